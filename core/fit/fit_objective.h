// The objective of a fit: the scene at the measured points for any values of its parameters, the
// residuals of its friction, and the minimum of the sum of their squares (the method of Levenberg
// and Marquardt, Ceres Solver). The files fit*.cpp share it.
// Failure: InputError for states that cannot slide, StopRequested where the computation was
// stopped.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "core/fit/derivatives.h"
#include "core/fit/fit.h"
#include "core/fit/friction_data.h"

namespace asperity {

/// A fit that is further from the points in the logarithm than a factor of two has not found them.
inline constexpr double kFarFromPoints = std::numbers::ln2;

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
  /// Returns whether the points have errors of their own.
  bool hasErrors() const { return hasErrors_; }
  /// Returns the number of points minus that of parameters.
  std::int64_t degreesOfFreedom() const {
    return static_cast<std::int64_t>(points_.size()) - static_cast<std::int64_t>(all_.size());
  }
  /// Returns the indices of all parameters.
  const std::vector<int>& all() const { return all_; }
  const std::stop_token& stop() const { return options_.stop; }

  Scene sceneAt(const Eigen::VectorXd& coordinates) const { return at(scene_, coordinates); }

  /// Returns friction and its derivatives with respect to the parameters `varied`; 0 at points that
  /// state the parameter themselves.
  FrictionWithDerivatives evaluate(const Eigen::VectorXd& coordinates,
                                   std::span<const int> varied) const;

  /// Returns computed minus measured friction at a point, over the point's error.
  double residual(const FrictionWithDerivatives& found, std::size_t i) const;

  double chiSquared(const FrictionWithDerivatives& found) const;

  /// Returns the root mean square of ln(computed / measured friction); infinite where some friction
  /// is not above 0.
  double logarithmicDistance(const FrictionWithDerivatives& found) const;

  void report(double chiSquared) const {
    if (options_.progress) options_.progress(evaluations_, chiSquared);
  }

  bool hasVelocityErrors() const;

  /// Adds the errors of the velocity to those of friction, by the slope of the computed curve
  /// (effective variance).
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
  bool hasErrors_;
  std::vector<int> all_;
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

/// Returns the sum of squares at some coordinates.
Minimum atCoordinates(const Objective& objective, const Eigen::VectorXd& coordinates);

/// The residuals that are squared and summed: the differences or, for an initial guess that is far
/// away, ln(computed / measured friction) over the point's relative error. Friction is close to a
/// product of powers of the parameters, so steps of logarithms converge from decades away, where
/// steps of differences exceed all limits.
enum class Distance { Difference, Logarithm };

/// The steps of a minimization from a start that may be far away.
inline constexpr int kFitIterations = 60;

/// Minimizes the sum of squares over the free parameters; the others are held fixed.
Minimum minimize(const Objective& objective, const Eigen::VectorXd& start,
                 const std::vector<int>& free, int iterations,
                 Distance distance = Distance::Difference);

Minimum findMinimum(const Objective& objective, const Eigen::VectorXd& start);

}  // namespace asperity
