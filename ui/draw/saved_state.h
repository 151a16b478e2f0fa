// Remembers the OpenGL state the renderer changes and puts it back. Private to ui/draw.
// Threading: the context's thread, with the context current from construction to destruction.
#pragma once

#include <array>

#include "ui/draw/gl_functions.h"

namespace asperity {

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
