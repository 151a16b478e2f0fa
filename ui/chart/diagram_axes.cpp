#include "ui/chart/diagram_axes.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "core/base/intervals.h"
#include "core/base/text_encoding.h"
#include "ui/draw/fonts.h"
#include "ui/draw/theme.h"

namespace asperity {
namespace {

constexpr double kFarthest = 1e6;  // pixels; keeps coordinates small enough for floats

/// Returns the range that the axis itself prescribes; empty where it prescribes none.
AxisRange prescribedRange(const DiagramAxis& axis) {
  const double a = axisPosition(axis.scale, axis.from), b = axisPosition(axis.scale, axis.to);
  if (axis.from == axis.to || !std::isfinite(a) || !std::isfinite(b)) return {};
  return {std::min(a, b), std::max(a, b)};
}

/// Rounds down (-1) or up (1) to 1, 2 or 5 times a power of ten, as decimal logarithms.
double roundedDecade(double decade, int direction) {
  const double floor = std::floor(decade);
  const double positions[] = {0, std::log10(2.0), std::log10(5.0), 1};
  double best = direction < 0 ? floor : floor + 1;
  for (const double position : positions) {
    if (direction < 0 && floor + position <= decade + 1e-9) best = floor + position;
    if (direction > 0 && floor + position >= decade - 1e-9) return floor + position;
  }
  return best;
}

AxisRange paddedLogarithmic(const Extent& extent, bool upwards) {
  const double size = extent.size();
  if (size < 1e-6) return {extent.least - 0.5, extent.most + 0.5};
  const double pad = (upwards ? 0.04 : 0.02) * size;
  if (!upwards) return {extent.least - pad, extent.most + pad};
  return {roundedDecade(extent.least - pad, -1), roundedDecade(extent.most + pad, 1)};
}

AxisRange paddedLinear(const Extent& extent) {
  double size = extent.size();
  const double largest = std::max(std::abs(extent.most), std::abs(extent.least));
  if (!(size > 1e-9 * largest)) size = largest > 0 ? largest : 1;
  const double pad = 0.06 * size;
  const bool nearZero = extent.least >= 0 && extent.least <= 0.4 * extent.most;
  return {nearZero ? 0 : extent.least - pad, extent.most + pad};
}

AxisRange padded(const DiagramAxis& axis, const Extent& data, const Extent& theory, bool upwards) {
  Extent extent = data.isEmpty() ? theory : data;
  if (extent.isEmpty()) return axis.scale == AxisScale::Linear ? AxisRange{0, 1} : AxisRange{-1, 1};
  if (upwards && !data.isEmpty() && !theory.isEmpty()) {
    const double beyond = 0.25 * data.size();
    extent.add(std::clamp(theory.least, data.least - beyond, data.most));
    extent.add(std::clamp(theory.most, data.least, data.most + beyond));
  }
  return axis.scale == AxisScale::Linear ? paddedLinear(extent)
                                         : paddedLogarithmic(extent, upwards);
}

/// Returns the end of an error bar. On a logarithmic axis it may reach to zero, which is not shown.
double barEnd(AxisScale scale, double end, double value) {
  const double position = axisPosition(scale, end);
  return scale == AxisScale::Logarithmic ? std::max(position, value - 1) : position;
}

/// Returns "position (mm)"; the name alone without a unit.
std::string titleWithUnit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " (" + unit + ")";
}

TickedAxis linearAxis(const DiagramAxis& axis, const AxisRange& range, const AxisTicks& ticks) {
  return {AxisScale::Linear, range, ticks.ticks, minorTicks(ticks, range.from, range.to),
          titleWithUnit(axis.title.text, ticks.unit)};
}

/// Returns a logarithmic axis with ticks at multiples of one step instead of its own.
TickedAxis withLinearTicks(TickedAxis ticked, const DiagramAxis& axis, int most) {
  const AxisTicks linear =
      linearTicks(std::pow(10, ticked.range.from), std::pow(10, ticked.range.to), most, axis.unit);
  ticked.title = titleWithUnit(axis.title.text, linear.unit);
  ticked.ticks.clear();
  ticked.minor.clear();
  for (const Tick& tick : linear.ticks)
    if (tick.value > 0) ticked.ticks.push_back({std::log10(tick.value), tick.label});
  return ticked;
}

/// Puts ticks at multiples of powers of ten; where this gives fewer than two, as on a linear axis.
TickedAxis logarithmicAxis(const DiagramAxis& axis, const AxisRange& range, int most, float pixels,
                           float unit) {
  const std::vector<Tick> ticks = logTicks(range.from, range.to, most);
  TickedAxis ticked{
      AxisScale::Logarithmic, range, ticks, {}, titleWithUnit(axis.title.text, axis.unit)};
  if (ticks.size() < 2) {
    TickedAxis linear = withLinearTicks(ticked, axis, most);
    return linear.ticks.size() > ticks.size() ? linear : ticked;
  }
  ticked.minor = minorLogTicks(range.from, range.to, ticks, pixels / range.size(), 3.0 * unit);
  return ticked;
}

/// Whether the labels of two neighbouring ticks at this distance in pixels have room.
using HaveRoom = std::function<bool(const Tick&, const Tick&, double distance)>;

/// A logarithmic axis whose ticks are chosen by the room that their labels have.
class SparseLogarithmicAxis {
 public:
  SparseLogarithmicAxis(const DiagramAxis& axis, const AxisRange& range, float pixels, float unit)
      : axis_(axis), range_(range), pixels_(pixels), unit_(unit) {}

