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
    fit_.hasConverged = best.hasConverged;
    fit_.chiSquared = best.chiSquared;
    fit_.scene = objective_.sceneAt(best.coordinates);
    setErrors(best.coordinates);
    setParameters(best.coordinates);
    setCombinations();
    if (options_.hasProfiles) setProfiles(best);
    fit_.evaluations = objective_.evaluations();
    addNotes();
    return std::move(fit_);
  }

 private:
  static constexpr int kIterations = 60;
  /// A fit that is further from the points in the logarithm than a factor of two has not found
  /// them.
  static constexpr double kFar = std::numbers::ln2;
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

  void setErrors(const VectorXd& coordinates) {
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
    covariance_ = response * ofPoints.asDiagonal() * response.transpose() +
                  ofLines * ofLines.transpose() + information.openCovariance();
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
      found.standardError = std::sqrt(covariance_(k, k));
      found.low = parameter.value(coordinates[k] - found.standardError);
      found.high = parameter.value(coordinates[k] + found.standardError);
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

  /// Holds one parameter at some values around the best one. The others begin where their
  /// covariance predicts, and are then minimized over.
  void setProfiles(const Minimum& best) {
    constexpr int kFewIterations = 4;
    for (std::size_t k = 0; k < parameters_.size(); ++k) {
      const auto index = static_cast<Eigen::Index>(k);
      const VariedParameter& parameter = parameters_[k];
      const double reach = std::min(fit_.parameters[k].standardError, 2 * openBeyond(parameter));
      std::vector<int> others = all_;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
      ObjectiveProfile profile{std::string(parameter.key()), {}, {}};
      for (const double steps : {-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0}) {
        const double there = best.coordinates[index] + steps * reach;
        if (there < parameter.lowest() || there > parameter.highest()) continue;
        Minimum held = best;
        if (steps != 0) {
          VectorXd start = best.coordinates +
                           covariance_.col(index) * (steps * reach) / covariance_(index, index);
          for (std::size_t j = 0; j < parameters_.size(); ++j) {
            const auto other = static_cast<Eigen::Index>(j);
            start[other] =
                std::clamp(start[other], parameters_[j].lowest(), parameters_[j].highest());
          }
          start[index] = there;
          held = others.empty() ? atCoordinates(start)
                                : minimize(objective_, start, others, kFewIterations);
        }
        profile.values.push_back(parameter.value(there));
        profile.chiSquared.push_back(held.chiSquared);
      }
      fit_.profiles.push_back(std::move(profile));
    }
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
      if (parameter.isAtLimit)
        fit_.notes.push_back(
            message("{} ends at its limit; the best value may lie beyond", parameter.key));
    }
    for (const ObjectiveProfile& profile : fit_.profiles) {
      // Of chi squared, whose rise by 1 is one standard error.
      constexpr double kLower = 0.1;
      const auto lowest = std::ranges::min_element(profile.chiSquared);
      if (!(*lowest < fit_.chiSquared - kLower)) continue;
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
  MatrixXd covariance_;  // of the coordinates
  Fit fit_;
};

}  // namespace

Fit fitFriction(const Scene& scene, std::span<const FrictionData> data,
                std::span<const VariedParameter> parameters, const FitOptions& options) {
  return Fitting(scene, data, parameters, options).run();
}

}  // namespace asperity
