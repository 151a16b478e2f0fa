#include "ui/window/lesson/lesson_player.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDateTime>
#include <QMainWindow>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "core/scene/parameters.h"
#include "ui/chart/chart_view.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/parameter_panel.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/curve/curve_commands.h"
#include "ui/window/lesson/lesson_dock.h"
#include "ui/window/lesson/lesson_pane.h"
#include "ui/window/lesson/lesson_text.h"
#include "ui/window/lesson/prediction_point.h"
#include "ui/window/main/commands.h"
#include "ui/window/main/scene_tabs.h"
#include "ui/window/main/session.h"

namespace asperity {

namespace {

/// The commands of a running lesson.
const std::initializer_list<const char*> kStepCommands = {"lessonBackStep", "lessonNextStep",
                                                          "lessonEnd"};

/// Returns the access to all rows in a step.
std::map<std::string, RowAccess> rowAccess(const LessonControls& controls, bool isRevealed) {
  std::map<std::string, RowAccess> access;
  const auto with = [isRevealed](ControlState state) {
    if (state == ControlState::Hidden) return RowAccess::Hidden;
    return state == ControlState::Free && isRevealed ? RowAccess::Free : RowAccess::Locked;
  };
  access["*"] = with(controls.others);
  for (const auto& [keys, state] : {std::pair(&controls.free, ControlState::Free),
                                    {&controls.locked, ControlState::Locked},
                                    {&controls.hidden, ControlState::Hidden}})
    for (const std::string& key : *keys) access[key] = with(state);
  return access;
}

/// Returns the scenes of all steps, before and after their answers, each with what the student may
/// do with its rows after the answer.
std::vector<PlannedRows> plannedRows(const Lesson& lesson) {
  std::vector<PlannedRows> plan;
  for (const LessonStep& step : lesson.steps) {
    const std::map<std::string, RowAccess> access = rowAccess(step.controls, true);
    plan.push_back({step.scene, access});
    if (!(step.revealedScene == step.scene)) plan.push_back({step.revealedScene, access});
  }
  return plan;
}

}  // namespace

LessonPlayer::LessonPlayer(const Parts& parts)
    : QObject(&parts.window),
      parts_(parts),
      dock_(new LessonDock(parts.window, parts.parameters, parts.panel)),
      pane_(&dock_->pane()),
      point_(new PredictionPoint(parts.tabs.plot())) {
  connect(dock_, &LessonDock::savingRequested, this, &LessonPlayer::savingRequested);
  connect(dock_, &LessonDock::endRequested, this, &LessonPlayer::endRequested);
  keepTranslated(*dock_, [this] {
    if (isRunning()) {
      translateStep();
      dock_->shareHeightSoon();
    }
    showTitle();
  });
  connect(pane_, &LessonPane::backRequested, this, [this] { show(step_ - 1); });
  connect(pane_, &LessonPane::nextRequested, this, &LessonPlayer::next);
  connect(pane_, &LessonPane::answered, this,
          [this](const GivenAnswer& given) { answer(given, false); });
  connect(pane_, &LessonPane::solutionRequested, this, [this] { answer({}, true); });
  connect(point_, &PredictionPoint::placed, this, [this] { pane_->setPointPlaced(true); });
  connect(point_, &PredictionPoint::returnPressed, pane_, &LessonPane::goOn);
  connect(this, &LessonPlayer::stepShown, dock_, &LessonDock::shareHeightSoon);
  connect(&parts_.document, &SceneDocument::sceneChanged, this,
          [this](const Scene&, SceneChange change) {
            // It runs later: the document is in the middle of its step.
            if (change == SceneChange::Edited)
              QTimer::singleShot(0, this, &LessonPlayer::lockControls);
          });
}

/// Shows the step in another language. What the student has changed, placed or entered stays.
void LessonPlayer::translateStep() {
  Scene scene = parts_.document.scene();
  scene.title = shown(present().title);  // of the step
  if (!(scene == parts_.document.scene())) parts_.document.edit(scene);
  if (present().prediction) point_->setQuestion(plainText(present().prediction->question));
  const QString entry = pane_->entry();
  // The control that has the focus may be made anew.
  const QWidget* focus = QApplication::focusWidget();
  const QString focused = pane_->isAncestorOf(focus) ? focus->objectName() : QString();
  showPage();
  pane_->enter(entry);
  if (auto* control = focused.isEmpty() ? nullptr : pane_->findChild<QWidget*>(focused))
    control->setFocus();
  if (waiting_) pane_->setWaiting(true);
}

void LessonPlayer::addTo(Commands& commands) {
  commands_ = &commands;
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
  commands.add({"lessonEnd", [] { return tr("End the lesson"); }, [this] { emit endRequested(); }});
  for (QAction* action : commands.get(kStepCommands)) action->setEnabled(false);
  // The usual layout has no lesson, but a lesson that runs keeps its pane.
  connect(commands.get("restoreLayout"), &QAction::triggered, this, [this] {
    if (isRunning()) dock_->show();
  });
}

void LessonPlayer::start(const Lesson& lesson, int step, const LessonResults& known, bool isTrial) {
  parts_.document.endTrial();  // the tour may be running
  keepWindow();
  lesson_ = std::make_unique<Lesson>(withWholeQuestions(lesson));
  answers_.clear();
  results_ = known;
  isTrial_ = isTrial;
  parts_.panel.planRows(plannedRows(*lesson_));
  dock_->begin();
  commands_->get("lessonEnd")->setEnabled(true);
  parts_.session.setPlaying(true);
  show(std::clamp(step, 0, static_cast<int>(lesson_->steps.size()) - 1));
}

bool LessonPlayer::isRevealed() const {
  return !isRunning() || !present().prediction || results_.find(step_) != nullptr;
}

void LessonPlayer::show(int step) {
  if (!isRunning() || step < 0 || step >= static_cast<int>(lesson_->steps.size())) return;
  step_ = step;
  stopFinding();
  showScene();
  // The text of a step may describe a movement, so its picture moves.
  if (present().hasOwnScene()) parts_.session.setPlaying(true);
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

void LessonPlayer::showPage() {
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
  if (step_ + 1 == static_cast<int>(lesson_->steps.size()) && isRevealed()) page.score = summary();
  pane_->showStep(page);
  if (point_->point() && !result) pane_->setPointPlaced(true);
  commands_->get("lessonNextStep")->setEnabled(isRevealed());
  showTitle();
}

QString LessonPlayer::summary() const {
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
  return "<b>" + score + "</b>";
}

void LessonPlayer::showTitle() {
  dock_->showTitle(isRunning() ? plainText(lesson_->title) : QString());
}

void LessonPlayer::showScene() {
  parts_.document.openTrial({{}, {}, shownScene()});
  showControls();
  const auto tab = std::ranges::find(kLessonTabs, present().show.tab) - std::begin(kLessonTabs);
  if (QWidget* page = parts_.tabs.widget(static_cast<int>(tab)))
    if (auto* action = parts_.window.findChild<QAction*>("go:" + page->objectName()))
      action->trigger();
}

/// Returns the scene of the step with the step's title: its own title may reveal the answer.
Scene LessonPlayer::shownScene() const {
  Scene scene = isRevealed() ? present().revealedScene : present().scene;
  scene.title = shown(present().title);
  scene.description.clear();
  return scene;
}

/// Frees and locks the controls. Before the prediction is made all are locked: trying them would
/// reveal the answer.
void LessonPlayer::showControls() {
  parts_.panel.setRowAccess(rowAccess(present().controls, isRevealed()));
}

/// Undoes changes of controls that are not free.
void LessonPlayer::lockControls() {
  if (!isRunning()) return;
  const Scene& scene = parts_.document.scene();
  LessonControls controls = present().controls;
  if (!isRevealed()) controls = {{}, {}, {}, ControlState::Locked};
  const Scene shown = shownScene();
  const std::vector<std::string_view> changed = lockedChanges(controls, shown, scene);
  if (changed.empty()) return;
  const QString name = translatedText(findParameter(changed.front())->label);
  parts_.document.edit(withinControls(controls, shown, scene));
  pane_->showNote(isRevealed() ? tr("“%1” is locked in this step.").arg(name)
                               : tr("First make your guess; then you can try it."));
}

void LessonPlayer::showChart() {
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
  showBeside();
  showPoint();
}

/// Computes the curves to compare with, and pins them.
void LessonPlayer::showBeside() {
  const LessonStep& step = present();
  if (step.show.beside.empty()) return;
  const auto scenes = [scene = step.scene, beside = step.show.beside] {
    std::vector<Scene> changed;
    for (const std::vector<std::string>& keys : beside) changed.push_back(withKeys(scene, keys));
    return changed;
  };
  pinCurves(parts_.session, comparisons_, scenes,
            [this](const QString& reason) { pane_->showNote(reason); });
}

/// Shows the point of the answer on the chart, or asks for it.
void LessonPlayer::showPoint() {
  const LessonStep& step = present();
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

/// Computes the answer to the present step, unless that is being done already.
void LessonPlayer::findAnswer() {
  if (finding_.isBusy()) return;
  finding_.request([step = present(), find = find_](
                       const BackgroundWork::Run& run) { return find(step, {.stop = run.stop()}); },
                   [this](const LessonAnswer& answer) { takeAnswer(answer); },
                   [this](const QString& reason) {
                     stopFinding();
                     pane_->setWaiting(false);
                     pane_->showNote(reason);
                   });
}

void LessonPlayer::stopFinding() {
  waiting_.reset();
  finding_.cancel();
}

void LessonPlayer::takeAnswer(const LessonAnswer& answer) {
  answers_[step_] = answer;
  if (waiting_) return settle(*std::exchange(waiting_, std::nullopt));
  if (isRevealed()) showPage();  // the result is from a file, and its texts get their values now
}

/// Takes the user's answer. givesUp: the user asks for the solution without a guess.
void LessonPlayer::answer(GivenAnswer given, bool givesUp) {
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
void LessonPlayer::settle(const GivenAnswer& given) {
  const LessonPrediction& prediction = *present().prediction;
  const LessonAnswer& expected = answers_.at(step_);
  results_.set(
      {step_, prediction.kind, given, expected, asperity::isRight(prediction, expected, given)});
  results_.date = QDateTime::currentDateTime().toString(Qt::ISODate).toStdString();
  emit answered();
  showScene();
  showChart();
  showPage();
  pane_->focusStep();
  emit stepShown();
}

void LessonPlayer::next() {
  if (step_ + 1 < static_cast<int>(lesson_->steps.size()))
    show(step_ + 1);
  else
    emit endRequested();
}

// ---- The end

void LessonPlayer::end() {
  stopFinding();
  comparisons_.cancel();
  lesson_.reset();
  point_->dismiss();
  dock_->hide();
  parts_.panel.planRows({});
  parts_.panel.setRowAccess({});
  for (QAction* action : commands_->get(kStepCommands)) action->setEnabled(false);
  restoreWindow();
  emit ended();
}

/// Keeps what a lesson changes in the window, and shows what its texts speak of.
void LessonPlayer::keepWindow() {
  const FrictionChartModel& chart = parts_.session.friction();
  before_ = Before{{}, chart.quantity(), chart.isLinearY(), parts_.tabs.currentIndex()};
  for (const PinnedCurve& pinned : chart.pinned()) before_->pinned.push_back(pinned.curve);
  if (auto* axes = parts_.window.findChild<QAction*>("dimensionlessAxes")) {
    before_->hasDimensionlessAxes = axes->isChecked();
    axes->setChecked(false);
  }
  if (auto* compares = parts_.window.findChild<QAbstractButton*>("comparisonWanted")) {
    before_->hasComparison = compares->isChecked();
    compares->setChecked(false);
  }
  // The texts of lessons speak of the pressure that glows.
  before_->overlay = parts_.canvas.viewer().overlay();
  parts_.canvas.setOverlay(ContactOverlay::Pressure);
}

/// Restores the state before the lesson.
void LessonPlayer::restoreWindow() {
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
  if (before->hasComparison)
    if (auto* compares = parts_.window.findChild<QAbstractButton*>("comparisonWanted"))
      compares->setChecked(true);
  parts_.canvas.setOverlay(before->overlay);
}

}  // namespace asperity
