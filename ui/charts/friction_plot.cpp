#include "ui/charts/friction_plot.h"

#include <algorithm>
#include <cmath>

#include "ui/charts/decade_range.h"

namespace asperity {

namespace {

constexpr DecadeRange kEmptyVelocities{-5, 3};  // shown before anything is known
constexpr DecadeRange kEmptyCoefficients{-6, -2};

constexpr double kAir = 1.15;

bool isKnown(const CurvePoint& point) {
  return point.realizations > 0;
}

bool hasKnownPoint(const CurveUpdate& update) {
  return std::any_of(update.points.begin(), update.points.end(), isKnown);
}

Scene withoutPresent(Scene scene) {
  scene.title.clear();
  scene.sliding.velocity = Sliding{}.velocity;
  return scene;
}

/// Smallest and largest of the positive finite numbers given to it.
struct Extent {
  double low = 0, high = 0;

  void add(double value) {
    if (!isPlottable(value, value)) return;
    low = high > 0 ? std::min(low, value) : value;
    high = std::max(high, value);
  }
  /// `air` keeps that factor between the data and the ends.
  DecadeRange decades(double air = 1) const {
    return high > 0 ? decadesAround(low / air, high * air) : DecadeRange{};
  }
};

}  // namespace

bool haveSameCurve(const Scene& a, const Scene& b) {
  return withoutPresent(a) == withoutPresent(b);
}

void FrictionPlot::expect(const Scene& scene) {
  expected_ = scene;
  fitRanges(!curve_);
}

bool FrictionPlot::isStale() const {
  return curve_ && expected_ && !haveSameCurve(*curve_->scene, *expected_);
}

bool FrictionPlot::take(const CurveUpdate& update) {
  if (!update.scene || !hasKnownPoint(update)) return false;
  if (expected_ && !haveSameCurve(*update.scene, *expected_)) return false;
  const bool newCurve = !curve_ || !haveSameCurve(*curve_->scene, *update.scene);
  curve_ = update;
  fitRanges(newCurve);
  return true;
}

void FrictionPlot::mark(const Frame& frame) {
  const double velocity = frame.scene->sliding.velocity;
  PlotMarker marker;
  marker.label = tr("v = %1 m/s").arg(readingLabel(velocity));
  marker.x = velocity;
  marker.y = frame.muSteady;
  marker_ = marker;
  fitRanges(false);
}

Plot FrictionPlot::plot() const {
  Plot plot;
  plot.x = {tr("sliding velocity v (m/s)"), velocities_.isEmpty() ? kEmptyVelocities : velocities_};
  plot.y = {tr("coefficient of friction μ"),
            coefficients_.isEmpty() ? kEmptyCoefficients : coefficients_};
  if (curve_) plot.series = {law(), measured()};
  plot.marker = marker_;
  if (plot.marker) plot.marker->name = isOneLine() ? tr("now") : tr("this line, now");
  plot.note = note();
  plot.blank = blank();
  if (curve_ && !isStale() && curve_->realizationsTotal > 0)
    plot.progress = static_cast<double>(curve_->realizationsDone) /
                    static_cast<double>(curve_->realizationsTotal);
  return plot;
}

/// Whether there is nothing to average: a line that is not random, or only one that is.
bool FrictionPlot::isOneLine() const {
  return curve_ && curve_->realizationsTotal <= 1;
}

PlotSeries FrictionPlot::measured() const {
  PlotSeries series{isOneLine() ? tr("this line") : tr("mean of the lines ± standard error"),
                    PlotStyle::Points,
                    isStale(),
                    {}};
  for (const CurvePoint& point : curve_->points)
    if (isKnown(point)) series.points.push_back({point.velocity, point.mu, point.muStandardError});
  series.points = plottable(series.points);
  return series;
}

PlotSeries FrictionPlot::law() const {
  PlotSeries series{tr("Eq. (11)"), PlotStyle::Line, isStale(), {}};
  for (const CurvePoint& point : curve_->points)
    series.points.push_back({point.velocity, point.muLaw});
  series.points = plottable(series.points);
  return series;
}

QString FrictionPlot::note() const {
  if (!curve_) return tr("no curve yet");
  if (isStale()) return tr("curve of the scene before");
  if (curve_->scene->surface.kind != SurfaceKind::SelfAffine) return {};
  return tr("%1 of %2 realizations").arg(curve_->realizationsDone).arg(curve_->realizationsTotal);
}

QString FrictionPlot::blank() const {
  if (!curve_ || isStale() || !measured().points.empty()) return {};
  const auto isFrictionless = [](const CurvePoint& point) {
    return !isKnown(point) || point.mu == 0;
  };
  if (std::all_of(curve_->points.begin(), curve_->points.end(), isFrictionless))
    return tr("no friction: nothing positive to show on a logarithmic axis");
  return tr("no positive coefficient of friction to show on a logarithmic axis");
}

void FrictionPlot::fitRanges(bool newCurve) {
  Extent velocities, coefficients;
  if (expected_) {
    velocities.add(expected_->sweep.velocityFrom);
    velocities.add(expected_->sweep.velocityTo);
  }
  if (curve_) {
    for (const CurvePoint& point : curve_->points) {
      velocities.add(point.velocity);
      coefficients.add(point.muLaw);
      if (!isKnown(point)) continue;
      coefficients.add(point.mu);
      if (point.mu > 0) coefficients.add(point.mu + point.muStandardError);
    }
  }
  if (marker_) {
    velocities.add(marker_->x);
    coefficients.add(marker_->y);
  }
  velocities_ = steadyRange(velocities_, velocities.decades(), newCurve);
  coefficients_ =
      steadyRange(coefficients_, neededCoefficients(coefficients.decades(kAir)), newCurve);
}

/// Before there is a curve, some decades of friction stand around the marker.
DecadeRange FrictionPlot::neededCoefficients(const DecadeRange& data) const {
  if (curve_) return data;
  return steadyRange(kEmptyCoefficients, data, false);
}

}  // namespace asperity
