#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/run/line_diagrams.h"
#include "core/surface/line_source.h"
#include "tests/ui/contact/tidy_texts.h"
#include "ui/chart/diagram_picture.h"

namespace asperity {
namespace {

Scene sceneOf(SurfaceKind kind, std::int64_t elements) {
  Scene scene;
  scene.title = "A line";
  scene.surface.kind = kind;
  scene.surface.elements = elements;
  scene.surface.waves = 1;
  return scene;
}

DrawList pictureOf(const Scene& scene, int width = 1280, int height = 800, float scale = 1) {
  const LineSource source(scene, pointsPerElement(scene));
  return composeDiagrams(surfaceSheet(scene, source.make(0)), {width, height, scale, lightTheme()});
}

struct Case {
  std::string name;
  Scene scene;
};

std::vector<Case> cases() {
  std::vector<Case> all{{"self_affine", sceneOf(SurfaceKind::SelfAffine, 2000)},
                        {"self_affine, 3", sceneOf(SurfaceKind::SelfAffine, 3)},
                        {"self_affine, 5", sceneOf(SurfaceKind::SelfAffine, 5)},
                        {"sine, 3", sceneOf(SurfaceKind::Sine, 3)},
                        {"sine", sceneOf(SurfaceKind::Sine, 100)},
                        {"wedge", sceneOf(SurfaceKind::Wedge, 100)},
                        {"parabola", sceneOf(SurfaceKind::Parabola, 100)},
                        {"flat", sceneOf(SurfaceKind::SelfAffine, 100)}};
  all.back().scene.surface.rmsHeight = 0;
  all[0].scene.title = "A title that is by far too long for most of the pictures that there are";
  all[3].scene.title = "";
  all[4].scene.surface.amplitude = 1.2345e-11;
  return all;
}

TEST(SurfacePicture, TextsNeverCollideNorLeaveThePicture) {
  struct {
    int width, height;
    float scale;
  } const sizes[] = {{320, 240, 1},  {400, 300, 1},  {480, 854, 1},   {800, 600, 1},
                     {1280, 800, 1}, {1280, 800, 2}, {3000, 1200, 1}, {600, 2000, 1},
                     {4000, 600, 1}, {2560, 1600, 2}};
  for (const Case& each : cases())
    for (const auto& size : sizes)
      expectTidy(pictureOf(each.scene, size.width, size.height, size.scale),
                 each.name + " " + std::to_string(size.width) + "x" + std::to_string(size.height));
}

TEST(SurfacePicture, StatisticsHaveFourDigits) {
  Scene scene = sceneOf(SurfaceKind::Sine, 100);
  scene.surface.amplitude = 5e-7;
  const std::string texts = allTexts(pictureOf(scene));
  for (const char* said : {"rms height h = 353.6 nm", "rms slope = 0.0001111",
                           "one period L = 20 mm", "position (mm)", "height (nm)"})
    EXPECT_NE(texts.find(said), texts.npos) << said << " in " << texts;
  EXPECT_EQ(texts.find("wave number q (1/m)"), texts.npos) << "given by a formula";
  const std::string rough = allTexts(pictureOf(sceneOf(SurfaceKind::SelfAffine, 100)));
  EXPECT_NE(rough.find("wave number q (1/m)"), rough.npos);
}

/// The same points as in the window's tab.
TEST(SurfacePicture, HasTheSpectrumOfTheWindow) {
  const Scene scene = sceneOf(SurfaceKind::SelfAffine, 1000);
  const LineSource source(scene, pointsPerElement(scene));
  const DiagramSheet sheet = surfaceSheet(scene, source.make(0)), tab = spectrumSheet(scene);
  ASSERT_EQ(sheet.diagrams.size(), 2U);
  ASSERT_EQ(sheet.diagrams[1].series.size(), tab.diagrams[0].series.size());
  for (std::size_t i = 0; i < tab.diagrams[0].series.size(); ++i) {
    const auto &own = sheet.diagrams[1].series[i].points, &other = tab.diagrams[0].series[i].points;
    ASSERT_EQ(own.size(), other.size());
    for (std::size_t k = 0; k < own.size(); ++k)
      EXPECT_TRUE(own[k].x == other[k].x && own[k].y == other[k].y) << k;
  }
}

/// The longest polyline is the rigid line's edge.
const DrawLine& edgeOf(const DrawList& list) {
  const DrawLine* longest = nullptr;
  for (const DrawLayer& layer : list.layers)
    for (const DrawLine& line : layer.lines)
      if (!longest || line.vertices.size() > longest->vertices.size()) longest = &line;
  return *longest;
}

TEST(SurfacePicture, SparseLinesAreRound) {
  for (const SurfaceKind kind : {SurfaceKind::Sine, SurfaceKind::SelfAffine}) {
    const DrawList list = pictureOf(sceneOf(kind, 8));
    const DrawLine& edge = edgeOf(list);
    EXPECT_GT(edge.vertices.size(), 1000U);
    double sharpest = 0;
    for (std::size_t i = 2; i < edge.vertices.size(); ++i) {
      const auto angle = [&](std::size_t k) {
        return std::atan2(edge.vertices[k].y - edge.vertices[k - 1].y,
                          edge.vertices[k].x - edge.vertices[k - 1].x);
      };
      sharpest = std::max<double>(sharpest, std::abs(angle(i) - angle(i - 1)));
    }
    EXPECT_LT(sharpest, 0.1);
  }
}

TEST(SurfacePicture, CostDoesNotGrowWithTheNodes) {
  EXPECT_LT(edgeOf(pictureOf(sceneOf(SurfaceKind::SelfAffine, 200000))).vertices.size(), 2700U);
}

TEST(SurfacePicture, AnySizeComposes) {
  for (const int size : {1, 2, 17, 60, 150})
    for (const Case& each : cases()) EXPECT_EQ(pictureOf(each.scene, size, size).width, size);
  EXPECT_FALSE(composeDiagrams(surfaceSheet(Scene{}, Line{}), {}).texts.empty());
}

}  // namespace
}  // namespace asperity
