#include "core/material/dma_sweeps.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_clause.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/material/dma_moduli.h"
#include "core/material/text_quantities.h"

namespace asperity {
namespace {

using enum DmaQuantity;

/// Returns whether a column of moduli is, or may be, of the kind that the user wants.
bool isOfKind(const DmaColumn& column, ModulusKind wanted) {
  return wanted == ModulusKind::Unknown || column.kind == ModulusKind::Unknown ||
         column.kind == wanted;
}

/// Chooses the shear moduli where a table has both kinds, unless the user wants the others.
ModulusKind kindToRead(const std::vector<DmaColumn>& found, const DmaChoices& choices) {
  if (choices.modulus != ModulusKind::Unknown) return choices.modulus;
  const auto hasBoth = [&](ModulusKind kind) {
    const auto has = [&](DmaQuantity quantity) {
      return std::ranges::any_of(found, [&](const DmaColumn& column) {
        return column.quantity == quantity && column.kind == kind;
      });
    };
    return (has(Storage) && has(Loss)) || has(Magnitude);
  };
  if (hasBoth(ModulusKind::Shear) && hasBoth(ModulusKind::Tension)) return ModulusKind::Shear;
  return ModulusKind::Unknown;
}

/// The column that a user may choose for a quantity, and the option for it.
struct ChosenColumn {
  DmaQuantity quantity;
  std::string DmaChoices::*choice;
  const char* option;
};
constexpr ChosenColumn kChosenColumns[] = {
    {Frequency, &DmaChoices::frequencyColumn, "--frequency-column"},
    {Temperature, &DmaChoices::temperatureColumn, "--temperature-column"},
    {Storage, &DmaChoices::storageColumn, "--storage-column"},
    {Loss, &DmaChoices::lossColumn, "--loss-column"},
    {LossTangent, &DmaChoices::lossTangentColumn, "--tan-delta-column"},
    {Magnitude, &DmaChoices::magnitudeColumn, "--magnitude-column"},
    {Phase, &DmaChoices::phaseColumn, "--phase-column"},
    {Strain, &DmaChoices::strainColumn, "--strain-column"}};

const ChosenColumn& chosenColumn(DmaQuantity quantity) {
  return *std::ranges::find(kChosenColumns, quantity, &ChosenColumn::quantity);
}

/// Returns the index of the column that a user chose by its name or number. Throws InputError
/// (option) where the block has no such column.
std::size_t columnNamed(const TextBlock& block, const std::string& wanted, const char* option) {
  const auto find = [&](const auto& spelled) {
    const std::string word = spelled(wanted);
    return std::ranges::find_if(block.columns, [&](const TextColumn& column) {
      const std::string name = spelled(column.name), unit = spelled(column.unit);
      return !name.empty() &&
             (name == word || name + " (" + unit + ")" == word || name + "_" + unit == word);
    });
  };
  // T is no t where a table has both.
  auto found = find([](const std::string& text) { return text; });
  if (found == block.columns.end())
    found = find([](const std::string& text) { return lowerCase(text); });
  // As it is written: "tan delta 20 \u00B0C" has been split into a name and a unit.
  if (const TextColumn written = parseColumnName(wanted);
      found == block.columns.end() && !written.unit.empty())
    found = std::ranges::find_if(block.columns, [&written](const TextColumn& column) {
      return column.name == written.name && column.unit == written.unit;
    });
  if (found != block.columns.end()) return static_cast<std::size_t>(found - block.columns.begin());
  std::size_t number = 0;
  if (readNumber(wanted, number) && number >= 1 && number <= block.columns.size())
    return number - 1;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < block.columns.size(); ++i) names.push_back(block.label(i));
  const std::vector<std::string_view> known(names.begin(), names.end());
  throw InputError("", option, notOneOf(wanted, known));
}

/// Applies the columns that the user names, which override those that were found.
void addChosen(const DmaBlock& in, SweepColumns& columns) {
  for (const auto& [quantity, choice, option] : kChosenColumns)
    if (const std::string& wanted = in.choices.*choice; !wanted.empty())
      columns.indices[quantity] = columnNamed(in.block, wanted, option);
  if (!in.choices.frequencyColumn.empty()) columns.indices.erase(ReducedFrequency);
}

/// Returns whether a sweep has the temperature and the frequency that the names of the columns
/// state which the user chose.
bool isOfChosen(const DmaBlock& in, const SweepColumns& chosen, const std::vector<DmaColumn>& found,
                const SweepColumns& sweep) {
  return std::ranges::all_of(kChosenColumns, [&](const ChosenColumn& one) {
    if ((in.choices.*one.choice).empty() || one.quantity == Temperature) return true;
    const DmaColumn& column = found[chosen[one.quantity]];
    return (!column.temperature || column.temperature == sweep.temperature) &&
           (!column.frequency || column.frequency == sweep.frequency);
  });
}

/// Distributes the columns: each belongs to the first sweep of its temperature and frequency that
/// has no column of its quantity yet.
std::vector<SweepColumns> assignToSweeps(const std::vector<DmaColumn>& found) {
  std::vector<SweepColumns> sweeps(1);  // what stands without a temperature is the first
  for (std::size_t i = 0; i < found.size(); ++i) {
    const DmaColumn& column = found[i];
    if (column.quantity == None) continue;
    const auto temperature = column.quantity == Temperature ? std::nullopt : column.temperature;
    auto sweepOfColumn = std::ranges::find_if(sweeps, [&](const SweepColumns& sweep) {
      return sweep.temperature == temperature && sweep.frequency == column.frequency &&
             !sweep.has(column.quantity);
    });
    if (sweepOfColumn == sweeps.end()) {
      sweeps.push_back({{}, temperature, column.frequency});
      sweepOfColumn = sweeps.end() - 1;
    }
    sweepOfColumn->indices[column.quantity] = i;
  }
  return sweeps;
}

std::vector<double> withoutRepeats(std::vector<double> values) {
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

/// Returns the temperatures in a line above the names, of which each or only the first cell states
/// the unit: "T / \u00B0C;-20;;-5".
std::vector<double> temperaturesIn(const TextEntry& entry) {
  std::vector<double> all = findTemperatures(entry.key + " " + entry.value);
  if (!all.empty()) return all;
  TextColumn key = parseColumnName(entry.key);
  if (dmaColumn(key).quantity == Temperature) {
    std::string numbers = entry.value;
    std::ranges::replace(numbers, ',', '.');
    for (const std::string_view word : WordList(numbers)) {
      double number = 0;
      if (!readTextNumber(word, '.', number)) return {};
      all.push_back(number);
    }
  } else {
    for (const std::string_view clause : splitClauses(entry.value)) {  // "T = -20;;T = -5"
      const auto stated = parseStatement(clause);
      if (!stated || !stated->unit().empty() ||
          dmaColumn(stated->name.name, {}).quantity != Temperature)
        return {};
      all.push_back(stated->quantity.number);
      key = stated->name;
    }
  }
  if (all.empty()) return {};
  const std::string unit =
      key.unit.empty() ? assumedTemperatureUnit(std::ranges::min(all)) : key.unit;
  const auto scale = temperatureUnit(unit);
  if (!scale) return {};
  for (double& one : all) one = scale->toSi(one);
  return all;
}

/// Reads the temperatures of sweeps that follow each other from a row above their names: one for
/// each column, or one for each sweep at any of its columns. Returns false where there is no such
/// row.
bool giveTemperatures(const TextBlock& block, std::vector<DmaColumn>& found,
                      std::vector<SweepColumns>& sweeps) {
  std::vector<std::size_t> measured, known;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i].quantity != None) known.push_back(i);
    if (isMeasured(found[i].quantity)) measured.push_back(i);
  }
  const auto count =
      static_cast<std::size_t>(std::ranges::count_if(sweeps, &SweepColumns::hasModuli));
  std::size_t stated = 0;
  for (auto entry = block.header.rbegin(); entry != block.header.rend(); ++entry) {
    const std::vector<double> all = temperaturesIn(*entry);
    stated += all.size();
    for (const auto* columns : {&measured, &known}) {
      if (all.size() != columns->size()) continue;
      for (std::size_t i = 0; i < columns->size(); ++i) found[(*columns)[i]].temperature = all[i];
      sweeps = assignToSweeps(found);
      return true;
    }
    for (const std::vector<double>& temperatures : {all, withoutRepeats(all)}) {
      if (temperatures.size() != count) continue;
      auto next = temperatures.begin();
      for (SweepColumns& sweep : sweeps)
        if (sweep.hasModuli()) sweep.temperature = *next++;
      return true;
    }
  }
  return stated == 1;  // one temperature for all, which were measured several times
}

