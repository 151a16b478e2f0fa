#include "core/chart/curve_words.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(CurveWords, SayWhatASceneSets) {
  const std::string words = describeParameters({}).english();
  EXPECT_NE(words.find("H = 0.7"), words.npos);
  EXPECT_NE(words.find("G = 10 MPa"), words.npos);
  EXPECT_NE(words.find("F\u2099 = 3.4 mN"), words.npos);
  EXPECT_EQ(words.find("T\u1D63"), words.npos) << "a temperature that shifts nothing is not said";
}

TEST(CurveWords, HaveATrueMinus) {
  Scene scene;
  scene.surface.summitCorrelation = -0.9;
  EXPECT_NE(describeParameters(scene).english().find("\u03BA = \u22120.9"), std::string::npos)
      << describeParameters(scene).english();
}

TEST(CurveWords, SayOnlyWhatDiffers) {
  Scene scene, other;
  EXPECT_EQ(describeDifferences(other, scene).english(), "");
  other.elastomer.shearModulus = 2e7;
  other.surface.rmsHeight = 5e-6;
  EXPECT_EQ(describeDifferences(other, scene).english(), "h = 5 \u00B5m, G = 20 MPa");
  EXPECT_EQ(describeDifferences(scene, other).english(), "h = 500 nm, G = 10 MPa");
}

TEST(CurveWords, LeaveOutWhatACurveDoesNotDependOn) {
  Scene scene, other;
  other.title = "another";
  other.description = "to be seen";
  other.sliding.velocity = 3;
  EXPECT_EQ(describeDifferences(other, scene).english(), "");
}

TEST(CurveWords, NameRowsWithoutSymbolAndChoices) {
  Scene scene, other;
  other.accuracy.scheme = Scheme::Linear;
  other.accuracy.oversampling = 4;
  other.ensemble.realizations = 20;
  EXPECT_EQ(describeDifferences(other, scene).english(), "realizations 20, linear, oversampling 4");
  other = {};
  other.elastomer.rheology = Rheology::StandardSolid;
  const std::string words = describeDifferences(other, scene).english();
  EXPECT_NE(words.find("standard-solid"), words.npos) << words;
  EXPECT_EQ(words.find("G = "), words.npos) << "what does not apply is not said: " << words;
}

/// A curve to a target beside one with stated lines.
TEST(CurveWords, NameNoTargetWhereThereIsNone) {
  Scene scene, target;
  target.accuracy.targetRelativeError = 0.05;
  EXPECT_EQ(describeDifferences(target, scene).english(), "target error = 0.05");
  const std::string words = describeDifferences(scene, target).english();
  EXPECT_EQ(words.find("target"), words.npos) << words;
  EXPECT_NE(words, "") << "it has points per element instead";
}

TEST(CurveWords, SayATemperatureThatShifts) {
  Scene scene, other;
  other.elastomer.temperature = 320;
  EXPECT_EQ(describeDifferences(other, scene).english().substr(0, 12), "T = 46.9 \u00B0C");
}

TEST(CurveWords, OneParameterHasItsSymbolOrItsName) {
  Scene scene;
  scene.surface.hurst = 0.25;
  scene.accuracy.scheme = Scheme::Linear;
  EXPECT_EQ(describeParameter("surface.hurst", scene).english(), "H = 0.25");
  EXPECT_EQ(describeParameter("surface.seed", scene).english(), "seed 1");
  EXPECT_EQ(describeParameter("accuracy.scheme", scene).english(), "linear");
  EXPECT_EQ(describeParameter("elastomer.arms", scene).english(), "");
  EXPECT_EQ(describeParameter("surface.hurts", scene).english(), "");
}

/// Points per element that the scene leaves open depend on its other parameters; nobody chose them.
TEST(CurveWords, LeaveOutWhatWasChosenAutomatically) {
  Scene scene, other;
  other.sliding.velocity = scene.sliding.velocity;
  other.load.normalForce = 3;
  other.surface.elements = 8 * scene.surface.elements;
  other.ensemble.realizations = 1;
  ASSERT_NE(curvePointsPerElement(scene), curvePointsPerElement(other));
  const std::string words = describeDifferences(other, scene).english();
  EXPECT_EQ(words.find("oversampling"), words.npos) << words;
  other.accuracy.oversampling = 4;
  EXPECT_NE(describeDifferences(other, scene).english().find("oversampling 4"), words.npos);
}

/// A length of 0 m means that of the file, and is no length of 0 m.
TEST(CurveWords, AValueLeftToTheFileIsNoNumber) {
  Scene scene, other;
  other.surface.kind = SurfaceKind::Measured;
  other.surface.file = "rough.csv";
  other.surface.length = 0;
  other.surface.elements = 0;
  other.ensemble.realizations = 0;
  const std::string words = describeDifferences(other, scene).english();
  EXPECT_NE(words.find("measured"), words.npos) << words;
  EXPECT_NE(words.find("file rough.csv"), words.npos) << words;
  for (const char* said : {"period", "elements", "realizations"})
    EXPECT_EQ(words.find(said), words.npos) << words;
  scene = other;
  scene.surface.length = 0.01;
  EXPECT_EQ(describeDifferences(other, scene).english(), "period as in the file");
}

}  // namespace
}  // namespace asperity
