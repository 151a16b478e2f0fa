// From measured rows to the lines of the model: seams, orientation, realizations, the isotropic
// equivalent. The files are made in memory, so that no reader takes part.
#include "core/surface/measured_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "core/base/input_error.h"
#include "core/base/stop.h"
#include "tests/core/error_from.h"
#include "tests/core/isotropic_surface.h"

namespace asperity {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

Scene measuredScene(Seam seam = Seam::Mirror) {
  Scene scene;
  scene.surface.kind = SurfaceKind::Measured;
  scene.surface.file = "surface.x3p";
  scene.surface.length = 0;
  scene.surface.elements = 0;
  scene.surface.processing.seam = seam;
  scene.ensemble.realizations = 0;
  return scene;
}

std::shared_ptr<const MeasuredFile> fileOf(Topography topography) {
  MeasuredFile file;
  file.topography = std::move(topography);
  return std::make_shared<const MeasuredFile>(std::move(file));
}

Topography topographyOf(std::vector<double> heights, std::int64_t rows = 1, double spacing = 1e-6) {
  const auto columns = static_cast<std::int64_t>(heights.size()) / rows;
  return {columns, rows, spacing, rows > 1 ? spacing : 0, std::move(heights)};
}

/// A walk that is not periodic: its ends are far apart.
std::vector<double> walk(std::size_t points, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0.0, 1e-8);
  std::vector<double> heights{0};
  while (heights.size() < points) heights.push_back(heights.back() + normal(random));
  return heights;
}

std::vector<double> nodesOf(const FourierLine& line, std::size_t points) {
  std::vector<double> heights;
  FourierTransform(points).evaluate(line, heights);
  return heights;
}

std::string errorOf(const Scene& scene, const Topography& topography) {
  return errorFrom([&] {
    const MeasuredLines lines(scene, fileOf(topography));
    lines.modes(0);
  });
}

TEST(MeasuredLines, OfAMirroredProfileAreTwiceAsLongAndEven) {
  const Scene scene = measuredScene();
  const MeasuredLines lines(scene, fileOf(topographyOf(walk(500))));
  EXPECT_DOUBLE_EQ(lines.length(), 1e-3);
  EXPECT_EQ(lines.points(), 1000);
  const std::vector<double> z = nodesOf(lines.modes(0), 1000);
  for (std::size_t i = 0; i < 500; ++i) EXPECT_NEAR(z[i], z[999 - i], 1e-18);
}

/// The summits of the surface are the lowest points of the rigid line, which lies above the rubber.
TEST(MeasuredLines, TurnTheSurfaceOverSoThatItsSummitsTouch) {
  std::vector<double> heights(200, 0.0);
  heights[80] = 1e-6;
  Scene scene = measuredScene();
  scene.surface.processing.form = FormRemoval::Mean;
  const std::vector<double> summits =
      nodesOf(MeasuredLines(scene, fileOf(topographyOf(heights))).modes(0), 400);
  EXPECT_EQ(std::ranges::min_element(summits) - summits.begin(), 80);
  EXPECT_EQ(MeasuredLines(scene, fileOf(topographyOf(heights))).profile(0).used[80], 1e-6 - 5e-9);
  scene.surface.contactSide = ContactSide::Valleys;
  const std::vector<double> valleys =
      nodesOf(MeasuredLines(scene, fileOf(topographyOf(heights))).modes(0), 400);
  for (std::size_t i = 0; i < 400; ++i) EXPECT_EQ(valleys[i], -summits[i]);
}

/// The line goes through the heights of the file, but for the mean and the highest wave of all.
TEST(MeasuredLines, GoThroughTheHeightsOfAPeriodicFile) {
  std::vector<double> heights;
  for (int i = 0; i < 301; ++i)
    heights.push_back(1e-6 * std::sin(2 * std::numbers::pi * 7 * i / 301) +
                      2e-7 * std::cos(2 * std::numbers::pi * 40 * i / 301));
  Scene scene = measuredScene(Seam::Periodic);
  scene.surface.processing.form = FormRemoval::None;
  scene.surface.contactSide = ContactSide::Valleys;
  const MeasuredLines lines(scene, fileOf(topographyOf(heights)));
  const std::vector<double> z = nodesOf(lines.modes(0), 301);
  for (std::size_t i = 0; i < 301; ++i) EXPECT_NEAR(z[i], heights[i], 1e-20);
  EXPECT_FALSE(lines.hasSeamJump(lines.profile(0)));
}

