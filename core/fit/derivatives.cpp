#include "core/fit/derivatives.h"

#include <algorithm>
#include <cmath>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/stop.h"
#include "core/base/text.h"
#include "core/material/temperature_shift.h"
#include "core/scene/scene_check.h"
#include "core/scene/sweep.h"

namespace asperity {
namespace {

constexpr double kStep = 1e-3;

/// Returns the keys of the numbers on which friction depends in the scene, with local friction,
/// which a fit can add to a scene that has none.
Message keysToVary(const Scene& scene) {
  std::vector<std::string_view> keys;
  for (const VariedParameter& parameter : activeParameters(scene)) keys.push_back(parameter.key());
  if (!hasLocalFriction(scene)) keys.emplace_back("interface.friction_coefficient");
  return namesWithCommas(keys);
}

const Parameter& realRow(std::string_view key, const Scene& scene) {
  const Parameter& row = knownParameter(key);
  if (!std::holds_alternative<RealField>(row.field))
    throw InputError(
        "", std::string(key),
        message("is not a real number, and only these can be varied; allowed in this scene: {}",
                keysToVary(scene)));
  if (!isApplicable(row, scene))
    throw InputError("", std::string(key),
                     message("has no meaning in this scene; allowed: {}", keysToVary(scene)));
  return row;
}

}  // namespace

VariedParameter::VariedParameter(std::string_view key, const Scene& scene)
    : VariedParameter(key, scene, allowedRange(realRow(key, scene))->minimum,
                      allowedRange(realRow(key, scene))->maximum) {}

VariedParameter::VariedParameter(std::string_view key, const Scene& scene, double low, double high)
    : row_(&realRow(key, scene)), low_(low), high_(high) {
  const AllowedRange allowed = *allowedRange(*row_);
  if (!(low < high) || low < allowed.minimum || high > allowed.maximum)
    throw InputError(
        "", std::string(key),
        message("{}:{} is not a range within {}", plain(low), plain(high), allowedText(*row_)));
  const double now = valueIn(scene);
  if (now < low || now > high)
    throw InputError(
        "", std::string(key),
        message("the scene's {} is outside {} to {}", plain(now), plain(low), plain(high)));
  const auto& field = std::get<RealField>(row_->field);
  isLogarithmic_ = field.scale != Scale::Linear && now > 0;
  if (field.scale == Scale::LogarithmicFromNone && now == 0)
    throw InputError("", std::string(key),
                     "is 0, which means none; it needs a value to begin from");
  if (isLogarithmic_) {
    // On a logarithmic axis the lowest value is above 0.
    constexpr double kMinPart = 1e-12;
    low_ = std::max(low_, kMinPart * now);
  } else {
    step_ = kStep * (field.sliderTo - field.sliderFrom);
  }
}

double VariedParameter::value(double coordinate) const {
  return std::clamp(isLogarithmic_ ? std::exp(coordinate) : coordinate, low_, high_);
}

double VariedParameter::coordinate(double value) const {
  return isLogarithmic_ ? std::log(value) : value;
}

double VariedParameter::valueIn(const Scene& scene) const {
  return std::get<double>(parameterValue(*row_, scene));
}

void VariedParameter::set(Scene& scene, double coordinate) const {
  setValue(*row_, scene, value(coordinate));
}

namespace {

/// Reads "KEY" or "KEY=LOW:HIGH".
VariedParameter parseVariedParameter(const std::string& text, const Scene& scene) {
  const std::size_t equals = text.find('=');
  const std::string key = text.substr(0, equals);
  if (equals == text.npos) return {key, scene};
  const std::string range = text.substr(equals + 1);
  const std::size_t colon = range.find(':');
  if (colon == range.npos)
    throw InputError("", "--vary", message("'{}' is not KEY or KEY=LOW:HIGH", shortened(text)));
  const Parameter& row = numberRow(key);
  return {key, scene, parseNumber(row, range.substr(0, colon)),
          parseNumber(row, range.substr(colon + 1))};
}

}  // namespace

std::vector<VariedParameter> parseVariedParameters(const std::vector<std::string>& texts,
                                                   const Scene& scene) {
  if (texts.empty()) throw InputError("", "--vary", "no key is given");
  std::vector<VariedParameter> varied;
  for (const std::string& text : texts) {
    varied.push_back(parseVariedParameter(text, scene));
    for (std::size_t i = 0; i + 1 < varied.size(); ++i)
      if (varied[i].key() == varied.back().key())
        throw InputError("", "--vary", message("{} is given more than once", varied.back().key()));
  }
  return varied;
}

std::vector<VariedParameter> activeParameters(const Scene& scene) {
  std::vector<VariedParameter> active;
  for (const Parameter& row : parameters()) {
    const std::string_view section = row.key.substr(0, row.key.find('.'));
    const bool isOfTheState = section == "surface" || section == "elastomer" || section == "load" ||
                              section == "interface" || row.key == kVelocityKey;
    // The measured range of a rubber tells where its moduli are known, and changes no friction.
    const bool isOfTheMeasurement = row.key.starts_with("elastomer.measured.");
    if (!isOfTheState || isOfTheMeasurement || !std::holds_alternative<RealField>(row.field) ||
        !whyNotSwept(row, scene).empty() || std::get<double>(parameterValue(row, scene)) == 0)
      continue;
    active.emplace_back(row.key, scene);
  }
  return active;
}

namespace {

/// Returns the coordinate of a state, moved to one side (-1 or 1) by the step of a difference.
/// Where that would shift the relaxation times by more than a step, as temperatures do, it moves so
/// much less. Where the shift ends, at the last row of a table or at the largest shift, it stays.
double besideState(const VariedParameter& parameter, const Scene& state, double side) {
  const double here = parameter.coordinate(parameter.valueIn(state));
  const double shiftHere = temperatureShift(state.elastomer);
  double step = side * parameter.step();
  // The second step is so short that only the end of a shift refuses it.
  constexpr int kTries = 2;
  for (int i = 0; i < kTries; ++i, step *= kStep) {
    const double there = std::clamp(here + step, parameter.lowest(), parameter.highest());
    Scene moved = state;
    parameter.set(moved, there);
    try {
      const double change = std::abs(std::log(temperatureShift(moved.elastomer) / shiftHere));
      return change > kStep ? here + (there - here) * (kStep / change) : there;
    } catch (const InputError&) {
      continue;
    }
  }
  return here;
}

}  // namespace

FrictionWithDerivatives frictionWithDerivatives(std::span<const Scene> states,
                                                std::span<const VariedParameter> parameters,
                                                const StateOptions& options) {
  // All states slide side by side: the given ones, then for each parameter those below and those
  // above. A resolution that the program chooses may change with a parameter, which would be a
  // jump.
  std::vector<Scene> all(states.begin(), states.end());
  for (Scene& state : all) fixResolution(state);
  std::vector<double> widths;  // [parameter][state]
  for (const VariedParameter& parameter : parameters)
    for (const double side : {-1.0, 1.0})
      for (std::size_t i = 0; i < states.size(); ++i) {
        const double there = besideState(parameter, states[i], side);
        Scene state = all[i];
        parameter.set(state, there);
        all.push_back(std::move(state));
        widths.push_back(there);
      }
  StateOptions keeping = options;
  keeping.keepsLines = true;
  SteadyStates found = slideStates(all, keeping);
  if (!found.isComplete) throw StopRequested{};

  FrictionWithDerivatives result;
  const std::size_t n = states.size();
  result.points.assign(found.points.begin(), found.points.begin() + static_cast<std::ptrdiff_t>(n));
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    auto& slopes = result.slopesOfLines.emplace_back(n);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t below = (2 * k) * n + i, above = below + n;
      const double width = widths[above] - widths[below];
      const std::vector<double>& low = found.muOfLines[n + below];
      const std::vector<double>& high = found.muOfLines[n + above];
      for (std::size_t line = 0; line < low.size(); ++line)
        slopes[i].push_back(width > 0 ? (high[line] - low[line]) / width : 0);
    }
  }
  found.muOfLines.resize(n);
  result.muOfLines = std::move(found.muOfLines);
  found.orderedRows.resize(n);
  result.orderedRows = std::move(found.orderedRows);
  return result;
}

std::vector<Sensitivity> sensitivities(const Scene& scene, const StateOptions& options) {
  requireNoTarget(scene, "differences need the same lines on both sides");
  const std::vector<VariedParameter> parameters = activeParameters(scene);
  const FrictionWithDerivatives found = frictionWithDerivatives({&scene, 1}, parameters, options);
  std::vector<Sensitivity> all;
  const std::vector<double>& mu = found.muOfLines.front();
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const std::vector<double>& slopes = found.slopesOfLines[k].front();
    if (std::ranges::all_of(slopes, [](double slope) { return slope == 0; })) continue;
    // This is the ratio of two means over the same lines, with its error by leaving out one line at
    // a time.
    const auto read = [&](int leftOut) {
      double slope = 0, friction = 0;
      for (std::size_t line = 0; line < mu.size(); ++line) {
        if (static_cast<int>(line) == leftOut) continue;
        slope += slopes[line];
        friction += mu[line];
      }
      return slope / friction;
    };
    all.push_back({parameters[k].key(), parameters[k].isLogarithmic(),
                   jackknife(static_cast<int>(mu.size()), read, found.orderedRows.front())});
  }
  return all;
}

}  // namespace asperity
