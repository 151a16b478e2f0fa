// An OpenGL 3.3 core context in memory, with libOSMesa opened at run time.
// Threading and failure: as PixelContext. The environment variable ASPERITY_OSMESA_LIBRARY names
// another library than libOSMesa.so.8.
#pragma once

#include "ui/draw/pixel_context.h"

namespace asperity {

class OsmesaContext : public PixelContext {
 public:
  OsmesaContext();
  ~OsmesaContext() override;
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  Pixels draw(const DrawList& list) override;
  std::string name() const override { return "osmesa"; }

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace asperity
