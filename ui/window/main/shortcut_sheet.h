// Every key of a window on one sheet, read from its actions as they are: by menu, then what is in
// no menu by the action's property "group"; and what wheel, pointer, fingers and arrow keys do in
// the views. GUI thread; belongs to its parent.
#pragma once

#include <QCoreApplication>
#include <QDialog>
#include <QList>
#include <QString>

class QMainWindow;

namespace asperity {

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

/// What contact_canvas.h and plot_view.h say of themselves.
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
