#include "core/contact/arms/arm_pass.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/contact/kernels/decay_moments.h"

namespace asperity {

namespace {

constexpr int kMaxEvents = 64;  // in one segment, which has a few; more are rounding

}  // namespace

ArmPass::ArmPass(const PreparedProfile& line, const ArmCoefficients& coefficients)
    : line_(line),
      coefficients_(coefficients),
      strain_(coefficients.arms()),
      next_(coefficients.arms()),
      mode_(coefficients.modes()),
      arcMode_(coefficients.modes()),
      creepChange_(coefficients.arms()) {}

void ArmPass::run(double depth, std::span<const double> strain, ArmTangent* tangent) {
  tangent_ = tangent;
  if (tangent) tangent->begin();
  runPass<false>(depth, strain, nullptr);
  const double begun = touching_ ? contactStart_ : arcStart_;
  if (tangent) tangent->finish(std::max(line_.length - begun, 0.0), touching_);
  tangent_ = nullptr;
}

void ArmPass::runForState(double depth, std::span<const double> strain, ArmShape* shape) {
  runPass<true>(depth, strain, shape);
}

template <bool Everything>
void ArmPass::runPass(double depth, std::span<const double> strain, ArmShape* shape) {
  depth_ = depth;
  sums_ = {};
  free_.begin(line_.spacing);
  level_ = 0;
  touching_ = true;
  hasLeft_ = false;
  entryHeight_ = 0;
  contactStart_ = 0;
  std::fill(creepChange_.begin(), creepChange_.end(), 0);
  std::copy(strain.begin(), strain.end(), strain_.begin());
  refreshSums();
  for (std::size_t i = 0; i < line_.segments();) {
    if (shape) record(i, *shape);
    i = touching_ ? contactSegment<Everything>(i) : freeSegments<Everything>(i, shape == nullptr);
  }
  if (touching_) {
    if (Everything) sums_.work += elasticWork(0);
  } else {
    gatherArc<Everything>(line_.length);
    setStrainsFree();  // the lowest point takes over
  }
  for (std::size_t i = coefficients_.slow; i < strain_.size(); ++i)
    creepChange_[i] = strain[i] - strain_[i];
}

void ArmPass::completeStrains(std::span<double> strain) {
  std::fill(strain_.begin(), strain_.end(), 0);
  depth_ = 0;
  const std::size_t last = line_.segments() - 1;
  advance(makePiece(makeInside(0), 0, 1), 1);
  for (std::size_t i = 1; i < last; ++i) {
    const Cubic height = line_.segment(i);
    for (std::size_t k = 0; k < strain_.size(); ++k)
      strain_[k] = coefficients_.kept[k] * strain_[k] - height.c1 * coefficients_.driven[0][k] -
                   2 * height.c2 * coefficients_.driven[1][k] -
                   3 * height.c3 * coefficients_.driven[2][k];
  }
  advance(makePiece(makeInside(last), 1, 0), 1);
  for (std::size_t k = 0; k < strain_.size(); ++k)
    strain[k] = strain_[k] / -std::expm1(-line_.length * coefficients_.inverse[k]);
}

void ArmPass::refreshSums() {
  strainSum_ = lossSum_ = 0;
  for (std::size_t i = 0; i < strain_.size(); ++i) {
    strainSum_ += coefficients_.modulus[i] * strain_[i];
    lossSum_ += coefficients_.lossRate[i] * strain_[i];
  }
}

/// Returns the work on the elements' own springs since contact began, up to this height.
double ArmPass::elasticWork(double height) const {
  return (entryHeight_ - height) * (depth_ - 0.5 * (entryHeight_ + height));
}

/// Computes the strains from the amplitudes.
void ArmPass::setStrainsFree() {
  std::fill(strain_.begin(), strain_.end(), 0);
  const std::size_t arms = strain_.size();
  for (std::size_t j = 0; j < mode_.size(); ++j) {
    const double* row = coefficients_.conversion.toStrain.data() + j * arms;
    for (std::size_t i = 0; i < arms; ++i) strain_[i] += row[i] * mode_[j];
  }
}

/// Computes the amplitudes from a depth and the strains.
void ArmPass::setModes(double* modes, double depth) const {
  const std::size_t arms = strain_.size();
  for (std::size_t j = 0; j < mode_.size(); ++j) {
    const double* row = coefficients_.conversion.ofCreep.data() + j * arms;
    double amplitude = coefficients_.settled[j] * depth;
    for (std::size_t i = 0; i < arms; ++i) amplitude -= row[i] * strain_[i];
    modes[j] = amplitude;
  }
}

// ---- In contact

/// Takes a whole segment in contact without examining its inside where the pressure is certainly
/// positive.
template <bool Everything>
std::size_t ArmPass::contactSegment(std::size_t i) {
  const bool whole = i > 0 && i + 1 < line_.segments();
  if (!whole) {
    inspectSegment<Everything>(i);
    return i + 1;
  }
  const Cubic height = line_.segment(i);
  const double h = line_.spacing, d0 = -height.c1, d1 = -2 * height.c2, d2 = -3 * height.c3;
  // Strains at the end of the segment.
  const std::size_t arms = strain_.size();
  const double *kept = coefficients_.kept.data(), *g = coefficients_.modulus.data(),
               *loss = coefficients_.lossRate.data(), *m0 = coefficients_.driven[0].data(),
               *m1 = coefficients_.driven[1].data(), *m2 = coefficients_.driven[2].data();
  const double* now = strain_.data();
  double* next = next_.data();
  double strainSum = 0, lossSum = 0;
  for (std::size_t k = 0; k < arms; ++k) {
    const double e = kept[k] * now[k] + (d0 * m0[k] + d1 * m1[k] + d2 * m2[k]);
    next[k] = e;
    strainSum += g[k] * e;
    lossSum += loss[k] * e;
  }
  // Pressure and its slope at both ends of the segment.
  const double perLength = coefficients_.dashpot / h;
  const double before = depth_ - height.c0 + strainSum_ + perLength * d0;
  const double slopeBefore = d0 * coefficients_.glassy - h * lossSum_ + perLength * d1;
  const double after =
      depth_ - line_.heightAboveMinimum[i + 1] + strainSum + perLength * (d0 + d1 + d2);
  const double slopeAfter =
      (d0 + d1 + d2) * coefficients_.glassy - h * lossSum + perLength * (d1 + 2 * d2);
  // As in firstZero().
  const bool lasts =
      before > 0 && after > 0 && before + slopeBefore / 3 > 0 && after - slopeAfter / 3 > 0;
  if (!lasts) {
    inspectSegment<Everything>(i);
    return i + 1;
  }
  // Contact lasts: sums over the segment.
  const double volume = depth_ * h - line_.bounds(i).heightIntegral;
  sums_.depth += volume;
  for (std::size_t k = 0; k < coefficients_.slow; ++k)
    creepChange_[k] += coefficients_.creepKept[k] * now[k] + d0 * coefficients_.creepDriven[0][k] +
                       d1 * coefficients_.creepDriven[1][k] + d2 * coefficients_.creepDriven[2][k];
  if constexpr (Everything) {
    std::array<double, 3> with{};
    for (std::size_t n = 0; n < 3; ++n)
      for (std::size_t k = 0; k < arms; ++k) with[n] += coefficients_.moment[n][k] * now[k];
    gatherContact({{depth_ - height.c0, d0, 0.5 * d1, d2 / 3}, h, line_.position(i)}, with[0],
                  with[1], with[2], coefficients_.own);
    for (std::size_t k = 0; k < arms; ++k)
      sums_.dissipation += g[k] * coefficients_.loss[k](now[k], d0, d1, d2);
  }
  strain_.swap(next_);
  strainSum_ = strainSum;
  lossSum_ = lossSum;
  return i + 1;
}

/// Follows contact from `from` on; returns the position where it ends, or `to`.
template <bool Everything>
double ArmPass::followContact(const Inside& inside, double from, double to) {
  const Piece piece = makePiece(inside, from, to);
  if (!(piece.length > 0)) return to;
  const double found = findSeparation(piece), u = std::min(found, 1.0);
  const double volume = piece.length * piece.depth.integral(u);
  sums_.depth += volume;
  if (u > 0) {
    if constexpr (Everything) gatherPiece(piece, u);
    advance(piece, u);
  }
  if (found > 1) return to;
  const double at = from + u * (to - from);
  leave<Everything>(inside.at(at), inside.height(at));
  return at;
}

template <bool Everything>
void ArmPass::leave(double position, double height) {
  // By rounding the end may lie before the start, where the strain of a fast arm would overflow.
  position = std::max(position, contactStart_);
  if (tangent_) tangent_->leave(position - contactStart_);
  touching_ = false;
  hasLeft_ = true;
  level_ = 0;
  arcStart_ = position;
  leftHeight_ = height;
  recovered_ = 0;
  if constexpr (Everything) sums_.work += elasticWork(height);
  setModes(mode_.data(), depth_ - height);
  arcMode_ = mode_;
}

// ---- Free

/// Closes the sums of the arc at a position, with the amplitudes there. In a free arc each
/// amplitude relaxes by itself and dissipates the energy of its own spring.
template <bool Everything>
void ArmPass::gatherArc(double position) {
  const double length = std::max(position - arcStart_, 0.0);
  const std::size_t arms = strain_.size();
  double volume = 0;
  for (std::size_t j = 0; j < mode_.size(); ++j) {
    const double z = coefficients_.rate[j] * length, back = std::expm1(-z);
    volume += arcMode_[j] * (z > 0 ? -back / z : 1);
    mode_[j] = arcMode_[j] * (1 + back);
    if constexpr (Everything)
      sums_.dissipation -=
          0.5 * coefficients_.stiffness[j] * arcMode_[j] * arcMode_[j] * back * (2 + back);
    for (std::size_t i = 0; i < coefficients_.slow; ++i)
      creepChange_[i] += coefficients_.conversion.toCreep[j * arms + i] * arcMode_[j] * back;
  }
  sums_.depth += volume * length;
  free_.add(arcStart_ - contactStart_, length);
  sums_.gaps = free_.count();
}

void ArmPass::enter(double position, double height) {
  position = std::max(position, arcStart_);
  if (tangent_) tangent_->enter(position - arcStart_);
  touching_ = true;
  contactStart_ = position;
  entryHeight_ = height;
  setStrainsFree();
  refreshSums();
}

/// Takes as many segments as the line is certainly above the free surface; else examines the inside
/// of one.
template <bool Everything>
std::size_t ArmPass::freeSegments(std::size_t i, bool mayJump) {
  const bool whole = i > 0 && i + 1 < line_.segments();
  if (!whole) {
    inspectSegment<Everything>(i);
    return i + 1;
  }
  const std::size_t index = i - 1;
  for (std::size_t level = mayJump ? level_ : 0;; --level) {
    const std::size_t size = std::size_t{1} << (2 * level), block = index >> (2 * level);
    const bool fits = (index & (size - 1)) == 0 && block < line_.blockCount(level);
    if (fits) {
      const double *decay = coefficients_.decay[level].data(),
                   *lost = coefficients_.lost[level].data();
      double back = recovered_;
      for (std::size_t j = 0; j < mode_.size(); ++j) back += mode_[j] * lost[j];
      if (leftHeight_ + back <= line_.block(level, block).lowest) {
        for (std::size_t j = 0; j < mode_.size(); ++j) mode_[j] *= decay[j];
        recovered_ = back;
        level_ = std::min(level + 1, line_.blocks.size() - 1);
        return i + size;
      }
    }
    if (level == 0) break;
  }
  level_ = 0;
  inspectSegment<Everything>(i);
  return i + 1;
}

// ---- Inside a segment

template <bool Everything>
void ArmPass::inspectSegment(std::size_t i) {
  const Inside inside = makeInside(i);
  const bool onwards = inside.along > 0;
  double t = onwards ? 0 : 1;
  const double end = onwards ? 1 : 0;
  for (int events = 0; events < kMaxEvents; ++events) {
    if (touching_) {
      t = followContact<Everything>(inside, t, end);
      if (touching_) return;
    }
    const double entry = findEntry(inside, t, end, line_.bounds(i).lowest);
    if (entry > 1) break;
    gatherArc<Everything>(inside.at(entry));
    enter(inside.at(entry), inside.height(entry));
    t = entry;
  }
  if (touching_) {
    // An event that repeats over and over is rounding: contact continues.
    advance(makePiece(inside, t, end), 1);
    return;
  }
  const double rest = std::abs((end - t) * inside.along);
  recovered_ += recovery(rest);
  for (std::size_t j = 0; j < mode_.size(); ++j)
    mode_[j] *= std::exp(-coefficients_.rate[j] * rest);
}

void ArmPass::record(std::size_t i, ArmShape& shape) {
  double depth = depth_ - line_.heightAboveMinimum[i], pressure = 0;
  const std::size_t known = shape.modes.size();
  if (touching_) {
    pressure = depth + strainSum_ - coefficients_.dashpot * line_.slopeIn[i];
    shape.modes.resize(known + mode_.size());
    setModes(shape.modes.data() + known, depth);
  } else {
    shape.modes.insert(shape.modes.end(), mode_.begin(), mode_.end());
    depth = std::max(depth, std::accumulate(mode_.begin(), mode_.end(), 0.0));
  }
  shape.nodes.depth.push_back(depth);
  shape.nodes.pressure.push_back(std::max(pressure, 0.0));
}

// ---- Where contact begins and ends inside a segment, and the sums over pieces

namespace {

/// Returns the first position from `from` towards `to` where pressure or clearance becomes 0, or
/// kNoZero.
template <class Function>
double firstEnd(double from, ValueAndSlope first, double to, ValueAndSlope last,
                const Function& function) {
  // At the beginning of a contact the function is 0 to rounding.
  first.value = std::max(first.value, 0.0);
  const auto value = [&function](double t, double& slope) {
    const ValueAndSlope at = function(t);
    slope = at.slope;
    return at.value;
  };
  return firstZero(from, first, to, last, function,
                   [&value](double a, ValueAndSlope, double b, ValueAndSlope atB) {
                     return a < b ? zeroBetween(a, b, 1, value)
                                  : zeroBetween(b, a, atB.value, value);
                   });
}

}  // namespace

StaticVector<3> turningPoints(double to, const Cubic& cubic, bool onwards) {
  const StaticVector<2> turns = stationaryPoints(cubic);
  StaticVector<3> found;
  for (int i = 0; i < turns.count; ++i)
    found.add(turns.values[static_cast<std::size_t>(onwards ? i : turns.count - 1 - i)]);
  found.add(to);
  return found;
}

ArmPass::Inside ArmPass::makeInside(std::size_t i) const {
  if (i + 1 < line_.segments())
    return {line_.segment(i), line_.position(i), line_.segmentLength(i)};
  return {line_.segmentBackwards(i), line_.length, -line_.segmentLength(i)};
}

ArmPass::Piece ArmPass::makePiece(const Inside& inside, double from, double to) const {
  const Cubic height = inside.height.about(from);
  const double step = to - from;
  return {{depth_ - height.c0, -height.c1 * step, -height.c2 * step * step,
           -height.c3 * step * step * step},
          std::abs(step * inside.along),
          inside.at(from)};
}

/// Returns p / 4G at u of a piece that begins with the present strains.
ValueAndSlope ArmPass::pressureAt(const Piece& piece, double u) const {
  const Cubic& w = piece.depth;
  const double d0 = w.c1, d1 = 2 * w.c2, d2 = 3 * w.c3, distance = piece.length * u;
  double strain = 0, loss = 0;
  for (std::size_t i = 0; i < strain_.size(); ++i) {
    const DrivenDecay decay = drivenDecay(distance * coefficients_.inverse[i]);
    const double e =
        decay.kept * strain_[i] +
        u * (d0 * decay.driven[0] + u * (d1 * decay.driven[1] + u * d2 * decay.driven[2]));
    strain += coefficients_.modulus[i] * e;
    loss += coefficients_.lossRate[i] * e;
  }
  const double perLength = coefficients_.dashpot / piece.length, rising = d0 + u * (d1 + u * d2);
  return {w(u) + strain + perLength * rising,
          rising * coefficients_.glassy - piece.length * loss + perLength * (d1 + 2 * u * d2)};
}

/// Returns the position on the piece where pressure ends, or kNoZero.
double ArmPass::findSeparation(const Piece& piece) const {
  const ValueAndSlope before = pressureAt(piece, 0);
  if (before.value <= 0 && before.slope <= 0) return 0;
  return firstEnd(0, before, 1, pressureAt(piece, 1),
                  [&](double u) { return pressureAt(piece, u); });
}

/// Adds the creep of slow arms over [0, u], before the strains advance.
void ArmPass::addCreep(const Piece& piece, double u) {
  const Cubic& w = piece.depth;
  for (std::size_t i = 0; i < coefficients_.slow; ++i) {
    const double z = piece.length * u * coefficients_.inverse[i];
    const auto drivenBy = drivenMoments(z);
    creepChange_[i] += z * (strain_[i] * decayMoments(z)[0] +
                            u * (w.c1 * drivenBy[0][0] +
                                 u * (2 * w.c2 * drivenBy[0][1] + u * 3 * w.c3 * drivenBy[0][2])));
  }
}

/// Advances the strains to u of the piece.
void ArmPass::advance(const Piece& piece, double u) {
  addCreep(piece, u);
  const Cubic& w = piece.depth;
  for (std::size_t i = 0; i < strain_.size(); ++i) {
    const DrivenDecay decay = drivenDecay(piece.length * u * coefficients_.inverse[i]);
    strain_[i] = decay.kept * strain_[i] +
                 u * (w.c1 * decay.driven[0] +
                      u * (2 * w.c2 * decay.driven[1] + u * 3 * w.c3 * decay.driven[2]));
  }
  refreshSums();
}

/// Adds all sums over [0, u] of a piece of any length, before the strains advance.
void ArmPass::gatherPiece(const Piece& piece, double u) {
  const Cubic& w = piece.depth;
  const Piece part{{w.c0, w.c1 * u, w.c2 * u * u, w.c3 * u * u * u}, piece.length * u, piece.start};
  std::array<double, 3> with{};
  std::array<std::array<double, 3>, 3> own{};
  for (std::size_t i = 0; i < strain_.size(); ++i) {
    const double g = coefficients_.modulus[i], z = part.length * coefficients_.inverse[i];
    const auto moments = decayMoments(z);
    const auto drivenBy = drivenMoments(z);
    for (std::size_t k = 0; k < 3; ++k) {
      with[k] += g * strain_[i] * moments[k];
      for (std::size_t l = 0; l < 3; ++l) own[k][l] += g * drivenBy[k][l];
    }
    sums_.dissipation +=
        g * lossForm(z)(strain_[i], part.depth.c1, 2 * part.depth.c2, 3 * part.depth.c3);
  }
  gatherContact(part, with[0], with[1], with[2], own);
}

/// Adds the sums over a piece in contact; withStrain: sum g_i e_i integral of exp(-z u) u^k. The
/// elastic part of the work is added where contact ends.
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
  const double damped = coefficients_.dashpot * slopeSquared;
  sums_.pressure += length * (piece.depth.integral(1) + strain) +
                    coefficients_.dashpot * (slope[0] + piece.depth.c2 + piece.depth.c3);
  sums_.work += work + damped;
  sums_.dissipation += damped;
  sums_.contactLength += length;
  sums_.slopeSquared += slopeSquared;
}

