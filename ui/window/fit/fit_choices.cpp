#include "ui/window/fit/fit_choices.h"

#include <QCheckBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/number_text.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/boxes.h"
#include "ui/panels/controls.h"
#include "ui/panels/list_box.h"
#include "ui/panels/number_text.h"
#include "ui/panels/panel_style.h"
#include "ui/panels/parameter_text.h"

namespace asperity {

namespace {

constexpr int kName = 0, kNow = 1, kLow = 2, kHigh = 3;  // columns
constexpr int kDefaultLines = 50;                        // where the scene states a target instead

/// Returns the number with few enough digits to leave space for the name.
QString shortQuantity(double value, const Parameter& row) {
  constexpr int kDigits = 6;
  return textWithUnit(row, roundedToDigits(value, kDigits));
}

/// Returns the numbers that can be varied. The tables give the velocities, and how a measured
/// surface is read is no property of the bodies. A local coefficient of friction is among them also
/// where the scene has no local friction yet, which measured friction always has. A local shear
/// cannot begin from 0. Its velocity and width are left out where they have no influence.
std::vector<VariedParameter> fittable(const Scene& scene) {
  std::vector<VariedParameter> all = activeParameters(scene);
  const Parameter* velocity = findParameter("sliding.velocity");
  const Parameter* outliers = findParameter("surface.outliers");
  const Parameter* shearVelocity = findParameter("interface.shear_velocity");
  const Parameter* shearWidth = findParameter("interface.shear_width");
  const bool hasShearLaw = scene.interface.shearStress > 0 && scene.interface.shearVelocity > 0;
  std::erase_if(all, [&](const VariedParameter& each) {
    return &each.row() == velocity || &each.row() == outliers ||
           (!hasShearLaw && (&each.row() == shearVelocity || &each.row() == shearWidth));
  });
  if (!hasLocalFriction(scene)) all.emplace_back("interface.friction_coefficient", scene);
  return all;
}

QLabel* heading(const QString& text) {
  auto* label = new QLabel("<b>" + text + "</b>");
  label->setWordWrap(true);
  return label;
}

}  // namespace

FitChoices::FitChoices(const Scene& scene, const FitSelection& before, QWidget* parent)
    : QWidget(parent),
      scene_(scene),
      parameters_(fittable(scene)),
      limits_(parameters_.size()),
      keys_(named<QTableWidget>("fitKeys")),
      tables_(named<QListWidget>("fitTables")),
      lines_(named<SpinBox>("fitLines")),
      profiles_(named<QCheckBox>("fitProfiles", tr("profile along each parameter"))) {
  auto* column = marginless<QVBoxLayout>(this, 6);
  column->addWidget(heading(tr("Parameters to fit")));
  column->addWidget(keys_, 3);
  column->addWidget(heading(tr("Measured friction")));
  column->addWidget(tables_);
  tables_->setFixedHeight(3 * (fontMetrics().lineSpacing() + 4) + 4);
  auto* form = marginless<QFormLayout>();
  form->addRow(tr("random lines"), lines_);
  column->addLayout(form);
  column->addWidget(profiles_);

  fillKeys();
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    const auto kept = before.find(std::string(parameters_[i].key()));
    if (kept == before.end()) continue;
    const int row = static_cast<int>(i);
    keys_->item(row, kName)->setCheckState(Qt::Checked);
    if (kept->second.low)
      keys_->item(row, kLow)->setText(textWithUnit(parameters_[i].row(), *kept->second.low));
    if (kept->second.high)
      keys_->item(row, kHigh)->setText(textWithUnit(parameters_[i].row(), *kept->second.high));
    for (const int cell : {kLow, kHigh}) take(*keys_->item(row, cell));
  }
  fillTables();
  lines_->setRange(2, 1000000);
  lines_->setValue(choosesAccuracy(scene) ? kDefaultLines
                                          : static_cast<int>(scene.ensemble.realizations));
  // The lines of a measured surface are its rows.
  lines_->setEnabled(hasRandomPhases(scene.surface));
  setRowShown(*form, lines_, hasRandomPhases(scene.surface));
  lines_->setToolTip(
      tr("Every trial uses the same random lines; their scatter is part of the errors"));
  profiles_->setChecked(true);
  profiles_->setToolTip(
      tr("The least sum of squares with one parameter held: flat where the data leave it open"));
  connect(keys_, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* cell) {
    take(*cell);
    emit changed();
  });
  connect(tables_, &QListWidget::itemChanged, this, &FitChoices::changed);
  // Boxes to tick take their outline from this colour, which is faint on a dark base.
  for (QWidget* list : Widgets{keys_, tables_}) {
    QPalette outlined = list->palette();
    outlined.setColor(QPalette::Window, outlined.color(QPalette::PlaceholderText));
    list->setPalette(outlined);
  }
}

