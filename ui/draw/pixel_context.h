// An OpenGL 3.3 core context without a screen, and what it draws. Two kinds: by OSMesa (software,
// part of Mesa up to 25.0) and by EGL without a surface (whatever driver there is). Both libraries
// are opened at run time, so a program starts without either.
// Threading: one thread makes, draws and destroys; never one on which a Qt context is current.
// Failure: std::runtime_error in one sentence that names the missing library and its package.
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

  /// The list's shapes (no texts) as a picture of its size, 1 to 16384 pixels each way; throws
  /// std::runtime_error otherwise.
  virtual Pixels draw(const DrawList& list) = 0;

  /// "osmesa" or "egl".
  virtual std::string name() const = 0;
};

enum class PixelBackend { Automatic, Osmesa, Egl };

/// Automatic: OSMesa, and EGL where that fails; where both fail the sentences of both.
std::unique_ptr<PixelContext> makePixelContext(PixelBackend backend = PixelBackend::Automatic);

/// The one context of the calling thread: made with the first call, destroyed with the thread.
PixelContext& contextOfThread();

/// Throws std::runtime_error unless a picture of this size can be drawn.
void checkPictureSize(const DrawList& list);

}  // namespace asperity
