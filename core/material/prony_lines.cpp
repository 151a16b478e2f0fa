// Arms of a Prony series as named numbers, "G1 = 2 MPa" and "tau1 = 0.1 s", as people write them in
// notes, scripts and lists of parameters.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_clause.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/material/prony_table.h"

namespace asperity {
namespace {

enum class ArmPart { Modulus, Time, Viscosity };

/// A number that a line states of an arm.
struct ArmNumber {
  ArmPart part = ArmPart::Modulus;
  std::string index{};  // "1" of "G_1"; empty where the name has none
  std::string name{};   // "G_i"
  std::string unit{};
  double number = 0;
  std::size_t line = 0;

  std::string written() const { return nameWith(index); }
  /// Returns the name of this part of another arm: "G_2".
  std::string nameWith(const std::string& other) const {
    return name.ends_with("_i") ? name.substr(0, name.size() - 1) + other : name + " " + other;
  }
};

/// A name, a number and its unit in a line.
struct NamedNumber {
  std::string name{};
  TextQuantity quantity{};
  bool isMarkUnclear = false;  // the comma may separate decimals or thousands
};

/// Returns the unit after a number without brackets, quotes and comments: "[MPa] "branch 1"", "; %
/// Pa", "MPa".
std::string cleanUnit(std::string_view text) {
  text = text.substr(std::min(text.find_first_not_of(" ;,#%/\t"), text.size()));
  if (text.starts_with('[')) text = text.substr(0, text.find(']') + 1);
  return std::string(withoutEnd(withoutBrackets(text.substr(0, text.find('"'))), " ;,."));
}

/// Returns the fields of a line that has neither "=" nor ":", "G1;2;MPa" or "G1 2[MPa]".
std::vector<std::string_view> fieldsOf(std::string_view line) {
  std::vector<std::string_view> fields;
  for (const auto separator :
       {TextDialect::Separator::Semicolon, TextDialect::Separator::Tab, TextDialect::Separator::Bar,
        TextDialect::Separator::Comma, TextDialect::Separator::Blanks}) {
    splitFields(line, separator, fields);
    if (fields.size() > 1) break;
  }
  for (std::string_view& field : fields) field = trimmedField(field);
  return fields;
}

/// Returns the names and numbers that a line states.
std::vector<NamedNumber> namedNumbers(std::string_view line) {
  std::vector<NamedNumber> found;
  const auto add = [&found](std::string_view name, std::string_view number, std::string_view unit) {
    auto quantity = parseQuantity(number);
    if (!quantity) return;
    quantity->unit = cleanUnit(quantity->unit.empty() ? unit : quantity->unit);
    const bool isUnclear = std::abs(quantity->number) >= 1 && parseQuantity(number, '.')->isGrouped;
    found.push_back({std::string(trimmedField(name)), std::move(*quantity), isUnclear});
  };
  if (keyEnd(line) != line.npos) {
    const std::vector<std::string_view> clauses = splitClauses(line);
    for (std::size_t i = 0; i < clauses.size(); ++i)
      for (const std::string_view statement : splitStatements(clauses[i])) {
        const std::size_t end = statement.find_last_of(":=");
        if (end == statement.npos) continue;
        // The unit may stand in a comment behind it: "G1 = 2e6;  % Pa".
        const bool isCommented =
            i + 1 < clauses.size() && beginsWithOneOf(clauses[i + 1], "% # //");
        add(keyBefore(statement.substr(0, end)), statement.substr(end + 1),
            isCommented ? clauses[i + 1] : std::string_view());
      }
    return found;
  }
  const std::vector<std::string_view> fields = fieldsOf(line);
  if (fields.size() > 1) add(fields[0], fields[1], fields.size() > 2 ? fields[2] : "");
  return found;
}

/// Returns the numbers of a list, "G = [2e6, 1e6]", named in their order: "G1", "G2".
std::vector<NamedNumber> listedNumbers(std::string_view line) {
  const std::size_t end = line.find('='), open = line.find('[', end), close = line.find(']', open);
  if (close == line.npos || line.substr(end, open - end).find_first_of("0123456789") != line.npos)
    return {};
  std::string numbers(line.substr(open + 1, close - open - 1));
  std::ranges::replace(numbers, ',', ' ');
  std::ranges::replace(numbers, ';', ' ');
  const std::string key(trimmedField(line.substr(0, end)));
  const std::string unit = cleanUnit(withoutEnd(line.substr(close + 1), ")"));
  std::vector<NamedNumber> found;
  for (const std::string_view word : WordList(std::string_view(numbers))) {
    double number = 0;
    if (!readTextNumber(word, '.', number)) return {};
    found.push_back({key + std::to_string(found.size() + 1), {number, unit}});
  }
  return found;
}

/// Returns what a name and its number state of an arm; nothing where they state something else.
std::optional<ArmNumber> armNumber(const NamedNumber& named, std::size_t line) {
  TextColumn key = parseColumnName(named.name);
  if (areDigits(key.unit)) key = {key.name + key.unit, {}};  // "G(1)"
  const std::string word = seriesWord(key.name);
  const std::size_t digits = word.find_last_not_of("0123456789") + 1;
  std::string base = word.substr(0, digits);
  if (base.empty() || isInstantaneous(word) || isEquilibrium(word)) return {};
  ArmNumber arm;
  arm.unit = named.quantity.unit.empty() ? key.unit : named.quantity.unit;
  if (base == "t" && timeSize(arm.unit)) base = "tau";
  if (isRelaxationTime(base))
    arm.part = ArmPart::Time;
  else if (isArmViscosity(base))
    arm.part = ArmPart::Viscosity;
  else if (!isArmModulus(base))
    return {};
  arm.index = word.substr(digits);
  // Capital letters are those of moduli, small ones those of parts.
  const bool isSmall = key.name.starts_with('g') || key.name.starts_with('e');
  // "tau_i" may name the list of all of them.
  const bool hasIndex = isOneOf(base, "gi ei taui etai");
  if (hasIndex) base.pop_back();
  arm.name = (arm.part == ArmPart::Modulus && base.size() == 1 && !isSmall
                  ? std::string(1, static_cast<char>(base.front() - 'a' + 'A'))
                  : base) +
             "_i";
  // "Modulus 1" has no symbol.
  if (arm.part == ArmPart::Modulus && !isArmModulus(arm.name)) arm.name = base;
  arm.number = named.quantity.number;
  arm.line = line;
  return arm;
}

/// What the lines of a text state of arms, and all else as lines above a table.
struct StatedArms {
  std::vector<ArmNumber> numbers{};
  std::vector<TextEntry> others{};
  bool isMarkUnclear = false;  // some number is such as "1,000"
};

/// Numbers the arm whose parts a line states without an index, as in "Arm 1: G = 2 MPa, tau = 0.1
/// s". Returns false where the parts are none of an arm.
bool numberArm(std::vector<ArmNumber>& parts, std::size_t number) {
  const bool isArm = parts.size() == 2 && parts[0].part != parts[1].part &&
                     parts[0].index.empty() && parts[1].index.empty();
  for (ArmNumber& part : parts)
    if (isArm) part.index = std::to_string(number);
  return std::ranges::none_of(parts, [](const ArmNumber& one) { return one.index.empty(); });
}

StatedArms statedArms(std::string_view text) {
  StatedArms stated;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = withoutCommentMark(takeLine(text), {});
    std::vector<TextEntry> others;
    std::vector<ArmNumber> parts;
    std::vector<NamedNumber> all = listedNumbers(line);
    if (all.empty() || !armNumber(all.front(), number)) all = namedNumbers(line);
    for (const NamedNumber& named : all) {
      if (auto part = armNumber(named, number)) {
        parts.push_back(std::move(*part));
        stated.isMarkUnclear = stated.isMarkUnclear || named.isMarkUnclear;
        continue;
      }
      const std::string value = plain(named.quantity.number).text + " " + named.quantity.unit;
      others.push_back({named.name, value, number, std::string(line)});
    }
    if (numberArm(parts, stated.numbers.size() / 2 + 1)) {
      std::ranges::move(parts, std::back_inserter(stated.numbers));
    } else {
      parts.clear();
      others.clear();
    }
    if (parts.empty() && others.empty() && !trimmedBlanks(line).empty())
      others.push_back(parseEntry({line, number}, {}));
    std::ranges::move(others, std::back_inserter(stated.others));
  }
  return stated;
}

/// One number of each arm, in the order of the arms.
using ArmColumn = std::vector<const ArmNumber*>;

/// Returns the column of a table of such numbers, in their unit or, where they have several, in SI
/// units, and changes the numbers accordingly. Throws InputError where some have no unit.
TextColumn unifiedColumn(const ArmColumn& arms, const std::string& name,
                         std::vector<double>& numbers) {
  const ArmNumber& first = *arms.front();
  const bool isOne =
      std::ranges::all_of(arms, [&first](const ArmNumber* one) { return one->unit == first.unit; });
  if (isOne) return {first.name, first.unit};
  for (std::size_t i = 0; i < arms.size(); ++i) {
    const ArmNumber& one = *arms[i];
    const auto size = one.part == ArmPart::Modulus ? unitSize(one.unit, "Pa")
                      : one.part == ArmPart::Time  ? timeSize(one.unit)
                                                   : viscosityUnit(one.unit);
    if (one.unit.empty() || !size)
      throw InputError(name, fmt::format("line {}", one.line),
                       one.unit.empty()
                           ? message("{} has no unit, as others have; write it after the number",
                                     Message::name(one.written()))
                           : message("{} has the unit {}, which is not understood",
                                     Message::name(one.written()), shortened(one.unit)));
    numbers[i] *= *size;
  }
  return {first.name, first.part == ArmPart::Modulus ? "Pa"
                      : first.part == ArmPart::Time  ? "s"
                                                     : "Pa s"};
}

/// Throws InputError for an arm that lacks what others have.
[[noreturn]] void refuseIncomplete(const ArmNumber& stated, const ArmNumber& missing,
                                   const std::string& name) {
  throw InputError(
      name, fmt::format("line {}", stated.line),
      message("{} is stated without {}; each arm needs both", Message::name(stated.written()),
              Message::name(missing.nameWith(stated.index))));
}

}  // namespace

