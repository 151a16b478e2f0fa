// Answers of lessons: they are what the program computes, and what counts as right.
#include "core/lesson/lesson_answers.h"

#include <gmock/gmock.h>

#include <cmath>

#include "core/accuracy/compute_curve.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/scene/scene_file.h"
#include "tests/core/lesson/lesson_samples.h"

namespace asperity {
namespace {

Scene small() {
  return lessonOf(sampleLesson()).steps[0].scene;
}

/// A sine in complete contact: mu = c q^2 A^2 / (2 d), c = v tau, d = F_N / (4 G L).
Scene fullSine() {
  return readScene(
      R"({"surface": {"kind": "sine", "elements": 256, "amplitude": 1e-6, "waves": 4},
          "load": {"normal_force": 100}, "sliding": {"velocity": 0.01},
          "sweep": {"velocity_from": 0.001, "velocity_to": 0.1, "points": 5},
          "ensemble": {"realizations": 1}})",
      "sine");
}

TEST(LessonAnswers, AStateIsTheClosedFormOfASineInFullContact) {
  const Scene scene = fullSine();
  const double q = 2 * M_PI * 4 / scene.surface.length, amplitude = 1e-6;
  const double depth = 100 / (4 * scene.elastomer.shearModulus * scene.surface.length);
  const double expected =
      0.01 * scene.elastomer.relaxationTime * q * q * amplitude * amplitude / (2 * depth);
  LessonValue value;
  EXPECT_NEAR(computeLessonValue(scene, value).value / expected, 1, 1e-4);
  EXPECT_EQ(computeLessonValue(scene, value).unit, "");
  value.column = "indentation";
  EXPECT_EQ(computeLessonValue(scene, value).unit, "m");
}

/// There mu is proportional to v and to 1/F_N: ratios and exponents are known.
TEST(LessonAnswers, RatiosAndExponents) {
  LessonValue twice;
  twice.set = {"sliding.velocity=0.02"};
  twice.over.push_back({});
  EXPECT_NEAR(computeLessonValue(fullSine(), twice).value, 2, 1e-6);
  LessonValue exponent;
  exponent.kind = LessonValue::Kind::Exponent;
  exponent.key = "sliding.velocity";
  exponent.from = 0.001;
  exponent.to = 0.01;
  EXPECT_NEAR(computeLessonValue(fullSine(), exponent).value, 1, 1e-6);
  exponent.key = "load.normal_force";
  exponent.from = 100;
  exponent.to = 300;
  EXPECT_NEAR(computeLessonValue(fullSine(), exponent).value, -1, 1e-6);
}

/// The curve depends on v tau alone: a hundredth of tau moves its top to 100 times the velocity.
TEST(LessonAnswers, ThePlaceOfThePeakMovesWithTheRelaxationTime) {
  Scene scene = small();
  scene.sweep = {1e-4, 1e4, 41};
  LessonValue value;
  value.kind = LessonValue::Kind::Peak;
  EXPECT_EQ(computeLessonValue(scene, value).unit, "m/s");
  value.over.push_back(value);
  value.set = {"elastomer.relaxation_time=1e-5"};
  EXPECT_NEAR(computeLessonValue(scene, value).value, 100, 0.1);
}

TEST(LessonAnswers, TheStepsOfALesson) {
  const Lesson lesson = lessonOf(sampleLesson());
  const LessonAnswer choice = lessonAnswer(lesson.steps[0]);
  EXPECT_NEAR(choice.number.value, 2, 0.1);  // region I: proportional to v
  EXPECT_EQ(choice.choice, 1);
  ASSERT_EQ(choice.values.size(), 1U);
  EXPECT_EQ(choice.values[0].second.value,
            computeCurveAt(lesson.steps[0].revealedScene, 2e-4).points.front().mu);
  const LessonAnswer number = lessonAnswer(lesson.steps[1]);
  EXPECT_EQ(number.number.unit, "m");
  EXPECT_EQ(number.number.value,
            computeCurveAt(lesson.steps[1].scene, 2e-4).points.front().indentation);
}

TEST(LessonAnswers, APointIsOnTheCurveOfItsStep) {
  auto json = sampleLesson();
  json["steps"][1]["prediction"] = {{"kind", "point"}, {"question", "?"}, {"x", 1}};
  LessonStep step = lessonOf(json).steps[1];
  EXPECT_TRUE(step.show.hidesCurve);
  EXPECT_EQ(lessonAnswer(step).number.value, computeCurveAt(step.scene, 1).points.front().mu);
  EXPECT_EQ(lessonAnswer(step).x.value, 1);
  json["steps"][1]["prediction"].erase("x");
  step = lessonOf(json).steps[1];
  const LessonAnswer top = lessonAnswer(step);
  for (const CurvePoint& point : computeCurve(step.scene).points)
    EXPECT_LE(point.mu, 1.001 * top.number.value);
  EXPECT_EQ(top.x.unit, "m/s");
}

