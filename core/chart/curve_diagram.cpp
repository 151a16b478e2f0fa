#include "core/chart/curve_diagram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/chart/curve_regions.h"
#include "core/chart/curve_words.h"
#include "core/fit/derivatives.h"
#include "core/scene/effects.h"

namespace asperity {
namespace {

constexpr double kDifferenceHeight = 0.42;  // relative to the curves' height
constexpr double kAir = 1.3;                // factor between the outermost points and the frame
constexpr double kLowestPercent = -100, kHighestPercent = 200;  // of the axis of a difference
constexpr double kLeastPercent = 0.1;
constexpr int kLawPoints = 160;

/// Returns the name of the mean. Curves show the friction of the deformation, also where there is
/// local friction.
Message nameOfMean(const NamedCurve& curve) {
  const std::vector<CurvePoint>& points = curve.points;
  const bool isPart = hasLocalFriction(curve.scene);
  if (points.empty() || points.front().realizations <= 1)
    return isPart ? "this line, deformation alone" : "this line";
  const std::int64_t lines = points.front().realizations;
  return isPart ? message("mean of {} lines \u00B1 standard error, deformation alone", lines)
                : message("mean of {} lines \u00B1 standard error", lines);
}

/// Returns a point on the axes. It has its own factors: lines with different slopes have different
/// factors at each velocity.
DiagramPoint pointOf(const CurvePoint& point, CurveAxes axes, int row) {
  if (axes == CurveAxes::Physical)
    return {point.velocity, point.mu, point.mu - point.muStandardError,
            point.mu + point.muStandardError, row};
  const double error = point.muStandardError * point.normalizedMu / point.mu;
  return {point.dimensionlessVelocity, point.normalizedMu, point.normalizedMu - error,
          point.normalizedMu + error, row};
}

/// Returns the known points with error bars.
DiagramSeries meanSeries(const NamedCurve& curve, CurveAxes axes) {
  DiagramSeries series;
  for (std::size_t i = 0; i < curve.points.size(); ++i)
    if (curve.points[i].realizations > 0)
      series.points.push_back(pointOf(curve.points[i], axes, static_cast<int>(i)));
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
  const auto [velocity, friction] = factorsOf(curve.points, axes);
  DiagramSeries law;
  law.name = "Eq. (11)";
  law.isTheory = true;
  law.id = kLawCurve;
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

/// Returns a pinned curve. It keeps its colour and mark when others leave; where colours repeat,
/// mark and stroke differ.
DiagramSeries pinnedSeries(const NamedCurve& curve, CurveAxes axes) {
  constexpr std::array marks{SeriesMark::Square, SeriesMark::Triangle, SeriesMark::Diamond};
  DiagramSeries series = meanSeries(curve, axes);
  series.name = curve.name;
  series.id = curve.id;
  series.colour = colourOfPin(curve.place);
  const int turn = curve.place / kPinColours;
  series.mark = marks[static_cast<std::size_t>(curve.place + 2 * turn) % marks.size()];
  if (turn % 2 == 1) series.stroke = SeriesStroke::Dashed;
  return series;
}

void addRegions(Diagram& diagram, const NamedCurve& curve, CurveAxes axes) {
  const double factor = factorsOf(curve.points, axes).velocity;
  if (!std::isfinite(factor)) return;
  const auto few = fewSummitsOf(curve.scene, curve.points);
  for (const CurveRegion& region : regionsOfCurve(curve.scene, curve.points)) {
    DiagramSpan span{region.from * factor, region.to * factor,
                     message("{} {}", region.name, Message(wordOfRegion(region.name))),
                     region.name};
    span.notes = {sentenceOfRegion(region.name),
                  "Borders are read from this curve, not from theory."};
    if (few && region.name == "IV") span.notes.emplace_back(kFewSummitsSentence);
    diagram.spans.push_back(std::move(span));
  }
  addFewSummits(diagram, few, factor);
}

/// Tints the velocities at which friction rests on frequencies that were not measured.
void addExtrapolated(Diagram& diagram, const NamedCurve& curve, CurveAxes axes) {
  const double factor = factorsOf(curve.points, axes).velocity;
  if (!std::isfinite(factor)) return;
  const std::vector<CurvePoint>& points = curve.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].extrapolated != 1) continue;
    std::size_t last = i;
    while (last + 1 < points.size() && points[last + 1].extrapolated == 1) ++last;
    // Up to the middle between the points at which it begins and ends.
    const auto border = [&](std::size_t inside, std::size_t outside) {
      return std::sqrt(points[inside].velocity * points[outside].velocity);
    };
    const double from = i > 0 ? border(i, i - 1) : points[i].velocity;
    const double to = last + 1 < points.size() ? border(last, last + 1) : points[last].velocity;
    diagram.shades.push_back(
        {from * factor, to * factor, "beyond the measured frequencies", {}, {}});
    i = last;
  }
}

