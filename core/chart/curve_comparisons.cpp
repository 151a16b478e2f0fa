#include "core/chart/curve_comparisons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/intervals.h"
#include "core/base/number_text.h"
#include "core/chart/curve_diagram.h"

namespace asperity {
namespace {

constexpr double kStripHeight = 0.42;                           // relative to the curves' height
constexpr double kLowestPercent = -100, kHighestPercent = 200;  // of the axis of a difference
constexpr double kMinPercent = 0.1;

/// Returns the shown quantity by a theory; NaN where the theory does not apply.
double ordinate(const TheoryPoint& point, const CurveSet& set) {
  return set.axes == CurveAxes::Dimensionless ? point.mu : point.value(set.y);
}

/// Returns why a theory has no line; empty where it has one.
Message whyMissing(const TheoryCurve& theory, const CurveSet& set) {
  const auto isKnown = [&](const TheoryPoint& point) {
    return std::isfinite(ordinate(point, set));
  };
  if (std::ranges::any_of(theory.points, [&](const TheoryPoint& point) {
        return point.isInRange && isKnown(point);
      }))
    return {};
  const Message name(theoryEntry(theory.theory).name);
  return std::ranges::any_of(theory.points, isKnown)
             ? message("Not drawn: {}, which does not apply anywhere on this axis.", name)
             : message("Not drawn: {}, which does not predict this quantity in this scene.", name);
}

constexpr std::array kMeasuredMarks{SeriesMark::Square, SeriesMark::Diamond, SeriesMark::Triangle,
                                    SeriesMark::Circle};

/// A quantity that tells the points of a table apart, and its value as it is printed.
struct Distinction {
  double MeasuredPoint::*value;
  std::string (*text)(double value);

  std::string textOf(const MeasuredPoint& point) const { return text(point.*value); }
};
constexpr std::array kLoads{
    Distinction{&MeasuredPoint::normalForce, [](double n) { return printedQuantity(n, "N", 3); }},
    Distinction{&MeasuredPoint::nominalPressure,
                [](double pa) { return printedQuantity(pa, "Pa", 3); }}};
constexpr Distinction kTemperature{&MeasuredPoint::temperature,
                                   [](double kelvin) { return celsius(kelvin).english(); }};

/// Returns the values of the quantity in a table as they are printed, rising, if all points have
/// one and there are several but no more than marks; else one empty text, which means all points.
std::vector<std::string> fewValues(const MeasuredCurve& measured, const Distinction& by) {
  std::vector<MeasuredPoint> points = measured.data.points;
  const std::vector<std::string> one(1);
  if (std::ranges::any_of(points,
                          [&](const MeasuredPoint& point) { return std::isnan(point.*by.value); }))
    return one;
  std::ranges::sort(points, {}, by.value);
  std::vector<std::string> texts;
  for (const MeasuredPoint& point : points)
    if (std::string text = by.textOf(point); texts.empty() || texts.back() != text)
      texts.push_back(std::move(text));
  return texts.size() > 1 && texts.size() <= kMeasuredMarks.size() ? texts : one;
}

/// The points of one table with one load and one temperature, each as it is printed; empty: any.
struct MeasuredPart {
  const Distinction* load = nullptr;
  std::string loadText{}, temperature{};

