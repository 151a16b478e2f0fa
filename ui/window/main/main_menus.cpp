#include "ui/window/main/main_menus.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QCursor>
#include <QEvent>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>
#include <string>
#include <utility>

#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/curve/comparison_commands.h"
#include "ui/window/curve/curve_commands.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/commands.h"
#include "ui/window/main/document_commands.h"
#include "ui/window/main/run_window.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/window_keys.h"
#include "ui/window/main/window_layout.h"
#include "ui/window/main/window_pages.h"

namespace asperity {

namespace {

struct MainMenus {
  Q_DECLARE_TR_FUNCTIONS(asperity::MainMenus)
};

/// Adds the actions to the window, so that their keys work where the menu bar is hidden.
void adoptActions(QWidget& window, const QMenu& menu) {
  for (QAction* action : menu.actions()) {
    if (action->menu())
      adoptActions(window, *action->menu());
    else if (!action->shortcut().isEmpty())
      window.addAction(action);
  }
}

/// Keeps a button of the tool bar as wide as the longest of its texts, so that the others stay
/// where they are when its text changes. Lives with the button.
class SteadyWidth : public QObject {
 public:
  SteadyWidth(QToolButton& button, std::function<QStringList()> texts)
      : QObject(&button), button_(button), texts_(std::move(texts)) {
    button_.installEventFilter(this);
    keepTranslated(button_, [this] { reserve(); });
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    const QEvent::Type type = event->type();
    if (type == QEvent::Show) reserve();
    // The button notices a change of style or font only after this filter.
    if (type == QEvent::StyleChange || type == QEvent::FontChange)
      QMetaObject::invokeMethod(this, &SteadyWidth::reserve, Qt::QueuedConnection);
    return QObject::eventFilter(watched, event);
  }

 private:
  void reserve() {
    button_.ensurePolished();
    const auto width = [this](const QString& text) {
      return button_.fontMetrics().size(Qt::TextShowMnemonic, text).width();
    };
    int widest = 0;
    for (const QString& text : texts_()) widest = std::max(widest, width(text));
    button_.setMinimumWidth(button_.sizeHint().width() - width(button_.text()) + widest);
  }

  QToolButton& button_;
  std::function<QStringList()> texts_;
};

QMenu& addMenu(QMenuBar& bar, QString (*title)()) {
  QMenu* menu = bar.addMenu(QString());
  keepTranslated(*menu, [menu, title] { menu->setTitle(title()); });
  return *menu;
}

/// Adds a submenu for each chapter; scenes without a chapter are in the menu itself.
void fillScenes(QMenu& menu, const std::function<void(const QString&)>& open) {
  std::string chapter;
  QMenu* part = &menu;
  for (const LibraryScene& entry : libraryScenes()) {
    if (entry.scene.chapter != chapter) {
      chapter = entry.scene.chapter;
      part =
          chapter.empty() ? &menu : addSubmenu(menu, {}, [chapter] { return sceneText(chapter); });
      part->setToolTipsVisible(true);
    }
    QAction* action = part->addAction(QString(), part, [open, &entry] { open(entry.name); });
    action->setObjectName("scene:" + entry.name);
    keepTranslated(*part, [action, &entry] {
      const QString title = sceneText(entry.scene.title);
      action->setText(title.isEmpty() ? entry.name : title);
      action->setToolTip(wrappedTip(sceneText(entry.scene.description)));
    });
  }
}

/// Adds a submenu of all languages and the desktop's language; the choice is remembered.
void fillLanguages(QMenu& menu, const std::function<void(std::string_view)>& use) {
  QMenu* names = addSubmenu(menu, {}, [] { return MainMenus::tr("&Language"); });
  auto* group = new QActionGroup(names);
  const auto add = [&](const QString& name, const QString& code) {
    QAction* action = checkedEntry(*names, "language:" + code, name,
                                   code == fromUtf8(chosenLanguage()), [use, code](bool) {
                                     chooseLanguage(code);
                                     use(windowLanguage());
                                   });
    return group->addAction(action);
  };
  QAction* system = add({}, {});
  for (const Language& language : languages())
    add(fromUtf8(language.name), fromUtf8(language.code));
  keepTranslated(*names, [system] { system->setText(MainMenus::tr("Same as system")); });
}

QToolButton* scenesButton(const MenuParts& parts, QMenu& menu) {
  auto* scenes = named<QToolButton>("scenesButton");
  scenes->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  scenes->setPopupMode(QToolButton::InstantPopup);
  scenes->setMenu(&menu);
  // While the menu is open, Qt does not tell the button that the pointer leaves it.
  QObject::connect(&menu, &QMenu::aboutToHide, scenes, [scenes] {
    if (scenes->rect().contains(scenes->mapFromGlobal(QCursor::pos()))) return;
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(scenes, &leave);
    scenes->update();
  });
  QObject::connect(
      &parts.appearance, &Appearance::themeChanged, scenes, [scenes](const Theme& theme) {
        scenes->setIcon(
            symbolIcon(Symbol::Scenes, themePalette(theme).color(QPalette::WindowText)));
      });
  keepTranslated(*scenes, [scenes] { scenes->setText(buttonText(MainMenus::tr("Scenes"))); });
  return scenes;
}

void addToolBar(const MenuParts& parts, QMenu& scenesMenu) {
  const Commands& commands = parts.commands;
  QToolBar* bar = parts.window.addToolBar(QString());
  bar->setObjectName("commands");
  bar->setMovable(false);
  bar->setIconSize({20, 20});
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  bar->addActions(commands.get({"play", "step", "reset"}));
  if (auto* play = qobject_cast<QToolButton*>(bar->widgetForAction(commands.get("play"))))
    new SteadyWidth(*play, parts.playTexts);
  bar->addSeparator();

  bar->addWidget(scenesButton(parts, scenesMenu));
  bar->addActions(commands.get({"figures", "open", "save"}));
  bar->addSeparator();
  bar->addActions(commands.get({"undo", "redo"}));

  auto* space = new QWidget;
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  bar->addAction(commands.get("light"));
  for (QAction* action : commands.get({"undo", "redo", "light"}))
    if (auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(action)))
      button->setToolButtonStyle(Qt::ToolButtonIconOnly);

