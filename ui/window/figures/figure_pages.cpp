#include "ui/window/figures/figure_pages.h"

#include <QAction>
#include <QMenu>

#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/number_text.h"
#include "ui/window/figures/gallery_page.h"
#include "ui/window/gallery/scene_gallery.h"
#include "ui/window/main/commands.h"

namespace asperity {

namespace {

/// The size policy of the hidden page, which otherwise would claim the width that it needs in
/// front.
constexpr QSizePolicy::Policy kNoSize = QSizePolicy::Ignored;

}  // namespace

FigurePages::FigurePages(QWidget* views, QWidget* parent) : QStackedWidget(parent) {
  addWidget(views);
}

void FigurePages::addTo(Commands& commands) {
  commands_ = &commands;
  const auto run = [this] {
    if (isShowingFigures()) return showViews();
    openFigures();
    gallery().choose(gallery().chosen(), true);
  };
  commands
      .add({"figures",
            [] { return tr("All figures"); },
            run,
            {Qt::CTRL | Qt::Key_G},
            Symbol::Figures,
            [] { return tr("Figures"); }})
      ->setCheckable(true);
  commands
      .add({"gallery",
            [] { return tr("Gallery…"); },
            [this] {
              if (isShowingScenes()) return showViews();
              emit galleryRequested();
            },
            {Qt::CTRL | Qt::Key_N}})
      ->setCheckable(true);
}

void FigurePages::fillMenu(QMenu& menu) {
  int key = Qt::Key_1;
  for (const FigureEntry& entry : figureEntries()) {
    QAction* action = menu.addAction(QString(), this, [this, name = entry.name] {
      openFigures();
      gallery().choose(name, true);
    });
    action->setObjectName("figure:" + fromUtf8(entry.word));
    action->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(key++)));
    // An entry has the text "Figure 2: Typical dependence …"; figures that the paper does not have
    // show their headlines.
    keepTranslated(menu, [action, &entry] {
      const QString headline = translatedText(entry.headline);
      const QString label = figureLabel(entry.name);
      const bool isNumbered = entry.name < FigureName::Master;
      action->setText(isNumbered ? tr("%1: %2").arg(label, headline) : headline);
      if (isNumbered) action->setProperty("shortText", label);
    });
  }
  menu.addSeparator();
  menu.addAction(commands_->get("figures"));
}

GalleryPage& FigurePages::gallery() {
  if (gallery_) return *gallery_;
  gallery_ = new GalleryPage;
  gallery_->setTheme(theme_);
  gallery_->setSizePolicy(kNoSize, kNoSize);
  addWidget(gallery_);
  connect(gallery_, &GalleryPage::closed, this, &FigurePages::showViews);
  connect(gallery_, &GalleryPage::figureShown, this, &FigurePages::figureShown);
  connect(gallery_, &GalleryPage::sceneRequested, this, [this](const Scene& scene) {
    showViews();
    emit sceneRequested(scene);
  });
  return *gallery_;
}

SceneGallery& FigurePages::scenes() {
  if (scenes_) return *scenes_;
  scenes_ = new SceneGallery;
  scenes_->setTheme(theme_);
  scenes_->setSizePolicy(kNoSize, kNoSize);
  addWidget(scenes_);
  scenes_->addCommand(*commands_->get("lessons"));
  connect(scenes_, &SceneGallery::closed, this, &FigurePages::showViews);
  connect(scenes_, &SceneGallery::chosen, this, [this](const QString& scene) {
    showViews();
    emit shippedSceneRequested(scene);
  });
  return *scenes_;
}

bool FigurePages::isShowingFigures() const {
  return gallery_ && currentWidget() == gallery_;
}

bool FigurePages::isShowingScenes() const {
  return scenes_ && currentWidget() == scenes_;
}

/// Brings a page to the front that covers the views.
void FigurePages::show(QWidget& page) {
  showViews();
  commands_->get("figures")->setChecked(&page == gallery_);
  commands_->get("gallery")->setChecked(&page == scenes_);
  page.setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  setCurrentWidget(&page);
  emit pageChanged(true);
}

void FigurePages::openFigures() {
  if (isShowingFigures())
    commands_->get("figures")->setChecked(true);
  else
    show(gallery());
}

void FigurePages::openScenes(const QString& scene) {
  if (isShowingScenes())
    commands_->get("gallery")->setChecked(true);
  else
    show(scenes());
  scenes().choose(scene);
}

void FigurePages::showViews() {
  for (const char* name : {"figures", "gallery"}) commands_->get(name)->setChecked(false);
  if (isShowingViews()) return;
  currentWidget()->setSizePolicy(kNoSize, kNoSize);
  setCurrentIndex(0);
  emit pageChanged(false);
}

void FigurePages::setTheme(const Theme& theme) {
  theme_ = theme;
  if (gallery_) gallery_->setTheme(theme);
  if (scenes_) scenes_->setTheme(theme);
}

}  // namespace asperity
