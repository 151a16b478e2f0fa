#include "ui/window/main/main_window.h"

#include <QApplication>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QSplitter>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>

#include "core/run/transient_diagram.h"
#include "ui/chart/chart_view.h"
#include "ui/language/translated.h"
#include "ui/panels/parameter_panel.h"
#include "ui/window/accuracy/accuracy_panel.h"
#include "ui/window/accuracy/plan_list.h"
#include "ui/window/curve/curve_reading.h"
#include "ui/window/figures/diagram_view.h"
#include "ui/window/figures/gallery_page.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/contact_canvas.h"
#include "ui/window/main/gesture_counter.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/main/session.h"
#include "ui/window/main/status_line.h"
#include "ui/window/main/tour_bar.h"
#include "ui/window/main/window_sight.h"
#include "ui/window/tasks/latest_work.h"

namespace asperity {

namespace {

constexpr int kPollInterval = 16;  // ms, 60 times a second
constexpr int kUnseenPoll = 250;   // ms, where nobody sees what comes

/// A dock's title in the window's own look.
QWidget* dockTitle(QDockWidget& dock) {
  auto* title = new QWidget;
  title->setObjectName("dockTitle");
  title->setAttribute(Qt::WA_StyledBackground);
  auto* layout = new QHBoxLayout(title);
  layout->setContentsMargins(14, 5, 8, 5);
  layout->addWidget(new QLabel(dock.windowTitle()), 1);
  auto* close = new QToolButton;
  close->setText(QStringLiteral("✕"));
  close->setAccessibleName(MainWindow::tr("close"));
  close->setFocusPolicy(Qt::NoFocus);
  QObject::connect(close, &QToolButton::clicked, &dock, &QDockWidget::close);
  layout->addWidget(close);
  return title;
}

LineSize sizeOf(const Frame& frame) {
  return {frame.length,
          static_cast<std::int64_t>(frame.lineHeight.size()) / pointsPerElement(*frame.scene)};
}

/// One below the other without a gap; the last one takes the room.
QWidget* inColumn(std::initializer_list<QWidget*> widgets) {
  auto* all = new QWidget;
  auto* column = new QVBoxLayout(all);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  for (QWidget* widget : widgets) column->addWidget(widget);
  column->setStretchFactor(*std::rbegin(widgets), 1);
  return all;
}

}  // namespace

MainWindow::MainWindow(const Scene& scene, RunnerOptions options, QWidget* parent)
    : QMainWindow(parent), session_(new Session(scene, options, this)) {
  setObjectName("mainWindow");
  setAcceptDrops(true);
  gestures_ = new GestureCounter(this);
  document_ = new SceneDocument(scene, this);
  canvas_ = new ContactCanvas;
  putTogether();
  setColours(Colours::System);
  showAboutScene();
  showDescription();
  showHistory();
  setMinimumSize(kLeastWindow);
  resize(1280, 800);
  defaultLayout_ = saveState();

  poll_ = new QTimer(this);
  poll_->setTimerType(Qt::PreciseTimer);
  connect(poll_, &QTimer::timeout, session_, &Session::poll);
  sight_ = new WindowSight(*this);
  connect(sight_, &WindowSight::changed, this, &MainWindow::followSight);
  session_->begin();
  poll_->start(kPollInterval);
}

/// Nothing is stepped and drawn for nobody; curves go on.
void MainWindow::followSight() {
  poll_->setInterval(sight_->isSeen() ? kPollInterval : kUnseenPoll);
  session_->setSeen(sight_->isSeen() && !isShowingFigures());
}

MainWindow::~MainWindow() {
  if (presentation_) QApplication::setFont(presentation_->font);  // of other windows, too
}

/// Everything that has words.
void MainWindow::putTogether() {
  parts_ = new QObject(this);
  connectDocument();
  buildViews();
  buildPanel();
  buildActions();
  connectSession();
}

void MainWindow::buildViews() {
  canvas_->setAccessibleName(ContactCanvas::tr("contact view"));
  plot_ = new ChartView;
  plot_->setFocusPolicy(Qt::ClickFocus);  // away from an entry: keys are the window's again
  plot_->setObjectName("frictionPlot");
  plot_->setMinimumHeight(170);
  plot_->setAccessibleName(tr("coefficient of friction against velocity"));
  splitter_ = new QSplitter(Qt::Vertical);
  splitter_->setObjectName("viewSplitter");
  splitter_->setHandleWidth(1);
  splitter_->setChildrenCollapsible(false);
  splitter_->addWidget(canvas_);
  canvas_->show();
  splitter_->addWidget(buildTabs());
  splitter_->setStretchFactor(0, 58);
  splitter_->setStretchFactor(1, 42);
  splitter_->setSizes({580, 420});

  description_ = new MessageBar;
  description_->setObjectName("descriptionBar");
  pages_ = new QStackedWidget;
  pages_->addWidget(inColumn({description_, splitter_}));

  messages_ = new MessageBar;
  hint_ = new MessageBar;
  hint_->setObjectName("hintBar");
  tourBar_ = new TourBar;
  setCentralWidget(inColumn({messages_, hint_, tourBar_, pages_}));

  buildStatus();
}

void MainWindow::buildPanel() {
  panel_ = new ParameterPanel(session_->scene());
  dock_ = new QDockWidget(tr("Parameters"));
  dock_->setObjectName("parameterDock");
  dock_->setWidget(panel_);
  dock_->setTitleBarWidget(dockTitle(*dock_));
  addDockWidget(Qt::RightDockWidgetArea, dock_);
  resizeDocks({dock_}, {panel_->sizeHint().width()}, Qt::Horizontal);
  connect(panel_, &ParameterPanel::sceneEdited, this, &MainWindow::takeStep);
}

void MainWindow::connectSession() {
  connect(session_, &Session::frameArrived, this, &MainWindow::showFrame);
  connect(accuracy_, &AccuracyPanel::sceneEdited, this,
          [this](const Scene& scene) { editScene(scene); });
  connect(session_, &Session::complained, this, [this](const QString& key, const QString& english) {
    complaint_ = {key, english};
    showComplaint();
  });
  connect(session_, &Session::sceneRuns, this, [this] {
    complaint_.reset();
    endFailure(MessageBar::Failure::Scene);
  });
  connect(session_, &Session::sceneRuns, panel_, &ParameterPanel::clearErrors);
  connect(session_, &Session::playingChanged, this, &MainWindow::showPlaying);
  connectView();
  connectChart();
}

void MainWindow::showFrame() {
  const std::shared_ptr<const Frame> frame = session_->frame();
  if (!isShowingFigures()) canvas_->setFrame(frame);
  status_->showFrame(*frame, readCurve(*frame, session_->curve()));
  if (frame->transient && frame->sceneNumber == session_->sceneNumber())
    strips_->setSheet(
        transientSheet(*frame->scene, *frame->transient, frame->spacing, frame->length));
  if (frame->sceneNumber == session_->sceneNumber()) panel_->showLine(sizeOf(*frame));
}

void MainWindow::showComplaint() {
  const auto& [key, english] = *complaint_;
  const QString text = translatedText(english.toStdString());
  messages_->showFailure(MessageBar::Failure::Scene, key.isEmpty() ? text : key + ": " + text);
  panel_->showError(key, text);
}

/// What it may have covered comes to light again.
void MainWindow::endFailure(MessageBar::Failure of) {
  if (messages_->end(of) && complaint_) showComplaint();
}

void MainWindow::showDescription() {
  const QString text = sceneText(session_->scene().description);
  if (text == described_) return;  // closed by hand it stays closed
  described_ = text;
  text.isEmpty() || isTouring_ ? description_->hide() : description_->showMessage(text);
}

void MainWindow::setDark(bool dark) {
  dark_ = dark;
  const Theme& theme = dark ? darkTheme() : lightTheme();
  QApplication::setPalette(paletteOf(theme));
  setStyleSheet(windowStyleSheet(theme));
  canvas_->setTheme(theme);
  plot_->setTheme(theme);
  for (DiagramView* view : {spectrum_, statistics_}) view->setTheme(theme);
  strips_->setTheme(theme);
  accuracy_->setTheme(theme);
  if (gallery_) gallery_->setTheme(theme);
  paintIcons();
}

}  // namespace asperity
