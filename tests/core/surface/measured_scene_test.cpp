// Scenes of measured surfaces and spectra from the file to the friction curve: the same line for
// every caller, both directions of a mirrored profile, rows as realizations, nominal pressure,
// notes, provenance.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/accuracy/compute_curve.h"
#include "core/accuracy/explanation.h"
#include "core/accuracy/pilot.h"
#include "core/accuracy/prediction.h"
#include "core/accuracy/target_curve.h"
#include "core/base/file_digest.h"
#include "core/base/input_error.h"
#include "core/contact/steady_solver.h"
#include "core/friction/curve_file.h"
#include "core/friction/line_mean.h"
#include "core/run/rigid_line.h"
#include "core/scene/plan.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_file.h"
#include "core/surface/measured_summary.h"
#include "core/surface/surface_file.h"
#include "tests/core/contact/lines.h"
#include "tests/core/error_from.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A rough profile as people have it: position in millimetres, height in micrometres, tilted.
std::string profileText(unsigned seed = 1, int points = 400) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> phase(0, 2 * std::numbers::pi);
  std::vector<double> heights(static_cast<std::size_t>(points));
  for (int k = 1; k < 60; ++k) {
    const double shift = phase(random), amplitude = std::pow(k, -1.2);
    for (int i = 0; i < points; ++i)
      heights[static_cast<std::size_t>(i)] +=
          amplitude * std::cos(2 * std::numbers::pi * 0.7 * k * i / points + shift);
  }
  std::string text = "x [mm]\tz [um]\n";
  for (int i = 0; i < points; ++i)
    text += std::to_string(0.01 * i) + "\t" +
            std::to_string(heights[static_cast<std::size_t>(i)] + 0.01 * i) + "\n";
  return text;
}

std::string matrixText(int rows, int columns) {
  std::string text = "# Channel: Height\n# Width: " + std::to_string(columns) +
                     " \u00B5m\n# Height: " + std::to_string(rows) + " \u00B5m\n# Value units: m\n";
  std::mt19937 random(9);
  std::normal_distribution<double> normal(0.0, 1e-8);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      text += std::to_string(1e9 * normal(random)) + "e-9" + (column + 1 < columns ? "\t" : "\n");
  return text;
}

class MeasuredScene : public testing::Test {
 protected:
  MeasuredScene() {
    folder_.write("p.txt", profileText());
    folder_.write("m.txt", matrixText(12, 64));
    folder_.write("s.csv", "q,C1\n1e3,1e-17\n1e4,1e-18\n1e5,1e-20\n");
  }

  Scene scene(const std::vector<std::string>& settings = {}, const std::string& file = "p.txt") {
    return readScene(R"({"surface": {"kind": "measured", "file": ")" + file + R"("},
        "elastomer": {"rheology": "kelvin", "shear_modulus": 1e6, "relaxation_time": 1e-3},
        "load": {"kind": "force", "normal_force": 0.05},
        "sweep": {"velocity_from": 1e-3, "velocity_to": 10, "points": 5}})",
                     "test", folder_.path(), settings);
  }

  /// Returns whether a sentence of the summary has these words.
  bool says(const std::vector<std::string>& settings, const std::string& words,
            const std::string& file = "p.txt") {
    const Scene measured = scene(settings, file);
    return std::ranges::any_of(
        factsOf(measuredSummary(measured, LineSource(measured, 1))),
        [&words](const Message& fact) { return fact.english().find(words) != std::string::npos; });
  }

  std::string errorOf(const std::vector<std::string>& settings, const std::string& file = "p.txt") {
    return errorFrom([&] { LineSource(scene(settings, file), 1); });
  }

  TemporaryFolder folder_;
};

TEST_F(MeasuredScene, IsTheSameLineForEveryCaller) {
  const Scene measured = scene();
  const LineSource source(measured, 1);
  const Line line = source.make(0);
  EXPECT_NEAR(line.length, 8e-3, 1e-9);
  EXPECT_EQ(line.nodes(), 800U);
  // The window's runner and motions take the line from RigidLine, with the points of the picture.
  const RigidLine rigid(measured);
  EXPECT_EQ(rigid.line->height, LineSource(measured, pointsPerElement(measured)).make(0).height);
  // A line of `asperity surface` is read back as a profile, bit for bit.
  folder_.write("line.csv", lineCsv(line));
  Scene profile = measured;
  profile.surface = Surface{};
  profile.surface.kind = SurfaceKind::Profile;
  profile.surface.length = 0;
  profile.surface.elements = 0;
  profile.surface.file = "line.csv";
  const Line back = LineSource(profile, 1).make(0);
  ASSERT_EQ(back.nodes(), line.nodes());
  for (std::size_t i = 0; i < line.nodes(); ++i) EXPECT_NEAR(back.height[i], line.height[i], 1e-19);
  const Curve ofMeasured = computeCurve(measured), ofProfile = computeCurve(profile);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(ofProfile.points[i].mu / ofMeasured.points[i].mu, 1, 1e-6);
}

