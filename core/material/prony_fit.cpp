#include "core/material/prony_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/input_error.h"
#include "core/base/linear_algebra.h"
#include "core/base/number_text.h"
#include "core/base/stop.h"
#include "core/material/element_law.h"

namespace asperity {
namespace {

constexpr double kBeyond = 0.5;         // decades of times outside of the measured range
constexpr double kFarBeyond = 2;        // of times below it, where these are needed
constexpr double kPoor = 0.03;          // relative residual that may need them
constexpr double kMuchBetter = 0.5;     // of that residual
constexpr double kTermsPerDecade = 8;   // at most, where the number is chosen
constexpr double kNearFloor = 1.05;     // of the least residual
constexpr double kGoodEnough = 0.002;   // relative; no instrument measures better
constexpr double kMaxOfSmallest = 1.1;  // that scatter lets an equilibrium modulus exceed
constexpr double kNothing = 1e-9;       // of the smallest storage modulus

/// Returns the x >= 0 that minimizes |A x - b|, by the active-set method of Lawson and Hanson,
/// Solving Least Squares Problems, ch. 23.
Eigen::VectorXd nonNegativeLeastSquares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  const Eigen::Index n = a.cols();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
  std::vector<bool> isFree(static_cast<std::size_t>(n), false);
  const double tolerance = 1e-11 * (a.transpose() * b).cwiseAbs().maxCoeff();
  const auto solveFree = [&] {
    std::vector<Eigen::Index> columns;
    for (Eigen::Index i = 0; i < n; ++i)
      if (isFree[static_cast<std::size_t>(i)]) columns.push_back(i);
    const Eigen::VectorXd part = LeastSquares(a(Eigen::all, columns)).solve(b);
    Eigen::VectorXd whole = Eigen::VectorXd::Zero(n);
    for (std::size_t k = 0; k < columns.size(); ++k)
      whole[columns[k]] = part[static_cast<Eigen::Index>(k)];
    return whole;
  };
  for (Eigen::Index outer = 0; outer < 3 * n; ++outer) {
    // The unknown that gains most from leaving 0 becomes free.
    const Eigen::VectorXd gain = a.transpose() * (b - a * x);
    Eigen::Index best = -1;
    for (Eigen::Index i = 0; i < n; ++i)
      if (!isFree[static_cast<std::size_t>(i)] && gain[i] > tolerance &&
          (best < 0 || gain[i] > gain[best]))
        best = i;
    if (best < 0) break;
    isFree[static_cast<std::size_t>(best)] = true;
    // Unknowns that would become negative stop at 0 and are fixed again.
    while (true) {
      const Eigen::VectorXd wanted = solveFree();
      double step = 1;
      for (Eigen::Index i = 0; i < n; ++i)
        if (isFree[static_cast<std::size_t>(i)] && wanted[i] <= 0)
          step = std::min(step, x[i] / (x[i] - wanted[i] + 1e-300));
      if (step >= 1) {
        x = wanted;
        break;
      }
      x += step * (wanted - x);
      bool fixedOne = false;
      for (Eigen::Index i = 0; i < n; ++i)
        if (isFree[static_cast<std::size_t>(i)] && wanted[i] <= 0 && x[i] <= 1e-14 * x.maxCoeff()) {
          x[i] = 0;
          isFree[static_cast<std::size_t>(i)] = false;
          fixedOne = true;
        }
      if (!fixedOne) break;
    }
  }
  return x.cwiseMax(0.0);
}

double angular(double frequency) {
  return 2 * std::numbers::pi * frequency;
}

/// Returns relaxation times that are evenly spaced in the logarithm, falling.
std::vector<double> relaxationTimes(double lowest, double highest, double decadesBelow, int count) {
  const double from = std::log10(1 / angular(lowest)) + kBeyond;
  const double to = std::log10(1 / angular(highest)) - decadesBelow;
  std::vector<double> times;
  for (int i = 0; i < count; ++i)
    times.push_back(
        std::pow(10, count == 1 ? 0.5 * (from + to) : from + (to - from) * i / (count - 1)));
  return times;
}

/// The system of relative residuals: its columns are those of the relaxation times, then that of
/// G_inf.
struct RelativeSystem {
  Eigen::MatrixXd columns;
  Eigen::VectorXd ones;
};

RelativeSystem relativeSystem(std::span<const DynamicModulus> points,
                              const std::vector<double>& times, double knownEquilibrium) {
  const bool isFitted = std::isnan(knownEquilibrium);
  const auto m = static_cast<Eigen::Index>(points.size());
  const auto n = static_cast<Eigen::Index>(times.size());
  RelativeSystem system{Eigen::MatrixXd::Zero(2 * m, n + (isFitted ? 1 : 0)),
                        Eigen::VectorXd::Ones(2 * m)};
  for (Eigen::Index k = 0; k < m; ++k) {
    const DynamicModulus& point = points[static_cast<std::size_t>(k)];
    for (Eigen::Index i = 0; i < n; ++i) {
      const double turn = angular(point.frequency) * times[static_cast<std::size_t>(i)];
      const double part = 1 / (1 + turn * turn);
      system.columns(k, i) = turn * turn * part / point.storage;
      system.columns(m + k, i) = turn * part / point.loss;
    }
    if (isFitted)
      system.columns(k, n) = 1 / point.storage;
    else
      system.ones[k] -= knownEquilibrium / point.storage;
  }
  return system;
}

PronySeries fitWith(std::span<const DynamicModulus> points, int terms, double decadesBelow,
                    double knownEquilibrium) {
  const std::vector<double> times =
      relaxationTimes(points.front().frequency, points.back().frequency, decadesBelow, terms);
  const RelativeSystem system = relativeSystem(points, times, knownEquilibrium);
  // The triangular factor of a QR factorization has the same least squares in few rows. Each column
  // is scaled to length 1, so that tolerances mean the same for all moduli.
  const Eigen::VectorXd lengths = system.columns.colwise().norm();
  Eigen::MatrixXd joined(system.columns.rows(), system.columns.cols() + 1);
  joined << system.columns * lengths.cwiseInverse().asDiagonal(), system.ones;
  const Eigen::MatrixXd triangle = triangularFactor(joined);
  const Eigen::VectorXd unknowns = nonNegativeLeastSquares(triangle.leftCols(system.columns.cols()),
                                                           triangle.col(system.columns.cols()))
                                       .cwiseQuotient(lengths);

  PronySeries series;
  series.terms = terms;
  series.decadesBelow = decadesBelow;
  series.equilibriumModulus =
      std::isnan(knownEquilibrium) ? unknowns[unknowns.size() - 1] : knownEquilibrium;
  for (std::size_t i = 0; i < times.size(); ++i)
    if (unknowns[static_cast<Eigen::Index>(i)] > 0)
      series.arms.push_back({unknowns[static_cast<Eigen::Index>(i)], times[i]});
  for (const DynamicModulus& point : points) {
    const DynamicModulus fitted = modulusAt(series, point.frequency);
    series.rmsStorage += std::pow(fitted.storage / point.storage - 1, 2);
    series.rmsLoss += std::pow(fitted.loss / point.loss - 1, 2);
  }
  const auto count = static_cast<double>(points.size());
  series.rmsStorage = std::sqrt(series.rmsStorage / count);
  series.rmsLoss = std::sqrt(series.rmsLoss / count);
  return series;
}

double rmsResidual(const PronySeries& series) {
  return std::hypot(series.rmsStorage, series.rmsLoss) / std::numbers::sqrt2;
}

/// Returns the series with the fewest terms whose residual more terms would not reduce.
PronySeries fitWithFewest(std::span<const DynamicModulus> points, double decadesBelow,
                          double knownEquilibrium, const std::stop_token& stop) {
  const double decades =
      std::log10(points.back().frequency / points.front().frequency) + kBeyond + decadesBelow;
  const int most = std::clamp(static_cast<int>(std::ceil(kTermsPerDecade * decades)) + 1, 2,
                              std::min(kMaxTerms, static_cast<int>(points.size())));
  std::vector<PronySeries> fits;
  // One more term makes little difference to many.
  constexpr int kMany = 24, kStep = 4;
  for (int terms = 1; terms <= most; terms += terms < kMany ? 1 : kStep) {
    throwIfStopped(stop);
    fits.push_back(fitWith(points, terms, decadesBelow, knownEquilibrium));
  }
  double floor = rmsResidual(fits.front());
  for (const PronySeries& fit : fits) floor = std::min(floor, rmsResidual(fit));
  const double enough = std::max(kNearFloor * floor, kGoodEnough);
  return *std::ranges::find_if(fits,
                               [&](const PronySeries& fit) { return rmsResidual(fit) <= enough; });
}

/// Returns the series with the fewest terms. Where the loss modulus rises almost as that of a
/// dashpot and the storage modulus does not follow, only times far below the measured range give
/// the one without the other.
PronySeries fitWithFewest(std::span<const DynamicModulus> points, double knownEquilibrium,
                          const std::stop_token& stop) {
  const PronySeries usual = fitWithFewest(points, kBeyond, knownEquilibrium, stop);
  if (!(rmsResidual(usual) > kPoor)) return usual;
  const PronySeries wider = fitWithFewest(points, kFarBeyond, knownEquilibrium, stop);
  return rmsResidual(wider) < kMuchBetter * rmsResidual(usual) ? wider : usual;
}

/// Returns whether the moduli tell the equilibrium modulus of a fit from 0: it is a visible part of
/// the smallest storage modulus, or the fit without it is clearly worse.
bool isEquilibriumClear(std::span<const DynamicModulus> points, const PronySeries& series,
                        double smallestStorage) {
  constexpr double kVisiblePart = 0.1, kClear = 3;  // standard errors
  if (series.equilibriumModulus > kVisiblePart * smallestStorage) return true;
  const auto values = 2 * static_cast<double>(points.size());
  const auto squares = [values](const PronySeries& fit) {
    return values * std::pow(rmsResidual(fit), 2);
  };
  const double degreesOfFreedom =
      std::max(1.0, values - static_cast<double>(series.arms.size() + 1));
  const double least = squares(series);
  return squares(fitWith(points, series.terms, series.decadesBelow, 0)) - least >
         kClear * kClear * least / degreesOfFreedom;
}

}  // namespace

