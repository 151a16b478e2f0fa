#include "ui/window/lesson/lesson_pages.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QStandardItemModel>
#include <QTableWidget>
#include <QToolButton>
#include <cmath>
#include <utility>

#include "core/base/number_text.h"
#include "core/friction/curve_quantity.h"
#include "core/scene/parameters.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/panels/number_text.h"
#include "ui/panels/parameter_row.h"
#include "ui/window/lesson/assignment_list.h"
#include "ui/window/lesson/lesson_value_fields.h"
#include "ui/window/lesson/prediction_fields.h"

namespace asperity {

namespace {

constexpr double kPointTolerance = 1;  // a factor of 2 on a logarithmic axis

}  // namespace

// ---- The lesson

LessonHeadPage::LessonHeadPage(QWidget* parent) : LessonForm(parent) {
  title_ = addLine(tr("Title"), "editorTitle");
  goal_ = addText(tr("Goal"), "editorGoal", 4);
  minutes_ = new SpinBox;
  minutes_->setObjectName("editorMinutes");
  minutes_->setRange(1, 600);
  minutes_->setAccessibleName(tr("Minutes"));
  addRow(tr("Minutes"), minutes_);
  connect(minutes_, &QSpinBox::valueChanged, this, &LessonForm::notifyEdited);
  notes_ = addText(tr("Notes for teachers"), "editorNotes", 8);
  notes_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  notes_->setMaximumHeight(QWIDGETSIZE_MAX);  // the notes get what is left
}

void LessonHeadPage::beginTitle() {
  title_->setFocus();
}

void LessonHeadPage::showLesson(const Lesson& lesson) {
  fill([&] {
    showText(*title_, lesson.title);
    showText(*goal_, lesson.goal);
    showText(*notes_, lesson.notes);
    minutes_->setValue(lesson.minutes);
  });
}

void LessonHeadPage::take(Lesson& lesson) const {
  write(lesson.title, title_->text());
  write(lesson.goal, plainText(*goal_));
  write(lesson.notes, plainText(*notes_));
  lesson.minutes = minutes_->value();
}

// ---- A step

LessonStepPage::LessonStepPage(QWidget* parent) : LessonForm(parent) {
  title_ = addLine(tr("Title"), "editorStepTitle");
  text_ = addText(tr("Text"), "editorText", 6);
  text_->setToolTip(
      tr("An empty line begins a paragraph; *word* and **word** emphasize; a line "
         "that begins with “- ” is an item"));
  addScene();
  set_ = addAssignments(tr("Changed in the scene"), "editorSet");
  set_->setToolTip(tr("What this step changes in the scene that the step before leaves"));
  tab_ = addChoice(tr("Tab in front"), "editorTab");
  const std::pair<std::string_view, QString> tabs[] = {{"curve", tr("Friction curve")},
                                                       {"motion", tr("Motion in time")},
                                                       {"spectrum", tr("Spectrum")},
                                                       {"statistics", tr("Statistics")},
                                                       {"material", tr("Material")},
                                                       {"accuracy", tr("Accuracy")},
                                                       {"plan", tr("Plan")},
                                                       {"map", tr("Map")},
                                                       {"influences", tr("Influences")}};
  static_assert(std::size(tabs) == std::size(kLessonTabs));
  for (const auto& [word, title] : tabs) tab_->addItem(title, fromUtf8(word));
  quantity_ = addChoice(tr("Vertical axis"), "editorQuantity");
  for (const QuantityEntry& entry : quantityEntries())
    quantity_->addItem(translatedText(entry.title), fromUtf8(entry.word.text()));
  controls_ = new QToolButton;
  controls_->setObjectName("editorControls");
  controls_->setPopupMode(QToolButton::InstantPopup);
  controls_->setMenu(new QMenu(controls_));
  controls_->setFocusPolicy(Qt::StrongFocus);
  controls_->setToolTip(tr("What students may change once they have answered"));
  addRow(tr("Free controls"), controls_);
  connect(controls_->menu(), &QMenu::aboutToShow, this, &LessonStepPage::fillControls);
  others_ = addChoice(tr("Other controls"), "editorOthers");
  for (const auto& [text, state] : {std::pair(tr("hidden"), ControlState::Hidden),
                                    {tr("in sight, but locked"), ControlState::Locked},
                                    {tr("free, too"), ControlState::Free}})
    others_->addItem(text, static_cast<int>(state));
  connect(others_, &QComboBox::activated, this, &LessonStepPage::chooseOthers);
  prediction_ = new PredictionFields(*this);
  addPredictionRows();
}

void LessonStepPage::addScene() {
  auto* row = new QWidget;
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 0, 0, 0);
  sceneText_ = new ElidedLabel;
  sceneText_->setObjectName("editorScene");
  auto* button = new QPushButton(tr("Take the scene that is shown"));
  button->setObjectName("editorTakeScene");
  button->setAutoDefault(false);
  button->setToolTip(tr("The step begins with the scene of the main window, as it is now"));
  connect(button, &QPushButton::clicked, this, &LessonStepPage::shownSceneRequested);
  line->addWidget(sceneText_, 1);
  line->addWidget(button);
  addRow(tr("Scene"), row);
}

