#include "ui/window/lesson/lesson_pages.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>
#include <utility>

#include "core/friction/curve_quantity.h"
#include "core/scene/parameters.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/boxes.h"
#include "ui/panels/controls.h"
#include "ui/panels/labels.h"
#include "ui/panels/parameter_text.h"
#include "ui/window/lesson/prediction_fields.h"

namespace asperity {

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
      tr("*italic*, **bold**; an empty line begins a paragraph; a line that begins with “- ” is an "
         "item"));
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
}

void LessonStepPage::addScene() {
  auto* row = new QWidget;
  auto* line = marginless<QHBoxLayout>(row);
  sceneText_ = new WrappedLabel;
  sceneText_->setObjectName("editorScene");
  auto* button = pageButton("editorTakeScene", tr("Take the scene that is shown"), this,
                            &LessonStepPage::shownSceneRequested);
  button->setToolTip(tr("The step begins with the scene of the main window, as it is now"));
  line->addWidget(sceneText_, 1);
  line->addWidget(button);
  addRow(tr("Scene"), row);
}

void LessonStepPage::showStep(const LessonStep& step, const QString& sceneText) {
  chosen_ = step.controls;
  scene_ = step.revealedScene;
  sceneText_->setText(sceneText);
  sceneText_->setToolTip(sceneText);
  fill([&] {
    showText(*title_, step.title);
    showText(*text_, step.text);
    set_->show(step.set, step.scene);
    chooseWord(*tab_, QString::fromStdString(step.show.tab));
    chooseWord(*quantity_, QString::fromStdString(step.show.quantity));
    prediction_->show(step);
    showControls();
  });
}

void LessonStepPage::take(LessonStep& step) const {
  write(step.title, title_->text());
  write(step.text, plainText(*text_));
  step.set = set_->assignments();
  step.show.tab = chosenWord(*tab_).toStdString();
  step.show.quantity = chosenWord(*quantity_).toStdString();
  step.controls = chosen_;
  prediction_->take(step);
}

void LessonStepPage::beginText() {
  text_->setFocus();
  text_->selectAll();
}

/// Shows which controls the student may use; where the others are free, too, which ones are not.
void LessonStepPage::showControls() {
  const bool areOthersFree = chosen_.others == ControlState::Free;
  std::vector<std::string> keys = areOthersFree ? chosen_.locked : chosen_.free;
  if (areOthersFree) keys.insert(keys.end(), chosen_.hidden.begin(), chosen_.hidden.end());
  QStringList names;
  for (const std::string& key : keys)
    if (const Parameter* parameter = findParameter(key)) names += labelText(*parameter);
  const QString named = names.size() > 3 ? tr("%1 controls").arg(names.size()) : names.join(", ");
  controls_->setText(!areOthersFree    ? (names.isEmpty() ? tr("Choose…") : named)
                     : names.isEmpty() ? tr("all")
                                       : tr("all except: %1").arg(named));
  others_->setCurrentIndex(others_->findData(static_cast<int>(chosen_.others)));
  controls_->setAccessibleName(tr("free controls: %1").arg(controls_->text()));
}

/// Offers the parameters that have a meaning in the step's scene.
void LessonStepPage::fillControls() {
  fillParameterMenu(*controls_->menu(), scene_, [this](QMenu& section, const Parameter& row) {
    checkedEntry(section, "free:" + fromUtf8(row.key), labelText(row),
                 chosen_.state(row.key) == ControlState::Free,
                 [this, key = std::string(row.key)](bool isFree) { chooseControl(key, isFree); });
  });
}

void LessonStepPage::chooseOthers() {
  const auto others = static_cast<ControlState>(others_->currentData().toInt());
  // The rows do not show which controls are locked among hidden ones.
  if (others == ControlState::Hidden && others != chosen_.others) chosen_.locked.clear();
  chosen_.others = others;
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