  // This button opens the commands that do not fit. Its own arrow is black, also on a dark bar.
  auto* more = bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"));
  if (more) {
    more->setToolButtonStyle(Qt::ToolButtonTextOnly);
    more->setText(QStringLiteral("»"));
  }
  keepTranslated(*bar, [bar, more] {
    bar->setWindowTitle(MainMenus::tr("Commands"));
    if (!more) return;
    more->setToolTip(MainMenus::tr("More commands"));
    more->setAccessibleName(MainMenus::tr("More commands"));
  });
}

}  // namespace

void addMenus(const MenuParts& parts) {
  QMenuBar& bar = *parts.window.menuBar();
  // An empty name is a separator.
  const auto add = [&parts](QMenu& menu, std::initializer_list<const char*> names) {
    for (const char* name : names)
      if (*name)
        menu.addAction(parts.commands.get(name));
      else
        menu.addSeparator();
  };
  QMenu& file = addMenu(bar, [] { return MainMenus::tr("&File"); });
  file.setToolTipsVisible(true);
  add(file, {"gallery", "open"});
  parts.documents.addRecentMenu(file);
  add(file, {"openSurface", "openMaterial", "", "save", "saveAs", "", "savePicture",
             "exportPicture", "exportFilm", "exportTable", "exportFigure", "", "quit"});

  add(addMenu(bar, [] { return MainMenus::tr("&Edit"); }),
      {"undo", "redo", "", "copyPicture", "copyCommand", "copyCurveCommand", "", "revert",
       "resetAll"});

  QMenu& scenes = addMenu(bar, [] { return MainMenus::tr("&Scenes"); });
  add(scenes, {"gallery", ""});
  fillScenes(scenes, parts.openScene);

  parts.pages.fillMenu(addMenu(bar, [] { return MainMenus::tr("Fi&gures"); }));

  add(addMenu(bar, [] { return MainMenus::tr("&Run"); }), {"play", "step", "stepFinely", "reset"});

  QMenu& view = addMenu(bar, [] { return MainMenus::tr("&View"); });
  view.setToolTipsVisible(true);
  addContactViewActions(parts.canvas, view);
  add(view, {"", "describe", ""});
  parts.layout.fillMenu(view);
  view.addSeparator();
  fillLanguages(view, parts.useLanguage);

  QMenu& curve = addMenu(bar, [] { return MainMenus::tr("&Curve"); });
  parts.curve.fill(curve);
  parts.comparisons.fill(curve, parts.commands);

  add(addMenu(bar, [] { return MainMenus::tr("&Help"); }),
      {"tour", "tourStepBack", "tourStepNext", "", "lessons", "lessonBackStep", "lessonNextStep",
       "lessonEnd", "lessonEditor", "classTable", "", "guide", "shortcuts", "", "about"});

  for (const QAction* action : bar.actions()) adoptActions(parts.window, *action->menu());
  for (QMenu* menu : bar.findChildren<QMenu*>()) keepMnemonics(*menu);
  addToolBar(parts, scenes);
}

}  // namespace asperity
