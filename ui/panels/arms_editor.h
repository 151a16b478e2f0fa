// The arms of an elastomer as a table: modulus and relaxation time of each in engineering units,
// sorted by time, with buttons to add and to remove; a long table is folded under a line that
// summarizes it. A refused value stays as it was typed, with the reason below it. Every accepted
// change passes on the whole list. Object names: "armsFold", "armsAdd", and from 0 "armModulus:I",
// "armTime:I", "armRemove:I", "armError:I". GUI thread; belongs to its parent.
#pragma once

#include <QWidget>
#include <array>
#include <optional>
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

 private:
  friend class ArmRow;

  void give(std::vector<Arm> arms);
  void change(std::size_t index, const Arm& arm);
  void add();
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
  QToolButton* add_;
};

}  // namespace asperity
