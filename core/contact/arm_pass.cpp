#include "core/contact/arm_pass.h"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

constexpr int kMostEvents = 64;  // in one segment, which has a few; more are rounding

}  // namespace

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
    if (entry > 1) break;
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
