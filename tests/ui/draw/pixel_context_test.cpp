// The choice of what draws, and that all draw the same.
#include "ui/draw/pixel_context.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "tests/ui/draw/drawing.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) { setenv(name, value, 1); }
  ~Variable() { unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
};

std::string refusal(PixelBackend backend) {
  try {
    makePixelContext(backend);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

/// Everything a picture has: gradients, thin and thick lines, transparency, a clip.
DrawList richList(int width, int height) {
  DrawList list = blackList(width, height);
  list.background = {0.9F, 0.95F, 1, 1};
  const auto w = static_cast<float>(width), h = static_cast<float>(height);
  DrawLayer filled, clipped;
  filled.triangles = rectangle(0.1F * w, 0.1F * h, 0.7F * w, 0.6F * h, {0.2F, 0.4F, 0.6F, 0.5F});
  filled.triangles[2].colour = kRed;
  clipped.clip = {0.2F * w, 0.2F * h, 0.5F * w, 0.5F * h};
  DrawLine wave{{}, 3};
  for (int i = 0; i <= 100; ++i) {
    const auto t = static_cast<float>(i) / 100;
    wave.vertices.push_back({t * w, h * (0.5F + 0.3F * std::sin(20 * t)), {t, 0, 1 - t, 0.8F}});
  }
  clipped.lines = {wave, straight(0, 0, w, h, 0.7F, kBlack), straight(0, h, w, 0, 9, kRed)};
  list.layers = {filled, clipped};
  return list;
}

/// Within one level everywhere.
TEST(PixelContext, OsmesaAndEglDrawTheSame) {
  const auto osmesa = makePixelContext(PixelBackend::Osmesa),
             egl = makePixelContext(PixelBackend::Egl);
  EXPECT_EQ(osmesa->name(), "osmesa");
  EXPECT_EQ(egl->name(), "egl");
  for (const int size : {17, 640, 301}) {
    for (const float alpha : {1.0F, 0.0F}) {
      DrawList list = richList(size, size / 2 + 1);
      list.background.a = alpha;
      const Pixels a = osmesa->draw(list), b = egl->draw(list);
      ASSERT_EQ(a.rgba.size(), b.rgba.size());
      ASSERT_EQ(b.width, list.width);
      int largest = 0;
      for (std::size_t i = 0; i < a.rgba.size(); ++i)
        largest = std::max(largest, std::abs(a.rgba[i] - b.rgba[i]));
      EXPECT_LE(largest, 1) << size;
    }
  }
}

TEST(PixelContext, EglDrawsTheSameBytesAgainAndOnOtherThreads) {
  const DrawList list = richList(200, 100);
  std::vector<std::uint8_t> here, there;
  const auto draw = [&list](std::vector<std::uint8_t>& bytes) {
    const auto context = makeEglContext();
    context->draw(richList(50, 300));
    bytes = context->draw(list).rgba;
  };
  std::thread other([&] { draw(there); });
  draw(here);
  other.join();
  EXPECT_EQ(here, there);
}

TEST(PixelContext, AllRefuseEmptyAndImpossiblePictures) {
  for (const PixelBackend backend :
       {PixelBackend::Raster, PixelBackend::Osmesa, PixelBackend::Egl}) {
    const auto context = makePixelContext(backend);
    EXPECT_THROW(context->draw(blackList(0, 10)), std::runtime_error);
    EXPECT_THROW(context->draw(blackList(32768, 32768)), std::runtime_error);
    EXPECT_EQ(coverage(context->draw(blackList(4, 4))), 0);  // and goes on
  }
}

TEST(PixelContext, AMissingEglIsNamed) {
  const Variable gone("ASPERITY_EGL_LIBRARY", "libnowhere.so.1");
  EXPECT_THAT(refusal(PixelBackend::Egl),
              AllOf(HasSubstr("libnowhere.so.1"), HasSubstr("libegl1")));
}

TEST(PixelContext, ALibraryThatIsNoEglIsTooOld) {
  const Variable other("ASPERITY_EGL_LIBRARY", "libm.so.6");
  EXPECT_THAT(refusal(PixelBackend::Egl), HasSubstr("libm.so.6 is too old"));
}

TEST(PixelContext, TheProgramsOwnRasterizerNeedsNoLibrary) {
  const Variable noOsmesa("ASPERITY_OSMESA_LIBRARY", "libnowhere.so.8");
  const Variable noEgl("ASPERITY_EGL_LIBRARY", "libnowhere.so.1");
  EXPECT_EQ(makePixelContext()->name(), "raster");
  EXPECT_THAT(refusal(PixelBackend::Osmesa), HasSubstr("libosmesa6"));
  EXPECT_THAT(refusal(PixelBackend::Egl), HasSubstr("libegl1"));
}

/// OpenGL cuts corners to parts of a pixel: single pixels on edges differ.
TEST(PixelContext, TheRasterizerDrawsAsOpenGlDoes) {
  const auto osmesa = makePixelContext(PixelBackend::Osmesa), own = makePixelContext();
  for (const int size : {17, 640, 301})
    for (const float alpha : {1.0F, 0.0F}) {
      DrawList list = richList(size, size / 2 + 1);
      list.background.a = alpha;
      const Pixels a = osmesa->draw(list), b = own->draw(list);
      ASSERT_EQ(a.rgba.size(), b.rgba.size());
      std::size_t further = 0, far = 0;
      for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        const int apart = std::abs(a.rgba[i] - b.rgba[i]);
        further += apart > 1 ? 1 : 0;
        far += apart > 16 ? 1 : 0;
      }
      EXPECT_LE(further, a.rgba.size() / 1000) << size;
      EXPECT_LE(far, a.rgba.size() / 20000) << size;
    }
}

}  // namespace
}  // namespace asperity
