// What accuracy costs: a slider from quick to exact, which sets the target of the friction curve's
// error, with predicted time and error as it moves and the measured ones beside them; the
// work-precision diagram of the present scene on demand; and the setting with which the curve is
// compared. Predicts in the background, and only while it is visible. GUI thread; belongs to its
// parent. Failure: said in a line of the panel.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "core/accuracy/prediction.h"
#include "core/friction/curve_difference.h"
#include "core/scene/scene.h"
#include "ui/contact/contact_picture.h"
#include "ui/window/figures/made_figure.h"
#include "ui/window/tasks/background_work.h"

class QLabel;
class QPushButton;
class QSlider;

namespace asperity {

class ComparisonBox;
class RegionPictures;

/// The target at a place of the slider, 0 (quick, 20 %) to kAccuracySteps (exact, 0.2 %).
inline constexpr int kAccuracySteps = 20;
double targetAt(int place);
/// The place nearest to a target (> 0).
int placeOf(double target);

/// Error against time of every method on the lines of a scene.
struct ComparedMethods {
  Scene scene;
  std::shared_ptr<const MadeFigure> figure;
  int diagram = 0;  // in sight
};

class AccuracyPanel : public QWidget {
  Q_OBJECT

 public:
  explicit AccuracyPanel(QWidget* parent = nullptr);

  void showScene(const Scene& scene);
  /// Shows time and error of the finished curve of this scene; errors are relative, root mean
  /// square. interval: half of it, said where there is no standard error, as of a single line to a
  /// target.
  void showMeasured(double seconds, double standardError, double interval = kNotApplicable);
  void setTheme(const Theme& theme);

  /// The setting that the curve is to be compared with; none: no comparison.
  std::optional<CurveSetting> comparison() const;

  /// The result that is shown, if there is one; and shows such a result if it is of this scene.
  std::optional<ComparedMethods> comparedMethods() const;
  void showComparedMethods(const ComparedMethods& compared);

 signals:
  /// The scene shown with another target.
  void sceneEdited(const asperity::Scene& scene);
  void comparisonChanged();

 protected:
  void changeEvent(QEvent* event) override;
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
  void endComparison();

  /// Time and error of a finished curve, to be said again in another language.
  struct Measured {
    double seconds, standardError, interval;
  };

  Scene scene_;
  QSlider* slider_;
  QLabel *quick_, *exact_;  // at its ends
  QLabel* target_;
  QLabel* predicted_;
  QLabel* measured_;
  ComparisonBox* comparisonBox_;
  QPushButton* free_;     // no target
  QPushButton* compare_;  // starts and cancels
  QWidget* scrolled_;     // the controls
  RegionPictures* picture_;
  bool isComparing_ = false;
  std::optional<Scene> pictured_;  // whose methods are compared on the picture
  std::optional<Measured> measuredCurve_;
  BackgroundWork comparison_,
      prediction_;  // last: their threads end before anything else here goes
};

}  // namespace asperity
