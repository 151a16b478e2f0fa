// The keys of a window. (1) Letters of menu entries: with Alt held, or in an open menu, one letter
// chooses an entry. They are chosen when a menu opens, so that every entry has its own in each
// language and in menus whose entries change; an entry whose letters are all used by others has
// none. (2) A list of all shortcuts, read from the window's present actions: first by menu, then
// actions in no menu by their property "group", then the gestures of wheel, pointer, fingers and
// arrow keys in the views. (3) Keys that a control with the focus handles, although they are
// shortcuts of the window or press the default button of a dialog elsewhere. GUI thread. Cannot
// fail.
#pragma once

#include <QCoreApplication>
#include <QDialog>
#include <QList>
#include <QObject>
#include <QString>
#include <QStringList>

class QKeyEvent;
class QMainWindow;
class QMenu;

namespace asperity {

/// Returns the texts with '&' before a letter or digit that no other text has, at the beginning of
/// a word where possible. Earlier marks are removed, "&&" stays.
QStringList withMnemonics(const QStringList& texts);

/// Assigns letters to the visible entries each time the menu opens.
void keepMnemonics(QMenu& menu);

struct ShortcutGroup {
  struct Entry {
    QString text;  // "Undo"
    QString keys;  // "Ctrl+Z"
  };
  QString title;  // "Edit"
  QList<Entry> entries;
};

/// Returns the groups; those without a key are left out.
QList<ShortcutGroup> shortcutGroups(const QMainWindow& window);

/// Returns the gestures that contact_canvas.h and chart_view.h describe.
QList<ShortcutGroup> gestureGroups();

class ShortcutSheet : public QDialog {
  Q_DECLARE_TR_FUNCTIONS(asperity::ShortcutSheet)

 public:
  ShortcutSheet(const QMainWindow& window, QWidget* parent);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void arrange(qsizetype columns);
  QSize neededSize() const;
  void scaleLetters(double factor);

  QList<ShortcutGroup> groups_;
  QList<QWidget*> widgets_;  // one for each group
  QWidget* content_;
};

/// Leaves keys to the control of the window that has the focus: the space bar presses a button and
/// does not pause the run, Home goes to the end of a slider and does not fit the picture. Return
/// presses a button, too. Owned by its window.
class FocusKeys : public QObject {
 public:
  explicit FocusKeys(QWidget& window);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget& window_;
};

/// Presses the button of a dialog that has the focus where the key is Return; in an entry Return
/// ends the entry, not the dialog. Returns whether the key is Return.
bool pressByReturn(const QDialog& dialog, QKeyEvent& event);

}  // namespace asperity
