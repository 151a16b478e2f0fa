#include "ui/window/main/tour.h"

#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPointer>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <algorithm>
#include <array>
#include <vector>

#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/window/main/commands.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/main/scene_library.h"

namespace asperity {

namespace {

const QString kOffered = QStringLiteral("tour/offered");

}  // namespace

std::span<const TourStep> Tour::steps() {
  static constexpr std::array kSteps{
      TourStep{"pressed", QT_TR_NOOP("Press"),
               QT_TR_NOOP("A rough line rests on rubber: only its highest summits touch."),
               QT_TR_NOOP("Raise the normal force: contacts grow in number and length."),
               "load.normal_force"},
      TourStep{"region_1", QT_TR_NOOP("Slide slowly"),
               QT_TR_NOOP("The rubber has time to come back behind every summit, and friction "
                          "grows in proportion to the velocity."),
               QT_TR_NOOP("Double the velocity: the coefficient of friction doubles."),
               "sliding.velocity"},
      TourStep{"region_3", QT_TR_NOOP("The plateau"),
               QT_TR_NOOP("At higher velocity friction stops growing: it is now set by the "
                          "slope of the line, not by the rubber."),
               QT_TR_NOOP("Change the shear modulus or the force: the height of the "
                          "plateau stays, but its place on the axis moves."),
               "elastomer.shear_modulus"},
      TourStep{"one_sided", QT_TR_NOOP("One-sided contact"),
               QT_TR_NOOP("A single summit shows why: the rubber is too slow to touch its "
                          "trailing side, so it pushes only from the front."),
               QT_TR_NOOP("Lower the velocity to 0.001 m/s: contact becomes even on both "
                          "sides, and friction vanishes."),
               "sliding.velocity"},
      TourStep{"region_4", QT_TR_NOOP("Region IV"),
               QT_TR_NOOP("Faster still, only the tips of the highest summits touch, and they "
                          "are smooth: friction falls again."),
               QT_TR_NOOP("Raise the number of elements: finer tips move the fall "
                          "to higher velocities."),
               "surface.elements"},
      TourStep{"full_contact", QT_TR_NOOP("Complete contact"),
               QT_TR_NOOP("Under a high load the rubber fills every valley, and friction is "
                          "known exactly."),
               QT_TR_NOOP("Raise the velocity until the first valleys open: there the "
                          "straight line ends."),
               "sliding.velocity"},
  };
  return kSteps;
}

// ---- The bar

namespace {

int stepCount() {
  return static_cast<int>(Tour::steps().size());
}

QString stepText(int index) {
  const TourStep& step = Tour::steps()[static_cast<std::size_t>(index)];
  return keptTogether(TourBar::tr("%1 of %2&ensp;<b>%3.</b> %4 <i>Try: %5</i>")
                          .arg(index + 1)
                          .arg(stepCount())
                          .arg(Tour::tr(step.title).toHtmlEscaped(),
                               Tour::tr(step.sentence).toHtmlEscaped(),
                               Tour::tr(step.attempt).toHtmlEscaped()));
}

}  // namespace

TourBar::TourBar(QWidget* parent) : QFrame(parent), text_(named<QLabel>("tourText")) {
  setObjectName("tourBar");
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::RichText);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(16, 6, 10, 6);
  layout->setSpacing(8);
  layout->addWidget(text_, 1);
  back_ = addButton("tourBack");
  next_ = addButton("tourNext");
  end_ = addButton("tourEnd");
  showTexts();
  connect(back_, &QPushButton::clicked, this, [this] { emit stepRequested(step_ - 1); });
  connect(next_, &QPushButton::clicked, this, [this] { emit stepRequested(step_ + 1); });
  connect(end_, &QPushButton::clicked, this, &TourBar::ended);
  hide();
}

void TourBar::showTexts() {
  back_->setText(tr("Back"));
  next_->setText(tr("Next"));
  end_->setText(tr("End"));
  text_->setText(stepText(step_));
}

