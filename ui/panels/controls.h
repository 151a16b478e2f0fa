// The controls that all panels and pages share: short ways to make usual ones, boxes for a choice,
// a whole number and a text, labels that fit into the width which a layout gives them, the bar with
// the title of a page, and the style of a panel. The wheel changes a choice or a number only while
// its box has the focus, so that scrolling changes nothing. GUI thread; owned by their parent.
// Cannot fail.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <QString>
#include <QStringList>
#include <functional>
#include <initializer_list>
#include <utility>

class QAction;
class QFormLayout;
class QPainter;
class QPalette;
class QProgressBar;
class QScrollArea;
class QToolButton;

namespace asperity {

/// Makes a control with the object name by which style sheets and tests find it.
template <class Control, class... Arguments>
Control* named(const QString& name, Arguments&&... arguments) {
  auto* control = new Control(std::forward<Arguments>(arguments)...);
  control->setObjectName(name);
  return control;
}

/// Widgets of several kinds, for a loop over them.
using Widgets = std::initializer_list<QWidget*>;

/// Makes a layout without margins. spacing: pixels between its items; -1: as the style says.
template <class Layout>
Layout* marginless(QWidget* parent = nullptr, int spacing = -1) {
  auto* layout = new Layout(parent);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(spacing);
  return layout;
}

/// Gives the Tab key the order of a layout, beginning after `before`: Qt puts controls last that
/// were made last. Returns the last control.
QWidget& orderTabs(QWidget& before, const QLayout& layout);

/// Makes an area without a frame in which the content scrolls, as wide as the area.
QScrollArea* scrolled(QWidget* content, Qt::ScrollBarPolicy sideways = Qt::ScrollBarAsNeeded);

/// Makes a label of several lines of plain text, which a user can select and copy.
QLabel* textLabel(const QString& name);

/// Makes such a label for an error, in the colour that errors have everywhere in a window.
QLabel* errorTextLabel(const QString& name);
enum class MessageKind { Error, Note };
/// Shows an error in such a label, or a note in the colour of other texts.
void setMessage(QLabel& label, const QString& text, MessageKind kind);

/// Makes such a label for warnings, in the colour that they have everywhere in a window.
QLabel* warningTextLabel(const QString& name);
/// Returns the warnings, each in a line after its sign.
QString warningLines(const QStringList& warnings);
/// Shows such lines; without any it hides the label.
void showWarnings(QLabel& label, const QStringList& warnings);

/// Makes a thin bar of progress without a text.
QProgressBar* thinProgress(const QString& name, int width = 120);

/// Makes a text in a font of fixed width, which a user can only read.
QPlainTextEdit* fixedText(const QString& name);

/// Makes an entry of a menu with a check mark, which lives with its owner. choose: called with the
/// new state when the user chooses the entry.
QAction* checkedEntry(QObject& owner, const QString& name, const QString& text, bool isChecked,
                      std::function<void(bool isChecked)> choose);

/// A question in plain text: titles and file names are not markup.
struct Question {
  QString name;  // of the dialog, as an object
  QString title, text, explanation{};
  QMessageBox::Icon icon = QMessageBox::Question;
};

/// Asks a question and returns the button that was pressed. answers: the buttons with their texts,
/// because not every desktop gives its standard buttons a shortcut letter. The Escape key means
/// Cancel, or the usual answer where there is no Cancel.
QMessageBox::StandardButton ask(
    QWidget* parent, const Question& question,
    std::initializer_list<std::pair<QMessageBox::StandardButton, QString>> answers,
    QMessageBox::StandardButton usual);

/// Asks the user for a file or a folder, beginning with a proposal; empty where none was chosen. It
/// stands for a dialog, so that another one can replace it.
using FileChooser = std::function<QString(QWidget* parent, const QString& proposed)>;

/// The bar with the title of a dock or a page, and at its end the button that closes it.
class TitleBar : public QWidget {
 public:
  explicit TitleBar(const QString& closeName = {}, QWidget* parent = nullptr);

  QLabel& title() { return *title_; }
  QToolButton& closeButton() { return *close_; }
  /// Puts a control between the title and the button.
  void insert(QWidget& control);

 private:
  QLabel* title_;
  QToolButton* close_;
};

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

/// Returns whether the windows of a palette are dark.
bool isDark(const QPalette& palette);

/// Returns the colour of error messages, legible on the palette's background.
QColor errorColour(const QPalette& palette);
/// Returns that of warnings.
QColor warningColour(const QPalette& palette);

QString panelStyleSheet(const QPalette& palette);
/// Returns its rules for labels that are an error, a warning or a note. The style sheet of a window
/// has them, too, for its dialogs.
QString messageStyleSheet(const QPalette& palette);

/// Sets a property on which the style sheet depends.
void setStyleProperty(QWidget& widget, const char* name, const QVariant& value);

/// A line of text that is shortened where the space is too small; the tooltip then shows all of it.
class ElidedLabel : public QLabel {
  Q_OBJECT

 public:
  explicit ElidedLabel(QWidget* parent = nullptr);

  /// Returns the text as it is shown, perhaps shortened.
  QString shownText() const;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
};

/// A text that breaks into lines. A word that is wider than a line is shortened. Its height is a
/// fixed one for the present width, because QFormLayout of Qt 6.4 writes beyond its rows where a
/// height depends on the width.
class WrappedLabel : public QLabel {
 public:
  explicit WrappedLabel(QWidget* parent = nullptr);

  bool hasHeightForWidth() const override { return false; }
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }
  /// Returns the text as it is shown, perhaps with shortened words.
  QString shownText() const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
};

/// Returns where to show a tip with this text so that it stands above a place, a rectangle on the
/// screen, or on its left, and does not cover it; on the other side where there is no room.
QPoint tipAbove(const QString& text, const QRect& place, int x);
QPoint tipBeside(const QString& text, const QRect& place);
/// Returns where to show a tip below a place.
QPoint tipBelow(const QRect& place, int x);

/// Shows the tips of what is in the widget now beside the widget, so that they do not cover what is
/// below it, to which the pointer moves next.
void keepTipsBeside(QWidget& widget);

/// Shows or hides a field of a form with its label.
void setRowShown(QFormLayout& form, QWidget* field, bool isShown);

/// Returns the font in bold letters.
QFont boldFont(QFont font);

/// Keeps the font of a heading bold and this many times as large as that of the widget whose
/// content it heads.
void keepHeading(QLabel& heading, QWidget& of, double scale);

/// Returns the width of the widest text in the font of the widget, in pixels. A place that reserves
/// it stays as wide as it is when its text changes, so that nothing beside it moves.
int widestText(const QWidget& widget, const QStringList& texts);

}  // namespace asperity
