// What happens during a motion as strips over time, one above the other, and where a frame stands
// on a friction curve. Pure; any thread.
#pragma once

#include <span>
#include <vector>

#include "core/chart/curve_set.h"
#include "core/chart/diagram.h"
#include "core/run/frame.h"
#include "core/run/transient_sample.h"
#include "core/scene/scene.h"

namespace asperity {

/// Velocity, friction with the predicted relaxation over it, indentation and mean contact length
/// over the scene's whole duration, as far as samples go, with the estimated error of friction as a
/// band. The status says the predicted rate. spacing, period: of the line, m, so that its ripple is
/// not magnified; 0: unknown.
DiagramSheet transientSheet(const Scene& scene, std::span<const TransientSample> samples,
                            double spacing = 0, double period = 0);

/// Contact fraction as one more strip.
Diagram contactStrip(const Scene& scene, std::span<const TransientSample> samples);

/// The velocity of a frame and the steady friction of its line; of a motion the magnitude of its
/// velocity at the moment, its friction then, and both since it began.
DiagramMarker markerOf(const Frame& frame, CurveAxes axes);

/// To dimensionless axes, of the line in a frame.
AxesFactors factorsOf(const Frame& frame, CurveAxes axes);

/// How friction is about to relax after a jump of the velocity: mu_end + (mu_0 - mu_end)
/// exp(-integral of (1/tau + |v|/l) dt) from the first sample after the newest jump on, mu_end
/// being that of the last sample. x: s, y: mu. Empty where the velocity has not jumped, changes all
/// the time, or friction or rate is not known there.
std::vector<DiagramPoint> relaxationGuide(const Sliding& sliding,
                                          std::span<const TransientSample> samples);

/// The least that the axis of a strip spans, as shares of the value shown. While the line moves by
/// one node a single element enters or leaves a contact that n = contact length / spacing elements
/// carry: a ripple of some 1/n in friction and contact length, smaller by the root of the number of
/// contacts. It is the march's and not the elastomer's, so it must not fill a strip. The
/// indentation hardly notices: an element enters it with no load.
struct MinimumSpan {
  double friction = 0, indentation = 0, contactLength = 0;
};

/// spacing and period of the line in m; 0: not known, nothing is held back.
MinimumSpan minimumSpan(std::span<const TransientSample> samples, double spacing, double period);

struct AxisEnds {
  double from = 0, to = 1;
};

/// Ends of an axis for values from low to high with some air, spanning at least this share of them.
AxisEnds axisEnds(double low, double high, double least);

}  // namespace asperity
