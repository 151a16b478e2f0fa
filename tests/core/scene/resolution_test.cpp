// How many points resolve a line where the scene leaves it open.
#include <gmock/gmock.h>

#include "core/base/input_error.h"
#include "core/scene/parameters.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_file.h"

namespace asperity {
namespace {

using testing::HasSubstr;

TEST(Resolution, IsLeftOpenByDefaultAndStatedNumbersStand) {
  EXPECT_EQ(Scene{}.accuracy.oversampling, 0);
  EXPECT_THAT(writeScene({}), HasSubstr("\"oversampling\": 0"));
  const Scene stated = readScene(R"({"accuracy":{"oversampling":2}})", "s.json");
  EXPECT_EQ(pointsPerElement(stated), 2);
  EXPECT_EQ(curvePointsPerElement(stated), 2);
  const Scene open = readScene("{}", "s.json", {}, {"accuracy.oversampling=0"});
  EXPECT_EQ(open, Scene{});
  EXPECT_EQ(readScene(R"({"accuracy":{"scheme":"nodal","oversampling":0}})", "s.json"),
            readScene(R"({"accuracy":{"scheme":"nodal"}})", "s.json"));
  for (const char* bad : {"-1", "65", "0.5"})
    EXPECT_THROW(readScene("{}", "s.json", {}, {std::string("accuracy.oversampling=") + bad}),
                 InputError);
}

TEST(Resolution, OneLineHasFourPointsAnElement) {
  for (const SurfaceKind kind : {SurfaceKind::Sine, SurfaceKind::Wedge, SurfaceKind::Parabola,
                                 SurfaceKind::Profile, SurfaceKind::SelfAffine}) {
    Scene scene;
    scene.surface.kind = kind;
    scene.ensemble.realizations = kind == SurfaceKind::SelfAffine ? 1 : 200;
    EXPECT_EQ(pointsPerElement(scene), 4);
    EXPECT_EQ(curvePointsPerElement(scene), 4);
  }
  // A picture or a motion shows one line of many.
  Scene scene;
  EXPECT_EQ(pointsPerElement(scene), 4);
  scene.sliding.kind = SlidingKind::Start;
  EXPECT_EQ(pointsPerElement(scene), 4);
}

/// Points of a march cost little on a short line that slides little. More of either, or of what an
/// element remembers, never gives more points; what the scene states is kept.
TEST(Resolution, ASmallMotionHasMorePoints) {
  Scene scene;
  scene.sliding.kind = SlidingKind::Start;
  scene.surface.elements = 200;
  scene.sliding.velocity = 1e-3;
  scene.sliding.duration = 0.1;
  EXPECT_EQ(pointsPerElement(scene), 32);
  std::int64_t last = 32;
  for (const std::int64_t elements : {400, 1000, 3000, 10000, 1000000}) {
    scene.surface.elements = elements;
    EXPECT_LE(pointsPerElement(scene), last);
    last = pointsPerElement(scene);
  }
  EXPECT_EQ(last, 4);
  scene.surface.elements = 200;
  for (const SlidingKind kind :
       {SlidingKind::Start, SlidingKind::Step, SlidingKind::Oscillation, SlidingKind::Reversal}) {
    scene.sliding.kind = kind;
    last = 32;
    for (const double duration : {0.1, 1.0, 10.0, 1e3, 1e4}) {
      scene.sliding.duration = duration;
      EXPECT_LE(pointsPerElement(scene), last);
      last = pointsPerElement(scene);
    }
    EXPECT_EQ(last, 4);
  }
  scene.sliding.duration = 0.1;
  scene.sliding.kind = SlidingKind::Start;
  scene.elastomer.rheology = Rheology::Prony;
  scene.elastomer.arms.assign(30, {1e6, 1e-3});
  EXPECT_LT(pointsPerElement(scene), 32);
  scene.accuracy.oversampling = 2;
  EXPECT_EQ(pointsPerElement(scene), 2);
  scene.accuracy.oversampling = 0;
}

/// The target is that of a curve: asking for it never makes a motion coarser.
TEST(Resolution, ATargetGivesAMotionNoFewerPoints) {
  Scene scene;
  scene.sliding.kind = SlidingKind::Start;
  scene.sliding.velocity = 1e-3;
  scene.sliding.duration = 0.1;
  for (const std::int64_t elements : {200, 1000, 1000000}) {
    scene.surface.elements = elements;
    scene.accuracy.targetRelativeError = 0;
    const std::int64_t points = pointsPerElement(scene);
    scene.accuracy.targetRelativeError = 0.05;
    EXPECT_EQ(pointsPerElement(scene), points);
    scene.accuracy.targetRelativeError = 5e-3;
    EXPECT_EQ(pointsPerElement(scene), std::max<std::int64_t>(points, 8));
  }
}

/// The size of a line that comes from a file counts as one that the scene states.
TEST(Resolution, AMotionOverALineFromAFileFollowsTheSizeOfTheLine) {
  Scene scene;
  scene.sliding.kind = SlidingKind::Start;
  scene.sliding.duration = 0.1;
  for (const std::int64_t elements : {200, 1000, 3000, 1000000}) {
    scene.surface.elements = elements;
    const std::int64_t stated = pointsPerElement(scene);
    Scene open = scene;
    open.surface.kind = SurfaceKind::Measured;
    open.surface.elements = 0;
    EXPECT_TRUE(needsSizeOfFile(open));
    EXPECT_EQ(pointsPerElement(open), 4);
    EXPECT_EQ(pointsPerElement(open, {scene.surface.length, elements}), stated);
    EXPECT_TRUE(provenance("motion", open)["oversampling_used"].is_null());
    open.accuracy.oversampling = 6;
    EXPECT_FALSE(needsSizeOfFile(open));
    EXPECT_EQ(provenance("motion", open)["oversampling_used"], 6);
    open.accuracy.oversampling = 0;
    open.sliding.kind = SlidingKind::Steady;
    EXPECT_FALSE(needsSizeOfFile(open));
  }
}

TEST(Resolution, OtherSchemesHaveTheirOwn) {
  Scene scene;
  scene.accuracy.scheme = Scheme::Nodal;
  EXPECT_EQ(pointsPerElement(scene), 1);
  EXPECT_EQ(curvePointsPerElement(scene), 1);
  scene.accuracy.scheme = Scheme::Linear;
  EXPECT_EQ(pointsPerElement(scene), 8);
  EXPECT_EQ(curvePointsPerElement(scene), 8);
}

/// The standard error falls with the number of lines, with a roll-off and with the load.
TEST(Resolution, FollowsTheStandardErrorOfACurve) {
  const auto points = [](double hurst, std::int64_t lines, double force, double rollOff = 0) {
    Scene scene;
    scene.surface.hurst = hurst;
    scene.surface.rollOffWavelength = rollOff;
    scene.ensemble.realizations = lines;
    scene.load.normalForce = force;
    return curvePointsPerElement(scene);
  };
  EXPECT_EQ(points(0.7, 200, 0.0034), 2);  // the paper's
  EXPECT_EQ(points(0.7, 10000, 0.0034), 4);
  EXPECT_EQ(points(0.7, 1000000, 0.0034), 8);
  EXPECT_EQ(points(0.7, 200, 0.0034, 0.02 / 64), 4);
  EXPECT_GE(points(0.7, 200, 10), 4);  // complete contact
  for (const double hurst : {0.0, 0.3, 1.0})
    for (const double force : {1e-4, 0.1, 10.0}) {
      std::int64_t last = 0;
      for (std::int64_t lines = 2; lines <= 1000000; lines *= 7) {
        EXPECT_GE(points(hurst, lines, force), std::max<std::int64_t>(last, 2));
        last = points(hurst, lines, force);
        EXPECT_GE(last, points(1, lines, force));  // the smoother, the fewer
      }
    }
}

TEST(Resolution, StaysWithinTheMemoryOfAMachine) {
  Scene scene;
  for (const std::int64_t elements : {std::int64_t{1} << 23, std::int64_t{1} << 24}) {
    scene.surface.elements = elements;
    EXPECT_LE(elements * pointsPerElement(scene), std::int64_t{1} << 25);
    EXPECT_LE(elements * curvePointsPerElement(scene), std::int64_t{1} << 25);
    EXPECT_GE(pointsPerElement(scene), 2);
  }
  scene.accuracy.oversampling = 4;  // stated
  EXPECT_EQ(pointsPerElement(scene), 4);
}

TEST(Resolution, ALineForATargetIsFinerTheSmallerTheTarget) {
  Scene scene;
  std::int64_t last = 4;
  for (const double target : {0.1, 0.01, 1e-3, 1e-4}) {
    scene.accuracy.targetRelativeError = target;
    EXPECT_GE(pointsPerElement(scene), last);
    last = pointsPerElement(scene);
  }
  EXPECT_EQ(last, 16);
}

/// Scenes that no law accepts are looked at before they are refused.
TEST(Resolution, IsChosenForAnyScene) {
  Scene scene;
  scene.elastomer.rheology = Rheology::Prony;
  scene.elastomer.equilibriumModulus = 0;
  EXPECT_GE(curvePointsPerElement(scene), 2);
  scene.surface.rmsHeight = 0;
  EXPECT_GE(curvePointsPerElement(scene), 2);
  scene = {};
  scene.load.normalForce = 1e30;
  scene.elastomer.shearModulus = 1e-6;
  scene.surface.length = 1e-9;
  EXPECT_GE(curvePointsPerElement(scene), 4);
  scene.load = {LoadKind::Indentation, 0, 1e6};
  EXPECT_GE(curvePointsPerElement(scene), 4);
}

TEST(Resolution, ProvenanceNamesTheNumberUsed) {
  Scene scene;
  EXPECT_EQ(provenance("curve", scene)["oversampling_used"], 2);
  EXPECT_EQ(provenance("figure", scene)["oversampling_used"], 2);
  EXPECT_EQ(provenance("render", scene)["oversampling_used"], 4);
  EXPECT_FALSE(provenance("render", scene).contains("curve_oversampling_used"));
  EXPECT_EQ(provenance("batch", scene)["curve_oversampling_used"], 2);
  EXPECT_EQ(provenance("curve", scene)["scene"]["accuracy"]["oversampling"], 0);
  auto both = provenance("render", scene);
  addCurveOversampling(both, scene);
  EXPECT_EQ(both["curve_oversampling_used"], 2);

  scene.accuracy.oversampling = 6;
  for (const char* verb : {"curve", "render", "surface", "batch"})
    EXPECT_EQ(provenance(verb, scene)["oversampling_used"], 6) << verb;
  EXPECT_FALSE(provenance("batch", scene).contains("curve_oversampling_used"));

  scene.accuracy = {Scheme::Cubic, 0, 0.01};
  EXPECT_TRUE(provenance("curve", scene)["oversampling_used"].is_null());
  scene.accuracy = {Scheme::Nodal, 1, 0};
  EXPECT_EQ(provenance("curve", scene)["oversampling_used"], 1);
}

}  // namespace
}  // namespace asperity
