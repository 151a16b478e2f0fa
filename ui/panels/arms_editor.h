// The arms of an elastomer as a table: modulus and relaxation time of each in engineering units,
// sorted by the time, with buttons to add and to remove; a long one is folded away under a line
// that says what is in it. A refused value stays where it was typed, with the reason beneath.
// Every accepted change gives the whole list. Object names: "armsFold", "armsAdd", and from 0
// "armModulus:I", "armTime:I", "armRemove:I", "armError:I". GUI thread; belongs to its parent.
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

  /// `wanted`: how many arms the rheology has, where it does not leave it open. `replace` also
  /// overwrites what someone typed and was refused.
  void showArms(const std::vector<Arm>& arms, std::optional<std::size_t> wanted, bool replace);

  /// The line with the fold, for the row of the panel.
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

  std::vector<Arm> arms_;  // by relaxation time, rising
  std::optional<std::size_t> wanted_;
  std::optional<bool> opened_;  // by hand; else a short list is open
  std::vector<ArmRow*> rows_;
  QToolButton* fold_;
  QWidget* table_;
  QGridLayout* grid_;
  std::array<QLabel*, 2> headings_{};
  QToolButton* add_;
};

}  // namespace asperity
