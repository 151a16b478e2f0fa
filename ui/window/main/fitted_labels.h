// Texts and their widths: labels that fit into the width which a layout gives them, and the width
// that a place needs whose text changes. GUI thread; labels are owned by their parent. Cannot fail.
#pragma once

#include <QLabel>
#include <QStringList>

namespace asperity {

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

/// Returns the width of the widest text in the font of the widget, in pixels. A place that reserves
/// it stays as wide as it is when its text changes, so that nothing beside it moves.
int widestText(const QWidget& widget, const QStringList& texts);

}  // namespace asperity
