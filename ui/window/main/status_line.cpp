#include "ui/window/main/status_line.h"

#include <QHBoxLayout>
#include <QHelpEvent>
#include <QLocale>
#include <QMenu>
#include <QPainter>
#include <QProgressBar>
#include <QStyle>
#include <QTimer>
#include <QToolButton>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/number_text.h"
#include "core/material/element_law.h"
#include "core/scene/scene_check.h"
#include "ui/chart/friction_chart_model.h"
#include "ui/language/explained.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/number_text.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/curve/curve_reading.h"
#include "ui/window/main/commands.h"
#include "ui/window/main/session.h"

namespace asperity {

namespace {

constexpr int kSaidFor = 5000;         // ms, how long a message is shown
constexpr int kDrawingInterval = 500;  // ms
constexpr int kWorkInterval = 100;     // ms

const QString kStopSign = QStringLiteral("✕"), kAgainSign = QStringLiteral("↻");

double orMissing(double value) {
  return std::isfinite(value) ? value : kNotApplicable;
}

/// Returns the friction of the steady state, or of a motion at this moment.
double presentFriction(const Frame& frame) {
  return frame.transient ? orMissing(frame.tangentialForce / frame.normalForce) : frame.muSteady;
}

/// Returns " (mean 0.001198 ± 0.4 %)", with the digits that the error allows; empty where all lines
/// agree except for rounding.
QString meanText(const CurveReading& reading) {
  constexpr double kRounding = 1e-5;
  const double share = std::abs(reading.error / reading.mu);
  if (!(share > kRounding)) return {};
  const double digits = std::clamp(std::ceil(-std::log10(share)) + 1, 2.0, 5.0);
  return StatusLine::tr(" (mean %1 ± %2 %)")
      .arg(readingLabel(reading.mu, static_cast<int>(digits)),
           shownNumber(roundedToDigits(100 * share, 1)));
}

/// Returns a rate with at most three significant digits: "12,000".
QString rateText(double rate) {
  const QLocale locale(fromUtf8(presentLanguage()));
  return locale.toString(static_cast<qlonglong>(roundedToDigits(rate, 2)));
}

/// Why there is no dimensionless velocity: a short text and a sentence; empty where there is one.
struct Reason {
  QString brief, sentence;
};

Reason whyNoVelocity(const Frame& frame) {
  const ElementKind kind = lawOf(frame.scene->elastomer).kind();
  if (kind == ElementKind::Elastic)
    return {StatusLine::tr("elastic"),
            StatusLine::tr("None here: an elastic body has no relaxation time.")};
  if (kind == ElementKind::Arms)
    return {StatusLine::tr("arms"),
            StatusLine::tr("None here: arms have relaxation times of their own, and Eq. (13) is "
                           "made with the only one of the paper's elastomer.")};
  if (!(frame.rmsHeight > 0) || !(frame.rmsSlope > 0))
    return {StatusLine::tr("flat"), StatusLine::tr("None here: the line has no roughness.")};
  return {};
}

QString velocityTip() {
  return StatusLine::tr(
      "Eq. (13) of the paper: relaxation time × velocity × rms slope / (√2 × rms height); of "
      "a motion at this moment");
}

Work workOf(const Session& session) {
  Work work;
  work.simulationsPerSecond = session.simulationsPerSecond();
  work.progress = session.friction().progress();
  if (session.isWaiting())
    work.state = Work::State::Waiting;
  else if (session.averaging() == Session::Averaging::Running)
    work.state = Work::State::Running;
  else if (session.averaging() == Session::Averaging::Stopped)
    work.state = Work::State::Stopped;
  return work;
}

}  // namespace

double dimensionlessForce(const Frame& frame) {
  return orMissing(frame.normalForce / (lawOf(frame.scene->elastomer).equilibriumModulus *
                                        frame.rmsHeight * frame.length));
}

double dimensionlessVelocity(const Frame& frame) {
  const ElementLaw law = lawOf(frame.scene->elastomer);
  if (law.kind() != ElementKind::Kelvin) return kNotApplicable;
  const double velocity = frame.transient ? frame.velocity : frame.scene->sliding.velocity;
  return orMissing(law.relaxationTime * velocity * frame.rmsSlope /
                   (std::sqrt(2.0) * frame.rmsHeight));
}

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  setAlignment(Qt::AlignRight | Qt::AlignVCenter);
}

