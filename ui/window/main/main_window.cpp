#include "ui/window/main/main_window.h"

#include <QAbstractButton>
#include <QAction>
#include <QCloseEvent>
#include <QDialog>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QMimeData>
#include <QSplitter>
#include <QStatusBar>
#include <QToolButton>
#include <QUrl>

#include "ui/chart/chart_view.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/panels/parameter_panel.h"
#include "ui/window/accuracy/accuracy_panel.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/contact/contact_words.h"
#include "ui/window/contact/motion_view.h"
#include "ui/window/contact/time_bar.h"
#include "ui/window/curve/comparison_commands.h"
#include "ui/window/curve/curve_commands.h"
#include "ui/window/curve/curve_display.h"
#include "ui/window/import/import_commands.h"
#include "ui/window/lesson/lessons.h"
#include "ui/window/lesson/prediction_point.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/commands.h"
#include "ui/window/main/document_commands.h"
#include "ui/window/main/exports.h"
#include "ui/window/main/file_dialogs.h"
#include "ui/window/main/frame_display.h"
#include "ui/window/main/help_commands.h"
#include "ui/window/main/last_session.h"
#include "ui/window/main/main_menus.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/scene_tabs.h"
#include "ui/window/main/session.h"
#include "ui/window/main/session_poll.h"
#include "ui/window/main/status_line.h"
#include "ui/window/main/tour.h"
#include "ui/window/main/window_keys.h"
#include "ui/window/main/window_layout.h"
#include "ui/window/main/window_pages.h"
#include "ui/window/main/work_indicator.h"
#include "ui/window/map/map_panel.h"

