// What the window says of itself: the status bar on the curve at the present velocity, the button
// that stops the averaging, and a picture that cannot be drawn here.
#include <gtest/gtest.h>

#include <QHelpEvent>
#include <QLayout>
#include <QProgressBar>
#include <QToolButton>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/accuracy/compute_curve.h"
#include "tests/core/elastomers.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/draw/ticks.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/labels.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/curve/curve_reading.h"
#include "ui/window/main/status_line.h"
#include "ui/window/main/work_indicator.h"

namespace asperity {
namespace {

using StatusTest = MainWindowTest;

Frame frameAt(double velocity, double contactFraction = 0.1) {
  Scene scene;
  scene.sliding.velocity = velocity;
  Frame frame;
  frame.scene = std::make_shared<const Scene>(scene);
  frame.state.contactFraction = contactFraction;
  return frame;
}

/// mu = v up to 1 m/s, then 1.
CurveUpdate bentCurve() {
  CurveUpdate curve;
  curve.scene = std::make_shared<const Scene>();
  curve.realizationsDone = curve.realizationsTotal = 10;
  curve.isComplete = true;
  for (int i = -20; i <= 20; ++i) {
    CurvePoint point;
    point.velocity = std::pow(10, 0.2 * i);
    point.mu = point.velocity / std::sqrt(1 + point.velocity * point.velocity);
    point.muStandardError = 0.01 * point.mu;
    point.realizations = 10;
    curve.points.push_back(point);
  }
  return curve;
}

TEST(CurveReading, IsTheCurvesAtItsPointsAndBetweenThem) {
  const CurveUpdate curve = bentCurve();
  const CurvePoint& point = curve.points[7];
  const CurveReading at = readCurve(frameAt(point.velocity), &curve);
  EXPECT_EQ(at.mu, point.mu);
  EXPECT_EQ(at.error, point.muStandardError);
  const CurveReading between = readCurve(frameAt(1.2e-3), &curve);
  EXPECT_NEAR(between.mu, 1.2e-3, 1e-8);
  EXPECT_NEAR(between.error, 1.2e-5, 1e-6);
}

TEST(CurveReading, SaysNothingOutsideOfTheCurveOrWithoutOne) {
  const CurveUpdate curve = bentCurve();
  for (const double velocity : {0.0, 1e-9, 1e9})
    EXPECT_FALSE(std::isfinite(readCurve(frameAt(velocity), &curve).mu));
  EXPECT_FALSE(std::isfinite(readCurve(frameAt(1), nullptr).mu));
}

TEST(CurveReading, SaysNothingOfTheCurveOfAnotherScene) {
  const CurveUpdate curve = bentCurve();
  Frame frame = frameAt(1);
  ASSERT_TRUE(std::isfinite(readCurve(frame, &curve).mu));
  Scene other = *frame.scene;
  other.elastomer.shearModulus *= 2;
  frame.scene = std::make_shared<const Scene>(other);
  EXPECT_FALSE(std::isfinite(readCurve(frame, &curve).mu));
}

/// Also where no curve reaches; the model itself goes on.
TEST(CurveReading, NotesAVelocityThatNobodyTests) {
  const CurveUpdate curve = bentCurve();
  const auto isNoted = [](const CurveReading& reading) {
    return reading.notes.has(Note::FasterThanTested);
  };
  EXPECT_TRUE(isNoted(readCurve(frameAt(1e9), &curve)));
  EXPECT_TRUE(isNoted(readCurve(frameAt(1e9), nullptr)));
  EXPECT_FALSE(isNoted(readCurve(frameAt(1000), &curve)));
}

TEST(CurveReading, NamesTheRegime) {
  const CurveUpdate curve = bentCurve();
  EXPECT_EQ(readCurve(frameAt(1e-3), &curve).regime, "region I, linear");
  EXPECT_EQ(readCurve(frameAt(1e3), &curve).regime, "region III, plateau");
  EXPECT_EQ(readCurve(frameAt(0), &curve).regime, "at rest");
  EXPECT_EQ(readCurve(frameAt(1e-3, 1), &curve).regime, "complete contact");
  CurveUpdate half = curve;
  half.isComplete = false;  // however many lines there are: a target may ask for more
  EXPECT_EQ(readCurve(frameAt(1e-3), &half).regime, "");
}

TEST_F(StatusTest, SaysRegimeMeanAndRateOfTheCurve) {
  ASSERT_TRUE(waitFor([&] { return session().averaging() == Session::Averaging::Done; }));
  ASSERT_TRUE(waitForFrame());
  ASSERT_TRUE(waitFor([&] { return fact("factMu").contains(QStringLiteral("±")); }));
  EXPECT_TRUE(fact("factMu").contains("mean"));
  ASSERT_TRUE(waitFor([&] { return fact("factSimulations").endsWith(" simulations/s"); }));
  EXPECT_GT(session().simulationsPerSecond(), 0);
  ASSERT_TRUE(waitFor([&] { return !control<QProgressBar>("workProgress").isVisible(); }));
  EXPECT_FALSE(control<QToolButton>("workStop").isVisible());
}

/// At any target: it is finished and says so, and its own error is told.
TEST_F(StatusTest, ACurveToATargetIsFinished) {
  action("go:accuracyPanel").trigger();
  QStringList told;
  for (const double target : {0.2, 0.05, 0.01}) {
    Scene scene = smallScene();
    scene.accuracy.targetRelativeError = target;
    window_.document().open(scene);
    ASSERT_TRUE(waitFor([&] { return session().averaging() == Session::Averaging::Done; }));
    ASSERT_TRUE(waitForFrame());
    ASSERT_TRUE(waitFor([&] { return !control<QProgressBar>("workProgress").isVisible(); }));
    EXPECT_FALSE(control<QToolButton>("workStop").isVisible());
    ASSERT_TRUE(waitFor([&] { return fact("factRegime").startsWith("region"); }));
    const CurveUpdate& curve = *session().curve();
    EXPECT_EQ(session().friction().sheet().status.english(),
              QStringLiteral("%1 of %1 lines").arg(curve.realizationsTotal).toStdString());
    double squares = 0;
    for (const CurvePoint& point : curve.points)
      squares += std::pow(point.muStandardError / point.mu, 2);
    const double error = std::sqrt(squares / static_cast<double>(curve.points.size()));
    EXPECT_LT(error, 1.05 * target);
    told += fact("accuracyMeasured");
    EXPECT_TRUE(told.back().contains(QString::fromStdString(shortNumber(100 * error, 2)) +
                                     QStringLiteral("\u00A0%")))
        << told.back().toStdString();
  }
  EXPECT_EQ(told.removeDuplicates(), 0);
}

/// Of a line that is no random one, which has no standard error.
TEST_F(StatusTest, ASingleLineToATargetHasItsCurve) {
  Scene scene = smallScene();
  scene.surface.kind = SurfaceKind::Sine;
  scene.accuracy.targetRelativeError = 0.01;
  window_.document().open(scene);
  ASSERT_TRUE(waitFor([&] { return session().averaging() == Session::Averaging::Done; }));
  ASSERT_TRUE(waitFor([&] { return fact("accuracyMeasured").contains(", error "); }));
  EXPECT_FALSE(fact("accuracyMeasured").contains(QStringLiteral("–")));
}

/// In the words of the command line, beside the readings, and only while its curve is shown.
TEST_F(StatusTest, AMissedTargetIsTold) {
  Scene scene = smallScene();
  scene.surface.kind = SurfaceKind::Sine;
  scene.accuracy.targetRelativeError = 1e-17;
  const Curve missed = computeCurve(scene);
  ASSERT_FALSE(missed.isTargetMet);
  window_.document().open(scene);
  const auto told = [&] { return control<QToolButton>("factNotes").accessibleDescription(); };
  const QString reason = translatedText(*missedTarget(missed));
  EXPECT_TRUE(waitFor([&] { return told().contains(reason); })) << told().toStdString();
  EXPECT_TRUE(control<QToolButton>("factNotes").isVisible());
  window_.document().open(smallScene());
  EXPECT_TRUE(waitFor([&] { return !told().contains(reason); }));
}

/// The picture of another scene would pass for its own, and there is no curve to wait for.
TEST_F(StatusTest, ASceneThatCannotBeComputedShowsNoOther) {
  ASSERT_TRUE(waitFor([&] { return session().averaging() == Session::Averaging::Done; }));
  ASSERT_TRUE(waitForFrame());
  ASSERT_FALSE(fact("factMu").isEmpty());
  Scene missing = smallScene();
  missing.surface.kind = SurfaceKind::Profile;
  missing.surface.file = "/there/is/no/such/file.txt";
  window_.document().open(missing);
  ASSERT_TRUE(waitFor([&] { return window_.messages().isVisible(); }));
  EXPECT_FALSE(session().frame());
  EXPECT_FALSE(window_.canvas().frame());
  EXPECT_TRUE(fact("factMu").isEmpty());
  // There is no picture of the previous scene under the veil, either.
  EXPECT_EQ(control<QLabel>("contactVeil").text(), "This scene cannot be computed");
  EXPECT_FALSE(session().friction().marker());
  EXPECT_TRUE(waitFor([&] { return !control<QProgressBar>("workProgress").isVisible(); }));
  EXPECT_FALSE(control<QToolButton>("workStop").isVisible());
  press("load.normal_force");  // still without its file
  QTest::qWait(100);
  EXPECT_FALSE(session().frame());
  window_.document().open(smallScene());
  ASSERT_TRUE(waitForFrame());
  EXPECT_TRUE(window_.canvas().frame());
  EXPECT_FALSE(fact("factMu").isEmpty());
}

/// Within one scene the last picture stays: a value is being tried.
TEST_F(StatusTest, ARefusedValueKeepsThePicture) {
  ASSERT_TRUE(waitForFrame());
  window_.document().edit(refusedScene());
  ASSERT_TRUE(waitFor([&] { return window_.messages().isVisible(); }));
  EXPECT_TRUE(window_.canvas().frame());
}

/// A scene with the same curve was not computed again.
TEST_F(StatusTest, TheTimeOfACurveStaysWithIt) {
  ASSERT_TRUE(waitFor([&] { return fact("accuracyMeasured").startsWith("measured"); }));
  const QString told = fact("accuracyMeasured");
  type("sliding.velocity", "0.125 m/s");
  ASSERT_TRUE(waitFor([&] { return session().averaging() == Session::Averaging::Done; }));
  EXPECT_EQ(fact("accuracyMeasured"), told);
}

/// So that the pictures above do not move when a curve begins or ends.
TEST(StatusLine, IsAlwaysAsHigh) {
  StatusLine line;
  const int height = line.sizeHint().height();
  for (const Work::State state :
       {Work::State::Running, Work::State::Stopped, Work::State::Waiting, Work::State::Idle}) {
    line.showWork({state, 0.5, 16000});
    line.layout()->activate();
    EXPECT_EQ(line.sizeHint().height(), height) << static_cast<int>(state);
    if (state != Work::State::Idle) {
      EXPECT_GE(height, line.findChild<QToolButton*>("workStop")->sizeHint().height());
    }
  }
}

TEST_F(StatusTest, ALongCurveIsStoppedAndBegunAnew) {
  Scene endless = smallScene();
  endless.surface.elements = 5000;
  endless.ensemble.realizations = 1000000;
  window_.document().open(endless);
  auto& button = control<QToolButton>("workStop");
  auto& progress = control<QProgressBar>("workProgress");
  // On a slow machine it offers the way back to the scene before until the line is made.
  ASSERT_TRUE(waitFor([&] {
    return session().curve() && button.isVisible() &&
           button.accessibleName() == QStringLiteral("Stop averaging the curve");
  }));
  EXPECT_TRUE(progress.isVisible());
  QTest::mouseClick(&button, Qt::LeftButton);
  EXPECT_EQ(session().averaging(), Session::Averaging::Stopped);
  ASSERT_TRUE(waitFor([&] { return button.text() == QStringLiteral("↻"); }));
  EXPECT_TRUE(session().curve());  // what is there stays
  QTest::mouseClick(&button, Qt::LeftButton);
  EXPECT_EQ(session().averaging(), Session::Averaging::Running);
  ASSERT_TRUE(waitFor([&] { return session().curve() != nullptr; }));
}

Frame movingFrame(double velocity) {
  Frame frame = frameAt(0);
  frame.rmsHeight = 5e-7;
  frame.rmsSlope = 0.01;
  frame.length = 0.02;
  frame.velocity = velocity;
  frame.transient = std::make_shared<const std::vector<TransientSample>>();
  return frame;
}

/// Eq. (13), of a motion at the moment: its mean velocity may well be 0.
TEST(StatusLine, TheDimensionlessVelocityOfAMotionIsThatOfTheMoment) {
  const Frame moving = movingFrame(0.3);
  const double time = moving.scene->elastomer.relaxationTime;
  EXPECT_DOUBLE_EQ(dimensionlessVelocity(moving), time * 0.3 * 0.01 / (std::sqrt(2.0) * 5e-7));
  EXPECT_LT(dimensionlessVelocity(movingFrame(-0.3)), 0);
  Frame steady = movingFrame(0.3);
  steady.transient.reset();
  EXPECT_EQ(dimensionlessVelocity(steady), 0);
}

/// A motion that goes back has a sign before its numbers, for which their widths have space.
TEST(StatusLine, ASignMovesNothingAndIsNotCut) {
  StatusLine line;
  line.setFixedWidth(1440);
  line.show();
  const auto& force = *line.findChild<QLabel*>("factForce");
  const auto& velocity = *line.findChild<QLabel*>("factVelocity");
  line.showFrame(movingFrame(6.28e-4), {});
  QTest::qWait(1);
  const int place = force.x(), width = velocity.width();
  line.showFrame(movingFrame(-6.28e-4), {});
  QTest::qWait(1);
  ASSERT_TRUE(velocity.text().contains(u'−')) << velocity.text().toStdString();
  EXPECT_EQ(force.x(), place);
  EXPECT_EQ(velocity.width(), width);
  EXPECT_GE(width, velocity.fontMetrics().horizontalAdvance(velocity.text()));
}

/// A motion passes through rest, where its numbers are long and the notes are others.
TEST(StatusLine, NothingMovesWhileAMotionPlays) {
  for (const Language& language : languages()) {
    useLanguage(language.code);
    StatusLine line;
    line.setFixedWidth(1024);
    line.show();
    std::map<QString, std::vector<QRect>> places;
    for (int i = 0; i < 60; ++i) {
      const double velocity = (i < 30 ? 1 : -1) * std::pow(10, -8 + 0.3 * (i % 30));
      Frame frame = movingFrame(velocity);
      frame.state.normalForce = 0.02;
      frame.state.tangentialForce = 0.001 * velocity * frame.state.normalForce;
      CurveReading reading;
      if (i % 3 == 0) reading.notes.add(Note::FasterThanTested);
      line.showFrame(frame, reading);
      line.showWork(
          {i % 2 == 0 ? Work::State::Running : Work::State::Idle, 0.5, 16000.0 * (i % 5)});
      line.showDrawing(i % 7, "software");
      QTest::qWait(1);  // the layout is made with the first events
      for (const char* name : {"factMu", "factForce", "factVelocity"}) {
        const auto& fact = *line.findChild<QLabel*>(name);
        EXPECT_TRUE(fact.isVisible()) << name << ' ' << velocity << ' ' << language.code;
        EXPECT_GE(fact.width(), fact.fontMetrics().horizontalAdvance(fact.text())) << name;
        places[name].push_back(fact.geometry());
      }
    }
    for (const auto& [name, each] : places)
      EXPECT_EQ(std::ranges::count(each, each.front()), std::ssize(each)) << name.toStdString();
  }
  useLanguage("en");
}

TEST(StatusLine, ADimensionlessVelocityThatIsMissingIsLeftOut) {
  StatusLine line;
  line.setFixedWidth(1440);
  line.show();
  const auto& velocity = *line.findChild<QLabel*>("factVelocity");
  Frame frame = movingFrame(1);
  const auto reason = [&] { return line.findChild<QLabel*>("factForce")->toolTip(); };
  line.showFrame(frame, {});
  EXPECT_TRUE(velocity.isVisible());
  EXPECT_FALSE(reason().contains("No velocity"));
  Scene scene = *frame.scene;
  for (const auto& [rheology, words] : {std::pair(Rheology::Prony, "arms have relaxation times"),
                                        {Rheology::Elastic, "no relaxation time"}}) {
    scene.elastomer.rheology = rheology;
    frame.scene = std::make_shared<const Scene>(scene);
    line.showFrame(frame, {});
    EXPECT_FALSE(velocity.isVisible());
    EXPECT_TRUE(reason().contains(words)) << reason().toStdString();
  }
  frame = movingFrame(1);
  frame.rmsHeight = frame.rmsSlope = 0;
  line.showFrame(frame, {});
  EXPECT_TRUE(reason().contains("no roughness")) << reason().toStdString();
}

/// A curve over another axis than the velocity has no regions.
TEST(StatusLine, TheForceKeepsItsPlaceWhereThereIsNoRegion) {
  StatusLine line;
  line.setFixedWidth(1440);
  line.show();
  const auto& force = *line.findChild<QLabel*>("factForce");
  Frame frame = movingFrame(1);
  CurveReading reading;
  reading.regime = "region II, transition";
  line.showFrame(frame, reading);
  QTest::qWait(1);  // the layout is made with the first events
  const int place = force.x();
  Scene scene = *frame.scene;
  scene.sweep.key = "load.normal_force";
  frame.scene = std::make_shared<const Scene>(scene);
  line.showFrame(frame, {});
  QTest::qWait(1);
  EXPECT_EQ(force.x(), place);
}

/// Between two points of the curve the mean is no computed one.
TEST(StatusLine, AnInterpolatedMeanIsMarked) {
  StatusLine line;
  CurveReading reading;
  reading.mu = 0.2757;
  reading.error = 0.008;
  reading.lines = 32;
  line.showFrame(movingFrame(1), reading);
  const auto& mu = *line.findChild<QLabel*>("factMu");
  EXPECT_TRUE(mu.text().contains("mean of 32: 0.276")) << mu.text().toStdString();
  reading.isInterpolated = true;
  line.showFrame(movingFrame(1), reading);
  EXPECT_TRUE(mu.text().contains(QStringLiteral("mean of 32 ≈ 0.276"))) << mu.text().toStdString();
}

/// Value and error end at the same digit, also where that digit is a zero.
TEST(StatusLine, TheMeanEndsWhereItsErrorBegins) {
  StatusLine line;
  CurveReading reading;
  reading.lines = 32;
  const auto& mu = *line.findChild<QLabel*>("factMu");
  for (const auto& [value, error, shown] : {std::tuple{0.3, 0.003, ", mean of 32: 0.300 ± 1 %"},
                                            {0.9, 0.0045, ", mean of 32: 0.900 ± 0.5 %"},
                                            {0.00119996, 5e-6, ", mean of 32: 0.001200 ± 0.4 %"},
                                            {0.5, 0.096, ", mean of 32: 0.5 ± 20 %"}}) {
    reading.mu = value;
    reading.error = error;
    line.showFrame(movingFrame(1), reading);
    EXPECT_TRUE(mu.text().contains(shown)) << mu.text().toStdString() << ", not " << shown;
  }
}

/// Header, chart and status line have three numbers of friction: words tell that of the drawn line
/// from the mean.
TEST(StatusLine, TheFrictionOfOneLineIsToldFromTheMeanOfAll) {
  StatusLine line;
  const auto text = [&] { return line.findChild<QLabel*>("factMu")->text().toStdString(); };
  Frame frame = movingFrame(1);
  frame.state.tangentialForce = 0.25;
  frame.state.normalForce = 1;
  CurveReading reading;
  reading.mu = 0.3;
  reading.error = 0.003;
  reading.lines = 32;
  line.showFrame(frame, reading);
  EXPECT_EQ(text(), "this line μ = 0.250, mean of 32: 0.300 ± 1 %");
  line.showFrame(frame, {});
  EXPECT_EQ(text(), "this line μ = 0.250");
  Scene scene = *frame.scene;
  scene.interface.frictionCoefficient = 0.1;
  frame.scene = std::make_shared<const Scene>(scene);
  line.showFrame(frame, {});
  EXPECT_EQ(text(), "this line, deformation μ = 0.250");
  scene.surface.kind = SurfaceKind::Sine;
  frame.scene = std::make_shared<const Scene>(scene);
  line.showFrame(frame, {});
  EXPECT_EQ(text(), "deformation μ = 0.250");
  scene.interface = {};
  frame.scene = std::make_shared<const Scene>(scene);
  line.showFrame(frame, {});
  EXPECT_EQ(text(), "friction μ = 0.250");
}

/// A long hint in a small window: nothing is computed, and the place of the progress is free.
TEST(StatusLine, AMessageHasThePlaceOfLesserReadings) {
  StatusLine line;
  line.setFixedWidth(1024);
  line.show();
  CurveReading reading;
  reading.regime = "region II, transition";
  line.showFrame(movingFrame(1), reading);
  line.showMessage("Drag down to press harder, up to press less; sideways moves a zoomed view.");
  QTest::qWait(1);
  const auto& said = *line.findChild<ElidedLabel*>("statusMessage");
  EXPECT_EQ(said.shownText(), said.text());
  EXPECT_TRUE(line.findChild<QLabel*>("factMu")->isVisible());
}

/// The space that is kept for the progress of the curve does not hide them, and they return after a
/// message.
TEST(StatusLine, ASmallWindowHasBothDimensionlessNumbers) {
  CurveReading reading;
  reading.mu = 0.01166;
  reading.error = 5e-5;
  reading.lines = 32;
  reading.isInterpolated = true;
  for (const Language& language : languages()) {
    useLanguage(language.code);
    reading.regime = regionText("II");
    StatusLine line;
    line.setFixedWidth(1024);
    line.show();
    Frame steady = movingFrame(1);
    steady.transient.reset();
    for (const Work::State state : {Work::State::Idle, Work::State::Running}) {
      line.showFrame(steady, reading);
      line.showWork({state, 0.5, 16000});
      line.showMessage(
          "Drag down to press harder, up to press less; sideways moves a zoomed view.");
      line.showMessage({});
      QTest::qWait(1);  // the layout is made with the first events
      for (const char* name : {"factForce", "factVelocity"}) {
        const auto& fact = *line.findChild<QLabel*>(name);
        EXPECT_TRUE(fact.isVisible()) << name << ' ' << language.code;
        EXPECT_GE(fact.width(), fact.sizeHint().width()) << name << ' ' << language.code;
      }
    }
  }
  useLanguage("en");
}

/// The numbers of the paper lose their words before one of them is left out, and what is left out
/// is told where friction stands.
TEST(StatusLine, ANarrowWindowTellsBothNumbersOfThePaper) {
  Frame frame = movingFrame(1);
  frame.transient.reset();
  CurveReading reading;
  reading.mu = 0.00012345;
  reading.error = 1e-6;
  reading.lines = 200;
  reading.notes.add(Note::FasterThanTested);
  for (const Language& language : languages()) {
    useLanguage(language.code);
    reading.regime = regionText("IV");
    StatusLine line;
    line.show();
    const auto& velocity = *line.findChild<QLabel*>("factVelocity");
    const auto& force = *line.findChild<QLabel*>("factForce");
    const auto& friction = *line.findChild<QLabel*>("factMu");
    const auto showAt = [&](int width) {
      line.setFixedWidth(width);
      line.showFrame(frame, reading);
      QTest::qWait(1);  // the layout is made with the first events
    };
    showAt(1440);
    const QString whole = velocity.text(), value = whole.section(u'=', -1);
    showAt(1024);
    for (const QLabel* number : {&force, &velocity}) {
      EXPECT_TRUE(number->isVisible()) << language.code;
      EXPECT_GE(number->width(), number->sizeHint().width()) << language.code;
    }
    EXPECT_EQ(velocity.text(), QStringLiteral("v̄ =") + value) << language.code;
    EXPECT_FALSE(friction.toolTip().contains(velocity.text())) << language.code;
    showAt(700);
    EXPECT_FALSE(velocity.isVisible()) << language.code;
    EXPECT_TRUE(friction.toolTip().contains(velocity.text())) << friction.toolTip().toStdString();
    showAt(1440);
    EXPECT_EQ(velocity.text(), whole);
  }
  useLanguage("en");
}

TEST(StatusLine, FactsAreWholeOrLeftOutHoweverNarrowTheWindow) {
  const Frame frame = movingFrame(1);
  CurveReading reading;
  reading.regime = "region II, transition";
  reading.mu = 0.001199;
  reading.error = 5e-6;
  StatusLine line;
  line.show();
  int most = 0, least = 10;
  for (const int width : {1400, 1100, 900, 700, 500, 900, 1400}) {
    line.setFixedWidth(width);
    line.showFrame(frame, reading);
    line.showWork({Work::State::Idle, 1, 16000});
    line.showDrawing(60, "software");
    QTest::qWait(1);  // the layout is made with the first events
    int shown = 0;
    for (const char* name : {"factMu", "factRegime", "factForce", "factVelocity", "factSimulations",
                             "factRate", "factBackend"}) {
      const auto& fact = *line.findChild<QLabel*>(name);
      if (fact.isHidden()) continue;
      ++shown;
      EXPECT_GE(fact.width(), fact.minimumSizeHint().width()) << name << ' ' << width;
    }
    EXPECT_FALSE(line.findChild<QLabel*>("factMu")->isHidden());
    most = std::max(most, shown);
    least = std::min(least, shown);
  }
  EXPECT_EQ(most, 7);
  EXPECT_LT(least, 4);
}

/// A mean of many lines is a long text, and a message beside it may be longer than its room.
TEST(StatusLine, TheMeanIsWholeAndApartFromWhatFollows) {
  Frame frame = movingFrame(1);
  frame.state.tangentialForce = 1.5e-4;
  frame.state.normalForce = 1;
  CurveReading reading;
  reading.mu = 0.00012345;
  reading.error = 1e-8;
  reading.lines = 123456;
  reading.isInterpolated = true;
  for (const Language& language : languages()) {
    useLanguage(language.code);
    reading.regime = regionText("II");
    StatusLine line;
    line.show();
    const auto& mu = *line.findChild<QLabel*>("factMu");
    const auto& regime = *line.findChild<QLabel*>("factRegime");
    const auto isApart = [&] {
      line.showFrame(frame, reading);
      QTest::qWait(1);  // the layout is made with the first events
      constexpr int kGap = 20;
      EXPECT_GE(mu.width(), mu.fontMetrics().horizontalAdvance(mu.text())) << line.width();
      EXPECT_TRUE(regime.isHidden() || regime.x() >= mu.geometry().right() + kGap) << line.width();
    };
    for (const int width : {700, 800, 1024, 1280, 1920}) {
      line.setFixedWidth(width);
      isApart();
    }
    line.setFixedWidth(1280);
    line.showMessage(QString("A message that has no room. ").repeated(10));
    isApart();
  }
  useLanguage("en");
}

/// While the picture settles its friction is another one than that of the steady state, however
/// narrow the line is; the word is there where it has room.
TEST(StatusLine, ASettlingPictureIsNamed) {
  StatusLine line;
  line.show();
  Frame frame = movingFrame(1);
  frame.transient.reset();
  frame.state.mu = 0.25;
  const auto& mu = *line.findChild<QLabel*>("factMu");
  const auto& word = *line.findChild<QLabel*>("factSettling");
  for (const int width : {300, 1280})
    for (const bool settles : {true, false}) {
      line.setFixedWidth(width);
      frame.isSettling = settles;
      line.showFrame(frame, {});
      EXPECT_EQ(mu.text().toStdString(), settles ? "this line μ → 0.250" : "this line μ = 0.250");
      EXPECT_EQ(mu.toolTip().contains("steady state that these numbers"), settles);
      EXPECT_EQ(word.isVisible(), settles && width > 1000);
    }
}

/// A confirmation has the room of the facts at the right, and where that is not enough it is
/// shortened in the middle and stands whole in the tooltip.
TEST(StatusLine, WhatIsSaidIsSeenWholeOrInItsTooltip) {
  StatusLine line;
  line.showFrame(movingFrame(1), {});
  line.showDrawing(60, "software");
  line.resize(1280, 30);
  line.show();
  const QString text = "On the clipboard: asperity render figure_1.json …";
  line.showMessage(text);
  QTest::qWait(1);  // the layout is made with the first events
  auto* said = line.findChild<ElidedLabel*>("statusMessage");
  ASSERT_TRUE(said);
  EXPECT_EQ(said->shownText(), text);
  EXPECT_FALSE(line.findChild<QLabel*>("factBackend")->isVisible());
  line.showMessage(text + text + text + text);
  QTest::qWait(1);
  EXPECT_NE(said->shownText(), said->text());
  EXPECT_LE(said->fontMetrics().horizontalAdvance(said->shownText()), said->width());
  QHelpEvent help(QEvent::ToolTip, {5, 5}, said->mapToGlobal(QPoint(5, 5)));
  QApplication::sendEvent(said, &help);
  EXPECT_TRUE(QToolTip::text().contains("On the clipboard"));
}

TEST(StatusLine, WaitingCanBeLeft) {
  StatusLine line;
  int back = 0;
  QObject::connect(&line.work(), &WorkIndicator::backRequested, [&] { ++back; });
  line.showWork({Work::State::Waiting, 0, 0});
  auto* button = line.findChild<QToolButton*>("workStop");
  EXPECT_FALSE(line.work().isHidden());
  EXPECT_TRUE(button->toolTip().contains("Making the line"));
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(back, 1);
  line.showWork({});
  EXPECT_TRUE(line.work().isHidden());
}

/// Before the window is there, which looks for them; gone after it.
struct WithoutLibraries {
  WithoutLibraries() {
    for (const char* variable : kVariables) qputenv(variable, "libnowhere.so.1");
  }
  ~WithoutLibraries() {
    for (const char* variable : kVariables) qunsetenv(variable);
  }
  static constexpr const char* kVariables[] = {"ASPERITY_OSMESA_LIBRARY", "ASPERITY_EGL_LIBRARY"};
};

class WithoutLibrariesTest : private WithoutLibraries, public MainWindowTest {};

TEST_F(WithoutLibrariesTest, ThePictureIsDrawnAndTheWindowGoesOn) {
  ASSERT_TRUE(waitFor([&] { return window_.canvas().framesPerSecond() > 0; }));
  EXPECT_EQ(window_.canvas().backendName(), QStringLiteral("software"));
  ASSERT_TRUE(waitForFrame());
  type("sliding.velocity", "0.125 m/s");
  ASSERT_TRUE(waitForFrame());
  EXPECT_EQ(frame()->scene->sliding.velocity, 0.125);
  EXPECT_TRUE(
      waitFor([&] { return session().curve() && session().curve()->realizationsDone > 0; }));
}

TEST(CurveReading, SaysNothingBetweenPointsThatAreFarApart) {
  CurveUpdate curve = bentCurve();
  std::erase_if(curve.points, [](const CurvePoint& point) {
    return point.velocity > 1.1e-4 && point.velocity < 30;
  });
  for (CurvePoint& point : curve.points) point.notes.add(Note::FewContacts);
  Frame frame = frameAt(1e-3);
  frame.velocity = 1e-3;
  const CurveReading between = readCurve(frame, &curve);
  EXPECT_FALSE(std::isfinite(between.mu));
  EXPECT_EQ(between.regime, "");
  EXPECT_TRUE(between.notes.empty());
  EXPECT_TRUE(std::isfinite(readCurve(frameAt(100), &curve).mu));
}

/// The present velocity is where it was, however the axis of the diagram is spaced.
TEST_F(StatusTest, ALinearAxisLeavesTheReadingsAsTheyWere) {
  Scene scene = smallScene();
  scene.sweep = {1e-4, 1e3, 36};
  scene.sliding.velocity = 3e-3;
  scene.ensemble.realizations = 8;
  window_.document().open(scene);
  const auto isRead = [&] {
    return session().averaging() == Session::Averaging::Done &&
           haveSameCurve(*session().curve()->scene, session().scene()) && frame() &&
           frame()->sceneNumber == session().sceneNumber() && !fact("factRegime").isEmpty();
  };
  ASSERT_TRUE(waitFor(isRead));
  const QString regime = fact("factRegime");
  const CurveReading before = readCurve(*frame(), session().curve());
  EXPECT_EQ(regime, "region I, linear");
  action("linearAxis").trigger();
  ASSERT_EQ(session().scene().sweep.scale, SweepScale::Linear);
  ASSERT_TRUE(waitFor(isRead));
  const CurveReading after = readCurve(*frame(), session().curve());
  EXPECT_EQ(fact("factRegime"), regime);
  EXPECT_NEAR(after.mu / before.mu, 1, 1e-6);
  EXPECT_NEAR(after.error / before.error, 1, 1e-4);
  EXPECT_EQ(after.notes, before.notes);
}

}  // namespace
}  // namespace asperity
