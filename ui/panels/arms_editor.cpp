#include "ui/panels/arms_editor.h"

#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/number_text.h"
#include "core/scene/list_text.h"
#include "core/scene/parameters.h"
#include "ui/language/language.h"
#include "ui/panels/number_text.h"
#include "ui/panels/value_entry.h"

namespace asperity {

namespace {

constexpr std::size_t kShort = 4;  // a list of this many arms is folded only by hand
constexpr double kNextArm = 10;    // relative to the longest relaxation time
constexpr int kColumns = 6;        // number, two values with their units, button

constexpr int kUnitDigits = 4;  // width of a unit, in digits

constexpr std::array kNames{"armModulus", "armTime"};

NumberRule ruleOf(const ArmMember& member) {
  return {fromUtf8(member.unit), 0, member.most, false, false};
}

QString quantityText(double value, const char* unit) {
  return inLanguage(QString::fromStdString(printedQuantity(value, unit)));
}

std::vector<Arm> sorted(std::vector<Arm> arms) {
  std::ranges::stable_sort(arms, {}, &Arm::relaxationTime);
  return arms;
}

/// Returns a new arm, a decade beyond the longest time, where a spectrum usually continues.
Arm armAfter(const std::vector<Arm>& arms) {
  if (arms.empty()) return {};
  Arm next = arms.back();
  const double most = armMembers()[1].most;
  next.relaxationTime = next.relaxationTime > 0 ? std::min(kNextArm * next.relaxationTime, most)
                                                : Arm{}.relaxationTime;
  return next;
}

}  // namespace

/// The widgets of one arm; owned by the table.
class ArmRow {
 public:
  ArmRow(ArmsEditor& editor, QGridLayout& grid, std::size_t index)
      : editor_(editor), index_(index), number_(new QLabel), remove_(new QToolButton) {
    const int line = static_cast<int>(2 * index) + 1;  // the error is below it
    number_->setText(QString::number(index + 1));
    number_->setProperty("role", "unit");
    grid.addWidget(number_, line, 0);
    for (std::size_t k = 0; k < entries_.size(); ++k) addValue(grid, line, k);
    remove_->setText(QStringLiteral("✕"));
    remove_->setProperty("role", "remove");
    remove_->setObjectName(QStringLiteral("armRemove:%1").arg(index));
    remove_->setFocusPolicy(Qt::TabFocus);
    // This runs later, because the button may be deleted with its arm.
    QObject::connect(
        remove_, &QToolButton::clicked, &editor_, [&editor, index] { editor.remove(index); },
        Qt::QueuedConnection);
    grid.addWidget(remove_, line, kColumns - 1);
    error_ = new QLabel;
    error_->setObjectName(QStringLiteral("armError:%1").arg(index));
    error_->setProperty("role", "error");
    error_->setWordWrap(true);
    error_->hide();
    grid.addWidget(error_, line + 1, 1, 1, kColumns - 1);
    // Widgets are shown at once: a layout would show them later, and hidden ones cannot get the
    // focus.
    for (QWidget* widget : widgets()) widget->show();
    showTexts();
  }

  void showTexts() {
    const QString labels[] = {ArmsEditor::tr("modulus of arm %1 (%2)"),
                              ArmsEditor::tr("relaxation time of arm %1 (%2)")};
    for (std::size_t k = 0; k < entries_.size(); ++k) {
      const ArmMember& member = armMembers()[k];
      entries_[k]->setAccessibleName(labels[k].arg(index_ + 1).arg(fromUtf8(member.unit)));
      entries_[k]->setToolTip(allowedInWords(ruleOf(member)));
    }
    remove_->setToolTip(ArmsEditor::tr("Remove this arm"));
    remove_->setAccessibleName(ArmsEditor::tr("remove arm %1").arg(index_ + 1));
  }

