#include "ui/contact/contact_probe.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/material/element_law.h"
#include "ui/contact/contact_parts.h"
#include "ui/contact/frame_curves.h"
#include "ui/draw/fonts.h"
#include "ui/draw/theme.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

/// Returns the rate of the surface. A marched element has a constant pressure in each time step, so
/// its law gives the rate at the end of the step exactly. The line's slope and velocity give it
/// only to first order in the step.
std::optional<double> surfaceRate(const Frame& frame, std::size_t point) {
  const bool isMarched = frame.transient || frame.isSettling;
  if (!frame.scene || !isMarched) return std::nullopt;
  const ElementLaw law = elementLaw(frame.scene->elastomer);
  if (law.kind() != ElementKind::Kelvin) return std::nullopt;
  const double spring = -4 * law.equilibriumModulus * frame.surfaceHeight[point];
  return (spring - frame.pressure[point]) / (4 * law.viscosity);
}

/// A free surface relaxes for ever; what is left of it far below an atom is shown as 0, in the unit
/// of the height beside it.
std::string heightText(double height, double beside) {
  constexpr double kMin = 1e-12;  // m
  const bool isZero = std::abs(height) < kMin;
  const std::string text = quantity(isZero ? beside : height, "m", 3, Zeros::Keep);
  return isZero ? "0" + text.substr(text.rfind(' ')) : text;
}

}  // namespace

std::optional<ProbeReading> probeReading(const Frame& frame, double x) {
  if (!isDrawable(frame) || !std::isfinite(x)) return std::nullopt;
  const auto count = static_cast<double>(frame.lineHeight.size());
  const double nearest = std::round(x / frame.spacing);
  const double wrapped = nearest - count * std::floor(nearest / count);
  const std::size_t n = frame.lineHeight.size();
  const std::size_t i = std::min(static_cast<std::size_t>(wrapped), n - 1);
  ProbeReading reading;
  reading.point = i;
  reading.position = nearest * frame.spacing;  // as on the axis, in any period
  reading.line = frame.lineHeight[i];
  reading.surface = frame.surfaceHeight[i];
  reading.pressure = frame.pressure[i];
  reading.gap = reading.pressure > 0 ? 0 : std::max(reading.line - reading.surface, 0.0);
  reading.slope = lineSlopeAt(frame, i);
  reading.surfaceRate = surfaceRate(frame, i);
  if (frame.sinceContact.size() == n && std::isfinite(frame.sinceContact[i]))
    reading.age = frame.sinceContact[i];
  if (frame.power.size() == n) reading.power = frame.power[i];
  return reading;
}

std::vector<ProbeLine> probeLines(const ProbeReading& reading) {
  std::vector<ProbeLine> lines{
      {Words::tr("position x"), quantity(reading.position, "m", 4, Zeros::Keep)},
      {Words::tr("rigid line z \u2212 d"), heightText(reading.line, reading.surface)},
      {Words::tr("elastomer u"), heightText(reading.surface, reading.line)}};
  if (reading.pressure > 0)
    lines.push_back({Words::tr("line load p"), quantity(reading.pressure, "N/m", 3, Zeros::Keep)});
  else
    lines.push_back({Words::tr("gap"), quantity(reading.gap, "m", 3, Zeros::Keep)});
  lines.push_back({Words::tr("slope z\u2032"), shortNumber(reading.slope, 3, Zeros::Keep)});
  if (reading.surfaceRate)
    lines.push_back(
        {Words::tr("rate du/dt"), quantity(*reading.surfaceRate, "m/s", 3, Zeros::Keep)});
  if (reading.age && *reading.age > 0)
    lines.push_back({Words::tr("free for"), quantity(*reading.age, "s", 3, Zeros::Keep)});
  if (reading.power)
    lines.push_back({Words::tr("dissipates"), quantity(*reading.power, "W/m", 3, Zeros::Keep)});
  return lines;
}

// ---- The crosshair with its readout

