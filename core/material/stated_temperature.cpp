#include "core/material/stated_temperature.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/material/dma_columns.h"
#include "core/material/isotherms.h"
#include "core/material/temperature_shift.h"

namespace asperity {
namespace {

using Words = std::vector<std::string>;

/// Returns the words of a text in lower case; "T_ref" is one of them.
Words wordsOf(std::string_view text) {
  Words words;
  bool isOpen = false;
  for (const char letter : lowerCase(text)) {
    if (letter == '_') continue;
    const auto byte = static_cast<unsigned char>(letter);
    const bool isPart = byte >= 0x80 || std::isalnum(byte) != 0;
    if (isPart && !isOpen) words.emplace_back();
    if (isPart) words.back() += letter;
    isOpen = isPart;
  }
  return words;
}

template <std::size_t N>
bool beginsWithAny(const std::string& word, const std::array<std::string_view, N>& stems) {
  return std::ranges::any_of(stems,
                             [&word](std::string_view stem) { return word.starts_with(stem); });
}

/// Returns whether a word says that a temperature is one of making the sample: all of the line is
/// about it.
bool isOfMaking(const std::string& word) {
  constexpr std::array<std::string_view, 19> kStems{
      "vulc",   "vulk",  "cure",  "curing", "mix",  "misch",   "mold",  "mould", "press", "aged",
      "ageing", "aging", "alter", "lager",  "melt", "schmelz", "extru", "calib", "kalib"};
  return beginsWithAny(word, kStems);
}

/// Returns whether a word says that a temperature is none of the test: a property of the sample, a
/// number of the program or of the oven, a constant of the shift.
bool isOfOther(const std::string& word) {
  constexpr std::array<std::string_view, 32> kStems{
      "instrument",  "ger\u00E4t", "device",      "glas",      "toler",     "oven",     "ofen",
      "furnace",     "range",      "bereich",     "maxim",     "minim",     "limit",    "grenz",
      "heat",        "heiz",       "aufheiz",     "cool",      "k\u00FChl", "soak",     "halte",
      "ramp",        "increment",  "schritt",     "differ",    "offset",    "gradient", "accur",
      "abk\u00FChl", "genauig",    "h\u00F6chst", "resolution"};
  return isOfMaking(word) || beginsWithAny(word, kStems) ||
         isOneOf(word, {"bis",     "tg",      "rate",  "wlf",    "c1",      "c2",   "c\u2081",
                        "c\u2082", "max",     "min",   "tmax",   "tmin",    "dt",   "delta",
                        "\u03B4t", "\u0394t", "start", "end",    "final",   "stop", "anfang",
                        "ende",    "tm",      "drift", "limits", "heizrate"});
}

/// Returns whether a word says that a temperature need not be the sample's.
bool isVague(const std::string& word) {
  constexpr std::array<std::string_view, 9> kStems{
      "ambient", "raum", "umgebung", "soll", "target", "nominal", "program", "setpoint", "lab"};
  return beginsWithAny(word, kStems) || isOneOf(word, {"room", "set", "tset", "tsoll"});
}

/// Returns whether a word names the temperature to which a master curve is shifted.
bool isOfReference(const std::string& word) {
  constexpr std::array<std::string_view, 2> kStems{"refer", "bezug"};
  return beginsWithAny(word, kStems) || isOneOf(word, {"ref", "tref", "tr", "t0", "tbezug"});
}

/// Returns whether words name a step from one temperature to the next.
bool isOfStep(const Words& words) {
  return std::ranges::any_of(words, [](const std::string& word) {
    return isOneOf(word, {"step", "steps"});
  });
}

bool isTemperatureWord(std::string_view key) {
  return dmaColumn(key, "").quantity == DmaQuantity::Temperature;
}

/// How certainly a statement is about the test.
enum class Rank { Test, Reference, Bare };

struct Statement {
  double kelvin = 0;
  std::size_t line = 0;
  Rank rank = Rank::Bare;
};

/// Splits a line at semicolons, tabs and commas before a blank.
std::vector<std::string_view> clausesOf(std::string_view line) {
  std::vector<std::string_view> clauses;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    const bool isEnd = i == line.size() || line[i] == ';' || line[i] == '\t' || line[i] == '|' ||
                       line.substr(i).starts_with(", ");
    if (!isEnd) continue;
    if (const auto clause = trimmedBlanks(line.substr(begin, i - begin)); !clause.empty())
      clauses.push_back(clause);
    begin = i + 1;
  }
  return clauses;
}

std::string_view withoutEnd(std::string_view text, std::string_view signs) {
  const std::size_t last = text.find_last_not_of(signs);
  return text.substr(0, last == text.npos ? 0 : last + 1);
}

/// Returns the key in front of a value: "T" of "Isothermal test: T = ".
std::string_view keyBefore(std::string_view text) {
  text = withoutEnd(text, " :=@(\t");
  const std::size_t before = text.find_last_of(":=");
  return trimmedBlanks(before == text.npos ? text : text.substr(before + 1));
}

/// Returns whether a text goes on from one end of a range to the other: "to 60 °C", "... 60 °C".
bool beginsAsRange(std::string_view text) {
  text = trimmedBlanks(text);
  constexpr std::array<std::string_view, 8> kSigns{"to ",    "bis ",   "..", "\u2026",
                                                   "\u2013", "\u2014", "-",  "\u2212"};
  return std::ranges::any_of(kSigns,
                             [text](std::string_view sign) { return text.starts_with(sign); });
}

/// Returns whether a text ends within a range: "-150 to", "-150 ...".
bool endsWithinRange(std::string_view text) {
  text = trimmedBlanks(text);
  for (const std::string_view sign : {"to", "bis", "..", "\u2026", "\u2013", "\u2014", "-"})
    if (text.ends_with(sign)) {
      text = withoutEnd(text.substr(0, text.size() - sign.size()), " .");
      const std::size_t word = text.find_last_of(" :=");
      const std::string_view last = word == text.npos ? text : text.substr(word + 1);
      return std::ranges::any_of(last, isDigit) || temperatureUnit(last).has_value();
    }
  return false;
}

std::string lineOf(const TextEntry& entry) {
  return entry.key.empty() ? entry.value : fmt::format("{} = {}", entry.key, entry.value);
}

/// Reads the lines above one block.
class HeaderReader {
 public:
  /// isStrict: whether an impossible temperature is refused.
  HeaderReader(const std::string& name, const std::string& unit, bool isStrict)
      : name_(name), unit_(unit), isStrict_(isStrict) {}

