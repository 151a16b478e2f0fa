// Draws a DrawList's shapes with the processor alone: no OpenGL, no library, no screen. Contact
// pictures are mostly columns of one colour, for which this takes a fifth of the time that OpenGL
// in software needs, and the bytes depend on neither the machine's driver nor on its threads.
// Its pixels follow OpenGL's rules and the renderer's shaders (pixel centres, shared edges belong
// to one triangle, coverage of lines by distance), so that both draw the same picture within a
// level of 255 except on single pixels of edges.
// Threading: one thread at a time; it has no state of the thread, so any thread may use it.
#pragma once

#include "ui/draw/pixel_context.h"
#include "ui/draw/shapes.h"

namespace asperity {

class RasterContext : public PixelContext {
 public:
  Pixels draw(const DrawList& list) override;
  std::string name() const override { return "raster"; }

 private:
  Geometry geometry_;
};

}  // namespace asperity
