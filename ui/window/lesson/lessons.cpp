#include "ui/window/lesson/lessons.h"

#include <QDateTime>
#include <QFileInfo>
#include <QMainWindow>
#include <QSettings>
#include <QWindow>
#include <algorithm>
#include <utility>

#include "core/base/input_error.h"
#include "core/lesson/lesson_file.h"
#include "core/scene/scene_files.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/window/lesson/handout.h"
#include "ui/window/lesson/lesson_editor.h"
#include "ui/window/lesson/lesson_list.h"
#include "ui/window/lesson/lesson_pane.h"
#include "ui/window/lesson/lesson_results_page.h"
#include "ui/window/lesson/lesson_text.h"
#include "ui/window/main/commands.h"
#include "ui/window/main/file_dialogs.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/scene_tabs.h"
#include "ui/window/main/session.h"
#include "ui/window/main/window_pages.h"

namespace asperity {

namespace {

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

// The settings of a lesson: the answers that are kept against a crash, the file in which answers
// were saved last, and the step at which it was left.
constexpr QLatin1String kAnswers("lessonAnswers/"), kFiles("lessonFiles/"), kSteps("lessonSteps/");

QString lessonKey(QLatin1String setting, const std::string& digest) {
  return setting + QString::fromStdString(digest);
}

/// Keeps the answers of a lesson in place of those kept before, or forgets them where there are
/// none. It writes to the disk at once: the program may be killed.
void keepAnswers(const std::string& digest, const LessonResults* results) {
  if (digest.empty()) return;
  QSettings settings;
  if (results)
    settings.setValue(lessonKey(kAnswers, digest), QString::fromStdString(resultsJson(*results)));
  else
    settings.remove(lessonKey(kAnswers, digest));
  settings.sync();
}

/// Returns the step at which to go on with these answers: the one that was left, or that of the
/// last answer where the lesson ran elsewhere.
int stepToGoOn(const LessonResults& results) {
  int last = 0;
  for (const LessonResult& one : results.results) last = std::max(last, one.step);
  return QSettings().value(lessonKey(kSteps, results.digest), last).toInt();
}

/// Returns whether the answers can be those to the questions of a lesson.
bool belongTo(const LessonResults& results, const Lesson& lesson) {
  return results.digest == lesson.digest && !results.results.empty() &&
         std::ranges::all_of(results.results, [&](const LessonResult& one) {
           return askingStep(lesson, one.step) != nullptr;
         });
}

/// Returns the answers that `read` finds, unless it fails or they are those of another lesson.
std::optional<LessonResults> answersTo(const Lesson& lesson,
                                       const std::function<LessonResults()>& read) {
  if (lesson.digest.empty()) return std::nullopt;
  try {
    const LessonResults results = read();
    return belongTo(results, lesson) ? std::optional(results) : std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

std::optional<LessonResults> keptAnswers(const Lesson& lesson) {
  const QString kept = QSettings().value(lessonKey(kAnswers, lesson.digest)).toString();
  return answersTo(lesson, [&] { return parseResults(kept.toStdString(), {}); });
}

Lessons::Lessons(const Parts& parts, MessageBar& messages)
    : QObject(&parts.window), parts_(parts), messages_(messages), player_(new LessonPlayer(parts)) {
  // Another scene was opened, or the tour begins.
  connect(&parts_.document, &SceneDocument::trialEnded, this, &Lessons::end);
  connect(player_, &LessonPlayer::answered, this, [this] {
    isSaved_ = false;
    if (!resultsFile_.isEmpty()) saveAnswers(resultsFile_);
    keepUnsavedAnswers();
  });
  connect(player_, &LessonPlayer::savingRequested, this, &Lessons::askResultsFile);
  connect(player_, &LessonPlayer::endRequested, this, &Lessons::leave);
  connect(player_, &LessonPlayer::stepShown, this, [this] {
    if (isRemembered())
      QSettings().setValue(lessonKey(kSteps, player_->lesson()->digest), player_->step());
    emit stepShown();
  });
}

void Lessons::addTo(Commands& commands) {
  commands.add(
      {"lessons", [] { return tr("Lessons…"); }, [this] { showList(); }, {Qt::CTRL | Qt::Key_L}});
  player_->addTo(commands);
  commands.add({"lessonEditor", [] { return tr("Lesson editor…"); },
                [this] {
                  if (LessonEditor* open = editor())
                    bringToFront(*open);
                  else
                    openEditor(player_->isRunning() ? written_ : Lesson{},
                               player_->isRunning() ? file_ : QString());
                }});
  commands.add({"classTable", [] { return tr("Table of a class…"); }, [this] { askResults(); }});
}

/// Asks for the files of a class, which may be of several lessons.
void Lessons::askResults() {
  const QStringList files = askOpenFiles(&parts_.window, tr("Results of a class"), proposedFolder(),
                                         tr("Results (*.json);;All files (*)"));
  if (!files.isEmpty()) openResults(files);
}

LessonList& Lessons::showList() {
  for (LessonList* open : parts_.window.findChildren<LessonList*>()) delete open;
  auto* list = new LessonList(&parts_.window);
  list->setAttribute(Qt::WA_DeleteOnClose);
  connect(&list->saver(), &HandoutSaver::endedWithoutPage, &messages_, &MessageBar::showMessage);
  connect(list, &LessonList::lessonRequested, this, [this](const QString& name) { open(name); });
  connect(list, &LessonList::resultsRequested, this, &Lessons::openResults);
  connect(list, &LessonList::editorRequested, this, [this](const QString& name) {
    messages_.succeeds(MessageBar::Failure::Files, [&] {
      openEditor(readNamedLesson(name.toStdString(), readNamedScene),
                 QFileInfo::exists(name) ? name : QString());
    });
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
  LessonEditor& made = makeEditor({lesson, file});
  made.show();
  return made;
}

LessonEditor& Lessons::makeEditor(const LessonDocument& document) {
  const auto shownNow = [this]() -> std::optional<LessonStep> {
    if (parts_.pages.isShowingGallery()) return std::nullopt;
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
  auto* editor = new LessonEditor(document, shownNow, &parts_.window);
  editor->setAttribute(Qt::WA_DeleteOnClose);
  connect(&editor->saver(), &HandoutSaver::endedWithoutPage, &messages_, &MessageBar::showMessage);
  connect(editor, &LessonEditor::trialRequested, this,
          [this, editor](const Lesson& edited, int step) {
            // The editor is hidden during the lesson, and shown again when that ends.
            start(edited, step, Purpose::Trial);
            hideDuringLesson(*editor);
          });
  return *editor;
}

LessonEditor& Lessons::openEditor(const Lesson& lesson, const QString& file) {
  const std::optional<LessonDocument> draft = editor() ? std::nullopt : keptDraft();
  if (!draft) return showEditor(lesson, file);
  QString title = plainText(draft->lesson.title);
  if (title.isEmpty()) title = tr("(no title)");
  if (!wantsToGoOn("draftQuestion",
                   tr("The lesson “%1” was changed in the editor and not saved before the program "
                      "ended. Go on with it?")
                       .arg(title),
                   discards())) {
    forgetDraft();
    return showEditor(lesson, file);
  }
  LessonEditor& made = makeEditor(*draft);
  made.show();
  return made;
}

/// The answer to wantsToGoOn() by which work is lost that is in no file.
Lessons::Refusal Lessons::discards() {
  return {tr("What you discard is lost."), tr("&Discard")};
}

/// Asks whether work of an earlier session is to be continued. The Escape key continues it.
bool Lessons::wantsToGoOn(const QString& name, const QString& question,
                          const Refusal& refusal) const {
  return ask(&parts_.window, {name, tr("Asperity"), question, refusal.consequence},
             {{QMessageBox::Yes, tr("&Go on")}, {QMessageBox::Discard, refusal.button}},
             QMessageBox::Yes) != QMessageBox::Discard;
}

void Lessons::hideDuringLesson(LessonEditor& editor) {
  editor.hide();
  connect(
      player_, &LessonPlayer::ended, &editor, [&editor] { bringToFront(editor); },
      Qt::SingleShotConnection);
}

std::function<void()> Lessons::closeEditorForReopening() {
  LessonEditor* open = editor();
  if (!open) return [] {};
  const LessonEditor::Session session = open->session();
  const bool isVisible = open->isVisible();
  delete open;
  return [this, session, isVisible] {
    LessonEditor& again = makeEditor(session.document);
    again.restoreSession(session);
    if (isVisible)
      again.show();
    else
      hideDuringLesson(again);
  };
}

/// Returns why a lesson cannot be opened, and for a draft how it can be completed.
LiveText Lessons::failureText(const QString& file, const std::exception& error) const {
  const LiveText reason = liveError(error);
  if (!isLessonFile(file.toStdString())) return reason;
  try {
    readDraftFile(file.toStdString(), readNamedScene);
  } catch (const std::exception&) {
    return reason;
  }
  return [reason] {
    return tr("This lesson cannot be played yet; Help > Lesson editor > Open completes it. %1")
        .arg(QString(reason));
  };
}

bool Lessons::open(const QString& nameOrFile) {
  try {
    if (isResultsFile(nameOrFile.toStdString())) {
      showLessonResults(parts_.window, nameOrFile,
                        [this, nameOrFile](const Lesson& lesson, const LessonResults& results) {
                          if (mayLeave())
                            goOn(lesson, results, QFileInfo(nameOrFile).absoluteFilePath());
                        });
      messages_.end(MessageBar::Failure::Files);
      return true;
    }
    const Lesson lesson = readNamedLesson(nameOrFile.toStdString(), readNamedScene);
    if (!mayLeave()) return false;
    end();
    const QString results = offerAnswers(lesson);
    const auto left = left_.find(lesson.digest);
    if (left == left_.end())
      start(lesson);
    else
      goOn(lesson, LessonResults(left->second), results);
    if (QFileInfo::exists(nameOrFile)) file_ = QFileInfo(nameOrFile).absoluteFilePath();
    messages_.end(MessageBar::Failure::Files);
    return true;
  } catch (const std::exception& error) {
    messages_.showFailure(MessageBar::Failure::Files, failureText(nameOrFile, error));
    return false;
  }
}

bool Lessons::openResults(const QStringList& files) {
  return messages_.succeeds(MessageBar::Failure::Files,
                            [&] { showClassResults(parts_.window, files); });
}

/// Begins a lesson with these answers, at the step where it was left. `file`: they are in it, and
/// the further ones will be; empty: they are in no file.
void Lessons::goOn(const Lesson& lesson, const LessonResults& results, const QString& file) {
  left_[lesson.digest] = results;
  start(lesson, stepToGoOn(results));
  if (!file.isEmpty()) setResultsFile(file);
}

/// Takes a file that has all answers as the one for the further ones, also in the next session.
void Lessons::setResultsFile(const QString& file) {
  resultsFile_ = file;
  isSaved_ = true;
  if (isRemembered())
    QSettings().setValue(lessonKey(kFiles, player_->lesson()->digest),
                         QFileInfo(file).absoluteFilePath());
}

/// Offers the answers of an earlier session, and returns their file; those that are in no file come
/// first. Those of this session that are in no file come back without a question.
QString Lessons::offerAnswers(const Lesson& lesson) {
  if (left_.contains(lesson.digest)) return {};
  const std::optional<LessonResults> kept = keptAnswers(lesson);
  if (!kept) return offerSavedAnswers(lesson);
  if (wantsToGoOn("answersQuestion",
                  tr("This lesson was begun before (%1), and its answers are in "
                     "no file. Go on with these answers?")
                      .arg(dateText(kept->date)),
                  discards()))
    left_[lesson.digest] = *kept;
  else
    keepAnswers(lesson.digest, nullptr);
  return {};
}

/// Offers the answers in the file of the last time. A student who begins anew is not asked again.
QString Lessons::offerSavedAnswers(const Lesson& lesson) {
  const QString file = QSettings().value(lessonKey(kFiles, lesson.digest)).toString();
  const auto saved = answersTo(lesson, [&] { return readResultsFile(file.toStdString()); });
  if (!saved) return {};
  if (wantsToGoOn("savedAnswersQuestion",
                  tr("Your answers to this lesson are in %1. Go on with these answers?")
                      .arg(QFileInfo(file).fileName()),
                  {tr("The file stays if you begin anew."), tr("&Begin anew")})) {
    left_[lesson.digest] = *saved;
    return file;
  }
  QSettings().remove(lessonKey(kFiles, lesson.digest));
  return {};
}

void Lessons::start(const Lesson& lesson, int step, Purpose purpose) {
  if (lesson.steps.empty()) return;
  end();
  written_ = lesson;
  resultsFile_.clear();
  isSaved_ = false;
  file_.clear();
  const bool isTrial = purpose == Purpose::Trial;
  const auto left = isTrial ? decltype(left_)::node_type() : left_.extract(lesson.digest);
  player_->start(lesson, step, left ? left.mapped() : emptyResults(lesson), isTrial);
  if (left) player_->pane().showNote(tr("Your answers from before are here."));
}

// ---- The answers and their file

bool Lessons::hasUnsavedAnswers() const {
  return player_->isRunning() && !isSaved_ && !player_->isTrial() &&
         std::ranges::any_of(player_->results().results,
                             [](const LessonResult& one) { return one.given.isGiven(); });
}

/// Keeps answers against a crash until they are in a file.
void Lessons::keepUnsavedAnswers() const {
  if (!player_->isTrial())
    keepAnswers(player_->lesson()->digest, hasUnsavedAnswers() ? &player_->results() : nullptr);
}

bool Lessons::mayLeave() {
  if (!hasUnsavedAnswers()) return true;
  switch (askSaveChanges(&parts_.window, "resultsQuestion", tr("Asperity"),
                         tr("Save your answers?"),
                         tr("They go into a file of your choice. Otherwise they are lost."))) {
    case QMessageBox::Save:
      askResultsFile();
      return isSaved_;
    case QMessageBox::Discard:
      isSaved_ = true;  // the lesson goes on with them where it does not end after all
      return true;
    default:
      return false;
  }
}

bool Lessons::canClose() {
  LessonEditor* open = editor();
  if (!open || open->canClose()) return mayLeave();
  bringToFront(*open);  // it shows why the lesson could not be saved
  return false;
}

void Lessons::close() {
  delete editor();
  end();
}

/// Ends the lesson, unless the student decides to stay in it.
void Lessons::leave() {
  if (player_->isRunning() && mayLeave()) end();
}

/// Returns the name that is proposed for the results: with the title in the language of the window
/// and with the time, so that the files of a class can be collected in one folder.
QString Lessons::resultsName() const {
  const QString now = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd HH.mm.ss"));
  return tr("%1, results %2.json").arg(fileNamePart(player_->lesson()->title), now);
}

void Lessons::askResultsFile() {
  if (!player_->isRunning()) return;
  const QString name = resultsFile_.isEmpty() ? resultsName() : resultsFile_;
  constexpr bool kAsksToReplace = false;  // answers in it are kept
  const QString file = askSaveFile(&parts_.window, tr("File of your results"), name,
                                   tr("Results (*.json)"), kAsksToReplace);
  if (!file.isEmpty()) keepResults(file);
}

bool Lessons::keepResults(const QString& file) {
  if (!player_->isRunning() || !saveAnswers(file)) return false;
  keepUnsavedAnswers();
  // A step that is still open stays as it is, with what the student has entered.
  if (player_->isRevealed()) player_->show(player_->step());
  player_->pane().showNote(tr("Your answers are kept in %1.").arg(QFileInfo(file).fileName()));
  return true;
}

/// Writes the answers into a file, together with those that it has already: the lesson may also run
/// elsewhere. Returns whether it could be written; the message bar shows the reason.
bool Lessons::saveAnswers(const QString& file) {
  const bool isWritten = messages_.succeeds(MessageBar::Failure::Export, [&] {
    LessonResults all = readResults(file.toStdString(), *player_->lesson());
    for (const LessonResult& one : player_->results().results) all.set(one);
    all.date = std::max(all.date, player_->results().date);  // the later one
    std::erase_if(all.results, [&](const LessonResult& one) {
      return !askingStep(*player_->lesson(), one.step);
    });
    writeResults(file.toStdString(), all, *player_->lesson());
    player_->setResults(std::move(all));
  });
  if (isWritten) setResultsFile(file);
  return isWritten;
}

void Lessons::end() {
  if (!player_->isRunning()) return;
  keepUnsavedAnswers();
  if (hasUnsavedAnswers() && !player_->lesson()->digest.empty())
    left_[player_->lesson()->digest] = player_->results();
  player_->end();
}

}  // namespace asperity
