#include "ui/window/lesson/lesson_editor.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QScrollArea>
#include <QShortcut>
#include <QStackedWidget>
#include <QTabBar>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/scene/parameters.h"
#include "core/scene/scene_file.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/parameter_row.h"
#include "ui/window/lesson/handout.h"
#include "ui/window/lesson/kept_lessons.h"
#include "ui/window/lesson/lesson_mistakes.h"
#include "ui/window/lesson/lesson_pages.h"
#include "ui/window/lesson/lesson_text.h"
#include "ui/window/main/document_commands.h"
#include "ui/window/main/last_session.h"
#include "ui/window/main/picture_files.h"
#include "ui/window/main/scene_library.h"

namespace asperity {

namespace {

constexpr QSize kDefault(960, 660);  // pixels
constexpr int kListWidth = 250;      // pixels, at least
constexpr int kScreenMargin = 60;    // pixels of the screen that stay free

/// Returns whether the program computes what a step asks for.
bool asksForNumber(const LessonStep& step) {
  return step.prediction &&
         (step.prediction->answer || step.prediction->kind == PredictionKind::Point);
}

/// Returns a step that asks for the number alone: what its texts and choices are has no influence.
LessonStep numberAsked(const LessonStep& step) {
  LessonStep asked;
  asked.scene = step.scene;
  LessonPrediction& prediction = asked.prediction.emplace();
  prediction.answer = step.prediction->answer;
  prediction.kind = PredictionKind::Number;
  if (step.prediction->kind != PredictionKind::Point) return asked;
  prediction.kind = PredictionKind::Point;
  prediction.x = step.prediction->x;
  asked.show.quantity = step.show.quantity;
  return asked;
}

/// Returns the name of the editor's row for a member of a lesson's file; empty where it has no row.
QString rowName(const QString& member) {
  const std::pair<const char*, QString> rows[] = {
      {"steps", LessonEditor::tr("steps")},
      {"title", LessonEditor::tr("title")},
      {"goal", LessonEditor::tr("goal")},
      {"minutes", LessonEditor::tr("minutes")},
      {"notes", LessonEditor::tr("notes for teachers")},
      {"text", LessonEditor::tr("text")},
      {"scene", LessonEditor::tr("scene")},
      {"set", LessonEditor::tr("changed")},
      {"after", LessonEditor::tr("changed with the answer")},
      {"tab", LessonEditor::tr("tab in front")},
      {"quantity", LessonEditor::tr("quantity")},
      {"controls", LessonEditor::tr("controls")},
      {"kind", LessonEditor::tr("prediction")},
      {"question", LessonEditor::tr("question")},
      {"choices", LessonEditor::tr("choices")},
      {"above", LessonEditor::tr("from")},
      {"below", LessonEditor::tr("to")},
      {"answer", LessonEditor::tr("computed answer")},
      {"tolerance", LessonEditor::tr("tolerance")},
      {"x", LessonEditor::tr("place on the axis")},
      {"right", LessonEditor::tr("if right")},
      {"wrong", LessonEditor::tr("if wrong")},
      {"reveal", LessonEditor::tr("said with the answer")},
      {"values", LessonEditor::tr("values of the texts")}};
  for (const auto& [name, row] : rows)
    if (member == QLatin1String(name)) return row;
  return {};
}

/// Returns a key of a lesson's file in the words of the editor:
/// "steps[1].prediction.choices[0].text" is step 2, choice 1, text. Parts without a row, such as
/// "show", are left out.
QString keyText(const QString& key) {
  static const QRegularExpression numbered(QStringLiteral(R"(^(\w+)\[(\d+)\]$)"));
  QStringList words;
  const QStringList members = key.split('.');
  for (qsizetype i = 0; i < members.size(); ++i) {
    const QString rest = members.mid(i).join('.');
    if (const Parameter* row = findParameter(rest.toStdString()); row && rest.contains('.')) {
      words += QStringLiteral("“%1”").arg(ParameterRow::labelText(*row));
      break;
    }
    if (const auto found = numbered.match(members[i]); found.hasMatch()) {
      const int number = found.captured(2).toInt() + 1;
      if (found.captured(1) == QLatin1String("steps"))
        words += LessonEditor::tr("step %1").arg(number);
      else if (found.captured(1) == QLatin1String("choices"))
        words += LessonEditor::tr("choice %1").arg(number);
    } else if (const QString row = rowName(members[i]); !row.isEmpty()) {
      words += row;
    }
  }
  return words.join(QStringLiteral(", "));
}

/// Returns whether a step has this scene when the lesson is read from its file.
bool isReadAs(const Lesson& lesson, std::size_t step, const Scene& scene,
              const std::filesystem::path& folder) {
  try {
    const Lesson read = readLesson(writeLesson(lesson), lesson.name, folder, readNamedScene);
    return read.steps[step].scene == scene;
  } catch (const InputError&) {
    return false;
  }
}

QPushButton* makeEditorButton(const char* name, const QString& text) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  button->setAutoDefault(false);
  return button;
}

}  // namespace

