// Fits parameters of a scene to measured friction: weighted least squares on common random lines,
// so that the objective is smooth, by Levenberg and Marquardt's method within limits (Ceres
// Solver), with derivatives by differences (derivatives.h).
//
// Errors. With J the derivatives of the computed friction by the parameters' coordinates and W the
// weights, the estimate moves by (J'WJ)^-1 J'W times whatever the data and the computed means are
// wrong by. Both have a covariance: that of the measurement, and that of the mean over the fit's
// own lines, which all points share. So cov = (J'WJ)^-1 J'W (S_data + S_lines) WJ (J'WJ)^-1. Where
// the tables have no errors, all points have the same relative one, read from what the fit leaves;
// where their errors do not hold, they are scaled to it.
// Threading: a function of its arguments, which uses several threads; same bytes for any number.
// Failure: InputError for what cannot be varied or fitted; StopRequested where it was stopped.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/fit/derivatives.h"
#include "core/fit/friction_data.h"

namespace asperity {

struct FitOptions {
  int threads = 0;
  std::stop_token stop;
  /// Called with the sum of squares so far after each step; from one thread at a time.
  std::function<void(int evaluations, double chiSquared)> progress;
  bool hasProfiles = true;
};

struct FittedParameter {
  std::string key;
  bool isLogarithmic = true;
  double value = 0;          // in the unit of its key
  double standardError = 0;  // of the value's coordinate: of ln value where that is varied
  double low = 0, high = 0;  // value at one standard error to each side
  bool isAtLimit = false;
  bool isDetermined = true;  // false: the data leave it open by more than a factor of two
};

/// The least sum of squares with one parameter held, over its value: flat where the data say
/// nothing about it.
struct ObjectiveProfile {
  std::string key;
  std::vector<double> values, chiSquared;
};

/// A product of powers of the parameters (a sum for linear ones) and how well it is determined.
struct Combination {
  std::vector<double> exponents;  // of each parameter's coordinate; the largest is 1
  double standardError = 0;       // of the sum of exponent times coordinate
};

struct Fit {
  Scene scene;  // with the best values
  std::vector<FittedParameter> parameters;
  Eigen::MatrixXd correlation;            // of the coordinates
  std::vector<Combination> combinations;  // best determined first
  std::vector<ObjectiveProfile> profiles;
  std::vector<CurvePoint> computed;    // at the measured points
  std::vector<double> computedErrors;  // of those means, by the scatter of the lines
  std::vector<double> bandErrors;      // of the computed friction, by the errors of the parameters
  double chiSquared = 0;
  double relativeScatter = 0;  // of the points about the fit, where the tables have no errors
  /// The factor of the points' errors in those of the parameters: 1 where they hold. Without errors
  /// theirs are 100 %, and this is the relative scatter.
  double errorScale = 1;
  std::int64_t freedom = 0;  // points minus parameters
  bool hasConverged = false;
  /// Whether the points lie further from the curve than their errors and the scatter of the lines
  /// say.
  bool missesPoints = false;
  /// false: friction differs from the points by more than a factor of two (root mean square of its
  /// logarithm). Then values and errors are those of no minimum that anyone looks for.
  bool hasFoundPoints = true;
  int evaluations = 0;
  std::vector<Message> notes;
};

/// Throws InputError for what cannot be fitted: no parameters, fewer points than parameters, a
/// parameter that every point states itself, tables with errors beside some without.
Fit fitFriction(const Scene& scene, std::span<const FrictionData> data,
                std::span<const VariedParameter> parameters, const FitOptions& options = {});

}  // namespace asperity
