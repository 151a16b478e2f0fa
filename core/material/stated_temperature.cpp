#include "core/material/stated_temperature.h"

#include <fmt/format.h>
#include <ranges>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <vector>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_cell.h"
#include "core/base/text_clause.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/material/dma_columns.h"
#include "core/material/isotherms.h"
#include "core/material/test_words.h"

namespace asperity {
namespace {

/// How certainly a statement is about the test: an entry with a key, a reference of the curve, the
/// temperature of a sentence about the test, one of any other sentence. Those of a shift are the
/// reference of its constants, a temperature beside them, and a glass transition, which is that of
/// no test.
enum class Rank { Test, Reference, Measured, Bare, ShiftReference, BesideShift, Glass };

struct Statement {
  double kelvin = 0;
  std::size_t line = 0;
  Rank rank = Rank::Bare;
  std::string text{};  // the line, to be quoted
};

/// Returns whether a text goes on from one end of a range to the other: "to 60 °C", "... 60 °C".
bool beginsAsRange(std::string_view text) {
  text = trimmedBlanks(text);
  return text.starts_with("to ") || text.starts_with("bis ") ||
         beginsWithOneOf(text, ".. \u2026 \u2013 \u2014 - \u2212");
}

/// Returns whether a text ends within a range: "-150 to", "-150 ...".
bool endsWithinRange(std::string_view text) {
  text = trimmedBlanks(text);
  for (const std::string_view sign : WordList("to bis .. \u2026 \u2013 \u2014 -"))
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
    text_ = joinEntry(entry);
    written_ = entry.written;
    line_ = entry.line;
    const std::vector<std::string> words = wordsIn(text_);
    isLineOfOther_ = areOfOther(words);
    isLineOfShift_ = areOfShift(words);
    isOfMaking_ = isMakingDone_ = false;
    for (const std::string_view clause : splitClauses(text_)) {
      // What a clause says about making holds for the next ones, too, until one is about the test.
      const std::vector<std::string> own = withoutNamesOfMixtures(wordsIn(clause));
      if (areOfTest(own) && !std::ranges::any_of(own, isOfMaking)) isOfMaking_ = false;
      if (isLineOfShift_)
        for (const std::string_view statement : splitStatements(clause)) readClause(statement);
      else
        readClause(clause);
      if (std::ranges::any_of(own, isOfMaking)) isOfMaking_ = true;
      if (isOfMaking_ && firstTemperature(clause)) isMakingDone_ = true;
    }
  }

  void readClause(std::string_view clause) {
    std::size_t begin = 0;
    while (const auto found = firstTemperature(clause.substr(begin))) {
      if (readTemperature(clause.substr(begin), *found)) return;
      begin += found->end;
      // The second temperature of "cured at 160 °C and tested at 20 °C" has words of its own.
      const auto next = firstTemperature(clause.substr(begin));
      if (!next) return;
      const std::vector<std::string> words = wordsIn(clause.substr(begin, next->begin));
      if (!areOfTest(words) && !(isLineOfShift_ && hasOneOf(words, "at bei tref tg"))) return;
      isOfMaking_ = false;
    }
    if (begin == 0) readPlainNumber(clause);
  }

