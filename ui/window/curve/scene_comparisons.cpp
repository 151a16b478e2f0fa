#include "ui/window/curve/scene_comparisons.h"

#include <memory>

#include "core/chart/comparison.h"
#include "ui/window/main/session.h"

namespace asperity {

SceneComparisons::SceneComparisons(Session& session, QObject* parent)
    : QObject(parent), session_(session) {
  connect(&session_, &Session::plotChanged, this, &SceneComparisons::update);
}

/// Begins when the scene's own curve is complete: the curve comes first.
void SceneComparisons::update() {
  const CurveUpdate* curve = session_.curve();
  if (!curve || !curve->isComplete) return;
  const Scene& scene = *curve->scene;
  const CurveQuantity quantity = session_.friction().quantity();
  if (compared_ && haveSameCurve(*compared_, scene) && quantity == quantity_) return;
  compared_ = scene;
  quantity_ = quantity;
  CurveSet named;
  named.present.scene = scene;
  named.y = quantity;
  if (!hasComparisons(named)) return work_.cancel();
  work_.request(
      [scene, quantity](const BackgroundWork::Run& run) {
        auto set = std::make_shared<CurveSet>();
        set->present.scene = scene;
        set->y = quantity;
        StateOptions options;
        options.stop = run.stop();
        addComparisons(*set, readComparisonData(scene), options);
        return std::shared_ptr<const CurveSet>(std::move(set));
      },
      [this, scene](const std::shared_ptr<const CurveSet>& set) {
        emit shown();
        session_.editCurve([&](FrictionChartModel& plot) { plot.showComparisons(scene, *set); });
      },
      [this](const QString& reason) { emit failed(reason); });
}

}  // namespace asperity
