#include "core/fit/friction_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <optional>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/regular_file.h"
#include "core/base/statistics.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/base/text_table.h"
#include "core/fit/friction_columns.h"
#include "core/fit/friction_header.h"
#include "core/material/dma_columns.h"

namespace asperity {
namespace {

using Quantity = FrictionQuantity;

bool isOfFriction(const TextBlock& block) {
  bool hasVelocity = false, hasMu = false;
  for (const TextColumn& column : block.columns) {
    const std::optional<Quantity> quantity = findMeaning(column);
    hasVelocity = hasVelocity || quantity == Quantity::Velocity;
    hasMu = hasMu || quantity == Quantity::Mu;
  }
  return hasVelocity && hasMu;
}

/// Returns the decimal mark of a table. A table of whole numbers shows none; where it may be a mark
/// of thousands, a note says which one is taken.
HeaderMark markOf(const TextBlock& block, const TextDialect& dialect) {
  const bool hasDecimals = std::ranges::any_of(block.values, [](double value) {
    return std::isfinite(value) && value != std::floor(value);
  });
  return {dialect.decimal, hasDecimals || dialect.isUnclear};
}

/// The conversion of the numbers of a column to SI units.
struct Conversion {
  Unit unit{};
  bool isShare = false;  // of the quantity that it is the error of
  double divisor = 1;    // of an error, for one standard error
  bool isVariance = false;
  bool isForce = false;  // of friction, to be divided by the normal force
  Message unitText{};    // for the notes; empty: as the column writes it
};

class Reader {
 public:
  Reader(const TextBlock& block, const TextDialect& dialect, std::string name)
      : block_(block), name_(std::move(name)), mark_(markOf(block, dialect)) {}

  FrictionData read() {
    findColumns();
    readHeader();
    FrictionData data;
    data.name = name_;
    data.notes = notes();
    for (std::size_t row = 0; row < block_.rows; ++row)
      if (!isBlank(row)) data.points.push_back(pointAt(row));
    if (!repeats_.empty()) averageRepeats(data.points);
    check(data.points);
    noteSlips(data);
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
        if (namesQuantity(lineOf(entry, " ")))
          refuse(
              message("line {}: '{}' does not name {} columns; separate the names as the "
                      "numbers are, or write each one without blanks, such as velocity_mm/s",
                      entry.line, shortened(lineOf(entry, " ")), count));
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
    refuseSeveralStates();
    for (std::size_t i = 0; i < count; ++i) {
      const TextColumn& column = block_.columns[i];
      if (const auto quantity = findMeaning(column)) {
        if (isClear(column) || !hasClearColumn(*quantity)) add(*quantity, i);
      } else {
        refuseUnknownUnit(column);
      }
    }
    for (const TextColumn& column : block_.columns) refuseUnclear(column);
    if (!find(Quantity::Mu)) findRepeats();
    if (!find(Quantity::Mu) && find(Quantity::Force)) findFrictionForce();
    for (const Quantity needed : {Quantity::Velocity, Quantity::Mu})
      if (!find(needed))
        refuse(message("has no column of the {}; its columns are {}", Message(meaningOf(needed)),
                       Message::name(namesOfColumns())));
    if (find(Quantity::Force) && find(Quantity::Pressure))
      refuse("has both a normal force and a nominal pressure; one of them says the load");
  }

  /// Throws InputError for friction at several temperatures or loads side by side.
  void refuseSeveralStates() const {
    std::string names;
    int count = 0;
    for (const TextColumn& column : block_.columns) {
      const std::vector<std::string> words = nameWords(column.name);
      if (words.empty() || quantityNamed(words.front()) != Quantity::Mu) continue;
      // "mu (0.1 MPa)", "mu 20 \u00B0C"; "mu 1" is the first of several measurements.
      const bool isInUnit = column.unit.size() > 1 && isDigit(column.unit.front());
      const bool isInName = words.size() > 1 && isDigit(words[1].front()) &&
                            (words.size() > 2 || !column.unit.empty()) && !findMeaning(column);
      if (!isInUnit && !isInName) continue;
      names += (count++ > 0 ? ", " : "") + shortened(column.name);
    }
    if (count > 1)
      refuse(
          message("has friction in several states side by side ({}); write them one below the "
                  "other, with a column that tells them apart, such as temperature",
                  Message::name(names)));
  }