TEST_F(MeasuredScene, SlidesAlikeBothWaysWhereItIsMirrored) {
  const Scene measured = scene();
  const Line line = LineSource(measured, 4).make(0);
  const SteadySolver solver(measured);
  for (const double velocity : {1e-2, 1.0, 30.0}) {
    const double there = solver.at(prepareProfile(line, Scheme::Cubic), velocity).result.mu;
    const double back =
        solver.at(prepareProfile(mirrored(line), Scheme::Cubic), velocity).result.mu;
    EXPECT_NEAR(there / back, 1, 1e-6) << velocity;
  }
}

TEST_F(MeasuredScene, HasItsRowsAsRealizations) {
  const Scene all = scene({}, "m.txt");
  EXPECT_EQ(all.ensemble.realizations, 0);
  EXPECT_EQ(computeCurve(all).points[0].realizations, 12);
  EXPECT_EQ(computeCurve(scene({"ensemble.realizations=4"}, "m.txt")).points[0].realizations, 4);
  EXPECT_EQ(computeCurve(scene({"surface.row=3"}, "m.txt")).points[0].realizations, 1);
  EXPECT_THAT(errorOf({"ensemble.realizations=13"}, "m.txt"), HasSubstr("more than the 12 rows"));
  EXPECT_THAT(errorOf({"ensemble.realizations=2"}), HasSubstr("more than the single profile"));
  // No row is counted twice: neither of all rows nor of those that the scene uses.
  for (const auto& [values, rows] : std::vector<std::pair<std::vector<std::string>, std::int64_t>>{
           {{}, 12},
           {{"ensemble.realizations=4"}, 4},
           {{"ensemble.realizations=1"}, 1},
           {{"accuracy.target_relative_error=0.01"}, 12}}) {
    const LineSource source(scene(values, "m.txt"), 1);
    EXPECT_NO_THROW(source.requireLines(rows, "--lines"));
    EXPECT_NO_THROW(source.requireRealization(rows - 1, "--realization"));
    EXPECT_THROW(source.requireLines(rows + 1, "--lines"), InputError);
    EXPECT_THROW(source.requireRealization(rows, "--realization"), InputError);
    EXPECT_THROW(source.requireRealization(-1, "--realization"), InputError);
  }
  const LineSource one(scene({"surface.row=3"}, "m.txt"), 1);
  EXPECT_NO_THROW(one.requireRealization(0, "--realization"));
  EXPECT_THROW(one.requireRealization(1, "--realization"), InputError);
  EXPECT_THROW(one.requireLines(2, "--lines"), InputError);
  EXPECT_NO_THROW(LineSource(Scene{}, 1).requireRealization(1000000, "--realization"));
  EXPECT_THAT(errorOf({"surface.direction=along_y"}), HasSubstr("needs a topography"));
  // Where the distance of the rows is not known, each is a profile of its own.
  std::string text = matrixText(12, 64);
  const std::size_t ofRows = text.find("# Height"), values = text.find("# Value units");
  folder_.write("rows.txt", text.erase(ofRows, values - ofRows));
  const std::size_t first = text.find('\n', ofRows) + 1;
  folder_.write("less.txt", text.erase(first, text.find('\n', first) + 1 - first));
  EXPECT_THAT(errorOf({"surface.direction=along_y"}, "rows.txt"),
              HasSubstr("needs their distance"));
  const std::string equivalent = "surface.line=isotropic_equivalent";
  EXPECT_EQ(LineSource(scene({equivalent, "surface.row=3"}, "rows.txt"), 1).make(0).height,
            LineSource(scene({equivalent, "surface.row=2"}, "less.txt"), 1).make(0).height);
  EXPECT_EQ(LineSource(scene({"surface.direction=along_y"}, "m.txt"), 1).measured()->rows(), 64);
  const Line row = LineSource(scene({"surface.row=3"}, "m.txt"), 1).make(0);
  EXPECT_EQ(row.height, LineSource(all, 1).make(2).height);
}

