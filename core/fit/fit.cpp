#include "core/fit/fit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/statistics.h"
#include "core/fit/fit_objective.h"

namespace asperity {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Returns a square root of the covariance of the mean over the lines, which all points share,
/// [point][line]: the covariance is the root times its transpose. Rows of a topography have the
/// correlation between points that lines have, and for each point the error of rows in order.
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

/// The Fisher information of the points about the parameters, a symmetric matrix, by its principal
/// directions.
class Information {
 public:
  explicit Information(const MatrixXd& matrix) : directions_(matrix) {}

  /// Returns the inverse; directions without information get a very large value instead of an
  /// infinite one.
  MatrixXd inverse() const {
    constexpr double kNothing = 1e-15;
    const VectorXd known = directions_.eigenvalues().cwiseMax(least(kNothing));
    return directions_.eigenvectors() * known.cwiseInverse().asDiagonal() *
           directions_.eigenvectors().transpose();
  }

  /// Returns the covariance of the directions without information, such as force and modulus
  /// together, of which only the ratio matters. Along them the response to the points' errors is 0,
  /// but the values may be anything.
  MatrixXd openCovariance() const {
    constexpr double kOpen = 1e-10;
    const MatrixXd& axes = directions_.eigenvectors();
    MatrixXd open = MatrixXd::Zero(axes.rows(), axes.cols());
    for (Eigen::Index k = 0; k < axes.cols(); ++k)
      if (directions_.eigenvalues()[k] < least(kOpen))
        open += axes.col(k) * axes.col(k).transpose() / least(kOpen);
    return open;
  }

 private:
  /// Returns the information below which a direction counts as unknown: this share of the best
  /// known one, and never 0.
  double least(double share) const {
    return std::max(share * directions_.eigenvalues().maxCoeff(),
                    std::numeric_limits<double>::min() * 1e10);
  }

  Eigen::SelfAdjointEigenSolver<MatrixXd> directions_;
};

/// Returns the error of a coordinate beyond which a parameter counts as not determined.
double openBeyond(const VariedParameter& parameter) {
  if (parameter.isLogarithmic()) return std::log(2.0);
  const auto& field = std::get<RealField>(parameter.row().field);
  return (field.sliderTo - field.sliderFrom) / 4;
}

class Fitting {
 public:
  Fitting(const Scene& scene, std::span<const FrictionData> data,
          std::span<const VariedParameter> parameters, const FitOptions& options)
      : data_(data),
        parameters_(parameters),
        options_(options),
        objective_(scene, data, parameters, options),
        hasErrors_(std::ranges::any_of(data, &FrictionData::hasErrors)),
        all_(parameters.size()) {
    std::iota(all_.begin(), all_.end(), 0);
    start_.resize(static_cast<Eigen::Index>(parameters.size()));
    for (std::size_t k = 0; k < parameters.size(); ++k)
      start_[static_cast<Eigen::Index>(k)] = parameters[k].coordinate(parameters[k].valueIn(scene));
    const auto points = static_cast<std::int64_t>(objective_.size());
    const auto count = static_cast<std::int64_t>(parameters.size());
    if (count == 0) throw InputError("", "--vary", "no parameter is named");
    if (points <= count)
      throw InputError("", "--data",
                       message("{} points do not determine {} parameters; more points than "
                               "parameters are needed",
                               points, count));
    fit_.freedom = points - count;
    refuseMissingErrors();
  }

  Fit run() {
    objective_.addVelocityErrors(start_);
    Minimum best = minimize(objective_, nearer(start_), all_, kIterations);
    if (isFarOff(best)) best = fromOtherStarts(best);
    if (objective_.hasVelocityErrors()) {
      objective_.addVelocityErrors(best.coordinates);
      best = minimize(objective_, best.coordinates, all_, kIterations);
    }
    setErrors(best);
    if (options_.hasProfiles) best = withProfiles(std::move(best));
    fit_.hasConverged = best.hasConverged;
    fit_.scene = objective_.sceneAt(best.coordinates);
    setParameters(best.coordinates);
    setCombinations();
    stateProfiles();
    fit_.evaluations = objective_.evaluations();
    addNotes();
    return std::move(fit_);
  }

