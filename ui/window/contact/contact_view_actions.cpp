#include "ui/window/contact/contact_view_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>
#include <array>
#include <functional>

#include "ui/language/language.h"
#include "ui/window/contact/contact_canvas.h"

namespace asperity {

namespace {

struct ViewActionText {
  Q_DECLARE_TR_FUNCTIONS(asperity::ViewActionText)
};

struct ViewAction {
  const char* name;  // object name of the action
  const char *text, *tip;
  QList<QKeySequence> keys;
};

QAction* add(ContactCanvas& canvas, QMenu& menu, const ViewAction& command,
             std::function<void(bool)> run) {
  auto* action = new QAction(&canvas);
  action->setObjectName(command.name);
  action->setShortcuts(command.keys);
  keepTranslated(canvas, [action, text = command.text, tip = command.tip] {
    action->setText(ViewActionText::tr(text));
    action->setToolTip(ViewActionText::tr(tip));
  });
  QObject::connect(action, &QAction::triggered, &canvas, std::move(run));
  canvas.addAction(action);
  menu.addAction(action);
  return action;
}

void addSeparator(ContactCanvas& canvas, QMenu& menu) {
  auto* separator = new QAction(&canvas);
  separator->setSeparator(true);
  canvas.addAction(separator);
  menu.addAction(separator);
}

void addZoom(ContactCanvas& canvas, QMenu& menu) {
  add(canvas, menu,
      {"zoomIn",
       QT_TRANSLATE_NOOP("asperity::ViewActionText", "Zoom in"),
       QT_TRANSLATE_NOOP("asperity::ViewActionText",
                         "At the crosshair or in the middle; also with the wheel"),
       {Qt::Key_Plus, Qt::Key_Equal, QKeySequence(QKeySequence::ZoomIn)}},
      [&canvas](bool) { canvas.zoom(1); });
  add(canvas, menu,
      {"zoomOut",
       QT_TRANSLATE_NOOP("asperity::ViewActionText", "Zoom out"),
       QT_TRANSLATE_NOOP("asperity::ViewActionText", "Also with the wheel"),
       {Qt::Key_Minus, QKeySequence(QKeySequence::ZoomOut)}},
      [&canvas](bool) { canvas.zoom(-1); });
  add(canvas, menu,
      {"zoomFit",
       QT_TRANSLATE_NOOP("asperity::ViewActionText", "Show all"),
       QT_TRANSLATE_NOOP("asperity::ViewActionText",
                         "The whole period, heights fitted; also a double click"),
       {Qt::Key_0, Qt::Key_F, Qt::Key_Home}},
      [&canvas](bool) { canvas.fit(); });
  addSeparator(canvas, menu);
  add(canvas, menu,
      {"steeper",
       QT_TRANSLATE_NOOP("asperity::ViewActionText", "More vertical exaggeration"),
       QT_TRANSLATE_NOOP("asperity::ViewActionText", "Also with Ctrl and the wheel"),
       {Qt::SHIFT | Qt::Key_Up}},
      [&canvas](bool) { canvas.exaggerate(1); });
  add(canvas, menu,
      {"flatter",
       QT_TRANSLATE_NOOP("asperity::ViewActionText", "Less vertical exaggeration"),
       QT_TRANSLATE_NOOP("asperity::ViewActionText", "Also with Ctrl and the wheel"),
       {Qt::SHIFT | Qt::Key_Down}},
      [&canvas](bool) { canvas.exaggerate(-1); });
  add(canvas, menu,
      {"fitHeights",
       QT_TRANSLATE_NOOP("asperity::ViewActionText", "Fit heights"),
       QT_TRANSLATE_NOOP("asperity::ViewActionText", "The exaggeration that shows all heights"),
       {Qt::Key_H}},
      [&canvas](bool) { canvas.fitHeights(); });
}

/// Adds what drags in the picture do, for the keyboard.
void addNudges(ContactCanvas& canvas, QMenu& menu) {
  add(canvas, menu,
      {"pressHarder",
       QT_TRANSLATE_NOOP("asperity::ViewActionText", "Press harder"),
       QT_TRANSLATE_NOOP("asperity::ViewActionText",
                         "More load; also by dragging the rigid body or the force's arrow down"),
       {Qt::CTRL | Qt::Key_Down}},
      [&canvas](bool) { canvas.nudge(ContactHandle::Body, 1); });
  add(canvas, menu,
      {"pressLess",
       QT_TRANSLATE_NOOP("asperity::ViewActionText", "Press less"),
       QT_TRANSLATE_NOOP("asperity::ViewActionText",
                         "Less load; also by dragging the rigid body or the force's arrow up"),
       {Qt::CTRL | Qt::Key_Up}},
      [&canvas](bool) { canvas.nudge(ContactHandle::Body, -1); });
  add(canvas, menu,
      {"slideFaster",
       QT_TRANSLATE_NOOP("asperity::ViewActionText", "Slide faster"),
       QT_TRANSLATE_NOOP("asperity::ViewActionText",
                         "More velocity; also by dragging its arrow to the right"),
       {Qt::Key_V}},
      [&canvas](bool) { canvas.nudge(ContactHandle::Velocity, 1); });
  add(canvas, menu,
      {"slideSlower",
       QT_TRANSLATE_NOOP("asperity::ViewActionText", "Slide slower"),
       QT_TRANSLATE_NOOP("asperity::ViewActionText",
                         "Less velocity; also by dragging its arrow to the left"),
       {Qt::SHIFT | Qt::Key_V}},
      [&canvas](bool) { canvas.nudge(ContactHandle::Velocity, -1); });
}

/// Adds the commands that switch something on and off; their check marks follow the canvas.
void addSwitches(ContactCanvas& canvas, QMenu& menu) {
  QAction* follow =
      add(canvas, menu,
          {"followLine",
           QT_TRANSLATE_NOOP("asperity::ViewActionText", "Follow the line"),
           QT_TRANSLATE_NOOP("asperity::ViewActionText",
                             "The line stands still in the picture and the elastomer passes by"),
           {Qt::Key_L}},
          [&canvas](bool on) { canvas.follow(on); });
  QAction* magnify =
      add(canvas, menu,
          {"magnify",
           QT_TRANSLATE_NOOP("asperity::ViewActionText", "Magnifier"),
           QT_TRANSLATE_NOOP(
               "asperity::ViewActionText",
               "Enlarges the asperity at the crosshair, or the one under the highest pressure"),
           {Qt::Key_M}},
          [&canvas](bool on) { canvas.magnify(on); });
  for (QAction* action : {follow, magnify}) action->setCheckable(true);
  const auto showState = [&canvas, follow, magnify] {
    follow->setChecked(canvas.viewer().navigation().followsLine());
    magnify->setChecked(canvas.viewer().magnifies());
  };
  QObject::connect(&canvas, &ContactCanvas::viewChanged, follow, showState);
  showState();
}

void addColours(ContactCanvas& canvas, QMenu& menu) {
  struct Choice {
    ContactOverlay overlay;
    const char *text, *tip;
  };
  static constexpr std::array<Choice, 4> kChoices{{
      {ContactOverlay::Pressure, QT_TRANSLATE_NOOP("asperity::ViewActionText", "Contact pressure"),
       QT_TRANSLATE_NOOP("asperity::ViewActionText", "Where the bodies press on each other")},
      {ContactOverlay::Relaxation,
       QT_TRANSLATE_NOOP("asperity::ViewActionText", "Time since contact"),
       QT_TRANSLATE_NOOP("asperity::ViewActionText",
                         "How long the free surface has had to recover")},
      {ContactOverlay::Power, QT_TRANSLATE_NOOP("asperity::ViewActionText", "Dissipated power"),
       QT_TRANSLATE_NOOP(
           "asperity::ViewActionText",
           "Where friction turns into heat: in contact and where the surface recovers")},
      {ContactOverlay::None, QT_TRANSLATE_NOOP("asperity::ViewActionText", "Nothing"), nullptr},
  }};
  auto* colours = new QMenu(&menu);
  colours->setObjectName("overlayMenu");
  colours->setToolTipsVisible(true);
  keepTranslated(*colours, [colours] { colours->setTitle(ViewActionText::tr("Colour by")); });
  auto* group = new QActionGroup(&canvas);
  for (const auto& [overlay, text, tip] : kChoices) {
    auto* action = new QAction(group);
    keepTranslated(canvas, [action, text = text, tip = tip ? tip : text] {
      action->setText(ViewActionText::tr(text));
      action->setToolTip(ViewActionText::tr(tip));
    });
    action->setObjectName("overlay:" + QString::fromUtf8(wordFor(overlay).data()));
    action->setCheckable(true);
    action->setChecked(overlay == canvas.viewer().overlay());
    QObject::connect(action, &QAction::triggered, &canvas,
                     [&canvas, o = overlay] { canvas.setOverlay(o); });
    QObject::connect(&canvas, &ContactCanvas::viewChanged, action, [&canvas, action, o = overlay] {
      if (canvas.viewer().overlay() == o) action->setChecked(true);
    });
    colours->addAction(action);
  }
  menu.addMenu(colours);
  canvas.addAction(colours->menuAction());
  colours->addSeparator();
  add(canvas, *colours,
      {"nextOverlay",
       QT_TRANSLATE_NOOP("asperity::ViewActionText", "Next colouring"),
       QT_TRANSLATE_NOOP("asperity::ViewActionText", "Switches to the next colouring"),
       {Qt::Key_C}},
      [&canvas, group](bool) {
        const QList<QAction*> all = group->actions();
        const auto now = all.indexOf(group->checkedAction());
        all[(now + 1) % all.size()]->trigger();
      });
}

/// Adds the entry of the context menu that opens the guide at the object under the pointer.
void addGuide(ContactCanvas& canvas) {
  auto* separator = new QAction(&canvas);
  separator->setSeparator(true);
  canvas.addAction(separator);
  auto* action = new QAction(&canvas);
  action->setObjectName("aboutContact");
  keepTranslated(canvas, [action] {
    action->setText(ViewActionText::tr("Read about it in the guide"));
    action->setToolTip(
        ViewActionText::tr("Opens the guide at what is under the pointer: a reading, a label, the "
                           "colours"));
  });
  QObject::connect(action, &QAction::triggered, &canvas, &ContactCanvas::readAbout);
  canvas.addAction(action);
}

}  // namespace

void addContactViewActions(ContactCanvas& canvas, QMenu& menu) {
  addZoom(canvas, menu);
  addSeparator(canvas, menu);
  addNudges(canvas, menu);
  addSeparator(canvas, menu);
  addSwitches(canvas, menu);
  addSeparator(canvas, menu);
  addColours(canvas, menu);
  addGuide(canvas);
}

}  // namespace asperity
