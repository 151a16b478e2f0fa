#include "ui/chart/diagram_annotations.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "ui/chart/diagram_style.h"
#include "ui/draw/fonts.h"
#include "ui/draw/shapes.h"
#include "ui/draw/theme.h"

namespace asperity {
namespace {

constexpr float kLine = 1.3F;  // height of a line in sizes of the font

struct SpanBox {
  Box box;
  std::string label, shortLabel;
};

/// Returns a span's part of the frame; an end outside the axis is the end of the frame.
std::vector<SpanBox> spanBoxes(const std::vector<DiagramSpan>& spans, const DiagramAxes& axes) {
  const Box& box = axes.box;
  std::vector<SpanBox> boxes;
  for (const DiagramSpan& span : spans) {
    const auto column = [&](double value, float otherwise) {
      const double position = axisPosition(axes.xAxis.scale, value);
      return std::isfinite(position) ? std::clamp(axes.px(position), box.x, box.right())
                                     : otherwise;
    };
    const float left = column(span.from, box.x), right = column(span.to, box.right());
    boxes.push_back({{left, box.y, right - left, box.height}, span.label.text, span.shortLabel});
  }
  return boxes;
}

/// Returns the full or the short name that fits. A span without a short name may be cut.
std::string labelWithin(const SpanBox& span, float size, float available) {
  if (span.shortLabel.empty()) return elided(span.label, size, false, available);
  for (const std::string& label : {span.label, span.shortLabel})
    if (textWidth(label, size) <= available) return label;
  return {};
}

bool crosses(const DrawPoint& from, const DrawPoint& to, const Box& box) {
  return !clippedTo(box, {from, to}).empty();
}

/// Tests whether a label and its arrow keep clear of the placed labels, of their arrows, and of the
/// targets of other arrows.
class Clearance {
 public:
  Clearance(const std::vector<PlacedLabel>& placed, std::vector<DrawPoint> targets, float margin)
      : placed_(placed), targets_(std::move(targets)), margin_(margin) {}

  bool isClear(const Box& box, const std::optional<DrawPoint>& target) const {
    const Box wide = grown(box, margin_);
    const auto from = target ? exitPoint(box, *target) : std::nullopt;
    if (target && !from) return false;  // there would be no arrow
    for (const DrawPoint& other : targets_)
      if (crosses(other, other, wide)) return false;
    return std::ranges::none_of(placed_, [&](const PlacedLabel& other) {
      return (from && crosses(*from, *target, grown(other.box, margin_))) ||
             (other.arrow.size() == 2 && crosses(other.arrow[0], other.arrow[1], wide));
    });
  }

 private:
  const std::vector<PlacedLabel>& placed_;
  std::vector<DrawPoint> targets_;
  float margin_;
};

/// Returns the position inside the frame that is nearest to the requested position of the label.
DrawPoint clampedInside(const Box& area, DrawPoint at, float width, float height) {
  const auto clamped = [](float value, float from, float to) {
    return from < to ? std::clamp(value, from, to) : (from + to) / 2;
  };
  return {clamped(at.x, area.x + width / 2, area.right() - width / 2),
          clamped(at.y, area.y + height / 2, area.bottom() - height / 2)};
}

std::vector<std::string> elidedLines(const std::string& text, float size, float width) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = elided(text.substr(at, end - at), size, false, width);
    if (!line.empty()) lines.push_back(line);
    at = end + 1;
  }
  return lines;
}

/// Places a shade's name near its foot, in as many lines as needed; none where the shade is too
/// narrow or the name would cover something.
std::optional<PlacedLabel> placeShade(const SpanBox& shade, OccupancyGrid& map,
                                      const DiagramSizes& sizes) {
  const float size = sizes.legend, margin = 0.25F * size;
  PlacedLabel out;
  out.lines = wrapped(shade.label, size, false, shade.box.width - 4 * margin);
  std::string whole;
  for (const std::string& line : out.lines) whole += (whole.empty() ? "" : " ") + line;
  if (out.lines.empty() || whole != shade.label) return std::nullopt;
  const float width = widestLine(out.lines, size) + 2 * margin;
  const float height = kLine * size * static_cast<float>(out.lines.size());
  const DrawPoint foot{shade.box.x + shade.box.width / 2,
                       shade.box.bottom() - height / 2 - 2 * margin};
  const auto box = boxNear(foot, width, height, shade.box, map, 0.6F * size, 24);
  if (!box || map.greatestUnder(*box) > 0) return std::nullopt;
  out.box = *box;
  out.isOfShade = true;
  map.addBox(grown(*box, margin), kTaken);
  return out;
}

}  // namespace

float aboveFrame(const Diagram& diagram, const DiagramSizes& sizes) {
  const bool named = std::any_of(diagram.spans.begin(), diagram.spans.end(),
                                 [](const DiagramSpan& span) { return !span.label.empty(); });
  return named ? std::round(1.6F * sizes.tick) : 0;
}

