#include "core/lesson/lesson_answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/accuracy/compute_curve.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/stop.h"
#include "core/friction/curve_features.h"
#include "core/friction/curve_file.h"
#include "core/friction/curve_quantity.h"
#include "core/scene/columns.h"
#include "core/scene/parameters.h"
#include "core/scene/sweep.h"

namespace asperity {
namespace {

constexpr int kShownDigits = 4;  // of a number in a message

std::string unitOfColumn(std::string_view name) {
  const auto column = std::ranges::find(kColumns, name, &Column::name);
  return column == kColumns.end() ? std::string() : std::string(column->unit);
}

double finite(double value, std::string_view column) {
  if (std::isfinite(value)) return value;
  throw InputError("", std::string(column), "has no value in this scene");
}

double stateValue(const Scene& scene, const std::string& column, const CurveOptions& options) {
  const Curve curve = computeCurveAt(scene, scene.sliding.velocity, options);
  if (!curve.isComplete) throw StopRequested{};
  return finite(curveValue(curve.points.front(), column), column);
}

/// Returns the maximum of a curve: that of the parabola through its highest points where the axis
/// is logarithmic and all values are positive, else the highest point.
CurveMaximum findMaximum(const Scene& scene, const std::string& column,
                         const CurveOptions& options) {
  const Curve curve = computeCurve(scene, options);
  if (!curve.isComplete) throw StopRequested{};
  std::vector<double> x, y;
  bool isPositive = true;
  for (const CurvePoint& point : curve.points) {
    const double value = curveValue(point, column);
    if (!std::isfinite(value)) continue;
    x.push_back(scene.sweep.isOfVelocity() ? point.velocity : point.swept);
    y.push_back(value);
    isPositive = isPositive && value > 0;
  }
  if (x.empty()) finite(kNotApplicable, column);
  const bool isAscending = std::ranges::is_sorted(x);
  if (x.size() >= 3 && isPositive && isAscending && scene.sweep.scale == SweepScale::Logarithmic)
    return curveMaximum(x, y);
  const auto highest = std::ranges::max_element(y) - y.begin();
  return {x[static_cast<std::size_t>(highest)], y[static_cast<std::size_t>(highest)]};
}

/// Returns the number itself, without the one by which it is divided.
double plainValue(const Scene& scene, const LessonValue& value, const CurveOptions& options) {
  const Scene changed = withKeys(scene, value.set);
  switch (value.kind) {
    case LessonValue::Kind::State:
      return stateValue(changed, value.column, options);
    case LessonValue::Kind::Peak:
      return findMaximum(changed, value.column, options).x;
    case LessonValue::Kind::Exponent:
      break;
  }
  double logs[2] = {0, 0};
  const double ends[2] = {value.from, value.to};
  for (int i = 0; i < 2; ++i) {
    const Scene end = withKeys(changed, {value.key + "=" + plainNumber(ends[i])});
    const double at = stateValue(end, value.column, options);
    if (!(at > 0)) throw InputError("", value.column, "is not above 0, so that it has no exponent");
    logs[i] = std::log(at);
  }
  return (logs[1] - logs[0]) / std::log(ends[1] / ends[0]);
}

/// Returns the answer to a point: the height of the curve at x, or its largest value.
void computePoint(const LessonStep& step, const CurveOptions& options, LessonAnswer& answer) {
  const LessonPrediction& prediction = *step.prediction;
  const std::string column(quantityEntry(*findQuantity(step.show.quantity)).word.text());
  if (prediction.x) {
    answer.x.value = *prediction.x;
    answer.number.value = stateValue(sceneAt(step.scene, *prediction.x), column, options);
  } else {
    const CurveMaximum maximum = findMaximum(step.scene, column, options);
    answer.x.value = maximum.x;
    answer.number.value = maximum.value;
  }
  answer.x.unit = std::string(sweptParameter(step.scene).unit);
  answer.number.unit = unitOfColumn(column);
}

bool isWithinFactor(double given, double answer, double tolerance) {
  return given > 0 && answer > 0 && given <= answer * (1 + tolerance) &&
         answer <= given * (1 + tolerance);
}

}  // namespace

bool GivenAnswer::isGiven() const {
  return choice >= 0 || !std::isnan(number);
}

int rightChoice(const LessonPrediction& prediction, const LessonNumber& number) {
  for (std::size_t i = 0; i < prediction.choices.size(); ++i) {
    const LessonChoice& choice = prediction.choices[i];
    if (prediction.answer ? number.value >= choice.above && number.value < choice.below
                          : choice.isRight)
      return static_cast<int>(i);
  }
  throw InputError("", "choices",
                   message("none of them covers the computed answer, {}",
                           plain(roundedToDigits(number.value, kShownDigits))));
}

bool leavesOutNumbers(const LessonPrediction& prediction) {
  if (prediction.kind != PredictionKind::Choice || !prediction.answer) return false;
  std::vector<LessonChoice> choices = prediction.choices;
  std::ranges::sort(choices, {}, &LessonChoice::above);
  double covered = -std::numeric_limits<double>::infinity();  // all numbers below it are
  for (const LessonChoice& choice : choices) {
    if (choice.above > covered) return true;
    covered = std::max(covered, choice.below);
  }
  return covered < std::numeric_limits<double>::infinity();
}

void checkChoices(const Lesson& lesson, const std::string& file, const CurveOptions& options) {
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const LessonStep& step = lesson.steps[i];
    if (!step.prediction || !leavesOutNumbers(*step.prediction)) continue;
    try {
      rightChoice(*step.prediction,
                  computeLessonValue(step.scene, *step.prediction->answer, options));
    } catch (const InputError& error) {
      throw InputError(file, fmt::format("steps[{}].prediction.{}", i, error.key()),
                       error.message());
    }
  }
}

