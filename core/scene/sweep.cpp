#include "core/scene/sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/material/element_law.h"
#include "core/scene/scene_check.h"

namespace asperity {
namespace {

/// Returns the local friction without the members that do not influence it.
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
         elementLaw(a.elastomer) == elementLaw(b.elastomer);
}

/// Returns whether friction depends on the parameter anywhere in the range of its slider.
bool hasInfluence(const Parameter& parameter, const Scene& scene) {
  const SliderRange slider = *sliderRange(parameter);
  const std::array tried{slider.from, slider.to, std::midpoint(slider.from, slider.to)};
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
                 std::get<std::string>(parameterValue(*choice, scene)));
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

std::vector<double> sweepVelocities(const Sweep& sweep) {
  return rangeValues({findParameter(kVelocityKey), sweep.velocityFrom, sweep.velocityTo,
                      sweep.points, sweep.scale == SweepScale::Logarithmic});
}

const Parameter& sweptParameter(const Scene& scene) {
  try {
    return knownParameter(scene.sweep.key);
  } catch (const InputError& error) {
    throw InputError("", "sweep.key", message("{}: {}", error.key(), error.message()));
  }
}

ParameterRange sweepRange(const Scene& scene) {
  const Sweep& sweep = scene.sweep;
  const bool isOfVelocity = sweep.isOfVelocity();
  return {&sweptParameter(scene), isOfVelocity ? sweep.velocityFrom : sweep.from,
          isOfVelocity ? sweep.velocityTo : sweep.to, sweep.points,
          sweep.scale == SweepScale::Logarithmic};
}

Scene sceneOver(const ParameterRange& range, Scene scene) {
  Sweep& sweep = scene.sweep;
  sweep = {};
  sweep.key = range.key();
  (sweep.isOfVelocity() ? sweep.velocityFrom : sweep.from) = range.from;
  (sweep.isOfVelocity() ? sweep.velocityTo : sweep.to) = range.to;
  sweep.points = range.points;
  sweep.scale = range.isLogarithmic ? SweepScale::Logarithmic : SweepScale::Linear;
  return scene;
}

std::vector<double> sweepValues(const Scene& scene) {
  return rangeValues(sweepRange(scene));
}

Scene sceneAt(const Scene& scene, double value) {
  Scene state = scene;
  setNumber(sweptParameter(scene), state, value);
  state.sweep = {};
  return state;
}

double ownSweptValue(const Scene& scene) {
  return parameterNumber(sweptParameter(scene), scene);
}

Scene withSweptValue(Scene scene, double value) {
  const Parameter& row = sweptParameter(scene);
  const AllowedRange allowed = *allowedRange(row);
  setNumber(row, scene, std::clamp(value, allowed.minimum, allowed.maximum));
  return scene;
}

namespace {

/// Returns whether this value of the parameter is possible in the scene.
bool canBe(const Parameter& parameter, const Scene& scene, double value) {
  try {
    Scene state = scene;
    setNumber(parameter, state, value);
    checkEffects(state);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

ParameterRange usualRange(const Parameter& parameter, const Scene& scene) {
  constexpr std::int64_t kPoints = 41;
  constexpr int kAttempts = 8;
  const AllowedRange allowed = *allowedRange(parameter);
  const double own = parameterNumber(parameter, scene);
  const auto [from, to, scale] = *sliderRange(parameter);
  ParameterRange range{&parameter, 0, 0, kPoints, scale != Scale::Linear};
  const bool isAround = range.isLogarithmic && own > 0;
  range.from =
      std::clamp(isAround ? own / kUsualRangeFactor : from, allowed.minimum, allowed.maximum);
  range.to = std::clamp(isAround ? own * kUsualRangeFactor : to, allowed.minimum, allowed.maximum);
  // A logarithmic slider may begin at "none", which has no logarithm.
  if (range.isLogarithmic && !(range.from > 0)) range.from = from;
  for (double* end : {&range.from, &range.to})
    for (int i = 0; i < kAttempts && !canBe(parameter, scene, *end); ++i)
      *end = isAround ? std::sqrt(*end * own) : (*end + own) / 2;
  if (isWholeNumber(parameter)) {
    range.from = std::round(range.from);
    range.to = std::round(range.to);
  }
  return range;
}

Scene withMeaningfulAxis(Scene scene) {
  if (scene.sweep.isOfVelocity()) return scene;
  const Parameter* row = findParameter(scene.sweep.key);
  if (row && whyNotSwept(*row, scene).empty()) return scene;
  const std::int64_t points = scene.sweep.points;
  scene.sweep = {};
  scene.sweep.points = points;
  return scene;
}

Scene canonicalCurveScene(Scene scene) {
  scene.title.clear();
  scene.description.clear();
  scene.chapter.clear();
  const double velocity = scene.sliding.velocity;
  scene.sliding = {};
  if (scene.sweep.isOfVelocity()) return scene;
  scene.sliding.velocity = velocity;
  const Parameter* row = findParameter(scene.sweep.key);
  if (!row || !isNumber(*row) || !isApplicable(*row, scene)) return scene;
  const AllowedRange allowed = *allowedRange(*row);
  setNumber(*row, scene, std::clamp(scene.sweep.from, allowed.minimum, allowed.maximum));
  return scene;
}

Message whyNotSwept(const Parameter& parameter, const Scene& scene) {
  if (parameter.key == kVelocityKey) return {};
  if (!isNumber(parameter)) return message("{} is not a number", parameter.key);
  for (const std::string_view section : {"sweep.", "ensemble."})
    if (parameter.key.starts_with(section))
      return message("{} says how the curve is made, which cannot be its axis", parameter.key);
  if (parameter.rule.isOfReading)
    return message("{} says how the file is read, which cannot be an axis", parameter.key);
  if (!isApplicable(parameter, scene)) return whyInapplicable(parameter, scene);
  if (!hasInfluence(parameter, scene))
    return message("{} changes nothing in this scene", parameter.key);
  return {};
}

Message whyNotBeside(const Parameter& parameter, const Scene& scene, const ParameterRange& other) {
  Message reason = whyNotSwept(parameter, scene);
  for (const double end : {other.from, other.to}) {
    if (reason.empty()) break;
    Scene there = scene;
    setNumber(*other.row, there, end);
    reason = whyNotSwept(parameter, there);
  }
  return reason;
}

void requireVelocityAxis(const Scene& scene, const Message& what) {
  if (!scene.sweep.isOfVelocity())
    throw InputError("", "sweep.key",
                     message("{} goes over velocities, not over {}", what, scene.sweep.key));
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
  if (scene.sliding.velocity == 0)
    throw InputError("", std::string(kVelocityKey),
                     message("is 0: a curve over {} slides at it, so it needs more", row.key));
  checkEnd(row, scene, "sweep.from", sweep.from);
  checkEnd(row, scene, "sweep.to", sweep.to);
}

}  // namespace asperity
