#include "ui/window/lesson/lesson_editor.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QShortcut>
#include <QStackedWidget>
#include <QTabBar>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/base/input_error.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/panels/labels.h"
#include "ui/window/lesson/handout.h"
#include "ui/window/lesson/lesson_pages.h"
#include "ui/window/lesson/lesson_text.h"
#include "ui/window/lesson/lesson_validation.h"
#include "ui/window/lesson/prediction_fields.h"
#include "ui/window/main/file_dialogs.h"
#include "ui/window/main/last_session.h"
#include "ui/window/main/window_layout.h"

namespace asperity {

namespace {

constexpr int kListWidth = 250;  // pixels, at least

}  // namespace

LessonEditor::LessonEditor(LessonDocument document, ShownNow shownNow, QWidget* parent)
    : QDialog(parent),
      document_(std::move(document)),
      shownNow_(std::move(shownNow)),
      validation_(new LessonValidation(this)),
      keeping_(new QTimer(this)) {
  setObjectName("lessonEditor");
  setWindowTitle(tr("Lesson editor"));
  buildLanguages();
  head_ = new LessonHeadPage;
  step_ = new LessonStepPage;
  pages_ = new QStackedWidget;
  pages_->addWidget(head_);
  scroll_ = scrolled(step_);
  scroll_->setFocusPolicy(Qt::NoFocus);  // its fields take the focus
  pages_->addWidget(scroll_);
  for (const LessonForm* page : std::initializer_list<const LessonForm*>{head_, step_})
    connect(page, &LessonForm::edited, this, &LessonEditor::take);
  auto* right = new QVBoxLayout;
  right->addWidget(language_);
  right->addWidget(pages_, 1);
  auto* halves = new QHBoxLayout;
  halves->setSpacing(14);
  halves->addWidget(buildSteps());
  halves->addLayout(right, 1);
  messageLabel_ = textLabel("editorComplaint");
  messageLabel_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(14, 12, 14, 12);
  all->addLayout(halves, 1);
  all->addWidget(messageLabel_);
  all->addLayout(buildFoot());
  resizeDialog(*this, {960, 660});
  connect(language_, &QTabBar::currentChanged, this, &LessonEditor::showStep);
  connect(steps_, &QListWidget::currentRowChanged, this, &LessonEditor::showStep);
  connect(step_, &LessonStepPage::shownSceneRequested, this, &LessonEditor::takeShownScene);
  connect(validation_, &LessonValidation::answerFound, this, &LessonEditor::check);
  // Undo and redo are those of the lesson, also where a field of text has the focus.
  const auto addKeys = [this](const QKeySequence& keys, auto slot) {
    connect(new QShortcut(keys, this), &QShortcut::activated, this, slot);
  };
  addKeys(QKeySequence::Undo, &LessonEditor::undo);
  addKeys(QKeySequence::Redo, &LessonEditor::redo);
  addKeys(QKeySequence::Save, &LessonEditor::save);
  addKeys(Qt::CTRL | Qt::SHIFT | Qt::Key_S, &LessonEditor::askAndSave);
  qApp->installEventFilter(this);
  keeping_->setSingleShot(true);
  keeping_->setInterval(kSessionDelay);
  connect(keeping_, &QTimer::timeout, this, [this] { document_.keep(); });
  showList();
  if (lesson().steps.empty()) head_->beginTitle();
}

// ---- The parts of the page

void LessonEditor::buildLanguages() {
  language_ = named<QTabBar>("editorLanguage");
  language_->addTab(QStringLiteral("English"));
  language_->addTab(QStringLiteral("Deutsch"));
  language_->setCurrentIndex(presentLanguage() == "de" ? 1 : 0);
  language_->setDrawBase(false);
  language_->setExpanding(false);
  // The chosen tab differs from the other one in a dark window, too.
  language_->setStyleSheet(QStringLiteral(
      "QTabBar::tab { padding: 4px 14px; border: none; border-bottom: 2px solid transparent; }"
      "QTabBar::tab:selected { border-bottom: 2px solid palette(highlight); font-weight: bold; }"));
  language_->setAccessibleName(tr("language of the texts"));
}

QWidget* LessonEditor::buildSteps() {
  auto* part = new QWidget;
  auto* column = marginless<QVBoxLayout>(part);
  steps_ = named<QListWidget>("editorSteps");
  steps_->setAccessibleName(tr("steps"));
  steps_->setWordWrap(true);
  steps_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  column->addWidget(steps_, 1);
  auto* add = pageButton("editorAdd", tr("&Add step from what is shown"), this,
                         &LessonEditor::addShownStep);
  add->setToolTip(tr("The scene, the tab and the quantity of the chart, as they are now"));
  column->addWidget(add);
  up_ = pageButton("editorUp", tr("&Up"), this, [this] { moveStep(-1); });
  down_ = pageButton("editorDown", tr("&Down"), this, [this] { moveStep(1); });
  remove_ = pageButton("editorRemove", tr("&Remove"), this, &LessonEditor::removeStep);
  auto* line = new QHBoxLayout;
  for (QPushButton* one : {up_, down_, remove_}) line->addWidget(one);
  column->addLayout(line);
  // The part is as wide as its buttons need, in the font that the window has now.
  part->setMinimumWidth(kListWidth);
  part->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
  return part;
}

QLayout* LessonEditor::buildFoot() {
  saver_ = new HandoutSaver(this);
  connect(saver_, &HandoutSaver::statusChanged, this, [this](const QString& text) {
    messageLabel_->setText(text);
    showButtons();
  });
  auto* open = pageButton("editorOpen", tr("&Open…"), this, &LessonEditor::openOther);
  handout_ = pageButton("editorHandout", tr("&Handout…"), this, [this] {
    const QString name = QFileInfo(proposedFile()).completeBaseName();
    useRead([&](const Lesson& read) { saver_->ask(read, name); });
  });
  handout_->setToolTip(tr("Pages to print, as PDF or as a web page"));
  undo_ = pageButton("editorUndo", tr("U&ndo"), this, &LessonEditor::undo);
  redo_ = pageButton("editorRedo", tr("R&edo"), this, &LessonEditor::redo);
  auto* close = pageButton("editorClose", tr("&Close"), this, &LessonEditor::reject);
  try_ = pageButton("editorTry", tr("&Try this step"), this, [this] {
    useRead([this](const Lesson& read) { emit trialRequested(read, std::max(0, presentStep())); });
  });
  auto* saveAs = pageButton("editorSaveAs", tr("Sa&ve as…"), this, &LessonEditor::askAndSave);
  auto* save = pageButton("editorSave", tr("&Save"), this, &LessonEditor::save);
  save->setToolTip(tr("Also saves a lesson that is not complete yet (Ctrl+S)"));
  return buttonRow({open, handout_, undo_, redo_}, {close, try_, saveAs, save});
}

/// Uses the lesson as its file would be read, or shows what is wrong: a scene that it names may
/// have gone since it was checked.
void LessonEditor::useRead(const std::function<void(const Lesson&)>& use) {
  try {
    use(document_.read());
  } catch (const InputError&) {
    check();
  }
}

// ---- Showing

/// Returns the place of the step that is shown; -1 for the lesson as a whole.
int LessonEditor::presentStep() const {
  return steps_->currentRow() - 1;
}

LessonStep* LessonEditor::present() {
  std::vector<LessonStep>& steps = document_.lesson.steps;
  const int place = presentStep();
  return place < 0 || place >= static_cast<int>(steps.size())
             ? nullptr
             : &steps[static_cast<std::size_t>(place)];
}

bool LessonEditor::isGerman() const {
  return language_->currentIndex() == 1;
}

/// Returns the name of a step in the list.
QString LessonEditor::stepName(std::size_t step) const {
  const QString title =
      QString::fromStdString(lesson().steps[step].title.in(isGerman() ? "de" : "en"));
  return tr("%1. %2").arg(step + 1).arg(title.isEmpty() ? tr("(no title)") : title);
}

void LessonEditor::showList() {
  const int row = steps_->currentRow();
  const bool wasShowing = std::exchange(isShowing_, true);
  steps_->clear();
  steps_->addItem(tr("The lesson"));
  for (std::size_t i = 0; i < lesson().steps.size(); ++i) steps_->addItem(stepName(i));
  isShowing_ = wasShowing;
  steps_->setCurrentRow(std::clamp(row, 0, steps_->count() - 1));
}

void LessonEditor::showStep() {
  if (isShowing_) return;
  const LessonStep* step = present();
  const int row = presentStep();
  up_->setEnabled(step && row > 0);
  down_->setEnabled(step && row + 1 < static_cast<int>(lesson().steps.size()));
  remove_->setEnabled(step != nullptr);
  for (LessonForm* page : std::initializer_list<LessonForm*>{head_, step_})
    page->setGerman(isGerman());
  head_->showLesson(lesson());
  if (step) step_->showStep(*step, sceneText(static_cast<std::size_t>(row)));
  pages_->setCurrentIndex(step ? 1 : 0);
  if (std::exchange(shownRow_, row) != row) scroll_->verticalScrollBar()->setValue(0);
  typedIn_.clear();
  check();
}

/// Returns the name of the scene with which a step begins.
QString LessonEditor::sceneText(std::size_t step) const {
  const LessonStep& shown = lesson().steps[step];
  QString title = translatedText(Message(shown.scene.title));
  if (title.isEmpty()) title = tr("(no title)");
  return shown.hasOwnScene() ? title : tr("%1, as step %2 leaves it").arg(title).arg(step);
}

// ---- Taking what is written

void LessonEditor::take() {
  if (LessonStep* step = present())
    step_->take(*step);
  else
    head_->take(document_.lesson);
  const QWidget* field = focusWidget();
  const bool isTyped = qobject_cast<const QLineEdit*>(field) ||
                       qobject_cast<const QPlainTextEdit*>(field) ||
                       qobject_cast<const QAbstractSpinBox*>(field);
  typedIn_ = isTyped ? field->objectName() : QString();
  check();
}

/// Shows in the tabs of the languages how many texts each of them lacks, where it has some.
void LessonEditor::showMissing() {
  const QString names[] = {QStringLiteral("English"), QStringLiteral("Deutsch")};
  const QStringList missing[] = {missingTexts(lesson(), false), missingTexts(lesson(), true)};
  for (int i = 0; i < 2; ++i) {
    language_->setTabText(i, missing[i].isEmpty()
                                 ? names[i]
                                 : tr("%1 (%2 missing)").arg(names[i]).arg(missing[i].size()));
    language_->setTabToolTip(
        i, missing[i].isEmpty()
               ? QString()
               : tr("Not translated: %1. A question that lacks a translation stands in the other "
                    "language as a whole.")
                     .arg(missing[i].join(QStringLiteral("; "))));
  }
}

/// Checks the lesson and shows what is wrong; an edit is kept for undo.
void LessonEditor::check() {
  const int place = presentStep();
  const LessonStep* step = present();
  validation_->check(document_, place, step ? step_->prediction().unreadable() : QString());
  if (step) step_->prediction().showComputed(validation_->computedText(*step));
  showMissing();
  messageLabel_->setText(validation_->whyNotPlayed());
  if (document_.remember(steps_->currentRow(), typedIn_)) keepSoon();
  showButtons();
  if (step) steps_->item(place + 1)->setText(stepName(static_cast<std::size_t>(place)));
}

/// Edits that follow each other do not put the keeping off.
void LessonEditor::keepSoon() {
  if (!keeping_->isActive()) keeping_->start();
}

void LessonEditor::forgetUnsaved() {
  keeping_->stop();
  forgetDraft();
}

// ---- Undo and redo

void LessonEditor::undo() {
  if (document_.canUndo()) showEdit(document_.undo());
}

void LessonEditor::redo() {
  if (document_.canRedo()) showEdit(document_.redo());
}

/// Shows the lesson after it went back or forward, at the step that changed.
void LessonEditor::showEdit(int row) {
  keepSoon();
  showList();
  steps_->setCurrentRow(std::min(row, steps_->count() - 1));
  showStep();
}

/// Leaves the keys of undo and redo to the editor where a field would undo its own typing.
bool LessonEditor::eventFilter(QObject* watched, QEvent* event) {
  const auto* field = qobject_cast<const QWidget*>(watched);
  if (event->type() == QEvent::ShortcutOverride && field && isAncestorOf(field)) {
    const auto* key = static_cast<const QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->ignore();
      return true;
    }
  }
  return QDialog::eventFilter(watched, event);
}

