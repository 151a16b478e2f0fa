// The commands of the contact view.
#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>
#include <functional>

#include "ui/language/language.h"
#include "ui/panels/controls.h"
#include "ui/window/contact/contact_canvas.h"

namespace asperity {

namespace {

/// Adds the commands one after the other to the menus that show them.
class ViewActions {
  Q_DECLARE_TR_FUNCTIONS(asperity::ViewActionText)

 public:
  /// menus: the widgets to which the commands are added; of the canvas it is the context menu.
  ViewActions(ContactCanvas& canvas, const QList<QWidget*>& menus)
      : canvas_(canvas), menus_(menus) {}

  void addZoom() {
    ViewActions zoom = addMenu("zoomMenu", QT_TR_NOOP("Zoom and exaggeration"));
    zoom.addScales();
    zoom.addSeparator();
    zoom.addExaggeration();
  }

  /// Adds what drags in the picture do, for the keyboard.
  void addNudges() {
    addMenu("nudgeMenu", QT_TR_NOOP("Press and slide")).addDrags();
    addSeparator();
  }

  /// Adds the commands that switch something on and off; their check marks follow the canvas.
  void addSwitches() {
    QAction* follow =
        add("followLine", QT_TR_NOOP("Follow the line"),
            QT_TR_NOOP("The line stands still in the picture and the elastomer passes by"),
            {Qt::Key_L}, [&canvas = canvas_](bool on) { canvas.follow(on); });
    QAction* magnify =
        add("magnify", QT_TR_NOOP("Magnifier"),
            QT_TR_NOOP(
                "Enlarges the asperity at the crosshair, or the one under the greatest line load"),
            {Qt::Key_M}, [&canvas = canvas_](bool on) { canvas.magnify(on); });
    for (QAction* action : {follow, magnify}) action->setCheckable(true);
    const auto showState = [&canvas = canvas_, follow, magnify] {
      follow->setChecked(canvas.viewer().navigation().followsLine());
      magnify->setChecked(canvas.viewer().magnifies());
    };
    QObject::connect(&canvas_, &ContactCanvas::viewChanged, follow, showState);
    showState();
    addSeparator();
  }

  void addColours() {
    struct Choice {
      ContactOverlay overlay;
      const char *text, *tip;
    };
    static constexpr Choice kChoices[] = {
        {ContactOverlay::Pressure, QT_TR_NOOP("Line load"),
         QT_TR_NOOP(
             "Where the bodies press on each other, and how much: force per length of the line")},
        {ContactOverlay::Relaxation, QT_TR_NOOP("Time since contact"),
         QT_TR_NOOP("How long the free surface has had to recover")},
        {ContactOverlay::Power, QT_TR_NOOP("Dissipated power"),
         QT_TR_NOOP("Where friction turns into heat: in contact and where the surface recovers")},
        {ContactOverlay::None, QT_TR_NOOP("Nothing"), nullptr},
    };
    ViewActions colours = addMenu("overlayMenu", QT_TR_NOOP("Colour by"));
    auto* group = new QActionGroup(&canvas_);
    for (const auto& [overlay, text, tip] : kChoices) {
      QAction* action =
          checkedEntry(*group, "overlay:" + fromUtf8(choiceWord(kContactOverlays, overlay)), {},
                       overlay == canvas_.viewer().overlay(),
                       [&canvas = canvas_, o = overlay](bool) { canvas.setOverlay(o); });
      keepTexts(*action, text, tip ? tip : text);
      QObject::connect(&canvas_, &ContactCanvas::viewChanged, action,
                       [&canvas = canvas_, action, o = overlay] {
                         if (canvas.viewer().overlay() == o) action->setChecked(true);
                       });
      colours.addToMenus(*action);
    }
    colours.addSeparator();
    colours.add("nextOverlay", QT_TR_NOOP("Next colouring"),
                QT_TR_NOOP("Switches to the next colouring"), {Qt::Key_C}, [group](bool) {
                  const QList<QAction*> all = group->actions();
                  const auto now = all.indexOf(group->checkedAction());
                  all[(now + 1) % all.size()]->trigger();
                });
  }

  /// Adds the entry of the context menu that opens the guide at the object under the pointer.
  void addGuide() {
    addSeparator();
    auto* action = named<QAction>("aboutContact", &canvas_);
    keepTexts(*action, QT_TR_NOOP("Read about it in the guide"),
              QT_TR_NOOP("Opens the guide at what is under the pointer: a reading, a label, the "
                         "colours"));
    QObject::connect(action, &QAction::triggered, &canvas_, &ContactCanvas::readAbout);
    addToMenus(*action);
  }

