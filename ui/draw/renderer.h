// Draws a DrawList's shapes with OpenGL 3.3 core. It links no GL library: the constructor gets a
// function that finds GL functions, so the same object code serves a window, OSMesa and EGL.
// Threading: one thread, with the context current in every call and in the destructor.
// Failure: the constructor throws std::runtime_error with the compiler's or linker's message.
#pragma once

#include <functional>
#include <memory>

#include "ui/draw/draw_list.h"

namespace asperity {

using ProcAddress = std::function<void*(const char* name)>;

class Renderer {
 public:
  explicit Renderer(const ProcAddress& procAddress);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Draws into the given framebuffer object (a QOpenGLWidget's is not 0), which has at least
  /// list.width x list.height pixels. It leaves no GL state that disturbs QPainter.
  void draw(const DrawList& list, unsigned framebuffer);

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace asperity
