#include "ui/panels/controls.h"

#include <QAction>
#include <QFontDatabase>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>
#include <QSplitter>
#include <QToolButton>

#include "ui/language/language.h"

namespace asperity {

QHBoxLayout* buttonRow(Widgets left, Widgets right) {
  auto* row = new QHBoxLayout;
  for (QWidget* button : left) row->addWidget(button);
  row->addStretch(1);
  for (QWidget* button : right) row->addWidget(button);
  return row;
}

QWidget& orderTabs(QWidget& before, const QLayout& layout) {
  QWidget* last = &before;
  for (int i = 0; i < layout.count(); ++i) {
    const QLayout* inner = layout.itemAt(i)->layout();
    if (QWidget* widget = layout.itemAt(i)->widget()) {
      inner = widget->layout();
      if (widget->focusPolicy() & Qt::TabFocus) {
        QWidget::setTabOrder(last, widget);
        last = widget;
      }
    }
    if (inner) last = &orderTabs(*last, *inner);
  }
  return *last;
}

bool isReturnKey(const QKeyEvent& event) {
  return event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
}

QSplitter* thinSplitter(Qt::Orientation orientation, const QString& name) {
  auto* splitter = named<QSplitter>(name, orientation);
  splitter->setHandleWidth(1);
  splitter->setChildrenCollapsible(false);
  return splitter;
}

void keepSpaceWhenHidden(QWidget& widget, bool keeps) {
  QSizePolicy policy = widget.sizePolicy();
  policy.setRetainSizeWhenHidden(keeps);
  widget.setSizePolicy(policy);
}

void setRowShown(QFormLayout& form, QWidget* field, bool isShown) {
  field->setVisible(isShown);
  if (QWidget* label = form.labelForField(field)) label->setVisible(isShown);
}

QScrollArea* scrolled(QWidget* content, Qt::ScrollBarPolicy sideways) {
  auto* area = new QScrollArea;
  area->setWidget(content);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(sideways);
  return area;
}

QProgressBar* thinProgress(const QString& name, int width) {
  auto* bar = named<QProgressBar>(name);
  bar->setTextVisible(false);
  bar->setFixedSize(width, 6);
  return bar;
}

void showPart(QProgressBar& bar, double part) {
  constexpr int kSteps = 1000;
  bar.setRange(0, kSteps);
  bar.setValue(static_cast<int>(kSteps * part));
}

QPlainTextEdit* fixedText(const QString& name) {
  auto* text = named<QPlainTextEdit>(name);
  text->setReadOnly(true);
  text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  return text;
}

QAction* checkedEntry(QObject& menuOrGroup, const QString& name, const QString& text,
                      bool isChecked, std::function<void(bool isChecked)> choose) {
  auto* entry = named<QAction>(name, text, &menuOrGroup);  // which adds it to a group
  if (auto* menu = qobject_cast<QMenu*>(&menuOrGroup)) menu->addAction(entry);
  entry->setCheckable(true);
  entry->setChecked(isChecked);
  QObject::connect(entry, &QAction::triggered, entry, std::move(choose));
  return entry;
}

QMenu* addSubmenu(QMenu& menu, const QString& name, std::function<QString()> title) {
  QMenu* submenu = menu.addMenu(QString());
  submenu->setObjectName(name);
  keepTranslated(*submenu, [submenu, title = std::move(title)] { submenu->setTitle(title()); });
  return submenu;
}

QMessageBox::StandardButton ask(
    QWidget* parent, const Question& question,
    std::initializer_list<std::pair<QMessageBox::StandardButton, QString>> answers,
    QMessageBox::StandardButton usual) {
  QMessageBox box(question.icon, question.title, {}, QMessageBox::NoButton, parent);
  box.setObjectName(question.name);
  box.setTextFormat(Qt::PlainText);
  box.setText(question.text);
  box.setInformativeText(question.explanation);
  for (const auto& [button, text] : answers) box.addButton(button)->setText(text);
  box.setDefaultButton(usual);
  if (!box.button(QMessageBox::Cancel)) box.setEscapeButton(usual);
  return static_cast<QMessageBox::StandardButton>(box.exec());
}

TitleBar::TitleBar(const QString& closeName, QWidget* parent)
    : QWidget(parent), title_(new QLabel), close_(named<QToolButton>(closeName)) {
  setObjectName("dockTitle");
  setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(14, 5, 8, 5);
  row->addWidget(title_, 1);
  row->addWidget(close_);
  close_->setText(QStringLiteral("✕"));
  close_->setFocusPolicy(Qt::NoFocus);
}

void TitleBar::leadBack(QWidget& page, const std::function<void()>& close,
                        const std::function<void()>& escape) {
  connect(close_, &QToolButton::clicked, &page, close);
  auto* key =
      new QShortcut(Qt::Key_Escape, &page, nullptr, nullptr, Qt::WidgetWithChildrenShortcut);
  connect(key, &QShortcut::activated, &page, escape);
  keepTranslated(*this, [this] {
    close_->setToolTip(tr("Back to the contact (Esc)"));
    close_->setAccessibleName(tr("back to the contact"));
  });
}

void TitleBar::insert(QWidget& control) {
  auto* row = static_cast<QHBoxLayout*>(layout());
  row->setSpacing(10);
  row->insertWidget(1, &control);
}

}  // namespace asperity
