#include "core/contact/kernels/pass.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {
namespace {

/// A free arc of the elastomer: it left the line at depth `depth` and `position`, where the line
/// has this height above its lowest point.
struct FreeArc {
  double height, depth, position;
};

/// Adds up contact spots and free arcs. The two ways to either force share nothing.
template <Output kOutput>
class Gatherer {
 public:
  Gatherer(double relaxationLength, double inverse)
      : relaxationLength_(relaxationLength), inverse_(inverse) {}

  /// Adds a segment that is in contact from end to end.
  void wholeSegment(const SegmentBounds& bounds, const Cubic& height, double depth, double length) {
    sums.depth += depth * length - bounds.heightIntegral;
    sums.stiffness += length;
    if constexpr (kOutput == Output::Everything) addContact(height, 1, depth, length);
  }
  /// Adds contact over t in [0, extent] of `height`; `along` is the distance in s for t from 0 to
  /// 1, negative where t runs backwards.
  void contact(const Cubic& height, double extent, double depth, double along) {
    const double length = std::abs(along);
    sums.depth += length * (depth * extent - height.integral(extent));
    sums.stiffness += length * extent;
    if constexpr (kOutput == Output::Everything) addContact(height, extent, depth, along);
  }
  /// Adds a free arc that ends at `to`.
  void arc(const FreeArc& from, double to) {
    const double distance = to - from.position;
    const double forgotten = -relaxationLength_ * std::expm1(-distance * inverse_);
    sums.depth += from.depth * forgotten;
    sums.stiffness += forgotten;
    sums.gaps += 1;
    if constexpr (kOutput == Output::Everything)
      sums.dissipation += 0.5 * from.depth * from.depth * -std::expm1(-2 * distance * inverse_);
  }

  PassSums sums;

 private:
  void addContact(const Cubic& height, double extent, double depth, double along) {
    const double length = std::abs(along);
    const double slopeSquared = height.integralOfSlopeSquared(extent) / length;
    addPressure(height, extent, depth, along);
    sums.dissipation += relaxationLength_ * slopeSquared;
    sums.contactLength += length * extent;
    sums.slopeSquared += slopeSquared;
  }
  /// Adds p and p w' from the pressure itself, by Gauss's three points: exact for these
  /// polynomials, and independent of the sums of depth and of dissipation.
  void addPressure(const Cubic& height, double extent, double depth, double along) {
    const double length = std::abs(along);
    constexpr double kNode = 0.7745966692414834, kOuter = 5.0 / 18, kMiddle = 8.0 / 18;
    for (const auto& [node, weight] :
         {std::pair{-kNode, kOuter}, std::pair{0.0, kMiddle}, std::pair{kNode, kOuter}}) {
      const double t = 0.5 * extent * (1 + node);
      const double slope = -height.derivative(t) / along;  // w'
      const double pressure = depth - height(t) + relaxationLength_ * slope;
      sums.pressure += weight * extent * length * pressure;
      sums.work += weight * extent * length * pressure * slope;
    }
  }

  double relaxationLength_, inverse_;
};

template <Output kOutput>
class Pass {
 public:
  Pass(const PreparedProfile& line, double depth, double relaxationLength, NodeShape* shape)
      : line_(line),
        depth_(depth),
        relaxationLength_(relaxationLength),
        // Without relaxation the free surface returns at once: exp(-s * large) is 0 for s > 0.
        inverse_(relaxationLength > 0 ? std::min(1 / relaxationLength, 1e300) : 1e300),
        lost_(-std::expm1(-line.spacing * inverse_)),
        shape_(shape),
        gatherer_(relaxationLength, inverse_) {}

  PassSums run() {
    for (std::size_t i = 0; i < line_.segments(); ++i) {
      record(i);
      segment(i);
    }
    // The arc ends at the lowest point of the next period, which is always in contact.
    if (!touching_) gatherer_.arc(arc_, line_.length);
    return gatherer_.sums;
  }

 private:
  void segment(std::size_t i) {
    const SegmentBounds bounds = line_.bounds(i);
    if (!touching_) {
      // The free surface stays below the whole segment.
      const double far = surface_ + (depth_ - surface_) * lostOver(i);
      if (bounds.lowest >= far) {
        surface_ = far;
        return;
      }
    } else if (depth_ - bounds.highest - relaxationLength_ * bounds.steepest > 0) {
      // The pressure is above 0 on the whole segment.
      gatherer_.wholeSegment(bounds, line_.segment(i), depth_, line_.segmentLength(i));
      return;
    }
    inspectSegment(i);
  }

