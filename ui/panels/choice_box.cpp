#include "ui/panels/choice_box.h"

#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>

namespace asperity {

ChoiceBox::ChoiceBox(QWidget* parent) : QComboBox(parent) {
  setFocusPolicy(Qt::StrongFocus);
}

QSize ChoiceBox::sizeHint() const {
  return {QComboBox::sizeHint().width() + 8, std::max(24, fontMetrics().height() + 8)};
}

void ChoiceBox::wheelEvent(QWheelEvent* event) {
  if (hasFocus()) return QComboBox::wheelEvent(event);
  event->ignore();
}

void ChoiceBox::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPalette& colours = palette();
  const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
  painter.setPen(QPen(colours.color(hasFocus() ? QPalette::Highlight : QPalette::Mid), 1));
  painter.setBrush(isEnabled() ? colours.color(QPalette::Base) : QColor(Qt::transparent));
  painter.drawRoundedRect(frame, 5, 5);

  painter.setPen(colours.color(QPalette::Text));
  painter.drawText(rect().adjusted(9, 0, -22, 0), Qt::AlignVCenter | Qt::AlignLeft,
                   fontMetrics().elidedText(currentText(), Qt::ElideRight, width() - 31));
  if (!isEnabled()) return;
  QPainterPath chevron;
  const QPointF centre(width() - 13.0, height() / 2.0 + 0.5);
  chevron.moveTo(centre + QPointF(-3.5, -2));
  chevron.lineTo(centre + QPointF(0, 2));
  chevron.lineTo(centre + QPointF(3.5, -2));
  painter.setPen(
      QPen(colours.color(QPalette::Text), 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(chevron);
}

}  // namespace asperity
