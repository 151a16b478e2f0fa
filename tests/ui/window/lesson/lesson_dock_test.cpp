// The dock of a lesson: its buttons have a fixed place, it shares the height with the parameters,
// and its title is one.
#include "ui/window/lesson/lesson_dock.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>

#include "core/lesson/lesson_file.h"
#include "tests/core/lesson/lesson_samples.h"
#include "tests/ui/window/qt_application.h"
#include "tests/ui/window/window_in.h"
#include "ui/window/lesson/lessons.h"
#include "ui/window/main/scene_library.h"

namespace asperity {
namespace {

constexpr QSize kSmallWindow(1024, 700);
constexpr int kSettled = 1500;  // ms, until a layout has settled

/// The border above the parameters moves with their number, the buttons below them do not.
TEST(LessonDockOfAStep, ItsButtonsStayWhereAStepFreesMoreParameters) {
  nlohmann::ordered_json json = sampleLesson();
  json["steps"][1].erase("prediction");
  json["steps"][1]["controls"]["free"] = {"sliding.velocity", "load.normal_force", "surface.hurst",
                                          "surface.rms_height", "elastomer.shear_modulus"};
  WindowIn window("en");
  window->resize(kSmallWindow);
  Lessons& lessons = window->lessons();
  lessons.start(lessonOf(json));
  const auto& next = *window->findChild<QPushButton*>("lessonNext");
  const auto& parameters = *window->findChild<QDockWidget*>("parameterDock");
  const auto place = [&] { return next.mapTo(&*window, QPoint()); };
  ASSERT_TRUE(QTest::qWaitFor([&] { return next.isVisible() && place().y() > 0; }));
  QTest::qWait(kSettled);
  const QPoint before = place();
  const int height = parameters.height();
  lessons.player().show(1);
  EXPECT_TRUE(QTest::qWaitFor([&] { return parameters.height() > height; }, kSettled));
  EXPECT_EQ(place(), before);
  EXPECT_GT(before.y(), parameters.geometry().bottom());
}

/// The step speaks of two parameters. The warning of the first one comes later, and pushed the
/// second one out of sight.
TEST(LessonDockOfAStep, AWarningThatComesLaterLeavesTheParametersInSight) {
  constexpr int kPlateau = 5;
  WindowIn window("en");
  window->resize(kSmallWindow);
  ASSERT_TRUE(QTest::qWaitForWindowActive(&*window));
  Lessons& lessons = window->lessons();
  lessons.start(readNamedLesson("rubber_is_not_coulomb", readNamedScene), kPlateau);
  window->findChild<QPushButton*>("lessonShow")->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return lessons.player().isRevealed(); }, kWindowPatience));
  const auto& modulus = *window->findChild<QWidget*>("row:elastomer.shear_modulus");
  const auto isInSight = [&] { return modulus.visibleRegion().boundingRect() == modulus.rect(); };
  EXPECT_TRUE(QTest::qWaitFor(isInSight, kSettled));
  QTest::qWait(kSettled);  // the warning is there
  EXPECT_TRUE(isInSight());
}

/// The parameters are locked until the question is answered. The warning of one of them, which has
/// three lines, pushed the last choice out of sight.
TEST(LessonDockOfAStep, AWarningThatComesLaterLeavesTheChoicesInSight) {
  constexpr int kPlateau = 5;
  WindowIn window("de");
  window->resize(kSmallWindow);
  ASSERT_TRUE(QTest::qWaitForWindowActive(&*window));
  window->lessons().start(readNamedLesson("rubber_is_not_coulomb", readNamedScene), kPlateau);
  const auto isWarned = [&] {
    const auto* warning = window->findChild<QLabel*>("warning:load.normal_force");
    return warning && warning->isVisible();
  };
  ASSERT_TRUE(QTest::qWaitFor(isWarned, kWindowPatience));
  const auto& last = *window->findChild<QRadioButton*>("lessonChoice:2");
  const auto isInSight = [&] { return last.visibleRegion().boundingRect() == last.rect(); };
  EXPECT_TRUE(QTest::qWaitFor(isInSight, kSettled));
}

/// Its colour is that of the text below it, not of what is disabled. It stands above the titles of
/// the steps, which stand above their texts, also in the large letters of a presentation.
TEST(LessonTitle, IsATitle) {
  MainWindow window(smallScene());
  window.show();
  for (const bool dark : {false, true}) {
    window.appearance().setDark(dark);
    auto& title = *window.findChild<QLabel*>("lessonTitle");
    title.ensurePolished();
    const auto colour = [](const QWidget& label) {
      return label.palette().color(QPalette::WindowText);
    };
    EXPECT_EQ(colour(title), colour(*window.findChild<QLabel*>("lessonText")));
    EXPECT_TRUE(title.font().bold());
  }
  const auto size = [&](const char* name) {
    return window.findChild<QLabel*>(name)->font().pointSizeF();
  };
  for (int round = 0; round < 2; ++round) {
    EXPECT_GT(size("lessonTitle"), size("lessonStepTitle"));
    EXPECT_GT(size("lessonStepTitle"), size("lessonText"));
    window.findChild<QAction*>("present")->trigger();
  }
}

}  // namespace
}  // namespace asperity
