// What people read at a point of a friction chart: its velocity, friction with its error, and what
// else is known there. Pure; any thread.
#pragma once

#include <QString>

#include "core/chart/curve_set.h"

namespace asperity {

/// Returns the curve whose series has this id (core/chart/curve_diagram.h), of the scene's friction
/// or pinned; null without one.
const NamedCurve* findCurve(const CurveSet& set, int id);

/// Returns the lines about a point in the language of the window, by the id of its series and its
/// row in it; empty where there is none.
QString pointText(const CurveSet& set, int id, int row);

}  // namespace asperity
