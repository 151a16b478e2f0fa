#include "core/material/joint_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/base/linear_algebra.h"
#include "core/base/stop.h"

namespace asperity {
namespace {

constexpr double kKnots = 0.15;                          // decades between the knots
constexpr double kMargin = 0.6;                          // decades of knots beyond the points
constexpr double kLeastNoise = 3e-5, kLeastBend = 1e-5;  // decades
constexpr int kOrder = 3;                                // of the differences
const Eigen::Vector4d kDifference{-1, 3, -3, 1};

/// The values of the four cubic B-splines that are not 0 at a point, and their derivatives.
struct Splines {
  Eigen::Index first = 0;
  std::array<double, 4> value{}, slope{};

  /// position: in distances of knots from the first one.
  explicit Splines(double position) : first(static_cast<Eigen::Index>(std::floor(position))) {
    const double t = position - std::floor(position), u = 1 - t;
    value = {u * u * u / 6, (3 * t * t * t - 6 * t * t + 4) / 6,
             (3 * u * u * u - 6 * u * u + 4) / 6, t * t * t / 6};
    slope = {-u * u / 2, (3 * t * t - 4 * t) / 2, (4 * u - 3 * u * u) / 2, t * t / 2};
    for (double& one : slope) one /= kKnots;
  }
};

/// One modulus: the variances of its noise and of the third differences of its coefficients.
struct FittedModulus {
  std::vector<double> LogSweep::*values;
  double noise = 1e-4, bend = 1e-4;  // decades^2
  Eigen::MatrixXd normal{};          // normal equations of its values alone
};

class JointFit {
 public:
  JointFit(std::span<const LogSweep> sweeps, const std::vector<double>& start, ShiftModuli moduli)
      : sweeps_(sweeps), shifts_(start) {
    if (moduli != ShiftModuli::Loss) moduli_.push_back({&LogSweep::storage});
    if (moduli != ShiftModuli::Storage) moduli_.push_back({&LogSweep::loss});
    double from = sweeps[0].x.front() + start[0], to = from;
    for (std::size_t i = 0; i < sweeps.size(); ++i) {
      from = std::min(from, sweeps[i].x.front() + start[i]);
      to = std::max(to, sweeps[i].x.back() + start[i]);
    }
    origin_ = from - kMargin;
    splines_ = static_cast<Eigen::Index>(std::ceil((to + kMargin - origin_) / kKnots)) + 3;
    unknowns_ = Eigen::VectorXd::Zero(modulusColumn(moduli_.size()) + std::ssize(sweeps));
  }

  enum class Result { Converged, OutOfKnots, Failed };

  /// Finds shifts and curves by the Gauss-Newton method, and their variances along the way.
  Result solve(const std::stop_token& stop) {
    constexpr int kMaxIterations = 60;
    constexpr double kConverged = 1e-5, kEnough = 1e-3;  // decades
    double step = 0;
    for (int i = 0; i < kMaxIterations; ++i) {
      throwIfStopped(stop);
      // The first pass has no curves yet, but the shifts need their slopes.
      assemble(i > 0);
      inverse_ = inverseOfPositive(normal_);
      if (inverse_.size() == 0) return Result::Failed;
      unknowns_ = inverse_ * right_;
      if (i > 0) step = moveShifts();
      if (!isWithinKnots()) return Result::OutOfKnots;
      const bool isSettled = updateVariances();
      if (i > 0 && step < kConverged && isSettled) return Result::Converged;
    }
    return step < kEnough ? Result::Converged : Result::Failed;
  }

  const std::vector<double>& shifts() const { return shifts_; }
  double covariance(std::size_t i, std::size_t k) const {
    return inverse_(shiftColumn(i), shiftColumn(k));
  }

  double noise() const {
    double logarithms = 0;
    for (const FittedModulus& modulus : moduli_) logarithms += std::log(modulus.noise);
    return std::exp(0.5 * logarithms / static_cast<double>(moduli_.size()));
  }