  /// Reads the first temperature of a text. Returns whether it may be that of the test; otherwise
  /// what stands after it is read, too.
  bool readTemperature(std::string_view clause, const TextTemperature& found) {
    std::string_view before = clause.substr(0, found.begin);
    if (beginsAsRange(clause.substr(found.end)) || endsWithinRange(before)) return false;
    double kelvin = found.kelvin, number = found.number;
    for (const std::string_view sign : kErrorSigns)
      if (trimmedBlanks(before).ends_with(sign)) {
        // "20 ± 0.5 °C"
        const std::string_view whole = trimmedBlanks(withoutEnd(trimmedBlanks(before), sign));
        const std::size_t begin = whole.find_last_of(" :=") + 1;
        const auto middle = parseQuantity(whole.substr(begin));
        if (!middle) return false;
        before = before.substr(0, begin);
        number = middle->number;
        kelvin = temperatureUnit(found.unit)->toSi(number);
      }
    const std::string_view key = keyBefore(before);
    const std::vector<std::string> words = wordsIn(before);
    if ((isLineOfShift_ || areOfGlass(words)) && addOfShift(words, kelvin)) return false;
    if (areOfOther(words)) return false;
    Rank rank = rankOf(key);
    if (rank == Rank::Reference && isLineOfShift_ && !hasOneOf(words, "master curve kurve"))
      rank = Rank::ShiftReference;
    if (rank != Rank::Bare)
      if (const auto scale = unit_.empty() ? std::nullopt : temperatureUnit(unit_))
        kelvin = scale->toSi(number);
    if (rank != Rank::Bare && hasOneOf(words, "step steps")) return false;
    // "run_3C" and "Probe 3C" are names of specimens.
    const bool mayBeName = before.ends_with('_') || !areOfTest(words);
    if (rank == Rank::Bare && found.isLetter && std::abs(number) < 10 && mayBeName) return false;
    // The temperature of "Curing: 10 min; T = 160 °C" is that of curing; the second of "Aging: 70
    // °C; Temperature: 20 °C" is not.
    const bool isOwn = rank == Rank::Reference || (rank != Rank::Bare && isMakingDone_);
    if (isOfMaking_ && !isOwn) return false;
    const bool isOfTest = areOfTest(words), isKeyed = rank != Rank::Bare;
    if (std::ranges::any_of(words, isVague)) {
      rank = Rank::Bare;
    } else if (rank == Rank::Bare && isOfTest) {
      // "tested after 24 h at 40 °C" and "test piece swollen at 40 °C" are in doubt.
      const std::vector<std::string> ofTest(std::ranges::find_if(words, isTestWord), words.end());
      if (stateDuration(ofTest) || !areOnlyOfTest(ofTest)) return false;
      rank = Rank::Measured;
    }
    if (rank == Rank::Bare &&
        (isKeyed ? isLineOfOther_ : !isBareTemperature(before, found, clause.substr(found.end))))
      return false;
    add(kelvin, rank);
    return true;
  }

  /// Returns whether a temperature without a key and without a word about the test may be that of
  /// the test: it stands alone, in brackets, after a dash, a comma or "@", or ends the name of a
  /// sample, and the line is about nothing else than a test or a sample. A letter alone as the
  /// unit needs more than a blank in front of its number: "NETZSCH DMA 242 C".
  bool isBareTemperature(std::string_view before, const TextTemperature& found,
                         std::string_view behind) const {
    if (isLineOfOther_) return false;
    // "Mischung 1 160 °C" is mixed at that temperature.
    constexpr double kHottestBesideMixture = 403;  // K
    if (found.kelvin > kHottestBesideMixture && std::ranges::any_of(wordsIn(text_), isMixture))
      return false;
    before = trimmedBlanks(before);
    const bool isMarked = endsWithOneOf(before, "( [ @");
    before = withoutEnd(before, "@([");
    const bool isBehindDash = before.ends_with('-') || before.ends_with("\u2013");
    const LineTemperatures ofLine = temperaturesOfLine();
    const bool isInName = before.ends_with('_') && ofLine.count == 1 && isUsual(found.kelvin);
    // "Step 3: 20 °C"
    const bool isBehindKey = endsWithOneOf(before, ": =") && areOnlyOfTest(wordsIn(before));
    const std::vector<std::string> front = wordsIn(before);
    const bool isSeparated = isBehindDash || isBehindKey || isMarked || isInName || front.empty() ||
                             isOneOf(lowerCase(before), "at bei \u00E0 t");
    // "Td 320 °C" and "Ts 10 °C" are other temperatures.
    constexpr std::size_t kSymbol = 3;
    const bool isBehindSymbol =
        !front.empty() && front.back().starts_with('t') && front.back().size() <= kSymbol;
    if (!isSeparated && (found.isLetter || found.unit == "K" || isBehindSymbol)) return false;
    if (!isInName && !wordsIn(behind).empty()) return false;
    // "3C, 20 °C": the letter belongs to the name of a sample.
    if (found.isLetter && ofLine.hasWrittenOut) return false;
    // The parts of "NR_aged_70C" are words.
    std::string parts = text_;
    std::ranges::replace(parts, '_', ' ');
    const std::vector<std::string> words = wordsIn(parts);
    return areOnlyOfTest(words) && !stateDuration(words) && !areOfOther(words) &&
           std::ranges::none_of(words, isVague);
  }

