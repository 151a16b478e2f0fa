#include "ui/panels/pair_editor.h"

#include <QClipboard>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QToolButton>
#include <algorithm>

#include "core/base/input_error.h"
#include "core/base/text_table.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/panels/value_entry.h"

namespace asperity {

namespace {

constexpr std::size_t kShort = 4;  // rows; a list of at most so many is folded only by the user
constexpr int kGridColumns = 6;    // number, two values with their units, button
constexpr int kUnitDigits = 4;     // width of a unit, in digits

}  // namespace

/// The widgets of one row. The editor owns the row, and the table its widgets.
class PairRow {
 public:
  PairRow(PairEditor& editor, QGridLayout& grid, std::size_t index)
      : editor_(editor), index_(index), number_(new QLabel), remove_(new QToolButton) {
    const int line = static_cast<int>(2 * index) + 1;  // the error is below it
    number_->setText(QString::number(index + 1));
    number_->setProperty("role", "unit");
    grid.addWidget(number_, line, 0);
    for (std::size_t k = 0; k < entries_.size(); ++k) addValue(grid, line, k);
    remove_->setText(QStringLiteral("✕"));
    remove_->setProperty("role", "remove");
    remove_->setObjectName(editor.partName("Remove:%1").arg(index));
    remove_->setFocusPolicy(Qt::TabFocus);
    // This runs later, because the button may be deleted with its row.
    QObject::connect(
        remove_, &QToolButton::clicked, &editor_, [&editor, index] { editor.remove(index); },
        Qt::QueuedConnection);
    grid.addWidget(remove_, line, kGridColumns - 1);
    error_ = named<QLabel>(editor.partName("Error:%1").arg(index));
    error_->setProperty("role", "error");
    error_->setWordWrap(true);
    error_->hide();
    grid.addWidget(error_, line + 1, 1, 1, kGridColumns - 1);
    // Widgets are shown at once: a layout would show them later, and hidden ones cannot get the
    // focus.
    for (QWidget* widget : widgets()) widget->show();
    showTexts();
  }

  void showTexts() {
    const PairEditor::Texts texts = editor_.texts();
    for (std::size_t k = 0; k < entries_.size(); ++k) {
      const NumberRule& rule = editor_.kind_.rules[k];
      entries_[k]->setSpokenName(texts.cells[k].arg(index_ + 1));
      entries_[k]->setToolTip(allowedInWords(rule));
    }
    remove_->setToolTip(texts.removeTip);
    remove_->setAccessibleName(texts.removeName.arg(index_ + 1));
  }

  void show(const PairEditor::Pair& pair, bool replace) {
    for (std::size_t k = 0; k < entries_.size(); ++k) {
      UnitText text = inReadableUnit(pair[k], editor_.kind_.rules[k].unit);
      text.number = inLanguage(text.number);
      if (replace)
        entries_[k]->replaceText(text.number, text.unit);
      else
        entries_[k]->showText(text.number, text.unit);
    }
    showErrors();
  }

  void setRemovable(bool removable) { remove_->setEnabled(removable); }
  void focus() {
    entries_[0]->setFocus();
    entries_[0]->selectAll();
  }

  void dispose() {
    for (ValueEntry* entry : entries_) entry->disconnect(&editor_);
    const auto discard = [](QWidget* widget) {
      widget->hide();
      widget->deleteLater();
    };
    for (QWidget* widget : widgets()) discard(widget);
    discard(error_);
  }

 private:
  /// Returns all widgets except for the error.
  std::array<QWidget*, 6> widgets() const {
    return {number_, entries_[0], units_[0], entries_[1], units_[1], remove_};
  }

  void addValue(QGridLayout& grid, int line, std::size_t k) {
    auto* entry = entries_[k] = new ValueEntry;
    entry->setObjectName(QStringLiteral("%1:%2").arg(editor_.kind_.columns[k]).arg(index_));
    entry->installEventFilter(&editor_);
    auto* unit = units_[k] = new QLabel;
    unit->setProperty("role", "unit");
    unit->setFixedWidth(kUnitDigits * unit->fontMetrics().horizontalAdvance('0'));
    QObject::connect(entry, &ValueEntry::unitShown, unit, &QLabel::setText);
    QObject::connect(entry, &ValueEntry::textCommitted, &editor_,
                     [this, k](const QString& text) { take(k, text); });
    QObject::connect(entry, &ValueEntry::entryRestored, &editor_, [this] { showErrors(); });
    grid.addWidget(entry, line, static_cast<int>(1 + 2 * k));
    grid.addWidget(unit, line, static_cast<int>(2 + 2 * k));
  }

