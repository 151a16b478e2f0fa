#include "core/fit/friction_data.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <optional>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/regular_file.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/base/text_table.h"
#include "core/material/dma_columns.h"

namespace asperity {
namespace {

enum class Quantity { Velocity, Mu, MuError, VelocityError, Force, Pressure, Temperature, Label };

struct QuantityNames {
  Quantity quantity;
  const char* meaning;
  std::initializer_list<std::string_view> names;  // letters and digits alone, in lower case
};

const std::array<QuantityNames, 8>& knownNames() {
  static const std::array<QuantityNames, 8> known{{
      {Quantity::Velocity,
       "velocity",
       {"velocity", "v", "speed", "slidingvelocity", "slidingspeed", "vslide", "vs",
        "geschwindigkeit", "gleitgeschwindigkeit"}},
      {Quantity::Mu,
       "coefficient of friction",
       {"mu", "\u00B5", "\u03BC", "cof", "friction", "frictioncoefficient", "coefficientoffriction",
        "coefficient", "reibwert", "reibungszahl", "reibbeiwert", "reibungskoeffizient"}},
      {Quantity::Force,
       "normal force",
       {"normalforce", "fn", "force", "load", "normalload", "w", "n", "normalkraft", "last"}},
      {Quantity::Pressure,
       "nominal pressure",
       {"nominalpressure", "pressure", "contactpressure", "p", "p0", "sigma0", "\u03C30", "druck",
        "fl\u00E4chenpressung", "nenndruck"}},
      {Quantity::Temperature,
       "temperature",
       {"temperature", "temp", "t", "temperatur", "sampletemperature", "specimentemperature",
        "probentemperatur"}},
      {Quantity::Label,
       "label",
       {"label", "sample", "name", "set", "series", "specimen", "probe", "bezeichnung", "comment"}},
      {Quantity::MuError, "error of the coefficient of friction", {}},
      {Quantity::VelocityError, "error of the velocity", {}},
  }};
  return known;
}

/// Returns the letters and digits of a name in lower case, without signs and blanks.
std::string plainWord(std::string_view text) {
  std::string word;
  for (const unsigned char letter : text)
    if (std::isalnum(letter) || letter >= 0x80) word += static_cast<char>(std::tolower(letter));
  return word;
}

/// Returns the rest of a word without the part that marks an error; nothing where there is no such
/// part.
std::optional<std::string> withoutError(std::string word) {
  for (const std::string_view sign : {"standarderror",
                                      "standarddeviation",
                                      "standarduncertainty",
                                      "standardabweichung",
                                      "standardunsicherheit",
                                      "standardfehler",
                                      "messunsicherheit",
                                      "uncertainty",
                                      "error",
                                      "stdev",
                                      "stddev",
                                      "sigma",
                                      "unsicherheit",
                                      "abweichung",
                                      "fehler",
                                      "err",
                                      "std",
                                      "dev",
                                      "sd",
                                      "se",
                                      "\u00B1",
                                      "\u03C3",
                                      "delta",
                                      "\u0394"}) {
    const std::size_t index = word.find(sign);
    // Two letters mark an error only at the beginning or end of a word: "sets" has no error.
    if (index == std::string::npos) continue;
    if (sign.size() == 2 && sign[0] < 'z' && index != 0 && index + 2 != word.size()) continue;
    word.erase(index, sign.size());
    if (word.ends_with("of")) word.resize(word.size() - 2);
    if (word.starts_with("of")) word.erase(0, 2);
    if (word.starts_with("in")) word.erase(0, 2);
    return word;
  }
  return {};
}

/// Returns the rest of a word without the letter of an uncertainty in front of it, as in "u(mu)",
/// "dmu" and "s_mu"; nothing where there is no such letter.
std::optional<std::string> withoutErrorLetter(const std::string& word) {
  constexpr std::string_view kLetters = "uds";
  if (word.size() < 2 || kLetters.find(word.front()) == std::string_view::npos) return {};
  return word.substr(1);
}

/// Returns whether a letter has several meanings, such as t for temperature and time, so that it
/// needs a unit.
bool isAmbiguous(const std::string& word) {
  return word == "t" || word == "n" || word == "w";
}

std::optional<Quantity> findMeaning(const std::string& name, const std::string& unit) {
  const std::string word = plainWord(name);
  if (unit.empty() && isAmbiguous(word)) return {};
  for (const QuantityNames& known : knownNames())
    if (std::ranges::find(known.names, word) != known.names.end()) return known.quantity;
  std::optional<std::string> subject = withoutError(word);
  if (!subject) subject = withoutErrorLetter(word);
  if (!subject) return {};
  if (subject->empty()) return Quantity::MuError;
  for (const QuantityNames& known : knownNames()) {
    if (std::ranges::find(known.names, *subject) == known.names.end()) continue;
    if (known.quantity == Quantity::Mu) return Quantity::MuError;
    if (known.quantity == Quantity::Velocity) return Quantity::VelocityError;
  }
  return {};
}

std::optional<Quantity> findMeaning(const TextColumn& column) {
  return findMeaning(column.name, column.unit);
}

/// Returns words in the order in which they stand: "velocity (mm/s) mu" has three.
std::vector<std::string> wordsOf(std::string_view text) {
  std::vector<std::string_view> fields;
  splitFields(text, TextDialect::Separator::Blanks, fields);
  return {fields.begin(), fields.end()};
}

/// Finds all ways to make so many known columns of the words from `begin` on.
void findNames(const std::vector<std::string>& words, std::size_t begin, std::size_t count,
               std::vector<TextColumn>& made, std::vector<std::vector<TextColumn>>& ways) {
  constexpr std::size_t kMostWords = 6, kMostWays = 2;
  if (ways.size() >= kMostWays) return;
  if (made.size() == count || begin == words.size()) {
    if (made.size() == count && begin == words.size()) ways.push_back(made);
    return;
  }
  // A unit in brackets begins no name.
  if (words[begin].starts_with('(') || words[begin].starts_with('[')) return;
  std::string text;
  for (std::size_t i = begin; i < std::min(words.size(), begin + kMostWords); ++i) {
    text += (text.empty() ? "" : " ") + words[i];
    TextColumn column = parseColumnName(text);
    if (!findMeaning(column.name, column.unit)) continue;
    made.push_back(std::move(column));
    findNames(words, i + 1, count, made, ways);
    made.pop_back();
  }
}

/// Returns whether some words of the line name a quantity.
bool namesQuantity(const std::string& line) {
  const std::vector<std::string> words = wordsOf(line);
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::string text;
    for (std::size_t j = i; j < std::min(words.size(), i + 3); ++j) {
      text += (text.empty() ? "" : " ") + words[j];
      const TextColumn column = parseColumnName(text);
      const auto quantity = findMeaning(column.name, column.unit);
      if (quantity && quantity != Quantity::Label && column.name.size() > 1) return true;
    }
  }
  return false;
}

std::string textOf(const TextEntry& entry) {
  return entry.key.empty() ? entry.value : entry.key + " " + entry.value;
}

/// Gives names to columns whose line of names has blanks within the names as well: "velocity (mm/s)
/// mu normal force (mN)". The line nearest to the numbers is taken.
void nameColumns(TextBlock& block) {
  const bool hasNames = std::ranges::any_of(
      block.columns, [](const TextColumn& column) { return !column.name.empty(); });
  if (hasNames || block.header.empty()) return;
  std::vector<std::vector<TextColumn>> ways;
  std::vector<TextColumn> made;
  findNames(wordsOf(textOf(block.header.back())), 0, block.columns.size(), made, ways);
  if (ways.size() != 1) return;
  for (std::size_t i = 0; i < block.columns.size(); ++i) {
    block.columns[i].name = ways.front()[i].name;
    block.columns[i].unit = ways.front()[i].unit;
  }
}

bool isOfFriction(const TextBlock& block) {
  bool hasVelocity = false, hasMu = false;
  for (const TextColumn& column : block.columns) {
    const std::optional<Quantity> quantity = findMeaning(column);
    hasVelocity = hasVelocity || quantity == Quantity::Velocity;
    hasMu = hasMu || quantity == Quantity::Mu;
  }
  return hasVelocity && hasMu;
}

/// The conversion of the numbers of a column to SI units.
struct Conversion {
  Unit unit{};
  bool isShare = false;  // of the quantity that it is the error of
};

class Reader {
 public:
  Reader(const TextBlock& block, std::string name) : block_(block), name_(std::move(name)) {}

