#include "core/material/dma_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/statistics.h"
#include "core/base/text.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/base/units.h"
#include "core/material/dma_sweeps.h"
#include "core/material/stated_temperature.h"

namespace asperity {
namespace {

using enum DmaQuantity;

/// Returns "G' in MPa", "G' in MPa (assumed)" or "tan delta".
Message describeColumn(const DmaColumnFact& fact) {
  const Message name = Message::name(fact.name);
  if (fact.unit.empty()) return name;
  return fact.isUnitAssumed ? message("{} in {} (assumed)", name, fact.unit)
                            : message("{} in {}", name, fact.unit);
}

bool isPositive(double value) {
  return std::isfinite(value) && value > 0;
}

/// Returns the note on a table that also has moduli of the kind that is not read, with their ratio.
/// storage: the column that is read, which is of this kind; poisson: Poisson's ratio.
std::optional<Message> otherKindNote(const TextBlock& block, std::size_t storage, ModulusKind kind,
                                     double poisson) {
  const TextColumn& read = block.columns[storage];
  const bool isShear = kind == ModulusKind::Shear;
  for (std::size_t i = 0; i < block.columns.size(); ++i) {
    const TextColumn& other = block.columns[i];
    const DmaColumn meaning = dmaColumn(other.name, other.unit);
    if (other.isText || meaning.quantity != DmaQuantity::Storage ||
        meaning.kind == ModulusKind::Unknown || meaning.kind == kind)
      continue;
    const double size =
        unitSize(other.unit, "Pa").value_or(1) / unitSize(read.unit, "Pa").value_or(1);
    std::vector<double> ratios;
    for (std::size_t row = 0; row < block.rows; ++row) {
      const double one = block.at(row, i) * size, used = block.at(row, storage);
      if (isPositive(one) && isPositive(used)) ratios.push_back(isShear ? one / used : used / one);
    }
    if (ratios.empty()) return {};
    const PrintedNumber ratio{printedNumber(upperMedian(std::move(ratios)), 3)};
    const PrintedNumber expected{printedNumber(2 * (1 + poisson), 3)};
    return isShear ? message(
                         "the table also has moduli of tension, {} times those of shear in the "
                         "median ({} with this Poisson's ratio); those of shear are read, and "
                         "--modulus tension reads the others",
                         ratio, expected)
                   : message(
                         "the table also has moduli of shear; those of tension are {} times as "
                         "large in the median ({} with this Poisson's ratio) and are read, and "
                         "--modulus shear reads the others",
                         ratio, expected);
  }
  return {};
}

/// Two columns with their units, and how storage and loss modulus follow from them.
struct ModulusPair {
  std::size_t first, second;
  double firstSize, secondSize;
  DynamicModulus (*combine)(double first, double second);
};

/// Returns the note on a loss factor that contradicts both moduli, by more than a tenth in the
/// median. tangentSize: of the unit of its column.
std::optional<Message> lossFactorNote(const TextBlock& block, const ModulusPair& moduli,
                                      std::size_t tangent, double tangentSize) {
  std::vector<double> ratios;
  for (std::size_t row = 0; row < block.rows; ++row) {
    const double storage = block.at(row, moduli.first) * moduli.firstSize;
    const double loss = block.at(row, moduli.second) * moduli.secondSize;
    const double factor = block.at(row, tangent) * tangentSize;
    if (isPositive(storage) && isPositive(loss) && isPositive(factor))
      ratios.push_back(factor * storage / loss);
  }
  constexpr double kSame = 0.1;
  if (ratios.empty()) return {};
  const double ratio = upperMedian(std::move(ratios));
  if (std::abs(ratio - 1) <= kSame) return {};
  return message(
      "{} contradicts the moduli: in the median it is {} times the ratio of {} and {}; the moduli "
      "are read",
      Message::name(block.label(tangent)), PrintedNumber{printedNumber(ratio, 3)},
      Message::name(block.label(moduli.second)), Message::name(block.label(moduli.first)));
}

/// The place of a row.
struct Origin {
  const TextBlock* block;
  std::size_t row;

