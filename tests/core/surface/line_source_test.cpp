#include "core/surface/line_source.h"

#include <gmock/gmock.h>

#include <cmath>
#include <set>
#include <thread>

#include "core/base/input_error.h"
#include "core/scene/scene_file.h"
#include "core/surface/profile_file.h"
#include "core/surface/random_phases.h"
#include "core/surface/surface_file.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

Scene roughScene(std::int64_t elements) {
  Scene scene;
  scene.surface.elements = elements;
  return scene;
}

double rms(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

TEST(LineSource, HeightAndSlopeAreExactForEveryRealization) {
  const LineSource source(roughScene(1000), 2);
  for (const std::int64_t realization : {0, 1, 199}) {
    const Line line = source.make(realization);
    EXPECT_EQ(line.nodes(), 2000U);
    EXPECT_NEAR(rms(line.height), 5e-7, 1e-18);
    EXPECT_NEAR(rms(line.slopeAfter) / line.rmsSlope, 1, 1e-11);
    EXPECT_EQ(line.rmsHeight, source.statistics().rmsHeight);
  }
}

TEST(LineSource, LinesDependOnSeedAndRealizationAlone) {
  const LineSource source(roughScene(500), 1);
  const Line once = source.make(7);
  Line other;
  std::thread([&] { other = LineSource(roughScene(500), 1).make(7); }).join();
  EXPECT_EQ(once.height, other.height);
  EXPECT_NE(once.height, source.make(8).height);
  Scene seeded = roughScene(500);
  seeded.surface.seed = 2;
  EXPECT_NE(once.height, LineSource(seeded, 1).make(7).height);
}

/// Every bit of a seed counts, up to the largest that a scene may have, on the way from the text of
/// a scene to the line.
TEST(LineSource, SeedsThatDifferAnywhereAreOtherLines) {
  std::set<std::vector<double>> lines;
  const std::vector<std::string> seeds{"1",          "4294967297",       "8589934593",
                                       "4294967296", "4503599627370497", "9007199254740991"};
  for (const std::string& seed : seeds) {
    const Scene scene = readScene(R"({"surface":{"elements":64,"seed":)" + seed + "}}", "s.json");
    EXPECT_EQ(std::to_string(scene.surface.seed), seed);
    EXPECT_EQ(readScene(writeScene(scene), "s.json").surface.seed, scene.surface.seed);
    const Line line = LineSource(scene, 1).make(0);
    EXPECT_TRUE(lines.insert(line.height).second) << seed;
    // The phase of the first wave is that of the authors' generator under the whole seed.
    const auto whole = static_cast<std::uint64_t>(std::stoull(seed));
    const std::complex<double> first = LineSource(scene, 1).spectrum(0).coefficients[0];
    EXPECT_LT(std::abs(first / std::abs(first) - std::polar(1.0, randomPhases(whole, 0, 0).odd)),
              1e-12);
    EXPECT_EQ(readScene("{}", "s.json", {}, {"surface.seed=" + seed}).surface.seed,
              scene.surface.seed);
  }
}

TEST(LineSource, OversamplingAddsPointsToTheSameLine) {
  const Line coarse = LineSource(roughScene(500), 1).make(3);
  const Line fine = LineSource(roughScene(500), 4).make(3);
  for (std::size_t i = 0; i < coarse.nodes(); ++i) {
    EXPECT_NEAR(coarse.height[i], fine.height[4 * i], 1e-19);
    EXPECT_NEAR(coarse.slopeAfter[i], fine.slopeAfter[4 * i], 1e-13);
  }
}

TEST(LineSource, MoreElementsKeepTheLongWaves) {
  const FourierLine coarse = LineSource(roughScene(101), 1).spectrum(0);
  const FourierLine fine = LineSource(roughScene(1001), 1).spectrum(0);
  for (std::size_t j = 0; j < coarse.coefficients.size(); ++j)
    EXPECT_NEAR(std::arg(coarse.coefficients[j] / fine.coefficients[j]), 0, 1e-12);
}

TEST(LineSource, PhasesAreUniform) {
  // Mean resultant length of n uniform phases is about 1 / sqrt(n).
  std::complex<double> sum = 0;
  double count = 0;
  const LineSource source(roughScene(2000), 1);
  for (int realization = 0; realization < 20; ++realization)
    for (const auto& c : source.spectrum(realization).coefficients) {
      sum += c / std::abs(c);
      ++count;
    }
  EXPECT_LT(std::abs(sum) / count, 4 / std::sqrt(count));
}

TEST(LineSource, EveryModeHasItsOwnPhase) {
  for (const std::int64_t elements : {4, 1025, 1026, 1027, 2600}) {
    const FourierLine line = LineSource(roughScene(elements), 1).spectrum(5);
    for (std::size_t mode = 1; mode <= line.coefficients.size(); ++mode) {
      const PhasePair two = randomPhases(1, 5, mode / 2);
      const std::complex<double> c = line.coefficients[mode - 1];
      EXPECT_LT(std::abs(c / std::abs(c) - std::polar(1.0, mode % 2 == 0 ? two.even : two.odd)),
                1e-12);
    }
  }
}

/// The longest steps of a line are its transforms: none begins after it is told to stop.
TEST(LineSource, StopsBeforeItsTransforms) {
  const LineSource source(roughScene(500), 1);
  std::stop_source stop;
  Line line;
  EXPECT_TRUE(source.makeInto(line, 0, Slopes::Computed, stop.get_token()));
  EXPECT_EQ(line.height, source.make(0).height);
  stop.request_stop();
  Line none;
  EXPECT_FALSE(source.makeInto(none, 0, Slopes::Computed, stop.get_token()));
  EXPECT_TRUE(none.height.empty());
}

TEST(LineSource, SmallAndOddNumbersOfElementsWork) {
  for (const std::int64_t elements : {3, 4, 7, 4999}) {
    const Line line = LineSource(roughScene(elements), 1).make(0);
    EXPECT_EQ(line.nodes(), static_cast<std::size_t>(elements));
    EXPECT_NEAR(rms(line.height), 5e-7, 1e-18);
  }
}

TEST(LineSource, AFlatLineIsFlat) {
  Scene scene = roughScene(100);
  scene.surface.rmsHeight = 0;
  EXPECT_THAT(LineSource(scene, 1).make(0).height, testing::Each(0.0));
}

TEST(LineSource, AWrittenLineReadAsProfileIsTheSameLine) {
  const TemporaryFolder folder;
  const Line line = LineSource(roughScene(250), 1).make(0);
  folder.write("line.csv", lineCsv(line));
  Scene scene;
  scene.surface = {};
  scene.surface.kind = SurfaceKind::Profile;
  scene.surface.length = 0;
  scene.surface.elements = 0;
  scene.surface.file = "line.csv";
  scene.folder = folder.path();
  const LineSource source(scene, 1);
  EXPECT_FALSE(source.isRandom());
  EXPECT_NEAR(source.length(), line.length, 1e-15);
  const Line read = source.make(0);
  for (std::size_t i = 0; i < line.nodes(); ++i) {
    EXPECT_NEAR(read.height[i], line.height[i], 1e-18);
    EXPECT_NEAR(read.slopeAfter[i], line.slopeAfter[i], 1e-12);
  }
  scene.surface.length = 0.04;  // the scene's length wins
  EXPECT_NEAR(LineSource(scene, 1).statistics().rmsSlope, line.rmsSlope / 2, 1e-12);
}

TEST(LineSource, ScenesThatCannotRunAreRefused) {
  Scene scene = roughScene(10);
  scene.surface.kind = SurfaceKind::Sine;
  scene.surface.waves = 5;
  EXPECT_THROW(LineSource(scene, 1), InputError);
  // 2^26 points at most.
  scene = roughScene(std::int64_t{1} << 24);
  try {
    const LineSource source(scene, 64);
    FAIL() << "a line of 2^30 points";
  } catch (const InputError& error) {
    EXPECT_EQ(error.key(), "surface.elements");
    EXPECT_THAT(error.message().english(),
                testing::HasSubstr("allowed are up to 1048576 elements, or with "
                                   "accuracy.oversampling 4 up to 16777216"));
  }
}

/// Memory is used again: whatever line lay in it, the next one is as if it were the first.
TEST(LineSource, ALineMadeOverAnotherHasNothingOfIt) {
  std::vector<LineSource> sources;
  for (const SurfaceKind kind : {SurfaceKind::SelfAffine, SurfaceKind::Wedge, SurfaceKind::Sine,
                                 SurfaceKind::Parabola, SurfaceKind::SelfAffine})
    for (const std::int64_t elements : {40, 100}) {
      Scene scene;
      scene.surface.kind = kind;
      scene.surface.elements = elements;
      sources.emplace_back(scene, 2);
    }
  for (const LineSource& before : sources)
    for (const LineSource& after : sources) {
      Line line = before.make(0);
      ASSERT_TRUE(after.makeInto(line, 3, Slopes::Computed, {}));
      const Line fresh = after.make(3);
      EXPECT_EQ(line.height, fresh.height);
      EXPECT_EQ(line.slopeAfter, fresh.slopeAfter);
      EXPECT_EQ(line.slopeBefore, fresh.slopeBefore);
      EXPECT_EQ(line.rmsSlope, fresh.rmsSlope);
      EXPECT_EQ(line.spacing, fresh.spacing);
    }
}

}  // namespace
}  // namespace asperity
