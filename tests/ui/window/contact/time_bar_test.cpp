// The bar of time: pace and slow motion, the moment of a motion, and what the window does with
// them.
#include "ui/window/contact/time_bar.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QGraphicsView>
#include <QHelpEvent>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <QToolTip>
#include <fstream>
#include <sstream>
#include <utility>

#include "core/base/number_text.h"
#include "core/run/runner.h"
#include "core/run/simulation.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/chart/friction_chart_model.h"
#include "ui/draw/ticks.h"
#include "ui/panels/number_text.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/contact/motion_view.h"
#include "ui/window/figures/diagram_view.h"
#include "ui/window/main/scene_tabs.h"
#include "ui/window/main/status_line.h"

namespace asperity {
namespace {

class TimeBarTest : public testing::Test {
 protected:
  TimeBarTest() {
    scene_.sliding.velocity = 1;
    show();
    frame_.length = 0.02;
    bar_.showFrame(frame_);
  }
  void show() { bar_.showScene(scene_); }
  template <class Widget>
  Widget& part(const char* name) {
    return *bar_.findChild<Widget*>(name);
  }
  void type(const QString& text) {
    auto& box = part<QLineEdit>("slowMotion");
    box.setText(text);
    QTest::keyClick(&box, Qt::Key_Return);
  }