LessonEditor::LessonEditor(const Lesson& lesson, const QString& file, ShownNow shownNow,
                           QWidget* parent)
    : QDialog(parent),
      lesson_(lesson),
      saved_(lesson),
      file_(file),
      shownNow_(std::move(shownNow)),
      keeping_(new QTimer(this)) {
  setObjectName("lessonEditor");
  setWindowTitle(tr("Lesson editor"));
  language_ = new QTabBar;
  language_->setObjectName("editorLanguage");
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
  head_ = new LessonHeadPage;
  step_ = new LessonStepPage;
  auto* scroll = new QScrollArea;
  scroll->setWidget(step_);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  pages_ = new QStackedWidget;
  pages_->addWidget(head_);
  pages_->addWidget(scroll);
  for (const LessonForm* page : std::initializer_list<const LessonForm*>{head_, step_})
    connect(page, &LessonForm::edited, this, &LessonEditor::take);
  auto* right = new QVBoxLayout;
  right->addWidget(language_);
  right->addWidget(pages_, 1);
  auto* halves = new QHBoxLayout;
  halves->setSpacing(14);
  halves->addWidget(buildSteps());
  halves->addLayout(right, 1);
  messageLabel_ = new QLabel;
  messageLabel_->setObjectName("editorComplaint");
  messageLabel_->setWordWrap(true);
  messageLabel_->setTextFormat(Qt::PlainText);
  messageLabel_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  messageLabel_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(14, 12, 14, 12);
  all->addLayout(halves, 1);
  all->addWidget(messageLabel_);
  all->addLayout(buildFoot());
  const QSize available = (parent ? parent->screen() : screen())->availableSize();
  resize(kDefault.boundedTo(available - QSize(kScreenMargin, kScreenMargin)));
  connect(language_, &QTabBar::currentChanged, this, &LessonEditor::showStep);
  connect(steps_, &QListWidget::currentRowChanged, this, &LessonEditor::showStep);
  connect(step_, &LessonStepPage::shownSceneRequested, this, &LessonEditor::takeShownScene);
  // Undo and redo are those of the lesson, also where a field of text has the focus.
  for (const auto& [keys, slot] : {std::pair(QKeySequence::Undo, &LessonEditor::undo),
                                   {QKeySequence::Redo, &LessonEditor::redo}})
    connect(new QShortcut(keys, this), &QShortcut::activated, this, slot);
  connect(new QShortcut(QKeySequence::Save, this), &QShortcut::activated, this,
          &LessonEditor::save);
  connect(new QShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_S, this), &QShortcut::activated, this,
          &LessonEditor::askAndSave);
  qApp->installEventFilter(this);
  keeping_->setSingleShot(true);
  keeping_->setInterval(kSessionDelay);
  connect(keeping_, &QTimer::timeout, this, &LessonEditor::keepUnsaved);
  showList();
  steps_->setCurrentRow(0);
  if (lesson_.steps.empty()) head_->beginTitle();
  states_.push_back({lesson_});
  check();
}

