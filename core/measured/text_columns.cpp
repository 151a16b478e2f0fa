// Finds what the columns of a text table and the lines above it state about a surface.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/text.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/base/units.h"
#include "core/measured/text_surface.h"
#include "core/measured/uniform_positions.h"

namespace asperity {
namespace {

/// Names of columns of positions, heights, ... in lower case; a name of one letter must be the
/// whole name.
constexpr WordList kPositions(
    "x position pos distance dist lateral abscissa abszisse weg strecke travel length l\u00E4nge "
    "laenge s d l abstand messweg scan displacement xposition xpos xcoordinate encoder encoder1 "
    "easting rechtswert");
constexpr WordList kRows("y yposition ypos ycoordinate northing hochwert");
constexpr WordList kHeights(
    "z height heights h h\u00F6he hoehe profile profil elevation altitude topography topo depth "
    "tiefe amplitude ordinate hauteur altezza altura primary zdata deviation raw value signal");
constexpr WordList kCounts(
    "index, #, i, n, no, no., nr, nr., idx, point, pt, punkt, row, id, sample, zeile, messpunkt, "
    "number, nummer, count, counter, row number, zeilennummer",
    ',');
constexpr WordList kGood("valid validity ok good g\u00FCltig gueltig isvalid is_valid");
constexpr WordList kBad("invalid bad error ung\u00FCltig missing outlier");
constexpr WordList kLongitudes("longitude lon lng l\u00E4ngengrad");
constexpr WordList kLatitudes("latitude lat breitengrad");
constexpr WordList kEither("flag flags status mask quality qual");

/// Returns whether one of the words is the first word of the name, or the whole name: "x position",
/// "x_axis", "height data".
bool begins(const WordList& words, std::string_view name) {
  if (isOneOf(name, words)) return true;
  return isOneOf(name.substr(0, std::min(name.find_first_of(" _-.("), name.size())), words);
}

/// Returns whether the column only rises or only falls.
bool isMonotone(const TextBlock& block, std::size_t column) {
  bool rises = true, falls = true, changes = false;
  double last = 0;
  bool any = false;
  for (std::size_t i = 0; i < block.rows; ++i) {
    const double value = block.at(i, column);
    if (std::isnan(value)) continue;
    if (any) {
      rises = rises && value >= last;
      falls = falls && value <= last;
      changes = changes || value != last;
    }
    last = value;
    any = true;
  }
  return changes && (rises || falls);
}

/// Returns whether the name is that of a position along the profile and not of a height: "Profile
/// Position", "P-Profile length".
bool isProfilePosition(std::string_view name) {
  const std::size_t at = name.find("profil");
  if (at == std::string_view::npos) return false;
  for (std::size_t i = name.find_first_of(" _-", at); i < name.size();
       i = name.find_first_of(" _-", i + 1)) {
    const std::string_view rest = name.substr(i + 1);
    const std::string_view word = rest.substr(0, rest.find_first_of(" _-.(/"));
    if (word.size() > 1 && isOneOf(word, kPositions)) return true;
  }
  return false;
}

enum class Course { Uniform, Monotone };

/// Returns the only column among those named like heights whose numbers run like positions, such as
/// "Profile Path Length" beside "Depth". -1: there is none.
int onlyOne(const TextBlock& block, const std::vector<int>& columns, Course course) {
  int found = -1;
  for (const int column : columns) {
    const TextColumn& one = block.columns[static_cast<std::size_t>(column)];
    if (one.isText || (one.name.empty() && block.columns.size() > 3)) continue;
    const auto number = static_cast<std::size_t>(column);
    const bool isUniform = uniformSpacing(block.column(number)).has_value();
    if (course == Course::Uniform ? !isUniform : !isMonotone(block, number)) continue;
    if (found >= 0) return -1;
    found = column;
  }
  return found;
}

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

/// Returns the share of ones where all numbers are 0 or 1; else -1.
double shareOfOnes(const TextBlock& block, std::size_t column) {
  double ones = 0, all = 0;
  for (std::size_t i = 0; i < block.rows; ++i) {
    const double value = block.at(i, column);
    if (std::isnan(value)) continue;
    if (value != 0 && value != 1) return -1;
    ones += value;
    all += 1;
  }
  return all > 0 ? ones / all : -1;
}

void findValidity(const TextBlock& block, int column, std::string_view name, ColumnRoles& roles) {
  const double ones = shareOfOnes(block, static_cast<std::size_t>(column));
  if (ones < 0) return;
  const bool named = isOneOf(name, kGood) || isOneOf(name, kBad) || isOneOf(name, kEither);
  // A column without a name is one of validity only where it is the last one and has both numbers.
  const bool isLast = column + 1 == static_cast<int>(block.columns.size());
  if (!named && !(name.empty() && isLast && column > 1 && ones > 0 && ones < 1)) return;
  roles.validity = column;
  roles.validIsOne = isOneOf(name, kGood) || (!isOneOf(name, kBad) && ones >= 0.5);
}

}  // namespace

Message columnText(const TextBlock& block, int column) {
  const std::string& name = block.columns[static_cast<std::size_t>(column)].name;
  if (name.empty()) return message("column {}", column + 1);
  return message("column {} '{}'", column + 1, shortened(name));
}

namespace {

/// Finds the roles of the columns: first by name, then by their numbers.
class RoleFinder {
 public:
  RoleFinder(const TextBlock& block, const SurfaceSource& source)
      : block_(block),
        name_(source.name),
        positionChoice_(chosen(source, source.choices.positionColumn, "surface.position_column")),
        heightChoice_(chosen(source, source.choices.heightColumn, "surface.height_column")) {
    if (positionChoice_ >= 0 && positionChoice_ == heightChoice_)
      throw InputError(source.name, "surface.height_column",
                       "is the column of the positions, too; they need one each");
  }