  std::uint32_t line() const { return block->lines[row]; }
  /// Returns the text or the number in a column.
  std::string field(std::size_t column) const {
    if (block->columns[column].isText) return block->texts[column][row];
    return plain(block->at(row, column)).text;
  }
};

/// Two rows at the same temperature, frequency and strain.
struct RepeatedRows {
  std::size_t first, second;
};

std::vector<RepeatedRows> repeatedRows(const std::vector<MeasuredModulus>& rows) {
  constexpr double kSameFrequency = 1e-4, kSameStrain = 1.2;
  std::vector<std::size_t> order(rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return rows[i].temperature; });
  std::vector<RepeatedRows> repeats;
  for (auto begin = order.begin(), end = begin; begin != order.end(); begin = end) {
    // The rows of one isotherm.
    for (++end; end != order.end() &&
                rows[*end].temperature - rows[*(end - 1)].temperature <= kIsothermTolerance;)
      ++end;
    std::stable_sort(begin, end, [&](std::size_t i, std::size_t j) {
      return rows[i].modulus.frequency < rows[j].modulus.frequency;
    });
    for (auto first = begin, next = first; first != end; first = next) {
      const double most = rows[*first].modulus.frequency * (1 + kSameFrequency);
      for (++next; next != end && rows[*next].modulus.frequency <= most; ++next) {
        const double own = rows[*first].strainAmplitude, other = rows[*next].strainAmplitude;
        const bool isOtherStrain = std::isfinite(own) && std::isfinite(other) &&
                                   std::abs(std::log(own / other)) > std::log(kSameStrain);
        const bool isApart =
            std::abs(rows[*first].temperature - rows[*next].temperature) > kIsothermTolerance ||
            isOtherStrain;
        if (!isApart) repeats.push_back({std::min(*first, *next), std::max(*first, *next)});
      }
    }
  }
  return repeats;
}

class Reader {
 public:
  Reader(const TextTable& table, const std::string& name, const DmaChoices& choices)
      : table_(table), name_(name), choices_(choices) {}

  DmaFile read() {
    std::size_t used = 0;
    for (const TextBlock& block : table_.blocks) used += readBlock(block) ? 1 : 0;
    if (used == 0) refuseColumns();
    if (file_.rows.empty())
      throw InputError(name_, "", "holds no row with a frequency and both moduli");
    refuseDifferentSamples();
    return std::move(file_);
  }

 private:
  [[noreturn]] void refuseColumns() const {
    const TextBlock& block = table_.largest();
    for (std::size_t i = 0; i < block.columns.size(); ++i)
      if (block.columns[i].isText && !block.texts[i].empty() &&
          dmaColumn(block.columns[i].name, block.columns[i].unit).quantity != None)
        throw InputError(name_, block.label(i),
                         message("line {}: '{}' is no number", block.lines.front(),
                                 shortened(block.texts[i].front())));
    constexpr std::size_t kMost = 12;
    std::string list;
    for (std::size_t i = 0; i < std::min(block.columns.size(), kMost); ++i)
      list += (i > 0 ? ", " : "") + shortened(block.label(i));
    throw InputError(
        name_, "",
        message("has no columns that are known as frequency, storage and loss modulus (or tan "
                "delta, or magnitude and phase) among {}; say which they are with "
                "--frequency-column, --storage-column and --loss-column",
                list));
  }

  /// Throws InputError where rows of equal temperature, frequency and strain differ clearly: they
  /// are of several samples or runs, of which a mean would be no rubber. Repeated runs of one
  /// sample scatter by 10 to 15 %, and the median of many ratios by less.
  void refuseDifferentSamples() const {
    constexpr double kSameSample = 1.2;
    const std::vector<RepeatedRows> repeats = repeatedRows(file_.rows);
    if (repeats.empty()) return;
    std::vector<double> storage, loss;
    for (const RepeatedRows& pair : repeats) {
      const DynamicModulus &one = file_.rows[pair.first].modulus,
                           &other = file_.rows[pair.second].modulus;
      storage.push_back(std::exp(std::abs(std::log(one.storage / other.storage))));
      loss.push_back(std::exp(std::abs(std::log(one.loss / other.loss))));
    }
    const double ratio = std::max(upperMedian(std::move(storage)), upperMedian(std::move(loss)));
    if (ratio <= kSameSample) return;
    const Origin &first = origins_[repeats.front().first],
                 &second = origins_[repeats.front().second];
    const PrintedNumber factor{printedNumber(ratio, 3)};
    std::string unused;
    for (std::size_t i = 0; i < first.block->columns.size(); ++i) {
      const TextColumn& column = first.block->columns[i];
      if (!column.isText && dmaColumn(column.name, column.unit).quantity != None) continue;
      unused += (unused.empty() ? "" : ", ") + shortened(first.block->label(i));
      if (distinguishes(i, repeats))
        throw InputError(
            name_, first.block->label(i),
            message("tells samples or runs apart, {} in line {} and {} in line {}, whose moduli at "
                    "the same temperature and frequency differ by a factor of {} in the median; "
                    "keep the rows of one of them",
                    Message::name(shortened(first.field(i))), first.line(),
                    Message::name(shortened(second.field(i))), second.line(), factor));
    }
    throw InputError(
        name_, "",
        message(
            "states other moduli at the same temperature and frequency, as in lines {} and {}, "
            "by a factor of {} in the median, and runs of one sample differ by at most {}; keep "
            "the rows of one sample and run (columns that are not read: {})",
            first.line(), second.line(), factor, kSameSample,
            Message::name(unused.empty() ? "-" : unused)));
  }

