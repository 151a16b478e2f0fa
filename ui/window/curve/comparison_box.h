// With what the friction curve is compared: another scheme, oversampling and number of lines. GUI
// thread; belongs to its parent. Cannot fail.
#pragma once

#include <QWidget>
#include <optional>

#include "core/friction/curve_difference.h"

class QCheckBox;
class QComboBox;
class QSpinBox;

namespace asperity {

class ComparisonBox : public QWidget {
  Q_OBJECT

 public:
  explicit ComparisonBox(QWidget* parent = nullptr);

  /// Nothing where the box is not ticked.
  std::optional<CurveSetting> setting() const;
  /// A target accuracy leaves nothing to compare at one resolution.
  void allow(bool allowed);
  /// As many lines as the scene has, unless somebody chose another number: fewer would add their
  /// own scatter to the difference.
  void suggestLines(std::int64_t lines);

 signals:
  void settingChanged();

 private:
  void showTexts();
  void showLines();

  QCheckBox* wanted_;
  QComboBox* scheme_;
  QSpinBox* oversampling_;
  QSpinBox* lines_;
  int suggested_ = 0;  // number of lines that nobody chose
};

}  // namespace asperity
