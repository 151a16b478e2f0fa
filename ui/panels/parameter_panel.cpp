#include "ui/panels/parameter_panel.h"

#include <QCoreApplication>
#include <QEvent>
#include <QFileDialog>
#include <QKeyEvent>
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
#include "core/scene/scene_files.h"
#include "ui/language/translated.h"
#include "ui/panels/labels.h"
#include "ui/panels/number_text.h"
#include "ui/panels/panel_headers.h"
#include "ui/panels/panel_style.h"
#include "ui/panels/parameter_row.h"

namespace asperity {

namespace {

constexpr int kMinWidth = 290, kDefaultWidth = 380;  // pixels
constexpr int kRemarkDelay = 3000;                   // ms

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
      scroll_(new QScrollArea) {
  // Qt evaluates the style of a widget again for each parent that it gets, with all its children.
  // So the style sheet comes first, and everything is made in its final parent.
  applyStyle();
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
      if (ParameterRow* row = rows_->firstVisible()) row->takeFocus();
    });
  }
  layout->addWidget(scroll_, 1);
  rows_ = new RowList(groups, scroll_->viewport());
  scroll_->setWidget(rows_);
  connect(rows_, &RowList::rowMade, this, &ParameterPanel::takeRow);
  connect(rows_, &RowList::foldChanged, this, &ParameterPanel::arrange);
  rows_->prepareFor(scene_);

  setMinimumWidth(kMinWidth);
  rows_->installEventFilter(this);
  if (bar_) bar_->installEventFilter(this);
  remarkDelay_ = new QTimer(this);
  remarkDelay_->setSingleShot(true);
  remarkDelay_->setInterval(kRemarkDelay);
  connect(remarkDelay_, &QTimer::timeout, this, &ParameterPanel::showWaitingRemarks);
  showTexts();
}

void ParameterPanel::setScene(const Scene& scene) {
  if (!haveSameFile(scene, scene_)) line_ = {};
  scene_ = scene;
  passedOn_ = scene;
  sizes_ = RememberedSizes(scene.surface);
  runErrors_.clear();
  rows_->prepareFor(scene_);
  for (ParameterRow* row : rows_->rows()) row->showScene(scene_, line_, true);
  showRemarks();
  showMissing();
}

