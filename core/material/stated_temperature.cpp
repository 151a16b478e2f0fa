#include "core/material/stated_temperature.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "core/base/header_clauses.h"
#include "core/base/input_error.h"
#include "core/base/text.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/material/dma_columns.h"
#include "core/material/isotherms.h"

namespace asperity {
namespace {

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
  constexpr std::array<std::string_view, 36> kStems{
      "instrument", "ger\u00E4t", "device",      "glas",    "dens",        "dicht",
      "hardn",      "h\u00E4rte", "toler",       "oven",    "ofen",        "furnace",
      "range",      "bereich",    "maxim",       "minim",   "limit",       "grenz",
      "heat",       "heiz",       "aufheiz",     "cool",    "k\u00FChl",   "soak",
      "halte",      "ramp",       "increment",   "schritt", "differ",      "offset",
      "gradient",   "accur",      "abk\u00FChl", "genauig", "h\u00F6chst", "resolution"};
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

/// Reads the lines above one block.
class HeaderReader {
 public:
  /// isStrict: whether an impossible temperature is refused.
  HeaderReader(std::string name, std::string unit, bool isStrict)
      : name_(std::move(name)), unit_(std::move(unit)), isStrict_(isStrict) {}

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
    if (hasHead && std::ranges::any_of(wordsIn(head), isOfMaking)) return;
    const Words words = wordsIn(line);
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
    const Words words = wordsIn(before);
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
    const Words words = wordsIn(clause);
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
        std::ranges::any_of(wordsIn(key), isVague) ? Rank::Bare : rank);
  }

  static Rank rankOf(std::string_view key) {
    const Words words = wordsIn(key);
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

  std::string name_, unit_;
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

std::optional<double> statedReference(const TextTable& table, const std::string& unit) {
  std::optional<double> reference;
  HeaderReader reader({}, unit, false);
  for (const TextBlock& block : table.blocks)
    for (const Statement& statement : reader.read(block.header))
      if (statement.rank == Rank::Reference) reference = statement.kelvin;
  return reference;
}

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

}  // namespace asperity
