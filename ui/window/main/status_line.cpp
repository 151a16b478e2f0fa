#include "ui/window/main/status_line.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/number_text.h"
#include "core/material/element_law.h"
#include "ui/draw/ticks.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/panels/labels.h"
#include "ui/panels/number_text.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/curve/curve_reading.h"
#include "ui/window/main/work_indicator.h"

namespace asperity {

/// A reading as a whole and, for a narrow window, a brief one.
using StatusForms = std::array<QString, 2>;

/// A reading of the status line: it keeps space for other texts and is never narrower than its own.
class StatusReading : public QLabel {
 public:
  using QLabel::QLabel;

  void setForms(const StatusForms& forms) {
    forms_ = forms;
    setText(forms_[isBrief_]);
  }
  void setForm(const QString& only) { setForms({only, only}); }
  void setBrief(bool isBrief) {
    isBrief_ = isBrief;
    if (text() != forms_[isBrief]) setText(forms_[isBrief]);
  }
  /// Keeps the space of a number in each form, or of the widest of these texts.
  void reserve(const StatusForms& forms) {
    reserved_ = {widestText(*this, {forms[0]}), widestText(*this, {forms[1]})};
    updateGeometry();
  }
  void reserve(const QStringList& texts) {
    reserved_.fill(widestText(*this, texts));
    updateGeometry();
  }
  QSize sizeHint() const override {
    return QLabel::sizeHint().expandedTo({reserved_[isBrief_], 0});
  }
  QSize minimumSizeHint() const override { return QLabel::sizeHint(); }
  int wholeWidth() const { return std::max(reserved_[0], widestText(*this, {forms_[0]})); }

