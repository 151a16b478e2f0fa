#include "ui/draw/shader_program.h"

#include <array>
#include <stdexcept>
#include <string>

namespace asperity {
namespace {

using Log = std::array<char, 2048>;

GLuint compile(const GlFunctions& gl, GLenum kind, const char* source) {
  const GLuint shader = gl.createShader(kind);
  gl.shaderSource(shader, 1, &source, nullptr);
  gl.compileShader(shader);
  GLint compiled = GL_FALSE;
  gl.getShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  Log log{};
  gl.getShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  gl.deleteShader(shader);
  throw std::runtime_error("OpenGL does not compile a shader: " + std::string(log.data()));
}

}  // namespace

ShaderProgram::ShaderProgram(const GlFunctions& gl, const char* vertexSource,
                             const char* fragmentSource)
    : gl_(gl) {
  const GLuint vertex = compile(gl, GL_VERTEX_SHADER, vertexSource);
  GLuint fragment = 0;
  try {
    fragment = compile(gl, GL_FRAGMENT_SHADER, fragmentSource);
  } catch (...) {
    gl.deleteShader(vertex);
    throw;
  }
  program_ = gl.createProgram();
  gl.attachShader(program_, vertex);
  gl.attachShader(program_, fragment);
  gl.linkProgram(program_);
  gl.deleteShader(vertex);
  gl.deleteShader(fragment);
  GLint linked = GL_FALSE;
  gl.getProgramiv(program_, GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) {
    Log log{};
    gl.getProgramInfoLog(program_, static_cast<GLsizei>(log.size()), nullptr, log.data());
    gl.deleteProgram(program_);
    throw std::runtime_error("OpenGL does not link a shader program: " + std::string(log.data()));
  }
  pictureSize_ = gl.getUniformLocation(program_, "pictureSize");
}

ShaderProgram::~ShaderProgram() {
  gl_.deleteProgram(program_);
}

void ShaderProgram::use(int width, int height) const {
  gl_.useProgram(program_);
  gl_.uniform2f(pictureSize_, static_cast<GLfloat>(width), static_cast<GLfloat>(height));
}

}  // namespace asperity