  ColumnRoles find() {
    refuseDegrees();
    findByName();
    const std::size_t namedHeights = roles_.heights.size();
    takeRowsAsHeights();
    findPositions();
    findHeights();
    refuseDepth();
    if (roles_.z >= 0) countCandidates(namedHeights);
    return std::move(roles_);
  }

 private:
  /// A longitude and a latitude are angles; as positions they would be lengths.
  void refuseDegrees() const {
    const int columns = static_cast<int>(block_.columns.size());
    int longitude = -1, latitude = -1;
    for (int i = 0; i < columns; ++i) {
      const std::string name = lowerCase(nameOf(i));
      if (begins(kPositions, name)) return;
      if (begins(kLongitudes, name)) longitude = i;
      if (begins(kLatitudes, name)) latitude = i;
    }
    if (positionChoice_ < 0 && longitude >= 0 && latitude >= 0)
      throw InputError(name_, "surface.position_column",
                       message("{} and {} are angles; positions are needed in a unit of length",
                               columnText(block_, longitude), columnText(block_, latitude)));
  }

  /// A depth counts into the material, but instruments that write a path call a height so, too.
  void refuseDepth() const {
    constexpr WordList kDepths("depth tiefe");
    if (heightChoice_ >= 0 || roles_.z < 0 || !begins(kDepths, lowerCase(nameOf(roles_.z)))) return;
    if (roles_.x >= 0 && isProfilePosition(lowerCase(nameOf(roles_.x)))) return;
    throw InputError(name_, "surface.height_column",
                     message("{} may count into the material; say {} where it does not, and set "
                             "surface.contact_side to valleys as well where it does",
                             columnText(block_, roles_.z), roles_.z + 1));
  }

  /// Returns the column that the user chose, counted from 0; -1: none.
  int chosen(const SurfaceSource& source, int choice, const char* key) const {
    const int columns = static_cast<int>(block_.columns.size());
    if (choice > columns)
      throw InputError(source.name, key, message("the file has {} columns", columns));
    return choice - 1;
  }

