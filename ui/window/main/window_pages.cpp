#include "ui/window/main/window_pages.h"

#include <QAction>
#include <QMenu>

#include "ui/language/language.h"
#include "ui/window/figures/figures_page.h"
#include "ui/window/gallery/scene_gallery.h"
#include "ui/window/main/commands.h"

namespace asperity {

namespace {

/// The size policy of the hidden page, which otherwise would claim the width that it needs in
/// front.
constexpr QSizePolicy::Policy kNoSize = QSizePolicy::Ignored;

}  // namespace

WindowPages::WindowPages(QWidget* views, QWidget* parent) : QStackedWidget(parent) {
  addWidget(views);
}

void WindowPages::addTo(Commands& commands) {
  commands_ = &commands;
  const auto run = [this] {
    if (isShowingFigures()) return showViews();
    openFigures();
    figuresPage().choose(figuresPage().chosen(), true);
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
              if (isShowingGallery()) return showViews();
              emit galleryRequested();
            },
            {Qt::CTRL | Qt::Key_N}})
      ->setCheckable(true);
}

void WindowPages::fillMenu(QMenu& menu) {
  int key = Qt::Key_1;
  for (const FigureEntry& entry : figureEntries()) {
    QAction* action = menu.addAction(QString(), this, [this, name = entry.name] {
      openFigures();
      figuresPage().choose(name, true);
    });
    action->setObjectName("figure:" + fromUtf8(entry.word));
    action->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(key++)));
    keepTranslated(menu, [action, &entry] {
      action->setText(figureTitle(entry));
      if (entry.name < FigureName::Master)
        action->setProperty("shortText", figureLabel(entry.name));
    });
  }
  menu.addSeparator();
  menu.addAction(commands_->get("figures"));
}

/// Makes a page behind the views.
template <class Page>
Page* WindowPages::addPage() {
  auto* page = new Page;
  page->setSizePolicy(kNoSize, kNoSize);
  addWidget(page);
  connect(page, &Page::closed, this, &WindowPages::showViews);
  return page;
}

FiguresPage& WindowPages::figuresPage() {
  if (figuresPage_) return *figuresPage_;
  figuresPage_ = addPage<FiguresPage>();
  connect(figuresPage_, &FiguresPage::figureShown, this, &WindowPages::figureShown);
  connect(figuresPage_, &FiguresPage::sceneRequested, this, [this](const Scene& scene) {
    showViews();
    emit sceneRequested(scene);
  });
  return *figuresPage_;
}

SceneGallery& WindowPages::gallery() {
  if (gallery_) return *gallery_;
  gallery_ = addPage<SceneGallery>();
  gallery_->addCommand(*commands_->get("lessons"));
  connect(gallery_, &SceneGallery::chosen, this, [this](const QString& scene) {
    showViews();
    emit shippedSceneRequested(scene);
  });
  return *gallery_;
}

bool WindowPages::isShowingFigures() const {
  return currentWidget() == figuresPage_;
}

bool WindowPages::isShowingGallery() const {
  return currentWidget() == gallery_;
}

/// Brings a page to the front that covers the views.
void WindowPages::show(QWidget& page) {
  showViews();
  commands_->get("figures")->setChecked(&page == figuresPage_);
  commands_->get("gallery")->setChecked(&page == gallery_);
  page.setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  setCurrentWidget(&page);
  emit pageChanged(true);
}

void WindowPages::openFigures() {
  if (isShowingFigures())
    commands_->get("figures")->setChecked(true);
  else
    show(figuresPage());
}

void WindowPages::openGallery(const QString& scene) {
  if (isShowingGallery())
    commands_->get("gallery")->setChecked(true);
  else
    show(gallery());
  gallery().choose(scene);
}

void WindowPages::showViews() {
  for (const char* name : {"figures", "gallery"}) commands_->get(name)->setChecked(false);
  if (isShowingViews()) return;
  currentWidget()->setSizePolicy(kNoSize, kNoSize);
  setCurrentIndex(0);
  emit pageChanged(false);
}

}  // namespace asperity
