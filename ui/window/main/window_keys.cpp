#include "ui/window/main/window_keys.h"

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMainWindow>
#include <QMap>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSet>
#include <QToolButton>
#include <algorithm>
#include <iterator>
#include <vector>

#include "ui/chart/chart_view.h"
#include "ui/panels/controls.h"
#include "ui/panels/labels.h"
#include "ui/window/lesson/prediction_point.h"
#include "ui/window/main/window_layout.h"
#include "ui/window/map/map_view.h"

namespace asperity {

// ---- Letters of menu entries

namespace {

const QChar kAnd = u'\x1';  // stands for "&&"

QString withoutMarks(QString text) {
  return text.replace(QStringLiteral("&&"), kAnd).remove(u'&');
}

/// Returns whether keyboards have the letter or digit, unlike that of a symbol such as "λᵣ".
bool isTyped(QChar letter) {
  constexpr char16_t kAfterLatin = 0x250;
  return letter.isLetterOrNumber() && letter.unicode() < kAfterLatin;
}

/// Returns the positions of letters and digits, those at the beginning of a word first.
std::vector<qsizetype> letterPositions(const QString& text) {
  std::vector<qsizetype> first, others;
  for (qsizetype i = 0; i < text.size(); ++i)
    if (isTyped(text[i])) (i == 0 || text[i - 1].isSpace() ? first : others).push_back(i);
  first.insert(first.end(), others.begin(), others.end());
  return first;
}

/// Assigns letters to entries: a matching of entries and letters, which grows by augmenting paths.
/// An earlier entry moves to another of its letters where that frees one for a later entry.
class MnemonicLetters {
 public:
  explicit MnemonicLetters(const QStringList& texts) : texts_(texts) {}

  /// Gives the entry a letter, if there is one.
  void assign(int entry) {
    QSet<QChar> visited;
    tryAssign(entry, visited);
  }

  /// Returns the position of the entry's letter in its text; -1 where it has none.
  qsizetype markPosition(int entry) const {
    for (const qsizetype position : letterPositions(texts_[entry]))
      if (owners_.value(letter(entry, position), -1) == entry) return position;
    return -1;
  }

 private:
  QChar letter(int entry, qsizetype position) const { return texts_[entry][position].toLower(); }

  bool tryAssign(int entry, QSet<QChar>& visited) {
    const std::vector<qsizetype> positions = letterPositions(texts_[entry]);
    for (const qsizetype position : positions) {
      if (owners_.contains(letter(entry, position))) continue;
      owners_[letter(entry, position)] = entry;
      return true;
    }
    for (const qsizetype position : positions) {
      const QChar requested = letter(entry, position);
      if (visited.contains(requested)) continue;
      visited += requested;
      if (!tryAssign(owners_[requested], visited)) continue;
      owners_[requested] = entry;
      return true;
    }
    return false;
  }

