// The appearance of interactive charts. GUI thread.
#pragma once

#include <QColor>
#include <QFont>
#include <QPen>
#include <QPointF>

#include "core/chart/diagram.h"
#include "ui/chart/diagram_layout.h"
#include "ui/chart/diagram_style.h"
#include "ui/draw/fonts.h"
#include "ui/draw/theme.h"

class QPainter;

namespace asperity {

/// The appearance of a chart: the colours of its theme and its font; marks and pens grow with the
/// font.
struct ChartStyle {
  Theme theme = lightTheme();
  QFont font{};
  bool showsFocus = false;

  QColor background() const { return toQColor(theme.background); }
  QColor text() const { return toQColor(theme.text); }
  QColor faintText() const { return toQColor(theme.faintText); }
  QColor axis() const { return mixed(background(), text(), 0.5); }
  /// Returns the colour at labels.
  QColor grid() const { return mixed(background(), text(), isDark(theme) ? 0.19 : 0.14); }
  /// Returns the colour between them.
  QColor fineGrid() const { return mixed(background(), grid(), 0.55); }
  QColor span() const;   // of every second region, translucent
  QColor shade() const;  // the same
  QColor marker() const;
  QColor curve(const DiagramSeries& series) const;
  double scale() const;  // at least 1
  double line() const;   // pixels, height of a line of text
};

/// Returns the size of the font relative to the usual one, at least 1; marks and pens grow with it.
double markScale(const QFont& font);

/// Returns the font sizes of the ticks, in the form that the layout of pictures uses.
DiagramSizes tickSizes(const ChartStyle& style);

/// Paints a mark as in pictures, filled with the painter's brush. `size`: its width.
void paintMark(QPainter& painter, SeriesMark mark, QPointF centre, double size);

/// Paints one line of text in the middle of the place's height, like QPainter::drawText(), with the
/// lowered signs of pictures (withLoweredSigns).
void paintText(QPainter& painter, const QRectF& place, int alignment, const QString& text);

/// Paints an error bar from `top` to `bottom` with caps, with the painter's pen. It is sharp where
/// x is the middle of a column of pixels.
void paintErrorBar(QPainter& painter, double x, double top, double bottom, double cap);

/// Returns the pen of a curve.
QPen curvePen(const DiagramSeries& series, const ChartStyle& style);

}  // namespace asperity
