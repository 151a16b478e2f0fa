#include "tests/ui/window/readable_widgets.h"

#include <QAbstractButton>
#include <QAbstractItemModel>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QRadioButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QSet>
#include <QSizeGrip>
#include <QSplitterHandle>
#include <QStyle>
#include <QStyleOptionFrame>
#include <QTabBar>
#include <QTabWidget>
#include <QTableView>
#include <QTest>
#include <QTextDocument>
#include <QToolButton>
#include <QTreeView>
#include <algorithm>

#include "core/scene/parameters.h"
#include "ui/panels/boxes.h"
#include "ui/panels/parameter_panel.h"

namespace asperity {

namespace {

constexpr int kPatience = 1500;  // ms, until the layout has settled
constexpr int kNothing = 1;      // pixels that nobody sees
const QSize kFrame(8, 34);       // what a window manager draws around a window

/// Returns the text as it is read: without the marks of keys and of rich text.
QString plain(const QString& text) {
  QString read = text;
  if (Qt::mightBeRichText(text)) {
    QTextDocument document;
    document.setHtml(text);
    read = document.toPlainText();
  }
  static const QRegularExpression mark(QStringLiteral("&(?=[^\\s&])"));
  return read.remove(mark).replace(QChar::Nbsp, u' ').simplified();
}

QString nameOf(const QWidget& widget) {
  QString name = QString::fromLatin1(widget.metaObject()->className()).section(':', -1);
  if (!widget.objectName().isEmpty()) name += " " + widget.objectName();
  return name;
}

QString cut(const QWidget& widget, const QString& text, int needed, int room) {
  return QStringLiteral("%1: '%2' is cut off, needs %3 and has %4")
      .arg(nameOf(widget), plain(text))
      .arg(needed)
      .arg(room);
}

/// Returns whether the whole text is in the tooltip, so that it may be shortened.
bool isInTip(const QString& text, const QString& tip) {
  return !tip.isEmpty() && plain(tip).contains(plain(text));
}

/// Returns whether the widget is a part of one of Qt's controls, which lays it out itself.
bool isPart(const QWidget& widget) {
  const QWidget* parent = widget.parentWidget();
  return !parent || qobject_cast<const QAbstractScrollArea*>(parent) ||
         qobject_cast<const QComboBox*>(parent) || qobject_cast<const QAbstractSpinBox*>(parent) ||
         qobject_cast<const QLineEdit*>(parent) || qobject_cast<const QTabBar*>(parent) ||
         qobject_cast<const QHeaderView*>(parent) || qobject_cast<const QMenuBar*>(parent) ||
         widget.objectName().startsWith("qt_") || qobject_cast<const QSizeGrip*>(&widget) ||
         widget.inherits("QFocusFrame") || widget.inherits("QRubberBand");
}

// ---- Texts that are cut off
// ----------------------------------------------------------------------

void checkLabel(const QLabel& label, QStringList& faults) {
  const QString text = label.text();
  if (text.isEmpty() || isInTip(text, label.toolTip())) return;
  if (label.wordWrap()) {
    const int height = label.heightForWidth(label.width());
    if (height > label.height() + kNothing) faults += cut(label, text, height, label.height());
    const QFontMetrics metrics(label.font());
    static const QRegularExpression gap(QStringLiteral("\\s|(?<=-)"));
    for (const QString& word : plain(text).split(gap))
      if (metrics.horizontalAdvance(word) > label.width() + kNothing)
        faults += cut(label, word, metrics.horizontalAdvance(word), label.width());
    return;
  }
  const QSize needed = label.sizeHint();
  if (needed.width() > label.width() + kNothing)
    faults += cut(label, text, needed.width(), label.width());
  else if (needed.height() > label.height() + kNothing)
    faults += cut(label, text, needed.height(), label.height());
}

void checkButton(const QAbstractButton& button, QStringList& faults) {
  constexpr int kSign = 2;  // letters of a sign, which may be tight
  if (plain(button.text()).size() <= kSign || isInTip(button.text(), button.toolTip())) return;
  const auto* tool = qobject_cast<const QToolButton*>(&button);
  const bool hasIcon = !button.icon().isNull();
  if (tool && hasIcon && tool->toolButtonStyle() == Qt::ToolButtonIconOnly) return;
  const QSize needed = button.sizeHint();
  if (needed.width() > button.width() + kNothing)
    faults += cut(button, button.text(), needed.width(), button.width());
  else if (QFontMetrics(button.font()).height() > button.height() + kNothing)
    faults += cut(button, button.text(), needed.height(), button.height());
}

void checkBox(const QComboBox& box, QStringList& faults) {
  constexpr int kChoiceAround = 31, kUsualAround = 28;  // pixels beside the text
  const auto* choice = dynamic_cast<const ChoiceBox*>(&box);
  const QString text = choice ? choice->shownText() : box.currentText();
  // The folder of Qt's file dialog may have a path of any length.
  if (isInTip(text, box.toolTip()) || box.objectName() == "lookInCombo") return;
  const int needed =
      QFontMetrics(box.font()).horizontalAdvance(text) + (choice ? kChoiceAround : kUsualAround);
  if (needed > box.width() + kNothing) faults += cut(box, text, needed, box.width());
}

void checkGroup(const QGroupBox& group, QStringList& faults) {
  const int needed = QFontMetrics(group.font()).horizontalAdvance(plain(group.title()));
  if (needed > group.width()) faults += cut(group, group.title(), needed, group.width());
}

void checkTabs(const QTabBar& bar, QStringList& faults) {
  const QFontMetrics metrics(bar.font());
  for (int i = 0; i < bar.count(); ++i) {
    if (!bar.isTabVisible(i) || isInTip(bar.tabText(i), bar.tabToolTip(i))) continue;
    const QRect place = bar.tabRect(i);
    const int needed = metrics.horizontalAdvance(plain(bar.tabText(i)));
    if (needed > place.width()) faults += cut(bar, bar.tabText(i), needed, place.width());
    if (place.right() > bar.width() + kNothing)
      faults += cut(bar, bar.tabText(i), place.right(), bar.width());
  }
}

void checkEntry(const QLineEdit& entry, QStringList& faults) {
  constexpr int kMargin = 2;  // pixels that an entry keeps free on each side of its text
  QStyleOptionFrame frame;
  frame.initFrom(&entry);
  const QRect inside = entry.style()->subElementRect(QStyle::SE_LineEditContents, &frame, &entry);
  const int room = inside.width() - 2 * kMargin;
  const auto check = [&](const QString& text) {
    const int needed = QFontMetrics(entry.font()).horizontalAdvance(text);
    if (needed > room + kNothing && !isInTip(text, entry.toolTip()))
      faults += cut(entry, text, needed, room);
  };
  if (entry.text().isEmpty()) check(entry.placeholderText());
  if (qobject_cast<const QAbstractSpinBox*>(entry.parentWidget())) check(entry.text());
}

/// Sentences that do not fit into their box have a scroll bar.
void checkSentences(const QPlainTextEdit& box, QStringList& faults) {
  const QScrollBar& bar = *box.verticalScrollBar();
  if (bar.maximum() > 0 && !bar.isVisible())
    faults += nameOf(box) + " hides lines, but has no scroll bar";
}

void checkProgress(const QProgressBar& bar, QStringList& faults) {
  const int needed = QFontMetrics(bar.font()).horizontalAdvance(bar.text());
  if (bar.isTextVisible() && needed > bar.width())
    faults += cut(bar, bar.text(), needed, bar.width());
}

void checkHeader(const QHeaderView& header, QStringList& faults) {
  if (header.orientation() != Qt::Horizontal || !header.model()) return;
  const QFontMetrics metrics(header.font());
  for (int i = 0; i < header.count(); ++i) {
    if (header.isSectionHidden(i)) continue;
    const QString text = header.model()->headerData(i, Qt::Horizontal).toString();
    const QString tip = header.model()->headerData(i, Qt::Horizontal, Qt::ToolTipRole).toString();
    const int needed = metrics.horizontalAdvance(text);
    if (needed > header.sectionSize(i) && !isInTip(text, tip))
      faults += cut(header, text, needed, header.sectionSize(i));
  }
}

/// Cells that are drawn by Qt itself; a list with its own delegate wraps its texts.
void checkCells(const QAbstractItemView& view, QStringList& faults) {
  const auto* table = qobject_cast<const QTableView*>(&view);
  const auto* tree = qobject_cast<const QTreeView*>(&view);
  if ((!table && !tree) || !view.model()) return;
  constexpr int kAround = 4;  // pixels beside the text
  for (int row = 0; row < view.model()->rowCount(); ++row)
    for (int column = 0; column < view.model()->columnCount(); ++column) {
      const QModelIndex index = view.model()->index(row, column);
      const QRect place = view.visualRect(index);
      const QString text = index.data().toString();
      if (text.isEmpty() || place.isEmpty() || text.contains('\n')) continue;
      const bool hasTick = index.data(Qt::CheckStateRole).isValid();
      const QVariant font = index.data(Qt::FontRole);
      const QFontMetrics metrics(font.isValid() ? font.value<QFont>() : view.font());
      // A text that is broken into lines needs the width of its longest word.
      const bool isWrapped = place.height() > 2 * metrics.height();
      int widest = isWrapped ? 0 : metrics.horizontalAdvance(text);
      if (isWrapped)
        for (const QString& word : plain(text).split(' '))
          widest = std::max(widest, metrics.horizontalAdvance(word));
      const int needed = widest + kAround + (hasTick ? 18 : 0);
      if (needed > place.width() + kNothing &&
          !isInTip(text, index.data(Qt::ToolTipRole).toString()))
        faults += cut(view, text, needed, place.width());
    }
}

void checkText(const QWidget& widget, QStringList& faults) {
  if (const auto* label = qobject_cast<const QLabel*>(&widget))
    checkLabel(*label, faults);
  else if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
    checkButton(*button, faults);
  else if (const auto* box = qobject_cast<const QComboBox*>(&widget))
    checkBox(*box, faults);
  else if (const auto* group = qobject_cast<const QGroupBox*>(&widget))
    checkGroup(*group, faults);
  else if (const auto* tabs = qobject_cast<const QTabBar*>(&widget))
    checkTabs(*tabs, faults);
  else if (const auto* entry = qobject_cast<const QLineEdit*>(&widget))
    checkEntry(*entry, faults);
  else if (const auto* sentences = qobject_cast<const QPlainTextEdit*>(&widget))
    checkSentences(*sentences, faults);
  else if (const auto* bar = qobject_cast<const QProgressBar*>(&widget))
    checkProgress(*bar, faults);
  else if (const auto* header = qobject_cast<const QHeaderView*>(&widget))
    checkHeader(*header, faults);
  else if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget))
    checkCells(*view, faults);
}