  const QStringList& texts_;
  QMap<QChar, int> owners_;
};

}  // namespace

QStringList withMnemonics(const QStringList& texts) {
  QStringList marked;
  for (const QString& text : texts) marked += withoutMarks(text);
  MnemonicLetters letters(marked);
  for (int i = 0; i < marked.size(); ++i) letters.assign(i);
  QList<qsizetype> positions;
  for (int i = 0; i < marked.size(); ++i) positions += letters.markPosition(i);
  for (int i = 0; i < marked.size(); ++i) {
    if (positions[i] >= 0) marked[i].insert(positions[i], u'&');
    marked[i].replace(kAnd, QStringLiteral("&&"));
  }
  return marked;
}

void keepMnemonics(QMenu& menu) {
  QObject::connect(&menu, &QMenu::aboutToShow, &menu, [&menu] {
    QList<QAction*> entries;
    QStringList texts;
    for (QAction* action : menu.actions()) {
      if (action->isSeparator() || !action->isVisible()) continue;
      entries += action;
      texts += action->text();
    }
    const QStringList marked = withMnemonics(texts);
    for (qsizetype i = 0; i < entries.size(); ++i) entries[i]->setText(marked[i]);
  });
}

// ---- The list of shortcuts

namespace {

constexpr int kAround = 40;           // pixels around the groups, including a scroll bar
constexpr double kMinLetters = 0.85;  // below this factor of the usual size letters get no smaller
constexpr double kSmaller = 0.97;     // factor of one step
constexpr qsizetype kMostColumns = 3;

QString plain(QString text) {
  return text.remove('&').remove(u'…');
}

/// Adds an entry with the keys of a command, each of which runs it; a command without keys has no
/// entry. The standard keys of some desktops are empty.
void addEntry(ShortcutGroup& group, const QAction& action) {
  QStringList keys;
  for (const QKeySequence& key : action.shortcuts())
    if (!key.isEmpty()) keys += key.toString(QKeySequence::NativeText);
  const QString text = action.property("shortText").toString();
  if (!keys.isEmpty())
    group.entries +=
        {text.isEmpty() ? plain(action.text()) : text, keys.join(ShortcutSheet::tr(" or "))};
}

void addMenu(ShortcutGroup& group, const QMenu& menu, QSet<const QAction*>& seen) {
  for (const QAction* action : menu.actions()) {
    if (action->menu()) {
      addMenu(group, *action->menu(), seen);
    } else if (!seen.contains(action)) {
      seen += action;
      addEntry(group, *action);
    }
  }
}

ShortcutGroup& findOrAddGroup(QList<ShortcutGroup>& groups, const QString& title) {
  const auto found = std::ranges::find(groups, title, &ShortcutGroup::title);
  if (found != groups.end()) return *found;
  groups.append({title, {}});
  return groups.last();
}

/// Puts alternative keys below each other where they would make the whole list wider.
QString inShortLines(QString keys) {
  constexpr int kLongest = 30;  // letters
  const QString separator = ShortcutSheet::tr(" or ");
  return keys.size() > kLongest ? keys.replace(separator, separator + u'\n') : keys;
}

QWidget* groupWidget(const ShortcutGroup& group) {
  auto* box = new QWidget;
  box->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 2);
  grid->setHorizontalSpacing(18);
  grid->setVerticalSpacing(2);
  auto* title = new QLabel(group.title);
  title->setFont(boldFont(title->font()));
  grid->addWidget(title, 0, 0, 1, 2);
  int row = 1;
  for (const ShortcutGroup::Entry& entry : group.entries) {
    auto* keys = named<QLabel>("shortcutKeys", inShortLines(entry.keys));
    grid->addWidget(keys, row, 0, Qt::AlignLeft);
    grid->addWidget(new QLabel(entry.text), row++, 1);
  }
  grid->setColumnMinimumWidth(0, 9 * box->fontMetrics().averageCharWidth());
  grid->setColumnStretch(1, 1);
  return box;
}

}  // namespace

QList<ShortcutGroup> shortcutGroups(const QMainWindow& window) {
  QList<ShortcutGroup> groups;
  QSet<const QAction*> seen;
  if (const auto* bar = qobject_cast<const QMenuBar*>(window.menuWidget()))
    for (const QAction* action : bar->actions())
      if (action->menu())
        addMenu(findOrAddGroup(groups, plain(action->text())), *action->menu(), seen);
  for (const QAction* action : window.actions()) {
    if (seen.contains(action)) continue;
    const QString title = action->property("group").toString();
    addEntry(findOrAddGroup(groups, title.isEmpty() ? ShortcutSheet::tr("More") : title), *action);
  }
  groups.removeIf([](const ShortcutGroup& group) { return group.entries.isEmpty(); });
  return groups;
}