  TimeBar bar_;
  Scene scene_;
  Frame frame_;
};

/// 12 s on the screen for the 20 ms of a period.
TEST_F(TimeBarTest, SlowMotionIsThePaceOverTheSimulatedTime) {
  EXPECT_DOUBLE_EQ(bar_.slowMotion(), 12 / 0.02);
  EXPECT_EQ(part<QLineEdit>("slowMotion").text(), QStringLiteral("600× slower"));
  EXPECT_EQ(part<QSlider>("paceSlider").accessibleDescription(), QStringLiteral("600× slower"));
  scene_.sliding.velocity = 0;
  show();
  EXPECT_EQ(bar_.slowMotion(), 0);
  EXPECT_FALSE(part<QLineEdit>("slowMotion").isEnabled());
  EXPECT_FALSE(part<QSlider>("paceSlider").isEnabled()) << "nothing moves at any pace";
}

TEST_F(TimeBarTest, ThePaceStaysWhileTheVelocityChangesOrTheSlowMotionDoes) {
  scene_.sliding.velocity = 2;
  show();
  EXPECT_DOUBLE_EQ(bar_.pace(), 12);
  EXPECT_DOUBLE_EQ(bar_.slowMotion(), 1200);
  part<QCheckBox>("keepPace").setChecked(false);
  QSignalSpy paces(&bar_, &TimeBar::paceChanged);
  scene_.sliding.velocity = 1;
  show();
  EXPECT_DOUBLE_EQ(bar_.slowMotion(), 1200);
  EXPECT_DOUBLE_EQ(bar_.pace(), 24);
  ASSERT_EQ(paces.size(), 1);
  EXPECT_DOUBLE_EQ(paces[0][0].value<std::optional<double>>().value(), 24);
}

/// A pace that only followed the velocity is not that of another scene, nor a constant one.
TEST_F(TimeBarTest, AnotherSceneAndAConstantPaceBringBackTheChosenOne) {
  auto& keeps = part<QCheckBox>("keepPace");
  type("300");
  ASSERT_DOUBLE_EQ(bar_.pace(), 6);
  keeps.setChecked(false);
  scene_.sliding.velocity = 0.003;
  show();
  ASSERT_DOUBLE_EQ(bar_.pace(), 600) << "as slow as it gets";
  Scene other = scene_;
  other.sliding.velocity = 0.02;
  bar_.showOtherScene(other);
  EXPECT_DOUBLE_EQ(bar_.pace(), 6);
  EXPECT_FALSE(keeps.isChecked());
  show();  // and follows from there
  EXPECT_DOUBLE_EQ(bar_.pace(), 6 * 0.02 / 0.003);
  keeps.setChecked(true);
  EXPECT_DOUBLE_EQ(bar_.pace(), 6);
}

/// Even where the user let the line before stand nearly still.
TEST_F(TimeBarTest, AnotherSceneMovesVisibly) {
  auto& slider = part<QSlider>("paceSlider");
  slider.setValue(slider.minimum());
  ASSERT_DOUBLE_EQ(bar_.pace(), 600);
  bar_.showOtherScene(scene_);
  EXPECT_LE(bar_.pace(), 60);
  slider.setValue(slider.maximum());
  const double fast = bar_.pace();
  bar_.showOtherScene(scene_);
  EXPECT_DOUBLE_EQ(bar_.pace(), fast);
}

/// The contact of a motion is known at whole steps: at the usual 12 s many frames would repeat the
/// one before. In a slow motion the least number of steps is the limit, in a fast one the distance
/// between nodes.
TEST_F(TimeBarTest, EachFrameOfAMotionIsAStep) {
  scene_.surface.elements = 60;
  scene_.sliding.velocity = 0;
  scene_.sliding.frequency = 100;
  scene_.sliding.kind = SlidingKind::Oscillation;
  const RunnerOptions options;
  for (const double amplitude : {0.001, 10.0})
    for (const double periods : {2.0, 12.0, 40.0}) {
      scene_.sliding.amplitude = amplitude;
      scene_.sliding.duration = periods / scene_.sliding.frequency;
      bar_.showOtherScene(scene_);
      Simulation simulation(std::make_shared<const Scene>(scene_), 1);
      bar_.showFrame(simulation.frame());
      EXPECT_NEAR(bar_.pace(), 12, 6) << amplitude << " m/s, " << periods;
      const double part = options.secondsPerFrame() / bar_.pace();
      double before = 0, shortest = 1, longest = 0;
      for (int i = 0; i < 100; ++i) {
        simulation.advance(part, options.secondsPerFrame());
        const double time = simulation.frame().time, step = time - std::exchange(before, time);
        if (i < 2) continue;  // rounding may delay the first one
        shortest = std::min(shortest, step);
        longest = std::max(longest, step);
      }
      EXPECT_GT(shortest, 0.999 * longest) << amplitude << " m/s, " << periods << " periods";
    }
  type("100");
  EXPECT_NEAR(bar_.slowMotion(), 100, 1e-9) << "a pace that was chosen is kept";
  bar_.showOtherScene(scene_);
  EXPECT_NEAR(bar_.slowMotion(), 100, 1e-9);
}

TEST_F(TimeBarTest, AFactorIsTypedOrChosen) {
  QSignalSpy paces(&bar_, &TimeBar::paceChanged);
  type("300×");
  EXPECT_DOUBLE_EQ(bar_.pace(), 6);
  type("1e3 x");
  EXPECT_DOUBLE_EQ(bar_.pace(), 20);
  for (const char* nonsense : {"", "fast", "-3", "0", "nan", "inf", "3 fast", "3 slowly"}) {
    type(nonsense);
    EXPECT_DOUBLE_EQ(bar_.pace(), 20) << nonsense;
    EXPECT_EQ(part<QLineEdit>("slowMotion").text(), QStringLiteral("1,000× slower")) << nonsense;
  }
  EXPECT_EQ(paces.size(), 2);
  type("1e12");  // as slow as it gets
  const double slowest = bar_.pace();
  EXPECT_GT(slowest, 60);
  EXPECT_LT(slowest, 1e4);
  EXPECT_EQ(part<QSlider>("paceSlider").value(), part<QSlider>("paceSlider").minimum());
  QTest::keyClick(&part<QSlider>("paceSlider"), Qt::Key_Right);  // to the right faster
  EXPECT_LT(bar_.pace(), slowest);
}

/// What was not taken, or not as it was typed, is said.
TEST_F(TimeBarTest, ARefusedPaceIsSaid) {
  QSignalSpy said(&bar_, &TimeBar::statusMessage);
  type("abc");
  type("-3");
  ASSERT_EQ(said.count(), 2);
  EXPECT_TRUE(said[0][0].toString().contains("abc"));
  EXPECT_TRUE(said[1][0].toString().contains("-3"));
  type("5");  // a period would take less time than can be seen
  ASSERT_EQ(said.count(), 3);
  EXPECT_DOUBLE_EQ(bar_.slowMotion(), 100);
  EXPECT_TRUE(said[2][0].toString().contains("100× slower is chosen"))
      << said[2][0].toString().toStdString();
  bar_.show();
  bar_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&bar_));
  type("5");
  ASSERT_EQ(said.count(), 4);
  EXPECT_TRUE(QTest::qWaitFor([] { return QToolTip::text().contains("100× slower to"); }))
      << "where it was typed, too";
  type("2,000");
  EXPECT_DOUBLE_EQ(bar_.slowMotion(), 2000);
  type("2,500x slower");
  EXPECT_DOUBLE_EQ(bar_.slowMotion(), 2500);
  EXPECT_EQ(said.count(), 4);
}

