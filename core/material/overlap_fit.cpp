#include "core/material/overlap_fit.h"

#include <algorithm>
#include <cmath>

#include "core/base/linear_algebra.h"

namespace asperity {
namespace {

constexpr int kHighestDegree = 4;  // of the polynomials
// A vertical shift is the change of density times temperature. Where both moduli are power laws it
// cannot be told from a horizontal one. Then the law of entropy elasticity, b_T ~ T, decides;
// vertical shifts are expected to deviate from it by about this much.
constexpr double kUsualVertical = 0.01;  // decades

/// The points that determine the shift, as indices: those in the common range, and on each side the
/// next one beyond it, so that sparse sweeps have some.
struct Window {
  std::vector<std::size_t> colder, warmer;
  bool operator==(const Window&) const = default;
  std::size_t size() const { return colder.size() + warmer.size(); }
};

std::vector<std::size_t> within(const std::vector<double>& xs, double from, double to) {
  const auto first = std::ranges::lower_bound(xs, from) - xs.begin();
  const auto last = std::ranges::upper_bound(xs, to) - xs.begin();
  std::vector<std::size_t> indices;
  for (auto i = std::max<std::ptrdiff_t>(0, first - 1);
       i < std::min<std::ptrdiff_t>(std::ssize(xs), last + 1); ++i)
    indices.push_back(static_cast<std::size_t>(i));
  return indices;
}

Window windowAt(const LogSweep& colder, const LogSweep& warmer, double shift) {
  const CommonRange range = commonRange(colder, warmer, shift);
  return {within(colder.x, range.from - shift, range.to - shift),
          within(warmer.x, range.from, range.to)};
}

/// Solves the least-squares problem over one window by the Gauss-Newton method. The unknowns are
/// the coefficients of the polynomials of each modulus, the vertical shift and the horizontal one.
class WindowFit {
 public:
  /// expectedVertical: decades; empty where there is no vertical shift.
  WindowFit(const LogSweep& colder, const LogSweep& warmer, const Window& window,
            std::optional<double> expectedVertical, ShiftModuli moduli, double shift)
      : colder_(colder),
        warmer_(warmer),
        window_(window),
        isVertical_(expectedVertical.has_value()),
        expectedVertical_(expectedVertical.value_or(0)) {
    if (moduli != ShiftModuli::Loss) moduli_.push_back(&LogSweep::storage);
    if (moduli != ShiftModuli::Storage) moduli_.push_back(&LogSweep::loss);
    rows_ = static_cast<Eigen::Index>(window.size());
    degree_ = std::clamp<Eigen::Index>(rows_ / 2 - 1, 1, kHighestDegree);
    const CommonRange range = commonRange(colder, warmer, shift);
    centre_ = 0.5 * (range.from + range.to);
    scale_ = std::max(0.5 * range.width(), 0.05);
  }

  /// Returns nothing where the deviations do not determine the shift. The expected vertical shift
  /// has the weight that the deviations themselves give it, which are not known in advance: they
  /// are first those of a fit in which it has almost none, so that a shift far from what is
  /// expected is not taken for noise. Where such a fit is not determined, they are first the usual
  /// ones.
  std::optional<FittedShifts> solve(double start) {
    constexpr int kPasses = 4;
    constexpr double kMinDeviation = 1e-6;  // decades
    deviation_ = kMinDeviation;
    chooseDegree(start);
    if (!isVertical_) return fitted(start);
    if (!fitted(start)) deviation_ = kUsualVertical;
    std::optional<FittedShifts> found;
    for (int i = 0; i < kPasses; ++i) {
      deviation_ = std::max(kMinDeviation, deviation_);
      found = fitted(start);
      if (!found) return {};
    }
    return found;
  }

 private:
  std::optional<FittedShifts> fitted(double start) {
    const std::optional<FittedShifts> found = iterate(start);
    return found ? found : search(start);
  }

