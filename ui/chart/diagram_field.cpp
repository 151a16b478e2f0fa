#include "ui/chart/diagram_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "ui/chart/diagram_style.h"
#include "ui/draw/fonts.h"

namespace asperity {
namespace {

constexpr float kColourBarGap = 14,
                kColourBarWidth = 16;  // units: from the frame to the bar, and its width
constexpr float kContour = 1.1F;       // unit
constexpr float kContourAlpha = 0.75F;
/// A field with fewer nodes than this along a side is interpolated before it is coloured, because
/// colours between those of distant values are not the colours of the values between.
constexpr std::size_t kFinest = 128;

double colourPart(const DiagramField& field, double value) {
  const double from = axisPosition(field.colours.scale, field.colours.from);
  const double to = axisPosition(field.colours.scale, field.colours.to);
  return (axisPosition(field.colours.scale, value) - from) / (to - from);
}

/// Returns the nodes with `steps` - 1 further ones between each two.
std::vector<float> refined(const std::vector<float>& nodes, std::size_t steps) {
  std::vector<float> fine;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    for (std::size_t k = 0; k < steps; ++k)
      fine.push_back(nodes[i] +
                     (nodes[i + 1] - nodes[i]) * static_cast<float>(k) / static_cast<float>(steps));
  if (!nodes.empty()) fine.push_back(nodes.back());
  return fine;
}

std::size_t stepsFor(std::size_t nodes) {
  return nodes > 1 ? std::max<std::size_t>(1, kFinest / (nodes - 1)) : 1;
}

float distance(const DrawPoint& a, const DrawPoint& b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}

float arcLength(const Polyline& line) {
  float length = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) length += distance(line[i], line[i + 1]);
  return length;
}

/// Returns the point of a line at this length from its beginning.
DrawPoint pointAfter(const Polyline& line, float length) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const float step = distance(line[i], line[i + 1]);
    if (length <= step && step > 0) {
      const float part = length / step;
      return {line[i].x + part * (line[i + 1].x - line[i].x),
              line[i].y + part * (line[i + 1].y - line[i].y)};
    }
    length -= step;
  }
  return line.back();
}

/// Returns the part of a line between two lengths along it.
Polyline partBetween(const Polyline& line, float from, float to) {
  Polyline part;
  if (!(from < to)) return part;
  part.push_back(pointAfter(line, from));
  float at = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    at += distance(line[i], line[i + 1]);
    if (at > from && at < to) part.push_back(line[i + 1]);
  }
  part.push_back(pointAfter(line, to));
  return part;
}

/// The label of a contour line.
struct LineLabel {
  DrawPoint middle;
  float angle = 0;         // counter-clockwise on the screen
  float from = 0, to = 0;  // lengths along the line between which it is interrupted
  float radius = 0;        // of the circle that the text needs
};

/// Returns points along the lines, at this distance from each other.
std::vector<DrawPoint> pointsAlong(const std::vector<Polyline>& lines, float step) {
  std::vector<DrawPoint> points;
  for (const Polyline& line : lines) {
    const float length = arcLength(line);
    for (float at = 0; at < length; at += step) points.push_back(pointAfter(line, at));
  }
  return points;
}

/// Finds a part of a line that is nearly straight, without another label and without a border.
std::optional<LineLabel> labelOn(const Polyline& line, float width, const Box& frame,
                                 const std::vector<LineLabel>& others,
                                 const std::vector<DrawPoint>& dashes) {
  constexpr std::array kPlaces{0.5F,  0.45F, 0.55F, 0.4F, 0.6F,  0.35F, 0.65F, 0.3F, 0.7F,
                               0.25F, 0.75F, 0.2F,  0.8F, 0.15F, 0.85F, 0.1F,  0.9F};
  constexpr float kStraight = 0.95F;  // chord over arc
  const float length = arcLength(line);
  if (length < 2.5F * width) return {};
  for (const float part : kPlaces) {
    LineLabel label;
    label.from = part * length - width / 2;
    label.to = part * length + width / 2;
    const DrawPoint a = pointAfter(line, label.from), b = pointAfter(line, label.to);
    const float chord = distance(a, b);
    if (chord < kStraight * width) continue;
    label.middle = {(a.x + b.x) / 2, (a.y + b.y) / 2};
    label.radius = 0.55F * width;
    label.angle = std::atan2(a.y - b.y, b.x - a.x);
    // Texts are never upside down.
    constexpr float kHalf = std::numbers::pi_v<float> / 2;
    if (label.angle > kHalf) label.angle -= 2 * kHalf;
    if (label.angle < -kHalf) label.angle += 2 * kHalf;
    const float r = label.radius;
    const bool isInside = label.middle.x - r > frame.x && label.middle.x + r < frame.right() &&
                          label.middle.y - r > frame.y && label.middle.y + r < frame.bottom();
    const bool isFree = std::ranges::none_of(others, [&](const LineLabel& other) {
      return distance(other.middle, label.middle) < other.radius + r;
    });
    const bool isClear = std::ranges::none_of(
        dashes, [&](const DrawPoint& dash) { return distance(dash, label.middle) < r; });
    if (isInside && isFree && isClear) return label;
  }
  return {};
}

