#include "ui/window/accuracy/accuracy_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/accuracy/work_precision_sheet.h"
#include "core/base/number_text.h"
#include "core/run/motion_accuracy.h"
#include "ui/chart/friction_chart_model.h"
#include "ui/draw/ticks.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/panels/labels.h"
#include "ui/panels/number_text.h"
#include "ui/panels/parameter_text.h"
#include "ui/window/accuracy/comparison_box.h"
#include "ui/window/accuracy/region_pictures.h"
#include "ui/window/curve/curve_reading.h"

namespace asperity {

namespace {

constexpr double kQuick = 0.2, kDecades = 2;  // targets from 20 % to 0.2 %
constexpr int kControlsWidth = 320;

QString percent(double part) {
  return std::isfinite(part) ? readingLabel(100 * part, 2) + QStringLiteral("\u00A0%")
                             : QStringLiteral("–");
}

QLabel* addLine(QVBoxLayout& column, const char* name) {
  auto* label = named<QLabel>(name);
  label->setWordWrap(true);
  column.addWidget(label);
  return label;
}

/// The controls beside the picture: as wide as their texts need, also in the large font of a
/// presentation. A scroll bar reaches what does not fit the height.
class ControlColumn : public QScrollArea {
 public:
  explicit ControlColumn(QWidget* content) {
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
    setWidget(content);
    content->installEventFilter(this);
    content->setAutoFillBackground(false);
    viewport()->setAutoFillBackground(false);
  }
  QSize sizeHint() const override {
    const int needed = widget()->layout()->minimumSize().width();
    const int bar = verticalScrollBar()->sizeHint().width();
    return {std::max(kControlsWidth, needed + bar), QScrollArea::sizeHint().height()};
  }
  QSize minimumSizeHint() const override { return {sizeHint().width(), 0}; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::LayoutRequest) updateGeometry();
    return QScrollArea::eventFilter(watched, event);
  }
};

QString comparingText() {
  return AccuracyPanel::tr("measuring every method on this scene's lines …");
}

}  // namespace

double targetAt(int position) {
  return roundedToDigits(kQuick * std::pow(10, -kDecades * position / kAccuracySteps), 2);
}

int sliderPosition(double target) {
  const double position = std::log10(kQuick / target) / kDecades * kAccuracySteps;
  return static_cast<int>(std::lround(std::clamp(position, 0.0, 1.0 * kAccuracySteps)));
}

AccuracyPanel::AccuracyPanel(QWidget* parent)
    : QWidget(parent),
      slider_(named<QSlider>("accuracySlider")),
      quick_(new QLabel),
      exact_(new QLabel) {
  setObjectName("accuracyPanel");
  auto* controls = new QWidget;
  auto* column = new QVBoxLayout(controls);
  column->setContentsMargins(14, 8, 10, 8);
  slider_->setOrientation(Qt::Horizontal);
  slider_->setRange(0, kAccuracySteps);
  connect(slider_, &QSlider::valueChanged, this,
          [this](int position) { setTarget(targetAt(position)); });
  auto* targets = new QHBoxLayout;
  targets->addWidget(quick_);
  targets->addWidget(slider_, 1);
  targets->addWidget(exact_);
  column->addLayout(targets);
  target_ = addLine(*column, "accuracyTarget");
  predicted_ = addLine(*column, "accuracyPredicted");
  warning_ = warningTextLabel("accuracyWarning");
  warning_->hide();
  column->addWidget(warning_);
  measured_ = addLine(*column, "accuracyMeasured");
  column->addStretch(1);
  comparisonBox_ = new ComparisonBox;
  connect(comparisonBox_, &ComparisonBox::settingChanged, this, &AccuracyPanel::comparisonChanged);
  column->addWidget(comparisonBox_);
  free_ = named<QPushButton>("accuracyFree");
  connect(free_, &QPushButton::clicked, this, [this] { setTarget(0); });
  compare_ = named<QPushButton>("accuracyCompare");
  connect(compare_, &QPushButton::clicked, this, &AccuracyPanel::compareMethods);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(free_);
  buttons->addWidget(compare_, 1);
  column->addLayout(buttons);

  picture_ = new RegionPictures;
  auto* line = marginless<QHBoxLayout>(this);
  scrolled_ = new ControlColumn(controls);
  line->addWidget(scrolled_);
  line->addWidget(picture_, 1);
  keepTranslated(*this, [this] { showTexts(); });
}

void AccuracyPanel::showTexts() {
  const QString tip = errorsInWords() + ' ' +
                      tr("Measured is the time on the clock from the change of the scene to its "
                         "whole curve. Other programs that run meanwhile make it longer than "
                         "predicted.");
  for (QLabel* label : {predicted_, measured_}) label->setToolTip(wrappedTip(tip));
  quick_->setText(tr("quick"));
  exact_->setText(tr("exact"));
  for (QWidget* widget : Widgets{slider_, scrolled_})
    widget->setAccessibleName(tr("accuracy from quick to exact"));
  free_->setText(tr("No target"));
  free_->setToolTip(tr("Scheme, oversampling and realizations as set in the parameters"));
  showComparing();
  compare_->setToolTip(tr("Measures error against time of every method on this scene's lines"));
  showTarget();
  if (measuredCurve_) showMeasured(*measuredCurve_);
  if (comparison_.isBusy()) {
    picture_->showText(comparingText());
  } else if (!picture_->hasSheet()) {
    pictured_.reset();
    showInvitation();
  }
  predict();
}

