#include "core/material/prony_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/statistics.h"
#include "core/base/text.h"
#include "core/base/text_clause.h"
#include "core/base/text_number.h"

namespace asperity {
namespace {

/// Names the columns of a list of branches as COMSOL saves it: the number of the branch, its
/// modulus or its energy factor, and its relaxation time, without names and units. Only a user who
/// states a modulus says that a file may be one. Throws InputError where the numbers may be
/// factors.
void nameBranches(TextBlock& block, const std::string& name, const PronyChoices& choices,
                  RawSeries& series) {
  if (block.hasNames() || !choices.statesModulus() || block.columns.size() != 3 ||
      !countsRows(block, 0))
    return;
  if (!std::ranges::all_of(block.values, [](double value) { return std::isfinite(value); })) return;
  const double modulus = std::ranges::max(block.column(1)),
               time = std::ranges::max(block.column(2));
  if (choices.modulusUnit.empty()) refuseSoftModulus(name, block.label(1), modulus);
  // Moduli in Pa are larger numbers than times in s; elsewhere the columns have another order.
  if (time >= modulus * unitSize(choices.modulusUnit, "Pa").value_or(1)) return;
  block.columns = {{"branch", {}, false}, {"G", "Pa", false}, {"tau", "s", false}};
  series.notes.push_back(
      "columns without names are read as branches in a file of COMSOL: number, modulus of shear, "
      "relaxation time in s");
}

/// The columns of one arm of a series whose arms stand side by side.
struct ArmColumns {
  std::size_t modulus = 0, time = 0;
};

/// Returns the arms that stand side by side in columns with numbers in their names, "G1 tau1 G2
/// tau2"; empty where a time has no modulus, or where units differ.
std::vector<ArmColumns> armsSideBySide(const TextBlock& block) {
  const auto isIndexed = [&block](std::size_t i, const std::string& index, const auto& isName) {
    const std::string word = seriesWord(block.columns[i].name);
    const std::size_t digits = word.find_last_not_of("0123456789") + 1;
    return word.substr(digits) == index && isName(word.substr(0, digits));
  };
  std::vector<ArmColumns> arms;
  for (std::size_t time = 0; time < block.columns.size(); ++time) {
    const std::string word = seriesWord(block.columns[time].name);
    const std::string index = word.substr(word.find_last_not_of("0123456789") + 1);
    if (index.empty() || !isIndexed(time, index, isRelaxationTime)) continue;
    std::size_t modulus = 0;
    while (modulus < block.columns.size() && !isIndexed(modulus, index, isArmModulus)) ++modulus;
    if (modulus == block.columns.size()) return {};
    arms.push_back({modulus, time});
    if (block.columns[modulus].unit != block.columns[arms.front().modulus].unit ||
        block.columns[time].unit != block.columns[arms.front().time].unit)
      return {};
  }
  return arms;
}

/// Writes what a column states of the whole series as a line above the table: its equilibrium or
/// instantaneous modulus or its temperature, and all numbers of a single row.
void liftConstants(TextBlock& block) {
  for (std::size_t i = 0; i < block.columns.size(); ++i) {
    const TextColumn& column = block.columns[i];
    const std::string word = seriesWord(column.name);
    const bool isOfAll = block.rows == 1 || isEquilibrium(word) || isInstantaneous(word) ||
                         dmaColumn(column).quantity == DmaQuantity::Temperature;
    if (column.isText || !isOfAll) continue;
    std::vector<double> numbers = block.column(i);
    std::erase_if(numbers, [](double number) { return !std::isfinite(number); });
    if (numbers.empty() || std::ranges::count(numbers, numbers.front()) != std::ssize(numbers))
      continue;
    const std::string value = plain(numbers.front()).text + " " + column.unit;
    block.header.push_back({column.name, value, block.lines.front(), column.name + " = " + value});
  }
}

/// Makes rows of arms that stand side by side. Throws InputError where several rows are several
/// series.
void stackArms(TextBlock& block, const std::string& name) {
  const std::vector<ArmColumns> arms = armsSideBySide(block);
  if (arms.size() < 2) return;
  if (block.rows > 1)
    throw InputError(name, "",
                     message("has {} rows, each of which is a Prony series by the names of its "
                             "columns; keep the one that is meant",
                             block.rows));
  const auto indexed = [](TextColumn column) {
    column.name = std::string(withoutEnd(column.name, "0123456789_ ")) + "_i";
    return column;
  };
  TextBlock made;
  made.header = std::move(block.header);
  made.columns = {indexed(block.columns[arms.front().time]),
                  indexed(block.columns[arms.front().modulus])};
  for (const auto& [modulus, time] : arms)
    made.values.insert(made.values.end(), {block.at(0, time), block.at(0, modulus)});
  made.rows = arms.size();
  made.texts.resize(2);
  made.cells.resize(2);
  made.lines.assign(made.rows, block.lines.front());
  block = std::move(made);
}

/// Undoes the logarithms of a table, as "log10 tau" and "lg(G/MPa)".
void undoSeriesLogarithms(TextTable& table, const TextBlock& block, RawSeries& series) {
  const std::vector<TextColumn> before = block.columns;
  undoLogarithms(table, [](const std::string& quantity) {
    const std::string word = seriesWord(quantity);
    return isRelaxationTime(word) || isArmModulus(quantity) || isArmViscosity(word);
  });
  for (std::size_t i = 0; i < before.size(); ++i) {
    const std::string written = lowerCase(before[i].name);
    if (block.columns[i].name == before[i].name || !written.starts_with("log") ||
        written.starts_with("log10"))
      continue;
    series.notes.push_back(
        message("{} is read as a logarithm to base 10", Message::name(before[i].name)));
  }
}

// ---- Columns ------------------------------------------------------------------------------------

/// The columns of a series; two of them describe an arm.
struct SeriesColumns {
  std::optional<std::size_t> time{}, modulus{}, viscosity{};
};

/// Returns whether the numbers of a column are parts of a modulus by its name or unit.
bool areParts(const TextColumn& column) {
  return column.unit == "%" || partsByName(seriesWord(column.name)) != PartsOf::Unknown;
}

/// Refuses frequencies of arms, of which nobody can tell whether they are 1/tau or 1/(2 pi tau).
[[noreturn]] void refuseFrequencies(const TextColumn& column, const std::string& name) {
  throw InputError(name, column.name,
                   "may be 1/tau or 1/(2 pi tau); write the arms' relaxation times, as tau (s), or "
                   "their rates 1/tau, as omega_i (rad/s)");
}

/// Returns the columns of a series; nothing where the block is none. Throws InputError where it has
/// a part of one.
std::optional<SeriesColumns> seriesColumns(const TextBlock& block, const std::string& name) {
  SeriesColumns found;
  bool hasIndex = false;
  std::optional<std::size_t> frequency;
  for (std::size_t i = 0; i < block.columns.size(); ++i) {
    const TextColumn& column = block.columns[i];
    const std::string word = seriesWord(column.name);
    if (dmaColumn(column).quantity == DmaQuantity::Frequency || word == "fi") {
      frequency = i;
      continue;
    }
    const std::string_view bare =
        std::string_view(column.name).substr(0, column.name.find_first_of("(["));
    if (!found.time && (isRelaxationTime(word) || isRelaxationTime(seriesWord(bare)))) {
      found.time = i;
    } else if (!found.modulus && isArmModulus(column.name)) {
      found.modulus = i;
      hasIndex = hasIndex || hasArmIndex(word);
    } else if (!found.viscosity && isArmViscosity(word)) {
      found.viscosity = i;
      hasIndex = hasIndex || hasArmIndex(word);
    }
  }
  // A sweep has no moduli with an index.
  if (frequency && (found.time || !found.modulus || !hasIndex)) return {};
  if (frequency && isDecayRate(seriesWord(block.columns[*frequency].name))) found.time = frequency;
  if (frequency && !found.time) refuseFrequencies(block.columns[*frequency], name);
  if (found.time && (found.modulus || found.viscosity)) return found;
  // No other table has moduli or viscosities with an index; elsewhere both may be those of a fluid.
  // Parts of a modulus give no time.
  if (found.modulus && found.viscosity && hasIndex && !areParts(block.columns[*found.modulus]))
    return found;
  if (found.time)
    throw InputError(name, block.columns[*found.time].name,
                     "looks like the relaxation times of a Prony series, but there is no column of "
                     "moduli; such a table has columns as tau (s) and G (MPa), or g_i for parts of "
                     "the instantaneous modulus");
  if (found.modulus && hasIndex)
    throw InputError(name, block.columns[*found.modulus].name,
                     "looks like the moduli of a Prony series, but there is no column of "
                     "relaxation times; such a table has columns as tau (s) and G (MPa), or g_i "
                     "for parts of the instantaneous modulus");
  return {};
}

// ---- Units --------------------------------------------------------------------------------------

/// Returns the unit of a column of times or rates. A text in brackets, or after a slash, at the
/// end of its name is a unit, too; empty where there is none, as in "tau (relaxation time)".
std::string writtenUnit(const TextColumn& column) {
  if (!column.unit.empty()) return column.unit;
  const std::string unit = unitText(column.name);
  return beginsWithOneOf(seriesWord(unit), "tau relaxation") ? std::string() : unit;
}

/// Returns the size in s of the unit of a column of relaxation times. Throws InputError where it is
/// not known, and where there is none and a line beside the table names another one than seconds;
/// adds a note where there is none.
double timeSizeOf(const TextColumn& column, const SeriesBlock& in) {
  const std::string unit = writtenUnit(column);
  if (unit.empty()) {
    const auto other = unitOfNoNumber(in, [](const std::string& word) {
      const auto size = word.size() > 1 ? timeSize(word) : std::nullopt;
      return size && *size != 1;
    });
    if (other) throw InputError(in.name, column.name, unitStandsElsewhere(column.name, *other));
    in.series.notes.push_back(
        message("{} has no unit: seconds are assumed", Message::name(column.name)));
    return 1;
  }
  if (const auto size = timeSize(unit)) return *size;
  throw InputError(in.name, column.name,
                   message("has the unit {}, which is not one of {}", shortened(unit),
                           "s, ms, \u00B5s, min, h, days"));
}

/// Returns the size in 1/s of the unit of a column of decay rates. Throws InputError where it is
/// not known: a beta without a unit may be a time, and an omega in Hz a frequency.
double rateSizeOf(const TextColumn& column, const std::string& name) {
  const std::string unit = lowerCase(writtenUnit(column));
  if (isOneOf(unit, "1/s s-1 s^-1 s\u207B\u00B9 rad/s")) return 1;
  if (unit == "hz" && seriesWord(column.name).starts_with("omega")) refuseFrequencies(column, name);
  if (unit == "hz") return 1;
  if (unit.starts_with("1/"))
    if (const auto size = timeSize(unit.substr(2))) return 1 / *size;
  throw InputError(name, column.name,
                   "may be a rate or a time; write its unit, as 1/s, after the name");
}

/// Returns the size in Pa s of the unit of a column of viscosities; without one it is that of the
/// user's modulus times s. Throws InputError where it is not known.
double viscositySizeOf(const TextColumn& column, const SeriesBlock& in) {
  const bool hasUnit = !column.unit.empty() && column.unit != "-";
  if (const auto size =
          hasUnit ? viscosityUnit(column.unit) : unitSize(in.choices.modulusUnit, "Pa"))
    return *size;
  throw InputError(in.name, column.name,
                   hasUnit ? message("has the unit {}, which is not one of {}",
                                     shortened(column.unit), unitNames("Pa s"))
                           : Message("has no unit; write it after the name, as in eta_i (Pa s)"));
}

// ---- Arms ---------------------------------------------------------------------------------------

/// Reads the column of moduli. What has a unit is no part of another modulus; what is in per cent
/// is one.
void readWeights(const SeriesBlock& in, std::size_t column, SeriesRows& rows) {
  rows.column = in.block.columns[column];
  const std::string& unit = rows.column.unit;
  const bool isPercent = unit == "%";
  in.series.isUnitKnown = !unit.empty() && unit != "-" && unit != "1" && !isPercent;
  if (in.series.isUnitKnown) in.series.unit = modulusSize(unit, in.name, rows.column.name);
  rows.weights = in.block.column(column);
  if (!in.series.isUnitKnown) rows.parts = partsByName(seriesWord(rows.column.name));
  if (!isPercent) return;
  for (double& weight : rows.weights) weight *= 0.01;
  if (rows.parts == PartsOf::Unknown) rows.parts = PartsOf::Instantaneous;
}

/// Reads the column of relaxation times, or of their inverse.
void readTimes(const SeriesBlock& in, std::size_t column, SeriesRows& rows) {
  const TextColumn& times = in.block.columns[column];
  const bool isRate = isDecayRate(seriesWord(times.name));
  const double size = isRate ? rateSizeOf(times, in.name) : timeSizeOf(times, in);
  // What does not decay has no relaxation time.
  const auto timeOf = [&](double number) {
    if (!isRate) return number * size;
    return number == 0 ? RawSeries::kNotStated : 1 / (number * size);
  };
  rows.times = in.block.column(column);
  std::ranges::transform(rows.times, rows.times.begin(), timeOf);
}

/// Makes moduli of viscosities and relaxation times.
void divideByTimes(const SeriesBlock& in, std::size_t viscosity, SeriesRows& rows) {
  const TextColumn& column = in.block.columns[viscosity];
  const double size = viscositySizeOf(column, in);
  in.series.unit = unitSize(in.choices.modulusUnit, "Pa").value_or(1);
  in.series.isUnitKnown = true;
  rows.column = {column.name, "Pa", false};
  rows.weights = in.block.column(viscosity);
  for (std::size_t row = 0; row < in.block.rows; ++row) {
    double& weight = rows.weights[row];
    const double time = rows.times[row];
    if (!std::isfinite(weight)) continue;
    if (!std::isfinite(time))
      throw InputError(in.name, fmt::format("line {}", in.block.lines[row]),
                       "has a viscosity and no relaxation time");
    if (time != 0) weight = weight * size / time / in.series.unit;
  }
  in.series.notes.push_back(
      message("moduli are {} divided by the relaxation times", Message::name(column.name)));
}

/// Makes relaxation times of viscosities and moduli.
void divideByModuli(const SeriesBlock& in, std::size_t viscosity, SeriesRows& rows) {
  const TextColumn& column = in.block.columns[viscosity];
  const double size = viscositySizeOf(column, in);
  const auto chosen = unitSize(in.choices.modulusUnit, "Pa");
  if (!chosen && !in.series.isUnitKnown)
    throw InputError(in.name, rows.column.name,
                     message("has no unit, and {} is in {}; say with --modulus-unit which unit "
                             "both have",
                             column.name, column.unit));
  in.series.isUnitKnown = true;
  rows.times = in.block.column(viscosity);
  for (std::size_t row = 0; row < in.block.rows; ++row) {
    const double modulus = rows.weights[row] * chosen.value_or(in.series.unit);
    // An arm without a modulus bears nothing, whatever its time.
    const bool isArm = std::isfinite(modulus) && modulus != 0;
    rows.times[row] = isArm ? rows.times[row] * size / modulus : 1;
  }
  in.series.notes.push_back(
      message("relaxation times are {} divided by the moduli", Message::name(column.name)));
}

/// Notes viscosities that contradict the product of moduli and relaxation times, by more than a
/// tenth in the median.
void noteViscosities(const SeriesBlock& in, std::size_t viscosity, const SeriesRows& rows) {
  const auto size = viscosityUnit(in.block.columns[viscosity].unit);
  if (!size || !in.series.isUnitKnown) return;
  const double unit = unitSize(in.choices.modulusUnit, "Pa").value_or(in.series.unit);
  std::vector<double> ratios;
  for (std::size_t row = 0; row < in.block.rows; ++row) {
    const double product = rows.weights[row] * unit * rows.times[row];
    const double stated = in.block.at(row, viscosity) * *size;
    if (std::isfinite(product) && std::isfinite(stated) && product > 0)
      ratios.push_back(stated / product);
  }
  if (const auto ratio = contradictingRatio(std::move(ratios)))
    in.series.notes.push_back(message(
        "{} contradicts the moduli and relaxation times, which are read: in the median it is {} "
        "times their product",
        Message::name(in.block.label(viscosity)), printed(*ratio, 3)));
}

/// Reads the arms of a table into the series, and the row of the equilibrium modulus.
SeriesRows readRows(const SeriesBlock& in, const SeriesColumns& columns) {
  SeriesRows rows;
  if (columns.modulus) readWeights(in, *columns.modulus, rows);
  if (columns.time) readTimes(in, *columns.time, rows);
  if (!columns.modulus) divideByTimes(in, *columns.viscosity, rows);
  if (!columns.time) divideByModuli(in, *columns.viscosity, rows);
  if (columns.modulus && columns.time && columns.viscosity)
    noteViscosities(in, *columns.viscosity, rows);
  std::size_t leftOut = 0;
  for (std::size_t row = 0; row < in.block.rows; ++row) {
    const double weight = rows.weights[row], time = rows.times[row];
    if (!std::isfinite(weight)) {
      if (std::isfinite(time)) ++leftOut;
    } else if (std::isfinite(time)) {
      in.series.terms.push_back({weight, time, in.block.lines[row]});
      rows.sum += weight;
      rows.most = std::max(rows.most, weight);
    } else if (std::isfinite(rows.equilibrium)) {
      throw InputError(in.name, fmt::format("line {}", in.block.lines[row]),
                       "is a second row without a relaxation time; one, of the equilibrium "
                       "modulus, is allowed");
    } else {
      rows.equilibrium = weight;
    }
  }
  if (in.series.terms.empty()) throw InputError(in.name, "", "holds no relaxation time");
  if (leftOut > 0)
    in.series.notes.push_back(message("rows without a value, left out: {}", leftOut));
  return rows;
}

/// Makes parts of the equilibrium modulus parts of the instantaneous one: G_i / G_0 = (G_i / G_inf)
/// / (1 + sum of all G_i / G_inf).
void referToInstantaneous(RawSeries& series, SeriesRows& rows) {
  if (!(rows.sum > 0)) return;  // is refused below: a part is negative
  const double whole = 1 + rows.sum;
  for (RawSeries::Term& term : series.terms) term.weight /= whole;
  rows.sum /= whole;
  if (std::isfinite(rows.equilibrium)) rows.equilibrium /= whole;
}

/// Decides whether the arms are moduli or parts of one. Parts of the instantaneous modulus have no
/// unit, and their sum is at most 1; with the part of the equilibrium modulus it is 1.
void decideParts(const std::string& name, RawSeries& series, SeriesRows& rows) {
  const bool isNamed = rows.parts != PartsOf::Unknown;
  series.isRelative = isNamed || (!series.isUnitKnown && rows.most < 1 && rows.sum <= 1 + 1e-6);
  if (rows.parts == PartsOf::Equilibrium) referToInstantaneous(series, rows);
  if (!series.isRelative || !std::isfinite(rows.equilibrium)) return;
  if (!isNamed && rows.equilibrium >= 1) return;  // it is the modulus
  const double all = rows.sum + rows.equilibrium;
  constexpr double kSame = 0.02;
  if (std::abs(all - 1) <= kSame) return;
  if (isNamed)
    throw InputError(name, rows.column.name,
                     message("are parts that add up to {:.6g} with that of the row without a "
                             "relaxation time, and not to 1",
                             all));
  series.isRelative = false;
}

}  // namespace

std::optional<SeriesRows> readArms(TextTable& table, TextBlock& block, const std::string& name,
                                   const PronyChoices& choices, RawSeries& series) {
  nameBranches(block, name, choices, series);
  liftConstants(block);
  stackArms(block, name);
  undoSeriesLogarithms(table, block, series);
  const std::optional<SeriesColumns> columns = seriesColumns(block, name);
  if (!columns) return {};
  SeriesRows rows = readRows({{table, block}, name, choices, series}, *columns);
  decideParts(name, series, rows);
  return rows;
}

}  // namespace asperity
