#include "core/material/stated_temperature.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <vector>

#include "core/base/input_error.h"
#include "core/base/text.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/material/dma_columns.h"
#include "core/material/isotherms.h"

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
         isOneOf(word, {"tg",      "rate", "wlf",   "c1",     "c2",      "c\u2081", "c\u2082",
                        "max",     "min",  "tmax",  "tmin",   "dt",      "delta",   "\u03B4t",
                        "\u0394t", "step", "start", "end",    "final",   "stop",    "anfang",
                        "ende",    "tm",   "drift", "limits", "heizrate"});
}

/// Returns whether a word says that a temperature need not be the sample's.
bool isVague(const std::string& word) {
  constexpr std::array<std::string_view, 9> kStems{
      "ambient", "raum", "umgebung", "soll", "target", "nominal", "program", "setpoint", "lab"};
  return beginsWithAny(word, kStems) || isOneOf(word, {"room", "set", "tset", "tsoll"});
}

/// Returns whether a word names the temperature to which a master curve is shifted.
bool isOfReference(const std::string& word) {
  constexpr std::array<std::string_view, 2> kStems{"ref", "bezug"};
  return beginsWithAny(word, kStems) || isOneOf(word, {"tref", "tr", "t0", "tbezug"});
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

/// Reads the lines above one block.
class HeaderReader {
 public:
  HeaderReader(const std::string& name, const std::string& unit) : name_(name), unit_(unit) {}

  std::vector<Statement> read(const std::vector<TextEntry>& header) {
    found_.clear();
    for (const TextEntry& entry : header) readEntry(entry);
    return std::move(found_);
  }

 private:
  void readEntry(const TextEntry& entry) {
    const std::string line =
        entry.key.empty() ? entry.value : fmt::format("{} = {}", entry.key, entry.value);
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
    if (std::ranges::any_of(words, isVague)) rank = Rank::Bare;
    if (rank == Rank::Bare && isLineOfOther) return;
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
    if (!quantity || rank == Rank::Bare || std::ranges::any_of(wordsOf(clause), isOfOther)) return;
    std::string unit = unit_.empty() ? quantity->unit : unit_;
    if (unit.empty()) unit = parseColumnName(key).unit;
    if (unit.empty()) unit = quantity->number >= 200 ? "K" : "C";
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
    } else if (rank != Rank::Bare) {
      throw InputError(name_, fmt::format("line {}", line),
                       message("states a temperature of {:.6g} K, at which no rubber is measured; "
                               "correct it, or state that of the test with --temperature",
                               kelvin));
    }
  }

  const std::string& name_;
  const std::string& unit_;
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
  HeaderReader reader(name, unit);
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