 private:
  Eigen::Index modulusColumn(std::size_t m) const {
    return static_cast<Eigen::Index>(m) * splines_;
  }
  Eigen::Index shiftColumn(std::size_t i) const {
    return modulusColumn(moduli_.size()) + static_cast<Eigen::Index>(i);
  }

  /// Returns the longest step.
  double moveShifts() {
    constexpr double kLongestStep = 0.1;  // decades
    double longest = 0;
    for (std::size_t i = 0; i < shifts_.size(); ++i) {
      const double step = std::clamp(unknowns_[shiftColumn(i)], -kLongestStep, kLongestStep);
      shifts_[i] += step;
      longest = std::max(longest, std::abs(step));
    }
    return longest;
  }

  bool isWithinKnots() const {
    const double end = origin_ + kKnots * static_cast<double>(splines_ - 3);
    for (std::size_t i = 0; i < sweeps_.size(); ++i)
      if (!(sweeps_[i].x.front() + shifts_[i] > origin_ && sweeps_[i].x.back() + shifts_[i] < end))
        return false;
    return true;
  }

  Splines splinesAt(std::size_t sweep, std::size_t point) const {
    return Splines((sweeps_[sweep].x[point] + shifts_[sweep] - origin_) / kKnots);
  }

  void assemble(bool withShifts) {
    normal_ = Eigen::MatrixXd::Zero(unknowns_.size(), unknowns_.size());
    right_ = Eigen::VectorXd::Zero(unknowns_.size());
    for (std::size_t m = 0; m < moduli_.size(); ++m) {
      moduli_[m].normal = Eigen::MatrixXd::Zero(unknowns_.size(), unknowns_.size());
      for (std::size_t i = 0; i < sweeps_.size(); ++i)
        for (std::size_t k = 0; k < sweeps_[i].x.size(); ++k) addValue(m, i, k, withShifts);
      normal_ += moduli_[m].normal + bends(m);
    }
    // The shifts have no origin of their own, and some may be undetermined.
    constexpr double kLoose = 100, kFixed = 1e-3;  // decades
    const std::size_t count = sweeps_.size();
    const Eigen::Index first = shiftColumn(0), size = std::ssize(sweeps_);
    normal_.block(first, first, size, size).array() += 1 / (kFixed * kFixed);
    for (std::size_t i = 0; i < count; ++i)
      normal_(shiftColumn(i), shiftColumn(i)) += 1 / (kLoose * kLoose);
  }

  void addValue(std::size_t m, std::size_t sweep, std::size_t point, bool withShifts) {
    constexpr std::size_t kSplines = 4, kUnknowns = 5;
    FittedModulus& modulus = moduli_[m];
    const Splines splines = splinesAt(sweep, point);
    std::array<Eigen::Index, kUnknowns> columns{};
    std::array<double, kUnknowns> row{};
    for (std::size_t a = 0; a < kSplines; ++a) {
      columns[a] = modulusColumn(m) + splines.first + static_cast<Eigen::Index>(a);
      row[a] = splines.value[a];
      if (withShifts) row[kSplines] += unknowns_[columns[a]] * splines.slope[a];
    }
    columns[kSplines] = shiftColumn(sweep);
    const double measured = (sweeps_[sweep].*modulus.values)[point];
    for (std::size_t a = 0; a < kUnknowns; ++a) {
      right_[columns[a]] += row[a] * measured / modulus.noise;
      for (std::size_t b = 0; b < kUnknowns; ++b)
        modulus.normal(columns[a], columns[b]) += row[a] * row[b] / modulus.noise;
    }
  }

  /// Returns the normal equations of the third differences of a modulus.
  Eigen::MatrixXd bends(std::size_t m) const {
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(unknowns_.size(), unknowns_.size());
    for (Eigen::Index i = modulusColumn(m); i + kOrder < modulusColumn(m + 1); ++i)
      normal.block<kOrder + 1, kOrder + 1>(i, i) +=
          kDifference * kDifference.transpose() / moduli_[m].bend;
    return normal;
  }