/// Returns the recovery of the free surface (m) over a distance (m) from here on.
double ArmPass::recovery(double distance) const {
  double back = 0;
  for (std::size_t j = 0; j < mode_.size(); ++j)
    back -= mode_[j] * std::expm1(-coefficients_.rate[j] * distance);
  return back;
}

/// Returns the height of the line above the free surface at t; mode_ belongs to `from`.
ValueAndSlope ArmPass::clearanceAt(const Inside& inside, double from, double t) const {
  const double distance = (t - from) * inside.along;
  double back = recovered_, rising = 0;
  for (std::size_t j = 0; j < mode_.size(); ++j) {
    const double gone = std::expm1(-coefficients_.rate[j] * distance);
    back -= mode_[j] * gone;
    rising += coefficients_.rate[j] * mode_[j] * (1 + gone);
  }
  return {inside.height(t) - (leftHeight_ + back),
          inside.height.derivative(t) - inside.along * rising};
}

/// Returns the first position in (from, to] where the line reaches the free surface, or kNoZero.
double ArmPass::findEntry(const Inside& inside, double from, double to, double lowest) const {
  if (leftHeight_ + recovered_ + recovery(std::abs((to - from) * inside.along)) <= lowest)
    return kNoZero;
  const auto clearance = [&](double t) { return clearanceAt(inside, from, t); };
  double a = from;
  ValueAndSlope atA = clearance(a);
  for (const double b : turningPoints(to, inside.height, inside.along > 0)) {
    if ((b - a) * inside.along <= 0) continue;
    const ValueAndSlope atB = clearance(b);
    const double found = firstEnd(a, atA, b, atB, clearance);
    if (found != kNoZero) return found;
    a = b;
    atA = atB;
  }
  return kNoZero;
}

}  // namespace asperity
