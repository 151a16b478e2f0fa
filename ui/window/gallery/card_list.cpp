#include "ui/window/gallery/card_list.h"

#include <QEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QScrollBar>
#include <QStyledItemDelegate>
#include <algorithm>
#include <cmath>

#include "ui/panels/controls.h"
#include "ui/panels/labels.h"

namespace asperity {

namespace {

enum CardRole { kNameRole = Qt::UserRole, kTitleRole, kSentenceRole };

constexpr int kCardGap = 10;                   // pixels between cards
constexpr int kInside = 10;                    // between the edge of a card and its texts
constexpr int kMinCard = 236, kMaxCard = 520;  // width of a card, pixels
constexpr int kDefaultColumns = 4;             // more only where cards would be too wide
constexpr double kShape = 0.6;                 // height of a picture, relative to its width
constexpr double kCardCorner = 8;              // radius, pixels

int wrappedHeight(const QFont& font, const QString& text, int width) {
  return QFontMetrics(font)
      .boundingRect(QRect(0, 0, width, 10000), Qt::TextWordWrap, text)
      .height();
}

}  // namespace

/// Draws headings and cards. The picture fills the upper part of a card.
class CardList::Painter : public QStyledItemDelegate {
 public:
  explicit Painter(CardList& list) : QStyledItemDelegate(&list), list_(list) {}

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    if (!index.data(kNameRole).toString().isEmpty()) return list_.card_;
    return {std::max(1, list_.viewport()->width() - 2 * kCardGap),
            QFontMetrics(option.font).height() + 12};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setRenderHint(QPainter::SmoothPixmapTransform);
    if (index.data(kNameRole).toString().isEmpty())
      paintHeading(*painter, option, index);
    else
      paintCard(*painter, option, index);
    painter->restore();
  }

 private:
  static void paintHeading(QPainter& painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) {
    painter.setFont(boldFont(option.font));
    painter.setPen(option.palette.color(QPalette::PlaceholderText));
    painter.drawText(option.rect.adjusted(2, 0, 0, -3), Qt::AlignLeft | Qt::AlignBottom,
                     index.data(Qt::DisplayRole).toString());
  }

  void paintCard(QPainter& painter, const QStyleOptionViewItem& option,
                 const QModelIndex& index) const {
    const QPalette& palette = option.palette;
    const bool isCurrent = list_.currentIndex() == index;
    const bool isUnderMouse = option.state & QStyle::State_MouseOver;
    const QRectF card = QRectF(option.rect).adjusted(1.5, 1.5, -1.5, -1.5);
    QPainterPath outline;
    outline.addRoundedRect(card, kCardCorner, kCardCorner);
    painter.fillPath(outline, palette.color(QPalette::Base));
    paintPicture(painter, card, outline, palette, index.data(kNameRole).toString());
    paintTexts(painter, option, index, card);
    QColor edge = palette.color(isCurrent || isUnderMouse ? QPalette::Highlight : QPalette::Mid);
    if (isUnderMouse && !isCurrent) edge.setAlphaF(0.6F);
    painter.setPen(QPen(edge, isCurrent ? 2.5 : 1));
    painter.drawPath(outline);
  }

  void paintPicture(QPainter& painter, const QRectF& card, const QPainterPath& outline,
                    const QPalette& palette, const QString& name) const {
    const QRectF pictureRect(card.topLeft(), QSizeF(card.width(), kShape * card.width()));
    painter.save();
    painter.setClipPath(outline);
    const QPixmap picture = list_.picture_(name);
    if (picture.isNull())
      painter.fillRect(pictureRect, palette.color(QPalette::AlternateBase));
    else
      painter.drawPixmap(pictureRect, picture, QRectF(picture.rect()));
    painter.setPen(palette.color(QPalette::Mid));
    painter.drawLine(pictureRect.bottomLeft(), pictureRect.bottomRight());
    painter.restore();
  }

  void paintTexts(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index,
                  const QRectF& card) const {
    const QRectF texts = card.adjusted(kInside, kShape * card.width() + 7, -kInside, -4);
    painter.setFont(boldFont(option.font));
    painter.setPen(option.palette.color(QPalette::Text));
    painter.drawText(texts, Qt::AlignLeft | Qt::TextWordWrap, index.data(kTitleRole).toString());
    painter.setFont(option.font);
    const int title = wrappedHeight(boldFont(option.font), index.data(kTitleRole).toString(),
                                    static_cast<int>(texts.width()));
    painter.drawText(texts.adjusted(0, title + 3, 0, 0), Qt::AlignLeft | Qt::TextWordWrap,
                     index.data(kSentenceRole).toString());
  }

  CardList& list_;
};

CardList::CardList(std::function<QPixmap(const QString&)> picture, QWidget* parent)
    : QListWidget(parent), picture_(std::move(picture)) {
  setObjectName("sceneCards");
  setItemDelegate(new Painter(*this));
  setFrameShape(NoFrame);
  setViewMode(IconMode);
  setMovement(Static);
  setFlow(LeftToRight);
  setWrapping(true);
  setResizeMode(Adjust);
  setSpacing(kCardGap / 2);
  setMouseTracking(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  // The width stays when the number of cards changes.
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  connect(verticalScrollBar(), &QScrollBar::rangeChanged, verticalScrollBar(),
          [bar = verticalScrollBar()](int from, int to) { bar->setEnabled(from < to); });
  setVerticalScrollMode(ScrollPerPixel);
  verticalScrollBar()->setSingleStep(40);
  setSelectionMode(SingleSelection);
  connect(this, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) {
    if (const QString name = item->data(kNameRole).toString(); !name.isEmpty())
      emit cardActivated(name);
  });
}

