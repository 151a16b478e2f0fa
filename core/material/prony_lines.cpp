// Arms of a Prony series as named numbers, "G1 = 2 MPa" and "tau1 = 0.1 s", as people write them in
// notes, scripts and lists of parameters.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
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

/// Why a number may not be read.
enum class Doubt {
  None,
  Comma,  // of "2,000"
  Point,  // of "2.000", where other numbers have decimal commas
  List,   // "[2,5 1,5]" may have two numbers or four
  NoNumber,
  NoArm,  // it belongs to no arm
};

/// A number that a line states of an arm.
struct ArmNumber {
  ArmPart part = ArmPart::Modulus;
  std::string index{};  // "1" of "G_1"; empty where the name has none
  std::string name{};   // "G_i"
  std::string unit{};
  double number = 0;
  Doubt doubt = Doubt::None;
  std::size_t line = 0;

  std::string written() const { return nameWith(index); }
  /// Returns the name of this part of another arm: "G_2".
  std::string nameWith(const std::string& other) const {
    if (!name.ends_with("_i")) return other.empty() ? name : name + " " + other;
    return name.substr(0, name.size() - (other.empty() ? 2 : 1)) + other;
  }
};

/// A name, a number and its unit in a line.
struct NamedNumber {
  std::string name{};
  TextQuantity quantity{};
  Doubt doubt = Doubt::None;
  bool hasDecimalComma = false;
};

/// Returns a name without the brackets around its index and the marks of LaTeX: "G1" for "G(1)",
/// "tau_1" for "\tau_{1}", "G_inf" for "G_{\infty}".
std::string plainName(std::string_view text) {
  std::string name(text);
  for (const std::string_view mark : WordList("\\ { } $")) replaceAll(name, mark, "");
  name = trimmedField(name);
  const std::size_t open = name.find_first_of("([");
  if (open != name.npos && name.find_first_of(")]", open) == name.npos)
    return name.substr(open + 1);  // the first of a list of parameters, "dict(G1"
  if (open == 0 || open == name.npos || name.find_first_of(")]", open) + 1 != name.size())
    return name;
  const std::string index = seriesWord(std::string_view(name).substr(open + 1));
  if (!areDigits(withoutEnd(index, ")]")) && withoutEnd(index, ")]") != "inf") return name;
  return name.substr(0, open) + name.substr(open + 1, name.size() - open - 2);
}