/// Steps at the seam are counted: only `periodic` makes them, and it is noticed each time.
TEST(MeasuredLines, NeverMakeAStepAtTheSeamInSilence) {
  int noticed = 0, steps = 0;
  for (const Seam seam : {Seam::Mirror, Seam::Blend, Seam::Periodic})
    for (unsigned seed = 1; seed <= 40; ++seed) {
      Scene scene = measuredScene(seam);
      scene.surface.processing.form = FormRemoval::Mean;
      const MeasuredLines lines(scene, fileOf(topographyOf(walk(600, seed))));
      const ProcessedProfile profile = lines.profile(0);
      const std::vector<double> period = lines.period(profile);
      double largest = 0;
      for (std::size_t i = 1; i < profile.used.size(); ++i)
        largest = std::max(largest, std::abs(profile.used[i] - profile.used[i - 1]));
      const bool isStep = std::abs(period.front() - period.back()) > 1.5 * largest;
      EXPECT_TRUE(!isStep || lines.hasSeamJump(profile)) << seed;
      EXPECT_TRUE(seam == Seam::Periodic || !lines.hasSeamJump(profile));
      steps += isStep ? 1 : 0;
      noticed += lines.hasSeamJump(profile) ? 1 : 0;
    }
  EXPECT_GT(steps, 20);  // of 40 walks that are left as they are
  EXPECT_GE(noticed, steps);
}

TEST(MeasuredLines, BlendTheEndIntoTheBeginning) {
  Scene scene = measuredScene(Seam::Blend);
  scene.surface.processing.form = FormRemoval::None;
  scene.surface.processing.blendLength = 1e-4;
  const std::vector<double> heights = walk(600);
  const MeasuredLines lines(scene, fileOf(topographyOf(heights)));
  EXPECT_EQ(lines.points(), 500);
  EXPECT_DOUBLE_EQ(lines.length(), 5e-4);
  const std::vector<double> period = lines.period(lines.profile(0));
  for (std::size_t i = 100; i < 500; ++i) EXPECT_EQ(period[i], heights[i]);
  EXPECT_NEAR(period[0], heights[500], 1e-4 * std::abs(heights[500] - heights[0]));
  for (std::size_t i = 0; i < 100; ++i) {
    EXPECT_LE(period[i], std::max(heights[i], heights[500 + i]));
    EXPECT_GE(period[i], std::min(heights[i], heights[500 + i]));
  }
}

TEST(MeasuredLines, TakeAsMuchOfTheFileAsThePeriodNeeds) {
  Scene scene = measuredScene();
  scene.surface.length = 6e-4;
  EXPECT_EQ(MeasuredLines(scene, fileOf(topographyOf(walk(500)))).points(), 600);
  scene.surface.length = 2e-3;
  EXPECT_EQ(errorOf(scene, topographyOf(walk(500))),
            "surface.length: 2 mm is more than the period of 1 mm that the file gives with "
            "this seam");
}

TEST(MeasuredLines, DoNotPromiseToFillARowWithoutHeights) {
  std::vector<double> heights(100, kNone);
  const std::vector<double> measured = walk(100);
  heights.insert(heights.end(), measured.begin(), measured.end());
  Scene scene = measuredScene();
  EXPECT_EQ(errorOf(scene, topographyOf(heights, 2)),
            "surface.gaps: row 1 has 0 measured points; interpolate leaves such rows out and fills "
            "the gaps of the others");
  scene.surface.reading.row = 1;
  EXPECT_EQ(errorOf(scene, topographyOf(heights, 2)),
            "surface.row: row 1 has 0 measured points; a line needs 3 or more");
  scene.surface.reading.row = 2;
  EXPECT_EQ(MeasuredLines(scene, fileOf(topographyOf(heights, 2))).rows(), 1);
}

