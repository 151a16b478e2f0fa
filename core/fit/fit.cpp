#include "core/fit/fit.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/linear_algebra.h"
#include "core/base/number_text.h"
#include "core/fit/fit_errors.h"
#include "core/fit/fit_objective.h"
#include "core/scene/parameters.h"
#include "core/scene/scene_check.h"

namespace asperity {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Returns that so few lines, which are rows of the measured surface in some scenes, know their
/// spread badly.
Message fewLinesText(const Scene& scene, std::int64_t lines) {
  if (mayHaveRows(scene.surface))
    return message(
        "the spread of the {} rows of the surface is a larger part of the errors than the points "
        "are, and so few rows estimate it poorly: the true values may be two or three standard "
        "errors away; a larger piece of the surface makes the errors smaller and better known",
        lines);
  return message(
      "the spread of the {} random lines is a larger part of the errors than the points "
      "are, and so few lines estimate it poorly: the true values may be two or three standard "
      "errors away; more lines (ensemble.realizations) make the errors smaller and better "
      "known",
      lines);
}

class Fitting {
 public:
  Fitting(const Scene& scene, std::span<const FrictionData> data,
          std::span<const VariedParameter> parameters, const FitOptions& options)
      : data_(data),
        parameters_(parameters),
        options_(options),
        objective_(scene, data, parameters, options) {
    start_.resize(static_cast<Eigen::Index>(parameters.size()));
    for (std::size_t k = 0; k < parameters.size(); ++k)
      start_[static_cast<Eigen::Index>(k)] = parameters[k].coordinate(parameters[k].valueIn(scene));
    fit_.degreesOfFreedom = objective_.degreesOfFreedom();
    if (parameters.empty()) throw InputError("", "--vary", "no parameter is named");
    if (fit_.degreesOfFreedom <= 0)
      throw InputError("", "--data",
                       message("{} points do not determine {} parameters; more points than "
                               "parameters are needed",
                               objective_.size(), parameters.size()));
    refuseMissingErrors();
  }

  Fit run() {
    objective_.addVelocityErrors(start_);
    Minimum best = findMinimum(objective_, start_);
    if (objective_.hasVelocityErrors()) {
      objective_.addVelocityErrors(best.coordinates);
      best = minimize(objective_, best.coordinates, objective_.all(), kFitIterations);
    }
    setErrors(best);
    if (options_.hasProfiles) best = withProfiles(std::move(best));
    fit_.hasConverged = best.hasConverged;
    fit_.scene = objective_.sceneAt(best.coordinates);
    setParameters(best.coordinates);
    setCombinations();
    addProfiles();
    fit_.evaluations = objective_.evaluations();
    addWarningsAndNotes();
    return std::move(fit_);
  }

 private:
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

  void setErrors(const Minimum& best) {
    static_cast<FitErrors&>(fit_) = fitErrors(objective_, best);
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
      const double error = std::sqrt(fit_.covariance(k, k));
      const auto [below, above] = profileReach(profiles_, fit_, k, coordinates[k]);
      const double low = std::max(error, below), high = std::max(error, above);
      constexpr double kWider = 1.5;  // a range wider than the standard error by this is reported
      found.isWidened = low > kWider * error || high > kWider * error;
      found.standardError = (low + high) / 2;
      found.low = parameter.value(coordinates[k] - low);
      found.high = parameter.value(coordinates[k] + high);
      const double near = 1e-6 * (parameter.highest() - parameter.lowest());
      found.isAtLimit =
          coordinates[k] - parameter.lowest() < near || parameter.highest() - coordinates[k] < near;
      found.isDetermined = found.standardError <= largestDeterminedError(parameter);
      fit_.parameters.push_back(found);
      for (Eigen::Index j = 0; j < count; ++j)
        if (j != k)
          fit_.correlation(k, j) =
              fit_.covariance(k, j) / std::sqrt(fit_.covariance(k, k) * fit_.covariance(j, j));
    }
  }

  /// Finds the principal axes of the error ellipsoid.
  void setCombinations() {
    const MatrixXd axes = principalAxes(fit_.covariance).axes;
    for (Eigen::Index k = 0; k < fit_.covariance.rows(); ++k) {
      VectorXd axis = axes.col(k);
      Eigen::Index largest = 0;
      axis.cwiseAbs().maxCoeff(&largest);
      axis /= axis[largest];
      const double variance = axis.dot(fit_.covariance * axis);
      fit_.combinations.push_back({{axis.begin(), axis.end()}, std::sqrt(std::max(0.0, variance))});
    }
  }

  /// Returns the minimum after its profiles are set. Where a point of a profile lies lower, the
  /// minimum was a hollow of a valley, and the search goes on from that point.
  Minimum withProfiles(Minimum best) {
    constexpr int kRestarts = 4;
    for (int restart = 0;; ++restart) {
      profiles_ = fitProfiles(objective_, best, fit_);
      const Minimum& lowest = lowestPoint(profiles_, best);
      if (lowest.chiSquared >= best.chiSquared - negligibleDecrease(fit_) || restart == kRestarts)
        return best;
      Minimum found = minimize(objective_, lowest.coordinates, objective_.all(), kFitIterations);
      best = found.chiSquared < lowest.chiSquared ? std::move(found) : lowest;
      setErrors(best);
    }
  }

