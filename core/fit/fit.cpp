#include "core/fit/fit.h"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <numeric>

#include "core/base/input_error.h"
#include "core/friction/study.h"

namespace asperity {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

double meanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The scene at the measured points for any places of the parameters, and what it differs by from
/// what was measured.
class Objective {
 public:
  Objective(const Scene& scene, std::span<const FrictionData> data,
            std::span<const VariedParameter> parameters, const FitOptions& options)
      : scene_(scene), fixed_(scene), parameters_(parameters), options_(options) {
    fixResolution(fixed_);
    for (const FrictionData& set : data)
      for (const MeasuredPoint& point : set.points) points_.push_back(point);
    weighWithErrors();
  }

  std::size_t size() const { return points_.size(); }
  const VariedParameter& parameter(int k) const { return parameters_[static_cast<std::size_t>(k)]; }
  double deviation(std::size_t i) const { return deviations_[i]; }
  int evaluations() const { return evaluations_; }

  std::vector<Scene> statesAt(const VectorXd& places) const {
    const Scene here = at(fixed_, places);
    std::vector<Scene> states;
    for (const MeasuredPoint& point : points_) states.push_back(sceneOf(point, here));
    return states;
  }

  Scene sceneAt(const VectorXd& places) const { return at(scene_, places); }

  /// Friction and, for the parameters named, its derivatives.
  FrictionWithDerivatives evaluate(const VectorXd& places, std::span<const int> varied) const {
    ++evaluations_;
    std::vector<VariedParameter> some;
    for (const int k : varied) some.push_back(parameters_[static_cast<std::size_t>(k)]);
    return frictionWithDerivatives(statesAt(places), some, stateOptions());
  }

  /// Returns computed minus measured friction at a point, over the point's error.
  double residual(const FrictionWithDerivatives& found, std::size_t i) const {
    return (meanOf(found.muOfLines[i]) - points_[i].mu) / deviations_[i];
  }

  void report(double chiSquared) const {
    if (options_.progress) options_.progress(evaluations_, chiSquared);
  }

  bool hasVelocityErrors() const {
    return std::ranges::any_of(
        points_, [](const MeasuredPoint& point) { return !std::isnan(point.velocityError); });
  }

  /// An error of the velocity is one of friction by the slope of the computed curve (effective
  /// variance).
  void addVelocityErrors(const VectorXd& places) {
    if (!hasVelocityErrors()) return;
    weighWithErrors();
    const std::vector<Scene> states = statesAt(places);
    const VariedParameter velocity("sliding.velocity", states.front());
    const FrictionWithDerivatives found =
        frictionWithDerivatives(states, {&velocity, 1}, stateOptions());
    for (std::size_t i = 0; i < size(); ++i) {
      if (std::isnan(points_[i].velocityError)) continue;
      const double relative = points_[i].velocityError / points_[i].velocity;
      deviations_[i] =
          std::hypot(deviations_[i], relative * meanOf(found.slopesOfLines.front()[i]));
    }
  }

 private:
  StateOptions stateOptions() const {
    StateOptions options;
    options.threads = options_.threads;
    options.stop = options_.stop;
    return options;
  }

  void weighWithErrors() {
    deviations_.clear();
    for (const MeasuredPoint& point : points_)
      deviations_.push_back(std::isnan(point.muError) ? point.mu : point.muError);
  }

  Scene at(Scene scene, const VectorXd& places) const {
    for (std::size_t k = 0; k < parameters_.size(); ++k)
      parameters_[k].set(scene, places[static_cast<Eigen::Index>(k)]);
    return scene;
  }

