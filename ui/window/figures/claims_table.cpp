#include "ui/window/figures/claims_table.h"

#include <QEvent>
#include <QHeaderView>
#include <QPainter>
#include <QRegularExpression>
#include <QStyledItemDelegate>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/draw/ticks.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/labels.h"
#include "ui/panels/panel_style.h"

namespace asperity {

namespace {

enum ClaimColumn { kHolds, kClaim, kComputed, kExpected, kWhere, kClaimColumns };

constexpr int kBesideText = 5;  // pixels of space beside a cell's text
constexpr int kAbove = 4;       // pixels of space above and below it

QString markedVerdict(const Claim& claim) {
  const QString text = verdictText(claim);
  switch (claim.holds) {
    case Verdict::Yes:
      return QStringLiteral("✓ ") + text;
    case Verdict::No:
      return QStringLiteral("✗ ") + text;
    case Verdict::Undecided:
      return QStringLiteral("? ") + text;
    case Verdict::OnlyForScheme:
      break;
  }
  return text;
}

QColor verdictColour(Verdict verdict, bool dark) {
  switch (verdict) {
    case Verdict::Yes:
      return dark ? QColor(0x6f, 0xcf, 0x97) : QColor(0x1b, 0x7a, 0x3d);
    case Verdict::No:
      return dark ? QColor(0xff, 0x8a, 0x80) : QColor(0xb4, 0x23, 0x18);
    case Verdict::Undecided:
      return dark ? QColor(0xb0, 0xb6, 0xbf) : QColor(0x5a, 0x63, 0x6e);
    case Verdict::OnlyForScheme:
      break;
  }
  return dark ? QColor(0xff, 0xc1, 0x6b) : QColor(0x9a, 0x5b, 0x00);
}

/// Returns the details that the row itself does not show.
QString claimDetails(const Claim& claim) {
  QStringList lines{ClaimsTable::tr("Computed: %1.").arg(translatedText(claim.quantity))};
  if (!claim.criterion.empty())
    lines << ClaimsTable::tr("Holds when: %1.").arg(translatedText(claim.criterion));
  if (claim.holds == Verdict::Undecided)
    lines << ClaimsTable::tr(
        "Undecided: within two standard errors of that border, or without a standard error.");
  if (!claim.note.empty()) lines << translatedText(claim.note);
  return lines.join('\n');
}

/// Draws cells with space around their texts. The texts keep their colours in the selected row,
/// which the table tints.
class ClaimDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QStyleOptionViewItem inside = option;
    inside.rect.adjust(0, 0, -2 * kBesideText, 0);
    return QStyledItemDelegate::sizeHint(inside, index) + QSize(2 * kBesideText, 2 * kAbove);
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    QStyleOptionViewItem inside = option;
    inside.state &= ~(QStyle::State_Selected | QStyle::State_HasFocus | QStyle::State_MouseOver);
    inside.rect.adjust(kBesideText, kAbove, -kBesideText, -kAbove);
    QStyledItemDelegate::paint(painter, inside, index);
  }
};

}  // namespace

QString verdictText(const Claim& claim) {
  if (claim.holds == Verdict::OnlyForScheme)
    return QString::fromStdString(
        filled(Words::tr("only for scheme %1"), {translated(claim.scheme)}));
  if (claim.holds == Verdict::Undecided) return QString::fromStdString(Words::tr("undecided"));
  return QString::fromStdString(claim.holds == Verdict::Yes ? Words::tr("yes") : Words::tr("no"));
}

QString estimateText(const Estimate& estimate) {
  const double error = estimate.standardError;
  const double size = std::max(std::abs(estimate.value), error);
  if (!std::isfinite(estimate.value) || !std::isfinite(error) || error <= 0)
    return readingLabel(estimate.value);
  if (size >= 1e5 || size < 1e-3) {  // one power of ten for both numbers
    const int power = static_cast<int>(std::floor(std::log10(size)));
    const double unit = std::pow(10, power);
    return '(' + estimateText({estimate.value / unit, error / unit}) + QStringLiteral(")×") +
           QString::fromStdString(powerOfTen(power));
  }
  // An uncertainty that begins with 1 has two digits, any other one has one.
  const int exponent = static_cast<int>(std::floor(std::log10(error)));
  const int digits = error / std::pow(10, exponent) < 1.95 ? 1 - exponent : -exponent;
  const int decimals = std::clamp(digits, 0, 6);
  return inLanguage(QString::number(estimate.value, 'f', decimals).replace('-', u'−') +
                    QStringLiteral(" ± ") + QString::number(error, 'f', decimals));
}

