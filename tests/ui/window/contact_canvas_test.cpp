// The contact view driven as by hands: wheel, drag, pinch, keys, menu.
#include "ui/window/contact/contact_canvas.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "core/run/steady_frames.h"
#include "qt_application.h"
#include "tests/ui/window/window_in.h"
#include "ui/contact/contact_signs.h"
#include "ui/draw/fonts.h"
#include "ui/language/translated.h"

namespace asperity {
namespace {

std::shared_ptr<const Frame> frameOf(std::int64_t index = 0) {
  Scene scene;
  scene.surface.elements = 500;
  scene.load.normalForce = 0.1;
  static const SteadyFrames frames(std::make_shared<const Scene>(scene));
  return std::make_shared<const Frame>(frames.frame(index, 60, 25));
}

class ContactCanvasTest : public testing::Test {
 protected:
  void SetUp() override {
    canvas_.resize(900, 500);
    addContactViewActions(canvas_, menu_);
    canvas_.setFrame(frameOf());
    canvas_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&canvas_));
  }

  ContactView view() const { return canvas_.viewer().options().view; }

  QPointF place(double x, double y) const {
    const QRectF plot = canvas_.plotArea();
    return {plot.left() + x * plot.width(), plot.bottom() - y * plot.height()};
  }

  void turnWheel(QPointF at, int steps, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QWheelEvent event(at, canvas_.mapToGlobal(at), {}, {0, 120 * steps}, Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&canvas_, &event);
  }

  QAction& action(const char* name) { return *canvas_.findChild<QAction*>(name); }

  ContactCanvas canvas_;
  QMenu menu_;
};

TEST_F(ContactCanvasTest, PlotAreaIsInsideTheWidget) {
  EXPECT_TRUE(QRectF(canvas_.rect()).contains(canvas_.plotArea()));
  EXPECT_GT(canvas_.plotArea().width(), 600);
}