void addSpans(DrawList& list, const Diagram& diagram, const DiagramAxes& axes,
              const DiagramSizes& sizes, const Theme& theme) {
  const float strip = aboveFrame(diagram, sizes), size = sizes.tick;
  const float gap = 0.4F * size;
  DrawLayer layer;
  float taken = axes.box.x;  // names of overlapping regions share the strip
  bool shaded = true;
  for (const SpanBox& span : spanBoxes(diagram.spans, axes)) {
    if (!(span.box.width > 1)) continue;
    const Box whole{span.box.x, span.box.y - strip, span.box.width, span.box.height + strip};
    if (shaded) addRectangle(layer, whole, withAlpha(theme.text, 0.055F));
    shaded = !shaded;
    const float left = std::max(whole.x, taken) + gap, available = whole.right() - gap - left;
    const std::string label = labelWithin(span, size, available);
    if (label.empty()) continue;
    const float width = textWidth(label, size);
    const float centre = std::clamp(whole.x + whole.width / 2, left + width / 2,
                                    std::max(left + width / 2, whole.right() - gap - width / 2));
    addLabel(list, label, {centre, std::round(whole.y + strip - 0.45F * size)}, size,
             TextAnchor::Centre, theme.faintText);
    taken = centre + width / 2;
  }
  for (const SpanBox& shade : spanBoxes(diagram.shades, axes))
    addRectangle(layer, shade.box, withAlpha(theme.highlight, kShadeOpacity));
  if (!layer.triangles.empty()) list.layers.push_back(std::move(layer));
}

std::vector<PlacedLabel> placeLabels(const Diagram& diagram, const DiagramAxes& axes,
                                     OccupancyGrid& map, const DiagramSizes& sizes) {
  const float size = sizes.legend, margin = 0.25F * size;
  const Box inside = grown(map.area(), -7 * sizes.unit);  // away from the ticks
  std::vector<PlacedLabel> placed;
  for (const DiagramLabel& label : diagram.labels) {
    const DrawPoint at = axes.mapToPosition(label.x, label.y);
    const DrawPoint target = axes.mapToPosition(label.arrowX, label.arrowY);
    const bool hasArrow = isFinite(target);
    if (!isFinite(at)) continue;
    PlacedLabel out;
    out.lines = elidedLines(label.text.text, size, 0.9F * map.area().width);
    if (out.lines.empty()) continue;
    const float width = widestLine(out.lines, size) + 2 * margin;
    const float height = kLine * size * static_cast<float>(out.lines.size());
    std::vector<DrawPoint> targets;  // of the others
    for (const DiagramLabel& other : diagram.labels)
      if (const DrawPoint its = axes.mapToPosition(other.arrowX, other.arrowY);
          &other != &label && isFinite(its))
        targets.push_back(its);
    const Clearance clearance(placed, std::move(targets), 0.4F * size);
    const DrawPoint preferred = clampedInside(inside, at, width, height);
    const int rings = hasArrow ? 24 : 14;
    auto box =
        boxNear(preferred, width, height, inside, map, 0.6F * size, rings, [&](const Box& one) {
          return clearance.isClear(one, hasArrow ? std::optional(target) : std::nullopt);
        });
    if (!box) box = boxNear(preferred, width, height, inside, map, 0.6F * size, rings);
    if (!box) continue;
    out.box = *box;
    out.covers = diagram.field || map.greatestUnder(*box) > 0;
    out.isOfMarker = !diagram.field && diagram.marker && label.text == diagram.marker->label;
    if (hasArrow)
      if (const auto start = exitPoint(grown(*box, 0.15F * size), target)) {
        out.arrow = {*start, target};
        map.addLine(out.arrow, 3);
      }
    map.addBox(grown(*box, margin), kTaken);
    placed.push_back(std::move(out));
  }
  for (const SpanBox& shade : spanBoxes(diagram.shades, axes))
    if (auto out = placeShade(shade, map, sizes)) placed.push_back(std::move(*out));
  return placed;
}

namespace {

/// Returns the colour of a label. That of a marker is darker or lighter than its line, so that
/// small letters can be read.
Rgba labelColour(const PlacedLabel& label, const Theme& theme) {
  constexpr float kMore = 0.2F;
  if (label.isOfMarker) return mix(seriesColour(kMarkerColour, theme), theme.text, kMore);
  return label.isOfShade ? theme.faintText : theme.text;
}

}  // namespace

void addLabels(DrawList& list, const std::vector<PlacedLabel>& labels, const DiagramSizes& sizes,
               const Theme& theme) {
  const float size = sizes.legend;
  DrawLayer layer;
  for (const PlacedLabel& label : labels) {
    if (label.covers) addRectangle(layer, label.box, withAlpha(theme.background, 0.75F));
    if (label.arrow.size() == 2)
      addArrow(layer, label.arrow[0], label.arrow[1], 7 * sizes.unit, 1.4F * sizes.unit,
               theme.text);
    const float x = label.box.x + label.box.width / 2;
    for (std::size_t i = 0; i < label.lines.size(); ++i)
      addLabel(list, label.lines[i],
               {x, std::round(label.box.y + kLine * size * static_cast<float>(i) + 0.98F * size)},
               size, TextAnchor::Centre, labelColour(label, theme));
  }
  if (!layer.triangles.empty() || !layer.lines.empty()) list.layers.push_back(std::move(layer));
}

}  // namespace asperity