  /// Returns the axis with up to `most` ticks that are apart. Where these are fewer than three, it
  /// has more of them if they are apart, too. A small axis has the two farthest from each other
  /// that do not touch: a single tick does not show the scale.
  TickedAxis ticked(int most, const HaveRoom& areApart, const HaveRoom& doNotTouch) const {
    const std::optional<TickedAxis> usual = atMost(most, areApart);
    if (usual && std::ssize(usual->ticks) >= kFewTicks) return *usual;
    if (const auto closer = moreThan(most, areApart)) return *closer;
    if (usual) return *usual;
    if (const auto ends = farthestTwo(doNotTouch)) return *ends;
    return singleTick();
  }

 private:
  static constexpr int kMany = 16;

  TickedAxis withTicks(int most) const {
    return logarithmicAxis(axis_, range_, most, pixels_, unit_);
  }

  bool haveRoom(const std::vector<Tick>& ticks, const HaveRoom& test) const {
    for (std::size_t i = 0; i + 1 < ticks.size(); ++i)
      if (!test(ticks[i], ticks[i + 1],
                (ticks[i + 1].value - ticks[i].value) / range_.size() * pixels_))
        return false;
    return ticks.size() > 1;
  }

  std::optional<TickedAxis> atMost(int most, const HaveRoom& areApart) const {
    for (int count = most; count > 1; --count) {
      TickedAxis axis = withTicks(count);
      if (axis.ticks.size() < 2) break;
      if (haveRoom(axis.ticks, areApart)) return axis;
    }
    return {};
  }

  /// Returns three or more ticks that are closer than usual, within a decade also those of a linear
  /// axis; on a longer axis these would all be at its upper end.
  std::optional<TickedAxis> moreThan(int most, const HaveRoom& areApart) const {
    const auto isGood = [&](const TickedAxis& axis) {
      return std::ssize(axis.ticks) >= kFewTicks && haveRoom(axis.ticks, areApart);
    };
    for (int count = most + 1; count <= kMany; ++count)
      if (TickedAxis axis = withTicks(count); isGood(axis)) return axis;
    for (int count = kFewTicks; count <= kMany && range_.size() <= 1; ++count)
      if (TickedAxis axis = withLinearTicks(withTicks(count), axis_, count); isGood(axis))
        return axis;
    return {};
  }

  std::optional<TickedAxis> farthestTwo(const HaveRoom& doNotTouch) const {
    for (int count = 2; count <= kMany; ++count) {
      const TickedAxis usual = withTicks(count);
      for (TickedAxis ends : {usual, withLinearTicks(usual, axis_, count)}) {
        const std::vector<Tick> all = ends.ticks;
        for (std::size_t span = all.size(); span-- > 1;)
          for (std::size_t i = 0; i + span < all.size(); ++i) {
            ends.ticks = {all[i], all[i + span]};
            if (haveRoom(ends.ticks, doNotTouch)) return ends;
          }
      }
    }
    return {};
  }

  TickedAxis singleTick() const {
    const TickedAxis single = withTicks(1);
    if (!single.ticks.empty()) return single;
    TickedAxis first = withTicks(2);
    if (first.ticks.size() > 1) first.ticks.resize(1);
    return first;
  }

