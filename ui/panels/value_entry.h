// A line for exact entry. The text counts when Enter is pressed or the focus leaves; Escape takes
// back what was typed. A refused text stays, framed in red, with the reason as tooltip. GUI thread.
#pragma once

#include <QLineEdit>

namespace asperity {

class ValueEntry : public QLineEdit {
  Q_OBJECT

 public:
  explicit ValueEntry(QWidget* parent = nullptr);

  /// Shows the accepted value, unless someone is typing another one or a refused text stands.
  void showText(const QString& text);

  /// Shows it whatever stands there.
  void replaceText(const QString& text);

  /// Red frame and the reason; an empty reason takes both away.
  void showError(const QString& reason);
  bool hasError() const { return !reason_.isEmpty(); }

 signals:
  void textCommitted(const QString& text);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void commit();

  QString accepted_;
  QString reason_;
};

}  // namespace asperity