/// Adds the rows of the prediction that depend on the step and its scene as a whole.
void LessonStepPage::addPredictionRows() {
  kind_ = findChild<QComboBox*>("editorKind");
  hides_ = findChild<QComboBox*>("editorHides");
  x_ = findChild<QLineEdit*>("editorX");
  tolerance_ = findChild<QLineEdit*>("editorTolerance");
  choices_ = findChild<QTableWidget*>("editorChoices");
  xTolerance_ = new QLineEdit;
  xTolerance_->setObjectName("editorPlaceTolerance");
  xTolerance_->setAccessibleName(tr("Tolerance of the place in %"));
  xTolerance_->setToolTip(
      tr("How far the place of a right answer may be from that of the largest value: the factor is "
         "2 for 100 %"));
  addRowBelow(tolerance_, tr("Tolerance of the place in %"), xTolerance_);
  connect(xTolerance_, &QLineEdit::textEdited, this, &LessonForm::notifyEdited);
  computed_ = new WrappedLabel;
  computed_->setObjectName("editorComputed");
  addRowBelow(findChild<QWidget*>("editorValueSet")->parentWidget(), QString(), computed_);
  setShown(computed_, false);
  connect(kind_, &QComboBox::activated, this, [this] {
    proposeTolerance();
    showRowsOfPoint();
    notifyEdited();
  });
  connect(x_, &QLineEdit::textEdited, this, &LessonStepPage::showRowsOfPoint);
}

/// Where a point is asked for from now on, its usual tolerance is a factor: on a logarithmic axis
/// of several decades a tenth of a value is one pixel. A number gets the usual one back.
void LessonStepPage::proposeTolerance() {
  const bool isPoint = kind_->currentIndex() == 1 + static_cast<int>(PredictionKind::Point);
  const auto text = [](double tolerance) {
    return shownNumber(roundedToDigits(100 * tolerance, 12));
  };
  const QString usual = text(LessonPrediction{}.tolerance), factor = text(kPointTolerance);
  if (isPoint && !isLinearY_ && tolerance_->text() == usual) tolerance_->setText(factor);
  if (!isPoint && tolerance_->text() == factor) tolerance_->setText(usual);
}

/// Shows the tolerance of the place where the place is asked for. The curve of a point is never
/// visible before the answer, but it may stay hidden after it.
void LessonStepPage::showRowsOfPoint() {
  const bool isPoint = kind_->currentIndex() == 1 + static_cast<int>(PredictionKind::Point);
  setShown(xTolerance_, isPoint && x_->text().trimmed().isEmpty());
  hides_->setEnabled(true);
  qobject_cast<QStandardItemModel*>(hides_->model())->item(0)->setEnabled(!isPoint);
  if (isPoint && hides_->currentIndex() == 0) hides_->setCurrentIndex(1);
}

void LessonStepPage::showStep(const LessonStep& step, const QString& sceneText) {
  chosen_ = step.controls;
  scene_ = step.revealedScene;
  axis_ = step.scene.sweep.key;
  isLinearY_ = step.show.isLinearY;
  sceneText_->setText(sceneText);
  sceneText_->setToolTip(sceneText);
  fill([&] {
    showText(*title_, step.title);
    showText(*text_, step.text);
    set_->show(step.set, step.scene);
    tab_->setCurrentIndex(tab_->findData(QString::fromStdString(step.show.tab)));
    quantity_->setCurrentIndex(quantity_->findData(QString::fromStdString(step.show.quantity)));
    prediction_->show(step);
    const double place = step.prediction.value_or(LessonPrediction{}).xTolerance;
    xTolerance_->setText(shownNumber(roundedToDigits(100 * place, 12)));
    showRowsOfPoint();
    showControls();
  });
}

