// The renderer in somebody else's context: other framebuffers, state left as it was.
#include "ui/draw/renderer.h"

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <vector>

#include "tests/ui/draw/drawing.h"
#include "ui/draw/gl_functions.h"

namespace asperity {
namespace {

// Of GL/osmesa.h, whose OpenGL header does not go together with the renderer's.
constexpr int kFormat = 0x22, kProfile = 0x33, kCoreProfile = 0x34, kMajor = 0x36, kMinor = 0x37;
using CreateContext = void* (*)(const int*, void*);
using MakeCurrent = unsigned char (*)(void*, void*, GLenum, int, int);
using DestroyContext = void (*)(void*);
using GetProcAddress = void (*(*)(const char*))();

/// A bare context that the test itself owns.
class ForeignContext {
 public:
  ForeignContext() : library_(dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL)) {
    if (library_ == nullptr) throw std::runtime_error("libOSMesa.so.8 is not installed");
    const int attributes[] = {kFormat, GL_RGBA, kProfile, kCoreProfile, kMajor, 3, kMinor, 3, 0};
    context_ = find<CreateContext>("OSMesaCreateContextAttribs")(attributes, nullptr);
    makeCurrent(context_, pixels_.data(), 16);
  }
  ~ForeignContext() {
    makeCurrent(nullptr, nullptr, 0);
    find<DestroyContext>("OSMesaDestroyContext")(context_);
  }

  ProcAddress procAddress() {
    return [this](const char* name) {
      return reinterpret_cast<void*>(find<GetProcAddress>("OSMesaGetProcAddress")(name));
    };
  }
  template <typename Function>
  Function find(const char* name) {
    return reinterpret_cast<Function>(dlsym(library_, name));
  }
  template <typename Function>
  Function gl(const char* name) {
    return reinterpret_cast<Function>(procAddress()(name));
  }

 private:
  void makeCurrent(void* context, void* buffer, int size) {
    find<MakeCurrent>("OSMesaMakeCurrent")(context, buffer, GL_UNSIGNED_BYTE, size, size);
  }

  void* library_;
  void* context_ = nullptr;
  std::vector<std::uint8_t> pixels_ = std::vector<std::uint8_t>(16 * 16 * 4);
};

DrawList redList() {
  DrawList list = blackList(8, 4);
  DrawLayer layer;
  layer.clip = {0, 0, 8, 2};
  layer.triangles = rectangle(0, 0, 8, 4, kRed);
  layer.lines.push_back(straight(0, 1, 8, 1, 1, kRed));
  list.layers.push_back(layer);
  return list;
}

TEST(Renderer, NamesAMissingFunction) {
  try {
    Renderer renderer([](const char*) -> void* { return nullptr; });
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("OpenGL 3.3"));
    EXPECT_THAT(error.what(), testing::HasSubstr("gl"));
  }
}

TEST(Renderer, DrawsIntoTheFramebufferItIsGiven) {
  ForeignContext context;
  GLuint framebuffer = 0, storage = 0;
  context.gl<PFNGLGENFRAMEBUFFERSPROC>("glGenFramebuffers")(1, &framebuffer);
  context.gl<PFNGLGENRENDERBUFFERSPROC>("glGenRenderbuffers")(1, &storage);
  context.gl<PFNGLBINDRENDERBUFFERPROC>("glBindRenderbuffer")(GL_RENDERBUFFER, storage);
  context.gl<PFNGLRENDERBUFFERSTORAGEPROC>("glRenderbufferStorage")(GL_RENDERBUFFER, GL_RGBA8, 16,
                                                                    16);
  const auto bind = context.gl<PFNGLBINDFRAMEBUFFERPROC>("glBindFramebuffer");
  bind(GL_FRAMEBUFFER, framebuffer);
  context.gl<PFNGLFRAMEBUFFERRENDERBUFFERPROC>("glFramebufferRenderbuffer")(
      GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, storage);
  bind(GL_FRAMEBUFFER, 0);
  Renderer renderer(context.procAddress());
  renderer.draw(redList(), framebuffer);
  bind(GL_FRAMEBUFFER, framebuffer);
  std::vector<std::uint8_t> pixels(8 * 4 * 4);
  context.gl<PFNGLREADPIXELSPROC>("glReadPixels")(0, 0, 8, 4, GL_RGBA, GL_UNSIGNED_BYTE,
                                                  pixels.data());
  EXPECT_EQ(pixels[0], 0);            // the lowest row is outside the clip
  EXPECT_EQ(pixels[3 * 8 * 4], 255);  // the highest is red
  EXPECT_EQ(pixels[3 * 8 * 4 + 1], 0);
  EXPECT_EQ(context.gl<PFNGLGETERRORPROC>("glGetError")(), GLenum{GL_NO_ERROR});
}

TEST(Renderer, LeavesTheStateAsItWas) {
  ForeignContext context;
  const GlFunctions gl(context.procAddress());
  Renderer renderer(context.procAddress());
  gl.viewport(1, 2, 3, 4);
  gl.enable(GL_DEPTH_TEST);
  gl.disable(GL_SCISSOR_TEST);
  gl.disable(GL_BLEND);
  gl.blendFuncSeparate(GL_ONE, GL_ZERO, GL_DST_ALPHA, GL_ONE);
  gl.clearColor(0.25F, 0.5F, 0.75F, 1);
  for (int repeat = 0; repeat < 2; ++repeat) renderer.draw(redList(), 0);
  GLint box[4] = {}, value = -1;
  gl.getIntegerv(GL_VIEWPORT, box);
  EXPECT_THAT(box, testing::ElementsAre(1, 2, 3, 4));
  EXPECT_EQ(gl.isEnabled(GL_DEPTH_TEST), GL_TRUE);
  EXPECT_EQ(gl.isEnabled(GL_SCISSOR_TEST), GL_FALSE);
  EXPECT_EQ(gl.isEnabled(GL_BLEND), GL_FALSE);
  gl.getIntegerv(GL_BLEND_SRC_ALPHA, &value);
  EXPECT_EQ(value, GL_DST_ALPHA);
  for (const GLenum name : {GL_CURRENT_PROGRAM, GL_VERTEX_ARRAY_BINDING, GL_ARRAY_BUFFER_BINDING}) {
    gl.getIntegerv(name, &value);
    EXPECT_EQ(value, 0) << name;
  }
  GLfloat colour[4] = {};
  gl.getFloatv(GL_COLOR_CLEAR_VALUE, colour);
  EXPECT_FLOAT_EQ(colour[2], 0.75F);
  EXPECT_EQ(context.gl<PFNGLGETERRORPROC>("glGetError")(), GLenum{GL_NO_ERROR});
}

}  // namespace
}  // namespace asperity
