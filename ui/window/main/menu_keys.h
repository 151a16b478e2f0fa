// The keys of a window. Letters of menu entries: with Alt held or a menu open one letter takes an
// entry. They are chosen when a menu opens, so that every entry has one of its own in each language
// and in menus that come and go; an entry whose letters are all taken has none. And a sheet of all
// shortcuts, read from the window's actions as they are: by menu, then what is in no menu by the
// action's property "group"; and what wheel, pointer, fingers and arrow keys do in the views. GUI
// thread. Cannot fail.
#pragma once

#include <QCoreApplication>
#include <QDialog>
#include <QList>
#include <QString>
#include <QStringList>

class QMainWindow;
class QMenu;

namespace asperity {

/// The texts with '&' before a letter or digit that is no other's, at the beginning of a word where
/// that can be; marks that were there go, "&&" stays.
QStringList withMnemonics(const QStringList& texts);

/// Gives the visible entries their letters whenever the menu opens from now on.
void keepMnemonics(QMenu& menu);

struct ShortcutGroup {
  struct Entry {
    QString text;  // "Undo"
    QString keys;  // "Ctrl+Z"
  };
  QString title;  // "Edit"
  QList<Entry> entries;
};

/// Groups without a key are left out.
QList<ShortcutGroup> shortcutGroups(const QMainWindow& window);

/// The gestures that contact_canvas.h and chart_view.h describe.
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
