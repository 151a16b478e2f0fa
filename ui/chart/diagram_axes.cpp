#include "ui/chart/diagram_axes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "ui/draw/fonts.h"
#include "ui/draw/log_ticks.h"
#include "ui/draw/theme.h"

namespace asperity {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr float kLeastText = 7;    // pixels, of a font
constexpr double kFarthest = 1e6;  // pixels; keeps coordinates small enough for floats

/// Grows with what it is given; empty at first.
struct Extent {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
  void add(double value) {
    if (!std::isfinite(value)) return;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  bool empty() const { return !(least <= most); }
};

/// What the axis itself asks for, or NaN.
AxisRange askedFor(const DiagramAxis& axis) {
  const double a = axisPlace(axis.scale, axis.from), b = axisPlace(axis.scale, axis.to);
  if (axis.from == axis.to || !std::isfinite(a) || !std::isfinite(b)) return {kNaN, kNaN};
  return {std::min(a, b), std::max(a, b)};
}

bool isKnown(const AxisRange& range) {
  return range.from < range.to;
}

/// Down (-1) or up (1) to 1, 2 or 5 times a power of ten, as decimal logarithms.
double roundedDecade(double decade, int direction) {
  const double floor = std::floor(decade);
  const double places[] = {0, std::log10(2.0), std::log10(5.0), 1};
  double best = direction < 0 ? floor : floor + 1;
  for (const double place : places) {
    if (direction < 0 && floor + place <= decade + 1e-9) best = floor + place;
    if (direction > 0 && floor + place >= decade - 1e-9) return floor + place;
  }
  return best;
}

AxisRange paddedLogarithmic(const Extent& extent, bool upwards) {
  const double size = extent.most - extent.least;
  if (size < 1e-6) return {extent.least - 0.5, extent.most + 0.5};
  const double pad = (upwards ? 0.04 : 0.02) * size;
  if (!upwards) return {extent.least - pad, extent.most + pad};
  return {roundedDecade(extent.least - pad, -1), roundedDecade(extent.most + pad, 1)};
}

AxisRange paddedLinear(const Extent& extent) {
  double size = extent.most - extent.least;
  const double largest = std::max(std::abs(extent.most), std::abs(extent.least));
  if (!(size > 1e-9 * largest)) size = largest > 0 ? largest : 1;
  const double pad = 0.06 * size;
  const bool nearZero = extent.least >= 0 && extent.least <= 0.4 * extent.most;
  return {nearZero ? 0 : extent.least - pad, extent.most + pad};
}

AxisRange padded(const DiagramAxis& axis, const Extent& data, const Extent& theory, bool upwards) {
  Extent extent = data.empty() ? theory : data;
  if (extent.empty()) return axis.scale == AxisScale::Linear ? AxisRange{0, 1} : AxisRange{-1, 1};
  if (upwards && !data.empty() && !theory.empty()) {
    const double beyond = 0.25 * (data.most - data.least);
    extent.add(std::clamp(theory.least, data.least - beyond, data.most));
    extent.add(std::clamp(theory.most, data.least, data.most + beyond));
  }
  return axis.scale == AxisScale::Linear ? paddedLinear(extent)
                                         : paddedLogarithmic(extent, upwards);
}

/// The end of an error bar; on a logarithmic axis it may reach to zero, which is not shown.
double barEnd(AxisScale scale, double end, double value) {
  const double place = axisPlace(scale, end);
  return scale == AxisScale::Logarithmic ? std::max(place, value - 1) : place;
}

/// The places between the ticks of a linear axis as decimal logarithms.
PictureAxis plainTicksOnLogarithmic(const DiagramAxis& axis, const AxisRange& range, int most) {
  const AxisTicks ticks =
      linearTicks(std::pow(10, range.from), std::pow(10, range.to), most, axis.unit);
  PictureAxis plot{range.from, range.to, {}, titleWithUnit(axis.title.text, ticks.unit), {}, {}};
  for (const Tick& tick : ticks.ticks)
    if (tick.value > 0) plot.ticks.push_back({std::log10(tick.value), tick.label});
  return plot;
}

PictureAxis logarithmic(const DiagramAxis& axis, const AxisRange& range, int most, float pixels,
                        float unit) {
  const std::vector<LogTick> ticks = logTicks(range.from, range.to, most);
  if (ticks.size() < 2) return plainTicksOnLogarithmic(axis, range, most);
  PictureAxis plot =
      logarithmicAxis(range.from, range.to, most, titleWithUnit(axis.title.text, axis.unit), {});
  plot.minor =
      minorLogTicks(range.from, range.to, ticks, pixels / (range.to - range.from), 3.0 * unit);
  return plot;
}

/// The symbol that ends a name, "v" of "velocity v"; empty where none does.
std::string symbolOf(const std::string& name) {
  constexpr std::size_t kLongest = 3;  // bytes, a Greek letter with a mark
  const std::size_t space = name.rfind(' ');
  return space != name.npos && name.size() - space - 1 <= kLongest ? name.substr(space + 1) : "";
}

struct TitleForm {
  std::string text;
  float size;
};

/// "velocity v (m/s)" in the largest size down to `least` that fits; then "v (m/s)" likewise; none
/// where neither does.
std::optional<TitleForm> saidInFull(const std::string& title, float size, float least,
                                    float pixels) {
  const std::size_t unit = title.rfind(" (");
  const std::string symbol = symbolOf(title.substr(0, unit));
  std::vector<std::string> forms{title};
  if (!symbol.empty()) forms.push_back(symbol + (unit == title.npos ? "" : title.substr(unit)));
  for (const std::string& form : forms) {
    const float fitting = fittingSize(form, size, least, false, pixels);
    if (textWidth(form, fitting) <= pixels) return TitleForm{form, fitting};
  }
  return std::nullopt;
}

float leastTitle(float size) {
  return std::max(kLeastText, std::round(0.8F * size));
}

/// What fits: words go first, the unit with its power of ten never, as the numbers on the axis
/// would be wrong without it.
TitleForm fittedTitle(const std::string& title, float size, float pixels) {
  const float least = leastTitle(size);
  if (const auto whole = saidInFull(title, size, least, pixels)) return *whole;
  const std::size_t at = title.rfind(" (");
  if (at == title.npos) return {elided(title, least, false, pixels), least};
  const std::string unit = title.substr(at);
  constexpr std::size_t kWorthReading = 6;  // letters of a name
  const std::string cut =
      elided(title.substr(0, at), least, false, pixels - textWidth(unit, least));
  if (cut.size() > kWorthReading) return {cut + unit, least};
  const std::string alone = unit.substr(1);
  return {alone, fittingSize(alone, size, kLeastText, false, pixels)};
}

void addTitle(DrawList& list, const std::string& title, Place at, float size, float pixels,
              TextAnchor anchor, const Rgba& colour, float angle) {
  const TitleForm form = fittedTitle(title, size, pixels);
  addLabel(list, form.text, at, form.size, anchor, colour, angle);
}

}  // namespace

double axisPlace(AxisScale scale, double value) {
  if (!std::isfinite(value)) return kNaN;
  if (scale == AxisScale::Linear) return value;
  return value > 0 ? std::log10(value) : kNaN;
}

AxisRange rangeAlong(const Diagram& diagram) {
  const AxisRange asked = askedFor(diagram.x);
  if (isKnown(asked)) return asked;
  Extent data, theory;
  for (const DiagramSeries& series : diagram.series)
    for (const DiagramPoint& point : series.points)
      if (std::isfinite(axisPlace(diagram.y.scale, point.y)))
        (series.isTheory ? theory : data).add(axisPlace(diagram.x.scale, point.x));
  return padded(diagram.x, data, theory, false);
}

AxisRange rangeUp(const Diagram& diagram, const AxisRange& along) {
  const AxisRange asked = askedFor(diagram.y);
  if (isKnown(asked)) return asked;
  Extent data, theory;
  for (const DiagramSeries& series : diagram.series)
    for (const DiagramPoint& point : series.points) {
      const double x = axisPlace(diagram.x.scale, point.x);
      const double y = axisPlace(diagram.y.scale, point.y);
      if (!(x >= along.from && x <= along.to) || !std::isfinite(y)) continue;
      Extent& extent = series.isTheory ? theory : data;
      extent.add(y);
      extent.add(barEnd(diagram.y.scale, point.low, y));
      extent.add(barEnd(diagram.y.scale, point.high, y));
    }
  return padded(diagram.y, data, theory, true);
}

PictureAxis diagramAxisAlong(const DiagramAxis& axis, const AxisRange& range, float pixels,
                             const DiagramSizes& sizes) {
  const float size = sizes.tick;
  if (axis.scale == AxisScale::Linear)
    return linearAxisAlong(range.from, range.to, pixels, size, axis.title.text, axis.unit);
  for (int most = std::clamp(static_cast<int>(pixels / (3.5F * size)), 2, 20);; --most) {
    PictureAxis plot = logarithmic(axis, range, most, pixels, sizes.unit);
    if (most <= 1 || plot.ticks.size() < 2) return plot;
    // Labels must not touch; unequal distances between multiples of a decade count.
    bool clear = true;
    for (std::size_t i = 0; i + 1 < plot.ticks.size(); ++i) {
      const double distance = (plot.ticks[i + 1].value - plot.ticks[i].value) /
                              (range.to - range.from) * static_cast<double>(pixels);
      const float both =
          textWidth(plot.ticks[i].label, size) + textWidth(plot.ticks[i + 1].label, size);
      clear = clear && distance > 0.5 * both + 0.8 * size;
    }
    if (clear) return plot;
  }
}

PictureAxis diagramAxisUp(const DiagramAxis& axis, const AxisRange& range, float pixels,
                          const DiagramSizes& sizes) {
  const float size = sizes.tick;
  if (axis.scale == AxisScale::Linear)
    return linearAxisUp(range.from, range.to, pixels, size, axis.title.text, axis.unit);
  for (int most = std::clamp(static_cast<int>(pixels / (2 * size)), 2, 16);; --most) {
    PictureAxis plot = logarithmic(axis, range, most, pixels, sizes.unit);
    if (most <= 1 || plot.ticks.size() < 2) return plot;
    double least = plot.to - plot.from;
    for (std::size_t i = 0; i + 1 < plot.ticks.size(); ++i)
      least = std::min(least, plot.ticks[i + 1].value - plot.ticks[i].value);
    if (least / (plot.to - plot.from) * static_cast<double>(pixels) > 1.5 * size) return plot;
  }
}

Place DiagramAxes::place(double x, double y) const {
  const double px = axisPlace(along, x), py = axisPlace(up, y);
  if (!std::isfinite(px) || !std::isfinite(py))
    return {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::quiet_NaN()};
  const auto held = [](float pixels) {
    return std::clamp(pixels, static_cast<float>(-kFarthest), static_cast<float>(kFarthest));
  };
  return {held(plot.px(px)), held(plot.py(py))};
}

float leftOfAxes(const DiagramAxes& axes, const DiagramSizes& sizes) {
  const PictureAxis& up = axes.plot.up;
  const float title = up.title.empty() || axes.titleAbove ? 0 : 1.75F * sizes.axis;
  return std::ceil(title + widestLabel(up, sizes.tick) + 0.7F * sizes.tick);
}

float aboveAxes(const DiagramAxes& axes, const DiagramSizes& sizes) {
  return axes.titleAbove ? std::ceil(1.4F * sizes.axis) : 0;
}

bool fitsUpright(const std::string& title, float height, const DiagramSizes& sizes) {
  return saidInFull(title, sizes.axis, leastTitle(sizes.axis), height).has_value();
}

float belowAxes(const DiagramSizes& sizes) {
  return std::ceil(1.5F * sizes.tick + 2 * sizes.axis);
}

void addDiagramGrid(DrawList& list, const DiagramAxes& axes, const DiagramSizes& sizes,
                    const Theme& theme) {
  DrawLayer layer;
  addGridLines(layer, axes.plot, theme, std::max(1.0F, std::round(sizes.unit)));
  list.layers.push_back(std::move(layer));
}

void addDiagramFrame(DrawList& list, const DiagramAxes& axes, const DiagramSizes& sizes,
                     const Theme& theme, float above) {
  const Box& box = axes.plot.box;
  const float width = std::max(1.0F, std::round(1.1F * sizes.unit));
  const Rgba colour = mix(theme.text, theme.axis, 0.35F);
  DrawLayer layer;
  addTickMarks(layer, axes.plot, colour, width, std::round(6 * sizes.unit));
  addFrame(layer, box, colour, width);
  list.layers.push_back(std::move(layer));
  PlotAxes said = axes.plot;
  if (!axes.saysAlong) said.along.ticks.clear();
  addTickLabels(list, said, theme.text, sizes.tick);
  if (axes.saysAlong)
    addTitle(
        list, axes.plot.along.title,
        {box.x + box.width / 2, std::round(box.bottom() + 1.5F * sizes.tick + 1.5F * sizes.axis)},
        sizes.axis, box.width, TextAnchor::Centre, theme.text, 0);
  if (axes.titleAbove)
    return addTitle(list, axes.plot.up.title,
                    {box.x, std::round(box.y - above - 0.4F * sizes.axis)}, sizes.axis, box.width,
                    TextAnchor::Left, theme.text, 0);
  const float left = box.x - leftOfAxes(axes, sizes);
  addTitle(list, axes.plot.up.title, {std::round(left + 1.1F * sizes.axis), box.y + box.height / 2},
           sizes.axis, box.height, TextAnchor::Centre, theme.text, 1.57079633F);
}

}  // namespace asperity