  /// Finds columns "mu1", "mu2", ... of repeated measurements.
  void findRepeats() {
    for (std::size_t i = 0; i < block_.columns.size(); ++i) {
      const TextColumn& column = block_.columns[i];
      const std::string word = plainWord(column.name);
      const std::string name = word.substr(0, word.find_last_not_of("0123456789") + 1);
      if (name != word && quantityNamed(name) == Quantity::Mu && isPure(column.unit) &&
          !column.isText)
        repeats_.push_back(i);
    }
    if (repeats_.size() < 2 || find(Quantity::MuError)) {
      repeats_.clear();
      return;
    }
    columns_.push_back({Quantity::Mu,
                        repeats_.front(),
                        {},
                        message("columns {} to {}: repeated measurements of the coefficient of "
                                "friction; each point is their mean, with a standard error from "
                                "the scatter in all rows",
                                repeats_.front() + 1, repeats_.back() + 1)});
  }

  /// Returns the repeated measurements of a row.
  std::vector<double> repeatsOf(std::size_t row) const {
    std::vector<double> values;
    for (const std::size_t index : repeats_)
      if (const double value = block_.at(row, index); !std::isnan(value)) values.push_back(value);
    return values;
  }

  /// Sets friction to the mean of its repeats. The relative scatter is that of all rows together,
  /// because that of a few values is itself uncertain.
  void averageRepeats(std::vector<MeasuredPoint>& points) const {
    double squares = 0;
    std::size_t freedom = 0, i = 0;
    std::vector<std::size_t> counts;
    for (std::size_t row = 0; row < block_.rows; ++row) {
      if (isBlank(row)) continue;
      const std::vector<double> values = repeatsOf(row);
      for (const double value : values) squares += std::pow(value / points[i].mu - 1, 2);
      freedom += values.size() - 1;
      counts.push_back(values.size());
      ++i;
    }
    if (!(squares > 0)) return;
    for (i = 0; i < points.size(); ++i)
      points[i].muError = points[i].mu * std::sqrt(squares / static_cast<double>(freedom) /
                                                   static_cast<double>(counts[i]));
  }

  /// Finds the one column of the force of friction, which gives mu beside the normal force.
  void findFrictionForce() {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < block_.columns.size(); ++i)
      if (isOneOf(plainWord(block_.columns[i].name),
                  "fx ft fr ff frictionforce reibkraft reibungskraft") &&
          !block_.columns[i].isText)
        found.push_back(i);
    if (found.size() != 1) return;
    Conversion conversion = conversionOf(Quantity::Force, block_.columns[found.front()]);
    conversion.isForce = true;
    columns_.push_back({Quantity::Mu, found.front(), conversion,
                        message("column {}: force of friction; its magnitude over the normal force "
                                "is the coefficient of friction",
                                found.front() + 1)});
  }

  static bool isClear(const TextColumn& column) {
    return !isAmbiguousName(column.name) && !findErrorScale(column);
  }

  /// Returns whether a row has nothing but separators.
  bool isBlank(std::size_t row) const {
    for (std::size_t i = 0; i < block_.columns.size(); ++i)
      if (block_.columns[i].isText ? !block_.texts[i][row].empty() : !std::isnan(block_.at(row, i)))
        return false;
    return true;
  }

  /// Returns whether a column names the quantity by more than an ambiguous letter.
  bool hasClearColumn(Quantity quantity) const {
    return std::ranges::any_of(block_.columns, [&](const TextColumn& column) {
      return findMeaning(column) == quantity && isClear(column);
    });
  }

  /// Throws InputError for a known quantity in an unknown unit, such as "load (stone)".
  void refuseUnknownUnit(const TextColumn& column) const {
    const std::size_t open = column.name.find_last_of("([");
    if (!column.unit.empty() || open == std::string::npos || open == 0) return;
    const std::string unit = column.name.substr(open);
    TextColumn known{std::string(trimmedBlanks(column.name.substr(0, open))),
                     std::string(withoutBrackets(unit)), false};
    if (const auto quantity = findMeaning(known)) {
      conversionOf(*quantity, known);
      refuse(message("column {}: the unit {} is not understood", shortened(column.name),
                     shortened(known.unit)));
    }
  }

