#include "ui/panels/row_list.h"

#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/scene/essentials.h"
#include "core/scene/parameters.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/panels/panel_headers.h"
#include "ui/panels/parameter_row.h"
#include "ui/panels/parameter_text.h"

namespace asperity {

namespace {

/// Returns the key's section; parameters of the averaging belong to the curve's section.
QString panelSection(const Parameter& parameter) {
  const QString key = fromUtf8(parameter.key);
  const qsizetype dot = key.indexOf('.');
  const QString section = dot < 0 ? QString() : key.left(dot);
  return section == "ensemble" ? QStringLiteral("sweep") : section;
}

QString sectionTitle(const QString& section) {
  const QMap<QString, QString> titles{
      {"surface", RowList::tr("Rigid line")},  {"elastomer", RowList::tr("Elastomer")},
      {"load", RowList::tr("Load")},           {"sliding", RowList::tr("Sliding")},
      {"interface", RowList::tr("Interface")}, {"sweep", RowList::tr("Friction curve")},
      {"accuracy", RowList::tr("Accuracy")},   {"comparison", RowList::tr("Comparison")},
      {"", RowList::tr("Texts of the scene")},
  };
  if (titles.contains(section)) return titles[section];
  return capitalized(section);
}

}  // namespace

std::vector<ParameterGroup> parameterSections() {
  const QStringList names{"sliding",   "load",  "elastomer", "surface",
                          "interface", "sweep", "accuracy",  "comparison"};
  QStringList others;
  for (const Parameter& parameter : parameters())
    if (const QString name = panelSection(parameter);
        !names.contains(name) && !others.contains(name))
      others += name;
  // The texts of the scene, which change nothing that is computed, come last.
  if (others.removeOne(QString())) others += QString();
  std::vector<ParameterGroup> groups;
  for (const QString& name : names + others) {
    ParameterGroup group;
    group.title = [name] { return sectionTitle(name); };
    group.name = name.isEmpty() ? QStringLiteral("texts") : name;
    for (const Parameter& parameter : parameters())
      // The axis of the curve is chosen at the chart.
      if (panelSection(parameter) == name && parameter.key != "sweep.key")
        group.keys.push_back(parameter.key);
    groups.push_back(std::move(group));
  }
  return groups;
}

// ---- Which rows exist

RowList::RowList(const std::vector<ParameterGroup>& groups, QWidget* parent)
    : QWidget(parent), column_(new QVBoxLayout(this)), noMatch_(named<QLabel>("noParameterFound")) {
  setObjectName("parameterRows");
  setFocusPolicy(Qt::ClickFocus);
  column_->setContentsMargins(14, 5, 8, 5);
  column_->setSpacing(3);
  for (const ParameterGroup& group : groups) addHeading(group);
  noMatch_->setProperty("role", "unit");
  noMatch_->setWordWrap(true);
  noMatch_->hide();
  column_->addWidget(noMatch_);
  column_->addStretch(1);
  showHeadings();
}

void RowList::addHeading(const ParameterGroup& group) {
  Section& section = sections_.emplace_back(Section{group});
  if (!group.name.isEmpty()) {
    section.header = named<SectionHeader>("section:" + group.name, this);
    column_->addWidget(section.header);
    connect(section.header, &SectionHeader::toggled, this, &RowList::foldChanged);
  } else if (group.title) {
    if (column_->count() > 0) column_->addSpacing(3);
    section.label = new QLabel(this);
    section.label->setProperty("role", "heading");
    column_->addWidget(section.label);
  }
}

void RowList::prepareFor(const Scene& scene) {
  QWidget* before = nullptr;
  bool isNew = false;
  for (Section& section : sections_) {
    if (section.header) before = section.header;
    if (section.label) before = section.label;
    auto place = section.rows.begin();
    for (const std::string_view key : section.group.keys) {
      const bool exists = place != section.rows.end() && (*place)->parameter().key == key;
      const Parameter& parameter = *findParameter(key);
      if (!exists && !isApplicable(parameter, scene)) continue;
      if (!exists) {
        place = section.rows.insert(place, &makeRow(parameterIn(parameter, scene)));
        column_->insertWidget(column_->indexOf(before) + 1, *place);
        isNew = true;
      }
      before = *place++;
    }
  }
  if (isNew) orderTabs(*this, *column_);
  updateUnits(scene);
}

ParameterRow& RowList::makeRow(const Parameter& parameter) {
  auto* row = new ParameterRow(parameter, this);
  rows_.insert(fromUtf8(parameter.key), row);
  row->showTexts();
  row->setLocked(accessTo(parameter.key) == RowAccess::Locked);
  emit rowMade(row);
  return *row;
}

void RowList::updateUnits(const Scene& scene) {
  const bool isOtherAxis = std::exchange(axis_, scene.sweep.key) != scene.sweep.key;
  for (ParameterRow* row : std::as_const(rows_)) {
    const Parameter shown = parameterIn(*findParameter(row->parameter().key), scene);
    const bool isEndOfAxis =
        isOtherAxis && shown.applies.choiceKey == "sweep.key" && allowedRange(shown);
    if (isEndOfAxis || shown.label != row->parameter().label) row->setParameter(shown);
  }
}

ParameterRow* RowList::row(std::string_view key) const {
  return rows_.value(fromUtf8(key));
}

void RowList::showHeadings() {
  setAccessibleName(tr("parameters"));
  for (const Section& section : sections_)
    if (section.label) section.label->setText(section.group.title());
}

void RowList::showTexts() {
  showHeadings();
  for (ParameterRow* row : std::as_const(rows_)) row->showTexts();
}

int RowList::neededWidth(const Scene& scene) const {
  const QMargins margins = column_->contentsMargins();
  int width = 0;
  for (const ParameterRow* row : rows_)
    // minimumSizeHint() would also lay out all texts to know the height at this width.
    if (mayBeVisible(*row, scene)) width = std::max(width, row->layout()->minimumSize().width());
  return width + margins.left() + margins.right();
}

// ---- Which rows are visible

ParameterRow* RowList::firstVisible() const {
  for (const Section& section : sections_)
    for (ParameterRow* row : section.rows)
      if (row->isVisibleTo(this)) return row;
  return nullptr;
}

QStringList RowList::folded() const {
  QStringList names;
  for (const Section& section : sections_)
    if (section.header && !section.header->isOpen()) names += section.group.name;
  return names;
}

void RowList::setFolded(const QStringList& names) {
  for (const Section& section : sections_) {
    if (!section.header) continue;
    const QSignalBlocker quiet(section.header);
    section.header->setOpen(!names.contains(section.group.name));
  }
}

void RowList::setAccess(const std::map<std::string, RowAccess>& access) {
  access_ = access;
  for (ParameterRow* row : std::as_const(rows_))
    row->setLocked(accessTo(row->parameter().key) == RowAccess::Locked);
}

/// Returns the access by the longest name: the key, its sections, all.
RowAccess RowList::accessTo(std::string_view key) const {
  std::string name(key);
  for (;;) {
    if (const auto found = access_.find(name); found != access_.end()) return found->second;
    if (name == "*" || access_.empty()) return RowAccess::Free;
    const std::size_t dot = name.rfind('.');
    name = dot == std::string::npos ? "*" : name.substr(0, dot);
  }
}

bool RowList::isNamed(std::string_view key) const {
  const auto found = access_.find(std::string(key));
  return found != access_.end() && found->second != RowAccess::Hidden;
}

bool RowList::mayBeVisible(const ParameterRow& row, const Scene& scene) const {
  return isApplicable(row.parameter(), scene) && accessTo(row.parameter().key) != RowAccess::Hidden;
}

void RowList::arrange(const Scene& scene, const RowChoice& choice) {
  const QStringList& words = choice.words;
  const std::vector<std::string_view> essentials = essentialKeys(scene);
  const bool isFiltered = !words.isEmpty();
  // Words of everyday language are in the sentences; those of a name select no other row.
  const bool inSentences = isFiltered && std::ranges::none_of(rows_, [&](const auto* row) {
                             return mayBeVisible(*row, scene) && isFound(row->parameter(), words);
                           });
  int found = 0;
  for (const Section& section : sections_) {
    const bool isOpen = !section.header || section.header->isOpen();
    int here = 0, changed = 0;  // rows that can be visible, and those with a changed value
    for (ParameterRow* row : section.rows) {
      const std::string_view key = row->parameter().key;
      const bool isPossible = mayBeVisible(*row, scene);
      const bool isListed =
          isFiltered ? isFound(row->parameter(), words, inSentences) : choice.isWhole;
      if (isPossible && isListed) {
        ++here;
        // A scene's title differs from the default in any case.
        if (row->isChanged() && !panelSection(row->parameter()).isEmpty()) ++changed;
      }
      const bool isEssential = std::ranges::find(essentials, key) != essentials.end();
      const bool isSelected = isFiltered || choice.isWhole ? isListed && (isFiltered || isOpen)
                                                           : isEssential || isNamed(key);
      const bool isNeeded = row->hasRemark() || fromUtf8(key) == choice.revealed;
      const bool isVisible = isPossible && (isSelected || isNeeded);
      row->setVisible(isVisible);
      if (isVisible) ++found;
    }
    if (section.header) {
      section.header->setVisible((choice.isWhole || isFiltered) && here > 0);
      section.header->showState(section.group.title(), changed,
                                isFiltered || section.header->isOpen());
    }
  }
  QString nothing;
  if (found == 0 && isFiltered)
    nothing =
        tr("No parameter of this scene has “%1”. Escape clears the search.").arg(words.join(' '));
  else if (found == 0 && !access_.empty())
    nothing = tr("Nothing is changed here in this step.");
  noMatch_->setText(nothing);
  noMatch_->setVisible(!nothing.isEmpty());
}

}  // namespace asperity
