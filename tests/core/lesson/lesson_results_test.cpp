// Results of lessons: they come back as they were, and nothing of somebody's is ever lost.
#include "core/lesson/lesson_results.h"

#include <gmock/gmock.h>

#include "core/base/input_error.h"
#include "tests/core/lesson/lesson_samples.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

LessonResults someResults(const Lesson& lesson) {
  LessonResults results = emptyResults(lesson);
  LessonResult number;
  number.step = 1;
  number.kind = PredictionKind::Number;
  number.given.number = 2e-7;
  number.expected.number = {2.5e-7, "m"};
  results.set(number);
  LessonResult choice;
  choice.step = 0;
  choice.given.choice = 1;
  choice.expected.choice = 1;
  choice.isRight = true;
  results.set(choice);
  return results;
}

TEST(LessonResults, ComeBackAsTheyWere) {
  TemporaryFolder folder;
  const Lesson lesson = lessonOf(sampleLesson());
  const LessonResults results = someResults(lesson);
  writeResults(folder / "mine.json", results, lesson);
  const LessonResults again = readResults(folder / "mine.json", lesson);
  EXPECT_EQ(resultsJson(again), resultsJson(results));
  ASSERT_EQ(again.results.size(), 2U);
  EXPECT_EQ(again.results[0].step, 0);  // in the order of the steps
  EXPECT_EQ(again.find(1)->given.number, 2e-7);
  EXPECT_EQ(again.find(1)->expected.number.unit, "m");
  EXPECT_EQ(again.right(), 1);
  EXPECT_EQ(again.find(7), nullptr);
}

TEST(LessonResults, AnAnswerThatWasOnlyShownIsCalledShown) {
  const Lesson lesson = lessonOf(sampleLesson());
  LessonResults results = emptyResults(lesson);
  for (const PredictionKind kind :
       {PredictionKind::Choice, PredictionKind::Number, PredictionKind::Point}) {
    LessonResult result;
    result.step = static_cast<int>(kind);
    result.kind = kind;
    results.set(result);
  }
  const auto json = nlohmann::json::parse(resultsJson(results));
  EXPECT_EQ(json["shown"], 3);
  for (const auto& step : json["steps"]) EXPECT_EQ(step["given"], "shown");
  const LessonResults again = parseResults(resultsJson(results), "x");
  EXPECT_EQ(again.shown(), 3);
  for (const LessonResult& result : again.results) EXPECT_FALSE(result.given.isGiven());
  EXPECT_EQ(again.results.size(), 3U);
}

TEST(LessonResults, NothingElseIsEverReplaced) {
  TemporaryFolder folder;
  const Lesson lesson = lessonOf(sampleLesson());
  for (const char* content : {"my thesis", "{}", "{\"schema\": \"asperity-scene/1\"}", ""}) {
    folder.write("mine.json", content);
    EXPECT_THROW(writeResults(folder / "mine.json", someResults(lesson), lesson), InputError);
    EXPECT_EQ(TemporaryFolder::read(folder / "mine.json"), content);
  }
  auto json = sampleLesson();
  json["minutes"] = 20;
  const Lesson other = lessonOf(json);
  writeResults(folder / "other.json", someResults(other), other);
  const std::string kept = TemporaryFolder::read(folder / "other.json");
  EXPECT_THROW(writeResults(folder / "other.json", someResults(lesson), lesson), InputError);
  EXPECT_EQ(TemporaryFolder::read(folder / "other.json"), kept);
}

TEST(LessonResults, WrongFilesAreRefusedWithTheirPlace) {
  const auto refused = [](const std::string& text, const std::string& key) {
    try {
      parseResults(text, "mine.json");
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_EQ(error.file(), "mine.json");
      EXPECT_EQ(error.key(), key) << text;
    }
  };
  const std::string head = R"({"schema": "asperity-lesson-results/1", )";
  refused(head + R"("stps": []})", "stps");
  refused(head + R"("lesson": "x"})", "steps");
  refused(head + R"("steps": [{"step": 0}]})", "steps[0].kind");
  refused(
      head +
          R"("steps": [{"step": 0, "kind": "choice", "given": 1, "expected": 1, "right": true}]})",
      "steps[0].step");
  refused(
      head +
          R"("steps": [{"step": 1, "kind": "choice", "given": "a", "expected": 1, "right": true}]})",
      "steps[0].given.choice");
  refused(
      head +
          R"("steps": [{"step": 1, "kind": "number", "given": "a", "expected": 1, "right": true}]})",
      "steps[0].given");
}

}  // namespace
}  // namespace asperity
