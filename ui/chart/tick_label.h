// Labels of ticks that say their unit themselves, for axes without a title. Pure; any thread.
#pragma once

#include <QString>

#include "ui/draw/ticks.h"

namespace asperity {

/// "5 ms", "20 %"; a power of ten is multiplied, but not with zero: "2×10⁻³ %", "0 %".
QString labelWithUnit(const Tick& tick, const AxisTicks& axis);

}  // namespace asperity
