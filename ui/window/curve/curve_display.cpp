#include "ui/window/curve/curve_display.h"

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "core/scene/sweep.h"
#include "ui/language/language.h"
#include "ui/panels/number_text.h"
#include "ui/window/main/session.h"

namespace asperity {

namespace {

constexpr int kPause = 80;  // ms; painting a diagram takes as long as several pictures
constexpr int kDigits = 3, kFineDigits = 5;  // digits of a value that the user sets
constexpr int kFade = 30;  // ms to wait for a new curve before the old one is drawn faded

}  // namespace

CurveDisplay::CurveDisplay(Session& session, ChartView& view, QObject* parent)
    : QObject(parent), session_(session), view_(view) {
  pause_.setSingleShot(true);
  connect(&pause_, &QTimer::timeout, this, [this] {
    if (isDue_) show();
  });
  connect(&session_, &Session::plotChanged, this, &CurveDisplay::showSoon);
  connect(&session_, &Session::markChanged, this, &CurveDisplay::showMarker);
  // The line returns to the marker where the value was refused, as in a step of a lesson.
  connect(&session_, &Session::commandSent, this, [this] {
    if (!requested_ || ownSweptValue(session_.scene()) == *requested_) return;
    requested_.reset();
    view_.releaseMarker();
  });
  view_.setDescribe([this](int id, int row) { return session_.friction().describe(id, row); });
  connect(&view_, &ChartView::markerMoved, this, [this](double x, bool finely) {
    const auto value = session_.friction().sweptAt(x);
    if (value) setSwept(roundedToDigits(*value, finely ? kFineDigits : kDigits));
  });
  connect(&view_, &ChartView::pointChosen, this, [this](int id, int row) {
    if (const auto value = session_.friction().sweptValue(id, row)) setSwept(*value);
  });
  connect(&view_, &ChartView::unpinRequested, this, [this](int id) {
    session_.editCurve([id](FrictionChartModel& plot) { plot.unpin(id); });
  });
  show();
}

void CurveDisplay::showSoon() {
  const bool isStale = session_.friction().isStale();
  const bool wasStale = std::exchange(wasStale_, isStale);
  if (wasStale && !isStale) return show();
  isDue_ = true;
  if (isStale && !wasStale) return pause_.start(kFade);
  if (!pause_.isActive()) show();
}

void CurveDisplay::show() {
  isDue_ = false;
  view_.setSheet(session_.friction().sheet());
  pause_.start(kPause);
}

void CurveDisplay::showMarker() {
  view_.setMarker(session_.friction().marker());
}

/// Sets the key of the axis to exactly this value, within the limits of the table of parameters.
void CurveDisplay::setSwept(double value) {
  const Scene scene = withSweptValue(session_.scene(), value);
  if (scene == session_.scene()) return;
  requested_ = ownSweptValue(scene);
  emit sceneEdited(scene);
}

}  // namespace asperity