  /// Throws InputError for bounds of a quantity, and for a load or temperature, by its name or its
  /// unit, that is not understood while no other column gives it: leaving these out would change
  /// the result.
  void refuseUnclear(const TextColumn& column) const {
    if (findMeaning(column)) return;
    if (column.name == "T" && !isGiven(Quantity::Temperature) &&
        (column.unit.empty() || isOneOf(plainWord(column.unit), "deg degree degrees \u00B0")))
      refuse(
          "column T: is it the temperature of the rubber? Give it as numbers with a unit, as "
          "in \"T (\u00B0C)\", or take the column out");
    if (column.isText) return;
    if (const auto scale = findErrorScale(column);
        scale && scale->isIndefinite && !find(Quantity::MuError))
      refuse(
          message("column {}: it is not known how many standard errors this is; give one standard "
                  "error as mu_error, or take the column out",
                  shortened(column.name)));
    if (column.name == "s" && column.unit.empty() && !find(Quantity::MuError))
      refuse(
          "column s: is it the standard deviation of the coefficient of friction? Name it "
          "std, or take the column out");
    const std::vector<std::string> words = nameWords(column.name);
    if (words.empty()) return;
    const auto isBound = [](const std::string& word) {
      return isOneOf(word, "min max minimum maximum lower upper low high");
    };
    std::string subject;
    for (const std::string& word : words)
      if (!isBound(word)) subject += word;
    const bool hasBound = std::ranges::any_of(words, isBound);
    auto named = quantityNamed(subject);
    if (!named) named = findMeaning(TextColumn{subject});
    if (hasBound && named)
      refuse(
          message("column {}: bounds of the {} are not read; give its error as a column such "
                  "as mu_error, or take the column out",
                  shortened(column.name), Message(meaningOf(*named))));
    if (isErrorName(column.name) || isOtherLoad(words)) return;
    for (const Quantity quantity : kLoadsAndTemperature) {
      if (isGiven(quantity)) continue;
      constexpr std::size_t kShortest = 4;  // letters; shorter names mean something else in a text
      const auto names = [&](const std::string& word) {
        return words.size() > 1 && word.size() >= kShortest && quantityNamed(word) == quantity;
      };
      if (!measures(column.unit, quantity) && !names(words.front()) && !names(words.back()))
        continue;
      if (quantity == Quantity::Temperature)
        refuse(
            message("column {}: is it the temperature of the rubber, and not of the track or "
                    "the air? Name it temperature alone, with its unit in brackets, or take "
                    "the column out",
                    shortened(column.name)));
      refuse(
          message("column {}: is it the {}? Name it so alone, with its unit in brackets, "
                  "or take the column out",
                  shortened(column.name), Message(meaningOf(quantity))));
    }
  }

  /// Returns whether a column gives this quantity; a force and a pressure both say the load.
  bool isGiven(Quantity quantity) const {
    if (quantity == Quantity::Temperature) return find(quantity) != nullptr;
    return find(Quantity::Force) != nullptr || find(Quantity::Pressure) != nullptr;
  }

  /// Reads the loads and temperatures that lines above the table state for all points. What is not
  /// understood, or given by a column, is kept for the notes.
  void readHeader() {
    for (const TextEntry& entry : block_.header)
      for (HeaderStatement& statement : readStatements(entry, mark_)) {
        const bool isCommon = statement.quantity && !isGiven(*statement.quantity);
        (isCommon ? common_ : unused_).push_back(std::move(statement));
      }
    // Two values of one quantity, or a force and a pressure, leave open which one is meant.
    const auto isDoubtful = [this](const HeaderStatement& one) {
      return !(one.value > 0) || std::ranges::any_of(common_, [&one](const HeaderStatement& other) {
        const bool areLoads =
            one.quantity != Quantity::Temperature && other.quantity != Quantity::Temperature;
        return one.quantity == other.quantity ? one.value != other.value : areLoads;
      });
    };
    hasTwoLoads_ = std::ranges::count(common_, true, [&](const HeaderStatement& one) {
                     return one.quantity != Quantity::Temperature && isDoubtful(one);
                   }) > 1;
    std::vector<HeaderStatement> sure;
    for (const HeaderStatement& one : common_) (isDoubtful(one) ? unused_ : sure).push_back(one);
    common_ = std::move(sure);
    std::ranges::stable_sort(unused_, {}, &HeaderStatement::line);
    for (const HeaderStatement& one : unused_) refuseUnclear(one);
  }

