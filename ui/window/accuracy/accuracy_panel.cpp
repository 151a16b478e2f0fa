#include "ui/window/accuracy/accuracy_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/accuracy/work_precision_sheet.h"
#include "ui/chart/friction_chart.h"
#include "ui/language/translated.h"
#include "ui/panels/number_text.h"
#include "ui/draw/ticks.h"
#include "ui/window/curve/comparison_box.h"
#include "ui/window/curve/region_pictures.h"

namespace asperity {

namespace {

constexpr double kQuick = 0.2, kDecades = 2;  // targets from 20 % to 0.2 %
constexpr int kControlsWidth = 320;

QString percent(double part) {
  return std::isfinite(part)
             ? QString::fromStdString(shortNumber(100 * part, 2)) + QStringLiteral("\u00A0%")
             : QStringLiteral("–");
}

QString seconds(double time) {
  return QString::fromStdString(quantity(time, "s", 2));
}

QLabel* addLine(QVBoxLayout& column, const char* name) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setWordWrap(true);
  column.addWidget(label);
  return label;
}

/// Beside the picture: as wide as its texts need, in the large font of a presentation too. What
/// does not fit the height is reached by a scroll bar.
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

QHBoxLayout* betweenItsEnds(QSlider& slider) {
  auto* line = new QHBoxLayout;
  line->addWidget(new QLabel(AccuracyPanel::tr("quick")));
  line->addWidget(&slider, 1);
  line->addWidget(new QLabel(AccuracyPanel::tr("exact")));
  return line;
}

/// The diagram of this scene in the place of one of the paper's figures.
FigureMaker comparisonOf(const Scene& scene) {
  return [scene](FigureName, const FigureOptions& options) {
    WorkPrecisionOptions wanted;
    wanted.lines = 3;
    wanted.repeats = 3;
    wanted.stop = options.stop;
    wanted.progress = options.progress;
    Figure figure;
    figure.scene = scene;
    figure.sheet = workPrecisionSheet(workPrecision(scene, wanted));
    return figure;
  };
}

}  // namespace

double targetAt(int place) {
  return roundedToDigits(kQuick * std::pow(10, -kDecades * place / kAccuracySteps), 2);
}

int placeOf(double target) {
  const double place = std::log10(kQuick / target) / kDecades * kAccuracySteps;
  return static_cast<int>(std::lround(std::clamp(place, 0.0, 1.0 * kAccuracySteps)));
}

AccuracyPanel::AccuracyPanel(QWidget* parent) : QWidget(parent), slider_(new QSlider) {
  setObjectName("accuracyPanel");
  auto* controls = new QWidget;
  auto* column = new QVBoxLayout(controls);
  column->setContentsMargins(14, 8, 10, 8);
  slider_->setObjectName("accuracySlider");
  slider_->setOrientation(Qt::Horizontal);
  slider_->setRange(0, kAccuracySteps);
  slider_->setAccessibleName(tr("accuracy from quick to exact"));
  connect(slider_, &QSlider::valueChanged, this, [this](int place) { setTarget(targetAt(place)); });
  column->addLayout(betweenItsEnds(*slider_));
  target_ = addLine(*column, "accuracyTarget");
  predicted_ = addLine(*column, "accuracyPredicted");
  measured_ = addLine(*column, "accuracyMeasured");
  column->addStretch(1);
  comparisonBox_ = new ComparisonBox;
  connect(comparisonBox_, &ComparisonBox::settingChanged, this, &AccuracyPanel::comparisonChanged);
  column->addWidget(comparisonBox_);
  free_ = new QPushButton(tr("No target"));
  free_->setObjectName("accuracyFree");
  free_->setToolTip(tr("Scheme, oversampling and realizations as the parameters say"));
  connect(free_, &QPushButton::clicked, this, [this] { setTarget(0); });
  compare_ = new QPushButton(tr("Compare methods"));
  compare_->setObjectName("accuracyCompare");
  compare_->setToolTip(tr("Measures error against time of every method on this scene's lines"));
  connect(compare_, &QPushButton::clicked, this, &AccuracyPanel::compareMethods);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(free_);
  buttons->addWidget(compare_, 1);
  column->addLayout(buttons);

  picture_ = new RegionPictures;
  showInvitation();
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(0, 0, 0, 0);
  auto* scrolled = new ControlColumn(controls);
  scrolled->setAccessibleName(slider_->accessibleName());
  line->addWidget(scrolled);
  line->addWidget(picture_, 1);
}

