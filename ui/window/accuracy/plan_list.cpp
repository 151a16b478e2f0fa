#include "ui/window/accuracy/plan_list.h"

#include <QEvent>
#include <algorithm>

#include "core/base/input_error.h"
#include "core/scene/plan.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/parameter_text.h"

namespace asperity {

PlanList::PlanList(QWidget* parent) : QTreeWidget(parent) {
  setObjectName("planList");
  setRootIsDecorated(false);
  setWordWrap(true);  // a long reason has as many lines as it needs
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::TabFocus);
  setSelectionMode(QAbstractItemView::NoSelection);
  keepTranslated(*this, [this] {
    setAccessibleName(tr("which stages run, and why"));
    setHeaderLabels({tr("stage"), tr("runs"), tr("because")});
    refill();
  });
}

void PlanList::showScene(const Scene& scene) {
  scene_ = scene;
  refill();
}

void PlanList::refill() {
  isFilled_ = false;
  if (isVisible()) fill();
}

void PlanList::fill() {
  isFilled_ = true;
  clear();
  try {
    for (const PlanStage& stage : planStages(scene_, Purpose::Window)) {
      const QString reason = withLabels(translatedText(stage.reason));
      auto* item = new QTreeWidgetItem(
          {translatedText(stage.name), stage.runs ? tr("yes") : tr("no"), reason});
      item->setToolTip(2, reason);
      item->setDisabled(!stage.runs);  // drawn pale, in either theme
      addTopLevelItem(item);
    }
  } catch (const InputError& error) {
    addTopLevelItem(new QTreeWidgetItem({{}, {}, errorWithLabel(error)}));
  }
  fitColumns();
}

void PlanList::showEvent(QShowEvent* event) {
  QTreeWidget::showEvent(event);
  if (isFilled_)
    fitColumns();
  else
    fill();
}

void PlanList::changeEvent(QEvent* event) {
  QTreeWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) fitColumns();
}

void PlanList::resizeEvent(QResizeEvent* event) {
  QTreeWidget::resizeEvent(event);
  fitRows();
}

/// Gives a row as many lines as its reason needs: the list itself counts one for each.
void PlanList::fitRows() {
  constexpr int kAround = 8, kBetween = 6;  // pixels beside a text and between rows
  const int available = viewport()->width() - columnWidth(0) - columnWidth(1) - kAround;
  for (int row = 0; row < topLevelItemCount(); ++row) {
    QTreeWidgetItem& item = *topLevelItem(row);
    const QRect rect = fontMetrics().boundingRect(QRect(0, 0, std::max(available, 1), 10000),
                                                  Qt::TextWordWrap, item.text(2));
    const QSize needed(rect.width() + kAround, rect.height() + kBetween);
    if (item.sizeHint(2) != needed) item.setSizeHint(2, needed);
  }
}

/// Shows names and answers in full; the reasons take the rest of the width.
void PlanList::fitColumns() {
  resizeColumnToContents(0);
  resizeColumnToContents(1);
  fitRows();
}

}  // namespace asperity