namespace asperity {

namespace {

/// Translates the dock's own buttons, whose texts Qt sets only once. The title bar covers them, but
/// screen readers find them.
void translateButtons(const QDockWidget& dock) {
  static constexpr struct {
    const char *object, *name, *description;
  } kButtons[] = {{"qt_dockwidget_floatbutton", "Float", "Undocks and re-attaches the dock widget"},
                  {"qt_dockwidget_closebutton", "Close", "Closes the dock widget"}};
  const auto text = [](const char* english) {
    return QCoreApplication::translate("QDockWidget", english);
  };
  for (const auto& [object, name, description] : kButtons)
    if (auto* button = dock.findChild<QAbstractButton*>(QLatin1String(object))) {
      button->setAccessibleName(text(name));
      button->setAccessibleDescription(text(description));
      if (!button->toolTip().isEmpty()) button->setToolTip(text(name));
    }
}

/// Makes a title bar for a dock in the window's own style.
QWidget* dockTitle(QDockWidget& dock) {
  auto* bar = new TitleBar;
  QObject::connect(&bar->closeButton(), &QToolButton::clicked, &dock, &QDockWidget::close);
  keepTranslated(dock, [&dock, bar] {
    dock.setWindowTitle(MainWindow::tr("Parameters"));
    bar->title().setText(dock.windowTitle());
    bar->closeButton().setAccessibleName(MainWindow::tr("close"));
  });
  return bar;
}

/// Puts widgets below each other without a gap; the last one takes the remaining height.
QWidget* inColumn(Widgets widgets) {
  auto* all = new QWidget;
  auto* column = marginless<QVBoxLayout>(all, 0);
  for (QWidget* widget : widgets) column->addWidget(widget);
  column->setStretchFactor(*std::rbegin(widgets), 1);
  return all;
}

}  // namespace

MainWindow::MainWindow(const Scene& scene, RunnerOptions options, QWidget* parent)
    : QMainWindow(parent),
      session_(new Session(scene, options, this)),
      document_(new SceneDocument(scene, this)),
      canvas_(new ContactCanvas) {
  setObjectName("mainWindow");
  setAcceptDrops(true);
  appearance_ = new Appearance(*this);
  buildViews();
  buildCommands();
  addMenus({*this, *commands_, *documents_, *pages_, *canvas_, *windowLayout_, *curveCommands_,
            *comparisons_, *appearance_, [this](const QString& name) { openShipped(name); },
            [this](std::string_view code) { setLanguage(code); },
            [] {
              return QStringList{tr("Play"), tr("Pause")};
            }});
  connectFrames();
  connectScene();
  connectTime();
  connectCurve();
  new FocusKeys(*this);
  appearance_->announceTheme();
  showScene(scene, true);
  setMinimumSize(kMinWindowSize);
  resize(1280, 800);
  windowLayout_->keepAsDefault();

  new SessionPoll(*session_, *pages_, *this);
  session_->begin();
}

/// The layout restores the font of other windows while all parts of this one still exist. Parts
/// that send a signal while they end must not reach a window that is half gone.
MainWindow::~MainWindow() {
  delete windowLayout_;
  delete frames_;
  for (const QObject* part : findChildren<QObject*>()) part->disconnect(this);
}

ChartView& MainWindow::plotView() {
  return tabs_->plot();
}

// ---- The parts

void MainWindow::buildViews() {
  tabs_ = new SceneTabs(*session_);
  splitter_ = thinSplitter(Qt::Vertical, "viewSplitter");
  timeBar_ = new TimeBar;
  auto* contact = named<QWidget>("contactPage");
  auto* column = marginless<QVBoxLayout>(contact, 0);
  column->addWidget(canvas_, 1);
  column->addWidget(timeBar_);
  splitter_->addWidget(contact);
  splitter_->addWidget(tabs_);
  splitter_->setStretchFactor(0, 58);
  splitter_->setStretchFactor(1, 42);

  description_ = named<MessageBar>("descriptionBar");
  pages_ = new WindowPages(inColumn({description_, splitter_}));
  messages_ = new MessageBar;
  hint_ = named<MessageBar>("hintBar");
  tourBar_ = new TourBar;
  setCentralWidget(inColumn({messages_, hint_, tourBar_, pages_}));

  status_ = new StatusLine;
  status_->monitor(*session_, *canvas_);
  statusBar()->addWidget(status_, 1);
  statusBar()->setSizeGripEnabled(false);
  statusBar()->setContentsMargins(0, 0, 0, 0);

  dock_ = named<QDockWidget>("parameterDock");
  dock_->setTitleBarWidget(dockTitle(*dock_));
  addDockWidget(Qt::RightDockWidgetArea, dock_);
  // The panel gets its final parent at once: Qt evaluates the style of its rows for each parent.
  panel_ = new ParameterPanel(document_->scene(), dock_);
  dock_->setWidget(panel_);
  resizeDocks({dock_}, {panel_->sizeHint().width()}, Qt::Horizontal);
}

/// Adds the commands of the running scene.
void MainWindow::addRunCommands() {
  commands_->add({"play",
                  [this] { return session_->isPlaying() ? tr("Pause") : tr("Play"); },
                  [this] { session_->setPlaying(!session_->isPlaying()); },
                  {Qt::Key_Space},
                  Symbol::Pause});
  commands_->add({"step",
                  [] { return tr("Step"); },
                  [this] { step(QGuiApplication::keyboardModifiers() & Qt::ShiftModifier); },
                  {Qt::Key_Period},
                  Symbol::Step});
  commands_->add({"stepFinely",
                  [] { return tr("Fine step"); },
                  [this] { step(true); },
                  {Qt::SHIFT | Qt::Key_Period, Qt::Key_Greater, Qt::Key_Colon}});
  commands_->add({"reset",
                  [] { return tr("Restart"); },
                  [this] { session_->reset(); },
                  {Qt::Key_R},
                  Symbol::Reset});
  commands_->setTip("reset", [] { return tr("Sets the time to 0 and keeps the parameters"); });
  commands_->add({"describe",
                  [] { return tr("Describe the contact in words"); },
                  [this] { ContactWords::showFor(*session_, *canvas_, *this); },
                  {Qt::CTRL | Qt::Key_D}});
}

void MainWindow::buildCommands() {
  commands_ = new Commands(*this);
  addRunCommands();
  documents_ = new DocumentCommands(*document_, *panel_, *messages_, *this);
  documents_->addTo(*commands_);
  pages_->addTo(*commands_);
  imports_ = new ImportCommands({*this, *document_, *documents_, *panel_, *messages_});
  imports_->addTo(*commands_);
  connect(imports_, &ImportCommands::imported, pages_, &WindowPages::showViews);
  comparisons_ = new ComparisonCommands(
      {*this, *document_, *tabs_, [this] { return imports_->askFriction(); }});
  comparisons_->addTo(*commands_);
  exports_ = new Exports({*this, *document_, *session_, *canvas_, *tabs_, *pages_, *appearance_,
                          *messages_, *status_});
  exports_->addTo(*commands_);
  appearance_->addTo(*commands_);
  windowLayout_ = new WindowLayout({*this, *dock_, *panel_, *splitter_, *canvas_, *tabs_, *pages_,
                                    *appearance_, *messages_, *description_, *hint_});
  windowLayout_->addTo(*commands_);
  tabs_->addTo(*commands_);
  tour_ = new Tour(*document_, *tourBar_, *hint_, *this);
  tour_->addTo(*commands_);
  connect(tour_, &Tour::controlRequested, panel_, &ParameterPanel::reveal);
  lessons_ = new Lessons({*this, *document_, *session_, *canvas_, *panel_, *dock_, *tabs_, *pages_},
                         *messages_);
  lessons_->addTo(*commands_);
  // The offer of the tour is nothing for those who are in a lesson, nor for an audience.
  connect(lessons_, &Lessons::stepShown, hint_, &QWidget::hide);
  connect(commands_->get("present"), &QAction::toggled, hint_, [this](bool isOn) {
    if (isOn) hint_->hide();
  });
  connect(documents_, &DocumentCommands::lessonFound, lessons_, &Lessons::open);
  connect(lessons_, &Lessons::stepShown, this, [this] {
    frames_->showFrame();  // a picture that stands still brings no new readings
  });
  help_ = new HelpCommands(*this, *messages_);
  help_->addTo(*commands_);
  commands_->add({"quit", [] { return tr("Quit"); }, [this] { close(); }, {Qt::CTRL | Qt::Key_Q}});
  curveCommands_ = new CurveCommands(*session_, tabs_->plot(), *exports_, *messages_, this);
  exports_->setCurves(*curveCommands_);
  new AxisChoosers(*session_, tabs_->plot(), *curveCommands_);
}

// ---- Connections: every change of the scene is a change of the document, which informs all parts

void MainWindow::connectScene() {
  const auto edit = [this](const Scene& scene) { document_->edit(scene); };
  connect(panel_, &ParameterPanel::sceneEdited, this, edit);
  connect(panel_, &ParameterPanel::guideRequested, help_, &HelpCommands::openGuide);
  // The connection is queued, because the dock does not know the new minimum width yet.
  connect(
      panel_, &ParameterPanel::widthReleased, this,
      [this](int width) { resizeDocks({dock_}, {width}, Qt::Horizontal); }, Qt::QueuedConnection);
  // Escape in the filter gives the keys of the picture back.
  connect(panel_, &ParameterPanel::filterLeft, canvas_, [this] { canvas_->setFocus(); });
  connect(canvas_, &ContactCanvas::guideRequested, help_, &HelpCommands::openGuide);
  connect(&tabs_->accuracy(), &AccuracyPanel::sceneEdited, this, edit);
  connect(&tabs_->map(), &MapPanel::sceneEdited, this, edit);
  connect(canvas_, &ContactCanvas::sceneEdited, this, edit);
  connect(pages_, &WindowPages::sceneRequested, this,
          [this](const Scene& scene) { document_->open(scene); });
  connect(pages_, &WindowPages::shippedSceneRequested, this, &MainWindow::openShipped);
  connect(pages_, &WindowPages::galleryRequested, this, &MainWindow::openGallery);
  connect(document_, &SceneDocument::opening, messages_, &MessageBar::forget);
  connect(document_, &SceneDocument::sceneChanged, this,
          [this](const Scene& scene, SceneChange change) {
            const bool isOpened = change == SceneChange::Opened;
            if (isOpened) {
              described_.reset();
              panel_->showNotes({});
              panel_->clearFilter();
              // An opened scene is shown at once, so the gallery closes.
              if (pages_->isShowingGallery()) pages_->showViews();
            }
            // A scene that comes from the panel must not replace what is being typed there.
            if (isOpened || !(panel_->scene() == scene)) panel_->setScene(scene);
            session_->setScene(scene,
                               isOpened ? Session::Begin::Restart : Session::Begin::Continue);
            // A scene with a motion plays at once.
            if (isOpened && scene.sliding.kind != SlidingKind::Steady) session_->setPlaying(true);
            showScene(scene, isOpened);
          });
  connect(document_, &SceneDocument::historyChanged, this, &MainWindow::showTitle);
  connect(tour_, &Tour::starting, pages_, &WindowPages::showViews);
  connect(tour_, &Tour::stepShown, description_, &QWidget::hide);
  keepTranslated(*this, [this] {
    for (const QDockWidget* dock : findChildren<QDockWidget*>()) translateButtons(*dock);
    showTitle();
    frames_->showFrame();
  });
}

void MainWindow::openShipped(const QString& name) {
  if (const LibraryScene* entry = findLibraryScene(name)) document_->open({name, {}, entry->scene});
}

void MainWindow::openGallery() {
  pages_->openGallery(document_->origin().shipped);
}

void MainWindow::showScene(const Scene& scene, bool isOpened) {
  canvas_->setScene(scene);
  if (isOpened) {
    canvas_->fit();
    tabs_->plot().fit();
    timeBar_->showOtherScene(scene);
  } else {
    timeBar_->showScene(scene);
  }
  tabs_->showScene(scene);
  showDescription();
  showTitle();
}

/// Shows the description of the scene, unless the user closed the bar and the text is the same.
void MainWindow::showDescription() {
  const std::string& description = document_->scene().description;
  if (description == described_) return;
  described_ = description;
  if (description.empty() || tour_->isRunning())
    description_->hide();
  else
    description_->showMessage([description] { return sceneText(description); });
}

void MainWindow::showTitle() {
  const QString name = document_->name();
  setWindowTitle(name.isEmpty() ? tr("Asperity[*]") : tr("%1[*] – Asperity").arg(name));
  setWindowModified(document_->isChanged());
}

// ---- Signals of the session

void MainWindow::connectFrames() {
  frames_ =
      new FrameDisplay({*session_, *canvas_, *tabs_, *timeBar_, *status_, *panel_,
                        [this] { return lessons_ && lessons_->player().point().isVisible(); }},
                       this);
  connect(session_, &Session::errorOccurred, messages_, &MessageBar::showSceneError);
  connect(messages_, &MessageBar::sceneErrorShown, panel_, &ParameterPanel::showError);
  connect(session_, &Session::sceneRuns, messages_, &MessageBar::sceneRuns);
  connect(session_, &Session::sceneRuns, panel_, &ParameterPanel::clearErrors);
  connect(session_, &Session::playingChanged, this, [this](bool playing) {
    commands_->setSymbol("play", playing ? Symbol::Pause : Symbol::Play);
    commands_->refresh("play");
  });
  connect(canvas_, &ContactCanvas::failed, messages_, &MessageBar::showMessage);
  connect(canvas_, &ContactCanvas::fieldsChanged, this, &MainWindow::requestFields);
  connect(tabs_, &SceneTabs::fieldsChanged, this, &MainWindow::requestFields);
  connect(appearance_, &Appearance::themeChanged, this, [this](const Theme& theme) {
    canvas_->setTheme(theme);
    tabs_->setTheme(theme);
  });
  connect(pages_, &WindowPages::pageChanged, this, [this](bool areViewsCovered) {
    // The space bar presses the buttons of the other page; it does not pause the run behind it.
    for (QAction* action : commands_->get({"play", "step", "stepFinely", "reset", "describe"}))
      action->setEnabled(!areViewsCovered);
    if (!areViewsCovered) canvas_->setFocus();
  });
  connect(&status_->work(), &WorkIndicator::stopRequested, session_, &Session::stopCurve);
  connect(&status_->work(), &WorkIndicator::restartRequested, this, [this] {
    tabs_->beginCurve();
    session_->startCurve();
  });
  connect(&status_->work(), &WorkIndicator::backRequested, this,
          [this] { document_->history().undo(); });
}

void MainWindow::connectTime() {
  connect(timeBar_, &TimeBar::paceChanged, session_, &Session::setPace);
  session_->setPace(timeBar_->requestedPace());
  connect(timeBar_, &TimeBar::seekRequested, session_, &Session::seek);
  connect(timeBar_, &TimeBar::statusMessage, status_, &StatusLine::showMessage);
  connect(canvas_, &ContactCanvas::statusMessage, status_, &StatusLine::showMessage);
  connect(&tabs_->motion(), &MotionView::seekRequested, session_, &Session::seek);
  connect(&tabs_->motion(), &MotionView::stepRequested, timeBar_, &TimeBar::stepMoment);
  // Dragging the slider of time pauses the run, which resumes afterwards if it was playing.
  connect(timeBar_, &TimeBar::scrubbing, this, [this](bool isOn) {
    if (isOn) wasPlaying_ = session_->isPlaying();
    if (isOn && wasPlaying_) session_->setPlaying(false);
    if (!isOn && wasPlaying_) session_->setPlaying(true);
  });
}

/// Requests only the optional values that the contact shows and the statistics count.
void MainWindow::requestFields() {
  session_->requestFields(canvas_->fields() | tabs_->fields());
}

/// Moves the line by a clearly visible part of the view, or by a pixel or two.
void MainWindow::step(bool finely) {
  const double share = finely ? 1.0 / 800 : 1.0 / 50;  // of the width of the view
  const Frame* frame = canvas_->frame();
  const bool isKnown = frame && frame->length > 0;
  session_->singleStep(isKnown ? share * canvas_->viewer().options().view.width / frame->length
                               : share);
}

// ---- The friction curve

void MainWindow::connectCurve() {
  connect(documents_, &DocumentCommands::saved, this,
          [this](const QString& file) { status_->showMessage(savedText(file)); });
  auto* display = new CurveDisplay(*session_, tabs_->plot(), this);
  connect(display, &CurveDisplay::sceneEdited, this, [this](const Scene& scene) {
    const bool isVelocity = scene.sweep.isOfVelocity();
    document_->edit(
        scene, isVelocity ? QT_TRANSLATE_NOOP("asperity::SceneDocument", "Velocity") : nullptr);
  });
  connect(curveCommands_, &CurveCommands::axisChosen, this, [this](const Scene& scene) {
    document_->edit(scene, QT_TRANSLATE_NOOP("asperity::SceneDocument", "Axis of the curve"));
  });
  connect(curveCommands_, &CurveCommands::guideRequested, help_, &HelpCommands::openGuide);
  auto* comparison = new CurveComparison(*session_, *messages_, this);
  connect(&tabs_->accuracy(), &AccuracyPanel::comparisonChanged, this,
          [this, comparison] { comparison->setSetting(tabs_->accuracy().comparison()); });
  new SceneComparisons(*session_, *messages_, this);
}

// ---- Language, dropped files, closing

/// Changes the language. Qt would post the event to every window later; this sends it at once.
void MainWindow::setLanguage(std::string_view code) {
  const std::string_view known = languageFor(code);
  if (known.empty() || known == presentLanguage()) return;
  const std::function<void()> openEditor = lessons_->closeEditorForReopening();
  for (QDialog* dialog : findChildren<QDialog*>(Qt::FindDirectChildrenOnly)) delete dialog;
  useLanguage(known);
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LanguageChange);
  openEditor();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (urls.size() == 1 && urls.front().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (urls.size() != 1 || !urls.front().isLocalFile()) return;
  event->acceptProposedAction();
  imports_->openDropped(urls.front().toLocalFile());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  // All questions come first: the editor would ask while the program ends already.
  if (!lessons_->canClose()) return event->ignore();
  if (!documents_->canClose()) return event->ignore();
  lessons_->close();
  if (windowLayout_->remembers()) saveLastSession(*this);
  windowLayout_->save();
  QMainWindow::closeEvent(event);
}

}  // namespace asperity
