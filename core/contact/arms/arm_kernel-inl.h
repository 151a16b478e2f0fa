// This file has the pass of arm_pass.h with the arms in the lanes of vectors: it finds where
// contact begins and ends along the line. The algorithm is that of arm_pass.cpp,
// with three differences. Contact moves on in batches of segments, one segment in each lane where
// all of them are judged at once. Roots are searched from the cubic through the values and slopes
// at both ends, so that few evaluations of all arms are needed. Inside a free segment only the
// intervals that lie below the highest free surface are looked at. The file is compiled once per
// instruction set.

#if defined(ASPERITY_ARM_KERNEL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ASPERITY_ARM_KERNEL_INL
#undef ASPERITY_ARM_KERNEL_INL
#else
#define ASPERITY_ARM_KERNEL_INL
#endif

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/contact/arms/arm_element-inl.h"
#include "core/contact/arms/arm_pass.h"
#include "core/contact/line/prepared_profile.h"

HWY_BEFORE_NAMESPACE();
namespace asperity {
namespace HWY_NAMESPACE {

/// Returns the zero of a smooth function between `low` and `high`, where its values have different
/// signs. Newton's method is used, and halving where that leads away. It ends after a step of
/// `tolerance` times the place: the error that is left is of the order of the step's square, and
/// the sums of a pass change with the square of that again.
template <class Function>
HWY_INLINE double zeroNear(double guess, double low, double high, bool rising, double tolerance,
                           const Function& function) {
  double t = guess > low && guess < high ? guess : 0.5 * (low + high), lastStep = high - low;
  for (int i = 0; i < 200; ++i) {
    const ValueAndSlope at = function(t);
    if (at.value == 0) return t;
    ((at.value < 0) == rising ? low : high) = t;
    const double step = at.slope != 0 ? -at.value / at.slope : high - low;
    const double next = t + step;
    if (std::abs(step) <= tolerance * std::abs(t)) return std::clamp(next, low, high);
    const bool isGood = next > low && next < high && std::abs(step) <= 0.5 * std::abs(lastStep);
    const double to = isGood ? next : 0.5 * (low + high);
    if (to == t || to == low || to == high) return to;
    lastStep = to - t;
    t = to;
  }
  return t;
}

/// Returns where the cubic through two values and slopes vanishes, as a guess. The two values have
/// different signs.
HWY_INLINE double hermiteZero(double low, ValueAndSlope atLow, double high, ValueAndSlope atHigh) {
  const double width = high - low;
  const Cubic cubic =
      hermiteCubic(atLow.value, atHigh.value, atLow.slope * width, atHigh.slope * width);
  constexpr double kEnough = 1e-4;
  const double secant = atLow.value / (atLow.value - atHigh.value);
  const double t = zeroNear(secant, 0, 1, atHigh.value > atLow.value, kEnough, [&](double u) {
    return ValueAndSlope{cubic(u), cubic.derivative(u)};
  });
  return low + t * width;
}

class ArmKernel {
 public:
  ArmKernel(const PreparedProfile& line, const ArmVectors& vectors, ArmWorkspace& work)
      : line_(line), vectors_(vectors), work_(work), element_(vectors, work) {}

  template <bool Everything>
  void run(double depth, const double* strain) {
    depth_ = depth;
    sums_ = {};
    free_.begin(line_.spacing);
    work_.lengths.clear();
    level_ = 0;
    touching_ = true;
    entryHeight_ = contactStart_ = 0;
    element_.begin(strain);
    // The pass goes on as far as contact or a free arc lasts, from the lowest point on.
    for (std::size_t i = 0; i < line_.segments();)
      i = touching_ ? contactSegments<Everything>(i) : freeSegments<Everything>(i);
    if (touching_) {
      if constexpr (Everything) sums_.work += elasticWork(0);
      work_.addLength(std::max(line_.length - contactStart_, 0.0));
      // Where contact never ended its length is the period, without the rounding of a sum.
      if (Everything && work_.wasComplete()) sums_.contactLength = line_.length;
    } else {
      // The lowest point takes over.
      endArc<Everything>(line_.length);
    }
    // The creep of the other arms, which change much in a period, follows from their strains.
    for (std::size_t k = 0; k < vectors_.slow; ++k) work_.creepChange[k] = element_.creep()[k];
    for (std::size_t k = vectors_.slow; k < vectors_.arms; ++k)
      work_.creepChange[k] = strain[k] - element_.strains()[k];
    work_.sums = sums_;
  }

