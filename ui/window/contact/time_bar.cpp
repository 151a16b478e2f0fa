#include "ui/window/contact/time_bar.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>
#include <algorithm>
#include <cmath>

#include "core/run/runner.h"
#include "ui/draw/ticks.h"
#include "ui/language/language.h"
#include "ui/window/main/commands.h"

namespace asperity {

namespace {

constexpr double kFastest = 2, kSlowest = 600;  // s on the screen for a period
constexpr int kPositions = 240;                 // of the slider of the pace
constexpr int kMoments = 1000;                  // of the slider of the moment

/// A pace's position on the slider: to the right slower.
int positionOf(double pace) {
  return static_cast<int>(
      std::lround(kPositions * std::log(pace / kFastest) / std::log(kSlowest / kFastest)));
}

double paceAt(int position) {
  return kFastest * std::pow(kSlowest / kFastest, static_cast<double>(position) / kPositions);
}

QString quantityText(double seconds) {
  return QString::fromStdString(quantity(seconds, "s"));
}

QString momentText(const QString& time, const QString& duration) {
  return TimeBar::tr("%1 of %2").arg(time, duration);
}

}  // namespace

TimeBar::TimeBar(QWidget* parent)
    : QWidget(parent),
      pace_(RunnerOptions{}.secondsPerPeriod),
      moment_(new QSlider(Qt::Horizontal)),
      slider_(new QSlider(Qt::Horizontal)),
      momentText_(new QLabel),
      name_(new QLabel),
      factor_(new QLineEdit),
      keep_(new QCheckBox) {
  setObjectName("timeBar");
  setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(14, 2, 14, 2);
  row->setSpacing(8);
  moment_->setObjectName("moment");
  moment_->setRange(0, kMoments);
  moment_->setPageStep(kMoments / 20);
  momentText_->setObjectName("momentText");
  slider_->setObjectName("paceSlider");
  slider_->setRange(0, kPositions);
  slider_->setPageStep(kPositions / 12);
  slider_->setFixedWidth(110);
  factor_->setObjectName("slowMotion");
  factor_->setFixedWidth(fontMetrics().horizontalAdvance("00000.00×") + 16);
  keep_->setObjectName("keepPace");
  keep_->setChecked(true);
  row->addWidget(moment_, 1);
  row->addWidget(momentText_);
  row->addStretch(0);
  row->addSpacing(8);
  row->addWidget(name_);
  row->addWidget(slider_);
  row->addWidget(factor_);
  row->addWidget(keep_);
  name_->setBuddy(slider_);

  connect(slider_, &QSlider::valueChanged, this,
          [this](int position) { setPace(paceAt(position)); });
  connect(factor_, &QLineEdit::editingFinished, this, &TimeBar::readFactor);
  connect(moment_, &QSlider::valueChanged, this, [this](int position) {
    if (duration_ > 0) emit momentWanted(duration_ * position / kMoments);
  });
  moment_->installEventFilter(this);
  connect(moment_, &QSlider::sliderPressed, this, [this] {
    emit scrubbing(true);
    emit momentWanted(duration_ * moment_->value() / kMoments);
  });
  connect(moment_, &QSlider::sliderReleased, this, [this] { emit scrubbing(false); });
  keepTranslated(*this, [this] { showTexts(); });
}

bool TimeBar::eventFilter(QObject* watched, QEvent* event) {
  if (watched == moment_ && event->type() == QEvent::MouseButtonPress) {
    const auto* mouse = static_cast<QMouseEvent*>(event);
    const int handle = moment_->style()->pixelMetric(QStyle::PM_SliderLength, nullptr, moment_);
    const QSignalBlocker quiet(moment_);  // the press itself asks for the moment
    if (mouse->button() == Qt::LeftButton)
      moment_->setValue(QStyle::sliderValueFromPosition(
          0, kMoments, qRound(mouse->position().x()) - handle / 2, moment_->width() - handle));
  }
  return QWidget::eventFilter(watched, event);
}

void TimeBar::showTexts() {
  moment_->setAccessibleName(tr("moment of the motion"));
  moment_->setToolTip(wrappedTip(tr("The moment of the motion: drag it to any other one.")));
  slider_->setAccessibleName(tr("slow motion"));
  const QString tip = wrappedTip(
      tr("How much slower than in reality the picture moves; to the right slower. Below 1 it is a "
         "time lapse. Lines of very many elements may move more slowly than this."));
  for (QWidget* part : std::initializer_list<QWidget*>{name_, slider_, factor_})
    part->setToolTip(tip);
  factor_->setAccessibleName(tr("slow motion factor"));
  name_->setText(tr("slow motion"));
  keep_->setText(tr("constant pace"));
  keep_->setToolTip(wrappedTip(
      tr("Keeps the pace of the picture while the velocity changes; otherwise the slow motion "
         "stays, and a faster line looks faster.")));
  showPace();
}

bool TimeBar::keepsPace() const {
  return keep_->isChecked();
}

/// Returns the simulated time of a period or of a motion, s; 0 where nothing moves.
double TimeBar::simulatedTime() const {
  if (scene_.sliding.kind != SlidingKind::Steady) return scene_.sliding.duration;
  const double velocity = std::abs(scene_.sliding.velocity);
  return velocity > 0 ? length_ / velocity : 0;
}

double TimeBar::slowMotion() const {
  const double time = simulatedTime();
  return time > 0 ? pace_ / time : 0;
}

void TimeBar::showScene(const Scene& scene) {
  const double before = slowMotion();
  scene_ = scene;
  duration_ = scene.sliding.kind == SlidingKind::Steady ? 0 : scene.sliding.duration;
  for (QWidget* part : std::initializer_list<QWidget*>{moment_, momentText_})
    part->setVisible(duration_ > 0);
  // The numbers change without moving what is beside them.
  momentText_->setMinimumWidth(momentText_->fontMetrics().horizontalAdvance(
      momentText(QStringLiteral("000.0 ms"), quantityText(duration_))));
  if (!keepsPace() && before > 0)
    setSlowMotion(before);
  else
    showPace();
}

void TimeBar::showFrame(const Frame& frame) {
  if (frame.length != length_) {
    length_ = frame.length;
    showPace();
  }
  if (!(duration_ > 0) || !frame.transient) return;
  time_ = frame.time;
  if (!moment_->isSliderDown()) {
    const QSignalBlocker quiet(moment_);
    moment_->setValue(static_cast<int>(std::lround(kMoments * time_ / duration_)));
  }
  momentText_->setText(momentText(quantityText(time_), quantityText(duration_)));
}

void TimeBar::setPace(double pace) {
  pace = std::clamp(pace, kFastest, kSlowest);
  if (pace != pace_) {
    pace_ = pace;
    emit paceChanged(pace_);
  }
  showPace();
}

void TimeBar::setSlowMotion(double factor) {
  if (factor > 0 && simulatedTime() > 0) setPace(factor * simulatedTime());
}

void TimeBar::showPace() {
  const QSignalBlocker quiet(slider_);
  slider_->setValue(positionOf(pace_));
  const double factor = slowMotion();
  factor_->setEnabled(factor > 0);
  factor_->setText(factor > 0 ? QString::fromStdString(shortNumber(factor)) + QStringLiteral("×")
                              : QStringLiteral("–"));
  factor_->setCursorPosition(0);
}

/// Takes what was typed, "600", "600×" or "1e3 x"; anything else leaves the pace.
void TimeBar::readFactor() {
  static const QRegularExpression ending(QStringLiteral("[\\s×x,]+"));
  bool isNumber = false;
  const QString text = factor_->text().replace(ending, QString());
  const double factor = text.toDouble(&isNumber);
  if (isNumber && std::isfinite(factor) && shortNumber(factor) != shortNumber(slowMotion()))
    setSlowMotion(factor);
  showPace();
}

}  // namespace asperity