/// A line of very many elements moves more slowly than was asked for; header and bar agree.
TEST_F(TimeBarTest, APictureThatIsTooSlowHasOneNumber) {
  auto& behind = part<QLabel>("behindText");
  frame_.timeScale = 1 / 600.0;
  for (int i = 0; i < 9; ++i) bar_.showFrame(frame_);
  EXPECT_TRUE(behind.isHidden());
  frame_.timeScale = 1 / 1.41e6;
  bar_.showFrame(frame_);
  EXPECT_TRUE(behind.isHidden()) << "one late picture is none";
  for (int i = 0; i < 9; ++i) bar_.showFrame(frame_);
  EXPECT_FALSE(behind.isHidden());
  EXPECT_EQ(part<QLineEdit>("slowMotion").text(), QStringLiteral("1,410,000× slower"));
  EXPECT_DOUBLE_EQ(bar_.pace(), 12) << "the wish stays";
  QTest::keyClick(&part<QLineEdit>("slowMotion"), Qt::Key_Return);
  EXPECT_DOUBLE_EQ(bar_.pace(), 12) << "and nothing was typed";
  frame_.timeScale = 1 / 600.0;
  bar_.showFrame(frame_);
  EXPECT_TRUE(behind.isHidden());
  EXPECT_EQ(part<QLineEdit>("slowMotion").text(), QStringLiteral("600× slower"));
}

/// The views above do not move when the computer falls behind: the space of the sign is kept.
TEST_F(TimeBarTest, FallingBehindMovesNothing) {
  const QSize before = bar_.minimumSizeHint();
  bar_.resize(before.width(), bar_.sizeHint().height());
  bar_.show();
  const auto placeOfPace = [this] { return part<QSlider>("paceSlider").geometry(); };
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
  const QRect place = placeOfPace();
  frame_.timeScale = 1 / 1200.0;
  for (int i = 0; i < 9; ++i) bar_.showFrame(frame_);
  const auto& behind = part<QLabel>("behindText");
  ASSERT_TRUE(behind.isVisible());
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
  EXPECT_EQ(bar_.minimumSizeHint(), before);
  EXPECT_EQ(placeOfPace(), place);
  EXPECT_GE(behind.width(), behind.fontMetrics().horizontalAdvance(behind.text()));
  EXPECT_EQ(behind.accessibleName(), "the computer cannot keep up");
}

TEST_F(TimeBarTest, AMomentCanBeChosenHoweverNarrowTheBar) {
  scene_.sliding.kind = SlidingKind::Oscillation;
  show();
  bar_.resize(1, bar_.sizeHint().height());
  bar_.show();
  EXPECT_GE(part<QSlider>("moment").width(), 80);
}

/// Beside the slider of the moment, that of the pace needs its name all the more.
TEST_F(TimeBarTest, ThePaceHasItsNameWhereThereIsSpace) {
  scene_.sliding.kind = SlidingKind::Oscillation;
  show();
  bar_.layout()->setSizeConstraint(QLayout::SetNoConstraint);  // as within a window
  bar_.show();
  const auto& pace = part<QLabel>("paceName");
  const auto isSeenAt = [&](int width) {
    bar_.resize(width, bar_.sizeHint().height());
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    EXPECT_TRUE(pace.isHidden() || pace.width() >= pace.sizeHint().width()) << width;
    EXPECT_GE(part<QSlider>("moment").width(), 80) << width;
    return pace.isVisible();
  };
  EXPECT_TRUE(isSeenAt(720)) << "of a window of 1024 pixels";
  EXPECT_FALSE(isSeenAt(bar_.minimumSizeHint().width()));
  EXPECT_TRUE(isSeenAt(720));
}