  /// Throws InputError for a load or temperature above the table that is not understood and may be
  /// the one meant, unless another line or column gives it.
  void refuseUnclear(const HeaderStatement& one) const {
    if (one.quantity || !one.candidate || isGiven(*one.candidate)) return;
    const bool isTemperature = one.candidate == Quantity::Temperature;
    for (const HeaderStatement& other : common_)
      if ((other.quantity == Quantity::Temperature) == isTemperature) return;
    struct WayOut {
      Quantity quantity;
      const char *example, *key;
    };
    constexpr WayOut kWaysOut[] = {
        {Quantity::Temperature, "Temperature: 23 \u00B0C", "elastomer.temperature"},
        {Quantity::Pressure, "Nominal pressure: 0.2 MPa", "load.nominal_pressure"},
        {Quantity::Force, "Normal force: 30 N", "load.normal_force"}};
    const auto& [quantity, example, key] =
        *std::ranges::find(kWaysOut, *one.candidate, &WayOut::quantity);
    refuse(
        message("line {}: '{}' may state the {}, but is not understood; write it as in \"{}\", or "
                "take the line out and set {}",
                one.line, shortened(one.text), Message(meaningOf(quantity)), example, key));
  }

  /// Returns notes on how the columns were understood, and which ones were ignored.
  std::vector<Message> notes() const {
    std::vector<Message> notes{columns_.front().note};
    for (std::size_t i = 1; i < columns_.size(); ++i)
      notes.front() = message("{}; {}", notes.front(), columns_[i].note);
    for (const HeaderStatement& one : common_)
      notes.front() =
          message("{}; {}", notes.front(),
                  message("line {}: {} of all points ({})", one.line,
                          Message(meaningOf(*one.quantity)), Message::name(shortened(one.text))));
    std::string unused;
    for (std::size_t i = 0; i < block_.columns.size(); ++i)
      if (std::ranges::find(columns_, i, &Column::index) == columns_.end() &&
          std::ranges::find(repeats_, i) == repeats_.end())
        unused += (unused.empty() ? "" : ", ") + (block_.columns[i].name.empty()
                                                      ? std::to_string(i + 1)
                                                      : shortened(block_.columns[i].name));
    for (const HeaderStatement& statement : unused_)
      unused += (unused.empty() ? "" : ", ") + shortened(statement.text);
    if (!unused.empty()) notes.push_back(message("not used: {}", Message::name(unused)));
    if (hasTwoLoads_)
      notes.emplace_back(
          "the lines above the table state several loads; one normal force or one nominal pressure "
          "says the load");
    for (const HeaderStatement& one : common_)
      if (!one.groupedNumber.empty())
        notes.push_back(
            mark_.decimal == ','
                ? message("line {}: {} is read as {}; the decimal mark of the table is a comma",
                          one.line, one.groupedNumber, plain(one.number))
                : message("line {}: {} is read as {}; the decimal mark of the table is a point",
                          one.line, one.groupedNumber, plain(one.number)));
    return notes;
  }

  std::string namesOfColumns() const {
    std::string names;
    for (const TextColumn& column : block_.columns)
      names += (names.empty() ? "" : ", ") + shortened(column.name);
    return names;
  }

  const Column* find(Quantity quantity) const {
    const auto found = std::ranges::find(columns_, quantity, &Column::quantity);
    return found == columns_.end() ? nullptr : &*found;
  }