void FitChoices::fillKeys() {
  keys_->setAccessibleName(tr("parameters to vary"));
  keys_->setColumnCount(4);
  keys_->setRowCount(static_cast<int>(parameters_.size()));
  keys_->setHorizontalHeaderLabels({tr("parameter"), tr("now"), tr("from"), tr("to")});
  keys_->verticalHeader()->hide();
  keys_->verticalHeader()->setDefaultSectionSize(fontMetrics().lineSpacing() + 9);
  keys_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  keys_->horizontalHeader()->setSectionResizeMode(kName, QHeaderView::Stretch);
  keys_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  for (const int limit : {kLow, kHigh}) {
    keys_->horizontalHeader()->setSectionResizeMode(limit, QHeaderView::Fixed);
    keys_->setColumnWidth(limit, 7 * fontMetrics().averageCharWidth());
  }
  keys_->setSelectionMode(QAbstractItemView::SingleSelection);
  keys_->setShowGrid(false);
  keys_->setEditTriggers(QAbstractItemView::AllEditTriggers);
  keys_->setTabKeyNavigation(false);
  for (int row = 0; row < keys_->rowCount(); ++row) {
    const VariedParameter& parameter = parameters_[static_cast<std::size_t>(row)];
    auto* name = new QTableWidgetItem(labelText(parameter.row()));
    name->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
    name->setCheckState(Qt::Unchecked);
    name->setToolTip(wrappedTip(translatedText(parameter.row().sentence)));
    name->setData(Qt::UserRole, fromUtf8(parameter.key()));
    auto* now = new QTableWidgetItem(shortQuantity(parameter.valueIn(scene_), parameter.row()));
    now->setToolTip(textWithUnit(parameter.row(), parameter.valueIn(scene_)));
    now->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    keys_->setItem(row, kName, name);
    keys_->setItem(row, kNow, now);
    for (const int limit : {kLow, kHigh}) {
      auto* cell = new QTableWidgetItem;
      cell->setToolTip(
          tr("empty: as far as allowed, %1").arg(allowedInWords(numberRule(parameter.row()))));
      keys_->setItem(row, limit, cell);
    }
  }
  // The names are not cut: the page gives the table the width that it needs.
  const QAbstractItemView& view = *keys_;
  const int spare = 2 * fontMetrics().averageCharWidth();
  const int texts = view.sizeHintForColumn(kName) + view.sizeHintForColumn(kNow) + spare;
  const int bar = keys_->verticalScrollBar()->sizeHint().width();
  keys_->setMinimumWidth(texts + 2 * keys_->columnWidth(kLow) + bar + 2 * keys_->frameWidth());
}

void FitChoices::fillTables() {
  tables_->setAccessibleName(tr("measured friction"));
  for (const DataFile& table : scene_.comparison.data) {
    auto* item = new QListWidgetItem(QFileInfo(tableName(table)).fileName(), tables_);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
    item->setCheckState(Qt::Checked);
    item->setToolTip(fromUtf8((scene_.folder / table.file).string()));
  }
}

/// Reads a limit that was typed; a tick needs nothing.
void FitChoices::take(QTableWidgetItem& cell) {
  const int column = cell.column();
  if (column != kLow && column != kHigh) return;
  const auto index = static_cast<std::size_t>(cell.row());
  std::optional<double>& limit = column == kLow ? limits_[index].low : limits_[index].high;
  const Parameter& row = parameters_[index].row();
  const NumberRule rule = numberRule(row);
  const QString typed = withoutGroups(cell.text().trimmed());
  const QString refusal = typed.isEmpty() ? QString() : validationError(typed, rule);
  limit.reset();
  if (!typed.isEmpty() && refusal.isEmpty()) limit = toPlainNumber(typed, rule).toDouble();
  const QSignalBlocker quiet(keys_);
  if (refusal.isEmpty())
    refusals_.erase({cell.row(), column});
  else
    refusals_[{cell.row(), column}] = labelText(row) + ": " + refusal;
  cell.setForeground(refusal.isEmpty() ? QBrush() : QBrush(errorColour(palette())));
  cell.setToolTip(refusal.isEmpty() ? tr("empty: as far as allowed, %1").arg(allowedInWords(rule))
                                    : refusal);
  if (limit) {
    cell.setText(textWithUnit(row, *limit));
    cell.setToolTip(cell.text() + '\n' + cell.toolTip());  // the cell may cut it
  }
  // A parameter whose limit is set is also varied.
  if (limit) keys_->item(cell.row(), kName)->setCheckState(Qt::Checked);
}

Scene FitChoices::scene() const {
  Scene scene = scene_;
  scene.comparison.data.clear();
  for (int i = 0; i < tables_->count(); ++i)
    if (tables_->item(i)->checkState() == Qt::Checked)
      scene.comparison.data.push_back(scene_.comparison.data[static_cast<std::size_t>(i)]);
  if (lines_->isEnabled()) {
    scene.ensemble.realizations = lines_->value();
    scene.accuracy.targetRelativeError = 0;
  }
  return scene;
}

FitSelection FitChoices::selection() const {
  FitSelection chosen;
  for (std::size_t i = 0; i < parameters_.size(); ++i)
    if (keys_->item(static_cast<int>(i), kName)->checkState() == Qt::Checked)
      chosen.emplace(parameters_[i].key(), limits_[i]);
  return chosen;
}

bool FitChoices::needsProfiles() const {
  return profiles_->isChecked();
}

bool FitChoices::isEnough() const {
  return !selection().empty() && !scene().comparison.data.empty();
}

QString FitChoices::refusal() const {
  return refusals_.empty() ? QString() : refusals_.begin()->second;
}

std::vector<VariedParameter> variedParameters(const FitSelection& selection, const Scene& scene) {
  std::vector<VariedParameter> varied;
  for (const auto& [key, limits] : selection) {
    const AllowedRange allowed = *allowedRange(*findParameter(key));
    if (limits.low || limits.high)
      varied.emplace_back(key, scene, limits.low.value_or(allowed.minimum),
                          limits.high.value_or(allowed.maximum));
    else
      varied.emplace_back(key, scene);
  }
  return varied;
}

std::vector<std::string> variedTexts(const FitSelection& selection) {
  std::vector<std::string> texts;
  for (const auto& [key, limits] : selection) {
    const AllowedRange allowed = *allowedRange(*findParameter(key));
    texts.push_back(limits.low || limits.high
                        ? key + "=" + plainNumber(limits.low.value_or(allowed.minimum)) + ":" +
                              plainNumber(limits.high.value_or(allowed.maximum))
                        : key);
  }
  return texts;
}

}  // namespace asperity