DynamicModulus modulusAt(const PronySeries& series, double frequency) {
  ElementLaw law;
  law.equilibriumModulus = series.equilibriumModulus;
  law.arms = series.arms;
  const ComplexModulus modulus = complexModulus(law, angular(frequency));
  return {frequency, modulus.storage, modulus.loss};
}

PronySeries fitPronySeries(std::span<const DynamicModulus> given, const PronyOptions& options) {
  std::vector<DynamicModulus> points(given.begin(), given.end());
  std::ranges::stable_sort(points, {}, &DynamicModulus::frequency);
  if (points.size() < 2 || !(points.back().frequency > points.front().frequency))
    throw InputError("", "frequency", "has one value alone; a series needs a range of frequencies");
  const auto most = static_cast<int>(std::min<std::size_t>(kMaxTerms, 2 * points.size() - 1));
  if (options.terms < 0 || options.terms > most)
    throw InputError("", "--terms",
                     message("{} is outside 1 to {}, what {} points can tell", options.terms, most,
                             points.size()));
  const double known = options.isLiquid ? 0 : options.equilibriumModulus;
  const double smallest = std::ranges::min(points, {}, &DynamicModulus::storage).storage;
  // G' rises with frequency from G_inf on, and scatter of the measurements adds far less than the
  // tolerance.
  if (std::isfinite(known) && known > smallest * kMaxOfSmallest)
    throw InputError("", "--equilibrium-modulus",
                     message("{} is above the lowest storage modulus of shear, {}; allowed is a "
                             "modulus below it",
                             printed(known, "Pa"), printed(smallest, "Pa")));
  PronySeries series = options.terms > 0 ? fitWith(points, options.terms, kBeyond, known)
                                         : fitWithFewest(points, known, options.stop);
  if (!options.isLiquid && !(series.equilibriumModulus > kNothing * smallest))
    throw InputError(
        "", "equilibrium modulus",
        message("is 0 in the fit: down to {:.3g} Hz the storage modulus still falls as "
                "that of a liquid, which cannot carry a load for ever; measure at lower "
                "frequencies or higher temperatures, give --equilibrium-modulus, or "
                "allow it with --liquid",
                points.front().frequency));
  if (!options.isLiquid && std::isnan(known) && !isEquilibriumClear(points, series, smallest))
    throw InputError(
        "", "equilibrium modulus",
        message("is {} in the fit, where the smallest storage modulus is {}, and cannot be told "
                "from 0: a liquid fits as well, which cannot carry a load for ever; measure at "
                "lower frequencies or higher temperatures, give --equilibrium-modulus, or allow "
                "it with --liquid",
                printed(series.equilibriumModulus, "Pa", 3), printed(smallest, "Pa", 3)));
  return series;
}

}  // namespace asperity
