// The scene at measured points for any values of its parameters, how far its friction is from what
// was measured, and the least sum of squares of that (Levenberg and Marquardt's method, Ceres
// Solver). A part of core/fit/fit.cpp.
// Failure: InputError for states that cannot slide, StopRequested where it was stopped.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/fit/derivatives.h"
#include "core/fit/fit.h"
#include "core/fit/friction_data.h"

namespace asperity {

class Objective {
 public:
  /// Throws InputError with the key of a parameter that every point states itself.
  Objective(const Scene& scene, std::span<const FrictionData> data,
            std::span<const VariedParameter> parameters, const FitOptions& options);

  std::size_t size() const { return points_.size(); }
  const VariedParameter& parameter(int k) const { return parameters_[static_cast<std::size_t>(k)]; }
  const MeasuredPoint& point(std::size_t i) const { return points_[i]; }
  double deviation(std::size_t i) const { return deviations_[i]; }
  int evaluations() const { return evaluations_; }
  const std::stop_token& stop() const { return options_.stop; }

  Scene sceneAt(const Eigen::VectorXd& coordinates) const { return at(scene_, coordinates); }

  /// Friction and, for the parameters named, its derivatives; 0 at points that state the parameter
  /// themselves.
  FrictionWithDerivatives evaluate(const Eigen::VectorXd& coordinates,
                                   std::span<const int> varied) const;

  /// Returns computed minus measured friction at a point, over the point's error.
  double residual(const FrictionWithDerivatives& found, std::size_t i) const;

  double chiSquared(const FrictionWithDerivatives& found) const;

  /// Root mean square of ln(computed / measured friction); infinite where some friction is not
  /// above 0.
  double logarithmicDistance(const FrictionWithDerivatives& found) const;

  void report(double chiSquared) const {
    if (options_.progress) options_.progress(evaluations_, chiSquared);
  }

  bool hasVelocityErrors() const;

  /// An error of the velocity is one of friction by the slope of the computed curve (effective
  /// variance).
  void addVelocityErrors(const Eigen::VectorXd& coordinates);

 private:
  StateOptions stateOptions() const;
  std::vector<Scene> statesAt(const Eigen::VectorXd& coordinates) const;
  void findStated();
  void weighWithErrors();
  Scene at(Scene scene, const Eigen::VectorXd& coordinates) const;

  const Scene& scene_;
  Scene fixed_;  // with its resolution stated
  std::span<const VariedParameter> parameters_;
  const FitOptions& options_;
  std::vector<MeasuredPoint> points_;
  std::vector<std::vector<bool>> isStated_;  // [parameter][point]
  std::vector<double> deviations_;           // of each point; without errors 100 %
  mutable int evaluations_ = 0;
};

struct Minimum {
  Eigen::VectorXd coordinates;
  double chiSquared = 0;
  bool hasConverged = false;
};

/// What is squared and summed: the residuals, or for a start that is far away ln(computed /
/// measured friction) over the point's relative error. Friction is close to a product of powers of
/// the parameters, so that steps of logarithms lead there from decades away, where those of
/// differences go beyond all limits.
enum class Distance { Difference, Logarithm };

/// The least sum of squares over the free parameters, the others held.
Minimum minimize(const Objective& objective, const Eigen::VectorXd& start,
                 const std::vector<int>& free, int iterations,
                 Distance distance = Distance::Difference);

}  // namespace asperity
