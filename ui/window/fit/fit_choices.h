// The choices for a fit, as tables with check boxes: the varied numbers of the scene with their
// limits, the measured tables to compare with, and the number of lines. A refused limit stays as it
// was typed, in red with its reason. Object names: "fitKeys", "fitTables", "fitLines",
// "fitProfiles". GUI thread; owned by its parent. Cannot fail.
#pragma once

#include <QWidget>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/fit/derivatives.h"
#include "core/scene/scene.h"

class QCheckBox;
class QListWidget;
class QSpinBox;
class QTableWidget;
class QTableWidgetItem;

namespace asperity {

/// Limits of one key as a user gave them, in the unit of the key.
struct FitLimits {
  std::optional<double> low, high;
};

/// The keys that are varied.
using FitSelection = std::map<std::string, FitLimits>;

class FitChoices : public QWidget {
  Q_OBJECT

 public:
  /// `before`: the choices of the last time, used for keys that the scene still has.
  FitChoices(const Scene& scene, const FitSelection& before, QWidget* parent = nullptr);

  /// Returns the scene that is fitted: with the chosen tables and number of lines.
  Scene scene() const;
  FitSelection selection() const;
  bool needsProfiles() const;
  /// Returns whether there is something to vary and something to compare it with.
  bool isEnough() const;
  /// Returns the first limit that is refused, with its reason; empty where there is none.
  QString refusal() const;

 signals:
  void changed();

 private:
  void fillKeys();
  void fillTables();
  void take(QTableWidgetItem& cell);

  Scene scene_;
  std::vector<VariedParameter> parameters_;  // one for each row
  std::vector<FitLimits> limits_;
  std::map<std::pair<int, int>, QString> refusals_;  // by row and column
  QTableWidget* keys_;
  QListWidget* tables_;
  QSpinBox* lines_;
  QCheckBox* profiles_;
};

/// Returns the parameters of the selection. Throws InputError as VariedParameter does.
std::vector<VariedParameter> variedParameters(const FitSelection& selection, const Scene& scene);

/// Returns them as the option --vary of `asperity fit` has them: "KEY" or "KEY=LOW:HIGH".
std::vector<std::string> variedTexts(const FitSelection& selection);

}  // namespace asperity
