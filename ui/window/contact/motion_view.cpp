#include "ui/window/contact/motion_view.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/run/motion_table.h"
#include "core/run/transient_diagram.h"
#include "core/scene/motion.h"
#include "core/scene/provenance.h"
#include "ui/chart/chart_view.h"
#include "ui/draw/picture_file.h"
#include "ui/draw/ticks.h"
#include "ui/language/language.h"
#include "ui/panels/controls.h"
#include "ui/panels/number_text.h"
#include "ui/panels/tips.h"
#include "ui/window/figures/diagram_files.h"

namespace asperity {

namespace {

constexpr double kReach = 24;  // pixels from a point of the loop

std::span<const TransientSample> samplesOf(
    const std::shared_ptr<const std::vector<TransientSample>>& samples) {
  return samples ? std::span(*samples) : std::span<const TransientSample>();
}

/// Returns "t = 0.2 s".
QString equation(const QString& name, double value, const char* unit) {
  return name + " = " + quantityLabel(value, unit);
}

/// Gives the first strip the velocities of the whole motion, which are known before it is played.
void showAllVelocities(DiagramSheet& sheet, const Sliding& sliding) {
  const Motion motion(sliding);
  const double quarter = motion.isSmooth() ? 0.25 / sliding.frequency : 0;
  double slowest = motion.velocityAt(0), fastest = slowest;
  for (const double time : {quarter, 3 * quarter, motion.duration()}) {
    if (time > motion.duration()) continue;
    slowest = std::min(slowest, motion.velocityAt(time));
    fastest = std::max(fastest, motion.velocityAt(time));
  }
  if (!(slowest < fastest)) return;
  axisEnds(slowest, fastest, 0).setOn(sheet.diagrams.front().y);
}

}  // namespace

MotionView::MotionView(QWidget* parent)
    : QWidget(parent),
      strips_(named<ChartView>("motionStrips")),
      loop_(named<ChartView>("frictionLoop")),
      stripFiles_(new DiagramFiles(*strips_)),
      loopFiles_(new DiagramFiles(*loop_)) {
  auto* row = marginless<QHBoxLayout>(this, 0);
  row->addWidget(strips_, 3);
  row->addWidget(loop_, 2);
  loop_->hide();
  for (ChartView* chart : {strips_, loop_}) {
    chart->setFocusPolicy(Qt::TabFocus);  // their menus; a click leaves the keys to the contact
    chart->setMouseTracking(true);
    chart->installEventFilter(this);
    chart->setContextMenuPolicy(Qt::ActionsContextMenu);
  }
  strips_->addActions(stripFiles_->actions());
  loop_->addActions(loopFiles_->actions());
  keepTranslated(*this, [this] {
    strips_->setAccessibleName(
        tr("velocity, friction, indentation and length per contact in time"));
    loop_->setAccessibleName(tr("loop of friction over velocity"));
  });
}

void MotionView::showScene(const Scene& scene) {
  duration_ = scene.sliding.kind == SlidingKind::Steady ? 0 : scene.sliding.duration;
  samples_.reset();
  later_.reset();
  for (DiagramFiles* files : {stripFiles_, loopFiles_}) files->setDiagram({});
  loop_->setVisible(scene.sliding.kind == SlidingKind::Oscillation);
  if (!(duration_ > 0)) return;
  DiagramSheet strips = transientSheet(scene, {});
  showAllVelocities(strips, scene.sliding);
  strips_->setSheet(strips);
  if (!loop_->isHidden()) loop_->setSheet(frictionLoopSheet({}));
}

void MotionView::showFrame(const Frame& frame) {
  if (!frame.transient) return;
  samples_ = frame.transient;
  later_ = frame.later;
  const auto strips = [scene = frame.scene, samples = samples_, later = later_,
                       spacing = frame.spacing, length = frame.length] {
    DiagramSheet sheet = transientSheet(*scene, *samples, spacing, length, samplesOf(later));
    showAllVelocities(sheet, scene->sliding);
    return sheet;
  };
  const auto loop = [samples = samples_, later = later_] {
    return frictionLoopSheet(*samples, samplesOf(later));
  };
  strips_->setSheet(strips());
  if (!loop_->isHidden()) loop_->setSheet(loop());
  // The rows are means over parts of the motion, and those of `asperity motion` single steps: a
  // file that is saved here names the command, but no options, and so cannot be remade.
  const auto origin = [scene = frame.scene] { return pictureOrigin("motion", *scene); };
  const auto table = [scene = frame.scene, samples = samples_, later = later_] {
    MotionTable rows;
    rows.lines = {*samples};
    if (later) rows.lines[0].insert(rows.lines[0].end(), later->begin(), later->end());
    // The sample at time 0, where the curves begin, repeats the means of the first step.
    std::erase_if(rows.lines[0], [](const TransientSample& sample) { return sample.time == 0; });
    rows.hasInterface = hasLocalFriction(*scene);
    return provenanceComment("motion", *scene) + motionCsv(rows);
  };
  for (ChartView* chart : {strips_, loop_})
    if (chart->hasFocus() && !samples_->empty())
      chart->setAccessibleDescription(reading(samples_->back()));
  stripFiles_->setDiagram({"motion", origin, table, strips});
  loopFiles_->setDiagram({"friction_loop", origin, table, loop});
}

std::optional<double> MotionView::momentAt(QPointF position) const {
  if (strips_->sheet().diagrams.empty()) return {};
  const DiagramAxis& y = strips_->sheet().diagrams.front().y;
  const double height = 0.5 * (y.from + y.to);
  const double left = strips_->mapToPosition(0, height).x(),
               right = strips_->mapToPosition(duration_, height).x();
  if (!(left < right) || position.x() < left - 1 || position.x() > right + 1) return {};
  return std::clamp((position.x() - left) / (right - left), 0.0, 1.0) * duration_;
}

const TransientSample* MotionView::sampleAt(const ChartView& chart, QPointF position) const {
  if (chart.sheet().diagrams.empty()) return nullptr;
  const bool isLoop = &chart == loop_;
  // A sample is found over the strips only, not over their titles.
  const std::optional<double> moment = isLoop ? std::nullopt : momentAt(position);
  if (!isLoop && !moment) return nullptr;
  double nearest = isLoop ? kReach : std::numeric_limits<double>::infinity();
  const TransientSample* found = nullptr;
  const auto consider = [&](const TransientSample& sample) {
    double away = 0;
    if (isLoop) {
      if (!(sample.normalForce > 0)) return;
      const QPointF at =
          chart.mapToPosition(sample.velocity, sample.tangentialForce / sample.normalForce) -
          position;
      away = std::hypot(at.x(), at.y());
    } else {
      away = std::abs(sample.time - *moment);
    }
    if (!(away < nearest)) return;
    nearest = away;
    found = &sample;
  };
  for (const Samples& part : {samples_, later_})
    for (const TransientSample& sample : samplesOf(part)) consider(sample);
  return found;
}

QString MotionView::reading(const TransientSample& sample) const {
  QStringList lines{equation("t", sample.time, "s"), equation("v", sample.velocity, "m/s")};
  if (std::isfinite(sample.mu)) lines += QStringLiteral("μ = ") + readingLabel(sample.mu);
  lines += equation("d", sample.indentation, "m");
  lines += tr("normal force %1").arg(quantityLabel(sample.normalForce, "N"));
  lines += tr("in contact %1 %").arg(readingLabel(100 * sample.contactFraction));
  return lines.join('\n');
}

/// Asks for another moment. Returns whether the key does this.
bool MotionView::step(const QKeyEvent& event) {
  constexpr double kStep = 1e-2, kFineStep = 1e-3;  // parts of the motion
  const bool isRight = event.key() == Qt::Key_Right;
  if (!isRight && event.key() != Qt::Key_Left) return false;
  const double step = event.modifiers() & Qt::ShiftModifier ? kFineStep : kStep;
  emit stepRequested(isRight ? step : -step);
  return true;
}

bool MotionView::eventFilter(QObject* watched, QEvent* event) {
  auto* chart = static_cast<ChartView*>(watched);
  if (event->type() == QEvent::MouseMove) {
    const auto* mouse = static_cast<QMouseEvent*>(event);
    const TransientSample* sample = sampleAt(*chart, mouse->position());
    if (sample && mouse->buttons() == Qt::NoButton) {
      const QString text = reading(*sample);
      const QRect place(chart->mapToGlobal(QPoint()), chart->size());
      const int x = chart->mapToGlobal(mouse->position().toPoint()).x();
      QToolTip::showText(tipAbove(text, place, x), text, chart);
    } else {
      QToolTip::hideText();
    }
  } else if (event->type() == QEvent::MouseButtonPress && chart == strips_) {
    const auto* mouse = static_cast<QMouseEvent*>(event);
    pressed_.reset();
    if (mouse->button() == Qt::LeftButton) pressed_ = mouse->position();
  } else if (event->type() == QEvent::MouseButtonRelease && chart == strips_ && pressed_) {
    const auto* mouse = static_cast<QMouseEvent*>(event);
    const bool isClick = (mouse->position() - *pressed_).manhattanLength() < 4;
    pressed_.reset();
    if (const auto moment = momentAt(mouse->position()); isClick && moment)
      emit seekRequested(*moment);
  } else if (event->type() == QEvent::KeyPress && step(*static_cast<QKeyEvent*>(event))) {
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace asperity
