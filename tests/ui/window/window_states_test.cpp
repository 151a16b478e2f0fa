// Every state of the window in each language on a small screen: no text is cut, nothing covers
// anything else, and the window is not larger than it was asked to be. And the names that a screen
// reader speaks.
#include "tests/ui/window/window_states.h"

#include <gtest/gtest.h>

#include <QAccessible>
#include <QMenu>
#include <QTabBar>

#include "tests/ui/window/qt_application.h"
#include "tests/ui/window/readable_widgets.h"
#include "tests/ui/window/window_in.h"

namespace asperity {
namespace {

class EachSizeAndLanguage : public testing::TestWithParam<std::tuple<QSize, const char*>> {};

TEST_P(EachSizeAndLanguage, EveryStateIsTidy) {
  const auto& [size, code] = GetParam();
  const StateScenes scenes(true);
  WindowIn window(code, scenes.scene(kUsualScene));
  window->resize(size);
  std::string scene;
  for (const WindowState& state : windowStates()) {
    if (scene != state.scene || window->isWindowModified()) {
      window->document().open(scenes.scene(state.scene));
      window->findChild<QTabWidget*>("tabs")->setCurrentIndex(0);
      waitForScene(*window);
    }
    scene = state.scene;
    state.enter(*window);
    QCoreApplication::processEvents();
    EXPECT_EQ(readingFaults(*window).join('\n').toStdString(), "") << state.name;
    EXPECT_EQ(window->size(), size) << state.name;
    for (QWidget* other : QApplication::topLevelWidgets())
      if (auto* dialog = qobject_cast<QDialog*>(other); dialog && dialog->isVisible()) {
        EXPECT_EQ(readingFaults(*dialog).join('\n').toStdString(), "") << state.name;
        EXPECT_LE(dialog->width(), size.width()) << state.name;
        EXPECT_LE(dialog->height(), size.height()) << state.name;
      }
    leaveState(*window, state);
    if (state.name.starts_with("tour")) scene.clear();
  }
}

INSTANTIATE_TEST_SUITE_P(Window, EachSizeAndLanguage,
                         testing::Combine(testing::Values(QSize(1024, 700)),
                                          testing::Values("en", "de")),
                         [](const auto& each) {
                           return std::string(std::get<1>(each.param)) + "_" +
                                  std::to_string(std::get<0>(each.param).width());
                         });

class StatesInEachLanguage : public testing::TestWithParam<const char*> {};

bool isTrimmed(const QString& text) {
  return text == text.trimmed();
}

/// Spaces at the ends are spoken, or show as an odd gap.
TEST_P(StatesInEachLanguage, SpokenNamesHaveNoSpacesAtTheirEnds) {
  WindowIn window(GetParam());
  ASSERT_TRUE(window.waitForCurve());
  int count = 0;
  for (QWidget* widget : window->findChildren<QWidget*>()) {
    QAccessibleInterface* face = QAccessible::queryAccessibleInterface(widget);
    // The pane has the name of its lesson once there is one.
    if (!face || (widget->objectName() == "lessonPane" && !widget->isVisible())) continue;
    ++count;
    for (const QAccessible::Text which : {QAccessible::Name, QAccessible::Description})
      EXPECT_TRUE(isTrimmed(face->text(which)))
          << widget->objectName().toStdString() << " “" << face->text(which).toStdString() << "”";
    for (int i = 0; i < face->childCount(); ++i) {
      const QAccessibleInterface* part = face->child(i);
      if (!part || part->object()) continue;
      const QString name = part->text(QAccessible::Name);
      EXPECT_TRUE(isTrimmed(name)) << name.toStdString();
    }
  }
  for (const QAction* action : window->findChildren<QAction*>())
    for (const QString& text : {action->text(), action->iconText(), action->toolTip()})
      EXPECT_TRUE(isTrimmed(text))
          << action->objectName().toStdString() << " “" << text.toStdString() << "”";
  EXPECT_GT(count, 200);
}

INSTANTIATE_TEST_SUITE_P(Window, StatesInEachLanguage, testing::Values("en", "de"),
                         [](const auto& each) { return std::string(each.param); });

}  // namespace
}  // namespace asperity