void LessonStepPage::take(LessonStep& step) const {
  write(step.title, title_->text());
  write(step.text, plainText(*text_));
  step.set = set_->assignments();
  step.show.tab = tab_->currentData().toString().toStdString();
  step.show.quantity = quantity_->currentData().toString().toStdString();
  step.controls = chosen_;
  const LessonPrediction before = step.prediction.value_or(LessonPrediction{});
  prediction_->take(step);
  if (!step.prediction) return;
  LessonPrediction& prediction = *step.prediction;
  if (!unreadableIn(*tolerance_, false).isEmpty()) prediction.tolerance = before.tolerance;
  if (!unreadableIn(*x_, true).isEmpty()) prediction.x = before.x;
  if (!unreadableChoice().isEmpty()) {
    prediction.choices = before.choices;
    prediction.answer = before.answer;
  }
  const double percent =
      numberIn(xTolerance_->text().remove('%')).value_or(100 * before.xTolerance);
  // A value that was not edited keeps all its digits.
  if (std::abs(percent - 100 * before.xTolerance) > 1e-9 * std::abs(percent))
    prediction.xTolerance = percent / 100;
}

QString LessonStepPage::unreadableIn(const QLineEdit& line, bool mayBeEmpty) const {
  const QString text = line.text().trimmed();
  if (!line.isVisibleTo(this) || (mayBeEmpty && text.isEmpty())) return {};
  const bool isRead = &line == x_ ? parseKeyValue(axis_, text).has_value()
                                  : numberIn(QString(text).remove('%')).has_value();
  if (isRead) return {};
  return tr("%1: “%2” is not a number").arg(line.accessibleName(), text);
}

QString LessonStepPage::unreadableChoice() const {
  if (!choices_->isVisibleTo(this)) return {};
  for (int row = 0; row < choices_->rowCount(); ++row)
    for (const int column : {2, 3}) {
      const QTableWidgetItem* item = choices_->item(row, column);  // none: no step was shown yet
      const QString text = item ? item->text().trimmed() : QString();
      if (text.isEmpty() || numberIn(text)) continue;
      return tr("Choice %1, %2: “%3” is not a number")
          .arg(row + 1)
          .arg(choices_->horizontalHeaderItem(column)->text(), text);
    }
  return {};
}

QString LessonStepPage::unreadable() const {
  for (const auto& [line, mayBeEmpty] :
       {std::pair{x_, true}, {tolerance_, false}, {xTolerance_, false}})
    if (const QString text = unreadableIn(*line, mayBeEmpty); !text.isEmpty()) return text;
  return unreadableChoice();
}

void LessonStepPage::showComputed(const QString& text) {
  computed_->setText(text);
  setShown(computed_, !text.isEmpty());
}

void LessonStepPage::beginText() {
  text_->setFocus();
  text_->selectAll();
}

/// Shows which controls the student may use.
void LessonStepPage::showControls() {
  QStringList names;
  for (const std::string& key : chosen_.free)
    if (const Parameter* parameter = findParameter(key))
      names += ParameterRow::labelText(*parameter);
  controls_->setText(names.isEmpty()    ? tr("Choose…")
                     : names.size() > 3 ? tr("%1 controls").arg(names.size())
                                        : names.join(", "));
  others_->setCurrentIndex(others_->findData(static_cast<int>(chosen_.others)));
  controls_->setAccessibleName(tr("free controls: %1").arg(controls_->text()));
}

/// Offers the parameters that have a meaning in the step's scene.
void LessonStepPage::fillControls() {
  fillParameterMenu(*controls_->menu(), scene_, [this](QMenu& section, const Parameter& row) {
    QAction* action = section.addAction(ParameterRow::labelText(row));
    action->setObjectName("free:" + fromUtf8(row.key));
    action->setCheckable(true);
    action->setChecked(chosen_.state(row.key) == ControlState::Free);
    connect(action, &QAction::toggled, this,
            [this, key = std::string(row.key)](bool isFree) { chooseControl(key, isFree); });
  });
}

void LessonStepPage::chooseOthers() {
  chosen_.others = static_cast<ControlState>(others_->currentData().toInt());
  showControls();
  notifyEdited();
}

void LessonStepPage::chooseControl(const std::string& key, bool isFree) {
  for (std::vector<std::string>* keys : {&chosen_.free, &chosen_.locked, &chosen_.hidden})
    std::erase(*keys, key);
  if (isFree)
    chosen_.free.push_back(key);
  else if (chosen_.others == ControlState::Free)
    chosen_.locked.push_back(key);
  showControls();
  notifyEdited();
}

}  // namespace asperity
