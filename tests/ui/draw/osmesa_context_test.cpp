#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "tests/ui/draw/drawing.h"

namespace asperity {
namespace {

using testing::HasSubstr;

std::string messageWithLibrary(const char* name) {
  setenv("ASPERITY_OSMESA_LIBRARY", name, 1);
  std::string message;
  try {
    makeOsmesaContext();
  } catch (const std::runtime_error& error) {
    message = error.what();
  }
  unsetenv("ASPERITY_OSMESA_LIBRARY");
  return message;
}

TEST(OsmesaContext, NamesTheMissingLibrary) {
  const std::string message = messageWithLibrary("libnowhere.so.8");
  EXPECT_THAT(message, HasSubstr("libnowhere.so.8"));
  EXPECT_THAT(message, HasSubstr("libosmesa6"));
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST(OsmesaContext, SaysThatALibraryIsTooOld) {
  const std::string message = messageWithLibrary("libm.so.6");
  EXPECT_THAT(message, HasSubstr("libm.so.6 is too old"));
  EXPECT_THAT(message, HasSubstr("OSMesaCreateContextAttribs"));
}

TEST(OsmesaContext, RefusesEmptyAndImpossiblePictures) {
  const auto context = makeOsmesaContext();
  EXPECT_THROW(context->draw(blackList(0, 10)), std::runtime_error);
  EXPECT_THROW(context->draw(blackList(10, -1)), std::runtime_error);
  EXPECT_THROW(context->draw(blackList(1000000, 1)), std::runtime_error);
  EXPECT_EQ(coverage(context->draw(blackList(4, 4))), 0);  // and goes on
}

TEST(OsmesaContext, DrawsPicturesOfAnySizeInTurn) {
  const auto context = makeOsmesaContext();
  for (const int size : {1, 7, 640, 3}) {
    DrawList list = blackList(size, size + 1);
    list.background = {1, 0.5F, 0, 1};
    const Pixels pixels = context->draw(list);
    ASSERT_EQ(pixels.rgba.size(), static_cast<std::size_t>(size) * (size + 1) * 4);
    EXPECT_EQ(pixel(pixels, size - 1, size), (std::array<int, 4>{255, 128, 0, 255}));
  }
}

TEST(OsmesaContext, ContextsOnSeveralThreadsDrawTheSameBytes) {
  DrawList list = blackList(200, 100);
  DrawLayer layer;
  layer.lines.push_back({{{10, 10, kRed}, {150, 90, kWhite}, {190, 5, kRed}}, 7});
  list.layers.push_back(layer);
  std::vector<std::uint8_t> first, second;
  const auto draw = [&list](std::vector<std::uint8_t>& bytes) {
    const auto context = makeOsmesaContext();
    bytes = context->draw(list).rgba;
  };
  std::thread other([&] { draw(first); });
  draw(second);
  other.join();
  EXPECT_GT(first.size(), 0U);
  EXPECT_EQ(first, second);
}

}  // namespace
}  // namespace asperity