 private:
  StatusForms forms_;
  std::array<int, 2> reserved_{};
  bool isBrief_ = false;
};

namespace {

constexpr int kMessageTime = 5000;     // ms, how long a message is shown
constexpr int kDrawingInterval = 500;  // ms
constexpr int kWorkInterval = 100;     // ms
constexpr int kMeanGap = 10;           // pixels after the mean, beside the usual spacing

double orMissing(double value) {
  return std::isfinite(value) ? value : kNotApplicable;
}

/// Returns the friction of the steady state, or of a motion at this moment.
double presentFriction(const Frame& frame) {
  return frame.transient ? orMissing(frame.state.tangentialForce / frame.state.normalForce)
                         : frame.state.mu;
}

/// Returns ", mean of 32 ≈ 0.001200 ± 0.4 %", of which the mean ends at the first digit of
/// the error; empty where all lines agree except for rounding. At a point of the curve it has a
/// colon.
QString meanText(const CurveReading& reading) {
  constexpr double kRounding = 1e-5;
  const double share = std::abs(reading.error / reading.mu);
  if (!(share > kRounding)) return {};
  const auto decade = [](double value) { return std::floor(std::log10(std::abs(value))); };
  const double last = decade(roundedToDigits(reading.error, 1));
  const double digits = std::clamp(decade(reading.mu) - last + 1, 1.0, 5.0);
  return (reading.isInterpolated ? StatusLine::tr(", mean of %1 ≈ %2 ± %3 %")
                                 : StatusLine::tr(", mean of %1: %2 ± %3 %"))
      .arg(reading.lines)
      .arg(readingLabel(reading.mu, static_cast<int>(digits), Zeros::Keep),
           shownNumber(roundedToDigits(100 * share, 1)));
}

/// Returns "this line μ = 0.00123", or "this line μ → 0.00123" while the picture is still on its
/// way there, in words that tell it from the mean of all lines, where there may be several.
QString frictionText(const Scene& scene, const QString& value, bool isSettling) {
  QString name;
  if (mayHaveManyLines(scene.surface))
    name = hasLocalFriction(scene) ? StatusLine::tr("this line, deformation")
                                   : StatusLine::tr("this line");
  else
    name = hasLocalFriction(scene) ? StatusLine::tr("deformation") : StatusLine::tr("friction");
  return name + (isSettling ? QStringLiteral(" μ → ") : QStringLiteral(" μ = ")) + value;
}

/// Returns a rate with two significant digits: "12,000".
QString rateText(double rate) {
  const QLocale locale(fromUtf8(presentLanguage()));
  return locale.toString(static_cast<qlonglong>(roundedToDigits(rate, 2)));
}

/// These functions return the forms of a number: "force F̄ = 0.034" and "F̄ = 0.034".
StatusForms forceForms(const QString& number) {
  return {StatusLine::tr("force F̄ = %1").arg(number), StatusLine::tr("F̄ = %1").arg(number)};
}
StatusForms velocityForms(const QString& number) {
  return {StatusLine::tr("velocity v̄ = %1").arg(number), StatusLine::tr("v̄ = %1").arg(number)};
}

QString velocityTip() {
  return StatusLine::tr(
      "Eq. (13) of the paper: relaxation time × velocity × rms slope / (√2 × rms height); of "
      "a motion at this moment");
}

QString forceTip() {
  return StatusLine::tr(
      "Eq. (14) of the paper: normal force / (shear modulus × rms height × period)");
}

QString settlingTip() {
  return StatusLine::tr(
      "The picture is moving from the previous scene to the steady state that these numbers and "
      "the chart describe. R shows that state at once.");
}

/// Returns why there is no dimensionless velocity; empty where there is one.
QString missingVelocityReason(const Frame& frame) {
  switch (elementLaw(frame.scene->elastomer).kind()) {
    case ElementKind::Elastic:
      return StatusLine::tr("No velocity v̄ here: an elastic body has no relaxation time.");
    case ElementKind::Arms:
      return StatusLine::tr(
          "No velocity v̄ here: arms have relaxation times of their own, and Eq. (13) is made with "
          "the only one of the paper's elastomer.");
    case ElementKind::Kelvin:
      break;
  }
  const bool isRough = frame.rmsHeight > 0 && frame.rmsSlope > 0;
  return isRough ? QString() : StatusLine::tr("No velocity v̄ here: the line has no roughness.");
}

}  // namespace

double dimensionlessForce(const Frame& frame) {
  return orMissing(dimensionlessForce(lawInput(frame, frame.velocity)));
}

double dimensionlessVelocity(const Frame& frame) {
  if (elementLaw(frame.scene->elastomer).kind() != ElementKind::Kelvin) return kNotApplicable;
  const double velocity = frame.transient ? frame.velocity : frame.scene->sliding.velocity;
  return orMissing(dimensionlessVelocity(lawInput(frame, velocity)));
}

StatusLine::StatusLine(QWidget* parent) : QWidget(parent) {
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(12, 3, 12, 3);
  line->setSpacing(14);
  // The readings that a narrow window leaves out first are in the middle, so that the others do not
  // move.
  mu_ = addReading(*line, "factMu");
  line->addSpacing(kMeanGap);
  regime_ = addReading(*line, "factRegime");
  force_ = addReading(*line, "factForce");
  velocity_ = addReading(*line, "factVelocity");
  notes_ = named<QToolButton>("factNotes");
  notes_->setAutoRaise(true);
  notes_->setFocusPolicy(Qt::TabFocus);
  notes_->hide();
  connect(notes_, &QToolButton::clicked, this, [this] {
    QMenu menu(this);
    menu.setObjectName("notesMenu");
    for (const Message& note : shownNotes_)
      menu.addAction(QStringLiteral("⚠ ") + translatedText(note));
    menu.exec(notes_->mapToGlobal(QPoint(0, -menu.sizeHint().height())));
  });
  line->addWidget(notes_);
  settling_ = addReading(*line, "factSettling");
  message_ = named<ElidedLabel>("statusMessage");
  message_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  line->addWidget(message_, 1);
  messageTimer_ = new QTimer(this);
  messageTimer_->setSingleShot(true);
  connect(messageTimer_, &QTimer::timeout, this, [this] { showMessage({}); });
  work_ = new WorkIndicator;
  line->addWidget(work_);
  // The views above must not move when a curve begins or ends.
  line->addStrut(work_->sizeHint().height());
  backend_ = addReading(*line, "factBackend");
  rate_ = addReading(*line, "factRate");
  simulations_ = addReading(*line, "factSimulations");
  for (StatusReading* reading : {simulations_, rate_})
    reading->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  showTips();
  reserveWidths();
  showWork({});
}

StatusReading* StatusLine::addReading(QHBoxLayout& line, const char* name) {
  auto* label = named<StatusReading>(name);
  line.addWidget(label);
  return label;
}

void StatusLine::showTips() {
  notes_->setAccessibleName(tr("notes on how far the results hold"));
  regime_->setToolTip(
      wrappedTip(tr("Where the velocity lies on the friction curve: regions I to IV of the "
                    "paper, found on the complete curve")));
  showFrictionTip();
  force_->setToolTip(wrappedTip(forceTip()));
  velocity_->setToolTip(wrappedTip(velocityTip()));
  settling_->setToolTip(wrappedTip(settlingTip()));
  simulations_->setToolTip(tr("Lines computed per second for the curve, each at one velocity"));
  rate_->setToolTip(tr("Pictures of the contact shown in the last second"));
  backend_->setToolTip(
      tr("What draws the contact: the program itself (software) or the graphics card (OpenGL)"));
}

/// Sets the tip of the friction, which is always in sight: it has the readings that the window has
/// no room for, and shows that the picture is not there yet.
void StatusLine::showFrictionTip() {
  QString tip = isSettling_ ? settlingTip() + ' ' : QString();
  tip += tr("Coefficient of friction of this line, of a motion at this moment; then the mean "
            "of all lines at this velocity with its standard error. After ≈ it is "
            "interpolated between two points of the curve.") +
         ' ' + errorsInWords();
  QStringList hidden;
  for (const StatusReading* reading : {regime_, force_, velocity_})
    if (std::ranges::find(leftOut_, reading) != leftOut_.end() && !reading->text().isEmpty())
      hidden += reading->text();
  if (!hidden.isEmpty())
    tip += ' ' + tr("This window has no room for: %1.").arg(hidden.join(QStringLiteral(", ")));
  tip = wrappedTip(tip);
  if (tip != mu_->toolTip()) mu_->setToolTip(tip);
}

/// Reserves the width of readings that appear only during work, so that the others do not move when
/// work begins or ends. In a motion, velocity and friction pass through 0, friction has no mean,
/// and notes come and go.
void StatusLine::reserveWidths() {
  const QString power = readingLabel(-8.88e-88);
  const QString number = isOfMotion_ ? power : QStringLiteral("0.00888");
  const QString friction = isOfMotion_ ? power : QStringLiteral("0.000888");
  const QString mean =
      isOfMotion_
          ? QString()
          : tr(", mean of %1 ≈ %2 ± %3 %").arg(888).arg(QStringLiteral("0.0008888"), "0.08");
  QStringList regions;
  for (const char* name : {"I", "II", "III", "IV"}) regions += regionText(name);
  mu_->reserve(QStringList{frictionText({}, friction, false) + mean,
                           frictionText({}, friction, true) + mean});
  regime_->reserve(regions);
  simulations_->reserve(QStringList{tr("%1 simulations/s").arg(rateText(8800000))});
  rate_->reserve(QStringList{tr("%1 frames/s").arg(888)});
  force_->reserve(forceForms(number));
  velocity_->reserve(velocityForms(number));
  const QString notes = notes_->text();
  notes_->setText(tr("⚠ %1 notes").arg(8));
  roomForNotes_ = notes_->sizeHint().width();
  notesWidth_ = isOfMotion_ ? roomForNotes_ : 0;
  notes_->setText(notes);
}

/// Updates the texts. The readings follow with the next frame, which the main window shows again.
void StatusLine::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange && simulations_) reserveWidths();
  if (event->type() != QEvent::LanguageChange) return;
  showTips();
  reserveWidths();
  showWork(work_->work());
  if (!backendName_.isEmpty()) showDrawing(framesPerSecond_, backendName_);
}