  std::optional<FittedShifts> iterate(double shift) {
    constexpr int kMaxIterations = 60;
    constexpr double kLongestStep = 0.1, kConverged = 1e-10;  // decades
    const double start = shift;
    // The first pass has no polynomials yet, but the step needs their slopes.
    coefficients_ = Eigen::VectorXd::Zero(linearUnknowns());
    double step = 0;
    for (int i = 0; i < kMaxIterations; ++i) {
      assemble(shift, i > 0);
      const LeastSquares solver(system_);
      const Eigen::VectorXd solution = solver.solve(data_);
      coefficients_ = solution.head(linearUnknowns());
      if (i == 0) continue;
      if (solver.rank() < system_.cols()) return {};
      step = std::clamp(solution[solution.size() - 1], -kLongestStep, kLongestStep);
      shift += step;
      if (!(std::abs(shift - start) < 1)) return {};
      if (std::abs(step) < kConverged) break;
    }
    if (!(std::abs(step) < 1e-4)) return {};
    return estimate(shift);
  }

  /// Lowers the degree of the polynomials until noise is a small part of what their slopes say
  /// about the shift. Else the moduli would seem to determine it better than they do.
  void chooseDegree(double shift) {
    constexpr double kMaxPart = 0.1;
    for (; degree_ > 1; --degree_) {
      coefficients_ = Eigen::VectorXd::Zero(linearUnknowns());
      const double squares = squaresAt(shift);
      const Eigen::MatrixXd polynomials = polynomialsOfRows();
      const auto left = static_cast<double>(polynomials.rows() - polynomials.cols());
      if (left < 1) continue;
      const SlopeSquares slopes = slopesBeside(polynomials, squares / left);
      if (slopes.ofNoise < kMaxPart * slopes.all) return;
    }
  }

  /// Returns the derivatives of the rows of the moduli by the coefficients of the polynomials.
  Eigen::MatrixXd polynomialsOfRows() const {
    return system_.topLeftCorner(moduliCount() * rows_, moduliCount() * polynomialUnknowns());
  }

  /// Returns the derivatives of the slopes by the same. Slopes are those of the colder isotherm,
  /// which a shift moves, and 0 elsewhere.
  Eigen::MatrixXd slopesOfRows() const {
    const Eigen::Index block = polynomialUnknowns();
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(moduliCount() * rows_, moduliCount() * block);
    for (Eigen::Index m = 0; m < moduliCount(); ++m)
      for (Eigen::Index i = m * rows_; i < m * rows_ + std::ssize(window_.colder); ++i)
        for (Eigen::Index k = 1; k < block; ++k)
          slopes(i, m * block + k) =
              static_cast<double>(k) * system_(i, m * block + k - 1) / scale_;
    return slopes;
  }

  /// Returns the derivatives of the rows of both moduli by a vertical shift.
  Eigen::VectorXd verticalOfRows() const {
    const auto colder = static_cast<Eigen::Index>(window_.colder.size());
    Eigen::VectorXd vertical = Eigen::VectorXd::Zero(2 * rows_);
    vertical.head(colder).setOnes();
    vertical.segment(rows_, colder).setOnes();
    return vertical;
  }

  struct SlopeSquares {
    double all = 0;      // sum of squares of the slopes
    double ofNoise = 0;  // the same that the errors of the slopes are expected to make
  };

  /// Returns what other unknowns (columns) leave of the slopes, with this variance of a modulus.
  SlopeSquares slopesBeside(const Eigen::MatrixXd& unknowns, double variance) const {
    // Slopes are linear in the coefficients of the polynomials.
    const Eigen::MatrixXd slopes = slopesOfRows();
    const Eigen::MatrixXd rest = slopes - unknowns * LeastSquares(unknowns).solveColumns(slopes);
    const Eigen::MatrixXd covariance = normalInverse(polynomialsOfRows());
    return {(rest * coefficients_.head(slopes.cols())).squaredNorm(),
            variance * (rest * covariance * rest.transpose()).trace()};
  }

  /// Returns the sum of the squares that the best of all other unknowns leave at this shift, and
  /// keeps these unknowns.
  double squaresAt(double shift) {
    assemble(shift, false);
    coefficients_ = LeastSquares(system_).solve(data_);
    return (data_ - system_ * coefficients_).squaredNorm();
  }