TEST_F(MeasuredScene, MeansAForceByItsNominalPressure) {
  const Scene pressed =
      scene({"load.kind=pressure", "load.nominal_pressure=2e5", "load.width=1e-4"});
  const double force = 2e5 * 8e-3 * 1e-4;
  Scene forced = scene();
  forced.load.normalForce = force;
  const Curve a = computeCurve(pressed), b = computeCurve(forced);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(a.points[i].mu / b.points[i].mu, 1, 1e-9);
    EXPECT_NEAR(a.points[i].normalForce / force, 1, 1e-9);
    EXPECT_NEAR(a.points[i].meanPressure * a.points[i].contactFraction, 2e5, 1e-3);
  }
  EXPECT_THAT(curveCsv(a.points), HasSubstr(",normal_force,nominal_pressure,mean_pressure"));
  EXPECT_THAT(curveCsv(b.points), testing::Not(HasSubstr("nominal_pressure")));
  const Scene square = scene({"load.kind=pressure", "load.nominal_pressure=2e5"});
  EXPECT_NEAR(computeCurve(square).points[0].normalForce, 2e5 * 64e-6, 1e-6);
  EXPECT_NEAR(explain(square, 1).normalForce, 2e5 * 64e-6, 1e-6);
}

TEST_F(MeasuredScene, IsPredictedAndReachesATarget) {
  const Prediction prediction = predictCurve(scene({}, "m.txt"), 1);
  EXPECT_EQ(prediction.lines, 12);
  EXPECT_GT(prediction.seconds, 0);
  const Curve one = computeCurve(scene({"accuracy.target_relative_error=0.01"}));
  EXPECT_TRUE(one.isTargetMet);
  const Curve plain = computeCurve(scene());
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(one.points[i].mu / plain.points[i].mu, 1, 0.02);
  EXPECT_TRUE(computeCurve(scene({"accuracy.target_relative_error=0.1"}, "m.txt")).isTargetMet);
}

/// Rows of white heights, each of which differs from the one before by a factor of correlation.
std::string alikeRowsText(int rows, int columns, double correlation) {
  std::string text = "# Channel: Height\n# Width: " + std::to_string(columns) +
                     " \u00B5m\n# Height: " + std::to_string(rows) + " \u00B5m\n# Value units: m\n";
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  std::vector<double> heights(static_cast<std::size_t>(columns));
  for (double& height : heights) height = normal(random);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      double& height = heights[static_cast<std::size_t>(column)];
      text += std::to_string(10 * height) + "e-9" + (column + 1 < columns ? "\t" : "\n");
      height = correlation * height + std::sqrt(1 - correlation * correlation) * normal(random);
    }
  return text;
}

TEST_F(MeasuredScene, StatesTheErrorOfRowsThatAreAlike) {
  folder_.write("independent.txt", alikeRowsText(60, 64, 0));
  folder_.write("alike.txt", alikeRowsText(60, 64, 0.97));
  for (const bool isAlike : {false, true}) {
    const std::string file = isAlike ? "alike.txt" : "independent.txt";
    std::vector<std::vector<double>> mu;
    CurveOptions options;
    options.eachLine = [&](std::int64_t, std::span<const SteadyResult> row) {
      mu.resize(row.size());
      for (std::size_t i = 0; i < row.size(); ++i) mu[i].push_back(row[i].mu);
    };
    const Curve curve = computeCurve(scene({"accuracy.oversampling=2"}, file), options);
    ASSERT_EQ(mu.size(), curve.points.size());
    double ratio = 0;
    for (std::size_t i = 0; i < mu.size(); ++i) {
      RunningMean usual;
      for (const double value : mu[i]) usual.add(value);
      EXPECT_EQ(curve.points[i].muStandardError, errorOfCorrelatedMean(mu[i]).standardError);
      ratio +=
          curve.points[i].muStandardError / usual.standardError() / static_cast<double>(mu.size());
    }
    EXPECT_EQ(ratio > 1.5, isAlike) << ratio;
    EXPECT_EQ(curve.points[0].notes.has(Note::FewIndependentRows), isAlike);
    // More rows of the same surface are no new ones.
    const Curve twice =
        computeCurve(scene({"accuracy.oversampling=2", "ensemble.realizations=120"}, file));
    EXPECT_EQ(twice.points[0].muStandardError, curve.points[0].muStandardError);
  }
}