  /// Returns whether a rubber may have been tested at this temperature, K.
  static bool isUsual(double kelvin) {
    constexpr double kColdestUsual = 173, kHottestUsual = 474;
    return kelvin > kColdestUsual && kelvin < kHottestUsual;
  }

  struct LineTemperatures {
    int count = 0;
    bool hasWrittenOut = false;  // one with a unit that is more than a letter
  };

  LineTemperatures temperaturesOfLine() const {
    LineTemperatures all;
    std::string_view rest = text_;
    while (const auto found = firstTemperature(rest)) {
      ++all.count;
      all.hasWrittenOut = all.hasWrittenOut || !found->isLetter;
      rest.remove_prefix(found->end);
    }
    return all;
  }

  /// Adds a temperature in a line about a shift, or of a glass transition. Returns whether it is
  /// one.
  bool addOfShift(const std::vector<std::string>& words, double kelvin) {
    if (hasOneOf(words, "c1 c2 c\u2081 c\u2082") && !hasOneOf(words, "at bei")) return false;
    const bool isShift = hasOneOf(words, "wlf"), isGlass = areOfGlass(words);
    if (hasOneOf(words, "twlf") || (isShift && std::ranges::any_of(words, isOfReference)))
      add(kelvin, Rank::ShiftReference);
    else if (isGlass && !isShift)
      add(kelvin, Rank::Glass);
    else if (isGlass || isShift ||
             (isLineOfShift_ && hasOneOf(words, "at bei") && !areOfTest(words) &&
              !hasOneOf(words, "master curve kurve")))
      add(kelvin, Rank::BesideShift);
    else
      return false;
    return true;
  }

  /// Reads "Temperature [°C]: 20", "T/K = 293" and "Temperature: 20".
  void readPlainNumber(std::string_view clause) {
    const auto statement = parseStatement(clause);
    if (!statement) return;
    Rank rank = rankOf(statement->key);
    const std::vector<std::string> words = wordsIn(clause);
    const bool isShift = isLineOfShift_ && hasOneOf(words, "wlf twlf") &&
                         (rank == Rank::Reference || hasOneOf(words, "twlf"));
    if (isShift) rank = Rank::ShiftReference;
    if (rank == Rank::Bare || (areOfOther(words) && !isShift) || hasOneOf(words, "step steps"))
      return;
    if (isOfMaking_ && !isMakingDone_ && rank != Rank::Reference) return;
    if (rank == Rank::Reference && isLineOfShift_) rank = Rank::ShiftReference;
    const double number = statement->quantity.number;
    std::string unit = unit_.empty() ? statement->unit() : unit_;
    if (unit.empty()) {
      // "Reference: 2041" is no temperature, and t may be a time.
      if (!namesOneTemperature(statement->key)) return;
      unit = assumedTemperatureUnit(number);
    }
    const auto scale = temperatureUnit(unit);
    if (!scale) return;
    add(scale->toSi(number),
        std::ranges::any_of(wordsIn(statement->key), isVague) ? Rank::Bare : rank);
  }

  static Rank rankOf(std::string_view key) {
    const std::vector<std::string> words = wordsIn(key);
    if (std::ranges::any_of(words, isOfReference)) return Rank::Reference;
    // "Temp\u00E9rature de vieillissement" is none of the test.
    if (words.size() > 1 && !areOnlyOfTest(words) && !std::ranges::any_of(words, isVague))
      return Rank::Bare;
    if (isTemperatureWord(key) || isTemperatureWord(parseColumnName(key).name)) return Rank::Test;
    return !words.empty() && isTemperatureWord(words.back()) ? Rank::Test : Rank::Bare;
  }