QString ElidedLabel::shownText() const {
  const int room = contentsRect().width();
  return fontMetrics().elidedText(text(), Qt::ElideMiddle, room);
}

bool ElidedLabel::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QLabel::event(event);
  const bool isCut = shownText() != text();
  QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(),
                     isCut ? wrappedTip(text()) : QString(), this);
  return true;
}

void ElidedLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  style()->drawItemText(&painter, contentsRect(), static_cast<int>(alignment()), palette(),
                        isEnabled(), shownText(), foregroundRole());
}

StatusLine::StatusLine(QWidget* parent) : QWidget(parent) {
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(12, 3, 12, 3);
  line->setSpacing(20);
  // What is left out first in a narrow window is in the middle, so that nothing else moves.
  mu_ = addFact(*line, "factMu");
  regime_ = addFact(*line, "factRegime");
  force_ = addFact(*line, "factForce");
  velocity_ = addFact(*line, "factVelocity");
  notes_ = new QToolButton;
  notes_->setObjectName("factNotes");
  notes_->setAutoRaise(true);
  notes_->setFocusPolicy(Qt::TabFocus);
  notes_->hide();
  connect(notes_, &QToolButton::clicked, this, [this] {
    QMenu menu(this);
    menu.setObjectName("notesMenu");
    for (const Note note : present_.list())
      menu.addAction(QStringLiteral("⚠ ") + translatedText(sentenceOf(note)));
    menu.exec(notes_->mapToGlobal(QPoint(0, -menu.sizeHint().height())));
  });
  line->addWidget(notes_);
  settling_ = addFact(*line, "factSettling");
  said_ = new ElidedLabel;
  said_->setObjectName("said");
  line->addWidget(said_, 1);
  silence_ = new QTimer(this);
  silence_->setSingleShot(true);
  connect(silence_, &QTimer::timeout, this, [this] {
    said_->setText({});
    fitFacts();
  });
  addWork(*line);
  backend_ = addFact(*line, "factBackend");
  rate_ = addFact(*line, "factRate");
  simulations_ = addFact(*line, "factSimulations");
  showTips();
  keepRooms();
  showWork({});
}

QLabel* StatusLine::addFact(QHBoxLayout& line, const char* name) {
  auto* label = new QLabel;
  label->setObjectName(name);
  line.addWidget(label);
  return label;
}

void StatusLine::showTips() {
  notes_->setAccessibleName(tr("notes on how far the results hold"));
  regime_->setToolTip(
      wrappedTip(tr("Where the velocity lies on the friction curve: regions I to IV of the "
                    "paper, found on the complete curve")));
  mu_->setToolTip(wrappedTip(
      tr("Coefficient of friction of this line, of a motion at this moment; in brackets the mean "
         "of all lines at this velocity with its standard error")));
  force_->setToolTip(wrappedTip(
      tr("Eq. (14) of the paper: normal force / (shear modulus × rms height × length)")));
  velocity_->setToolTip(wrappedTip(velocityTip()));
  settling_->setToolTip(wrappedTip(
      tr("The picture is moving from the previous scene to the steady state that these numbers and "
         "the chart describe. R shows that state at once.")));
  simulations_->setToolTip(tr("Lines computed per second for the curve, each at one velocity"));
  rate_->setToolTip(tr("Pictures of the contact shown in the last second"));
  backend_->setToolTip(
      tr("What draws the contact: the program itself (software) or the graphics card (OpenGL)"));
}

/// Gives readings that come and go with the work their room for good, so that nothing beside them
/// moves when work begins or ends.
void StatusLine::keepRooms() {
  const auto widthOf = [this](const QString& text) {
    return fontMetrics().horizontalAdvance(text);
  };
  const QString number = QStringLiteral("0.00888");
  mu_->setMinimumWidth(
      widthOf(tr("friction μ = %1%2")
                  .arg(number, tr(" (mean %1 ± %2 %)").arg(QStringLiteral("0.0008888"), "0.08"))));
  force_->setMinimumWidth(widthOf(tr("force F̄ = %1").arg(number)));
  velocity_->setMinimumWidth(widthOf(tr("velocity v̄ = %1").arg(number)));
  simulations_->setMinimumWidth(widthOf(tr("%1 simulations/s").arg(rateText(8800000))));
  rate_->setMinimumWidth(widthOf(tr("%1 frames/s").arg(888)));
  for (QLabel* fact : {simulations_, rate_}) fact->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  int widest = 0;
  for (const char* name : {"I", "II", "III", "IV"})
    widest = std::max(widest, widthOf(regionText(name)));
  regime_->setMinimumWidth(widest);
  for (QWidget* widget : std::initializer_list<QWidget*>{progress_, stop_}) {
    QSizePolicy policy = widget->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    widget->setSizePolicy(policy);
  }
}

