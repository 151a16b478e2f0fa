#include "core/measured/text_lengths.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text.h"
#include "core/base/text_clause.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/base/text_units.h"
#include "core/base/units.h"

namespace asperity {
namespace {

/// Returns the number of points that a part of a line states: "400 points" in "Total length: 200
/// um, 400 points".
std::optional<std::int64_t> countInClause(const TextPart& in) {
  constexpr WordList kWords(
      "points, pts, pt, data points, samples, punkte, messpunkte, datenpunkte, punti, puntos, "
      "pontos, points de mesure",
      ',');
  std::optional<std::int64_t> found;
  for (const TextEntry* const entry : in.entriesAbove())
    for (const std::string_view clause : splitClauses(entry->value))
      if (const auto quantity = parseQuantity(clause);
          quantity && quantity->number > 0 && isOneOf(lowerCase(quantity->unit), kWords))
        if (const auto count = wholeNumber(quantity->number)) found = count;
  return found;
}

/// Returns whether a text names an axis and says nothing but that positions on it follow: "x from",
/// "X range", "x-axis", "Axis X".
bool namesAxis(std::string_view text, char axis) {
  constexpr WordList kWords(
      "from range position positions axis limits von bereich achse de da axe");
  bool isNamed = false;
  for (const std::string& word : wordsIn(text)) {
    const bool isAxis = word.size() == 1 && word.front() == axis;
    if (!isAxis && !isOneOf(word, kWords)) return false;
    isNamed = isNamed || isAxis;
  }
  return isNamed;
}

/// Returns the length from the first to the last position that a line states: "x from 0 to 199.5
/// um", "X range: 0 - 199.5 um", "x (mm): 0 ... 0.2"; nothing where it states none.
std::optional<HeaderLength> lengthBetweenEnds(const TextEntry& entry, char axis) {
  std::string line = lowerCase(joinEntry(entry, " "));
  for (const std::string_view dots : {"...", "..", "\u2026"}) replaceAll(line, dots, " to ");
  std::size_t number = line.find_first_of("0123456789");
  while (number != line.npos && number > 0 &&
         isOneOf(line.substr(number - 1, 1), WordList("+ - .")))
    --number;
  if (number == line.npos || number == 0) return {};
  const TextColumn name = parseColumnName(line.substr(0, number));
  const auto first = parseQuantity(std::string_view(line).substr(number));
  if (!first || !namesAxis(name.name, axis)) return {};
  for (const std::string_view between : WordList("to bis hasta ate \u00E0 a \u2013 -")) {
    const std::size_t at = first->unit.find(between);
    if (at == std::string::npos) continue;
    const std::string_view unit = trimmedBlanks(std::string_view(first->unit).substr(0, at));
    const auto last = parseQuantity(std::string_view(first->unit).substr(at + between.size()));
    if (!last || !(last->number > first->number)) continue;
    const std::string& own = last->unit.empty() ? name.unit : last->unit;
    const auto metres = metresPer(own);
    if (metres && (unit.empty() || metresPer(unit) == metres))
      return HeaderLength{last->number - first->number, StatedUnit{own, *metres}};
  }
  return {};
}

/// Returns the length between two positions of an axis that two lines state: "Start X = 0 um" and
/// "End X = 199.5 um"; nothing where they are not clear.
std::optional<HeaderLength> lengthBetweenLines(const TextPart& in, char axis) {
  constexpr WordList kFirst("start first begin min anfang debut inizio inicio 0"),
      kLast("end stop last max ende fin fine final 1");
  struct Position {
    double number = 0;
    std::string unit{};
  };
  std::optional<Position> first, last;
  for (const TextEntry* const entry : in.entriesAbove()) {
    const TextColumn name = parseColumnName(entry->key);
    const std::string word = plainWord(lowerCase(name.name));
    const auto quantity = parseQuantity(entry->value);
    if (word.size() < 2 || !quantity) continue;
    for (const std::string_view end :
         {word.starts_with(axis) ? std::string_view(word).substr(1) : "",
          word.ends_with(axis) ? std::string_view(word).substr(0, word.size() - 1) : ""}) {
      const Position position{quantity->number,
                              quantity->unit.empty() ? name.unit : quantity->unit};
      if (isOneOf(end, kFirst)) first = position;
      if (isOneOf(end, kLast)) last = position;
    }
  }
  if (!first || !last || !(last->number > first->number)) return {};
  HeaderLength length{last->number - first->number};
  length.note = "The points are as far apart as their first and last position in the header say.";
  if (first->unit.empty()) first->unit = last->unit;
  if (last->unit.empty()) last->unit = first->unit;
  if (last->unit.empty()) return length;
  const auto metres = metresPer(last->unit);
  if (!metres || metresPer(first->unit) != metres) return {};
  length.unit = StatedUnit{last->unit, *metres};
  return length;
}

/// Returns the first of these entries with a quantity of this SI unit, in that unit.
std::optional<double> quantityAbove(const TextPart& in, const WordList& keys, std::string_view si) {
  for (const std::string_view key : keys)
    if (const auto quantity = parseQuantity(in.entry(key)); quantity)
      if (const auto unit = findUnit(quantity->unit, si); unit && quantity->number > 0)
        return unit->toSi(quantity->number);
  return {};
}

}  // namespace

std::optional<std::int64_t> statedCount(const TextPart& in, Counted counted) {
  constexpr WordList kPoints(
      "points, number of points, no. of points, data points, number of data points, data number, "
      "samples, number of samples, samps, npoints, n points, punkte, anzahl punkte, punktanzahl, "
      "punktzahl, messpunkte, anzahl messpunkte, nombre de points, numero di punti, n\u00FAmero "
      "de puntos, n\u00FAmero de pontos, \u30C7\u30FC\u30BF\u6570, "
      "\uFF83\uFF9E\uFF70\uFF80\u6570, \u00C3\u00DE\u00B0\u00C0\u0090\u201D, "
      "\u70B9\u6570",
      ',');
  constexpr WordList kColumnWords(
      "nx, ncols, cols, columns, number of columns, x points, points x, points in x, samps/line, "
      "\\samps/line, samples/line, samples per line, "
      "points per line, pixels in x, x pixels, horizontal, spalten, anzahl spalten, nombre de "
      "colonnes, \u6A2A",
      ',');
  constexpr WordList kRowWords(
      "ny, nrows, rows, number of rows, y points, points y, points in y, lines, \\lines, number of "
      "lines, \\number of lines, pixels in y, y "
      "pixels, vertical, zeilen, anzahl zeilen, nombre de lignes, \u7E26",
      ',');
  for (const std::string_view key : counted == Counted::Points    ? kPoints
                                    : counted == Counted::Columns ? kColumnWords
                                                                  : kRowWords)
    if (const auto number = parseQuantity(in.entry(key)); number && number->number > 0)
      if (const auto count = wholeNumber(number->number)) return count;
  if (counted == Counted::Points) return countInClause(in);
  return {};
}

std::optional<HeaderLength> countedStep(const TextPart& in, std::int64_t count, char axis) {
  for (const std::string_view form : kAxisForms) {
    std::string key(form);
    replaceAll(key, "{}", std::string_view(&axis, 1));
    const std::string text = in.entry(key);
    const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
    const auto length = parseQuantity(std::string_view(text).substr(end));
    double points = 0;
    if (!length || !readTextNumber(std::string_view(text).substr(0, end), '.', points)) continue;
    const auto metres = metresPer(length->unit);
    if (!metres || points != static_cast<double>(count) || count < 2 || !(length->number > 0))
      continue;
    return HeaderLength{length->number / (points - 1), StatedUnit{length->unit, *metres}};
  }
  std::optional<HeaderLength> between;
  for (const TextEntry* const entry : in.entriesAbove())
    if (!between) between = lengthBetweenEnds(*entry, axis);
  if (!between && statedCount(in, Counted::Points).value_or(count) == count)
    between = lengthBetweenLines(in, axis);
  if (between && count > 1) {
    between->value /= static_cast<double>(count - 1);
    return between;
  }
  constexpr WordList kDensities(
      "points per mm, points/mm, data points per mm, samples per mm, samples/mm, pixels per mm, "
      "punkte pro mm, punkte/mm, messpunkte pro mm, points par mm",
      ',');
  for (const std::string_view density : kDensities)
    if (const auto perMillimetre = parseQuantity(in.entry(density));
        perMillimetre && perMillimetre->number > 0)
      return HeaderLength{1 / perMillimetre->number, StatedUnit{"mm", 1e-3}};
  constexpr WordList kTraverses(
      "traverse length, measuring length, measurement length, tracing length, messl\u00E4nge, "
      "messstrecke, taststrecke, longueur de mesure, \u6E2C\u5B9A\u9577\u3055, length, total "
      "length, profile length, scan length, l\u00E4nge, gesamtl\u00E4nge, longueur, longueur "
      "totale, lunghezza, longitud, comprimento, evaluation length, auswertel\u00E4nge, longueur "
      "d'\u00E9valuation",
      ',');
  if (axis != 'x' || count < 2 || statedCount(in, Counted::Points) != count) return {};
  for (const std::string_view traverse : kTraverses) {
    std::string text = in.entry(traverse);
    for (const char* symbol : {" lt", " ln"})  // "Taststrecke lt"
      if (text.empty()) text = in.entry(std::string(traverse) + symbol);
    const auto clauses = splitClauses(text);
    auto length = clauses.empty() ? std::nullopt : lengthIn(clauses.front());
    if (!length || !length->unit) continue;
    length->value /= static_cast<double>(count - 1);
    return length;
  }
  return {};
}

std::optional<HeaderLength> sampledStep(const TextPart& in) {
  constexpr WordList kSpeeds(
      "speed, scan speed, scanning speed, measuring speed, measurement speed, traverse speed, "
      "tracing speed, stylus speed, drive speed, vt, vorschub, vorschubgeschwindigkeit, "
      "messgeschwindigkeit, tastgeschwindigkeit, vitesse, vitesse de mesure, vitesse de palpage, "
      "velocidad, velocidad de medida, velocit\u00E0, velocit\u00E0 di misura, velocidade",
      ',');
  constexpr WordList kRates(
      "sampling rate, sample rate, sampling frequency, data rate, acquisition rate, abtastrate, "
      "abtastfrequenz, messrate, fr\u00E9quence d'\u00E9chantillonnage, frecuencia de muestreo, "
      "frequenza di campionamento",
      ',');
  const auto speed = quantityAbove(in, kSpeeds, "m/s");
  const auto rate = quantityAbove(in, kRates, "Hz");
  if (!speed || !rate) return {};
  constexpr double kMicrometre = 1e-6;
  HeaderLength step{*speed / *rate / kMicrometre, StatedUnit{"\u00B5m", kMicrometre}};
  step.note = "The points are as far apart as the speed and the sampling rate of the header say.";
  return step;
}

}  // namespace asperity
