#include "core/fit/friction_preparation.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/text.h"
#include "core/base/text_cell.h"
#include "core/base/text_clause.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/base/text_units.h"
#include "core/fit/friction_columns.h"
#include "core/fit/friction_roles.h"

namespace asperity {
namespace {

/// Calls use(column, end) for each column with a known meaning that the words from `begin` to `end`
/// make, `most` words at the most, until it returns true. Returns whether it did.
template <class Use>
bool anyColumn(const std::vector<std::string_view>& words, std::size_t begin, std::size_t most,
               const Use& use) {
  std::string text;
  for (std::size_t i = begin; i < std::min(words.size(), begin + most); ++i) {
    appendItem(text, words[i], " ");
    const TextColumn column = parseColumnName(text);
    if (findMeaning(column) && use(column, i + 1)) return true;
  }
  return false;
}

/// Finds all ways to make so many known columns of the words from `begin` on.
void findNames(const std::vector<std::string_view>& words, std::size_t begin, std::size_t count,
               std::vector<TextColumn>& made, std::vector<std::vector<TextColumn>>& ways) {
  constexpr std::size_t kMaxWords = 6, kMaxWays = 2;
  if (ways.size() >= kMaxWays) return;
  if (made.size() == count || begin == words.size()) {
    if (made.size() == count && begin == words.size()) ways.push_back(made);
    return;
  }
  // A unit in brackets begins no name.
  if (words[begin].starts_with('(') || words[begin].starts_with('[')) return;
  anyColumn(words, begin, kMaxWords, [&](const TextColumn& column, std::size_t end) {
    made.push_back(column);
    findNames(words, end, count, made, ways);
    made.pop_back();
    return false;
  });
}

/// Gives names to columns whose line of names has blanks within the names as well.
void findNames(TextBlock& block) {
  if (block.hasNames() || block.header.empty()) return;
  std::vector<std::vector<TextColumn>> ways;
  std::vector<TextColumn> made;
  const std::string line = joinEntry(block.header.back(), " ");
  findNames(splitWords(line), 0, block.columns.size(), made, ways);
  for (std::size_t i = 0; ways.size() == 1 && i < block.columns.size(); ++i) {
    block.columns[i].name = ways.front()[i].name;
    block.columns[i].unit = ways.front()[i].unit;
  }
}

/// Separates from its name a unit that only friction has: "(% of mu)", and a power of ten as that
/// of a pure number, "(10^-3)" and "/ 10^-3".
void separateUnit(TextColumn& column) {
  const std::size_t open = column.name.find_last_of("([/");
  if (!column.unit.empty() || open == std::string::npos || open == 0) return;
  const bool isStroke = column.name[open] == '/';
  const std::string unit(withoutBrackets(column.name.substr(open + (isStroke ? 1 : 0))));
  if (!isWrittenPower(unit) && (isStroke || !isShareUnit(unit))) return;
  column.unit = unit;
  column.name = trimmedBlanks(column.name.substr(0, open));
}

/// Joins the symbol of friction to the name of its error, "s(\u00B5)" and "\u03C3_\u00B5": nobody
/// measures an error of friction in microns.
void joinSymbol(TextColumn& column) {
  // "COF (min)" and "COF (max)" are bounds.
  if (column.unit == "min" && findMeaning(column.name, {}) == FrictionQuantity::Mu)
    column = {column.name + " min", {}, column.isText};
  if (column.name.ends_with(" (max)")) replaceAll(column.name, "(max)", "max");
  if (!isOneOf(column.unit, "\u00B5 \u03BC")) return;
  const std::string name = column.name + "(" + column.unit + ")";
  if (findMeaning(name, {}) != FrictionQuantity::MuError) return;
  column.name = name;
  column.unit.clear();
}

/// Splits "mu \u00B1 2 sigma", the name of a column with errors in its cells; returns the name of
/// the errors.
std::string takeErrorName(TextColumn& column) {
  const std::string name = column.name;
  const auto sides = splitAtErrorSign(name);
  if (!sides || sides->number.empty()) return {};
  column.name = trimmedBlanks(sides->number);
  const std::string_view errors = trimmedBlanks(sides->error);
  return isOneOf(errors, "u s") ? std::string() : std::string(errors);
}

/// Appends a column of the errors that stand in the cells of another one.
void appendErrors(TextBlock& block, std::size_t of, const std::string& name) {
  TextColumn column{name.empty() ? "standard error" : name, block.columns[of].unit};
  column.errorsOf = of;
  std::vector<double> errors;
  std::vector<TextCell> cells(block.rows);
  for (std::size_t row = 0; row < block.rows; ++row) {
    errors.push_back(block.cells[of][row].error);
    cells[row].unit = block.cells[of][row].unit;
  }
  block.append(std::move(column), errors);
  block.cells.back() = std::move(cells);
}

/// Gives the errors in the cells of the coefficient of friction a column of their own.
void separateErrors(TextBlock& block) {
  std::optional<std::size_t> found;
  std::string name;
  std::size_t count = 0;
  for (std::size_t i = 0; i < block.columns.size(); ++i) {
    TextColumn& column = block.columns[i];
    std::string ofErrors;
    if (hasErrors(block.cells[i])) ofErrors = takeErrorName(column);
    if (findMeaning(column) != FrictionQuantity::Mu) continue;
    ++count;
    if (!hasErrors(block.cells[i])) continue;
    found = i;
    name = ofErrors;
  }
  if (found && count == 1) appendErrors(block, *found, name);
}

/// Keeps the cells of labels as they are written: "5 N" may name a sample. Complex numbers are no
/// numbers of friction.
void keepLabels(TextBlock& block) {
  for (std::size_t i = 0; i < block.columns.size(); ++i) {
    std::vector<TextCell>& cells = block.cells[i];
    const bool isLabel =
        findMeaning(block.columns[i]) == FrictionQuantity::Label &&
        std::ranges::all_of(cells, [](const TextCell& cell) { return !cell.text.empty(); });
    const bool isComplex = std::ranges::any_of(
        cells, [](const TextCell& cell) { return !std::isnan(cell.imaginary); });
    if (cells.empty() || !(isLabel || isComplex)) continue;
    block.columns[i].isText = true;
    for (const TextCell& cell : cells) block.texts[i].push_back(cell.text);
    cells.clear();
  }
}

// ---- Several states side by side ----------------------------------------------------------------

/// A temperature, load or velocity in the name of a column, and the column without it.
struct NamedState {
  FrictionQuantity quantity = FrictionQuantity::Temperature;
  double value = 0;   // SI
  double number = 0;  // as written
  std::string unit{};
  TextColumn column{};
  std::optional<FrictionQuantity> meaning{};  // of that column
};

/// Reads "mu 5 \u00B0C", "mu_5C", "mu@5 N", "mu (0.1 MPa)", "mu v=1 mm/s", "mu_error 5 \u00B0C".
/// The unit of the state may have been taken for that of the column.
std::optional<NamedState> stateOf(const TextColumn& column) {
  // "mu 1 bar" has been taken for a quantity in 1/bar.
  const bool isOne = column.unit.starts_with("1/");
  const std::string unit = isOne ? "1 " + column.unit.substr(2) : column.unit;
  for (const bool isJoined : {false, true}) {
    const std::string text = isJoined ? column.name + " " + unit : column.name;
    std::size_t number = text.find_first_of("0123456789");
    if (number == 0 || number == text.npos) continue;
    const bool hasMinus = text[number - 1] == '-' && number > 1 &&
                          std::isalnum(static_cast<unsigned char>(text[number - 2])) == 0;
    if (hasMinus) --number;
    const auto state = parseQuantity(withoutEnd(std::string_view(text).substr(number), ")] "));
    const auto quantity = state ? stateOfUnit(state->unit) : std::nullopt;
    if (!quantity) continue;
    NamedState found{*quantity, unitOfQuantity(state->unit, *quantity)->toSi(state->number),
                     state->number, state->unit};
    std::string_view name = withoutEnd(std::string_view(text).substr(0, number), " ([@_,=T");
    for (const std::string_view word : WordList(" at, bei", ','))
      if (name.ends_with(word) && name.size() > word.size() + 1)
        name = withoutEnd(name.substr(0, name.size() - word.size()), " ");
    // "mu v=1 mm/s"
    if (quantity == FrictionQuantity::Velocity && name.ends_with('v'))
      name = withoutEnd(name.substr(0, name.size() - 1), " ([@_,");
    found.column.name = name;
    found.column.unit = isJoined ? std::string() : column.unit;
    found.column.isText = column.isText;
    found.meaning = findMeaning(found.column);
    // "v (1e-3 m/s)" has a power of ten in its unit.
    const bool isOfFriction =
        found.meaning == FrictionQuantity::Mu || found.meaning == FrictionQuantity::MuError;
    if (*quantity == FrictionQuantity::Velocity && !isOfFriction) continue;
    return found;
  }
  return {};
}

/// Returns the state that is the whole name of a column, "5 N", "F = 5 N" or, beside the quantity
/// of all of them, "5"; empty where there is none. of: that quantity, with its unit.
std::string bareState(const TextColumn& column, const TextColumn& of) {
  const std::string text = column.name + " " + (column.unit.empty() ? of.unit : column.unit);
  const std::size_t number = text.find_first_of("-0123456789");
  if (column.isText || number == text.npos) return {};
  const auto state = parseQuantity(withoutEnd(std::string_view(text).substr(number), ")] "));
  const auto quantity = state ? stateOfUnit(state->unit) : std::nullopt;
  if (!quantity) return {};
  const std::string name = plainWord(text.substr(0, number));
  return name.empty() || quantityNamed(name) == quantity ? text.substr(number) : std::string();
}

/// Returns whether a column has a load, a temperature or a velocity with its unit.
bool isState(const TextColumn& column) {
  return !column.unit.empty() && stateOfUnit(column.unit) &&
         findMeaning(column) == stateOfUnit(column.unit);
}

/// Returns whether a line is about a force other than the normal one, so that "friction" may be
/// that force: "Friction test (tangential force)".
bool namesOtherForce(const TextEntry& entry) {
  const std::string text = lowerCase(entry.written);
  constexpr WordList kForces(
      "force kraft kr\u00E4fte forza fuerza for\u00E7a kracht si\u0142a s\u00EDla kuvvet "
      "\u0441\u0438\u043B\u0430 \u6469\u64E6\u529B");
  constexpr WordList kNormal("normal vertical vertikal \u043D\u043E\u0440\u043C\u0430\u043B");
  return (containsOneOf(text, kForces) && !containsOneOf(text, kNormal)) ||
         std::ranges::any_of(nameWords(text), [](const std::string& word) {
           return beginsWithOneOf(word, "tang later shear tract drag longi");
         });
}

/// Returns whether a word says that numbers of friction are those of its scatter, of its extremes,
/// or of another quantity.
bool isOfOtherKind(const std::string& word) {
  constexpr WordList kOfOtherKind(
      "std stdev stddev sd sem cv ci rsd rms deviation standardabweichung standardfehler "
      "abweichung scatter streuung error errors fehler uncertainty unsicherheit variance varianz "
      "variation "
      "range spread spannweite quantile quantil interval intervall konfidenzintervall "
      "vertrauensbereich repeatability wiederholbarkeit residual residuum number anzahl count max "
      "maximum maximal maximaler maximale min minimum minimaler peak spitze static statisch "
      "statische haftreibung breakaway initial wear verschlei\u00DF depth tiefe amplitude stick "
      "difference differenz delta \u03B4 \u0394 ratio verh\u00E4ltnis relative relativer change "
      "\u00E4nderung slope steigung loss verlust increase zunahme decrease abnahme");
  return isOneOf(word, kOfOtherKind);
}

/// Returns whether a text ends with a unit that is neither one of friction nor one of a load, a
/// temperature or a velocity: "wear depth (\u00B5m)".
bool hasUnitOfOtherKind(const std::string& text) {
  const std::string unit = parseColumnName(text).unit;
  return isKnownUnit(unit) && !isPureUnit(unit) && unit != "%" && !stateOfUnit(unit);
}

/// Returns whether a line that names friction means its coefficient itself, and not "COF standard
/// deviation" or "CoF test: wear depth (\u00B5m)". In "COF at max. load" only the first word
/// counts.
bool meansFriction(const TextEntry& entry, const std::function<bool(std::string_view)>& isNamed) {
  if (hasUnitOfOtherKind(joinEntry(entry, " "))) return false;
  const std::string_view line = entry.written;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find_first_of(",;:()|", begin), line.size());
    const std::string_view clause = line.substr(begin, end - begin);
    begin = end + 1;
    if (!isNamed(clause)) continue;
    const std::vector<std::string> words = wordsIn(clause);
    std::size_t last = 0;  // beyond the words that say what of friction is meant
    for (bool wasNamed = false; last < words.size(); ++last) {
      constexpr WordList kPrepositions(
          "at bei for f\u00FCr of von vs versus with mit without ohne before vor after nach under "
          "unter over \u00FCber as als on auf in");
      if (wasNamed && isOneOf(words[last], kPrepositions)) break;
      wasNamed = wasNamed || isNamed(words[last]) || isOneOf(words[last], "friction reibung");
    }
    return std::none_of(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(last),
                        isOfOtherKind);
  }
  return true;
}