std::string lessonValueUnit(const LessonValue& value, const Scene& scene) {
  if (!value.over.empty() || value.kind == LessonValue::Kind::Exponent) return {};
  if (value.kind == LessonValue::Kind::Peak)
    return std::string(sweptParameter(withKeys(scene, value.set)).unit);
  return unitOfColumn(value.column);
}

LessonNumber computeLessonValue(const Scene& scene, const LessonValue& value,
                                const CurveOptions& options) {
  LessonNumber number{plainValue(scene, value, options), lessonValueUnit(value, scene)};
  if (value.over.empty()) return number;
  const double under = plainValue(scene, value.over.front(), options);
  if (under == 0) throw InputError("", value.over.front().column, "is 0, so that it has no ratio");
  number.value = finite(number.value / under, value.column);
  return number;
}

LessonAnswer lessonAnswer(const LessonStep& step, const CurveOptions& options) {
  LessonAnswer answer;
  if (!step.prediction) return answer;
  const LessonPrediction& prediction = *step.prediction;
  if (prediction.answer)
    answer.number = computeLessonValue(step.scene, *prediction.answer, options);
  if (prediction.kind == PredictionKind::Choice)
    answer.choice = rightChoice(prediction, answer.number);
  if (prediction.kind == PredictionKind::Point) computePoint(step, options, answer);
  for (const NamedLessonValue& value : step.values)
    answer.values.emplace_back(value.name, computeLessonValue(step.scene, value.value, options));
  return answer;
}

bool isRight(const LessonPrediction& prediction, const LessonAnswer& answer,
             const GivenAnswer& given) {
  if (!given.isGiven()) return false;
  switch (prediction.kind) {
    case PredictionKind::Choice:
      return given.choice == answer.choice;
    case PredictionKind::Number:
      return std::isfinite(given.number) &&
             std::abs(given.number - answer.number.value) <=
                 prediction.tolerance * std::abs(answer.number.value);
    case PredictionKind::Point:
      break;
  }
  return isHeightRight(prediction, answer, given) && isPlaceRight(prediction, answer, given);
}

bool isHeightRight(const LessonPrediction& prediction, const LessonAnswer& answer,
                   const GivenAnswer& given) {
  return std::isfinite(given.number) &&
         isWithinFactor(given.number, answer.number.value, prediction.tolerance);
}

bool isPlaceRight(const LessonPrediction& prediction, const LessonAnswer& answer,
                  const GivenAnswer& given) {
  return prediction.x ||
         (std::isfinite(given.x) && isWithinFactor(given.x, answer.x.value, prediction.xTolerance));
}

std::string withValues(const std::string& text, const LessonPrediction& prediction,
                       const LessonAnswer& answer, const GivenAnswer& given,
                       std::string_view language,
                       const std::function<std::string(const LessonNumber&)>& formatNumber) {
  const auto choiceText = [&](int choice) {
    return choice < 0 || choice >= static_cast<int>(prediction.choices.size())
               ? std::string("–")
               : prediction.choices[static_cast<std::size_t>(choice)].text.in(language);
  };
  // "{part%}" is the value in per cent.
  const auto formatted = [&](LessonNumber number, bool inPercent) {
    if (!inPercent) return formatNumber(number);
    number.value *= 100;
    return formatNumber(number) + "\u00A0%";
  };
  const auto valueOf = [&](std::string_view name) -> std::optional<std::string> {
    const bool inPercent = name.ends_with('%');
    if (inPercent) name.remove_suffix(1);
    if (name == "given") {
      if (prediction.kind == PredictionKind::Choice) return choiceText(given.choice);
      return formatted({given.number, answer.number.unit}, inPercent);
    }
    if (name == "answer" && prediction.kind == PredictionKind::Choice && !prediction.answer)
      return choiceText(answer.choice);
    if (name == "answer") return formatted(answer.number, inPercent);
    for (const auto& [known, number] : answer.values)
      if (known == name) return formatted(number, inPercent);
    return std::nullopt;
  };
  std::string filled;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t open = text.find('{', begin);
    const std::size_t close = open == text.npos ? open : text.find('}', open);
    if (close == text.npos) {
      filled += text.substr(begin);
      break;
    }
    filled += text.substr(begin, open - begin);
    const auto value = valueOf(std::string_view(text).substr(open + 1, close - open - 1));
    filled += value ? *value : text.substr(open, close - open + 1);
    begin = close + 1;
  }
  return filled;
}

}  // namespace asperity