  FrictionData read() {
    findColumns();
    FrictionData data;
    data.name = name_;
    data.notes = notes();
    for (std::size_t row = 0; row < block_.rows; ++row) data.points.push_back(pointAt(row));
    check(data.points);
    return data;
  }

 private:
  struct Column {
    Quantity quantity;
    std::size_t index;
    Conversion conversion;
    Message note;
  };

  [[noreturn]] void refuse(const Message& what) const { throw InputError(name_, "", what); }
  [[noreturn]] void refuseRow(int row, const Message& what) const {
    throw InputError(name_, "", message("row {}: {}", row, what));
  }

  void findColumns() {
    const std::size_t count = block_.columns.size();
    const bool hasNames = std::ranges::any_of(
        block_.columns, [](const TextColumn& column) { return !column.name.empty(); });
    if (!hasNames) {
      for (const TextEntry& entry : block_.header)
        if (namesQuantity(textOf(entry)))
          refuse(
              message("line {}: '{}' does not name {} columns; separate the names as the "
                      "numbers are, or write each one without blanks, such as velocity_mm/s",
                      entry.line, shortened(textOf(entry)), count));
      if (count != 2 && count != 3)
        refuse(
            message("has {} columns without names; name them: velocity, mu, and where there are "
                    "some mu_error, normal_force, nominal_pressure, temperature, label",
                    count));
      add(Quantity::Velocity, 0);
      add(Quantity::Mu, 1);
      if (count == 3) add(Quantity::MuError, 2);
      return;
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (const auto quantity = findMeaning(block_.columns[i]))
        add(*quantity, i);
      else
        refuseUnknownUnit(block_.columns[i]);
    }
    for (const TextColumn& column : block_.columns) refuseUnclear(column);
    for (const Quantity needed : {Quantity::Velocity, Quantity::Mu})
      if (!find(needed))
        refuse(message("has no column of the {}; its columns are {}", Message(meaningOf(needed)),
                       Message::name(namesOfColumns())));
    if (find(Quantity::Force) && find(Quantity::Pressure))
      refuse("has both a normal force and a nominal pressure; one of them says the load");
  }

