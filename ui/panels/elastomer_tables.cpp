#include "ui/panels/elastomer_tables.h"

#include <algorithm>
#include <cmath>

#include "core/base/input_error.h"
#include "core/base/text_table.h"
#include "core/material/prony_file.h"
#include "core/material/stated_temperature.h"
#include "core/scene/list_text.h"
#include "core/scene/parameters.h"

namespace asperity {

// ---- Arms

namespace {

constexpr double kNextArm = 10;  // relative to the longest relaxation time

NumberRule numberRule(const ArmMember& member) {
  return {fromUtf8(member.unit), 0, member.most, false, false};
}

PairEditor::Pairs asPairs(const std::vector<Arm>& arms) {
  return PairEditor::toPairs(arms, &Arm::modulus, &Arm::relaxationTime);
}

/// Reads arms from a table without names. The column with the larger maximum has the moduli: the
/// largest modulus is far above the longest time.
std::vector<Arm> namelessArms(const TextBlock& block, const std::string& name) {
  const std::vector<std::size_t> columns = columnsOfNumbers(block);
  if (columns.size() != 2)
    throw InputError(name, "", "needs two columns: modulus in Pa and relaxation time in s");
  double largest[2] = {0, 0};
  for (std::size_t row = 0; row < block.rows; ++row)
    for (std::size_t k = 0; k < 2; ++k)
      if (const double value = block.at(row, columns[k]); !std::isnan(value))
        largest[k] = std::max(largest[k], value);
  const std::size_t modulus = largest[0] >= largest[1] ? 0 : 1;
  std::vector<Arm> arms;
  for (std::size_t row = 0; row < block.rows; ++row)
    arms.push_back({block.at(row, columns[modulus]), block.at(row, columns[1 - modulus])});
  return arms;
}

}  // namespace

std::vector<Arm> armsFromTable(std::string_view text) {
  const std::string name = ArmsEditor::tr("clipboard").toStdString();
  const TextTable table = readTextTable(text, name);
  const bool isNamed = std::ranges::any_of(
      table.largest().columns, [](const TextColumn& column) { return !column.name.empty(); });
  std::vector<Arm> arms;
  if (isNamed) {
    PronyChoices choices;
    choices.isLiquid = true;  // the equilibrium modulus is a value of the scene
    const auto series = readPronyFile({}, &table, name, choices);
    if (!series)
      throw InputError(
          name, "",
          "needs a column of relaxation times and one of moduli, named such as tau and G");
    arms = series->arms;
  } else {
    arms = namelessArms(table.largest(), name);
  }
  if (arms.size() > kMaxArms)
    throw InputError(name, "", message("has {} arms; allowed is {}", arms.size(), kMaxArms));
  for (const Arm& arm : arms)
    for (const ArmMember& member : armMembers())
      if (const double value = arm.*member.value; !(value > 0 && value <= member.most))
        throw InputError(name, "", "holds a modulus or a time that is not above 0, or too large");
  return arms;
}

ArmsEditor::ArmsEditor(QWidget* parent)
    : PairEditor({"arm",
                  {"armModulus", "armTime"},
                  {numberRule(armMembers()[0]), numberRule(armMembers()[1])},
                  1,
                  kMaxArms,
                  true},
                 parent) {
  begin();
}

PairEditor::Texts ArmsEditor::texts() const {
  return {{tr("modulus") + "&nbsp; " + symbolHtml("G_i"),
           tr("relaxation time") + "&nbsp; " + symbolHtml("tau_i")},
          {tr("modulus of arm %1"), tr("relaxation time of arm %1")},
          tr("one"),
          tr("Add arm"),
          tr("One more arm, with ten times the longest relaxation time"),
          tr("Paste table"),
          tr("Two columns from the clipboard, as a spreadsheet copies them, replace all arms: "
             "modulus in Pa and relaxation time in s, or as names and units in the first row say"),
          tr("Remove this arm"),
          tr("remove arm %1"),
          tr("arms: %1")};
}

/// Returns a new arm, a decade beyond the longest time, where a spectrum usually continues.
PairEditor::Pair ArmsEditor::next(const Pairs& pairs) const {
  if (pairs.empty()) return {Arm{}.modulus, Arm{}.relaxationTime};
  Pair arm = pairs.back();
  arm[1] = arm[1] > 0 ? std::min(kNextArm * arm[1], armMembers()[1].most) : Arm{}.relaxationTime;
  return arm;
}

PairEditor::Pairs ArmsEditor::fromTable(std::string_view text) const {
  return asPairs(armsFromTable(text));
}

ParameterValue ArmsEditor::toValue(const Pairs& pairs) const {
  return listText(fromPairs(pairs, &Arm::modulus, &Arm::relaxationTime));
}

/// A standard solid has one arm, a Prony series any number.
void ArmsEditor::showScene(const Scene& scene, bool replace) {
  const bool isSolid = scene.elastomer.rheology == Rheology::StandardSolid;
  showPairs(asPairs(scene.elastomer.arms), isSolid ? std::optional<std::size_t>(1) : std::nullopt,
            replace);
}

// ---- Shifts

namespace {

constexpr double kNextTemperature = 10;  // K above the warmest
constexpr double kColdest = 150;         // K; a lower number is meant in degrees Celsius

NumberRule numberRule(const ListMember<ShiftPoint>& member, bool isTemperature) {
  return {fromUtf8(member.unit), member.least, member.most, false, isTemperature};
}

PairEditor::Pairs asPairs(const std::vector<ShiftPoint>& table) {
  return PairEditor::toPairs(table, &ShiftPoint::temperature, &ShiftPoint::log10Shift);
}

Unit columnUnit(const TextBlock& block, std::size_t column, const std::string& name) {
  std::string stated = block.columns[column].unit;
  // A unit that no table knows stays in the name.
  const std::string& title = block.columns[column].name;
  if (const auto open = title.find_first_of("(["); stated.empty() && open != title.npos)
    stated = title.substr(open + 1, title.find_first_of(")]", open) - open - 1);
  if (!stated.empty()) {
    if (const auto unit = temperatureUnit(stated)) return *unit;
    throw InputError(name, "", message("'{}' is not a unit of temperature", stated));
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
  const ShiftNotation notation =
      shiftNotation(block.columns[columns[1]].name).value_or(ShiftNotation{});
  std::vector<ShiftPoint> table;
  for (std::size_t row = 0; row < block.rows; ++row) {
    const double temperature = block.at(row, columns[0]);
    const double shift = block.at(row, columns[1]);
    if (std::isnan(temperature) || std::isnan(shift)) continue;
    if (!notation.isLogarithm && shift <= 0)
      throw InputError(name, "", "holds a shift factor that is not above 0");
    table.push_back({unit.toSi(temperature), notation.log10Shift(shift)});
  }
  std::ranges::sort(table, {}, &ShiftPoint::temperature);
  if (table.empty() || table.size() > kMaxShiftPoints)
    throw InputError(name, "",
                     message("has {} rows; allowed is 1 to {}", table.size(), kMaxShiftPoints));
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
                  kMaxShiftPoints,
                  false},
                 parent) {
  begin();
}

PairEditor::Texts ShiftEditor::texts() const {
  return {
      {tr("temperature") + "&nbsp; " + symbolHtml("T"), "log<sub>10</sub> " + symbolHtml("a_T")},
      {tr("temperature of row %1"), tr("log10 of the shift of row %1")},
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

ParameterValue ShiftEditor::toValue(const Pairs& pairs) const {
  return listText(fromPairs(pairs, &ShiftPoint::temperature, &ShiftPoint::log10Shift));
}

void ShiftEditor::showScene(const Scene& scene, bool replace) {
  showPairs(asPairs(scene.elastomer.shift.table), std::nullopt, replace);
}

}  // namespace asperity