/// At its least width the bar shows the moment without the duration, and nothing is cut.
TEST_F(TimeBarTest, TheDurationGivesWayInANarrowBar) {
  scene_.sliding.kind = SlidingKind::Oscillation;
  show();
  frame_.time = scene_.sliding.duration / 2;
  frame_.transient = std::make_shared<const std::vector<TransientSample>>();
  bar_.showFrame(frame_);
  bar_.layout()->setSizeConstraint(QLayout::SetNoConstraint);  // as within a window
  bar_.show();
  const auto& moment = part<QLabel>("momentText");
  const auto& keep = part<QCheckBox>("keepPace");
  const QString time = QString::fromStdString(quantity(frame_.time, "s", 3, Zeros::Keep));
  for (const int width : {720, bar_.minimumSizeHint().width(), 720}) {
    bar_.resize(width, bar_.sizeHint().height());
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    EXPECT_EQ(moment.text() == time, width < 720) << moment.text().toStdString();
    EXPECT_TRUE(moment.text().startsWith((width < 720 ? "" : "t = ") + time))
        << moment.text().toStdString();
    EXPECT_LE(keep.geometry().right(), bar_.width()) << width;
    EXPECT_GE(keep.width(), keep.sizeHint().width()) << width;
    EXPECT_GE(moment.width(), moment.sizeHint().width()) << width;
  }
}

TEST_F(TimeBarTest, ALongPaceIsNotCut) {
  auto& box = part<QLineEdit>("slowMotion");
  scene_.sliding.velocity = 1;
  for (const double length : {3.6e-6, 3.6e-8, 3.6e-11}) {
    frame_.length = length;
    bar_.showFrame(frame_);
    show();
    EXPECT_GT(bar_.slowMotion(), 3e6);
    EXPECT_LE(box.fontMetrics().horizontalAdvance(box.text()), box.width() - 8)
        << box.text().toStdString();
  }
}

/// One word says the pace, with the direction beside the number.
TEST_F(TimeBarTest, APaceFasterThanRealityIsSaidAndTyped) {
  scene_.sliding.velocity = 1e-5;  // 2000 s for a period
  show();
  EXPECT_EQ(part<QLineEdit>("slowMotion").text(), QStringLiteral("167× faster"));
  type("100x faster");
  EXPECT_DOUBLE_EQ(bar_.pace(), 20);
  EXPECT_EQ(part<QLineEdit>("slowMotion").text(), QStringLiteral("100× faster"));
  type("0.02 slower");
  EXPECT_DOUBLE_EQ(bar_.pace(), 40);
  EXPECT_EQ(part<QLineEdit>("slowMotion").text(), QStringLiteral("50× faster"));
  auto& box = part<QLineEdit>("slowMotion");
  EXPECT_LE(box.fontMetrics().horizontalAdvance("9999.99× faster"), box.width() - 8);
}

TEST_F(TimeBarTest, OnlyAMotionHasAMoment) {
  EXPECT_TRUE(part<QSlider>("moment").isHidden());
  scene_.sliding.kind = SlidingKind::Step;
  scene_.sliding.duration = 0.04;
  show();
  EXPECT_FALSE(part<QSlider>("moment").isHidden());
  QSignalSpy moments(&bar_, &TimeBar::seekRequested);
  frame_.transient = std::make_shared<const std::vector<TransientSample>>();
  frame_.time = 0.01;
  bar_.showFrame(frame_);
  EXPECT_EQ(moments.size(), 0);  // time itself asks for nothing
  EXPECT_NEAR(part<QSlider>("moment").value(), 250, 1);
  part<QSlider>("moment").setValue(500);
  ASSERT_EQ(moments.size(), 1);
  EXPECT_NEAR(moments[0][0].toDouble(), 0.02, 1e-9);
}

/// Who does not see the handle hears which moment it stands for; its tip tells the same.
TEST_F(TimeBarTest, TheMomentHasANameAndItsTimeInWords) {
  scene_.sliding.kind = SlidingKind::Step;
  scene_.sliding.duration = 0.04;
  show();
  frame_.transient = std::make_shared<const std::vector<TransientSample>>();
  frame_.time = 0.01;
  bar_.showFrame(frame_);
  auto& moment = part<QSlider>("moment");
  EXPECT_EQ(moment.accessibleName(), "moment of the motion");
  EXPECT_EQ(moment.accessibleDescription(), "t = 10.0 ms of 40 ms");
  bar_.show();
  QHelpEvent help(QEvent::ToolTip, {5, 5}, moment.mapToGlobal(QPoint(5, 5)));
  QApplication::sendEvent(&moment, &help);
  EXPECT_TRUE(QToolTip::text().contains("t = 10")) << QToolTip::text().toStdString();
}

