#include "ui/window/lesson/lesson_form.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>

#include "core/scene/scene_file.h"
#include "ui/panels/number_text.h"

namespace asperity {

LessonForm::LessonForm(QWidget* parent) : QWidget(parent), rows_(new QFormLayout(this)) {
  rows_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
}

QLineEdit* LessonForm::addLine(const QString& label, const char* name) {
  auto* line = new QLineEdit;
  line->setObjectName(name);
  line->setAccessibleName(label);
  addRow(label, line);
  connect(line, &QLineEdit::textEdited, this, &LessonForm::tell);
  return line;
}

QPlainTextEdit* LessonForm::addText(const QString& label, const char* name, int lines) {
  auto* text = new QPlainTextEdit;
  text->setObjectName(name);
  text->setAccessibleName(label);
  text->setTabChangesFocus(true);
  text->setFixedHeight(lines * fontMetrics().lineSpacing() + 12);
  addRow(label, text);
  connect(text, &QPlainTextEdit::textChanged, this, &LessonForm::tell);
  return text;
}

QComboBox* LessonForm::addChoice(const QString& label, const char* name) {
  auto* box = new QComboBox;
  box->setObjectName(name);
  box->setAccessibleName(label);
  addRow(label, box);
  connect(box, &QComboBox::activated, this, &LessonForm::tell);
  return box;
}

void LessonForm::addRow(const QString& label, QWidget* field) {
  rows_->addRow(label, field);
}

void LessonForm::setShown(QWidget* field, bool isShown) {
  field->setVisible(isShown);
  if (QWidget* label = rows_->labelForField(field)) label->setVisible(isShown);
}

void LessonForm::tell() {
  if (!isFilling_) emit edited();
}

QString LessonForm::textOf(const LessonText& text) const {
  return QString::fromStdString(isGerman_ ? text.german : text.english);
}

void LessonForm::write(LessonText& text, const QString& written) const {
  (isGerman_ ? text.german : text.english) = written.trimmed().toStdString();
}

QString assignmentText(const std::vector<std::string>& assignments) {
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

std::optional<double> numberIn(const QString& text) {
  bool isNumber = false;
  const double value = withPoint(text.trimmed()).toDouble(&isNumber);
  return isNumber ? std::optional(value) : std::nullopt;
}

}  // namespace asperity
