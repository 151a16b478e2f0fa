#include "ui/window/curve/curve_comparison.h"

#include <exception>

#include "ui/language/translated.h"
#include "ui/window/main/session.h"

namespace asperity {

CurveComparison::CurveComparison(Session& session, QObject* parent)
    : QObject(parent), session_(session) {
  connect(&session_, &Session::plotChanged, this, &CurveComparison::follow);
}

void CurveComparison::setSetting(const std::optional<CurveSetting>& setting) {
  if (setting == setting_) return;
  setting_ = setting;
  compared_.reset();
  ++number_;  // what still runs is not wanted
  if (work_) work_->cancel();
  if (setting_) return follow();
  session_.editCurve([](FrictionChart& plot) { plot.showDifference(std::nullopt); });
}

/// Begins when the scene's own curve is complete: the curve comes first.
void CurveComparison::follow() {
  const CurveUpdate* curve = session_.curve();
  if (!setting_ || !curve || !curve->isComplete) return;
  if (choosesAccuracy(*curve->scene)) return;
  if (compared_ && haveSameCurve(*compared_, *curve->scene)) return;
  compared_ = *curve->scene;
  compared_->sliding.kind = SlidingKind::Steady;  // as the curve of any motion is
  start();
}

void CurveComparison::start() {
  if (!work_) work_ = std::make_unique<LatestWork>();
  const auto later = [this](auto&& what) { QMetaObject::invokeMethod(this, what); };
  work_->request([this, later, scene = *compared_, setting = *setting_,
                  number = ++number_](const std::stop_token& stop) {
    DifferenceOptions options;
    options.stop = stop;
    options.progress = [&](const CurveDifference& part) {
      if (!stop.stop_requested())
        later([this, number, difference = std::make_shared<const CurveDifference>(part)] {
          take(number, difference);
        });
    };
    try {
      curveDifference(scene, setting, options);
    } catch (const std::exception& error) {
      later([this, reason = translatedText(error.what())] { emit failed(reason); });
    }
  });
}

void CurveComparison::take(std::uint64_t number,
                           std::shared_ptr<const CurveDifference> difference) {
  if (number != number_ || !setting_) return;
  emit shown();
  session_.editCurve([&](FrictionChart& plot) { plot.showDifference(*difference); });
}

}  // namespace asperity
