// An OpenGL 3.3 core context in memory, by libOSMesa opened at run time.
// Threading: one thread makes, draws and destroys; never one on which a Qt context is current.
// Failure: the constructor throws std::runtime_error in one sentence that names the missing
// library. The environment variable ASPERITY_OSMESA_LIBRARY names another library than
// libOSMesa.so.8.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "ui/render/draw_list.h"

namespace asperity {

/// 8-bit RGBA, rows from the top, no padding. Alpha is premultiplied, which makes no difference
/// where the list's background is opaque.
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

  /// The list's shapes (no texts) as a picture of its size, 1 to 16384 pixels each way; throws
  /// std::runtime_error otherwise.
  Pixels draw(const DrawList& list);

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace asperity