 private:
  static constexpr int kIterations = 60;
  /// A fit that is further from the points in the logarithm than a factor of two has not found
  /// them.
  static constexpr double kFar = std::numbers::ln2;
  /// A range that its profile makes wider than the standard error by this factor is reported.
  static constexpr double kWider = 1.5;
  static constexpr double kInfinite = std::numeric_limits<double>::infinity();

  /// A table without errors has no weight beside a table with errors.
  void refuseMissingErrors() const {
    const auto with = std::ranges::find_if(data_, &FrictionData::hasErrors);
    const auto without = std::ranges::find_if_not(data_, &FrictionData::hasErrors);
    if (with != data_.end() && without != data_.end())
      throw InputError("", "--data",
                       message("{} has no errors of the coefficient of friction, and {} has; give "
                               "it a column mu_error, or leave the errors out of all tables",
                               Message::name(without->name), Message::name(with->name)));
  }

  /// Returns the coordinates from which the fit begins. Where friction is far from the measured
  /// values, a fit of logarithms comes first.
  VectorXd nearer(const VectorXd& start) const {
    const double distance = objective_.logarithmicDistance(objective_.evaluate(start, {}));
    if (distance < kFar || !std::isfinite(distance)) return start;
    return minimize(objective_, start, all_, kIterations, Distance::Logarithm).coordinates;
  }

  /// Returns whether a minimum leaves so much that another one may be the right one: chi squared
  /// far above the degrees of freedom, or without errors points that scatter by more than a tenth.
  bool isFarOff(const Minimum& found) const {
    constexpr double kFarAbove = 10, kScatter = 0.1;
    const double perFreedom = found.chiSquared / static_cast<double>(fit_.freedom);
    return perFreedom > (hasErrors_ ? kFarAbove : kScatter * kScatter);
  }

  /// Searches again from other coordinates. A parameter may have left the range in which friction
  /// answers to it, from where no slope leads back: so each one in turn is set to values over
  /// its slider's whole range, the others as found, and the search goes on from the best of them,
  /// as long as that helps.
  Minimum fromOtherStarts(Minimum best) const {
    constexpr int kRounds = 3;
    for (int round = 0; round < kRounds && isFarOff(best); ++round) {
      const double before = best.chiSquared;
      const VectorXd around = best.coordinates;
      for (std::size_t k = 0; k < parameters_.size(); ++k) {
        const Minimum start = bestAlong(k, around);
        if (!std::isfinite(start.chiSquared)) continue;
        try {
          Minimum found = minimize(objective_, start.coordinates, all_, kIterations);
          if (found.chiSquared < best.chiSquared) best = std::move(found);
        } catch (const InputError&) {
          // A start from which no state can slide leads nowhere.
        }
      }
      if (!(best.chiSquared < 0.99 * before)) break;
    }
    return best;
  }

  /// Returns the best of some values of one parameter over its plausible range, the others held.
  Minimum bestAlong(std::size_t k, const VectorXd& around) const {
    constexpr int kValues = 11;
    const VariedParameter& parameter = parameters_[k];
    const auto [from, to] = plausible(parameter);
    Minimum best{around, kInfinite, false};
    for (int i = 0; i < kValues; ++i) try {
        VectorXd coordinates = around;
        coordinates[static_cast<Eigen::Index>(k)] = from + (to - from) * i / (kValues - 1);
        const double chiSquared = atCoordinates(coordinates).chiSquared;
        if (chiSquared < best.chiSquared) best = {std::move(coordinates), chiSquared, false};
      } catch (const InputError&) {
        continue;  // a state that cannot slide
      }
    return best;
  }