QList<ShortcutGroup> gestureGroups() {
  return {{ShortcutSheet::tr("Contact: mouse and touch"),
           {{ShortcutSheet::tr("Zoom at the pointer"), ShortcutSheet::tr("Wheel or pinch")},
            {ShortcutSheet::tr("Vertical exaggeration"), ShortcutSheet::tr("Ctrl+Wheel")},
            {ShortcutSheet::tr("Move along the line"), ShortcutSheet::tr("Shift+Wheel")},
            {ShortcutSheet::tr("Move the view"), ShortcutSheet::tr("Drag or arrow keys")},
            {ShortcutSheet::tr("Press harder or less"),
             ShortcutSheet::tr("Drag the body or its arrow up or down")},
            {ShortcutSheet::tr("Slide faster or slower"),
             ShortcutSheet::tr("Drag the arrow of the velocity")},
            {ShortcutSheet::tr("Move the crosshair"), ShortcutSheet::tr("Ctrl+← or →")},
            {ShortcutSheet::tr("Show all"), ShortcutSheet::tr("Double click")}}},
          {ShortcutSheet::tr("Curve: mouse and touch"),
           {{ShortcutSheet::tr("Zoom, over an axis along it"), ShortcutSheet::tr("Wheel")},
            {ShortcutSheet::tr("Move curve or marker"), ShortcutSheet::tr("Drag")},
            {ShortcutSheet::tr("Slower or faster"), ShortcutSheet::tr("← or →")},
            {ShortcutSheet::tr("Velocity of a point"), ShortcutSheet::tr("Click")},
            {ShortcutSheet::tr("Fit axes"), ShortcutSheet::tr("Double click")}}}};
}

namespace {

/// Returns the number of lines of a group, with its title and the gap below it.
qsizetype lineCount(const ShortcutGroup& group) {
  return group.entries.size() + 2;
}

/// Puts the groups below each other in columns of at most `maxLines` lines. Returns the number of
/// columns, and in `columnIndices` the column of each group.
qsizetype assignColumns(qsizetype maxLines, const QList<ShortcutGroup>& groups,
                        QList<qsizetype>& columnIndices) {
  columnIndices.clear();
  qsizetype column = 0, lines = 0;
  for (const ShortcutGroup& group : groups) {
    if (lines > 0 && lines + lineCount(group) > maxLines) {
      ++column;
      lines = 0;
    }
    lines += lineCount(group);
    columnIndices += column;
  }
  return column + 1;
}

}  // namespace

ShortcutSheet::ShortcutSheet(const QMainWindow& window, QWidget* parent) : QDialog(parent) {
  setObjectName("shortcutSheet");
  setWindowTitle(tr("Keyboard shortcuts"));
  groups_ = shortcutGroups(window) + gestureGroups();
  content_ = new QWidget;
  for (const ShortcutGroup& group : groups_) widgets_ += groupWidget(group);
  arrange(kMostColumns);
  auto* scroll = scrolled(content_);
  scroll->setAccessibleName(windowTitle());
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(scroll);
}

/// Distributes the groups over columns so that the longest column is as short as possible.
void ShortcutSheet::arrange(qsizetype columns) {
  delete content_->layout();
  auto* row = new QHBoxLayout(content_);
  row->setSpacing(18);
  QList<qsizetype> columnIndices;
  qsizetype maxLines = 1;
  while (assignColumns(maxLines, groups_, columnIndices) > columns) ++maxLines;
  for (qsizetype column = 0; column < columns; ++column) {
    auto* box = new QVBoxLayout;
    box->setSpacing(12);  // otherwise it takes the spacing of the row
    row->addLayout(box);
    for (qsizetype i = 0; i < groups_.size(); ++i)
      if (columnIndices[i] == column) box->addWidget(widgets_[i]);
    box->addStretch(1);
  }
}

QSize ShortcutSheet::neededSize() const {
  // Layouts keep the sizes of before a change of letters until they get their events.
  for (QWidget* group : widgets_) group->layout()->invalidate();
  content_->layout()->invalidate();
  return content_->minimumSizeHint().expandedTo(content_->sizeHint()) + QSize(kAround, kAround);
}

void ShortcutSheet::scaleLetters(double factor) {
  for (QLabel* label : content_->findChildren<QLabel*>()) {
    QFont font = label->font();  // with a style sheet it differs from the list's font
    font.setPointSizeF(factor * font.pointSizeF());
    label->setFont(font);
  }
}

