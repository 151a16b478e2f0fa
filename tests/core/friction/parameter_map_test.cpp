// A map of friction: each cell is the point of its own curve, the identities of the model hold, and
// ranges that make no sense are refused.
#include "core/friction/parameter_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "core/base/input_error.h"
#include "core/chart/map_sheet.h"
#include "core/friction/ensemble.h"
#include "core/material/element_law.h"
#include "core/scene/columns.h"
#include "tests/core/elastomers.h"
#include "tests/core/error_from.h"
#include "tests/core/small_scene.h"

namespace asperity {
namespace {

Scene mappedScene() {
  return sceneOfSize(200, 5, 4, 0.02);
}

MapAxis side(const Scene& scene, const std::string& range) {
  return mapAxis(scene, parseRangeOption("--x", range));
}

ParameterMap mapOf(const Scene& scene, const std::string& x, const std::string& y,
                   const StateOptions& options = {}, const MapPreview& preview = {}) {
  return parameterMap(scene, side(scene, x), side(scene, y), options, preview);
}

void expectCellsOfCurves(const ParameterMap& map, double tolerance) {
  for (std::size_t j = 0; j < map.y.values.size(); ++j)
    for (std::size_t i = 0; i < map.x.values.size(); ++i) {
      const CurvePoint own = pointOfCurve(cellScene(map, i, j));
      const CurvePoint& cell = map.at(i, j);
      SCOPED_TRACE(std::to_string(i) + " " + std::to_string(j));
      EXPECT_NEAR(cell.mu, own.mu, tolerance * own.mu);
      EXPECT_NEAR(cell.indentation, own.indentation, tolerance * own.indentation);
      EXPECT_NEAR(cell.contactFraction, own.contactFraction, tolerance);
      EXPECT_NEAR(cell.muStandardError, own.muStandardError, tolerance * own.mu);
      EXPECT_EQ(cell.realizations, own.realizations);
      EXPECT_EQ(cell.velocity, own.velocity);
      EXPECT_EQ(cell.notes, own.notes);
      if (!std::isnan(own.muLaw)) {
        EXPECT_NEAR(cell.muLaw, own.muLaw, 1e-12 * own.muLaw);
      }
    }
}

/// To 1e-12; with arms to what rounding leaves of their balance (kRoundingResidual of
/// contact/arms/arm_balance.cpp, 5e-12), which depends on where the search began.
TEST(ParameterMap, EachCellIsThePointOfItsOwnCurve) {
  for (const auto& [name, elastomer] : allElastomers()) {
    SCOPED_TRACE(name);
    Scene scene = mappedScene();
    scene.elastomer = elastomer;
    expectCellsOfCurves(mapOf(scene, "sliding.velocity=1e-4:10:5", "load.normal_force=1e-3:1:4"),
                        elementLaw(elastomer).kind() == ElementKind::Arms ? 5e-12 : 1e-12);
  }
}

/// The resolution that the program chooses may differ from cell to cell.
TEST(ParameterMap, EachCellHasTheResolutionOfItsOwnCurve) {
  const Scene scene = mappedScene();
  const ParameterMap map = mapOf(scene, "load.normal_force=1e-3:1000:6", "surface.hurst=0.2:1:3");
  std::int64_t least = 100, most = 0;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 6; ++i) {
      least = std::min(least, curvePointsPerElement(cellScene(map, i, j)));
      most = std::max(most, curvePointsPerElement(cellScene(map, i, j)));
    }
  EXPECT_LT(least, most) << "the map must cover two resolutions";
  expectCellsOfCurves(map, 1e-12);
  EXPECT_TRUE(mapProvenance(map, "mu")["oversampling_used"].is_null());
}

TEST(ParameterMap, OfSurfacesLoadsAndWholeNumbers) {
  Scene scene = mappedScene();
  expectCellsOfCurves(mapOf(scene, "surface.rms_height=1e-7:1e-6:3", "surface.length=0.01:0.03:3"),
                      1e-12);
  expectCellsOfCurves(mapOf(scene, "surface.elements=50:200:3", "surface.seed=1:3:3"), 1e-12);
  scene.load.kind = LoadKind::Indentation;
  expectCellsOfCurves(mapOf(scene, "load.depth=1e-7:3e-6:4", "surface.rms_height=3e-7:1e-6:3"),
                      1e-12);
  scene.load.kind = LoadKind::Pressure;
  expectCellsOfCurves(mapOf(scene, "load.nominal_pressure=1e3:1e6:4", "load.width=1e-3:1e-2:3"),
                      1e-12);
  scene.load.kind = LoadKind::Force;
  scene.interface.frictionCoefficient = 0.1;
  expectCellsOfCurves(
      mapOf(scene, "interface.friction_coefficient=0:0.5:3:linear", "sliding.velocity=1e-3:1:3"),
      1e-12);
}

/// The separate elements jump; their balance is met to its own residual.
/// WLF's constants have no influence at the reference temperature, where the scene is, but on a map
/// over temperature.
TEST(ParameterMap, OfParametersThatMatterElsewhereOnTheMap) {
  Scene scene = mappedScene();
  scene.elastomer.shift.kind = ShiftKind::Wlf;
  scene.elastomer.temperature = scene.elastomer.shift.referenceTemperature = 300;
  const ParameterRange x = parseRangeOption("--x", "elastomer.temperature=290:310:3");
  const ParameterRange y = parseRangeOption("--y", "elastomer.shift.c1=4:12:2");
  EXPECT_THAT(errorFrom([&] { mapAxis(scene, y); }), testing::HasSubstr("changes nothing"));
  const ParameterMap map = parameterMap(scene, mapAxis(scene, x, &y), mapAxis(scene, y, &x));
  EXPECT_NE(map.at(0, 0).mu, map.at(0, 1).mu);
  EXPECT_EQ(map.at(1, 0).mu, map.at(1, 1).mu);
}

TEST(ParameterMap, OfTheSeparateElements) {
  Scene scene = mappedScene();
  scene.accuracy.scheme = Scheme::Nodal;
  expectCellsOfCurves(mapOf(scene, "sliding.velocity=1e-2:10:5", "load.normal_force=1e-2:1:3"),
                      1e-9);
}

/// z = h zeta, time in tau: friction over v and tau depends on v tau alone.
TEST(ParameterMap, OverVelocityAndTimeDependsOnTheirProduct) {
  const ParameterMap map =
      mapOf(mappedScene(), "sliding.velocity=1e-4:1:9", "elastomer.relaxation_time=1e-5:0.1:9");
  EXPECT_EQ(map.computed, 17U);
  for (std::size_t j = 1; j < 9; ++j)
    for (std::size_t i = 0; i + 1 < 9; ++i) EXPECT_EQ(map.at(i, j).mu, map.at(i + 1, j - 1).mu);
}

TEST(ParameterMap, OverForceAndModulusDependsOnTheirRatio) {
  const ParameterMap map =
      mapOf(mappedScene(), "load.normal_force=1e-3:10:9", "elastomer.shear_modulus=1e6:1e10:9");
  EXPECT_EQ(map.computed, 17U);
  for (std::size_t j = 1; j < 9; ++j)
    for (std::size_t i = 1; i < 9; ++i)
      EXPECT_NEAR(map.at(i, j).mu / map.at(i - 1, j - 1).mu, 1, 1e-12);
}

TEST(ParameterMap, AnyNumberOfThreadsGivesTheSameBytes) {
  std::string first;
  for (const int threads : {1, 2, 5}) {
    const std::string text = mapCsv(mapOf(mappedScene(), "sliding.velocity=1e-4:10:40",
                                          "load.normal_force=1e-3:1:30", {.threads = threads}),
                                    "exponent");
    if (first.empty()) first = text;
    EXPECT_EQ(text, first);
  }
}

TEST(ParameterMap, PreviewsComeFromCoarseToFine) {
  std::vector<std::pair<std::size_t, std::int64_t>> stages;
  const auto preview = [&](const ParameterMap& stage) {
    stages.emplace_back(stage.points.size(), stage.points.front().realizations);
    EXPECT_FALSE(stage.isFinal);
  };
  const ParameterMap map = mapOf(mappedScene(), "sliding.velocity=1e-4:10:20",
                                 "load.normal_force=1e-3:1:18", {}, preview);
  EXPECT_EQ(stages, (std::vector<std::pair<std::size_t, std::int64_t>>{{256, 1}, {360, 1}}));
  EXPECT_TRUE(map.isFinal);
  EXPECT_EQ(map.points.front().realizations, 4);
}

TEST(ParameterMap, StopsSoon) {
  Scene scene = sceneOfSize(5000, 5, 200);
  std::stop_source source;
  StateOptions options;
  options.stop = source.get_token();
  std::chrono::steady_clock::time_point asked;
  std::thread stopper([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    asked = std::chrono::steady_clock::now();
    source.request_stop();
  });
  const ParameterMap map =
      mapOf(scene, "sliding.velocity=1e-4:10:64", "load.normal_force=1e-3:1:64", options);
  const auto ended = std::chrono::steady_clock::now();
  stopper.join();
  EXPECT_FALSE(map.isComplete);
  EXPECT_FALSE(map.isFinal);
  // 10 ms on a quiet machine (tests/bench); here others may use the processor.
  EXPECT_LT(std::chrono::duration<double>(ended - asked).count(), 0.5);
}

/// Friction of region I is proportional to v: mu = v f(x) has the exponent 1 at any spacing, and of
/// c v^k the parabola through three logarithms is exact.
TEST(ParameterMap, TheExponentIsThatOfAPower) {
  ParameterMap map;
  map.scene = mappedScene();
  map.x = side(map.scene, "sliding.velocity=1e-3:1:7");
  map.y = side(map.scene, "load.normal_force=1e-3:1:2");
  for (const double power : {1.0, -0.37})
    for (const double v : map.x.values) {
      CurvePoint point;
      point.mu = 0.3 * std::pow(v, power);
      map.points.push_back(point);
    }
  const std::vector<double> found = mapValues(map, "exponent");
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_NEAR(found[i], 1, 1e-12);
    EXPECT_NEAR(found[7 + i], -0.37, 1e-12);
  }
  map.points[3].mu = 0;  // no logarithm, and none beside it
  EXPECT_TRUE(std::isnan(mapValues(map, "exponent")[3]));
  EXPECT_TRUE(std::isnan(mapValues(map, "exponent")[2]));
  EXPECT_NEAR(mapValues(map, "exponent")[1], 1, 1e-12);
}