  /// Returns the coordinates that a slider reaches, within the parameter's limits.
  static std::pair<double, double> plausible(const VariedParameter& parameter) {
    const auto& field = std::get<RealField>(parameter.row().field);
    // A logarithmic slider may begin at none, which has no coordinate.
    constexpr double kDecades = 1e-6;
    const double first = parameter.isLogarithmic()
                             ? std::max(field.sliderFrom, kDecades * field.sliderTo)
                             : field.sliderFrom;
    const auto within = [&](double value) {
      return std::clamp(parameter.coordinate(value), parameter.lowest(), parameter.highest());
    };
    return {within(first), within(field.sliderTo)};
  }

  /// Scales the errors of the points if they do not hold: if chi squared is more than three of its
  /// standard deviations above its mean. A fit leaves the degrees of freedom of the points' errors,
  /// and that part of the lines' scatter which no parameter follows. Errors that do not hold, and
  /// the 100 % that replace missing ones, are scaled to the residuals. left: the remaining part of
  /// the lines' scatter, over the points' errors.
  void compareWithErrors(const MatrixXd& left) {
    const auto freedom = static_cast<double>(fit_.freedom);
    const double ofLines = left.squaredNorm();
    const double variance = 2 * (freedom + 2 * ofLines + (left.transpose() * left).squaredNorm());
    fit_.missesPoints = hasErrors_ && fit_.chiSquared > freedom + ofLines + 3 * std::sqrt(variance);
    if (fit_.missesPoints) fit_.errorScale = std::sqrt((fit_.chiSquared - ofLines) / freedom);
    if (!hasErrors_) fit_.errorScale = fit_.relativeScatter = std::sqrt(fit_.chiSquared / freedom);
  }

  void setErrors(const Minimum& best) {
    const VectorXd& coordinates = best.coordinates;
    fit_.chiSquared = best.chiSquared;
    fit_.computedErrors.clear();
    fit_.bandErrors.clear();
    const FrictionWithDerivatives found = objective_.evaluate(coordinates, all_);
    fit_.hasFoundPoints = objective_.logarithmicDistance(found) < kFar;
    const auto n = static_cast<Eigen::Index>(objective_.size());
    const auto count = static_cast<Eigen::Index>(parameters_.size());
    MatrixXd slopes(n, count);
    VectorXd weights(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto point = static_cast<std::size_t>(i);
      const double deviation = objective_.deviation(point);
      weights[i] = 1 / (deviation * deviation);
      for (Eigen::Index k = 0; k < count; ++k)
        slopes(i, k) = mean(found.slopesOfLines[static_cast<std::size_t>(k)][point]);
    }
    const MatrixXd lines = scatterOfLines(found);
    const Information information(slopes.transpose() * weights.asDiagonal() * slopes);
    const MatrixXd response = information.inverse() * slopes.transpose() * weights.asDiagonal();
    const MatrixXd ofLines = response * lines;
    compareWithErrors(weights.cwiseSqrt().asDiagonal() * (lines - slopes * ofLines));
    const VectorXd ofPoints = fit_.errorScale * fit_.errorScale * weights.cwiseInverse();
    const MatrixXd byPoints = response * ofPoints.asDiagonal() * response.transpose();
    const MatrixXd byLines = ofLines * ofLines.transpose();
    covariance_ = byPoints + byLines + information.openCovariance();
    isByLines_ = (byLines.diagonal().array() > byPoints.diagonal().array()).any();
    fit_.computed = found.points;
    for (Eigen::Index i = 0; i < n; ++i) {
      fit_.computedErrors.push_back(lines.row(i).norm());
      const double variance = slopes.row(i) * covariance_ * slopes.row(i).transpose();
      fit_.bandErrors.push_back(std::sqrt(std::max(0.0, variance)));
    }
  }

