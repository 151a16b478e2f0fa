#include "tests/stability/reference_arms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/stability/reference_modes.h"

namespace asperity {
namespace {

using Vector = std::vector<Wide>;

constexpr int kLooks = 16;      // at a function along a piece
constexpr int kMaxEvents = 64;  // in a piece; more are rounding
constexpr Wide kPoint = 1e-9;   // of a period
constexpr Wide kNearlyStill = 0.01;
constexpr Wide kSmooth = 0.5;  // decays by Gauss's points, above in closed form

/// Where a function is lowest between two places around one dip, or just below 0.
template <class Function>
Wide lowestBetween(Wide low, Wide high, const Function& function) {
  static const Wide golden = (std::sqrt(Wide(5)) - 1) / 2;
  Wide left = high - golden * (high - low), right = low + golden * (high - low);
  Wide atLeft = function(left), atRight = function(right);
  for (int i = 0; i < 60 && atLeft >= 0 && atRight >= 0; ++i) {
    const bool isLeft = atLeft < atRight;
    (isLeft ? high : low) = isLeft ? right : left;
    (isLeft ? right : left) = isLeft ? left : right;
    (isLeft ? atRight : atLeft) = isLeft ? atLeft : atRight;
    (isLeft ? left : right) = isLeft ? high - golden * (high - low) : low + golden * (high - low);
    (isLeft ? atLeft : atRight) = function(isLeft ? left : right);
  }
  return atLeft < atRight ? left : right;
}

/// The first place in [from, to] from which on a function is below 0 that is not so at `from` but
/// for rounding; beyond `to` if there is none.
template <class Function>
Wide firstBelow(Wide from, Wide to, const Function& function) {
  Wide places[3] = {from, from, from}, values[3] = {function(from), 0, 0};
  values[1] = values[2] = values[0];
  for (int k = 1; k <= kLooks; ++k) {
    places[0] = places[1], places[1] = places[2];
    values[0] = values[1], values[1] = values[2];
    places[2] = k == kLooks ? to : from + (to - from) * k / kLooks;
    values[2] = function(places[2]);
    if (k > 1 && values[1] < values[0] && values[1] < values[2]) {
      const Wide dip = lowestBetween(places[0], places[2], function);
      if (function(dip) < 0) return bisect(places[0], dip, function);
    }
    if (values[2] >= 0) continue;
    Wide above = places[1];
    if (values[1] < 0) {
      above = lowestBetween(places[1], places[2], [&](Wide x) { return -function(x); });
      if (function(above) <= 0) return places[1];
    }
    return bisect(above, places[2], function);
  }
  return to + 1;
}

/// An arm's strain while its element moves by y' = p0 + p1 s + p2 s^2, s m from where it was e:
/// e' = y' - e / c.
class DrivenArm {
 public:
  DrivenArm(Wide c, Wide e, const std::array<Wide, 3>& p) : c_(c), e_(e), p_(p) {
    // A particular solution is c y' - c^2 y'' + c^3 y'''.
    q_ = {c * (p[0] - c * (p[1] - 2 * c * p[2])), c * (p[1] - 2 * c * p[2]), c * p[2]};
  }

  Wide at(Wide s) const {
    if (s > kSmooth * c_) return (e_ - q_[0]) * std::exp(-s / c_) + value(q_, s);
    const auto kept = [&](Wide x) { return std::exp((x - s) / c_) * value(p_, x); };
    return e_ * std::exp(-s / c_) +
           (s > kNearlyStill * c_ ? integral(0, s, kept) : integral<4>(0, s, kept));
  }
  /// integral of e over [0, s].
  Wide sum(Wide s) const {
    if (!(s > kSmooth * c_)) return integral(0, s, [&](Wide x) { return at(x); });
    return -(e_ - q_[0]) * c_ * std::expm1(-s / c_) +
           integral(0, s, [&](Wide x) { return value(q_, x); });
  }
  /// What its dashpot takes over [0, s]: integral of e^2 / c.
  Wide loss(Wide s) const {
    if (!(s > kSmooth * c_)) return integral(0, s, [&](Wide x) { return at(x) * at(x); }) / c_;
    const Wide a = e_ - q_[0], kept = std::exp(-s / c_);
    return -a * a / 2 * std::expm1(-2 * s / c_) + 2 * a * (tail(0) - kept * tail(s)) +
           integral(0, s, [&](Wide x) { return value(q_, x) * value(q_, x); }) / c_;
  }

 private:
  static Wide value(const std::array<Wide, 3>& p, Wide x) { return p[0] + x * (p[1] + x * p[2]); }
  /// Q + c Q' + c^2 Q''.
  Wide tail(Wide x) const {
    return value(q_, x) + c_ * (q_[1] + 2 * q_[2] * x) + 2 * c_ * c_ * q_[2];
  }

  Wide c_, e_;
  std::array<Wide, 3> p_, q_;
};

/// One pass over a period, per 4G.
class ArmReference {
 public:
  ArmReference(const Line& line, Scheme scheme, const ElementLaw& law, Wide velocity)
      : line_(line, scheme),
        modes_(referenceModes(law, velocity)),
        dashpot_(velocity * law.viscosity / law.equilibriumModulus) {
    for (const Arm& arm : law.arms) {
      modulus_.push_back(Wide(arm.modulus) / law.equilibriumModulus);
      memory_.push_back(velocity * arm.relaxationTime);
    }
  }