// ---- Words

/// Returns all texts of a widget and its tooltips. Tooltips of the panel of parameters are left
/// out: they name the keys for people who write scene files.
QStringList textsOf(const QWidget& widget) {
  QStringList texts;
  const QWidget* parent = &widget;
  while (parent && !qobject_cast<const ParameterPanel*>(parent)) parent = parent->parentWidget();
  if (!parent) texts += widget.toolTip();
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) texts += label->text();
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) texts += button->text();
  const auto* box = qobject_cast<const QComboBox*>(&widget);
  const auto* view = qobject_cast<const QAbstractItemView*>(&widget);
  const QAbstractItemModel* model = box ? box->model() : view ? view->model() : nullptr;
  for (int row = 0; model && row < model->rowCount(); ++row)
    for (int column = 0; column < model->columnCount(); ++column)
      for (const int role : {Qt::DisplayRole, Qt::ToolTipRole})
        texts += model->index(row, column).data(role).toString();
  return texts;
}

/// The key of a scene file is no word for a person, who knows the control by its label.
void checkKeys(const QWidget& widget, QStringList& faults) {
  static const QRegularExpression word(QStringLiteral(R"([a-z_]+(\.[a-z0-9_]+)+)"));
  for (const QString& text : textsOf(widget))
    for (auto words = word.globalMatch(text); words.hasNext();) {
      const QString key = words.next().captured();
      if (findParameter(key.toStdString()))
        faults += QStringLiteral("%1: names the key %2 in “%3”").arg(nameOf(widget), key, text);
    }
}

