#include "ui/draw/saved_state.h"

namespace asperity {

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
