#include "ui/window/lesson/lesson_value_fields.h"

#include <QComboBox>
#include <QLineEdit>
#include <algorithm>
#include <utility>

#include "core/base/number_text.h"
#include "core/friction/curve_file.h"
#include "core/friction/curve_quantity.h"
#include "core/scene/parameters.h"
#include "ui/language/translated.h"
#include "ui/panels/boxes.h"
#include "ui/panels/controls.h"
#include "ui/panels/parameter_text.h"
#include "ui/window/lesson/lesson_form.h"

namespace asperity {

namespace {

enum ValueKind { kStateValue, kRatio, kPeak, kExponent };  // as in the list

ValueKind valueKind(const LessonValue& value) {
  if (value.kind == LessonValue::Kind::Peak) return kPeak;
  if (value.kind == LessonValue::Kind::Exponent) return kExponent;
  return value.over.empty() ? kStateValue : kRatio;
}

/// Returns a quantity of the friction curve in words.
QString columnTitle(std::string_view column) {
  for (const QuantityEntry& entry : quantityEntries())
    if (entry.word.text() == column) return translatedText(entry.title);
  const std::pair<std::string_view, QString> titles[] = {
      {"velocity", LessonValueFields::tr("velocity")},
      {"mu_standard_error", LessonValueFields::tr("standard error of μ")},
      {"mu_law", LessonValueFields::tr("μ by Eq. (11)")},
      {"dimensionless_velocity", LessonValueFields::tr("dimensionless velocity")},
      {"dimensionless_force", LessonValueFields::tr("dimensionless force")},
      {"mu_interface", LessonValueFields::tr("μ of the local friction")},
      {"mu_total", LessonValueFields::tr("μ with the local friction")},
      {"mu_mean_of_ratios", LessonValueFields::tr("mean of the ratios of force to load")},
      {"mu_ratio_of_means", LessonValueFields::tr("ratio of the mean force to the mean load")},
      {"marginal_share",
       LessonValueFields::tr("share of its load on an element that just touches")},
      {"extrapolated",
       LessonValueFields::tr("whether it rests on frequencies that were not measured")},
      {"normal_force", LessonValueFields::tr("normal force")},
      {"nominal_pressure", LessonValueFields::tr("nominal pressure")},
      {"contact_spots", LessonValueFields::tr("number of contacts")}};
  for (const auto& [name, title] : titles)
    if (name == column) return title;
  return fromUtf8(column);
}

}  // namespace

LessonValueFields::LessonValueFields(LessonForm& page) : QObject(&page), page_(page) {
  kind_ = page.addChoice(tr("Computed answer"), "editorValue");
  kind_->addItems(
      {tr("the value after the changes below"), tr("how many times as large as in this step"),
       tr("where on the axis it is largest"), tr("the power of a parameter with which it grows")});
  connect(kind_, &QComboBox::activated, this, [this] {
    showRows();
    proposeEnds();
  });
  column_ = page.addChoice(tr("of the quantity"), "editorColumn");
  for (const std::string_view name : curveColumns())
    if (name != "mu_low" && name != "mu_high" && name != "realizations") {
      column_->addItem(columnTitle(name), fromUtf8(name));
      column_->setItemData(column_->count() - 1, fromUtf8(name), Qt::ToolTipRole);
    }
  key_ = page.addChoice(tr("of the parameter"), "editorExponentKey");
  connect(key_, &QComboBox::activated, this, &LessonValueFields::proposeEnds);
  from_ = page.addLine(tr("from"), "editorExponentFrom");
  to_ = page.addLine(tr("to"), "editorExponentTo");
  for (QLineEdit* end : {from_, to_}) {
    end->setPlaceholderText(QStringLiteral("20 mN"));
    end->setToolTip(
        tr("Two values of the parameter, both above 0, between which the slope of the curve in "
           "logarithms is computed"));
  }
  set_ = page.addAssignments(tr("after the changes"), "editorValueSet");
}

void LessonValueFields::show(const LessonValue& value, const Scene& scene) {
  scene_ = scene;
  kind_->setCurrentIndex(valueKind(value));
  column_->setCurrentIndex(column_->findData(QString::fromStdString(value.column)));
  set_->show(value.set, scene);
  key_->clear();
  for (const Parameter& row : parameters())
    if (std::holds_alternative<RealField>(row.field) && isApplicable(row, scene) &&
        row.key.find('.') != row.key.npos)
      key_->addItem(labelText(row), fromUtf8(row.key));
  const QString key = QString::fromStdString(value.key.empty() ? "sliding.velocity" : value.key);
  // A key may have a meaning only after the changes below.
  if (key_->findData(key) < 0) {
    const Parameter* row = findParameter(key.toStdString());
    key_->addItem(row ? labelText(*row) : key, key);
  }
  key_->setCurrentIndex(key_->findData(key));
  from_->setText(value.from == 0 ? QString() : keyValueText(value.key, value.from));
  to_->setText(value.to == 0 ? QString() : keyValueText(value.key, value.to));
  showRows();
}

void LessonValueFields::setShown(bool isShown) {
  isShown_ = isShown;
  showRows();
}

void LessonValueFields::showRows() {
  for (QWidget* field : Widgets{kind_, column_, set_}) page_.setShown(field, isShown_);
  for (QWidget* field : Widgets{key_, from_, to_})
    page_.setShown(field, isShown_ && kind_->currentIndex() == kExponent);
}

/// Writes two values of the key where those that are there are none of it: that of the step, and
/// ten times as much.
void LessonValueFields::proposeEnds() {
  if (kind_->currentIndex() != kExponent || (rangeEnd(*from_) > 0 && rangeEnd(*to_) > 0)) return;
  const std::string key = chosenWord(*key_).toStdString();
  const Parameter* row = findParameter(key);
  if (!row || !std::holds_alternative<RealField>(row->field)) return;
  const double present = std::get<double>(parameterValue(*row, scene_));
  const double most = std::get<RealField>(row->field).maximum;
  const double to = present > 0 ? std::min(10 * present, most) : 1;
  from_->setText(keyValueText(key, roundedToDigits(0.1 * to, 4)));
  to_->setText(keyValueText(key, roundedToDigits(to, 4)));
  page_.notifyEdited();
}

/// Returns the value in SI; 0 where it cannot be read, which is a mistake of the lesson.
double LessonValueFields::rangeEnd(const QLineEdit& entry) const {
  return parseKeyValue(chosenWord(*key_).toStdString(), entry.text()).value_or(0);
}

LessonValue LessonValueFields::edited(const LessonValue& before) const {
  LessonValue value = before;
  value.column = chosenWord(*column_).toStdString();
  value.set = set_->assignments();
  const int kind = kind_->currentIndex();
  if (kind != valueKind(before)) {
    value.kind = kind == kPeak       ? LessonValue::Kind::Peak
                 : kind == kExponent ? LessonValue::Kind::Exponent
                                     : LessonValue::Kind::State;
    value.over.clear();
    if (kind == kRatio) value.over.push_back(LessonValue{});
  }
  // The divisor of a ratio is of the same column, unless the file names another one.
  for (LessonValue& under : value.over)
    if (kind != valueKind(before) || under.column == before.column) under.column = value.column;
  value.key.clear();
  value.from = value.to = 0;
  if (kind == kExponent) {
    value.key = chosenWord(*key_).toStdString();
    value.from = rangeEnd(*from_);
    value.to = rangeEnd(*to_);
  }
  return value;
}

}  // namespace asperity