namespace {

/// Returns the box of a text with its ascenders and descenders, rotated or not.
Box textBox(const DrawText& text) {
  const float width = textWidth(text.utf8, text.size, text.bold);
  const float start = text.anchor == TextAnchor::Left     ? 0
                      : text.anchor == TextAnchor::Centre ? -width / 2
                                                          : -width;
  if (text.angle != 0) return {text.x - text.size, text.y - start - width, text.size * 1.3F, width};
  return {text.x + start, text.y - 0.8F * text.size, width, 1.05F * text.size};
}

struct Readout {
  std::vector<ProbeLine> lines;
  float labels = 0, values = 0;  // pixels
  float row = 0, inset = 0, gap = 0;

  float width() const { return labels + gap + values + 2 * inset; }
  float height() const { return row * static_cast<float>(lines.size()) + 1.4F * inset; }
};

Readout makeReadout(std::vector<ProbeLine> lines, const Sizes& s) {
  Readout readout;
  readout.lines = std::move(lines);
  readout.row = std::round(1.42F * s.small);
  readout.inset = std::round(0.75F * s.small);
  readout.gap = std::round(s.small);
  for (const ProbeLine& line : readout.lines) {
    readout.labels = std::max(readout.labels, textWidth(line.label, s.small));
    readout.values = std::max(readout.values, textWidth(line.value, s.small, true));
  }
  return readout;
}

/// The crosshair and its dots in the plot, and a box to avoid.
struct Surroundings {
  float x, upper, lower;
  Box taken;
};

/// Returns a free box for the readout: beside the crosshair, on the side with more space, high or
/// low, away from the dots. In a narrow plot it is at the edges, above or below the dots. Nothing
/// where all of these boxes cover the dots or the box to avoid.
std::optional<Box> freeBox(const Readout& readout, const Surroundings& around,
                           const ContactLayout& layout) {
  const Box& plot = layout.plot;
  const auto [x, upper, lower, taken] = around;
  const float away = std::round(14 * layout.sizes.unit), edge = std::round(4 * layout.sizes.unit);
  const float w = readout.width(), h = readout.height();
  if (w + 2 * edge > plot.width || h + 2 * edge > plot.height) return std::nullopt;
  const float right = x + away, left = x - away - w;
  const float first = plot.x + edge, last = plot.right() - edge - w;
  const float middle = 0.5F * (upper + lower) - 0.5F * h;
  // The readout is below the row of labels where it fits.
  const float row = layout.sizes.labelHeight() + 2 * edge;
  const float high = plot.y + edge, low = plot.bottom() - edge - h;
  const float least = high + row <= low ? high + row : high;
  const bool goesRight = right <= last;
  for (const float side : {goesRight ? right : left, goesRight ? left : right, first, last})
    for (const float y : {middle, least, low, upper - away - h, lower + away, high}) {
      const Box candidate{std::round(std::clamp(side, first, last)),
                          std::round(std::clamp(y, y == high ? high : least, low)), w, h};
      const bool isBeside = candidate.x >= x + 0.5F * away || candidate.right() <= x - 0.5F * away;
      const bool isApart =
          candidate.y >= lower + 0.5F * away || candidate.bottom() <= upper - 0.5F * away;
      if ((isBeside || isApart) && !candidate.overlaps(taken)) return candidate;
    }
  return std::nullopt;
}

/// Leaves out a line, from the last one on; of the first four the rigid line's height, which in
/// contact equals that of the elastomer.
void leaveOneOut(std::vector<ProbeLine>& lines) {
  if (lines.size() == 4)
    lines.erase(lines.begin() + 1);
  else
    lines.pop_back();
}

/// Returns the readout with as many of its lines as fit into a free box, at least three; it covers
/// an inset only where there is no such box.
std::optional<std::pair<Readout, Box>> fittingReadout(const ProbeReading& reading,
                                                      Surroundings around,
                                                      const ContactLayout& layout) {
  constexpr std::size_t kMinLines = 3;
  const Readout all = makeReadout(probeLines(reading), layout.sizes);
  for (const Box& taken : {around.taken, Box{}}) {
    around.taken = taken;
    std::vector<ProbeLine> lines = all.lines;
    for (; lines.size() >= kMinLines; leaveOneOut(lines)) {
      const Readout readout = makeReadout(lines, layout.sizes);
      if (const auto box = freeBox(readout, around, layout)) return {{readout, *box}};
    }
  }
  return std::nullopt;
}

void addReadout(DrawList& list, const Readout& readout, const Box& box,
                const ContactLayout& layout) {
  removeTextsUnder(list, box);
  const Theme& t = layout.theme;
  const float u = std::max(1.0F, std::round(layout.sizes.unit));
  DrawLayer layer;
  addRectangle(layer, {box.x - u, box.y - u, box.width + 2 * u, box.height + 2 * u}, t.axis);
  Rgba paper = t.background;
  paper.a = 1;
  addRectangle(layer, box, paper);
  list.layers.push_back(std::move(layer));
  const float size = layout.sizes.small;
  float baseline =
      box.y + 0.7F * readout.inset + std::round(0.5F * readout.row + kMiddleOfText * size);
  for (const ProbeLine& line : readout.lines) {
    addText(list, {{line.label}}, {box.x + readout.inset, std::round(baseline)}, size, t.faintText);
    const float width = textWidth(line.value, size, true);
    addText(list, {{line.value, true}},
            {std::floor(box.right() - readout.inset - width), std::round(baseline)}, size, t.text);
    baseline += readout.row;
  }
}

/// The crosshair in pixels: its position, those of its two dots, and its readout where it fits.
struct Crosshair {
  float x, line, surface;
  std::optional<std::pair<Readout, Box>> readout;
};

std::optional<Crosshair> placeCrosshair(const Frame& frame, double x, const ContactLayout& layout,
                                        const Box& taken) {
  const auto reading = probeReading(frame, x);
  if (!reading) return std::nullopt;
  // The copies are shifted to the period of the crosshair.
  const double period = periodLength(frame);
  const double nearest = reading->position + period * std::round((x - reading->position) / period);
  const Box& plot = layout.plot;
  Crosshair cross{layout.px(nearest), layout.py(reading->line), layout.py(reading->surface), {}};
  if (cross.x < plot.x - 1 || cross.x > plot.right() + 1) return std::nullopt;
  const auto [upper, lower] = std::minmax(cross.line, cross.surface);
  cross.readout = fittingReadout(*reading,
                                 {cross.x, std::clamp(upper, plot.y, plot.bottom()),
                                  std::clamp(lower, plot.y, plot.bottom()), taken},
                                 layout);
  return cross;
}

}  // namespace