 private:
  void addScales() {
    add("zoomIn", QT_TR_NOOP("Zoom in"),
        QT_TR_NOOP("At the crosshair or in the middle; also with the wheel"),
        {Qt::Key_Plus, Qt::Key_Equal, QKeySequence(QKeySequence::ZoomIn)},
        [&canvas = canvas_](bool) { canvas.zoom(1); });
    add("zoomOut", QT_TR_NOOP("Zoom out"), QT_TR_NOOP("Also with the wheel"),
        {Qt::Key_Minus, QKeySequence(QKeySequence::ZoomOut)},
        [&canvas = canvas_](bool) { canvas.zoom(-1); });
    add("zoomFit", QT_TR_NOOP("Show all"),
        QT_TR_NOOP("The whole period, heights fitted; also a double click"),
        {Qt::Key_0, Qt::Key_F, Qt::Key_Home}, [&canvas = canvas_](bool) { canvas.fit(); });
  }

  void addExaggeration() {
    add("steeper", QT_TR_NOOP("More vertical exaggeration"),
        QT_TR_NOOP("Also with Ctrl and the wheel"), {Qt::SHIFT | Qt::Key_Up},
        [&canvas = canvas_](bool) { canvas.exaggerate(1); });
    add("flatter", QT_TR_NOOP("Less vertical exaggeration"),
        QT_TR_NOOP("Also with Ctrl and the wheel"), {Qt::SHIFT | Qt::Key_Down},
        [&canvas = canvas_](bool) { canvas.exaggerate(-1); });
    add("fitHeights", QT_TR_NOOP("Fit heights"),
        QT_TR_NOOP("The exaggeration that shows all heights"), {Qt::Key_H},
        [&canvas = canvas_](bool) { canvas.fitHeights(); });
  }

  void addDrags() {
    const auto nudge = [&canvas = canvas_](ContactHandle handle, double steps) {
      return [&canvas, handle, steps](bool) { canvas.nudge(handle, steps); };
    };
    add("pressHarder", QT_TR_NOOP("Press harder"),
        QT_TR_NOOP("More load; also by dragging the rigid body or the force's arrow down"),
        {Qt::CTRL | Qt::Key_Down}, nudge(ContactHandle::Body, 1));
    add("pressLess", QT_TR_NOOP("Press less"),
        QT_TR_NOOP("Less load; also by dragging the rigid body or the force's arrow up"),
        {Qt::CTRL | Qt::Key_Up}, nudge(ContactHandle::Body, -1));
    add("slideFaster", QT_TR_NOOP("Slide faster"),
        QT_TR_NOOP("More velocity; also by dragging its arrow to the right"), {Qt::Key_V},
        nudge(ContactHandle::Velocity, 1));
    add("slideSlower", QT_TR_NOOP("Slide slower"),
        QT_TR_NOOP("Less velocity; also by dragging its arrow to the left"),
        {Qt::SHIFT | Qt::Key_V}, nudge(ContactHandle::Velocity, -1));
  }

  QAction* add(const char* name, const char* text, const char* tip, const QList<QKeySequence>& keys,
               std::function<void(bool)> run) {
    auto* action = named<QAction>(name, &canvas_);
    action->setShortcuts(keys);
    keepTexts(*action, text, tip);
    QObject::connect(action, &QAction::triggered, &canvas_, std::move(run));
    addToMenus(*action);
    return action;
  }

  /// Adds a submenu, and returns what adds commands to it.
  ViewActions addMenu(const char* name, const char* title) {
    auto* menu = named<QMenu>(name, menus_.back());
    menu->setToolTipsVisible(true);
    keepTranslated(*menu, [menu, title] { menu->setTitle(tr(title)); });
    addToMenus(*menu->menuAction());
    return {canvas_, {menu}};
  }

  void addToMenus(QAction& action) {
    for (QWidget* menu : menus_) menu->addAction(&action);
  }

  void keepTexts(QAction& action, const char* text, const char* tip) {
    keepTranslated(canvas_, [&action, text, tip] {
      action.setText(tr(text));
      action.setToolTip(tr(tip));
    });
  }

  void addSeparator() {
    auto* separator = new QAction(&canvas_);
    separator->setSeparator(true);
    addToMenus(*separator);
  }

  ContactCanvas& canvas_;
  QList<QWidget*> menus_;
};

}  // namespace

void addContactViewActions(ContactCanvas& canvas, QMenu& menu) {
  ViewActions actions(canvas, {&canvas, &menu});
  actions.addZoom();
  actions.addNudges();
  actions.addSwitches();
  actions.addColours();
  ViewActions(canvas, {&canvas}).addGuide();
}

}  // namespace asperity