  /// Finds the minimum of these sums that is nearest to `start`: for noisy moduli, whose fitted
  /// curves turn so much that the steps of the Gauss-Newton method go past it. Farther away the
  /// curve may bend through the points of isotherms that no longer overlap. Returns nothing where
  /// there is none.
  std::optional<FittedShifts> search(double start) {
    constexpr double kRange = 0.5, kStep = 0.02, kPrecision = 1e-7;  // decades
    constexpr int kSteps = static_cast<int>(kRange / kStep);
    std::vector<double> squares;
    for (int i = -kSteps; i <= kSteps; ++i) squares.push_back(squaresAt(start + i * kStep));
    std::optional<int> best;
    for (int i = 1 - kSteps; i < kSteps; ++i) {
      const auto k = static_cast<std::size_t>(i + kSteps);
      const bool isMinimum = squares[k] <= squares[k - 1] && squares[k] < squares[k + 1];
      if (isMinimum && (!best || std::abs(i) < std::abs(*best))) best = i;
    }
    if (!best) return {};
    // Golden section between the neighbours.
    constexpr double kGolden = 0.6180339887498949;
    double low = start + (*best - 1) * kStep, high = start + (*best + 1) * kStep;
    double left = high - kGolden * (high - low), right = low + kGolden * (high - low);
    double ofLeft = squaresAt(left), ofRight = squaresAt(right);
    while (high - low > kPrecision) {
      if (ofLeft < ofRight) {
        high = right, right = left, ofRight = ofLeft;
        left = high - kGolden * (high - low);
        ofLeft = squaresAt(left);
      } else {
        low = left, left = right, ofLeft = ofRight;
        right = low + kGolden * (high - low);
        ofRight = squaresAt(right);
      }
    }
    const double shift = 0.5 * (low + high);
    squaresAt(shift);
    assemble(shift, true);
    if (LeastSquares(system_).rank() < system_.cols()) return {};
    return estimate(shift);
  }

  Eigen::Index polynomialUnknowns() const { return degree_ + 1; }
  Eigen::Index moduliCount() const { return static_cast<Eigen::Index>(moduli_.size()); }
  Eigen::Index linearUnknowns() const {
    return moduliCount() * polynomialUnknowns() + (isVertical_ ? 1 : 0);
  }

  /// Fills the rows: all points of one modulus, then of the other. The last column is the
  /// derivative of the model with respect to the shift, from the polynomials of the previous pass.
  void assemble(double shift, bool withShift) {
    const Eigen::Index block = polynomialUnknowns();
    const Eigen::Index rows = moduliCount() * rows_ + (isVertical_ ? 1 : 0);
    system_ = Eigen::MatrixXd::Zero(rows, linearUnknowns() + (withShift ? 1 : 0));
    data_ = Eigen::VectorXd::Zero(rows);
    if (isVertical_) {
      system_(rows - 1, moduliCount() * block) = deviation_ / kUsualVertical;
      data_[rows - 1] = expectedVertical_ * deviation_ / kUsualVertical;
    }
    for (Eigen::Index m = 0; m < moduliCount(); ++m) {
      Eigen::Index row = m * rows_;
      const auto add = [&](const LogSweep& sweep, std::size_t i, bool isColder) {
        const double u = (sweep.x[i] + (isColder ? shift : 0) - centre_) / scale_;
        double power = 1, slope = 0;
        for (Eigen::Index k = 0; k < block; ++k) {
          system_(row, m * block + k) = power;
          if (k + 1 < block)
            slope += static_cast<double>(k + 1) * coefficients_[m * block + k + 1] * power;
          power *= u;
        }
        // The measured modulus of the colder isotherm is b_T times the common curve.
        if (isVertical_ && isColder) system_(row, moduliCount() * block) = 1;
        if (withShift && isColder) system_(row, system_.cols() - 1) = slope / scale_;
        data_[row++] = (sweep.*moduli_[static_cast<std::size_t>(m)])[i];
      };
      for (const std::size_t i : window_.colder) add(colder_, i, true);
      for (const std::size_t i : window_.warmer) add(warmer_, i, false);
    }
  }

