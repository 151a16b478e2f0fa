#include "ui/window/lesson/lesson_form.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QTextDocument>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <memory>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/scene/parameters.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/boxes.h"
#include "ui/panels/controls.h"
#include "ui/panels/number_text.h"
#include "ui/panels/parameter_text.h"

namespace asperity {

namespace {

/// Returns the number in a text with a decimal point and no marks between its thousands.
std::optional<double> pointNumber(const QString& text) {
  bool isNumber = false;
  const double value = text.toDouble(&isNumber);
  return isNumber ? std::optional(value) : std::nullopt;
}

/// Returns the value of an assignment KEY=VALUE.
QString assignedValue(const std::string& assignment) {
  const std::size_t sign = assignment.find('=');
  return sign == assignment.npos ? QString() : QString::fromStdString(assignment.substr(sign + 1));
}

/// Returns a value as an assignment has it.
QString plainValue(const ParameterValue& value) {
  if (const auto* real = std::get_if<double>(&value)) return numberText(*real);
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return QString::number(*whole);
  return QString::fromStdString(std::get<std::string>(value));
}

/// Returns a number of an assignment in a readable unit; any other text has none.
UnitText readable(const QString& text, const Parameter& row) {
  const std::optional<double> value = pointNumber(toPlainNumber(text, numberRule(row)));
  return value ? shownText(row, *value) : UnitText{text, {}};
}

}  // namespace

// ---- Changes of a scene

AssignmentList::AssignmentList(const QString& name, const QString& label, QWidget* parent)
    : QWidget(parent),
      name_(name),
      column_(marginless<QVBoxLayout>(this, 4)),
      add_(new QToolButton) {
  add_->setObjectName(name);
  add_->setText(tr("Change a parameter…"));
  add_->setAccessibleDescription(label);
  setAccessibleName(label);
  add_->setPopupMode(QToolButton::InstantPopup);
  add_->setMenu(new QMenu(add_));
  add_->setFocusPolicy(Qt::StrongFocus);
  connect(add_->menu(), &QMenu::aboutToShow, this, &AssignmentList::fillMenu);
  column_->addWidget(add_, 0, Qt::AlignLeft);
}

void AssignmentList::show(const std::vector<std::string>& assignments, const Scene& scene) {
  assignments_ = assignments;
  scene_ = scene;
  showRows();
}

void AssignmentList::showRows() {
  // The Tab key goes through the rows before it comes to the button below them. setTabOrder() does
  // nothing for a widget without focus, such as this one.
  const auto isBeforeRows = [this](const QWidget& widget) {
    return widget.focusPolicy() & Qt::TabFocus && !(rows_ && rows_->isAncestorOf(&widget));
  };
  QWidget* previous = add_->previousInFocusChain();
  while (previous != add_ && !isBeforeRows(*previous)) previous = previous->previousInFocusChain();
  if (rows_) {
    // A field that loses the focus now ends its editing: its index may then belong to another row,
    // or to none.
    for (QWidget* field : rows_->findChildren<QWidget*>()) field->disconnect(this);
    column_->removeWidget(rows_);
    rows_->setParent(nullptr);
    rows_->deleteLater();  // one of its buttons may have been pressed
  }
  rows_ = new QWidget;
  auto* rows = marginless<QVBoxLayout>(rows_, 3);
  for (std::size_t i = 0; i < assignments_.size(); ++i) rows->addWidget(makeRow(i));
  // All values begin at the same place.
  const QList<QLabel*> names = rows_->findChildren<QLabel*>();
  int widest = 0;
  for (const QLabel* name : names) widest = std::max(widest, name->sizeHint().width());
  for (QLabel* name : names) name->setMinimumWidth(widest);
  column_->insertWidget(0, rows_);
  rows_->setVisible(!assignments_.empty());
  if (previous->window() == window()) orderTabs(*previous, *rows);
}

QWidget* AssignmentList::makeRow(std::size_t index) {
  const std::string key(assignmentKey(assignments_[index]));
  const Parameter* row = findParameter(key);
  auto* all = new QWidget;
  auto* line = marginless<QHBoxLayout>(all);
  const QString label = row ? labelText(*row) : QString::fromStdString(key);
  auto* name = new QLabel(label);
  if (row) name->setToolTip(wrappedTip(translatedText(row->sentence)));
  line->addWidget(name);
  QWidget* value = nullptr;
  if (row) {
    value = makeValue(index, *row);
  } else {
    auto* text = new QLineEdit(assignedValue(assignments_[index]));
    connect(text, &QLineEdit::textEdited, this,
            [this, index](const QString& written) { write(index, written); });
    value = text;
  }
  value->setObjectName(name_ + ':' + QString::fromStdString(key));
  value->setAccessibleName(label);
  name->setBuddy(value);
  line->addWidget(value, 1);
  auto* button = new QToolButton;
  button->setObjectName(name_ + "Without:" + QString::fromStdString(key));
  button->setText(QStringLiteral("✕"));
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::StrongFocus);
  button->setToolTip(tr("Removes this change"));
  button->setAccessibleName(tr("remove the change of “%1”").arg(label));
  line->addWidget(button);
  connect(button, &QToolButton::clicked, this, [this, index] { remove(index); });
  return all;
}