  void take(std::size_t k, const QString& typed) {
    const NumberRule& rule = editor_.kind_.rules[k];
    const QString text = inShownUnit(withoutGroups(typed.trimmed()), entries_[k]->unit());
    const QString refusal = validationError(text, rule);
    entries_[k]->showError(refusal);
    showErrors();
    if (!refusal.isEmpty()) return;
    PairEditor::Pair pair = editor_.pairs_[index_];
    pair[k] = toPlainNumber(text, rule).toDouble();
    editor_.change(index_, pair);
  }

  /// Shows below the row why values in it are refused.
  void showErrors() {
    QStringList reasons;
    for (const ValueEntry* entry : entries_)
      if (entry->hasError()) reasons += entry->errorText();
    error_->setText(reasons.join('\n'));
    error_->setVisible(!reasons.isEmpty());
  }

  PairEditor& editor_;
  std::size_t index_;
  QLabel* number_;
  std::array<ValueEntry*, 2> entries_{};
  std::array<QLabel*, 2> units_{};
  QToolButton* remove_;
  QLabel* error_ = nullptr;
};

PairEditor::PairEditor(const Kind& kind, QWidget* parent)
    : QWidget(parent),
      kind_(kind),
      fold_(named<QToolButton>(partName("sFold"))),
      table_(new QWidget),
      add_(named<QToolButton>(partName("sAdd"))),
      paste_(named<QToolButton>(partName("sPaste"))),
      refusal_(named<QLabel>(partName("sRefusal"))) {
  for (QToolButton* button : {fold_, add_, paste_}) {
    button->setProperty("role", "browse");
    button->setFocusPolicy(Qt::StrongFocus);
  }
  fold_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  fold_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  connect(fold_, &QToolButton::clicked, this, [this] {
    opened_ = !isOpen();
    showFold();
  });
  grid_ = marginless<QGridLayout>(table_);
  grid_->setHorizontalSpacing(5);
  grid_->setVerticalSpacing(2);
  grid_->setColumnStretch(1, 1);
  grid_->setColumnStretch(3, 1);
  for (std::size_t k = 0; k < headings_.size(); ++k) {
    headings_[k] = new QLabel;
    headings_[k]->setProperty("role", "unit");
    grid_->addWidget(headings_[k], 0, static_cast<int>(1 + 2 * k), 1, 2);
  }
  connect(add_, &QToolButton::clicked, this, &PairEditor::add);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(14, 2, 0, 4);
  column->setSpacing(4);
  column->addWidget(table_);
  connect(paste_, &QToolButton::clicked, this, &PairEditor::paste);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(5);
  buttons->addWidget(add_);
  buttons->addWidget(paste_);
  buttons->addStretch(1);
  column->addLayout(buttons);
  refusal_->setProperty("role", "error");
  refusal_->setWordWrap(true);
  refusal_->hide();
  column->addWidget(refusal_);
}

void PairEditor::begin() {
  keepTranslated(*this, [this] { showTexts(); });
}

QString PairEditor::partName(const char* part) const {
  return QString(kind_.name) + part;
}

PairEditor::Pairs PairEditor::sorted(Pairs pairs) const {
  std::ranges::stable_sort(pairs, {}, [this](const Pair& pair) { return pair[kind_.sortedBy]; });
  return pairs;
}

void PairEditor::showTexts() {
  const Texts shown = texts();
  for (std::size_t k = 0; k < headings_.size(); ++k) headings_[k]->setText(shown.headings[k]);
  add_->setText(shown.add);
  add_->setToolTip(shown.addTip);
  paste_->setText(shown.paste);
  paste_->setToolTip(shown.pasteTip);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i]->showTexts();
    rows_[i]->show(pairs_[i], false);
  }
  showFold();
}

