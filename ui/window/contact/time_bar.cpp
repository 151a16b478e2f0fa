#include "ui/window/contact/time_bar.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>
#include <QTimer>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/run/runner.h"
#include "ui/draw/ticks.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/panels/labels.h"
#include "ui/panels/number_text.h"
#include "ui/panels/tips.h"

namespace asperity {

namespace {

constexpr double kFastest = 2, kSlowest = 600;       // s on the screen for a period
constexpr int kPositions = 240;                      // of the slider of the pace
constexpr int kMoments = 1000;                       // of the slider of the moment
constexpr int kLongestQuote = 60;                    // letters of what was typed, in a message
constexpr int kEntryMargin = 16;                     // pixels around the text of an entry
constexpr int kTipTime = 8000;                       // ms, how long a refusal stays at the entry
constexpr int kMinTrack = 84;                        // pixels in which a moment can still be chosen
constexpr int kPaceTrack = 110, kMinPaceTrack = 50;  // pixels of the slider of the pace

constexpr double kBehind = 0.7, kAgainOnTime = 0.9;  // of the requested pace
constexpr int kFramesBehind = 5;  // in a row, before the bar reports that the picture is too slow

/// Returns the position of a pace on the slider: faster to the right.
int positionOfPace(double pace) {
  return static_cast<int>(
      std::lround(kPositions * std::log(kSlowest / pace) / std::log(kSlowest / kFastest)));
}

double paceAt(int position) {
  return kSlowest * std::pow(kFastest / kSlowest, static_cast<double>(position) / kPositions);
}

QString slowerText(const QString& number) {
  return TimeBar::tr("%1× slower").arg(number);
}

QString fasterText(const QString& number) {
  return TimeBar::tr("%1× faster").arg(number);
}

/// Returns "600× slower", or "20× faster" where less than reality is needed.
QString paceText(double slowMotion) {
  return slowMotion < 1 ? fasterText(QString::fromStdString(factorText(1 / slowMotion)))
                        : slowerText(QString::fromStdString(factorText(slowMotion)));
}

/// Returns the present moment with the digits that the header of the picture has, "3.80 ms": they
/// neither come nor go while the motion plays.
QString presentText(double time) {
  return QString::fromStdString(quantity(time, "s", 3, Zeros::Keep));
}

/// Returns "t = 3.89 ms of 6 ms", with the symbol that the axis of the charts has.
QString momentText(const QString& time, const QString& duration) {
  return QStringLiteral("t = ") + TimeBar::tr("%1 of %2").arg(time, duration);
}

}  // namespace

TimeBar::TimeBar(QWidget* parent)
    : QWidget(parent),
      pace_(kDefaultPace),
      moment_(named<QSlider>("moment", Qt::Horizontal)),
      slider_(named<QSlider>("paceSlider", Qt::Horizontal)),
      momentText_(named<QLabel>("momentText")),
      behindText_(named<QLabel>("behindText")),
      name_(named<QLabel>("paceName")),
      factor_(named<QLineEdit>("slowMotion")),
      keep_(named<QCheckBox>("keepPace")) {
  setObjectName("timeBar");
  setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(14, 2, 14, 2);
  row->setSpacing(8);
  moment_->setRange(0, kMoments);
  moment_->setPageStep(kMoments / 20);
  slider_->setRange(0, kPositions);
  slider_->setPageStep(kPositions / 12);
  moment_->setMinimumWidth(kMinTrack);
  slider_->setMinimumWidth(kMinPaceTrack);
  slider_->setMaximumWidth(kPaceTrack);
  keep_->setChecked(true);
  row->addWidget(moment_, 1);
  row->addWidget(momentText_);
  row->addStretch(0);
  // A sign alone, for which space is kept: nothing moves when the computer falls behind.
  behindText_->setText(QStringLiteral("⚠"));
  keepSpaceWhenHidden(*behindText_);
  behindText_->hide();
  row->addWidget(behindText_);
  row->addWidget(name_);
  row->addWidget(slider_);
  row->addWidget(factor_);
  row->addWidget(keep_);
  name_->setBuddy(slider_);

  connect(slider_, &QSlider::valueChanged, this,
          [this](int position) { choosePace(paceAt(position)); });
  connect(keep_, &QCheckBox::toggled, this, [this](bool keeps) {
    if (keeps) setLimitedPace(chosen_);
  });
  connect(factor_, &QLineEdit::editingFinished, this, &TimeBar::readFactor);
  connect(moment_, &QSlider::valueChanged, this, [this](int position) {
    if (duration_ > 0) emit seekRequested(duration_ * position / kMoments);
  });
  moment_->installEventFilter(this);
  connect(moment_, &QSlider::sliderPressed, this, [this] {
    emit scrubbing(true);
    emit seekRequested(duration_ * moment_->value() / kMoments);
  });
  connect(moment_, &QSlider::sliderReleased, this, [this] { emit scrubbing(false); });
  keepTranslated(*this, [this] { showTexts(); });
}

bool TimeBar::eventFilter(QObject* watched, QEvent* event) {
  if (watched == moment_ && event->type() == QEvent::ToolTip) {
    const QRect place(moment_->mapToGlobal(QPoint()), moment_->size());
    QToolTip::showText(tipBelow(place, static_cast<QHelpEvent*>(event)->globalX()),
                       wrappedTip(momentWords() + QStringLiteral(". ") + moment_->toolTip()),
                       moment_);
    return true;
  }
  if (watched == moment_ && event->type() == QEvent::MouseButtonPress) {
    const auto* mouse = static_cast<QMouseEvent*>(event);
    const int handle = moment_->style()->pixelMetric(QStyle::PM_SliderLength, nullptr, moment_);
    const QSignalBlocker blocker(moment_);  // the press itself requests the moment
    if (mouse->button() == Qt::LeftButton)
      moment_->setValue(QStyle::sliderValueFromPosition(
          0, kMoments, qRound(mouse->position().x()) - handle / 2, moment_->width() - handle));
  }
  return QWidget::eventFilter(watched, event);
}

void TimeBar::showTexts() {
  moment_->setAccessibleName(tr("moment of the motion"));
  moment_->setToolTip(tr("Drag it to any other moment of the motion."));
  slider_->setAccessibleName(tr("pace of the picture"));
  const QString tip = wrappedTip(
      tr("How many times slower or faster than in reality the picture moves; to the right faster. "
         "A number alone, such as 600, means slower."));
  for (QWidget* part : Widgets{name_, slider_, factor_}) part->setToolTip(tip);
  factor_->setAccessibleName(tr("pace of the picture, times slower or faster than in reality"));
  name_->setText(tr("pace"));
  behindText_->setAccessibleName(tr("the computer cannot keep up"));
  behindText_->setToolTip(
      wrappedTip(tr("The line has too many elements to move as fast as requested. The number is "
                    "the pace that the picture has.")));
  keep_->setText(tr("constant pace"));
  keep_->setToolTip(wrappedTip(
      tr("The picture moves as fast as before when the velocity changes. Without it a faster line "
         "also looks faster.")));
  setWidths();
  showPace();
}

void TimeBar::setWidths() {
  // A longer pace, which is rare, widens the entry.
  const QString usual = QStringLiteral("000,000");
  factor_->setFixedWidth(widestText(*this, {slowerText(usual), fasterText(usual), shown_}) +
                         kEntryMargin);
  fit();
}

/// Returns the width without what gives way to the rest: the name of the pace and the duration.
QSize TimeBar::minimumSizeHint() const {
  QSize size = QWidget::minimumSizeHint();
  if (!name_->isHidden()) size.rwidth() -= nameWidth();
  if (showsDuration_) size.rwidth() -= durationWidth();
  return size;
}

int TimeBar::nameWidth() const {
  return name_->sizeHint().width() + layout()->spacing();
}

/// Returns the width of the longest text of a moment.
int TimeBar::momentWidth(bool withDuration) const {
  const QString longest = QStringLiteral("000.0 ms");
  return widestText(*this,
                    {withDuration ? momentText(longest, quantityLabel(duration_, "s")) : longest});
}

int TimeBar::durationWidth() const {
  return duration_ > 0 ? momentWidth(true) - momentWidth(false) : 0;
}

/// Shows the name of the pace and then the duration, which the axis of the charts has too, where
/// there is space for them.
void TimeBar::fit() {
  showsDuration_ = false;
  momentText_->setMinimumWidth(momentWidth(false));
  const int spare = width() - minimumSizeHint().width();
  const bool showsName = spare >= nameWidth();
  name_->setVisible(showsName);
  showsDuration_ = duration_ > 0 && spare - (showsName ? nameWidth() : 0) >= durationWidth();
  momentText_->setMinimumWidth(momentWidth(showsDuration_));
  showMoment();
}

QString TimeBar::momentWords() const {
  return momentText(presentText(time_), quantityLabel(duration_, "s"));
}

void TimeBar::showMoment() {
  momentText_->setText(showsDuration_ ? momentWords() : presentText(time_));
  moment_->setAccessibleDescription(momentWords());  // its own value is a position
}

void TimeBar::stepMoment(double part) {
  moment_->setValue(moment_->value() + static_cast<int>(std::lround(part * kMoments)));
}

void TimeBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fit();
}

