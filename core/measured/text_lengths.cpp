#include "core/measured/text_lengths.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "core/base/text.h"
#include "core/base/text_clause.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/base/text_units.h"
#include "core/measured/text_columns.h"

namespace asperity {
namespace {

/// The names of a kind of lengths, in lower case and with blanks in place of "-" and "_".
struct LengthNames {
  WordList ofX, ofY;  // name the axis
  WordList withAxis;  // need the letter of the axis: "x range", "size x", "deltax"
  WordList ofBoth;    // may have it
};

constexpr LengthNames kSteps{
    WordList("dx, pixelbreite, pixel width, pixelwidth, column spacing, spaltenabstand", ','),
    WordList("dy, pixelh\u00F6he, pixel height, pixelheight, line spacing, row spacing, profile "
             "spacing, track spacing, scan line spacing, scanline spacing, trace spacing, line "
             "distance, line pitch, trace distance, linienabstand, zeilenabstand, profilabstand, "
             "spurabstand",
             ','),
    WordList("delta, \u0394, \u03B4, \u2206, abstand, resolution, aufl\u00F6sung, r\u00E9solution",
             ','),
    WordList("cellsize, cell size, spacing, increment, step, step size, stepsize, sampling "
             "interval, sampling step, sample interval, point spacing, pixel size, pixelsize, "
             "punktabstand, messpunktabstand, schrittweite, abtastweite, abtastabstand, data "
             "spacing, pitch, data pitch, point pitch, sampling pitch, measuring pitch, pas, "
             "\u6E2C\u5B9A\u30D4\u30C3\u30C1, lateral resolution, xy calibration, xy justierung, "
             "xy kalibrierung, xy\uCE98\uB9AC\uBE0C\uB808\uC774\uC158, sample distance, sampling "
             "distance, sample "
             "spacing, sampling spacing, point distance, grid spacing, grid step, sampling step "
             "size, abtastschritt, abtastschrittweite, digitalisierungsabstand, rasterabstand, "
             "rasterweite, pas d'\u00E9chantillonnage, pas d\u2019\u00E9chantillonnage, pas de "
             "mesure, intervalle, intervalle d'\u00E9chantillonnage, passo, passo di "
             "campionamento, passo de amostragem, paso, paso de muestreo, intervalo de muestreo, "
             "\u30D4\u30C3\u30C1, \uFF8B\uFF9F\uFF6F\uFF81, \u00CB\u00DF\u00AF\u00C1, "
             "\u30B5\u30F3\u30D7\u30EA\u30F3\u30B0\u30D4\u30C3\u30C1, "
             "\u30B5\u30F3\u30D7\u30EA\u30F3\u30B0\u9593\u9694, \u6D4B\u91CF\u95F4\u8DDD, "
             "\u91C7\u6837\u95F4\u8DDD, \u91C7\u6837\u95F4\u9694",
             ',')};

/// The keys of Gwyddion in each of its languages, and others.
constexpr LengthNames kExtents{
    WordList("width, breite, largeur, \u0160\u00ED\u0159ka, \u0161\u00ED\u0159ka, larghezza, "
             "anchura, ancho, largura, \u0448\u0438\u0440\u0438\u043D\u0430, "
             "\u0428\u0438\u0440\u0438\u043D\u0430, \u5E45",
             ','),
    WordList("height, h\u00F6he, hauteur, v\u00FD\u0161ka, altezza, altura, "
             "\u0432\u044B\u0441\u043E\u0442\u0430, \u0412\u044B\u0441\u043E\u0442\u0430, "
             "\u9AD8\u3055",
             ','),
    WordList("size, range, length, real, l\u00E4nge, amplitude", ','),
    WordList("scan size, scansize, scan range, scan area, field of view, fov, image size, "
             "measuring area, messfeld, sichtfeld, scanbereich",
             ',')};

/// Returns the axis, x, y or z, where the line names it and says no more: the lines below belong to
/// it. 0: it names none.
char axisAlone(const TextEntry& entry) {
  std::string_view text = entry.key.empty() ? entry.value : entry.key;
  if (!entry.key.empty() && !entry.value.empty()) return 0;
  text = withoutBrackets(text);
  if (text.ends_with(':')) text.remove_suffix(1);
  for (const char axis : {'x', 'y', 'z'})
    for (const std::string_view form : kAxisForms) {
      std::string name(form);
      replaceAll(name, "{}", std::string_view(&axis, 1));
      if (lowerCase(text) == name) return axis;
    }
  return 0;
}

/// The place of a key among the names of a kind: the first one counts.
struct KeyPlace {
  std::size_t place = 0;
  bool hasAxis = false;
};

/// section: the axis to which the line belongs (axisAlone); 0: none.
std::optional<KeyPlace> placeOf(std::string_view key, const LengthNames& names, char axis,
                                char section) {
  key.remove_prefix(std::min(key.find_first_not_of("\\\""), key.size()));  // of NanoScope
  std::string text = lowerCase(key);
  std::ranges::replace_if(
      text, [](char letter) { return letter == '-' || letter == '_'; }, ' ');
  // "Punktabstand dx" has the name and the symbol.
  for (const std::string_view sign : WordList("d \u03B4 \u0394 \u2206"))
    if (const std::string symbol = " " + std::string(sign) + axis; text.ends_with(symbol))
      text.resize(text.size() - symbol.size());
  const std::string_view whole = text;
  const auto behind = whole.starts_with(axis) ? trimmedBlanks(whole.substr(1)) : "";
  const auto before = whole.ends_with(axis) ? trimmedBlanks(whole.substr(0, whole.size() - 1)) : "";
  std::size_t place = 0;
  for (const std::string_view name : axis == 'x' ? names.ofX : names.ofY) {
    if (name == whole) return KeyPlace{place, true};
    ++place;
  }
  for (const bool needsAxis : {true, false})
    for (const std::string_view name : needsAxis ? names.withAxis : names.ofBoth) {
      if (name == behind || name == before) return KeyPlace{place, true};
      if (name == whole && section == axis) return KeyPlace{place, true};
      if (name == whole && section == 0 && !needsAxis) return KeyPlace{place, false};
      ++place;
    }
  return {};
}

/// Returns a length with the unit of its own or, where it has none, that of its key; nothing where
/// the unit is none of length.
std::optional<HeaderLength> lengthFrom(double number, std::string unit,
                                       const std::string& unitOfKey) {
  // "0.0005 mm (2000 pt/mm)"
  if (const std::size_t bracket = unit.find(" ("); bracket != std::string::npos)
    unit.resize(bracket);
  while (unit.starts_with(';') || unit.starts_with(' ')) unit.erase(0, 1);  // "Spacing;0,5;um"
  if (unit == "~m") unit = "\u00B5m";                                       // of NanoScope
  for (const std::string_view each : WordList("/pixel /px /point /pt /sample"))
    if (lowerCase(unit).ends_with(each)) unit.resize(unit.size() - each.size());
  if (unit.empty()) unit = unitOfKey;
  if (!(number > 0)) return {};
  if (unit.empty()) return HeaderLength{number, {}};
  const auto metres = metresPer(unit);
  return metres ? std::optional(HeaderLength{number, StatedUnit{unit, *metres}}) : std::nullopt;
}

/// One length, or two of them: "0.5 um", "10 um x 20 um", "10 x 20 um", "10 20 um".
struct OneOrTwo {
  HeaderLength first;
  std::optional<HeaderLength> second{};
};

std::optional<OneOrTwo> parseLengths(std::string_view text, const std::string& unitOfKey) {
  const auto quantity = parseQuantity(text);
  if (!quantity) return {};
  const std::string_view rest = quantity->unit;
  if (!rest.empty() && rest.front() >= '0' && rest.front() <= '9')
    if (const auto next = parseQuantity(rest)) {
      const auto first = lengthFrom(quantity->number, next->unit, unitOfKey);
      const auto second = lengthFrom(next->number, next->unit, unitOfKey);
      if (first && second) return OneOrTwo{*first, second};
    }
  for (const std::string_view times : {"x", "X", "*", "\u00D7"}) {
    const std::size_t at = rest.find(times);
    if (at == rest.npos) continue;
    const std::string_view behind = trimmedBlanks(rest.substr(at + times.size()));
    const bool isPower = lowerCase(behind).starts_with("1e");  // "0.5 x 1e-6 m"
    const auto next = isPower ? std::nullopt : parseQuantity(behind);
    if (!next) continue;
    const std::string_view own = trimmedBlanks(rest.substr(0, at));
    const auto first =
        lengthFrom(quantity->number, own.empty() ? next->unit : std::string(own), unitOfKey);
    const auto second = lengthFrom(next->number, next->unit, unitOfKey);
    if (first && second) return OneOrTwo{*first, second};
  }
  const auto length = lengthFrom(quantity->number, quantity->unit, unitOfKey);
  return length ? std::optional(OneOrTwo{*length}) : std::nullopt;
}

/// Returns whether two statements of a length differ by their rounding alone.
bool isSame(const HeaderLength& one, const HeaderLength& other) {
  constexpr double kRounding = 0.01;
  if (!one.unit != !other.unit) return true;  // it is not known
  return std::abs(one.metres() - other.metres()) <= kRounding * one.metres();
}

/// Returns whether the name is that of a resolution, which may be a number of points as well.
bool isResolution(std::string_view name) {
  return containsOneOf(lowerCase(name), "resolution aufl\u00F6sung r\u00E9solution");
}

/// Reads an entry without a key: "DeltaX 0.5 um", "10 um x 20 um".
TextEntry keyedEntry(const TextEntry& entry) {
  const std::size_t number = entry.value.find_first_of("0123456789");
  if (!entry.key.empty() || number == std::string::npos) return entry;
  return {std::string(trimmedBlanks(std::string_view(entry.value).substr(0, number))),
          entry.value.substr(number), entry.line};
}

}  // namespace

bool statesLineSpacing(const TextPart& in) {
  return std::ranges::any_of(in.entriesAbove(), [](const TextEntry* entry) {
    const std::string name = lowerCase(parseColumnName(entry->key).name);
    return isOneOf(name, kSteps.ofY) && containsOneOf(name, "line linien profil track trace spur");
  });
}

std::optional<HeaderLength> headerLength(const SurfaceText& in, LengthKind kind, char axis) {
  const LengthNames& names = kind == LengthKind::Step ? kSteps : kExtents;
  constexpr std::size_t kWithoutKey = 1000;  // after all names
  std::size_t first = kWithoutKey;
  std::optional<HeaderLength> found;
  std::size_t lineOfFound = 0;
  bool isContradicted = false;
  for (const TextBlock& one : in.table.blocks) {
    char section = 0;
    lineOfFound = 0;  // what is nearer to the table replaces what is above an earlier one
    for (const TextEntry& line : one.header) {
      if (const char named = axisAlone(line)) {
        section = named;
        continue;
      }
      const TextEntry entry = keyedEntry(line);
      const TextColumn name = parseColumnName(entry.key);
      auto place = placeOf(name.name, names, axis, section);
      if (entry.key.empty() && kind == LengthKind::Extent) place = KeyPlace{kWithoutKey};
      if (!place || place->place > first) continue;
      const auto lengths = parseLengths(entry.value, name.unit);
      if (!lengths || (place->hasAxis && lengths->second)) continue;
      if (place->hasAxis && !lengths->first.unit && isResolution(name.name)) continue;
      const bool isPair = lengths->second.has_value();
      // "50x 10 um" is no pair of lengths.
      const bool isClear =
          isPair && lengths->first.unit && line.value.find(" x ") != line.value.npos;
      if (entry.key.empty() && !isClear) continue;
      const bool isOfBoth = isPair || lowerCase(name.name).starts_with("xy");
      if (!place->hasAxis && axis == 'y' && !isOfBoth) continue;
      // "Size: 60" below the name of an axis counts its points.
      if (section != 0 && kind == LengthKind::Extent && !lengths->first.unit) continue;
      HeaderLength length = axis == 'y' && isPair ? *lengths->second : lengths->first;
      length.hasAxis = place->hasAxis;
      const bool isAgain = found && lineOfFound > 0 && place->place == first;
      if (isAgain && !entry.key.empty() && !isSame(*found, length)) {
        isContradicted = true;
        if (in.source.choices.spacing == 0)
          throw InputError(in.source.name, "surface.point_spacing",
                           message("is needed (in m): lines {} and {} state different lengths of "
                                   "one axis",
                                   lineOfFound, line.line));
      }
      first = place->place;
      found = length;
      lineOfFound = line.line;
    }
    if (&one == &in.block) break;
  }
  return isContradicted ? std::nullopt : found;
}

std::optional<HeaderLength> lengthIn(std::string_view text) {
  const auto lengths = parseLengths(text, {});
  return lengths && !lengths->second ? std::optional(lengths->first) : std::nullopt;
}

std::optional<std::pair<HeaderLength, HeaderLength>> widthAndLength(const TextBlock& block) {
  constexpr WordList kWidths("width, breite, largeur, larghezza, anchura, ancho, largura, \u5E45",
                             ',');
  constexpr WordList kSides(
      "length, l\u00E4nge, longueur, lunghezza, longitud, comprimento, \u9577\u3055", ',');
  std::optional<HeaderLength> width, length;
  bool isWidthFirst = true;
  for (const TextEntry& entry : block.header) {
    const TextColumn name = parseColumnName(entry.key);
    const auto lengths = parseLengths(entry.value, name.unit);
    if (!lengths || lengths->second) continue;
    const std::string key = lowerCase(name.name);
    if (isOneOf(key, kWidths)) {
      width = lengths->first;
      isWidthFirst = !length;
    }
    if (isOneOf(key, kSides)) length = lengths->first;
  }
  if (!width || !length) return {};
  return isWidthFirst ? std::pair{*width, *length} : std::pair{*length, *width};
}

namespace {

/// Returns the text in brackets at the end of a name; empty where there is none.
std::string_view inBrackets(std::string_view name) {
  const std::size_t begin = name.rfind('(');
  if (begin == std::string_view::npos || begin == 0 || !name.ends_with(')')) return {};
  return trimmedBlanks(name.substr(begin + 1, name.size() - begin - 2));
}

/// Returns whether a text may be meant as a unit: it is short and no number.
bool canBeUnit(std::string_view text) {
  constexpr std::size_t kLongest = 20;
  return !text.empty() && text.size() <= kLongest &&
         text.find_first_of("0123456789") == std::string_view::npos;
}

/// Keys, in lower case, of entries that state a unit without saying of what.
constexpr WordList kCommonUnitKeys(
    "unit, units, einheit, length unit, unit\u00E9, unit\u00E0, unidad, \u5358\u4F4D", ',');

/// Returns the keys, in lower case, of entries that state a unit of heights or of positions.
WordList unitKeys(bool ofHeights) {
  constexpr WordList kOfHeights(
      "z, vertical unit, vertical units, value units, value unit, z unit, z units, z-unit, unit z, "
      "units z, height unit, height "
      "units, elevation unit, elevation units, zunit, einheiten, werteinheit, werteinheiten, "
      "z-axis unit, z-axis units, z axis "
      "unit, z axis units, einheit z-achse, einheit z, z-einheit, unit\u00E9s, unit\u00E9s des "
      "valeurs, unit\u00E9 z, unit\u00E9 des hauteurs, \u9AD8\u3055\u5358\u4F4D, jednotky hodnot, "
      "unit\u00E0 valore, h\u00F6heneinheit, \u5024\u306E\u5358\u4F4D, "
      "\u0415\u0434\u0438\u043D\u0438\u0446\u044B "
      "\u0438\u0437\u043C\u0435\u0440\u0435\u043D\u0438\u044F",
      ',');
  constexpr WordList kOfPositions(
      "x unit, x units, x-unit, unit x, units x, xunit, lateral unit, position unit, xy unit, xy "
      "units, x-einheit, einheit x, unit\u00E9 x, x-axis unit, x-axis units, x axis unit, x axis "
      "units, einheit x-achse, x",
      ',');
  return ofHeights ? kOfHeights : kOfPositions;
}

/// Returns the unit that one of the entries with these keys states.
std::optional<StatedUnit> unitOfEntries(const TextPart& in, const WordList& keys) {
  for (const std::string_view key : keys) {
    const std::string text = in.entry(key);
    // "x: mm" states a unit, "x: 5 mm" a length.
    const bool isAlone = text.find_first_of("0123456789") == std::string::npos;
    const auto metres = metresPer(text);
    if (metres && (isAlone || key.size() > 1))
      return StatedUnit{std::string(withoutBrackets(text)), *metres};
  }
  return {};
}

/// Returns the unit in the name of the table: "H\u00F6he in \u00B5m", "Height data [nm]",
/// "Height;um".
std::optional<StatedUnit> unitOfTableName(const TextPart& in) {
  constexpr WordList kBeside("data values value map image channel daten werte");
  std::optional<StatedUnit> found;
  for (const TextEntry* const entry : in.entriesAbove()) {
    const TextColumn column =
        entry->key.empty() ? parseColumnName(entry->value) : TextColumn{entry->key, entry->value};
    const auto metres = metresPer(column.unit);
    const auto words = wordsIn(column.name);
    const bool isName = !words.empty() && isHeightName(words.front()) &&
                        std::all_of(words.begin() + 1, words.end(), [&](const std::string& word) {
                          return isOneOf(word, kBeside);
                        });
    // "Height: 5 um" states a length.
    const bool isAlone = column.unit.find_first_of("0123456789") == std::string::npos;
    if (metres && isName && isAlone) found = StatedUnit{column.unit, *metres};
  }
  return found;
}

}  // namespace

std::optional<StatedUnit> headerUnit(const TextPart& in, bool ofHeights, UnitEntries entries) {
  if (const auto unit = unitOfEntries(in, unitKeys(ofHeights))) return unit;
  if (ofHeights)
    if (const auto unit = unitOfTableName(in)) return unit;
  if (entries == UnitEntries::Own) return {};
  return unitOfEntries(in, kCommonUnitKeys);
}

std::string unknownUnit(const TextPart& in, int column, bool ofHeights) {
  if (column >= 0)
    if (const auto text = inBrackets(columnAt(in.block, column).name);
        canBeUnit(text) && !metresPer(text))
      return std::string(text);
  for (const WordList& keys : {unitKeys(ofHeights), kCommonUnitKeys})
    for (const std::string_view key : keys) {
      const std::string text = in.entry(key);
      const std::string_view unit = withoutBrackets(text);
      if (key.size() > 1 && canBeUnit(unit) && !metresPer(unit)) return std::string(unit);
    }
  return {};
}

CornerUnits cornerUnits(const TextBlock& block) {
  CornerUnits units;
  // The line above the numbers has the whole text of the corner as its key.
  std::string corner = block.header.empty() ? "" : block.header.back().key;
  // Units in the cells: "0 um", "2 um", ... along the first row and the first column.
  double number = 0;
  const TextColumn& next = block.columns[1];
  if (const auto metres = metresPer(next.unit);
      metres && (readTextNumber(next.name, '.', number) || readTextNumber(next.name, ',', number)))
    units.x = {next.unit, *metres};
  if (const auto metres = metresPer(block.columns[0].unit); metres && !block.cells[0].empty())
    units.y = {block.columns[0].unit, *metres};
  if (units.x || units.y) return units;
  if (corner.empty()) corner = block.columns[0].name + " [" + block.columns[0].unit + "]";
  for (const std::string_view mark : {"\\", "|", ";", " / "}) replaceAll(corner, mark, "\n");
  for (const std::string_view text : splitText(corner, "\n")) {
    TextColumn part = parseColumnName(text);
    if (part.unit.empty() && metresPer(part.name)) std::swap(part.name, part.unit);
    if (part.unit.empty() && canBeUnit(inBrackets(part.name))) part.unit = inBrackets(part.name);
    if (part.unit.empty()) continue;
    const std::string name = lowerCase(part.name);
    const bool isHeight = isHeightName(name);
    if (const auto metres = metresPer(part.unit))
      (isHeight ? units.z : isRowName(name) ? units.y : units.x) = {part.unit, *metres};
    else
      (isHeight ? units.unknownHeight : units.unknownPosition) = part.unit;
  }
  return units;
}

std::optional<StatedUnit> columnUnit(const SurfaceText& in, int column, bool ofHeights) {
  const std::string& unit = columnAt(in.block, column).unit;
  const bool isChosen =
      (ofHeights ? in.source.choices.heightUnit : in.source.choices.positionUnit) != "auto";
  if (unit.empty()) {
    const std::string_view text = inBrackets(columnAt(in.block, column).name);
    if (const auto metres = metresPer(text)) return StatedUnit{std::string(text), *metres};
    return headerUnit(in, ofHeights);
  }
  if (const auto metres = metresPer(unit)) return StatedUnit{unit, *metres};
  if (isChosen) return {};
  const char* key = ofHeights ? "surface.height_unit" : "surface.position_unit";
  throw InputError(in.source.name, key,
                   message("{} is in '{}', which is not a unit of length; {} can name another one",
                           columnText(in.block, column), shortened(unit), key));
}

}  // namespace asperity