  void findByName() {
    std::vector<int> lateral;  // columns named y
    for (int i = 0; i < static_cast<int>(block_.columns.size()); ++i) {
      const std::string name = lowerCase(nameOf(i));
      if (i == positionChoice_ || i == heightChoice_) continue;
      if (begins(kRows, name) && !name.starts_with("y.") && !name.starts_with("y("))
        lateral.push_back(roles_.y = i);
      else if (roles_.x < 0 && (begins(kPositions, name) || isProfilePosition(name)))
        roles_.x = i;
      else if (begins(kHeights, name))
        roles_.heights.push_back(i);
      else if (!isOneOf(name, kCounts))
        findValidity(block_, i, name, roles_);
      if (roles_.x != i && roles_.y != i && roles_.validity != i && !isOneOf(name, kCounts) &&
          std::ranges::find(roles_.heights, i) == roles_.heights.end())
        open_.push_back(i);
    }
    // "y" and "y 2" are two curves over x.
    if (lateral.size() > 1) {
      roles_.heights.insert(roles_.heights.begin(), lateral.begin(), lateral.end());
      roles_.y = -1;
    }
    roles_.named = roles_.x >= 0 || !roles_.heights.empty();
  }

  /// Takes "y" for the height where there are "x" and "y" without "z", as in a plot.
  void takeRowsAsHeights() {
    const bool isHeight =
        roles_.y >= 0 && roles_.heights.empty() && heightChoice_ < 0 && open_.empty();
    if (!isHeight && (roles_.y < 0 || roles_.x >= 0 || positionChoice_ >= 0)) return;
    roles_.heights.insert(roles_.heights.begin(), roles_.y);
    roles_.y = -1;
  }

  void findPositions() {
    if (positionChoice_ >= 0) {
      roles_.x = positionChoice_;
      return;
    }
    // A column without a name that counts the rows, in front of at least two others, numbers the
    // points.
    if (open_.size() > 2 && nameOf(open_.front()).empty() && isCount(open_.front()) &&
        isMonotone(block_, static_cast<std::size_t>(open_[1])))
      open_.erase(open_.begin());
    const bool hasHeights = open_.size() > 1 || !roles_.heights.empty() || heightChoice_ >= 0;
    if (roles_.x < 0 && !open_.empty() && hasHeights &&
        isMonotone(block_, static_cast<std::size_t>(open_.front()))) {
      roles_.x = open_.front();
      open_.erase(open_.begin());
    }
  }

  void findHeights() {
    roles_.heights.insert(roles_.heights.end(), open_.begin(), open_.end());
    if (roles_.x < 0 && heightChoice_ < 0 && roles_.heights.size() > 1) {
      roles_.x = onlyOne(block_, roles_.heights, Course::Uniform);
      if (roles_.x < 0) roles_.x = onlyOne(block_, roles_.heights, Course::Monotone);
    }
    std::erase(roles_.heights, roles_.x);
    if (heightChoice_ >= 0)
      roles_.z = heightChoice_;
    else if (!roles_.heights.empty())
      roles_.z = roles_.heights.front();
    else if (roles_.x >= 0 && positionChoice_ < 0)
      std::swap(roles_.x, roles_.z);  // a single column holds heights, whatever its name
  }

  /// Counts the columns that could be the heights as well: those in the same unit or, without
  /// units, those with a similar name.
  void countCandidates(std::size_t namedHeights) {
    const std::string& unit = unitOf(roles_.z);
    const auto isAlike = [&](int column) { return unitOf(column) == unit; };
    roles_.candidates = static_cast<std::size_t>(std::ranges::count_if(roles_.heights, isAlike));
    if (namedHeights > 0 && unit.empty()) roles_.candidates = namedHeights;
  }

  const TextColumn& columnAt(int column) const {
    return block_.columns[static_cast<std::size_t>(column)];
  }
  const std::string& nameOf(int column) const { return columnAt(column).name; }
  const std::string& unitOf(int column) const { return columnAt(column).unit; }
  bool isCount(int column) const { return countsRows(block_, static_cast<std::size_t>(column)); }

