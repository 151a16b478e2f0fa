// Ranges of logarithmic axes that fit the data and stay where they are while data arrive.
// Plain values; any thread.
#pragma once

#include <QString>

#include "ui/chart/plot.h"

namespace asperity {

/// The whole decades around [low, high]; both positive and finite.
DecadeRange decadesAround(double low, double high);

/// The range to show next. It grows at once where the data need it, and shrinks only when
/// `mayShrink` and an end lies two decades or more outside the data.
DecadeRange steadyRange(const DecadeRange& shown, const DecadeRange& needed, bool mayShrink);

/// A few digits for reading, not for computing, as everywhere: shortNumber() of ui/draw.
QString readingLabel(double value, int digits = 3);

}  // namespace asperity