  const Scene& scene_;
  Scene fixed_;  // with its resolution stated
  std::span<const VariedParameter> parameters_;
  const FitOptions& options_;
  std::vector<MeasuredPoint> points_;
  std::vector<double> deviations_;  // of each point; without errors 100 %
  mutable int evaluations_ = 0;
};

/// Residuals and their derivatives by the free parameters, as Ceres asks for them.
class Residuals : public ceres::CostFunction {
 public:
  Residuals(const Objective& objective, VectorXd places, std::vector<int> free)
      : objective_(objective), places_(std::move(places)), free_(std::move(free)) {
    set_num_residuals(static_cast<int>(objective_.size()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(free_.size()));
  }

  bool Evaluate(const double* const* blocks, double* residuals, double** jacobians) const override {
    // Beyond a limit friction is that at the limit. Limits of Ceres's own would cost a search along
    // a line, with derivatives, after every step.
    std::vector<bool> isBeyond;
    for (std::size_t j = 0; j < free_.size(); ++j) {
      const VariedParameter& parameter = objective_.parameter(free_[j]);
      const double place = std::clamp(blocks[0][j], parameter.lowest(), parameter.highest());
      isBeyond.push_back(place != blocks[0][j]);
      places_[free_[j]] = place;
    }
    const bool wantsSlopes = jacobians && jacobians[0];
    try {
      const FrictionWithDerivatives found =
          objective_.evaluate(places_, wantsSlopes ? free_ : std::vector<int>{});
      double chiSquared = 0;
      for (std::size_t i = 0; i < objective_.size(); ++i) {
        const double deviation = objective_.deviation(i);
        residuals[i] = objective_.residual(found, i);
        chiSquared += residuals[i] * residuals[i];
        if (!wantsSlopes) continue;
        for (std::size_t j = 0; j < free_.size(); ++j)
          jacobians[0][i * free_.size() + j] =
              isBeyond[j] ? 0 : meanOf(found.slopesOfLines[j][i]) / deviation;
      }
      objective_.report(chiSquared);
      return true;
    } catch (...) {
      // Ceres knows no exceptions: a state that cannot be is a step that failed.
      failure_ = std::current_exception();
      return false;
    }
  }

  const std::exception_ptr& failure() const { return failure_; }
  const VectorXd& places() const { return places_; }

 private:
  const Objective& objective_;
  mutable VectorXd places_;
  std::vector<int> free_;
  mutable std::exception_ptr failure_;
};

struct Minimum {
  VectorXd places;
  double chiSquared = 0;
  bool hasConverged = false;
};

/// The least sum of squares over the free parameters, the others held.
Minimum minimize(const Objective& objective, const VectorXd& start, const std::vector<int>& free,
                 int iterations, const std::stop_token& stop) {
  Minimum minimum{start, 0, true};
  std::vector<double> values;
  for (const int k : free) values.push_back(start[k]);
  auto residuals = std::make_unique<Residuals>(objective, start, free);
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
  // Ceres warns on the standard error stream of a step that failed; the exception behind it says
  // more.
  FLAGS_minloglevel = google::GLOG_FATAL;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  throwIfStopped(stop);
  if (summary.termination_type == ceres::FAILURE && watched.failure())
    std::rethrow_exception(watched.failure());
  for (std::size_t j = 0; j < free.size(); ++j)
    minimum.places[free[j]] = std::clamp(values[j], objective.parameter(free[j]).lowest(),
                                         objective.parameter(free[j]).highest());
  minimum.chiSquared = 2 * summary.final_cost;
  minimum.hasConverged = summary.termination_type == ceres::CONVERGENCE;
  return minimum;
}

/// The covariance of the mean over the lines, which all points share, [point][point].
MatrixXd covarianceOfLines(const FrictionWithDerivatives& found) {
  const auto n = static_cast<Eigen::Index>(found.muOfLines.size());
  std::size_t lines = found.muOfLines.front().size();
  for (const std::vector<double>& mu : found.muOfLines) lines = std::min(lines, mu.size());
  MatrixXd covariance = MatrixXd::Zero(n, n);
  if (lines < 2) return covariance;
  MatrixXd about(n, static_cast<Eigen::Index>(lines));
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::vector<double>& mu = found.muOfLines[static_cast<std::size_t>(i)];
    const double mean = meanOf(mu);
    for (std::size_t line = 0; line < lines; ++line)
      about(i, static_cast<Eigen::Index>(line)) = mu[line] - mean;
  }
  return about * about.transpose() / (static_cast<double>(lines) * static_cast<double>(lines - 1));
}

/// What the points know of the parameters, a symmetric matrix, by its principal directions.
class Information {
 public:
  explicit Information(const MatrixXd& matrix) : directions_(matrix) {}

