#include "ui/window/figures/figure_pages.h"

#include <QAction>
#include <QMenu>

#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/number_text.h"
#include "ui/window/figures/figures_page.h"
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

FiguresPage& FigurePages::figuresPage() {
  if (figuresPage_) return *figuresPage_;
  figuresPage_ = new FiguresPage;
  figuresPage_->setTheme(theme_);
  figuresPage_->setSizePolicy(kNoSize, kNoSize);
  addWidget(figuresPage_);
  connect(figuresPage_, &FiguresPage::closed, this, &FigurePages::showViews);
  connect(figuresPage_, &FiguresPage::figureShown, this, &FigurePages::figureShown);
  connect(figuresPage_, &FiguresPage::sceneRequested, this, [this](const Scene& scene) {
    showViews();
    emit sceneRequested(scene);
  });
  return *figuresPage_;
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
  return figuresPage_ && currentWidget() == figuresPage_;
}

bool FigurePages::isShowingScenes() const {
  return scenes_ && currentWidget() == scenes_;
}

/// Brings a page to the front that covers the views.
void FigurePages::show(QWidget& page) {
  showViews();
  commands_->get("figures")->setChecked(&page == figuresPage_);
  commands_->get("gallery")->setChecked(&page == scenes_);
  page.setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  setCurrentWidget(&page);
  emit pageChanged(true);
}

void FigurePages::openFigures() {
  if (isShowingFigures())
    commands_->get("figures")->setChecked(true);
  else
    show(figuresPage());
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
  if (figuresPage_) figuresPage_->setTheme(theme);
  if (scenes_) scenes_->setTheme(theme);
}

}  // namespace asperity