  /// Throws InputError for a known quantity in an unknown unit, such as "load (stone)".
  void refuseUnknownUnit(const TextColumn& column) const {
    const std::size_t open = column.name.find_last_of("([");
    if (!column.unit.empty() || open == std::string::npos || open == 0) return;
    const std::string unit = column.name.substr(open);
    TextColumn known{column.name.substr(0, open), std::string(withoutBrackets(unit)), false};
    if (const auto quantity = findMeaning(known)) {
      conversionOf(*quantity, known);
      refuse(message("column {}: the unit {} is not understood", shortened(column.name),
                     shortened(known.unit)));
    }
  }

  /// Throws InputError for bounds of a quantity, and for a load or temperature with words that are
  /// not understood while no other column gives it: leaving these out would change the result.
  void refuseUnclear(const TextColumn& column) const {
    if (findMeaning(column) || column.isText) return;
    std::string text = column.name;
    std::ranges::replace(text, '_', ' ');
    std::ranges::replace(text, '-', ' ');
    std::vector<std::string> words;
    for (const std::string& word : wordsOf(text)) words.push_back(plainWord(word));
    std::erase(words, std::string());
    if (words.size() < 2) return;
    const auto isBound = [](const std::string& word) {
      constexpr std::array<std::string_view, 8> kBounds{"min",   "max",   "minimum", "maximum",
                                                        "lower", "upper", "low",     "high"};
      return std::ranges::find(kBounds, word) != kBounds.end();
    };
    std::string subject;
    for (const std::string& word : words)
      if (!isBound(word)) subject += word;
    const bool hasBound = std::ranges::any_of(words, isBound);
    for (const QuantityNames& known : knownNames())
      if (hasBound && std::ranges::find(known.names, subject) != known.names.end())
        refuse(
            message("column {}: bounds of the {} are not read; give its error as a column such "
                    "as mu_error, or take the column out",
                    shortened(column.name), Message(known.meaning)));
    if (withoutError(plainWord(column.name))) return;
    constexpr std::size_t kShortest = 4;  // letters; shorter names mean something else in a text
    for (const QuantityNames& known : knownNames()) {
      if (known.quantity != Quantity::Force && known.quantity != Quantity::Pressure &&
          known.quantity != Quantity::Temperature)
        continue;
      const bool isForce = known.quantity != Quantity::Temperature;
      if (find(known.quantity) || (isForce && (find(Quantity::Force) || find(Quantity::Pressure))))
        continue;
      const auto isOfFriction = [](const std::string& word) {
        return word.starts_with("fric") || word.starts_with("tang") || word.starts_with("later") ||
               word.starts_with("shear") || word.starts_with("drag") || word.starts_with("reib");
      };
      if (std::ranges::any_of(words, isOfFriction)) continue;
      for (const std::string* word : {&words.front(), &words.back()})
        if (word->size() >= kShortest && std::ranges::find(known.names, *word) != known.names.end())
          refuse(
              message("column {}: is it the {}? Name it so alone, with its unit in brackets, "
                      "or take the column out",
                      shortened(column.name), Message(known.meaning)));
    }
  }

