// A box of materials: the values typed by hand, those that come with the program, the file that the
// scene names, and a last entry that opens a file dialog. Each entry of the open list has a small
// picture of its moduli G' and G'' over frequency. GUI thread; owned by its parent.
#pragma once

#include "core/material/elastomer.h"
#include "ui/panels/boxes.h"

namespace asperity {

class MaterialBox : public ChoiceBox {
  Q_OBJECT

 public:
  explicit MaterialBox(QWidget* parent = nullptr);

  /// Shows the elastomer's material.
  void showMaterial(const Elastomer& elastomer);
  void showTexts();

  void showPopup() override;
  QSize minimumSizeHint() const override;

 signals:
  /// Emitted with a shipped material, a file as the scene names it, or an empty name.
  void nameGiven(const QString& name);
  void fileRequested();

 private:
  void pick(int index);

  Elastomer elastomer_;
};

}  // namespace asperity
