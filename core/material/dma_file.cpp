#include "core/material/dma_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/material/dma_moduli.h"
#include "core/material/dma_samples.h"
#include "core/material/dma_sweeps.h"
#include "core/material/dma_units.h"
#include "core/material/set_temperatures.h"
#include "core/material/table_forms.h"

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

Message shiftIsNotRead() {
  return "the shift that the file states is not read: the isotherms have their own";
}

class DmaReader {
 public:
  DmaReader(const TextTable& table, const std::string& name, const DmaChoices& choices)
      : table_(table), name_(name), choices_(choices) {}

  DmaFile read() {
    std::size_t used = 0;
    std::string unused;
    for (const TextBlock& block : table_.blocks) {
      const bool isRead = readBlock(block);
      used += isRead ? 1 : 0;
      if (!isRead && used > 0 && !block.hasNames())
        appendItem(unused, std::to_string(block.lines.front()));
    }
    if (used == 0) refuseColumns();
    if (!unused.empty())
      addNote(message("tables of numbers that are not used: at line {}",
                      PrintedNumber{shortened(unused)}));
    if (file_.rows.empty()) refuseRows();
    // A column of temperatures that a user names is read as it is.
    if (!file_.facts.temperature.name.empty() && choices_.temperatureColumn.empty())
      if (auto note = groupBySetTemperature(file_.rows, origins_)) addNote(std::move(*note));
    refuseDifferentSamples(file_.rows, origins_, name_);
    return std::move(file_);
  }

 private:
  [[noreturn]] void refuseColumns() const {
    const TextBlock& block = table_.largest();
    for (std::size_t i = 0; i < block.columns.size(); ++i)
      if (block.columns[i].isText && !block.texts[i].empty() &&
          dmaColumn(block.columns[i]).quantity != None)
        throw InputError(name_, block.label(i),
                         message("line {}: '{}' is not a number", block.lines.front(),
                                 shortened(block.texts[i].front())));
    refuseTestOverTime(block);
    refuseOtherKind(block);
    constexpr std::size_t kMax = 12;
    std::string list;
    for (std::size_t i = 0; i < std::min(block.columns.size(), kMax); ++i)
      appendItem(list, shortened(block.label(i)));
    throw InputError(
        name_, "",
        message("has no columns that are known as frequency, storage and loss modulus (or tan "
                "delta, or magnitude and phase) among {}; say which they are with "
                "--frequency-column, --storage-column and --loss-column",
                list));
  }

  /// Refuses a file without a row that has all numbers.
  [[noreturn]] void refuseRows() const {
    const TextBlock& block = table_.largest();
    for (std::size_t i = 0; i < block.columns.size(); ++i)
      if (dmaColumn(block.columns[i]).quantity != None && !block.hasNumber(i))
        throw InputError(name_, block.label(i),
                         "has no number in any row; correct the column, or take it out");
    throw InputError(name_, "", "holds no row with a frequency and both moduli");
  }

  /// Refuses a modulus or a compliance over time, G(t) or J(t), and says what is read.
  void refuseTestOverTime(const TextBlock& block) const {
    bool hasTime = false, hasAnswer = false;
    for (const TextColumn& column : block.columns) {
      const std::string name = compactName(column.name);
      hasTime = hasTime || name == "t" || name.starts_with("time") || name.starts_with("zeit");
      for (const char* answer : {"gt", "et", "jt", "dt"})
        // With its unit, where that is none of a modulus: "J(t) (1/MPa)".
        hasAnswer = hasAnswer || name == answer || name.starts_with(std::string(answer) + "1/");
      for (const char* word : {"relax", "creep", "compliance", "kriech", "nachgiebigkeit"})
        hasAnswer = hasAnswer || name.find(word) != std::string::npos;
    }
    if (hasTime && hasAnswer)
      throw InputError(
          name_, "",
          "holds a test over time: relaxation tests, G(t), and creep tests, J(t), are "
          "not read; what is read are G\u2032 and G\u2033 over frequency at one or several "
          "temperatures, and Prony series");
  }