std::optional<TextTable> tableOfNamedArms(std::string_view text, const std::string& name) {
  StatedArms stated = statedArms(text);
  std::vector<std::string> indices;
  std::map<ArmPart, std::map<std::string, const ArmNumber*>> parts;
  for (const ArmNumber& one : stated.numbers) {
    if (std::ranges::find(indices, one.index) == indices.end()) indices.push_back(one.index);
    const auto [found, isNew] = parts[one.part].try_emplace(one.index, &one);
    if (isNew) continue;
    throw InputError(name, fmt::format("line {}", one.line),
                     message("{} is stated in line {} already", Message::name(one.written()),
                             found->second->line));
  }
  if (parts.size() < 2) return {};
  // Viscosities beside both others only say the same.
  if (parts.size() == 3) parts.erase(ArmPart::Viscosity);
  TextBlock block;
  block.header = std::move(stated.others);
  block.rows = indices.size();
  std::vector<std::vector<double>> columns;
  for (const auto& [part, numbers] : parts) {
    ArmColumn arms;
    std::vector<double> values;
    for (const std::string& index : indices) {
      const auto found = numbers.find(index);
      if (found == numbers.end()) {
        const auto& other =
            parts.begin()->first == part ? parts.rbegin()->second : parts.begin()->second;
        refuseIncomplete(*other.at(index), *numbers.begin()->second, name);
      }
      if (found->second->name != numbers.begin()->second->name) return {};
      arms.push_back(found->second);
      values.push_back(found->second->number);
    }
    block.columns.push_back(unifiedColumn(arms, name, values));
    columns.push_back(std::move(values));
    if (block.lines.empty())  // those of the moduli or, without them, of the times
      for (const ArmNumber* one : arms)
        block.lines.push_back(static_cast<std::uint32_t>(one->line));
  }
  for (std::size_t row = 0; row < block.rows; ++row)
    for (const std::vector<double>& column : columns) block.values.push_back(column[row]);
  block.texts.resize(columns.size());
  block.cells.resize(columns.size());
  TextTable table;
  table.dialect.decimal = ',';
  table.dialect.isUnclear = stated.isMarkUnclear;
  refuseUnclearMark(table, name);
  table.dialect.decimal = '.';
  table.blocks.push_back(std::move(block));
  return table;
}

}  // namespace asperity