void StatusLine::monitor(const Session& session, const ContactCanvas& canvas) {
  auto* drawing = new QTimer(this);
  // A paused window measures its texts only where one of them has changed.
  connect(drawing, &QTimer::timeout, this, [this, &canvas] {
    const int rate = canvas.framesPerSecond();
    const QString name = canvas.backendName();
    if (rate != framesPerSecond_ || name != backendName_) showDrawing(rate, name);
  });
  drawing->start(kDrawingInterval);
  auto* work = new QTimer(this);
  connect(work, &QTimer::timeout, this, [this, &session] {
    if (const Work present = presentWork(session); present != work_->work()) showWork(present);
  });
  work->start(kWorkInterval);
}

void StatusLine::showWork(const Work& work) {
  work_->showWork(work);
  simulations_->setForm(work.simulationsPerSecond > 0
                            ? tr("%1 simulations/s").arg(rateText(work.simulationsPerSecond))
                            : QString());
  fitReadings();
}

void StatusLine::showFrame(const Frame& frame, const CurveReading& reading) {
  const bool isOfMotion = frame.transient != nullptr;
  if (std::exchange(isOfMotion_, isOfMotion) != isOfMotion) reserveWidths();
  regime_->setForm(reading.regime);
  QString mean;
  if (std::isfinite(reading.mu) && std::isfinite(reading.error)) mean = meanText(reading);
  isSettling_ = frame.isSettling;
  mu_->setForm(frictionText(*frame.scene, readingLabel(presentFriction(frame), 3, Zeros::Keep),
                            isSettling_) +
               mean);
  force_->setForms(forceForms(readingLabel(dimensionlessForce(frame))));
  showVelocity(frame);
  showNotes(reading);
  settling_->setForm(isSettling_ ? tr("settling") : QString());
  fitReadings();
}

