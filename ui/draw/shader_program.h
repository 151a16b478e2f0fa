// A linked vertex and fragment shader. Private to ui/draw. Owns the program object; the context
// is current in every call. Failure: throws std::runtime_error with the compiler's or linker's
// message.
#pragma once

#include "ui/draw/gl_functions.h"

namespace asperity {

class ShaderProgram {
 public:
  ShaderProgram(const GlFunctions& gl, const char* vertexSource, const char* fragmentSource);
  ~ShaderProgram();
  ShaderProgram(const ShaderProgram&) = delete;
  ShaderProgram& operator=(const ShaderProgram&) = delete;

  /// Makes it current for a picture of this size in pixels.
  void use(int width, int height) const;

 private:
  const GlFunctions& gl_;
  GLuint program_ = 0;
  GLint pictureSize_ = -1;
};

}  // namespace asperity
