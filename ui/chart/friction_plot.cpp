#include "ui/chart/friction_plot.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/friction/law.h"
#include "core/material/element_law.h"
#include "core/scene/motion.h"
#include "ui/chart/decade_range.h"

namespace asperity {

namespace {

constexpr DecadeRange kEmptyVelocities{-5, 3};  // shown before anything is known
constexpr DecadeRange kEmptyCoefficients{-6, -2};

constexpr double kAir = 1.15;
constexpr std::size_t kLongestTrace = 2000;  // samples of a motion

bool isKnown(const CurvePoint& point) {
  return point.realizations > 0;
}

bool hasKnownPoint(const CurveUpdate& update) {
  return std::any_of(update.points.begin(), update.points.end(), isKnown);
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

void addCurve(const CurveUpdate& curve, CurveAxes axes, Extent& velocities, Extent& coefficients) {
  const auto [velocity, friction] = factorsOf(curve.points, axes);
  for (const CurvePoint& point : curve.points) {
    velocities.add(point.velocity * velocity);
    if (!isKnown(point)) continue;
    coefficients.add(point.mu * friction);
    if (point.mu > 0) coefficients.add((point.mu + point.muStandardError) * friction);
  }
}

/// To dimensionless axes, of the line in a frame.
AxesFactors factorsOf(const Frame& frame) {
  AxesFactors factors;
  if (!(frame.rmsHeight > 0) || !(frame.rmsSlope > 0)) return factors;
  factors.friction = 1 / frame.rmsSlope;
  const ElementLaw law = lawOf(frame.scene->elastomer);
  if (law.kind() != ElementKind::Kelvin) return factors;
  LawInput in;
  in.relaxationTime = law.relaxationTime;
  in.rmsHeight = frame.rmsHeight;
  in.rmsSlope = frame.rmsSlope;
  in.velocity = 1;
  factors.velocity = dimensionlessVelocity(in);
  return factors;
}

}  // namespace

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
  curve_ = std::make_shared<const CurveUpdate>(update);
  fitRanges(newCurve);
  return true;
}

void FrictionPlot::mark(const Frame& frame) {
  markerFactors_ = factorsOf(frame);
  if (frame.transient) {
    markMotion(frame);
  } else {
    const double velocity = frame.scene->sliding.velocity;
    marker_.emplace();
    marker_->label = tr("v = %1 m/s").arg(readingLabel(velocity));
    marker_->x = velocity;
    marker_->y = frame.muSteady;
  }
  fitRanges(false);
}

void FrictionPlot::markMotion(const Frame& frame) {
  const std::vector<TransientSample>& samples = *frame.transient;
  const double velocity = std::abs(samples.empty() ? frame.velocity : samples.back().velocity);
  marker_.emplace();
  marker_->label = tr("|v| = %1 m/s").arg(readingLabel(std::abs(frame.velocity)));
  marker_->x = velocity;
  marker_->isFixed = true;
  const std::size_t first = samples.size() > kLongestTrace ? samples.size() - kLongestTrace : 0;
  for (std::size_t i = first; i < samples.size(); ++i)
    marker_->trace.push_back({std::abs(samples[i].velocity), samples[i].mu});
  if (!samples.empty()) marker_->y = samples.back().mu;
  const Motion motion(frame.scene->sliding);
  fastest_ = motion.fastest(0, motion.duration());
}

void FrictionPlot::setAxes(CurveAxes axes) {
  if (axes == axes_) return;
  axes_ = axes;
  velocities_ = coefficients_ = {};
  fitRanges(true);
}

int FrictionPlot::pin() {
  if (!curve_) return 0;
  for (const PinnedCurve& pinned : pinned_)
    if (haveSameCurve(*pinned.curve->scene, *curve_->scene) &&
        pinned.curve->realizationsDone == curve_->realizationsDone &&
        pinned.curve->isComplete == curve_->isComplete)
      return 0;
  const auto isTaken = [this](int place) {
    return std::ranges::any_of(pinned_, [&](const PinnedCurve& p) { return p.place == place; });
  };
  int place = 0;
  while (isTaken(place)) ++place;
  pinned_.push_back({++lastId_, place, curve_});
  return lastId_;
}

void FrictionPlot::unpin(int id) {
  std::erase_if(pinned_, [id](const PinnedCurve& pinned) { return pinned.id == id; });
  fitRanges(true);
}

void FrictionPlot::unpinAll() {
  pinned_.clear();
  fitRanges(true);
}

QString FrictionPlot::nameOf(const PinnedCurve& pinned) const {
  return FrictionSeries::nameOfPinned(*pinned.curve, expected_ ? *expected_ : *curve_->scene);
}

void FrictionPlot::showDifference(std::optional<CurveDifference> difference) {
  difference_ = std::move(difference);
}

bool FrictionPlot::hasStaleDifference() const {
  const Scene& present = expected_ ? *expected_ : *curve_->scene;
  return isStale() || !haveSameCurve(*difference_->scene, present);
}

Plot FrictionPlot::plot() const {
  Plot plot;
  if (axes_ == CurveAxes::Physical) {
    plot.x = {tr("sliding velocity v (m/s)"), {}, velocities_};
    plot.y = {tr("coefficient of friction μ"), tr("friction μ"), coefficients_};
  } else {
    plot.x = {tr("dimensionless velocity v̄ = τ v ∇z / (√2 h)"), {}, velocities_};
    plot.y = {tr("normalized friction μ / ∇z"), QStringLiteral("μ / ∇z"), coefficients_};
  }
  if (plot.x.range.isEmpty()) plot.x.range = kEmptyVelocities;
  if (plot.y.range.isEmpty()) plot.y.range = kEmptyCoefficients;
  if (curve_) {
    plot.series = {FrictionSeries::law(*curve_, axes_)};
    for (const PinnedCurve& pinned : pinned_)
      plot.series.push_back(
          FrictionSeries::pinned(*pinned.curve, axes_, pinned.id, pinned.place, nameOf(pinned)));
    plot.series.push_back(FrictionSeries::measured(*curve_, axes_));
    plot.spans = FrictionSeries::regions(*curve_, axes_);
    plot.shades = FrictionSeries::shades(*curve_, axes_);
    if (difference_) {
      plot.strip = FrictionSeries::strip(*difference_, *curve_, axes_);
      plot.strip->faded = hasStaleDifference();
    }
  }
  if (isStale()) {
    plot.series.front().faded = plot.series.back().faded = true;
    for (std::vector<PlotSpan>* spans : {&plot.spans, &plot.shades})
      for (PlotSpan& span : *spans) span.faded = true;
  }
  plot.marker = marker();
  plot.note = note();
  plot.blank = blank();
  plot.progress = progress();
  return plot;
}

double FrictionPlot::progress() const {
  constexpr double kAlmost = 0.999;
  if (!curve_ || isStale()) return 0;
  if (curve_->isComplete) return 1;
  if (curve_->realizationsTotal <= 0) return 0;
  return std::min(kAlmost, static_cast<double>(curve_->realizationsDone) /
                               static_cast<double>(curve_->realizationsTotal));
}

std::optional<PlotMarker> FrictionPlot::marker() const {
  if (!marker_) return std::nullopt;
  PlotMarker marker = *marker_;
  if (axes_ == CurveAxes::Dimensionless) {
    marker.x *= markerFactors_.velocity;
    marker.y *= markerFactors_.friction;
    for (PlotPoint& point : marker.trace) {
      point.x *= markerFactors_.velocity;
      point.y *= markerFactors_.friction;
    }
    marker.label = tr("v̄ = %1").arg(readingLabel(marker.x));
  }
  marker.faded = isMarkFaded_;
  marker.name = isMarkFaded_                                   ? tr("before the change")
                : marker.isFixed                               ? tr("this motion, now")
                : curve_ && FrictionSeries::isOneLine(*curve_) ? tr("now")
                                                               : tr("this line, now");
  return marker;
}

const CurveUpdate* FrictionPlot::find(int id) const {
  if (id == kPresentCurve) return curve_.get();
  for (const PinnedCurve& pinned : pinned_)
    if (pinned.id == id) return pinned.curve.get();
  return nullptr;
}

QString FrictionPlot::describe(int id, int row) const {
  const auto place = static_cast<std::size_t>(row);
  if (id == kStripCurve)
    return difference_ && place < difference_->points.size()
               ? FrictionSeries::reading(difference_->points[place], difference_->setting)
               : QString();
  const CurveUpdate* curve = find(id);
  if (!curve || place >= curve->points.size()) return {};
  const QString text = FrictionSeries::reading(curve->points[place], axes_);
  if (id == kPresentCurve) return text;
  const auto pinned = std::ranges::find(pinned_, id, &PinnedCurve::id);
  return nameOf(*pinned) + '\n' + text;
}

std::optional<double> FrictionPlot::velocityOf(int id, int row) const {
  const CurveUpdate* curve = find(id);
  if (!curve || static_cast<std::size_t>(row) >= curve->points.size()) return std::nullopt;
  return curve->points[static_cast<std::size_t>(row)].velocity;
}

std::optional<double> FrictionPlot::velocityAt(double x) const {
  const double factor = axes_ == CurveAxes::Physical ? 1 : markerFactors_.velocity;
  const double velocity = x / factor;
  return std::isfinite(velocity) ? std::optional(velocity) : std::nullopt;
}

std::optional<CurveSet> FrictionPlot::shown(const std::optional<PlotWindow>& zoom) const {
  if (!curve_) return std::nullopt;
  CurveSet set;
  set.present = {{}, *curve_->scene, curve_->points, 0};
  for (const PinnedCurve& pinned : pinned_) {
    const QString name = FrictionSeries::nameOfPinned(*pinned.curve, *curve_->scene);
    set.pinned.push_back(
        {name.toStdString(), *pinned.curve->scene, pinned.curve->points, pinned.place});
  }
  set.axes = axes_;
  if (difference_ && haveSameCurve(*difference_->scene, *curve_->scene))
    set.difference = difference_;
  if (zoom) {
    set.xFrom = std::pow(10, zoom->x.from);
    set.xTo = std::pow(10, zoom->x.to);
    set.yFrom = std::pow(10, zoom->y.from);
    set.yTo = std::pow(10, zoom->y.to);
  }
  return set;
}

QString FrictionPlot::note() const {
  if (!curve_) return tr("no curve yet");
  if (isStale()) return tr("curve of the scene before");
  if (curve_->scene->surface.kind != SurfaceKind::SelfAffine) return {};
  return tr("%1 of %2 realizations").arg(curve_->realizationsDone).arg(curve_->realizationsTotal);
}

QString FrictionPlot::blank() const {
  if (!curve_ || isStale() || !FrictionSeries::measured(*curve_, axes_).points.empty()) return {};
  const auto isFrictionless = [](const CurvePoint& point) {
    return !isKnown(point) || point.mu == 0;
  };
  if (std::all_of(curve_->points.begin(), curve_->points.end(), isFrictionless))
    return tr("no friction: nothing positive to show on a logarithmic axis");
  if (axes_ == CurveAxes::Dimensionless &&
      !FrictionSeries::measured(*curve_, CurveAxes::Physical).points.empty())
    return tr("no dimensionless axes: they need a line with roughness and one relaxation time");
  return tr("no positive coefficient of friction to show on a logarithmic axis");
}

void FrictionPlot::fitRanges(bool newCurve) {
  Extent velocities, coefficients;
  if (expected_ && axes_ == CurveAxes::Physical) {
    velocities.add(expected_->sweep.velocityFrom);
    velocities.add(expected_->sweep.velocityTo);
  }
  if (curve_) {
    addCurve(*curve_, axes_, velocities, coefficients);
    const auto [velocity, friction] = asperity::factorsOf(curve_->points, axes_);
    for (const CurvePoint& point : curve_->points) coefficients.add(point.muLaw * friction);
  }
  for (const PinnedCurve& pinned : pinned_)
    addCurve(*pinned.curve, axes_, velocities, coefficients);
  if (const std::optional<PlotMarker> shown = marker(); shown && shown->isFixed) {
    // A motion comes to rest again and again: the axes go up with it, not down.
    velocities.add(fastest_ * (axes_ == CurveAxes::Physical ? 1 : markerFactors_.velocity));
    if (shown->y > coefficients.high) coefficients.add(shown->y);
  } else if (shown) {
    velocities.add(shown->x);
    coefficients.add(shown->y);
  }
  if (const DecadeRange needed = velocities.decades(); !needed.isEmpty()) velocities_ = needed;
  coefficients_ =
      steadyRange(coefficients_, neededCoefficients(coefficients.decades(kAir)), newCurve);
}

/// Before there is a curve, some decades of friction stand around the marker.
DecadeRange FrictionPlot::neededCoefficients(const DecadeRange& data) const {
  if (curve_ || axes_ == CurveAxes::Dimensionless) return data;
  return steadyRange(kEmptyCoefficients, data, false);
}

}  // namespace asperity
