// A guess as a point on the chart: dragged or moved by keys, and told right or wrong.
#include <gmock/gmock.h>

#include "tests/ui/window/lesson/lessons_fixture.h"
#include "ui/window/lesson/lesson_pane.h"
#include "ui/window/lesson/prediction_point.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

class LessonPointTest : public LessonsTest {};

TEST_F(LessonPointTest, APointHasThreeDigits) {
  Json json = sampleLesson();
  json["steps"][1]["prediction"] = {{"kind", "point"}, {"question", "Where?"}, {"x", 0.123}};
  lessons().start(lessonOf(json), 1);
  PredictionPoint& point = player().point();
  ASSERT_TRUE(waitFor([&] { return point.isVisible() && chart().y.to == 1; }));
  QTest::keyClick(&point, Qt::Key_Up);
  EXPECT_TRUE(point.accessibleName().contains("at 123 mm/s"))
      << point.accessibleName().toStdString();
}

TEST_F(LessonPointTest, TheLabelOfAPointHidesNoLine) {
  Json json = sampleLesson();
  json["steps"][1]["prediction"] = {{"kind", "point"}, {"question", "Where?"}, {"x", 2e-3}};
  lessons().start(lessonOf(json), 1);
  PredictionPoint& point = player().point();
  click("lessonShow");
  ASSERT_TRUE(waitForAnswer());
  ASSERT_TRUE(waitFor([&] { return showsCurve() && session().friction().progress() >= 1; }));
  const auto isCrossed = [&] {
    (void)point.grab();  // draws it
    const QRectF label = point.label();
    const double present = window_.plotView().mapToPosition(chart().marker->x, 1).x();
    if (label.left() < present && present < label.right()) return true;
    const auto pixel = [&](const DiagramPoint& each) {
      return window_.plotView().mapToPosition(each.x, each.y);
    };
    for (const DiagramSeries& series : chart().series)
      for (std::size_t i = 1; i < series.points.size(); ++i) {
        const QLineF line(pixel(series.points[i - 1]), pixel(series.points[i]));
        for (int part = 0; part <= 100; ++part)
          if (label.contains(line.pointAt(part / 100.0))) return true;
      }
    return false;
  };
  EXPECT_TRUE(waitFor([&] { return !isCrossed(); }));
  EXPECT_FALSE(point.label().isEmpty());
}

TEST_F(LessonPointTest, APointSaysHowCloselyItCounts) {
  lessons().start(sampleWithPoint(false), 1);
  EXPECT_EQ(said("lessonTolerance"),
            "A height within a factor of 1.5 and a place within a factor of 2 count as right.");
  lessons().start(sampleWithPoint(true), 1);
  EXPECT_EQ(said("lessonTolerance"), "A height within a factor of 1.5 counts as right.");
  lessons().start(lessonOf(sampleLesson()), 0);  // a choice
  EXPECT_FALSE(control<QLabel>("lessonTolerance").isVisible());
}

TEST_F(LessonPointTest, APointIsDraggedOrMovedByKeysOverTheHiddenCurve) {
  for (const bool hasPlace : {true, false}) {
    lessons().start(sampleWithPoint(hasPlace), 1);
    PredictionPoint& point = player().point();
    ASSERT_TRUE(waitFor([&] {
      return point.isVisible() && session().friction().progress() >= 1 && chart().y.from == 1e-6 &&
             chart().y.to == 1;
    }));
    EXPECT_FALSE(showsCurve());
    EXPECT_FALSE(button("lessonNext").isEnabled());
    const QPoint place = window_.plotView().mapToPosition(0.1, 1e-3).toPoint();
    QTest::mousePress(&point, Qt::LeftButton, {}, place + QPoint(20, 30));
    QTest::mouseMove(&point, place + QPoint(10, 5));
    QTest::mouseRelease(&point, Qt::LeftButton, {}, place);
    ASSERT_TRUE(point.point());
    QTest::mouseClick(&point, Qt::LeftButton, {}, place);
    EXPECT_NEAR(std::log10(point.point()->y()), -3, 0.1);
    EXPECT_NEAR(std::log10(point.point()->x()), -1, hasPlace ? 1e-12 : 0.1);
    const double before = point.point()->y();
    QTest::keyClick(&point, Qt::Key_Up);
    EXPECT_GT(point.point()->y(), before);
    QTest::keyClick(&point, Qt::Key_Down);
    QTest::keyClick(&point, Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_EQ(point.point()->x() > 0.1 * 1.0001, !hasPlace);
    EXPECT_TRUE(point.accessibleName().contains("Where?"));
    const double placed = point.point()->y();
    click("lessonNext");
    ASSERT_TRUE(waitForAnswer());
    EXPECT_EQ(player().results().find(1)->given.number, placed);
    ASSERT_TRUE(waitFor([&] { return showsCurve(); }));
    lessons().end();
    EXPECT_FALSE(point.isVisible());
  }
}

/// By real keys; the Return key does nothing before the point is placed.
TEST_F(LessonPointTest, APointIsPlacedAndCheckedByKeysAlone) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  lessons().start(sampleWithPoint(true), 1);
  ASSERT_TRUE(waitFor(
      [&] { return player().point().isVisible() && window_.plotView().frame().has_value(); }));
  const auto key = [&](Qt::Key pressed) { QTest::keyClick(window_.windowHandle(), pressed); };
  key(Qt::Key_Return);
  EXPECT_FALSE(player().point().point());
  key(Qt::Key_Up);
  ASSERT_TRUE(player().point().point());
  const double placed = player().point().point()->y();
  key(Qt::Key_Return);
  ASSERT_TRUE(waitForAnswer());
  EXPECT_EQ(player().results().find(1)->given.number, placed);
  EXPECT_TRUE(button("lessonNext").hasFocus());
}

