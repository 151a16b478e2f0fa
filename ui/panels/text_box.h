// A box for sentences. The text counts when the focus leaves or with Ctrl+Enter; Escape takes back
// what was typed; Tab goes on to the next control. GUI thread.
#pragma once

#include <QPlainTextEdit>

namespace asperity {

class TextBox : public QPlainTextEdit {
  Q_OBJECT

 public:
  explicit TextBox(QWidget* parent = nullptr);

  /// Shows the accepted text, unless someone is typing another one.
  void showText(const QString& text);

  /// Shows it whatever stands there.
  void replaceText(const QString& text);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 signals:
  void textCommitted(const QString& text);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void commit();

  QString accepted_;
};

}  // namespace asperity