  const TextBlock& block_;
  const std::string& name_;
  int positionChoice_, heightChoice_;
  std::vector<int> open_;  // columns whose meaning is not known by name
  ColumnRoles roles_;
};

}  // namespace

ColumnRoles columnRoles(const TextBlock& block, const SurfaceSource& source) {
  return RoleFinder(block, source).find();
}

bool mayNumberPoints(const TextBlock& block, const ColumnRoles& roles,
                     const SurfaceSource& source) {
  if (roles.x < 0 || source.choices.positionColumn > 0) return false;
  const TextColumn& column = block.columns[static_cast<std::size_t>(roles.x)];
  const std::string name = lowerCase(column.name);
  return column.unit.empty() && !begins(kPositions, name) && !isProfilePosition(name) &&
         countsRows(block, static_cast<std::size_t>(roles.x));
}

namespace {

/// The names of a kind of lengths, in lower case and with blanks in place of "-" and "_".
struct LengthNames {
  WordList ofX, ofY;  // name the axis
  WordList withAxis;  // need the letter of the axis: "x range", "size x", "deltax"
  WordList ofBoth;    // may have it
};

constexpr LengthNames kSteps{
    WordList("dx, pixelbreite, pixel width, pixelwidth", ','),
    WordList("dy, pixelh\u00F6he, pixel height, pixelheight", ','), WordList("delta", ','),
    WordList("cellsize, cell size, spacing, increment, step, step size, stepsize, sampling "
             "interval, sampling step, sample interval, point spacing, pixel size, pixelsize, "
             "punktabstand, messpunktabstand, schrittweite, abtastweite, abtastabstand, data "
             "spacing, pitch, data pitch, point pitch, sampling pitch, measuring pitch, pas, "
             "\u6E2C\u5B9A\u30D4\u30C3\u30C1, lateral resolution, xy calibration, xy justierung, "
             "xy kalibrierung, xy\uCE98\uB9AC\uBE0C\uB808\uC774\uC158",
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
    WordList("size, range, length, real, l\u00E4nge", ','),
    WordList("scan size, scansize, scan range, scan area, field of view, fov, image size, "
             "measuring area, messfeld, sichtfeld, scanbereich",
             ',')};

/// The place of a key among the names of a kind: the first one counts.
struct KeyPlace {
  std::size_t place = 0;
  bool hasAxis = false;
};

std::optional<KeyPlace> placeOf(std::string_view key, const LengthNames& names, char axis) {
  std::string text = lowerCase(key);
  std::ranges::replace_if(
      text, [](char letter) { return letter == '-' || letter == '_'; }, ' ');
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
      if (!needsAxis && name == whole) return KeyPlace{place, false};
      ++place;
    }
  return {};
}

/// Returns a length with the unit of its own or, where it has none, that of its key; nothing where
/// the unit is none of length.
std::optional<HeaderLength> lengthFrom(double number, std::string unit,
                                       const std::string& unitOfKey) {
  for (const std::string_view each : WordList("/pixel /px /point"))
    if (lowerCase(unit).ends_with(each)) unit.resize(unit.size() - each.size());
  if (unit.empty()) unit = unitOfKey;
  if (!(number > 0)) return {};
  if (unit.empty()) return HeaderLength{number, {}};
  const auto metres = metresPer(unit);
  return metres ? std::optional(HeaderLength{number, StatedUnit{unit, *metres}}) : std::nullopt;
}

/// One length, or two of them: "0.5 um", "10 um x 20 um", "10 x 20 um".
struct OneOrTwo {
  HeaderLength first;
  std::optional<HeaderLength> second{};
};

std::optional<OneOrTwo> parseLengths(std::string_view text, const std::string& unitOfKey) {
  const auto quantity = parseQuantity(text);
  if (!quantity) return {};
  const std::string_view rest = quantity->unit;
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

/// Reads an entry without a key: "DeltaX 0.5 um", "10 um x 20 um".
TextEntry keyedEntry(const TextEntry& entry) {
  const std::size_t number = entry.value.find_first_of("0123456789");
  if (!entry.key.empty() || number == std::string::npos) return entry;
  return {std::string(trimmedBlanks(std::string_view(entry.value).substr(0, number))),
          entry.value.substr(number), entry.line};
}

}  // namespace

std::optional<HeaderLength> headerLength(const TextTable& table, const TextBlock& block,
                                         LengthKind kind, char axis) {
  const LengthNames& names = kind == LengthKind::Step ? kSteps : kExtents;
  constexpr std::size_t kWithoutKey = 1000;  // behind all names
  std::size_t first = kWithoutKey;
  std::optional<HeaderLength> found;
  for (const TextBlock& one : table.blocks) {
    for (const TextEntry& line : one.header) {
      const TextEntry entry = keyedEntry(line);
      const TextColumn name = parseColumnName(entry.key);
      auto place = placeOf(name.name, names, axis);
      if (entry.key.empty() && kind == LengthKind::Extent) place = KeyPlace{kWithoutKey};
      if (!place || place->place > first) continue;
      const auto lengths = parseLengths(entry.value, name.unit);
      if (!lengths || (place->hasAxis && lengths->second)) continue;
      const bool isPair = lengths->second.has_value();
      // "50x 10 um" is no pair of lengths.
      const bool isClear =
          isPair && lengths->first.unit && line.value.find(" x ") != line.value.npos;
      if (entry.key.empty() && !isClear) continue;
      if (!place->hasAxis && axis == 'y' && !isPair) continue;
      first = place->place;
      found = axis == 'y' && isPair ? lengths->second : lengths->first;
    }
    if (&one == &block) break;
  }
  return found;
}

std::optional<HeaderLength> countedStep(const TextTable& table, const TextBlock& block,
                                        std::int64_t count, char axis) {
  constexpr WordList kForms(
      "axis {}, {} axis, {}-axis, achse {}, {}-achse, axe {}, axe des {}, eje {}, asse {}", ',');
  for (const std::string_view form : kForms) {
    std::string key(form);
    replaceAll(key, "{}", std::string_view(&axis, 1));
    const std::string text = table.entry(key, block);
    const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
    const auto length = parseQuantity(std::string_view(text).substr(end));
    double points = 0;
    if (!length || !readTextNumber(std::string_view(text).substr(0, end), '.', points)) continue;
    const auto metres = metresPer(length->unit);
    if (!metres || points != static_cast<double>(count) || count < 2 || !(length->number > 0))
      continue;
    return HeaderLength{length->number / (points - 1), StatedUnit{length->unit, *metres}};
  }
  constexpr WordList kNumbers(
      "points, number of points, data points, data number, punkte, anzahl punkte, messpunkte, "
      "nombre de points, \u30C7\u30FC\u30BF\u6570",
      ',');
  constexpr WordList kTraverses(
      "traverse length, measuring length, measurement length, tracing length, messl\u00E4nge, "
      "messstrecke, taststrecke, longueur de mesure, \u6E2C\u5B9A\u9577\u3055",
      ',');
  if (axis != 'x' || count < 2) return {};
  for (const std::string_view number : kNumbers) {
    const auto points = parseQuantity(table.entry(number, block));
    if (!points || points->number != static_cast<double>(count)) continue;
    for (const std::string_view traverse : kTraverses)
      if (auto lengths = parseLengths(table.entry(traverse, block), {});
          lengths && !lengths->second) {
        lengths->first.value /= static_cast<double>(count - 1);
        return lengths->first;
      }
  }
  return {};
}

namespace {

/// The keys, in lower case, of entries that state a unit.
std::vector<std::string_view> unitKeys(bool ofHeights, UnitEntries entries) {
  constexpr WordList kOfHeights(
      "z, value units, value unit, z unit, z units, z-unit, unit z, units z, height unit, height "
      "units, zunit, einheiten, werteinheit, werteinheiten, z-axis unit, z-axis units, z axis "
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
  std::vector<std::string_view> keys;
  std::ranges::copy(ofHeights ? kOfHeights : kOfPositions, std::back_inserter(keys));
  if (entries == UnitEntries::AndCommon)
    std::ranges::copy(WordList("unit, units, einheit, length unit", ','), std::back_inserter(keys));
  return keys;
}

}  // namespace

std::optional<StatedUnit> headerUnit(const TextTable& table, const TextBlock& block, bool ofHeights,
                                     UnitEntries entries) {
  for (const std::string_view key : unitKeys(ofHeights, entries)) {
    const std::string text = table.entry(key, block);
    // "x: mm" states a unit, "x: 5 mm" a length.
    const bool isAlone = text.find_first_of("0123456789") == std::string::npos;
    const auto metres = metresPer(text);
    if (metres && (isAlone || key.size() > 1))
      return StatedUnit{std::string(withoutBrackets(text)), *metres};
  }
  return {};
}

std::string unknownUnit(const TextTable& table, const TextBlock& block, int column,
                        bool ofHeights) {
  if (column >= 0)
    if (const auto text = inBrackets(block.columns[static_cast<std::size_t>(column)].name);
        canBeUnit(text) && !metresPer(text))
      return std::string(text);
  for (const std::string_view key : unitKeys(ofHeights, UnitEntries::AndCommon)) {
    const std::string text = table.entry(key, block);
    const std::string_view unit = withoutBrackets(text);
    if (key.size() > 1 && canBeUnit(unit) && !metresPer(unit)) return std::string(unit);
  }
  return {};
}

CornerUnits cornerUnits(const TextBlock& block) {
  CornerUnits units;
  // The line above the numbers has the whole text of the corner as its key.
  std::string corner = block.header.empty() ? "" : block.header.back().key;
  if (corner.empty()) corner = block.columns[0].name + " [" + block.columns[0].unit + "]";
  for (const std::string_view mark : {"\\", "|", ";", " / "}) replaceAll(corner, mark, "\n");
  for (const std::string_view text : splitText(corner, "\n")) {
    TextColumn part = parseColumnName(text);
    if (part.unit.empty() && metresPer(part.name)) std::swap(part.name, part.unit);
    if (part.unit.empty() && canBeUnit(inBrackets(part.name))) part.unit = inBrackets(part.name);
    if (part.unit.empty()) continue;
    const std::string name = lowerCase(part.name);
    const bool isHeight = begins(kHeights, name);
    if (const auto metres = metresPer(part.unit))
      (isHeight ? units.z : begins(kRows, name) ? units.y : units.x) = {part.unit, *metres};
    else
      (isHeight ? units.unknownHeight : units.unknownPosition) = part.unit;
  }
  return units;
}

std::optional<StatedUnit> columnUnit(const SurfaceSource& source, const TextTable& table,
                                     const TextBlock& block, int column, bool ofHeights) {
  const std::string& unit = block.columns[static_cast<std::size_t>(column)].unit;
  const bool isChosen =
      (ofHeights ? source.choices.heightUnit : source.choices.positionUnit) != "auto";
  if (unit.empty()) {
    const std::string_view text = inBrackets(block.columns[static_cast<std::size_t>(column)].name);
    if (const auto metres = metresPer(text)) return StatedUnit{std::string(text), *metres};
    return headerUnit(table, block, ofHeights);
  }
  if (const auto metres = metresPer(unit)) return StatedUnit{unit, *metres};
  if (isChosen) return {};
  const char* key = ofHeights ? "surface.height_unit" : "surface.position_unit";
  throw InputError(source.name, key,
                   message("{} is in '{}', which is no unit of length; {} can name another one",
                           columnText(block, column), shortened(unit), key));
}

}  // namespace asperity
