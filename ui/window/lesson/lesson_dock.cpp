#include "ui/window/lesson/lesson_dock.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QMainWindow>
#include <QResizeEvent>
#include <QScrollArea>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "ui/language/language.h"
#include "ui/panels/controls.h"
#include "ui/panels/labels.h"
#include "ui/panels/parameter_panel.h"
#include "ui/window/lesson/lesson_pane.h"

namespace asperity {

namespace {

// The heights in pixels of the pane and of the parameters below it at the start: a step frees only
// a few of them.
constexpr int kDefaultHeight = 390, kParametersHeight = 230;
constexpr int kMinHeight = 220;  // of the pane
constexpr int kUsualRows = 52;   // of the parameters that a step usually frees

/// Returns the height in pixels that the content of an area needs.
int neededHeight(const QScrollArea& area) {
  const QLayout& layout = *area.widget()->layout();
  return layout.hasHeightForWidth() ? layout.totalHeightForWidth(area.viewport()->width())
                                    : layout.minimumSize().height();
}

/// Returns by how many pixels the content of an area is higher than what is shown of it; below 0
/// there is room left.
int hiddenHeight(const QScrollArea& area) {
  return neededHeight(area) - area.viewport()->height();
}

}  // namespace

LessonDock::LessonDock(QMainWindow& window, QDockWidget& parameters, const ParameterPanel& panel)
    : window_(window),
      parameters_(parameters),
      panel_(panel),
      pane_(new LessonPane),
      foot_(named<QDockWidget>("lessonFootDock")),
      title_(new WrappedLabel),
      keep_(named<QToolButton>("lessonKeep")),
      close_(named<QToolButton>("lessonEnd")),
      rows_(panel.findChild<QScrollArea*>()) {
  setObjectName("lessonDock");
  setFeatures(QDockWidget::DockWidgetClosable);
  pane_->setMinimumHeight(kMinHeight);
  setWidget(pane_);
  buildTitleBar();
  rows_->widget()->installEventFilter(this);
  window.addDockWidget(Qt::RightDockWidgetArea, this);
  window.splitDockWidget(this, &parameters, Qt::Vertical);
  foot_->setFeatures(NoDockWidgetFeatures);
  foot_->setTitleBarWidget(new QWidget);
  foot_->setWidget(&pane_->foot());
  window.addDockWidget(Qt::RightDockWidgetArea, foot_);
  // The buttons come after the texts and answers, and before the parameters.
  orderTabs(*pane_->findChild<QLabel*>("lessonScore"), *pane_->foot().layout());
  hide();
  for (QDockWidget* dock : {static_cast<QDockWidget*>(this), foot_})
    dock->toggleViewAction()->setVisible(false);  // they come and go with a lesson
  keepTranslated(*this, [this] {
    setWindowTitle(tr("Lesson"));
    foot_->setWindowTitle(tr("Steps of the lesson"));
    keep_->setToolTip(tr("Keeps your answers in a file of your choice"));
    keep_->setText(tr("Save results…").replace(' ', '\n'));  // it leaves the title its width
    keep_->setAccessibleName(keep_->toolTip());
    close_->setToolTip(tr("Ends the lesson; your own scene comes back"));
    close_->setAccessibleName(tr("end the lesson"));
  });
}

void LessonDock::buildTitleBar() {
  auto* bar = new QWidget;
  bar->setObjectName("dockTitle");
  bar->setAttribute(Qt::WA_StyledBackground);
  auto* line = new QHBoxLayout(bar);
  line->setContentsMargins(14, 5, 8, 5);
  title_->setObjectName("lessonTitle");
  constexpr double kTitleScale = 1.2;  // above that of the steps
  keepHeading(*title_, *bar, kTitleScale);
  title_->installEventFilter(this);
  keep_->setProperty("role", "framed");
  close_->setText(QStringLiteral("✕"));
  line->addWidget(title_, 1);
  line->addWidget(keep_);
  line->addWidget(close_);
  setTitleBarWidget(bar);
  connect(keep_, &QToolButton::clicked, this, &LessonDock::savingRequested);
  connect(close_, &QToolButton::clicked, this, &LessonDock::endRequested);
}

void LessonDock::showTitle(const QString& title) {
  title_->setText(title);
  title_->setToolTip(title);
  pane_->setAccessibleName(title.isEmpty() ? tr("Lesson") : tr("Lesson: %1").arg(title));
}

void LessonDock::begin() {
  // A lesson may begin while the panel is closed; a step that frees parameters opens it.
  parameters_.show();
  window_.addDockWidget(Qt::RightDockWidgetArea, foot_);  // below docks that were moved
  show();
  window_.resizeDocks({this, &parameters_}, {kDefaultHeight, kParametersHeight}, Qt::Vertical);
  isBeginning_ = true;
}

void LessonDock::setVisible(bool isVisible) {
  QDockWidget::setVisible(isVisible);
  foot_->setVisible(isVisible);
}

void LessonDock::shareHeightSoon() {
  QTimer::singleShot(0, this, [this] { shareHeight(); });
}

/// Shares the height again where the title or the parameters need another one. The warning of a
/// parameter appears some time after the step. Nothing moves while the student uses a parameter.
bool LessonDock::eventFilter(QObject* watched, QEvent* event) {
  if (watched == title_ && event->type() == QEvent::Resize) {
    const auto& resized = *static_cast<const QResizeEvent*>(event);
    if (resized.size().height() != resized.oldSize().height()) shareHeightSoon();
  } else if (watched != title_ && event->type() == QEvent::LayoutRequest && !isHidden()) {
    // The rows are measured later: a panel that is being destroyed asks for a layout, too.
    QTimer::singleShot(0, this, [this] { followRows(); });
  }
  return QDockWidget::eventFilter(watched, event);
}

void LessonDock::followRows() {
  const int before = std::exchange(rowsHeight_, neededHeight(*rows_));
  if (before != rowsHeight_ && !panel_.isAncestorOf(QApplication::focusWidget())) shareHeight();
}

/// Moves the border between the pane and the parameters where one of them has to be scrolled while
/// the other has room. Where both have to be, the parameters are shown whole if the pane can give
/// the height: the text may tell the student to move one of them. Where there are too many for
/// that, the text is shown whole above the first of them. Before the answer they are locked, and
/// the question comes first. Elsewhere the border stays: at the beginning, and where it
/// moves for the text, it leaves the parameters no more than the next steps are likely to need, so
/// that it need not move again.
void LessonDock::shareHeight(int corrections) {
  const auto* text = pane_->findChild<QScrollArea*>();
  if (isHidden() || !parameters_.isVisible() || !text) return;
  const int hiddenText = hiddenHeight(*text), hiddenRows = hiddenHeight(*rows_);
  const int most = std::max(0, pane_->height() - kMinHeight);
  int toRows = 0;
  if (pane_->isAsking() && hiddenText > 0) {
    toRows = -std::min(hiddenText, rows_->viewport()->height());
  } else if (hiddenRows > 0) {
    const bool isFirst = hiddenRows <= most && !pane_->isAsking();
    const int spare = std::max(0, rows_->viewport()->height() - kUsualRows);
    toRows = isFirst          ? hiddenRows
             : hiddenText > 0 ? -std::min(hiddenText, spare)
                              : std::min({-hiddenText, hiddenRows, most});
  } else if (std::exchange(isBeginning_, false) || hiddenText > 0) {
    const int room = -hiddenRows, needed = std::min(hiddenText, room);
    const int kept = std::max(0, kUsualRows - neededHeight(*rows_));
    toRows = -std::max({0, needed, room - kept});
  }
  if (toRows == 0) return;
  window_.resizeDocks({this, &parameters_}, {height() - toRows, parameters_.height() + toRows},
                      Qt::Vertical);
  // A scroll bar that came or went has changed the width, and with it the height of the texts.
  if (corrections > 0)
    QTimer::singleShot(0, this, [this, corrections] { shareHeight(corrections - 1); });
}

}  // namespace asperity
