#include "ui/window/main/contact_view_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>
#include <array>
#include <functional>

#include "ui/window/main/contact_canvas.h"

namespace asperity {

namespace {

struct ViewActionText {
  Q_DECLARE_TR_FUNCTIONS(asperity::ViewActionText)
};

struct Command {
  const char* name;  // of the object
  QString text, tip;
  QList<QKeySequence> keys;
};

QAction* add(ContactCanvas& canvas, QMenu& menu, const Command& command,
             std::function<void(bool)> run) {
  auto* action = new QAction(command.text, &canvas);
  action->setObjectName(command.name);
  action->setToolTip(command.tip);
  action->setShortcuts(command.keys);
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
       ViewActionText::tr("Zoom in"),
       ViewActionText::tr("At the crosshair, or in the middle; also the wheel"),
       {Qt::Key_Plus, Qt::Key_Equal, QKeySequence(QKeySequence::ZoomIn)}},
      [&canvas](bool) { canvas.zoom(1); });
  add(canvas, menu,
      {"zoomOut",
       ViewActionText::tr("Zoom out"),
       ViewActionText::tr("Also the wheel"),
       {Qt::Key_Minus, QKeySequence(QKeySequence::ZoomOut)}},
      [&canvas](bool) { canvas.zoom(-1); });
  add(canvas, menu,
      {"zoomFit",
       ViewActionText::tr("Show all"),
       ViewActionText::tr("The whole period, heights fitted; also a double click"),
       {Qt::Key_0, Qt::Key_F, Qt::Key_Home}},
      [&canvas](bool) { canvas.fit(); });
  addSeparator(canvas, menu);
  add(canvas, menu,
      {"steeper",
       ViewActionText::tr("More vertical exaggeration"),
       ViewActionText::tr("Also Ctrl and the wheel"),
       {Qt::SHIFT | Qt::Key_Up}},
      [&canvas](bool) { canvas.exaggerate(1); });
  add(canvas, menu,
      {"flatter",
       ViewActionText::tr("Less vertical exaggeration"),
       ViewActionText::tr("Also Ctrl and the wheel"),
       {Qt::SHIFT | Qt::Key_Down}},
      [&canvas](bool) { canvas.exaggerate(-1); });
  add(canvas, menu,
      {"fitHeights",
       ViewActionText::tr("Fit heights"),
       ViewActionText::tr("The exaggeration that shows all heights"),
       {Qt::Key_H}},
      [&canvas](bool) { canvas.fitHeights(); });
}

/// What can be switched on and off; the check marks follow the canvas.
void addSwitches(ContactCanvas& canvas, QMenu& menu) {
  QAction* follow =
      add(canvas, menu,
          {"followLine",
           ViewActionText::tr("Follow the line"),
           ViewActionText::tr("The line stands still in the picture and the elastomer passes by"),
           {Qt::Key_L}},
          [&canvas](bool on) { canvas.follow(on); });
  QAction* magnify =
      add(canvas, menu,
          {"magnify",
           ViewActionText::tr("Magnifier"),
           ViewActionText::tr("Enlarges the asperity at the crosshair, or the one pressed most"),
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
  const std::array<std::tuple<ContactOverlay, QString, QString>, 4> choices{{
      {ContactOverlay::Pressure, ViewActionText::tr("Contact pressure"),
       ViewActionText::tr("Where the bodies press on each other")},
      {ContactOverlay::Relaxation, ViewActionText::tr("Time since contact"),
       ViewActionText::tr("How long the free surface has had to come back")},
      {ContactOverlay::Power, ViewActionText::tr("Dissipated power"),
       ViewActionText::tr(
           "Where friction turns into heat: in contact and where the surface comes back")},
      {ContactOverlay::None, ViewActionText::tr("Nothing"), {}},
  }};
  auto* colours = new QMenu(ViewActionText::tr("Colours show"), &menu);
  colours->setObjectName("overlayMenu");
  colours->setToolTipsVisible(true);
  auto* group = new QActionGroup(&canvas);
  for (const auto& [overlay, text, tip] : choices) {
    auto* action = new QAction(text, group);
    action->setToolTip(tip.isEmpty() ? text : tip);
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
  add(canvas, menu,
      {"nextOverlay",
       ViewActionText::tr("Next colours"),
       ViewActionText::tr("Goes through what colours can show"),
       {Qt::Key_C}},
      [&canvas, group](bool) {
        const QList<QAction*> all = group->actions();
        const auto now = all.indexOf(group->checkedAction());
        all[(now + 1) % all.size()]->trigger();
      });
}

}  // namespace

void addContactViewActions(ContactCanvas& canvas, QMenu& menu) {
  addZoom(canvas, menu);
  addSeparator(canvas, menu);
  addSwitches(canvas, menu);
  addSeparator(canvas, menu);
  addColours(canvas, menu);
}

}  // namespace asperity
