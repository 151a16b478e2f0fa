#include "ui/panels/parameter_panel.h"

#include <QEvent>
#include <QFileDialog>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/base/input_error.h"
#include "core/scene/parameters.h"
#include "ui/language/translated.h"
#include "ui/panels/arms_editor.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/number_text.h"
#include "ui/panels/parameter_row.h"
#include "ui/panels/scene_files.h"

namespace asperity {

namespace {

constexpr int kLeastWidth = 350;  // pixels

/// Returns the key's section; parameters of the averaging belong to the curve's section.
QString sectionOf(const Parameter& parameter) {
  const QString key = fromUtf8(parameter.key);
  const qsizetype dot = key.indexOf('.');
  const QString section = dot < 0 ? QString() : key.left(dot);
  return section == "ensemble" ? QStringLiteral("sweep") : section;
}

QString sectionTitle(const QString& section) {
  const QMap<QString, QString> titles{
      {"surface", ParameterPanel::tr("Rigid line")},
      {"elastomer", ParameterPanel::tr("Elastomer")},
      {"load", ParameterPanel::tr("Load")},
      {"sliding", ParameterPanel::tr("Sliding")},
      {"interface", ParameterPanel::tr("Interface")},
      {"sweep", ParameterPanel::tr("Friction curve")},
      {"accuracy", ParameterPanel::tr("Accuracy")},
      {"comparison", ParameterPanel::tr("Comparison")},
  };
  if (titles.contains(section)) return titles[section];
  return section.left(1).toUpper() + section.mid(1);
}

/// Returns the sections: frequently used ones first; unknown ones follow in the order of the table.
std::vector<ParameterGroup> sections() {
  QStringList names{"sliding", "load", "elastomer", "surface", "interface", "sweep", "accuracy"};
  for (const Parameter& parameter : parameters())
    if (!names.contains(sectionOf(parameter))) names += sectionOf(parameter);
  std::vector<ParameterGroup> groups;
  for (const QString& name : names) {
    ParameterGroup group;
    if (!name.isEmpty()) group.title = [name] { return sectionTitle(name); };
    for (const Parameter& parameter : parameters())
      // The axis of the curve is chosen at the chart.
      if (sectionOf(parameter) == name && parameter.key != "sweep.key")
        group.keys.push_back(parameter.key);
    groups.push_back(std::move(group));
  }
  return groups;
}

QString askForTable(QWidget* parent, const QString& folder) {
  return QFileDialog::getOpenFileName(parent, ParameterPanel::tr("Choose a file of the line"),
                                      folder,
                                      ParameterPanel::tr("Tables (*.csv *.txt);;All files (*)"));
}

/// Returns whether two scenes read their profile from the same file.
bool haveSameFile(const Scene& a, const Scene& b) {
  return a.surface.kind == b.surface.kind && a.surface.file == b.surface.file &&
         a.folder == b.folder;
}

}  // namespace

ParameterPanel::ParameterPanel(const Scene& scene, QWidget* parent)
    : ParameterPanel(scene, sections(), parent) {}

ParameterPanel::ParameterPanel(const Scene& scene, const std::vector<ParameterGroup>& groups,
                               QWidget* parent)
    : QWidget(parent),
      scene_(scene),
      passedOn_(scene),
      sizes_(scene.surface),
      chooser_(askForTable),
      scroll_(new QScrollArea) {
  auto* content = new QWidget;
  content->setObjectName("parameterRows");
  content->setFocusPolicy(Qt::ClickFocus);
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(14, 5, 5, 5);
  column->setSpacing(3);
  for (const ParameterGroup& group : groups) addGroup(*column, group);
  column->addStretch(1);

  scroll_->setWidget(content);
  scroll_->setWidgetResizable(true);
  scroll_->setFocusPolicy(Qt::NoFocus);  // its rows take the focus
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(scroll_);
  setMinimumWidth(kLeastWidth);
  content->installEventFilter(this);
  applyStyle();
  showTexts();
}

void ParameterPanel::setScene(const Scene& scene) {
  if (!haveSameFile(scene, scene_)) line_ = {};
  scene_ = scene;
  passedOn_ = scene;
  sizes_ = KeptSizes(scene.surface);
  complaints_.clear();
  for (ParameterRow* row : std::as_const(rows_)) row->showScene(scene_, line_, true);
  showMissing();
}

void ParameterPanel::showError(const QString& key, const QString& text) {
  const QString whole = key.section('[', 0, 0);  // row of the list
  ParameterRow* row = rows_.value(whole);
  if (!row) return;
  row->showError(text);
  complaints_.insert(whole);
}

void ParameterPanel::clearErrors() {
  for (const QString& key : std::exchange(complaints_, {})) rows_.value(key)->showError({});
}

void ParameterPanel::showLine(const LineSize& line) {
  if (line == line_ || !(scene_ == passedOn_)) return;
  line_ = line;
  showRows(nullptr);
  applyAccess();
}

void ParameterPanel::setRowAccess(const std::map<std::string, RowAccess>& access) {
  access_ = access;
  showRows(nullptr);
  showMissing();
}

void ParameterPanel::applyAccess() {
  const auto others = access_.find("*");
  for (ParameterRow* row : std::as_const(rows_)) {
    const auto found = access_.find(std::string(row->parameter().key));
    const auto& chosen = found != access_.end() ? found : others;
    const RowAccess access = chosen != access_.end() ? chosen->second : RowAccess::Free;
    if (access == RowAccess::Hidden) row->hide();
    if (access == RowAccess::Locked) row->setEnabled(false);
  }
  for (const auto& [label, title] : headings_)
    label->setVisible(others == access_.end() || others->second != RowAccess::Hidden);
}

void ParameterPanel::setFileChooser(FileChooser chooser) {
  chooser_ = std::move(chooser);
}

QSize ParameterPanel::sizeHint() const {
  return {380, 640};
}

/// Adds rows under their heading. Their first choice, if they have one, is in the heading.
void ParameterPanel::addGroup(QVBoxLayout& column, const ParameterGroup& group) {
  bool hasHeading = !group.title;
  if (column.count() > 0) column.addSpacing(3);
  for (const std::string_view key : group.keys) {
    const Parameter& parameter = *findParameter(key);
    const bool isChoice = std::holds_alternative<ChoiceField>(parameter.field);
    if (!hasHeading && !(isChoice && group.isInFirstRow)) {
      auto* label = new QLabel;
      label->setProperty("role", "heading");
      column.addWidget(label);
      headings_.emplace_back(label, group.title);
      hasHeading = true;
    }
    ParameterRow& row = addRow(column, parameter);
    if (!hasHeading) headingRows_.insert(&row, group.title);
    hasHeading = true;
  }
}

ParameterRow& ParameterPanel::addRow(QVBoxLayout& column, const Parameter& parameter) {
  auto* row = new ParameterRow(parameter);
  rows_.insert(fromUtf8(parameter.key), row);
  column.addWidget(row);
  connect(row, &ParameterRow::valueGiven, this, [this, row](const ParameterValue& value) {
    edit(*row, [&](Scene& scene) { giveValue(row->parameter(), scene, value); });
  });
  connect(row, &ParameterRow::textGiven, this,
          [this, row](const QString& text) { takeText(*row, text); });
  connect(row, &ParameterRow::fileWanted, this, [this, row] { chooseFile(*row); });
  return *row;
}

/// Sets all texts. Unfinished input stays. A refused entry is refused again, in the new language.
void ParameterPanel::showTexts() {
  scroll_->widget()->setAccessibleName(tr("parameters"));
  for (const auto& [label, title] : headings_) label->setText(title());
  for (ParameterRow* row : std::as_const(rows_)) {
    const std::function<QString()> title = headingRows_.value(row);
    row->showTexts(title ? title() : QString());
  }
  showRows(nullptr);
  showMissing();
}

/// Tries a typed text. The core decides; the reason of a refusal has the words and units of the
/// entry.
void ParameterPanel::takeText(ParameterRow& row, const QString& text) {
  const Parameter& parameter = row.parameter();
  const bool isNumber = allowedRange(parameter).has_value();
  const NumberRule rule = ruleOf(parameter);
  const QString plain = isNumber ? plainNumberOf(text.trimmed(), rule) : text.trimmed();
  const QString refusal = isNumber ? refusalOf(text, rule) : QString();
  edit(
      row, [&](Scene& scene) { giveText(parameter, scene, plain.toStdString()); }, refusal);
}

void ParameterPanel::chooseFile(ParameterRow& row) {
  if (isMaterial(row.parameter())) return emit materialWanted(scene_);
  if (scene_.surface.kind == SurfaceKind::Measured) return emit surfaceWanted(scene_);
  const std::filesystem::path present = scene_.folder / scene_.surface.file;
  const QString file = chooser_(this, QString::fromStdString(present.parent_path().string()));
  if (file.isEmpty()) return;
  edit(row, [&](Scene& scene) {
    giveValue(row.parameter(), scene, nameInScene(scene, file.toStdString()));
  });
}

template <class Change>
void ParameterPanel::edit(ParameterRow& row, Change&& change, const QString& refusal) {
  Scene next = scene_;
  try {
    change(next);
  } catch (const InputError& error) {
    row.showError(refusal.isEmpty() ? translatedText(error.message()) : refusal);
    return;
  }
  complaints_.remove(fromUtf8(row.parameter().key));
  sizes_.follow(scene_.surface, next.surface);
  followRealizations(scene_, next);
  if (!haveSameFile(scene_, next)) line_ = {};
  scene_ = std::move(next);
  showRows(&row);
  showMissing();
  if (!missingOf(scene_).text.isEmpty() || scene_ == passedOn_) return;
  passedOn_ = scene_;
  emit sceneEdited(scene_);
}

void ParameterPanel::showRows(const ParameterRow* edited) {
  for (ParameterRow* row : std::as_const(rows_)) row->showScene(scene_, line_, row == edited);
}

void ParameterPanel::showMissing() {
  const Missing missing = missingOf(scene_);
  for (ParameterRow* row : std::as_const(rows_))
    row->showNote(row->parameter().key == missing.key ? missing.text : QString());
  applyAccess();
}

void ParameterPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) applyStyle();
  if (event->type() == QEvent::LanguageChange) showTexts();
}

/// Keeps the panel wide enough that rows are never cut at the side, also with a large font.
bool ParameterPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::LayoutRequest)
    setMinimumWidth(std::max(kLeastWidth, scroll_->widget()->layout()->minimumSize().width() +
                                              scroll_->verticalScrollBar()->sizeHint().width()));
  return QWidget::eventFilter(watched, event);
}

void ParameterPanel::applyStyle() {
  const QString style = panelStyleSheet(palette());
  if (style != styleSheet()) setStyleSheet(style);
}

}  // namespace asperity