void AccuracyPanel::showScene(const Scene& scene) {
  scene_ = scene;
  const double target = scene.accuracy.targetRelativeError;
  const QSignalBlocker quiet(slider_);
  slider_->setValue(target > 0 ? placeOf(target) : 0);
  target_->setText(target > 0 ? tr("target: %1 of μ at every velocity").arg(percent(target))
                              : tr("no target: as scheme and realizations say"));
  free_->setEnabled(target > 0);
  comparisonBox_->allow(!choosesAccuracy(scene));
  comparisonBox_->suggestLines(scene.ensemble.realizations);
  dropOldPicture();
  measured_->clear();
  predict();
}

void AccuracyPanel::showMeasured(double time, double standardError, double interval) {
  const bool isSingle = !std::isfinite(standardError) && std::isfinite(interval);
  measured_->setText(
      isSingle ? tr("measured: %1, error %2").arg(seconds(time), percent(interval))
               : tr("measured: %1, standard error %2").arg(seconds(time), percent(standardError)));
}

std::optional<CurveSetting> AccuracyPanel::comparison() const {
  return comparisonBox_->setting();
}

void AccuracyPanel::setComparison(const std::optional<CurveSetting>& setting) {
  comparisonBox_->setSetting(setting);
}

std::optional<ComparedMethods> AccuracyPanel::comparedMethods() const {
  if (!pictured_ || isComparing_ || !picture_->figure()) return std::nullopt;
  return ComparedMethods{*pictured_, picture_->figure(), picture_->chosen()};
}

void AccuracyPanel::showComparedMethods(const ComparedMethods& compared) {
  pictured_ = compared.scene;
  picture_->showFigure(compared.figure);
  picture_->choose(compared.diagram);
  dropOldPicture();
}

void AccuracyPanel::setTheme(const Theme& theme) {
  picture_->setTheme(theme);
}

/// A target leaves the oversampling to the program and needs the scheme that can be refined.
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
  if (prediction_) prediction_->cancel();
}

void AccuracyPanel::predict() {
  if (!isVisible()) return;
  if (!prediction_)
    prediction_ = std::make_unique<PredictionWorker>([this](const PredictionAnswer& answer) {
      QMetaObject::invokeMethod(this, [this, answer] { takePrediction(answer); });
    });
  predicted_->setText(tr("predicting …"));
  asked_ = prediction_->request(scene_);
}

void AccuracyPanel::takePrediction(const PredictionAnswer& answer) {
  if (answer.number != asked_) return;
  if (!answer.prediction) return predicted_->setText(translatedText(answer.reason.toStdString()));
  const Prediction& prediction = *answer.prediction;
  if (prediction.steps > 0)
    return predicted_->setText(
        tr("predicted motion: %1 for %2 steps, error %3 (time step %4, resolution %5, settling %6)")
            .arg(seconds(prediction.seconds))
            .arg(prediction.steps, 0, 'f', 0)
            .arg(percent(prediction.error.total()), percent(prediction.error.timeStep),
                 percent(prediction.error.resolution), percent(prediction.error.settling)));
  predicted_->setText(tr("predicted: %1, error %2 (resolution %3, realizations %4)")
                          .arg(seconds(prediction.seconds), percent(prediction.error.total()),
                               percent(prediction.error.resolution),
                               percent(prediction.error.standardError)));
}

/// Another scene has another diagram; how the curve is computed does not matter to it.
void AccuracyPanel::dropOldPicture() {
  if (!pictured_ || isComparing_) return;
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

/// Starts, or cancels what was started.
void AccuracyPanel::compareMethods() {
  if (isComparing_) return comparison_->stop();
  FigureWorkerEvents events;
  const auto later = [this](auto&& what) { QMetaObject::invokeMethod(this, what); };
  events.progressed = [this, later](FigureName, double part) {
    later([this, part] {
      if (isComparing_) compare_->setText(tr("Cancel (%1 %)").arg(std::lround(100 * part)));
    });
  };
  events.finished = [this, later](std::shared_ptr<const MadeFigure> made) {
    later([this, made] {
      endComparison({});
      picture_->showFigure(made);
      dropOldPicture();  // the scene may have changed meanwhile
    });
  };
  events.failed = [this, later](FigureName, const QString& reason) {
    later([this, reason] { endComparison(reason); });
  };
  events.stopped = [this, later](FigureName) { later([this] { endComparison(tr("cancelled")); }); };
  comparison_ = std::make_unique<FigureWorker>(std::move(events), comparisonOf(scene_));
  isComparing_ = true;
  compare_->setText(tr("Cancel"));
  pictured_ = scene_;
  picture_->showText(tr("measuring every method on this scene's lines …"));
  comparison_->start({});
}

void AccuracyPanel::endComparison(const QString& text) {
  isComparing_ = false;
  compare_->setText(tr("Compare methods"));
  if (!text.isEmpty()) picture_->showText(text);
}

}  // namespace asperity