TEST(ParameterMap, RefusesWhatMakesNoSense) {
  const Scene scene = mappedScene();
  const auto says = [&](const std::string& range) {
    return errorFrom([&] { side(scene, range); });
  };
  EXPECT_NE(says("load.normal_farce=1:2:3").find("load.normal_force"), std::string::npos);
  EXPECT_NE(says("surface.kind=1:2:3").find("surface.kind"), std::string::npos);
  EXPECT_NE(says("surface.slope=0.1:0.2:3").find("surface.slope"), std::string::npos);
  EXPECT_NE(says("ensemble.realizations=1:10:3").find("cannot be its axis"), std::string::npos);
  EXPECT_NE(says("sweep.points=1:10:3").find("cannot be its axis"), std::string::npos);
  EXPECT_NE(says("load.normal_force=1:2:1").find("2 to 1000"), std::string::npos);
  EXPECT_NE(says("load.normal_force=1:2:5000").find("2 to 1000"), std::string::npos);
  EXPECT_NE(says("load.normal_force=0:2:5:log").find("normal_force"), std::string::npos);
  EXPECT_NE(says("load.normal_force=1:1:5").find("only one value"), std::string::npos);
  EXPECT_NE(says("surface.elements=100:100.2:5").find("surface.elements"), std::string::npos);
  EXPECT_NE(says("surface.hurst=0:1.4:5").find("0 to 1"), std::string::npos);
  const MapAxis x = side(scene, "load.normal_force=1:2:3");
  EXPECT_NE(errorFrom([&] { parameterMap(scene, x, x); }).find("both sides"), std::string::npos);
  Scene target = scene;
  target.accuracy.targetRelativeError = 0.01;
  EXPECT_NE(errorFrom([&] {
              parameterMap(target, x, side(scene, "sliding.velocity=1:2:2"));
            }).find("accuracy.target_relative_error"),
            std::string::npos);
  EXPECT_NE(errorFrom([&] {
              parameterMap(scene, side(scene, "load.normal_force=1:2:900"),
                           side(scene, "sliding.velocity=1:2:900"));
            }).find("100000"),
            std::string::npos);
}