/// The pilot of a prediction slides few rows, but at least two pairs of neighbours: what it
/// predicts is the error of the mean over all rows, with a target or without.
TEST_F(MeasuredScene, PredictsTheErrorOfAllRows) {
  folder_.write("independent.txt", alikeRowsText(300, 256, 0));
  folder_.write("alike.txt", alikeRowsText(300, 256, 0.97));
  std::vector<Arm> arms(24);
  for (std::size_t i = 0; i < arms.size(); ++i)
    arms[i] = {1e6, std::pow(10.0, -1 - 0.2 * static_cast<double>(i))};
  for (const std::string file : {"independent.txt", "alike.txt"}) {
    Scene rough = scene({"accuracy.oversampling=1"}, file);
    rough.elastomer.rheology = Rheology::Prony;
    rough.elastomer.arms = arms;
    EXPECT_GE(planPilot(rough, 1).lines, 4);
    double squares = 0;
    const Curve curve = computeCurve(rough);
    for (const CurvePoint& point : curve.points)
      squares += std::pow(point.muStandardError / point.mu, 2);
    const double found = std::sqrt(squares / static_cast<double>(curve.points.size()));
    EXPECT_NEAR(std::log(predictCurve(rough, 1).error.standardError / found), 0, std::log(3.0))
        << file;
    rough.accuracy.targetRelativeError = 0.1 * found;
    const TargetPlan plan = planTarget(rough);
    EXPECT_NEAR(std::log(plan.standardError / found), 0, std::log(2.0)) << file;
    EXPECT_GT(plan.secondsOfRows, 0);
  }
}

/// A target is met where the rows of the surface allow it, even if they leave little of it for the
/// lines drawn; below, the surface is named as the reason.
TEST_F(MeasuredScene, ATargetIsMetDownToTheErrorOfTheRows) {
  Scene rows = scene({"accuracy.target_relative_error=0.5"}, "m.txt");
  const double least = computeCurve(rows).errorOfRows;
  ASSERT_GT(least, 0.001);
  rows.accuracy.targetRelativeError = 1.06 * least;
  EXPECT_TRUE(computeCurve(rows).isTargetMet);
  rows.accuracy.targetRelativeError = 0.9 * least;
  const Curve missed = computeCurve(rows);
  EXPECT_FALSE(missed.isTargetMet);
  EXPECT_EQ(missed.errorOfRows, least);
  EXPECT_THAT(missedTarget(missed).value_or("").english(),
              HasSubstr("a larger piece of the surface"));
}

TEST_F(MeasuredScene, SaysWhatTheUserMustKnow) {
  const auto notes = [&](const std::vector<std::string>& settings) {
    return lineNotes(LineSource(scene(settings), 1));
  };
  EXPECT_TRUE(notes({}).empty());
  EXPECT_THAT(notes({"surface.seam=periodic", "surface.form=none"}).list(),
              ElementsAre(Note::SeamJump));
  EXPECT_THAT(notes({"surface.height_unit=mm"}).list(), ElementsAre(Note::SlopeAbove));
  const Curve curve = computeCurve(scene({"surface.seam=periodic", "surface.form=none"}));
  for (const CurvePoint& point : curve.points)
    EXPECT_THAT(pointNotes(point), HasSubstr("seam_jump"));
  EXPECT_THAT(curveCsv(curve.points), HasSubstr(",notes\n"));
}

