// How far the axis of a strip over time may zoom in. Pure; any thread.
#pragma once

#include <span>

#include "core/run/transient_sample.h"

namespace asperity {

/// The least that an axis spans, as shares of the value shown. While the line moves by one node a
/// single element enters or leaves a contact that n = contact length / spacing elements carry: a
/// ripple of some 1/n in friction and contact length, smaller by the root of the number of
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