/// Returns whether a line below one that names friction says of which other kind the numbers are:
/// "std", "Wear rate (mm3/Nm)", "Statistic: max".
bool isTitleOfOtherKind(const TextEntry& entry) {
  const bool isStatement = !entry.key.empty() && !entry.value.empty();
  const std::string& text = isStatement ? entry.value : entry.written;
  const std::vector<std::string> words = wordsIn(text);
  if (words.empty() || (isStatement && text.find_first_of("0123456789") != text.npos)) return false;
  return isOfOtherKind(words.front()) || isOfOtherKind(words.back()) || hasUnitOfOtherKind(text);
}

/// Names columns that have a state alone, "5 N" and "10 N", after friction, where a line above the
/// table names it.
void nameFrictionInStates(TextBlock& block) {
  const auto isMu = [](const TextColumn& column) {
    return findMeaning(column) == FrictionQuantity::Mu;
  };
  // A unit in the cells of the first column names it: "mu;5 \u00B0C;20 \u00B0C" above "1
  // mm/s;0.6;0.5".
  std::string nameOfRows;
  if (!block.columns.empty() && !block.cells[0].empty())
    if (const auto quantity = stateOfUnit(block.cells[0].front().unit))
      nameOfRows = meaningOf(*quantity);
  const bool isCorner = !nameOfRows.empty() && isMu(block.columns.front());
  const bool hasMu =
      std::any_of(block.columns.begin() + (isCorner ? 1 : 0), block.columns.end(), isMu);
  const bool hasOtherForce = std::ranges::any_of(block.header, [&block](const TextEntry& entry) {
    return namesOtherForce(entry) && !isLineOfNames(entry, block.columns);
  });
  const auto isFriction = [hasOtherForce](const TextColumn& column, std::size_t) {
    constexpr WordList kMayBeForces(
        "friction kineticfriction dynamicfriction slidingfriction gleitreibung");
    return findMeaning(column) == FrictionQuantity::Mu &&
           !(hasOtherForce && isOneOf(plainWord(column.name), kMayBeForces));
  };
  const auto isNamed = [&isFriction](std::string_view text) {
    const std::vector<std::string_view> words = splitWords(text);
    constexpr std::size_t kMaxWords = 3;
    for (std::size_t i = 0; i < words.size(); ++i)
      if (anyColumn(words, i, kMaxWords, isFriction)) return true;
    return false;
  };
  // The line nearest to the table counts.
  const auto title =
      std::find_if(block.header.rbegin(), block.header.rend(),
                   [&](const TextEntry& entry) { return isNamed(joinEntry(entry, " ")); });
  const bool isTitled = title != block.header.rend();
  const auto isOther = [&](const TextEntry& entry) {
    return !isLineOfNames(entry, block.columns) && isTitleOfOtherKind(entry);
  };
  if (hasMu || block.columns.size() < 3 || !(isCorner || isTitled) ||
      (isTitled &&
       (!meansFriction(*title, isNamed) || std::any_of(block.header.rbegin(), title, isOther))))
    return;
  TextBlock named = block;
  if (isCorner || named.columns.front().name.empty()) named.columns.front().name = nameOfRows;
  const auto ofRows = findMeaning(named.columns.front());
  const TextColumn of =
      quantityOfHeads(named.columns.front(), named.header, [ofRows](const TextColumn& column) {
        return isState(column) && findMeaning(column) != ofRows;
      });
  for (std::size_t i = 1; i < named.columns.size(); ++i) {
    const std::string state = bareState(named.columns[i], of);
    if (state.empty()) return;
    named.columns[i] = {"mu " + state};
  }
  eraseLinesOfNames(block.header, block.columns);
  block.columns = std::move(named.columns);
}