void StatusLine::clearReadings() {
  for (StatusReading* reading : {mu_, regime_, force_, velocity_, settling_}) reading->setForm({});
  showNotes({});
  fitReadings();
}

void StatusLine::fadeReadings(bool fades) {
  for (QWidget* reading : Widgets{mu_, regime_, force_, velocity_, settling_, notes_})
    reading->setEnabled(!fades);
}

/// Shows the number of notes; tooltip and menu have all sentences. The sign appears beside the
/// readings, so that no view moves.
void StatusLine::showNotes(const CurveReading& reading) {
  shownNotes_.clear();
  if (reading.missedTarget) shownNotes_.push_back(*reading.missedTarget);
  for (const Note note : reading.notes.list()) shownNotes_.push_back(noteSentence(note));
  QStringList sentences;
  for (const Message& note : shownNotes_) sentences += translatedText(note);
  QString text;
  if (sentences.size() == 1)
    text = tr("⚠ 1 note");
  else if (!sentences.empty())
    text = tr("⚠ %1 notes").arg(sentences.size());
  if (text == notes_->text() && sentences.join('\n') == notes_->accessibleDescription()) return;
  notes_->setText(text);
  notes_->setAccessibleDescription(sentences.join('\n'));
  notes_->setToolTip(wrappedTip(sentences.join(QStringLiteral(". "))));
  fitReadings();
}

