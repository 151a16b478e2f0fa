// The OpenGL 3.3 functions the renderer uses, found at run time. Private to ui/draw: the only
// header that sees OpenGL's types. Threading: a table belongs to one context and its thread.
// Failure: the constructor throws std::runtime_error naming the function that is missing.
#pragma once

#include <GL/glcorearb.h>

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

struct GlFunctions {
  explicit GlFunctions(const ProcAddress& procAddress);

#define ASPERITY_GL_MEMBER(Type, member, name) Type member = nullptr;
  ASPERITY_GL_FUNCTIONS(ASPERITY_GL_MEMBER)
#undef ASPERITY_GL_MEMBER
};

}  // namespace asperity