TEST(ParameterMap, WholeNumbersAreRoundedAndDownwardsIsDownwards) {
  const Scene scene = mappedScene();
  EXPECT_EQ(side(scene, "surface.seed=1:3:9:linear").values, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(side(scene, "surface.hurst=1:0:3").values, (std::vector<double>{1, 0.5, 0}));
  const ParameterMap down = mapOf(scene, "sliding.velocity=1:1e-3:4", "surface.hurst=0.3:0.9:2");
  const ParameterMap up = mapOf(scene, "sliding.velocity=1e-3:1:4", "surface.hurst=0.3:0.9:2");
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(down.at(i, 1).mu / up.at(3 - i, 1).mu, 1, 1e-12);
  // The picture is the same.
  const auto a = mapSheet(down, "mu").diagrams[0].field, b = mapSheet(up, "mu").diagrams[0].field;
  ASSERT_TRUE(a && b);
  for (std::size_t k = 0; k < a->values.size(); ++k)
    EXPECT_NEAR(a->values[k] / b->values[k], 1, 1e-12);
}

TEST(ParameterMap, SaysWhereAParameterDoesNothing) {
  Scene scene = mappedScene();
  scene.elastomer.rheology = Rheology::Elastic;
  const ParameterMap map = mapOf(scene, "sliding.velocity=1e-3:1:3", "load.normal_force=1e-3:1:3");
  EXPECT_TRUE(isWithoutEffect(mapOf(mappedScene(), "elastomer.relaxation_time=1e-3:1e-2:3",
                                    "surface.seed=1:2:2"),
                              false) == false);
  EXPECT_TRUE(isWithoutEffect(map, true));
}

/// Every column of the table stands in the dictionary, and two keys of the same last word have
/// their whole names.
TEST(ParameterMap, TheTableHasKnownColumns) {
  const ParameterMap map =
      mapOf(mappedScene(), "sliding.velocity=1e-3:1:3", "load.normal_force=1e-3:1:2");
  const std::string csv = mapCsv(map, "exponent");
  const std::string header = csv.substr(0, csv.find('\n'));
  EXPECT_TRUE(header.starts_with("velocity,normal_force,mu,mu_standard_error,")) << header;
  EXPECT_TRUE(header.ends_with(",exponent")) << header;
  const auto known = nlohmann::json::parse(columnsJson())["columns"];
  std::string word;
  for (std::istringstream words(header); std::getline(words, word, ',');)
    EXPECT_TRUE(std::ranges::any_of(known, [&](const auto& one) { return one["name"] == word; }))
        << word;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 7);
  // x fastest.
  EXPECT_NE(csv.find("\n0.001,0.001,"), std::string::npos);
  EXPECT_LT(csv.find("\n1,0.001,"), csv.find("\n0.001,1,"));
  const auto json = nlohmann::json::parse(mapJson(map, "mu"));
  EXPECT_EQ(json["schema"], "asperity-map/1");
  EXPECT_EQ(json["keys"][0]["key"], "sliding.velocity");
  EXPECT_EQ(json["keys"][1]["points"], 2);
  EXPECT_EQ(json["options"]["show"], "mu");
  EXPECT_EQ(json["points"].size(), 6U);
  EXPECT_EQ(json["points"][1]["normal_force"], 0.001);
}