/// Enables the buttons that the state of the lesson allows.
void LessonEditor::showButtons() {
  const bool isPlayed = validation_->whyNotPlayed().isEmpty();
  try_->setEnabled(isPlayed);
  handout_->setEnabled(isPlayed && !saver_->isSaving());
  undo_->setEnabled(document_.canUndo());
  redo_->setEnabled(document_.canRedo());
}

// ---- Steps

/// Adds a step below the present one.
void LessonEditor::addShownStep() {
  std::optional<LessonStep> step = takenStep();
  if (!step) return;
  const int row = std::max(0, steps_->currentRow());
  (isGerman() ? step->text.german : step->text.english) =
      tr("What is to be seen here?").toStdString();
  document_.insertStep(static_cast<std::size_t>(row), std::move(*step));
  showChange(row + 1);
  step_->beginText();
}

/// Returns the step that the window shows; else shows why there is none.
std::optional<LessonStep> LessonEditor::takenStep() {
  std::optional<LessonStep> taken = shownNow_();
  if (!taken)
    messageLabel_->setText(
        tr("The main window shows the gallery. Open a scene in it, then add the step."));
  return taken;
}

void LessonEditor::removeStep() {
  if (!present()) return;
  const int row = steps_->currentRow();
  document_.removeStep(static_cast<std::size_t>(presentStep()));
  showChange(row);
}

