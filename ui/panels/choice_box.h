// Boxes of the panels for a choice, a whole number and a text, and the style that all controls
// share. The wheel changes a choice or a number only while its box has the focus, so that scrolling
// changes nothing. GUI thread; owned by their parent. Cannot fail.
#pragma once

#include <QComboBox>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <QString>

class QPalette;

namespace asperity {

class ChoiceBox : public QComboBox {
 public:
  explicit ChoiceBox(QWidget* parent = nullptr);
  QSize sizeHint() const override;

  /// Sets a text that is painted instead of that of the current entry, and determines the width;
  /// empty: the current entry does both.
  void setShownText(const QString& text);
  QString shownText() const { return shown_.isEmpty() ? currentText() : shown_; }

 protected:
  void wheelEvent(QWheelEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  QString shown_;
};

class SpinBox : public QSpinBox {
 public:
  explicit SpinBox(QWidget* parent = nullptr);

 protected:
  void wheelEvent(QWheelEvent* event) override;
};

class TextBox : public QPlainTextEdit {
  Q_OBJECT

 public:
  explicit TextBox(QWidget* parent = nullptr);

  /// Shows the accepted text, unless the user is typing another one.
  void showText(const QString& text);

  /// Shows the text in any case.
  void replaceText(const QString& text);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 signals:
  void textCommitted(const QString& text);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void commit();

  QString accepted_;
};

/// Returns whether the windows of a palette are dark.
bool isDark(const QPalette& palette);

/// Returns the colour of error messages, legible on the palette's background.
QColor faultColour(const QPalette& palette);

QString panelStyleSheet(const QPalette& palette);

}  // namespace asperity