// ---- The parts of the page

QWidget* LessonEditor::buildSteps() {
  auto* part = new QWidget;
  auto* column = new QVBoxLayout(part);
  column->setContentsMargins(0, 0, 0, 0);
  steps_ = new QListWidget;
  steps_->setObjectName("editorSteps");
  steps_->setAccessibleName(tr("steps"));
  column->addWidget(steps_, 1);
  add_ = makeEditorButton("editorAdd", tr("&Add step from what is shown"));
  add_->setToolTip(tr("The scene, the tab and the quantity of the chart, as they are now"));
  up_ = makeEditorButton("editorUp", tr("&Up"));
  down_ = makeEditorButton("editorDown", tr("&Down"));
  remove_ = makeEditorButton("editorRemove", tr("&Remove"));
  column->addWidget(add_);
  auto* line = new QHBoxLayout;
  for (QPushButton* one : {up_, down_, remove_}) line->addWidget(one);
  column->addLayout(line);
  connect(add_, &QPushButton::clicked, this, &LessonEditor::addShownStep);
  connect(up_, &QPushButton::clicked, this, [this] { moveStep(-1); });
  connect(down_, &QPushButton::clicked, this, [this] { moveStep(1); });
  connect(remove_, &QPushButton::clicked, this, &LessonEditor::removeStep);
  // The part is as wide as its buttons need, in the font that the window has now.
  part->setMinimumWidth(kListWidth);
  part->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
  return part;
}

QLayout* LessonEditor::buildFoot() {
  try_ = makeEditorButton("editorTry", tr("&Try this step"));
  open_ = makeEditorButton("editorOpen", tr("&Open…"));
  connect(open_, &QPushButton::clicked, this, &LessonEditor::openOther);
  handout_ = makeEditorButton("editorHandout", tr("&Handout…"));
  handout_->setToolTip(tr("Pages to print, as PDF or as a web page"));
  saver_ = new HandoutSaver(this);
  connect(handout_, &QPushButton::clicked, this, [this] {
    const QString name = QFileInfo(file_).completeBaseName();
    saver_->ask(checked(), name.isEmpty() ? QStringLiteral("lesson") : name);
  });
  connect(saver_, &HandoutSaver::statusChanged, messageLabel_, &QLabel::setText);
  connect(saver_, &HandoutSaver::statusChanged, this, &LessonEditor::showButtons);
  save_ = makeEditorButton("editorSave", tr("&Save"));
  save_->setToolTip(tr("Also saves a lesson that is not complete yet (Ctrl+S)"));
  saveAs_ = makeEditorButton("editorSaveAs", tr("Sa&ve as…"));
  close_ = makeEditorButton("editorClose", tr("&Close"));
  connect(try_, &QPushButton::clicked, this, [this] {
    try {
      emit trialRequested(checked(), std::max(0, steps_->currentRow() - 1));
    } catch (const InputError&) {
      check();
    }
  });
  connect(save_, &QPushButton::clicked, this, &LessonEditor::save);
  connect(saveAs_, &QPushButton::clicked, this, &LessonEditor::askAndSave);
  undo_ = makeEditorButton("editorUndo", tr("U&ndo"));
  redo_ = makeEditorButton("editorRedo", tr("R&edo"));
  connect(undo_, &QPushButton::clicked, this, &LessonEditor::undo);
  connect(redo_, &QPushButton::clicked, this, &LessonEditor::redo);
  connect(close_, &QPushButton::clicked, this, &LessonEditor::reject);
  auto* foot = new QHBoxLayout;
  for (QPushButton* one : {open_, handout_, undo_, redo_}) foot->addWidget(one);
  foot->addStretch(1);
  for (QPushButton* one : {close_, try_, saveAs_, save_}) foot->addWidget(one);
  return foot;
}

// ---- Showing

LessonStep* LessonEditor::present() {
  const int row = steps_->currentRow() - 1;
  return row < 0 || row >= static_cast<int>(lesson_.steps.size())
             ? nullptr
             : &lesson_.steps[static_cast<std::size_t>(row)];
}