/// The columns of friction and its error in one state.
struct StateColumns {
  double value = 0;
  std::optional<std::size_t> mu{}, error{};
};

/// Returns the states of a table that has friction in several of them side by side, each once, and
/// with an error in all or none of them; empty where it is another table, or one that is not clear.
std::vector<StateColumns> statesOf(const TextBlock& block,
                                   const std::vector<std::optional<NamedState>>& named) {
  using enum FrictionQuantity;
  std::vector<StateColumns> states;
  std::optional<FrictionQuantity> quantity;
  for (std::size_t i = 0; i < named.size(); ++i) {
    if (!named[i]) continue;
    const bool isMu = named[i]->meaning == Mu, isError = named[i]->meaning == MuError;
    if (block.columns[i].isText || !(isMu || isError)) return {};
    if (quantity && quantity != named[i]->quantity) return {};
    quantity = named[i]->quantity;
    auto state = std::ranges::find(states, named[i]->value, &StateColumns::value);
    if (state == states.end()) state = states.insert(state, {named[i]->value});
    std::optional<std::size_t>& place = isMu ? state->mu : state->error;
    if (place) return {};
    place = i;
  }
  if (states.size() < 2) return {};
  for (const StateColumns& state : states)
    if (!state.mu || state.error.has_value() != states.front().error.has_value()) return {};
  for (std::size_t i = 0; i < named.size(); ++i) {
    const auto meaning = named[i] ? std::nullopt : findMeaning(block.columns[i]);
    const auto isLoad = [](const auto& one) { return one == Force || one == Pressure; };
    const bool isSame = meaning == quantity || (isLoad(meaning) && isLoad(quantity));
    // The number of a column after those of friction would be another one.
    if (meaning == Mu || isSame || (meaning && i > *states.front().mu)) return {};
  }
  return states;
}

