// The cost of accuracy: a slider from quick to exact, which sets the target for the error of the
// friction curve, with the predicted time and error, and the measured ones beside them; the
// work-precision diagram of the present scene on demand; and the setting with which the curve is
// compared. It predicts in the background, and only while it is visible. GUI thread; owned by its
// parent. Failure: a line of the panel gives the reason.
#pragma once

#include <QWidget>
#include <optional>

#include "core/accuracy/prediction.h"
#include "core/friction/curve_difference.h"
#include "core/scene/scene.h"
#include "ui/window/tasks/background_work.h"

class QLabel;
class QPushButton;
class QSlider;

namespace asperity {

class ComparisonBox;
class RegionPictures;

/// The slider's positions: target 20 % at 0 (quick), 0.2 % at kAccuracySteps (exact).
inline constexpr int kAccuracySteps = 20;
double targetAt(int position);
/// Returns the slider position nearest to a target (> 0).
int sliderPosition(double target);

/// Time and error of a finished curve; errors are relative, root mean square.
struct CurveCost {
  double seconds = 0, standardError = kNotApplicable;
  /// Half of the confidence interval, shown where there is no standard error, for example for a
  /// single line with a target.
  double interval = kNotApplicable;
};

class AccuracyPanel : public QWidget {
  Q_OBJECT

 public:
  explicit AccuracyPanel(QWidget* parent = nullptr);

  void showScene(const Scene& scene);
  /// Shows time and error of the finished curve of this scene.
  void showMeasured(const CurveCost& measured);

  /// Returns the setting with which the curve is compared; none: no comparison.
  std::optional<CurveSetting> comparison() const;

 signals:
  /// Emitted with the scene that has another target.
  void sceneEdited(const asperity::Scene& scene);
  void comparisonChanged();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void setTarget(double target);
  void showTexts();
  void showTarget();
  void predict();
  void showPrediction(const Prediction& prediction);
  void compareMethods();
  void dropOldPicture();
  void showInvitation();
  void showComparing();

  Scene scene_;
  QSlider* slider_;
  QLabel *quick_, *exact_;  // labels at the slider's ends
  QLabel* target_;
  QLabel *predicted_, *warning_;
  QLabel* measured_;
  ComparisonBox* comparisonBox_;
  QPushButton* free_;     // no target
  QPushButton* compare_;  // starts and cancels the comparison
  QWidget* scrolled_;     // the controls
  RegionPictures* picture_;
  std::optional<Scene> pictured_;           // scene of the comparison in the picture
  std::optional<CurveCost> measuredCurve_;  // to show it again in another language
  BackgroundWork comparison_,
      prediction_;  // last: their threads end before other members are destroyed
};

}  // namespace asperity
