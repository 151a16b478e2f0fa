#include "ui/chart/diagram_panel.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "ui/chart/diagram_field.h"
#include "ui/chart/diagram_series.h"
#include "ui/draw/fonts.h"

namespace asperity {

namespace {

constexpr float kLittleHidden = 0.03F;  // part of a legend's box
constexpr float kLowest = 4.5F;         // height of a frame in print, in letters

bool isOver(const Box& part, const Box& whole) {
  return part.right() <= whole.right() && part.y >= whole.y && part.bottom() <= whole.bottom();
}

}  // namespace

DiagramPanel::DiagramPanel(const Diagram& diagram, const Box& cell, float above, bool hasXLabels,
                           bool titleAbove, bool isAligned, bool isInRow, const DiagramSizes& sizes,
                           const Theme& theme)
    : diagram_(diagram),
      cell_(cell),
      sizes_(sizes),
      theme_(theme),
      isInRow_(isInRow),
      isAligned_(isAligned) {
  axes_.hasXLabels = hasXLabels;
  axes_.titleAbove = titleAbove;
  top_ = std::round(cell.y + above + aboveAxes(axes_, sizes));
  bottom_ = std::max(top_ + 1, std::floor(cell.bottom() - (hasXLabels ? belowAxes(sizes) : 0)));
  xRange_ = xRange(diagram);
  arrange();
}

void DiagramPanel::alignTo(float left, float right) {
  left_ = left;
  right_ = right;
  arrange();
}

void DiagramPanel::lowerTo(float top) {
  headroom_ = top - top_;
  arrange();
}

ChartGeometry DiagramPanel::geometry() const {
  const Box& box = axes_.box;
  return {QRectF(box.x, box.y, box.width, box.height), axes_.xAxis.range, axes_.yAxis.range,
          axes_.xAxis.scale, axes_.yAxis.scale};
}

bool DiagramPanel::hasTitle() const {
  return axes_.titleAbove || axes_.yAxis.title.empty() ||
         fitsUpright(axes_.yAxis.title, axes_.box.height, sizes_);
}

bool DiagramPanel::hasTitleInWords() const {
  return axes_.titleAbove || fitsUprightInWords(axes_.yAxis.title, axes_.box.height, sizes_);
}

bool DiagramPanel::isReadable() const {
  const Box& box = axes_.box;
  return box.width >= 4 * sizes_.tick && box.height >= 2 * sizes_.tick;
}

bool DiagramPanel::isWhole() const {
  const float least = axes_.titleAbove ? kLowest : 7;
  return isReadable() && axes_.box.height >= least * sizes_.tick && hasTitle() && hasWholeLegend();
}

bool DiagramPanel::hasWholeLegend() const {
  if (!showsLegend_) return sizes_.legendMode == LegendMode::None;
  return legend_.isWhole && (legend_.empty() || (legendBox_.width > 0 && hidden_ <= kLittleHidden));
}

void DiagramPanel::addTo(DrawList& list) const {
  if (!isReadable()) return;
  const Box& box = axes_.box;
  addSpans(list, diagram_, axes_, sizes_, theme_);
  if (diagram_.field) {
    addFieldColours(list, *diagram_.field, axes_);
    std::vector<Box> taken;
    for (const PlacedLabel& label : labels_) taken.push_back(label.box);
    std::vector<Polyline> borders;
    for (const DiagramSeries& series : diagram_.series)
      std::ranges::move(clippedCurve(series, axes_), std::back_inserter(borders));
    if (diagram_.marker) borders.push_back(markerLine());
    if (diagram_.marker && diagram_.marker->isCross) {
      const float y = axes_.py(axisPosition(axes_.yAxis.scale, diagram_.marker->y));
      borders.push_back({{box.x, y}, {box.right(), y}});
    }
    addContours(list, *diagram_.field, axes_, sizes_, taken, borders);
    addColourBar(list, colours_, box, sizes_, theme_);
  } else {
    addDiagramGrid(list, axes_, sizes_, theme_);
  }
  const float above = aboveFrame(diagram_, sizes_);
  // Marks at the edge of the frame are drawn over it.
  addDiagramFrame(list, axes_, sizes_, theme_, above);
  addMarkerLine(list);
  addHorizontalBars(list, diagram_, axes_, sizes_, theme_);
  addSeries(list, diagram_, styles_, axes_, sizes_, theme_);
  addSentence(list);
  addLabels(list, labels_, sizes_, theme_);
  if (legendBox_.width > 0)
    addLegend(list, legend_, legendBox_, isOver(legendBox_, box), sizes_, theme_);
  const float baseline = std::round(top_ - above - aboveAxes(axes_, sizes_) - 0.55F * sizes_.panel);
  const float size = fittingSize(diagram_.title.text, sizes_.panel,
                                 std::max(sizes_.minFontSize, std::round(0.8F * sizes_.panel)),
                                 true, cell_.right() - box.x);
  const std::string title = elided(diagram_.title.text, size, true, cell_.right() - box.x);
  if (!title.empty()) addText(list, {{title, true}}, {box.x, baseline}, size, theme_.text);
}

/// Returns the line of the marker from the bottom to the top.
std::vector<DrawPoint> DiagramPanel::markerLine() const {
  const Box& box = axes_.box;
  const float x = axes_.px(axisPosition(axes_.xAxis.scale, diagram_.marker->x));
  return {{x, box.y}, {x, box.bottom()}};
}

void DiagramPanel::addMarkerLine(DrawList& list) const {
  const Box& box = axes_.box;
  if (!diagram_.marker) return;
  const std::vector<DrawPoint> line = markerLine();
  if (!(line[0].x >= box.x && line[0].x <= box.right())) return;
  std::vector<Polyline> lines{line};
  const Box gap = sentenceBox();
  if (line[0].x > gap.x && line[0].x < gap.right())
    lines = {{line[0], {line[0].x, gap.y}}, {{line[1].x, gap.bottom()}, line[1]}};
  const DrawPoint at = axes_.mapToPosition(diagram_.marker->x, diagram_.marker->y);
  if (diagram_.marker->isCross && at.y >= box.y && at.y <= box.bottom())
    lines.push_back({{box.x, at.y}, {box.right(), at.y}});
  DrawLayer layer;
  const auto addLines = [&](float width, const Rgba& colour) {
    for (const Polyline& one : lines) addLine(layer, one, width * sizes_.unit, colour);
  };
  if (diagram_.field) {
    addLines(kEdgeOnFieldWidth, kEdgeOnField);
    addLines(kLineOnFieldWidth, kLineOnField);
  } else {
    addLines(1.2F, seriesColour(kMarkerColour, theme_));
  }
  list.layers.push_back(std::move(layer));
}

/// Returns the lines of the sentence that explains why there are no curves.
std::vector<std::string> DiagramPanel::sentenceLines() const {
  return wrapped(diagram_.blank.text, sizes_.legend, false, 0.9F * axes_.box.width);
}

/// Returns the box of that sentence; empty where there is none.
Box DiagramPanel::sentenceBox() const {
  const std::vector<std::string> lines = sentenceLines();
  if (lines.empty()) return {};
  const float size = sizes_.legend, width = widestLine(lines, size) + 2 * size;
  const float height = 1.4F * size * static_cast<float>(lines.size()) + size;
  const Box& box = axes_.box;
  return {box.x + (box.width - width) / 2, box.y + (box.height - height) / 2 + 0.3F * size, width,
          height};
}

void DiagramPanel::addSentence(DrawList& list) const {
  const Box& box = axes_.box;
  const float size = sizes_.legend;
  const std::vector<std::string> lines = sentenceLines();
  float baseline = box.y + box.height / 2 - 0.7F * size * static_cast<float>(lines.size());
  for (const std::string& line : lines) {
    baseline += 1.4F * size;
    addLabel(list, line, {box.x + box.width / 2, std::round(baseline)}, size, TextAnchor::Centre,
             theme_.text);
  }
}

/// Places the frame and the legend. On a screen the letters of the legend get smaller where only
/// that keeps all its names whole; where nothing does, it is the smallest, which names the most.
void DiagramPanel::arrange() {
  legendSize_ = sizes_.legend;
  arrangeLegend();
  if (sizes_.isPrinted || sizes_.legendMode != LegendMode::Automatic) return;
  while (!hasWholeLegend() && legendSize_ - 1 >= smallestLegend()) {
    --legendSize_;
    arrangeLegend();
  }
}

/// Returns the size of the smallest letters of a legend.
float DiagramPanel::smallestLegend() const {
  return std::max(sizes_.minFontSize, std::round(0.8F * sizes_.legend));
}

/// Places the frame and the legend: inside the frame where the legend hides nothing and is whole;
/// otherwise at the right of the frame or above it where there is enough space; otherwise below
/// the axis; otherwise beside it with shortened names. A legend that would still hide a curve is
/// left out, where the frame is aligned with others.
void DiagramPanel::arrangeLegend() {
  // The minimum parts of the frame that stay beside a legend.
  constexpr float kMinWidth = 0.55F, kMinHeight = 0.6F;
  below_ = 0;
  showsLegend_ = sizes_.legendMode != LegendMode::None;
  place(0, 0);
  if (sizes_.legendMode == LegendMode::Below) return placeBelow(legendBelow(legendSize_));
  if (sizes_.legendMode != LegendMode::Automatic) return;
  // A scale of colours that did not fit leaves an empty, incomplete legend.
  if (legend_.isWhole && (legend_.empty() || hidden_ <= 0)) return;
  const Box frame = axes_.box;
  const float gap = std::round(10 * sizes_.unit);
  const Legend beside =
      legendFor(diagram_, styles_, legendSize_, 0.36F * cell_.width, frame.height);
  const float least = beside.isWhole && !legend_.isWhole ? 0.45F : kMinWidth;
  const bool fitsBeside =
      !isAligned_ && !beside.empty() && frame.width - beside.width - gap > least * cell_.width;
  const Legend over = legendOver(diagram_, styles_, legendSize_, frame.width);
  const float rest = frame.height - std::max(0.0F, over.height - headroom_);
  const bool fitsAbove =
      over.isWhole && rest > std::max(kMinHeight * frame.height, 5 * sizes_.tick);
  const bool hidesCurve = hidden_ > kLittleHidden;
  const bool isRoomAbove = over.height <= headroom_;
  // Beside a frame in a row, a legend would make it narrower than the others.
  if (fitsAbove && (isRoomAbove || isInRow_ || !(fitsBeside && beside.isWhole))) {
    place(0, over.height);
    legend_ = over;
    const float above = aboveFrame(diagram_, sizes_) + aboveAxes(axes_, sizes_);
    legendBox_ = {axes_.box.x, axes_.box.y - over.height - above, over.width, over.height};
    hidden_ = 0;
    return;
  }
  const bool needsSpace = hidesCurve || (sizes_.isPrinted && !legend_.isWhole);
  if (needsSpace && !(fitsBeside && beside.isWhole) && fitBelow()) return;
  if (fitsBeside || (!isAligned_ && !beside.empty() && hidesCurve)) {
    place(beside.width + gap, 0);
    legend_ = beside;
    legendBox_ = {cell_.right() - beside.width, axes_.box.y, beside.width, beside.height};
    hidden_ = 0;
  } else if (hidesCurve) {
    showsLegend_ = false;
    place(0, 0);
  }
}

/// Places the legend below the axis and returns true where the frame stays high enough: where it
/// would not, in smaller letters, then with fewer entries.
bool DiagramPanel::fitBelow() {
  // On a screen a legend may rather be cut than take most of the frame.
  const float most = sizes_.isPrinted ? 1 : 0.5F;
  const float available =
      std::min(axes_.box.height - kLowest * sizes_.tick, most * axes_.box.height);
  const float smallest = smallestLegend();
  const auto fits = [&](const Legend& legend) {
    return legend.height <= available && legend.width <= cell_.width;
  };
  Legend below = legendBelow(legendSize_);
  while (!fits(below) && below.size - 1 >= smallest) below = legendBelow(below.size - 1);
  if (!fits(below)) below = legendFor(diagram_, styles_, smallest, cell_.width, available);
  const bool isOfUse = below.ramp || (!below.entries.empty() && below.entries.front().hasSample);
  if (!isOfUse || !fits(below)) return false;
  placeBelow(std::move(below));
  return true;
}

/// Returns the legend under the axis, in rows over the width of the panel.
Legend DiagramPanel::legendBelow(float size) const {
  Legend below = legendOver(diagram_, styles_, size, cell_.width);
  return below.isWhole || below.empty()
             ? below
             : legendFor(diagram_, styles_, size, cell_.width, 0.5F * cell_.height);
}

void DiagramPanel::placeBelow(Legend below) {
  if (below.empty()) return;
  below_ = below.height;
  place(0, 0);
  legend_ = std::move(below);
  const float left = std::min(axes_.box.x, cell_.right() - legend_.width);
  legendBox_ = {std::max(cell_.x, left), std::floor(cell_.bottom() - legend_.height), legend_.width,
                legend_.height};
  hidden_ = 0;
}

/// Lays out everything, with this many pixels free at the right and above the frame.
void DiagramPanel::place(float right, float above) {
  Box& box = axes_.box;
  box.y = top_ + std::max(above, headroom_);
  box.height = std::max(1.0F, bottom_ - below_ - box.y);
  axes_.yAxis = diagram_.bars.empty()
                    ? tickedYAxis(diagram_.y, yRange(diagram_, xRange_), box.height, sizes_)
                    : barAxis(diagram_, 0.45F * cell_.width, sizes_);
  if (hasNoValues(diagram_)) {
    axes_.yAxis.ticks.clear();
    axes_.yAxis.minor.clear();
  }
  float bar = 0;
  if (diagram_.field) {
    colours_ = colourAxis(*diagram_.field, box.height, sizes_);
    bar = colourBarWidth(colours_, sizes_);
  }
  box.x = std::round(std::max(left_, cell_.x + leftOfAxes(axes_, sizes_)));
  const auto fit = [&](float overhang) {
    const float end = right_ > 0 ? right_ : cell_.right() - right - std::max(bar, overhang);
    box.width = std::max(1.0F, std::floor(end - box.x));
    axes_.xAxis = tickedXAxis(diagram_.x, xRange_, box.width, sizes_);
  };
  fit(sizes_.tick);
  fit(overhang());
  styles_ = seriesStyles(diagram_, sizes_, theme_, box.width);
  // Letters that must not get smaller need more of a narrow frame.
  const float widest = sizes_.minFontSize > kSmallestFont ? 0.95F : 0.7F;
  // Labels need not avoid a legend that will be outside.
  const bool isInside = showsLegend_ && below_ <= 0 && right <= 0 && above <= 0;
  legend_ = isInside
                ? legendFor(diagram_, styles_, legendSize_, widest * box.width, 0.7F * box.height)
                : Legend{};
  OccupancyGrid series(box, 4 * sizes_.unit);
  coverSeries(series, diagram_, styles_, axes_);
  if (diagram_.marker) series.addLine(markerLine(), 1);
  OccupancyGrid map = series;
  labels_ = labelsOn(map);
  placeLegend(map);
  if (hidden_ <= 0 || labels_.empty()) return;
  // Labels avoid the legend.
  const DiagramPanel before = *this;
  placeLegend(series);
  series.addBox(legendBox_, kTaken);
  labels_ = labelsOn(series);
  if (labels_.size() < before.labels_.size() || hidden_ >= before.hidden_) {
    labels_ = before.labels_;
    legendBox_ = before.legendBox_;
    hidden_ = before.hidden_;
  }
}

/// Places the labels, none of them on the marker's line unless one would be missing without that.
std::vector<PlacedLabel> DiagramPanel::labelsOn(OccupancyGrid& map) const {
  OccupancyGrid clear = map;
  if (diagram_.marker) clear.addLine(markerLine(), kTaken);
  std::vector<PlacedLabel> beside = placeLabels(diagram_, axes_, clear, sizes_);
  OccupancyGrid onLine = map;
  std::vector<PlacedLabel> labels = placeLabels(diagram_, axes_, onLine, sizes_);
  if (beside.size() >= labels.size()) labels = std::move(beside);
  for (const PlacedLabel& label : labels) {
    map.addBox(grown(label.box, 0.25F * sizes_.legend), kTaken);
    if (!label.arrow.empty()) map.addLine(label.arrow, 3);
  }
  return labels;
}

void DiagramPanel::placeLegend(const OccupancyGrid& map) {
  const float margin = std::round(9 * sizes_.unit);
  legendBox_ = legend_.empty() ? Box{} : freestBox(map, legend_.width, legend_.height, margin);
  if (map.greatestUnder(legendBox_) >= kTaken) legendBox_ = {};
  hidden_ = legendBox_.width > 0 ? map.under(legendBox_) : 1;
}

/// Returns the length of the last label beyond the frame.
float DiagramPanel::overhang() const {
  const Box& box = axes_.box;
  float most = 2 * sizes_.unit;
  for (const Tick& tick : axes_.xAxis.ticks)
    most = std::max(most, axes_.px(tick.value) + textWidth(tick.label, sizes_.tick) / 2 -
                              box.right() + 2 * sizes_.unit);
  return most;
}

}  // namespace asperity