QPushButton* TourBar::addButton(const char* name) {
  auto* button = named<QPushButton>(name);
  button->setAutoDefault(false);
  button->setFocusPolicy(Qt::TabFocus);
  layout()->addWidget(button);
  return button;
}

void TourBar::showStep(int step) {
  step_ = step;
  text_->setText(stepText(step));
  back_->setEnabled(step > 0);
  next_->setEnabled(step + 1 < stepCount());
  show();
}

void TourBar::keepHeight() {
  QLabel measured(this);
  measured.setFont(text_->font());
  measured.setWordWrap(true);
  measured.setTextFormat(Qt::RichText);
  int height = 0;
  for (int step = 0; step < stepCount(); ++step) {
    measured.setText(stepText(step));
    height = std::max(height, measured.heightForWidth(text_->width()));
  }
  text_->setMinimumHeight(height);
}

void TourBar::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  keepHeight();
}

void TourBar::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) showTexts();
  if (event->type() == QEvent::FontChange || event->type() == QEvent::LanguageChange) keepHeight();
}

// ---- The frame around a control

namespace {

constexpr int kMargin = 5;      // pixels between the control and the outer edge of the frame
constexpr int kSideMargin = 8;  // the same at its sides, where its text begins
constexpr double kWidth = 2.5;  // of the line, pixels
constexpr double kSpotlightCorner = 7;  // radius, pixels

QScrollArea* scrollAreaAround(QWidget& control) {
  for (QWidget* each = control.parentWidget(); each; each = each->parentWidget())
    if (auto* area = qobject_cast<QScrollArea*>(each)) return area;
  return nullptr;
}

}  // namespace

/// A frame that highlights a control. It is drawn over the control, takes no focus and no mouse
/// events, and follows the control when it moves, is resized, hidden or scrolled. A child of the
/// window. Without a control there is no frame.
class HighlightFrame : public QWidget {
 public:
  explicit HighlightFrame(QWidget& window);

  /// Draws the frame around this control of the window and scrolls to it; null: around none.
  void highlight(QWidget* control);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void adjustToControl();
  QRect visiblePart() const;

  QWidget& window_;
  QPointer<QWidget> control_;
  std::vector<QPointer<QWidget>> watched_;  // the control and all widgets around it
};

HighlightFrame::HighlightFrame(QWidget& window) : QWidget(&window), window_(window) {
  setObjectName("halo");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
  hide();
}

void HighlightFrame::highlight(QWidget* control) {
  for (const QPointer<QWidget>& widget : watched_)
    if (widget) widget->removeEventFilter(this);
  watched_.clear();
  control_ = control;
  for (QWidget* each = control; each && each != &window_; each = each->parentWidget()) {
    each->installEventFilter(this);
    watched_.emplace_back(each);
  }
  window_.removeEventFilter(this);
  if (control) {
    window_.installEventFilter(this);
    if (QScrollArea* area = scrollAreaAround(*control)) area->ensureWidgetVisible(control);
  }
  adjustToControl();
}

/// Several widgets may move one after the other; the frame moves once, afterwards.
bool HighlightFrame::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::Move:
    case QEvent::Resize:
    case QEvent::Show:
    case QEvent::Hide:
    case QEvent::ParentChange:
      QMetaObject::invokeMethod(
          this, [this] { adjustToControl(); }, Qt::QueuedConnection);
      break;
    default:
      break;
  }
  return QWidget::eventFilter(watched, event);
}

/// Returns the part of the control that nothing around it cuts off, in pixels of the window.
QRect HighlightFrame::visiblePart() const {
  QRect part(control_->mapTo(&window_, QPoint()), control_->size());
  for (QWidget* each = control_->parentWidget(); each && each != &window_;
       each = each->parentWidget())
    part &= QRect(each->mapTo(&window_, QPoint()), each->size());
  return part;
}

