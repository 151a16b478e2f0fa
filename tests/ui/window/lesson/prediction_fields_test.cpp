// The rows for the question of a step: choices, points and tolerances.
#include "ui/window/lesson/prediction_fields.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QStandardItemModel>
#include <QTableWidget>
#include <QTest>

#include "tests/ui/window/lesson/lesson_editor_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/window/lesson/lesson_text.h"

namespace asperity {
namespace {

using PredictionFieldsTest = LessonEditorTest;
using Json = nlohmann::ordered_json;

TEST_F(PredictionFieldsTest, ChoicesAreCheckedInTheWordsOfTheForm) {
  edit(sampleLesson(), 1);
  setCell(1, 2, "abc");
  EXPECT_EQ(errorText(), "Step 1: Choice 2, From: “abc” is not a number");
  EXPECT_EQ(prediction(0).choices[1].above, 1.5);
  setCell(1, 2, "1.5");
  setCell(2, 2, "2");
  EXPECT_TRUE(errorText().starts_with("Step 1: Choice 3: its range overlaps that of choice 2"))
      << errorText();
  setCell(2, 2, "");
  EXPECT_EQ(errorText(), "Step 1: Choice 3: needs a number in From or To, as the others have");
  for (const auto& [row, column] : {std::pair(0, 3), {1, 2}, {1, 3}}) setCell(row, column, "");
  EXPECT_TRUE(errorText().starts_with("Step 1: Choices: tick the right one")) << errorText();
}

/// A tenth of a value is one pixel on an axis of several decades.
TEST_F(PredictionFieldsTest, APointHasAFactorAsItsUsualToleranceAndItsAnswerIsShown) {
  edit(sampleLesson(), 2);
  choose("editorKind", 3);
  EXPECT_EQ(prediction(1).tolerance, 0.2);  // that of the teacher
  editor_->addShownStep();
  choose("editorKind", 3);
  EXPECT_EQ(prediction(2).tolerance, 1);
  choose("editorKind", 2);
  EXPECT_DOUBLE_EQ(prediction(2).tolerance, LessonPrediction{}.tolerance);
  field<QListWidget>("editorSteps").setCurrentRow(3);
  editor_->removeStep();
  field<QListWidget>("editorSteps").setCurrentRow(2);
  auto& said = field<QLabel>("editorComputed");
  EXPECT_TRUE(waitFor([&] { return said.text().contains("The program finds"); }));
  EXPECT_TRUE(said.text().contains(" at "));
}

/// What is said above a field that cannot be read is not of the value before.
TEST_F(PredictionFieldsTest, AnAnswerToAnotherPlaceIsNotShown) {
  edit(sampleWithPeak(), 2);
  auto& said = field<QLabel>("editorComputed");
  ASSERT_TRUE(waitFor([&] { return said.text().contains("The program finds"); }));
  EXPECT_TRUE(said.text().contains("within a factor of 1.5")) << said.text().toStdString();
  type("editorX", "abc");
  EXPECT_TRUE(errorText().find("not a number") != std::string::npos) << errorText();
  EXPECT_FALSE(said.text().contains("The program finds")) << said.text().toStdString();
  EXPECT_FALSE(said.text().contains("1.5"));
  EXPECT_TRUE(said.isVisibleTo(editor_));  // what is below does not move
}

TEST_F(PredictionFieldsTest, TheDeleteKeyEmptiesTheCellsOfTheChoices) {
  edit(sampleLesson(), 1);
  auto& table = field<QTableWidget>("editorChoices");
  ASSERT_TRUE(waitFor([&] {
    editor_->activateWindow();
    return editor_->isActiveWindow();
  }));
  table.setFocus();
  table.setCurrentCell(2, 0);
  QTest::keyClick(&table, Qt::Key_Delete);
  EXPECT_EQ(table.item(2, 0)->text(), "");
  EXPECT_EQ(prediction(0).choices.size(), 2U);
}

TEST_F(PredictionFieldsTest, ALongChoiceIsShownAsAWhole) {
  edit(sampleLesson(), 1);
  const auto& table = field<QTableWidget>("editorChoices");
  const auto showsAll = [&] {
    return table.verticalHeader()->length() <= table.viewport()->height();
  };
  ASSERT_TRUE(waitFor([&] { return table.isVisible() && showsAll(); }));
  const int height = table.rowHeight(0);
  setCell(0, 0,
          QStringLiteral("It grows by half or more: it doubles, as Amontons says. ").repeated(3));
  EXPECT_TRUE(waitFor([&] { return table.rowHeight(0) > height; })) << table.columnWidth(0);
  EXPECT_TRUE(waitFor(showsAll)) << table.verticalHeader()->length() << " in "
                                 << table.viewport()->height();
  EXPECT_EQ(table.rowHeight(1), height);
  setCell(0, 0, "short");
  EXPECT_TRUE(waitFor([&] { return table.rowHeight(0) == height; }));
}

TEST_F(PredictionFieldsTest, EmptyingManyCellsIsOneEdit) {
  edit(sampleLesson(), 1);
  const std::string before = writeLesson(editor_->lesson());
  auto& table = field<QTableWidget>("editorChoices");
  ASSERT_TRUE(waitFor([&] {
    editor_->activateWindow();
    return editor_->isActiveWindow();
  }));
  table.setFocus();
  table.setCurrentCell(1, 0);
  table.setRangeSelected({1, 0, 2, 3}, true);
  QTest::keyClick(&table, Qt::Key_Delete);
  EXPECT_EQ(prediction(0).choices.size(), 1U);
  EXPECT_EQ(table.item(1, 2)->text(), "");
  editor_->undo();
  EXPECT_EQ(writeLesson(editor_->lesson()), before);
  EXPECT_EQ(table.item(1, 0)->text(), "twice");
}

/// A choice keeps its translation where the one above it is removed.
TEST_F(PredictionFieldsTest, TranslationsStayWithTheirChoices) {
  Json json = sampleLesson();
  json["steps"][0]["prediction"]["choices"][2]["text"] = {{"en", "more"}, {"de", "mehr"}};
  edit(json, 1);
  setCell(1, 0, "");
  setCell(2, 0, "much more");
  const auto& choices = prediction(0).choices;
  ASSERT_EQ(choices.size(), 2U);
  EXPECT_EQ(choices[0].text, (LessonText{"same", ""}));
  EXPECT_EQ(choices[1].text, (LessonText{"much more", "mehr"}));
}

/// What is hidden stays hidden only where the teacher sees that it does.
TEST_F(PredictionFieldsTest, AllSettingsOfAPointCanBeSeenAndChanged) {
  edit(sampleWithPeak(), 2);
  auto& hides = field<QComboBox>("editorHides");
  EXPECT_TRUE(hides.isEnabled());
  EXPECT_FALSE(qobject_cast<QStandardItemModel*>(hides.model())->item(0)->isEnabled());
  choose("editorHides", 2);
  EXPECT_TRUE(editor_->lesson().steps[1].show.hidesCurveAfter);
  choose("editorHides", 1);
  EXPECT_FALSE(editor_->lesson().steps[1].show.hidesCurveAfter);
  auto& place = field<QLineEdit>("editorPlaceTolerance");
  EXPECT_TRUE(place.isVisibleTo(editor_));
  EXPECT_EQ(place.text(), "80");
  type("editorPlaceTolerance", "30");
  EXPECT_DOUBLE_EQ(prediction(1).xTolerance, 0.3);
  type("editorX", "0.1");
  EXPECT_FALSE(place.isVisibleTo(editor_));
  choose("editorKind", 2);
  EXPECT_TRUE(qobject_cast<QStandardItemModel*>(hides.model())->item(0)->isEnabled());
}

TEST_F(PredictionFieldsTest, ACurveThatShowsTheAnswerIsHiddenOrTheFormSaysSo) {
  Json json = sampleLesson();
  json["steps"][1] = {{"text", "Look."}};
  edit(json, 2);
  const auto& view = editor_->lesson().steps[1].show;
  const auto says = [&] { return field<QLabel>("editorComputed").text().contains("in sight"); };
  choose("editorKind", 1);  // a choice that nothing computes
  EXPECT_FALSE(view.hidesCurve);
  choose("editorKind", 2);
  EXPECT_TRUE(view.hidesCurve);
  EXPECT_EQ(field<QComboBox>("editorHides").currentIndex(), 1);
  EXPECT_FALSE(says());
  choose("editorHides", 0);  // the teacher's own choice stays
  EXPECT_FALSE(view.hidesCurve);
  EXPECT_TRUE(says());
  auto& column = field<QComboBox>("editorColumn");
  choose("editorColumn", column.findData("indentation"));
  EXPECT_FALSE(view.hidesCurve);
  EXPECT_FALSE(says());
}

}  // namespace
}  // namespace asperity