  std::vector<Statement> read(const std::vector<TextEntry>& header) {
    found_.clear();
    for (const TextEntry& entry : header) readEntry(entry);
    return std::move(found_);
  }

 private:
  void readEntry(const TextEntry& entry) {
    const std::string line = lineOf(entry);
    const std::string_view head =
        std::string_view(line).substr(0, std::min(line.find_first_of(":="), line.size()));
    const bool hasHead = head.size() < line.size();
    if (hasHead && std::ranges::any_of(wordsOf(head), isOfMaking)) return;
    const Words words = wordsOf(line);
    bool isOther = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
      // "5 min" are minutes.
      const bool isTime = words[i] == "min" && i > 0 && isDigit(words[i - 1].back());
      isOther = isOther || (!isTime && isOfOther(words[i]));
    }
    for (const std::string_view clause : clausesOf(line)) readClause(clause, entry.line, isOther);
  }

  void readClause(std::string_view clause, std::size_t line, bool isLineOfOther) {
    const auto found = firstTemperature(clause);
    if (!found) return readPlainNumber(clause, line);
    std::string_view before = clause.substr(0, found->begin);
    if (beginsAsRange(clause.substr(found->end)) || endsWithinRange(before)) return;
    double kelvin = found->kelvin;
    auto quantity = parseQuantity(clause.substr(found->begin, found->end - found->begin));
    for (const std::string_view sign : {"\u00B1", "+/-", "+-"})
      if (trimmedBlanks(before).ends_with(sign)) {
        // "20 ± 0.5 °C"
        const std::string_view number = trimmedBlanks(withoutEnd(trimmedBlanks(before), sign));
        const std::size_t begin = number.find_last_of(" :=") + 1;
        const auto middle = parseQuantity(number.substr(begin));
        const auto scale = quantity ? temperatureUnit(quantity->unit) : std::nullopt;
        if (!middle || !scale) return;
        before = before.substr(0, begin);
        kelvin = scale->toSi(middle->number);
        quantity = middle;
      }
    const std::string_view key = keyBefore(before);
    const Words words = wordsOf(before);
    if (std::ranges::any_of(words, isOfOther)) return;
    Rank rank = rankOf(key);
    if (rank != Rank::Bare && quantity)
      if (const auto scale = unit_.empty() ? std::nullopt : temperatureUnit(unit_))
        kelvin = scale->toSi(quantity->number);
    if (rank != Rank::Bare && isOfStep(words)) return;
    if (std::ranges::any_of(words, isVague)) rank = Rank::Bare;
    // "DMA 242 C" is an instrument.
    if (rank == Rank::Bare && (isLineOfOther || (!words.empty() && words.back() == "dma"))) return;
    add(kelvin, line, rank);
  }