bool isOnLogarithmicAxes(const DiagramPoint& point) {
  return std::isfinite(point.x) && std::isfinite(point.y) && point.x > 0 && point.y > 0;
}

/// Returns why none of the present curve's points is on the axes; empty where one is.
Message blankOf(const NamedCurve& curve, CurveAxes axes) {
  const auto isShown = [&](CurveAxes on) {
    return std::ranges::any_of(meanSeries(curve, on).points, isOnLogarithmicAxes);
  };
  if (curve.points.empty() || isShown(axes)) return {};
  if (std::ranges::all_of(curve.points, [](const CurvePoint& point) {
        return point.realizations < 1 || point.mu == 0;
      }))
    return "no friction: nothing positive to show on a logarithmic axis";
  if (axes == CurveAxes::Dimensionless && isShown(CurveAxes::Physical))
    return "no dimensionless axes: they need a line with roughness and one relaxation time";
  return "no positive coefficient of friction to show on a logarithmic axis";
}

constexpr std::array kMeasuredMarks{SeriesMark::Square, SeriesMark::Diamond, SeriesMark::Triangle};

/// Marks and colours that no curve of the set has.
DiagramSeries measuredSeries(const CurveSet& set, std::size_t k) {
  DiagramSeries series;
  series.name = set.measured[k].data.name;
  series.stroke = SeriesStroke::None;
  series.mark = kMeasuredMarks[k % kMeasuredMarks.size()];
  series.colour = colourOfPin(static_cast<int>(set.pinned.size() + k));
  return series;
}

/// Points with error bars.
void addMeasured(Diagram& diagram, const CurveSet& set) {
  const auto [velocity, friction] = factorsOf(set.present.points, set.axes);
  for (std::size_t k = 0; k < set.measured.size(); ++k) {
    const MeasuredCurve& measured = set.measured[k];
    DiagramSeries series = measuredSeries(set, k);
    series.id = kMeasuredCurves - static_cast<int>(k);
    for (std::size_t i = 0; i < measured.velocities.size(); ++i) {
      const MeasuredPoint& point = measured.data.points[i];
      series.points.push_back({measured.velocities[i] * velocity, point.mu * friction,
                               (point.mu - point.muError) * friction,
                               (point.mu + point.muError) * friction, static_cast<int>(i)});
    }
    diagram.series.push_back(std::move(series));
  }
}

/// Measured over computed friction at each measured point, over the axis of the curves.
Diagram residualDiagram(const CurveSet& set, const DiagramAxis& x) {
  Diagram diagram;
  diagram.height = kDifferenceHeight;
  diagram.x = x;
  diagram.y = {"measured / computed", "", AxisScale::Linear};
  const double factor = factorsOf(set.present.points, set.axes).velocity;
  DiagramSeries one;
  one.isTheory = true;
  one.points = {{x.from, 1}, {x.to, 1}};
  diagram.series.push_back(std::move(one));
  for (std::size_t k = 0; k < set.measured.size(); ++k) {
    const MeasuredCurve& measured = set.measured[k];
    DiagramSeries series = measuredSeries(set, k);
    series.name = {};
    for (std::size_t i = 0; i < measured.computed.size(); ++i) {
      const double whole = totalMu(measured.computed[i]);
      const MeasuredPoint& point = measured.data.points[i];
      series.points.push_back({measured.velocities[i] * factor, point.mu / whole,
                               (point.mu - point.muError) / whole,
                               (point.mu + point.muError) / whole, static_cast<int>(i)});
    }
    diagram.series.push_back(std::move(series));
  }
  return diagram;
}