  const ReferenceLine& line() const { return line_; }
  std::size_t arms() const { return modulus_.size(); }
  Wide depthSum() const { return depthSum_; }
  Wide dissipation() const { return dissipation_; }
  Wide contact() const { return contact_; }
  Wide glassy() const {
    Wide sum = 1;
    for (const Wide g : modulus_) sum += g;
    return sum;
  }
  /// m, by which each arm's strain misses the one that closes the period.
  Vector missing() const {
    Vector found;
    for (std::size_t i = 0; i < arms(); ++i) {
      const Wide creep = memory_[i] > line_.length ? creep_[i] : begin_[i] - strain_[i];
      found.push_back(creep / -std::expm1(-line_.length / memory_[i]));
    }
    return found;
  }

  void run(Wide depth, std::span<const Wide> strain) {
    depth_ = depth;
    depthSum_ = dissipation_ = contact_ = 0;
    begin_.assign(strain.begin(), strain.end());
    strain_ = begin_;
    creep_.assign(arms(), 0);
    touching_ = true;
    for (const Piece& piece : line_.pieces) take(piece);
    if (!touching_) close(line_.length);
  }

 private:
  void take(const Piece& piece) {
    Wide x = piece.from;
    for (int event = 0; event < kMaxEvents; ++event) {
      if (touching_) {
        const Wide end = whereContactEnds(piece, x);
        press(piece, x, std::min(end, piece.to));
        if (end > piece.to) return;
        leave(piece.rise(end), piece.rise.slope(end), piece.origin + end);
        x = end;
      }
      if (piece.lowest() > leftRise_ + back(piece.origin + piece.to)) return;
      const Wide entry = firstBelow(x, piece.to, [&](Wide at) {
        return (piece.rise(at) - leftRise_) - back(piece.origin + at);
      });
      if (entry > piece.to) return;
      close(piece.origin + entry);
      touching_ = true;
      x = entry;
    }
    if (touching_) press(piece, x, piece.to);
  }

  std::vector<DrivenArm> drivenFrom(const Polynomial& rise) const {
    std::vector<DrivenArm> driven;
    for (std::size_t i = 0; i < arms(); ++i)
      driven.emplace_back(memory_[i], strain_[i],
                          std::array<Wide, 3>{-rise.a1, -2 * rise.a2, -3 * rise.a3});
    return driven;
  }

  Wide whereContactEnds(const Piece& piece, Wide from) const {
    const Polynomial rise = piece.rise.about(from);
    const auto driven = drivenFrom(rise);
    const Wide end = firstBelow(0, piece.to - from, [&](Wide s) {
      Wide pressure = depth_ - rise(s) - dashpot_ * rise.slope(s);
      for (std::size_t i = 0; i < arms(); ++i) pressure += modulus_[i] * driven[i].at(s);
      return pressure;
    });
    return from + end;
  }

  void press(const Piece& piece, Wide from, Wide to) {
    const Polynomial rise = piece.rise.about(from);
    const auto driven = drivenFrom(rise);
    const Wide way = to - from;
    depthSum_ += integral(0, way, [&](Wide s) { return depth_ - rise(s); });
    dissipation_ +=
        dashpot_ * integral(0, way, [&](Wide s) { return rise.slope(s) * rise.slope(s); });
    contact_ += way;
    for (std::size_t i = 0; i < arms(); ++i) {
      dissipation_ += modulus_[i] * driven[i].loss(way);
      creep_[i] += driven[i].sum(way) / memory_[i];
      strain_[i] = driven[i].at(way);
    }
  }

  /// Nothing presses there: what the strains hold is the depth. Where they forget within a point it
  /// has more digits than the difference of indentation and rise.
  void leave(Wide rise, Wide slope, Wide position) {
    touching_ = false;
    leftRise_ = rise;
    leftPosition_ = position;
    Wide depth = depth_ - rise;
    if (memory_.front() < kPoint * line_.length) {
      depth = dashpot_ * slope;
      for (std::size_t i = 0; i < arms(); ++i) depth -= modulus_[i] * strain_[i];
    }
    amplitude_.clear();
    for (const ReferenceMode& mode : modes_) {
      Wide amplitude = mode.settled * depth;
      for (std::size_t i = 0; i < arms(); ++i) amplitude -= mode.ofCreep[i] * strain_[i];
      amplitude_.push_back(amplitude);
    }
  }

  /// m, by which the free surface has come back.
  Wide back(Wide position) const {
    Wide sum = 0;
    for (std::size_t j = 0; j < modes_.size(); ++j)
      sum -= amplitude_[j] * std::expm1(-modes_[j].rate * (position - leftPosition_));
    return sum;
  }

