#include "core/chart/contact_fraction_diagram.h"

#include <cmath>

#include "core/chart/curve_diagram.h"
#include "core/chart/curve_words.h"

namespace asperity {
namespace {

DiagramSeries seriesOf(const NamedCurve& curve, double factor) {
  DiagramSeries series;
  series.id = curve.id;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const CurvePoint& point = curve.points[i];
    if (point.realizations < 1) continue;
    series.points.push_back({point.velocity * factor, point.contactFraction, kNotApplicable,
                             kNotApplicable, static_cast<int>(i)});
  }
  return series;
}

}  // namespace

DiagramSheet contactFractionSheet(const CurveSet& set) {
  const Scene& scene = set.present.scene;
  const AxesFactors factors = factorsOf(set.present.points, set.axes);
  Diagram diagram;
  diagram.x = xAxisOf(set);
  diagram.y = {"contact fraction"};
  diagram.series = theorySeries(set, &TheoryPoint::contactFraction, {factors.velocity, 1});
  for (const NamedCurve& pinned : set.pinned) {
    DiagramSeries series = seriesOf(pinned, factorsOf(pinned.points, set.axes).velocity);
    series.name = pinned.name;
    series.colour = colourOfPin(pinned.place);
    series.mark = SeriesMark::Square;
    diagram.series.push_back(std::move(series));
  }
  const std::int64_t lines =
      set.present.points.empty() ? 0 : set.present.points.front().realizations;
  DiagramSeries present = seriesOf(set.present, factors.velocity);
  present.name = lines > 1 ? message("mean of {} lines", lines) : Message("this line");
  present.mark = SeriesMark::Circle;
  present.colour = 0;
  present.id = kPresentCurve;
  diagram.series.push_back(std::move(present));
  DiagramSheet sheet;
  sheet.title =
      scene.title.empty() ? Message("Contact fraction over velocity") : Message(scene.title);
  sheet.subtitle = parametersInWords(scene);
  sheet.note = sentences(rangesOfTheories(set));
  sheet.diagrams = {std::move(diagram)};
  return sheet;
}

}  // namespace asperity