Diagram curvesDiagram(const CurveSet& set) {
  Diagram diagram;
  const bool isPhysical = set.axes == CurveAxes::Physical;
  diagram.x = xAxisOf(set);
  diagram.y = {isPhysical ? "coefficient of friction \u03BC"
                          : "normalized friction \u03BC / \u2207z"};
  diagram.y.from = set.yFrom;
  diagram.y.to = set.yTo;
  DiagramSeries law = lawSeries(set.present, set.axes);
  if (!law.points.empty() && showsLaw(set.present.scene)) diagram.series.push_back(std::move(law));
  std::ranges::move(theorySeries(set, &TheoryPoint::mu, factorsOf(set.present.points, set.axes)),
                    std::back_inserter(diagram.series));
  for (const NamedCurve& curve : set.pinned)
    diagram.series.push_back(pinnedSeries(curve, set.axes));
  DiagramSeries mean = meanSeries(set.present, set.axes);
  mean.name = nameOfMean(set.present);
  mean.mark = SeriesMark::Circle;
  mean.colour = 0;
  mean.id = kPresentCurve;
  diagram.series.push_back(std::move(mean));
  addMeasured(diagram, set);
  addRegions(diagram, set.present, set.axes);
  addExtrapolated(diagram, set.present, set.axes);
  diagram.blank = blankOf(set.present, set.axes);
  return diagram;
}

/// Sets the same x-range for all diagrams that share the axis: the range of the curves, with a
/// margin.
void fixAlong(Diagram& diagram) {
  if (diagram.x.from < diagram.x.to) return;
  double low = 0, high = 0;
  for (const DiagramSeries& series : diagram.series)
    for (const DiagramPoint& point : series.points) {
      if (!isOnLogarithmicAxes(point)) continue;
      low = high > 0 ? std::min(low, point.x) : point.x;
      high = std::max(high, point.x);
    }
  if (!(high > low)) return;
  diagram.x.from = low / kAir;
  diagram.x.to = high * kAir;
}

/// Sets ends around all values and 0, limited to a readable range.
void fixDifferenceAxis(DiagramAxis& axis, const DiagramSeries& series) {
  constexpr double kAround = 1.1, kBesideZero = 0.15;
  double low = 0, high = 0;
  for (const DiagramPoint& point : series.points) {
    if (!std::isfinite(point.y)) continue;
    low = std::min({low, point.y, std::isfinite(point.low) ? point.low : point.y});
    high = std::max({high, point.y, std::isfinite(point.high) ? point.high : point.y});
  }
  const double least = kBesideZero * std::max({-low, high, kLeastPercent});
  axis.from = std::max(-std::max(-kAround * low, least), kLowestPercent);
  axis.to = std::min(std::max(kAround * high, least), kHighestPercent);
}

/// Makes the diagram of the difference in per cent, over the axis of the curves. A value beyond the
/// axis is a triangle at its end.
Diagram differenceDiagram(const CurveSet& set, const DiagramAxis& x) {
  Diagram diagram;
  diagram.height = kDifferenceHeight;
  diagram.x = x;
  diagram.y = {"difference \u0394", "%", AxisScale::Linear};
  const double factor = factorsOf(set.present.points, set.axes).velocity;
  DiagramSeries series, zero;
  series.name = message("{} minus the curve above", nameOf(set.difference->setting));
  series.mark = SeriesMark::Diamond;
  series.colour = colourOfPin(kPinColours - 1);
  series.id = kDifferenceCurve;
  zero.isTheory = true;
  for (std::size_t i = 0; i < set.difference->points.size(); ++i) {
    const DifferencePoint& point = set.difference->points[i];
    const double value = 100 * point.relative, error = 100 * point.standardError;
    series.points.push_back(
        {point.velocity * factor, value, value - error, value + error, static_cast<int>(i)});
    zero.points.push_back({point.velocity * factor, 0});
  }
  fixDifferenceAxis(diagram.y, series);
  DiagramSeries beyond = series;
  beyond.name = {};
  beyond.mark = SeriesMark::Triangle;
  beyond.stroke = SeriesStroke::None;
  beyond.points.clear();
  const DiagramAxis& axis = diagram.y;
  for (const DiagramPoint& point : series.points)
    if (std::isfinite(point.y) && (point.y < axis.from || point.y > axis.to))
      beyond.points.push_back({point.x, std::clamp(point.y, axis.from, axis.to), kNotApplicable,
                               kNotApplicable, point.row});
  diagram.series = {std::move(zero), std::move(series)};
  if (!beyond.points.empty()) diagram.series.push_back(std::move(beyond));
  return diagram;
}

}  // namespace