/// Returns the labels of a contour's lines, the longest first, and adds them to those that are
/// there. Each of the longer lines has one where no border is in its way. A contour that would have
/// none has one over a border.
std::vector<std::optional<LineLabel>> labelsOn(const std::vector<Polyline>& lines, float width,
                                               const Box& frame, std::vector<LineLabel>& others,
                                               const std::vector<DrawPoint>& dashes) {
  constexpr std::size_t kLabelled = 3;  // lines of a contour
  const std::size_t longer = std::min(lines.size(), kLabelled);
  std::vector<std::optional<LineLabel>> labels(lines.size());
  bool isLabelled = false;
  const auto place = [&](std::size_t k, const std::vector<DrawPoint>& avoided) {
    labels[k] = labelOn(lines[k], width, frame, others, avoided);
    if (!labels[k]) return;
    others.push_back(*labels[k]);
    isLabelled = true;
  };
  for (std::size_t k = 0; k < longer; ++k) place(k, dashes);
  for (std::size_t k = 0; k < longer && !isLabelled; ++k) place(k, {});
  return labels;
}

}  // namespace

TickedAxis colourAxis(const DiagramField& field, float height, const DiagramSizes& sizes) {
  const AxisRange range{axisPosition(field.colours.scale, field.colours.from),
                        axisPosition(field.colours.scale, field.colours.to)};
  if (!(range.from < range.to)) return {};
  return tickedYAxis(field.colours, range, height, sizes);
}

float colourBarWidth(const TickedAxis& colours, const DiagramSizes& sizes) {
  return std::ceil((kColourBarGap + kColourBarWidth) * sizes.unit + 0.6F * sizes.tick +
                   widestLabel(colours.ticks, sizes.tick) + 1.8F * sizes.axis);
}

void addFieldColours(DrawList& list, const DiagramField& field, const DiagramAxes& axes) {
  const std::size_t columns = field.x.size(), rows = field.y.size();
  if (columns < 2 || rows < 2 || field.values.size() != columns * rows) return;
  std::vector<float> x, y;
  for (const double value : field.x) x.push_back(axes.px(axisPosition(axes.xAxis.scale, value)));
  for (const double value : field.y) y.push_back(axes.py(axisPosition(axes.yAxis.scale, value)));
  std::vector<double> parts;
  for (const double value : field.values) parts.push_back(colourPart(field, value));
  const std::size_t alongX = stepsFor(columns), alongY = stepsFor(rows);
  DrawField drawn{refined(x, alongX), refined(y, alongY), {}};
  drawn.colours.reserve(drawn.x.size() * drawn.y.size());
  for (std::size_t fineRow = 0; fineRow < drawn.y.size(); ++fineRow) {
    const std::size_t j = std::min(fineRow / alongY, rows - 2);
    const double down = static_cast<double>(fineRow - j * alongY) / static_cast<double>(alongY);
    for (std::size_t fineColumn = 0; fineColumn < drawn.x.size(); ++fineColumn) {
      const std::size_t i = std::min(fineColumn / alongX, columns - 2);
      const double right =
          static_cast<double>(fineColumn - i * alongX) / static_cast<double>(alongX);
      const double* at = &parts[j * columns + i];
      // A corner without a value counts only where it has weight.
      double sum = 0;
      bool isKnown = true;
      const auto add = [&](double part, double weight) {
        if (weight == 0) return;
        if (std::isfinite(part))
          sum += weight * part;
        else
          isKnown = false;
      };
      add(at[0], (1 - right) * (1 - down));
      add(at[1], right * (1 - down));
      add(at[columns], (1 - right) * down);
      add(at[columns + 1], right * down);
      drawn.colours.push_back(isKnown ? fieldColour(sum) : Rgba{0, 0, 0, 0});
    }
  }
  DrawLayer layer;
  layer.clip = axes.box;
  layer.fields.push_back(std::move(drawn));
  list.layers.push_back(std::move(layer));
}