// ---- Places
// --------------------------------------------------------------------------------------

/// What is scrolled out of sight can be scrolled back, but only in the directions that scroll.
void checkPosition(const QWidget& widget, QStringList& faults) {
  const QWidget* parent = widget.parentWidget();
  if (!parent || widget.isWindow() || widget.size().isEmpty()) return;
  const auto* area = qobject_cast<const QScrollArea*>(parent->parentWidget());
  const bool isScrolled = area && area->widget() == &widget;
  if (isScrolled) {
    if (area->horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff &&
        widget.width() > parent->width() + kNothing)
      faults += QStringLiteral("%1: is %2 wide in a view of %3 that does not scroll sideways")
                    .arg(nameOf(widget))
                    .arg(widget.width())
                    .arg(parent->width());
    return;
  }
  if (isPart(widget)) return;
  const QRect inside = parent->rect().adjusted(-kNothing, -kNothing, kNothing, kNothing);
  if (!inside.contains(widget.geometry()))
    faults += QStringLiteral("%1: lies beyond %2, at %3, %4 with %5 x %6 in %7 x %8")
                  .arg(nameOf(widget), nameOf(*parent))
                  .arg(widget.x())
                  .arg(widget.y())
                  .arg(widget.width())
                  .arg(widget.height())
                  .arg(parent->width())
                  .arg(parent->height());
}