  /// Reads "Temperature [°C]: 20", "T/K = 293" and "Temperature: 20". Without a unit, numbers above
  /// 200 are kelvins, as in columns.
  void readPlainNumber(std::string_view clause, std::size_t line) {
    const std::size_t end = clause.find_last_of(":=");
    if (end == clause.npos) return;
    const std::string_view key = keyBefore(clause.substr(0, end));
    const auto quantity = parseQuantity(clause.substr(end + 1));
    const Rank rank = rankOf(key);
    const Words words = wordsOf(clause);
    if (!quantity || rank == Rank::Bare || std::ranges::any_of(words, isOfOther) || isOfStep(words))
      return;
    std::string unit = unit_.empty() ? quantity->unit : unit_;
    if (unit.empty()) unit = parseColumnName(key).unit;
    if (unit.empty()) {
      // "Reference: 2041" is no temperature, and t may be a time.
      const bool isNamed = lowerCase(key).find("temp") != std::string::npos || key == "T" ||
                           std::ranges::find(words, "tref") != words.end();
      if (!isNamed) return;
      unit = quantity->number >= 200 ? "K" : "C";
    }
    const auto scale = temperatureUnit(unit);
    if (!scale) return;
    add(scale->toSi(quantity->number), line,
        std::ranges::any_of(wordsOf(key), isVague) ? Rank::Bare : rank);
  }

  static Rank rankOf(std::string_view key) {
    const Words words = wordsOf(key);
    if (std::ranges::any_of(words, isOfReference)) return Rank::Reference;
    if (isTemperatureWord(key) || isTemperatureWord(parseColumnName(key).name)) return Rank::Test;
    return !words.empty() && isTemperatureWord(words.back()) ? Rank::Test : Rank::Bare;
  }

  void add(double kelvin, std::size_t line, Rank rank) {
    if (kelvin >= kColdestTest) {
      found_.push_back({kelvin, line, rank});
    } else if (rank != Rank::Bare && isStrict_) {
      throw InputError(name_, fmt::format("line {}", line),
                       message("states a temperature of {:.6g} K, at which no rubber is measured; "
                               "correct it, or state that of the test with --temperature",
                               kelvin));
    }
  }

  const std::string& name_;
  const std::string& unit_;
  bool isStrict_;
  std::vector<Statement> found_;
};

/// Returns the one temperature of these statements. Throws InputError where they differ.
double onlyTemperature(const std::vector<Statement>& statements, const std::string& name) {
  const auto [coldest, warmest] = std::ranges::minmax(statements, {}, &Statement::kelvin);
  if (warmest.kelvin - coldest.kelvin > kIsothermTolerance) {
    const auto& [first, second] = std::minmax(
        coldest, warmest, [](const auto& one, const auto& other) { return one.line < other.line; });
    throw InputError(
        name, "temperature",
        message("is {} in line {} and {} in line {}; say with --temperature which is "
                "that of the test",
                celsius(first.kelvin), first.line, celsius(second.kelvin), second.line));
  }
  return statements.back().kelvin;
}

}  // namespace

std::optional<double> statedTemperature(const TextTable& table, const TextBlock& block,
                                        const std::string& name, const std::string& unit,
                                        bool isReduced) {
  std::array order{Rank::Test, Rank::Reference, Rank::Bare};
  if (isReduced) std::swap(order[0], order[1]);
  HeaderReader reader(name, unit, true);
  for (const TextBlock* current = &block;; --current) {
    const std::vector<Statement> all = reader.read(current->header);
    for (const Rank rank : order) {
      std::vector<Statement> some;
      std::ranges::copy_if(all, std::back_inserter(some),
                           [rank](const Statement& one) { return one.rank == rank; });
      if (!some.empty()) return onlyTemperature(some, name);
    }
    if (current == &table.blocks.front()) return {};
  }
}

