#include "tests/ui/window/window_in.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QRegularExpression>
#include <QTabBar>
#include <QTreeWidget>

namespace asperity {

namespace {

QString plain(QString text) {
  static const QRegularExpression tag(QStringLiteral("<[^>]*>"));
  return text.remove(tag).remove(u'&');
}

Texts itemsOf(const QAbstractItemModel& model) {
  Texts texts;
  for (int column = 0; column < model.columnCount(); ++column) {
    texts.insert(model.headerData(column, Qt::Horizontal).toString().toStdString());
    for (int row = 0; row < model.rowCount(); ++row)
      for (const int role :
           {int(Qt::DisplayRole), int(Qt::ToolTipRole), int(Qt::AccessibleTextRole)})
        texts.insert(plain(model.index(row, column).data(role).toString()).toStdString());
  }
  return texts;
}

/// Words of both languages, names, keys of the table (which are no words), paths.
bool isTheSame(const std::string& text) {
  static const QRegularExpression word(QStringLiteral("[A-Za-z]{4}"));
  static const QRegularExpression key(QStringLiteral("^[a-z_]+\\.[a-z0-9_.]+$|^:|^/"));
  static const std::set<QString> words{"Asperity",
                                       "English",
                                       "Deutsch",
                                       "OpenGL",
                                       "Elastomer",
                                       QStringLiteral("Roll-off λᵣ (m)"),
                                       "Plan",
                                       "Parameter",
                                       "linear",
                                       "nodal",
                                       "Radius",
                                       "Kelvin",
                                       "Prony",
                                       "EPDM 70",
                                       "Gwyddion",
                                       "NumPy",
                                       "Zygo",
                                       "Arrhenius",
                                       "Matrix",
                                       "Material",
                                       "Pause",
                                       "Software",
                                       "software",
                                       "title",
                                       "small",
                                       "small – Asperity",
                                       "small[*] – Asperity"};
  const QString whole = QString::fromStdString(text).trimmed();
  return !word.match(whole).hasMatch() || findParameter(text) || key.match(whole).hasMatch() ||
         words.contains(whole);
}

/// Why a visible widget does not show all of its text; empty where it does.
std::string cutOff(const QWidget& widget) {
  const auto say = [&](const QString& text, QSize needed) {
    return (text + QStringLiteral(" needs %1 x %2, has %3 x %4")
                       .arg(needed.width())
                       .arg(needed.height())
                       .arg(widget.width())
                       .arg(widget.height()))
        .toStdString();
  };
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
    if (label->text().isEmpty()) return {};
    if (label->wordWrap()) {
      const int height = label->heightForWidth(label->width());
      return height > label->height() ? say(label->text(), {label->width(), height}) : "";
    }
    return label->sizeHint().width() > label->width() ? say(label->text(), label->sizeHint()) : "";
  }
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))  // a sign may be tight
    if (button->sizeHint().width() > button->width() && button->text().size() > 1)
      return say(button->text(), button->sizeHint());
  if (const auto* box = qobject_cast<const QComboBox*>(&widget))
    if (box->sizeHint().width() > box->width()) return say(box->currentText(), box->sizeHint());
  return {};
}

}  // namespace

Texts textsOf(const MainWindow& window) {
  Texts texts{window.windowTitle().toStdString()};
  const auto add = [&](const QString& text) { texts.insert(plain(text).toStdString()); };
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    add(widget->toolTip());
    add(widget->accessibleName());
    add(widget->accessibleDescription());
    if (const auto* label = qobject_cast<const QLabel*>(widget)) add(label->text());
    if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) add(button->text());
    if (const auto* menu = qobject_cast<const QMenu*>(widget)) add(menu->title());
    if (const auto* entry = qobject_cast<const QLineEdit*>(widget)) add(entry->placeholderText());
    if (const auto* box = qobject_cast<const QComboBox*>(widget))
      texts.merge(itemsOf(*box->model()));
    if (const auto* view = qobject_cast<const QAbstractItemView*>(widget))
      if (view->model()) texts.merge(itemsOf(*view->model()));
    if (const auto* tabs = qobject_cast<const QTabBar*>(widget))
      for (int i = 0; i < tabs->count(); ++i) add(tabs->tabText(i));
  }
  for (const QAction* action : window.findChildren<QAction*>()) {
    add(action->text());
    add(action->toolTip());
  }
  return texts;
}
Texts leftOver(const Texts& shown, const Texts& other) {
  Texts left;
  for (const std::string& text : shown)
    if (other.contains(text) && !isTheSame(text)) left.insert(text);
  return left;
}

ContactPictureOptions shownOptions(const ContactCanvas& canvas) {
  ContactPictureOptions options = canvas.viewer().options();
  options.width = canvas.width();
  options.height = canvas.height();
  return options;
}

QPoint middleOf(const Box& place) {
  return QPointF(place.x + 0.5 * place.width, place.y + 0.5 * place.height).toPoint();
}

std::optional<QPoint> handleIn(const ContactCanvas& canvas, ContactHandle wanted) {
  for (const ContactSign& place : contactHandles(*canvas.frame(), shownOptions(canvas)))
    if (place.handle == wanted) return middleOf(place.box);
  return std::nullopt;
}

std::string cutOffIn(const QWidget& window) {
  static const std::set<QString> tooLong{"qt_toolbar_ext_button", "qt_menubar_ext_button"};
  std::string lines;
  const auto isWhole = [&] {
    lines.clear();
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
      if (!widget->isVisible()) continue;
      if (const std::string line = cutOff(*widget); !line.empty()) lines += line + "\n";
      if (tooLong.contains(widget->objectName())) lines += "a bar is longer than the window\n";
    }
    return lines.empty();
  };
  return QTest::qWaitFor(isWhole, 2000) ? std::string() : lines;
}

}  // namespace asperity
