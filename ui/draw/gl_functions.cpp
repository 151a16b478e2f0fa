#include "ui/draw/gl_functions.h"

#include <dlfcn.h>

#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace asperity {

SharedLibrary::SharedLibrary(const char* file, const char* variable, const char* package)
    : name_(file) {
  if (const char* other = std::getenv(variable); other != nullptr && *other != '\0') name_ = other;
  // With RTLD_LOCAL the gl* names stay invisible to the window's libraries.
  handle_ = dlopen(name_.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle_ != nullptr) return;
  const char* reason = dlerror();
  throw std::runtime_error("Pictures need the library " + name_ + " (package " + package +
                           "): " + (reason != nullptr ? reason : "it cannot be opened") + ".");
}

void* SharedLibrary::address(const char* symbol) const {
  void* found = dlsym(handle_, symbol);
  if (found == nullptr)
    throw std::runtime_error("The library " + name_ + " is too old for pictures: it has no " +
                             symbol + ".");
  return found;
}

namespace {

void* find(const ProcAddress& procAddress, const char* name) {
  if (void* address = procAddress(name)) return address;
  throw std::runtime_error("OpenGL 3.3 is needed, but this one has no " + std::string(name) + ".");
}

}  // namespace

GlFunctions::GlFunctions(const ProcAddress& procAddress) {
#define ASPERITY_GL_FIND(Type, member, name) \
  member = reinterpret_cast<Type>(find(procAddress, name));
  ASPERITY_GL_FUNCTIONS(ASPERITY_GL_FIND)
#undef ASPERITY_GL_FIND
}

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

SavedState::SavedState(const GlFunctions& gl)
    : gl_(gl),
      program_(integer(GL_CURRENT_PROGRAM)),
      vertexArray_(integer(GL_VERTEX_ARRAY_BINDING)),
      arrayBuffer_(integer(GL_ARRAY_BUFFER_BINDING)),
      drawFramebuffer_(integer(GL_DRAW_FRAMEBUFFER_BINDING)),
      readFramebuffer_(integer(GL_READ_FRAMEBUFFER_BINDING)),
      blendEquationColour_(integer(GL_BLEND_EQUATION_RGB)),
      blendEquationAlpha_(integer(GL_BLEND_EQUATION_ALPHA)),
      sourceColour_(integer(GL_BLEND_SRC_RGB)),
      targetColour_(integer(GL_BLEND_DST_RGB)),
      sourceAlpha_(integer(GL_BLEND_SRC_ALPHA)),
      targetAlpha_(integer(GL_BLEND_DST_ALPHA)) {
  for (std::size_t i = 0; i < kCapabilities.size(); ++i)
    enabled_[i] = gl_.isEnabled(kCapabilities[i]) == GL_TRUE;
  gl_.getIntegerv(GL_VIEWPORT, viewport_.data());
  gl_.getIntegerv(GL_SCISSOR_BOX, scissor_.data());
  gl_.getFloatv(GL_COLOR_CLEAR_VALUE, clearColour_.data());
  gl_.getBooleanv(GL_COLOR_WRITEMASK, colourMask_.data());
}

SavedState::~SavedState() {
  for (std::size_t i = 0; i < kCapabilities.size(); ++i) setEnabled(kCapabilities[i], enabled_[i]);
  gl_.useProgram(static_cast<GLuint>(program_));
  gl_.bindVertexArray(static_cast<GLuint>(vertexArray_));
  gl_.bindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(arrayBuffer_));
  gl_.bindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(drawFramebuffer_));
  gl_.bindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(readFramebuffer_));
  gl_.blendEquationSeparate(static_cast<GLenum>(blendEquationColour_),
                            static_cast<GLenum>(blendEquationAlpha_));
  gl_.blendFuncSeparate(static_cast<GLenum>(sourceColour_), static_cast<GLenum>(targetColour_),
                        static_cast<GLenum>(sourceAlpha_), static_cast<GLenum>(targetAlpha_));
  gl_.viewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
  gl_.scissor(scissor_[0], scissor_[1], scissor_[2], scissor_[3]);
  gl_.clearColor(clearColour_[0], clearColour_[1], clearColour_[2], clearColour_[3]);
  gl_.colorMask(colourMask_[0], colourMask_[1], colourMask_[2], colourMask_[3]);
}

GLint SavedState::integer(GLenum name) const {
  GLint value = 0;
  gl_.getIntegerv(name, &value);
  return value;
}

void SavedState::setEnabled(GLenum capability, bool on) const {
  if (on)
    gl_.enable(capability);
  else
    gl_.disable(capability);
}

}  // namespace asperity