void LessonEditor::takeShownScene() {
  if (!present()) return;
  const std::optional<LessonStep> taken = takenStep();
  if (!taken) return;
  document_.setScene(static_cast<std::size_t>(presentStep()), taken->scene);
  showChange(steps_->currentRow());
}

/// Moves the present step up or down.
void LessonEditor::moveStep(int by) {
  const int place = presentStep(), other = place + by;
  if (!present() || other < 0 || other >= static_cast<int>(lesson().steps.size())) return;
  document_.swapSteps(static_cast<std::size_t>(place), static_cast<std::size_t>(other));
  showChange(other + 1);
}

/// Shows the steps after one of them was added, removed, moved or got another scene.
void LessonEditor::showChange(int row) {
  typedIn_.clear();
  showList();
  steps_->setCurrentRow(std::min(row, steps_->count() - 1));
  check();
  showStep();
}

// ---- The file

void LessonEditor::openOther() {
  if (!canClose()) return;
  const QString file = askOpenFile(this, tr("Open lesson"), proposedFolder(document_.file()),
                                   tr("Lessons (*.json);;All files (*)"));
  if (!file.isEmpty()) openFile(file);
}

void LessonEditor::openFile(const QString& file) {
  try {
    document_.open(file);
  } catch (const std::exception& error) {
    messageLabel_->setText(translatedError(error));
    return;
  }
  forgetUnsaved();
  validation_->forget();
  showChange(0);
}

