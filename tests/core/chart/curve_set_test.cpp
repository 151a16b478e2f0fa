#include "core/chart/curve_set.h"

#include <gmock/gmock.h>

#include <cmath>
#include <sstream>
#include <tuple>

#include "core/material/temperature_shift.h"

namespace asperity {
namespace {

CurvePoint point(double velocity, double mu) {
  CurvePoint made{.velocity = velocity,
                  .mu = mu,
                  .muStandardError = mu / 8,
                  .normalizedMu = 2 * mu,
                  .dimensionlessVelocity = 4 * velocity,
                  .realizations = 3};
  return made;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(CurveSet, FactorsLeadToTheAxes) {
  const std::vector<CurvePoint> points{point(1, 0), point(2, 0.5)};
  const AxesFactors plain = axesFactors(points, CurveAxes::Physical);
  EXPECT_EQ(plain.velocity, 1);
  EXPECT_EQ(plain.friction, 1);
  const AxesFactors factors = axesFactors(points, CurveAxes::Dimensionless);
  EXPECT_EQ(factors.velocity, 4);
  EXPECT_EQ(factors.friction, 2);
  EXPECT_TRUE(std::isnan(axesFactors({}, CurveAxes::Dimensionless).velocity));
}

constexpr const char* kColumnsOfACurve =
    "series,velocity,mu,mu_standard_error,mu_law,contact_fraction,rms_slope_contact,indentation,"
    "normalized_mu,dimensionless_velocity,dimensionless_force,realizations";

/// Series are called what they are; no column of a curve is missing.
TEST(CurveSet, TheTableHasOneRowForEachPointOfEachSeries) {
  CurveSet set;
  set.present = {"", {}, {point(1, 0.5), point(2, 1)}};
  set.present.scene.title = "Soft, slow";
  set.present.points[0].muLaw = 0.25;
  set.present.points[1].realizations = 0;  // not known yet
  set.pinned = {{"G = 20 MPa, h = 5 \u00B5m", {}, {point(1, 2)}}};
  EXPECT_THAT(linesOf(curveSetCsv(set)),
              testing::ElementsAre(kColumnsOfACurve, "\"Soft, slow\",1,0.5,0.0625,0.25,0,,0,1,4,,3",
                                   "Eq. (11),1,0.25,,,,,,0.5,4,,",
                                   "\"G = 20 MPa, h = 5 \u00B5m\",1,2,0.25,,0,,0,4,4,,3"));
}

/// A further column is there where one of the curves needs it.
TEST(CurveSet, FurtherColumnsAreThoseOfAllCurves) {
  CurveSet set;
  set.present = {"", {}, {point(1, 0.5)}};
  set.pinned = {{"local friction = 0.1", {}, {point(1, 2)}}};
  set.pinned[0].points[0].muInterface = 0.125;
  const std::vector<std::string> lines = linesOf(curveSetCsv(set));
  EXPECT_THAT(lines[0], testing::StartsWith(kColumnsOfACurve));
  EXPECT_THAT(lines[0], testing::EndsWith(",realizations,mu_interface,mu_total"));
  EXPECT_THAT(lines[1], testing::EndsWith(",3,,"));
  EXPECT_THAT(lines.back(), testing::EndsWith(",3,0.125,2.125"));
}

/// `velocity` is that at which something slid; where it lies on the axis of the reduced velocity,
/// and at which temperature it slid, are columns of their own.
TEST(CurveSet, TheTableHasTheVelocityAsMeasuredAndTheReducedOne) {
  CurveSet set;
  set.present = {"", {}, {point(1, 0.5)}};
  set.present.scene.elastomer.temperature = 300;
  set.pinned = {{"warm", set.present.scene, {point(1, 2)}}};
  set.pinned[0].scene.elastomer.temperature = 350;
  for (Scene* scene : {&set.present.scene, &set.pinned[0].scene}) {
    scene->elastomer.shift.kind = ShiftKind::Table;
    scene->elastomer.shift.referenceTemperature = 300;
    scene->elastomer.shift.table = {{300, 0}, {350, -2}};
  }
  MeasuredCurve measured;
  measured.data.name = "a table";
  measured.data.points = {{2, 0.25}, {4, 0.75}};
  measured.data.points[0].temperature = 350;
  set.measured = {measured};
  placeMeasured(set);
  const std::vector<std::string> lines = linesOf(curveSetCsv(set));
  EXPECT_THAT(lines[0], testing::EndsWith(",realizations,reduced_velocity,temperature"));
  ASSERT_EQ(lines.size(), 5U);
  // Names, velocity, reduced velocity (a hundredth at 350 K) and temperature of each row.
  const std::vector<std::tuple<std::string, double, double, double>> rows{{"this scene", 1, 1, 300},
                                                                          {"a table", 2, 0.02, 350},
                                                                          {"a table", 4, 4, 300},
                                                                          {"warm", 1, 0.01, 350}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& [name, velocity, reduced, temperature] = rows[i];
    std::vector<std::string> cells;
    std::istringstream in(lines[i + 1]);
    for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    EXPECT_EQ(cells[0], name);
    EXPECT_EQ(std::stod(cells[1]), velocity);
    EXPECT_NEAR(std::stod(cells[cells.size() - 2]) / reduced, 1, 1e-12);
    EXPECT_EQ(std::stod(cells.back()), temperature);
  }
}

TEST(CurveSet, ADifferenceHasColumnsOfItsOwn) {
  CurveSet set;
  set.present = {"", {}, {point(1, 0.5)}};
  set.difference =
      CurveDifference{nullptr, {Scheme::Linear, 2, 3}, {{1, 0.75, 0.125, 0.5, 0.25}}, 6, 6};
  EXPECT_THAT(
      linesOf(curveSetCsv(set)),
      testing::ElementsAre(
          testing::EndsWith("realizations,relative_difference,relative_difference_standard_error"),
          "this scene,1,0.5,0.0625,,0,,0,1,4,,3,,",
          "\"linear x2, 3 lines\",1,0.75,0.125,,,,,1.5,4,,3,0.5,0.25"));
}

TEST(CurveSet, MeasuredTablesHaveOtherColoursThanWhatStandsBesideThem) {
  for (int table = 0; table < kPinColours; ++table)
    for (int other = 0; other < table; ++other)
      EXPECT_NE(measuredColour(table), measuredColour(other));
  constexpr int kPresent = 0, kMarker = 1, kNearlyBlack = 8;  // on white, as theories are
  for (int table = 0; table < 2; ++table) {
    for (const int other : {kPresent, kMarker, kNearlyBlack, kColourOfHalfSpace})
      EXPECT_NE(measuredColour(table), other);
    for (int pin = 0; pin < 3; ++pin) EXPECT_NE(measuredColour(table), pinColour(pin));
  }
}

TEST(CurveSet, PinsOfDifferentPlacesHaveDifferentColours) {
  for (int a = 0; a < kPinColours; ++a)
    for (int b = 0; b < a; ++b) EXPECT_NE(pinColour(a), pinColour(b));
  EXPECT_EQ(pinColour(kPinColours), pinColour(0));
}

}  // namespace
}  // namespace asperity