  /// Returns whether a column has other values in the rows of each pair, and each value in several
  /// rows, as a label has and a time has not.
  bool distinguishes(std::size_t column, const std::vector<RepeatedRows>& repeats) const {
    std::map<std::string, std::size_t> rows;
    for (const Origin& origin : origins_) {
      if (column >= origin.block->columns.size()) return false;
      ++rows[origin.field(column)];
    }
    return rows.size() * 2 <= origins_.size() &&
           std::ranges::all_of(repeats, [&](const RepeatedRows& pair) {
             return origins_[pair.first].field(column) != origins_[pair.second].field(column);
           });
  }

  bool readBlock(const TextBlock& block) {
    std::string leftOut;
    const std::vector<SweepColumns> sweeps = findSweeps(block, name_, choices_, leftOut);
    if (!sweeps.empty() && file_.facts.leftOutColumns.empty()) file_.facts.leftOutColumns = leftOut;
    for (const SweepColumns& columns : sweeps) {
      DmaFacts& facts = file_.facts;
      const DmaFacts before = facts;
      readSweep(block, columns, sweeps.size() > 1);
      facts.hasOtherColumns =
          facts.hasOtherColumns ||
          (facts.sweeps > 0 && !(facts.frequency == before.frequency &&
                                 facts.storage == before.storage && facts.loss == before.loss));
      ++facts.sweeps;
    }
    return !sweeps.empty();
  }

  void addNote(std::optional<Message> note) {
    std::vector<Message>& notes = file_.facts.notes;
    if (note && std::ranges::find(notes, *note) == notes.end()) notes.push_back(std::move(*note));
  }

  /// Notes columns that contradict those that are read.
  void noteContradictions(const TextBlock& block, const SweepColumns& columns,
                          const ModulusPair& pair) {
    if (!columns.has(Storage)) return;
    addNote(otherKindNote(block, columns[Storage], file_.facts.modulus, choices_.poissonRatio));
    if (!columns.has(Loss) || !columns.has(LossTangent)) return;
    if (const auto size = tangentSize(columnFact(block, columns[LossTangent], {}).unit))
      addNote(lossFactorNote(block, pair, columns[LossTangent], *size));
  }

  /// Returns name and unit of a column; the user's choice of a unit overrides that of the file.
  DmaColumnFact columnFact(const TextBlock& block, std::size_t column,
                           const std::string& choice) const {
    DmaColumnFact fact;
    fact.name = block.label(column);
    fact.unit = choice.empty() ? block.columns[column].unit : choice;
    // The brackets of "G' [20 °C]" contain a temperature and no unit.
    if (choice.empty() && findTemperature(fact.unit)) fact.unit.clear();
    if (fact.unit.empty()) fact.unit = unknownUnitIn(block.columns[column].name);
    fact.isUnitAssumed = fact.unit.empty();
    return fact;
  }