bool LessonEditor::isGerman() const {
  return language_->currentIndex() == 1;
}

/// Returns the name of a step in the list.
QString LessonEditor::stepName(std::size_t step) const {
  const QString title =
      QString::fromStdString(lesson_.steps[step].title.in(isGerman() ? "de" : "en"));
  return tr("%1. %2").arg(step + 1).arg(title.isEmpty() ? tr("(no title)") : title);
}

void LessonEditor::showList() {
  const int row = steps_->currentRow();
  const bool wasShowing = std::exchange(isShowing_, true);
  steps_->clear();
  steps_->addItem(tr("The lesson"));
  for (std::size_t i = 0; i < lesson_.steps.size(); ++i) steps_->addItem(stepName(i));
  isShowing_ = wasShowing;
  steps_->setCurrentRow(std::clamp(row, 0, steps_->count() - 1));
}

void LessonEditor::showStep() {
  if (isShowing_) return;
  const LessonStep* step = present();
  const int row = steps_->currentRow() - 1;
  up_->setEnabled(step && row > 0);
  down_->setEnabled(step && row + 1 < static_cast<int>(lesson_.steps.size()));
  remove_->setEnabled(step != nullptr);
  for (LessonForm* page : std::initializer_list<LessonForm*>{head_, step_})
    page->setGerman(isGerman());
  head_->showLesson(lesson_);
  if (step) step_->showStep(*step, sceneText(static_cast<std::size_t>(row)));
  pages_->setCurrentIndex(step ? 1 : 0);
  typedIn_.clear();
  if (!states_.empty()) check();
}

/// Returns the name of the scene with which a step begins.
QString LessonEditor::sceneText(std::size_t step) const {
  const LessonStep& asked = lesson_.steps[step];
  QString title = translatedText(Message(asked.scene.title));
  if (title.isEmpty()) title = tr("(no title)");
  const bool goesOn = asked.sceneName.empty() && asked.sceneJson.empty();
  return goesOn ? tr("%1, as step %2 leaves it").arg(title).arg(step) : title;
}

// ---- Taking what is written

void LessonEditor::take() {
  if (LessonStep* step = present())
    step_->take(*step);
  else
    head_->take(lesson_);
  const QWidget* field = focusWidget();
  const bool isTyped = qobject_cast<const QLineEdit*>(field) ||
                       qobject_cast<const QPlainTextEdit*>(field) ||
                       qobject_cast<const QAbstractSpinBox*>(field);
  typedIn_ = isTyped ? field->objectName() : QString();
  check();
}

/// Returns the lesson as its file would be read.
Lesson LessonEditor::checked() const {
  return readLesson(writeLesson(lesson_), lesson_.name, folder(), readNamedScene);
}

/// Returns the folder of the lesson's file, in which its scenes are. Without a file it is that of
/// the shipped scenes for a shipped lesson, and empty for a new one, which names no scenes.
std::filesystem::path LessonEditor::folder() const {
  const bool isShipped =
      file_.isEmpty() && std::ranges::find(shippedLessons(), lesson_.name, &ShippedLesson::name) !=
                             shippedLessons().end();
  return isShipped ? std::filesystem::path(kShippedFolder)
                   : std::filesystem::path(file_.toStdString()).parent_path();
}

/// Shows an error, with its key in the words of the editor where there are such words.
void LessonEditor::showError(const InputError& error) {
  errorText_ = translatedText(InputError("", error.key(), error.message()).message());
  QString key = keyText(QString::fromStdString(error.key()));
  if (!key.isEmpty()) errorText_ = key.replace(0, 1, key[0].toUpper()) + ": " + errorText_;
}

/// Gives the steps the scenes that they have in the lesson as read.
void LessonEditor::takeScenes(const Lesson& read) {
  for (std::size_t i = 0; i < read.steps.size(); ++i) {
    lesson_.steps[i].scene = read.steps[i].scene;
    lesson_.steps[i].revealedScene = read.steps[i].revealedScene;
  }
}

