// A line for exact entry. The text counts when Enter is pressed or the focus leaves; Escape takes
// back what was typed. A refused text stays, framed in red; with an accepted one Enter also gives
// the keys back to the window. Undo and redo are the window's where nothing is being typed. GUI
// thread.
#pragma once

#include <QLineEdit>

namespace asperity {

class ValueEntry : public QLineEdit {
  Q_OBJECT

 public:
  explicit ValueEntry(QWidget* parent = nullptr);

  /// Shows the accepted value, unless someone is typing another one or a refused text stands. The
  /// unit stands beside the entry, where unitShown() puts it.
  void showText(const QString& text, const QString& unit = {});

  /// Shows it whatever stands there.
  void replaceText(const QString& text, const QString& unit = {});

  /// Of what stands there, if it is a number alone.
  QString unit() const { return unit_; }

  /// Which end of a text that is too long is in sight; the left one unless told.
  void setShownEnd(Qt::Edge end) { shownEnd_ = end; }

  /// Red frame and the reason; an empty reason takes both away.
  void showError(const QString& reason);
  bool hasError() const { return !reason_.isEmpty(); }

 signals:
  void textCommitted(const QString& text);
  void unitShown(const QString& unit);
  /// What was typed is gone: by Escape, or the accepted text stands again.
  void takenBack();

 protected:
  /// What was refused is given again, so that the reason is said in the new language.
  void changeEvent(QEvent* event) override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void showUnit(const QString& unit);
  void mend();
  void commit();
  bool hasOwn(const QKeyEvent& event) const;

  QString accepted_, acceptedUnit_;
  QString unit_;
  QString reason_;
  Qt::Edge shownEnd_ = Qt::LeftEdge;
};

}  // namespace asperity