  bool has(const MeasuredPoint& point) const {
    return (loadText.empty() || load->textOf(point) == loadText) &&
           (temperature.empty() || kTemperature.textOf(point) == temperature);
  }
  Message name(const std::string& table) const {
    Message name(table);
    for (const std::string& text : {loadText, temperature})
      if (!text.empty()) name = message("{}, {}", name, PrintedNumber{text});
    return name;
  }
};

/// Returns the quantity that tells the loads of a table apart; null where none does, and on an axis
/// of another key than velocity, which may be the load.
const Distinction* loadOf(const MeasuredCurve& measured, const CurveSet& set) {
  const auto found = std::ranges::find_if(
      kLoads, [&](const Distinction& by) { return fewValues(measured, by).size() > 1; });
  return set.isOfVelocity() && found != kLoads.end() ? &*found : nullptr;
}

/// Makes the series of the measured points: one for each table, or for each load and each
/// temperature of a table. A table, and each load of it, has a colour of its own, which no pinned
/// curve changes: points under another load than that of the scene do not lie on its curve. Each
/// temperature has a mark. place(k, i): of point i of table k, with its row.
template <class Place>
void addMeasuredSeries(Diagram& diagram, const CurveSet& set, const Place& place) {
  int colour = 0;
  for (std::size_t k = 0; k < set.measured.size(); ++k) {
    const MeasuredCurve& measured = set.measured[k];
    const Distinction* const load = loadOf(measured, set);
    const std::vector<std::string> temperatures = fewValues(measured, kTemperature);
    const std::vector<std::string> loads =
        load ? fewValues(measured, *load) : std::vector<std::string>(1);
    for (std::size_t i = 0; i < loads.size(); ++i, ++colour)
      for (std::size_t j = 0; j < temperatures.size(); ++j) {
        const MeasuredPart part{load, loads[i], temperatures[j]};
        DiagramSeries series;
        series.name = part.name(measured.data.name);
        series.stroke = SeriesStroke::None;
        series.mark =
            kMeasuredMarks[(k + (temperatures.size() > 1 ? j : i)) % kMeasuredMarks.size()];
        series.colour = measuredColour(colour);
        for (std::size_t row = 0; row < measured.abscissas.size(); ++row)
          if (part.has(measured.data.points[row])) series.points.push_back(place(k, row));
        series.id = kMeasuredCurves - static_cast<int>(k);
        if (!series.points.empty()) diagram.series.push_back(std::move(series));
      }
  }
}

/// Returns ends around all ratios and 1, so that no mark is cut: on a logarithmic axis whole
/// decades, which have numbers.
void fixRatioAxis(DiagramAxis& axis, const std::vector<DiagramSeries>& series) {
  Extent ratios{1, 1}, bars{1, 1};
  for (const DiagramSeries& one : series)
    for (const DiagramPoint& point : one.points) {
      ratios.add(point.y);
      for (const double value : {point.y, point.low, point.high}) bars.add(value);
    }
  // On a linear axis all ratios but the largest would lie on the line of 1.
  constexpr double kDecade = 10, kMargin = 0.08;
  if (ratios.least > 0 && ratios.most >= kDecade * ratios.least) {
    axis.scale = AxisScale::Logarithmic;
    axis.from = std::pow(kDecade, std::floor(std::log10(ratios.least / kLogMargin)));
    axis.to = std::pow(kDecade, std::ceil(std::log10(ratios.most * kLogMargin)));
    return;
  }
  const double margin = kMargin * std::max(bars.size(), kMargin);
  axis.from = bars.least - margin;
  axis.to = bars.most + margin;
}

/// Sets ends around all values and 0, limited to a readable range.
void fixDifferenceAxis(DiagramAxis& axis, const DiagramSeries& series) {
  constexpr double kAround = 1.1, kBesideZero = 0.15;
  Extent values{0, 0};
  for (const DiagramPoint& point : series.points)
    if (std::isfinite(point.y))
      for (const double value : {point.y, point.low, point.high}) values.add(value);
  const double least = kBesideZero * std::max({-values.least, values.most, kMinPercent});
  axis.from = std::max(-std::max(-kAround * values.least, least), kLowestPercent);
  axis.to = std::min(std::max(kAround * values.most, least), kHighestPercent);
}

}  // namespace

void addTheories(Diagram& diagram, const CurveSet& set) {
  const auto [velocity, friction] = axesFactors(set.present.points, set.axes);
  for (std::size_t k = 0; k < set.theories.size(); ++k) {
    const TheoryCurve& theory = set.theories[k];
    DiagramSeries series{.name = theoryEntry(theory.theory).name,
                         .stroke = theory.theory == Theory::Eq11 ? SeriesStroke::Solid
                                   : theory.theory == Theory::CompleteContact
                                       ? SeriesStroke::Dotted
                                       : SeriesStroke::Dashed,
                         .isTheory = theory.theory != Theory::PerssonHalfSpace};
    if (!series.isTheory) series.colour = kColourOfHalfSpace;
    series.id = theory.theory == Theory::Eq11 ? kLawCurve : kTheoryCurves - static_cast<int>(k);
    for (const TheoryPoint& point : theory.points) {
      const double y = point.isInRange ? ordinate(point, set) * friction : kNotApplicable;
      series.points.push_back({set.isOfVelocity() ? point.velocity * velocity : point.swept, y});
    }
    if (whyMissing(theory, set).empty()) diagram.series.push_back(std::move(series));
  }
}

std::vector<Message> theoryNotes(const CurveSet& set) {
  std::vector<Message> notes;
  for (const TheoryCurve& theory : set.theories)
    if (Message reason = whyMissing(theory, set); !reason.empty())
      notes.push_back(std::move(reason));
    else if (theory.theory != Theory::Eq11)
      notes.emplace_back(theoryEntry(theory.theory).range);
  return notes;
}

void addMeasured(Diagram& diagram, const CurveSet& set) {
  const AxesFactors factors = axesFactors(set.present.points, set.axes);
  addMeasuredSeries(diagram, set, [&](std::size_t k, std::size_t i) {
    const MeasuredCurve& measured = set.measured[k];
    const MeasuredPoint& point = measured.data.points[i];
    const double friction = measuredFactor(measured, i, set, factors);
    return DiagramPoint{measured.abscissas[i] * factors.velocity, point.mu * friction,
                        (point.mu - point.muError) * friction,
                        (point.mu + point.muError) * friction, static_cast<int>(i)};
  });
}

bool hasResiduals(const CurveSet& set) {
  return std::ranges::any_of(
      set.measured, [](const MeasuredCurve& measured) { return !measured.computed.empty(); });
}

Diagram residualDiagram(const CurveSet& set, const DiagramAxis& x) {
  Diagram diagram{
      .x = x, .y = {"measured / computed", "", AxisScale::Linear}, .height = kStripHeight};
  const double factor = axesFactors(set.present.points, set.axes).velocity;
  addMeasuredSeries(diagram, set, [&](std::size_t k, std::size_t i) {
    const MeasuredCurve& measured = set.measured[k];
    const MeasuredPoint& point = measured.data.points[i];
    const double whole = measured.computedMu(i);
    return DiagramPoint{measured.abscissas[i] * factor, point.mu / whole,
                        (point.mu - point.muError) / whole, (point.mu + point.muError) / whole,
                        static_cast<int>(i)};
  });
  for (DiagramSeries& series : diagram.series) {
    series.name = {};
    series.id = -1;
  }
  fixRatioAxis(diagram.y, diagram.series);
  DiagramSeries one{.isTheory = true, .points = {{x.from, 1}, {x.to, 1}}};
  diagram.series.insert(diagram.series.begin(), std::move(one));
  return diagram;
}

Diagram differenceDiagram(const CurveSet& set, const DiagramAxis& x) {
  Diagram diagram{
      .x = x, .y = {"difference \u0394", "%", AxisScale::Linear}, .height = kStripHeight};
  const double factor = axesFactors(set.present.points, set.axes).velocity;
  DiagramSeries series{
      .name = message("{} minus the curve above", settingName(set.difference->setting)),
      .mark = SeriesMark::Diamond,
      .colour = pinColour(kPinColours - 1),
      .id = kDifferenceCurve};
  DiagramSeries zero{.isTheory = true};
  for (std::size_t i = 0; i < set.difference->points.size(); ++i) {
    const DifferencePoint& point = set.difference->points[i];
    series.points.push_back(pointWithError(point.velocity * factor, 100 * point.relative,
                                           100 * point.standardError, static_cast<int>(i)));
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

}  // namespace asperity
