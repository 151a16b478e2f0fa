#include "core/run/transient_diagram.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/run/minimum_span.h"
#include "core/scene/effects.h"

namespace asperity {
namespace {

Diagram strip(const Scene& scene, std::span<const TransientSample> samples, DiagramAxis up,
              double TransientSample::*member, double least) {
  Diagram diagram;
  diagram.x = {"time t", "s", AxisScale::Linear, 0, scene.sliding.duration};
  diagram.y = std::move(up);
  DiagramSeries series;
  series.colour = 0;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const TransientSample& sample : samples) {
    series.points.push_back({sample.time, sample.*member});
    if (!std::isfinite(sample.*member)) continue;
    low = std::min(low, sample.*member);
    high = std::max(high, sample.*member);
  }
  if (least > 0 && low <= high) {
    const AxisEnds ends = axisEnds(low, high, least);
    diagram.y.from = ends.from;
    diagram.y.to = ends.to;
  }
  diagram.series = {std::move(series)};
  return diagram;
}

/// What is known of the error as a band around the values, under their line; the axis has room for
/// it where it reaches 0, as of a body without friction.
void addErrorBand(Diagram& diagram, std::span<const TransientSample> samples) {
  DiagramSeries band;
  band.isBand = true;
  band.stroke = SeriesStroke::None;
  band.colour = 0;
  for (const TransientSample& sample : samples)
    if (std::isfinite(sample.muError))
      band.points.push_back({sample.time, sample.mu, std::max(sample.mu - sample.muError, 0.0),
                             sample.mu + sample.muError});
  if (band.points.size() < 2) return;
  const double low = std::ranges::min(band.points, {}, &DiagramPoint::low).low;
  const double high = std::ranges::max(band.points, {}, &DiagramPoint::high).high;
  if (low < diagram.y.from || high > diagram.y.to) {
    const AxisEnds ends = axisEnds(low, high, 0);
    diagram.y.from = std::min(diagram.y.from, ends.from);
    diagram.y.to = std::max(diagram.y.to, ends.to);
  }
  diagram.series.insert(diagram.series.begin(), std::move(band));
}

}  // namespace

DiagramSheet transientSheet(const Scene& scene, std::span<const TransientSample> samples,
                            double spacing, double period) {
  const MinimumSpan floors = minimumSpan(samples, spacing, period);
  DiagramSheet sheet;
  sheet.columns = 1;
  sheet.sharesAxis = true;
  sheet.diagrams = {
      strip(scene, samples, {"velocity v", "m/s", AxisScale::Linear}, &TransientSample::velocity,
            0),
      strip(scene, samples,
            {hasLocalFriction(scene) ? "friction \u03BC, deformation alone" : "friction \u03BC", "",
             AxisScale::Linear},
            &TransientSample::mu, floors.friction),
      strip(scene, samples, {"indentation d", "m", AxisScale::Linear},
            &TransientSample::indentation, floors.indentation)};
  addErrorBand(sheet.diagrams[1], samples);
  return sheet;
}

Diagram contactStrip(const Scene& scene, std::span<const TransientSample> samples) {
  return strip(scene, samples, {"in contact", "", AxisScale::Linear},
               &TransientSample::contactFraction, 0.2);
}

}  // namespace asperity