  /// Finds the strains (m) at the lowest point in complete contact, as ArmPass::completeStrains.
  void completeStrains(double* strain) {
    std::fill_n(strain, vectors_.arms, 0.0);
    element_.begin(strain);
    depth_ = 0;
    const std::size_t last = line_.segments() - 1;
    element_.advance(makePiece(makeInside(0), 0, 1), 1);
    SegmentBatch batch;
    for (std::size_t i = 1; i < last; i += SegmentBatch::kCount) {
      const std::size_t count = std::min(SegmentBatch::kCount, last - i);
      loadSegments(i, count, batch);
      element_.drive(batch);
      element_.take<false>(batch, count, line_.spacing, sums_);
    }
    element_.advance(makePiece(makeInside(last), 1, 0), 1);
    for (std::size_t k = 0; k < vectors_.arms; ++k) {
      const double inverse = vectors_.arm.from(k)[ArmVectors::Inverse * kWidestVector];
      strain[k] = element_.strains()[k] / -std::expm1(-line_.length * inverse);
    }
  }

 private:
  static constexpr int kMaxEvents = 64;               // in one segment, as in arm_pass.cpp
  static constexpr double kPositionTolerance = 1e-6;  // of a last step, relative to the place

  /// A segment to look inside, as in arm_pass.h.
  struct Inside {
    Cubic height;
    double start, along;
    double at(double t) const { return start + t * along; }
  };

  HWY_INLINE Inside makeInside(std::size_t i) const {
    const bool isLast = i + 1 == line_.segments();
    const std::size_t first = isLast ? i + 1 : i, second = isLast ? i : i + 1;
    const double length = line_.segmentLength(i);
    const double in = line_.slopeIn[i] * length, out = line_.slopeAtEnd(i) * length;
    return {hermiteCubic(line_.heightAboveMinimum[first], line_.heightAboveMinimum[second],
                         isLast ? -out : in, isLast ? -in : out),
            isLast ? line_.length : line_.position(i), isLast ? -length : length};
  }

  HWY_INLINE ContactPiece makePiece(const Inside& inside, double from, double to) const {
    const Cubic height = inside.height.about(from);
    const double step = to - from;
    return {{depth_ - height.c0, -height.c1 * step, -height.c2 * step * step,
             -height.c3 * step * step * step},
            std::abs(step * inside.along)};
  }

  /// Returns what has been put into the elements' own springs since contact began, up to this
  /// height.
  double elasticWork(double height) const {
    return (entryHeight_ - height) * (depth_ - 0.5 * (entryHeight_ + height));
  }

  // ---- In contact

  /// Takes whole segments in contact as long as pressure surely lasts, then looks inside of one.
  /// Returns the next segment.
  template <bool Everything>
  std::size_t contactSegments(std::size_t i) {
    const std::size_t last = line_.segments() - 1;
    if (i == 0) return inspectSegment<Everything>(i, nullptr);
    SegmentBatch batch;
    while (i < last) {
      const std::size_t count = std::min(SegmentBatch::kCount, last - i);
      const Segments segments = loadSegments(i, count, batch);
      element_.drive(batch);
      const std::size_t lasting = std::min(lastingIn(segments, batch), count);
      if constexpr (Everything) sums_.pressure += depthIn(segments, lasting);
      sums_.depth += depthIn(segments, lasting);
      element_.template take<Everything>(batch, lasting, line_.spacing, sums_);
      i += lasting;
      if (lasting == count) continue;
      const ValueAndSlope after =
          element_.pressureAfter(batch, lasting, makePiece(makeInside(i), 0, 1));
      return inspectSegment<Everything>(i, &after);
    }
    return inspectSegment<Everything>(i, nullptr);
  }

