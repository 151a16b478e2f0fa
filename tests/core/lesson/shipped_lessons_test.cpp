// Every shipped lesson is run: its scenes, its answers, its choices, both languages. What a lesson
// says in words is decided by the same numbers that decide its choices.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "core/accuracy/compute_curve.h"
#include "core/lesson/lesson_answers.h"
#include "core/lesson/lesson_file.h"
#include "core/scene/scene_file.h"

namespace asperity {
namespace {

Scene shippedScene(const std::string& name, const std::filesystem::path&,
                   const std::vector<std::string>& assignments) {
  return readSceneFile(std::filesystem::path(ASPERITY_RESOURCES_DIR "/scenes") / name, assignments);
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const ShippedFile& lesson : shippedLessons()) all.emplace_back(lesson.name);
  return all;
}

Lesson shipped(const std::string& name) {
  return readNamedLesson(name, shippedScene);
}

TEST(ShippedLessons, EveryFileOfTheFolderIsInTheProgram) {
  std::set<std::string> files;
  for (const auto& file : std::filesystem::directory_iterator(ASPERITY_RESOURCES_DIR "/lessons"))
    if (file.path().extension() == ".json") files.insert(file.path().stem().string());
  const std::vector<std::string> known = names();
  EXPECT_EQ(std::set<std::string>(known.begin(), known.end()), files);
  EXPECT_EQ(known.size(), 6U);
}

class ShippedLessonTest : public testing::TestWithParam<std::string> {};

void expectBoth(const LessonText& text, const std::string& what, bool isRequired = true) {
  if (!isRequired && text.empty()) return;
  EXPECT_FALSE(text.english.empty()) << what;
  EXPECT_FALSE(text.german.empty()) << what;
  EXPECT_NE(text.english, text.german) << what;
  const auto paragraphs = [](const std::string& all) { return std::ranges::count(all, '\n'); };
  EXPECT_EQ(paragraphs(text.english), paragraphs(text.german)) << what;
}

TEST_P(ShippedLessonTest, HasGoalNotesAndTwoLanguagesThroughout) {
  const Lesson lesson = shipped(GetParam());
  for (const LessonText* text : {&lesson.title, &lesson.goal, &lesson.notes})
    expectBoth(*text, "head");
  EXPECT_GE(lesson.minutes, 10);
  EXPECT_LE(lesson.minutes, 20);
  EXPECT_GE(lesson.steps.size(), 8U);
  EXPECT_LE(lesson.steps.size(), 14U);
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const LessonStep& step = lesson.steps[i];
    const std::string what = "step " + std::to_string(i + 1);
    expectBoth(step.title, what + " title");
    expectBoth(step.text, what + " text");
    expectBoth(step.reveal, what + " reveal", false);
    if (!step.prediction) continue;
    expectBoth(step.prediction->question, what + " question");
    expectBoth(step.prediction->right, what + " right", false);
    expectBoth(step.prediction->wrong, what + " wrong");
    for (const LessonChoice& choice : step.prediction->choices)
      expectBoth(choice.text, what + " choice");
  }
}

/// A lesson without a guess is a lecture; choices that nothing decides are the exception.
TEST_P(ShippedLessonTest, AsksAndAnswersByComputing) {
  const Lesson lesson = shipped(GetParam());
  int asked = 0, computed = 0;
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const LessonStep& step = lesson.steps[i];
    if (!step.prediction) continue;
    ++asked;
    computed += step.prediction->answer || step.prediction->kind == PredictionKind::Point ? 1 : 0;
    SCOPED_TRACE("step " + std::to_string(i + 1));
    const LessonAnswer answer = lessonAnswer(step);
    if (step.prediction->kind == PredictionKind::Choice) {
      EXPECT_GE(answer.choice, 0);
      // The bounds of the right choice keep clear of the answer: it does not hang on a digit.
      if (step.prediction->answer) {
        const LessonChoice& right =
            step.prediction->choices[static_cast<std::size_t>(answer.choice)];
        const double below = answer.number.value - right.above;
        const double above = right.below - answer.number.value;
        const double room = std::isfinite(below + above) ? 0.1 * (below + above)
                                                         : 0.02 * std::abs(answer.number.value);
        EXPECT_GT(std::min(below, above), room) << answer.number.value;
      }
    } else {
      EXPECT_TRUE(std::isfinite(answer.number.value));
      GivenAnswer exact;
      exact.number = answer.number.value;
      exact.x = answer.x.value;
      EXPECT_TRUE(isRight(*step.prediction, answer, exact));
    }
    // A hidden curve lies within the axes on which it is guessed.
    if (step.prediction->kind == PredictionKind::Point) {
      EXPECT_GT(answer.number.value, step.show.hiddenFrom);
      EXPECT_LT(answer.number.value, step.show.hiddenTo);
    }
    for (const auto& [name, value] : answer.values) EXPECT_TRUE(std::isfinite(value.value)) << name;
  }
  EXPECT_GE(asked, 5);
  EXPECT_GE(3 * computed, 2 * asked);
}

INSTANTIATE_TEST_SUITE_P(All, ShippedLessonTest, testing::ValuesIn(names()),
                         [](const auto& one) { return one.param; });

}  // namespace
}  // namespace asperity