  void show(const Arm& arm, bool replace) {
    if (replace) showError({}, nullptr);
    for (std::size_t k = 0; k < entries_.size(); ++k) {
      const ArmMember& member = armMembers()[k];
      UnitText text = inReadableUnit(arm.*member.value, fromUtf8(member.unit));
      text.number = inLanguage(text.number);
      replace ? entries_[k]->replaceText(text.number, text.unit)
              : entries_[k]->showText(text.number, text.unit);
    }
  }

  void setRemovable(bool removable) { remove_->setEnabled(removable); }
  void focus() {
    entries_[0]->setFocus();
    entries_[0]->selectAll();
  }

  void dispose() {
    for (ValueEntry* entry : entries_) entry->disconnect(&editor_);
    for (QWidget* widget : widgets()) widget->hide(), widget->deleteLater();
    error_->hide(), error_->deleteLater();
  }

 private:
  /// Returns all widgets except for the error.
  std::array<QWidget*, 6> widgets() const {
    return {number_, entries_[0], units_[0], entries_[1], units_[1], remove_};
  }

  void addValue(QGridLayout& grid, int line, std::size_t k) {
    auto* entry = entries_[k] = new ValueEntry;
    entry->setObjectName(QStringLiteral("%1:%2").arg(kNames[k]).arg(index_));
    auto* unit = units_[k] = new QLabel;
    unit->setProperty("role", "unit");
    unit->setFixedWidth(kUnitDigits * unit->fontMetrics().horizontalAdvance('0'));
    QObject::connect(entry, &ValueEntry::unitShown, unit, &QLabel::setText);
    QObject::connect(entry, &ValueEntry::textCommitted, &editor_,
                     [this, k](const QString& text) { take(k, text); });
    QObject::connect(entry, &ValueEntry::takenBack, &editor_,
                     [this, entry] { showError({}, entry); });
    grid.addWidget(entry, line, static_cast<int>(1 + 2 * k));
    grid.addWidget(unit, line, static_cast<int>(2 + 2 * k));
  }

  void take(std::size_t k, const QString& typed) {
    const ArmMember& member = armMembers()[k];
    const NumberRule rule = ruleOf(member);
    const QString text = inShownUnit(withPoint(typed.trimmed()), entries_[k]->unit());
    const QString refusal = refusalOf(text, rule);
    showError(refusal, entries_[k]);
    if (!refusal.isEmpty()) return;
    Arm arm = editor_.arms_[index_];
    arm.*member.value = plainNumberOf(text, rule).toDouble();
    editor_.change(index_, arm);
  }

  void showError(const QString& reason, ValueEntry* entry) {
    if (entry) entry->showError(reason);
    error_->setText(reason);
    error_->setVisible(!reason.isEmpty());
  }

  ArmsEditor& editor_;
  std::size_t index_;
  QLabel* number_;
  std::array<ValueEntry*, 2> entries_{};
  std::array<QLabel*, 2> units_{};
  QToolButton* remove_;
  QLabel* error_ = nullptr;
};

ArmsEditor::ArmsEditor(QWidget* parent)
    : QWidget(parent), fold_(new QToolButton), table_(new QWidget), add_(new QToolButton) {
  fold_->setObjectName("armsFold");
  fold_->setProperty("role", "browse");
  fold_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  fold_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  fold_->setFocusPolicy(Qt::StrongFocus);
  connect(fold_, &QToolButton::clicked, this, [this] {
    opened_ = !isOpen();
    showFold();
  });
  grid_ = new QGridLayout(table_);
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(5);
  grid_->setVerticalSpacing(2);
  grid_->setColumnStretch(1, 1);
  grid_->setColumnStretch(3, 1);
  for (std::size_t k = 0; k < headings_.size(); ++k) {
    headings_[k] = new QLabel;
    headings_[k]->setProperty("role", "unit");
    grid_->addWidget(headings_[k], 0, static_cast<int>(1 + 2 * k), 1, 2);
  }
  add_->setObjectName("armsAdd");
  add_->setProperty("role", "browse");
  add_->setFocusPolicy(Qt::StrongFocus);
  connect(add_, &QToolButton::clicked, this, &ArmsEditor::add);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(14, 2, 0, 4);
  column->setSpacing(4);
  column->addWidget(table_);
  column->addWidget(add_, 0, Qt::AlignLeft);
  keepTranslated(*this, [this] { showTexts(); });
}

void ArmsEditor::showTexts() {
  const QString names[] = {tr("modulus"), tr("relaxation time")};
  const char* symbols[] = {"G_i", "tau_i"};
  for (std::size_t k = 0; k < headings_.size(); ++k)
    headings_[k]->setText(names[k] + "&nbsp; " + symbolHtml(symbols[k]));
  add_->setText(tr("Add arm"));
  add_->setToolTip(tr("One more arm, with ten times the longest relaxation time"));
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i]->showTexts();
    rows_[i]->show(arms_[i], false);
  }
  showFold();
}