  /// Returns the text in brackets, or behind a stroke, at the end of a name that is neither a
  /// quantity nor a word for the kind of modulus: "furlongs" of "G' (furlongs)". It is refused as a
  /// unit.
  static std::string unknownUnitIn(const std::string& name) {
    const std::size_t begin = unitPart(name);
    if (begin == std::string::npos) return {};
    std::string unit(withoutBrackets(std::string_view(name).substr(begin)));
    if (unit.starts_with('/')) unit = trimmedBlanks(unit.substr(1));
    const DmaColumn meaning = dmaColumn(unit, {});
    const bool isNone = unit.empty() || meaning.quantity != None || meaning.temperature ||
                        meaning.kind != ModulusKind::Unknown;
    constexpr WordList kOtherWords(
        "real imaginary imag in-phase out-of-phase elastic viscous dynamic mean average measured "
        "corrected smoothed abs complex at shifted reference linear absolute");
    return isNone || isOneOf(lowerCase(unit), kOtherWords) ? std::string() : unit;
  }

  [[noreturn]] void refuseUnit(const DmaColumnFact& fact, const std::string& allowed,
                               const char* option) const {
    throw InputError(name_, fact.name,
                     message("has the unit {}, which is not one of {}; {} says which is meant",
                             shortened(fact.unit), allowed, option));
  }

  double modulusUnit(const TextBlock& block, std::size_t column, DmaColumnFact& fact) const {
    fact = columnFact(block, column, choices_.modulusUnit);
    if (fact.unit.empty()) fact.unit = "Pa";
    const auto unit = unitSize(fact.unit, "Pa");
    if (!unit) refuseUnit(fact, unitNames("Pa"), "--modulus-unit");
    return *unit;
  }

  static std::optional<double> tangentSize(const std::string& unit) {
    if (unit.empty() || unit == "1" || unit == "-") return 1;
    return unitSize(unit == "percent" ? "%" : unit, "");
  }

  /// Returns the factor of the unit of a loss factor: 0.01 for per cent.
  double tangentUnit(const TextBlock& block, std::size_t column) const {
    const DmaColumnFact fact = columnFact(block, column, {});
    if (const auto unit = tangentSize(fact.unit)) return *unit;
    throw InputError(
        name_, fact.name,
        message("has the unit {}; a loss factor has none, or %", shortened(fact.unit)));
  }

  /// Returns the kind of moduli of the geometry that the lines above a block state: "Geometry:
  /// Tension: Film", "Geometry: Parallel plate". Unknown where they state none, or both.
  ModulusKind kindOfGeometry(const TextBlock& block) {
    for (const TextBlock* current = &block;; --current) {
      for (const TextEntry& entry : current->header) {
        const std::string line = lowerCase(lineOf(entry));
        if (!containsOneOf(line, "geometr g\u00E9om\u00E9tr clamp fixture")) continue;
        const bool isShear = containsOneOf(line, "shear schub torsion parallel cone sandwich");
        const bool isTension =
            containsOneOf(line, "tension tensile zug compress bend biege cantilever film");
        if (isShear == isTension) continue;
        addNote(message("line {} states the geometry: {}", entry.line,
                        Message::name(shortened(lineOf(entry)))));
        return isShear ? ModulusKind::Shear : ModulusKind::Tension;
      }
      if (current == &table_.blocks.front()) return ModulusKind::Unknown;
    }
  }

  /// Returns the factor that turns the moduli into shear moduli.
  double shearFactor(const TextBlock& block, std::initializer_list<std::size_t> columns) {
    ModulusKind kind = ModulusKind::Unknown;
    for (const std::size_t column : columns) {
      const ModulusKind next =
          dmaColumn(block.columns[column].name, block.columns[column].unit).kind;
      if (next == ModulusKind::Unknown) continue;
      if (kind != ModulusKind::Unknown && kind != next)
        throw InputError(name_, block.label(column),
                         "is of another kind than the other modulus: one is of shear (G), one of "
                         "tension (E); say with --storage-column and --loss-column which belong "
                         "together");
      kind = next;
    }
    if (kind == ModulusKind::Unknown) kind = kindOfGeometry(block);
    if (choices_.modulus != ModulusKind::Unknown) kind = choices_.modulus;
    if (kind == ModulusKind::Unknown)
      throw InputError(name_, block.label(*columns.begin()),
                       "may be of shear (G) or of tension (E); say which with --modulus shear or "
                       "--modulus tension");
    file_.facts.modulus = kind;
    return kind == ModulusKind::Tension ? shearFromYoungs(1, choices_.poissonRatio) : 1;
  }

