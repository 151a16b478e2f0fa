#include "core/run/transient_diagram.h"

namespace asperity {
namespace {

Diagram strip(const Scene& scene, std::span<const TransientSample> samples, DiagramAxis up,
              double TransientSample::*member) {
  Diagram diagram;
  diagram.x = {"time t", "s", AxisScale::Linear, 0, scene.sliding.duration};
  diagram.y = std::move(up);
  DiagramSeries series;
  series.colour = 0;
  for (const TransientSample& sample : samples)
    series.points.push_back({sample.time, sample.*member});
  diagram.series = {std::move(series)};
  return diagram;
}

}  // namespace

DiagramSheet transientSheet(const Scene& scene, std::span<const TransientSample> samples) {
  DiagramSheet sheet;
  sheet.columns = 1;
  sheet.diagrams = {
      strip(scene, samples, {"velocity v", "m/s", AxisScale::Linear}, &TransientSample::velocity),
      strip(scene, samples, {"friction \u03BC", "", AxisScale::Linear}, &TransientSample::mu),
      strip(scene, samples, {"indentation d", "m", AxisScale::Linear},
            &TransientSample::indentation)};
  return sheet;
}

}  // namespace asperity