  void setParameters(const VectorXd& coordinates) {
    const auto count = static_cast<Eigen::Index>(parameters_.size());
    fit_.correlation = MatrixXd::Identity(count, count);
    for (Eigen::Index k = 0; k < count; ++k) {
      const VariedParameter& parameter = parameters_[static_cast<std::size_t>(k)];
      FittedParameter found;
      found.key = parameter.key();
      found.isLogarithmic = parameter.isLogarithmic();
      found.value = parameter.value(coordinates[k]);
      const double error = std::sqrt(covariance_(k, k));
      const auto [below, above] = reachOfProfiles(k, coordinates[k]);
      const double low = std::max(error, below), high = std::max(error, above);
      found.isWidened = low > kWider * error || high > kWider * error;
      found.standardError = (low + high) / 2;
      found.low = parameter.value(coordinates[k] - low);
      found.high = parameter.value(coordinates[k] + high);
      const double near = 1e-6 * (parameter.highest() - parameter.lowest());
      found.isAtLimit =
          coordinates[k] - parameter.lowest() < near || parameter.highest() - coordinates[k] < near;
      found.isDetermined = found.standardError <= openBeyond(parameter);
      fit_.parameters.push_back(found);
      for (Eigen::Index j = 0; j < count; ++j)
        if (j != k)
          fit_.correlation(k, j) =
              covariance_(k, j) / std::sqrt(covariance_(k, k) * covariance_(j, j));
    }
  }

  /// Returns how far below and above the best value of a coordinate the profiles of all parameters
  /// come before the sum of squares has risen by one standard error; 0 without profiles.
  std::pair<double, double> reachOfProfiles(Eigen::Index coordinate, double best) const {
    double below = 0, above = 0;
    const auto take = [&](double place) {
      below = std::max(below, best - place);
      above = std::max(above, place - best);
    };
    for (const std::vector<Minimum>& profile : profiles_)
      for (std::size_t i = 0; i < profile.size(); ++i) {
        const double errors = errorsAbove(profile[i]), place = profile[i].coordinates[coordinate];
        if (errors <= 1) take(place);
        if (i == 0) continue;
        const double before = errorsAbove(profile[i - 1]);
        if ((errors > 1) != (before > 1))
          take(std::lerp(profile[i - 1].coordinates[coordinate], place,
                         (1 - before) / (errors - before)));
      }
    return {below, above};
  }

  /// Returns how many standard errors a parabola of the sum of squares would be away from its least
  /// value to reach that of a point.
  double errorsAbove(const Minimum& point) const {
    return std::sqrt(std::max(0.0, point.chiSquared - fit_.chiSquared)) / fit_.errorScale;
  }

  /// Finds the principal axes of the error ellipsoid.
  void setCombinations() {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(covariance_);
    for (Eigen::Index k = 0; k < covariance_.rows(); ++k) {
      VectorXd axis = solver.eigenvectors().col(k);
      Eigen::Index largest = 0;
      axis.cwiseAbs().maxCoeff(&largest);
      axis /= axis[largest];
      const double variance = axis.dot(covariance_ * axis);
      fit_.combinations.push_back({{axis.begin(), axis.end()}, std::sqrt(std::max(0.0, variance))});
    }
  }

  /// Returns the minimum after its profiles are set. Where a point of a profile lies lower, the
  /// minimum was a hollow of a valley, and the search goes on from that point.
  Minimum withProfiles(Minimum best) {
    constexpr int kRestarts = 4;
    for (int restart = 0;; ++restart) {
      const Minimum lowest = setProfiles(best);
      if (lowest.chiSquared >= best.chiSquared - worthAStep() || restart == kRestarts) return best;
      Minimum found = minimize(objective_, lowest.coordinates, all_, kIterations);
      best = found.chiSquared < lowest.chiSquared ? std::move(found) : lowest;
      setErrors(best);
    }
  }

