// How a student answers: choices by keys alone, and numbers as the language writes them.
#include "ui/window/lesson/answer_input.h"

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QRadioButton>

#include "tests/ui/window/lesson/lessons_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

using AnswerInputTest = LessonsTest;
using Json = nlohmann::ordered_json;

/// By real keys, which are offered to the window's shortcuts first: the space bar pauses.
TEST_F(AnswerInputTest, AChoiceIsMadeAndCheckedByKeysAlone) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  lessons().start(lessonOf(sampleLesson()));
  const bool isPlaying = session().isPlaying();
  auto& first = control<QRadioButton>("lessonChoice:0");
  auto& second = control<QRadioButton>("lessonChoice:1");
  ASSERT_TRUE(first.hasFocus());
  const auto heightOf = [&](QWidget& one) { return one.mapTo(&window_, QPoint()).y(); };
  ASSERT_TRUE(waitFor([&] { return heightOf(second) > heightOf(first); }));
  const auto key = [&](Qt::Key pressed) { QTest::keyClick(window_.windowHandle(), pressed); };
  key(Qt::Key_Down);
  EXPECT_TRUE(second.hasFocus());
  EXPECT_TRUE(second.isChecked());
  key(Qt::Key_Up);
  EXPECT_TRUE(first.isChecked());
  second.setFocus();
  key(Qt::Key_Space);
  EXPECT_TRUE(second.isChecked());
  EXPECT_EQ(session().isPlaying(), isPlaying);
  key(Qt::Key_Tab);
  EXPECT_EQ(QApplication::focusWidget(), &button("lessonShow"));  // the first step has no "Back"
  key(Qt::Key_Tab);
  EXPECT_EQ(QApplication::focusWidget(), &button("lessonNext"));
  key(Qt::Key_Space);
  ASSERT_TRUE(waitForAnswer());
  EXPECT_EQ(player().results().right(), 1);
  EXPECT_EQ(session().isPlaying(), isPlaying);
}

TEST_F(AnswerInputTest, ANumberIsTypedWithOrWithoutItsUnit) {
  lessons().start(lessonOf(sampleLesson()), 1);
  auto& number = control<QLineEdit>("lessonNumber");
  EXPECT_FALSE(showsCurve());
  QTest::keyClicks(&number, "much");
  click("lessonNext");
  EXPECT_FALSE(player().isRevealed());
  EXPECT_TRUE(said("lessonNote").contains("number"));
  number.selectAll();
  QTest::keyClicks(&number, "0.3 um");
  QTest::keyClick(&number, Qt::Key_Return);
  ASSERT_TRUE(waitForAnswer());
  EXPECT_DOUBLE_EQ(player().results().find(1)->given.number, 3e-7);
  ASSERT_TRUE(waitFor([&] { return showsCurve(); }));
}

/// Groups of thousands are those of the language, and the pane says how it reads them.
TEST_F(AnswerInputTest, ANumberIsReadAsTheLanguageWritesIt) {
  Json json = sampleLesson();
  const auto begin = [&](const char* language) {
    useLanguage(language);
    json["title"] = language;  // another lesson, without answers
    lessons().start(lessonOf(json), 1);
  };
  for (const auto& [language, typed] : {std::pair("en", "2,560 um"), {"de", "2.560 um"}}) {
    begin(language);
    QTest::keyClicks(&control<QLineEdit>("lessonNumber"), typed);
    EXPECT_TRUE(said("lessonNote").contains("2560 um")) << said("lessonNote").toStdString();
    click("lessonNext");
    ASSERT_TRUE(waitForAnswer());
    EXPECT_DOUBLE_EQ(player().results().find(1)->given.number, 2.56e-3);
  }
  json["goal"] = "another one";
  begin("de");
  QTest::keyClicks(&control<QLineEdit>("lessonNumber"), "2,560 um");
  EXPECT_TRUE(said("lessonNote").contains("2,56 um")) << said("lessonNote").toStdString();
  useLanguage("en");
}

}  // namespace
}  // namespace asperity