void ParameterPanel::showError(const QString& key, const QString& text) {
  const QString whole = key.section('[', 0, 0);  // row of the list
  if (!rows_->rows().contains(whole)) return;
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

/// Listens to a new row.
void ParameterPanel::takeRow(ParameterRow* row) {
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
}

/// Sets all texts but those of the rows. Unfinished input stays. A refused entry is refused again,
/// in the new language.
void ParameterPanel::showTexts() {
  if (bar_) bar_->showTexts();
  measurePlan();
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
  return {showsAll(), rows_->folded()};
}

void ParameterPanel::setView(const PanelView& view) {
  if (view == this->view()) return;
  // All parts change first; then the rows follow once.
  const QSignalBlocker quiet(bar_);
  if (bar_) bar_->setShowsAll(view.showsAll);
  rows_->setFolded(view.folded);
  showOtherRows();
}

/// Shows the rows that another view or filter selects, from the first one on.
void ParameterPanel::showOtherRows() {
  scroll_->verticalScrollBar()->setValue(0);
  revealed_.clear();
  arrange();
}

bool ParameterPanel::showsAll() const {
  return !bar_ || bar_->showsAll();
}

void ParameterPanel::setRowAccess(const std::map<std::string, RowAccess>& access) {
  rows_->setAccess(access);
  arrange();
  updateWidth();
}

void ParameterPanel::planRows(const std::vector<PlannedRows>& plan) {
  plan_ = plan;
  measurePlan();
  updateWidth();
}

/// Shows the planned scenes one after the other, without painting them: how wide a row is may
/// depend on its values.
void ParameterPanel::measurePlan() {
  plannedWidth_ = 0;
  if (plan_.empty()) return;
  const std::map<std::string, RowAccess> access = rows_->access();
  for (const PlannedRows& planned : plan_) {
    rows_->setAccess(planned.access);
    rows_->prepareFor(planned.scene);
    for (ParameterRow* row : rows_->rows()) row->showScene(planned.scene, {}, false);
    plannedWidth_ = std::max(plannedWidth_, rows_->neededWidth(planned.scene));
  }
  rows_->setAccess(access);
  rows_->prepareFor(scene_);
  showRows(nullptr);
}

/// Returns the row that the user works with: the one that is held, that has the focus, or that is
/// under the pointer; null without one.
ParameterRow* ParameterPanel::rowInUse() const {
  const auto find = [this](auto has) {
    const auto row = std::ranges::find_if(rows_->rows(), has);
    return row == rows_->rows().end() ? nullptr : *row;
  };
  if (ParameterRow* held = find([](const ParameterRow* row) { return row->isHeld(); })) return held;
  const QWidget* focus = rows_->focusWidget();
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
  rows_->layout()->activate();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
  QScrollBar& bar = *scroll_->verticalScrollBar();
  bar.setValue(bar.value() + place() - before);
}

void ParameterPanel::arrange() {
  rows_->arrange(scene_, {showsAll(), bar_ ? bar_->words() : QStringList(), revealed_});
}

void ParameterPanel::showNotes(const NoteSet& notes) {
  if (notes == notes_) return;  // they come with each frame
  notes_ = notes;
  updateRemarks();
}

bool ParameterPanel::isHeld() const {
  return std::ranges::any_of(rows_->rows(), [](const auto* row) { return row->isHeld(); });
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
    if (ParameterRow* row = rows_->row(noteKey(note, scene_)))
      warnings[row] += translatedText(noteSentence(note));
  keepInPlace([&] {
    for (ParameterRow* row : rows_->rows()) {
      if (withWarnings) row->showWarning(warningLines(warnings.value(row)));
      row->showRunError(runErrors_.value(fromUtf8(row->parameter().key)));
    }
    arrange();
  });
}

void ParameterPanel::reveal(const QString& key) {
  ParameterRow* row = rows_->rows().value(key);
  if (!row) return;
  revealed_ = key;
  arrange();
  rows_->layout()->activate();
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
    rows_->prepareFor(scene_);
    showRows(&row);
    showMissing();
  });
  updateRemarks();  // in the new scene a note may be about another row
  if (!missingValue(scene_).text.isEmpty() || scene_ == passedOn_) return;
  passedOn_ = scene_;
  emit sceneEdited(scene_);
}

void ParameterPanel::showRows(const ParameterRow* edited) {
  for (ParameterRow* row : rows_->rows()) row->showScene(scene_, line_, row == edited);
}

void ParameterPanel::showMissing() {
  const Missing missing = missingValue(scene_);
  for (ParameterRow* row : rows_->rows())
    row->showNote(row->parameter().key == missing.key ? missing.text : QString());
  arrange();
}

void ParameterPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) applyStyle();
  if (event->type() != QEvent::LanguageChange) return;
  rows_->showTexts();
  showTexts();
}

/// Keeps the panel wide enough that rows are never cut at the side, also with a large font. The
/// width depends on the rows that the scene has, or all planned scenes have, not on which of them
/// are visible. Of a plan, only a row that would be cut moves the views beside the panel.
void ParameterPanel::updateWidth() {
  const int rows = std::max(plannedWidth_, rows_->neededWidth(scene_));
  int least = std::max({kMinWidth, rows + scroll_->verticalScrollBar()->sizeHint().width(),
                        bar_ ? bar_->minimumSizeHint().width() : 0});
  if (!plan_.empty()) least = std::max(least, minimumWidth());
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

/// Escape that nothing in the panel needs clears the filter, as its tooltip states.
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
