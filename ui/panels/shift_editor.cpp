#include "ui/panels/shift_editor.h"

#include <algorithm>
#include <cmath>

#include "core/base/input_error.h"
#include "core/base/text_table.h"
#include "core/material/dma_columns.h"
#include "core/scene/list_text.h"
#include "core/scene/parameters.h"

namespace asperity {

namespace {

constexpr double kNextTemperature = 10;  // K above the warmest
constexpr double kColdest = 150;         // K; a lower number is meant in degrees Celsius

NumberRule numberRule(const ListMember<ShiftPoint>& member, bool isTemperature) {
  return {fromUtf8(member.unit), member.least, member.most, false, isTemperature};
}

PairEditor::Pairs asPairs(const std::vector<ShiftPoint>& table) {
  return PairEditor::toPairs(table, &ShiftPoint::temperature, &ShiftPoint::log10Shift);
}

/// Returns whether the column holds a_T, not its logarithm: "aT", "a_T", "shift factor".
bool isFactor(const std::string& name) {
  const QString word = fromUtf8(name).toLower().remove(' ').remove('_');
  return !word.contains(QStringLiteral("log")) && !word.contains(QStringLiteral("lg")) &&
         (word == QStringLiteral("at") || word.contains(QStringLiteral("factor")));
}

Unit columnUnit(const TextBlock& block, std::size_t column, const std::string& name) {
  std::string stated = block.columns[column].unit;
  // A unit that no table knows stays in the name.
  const std::string& title = block.columns[column].name;
  if (const auto open = title.find_first_of("(["); stated.empty() && open != title.npos)
    stated = title.substr(open + 1, title.find_first_of(")]", open) - open - 1);
  if (!stated.empty()) {
    if (const auto unit = temperatureUnit(stated)) return *unit;
    throw InputError(name, "", message("'{}' is no unit of temperature", stated));
  }
  double lowest = HUGE_VAL;
  for (std::size_t row = 0; row < block.rows; ++row)
    if (const double value = block.at(row, column); !std::isnan(value))
      lowest = std::min(lowest, value);
  return *temperatureUnit(lowest < kColdest ? "C" : "K");
}

}  // namespace

std::vector<ShiftPoint> shiftsFromTable(std::string_view text) {
  const std::string name = ShiftEditor::tr("clipboard").toStdString();
  const TextTable read = readTextTable(text, name);
  const TextBlock& block = read.largest();
  const std::vector<std::size_t> columns = columnsOfNumbers(block);
  if (columns.size() < 2)
    throw InputError(name, "", "needs two columns: temperature and log10 of the shift");
  const Unit unit = columnUnit(block, columns[0], name);
  const bool holdsFactors = isFactor(block.columns[columns[1]].name);
  std::vector<ShiftPoint> table;
  for (std::size_t row = 0; row < block.rows; ++row) {
    const double temperature = block.at(row, columns[0]);
    double shift = block.at(row, columns[1]);
    if (std::isnan(temperature) || std::isnan(shift)) continue;
    if (holdsFactors && shift <= 0)
      throw InputError(name, "", "holds a shift factor that is not above 0");
    if (holdsFactors) shift = std::log10(shift);
    table.push_back({unit.toSi(temperature), shift});
  }
  std::ranges::sort(table, {}, &ShiftPoint::temperature);
  if (table.empty() || table.size() > kMostShiftPoints)
    throw InputError(name, "",
                     message("has {} rows; allowed is 1 to {}", table.size(), kMostShiftPoints));
  for (const ShiftPoint& point : table)
    for (const auto& member : shiftMembers())
      if (const double value = point.*member.value;
          !(value >= member.least && value <= member.most))
        throw InputError(name, "",
                         message("{} is {}; allowed is {} to {}", Message::name(member.name), value,
                                 member.least, member.most));
  for (std::size_t i = 1; i < table.size(); ++i)
    if (table[i].temperature == table[i - 1].temperature)
      throw InputError(name, "", message("has {} K twice", table[i].temperature));
  return table;
}

ShiftEditor::ShiftEditor(QWidget* parent)
    : PairEditor({"shift",
                  {"shiftTemperature", "shiftLog"},
                  {numberRule(shiftMembers()[0], true), numberRule(shiftMembers()[1], false)},
                  0,
                  kMostShiftPoints,
                  false},
                 parent) {
  begin();
}

PairEditor::Texts ShiftEditor::texts() const {
  return {
      {tr("temperature") + "&nbsp; " + symbolHtml("T"), "log<sub>10</sub> " + symbolHtml("a_T")},
      {tr("temperature of row %1 (%2)"), tr("log10 of the shift of row %1")},
      tr("one"),
      tr("Add row"),
      tr("One more row, 10 K above the highest temperature"),
      tr("Paste table"),
      tr("Two columns from the clipboard, as a spreadsheet copies them, replace the table: "
         "temperature in K or °C and log10 of the shift, or as names and units in the first "
         "row say"),
      tr("Remove this row"),
      tr("remove row %1"),
      tr("shift table: %1")};
}

/// Returns a row beyond the warmest, with the shift that the last two rows go on to.
PairEditor::Pair ShiftEditor::next(const Pairs& pairs) const {
  if (pairs.empty()) return {ShiftPoint{}.temperature, ShiftPoint{}.log10Shift};
  Pair row = pairs.back();
  if (pairs.size() > 1) {
    const Pair& before = pairs[pairs.size() - 2];
    row[1] += (row[1] - before[1]) / (row[0] - before[0]) * kNextTemperature;
    row[1] =
        std::clamp(std::round(1e3 * row[1]) / 1e3, shiftMembers()[1].least, shiftMembers()[1].most);
  }
  row[0] = std::min(row[0] + kNextTemperature, shiftMembers()[0].most);
  return row;
}

PairEditor::Pairs ShiftEditor::fromTable(std::string_view text) const {
  return asPairs(shiftsFromTable(text));
}

void ShiftEditor::give(const Pairs& pairs) {
  emit shiftsGiven(fromPairs(pairs, &ShiftPoint::temperature, &ShiftPoint::log10Shift));
}

void ShiftEditor::showShifts(const std::vector<ShiftPoint>& table, bool replace) {
  showPairs(asPairs(table), std::nullopt, replace);
}

}  // namespace asperity