void TimeBar::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) setWidths();
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

void TimeBar::takeScene(const Scene& scene) {
  scene_ = scene;
  duration_ = scene.sliding.kind == SlidingKind::Steady ? 0 : scene.sliding.duration;
  for (QWidget* part : Widgets{moment_, momentText_}) part->setVisible(duration_ > 0);
  setWidths();
}

void TimeBar::showScene(const Scene& scene) {
  const double before = slowMotion();
  takeScene(scene);
  if (keepsPace())
    setLimitedPace(chosen_);
  else if (before > 0 && simulatedTime() > 0)
    setLimitedPace(before * simulatedTime());
  else
    showPace();
}

void TimeBar::showOtherScene(const Scene& scene) {
  takeScene(scene);
  // Its slow motion has nothing to do with that of the previous scene.
  if (chosen_) chosen_ = std::min(*chosen_, kSlowestFirstPace);
  setLimitedPace(chosen_);
}

void TimeBar::showFrame(const Frame& frame, std::optional<double> requested) {
  if (frame.length != length_ || frame.spacing != spacing_) {
    length_ = frame.length;
    spacing_ = frame.spacing;
    if (keepsPace())
      setLimitedPace(chosen_);
    else
      showPace();
  }
  showDelay(frame);
  if (!(duration_ > 0) || !frame.transient) return;
  if (!moment_->isSliderDown()) {
    const QSignalBlocker blocker(moment_);
    const double moment = requested.value_or(frame.time);
    moment_->setValue(static_cast<int>(std::lround(kMoments * moment / duration_)));
  }
  time_ = frame.time;
  showMoment();
}