  /// Refuses moduli of another kind than that which the user wants.
  void refuseOtherKind(const TextBlock& block) const {
    std::string others;
    for (std::size_t i = 0; i < block.columns.size(); ++i) {
      const DmaColumn column = dmaColumn(block.columns[i]);
      if (isModulus(column.quantity) && column.kind != ModulusKind::Unknown &&
          column.kind != choices_.modulus)
        appendItem(others, shortened(block.label(i)));
    }
    if (others.empty() || choices_.modulus == ModulusKind::Unknown) return;
    throw InputError(
        name_, "--modulus",
        choices_.modulus == ModulusKind::Shear
            ? message("the file has moduli of tension (E) by their names: {}; without the option "
                      "they are read as such and divided for shear; where the names are wrong, say "
                      "with --storage-column and --loss-column which are meant",
                      Message::name(others))
            : message("the file has moduli of shear (G) by their names: {}; without the option "
                      "they are read as such; where the names are wrong, say with --storage-column "
                      "and --loss-column which are meant",
                      Message::name(others)));
  }

  bool readBlock(const TextBlock& block) {
    std::string leftOut;
    const DmaBlock in{{table_, block}, name_, choices_};
    const std::vector<SweepColumns> sweeps = findSweeps(in, leftOut);
    if (!sweeps.empty() && file_.facts.leftOutColumns.empty()) file_.facts.leftOutColumns = leftOut;
    for (const SweepColumns& columns : sweeps) {
      DmaFacts& facts = file_.facts;
      const DmaFacts before = facts;
      readSweep(in, columns, sweeps.size() > 1);
      facts.hasOtherColumns =
          facts.hasOtherColumns ||
          (facts.sweeps > 0 && !(facts.frequency == before.frequency &&
                                 facts.storage == before.storage && facts.loss == before.loss));
      ++facts.sweeps;
    }
    return !sweeps.empty();
  }

  void addNote(Message note) {
    std::vector<Message>& notes = file_.facts.notes;
    if (std::ranges::find(notes, note) == notes.end()) notes.push_back(std::move(note));
  }

  /// Returns the numbers of a column of temperatures or frequencies, which may stand in the first
  /// row of each sweep alone.
  std::vector<double> statesOf(const TextBlock& block, std::size_t column, std::size_t modulus) {
    auto filled = filledDown(block, column, modulus);
    if (!filled) return block.column(column);
    addNote(standsInFirstRows(block.label(column)));
    return std::move(*filled);
  }

  /// Reads the rows of one block, or of one temperature in a table of several.
  void readSweep(const DmaBlock& in, const SweepColumns& columns, bool isSideBySide) {
    DmaFacts& facts = file_.facts;
    // Beside f and T, f aT is a shift of isotherms, which have their own.
    const bool hasIsotherms = columns.has(Frequency) && columns.has(Temperature);
    const bool isReduced =
        columns.has(ReducedFrequency) && choices_.frequencyColumn.empty() && !hasIsotherms;
    if (columns.has(ReducedFrequency) && hasIsotherms) addNote(shiftIsNotRead());
    const std::size_t frequencyAt = columns[isReduced ? ReducedFrequency : Frequency];
    facts.isReduced = isReduced;
    const bool hasFrequencies = frequencyAt != SweepColumns::kNone;
    const SizedColumn frequency =
        hasFrequencies ? frequencyColumn(in, frequencyAt)
                       : SizedColumn{{printedQuantity(*columns.frequency, "Hz", 6), {}, false}, 1};
    facts.frequency = frequency.fact;
    // A master curve belongs to one temperature, whatever the temperatures of its points.
    std::optional<double> oneTemperature = columns.temperature;
    Unit scale;
    if (columns.has(Temperature) && !isReduced) {
      const TemperatureColumn temperature = temperatureColumn(in, columns[Temperature]);
      facts.temperature = temperature.fact;
      scale = temperature.unit;
      if (temperature.note) addNote(*temperature.note);
    } else {
      facts.temperature = {};
      facts.stated.reset();
      if (choices_.temperature) oneTemperature = choices_.temperature;
      if (!oneTemperature) oneTemperature = temperatureAbove(in, isReduced);
    }
    ModulusColumns moduli = findModulusColumns(in, columns);
    facts.storage = moduli.storage;
    facts.loss = moduli.loss;
    facts.modulus = moduli.kind;
    for (Message& note : moduli.notes) addNote(std::move(note));
    std::vector<double> temperatures;
    if (!oneTemperature) temperatures = statesOf(in.block, columns[Temperature], moduli.first);
    std::vector<double> frequencies;
    if (hasFrequencies) frequencies = statesOf(in.block, frequencyAt, moduli.first);
    for (std::size_t row = 0; row < in.block.rows; ++row) {
      const double hertz = hasFrequencies ? frequencies[row] * frequency.size : *columns.frequency;
      const double first = in.block.at(row, moduli.first) * moduli.firstSize;
      const double second = in.block.at(row, moduli.second) * moduli.secondSize;
      const double temperature = oneTemperature ? *oneTemperature : scale.toSi(temperatures[row]);
      if (!std::isfinite(hertz) || !std::isfinite(first) || !std::isfinite(second) ||
          !std::isfinite(temperature)) {
        // Some of the sweeps side by side may end before the others.
        const bool isBehindEnd = !std::isfinite(first) && !std::isfinite(second);
        facts.leftOut += isSideBySide && isBehindEnd ? 0 : 1;
        continue;
      }
      const DynamicModulus modulus = modulusOfRow(in, row, moduli, hertz, first, second);
      checkRow(modulus, temperature, in.block.lines[row]);
      file_.rows.push_back({temperature, modulus});
      origins_.push_back({&in.block, row});
      if (columns.has(Strain))
        file_.rows.back().strainAmplitude = strainAt(in, row, columns[Strain]);
    }
  }

