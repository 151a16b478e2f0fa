#include "core/contact/kernels/resolved_pass.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {
namespace {

/// A free arc of the elastomer: it left the line `depth` deep at `position`, where the line is at
/// height `rise`.
struct FreeArc {
  double rise, depth, position;
};

/// Sums for the force balance only.
class ForceGatherer {
 public:
  ForceGatherer(double memory, double inverse) : memory_(memory), inverse_(inverse) {}

  void wholeSegment(const SegmentBounds& bounds, const Cubic&, double depth, double length) {
    sums.depth += depth * length - bounds.riseIntegral;
    sums.stiffness += length;
  }
  /// Contact over t in [0, extent] of `rise`; `along` is the way in s for t from 0 to 1, negative
  /// where t runs back.
  void contact(const Cubic& rise, double extent, double depth, double along) {
    const double length = std::abs(along);
    sums.depth += length * (depth * extent - rise.integral(extent));
    sums.stiffness += length * extent;
  }
  void arc(const FreeArc& from, double to) {
    const double forgotten = -memory_ * std::expm1(-(to - from.position) * inverse_);
    sums.depth += from.depth * forgotten;
    sums.stiffness += forgotten;
  }

  ForceSums sums;

 protected:
  double memory_, inverse_;
};

/// All sums; the two ways to either force share nothing.
class StateGatherer {
 public:
  StateGatherer(double memory, double inverse)
      : force_(memory, inverse), memory_(memory), inverse_(inverse) {}

  void wholeSegment(const SegmentBounds& bounds, const Cubic& rise, double depth, double length) {
    force_.wholeSegment(bounds, rise, depth, length);
    addContact(rise, 1, depth, length);
  }
  void contact(const Cubic& rise, double extent, double depth, double along) {
    force_.contact(rise, extent, depth, along);
    addContact(rise, extent, depth, along);
  }
  void arc(const FreeArc& from, double to) {
    force_.arc(from, to);
    const double fraction = -std::expm1(-2 * (to - from.position) * inverse_);
    sums_.dissipation += 0.5 * from.depth * from.depth * fraction;
  }

  StateSums total() const {
    StateSums total = sums_;
    total.depth = force_.sums.depth;
    total.stiffness = force_.sums.stiffness;
    return total;
  }

 private:
  void addContact(const Cubic& rise, double extent, double depth, double along) {
    const double length = std::abs(along);
    const double slopeSquared = rise.integralOfSlopeSquared(extent) / length;
    addPressure(rise, extent, depth, along);
    sums_.dissipation += memory_ * slopeSquared;
    sums_.contactLength += length * extent;
    sums_.slopeSquared += slopeSquared;
    sums_.absoluteSlope += variation(rise, extent);
  }
  /// p and p w' from the pressure itself, by Gauss's three points: exact for these polynomials, and
  /// sharing nothing with the sums of depth and of dissipation.
  void addPressure(const Cubic& rise, double extent, double depth, double along) {
    const double length = std::abs(along);
    constexpr double kPlace = 0.7745966692414834, kOuter = 5.0 / 18, kMiddle = 8.0 / 18;
    for (const auto& [place, weight] :
         {std::pair{-kPlace, kOuter}, std::pair{0.0, kMiddle}, std::pair{kPlace, kOuter}}) {
      const double t = 0.5 * extent * (1 + place);
      const double slope = -rise.derivative(t) / along;  // w'
      const double pressure = depth - rise(t) + memory_ * slope;
      sums_.pressure += weight * extent * length * pressure;
      sums_.work += weight * extent * length * pressure * slope;
    }
  }
  /// Integral of |d rise / dt| over [0, extent].
  static double variation(const Cubic& rise, double extent) {
    double sum = 0, last = rise.c0;
    for (const double t : stationaryPoints(rise)) {
      if (t >= extent) break;
      sum += std::abs(rise(t) - last);
      last = rise(t);
    }
    return sum + std::abs(rise(extent) - last);
  }

  ForceGatherer force_;
  StateSums sums_;
  double memory_, inverse_;
};

template <class Gatherer>
class Pass {
 public:
  Pass(const PreparedProfile& line, double depth, double memory, NodeShape* shape)
      : line_(line),
        depth_(depth),
        memory_(memory),
        // Without memory the free surface comes back at once: exp(-s * large) is 0 for any s > 0.
        inverse_(memory > 0 ? std::min(1 / memory, 1e300) : 1e300),
        lost_(-std::expm1(-line.spacing * inverse_)),
        shape_(shape),
        gatherer(memory, inverse_) {}

  void run() {
    surface_ = 0;
    touching_ = true;
    for (std::size_t i = 0; i < line_.segments(); ++i) {
      record(i);
      segment(i);
    }
    // The lowest point of the next period takes over, always in contact.
    if (!touching_) gatherer.arc(arc_, line_.length);
  }

 private:
  void segment(std::size_t i) {
    const SegmentBounds bounds = line_.bounds(i);
    if (!touching_) {
      const double far = surface_ + (depth_ - surface_) * lostOver(i);
      if (bounds.lowest >= far) {
        surface_ = far;
        return;
      }
    } else if (depth_ - bounds.highest - memory_ * bounds.steepest > 0) {
      gatherer.wholeSegment(bounds, line_.segment(i), depth_, line_.segmentLength(i));
      return;
    }
    lookInside(i);
  }

