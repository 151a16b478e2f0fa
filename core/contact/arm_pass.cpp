#include "core/contact/arm_pass.h"

#include <algorithm>
#include <cmath>

#include "core/contact/decay_moments.h"

namespace asperity {
namespace {

constexpr int kMostEvents = 64;  // in one segment, which has a few; more are rounding
constexpr double kNone = 2;      // beyond [0, 1]

/// Where the slope of a cubic or its curvature changes sign inside (0, 1), in order of travel.
Few<4> breakpoints(const Cubic& cubic, bool onwards) {
  Few<4> found;
  const double turn = cubic.c3 != 0 ? -cubic.c2 / (3 * cubic.c3) : kNone;
  bool turned = !(turn > 0 && turn < 1);
  for (const double t : stationaryPoints(cubic)) {
    if (!turned && turn < t) found.add(turn);
    turned |= turn < t;
    found.add(t);
  }
  if (!turned) found.add(turn);
  if (!onwards && found.count > 1)
    std::reverse(found.values.begin(), found.values.begin() + found.count);
  return found;
}

}  // namespace

/// A segment to look inside: its rise over t in [0, 1], s = start + t along. The last one is
/// measured back from its end, the lowest point: contact there may be far shorter than it.
struct ArmPass::Inside {
  Cubic rise;
  double start, along;
  double at(double t) const { return start + t * along; }
};

/// A part of it in contact: w over u in [0, 1], in the direction of travel.
struct ArmPass::Piece {
  Cubic depth;
  double length, start;
};

ArmPass::ArmPass(const TravelLine& line, const ArmMemory& memory)
    : line_(line),
      memory_(memory),
      strain_(memory.arms()),
      next_(memory.arms()),
      mode_(memory.modes()),
      arcMode_(memory.modes()),
      yieldChange_(memory.arms()) {}

void ArmPass::run(double depth, std::span<const double> yield, ArmTangent* tangent) {
  tangent_ = tangent;
  if (tangent) tangent->begin();
  go<false>(depth, yield, nullptr);
  if (tangent) tangent->finish(line_.length - (touching_ ? contactStart_ : arcStart_), touching_);
  tangent_ = nullptr;
}

void ArmPass::runForState(double depth, std::span<const double> yield, ArmShape* shape) {
  go<true>(depth, yield, shape);
}

template <bool Everything>
void ArmPass::go(double depth, std::span<const double> yield, ArmShape* shape) {
  depth_ = depth;
  sums_ = {};
  level_ = 0;
  touching_ = true;
  entryDepth_ = depth;
  contactStart_ = 0;
  std::fill(yieldChange_.begin(), yieldChange_.end(), 0);
  for (std::size_t i = 0; i < strain_.size(); ++i) strain_[i] = depth - yield[i];
  refreshSums();
  for (std::size_t i = 0; i < line_.segments();) {
    if (shape) record(i, *shape);
    i = touching_ ? contactSegment<Everything>(i) : freeSegments<Everything>(i, shape == nullptr);
  }
  const std::size_t arms = strain_.size(), slow = memory_.slow;
  if (touching_) {
    if (Everything) sums_.work += 0.5 * (depth_ - entryDepth_) * (depth_ + entryDepth_);
    for (std::size_t i = slow; i < arms; ++i) yieldChange_[i] = depth_ - strain_[i] - yield[i];
    return;
  }
  gatherArc(line_.length);
  if (Everything) enter<true>(line_.length, depth_);  // the lowest point takes over
  for (std::size_t i = slow; i < arms; ++i) {
    yieldChange_[i] = -yield[i];
    for (std::size_t j = 0; j < mode_.size(); ++j)
      yieldChange_[i] += memory_.conversion.toYield[j * arms + i] * mode_[j];
  }
}

void ArmPass::refreshSums() {
  strainSum_ = lossSum_ = 0;
  for (std::size_t i = 0; i < strain_.size(); ++i) {
    strainSum_ += memory_.modulus[i] * strain_[i];
    lossSum_ += memory_.lossRate[i] * strain_[i];
  }
}

/// Stored by the springs, per 2G.
double ArmPass::springEnergy(double depth) const {
  double energy = 0.5 * depth * depth;
  for (std::size_t i = 0; i < strain_.size(); ++i)
    energy += 0.5 * memory_.modulus[i] * strain_[i] * strain_[i];
  return energy;
}

// ---- in contact
// ----------------------------------------------------------------------------------

/// A whole segment in contact, without looking inside where pressure surely lasts.
template <bool Everything>
std::size_t ArmPass::contactSegment(std::size_t i) {
  const bool whole = i > 0 && i + 1 < line_.segments();
  if (!whole) {
    lookInside<Everything>(i);
    return i + 1;
  }
  const Cubic rise = line_.segment(i);
  const double h = line_.spacing, d0 = -rise.c1, d1 = -2 * rise.c2, d2 = -3 * rise.c3;
  const std::size_t arms = strain_.size();
  const double *kept = memory_.kept.data(), *g = memory_.modulus.data(),
               *loss = memory_.lossRate.data(), *m0 = memory_.driven[0].data(),
               *m1 = memory_.driven[1].data(), *m2 = memory_.driven[2].data();
  const double* now = strain_.data();
  double* next = next_.data();
  double strainSum = 0, lossSum = 0;
  for (std::size_t k = 0; k < arms; ++k) {
    const double e = kept[k] * now[k] + (d0 * m0[k] + d1 * m1[k] + d2 * m2[k]);
    next[k] = e;
    strainSum += g[k] * e;
    lossSum += loss[k] * e;
  }
  const double perLength = memory_.dashpot / h;
  const double before = depth_ - rise.c0 + strainSum_ + perLength * d0;
  const double slopeBefore = d0 * memory_.glassy - h * lossSum_ + perLength * d1;
  const double after = depth_ - line_.rise[i + 1] + strainSum + perLength * (d0 + d1 + d2);
  const double slopeAfter =
      (d0 + d1 + d2) * memory_.glassy - h * lossSum + perLength * (d1 + 2 * d2);
  // A dip between the ends lies above where the tangents meet.
  bool lasts = before > 0 && after > 0;
  if (lasts && slopeBefore < 0 && slopeAfter > 0) {
    const double meet = (after - before - slopeAfter) / (slopeBefore - slopeAfter);
    lasts = before + slopeBefore * meet > 0;
  }
  if (!lasts) {
    lookInside<Everything>(i);
    return i + 1;
  }
  const double volume = depth_ * h - line_.bounds(i).riseIntegral;
  sums_.depth += volume;
  for (std::size_t k = 0; k < memory_.slow; ++k)
    yieldChange_[k] += memory_.yieldKept[k] * now[k] + d0 * memory_.yieldDriven[0][k] +
                       d1 * memory_.yieldDriven[1][k] + d2 * memory_.yieldDriven[2][k];
  if constexpr (Everything) {
    std::array<double, 3> with{};
    for (std::size_t n = 0; n < 3; ++n)
      for (std::size_t k = 0; k < arms; ++k) with[n] += memory_.moment[n][k] * now[k];
    gatherContact({{depth_ - rise.c0, d0, 0.5 * d1, d2 / 3}, h, line_.position[i]}, with[0],
                  with[1], with[2], memory_.own);
    for (std::size_t k = 0; k < arms; ++k)
      sums_.dissipation += 0.5 * g[k] * (now[k] * now[k] - next[k] * next[k]);
  }
  strain_.swap(next_);
  strainSum_ = strainSum;
  lossSum_ = lossSum;
  return i + 1;
}

/// Sums over a piece in contact; withStrain: sum g_i e_i integral of exp(-z u) u^k. The elastic
/// part of the work is added where contact ends.
void ArmPass::gatherContact(const Piece& piece, double withStrain0, double withStrain1,
                            double withStrain2, const std::array<std::array<double, 3>, 3>& own) {
  const double length = piece.length;
  const std::array<double, 3> slope{piece.depth.c1, 2 * piece.depth.c2, 3 * piece.depth.c3};
  const double slopeSquared = piece.depth.integralOfSlopeSquared(1) / length;
  double strain = withStrain0,
         work = slope[0] * withStrain0 + slope[1] * withStrain1 + slope[2] * withStrain2;
  for (std::size_t k = 0; k < 3; ++k) {
    strain += own[0][k] * slope[k];
    for (std::size_t l = 0; l < 3; ++l) work += slope[k] * own[k][l] * slope[l];
  }
  work += memory_.dashpot * slopeSquared;
  sums_.pressure += length * (piece.depth.integral(1) + strain) +
                    memory_.dashpot * (slope[0] + piece.depth.c2 + piece.depth.c3);
  sums_.work += work;
  sums_.dissipation += work;
  sums_.contactLength += length;
  sums_.slopeSquared += slopeSquared;
  double last = piece.depth.c0;
  for (const double u : stationaryPoints(piece.depth)) {
    sums_.absoluteSlope += std::abs(piece.depth(u) - last);
    last = piece.depth(u);
  }
  sums_.absoluteSlope += std::abs(piece.depth(1) - last);
}

ArmPass::Piece ArmPass::pieceOf(const Inside& inside, double from, double to) const {
  const Cubic rise = inside.rise.about(from);
  const double step = to - from;
  return {
      {depth_ - rise.c0, -rise.c1 * step, -rise.c2 * step * step, -rise.c3 * step * step * step},
      std::abs(step * inside.along),
      inside.at(from)};
}

/// p / 4G at u of a piece that begins with the present strains, and its derivative there.
double ArmPass::pressureAt(const Piece& piece, double u, double& slope) const {
  const Cubic& w = piece.depth;
  const double d0 = w.c1, d1 = 2 * w.c2, d2 = 3 * w.c3, way = piece.length * u;
  double strain = 0, loss = 0;
  for (std::size_t i = 0; i < strain_.size(); ++i) {
    const DrivenDecay decay = drivenDecay(way * memory_.inverse[i]);
    const double e =
        decay.kept * strain_[i] +
        u * (d0 * decay.driven[0] + u * (d1 * decay.driven[1] + u * d2 * decay.driven[2]));
    strain += memory_.modulus[i] * e;
    loss += memory_.lossRate[i] * e;
  }
  const double perLength = memory_.dashpot / piece.length, rising = d0 + u * (d1 + u * d2);
  slope = rising * memory_.glassy - piece.length * loss + perLength * (d1 + 2 * u * d2);
  return w(u) + strain + perLength * rising;
}

/// Where pressure ends on the piece, or kNone.
double ArmPass::liftOff(const Piece& piece) const {
  double slopeBefore = 0, slopeAfter = 0;
  const double before = pressureAt(piece, 0, slopeBefore);
  // Right where contact begins p may be 0 to rounding, but it grows.
  if (before <= 0 && slopeBefore <= 0) return 0;
  const double after = pressureAt(piece, 1, slopeAfter);
  const auto pressure = [&](double u, double& slope) { return pressureAt(piece, u, slope); };
  if (after <= 0) return zeroBetween(0, 1, 1, pressure);
  if (!(slopeBefore < 0 && slopeAfter > 0)) return kNone;
  double low = 0, high = 1, slope = 0;  // the lowest pressure is between
  for (int i = 0; i < 60 && high - low > 1e-9; ++i) {
    const double middle = 0.5 * (low + high);
    if (pressureAt(piece, middle, slope) <= 0) return zeroBetween(0, middle, 1, pressure);
    (slope < 0 ? low : high) = middle;
  }
  return kNone;
}

/// What slow arms yield over [0, u], before the strains advance.
void ArmPass::addYield(const Piece& piece, double u) {
  const Cubic& w = piece.depth;
  for (std::size_t i = 0; i < memory_.slow; ++i) {
    const double z = piece.length * u * memory_.inverse[i];
    const auto drivenBy = drivenMoments(z);
    yieldChange_[i] += z * (strain_[i] * decayMoments(z)[0] +
                            u * (w.c1 * drivenBy[0][0] +
                                 u * (2 * w.c2 * drivenBy[0][1] + u * 3 * w.c3 * drivenBy[0][2])));
  }
}

/// Strains at u of the piece.
void ArmPass::advance(const Piece& piece, double u) {
  addYield(piece, u);
  const Cubic& w = piece.depth;
  for (std::size_t i = 0; i < strain_.size(); ++i) {
    const DrivenDecay decay = drivenDecay(piece.length * u * memory_.inverse[i]);
    strain_[i] = decay.kept * strain_[i] +
                 u * (w.c1 * decay.driven[0] +
                      u * (2 * w.c2 * decay.driven[1] + u * 3 * w.c3 * decay.driven[2]));
  }
  refreshSums();
}

/// All sums over [0, u] of a piece of any length, before the strains advance.
void ArmPass::gatherPiece(const Piece& piece, double u) {
  const Cubic& w = piece.depth;
  const Piece part{{w.c0, w.c1 * u, w.c2 * u * u, w.c3 * u * u * u}, piece.length * u, piece.start};
  std::array<double, 3> with{};
  std::array<std::array<double, 3>, 3> own{};
  for (std::size_t i = 0; i < strain_.size(); ++i) {
    const double g = memory_.modulus[i], z = part.length * memory_.inverse[i];
    const auto moments = decayMoments(z);
    const auto drivenBy = drivenMoments(z);
    for (std::size_t k = 0; k < 3; ++k) {
      with[k] += g * strain_[i] * moments[k];
      for (std::size_t l = 0; l < 3; ++l) own[k][l] += g * drivenBy[k][l];
    }
  }
  gatherContact(part, with[0], with[1], with[2], own);
}

/// Contact from `from` on; returns where it ends, or `to`.
template <bool Everything>
double ArmPass::pressed(const Inside& inside, double from, double to) {
  const Piece piece = pieceOf(inside, from, to);
  if (!(piece.length > 0)) return to;
  const double found = liftOff(piece), u = std::min(found, 1.0);
  const double volume = piece.length * piece.depth.integral(u);
  sums_.depth += volume;
  if (u > 0) {
    const double before = Everything ? springEnergy(0) : 0;
    if constexpr (Everything) gatherPiece(piece, u);
    advance(piece, u);
    if constexpr (Everything) sums_.dissipation += before - springEnergy(0);
  }
  if (found > 1) return to;
  const double at = from + u * (to - from);
  leave<Everything>(inside.at(at), piece.depth(u));
  return at;
}

template <bool Everything>
void ArmPass::leave(double position, double depth) {
  if (tangent_) tangent_->leave(position - contactStart_);
  touching_ = false;
  level_ = 0;
  arcStart_ = position;
  if constexpr (Everything) {
    sums_.work += 0.5 * (depth - entryDepth_) * (depth + entryDepth_);
    sums_.dissipation += springEnergy(depth);
  }
  const std::size_t arms = strain_.size();
  for (std::size_t j = 0; j < mode_.size(); ++j) {
    const double* row = memory_.conversion.ofYield.data() + j * arms;
    double amplitude = memory_.conversion.ofDepth[j] * depth;
    for (std::size_t i = 0; i < arms; ++i) amplitude += row[i] * (depth - strain_[i]);
    mode_[j] = arcMode_[j] = amplitude;
  }
}

// ---- free
// ----------------------------------------------------------------------------------------

/// Closes the arc's sums at a place, with the amplitudes there.
void ArmPass::gatherArc(double position) {
  const double length = position - arcStart_;
  const std::size_t arms = strain_.size();
  double volume = 0;
  for (std::size_t j = 0; j < mode_.size(); ++j) {
    const double z = memory_.rate[j] * length, back = std::expm1(-z);
    volume += arcMode_[j] * (z > 0 ? -back / z : 1);
    mode_[j] = arcMode_[j] * (1 + back);
    for (std::size_t i = 0; i < memory_.slow; ++i)
      yieldChange_[i] += memory_.conversion.toYield[j * arms + i] * arcMode_[j] * back;
  }
  sums_.depth += volume * length;
}

template <bool Everything>
void ArmPass::enter(double position, double depth) {
  if (tangent_) tangent_->enter(position - arcStart_);
  touching_ = true;
  contactStart_ = position;
  entryDepth_ = depth;
  std::fill(strain_.begin(), strain_.end(), 0);
  const std::size_t arms = strain_.size();
  for (std::size_t j = 0; j < mode_.size(); ++j) {
    const double* row = memory_.conversion.toStrain.data() + j * arms;
    for (std::size_t i = 0; i < arms; ++i) strain_[i] += row[i] * mode_[j];
  }
  refreshSums();
  if constexpr (Everything) sums_.dissipation -= springEnergy(depth);
}

double ArmPass::freeDepth(double distance) const {
  double depth = 0;
  for (std::size_t j = 0; j < mode_.size(); ++j)
    depth += mode_[j] * std::exp(-memory_.rate[j] * distance);
  return depth;
}

/// Depth of the line below the free surface at t, mode_ being that at `from`; slope with t.
double ArmPass::gapAt(const Inside& inside, double from, double t, double& slope) const {
  const double distance = (t - from) * inside.along;
  double depth = 0, falling = 0;
  for (std::size_t j = 0; j < mode_.size(); ++j) {
    const double part = mode_[j] * std::exp(-memory_.rate[j] * distance);
    depth += part;
    falling += memory_.rate[j] * part;
  }
  slope = -inside.rise.derivative(t) + inside.along * falling;
  return depth_ - inside.rise(t) - depth;
}

/// First place in (from, to] where the line reaches the free surface, or kNone.
double ArmPass::findEntry(const Inside& inside, double from, double to, double lowest) const {
  if (depth_ - lowest <= freeDepth(std::abs((to - from) * inside.along))) return kNone;
  Few<4> stops = breakpoints(inside.rise, to > from);
  stops.add(to);
  double a = from, slopeA = 0;
  gapAt(inside, from, a, slopeA);
  const double onward = to > from ? 1 : -1;
  const auto gap = [&](double t, double& slope) { return gapAt(inside, from, t, slope); };
  const auto zeroFrom = [&](double low, double high) {
    double ignored = 0;
    return onward > 0 ? zeroBetween(low, high, -1, gap)
                      : zeroBetween(high, low, gapAt(inside, from, high, ignored), gap);
  };
  for (const double b : stops) {
    if ((b - a) * onward <= 0) continue;
    double slopeB = 0;
    if (gapAt(inside, from, b, slopeB) > 0) return zeroFrom(a, b);
    if (slopeA * onward > 0 && slopeB * onward < 0) {
      double low = a, high = b, slope = 0;
      for (int i = 0; i < 60 && std::abs(high - low) > 1e-9; ++i) {
        const double middle = 0.5 * (low + high);
        if (gapAt(inside, from, middle, slope) > 0) return zeroFrom(a, middle);
        (slope * onward > 0 ? low : high) = middle;
      }
    }
    a = b;
    slopeA = slopeB;
  }
  return kNone;
}

/// As many segments as the line stays above the free surface for sure; else a look inside of one.
template <bool Everything>
std::size_t ArmPass::freeSegments(std::size_t i, bool mayJump) {
  const bool whole = i > 0 && i + 1 < line_.segments();
  if (!whole) {
    lookInside<Everything>(i);
    return i + 1;
  }
  const std::size_t place = i - 1;
  for (std::size_t level = mayJump ? level_ : 0;; --level) {
    const std::size_t size = std::size_t{1} << (2 * level), block = place >> (2 * level);
    const bool fits = (place & (size - 1)) == 0 && block < line_.blocks[level].size();
    if (fits) {
      const double* decay = memory_.decay[level].data();
      double far = 0;
      for (std::size_t j = 0; j < mode_.size(); ++j) far += mode_[j] * decay[j];
      if (depth_ - line_.blocks[level][block].lowest <= far) {
        for (std::size_t j = 0; j < mode_.size(); ++j) mode_[j] *= decay[j];
        level_ = std::min(level + 1, line_.blocks.size() - 1);
        return i + size;
      }
    }
    if (level == 0) break;
  }
  level_ = 0;
  lookInside<Everything>(i);
  return i + 1;
}

// ---- inside a segment
// ----------------------------------------------------------------------------

ArmPass::Inside ArmPass::insideOf(std::size_t i) const {
  if (i + 1 < line_.segments())
    return {line_.segment(i), line_.position[i], line_.segmentLength(i)};
  return {line_.segmentBackwards(i), line_.length, -line_.segmentLength(i)};
}

template <bool Everything>
void ArmPass::lookInside(std::size_t i) {
  const Inside inside = insideOf(i);
  const bool onwards = inside.along > 0;
  double t = onwards ? 0 : 1;
  const double end = onwards ? 1 : 0;
  for (int events = 0; events < kMostEvents; ++events) {
    if (touching_) {
      t = pressed<Everything>(inside, t, end);
      if (touching_) return;
    }
    const double entry = findEntry(inside, t, end, line_.bounds(i).lowest);
    if (entry == kNone) break;
    gatherArc(inside.at(entry));
    enter<Everything>(inside.at(entry), depth_ - inside.rise(entry));
    t = entry;
  }
  if (touching_) {
    // The same event over and over again is rounding: contact goes on.
    advance(pieceOf(inside, t, end), 1);
    return;
  }
  const double rest = std::abs((end - t) * inside.along);
  for (std::size_t j = 0; j < mode_.size(); ++j) mode_[j] *= std::exp(-memory_.rate[j] * rest);
}

void ArmPass::record(std::size_t i, ArmShape& shape) {
  double depth = 0, pressure = 0;
  const std::size_t arms = strain_.size(), modes = mode_.size();
  if (touching_) {
    depth = depth_ - line_.rise[i];
    pressure = depth + strainSum_ - memory_.dashpot * line_.slopeIn[i];
    for (std::size_t j = 0; j < modes; ++j) {
      const double* row = memory_.conversion.ofYield.data() + j * arms;
      double amplitude = memory_.conversion.ofDepth[j] * depth;
      for (std::size_t k = 0; k < arms; ++k) amplitude += row[k] * (depth - strain_[k]);
      shape.modes.push_back(amplitude);
    }
  } else {
    for (std::size_t j = 0; j < modes; ++j) {
      depth += mode_[j];
      shape.modes.push_back(mode_[j]);
    }
  }
  shape.nodes.depth.push_back(depth);
  shape.nodes.pressure.push_back(std::max(pressure, 0.0));
}

}  // namespace asperity
