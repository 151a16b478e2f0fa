// Everything that can be reached has a name, keys belong to one command each, and the sheet of
// shortcuts says all of them.
#include <gtest/gtest.h>

#include <QAccessible>
#include <QDialog>
#include <QLabel>
#include <QMap>
#include <QMenu>
#include <QMenuBar>
#include <QSet>
#include <QTabWidget>

#include "tests/ui/window/main_window_fixture.h"
#include "tests/ui/window/qt_application.h"
#include "tests/ui/window/readable_widgets.h"
#include "ui/window/figures/figures_page.h"
#include "ui/window/main/scene_tabs.h"
#include "ui/window/main/window_keys.h"
#include "ui/window/map/map_panel.h"
#include "ui/window/map/map_view.h"

namespace asperity {
namespace {

using AccessibilityTest = MainWindowTest;

QString nameOf(QWidget* widget) {
  QAccessibleInterface* face = QAccessible::queryAccessibleInterface(widget);
  return face ? face->text(QAccessible::Name) : QString();
}

QString pathOf(const QWidget* widget) {
  QString path;
  for (; widget; widget = widget->parentWidget())
    path = QStringLiteral("%1(%2)/").arg(widget->metaObject()->className(), widget->objectName()) +
           path;
  return path;
}

/// Parts of a control of Qt's that stand for it and speak through it.
bool isInsideOfAControl(const QWidget* widget) {
  const QString name = widget->objectName();
  const bool isCorner = qstrcmp(widget->metaObject()->className(), "QTableCornerButton") == 0;
  const QWidget* parent = widget->parentWidget();
  const bool isList =
      parent && qstrcmp(parent->metaObject()->className(), "QComboBoxPrivateContainer") == 0;
  return isCorner || isList || name.startsWith("qt_") || name.startsWith("ScrollLeft") ||
         name.startsWith("ScrollRight");
}

TEST_F(AccessibilityTest, WhatTakesTheFocusHasAName) {
  window_.pages().figuresPage();
  int count = 0;
  for (QWidget* widget : window_.findChildren<QWidget*>()) {
    if (widget->focusPolicy() == Qt::NoFocus || isInsideOfAControl(widget)) continue;
    const auto* label = qobject_cast<QLabel*>(widget);
    if (label && !label->isVisible()) continue;  // its text is its name
    ++count;
    EXPECT_TRUE(hasSpokenName(*widget)) << pathOf(widget).toStdString();
  }
  EXPECT_GT(count, 80);
}

/// Qt passes the tooltip on where a widget has no description of its own.
TEST_F(AccessibilityTest, NoDescriptionHasMarkup) {
  window_.pages().figuresPage();
  int count = 0;
  for (QWidget* widget : window_.findChildren<QWidget*>()) {
    const QAccessibleInterface* spoken = QAccessible::queryAccessibleInterface(widget);
    const QString description = spoken ? spoken->text(QAccessible::Description) : QString();
    count += !description.isEmpty();
    EXPECT_FALSE(Qt::mightBeRichText(description))
        << pathOf(widget).toStdString() << ": " << description.toStdString();
  }
  EXPECT_GT(count, 80);
}

/// The keys of contact and chart are of no use to a person who cannot get there without a pointer.
TEST_F(AccessibilityTest, TheTabKeyComesToContactAndChart) {
  ASSERT_TRUE(waitForFrame());
  QSet<QWidget*> reached;
  window_.canvas().setFocus();
  for (QWidget* at = window_.focusWidget(); at && !reached.contains(at);
       at = window_.focusWidget()) {
    reached += at;
    QTest::keyClick(at, Qt::Key_Tab);
  }
  EXPECT_TRUE(reached.contains(&window_.canvas()));
  EXPECT_TRUE(reached.contains(&window_.plotView()));
  EXPECT_TRUE(window_.plotView().isVisible());
  EXPECT_GT(reached.size(), 20);
}

TEST_F(AccessibilityTest, ButtonsWithoutFocusHaveNamesToo) {
  for (QAbstractButton* button : window_.findChildren<QAbstractButton*>()) {
    if (isInsideOfAControl(button)) continue;
    EXPECT_FALSE(nameOf(button).isEmpty()) << pathOf(button).toStdString();
    EXPECT_NE(nameOf(button), QStringLiteral("✕"));
  }
}

TEST_F(AccessibilityTest, EveryCommandHasAText) {
  int count = 0;
  for (const QAction* each : window_.findChildren<QAction*>()) {
    if (each->isSeparator()) continue;
    // A line edit's own, and what stands for a widget in a tool bar.
    if (each->objectName().startsWith("_q_") || each->inherits("QWidgetAction")) continue;
    // What does not fit into the bar goes into a menu of its own.
    const auto* bar = each->menu() ? qobject_cast<QMenuBar*>(each->parent()->parent()) : nullptr;
    if (bar && !bar->actions().contains(const_cast<QAction*>(each))) continue;
    ++count;
    EXPECT_FALSE(each->text().isEmpty())
        << each->objectName().toStdString() << " of "
        << pathOf(qobject_cast<QWidget*>(each->parent())).toStdString();
  }
  EXPECT_GT(count, 50);
}

TEST_F(AccessibilityTest, AKeyBelongsToOneCommand) {
  QMap<QString, QString> owners;
  for (const QAction* each : window_.actions())
    for (const QKeySequence& key : each->shortcuts()) {
      EXPECT_FALSE(owners.contains(key.toString()))
          << key.toString().toStdString() << ": " << each->text().toStdString() << " and "
          << owners[key.toString()].toStdString();
      owners[key.toString()] = each->text();
    }
  EXPECT_GT(owners.size(), 20);
}

TEST_F(AccessibilityTest, TheSheetSaysEveryKey) {
  QStringList said;
  for (const ShortcutGroup& group : shortcutGroups(window_)) {
    EXPECT_FALSE(group.title.isEmpty());
    for (const ShortcutGroup::Entry& entry : group.entries) {
      EXPECT_FALSE(entry.keys.isEmpty()) << entry.text.toStdString();
      said += entry.keys;
    }
  }
  for (const QAction* each : window_.findChildren<QAction*>())
    for (const QKeySequence& key : each->shortcuts())
      if (window_.actions().contains(const_cast<QAction*>(each))) {
        const QString text = key.toString(QKeySequence::NativeText);
        EXPECT_TRUE(std::ranges::any_of(said, [&](const QString& keys) {
          return keys.split(" or ").contains(text);
        })) << text.toStdString();
      }
  EXPECT_TRUE(said.contains("Ctrl+Q")) << "on every desktop";
  auto* extra = new QAction("Something new…", &window_);
  extra->setShortcut(Qt::CTRL | Qt::ALT | Qt::Key_J);
  window_.addAction(extra);
  const QList<ShortcutGroup> groups = shortcutGroups(window_);
  const auto more = std::ranges::find(groups, "More", &ShortcutGroup::title);
  ASSERT_NE(more, groups.end());
  EXPECT_EQ(more->entries.last().text, "Something new");
  EXPECT_EQ(more->entries.last().keys, "Ctrl+Alt+J");
}

TEST_F(AccessibilityTest, TheSheetSaysWhatAKeyMeansAtAnyTime) {
  press("load.normal_force");
  ASSERT_NE(action("undo").text(), "Undo");
  QStringList meanings;
  for (const ShortcutGroup& group : shortcutGroups(window_))
    for (const ShortcutGroup::Entry& entry : group.entries)
      if (entry.keys.contains("Ctrl+Z") || entry.keys.contains("Ctrl+Y")) meanings += entry.text;
  EXPECT_EQ(meanings, (QStringList{"Undo", "Redo"}));
}

TEST_F(AccessibilityTest, TheSheetOpensByItsKeysAndClosesByEscape) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  for (const Qt::Key key : {Qt::Key_F1, Qt::Key_Question}) {
    QTest::keyClick(&window_, key);
    auto* sheet = window_.findChild<QDialog*>("shortcutSheet");
    ASSERT_TRUE(sheet);
    EXPECT_TRUE(sheet->isVisible());
    bool hasUndo = false;
    for (const QLabel* label : sheet->findChildren<QLabel*>())
      hasUndo = hasUndo || label->text() == "Ctrl+Z";
    EXPECT_TRUE(hasUndo);
    QTest::keyClick(sheet, Qt::Key_Escape);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_FALSE(window_.findChild<QDialog*>("shortcutSheet"));
  }
}

/// From the first parameter down, slider and entry of each row in turn.
TEST_F(AccessibilityTest, TabGoesThroughThePanelFromTopToBottom) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  auto& first = control<ValueSlider>("slider:sliding.velocity");
  first.setFocus();
  int row = 0;
  for (int i = 0; i < 12; ++i) {
    QWidget* before = QApplication::focusWidget();
    ASSERT_TRUE(before);
    QTest::keyClick(before, Qt::Key_Tab);
    QWidget* now = QApplication::focusWidget();
    ASSERT_TRUE(now && window_.panel().isAncestorOf(now)) << pathOf(now).toStdString();
    const int y = now->mapTo(&window_.panel(), QPoint(0, now->height() / 2)).y();
    const int was = before->mapTo(&window_.panel(), QPoint(0, before->height() / 2)).y();
    EXPECT_GE(y, was - 2) << pathOf(now).toStdString();
    row += y > was + 2;
  }
  EXPECT_GE(row, 5);
}