/// Layers that are meant to lie over others let the mouse through.
bool canOverlap(const QWidget& widget) {
  return widget.isWindow() || !widget.isVisible() || widget.size().isEmpty() || isPart(widget) ||
         widget.testAttribute(Qt::WA_TransparentForMouseEvents) ||
         qobject_cast<const QSplitterHandle*>(&widget);
}

void checkOverlaps(const QWidget& parent, QStringList& faults) {
  QList<const QWidget*> children;
  for (const QObject* child : parent.children())
    if (const auto* widget = qobject_cast<const QWidget*>(child); widget && !canOverlap(*widget))
      children += widget;
  for (qsizetype i = 0; i < children.size(); ++i)
    for (qsizetype j = i + 1; j < children.size(); ++j) {
      const QRect shared = children[i]->geometry() & children[j]->geometry();
      if (shared.width() > kNothing && shared.height() > kNothing)
        faults += QStringLiteral("%1 and %2 overlap by %3 x %4")
                      .arg(nameOf(*children[i]), nameOf(*children[j]))
                      .arg(shared.width())
                      .arg(shared.height());
    }
}

QStringList faultsNow(QWidget& window) {
  QStringList faults;
  QList<QWidget*> widgets{&window};
  for (QWidget* widget : window.findChildren<QWidget*>())
    if (widget->isVisible() && widget->window() == window.window()) widgets += widget;
  for (const QWidget* widget : widgets) {
    checkText(*widget, faults);
    checkKeys(*widget, faults);
    checkPosition(*widget, faults);
    if (!isPart(*widget) || widget == &window) checkOverlaps(*widget, faults);
    // The rows of a scrolled form are children of what a viewport shows.
    else if (const auto* area = qobject_cast<const QScrollArea*>(widget->parentWidget()))
      if (area->widget()) checkOverlaps(*area->widget(), faults);
  }
  faults.removeDuplicates();
  return faults;
}

