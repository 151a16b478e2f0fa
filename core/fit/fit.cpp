#include "core/fit/fit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/statistics.h"
#include "core/fit/fisher_information.h"
#include "core/fit/fit_objective.h"
#include "core/fit/fit_profile.h"

namespace asperity {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

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
    best = settled(best);
    fit_.hasConverged = best.hasConverged && possibleDecrease_ <= enough();
    fit_.scene = objective_.sceneAt(best.coordinates);
    setParameters(best.coordinates);
    setCombinations();
    fit_.evaluations = objective_.evaluations();
    addNotes();
    return std::move(fit_);
  }

 private:
  static constexpr int kIterations = 60;
  /// The part of a standard error by which the end of a range differs where there is no parabola.
  static constexpr double kUneven = 0.25;
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

  /// Returns the decrease of the sum of squares that is not worth a further step: that of a tenth
  /// of an error of the points.
  double enough() const { return 0.01 * fit_.errorScale * fit_.errorScale; }

  /// Finds the errors, ranges and profiles of a minimum. Steps that end in a valley go on, and
  /// where a point of a profile lies lower, the fit goes on from there.
  Minimum settled(Minimum best) {
    constexpr int kRestarts = 12;
    for (int restart = 0;; ++restart) {
      setErrors(best);
      std::optional<Minimum> start;
      if (possibleDecrease_ > enough() || !best.hasConverged) start = continued(best);
      if (!start) start = walkProfiles(best);
      if (!start) return best;
      best = *start;
      if (restart == kRestarts) {
        setErrors(best);
        best.hasConverged = false;
        return best;
      }
    }
  }

  /// Returns a lower minimum that new steps from the best one lead to.
  std::optional<Minimum> continued(const Minimum& best) const {
    Minimum next = minimize(objective_, best.coordinates, all_, kIterations);
    if (next.chiSquared < best.chiSquared - enough()) return next;
    return std::nullopt;
  }

  /// Sets profiles and ranges: of all parameters, or where no profiles are wanted of that one which
  /// the data leave open most, if it lies in a valley. Returns a lower minimum where one shows.
  std::optional<Minimum> walkProfiles(const Minimum& best) {
    fit_.profiles.assign(parameters_.size(), {});
    ranges_.assign(parameters_.size(), {});
    isWalked_.assign(parameters_.size(), false);
    const int worst = leastDetermined();
    std::vector<int> order;
    if (options_.hasProfiles || liesInValley(worst)) order.push_back(worst);
    if (options_.hasProfiles)
      for (const int k : all_)
        if (k != worst) order.push_back(k);
    const MatrixXd linear = covariance_;
    const ProfileWalk walk(objective_, best, fit_.errorScale);
    std::vector<VectorXd> within;  // of all profiles, how far one deviation reaches
    for (const int k : order) {
      const VariedParameter& parameter = parameters_[static_cast<std::size_t>(k)];
      const double reach = std::min(std::sqrt(linear(k, k)), 2 * openBeyond(parameter));
      const std::vector<ProfilePoint> points =
          walk.profile(k, linear.col(k) * reach / linear(k, k), options_.hasProfiles ? 3 : 1);
      const auto lowest = std::ranges::min_element(
          points, {}, [](const ProfilePoint& point) { return point.minimum.chiSquared; });
      if (lowest->minimum.chiSquared < best.chiSquared - enough()) return from(lowest->minimum);
      setRange(k, best, points, linear, k == worst);
      for (const ProfilePoint& point : points)
        if (const auto share = shareOfPoint(best.coordinates, point)) within.push_back(*share);
      ObjectiveProfile profile{std::string(parameter.key()), {}, {}};
      for (const ProfilePoint& point : points) {
        profile.values.push_back(parameter.value(point.minimum.coordinates[k]));
        profile.chiSquared.push_back(point.minimum.chiSquared);
      }
      fit_.profiles[static_cast<std::size_t>(k)] = std::move(profile);
    }
    if (!options_.hasProfiles) fit_.profiles.clear();
    for (const int k : all_) widenRange(k, best.coordinates[k], within);
    return std::nullopt;
  }

  /// Widens the range of a parameter to the points of all profiles that are within one deviation:
  /// behind a bump its own profile may have ended before it came to them.
  void widenRange(int k, double here, const std::vector<VectorXd>& within) {
    auto& range = ranges_[static_cast<std::size_t>(k)];
    const VariedParameter& parameter = parameters_[static_cast<std::size_t>(k)];
    const double error = std::sqrt(covariance_(k, k));
    auto [low, high] = range.value_or(std::pair(here - error, here + error));
    const double margin = kUneven * error;
    bool isWider = false;
    for (const VectorXd& point : within) {
      isWider |= point[k] < std::max(low, parameter.lowest()) - margin ||
                 point[k] > std::min(high, parameter.highest()) + margin;
      low = std::min(low, point[k]);
      high = std::max(high, point[k]);
    }
    if (isWider) range = std::pair(low, high);
  }

  /// Returns the minimum over all parameters from a point of a profile; never above the point.
  Minimum from(const Minimum& point) const {
    Minimum found = minimize(objective_, point.coordinates, all_, kIterations);
    return found.chiSquared <= point.chiSquared ? found : point;
  }

  int leastDetermined() const {
    const auto openness = [&](int k) {
      return covariance_(k, k) / std::pow(openBeyond(parameters_[static_cast<std::size_t>(k)]), 2);
    };
    return *std::ranges::max_element(all_, {}, openness);
  }

  /// Returns whether an error is a large part of what counts as open, and most of it comes from the
  /// other parameters.
  bool liesInValley(int k) const {
    constexpr double kLarge = 0.25, kTimes = 3;
    const double error = std::sqrt(covariance_(k, k));
    return error > kLarge * openBeyond(parameters_[static_cast<std::size_t>(k)]) &&
           error > kTimes * alone_[k];
  }

  /// Reads the range of a parameter from its profile, where that is no parabola. The covariance of
  /// the least determined one then follows its valley, with that of the others around it.
  void setRange(int k, const Minimum& best, const std::vector<ProfilePoint>& points,
                const MatrixXd& linear, bool isValley) {
    const VariedParameter& parameter = parameters_[static_cast<std::size_t>(k)];
    const double error = std::sqrt(linear(k, k)), here = best.coordinates[k];
    const ProfileRange range = rangeOfProfile(objective_, k, points);
    const auto differs = [&](const std::optional<VectorXd>& end, double there) {
      there = std::clamp(there, parameter.lowest(), parameter.highest());
      return end && std::abs((*end)[k] - there) > kUneven * error;
    };
    if (!differs(range.low, here - error) && !differs(range.high, here + error)) return;
    isWalked_[static_cast<std::size_t>(k)] = true;
    const VectorXd straight = linear.col(k) / error;
    const VectorXd low = range.low.value_or(best.coordinates - straight);
    const VectorXd high = range.high.value_or(best.coordinates + straight);
    ranges_[static_cast<std::size_t>(k)] = std::pair(low[k], high[k]);
    if (!isValley) return;
    const MatrixXd around = linear - straight * straight.transpose();
    const VectorXd half = (high - low) / 2;
    covariance_ = around + half * half.transpose();
    for (const int j : all_) {
      if (j == k) continue;
      const double beside = std::sqrt(std::max(0.0, around(j, j)));
      const double lowest = std::min({low[j], high[j], best.coordinates[j]});
      const double highest = std::max({low[j], high[j], best.coordinates[j]});
      ranges_[static_cast<std::size_t>(j)] =
          std::pair(best.coordinates[j] - std::hypot(best.coordinates[j] - lowest, beside),
                    best.coordinates[j] + std::hypot(highest - best.coordinates[j], beside));
    }
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
    VectorXd weights(n), residuals(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto point = static_cast<std::size_t>(i);
      const double deviation = objective_.deviation(point);
      weights[i] = 1 / (deviation * deviation);
      residuals[i] = objective_.residual(found, point) * deviation;
      for (Eigen::Index k = 0; k < count; ++k)
        slopes(i, k) = mean(found.slopesOfLines[static_cast<std::size_t>(k)][point]);
    }
    const MatrixXd lines = scatterOfLines(found);
    const FisherInformation information(slopes.transpose() * weights.asDiagonal() * slopes);
    const MatrixXd response = information.inverse() * slopes.transpose() * weights.asDiagonal();
    const MatrixXd ofLines = response * lines;
    compareWithErrors(weights.cwiseSqrt().asDiagonal() * (lines - slopes * ofLines));
    const VectorXd ofPoints = fit_.errorScale * fit_.errorScale * weights.cwiseInverse();
    covariance_ = response * ofPoints.asDiagonal() * response.transpose() +
                  ofLines * ofLines.transpose() + information.openCovariance();
    // A parameter at a limit cannot move beyond it.
    VectorXd gradient = slopes.transpose() * weights.asDiagonal() * residuals;
    MatrixXd inner = slopes.transpose() * weights.asDiagonal() * slopes;
    alone_ = fit_.errorScale * inner.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    for (Eigen::Index k = 0; k < count; ++k) {
      const VariedParameter& parameter = parameters_[static_cast<std::size_t>(k)];
      if (!(coordinates[k] <= parameter.lowest() && gradient[k] > 0) &&
          !(coordinates[k] >= parameter.highest() && gradient[k] < 0))
        continue;
      gradient[k] = 0;
      inner.row(k).setZero();
      inner.col(k).setZero();
    }
    possibleDecrease_ = FisherInformation(inner).possibleDecrease(gradient);
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
      double low = coordinates[k] - found.standardError;
      double high = coordinates[k] + found.standardError;
      if (const auto& range = ranges_[static_cast<std::size_t>(k)]) {
        std::tie(low, high) = *range;
        found.standardError = std::max(found.standardError, (high - low) / 2);
      }
      found.low = parameter.value(low);
      found.high = parameter.value(high);
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
    for (std::size_t k = 0; k < parameters_.size(); ++k)
      if (fit_.hasFoundPoints && isWalked_[k])
        fit_.notes.push_back(
            message("the sum of squares along {} is no parabola: the range is that of its profile, "
                    "and the standard error is at least half of it",
                    fit_.parameters[k].key));
    for (const FittedParameter& parameter : fit_.parameters) {
      if (fit_.hasFoundPoints && !parameter.isDetermined)
        fit_.notes.push_back(message(
            "{} is not determined by these data: its standard error is {:.2g} in {}", parameter.key,
            parameter.standardError, parameter.isLogarithmic ? "ln" : "its unit"));
      if (parameter.isAtLimit)
        fit_.notes.push_back(
            message("{} ends at its limit; the best value may lie beyond", parameter.key));
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
  MatrixXd covariance_;          // of the coordinates
  VectorXd alone_;               // the error of each coordinate with the others known
  double possibleDecrease_ = 0;  // of the sum of squares, by a step within the limits
  /// Ends of one deviation, where the profile of a parameter gives them.
  std::vector<std::optional<std::pair<double, double>>> ranges_;
  std::vector<bool> isWalked_;  // whether the parameter's own profile gives them
  Fit fit_;
};

}  // namespace

Fit fitFriction(const Scene& scene, std::span<const FrictionData> data,
                std::span<const VariedParameter> parameters, const FitOptions& options) {
  return Fitting(scene, data, parameters, options).run();
}

}  // namespace asperity
