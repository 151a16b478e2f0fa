#include "ui/draw/renderer.h"

#include "shader_sources.h"
#include "ui/draw/gl_functions.h"
#include "ui/draw/shapes.h"

namespace asperity {
namespace {

const void* bytes(std::size_t floats) {
  return reinterpret_cast<const void*>(floats * sizeof(float));
}

}  // namespace

struct Renderer::Body {
  explicit Body(const ProcAddress& procAddress)
      : gl(procAddress),
        triangles(gl, kTriangleVertexShader, kTriangleFragmentShader),
        lines(gl, kLineVertexShader, kLineFragmentShader) {
    gl.genBuffers(1, &buffer);
    gl.genVertexArrays(1, &triangleArray);
    gl.genVertexArrays(1, &lineArray);
  }

  ~Body() {
    gl.deleteVertexArrays(1, &triangleArray);
    gl.deleteVertexArrays(1, &lineArray);
    gl.deleteBuffers(1, &buffer);
  }

  void prepare(const DrawList& list, unsigned framebuffer);
  void upload();
  void attribute(GLuint index, GLint floats, int stride, std::size_t offset, GLuint divisor);
  void drawTriangles(const DrawBatch& batch, const DrawList& list);
  void drawSegments(const DrawBatch& batch, const DrawList& list);

  GlFunctions gl;
  ShaderProgram triangles, lines;
  GLuint buffer = 0, triangleArray = 0, lineArray = 0;
  std::size_t capacity = 0;  // number of floats in the buffer
  Geometry geometry;
};

/// Sets the state, and draws the background over the list's rectangle.
void Renderer::Body::prepare(const DrawList& list, unsigned framebuffer) {
  gl.bindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.viewport(0, 0, list.width, list.height);
  for (const GLenum off : {GL_DEPTH_TEST, GL_STENCIL_TEST, GL_CULL_FACE, GL_FRAMEBUFFER_SRGB})
    gl.disable(off);
  gl.enable(GL_BLEND);
  gl.blendEquationSeparate(GL_FUNC_ADD, GL_FUNC_ADD);
  gl.blendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl.colorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.enable(GL_SCISSOR_TEST);
  gl.scissor(0, 0, list.width, list.height);
  const Rgba& c = list.background;
  gl.clearColor(c.r * c.a, c.g * c.a, c.b * c.a, c.a);
  gl.clear(GL_COLOR_BUFFER_BIT);
}

/// Uploads the data once per picture. The old buffer is orphaned, so that the upload need not wait
/// for the last picture.
void Renderer::Body::upload() {
  gl.bindBuffer(GL_ARRAY_BUFFER, buffer);
  if (geometry.data.size() > capacity) capacity = geometry.data.size() * 3 / 2;
  if (capacity == 0) return;
  gl.bufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(capacity * sizeof(float)), nullptr,
                GL_STREAM_DRAW);
  gl.bufferSubData(GL_ARRAY_BUFFER, 0,
                   static_cast<GLsizeiptr>(geometry.data.size() * sizeof(float)),
                   geometry.data.data());
}

void Renderer::Body::attribute(GLuint index, GLint floats, int stride, std::size_t offset,
                               GLuint divisor) {
  gl.enableVertexAttribArray(index);
  gl.vertexAttribPointer(index, floats, GL_FLOAT, GL_FALSE,
                         stride * static_cast<GLsizei>(sizeof(float)), bytes(offset));
  gl.vertexAttribDivisor(index, divisor);
}

void Renderer::Body::drawTriangles(const DrawBatch& batch, const DrawList& list) {
  if (batch.triangleCorners == 0) return;
  triangles.use(list.width, list.height);
  gl.bindVertexArray(triangleArray);
  attribute(0, 2, kTriangleFloats, batch.triangleOffset, 0);
  attribute(1, 4, kTriangleFloats, batch.triangleOffset + 2, 0);
  gl.drawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(batch.triangleCorners));
}

void Renderer::Body::drawSegments(const DrawBatch& batch, const DrawList& list) {
  if (batch.segments == 0) return;
  lines.use(list.width, list.height);
  gl.bindVertexArray(lineArray);
  const std::size_t start = batch.segmentOffset;
  for (GLuint i = 0; i < 4; ++i) attribute(i, 4, kSegmentFloats, start + 4 * i, 1);
  attribute(4, 1, kSegmentFloats, start + 16, 1);
  gl.drawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(batch.segments));
}

Renderer::Renderer(const ProcAddress& procAddress) : body_(std::make_unique<Body>(procAddress)) {}

Renderer::~Renderer() = default;

void Renderer::draw(const DrawList& list, unsigned framebuffer) {
  if (list.width <= 0 || list.height <= 0) return;
  Body& body = *body_;
  const SavedState saved(body.gl);
  body.prepare(list, framebuffer);
  flatten(list, body.geometry);
  body.upload();
  for (const DrawBatch& batch : body.geometry.batches) {
    const ScissorBox& box = batch.scissor;
    if (box.width <= 0 || box.height <= 0) continue;
    body.gl.scissor(box.x, box.y, box.width, box.height);
    body.drawTriangles(batch, list);
    body.drawSegments(batch, list);
  }
}

}  // namespace asperity
