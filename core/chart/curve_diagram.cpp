#include "core/chart/curve_diagram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/intervals.h"
#include "core/base/number_text.h"
#include "core/chart/curve_comparisons.h"
#include "core/chart/curve_regions.h"
#include "core/chart/curve_words.h"
#include "core/fit/derivatives.h"
#include "core/scene/sweep.h"

namespace asperity {
namespace {

constexpr int kLawPoints = 160;

/// Returns the name of the mean. But for the axis of mu_total, curves show the friction of the
/// deformation, also where there is local friction.
Message meanName(const NamedCurve& curve, const CurveSet& set) {
  const std::vector<CurvePoint>& points = curve.points;
  const bool isPart = hasLocalFriction(curve.scene) && set.quantity() != CurveQuantity::MuTotal;
  if (points.empty() || points.front().realizations <= 1)
    return isPart ? "deformation alone, this line" : "this line";
  const std::int64_t lines = points.front().realizations;
  return isPart ? message("deformation alone, mean of {} lines \u00B1 standard error", lines)
                : message("mean of {} lines \u00B1 standard error", lines);
}

/// Returns the name of the present curve: beside others by the values in which it differs from
/// them, as they are named.
Message presentName(const CurveSet& set) {
  std::vector<Message> words;
  for (const NamedCurve& curve : set.pinned) {
    Message difference = describeDifferences(set.present.scene, curve.scene);
    if (!difference.empty() && std::ranges::find(words, difference) == words.end())
      words.push_back(std::move(difference));
  }
  return words.empty() || words.size() > 3 ? meanName(set.present, set) : listed(words);
}

/// Returns a point on the axes. It has its own factors: lines with different slopes have different
/// factors at each velocity.
DiagramPoint diagramPoint(const CurvePoint& point, const Scene& scene, const CurveSet& set,
                          int row) {
  const double error = point.muStandardError * perFriction(set.quantity(), point);
  return pointWithError(abscissa(point, scene, set), ordinate(point, set), error, row);
}

/// Returns the known points with error bars.
DiagramSeries meanSeries(const NamedCurve& curve, const CurveSet& set) {
  DiagramSeries series;
  for (std::size_t i = 0; i < curve.points.size(); ++i)
    if (curve.points[i].realizations > 0)
      series.points.push_back(diagramPoint(curve.points[i], curve.scene, set, static_cast<int>(i)));
  return series;
}

/// Returns what is measured: friction with local friction, beside that of the deformation.
DiagramSeries totalSeries(const CurveSet& set) {
  DiagramSeries series{.name = "with local friction",
                       .mark = SeriesMark::Diamond,
                       .stroke = SeriesStroke::Dashed,
                       .colour = 0,
                       .id = kTotalCurve};
  for (std::size_t i = 0; i < set.present.points.size(); ++i) {
    const CurvePoint& point = set.present.points[i];
    const double factor = perFriction(set.quantity(), point);
    if (point.realizations > 0)
      series.points.push_back({abscissa(point, set.present.scene, set), totalMu(point) * factor,
                               kNotApplicable, kNotApplicable, static_cast<int>(i)});
  }
  return series;
}

/// Interpolates Eq. (11) between two points of a curve, exactly: in it, 1 / mu^2 is linear in 1 /
/// v^2.
double lawBetween(const CurvePoint& a, const CurvePoint& b, double velocity) {
  const auto inverseSquare = [](double value) { return 1 / (value * value); };
  const double start = inverseSquare(a.velocity), end = inverseSquare(b.velocity);
  const double part = (inverseSquare(velocity) - start) / (end - start);
  return 1 / std::sqrt(std::lerp(inverseSquare(a.muLaw), inverseSquare(b.muLaw), part));
}

/// Samples the law more finely than the sweep, because straight lines between its points would be
/// visible.
DiagramSeries lawSeries(const NamedCurve& curve, CurveAxes axes) {
  const auto [velocity, friction] = axesFactors(curve.points, axes);
  DiagramSeries law{.name = "Eq. (11)", .isTheory = true, .id = kLawCurve};
  const CurvePoint* before = nullptr;
  const int steps = std::max(1, kLawPoints / std::max(1, static_cast<int>(curve.points.size())));
  for (const CurvePoint& point : curve.points) {
    if (!std::isfinite(point.muLaw)) continue;
    const bool isCurved = before && before->muLaw > 0 && point.muLaw > 0 && before->velocity > 0 &&
                          before->velocity != point.velocity;
    for (int k = 1; isCurved && k < steps; ++k) {
      const double between =
          before->velocity * std::pow(point.velocity / before->velocity, double(k) / steps);
      law.points.push_back({between * velocity, lawBetween(*before, point, between) * friction});
    }
    law.points.push_back({point.velocity * velocity, point.muLaw * friction});
    before = &point;
  }
  return law;
}

/// Returns how many of the pinned curves are of the family; they come first.
std::size_t familySize(const CurveSet& set) {
  if (set.familyKey.empty()) return 0;
  return static_cast<std::size_t>(std::ranges::count_if(
      set.pinned, [](const NamedCurve& curve) { return std::isfinite(curve.familyValue); }));
}

/// Returns whether a curve belongs to a large family, whose colours are those of a ramp.
bool isOnRamp(const NamedCurve& curve, const CurveSet& set) {
  constexpr std::size_t kFewCurves = 5;
  return std::isfinite(curve.familyValue) && familySize(set) > kFewCurves;
}

/// Returns the meaning of the colours of a large family; nothing for other sets.
std::optional<DiagramRamp> familyRamp(const CurveSet& set) {
  if (set.pinned.empty() || !isOnRamp(set.pinned.front(), set)) return std::nullopt;
  const Parameter& row = *findParameter(set.familyKey);
  const auto text = [&](const NamedCurve& curve) {
    return message("{}", printedValue(curve.familyValue, row));
  };
  return DiagramRamp{Message(row.label), text(set.pinned.front()),
                     text(set.pinned[familySize(set) - 1])};
}

/// Returns a pinned curve. It keeps its colour and mark when others leave; where colours repeat,
/// mark and stroke differ.
DiagramSeries pinnedSeries(const NamedCurve& curve, const CurveSet& set) {
  constexpr std::array marks{SeriesMark::Circle, SeriesMark::Square, SeriesMark::Triangle,
                             SeriesMark::Diamond};
  constexpr std::array strokes{SeriesStroke::Solid, SeriesStroke::Dashed, SeriesStroke::Dotted};
  DiagramSeries series = meanSeries(curve, set);
  series.name = curve.name;
  series.id = curve.id;
  if (isOnRamp(curve, set)) {
    series.ramp = static_cast<double>(curve.index) / static_cast<double>(familySize(set) - 1);
    // Error bars of many curves cover each other.
    series.dropErrors();
    return series;
  }
  series.colour = pinColour(curve.index);
  // Twelve pairs of marks and strokes, of which the present curve has the first, distinguish curves
  // without colours.
  const auto number = static_cast<std::size_t>(curve.index) + 1;
  series.mark = marks[number % marks.size()];
  series.stroke = strokes[number / marks.size() % strokes.size()];
  return series;
}

void addRegions(Diagram& diagram, const NamedCurve& curve, CurveAxes axes) {
  const double factor = axesFactors(curve.points, axes).velocity;
  if (!std::isfinite(factor)) return;
  const auto few = fewContactsRange(curve.scene, curve.points);
  for (const CurveRegion& region : findRegions(curve.scene, curve.points)) {
    DiagramSpan span{region.from * factor, region.to * factor,
                     message("{} {}", region.name, Message(regionWord(region.name))), region.name};
    span.notes = {regionSentence(region.name),
                  "Borders are read from this curve, not from theory."};
    if (few && region.name == "IV") span.notes.emplace_back(kFewContactsSentence);
    diagram.spans.push_back(std::move(span));
  }
  addFewContacts(diagram, few, factor);
}

/// Tints the part of the axis in which friction rests on frequencies that were not measured.
void addExtrapolated(Diagram& diagram, const CurveSet& set) {
  const std::vector<CurvePoint>& points = set.present.points;
  const auto place = [&](const CurvePoint& point) {
    return abscissa(point, set.present.scene, set);
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].extrapolated != 1) continue;
    std::size_t last = i;
    while (last + 1 < points.size() && points[last + 1].extrapolated == 1) ++last;
    // The tint extends to the middle between the points at which it begins and ends.
    const auto border = [&](std::size_t inside, std::size_t outside) {
      const double a = place(points[inside]), b = place(points[outside]);
      return set.scaleOfX() == AxisScale::Linear ? (a + b) / 2 : std::sqrt(a * b);
    };
    const double from = i > 0 ? border(i, i - 1) : place(points[i]);
    const double to = last + 1 < points.size() ? border(last, last + 1) : place(points[last]);
    if (std::isfinite(from) && std::isfinite(to))
      diagram.shades.push_back(
          {std::min(from, to), std::max(from, to), "beyond the measured frequencies", {}, {}});
    i = last;
  }
}

