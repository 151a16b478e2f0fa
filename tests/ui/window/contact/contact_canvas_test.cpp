// The contact view driven as by hands: wheel, drag, pinch, keys, menu.
#include "ui/window/contact/contact_canvas.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QFontInfo>
#include <QImage>
#include <QLabel>
#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>
#include <cmath>

#include "core/run/steady_frames.h"
#include "tests/ui/window/contact/contact_canvas_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "tests/ui/window/window_in.h"
#include "ui/contact/contact_signs.h"
#include "ui/draw/fonts.h"
#include "ui/language/translated.h"

namespace asperity {
namespace {

TEST_F(ContactCanvasTest, PlotAreaIsInsideTheWidget) {
  EXPECT_TRUE(QRectF(canvas_.rect()).contains(canvas_.plotArea()));
  EXPECT_GT(canvas_.plotArea().width(), 600);
}

/// Lines of the picture shine through the veil, but not through the plate of its text.
TEST_F(ContactCanvasTest, TheTextOfTheVeilStandsOnAPlate) {
  auto& veil = *canvas_.findChild<QLabel*>("contactVeil");
  for (const Theme& theme : {lightTheme(), darkTheme()}) {
    canvas_.setTheme(theme);
    canvas_.setVeil(QStringLiteral("The changed scene cannot be computed"));
    QImage drawn(veil.size(), QImage::Format_RGB32);
    drawn.fill(Qt::magenta);
    veil.render(&drawn, {}, {}, QWidget::DrawChildren);
    const QRgb plate = toQColor(theme.background).rgb();
    const int middle = drawn.height() / 2;
    EXPECT_NE(drawn.pixel(5, middle), plate);
    const int left =
        (drawn.width() - veil.fontMetrics().horizontalAdvance(veil.text())) / 2 - 3;  // of its text
    EXPECT_EQ(drawn.pixel(left, middle), plate);
  }
}

/// With large texts the plot is elsewhere, and the cursor with it. The numbers have the letters of
/// the font, as those of the chart.
TEST_F(ContactCanvasTest, CursorMeetsThePlotAtAnyTextSize) {
  canvas_.setTextScale(1.6);
  QTest::mouseMove(&canvas_, place(0.25, 0.5).toPoint());
  ASSERT_TRUE(canvas_.viewer().reading());
  EXPECT_NEAR(*canvas_.viewer().pointer(), 0.25 * sampleContact()->length,
              0.003 * sampleContact()->length);
  ContactPictureOptions options = canvas_.viewer().options();
  options.width = canvas_.width();
  options.height = canvas_.height();
  options.scale = 1.6F;
  options.fontSize = static_cast<float>(QFontInfo(canvas_.font()).pixelSize());
  EXPECT_EQ(contactPlotArea(*canvas_.frame(), options).x, canvas_.plotArea().x());
}

TEST_F(ContactCanvasTest, WheelZoomsAtTheCursor) {
  const QPointF at = place(0.7, 0.4);
  const double x = view().left + 0.7 * view().width;
  turnWheel(at, 4);
  EXPECT_NEAR(view().width, sampleContact()->length / std::pow(1.25, 4), 1e-9);
  // The axis' labels may have moved the plot by some pixels.
  EXPECT_NEAR(view().left + 0.7 * view().width, x, 0.02 * view().width);
  turnWheel(at, -20);
  EXPECT_TRUE(canvas_.viewer().navigation().isFitted());
}

TEST_F(ContactCanvasTest, WheelWithControlExaggeratesAndWithShiftMoves) {
  const ContactView before = view();
  turnWheel(place(0.5, 0.5), 2, Qt::ControlModifier);
  EXPECT_EQ(view().width, before.width);
  EXPECT_NEAR((before.top - before.bottom) / (view().top - view().bottom), 1.5625, 1e-6);
  turnWheel(place(0.5, 0.5), 6);
  const double left = view().left, width = view().width;
  turnWheel(place(0.5, 0.5), 1, Qt::ShiftModifier);
  EXPECT_NEAR(std::remainder(view().left - left + 0.1 * width, sampleContact()->length), 0, 1e-9);
  EXPECT_EQ(view().width, width);
}

TEST_F(ContactCanvasTest, DraggingMovesWhatIsUnderTheCursor) {
  turnWheel(place(0.5, 0.5), 6);
  const ContactView before = view();
  const QPoint from = place(0.5, 0.5).toPoint(), to = from + QPoint(100, 0);
  QTest::mousePress(&canvas_, Qt::LeftButton, {}, from);
  QTest::mouseMove(&canvas_, to);
  QTest::mouseRelease(&canvas_, Qt::LeftButton, {}, to);
  const double moved = 100 / canvas_.plotArea().width() * before.width;
  EXPECT_NEAR(std::remainder(view().left - before.left + moved, sampleContact()->length), 0,
              0.02 * moved);
  QTest::mouseMove(&canvas_, from);  // no longer held
  EXPECT_NEAR(std::remainder(view().left - before.left + moved, sampleContact()->length), 0,
              0.02 * moved);
}

/// As a touchpad's driver tells it: steps of the scale at the cursor.
TEST_F(ContactCanvasTest, APinchOnATouchpadZoomsAtTheCursor) {
  const QPointF at = place(0.7, 0.4);
  const double x = view().left + 0.7 * view().width;
  const auto pinch = [&](double value) {
    QNativeGestureEvent event(Qt::ZoomNativeGesture, QPointingDevice::primaryPointingDevice(), 2,
                              at, at, canvas_.mapToGlobal(at), value, {});
    QApplication::sendEvent(&canvas_, &event);
  };
  for (const double value : {0.1, 0.25, 0.2}) pinch(value);
  EXPECT_NEAR(view().width, sampleContact()->length / (1.1 * 1.25 * 1.2), 1e-9);
  EXPECT_NEAR(view().left + 0.7 * view().width, x, 0.02 * view().width);
  for (int i = 0; i < 8; ++i) pinch(-0.2);
  EXPECT_TRUE(canvas_.viewer().navigation().isFitted());
}

/// Two fingers on a touch screen, through Qt's own recognition of gestures, with the view inside of
/// a window as it always is.
TEST_F(ContactCanvasTest, TwoFingersZoomBetweenThem) {
  static QPointingDevice* const screen = QTest::createTouchDevice();
  QWidget window;
  auto* canvas = new ContactCanvas(&window);
  canvas->resize(900, 500);
  canvas->setFrame(sampleContact());
  window.resize(900, 500);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  const auto seen = [&] { return canvas->viewer().options().view; };
  const QPoint at = canvas->plotArea().center().toPoint();
  const double middle = seen().left + 0.5 * seen().width;
  const auto fingers = [&](int apart) {
    return std::pair{at - QPoint(apart / 2, 0), at + QPoint(apart / 2, 0)};
  };
  const auto move = [&](int apart) {
    const auto [first, second] = fingers(apart);
    QTest::touchEvent(canvas, screen).move(0, first, canvas).move(1, second, canvas);
  };
  const auto [first, second] = fingers(120);
  QTest::touchEvent(canvas, screen).press(0, first, canvas).press(1, second, canvas);
  for (int apart = 130; apart <= 360; apart += 10) move(apart);
  EXPECT_NEAR(seen().width * 360 / 120, sampleContact()->length, 0.1 * sampleContact()->length);
  EXPECT_NEAR(seen().left + 0.5 * seen().width, middle, 0.1 * seen().width);
  const double closest = seen().width;
  for (int apart = 350; apart >= 180; apart -= 10) move(apart);
  EXPECT_NEAR(seen().width, 2 * closest, 0.1 * closest);
  const auto [left, right] = fingers(180);
  QTest::touchEvent(canvas, screen).release(0, left, canvas).release(1, right, canvas);
}

TEST_F(ContactCanvasTest, DoubleClickShowsAll) {
  turnWheel(place(0.5, 0.5), 6);
  QTest::mouseDClick(&canvas_, Qt::LeftButton, {}, place(0.4, 0.5).toPoint());
  EXPECT_TRUE(canvas_.viewer().navigation().isFitted());
}

TEST_F(ContactCanvasTest, CursorReadsAndLeavingEndsIt) {
  QSignalSpy wanted(&canvas_, &ContactCanvas::fieldsChanged);
  QTest::mouseMove(&canvas_, place(0.25, 0.5).toPoint());
  ASSERT_TRUE(canvas_.viewer().reading());
  EXPECT_NEAR(*canvas_.viewer().pointer(), 0.25 * sampleContact()->length,
              0.002 * sampleContact()->length);
  ASSERT_EQ(wanted.count(), 1);  // the slopes, once
  EXPECT_TRUE(canvas_.fields().lineSlope);
  QTest::mouseMove(&canvas_, {2, 2});  // in the header
  EXPECT_FALSE(canvas_.viewer().reading());
  EXPECT_EQ(wanted.count(), 2);
}

TEST_F(ContactCanvasTest, KeysMoveZoomAndRead) {
  const ContactView whole = view();
  for (int i = 0; i < 3; ++i) action("zoomIn").trigger();
  EXPECT_NEAR(view().width, whole.width / std::pow(1.25, 3), 1e-9);
  const double left = view().left;
  QTest::keyClick(&canvas_, Qt::Key_Right);
  EXPECT_NEAR(std::remainder(view().left - left - 0.1 * view().width, whole.width), 0, 1e-9);
  const double size = view().top - view().bottom;
  QTest::keyClick(&canvas_, Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_NEAR(view().top - view().bottom, size / 1.25, 1e-12);
  QTest::keyClick(&canvas_, Qt::Key_Right, Qt::ControlModifier);
  ASSERT_TRUE(canvas_.viewer().reading());
  const std::size_t point = canvas_.viewer().reading()->point;
  QTest::keyClick(&canvas_, Qt::Key_Left, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(canvas_.viewer().reading()->point + 10, point);
  EXPECT_TRUE(canvas_.accessibleDescription().contains("slope"));
  QTest::keyClick(&canvas_, Qt::Key_Escape);
  EXPECT_FALSE(canvas_.viewer().reading());
  action("zoomFit").trigger();
  EXPECT_TRUE(canvas_.viewer().navigation().isFitted());
}

/// No further frame makes up for it while time is paused.
TEST_F(ContactCanvasTest, ALowPictureLeavesRoomForItsLabelsAtOnce) {
  QSignalSpy painted(&canvas_, &ContactCanvas::painted);
  const auto settledPicture = [&] {
    do {
      painted.clear();
      QTest::qWait(500);
    } while (!painted.isEmpty());
    return canvas_.grab().toImage();
  };
  const ContactView before = view();
  canvas_.resize(900, 240);
  const QImage shown = settledPicture();
  ASSERT_NE(view(), before);
  canvas_.setTextScale(1);  // nothing changes, but the picture is drawn again
  EXPECT_EQ(settledPicture(), shown);
}

// ---- Drags that change the scene

TEST_F(DraggedCanvasTest, TheBodyDraggedDownPressesHarderAndTheTipSaysTheForce) {
  const double before = scene_.load.normalForce;
  const QPoint at = place(0.3, 0.97).toPoint();
  drag(at, {2, 60});
  EXPECT_GT(scene_.load.normalForce, 1.2 * before);
  EXPECT_EQ(canvas_.cursor().shape(), Qt::SizeVerCursor);
  EXPECT_TRUE(QToolTip::text().contains("normal force")) << QToolTip::text().toStdString();
  EXPECT_TRUE(QToolTip::text().contains("N"));
  const ContactView moved = view();
  drop(at + QPoint(2, 60));
  EXPECT_EQ(view(), moved);
  EXPECT_TRUE(canvas_.viewer().navigation().isFitted());
  // There and back is where it was.
  Scene start = scene_;
  const double pressed = scene_.load.normalForce;
  QTest::mousePress(&canvas_, Qt::LeftButton, {}, at);
  QTest::mouseMove(&canvas_, at + QPoint(0, 40));
  EXPECT_NE(scene_.load.normalForce, pressed);
  QTest::mouseMove(&canvas_, at);
  EXPECT_EQ(scene_, start);
  drop(at);
}

TEST_F(DraggedCanvasTest, TheBodyDraggedSidewaysMovesTheViewOnly) {
  turnWheel(place(0.5, 0.5), 3);
  const ContactView before = view();
  const QPoint at = place(0.3, 0.98).toPoint();
  ASSERT_EQ(handleAt(
                *canvas_.frame(),
                [&] {
                  ContactPictureOptions options = canvas_.viewer().options();
                  options.width = canvas_.width();
                  options.height = canvas_.height();
                  return options;
                }(),
                static_cast<float>(at.x()), static_cast<float>(at.y())),
            ContactHandle::Body);
  drag(at, {80, 3});
  drop(at + QPoint(80, 3));
  EXPECT_EQ(edits_, 0);
  EXPECT_NE(view().left, before.left);
}

TEST_F(DraggedCanvasTest, ArrowsSetForceAndVelocity) {
  const Scene start = scene_;
  const QPoint speed = handle(ContactHandle::Velocity);
  QTest::mouseMove(&canvas_, speed);
  EXPECT_EQ(canvas_.cursor().shape(), Qt::SizeHorCursor);
  drag(speed, {100, 0});
  drop(speed + QPoint(100, 0));
  EXPECT_GT(scene_.sliding.velocity, 1.5 * start.sliding.velocity);
  EXPECT_EQ(scene_.load, start.load);
  const QPoint force = handle(ContactHandle::Force);
  drag(force, {0, -50});
  drop(force - QPoint(0, 50));
  EXPECT_LT(scene_.load.normalForce, 0.8 * start.load.normalForce);
}

TEST_F(DraggedCanvasTest, EscapeEndsADragWhereItBegan) {
  const Scene start = scene_;
  const QPoint at = place(0.3, 0.97).toPoint();
  drag(at, {0, 60});
  EXPECT_FALSE(scene_ == start);
  QTest::keyClick(&canvas_, Qt::Key_Escape);
  EXPECT_EQ(scene_, start);
  QTest::mouseMove(&canvas_, at + QPoint(0, 90));  // no longer held
  EXPECT_EQ(scene_, start);
  drop(at);
}

/// An indentation leaves no force to choose.
TEST_F(DraggedCanvasTest, AGivenIndentationIsWhatTheBodyChanges) {
  scene_.load.kind = LoadKind::Indentation;
  scene_.load.depth = 9e-7;
  canvas_.setScene(scene_);
  const QPoint at = place(0.3, 0.97).toPoint();
  const double heights = view().top - view().bottom, plot = canvas_.plotArea().height();
  drag(at, {0, 50});
  drop(at + QPoint(0, 50));
  EXPECT_NEAR(scene_.load.depth, 9e-7 + heights * 50 / plot, 1e-9);
  const Scene now = scene_;
  const QPoint force = handle(ContactHandle::Force);
  drag(force, {0, 30});
  drop(force + QPoint(0, 30));
  EXPECT_EQ(scene_.load.normalForce, now.load.normalForce);
}

}  // namespace
}  // namespace asperity
