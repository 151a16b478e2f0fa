// The results of a class as a table.
#include "core/lesson/lesson_results.h"

#include <gmock/gmock.h>

#include "core/base/input_error.h"
#include "tests/core/lesson/lesson_samples.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

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
  static std::vector<StudentResults> readClass(const std::vector<std::string>& filesAndFolders) {
    return onlyClass(readClasses(filesAndFolders));
  }

  TemporaryFolder folder_;
  Lesson lesson_ = lessonOf(sampleLesson());
};

TEST_F(LessonClass, EachStudentIsARow) {
  EXPECT_EQ(classCsv(readClass({path("ada.json"), path("Bo, 2.json")})),
            "file,date,right,wrong,shown,step_1,step_1_given,step_2,step_2_given\n"
            "ada.json,2026-11-27T10:00:00,1,1,0,right,2,wrong,2e-7\n"
            "\"Bo, 2.json\",,0,0,1,shown,,,\n");
}

/// Also JSON without results is named: a student may have sent the wrong file.
TEST_F(LessonClass, AFolderGivesItsResultsAndNamesOtherJson) {
  folder_.write("lesson.json", sampleLesson().dump());
  folder_.write("note.txt", "x");
  folder_.write("torn.json", R"({"schema": "asperity-lesson-res)");
  const TemporaryFolder empty;
  const ClassResults results = readClasses({empty.path().string(), folder_.path().string()});
  EXPECT_EQ(classCsv(onlyClass(results)),
            classCsv(readClass({path("Bo, 2.json"), path("ada.json")})));
  ASSERT_EQ(results.refused.size(), 3U);
  EXPECT_EQ(results.refused[0].file(), empty.path().string());
  EXPECT_EQ(results.refused[1].file(), path("lesson.json"));
  EXPECT_EQ(results.refused[2].file(), path("torn.json"));
  EXPECT_THROW(readClass({empty.path().string()}), InputError);
}

TEST_F(LessonClass, APointHasItsPlace) {
  LessonResults results = emptyResults(lesson_);
  LessonResult point;
  point.step = 1;
  point.kind = PredictionKind::Point;
  point.given.number = 0.0017782794100389228;
  point.given.x = 0.012092330352182426;
  point.expected.number.value = 0.5;
  point.expected.x = {0.03, "m/s"};
  results.set(point);
  writeResults(folder_ / "eva.json", results, lesson_);
  EXPECT_THAT(classCsv(readClass({path("eva.json"), path("ada.json")})),
              testing::HasSubstr("0.0017782794100389228 at 0.012092330352182426"));
}

/// In a folder with results of several lessons each has a table of its own.
TEST_F(LessonClass, EachLessonHasATable) {
  auto json = sampleLesson();
  json["title"] = "Other";
  const Lesson other = lessonOf(json);
  writeResults(folder_ / "bea.json", emptyResults(other), other);
  const auto classes = readClasses({folder_.path().string()}).classes;
  ASSERT_EQ(classes.size(), 2U);
  EXPECT_EQ(classes[0].size(), 2U);
  EXPECT_EQ(classes[0][1].file, "ada.json");
  EXPECT_EQ(classes[1].front().results.title, "Other");
  EXPECT_EQ(classes[1].size(), 1U);
}

TEST_F(LessonClass, FilesThatCannotBeReadAreReturnedWithTheirReasons) {
  folder_.write("lesson.json", sampleLesson().dump());
  const auto [classes, refused] =
      readClasses({path("ada.json"), path("lesson.json"), path("none.json")});
  ASSERT_EQ(classes.size(), 1U);
  EXPECT_EQ(classes[0].front().file, "ada.json");
  ASSERT_EQ(refused.size(), 2U);
  EXPECT_EQ(refused[0].file(), path("lesson.json"));
  EXPECT_THAT(refused[0].what(), testing::HasSubstr("lesson.json: has no results of a lesson"));
  EXPECT_EQ(refused[1].file(), path("none.json"));
  EXPECT_THROW(readClasses({path("lesson.json"), path("none.json")}), InputError);
}

TEST_F(LessonClass, ResultsOfAnotherLessonAreRefusedInWords) {
  const auto refusal = [this](const char* member, const Json& value) {
    auto json = sampleLesson();
    json[member] = value;
    const Lesson other = lessonOf(json);
    const std::string file = path((std::string(member) + ".json").c_str());
    writeResults(file, emptyResults(other), other);
    try {
      readClass({path("ada.json"), file});
    } catch (const InputError& error) {
      EXPECT_EQ(error.file(), std::string(member) + ".json");
      EXPECT_EQ(error.key(), "");
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(refusal("title", "Other"),
              testing::HasSubstr("has results of 'Other', but ada.json has those of 'Sample'"));
  EXPECT_THAT(refusal("minutes", 20),
              testing::HasSubstr("another version of 'Sample' than ada.json"));
  folder_.write("thesis.json", "{}");
  EXPECT_THROW(readClass({path("thesis.json")}), InputError);
}

}  // namespace
}  // namespace asperity
