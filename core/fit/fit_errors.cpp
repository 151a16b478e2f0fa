#include "core/fit/fit_errors.h"

#include <algorithm>
#include <cmath>
#include <iterator>
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

/// Returns the factor by which an error from a scatter is larger than this scatter, because few
/// values know it badly: two such errors hold as often as two of a known one (Student).
double factorOfFew(double degreesOfFreedom) {
  constexpr double kErrors = 2;
  return std::isfinite(degreesOfFreedom) ? studentDeviations(kErrors, degreesOfFreedom) / kErrors
                                         : 1;
}

/// Returns the least degrees of freedom of the scatter of the lines at a point; infinite where
/// there is one line.
double freedomOfLines(const FrictionWithDerivatives& found) {
  double degreesOfFreedom = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < found.muOfLines.size(); ++i)
    if (found.muOfLines[i].size() > 1)
      degreesOfFreedom =
          std::min(degreesOfFreedom,
                   lineMeanError(found.muOfLines[i], found.orderedRows[i]).degreesOfFreedom);
  return degreesOfFreedom;
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
  if (hasErrors) return;
  errors.errorScale = errors.relativeScatter = std::sqrt(errors.chiSquared / degreesOfFreedom);
  errors.fewPointsFactor = factorOfFew(degreesOfFreedom);
}

/// Returns the factor from the errors of the points, or from 100 %, to those that the errors of the
/// values come from.
double pointScale(const FitErrors& errors) {
  return errors.errorScale * errors.fewPointsFactor;
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
  const VectorXd ofPoints = std::pow(pointScale(errors), 2) * weights.cwiseInverse();
  const MatrixXd byPoints = response * ofPoints.asDiagonal() * response.transpose();
  const double fewLines = factorOfFew(freedomOfLines(found));
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

namespace {

using Eigen::VectorXd;

/// Returns how many standard errors a parabola of the sum of squares would be away from its least
/// value to reach that of a point.
double errorsAbove(const Minimum& point, const FitErrors& errors) {
  return std::sqrt(std::max(0.0, point.chiSquared - errors.chiSquared)) / pointScale(errors);
}

VectorXd withinLimits(const Objective& objective, VectorXd coordinates) {
  for (const int j : objective.all()) {
    const VariedParameter& parameter = objective.parameter(j);
    coordinates[j] = std::clamp(coordinates[j], parameter.lowest(), parameter.highest());
  }
  return coordinates;
}

/// Holds one parameter at values on one side of the best one, and minimizes over the others. They
/// begin where the covariance predicts, further out where the last two points lead, so that they
/// follow a curved valley. Where the sum of squares has not risen by one standard error after
/// three of them, the walk goes on with longer steps.
std::vector<Minimum> profileToOneSide(const Objective& objective, int k, int sign,
                                      const Minimum& best, const FitErrors& errors) {
  constexpr int kFewIterations = 4;
  const VariedParameter& parameter = objective.parameter(k);
  const double error = std::sqrt(errors.covariance(k, k));
  const double reach = std::min(error, 2 * largestDeterminedError(parameter));
  std::vector<int> others = objective.all();
  others.erase(others.begin() + k);
  std::vector<Minimum> points;
  VectorXd last = best.coordinates;
  VectorXd perReach = errors.covariance.col(k) * reach / errors.covariance(k, k);
  double place = 0;
  for (const double reaches : {1, 2, 3, 6, 12}) {
    if (reaches > 3 && (reach < error || errorsAbove(points.back(), errors) > 1)) break;
    VectorXd start = withinLimits(objective, last + sign * (reaches - place) * perReach);
    start[k] = best.coordinates[k] + sign * reaches * reach;
    if (start[k] < parameter.lowest() || start[k] > parameter.highest()) break;
    points.push_back(others.empty() ? atCoordinates(objective, start)
                                    : minimize(objective, start, others, kFewIterations));
    perReach = sign * (points.back().coordinates - last) / (reaches - place);
    last = points.back().coordinates;
    place = reaches;
  }
  return points;
}

}  // namespace

FitProfiles fitProfiles(const Objective& objective, const Minimum& best, const FitErrors& errors) {
  FitProfiles profiles;
  for (const int k : objective.all()) {
    std::vector<Minimum> points = profileToOneSide(objective, k, -1, best, errors);
    std::ranges::reverse(points);
    points.push_back(best);
    std::ranges::move(profileToOneSide(objective, k, 1, best, errors), std::back_inserter(points));
    profiles.push_back(std::move(points));
  }
  return profiles;
}

const Minimum& lowestPoint(const FitProfiles& profiles, const Minimum& best) {
  const Minimum* lowest = &best;
  for (const std::vector<Minimum>& profile : profiles)
    for (const Minimum& point : profile)
      if (point.chiSquared < lowest->chiSquared) lowest = &point;
  return *lowest;
}

std::pair<double, double> profileReach(const FitProfiles& profiles, const FitErrors& errors,
                                       Eigen::Index coordinate, double best) {
  double below = 0, above = 0;
  const auto take = [&](double place) {
    below = std::max(below, best - place);
    above = std::max(above, place - best);
  };
  for (const std::vector<Minimum>& profile : profiles)
    for (std::size_t i = 0; i < profile.size(); ++i) {
      const double height = errorsAbove(profile[i], errors);
      const double place = profile[i].coordinates[coordinate];
      if (height <= 1) take(place);
      if (i == 0) continue;
      const double before = errorsAbove(profile[i - 1], errors);
      if ((height > 1) != (before > 1))
        take(std::lerp(profile[i - 1].coordinates[coordinate], place,
                       (1 - before) / (height - before)));
    }
  return {below, above};
}

double negligibleDecrease(const FitErrors& errors) {
  return 0.1 * errors.errorScale * errors.errorScale;
}

}  // namespace asperity
