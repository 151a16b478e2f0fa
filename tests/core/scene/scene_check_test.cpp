// Values that are each allowed but do not go together.
#include "core/scene/scene_check.h"

#include <gtest/gtest.h>

#include "core/base/input_error.h"

namespace asperity {
namespace {

std::string keyRefused(const Scene& scene) {
  try {
    checkScene(scene);
  } catch (const InputError& error) {
    return error.key();
  }
  return {};
}

TEST(SceneCheck, DefaultsGoTogether) {
  EXPECT_EQ(keyRefused(Scene()), "");
}

TEST(SceneCheck, KindsWithAFileNeedOne) {
  for (const SurfaceKind kind :
       {SurfaceKind::Profile, SurfaceKind::Measured, SurfaceKind::Spectrum}) {
    Scene scene;
    scene.surface.kind = kind;
    EXPECT_EQ(keyRefused(scene), "surface.file");
  }
}

TEST(SceneCheck, ASpectrumSaysWhatItsNumbersMean) {
  Scene scene;
  scene.surface.kind = SurfaceKind::Spectrum;
  scene.surface.file = "spectrum.csv";
  EXPECT_EQ(keyRefused(scene), "surface.spectrum_kind");
  scene.surface.spectrumKind = SpectrumKind::C2;
  EXPECT_EQ(keyRefused(scene), "");
}

TEST(SceneCheck, TheLongWaveCutIsAboveTheShortOne) {
  Scene scene;
  scene.surface.kind = SurfaceKind::Measured;
  scene.surface.file = "profile.csv";
  scene.surface.processing.shortWaveCut = 1e-5;
  for (const double cut : {1e-6, 1e-5}) {
    scene.surface.processing.longWaveCut = cut;
    EXPECT_EQ(keyRefused(scene), "surface.long_wave_cut");
  }
  for (const double cut : {0.0, 2e-5}) {
    scene.surface.processing.longWaveCut = cut;
    EXPECT_EQ(keyRefused(scene), "");
  }
}

/// One row of a topography is one line, unless it gives the spectrum of random ones.
TEST(SceneCheck, ARowIsOneLine) {
  Scene scene;
  scene.surface.kind = SurfaceKind::Measured;
  scene.surface.file = "topography.x3p";
  scene.surface.reading.row = 5;
  scene.ensemble.realizations = 3;
  EXPECT_EQ(keyRefused(scene), "ensemble.realizations");
  for (const std::int64_t lines : {0, 1}) {
    scene.ensemble.realizations = lines;
    EXPECT_EQ(keyRefused(scene), "");
  }
  scene.ensemble.realizations = 3;
  scene.surface.reading.row = 0;
  EXPECT_EQ(keyRefused(scene), "");
  scene.surface.reading.row = 5;
  scene.surface.processing.seam = Seam::RandomPhases;
  EXPECT_EQ(keyRefused(scene), "");
}

TEST(SceneCheck, WorkThatNeedsStatedLinesOrAMotionSaysSo) {
  const auto refusal = [](const auto& check) {
    try {
      check();
    } catch (const InputError& error) {
      return error.key() + ": " + error.message().english();
    }
    return std::string();
  };
  Scene scene;
  EXPECT_EQ(refusal([&] { requireNoTarget(scene, "a"); }), "");
  scene.accuracy.targetRelativeError = 0.01;
  EXPECT_EQ(refusal([&] { requireNoTarget(scene, "a fit needs the same lines everywhere"); }),
            "accuracy.target_relative_error: a fit needs the same lines everywhere; give "
            "accuracy.scheme and ensemble.realizations instead of a target");
  EXPECT_EQ(refusal([&] { requireMotion(scene, Message::name("asperity motion")); }),
            "sliding.kind: is steady, so nothing changes in time; asperity motion needs start, "
            "step, oscillation or reversal");
  scene.sliding.kind = SlidingKind::Start;
  EXPECT_EQ(refusal([&] { requireMotion(scene, Message::name("asperity motion")); }), "");
}

}  // namespace
}  // namespace asperity