TEST_F(MeasuredScene, IsWrittenAndReadBackWithAllItsKeys) {
  const Scene full =
      scene({"surface.seam=blend", "surface.blend_length=1e-4", "surface.form=parabola",
             "surface.short_wave_cut=3e-5", "surface.line=isotropic_equivalent",
             "surface.contact_side=valleys", "surface.height_unit=nm"});
  const std::string text = writeScene(full);
  EXPECT_EQ(readScene(text, "t", folder_.path()), full);
  EXPECT_THAT(text, HasSubstr("\"blend_length\": 0.0001"));
  EXPECT_THAT(text, testing::Not(HasSubstr("hurst")));
  EXPECT_THAT(text, testing::Not(HasSubstr("seed")));
  EXPECT_THAT(writeScene(Scene{}), testing::Not(HasSubstr("seam")));
  // A kind of before takes the file's choices away, and only what has a meaning may be said.
  EXPECT_EQ(readScene(text, "t", folder_.path(), {"surface.kind=sine"}).surface.processing.seam,
            Seam::Mirror);
  EXPECT_THROW(readScene(R"({"surface": {"kind": "sine", "seam": "blend"}})", "t"), InputError);
  EXPECT_THROW(readScene(R"({"surface": {"blend_length": 1}})", "t"), InputError);
  EXPECT_THROW(
      readScene(R"({"surface": {"kind": "measured", "file": "p.txt", "blend_length": 1}})", "t"),
      InputError);
  EXPECT_THROW(readScene(R"({"ensemble": {"realizations": 0}})", "t"), InputError);
  EXPECT_THROW(readScene(R"({"surface": {"kind": "spectrum", "file": "s.csv"}})", "t"), InputError);
}

TEST_F(MeasuredScene, KeepsTheDigestOfItsFileAndRefusesAnotherContent) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  const std::string answer = provenance("curve", scene()).dump();
  EXPECT_THAT(answer, HasSubstr(sha256OfFile(folder_ / "p.txt")));
  EXPECT_EQ(findScene(answer, "a.json", folder_.path()).scene, scene());
  folder_.write("p.txt", profileText(2));
  try {
    findScene(answer, "a.json", folder_.path());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a.json: surface.file: p.txt: it is another file now"));
  }
}

TEST_F(MeasuredScene, OfASpectrumHasItsHeight) {
  const Scene spectral = readScene(
      R"({"surface": {"kind": "spectrum", "file": "s.csv", "spectrum_kind": "c1_two_sided"}})", "t",
      folder_.path());
  const LineSource source(spectral, 1);
  EXPECT_NEAR(source.length(), 2 * std::numbers::pi / 1e3, 1e-12);
  // Power laws q^-1 and q^-2 between the rows: 2 (1e-14 ln 10 + 1e-10 (1e-4 - 1e-5)).
  const double square = 2 * (1e-14 * std::log(10) + 1e-10 * 9e-5);
  EXPECT_NEAR(source.statistics().rmsHeight / std::sqrt(square), 1, 0.01);
  EXPECT_NE(source.make(0).height, source.make(1).height);
  EXPECT_EQ(source.lines(), 200);
  EXPECT_EQ(provenance("curve", spectral)["seed"], 1);
}

/// <h^2> = 2 sum C dq and <z'^2> = 2 sum q^2 C dq of what the program writes itself.
TEST_F(MeasuredScene, OfASpectrumThatWasWrittenHasItsHeightAndSlope) {
  std::string tilted = "x [m],z [m]\n";
  for (int i = 0; i < 500; ++i)
    tilted += fmt::format("{},{}\n", 2e-6 * i,
                          1e-6 * std::sin(i * 0.05) + 2e-7 * std::sin(0.9 * i + 1) + 1e-9 * i);
  folder_.write("line.csv", tilted);
  for (const char* surface :
       {R"("kind": "measured", "file": "line.csv")",
        R"("kind": "self_affine", "length": 1e-3, "elements": 400, "rms_height": 2e-6)",
        R"("kind": "self_affine", "length": 1e-3, "elements": 16, "rms_height": 2e-6)"}) {
    const Scene first =
        readScene(fmt::format(R"({{"surface": {{{}}}}})", surface), "t", folder_.path());
    const LineSource written(first, 1);
    std::string table = "wave_number,power_spectral_density\n";
    for (const auto& row : spectrumTable(written).rows)
      table += fmt::format("{},{}\n", std::get<double>(row[0]), std::get<double>(row[1]));
    folder_.write("own.csv", table);
    const Scene second = readScene(
        R"({"surface": {"kind": "spectrum", "file": "own.csv", "spectrum_kind": "c1_two_sided"}})",
        "t", folder_.path());
    const LineSource read(second, 1);
    EXPECT_NEAR(read.length() / written.length(), 1, 1e-12) << surface;
    EXPECT_NEAR(read.statistics().rmsHeight / written.statistics().rmsHeight, 1, 1e-9) << surface;
    EXPECT_NEAR(read.statistics().rmsSlope / written.statistics().rmsSlope, 1, 1e-9) << surface;
    EXPECT_THAT(sentences(read.spectrumFacts()).english(), HasSubstr("periodogram"));
  }
}