  /// The inverse; directions of which the points know nothing get a very large value in place of an
  /// infinite one.
  MatrixXd inverse() const {
    constexpr double kNothing = 1e-15;
    const VectorXd known = directions_.eigenvalues().cwiseMax(least(kNothing));
    return directions_.eigenvectors() * known.cwiseInverse().asDiagonal() *
           directions_.eigenvectors().transpose();
  }

  /// The covariance of the directions of which the points know nothing, such as that of force and
  /// modulus together, whose ratio alone matters: along them the response to the points' errors is
  /// 0, but their values may be any.
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
  /// This share of the best known direction, and never 0.
  double least(double share) const {
    return std::max(share * directions_.eigenvalues().maxCoeff(),
                    std::numeric_limits<double>::min() * 1e10);
  }

  Eigen::SelfAdjointEigenSolver<MatrixXd> directions_;
};

/// How far a parameter's place may be wrong before it counts as open.
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
        hasErrors_(std::ranges::all_of(data, &FrictionData::hasErrors)),
        all_(parameters.size()) {
    std::iota(all_.begin(), all_.end(), 0);
    start_.resize(static_cast<Eigen::Index>(parameters.size()));
    for (std::size_t k = 0; k < parameters.size(); ++k)
      start_[static_cast<Eigen::Index>(k)] = parameters[k].place(parameters[k].of(scene));
    const auto points = static_cast<std::int64_t>(objective_.size());
    const auto count = static_cast<std::int64_t>(parameters.size());
    if (count == 0) throw InputError("", "--vary", "no parameter is named");
    if (points <= count)
      throw InputError("", "--data",
                       message("{} points do not determine {} parameters; more points than "
                               "parameters are needed",
                               points, count));
    fit_.freedom = points - count;
  }

  Fit run() {
    constexpr int kIterations = 60;
    objective_.addVelocityErrors(start_);
    Minimum best = minimize(objective_, start_, all_, kIterations, options_.stop);
    if (objective_.hasVelocityErrors()) {
      objective_.addVelocityErrors(best.places);
      best = minimize(objective_, best.places, all_, kIterations, options_.stop);
    }
    fit_.hasConverged = best.hasConverged;
    fit_.chiSquared = best.chiSquared;
    fit_.scene = objective_.sceneAt(best.places);
    setErrors(best.places);
    setParameters(best.places);
    setCombinations();
    if (options_.hasProfiles) setProfiles(best);
    fit_.evaluations = objective_.evaluations();
    addNotes();
    return std::move(fit_);
  }