Box readoutBox(const Frame& frame, double x, const ContactLayout& layout, const Box& taken) {
  const auto cross = placeCrosshair(frame, x, layout, taken);
  return cross && cross->readout ? cross->readout->second : Box{};
}

void removeTextsUnder(DrawList& list, const Box& box) {
  std::erase_if(list.texts, [&](const DrawText& text) { return textBox(text).overlaps(box); });
}

void addProbe(DrawList& list, const Frame& frame, double x, const ContactLayout& layout,
              const Box& taken) {
  const auto cross = placeCrosshair(frame, x, layout, taken);
  if (!cross) return;
  const Box& plot = layout.plot;
  const float u = layout.sizes.unit;
  DrawLayer layer;
  layer.clip = plot;
  addLine(layer, {{cross->x, plot.y}, {cross->x, plot.bottom()}}, 3 * u,
          withAlpha(layout.theme.background, 0.35F));
  addLine(layer, {{cross->x, plot.y}, {cross->x, plot.bottom()}}, 1.2F * u,
          withAlpha(layout.theme.text, 0.8F));
  for (const float y : {cross->surface, cross->line}) {
    addLine(layer, {{cross->x, y}}, 9 * u, layout.theme.text);
    addLine(layer, {{cross->x, y}}, 6 * u,
            y == cross->line ? layout.theme.rigid : layout.theme.highlight);
  }
  list.layers.push_back(std::move(layer));
  if (cross->readout) addReadout(list, cross->readout->first, cross->readout->second, layout);
}

}  // namespace asperity
