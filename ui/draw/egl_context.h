// An OpenGL 3.3 core context without a surface, with libEGL opened at run time; it draws into its
// own framebuffer.
// Threading and failure: as PixelContext. The environment variable ASPERITY_EGL_LIBRARY names
// another library than libEGL.so.1.
#pragma once

#include "ui/draw/pixel_context.h"

namespace asperity {

class EglContext : public PixelContext {
 public:
  EglContext();
  ~EglContext() override;
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  Pixels draw(const DrawList& list) override;
  std::string name() const override { return "egl"; }

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace asperity
