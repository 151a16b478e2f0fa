// The marks of a plot's curves, drawn alike in the plot and in its legend. GUI thread.
#pragma once

#include <QColor>
#include <QPointF>

#include "ui/chart/plot.h"
#include "ui/chart/plot_view.h"

class QFont;
class QPainter;

namespace asperity {

/// Opacity of what belongs to an older scene.
inline constexpr double kFadedOpacity = 0.3;

/// How much larger than usual the letters are, at least 1: marks and pens grow with them.
double markScale(const QFont& font);

QColor colourOf(const PlotSeries& series, const PlotColours& colours);

/// Filled with the painter's brush, as large to the eye as a circle of this radius.
void paintMark(QPainter& painter, PlotMark mark, QPointF centre, double radius);

/// Half the width of an error bar's caps, pixels.
inline constexpr double kErrorCap = 3.5;

/// From `top` to `bottom` with caps, with the painter's pen.
void paintErrorBar(QPainter& painter, double x, double top, double bottom, double cap);

}  // namespace asperity