TEST(MeasuredLines, RefuseGapsUnlessTheyAreToBeFilled) {
  std::vector<double> heights = walk(100);
  heights[7] = heights[8] = kNone;
  Scene scene = measuredScene();
  EXPECT_EQ(errorOf(scene, topographyOf(heights)),
            "surface.gaps: row 1 has 2 points without a height, the first is point 8; "
            "interpolate fills them");
  scene.surface.processing.gaps = GapHandling::Interpolate;
  scene.surface.processing.form = FormRemoval::None;
  const ProcessedProfile filled = MeasuredLines(scene, fileOf(topographyOf(heights))).profile(0);
  EXPECT_EQ(filled.gaps, 2);
  EXPECT_TRUE(std::isnan(filled.raw[7]));
  EXPECT_DOUBLE_EQ(filled.used[7], heights[6] + (heights[9] - heights[6]) / 3);
}

/// Gaps at the ends of a profile are no part of it; rows of a topography keep their length.
TEST(MeasuredLines, LeaveOutGapsAtTheEndsAndEmptyRows) {
  std::vector<double> heights = walk(100);
  heights[0] = heights[99] = heights[98] = kNone;
  Scene scene = measuredScene();
  scene.surface.processing.gaps = GapHandling::Interpolate;
  EXPECT_EQ(MeasuredLines(scene, fileOf(topographyOf(heights))).points(), 194);
  std::vector<double> rows(100, kNone);
  rows.insert(rows.end(), heights.begin(), heights.end());
  const MeasuredLines lines(scene, fileOf(topographyOf(rows, 2)));
  EXPECT_EQ(lines.points(), 200);
  EXPECT_EQ(lines.rows(), 1);
  EXPECT_EQ(lines.missingHeights().rowsLeftOut, 1);
  EXPECT_EQ(lines.missingHeights().gaps, 3);  // those of the row that is left out do not count
  EXPECT_EQ(lines.numberInFile(0), 2);
}

TEST(MeasuredLines, AreTheRowsOfATopographyInTurnOrOneOfThem) {
  std::vector<double> heights;
  for (unsigned row = 0; row < 5; ++row)
    for (const double z : walk(64, row + 1)) heights.push_back(z);
  Scene scene = measuredScene();
  const MeasuredLines all(scene, fileOf(topographyOf(heights, 5)));
  EXPECT_EQ(all.rows(), 5);
  for (std::int64_t row = 0; row < 5; ++row) {
    scene.surface.reading.row = row + 1;
    const MeasuredLines one(scene, fileOf(topographyOf(heights, 5)));
    EXPECT_EQ(one.rows(), 1);
    EXPECT_EQ(one.modes(0).coefficients, all.modes(row).coefficients);
  }
  scene.surface.reading.row = 6;
  EXPECT_EQ(errorOf(scene, topographyOf(heights, 5)),
            "surface.row: 6 is outside 0 to 5, the rows of the file");
  scene.surface.reading.row = 0;
  scene.ensemble.realizations = 6;
  EXPECT_EQ(errorOf(scene, topographyOf(heights, 5)),
            "ensemble.realizations: 6 is more than the 5 rows of the file; 0 is every row");
}

/// What is counted is what the lines are made of: the used part of each used row.
TEST(MeasuredLines, CountWhatIsInterpolatedInAllRows) {
  std::vector<double> heights(3 * 100, kNone);
  for (const std::size_t row : {0U, 2U}) {
    const std::vector<double> measured = walk(100, static_cast<unsigned>(row + 1));
    std::ranges::copy(measured, heights.begin() + static_cast<std::ptrdiff_t>(100 * row));
  }
  heights[10] = heights[11] = heights[90] = heights[230] = kNone;
  heights[50] = 1;  // m
  Scene scene = measuredScene();
  scene.surface.processing.gaps = GapHandling::Interpolate;
  scene.surface.processing.outliers = 100;
  const auto missing = [&] {
    return MeasuredLines(scene, fileOf(topographyOf(heights, 3))).missingHeights();
  };
  EXPECT_EQ(missing().rowsLeftOut, 1);
  EXPECT_EQ(missing().gaps, 4);
  EXPECT_EQ(missing().outliers, 1);
  scene.surface.length = 1e-4;  // half of each row
  EXPECT_EQ(missing().gaps, 3);
  scene.surface.reading.row = 3;
  EXPECT_EQ(missing().gaps, 1);
  EXPECT_EQ(missing().outliers, 0);
}

