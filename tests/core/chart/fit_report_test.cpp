// The chart of a fit.
#include "core/chart/fit_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/chart/curve_diagram.h"
#include "core/chart/curve_set.h"
#include "core/friction/ensemble.h"
#include "tests/core/small_scene.h"

namespace asperity {
namespace {

/// The band is around the curve with local friction, which is what was measured. The theories are
/// of the deformation alone and are drawn beside both, as in the chart of the same scene.
TEST(FitSheet, WithLocalFrictionHasTheTheoriesAndTheBandOfTheTotal) {
  Scene scene = sceneOfSize(500, 17, 3);
  scene.interface.frictionCoefficient = 0.3;
  scene.comparison.theory = {Theory::Eq11, Theory::PerssonHalfSpace};
  CurveSet set;
  set.present = {{}, scene, frictionCurve(scene).points};
  const std::vector<CurvePoint>& points = set.present.points;
  FrictionData table{"a table", {}};
  for (const CurvePoint& point : {points.front(), points.back()})
    table.points.push_back({point.velocity, totalMu(point)});
  addComparisons(set, {table});
  Fit fit;
  fit.scene = scene;
  fit.computed = set.measured.front().computed;
  fit.bandErrors = {0.1, 0.1};

  const DiagramSheet sheet = fitSheet(fit, set), plain = curveSheet(set);
  const std::vector<DiagramSeries>& series = sheet.diagrams.front().series;
  for (const DiagramSeries& other : plain.diagrams.front().series)
    EXPECT_TRUE(std::ranges::any_of(series, [&](const DiagramSeries& one) {
      return one.id == other.id && one.name == other.name;
    })) << other.name.english();
  for (const Theory theory : scene.comparison.theory)
    EXPECT_TRUE(std::ranges::any_of(series, [&](const DiagramSeries& one) {
      return one.name.english() == theoryEntry(theory).name;
    })) << theoryEntry(theory).name;
  EXPECT_THAT(sheet.note.english(), testing::Not(testing::HasSubstr("has no line")));

  const DiagramSeries& band = series.front();
  ASSERT_TRUE(band.isBand);
  ASSERT_EQ(band.points.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(band.points[i].y, totalMu(points[i]));
}

/// A nominal pressure is computed as a force by the width of the load: the table has that force.
TEST(FitReport, ItsTableHasTheForceOfANominalPressure) {
  FrictionData table{"a table", {{0.1, 0.01}, {0.1, 0.02}}};
  table.points[0].nominalPressure = 2e4;
  table.points[1].normalForce = 3;
  Fit fit;
  fit.computed.resize(2);
  fit.computed[0].normalForce = 8;
  fit.computed[0].mu = fit.computed[1].mu = 0.01;
  fit.computedErrors = fit.bandErrors = {0, 0};
  EXPECT_THAT(fitCsv(fit, {&table, 1}), testing::AllOf(testing::HasSubstr("\n0.1,8,20000,"),
                                                       testing::HasSubstr("\n0.1,3,,")));
}

/// The flanks of a profile that are far steeper than its bottom are cut, those of a parabola are
/// not.
TEST(FitReport, TheBottomOfAProfileIsSeen) {
  Fit fit;
  fit.parameters.resize(1);
  fit.parameters[0].key = "surface.rms_height";
  fit.profiles = {{"surface.rms_height", {1e-7, 2e-7, 3e-7, 4e-7, 5e-7}, {1300, 1, 0, 2, 6000}}};
  EXPECT_EQ(profileSheet(fit).diagrams.at(0).y.to, 10);
  fit.profiles[0].chiSquared = {16, 4, 0, 4, 16};
  const DiagramAxis parabola = profileSheet(fit).diagrams.at(0).y;
  EXPECT_EQ(parabola.from, parabola.to);
}

/// In the notation of the window.
TEST(FitReport, NamesTheSumOfSquaresByItsSign) {
  Fit fit;
  fit.chiSquared = 12.5;
  const auto hasLine = [&fit](std::string_view text) {
    return std::ranges::any_of(describeFit(fit),
                               [text](const Message& line) { return line.english() == text; });
  };
  fit.degreesOfFreedom = 11;
  EXPECT_TRUE(hasLine("\u03C7\u00B2 = 12.5 for 11 degrees of freedom"));
  fit.degreesOfFreedom = 1;
  EXPECT_TRUE(hasLine("\u03C7\u00B2 = 12.5 for one degree of freedom"));
}

}  // namespace
}  // namespace asperity
