// The main window's menus and tool bar, in the order on the screen, and the dialogs of its help
// menu.
#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QCursor>
#include <QDesktopServices>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QToolBar>
#include <QToolButton>
#include <QUrl>
#include <algorithm>
#include <functional>
#include <string>
#include <utility>

#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/panels/number_text.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/curve/comparison_commands.h"
#include "ui/window/curve/curve_commands.h"
#include "ui/window/figures/figure_pages.h"
#include "ui/window/lesson/lesson_editor.h"
#include "ui/window/lesson/lessons.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/commands.h"
#include "ui/window/main/document_commands.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/run_window.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/window_keys.h"
#include "ui/window/main/window_layout.h"

namespace asperity {

namespace {

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

}  // namespace

void MainWindow::buildMenus() {
  const auto add = [this](QMenu& menu, std::initializer_list<const char*> names) {
    menu.addActions(commands_->get(names));
  };
  QMenu& file = *addMenu([] { return tr("&File"); });
  file.setToolTipsVisible(true);
  add(file, {"gallery", "open"});
  documents_->addRecentMenu(file);
  add(file, {"openSurface", "openMaterial"});
  file.addSeparator();
  add(file, {"save", "saveAs"});
  file.addSeparator();
  add(file, {"savePicture", "exportPicture", "exportFilm", "exportTable", "exportFigure"});
  file.addSeparator();
  add(file, {"quit"});

  QMenu& edit = *addMenu([] { return tr("&Edit"); });
  add(edit, {"undo", "redo"});
  edit.addSeparator();
  add(edit, {"copyPicture", "copyCommand", "copyCurveCommand"});
  edit.addSeparator();
  add(edit, {"revert", "resetAll"});

  QMenu& scenes = *addMenu([] { return tr("&Scenes"); });
  add(scenes, {"gallery"});
  scenes.addSeparator();
  fillScenes(scenes);

  figures_->fillMenu(*addMenu([] { return tr("Fi&gures"); }));

  add(*addMenu([] { return tr("&Run"); }), {"play", "step", "stepFinely", "reset"});

  QMenu& view = *addMenu([] { return tr("&View"); });
  view.setToolTipsVisible(true);
  addContactViewActions(*canvas_, view);
  view.addSeparator();
  add(view, {"describe"});
  view.addSeparator();
  windowLayout_->fillMenu(view);
  view.addSeparator();
  fillLanguages(view);

  QMenu& curve = *addMenu([] { return tr("&Curve"); });
  curveCommands_->fill(curve);
  comparisons_->fill(curve, *commands_);

  QMenu& help = *addMenu([] { return tr("&Help"); });
  add(help, {"tour", "tourStepBack", "tourStepNext"});
  help.addSeparator();
  add(help,
      {"lessons", "lessonBackStep", "lessonNextStep", "lessonEnd", "lessonEditor", "classTable"});
  help.addSeparator();
  add(help, {"guide", "shortcuts"});
  help.addSeparator();
  add(help, {"about"});

  for (const QAction* action : menuBar()->actions()) adoptActions(*this, *action->menu());
  for (QMenu* menu : menuBar()->findChildren<QMenu*>()) keepMnemonics(*menu);
  buildToolBar(scenes);
}

QMenu* MainWindow::addMenu(QString (*title)()) {
  QMenu* menu = menuBar()->addMenu(QString());
  keepTranslated(*menu, [menu, title] { menu->setTitle(title()); });
  return menu;
}

/// Adds a submenu for each chapter; scenes without a chapter are in the menu itself.
void MainWindow::fillScenes(QMenu& menu) {
  std::string chapter;
  QMenu* part = &menu;
  for (const LibraryScene& entry : libraryScenes()) {
    if (entry.scene.chapter != chapter) {
      chapter = entry.scene.chapter;
      part = chapter.empty() ? &menu : menu.addMenu(QString());
      part->setToolTipsVisible(true);
      if (part != &menu)
        keepTranslated(*part, [part, chapter] { part->setTitle(sceneText(chapter)); });
    }
    QAction* action = part->addAction(QString(), this, [this, &entry] { openShipped(entry.name); });
    action->setObjectName("scene:" + entry.name);
    keepTranslated(*part, [action, &entry] {
      const QString title = sceneText(entry.scene.title);
      action->setText(title.isEmpty() ? entry.name : title);
      action->setToolTip(wrappedTip(sceneText(entry.scene.description)));
    });
  }
}

/// Adds a submenu of all languages and the desktop's language; the choice is remembered.
void MainWindow::fillLanguages(QMenu& menu) {
  QMenu* names = menu.addMenu(QString());
  auto* group = new QActionGroup(names);
  const auto add = [&](const QString& name, const QString& code) {
    QAction* action = checkedEntry(*names, "language:" + code, name,
                                   code == fromUtf8(chosenLanguage()), [this, code](bool) {
                                     chooseLanguage(code);
                                     setLanguage(windowLanguage());
                                   });
    names->addAction(group->addAction(action));
    return action;
  };
  QAction* system = add({}, {});
  for (const Language& language : languages())
    add(fromUtf8(language.name), fromUtf8(language.code));
  keepTranslated(*names, [names, system] {
    names->setTitle(tr("&Language"));
    system->setText(tr("Same as system"));
  });
}

void MainWindow::buildToolBar(QMenu& scenesMenu) {
  QToolBar* bar = addToolBar(QString());
  bar->setObjectName("commands");
  bar->setMovable(false);
  bar->setIconSize({20, 20});
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  bar->addActions(commands_->get({"play", "step", "reset"}));
  if (auto* play = qobject_cast<QToolButton*>(bar->widgetForAction(commands_->get("play"))))
    new SteadyWidth(*play, [] { return QStringList{tr("Play"), tr("Pause")}; });
  bar->addSeparator();

  auto* scenes = named<QToolButton>("scenesButton");
  scenes->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  scenes->setPopupMode(QToolButton::InstantPopup);
  scenes->setMenu(&scenesMenu);
  // While the menu is open, Qt does not tell the button that the pointer leaves it.
  connect(&scenesMenu, &QMenu::aboutToHide, scenes, [scenes] {
    if (scenes->rect().contains(scenes->mapFromGlobal(QCursor::pos()))) return;
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(scenes, &leave);
    scenes->update();
  });
  connect(appearance_, &Appearance::themeChanged, scenes, [scenes](const Theme& theme) {
    scenes->setIcon(symbolIcon(Symbol::Scenes, themePalette(theme).color(QPalette::WindowText)));
  });
  bar->addWidget(scenes);
  bar->addActions(commands_->get({"figures", "open", "save"}));
  bar->addSeparator();
  bar->addActions(commands_->get({"undo", "redo"}));

  auto* space = new QWidget;
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  bar->addAction(commands_->get("light"));
  for (QAction* action : commands_->get({"undo", "redo", "light"}))
    if (auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(action)))
      button->setToolButtonStyle(Qt::ToolButtonIconOnly);

