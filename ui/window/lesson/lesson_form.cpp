#include "ui/window/lesson/lesson_form.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QTextDocument>

#include "core/scene/parameters.h"
#include "ui/panels/controls.h"
#include "ui/panels/number_text.h"
#include "ui/panels/parameter_panel.h"
#include "ui/window/lesson/assignment_list.h"

namespace asperity {

LessonForm::LessonForm(QWidget* parent) : QWidget(parent), rows_(new QFormLayout(this)) {
  rows_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
}

QLineEdit* LessonForm::addLine(const QString& label, const char* name) {
  auto* line = new QLineEdit;
  line->setObjectName(name);
  line->setAccessibleName(label);
  addRow(label, line);
  connect(line, &QLineEdit::textEdited, this, &LessonForm::notifyEdited);
  return line;
}

QPlainTextEdit* LessonForm::addText(const QString& label, const char* name, int lines) {
  auto* text = new QPlainTextEdit;
  text->setObjectName(name);
  text->setAccessibleName(label);
  text->setTabChangesFocus(true);
  text->setFixedHeight(lines * fontMetrics().lineSpacing() + 12);
  // Otherwise the rows would share the space below them.
  text->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  addRow(label, text);
  connect(text, &QPlainTextEdit::textChanged, this, &LessonForm::notifyEdited);
  return text;
}

QComboBox* LessonForm::addChoice(const QString& label, const char* name) {
  auto* box = new ChoiceBox;
  box->setObjectName(name);
  box->setAccessibleName(label);
  addRow(label, box);
  connect(box, &QComboBox::activated, this, &LessonForm::notifyEdited);
  return box;
}

AssignmentList* LessonForm::addAssignments(const QString& label, const char* name) {
  auto* list = new AssignmentList(QString::fromLatin1(name));
  list->setAccessibleName(label);
  addRow(label, list);
  connect(list, &AssignmentList::edited, this, &LessonForm::notifyEdited);
  return list;
}

void LessonForm::addRow(const QString& label, QWidget* field) {
  rows_->addRow(label, field);
}

void LessonForm::addRowBelow(QWidget* above, const QString& label, QWidget* field) {
  int row = 0;
  QFormLayout::ItemRole role{};
  rows_->getWidgetPosition(above, &row, &role);
  rows_->insertRow(row + 1, label, field);
}

void LessonForm::setShown(QWidget* field, bool isShown) {
  field->setVisible(isShown);
  if (QWidget* label = rows_->labelForField(field)) label->setVisible(isShown);
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

std::optional<double> plainNumberIn(const QString& text) {
  bool isNumber = false;
  const double value = text.toDouble(&isNumber);
  return isNumber ? std::optional(value) : std::nullopt;
}

std::optional<double> numberIn(const QString& text) {
  return plainNumberIn(withoutGroups(text.trimmed()));
}

}  // namespace asperity