ClaimsTable::ClaimsTable(QWidget* parent) : QTableWidget(0, kClaimColumns, parent) {
  setObjectName("claims");
  showTexts();
  setItemDelegate(new ClaimDelegate(this));
  setEditTriggers(NoEditTriggers);
  setSelectionBehavior(SelectRows);
  setSelectionMode(SingleSelection);
  setTabKeyNavigation(false);
  setWordWrap(true);
  setShowGrid(false);
  setFrameShape(NoFrame);
  setVerticalScrollMode(ScrollPerPixel);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  verticalHeader()->hide();
  QHeaderView& header = *horizontalHeader();
  header.setHighlightSections(false);
  header.setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  header.setSectionResizeMode(QHeaderView::Fixed);
  header.setSectionResizeMode(kClaim, QHeaderView::Stretch);
  // Claims are wrapped again, also where a scroll bar takes some of their width. This is done
  // later, because the header sends the signal while its stretched column still has its old width.
  connect(
      &header, &QHeaderView::sectionResized, this,
      [this](int column) {
        if (column == kClaim) resizeRowsToContents();
      },
      Qt::QueuedConnection);
  setWidths();
  connect(this, &QTableWidget::itemSelectionChanged, this, [this] { unfold(unfolded()); });
}

void ClaimsTable::showTexts() {
  setAccessibleName(tr("what the paper says about this figure, and whether it holds"));
  setHorizontalHeaderLabels(
      {tr("Holds"), tr("The paper says"), tr("Computed"), tr("Expected"), tr("Where")});
}

/// Returns the width that the longest word of a column needs, because words are not broken.
int ClaimsTable::longest(int column) const {
  int width = 0;
  for (int row = 0; row < rowCount(); ++row) {
    const QTableWidgetItem* cell = item(row, column);
    if (!cell) continue;
    const QVariant font = cell->data(Qt::FontRole);
    const QFontMetrics metrics(font.isValid() ? font.value<QFont>() : this->font());
    for (const QString& word : cell->text().split(QRegularExpression(QStringLiteral("\\s"))))
      width = std::max(width, metrics.horizontalAdvance(word));
  }
  constexpr int kInside = 8;  // pixels that the style keeps free beside a text
  return width + 2 * kBesideText + kInside;
}

/// Gives each column the width of its texts, within limits that grow with the table; the claim gets
/// the rest.
void ClaimsTable::setWidths() {
  ensurePolished();
  const int letter = fontMetrics().averageCharWidth(), share = width() / 8;
  for (const auto& [column, letters] :
       {std::pair{kHolds, 17}, {kComputed, 20}, {kExpected, 13}, {kWhere, 18}}) {
    const int needed = std::max(sizeHintForColumn(column),
                                horizontalHeader()->sectionSizeHint(column) + 2 * letter);
    horizontalHeader()->resizeSection(
        column, std::max(std::min(needed, std::max(letters * letter, share)), longest(column)));
  }
}

void ClaimsTable::resizeEvent(QResizeEvent* event) {
  QTableWidget::resizeEvent(event);
  if (event->oldSize().width() != event->size().width()) setWidths();
}

void ClaimsTable::changeEvent(QEvent* event) {
  QTableWidget::changeEvent(event);
  if (event->type() != QEvent::FontChange && event->type() != QEvent::LanguageChange &&
      event->type() != QEvent::PaletteChange)
    return;
  showTexts();
  const int row = unfolded();
  fill();
  if (row >= 0) selectRow(row);
}

int ClaimsTable::unfolded() const {
  return selectedItems().isEmpty() ? -1 : currentRow();
}

void ClaimsTable::setClaims(const std::vector<Claim>& claims) {
  setRowCount(0);  // a row that is chosen unfolds when the choice ends, with its own claim
  claims_ = claims;
  fill();
}

void ClaimsTable::fill() {
  clearSelection();
  setRowCount(static_cast<int>(claims_.size()));
  for (int row = 0; row < rowCount(); ++row) {
    const Claim& claim = claims_[static_cast<std::size_t>(row)];
    const QStringList cells{markedVerdict(claim), translatedText(claim.claim),
                            estimateText(claim.measured),
                            std::isfinite(claim.expected) ? readingLabel(claim.expected) : "",
                            translatedText(claim.where)};
    for (int column = 0; column < kClaimColumns; ++column) {
      auto* item = new QTableWidgetItem(cells[column]);
      item->setTextAlignment(Qt::AlignLeft | Qt::AlignTop);
      item->setToolTip(QStringLiteral("<p style='white-space:pre-wrap'>%1</p>")
                           .arg(richText(claimDetails(claim))));
      setItem(row, column, item);
    }
    item(row, kHolds)->setForeground(verdictColour(claim.holds, isDark(palette())));
    item(row, kHolds)->setFont(boldFont(font()));
  }
  setWidths();
  resizeRowsToContents();
}

void ClaimsTable::unfold(int chosen) {
  for (int row = 0; row < rowCount(); ++row) {
    const Claim& claim = claims_[static_cast<std::size_t>(row)];
    item(row, kClaim)
        ->setText(row == chosen ? translatedText(claim.claim) + "\n\n" + claimDetails(claim)
                                : translatedText(claim.claim));
  }
  resizeRowsToContents();
  updateGeometries();  // otherwise the scroll bar would use the previous height of the rows
  if (chosen >= 0) scrollTo(model()->index(chosen, kClaim));
}

}  // namespace asperity
