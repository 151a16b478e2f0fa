// The lists of theories and of measured friction in the panel, opened by key and chosen by name.
#include "ui/panels/list_box.h"

#include <gtest/gtest.h>

#include <QEvent>
#include <QMenu>
#include <QToolButton>

#include "tests/ui/panels/parameter_panel_fixture.h"
#include "tests/ui/window/qt_application.h"

namespace asperity {
namespace {

class ListBoxTest : public ParameterPanelTest {
 protected:
  ListBox& box(const QString& key) { return *control<ListBox>("list:" + key); }

  /// Opens the list of a key and presses its entry; returns the text of the box afterwards.
  QString press(const QString& key, const QString& entry) {
    box(key).setFocus();
    QTest::keyClick(&box(key), Qt::Key_Space);
    auto* menu = box(key).findChild<QMenu*>();
    auto* action = menu ? menu->findChild<QAction*>(entry) : nullptr;
    if (!action) return "no entry";
    menu->setActiveAction(action);
    QTest::keyClick(menu, Qt::Key_Return);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    return box(key).currentText();
  }
};

TEST_F(ListBoxTest, TheoriesAreChosenByTheirNames) {
  EXPECT_EQ(box("comparison.theory").currentText(), "Eq. (11)");
  EXPECT_EQ(press("comparison.theory", "shown:3"), "2 theories");
  EXPECT_EQ(panel_.scene().comparison.theory,
            (std::vector{Theory::Eq11, Theory::PerssonHalfSpace}));
  press("comparison.theory", "shown:0");
  EXPECT_EQ(press("comparison.theory", "shown:3"), "none");
  EXPECT_TRUE(panel_.scene().comparison.theory.empty());
  QTest::mouseClick(control<QToolButton>("reset:comparison.theory"), Qt::LeftButton);
  EXPECT_EQ(box("comparison.theory").currentText(), "Eq. (11)");
}

TEST_F(ListBoxTest, TablesAreTakenAwayAndAskedFor) {
  EXPECT_EQ(box("comparison.data").currentText(), "none");
  Scene scene;
  scene.comparison.data = {{"first.csv", "compound A"}, {"second.csv", {}}};
  panel_.setScene(scene);
  EXPECT_EQ(box("comparison.data").currentText(), "2 tables");
  EXPECT_EQ(press("comparison.data", "shown:0"), "second.csv");
  EXPECT_EQ(panel_.scene().comparison.data, (std::vector<DataFile>{{"second.csv", {}}}));

  QSignalSpy asked(&panel_, &ParameterPanel::frictionRequested);
  press("comparison.data", "addTable");
  EXPECT_EQ(asked.count(), 1);
}

}  // namespace
}  // namespace asperity