std::string listColumns(const TextBlock& block, const std::vector<std::size_t>& columns) {
  constexpr std::size_t kMax = 8;
  std::string list;
  for (std::size_t i = 0; i < std::min(columns.size(), kMax); ++i)
    appendItem(list, fmt::format("{} ({})", shortened(block.label(columns[i])), columns[i] + 1));
  return columns.size() > kMax ? list + ", \u2026" : list;
}

[[noreturn]] void refuseWithoutTemperatures(const DmaBlock& in,
                                            const std::vector<SweepColumns>& sweeps) {
  std::vector<std::size_t> columns;
  for (const SweepColumns& sweep : sweeps)
    for (const auto& [quantity, column] : sweep.indices)
      if (isModulus(quantity)) columns.push_back(column);
  std::ranges::sort(columns);
  throw InputError(in.fileName, "temperature",
                   message("is not stated for each of the sweeps side by side in the columns {}; "
                           "write it into the names, as in \"G' 20C (MPa)\", or once for each "
                           "sweep into a row above them",
                           listColumns(in.block, columns)));
}

/// Throws InputError where a column of moduli would be ignored: its owner wants it used, or at
/// least wants to know that it is not.
void refuseLeftovers(const DmaBlock& in, const std::vector<DmaColumn>& found,
                     const std::vector<SweepColumns>& sweeps) {
  std::vector<std::size_t> unused;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const bool isUsed = std::ranges::any_of(sweeps, [i](const SweepColumns& sweep) {
      return std::ranges::any_of(sweep.indices,
                                 [i](const auto& entry) { return entry.second == i; });
    });
    if (isModulus(found[i].quantity) && !isUsed) unused.push_back(i);
  }
  if (!unused.empty())
    throw InputError(in.fileName, "",
                     message("has columns of moduli that belong to no sweep with a frequency and "
                             "both moduli: {}; take them out, or say with --storage-column and "
                             "--loss-column which are meant",
                             listColumns(in.block, unused)));
}