TEST(MeasuredLines, AreAsManyAsTheRowsThatCanBeUsed) {
  Scene scene = measuredScene();
  scene.surface.processing.gaps = GapHandling::Interpolate;
  std::vector<double> heights(64, kNone);
  for (unsigned row = 1; row < 3; ++row)
    for (const double z : walk(64, row)) heights.push_back(z);
  scene.ensemble.realizations = 3;
  EXPECT_EQ(errorOf(scene, topographyOf(heights, 3)),
            "ensemble.realizations: 3 is more than the rows of the file with 3 measured points or "
            "more, which are 2 of 3; 0 is every one of them");
  scene.ensemble.realizations = 2;
  EXPECT_EQ(errorOf(scene, topographyOf(heights, 3)), "no error");
}

TEST(MeasuredLines, OfFewerRealizationsAreSpreadOverTheRows) {
  EXPECT_EQ(rowOfRealization(3, 0, 10), 3);
  EXPECT_EQ(rowOfRealization(0, 2, 10), 0);
  EXPECT_EQ(rowOfRealization(1, 2, 10), 5);
  EXPECT_EQ(rowOfRealization(9, 10, 10), 9);
}

/// Random lines have the height of the profile and other phases each time.
TEST(MeasuredLines, OfRandomPhasesKeepTheSpectrum) {
  const IsotropicSurface surface;
  Scene scene = measuredScene(Seam::RandomPhases);
  scene.ensemble.realizations = 10;
  scene.surface.processing.form = FormRemoval::Mean;
  const MeasuredLines lines(scene, fileOf(surface.make(1)));
  double square = 0;
  for (std::int64_t row = 0; row < lines.rows(); ++row) {
    for (const double z : lines.profile(row).used)
      square += z * z / static_cast<double>(lines.rows() * 256);
  }
  EXPECT_NEAR(rmsHeight(lines.modes(3)) / std::sqrt(square), 1, 0.01);
  EXPECT_NE(lines.modes(3).coefficients, lines.modes(4).coefficients);
  EXPECT_EQ(lines.modes(3).coefficients, lines.modes(3).coefficients);
}

/// A piece of a long self-affine line, which has no beginning and no end. slope: that of the line.
std::vector<double> cutProfile(double hurst, unsigned seed, double& slope) {
  constexpr std::size_t kWaves = 2047, kPoints = 512;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> phase(0, 2 * std::numbers::pi);
  std::vector<double> heights(kPoints);
  double square = 0;
  for (std::size_t k = 1; k <= kWaves; ++k) {
    const double wave = 2 * std::numbers::pi * static_cast<double>(k) / (2 * kWaves + 2);
    const double amplitude = 1e-6 * std::pow(k, -hurst - 0.5), begin = phase(random);
    square += std::pow(amplitude * wave / 1e-6, 2) / 2;
    for (std::size_t i = 0; i < kPoints; ++i)
      heights[i] += amplitude * std::cos(wave * static_cast<double>(i) + begin);
  }
  slope = std::sqrt(square);
  return heights;
}

/// The window takes from the long waves of one profile alone, in which most of its height may be:
/// what it took must not be given to the short ones, which make the slope and so the friction.
TEST(MeasuredLines, OfRandomPhasesKeepTheSlopeOfAProfile) {
  constexpr unsigned kProfiles = 30;
  for (const double hurst : {0.3, 0.8}) {
    double mean = 0, square = 0;
    for (unsigned seed = 1; seed <= kProfiles; ++seed) {
      double slope = 0;
      std::vector<double> heights = cutProfile(hurst, seed, slope);
      const MeasuredLines lines(measuredScene(Seam::RandomPhases),
                                fileOf(topographyOf(std::move(heights))));
      const double ratio = rmsSlope(lines.modes(0)) / slope;
      mean += ratio / kProfiles;
      square += std::pow(ratio - 1, 2) / kProfiles;
    }
    EXPECT_NEAR(mean, 1, 0.04) << hurst;
    EXPECT_LT(std::sqrt(square), 0.1) << hurst;
  }
}

struct Squares {
  double height = 0, slope = 0;
};