  const DiagramAxis& axis_;
  const AxisRange& range_;
  float pixels_, unit_;
};

/// Fits "velocity v (m/s)" in the largest size down to `least`, otherwise "v (m/s)" in the same
/// way. Returns nothing where neither fits.
std::optional<FittedTitle> wholeTitle(const std::string& title, float size, float least,
                                      float pixels) {
  const std::size_t unit = title.rfind(" (");
  const std::string symbol = trailingSymbol(title.substr(0, unit));
  std::vector<std::string> forms{title};
  if (!symbol.empty()) forms.push_back(symbol + (unit == title.npos ? "" : title.substr(unit)));
  for (const std::string& form : forms) {
    const float fitting = fittingSize(form, size, least, false, pixels);
    if (textWidth(form, fitting) <= pixels) return FittedTitle{form, fitting};
  }
  return std::nullopt;
}

float minTitleSize(float size) {
  return std::max(kSmallestFont, std::round(0.8F * size));
}

void addTitle(DrawList& list, const std::string& title, DrawPoint at, float size, float pixels,
              TextAnchor anchor, const Rgba& colour, float angle) {
  const FittedTitle form = fittedTitle(title, size, pixels);
  addLabel(list, form.text, at, form.size, anchor, colour, angle);
}

/// Adds marks on all four sides of the frame, or with a negative length outside of it, where only
/// the lower and the left side have them.
void addTickMarks(DrawLayer& layer, const DiagramAxes& axes, const Rgba& colour, float width,
                  float length) {
  const Box& box = axes.box;
  const bool isInside = length > 0;
  // Marks outside of a frame without numbers would stand in the gap to the next frame.
  const bool hasX = isInside || axes.hasXLabels;
  const auto addX = [&](double value, float reach) {
    const float x = onWholePixels(axes.px(value), width);
    addLine(layer, {{x, box.bottom()}, {x, box.bottom() - reach}}, width, colour);
    if (isInside) addLine(layer, {{x, box.y}, {x, box.y + reach}}, width, colour);
  };
  const auto addY = [&](double value, float reach) {
    const float y = onWholePixels(axes.py(value), width);
    addLine(layer, {{box.x, y}, {box.x + reach, y}}, width, colour);
    if (isInside) addLine(layer, {{box.right(), y}, {box.right() - reach, y}}, width, colour);
  };
  for (const Tick& tick : axes.xAxis.ticks)
    if (hasX) addX(tick.value, length);
  for (const double value : axes.xAxis.minor)
    if (hasX) addX(value, length / 2);
  for (const Tick& tick : axes.yAxis.ticks) addY(tick.value, length);
  for (const double value : axes.yAxis.minor) addY(value, length / 2);
}

void addTickLabels(DrawList& list, const DiagramAxes& axes, const Rgba& colour, float size) {
  const Box& box = axes.box;
  for (const Tick& tick : axes.xAxis.ticks) {
    const float half = textWidth(tick.label, size) / 2;
    const float centre = std::min(axes.px(tick.value), static_cast<float>(list.width) - half - 2);
    addLabel(list, tick.label, {centre, box.bottom() + 1.5F * size}, size, TextAnchor::Centre,
             colour);
  }
  for (const Tick& tick : axes.yAxis.ticks)
    addLabel(list, tick.label, {box.x - 0.7F * size, axes.py(tick.value) + kMiddleOfText * size},
             size, TextAnchor::Right, colour);
}

}  // namespace

std::string trailingSymbol(const std::string& name) {
  constexpr std::ptrdiff_t kLongest = 2;  // characters: a letter with a mark, an index or a prime
  const std::size_t space = name.rfind(' ');
  // "relative error of mu" is not mu, in neither language.
  const std::string_view before = std::string_view(name).substr(0, std::min(space, name.size()));
  if (before.ends_with(" of") || before.ends_with(" von")) return {};
  // Nor is "modulus G′, G″" G″ alone, nor "exponent d ln mu / d ln x" x.
  if (before.ends_with(',') || name.find(" / ") != name.npos) return {};
  if (name.find("\u00B0", std::min(space, name.size())) != name.npos) return {};  // a temperature
  if (space == name.npos) return {};
  const std::string last = name.substr(space + 1);
  // A word of two letters, as at the end of a user's own title, is no symbol.
  if (last.size() == 2 &&
      std::ranges::all_of(last, [](unsigned char c) { return std::isalpha(c) != 0; }))
    return {};
  return std::ranges::count_if(last, beginsCharacter) <= kLongest ? last : "";
}

