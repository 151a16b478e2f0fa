#include "ui/panels/parameter_panel.h"

#include <QCoreApplication>
#include <QEvent>
#include <QFileDialog>
#include <QKeyEvent>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/base/input_error.h"
#include "core/scene/essentials.h"
#include "core/scene/parameters.h"
#include "core/scene/sweep.h"
#include "ui/language/translated.h"
#include "ui/panels/number_text.h"
#include "ui/panels/panel_headers.h"
#include "ui/panels/parameter_row.h"
#include "ui/panels/parameter_text.h"
#include "ui/panels/scene_files.h"

namespace asperity {

namespace {

constexpr int kMinWidth = 290, kDefaultWidth = 380;  // pixels
constexpr int kRemarkDelay = 3000;                   // ms

/// Returns the key's section; parameters of the averaging belong to the curve's section.
QString panelSection(const Parameter& parameter) {
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
      {"", ParameterPanel::tr("Texts of the scene")},
  };
  if (titles.contains(section)) return titles[section];
  return capitalized(section);
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

ParameterPanel::ParameterPanel(const Scene& scene, QWidget* parent)
    : ParameterPanel(scene, parameterSections(), new PanelBar, parent) {
  setView(defaultView());
}

ParameterPanel::ParameterPanel(const Scene& scene, const std::vector<ParameterGroup>& groups,
                               QWidget* parent)
    : ParameterPanel(scene, groups, nullptr, parent) {}

ParameterPanel::ParameterPanel(const Scene& scene, const std::vector<ParameterGroup>& groups,
                               PanelBar* bar, QWidget* parent)
    : QWidget(parent),
      scene_(scene),
      passedOn_(scene),
      sizes_(scene.surface),
      chooser_(askForTable),
      bar_(bar),
      noMatch_(named<QLabel>("noParameterFound")),
      scroll_(new QScrollArea) {
  // Qt evaluates the style of a widget again for each parent that it gets, with all its children.
  // So the style sheet comes first, and everything is made in its final parent.
  applyStyle();
  auto* content = named<QWidget>("parameterRows");
  content->setFocusPolicy(Qt::ClickFocus);
  scroll_->setWidgetResizable(true);
  scroll_->setFocusPolicy(Qt::NoFocus);  // its rows take the focus
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* layout = marginless<QVBoxLayout>(this, 0);
  if (bar_) {
    layout->addWidget(bar_);
    connect(bar_, &PanelBar::changed, this, &ParameterPanel::showOtherRows);
    connect(&bar_->filter(), &FilterLine::escaped, this, &ParameterPanel::filterLeft);
    connect(&bar_->filter(), &FilterLine::left, this, [this] {
      for (const Section& section : sections_)
        for (ParameterRow* row : section.rows)
          if (row->isVisibleTo(this)) return row->takeFocus();
    });
  }
  layout->addWidget(scroll_, 1);
  scroll_->setWidget(content);
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(14, 5, 8, 5);
  column->setSpacing(3);
  for (const ParameterGroup& group : groups) addGroup(*column, group);
  noMatch_->setProperty("role", "unit");
  noMatch_->setWordWrap(true);
  noMatch_->hide();
  column->addWidget(noMatch_);
  column->addStretch(1);

  setMinimumWidth(kMinWidth);
  content->installEventFilter(this);
  if (bar_) bar_->installEventFilter(this);
  remarkDelay_ = new QTimer(this);
  remarkDelay_->setSingleShot(true);
  remarkDelay_->setInterval(kRemarkDelay);
  connect(remarkDelay_, &QTimer::timeout, this, &ParameterPanel::showWaitingRemarks);
  updateUnits();
  showTexts();
}

void ParameterPanel::setScene(const Scene& scene) {
  if (!haveSameFile(scene, scene_)) line_ = {};
  scene_ = scene;
  passedOn_ = scene;
  sizes_ = RememberedSizes(scene.surface);
  runErrors_.clear();
  addMissingRows();
  updateUnits();
  for (ParameterRow* row : std::as_const(rows_)) row->showScene(scene_, line_, true);
  showRemarks();
  showMissing();
}

void ParameterPanel::showError(const QString& key, const QString& text) {
  const QString whole = key.section('[', 0, 0);  // row of the list
  if (!rows_.contains(whole)) return;
  runErrors_[whole] = text;
  updateRemarks();
}

void ParameterPanel::clearErrors() {
  runErrors_.clear();
  updateRemarks();
}

void ParameterPanel::showLine(const LineSize& line) {
  if (line == line_ || !(scene_ == passedOn_)) return;
  line_ = line;
  showRows(nullptr);
}

void ParameterPanel::setFileChooser(FileChooser chooser) {
  chooser_ = std::move(chooser);
}

QSize ParameterPanel::sizeHint() const {
  return {kDefaultWidth, 640};
}

/// Adds rows under their heading.
void ParameterPanel::addGroup(QVBoxLayout& column, const ParameterGroup& group) {
  Section section{group};
  if (!group.name.isEmpty()) {
    section.header = new SectionHeader(column.parentWidget());
    section.header->setObjectName("section:" + group.name);
    column.addWidget(section.header);
    connect(section.header, &SectionHeader::toggled, this, [this] {
      arrange();
      emit viewChanged();
    });
  } else if (group.title) {
    if (column.count() > 0) column.addSpacing(3);
    section.label = new QLabel(column.parentWidget());
    section.label->setProperty("role", "heading");
    column.addWidget(section.label);
  }
  sections_.push_back(std::move(section));
  addMissingRows();
}

/// Makes the rows that the scene needs and that do not exist yet. Most of the table has no meaning
/// for a given scene, and making rows is a large part of the time in which a window is made.
void ParameterPanel::addMissingRows() {
  QWidget& content = *scroll_->widget();
  auto& column = static_cast<QVBoxLayout&>(*content.layout());
  QWidget* before = nullptr;
  bool isOrdered = true;
  for (Section& section : sections_) {
    if (section.header) before = section.header;
    if (section.label) before = section.label;
    auto place = section.rows.begin();
    for (const std::string_view key : section.group.keys) {
      const bool exists = place != section.rows.end() && (*place)->parameter().key == key;
      const Parameter& parameter = *findParameter(key);
      if (!exists && !isApplicable(parameter, scene_)) continue;
      if (!exists) {
        place = section.rows.insert(place, &addRow(parameterIn(parameter, scene_)));
        const int below = column.indexOf(before) + 1;
        isOrdered = isOrdered && below == column.count();
        column.insertWidget(below, *place);
      }
      before = *place++;
    }
  }
  if (!isOrdered) orderTabs(content, column);
}

ParameterRow& ParameterPanel::addRow(const Parameter& parameter) {
  auto* row = new ParameterRow(parameter, scroll_->widget());
  rows_.insert(fromUtf8(parameter.key), row);
  row->showTexts();
  row->setLocked(rowAccess(parameter.key) == RowAccess::Locked);
  connect(row, &ParameterRow::valueGiven, this, [this, row](const ParameterValue& value) {
    edit(*row, [&](Scene& scene) { assignValue(row->parameter(), scene, value); });
  });
  connect(row, &ParameterRow::textGiven, this,
          [this, row](const QString& text) { takeText(*row, text); });
  connect(row, &ParameterRow::fileRequested, this, [this, row] { chooseFile(*row); });
  connect(row, &ParameterRow::guideRequested, this, &ParameterPanel::guideRequested);
  connect(row, &ParameterRow::released, this, [this] {
    if (areRemarksWaiting_) updateRemarks();
  });
  return *row;
}

/// Sets all texts but those of the rows. Unfinished input stays. A refused entry is refused again,
/// in the new language.
void ParameterPanel::showTexts() {
  scroll_->widget()->setAccessibleName(tr("parameters"));
  if (bar_) bar_->showTexts();
  for (const Section& section : sections_)
    if (section.label) section.label->setText(section.group.title());
  showRows(nullptr);
  showRemarks();
  showMissing();
  updateWidth();
}

// ---- Which rows are visible

PanelView ParameterPanel::defaultView() {
  return {false, {"interface", "sweep", "accuracy", "comparison", "texts"}};
}

PanelView ParameterPanel::view() const {
  PanelView view{showsAll(), {}};
  for (const Section& section : sections_)
    if (section.header && !section.header->isOpen()) view.folded += section.group.name;
  return view;
}

void ParameterPanel::setView(const PanelView& view) {
  if (view == this->view()) return;
  // All parts change first; then the rows follow once.
  const QSignalBlocker quietBar(bar_);
  if (bar_) bar_->setShowsAll(view.showsAll);
  for (const Section& section : sections_) {
    if (!section.header) continue;
    const QSignalBlocker quietHeader(section.header);
    section.header->setOpen(!view.folded.contains(section.group.name));
  }
  showOtherRows();
}

/// Shows the rows that another view or filter selects, from the first one on.
void ParameterPanel::showOtherRows() {
  scroll_->verticalScrollBar()->setValue(0);
  revealed_.clear();
  arrange();
  emit viewChanged();
}

bool ParameterPanel::showsAll() const {
  return !bar_ || bar_->showsAll();
}

void ParameterPanel::setRowAccess(const std::map<std::string, RowAccess>& access) {
  access_ = access;
  for (ParameterRow* row : std::as_const(rows_))
    row->setLocked(rowAccess(row->parameter().key) == RowAccess::Locked);
  arrange();
}

/// Returns the access by the longest name: the key, its sections, all.
RowAccess ParameterPanel::rowAccess(std::string_view key) const {
  std::string name(key);
  for (;;) {
    if (const auto found = access_.find(name); found != access_.end()) return found->second;
    if (name == "*" || access_.empty()) return RowAccess::Free;
    const std::size_t dot = name.rfind('.');
    name = dot == std::string::npos ? "*" : name.substr(0, dot);
  }
}

bool ParameterPanel::isNamed(std::string_view key) const {
  const auto found = access_.find(std::string(key));
  return found != access_.end() && found->second != RowAccess::Hidden;
}

/// Returns the row that the user works with: the one that is held, that has the focus, or that is
/// under the pointer; null without one.
ParameterRow* ParameterPanel::rowInUse() const {
  const auto find = [this](auto has) {
    const auto row = std::ranges::find_if(rows_, has);
    return row == rows_.end() ? nullptr : *row;
  };
  if (ParameterRow* held = find([](const ParameterRow* row) { return row->isHeld(); })) return held;
  const QWidget* focus = scroll_->widget()->focusWidget();
  if (focus && focus->hasFocus())
    if (ParameterRow* row =
            find([&](const ParameterRow* each) { return each->isAncestorOf(focus); }))
      return row;
  return find([](const ParameterRow* row) { return row->isVisible() && row->underMouse(); });
}

/// Makes a change that may move rows. The row in use keeps its place as far as scrolling can.
template <class Change>
void ParameterPanel::keepInPlace(Change&& change) {
  ParameterRow* row = isVisible() ? rowInUse() : nullptr;
  const auto place = [&] { return row->mapTo(scroll_->viewport(), QPoint()).y(); };
  const int before = row ? place() : 0;
  change();
  if (!row || !row->isVisible()) return;
  scroll_->widget()->layout()->activate();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
  QScrollBar& bar = *scroll_->verticalScrollBar();
  bar.setValue(bar.value() + place() - before);
}

/// Shows and hides rows and headings.
void ParameterPanel::arrange() {
  const QStringList words = bar_ ? bar_->words() : QStringList();
  const std::vector<std::string_view> essentials = essentialKeys(scene_);
  const bool isWhole = showsAll(), isFiltered = !words.isEmpty();
  const auto mayBeVisible = [&](const ParameterRow* row) {
    return isApplicable(row->parameter(), scene_) &&
           rowAccess(row->parameter().key) != RowAccess::Hidden;
  };
  // Words of everyday language are in the sentences; those of a name select no other row.
  const bool inSentences = isFiltered && std::ranges::none_of(rows_, [&](const auto* row) {
                             return mayBeVisible(row) && isFound(row->parameter(), words);
                           });
  int found = 0;
  for (const Section& section : sections_) {
    const bool isOpen = !section.header || section.header->isOpen();
    int here = 0, changed = 0;  // rows that can be visible, and those with a changed value
    for (ParameterRow* row : section.rows) {
      const std::string_view key = row->parameter().key;
      const bool isPossible = mayBeVisible(row);
      bool isSelected = isFiltered ? isFound(row->parameter(), words, inSentences) : isWhole;
      if (isPossible && isSelected) ++here;
      // A scene's title differs from the default in any case.
      if (isPossible && isSelected && row->isChanged() && !panelSection(row->parameter()).isEmpty())
        ++changed;
      if (!isFiltered)
        isSelected = isWhole
                         ? isOpen
                         : std::ranges::find(essentials, key) != essentials.end() || isNamed(key);
      const bool isNeeded = row->hasRemark() || fromUtf8(key) == revealed_;
      const bool isVisible = isPossible && (isSelected || isNeeded);
      row->setVisible(isVisible);
      if (isVisible) ++found;
    }
    if (section.header) {
      section.header->setVisible((isWhole || isFiltered) && here > 0);
      section.header->showState(section.group.title(), changed,
                                isFiltered || section.header->isOpen());
    }
  }
  QString nothing;
  if (found == 0 && isFiltered)
    nothing =
        tr("No parameter of this scene has “%1”. Escape clears the filter.").arg(words.join(' '));
  else if (found == 0 && !access_.empty())
    nothing = tr("Nothing is changed here in this step.");
  noMatch_->setText(nothing);
  noMatch_->setVisible(!nothing.isEmpty());
}

void ParameterPanel::showNotes(const NoteSet& notes) {
  if (notes == notes_) return;  // they come with each frame
  notes_ = notes;
  updateRemarks();
}

bool ParameterPanel::isHeld() const {
  return std::ranges::any_of(rows_, [](const auto* row) { return row->isHeld(); });
}

/// Shows the present remarks or, while a slider is held, lets them wait for its release. Warnings
/// also wait until the pointer has left the panel or rests: they would move the row that it is
/// about to reach.
void ParameterPanel::updateRemarks() {
  areRemarksWaiting_ = isHeld() || underMouse();
  if (isHeld()) return;
  showRemarks(!areRemarksWaiting_);
  if (areRemarksWaiting_) remarkDelay_->start();
}

void ParameterPanel::showWaitingRemarks() {
  if (!areRemarksWaiting_ || isHeld()) return;
  areRemarksWaiting_ = false;
  showRemarks();
}

void ParameterPanel::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  showWaitingRemarks();
}

void ParameterPanel::showRemarks(bool withWarnings) {
  QMap<ParameterRow*, QStringList> warnings;
  for (const Note note : notes_.list())
    if (ParameterRow* row = rows_.value(fromUtf8(noteKey(note, scene_))))
      warnings[row] += QStringLiteral("⚠ ") + translatedText(noteSentence(note));
  keepInPlace([&] {
    for (ParameterRow* row : std::as_const(rows_)) {
      if (withWarnings) row->showWarning(warnings.value(row).join('\n'));
      row->showRunError(runErrors_.value(fromUtf8(row->parameter().key)));
    }
    arrange();
  });
}

void ParameterPanel::reveal(const QString& key) {
  ParameterRow* row = rows_.value(key);
  if (!row) return;
  revealed_ = key;
  arrange();
  scroll_->widget()->layout()->activate();
  scroll_->ensureWidgetVisible(row);
  row->takeFocus();
}

void ParameterPanel::focusFilter() {
  if (!bar_) return;
  bar_->filter().setFocus(Qt::ShortcutFocusReason);
  bar_->filter().selectAll();
}

void ParameterPanel::clearFilter() {
  if (bar_) bar_->filter().clear();
}

// ---- Editing

/// Tries a typed text. The core decides; the reason of a refusal has the words and units of the
/// entry.
void ParameterPanel::takeText(ParameterRow& row, const QString& text) {
  const Parameter& parameter = row.parameter();
  const NumberRule rule = numberRule(parameter);
  const QString plain = isNumber(parameter) ? toPlainNumber(text.trimmed(), rule) : text.trimmed();
  const QString refusal = isNumber(parameter) ? validationError(text, rule) : QString();
  edit(
      row, [&](Scene& scene) { assignText(parameter, scene, plain.toStdString()); }, refusal);
}

void ParameterPanel::chooseFile(ParameterRow& row) {
  if (isMaterial(row.parameter())) return emit materialRequested(scene_);
  if (isList(row.parameter())) return emit frictionRequested();
  if (scene_.surface.kind == SurfaceKind::Measured) return emit surfaceRequested(scene_);
  const std::filesystem::path present = scene_.folder / scene_.surface.file;
  const QString file = chooser_(this, QString::fromStdString(present.parent_path().string()));
  if (file.isEmpty()) return;
  edit(row, [&](Scene& scene) {
    assignValue(row.parameter(), scene, nameInScene(scene, file.toStdString()));
  });
}

template <class Change>
void ParameterPanel::edit(ParameterRow& row, Change&& change, const QString& refusal) {
  Scene next = scene_;
  try {
    change(next);
  } catch (const InputError& error) {
    return keepInPlace([&] {
      row.showRefusal(refusal.isEmpty() ? translatedText(error.message()) : refusal);
      arrange();
    });
  }
  runErrors_.remove(fromUtf8(row.parameter().key));
  sizes_.update(scene_.surface, next.surface);
  updateRealizations(scene_, next);
  if (!haveSameFile(scene_, next)) line_ = {};
  scene_ = std::move(next);
  keepInPlace([&] {
    addMissingRows();
    updateUnits();
    showRows(&row);
    showMissing();
  });
  updateRemarks();  // in the new scene a note may be about another row
  if (!missingValue(scene_).text.isEmpty() || scene_ == passedOn_) return;
  passedOn_ = scene_;
  emit sceneEdited(scene_);
}

void ParameterPanel::showRows(const ParameterRow* edited) {
  for (ParameterRow* row : std::as_const(rows_)) row->showScene(scene_, line_, row == edited);
}

/// Gives the ends of the curve's axis the unit and the slider of its key, and the velocity the name
/// that it has in the scene's motion.
void ParameterPanel::updateUnits() {
  const bool isOtherAxis = std::exchange(axis_, scene_.sweep.key) != scene_.sweep.key;
  for (ParameterRow* row : std::as_const(rows_)) {
    const Parameter shown = parameterIn(*findParameter(row->parameter().key), scene_);
    const bool isEndOfAxis =
        isOtherAxis && shown.applies.choiceKey == "sweep.key" && allowedRange(shown);
    if (isEndOfAxis || shown.label != row->parameter().label) row->setParameter(shown);
  }
}

void ParameterPanel::showMissing() {
  const Missing missing = missingValue(scene_);
  for (ParameterRow* row : std::as_const(rows_))
    row->showNote(row->parameter().key == missing.key ? missing.text : QString());
  arrange();
}

void ParameterPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) applyStyle();
  if (event->type() != QEvent::LanguageChange) return;
  for (ParameterRow* row : std::as_const(rows_)) row->showTexts();
  showTexts();
}