/// Mean squares of the lines of 200 surfaces, one row of each, relative to the surfaces' own: of
/// each kind of line.
std::vector<Squares> meanOfLines(const IsotropicSurface& surface, std::vector<LineKind> kinds,
                                 bool fromProfile, Seam seam) {
  constexpr unsigned kSurfaces = 200;
  Scene scene = measuredScene(seam);
  scene.surface.processing.form = FormRemoval::None;
  std::vector<Squares> means(kinds.size());
  const double squareGradient = surface.squareGradient();
  const std::vector<double> amplitudes = surface.amplitudes();
  for (unsigned r = 0; r < kSurfaces; ++r) {
    Topography topography = surface.make(r + 1, amplitudes);
    if (fromProfile) {
      const auto row = topography.row(100);
      topography = topographyOf({row.begin(), row.end()}, 1, surface.spacing);
    } else {
      scene.surface.reading.row = 101;
    }
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      scene.surface.line = kinds[k];
      const FourierLine line = MeasuredLines(scene, fileOf(topography)).modes(0);
      means[k].height += std::pow(rmsHeight(line) / surface.height, 2) / kSurfaces;
      means[k].slope += std::pow(rmsSlope(line), 2) / squareGradient / kSurfaces;
    }
  }
  return means;
}

/// C_line = pi q C2: <h^2> of the line is that of the surface, and <z'^2> its <|grad h|^2>; a row
/// as it is has half of it.
TEST(IsotropicEquivalent, HasTheHeightAndTheGradientOfItsSurface) {
  const IsotropicSurface surface;
  const auto means = meanOfLines(surface, {LineKind::IsotropicEquivalent, LineKind::AsMeasured},
                                 false, Seam::Mirror);
  const Squares line = means[0], row = means[1];
  EXPECT_NEAR(std::sqrt(line.height), 1, 0.03);
  EXPECT_NEAR(std::sqrt(line.slope), 1, 0.03);
  EXPECT_NEAR(std::sqrt(2 * row.slope), 1, 0.03);
}

/// A row that is levelled by itself loses height, and its equivalent gets that of the levelled
/// surface back, in the mean over all rows.
TEST(IsotropicEquivalent, HasTheHeightOfTheSurfaceWhereRowsAreLevelled) {
  IsotropicSurface surface;
  surface.rollOffWaves = 6;  // of 512 points; a row has half of them
  Scene scene = measuredScene();
  double lines = 0, rows = 0, whole = 0;
  const std::vector<double> amplitudes = surface.amplitudes();
  for (unsigned seed = 1; seed <= 24; ++seed) {
    const Topography topography = surface.make(seed, amplitudes);
    const auto size = static_cast<std::size_t>(topography.columns);
    std::vector<double> plane = topography.height;
    removeForm(plane, size, size, FormRemoval::Line);
    for (const double z : plane) whole += z * z / static_cast<double>(size * size);
    scene.surface.line = LineKind::IsotropicEquivalent;
    const MeasuredLines equivalent(scene, fileOf(topography));
    constexpr std::int64_t kStep = 8;  // rows near each other are much alike
    const auto count = static_cast<double>(equivalent.rows() / kStep);
    for (std::int64_t row = 0; row < equivalent.rows(); row += kStep) {
      lines += std::pow(rmsHeight(equivalent.modes(row)), 2) / count;
      rows += std::pow(rmsHeight(equivalent.measuredModes(row)), 2) / count;
    }
    // The factors that are told are those of the first line.
    const FourierLine first = equivalent.modes(0), measured = equivalent.measuredModes(0);
    EXPECT_DOUBLE_EQ(equivalent.equivalentRatios().height, rmsHeight(first) / rmsHeight(measured));
    EXPECT_DOUBLE_EQ(equivalent.equivalentRatios().slope, rmsSlope(first) / rmsSlope(measured));
    scene.surface.line = LineKind::AsMeasured;
    EXPECT_EQ(MeasuredLines(scene, fileOf(topography)).equivalentRatios().height, 1);
  }
  EXPECT_NEAR(std::sqrt(lines / whole), 1, 0.05);
  EXPECT_LT(std::sqrt(rows / whole), 0.95);
}

/// Returns the first rows of a topography, or every step-th of them.
Topography strip(const Topography& all, std::int64_t rows, std::int64_t step) {
  Topography part{
      all.columns, rows, all.columnSpacing, static_cast<double>(step) * all.rowSpacing, {}};
  for (std::int64_t row = 0; row < rows; ++row) {
    const auto heights = all.row(row * step);
    part.height.insert(part.height.end(), heights.begin(), heights.end());
  }
  return part;
}

