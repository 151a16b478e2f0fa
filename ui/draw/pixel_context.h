// Draws the shapes of a DrawList without a screen, into pixels. There are three kinds: the
// program's own rasterizer, which is always there, and two OpenGL 3.3 core contexts, OSMesa
// (software, part of Mesa up to 25.0) and EGL without a surface (any driver), whose libraries are
// opened at run time. Threading: one thread makes, draws and destroys; with OpenGL never a thread
// on which a Qt context is current. Failure: std::runtime_error in one sentence that names the
// missing library and its package.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "ui/draw/draw_list.h"

namespace asperity {

/// 8-bit RGBA, rows from the top, no padding. Alpha is premultiplied, which makes no difference
/// where the list's background is opaque.
struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

class PixelContext {
 public:
  virtual ~PixelContext() = default;

  /// Draws the list's shapes (no texts) as a picture of its size, 1 to 16384 pixels in each
  /// direction; throws std::runtime_error for other sizes.
  virtual Pixels draw(const DrawList& list) = 0;

  /// Returns "raster", "osmesa" or "egl".
  virtual std::string name() const = 0;
};

/// Makes one kind of context, each from the file of its name. The environment variables
/// ASPERITY_OSMESA_LIBRARY and ASPERITY_EGL_LIBRARY name other libraries than libOSMesa.so.8 and
/// libEGL.so.1. The rasterizer has no state of the thread, so any thread may use it.
std::unique_ptr<PixelContext> makeRasterContext();
std::unique_ptr<PixelContext> makeOsmesaContext();
std::unique_ptr<PixelContext> makeEglContext();

enum class PixelBackend { Automatic, Osmesa, Egl, Raster };

/// Makes a context. Automatic: the program's own rasterizer.
std::unique_ptr<PixelContext> makePixelContext(PixelBackend backend = PixelBackend::Automatic);

/// Returns the context of the calling thread, made at the first call and destroyed with the thread.
PixelContext& contextOfThread();

/// Throws std::runtime_error unless a picture of this size can be drawn.
void checkPictureSize(const DrawList& list);

}  // namespace asperity
