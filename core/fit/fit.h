// Fits parameters of a scene to measured friction by weighted least squares on common random lines,
// so that the objective is smooth: the method of Levenberg and Marquardt within limits (Ceres
// Solver), with derivatives by differences (derivatives.h).
//
// Errors. Let J be the derivatives of the computed friction with respect to the parameters'
// coordinates, and W the weights. If data and computed means have the errors e, the estimate has
// the error (J'WJ)^-1 J'W e. The covariance of e has two parts: that of the measurement, and that
// of the mean over the fit's own lines, which all points share. So cov = (J'WJ)^-1 J'W (S_data +
// S_lines) WJ (J'WJ)^-1. S_lines is larger than the scatter of the lines by the square of Student's
// factor, because few lines know their scatter badly. Where the tables have no errors, all points
// have the same relative error, which is estimated from the residuals and enlarged in the same way;
// where their errors do not hold, they are scaled to the residuals.
//
// Valleys. Where parameters can replace one another, the sum of squares is no parabola, and few
// lines make it uneven. The profiles follow such a valley: where a point of one lies lower than the
// minimum, the fit goes on from there, and the ranges reach to where the profiles have risen by one
// standard error. Without profiles, a fit may end in a hollow of the valley.
//
// Threading: a function of its arguments, which uses several threads; the bytes are the same for
// any number of them. Failure: InputError for what cannot be varied or fitted; StopRequested where
// the computation was stopped.
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
  double value = 0;  // in the unit of its key
  /// Of the coordinate: of ln value where that is varied. Where a profile is wider, half its range.
  double standardError = 0;
  /// The value at one standard error to each side, or further out where the profile of the sum of
  /// squares has risen by one standard error only there.
  double low = 0, high = 0;
  bool isWidened = false;  // by the profile
  bool isAtLimit = false;
  bool isDetermined = true;  // false: the data leave it open by more than a factor of two
};

/// The minimum of the sum of squares with one parameter held fixed, over its value: flat where the
/// data do not determine it.
struct ObjectiveProfile {
  std::string key;
  std::vector<double> values, chiSquared;
};

/// A product of powers of the parameters (a sum for linear ones) and how well it is determined.
struct Combination {
  std::vector<double> exponents;  // of each parameter's coordinate; the largest is 1
  double standardError = 0;       // of the sum of exponent times coordinate
};

/// What a minimum says about the errors of the fit.
struct FitErrors {
  Eigen::MatrixXd covariance;        // of the coordinates
  bool isByLines = false;            // the scatter of the lines is the larger part of some variance
  std::vector<CurvePoint> computed;  // at the measured points
  std::vector<double> computedErrors;  // of those means, by the scatter of the lines
  std::vector<double> bandErrors;      // of the computed friction, by the errors of the parameters
  double chiSquared = 0;
  double relativeScatter = 0;  // of the points about the fit, where the tables have no errors
  /// The factor by which the errors of the points are scaled: 1 where they hold. Without errors
  /// theirs are 100 %, and this is the relative scatter.
  double errorScale = 1;
  /// The factor by which the errors of the values are enlarged, because few residuals know the
  /// scatter of the points badly (Student); 1 where the tables have errors.
  double fewPointsFactor = 1;
  /// Whether the points are further from the curve than their errors and the scatter of the lines
  /// allow.
  bool missesPoints = false;
  /// false: friction differs from the points by more than a factor of two (root mean square of its
  /// logarithm), so that values and errors belong to no useful minimum.
  bool hasFoundPoints = true;
};

struct Fit : FitErrors {
  Scene scene;  // with the best values
  std::vector<FittedParameter> parameters;
  Eigen::MatrixXd correlation;            // of the coordinates
  std::vector<Combination> combinations;  // best determined first
  std::vector<ObjectiveProfile> profiles;
  std::int64_t degreesOfFreedom = 0;  // points minus parameters
  bool hasConverged = false;
  int evaluations = 0;
  std::vector<Message> warnings;  // what makes the values uncertain or wrong
  std::vector<Message> notes;     // how the tables were understood, and what the ranges mean
};

/// Returns "one degree of freedom" or "11 degrees of freedom".
Message degreesOfFreedom(std::int64_t count);

/// Fits the parameters. Throws InputError for what cannot be fitted: no parameters, fewer points
/// than parameters, a parameter that every point states itself, tables with errors beside tables
/// without.
Fit fitFriction(const Scene& scene, std::span<const FrictionData> data,
                std::span<const VariedParameter> parameters, const FitOptions& options = {});

}  // namespace asperity