/// Makes the field of a value: a list where there are words to choose from, otherwise a line.
QWidget* AssignmentList::makeValue(std::size_t index, const Parameter& row) {
  const QString written = assignedValue(assignments_[index]);
  const auto list = [&](const auto& fill) {
    auto* box = new ChoiceBox;
    fill(*box);
    if (box->findData(written) < 0) box->addItem(written, written);
    box->setCurrentIndex(box->findData(written));
    connect(box, &QComboBox::activated, this,
            [this, index, box] { write(index, chosenWord(*box)); });
    return box;
  };
  if (const auto* choice = std::get_if<ChoiceField>(&row.field))
    return list([choice](QComboBox& box) {
      for (const std::string_view word : choice->choices)
        box.addItem(wordText(word), fromUtf8(word));
    });
  // The axis of the curve is the name of another parameter.
  if (findParameter(written.toStdString()))
    return list([this](QComboBox& box) {
      const Scene scene = changed();
      for (const Parameter& one : parameters())
        if (isApplicable(one, scene) && std::holds_alternative<RealField>(one.field))
          box.addItem(labelText(one), fromUtf8(one.key));
    });
  auto* line = new QLineEdit;
  const Parameter shown = parameterIn(row, changed());
  if (!allowedRange(shown)) {
    line->setText(written);
    connect(line, &QLineEdit::textEdited, this,
            [this, index](const QString& text) { write(index, text); });
    return line;
  }
  line->setToolTip(tr("Allowed: %1").arg(allowedInWords(numberRule(shown))));
  // A number that is typed without a unit has the one that was shown.
  const auto unit = std::make_shared<QString>();
  const auto showValue = [this, index, line, unit, shown] {
    const UnitText text = readable(assignedValue(assignments_[index]), shown);
    *unit = text.unit;
    line->setText((text.number + ' ' + text.unit).trimmed());
  };
  showValue();
  connect(line, &QLineEdit::textEdited, this,
          [this, index, unit, rule = numberRule(shown)](const QString& typed) {
            write(index, toPlainNumber(inShownUnit(withoutGroups(typed.trimmed()), *unit), rule));
          });
  connect(line, &QLineEdit::editingFinished, this, showValue);
  return line;
}

void AssignmentList::write(std::size_t index, const QString& value) {
  assignments_[index] =
      std::string(assignmentKey(assignments_[index])) + '=' + value.trimmed().toStdString();
  emit edited();
}

void AssignmentList::remove(std::size_t index) {
  assignments_.erase(assignments_.begin() + static_cast<std::ptrdiff_t>(index));
  showRows();
  add_->setFocus();
  emit edited();
}

/// Adds a change to the value that the parameter has, which the teacher edits.
void AssignmentList::add(const Parameter& row) {
  const QString value = plainValue(parameterValue(row, changed()));
  assignments_.push_back(std::string(row.key) + '=' + value.toStdString());
  showRows();
  auto* field = findChild<QWidget*>(name_ + ':' + fromUtf8(row.key));
  field->setFocus();
  if (auto* line = qobject_cast<QLineEdit*>(field)) line->selectAll();
  emit edited();
}

/// Offers the parameters that have a meaning in the scene and are not changed yet.
void AssignmentList::fillMenu() {
  fillParameterMenu(*add_->menu(), changed(), [this](QMenu& section, const Parameter& row) {
    const auto isSame = [&](const std::string& one) { return assignmentKey(one) == row.key; };
    if (std::ranges::any_of(assignments_, isSame)) return;
    QAction* action = section.addAction(labelText(row));
    action->setObjectName(name_ + "With:" + fromUtf8(row.key));
    connect(action, &QAction::triggered, this, [this, &row] { add(row); });
  });
}

/// Returns the scene with the changes, or without them where one of them is wrong.
Scene AssignmentList::changed() const {
  try {
    return withKeys(scene_, assignments_);
  } catch (const InputError&) {
    return scene_;
  }
}

// ---- The rows of a page