FittedTitle fittedTitle(const std::string& title, float size, float pixels) {
  const float least = minTitleSize(size);
  if (const auto whole = wholeTitle(title, size, least, pixels)) return *whole;
  const std::size_t at = title.rfind(" (");
  if (at == title.npos) return {elided(title, least, false, pixels), least};
  const std::string unit = title.substr(at);
  constexpr std::ptrdiff_t kWorthReading = 6;  // minimum number of letters of a shortened name
  const std::string cut =
      elided(title.substr(0, at), least, false, pixels - textWidth(unit, least));
  const auto letters = std::ranges::count_if(cut, beginsCharacter);
  if (letters > kWorthReading) return {cut + unit, least};
  const std::string alone = unit.substr(1);
  return {alone, fittingSize(alone, size, kSmallestFont, false, pixels)};
}

AxisRange xRange(const Diagram& diagram) {
  const AxisRange prescribed = prescribedRange(diagram.x);
  if (!prescribed.isEmpty()) return prescribed;
  Extent data, theory;
  for (const DiagramSeries& series : diagram.series)
    for (const DiagramPoint& point : series.points)
      if (std::isfinite(axisPosition(diagram.y.scale, point.y)))
        (series.isTheory ? theory : data).add(axisPosition(diagram.x.scale, point.x));
  return padded(diagram.x, data, theory, false);
}

AxisRange yRange(const Diagram& diagram, const AxisRange& inX) {
  const AxisRange prescribed = prescribedRange(diagram.y);
  if (!prescribed.isEmpty()) return prescribed;
  Extent data, theory;
  for (const DiagramSeries& series : diagram.series)
    for (const DiagramPoint& point : series.points) {
      const double x = axisPosition(diagram.x.scale, point.x);
      const double y = axisPosition(diagram.y.scale, point.y);
      if (!(x >= inX.from && x <= inX.to) || !std::isfinite(y)) continue;
      Extent& extent = series.isTheory ? theory : data;
      extent.add(y);
      extent.add(barEnd(diagram.y.scale, point.low, y));
      extent.add(barEnd(diagram.y.scale, point.high, y));
    }
  return padded(diagram.y, data, theory, true);
}

bool hasNoValues(const Diagram& diagram) {
  if (diagram.field || !diagram.bars.empty()) return false;
  const auto hasValue = [](const DiagramSeries& series) {
    return std::ranges::any_of(series.points,
                               [](const DiagramPoint& point) { return std::isfinite(point.y); });
  };
  return diagram.y.from == diagram.y.to && std::ranges::none_of(diagram.series, hasValue);
}

TickedAxis tickedXAxis(const DiagramAxis& axis, const AxisRange& range, float pixels,
                       const DiagramSizes& sizes) {
  if (axis.isOfNames) return {axis.scale, range, {}, {}, axis.title.text};
  const float size = sizes.tick;
  if (axis.scale == AxisScale::Linear)
    return linearAxis(axis, range, sparseTicks(range.from, range.to, pixels, size, axis.unit));
  const auto areApart = [&](const Tick& a, const Tick& b, double distance) {
    return distance > 0.5 * (textWidth(a.label, size) + textWidth(b.label, size)) + 0.8 * size;
  };
  const int most = std::clamp(static_cast<int>(pixels / (3.5F * size)), 2, 20);
  return SparseLogarithmicAxis(axis, range, pixels, sizes.unit).ticked(most, areApart, areApart);
}

TickedAxis tickedYAxis(const DiagramAxis& axis, const AxisRange& range, float pixels,
                       const DiagramSizes& sizes) {
  const float size = sizes.tick;
  if (axis.scale == AxisScale::Linear)
    return linearAxis(axis, range, yTicks(range.from, range.to, pixels, 4 * size, size, axis.unit));
  const int most = std::clamp(static_cast<int>(pixels / (2 * size)), 2, 16);
  return SparseLogarithmicAxis(axis, range, pixels, sizes.unit)
      .ticked(
          most, [&](const Tick&, const Tick&, double distance) { return distance > 1.3 * size; },
          [&](const Tick&, const Tick&, double distance) { return distance >= size; });
}

float DiagramAxes::px(double x) const {
  return box.x + static_cast<float>((x - xAxis.range.from) / xAxis.range.size()) * box.width;
}

float DiagramAxes::py(double y) const {
  return box.bottom() -
         static_cast<float>((y - yAxis.range.from) / yAxis.range.size()) * box.height;
}

