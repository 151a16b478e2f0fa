#include "ui/window/curve/curve_comparison.h"

#include <memory>

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

/// Begins the comparison when the scene's own curve is complete: the curve comes first.
void CurveComparison::update() {
  const CurveUpdate* curve = session_.curve();
  if (!setting_ || !curve || !curve->isComplete) return;
  if (choosesAccuracy(*curve->scene) || !curve->scene->sweep.isOfVelocity()) return;
  if (compared_ && haveSameCurve(*compared_, *curve->scene)) return;
  compared_ = *curve->scene;
  // Curves of any motion are computed for steady sliding.
  compared_->sliding.kind = SlidingKind::Steady;
  start();
}

void CurveComparison::start() {
  work_.request(
      [this, scene = *compared_, setting = *setting_](const BackgroundWork::Run& run) {
        DifferenceOptions options;
        options.stop = run.stop();
        options.progress = [&](const CurveDifference& part) {
          run.post([this, part = std::make_shared<const CurveDifference>(part)] { take(*part); });
        };
        curveDifference(scene, setting, options);
      },
      [] {}, [this](const QString& reason) { emit failed(reason); });
}

void CurveComparison::take(const CurveDifference& difference) {
  emit shown();
  session_.editCurve([&](FrictionChartModel& plot) { plot.showDifference(difference); });
}

}  // namespace asperity