/// Writes friction in several states side by side one below the other.
void stackStates(TextBlock& block) {
  std::vector<std::optional<NamedState>> named;
  for (const TextColumn& column : block.columns) named.push_back(stateOf(column));
  const std::vector<StateColumns> states = statesOf(block, named);
  if (states.empty()) return;
  const StateColumns& first = states.front();
  const NamedState& example = *named[*first.mu];
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < named.size(); ++i)
    if (!named[i] || i == first.mu || i == first.error) kept.push_back(i);
  TextBlock stacked;
  stacked.header = block.header;
  // The line of names states none of all points.
  eraseLinesOfNames(stacked.header, block.columns);
  stacked.rows = block.rows * states.size();
  stacked.texts.resize(kept.size());
  stacked.cells.resize(kept.size());
  for (const std::size_t i : kept)
    stacked.columns.push_back(named[i] ? named[i]->column : block.columns[i]);
  // The velocities of one load or temperature follow one another, in either arrangement.
  const bool isInRows = example.quantity == FrictionQuantity::Velocity;
  const auto units = {"K", "N", "Pa", "m/s"};
  // In the unit of the names, where it is one.
  const bool isOneUnit = std::ranges::all_of(
      states, [&](const StateColumns& state) { return named[*state.mu]->unit == example.unit; });
  std::vector<double> values;
  for (std::size_t i = 0; i < stacked.rows; ++i) {
    const std::size_t row = isInRows ? i / states.size() : i % block.rows;
    const StateColumns& state = states[isInRows ? i % states.size() : i / block.rows];
    stacked.lines.push_back(block.lines[row]);
    values.push_back(isOneUnit ? named[*state.mu]->number : state.value);
    for (std::size_t j = 0; j < kept.size(); ++j) {
      const std::size_t from = kept[j] == first.mu      ? *state.mu
                               : kept[j] == first.error ? *state.error
                                                        : kept[j];
      stacked.values.push_back(block.at(row, from));
      if (!block.texts[from].empty()) stacked.texts[j].push_back(block.texts[from][row]);
      stacked.cells[j].push_back(block.cells[from].empty() ? TextCell{} : block.cells[from][row]);
    }
  }
  TextColumn column{meaningOf(example.quantity), example.unit};
  if (!isOneUnit)
    column.unit = *std::ranges::find_if(
        units, [&example](const char* unit) { return measures(unit, example.quantity); });
  column.isOfNames = true;
  stacked.append(std::move(column), values);
  block = std::move(stacked);
}

}  // namespace

bool hasErrors(const std::vector<TextCell>& cells) {
  return std::ranges::any_of(cells, [](const TextCell& cell) { return !std::isnan(cell.error); });
}

bool namesQuantity(const std::string& line) {
  constexpr std::size_t kMaxWords = 3;
  const std::vector<std::string_view> words = splitWords(line);
  for (std::size_t i = 0; i < words.size(); ++i)
    if (anyColumn(words, i, kMaxWords, [](const TextColumn& column, std::size_t) {
          return findMeaning(column) != FrictionQuantity::Label && column.name.size() > 1;
        }))
      return true;
  return false;
}

void prepareColumns(TextBlock& block) {
  findNames(block);
  for (TextColumn& column : block.columns) {
    separateUnit(column);
    joinSymbol(column);
  }
  keepLabels(block);
  nameFrictionInStates(block);
  stackStates(block);
  separateErrors(block);
}

}  // namespace asperity