/// Returns the unit after a number without brackets, quotes and comments: "[MPa] "branch 1"", "; %
/// Pa", "MPa (fast)". Brackets that end a list of parameters are no unit.
std::string cleanUnit(std::string_view text) {
  if (trimmedBlanks(text) == "%") return "%";
  text = text.substr(std::min(text.find_first_not_of(" ;,#%!/\t"), text.size()));
  if (text.starts_with('[')) text = text.substr(0, text.find(']') + 1);
  text = withoutEnd(text.substr(0, text.find('"')), " ;,.");
  if (text.find_first_not_of(")}") == text.npos) return {};
  return std::string(withoutEnd(withoutBrackets(text.substr(0, text.find(" ("))), " ;,."));
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

/// Returns a name and what stands after it. unit: of a number without one.
NamedNumber namedNumber(std::string_view name, std::string_view number, std::string_view unit) {
  NamedNumber named{plainName(name)};
  const auto quantity = parseQuantity(number);
  named.quantity = quantity.value_or(TextQuantity{});
  named.quantity.unit = cleanUnit(named.quantity.unit.empty() ? unit : named.quantity.unit);
  if (!quantity) {
    named.doubt = Doubt::NoNumber;
  } else if (std::abs(quantity->number) >= 1) {
    if (parseQuantity(number, '.')->isGrouped)
      named.doubt = Doubt::Comma;
    else if (parseQuantity(number, ',')->isGrouped)
      named.doubt = Doubt::Point;
  }
  const std::size_t mark = number.find_first_of(".,");
  named.hasDecimalComma = quantity && named.doubt == Doubt::None && mark != number.npos &&
                          mark + 1 < number.size() && number[mark] == ',' &&
                          isDigit(number[mark + 1]);
  return named;
}

/// Returns where the comment behind a value begins: "G1 = 2e6;  % Pa"; the size of the line where
/// there is none.
std::size_t remarkIn(std::string_view line) {
  for (std::size_t at = 1; at + 1 < line.size(); ++at) {
    const bool isPercent =
        line[at] == '%' &&
        trimmedBlanks(line.substr(at + 1)).find_first_of(";,") != 0;  // "g1 = 50 %, tau1 = 0.1 s"
    if ((line[at - 1] == ' ' || line[at - 1] == ';' || line[at - 1] == '\t') &&
        (isPercent || line[at] == '#' || line[at] == '!' || line.substr(at).starts_with("//")))
      return at;
  }
  return line.size();
}

/// Returns the names that a line states, and the numbers after them.
std::vector<NamedNumber> namedNumbers(std::string_view line) {
  std::vector<NamedNumber> found;
  if (keyEnd(line) != line.npos) {
    const std::size_t remark = remarkIn(line);
    for (const std::string_view clause : splitClauses(line.substr(0, remark)))
      for (const std::string_view statement : splitStatements(clause)) {
        const std::size_t end = statement.find_last_of(":=");
        if (end == statement.npos) continue;
        // The unit may stand in a comment behind it: "G1 = 2e6;  % Pa".
        found.push_back(namedNumber(keyBefore(statement.substr(0, end)), statement.substr(end + 1),
                                    line.substr(remark)));
      }
    return found;
  }
  const std::vector<std::string_view> fields = fieldsOf(line);
  if (fields.size() > 1)
    found.push_back(namedNumber(fields[0], fields[1], fields.size() > 2 ? fields[2] : ""));
  return found;
}

/// Returns the numbers of a list, "G = [2e6, 1e6]", named in their order: "G1", "G2". Between
/// semicolons a comma is a decimal mark.
std::vector<NamedNumber> listedNumbers(std::string_view line) {
  const std::size_t end = line.find('='), open = line.find('[', end), close = line.find(']', open);
  if (close == line.npos || line.substr(end, open - end).find_first_of("0123456789") != line.npos)
    return {};
  std::string numbers(line.substr(open + 1, close - open - 1));
  const bool hasSemicolons = numbers.find(';') != std::string::npos;
  const auto mayBeDecimal = [](std::string_view word) {
    word = withoutEnd(word, ",");
    double number = 0;
    return word.find(',') != word.npos && readTextNumber(word, ',', number);
  };
  const bool isUnclear = !hasSemicolons && numbers.find('.') == std::string::npos &&
                         std::ranges::any_of(splitWords(numbers), mayBeDecimal);
  if (!hasSemicolons) std::ranges::replace(numbers, ',', ' ');
  const std::string key = plainName(line.substr(0, end));
  const std::string unit = cleanUnit(withoutEnd(line.substr(close + 1), ")"));
  std::vector<NamedNumber> found;
  for (const std::string_view word :
       hasSemicolons ? splitText(numbers, ";") : splitWords(numbers)) {
    if (trimmedBlanks(word).empty()) continue;
    found.push_back(namedNumber(key + std::to_string(found.size() + 1), word, {}));
    NamedNumber& last = found.back();
    if (!last.quantity.unit.empty()) last.doubt = Doubt::NoNumber;  // "2 MPa", "2, 1"
    last.quantity.unit = unit;
    if (isUnclear) last.doubt = Doubt::List;
  }
  return found;
}

/// Returns what a name and its number state of an arm; nothing where they state something else.
std::optional<ArmNumber> armNumber(const NamedNumber& named, std::size_t line) {
  const TextColumn key = parseColumnName(named.name);
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
  // A word after a name without an index is no value of an arm.
  if (named.doubt == Doubt::NoNumber && arm.index.empty()) return {};
  arm.number = named.quantity.number;
  arm.doubt = named.doubt;
  arm.line = line;
  return arm;
}

/// What the lines of a text state of arms, and all else as lines above a table.
struct StatedArms {
  std::vector<ArmNumber> numbers{};
  std::vector<TextEntry> others{};
  std::vector<bool> areComments{};  // the lines of the text
  bool hasDecimalComma = false;
};

/// Numbers the arm whose parts a line states without an index, as in "Arm 1: G = 2 MPa, tau = 0.1
/// s".
void numberArm(std::vector<ArmNumber>& parts, const std::vector<ArmNumber>& before) {
  const auto hasTwin = [&parts](const ArmNumber& one) {
    return std::ranges::count(parts, one.part, &ArmNumber::part) > 1;
  };
  const auto isBare = [](const ArmNumber& one) { return one.index.empty(); };
  if (parts.size() > 1 && std::ranges::all_of(parts, isBare) &&
      std::ranges::none_of(parts, hasTwin)) {
    const auto number = 1 + std::ranges::count(before, parts.front().part, &ArmNumber::part);
    for (ArmNumber& part : parts) part.index = std::to_string(number);
  }
  for (ArmNumber& part : parts)
    if (isBare(part)) part.doubt = Doubt::NoArm;
}

/// Adds what a line states.
void addLine(std::string_view line, std::size_t number, StatedArms& stated) {
  std::vector<ArmNumber> parts;
  const std::size_t others = stated.others.size();
  std::vector<NamedNumber> all = listedNumbers(line);
  const bool hasList = !all.empty() && armNumber(all.front(), number);
  if (!hasList) all = namedNumbers(line);
  for (const NamedNumber& named : all) {
    if (named.doubt == Doubt::NoNumber && !hasList) continue;
    stated.hasDecimalComma = stated.hasDecimalComma || named.hasDecimalComma;
    if (auto part = armNumber(named, number)) {
      parts.push_back(std::move(*part));
    } else {
      const std::string value = plain(named.quantity.number).text + " " + named.quantity.unit;
      stated.others.push_back({named.name, value, number, std::string(line)});
      const std::string word = seriesWord(parseColumnName(named.name).name);
      // The mark of this number may be unclear, too.
      if (named.doubt != Doubt::None && (isEquilibrium(word) || isInstantaneous(word)))
        stated.numbers.push_back({.name = named.name, .doubt = named.doubt, .line = number});
    }
  }
  if (parts.empty() && others == stated.others.size() && !trimmedBlanks(line).empty())
    stated.others.push_back(parseEntry({line, number}, {}));
  numberArm(parts, stated.numbers);
  std::ranges::move(parts, std::back_inserter(stated.numbers));
}

/// Adds the names of arms' numbers in a line, by which numbers that are not read are found.
void addNames(std::string_view line, std::size_t number, StatedArms& stated) {
  std::string words(line.substr(0, remarkIn(line)));
  for (char& letter : words)
    if (std::ispunct(static_cast<unsigned char>(letter)) != 0 && letter != '_') letter = ' ';
  for (const std::string_view word : splitWords(words))
    if (auto part = armNumber({std::string(word), {}, Doubt::NoNumber}, number))
      stated.numbers.push_back(std::move(*part));
}

StatedArms statedArms(std::string_view text) {
  StatedArms stated;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view whole = trimmedBlanks(takeLine(text));
    std::string line(withoutCommentMark(whole, {}));
    stated.areComments.push_back(line.size() < whole.size());
    for (const auto& [wide, plain] : {std::pair("\uFF1A", ":"), {"\uFF1D", "="}})
      replaceAll(line, wide, plain);
    addLine(line, number, stated);
    addNames(line, number, stated);
  }
  return stated;
}