class TimeInTheWindow : public MainWindowTest {
 protected:
  void openMotion(SlidingKind kind) {
    Scene moving = smallScene();
    moving.sliding.kind = kind;
    window_.document().open(moving);
    ASSERT_TRUE(waitForFrame());
  }
};

TEST_F(TimeInTheWindow, AMomentIsDraggedAndTimeGoesOnAsBefore) {
  openMotion(SlidingKind::Step);
  auto& moment = control<QSlider>("moment");
  const double duration = window_.document().scene().sliding.duration;
  const auto isAt = [&](double part) {
    return waitFor([&] {
      return frame()->time <= part * duration * (1 + 1e-9) &&
             frame()->time + frame()->nextStep >= part * duration * (1 - 1e-9);
    });
  };
  emit moment.sliderPressed();
  EXPECT_FALSE(session().isPlaying());
  for (const double part : {0.7, 0.25, 0.5}) {
    moment.setValue(static_cast<int>(part * moment.maximum()));
    EXPECT_TRUE(isAt(part)) << part;
  }
  emit moment.sliderReleased();
  EXPECT_TRUE(session().isPlaying());
  // A press beside the handle grips it there.
  const QPoint place(static_cast<int>(0.3 * moment.width()), moment.height() / 2);
  QTest::mousePress(&moment, Qt::LeftButton, {}, place);
  EXPECT_TRUE(moment.isSliderDown());
  EXPECT_NEAR(moment.value(), 0.3 * moment.maximum(), 0.06 * moment.maximum());
  EXPECT_FALSE(session().isPlaying());
  EXPECT_TRUE(isAt(static_cast<double>(moment.value()) / moment.maximum()));
  QTest::mouseRelease(&moment, Qt::LeftButton, {}, place);
  EXPECT_TRUE(session().isPlaying());
  EXPECT_TRUE(waitFor([&] { return frame()->time > 0.4 * duration; }));
}

/// Pictures that were on their way when a key asked for another moment do not take the handle back,
/// from which the next key goes on.
TEST_F(TimeInTheWindow, ALatePictureDoesNotTakeTheHandleBack) {
  openMotion(SlidingKind::Step);
  ASSERT_TRUE(waitFor([&] { return frame()->transient && frame()->transient->size() > 30; }));
  session().setPlaying(false);
  ASSERT_TRUE(waitForRest());
  const auto late = std::make_shared<const Frame>(*frame());
  auto& moment = control<QSlider>("moment");
  const int before = moment.value(), page = moment.pageStep();
  ASSERT_LT(before + 3 * page, moment.maximum());
  for (const int pages : {1, 2, 3}) {
    QTest::keyClick(&moment, Qt::Key_PageUp);
    session().show(late);
    EXPECT_EQ(moment.value(), before + pages * page);
  }
  const double wanted =
      window_.document().scene().sliding.duration * moment.value() / moment.maximum();
  EXPECT_TRUE(waitFor([&] { return !session().requestedMoment(); }));
  EXPECT_NEAR(frame()->time, wanted, frame()->nextStep * (1 + 1e-9));
  EXPECT_NEAR(moment.value(), before + 3 * page, 1);
  // Another command than a key of the handle takes its place.
  QTest::keyClick(&moment, Qt::Key_PageDown);
  session().reset();
  session().show(late);
  EXPECT_EQ(moment.value(), before);
}