  /// States the profiles of the final minimum by the values of their parameters.
  void addProfiles() {
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

  void addWarningsAndNotes() {
    if (!fit_.hasFoundPoints)
      fit_.warnings.emplace_back(
          "the fit has not found the points: computed and measured friction differ by more than a "
          "factor of two on average, and the values and their errors say nothing; begin from other "
          "values, or vary further ones");
    else if (fit_.missesPoints)
      fit_.warnings.push_back(
          message("the points lie further from the curve than their errors say: \u03C7\u00B2 is "
                  "{:.3g} for {}; the errors of the values are computed from "
                  "errors of the points that are {:.2g} times as large",
                  fit_.chiSquared, degreesOfFreedom(fit_.degreesOfFreedom), fit_.errorScale));
    warnOfOutlier();
    std::ranges::move(notesOf(data_), std::back_inserter(fit_.notes));
    const double width = fit_.scene.load.width;
    for (const FrictionData& table : data_)
      if (auto note = forceNote(table, fit_.scene)) fit_.warnings.push_back(std::move(*note));
    if (const auto note = pressureNote(fit_.computed, width))
      (width > 0 ? fit_.notes : fit_.warnings).push_back(*note);
    if (shiftsByGeneralConstants())
      fit_.warnings.push_back(message(
          "times are shifted to the temperatures of the points by the general WLF constants, C1 = "
          "{} and C2 = {} K, which the scene does not replace by those of its rubber",
          TemperatureShift{}.c1, TemperatureShift{}.c2));
    for (const FittedParameter& parameter : fit_.parameters) {
      if (fit_.hasFoundPoints && !parameter.isDetermined)
        fit_.warnings.push_back(
            parameter.isLogarithmic
                ? message("{} is not determined by these data: the standard error of its logarithm "
                          "(ln) is {:.2g}",
                          parameter.key, parameter.standardError)
                : message("{} is not determined by these data: its standard error is {}",
                          parameter.key,
                          printed(parameter.standardError, findParameter(parameter.key)->unit, 2)));
      if (fit_.hasFoundPoints && parameter.isWidened)
        fit_.notes.push_back(
            message("the sum of squares is not a parabola along {}: its range is where the profile "
                    "rises by one standard error, and the standard error is half of that range",
                    parameter.key));
      if (parameter.isAtLimit)
        fit_.warnings.push_back(
            message("{} ends at its limit; the best value may lie beyond", parameter.key));
    }
    constexpr std::int64_t kFewLines = 50;
    const std::int64_t lines = fit_.computed.front().realizations;
    if (fit_.hasFoundPoints && fit_.isByLines && lines < kFewLines)
      fit_.warnings.push_back(fewLinesText(fit_.scene, lines));
    for (const ObjectiveProfile& profile : fit_.profiles) {
      const auto lowest = std::ranges::min_element(profile.chiSquared);
      if (!(*lowest < fit_.chiSquared - negligibleDecrease(fit_))) continue;
      const auto at = static_cast<std::size_t>(lowest - profile.chiSquared.begin());
      fit_.warnings.push_back(
          message("the sum of squares is lower at {} = {:.3g}, by {:.2g}: the fit has not reached "
                  "its minimum; begin again from that value",
                  profile.key, profile.values[at], fit_.chiSquared - *lowest));
    }
    if (!fit_.hasConverged)
      fit_.warnings.emplace_back("the fit ended before the sum of squares stopped falling");
  }

  /// Warns of the point that alone makes most of the sum of squares: it pulls all values towards
  /// itself, and its deviation is many times that of the others.
  void warnOfOutlier() {
    constexpr double kShare = 0.5, kTimesTheOthers = 4;
    if (!fit_.hasFoundPoints || fit_.degreesOfFreedom < 3) return;
    double largest = 0, sum = 0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < objective_.size(); ++i) {
      const double distance =
          (fit_.computed[i].mu - objective_.point(i).mu) / objective_.deviation(i);
      sum += distance * distance;
      if (distance * distance <= largest) continue;
      largest = distance * distance;
      at = i;
    }
    const double others = (sum - largest) / static_cast<double>(fit_.degreesOfFreedom - 1);
    const bool isExpected = objective_.hasErrors() && !fit_.missesPoints;
    if (isExpected || largest < kShare * sum ||
        largest < kTimesTheOthers * kTimesTheOthers * others)
      return;
    const MeasuredPoint& point = objective_.point(at);
    fit_.warnings.push_back(message(
        "one point makes {:.2g} % of the sum of squares: at {:.3g} m/s friction is measured "
        "as {:.3g} and computed as {:.3g}; check it, because it moves all values",
        100 * largest / sum, point.velocity, point.mu, fit_.computed[at].mu));
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
  VectorXd start_;
  FitProfiles profiles_;
  Fit fit_;
};

}  // namespace

Message degreesOfFreedom(std::int64_t count) {
  return count == 1 ? Message("one degree of freedom") : message("{} degrees of freedom", count);
}

Fit fitFriction(const Scene& scene, std::span<const FrictionData> data,
                std::span<const VariedParameter> parameters, const FitOptions& options) {
  requireSteadySliding(scene, "a fit");
  requireNoTarget(scene, "a fit needs the same lines everywhere");
  return Fitting(scene, data, parameters, options).run();
}

}  // namespace asperity