ArmsEditor::~ArmsEditor() {
  for (const ArmRow* row : rows_) delete row;
}

void ArmsEditor::showArms(const std::vector<Arm>& arms, std::optional<std::size_t> wanted,
                          bool replace) {
  const std::vector<Arm> next = sorted(arms);
  const bool isAnother = next != arms_ || wanted != wanted_ || next.size() != rows_.size();
  if (!isAnother && !replace) return;
  arms_ = next;
  wanted_ = wanted;
  makeRows(arms_.size());
  for (std::size_t i = 0; i < arms_.size(); ++i) {
    rows_[i]->show(arms_[i], replace || isAnother);
    rows_[i]->setRemovable(!wanted_ || arms_.size() > *wanted_);
  }
  add_->setEnabled(arms_.size() < wanted_.value_or(kMostArms));
  showFold();
}

/// Passes on the arms; the editor then shows the scene's result.
void ArmsEditor::give(std::vector<Arm> arms) {
  emit armsGiven(sorted(std::move(arms)));
}

void ArmsEditor::change(std::size_t index, const Arm& arm) {
  std::vector<Arm> arms = arms_;
  arms[index] = arm;
  give(std::move(arms));
}

void ArmsEditor::add() {
  opened_ = true;
  std::vector<Arm> arms = arms_;
  arms.push_back(armAfter(arms));
  give(std::move(arms));
  if (!rows_.empty()) rows_.back()->focus();
}

void ArmsEditor::remove(std::size_t index) {
  if (index >= arms_.size()) return;
  std::vector<Arm> arms = arms_;
  arms.erase(arms.begin() + static_cast<std::ptrdiff_t>(index));
  opened_ = isOpen();
  give(std::move(arms));
  rows_.empty() ? add_->setFocus() : rows_[std::min(index, rows_.size() - 1)]->focus();
}

void ArmsEditor::makeRows(std::size_t count) {
  for (; rows_.size() > count; rows_.pop_back()) {
    rows_.back()->dispose();
    delete rows_.back();
  }
  while (rows_.size() < count) rows_.push_back(new ArmRow(*this, *grid_, rows_.size()));
}

bool ArmsEditor::isOpen() const {
  return opened_.value_or(arms_.size() <= kShort);
}

void ArmsEditor::showFold() {
  setVisible(isOpen());
  table_->setVisible(!arms_.empty());
  fold_->setArrowType(isOpen() ? Qt::UpArrow : Qt::DownArrow);
  QString text = tr("none");
  if (arms_.size() == 1) text = tr("one");
  if (arms_.size() > 1)
    text = tr("%1, %2 to %3")
               .arg(arms_.size())
               .arg(quantityText(arms_.front().relaxationTime, "s"),
                    quantityText(arms_.back().relaxationTime, "s"));
  fold_->setText(text);
  fold_->setToolTip(isOpen() ? tr("Fold the table away") : tr("Open the table"));
  fold_->setAccessibleName(tr("arms: %1").arg(text));
}

}  // namespace asperity