  FittedShifts estimate(double shift) {
    assemble(shift, true);
    Eigen::VectorXd unknowns(system_.cols());
    unknowns.head(linearUnknowns()) = coefficients_;
    unknowns[system_.cols() - 1] = 0;
    const Eigen::VectorXd misfit = data_ - system_ * unknowns;
    const double squares = misfit.squaredNorm();
    const auto left = static_cast<double>(system_.rows() - system_.cols());
    // The moduli alone, without the row of the expected vertical shift, say how much they deviate.
    deviation_ = std::sqrt(misfit.head(moduliCount() * rows_).squaredNorm() / std::max(1.0, left));
    FittedShifts found{{shift}, {isVertical_ ? unknowns[system_.cols() - 2] : 0}};
    if (!isVertical_) found.vertical.standardError = 0;
    if (left < 1) return found;
    const Eigen::MatrixXd inverse = normalInverse(system_);
    const Eigen::MatrixXd covariance = inverse * (squares / left);
    const auto errorOf = [&](Eigen::Index i) { return std::sqrt(std::max(0.0, covariance(i, i))); };
    found.horizontal.standardError = errorOf(system_.cols() - 1);
    if (isVertical_) {
      found.vertical.standardError = errorOf(system_.cols() - 2);
      const Eigen::Index last = system_.rows() - 1;
      found.ofExpected =
          (inverse * system_.row(last).transpose())[system_.cols() - 1] * data_[last];
    }
    if (moduliCount() == 2) found.residuals = residuals();
    return found;
  }

  /// Returns what more unknowns would explain of the assembled rows.
  OverlapResiduals residuals() const {
    const Eigen::Index rows = 2 * rows_;  // without that of the expected vertical shift
    const Eigen::MatrixXd known = system_.topRows(rows);
    const Eigen::VectorXd data = data_.head(rows);
    const LeastSquares solver(known);
    Eigen::MatrixXd basis = solver.basis();
    const auto rest = [&basis](const Eigen::VectorXd& column) -> Eigen::VectorXd {
      return column - basis * (basis.transpose() * column);
    };
    const auto contrast = [&](const Eigen::VectorXd& column) {
      constexpr double kIndependent = 1e-6;
      Contrast found;
      const Eigen::VectorXd own = rest(column);
      const double square = own.squaredNorm();
      if (!(square > kIndependent * kIndependent * column.squaredNorm())) return found;
      found.value = own.dot(data) / square;
      found.storageGain = own.head(rows_).squaredNorm() / (square * square);
      found.lossGain = own.tail(rows_).squaredNorm() / (square * square);
      found.explained = found.value * found.value * square;
      found.shiftChange = -found.value * solver.solve(column)[known.cols() - 1];
      return found;
    };
    OverlapResiduals found;
    found.verticalError = verticalError();
    const auto addToBasis = [&](const Eigen::VectorXd& column) {
      const Eigen::VectorXd own = rest(column);
      basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
      basis.rightCols(1) = own.normalized();
    };
    found.squares = rest(data).squaredNorm();
    found.values = static_cast<double>(rows);
    found.degreesOfFreedom = static_cast<double>(rows - basis.cols());
    Eigen::VectorXd difference = known.rightCols(1);
    difference.head(rows_).setZero();
    found.difference = found.differenceBesideVertical = contrast(difference);
    if (!isVertical_) {
      const Eigen::VectorXd vertical = verticalOfRows();
      found.vertical = contrast(vertical);
      if (std::isfinite(found.vertical.value)) addToBasis(vertical);
      found.differenceBesideVertical = contrast(difference);
    }
    if (std::isfinite(found.differenceBesideVertical.value)) addToBasis(difference);
    const Eigen::VectorXd left = rest(data);
    found.storage = residualsOfModulus(0, left, basis);
    found.loss = residualsOfModulus(rows_, left, basis);
    return found;
  }

  /// Returns what a fit leaves of the modulus whose rows begin at `from`. left: the residuals of
  /// all rows; basis: orthonormal, of all unknowns.
  OverlapResiduals::Modulus residualsOfModulus(Eigen::Index from, const Eigen::VectorXd& left,
                                               const Eigen::MatrixXd& basis) const {
    const auto colder = static_cast<Eigen::Index>(window_.colder.size());
    OverlapResiduals::Modulus modulus;
    addNoise(from, colder, modulus);
    addNoise(from + colder, rows_ - colder, modulus);
    for (Eigen::Index i = from; i < from + rows_; ++i) {
      modulus.squares += left[i] * left[i];
      modulus.degreesOfFreedom += 1 - basis.row(i).squaredNorm();
      const bool startsSweep = i == from || i == from + colder;
      if (startsSweep) continue;
      modulus.products += left[i] * left[i - 1];
      modulus.whiteProducts -= basis.row(i).dot(basis.row(i - 1));
      modulus.neighbours += 1;
    }
    return modulus;
  }