  /// Returns notes on how the columns were understood, and which ones were ignored.
  std::vector<Message> notes() const {
    std::vector<Message> notes{columns_.front().note};
    for (std::size_t i = 1; i < columns_.size(); ++i)
      notes.front() = message("{}; {}", notes.front(), columns_[i].note);
    std::string unused;
    for (std::size_t i = 0; i < block_.columns.size(); ++i)
      if (std::ranges::find(columns_, i, &Column::index) == columns_.end())
        unused += (unused.empty() ? "" : ", ") + (block_.columns[i].name.empty()
                                                      ? std::to_string(i + 1)
                                                      : shortened(block_.columns[i].name));
    if (!unused.empty()) notes.push_back(message("not used: {}", Message::name(unused)));
    return notes;
  }

  std::string namesOfColumns() const {
    std::string names;
    for (const TextColumn& column : block_.columns)
      names += (names.empty() ? "" : ", ") + shortened(column.name);
    return names;
  }

  static const char* meaningOf(Quantity quantity) {
    return std::ranges::find(knownNames(), quantity, &QuantityNames::quantity)->meaning;
  }

  const Column* find(Quantity quantity) const {
    const auto found = std::ranges::find(columns_, quantity, &Column::quantity);
    return found == columns_.end() ? nullptr : &*found;
  }

