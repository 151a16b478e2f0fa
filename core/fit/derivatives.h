// Derivatives of friction with respect to the parameters of a scene, by central differences on
// common random lines: both sides use the same lines, so that their scatter cancels. Fits and
// sensitivities use the same function.
// Failure: as slideStates; StopRequested where the computation was stopped.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/friction/jackknife.h"
#include "core/friction/steady_states.h"
#include "core/scene/parameters.h"

namespace asperity {

/// A parameter of a scene on the axis on which it is varied. Its coordinate is its logarithm where
/// its slider is logarithmic and the value is above 0, else the value itself.
class VariedParameter {
 public:
  /// low, high: limits of the value, within what the parameter allows. Throws InputError with the
  /// key where the parameter is no number, has no meaning in the scene, or has a value outside of
  /// the limits.
  VariedParameter(std::string_view key, const Scene& scene);
  VariedParameter(std::string_view key, const Scene& scene, double low, double high);

  std::string_view key() const { return row_->key; }
  const Parameter& row() const { return *row_; }
  bool isLogarithmic() const { return isLogarithmic_; }

  /// Return the value of a coordinate, and the coordinate of a value.
  double value(double coordinate) const;
  double coordinate(double value) const;
  double lowest() const { return coordinate(low_); }
  double highest() const { return coordinate(high_); }
  /// Returns the longest step of a difference to each side: a thousandth of the value, or of the
  /// range of a linear slider. Central differences are then accurate to about 1e-6.
  double step() const { return step_; }

  double valueIn(const Scene& scene) const;  // the value in a scene
  void set(Scene& scene, double coordinate) const;

 private:
  const Parameter* row_;
  double low_ = 0, high_ = 0;
  bool isLogarithmic_ = false;
  double step_ = 1e-3;
};

/// Reads parameters given as "KEY" or "KEY=LOW:HIGH"; the limits may have units. Throws InputError
/// with the key, or with --vary where a text is neither, there is none, or a key occurs twice.
std::vector<VariedParameter> parseVariedParameters(const std::vector<std::string>& texts,
                                                   const Scene& scene);

/// Returns the numbers on which steady friction at one velocity may depend, in the table's order. A
/// parameter that is 0 is an effect that is switched off, and left out.
std::vector<VariedParameter> activeParameters(const Scene& scene);

/// The friction of states on each of their lines (deformation and interface together), and its
/// derivative with respect to the coordinate of each parameter.
struct FrictionWithDerivatives {
  std::vector<CurvePoint> points;                               // [state]
  std::vector<std::vector<double>> muOfLines;                   // [state][line]
  std::vector<std::int64_t> orderedRows;                        // LineSource::orderedRows()
  std::vector<std::vector<std::vector<double>>> slopesOfLines;  // [parameter][state][line]
};

/// Slides `states` with the parameters at their own values and at a step to each side of them;
/// where a limit is nearer than a step, to the other side only. Beyond the limits derivatives are
/// 0. A step of a temperature, or of what shifts the times with it, changes the relaxation times by
/// a thousandth at most; where the shift ends, the difference is to the other side, and 0 where a
/// table has one temperature alone.
FrictionWithDerivatives frictionWithDerivatives(std::span<const Scene> states,
                                                std::span<const VariedParameter> parameters,
                                                const StateOptions& options);

/// The derivative d ln mu / d ln p at the scene's velocity, or d ln mu / d p for parameters that
/// may be 0 or negative; mu includes the friction of the interface.
struct Sensitivity {
  std::string_view key;
  bool isLogarithmic = true;
  Estimate slope;  // its error is that of the mean over the lines
};

/// Returns the sensitivity to every number that has a meaning in the scene and influences its
/// friction at one velocity. Throws InputError where the scene has a target accuracy.
std::vector<Sensitivity> sensitivities(const Scene& scene, const StateOptions& options = {});

}  // namespace asperity