/// Makes the list as large as needed, once fonts and style are those of the screen. Where it would
/// be larger than the window, its letters become smaller; where that is not enough, they are as
/// usual, in fewer columns that scroll.
void ShortcutSheet::showEvent(QShowEvent* event) {
  const QSize available = parentWidget() ? parentWidget()->size() - kWindowFrame : neededSize();
  const auto fits = [&](bool mayScroll) {
    const QSize size = neededSize();
    return size.width() <= available.width() && (mayScroll || size.height() <= available.height());
  };
  double scale = 1;
  for (; !fits(false) && scale > kMinLetters; scale *= kSmaller) scaleLetters(kSmaller);
  if (!fits(false)) scaleLetters(1 / scale);
  for (qsizetype columns = kMostColumns; !fits(true) && columns > 1;) arrange(--columns);
  resize(neededSize().boundedTo(available));
  QDialog::showEvent(event);  // puts it over the middle of the window
}

// ---- Keys of the control that has the focus

namespace {

bool isSpace(int key) {
  return key == Qt::Key_Space || key == Qt::Key_Select;
}

/// Returns whether a key goes to an end of a slider or a list. The page keys do not count, because
/// a presenter's remote control sends them to the tour.
bool isEnd(int key) {
  return key == Qt::Key_Home || key == Qt::Key_End;
}

bool isArrow(int key) {
  return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
}

/// Returns whether a control handles a key that is also a shortcut of the window.
bool needs(const QWidget& widget, const QKeyEvent& event) {
  const Qt::KeyboardModifiers modifiers = event.modifiers() & ~Qt::KeypadModifier;
  const int key = event.key();
  if (modifiers == Qt::ShiftModifier && isArrow(key))
    return qobject_cast<const QAbstractSlider*>(&widget) ||
           qobject_cast<const PredictionPoint*>(&widget) || qobject_cast<const MapView*>(&widget);
  if (modifiers != Qt::NoModifier) return false;
  if (qobject_cast<const QAbstractButton*>(&widget)) return isSpace(key);
  if (qobject_cast<const QComboBox*>(&widget)) return isSpace(key) || isEnd(key);
  if (qobject_cast<const QAbstractSlider*>(&widget) ||
      qobject_cast<const QAbstractItemView*>(&widget))
    return isEnd(key);
  return qobject_cast<const ChartView*>(&widget) && key == Qt::Key_Home;
}

bool isReturn(const QKeyEvent& event) {
  const bool isPlain = (event.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
  return isPlain && isReturnKey(event);
}

/// Clicks a push or tool button, or opens its menu. Returns whether the widget is such a button.
bool press(QWidget& widget) {
  auto* tool = qobject_cast<QToolButton*>(&widget);
  auto* button = qobject_cast<QPushButton*>(&widget);
  if (tool && tool->isEnabled() && tool->popupMode() == QToolButton::InstantPopup && tool->menu())
    tool->showMenu();
  else if (tool)
    tool->click();
  else if (button)
    button->click();
  return tool || button;
}

}  // namespace

FocusKeys::FocusKeys(QWidget& window) : QObject(&window), window_(window) {
  QApplication::instance()->installEventFilter(this);
}

bool FocusKeys::eventFilter(QObject* watched, QEvent* event) {
  const bool isOffer = event->type() == QEvent::ShortcutOverride;
  if (!isOffer && event->type() != QEvent::KeyPress) return false;
  auto* widget = qobject_cast<QWidget*>(watched);
  if (!widget || widget->window() != &window_) return false;
  const auto& key = *static_cast<QKeyEvent*>(event);
  // With Alt an arrow leads through the tour; at its end it must not move a slider.
  const bool isIdle = !isOffer && key.modifiers() & Qt::AltModifier && isArrow(key.key()) &&
                      qobject_cast<QAbstractSlider*>(widget);
  if (isIdle) return true;
  if (!isOffer) return isReturn(key) && press(*widget);
  if (!needs(*widget, key)) return false;
  event->accept();  // the key is the control's
  return true;
}

bool pressByReturn(const QDialog& dialog, QKeyEvent& event) {
  if (!isReturnKey(event)) return false;
  event.accept();
  if (auto* button = qobject_cast<QAbstractButton*>(dialog.focusWidget())) button->click();
  return true;
}

}  // namespace asperity
