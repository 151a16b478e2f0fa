// A motion as strips over time, one above the other, and the marker of a frame on a friction curve.
// Pure; any thread.
#pragma once

#include <span>
#include <vector>

#include "core/chart/curve_set.h"
#include "core/chart/diagram.h"
#include "core/run/frame.h"
#include "core/scene/scene.h"

namespace asperity {

/// Returns velocity, friction with the predicted relaxation, indentation and mean length per
/// contact over the scene's whole duration, as far as there are samples, with the estimated error
/// of friction as a band. The status shows the predicted rate. spacing, period: of the line, m, so
/// that its ripple is not magnified; 0: unknown. later: samples after the present moment, faded.
DiagramSheet transientSheet(const Scene& scene, std::span<const TransientSample> samples,
                            double spacing = 0, double period = 0,
                            std::span<const TransientSample> later = {});

/// Returns the friction of an oscillation over its velocity, a loop. Friction F_x/F_N has the sign
/// of the velocity where it resists. A ring is at the newest of `samples`; `later` ones are faded.
DiagramSheet frictionLoopSheet(std::span<const TransientSample> samples,
                               std::span<const TransientSample> later = {});

/// Returns the contact fraction as one more strip.
Diagram contactStrip(const Scene& scene, std::span<const TransientSample> samples);

/// Returns a marker at the velocity of a frame and the steady friction of its line; in a motion at
/// the magnitude of its present velocity and the present friction, with a trace of both since its
/// beginning. Over another key than velocity it stands at the scene's own value of that key. y:
/// what physical axes show. It has no name at rest on a logarithmic axis, where it is not drawn.
DiagramMarker frameMarker(const Frame& frame, CurveAxes axes, CurveQuantity y = CurveQuantity::Mu);

/// Returns the factors to dimensionless axes, for the line in a frame.
AxesFactors axesFactors(const Frame& frame, CurveAxes axes);

/// Returns the expected relaxation of friction after a jump of the velocity: mu_end + (mu_0 -
/// mu_end) exp(-integral of (1/tau + |v|/l) dt) from the first sample after the newest jump on;
/// mu_end is that of the last sample. x: s, y: mu. Empty where the velocity has not jumped, changes
/// continuously, or friction or rate is unknown.
std::vector<DiagramPoint> relaxationGuide(const Sliding& sliding,
                                          std::span<const TransientSample> samples);

/// The minimum span of a strip's axis, relative to the shown value. While the line moves by one
/// node a single element enters or leaves a contact of n = length per contact / spacing elements:
/// this causes a ripple of about 1/n in friction and length per contact, smaller by the root of the
/// number of contacts. The ripple belongs to the march and not to the elastomer, so it must not
/// fill a strip. The indentation hardly ripples: an element enters without load.
struct MinimumSpan {
  double friction = 0, indentation = 0, contactLength = 0;
};

/// Returns the minimum spans. spacing and period of the line in m; 0: unknown, there is no minimum.
MinimumSpan minimumSpan(std::span<const TransientSample> samples, double spacing, double period);

struct AxisEnds {
  double from = 0, to = 1;

  void setOn(DiagramAxis& axis) const {
    axis.from = from;
    axis.to = to;
  }
};

/// Returns the ends of an axis for values from low to high with a margin, spanning at least this
/// part of them.
AxisEnds axisEnds(double low, double high, double least);

}  // namespace asperity