/// Says in the tabs of the languages how many texts each of them lacks, where it has some.
void LessonEditor::showMissing() {
  const QString names[] = {QStringLiteral("English"), QStringLiteral("Deutsch")};
  const QStringList missing[] = {missingTexts(lesson_, false), missingTexts(lesson_, true)};
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

/// Reads the lesson as if it came from a file, which finds every mistake, and the steps' scenes.
void LessonEditor::check() {
  const int row = steps_->currentRow() - 1;
  isComputing_ = false;
  errorText_ = present() ? step_->unreadable() : QString();
  if (!errorText_.isEmpty()) errorText_ = tr("Step %1: %2").arg(row + 1).arg(errorText_);
  if (errorText_.isEmpty()) errorText_ = findMistake(lesson_);
  try {
    takeScenes(checked());
    if (errorText_.isEmpty() && !checkAnswers()) stopComputing();
  } catch (const InputError& error) {
    if (errorText_.isEmpty()) showError(error);
    try {
      takeScenes(readDraft(writeLesson(lesson_), lesson_.name, folder(), readNamedScene));
    } catch (const InputError&) {
      // The scenes stay as they are.
    }
  }
  step_->showComputed(computedText());
  showMissing();
  messageLabel_->setText(whyNotPlayed());
  remember();
  showButtons();
  if (QListWidgetItem* item = row >= 0 ? steps_->item(row + 1) : nullptr)
    item->setText(stepName(static_cast<std::size_t>(row)));
}

/// Returns why the lesson cannot be played, or not yet; empty where it can.
QString LessonEditor::whyNotPlayed() const {
  return isComputing_ ? tr("The program computes an answer that no choice may cover…") : errorText_;
}

// ---- Computed answers

const LessonEditor::Computed* LessonEditor::computed(const LessonStep& step) const {
  if (!asksForNumber(step)) return nullptr;
  const auto found = std::ranges::find(computed_, numberAsked(step), &Computed::asked);
  return found == computed_.end() ? nullptr : &*found;
}

/// Computes the answer of a step in the background unless it is known. Returns whether it is being
/// computed.
bool LessonEditor::compute(const LessonStep& step) {
  if (!asksForNumber(step) || computed(step)) return false;
  Computed one{numberAsked(step)};
  if (pending_ && pending_->asked == one.asked) return true;
  pending_ = one;
  const auto keep = [this](const Computed& known) {
    pending_.reset();
    computed_.push_back(known);
    check();
  };
  computing_.request(
      [one](const BackgroundWork::Run& run) {
        CurveOptions options;
        options.stop = run.stop();
        return lessonAnswer(one.asked, options);
      },
      [one, keep](const LessonAnswer& answer) {
        Computed known = one;
        known.answer = answer;
        keep(known);
      },
      [one, keep](const QString& reason) {
        Computed known = one;
        known.failure = reason;
        keep(known);
      });
  return true;
}

/// Shows an error where no choice covers a computed answer, or where there is none. Answers that
/// are not known yet are computed one after the other: those that may be covered by no choice,
/// without which the lesson is not played, and that of the present step, which is shown. Returns
/// whether one is being computed, or may be again as soon as an error is corrected.
bool LessonEditor::checkAnswers() {
  for (std::size_t i = 0; i < lesson_.steps.size(); ++i) {
    const LessonStep& step = lesson_.steps[i];
    const Computed* known = computed(step);
    if (known && !known->failure.isEmpty()) {
      errorText_ = tr("Step %1, computed answer: %2").arg(i + 1).arg(known->failure);
      return true;
    }
    if (!step.prediction || !leavesOutNumbers(*step.prediction)) continue;
    if (compute(step)) {
      isComputing_ = true;
      return true;
    }
    try {
      rightChoice(*step.prediction, known->answer.number);
    } catch (const InputError& error) {
      showError(InputError("", "steps[" + std::to_string(i) + "].prediction." + error.key(),
                           error.message()));
      return true;
    }
  }
  const LessonStep* step = present();
  return step && compute(*step);
}

/// Stops the computation of an answer that nobody needs any more.
void LessonEditor::stopComputing() {
  if (!pending_) return;
  pending_.reset();
  computing_.cancel();
}

/// Returns the text about the computed answer of the present step.
QString LessonEditor::computedText() const {
  const int row = steps_->currentRow() - 1;
  if (row < 0 || row >= static_cast<int>(lesson_.steps.size())) return {};
  const LessonStep& step = lesson_.steps[static_cast<std::size_t>(row)];
  if (!asksForNumber(step)) return {};
  QStringList sentences;
  // There is always a first sentence: what is below would move when it comes.
  const Computed* known = computed(step);
  const bool isComputed = known && known->failure.isEmpty();
  QString found = isComputed ? fromUtf8(numberInWords(known->answer.number)) : QString();
  if (isComputed && step.prediction->kind == PredictionKind::Point)
    found = pointInWords(known->answer.number, known->answer.x);
  sentences += isComputed ? tr("The program finds %1.").arg(found)
               : known    ? tr("The program finds no answer.")
               : errorText_.isEmpty()
                   ? tr("The program computes the answer…")
                   : tr("The program computes the answer when the lesson is complete.");
  if (step.scene.ensemble.realizations > 1)
    sentences += tr("Computed answers are means over the scene's %1 lines; the picture shows one.")
                     .arg(step.scene.ensemble.realizations);
  if (keepsPicture(step))
    sentences +=
        tr("The picture stays as it is when the answer is shown: “Changed with the answer” "
           "does not have the changes of the computed answer.");
  if (showsAnswer(step)) sentences += tr("The curve, which is in sight, may show this answer.");
  return sentences.join('\n');
}

// ---- Undo and redo

/// Keeps the lesson for undo. What is typed into one field without a break is one edit.
void LessonEditor::remember() {
  if (states_.empty() || writeLesson(states_[state_].lesson) == writeLesson(lesson_)) return;
  const bool goesOn = !typedIn_.isEmpty() && state_ > 0 && states_[state_].field == typedIn_ &&
                      states_[state_].row == steps_->currentRow();
  states_.resize(state_ + (goesOn ? 0 : 1));
  states_.push_back({lesson_, steps_->currentRow(), typedIn_});
  state_ = states_.size() - 1;
  keepSoon();
}

/// Edits that follow each other do not put the keeping off.
void LessonEditor::keepSoon() {
  if (!keeping_->isActive()) keeping_->start();
}

/// Keeps the lesson against a crash until it is saved or discarded.
void LessonEditor::keepUnsaved() {
  if (writeLesson(saved_) == writeLesson(lesson_)) return forgetDraft();
  const QString file = file_.isEmpty() ? QString() : QFileInfo(file_).absoluteFilePath();
  keepDraft({lesson_, saved_, file.toStdString()}, folder().string());
}

void LessonEditor::forgetUnsaved() {
  keeping_->stop();
  forgetDraft();
}

/// Goes back or forward by one edit, and shows the step that it changed.
void LessonEditor::restore(int by) {
  if (by < 0 ? state_ == 0 : state_ + 1 >= states_.size()) return;
  const int row = states_[by < 0 ? state_ : state_ + 1].row;
  state_ = by < 0 ? state_ - 1 : state_ + 1;
  states_[state_].field.clear();  // what is typed now is another edit
  lesson_ = states_[state_].lesson;
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
  for (QPushButton* button : {try_, handout_})
    button->setEnabled(whyNotPlayed().isEmpty() && !(button == handout_ && saver_->isSaving()));
  undo_->setEnabled(state_ > 0);
  redo_->setEnabled(state_ + 1 < states_.size());
}

// ---- Steps

/// Adds a step below the present one. It starts from the scene of the previous step where a change
/// of keys can express it, and has a scene of its own otherwise.
void LessonEditor::addShownStep() {
  const int row = std::max(0, steps_->currentRow());
  const std::optional<LessonStep> taken = takenStep();
  if (!taken) return;
  LessonStep step = *taken;
  Scene scene = step.scene;
  if (row > 0) {
    Scene before = lesson_.steps[static_cast<std::size_t>(row - 1)].revealedScene;
    if (before.folder == kShippedFolder) before.folder.clear();  // it holds no files
    scene.title = before.title;
    scene.description = before.description;
    scene.chapter = before.chapter;
    step.set = differingAssignments(before, scene);
    try {
      if (!(withKeys(before, step.set) == scene) || before.folder != scene.folder)
        step.sceneJson = writeScene(step.scene);
    } catch (const InputError&) {
      step.sceneJson = writeScene(step.scene);
    }
  } else {
    step.sceneJson = writeScene(step.scene);
  }
  if (!step.sceneJson.empty()) step.set.clear();
  // The step after it goes on from another scene now, unless it has one of its own.
  keepOwnScene(static_cast<std::size_t>(row));
  step.text.english = isGerman() ? "" : tr("What is to be seen here?").toStdString();
  if (isGerman()) step.text.german = tr("What is to be seen here?").toStdString();
  lesson_.steps.insert(lesson_.steps.begin() + row, step);
  showList();
  steps_->setCurrentRow(row + 1);
  check();
  showStep();
  step_->beginText();
}

/// Returns the step that the window shows; else says why there is none.
std::optional<LessonStep> LessonEditor::takenStep() {
  std::optional<LessonStep> taken = shownNow_();
  if (!taken)
    messageLabel_->setText(
        tr("The main window shows the gallery. Open a scene in it, then add the step."));
  return taken;
}

/// Gives a step that goes on from the one before a scene of its own, so that it stays the same
/// wherever it stands; its changes stay changes.
void LessonEditor::keepOwnScene(std::size_t step) {
  if (step == 0 || step >= lesson_.steps.size()) return;
  LessonStep& kept = lesson_.steps[step];
  if (kept.sceneName.empty() && kept.sceneJson.empty())
    kept.sceneJson = writeScene(lesson_.steps[step - 1].revealedScene);
}

/// Removes the present step. The one after it begins where the removed one began, with the changes
/// of both, where that is the same scene; else it has a scene of its own.
void LessonEditor::removeStep() {
  const int row = steps_->currentRow() - 1;
  if (!present()) return;
  const auto place = static_cast<std::size_t>(row);
  if (const std::size_t next = place + 1; next < lesson_.steps.size()) {
    const LessonStep& removed = lesson_.steps[place];
    LessonStep& after = lesson_.steps[next];
    const LessonStep before = after;
    keepOwnScene(next);
    if (before.sceneName.empty() && before.sceneJson.empty()) {
      const LessonStep own = after;
      std::vector<std::string> set = removed.set;
      for (const std::vector<std::string>* more : {&removed.after, &before.set})
        for (const std::string& one : *more) {
          std::erase_if(set, [&](const std::string& old) {
            return assignmentKey(old) == assignmentKey(one);
          });
          set.push_back(one);
        }
      after.sceneName = removed.sceneName;
      after.sceneJson = removed.sceneJson;
      after.set = set;
      Lesson without = lesson_;
      without.steps.erase(without.steps.begin() + row);
      if (!isReadAs(without, place, before.scene, folder())) after = own;
    }
  }
  lesson_.steps.erase(lesson_.steps.begin() + row);
  showList();
  check();
  showStep();
}

void LessonEditor::takeShownScene() {
  LessonStep* step = present();
  if (!step) return;
  const std::optional<LessonStep> taken = takenStep();
  if (!taken) return;
  keepOwnScene(static_cast<std::size_t>(steps_->currentRow()));
  step->sceneName.clear();
  step->sceneJson = writeScene(taken->scene);
  step->set.clear();
  typedIn_.clear();
  check();
  showStep();
}

/// Moves the present step; steps that went on from the one before keep the scenes that they had.
void LessonEditor::moveStep(int by) {
  const int row = steps_->currentRow() - 1, other = row + by;
  if (!present() || other < 0 || other >= static_cast<int>(lesson_.steps.size())) return;
  const auto first = static_cast<std::size_t>(std::min(row, other));
  for (std::size_t i = first; i < std::min(first + 3, lesson_.steps.size()); ++i) keepOwnScene(i);
  std::swap(lesson_.steps[static_cast<std::size_t>(row)],
            lesson_.steps[static_cast<std::size_t>(other)]);
  showList();
  steps_->setCurrentRow(other + 1);
  check();
  showStep();
}

// ---- The file

void LessonEditor::openOther() {
  if (!canClose()) return;
  const QString file = QFileDialog::getOpenFileName(this, tr("Open lesson"), file_,
                                                    tr("Lessons (*.json);;All files (*)"));
  if (!file.isEmpty()) openFile(file);
}

void LessonEditor::openFile(const QString& file) {
  try {
    lesson_ = saved_ = readDraftFile(file.toStdString(), readNamedScene);
    file_ = file;
  } catch (const std::exception& error) {
    messageLabel_->setText(translatedError(error));
    return;
  }
  forgetUnsaved();
  stopComputing();
  computed_.clear();
  states_.assign(1, {lesson_});
  state_ = 0;
  steps_->setCurrentRow(0);
  showList();
  showStep();
}

bool LessonEditor::saveTo(const QString& file) {
  try {
    const std::filesystem::path path = std::filesystem::absolute(file.toStdString());
    const std::string text = writeLesson(lesson_);
    readDraft(text, path.string(), path.parent_path(), readNamedScene);
    writeFileAtomically(path, text);
  } catch (const std::exception& error) {
    messageLabel_->setText(translatedError(error));
    return false;
  }
  file_ = file;
  saved_ = lesson_;
  forgetUnsaved();
  const QString name = QFileInfo(file).fileName();
  const QString reason = whyNotPlayed();
  messageLabel_->setText(
      reason.isEmpty() ? tr("Saved %1").arg(name)
                       : tr("Saved %1 as a draft. Before it can be played: %2").arg(name, reason));
  return true;
}

bool LessonEditor::save() {
  return file_.isEmpty() ? askAndSave() : saveTo(file_);
}

bool LessonEditor::askAndSave() {
  const QString name = file_.isEmpty() ? QStringLiteral("lesson.json") : file_;
  const QString file =
      askSaveFile(questionParent(), tr("Save lesson"), name, tr("Lessons (*.json)"));
  return !file.isEmpty() && saveTo(file);
}

/// Returns the window over which questions appear: the editor is hidden during a trial.
QWidget* LessonEditor::questionParent() {
  return isVisible() || !parentWidget() ? this : parentWidget();
}

bool LessonEditor::canClose() {
  if (writeLesson(saved_) == writeLesson(lesson_)) {
    forgetUnsaved();
    return true;
  }
  const SaveAnswer answer = askSaveChanges(questionParent(), "editorUnsaved", tr("Lesson editor"),
                                           tr("The lesson was changed and not saved."));
  if (answer == SaveAnswer::Discard) forgetUnsaved();
  if (answer != SaveAnswer::Save) return answer == SaveAnswer::Discard;
  return save();
}

LessonEditor::Session LessonEditor::session() const {
  return {lesson_,
          saved_,
          file_,
          states_,
          state_,
          steps_->currentRow(),
          language_->currentIndex(),
          saveGeometry()};
}

void LessonEditor::restoreSession(const Session& session) {
  lesson_ = session.lesson;
  saved_ = session.saved;
  file_ = session.file;
  states_ = session.states;
  state_ = session.state;
  keepSoon();
  language_->setCurrentIndex(session.language);
  restoreGeometry(session.geometry);
  showList();
  steps_->setCurrentRow(std::clamp(session.row, 0, steps_->count() - 1));
  showStep();
}

void LessonEditor::showDraft(const Lesson& lesson) {
  lesson_ = lesson;
  showList();
  check();
  showStep();
}

void LessonEditor::reject() {
  if (canClose()) QDialog::reject();
}

}  // namespace asperity
