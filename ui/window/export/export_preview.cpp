#include "ui/window/export/export_preview.h"

#include <QLabel>
#include <QPainter>
#include <QPlainTextEdit>
#include <QStackedLayout>
#include <QVBoxLayout>

#include "ui/language/language.h"
#include "ui/panels/controls.h"

namespace asperity {

/// The picture in the middle, as large as fits.
class ExportPreview::Picture : public QWidget {
 public:
  explicit Picture(const ExportPreview& preview) : preview_(preview) {
    setObjectName("exportPicture");
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::AlternateBase));
    const QImage& image = preview_.image_;
    if (image.isNull()) return;
    const QSizeF available = rect().adjusted(8, 8, -8, -8).size();
    const QSizeF size = QSizeF(image.size()).scaled(available, Qt::KeepAspectRatio);
    const QRectF pictureRect(
        QPointF(0.5 * (width() - size.width()), 0.5 * (height() - size.height())), size);
    if (image.hasAlphaChannel()) paintChequers(painter, pictureRect);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    // The painter takes four pixels of the image at a time, too few for less than half its size.
    const QSize pixels = (size * devicePixelRatioF()).toSize();
    const bool isSmaller = pixels.width() < image.width() && !pixels.isEmpty();
    painter.drawImage(
        pictureRect,
        isSmaller ? image.scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation) : image);
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawRect(pictureRect);
  }

 private:
  static void paintChequers(QPainter& painter, const QRectF& rect) {
    constexpr int kField = 8;  // pixels
    painter.save();
    painter.setClipRect(rect);
    painter.fillRect(rect, Qt::white);
    const QRect all = rect.toAlignedRect();
    for (int y = 0; y < all.height(); y += kField)
      for (int x = (y / kField % 2) * kField; x < all.width(); x += 2 * kField)
        painter.fillRect(all.x() + x, all.y() + y, kField, kField, QColor(0xdd, 0xdd, 0xdd));
    painter.restore();
  }

  const ExportPreview& preview_;
};

ExportPreview::ExportPreview(QWidget* parent)
    : QWidget(parent),
      pages_(new QStackedLayout),
      picture_(new Picture(*this)),
      table_(fixedText("exportTableText")),
      note_(named<QLabel>("exportNote")) {
  setObjectName("exportPreview");
  table_->setLineWrapMode(QPlainTextEdit::NoWrap);
  note_->setWordWrap(true);
  // Two lines are kept free, so that nothing moves when a note comes and goes.
  note_->setMinimumHeight(2 * QFontMetrics(note_->font()).lineSpacing());
  note_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  pages_->addWidget(picture_);
  pages_->addWidget(table_);
  auto* column = marginless<QVBoxLayout>(this);
  column->addLayout(pages_, 1);
  column->addWidget(note_);
  keepTranslated(*this, [this] {
    picture_->setAccessibleName(tr("preview"));
    table_->setAccessibleName(tr("first lines of the table"));
  });
}

void ExportPreview::showPicture(const QImage& image, const QString& note) {
  image_ = image;
  pages_->setCurrentWidget(picture_);
  picture_->update();
  note_->setText(note);
}

void ExportPreview::showTable(const QString& text, const QString& note) {
  table_->setPlainText(text);
  pages_->setCurrentWidget(table_);
  note_->setText(note);
}

void ExportPreview::showWork(const QString& note) {
  note_->setText(note);
}

QString ExportPreview::text() const {
  return table_->toPlainText();
}

}  // namespace asperity
