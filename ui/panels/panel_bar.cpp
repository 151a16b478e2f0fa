#include "ui/panels/panel_bar.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QToolButton>
#include <algorithm>

namespace asperity {

FilterLine::FilterLine(QWidget* parent) : QLineEdit(parent) {
  setClearButtonEnabled(true);
  setMaxLength(60);
}

/// Handles Escape here, not as a shortcut of the window: it clears the filter and leaves it.
bool FilterLine::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    event->accept();
    return true;
  }
  return QLineEdit::event(event);
}

/// Reserves the width of the placeholder text of the filter.
QSize FilterLine::minimumSizeHint() const {
  constexpr int kAround = 24;  // pixels of the frame and the margins
  const QSize size = QLineEdit::minimumSizeHint();
  const int width = fontMetrics().horizontalAdvance(placeholderText()) + kAround;
  return {std::max(size.width(), width), size.height()};
}

void FilterLine::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Escape:
      clear();
      clearFocus();
      emit escaped();
      return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Down:
      emit left();
      return;
    default:
      QLineEdit::keyPressEvent(event);
  }
}

PanelBar::PanelBar(QWidget* parent)
    : QWidget(parent),
      essentials_(new QToolButton),
      all_(new QToolButton),
      filter_(new FilterLine) {
  setObjectName("panelBar");
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(14, 6, 14, 6);
  line->setSpacing(0);
  auto* choice = new QButtonGroup(this);
  for (QToolButton* button : {essentials_, all_}) {
    button->setCheckable(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
    choice->addButton(button);
    line->addWidget(button);
  }
  essentials_->setObjectName("showEssentials");
  essentials_->setProperty("role", "segmentLeft");
  all_->setObjectName("showAllParameters");
  all_->setProperty("role", "segmentRight");
  essentials_->setChecked(true);
  connect(choice, &QButtonGroup::idToggled, this, [this](int, bool isOn) {
    if (isOn) emit changed();
  });
  filter_->setObjectName("parameterFilter");
  connect(filter_, &QLineEdit::textChanged, this, &PanelBar::changed);
  line->addSpacing(8);
  line->addWidget(filter_, 1);
}

bool PanelBar::showsAll() const {
  return all_->isChecked();
}

void PanelBar::setShowsAll(bool all) {
  (all ? all_ : essentials_)->setChecked(true);
}

QStringList PanelBar::words() const {
  return filter_->text().split(' ', Qt::SkipEmptyParts);
}

void PanelBar::showTexts() {
  essentials_->setText(tr("Essentials"));
  essentials_->setToolTip(
      tr("The few parameters that matter first: velocity, load, stiffness, "
         "roughness"));
  all_->setText(tr("All"));
  all_->setToolTip(tr("All parameters of this scene, in sections"));
  filter_->setPlaceholderText(tr("Search ( / )"));
  filter_->setAccessibleName(tr("filter of the parameters"));
  for (QAbstractButton* button : filter_->findChildren<QAbstractButton*>())
    button->setAccessibleName(tr("clear the filter"));
  filter_->setToolTip(
      tr("Words of a label or a key, a symbol or a unit: “force”, “surface”, “G”, "
         "“mN”. Escape clears."));
}

}  // namespace asperity
