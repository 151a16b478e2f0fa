#include "ui/panels/section_header.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>

namespace asperity {

namespace {

constexpr int kChevron = 16;  // pixels, width with its gap
constexpr int kAbove = 7, kBelow = 4;

}  // namespace

SectionHeader::SectionHeader(QWidget* parent) : QAbstractButton(parent) {
  setCheckable(true);
  setChecked(true);
  setFocusPolicy(Qt::TabFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setCursor(Qt::PointingHandCursor);
}

void SectionHeader::showState(const QString& title, int changed, bool isUnfolded) {
  setText(title);
  isUnfolded_ = isUnfolded;
  remark_ = isUnfolded || changed == 0 ? QString() : tr("%1 changed").arg(changed);
  setAccessibleName(title);
  setAccessibleDescription(isUnfolded          ? tr("open section")
                           : remark_.isEmpty() ? tr("folded section")
                                               : tr("folded section, %1").arg(remark_));
  setToolTip(isOpen() ? tr("Fold this section") : tr("Open this section"));
  update();
}

QSize SectionHeader::sizeHint() const {
  QFont bold = font();
  bold.setBold(true);
  const QFontMetrics metrics(bold);
  return {kChevron + metrics.horizontalAdvance(text()), metrics.height() + kAbove + kBelow};
}

void SectionHeader::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Right && !isOpen()) return click();
  if (event->key() == Qt::Key_Left && isOpen()) return click();
  QAbstractButton::keyPressEvent(event);
}

void SectionHeader::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPalette& colours = palette();
  const QRect line = rect().adjusted(0, kAbove, 0, -kBelow);
  painter.setPen(QPen(colours.color(QPalette::Mid), 1));
  painter.drawLine(QPointF(0, 1.5), QPointF(width(), 1.5));

  const bool isHighlighted = underMouse() || hasFocus();
  const QColor ink = colours.color(isHighlighted ? QPalette::Highlight : QPalette::WindowText);
  QPainterPath chevron;
  const QPointF centre(5, line.center().y() + 0.5);
  chevron.moveTo(centre + (isUnfolded_ ? QPointF(-3.5, -2) : QPointF(-2, -3.5)));
  chevron.lineTo(centre + (isUnfolded_ ? QPointF(0, 2) : QPointF(2, 0)));
  chevron.lineTo(centre + (isUnfolded_ ? QPointF(3.5, -2) : QPointF(-2, 3.5)));
  painter.setPen(QPen(ink, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(chevron);

  QFont bold = font();
  bold.setBold(true);
  painter.setFont(bold);
  painter.setPen(ink);
  painter.drawText(line.adjusted(kChevron, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, text());
  painter.setFont(font());
  painter.setPen(colours.color(QPalette::PlaceholderText));
  painter.drawText(line, Qt::AlignVCenter | Qt::AlignRight, remark_);
}

}  // namespace asperity