  void add(Quantity quantity, std::size_t index) {
    const TextColumn& column = block_.columns[index];
    if (const Column* other = find(quantity))
      refuse(message("has two columns of the {}: {} and {}", Message(meaningOf(quantity)),
                     shortened(block_.columns[other->index].name), shortened(column.name)));
    if (column.isText && quantity != Quantity::Label)
      refuse(message("column {} has texts where numbers are expected", shortened(column.name)));
    if (!column.isText && quantity == Quantity::Label) return;  // numbers of samples
    const Conversion conversion = conversionOf(quantity, column);
    const std::string unit = column.unit.empty() ? std::string(conversion.unit.si) : column.unit;
    const int number = static_cast<int>(index) + 1;
    const Message meaning(meaningOf(quantity));
    columns_.push_back({quantity, index, conversion,
                        unit.empty()
                            ? message("column {}: {}", number, meaning)
                            : message("column {}: {} ({})", number, meaning, Message::name(unit))});
  }

  /// Finds the conversion of a column; one without a unit is in SI units.
  Conversion conversionOf(Quantity quantity, const TextColumn& column) const {
    const auto unitOf = [&](std::string_view si, const std::string& known) {
      if (column.unit.empty()) return Conversion{Unit{si}};
      const auto unit = quantity == Quantity::Temperature ? temperatureUnit(column.unit)
                                                          : unitInAnyCase(column.unit, si);
      if (!unit)
        refuse(message("column {}: the unit {} is unknown; known are {}", shortened(column.name),
                       shortened(column.unit), known));
      return Conversion{*unit};
    };
    const Conversion share{*findUnit("%"), true};
    switch (quantity) {
      case Quantity::Velocity:
        return unitOf("m/s", unitNames("m/s"));
      case Quantity::VelocityError:
        return column.unit == "%" ? share : unitOf("m/s", unitNames("m/s") + ", %");
      case Quantity::Force:
        return unitOf("N", "N, mN, uN, kN");
      case Quantity::Pressure:
        return unitOf("Pa", "Pa, kPa, MPa, bar");
      case Quantity::Mu:
        return isPure(column.unit) ? Conversion{} : unitOf("", "1, %");
      case Quantity::MuError:
        return column.unit == "%" ? share : isPure(column.unit) ? Conversion{} : unitOf("", "1, %");
      case Quantity::Temperature:
        return unitOf("K", "K, C, F");
      default:
        return {};
    }
  }

  static bool isPure(std::string_view unit) {
    return unit.empty() || unit == "1" || unit == "-" || unit == "N/N";
  }

  /// Returns a value of a row; NaN where the column or the value is missing.
  double valueAt(std::size_t row, Quantity quantity, double whole = 1) const {
    const Column* column = find(quantity);
    if (!column) return kNotApplicable;
    const double number = block_.at(row, column->index);
    if (std::isnan(number)) return kNotApplicable;
    const Conversion& in = column->conversion;
    return in.unit.toSi(number) * (in.isShare ? whole : 1);
  }

  MeasuredPoint pointAt(std::size_t row) const {
    MeasuredPoint point;
    point.row = static_cast<int>(block_.lines[row]);
    point.velocity = valueAt(row, Quantity::Velocity);
    point.mu = valueAt(row, Quantity::Mu);
    needPositive(point, point.velocity, Quantity::Velocity);
    needPositive(point, point.mu, Quantity::Mu);
    point.muError = valueAt(row, Quantity::MuError, point.mu);
    point.velocityError = valueAt(row, Quantity::VelocityError, point.velocity);
    point.normalForce = valueAt(row, Quantity::Force);
    point.nominalPressure = valueAt(row, Quantity::Pressure);
    point.temperature = valueAt(row, Quantity::Temperature);
    for (const auto& [quantity, value] : {std::pair{Quantity::MuError, point.muError},
                                          {Quantity::Force, point.normalForce},
                                          {Quantity::Pressure, point.nominalPressure},
                                          {Quantity::Temperature, point.temperature}})
      if (find(quantity)) needPositive(point, value, quantity);
    if (find(Quantity::VelocityError) && !std::isnan(point.velocityError) &&
        !(point.velocityError >= 0))
      refuseRow(point.row, "the error of the velocity is below 0");
    if (const Column* temperature = find(Quantity::Temperature)) {
      constexpr double kColdest = 120;  // K; below it no elastomer is rubbery
      if (block_.columns[temperature->index].unit.empty() && point.temperature < kColdest)
        refuseRow(point.row,
                  message("a temperature of {} K is too cold for rubber; name the unit, as in "
                          "\"temperature (C)\"",
                          plain(point.temperature)));
    }
    if (const Column* label = find(Quantity::Label)) point.label = block_.texts[label->index][row];
    return point;
  }

