// The lists of an elastomer as tables (pair_editor.h). Arms: modulus and relaxation time of each,
// sorted by time; object names those of PairEditor with "arm", "armModulus" and "armTime". Measured
// shifts: temperature and log10 a_T, by rising temperature; object names with "shift",
// "shiftTemperature" and "shiftLog". GUI thread; owned by their parent.
#pragma once

#include <string_view>
#include <vector>

#include "core/scene/scene.h"
#include "ui/panels/pair_editor.h"

namespace asperity {

class ArmsEditor : public PairEditor {
  Q_OBJECT

 public:
  explicit ArmsEditor(QWidget* parent = nullptr);
  void showScene(const Scene& scene, bool replace) override;

 protected:
  Texts texts() const override;
  Pair next(const Pairs& pairs) const override;
  Pairs fromTable(std::string_view text) const override;
  ParameterValue toValue(const Pairs& pairs) const override;
};

/// Reads arms from a table of two columns, as a spreadsheet copies it: with names and units in the
/// first row, or modulus in Pa and relaxation time in s, in any order that makes the larger numbers
/// the moduli. Throws InputError where there is no such table, a value is not allowed, or there are
/// more than kMaxArms.
std::vector<Arm> armsFromTable(std::string_view text);

class ShiftEditor : public PairEditor {
  Q_OBJECT

 public:
  explicit ShiftEditor(QWidget* parent = nullptr);
  void showScene(const Scene& scene, bool replace) override;

 protected:
  Texts texts() const override;
  Pair next(const Pairs& pairs) const override;
  Pairs fromTable(std::string_view text) const override;
  ParameterValue toValue(const Pairs& pairs) const override;
};

/// Reads shifts from a table whose first two columns of numbers are temperature and log10 a_T, as a
/// spreadsheet copies it. Temperatures are in the unit that the name of the column states (K, °C,
/// °F), else in K, or in °C where one of them is below 150, colder than any rubber is used. The
/// second column holds a_T itself where its name is that of a factor ("aT", "a_T", "shift factor").
/// Throws InputError where there is no such table, a temperature stands twice, or a value is not
/// allowed.
std::vector<ShiftPoint> shiftsFromTable(std::string_view text);

}  // namespace asperity