  void add(double kelvin, Rank rank) {
    const bool isOfTest = rank == Rank::Test || rank == Rank::Reference;
    if (kelvin >= kColdestTest) {
      found_.push_back({kelvin, line_, rank, written_});
    } else if (isOfTest && isStrict_) {
      throw InputError(name_, fmt::format("line {}", line_),
                       message("states a temperature of {:.6g} K, at which no rubber is measured; "
                               "correct it, or state that of the test with --temperature",
                               kelvin));
    }
  }

  std::string name_, unit_;
  bool isStrict_;
  std::vector<Statement> found_;
  // Of the line that is read:
  std::string text_{}, written_{};  // the line as it is read, and as it is quoted
  std::size_t line_ = 0;
  bool isLineOfOther_ = false, isLineOfShift_ = false;
  bool isOfMaking_ = false;    // whether the clauses before are about making
  bool isMakingDone_ = false;  // whether these have stated their temperature
};

bool isOneOfTest(Rank rank) {
  return rank == Rank::Test || rank == Rank::Reference || rank == Rank::Measured ||
         rank == Rank::Bare;
}

/// Returns the one temperature of these statements. Throws InputError where they differ.
HeaderTemperature onlyTemperature(const std::vector<Statement>& statements,
                                  const std::string& name) {
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
  const Statement& last = statements.back();
  return {last.kelvin, last.line, last.text};
}

}  // namespace

std::optional<double> statedShiftReference(const TextTable& table, const std::string& unit,
                                           bool isOfGlass) {
  std::vector<Statement> all;
  HeaderReader reader({}, unit, false);
  const auto read = [&](const std::vector<TextEntry>& header) {
    std::ranges::move(reader.read(header), std::back_inserter(all));
  };
  for (const TextBlock& block : table.blocks) read(block.header);
  std::vector<Rank> order{Rank::ShiftReference, Rank::BesideShift, Rank::Reference};
  if (isOfGlass) order.push_back(Rank::Glass);
  for (const Rank rank : order)
    for (auto one = all.rbegin(); one != all.rend(); ++one)
      if (one->rank == rank) return one->kelvin;
  return {};
}

std::optional<HeaderTemperature> distrustedTemperature(const TextPart& in) {
  for (const TextBlock& one : std::views::reverse(in.blocksUpTo()))
    for (const TextEntry& entry : one.header)
      if (const auto found = findTemperature(joinEntry(entry)))
        return {{*found, entry.line, entry.written}};
  return {};
}

std::optional<HeaderTemperature> temperatureInName(const std::string& fileName) {
  const std::string stem = std::filesystem::path(fileName).stem().string();
  const std::vector<TextEntry> name{{.key = {}, .value = stem, .written = stem}};
  const std::vector<Statement> all = HeaderReader({}, {}, false).read(name);
  const bool isOne = all.size() == 1 && isOneOfTest(all.front().rank);
  return isOne ? std::optional(HeaderTemperature{all.front().kelvin, 0, all.front().text})
               : std::nullopt;
}

std::optional<HeaderTemperature> statedTemperature(const TextPart& in, const std::string& name,
                                                   const std::string& unit, bool isReduced) {
  std::array order{Rank::Test, Rank::Reference, Rank::Measured, Rank::Bare, Rank::ShiftReference};
  if (isReduced) std::swap(order[0], order[1]);
  HeaderReader reader(name, unit, true);
  for (const TextBlock& one : std::views::reverse(in.blocksUpTo())) {
    const std::vector<Statement> all = reader.read(one.header);
    for (const Rank rank : order) {
      std::vector<Statement> some;
      std::ranges::copy_if(all, std::back_inserter(some),
                           [rank](const Statement& each) { return each.rank == rank; });
      if (!some.empty()) return onlyTemperature(some, name);
    }
  }
  return {};
}

std::optional<HeaderTemperature> temperatureBelow(const TextTable& table, const std::string& name,
                                                  const std::string& unit, bool isReduced) {
  TextTable below;
  below.blocks.push_back({.header = table.trailer});
  return statedTemperature({below, below.blocks.front()}, name, unit, isReduced);
}

}  // namespace asperity