TEST_F(LessonPointTest, AGuessStaysOnTheAxis) {
  lessons().start(sampleWithPoint(true), 1);
  PredictionPoint& point = player().point();
  ASSERT_TRUE(waitFor([&] { return point.isVisible() && chart().y.to == 1; }));
  ASSERT_TRUE(waitFor([&] { return session().friction().progress() >= 1; }));
  const std::shared_ptr<const Frame> before = session().frame();
  ASSERT_TRUE(waitFor([&] { return session().frame() != before; }));
  EXPECT_FALSE(said("factMu").contains("mean"));
  const QPoint beside = window_.plotView().mapToPosition(0.1, 1).toPoint() - QPoint(0, 15);
  QTest::mouseClick(&point, Qt::LeftButton, {}, beside);
  EXPECT_FALSE(point.point());  // the legend is no place for an answer
  const QPoint high = window_.plotView().mapToPosition(0.1, 0.8).toPoint();
  QTest::mouseClick(&point, Qt::LeftButton, {}, high);
  ASSERT_TRUE(point.point());
  click("lessonNext");
  ASSERT_TRUE(waitForAnswer());
  ASSERT_TRUE(waitFor([&] { return showsCurve(); }));
  EXPECT_LE(chart().y.from, 1e-6);
  EXPECT_EQ(chart().y.to, 1);
  click("lessonBack");
  ASSERT_TRUE(waitFor([&] { return chart().y.to < 1; }));
}

TEST_F(LessonPointTest, AWrongPointIsNamedWithWhatIsWrongOfIt) {
  LessonPane pane;
  const auto verdict = [&pane](bool hasPlace, double x, double y) {
    const Lesson lesson = sampleWithPoint(hasPlace);
    const LessonAnswer answer{{0.5, ""}, {0.1, "m/s"}, -1, {}};
    const GivenAnswer given{-1, y, x};
    LessonPage page;
    page.lesson = &lesson;
    page.step = 1;
    page.answer = &answer;
    page.given = &given;
    page.isRight = isRight(*lesson.steps[1].prediction, answer, given);
    pane.showStep(page);
    return pane.findChild<QLabel*>("lessonVerdict")->text().toStdString();
  };
  using testing::HasSubstr;
  EXPECT_THAT(verdict(false, 5, 0.5), HasSubstr("at 5"));
  EXPECT_THAT(verdict(false, 5, 0.5), HasSubstr("The height is right, the place is not."));
  EXPECT_THAT(verdict(false, 0.1, 9), HasSubstr("You said 9 at "));
  EXPECT_THAT(verdict(false, 0.1, 9), HasSubstr("The place is right, the height is not."));
  EXPECT_THAT(verdict(false, 5, 9), HasSubstr("Neither the place nor the height is right."));
  EXPECT_THAT(verdict(false, 0.1, 0.5), Not(HasSubstr("place")));
  EXPECT_THAT(verdict(true, 0.1, 9), HasSubstr("You said 9."));
  EXPECT_THAT(verdict(true, 0.1, 9), HasSubstr("The program finds 0.5."));
}

}  // namespace
}  // namespace asperity