  /// Returns the decrease of the sum of squares below which a lower point changes the parameters
  /// by less than a third of their errors.
  double worthAStep() const { return 0.1 * fit_.errorScale * fit_.errorScale; }

  /// Sets the profiles around a minimum, and returns the lowest of their points.
  Minimum setProfiles(const Minimum& best) {
    profiles_.clear();
    Minimum lowest = best;
    for (const int k : all_) {
      std::vector<Minimum> points = profileToOneSide(k, -1, best);
      std::ranges::reverse(points);
      points.push_back(best);
      for (Minimum& point : profileToOneSide(k, 1, best)) points.push_back(std::move(point));
      for (const Minimum& point : points)
        if (point.chiSquared < lowest.chiSquared) lowest = point;
      profiles_.push_back(std::move(points));
    }
    return lowest;
  }

  /// States the profiles of the final minimum by the values of their parameters.
  void stateProfiles() {
    for (std::size_t k = 0; k < profiles_.size(); ++k) {
      const VariedParameter& parameter = parameters_[k];
      ObjectiveProfile& profile = fit_.profiles.emplace_back();
      profile.key = parameter.key();
      for (const Minimum& point : profiles_[k]) {
        profile.values.push_back(parameter.value(point.coordinates[static_cast<Eigen::Index>(k)]));
        profile.chiSquared.push_back(point.chiSquared);
      }
    }
  }

  /// Holds one parameter at values on one side of the best one, and minimizes over the others. They
  /// begin where the covariance predicts, further out where the last two points lead, so that they
  /// follow a curved valley. Where the sum of squares has not risen by one standard error after
  /// three of them, the walk goes on with longer steps.
  std::vector<Minimum> profileToOneSide(int k, int sign, const Minimum& best) const {
    constexpr int kFewIterations = 4;
    const VariedParameter& parameter = parameters_[static_cast<std::size_t>(k)];
    const double error = std::sqrt(covariance_(k, k));
    const double reach = std::min(error, 2 * openBeyond(parameter));
    std::vector<int> others = all_;
    others.erase(others.begin() + k);
    std::vector<Minimum> points;
    VectorXd last = best.coordinates;
    VectorXd perReach = covariance_.col(k) * reach / covariance_(k, k);
    double place = 0;
    for (const double reaches : {1, 2, 3, 6, 12}) {
      if (reaches > 3 && (reach < error || errorsAbove(points.back()) > 1)) break;
      VectorXd start = withinLimits(last + sign * (reaches - place) * perReach);
      start[k] = best.coordinates[k] + sign * reaches * reach;
      if (start[k] < parameter.lowest() || start[k] > parameter.highest()) break;
      points.push_back(others.empty() ? atCoordinates(start)
                                      : minimize(objective_, start, others, kFewIterations));
      perReach = sign * (points.back().coordinates - last) / (reaches - place);
      last = points.back().coordinates;
      place = reaches;
    }
    return points;
  }

  VectorXd withinLimits(VectorXd coordinates) const {
    for (const int j : all_) {
      const VariedParameter& parameter = parameters_[static_cast<std::size_t>(j)];
      coordinates[j] = std::clamp(coordinates[j], parameter.lowest(), parameter.highest());
    }
    return coordinates;
  }

  Minimum atCoordinates(const VectorXd& coordinates) const {
    return {coordinates, objective_.chiSquared(objective_.evaluate(coordinates, {})), true};
  }