/// Updates the texts. The readings follow with the next frame, which the main window shows again.
void StatusLine::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange && stop_) keepRooms();
  if (event->type() != QEvent::LanguageChange) return;
  showTips();
  keepRooms();
  showWork(work_);
  if (!backendName_.isEmpty()) showDrawing(framesPerSecond_, backendName_);
}

void StatusLine::follow(const Session& session, const ContactCanvas& canvas) {
  auto* drawing = new QTimer(this);
  connect(drawing, &QTimer::timeout, this,
          [this, &canvas] { showDrawing(canvas.framesPerSecond(), canvas.backendName()); });
  drawing->start(kDrawingInterval);
  auto* work = new QTimer(this);
  connect(work, &QTimer::timeout, this, [this, &session] { showWork(workOf(session)); });
  work->start(kWorkInterval);
}

/// Adds the progress bar. It is thin, and visible only during work, but its height is kept: the
/// views above must not move when a curve begins or ends.
void StatusLine::addWork(QHBoxLayout& line) {
  progress_ = new QProgressBar;
  progress_->setObjectName("workProgress");
  progress_->setTextVisible(false);
  progress_->setFixedSize(90, 6);
  stop_ = new QToolButton;
  stop_->setObjectName("workStop");
  stop_->setAutoRaise(true);
  stop_->setFocusPolicy(Qt::TabFocus);
  connect(stop_, &QToolButton::clicked, this, &StatusLine::pressed);
  auto* room = new QHBoxLayout;
  room->setSpacing(4);
  room->addWidget(progress_);
  room->addWidget(stop_);
  line.addLayout(room);
  QSize size;
  for (const QString& sign : {kStopSign, kAgainSign}) {
    stop_->setText(sign);
    size = size.expandedTo(stop_->sizeHint());
  }
  stop_->setFixedSize(size);
  line.addStrut(size.height());
}

void StatusLine::pressed() {
  if (work_.state == Work::State::Running) emit stopWanted();
  if (work_.state == Work::State::Stopped) emit againWanted();
  if (work_.state == Work::State::Waiting) emit backWanted();
}

void StatusLine::showWork(const Work& work) {
  work_ = work;
  const bool waits = work.state == Work::State::Waiting;
  const bool stands = work.state == Work::State::Stopped;
  progress_->setRange(0, waits ? 0 : 1000);
  progress_->setValue(static_cast<int>(1000 * work.progress));
  progress_->setAccessibleName(waits ? tr("making the line") : tr("progress of the curve"));
  stop_->setText(stands ? kAgainSign : kStopSign);
  const QString text = waits    ? tr("Making the line… Back to the previous scene")
                       : stands ? tr("The curve is not complete: average it again")
                                : tr("Stop averaging the curve");
  stop_->setToolTip(text);
  stop_->setAccessibleName(text);
  progress_->setVisible(work.state != Work::State::Idle);
  stop_->setVisible(work.state != Work::State::Idle);
  simulations_->setText(work.simulationsPerSecond > 0
                            ? tr("%1 simulations/s").arg(rateText(work.simulationsPerSecond))
                            : QString());
  fitFacts();
}

void StatusLine::showFrame(const Frame& frame, const CurveReading& reading) {
  hasRegions_ = frame.scene->sweep.isOfVelocity();
  regime_->setText(reading.regime);
  QString mean;
  if (std::isfinite(reading.mu) && std::isfinite(reading.error)) mean = meanText(reading);
  const QString text =
      hasLocalFriction(*frame.scene) ? tr("deformation μ = %1%2") : tr("friction μ = %1%2");
  mu_->setText(text.arg(readingLabel(presentFriction(frame)), mean));
  force_->setText(tr("force F̄ = %1").arg(readingLabel(dimensionlessForce(frame))));
  showVelocity(frame);
  showNotes(reading.notes);
  settling_->setText(frame.isSettling ? tr("settling") : QString());
  fitFacts();
}