  /// Returns the standard error of a vertical shift that the assembled rows alone determine. A
  /// vertical shift moves the colder isotherm by 1, a horizontal one by the slope of its curve;
  /// only where that slope varies, along the frequency or between the moduli, do they differ. The
  /// slopes have errors, which make them vary as well: that part of the variation does not count.
  double verticalError() const {
    const Eigen::MatrixXd polynomials = polynomialsOfRows();
    const Eigen::VectorXd vertical = verticalOfRows();
    Eigen::MatrixXd unknowns(polynomials.rows(), polynomials.cols() + 1);
    unknowns << polynomials, vertical;
    const double variance = deviation_ * deviation_;
    const SlopeSquares besideVertical = slopesBeside(unknowns, variance);
    const double shiftAlone = slopesBeside(polynomials, variance).all;
    const double verticalAlone =
        (vertical - polynomials * LeastSquares(polynomials).solve(vertical)).squaredNorm();
    // |vertical beside polynomials and shift|^2 = |vertical|^2 |shift beside vertical|^2 /
    // |shift|^2
    const double verticalBesideShift =
        shiftAlone > 0 ? verticalAlone *
                             std::max(0.0, besideVertical.all - besideVertical.ofNoise) / shiftAlone
                       : 0;
    return verticalBesideShift > 0 ? std::sqrt(variance / verticalBesideShift)
                                   : std::numeric_limits<double>::infinity();
  }

  /// Adds the residuals of one sweep of one modulus about a polynomial of its own.
  void addNoise(Eigen::Index from, Eigen::Index count, OverlapResiduals::Modulus& modulus) const {
    const Eigen::Index block = polynomialUnknowns();
    if (count <= block) return;
    const Eigen::Index column = from < rows_ ? 0 : block;
    const Eigen::MatrixXd own = system_.block(from, column, count, block);
    const Eigen::VectorXd data = data_.segment(from, count);
    const LeastSquares solver(own);
    modulus.noiseSquares += (data - own * solver.solve(data)).squaredNorm();
    modulus.noiseFreedom += static_cast<double>(count - block);
  }

  const LogSweep &colder_, &warmer_;
  const Window& window_;
  bool isVertical_;
  double expectedVertical_ = 0;  // decades
  double deviation_ = 0;         // decades, of one measured modulus
  std::vector<std::vector<double> LogSweep::*> moduli_;
  Eigen::Index rows_ = 0, degree_ = 1;
  double centre_ = 0, scale_ = 1;
  Eigen::MatrixXd system_;
  Eigen::VectorXd data_, coefficients_;
};

}  // namespace

LogSweep logarithms(const Isotherm& isotherm) {
  LogSweep sweep;
  for (const DynamicModulus& point : isotherm.points) {
    sweep.x.push_back(std::log10(point.frequency));
    sweep.storage.push_back(std::log10(point.storage));
    sweep.loss.push_back(std::log10(point.loss));
  }
  return sweep;
}

std::vector<LogSweep> logarithms(std::span<const Isotherm> isotherms) {
  std::vector<LogSweep> sweeps;
  for (const Isotherm& isotherm : isotherms) sweeps.push_back(logarithms(isotherm));
  return sweeps;
}

CommonRange commonRange(const LogSweep& colder, const LogSweep& warmer, double shift) {
  return {std::max(colder.x.front() + shift, warmer.x.front()),
          std::min(colder.x.back() + shift, warmer.x.back())};
}

std::optional<FittedShifts> fittedShift(const LogSweep& colder, const LogSweep& warmer,
                                        double shift, std::optional<double> expectedVertical,
                                        ShiftModuli moduli) {
  constexpr int kWindows = 4;
  std::optional<FittedShifts> found;
  Window used;
  for (int i = 0; i < kWindows; ++i) {
    if (!(commonRange(colder, warmer, shift).width() > 0)) return found;
    const Window window = windowAt(colder, warmer, shift);
    if (window.size() < 4 || window.colder.size() < 2 || window.warmer.size() < 2) return found;
    if (found && window == used) return found;
    WindowFit fit(colder, warmer, window, expectedVertical, moduli, shift);
    const std::optional<FittedShifts> next = fit.solve(shift);
    if (!next) return found;
    found = next;
    used = window;
    shift = next->horizontal.value;
  }
  return found;
}

}  // namespace asperity
