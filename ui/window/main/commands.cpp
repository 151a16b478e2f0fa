#include "ui/window/main/commands.h"

#include <QMainWindow>
#include <QMenu>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <utility>

#include "ui/language/language.h"
#include "ui/panels/controls.h"

namespace asperity {

void explainEmpty(QMenu& menu, const QString& reason) {
  if (menu.isEmpty()) menu.addAction(reason)->setEnabled(false);
}

QString buttonText(QString text) {
  return text.remove(u'…').trimmed();
}

Commands::Commands(QMainWindow& window) : QObject(&window), window_(window) {
  keepTranslated(*this, [this] {
    for (const auto& [name, entry] : entries_) showText(entry);
  });
}

QAction* Commands::add(Command command) {
  auto* action = named<QAction>(QString::fromStdString(command.name), this);
  action->setShortcuts(command.keys);
  action->setIconVisibleInMenu(false);
  connect(action, &QAction::triggered, this, [run = command.run] { run(); });
  window_.addAction(action);
  const std::string name = command.name;
  const auto& entry = entries_.insert_or_assign(name, Entry{action, std::move(command), {}}).first;
  showText(entry->second);
  return action;
}

QAction* Commands::get(const std::string& name) const {
  return entries_.at(name).action;
}

QList<QAction*> Commands::get(std::initializer_list<const char*> names) const {
  QList<QAction*> actions;
  for (const char* name : names) actions += get(name);
  return actions;
}

void Commands::refresh(const std::string& name) {
  showText(entries_.at(name));
}

void Commands::setTip(const std::string& name, std::function<QString()> tip) {
  entries_.at(name).tip = std::move(tip);
  refresh(name);
}

void Commands::setSymbol(const std::string& name, Symbol symbol) {
  Entry& entry = entries_.at(name);
  entry.command.symbol = symbol;
  paint(entry);
}

void Commands::setColour(const QColor& colour) {
  colour_ = colour;
  for (const auto& [name, entry] : entries_) paint(entry);
}

/// Sets the text of menu, button and tooltip; the tooltip also names the key.
void Commands::showText(const Entry& entry) const {
  QAction& action = *entry.action;
  const QString text = entry.command.text();
  const QString key = action.shortcut().toString(QKeySequence::NativeText);
  action.setText(text);
  action.setIconText(buttonText(entry.command.button ? entry.command.button() : text));
  const QString tip = entry.tip ? entry.tip() : text;
  action.setToolTip(key.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, key));
}

void Commands::paint(const Entry& entry) const {
  if (entry.command.symbol == Symbol::None || !colour_.isValid()) return;
  entry.action->setIcon(symbolIcon(entry.command.symbol, colour_));
}

// ---- Icons

namespace {

constexpr int kSize = 20;  // all symbols are drawn in a square of this side

QPainterPath triangle(double left, double right) {
  QPainterPath path;
  path.moveTo(left, 4);
  path.lineTo(right, 10);
  path.lineTo(left, 16);
  path.closeSubpath();
  return path;
}

void fill(QPainter& painter, const QPainterPath& path) {
  painter.fillPath(path, painter.pen().color());
}

void drawReset(QPainter& painter) {
  painter.drawArc(QRectF(4, 4, 12, 12), 60 * 16, 290 * 16);
  QPainterPath head;  // at the arc's upper end
  head.moveTo(9.2, 1.6);
  head.lineTo(14.4, 4.6);
  head.lineTo(9.8, 8.2);
  head.closeSubpath();
  fill(painter, head);
}

void drawOpen(QPainter& painter) {
  QPainterPath folder;
  folder.moveTo(3, 16);
  folder.lineTo(3, 4.5);
  folder.lineTo(8, 4.5);
  folder.lineTo(10, 6.8);
  folder.lineTo(17, 6.8);
  folder.lineTo(17, 16);
  folder.closeSubpath();
  painter.drawPath(folder);
}

void drawSave(QPainter& painter) {
  painter.drawLine(QPointF(10, 3), QPointF(10, 12));
  painter.drawPolyline(QPolygonF{{6, 8.4}, {10, 12.4}, {14, 8.4}});
  painter.drawPolyline(QPolygonF{{3.5, 12.5}, {3.5, 16.5}, {16.5, 16.5}, {16.5, 12.5}});
}

/// Draws an arrow that turns back to the left.
void drawUndo(QPainter& painter) {
  painter.drawPolyline(QPolygonF{{7.5, 3.5}, {3.8, 7.2}, {7.5, 10.9}});
  QPainterPath path;
  path.moveTo(4.2, 7.2);
  path.lineTo(12, 7.2);
  path.cubicTo(18, 7.2, 18, 15.8, 12, 15.8);
  path.lineTo(8, 15.8);
  painter.drawPath(path);
}

void drawRedo(QPainter& painter) {
  painter.translate(kSize, 0);
  painter.scale(-1, 1);
  drawUndo(painter);
}

void drawScenes(QPainter& painter) {
  for (const double y : {5.0, 10.0, 15.0}) {
    painter.drawLine(QPointF(8, y), QPointF(17, y));
    painter.drawEllipse(QPointF(4, y), 0.6, 0.6);
  }
}

void drawFigures(QPainter& painter) {
  painter.drawPolyline(QPolygonF{{3.5, 3}, {3.5, 16.5}, {17, 16.5}});
  QPainterPath curve;
  curve.moveTo(5.5, 13.5);
  curve.cubicTo(9, 13, 9, 5.5, 12, 5.5);
  curve.cubicTo(14, 5.5, 14.5, 8, 16.5, 10);
  painter.drawPath(curve);
}

void drawLight(QPainter& painter) {
  painter.drawEllipse(QPointF(10, 10), 6.5, 6.5);
  QPainterPath half;
  half.moveTo(10, 3.5);
  half.arcTo(QRectF(3.5, 3.5, 13, 13), 90, -180);
  half.closeSubpath();
  fill(painter, half);
}

void draw(QPainter& painter, Symbol symbol) {
  switch (symbol) {
    case Symbol::Play:
      return fill(painter, triangle(5, 16.5));
    case Symbol::Pause:
      painter.fillRect(QRectF(5, 4, 3.6, 12), painter.pen().color());
      return painter.fillRect(QRectF(11.4, 4, 3.6, 12), painter.pen().color());
    case Symbol::Step:
      fill(painter, triangle(4, 13));
      return painter.fillRect(QRectF(13.6, 4, 2.4, 12), painter.pen().color());
    case Symbol::Reset:
      return drawReset(painter);
    case Symbol::Scenes:
      return drawScenes(painter);
    case Symbol::Figures:
      return drawFigures(painter);
    case Symbol::Open:
      return drawOpen(painter);
    case Symbol::Save:
      return drawSave(painter);
    case Symbol::Undo:
      return drawUndo(painter);
    case Symbol::Redo:
      return drawRedo(painter);
    case Symbol::Light:
      return drawLight(painter);
    case Symbol::None:
      return;
  }
}

QPixmap pixmap(Symbol symbol, const QColor& colour, int density) {
  QPixmap image(kSize * density, kSize * density);
  image.setDevicePixelRatio(density);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colour, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  draw(painter, symbol);
  return image;
}

}  // namespace

QIcon symbolIcon(Symbol symbol, const QColor& colour) {
  QIcon icon;
  for (const int density : {1, 2, 3}) {
    icon.addPixmap(pixmap(symbol, colour, density));
    QColor faint = colour;
    faint.setAlphaF(0.35F);
    icon.addPixmap(pixmap(symbol, faint, density), QIcon::Disabled);
  }
  return icon;
}

}  // namespace asperity
