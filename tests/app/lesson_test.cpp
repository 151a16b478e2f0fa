// asperity lesson and the check of lessons, as typed in a shell.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/app/program.h"
#include "tests/core/lesson/lesson_samples.h"

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class LessonProgramTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    program.folder.write("lesson.json", sampleLesson().dump());
  }
};

TEST_F(LessonProgramTest, ListsTheShippedLessons) {
  const Said said = program.run("lesson");
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("rubber_is_not_coulomb"));
  const auto json = nlohmann::json::parse(program.run("lesson --json --quiet").out);
  EXPECT_EQ(json.size(), 6U);
}

TEST_F(LessonProgramTest, SaysWhatIsAskedAndWhatIsRight) {
  const Said said = program.run("lesson lesson.json --json");
  ASSERT_EQ(said.status, 0) << said.err;
  const auto json = nlohmann::json::parse(said.out);
  EXPECT_EQ(json["schema"], "asperity-lesson-summary/1");
  EXPECT_EQ(json["steps"][0]["answer"]["choice"], 2);
  EXPECT_NEAR(json["steps"][0]["answer"]["computed"]["value"].get<double>(), 2, 0.1);
  EXPECT_EQ(json["steps"][1]["answer"]["unit"], "m");
  EXPECT_EQ(program.run("lesson lesson.json --json --threads 1").out, said.out);
}

TEST_F(LessonProgramTest, WritesHandouts) {
  Said said = program.run("lesson lesson.json -o page.html -o page.pdf");
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("wrote page.pdf"));
  EXPECT_THAT(read("page.pdf"), StartsWith("%PDF"));
  EXPECT_THAT(read("page.html"), Not(HasSubstr("Answer:")));
  const std::string first = read("page.pdf");
  said = program.run("lesson lesson.json -o page.html -o page.pdf --threads 1");
  EXPECT_EQ(read("page.pdf"), first);
  said = program.run("lesson lesson.json -o page.html --teacher --language de");
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_THAT(read("page.html"), HasSubstr("Antwort:"));
  EXPECT_THAT(read("page.html"), HasSubstr("lang=\"de\""));
}

TEST_F(LessonProgramTest, IsChecked) {
  const Said said = program.run("check lesson.json s.json");
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("2 steps, 2 predictions"));
  auto json = sampleLesson();
  json["steps"][1]["set"]["load.normal_forc"] = 1;
  program.folder.write("lesson.json", json.dump());
  expectRefused("check lesson.json", 2, "lesson.json: steps[1].set.load.normal_forc: ");
}

TEST_F(LessonProgramTest, RefusesWhatCannotBe) {
  expectRefused("lesson none", 2, "rubber_is_not_coulomb");
  expectRefused("lesson lesson.json -o page.txt", 2, ".html");
  expectRefused("lesson lesson.json -o none/page.html", 2, "none");
  expectRefused("lesson lesson.json --teacher", 2, "--teacher");
  expectRefused("lesson --teacher", 2, "--teacher");
  expectRefused("lesson s.json", 2, "asperity-lesson/1");
  expectRefused("check lesson.json --set load.normal_force=1", 2, "--set");
}

TEST_F(LessonProgramTest, RefusesChoicesThatDoNotCoverTheAnswer) {
  auto json = sampleLesson();
  json["steps"][0]["prediction"]["choices"][1]["below"] = 1.6;
  program.folder.write("gap.json", json.dump());
  for (const char* command : {"check gap.json", "lesson gap.json", "lesson gap.json --json"}) {
    const Said said = program.run(command);
    EXPECT_EQ(said.status, 2) << command;
    EXPECT_THAT(said.err, HasSubstr("gap.json: steps[0].prediction.choices: none of them covers"));
  }
}

/// A teacher collects the files of a class.
TEST_F(LessonProgramTest, PrintsTheResultsOfAClass) {
  const std::string head =
      R"({"schema": "asperity-lesson-results/1", "lesson": "x", "title": "Loads", "sha256": "1", )";
  const std::string step = R"("steps": [{"step": 2, "kind": "choice", "expected": 1, )";
  program.folder.write("ada.json", head + step + R"("given": 1, "right": true}]})");
  program.folder.write("bo.json", head + R"("date": "2026-11-27T10:00:00", )" + step +
                                      R"("given": "shown", "right": false}]})");
  const Said said = program.run("lesson ada.json bo.json -o class.csv");
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("Loads"));
  EXPECT_THAT(said.out, HasSubstr("right (choice 1)"));
  EXPECT_EQ(read("class.csv"),
            "file,date,right,wrong,shown,step_2,step_2_given\n"
            "ada.json,,1,0,0,right,1\nbo.json,2026-11-27T10:00:00,0,0,1,shown,\n");
  const auto json = nlohmann::json::parse(program.run("lesson bo.json --json").out);
  EXPECT_EQ(json["schema"], "asperity-lesson-class/1");
  EXPECT_EQ(json["students"][0]["shown"], 1);
  expectRefused("lesson ada.json -o class.pdf", 2, ".csv");
  expectRefused("lesson ada.json -o ada.json", 2, ".csv");
  expectRefused("lesson ada.json --teacher -o class.csv", 2, "--teacher");
}