  /// Decides about temperatures without a unit: numbers above 200 are kelvins, as no rubber is
  /// hotter in °C.
  Unit temperatureScale(const TextBlock& block, std::size_t column) {
    DmaColumnFact& fact = file_.facts.temperature;
    fact = columnFact(block, column, choices_.temperatureUnit);
    if (!fact.unit.empty()) {
      const auto unit = temperatureUnit(fact.unit);
      if (!unit) refuseUnit(fact, unitNames("K"), "--temperature-unit");
      return *unit;
    }
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (const double value : block.column(column))
      if (std::isfinite(value))
        lowest = std::min(lowest, value), highest = std::max(highest, value);
    if (lowest < 200 && highest > 250)
      throw InputError(
          name_, fact.name,
          message("runs from {} to {} without a unit: kelvins and degrees Celsius seem "
                  "to be mixed; say which with --temperature-unit, or correct the "
                  "column",
                  lowest, highest));
    fact.unit = lowest >= 200 ? "K" : "\u00B0C";
    return *temperatureUnit(fact.unit);
  }

  /// Reads the rows of one block, or of one temperature in a table of several.
  void readSweep(const TextBlock& block, const SweepColumns& columns, bool isSideBySide) {
    const bool isReduced = columns.has(ReducedFrequency) && choices_.frequencyColumn.empty();
    const std::size_t frequencyAt = columns[isReduced ? ReducedFrequency : Frequency];
    file_.facts.isReduced = isReduced;
    DmaColumnFact& frequency = file_.facts.frequency;
    frequency = columnFact(block, frequencyAt, choices_.frequencyUnit);
    const bool isAngular =
        dmaColumn(block.columns[frequencyAt].name, block.columns[frequencyAt].unit).isAngular;
    const auto frequencySize = frequencyUnit(frequency.unit, isAngular);
    if (!frequencySize) refuseUnit(frequency, "rad/s, " + unitNames("Hz"), "--frequency-unit");
    if (frequency.unit.empty()) frequency.unit = isAngular ? "rad/s" : "Hz";

    // A master curve belongs to one temperature, whatever the temperatures of its points.
    std::optional<double> oneTemperature = columns.temperature;
    const bool hasColumn = columns.has(Temperature) && !isReduced;
    Unit scale;
    if (hasColumn) {
      scale = temperatureScale(block, columns[Temperature]);
    } else {
      if (choices_.temperature) oneTemperature = choices_.temperature;
      file_.facts.stated.reset();
      if (!oneTemperature)
        if (auto stated =
                statedTemperature(table_, block, name_, choices_.temperatureUnit, isReduced)) {
          oneTemperature = stated->kelvin;
          file_.facts.stated = std::move(stated);
        }
      if (const auto line = distrustedTemperature(table_, block); !oneTemperature && line)
        throw InputError(
            name_, "temperature",
            message("is stated nowhere; say at which the moduli were measured with --temperature, "
                    "such as --temperature 20C (line {} may be about something else: {})",
                    line->line, Message::name(shortened(line->text))));
      if (!oneTemperature)
        throw InputError(name_, "temperature",
                         "is stated nowhere; say at which the moduli were measured with "
                         "--temperature, such as --temperature 20C");
      file_.facts.temperature = {};
    }
    readRows(block, columns, isSideBySide, frequencyAt, *frequencySize, oneTemperature, scale);
  }

