#include "ui/window/lesson/lesson_editor.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>
#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/scene/parameters.h"
#include "core/scene/scene_file.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/parameter_row.h"
#include "ui/window/lesson/handout_saver.h"
#include "ui/window/lesson/lesson_pages.h"
#include "ui/window/main/picture_files.h"
#include "ui/window/main/scene_library.h"

namespace asperity {

namespace {

constexpr QSize kDefault(960, 660);  // pixels
constexpr int kAround = 60;          // pixels of the screen that stay free

/// Returns the name of a row of the editor for a member of a lesson's file; null: it has no row.
QString rowOf(const QString& member) {
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
    } else if (const QString row = rowOf(members[i]); !row.isEmpty()) {
      words += row;
    }
  }
  return words.join(QStringLiteral(", "));
}

}  // namespace

LessonEditor::LessonEditor(const Lesson& lesson, const QString& file,
                           std::function<LessonStep()> shownNow, QWidget* parent)
    : QDialog(parent),
      lesson_(lesson),
      saved_(lesson),
      file_(file),
      shownNow_(std::move(shownNow)) {
  setObjectName("lessonEditor");
  setWindowTitle(tr("Lesson editor"));
  language_ = new QTabBar;
  language_->setObjectName("editorLanguage");
  language_->addTab(QStringLiteral("English"));
  language_->addTab(QStringLiteral("Deutsch"));
  language_->setCurrentIndex(presentLanguage() == "de" ? 1 : 0);
  language_->setDrawBase(false);
  language_->setExpanding(false);
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
  resize(kDefault.boundedTo(available - QSize(kAround, kAround)));
  connect(language_, &QTabBar::currentChanged, this, &LessonEditor::showStep);
  connect(steps_, &QListWidget::currentRowChanged, this, &LessonEditor::showStep);
  showList();
  steps_->setCurrentRow(0);
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
  const auto button = [&](const char* name, const QString& text) {
    auto* made = new QPushButton(text);
    made->setObjectName(name);
    made->setAutoDefault(false);
    return made;
  };
  add_ = button("editorAdd", tr("&Add step from what is shown"));
  add_->setToolTip(tr("The scene, the tab and the quantity of the chart, as they are now"));
  up_ = button("editorUp", tr("&Up"));
  down_ = button("editorDown", tr("&Down"));
  remove_ = button("editorRemove", tr("&Remove"));
  column->addWidget(add_);
  auto* line = new QHBoxLayout;
  for (QPushButton* one : {up_, down_, remove_}) line->addWidget(one);
  column->addLayout(line);
  connect(add_, &QPushButton::clicked, this, &LessonEditor::addShownStep);
  connect(up_, &QPushButton::clicked, this, [this] { moveStep(-1); });
  connect(down_, &QPushButton::clicked, this, [this] { moveStep(1); });
  connect(remove_, &QPushButton::clicked, this, &LessonEditor::removeStep);
  part->setFixedWidth(std::max(250, add_->sizeHint().width()));
  return part;
}