/// Waves of the line outside of the table's band, and of the table outside of the line's, are said.
TEST_F(MeasuredScene, OfASpectrumSaysWhereItsBandEnds) {
  folder_.write("band.csv", "wavelength (um),C1 (um^2*mm)\n1000,1e-4\n100,1e-5\n10,1e-7\n");
  const auto facts = [&](const char* size) {
    const Scene scene =
        readScene(fmt::format(R"({{"surface": {{"kind": "spectrum", "file": "band.csv",
                        "spectrum_kind": "c1_two_sided"{}}}}})",
                              size),
                  "t", folder_.path());
    return sentences(LineSource(scene, 1).spectrumFacts()).english();
  };
  EXPECT_THAT(facts(""), HasSubstr("wavelengths are column 1 'wavelength' (um)"));
  EXPECT_THAT(facts(""), HasSubstr("per spatial frequency"));
  EXPECT_THAT(facts(""), Not(HasSubstr("the spectrum ends")));
  EXPECT_THAT(facts(""), Not(HasSubstr("the spectrum has waves")));
  const std::string wide = facts(R"(, "length": 0.01, "elements": 20000)");
  EXPECT_THAT(wide, HasSubstr("the spectrum ends at waves of 1 mm: longer ones"));
  EXPECT_THAT(wide, HasSubstr("the spectrum ends at waves of 10 \u00B5m: shorter ones, down to 1"));
  const std::string narrow = facts(R"(, "length": 5e-4, "elements": 20)");
  EXPECT_THAT(narrow, HasSubstr("the spectrum has waves up to 1 mm"));
  EXPECT_THAT(narrow,
              HasSubstr("the spectrum has waves down to 10 \u00B5m: those shorter than 50"));
}

TEST_F(MeasuredScene, WithALongWaveCutBeyondTheProfileSaysSo) {
  const char* words = "is longer than the profile of 4 mm";
  EXPECT_TRUE(says({"surface.long_wave_cut=5e-3"}, words));
  EXPECT_FALSE(says({"surface.long_wave_cut=8e-4"}, words));
}

TEST_F(MeasuredScene, SaysThatOneProfileCannotShowIsotropy) {
  const char* words = "one profile cannot show it";
  EXPECT_TRUE(says({"surface.line=isotropic_equivalent"}, words));
  EXPECT_FALSE(says({}, words));
}

/// The cut-off that the sentence names removes what the steps add.
TEST_F(MeasuredScene, SaysThatStepsOfTheHeightsAreCoarse) {
  std::string text = "x [mm]\tz [um]\n";
  for (int i = 0; i < 400; ++i)
    text +=
        fmt::format("{:.2f}\t{:.1f}\n", 0.01 * i, std::sin(0.031 * i) + 0.4 * std::sin(0.2 * i));
  folder_.write("coarse.txt", text);
  const char* words = "levels, ";
  EXPECT_TRUE(says({}, words, "coarse.txt"));
  EXPECT_FALSE(says({}, words));
  const Scene coarse = scene({}, "coarse.txt");
  const ReliableBand band = measuredSummary(coarse, LineSource(coarse, 1)).band;
  const std::string cut =
      fmt::format("surface.short_wave_cut={:.3g}", 2 * std::numbers::pi / band.to);
  EXPECT_FALSE(says({cut}, words, "coarse.txt"));
}