  ModulusPair modulusPair(const TextBlock& block, const SweepColumns& columns) {
    DmaFacts& facts = file_.facts;
    const auto at = [&](DmaQuantity quantity) { return columns[quantity]; };
    if (columns.has(Storage) && columns.has(Loss)) {
      double first = modulusUnit(block, at(Storage), facts.storage);
      double second = modulusUnit(block, at(Loss), facts.loss);
      // Where only one column has a unit, it is unclear whether it is that of both.
      if (facts.storage.isUnitAssumed != facts.loss.isUnitAssumed)
        throw InputError(
            name_, facts.storage.isUnitAssumed ? facts.storage.name : facts.loss.name,
            message("has no unit, and {} is in {}; say with --modulus-unit which unit both have",
                    facts.storage.isUnitAssumed ? facts.loss.name : facts.storage.name,
                    facts.storage.isUnitAssumed ? facts.loss.unit : facts.storage.unit));
      const double factor = shearFactor(block, {at(Storage), at(Loss)});
      return {at(Storage), at(Loss), first * factor, second * factor,
              [](double storage, double loss) {
                return DynamicModulus{0, storage, loss};
              }};
    }
    facts.loss = {};
    if (columns.has(Storage)) {
      const double size = modulusUnit(block, at(Storage), facts.storage);
      facts.loss.name = block.label(at(LossTangent));
      return {at(Storage), at(LossTangent), size * shearFactor(block, {at(Storage)}),
              tangentUnit(block, at(LossTangent)), [](double storage, double tangent) {
                return DynamicModulus{0, storage, storage * tangent};
              }};
    }
    if (columns.has(Loss)) {
      const double size = modulusUnit(block, at(Loss), facts.loss);
      facts.storage.name = block.label(at(LossTangent));
      return {at(Loss), at(LossTangent), size * shearFactor(block, {at(Loss)}),
              tangentUnit(block, at(LossTangent)), [](double loss, double tangent) {
                return DynamicModulus{0, loss / tangent, loss};
              }};
    }
    const double size = modulusUnit(block, at(Magnitude), facts.storage);
    const double factor = shearFactor(block, {at(Magnitude)});
    const bool hasPhase = columns.has(Phase);
    facts.loss.name = block.label(at(hasPhase ? Phase : LossTangent));
    if (!hasPhase)
      return {at(Magnitude), at(LossTangent), size * factor, tangentUnit(block, at(LossTangent)),
              [](double magnitude, double tan) {
                const double storage = magnitude / std::hypot(1, tan);
                return DynamicModulus{0, storage, storage * tan};
              }};
    return {at(Magnitude), at(Phase), size * factor, phaseUnit(block, at(Phase), facts.loss),
            [](double magnitude, double phase) {
              return DynamicModulus{0, magnitude * std::cos(phase), magnitude * std::sin(phase)};
            }};
  }

  /// Decides about angles without a unit: they are degrees where they exceed a right angle in
  /// radians.
  double phaseUnit(const TextBlock& block, std::size_t column, DmaColumnFact& fact) const {
    fact = columnFact(block, column, {});
    if (const auto size = angleUnit(block.columns[column].unit)) return *size;
    if (!fact.unit.empty())
      throw InputError(name_, fact.name,
                       message("has the unit {}; an angle is in rad or deg", shortened(fact.unit)));
    double largest = 0;
    for (const double value : block.column(column))
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    fact.unit = largest > std::numbers::pi / 2 ? "deg" : "rad";
    return largest > std::numbers::pi / 2 ? std::numbers::pi / 180 : 1;
  }

  void readRows(const TextBlock& block, const SweepColumns& columns, bool isSideBySide,
                std::size_t frequencyAt, double frequencySize,
                const std::optional<double>& oneTemperature, const Unit& scale) {
    const ModulusPair pair = modulusPair(block, columns);
    noteContradictions(block, columns, pair);
    for (std::size_t row = 0; row < block.rows; ++row) {
      const double frequency = block.at(row, frequencyAt) * frequencySize;
      const double first = block.at(row, pair.first) * pair.firstSize;
      const double second = block.at(row, pair.second) * pair.secondSize;
      const double temperature =
          oneTemperature ? *oneTemperature : scale.toSi(block.at(row, columns[Temperature]));
      if (!std::isfinite(frequency) || !std::isfinite(first) || !std::isfinite(second) ||
          !std::isfinite(temperature)) {
        // Some of the sweeps side by side may end before the others.
        const bool isBehindEnd = !std::isfinite(first) && !std::isfinite(second);
        file_.facts.leftOut += isSideBySide && isBehindEnd ? 0 : 1;
        continue;
      }
      DynamicModulus modulus = pair.combine(first, second);
      modulus.frequency = frequency;
      checkRow(modulus, temperature, block.lines[row]);
      file_.rows.push_back({temperature, modulus});
      origins_.push_back({&block, row});
      if (columns.has(Strain))
        file_.rows.back().strainAmplitude = strainOf(block, row, columns[Strain]);
    }
  }