/// A line scanner gives few rows, whose window mixes the long waves with the short ones, and wide
/// distances between rows fold short waves across. Neither makes the surface steeper.
TEST(IsotropicEquivalent, OfFewRowsHasTheGradientOfTheirSurface) {
  IsotropicSurface surface;
  surface.size = 1024;
  surface.part = 512;
  surface.highestWaves = 200;
  Scene scene = measuredScene();
  scene.surface.line = LineKind::IsotropicEquivalent;
  constexpr std::array kStrips{std::pair{8, 1}, std::pair{16, 1}, std::pair{32, 1},
                               std::pair{16, 4}, std::pair{100, 4}};
  constexpr unsigned kSurfaces = 6;
  std::array<double, kStrips.size()> square{};
  const std::vector<double> amplitudes = surface.amplitudes();
  for (unsigned seed = 1; seed <= kSurfaces; ++seed) {
    const Topography all = surface.make(seed, amplitudes);
    for (std::size_t i = 0; i < kStrips.size(); ++i) {
      const auto [rows, step] = kStrips[i];
      const MeasuredLines lines(scene, fileOf(strip(all, rows, step)));
      for (std::int64_t row = 0; row < rows; ++row)
        square[i] += std::pow(rmsSlope(lines.modes(row)), 2) / (kSurfaces * rows);
    }
  }
  for (std::size_t i = 0; i < kStrips.size(); ++i)
    EXPECT_NEAR(std::sqrt(square[i] / surface.squareGradient()), 1, 0.05) << kStrips[i].first;
}

/// The rows of a surface with grooves along them are smooth; the whole surface is not.
TEST(IsotropicEquivalent, HasTheGradientOfGroovesAcrossThem) {
  constexpr std::int64_t kPoints = 256;
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> phase(0, 2 * std::numbers::pi);
  std::vector<double> across(kPoints);
  for (int wave = 8; wave < 40; ++wave) {
    const double shift = phase(random);
    for (std::size_t y = 0; y < across.size(); ++y)
      across[y] +=
          1e-7 * std::sin(2 * std::numbers::pi * wave * static_cast<double>(y) / kPoints + shift);
  }
  std::vector<double> heights;
  for (const double z : across)
    for (std::int64_t x = 0; x < kPoints; ++x) heights.push_back(z + 1e-8 * normal(random));
  double square = 0;
  for (std::size_t i = 1; i < across.size(); ++i)
    square += std::pow((across[i] - across[i - 1]) / 1e-6, 2) / kPoints;
  const EquivalentSpectra spectra =
      equivalentSpectra(topographyOf(heights, kPoints), FormRemoval::None);
  EXPECT_NEAR(spectra.line.rmsSlope() / std::sqrt(square), 1, 0.15);
}

TEST(IsotropicEquivalent, OfCutProfilesIsThatOfTheSurface) {
  const IsotropicSurface surface;
  const Squares line =
      meanOfLines(surface, {LineKind::IsotropicEquivalent}, true, Seam::Mirror).front();
  EXPECT_NEAR(std::sqrt(line.height), 1, 0.03);
  EXPECT_NEAR(std::sqrt(line.slope), 1, 0.03);
}

/// The spectrum of a whole surface is the long part of the work: it says how far it is, and ends
/// soon where nobody wants it any more.
TEST(MeasuredLines, TheSpectrumOfASurfaceSaysHowFarItIsAndCanBeStopped) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0.0, 1e-7);
  std::vector<double> heights(96 * 128);
  for (double& z : heights) z = normal(random);
  const auto file = fileOf(topographyOf(heights, 96));
  Scene scene = measuredScene();
  scene.surface.line = LineKind::IsotropicEquivalent;
  std::vector<double> parts;
  const MeasuredLines lines(scene, file, {}, [&parts](double part) { parts.push_back(part); });
  ASSERT_GT(parts.size(), 20U);
  EXPECT_TRUE(std::ranges::is_sorted(parts));
  EXPECT_GT(parts.front(), 0);
  EXPECT_EQ(parts.back(), 1);
  for (const double until : {0.0, 0.4, 0.9}) {
    std::stop_source source;
    if (until == 0) source.request_stop();
    double last = 0;
    const auto stopAt = [&](double part) {
      last = part;
      if (part >= until) source.request_stop();
    };
    EXPECT_THROW(MeasuredLines(scene, file, source.get_token(), stopAt), StopRequested) << until;
    EXPECT_LT(last, until + 0.05);
  }
}

}  // namespace
}  // namespace asperity