  /// Heights (m) at both ends of the segments of a batch, D_k and the mean height.
  struct Segments {
    One begin, end, d0, d1, d2, mean;
  };

  /// Loads the first `count` segments of a batch from segment i on. The lanes after them are flat.
  HWY_INLINE Segments loadSegments(std::size_t i, std::size_t count, SegmentBatch& batch) const {
    const double* height = line_.heightAboveMinimum.data() + i;
    const double* slopeOut = line_.slopeOut.empty() ? line_.slopeIn.data() : line_.slopeOut.data();
    const One h = One::all(line_.spacing);
    Segments s;
    s.begin = One::loadFirst(height, count);
    s.end = One::loadFirst(height + 1, count);
    // Hermite's cubic, as in polynomial.h.
    const One in = h * One::loadFirst(line_.slopeIn.data() + i, count),
              out = h * One::loadFirst(slopeOut + i, count), step = s.end - s.begin;
    const One c2 = mulSub(One::all(3), step, in + in + out),
              c3 = negMulAdd(One::all(2), step, in + out);
    s.d0 = -in;
    s.d1 = -(c2 + c2);
    s.d2 = One::all(-3) * c3;
    s.mean = mulAdd(One::all(1.0 / 12), in - out, One::all(0.5) * (s.begin + s.end));
    s.d0.store(batch.d0);
    s.d1.store(batch.d1);
    s.d2.store(batch.d2);
    return s;
  }

  /// Returns over how many segments, from the first on, pressure surely lasts.
  HWY_INLINE std::size_t lastingIn(const Segments& s, const SegmentBatch& batch) const {
    const One zero = One::all(0), depth = One::all(depth_), h = One::all(line_.spacing),
              glassy = One::all(element_.glassy()),
              perLength = One::all(element_.dashpot() / line_.spacing);
    const One rise = s.d0 + s.d1 + s.d2;
    // These are pressure and its slope at both ends of each segment.
    const One before = mulAdd(perLength, s.d0, depth - s.begin + One::load(batch.strainSum));
    const One slopeBefore =
        mulAdd(s.d0, glassy, mulSub(perLength, s.d1, h * One::load(batch.lossSum)));
    const One after = mulAdd(perLength, rise, depth - s.end + One::load(batch.strainSum + 1));
    const One slopeAfter = mulAdd(
        rise, glassy, mulSub(perLength, s.d1 + s.d2 + s.d2, h * One::load(batch.lossSum + 1)));
    // As in firstZero().
    const One third = One::all(1.0 / 3);
    const OneMask lasts = (before > zero) & (after > zero) &
                          (mulAdd(third, slopeBefore, before) > zero) &
                          (negMulAdd(third, slopeAfter, after) > zero);
    return static_cast<std::size_t>(std::countr_one(bitsOf(lasts)));
  }

  /// Returns the integral (m^2) of w over the first `count` segments.
  HWY_INLINE double depthIn(const Segments& s, std::size_t count) const {
    const One w = onlyIn({hn::FirstN(kTag, count)}, One::all(depth_) - s.mean);
    return line_.spacing * sumOf(w);
  }