TEST_F(TimeInTheWindow, StripsAndLoopReadMomentsAndSaveThem) {
  openMotion(SlidingKind::Oscillation);
  MotionView& motion = window_.tabs().motion();
  EXPECT_FALSE(motion.loop().isHidden());
  ASSERT_TRUE(waitFor([&] { return frame()->transient && frame()->transient->size() > 30; }));
  session().setPlaying(false);
  ASSERT_TRUE(waitForRest());
  const std::vector<TransientSample>& samples = *frame()->transient;
  const TransientSample& one = samples[samples.size() / 2];
  const DiagramAxis& y = motion.strips().sheet().diagrams[0].y;
  const QPointF at = motion.strips().mapToPosition(one.time, (y.from + y.to) / 2);
  const TransientSample* found = motion.sampleAt(motion.strips(), at);
  ASSERT_TRUE(found);
  EXPECT_DOUBLE_EQ(found->time, one.time);
  EXPECT_FALSE(motion.sampleAt(motion.strips(), {-50, 20}));
  // The loop has one point for each sample; a place far from it reads nothing.
  const Diagram& loop = motion.loop().sheet().diagrams[0];
  EXPECT_EQ(loop.series[0].points.size(), samples.size());
  EXPECT_NEAR(loop.series[0].points[5].y, samples[5].tangentialForce / samples[5].normalForce,
              1e-15);
  // What is saved are the samples that are shown, but for the one at time 0, which is the beginning
  // of the curves and has the values of the next one.
  QTemporaryDir folder;
  QSignalSpy saved(&motion.stripFiles(), &DiagramFiles::saved);
  QSignalSpy loopSaved(&motion.loopFiles(), &DiagramFiles::saved);
  for (const char* name : {"/a.csv", "/a.png", "/a.svg"})
    motion.stripFiles().save(folder.path() + name);
  motion.loopFiles().save(folder.path() + "/loop.pdf");
  ASSERT_TRUE(waitFor([&] { return saved.size() == 3 && loopSaved.size() == 1; }));
  std::ifstream file((folder.path() + "/a.csv").toStdString());
  std::size_t rows = 0;
  std::string record;
  std::getline(file, record);
  for (std::string line; std::getline(file, line);) ++rows;
  // It names the command of motions, and no options: its rows are not those of the command.
  EXPECT_NE(record.find("\"verb\":\"motion\""), record.npos) << record;
  EXPECT_EQ(record.find("\"options\""), record.npos) << record;
  ASSERT_EQ(samples.front().time, 0);
  EXPECT_EQ(rows, samples.size()) << "with the names of the columns";
  EXPECT_GT(QFileInfo(folder.path() + "/a.png").size(), 5000);
  EXPECT_GT(QFileInfo(folder.path() + "/loop.pdf").size(), 1000);
  // The samples of the previous motion are no longer on the screen, so they cannot be saved.
  Scene other = smallScene();
  other.sliding.kind = SlidingKind::Step;
  window_.document().open(other);
  EXPECT_TRUE(motion.loop().isHidden());
  EXPECT_TRUE(motion.stripFiles().isEmpty());
  EXPECT_TRUE(waitFor([&] { return !motion.stripFiles().isEmpty(); }));
}

/// The axis of velocities does not jump when the velocity does.
TEST_F(TimeInTheWindow, TheStripOfVelocitiesHasThoseOfTheWholeMotion) {
  for (const SlidingKind kind : {SlidingKind::Step, SlidingKind::Oscillation}) {
    openMotion(kind);
    session().setPlaying(false);
    const Sliding& sliding = window_.document().scene().sliding;
    const bool isStep = kind == SlidingKind::Step;
    const double first = isStep ? sliding.velocity : sliding.velocity - sliding.amplitude;
    const double other = isStep ? sliding.velocityAfter : sliding.velocity + sliding.amplitude;
    const DiagramAxis& y = window_.tabs().motion().strips().sheet().diagrams[0].y;
    EXPECT_LT(y.from, std::min(first, other));
    EXPECT_GT(y.to, std::max(first, other));
    EXPECT_LT(y.to - y.from, 1.5 * std::abs(other - first));
  }
}

TEST_F(TimeInTheWindow, AClickOnAStripGoesToItsMoment) {
  openMotion(SlidingKind::Step);
  ASSERT_TRUE(waitFor([&] { return frame()->transient && frame()->transient->size() > 60; }));
  session().setPlaying(false);
  ASSERT_TRUE(waitForRest());
  ChartView& strips = window_.tabs().motion().strips();
  const TransientSample wanted = (*frame()->transient)[20], last = frame()->transient->back();
  const DiagramAxis& y = strips.sheet().diagrams[0].y;
  const QPoint at = strips.mapToPosition(wanted.time, (y.from + y.to) / 2).toPoint();
  QTest::mouseClick(&strips, Qt::LeftButton, {}, at);
  EXPECT_TRUE(waitFor([&] {
    return std::abs(frame()->time - wanted.time) <
           0.02 * window_.document().scene().sliding.duration;
  }));
  // What was drawn after it stays, and is read there.
  EXPECT_LT(frame()->transient->back().time, last.time);
  ASSERT_TRUE(frame()->later);
  EXPECT_EQ(frame()->later->back().time, last.time);
  EXPECT_TRUE(strips.sheet().diagrams[0].series.back().isFaded);
  EXPECT_EQ(strips.sheet().diagrams[0].series.back().points.back().x, last.time);
  const QPoint late = strips.mapToPosition(last.time, (y.from + y.to) / 2).toPoint();
  ASSERT_TRUE(window_.tabs().motion().sampleAt(strips, late));
  EXPECT_NEAR(window_.tabs().motion().sampleAt(strips, late)->time, last.time, 0.1 * last.time);
  QTest::mouseClick(&strips, Qt::LeftButton, {}, late);
  EXPECT_TRUE(waitFor([&] { return frame()->time > 0.9 * last.time; }));
}