bool isOnAxes(const DiagramPoint& point, const CurveSet& set) {
  return std::isfinite(axisPosition(set.scaleOfX(), point.x)) &&
         std::isfinite(axisPosition(set.scaleOfY(), point.y));
}

/// Returns why none of the present curve's points is on the axes; empty where one is.
Message blankReason(const CurveSet& set) {
  const std::vector<CurvePoint>& points = set.present.points;
  const auto isShown = [&](const CurveSet& on) {
    return std::ranges::any_of(meanSeries(set.present, on).points,
                               [&](const DiagramPoint& point) { return isOnAxes(point, on); });
  };
  if (points.empty() || isShown(set)) return {};
  CurveSet physical;
  physical.present.scene.sweep = set.present.scene.sweep;
  if (set.axes == CurveAxes::Physical && !quantityEntry(set.y).isFriction)
    return "nothing to show on these axes";
  if (std::ranges::all_of(
          points, [](const CurvePoint& point) { return point.realizations < 1 || point.mu == 0; }))
    return "no friction: nothing positive to show on a logarithmic axis";
  if (set.axes == CurveAxes::Dimensionless && isShown(physical))
    return "no dimensionless axes: they need a line with roughness and one relaxation time";
  return "no positive coefficient of friction to show on a logarithmic axis";
}