/// Shows the pace that the picture has where that is much slower than the requested one, so that
/// the header of the picture and the bar show the same number.
void TimeBar::showDelay(const Frame& frame) {
  if (!(frame.timeScale > 0) || !(slowMotion() > 0)) return;
  const double reached = frame.timeScale * slowMotion();
  framesBehind_ = reached < (reachedScale_ > 0 ? kAgainOnTime : kBehind) ? framesBehind_ + 1 : 0;
  const double before =
      std::exchange(reachedScale_, framesBehind_ >= kFramesBehind ? frame.timeScale : 0);
  if (reachedScale_ != before) showPace();
}

/// Sets a pace, or the nearest possible one; none: the usual one of the scene.
void TimeBar::setLimitedPace(std::optional<double> pace) {
  if (pace) pace = std::clamp(*pace, kFastest, kSlowest);
  const double next = pace.value_or(usualPace(scene_.sliding, spacing_));
  if (next != pace_) {
    pace_ = next;
    framesBehind_ = 0;
    reachedScale_ = 0;
  }
  if (std::exchange(requested_, pace) != pace) emit paceChanged(pace);
  showPace();
}

void TimeBar::choosePace(double pace) {
  setLimitedPace(pace);
  chosen_ = pace_;
}

void TimeBar::setSlowMotion(double factor) {
  if (factor > 0 && simulatedTime() > 0) choosePace(factor * simulatedTime());
}

void TimeBar::showPace() {
  const QSignalBlocker blocker(slider_);
  slider_->setValue(positionOfPace(pace_));
  const double requested = slowMotion();
  const double factor = reachedScale_ > 0 ? 1 / reachedScale_ : requested;
  behindText_->setVisible(reachedScale_ > 0);
  for (QWidget* part : Widgets{slider_, factor_}) part->setEnabled(requested > 0);
  shown_ = requested > 0 ? paceText(factor) : QStringLiteral("–");
  slider_->setAccessibleDescription(shown_);  // its own value is a position
  setWidths();
  if (factor_->hasFocus() && factor_->isModified()) return;  // the user is typing
  if (factor_->text() == shown_) return;
  factor_->setText(shown_);
  factor_->setCursorPosition(0);
}

/// Shows a sentence where the pace was typed, after the events that may end the typing, which hide
/// tooltips.
void TimeBar::showMessage(const QString& sentence) {
  QTimer::singleShot(0, factor_, [this, sentence] {
    if (factor_->isVisible())
      QToolTip::showText(factor_->mapToGlobal(QPoint(0, 0)), wrappedTip(sentence), factor_, {},
                         kTipTime);
  });
  emit statusMessage(sentence);
}

/// Reads the typed pace, "600", "1e3 x slower" or "20× faster". Any other text leaves the pace, and
/// a pace beyond the limits becomes the nearest one; in both cases a message explains it.
void TimeBar::readFactor() {
  static const QRegularExpression form(
      QStringLiteral("^\\s*([0-9.,eE+]+|[0-9.,]+[eE]-[0-9]+)\\s*[×x]?\\s*(\\p{L}*)\\s*$"));
  const QString text = factor_->text().trimmed();
  factor_->setModified(false);
  if (text == shown_) return;
  const QRegularExpressionMatch typed = form.match(text);
  // The words "slower" and "faster" of the present language, without a number.
  const auto endsWithWord = [&](const QString& shown) {
    return !typed.captured(2).isEmpty() && shown.endsWith(typed.captured(2));
  };
  bool isNumber = false;
  const double number = withoutGroups(typed.captured(1)).toDouble(&isNumber);
  const bool isFaster = endsWithWord(fasterText(QString()));
  const bool isKnown =
      isFaster || typed.captured(2).isEmpty() || endsWithWord(slowerText(QString()));
  const double factor = isFaster && number > 0 ? 1 / number : number;
  if (isNumber && isKnown && std::isfinite(factor) && factor > 0) {
    setSlowMotion(factor);
    if (paceText(factor) != paceText(slowMotion()))
      showMessage(tr("“%1” is beyond what the picture can show, %2 to %3; %4 is chosen")
                      .arg(text.left(kLongestQuote), paceText(kFastest / simulatedTime()),
                           paceText(kSlowest / simulatedTime()), paceText(slowMotion())));
  } else {
    showMessage(tr("“%1” is not a pace; enter 600, 600× slower or 20× faster")
                    .arg(text.left(kLongestQuote)));
  }
  showPace();
}

}  // namespace asperity
