// View > Describe the contact: the sentences of the moment, in the language of the window, to be
// read, heard and copied.
#include "ui/window/contact/contact_words.h"

#include <gtest/gtest.h>

#include <QClipboard>
#include <QPlainTextEdit>
#include <QPushButton>

#include "core/base/number_text.h"
#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "ui/chart/friction_chart_model.h"

namespace asperity {
namespace {

class ContactWordsTest : public MainWindowTest {
 protected:
  ContactWords* words() { return window_.findChild<ContactWords*>("contactWords"); }
  /// Waits until the picture stands still at the steady state and the curve is whole.
  bool waitForState() {
    session().setPlaying(false);
    return waitForFrame() && waitForRest() &&
           waitFor([&] { return session().curve() && session().curve()->isComplete; });
  }
};

TEST_F(ContactWordsTest, AKeySaysThePresentNumbers) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  ASSERT_TRUE(waitForState());
  EXPECT_FALSE(words());
  QTest::keyClick(&window_, Qt::Key_D, Qt::ControlModifier);
  ASSERT_TRUE(words());
  EXPECT_TRUE(words()->isVisible());
  const QString text = words()->text();
  for (const std::string& part :
       {printedQuantity(frame()->scene->sliding.velocity, "m/s"),
        printedQuantity(frame()->state.normalForce, "N"),
        printedNumber(frame()->state.mu, 3, Zeros::Keep), std::string("The mean of 3 lines")})
    EXPECT_TRUE(text.contains(QString::fromStdString(part))) << part << "\n" << text.toStdString();
  const QStringList lines = text.split('\n');
  EXPECT_GE(lines.size(), 4);
  // The picture and the window are described by the same sentences.
  EXPECT_EQ(window_.canvas().accessibleDescription(), lines.join(' '));
  EXPECT_EQ(words()->accessibleDescription(), lines.join(' '));
}

TEST_F(ContactWordsTest, AskingAgainRenewsTheOneWindow) {
  ASSERT_TRUE(waitForState());
  action("describe").trigger();
  const QPointer<ContactWords> first = words();
  ASSERT_TRUE(first);
  const QString before = first->text();
  Scene scene = smallScene();
  scene.sliding.velocity *= 0.37;
  window_.document().edit(scene);
  ASSERT_TRUE(waitForFrame());
  EXPECT_EQ(first->text(), before);  // of the moment at which it was asked for
  first->findChild<QPushButton*>("contactWordsAgain")->click();
  const QString velocity = QString::fromStdString(printedQuantity(scene.sliding.velocity, "m/s"));
  EXPECT_TRUE(first->text().contains(velocity)) << first->text().toStdString();
  action("describe").trigger();
  EXPECT_EQ(words(), first.data());
  first->findChild<QPushButton*>("contactWordsCopy")->click();
  EXPECT_EQ(QGuiApplication::clipboard()->text(), first->text());
  QTest::keyClick(first, Qt::Key_Escape);
  EXPECT_TRUE(waitFor([&] { return first.isNull(); }));
}

TEST_F(ContactWordsTest, IsInTheLanguageOfTheWindow) {
  ASSERT_TRUE(waitForState());
  window_.setLanguage("de");
  action("describe").trigger();
  ASSERT_TRUE(words());
  EXPECT_TRUE(words()->text().contains("Die starre Linie gleitet mit 1 m/s nach rechts."));
  EXPECT_TRUE(words()->text().contains("Das Mittel über 3 Linien"));
  window_.setLanguage("en");
  EXPECT_FALSE(words());
  EXPECT_TRUE(window_.canvas().accessibleDescription().isEmpty());
}

/// A curve that is to be guessed is not given away.
TEST_F(ContactWordsTest, ConcealsWhatTheChartConceals) {
  ASSERT_TRUE(waitForState());
  session().editCurve([](FrictionChartModel& plot) { plot.conceal(AxisRange{1e-4, 10}); });
  action("describe").trigger();
  ASSERT_TRUE(words());
  EXPECT_FALSE(words()->text().contains("mean of"));
}

TEST_F(ContactWordsTest, RestsBehindThePagesWithoutAContact) {
  window_.pages().openFigures();
  EXPECT_FALSE(action("describe").isEnabled());
  window_.pages().showViews();
  EXPECT_TRUE(action("describe").isEnabled());
}

}  // namespace
}  // namespace asperity