/// Keys as they come from the keyboard: the window's shortcuts are asked first.
TEST_F(AccessibilityTest, TheControlWithTheFocusHasItsKeys) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  const auto key = [&](Qt::Key pressed, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(window_.windowHandle(), pressed, modifiers);
  };
  const bool isPlaying = session().isPlaying();
  auto& pace = control<QAbstractButton>("keepPace");
  const bool keeps = pace.isChecked();
  pace.setFocus();
  key(Qt::Key_Space);
  EXPECT_NE(pace.isChecked(), keeps);
  auto& essentials = control<QAbstractButton>("showEssentials");
  essentials.setFocus();
  key(Qt::Key_Return);
  EXPECT_TRUE(essentials.isChecked());
  auto& slider = control<ValueSlider>("slider:load.normal_force");
  const int value = slider.value();
  slider.setFocus();
  key(Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_GT(slider.value(), value);
  key(Qt::Key_Home);
  EXPECT_EQ(slider.value(), slider.minimum());
  EXPECT_EQ(session().isPlaying(), isPlaying);
  // Elsewhere the key is the window's.
  window_.canvas().setFocus();
  key(Qt::Key_Space);
  EXPECT_NE(session().isPlaying(), isPlaying);
}

/// With Shift the arrow keys move the cross of the map in fine steps; they change the exaggeration
/// of the contact where the contact has the focus.
TEST_F(AccessibilityTest, TheMapWithTheFocusHasItsKeys) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  action("go:mapPanel").trigger();
  MapView& map = window_.tabs().map().view();
  ASSERT_TRUE(waitFor([&] { return map.focusPolicy() == Qt::StrongFocus && map.isPainted(); }));
  map.setFocus();
  const std::string before = window_.canvas().viewer().navigation().toText();
  const QSignalSpy moves(&map, &MapView::crossMoved);
  QTest::keyClick(window_.windowHandle(), Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_EQ(moves.count(), 1);
  EXPECT_EQ(window_.canvas().viewer().navigation().toText(), before);
}

}  // namespace
}  // namespace asperity