/// What changes with the frame is then painted together with its picture.
TEST_F(ContactCanvasTest, AFrameIsShownWhenItsPictureIsReady) {
  std::vector<std::shared_ptr<const Frame>> shown;
  QObject::connect(&canvas_, &ContactCanvas::frameShown, &canvas_,
                   [&](const std::shared_ptr<const Frame>& frame) { shown.push_back(frame); });
  ASSERT_TRUE(QTest::qWaitFor([&] { return canvas_.framesPerSecond() > 0; }));
  shown.clear();
  const QImage before = canvas_.grab().toImage();
  const std::shared_ptr<const Frame> next = frameOf(5);
  canvas_.setFrame(next);
  if (shown.empty()) {  // it is drawn in the background
    EXPECT_EQ(canvas_.grab().toImage(), before);
  }
  ASSERT_TRUE(QTest::qWaitFor([&] { return !shown.empty(); }));
  EXPECT_NE(canvas_.grab().toImage(), before);
  canvas_.zoom(1);
  QTest::qWait(100);
  EXPECT_EQ(shown, std::vector{next}) << "another picture of the same frame";
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

/// With large texts the plot is elsewhere, and the cursor with it.
TEST_F(ContactCanvasTest, CursorMeetsThePlotAtAnyTextSize) {
  canvas_.setTextScale(1.6);
  QTest::mouseMove(&canvas_, place(0.25, 0.5).toPoint());
  ASSERT_TRUE(canvas_.viewer().reading());
  EXPECT_NEAR(*canvas_.viewer().pointer(), 0.25 * frameOf()->length, 0.003 * frameOf()->length);
  ContactPictureOptions options = canvas_.viewer().options();
  options.width = canvas_.width();
  options.height = canvas_.height();
  options.scale = 1.6F;
  EXPECT_EQ(contactPlotArea(*canvas_.frame(), options).x, canvas_.plotArea().x());
}

TEST_F(ContactCanvasTest, WheelZoomsAtTheCursor) {
  const QPointF at = place(0.7, 0.4);
  const double x = view().left + 0.7 * view().width;
  turnWheel(at, 4);
  EXPECT_NEAR(view().width, frameOf()->length / std::pow(1.25, 4), 1e-9);
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
  EXPECT_NEAR(std::remainder(view().left - left + 0.1 * width, frameOf()->length), 0, 1e-9);
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
  EXPECT_NEAR(std::remainder(view().left - before.left + moved, frameOf()->length), 0,
              0.02 * moved);
  QTest::mouseMove(&canvas_, from);  // no longer held
  EXPECT_NEAR(std::remainder(view().left - before.left + moved, frameOf()->length), 0,
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
  EXPECT_NEAR(view().width, frameOf()->length / (1.1 * 1.25 * 1.2), 1e-9);
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
  canvas->setFrame(frameOf());
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
  EXPECT_NEAR(seen().width * 360 / 120, frameOf()->length, 0.1 * frameOf()->length);
  EXPECT_NEAR(seen().left + 0.5 * seen().width, middle, 0.1 * seen().width);
  const double closest = seen().width;
  for (int apart = 350; apart >= 180; apart -= 10) move(apart);
  EXPECT_NEAR(seen().width, 2 * closest, 0.1 * closest);
  const auto [left, right] = fingers(180);
  QTest::touchEvent(canvas, screen).release(0, left, canvas).release(1, right, canvas);
}

/// What a reading means is told where it stands, and nothing elsewhere.
TEST_F(ContactCanvasTest, ReadingsExplainThemselves) {
  const auto tipAt = [&](QPointF position) {
    QHelpEvent help(QEvent::ToolTip, position.toPoint(), canvas_.mapToGlobal(position.toPoint()));
    QApplication::sendEvent(&canvas_, &help);
    return QToolTip::text();
  };
  ContactPictureOptions options = canvas_.viewer().options();
  options.width = canvas_.width();
  options.height = canvas_.height();
  for (const ContactSign& reading : contactReadings(*canvas_.frame(), options)) {
    const Box& box = reading.box;
    const QString tip = tipAt({box.x + 0.5 * box.width, box.y + 0.5 * box.height});
    const QString said = keptTogether(QString::fromStdString(reading.tip)).toHtmlEscaped();
    EXPECT_TRUE(tip.contains(said)) << reading.name;
  }
  tipAt(place(0.5, 0.5));  // in the plot: whatever was told is taken away
  EXPECT_TRUE(QTest::qWaitFor([] { return !QToolTip::isVisible(); }));
}

/// A tip covers neither the text that it explains nor, at the vertical axis, the numbers.
TEST_F(ContactCanvasTest, TipsStandBesideWhatTheyExplain) {
  int count = 0;
  for (const ContactSign& sign : contactSigns(*canvas_.frame(), shownOptions(canvas_))) {
    const QRect box = QRectF(sign.box.x, sign.box.y, sign.box.width, sign.box.height).toRect();
    const QPoint at = box.topLeft() + QPoint(1, 1);
    QHelpEvent help(QEvent::ToolTip, at, canvas_.mapToGlobal(at));
    QApplication::sendEvent(&canvas_, &help);
    const QWidgetList windows = QApplication::topLevelWidgets();
    const auto tip = std::ranges::find_if(windows, [](const QWidget* window) {
      return window->inherits("QTipLabel") && window->isVisible();
    });
    ASSERT_NE(tip, windows.end()) << sign.name;
    const QRect shown(canvas_.mapFromGlobal((*tip)->pos()), (*tip)->size());
    EXPECT_FALSE(shown.intersects(box)) << sign.name;
    if (sign.id == "height above the surface")
      EXPECT_GE(shown.left(), std::floor(canvas_.plotArea().left()));
    ++count;
  }
  EXPECT_GE(count, 8);
}

/// The legend of the colours and the labels have formula and sentence; the menu leads to the guide.
TEST_F(ContactCanvasTest, SignsExplainThemselvesAndLeadToTheGuide) {
  const ContactPictureOptions options = shownOptions(canvas_);
  QStringList read;
  QObject::connect(&canvas_, &ContactCanvas::guideRequested, &canvas_,
                   [&](const QString& anchor) { read += anchor; });
  int count = 0;
  for (const ContactSign& sign : contactSigns(*canvas_.frame(), options)) {
    if (sign.id != "line load" && sign.id != "rigid body") continue;
    ++count;
    const QPoint at = middleOf(sign.box);
    QHelpEvent help(QEvent::ToolTip, at, canvas_.mapToGlobal(at));
    QApplication::sendEvent(&canvas_, &help);
    const HoverExplanation explanation = *findExplanation(sign.id);
    EXPECT_TRUE(QToolTip::text().contains(QString::fromStdString(sign.name).toHtmlEscaped()));
    EXPECT_TRUE(QToolTip::text().contains(formulaHtml(explanation.formula))) << sign.name;
    canvas_.setContextMenuPolicy(Qt::NoContextMenu);  // a menu would wait for an answer
    QContextMenuEvent asked(QContextMenuEvent::Mouse, at, canvas_.mapToGlobal(at));
    QApplication::sendEvent(&canvas_, &asked);
    canvas_.findChild<QAction*>("aboutContact")->trigger();
    ASSERT_FALSE(read.isEmpty());
    EXPECT_EQ(read.last(), anchorText(explanation)) << sign.name;
  }
  EXPECT_EQ(count, 2);
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
  EXPECT_NEAR(*canvas_.viewer().pointer(), 0.25 * frameOf()->length, 0.002 * frameOf()->length);
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

TEST_F(ContactCanvasTest, CommandsSwitchAndShowWhatIsOn) {
  action("magnify").trigger();
  EXPECT_TRUE(canvas_.viewer().magnifies());
  EXPECT_TRUE(action("magnify").isChecked());
  action("followLine").trigger();
  EXPECT_TRUE(canvas_.viewer().navigation().followsLine());
  canvas_.magnify(false);
  EXPECT_FALSE(action("magnify").isChecked());
  action("steeper").trigger();
  EXPECT_FALSE(canvas_.viewer().navigation().hasFittedHeights());
  action("fitHeights").trigger();
  EXPECT_TRUE(canvas_.viewer().navigation().hasFittedHeights());
}

TEST_F(ContactCanvasTest, ColoursAskForTheirFields) {
  QSignalSpy wanted(&canvas_, &ContactCanvas::fieldsChanged);
  menu_.findChild<QAction*>();
  const auto trigger = [this](const char* name) {
    for (QAction* one : canvas_.findChildren<QAction*>(name)) one->trigger();
  };
  trigger("overlay:power");
  EXPECT_EQ(canvas_.viewer().overlay(), ContactOverlay::Power);
  ASSERT_EQ(wanted.count(), 1);
  EXPECT_TRUE(wanted.back()[0].value<FrameFields>().power);
  action("nextOverlay").trigger();
  EXPECT_EQ(canvas_.viewer().overlay(), ContactOverlay::None);
  action("nextOverlay").trigger();
  EXPECT_EQ(canvas_.viewer().overlay(), ContactOverlay::Pressure);
  EXPECT_EQ(canvas_.fields(), FrameFields{});
}

TEST_F(ContactCanvasTest, EveryCommandSaysWhatItDoesAndKeysAreTheirOwn) {
  QStringList keys;
  for (const QAction* one : canvas_.findChildren<QAction*>()) {
    if (one->isSeparator()) continue;
    EXPECT_FALSE(one->text().isEmpty());
    EXPECT_FALSE(one->toolTip().isEmpty());
    for (const QKeySequence& key : one->shortcuts()) keys += key.toString();
  }
  const auto count = keys.size();
  EXPECT_EQ(keys.removeDuplicates(), 0) << count;
}

/// Every change is drawn: sooner or later the picture is another one.
TEST_F(ContactCanvasTest, DrawsWhatIsChosen) {
  ASSERT_FALSE(canvas_.backendName().isEmpty());
  QSignalSpy painted(&canvas_, &ContactCanvas::painted);
  canvas_.setFrame(frameOf());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !painted.empty(); }, 20000));
  const auto picture = [&] { return canvas_.grab().toImage(); };
  const auto differsFrom = [&](const QImage& before) {
    return QTest::qWaitFor([&] { return picture() != before; }, 20000);
  };
  const QImage plain = picture();
  action("magnify").trigger();
  ASSERT_TRUE(differsFrom(plain));
  const QImage magnified = picture();
  turnWheel(place(0.5, 0.4), 5);
  EXPECT_TRUE(differsFrom(magnified));
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

class DraggedCanvasTest : public ContactCanvasTest {
 protected:
  void SetUp() override {
    ContactCanvasTest::SetUp();
    scene_ = *frameOf()->scene;
    canvas_.setScene(scene_);
    QObject::connect(&canvas_, &ContactCanvas::sceneEdited, &canvas_, [this](const Scene& scene) {
      scene_ = scene;
      ++edits_;
      canvas_.setScene(scene);
    });
  }

  /// The middle of the label or arrow that changes this.
  QPoint handle(ContactHandle wanted) {
    const std::optional<QPoint> place = handleIn(canvas_, wanted);
    EXPECT_TRUE(place) << "no handle";
    return place.value_or(QPoint());
  }

  void drag(QPoint from, QPoint by) {
    QTest::mouseMove(&canvas_, from);
    QTest::mousePress(&canvas_, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 4; ++i) QTest::mouseMove(&canvas_, from + by * i / 4);
  }
  void drop(QPoint at) { QTest::mouseRelease(&canvas_, Qt::LeftButton, {}, at); }

  Scene scene_;
  int edits_ = 0;
};

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

TEST_F(DraggedCanvasTest, TheTipSaysBeforehandWhatADragWillDo) {
  const auto tip = [&](QPoint at) {
    QHelpEvent event(QEvent::ToolTip, at, canvas_.mapToGlobal(at));
    QApplication::sendEvent(&canvas_, &event);
    return QToolTip::text();
  };
  EXPECT_TRUE(tip(handle(ContactHandle::Velocity)).contains("faster"));
  EXPECT_TRUE(tip(handle(ContactHandle::Force)).contains("press harder"));
  EXPECT_TRUE(tip(place(0.3, 0.97).toPoint()).contains("sideways"));
}

/// Over the body the readout of the crosshair stays alone; what a drag does is said elsewhere. A
/// tooltip takes the readout's place until the pointer moves on.
TEST_F(DraggedCanvasTest, OneBoxStandsOverTheContact) {
  QSignalSpy said(&canvas_, &ContactCanvas::statusMessage);
  const auto rest = [&](QPoint at) {
    QTest::mouseMove(&canvas_, at + QPoint(1, 1));  // the pointer may be there already
    QTest::mouseMove(&canvas_, at);
    EXPECT_TRUE(canvas_.viewer().pointer());
    QHelpEvent event(QEvent::ToolTip, at, canvas_.mapToGlobal(at));
    QApplication::sendEvent(&canvas_, &event);
  };
  rest(place(0.3, 0.97).toPoint());
  EXPECT_TRUE(canvas_.viewer().pointer());
  EXPECT_TRUE(QTest::qWaitFor([] { return !QToolTip::isVisible(); }));
  ASSERT_EQ(said.count(), 1);
  EXPECT_TRUE(said[0][0].toString().contains("press harder"));
  // A drag needs the hint no more, and another handle does something else.
  drag(handle(ContactHandle::Velocity), {5, 0});
  drop(handle(ContactHandle::Velocity) + QPoint(5, 0));
  ASSERT_EQ(said.count(), 2);
  EXPECT_TRUE(said[1][0].toString().isEmpty());
  rest(handle(ContactHandle::Force));
  EXPECT_TRUE(QToolTip::text().contains("press harder"));
  EXPECT_FALSE(canvas_.viewer().pointer());
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

TEST_F(DraggedCanvasTest, KeysDoTheSame) {
  const Scene start = scene_;
  action("pressHarder").trigger();
  EXPECT_GT(scene_.load.normalForce, start.load.normalForce);
  EXPECT_TRUE(canvas_.accessibleDescription().contains("normal force"));
  action("pressLess").trigger();
  EXPECT_NEAR(scene_.load.normalForce, start.load.normalForce, 1e-3 * start.load.normalForce);
  action("slideFaster").trigger();
  EXPECT_GT(scene_.sliding.velocity, start.sliding.velocity);
  action("slideSlower").trigger();
  action("slideSlower").trigger();
  EXPECT_LT(scene_.sliding.velocity, start.sliding.velocity);
}

}  // namespace
}  // namespace asperity