/// Keeps the panel wide enough that rows are never cut at the side, also with a large font. The
/// width depends on the rows that the scene has, not on which of them are visible.
void ParameterPanel::updateWidth() {
  const QMargins margins = scroll_->widget()->layout()->contentsMargins();
  int row = 0;
  for (const ParameterRow* each : std::as_const(rows_))
    if (isApplicable(each->parameter(), scene_))
      // minimumSizeHint() would also lay out all texts to know the height at this width.
      row = std::max(row, each->layout()->minimumSize().width());
  const int least = std::max(
      {kMinWidth,
       row + margins.left() + margins.right() + scroll_->verticalScrollBar()->sizeHint().width(),
       bar_ ? bar_->minimumSizeHint().width() : 0});
  if (least == minimumWidth()) return;
  setMinimumWidth(least);
  const int enough = std::max(least, chosenWidth_);
  if (isVisible() && enough < width()) emit widthReleased(enough);
}

/// Only a panel that is wider than its minimum has the width that the user chose; at its minimum
/// it may be wider than that.
void ParameterPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  chosenWidth_ = width() > minimumWidth() ? width() : std::min(chosenWidth_, width());
}

/// Escape that nothing in the panel needs clears the filter, as the panel says.
void ParameterPanel::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && bar_ && !bar_->words().isEmpty()) return clearFilter();
  QWidget::keyPressEvent(event);
}

bool ParameterPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::LayoutRequest) updateWidth();
  return QWidget::eventFilter(watched, event);
}

void ParameterPanel::applyStyle() {
  const QString style = panelStyleSheet(palette());
  if (style != styleSheet()) setStyleSheet(style);
}

}  // namespace asperity