/// Strips and loop are reached by the Tab key: for their menus, and to read one moment after the
/// other.
TEST_F(TimeInTheWindow, ArrowKeysMoveTheMomentOfTheStrips) {
  openMotion(SlidingKind::Oscillation);
  ASSERT_TRUE(waitFor([&] { return frame()->transient && frame()->transient->size() > 30; }));
  session().setPlaying(false);
  ASSERT_TRUE(waitForRest());
  MotionView& motion = window_.tabs().motion();
  const double duration = window_.document().scene().sliding.duration;
  const auto& moment = control<QSlider>("moment");
  for (ChartView* chart : {&motion.strips(), &motion.loop()}) {
    EXPECT_EQ(chart->focusPolicy(), Qt::TabFocus);
    chart->setFocus(Qt::TabFocusReason);
    const int before = moment.value();
    for (int i = 0; i < 3; ++i) QTest::keyClick(chart, Qt::Key_Right);
    QTest::keyClick(chart, Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_EQ(moment.value(), before + 29);
    const double wanted = duration * moment.value() / moment.maximum();
    EXPECT_TRUE(waitFor([&] { return std::abs(frame()->time - wanted) < 2e-3 * duration; }));
    EXPECT_TRUE(waitFor([&] { return chart->accessibleDescription().startsWith("t = "); }));
  }
}

/// The picture, the bar, the status line and the charts tell the same moment, also while it plays.
TEST_F(TimeInTheWindow, EverythingTellsTheSameMoment) {
  std::shared_ptr<const Frame> drawn;
  QObject::connect(&window_.canvas(), &ContactCanvas::frameShown, &window_,
                   [&](const std::shared_ptr<const Frame>& shown) { drawn = shown; });
  openMotion(SlidingKind::Oscillation);
  const auto& strips = window_.tabs().motion().strips();
  int pictures = 0;
  QObject::connect(&window_.canvas(), &ContactCanvas::painted, &window_, [&] {
    if (!drawn || !drawn->transient || drawn->transient->empty()) return;
    ++pictures;
    EXPECT_EQ(session().frame(), drawn);
    EXPECT_TRUE(control<QLabel>("momentText")
                    .text()
                    .contains(QString::fromStdString(quantity(drawn->time, "s", 3, Zeros::Keep))));
    EXPECT_TRUE(control<QLabel>("factVelocity")
                    .text()
                    .endsWith(readingLabel(dimensionlessVelocity(*drawn))));
    EXPECT_EQ(strips.sheet().diagrams[0].series.front().points.size(), drawn->transient->size());
    EXPECT_EQ(window_.session().friction().sheet().diagrams.front().marker->label.english(),
              "|v| = " + printedQuantity(std::abs(drawn->velocity), "m/s"));
  });
  EXPECT_TRUE(waitFor([&] { return pictures > 20; }));
}

/// Counts the events in which the contact of another frame was painted, and those among them in
/// which the chart was not.
class PaintedTogether : public QObject {
 public:
  PaintedTogether(MainWindow& window, QWidget& canvas, QWidget& chart)
      : canvas_(canvas), chart_(chart), session_(window.session()), last_(session_.frame()) {
    for (QObject* each : {static_cast<QObject*>(&window), static_cast<QObject*>(&canvas),
                          static_cast<QObject*>(&chart)})
      each->installEventFilter(this);
  }

  int pictures = 0, late = 0;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::UpdateRequest) endEvent();
    if (event->type() == QEvent::Paint && watched == &canvas_) painted_ = session_.frame();
    if (event->type() == QEvent::Paint && watched == &chart_) hasChart_ = true;
    return false;
  }

 private:
  void endEvent() {
    if (painted_ && painted_ != last_) {
      ++pictures;
      if (!hasChart_) ++late;
      last_ = painted_;
    }
    painted_.reset();
    hasChart_ = false;
  }

  QWidget &canvas_, &chart_;
  Session& session_;
  std::shared_ptr<const Frame> last_, painted_;  // before this event, and in it
  bool hasChart_ = false;                        // in this event
};