  void add(Quantity quantity, std::size_t index) {
    const TextColumn& column = block_.columns[index];
    if (const Column* other = find(quantity); other && quantity != Quantity::Label)
      refuse(message("has two columns of the {}: {} and {}", Message(meaningOf(quantity)),
                     shortened(block_.columns[other->index].name), shortened(column.name)));
    const auto hasError = [](const std::string& text) {
      return containsOneOf(text, "\u00B1 +/- +- (");
    };
    if (column.isText && quantity == Quantity::Mu &&
        std::ranges::all_of(block_.texts[index], hasError))
      refuse(
          message("column {}: '{}' is a value with its error; write them in two columns, mu and "
                  "mu_error",
                  shortened(column.name), shortened(block_.texts[index].front())));
    if (column.isText && quantity != Quantity::Label)
      refuse(message("column {} has texts where numbers are expected", shortened(column.name)));
    // Numbers of samples and lengths of tracks are no labels.
    if (quantity == Quantity::Label && (!column.isText || !column.unit.empty())) return;
    const Conversion conversion = conversionOf(quantity, column);
    Message unit = conversion.unitText;
    if (unit.empty())
      unit = Message::name(column.unit.empty() ? std::string(conversion.unit.si) : column.unit);
    const int number = static_cast<int>(index) + 1;
    const Message meaning(meaningOf(quantity));
    columns_.push_back({quantity, index, conversion,
                        unit.empty() ? message("column {}: {}", number, meaning)
                                     : message("column {}: {} ({})", number, meaning, unit)});
  }

  /// Finds the conversion of a column; one without a unit is in SI units.
  Conversion conversionOf(Quantity quantity, const TextColumn& column) const {
    const auto scale = findErrorScale(column);
    if (!scale) return unscaledConversion(quantity, column);
    const std::string relative = scale->isShare ? "relative " : "";
    Conversion scaled = unscaledConversion(quantity, {relative + scale->name, scale->unit});
    scaled.divisor = scale->divisor;
    scaled.isVariance = scale->isVariance;
    if (scale->isVariance)
      scaled.unitText = "its square root";
    else if (scale->divisor != 1 && scaled.unitText.empty())
      scaled.unitText = message("divided by {} for one standard error", plain(scale->divisor));
    else if (scale->divisor != 1)
      scaled.unitText = message("{}, divided by {} for one standard error", scaled.unitText,
                                plain(scale->divisor));
    return scaled;
  }

  Conversion unscaledConversion(Quantity quantity, const TextColumn& column) const {
    const auto unitOf = [&](std::string_view si, const std::string& known) {
      if (column.unit.empty()) return Conversion{Unit{si}};
      const auto unit = quantity == Quantity::Temperature ? temperatureUnit(column.unit)
                                                          : unitInAnyCase(column.unit, si);
      if (!unit)
        refuse(message("column {}: the unit {} is unknown; known are {}", shortened(column.name),
                       shortened(column.unit), known));
      return Conversion{*unit};
    };
    const Conversion share{.unit = *findUnit("%"), .isShare = true, .unitText = "% of the value"};
    switch (quantity) {
      case Quantity::Velocity:
        return unitOf("m/s", unitNames("m/s"));
      case Quantity::VelocityError:
        return column.unit == "%" || isShareUnit(column.unit)
                   ? share
                   : unitOf("m/s", unitNames("m/s") + ", %");
      case Quantity::Force:
        return unitOf("N", "N, mN, uN, kN");
      case Quantity::Pressure:
        return unitOf("Pa", "Pa, kPa, MPa, bar");
      case Quantity::Mu:
        return isPure(column.unit) ? Conversion{} : unitOf("", "1, %");
      case Quantity::MuError:
        return isPure(column.unit) || column.unit == "%" || isShareUnit(column.unit)
                   ? errorConversion(column)
                   : unitOf("", "1, %");
      case Quantity::Temperature:
        return unitOf("K", "K, C, F");
      default:
        return {};
    }
  }