  void needPositive(const MeasuredPoint& point, double value, Quantity quantity) const {
    const Message meaning = meaningOf(quantity);
    if (std::isnan(value))
      refuseRow(point.row, message("the {} is missing", meaning));
    else if (!(value > 0))
      refuseRow(point.row, message("the {} is {}, which is not above 0", meaning, plain(value)));
  }

  void check(const std::vector<MeasuredPoint>& points) const {
    if (points.size() < 2)
      refuse(message("has {} row of numbers; at least 2 are needed", points.size()));
    const auto areEqual = [](double a, double b) {
      return (std::isnan(a) && std::isnan(b)) || a == b;
    };
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (points[i].velocity == points[j].velocity && points[i].label == points[j].label &&
            areEqual(points[i].normalForce, points[j].normalForce) &&
            areEqual(points[i].nominalPressure, points[j].nominalPressure) &&
            areEqual(points[i].temperature, points[j].temperature))
          refuseRow(points[i].row,
                    message("has the velocity of row {}, {} m/s; average repeated measurements and "
                            "give their error as mu_error, or tell them apart by a label",
                            points[j].row, plain(points[i].velocity)));
  }

  const TextBlock& block_;
  std::string name_;
  std::vector<Column> columns_;
};

}  // namespace

bool isFrictionTable(const TextTable& table) {
  return isOfFriction(table.largest());
}

FrictionData parseFrictionData(std::string_view bytes, const std::string& name) {
  TextTableOptions options;
  options.keepsTexts = true;
  options.textColumns = {"label", "sample", "name", "set", "series", "specimen"};
  TextTable table = readTextTable(bytes, name, options);
  undoLogarithms(
      table, [](const std::string& quantity) { return findMeaning(quantity, "?").has_value(); });
  for (TextBlock& block : table.blocks) nameColumns(block);
  const TextBlock* first = nullptr;
  for (const TextBlock& block : table.blocks) {
    if (!isOfFriction(block)) continue;
    if (first != nullptr)
      throw InputError(name, "",
                       message("has several tables of friction, at lines {} and {}; each needs a "
                               "file of its own, or all one table with a column that tells them "
                               "apart, such as temperature or label",
                               first->lines.front(), block.lines.front()));
    first = &block;
  }
  FrictionData data = Reader(table.largest(), name).read();
  if (table.dialect.isUnclear) data.notes.push_back(unclearMark(table.dialect.decimal));
  return data;
}

FrictionData readFrictionData(const std::filesystem::path& file, const std::string& label) {
  constexpr std::size_t kLargest = std::size_t{1} << 26;  // bytes
  FrictionData data = parseFrictionData(readRegularFile(file, kLargest), file.string());
  data.name = label.empty() ? file.stem().string() : label;
  return data;
}

Scene sceneAtPoint(const MeasuredPoint& point, const Scene& scene) {
  Scene at = scene;
  at.sliding.kind = SlidingKind::Steady;
  at.sliding.velocity = point.velocity;
  if (!std::isnan(point.normalForce)) {
    at.load.kind = LoadKind::Force;
    at.load.normalForce = point.normalForce;
  }
  if (!std::isnan(point.nominalPressure)) {
    at.load.kind = LoadKind::Pressure;
    at.load.nominalPressure = point.nominalPressure;
  }
  if (!std::isnan(point.temperature)) at.elastomer.temperature = point.temperature;
  return at;
}

}  // namespace asperity