DrawPoint DiagramAxes::mapToPosition(double x, double y) const {
  const double right = axisPosition(xAxis.scale, x), above = axisPosition(yAxis.scale, y);
  const bool isUnder = isBelow(yAxis.scale, y);
  if (!std::isfinite(right) || !(std::isfinite(above) || isUnder))
    return {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::quiet_NaN()};
  const auto clamped = [](float pixels) {
    return std::clamp(pixels, static_cast<float>(-kFarthest), static_cast<float>(kFarthest));
  };
  return {clamped(px(right)),
          isUnder ? box.bottom() + static_cast<float>(kBelowAxis) : clamped(py(above))};
}

float leftOfAxes(const DiagramAxes& axes, const DiagramSizes& sizes) {
  const float title = axes.yAxis.title.empty() || axes.titleAbove ? 0 : 1.75F * sizes.axis;
  return std::ceil(title + widestLabel(axes.yAxis.ticks, sizes.tick) + 0.7F * sizes.tick);
}

float aboveAxes(const DiagramAxes& axes, const DiagramSizes& sizes) {
  return axes.titleAbove ? std::ceil(1.4F * sizes.axis) : 0;
}

bool fitsUpright(const std::string& title, float height, const DiagramSizes& sizes) {
  return wholeTitle(title, sizes.axis, minTitleSize(sizes.axis), height).has_value();
}

bool fitsUprightInWords(const std::string& title, float height, const DiagramSizes& sizes) {
  return textWidth(title, minTitleSize(sizes.axis)) <= height;
}

float belowAxes(const DiagramSizes& sizes) {
  return std::ceil(1.5F * sizes.tick + 2 * sizes.axis);
}

float axisLineWidth(const DiagramSizes& sizes) {
  return std::max(1.0F, std::round(1.1F * sizes.unit));
}

float onWholePixels(float pixel, float width) {
  return std::floor(pixel) + width / 2;
}

void addAxisFrame(DrawLayer& layer, const Box& box, float width, const Theme& theme) {
  // It is around the box, as that of the contact.
  addOutline(layer, {box.x - width / 2, box.y - width / 2, box.width + width, box.height + width},
             width, theme.axis);
}

void addDiagramGrid(DrawList& list, const DiagramAxes& axes, const DiagramSizes& sizes,
                    const Theme& theme) {
  const Box& box = axes.box;
  const float width = std::max(1.0F, std::round(sizes.unit));
  DrawLayer layer;
  for (const Tick& tick : axes.yAxis.ticks) {
    const float y = onWholePixels(axes.py(tick.value), width);
    addLine(layer, {{box.x, y}, {box.right(), y}}, width, theme.grid);
  }
  for (const Tick& tick : axes.xAxis.ticks) {
    const float x = onWholePixels(axes.px(tick.value), width);
    addLine(layer, {{x, box.y}, {x, box.bottom()}}, width, theme.grid);
  }
  list.layers.push_back(std::move(layer));
}

void addDiagramFrame(DrawList& list, const DiagramAxes& axes, const DiagramSizes& sizes,
                     const Theme& theme, float above) {
  const Box& box = axes.box;
  const float width = axisLineWidth(sizes);
  const Rgba& colour = theme.axis;
  DrawLayer layer;
  const float reach = std::round(6 * sizes.unit);
  if (sizes.ticks != TickSide::None)
    addTickMarks(layer, axes, colour, width, sizes.ticks == TickSide::Inside ? reach : -reach);
  addAxisFrame(layer, box, width, theme);
  list.layers.push_back(std::move(layer));
  DiagramAxes labelled = axes;
  if (!axes.hasXLabels) labelled.xAxis.ticks.clear();
  addTickLabels(list, labelled, theme.faintText, sizes.tick);
  if (axes.hasXLabels)
    addTitle(
        list, axes.xAxis.title,
        {box.x + box.width / 2, std::round(box.bottom() + 1.5F * sizes.tick + 1.5F * sizes.axis)},
        sizes.axis, box.width, TextAnchor::Centre, theme.text, 0);
  if (axes.titleAbove)
    return addTitle(list, axes.yAxis.title, {box.x, std::round(box.y - above - 0.4F * sizes.axis)},
                    sizes.axis, box.width, TextAnchor::Left, theme.text, 0);
  const float left = box.x - leftOfAxes(axes, sizes);
  addTitle(list, axes.yAxis.title, {std::round(left + 1.1F * sizes.axis), box.y + box.height / 2},
           sizes.axis, box.height, TextAnchor::Centre, theme.text, 1.57079633F);
}

}  // namespace asperity