/// Sets title, unit, scale and range of both axes.
void setAxes(Diagram& diagram, const CurveSet& set) {
  const bool isPhysical = set.axes == CurveAxes::Physical;
  const Parameter& row = sweptParameter(set.present.scene);
  diagram.x = isPhysical
                  ? DiagramAxis{parameterTitle(row.key), std::string(row.unit)}
                  : DiagramAxis{"dimensionless velocity v\u0304 = \u03C4 v \u2207z / (\u221A2 h)"};
  const QuantityEntry& entry = quantityEntry(set.quantity());
  diagram.y = {Message(entry.title), std::string(entry.unit)};
  diagram.x.scale = set.scaleOfX();
  diagram.y.scale = set.scaleOfY();
  diagram.x.from = set.xFrom;
  diagram.x.to = set.xTo;
  diagram.y.from = set.yFrom;
  diagram.y.to = set.yTo;
  if (set.isReduced && isPhysical && set.isOfVelocity())
    diagram.x.title = message("reduced sliding velocity a\u1D1B v at {}",
                              celsius(set.present.scene.elastomer.temperature));
}

/// Returns whether Eq. (11) is drawn from the points of the curve; otherwise it is one of the
/// theories, with many points.
bool drawsLawOfPoints(const CurveSet& set) {
  const bool isAmongTheories = std::ranges::any_of(
      set.theories, [](const TheoryCurve& theory) { return theory.theory == Theory::Eq11; });
  return set.familyKey.empty() && showsLaw(set.present.scene) && !isAmongTheories &&
         set.hasLawInPoints();
}

Diagram curvesDiagram(const CurveSet& set) {
  Diagram diagram;
  setAxes(diagram, set);
  if (drawsLawOfPoints(set))
    if (DiagramSeries law = lawSeries(set.present, set.axes); !law.points.empty())
      diagram.series.push_back(std::move(law));
  addTheories(diagram, set);
  for (const NamedCurve& curve : set.pinned) diagram.series.push_back(pinnedSeries(curve, set));
  diagram.ramp = familyRamp(set);
  // A family needs no present curve: it would be one more, and often one of them again.
  const bool showsOwn = set.familyKey.empty();
  if (showsOwn) {
    DiagramSeries mean = meanSeries(set.present, set);
    mean.name = presentName(set);
    mean.mark = SeriesMark::Circle;
    mean.colour = 0;
    mean.id = kPresentCurve;
    diagram.series.push_back(std::move(mean));
    if (showsTotal(set)) diagram.series.push_back(totalSeries(set));
  }
  addMeasured(diagram, set);
  // The regions belong to the present curve of friction over velocity.
  if (showsOwn && set.isOfVelocity()) addRegions(diagram, set.present, set.axes);
  addExtrapolated(diagram, set);
  diagram.blank = blankReason(set);
  return diagram;
}

/// Returns whether the axes can show none of the points.
bool isEmpty(const Diagram& diagram) {
  return std::ranges::none_of(diagram.series, [&](const DiagramSeries& series) {
    return std::ranges::any_of(
        series.points, [&](const DiagramPoint& point) { return hasPosition(diagram, point); });
  });
}

