#include "ui/window/lesson/lesson_editor.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QSpinBox>
#include <QStackedWidget>
#include <QTabBar>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/friction/curve_file.h"
#include "core/friction/curve_quantity.h"
#include "core/scene/parameters.h"
#include "core/scene/scene_file.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/number_text.h"
#include "ui/panels/parameter_row.h"
#include "ui/window/main/picture_files.h"
#include "ui/window/main/scene_library.h"

namespace asperity {

namespace {

constexpr QSize kUsual(960, 660);  // pixels
constexpr int kAround = 60;        // pixels of the screen that stay free
constexpr int kMostChoices = 6;

enum ValueKind { kThere, kRatio, kPeak };
enum Kind { kNone, kChoice, kNumber, kPoint };

QString joined(const std::vector<std::string>& assignments) {
  return QString::fromStdString(joinedAssignments(assignments));
}

std::vector<std::string> assignmentsIn(const QString& text) {
  std::vector<std::string> assignments;
  for (std::string& one : separatedAssignments(text.toStdString())) {
    const std::size_t first = one.find_first_not_of(' '), last = one.find_last_not_of(' ');
    if (first != one.npos) assignments.push_back(one.substr(first, last - first + 1));
  }
  return assignments;
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
  pages_ = new QStackedWidget;
  pages_->addWidget(buildHead());
  pages_->addWidget(buildStep());
  auto* right = new QVBoxLayout;
  right->addWidget(language_);
  right->addWidget(pages_, 1);
  auto* halves = new QHBoxLayout;
  halves->setSpacing(14);
  halves->addWidget(buildSteps());
  halves->addLayout(right, 1);
  said_ = new QLabel;
  said_->setObjectName("editorComplaint");
  said_->setWordWrap(true);
  said_->setTextFormat(Qt::PlainText);
  said_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  said_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(14, 12, 14, 12);
  all->addLayout(halves, 1);
  all->addWidget(said_);
  all->addLayout(buildFoot());
  const QSize room = (parent ? parent->screen() : screen())->availableSize();
  resize(kUsual.boundedTo(room - QSize(kAround, kAround)));
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

QLineEdit* LessonEditor::addLine(QFormLayout& form, const QString& label, const char* name) {
  auto* line = new QLineEdit;
  line->setObjectName(name);
  line->setAccessibleName(label);
  form.addRow(label, line);
  connect(line, &QLineEdit::textEdited, this, &LessonEditor::take);
  return line;
}

QPlainTextEdit* LessonEditor::addText(QFormLayout& form, const QString& label, const char* name,
                                      int lines) {
  auto* text = new QPlainTextEdit;
  text->setObjectName(name);
  text->setAccessibleName(label);
  text->setTabChangesFocus(true);
  text->setFixedHeight(lines * fontMetrics().lineSpacing() + 12);
  form.addRow(label, text);
  connect(text, &QPlainTextEdit::textChanged, this, &LessonEditor::take);
  return text;
}

QWidget* LessonEditor::buildHead() {
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  title_ = addLine(*form, tr("Title"), "editorTitle");
  goal_ = addText(*form, tr("Goal"), "editorGoal", 4);
  minutes_ = new QSpinBox;
  minutes_->setObjectName("editorMinutes");
  minutes_->setRange(1, 600);
  minutes_->setAccessibleName(tr("Minutes"));
  form->addRow(tr("Minutes"), minutes_);
  connect(minutes_, &QSpinBox::valueChanged, this, &LessonEditor::take);
  notes_ = addText(*form, tr("Notes for teachers"), "editorNotes", 8);
  return page;
}

QWidget* LessonEditor::buildStep() {
  auto* content = new QWidget;
  stepForm_ = new QFormLayout(content);
  QFormLayout& form = *stepForm_;
  form.setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  stepTitle_ = addLine(form, tr("Title"), "editorStepTitle");
  text_ = addText(form, tr("Text"), "editorText", 6);
  text_->setToolTip(
      tr("An empty line begins a paragraph; *word* and **word** emphasize; a line "
         "that begins with “- ” is an item"));
  set_ = addLine(form, tr("Change of keys"), "editorSet");
  set_->setPlaceholderText(QStringLiteral("load.normal_force=20mN; sliding.velocity=0.1"));
  const auto choice = [&](const QString& label, const char* name) {
    auto* box = new QComboBox;
    box->setObjectName(name);
    box->setAccessibleName(label);
    form.addRow(label, box);
    connect(box, &QComboBox::activated, this, &LessonEditor::take);
    return box;
  };
  tab_ = choice(tr("Tab"), "editorTab");
  for (const std::string_view word : kLessonTabs) tab_->addItem(wordText(word), fromUtf8(word));
  quantity_ = choice(tr("Vertical axis"), "editorQuantity");
  for (const QuantityEntry& entry : quantityEntries())
    quantity_->addItem(translatedText(entry.title), fromUtf8(entry.word.text()));
  controls_ = new QToolButton;
  controls_->setObjectName("editorControls");
  controls_->setPopupMode(QToolButton::InstantPopup);
  controls_->setMenu(new QMenu(controls_));
  form.addRow(tr("Free controls"), controls_);
  connect(controls_->menu(), &QMenu::aboutToShow, this, &LessonEditor::fillControls);
  kind_ = choice(tr("Prediction"), "editorKind");
  kind_->addItems({tr("none"), tr("a choice"), tr("a number"), tr("a point on the chart")});
  connect(kind_, &QComboBox::activated, this, &LessonEditor::showKind);
  question_ = addLine(form, tr("Question"), "editorQuestion");
  choices_ = new QTableWidget(kMostChoices, 4);
  choices_->setObjectName("editorChoices");
  choices_->setAccessibleName(tr("choices"));
  choices_->setHorizontalHeaderLabels({tr("Choice"), tr("Right"), tr("From"), tr("To")});
  choices_->setToolTip(
      tr("Tick the right one; or leave all unticked, give the range of the "
         "computed answer for which each is right, and say below what is computed"));
  choices_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  for (int column = 1; column < 4; ++column)
    choices_->setColumnWidth(column, 8 * fontMetrics().horizontalAdvance('0'));
  choices_->verticalHeader()->hide();
  choices_->setFixedHeight(5 * (fontMetrics().lineSpacing() + 12));
  choices_->setTabKeyNavigation(false);
  form.addRow(tr("Choices"), choices_);
  connect(choices_, &QTableWidget::itemChanged, this, &LessonEditor::take);
  value_ = choice(tr("Computed answer"), "editorValue");
  value_->addItems({tr("the value with these keys"), tr("its ratio to the value of the step"),
                    tr("the place of the largest value")});
  column_ = choice(tr("of the column"), "editorColumn");
  for (const std::string_view name : curveColumns())
    if (name != "mu_low" && name != "mu_high" && name != "realizations")
      column_->addItem(fromUtf8(name));
  valueSet_ = addLine(form, tr("with the keys"), "editorValueSet");
  valueSet_->setPlaceholderText(QStringLiteral("sliding.velocity=0.1"));
  x_ = addLine(form, tr("Place on the axis"), "editorX");
  x_->setPlaceholderText(tr("empty: the largest value is asked"));
  tolerance_ = addLine(form, tr("Tolerance"), "editorTolerance");
  right_ = addLine(form, tr("If right"), "editorRight");
  wrong_ = addLine(form, tr("If wrong"), "editorWrong");
  for (QLineEdit* line : {right_, wrong_})
    line->setToolTip(tr("{answer} and {given} stand for the two answers"));
  hides_ = new QCheckBox(tr("The curve is hidden until the answer"));
  hides_->setObjectName("editorHides");
  form.addRow(QString(), hides_);
  connect(hides_, &QCheckBox::toggled, this, &LessonEditor::take);
  after_ = addLine(form, tr("Change when revealed"), "editorAfter");
  reveal_ = addText(form, tr("What is revealed"), "editorReveal", 4);
  auto* scroll = new QScrollArea;
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  return scroll;
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
  save_ = button("editorSave", tr("&Save…"));
  close_ = button("editorClose", tr("&Close"));
  connect(try_, &QPushButton::clicked, this, [this] {
    try {
      emit tryWanted(checked(), std::max(0, steps_->currentRow() - 1));
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
  foot->addStretch(1);
  for (QPushButton* one : {close_, try_, save_}) foot->addWidget(one);
  return foot;
}

/// Offers the parameters that have a meaning in the step's scene.
void LessonEditor::fillControls() {
  QMenu& menu = *controls_->menu();
  menu.clear();
  LessonStep* step = present();
  if (!step) return;
  QAction* all = menu.addAction(tr("all"));
  all->setCheckable(true);
  all->setChecked(step->controls.others == ControlState::Free);
  connect(all, &QAction::toggled, this, [this](bool isFree) {
    if (LessonStep* one = present()) {
      one->controls = {};
      if (isFree) one->controls.others = ControlState::Free;
    }
    check();
    showStep();
  });
  menu.addSeparator();
  for (const Parameter& row : parameters()) {
    if (!isApplicable(row, step->revealedScene) || row.key.find('.') == row.key.npos) continue;
    QAction* action = menu.addAction(ParameterRow::labelOf(row));
    action->setObjectName("free:" + fromUtf8(row.key));
    action->setCheckable(true);
    action->setChecked(step->controls.of(row.key) == ControlState::Free);
    connect(action, &QAction::toggled, this, [this, key = std::string(row.key)](bool isFree) {
      if (LessonStep* one = present()) {
        std::erase(one->controls.free, key);
        std::erase(one->controls.locked, key);
        std::erase(one->controls.hidden, key);
        if (isFree) one->controls.free.push_back(key);
      }
      check();
      showStep();
    });
  }
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

QString LessonEditor::inLanguage(const LessonText& text) const {
  return QString::fromStdString(isGerman() ? text.german : text.english);
}

LessonText& LessonEditor::withLanguage(LessonText& text, const QString& written) const {
  (isGerman() ? text.german : text.english) = written.trimmed().toStdString();
  return text;
}

void LessonEditor::showList() {
  const int row = steps_->currentRow();
  const bool wasShowing = std::exchange(isShowing_, true);
  steps_->clear();
  steps_->addItem(tr("The lesson"));
  for (std::size_t i = 0; i < lesson_.steps.size(); ++i) {
    const LessonStep& step = lesson_.steps[i];
    const QString title = QString::fromStdString(step.title.in(isGerman() ? "de" : "en"));
    steps_->addItem(tr("%1. %2").arg(i + 1).arg(title.isEmpty() ? tr("(no title)") : title));
  }
  isShowing_ = wasShowing;
  steps_->setCurrentRow(std::clamp(row, 0, steps_->count() - 1));
}

void LessonEditor::showStep() {
  if (isShowing_) return;
  isShowing_ = true;
  LessonStep* step = present();
  pages_->setCurrentIndex(step ? 1 : 0);
  title_->setText(inLanguage(lesson_.title));
  goal_->setPlainText(inLanguage(lesson_.goal));
  notes_->setPlainText(inLanguage(lesson_.notes));
  minutes_->setValue(lesson_.minutes);
  const int row = steps_->currentRow() - 1;
  up_->setEnabled(step && row > 0);
  down_->setEnabled(step && row + 1 < static_cast<int>(lesson_.steps.size()));
  remove_->setEnabled(step != nullptr);
  if (step) {
    stepTitle_->setText(inLanguage(step->title));
    text_->setPlainText(inLanguage(step->text));
    set_->setText(joined(step->set));
    after_->setText(joined(step->after));
    reveal_->setPlainText(inLanguage(step->reveal));
    tab_->setCurrentIndex(tab_->findData(QString::fromStdString(step->show.tab)));
    quantity_->setCurrentIndex(quantity_->findData(QString::fromStdString(step->show.quantity)));
    hides_->setChecked(step->show.hidesCurve);
    QStringList names;
    for (const std::string& key : step->controls.free)
      if (const Parameter* parameter = findParameter(key))
        names += ParameterRow::labelOf(*parameter);
    controls_->setText(step->controls.others == ControlState::Free ? tr("all")
                       : names.isEmpty()                           ? tr("none")
                       : names.size() > 3 ? tr("%1 controls").arg(names.size())
                                          : names.join(", "));
    controls_->setAccessibleName(tr("free controls: %1").arg(controls_->text()));
    const LessonPrediction prediction = step->prediction.value_or(LessonPrediction{});
    kind_->setCurrentIndex(step->prediction ? 1 + static_cast<int>(prediction.kind) : 0);
    question_->setText(inLanguage(prediction.question));
    right_->setText(inLanguage(prediction.right));
    wrong_->setText(inLanguage(prediction.wrong));
    tolerance_->setText(numberText(prediction.tolerance));
    x_->setText(prediction.x ? numberText(*prediction.x) : QString());
    const LessonValue value = prediction.answer.value_or(LessonValue{});
    value_->setCurrentIndex(value.kind == LessonValue::Kind::Peak ? kPeak
                            : value.over.empty()                  ? kThere
                                                                  : kRatio);
    column_->setCurrentText(QString::fromStdString(value.column));
    valueSet_->setText(joined(value.set));
    for (int i = 0; i < kMostChoices; ++i) {
      const bool has = i < static_cast<int>(prediction.choices.size());
      const LessonChoice choice =
          has ? prediction.choices[static_cast<std::size_t>(i)] : LessonChoice{};
      auto* tick = new QTableWidgetItem;
      tick->setFlags(Qt::ItemIsUserCheckable | Qt::ItemIsEnabled | Qt::ItemIsSelectable);
      tick->setCheckState(choice.isRight ? Qt::Checked : Qt::Unchecked);
      const auto bound = [](double end) {
        return std::isfinite(end) ? numberText(end) : QString();
      };
      choices_->setItem(i, 0, new QTableWidgetItem(inLanguage(choice.text)));
      choices_->setItem(i, 1, tick);
      choices_->setItem(i, 2, new QTableWidgetItem(bound(choice.above)));
      choices_->setItem(i, 3, new QTableWidgetItem(bound(choice.below)));
    }
  }
  isShowing_ = false;
  showKind();
}

/// Shows the fields that the kind of prediction has.
void LessonEditor::showKind() {
  const int kind = kind_->currentIndex();
  const auto setVisible = [this](QWidget* field, bool isSeen) {
    field->setVisible(isSeen);
    if (QWidget* label = stepForm_->labelForField(field)) label->setVisible(isSeen);
  };
  for (QWidget* field : std::initializer_list<QWidget*>{question_, right_, wrong_, after_, reveal_})
    setVisible(field, kind != kNone);
  setVisible(choices_, kind == kChoice);
  for (QWidget* field : std::initializer_list<QWidget*>{value_, column_, valueSet_})
    setVisible(field, kind == kChoice || kind == kNumber);
  setVisible(x_, kind == kPoint);
  setVisible(tolerance_, kind == kNumber || kind == kPoint);
  hides_->setEnabled(kind != kPoint);
}

// ---- Taking what is written

LessonValue LessonEditor::takenValue() const {
  LessonValue value;
  value.column = column_->currentText().toStdString();
  value.set = assignmentsIn(valueSet_->text());
  if (value_->currentIndex() == kPeak) value.kind = LessonValue::Kind::Peak;
  if (value_->currentIndex() == kRatio) {
    LessonValue under;
    under.column = value.column;
    value.over.push_back(under);
  }
  return value;
}

void LessonEditor::takePrediction(LessonStep& step) {
  const int kind = kind_->currentIndex();
  if (kind == kNone) {
    step.prediction.reset();
    step.reveal = {};
    step.after.clear();
    step.values.clear();
    return;
  }
  LessonPrediction prediction = step.prediction.value_or(LessonPrediction{});
  prediction.kind = static_cast<PredictionKind>(kind - 1);
  withLanguage(prediction.question, question_->text());
  withLanguage(prediction.right, right_->text());
  withLanguage(prediction.wrong, wrong_->text());
  const auto number = [](const QString& text) {
    bool isNumber = false;
    const double value = withPoint(text.trimmed()).toDouble(&isNumber);
    return isNumber ? std::optional(value) : std::nullopt;
  };
  prediction.tolerance = number(tolerance_->text()).value_or(0);
  prediction.x.reset();
  if (kind == kPoint) prediction.x = number(x_->text());
  const std::vector<LessonChoice> before = std::exchange(prediction.choices, {});
  bool hasRanges = false;
  for (int i = 0; i < kMostChoices && kind == kChoice; ++i) {
    LessonChoice choice =
        i < static_cast<int>(before.size()) ? before[static_cast<std::size_t>(i)] : LessonChoice{};
    withLanguage(choice.text, choices_->item(i, 0)->text());
    choice.isRight = choices_->item(i, 1)->checkState() == Qt::Checked;
    choice.above = number(choices_->item(i, 2)->text()).value_or(LessonChoice{}.above);
    choice.below = number(choices_->item(i, 3)->text()).value_or(LessonChoice{}.below);
    if (choice.text.empty()) continue;
    hasRanges = hasRanges || choice.isRange();
    prediction.choices.push_back(choice);
  }
  const bool isComputed = kind == kNumber || (kind == kChoice && hasRanges);
  // An exponent cannot be written on this page; it stays as the file has it.
  const bool keeps = prediction.answer && prediction.answer->kind == LessonValue::Kind::Exponent;
  if (!isComputed)
    prediction.answer.reset();
  else if (!keeps)
    prediction.answer = takenValue();
  if (hasRanges)
    for (LessonChoice& choice : prediction.choices) choice.isRight = false;
  step.prediction = prediction;
  step.after = assignmentsIn(after_->text());
  withLanguage(step.reveal, reveal_->toPlainText());
}

void LessonEditor::take() {
  if (isShowing_) return;
  if (LessonStep* step = present()) {
    withLanguage(step->title, stepTitle_->text());
    withLanguage(step->text, text_->toPlainText());
    step->set = assignmentsIn(set_->text());
    step->show.tab = tab_->currentData().toString().toStdString();
    step->show.quantity = quantity_->currentData().toString().toStdString();
    step->show.hidesCurve = hides_->isChecked();
    takePrediction(*step);
  } else {
    withLanguage(lesson_.title, title_->text());
    withLanguage(lesson_.goal, goal_->toPlainText());
    withLanguage(lesson_.notes, notes_->toPlainText());
    lesson_.minutes = minutes_->value();
  }
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
  complaint_.clear();
  try {
    const Lesson read = checked();
    for (std::size_t i = 0; i < read.steps.size(); ++i) {
      lesson_.steps[i].scene = read.steps[i].scene;
      lesson_.steps[i].revealedScene = read.steps[i].revealedScene;
    }
  } catch (const InputError& error) {
    complaint_ = translatedText(InputError("", error.key(), error.message()).message());
    QString place = QString::fromStdString(error.key());
    for (std::size_t i = 0; i < lesson_.steps.size(); ++i)
      place.replace(QStringLiteral("steps[%1].").arg(i), tr("step %1, ").arg(i + 1));
    if (!place.isEmpty()) complaint_ = place + ": " + complaint_;
  }
  said_->setText(complaint_);
  save_->setEnabled(complaint_.isEmpty());
  try_->setEnabled(complaint_.isEmpty());
  if (QListWidgetItem* item = row >= 0 ? steps_->item(row + 1) : nullptr) {
    const LessonStep& step = lesson_.steps[static_cast<std::size_t>(row)];
    const QString title = QString::fromStdString(step.title.in(isGerman() ? "de" : "en"));
    item->setText(tr("%1. %2").arg(row + 1).arg(title.isEmpty() ? tr("(no title)") : title));
  }
}

// ---- Steps

/// Adds a step below the present one. It goes on from the scene of the one before where that can
/// be said by a change of keys, and has a scene of its own else.
void LessonEditor::addShownStep() {
  const int row = std::max(0, steps_->currentRow());
  LessonStep step = shownNow_();
  Scene scene = step.scene;
  if (row > 0) {
    const Scene before = lesson_.steps[static_cast<std::size_t>(row - 1)].revealedScene;
    scene.title = before.title;
    scene.description = before.description;
    scene.chapter = before.chapter;
    step.set = assignmentsFrom(before, scene);
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
  // The step after it goes on from another scene now, unless it has one of its own.
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
  text_->setFocus();
  text_->selectAll();
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
  if (!mayClose()) return;
  const QString file = QFileDialog::getOpenFileName(this, tr("Open lesson"), file_,
                                                    tr("Lessons (*.json);;All files (*)"));
  if (file.isEmpty()) return;
  try {
    lesson_ = saved_ = readLessonFile(file.toStdString(), readNamedScene);
    file_ = file;
  } catch (const std::exception& error) {
    said_->setText(translatedError(error));
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
    said_->setText(translatedError(error));
    return false;
  }
  file_ = file;
  saved_ = lesson_;
  said_->setText(tr("Saved %1").arg(QFileInfo(file).fileName()));
  return true;
}

bool LessonEditor::mayClose() {
  if (writeLesson(saved_) == writeLesson(lesson_)) return true;
  const auto answer = QMessageBox::question(
      this, tr("Lesson editor"),
      tr("The lesson was changed and not saved. Close it and lose the changes?"));
  return answer == QMessageBox::Yes;
}

void LessonEditor::reject() {
  if (mayClose()) QDialog::reject();
}

}  // namespace asperity
