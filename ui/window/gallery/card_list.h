// Scenes as cards under headings of chapters: picture, title, one sentence. Arrows move between
// cards, Enter or a click chooses one. GUI thread; owned by its parent.
#pragma once

#include <QListWidget>
#include <QPixmap>
#include <functional>
#include <vector>

namespace asperity {

/// The contents of a card; a heading has only a chapter.
struct Card {
  QString name, chapter, title, sentence;
};

class CardList : public QListWidget {
  Q_OBJECT

 public:
  /// picture: returns the picture of a card; null while there is none.
  explicit CardList(std::function<QPixmap(const QString& name)> picture, QWidget* parent = nullptr);

  /// Shows cards; those of one chapter follow each other. The current card stays, if it is there.
  void setCards(const std::vector<Card>& cards);

  QString chosen() const;
  void choose(const QString& name);
  int cardCount() const;

  /// Paints the card again, because its picture has changed.
  void showPicture(const QString& name);

  /// Keeps the chosen card in view where a new width moves the cards.
  void doItemsLayout() override;

 signals:
  /// Emitted by Enter or a click.
  void cardActivated(const QString& name);
  /// Emitted by a letter, which belongs to a filter.
  void typed(const QString& text);

 protected:
  QModelIndex moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  class Painter;
  void layOut();
  QList<int> cardRows() const;

  std::function<QPixmap(const QString&)> picture_;
  QSize card_;  // pixels
};

}  // namespace asperity
