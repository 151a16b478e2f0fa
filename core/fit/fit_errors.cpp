#include "core/fit/fit_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/linear_algebra.h"
#include "core/base/statistics.h"

namespace asperity {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Returns a square root of the covariance of the mean over the lines, which all points share,
/// [point][line]: the covariance is the root times its transpose. For rows of a topography the
/// points correlate as for lines, and each point has the error of rows in order.
MatrixXd scatterOfLines(const FrictionWithDerivatives& found) {
  const auto n = static_cast<Eigen::Index>(found.muOfLines.size());
  std::size_t lines = found.muOfLines.front().size();
  for (const std::vector<double>& mu : found.muOfLines) lines = std::min(lines, mu.size());
  if (lines < 2) return MatrixXd::Zero(n, 1);
  MatrixXd about(n, static_cast<Eigen::Index>(lines));
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::vector<double>& mu = found.muOfLines[static_cast<std::size_t>(i)];
    const double average = mean(mu);
    for (std::size_t line = 0; line < lines; ++line)
      about(i, static_cast<Eigen::Index>(line)) = mu[line] - average;
  }
  about /= std::sqrt(static_cast<double>(lines) * static_cast<double>(lines - 1));
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto point = static_cast<std::size_t>(i);
    const double independent = about.row(i).norm();
    if (found.orderedRows[point] > 0 && independent > 0)
      about.row(i) *=
          lineMeanError(found.muOfLines[point], found.orderedRows[point]).standardError /
          independent;
  }
  return about;
}

/// Returns the factor by which an error from the scatter of the lines is larger than this scatter,
/// because few lines know it badly: two such errors hold as often as two of a known one (Student).
double factorOfFewLines(const FrictionWithDerivatives& found) {
  constexpr double kErrors = 2;
  double degreesOfFreedom = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < found.muOfLines.size(); ++i)
    if (found.muOfLines[i].size() > 1)
      degreesOfFreedom =
          std::min(degreesOfFreedom,
                   lineMeanError(found.muOfLines[i], found.orderedRows[i]).degreesOfFreedom);
  return std::isfinite(degreesOfFreedom) ? studentDeviations(kErrors, degreesOfFreedom) / kErrors
                                         : 1;
}

/// The Fisher information of the points about the parameters, a symmetric matrix, by its principal
/// directions.
class Information {
 public:
  explicit Information(const MatrixXd& matrix) : directions_(principalAxes(matrix)) {}

  /// Returns the inverse; directions without information get a very large value instead of an
  /// infinite one.
  MatrixXd inverse() const {
    constexpr double kNothing = 1e-15;
    const VectorXd known = directions_.values.cwiseMax(least(kNothing));
    return directions_.axes * known.cwiseInverse().asDiagonal() * directions_.axes.transpose();
  }

  /// Returns the covariance of the directions without information, such as force and modulus
  /// together, of which only the ratio matters. Along them the response to the points' errors is 0,
  /// but the values may be anything.
  MatrixXd openCovariance() const {
    constexpr double kOpen = 1e-10;
    const MatrixXd& axes = directions_.axes;
    MatrixXd open = MatrixXd::Zero(axes.rows(), axes.cols());
    for (Eigen::Index k = 0; k < axes.cols(); ++k)
      if (directions_.values[k] < least(kOpen))
        open += axes.col(k) * axes.col(k).transpose() / least(kOpen);
    return open;
  }

 private:
  /// Returns the information below which a direction counts as unknown: this share of the best
  /// known one, and never 0.
  double least(double share) const {
    return std::max(share * directions_.values.maxCoeff(),
                    std::numeric_limits<double>::min() * 1e10);
  }

  PrincipalAxes directions_;
};

/// Scales the errors of the points if they do not hold: if chi squared is more than three of its
/// standard deviations above its mean. A fit leaves the degrees of freedom of the points' errors,
/// and that part of the lines' scatter which no parameter follows. Errors that do not hold, and
/// the 100 % that replace missing ones, are scaled to the residuals. left: the remaining part of
/// the lines' scatter, over the points' errors.
void compareWithErrors(const MatrixXd& left, const Objective& objective, FitErrors& errors) {
  const auto degreesOfFreedom = static_cast<double>(objective.degreesOfFreedom());
  const bool hasErrors = objective.hasErrors();
  const double ofLines = left.squaredNorm();
  const double variance =
      2 * (degreesOfFreedom + 2 * ofLines + (left.transpose() * left).squaredNorm());
  errors.missesPoints =
      hasErrors && errors.chiSquared > degreesOfFreedom + ofLines + 3 * std::sqrt(variance);
  if (errors.missesPoints)
    errors.errorScale = std::sqrt((errors.chiSquared - ofLines) / degreesOfFreedom);
  if (!hasErrors)
    errors.errorScale = errors.relativeScatter = std::sqrt(errors.chiSquared / degreesOfFreedom);
}

}  // namespace

FitErrors fitErrors(const Objective& objective, const Minimum& best) {
  FitErrors errors;
  errors.chiSquared = best.chiSquared;
  const FrictionWithDerivatives found = objective.evaluate(best.coordinates, objective.all());
  errors.hasFoundPoints = objective.logarithmicDistance(found) < kFarFromPoints;
  const auto n = static_cast<Eigen::Index>(objective.size());
  const auto count = best.coordinates.size();
  MatrixXd slopes(n, count);
  VectorXd weights(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto point = static_cast<std::size_t>(i);
    const double deviation = objective.deviation(point);
    weights[i] = 1 / (deviation * deviation);
    for (Eigen::Index k = 0; k < count; ++k)
      slopes(i, k) = mean(found.slopesOfLines[static_cast<std::size_t>(k)][point]);
  }
  const MatrixXd lines = scatterOfLines(found);
  const Information information(slopes.transpose() * weights.asDiagonal() * slopes);
  const MatrixXd response = information.inverse() * slopes.transpose() * weights.asDiagonal();
  const MatrixXd ofLines = response * lines;
  compareWithErrors(weights.cwiseSqrt().asDiagonal() * (lines - slopes * ofLines), objective,
                    errors);
  const VectorXd ofPoints = errors.errorScale * errors.errorScale * weights.cwiseInverse();
  const MatrixXd byPoints = response * ofPoints.asDiagonal() * response.transpose();
  const double fewLines = factorOfFewLines(found);
  const MatrixXd byLines = fewLines * fewLines * ofLines * ofLines.transpose();
  errors.covariance = byPoints + byLines + information.openCovariance();
  errors.isByLines = (byLines.diagonal().array() > byPoints.diagonal().array()).any();
  errors.computed = found.points;
  for (Eigen::Index i = 0; i < n; ++i) {
    errors.computedErrors.push_back(lines.row(i).norm());
    const double variance = slopes.row(i) * errors.covariance * slopes.row(i).transpose();
    errors.bandErrors.push_back(std::sqrt(std::max(0.0, variance)));
  }
  return errors;
}

double largestDeterminedError(const VariedParameter& parameter) {
  if (parameter.isLogarithmic()) return std::log(2.0);
  const SliderRange slider = *sliderRange(parameter.row());
  return (slider.to - slider.from) / 4;
}

}  // namespace asperity