/// The title of a shipped lesson, too. A number has three digits and its unit, and a letter of
/// several bytes takes one place.
TEST_F(LessonProgramTest, TheTableForPeopleIsInTheirLanguage) {
  const auto lesson =
      nlohmann::json::parse(program.run("lesson load_and_friction --json --quiet").out);
  program.folder.write(
      "Zoë.json",
      R"({"schema": "asperity-lesson-results/1", "lesson": "load_and_friction", "title": "x", )"
      R"("sha256": ")" +
          lesson["sha256"].get<std::string>() +
          R"(", "steps": [{"step": 3, "kind": "number", "expected": 3.6701948, )"
          R"("given": 0.0034567, "unit": "N", "right": false}]})");
  const Said said = program.run("lesson Zoë.json --language de");
  EXPECT_EQ(said.out,
            "Last und Reibung\n"
            "Datei             richtig  falsch  gezeigt  Schritt 3\n"
            "Richtige Antwort                            3,67 N\n"
            "Zoë.json          0        1       0        falsch (3,46 mN)\n");
}

/// The folder of a teacher has the results of several lessons.
TEST_F(LessonProgramTest, PrintsATableForEachLesson) {
  const auto results = [](const char* title, const char* digest) {
    return std::string(R"({"schema": "asperity-lesson-results/1", "lesson": "x", "title": ")") +
           title + R"(", "sha256": ")" + digest +
           R"(", "steps": [{"step": 2, "kind": "choice", "expected": 1, "given": 1, "right": true}]})";
  };
  program.folder.write("ada.json", results("Loads", "1"));
  program.folder.write("bo.json", results("Speeds", "2"));
  program.folder.write("cy.json", results("Speeds", "3"));
  const Said said = program.run("lesson ada.json bo.json cy.json");
  ASSERT_EQ(said.status, 0) << said.err;
  for (const char* part : {"Loads\nFile", "\n\nSpeeds\nFile", "\n\nSpeeds, another version\nFile"})
    EXPECT_THAT(said.out, HasSubstr(part));
  expectRefused("lesson ada.json bo.json -o class.csv", 2,
                "bo.json: has results of 'Speeds', but ada.json has those of 'Loads'");
  EXPECT_THAT(program.run("lesson ada.json bo.json --json").err, Not(HasSubstr("sha256")));
}

/// One damaged file does not hide the others, and none is left out in silence.
TEST_F(LessonProgramTest, NamesTheFilesWithoutResultsBesideTheTable) {
  const std::string head =
      R"({"schema": "asperity-lesson-results/1", "lesson": "x", "title": "Loads", "sha256": "1", )"
      R"("steps": [{"step": 2, "kind": "choice", "expected": 1)";
  std::filesystem::create_directory(program.folder / "class");
  program.folder.write("class/ada.json", head + R"(, "given": 1, "right": true}]})");
  program.folder.write("class/bo.json", head + "}]}");
  program.folder.write("class/cy.json", "{");
  program.folder.write("class/di.json", "{}");
  for (const char* rest : {"", " -o class.csv"}) {
    const Said said = program.run(std::string("lesson class") + rest);
    EXPECT_EQ(said.status, 1);
    EXPECT_THAT(said.out, HasSubstr("\nada.json      1 "));
    for (const char* reason : {"bo.json: steps[0].given: is missing\n",
                               "cy.json: ", "di.json: has no results of a lesson\n"})
      EXPECT_THAT(said.err, HasSubstr(reason));
  }
  EXPECT_THAT(read("class.csv"), HasSubstr("\nada.json,,1,0,0,right,1\n"));
  expectRefused("lesson class/bo.json class/di.json", 2, "bo.json: steps[0].given: is missing");
}

/// A name in Latin-1, as from an old disk.
TEST_F(LessonProgramTest, NamesOfFilesMayBeNoUtf8) {
  program.folder.write(
      "Zo\xEB.json",
      R"({"schema": "asperity-lesson-results/1", "lesson": "x", "title": "Loads", "sha256": "1", )"
      R"("steps": [{"step": 2, "kind": "choice", "expected": 1, "given": 1, "right": true}]})");
  const Said said = program.run("lesson Zo*.json --json --quiet");
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_EQ(nlohmann::json::parse(said.out)["students"][0]["file"], "Zo\uFFFD.json");
}

/// Several words are results, of which each is a file or a folder.
TEST_F(LessonProgramTest, ShowsOneLessonAtATime) {
  expectRefused("lesson rubber_is_not_coulomb hurst", 2,
                "rubber_is_not_coulomb: there is no such file or folder of results; one lesson at "
                "a time is shown");
  expectRefused("lesson lesson.json missing.json", 2, "missing.json: there is no such file");
}

/// A draft is refused with what is missing in which step.
TEST_F(LessonProgramTest, SaysWhatADraftLacks) {
  auto json = sampleLesson();
  json["steps"][1]["prediction"].erase("question");
  program.folder.write("draft.json", json.dump());
  for (const char* command : {"check draft.json", "lesson draft.json"})
    expectRefused(command, 2, "draft.json: steps[1].prediction.question: is missing");
}

}  // namespace
}  // namespace asperity
