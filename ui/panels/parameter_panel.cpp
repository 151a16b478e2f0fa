#include "ui/panels/parameter_panel.h"

#include <QEvent>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>
#include <utility>

#include "core/scene/input_error.h"
#include "core/scene/parameters.h"
#include "ui/panels/number_text.h"
#include "ui/panels/panel_style.h"
#include "ui/panels/parameter_row.h"

namespace asperity {

namespace {

QString sectionOf(const Parameter& parameter) {
  const QString key = fromUtf8(parameter.key);
  const qsizetype dot = key.indexOf('.');
  return dot < 0 ? QString() : key.left(dot);
}

QString sectionTitle(const QString& section) {
  const QMap<QString, QString> titles{
      {"surface", ParameterPanel::tr("Rigid line")},
      {"elastomer", ParameterPanel::tr("Elastomer")},
      {"load", ParameterPanel::tr("Load")},
      {"sliding", ParameterPanel::tr("Sliding")},
      {"sweep", ParameterPanel::tr("Friction curve")},
      {"ensemble", ParameterPanel::tr("Average")},
      {"accuracy", ParameterPanel::tr("Accuracy")},
  };
  if (titles.contains(section)) return titles[section];
  return section.left(1).toUpper() + section.mid(1);
}

/// What a person changes most comes first; sections the list does not know follow as in the table.
QStringList sections() {
  QStringList names{"sliding", "load", "elastomer", "surface", "ensemble", "sweep", "accuracy"};
  for (const Parameter& parameter : parameters())
    if (!names.contains(sectionOf(parameter))) names += sectionOf(parameter);
  return names;
}

/// The length and the elements of a profile are its file's unless someone says otherwise.
void followKind(SurfaceKind before, Surface& surface) {
  if (before == surface.kind) return;
  if (surface.kind == SurfaceKind::Profile) {
    surface.length = 0;
    surface.elements = 0;
  } else if (before == SurfaceKind::Profile) {
    if (surface.length == 0) surface.length = Surface{}.length;
    if (surface.elements == 0) surface.elements = Surface{}.elements;
  }
}

}  // namespace

ParameterPanel::ParameterPanel(const Scene& scene, QWidget* parent)
    : QWidget(parent), scene_(scene) {
  auto* content = new QWidget;
  content->setObjectName("parameterRows");
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(14, 6, 5, 10);
  column->setSpacing(4);
  for (const QString& section : sections()) addSection(*column, section);
  column->addStretch(1);

  auto* scroll = new QScrollArea;
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(scroll);
  setMinimumWidth(350);
  applyStyle();
  showRows(nullptr);
}

void ParameterPanel::setScene(const Scene& scene) {
  scene_ = scene;
  for (ParameterRow* row : std::as_const(rows_)) row->showScene(scene_, true);
}

void ParameterPanel::showError(const QString& key, const QString& text) {
  if (ParameterRow* row = rows_.value(key)) row->showError(text);
}

QSize ParameterPanel::sizeHint() const {
  return {380, 640};
}

/// The section's first choice, if it has one, stands in its heading.
void ParameterPanel::addSection(QVBoxLayout& column, const QString& section) {
  QString heading = section.isEmpty() ? QString() : sectionTitle(section);
  if (column.count() > 0) column.addSpacing(5);
  for (const Parameter& parameter : parameters()) {
    if (sectionOf(parameter) != section) continue;
    const bool isChoice = std::holds_alternative<ChoiceField>(parameter.field);
    if (!heading.isEmpty() && !isChoice) {
      auto* label = new QLabel(heading);
      label->setProperty("role", "heading");
      column.addWidget(label);
      heading.clear();
    }
    addRow(column, parameter, heading);
    heading.clear();
  }
}

void ParameterPanel::addRow(QVBoxLayout& column, const Parameter& parameter,
                            const QString& heading) {
  auto* row = new ParameterRow(parameter, heading);
  rows_.insert(fromUtf8(parameter.key), row);
  column.addWidget(row);
  connect(row, &ParameterRow::valueGiven, this, [this, row](const ParameterValue& value) {
    edit(*row, [&](Scene& scene) { setValue(row->parameter(), scene, value); });
  });
  connect(row, &ParameterRow::textGiven, this, [this, row](const QString& text) {
    edit(*row,
         [&](Scene& scene) { setFromText(row->parameter(), scene, text.trimmed().toStdString()); });
  });
}

template <class Change>
void ParameterPanel::edit(ParameterRow& row, Change&& change) {
  Scene next = scene_;
  try {
    change(next);
  } catch (const InputError& error) {
    row.showError(QString::fromStdString(error.message()));
    return;
  }
  followKind(scene_.surface.kind, next.surface);
  const bool changed = !(next == scene_);
  scene_ = std::move(next);
  showRows(&row);
  if (changed) emit sceneEdited(scene_);
}

void ParameterPanel::showRows(const ParameterRow* edited) {
  for (ParameterRow* row : std::as_const(rows_)) row->showScene(scene_, row == edited);
}

void ParameterPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) applyStyle();
}

void ParameterPanel::applyStyle() {
  const QString style = panelStyleSheet(palette());
  if (style != styleSheet()) setStyleSheet(style);
}

}  // namespace asperity
