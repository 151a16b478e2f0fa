#include "core/chart/curve_words.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/base/number_text.h"
#include "core/material/temperature_shift.h"

namespace asperity {
namespace {

/// Returns the table's symbol in printed letters.
std::string printedSymbol(std::string_view symbol) {
  constexpr std::pair<std::string_view, std::string_view> letters[] = {
      {"tau", "\u03C4"},           {"eta", "\u03B7"},
      {"kappa", "\u03BA"},         {"lambda_r", "\u03BB\u1D63"},
      {"G_inf", "G\u221E"},        {"F_N", "F\u2099"},
      {"C_1", "C\u2081"},          {"C_2", "C\u2082"},
      {"T_r", "T\u1D63"},          {"p_0", "p\u2080"},
      {"lambda_s", "\u03BB\u209B"}};
  for (const auto& [word, letter] : letters)
    if (symbol == word) return std::string(letter);
  return std::string(symbol);
}

/// Returns the parameter as text; empty where the row has no symbol, or the effect is not present.
Message inWords(const Parameter& row, const Scene& scene) {
  if (row.symbol.empty() || !isApplicable(row, scene)) return {};
  const ParameterValue value = parameterValue(row, scene);
  const auto* real = std::get_if<double>(&value);
  const auto* whole = std::get_if<std::int64_t>(&value);
  if (real && *real == 0 && (value == defaultValue(row) || isTakenFromSurfaceFile(row, scene, 0)))
    return {};
  if (real) return message("{} = {}", printedSymbol(row.symbol), printedValue(*real, row));
  if (whole && *whole > 0) return message("{} = {}", printedSymbol(row.symbol), *whole);
  return {};
}

/// Returns whether a row belongs to a temperature shift that shifts nothing.
bool isShiftIdle(const Parameter& row, const Scene& scene) {
  const bool shifts = row.key == "elastomer.temperature" || row.key.starts_with("elastomer.shift");
  return shifts && !shiftsTimes(scene.elastomer);
}

/// Returns the value, or the automatic choice where the scene leaves it open.
ParameterValue valueInCurve(const Parameter& row, const Scene& scene) {
  if (row.zero == ZeroMeaning::ChosenByScene) return curvePointsPerElement(scene);
  return parameterValue(row, scene);
}

/// Returns whether the value of the row means "as in the surface's file".
bool isGivenByFile(const Parameter& row, const Scene& scene) {
  const ParameterValue value = parameterValue(row, scene);
  const auto* whole = std::get_if<std::int64_t>(&value);
  const auto* real = std::get_if<double>(&value);
  return (whole || real) &&
         isTakenFromSurfaceFile(row, scene, whole ? static_cast<double>(*whole) : *real);
}

/// Returns "seed 3", "linear", "local shear = 2 N/m": rows without a symbol.
Message inPlainWords(const Parameter& row, const Scene& scene) {
  const ParameterValue value = valueInCurve(row, scene);
  const Message label(row.label);
  if (isGivenByFile(row, scene)) return message("{} as in the file", label);
  if (const auto* real = std::get_if<double>(&value))
    return message("{} = {}", label, printedValue(*real, row));
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return message("{} {}", label, *whole);
  std::string word = std::get<std::string>(value);
  if (!std::holds_alternative<ChoiceField>(row.field)) return message("{} {}", label, word);
  std::ranges::replace(word, '_', '-');
  return word;
}

/// Returns whether the friction curve of a scene is independent of the row: of texts, of what it
/// goes over, and of the motion; over another key than velocity it slides at a velocity.
bool isOfNoCurve(const Parameter& row, const Scene& scene) {
  if (row.key == scene.sweep.key) return true;
  if (row.key == kVelocityKey) return false;
  return row.key == "title" || row.key == "description" || row.key == "chapter" ||
         row.key.starts_with("sliding.");
}

/// Returns whether two scenes have different texts for a row.
bool differs(const Parameter& row, const Scene& scene, const Scene& from) {
  if (isOfNoCurve(row, scene) || !isApplicable(row, scene)) return false;
  // Only beside a line with a file is a length or a number left to the file a change.
  if (isGivenByFile(row, scene) && !isTakenFromSurfaceFile(row, from, 0)) return false;
  if (isShiftIdle(row, scene) && isShiftIdle(row, from)) return false;
  // A curve without a target has points per element and lines instead.
  if (row.key == "accuracy.target_relative_error" && !choosesAccuracy(scene)) return false;
  // What was chosen automatically in both scenes is no difference that a user made.
  if (parameterValue(row, scene) == parameterValue(row, from) &&
      parameterValue(row, scene) == defaultValue(row) && isApplicable(row, from))
    return false;
  return !isApplicable(row, from) || valueInCurve(row, scene) != valueInCurve(row, from);
}

}  // namespace

PrintedNumber printedValue(double value, const Parameter& row) {
  constexpr int kDigits = 6;
  if (quantityRule(row).isTemperature) return {celsius(value).english()};
  return row.unit.empty() ? printed(value, kDigits) : printed(value, row.unit);
}

Message parameterTitle(std::string_view key) {
  if (key == kVelocityKey) return "sliding velocity v";
  const Parameter& row = knownParameter(key);
  // "constant C1" names its symbol C_1 already.
  std::string plainSymbol(row.symbol);
  std::erase(plainSymbol, '_');
  if (row.symbol.empty() || row.label.ends_with(" " + plainSymbol)) return row.label;
  return message("{} {}", Message(row.label), printedSymbol(row.symbol));
}

Message describeParameter(std::string_view key, const Scene& scene) {
  const Parameter* row = findParameter(key);
  if (!row || isList(*row)) return {};
  const Message words = inWords(*row, scene);
  return words.empty() ? inPlainWords(*row, scene) : words;
}

Message describeParameters(const Scene& scene, const std::vector<std::string_view>& without) {
  std::vector<Message> parts;
  for (const Parameter& row : parameters()) {
    if (isOfNoCurve(row, scene) || isShiftIdle(row, scene)) continue;
    if (std::ranges::find(without, row.key) != without.end()) continue;
    if (Message words = inWords(row, scene); !words.empty()) parts.push_back(std::move(words));
  }
  return listed(parts);
}

Message describeScene(const Scene& scene, const std::vector<std::string_view>& without) {
  const Message parameters = describeParameters(scene, without);
  if (scene.title.empty()) return parameters;
  const Message name(scene.title);
  return parameters.empty() ? name : message("{}; {}", name, parameters);
}

Message describeDifferences(const Scene& scene, const Scene& from) {
  std::vector<Message> parts;
  for (const Parameter& row : parameters()) {
    if (!differs(row, scene, from)) continue;
    Message words = describeParameter(row.key, scene);
    if (words.empty())
      words = row.key == "elastomer.arms" ? Message("other arms") : Message("another shift table");
    parts.push_back(std::move(words));
  }
  return listed(parts);
}

}  // namespace asperity
