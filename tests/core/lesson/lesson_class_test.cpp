// The results of a class as a table.
#include "core/lesson/lesson_class.h"

#include <gmock/gmock.h>

#include "core/base/input_error.h"
#include "tests/core/lesson/lesson_samples.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

LessonResult choice(int step, int given, bool isRight) {
  LessonResult result;
  result.step = step;
  result.given.choice = given;
  result.expected.choice = 1;
  result.isRight = isRight;
  return result;
}

class LessonClass : public testing::Test {
 protected:
  /// Writes the results of two students: one answered both steps, one saw the first answer.
  LessonClass() {
    LessonResults results = emptyResults(lesson_);
    results.date = "2026-11-27T10:00:00";
    results.set(choice(0, 1, true));
    LessonResult number;
    number.step = 1;
    number.kind = PredictionKind::Number;
    number.given.number = 2e-7;
    number.expected.number = {2.5e-7, "m"};
    results.set(number);
    writeResults(folder_ / "ada.json", results, lesson_);
    results = emptyResults(lesson_);
    results.set(choice(0, -1, false));
    writeResults(folder_ / "Bo, 2.json", results, lesson_);
  }
  std::string path(const char* name) { return (folder_ / name).string(); }

  TemporaryFolder folder_;
  Lesson lesson_ = lessonOf(sampleLesson());
};

TEST_F(LessonClass, EachStudentIsARow) {
  EXPECT_EQ(classCsv(readClass({path("ada.json"), path("Bo, 2.json")})),
            "file,date,right,wrong,shown,step_1,step_1_given,step_2,step_2_given\n"
            "ada.json,2026-11-27T10:00:00,1,1,0,right,2,wrong,2e-7\n"
            "\"Bo, 2.json\",,0,0,1,shown,,,\n");
  const std::string text = classText(readClass({path("ada.json"), path("Bo, 2.json")}));
  EXPECT_THAT(text, testing::HasSubstr("right (2)  wrong (2e-7)"));
  EXPECT_THAT(text, testing::HasSubstr("shown      -\n"));
}

TEST_F(LessonClass, AFolderGivesItsResultsAndNothingElse) {
  folder_.write("lesson.json", sampleLesson().dump());
  folder_.write("note.txt", "x");
  EXPECT_EQ(classCsv(readClass({folder_.path().string()})),
            classCsv(readClass({path("Bo, 2.json"), path("ada.json")})));
  TemporaryFolder empty;
  EXPECT_THROW(readClass({empty.path().string()}), InputError);
}

TEST_F(LessonClass, ResultsOfAnotherLessonAreRefusedByName) {
  auto json = sampleLesson();
  json["minutes"] = 20;
  const Lesson other = lessonOf(json);
  writeResults(folder_ / "other.json", emptyResults(other), other);
  try {
    readClass({path("ada.json"), path("other.json")});
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(error.file(), path("other.json"));
    EXPECT_EQ(error.key(), "sha256");
  }
  folder_.write("thesis.json", "{}");
  EXPECT_THROW(readClass({path("thesis.json")}), InputError);
}

}  // namespace
}  // namespace asperity