  /// Returns the first place from `from` towards `to` where contact or a free interval ends, or
  /// kNoZero. `function` is the pressure or the clearance.
  template <class Function>
  static double firstEnd(double from, ValueAndSlope first, double to, ValueAndSlope last,
                         const Function& function) {
    // Right where an interval begins the function is 0 to rounding.
    first.value = std::max(first.value, 0.0);
    return firstZero(from, first, to, last, function,
                     [&](double a, ValueAndSlope atA, double b, ValueAndSlope atB) {
                       const bool isBracketed = atA.value > 0;
                       const double guess =
                           isBracketed ? hermiteZero(a, atA, b, atB) : 0.5 * (a + b);
                       return zeroNear(guess, std::min(a, b), std::max(a, b), a > b,
                                       kPositionTolerance, function);
                     });
  }

  /// Follows contact from `from` on and returns where it ends, or `to`. atEnd: the pressure at `to`
  /// as long as contact lasts, if known.
  template <bool Everything>
  double followContact(const Inside& inside, double from, double to, const ValueAndSlope* atEnd) {
    const ContactPiece piece = makePiece(inside, from, to);
    if (!(piece.length > 0)) return to;
    const double found = findSeparation(piece, atEnd), u = std::min(found, 1.0);
    sums_.depth += piece.length * piece.depth.integral(u);
    if (u > 0) {
      if constexpr (Everything) element_.gatherPiece(piece.until(u), sums_);
      element_.advance(piece, u);
    }
    if (found > 1) return to;
    const double at = from + u * (to - from);
    leave<Everything>(inside.at(at), inside.height(at));
    return at;
  }

  /// Returns where pressure ends on the piece, or kNoZero.
  double findSeparation(const ContactPiece& piece, const ValueAndSlope* atEnd) {
    const ValueAndSlope before = element_.pressure(piece);
    if (before.value <= 0 && before.slope <= 0) return 0;
    const ValueAndSlope after = atEnd ? *atEnd : element_.pressureAt(piece, 1);
    return firstEnd(0, before, 1, after, [&](double u) { return element_.pressureAt(piece, u); });
  }

  template <bool Everything>
  void leave(double position, double height) {
    // Rounding may have the end before the start, where a fast arm would grow out of the numbers.
    position = std::max(position, contactStart_);
    work_.addLength(position - contactStart_);
    touching_ = false;
    level_ = 0;
    arcStart_ = position;
    leftHeight_ = height;
    recovered_ = 0;
    if constexpr (Everything) sums_.work += elasticWork(height);
    element_.setFree(depth_ - height);
  }

  // ---- Free

  template <bool Everything>
  void endArc(double position) {
    const double length = std::max(position - arcStart_, 0.0);
    work_.addLength(length);
    free_.add(arcStart_ - contactStart_, length);
    sums_.gaps = free_.count();
    element_.template endArc<Everything>(length, sums_);
  }

  template <bool Everything>
  void enter(double position, double height) {
    position = std::max(position, arcStart_);
    endArc<Everything>(position);
    touching_ = true;
    contactStart_ = position;
    entryHeight_ = height;
  }

  /// Takes as many segments as the line surely stays above the free surface, in blocks of growing
  /// size, then looks inside of one. Returns the next segment.
  template <bool Everything>
  std::size_t freeSegments(std::size_t i) {
    const std::size_t last = line_.segments() - 1;
    while (i > 0 && i < last) {
      const std::size_t from = i, index = i - 1;
      for (std::size_t level = level_;; --level) {
        const std::size_t size = std::size_t{1} << (2 * level), block = index >> (2 * level);
        if ((index & (size - 1)) == 0 && block < line_.blockCount(level)) {
          const double back = recovered_ + element_.recoveryOverBlock(level);
          const double lowest =
              level == 0 ? line_.bounds(i).lowest : line_.blocks[level].lowest[block];
          if (leftHeight_ + back <= lowest) {
            element_.relaxOverBlock(level);
            recovered_ = back;
            level_ = std::min(level + 1, line_.blocks.size() - 1);
            i += size;
            break;
          }
        }
        if (level == 0) break;
      }
      if (i == from) break;
    }
    level_ = 0;
    return inspectSegment<Everything>(i, nullptr);
  }

