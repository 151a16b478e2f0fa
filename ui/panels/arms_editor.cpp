#include "ui/panels/arms_editor.h"

#include <algorithm>
#include <cmath>

#include "core/base/input_error.h"
#include "core/base/text_table.h"
#include "core/material/prony_file.h"
#include "core/scene/list_text.h"
#include "core/scene/parameters.h"

namespace asperity {

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
  if (arms.size() > kMostArms)
    throw InputError(name, "", message("has {} arms; allowed is {}", arms.size(), kMostArms));
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
                  kMostArms,
                  true},
                 parent) {
  begin();
}

PairEditor::Texts ArmsEditor::texts() const {
  return {{tr("modulus") + "&nbsp; " + symbolHtml("G_i"),
           tr("relaxation time") + "&nbsp; " + symbolHtml("tau_i")},
          {tr("modulus of arm %1 (%2)"), tr("relaxation time of arm %1 (%2)")},
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

void ArmsEditor::give(const Pairs& pairs) {
  emit armsGiven(fromPairs(pairs, &Arm::modulus, &Arm::relaxationTime));
}

void ArmsEditor::showArms(const std::vector<Arm>& arms, std::optional<std::size_t> prescribed,
                          bool replace) {
  showPairs(asPairs(arms), prescribed, replace);
}

}  // namespace asperity