  void close(Wide position) {
    const Wide way = position - leftPosition_;
    std::fill(strain_.begin(), strain_.end(), 0);
    for (std::size_t j = 0; j < modes_.size(); ++j) {
      const ReferenceMode& mode = modes_[j];
      const Wide a = amplitude_[j], gone = -std::expm1(-mode.rate * way);
      depthSum_ += a * gone / mode.rate;
      dissipation_ += a * a / mode.settled / 2 * gone * (2 - gone);
      for (std::size_t i = 0; i < arms(); ++i) {
        creep_[i] -= a * gone * mode.toCreep[i];
        strain_[i] += a * (1 - gone) * mode.toStrain[i];
      }
    }
  }

  ReferenceLine line_;
  std::vector<ReferenceMode> modes_;
  Wide dashpot_;             // m
  Vector modulus_, memory_;  // per G, m
  Wide depth_ = 0, depthSum_ = 0, dissipation_ = 0, contact_ = 0;
  Vector begin_, strain_, creep_, amplitude_;  // m
  Wide leftRise_ = 0, leftPosition_ = 0;
  bool touching_ = true;
};

/// The solution of a few linear equations, row after row with the right side at its end.
Vector solved(std::vector<Vector> rows) {
  const std::size_t n = rows.size();
  for (Vector& row : rows) {
    Wide largest = 0;
    for (std::size_t k = 0; k < n; ++k) largest = std::max(largest, std::abs(row[k]));
    for (Wide& each : row) each /= largest;
  }
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t i = c + 1; i < n; ++i)
      if (std::abs(rows[i][c]) > std::abs(rows[pivot][c])) pivot = i;
    std::swap(rows[c], rows[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      const Wide part = i == c ? 0 : rows[i][c] / rows[c][c];
      if (part != 0)
        for (std::size_t k = c; k <= n; ++k) rows[i][k] -= part * rows[c][k];
    }
  }
  Vector found;
  for (std::size_t i = 0; i < n; ++i) found.push_back(rows[i][n] / rows[i][i]);
  return found;
}

class Closing {
 public:
  /// load: F_N / 4G, or 0 where the depth is given.
  Closing(ArmReference& pass, Wide load, Wide depth) : pass_(pass), load_(load), depth_(depth) {}

  ReferenceResult from(std::span<const double> strains) {
    Vector unknown(strains.begin(), strains.end());
    if (load_ > 0) unknown.insert(unknown.begin(), depth_);
    ReferenceResult best;
    best.periodicityError = std::numeric_limits<Wide>::infinity();
    for (int step = 0, stalled = 0; step < 40 && stalled < 3; ++step) {
      const Vector residual = residualAt(unknown);
      stalled = worst_ < best.periodicityError / 2 ? 0 : stalled + 1;
      if (worst_ < best.periodicityError)
        best = {depth_, pass_.dissipation() / pass_.depthSum(),
                pass_.contact() / pass_.line().length, 1, worst_};
      if (worst_ < 1e-19L) break;
      const Vector by = solved(slopesAt(unknown, residual));
      for (std::size_t i = 0; i < unknown.size(); ++i) unknown[i] -= by[i];
    }
    return best;
  }

 private:
  Wide scale() const { return std::min(pass_.line().meanRise, depth_); }

  Vector residualAt(const Vector& unknown) {
    const bool byForce = load_ > 0;
    if (byForce) depth_ = unknown[0];
    pass_.run(depth_, std::span(unknown).subspan(byForce ? 1 : 0));
    Vector residual = pass_.missing();
    worst_ = byForce ? std::abs(pass_.depthSum() / load_ - 1) : 0;
    for (const Wide missing : residual) worst_ = std::max(worst_, std::abs(missing) / scale());
    if (byForce)
      residual.insert(residual.begin(), (pass_.depthSum() - load_) / pass_.line().length);
    return residual;
  }

  std::vector<Vector> slopesAt(const Vector& unknown, const Vector& residual) {
    const Wide depth = depth_;
    std::vector<Vector> rows(unknown.size(), Vector(unknown.size() + 1));
    for (std::size_t k = 0; k < unknown.size(); ++k) {
      depth_ = depth;
      const bool isDepth = load_ > 0 && k == 0;
      const Wide step = 1e-8L * (isDepth ? depth : scale() / pass_.glassy());
      Vector moved = unknown;
      moved[k] += step;
      const Vector there = residualAt(moved);
      for (std::size_t i = 0; i < rows.size(); ++i) rows[i][k] = (there[i] - residual[i]) / step;
    }
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].back() = residual[i];
    depth_ = depth;
    return rows;
  }

  ArmReference& pass_;
  Wide load_, depth_, worst_ = 0;
};

}  // namespace

ReferenceResult referenceWithArms(const Line& line, Scheme scheme, const ElementLaw& law,
                                  double velocity, const Load& load, double depth,
                                  std::span<const double> strains) {
  ArmReference pass(line, scheme, law, velocity);
  const Wide perStiffness = load.kind == LoadKind::Force
                                ? load.normalForce / (4 * Wide(law.equilibriumModulus))
                                : Wide(0);
  return Closing(pass, perStiffness, load.kind == LoadKind::Force ? depth : load.depth)
      .from(strains);
}

}  // namespace asperity