  /// Returns the height of the line above the free surface at t, and its slope with t. The
  /// amplitudes are those at `from`.
  HWY_INLINE ValueAndSlope clearanceAt(const Inside& inside, double from, double t) const {
    const ValueAndSlope back = element_.recovery(std::abs((t - from) * inside.along));
    return {inside.height(t) - (leftHeight_ + (recovered_ + back.value)),
            inside.height.derivative(t) - inside.along * back.slope};
  }

  /// Returns the first place in (from, to] where the line reaches the free surface, or kNoZero.
  double findEntry(const Inside& inside, double from, double to) const {
    // The free surface rises, over the rest of a segment not farther than over a whole one.
    const double highest = leftHeight_ + (recovered_ + element_.recoveryOverBlock(0));
    const auto clearance = [&](double t) { return clearanceAt(inside, from, t); };
    // From one stationary point to the next the line only rises or only falls, so it is lowest at
    // an end.
    double a = from, heightA = inside.height(from);
    ValueAndSlope atA{heightA - (leftHeight_ + recovered_),
                      inside.height.derivative(from) - inside.along * element_.speedBack()};
    bool isKnownAtA = true;
    for (const double b : turningPoints(to, inside.height, inside.along > 0)) {
      if ((b - a) * inside.along <= 0) continue;
      const double heightB = inside.height(b);
      if (std::min(heightA, heightB) >= highest) {
        isKnownAtA = false;
      } else {
        if (!isKnownAtA) atA = clearance(a);
        const ValueAndSlope atB = clearance(b);
        const double found = firstEnd(a, atA, b, atB, clearance);
        if (found != kNoZero) return found;
        atA = atB;
        isKnownAtA = true;
      }
      a = b;
      heightA = heightB;
    }
    return kNoZero;
  }

  /// Goes over segment i, through every event inside; returns the next one. atEnd: the pressure at
  /// its end as long as contact lasts, if known.
  template <bool Everything>
  std::size_t inspectSegment(std::size_t i, const ValueAndSlope* atEnd) {
    const Inside inside = makeInside(i);
    const bool onwards = inside.along > 0;
    double t = onwards ? 0 : 1;
    const double end = onwards ? 1 : 0;
    for (int events = 0; events < kMaxEvents; ++events) {
      if (touching_) {
        t = followContact<Everything>(inside, t, end, events == 0 ? atEnd : nullptr);
        if (touching_) return i + 1;
      }
      const double entry = findEntry(inside, t, end);
      if (entry > 1) {
        relaxTo(inside, t, end);
        return i + 1;
      }
      enter<Everything>(inside.at(entry), inside.height(entry));
      t = entry;
    }
    // The same event over and over again is rounding: contact goes on.
    if (touching_) {
      element_.advance(makePiece(inside, t, end), 1);
    } else {
      relaxTo(inside, t, end);
    }
    return i + 1;
  }

  /// Lets the free surface creep back to the end of a segment.
  HWY_INLINE void relaxTo(const Inside& inside, double from, double end) {
    if (from == 0 && inside.along == line_.spacing) {
      recovered_ += element_.recoveryOverBlock(0);
      element_.relaxOverBlock(0);
    } else {
      recovered_ += element_.relax(std::abs((end - from) * inside.along));
    }
  }

  const PreparedProfile& line_;
  const ArmVectors& vectors_;
  ArmWorkspace& work_;
  ArmElement element_;
  PassSums sums_;
  double depth_ = 0;
  bool touching_ = true;
  std::size_t level_ = 0;  // of the block tried next
  double arcStart_ = 0;    // m
  FreeIntervals free_;
  double contactStart_ = 0;  // m
  double entryHeight_ = 0;   // m, of the line where the present contact began
  double leftHeight_ = 0;    // m, of the line where the present arc began
  double recovered_ = 0;     // m, that the free surface has come back since
};

}  // namespace HWY_NAMESPACE
}  // namespace asperity
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