// ---- The shift ---------------------------------------------------------------------------------

namespace {

/// The columns of a table of shift factors.
struct ShiftColumns {
  std::size_t temperature = 0, factor = 0;
  double base = 10;         // of the logarithm
  bool isLogarithm = true;  // otherwise the factor itself
};

std::optional<ShiftColumns> shiftColumns(const TextBlock& block) {
  std::optional<std::size_t> temperature, factor;
  ShiftColumns found;
  for (std::size_t i = 0; i < block.columns.size(); ++i) {
    std::string word;
    for (const std::string& part : wordsOf(block.columns[i].name)) word += part;
    const DmaQuantity quantity = dmaColumn(block.columns[i].name, block.columns[i].unit).quantity;
    if (quantity == DmaQuantity::Frequency || quantity == DmaQuantity::Storage) return {};
    if (quantity == DmaQuantity::Temperature && !temperature) temperature = i;
    const bool isTen = isOneOf(word, {"logat", "log10at", "lgat", "logshiftfactor", "log10shift",
                                      "logshift", "log10shiftfactor", "logat10"});
    const bool isNatural = isOneOf(word, {"lnat", "lnshiftfactor"});
    if (factor || !(isTen || isNatural || isOneOf(word, {"at", "shiftfactor", "shiftfactors"})))
      continue;
    factor = i;
    found.isLogarithm = isTen || isNatural;
    if (isNatural) found.base = std::numbers::e;
  }
  if (!temperature || !factor) return {};
  found.temperature = *temperature;
  found.factor = *factor;
  return found;
}

/// Reads the rows in rising temperature; empty where they are no table of a scene.
std::vector<ShiftPoint> shiftRows(const TextBlock& block, const ShiftColumns& columns,
                                  const std::string& chosenUnit) {
  std::string unit = chosenUnit.empty() ? block.columns[columns.temperature].unit : chosenUnit;
  const std::vector<double> temperatures = block.column(columns.temperature);
  // Numbers above 200 are kelvins, as in columns of moduli.
  if (unit.empty()) unit = std::ranges::min(temperatures) >= 200 ? "K" : "C";
  const auto scale = temperatureUnit(unit);
  if (!scale) return {};
  std::vector<ShiftPoint> rows;
  for (std::size_t row = 0; row < block.rows; ++row) {
    const double value = block.at(row, columns.factor);
    const double decades =
        columns.isLogarithm ? value * std::log10(columns.base) : std::log10(value);
    const double kelvin = scale->toSi(temperatures[row]);
    if (!(kelvin >= kColdestTest && std::abs(decades) <= kMostDecades)) return {};
    rows.push_back({kelvin, decades});
  }
  std::ranges::sort(rows, {}, &ShiftPoint::temperature);
  const auto isSame = [](const ShiftPoint& one, const ShiftPoint& other) {
    return one.temperature == other.temperature;
  };
  return std::ranges::adjacent_find(rows, isSame) == rows.end() ? rows : std::vector<ShiftPoint>{};
}

/// Returns the shift of a table at its reference temperature.
void readShiftTable(const TextBlock& block, double temperature, const std::string& unit,
                    StatedShift& stated) {
  const std::size_t line = block.lines.front();
  TemperatureShift shift;
  shift.kind = ShiftKind::Table;
  shift.table = shiftRows(block, *shiftColumns(block), unit);
  if (shift.table.size() < 2) {
    stated.notes.push_back(
        message("the shift factors from line {} on are not read: they are no rising table", line));
    return;
  }
  // Degrees that were converted differ in the last digit.
  for (ShiftPoint& row : shift.table)
    if (std::abs(row.temperature - temperature) < 1e-6) row.temperature = temperature;
  constexpr double kNoShift = 0.05;  // decades
  if (temperature < shift.table.front().temperature ||
      temperature > shift.table.back().temperature ||
      !(std::abs(log10ShiftFactor(shift, temperature)) <= kNoShift)) {
    stated.notes.push_back(message(
        "the shift factors from line {} on are not read: they are not those of {}, where log aT "
        "would be 0",
        line, celsius(temperature)));
    return;
  }
  stated.shift = tableShift(shift.table, temperature);
  stated.notes.push_back(message("shift factors from line {} on: {} from {} to {}", line,
                                 shift.table.size(), celsius(shift.table.front().temperature),
                                 celsius(shift.table.back().temperature)));
}

/// The constants of Williams, Landel and Ferry as a header states them.
struct WlfConstants {
  std::optional<double> c1{}, c2{};
  std::optional<double> reference{};  // K
  std::optional<std::size_t> line{};  // of the last line with words about a shift
};

WlfConstants wlfConstants(const TextTable& table, const std::string& name,
                          const std::string& unit) {
  WlfConstants found;
  HeaderReader reader(name, unit, false);
  for (const TextBlock& block : table.blocks) {
    for (const Statement& statement : reader.read(block.header))
      if (statement.rank == Rank::Reference) found.reference = statement.kelvin;
    for (const TextEntry& entry : block.header) {
      const std::string line = lineOf(entry);
      for (const std::string& word : wordsOf(line))
        if (isOneOf(word, {"wlf", "arrhenius", "activation", "aktivierungsenergie"}))
          found.line = entry.line;
      for (const std::string_view clause : clausesOf(line)) {
        const std::size_t end = clause.find_last_of(":=");
        if (end == clause.npos) continue;
        const Words words = wordsOf(keyBefore(clause.substr(0, end)));
        const auto quantity = parseQuantity(clause.substr(end + 1));
        if (words.empty() || !quantity) continue;
        if (isOneOf(words.back(), {"c1", "c\u2081"})) found.c1 = quantity->number;
        if (isOneOf(words.back(), {"c2", "c\u2082"})) found.c2 = quantity->number;
      }
    }
  }
  return found;
}

void readWlf(const WlfConstants& constants, double temperature, const std::string& name,
             StatedShift& stated) {
  const double c1 = *constants.c1, c2 = *constants.c2;
  if (!(c1 > 0 && c1 <= kMostC1 && c2 >= kLeastC2 && c2 <= kMostC2))
    throw InputError(
        name, "WLF",
        message("C1 is {} and C2 is {} K; allowed is C1 above 0 to {}, C2 from {} to "
                "{} K",
                plain(c1), plain(c2), plain(kMostC1), plain(kLeastC2), plain(kMostC2)));
  TemperatureShift shift;
  shift.referenceTemperature = temperature;
  // The same curve from another reference: C2' = C2 + T - T_r, C1' = C1 C2 / C2'.
  const double apart = temperature - constants.reference.value_or(temperature);
  const bool isApart = std::abs(apart) > kIsothermTolerance;
  shift.c2 = isApart ? c2 + apart : c2;
  shift.c1 = isApart ? c1 * c2 / shift.c2 : c1;
  if (!(shift.c2 >= kLeastC2)) {
    stated.notes.push_back(message("the constants C1 and C2 are not read: they hold above {}",
                                   celsius(temperature - shift.c2)));
    return;
  }
  stated.shift = shift;
  stated.notes.push_back(
      message("shift of the file: Williams, Landel and Ferry with C1 = {}, C2 = "
              "{} K at {}",
              PrintedNumber{printedNumber(shift.c1)}, PrintedNumber{printedNumber(shift.c2)},
              celsius(temperature)));
}

}  // namespace

bool isShiftTable(const TextBlock& block) {
  return shiftColumns(block).has_value();
}

bool statesShift(const TextTable& table) {
  const WlfConstants constants = wlfConstants(table, {}, {});
  return (constants.c1 && constants.c2) || std::ranges::any_of(table.blocks, isShiftTable);
}

StatedShift statedShift(const TextTable& table, double temperature, const std::string& name,
                        const std::string& unit) {
  StatedShift stated;
  for (const TextBlock& block : table.blocks)
    if (isShiftTable(block) && !stated.shift) readShiftTable(block, temperature, unit, stated);
  const WlfConstants constants = wlfConstants(table, name, unit);
  const bool hasConstants = constants.c1 && constants.c2;
  if (hasConstants && stated.shift)
    stated.notes.push_back("the constants C1 and C2 are not read: the file has shift factors");
  else if (hasConstants)
    readWlf(constants, temperature, name, stated);
  else if (constants.line && !stated.shift)
    stated.notes.push_back(
        message("line {} is about a shift and is not read: C1 and C2 with values, or a table of "
                "temperature and log aT, would be",
                *constants.line));
  return stated;
}

}  // namespace asperity
