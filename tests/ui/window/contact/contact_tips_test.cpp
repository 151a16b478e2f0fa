// The tips over the contact: what a reading or a sign means, where the tip stands, and what a drag
// from there does.
#include "ui/window/contact/contact_tips.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "tests/ui/window/contact/contact_canvas_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/language/translated.h"
#include "ui/window/contact/contact_canvas.h"

namespace asperity {
namespace {

using ContactTipsTest = ContactCanvasTest;
using DraggedContactTipsTest = DraggedCanvasTest;

/// What a reading means is told where it stands, and nothing elsewhere.
TEST_F(ContactTipsTest, ReadingsExplainThemselves) {
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
TEST_F(ContactTipsTest, TipsStandBesideWhatTheyExplain) {
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
TEST_F(ContactTipsTest, SignsExplainThemselvesAndLeadToTheGuide) {
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

TEST_F(DraggedContactTipsTest, TheTipSaysBeforehandWhatADragWillDo) {
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
TEST_F(DraggedContactTipsTest, OneBoxStandsOverTheContact) {
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

}  // namespace
}  // namespace asperity
