#include "ui/window/shortcut_sheet.h"

#include <QAction>
#include <QGridLayout>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QSet>
#include <algorithm>
#include <iterator>

namespace asperity {

namespace {

QString plain(QString text) {
  return text.remove('&').remove(u'…');
}

/// Several keys of one command are alternatives; a command that has none has no entry.
void addEntry(ShortcutGroup& group, const QAction& action) {
  QStringList keys;
  for (const QKeySequence& key : action.shortcuts()) keys += key.toString(QKeySequence::NativeText);
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

ShortcutGroup& groupOf(QList<ShortcutGroup>& groups, const QString& title) {
  const auto found = std::ranges::find(groups, title, &ShortcutGroup::title);
  if (found != groups.end()) return *found;
  groups.append({title, {}});
  return groups.last();
}

QWidget* groupWidget(const ShortcutGroup& group) {
  auto* box = new QWidget;
  box->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 2);
  grid->setHorizontalSpacing(18);
  grid->setVerticalSpacing(4);
  auto* title = new QLabel(group.title);
  QFont bold = title->font();
  bold.setBold(true);
  title->setFont(bold);
  grid->addWidget(title, 0, 0, 1, 2);
  int row = 1;
  for (const ShortcutGroup::Entry& entry : group.entries) {
    auto* keys = new QLabel(entry.keys);
    keys->setObjectName("shortcutKeys");
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
      if (action->menu()) addMenu(groupOf(groups, plain(action->text())), *action->menu(), seen);
  for (const QAction* action : window.actions()) {
    if (seen.contains(action)) continue;
    const QString title = action->property("group").toString();
    addEntry(groupOf(groups, title.isEmpty() ? ShortcutSheet::tr("More") : title), *action);
  }
  groups.removeIf([](const ShortcutGroup& group) { return group.entries.isEmpty(); });
  return groups;
}

/// In columns of about the same height.
ShortcutSheet::ShortcutSheet(const QMainWindow& window, QWidget* parent) : QDialog(parent) {
  setObjectName("shortcutSheet");
  setWindowTitle(tr("Keyboard shortcuts"));
  const QList<ShortcutGroup> groups = shortcutGroups(window);
  qsizetype total = 0;
  for (const ShortcutGroup& group : groups) total += group.entries.size() + 2;

  content_ = new QWidget;
  auto* row = new QHBoxLayout(content_);
  row->setSpacing(40);
  QVBoxLayout* columns[] = {new QVBoxLayout, new QVBoxLayout, new QVBoxLayout};
  constexpr qsizetype kColumns = std::size(columns);
  qsizetype before = 0;
  for (const ShortcutGroup& group : groups) {
    const qsizetype middle = before + group.entries.size() / 2;
    columns[std::min(kColumns - 1, kColumns * middle / total)]->addWidget(groupWidget(group));
    before += group.entries.size() + 2;
  }
  for (QVBoxLayout* column : columns) {
    column->addStretch(1);
    row->addLayout(column);
  }
  auto* scroll = new QScrollArea;
  scroll->setWidget(content_);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setAccessibleName(windowTitle());
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(scroll);
}

/// As large as needed, once fonts and style are those of the screen.
void ShortcutSheet::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  QCoreApplication::sendPostedEvents(content_, QEvent::LayoutRequest);
  const QSize wanted = content_->minimumSizeHint().expandedTo(content_->sizeHint());
  resize((wanted + QSize(60, 60)).boundedTo(parentWidget() ? parentWidget()->size() : wanted));
}

}  // namespace asperity
