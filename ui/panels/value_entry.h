// A line for exact entry. The text is accepted when Enter is pressed or the focus leaves; Escape
// discards it. A refused text stays, framed in red; after an accepted one Enter also returns the
// keys to the window. A number with more digits than fit is shown rounded, and whole with the focus
// and in the tooltip. Undo and redo belong to the window unless the user is typing. GUI thread.
#pragma once

#include <QLineEdit>

namespace asperity {

class ValueEntry : public QLineEdit {
  Q_OBJECT

 public:
  explicit ValueEntry(QWidget* parent = nullptr);

  /// Shows the accepted value, unless the user is typing another one or a text was refused. The
  /// unit is beside the entry, where unitShown() puts it.
  void showText(const QString& text, const QString& unit = {});

  /// Shows the text in any case.
  void replaceText(const QString& text, const QString& unit = {});

  /// Sets the name that screen readers speak, with the unit that is shown beside the entry.
  void setSpokenName(const QString& name);

  /// Returns the unit of the present text, if that is only a number.
  QString unit() const { return unit_; }

  /// Sets which end of a long text is visible; the default is the left one.
  void setShownEnd(Qt::Edge end) { shownEnd_ = end; }

  /// Shows a red frame and the reason; an empty reason removes both.
  void showError(const QString& reason);
  bool hasError() const { return !reason_.isEmpty(); }
  /// Returns why the text is refused; empty where it is not.
  const QString& errorText() const { return reason_; }

  /// Returns the text as it is shown: without the focus, a number that does not fit is rounded, and
  /// another text is shortened with a sign at its hidden end.
  QString shownText() const;

 signals:
  void textCommitted(const QString& text);
  void unitShown(const QString& unit);
  /// Emitted for the arrows up and down, PageUp and PageDown, after typed text was passed on.
  void stepped(int key, Qt::KeyboardModifiers modifiers);
  /// Emitted when the input was discarded: by Escape, or because it is the accepted text again.
  void entryRestored();

 protected:
  /// Submits a refused text again, so that the reason appears in the new language.
  void changeEvent(QEvent* event) override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  QRect textRect() const;
  void showUnit(const QString& unit);
  void speakName();
  void correctText();
  void commit();
  bool handlesKey(const QKeyEvent& event) const;

  QString accepted_, acceptedUnit_;
  QString unit_;
  QString spokenName_;
  QString reason_;
  Qt::Edge shownEnd_ = Qt::LeftEdge;
};

}  // namespace asperity
