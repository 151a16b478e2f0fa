// Labels: of several lines, for errors and warnings, those that fit into the width which a layout
// gives them, and headings. GUI thread; owned by their parent. Cannot fail.
#pragma once

#include <QFont>
#include <QLabel>
#include <QString>
#include <QStringList>

namespace asperity {

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

/// Returns the font in bold letters.
QFont boldFont(QFont font);

/// Keeps the font of a heading bold and this many times as large as that of the widget whose
/// content it heads.
void keepHeading(QLabel& heading, QWidget& of, double scale);

/// Returns the width of the widest text in the font of the widget, in pixels. A place that reserves
/// it stays as wide as it is when its text changes, so that nothing beside it moves.
int widestText(const QWidget& widget, const QStringList& texts);

}  // namespace asperity