/// Where most of a map is a plateau, it has contours there, too: at most a few, and no closer than
/// a hundredth of the value.
TEST(ParameterMap, APlateauHasContours) {
  ParameterMap map =
      mapOf(mappedScene(), "sliding.velocity=1e-4:1e4:41", "load.normal_force=1e-3:1:5");
  const auto fill = [&](auto&& mu, double noise = 1e-4) {
    for (std::size_t i = 0; i < map.points.size(); ++i) {
      map.points[i].mu = mu(static_cast<double>(i % 41) / 40);
      map.points[i].muStandardError = noise * map.points[i].mu;
    }
  };
  const auto levelsOn = [&](double from, double to) {
    std::vector<double> levels;
    const DiagramSheet sheet = mapSheet(map, "mu");
    for (const DiagramContour& contour : sheet.diagrams[0].field->contours)
      if (contour.value > from && contour.value < to) levels.push_back(contour.value);
    return levels;
  };
  // A fifth of the map rises from 0, the rest slowly from 0.09 to 0.1.
  fill([](double part) { return part < 0.2 ? 0.45 * part : 0.09 + 0.0125 * (part - 0.2); });
  const std::vector<double> plateau = levelsOn(0.09, 0.1);
  EXPECT_GE(plateau.size(), 3U);
  EXPECT_LE(plateau.size(), 10U);
  for (std::size_t i = 1; i < plateau.size(); ++i) EXPECT_GE(plateau[i] - plateau[i - 1], 0.00099);
  EXPECT_LE(levelsOn(0, 0.09).size(), 9U);
  // Few lines have noise that would bend them.
  fill([](double part) { return part < 0.2 ? 0.45 * part : 0.09 + 0.0125 * (part - 0.2); }, 0.02);
  EXPECT_LE(levelsOn(0.09, 0.1).size(), 2U);
  // A plateau that is flat but for the noise of the lines gets none.
  fill([](double part) { return part < 0.2 ? 0.45 * part : 0.09 + 1e-5 * std::sin(99 * part); });
  EXPECT_LE(levelsOn(0.0899, 0.1).size(), 1U);
}