TEST_F(TimeInTheWindow, TheMarkerIsPaintedWithTheContact) {
  openMotion(SlidingKind::Oscillation);
  window_.findChild<QAction*>("go:frictionPlot")->trigger();
  ASSERT_TRUE(waitFor([&] { return session().friction().progress() >= 1; }));
  PaintedTogether watch(window_, control<QWidget>("softwareCanvas"),
                        *window_.plotView().findChild<QGraphicsView*>()->viewport());
  EXPECT_TRUE(waitFor([&] { return watch.pictures > 60; }));
  EXPECT_EQ(watch.late, 0) << "of " << watch.pictures;
}

/// Also where the axes grow with it, however short a while ago the chart was made.
TEST_F(TimeInTheWindow, AMarkerThatLeavesTheAxesIsShownAtOnce) {
  ASSERT_TRUE(waitFor([&] { return session().friction().progress() >= 1; }));
  ASSERT_TRUE(waitForFrame());
  session().setPlaying(false);
  ASSERT_TRUE(waitForRest());
  for (const double factor : {1e3, 1e6, 1e9}) {
    Frame higher = *frame();
    higher.state.mu *= factor;
    session().show(std::make_shared<const Frame>(higher));
    ASSERT_TRUE(chart().marker);
    EXPECT_EQ(chart().marker->y, higher.state.mu);
    EXPECT_GT(chart().y.to, higher.state.mu);
  }
}

/// Shift makes a step fine.
TEST_F(TimeInTheWindow, AStepIsSeenAndAFineOneIsSmall) {
  ASSERT_TRUE(waitForFrame());
  session().setPlaying(false);
  ASSERT_TRUE(waitForRest());
  const auto moved = [&](const char* name) {
    const double before = frame()->distance;
    window_.findChild<QAction*>(name)->trigger();
    EXPECT_TRUE(waitFor([&] { return frame()->distance != before; }));
    return (frame()->distance - before) / frame()->length;
  };
  const double coarse = moved("step"), fine = moved("stepFinely");
  EXPECT_GT(coarse, 0.01);
  EXPECT_LT(fine, 0.25 * coarse);
  EXPECT_GT(fine, 0);
}

TEST_F(TimeInTheWindow, ADragInThePictureIsOneStepBack) {
  ASSERT_TRUE(waitForFrame());
  const Scene start = window_.document().scene();
  ContactCanvas& canvas = window_.canvas();
  const QRectF plot = canvas.plotArea();
  const QPoint at(static_cast<int>(plot.left() + 0.3 * plot.width()),
                  static_cast<int>(plot.top() + 0.03 * plot.height()));
  QTest::mousePress(&canvas, Qt::LeftButton, {}, at);
  for (const int down : {10, 20, 30}) QTest::mouseMove(&canvas, at + QPoint(0, down));
  QTest::mouseRelease(&canvas, Qt::LeftButton, {}, at + QPoint(0, 30));
  EXPECT_GT(window_.document().scene().load.normalForce, start.load.normalForce);
  EXPECT_EQ(window_.document().history().count(), 1);
  window_.document().history().undo();
  EXPECT_EQ(window_.document().scene(), start);
}

/// A window at rest asks seldom, and answers at once all the same.
TEST_F(TimeInTheWindow, AWindowAtRestAnswersOrders) {
  ASSERT_TRUE(waitForFrame());
  session().setPlaying(false);
  ASSERT_TRUE(waitFor([&] { return session().isIdle(); }));
  const double before = frame()->distance;
  session().singleStep(0.01);
  EXPECT_FALSE(session().isIdle());
  EXPECT_TRUE(waitFor([&] { return frame()->distance > before; }));
  session().setPlaying(true);
  EXPECT_FALSE(session().isIdle());
}

}  // namespace
}  // namespace asperity
