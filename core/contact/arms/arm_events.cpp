// A part of ArmPass: it finds where contact begins and ends inside a segment, and sums over pieces.
#include <algorithm>
#include <cmath>

#include "core/contact/arms/arm_pass.h"
#include "core/contact/kernels/decay_moments.h"

namespace asperity {
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