/// Rows other than the first may have such steps, too: in tables and in the summary.
TEST_F(MeasuredScene, SaysThatStepsOfOtherRowsAreCoarse) {
  constexpr int kRows = 3;
  const auto write = [&](const std::string& name, int firstCoarse) {
    std::string text = "# Width: 400 \u00B5m\n# Height: 3 \u00B5m\n# Value units: \u00B5m\n";
    for (int row = 0; row < kRows; ++row)
      for (int i = 0; i < 400; ++i) {
        const double z = std::sin(0.031 * i + row) + 0.4 * std::sin(0.2 * i);
        text += fmt::format("{:.{}f}{}", 0.1 * z, row < firstCoarse ? 6 : 2, i < 399 ? "\t" : "\n");
      }
    folder_.write(name, text);
  };
  write("fine.txt", kRows);
  write("coarse.txt", 1);
  const auto notes = [&](const std::vector<std::string>& settings, const std::string& file) {
    return lineNotes(LineSource(scene(settings, file), 1));
  };
  EXPECT_FALSE(notes({}, "fine.txt").has(Note::CoarseHeights));
  EXPECT_TRUE(notes({}, "coarse.txt").has(Note::CoarseHeights));
  EXPECT_FALSE(notes({"surface.short_wave_cut=1e-4"}, "coarse.txt").has(Note::CoarseHeights));
  EXPECT_FALSE(notes({"surface.row=1"}, "coarse.txt").has(Note::CoarseHeights));
  EXPECT_TRUE(says({}, "of 3 rows examined, 2 have heights in steps", "coarse.txt"));
  EXPECT_FALSE(says({}, "rows examined", "fine.txt"));
  for (const CurvePoint& point : computeCurve(scene({}, "coarse.txt")).points)
    EXPECT_THAT(pointNotes(point), HasSubstr("coarse_heights"));
}

TEST_F(MeasuredScene, SaysThatAProfileIsPartOfACircle) {
  std::string text = "x [mm]\tz [mm]\n";
  for (int i = 0; i < 400; ++i) {
    const double x = 0.01 * (i - 200);
    text += fmt::format("{:.2f}\t{:.6f}\n", x, std::sqrt(16 - x * x) + 1e-4 * std::sin(0.2 * i));
  }
  folder_.write("roller.txt", text);
  const auto notes = [&](const std::vector<std::string>& settings, const std::string& file) {
    return lineNotes(LineSource(scene(settings, file), 1));
  };
  EXPECT_TRUE(notes({"surface.form=parabola"}, "roller.txt").has(Note::RoundForm));
  EXPECT_TRUE(says({}, "part of a circle with a radius of 4 mm", "roller.txt"));
  EXPECT_FALSE(notes({"surface.long_wave_cut=8e-4"}, "roller.txt").has(Note::RoundForm));
  EXPECT_FALSE(notes({}, "p.txt").has(Note::RoundForm));
}

/// Neither a row that was measured beside the roller nor points far above it hide the form.
TEST_F(MeasuredScene, ADamagedRowAndOutliersHideNoCircle) {
  std::string profile = "x [mm]\tz [mm]\n", rows;
  for (int row = 0; row < 4; ++row) {
    for (int i = 0; i < 400; ++i) {
      const double x = 0.01 * (i - 200);
      const double rough = 1e-4 * std::sin(0.2 * i), round = std::sqrt(16 - x * x) + rough;
      rows += fmt::format("{}{:.6f}", i > 0 ? "\t" : "", row == 0 ? rough : round);
      if (row == 0) profile += fmt::format("{:.2f}\t{:.6f}\n", x, i % 97 == 50 ? 8 : round);
    }
    rows += "\n";
  }
  folder_.write("spiky.txt", profile);
  folder_.write("rows.txt", rows);
  const auto isRound = [&](const std::vector<std::string>& settings, const std::string& file) {
    return lineNotes(LineSource(scene(settings, file), 1)).has(Note::RoundForm);
  };
  EXPECT_FALSE(isRound({"surface.form=parabola"}, "spiky.txt"));
  EXPECT_TRUE(isRound({"surface.form=parabola", "surface.outliers=6"}, "spiky.txt"));
  const std::vector<std::string> matrix{"surface.format=matrix", "surface.height_unit=mm",
                                        "surface.point_spacing=1e-5"};
  EXPECT_TRUE(isRound(matrix, "rows.txt"));
}

TEST_F(MeasuredScene, IsSummedUpInItsOwnOrientation) {
  const Scene measured = scene();
  const LineSource source(measured, 1);
  const MeasuredSummary summary = measuredSummary(measured, source);
  EXPECT_EQ(summary.columns, 400);
  EXPECT_NEAR(summary.spacing, 1e-5, 1e-11);
  EXPECT_GT(summary.raw.pq, 1.05 * summary.used.pq);  // the tilt
  EXPECT_NEAR(summary.used.pdq / source.statistics().rmsSlope, 1, 0.05);
  const Line line = source.make(0);
  double mean = 0;
  for (const double z : summary.profile.used) mean += z / 400;
  for (std::size_t i = 0; i < 400; ++i)
    EXPECT_NEAR(line.height[i], -(summary.profile.used[i] - mean), 2e-9);
}

}  // namespace
}  // namespace asperity