  void checkRow(const DynamicModulus& modulus, double temperature, std::size_t line) const {
    const auto refuse = [&](const char* what, double value) {
      throw InputError(
          name_, fmt::format("line {}", line),
          message("{} is {:.8g}, which must be above 0; leave the row out or correct it",
                  Message(what), value));
    };
    if (!(modulus.frequency > 0)) refuse("the frequency", modulus.frequency);
    if (!(modulus.storage > 0)) refuse("the storage modulus", modulus.storage);
    if (!(modulus.loss > 0)) refuse("the loss modulus", modulus.loss);
    if (!(temperature > 0 && temperature <= 2000)) refuse("the temperature in K", temperature);
    if (temperature < kColdestTest)
      throw InputError(name_, fmt::format("line {}", line),
                       message("the temperature is {:.6g} K, at which no rubber is measured; "
                               "correct it, or say with --temperature-unit in which unit it is",
                               temperature));
  }

  /// Returns the strain of a row; NaN where it states none.
  double strainOf(const TextBlock& block, std::size_t row, std::size_t column) const {
    const double value = block.at(row, column);
    if (!std::isfinite(value) || value <= 0) return std::numeric_limits<double>::quiet_NaN();
    const TextColumn& strain = block.columns[column];
    const bool isPercent = strain.unit.empty() && lowerCase(strain.name).ends_with("pct");
    const auto unit = strainUnit(isPercent ? "%" : strain.unit);
    if (!unit)
      throw InputError(name_, "--strain-column",
                       message("the unit '{}' is no unit of strain; known are %, ppm, mm/mm",
                               shortened(strain.unit)));
    return value * *unit;
  }

  const TextTable& table_;
  const std::string& name_;
  const DmaChoices& choices_;
  DmaFile file_;
  std::vector<Origin> origins_{};  // of the rows
};

/// Reads the shift beside moduli at one temperature; isotherms have their own.
void readShift(const TextTable& table, const std::string& name, const DmaChoices& choices,
               DmaFile& file) {
  const double temperature = file.rows.front().temperature;
  const bool isOne = std::ranges::all_of(file.rows, [temperature](const MeasuredModulus& row) {
    return std::abs(row.temperature - temperature) <= kIsothermTolerance;
  });
  if (isOne) {
    StatedShift stated = statedShift(table, temperature, name, choices.temperatureUnit);
    file.shift = std::move(stated.shift);
    std::ranges::move(stated.notes, std::back_inserter(file.facts.notes));
  } else if (statesShift(table)) {
    file.facts.notes.push_back(
        "the shift that the file states is not read: the isotherms have their own");
  }
}

}  // namespace

std::vector<Message> factsOf(const DmaFacts& facts) {
  std::vector<Message> lines;
  const Message frequency = describeColumn(facts.frequency);
  lines.push_back(facts.isReduced ? message("reduced frequency: {}", frequency)
                                  : message("frequency: {}", frequency));
  if (!facts.temperature.name.empty())
    lines.push_back(message("temperature: {}", describeColumn(facts.temperature)));
  else if (facts.stated && facts.sweeps == 1)
    lines.push_back(message("temperature: {} (line {}: {})", celsius(facts.stated->kelvin),
                            facts.stated->line, Message::name(shortened(facts.stated->text))));
  const Message storage = describeColumn(facts.storage), loss = describeColumn(facts.loss);
  lines.push_back(facts.modulus == ModulusKind::Tension
                      ? message("moduli of tension: {}, {}", storage, loss)
                      : message("moduli of shear: {}, {}", storage, loss));
  if (facts.hasOtherColumns)
    lines.push_back(message("these are the columns of the last of {} sweeps", facts.sweeps));
  lines.insert(lines.end(), facts.notes.begin(), facts.notes.end());
  return lines;
}

DmaFile readDmaFile(TextTable table, const std::string& name, const DmaChoices& choices) {
  undoLogarithms(
      table, [](const std::string& quantity) { return dmaColumn(quantity, {}).quantity != None; });
  DmaFile file = Reader(table, name, choices).read();
  readShift(table, name, choices, file);
  file.facts.isMarkUnclear = table.dialect.isUnclear;
  file.facts.decimal = table.dialect.decimal;
  if (file.facts.storage.isUnitAssumed && choices.modulusUnit.empty()) {
    double largest = 0;
    for (const MeasuredModulus& row : file.rows) largest = std::max(largest, row.modulus.storage);
    refuseSoftModulus(name, file.facts.storage.name, largest);
  }
  return file;
}

}  // namespace asperity