  void addNotes() {
    if (!fit_.hasFoundPoints)
      fit_.notes.emplace_back(
          "the fit has not found the points: computed and measured friction differ by more than a "
          "factor of two on average, and the values and their errors say nothing; begin from other "
          "values, or vary further ones");
    else if (fit_.missesPoints)
      fit_.notes.push_back(
          message("the points lie further from the curve than their errors say: chi squared is "
                  "{:.3g} for {} degrees of freedom; the errors of the values are computed from "
                  "errors of the points that are {:.2g} times as large",
                  fit_.chiSquared, fit_.freedom, fit_.errorScale));
    // These notes tell how the tables were understood.
    for (const FrictionData& table : data_)
      for (const Message& note : table.notes)
        fit_.notes.push_back(message("{}: {}", Message::name(table.name), note));
    if (shiftsByGeneralConstants())
      fit_.notes.push_back(message(
          "times are shifted to the temperatures of the points by the general WLF constants, C1 = "
          "{} and C2 = {} K, which the scene does not replace by those of its rubber",
          TemperatureShift{}.c1, TemperatureShift{}.c2));
    for (const FittedParameter& parameter : fit_.parameters) {
      if (fit_.hasFoundPoints && !parameter.isDetermined)
        fit_.notes.push_back(message(
            "{} is not determined by these data: its standard error is {:.2g} in {}", parameter.key,
            parameter.standardError, parameter.isLogarithmic ? "ln" : "its unit"));
      if (fit_.hasFoundPoints && parameter.isWidened)
        fit_.notes.push_back(
            message("the sum of squares is no parabola along {}: its range is where the profile "
                    "rises by one standard error, and the standard error is half of that range",
                    parameter.key));
      if (parameter.isAtLimit)
        fit_.notes.push_back(
            message("{} ends at its limit; the best value may lie beyond", parameter.key));
    }
    constexpr std::int64_t kFewLines = 50;
    const std::int64_t lines = fit_.computed.front().realizations;
    if (fit_.hasFoundPoints && isByLines_ && lines < kFewLines)
      fit_.notes.push_back(message(
          "the spread of the {} random lines is a larger part of the errors than the points "
          "are, and so few lines estimate it poorly: the true values may be two or three standard "
          "errors away; more lines (ensemble.realizations) make the errors smaller and better "
          "known",
          lines));
    for (const ObjectiveProfile& profile : fit_.profiles) {
      const auto lowest = std::ranges::min_element(profile.chiSquared);
      if (!(*lowest < fit_.chiSquared - worthAStep())) continue;
      const auto at = static_cast<std::size_t>(lowest - profile.chiSquared.begin());
      fit_.notes.push_back(
          message("the sum of squares is lower at {} = {:.3g}, by {:.2g}: the fit has not reached "
                  "its minimum; begin again from that value",
                  profile.key, profile.values[at], fit_.chiSquared - *lowest));
    }
    if (!fit_.hasConverged)
      fit_.notes.emplace_back("the fit ended before the sum of squares stopped falling");
  }

  /// Returns whether points are shifted in temperature by constants that are only defaults.
  bool shiftsByGeneralConstants() const {
    const Elastomer& elastomer = fit_.scene.elastomer;
    const TemperatureShift &shift = elastomer.shift, general;
    if (elastomer.rheology == Rheology::Elastic || shift.kind != ShiftKind::Wlf ||
        shift.c1 != general.c1 || shift.c2 != general.c2)
      return false;
    for (std::size_t i = 0; i < objective_.size(); ++i) {
      const double temperature = objective_.point(i).temperature;
      if (!std::isnan(temperature) && temperature != shift.referenceTemperature) return true;
    }
    return false;
  }

  std::span<const FrictionData> data_;
  std::span<const VariedParameter> parameters_;
  const FitOptions& options_;
  Objective objective_;
  bool hasErrors_;
  std::vector<int> all_;
  VectorXd start_;
  MatrixXd covariance_;     // of the coordinates
  bool isByLines_ = false;  // the spread of the lines is the larger part of some variance in it
  std::vector<std::vector<Minimum>> profiles_;  // of each parameter, by its rising values
  Fit fit_;
};

}  // namespace

Fit fitFriction(const Scene& scene, std::span<const FrictionData> data,
                std::span<const VariedParameter> parameters, const FitOptions& options) {
  return Fitting(scene, data, parameters, options).run();
}

}  // namespace asperity
