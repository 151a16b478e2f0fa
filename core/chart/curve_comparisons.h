// What a diagram shows beside its friction curve: theories, measured friction, and the strips below
// it: measured over computed friction, and the difference of two settings. Pure; any thread.
#pragma once

#include <vector>

#include "core/chart/curve_set.h"
#include "core/chart/diagram.h"

namespace asperity {

/// Adds lines where the theories are valid. Theories of this model are thin, each with a stroke of
/// its own; that of a half-space, which is another model, has a colour.
void addTheories(Diagram& diagram, const CurveSet& set);

/// Returns a sentence for each theory but Eq. (11): where it holds, or why it has no line.
std::vector<Message> theoryNotes(const CurveSet& set);

/// Adds the measured points with error bars.
void addMeasured(Diagram& diagram, const CurveSet& set);

/// Returns whether friction was computed at measured points.
bool hasResiduals(const CurveSet& set);

/// Makes the diagram of measured over computed friction at each measured point, over the axis of
/// the curves.
Diagram residualDiagram(const CurveSet& set, const DiagramAxis& x);

/// Makes the diagram of the set's difference in per cent, over the axis of the curves. A value
/// beyond the axis is a triangle at its end.
Diagram differenceDiagram(const CurveSet& set, const DiagramAxis& x);

}  // namespace asperity