QLayout* LessonEditor::buildFoot() {
  const auto button = [](const char* name, const QString& text) {
    auto* made = new QPushButton(text);
    made->setObjectName(name);
    made->setAutoDefault(false);
    return made;
  };
  try_ = button("editorTry", tr("&Try this step"));
  open_ = button("editorOpen", tr("&Open…"));
  connect(open_, &QPushButton::clicked, this, &LessonEditor::openOther);
  handout_ = button("editorHandout", tr("&Handout…"));
  handout_->setToolTip(tr("Pages to print, as PDF or as a web page"));
  saver_ = new HandoutSaver(this);
  connect(handout_, &QPushButton::clicked, this, [this] {
    const QString name = QFileInfo(file_).completeBaseName();
    saver_->ask(checked(), name.isEmpty() ? QStringLiteral("lesson") : name);
  });
  connect(saver_, &HandoutSaver::statusChanged, messageLabel_, &QLabel::setText);
  connect(saver_, &HandoutSaver::savingChanged, this, &LessonEditor::showButtons);
  save_ = button("editorSave", tr("&Save…"));
  close_ = button("editorClose", tr("&Close"));
  connect(try_, &QPushButton::clicked, this, [this] {
    try {
      emit trialRequested(checked(), std::max(0, steps_->currentRow() - 1));
    } catch (const InputError&) {
      check();
    }
  });
  connect(save_, &QPushButton::clicked, this, [this] {
    const QString name = file_.isEmpty() ? QStringLiteral("lesson.json") : file_;
    const QString file = askSaveFile(this, tr("Save lesson"), name, tr("Lessons (*.json)"));
    if (!file.isEmpty()) saveTo(file);
  });
  connect(close_, &QPushButton::clicked, this, &LessonEditor::reject);
  auto* foot = new QHBoxLayout;
  foot->addWidget(open_);
  foot->addWidget(handout_);
  foot->addStretch(1);
  for (QPushButton* one : {close_, try_, save_}) foot->addWidget(one);
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
QString LessonEditor::nameOf(std::size_t step) const {
  const QString title =
      QString::fromStdString(lesson_.steps[step].title.in(isGerman() ? "de" : "en"));
  return tr("%1. %2").arg(step + 1).arg(title.isEmpty() ? tr("(no title)") : title);
}

void LessonEditor::showList() {
  const int row = steps_->currentRow();
  const bool wasShowing = std::exchange(isShowing_, true);
  steps_->clear();
  steps_->addItem(tr("The lesson"));
  for (std::size_t i = 0; i < lesson_.steps.size(); ++i) steps_->addItem(nameOf(i));
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
  if (step) step_->showStep(*step);
  pages_->setCurrentIndex(step ? 1 : 0);
}

// ---- Taking what is written

void LessonEditor::take() {
  if (LessonStep* step = present())
    step_->take(*step);
  else
    head_->take(lesson_);
  check();
}

/// Returns the lesson as its file would be read.
Lesson LessonEditor::checked() const {
  return readLesson(writeLesson(lesson_), lesson_.name,
                    std::filesystem::path(file_.toStdString()).parent_path(), readNamedScene);
}

/// Reads the lesson as if it came from a file, which finds every mistake, and the steps' scenes.
void LessonEditor::check() {
  const int row = steps_->currentRow() - 1;
  errorText_.clear();
  try {
    const Lesson read = checked();
    for (std::size_t i = 0; i < read.steps.size(); ++i) {
      lesson_.steps[i].scene = read.steps[i].scene;
      lesson_.steps[i].revealedScene = read.steps[i].revealedScene;
    }
  } catch (const InputError& error) {
    errorText_ = translatedText(InputError("", error.key(), error.message()).message());
    QString key = keyText(QString::fromStdString(error.key()));
    if (!key.isEmpty()) errorText_ = key.replace(0, 1, key[0].toUpper()) + ": " + errorText_;
  }
  messageLabel_->setText(errorText_);
  showButtons();
  if (QListWidgetItem* item = row >= 0 ? steps_->item(row + 1) : nullptr)
    item->setText(nameOf(static_cast<std::size_t>(row)));
}

/// Enables what a lesson without mistakes allows.
void LessonEditor::showButtons() {
  for (QPushButton* button : {save_, try_, handout_})
    button->setEnabled(errorText_.isEmpty() && !(button == handout_ && saver_->isSaving()));
}

// ---- Steps

/// Adds a step below the present one. It starts from the scene of the previous step where a change
/// of keys can express it, and has a scene of its own otherwise.
void LessonEditor::addShownStep() {
  const int row = std::max(0, steps_->currentRow());
  LessonStep step = shownNow_();
  Scene scene = step.scene;
  if (row > 0) {
    const Scene before = lesson_.steps[static_cast<std::size_t>(row - 1)].revealedScene;
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
  step.text.english = isGerman() ? "" : tr("What is to be seen here?").toStdString();
  if (isGerman()) step.text.german = tr("What is to be seen here?").toStdString();
  lesson_.steps.insert(lesson_.steps.begin() + row, step);
  // The next step now starts from another scene, unless it has one of its own.
  const auto after = static_cast<std::size_t>(row) + 1;
  if (after < lesson_.steps.size()) {
    LessonStep& next = lesson_.steps[after];
    if (next.sceneName.empty() && next.sceneJson.empty()) {
      next.sceneJson = writeScene(next.scene);
      next.set.clear();
    }
  }
  showList();
  steps_->setCurrentRow(row + 1);
  check();
  showStep();
  step_->beginText();
}

void LessonEditor::removeStep() {
  const int row = steps_->currentRow() - 1;
  if (!present()) return;
  const auto next = static_cast<std::size_t>(row) + 1;
  if (next < lesson_.steps.size()) {
    LessonStep& after = lesson_.steps[next];
    if (after.sceneName.empty() && after.sceneJson.empty()) {
      after.sceneJson = writeScene(after.scene);
      after.set.clear();
    }
  }
  lesson_.steps.erase(lesson_.steps.begin() + row);
  showList();
  check();
  showStep();
}

/// Moves the present step; steps that went on from the one before keep the scenes that they had.
void LessonEditor::moveStep(int by) {
  const int row = steps_->currentRow() - 1, other = row + by;
  if (!present() || other < 0 || other >= static_cast<int>(lesson_.steps.size())) return;
  const auto first = static_cast<std::size_t>(std::min(row, other));
  for (std::size_t i = first; i < std::min(first + 3, lesson_.steps.size()); ++i) {
    LessonStep& step = lesson_.steps[i];
    if (!step.sceneName.empty() || !step.sceneJson.empty()) continue;
    step.sceneJson = writeScene(step.scene);
    step.set.clear();
  }
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
  if (file.isEmpty()) return;
  try {
    lesson_ = saved_ = readLessonFile(file.toStdString(), readNamedScene);
    file_ = file;
  } catch (const std::exception& error) {
    messageLabel_->setText(translatedError(error));
    return;
  }
  steps_->setCurrentRow(0);
  showList();
  showStep();
  check();
}

bool LessonEditor::saveTo(const QString& file) {
  try {
    const std::filesystem::path path = std::filesystem::absolute(file.toStdString());
    const std::string text = writeLesson(lesson_);
    readLesson(text, path.string(), path.parent_path(), readNamedScene);
    writeFileAtomically(path, text);
  } catch (const std::exception& error) {
    messageLabel_->setText(translatedError(error));
    return false;
  }
  file_ = file;
  saved_ = lesson_;
  messageLabel_->setText(tr("Saved %1").arg(QFileInfo(file).fileName()));
  return true;
}

bool LessonEditor::canClose() {
  if (writeLesson(saved_) == writeLesson(lesson_)) return true;
  const auto answer = QMessageBox::question(
      this, tr("Lesson editor"),
      tr("The lesson was changed and not saved. Close it and lose the changes?"));
  return answer == QMessageBox::Yes;
}

void LessonEditor::reject() {
  if (canClose()) QDialog::reject();
}

}  // namespace asperity