void addContours(DrawList& list, const DiagramField& field, const DiagramAxes& axes,
                 const DiagramSizes& sizes, const std::vector<Box>& taken,
                 const std::vector<Polyline>& borders) {
  DrawLayer layer;
  layer.clip = axes.box;
  std::vector<LineLabel> labels;
  for (const Box& box : taken) {
    LineLabel label;
    label.middle = {box.x + box.width / 2, box.y + box.height / 2};
    label.radius = std::hypot(box.width, box.height) / 2;
    labels.push_back(label);
  }
  const float size = std::round(0.92F * sizes.tick);
  const std::vector<DrawPoint> dashes = pointsAlong(borders, 0.5F * size);
  for (const DiagramContour& contour : field.contours) {
    const Rgba colour =
        withAlpha(textOn(fieldColour(colourPart(field, contour.value))), kContourAlpha);
    std::vector<Polyline> lines;
    for (const std::vector<DiagramPoint>& points : contour.lines) {
      Polyline line;
      for (const DiagramPoint& point : points) line.push_back(axes.mapToPosition(point.x, point.y));
      lines.push_back(std::move(line));
    }
    std::ranges::stable_sort(lines, {}, [](const Polyline& line) { return -arcLength(line); });
    const float width = textWidth(contour.label.text, size) + 0.6F * size;
    const auto labelOfLine = labelsOn(lines, width, axes.box, labels, dashes);
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const Polyline& line = lines[k];
      const std::optional<LineLabel>& label = labelOfLine[k];
      if (!label) {
        addLine(layer, line, kContour * sizes.unit, colour);
        continue;
      }
      for (const Polyline& part :
           {partBetween(line, 0, label->from), partBetween(line, label->to, arcLength(line))})
        if (part.size() > 1) addLine(layer, part, kContour * sizes.unit, colour);
      const float drop = kMiddleOfText * size;
      addLabel(list, contour.label.text,
               {label->middle.x + drop * std::sin(label->angle),
                label->middle.y + drop * std::cos(label->angle)},
               size, TextAnchor::Centre, withAlpha(colour, 1), label->angle);
    }
  }
  list.layers.push_back(std::move(layer));
}

void addColourBar(DrawList& list, const TickedAxis& colours, const Box& frame,
                  const DiagramSizes& sizes, const Theme& theme) {
  if (!(colours.range.from < colours.range.to)) return;
  const Box bar{std::round(frame.right() + kColourBarGap * sizes.unit), frame.y,
                std::round(kColourBarWidth * sizes.unit), frame.height};
  DrawLayer layer;
  DrawField ramp;
  ramp.x = {bar.x, bar.right()};
  constexpr int kSteps = 40;
  for (int k = 0; k <= kSteps; ++k) {
    const float part = static_cast<float>(k) / kSteps;
    ramp.y.push_back(bar.bottom() - part * bar.height);
    ramp.colours.insert(ramp.colours.end(), 2, fieldColour(static_cast<double>(part)));
  }
  layer.fields.push_back(std::move(ramp));
  DiagramAxes axes;
  axes.box = bar;
  axes.yAxis = colours;
  const float width = axisLineWidth(sizes);
  addAxisFrame(layer, bar, width, theme);
  const float reach = std::round(5 * sizes.unit);
  const auto addTick = [&](double value, float length) {
    const float y = onWholePixels(axes.py(value), width);
    addLine(layer, {{bar.right(), y}, {bar.right() - length, y}}, width,
            mix(theme.text, theme.axis, 0.35F));
  };
  for (const Tick& tick : colours.ticks) addTick(tick.value, reach);
  for (const double value : colours.minor) addTick(value, reach / 2);
  list.layers.push_back(std::move(layer));
  for (const Tick& tick : colours.ticks)
    addLabel(list, tick.label,
             {bar.right() + 0.5F * sizes.tick, axes.py(tick.value) + kMiddleOfText * sizes.tick},
             sizes.tick, TextAnchor::Left, theme.faintText);
  const FittedTitle title = fittedTitle(colours.title, sizes.axis, frame.height);
  addLabel(list, title.text,
           {std::round(bar.right() + 0.5F * sizes.tick + widestLabel(colours.ticks, sizes.tick) +
                       1.3F * sizes.axis),
            frame.y + frame.height / 2},
           title.size, TextAnchor::Centre, theme.text, std::numbers::pi_v<float> / 2);
}

}  // namespace asperity
