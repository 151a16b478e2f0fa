#include "ui/window/figures/figure_list.h"

#include <QPainter>
#include <QRegularExpression>
#include <QScrollBar>
#include <QStyledItemDelegate>
#include <algorithm>

#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/labels.h"

namespace asperity {

namespace {

enum FigureRole { kState = Qt::UserRole, kHeadline, kLabel, kPart };

constexpr int kPadding = 12;  // pixels, left and right
constexpr int kBar = 3;       // pixels, height of the progress bar

/// Draws label and state on one line, the headline below them, and the progress at the lower edge.
class EntryDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const QFontMetrics metrics(option.font);
    const int width = viewWidth(option) - 2 * kPadding;
    const QRect headline = metrics.boundingRect(QRect(0, 0, width, 1000), Qt::TextWordWrap,
                                                index.data(kHeadline).toString());
    return {0, metrics.height() + headline.height() + 18};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    painter->save();
    const bool isChosen = option.state & QStyle::State_Selected;
    const QPalette& palette = option.palette;
    if (isChosen) {
      QColor tint = palette.color(QPalette::Highlight);
      tint.setAlphaF(0.18F);
      painter->fillRect(option.rect, tint);
      painter->fillRect(QRect(option.rect.topLeft(), QSize(3, option.rect.height())),
                        palette.color(QPalette::Highlight));
    } else if (option.state & QStyle::State_MouseOver) {
      QColor tint = palette.color(QPalette::Text);
      tint.setAlphaF(0.06F);
      painter->fillRect(option.rect, tint);
    }
    paintTexts(*painter, option, index);
    paintProgress(*painter, option, index);
    painter->restore();
  }

 private:
  static int viewWidth(const QStyleOptionViewItem& option) {
    const auto* view = qobject_cast<const QListWidget*>(option.widget);
    return view ? view->viewport()->width() : option.rect.width();
  }

  static void paintTexts(QPainter& painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) {
    const QRect inside = option.rect.adjusted(kPadding, 7, -kPadding, -7);
    painter.setFont(boldFont(option.font));
    painter.setPen(option.palette.color(QPalette::Text));
    painter.drawText(inside, Qt::AlignLeft | Qt::AlignTop, index.data(kLabel).toString());
    painter.setFont(option.font);
    const int line = QFontMetrics(option.font).height() + 4;
    painter.drawText(inside.adjusted(0, line, 0, 0), Qt::AlignLeft | Qt::TextWordWrap,
                     index.data(kHeadline).toString());
    painter.setPen(option.palette.color(QPalette::PlaceholderText));
    painter.drawText(inside, Qt::AlignRight | Qt::AlignTop, index.data(kState).toString());
  }

  static void paintProgress(QPainter& painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) {
    const QVariant part = index.data(kPart);
    if (!part.isValid()) return;
    const QRect& r = option.rect;
    painter.fillRect(r.left(), r.bottom() - kBar + 1, static_cast<int>(r.width() * part.toDouble()),
                     kBar, option.palette.color(QPalette::Highlight));
  }
};

FigureName nameAt(int row) {
  return figureEntries()[static_cast<std::size_t>(row)].name;
}

}  // namespace

QString stateText(FigureName name, const FigureStatus& status) {
  if (status.work == FigureStage::Waiting) return FigureList::tr("waiting");
  if (status.work == FigureStage::Computing)
    return FigureList::tr("%1 %").arg(static_cast<int>(100 * status.part));
  if (!status.error.isEmpty()) return FigureList::tr("failed");
  if (!status.made) return FigureList::tr("not computed");
  if (name == FigureName::Contact) return FigureList::tr("ready");
  return status.made->realizations == 1
             ? FigureList::tr("ready, 1 line")
             : FigureList::tr("ready, %1 lines").arg(status.made->realizations);
}

FigureList::FigureList(const FigureQueue& queue, QWidget* parent)
    : QListWidget(parent), queue_(queue) {
  setObjectName("figureList");
  setItemDelegate(new EntryDelegate(this));
  setFrameShape(NoFrame);
  setMouseTracking(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollMode(ScrollPerPixel);
  for (std::size_t i = 0; i < figureEntries().size(); ++i) new QListWidgetItem(this);
  keepTranslated(*this, [this] { showTexts(); });
  setCurrentRow(0);
  connect(this, &QListWidget::currentRowChanged, this,
          [this](int row) { emit chosenChanged(nameAt(row)); });
  connect(this, &QListWidget::itemActivated, this, &FigureList::computeRequested);
  connect(&queue_, &FigureQueue::changed, this, &FigureList::showStatus);
}

FigureName FigureList::chosen() const {
  return nameAt(currentRow());
}

void FigureList::choose(FigureName name) {
  setCurrentRow(static_cast<int>(name));
}

void FigureList::showTexts() {
  setAccessibleName(tr("figures of the paper"));
  for (const FigureEntry& entry : figureEntries()) {
    QListWidgetItem& item = *this->item(static_cast<int>(entry.name));
    item.setData(kLabel, figureLabel(entry.name));
    item.setData(kHeadline, translatedText(entry.headline));
    showStatus(entry.name);
  }
}

void FigureList::showStatus(FigureName name) {
  const FigureStatus& status = queue_.status(name);
  QListWidgetItem& item = *this->item(static_cast<int>(name));
  const QString state = stateText(name, status);
  item.setData(kState, state);
  item.setData(kPart, status.work == FigureStage::Computing ? QVariant(status.part) : QVariant());
  item.setData(Qt::AccessibleTextRole,
               QStringLiteral("%1, %2, %3")
                   .arg(figureLabel(name), translatedText(figureEntry(name).headline), state));
  updateGeometry();
}

QSize FigureList::minimumSizeHint() const {
  const QFontMetrics metrics(font()), boldMetrics(boldFont(font()));
  int width = 0;
  for (int row = 0; row < count(); ++row) {
    const int label = boldMetrics.horizontalAdvance(item(row)->data(kLabel).toString());
    const int state = std::max(metrics.horizontalAdvance(tr("not computed")),
                               metrics.horizontalAdvance(item(row)->data(kState).toString()));
    width = std::max(width, label + metrics.averageCharWidth() + state);
    for (const QString& word :
         item(row)->data(kHeadline).toString().split(QRegularExpression("[ -]")))
      width = std::max(width, metrics.horizontalAdvance(word) + 1);
  }
  return {width + 2 * kPadding + verticalScrollBar()->sizeHint().width(), 80};
}

void FigureList::resizeEvent(QResizeEvent* event) {
  QListWidget::resizeEvent(event);
  scheduleDelayedItemsLayout();  // headlines are wrapped again
}

}  // namespace asperity
