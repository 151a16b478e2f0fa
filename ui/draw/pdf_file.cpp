#include "ui/draw/picture_file.h"

#include <QBuffer>
#include <QHashFunctions>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPainterPath>
#include <QPdfWriter>
#include <stdexcept>

#include "ui/draw/fonts.h"
#include "ui/draw/shapes.h"
#include "ui/draw/vector_shapes.h"

namespace asperity {
namespace {

constexpr int kResolution = 1200;  // dots per inch, to which the painter rounds
constexpr double kPointsPerInch = 72;
constexpr int kFieldPixels = 512;  // of an image for a field, in each direction
constexpr int kSoftPixels = 2;     // image pixels per picture pixel, in each direction

QPointF toPointF(const DrawPoint& point) {
  return {point.x, point.y};
}

QPainterPath toPath(const std::vector<Polyline>& lines, bool closed) {
  QPainterPath path;
  path.setFillRule(Qt::WindingFill);
  for (const Polyline& line : lines) {
    if (line.size() < 2) continue;
    path.moveTo(toPointF(line[0]));
    for (std::size_t i = 1; i < line.size(); ++i) path.lineTo(toPointF(line[i]));
    if (closed) path.closeSubpath();
  }
  return path;
}

QBrush toBrush(const VectorPaint& paint) {
  if (!paint.isGradient) return toQColor(paint.from);
  QLinearGradient gradient(toPointF(paint.start), toPointF(paint.end));
  gradient.setColorAt(0, toQColor(paint.from));
  gradient.setColorAt(1, toQColor(paint.to));
  return gradient;
}

void paintFill(QPainter& painter, const VectorFill& fill) {
  const QBrush brush = toBrush(fill.paint);
  // Viewers always smooth edges, so pieces overlap a little.
  painter.setPen(fill.isPieceOfMesh ? QPen(brush, 0.5) : QPen(Qt::NoPen));
  painter.setBrush(brush);
  painter.drawPath(toPath(fill.outlines, true));
}

bool isSoft(const VectorFill& fill) {
  return fill.isPieceOfMesh && (fill.paint.from.a < 1 || fill.paint.to.a < 1);
}

/// Paints translucent colours that vary in space as an image: Qt's PDF has no gradients of opacity,
/// and the edges of pieces would be visible. The image covers the whole pixels around the fills.
void paintSoft(QPainter& painter, const std::vector<VectorFill>& fills, std::size_t first,
               std::size_t last, const QRectF& shown) {
  QRectF bounds;
  for (std::size_t i = first; i < last; ++i)
    bounds |= toPath(fills[i].outlines, true).controlPointRect();
  const QRect box = (bounds & shown).toAlignedRect();
  if (box.isEmpty()) return;
  QImage image(box.size() * kSoftPixels, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  QPainter soft(&image);
  soft.scale(kSoftPixels, kSoftPixels);
  soft.translate(-box.topLeft());
  soft.setPen(Qt::NoPen);
  for (std::size_t i = first; i < last; ++i) {
    soft.setBrush(toBrush(fills[i].paint));
    soft.drawPath(toPath(fills[i].outlines, true));
  }
  soft.end();
  painter.drawImage(QRectF(box), image);
}

void paintFills(QPainter& painter, const std::vector<VectorFill>& fills, const QRectF& shown) {
  for (std::size_t i = 0; i < fills.size();) {
    std::size_t end = i;
    while (end < fills.size() && isSoft(fills[end])) ++end;
    if (end > i)
      paintSoft(painter, fills, i, end, shown);
    else
      paintFill(painter, fills[end++]);
    i = end;
  }
}

void paintStroke(QPainter& painter, const VectorStroke& stroke) {
  const QColor colour = toQColor(stroke.colour);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(
      QPen(colour, static_cast<qreal>(stroke.width), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  const QPainterPath path = toPath(stroke.lines, false);
  if (!path.isEmpty()) painter.drawPath(path);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  for (const Polyline& line : stroke.lines)
    if (line.size() == 1)
      painter.drawEllipse(toPointF(line[0]), stroke.width / 2, stroke.width / 2);
}

void paintList(QPainter& painter, const DrawList& list) {
  painter.fillRect(QRectF(0, 0, list.width, list.height), toQColor(list.background));
  for (const DrawLayer& layer : list.layers) {
    const VectorLayer vector = vectorized(layer);
    painter.save();
    const Box& clip = vector.clip;
    QRectF shown(0, 0, list.width, list.height);
    if (clip.width > 0) {
      shown &= QRectF(clip.x, clip.y, clip.width, clip.height);
      painter.setClipRect(shown);
    }
    for (const DrawField& field : layer.fields) {
      const Box box = boundingBox(field);
      if (const QImage image = fieldImage(field, kFieldPixels); !image.isNull())
        painter.drawImage(QRectF(box.x, box.y, box.width, box.height), image);
    }
    paintFills(painter, vector.fills, shown);
    for (const VectorStroke& stroke : vector.strokes) paintStroke(painter, stroke);
    painter.restore();
  }
  paintTexts(painter, list);
}

}  // namespace

void blankDate(QByteArray& pdf) {
  const QByteArray key("/CreationDate (");
  const qsizetype from = pdf.indexOf(key);
  const qsizetype to = from < 0 ? -1 : pdf.indexOf(')', from);
  for (qsizetype i = from; i >= 0 && i <= to; ++i) pdf[i] = ' ';
}

std::string pdfBytes(const DrawList& list, const PictureProperties& properties) {
  // Qt lists the fonts in the order of a hash, which would differ in every process.
  QHashSeed::setDeterministicGlobalSeed();
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&buffer);
    const QSizeF page(list.width * properties.pointsPerPixel(),
                      list.height * properties.pointsPerPixel());
    writer.setPageSize(QPageSize(page, QPageSize::Point, QString(), QPageSize::ExactMatch));
    writer.setPageMargins({0, 0, 0, 0});
    writer.setResolution(kResolution);
    writer.setTitle(QString::fromStdString(properties.title));
    writer.setCreator(QStringLiteral("Asperity"));
    writer.setDocumentXmpMetadata(
        QByteArray::fromStdString(xmpPacket(properties.title, properties.metadata)));
    QPainter painter;
    if (!painter.begin(&writer)) throw std::runtime_error("The picture cannot be written as PDF.");
    const double scale = properties.pointsPerPixel() * kResolution / kPointsPerInch;
    painter.setRenderHint(QPainter::LosslessImageRendering);
    painter.scale(scale, scale);
    paintList(painter, list);
    painter.end();
  }
  blankDate(bytes);
  return bytes.toStdString();
}

}  // namespace asperity