/// Shows each reading in full or not at all: in a narrow window the numbers of the paper lose their
/// words, and then the less important readings are left out. A reading that was left out at this
/// width returns only with some extra space, so that it does not flicker with the digits of the
/// others. Readings are hidden before others are shown, because Qt lays a line out as soon as a
/// widget in it is shown, and would squeeze the readings of one line too many.
void StatusLine::fitReadings() {
  constexpr int kExtraSpace = 40;  // pixels
  const QMargins margins = layout()->contentsMargins();
  int available = width() - margins.left() - margins.right() - kMeanGap;
  const int work = work_->sizeHint().width() + layout()->spacing();
  chooseForms(available - work);
  // A message takes the place of work that does not run, and of the less important readings.
  const bool hasMessage = messageTimer_->isActive();
  const bool keepsWork = !hasMessage || work_->work().state != Work::State::Idle;
  keepSpaceWhenHidden(*work_, keepsWork);
  if (keepsWork) available -= work;
  if (hasMessage)
    available -= fontMetrics().horizontalAdvance(message_->text()) + 2 * layout()->spacing();
  // Friction and the notes stay even in the narrowest window.
  notes_->setVisible(!shownNotes_.empty());
  const int notes = std::max(notesWidth_, shownNotes_.empty() ? 0 : notes_->sizeHint().width());
  if (notes > 0) available -= notes + layout()->spacing();
  bool fits = true;
  std::vector<StatusReading*> shown;
  const std::vector<StatusReading*> before = std::exchange(leftOut_, {});
  // "Settling" comes last, because it appears after every change and must hide no other reading.
  for (StatusReading* reading :
       {mu_, regime_, force_, velocity_, simulations_, rate_, backend_, settling_}) {
    const bool isBehindMessage =
        hasMessage && (reading == simulations_ || reading == rate_ || reading == backend_);
    // Readings that come and go keep their space while they are empty, so that no other one moves:
    // that of work, and the region, which an unfinished curve and another axis do not have.
    const bool keepsSpace = reading == simulations_ || reading == regime_;
    if ((reading->text().isEmpty() && !keepsSpace) || isBehindMessage) {
      reading->hide();
      continue;
    }
    const int needed = reading->sizeHint().width() + layout()->spacing();
    const bool wasLeftOut = std::ranges::find(before, reading) != before.end();
    fits = fits && available >= needed + (wasLeftOut ? kExtraSpace : 0);
    if (fits || reading == mu_) {
      shown.push_back(reading);
    } else {
      reading->hide();
      leftOut_.push_back(reading);
    }
    available -= needed;
  }
  for (StatusReading* reading : shown) reading->show();
  showFrictionTip();
}

/// Gives the numbers of the paper their brief forms where the whole ones do not fit beside
/// friction, region and notes, whether there are notes or not, so that nothing moves when they
/// come.
void StatusLine::chooseForms(int available) {
  int needed = roomForNotes_ + layout()->spacing();
  for (const StatusReading* reading : {mu_, regime_, force_, velocity_})
    needed += reading->wholeWidth() + layout()->spacing();
  for (StatusReading* reading : {force_, velocity_}) reading->setBrief(needed > available);
}

void StatusLine::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  leftOut_.clear();
  fitReadings();
}

/// Shows the dimensionless velocity. Where there is none the reading is hidden, and the tooltip of
/// the force beside it has the reason.
void StatusLine::showVelocity(const Frame& frame) {
  const double velocity = dimensionlessVelocity(frame);
  velocity_->setForms(std::isfinite(velocity) ? velocityForms(readingLabel(velocity))
                                              : StatusForms());
  const QString reason = missingVelocityReason(frame);
  const QString tip =
      wrappedTip(reason.isEmpty() ? forceTip() : forceTip() + QStringLiteral(". ") + reason);
  if (tip != force_->toolTip()) force_->setToolTip(tip);
}

void StatusLine::showMessage(const QString& text) {
  message_->setText(text);
  if (text.isEmpty())
    messageTimer_->stop();
  else
    messageTimer_->start(kMessageTime);
  leftOut_.clear();  // readings return after a message, which is not the digits of the others
  fitReadings();
}

void StatusLine::showDrawing(int framesPerSecond, const QString& backend) {
  framesPerSecond_ = framesPerSecond;
  // A picture at rest has no rate.
  rate_->setForm(framesPerSecond == 0   ? QString()
                 : framesPerSecond == 1 ? tr("1 frame/s")
                                        : tr("%1 frames/s").arg(framesPerSecond));
  backendName_ = backend;
  backend_->setForm(backend);
  fitReadings();
}

}  // namespace asperity