  /// Finds the conversion of an error of mu. In per cent it is a share of mu, unless mu itself is
  /// in per cent: then a name that does not say "relative" means percentage points of mu.
  Conversion errorConversion(const TextColumn& column) const {
    const Unit percent = *findUnit("%");
    const auto mu = std::ranges::find_if(
        block_.columns, [](const TextColumn& other) { return findMeaning(other) == Quantity::Mu; });
    const bool isMuInPercent = mu != block_.columns.end() && mu->unit == "%";
    const bool isShare = isRelativeError(column.name) || isShareUnit(column.unit) ||
                         (column.unit == "%" && !isMuInPercent);
    const bool isInPercent = column.unit.starts_with('%');
    if (isShare && !isInPercent) return {.isShare = true, .unitText = "share of the value"};
    if (isShare) return {.unit = percent, .isShare = true, .unitText = "% of the value"};
    if (isInPercent || (column.unit.empty() && isMuInPercent))
      return {.unit = percent, .unitText = "percentage points"};
    return {};
  }

  static bool isPure(std::string_view unit) {
    return unit.empty() || unit == "1" || unit == "-" || unit == "N/N";
  }

  /// Returns a value of a row; NaN where the column or the value is missing.
  double valueAt(std::size_t row, Quantity quantity, double whole = 1) const {
    const Column* column = find(quantity);
    if (!column) {
      const auto common = std::ranges::find(common_, quantity, &HeaderStatement::quantity);
      return common == common_.end() ? kNotApplicable : common->value;
    }
    if (quantity == Quantity::Mu && !repeats_.empty()) {
      const std::vector<double> values = repeatsOf(row);
      return values.empty() ? kNotApplicable : mean(values);
    }
    const Conversion& in = column->conversion;
    double number = block_.at(row, column->index);
    if (std::isnan(number)) return kNotApplicable;
    if (in.isVariance) number = std::sqrt(number);
    if (in.isForce) return std::abs(in.unit.toSi(number)) / valueAt(row, Quantity::Force);
    return in.unit.toSi(number) * (in.isShare ? whole : 1) / in.divisor;
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
    for (const Column& column : columns_)
      if (column.quantity == Quantity::Label)
        point.label += (point.label.empty() ? "" : ", ") + block_.texts[column.index][row];
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
    refusePercent(points);
    refuseFrictionForce(points);
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (points[i].velocity == points[j].velocity && areOfOneSeries(points[i], points[j]))
          refuseRow(points[i].row,
                    message("has the velocity of row {}, {} m/s; average repeated measurements and "
                            "give their error as mu_error, or tell them apart by a label",
                            points[j].row, plain(points[i].velocity)));
  }

  /// Throws InputError for a force that is proportional to friction: it is the force of friction,
  /// under a constant load.
  void refuseFrictionForce(const std::vector<MeasuredPoint>& points) const {
    constexpr std::size_t kFewest = 3;
    constexpr double kRounding = 1.02, kVaries = 1.1;
    const Column* force = find(Quantity::Force);
    if (!force || points.size() < kFewest) return;
    const auto ratio = [](const MeasuredPoint& point) { return point.normalForce / point.mu; };
    const auto [least, most] = std::ranges::minmax_element(points, {}, &MeasuredPoint::mu);
    const auto [low, high] = std::ranges::minmax_element(points, {}, ratio);
    if (most->mu < kVaries * least->mu || ratio(*high) > kRounding * ratio(*low)) return;
    refuse(message(
        "column {}: the force is proportional to the coefficient of friction, as a force of "
        "friction is; name it friction force, and give the normal force in a column "
        "normal_force or a line \"Normal force: {:.3g} N\"",
        shortened(block_.columns[force->index].name), ratio(*low)));
  }

  /// Returns whether two points differ at most in their velocity and friction.
  static bool areOfOneSeries(const MeasuredPoint& a, const MeasuredPoint& b) {
    const auto areEqual = [](double x, double y) {
      return (std::isnan(x) && std::isnan(y)) || x == y;
    };
    return a.label == b.label && areEqual(a.normalForce, b.normalForce) &&
           areEqual(a.nominalPressure, b.nominalPressure) && areEqual(a.temperature, b.temperature);
  }

