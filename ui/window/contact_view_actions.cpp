#include "ui/window/contact_view_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>
#include <array>
#include <functional>

#include "ui/window/contact_canvas.h"

namespace asperity {

namespace {

/// In one context for translations.
QString tr(const char* text) {
  return QCoreApplication::translate("ContactViewActions", text);
}

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
       tr("Zoom in"),
       tr("At the crosshair, or in the middle; also the wheel"),
       {Qt::Key_Plus, Qt::Key_Equal, QKeySequence(QKeySequence::ZoomIn)}},
      [&canvas](bool) { canvas.zoom(1); });
  add(canvas, menu,
      {"zoomOut",
       tr("Zoom out"),
       tr("Also the wheel"),
       {Qt::Key_Minus, QKeySequence(QKeySequence::ZoomOut)}},
      [&canvas](bool) { canvas.zoom(-1); });
  add(canvas, menu,
      {"zoomFit",
       tr("Show all"),
       tr("The whole period, heights fitted; also a double click"),
       {Qt::Key_0, Qt::Key_F, Qt::Key_Home}},
      [&canvas](bool) { canvas.fit(); });
  addSeparator(canvas, menu);
  add(canvas, menu,
      {"steeper",
       tr("More vertical exaggeration"),
       tr("Also Ctrl and the wheel"),
       {Qt::SHIFT | Qt::Key_Up}},
      [&canvas](bool) { canvas.exaggerate(1); });
  add(canvas, menu,
      {"flatter",
       tr("Less vertical exaggeration"),
       tr("Also Ctrl and the wheel"),
       {Qt::SHIFT | Qt::Key_Down}},
      [&canvas](bool) { canvas.exaggerate(-1); });
  add(canvas, menu,
      {"fitHeights", tr("Fit heights"), tr("The exaggeration that shows all heights"), {Qt::Key_H}},
      [&canvas](bool) { canvas.fitHeights(); });
}

/// What can be switched on and off; the check marks follow the canvas.
void addSwitches(ContactCanvas& canvas, QMenu& menu) {
  QAction* follow = add(canvas, menu,
                        {"followLine",
                         tr("Follow the line"),
                         tr("The line stands still in the picture and the elastomer passes by"),
                         {Qt::Key_L}},
                        [&canvas](bool on) { canvas.follow(on); });
  QAction* magnify = add(canvas, menu,
                         {"magnify",
                          tr("Magnifier"),
                          tr("Enlarges the asperity at the crosshair, or the one pressed most"),
                          {Qt::Key_M}},
                         [&canvas](bool on) { canvas.magnify(on); });
  for (QAction* action : {follow, magnify}) action->setCheckable(true);
  QObject::connect(&canvas, &ContactCanvas::viewChanged, follow, [&canvas, follow, magnify] {
    follow->setChecked(canvas.viewer().navigation().followsLine());
    magnify->setChecked(canvas.viewer().magnifies());
  });
}

void addColours(ContactCanvas& canvas, QMenu& menu) {
  const std::array<std::tuple<ContactOverlay, QString, QString>, 4> choices{{
      {ContactOverlay::Pressure, tr("Contact pressure"),
       tr("Where the bodies press on each other")},
      {ContactOverlay::Relaxation, tr("Time since contact"),
       tr("How long the free surface has had to come back")},
      {ContactOverlay::Power, tr("Dissipated power"),
       tr("Where friction turns into heat: in contact and where the surface comes back")},
      {ContactOverlay::None, tr("Nothing"), {}},
  }};
  auto* colours = new QMenu(tr("Colours show"), &menu);
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
      {"nextOverlay", tr("Next colours"), tr("Goes through what colours can show"), {Qt::Key_C}},
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