  // This button opens the commands that do not fit. Its own arrow is black, also on a dark bar.
  auto* more = bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"));
  if (more) {
    more->setToolButtonStyle(Qt::ToolButtonTextOnly);
    more->setText(QStringLiteral("»"));
  }
  keepTranslated(*bar, [bar, scenes, more] {
    bar->setWindowTitle(tr("Commands"));
    scenes->setText(buttonText(tr("Scenes")));
    if (!more) return;
    more->setToolTip(tr("More commands"));
    more->setAccessibleName(tr("More commands"));
  });
}

void MainWindow::showShortcuts() {
  auto* sheet = new ShortcutSheet(*this, this);
  sheet->setAttribute(Qt::WA_DeleteOnClose);
  sheet->open();
}

QString guideFile(const QString& programFolder) {
  for (const char* path : {"../share/asperity/guide.html", "../resources/guide/guide.html"}) {
    const QFileInfo file(QDir(programFolder).filePath(QString::fromLatin1(path)));
    if (file.isFile() && file.isReadable()) return file.canonicalFilePath();
  }
  return {};
}

LiveText openGuideFile(const QString& programFolder, const QString& anchor) {
  const QString file = guideFile(programFolder);
  if (file.isEmpty())
    return [] {
      return MessageBar::tr("The guide is not part of this build. Its text is in resources/guide.");
    };
  QUrl path = QUrl::fromLocalFile(file);
  if (!anchor.isEmpty()) path.setFragment(anchor);
  if (!QDesktopServices::openUrl(path))
    return [file] {
      return MessageBar::tr("No browser opens the guide; it is the file %1.")
          .arg(QDir::toNativeSeparators(file));
    };
  return {};
}

void MainWindow::openGuide(const QString& anchor) {
  const LiveText reason = openGuideFile(QCoreApplication::applicationDirPath(), anchor);
  if (reason.isEmpty())
    messages_->end(MessageBar::Failure::Files);
  else
    messages_->showFailure(MessageBar::Failure::Files, reason);
}

void MainWindow::showAbout() {
  auto* box = new QMessageBox(this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setWindowTitle(tr("About Asperity"));
  box->setText(tr("<h3>Asperity %1</h3>").arg(ASPERITY_VERSION));
  box->setInformativeText(
      tr("Shows how a viscoelastic elastomer slides over a randomly rough rigid line, after Li et "
         "al., <i>Friction between a viscoelastic body and a rigid surface with random self-affine "
         "roughness</i>, Physical Review Letters 111, 034301 (2013).<br><br>The elements of the "
         "elastomer are independent of each other: long-range elastic coupling is not in the "
         "model.<br><br>Free software, GPL-3.0-or-later."));
  box->open();
}

}  // namespace asperity