bool hasWord(const DmaColumn& column, const WordList& words) {
  return hasOneOf(wordsIn(column.words), words);
}

/// Of a set temperature and the sample's own, the sample's is read.
void dropSetTemperatures(std::vector<DmaColumn>& found) {
  const auto isOfSample = [](const DmaColumn& column) {
    return column.quantity == Temperature && hasWord(column, kWordsOfSample);
  };
  const auto isOfDevice = [](const DmaColumn& column) {
    return column.quantity == Temperature &&
           (hasWord(column, kWordsOfSetPoint) || hasWord(column, kWordsOfDevice));
  };
  if (!std::ranges::any_of(found, [&](const DmaColumn& column) {
        return isOfSample(column) && !isOfDevice(column);
      }))
    return;
  for (DmaColumn& column : found)
    if (isOfDevice(column)) {
      column.quantity = None;
      column.isLeftOut = true;
    }
}

/// Of "t" and T without units, "t" is the time.
void dropTimes(const TextBlock& block, std::vector<DmaColumn>& found) {
  const auto hasOther = [&] {
    for (std::size_t i = 0; i < found.size(); ++i)
      if (found[i].quantity == Temperature && block.columns[i].name != "t") return true;
    return false;
  };
  if (!hasOther()) return;
  for (std::size_t i = 0; i < found.size(); ++i)
    if (found[i].quantity == Temperature && block.columns[i].name == "t") found[i].quantity = None;
}

/// Beside a column in a unit of pressure, one in a unit of stiffness or torque is no modulus: K'
/// (N/m), S' (dNm).
void dropStiffnesses(const TextBlock& block, std::vector<DmaColumn>& found) {
  const auto isOther = [](const std::string& unit) {
    const auto known = findUnit(unit);
    return known ? known->si != "Pa" : endsWithOneOf(lowerCase(unit), "nm n\u00B7m n*m lbin lbfin");
  };
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!isModulus(found[i].quantity) || !isOther(block.columns[i].unit)) continue;
    for (std::size_t j = 0; j < found.size(); ++j)
      if (found[j].quantity == found[i].quantity && unitSize(block.columns[j].unit, "Pa")) {
        found[i].quantity = None;
        break;
      }
  }
}

/// Refuses names of moduli with words that are not understood, and two columns that claim the same
/// quantity under different names: which one is meant is for the user to say. Equal names are
/// sweeps side by side.
void refuseUnclearColumns(const DmaBlock& in, std::vector<DmaColumn>& found) {
  const auto has = [&found](DmaQuantity quantity) {
    return std::ranges::any_of(found, [quantity](const DmaColumn& column) {
      return column.quantity == quantity && column.unknown.empty();
    });
  };
  const bool hasBoth = (has(Storage) || !in.choices.storageColumn.empty()) &&
                       (has(Loss) || !in.choices.lossColumn.empty());
  // A table without any frequency is no table of moduli.
  const bool isStated =
      statedFrequency(in.block) || std::ranges::any_of(found, [](const DmaColumn& column) {
        return column.frequency.has_value();
      });
  if (!has(Frequency) && !has(ReducedFrequency) && in.choices.frequencyColumn.empty() && !isStated)
    return;
  for (std::size_t i = 0; i < found.size(); ++i) {
    DmaColumn& column = found[i];
    const DmaQuantity quantity = column.quantity;
    if (!isMeasured(quantity) && quantity != Temperature) continue;
    const bool isNeeded = quantity == Storage || quantity == Loss || quantity == Temperature;
    const bool isChosen = !(in.choices.*chosenColumn(quantity).choice).empty();
    if (isChosen || (!isNeeded && hasBoth)) {
      if (!column.unknown.empty()) column.quantity = None;
      continue;
    }
    for (std::size_t j = 0; j < found.size(); ++j) {
      const DmaColumn& other = found[j];
      if (j == i || other.quantity != quantity || other.temperature != column.temperature ||
          other.frequency != column.frequency ||
          (other.words == column.words && other.unknown == column.unknown &&
           lowerCase(in.block.columns[i].name) == lowerCase(in.block.columns[j].name)))
        continue;
      // The same words in other signs: G' and G\u2032.
      if (other.words == column.words && other.unknown.empty() && column.unknown.empty() &&
          in.block.columns[i].name.find('/') == std::string::npos &&
          in.block.columns[i].name.find('(') == std::string::npos)
        continue;
      throw InputError(
          in.fileName, in.block.label(std::min(i, j)),
          message("and {} seem to be the same quantity; take one of them out, or say "
                  "with {} which is meant",
                  shortened(in.block.label(std::max(i, j))), chosenColumn(quantity).option));
    }
    if (!column.unknown.empty())
      throw InputError(in.fileName, in.block.label(i),
                       message("'{}' is not understood beside the name of a modulus; name the "
                               "column after the modulus alone, or say with {} which is meant",
                               shortened(column.unknown), chosenColumn(quantity).option));
  }
}

}  // namespace

