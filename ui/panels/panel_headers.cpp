#include "ui/panels/panel_headers.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QToolButton>
#include <algorithm>

#include "ui/panels/boxes.h"
#include "ui/panels/controls.h"
#include "ui/panels/labels.h"

namespace asperity {

// ---- The bar

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
      essentials_(named<QToolButton>("showEssentials")),
      all_(named<QToolButton>("showAllParameters")),
      filter_(named<FilterLine>("parameterFilter")) {
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
  essentials_->setProperty("role", "segmentLeft");
  all_->setProperty("role", "segmentRight");
  essentials_->setChecked(true);
  connect(choice, &QButtonGroup::idToggled, this, [this](int, bool isOn) {
    if (isOn) emit changed();
  });
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
  filter_->setAccessibleName(tr("search in the parameters"));
  for (QAbstractButton* button : filter_->findChildren<QAbstractButton*>())
    button->setAccessibleName(tr("clear the search"));
  filter_->setToolTip(
      tr("Words of a label or a key, a symbol or a unit: “force”, “surface”, “G”, "
         "“mN”. Escape clears."));
}

// ---- The title of a section

namespace {

constexpr int kChevron = 16;  // pixels, width with its gap
constexpr int kAbove = 7, kBelow = 4;

}  // namespace

SectionHeader::SectionHeader(QWidget* parent) : QAbstractButton(parent) {
  setCheckable(true);
  setChecked(true);
  setFocusPolicy(Qt::TabFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setCursor(Qt::PointingHandCursor);
}

void SectionHeader::showState(const QString& title, int changed, bool isUnfolded) {
  setText(title);
  isUnfolded_ = isUnfolded;
  remark_ = isUnfolded || changed == 0 ? QString() : tr("%1 changed").arg(changed);
  setAccessibleName(title);
  setAccessibleDescription(isUnfolded          ? tr("open section")
                           : remark_.isEmpty() ? tr("folded section")
                                               : tr("folded section, %1").arg(remark_));
  setToolTip(isOpen() ? tr("Fold this section") : tr("Open this section"));
  update();
}

QSize SectionHeader::sizeHint() const {
  const QFontMetrics metrics(boldFont(font()));
  return {kChevron + metrics.horizontalAdvance(text()), metrics.height() + kAbove + kBelow};
}

void SectionHeader::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Right && !isOpen()) return click();
  if (event->key() == Qt::Key_Left && isOpen()) return click();
  QAbstractButton::keyPressEvent(event);
}

void SectionHeader::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPalette& colours = palette();
  const QRect line = rect().adjusted(0, kAbove, 0, -kBelow);
  painter.setPen(QPen(colours.color(QPalette::Mid), 1));
  painter.drawLine(QPointF(0, 1.5), QPointF(width(), 1.5));

  const bool isHighlighted = underMouse() || hasFocus();
  const QColor ink = colours.color(isHighlighted ? QPalette::Highlight : QPalette::WindowText);
  drawChevron(painter, {5, line.center().y() + 0.5}, isUnfolded_ ? Chevron::Down : Chevron::Right,
              ink);

  painter.setFont(boldFont(font()));
  painter.setPen(ink);
  painter.drawText(line.adjusted(kChevron, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, text());
  painter.setFont(font());
  painter.setPen(colours.color(QPalette::PlaceholderText));
  painter.drawText(line, Qt::AlignVCenter | Qt::AlignRight, remark_);
}

}  // namespace asperity
