#include "core/scene/sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/material/element_law.h"

namespace asperity {
namespace {

bool isWhole(const Parameter& parameter) {
  return std::holds_alternative<IntegerField>(parameter.field);
}

bool isNumber(const Parameter& parameter) {
  return allowedRange(parameter).has_value();
}

double numberOf(const Parameter& parameter, const Scene& scene) {
  const ParameterValue value = valueOf(parameter, scene);
  const auto* whole = std::get_if<std::int64_t>(&value);
  return whole ? static_cast<double>(*whole) : std::get<double>(value);
}

void setNumber(const Parameter& parameter, Scene& scene, double value) {
  setValue(parameter, scene, isWhole(parameter) ? std::round(value) : value);
}

/// What local friction amounts to, without what has no influence on it.
Interface effective(Interface interface) {
  const Interface none;
  if (interface.shearStress == 0) interface.shearVelocity = 0;
  if (interface.shearVelocity == 0) interface.shearWidth = none.shearWidth;
  return interface;
}

/// Returns whether two scenes are the same for friction in steady sliding.
bool slideAlike(const Scene& a, const Scene& b) {
  return a.surface == b.surface && a.load == b.load && a.accuracy == b.accuracy &&
         a.sliding.velocity == b.sliding.velocity &&
         effective(a.interface) == effective(b.interface) &&
         lawOf(a.elastomer) == lawOf(b.elastomer);
}

/// Returns whether friction depends on the parameter anywhere in the range of its slider.
bool hasInfluence(const Parameter& parameter, const Scene& scene) {
  std::array<double, 3> tried{};
  if (const auto* real = std::get_if<RealField>(&parameter.field))
    tried = {real->sliderFrom, real->sliderTo, std::midpoint(real->sliderFrom, real->sliderTo)};
  else if (const auto* whole = std::get_if<IntegerField>(&parameter.field))
    tried = {static_cast<double>(whole->sliderFrom), static_cast<double>(whole->sliderTo),
             static_cast<double>((whole->sliderFrom + whole->sliderTo) / 2)};
  return std::ranges::any_of(tried, [&](double value) {
    Scene other = scene;
    setNumber(parameter, other, value);
    try {
      return !slideAlike(scene, other);
    } catch (const InputError&) {
      return true;  // An elastomer that cannot be differs from one that can.
    }
  });
}

/// Returns the choice by which a row has no meaning; null where it is none of a kind.
const Parameter* decidingChoice(const Parameter& parameter, const Scene& scene) {
  const Parameter* choice = findParameter(parameter.applies.choiceKey);
  while (choice && !isApplicable(*choice, scene)) choice = findParameter(choice->applies.choiceKey);
  return choice;
}

Message whyInapplicable(const Parameter& parameter, const Scene& scene) {
  const Parameter* choice = decidingChoice(parameter, scene);
  if (!choice || choosesAccuracy(scene))
    return message("{} has no meaning in this scene", parameter.key);
  return message("{} has no meaning for {} {}", parameter.key, choice->key,
                 std::get<std::string>(valueOf(*choice, scene)));
}

/// Puts the last value on its place and returns the values.
std::vector<double> endingIn(std::vector<double> values, double to) {
  if (values.size() > 1) values.back() = to;
  return values;
}

double partOf(std::int64_t i, std::int64_t points) {
  return points > 1 ? static_cast<double>(i) / static_cast<double>(points - 1) : 0;
}

std::vector<double> spaced(double from, double to, const Sweep& sweep) {
  return sweep.scale == SweepScale::Linear ? linearSpaced(from, to, sweep.points)
                                           : logSpaced(from, to, sweep.points);
}

void checkEnd(const Parameter& parameter, const Scene& scene, const char* key, double value) {
  const AllowedRange allowed = *allowedRange(parameter);
  if (value < allowed.minimum || value > allowed.maximum)
    throw InputError(
        "", key,
        message("{} is outside {} of {}", plain(value), allowedText(parameter), parameter.key));
  if (scene.sweep.scale == SweepScale::Logarithmic && !(value > 0))
    throw InputError("", key,
                     message("{} has no place on a logarithmic axis; sweep.scale linear has room "
                             "for it",
                             plain(value)));
}

}  // namespace

std::vector<double> logSpaced(double from, double to, std::int64_t points) {
  std::vector<double> values;
  for (std::int64_t i = 0; i < points; ++i)
    values.push_back(from * std::pow(to / from, partOf(i, points)));
  return endingIn(std::move(values), to);
}

std::vector<double> linearSpaced(double from, double to, std::int64_t points) {
  std::vector<double> values;
  for (std::int64_t i = 0; i < points; ++i)
    values.push_back(from + (to - from) * partOf(i, points));
  return endingIn(std::move(values), to);
}

std::vector<double> sweepVelocities(const Sweep& sweep) {
  return spaced(sweep.velocityFrom, sweep.velocityTo, sweep);
}

const Parameter& sweptParameter(const Scene& scene) {
  if (const Parameter* row = findParameter(scene.sweep.key)) return *row;
  const std::string_view nearest = nearestKey(scene.sweep.key);
  throw InputError("", "sweep.key",
                   nearest.empty() ? message("{} is no key; 'asperity help check' lists all",
                                             shortened(scene.sweep.key))
                                   : message("{} is no key; the nearest known one is {}",
                                             shortened(scene.sweep.key), nearest));
}

std::vector<double> sweepValues(const Scene& scene) {
  const Sweep& sweep = scene.sweep;
  if (sweep.isOfVelocity()) return sweepVelocities(sweep);
  std::vector<double> values = spaced(sweep.from, sweep.to, sweep);
  if (!isWhole(sweptParameter(scene))) return values;
  for (double& value : values) value = std::round(value);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

Scene sceneAt(const Scene& scene, double value) {
  Scene state = scene;
  setNumber(sweptParameter(scene), state, value);
  state.sweep = {};
  return state;
}

double ownSweptValue(const Scene& scene) {
  return numberOf(sweptParameter(scene), scene);
}

Message whyNotSwept(const Parameter& parameter, const Scene& scene) {
  if (parameter.key == kVelocityKey) return {};
  if (!isNumber(parameter)) return message("{} is not a number", parameter.key);
  for (const std::string_view section : {"sweep.", "ensemble."})
    if (parameter.key.starts_with(section))
      return message("{} says how the curve is made, which cannot be its axis", parameter.key);
  if (!isApplicable(parameter, scene)) return whyInapplicable(parameter, scene);
  if (!hasInfluence(parameter, scene))
    return message("{} changes nothing in this scene", parameter.key);
  return {};
}

void checkSweep(const Scene& scene) {
  const Sweep& sweep = scene.sweep;
  if (sweep.isOfVelocity()) {
    if (sweep.velocityFrom > sweep.velocityTo)
      throw InputError(
          "", "sweep.velocity_from",
          message("{} is above sweep.velocity_to, {}", sweep.velocityFrom, sweep.velocityTo));
    return;
  }
  const Parameter& row = sweptParameter(scene);
  if (Message reason = whyNotSwept(row, scene); !reason.empty())
    throw InputError("", "sweep.key", std::move(reason));
  checkEnd(row, scene, "sweep.from", sweep.from);
  checkEnd(row, scene, "sweep.to", sweep.to);
}

}  // namespace asperity
