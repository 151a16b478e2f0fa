#include "core/measured/text_columns.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "core/base/statistics.h"
#include "core/base/text.h"
#include "core/base/text_number.h"
#include "core/base/text_units.h"
#include "core/base/units.h"
#include "core/measured/uniform_positions.h"

namespace asperity {
namespace {

/// Names of columns of positions, heights, ... in lower case; a name of one letter must be the
/// whole name.
constexpr WordList kPositions(
    "\u0440\u0430\u0441\u0441\u0442\u043E\u044F\u043D\u0438\u0435 "
    "\u0434\u043B\u0438\u043D\u0430 mesafe uzunluk konum vzd\u00E1lenost d\u00E9lka "
    "poloha "
    "x position pos distance dist lateral abscissa abszisse weg strecke travel length l\u00E4nge "
    "laenge s d l abstand messweg scan displacement xposition xpos xcoordinate encoder encoder1 "
    "easting rechtswert");
constexpr WordList kRows("y yposition ypos ycoordinate northing hochwert");
constexpr WordList kHeights(
    "\u0432\u044B\u0441\u043E\u0442\u0430 y\u00FCkseklik v\u00FD\u0161ka "
    "z height heights h h\u00F6he hoehe h\u00F6hen hauteurs alturas altezze hoogte profile profil "
    "elevation altitude topography topo depth "
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

/// Names of the primary profile (ISO 21920-2), and of those that a filter made of it, without
/// blanks and dashes.
constexpr WordList kPrimary(
    "p pprofile pprofil profilep profilp primary primaryprofile prim\u00E4r prim\u00E4rprofil "
    "primaerprofil profilprimaire profiloprimario perfilprimario unfiltered unfilteredprofile "
    "ungefiltert raw rawprofile rawdata rohprofil");
constexpr WordList kFiltered(
    "r rprofile rprofil profiler profilr roughness roughnessprofile rauheit rauheitsprofil "
    "rugosit\u00E9 "
    "profilderugosit\u00E9 rugosit\u00E0 rugosidad w wprofile wprofil profilew profilw waviness "
    "wavinessprofile welligkeit welligkeitsprofil ondulation filtered filteredprofile gefiltert");

/// Returns whether one of the words is the first word of the name, or the whole name: "x position",
/// "x_axis", "height data".
bool begins(const WordList& words, std::string_view name) {
  if (isOneOf(name, words)) return true;
  return isOneOf(name.substr(0, std::min(name.find_first_of(" _-.("), name.size())), words);
}

/// Returns whether a column holds the times of the points, by its unit or its name.
bool isTime(const TextColumn& column) {
  constexpr WordList kTimes(
      "time, t, date, datetime, date time, timestamp, time stamp, datum, zeit, uhrzeit, "
      "zeitstempel, temps, heure, tiempo, hora, fecha, tempo, ora",
      ',');
  if (isOneOf(lowerCase(column.name), kTimes)) return true;
  return column.unit != "m" && findUnit(column.unit, "s");
}

/// Returns whether the column only rises or only falls.
bool isMonotone(const TextBlock& block, int column) {
  bool rises = true, falls = true, changes = false;
  double last = 0;
  bool any = false;
  for (std::size_t i = 0; i < block.rows; ++i) {
    const double value = block.at(i, static_cast<std::size_t>(column));
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
    const TextColumn& one = columnAt(block, column);
    if (one.isText || (one.name.empty() && block.columns.size() > 3)) continue;
    const auto number = static_cast<std::size_t>(column);
    const bool isUniform = uniformSpacing(block.column(number)).has_value();
    if (course == Course::Uniform ? !isUniform : !isMonotone(block, column)) continue;
    if (found >= 0) return -1;
    found = column;
  }
  return found;
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

bool isHeightName(std::string_view name) {
  return begins(kHeights, name);
}

bool isPositionName(std::string_view name) {
  return begins(kPositions, name) || isProfilePosition(name);
}

bool isRowName(std::string_view name) {
  return begins(kRows, name);
}

Message columnText(const TextBlock& block, int column) {
  const std::string& name = columnAt(block, column).name;
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

  /// A depth, or a distance from a sensor, counts into the material, but instruments that write a
  /// path call a height so, too.
  void refuseDepth() const {
    constexpr WordList kDepths(
        "depth tiefe profiltiefe distance abstand standoff profondeur profundidad profondit\u00E0 "
        "profondita g\u0142\u0119boko\u015B\u0107 \u0433\u043B\u0443\u0431\u0438\u043D\u0430 "
        "derinlik hloubka \u6DF1\u5EA6 \u6DF1\u3055 \uAE4A\uC774");
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
      if (isRowName(name) && !name.starts_with("y.") && !name.starts_with("y("))
        lateral.push_back(roles_.y = i);
      else if (isPositionName(name) &&
               (roles_.x < 0 || i < heightChoice_ || (mayBeOther(roles_.x) && !mayBeOther(i))))
        roles_.x = i;  // of several profiles, each with its positions, those of the chosen one
      else if (isHeightName(name))
        roles_.heights.push_back(i);
      else if (!isOneOf(name, kCounts))
        findValidity(block_, i, name, roles_);
      if (roles_.x != i && roles_.y != i && roles_.validity != i && !isOneOf(name, kCounts) &&
          !isTime(columnAt(block_, i)) && block_.hasNumber(static_cast<std::size_t>(i)) &&
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
        isMonotone(block_, open_[1]))
      open_.erase(open_.begin());
    const bool hasHeights = open_.size() > 1 || !roles_.heights.empty() || heightChoice_ >= 0;
    if (roles_.x >= 0 || open_.empty() || !hasHeights) return;
    // The positions of chosen heights stand nearest in front of them.
    auto candidate = open_.begin();
    for (auto column = candidate; column != open_.end() && *column < heightChoice_; ++column)
      if (isMonotone(block_, *column)) candidate = column;
    if (!isMonotone(block_, *candidate)) return;
    roles_.x = *candidate;
    open_.erase(candidate);
  }

  void findHeights() {
    roles_.heights.insert(roles_.heights.end(), open_.begin(), open_.end());
    if (roles_.x < 0 && heightChoice_ < 0 && roles_.heights.size() > 1) {
      roles_.x = onlyOne(block_, roles_.heights, Course::Uniform);
      if (roles_.x < 0) roles_.x = onlyOne(block_, roles_.heights, Course::Monotone);
    }
    std::erase(roles_.heights, roles_.x);
    dropNumbers();
    preferPrimary();
    if (heightChoice_ >= 0)
      roles_.z = heightChoice_;
    else if (!roles_.heights.empty())
      roles_.z = firstHeights();
    else if (roles_.x >= 0 && positionChoice_ < 0)
      std::swap(roles_.x, roles_.z);  // a single column holds heights, whatever its name
  }

  /// Removes columns that number the profiles from the heights where others remain.
  void dropNumbers() {
    const auto isNumber = [this](int column) {
      return numbersProfiles(block_, static_cast<std::size_t>(column));
    };
    if (!std::ranges::all_of(roles_.heights, isNumber)) std::erase_if(roles_.heights, isNumber);
  }

  /// Returns the first column of heights that has different ones, such as "Z" behind "Z-Pos" of the
  /// stage; the first column where there is none.
  int firstHeights() const {
    const auto varies = [this](int column) {
      const auto number = static_cast<std::size_t>(column);
      double first = kNaN;
      for (std::size_t row = 0; row < block_.rows; ++row) {
        const double value = block_.at(row, number);
        if (std::isnan(first)) first = value;
        if (!std::isnan(value) && value != first) return true;
      }
      return false;
    };
    const auto found = std::ranges::find_if(roles_.heights, varies);
    return found != roles_.heights.end() ? *found : roles_.heights.front();
  }

  /// Puts the primary profile in front of what a filter made of it: the long waves decide where the
  /// load is carried.
  void preferPrimary() {
    const auto isNamed = [this](int column, const WordList& words) {
      std::string name = lowerCase(nameOf(column));
      std::erase_if(name,
                    [](char letter) { return letter == ' ' || letter == '-' || letter == '_'; });
      return isOneOf(name, words);
    };
    const auto primary =
        std::ranges::find_if(roles_.heights, [&](int column) { return isNamed(column, kPrimary); });
    if (primary != roles_.heights.end() &&
        std::ranges::any_of(roles_.heights, [&](int column) { return isNamed(column, kFiltered); }))
      std::rotate(roles_.heights.begin(), primary, primary + 1);
  }

  /// Counts the columns that could be the heights as well: those in the same unit or, without
  /// units, those with a similar name.
  void countCandidates(std::size_t namedHeights) {
    const std::string& unit = unitOf(roles_.z);
    const auto isAlike = [&](int column) { return unitOf(column) == unit; };
    roles_.candidates = static_cast<std::size_t>(std::ranges::count_if(roles_.heights, isAlike));
    if (namedHeights > 0 && unit.empty()) roles_.candidates = namedHeights;
  }

  const std::string& nameOf(int column) const { return columnAt(block_, column).name; }
  const std::string& unitOf(int column) const { return columnAt(block_, column).unit; }
  /// Returns whether a column named as positions may hold something else: its unit is none of
  /// length, as counts of an encoder, or it numbers the profiles.
  bool mayBeOther(int column) const {
    return (!unitOf(column).empty() && !metresPer(unitOf(column))) ||
           numbersProfiles(block_, static_cast<std::size_t>(column));
  }
  bool isCount(int column) const { return countsRows(block_, static_cast<std::size_t>(column)); }

  const TextBlock& block_;
  const std::string& name_;
  int positionChoice_, heightChoice_;
  std::vector<int> open_;  // columns whose meaning is not known by name
  ColumnRoles roles_;
};

/// A name with one number in it: "Profile 2 (left)".
struct NumberedName {
  std::string before{}, number{}, after{};
};

/// Returns the parts of a name; without a number in it, or with several, the number is empty.
NumberedName numberedName(const std::string& name) {
  constexpr std::string_view kDigits = "0123456789";
  const std::size_t begin = name.find_first_of(kDigits);
  if (begin == std::string::npos) return {};
  const std::size_t end = std::min(name.find_first_not_of(kDigits, begin), name.size());
  if (name.find_first_of(kDigits, end) != std::string::npos) return {};
  return {name.substr(0, begin), name.substr(begin, end - begin), name.substr(end)};
}

}  // namespace

ColumnRoles columnRoles(const TextBlock& block, const SurfaceSource& source) {
  return RoleFinder(block, source).find();
}

bool numbersProfiles(const TextBlock& block, std::size_t column) {
  constexpr WordList kProfiles(
      "profile profil perfil profilo scan track trace line linie spur section measurement messung "
      "run");
  const TextColumn& one = block.columns[column];
  if (one.isText || !one.unit.empty() || !begins(kProfiles, lowerCase(one.name))) return false;
  double last = 0;
  for (std::size_t row = 0; row < block.rows; ++row) {
    const double number = block.at(row, column);
    if (number != std::floor(number) || (row > 0 && number < last)) return false;
    last = number;
  }
  return true;
}

ProfileColumns profilesSideBySide(const TextBlock& block, const ColumnRoles& roles,
                                  const SurfaceSource& source) {
  if (roles.z < 0 || source.choices.heightColumn > 0) return {};
  const NumberedName first = numberedName(columnAt(block, roles.z).name);
  const bool areLengths = metresPer(columnAt(block, roles.z).unit).has_value();
  if (first.number.empty() || !(areLengths || isHeightName(lowerCase(first.before)))) return {};
  ProfileColumns found;
  std::set<std::string> numbers;
  for (const int column : roles.heights) {
    const NumberedName name = numberedName(columnAt(block, column).name);
    const auto number = static_cast<std::size_t>(column);
    if (name.before != first.before || name.after != first.after || name.number.empty() ||
        columnAt(block, column).unit != columnAt(block, roles.z).unit ||
        !numbers.insert(name.number).second)
      continue;
    const bool isWhole =
        !std::isnan(block.at(0, number)) && !std::isnan(block.at(block.rows - 1, number));
    (isWhole ? found.whole : found.leftOut).push_back(column);
  }
  return found.whole.size() > 1 && found.whole.front() == roles.z ? found : ProfileColumns{};
}

bool isInPixels(const TextColumn& column) {
  constexpr WordList kPixels("px pix pixel pixels");
  return isOneOf(lowerCase(column.unit), kPixels);
}

bool mayNumberPoints(const TextBlock& block, const ColumnRoles& roles,
                     const SurfaceSource& source) {
  if (roles.x < 0 || source.choices.positionColumn > 0) return false;
  const TextColumn& column = columnAt(block, roles.x);
  const std::string name = lowerCase(column.name);
  return (isInPixels(column) || (column.unit.empty() && !isPositionName(name))) &&
         countsRows(block, static_cast<std::size_t>(roles.x));
}

}  // namespace asperity
