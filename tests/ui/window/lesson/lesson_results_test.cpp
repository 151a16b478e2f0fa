// Results of a student and the table of a class, as a teacher opens them.
#include <gtest/gtest.h>

#include <QPushButton>
#include <QScrollBar>
#include <QTextBrowser>

#include "tests/core/temporary_folder.h"
#include "tests/ui/window/lesson/lessons_fixture.h"
#include "ui/window/lesson/lesson_results_page.h"
#include "ui/window/lesson/lesson_text.h"
#include "ui/window/main/scene_library.h"

namespace asperity {
namespace {

class LessonResultsTest : public LessonsTest {};

/// A teacher opens the file of a student like any other file.
TEST_F(LessonResultsTest, AStudentsResultsAreShownInWords) {
  TemporaryFolder folder;
  const Lesson lesson = readNamedLesson("load_and_friction", readNamedScene);
  LessonResults results = emptyResults(lesson);
  results.date = "2026-11-27T10:00:00";
  LessonResult one;
  one.step = 1;
  one.given.choice = 0;
  one.expected.choice = 1;
  results.set(one);
  writeResults(folder / "ada.json", results, lesson);
  const QString file = QString::fromStdString((folder / "ada.json").string());
  window_.documentCommands().openFile(file);
  const auto* dialog = window_.findChild<QDialog*>("lessonResults");
  ASSERT_NE(dialog, nullptr);
  const auto& table = *dialog->findChild<QTextBrowser*>("lessonResultsTable");
  const QString text = table.toPlainText();
  const LessonPrediction& asked = *lesson.steps[1].prediction;
  for (const QString& part :
       {plainText(lesson.title), plainText(asked.question), plainText(asked.choices[0].text),
        plainText(asked.choices[1].text), QStringLiteral("0 right, 1 wrong, 0 shown"),
        QStringLiteral("11/27/26"), QStringLiteral("ada.json")})
    EXPECT_TRUE(text.contains(part)) << part.toStdString() << text.toStdString();
  EXPECT_FALSE(window_.messages().isVisible());
  auto* goOn = dialog->findChild<QPushButton*>("resultsGoOn");
  ASSERT_NE(goOn, nullptr);
  EXPECT_TRUE(goOn->isDefault()) << "it is the first button, which the Enter key presses";
  goOn->click();
  ASSERT_TRUE(player().isRunning());
  EXPECT_EQ(player().step(), 1);
  EXPECT_TRUE(player().isRevealed());
}

/// Of a long lesson, too: a screen of 1024 x 700 pixels does not hold its table.
TEST_F(LessonResultsTest, TheResultsOfALongLessonAreScrolledTo) {
  TemporaryFolder folder;
  const Lesson lesson = readNamedLesson("load_and_friction", readNamedScene);
  LessonResults results = emptyResults(lesson);
  for (int step = 0; step < 60; ++step) {
    LessonResult one;
    one.step = step;
    one.given.choice = 0;
    one.expected.choice = 1;
    results.set(one);
  }
  folder.write("ada.json", resultsJson(results));
  showLessonResults(window_, QString::fromStdString((folder / "ada.json").string()));
  const auto& dialog = control<QDialog>("lessonResults");
  const auto* table = dialog.findChild<QTextBrowser*>("lessonResultsTable");
  ASSERT_NE(table, nullptr);
  EXPECT_LE(dialog.height(), dialog.screen()->availableSize().height());
  EXPECT_TRUE(waitFor([&] { return table->verticalScrollBar()->maximum() > 0; }));
}

/// Of a lesson that the program does not know as well.
TEST_F(LessonResultsTest, ThePlaceOfAPointInResultsHasItsUnit) {
  for (const Lesson& lesson :
       {readNamedLesson("rubber_is_not_coulomb", readNamedScene), sampleWithPoint(false)}) {
    const auto step = std::ranges::find_if(lesson.steps, [](const LessonStep& each) {
      return each.prediction && each.prediction->kind == PredictionKind::Point &&
             !each.prediction->x;
    });
    ASSERT_NE(step, lesson.steps.end());
    TemporaryFolder folder;
    LessonResults results = emptyResults(lesson);
    LessonResult one;
    one.step = static_cast<int>(step - lesson.steps.begin());
    one.kind = PredictionKind::Point;
    one.given.number = 0.25;
    one.given.x = 0.01;
    one.expected.number = {0.5, ""};
    one.expected.x = {0.03, "m/s"};
    results.set(one);
    writeResults(folder / "ada.json", results, lesson);
    const QString html =
        LessonResultsPage::html(QString::fromStdString((folder / "ada.json").string()));
    EXPECT_TRUE(html.contains("0.25 at 10 mm/s")) << html.toStdString();
    EXPECT_TRUE(html.contains("0.5 at 30 mm/s")) << html.toStdString();
  }
}

TEST_F(LessonResultsTest, AClassIsATable) {
  TemporaryFolder folder;
  const Lesson lesson = readNamedLesson("load_and_friction", readNamedScene);
  QStringList files;
  for (const char* student : {"ada.json", "bo.json"}) {
    LessonResults results = emptyResults(lesson);
    LessonResult one;
    one.step = 1;
    one.given.choice = files.isEmpty() ? 0 : 1;
    one.expected.choice = 1;
    one.isRight = !files.isEmpty();
    results.set(one);
    writeResults(folder / student, results, lesson);
    files += QString::fromStdString((folder / student).string());
  }
  chooseFiles("\"" + files.join("\" \"") + "\"");
  action("classTable").trigger();
  const auto* dialog = window_.findChild<QDialog*>("classResults");
  ASSERT_NE(dialog, nullptr);
  const QString text = dialog->findChild<QTextBrowser*>("classResultsTable")->toPlainText();
  for (const QString& part :
       {plainText(lesson.title), QStringLiteral("ada.json"), QStringLiteral("bo.json"),
        QStringLiteral("Step 2"), QStringLiteral("wrong (choice 1)"),
        QStringLiteral("right (choice 2)")})
    EXPECT_TRUE(text.contains(part)) << part.toStdString() << text.toStdString();

  // The file is that of the command line.
  const std::filesystem::path table = folder / "class.csv";
  chooseFiles(QString::fromStdString(table.string()));
  click("saveClassTable");
  const ClassResults results = readClasses({files[0].toStdString(), files[1].toStdString()});
  EXPECT_EQ(TemporaryFolder::read(table), classCsv(onlyClass(results)));
  EXPECT_EQ(said("classResultsStatus"), "Saved class.csv");
  chooseFiles(QString::fromStdString((folder / "class.txt").string()));
  click("saveClassTable");
  EXPECT_TRUE(said("classResultsStatus").contains(".csv"))
      << said("classResultsStatus").toStdString();
  EXPECT_FALSE(std::filesystem::exists(folder / "class.txt"));
}

TEST_F(LessonResultsTest, ATableIsOfOneLesson) {
  TemporaryFolder folder;
  QStringList files;
  for (const char* name : {"load_and_friction", "what_the_mesh_does"}) {
    const Lesson lesson = readNamedLesson(name, readNamedScene);
    const std::filesystem::path file = folder / (std::string(name) + ".json");
    writeResults(file, emptyResults(lesson), lesson);
    files += QString::fromStdString(file.string());
  }
  ASSERT_TRUE(lessons().openResults(files));
  click("saveClassTable");
  EXPECT_TRUE(said("classResultsStatus").contains("what_the_mesh_does.json"))
      << said("classResultsStatus").toStdString();
}

/// The others are shown, and the table says which file it lacks and why.
TEST_F(LessonResultsTest, AFileWithoutResultsDoesNotRefuseTheClass) {
  TemporaryFolder folder;
  const Lesson lesson = readNamedLesson("load_and_friction", readNamedScene);
  writeResults(folder / "ada.json", emptyResults(lesson), lesson);
  folder.write("lesson.json", writeLesson(lesson));
  folder.write("torn.json", R"({"schema": "asperity-lesson-results/1", "lesson": )");
  const auto path = [&](const char* name) {
    return QString::fromStdString((folder / name).string());
  };
  ASSERT_TRUE(lessons().openResults(
      {path("ada.json"), path("lesson.json"), path("torn.json"), path("none.json")}));
  const auto* dialog = window_.findChild<QDialog*>("classResults");
  ASSERT_NE(dialog, nullptr);
  const QString text = dialog->findChild<QTextBrowser*>("classResultsTable")->toPlainText();
  for (const char* part :
       {"ada.json", "lesson.json: has no results of a lesson", "torn.json: ", "none.json: "})
    EXPECT_TRUE(text.contains(part)) << part << text.toStdString();
  EXPECT_FALSE(window_.messages().isVisible());
  EXPECT_FALSE(lessons().openResults({path("lesson.json"), path("none.json")}));
  EXPECT_TRUE(window_.messages().text().contains("lesson.json: has no results of a lesson"));
}

}  // namespace
}  // namespace asperity
