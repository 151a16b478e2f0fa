#include "core/chart/contact_fraction_diagram.h"

#include <gmock/gmock.h>

#include <cmath>

#include "core/chart/comparison.h"
#include "core/chart/curve_diagram.h"
#include "core/friction/curve_file.h"
#include "core/friction/ensemble.h"
#include "tests/core/small_scene.h"

namespace asperity {
namespace {

using testing::HasSubstr;

/// A rough line on Kelvin elements with three theories beside it.
CurveSet setWithTheories() {
  Scene scene = sceneOfSize(1000, 9, 20);
  scene.surface.rollOffWavelength = scene.surface.length / 40;
  scene.load.normalForce = 0.5;
  scene.comparison.theory = {Theory::Eq11, Theory::GaussianFoundation, Theory::CompleteContact,
                             Theory::PerssonHalfSpace};
  CurveSet set;
  set.present = {{}, scene, frictionCurve(scene).points};
  addComparisons(set, {});
  return set;
}

const DiagramSeries* seriesNamed(const Diagram& diagram, const std::string& name) {
  for (const DiagramSeries& series : diagram.series)
    if (series.name.english() == name) return &series;
  return nullptr;
}

/// The fraction of each point of the curve, and the Gaussian form beside it, which at low velocity
/// lies on it. Eq. (11) says nothing of contact.
TEST(ContactFractionDiagram, TheGaussianFormLiesOnTheCurveAtLowVelocity) {
  const CurveSet set = setWithTheories();
  const DiagramSheet sheet = contactFractionSheet(set);
  const Diagram& diagram = sheet.diagrams.front();
  EXPECT_EQ(diagram.y.title.english(), "contact fraction");
  const DiagramSeries* mean = seriesNamed(diagram, "mean of 20 lines");
  ASSERT_TRUE(mean);
  ASSERT_EQ(mean->points.size(), set.present.points.size());
  for (std::size_t i = 0; i < mean->points.size(); ++i) {
    EXPECT_EQ(mean->points[i].x, set.present.points[i].velocity);
    EXPECT_EQ(mean->points[i].y, set.present.points[i].contactFraction);
  }
  const DiagramSeries* gauss = seriesNamed(diagram, entryOf(Theory::GaussianFoundation).name);
  ASSERT_TRUE(gauss);
  EXPECT_NEAR(gauss->points.front().y / mean->points.front().y, 1, 0.1);
  EXPECT_TRUE(seriesNamed(diagram, entryOf(Theory::PerssonHalfSpace).name));
  EXPECT_FALSE(seriesNamed(diagram, entryOf(Theory::Eq11).name));
}

/// The note under the charts says what each theory holds for.
TEST(ContactFractionDiagram, RangesOfTheoriesAreSaid) {
  const CurveSet set = setWithTheories();
  for (const DiagramSheet& sheet : {contactFractionSheet(set), curveSheet(set)})
    for (const TheoryCurve& theory : set.theories)
      EXPECT_THAT(sheet.note.english(),
                  HasSubstr(std::string(entryOf(theory.theory).range).substr(0, 60)));
}

/// Tables have the theories' fractions.
TEST(ContactFractionDiagram, TablesHaveTheFractionsOfTheories) {
  const CurveSet set = setWithTheories();
  const std::string table = curveSetCsv(set);
  for (const TheoryCurve& theory : set.theories)
    for (const TheoryPoint& point : theory.points) {
      if (!point.isInRange || std::isnan(point.mu)) continue;
      EXPECT_THAT(table, HasSubstr("," + csvNumber(point.mu) + ",,," +
                                   csvNumber(point.contactFraction) + ","));
      break;
    }
}

}  // namespace
}  // namespace asperity
