// OpenGL 3.3 without linking a library: libraries and functions found at run time, shader programs,
// and the state of a foreign context, which drawing restores. A context must be current in every
// call. Failure: std::runtime_error naming the missing function, or with the compiler's message.
#pragma once

#include <GL/glcorearb.h>
#include <array>
#include <string>

#include "ui/draw/renderer.h"

// clang-format off
#define ASPERITY_GL_FUNCTIONS(X) \
  X(PFNGLATTACHSHADERPROC, attachShader, "glAttachShader")                                  \
  X(PFNGLBINDBUFFERPROC, bindBuffer, "glBindBuffer")                                        \
  X(PFNGLBINDFRAMEBUFFERPROC, bindFramebuffer, "glBindFramebuffer")                         \
  X(PFNGLBINDVERTEXARRAYPROC, bindVertexArray, "glBindVertexArray")                         \
  X(PFNGLBLENDEQUATIONSEPARATEPROC, blendEquationSeparate, "glBlendEquationSeparate")       \
  X(PFNGLBLENDFUNCSEPARATEPROC, blendFuncSeparate, "glBlendFuncSeparate")                   \
  X(PFNGLBUFFERDATAPROC, bufferData, "glBufferData")                                        \
  X(PFNGLBUFFERSUBDATAPROC, bufferSubData, "glBufferSubData")                               \
  X(PFNGLCLEARPROC, clear, "glClear")                                                       \
  X(PFNGLCLEARCOLORPROC, clearColor, "glClearColor")                                        \
  X(PFNGLCOLORMASKPROC, colorMask, "glColorMask")                                           \
  X(PFNGLCOMPILESHADERPROC, compileShader, "glCompileShader")                               \
  X(PFNGLCREATEPROGRAMPROC, createProgram, "glCreateProgram")                               \
  X(PFNGLCREATESHADERPROC, createShader, "glCreateShader")                                  \
  X(PFNGLDELETEBUFFERSPROC, deleteBuffers, "glDeleteBuffers")                               \
  X(PFNGLDELETEPROGRAMPROC, deleteProgram, "glDeleteProgram")                               \
  X(PFNGLDELETESHADERPROC, deleteShader, "glDeleteShader")                                  \
  X(PFNGLDELETEVERTEXARRAYSPROC, deleteVertexArrays, "glDeleteVertexArrays")                \
  X(PFNGLDISABLEPROC, disable, "glDisable")                                                 \
  X(PFNGLDRAWARRAYSPROC, drawArrays, "glDrawArrays")                                        \
  X(PFNGLDRAWARRAYSINSTANCEDPROC, drawArraysInstanced, "glDrawArraysInstanced")             \
  X(PFNGLENABLEPROC, enable, "glEnable")                                                    \
  X(PFNGLENABLEVERTEXATTRIBARRAYPROC, enableVertexAttribArray, "glEnableVertexAttribArray") \
  X(PFNGLFINISHPROC, finish, "glFinish")                                                    \
  X(PFNGLGENBUFFERSPROC, genBuffers, "glGenBuffers")                                        \
  X(PFNGLGENVERTEXARRAYSPROC, genVertexArrays, "glGenVertexArrays")                         \
  X(PFNGLGETBOOLEANVPROC, getBooleanv, "glGetBooleanv")                                     \
  X(PFNGLGETFLOATVPROC, getFloatv, "glGetFloatv")                                           \
  X(PFNGLGETINTEGERVPROC, getIntegerv, "glGetIntegerv")                                     \
  X(PFNGLGETPROGRAMINFOLOGPROC, getProgramInfoLog, "glGetProgramInfoLog")                   \
  X(PFNGLGETPROGRAMIVPROC, getProgramiv, "glGetProgramiv")                                  \
  X(PFNGLGETSHADERINFOLOGPROC, getShaderInfoLog, "glGetShaderInfoLog")                      \
  X(PFNGLGETSHADERIVPROC, getShaderiv, "glGetShaderiv")                                     \
  X(PFNGLGETUNIFORMLOCATIONPROC, getUniformLocation, "glGetUniformLocation")                \
  X(PFNGLISENABLEDPROC, isEnabled, "glIsEnabled")                                           \
  X(PFNGLLINKPROGRAMPROC, linkProgram, "glLinkProgram")                                     \
  X(PFNGLSCISSORPROC, scissor, "glScissor")                                                 \
  X(PFNGLSHADERSOURCEPROC, shaderSource, "glShaderSource")                                  \
  X(PFNGLUNIFORM2FPROC, uniform2f, "glUniform2f")                                           \
  X(PFNGLUSEPROGRAMPROC, useProgram, "glUseProgram")                                        \
  X(PFNGLVERTEXATTRIBDIVISORPROC, vertexAttribDivisor, "glVertexAttribDivisor")             \
  X(PFNGLVERTEXATTRIBPOINTERPROC, vertexAttribPointer, "glVertexAttribPointer")             \
  X(PFNGLVIEWPORTPROC, viewport, "glViewport")
// clang-format on

namespace asperity {

/// A library that is opened at run time, once in the process, and never closed, because its threads
/// outlive any context. Its names stay invisible to other libraries. Failure: std::runtime_error in
/// one sentence with the names of the library and its package.
class SharedLibrary {
 public:
  /// Loads the library. `variable`: an environment variable that names another file.
  SharedLibrary(const char* file, const char* variable, const char* package);

  template <typename Function>
  void find(Function& function, const char* symbol) const {
    function = reinterpret_cast<Function>(address(symbol));
  }
  const std::string& name() const { return name_; }

 private:
  void* address(const char* symbol) const;

  std::string name_;
  void* handle_ = nullptr;
};

struct GlFunctions {
  explicit GlFunctions(const ProcAddress& procAddress);

#define ASPERITY_GL_MEMBER(Type, member, name) Type member = nullptr;
  ASPERITY_GL_FUNCTIONS(ASPERITY_GL_MEMBER)
#undef ASPERITY_GL_MEMBER
};

class ShaderProgram {
 public:
  ShaderProgram(const GlFunctions& gl, const char* vertexSource, const char* fragmentSource);
  ~ShaderProgram();
  ShaderProgram(const ShaderProgram&) = delete;
  ShaderProgram& operator=(const ShaderProgram&) = delete;

  /// Makes the program current for a picture of this size in pixels.
  void use(int width, int height) const;

 private:
  const GlFunctions& gl_;
  GLuint program_ = 0;
  GLint pictureSize_ = -1;
};

class SavedState {
 public:
  explicit SavedState(const GlFunctions& gl);
  ~SavedState();
  SavedState(const SavedState&) = delete;
  SavedState& operator=(const SavedState&) = delete;

 private:
  GLint integer(GLenum name) const;
  void setEnabled(GLenum capability, bool on) const;

  static constexpr std::array<GLenum, 6> kCapabilities = {
      GL_BLEND, GL_SCISSOR_TEST, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_CULL_FACE, GL_FRAMEBUFFER_SRGB};

  const GlFunctions& gl_;
  std::array<bool, kCapabilities.size()> enabled_{};
  GLint program_, vertexArray_, arrayBuffer_, drawFramebuffer_, readFramebuffer_;
  GLint blendEquationColour_, blendEquationAlpha_;
  GLint sourceColour_, targetColour_, sourceAlpha_, targetAlpha_;
  std::array<GLint, 4> viewport_{}, scissor_{};
  std::array<GLfloat, 4> clearColour_{};
  std::array<GLboolean, 4> colourMask_{};
};

}  // namespace asperity
