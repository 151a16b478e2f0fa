#include "ui/window/gallery/scene_gallery.h"

#include <QAction>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <algorithm>

#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/window/gallery/card_list.h"
#include "ui/window/gallery/scene_cards.h"
#include "ui/window/gallery/scene_thumbnails.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/scene_library.h"

namespace asperity {

namespace {

Card cardFor(const LibraryScene& entry) {
  const SceneCard* card = findCard(entry.name);
  const QString title = sceneText(entry.scene.title);
  return {entry.name, sceneText(entry.scene.chapter), title.isEmpty() ? entry.name : title,
          card ? cardSentence(*card) : QString()};
}

/// Returns whether each word of the filter is somewhere in what is known of the scene.
bool matches(const LibraryScene& entry, const Card& card, const QString& filter) {
  const QString all = QStringList{card.name, card.chapter, card.title, card.sentence,
                                  sceneText(entry.scene.description)}
                          .join(' ');
  return std::ranges::all_of(filter.split(' ', Qt::SkipEmptyParts), [&](const QString& word) {
    return all.contains(word, Qt::CaseInsensitive);
  });
}

}  // namespace

SceneGallery::SceneGallery(QWidget* parent)
    : QWidget(parent),
      thumbnails_(new SceneThumbnails(drawScenePicture, {}, this)),
      heading_(new TitleBar("closeScenes")) {
  setObjectName("sceneGallery");
  setAutoFillBackground(true);
  thumbnails_->setTheme(pictureTheme(palette()));
  cards_ = new CardList([this](const QString& name) { return thumbnails_->picture(name); });
  none_ = named<QLabel>("noScene");
  none_->setAlignment(Qt::AlignCenter);
  none_->setWordWrap(true);
  auto* column = marginless<QVBoxLayout>(this, 0);
  fillHeading();
  column->addWidget(heading_);
  column->addWidget(cards_, 1);
  column->addWidget(none_, 1);

  connect(thumbnails_, &SceneThumbnails::changed, cards_, &CardList::showPicture);
  connect(cards_, &CardList::cardActivated, this, &SceneGallery::chosen);
  connect(cards_, &CardList::typed, this, [this](const QString& text) {
    focusFilter();
    if (text != QStringLiteral("/")) filter_->insert(text);
  });
  connect(filter_, &QLineEdit::textChanged, this, &SceneGallery::showCards);
  connect(filter_, &QLineEdit::returnPressed, this, [this] {
    if (!cards_->chosen().isEmpty() && cards_->cardCount() > 0) emit chosen(cards_->chosen());
  });
  filter_->installEventFilter(this);
  keepTranslated(*this, [this] { showTexts(); });
}

void SceneGallery::fillHeading() {
  filter_ = named<QLineEdit>("sceneFilter");
  filter_->setClearButtonEnabled(true);
  filter_->setMinimumWidth(200);
  filter_->setTextMargins(4, 0, 0, 0);
  heading_->insert(*filter_);
  heading_->leadBack(
      *this, [this] { emit closed(); }, [this] { leave(); });
}

void SceneGallery::addCommand(QAction& command) {
  auto* button = named<QToolButton>("gallery:" + command.objectName());
  button->setProperty("role", "framed");
  button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  button->setDefaultAction(&command);
  heading_->insert(*button);
  orderTabs(*this, *layout());
}

void SceneGallery::showTexts() {
  heading_->title().setText(tr("Choose a scene to begin with; everything in it can be changed"));
  filter_->setPlaceholderText(tr("Search ( / )"));
  filter_->setAccessibleName(tr("search in the scenes"));
  cards_->setAccessibleName(tr("scenes"));
  none_->setText(tr("No scene has these words. Escape clears them."));
  showCards();
}

void SceneGallery::showCards() {
  std::vector<Card> cards;
  for (const LibraryScene& entry : libraryScenes()) {
    const Card card = cardFor(entry);
    if (matches(entry, card, filter_->text())) cards.push_back(card);
  }
  cards_->setCards(cards);
  cards_->setVisible(!cards.empty());
  none_->setVisible(cards.empty());
}

void SceneGallery::choose(const QString& scene) {
  cards_->choose(scene);
}

void SceneGallery::focusFilter() {
  filter_->setFocus();
}

void SceneGallery::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  thumbnails_->setTheme(pictureTheme(palette()));
  if (isVisible()) thumbnails_->requestAll();
}

/// Escape first empties the filter.
void SceneGallery::leave() {
  if (filter_->text().isEmpty()) return emit closed();
  filter_->clear();
  cards_->setFocus();
}

void SceneGallery::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  filter_->clear();
  cards_->setFocus();
  // The pictures in sight are requested when they are painted, before the others.
  QMetaObject::invokeMethod(thumbnails_, &SceneThumbnails::requestAll, Qt::QueuedConnection);
}

/// Up and down lead from the filter to the cards.
bool SceneGallery::eventFilter(QObject* watched, QEvent* event) {
  if (watched == filter_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if ((key == Qt::Key_Down || key == Qt::Key_Up) && cards_->isVisible()) {
      cards_->setFocus();
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace asperity