  double squaresOfResiduals(std::size_t m) const {
    double squares = 0;
    for (std::size_t i = 0; i < sweeps_.size(); ++i)
      for (std::size_t k = 0; k < sweeps_[i].x.size(); ++k) {
        const Splines splines = splinesAt(i, k);
        double residual = (sweeps_[i].*moduli_[m].values)[k];
        for (std::size_t a = 0; a < splines.value.size(); ++a)
          residual -= splines.value[a] *
                      unknowns_[modulusColumn(m) + splines.first + static_cast<Eigen::Index>(a)];
        squares += residual * residual;
      }
    return squares;
  }

  /// Returns whether the variances are those of the previous pass.
  bool updateVariances() {
    constexpr double kSettled = 0.02, kLeastFreedom = 0.5;
    double values = 0;
    for (const LogSweep& sweep : sweeps_) values += static_cast<double>(sweep.x.size());
    bool areSettled = true;
    for (std::size_t m = 0; m < moduli_.size(); ++m) {
      FittedModulus& modulus = moduli_[m];
      const Eigen::MatrixXd normal = bends(m);
      const double ofNoise = values - inverse_.cwiseProduct(modulus.normal).sum();
      const double ofBends =
          static_cast<double>(splines_ - kOrder) - inverse_.cwiseProduct(normal).sum();
      const double noise = std::max(kLeastNoise * kLeastNoise,
                                    squaresOfResiduals(m) / std::max(kLeastFreedom, ofNoise));
      const double bend =
          std::max(kLeastBend * kLeastBend, modulus.bend * unknowns_.dot(normal * unknowns_) /
                                                std::max(kLeastFreedom, ofBends));
      areSettled = areSettled && std::abs(noise / modulus.noise - 1) < kSettled &&
                   std::abs(bend / modulus.bend - 1) < kSettled;
      modulus.noise = noise;
      modulus.bend = bend;
    }
    return areSettled;
  }

  std::span<const LogSweep> sweeps_;
  std::vector<double> shifts_;
  std::vector<FittedModulus> moduli_;
  double origin_ = 0;         // decades, of the knots
  Eigen::Index splines_ = 0;  // of one modulus
  Eigen::MatrixXd normal_, inverse_;
  Eigen::VectorXd right_, unknowns_;
};

}  // namespace

JointShifts jointShifts(std::span<const LogSweep> sweeps, const std::vector<double>& start,
                        const std::vector<double>& weights, ShiftModuli moduli,
                        const std::stop_token& stop) {
  constexpr int kRestarts = 6;
  std::optional<JointFit> joint;
  JointFit::Result result = JointFit::Result::OutOfKnots;
  // Knots are laid anew where the shifts leave them.
  for (int i = 0; i < kRestarts && result == JointFit::Result::OutOfKnots; ++i) {
    joint.emplace(sweeps, joint ? std::vector<double>(joint->shifts()) : start, moduli);
    result = joint->solve(stop);
  }
  if (result != JointFit::Result::Converged) return {};
  const JointFit& fit = *joint;
  const std::size_t count = sweeps.size();
  double origin = 0;
  for (std::size_t i = 0; i < count; ++i) origin += weights[i] * fit.shifts()[i];
  JointShifts found;
  found.noise = fit.noise();
  for (std::size_t i = 0; i < count; ++i) {
    double variance = 0;
    for (std::size_t a = 0; a < count; ++a)
      for (std::size_t b = 0; b < count; ++b)
        variance += ((a == i ? 1 : 0) - weights[a]) * ((b == i ? 1 : 0) - weights[b]) *
                    fit.covariance(a, b);
    found.shifts.push_back({fit.shifts()[i] - origin, std::sqrt(std::max(0.0, variance))});
  }
  return found;
}

}  // namespace asperity