 private:
  void setErrors(const VectorXd& places) {
    const FrictionWithDerivatives found = objective_.evaluate(places, all_);
    const auto n = static_cast<Eigen::Index>(objective_.size());
    const auto count = static_cast<Eigen::Index>(parameters_.size());
    MatrixXd slopes(n, count);
    VectorXd weights(n), variances(n);
    const double scatter =
        hasErrors_ ? 1 : std::sqrt(fit_.chiSquared / static_cast<double>(fit_.freedom));
    if (!hasErrors_) fit_.relativeScatter = scatter;
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto point = static_cast<std::size_t>(i);
      const double deviation = objective_.deviation(point);
      weights[i] = 1 / (deviation * deviation);
      variances[i] = scatter * scatter / weights[i];
      for (Eigen::Index k = 0; k < count; ++k)
        slopes(i, k) = meanOf(found.slopesOfLines[static_cast<std::size_t>(k)][point]);
    }
    const MatrixXd lines = covarianceOfLines(found);
    const Information information(slopes.transpose() * weights.asDiagonal() * slopes);
    const MatrixXd response = information.inverse() * slopes.transpose() * weights.asDiagonal();
    const MatrixXd ofErrors = MatrixXd(variances.asDiagonal()) + lines;
    covariance_ = response * ofErrors * response.transpose() + information.openCovariance();
    fit_.computed = found.points;
    const MatrixXd band = slopes * covariance_ * slopes.transpose();
    for (Eigen::Index i = 0; i < n; ++i) {
      fit_.computedErrors.push_back(std::sqrt(lines(i, i)));
      fit_.bandErrors.push_back(std::sqrt(std::max(0.0, band(i, i))));
    }
  }

  void setParameters(const VectorXd& places) {
    const auto count = static_cast<Eigen::Index>(parameters_.size());
    fit_.correlation = MatrixXd::Identity(count, count);
    for (Eigen::Index k = 0; k < count; ++k) {
      const VariedParameter& parameter = parameters_[static_cast<std::size_t>(k)];
      FittedParameter found;
      found.key = parameter.key();
      found.isLogarithmic = parameter.isLogarithmic();
      found.value = parameter.value(places[k]);
      found.standardError = std::sqrt(covariance_(k, k));
      found.low = parameter.value(places[k] - found.standardError);
      found.high = parameter.value(places[k] + found.standardError);
      const double near = 1e-6 * (parameter.highest() - parameter.lowest());
      found.isAtLimit =
          places[k] - parameter.lowest() < near || parameter.highest() - places[k] < near;
      found.isDetermined = found.standardError <= openBeyond(parameter);
      fit_.parameters.push_back(found);
      for (Eigen::Index j = 0; j < count; ++j)
        if (j != k)
          fit_.correlation(k, j) =
              covariance_(k, j) / std::sqrt(covariance_(k, k) * covariance_(j, j));
    }
  }

  /// The principal axes of the error ellipsoid.
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

  /// With one parameter held at some places around the best one, the others follow as their
  /// covariance says and are then minimized for.
  void setProfiles(const Minimum& best) {
    constexpr int kIterations = 4;
    for (std::size_t k = 0; k < parameters_.size(); ++k) {
      const auto index = static_cast<Eigen::Index>(k);
      const VariedParameter& parameter = parameters_[k];
      const double reach = std::min(fit_.parameters[k].standardError, 2 * openBeyond(parameter));
      std::vector<int> others = all_;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
      ObjectiveProfile profile{std::string(parameter.key()), {}, {}};
      for (const double steps : {-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0}) {
        const double there = best.places[index] + steps * reach;
        if (there < parameter.lowest() || there > parameter.highest()) continue;
        Minimum held = best;
        if (steps != 0) {
          VectorXd start =
              best.places + covariance_.col(index) * (steps * reach) / covariance_(index, index);
          for (std::size_t j = 0; j < parameters_.size(); ++j) {
            const auto place = static_cast<Eigen::Index>(j);
            start[place] =
                std::clamp(start[place], parameters_[j].lowest(), parameters_[j].highest());
          }
          start[index] = there;
          held = others.empty() ? atPlace(start)
                                : minimize(objective_, start, others, kIterations, options_.stop);
        }
        profile.values.push_back(parameter.value(there));
        profile.chiSquared.push_back(held.chiSquared);
      }
      fit_.profiles.push_back(std::move(profile));
    }
  }

  Minimum atPlace(const VectorXd& places) const {
    const FrictionWithDerivatives found = objective_.evaluate(places, {});
    Minimum minimum{places, 0, true};
    for (std::size_t i = 0; i < objective_.size(); ++i) {
      const double residual = objective_.residual(found, i);
      minimum.chiSquared += residual * residual;
    }
    return minimum;
  }

  void addNotes() {
    if (hasErrors_ && fit_.freedom > 0) {
      // Three standard deviations of chi squared beyond its mean.
      const auto freedom = static_cast<double>(fit_.freedom);
      fit_.missesPoints = fit_.chiSquared > freedom + 3 * std::sqrt(2 * freedom);
    }
    if (fit_.missesPoints)
      fit_.notes.push_back(
          message("the points lie further from the curve than their errors say: chi squared is "
                  "{:.3g} for {} degrees of freedom",
                  fit_.chiSquared, fit_.freedom));
    // What the tables were taken for.
    for (const FrictionData& table : data_)
      for (const Message& note : table.notes)
        fit_.notes.push_back(message("{}: {}", Message::name(table.name), note));
    for (const FittedParameter& parameter : fit_.parameters) {
      if (!parameter.isDetermined)
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

  std::span<const FrictionData> data_;
  std::span<const VariedParameter> parameters_;
  const FitOptions& options_;
  Objective objective_;
  bool hasErrors_;
  std::vector<int> all_;
  VectorXd start_;
  MatrixXd covariance_;  // of the places
  Fit fit_;
};

}  // namespace

Fit fitFriction(const Scene& scene, std::span<const FrictionData> data,
                std::span<const VariedParameter> parameters, const FitOptions& options) {
  return Fitting(scene, data, parameters, options).run();
}

}  // namespace asperity
