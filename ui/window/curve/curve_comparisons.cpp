#include "ui/window/curve/curve_comparisons.h"

#include <memory>

#include "core/chart/curve_set.h"
#include "ui/window/main/session.h"

namespace asperity {

CurveComparison::CurveComparison(Session& session, QObject* parent)
    : QObject(parent), session_(session) {
  connect(&session_, &Session::plotChanged, this, &CurveComparison::update);
}

void CurveComparison::setSetting(const std::optional<CurveSetting>& setting) {
  if (setting == setting_) return;
  setting_ = setting;
  compared_.reset();
  work_.cancel();
  if (setting_) return update();
  session_.editCurve([](FrictionChartModel& plot) { plot.showDifference(std::nullopt); });
}

void CurveComparison::update() {
  const CurveUpdate* curve = session_.curve();
  if (!setting_ || !curve || !curve->isComplete) return;
  if (choosesAccuracy(*curve->scene) || !curve->scene->sweep.isOfVelocity()) return;
  if (compared_ && haveSameCurve(*compared_, *curve->scene)) return;
  compared_ = *curve->scene;
  // Curves of any motion are computed for steady sliding.
  compared_->sliding.kind = SlidingKind::Steady;
  work_.request(
      [this, scene = *compared_, setting = *setting_](const BackgroundWork::Run& run) {
        DifferenceOptions options;
        options.stop = run.stop();
        options.progress = [&](const CurveDifference& part) {
          run.post([this, part = std::make_shared<const CurveDifference>(part)] {
            emit shown();
            session_.editCurve([&](FrictionChartModel& plot) { plot.showDifference(*part); });
          });
        };
        curveDifference(scene, setting, options);
      },
      [] {}, [this](const QString& reason) { emit failed(reason); });
}

SceneComparisons::SceneComparisons(Session& session, QObject* parent)
    : QObject(parent), session_(session) {
  connect(&session_, &Session::plotChanged, this, &SceneComparisons::update);
}

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
