// The arms of an elastomer as a table (pair_editor.h): modulus and relaxation time of each, sorted
// by time. Object names: those of PairEditor with "arm", "armModulus" and "armTime". GUI thread;
// owned by its parent.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"
#include "ui/panels/pair_editor.h"

namespace asperity {

class ArmsEditor : public PairEditor {
  Q_OBJECT

 public:
  explicit ArmsEditor(QWidget* parent = nullptr);

  /// Shows the arms. `prescribed`: the number of arms that the rheology prescribes, if any.
  /// `replace` also overwrites refused input.
  void showArms(const std::vector<Arm>& arms, std::optional<std::size_t> prescribed, bool replace);

 signals:
  void armsGiven(const std::vector<asperity::Arm>& arms);

 protected:
  Texts texts() const override;
  Pair next(const Pairs& pairs) const override;
  Pairs fromTable(std::string_view text) const override;
  void give(const Pairs& pairs) override;
};

/// Reads arms from a table of two columns, as a spreadsheet copies it: with names and units in the
/// first row, or modulus in Pa and relaxation time in s, in any order that makes the larger numbers
/// the moduli. Throws InputError where there is no such table, a value is not allowed, or there are
/// more than kMostArms.
std::vector<Arm> armsFromTable(std::string_view text);

}  // namespace asperity