/// Shows that there is something to know, in a few letters; tooltip and menu have all sentences.
/// The sign comes and goes beside the readings, so that no view moves.
void StatusLine::showNotes(const NoteSet& notes) {
  present_ = notes;
  QStringList sentences;
  for (const Note note : notes.list()) sentences += translatedText(sentenceOf(note));
  QString text;
  if (sentences.size() == 1)
    text = tr("⚠ 1 note");
  else if (!sentences.empty())
    text = tr("⚠ %1 notes").arg(sentences.size());
  if (text == notes_->text() && sentences.join('\n') == notes_->accessibleDescription()) return;
  notes_->setText(text);
  notes_->setAccessibleDescription(sentences.join('\n'));
  notes_->setToolTip(wrappedTip(sentences.join(QStringLiteral(". "))));
  fitFacts();
}

/// Shows each reading in full or not at all: in a narrow window the least important ones are left
/// out. A hidden reading returns only with some extra space, so that it does not flicker with the
/// digits of the others. Readings are hidden before others are shown, because Qt lays a line out as
/// soon as a widget in it is shown, and would squeeze the readings of one line too many.
void StatusLine::fitFacts() {
  constexpr int kAir = 40;  // pixels
  const QMargins around = layout()->contentsMargins();
  int room = width() - around.left() - around.right();
  for (const QWidget* work : std::initializer_list<const QWidget*>{progress_, stop_})
    room -= work->width() + layout()->spacing();
  // Friction and what limits it stay, however narrow the window is.
  notes_->setVisible(!present_.empty());
  if (!present_.empty()) room -= notes_->sizeHint().width() + layout()->spacing();
  bool fits = true;
  std::vector<QLabel*> shown;
  // That the picture still settles comes and goes with every change: it hides no other reading.
  for (QLabel* fact : {mu_, regime_, force_, velocity_, simulations_, rate_, backend_, settling_}) {
    const bool isSaidOver =
        silence_->isActive() && (fact == simulations_ || fact == rate_ || fact == backend_);
    // Those that come with the work have their room while they say nothing.
    const bool keepsRoom = fact == simulations_ || (fact == regime_ && hasRegions_);
    if ((fact->text().isEmpty() && !keepsRoom) || isSaidOver) {
      fact->hide();
      continue;
    }
    const int needed =
        std::max(fact->sizeHint().width(), fact->minimumWidth()) + layout()->spacing();
    fits = fits && room >= needed + (fact->isHidden() ? kAir : 0);
    if (fits || fact == mu_)
      shown.push_back(fact);
    else
      fact->hide();
    room -= needed;
  }
  for (QLabel* fact : shown) fact->show();
}

void StatusLine::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitFacts();
}

/// Shows the dimensionless velocity. Where there is none, the reason is shown beside it if there is
/// enough space.
void StatusLine::showVelocity(const Frame& frame) {
  constexpr int kLeastLeft = 4, kAir = 16;  // pixels; different, to avoid flicker
  const QString plain = tr("velocity v̄ = %1").arg(readingLabel(dimensionlessVelocity(frame)));
  const Reason reason = whyNoVelocity(frame);
  velocity_->setToolTip(reason.sentence.isEmpty()
                            ? wrappedTip(velocityTip())
                            : wrappedTip(velocityTip() + QStringLiteral(". ") + reason.sentence));
  if (reason.brief.isEmpty()) return velocity_->setText(plain);
  const QString whole = tr("%1 (%2)").arg(plain, reason.brief);
  const int more = fontMetrics().horizontalAdvance(whole) - fontMetrics().horizontalAdvance(plain);
  const bool isWhole = velocity_->text() == whole;
  const bool hasRoom = isWhole ? said_->width() >= kLeastLeft : said_->width() >= more + kAir;
  velocity_->setText(hasRoom && !velocity_->isHidden() ? whole : plain);
}

void StatusLine::say(const QString& text) {
  said_->setText(text);
  silence_->start(kSaidFor);
  fitFacts();
}

void StatusLine::showDrawing(int framesPerSecond, const QString& backend) {
  framesPerSecond_ = framesPerSecond;
  // A picture at rest has no rate.
  rate_->setText(framesPerSecond == 0   ? QString()
                 : framesPerSecond == 1 ? tr("1 frame/s")
                                        : tr("%1 frames/s").arg(framesPerSecond));
  backendName_ = backend;
  backend_->setText(backend);
  fitFacts();
}

}  // namespace asperity
