// The preview of an export: a small picture, the first lines of a table, or the reason why there is
// none. GUI thread; owned by its parent.
#pragma once

#include <QImage>
#include <QWidget>

class QLabel;
class QPlainTextEdit;
class QStackedLayout;

namespace asperity {

class ExportPreview : public QWidget {
  Q_OBJECT

 public:
  explicit ExportPreview(QWidget* parent = nullptr);

  /// Shows a picture; transparent parts are chequered. A null image leaves the place empty. note: a
  /// line below it; may be empty.
  void showPicture(const QImage& image, const QString& note);
  void showTable(const QString& text, const QString& note);
  /// Marks the preview as out of date.
  void showWork(const QString& note);

  const QImage& image() const { return image_; }
  QString text() const;

  QSize sizeHint() const override { return {520, 380}; }
  QSize minimumSizeHint() const override { return {260, 200}; }

 private:
  class Picture;
  QImage image_;
  QStackedLayout* pages_;
  Picture* picture_;
  QPlainTextEdit* table_;
  QLabel* note_;
};

}  // namespace asperity