bool SweepColumns::hasModuli() const {
  return measuredPair(*this) != nullptr;
}

bool SweepColumns::isComplete() const {
  return hasModuli() && (has(Frequency) || has(ReducedFrequency) || frequency);
}

std::vector<SweepColumns> findSweeps(const DmaBlock& in, std::string& leftOut) {
  std::vector<DmaColumn> found;
  for (const TextColumn& column : in.block.columns)
    found.push_back(column.isText ? DmaColumn{} : dmaColumn(column));
  chooseForm(found);
  const ModulusKind kind = kindToRead(found, in.choices);
  for (DmaColumn& column : found)
    if (isModulus(column.quantity) && !isOfKind(column, kind)) column.quantity = None;
  dropTimes(in.block, found);
  dropStiffnesses(in.block, found);
  dropSetTemperatures(found);
  refuseUnclearColumns(in, found);
  for (std::size_t i = 0; i < found.size(); ++i)
    if (found[i].isLeftOut) appendItem(leftOut, shortened(in.block.label(i)));
  const bool isChosen =
      !(in.choices.storageColumn + in.choices.lossColumn + in.choices.lossTangentColumn +
        in.choices.magnitudeColumn + in.choices.phaseColumn)
           .empty();
  const bool hasTemperatures = std::ranges::any_of(found, [](const DmaColumn& column) {
    return column.temperature || column.quantity == Temperature;
  });
  std::vector<SweepColumns> sweeps = assignToSweeps(found);
  const auto isWide = [&] {
    return !isChosen && std::ranges::count_if(sweeps, &SweepColumns::hasModuli) > 1;
  };
  if (isWide() && !hasTemperatures && !giveTemperatures(in.block, found, sweeps))
    refuseWithoutTemperatures(in, sweeps);

  SweepColumns common = sweeps.front();
  addChosen(in, common);
  if (isWide()) {
    for (SweepColumns& sweep : sweeps) {
      for (const DmaQuantity quantity : {Frequency, ReducedFrequency, Strain})
        if (common.has(quantity)) sweep.indices.try_emplace(quantity, common[quantity]);
      if (common.has(Temperature) && !sweep.temperature)
        sweep.indices.try_emplace(Temperature, common[Temperature]);
    }
  } else {
    std::vector<double> temperatures, frequencies;
    for (const SweepColumns& sweep : sweeps) {
      if ((!sweep.temperature && !sweep.frequency) || !isOfChosen(in, common, found, sweep))
        continue;
      if (sweep.temperature) temperatures.push_back(*sweep.temperature);
      if (sweep.frequency) frequencies.push_back(*sweep.frequency);
      for (const auto& [quantity, index] : sweep.indices)
        common.indices.try_emplace(quantity, index);
    }
    if (withoutRepeats(temperatures).size() == 1) common.temperature = temperatures.front();
    if (withoutRepeats(frequencies).size() == 1) common.frequency = frequencies.front();
    sweeps = {common};
  }
  if (!common.has(Frequency) && !common.has(ReducedFrequency))
    if (const auto stated = statedFrequency(in.block))
      for (SweepColumns& sweep : sweeps)
        if (!sweep.frequency) sweep.frequency = stated;
  std::erase_if(sweeps, [](const SweepColumns& sweep) { return !sweep.isComplete(); });
  if (!sweeps.empty() && !isChosen) refuseLeftovers(in, found, sweeps);
  return sweeps;
}

}  // namespace asperity
