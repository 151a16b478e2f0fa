// The measured shifts of an elastomer as a table (pair_editor.h): temperature and log10 a_T, by
// rising temperature. Object names: those of PairEditor with "shift", "shiftTemperature" and
// "shiftLog". GUI thread; owned by its parent.
#pragma once

#include <string_view>
#include <vector>

#include "core/scene/scene.h"
#include "ui/panels/pair_editor.h"

namespace asperity {

class ShiftEditor : public PairEditor {
  Q_OBJECT

 public:
  explicit ShiftEditor(QWidget* parent = nullptr);

  /// Shows the table. `replace` also overwrites refused input.
  void showShifts(const std::vector<ShiftPoint>& table, bool replace);

 signals:
  void shiftsGiven(const std::vector<asperity::ShiftPoint>& table);

 protected:
  Texts texts() const override;
  Pair next(const Pairs& pairs) const override;
  Pairs fromTable(std::string_view text) const override;
  void give(const Pairs& pairs) override;
};

/// Reads shifts from a table whose first two columns of numbers are temperature and log10 a_T, as a
/// spreadsheet copies it. Temperatures are in the unit that the name of the column states (K, °C,
/// °F), else in K, or in °C where one of them is below 150, colder than any rubber is used. The
/// second column holds a_T itself where its name is that of a factor ("aT", "a_T", "shift factor").
/// Throws InputError where there is no such table, a temperature stands twice, or a value is not
/// allowed.
std::vector<ShiftPoint> shiftsFromTable(std::string_view text);

}  // namespace asperity
