// The keys of a window. (1) Letters of menu entries: with Alt held, or in an open menu, one letter
// chooses an entry. They are chosen when a menu opens, so that every entry has its own in each
// language and in menus whose entries change; an entry whose letters are all used by others has
// none. (2) A list of all shortcuts, read from the window's present actions: first by menu, then
// actions in no menu by their property "group", then the gestures of wheel, pointer, fingers and
// arrow keys in the views. GUI thread. Cannot fail.
#pragma once

#include <QCoreApplication>
#include <QDialog>
#include <QList>
#include <QString>
#include <QStringList>

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
  QSize neededSize() const;

  QWidget* content_;
};

}  // namespace asperity