DiagramAxis xAxisOf(const CurveSet& set) {
  const bool isPhysical = set.axes == CurveAxes::Physical;
  DiagramAxis axis =
      isPhysical ? DiagramAxis{"sliding velocity v", "m/s"}
                 : DiagramAxis{"dimensionless velocity v\u0304 = \u03C4 v \u2207z / (\u221A2 h)"};
  axis.from = set.xFrom;
  axis.to = set.xTo;
  if (set.isReduced && isPhysical)
    axis.title = message("reduced sliding velocity a_T v at {:.4g} K",
                         set.present.scene.elastomer.temperature);
  return axis;
}

std::vector<DiagramSeries> theorySeries(const CurveSet& set, double TheoryPoint::*value,
                                        const AxesFactors& factors) {
  constexpr int kColourOfHalfSpace = kPinColours - 2;
  std::vector<DiagramSeries> all;
  for (std::size_t k = 0; k < set.theories.size(); ++k) {
    const TheoryCurve& theory = set.theories[k];
    DiagramSeries series;
    series.name = entryOf(theory.theory).name;
    series.isTheory = theory.theory != Theory::PerssonHalfSpace;
    series.stroke =
        theory.theory == Theory::CompleteContact ? SeriesStroke::Dotted : SeriesStroke::Dashed;
    if (!series.isTheory) series.colour = colourOfPin(kColourOfHalfSpace);
    series.id = kTheoryCurves - static_cast<int>(k);
    bool isSeen = false;
    for (const TheoryPoint& point : theory.points) {
      const double y = point.isInRange ? point.*value * factors.friction : kNotApplicable;
      series.points.push_back({point.velocity * factors.velocity, y});
      isSeen |= std::isfinite(y);
    }
    if (isSeen) all.push_back(std::move(series));
  }
  return all;
}

std::vector<Message> rangesOfTheories(const CurveSet& set) {
  std::vector<Message> ranges;
  for (const TheoryCurve& theory : set.theories) ranges.push_back(entryOf(theory.theory).range);
  return ranges;
}

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
  if (!sheet.diagrams.front().shades.empty() && fewSummitsOf(set.present.scene, set.present.points))
    notes.emplace_back(kFewSummitsSentence);
  if (std::ranges::any_of(set.present.points,
                          [](const CurvePoint& point) { return point.extrapolated == 1; }))
    notes.emplace_back(
        "Beyond the measured frequencies: more than a tenth of the loss rests on frequencies at "
        "which the rubber was not measured.");
  for (Message& range : rangesOfTheories(set)) notes.push_back(std::move(range));
  sheet.note = sentences(notes);
  const bool hasResiduals = std::ranges::any_of(
      set.measured, [](const MeasuredCurve& measured) { return !measured.computed.empty(); });
  if (!set.difference && !hasResiduals) return sheet;
  fixAlong(sheet.diagrams.front());
  const DiagramAxis x = sheet.diagrams.front().x;
  if (hasResiduals) sheet.diagrams.push_back(residualDiagram(set, x));
  if (set.difference) sheet.diagrams.push_back(differenceDiagram(set, x));
  sheet.columns = 1;
  sheet.sharesAxis = true;
  return sheet;
}

}  // namespace asperity