  /// Adds a note on each point that is many times higher or lower than its neighbours: one slip of
  /// a decimal mark moves a whole fit.
  static void noteSlips(FrictionData& data) {
    std::vector<const MeasuredPoint*> open;
    for (const MeasuredPoint& point : data.points) open.push_back(&point);
    while (!open.empty()) {
      std::vector<const MeasuredPoint*> series;
      const MeasuredPoint& first = *open.front();
      const auto isOfSeries = [&first](const MeasuredPoint* point) {
        return areOfOneSeries(*point, first);
      };
      std::ranges::copy_if(open, std::back_inserter(series), isOfSeries);
      std::erase_if(open, isOfSeries);
      std::ranges::sort(series, {}, [](const MeasuredPoint* point) { return point->velocity; });
      if (const auto slip = slipOf(series)) data.notes.push_back(*slip);
    }
  }

  /// Returns a note on the point of a series, in the order of velocities, that lies furthest from
  /// the line between its neighbours in double logarithm, where it is far above or below both. The
  /// first and the last two points are left out: there it is open which one is wrong.
  static std::optional<Message> slipOf(const std::vector<const MeasuredPoint*>& series) {
    constexpr double kFarFromLine = 8, kFarFromBoth = 3;
    double most = 1;
    std::size_t furthest = 0;
    for (std::size_t i = 1; i + 1 < series.size(); ++i) {
      const MeasuredPoint &before = *series[i - 1], &behind = *series[i + 1];
      const double part = std::log(series[i]->velocity / before.velocity) /
                          std::log(behind.velocity / before.velocity);
      const double ratio = series[i]->mu / (before.mu * std::pow(behind.mu / before.mu, part));
      if (std::max(ratio, 1 / ratio) <= std::max(most, 1 / most)) continue;
      most = ratio;
      furthest = i;
    }
    if (furthest < 2 || furthest + 2 >= series.size()) return {};
    const double mu = series[furthest]->mu, before = series[furthest - 1]->mu,
                 behind = series[furthest + 1]->mu;
    const bool isFar = mu > kFarFromBoth * std::max(before, behind) ||
                       kFarFromBoth * mu < std::min(before, behind);
    if (!isFar || std::max(most, 1 / most) < kFarFromLine) return {};
    return message(
        "row {}: the coefficient of friction {} is {:.2g} times what the points beside it give; is "
        "its decimal mark right?",
        series[furthest]->row, plain(mu), most);
  }

  /// Throws InputError for friction without a unit that is too high for any rubber: it is in per
  /// cent.
  void refusePercent(const std::vector<MeasuredPoint>& points) const {
    constexpr double kHighest = 5;
    const auto [least, most] = std::ranges::minmax_element(points, {}, &MeasuredPoint::mu);
    if (!block_.columns[find(Quantity::Mu)->index].unit.empty() || !(least->mu > kHighest)) return;
    refuse(
        message("the coefficients of friction are {} to {}; name their unit in the header, as "
                "in \"mu (%)\" or \"mu (1)\"",
                plain(least->mu), plain(most->mu)));
  }

  const TextBlock& block_;
  std::string name_;
  std::vector<Column> columns_;
  std::vector<std::size_t> repeats_;  // columns of one coefficient of friction
  HeaderMark mark_;
  std::vector<HeaderStatement> common_;  // of all points
  std::vector<HeaderStatement> unused_;
  bool hasTwoLoads_ = false;  // above the table
};

}  // namespace

bool isFrictionTable(const TextTable& table) {
  return isOfFriction(table.largest());
}

FrictionData parseFrictionData(std::string_view bytes, const std::string& name) {
  TextTableOptions options;
  options.keepsTexts = true;
  options.textColumns = {"label", "sample",  "name", "set",  "series",      "specimen",
                         "track", "surface", "run",  "lauf", "wiederholung"};
  TextTable table = readTextTable(bytes, name, options);
  undoLogarithms(table, [](const std::string& quantity) {
    return findMeaning(quantity, kAnyUnit).has_value();
  });
  for (TextBlock& block : table.blocks) prepareColumns(block);
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
  FrictionData data = Reader(table.largest(), table.dialect, name).read();
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
