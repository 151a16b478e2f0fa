// The setting with which the friction curve is compared, as controls: another scheme, oversampling
// and number of lines. GUI thread; owned by its parent.
#pragma once

#include <QWidget>
#include <cstdint>
#include <optional>

#include "core/friction/curve_difference.h"

class QCheckBox;
class QSpinBox;

namespace asperity {

class ChoiceBox;
class ComparisonBox : public QWidget {
  Q_OBJECT

 public:
  explicit ComparisonBox(QWidget* parent = nullptr);

  /// Returns the setting, or nothing where the box is not ticked.
  std::optional<CurveSetting> setting() const;
  /// Enables the box. With a target accuracy there is no single resolution to compare with.
  void allow(bool allowed);
  /// Proposes as many lines as the scene has, unless the user chose another number: fewer lines
  /// would add their own scatter to the difference.
  void suggestLines(std::int64_t lines);

 signals:
  void settingChanged();

 private:
  void showTexts();
  void showLines();

  QCheckBox* compare_;
  ChoiceBox* scheme_;
  QSpinBox* oversampling_;
  QSpinBox* lines_;
  int suggested_ = 0;  // number of lines that was proposed, not chosen
};

}  // namespace asperity