LessonForm::LessonForm(QWidget* parent) : QWidget(parent), rows_(new QFormLayout(this)) {
  rows_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  rows_->setHorizontalSpacing(12);  // a label is nearer to its own letters than to its field
}

QLineEdit* LessonForm::addLine(const QString& label, const char* name) {
  auto* line = addField<QLineEdit>(*rows_, name, label);
  connect(line, &QLineEdit::textEdited, this, &LessonForm::notifyEdited);
  return line;
}

QPlainTextEdit* LessonForm::addText(const QString& label, const char* name, int lines) {
  auto* text = addField<QPlainTextEdit>(*rows_, name, label);
  text->setTabChangesFocus(true);
  text->setFixedHeight(lines * fontMetrics().lineSpacing() + 16);
  // Otherwise the rows would share the space below them.
  text->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  connect(text, &QPlainTextEdit::textChanged, this, &LessonForm::notifyEdited);
  return text;
}

QComboBox* LessonForm::addChoice(const QString& label, const char* name) {
  auto* box = addField<ChoiceBox>(*rows_, name, label);
  connect(box, &QComboBox::activated, this, &LessonForm::notifyEdited);
  return box;
}

AssignmentList* LessonForm::addAssignments(const QString& label, const char* name) {
  auto* list = new AssignmentList(QString::fromLatin1(name), label);
  addRow(label, list);
  connect(list, &AssignmentList::edited, this, &LessonForm::notifyEdited);
  return list;
}

void LessonForm::addRow(const QString& label, QWidget* field) {
  rows_->addRow(label, field);
}

void LessonForm::setShown(QWidget* field, bool isShown) {
  setRowShown(*rows_, field, isShown);
}

void LessonForm::notifyEdited() {
  if (!isFilling_) emit edited();
}

QString LessonForm::localText(const LessonText& text) const {
  return QString::fromStdString(isGerman_ ? text.german : text.english);
}

QString LessonForm::placeholder(const LessonText& text, const QString& hint) const {
  const std::string& other = isGerman_ ? text.english : text.german;
  return other.empty() ? hint : QString::fromStdString(other);
}

void LessonForm::showText(QLineEdit& line, const LessonText& text, const QString& hint) const {
  line.setText(localText(text));
  line.setPlaceholderText(placeholder(text, hint));
  line.setCursorPosition(0);
}

void LessonForm::showText(QPlainTextEdit& box, const LessonText& text, const QString& hint) const {
  box.setPlainText(localText(text));
  box.setPlaceholderText(placeholder(text, hint));
}

QString LessonForm::plainText(const QPlainTextEdit& box) {
  return box.document()
      ->toRawText()
      .replace(QChar::ParagraphSeparator, '\n')
      .replace(QChar::LineSeparator, '\n');
}

void LessonForm::write(LessonText& text, const QString& written) const {
  (isGerman_ ? text.german : text.english) = written.trimmed().toStdString();
}

void LessonForm::write(LessonText& text, const QString& written,
                       const QString& inOtherLanguage) const {
  write(text, written);
  (isGerman_ ? text.english : text.german) = inOtherLanguage.toStdString();
}

void fillParameterMenu(QMenu& menu, const Scene& scene,
                       const std::function<void(QMenu& section, const Parameter& row)>& add) {
  menu.clear();
  for (const ParameterGroup& group : parameterSections()) {
    if (group.name == QLatin1String("texts")) continue;  // a step has a title and a text of its own
    auto* section = new QMenu(group.title(), &menu);
    for (const std::string_view key : group.keys)
      if (const Parameter* row = findParameter(key); row && isApplicable(*row, scene))
        add(*section, *row);
    if (section->isEmpty())
      delete section;
    else
      menu.addMenu(section);
  }
}

// ---- Numbers

std::optional<double> numberIn(const QString& text) {
  return pointNumber(withoutGroups(text.trimmed()));
}

QString percentText(double part) {
  return shownNumber(roundedToDigits(100 * part, 12));
}

double partIn(const QString& text, double before) {
  const std::optional<double> percent = numberIn(QString(text).remove('%'));
  const bool isEdited = percent && std::abs(*percent - 100 * before) > 1e-9 * std::abs(*percent);
  return isEdited ? *percent / 100 : before;
}

QString keyValueText(const std::string& key, double value) {
  const Parameter* row = findParameter(key);
  return row ? textWithUnit(*row, value) : shownNumber(value);
}

std::optional<double> parseKeyValue(const std::string& key, const QString& text) {
  const Parameter* row = findParameter(key);
  const QString number = withoutGroups(text.trimmed());
  return pointNumber(row ? toPlainNumber(number, numberRule(*row)) : number);
}

}  // namespace asperity