PairEditor::~PairEditor() = default;

void PairEditor::showPairs(Pairs pairs, std::optional<std::size_t> prescribed, bool replace) {
  const Pairs next = sorted(std::move(pairs));
  const bool isNew = next != pairs_ || prescribed != prescribed_ || next.size() != rows_.size();
  if (!isNew && !replace) return;
  if (isNew) refusal_->hide();
  paste_->setEnabled(!prescribed || *prescribed > 1);
  pairs_ = next;
  prescribed_ = prescribed;
  makeRows(pairs_.size());
  const std::size_t least = prescribed_.value_or(kind_.mayBeEmpty ? 0 : 1);
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    rows_[i]->show(pairs_[i], replace || isNew);
    rows_[i]->setRemovable(pairs_.size() > least);
  }
  add_->setEnabled(pairs_.size() < prescribed_.value_or(kind_.most));
  showFold();
}

/// Gives the sorted rows to the panel, whose scene the editor then shows.
void PairEditor::pass(Pairs pairs) {
  emit listGiven(toValue(sorted(std::move(pairs))));
}

void PairEditor::change(std::size_t index, const Pair& pair) {
  Pairs pairs = pairs_;
  pairs[index] = pair;
  pass(std::move(pairs));
}

void PairEditor::add() {
  opened_ = true;
  Pairs pairs = pairs_;
  pairs.push_back(next(pairs));
  pass(std::move(pairs));
  if (!rows_.empty()) rows_.back()->focus();
}

void PairEditor::paste() {
  refusal_->hide();
  try {
    const std::string text = QGuiApplication::clipboard()->text().toStdString();
    const Pairs pairs = fromTable(text);
    opened_ = true;
    pass(pairs);
  } catch (const InputError& error) {
    refusal_->setText(translatedError(error));
    refusal_->show();
  }
}

bool PairEditor::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress &&
      static_cast<QKeyEvent*>(event)->matches(QKeySequence::Paste)) {
    const QString text = QGuiApplication::clipboard()->text().trimmed();
    if (text.contains(u'\n') || text.contains(u'\t')) {
      paste();
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

void PairEditor::remove(std::size_t index) {
  if (index >= pairs_.size()) return;
  Pairs pairs = pairs_;
  pairs.erase(pairs.begin() + static_cast<std::ptrdiff_t>(index));
  opened_ = isOpen();
  pass(std::move(pairs));
  if (rows_.empty())
    add_->setFocus();
  else
    rows_[std::min(index, rows_.size() - 1)]->focus();
}

void PairEditor::makeRows(std::size_t count) {
  for (; rows_.size() > count; rows_.pop_back()) rows_.back()->dispose();
  if (rows_.size() == count) return;
  while (rows_.size() < count)
    rows_.push_back(std::make_unique<PairRow>(*this, *grid_, rows_.size()));
  orderTabs(*fold_, *layout());
}

std::vector<std::size_t> columnsOfNumbers(const TextBlock& block) {
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < block.columns.size(); ++i)
    if (!block.columns[i].isText && !(block.columns.size() > 2 && countsRows(block, i)))
      columns.push_back(i);
  return columns;
}

bool PairEditor::isOpen() const {
  return opened_.value_or(pairs_.size() <= kShort);
}

void PairEditor::showFold() {
  setVisible(isOpen());
  table_->setVisible(!pairs_.empty());
  fold_->setArrowType(isOpen() ? Qt::UpArrow : Qt::DownArrow);
  QString text = tr("none");
  if (pairs_.size() == 1) text = texts().one;
  if (pairs_.size() > 1) {
    const auto end = [this](const Pair& pair) {
      return quantityLabel(pair[kind_.sortedBy], kind_.rules[kind_.sortedBy].unit.toStdString());
    };
    text = tr("%1, %2 to %3").arg(pairs_.size()).arg(end(pairs_.front()), end(pairs_.back()));
  }
  fold_->setText(text);
  fold_->setToolTip(isOpen() ? tr("Fold the table away") : tr("Open the table"));
  fold_->setAccessibleName(texts().foldName.arg(text));
}

}  // namespace asperity