/// Leaves out what comments state of arms where other lines state arms, and what they state again.
void leaveOutComments(StatedArms& stated) {
  const auto isLive = [&stated](const auto& one) { return !stated.areComments[one.line - 1]; };
  if (std::ranges::none_of(stated.numbers, [&](const ArmNumber& one) {
        return isLive(one) && !one.index.empty() && one.doubt != Doubt::NoNumber;
      }))
    return;
  std::erase_if(stated.numbers, std::not_fn(isLive));
  std::vector<std::string> keys;
  for (const TextEntry& entry : stated.others)
    if (isLive(entry)) keys.push_back(entry.key);
  std::erase_if(stated.others, [&](const TextEntry& entry) {
    return !isLive(entry) && std::ranges::find(keys, entry.key) != keys.end();
  });
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

/// The numbers of each part of an arm by the index of the arm.
using ArmParts = std::map<ArmPart, std::map<std::string, const ArmNumber*>>;

/// Returns why a number may not be read, if so. A name without a number counts where no other line
/// has its number.
std::optional<Message> reasonAgainst(const ArmNumber& one, const StatedArms& stated,
                                     const ArmParts& parts) {
  const Message written = Message::name(one.written());
  const auto& same = parts.at(one.part);
  switch (one.doubt) {
    case Doubt::None:
      break;
    case Doubt::Point:
    case Doubt::Comma:
      if (one.doubt == Doubt::Point && !stated.hasDecimalComma) break;
      return message(
          "the mark in the number of {} may separate decimals or thousands; write "
          "thousands without a mark",
          written);
    case Doubt::List:
      return "the commas in the list may separate decimals or numbers; write \"; \" or \", \" "
             "between the numbers";
    case Doubt::NoNumber:
      if (same.contains(one.index)) break;
      // "E2" beside "G1" may be the name of a sample.
      if (!same.empty() && same.begin()->second->name != one.name) break;
      return message(
          "{} has no number that can be read; write it as \"{} = 1\", with its "
          "unit, or leave it out",
          written, written);
    case Doubt::NoArm:
      return message(
          "{} belongs to no arm; write the number of its arm after the name, or leave it out",
          written);
  }
  return {};
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
  leaveOutComments(stated);
  std::vector<std::string> indices;
  ArmParts parts;
  for (const ArmNumber& one : stated.numbers) {
    auto& same = parts[one.part];
    if (one.index.empty() || one.doubt == Doubt::NoNumber) continue;
    if (std::ranges::find(indices, one.index) == indices.end()) indices.push_back(one.index);
    const auto [found, isNew] = same.try_emplace(one.index, &one);
    if (isNew) continue;
    throw InputError(name, fmt::format("line {}", one.line),
                     message("{} is stated in line {} already", Message::name(one.written()),
                             found->second->line));
  }
  if (parts.size() < 2 || indices.empty()) return {};
  for (const ArmNumber& one : stated.numbers)
    if (const auto reason = reasonAgainst(one, stated, parts))
      throw InputError(name, fmt::format("line {}", one.line), *reason);
  TextBlock block;
  block.header = std::move(stated.others);
  block.rows = indices.size();
  for (const auto& [part, numbers] : parts) {
    // Viscosities beside both others only say the same; they are compared where each arm has one.
    if (block.columns.size() == 2 && numbers.size() < indices.size()) break;
    ArmColumn arms;
    std::vector<double> values;
    for (const std::string& index : indices) {
      const auto found = numbers.find(index);
      if (found == numbers.end()) {
        const auto other = std::ranges::find(stated.numbers, index, &ArmNumber::index);
        refuseIncomplete(*other, *numbers.begin()->second, name);
      }
      if (found->second->name != numbers.begin()->second->name) return {};
      arms.push_back(found->second);
      values.push_back(found->second->number);
    }
    TextColumn column = unifiedColumn(arms, name, values);
    block.append(std::move(column), values);
    if (block.lines.empty())  // those of the moduli or, without them, of the times
      for (const ArmNumber* one : arms)
        block.lines.push_back(static_cast<std::uint32_t>(one->line));
  }
  TextTable table;
  table.dialect.decimal = '.';
  table.blocks.push_back(std::move(block));
  return table;
}

}  // namespace asperity
