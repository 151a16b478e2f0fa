#include "core/fit/fit_objective.h"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/statistics.h"
#include "core/base/stop.h"
#include "core/friction/jackknife.h"

namespace asperity {
namespace {

using Eigen::VectorXd;

/// The residuals and their derivatives with respect to the free parameters, as a cost function of
/// Ceres.
class Residuals : public ceres::CostFunction {
 public:
  Residuals(const Objective& objective, VectorXd coordinates, std::vector<int> free,
            Distance distance)
      : objective_(objective),
        coordinates_(std::move(coordinates)),
        free_(std::move(free)),
        distance_(distance) {
    set_num_residuals(static_cast<int>(objective_.size()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(free_.size()));
  }

  bool Evaluate(const double* const* blocks, double* residuals, double** jacobians) const override {
    // Beyond a limit, friction is that at the limit. Limits of Ceres itself would cost a line
    // search with derivatives after every step.
    std::vector<bool> isBeyond;
    for (std::size_t j = 0; j < free_.size(); ++j) {
      const VariedParameter& parameter = objective_.parameter(free_[j]);
      const double coordinate = std::clamp(blocks[0][j], parameter.lowest(), parameter.highest());
      isBeyond.push_back(coordinate != blocks[0][j]);
      coordinates_[free_[j]] = coordinate;
    }
    const bool wantsSlopes = jacobians && jacobians[0];
    try {
      const FrictionWithDerivatives found =
          objective_.evaluate(coordinates_, wantsSlopes ? free_ : std::vector<int>{});
      if (distance_ == Distance::Logarithm && !std::isfinite(objective_.logarithmicDistance(found)))
        return false;
      for (std::size_t i = 0; i < objective_.size(); ++i) {
        double perSlope = 1 / objective_.deviation(i);
        residuals[i] = objective_.residual(found, i);
        if (distance_ == Distance::Logarithm) {
          const double measured = objective_.point(i).mu, computed = mean(found.muOfLines[i]);
          residuals[i] = perSlope * measured * std::log(computed / measured);
          perSlope *= measured / computed;
        }
        if (!wantsSlopes) continue;
        for (std::size_t j = 0; j < free_.size(); ++j)
          jacobians[0][i * free_.size() + j] =
              isBeyond[j] ? 0 : perSlope * mean(found.slopesOfLines[j][i]);
      }
      objective_.report(objective_.chiSquared(found));
      return true;
    } catch (...) {
      // Ceres does not allow exceptions: an impossible state is a failed step.
      failure_ = std::current_exception();
      return false;
    }
  }

  const std::exception_ptr& failure() const { return failure_; }

 private:
  const Objective& objective_;
  mutable VectorXd coordinates_;
  std::vector<int> free_;
  Distance distance_;
  mutable std::exception_ptr failure_;
};

}  // namespace

Objective::Objective(const Scene& scene, std::span<const FrictionData> data,
                     std::span<const VariedParameter> parameters, const FitOptions& options)
    : scene_(scene),
      fixed_(scene),
      parameters_(parameters),
      options_(options),
      hasErrors_(std::ranges::any_of(data, &FrictionData::hasErrors)),
      all_(parameters.size()) {
  std::iota(all_.begin(), all_.end(), 0);
  fixResolution(fixed_);
  for (const FrictionData& set : data)
    for (const MeasuredPoint& point : set.points) points_.push_back(point);
  findStated();
  weighWithErrors();
}

/// Finds the points that state a parameter: their state is the same for any value of it, or has
/// another kind of load.
void Objective::findStated() {
  for (const VariedParameter& parameter : parameters_) {
    Scene least = scene_, most = scene_;
    parameter.set(least, parameter.lowest());
    parameter.set(most, parameter.highest());
    std::vector<bool>& isStated = isStated_.emplace_back();
    for (const MeasuredPoint& point : points_)
      isStated.push_back(parameter.valueIn(sceneAtPoint(point, least)) ==
                             parameter.valueIn(sceneAtPoint(point, most)) ||
                         !isApplicable(parameter.row(), sceneAtPoint(point, scene_)));
    if (std::ranges::all_of(isStated, std::identity{}))
      throw InputError("", std::string(parameter.key()),
                       "the data state it in each row, so that there is nothing to fit");
  }
}

FrictionWithDerivatives Objective::evaluate(const VectorXd& coordinates,
                                            std::span<const int> varied) const {
  ++evaluations_;
  std::vector<VariedParameter> some;
  for (const int k : varied) some.push_back(parameter(k));
  FrictionWithDerivatives found =
      frictionWithDerivatives(statesAt(coordinates), some, stateOptions());
  for (std::size_t i = 0; i < size(); ++i)
    if (!std::isfinite(mean(found.muOfLines[i])))
      throw InputError("", "--data",
                       message("the scene has no friction at row {}", points_[i].row));
  for (std::size_t j = 0; j < varied.size(); ++j)
    for (std::size_t i = 0; i < size(); ++i)
      if (isStated_[static_cast<std::size_t>(varied[j])][i])
        std::ranges::fill(found.slopesOfLines[j][i], 0.0);
  return found;
}

double Objective::residual(const FrictionWithDerivatives& found, std::size_t i) const {
  return (mean(found.muOfLines[i]) - points_[i].mu) / deviations_[i];
}

double Objective::chiSquared(const FrictionWithDerivatives& found) const {
  double sum = 0;
  for (std::size_t i = 0; i < size(); ++i) sum += residual(found, i) * residual(found, i);
  return sum;
}

double Objective::logarithmicDistance(const FrictionWithDerivatives& found) const {
  double sum = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    const double ratio = mean(found.muOfLines[i]) / points_[i].mu;
    if (!(ratio > 0)) return std::numeric_limits<double>::infinity();
    sum += std::log(ratio) * std::log(ratio);
  }
  return std::sqrt(sum / static_cast<double>(size()));
}

bool Objective::hasVelocityErrors() const {
  return std::ranges::any_of(
      points_, [](const MeasuredPoint& point) { return !std::isnan(point.velocityError); });
}

void Objective::addVelocityErrors(const VectorXd& coordinates) {
  if (!hasVelocityErrors()) return;
  weighWithErrors();
  const std::vector<Scene> states = statesAt(coordinates);
  const VariedParameter velocity(kVelocityKey, states.front());
  const FrictionWithDerivatives found =
      frictionWithDerivatives(states, {&velocity, 1}, stateOptions());
  for (std::size_t i = 0; i < size(); ++i) {
    if (std::isnan(points_[i].velocityError)) continue;
    const double relative = points_[i].velocityError / points_[i].velocity;
    deviations_[i] = std::hypot(deviations_[i], relative * mean(found.slopesOfLines.front()[i]));
  }
}

StateOptions Objective::stateOptions() const {
  return {.threads = options_.threads, .stop = options_.stop};
}

std::vector<Scene> Objective::statesAt(const VectorXd& coordinates) const {
  const Scene here = at(fixed_, coordinates);
  std::vector<Scene> states;
  states.reserve(points_.size());
  for (const MeasuredPoint& point : points_) states.push_back(sceneAtPoint(point, here));
  return states;
}

void Objective::weighWithErrors() {
  deviations_.clear();
  for (const MeasuredPoint& point : points_)
    deviations_.push_back(std::isnan(point.muError) ? point.mu : point.muError);
}

Scene Objective::at(Scene scene, const VectorXd& coordinates) const {
  for (std::size_t k = 0; k < parameters_.size(); ++k)
    parameters_[k].set(scene, coordinates[static_cast<Eigen::Index>(k)]);
  return scene;
}

Minimum minimize(const Objective& objective, const VectorXd& start, const std::vector<int>& free,
                 int iterations, Distance distance) {
  Minimum minimum{start, 0, true};
  std::vector<double> values;
  for (const int k : free) values.push_back(start[k]);
  auto residuals = std::make_unique<Residuals>(objective, start, free, distance);
  const Residuals& watched = *residuals;
  ceres::Problem::Options owned;
  owned.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(owned);
  problem.AddResidualBlock(residuals.get(), nullptr, values.data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = iterations;
  options.function_tolerance = 1e-6;
  options.parameter_tolerance = 1e-6;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  // Ceres would warn about a failed step on the standard error stream; the exception tells more.
  FLAGS_minloglevel = google::GLOG_FATAL;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  throwIfStopped(objective.stop());
  if (summary.termination_type == ceres::FAILURE) {
    if (watched.failure()) std::rethrow_exception(watched.failure());
    throw std::runtime_error("the fit failed: " + summary.message);
  }
  for (std::size_t j = 0; j < free.size(); ++j)
    minimum.coordinates[free[j]] = std::clamp(values[j], objective.parameter(free[j]).lowest(),
                                              objective.parameter(free[j]).highest());
  minimum.chiSquared = 2 * summary.final_cost;
  minimum.hasConverged = summary.termination_type == ceres::CONVERGENCE;
  return minimum;
}

Minimum atCoordinates(const Objective& objective, const VectorXd& coordinates) {
  return {coordinates, objective.chiSquared(objective.evaluate(coordinates, {})), true};
}

namespace {

using Eigen::VectorXd;

/// Returns the coordinates from which the fit begins. Where friction is far from the measured
/// values, a fit of logarithms comes first.
VectorXd startNearPoints(const Objective& objective, const VectorXd& start) {
  const double distance = objective.logarithmicDistance(objective.evaluate(start, {}));
  if (distance < kFarFromPoints || !std::isfinite(distance)) return start;
  return minimize(objective, start, objective.all(), kFitIterations, Distance::Logarithm)
      .coordinates;
}

/// Returns whether a minimum leaves so much that another one may be the right one: chi squared
/// far above the degrees of freedom, or without errors points that scatter by more than a tenth.
bool isFarOff(const Objective& objective, const Minimum& found) {
  constexpr double kFarAbove = 10, kScatter = 0.1;
  const double perFreedom = found.chiSquared / static_cast<double>(objective.degreesOfFreedom());
  return perFreedom > (objective.hasErrors() ? kFarAbove : kScatter * kScatter);
}

/// Returns the coordinates that a slider reaches, within the parameter's limits.
std::pair<double, double> sliderCoordinates(const VariedParameter& parameter) {
  const SliderRange slider = *sliderRange(parameter.row());
  // A logarithmic slider may begin at none, which has no coordinate.
  constexpr double kDecades = 1e-6;
  const double first =
      parameter.isLogarithmic() ? std::max(slider.from, kDecades * slider.to) : slider.from;
  const auto within = [&](double value) {
    return std::clamp(parameter.coordinate(value), parameter.lowest(), parameter.highest());
  };
  return {within(first), within(slider.to)};
}

/// Returns the best of some values of one parameter over the range of its slider, the others held.
Minimum bestAlong(const Objective& objective, int k, const VectorXd& around) {
  constexpr int kValues = 11;
  const VariedParameter& parameter = objective.parameter(k);
  const auto [from, to] = sliderCoordinates(parameter);
  Minimum best{around, std::numeric_limits<double>::infinity(), false};
  for (int i = 0; i < kValues; ++i) try {
      VectorXd coordinates = around;
      coordinates[k] = from + (to - from) * i / (kValues - 1);
      const double chiSquared = atCoordinates(objective, coordinates).chiSquared;
      if (chiSquared < best.chiSquared) best = {std::move(coordinates), chiSquared, false};
    } catch (const InputError&) {
      continue;  // a state that cannot slide
    }
  return best;
}

/// Searches again from other coordinates. A parameter may have left the range in which friction
/// answers to it, from where no slope leads back: so each one in turn is set to values over
/// its slider's whole range, the others as found, and the search goes on from the best of them,
/// as long as that helps.
Minimum fromOtherStarts(const Objective& objective, Minimum best) {
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds && isFarOff(objective, best); ++round) {
    const double before = best.chiSquared;
    const VectorXd around = best.coordinates;
    for (const int k : objective.all()) {
      const Minimum start = bestAlong(objective, k, around);
      if (!std::isfinite(start.chiSquared)) continue;
      try {
        Minimum found = minimize(objective, start.coordinates, objective.all(), kFitIterations);
        if (found.chiSquared < best.chiSquared) best = std::move(found);
      } catch (const InputError&) {
        // A start from which no state can slide leads nowhere.
      }
    }
    if (!(best.chiSquared < 0.99 * before)) break;
  }
  return best;
}

}  // namespace

Minimum findMinimum(const Objective& objective, const VectorXd& start) {
  const Minimum best =
      minimize(objective, startNearPoints(objective, start), objective.all(), kFitIterations);
  return isFarOff(objective, best) ? fromOtherStarts(objective, best) : best;
}

}  // namespace asperity