/// The signal itemActivated() also comes from double clicks, whose first click has chosen the card
/// already.
void CardList::keyPressEvent(QKeyEvent* event) {
  if (isReturnKey(*event) && !chosen().isEmpty()) return emit cardActivated(chosen());
  // Typed letters belong to the filter.
  if (!event->text().isEmpty() && event->text().front().isPrint() &&
      !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)))
    return emit typed(event->text());
  QListWidget::keyPressEvent(event);
}

void CardList::setCards(const std::vector<Card>& cards) {
  const QString current = chosen();
  clear();
  QString chapter;
  for (const Card& card : cards) {
    if (card.chapter != chapter) {
      chapter = card.chapter;
      auto* heading = new QListWidgetItem(chapter, this);
      heading->setFlags(Qt::NoItemFlags);
    }
    auto* item = new QListWidgetItem(this);
    item->setData(kNameRole, card.name);
    item->setData(kTitleRole, card.title);
    item->setData(kSentenceRole, card.sentence);
    item->setData(Qt::AccessibleTextRole,
                  QStringLiteral("%1. %2 (%3)").arg(card.title, card.sentence, card.chapter));
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
  }
  layOut();
  choose(current);
  if (chosen().isEmpty() && !cards.empty()) choose(cards.front().name);
}

QString CardList::chosen() const {
  const QListWidgetItem* item = currentItem();
  return item ? item->data(kNameRole).toString() : QString();
}

void CardList::choose(const QString& name) {
  if (name.isEmpty()) return;
  for (const int row : cardRows())
    if (item(row)->data(kNameRole).toString() == name) {
      setCurrentRow(row);
      scrollToItem(item(row));
    }
}

int CardList::cardCount() const {
  return static_cast<int>(cardRows().size());
}

QList<int> CardList::cardRows() const {
  QList<int> rows;
  for (int row = 0; row < count(); ++row)
    if (!item(row)->data(kNameRole).toString().isEmpty()) rows += row;
  return rows;
}

void CardList::showPicture(const QString& name) {
  for (const int row : cardRows())
    if (item(row)->data(kNameRole).toString() == name) update(indexFromItem(item(row)));
}

/// Sets the size of all cards: as many columns as fit, and as high as the longest texts need.
void CardList::layOut() {
  const int available = viewport()->width() - spacing();  // each card has its spacing after it
  const int letters = QFontMetrics(font()).averageCharWidth();
  const int least = std::max(kMinCard, 30 * letters) + spacing();
  const int most = std::max(kMaxCard, 50 * letters) + spacing();
  const int fitting = std::max(1, available / least);
  const int columns = std::max(std::min(kDefaultColumns, fitting), (available + most - 1) / most);
  const int width = std::max(80, available / columns - spacing() - 1);
  int texts = 0;
  const int inside = width - 2 * kInside - 3;
  for (const int row : cardRows())
    texts = std::max(
        texts, wrappedHeight(boldFont(font()), item(row)->data(kTitleRole).toString(), inside) +
                   wrappedHeight(font(), item(row)->data(kSentenceRole).toString(), inside));
  const QSize size(width, static_cast<int>(std::lround(kShape * width)) + texts + 20);
  card_ = size;
  scheduleDelayedItemsLayout();
}

void CardList::resizeEvent(QResizeEvent* event) {
  QListWidget::resizeEvent(event);
  layOut();
}

void CardList::doItemsLayout() {
  QListWidget::doItemsLayout();
  if (currentItem()) scrollToItem(currentItem());
}

void CardList::changeEvent(QEvent* event) {
  QListWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) layOut();
}

/// Moves over cards only. Up and down go to the nearest card of the next line with cards.
QModelIndex CardList::moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers) {
  const QList<int> rows = cardRows();
  if (rows.isEmpty()) return {};
  const auto at = static_cast<int>(rows.indexOf(currentRow()));
  if (at < 0) return indexFromItem(item(rows.first()));
  const auto indexOf = [&](int index) {
    return indexFromItem(item(rows[std::clamp(index, 0, static_cast<int>(rows.size()) - 1)]));
  };
  const auto centre = [&](int row) { return visualRect(indexFromItem(item(row))).center(); };
  const QPoint here = centre(rows[at]);
  // Returns the card whose line is nearest to this distance below (sign 1) or above (-1).
  const auto towards = [&](int sign, int distance) {
    int best = rows[at];
    double least = 1e12;
    for (const int row : rows) {
      const QPoint away = centre(row) - here;
      const int down = sign * away.y();
      if (down <= card_.height() / 2) continue;
      const double cost = 1000.0 * std::abs(down - distance) + std::abs(away.x());
      if (cost >= least) continue;
      least = cost;
      best = row;
    }
    return indexFromItem(item(best));
  };
  const int page = std::max(viewport()->height() - card_.height(), card_.height());
  switch (action) {
    case MoveLeft:
    case MovePrevious:
      return indexOf(at - 1);
    case MoveRight:
    case MoveNext:
      return indexOf(at + 1);
    case MoveHome:
      return indexOf(0);
    case MoveEnd:
      return indexOf(static_cast<int>(rows.size()) - 1);
    case MoveUp:
      return towards(-1, card_.height());
    case MoveDown:
      return towards(1, card_.height());
    case MovePageUp:
      return towards(-1, page);
    case MovePageDown:
      return towards(1, page);
  }
  return QListWidget::moveCursor(action, modifiers);
}

}  // namespace asperity
