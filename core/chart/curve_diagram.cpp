#include "core/chart/curve_diagram.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/chart/curve_regions.h"
#include "core/chart/curve_words.h"
#include "core/chart/few_summits.h"
#include "core/scene/effects.h"

namespace asperity {
namespace {

constexpr double kSlim = 0.42;  // height of the difference, of the curves'
constexpr double kAir = 1.3;    // factor between the outermost points and the frame

/// Curves are of the deformation, also where local friction stands beside it.
Message nameOfMean(const NamedCurve& curve) {
  const std::vector<CurvePoint>& points = curve.points;
  const bool isPart = hasLocalFriction(curve.scene);
  if (points.empty() || points.front().realizations <= 1)
    return isPart ? "this line, deformation alone" : "this line";
  const std::int64_t lines = points.front().realizations;
  return isPart ? message("mean of {} lines \u00B1 standard error, deformation alone", lines)
                : message("mean of {} lines \u00B1 standard error", lines);
}

DiagramSeries seriesOf(const NamedCurve& curve, CurveAxes axes) {
  const auto [velocity, friction] = factorsOf(curve.points, axes);
  DiagramSeries series;
  for (const CurvePoint& point : curve.points) {
    if (point.realizations < 1) continue;
    const double mu = point.mu * friction, error = point.muStandardError * friction;
    series.points.push_back({point.velocity * velocity, mu, mu - error, mu + error});
  }
  return series;
}

DiagramSeries lawOf(const NamedCurve& curve, CurveAxes axes) {
  const auto [velocity, friction] = factorsOf(curve.points, axes);
  DiagramSeries law;
  law.name = "Eq. (11)";
  law.isTheory = true;
  for (const CurvePoint& point : curve.points)
    if (std::isfinite(point.muLaw))
      law.points.push_back({point.velocity * velocity, point.muLaw * friction});
  return law;
}

DiagramSeries pinnedSeries(const NamedCurve& curve, CurveAxes axes) {
  constexpr std::array marks{SeriesMark::Square, SeriesMark::Triangle, SeriesMark::Diamond};
  DiagramSeries series = seriesOf(curve, axes);
  series.name = curve.name;
  series.colour = colourOfPin(curve.place);
  // Another mark where colours repeat.
  const int turn = curve.place + curve.place / kPinColours;
  series.mark = marks[static_cast<std::size_t>(turn) % marks.size()];
  return series;
}

void addRegions(Diagram& diagram, const NamedCurve& curve, CurveAxes axes) {
  const double factor = factorsOf(curve.points, axes).velocity;
  if (!std::isfinite(factor)) return;
  for (const CurveRegion& region : regionsOfCurve(curve.scene, curve.points))
    diagram.spans.push_back({region.from * factor, region.to * factor,
                             message("{} {}", region.name, Message(wordOfRegion(region.name)))});
  addFewSummits(diagram, fewSummitsOf(curve.scene, curve.points), factor);
}

Diagram curvesDiagram(const CurveSet& set) {
  Diagram diagram;
  const bool isPhysical = set.axes == CurveAxes::Physical;
  diagram.x = isPhysical
                  ? DiagramAxis{"sliding velocity v", "m/s"}
                  : DiagramAxis{"dimensionless velocity v\u0304 = \u03C4 v \u2207z / (\u221A2 h)"};
  diagram.y = {isPhysical ? "coefficient of friction \u03BC"
                          : "normalized friction \u03BC / \u2207z"};
  diagram.x.from = set.xFrom;
  diagram.x.to = set.xTo;
  diagram.y.from = set.yFrom;
  diagram.y.to = set.yTo;
  DiagramSeries law = lawOf(set.present, set.axes);
  if (!law.points.empty()) diagram.series.push_back(std::move(law));
  for (const NamedCurve& curve : set.pinned)
    diagram.series.push_back(pinnedSeries(curve, set.axes));
  DiagramSeries mean = seriesOf(set.present, set.axes);
  mean.name = nameOfMean(set.present);
  mean.mark = SeriesMark::Circle;
  mean.colour = 0;
  diagram.series.push_back(std::move(mean));
  addRegions(diagram, set.present, set.axes);
  return diagram;
}

/// The same range for all that share an axis: that of the curves, with some air.
void fixAlong(Diagram& diagram) {
  if (diagram.x.from < diagram.x.to) return;
  double low = 0, high = 0;
  for (const DiagramSeries& series : diagram.series)
    for (const DiagramPoint& point : series.points) {
      if (!std::isfinite(point.x) || !std::isfinite(point.y) || point.x <= 0 || point.y <= 0)
        continue;
      low = high > 0 ? std::min(low, point.x) : point.x;
      high = std::max(high, point.x);
    }
  if (!(high > low)) return;
  diagram.x.from = low / kAir;
  diagram.x.to = high * kAir;
}

/// In per cent, over the axis of the curves.
Diagram differenceDiagram(const CurveSet& set, const DiagramAxis& along) {
  Diagram diagram;
  diagram.height = kSlim;
  diagram.x = along;
  diagram.y = {"difference", "%", AxisScale::Linear};
  const double factor = factorsOf(set.present.points, set.axes).velocity;
  DiagramSeries series, none;
  series.name = message("{} minus the curve above", nameOf(set.difference->setting));
  series.mark = SeriesMark::Diamond;
  series.colour = colourOfPin(kPinColours - 1);
  none.isTheory = true;
  for (const DifferencePoint& point : set.difference->points) {
    const double value = 100 * point.relative, error = 100 * point.standardError;
    series.points.push_back({point.velocity * factor, value, value - error, value + error});
    none.points.push_back({point.velocity * factor, 0});
  }
  diagram.series = {std::move(none), std::move(series)};
  return diagram;
}

}  // namespace

DiagramSheet curveSheet(const Scene& scene, std::span<const CurvePoint> points) {
  CurveSet set;
  set.present = {{}, scene, {points.begin(), points.end()}};
  return curveSheet(set);
}

DiagramSheet curveSheet(const CurveSet& set) {
  const Scene& scene = set.present.scene;
  DiagramSheet sheet;
  sheet.title = scene.title.empty() ? Message("Friction over velocity") : Message(scene.title);
  sheet.subtitle = parametersInWords(scene);
  sheet.diagrams = {curvesDiagram(set)};
  std::vector<Message> notes;
  if (!sheet.diagrams.front().spans.empty())
    notes.emplace_back(
        "Regions as read from the curve: I ends 20 % below its line, III lies above 95 % of the "
        "maximum.");
  if (!sheet.diagrams.front().shades.empty()) notes.emplace_back(kFewSummitsSentence);
  sheet.note = sentences(notes);
  if (set.difference) {
    fixAlong(sheet.diagrams.front());
    sheet.diagrams.push_back(differenceDiagram(set, sheet.diagrams.front().x));
    sheet.columns = 1;
    sheet.sharesAxis = true;
  }
  return sheet;
}

}  // namespace asperity