// ---- The Tab key
// ---------------------------------------------------------------------------------

bool takesTab(const QWidget& widget, const QWidget& window) {
  if (!widget.isVisible() || !widget.isEnabled() || widget.window() != &window || isPart(widget))
    return false;
  if (widget.focusPolicy() == Qt::NoFocus || qobject_cast<const QLabel*>(&widget)) return false;
  // One of the buttons of a group takes the focus for all of them.
  if (const auto* radio = qobject_cast<const QRadioButton*>(&widget)) return radio->isChecked();
  return (widget.focusPolicy() & Qt::TabFocus) != 0;
}

/// A button of a tool bar stands for a command of a menu.
bool needsAKey(const QAbstractButton& button, const QWidget& window) {
  static const QRegularExpression key(QStringLiteral("\\([^)]+\\)$"));
  const auto* tool = qobject_cast<const QToolButton*>(&button);
  // What stood before can be typed, too.
  if (button.objectName().startsWith("reset:")) return false;
  return button.isVisible() && button.isEnabled() && button.window() == &window &&
         !isPart(button) && button.focusPolicy() == Qt::NoFocus &&
         !(tool && tool->defaultAction()) && !button.inherits("QTableCornerButton") &&
         !key.match(button.toolTip()).hasMatch();
}

}  // namespace

/// Of a box for a choice, Qt passes on its value as its name on Linux. So its name has to be in its
/// description, unless it has a label. Qt's dialog for files has boxes of its own.
bool hasSpokenName(QWidget& widget) {
  const QAccessibleInterface* spoken = QAccessible::queryAccessibleInterface(&widget);
  if (!spoken || spoken->text(QAccessible::Name).isEmpty()) return false;
  if (!dynamic_cast<ChoiceBox*>(&widget)) return true;
  const QString name = widget.accessibleName();
  return !spoken->relations(QAccessible::Label).isEmpty() ||
         (!name.isEmpty() && spoken->text(QAccessible::Description).startsWith(name));
}

QStringList readingFaults(QWidget& window) {
  QStringList faults;
  (void)QTest::qWaitFor(
      [&] {
        faults = faultsNow(window);
        return faults.isEmpty();
      },
      kPatience);
  return faults;
}

QStringList tabFaults(QWidget& window) {
  constexpr int kMax = 600;  // more than any window has controls
  window.activateWindow();
  if (!QTest::qWaitForWindowActive(&window)) return {"the window does not become active"};
  QStringList faults;
  QSet<QWidget*> reached;
  for (int i = 0; i < kMax; ++i) {
    QWidget* before = QApplication::focusWidget();
    if (before) {
      if (reached.contains(before) && i > 0 && reached.size() > 1) break;
      reached += before;
    }
    QTest::keyClick(before ? before : &window, Qt::Key_Tab);
    if (before && QApplication::focusWidget() == before) {
      if (i > 0) faults += nameOf(*before) + ": keeps the Tab key";
      break;
    }
  }
  for (QWidget* widget : reached)
    if (!hasSpokenName(*widget)) faults += nameOf(*widget) + ": has no name for screen readers";
  for (QWidget* widget : window.findChildren<QWidget*>())
    if (takesTab(*widget, window) && !reached.contains(widget))
      faults += nameOf(*widget) + ": is not reached by the Tab key";
  for (const QAbstractButton* button : window.findChildren<QAbstractButton*>())
    if (needsAKey(*button, window))
      faults += nameOf(*button) + ": takes no key, and its tooltip names none";
  return faults;
}

QStringList sizeFaults(const QWidget& window, QSize screen) {
  const QSize all = window.size() + kFrame;
  if (all.width() <= screen.width() && all.height() <= screen.height()) return {};
  return {QStringLiteral("%1: is %2 x %3 with its frame, the screen %4 x %5")
              .arg(nameOf(window))
              .arg(all.width())
              .arg(all.height())
              .arg(screen.width())
              .arg(screen.height())};
}

}  // namespace asperity