  /// Returns the part of its depth that the free surface loses over a segment.
  double lostOver(std::size_t i) const {
    const bool whole = i > 0 && i + 1 < line_.segments();
    return whole || !line_.startsInsideSegment ? lost_
                                               : -std::expm1(-line_.segmentLength(i) * inverse_);
  }

  /// Returns the height of the free surface above the line's lowest point, y = depth - height. A
  /// height distinguishes it from the line to the last digit even where the depth is far larger
  /// than all heights, or hardly relaxes over a period.
  double freeHeight(double position) const {
    return arc_.height - arc_.depth * std::expm1(-(position - arc_.position) * inverse_);
  }

  /// A segment to examine: its height over t in [0, 1], s = start + t along.
  struct Inside {
    Cubic height;
    double start, along;
    double at(double t) const { return start + t * along; }
  };

  Inside makeInside(std::size_t i) const {
    if (line_.isMeasuredBack(i))
      return {line_.segmentBackwards(i), line_.position(i + 1), -line_.segmentLength(i)};
    return {line_.segment(i), line_.position(i), line_.segmentLength(i)};
  }

  /// Splits the segment where p changes sign; w e^(s/c) is monotone on each piece.
  void inspectSegment(std::size_t i) {
    const Inside inside = makeInside(i);
    const Cubic& z = inside.height;
    const double k = relaxationLength_ / inside.along;
    const Cubic pressure{depth_ - z.c0 - k * z.c1, -z.c1 - 2 * k * z.c2, -z.c2 - 3 * k * z.c3,
                         -z.c3};
    const StaticVector<3> zeros = zerosInside(pressure);
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
    const double height = inside.height(t);
    arc_ = {height, depth_ - height, inside.at(t)};
    touching_ = false;
  }

  void pressedPiece(const Inside& inside, double from, double to) {
    double entry = from;
    if (!touching_) {
      const auto isReached = [&](double t) { return inside.height(t) < freeHeight(inside.at(t)); };
      // Without relaxation the line is at the surface again when p vanishes, to rounding.
      const double middle = 0.5 * (from + to);
      if (isReached(to))
        entry = entryBetween(inside, from, to);
      else if (isReached(middle))
        entry = entryBetween(inside, from, middle);
      else
        return;
      gatherer_.arc(arc_, inside.at(entry));
      touching_ = true;
    }
    const double low = std::min(entry, to);
    gatherer_.contact(inside.height.about(low), std::abs(to - entry), depth_, inside.along);
  }

  /// Returns where the line reaches the relaxing surface.
  double entryBetween(const Inside& inside, double from, double to) const {
    const auto gap = [&](double t, double& derivative) {
      const double free = freeHeight(inside.at(t));
      derivative = -inside.height.derivative(t) + inside.along * inverse_ * (depth_ - free);
      return free - inside.height(t);
    };
    double ignored = 0;
    const double first = gap(from, ignored);
    if (first >= 0) return from;
    return from < to ? zeroBetween(from, to, first, gap)
                     : zeroBetween(to, from, gap(to, ignored), gap);
  }

  void record(std::size_t i) {
    if (!shape_) return;
    const double height = touching_ ? line_.heightAboveMinimum[i] : surface_;
    // rounding may place the surface above the level
    shape_->depth.push_back(std::max(depth_ - height, 0.0));
    const double p = touching_ ? depth_ - height - relaxationLength_ * line_.slopeIn[i] : 0;
    shape_->pressure.push_back(std::max(p, 0.0));
  }

  const PreparedProfile& line_;
  double depth_, relaxationLength_, inverse_, lost_;
  NodeShape* shape_;
  bool touching_ = true;  // the pass starts at the lowest point
  double surface_ = 0;    // m, height of the free surface at the start of the segment
  FreeArc arc_{};
  Gatherer<kOutput> gatherer_;
};

}  // namespace

PassSums resolvedPass(const PreparedProfile& line, double depth, double relaxationLength,
                      Output output, NodeShape* shape) {
  if (output == Output::Force)
    return Pass<Output::Force>(line, depth, relaxationLength, shape).run();
  return Pass<Output::Everything>(line, depth, relaxationLength, shape).run();
}

}  // namespace asperity
