#include "ui/window/contact/contact_veil.h"

#include <QPainter>

#include "ui/draw/fonts.h"

namespace asperity {

ContactVeil::ContactVeil(QWidget& canvas) : QLabel(&canvas) {
  setObjectName("contactVeil");
  setAlignment(Qt::AlignCenter);
  setWordWrap(true);
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

void ContactVeil::showReason(const QString& reason) {
  setText(reason);
  setVisible(!reason.isEmpty());
}

void ContactVeil::setTheme(const Theme& theme) {
  QPalette palette;
  palette.setColor(QPalette::Window, toQColor(theme.background));
  palette.setColor(QPalette::WindowText, toQColor(theme.text));
  palette.setColor(QPalette::Mid, toQColor(theme.faintText));
  setPalette(palette);
}

/// Paints the text on a plate, because lines shine through beside it.
void ContactVeil::paintEvent(QPaintEvent*) {
  constexpr int kAir = 8;  // pixels
  constexpr float kOpacity = 0.7F;
  const int flags = static_cast<int>(alignment()) | Qt::TextWordWrap;
  QPainter painter(this);
  const QColor ground = palette().color(QPalette::Window);
  QColor shade = ground;
  shade.setAlphaF(kOpacity);
  painter.fillRect(rect(), shade);
  const QRect place = rect().adjusted(2 * kAir, kAir, -2 * kAir, -kAir);
  const QRect plate = painter.fontMetrics().boundingRect(place, flags, text());
  painter.setPen(palette().color(QPalette::Mid));
  painter.setBrush(ground);
  painter.drawRect(plate.adjusted(-kAir, -kAir / 2, kAir, kAir / 2));
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(place, flags, text());
}

}  // namespace asperity