TEST(LessonAnswers, AnAnswerThatNoChoiceCoversIsAnError) {
  auto json = sampleLesson();
  json["steps"][0]["prediction"]["choices"] = {{{"text", "a"}, {"below", 1}},
                                               {{"text", "b"}, {"above", 5}}};
  EXPECT_THROW(lessonAnswer(lessonOf(json).steps[0]), InputError);
}

TEST(LessonAnswers, WhatIsRight) {
  const LessonAnswer answer{{-2, ""}, {0.1, ""}, 1, {}};
  GivenAnswer given;
  LessonPrediction prediction;
  EXPECT_FALSE(isRight(prediction, answer, given));
  given.choice = 1;
  EXPECT_TRUE(isRight(prediction, answer, given));
  given = {};
  prediction.kind = PredictionKind::Number;
  prediction.tolerance = 0.25;
  for (const auto& [number, right] : std::vector<std::pair<double, bool>>{
           {-2, true}, {-2.5, true}, {-1.5, true}, {-2.51, false}, {2, false}, {INFINITY, false}}) {
    given.number = number;
    EXPECT_EQ(isRight(prediction, answer, given), right) << number;
  }
}

TEST(LessonAnswers, APointIsRightWithinAFactor) {
  const LessonAnswer answer{{0.02, ""}, {0.1, "m/s"}, -1, {}};
  LessonPrediction prediction;
  prediction.kind = PredictionKind::Point;
  prediction.tolerance = 0.5;
  prediction.xTolerance = 1;
  GivenAnswer given;
  given.number = 0.0135;  // 1/1.48
  given.x = 0.19;
  EXPECT_TRUE(isRight(prediction, answer, given));
  given.x = 0.21;
  EXPECT_FALSE(isRight(prediction, answer, given));
  EXPECT_TRUE(isHeightRight(prediction, answer, given));
  EXPECT_FALSE(isPlaceRight(prediction, answer, given));
  prediction.x = 0.1;  // its place is not asked
  EXPECT_TRUE(isRight(prediction, answer, given));
  given.number = 0.0132;
  EXPECT_FALSE(isRight(prediction, answer, given));
  given.number = 0.03;
  EXPECT_TRUE(isRight(prediction, answer, given));
}

TEST(LessonAnswers, TextsSpeakOfValues) {
  const Lesson lesson = lessonOf(sampleLesson());
  const LessonPrediction& prediction = *lesson.steps[0].prediction;
  const LessonAnswer answer{{2, ""}, {}, 1, {{"twice", {0.5, "m"}}}};
  GivenAnswer given;
  given.choice = 2;
  const auto text = [](const LessonNumber& number) {
    return plainNumber(number.value) + number.unit;
  };
  EXPECT_EQ(withValues("No, {answer}, not {given}: {twice} {other} {", prediction, answer, given,
                       "en", text),
            "No, 2, not more: 0.5m {other} {");
  const LessonAnswer part{{0.25, ""}, {}, 1, {}};
  EXPECT_EQ(withValues("{answer%} of it", prediction, part, given, "en", text), "25\u00A0% of it");
}

/// A student could not go on: the lesson is refused with the place, and with a number that can be
/// read.
TEST(LessonAnswers, ChoicesThatMayLeaveOutTheAnswerAreComputed) {
  auto json = sampleLesson();
  EXPECT_FALSE(leavesOutNumbers(*lessonOf(json).steps[0].prediction));
  EXPECT_NO_THROW(checkChoices(lessonOf(json), "a.json"));
  auto& choices = json["steps"][0]["prediction"]["choices"];
  choices[1]["below"] = 2.9;  // the answer, about 2, is covered in spite of the gap
  EXPECT_TRUE(leavesOutNumbers(*lessonOf(json).steps[0].prediction));
  EXPECT_NO_THROW(checkChoices(lessonOf(json), "a.json"));
  choices[1]["below"] = 1.6;
  try {
    checkChoices(lessonOf(json), "a.json");
    ADD_FAILURE() << "the gap was accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.file(), "a.json");
    EXPECT_EQ(error.key(), "steps[0].prediction.choices");
    EXPECT_LT(error.message().english().size(), 60U) << error.message().english();
  }
  choices[2].erase("above");
  choices[2]["below"] = 1.5;
  choices[0] = {{"text", "same"}, {"above", 3}};
  EXPECT_TRUE(leavesOutNumbers(*lessonOf(json).steps[0].prediction));  // in any order
}

/// Where no number decides, the answer is a choice, and its text stands for it.
TEST(LessonAnswers, TheAnswerOfATickedChoiceIsItsText) {
  auto json = sampleLesson();
  auto& prediction = json["steps"][0]["prediction"];
  prediction.erase("answer");
  prediction["choices"] = {{{"text", {{"en", "the front"}, {"de", "vorn"}}}, {"right", true}},
                           {{"text", {{"en", "the back"}, {"de", "hinten"}}}}};
  const LessonStep step = lessonOf(json).steps[0];
  GivenAnswer given;
  given.choice = 1;
  const auto number = [](const LessonNumber&) { return std::string("a number"); };
  EXPECT_EQ(withValues("{answer}, not {given}", *step.prediction, lessonAnswer(step), given, "de",
                       number),
            "vorn, not hinten");
}

}  // namespace
}  // namespace asperity