  /// Part of its depth that the free surface loses over a segment.
  double lostOver(std::size_t i) const {
    const bool whole = i > 0 && i + 1 < line_.segments();
    return whole || !line_.startsInsideSegment ? lost_
                                               : -std::expm1(-line_.segmentLength(i) * inverse_);
  }

  /// Height of the free surface above the line's lowest point, y = depth - height: as a height it
  /// is told from the line to the last digit even where the depth is far larger than all heights,
  /// or hardly relaxes over a period.
  double freeHeight(double position) const {
    return arc_.rise - arc_.depth * std::expm1(-(position - arc_.position) * inverse_);
  }

  /// A segment to look inside: its rise over t in [0, 1], s = start + t along.
  struct Inside {
    Cubic rise;
    double start, along;
    double at(double t) const { return start + t * along; }
  };

  Inside insideOf(std::size_t i) const {
    if (line_.isMeasuredBack(i))
      return {line_.segmentBackwards(i), line_.position(i + 1), -line_.segmentLength(i)};
    return {line_.segment(i), line_.position(i), line_.segmentLength(i)};
  }

  /// Splits the segment where p changes sign; w e^(s/c) is monotone on each piece.
  void lookInside(std::size_t i) {
    const Inside inside = insideOf(i);
    const Cubic& rise = inside.rise;
    const double k = memory_ / inside.along;
    const Cubic pressure{depth_ - rise.c0 - k * rise.c1, -rise.c1 - 2 * k * rise.c2,
                         -rise.c2 - 3 * k * rise.c3, -rise.c3};
    const Few<3> zeros = zerosInside(pressure);
    const bool onwards = inside.along > 0;
    double from = onwards ? 0 : 1;
    const auto piece = [&](double to) {
      if (pressure(0.5 * (from + to)) > 0)
        pressedPiece(inside, from, to);
      else if (touching_)
        leave(inside, from);
      from = to;
    };
    for (int n = 0; n < zeros.count; ++n)
      piece(zeros.values[static_cast<std::size_t>(onwards ? n : zeros.count - 1 - n)]);
    piece(onwards ? 1 : 0);
    if (!touching_) surface_ = freeHeight(line_.position(i + 1));
  }

  void leave(const Inside& inside, double t) {
    const double rise = inside.rise(t);
    arc_ = {rise, depth_ - rise, inside.at(t)};
    touching_ = false;
  }

  void pressedPiece(const Inside& inside, double from, double to) {
    double entry = from;
    if (!touching_) {
      const auto isReached = [&](double t) { return inside.rise(t) < freeHeight(inside.at(t)); };
      // Where nothing is remembered the line is back at the surface when p vanishes, to rounding.
      const double middle = 0.5 * (from + to);
      if (isReached(to))
        entry = entryBetween(inside, from, to);
      else if (isReached(middle))
        entry = entryBetween(inside, from, middle);
      else
        return;
      gatherer.arc(arc_, inside.at(entry));
      touching_ = true;
    }
    const double low = std::min(entry, to);
    gatherer.contact(inside.rise.about(low), std::abs(to - entry), depth_, inside.along);
  }

  /// Where the line catches up with the relaxing surface.
  double entryBetween(const Inside& inside, double from, double to) const {
    const auto gap = [&](double t, double& derivative) {
      const double free = freeHeight(inside.at(t));
      derivative = -inside.rise.derivative(t) + inside.along * inverse_ * (depth_ - free);
      return free - inside.rise(t);
    };
    double ignored = 0;
    const double first = gap(from, ignored);
    if (first >= 0) return from;
    return from < to ? zeroBetween(from, to, first, gap)
                     : zeroBetween(to, from, gap(to, ignored), gap);
  }

  void record(std::size_t i) {
    if (!shape_) return;
    const double height = touching_ ? line_.rise[i] : surface_;
    shape_->depth.push_back(std::max(depth_ - height, 0.0));  // rounding may come out above
    const double slope = line_.slopeIn[i];
    const double p = touching_ ? depth_ - line_.rise[i] - memory_ * slope : 0;
    shape_->pressure.push_back(std::max(p, 0.0));
  }

  const PreparedProfile& line_;
  double depth_, memory_, inverse_, lost_;
  NodeShape* shape_;
  bool touching_ = true;
  double surface_ = 0;  // m, height of the free surface at the start of the segment
  FreeArc arc_{};

 public:
  Gatherer gatherer;
};

}  // namespace

ForceSums forceAt(const PreparedProfile& line, double depth, double memoryLength) {
  Pass<ForceGatherer> pass(line, depth, memoryLength, nullptr);
  pass.run();
  return pass.gatherer.sums;
}

StateSums stateAt(const PreparedProfile& line, double depth, double memoryLength,
                  NodeShape* shape) {
  Pass<StateGatherer> pass(line, depth, memoryLength, shape);
  pass.run();
  return pass.gatherer.total();
}

}  // namespace asperity