  /// Returns the modulus at a frequency (Hz) from both numbers of a row. Throws InputError where
  /// one of them is not above 0, or a magnitude not above its part.
  DynamicModulus modulusOfRow(const DmaBlock& in, std::size_t row, const ModulusColumns& moduli,
                              double hertz, double first, double second) const {
    for (const auto& [column, value] : {std::pair(moduli.first, first), {moduli.second, second}})
      if (!(value > 0)) refuseCell(in, row, column, moduli);
    if (!(hertz > 0)) refuseRow(in.block.lines[row], "the frequency", hertz);
    const DynamicModulus modulus = moduli.at(hertz, first, second);
    const bool isOfMagnitude = moduli.pair->first == Magnitude && isModulus(moduli.pair->second);
    if (isOfMagnitude && !(modulus.storage > 0 && modulus.loss > 0))
      throw InputError(
          name_, fmt::format("line {}", in.block.lines[row]),
          message("{} is not above {}, which is a part of it; leave the row out or correct it",
                  Message::name(shortened(in.block.label(moduli.first))),
                  Message::name(shortened(in.block.label(moduli.second)))));
    return modulus;
  }

  /// Returns the temperature (K) that the lines above a block state. Throws InputError where they
  /// state none.
  double temperatureAbove(const DmaBlock& in, bool isReduced) {
    std::optional<HeaderTemperature>& stated = file_.facts.stated;
    stated = statedTemperature(in, name_, choices_.temperatureUnit, isReduced);
    if (stated) return stated->kelvin;
    if (const auto line = distrustedTemperature(in))
      throw InputError(
          name_, "temperature",
          message("is stated nowhere; say at which the moduli were measured with --temperature, "
                  "such as --temperature 20C (line {} may be about something else: {})",
                  line->line, Message::name(shortened(line->text))));
    if (table_.blocks.size() == 1) stated = temperatureInName(name_);
    if (stated) {
      const auto below = temperatureBelow(table_, name_, choices_.temperatureUnit, isReduced);
      if (below && std::abs(below->kelvin - stated->kelvin) > kIsothermTolerance)
        throw InputError(name_, "temperature",
                         message("is {} by the name of the file and {} in line {}; say with "
                                 "--temperature which is that of the test",
                                 celsius(stated->kelvin), celsius(below->kelvin), below->line));
      return stated->kelvin;
    }
    throw InputError(name_, "temperature",
                     "is stated nowhere; say at which the moduli were measured with "
                     "--temperature, such as --temperature 20C");
  }

  /// Refuses a modulus that is not above 0 as the file writes it.
  void refuseCell(const DmaBlock& in, std::size_t row, std::size_t column,
                  const ModulusColumns& moduli) const {
    const std::string label = in.block.label(column);
    const auto& fact = moduli.storage.name == label ? moduli.storage : moduli.loss;
    const bool isOne = isModulus(column == moduli.first ? moduli.pair->first : moduli.pair->second);
    if (fact.name != label || !isOne) return;
    throw InputError(
        name_, fmt::format("line {}", in.block.lines[row]),
        message("{} is {}, which must be above 0; leave the row out or correct it",
                Message::name(shortened(label)),
                PrintedNumber{printedNumber(in.block.at(row, column), 8) + " " + fact.unit}));
  }

  [[noreturn]] void refuseRow(std::size_t line, const char* what, double value) const {
    throw InputError(name_, fmt::format("line {}", line),
                     message("{} is {:.8g}, which must be above 0; leave the row out or correct it",
                             Message(what), value));
  }