void HighlightFrame::adjustToControl() {
  // A panel that floats is a window of its own.
  const bool isHere = control_ && control_->window() == &window_ && control_->isVisible();
  const QRect part = isHere ? visiblePart() : QRect();
  setVisible(!part.isEmpty());
  if (part.isEmpty()) return;
  setGeometry(part.adjusted(-kSideMargin, -kMargin, kSideMargin, kMargin) & window_.rect());
  raise();
  update();
}

void HighlightFrame::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor colour = palette().color(QPalette::Highlight);
  const QRectF line = QRectF(rect()).adjusted(kWidth, kWidth, -kWidth, -kWidth);
  QColor glow = colour;
  glow.setAlphaF(0.25F);
  painter.setPen(QPen(glow, 2 * kWidth));
  painter.drawRoundedRect(line, kSpotlightCorner, kSpotlightCorner);
  painter.setPen(QPen(colour, kWidth));
  painter.drawRoundedRect(line, kSpotlightCorner, kSpotlightCorner);
}

// ---- The steps

Tour::Tour(SceneDocument& document, TourBar& bar, MessageBar& hint, QWidget& window)
    : QObject(&window),
      document_(document),
      window_(window),
      highlight_(new HighlightFrame(window)),
      bar_(bar),
      hint_(hint) {
  connect(&document_, &SceneDocument::trialEnded, this, &Tour::close);
  connect(&bar_, &TourBar::stepRequested, this, &Tour::show);
  connect(&bar_, &TourBar::ended, this, &Tour::end);
  connect(&hint_, &MessageBar::accepted, this, &Tour::start);
  connect(&hint_, &MessageBar::closed, this, [] { QSettings().setValue(kOffered, true); });
}

void Tour::addTo(Commands& commands) {
  commands_ = &commands;
  commands.add({"tour", [] { return tr("Guided tour"); }, [this] { start(); }});
  // A presenter's remote control sends the second keys.
  commands.add({"tourStepBack",
                [] { return tr("Tour: back"); },
                [this] { show(bar_.step() - 1); },
                {Qt::ALT | Qt::Key_Left, Qt::Key_PageUp}});
  commands.add({"tourStepNext",
                [] { return tr("Tour: next"); },
                [this] { show(bar_.step() + 1); },
                {Qt::ALT | Qt::Key_Right, Qt::Key_PageDown}});
  close();
}

void Tour::offer() {
  if (QSettings().value(kOffered).toBool()) return;
  hint_.showOffer(
      [] {
        return tr(
            "New here? A tour of six steps shows what there is to see. Lessons are under Help.");
      },
      [] { return tr("Take the tour"); });
}

void Tour::start() {
  QSettings().setValue(kOffered, true);
  hint_.hide();
  document_.endTrial();  // a lesson may be running
  emit starting();
  isRunning_ = true;
  show(0);
}

/// Shows a step. Changes that were tried in a step are discarded.
void Tour::show(int step) {
  if (!isRunning_ || step < 0 || step >= stepCount()) return;
  const TourStep& shown = steps()[static_cast<std::size_t>(step)];
  const QString name = QString::fromLatin1(shown.scene);
  const LibraryScene* found = findLibraryScene(name);
  if (!found) return end();
  document_.openTrial({name, {}, found->scene});
  bar_.showStep(step);
  commands_->get("tourStepBack")->setEnabled(step > 0);
  commands_->get("tourStepNext")->setEnabled(step + 1 < stepCount());
  emit stepShown();
  highlight(shown.key);
}

/// Draws the frame around the row of a parameter, once the panel shows the scene's rows.
void Tour::highlight(const char* key) {
  emit controlRequested(QString::fromLatin1(key));
  highlight_->highlight(window_.findChild<QWidget*>(QStringLiteral("row:") + QLatin1String(key)));
}

/// Ends the tour and restores the previous scene.
void Tour::end() {
  if (isRunning_)
    document_.endTrial();
  else
    close();
}

void Tour::close() {
  isRunning_ = false;
  highlight_->highlight(nullptr);
  bar_.hide();
  for (QAction* action : commands_->get({"tourStepBack", "tourStepNext"}))
    action->setEnabled(false);
}

}  // namespace asperity