void AccuracyPanel::showScene(const Scene& scene) {
  scene_ = scene;
  showTarget();
  comparisonBox_->allow(!choosesAccuracy(scene));
  comparisonBox_->suggestLines(scene.ensemble.realizations);
  dropOldPicture();
  measuredCurve_.reset();
  measured_->clear();
  predict();
}

void AccuracyPanel::showTarget() {
  const double target = scene_.accuracy.targetRelativeError;
  const QSignalBlocker quiet(slider_);
  slider_->setValue(target > 0 ? sliderPosition(target) : 0);
  target_->setText(target > 0 ? tr("target: %1 of μ at every velocity").arg(percent(target))
                              : tr("no target: scheme and realizations as set"));
  slider_->setAccessibleDescription(target_->text());  // its own value is a position
  free_->setEnabled(target > 0);
}

void AccuracyPanel::showMeasured(const CurveCost& measured) {
  measuredCurve_ = measured;
  const auto& [time, standardError, interval] = *measuredCurve_;
  const bool isSingle = !std::isfinite(standardError) && std::isfinite(interval);
  measured_->setText(isSingle
                         ? tr("measured: %1 on the clock, error of the whole curve %2")
                               .arg(quantityLabel(time, "s", 2), percent(interval))
                         : tr("measured: %1 on the clock, standard error of the whole curve %2")
                               .arg(quantityLabel(time, "s", 2), percent(standardError)));
}

std::optional<CurveSetting> AccuracyPanel::comparison() const {
  return comparisonBox_->setting();
}

/// Sets a target. The program then chooses the oversampling, and the scheme is the one that can be
/// refined.
void AccuracyPanel::setTarget(double target) {
  Scene next = scene_;
  next.accuracy.targetRelativeError = target;
  if (target > 0) next.accuracy.scheme = Scheme::Cubic;
  showScene(next);
  emit sceneEdited(next);
}

void AccuracyPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  predict();
}

void AccuracyPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  prediction_.cancel();
}

void AccuracyPanel::predict() {
  if (!isVisible()) return;
  predicted_->setText(tr("predicting …"));
  showWarnings(*warning_, {});
  prediction_.request(
      [scene = scene_](const BackgroundWork::Run& run) { return predictRun(scene, 0, run.stop()); },
      [this](const Prediction& prediction) { showPrediction(prediction); },
      [this](const QString& reason) { predicted_->setText(reason); });
}

void AccuracyPanel::showPrediction(const Prediction& prediction) {
  QStringList warnings;
  if (const auto warning = warningOf(scene_, prediction))
    warnings += withLabels(translatedText(*warning));
  showWarnings(*warning_, warnings);
  if (prediction.steps > 0)
    return predicted_->setText(
        tr("predicted motion: %1 on free processors for %2 steps, error of the whole motion %3 "
           "(time step %4, resolution %5, settling %6)")
            .arg(quantityLabel(prediction.seconds, "s", 2))
            .arg(prediction.steps, 0, 'f', 0)
            .arg(percent(prediction.error.total()), percent(prediction.error.timeStep),
                 percent(prediction.error.resolution), percent(prediction.error.settling)));
  predicted_->setText(
      tr("predicted: %1 on free processors, error of the whole curve %2 (resolution %3, standard "
         "error %4)")
          .arg(quantityLabel(prediction.seconds, "s", 2), percent(prediction.error.total()),
               percent(prediction.error.resolution), percent(prediction.error.standardError)));
}

/// Drops the diagram of another scene. The diagram does not depend on the method that computes the
/// curve.
void AccuracyPanel::dropOldPicture() {
  if (!pictured_ || comparison_.isBusy()) return;
  Scene same = *pictured_;
  same.accuracy = scene_.accuracy;
  same.ensemble = scene_.ensemble;
  if (haveSameCurve(same, scene_)) return;
  pictured_.reset();
  showInvitation();
}

void AccuracyPanel::showInvitation() {
  picture_->showText(tr("“Compare methods” measures what accuracy costs for this scene."));
}

/// Starts the comparison, or cancels the one that runs.
void AccuracyPanel::compareMethods() {
  if (comparison_.isBusy()) {
    comparison_.cancel();
    showComparing();
    return picture_->showText(tr("cancelled"));
  }
  pictured_ = scene_;
  picture_->showText(comparingText());
  comparison_.request(
      [this, scene = scene_](const BackgroundWork::Run& run) {
        WorkPrecisionOptions options;
        options.lines = 3;
        options.repeats = 3;
        options.stop = run.stop();
        options.progress = run.percents(
            [this](int percent) { compare_->setText(tr("Cancel (%1 %)").arg(percent)); });
        return workPrecisionSheet(workPrecision(scene, options));
      },
      [this](const DiagramSheet& sheet) {
        showComparing();
        picture_->showSheet(sheet);
        dropOldPicture();  // the scene may have changed meanwhile
      },
      [this](const QString& reason) {
        showComparing();
        picture_->showText(reason);
      });
  showComparing();
}

void AccuracyPanel::showComparing() {
  compare_->setText(comparison_.isBusy() ? tr("Cancel") : tr("Compare methods"));
}

}  // namespace asperity
