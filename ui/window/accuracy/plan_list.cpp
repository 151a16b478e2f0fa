#include "ui/window/accuracy/plan_list.h"

#include <QEvent>
#include <QHeaderView>

#include "core/base/input_error.h"
#include "core/scene/plan.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"

namespace asperity {

PlanList::PlanList(QWidget* parent) : QTreeWidget(parent) {
  setObjectName("planList");
  setRootIsDecorated(false);
  setUniformRowHeights(true);
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::TabFocus);
  setSelectionMode(QAbstractItemView::NoSelection);
  keepTranslated(*this, [this] {
    setAccessibleName(tr("which stages run, and why"));
    setHeaderLabels({tr("stage"), tr("runs"), tr("because")});
    fill();
  });
}

void PlanList::showScene(const Scene& scene) {
  scene_ = scene;
  fill();
}

void PlanList::fill() {
  clear();
  try {
    for (const PlanStage& stage : planOf(scene_, Purpose::Window)) {
      const QString reason = translatedText(stage.reason);
      auto* item = new QTreeWidgetItem(
          {translatedText(stage.name), stage.runs ? tr("yes") : tr("no"), reason});
      item->setToolTip(2, reason);
      item->setDisabled(!stage.runs);  // drawn pale, in either theme
      addTopLevelItem(item);
    }
  } catch (const InputError& error) {
    addTopLevelItem(new QTreeWidgetItem({{}, {}, translatedError(error)}));
  }
  fitColumns();
}

void PlanList::showEvent(QShowEvent* event) {
  QTreeWidget::showEvent(event);
  fitColumns();
}

void PlanList::changeEvent(QEvent* event) {
  QTreeWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) fitColumns();
}

/// Shows names and answers in full; the reasons take the rest of the width.
void PlanList::fitColumns() {
  resizeColumnToContents(0);
  resizeColumnToContents(1);
}

}  // namespace asperity
