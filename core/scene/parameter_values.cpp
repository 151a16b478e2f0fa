// Reads and writes values of a scene through the rows of the table.
#include <algorithm>
#include <cmath>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/scene/list_text.h"
#include "core/scene/parameters.h"

namespace asperity {
namespace {

template <class... Handlers>
struct Overloaded : Handlers... {
  using Handlers::operator()...;
};
template <class... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;

/// Returns the scene for an accessor, which takes a Scene& but only reads it here.
Scene& forReading(const Scene& scene) {
  return const_cast<Scene&>(scene);
}

[[noreturn]] void refuse(const Parameter& parameter, Message message) {
  throw InputError("", std::string(parameter.key), std::move(message));
}

double numberFrom(const Parameter& parameter, const ParameterValue& value) {
  const double number =
      std::visit(Overloaded{[](double real) { return real; },
                            [](std::int64_t integer) { return static_cast<double>(integer); },
                            [&](const std::string& text) -> double {
                              refuse(parameter, message("'{}' is not a number; allowed is {}",
                                                        shortened(text), allowedText(parameter)));
                            }},
                 value);
  if (!std::isfinite(number))
    refuse(parameter, message("{} is not a finite number; allowed is {}", plain(number),
                              allowedText(parameter)));
  return number;
}

void checkRange(const Parameter& parameter, const Scene& scene, double number, double minimum,
                double maximum) {
  if ((number < minimum || number > maximum) && !isTakenFromSurfaceFile(parameter, scene, number))
    refuse(parameter, message("{} is outside {}", plain(number), allowedText(parameter)));
}

void setReal(const Parameter& parameter, const RealField& field, Scene& scene,
             const ParameterValue& value) {
  const double number = numberFrom(parameter, value);
  checkRange(parameter, scene, number, field.minimum, field.maximum);
  field.member(scene) = number;
}

void setInteger(const Parameter& parameter, const IntegerField& field, Scene& scene,
                const ParameterValue& value) {
  const auto* exact = std::get_if<std::int64_t>(&value);
  // A double would show an integer above 2^53 as its neighbour.
  if (exact && *exact > field.maximum)
    refuse(parameter, message("{} is outside {}", *exact, allowedText(parameter)));
  const double number = numberFrom(parameter, value);
  if (number != std::floor(number))
    refuse(parameter, message("{} is not a whole number; allowed is {}", plain(number),
                              allowedText(parameter)));
  checkRange(parameter, scene, number, static_cast<double>(field.minimum),
             static_cast<double>(field.maximum));
  field.member(scene) = static_cast<std::int64_t>(number);
}

void setChoice(const Parameter& parameter, const ChoiceField& field, Scene& scene,
               const ParameterValue& value) {
  const auto* word = std::get_if<std::string>(&value);
  auto found =
      word ? std::find(field.choices.begin(), field.choices.end(), *word) : field.choices.end();
  // People write the unit "um" with either micro sign.
  if (word && (*word == "\u00B5m" || *word == "\u03BCm"))
    found = std::find(field.choices.begin(), field.choices.end(), "um");
  if (word && (*word == "mils" || *word == "thou"))
    found = std::find(field.choices.begin(), field.choices.end(), "mil");
  if (found == field.choices.end()) {
    const Message allowed = allowedText(parameter);
    refuse(parameter, word ? message("'{}' is not {}", shortened(*word), allowed)
                           : message("a number is not {}", allowed));
  }
  field.write(scene, static_cast<int>(found - field.choices.begin()));
}

void setText(const Parameter& parameter, const TextField& field, Scene& scene,
             const ParameterValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  if (!text) refuse(parameter, "a number is not a text");
  field.member(scene) = *text;
}

/// Returns the JSON text of a list. Throws InputError for a number.
const std::string& listIn(const Parameter& parameter, const ParameterValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  if (!text) refuse(parameter, message("a number is not {}", allowedText(parameter)));
  return *text;
}

}  // namespace

bool isKind(const Parameter& parameter) {
  return std::holds_alternative<ChoiceField>(parameter.field) ||
         std::ranges::any_of(parameters(), [&](const Parameter& row) {
           return row.applies.choiceKey == parameter.key;
         });
}

bool isList(const Parameter& parameter) {
  return std::holds_alternative<ArmsField>(parameter.field) ||
         std::holds_alternative<ShiftTableField>(parameter.field) ||
         std::holds_alternative<ListField>(parameter.field);
}

bool isTakenFromSurfaceFile(const Parameter& parameter, const Scene& scene, double number) {
  if (number != 0) return false;
  if (parameter.zero == ZeroMeaning::EveryRow)
    return scene.surface.kind == SurfaceKind::Measured && !hasRandomPhases(scene.surface);
  return parameter.zero == ZeroMeaning::SizeOfFile && hasSurfaceFile(scene.surface);
}

namespace {

bool holds(const Applicability& applies, const Scene& scene) {
  const Parameter* choice = findParameter(applies.choiceKey);
  return isApplicable(*choice, scene) &&
         isOneOf(std::get<std::string>(parameterValue(*choice, scene)), WordList(applies.words)) !=
             applies.isExcept;
}

}  // namespace

bool isApplicable(const Parameter& parameter, const Scene& scene) {
  if (parameter.zero == ZeroMeaning::ChosenByScene && choosesAccuracy(scene)) return false;
  if (parameter.applies.choiceKey.empty() || holds(parameter.applies, scene)) return true;
  return !parameter.alsoApplies.choiceKey.empty() && holds(parameter.alsoApplies, scene);
}

Parameter parameterIn(const Parameter& row, const Scene& scene) {
  Parameter shown = row;
  if (row.key == kVelocityKey && scene.sliding.kind == SlidingKind::Oscillation)
    shown.label = "mean velocity";
  const bool isEndOfOtherAxis = row.applies.choiceKey == "sweep.key" && row.applies.isExcept;
  const Parameter* swept = isEndOfOtherAxis ? findParameter(scene.sweep.key) : nullptr;
  if (!swept || scene.sweep.isOfVelocity() || !isNumber(*swept)) return shown;
  shown.unit = swept->unit;
  shown.symbol = swept->symbol;
  const auto [minimum, maximum] = *allowedRange(*swept);
  const auto [from, to, scale] = *sliderRange(*swept);
  shown.field = RealField{std::get<RealField>(row.field).member, minimum, maximum, from, to, scale};
  return shown;
}

ParameterValue parameterValue(const Parameter& parameter, const Scene& scene) {
  return std::visit(
      Overloaded{
          [&](const RealField& field) -> ParameterValue { return field.member(forReading(scene)); },
          [&](const IntegerField& field) -> ParameterValue {
            return field.member(forReading(scene));
          },
          [&](const ChoiceField& field) -> ParameterValue {
            return std::string(field.choices[static_cast<std::size_t>(field.read(scene))]);
          },
          [&](const TextField& field) -> ParameterValue { return field.member(forReading(scene)); },
          [&](const ArmsField& field) -> ParameterValue {
            return listText(field.member(forReading(scene)));
          },
          [&](const ShiftTableField& field) -> ParameterValue {
            return listText(field.member(forReading(scene)));
          },
          [&](const ListField& field) -> ParameterValue { return field.read(scene); }},
      parameter.field);
}

ParameterValue defaultValue(const Parameter& parameter) {
  return parameterValue(parameter, Scene{});
}

void setValue(const Parameter& parameter, Scene& scene, const ParameterValue& value) {
  const std::string key(parameter.key);
  std::visit(
      Overloaded{
          [&](const RealField& field) { setReal(parameter, field, scene, value); },
          [&](const IntegerField& field) { setInteger(parameter, field, scene, value); },
          [&](const ChoiceField& field) { setChoice(parameter, field, scene, value); },
          [&](const TextField& field) { setText(parameter, field, scene, value); },
          [&](const ArmsField& field) {
            field.member(scene) = parseArms(listIn(parameter, value), key);
          },
          [&](const ShiftTableField& field) {
            field.member(scene) = parseShiftTable(listIn(parameter, value), key);
          },
          [&](const ListField& field) { field.write(scene, listIn(parameter, value), key); }},
      parameter.field);
}

void setFromText(const Parameter& parameter, Scene& scene, std::string_view text) {
  if (!isNumber(parameter)) return setValue(parameter, scene, std::string(text));
  if (std::int64_t whole = 0; isWholeNumber(parameter) && readNumber(text, whole))
    return setValue(parameter, scene, whole);
  const TypedQuantity typed = typedQuantity(text, quantityRule(parameter));
  if (typed.value) return setValue(parameter, scene, *typed.value);
  if (typed.isTooLarge)
    refuse(parameter, message("{} is beyond what a number can hold; allowed is {}", shortened(text),
                              allowedText(parameter)));
  if (!typed.refusal.empty()) refuse(parameter, typed.refusal);
  // NaN and infinity have a message of their own.
  if (double notFinite = 0; readNumber(text, notFinite)) setValue(parameter, scene, notFinite);
  setValue(parameter, scene, std::string(text));
}

QuantityRule quantityRule(const Parameter& parameter) {
  // The constant c2 of WLF is in kelvins, too, but is a difference of temperatures.
  const bool isAbsolute =
      parameter.key.ends_with("temperature") || parameter.symbol.starts_with('T');
  return {parameter.unit, parameter.unit == "K" && isAbsolute, isWholeNumber(parameter)};
}

const Parameter& numberRow(std::string_view key) {
  const Parameter& row = knownParameter(key);
  if (!isNumber(row)) refuse(row, "is not a number, so it has no range");
  return row;
}

double parseNumber(const Parameter& parameter, std::string_view text) {
  Scene scratch;
  setFromText(parameter, scratch, text);
  return parameterNumber(parameter, scratch);
}

double parameterNumber(const Parameter& parameter, const Scene& scene) {
  const ParameterValue value = parameterValue(parameter, scene);
  const auto* whole = std::get_if<std::int64_t>(&value);
  return whole ? static_cast<double>(*whole) : std::get<double>(value);
}

void setNumber(const Parameter& parameter, Scene& scene, double number) {
  setValue(parameter, scene, isWholeNumber(parameter) ? std::round(number) : number);
}

std::optional<AllowedRange> allowedRange(const Parameter& parameter) {
  if (const auto* real = std::get_if<RealField>(&parameter.field))
    return AllowedRange{real->minimum, real->maximum};
  if (const auto* whole = std::get_if<IntegerField>(&parameter.field))
    return AllowedRange{static_cast<double>(whole->minimum), static_cast<double>(whole->maximum)};
  return {};
}

bool isWholeNumber(const Parameter& parameter) {
  return std::holds_alternative<IntegerField>(parameter.field);
}

std::optional<SliderRange> sliderRange(const Parameter& parameter) {
  if (const auto* real = std::get_if<RealField>(&parameter.field))
    return SliderRange{real->sliderFrom, real->sliderTo, real->scale};
  if (const auto* whole = std::get_if<IntegerField>(&parameter.field))
    return SliderRange{static_cast<double>(whole->sliderFrom), static_cast<double>(whole->sliderTo),
                       whole->scale};
  return {};
}

bool hasLogarithmicSlider(const Parameter& parameter) {
  const auto slider = sliderRange(parameter);
  return slider && slider->scale != Scale::Linear;
}

Message allowedText(const Parameter& parameter) {
  return std::visit(Overloaded{[&](const RealField& field) {
                                 return rangeText(field.minimum, field.maximum, parameter.unit);
                               },
                               [](const IntegerField& field) {
                                 return message("{} to {}", field.minimum, field.maximum);
                               },
                               [](const ChoiceField& field) {
                                 const Message words = namesWithCommas(field.choices);
                                 return field.choices.size() > 1 ? message("one of {}", words)
                                                                 : words;
                               },
                               [](const TextField&) { return Message("text"); },
                               [](const ArmsField&) { return allowedArms(); },
                               [](const ShiftTableField&) { return allowedShiftTable(); },
                               [](const ListField& field) { return field.allowed(); }},
                    parameter.field);
}

}  // namespace asperity
