// Derivatives of friction by the parameters of a scene, by central differences on common random
// lines: the lines of both sides are the same, so that their scatter cancels. One function for
// fits, sensitivities and whoever else needs them.
// Failure: as slideStates; a stopped computation throws StopRequested.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/friction/steady_states.h"
#include "core/friction/study.h"
#include "core/scene/parameters.h"

namespace asperity {

/// A parameter of a scene on the axis on which it is varied: its logarithm where its slider is
/// logarithmic and the value is above 0, else the value itself.
class VariedParameter {
 public:
  /// low, high: limits of the value, within what the parameter allows. Throws InputError with the
  /// key where it is no number, has no meaning in the scene, or its value lies outside the limits.
  VariedParameter(std::string_view key, const Scene& scene);
  VariedParameter(std::string_view key, const Scene& scene, double low, double high);

  std::string_view key() const { return row_->key; }
  const Parameter& row() const { return *row_; }
  bool isLogarithmic() const { return isLogarithmic_; }

  /// The value from its coordinate on the axis, and back.
  double value(double coordinate) const;
  double coordinate(double value) const;
  double lowest() const { return coordinate(low_); }
  double highest() const { return coordinate(high_); }
  /// How far a difference reaches to each side: a thousandth of the value, or of the range of a
  /// linear slider. Second-order differences are then good to some 1e-6.
  double step() const { return step_; }

  double valueIn(const Scene& scene) const;  // the value in a scene
  void set(Scene& scene, double coordinate) const;

 private:
  const Parameter* row_;
  double low_ = 0, high_ = 0;
  bool isLogarithmic_ = false;
  double step_ = 1e-3;
};

/// Reads "KEY" or "KEY=LOW:HIGH", whose limits may have units. Throws InputError with the key, or
/// with --vary.
VariedParameter parseVariedParameter(const std::string& text, const Scene& scene);

/// Reads several. Throws InputError (--vary) where there is none, or a key stands twice.
std::vector<VariedParameter> parseVariedParameters(const std::vector<std::string>& texts,
                                                   const Scene& scene);

/// Returns the numbers that steady friction at one velocity may depend on, in the table's order.
/// What is 0 is an effect that is switched off, and left out.
std::vector<VariedParameter> activeParameters(const Scene& scene);

/// States the resolution that the scene leaves to the program, so that it does not change where
/// other parameters do.
void fixResolution(Scene& scene);

/// Friction as a person measures it: of deformation and interface together.
double totalMu(const CurvePoint& point);

/// States with the friction of their lines (deformation and interface together), and how it changes
/// with the place of each parameter.
struct FrictionWithDerivatives {
  std::vector<CurvePoint> points;                               // [state]
  std::vector<std::vector<double>> muOfLines;                   // [state][line]
  std::vector<std::vector<std::vector<double>>> slopesOfLines;  // [parameter][state][line]
};

/// `states` are slid with the parameters at their own values, and at a step to each side of them;
/// where a limit is nearer than a step, to the other side alone. Beyond the limits slopes are 0.
FrictionWithDerivatives frictionWithDerivatives(std::span<const Scene> states,
                                                std::span<const VariedParameter> parameters,
                                                const StateOptions& options);

/// d ln mu / d ln p at the scene's velocity, or d ln mu / d p for parameters that may be 0 or
/// negative; of mu with what the interface adds.
struct Sensitivity {
  std::string_view key;
  bool isLogarithmic = true;
  Estimate slope;  // its error is that of the mean over the lines
};

/// Returns one for every number that has a meaning in the scene and changes its friction at one
/// velocity.
std::vector<Sensitivity> sensitivities(const Scene& scene, const StateOptions& options = {});

}  // namespace asperity
