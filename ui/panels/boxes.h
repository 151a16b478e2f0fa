// Boxes for a choice, a whole number and a text. The wheel changes a choice or a number only while
// its box has the focus, so that scrolling changes nothing. GUI thread; owned by their parent.
// Cannot fail.
#pragma once

#include <QComboBox>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <QString>

class QPainter;

namespace asperity {

enum class Chevron { Down, Right };

/// Draws the mark of a list or of a section that opens; colour and size as the letters beside it.
void drawChevron(QPainter& painter, const QPointF& centre, Chevron direction, const QColor& colour,
                 double size = 1);

class ChoiceBox : public QComboBox {
 public:
  explicit ChoiceBox(QWidget* parent = nullptr);
  QSize sizeHint() const override;

  /// Sets a text that is painted instead of that of the current entry, and determines the width;
  /// empty: the current entry does both.
  void setShownText(const QString& text);
  QString shownText() const { return shown_.isEmpty() ? currentText() : shown_; }

  /// Sets what screen readers speak. On Linux Qt gives them the current entry in place of the name,
  /// so the description begins with the name.
  void setSpoken(const QString& name, const QString& description = {});
  /// Gives the list of entries the name of the box. A list that does not exist yet gets it as soon
  /// as Qt makes it.
  void nameList();

 protected:
  void childEvent(QChildEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  QString shown_;
  bool isListNamed_ = false;  // whether nameList() was called
};

/// Chooses the entry of a list that has this word as its data, if there is one.
void chooseWord(QComboBox& box, const QString& word);
/// Returns the word of the chosen entry.
QString chosenWord(const QComboBox& box);

class SpinBox : public QSpinBox {
 public:
  explicit SpinBox(QWidget* parent = nullptr);

 protected:
  void wheelEvent(QWheelEvent* event) override;
};

/// A box for a text of several lines, which is as high as the text within limits; a longer text is
/// scrolled.
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
  void changeEvent(QEvent* event) override;

 private:
  double lineHeight() const;
  double textHeight() const;
  void fitToText();
  void commit();

  QString accepted_;
};

}  // namespace asperity
