// The arms of an elastomer as a table: modulus and relaxation time of each in engineering units,
// sorted by time, with buttons to add, to remove and to paste a table; a long table is folded under
// a line that summarizes it. A refused value stays as it was typed, with the reason below it. Every
// accepted change passes on the whole list. Object names: "armsFold", "armsAdd", "armsPaste",
// "armsRefusal", and from 0 "armModulus:I", "armTime:I", "armRemove:I", "armError:I". GUI thread;
// belongs to its parent.
#pragma once

#include <QWidget>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

class QGridLayout;
class QLabel;
class QToolButton;

namespace asperity {

class ArmRow;

class ArmsEditor : public QWidget {
  Q_OBJECT

 public:
  explicit ArmsEditor(QWidget* parent = nullptr);
  ~ArmsEditor() override;

  /// `wanted`: number of arms that the rheology prescribes, if any. `replace` also overwrites
  /// refused input.
  void showArms(const std::vector<Arm>& arms, std::optional<std::size_t> wanted, bool replace);

  /// Returns the line with the fold, for the row of the panel.
  QToolButton& fold() { return *fold_; }

 signals:
  void armsGiven(const std::vector<asperity::Arm>& arms);

 protected:
  /// A table that is pasted into one of the entries replaces all arms.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  friend class ArmRow;

  void give(std::vector<Arm> arms);
  void change(std::size_t index, const Arm& arm);
  void add();
  void paste();
  void remove(std::size_t index);
  void makeRows(std::size_t count);
  void showTexts();
  void showFold();
  bool isOpen() const;

  std::vector<Arm> arms_;  // by ascending relaxation time
  std::optional<std::size_t> wanted_;
  std::optional<bool> opened_;  // by hand; otherwise a short list is open
  std::vector<ArmRow*> rows_;
  QToolButton* fold_;
  QWidget* table_;
  QGridLayout* grid_;
  std::array<QLabel*, 2> headings_{};
  QToolButton *add_, *paste_;
  QLabel* refusal_;  // why a table was not taken
};

/// Reads arms from a table of two columns, as a spreadsheet copies it: with names and units in the
/// first row, or modulus in Pa and relaxation time in s, in any order that makes the larger numbers
/// the moduli. Throws InputError where there is no such table, a value is not allowed, or there are
/// more than kMostArms.
std::vector<Arm> armsFromTable(std::string_view text);

}  // namespace asperity