  void checkRow(const DynamicModulus& modulus, double temperature, std::size_t line) const {
    const auto refuse = [&](const char* what, double value) { refuseRow(line, what, value); };
    if (!(modulus.storage > 0)) refuse("the storage modulus", modulus.storage);
    if (!(modulus.loss > 0)) refuse("the loss modulus", modulus.loss);
    if (!(temperature > 0)) refuse("the temperature in K", temperature);
    constexpr double kHottestTest = 2000;  // K
    if (!(temperature >= kColdestTest && temperature <= kHottestTest))
      throw InputError(name_, fmt::format("line {}", line),
                       message("the temperature is {:.6g} K, at which no rubber is measured; "
                               "correct it, or say with --temperature-unit in which unit it is",
                               temperature));
  }

  const TextTable& table_;
  const std::string& name_;
  const DmaChoices& choices_;
  DmaFile file_;
  std::vector<RowOrigin> origins_{};  // of the rows
};

/// Returns whether a table has moduli over a frequency.
bool isSweep(const TextBlock& block) {
  std::size_t moduli = 0;
  bool hasFrequency = false;
  for (const TextColumn& column : block.columns) {
    const DmaQuantity quantity = dmaColumn(column).quantity;
    moduli += isMeasured(quantity) ? 1 : 0;
    hasFrequency = hasFrequency || quantity == Frequency;
  }
  return hasFrequency && moduli >= 2;
}

/// Replaces the periods of an oscillation, "Period (s)", by its frequencies, with a note, in tables
/// without frequencies.
void invertPeriods(TextTable& table, std::vector<Message>& notes) {
  for (TextBlock& block : table.blocks) {
    const auto isPeriod = [](const TextColumn& column) {
      return isOneOf(compactName(column.name),
                     "period periode periodo oscillationperiod periodendauer schwingungsdauer") &&
             unitSize(column.unit, "s");
    };
    const auto period = std::ranges::find_if(block.columns, isPeriod);
    if (period == block.columns.end() ||
        std::ranges::any_of(block.columns, [&](const TextColumn& column) {
          const DmaQuantity quantity = dmaColumn(column).quantity;
          return quantity == Frequency || quantity == ReducedFrequency;
        }))
      continue;
    const double size = *unitSize(period->unit, "s");
    notes.push_back(message("{} is a period of the oscillation: the frequency is 1 over it",
                            Message::name(shortened(period->name))));
    *period = {"frequency", "Hz"};
    const auto index = static_cast<std::size_t>(period - block.columns.begin());
    for (std::size_t row = 0; row < block.rows; ++row) {
      double& value = block.at(row, index);
      value = 1 / (value * size);
    }
  }
}

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
    file.facts.notes.push_back(shiftIsNotRead());
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
    lines.push_back(
        facts.stated->line == 0
            ? message("temperature: {} (name of the file)", celsius(facts.stated->kelvin))
            : message("temperature: {} (line {}: {})", celsius(facts.stated->kelvin),
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
  std::vector<Message> ofCells = repeatNames(table, isSweep, temperatureNamed);
  moveLinesAbove(table, name);
  joinMatrices(table, ofCells);
  transposeRows(table, isSweep, ofCells);
  separateCells(table, name, ofCells);
  undoLogarithms(
      table, [](const std::string& quantity) { return dmaColumn(quantity, {}).quantity != None; });
  if (choices.frequencyColumn.empty()) invertPeriods(table, ofCells);
  DmaFile file = DmaReader(table, name, choices).read();
  readShift(table, name, choices, file);
  std::ranges::move(doubtsAbout(table), std::back_inserter(file.facts.notes));
  std::ranges::move(ofCells, std::back_inserter(file.facts.notes));
  file.facts.isMarkUnclear = table.dialect.isUnclear;
  file.facts.decimal = table.dialect.decimal;
  // A loss factor has no unit; then the other column is the modulus.
  const DmaColumnFact& modulus =
      file.facts.storage.unit.empty() ? file.facts.loss : file.facts.storage;
  const auto [least, most] = std::ranges::minmax(
      file.rows, {}, [](const MeasuredModulus& row) { return row.modulus.storage; });
  if (modulus.isUnitAssumed) refuseSoftModulus(name, modulus.name, most.modulus.storage);
  if (auto note = unusualModulus(least.modulus.storage, most.modulus.storage))
    file.facts.notes.push_back(std::move(*note));
  return file;
}

}  // namespace asperity
