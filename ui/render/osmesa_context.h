// An OpenGL 3.3 core context in memory, by libOSMesa opened at run time.
// Threading: one thread makes, draws and destroys; never one on which a Qt context is current.
// Failure: the constructor throws std::runtime_error in one sentence that names the missing library.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "ui/render/draw_list.h"

namespace asperity {

/// 8-bit RGBA, rows from the top, no padding.
struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

class OsmesaContext {
 public:
  OsmesaContext();
  ~OsmesaContext();
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  /// The list's shapes (no texts) as a picture of its size.
  Pixels draw(const DrawList& list);

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace asperity