/// Sets the x-range of the curves, with a margin: the same for all diagrams that share the axis,
/// and that of the sweep where the axes show no point.
void fixAlong(Diagram& diagram) {
  if (diagram.x.from < diagram.x.to) return;
  constexpr double kMargin = 0.04;  // of a linear axis
  const bool isLinear = diagram.x.scale == AxisScale::Linear, isBlank = isEmpty(diagram);
  Extent along;
  for (const DiagramSeries& series : diagram.series)
    for (const DiagramPoint& point : series.points)
      if (isBlank ? std::isfinite(axisPosition(diagram.x.scale, point.x))
                  : hasPosition(diagram, point))
        along.add(point.x);
  if (!(along.most > along.least)) return;
  const double margin = kMargin * along.size();
  diagram.x.from = isLinear ? along.least - margin : along.least / kLogMargin;
  diagram.x.to = isLinear ? along.most + margin : along.most * kLogMargin;
}

/// Sets the ranges of axes that show no point, as of a body without friction.
void setEmptyAxes(Diagram& diagram, CurveQuantity quantity) {
  fixAlong(diagram);
  const bool isAutomatic = diagram.y.from == diagram.y.to;
  if (!isAutomatic || !isCoefficient(quantity) || diagram.y.scale == AxisScale::Linear) return;
  diagram.y.from = kEmptyFrictionFrom;
  diagram.y.to = kEmptyFrictionTo;
}

/// Returns the title of a chart whose scene has none.
Message chartTitle(const CurveSet& set) {
  const Message label(sweptParameter(set.present.scene).label);
  if (set.isOfMu())
    return set.isOfVelocity() ? Message("Friction over velocity")
                              : message("Friction over {}", label);
  return message("{} over {}", Message(quantityEntry(set.y).title), label);
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
  // The name of a scene often mentions its friction over velocity.
  const bool isNamed = set.isOfVelocity() && !scene.title.empty();
  sheet.title = isNamed ? Message(scene.title) : chartTitle(set);
  // A family is drawn without the curve of the scene, whose own value of the key only theories and
  // measured points have.
  std::vector<std::string_view> without;
  if (!set.familyKey.empty() && set.theories.empty() && set.measured.empty())
    without = {set.familyKey};
  sheet.subtitle = isNamed ? describeParameters(scene, without) : describeScene(scene, without);
  sheet.diagrams = {curvesDiagram(set)};
  std::vector<Message> notes;
  if (!sheet.diagrams.front().spans.empty())
    notes.emplace_back(
        "Regions as read from the curve: I ends 20 % below its line, III lies above 95 % of the "
        "maximum.");
  if (set.isOfVelocity() && !sheet.diagrams.front().shades.empty() &&
      fewContactsRange(set.present.scene, set.present.points))
    notes.emplace_back(kFewContactsSentence);
  if (std::ranges::any_of(set.present.points,
                          [](const CurvePoint& point) { return point.extrapolated == 1; }))
    notes.emplace_back(
        "Beyond the measured frequencies: more than a tenth of the loss rests on frequencies at "
        "which the rubber was not measured.");
  for (Message& note : theoryNotes(set)) notes.push_back(std::move(note));
  if (showsTotal(set) && !set.pinned.empty())
    notes.emplace_back(
        "Measured friction holds local friction, the curves of other settings do not: with "
        "mu_total as the vertical axis, all do.");
  for (const NamedCurve& curve : set.pinned)
    if (std::isnan(reduction(curve.scene, set)))
      notes.push_back(message("{} is not shown: its rubber has no shift at {}.", curve.name,
                              celsius(scene.elastomer.temperature)));
  for (const Message& note : set.notes) notes.push_back(message("{}.", note));
  sheet.note = sentences(notes);
  if (isEmpty(sheet.diagrams.front())) setEmptyAxes(sheet.diagrams.front(), set.quantity());
  if (!set.difference && !hasResiduals(set)) return sheet;
  fixAlong(sheet.diagrams.front());
  const DiagramAxis x = sheet.diagrams.front().x;
  if (hasResiduals(set)) sheet.diagrams.push_back(residualDiagram(set, x));
  if (set.difference) sheet.diagrams.push_back(differenceDiagram(set, x));
  sheet.columns = 1;
  sheet.sharesAxis = true;
  return sheet;
}

DiagramSheet withoutCurve(DiagramSheet sheet, double from, double to) {
  sheet.diagrams.resize(1);
  sheet.note = {};
  Diagram& diagram = sheet.diagrams.front();
  std::erase_if(diagram.series,
                [](const DiagramSeries& series) { return series.id <= kPresentCurve; });
  diagram.spans.clear();
  diagram.shades.clear();
  diagram.blank = {};
  diagram.y.from = from;
  diagram.y.to = to;
  return sheet;
}

}  // namespace asperity
