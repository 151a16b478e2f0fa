#include "ui/window/lesson/lesson_value_fields.h"

#include <QComboBox>
#include <QLineEdit>
#include <algorithm>
#include <string>

#include "core/friction/curve_file.h"
#include "core/scene/parameters.h"
#include "ui/language/language.h"
#include "ui/panels/number_text.h"
#include "ui/panels/parameter_row.h"
#include "ui/window/lesson/lesson_form.h"

namespace asperity {

namespace {

enum Kind { kThere, kRatio, kPeak, kExponent };  // as in the list

Kind kindOf(const LessonValue& value) {
  if (value.kind == LessonValue::Kind::Peak) return kPeak;
  if (value.kind == LessonValue::Kind::Exponent) return kExponent;
  return value.over.empty() ? kThere : kRatio;
}

/// Returns a value of a key as its row of the panel shows it: "20 mN".
QString valueOfKey(const std::string& key, double value) {
  const Parameter* row = findParameter(key);
  if (value == 0) return {};
  if (!row) return shownNumber(value);
  const UnitText text = inReadableUnit(value, fromUtf8(row->unit));
  return (inLanguage(text.number) + ' ' + text.unit).trimmed();
}

}  // namespace

LessonValueFields::LessonValueFields(LessonForm& page) : QObject(&page), page_(page) {
  kind_ = page.addChoice(tr("Computed answer"), "editorValue");
  kind_->addItems({tr("the value with these keys"), tr("its ratio to the value of the step"),
                   tr("the place of the largest value"),
                   tr("the exponent with which it depends on a key")});
  connect(kind_, &QComboBox::activated, this, [this] {
    showRows();
    proposeEnds();
  });
  column_ = page.addChoice(tr("of the column"), "editorColumn");
  for (const std::string_view name : curveColumns())
    if (name != "mu_low" && name != "mu_high" && name != "realizations")
      column_->addItem(fromUtf8(name));
  key_ = page.addChoice(tr("over the key"), "editorExponentKey");
  connect(key_, &QComboBox::activated, this, &LessonValueFields::proposeEnds);
  from_ = page.addLine(tr("from"), "editorExponentFrom");
  to_ = page.addLine(tr("to"), "editorExponentTo");
  for (QLineEdit* end : {from_, to_}) {
    end->setPlaceholderText(QStringLiteral("20 mN"));
    end->setToolTip(
        tr("Two values of the key, both above 0, between which the slope of the curve in "
           "logarithms is computed"));
  }
  set_ = page.addLine(tr("with the keys"), "editorValueSet");
  set_->setPlaceholderText(QStringLiteral("sliding.velocity=0.1"));
}

void LessonValueFields::show(const LessonValue& value, const Scene& scene) {
  scene_ = scene;
  kind_->setCurrentIndex(kindOf(value));
  column_->setCurrentText(QString::fromStdString(value.column));
  set_->setText(assignmentText(value.set));
  key_->clear();
  for (const Parameter& row : parameters())
    if (std::holds_alternative<RealField>(row.field) && isApplicable(row, scene) &&
        row.key.find('.') != row.key.npos)
      key_->addItem(ParameterRow::labelOf(row), fromUtf8(row.key));
  const QString key = QString::fromStdString(value.key.empty() ? "sliding.velocity" : value.key);
  if (key_->findData(key) < 0) key_->addItem(key, key);  // it has a meaning with the keys below
  key_->setCurrentIndex(key_->findData(key));
  from_->setText(valueOfKey(value.key, value.from));
  to_->setText(valueOfKey(value.key, value.to));
  showRows();
}

void LessonValueFields::setShown(bool isShown) {
  isShown_ = isShown;
  showRows();
}

void LessonValueFields::showRows() {
  for (QWidget* field : std::initializer_list<QWidget*>{kind_, column_, set_})
    page_.setShown(field, isShown_);
  for (QWidget* field : std::initializer_list<QWidget*>{key_, from_, to_})
    page_.setShown(field, isShown_ && kind_->currentIndex() == kExponent);
}

/// Writes two values of the key where those that are there are none of it: that of the step, and
/// ten times as much.
void LessonValueFields::proposeEnds() {
  if (kind_->currentIndex() != kExponent || (endOf(*from_) > 0 && endOf(*to_) > 0)) return;
  const std::string key = key_->currentData().toString().toStdString();
  const Parameter* row = findParameter(key);
  if (!row || !std::holds_alternative<RealField>(row->field)) return;
  const double present = std::get<double>(valueOf(*row, scene_));
  const double most = std::get<RealField>(row->field).maximum;
  const double to = present > 0 ? std::min(10 * present, most) : 1;
  from_->setText(valueOfKey(key, roundedToDigits(0.1 * to, 4)));
  to_->setText(valueOfKey(key, roundedToDigits(to, 4)));
  page_.tell();
}

/// Returns the value in SI, 0 where nothing can be read: the lesson is then complained about.
double LessonValueFields::endOf(const QLineEdit& entry) const {
  const Parameter* row = findParameter(key_->currentData().toString().toStdString());
  const QString text = withPoint(entry.text().trimmed());
  return numberIn(row ? plainNumberOf(text, ruleOf(*row)) : text).value_or(0);
}

LessonValue LessonValueFields::taken(const LessonValue& before) const {
  LessonValue value = before;
  value.column = column_->currentText().toStdString();
  value.set = assignmentsIn(set_->text());
  const int kind = kind_->currentIndex();
  if (kind != kindOf(before)) {
    value.kind = kind == kPeak       ? LessonValue::Kind::Peak
                 : kind == kExponent ? LessonValue::Kind::Exponent
                                     : LessonValue::Kind::State;
    value.over.clear();
    if (kind == kRatio) value.over.push_back(LessonValue{});
  }
  // The value below a ratio is of the same column, unless a file says otherwise.
  for (LessonValue& under : value.over)
    if (kind != kindOf(before) || under.column == before.column) under.column = value.column;
  value.key.clear();
  value.from = value.to = 0;
  if (kind == kExponent) {
    value.key = key_->currentData().toString().toStdString();
    value.from = endOf(*from_);
    value.to = endOf(*to_);
  }
  return value;
}

}  // namespace asperity
