#include "ui/window/lesson/lessons.h"

#include <QAction>
#include <QDateTime>
#include <QDockWidget>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QTimer>
#include <QToolButton>
#include <QWindow>
#include <algorithm>
#include <utility>

#include "core/base/input_error.h"
#include "core/scene/parameters.h"
#include "core/scene/sweep.h"
#include "ui/chart/chart_view.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/number_text.h"
#include "ui/panels/parameter_panel.h"
#include "ui/panels/scene_files.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/curve/curve_commands.h"
#include "ui/window/figures/figure_pages.h"
#include "ui/window/lesson/kept_lessons.h"
#include "ui/window/lesson/lesson_editor.h"
#include "ui/window/lesson/lesson_list.h"
#include "ui/window/lesson/lesson_pane.h"
#include "ui/window/lesson/lesson_results_page.h"
#include "ui/window/lesson/lesson_text.h"
#include "ui/window/lesson/prediction_point.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/commands.h"
#include "ui/window/main/document_commands.h"
#include "ui/window/main/fitted_labels.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/picture_files.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/scene_tabs.h"
#include "ui/window/main/session.h"

namespace asperity {

namespace {

// The heights in pixels of the pane and of the parameters below it: a step frees only a few of
// them.
constexpr int kDefaultHeight = 430, kParametersHeight = 230;
constexpr int kMinHeight = 260;    // of the pane
constexpr int kLongestTitle = 60;  // letters, in the name of a file

/// Returns the scene with the title of the step: its own title may reveal the answer.
Scene titledByStep(Scene scene, const LessonStep& step) {
  scene.title = shown(step.title);
  scene.description.clear();
  return scene;
}

/// Shows a window before all others of the program.
void bringToFront(QWidget& window) {
  // The window system may have left a window off the screen that is to be visible.
  const QWindow* handle = window.windowHandle();
  if (window.isVisible() && !window.isMinimized() && handle && !handle->isExposed()) window.hide();
  if (window.isMinimized())
    window.showNormal();
  else
    window.show();
  window.raise();
  window.activateWindow();
}

}  // namespace

Lessons::Lessons(const Parts& parts)
    : QObject(&parts.window),
      parts_(parts),
      dock_(new QDockWidget),
      title_(new WrappedLabel),
      keep_(new QToolButton),
      close_(new QToolButton),
      pane_(new LessonPane),
      point_(new PredictionPoint(parts.tabs.plot())) {
  buildDock();
  connect(pane_, &LessonPane::backRequested, this, [this] { show(step_ - 1); });
  connect(pane_, &LessonPane::nextRequested, this, &Lessons::next);
  connect(pane_, &LessonPane::answered, this,
          [this](const GivenAnswer& given) { answer(given, false); });
  connect(pane_, &LessonPane::solutionRequested, this, [this] { answer({}, true); });
  connect(point_, &PredictionPoint::placed, this, [this] { pane_->setPointPlaced(true); });
  // Another scene was opened, or the tour begins.
  connect(&parts_.document, &SceneDocument::trialEnded, this, &Lessons::end);
  connect(&parts_.document, &SceneDocument::sceneChanged, this,
          [this](const Scene& scene, SceneChange change) {
            if (isRunning() && change == SceneChange::Edited) lockControls(scene);
          });
}

Lessons::~Lessons() = default;

void Lessons::buildDock() {
  dock_->setObjectName("lessonDock");
  dock_->setFeatures(QDockWidget::DockWidgetClosable);
  pane_->setMinimumHeight(kMinHeight);
  dock_->setWidget(pane_);
  auto* bar = new QWidget;
  bar->setObjectName("dockTitle");
  bar->setAttribute(Qt::WA_StyledBackground);
  auto* line = new QHBoxLayout(bar);
  line->setContentsMargins(14, 5, 8, 5);
  title_->setObjectName("lessonTitle");
  keep_->setObjectName("lessonKeep");
  close_->setObjectName("lessonEnd");
  close_->setText(QStringLiteral("✕"));
  line->addWidget(title_, 1);
  line->addWidget(keep_);
  line->addWidget(close_);
  dock_->setTitleBarWidget(bar);
  connect(keep_, &QToolButton::clicked, this, &Lessons::askResultsFile);
  connect(close_, &QToolButton::clicked, this, &Lessons::leave);
  parts_.window.addDockWidget(Qt::RightDockWidgetArea, dock_);
  parts_.window.splitDockWidget(dock_, &parts_.parameters, Qt::Vertical);
  dock_->hide();
  dock_->toggleViewAction()->setVisible(false);  // it comes and goes with a lesson
  keepTranslated(*dock_, [this] {
    dock_->setWindowTitle(tr("Lesson"));
    keep_->setToolTip(tr("Keeps your answers in a file of your choice"));
    keep_->setText(tr("Save results…"));
    keep_->setAccessibleName(tr("Save results…"));
    close_->setToolTip(tr("Ends the lesson; your own scene comes back"));
    close_->setAccessibleName(tr("end the lesson"));
    if (isRunning()) {
      // The scene has the step's title, and keeps what the student changed.
      Scene scene = parts_.document.scene();
      scene.title = shown(present().title);
      if (!(scene == parts_.document.scene())) parts_.document.edit(scene);
      showPage();
    }
    showTitle();
  });
}

void Lessons::addTo(Commands& commands) {
  commands_ = &commands;
  commands.add(
      {"lessons", [] { return tr("Lessons…"); }, [this] { showList(); }, {Qt::CTRL | Qt::Key_L}});
  commands.add({"lessonBackStep",
                [] { return tr("Lesson: back"); },
                [this] {
                  if (isRunning() && step_ > 0) show(step_ - 1);
                },
                {Qt::CTRL | Qt::ALT | Qt::Key_Left}});
  commands.add({"lessonNextStep",
                [] { return tr("Lesson: next"); },
                [this] {
                  if (isRunning() && isRevealed()) next();
                },
                {Qt::CTRL | Qt::ALT | Qt::Key_Right}});
  commands.add({"lessonEnd", [] { return tr("End the lesson"); }, [this] { leave(); }});
  commands.add({"lessonEditor", [] { return tr("Lesson editor…"); },
                [this] {
                  if (LessonEditor* open = editor())
                    bringToFront(*open);
                  else
                    openEditor(lesson_ ? written_ : Lesson{}, lesson_ ? file_ : QString());
                }});
  for (QAction* action : commands.get({"lessonBackStep", "lessonNextStep", "lessonEnd"}))
    action->setEnabled(false);
  // The usual layout has no lesson, but a lesson that runs keeps its pane.
  connect(commands.get("restoreLayout"), &QAction::triggered, this, [this] {
    if (isRunning()) dock_->show();
  });
}

LessonList& Lessons::showList() {
  for (LessonList* open : parts_.window.findChildren<LessonList*>()) delete open;
  auto* list = new LessonList(&parts_.window);
  list->setAttribute(Qt::WA_DeleteOnClose);
  connect(list, &LessonList::lessonRequested, this, [this](const QString& name) { open(name); });
  connect(list, &LessonList::resultsRequested, this, &Lessons::openResults);
  connect(list, &LessonList::editorRequested, this, [this](const QString& name) {
    try {
      openEditor(readNamedLesson(name.toStdString(), readNamedScene),
                 QFileInfo::exists(name) ? name : QString());
    } catch (const std::exception& error) {
      parts_.messages.showFailure(MessageBar::Failure::Files, translatedError(error));
    }
  });
  list->open();
  return *list;
}

LessonEditor* Lessons::editor() const {
  return parts_.window.findChild<LessonEditor*>(QString(), Qt::FindDirectChildrenOnly);
}

LessonEditor& Lessons::showEditor(const Lesson& lesson, const QString& file) {
  if (LessonEditor* open = editor()) {
    // It is hidden during a trial.
    if (!open->isVisible() || !open->canClose()) {
      bringToFront(*open);
      return *open;
    }
    delete open;
  }
  LessonEditor& made = makeEditor(lesson, file);
  made.show();
  return made;
}

LessonEditor& Lessons::makeEditor(const Lesson& lesson, const QString& file) {
  const auto shownNow = [this]() -> std::optional<LessonStep> {
    const auto* pages = parts_.window.findChild<FigurePages*>();
    if (pages && pages->isShowingScenes()) return std::nullopt;
    LessonStep step;
    step.scene = withAbsoluteFiles(parts_.document.scene());
    step.scene.folder.clear();  // a lesson in any folder finds them
    step.revealedScene = step.scene;
    const auto tab = static_cast<std::size_t>(std::max(0, parts_.tabs.currentIndex()));
    if (tab < std::size(kLessonTabs)) step.show.tab = kLessonTabs[tab];
    const FrictionChartModel& chart = parts_.session.friction();
    step.show.quantity = std::string(quantityEntry(chart.quantity()).word.text());
    step.show.isLinearY = chart.isLinearY();
    return step;
  };
  auto* editor = new LessonEditor(lesson, file, shownNow, &parts_.window);
  editor->setAttribute(Qt::WA_DeleteOnClose);
  connect(editor, &LessonEditor::trialRequested, this,
          [this, editor](const Lesson& edited, int step) {
            // The editor is hidden during the lesson, and shown again when that ends.
            start(edited, step, Purpose::Trial);
            hideDuringLesson(*editor);
          });
  return *editor;
}

LessonEditor& Lessons::openEditor(const Lesson& lesson, const QString& file) {
  const std::optional<LessonDraft> draft = editor() ? std::nullopt : keptDraft();
  if (!draft) return showEditor(lesson, file);
  QString title = plainText(draft->lesson.title);
  if (title.isEmpty()) title = tr("(no title)");
  if (!wantsToGoOn("draftQuestion",
                   tr("The lesson “%1” was changed in the editor and not saved before the program "
                      "ended. Go on with it?")
                       .arg(title))) {
    forgetDraft();
    return showEditor(lesson, file);
  }
  LessonEditor& made = makeEditor(draft->saved, QString::fromStdString(draft->file));
  made.showDraft(draft->lesson);
  made.show();
  return made;
}

/// Asks whether work of an earlier session is to be continued; else it is lost.
bool Lessons::wantsToGoOn(const QString& name, const QString& question) const {
  QMessageBox box(QMessageBox::Question, tr("Asperity"), {},
                  QMessageBox::Yes | QMessageBox::Discard, &parts_.window);
  box.setObjectName(name);
  box.setTextFormat(Qt::PlainText);  // titles are not markup
  box.setText(question);
  box.setInformativeText(tr("What you discard is lost."));
  box.setDefaultButton(QMessageBox::Yes);
  box.setEscapeButton(QMessageBox::Yes);
  box.button(QMessageBox::Yes)->setText(tr("&Go on"));
  box.button(QMessageBox::Discard)->setText(tr("&Discard"));
  return box.exec() != QMessageBox::Discard;
}

void Lessons::hideDuringLesson(LessonEditor& editor) {
  editor.hide();
  connect(
      this, &Lessons::ended, &editor, [&editor] { bringToFront(editor); },
      Qt::SingleShotConnection);
}

std::function<void()> Lessons::closeEditorForReopening() {
  LessonEditor* open = editor();
  if (!open) return [] {};
  const LessonEditor::Session session = open->session();
  const bool isVisible = open->isVisible();
  delete open;
  return [this, session, isVisible] {
    LessonEditor& again = makeEditor(session.saved, session.file);
    again.restoreSession(session);
    if (isVisible)
      again.show();
    else
      hideDuringLesson(again);
  };
}

/// Returns why a lesson cannot be opened, and for a draft how it can be completed.
QString Lessons::failureText(const QString& file, const std::exception& error) const {
  const QString reason = translatedError(error);
  if (!isLessonFile(file.toStdString())) return reason;
  try {
    readDraftFile(file.toStdString(), readNamedScene);
  } catch (const std::exception&) {
    return reason;
  }
  return tr("This lesson cannot be played yet; Help > Lesson editor > Open completes it. %1")
      .arg(reason);
}

bool Lessons::open(const QString& nameOrFile) {
  try {
    if (isResultsFile(nameOrFile.toStdString())) {
      showLessonResults(parts_.window, nameOrFile);
      parts_.messages.end(MessageBar::Failure::Files);
      return true;
    }
    const Lesson lesson = readNamedLesson(nameOrFile.toStdString(), readNamedScene);
    if (!mayLeave()) return false;
    offerAnswers(lesson);
    start(lesson);
    if (QFileInfo::exists(nameOrFile)) file_ = QFileInfo(nameOrFile).absoluteFilePath();
    parts_.messages.end(MessageBar::Failure::Files);
    return true;
  } catch (const std::exception& error) {
    parts_.messages.showFailure(MessageBar::Failure::Files, failureText(nameOrFile, error));
    return false;
  }
}

bool Lessons::openResults(const QStringList& files) {
  try {
    showClassResults(parts_.window, files);
    parts_.messages.end(MessageBar::Failure::Files);
    return true;
  } catch (const std::exception& error) {
    parts_.messages.showFailure(MessageBar::Failure::Files, translatedError(error));
    return false;
  }
}

/// Offers the answers that an earlier session left in no file. Those of this session come back
/// without a question.
void Lessons::offerAnswers(const Lesson& lesson) {
  if (left_.contains(lesson.digest)) return;
  const std::optional<LessonResults> kept = keptAnswers(lesson);
  if (!kept) return;
  const QString date = QString::fromStdString(kept->date).replace('T', ' ');
  if (wantsToGoOn("answersQuestion", tr("This lesson was begun before (%1), and its answers are in "
                                        "no file. Go on with these answers?")
                                         .arg(date)))
    left_[lesson.digest] = *kept;
  else
    forgetAnswers(lesson);
}

void Lessons::start(const Lesson& lesson, int step, Purpose purpose) {
  if (lesson.steps.empty()) return;
  end();
  parts_.document.endTrial();  // the tour may be running
  const FrictionChartModel& chart = parts_.session.friction();
  Before before{{}, chart.quantity(), chart.isLinearY(), parts_.tabs.currentIndex(), false, {}};
  for (const PinnedCurve& pinned : chart.pinned()) before.pinned.push_back(pinned.curve);
  if (auto* axes = parts_.window.findChild<QAction*>("dimensionlessAxes")) {
    before.hasDimensionlessAxes = axes->isChecked();
    axes->setChecked(false);
  }
  // The texts of lessons speak of the pressure that glows.
  if (auto* canvas = parts_.window.findChild<ContactCanvas*>()) {
    before.overlay = canvas->viewer().overlay();
    canvas->setOverlay(ContactOverlay::Pressure);
  }
  before_ = std::move(before);
  written_ = lesson;
  lesson_ = std::make_unique<Lesson>(withWholeQuestions(written_));
  answers_.clear();
  results_ = emptyResults(*lesson_);
  isTrial_ = purpose == Purpose::Trial;
  const auto left = isTrial_ ? decltype(left_)::node_type() : left_.extract(lesson_->digest);
  if (left) results_ = left.mapped();
  resultsFile_.clear();
  isSaved_ = false;
  file_.clear();
  // A lesson may begin while the panel is closed; a step that frees parameters opens it.
  parts_.parameters.show();
  dock_->show();
  parts_.window.resizeDocks({dock_, &parts_.parameters}, {kDefaultHeight, kParametersHeight},
                            Qt::Vertical);
  commands_->get("lessonEnd")->setEnabled(true);
  parts_.session.setPlaying(true);
  show(std::clamp(step, 0, static_cast<int>(lesson_->steps.size()) - 1));
  if (left) pane_->showNote(tr("Your answers from before are here."));
}

bool Lessons::isRevealed() const {
  return !isRunning() || !present().prediction || results_.find(step_) != nullptr;
}

void Lessons::show(int step) {
  if (!isRunning() || step < 0 || step >= static_cast<int>(lesson_->steps.size())) return;
  step_ = step;
  waiting_.reset();
  finding_.cancel();
  showScene();
  // The text of a step may describe a movement, so its picture moves.
  if (!present().sceneName.empty() || !present().sceneJson.empty()) parts_.session.setPlaying(true);
  showChart();
  showPage();
  if (point_->isVisible() && !isRevealed())
    point_->setFocus();
  else
    pane_->focusStep();
  if (present().prediction && !answers_.contains(step_)) findAnswer();
  commands_->get("lessonBackStep")->setEnabled(step_ > 0);
  emit stepShown();
}

void Lessons::showPage() {
  LessonPage page;
  page.lesson = lesson_.get();
  page.step = step_;
  const LessonStep& step = present();
  const LessonResult* result = results_.find(step_);
  if (step.prediction && step.prediction->answer)
    page.unit = lessonValueUnit(*step.prediction->answer, step.scene);
  const auto known = answers_.find(step_);
  if (result) {
    page.answer = known != answers_.end() ? &known->second : &result->expected;
    page.given = &result->given;
    page.isRight = result->isRight;
  }
  if (step_ + 1 == static_cast<int>(lesson_->steps.size()) && isRevealed()) page.remark = summary();
  pane_->showStep(page);
  if (point_->point() && !result) pane_->setPointPlaced(true);
  commands_->get("lessonNextStep")->setEnabled(isRevealed());
  showTitle();
}

QString Lessons::summary() const {
  // A trial may be of one step, so the others do not count.
  const int asked =
      isTrial_ ? static_cast<int>(results_.results.size()) : predictionCount(*lesson_);
  if (asked == 0) return {};
  const int shown = results_.shown();
  QString score = shown == 0 ? tr("You were right in %1 of %2 predictions.")
                  : shown == 1
                      ? tr("You were right in %1 of %2 predictions; 1 was shown to you.")
                      : tr("You were right in %1 of %2 predictions; %3 were shown to you.");
  score = score.arg(results_.right()).arg(asked);
  if (shown > 1) score = score.arg(shown);
  return "<p><b>" + score + "</b></p>";
}

void Lessons::showTitle() {
  const QString title = isRunning() ? plainText(lesson_->title) : QString();
  title_->setText(title);
  title_->setToolTip(title);
  pane_->setAccessibleName(title.isEmpty() ? tr("Lesson") : tr("Lesson: %1").arg(title));
}

void Lessons::showScene() {
  const LessonStep& step = present();
  const Scene scene = titledByStep(isRevealed() ? step.revealedScene : step.scene, step);
  parts_.document.openTrial({{}, {}, scene});
  showControls();
  const auto tab = std::ranges::find(kLessonTabs, step.show.tab) - std::begin(kLessonTabs);
  if (QWidget* page = parts_.tabs.widget(static_cast<int>(tab)))
    if (auto* action = parts_.window.findChild<QAction*>("go:" + page->objectName()))
      action->trigger();
}

/// Frees and locks the controls. Before the prediction is made all are locked: trying them would
/// reveal the answer.
void Lessons::showControls() {
  std::map<std::string, RowAccess> access;
  const LessonControls& controls = present().controls;
  const auto rowAccess = [&](ControlState state) {
    if (state == ControlState::Hidden) return RowAccess::Hidden;
    return state == ControlState::Free && isRevealed() ? RowAccess::Free : RowAccess::Locked;
  };
  access["*"] = rowAccess(controls.others);
  for (const auto& [keys, state] : {std::pair(&controls.free, ControlState::Free),
                                    {&controls.locked, ControlState::Locked},
                                    {&controls.hidden, ControlState::Hidden}})
    for (const std::string& key : *keys) access[key] = rowAccess(state);
  parts_.panel.setRowAccess(access);
}

/// Undoes a change of a control that is not free.
void Lessons::lockControls(const Scene& scene) {
  LessonControls controls = present().controls;
  if (!isRevealed()) controls = {{}, {}, {}, ControlState::Locked};
  const Scene shown =
      titledByStep(isRevealed() ? present().revealedScene : present().scene, present());
  const std::vector<std::string_view> changed = lockedChanges(controls, shown, scene);
  if (changed.empty()) return;
  const Scene held = withinControls(controls, shown, scene);
  const QString name = translatedText(findParameter(changed.front())->label);
  QTimer::singleShot(0, this, [this, held, name] {
    if (!isRunning()) return;
    parts_.document.edit(held);
    pane_->showNote(isRevealed() ? tr("“%1” is locked in this step.").arg(name)
                                 : tr("First make your guess; then you can try it."));
  });
}

void Lessons::showChart() {
  const LessonStep& step = present();
  const LessonView& view = step.show;
  const bool hides = view.hidesCurve && (!isRevealed() || !step.prediction || view.hidesCurveAfter);
  comparisons_.cancel();
  parts_.tabs.plot().fit();
  parts_.session.editCurve([&](FrictionChartModel& plot) {
    plot.unpinAll();
    plot.setQuantity(*findQuantity(view.quantity));
    plot.setLinearY(view.isLinearY);
    plot.conceal(hides ? std::optional<AxisRange>({view.hiddenFrom, view.hiddenTo}) : std::nullopt);
    // The axis on which the student made the guess stays when the curve appears.
    plot.reachOver(view.hidesCurve && !hides
                       ? std::optional<AxisRange>({view.hiddenFrom, view.hiddenTo})
                       : std::nullopt);
  });
  parts_.tabs.setCurveHidden(hides);
  if (!view.beside.empty()) {
    const Scene scene = step.scene;
    comparisons_.request(
        [scene, beside = view.beside](const BackgroundWork::Run& run) {
          std::vector<std::shared_ptr<const CurveUpdate>> curves;
          for (const std::vector<std::string>& keys : beside)
            curves.push_back(computeCurveToPin(withKeys(scene, keys), run.stop()));
          return curves;
        },
        [this](const std::vector<std::shared_ptr<const CurveUpdate>>& curves) {
          parts_.session.editCurve([&](FrictionChartModel& plot) {
            for (const auto& curve : curves) plot.pin(curve);
          });
        },
        [this](const QString& reason) { pane_->showNote(reason); });
  }
  const bool isPoint = step.prediction && step.prediction->kind == PredictionKind::Point;
  const LessonResult* result = results_.find(step_);
  if (!isPoint)
    point_->dismiss();
  else if (!result)
    point_->ask(step.prediction->x, plainText(step.prediction->question));
  else if (result->given.isGiven())
    point_->showDecided(step.prediction->x.value_or(result->given.x), result->given.number);
  else
    point_->showDecided(step.prediction->x.value_or(result->expected.x.value),
                        result->expected.number.value, PredictionPoint::Whose::Computed);
}

// ---- Answers

void Lessons::findAnswer() {
  finding_.request(
      [step = present()](const BackgroundWork::Run& run) {
        CurveOptions options;
        options.stop = run.stop();
        return lessonAnswer(step, options);
      },
      [this, step = step_](const LessonAnswer& answer) { takeAnswer(step, answer); },
      [this](const QString& reason) {
        waiting_.reset();
        pane_->setWaiting(false);
        pane_->showNote(reason);
      });
}

void Lessons::takeAnswer(int step, const LessonAnswer& answer) {
  answers_[step] = answer;
  if (step != step_) return;
  if (waiting_) return settle(*std::exchange(waiting_, std::nullopt));
  if (isRevealed()) showPage();  // the result is from a file, and its texts get their values now
}

/// Takes the user's answer. givesUp: the user asks for the solution without a guess.
void Lessons::answer(GivenAnswer given, bool givesUp) {
  if (!isRunning() || isRevealed() || waiting_) return;
  if (present().prediction->kind == PredictionKind::Point && !givesUp && point_->point()) {
    given.x = point_->point()->x();
    given.number = point_->point()->y();
  }
  if (answers_.contains(step_)) return settle(given);
  waiting_ = given;
  pane_->setWaiting(true);
  findAnswer();
}

/// Compares the answer with the computed one, keeps the result and shows it.
void Lessons::settle(const GivenAnswer& given) {
  const LessonPrediction& prediction = *present().prediction;
  const LessonAnswer& expected = answers_.at(step_);
  results_.set(
      {step_, prediction.kind, given, expected, asperity::isRight(prediction, expected, given)});
  isSaved_ = false;
  results_.date = QDateTime::currentDateTime().toString(Qt::ISODate).toStdString();
  writeResultsFile();
  keepUnsavedAnswers();
  showScene();
  showChart();
  showPage();
  pane_->focusStep();
  emit stepShown();
}

void Lessons::next() {
  if (step_ + 1 < static_cast<int>(lesson_->steps.size()))
    show(step_ + 1);
  else
    leave();
}

// ---- Results

bool Lessons::hasUnsavedAnswers() const {
  return isRunning() && !isSaved_ && !isTrial_ &&
         std::ranges::any_of(results_.results,
                             [](const LessonResult& one) { return one.given.isGiven(); });
}

/// Keeps answers against a crash until they are in a file.
void Lessons::keepUnsavedAnswers() const {
  if (isTrial_) return;
  if (hasUnsavedAnswers())
    keepAnswers(results_);
  else
    forgetAnswers(*lesson_);
}

bool Lessons::mayLeave() {
  if (!hasUnsavedAnswers()) return true;
  switch (askSaveChanges(&parts_.window, "resultsQuestion", tr("Asperity"),
                         tr("Save your answers?"),
                         tr("They go into a file of your choice. Otherwise they are lost."))) {
    case SaveAnswer::Save:
      askResultsFile();
      return isSaved_;
    case SaveAnswer::Discard:
      results_ = emptyResults(*lesson_);
      keepUnsavedAnswers();
      return true;
    case SaveAnswer::Cancel:
      break;
  }
  return false;
}

bool Lessons::canClose() {
  LessonEditor* open = editor();
  if (!open || open->canClose()) return mayLeave();
  bringToFront(*open);  // it says why the lesson could not be saved
  return false;
}

void Lessons::close() {
  delete editor();
  end();
}

/// Ends the lesson, unless the student decides to stay in it.
void Lessons::leave() {
  if (isRunning() && mayLeave()) end();
}

/// Returns the name that is proposed for the results: with the title in the language of the window
/// and with the time, so that the files of a class can be collected in one folder.
QString Lessons::resultsName() const {
  QString title = plainText(lesson_->title);
  static const QRegularExpression forbidden(QStringLiteral(R"([/\\:*?"<>|\x00-\x1f])"));
  title = title.remove(forbidden).simplified().left(kLongestTitle);
  const QString now = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd HH.mm.ss"));
  return tr("%1, results %2.json").arg(title, now);
}

void Lessons::askResultsFile() {
  if (!isRunning()) return;
  const QString name = resultsFile_.isEmpty() ? resultsName() : resultsFile_;
  constexpr bool kAsksToReplace = false;  // answers in it are kept
  const QString file = askSaveFile(&parts_.window, tr("File of your results"), name,
                                   tr("Results (*.json)"), kAsksToReplace);
  if (!file.isEmpty()) keepResults(file);
}

bool Lessons::keepResults(const QString& file) {
  if (!isRunning()) return false;
  try {
    LessonResults kept = readResults(file.toStdString(), *lesson_);
    for (const LessonResult& one : results_.results) kept.set(one);
    kept.date = std::max(kept.date, results_.date);  // the later one
    std::erase_if(kept.results, [&](const LessonResult& one) {
      return one.step >= static_cast<int>(lesson_->steps.size()) ||
             !lesson_->steps[static_cast<std::size_t>(one.step)].prediction;
    });
    writeResults(file.toStdString(), kept, *lesson_);
    results_ = std::move(kept);
    resultsFile_ = file;
    isSaved_ = true;
    keepUnsavedAnswers();
  } catch (const std::exception& error) {
    parts_.messages.showFailure(MessageBar::Failure::Export, translatedError(error));
    return false;
  }
  parts_.messages.end(MessageBar::Failure::Export);
  show(step_);
  pane_->showNote(tr("Your answers are kept in %1.").arg(QFileInfo(file).fileName()));
  return true;
}

void Lessons::writeResultsFile() {
  if (resultsFile_.isEmpty()) return;
  try {
    writeResults(resultsFile_.toStdString(), results_, *lesson_);
    isSaved_ = true;
  } catch (const std::exception& error) {
    parts_.messages.showFailure(MessageBar::Failure::Export, translatedError(error));
  }
}

// ---- The end

void Lessons::end() {
  if (!isRunning()) return;
  finding_.cancel();
  comparisons_.cancel();
  waiting_.reset();
  keepUnsavedAnswers();
  if (hasUnsavedAnswers() && !lesson_->digest.empty()) left_[lesson_->digest] = results_;
  lesson_.reset();
  point_->dismiss();
  dock_->hide();
  parts_.panel.setRowAccess({});
  for (QAction* action : commands_->get({"lessonBackStep", "lessonNextStep", "lessonEnd"}))
    action->setEnabled(false);
  restore();
  emit ended();
}

/// Restores the state before the lesson.
void Lessons::restore() {
  const std::optional<Before> before = std::exchange(before_, std::nullopt);
  parts_.session.editCurve([&](FrictionChartModel& plot) {
    plot.conceal(std::nullopt);
    plot.reachOver(std::nullopt);
    plot.unpinAll();
    if (!before) return;
    plot.setQuantity(before->quantity);
    plot.setLinearY(before->isLinearY);
    for (const auto& curve : before->pinned) plot.pin(curve);
  });
  parts_.tabs.setCurveHidden(false);
  if (!before) return;
  parts_.document.endTrial();
  parts_.tabs.setCurrentIndex(before->tab);
  if (before->hasDimensionlessAxes)
    if (auto* axes = parts_.window.findChild<QAction*>("dimensionlessAxes")) axes->setChecked(true);
  if (auto* canvas = parts_.window.findChild<ContactCanvas*>()) canvas->setOverlay(before->overlay);
}

}  // namespace asperity