bool LessonEditor::saveTo(const QString& file) {
  try {
    document_.save(file);
  } catch (const std::exception& error) {
    messageLabel_->setText(translatedError(error));
    return false;
  }
  forgetUnsaved();
  const QString reason = validation_->whyNotPlayed();
  messageLabel_->setText(reason.isEmpty() ? savedText(file)
                                          : tr("Saved %1 as a draft. Before it can be played: %2")
                                                .arg(QFileInfo(file).fileName(), reason));
  return true;
}

bool LessonEditor::save() {
  return document_.file().isEmpty() ? askAndSave() : saveTo(document_.file());
}

/// Returns the file of the lesson, or a name that its title gives where it has none.
QString LessonEditor::proposedFile() const {
  if (!document_.file().isEmpty()) return document_.file();
  const QString title = fileNamePart(lesson().title);
  return (title.isEmpty() ? QStringLiteral("lesson") : title) + ".json";
}

bool LessonEditor::askAndSave() {
  const QString file =
      askSaveFile(questionParent(), tr("Save lesson"), proposedFile(), tr("Lessons (*.json)"));
  return !file.isEmpty() && saveTo(file);
}

/// Returns the window over which questions appear: the editor is hidden during a trial.
QWidget* LessonEditor::questionParent() {
  return isVisible() || !parentWidget() ? this : parentWidget();
}

bool LessonEditor::canClose() {
  if (!document_.isChanged()) {
    forgetUnsaved();
    return true;
  }
  switch (askSaveChanges(questionParent(), "editorUnsaved", tr("Lesson editor"),
                         tr("The lesson was changed and not saved."))) {
    case QMessageBox::Save:
      return save();
    case QMessageBox::Discard:
      forgetUnsaved();
      return true;
    default:
      return false;
  }
}

LessonEditor::Session LessonEditor::session() const {
  return {document_, steps_->currentRow(), language_->currentIndex(), saveGeometry()};
}

void LessonEditor::restoreSession(const Session& session) {
  keepSoon();
  language_->setCurrentIndex(session.language);
  restoreGeometry(session.geometry);
  showList();
  steps_->setCurrentRow(std::clamp(session.row, 0, steps_->count() - 1));
}

void LessonEditor::reject() {
  if (canClose()) QDialog::reject();
}

}  // namespace asperity