/// Borders are those that the curve of each row shows.
TEST(ParameterMap, TheSheetHasTheRegionsOfItsCurves) {
  Scene scene = sceneOfSize(1000, 5, 2);
  const ParameterMap map =
      mapOf(scene, "sliding.velocity=1e-5:1e3:33", "load.normal_force=1e-3:1:5");
  const DiagramSheet sheet = mapSheet(map, "mu");
  EXPECT_EQ(sheet.title.english(), "Friction over velocity and normal force");
  const Diagram& diagram = sheet.diagrams.at(0);
  ASSERT_TRUE(diagram.field && diagram.marker);
  EXPECT_FALSE(diagram.field->contours.empty());
  EXPECT_TRUE(diagram.marker->isCross);
  EXPECT_GE(diagram.series.size(), 2U);
  double before = 0;
  for (const DiagramSeries& border : diagram.series) {
    const auto& first = *std::ranges::find_if(
        border.points, [](const DiagramPoint& point) { return std::isfinite(point.x); });
    EXPECT_GT(first.x, before);  // in the order of regions
    before = first.x;
  }
  // Without the velocity, few contacts are found from each cell's own state.
  const DiagramSheet other =
      mapSheet(mapOf(scene, "elastomer.relaxation_time=1e-5:1e3:17", "load.normal_force=1e-3:1:5"),
               "contact_fraction");
  EXPECT_EQ(other.title.english(), "Map over relaxation time and normal force: contact fraction");
  ASSERT_EQ(other.diagrams.at(0).series.size(), 1U);
  for (const DiagramPoint& point : other.diagrams[0].series[0].points) {
    // F_N / (4 eta v) = 0.1 h, eta = G tau
    const double climbed =
        point.y / (4 * scene.elastomer.shearModulus * point.x * scene.sliding.velocity);
    EXPECT_NEAR(climbed / (0.1 * scene.surface.rmsHeight), 1, 1e-6);
  }
}

}  // namespace
}  // namespace asperity
