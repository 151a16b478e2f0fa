#include "ui/chart/diagram_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "ui/chart/diagram_annotations.h"
#include "ui/chart/diagram_panel.h"
#include "ui/language/translated.h"

namespace asperity {
namespace {

/// Returns the height above the frames for titles and names of regions, the same for all of the
/// sheet, with some space that titles of axes include.
float aboveFrames(const DiagramSheet& sheet, bool titlesAbove, const DiagramSizes& sizes) {
  float title = 0, names = 0;
  for (const Diagram& diagram : sheet.diagrams) {
    if (!diagram.title.empty()) title = 1.6F * sizes.panel;
    names = std::max(names, aboveFrame(diagram, sizes));
  }
  return title + names + std::round((titlesAbove ? 0.1F : 0.8F) * sizes.tick);
}

DrawList emptyList(const DiagramOptions& options) {
  DrawList list;
  list.width = options.width;
  list.height = options.height;
  list.background = options.theme.background;
  return list;
}

/// Lowers the frames of each row to the lowest of them, beside a legend above it. A frame that
/// would lose much of its height, or names of its legend, stays.
std::vector<DiagramPanel> withCommonTops(const std::vector<DiagramPanel>& panels,
                                         std::size_t columns) {
  constexpr float kMinHeight = 0.6F;  // of the height
  std::vector<DiagramPanel> aligned;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    float top = 0;
    const std::size_t first = i - i % columns;
    for (std::size_t k = first; k < std::min(first + columns, panels.size()); ++k)
      top = std::max(top, panels[k].frame().y);
    DiagramPanel lowered = panels[i];
    if (lowered.frame().y < top) lowered.lowerTo(top);
    const bool isAsGood = lowered.frame().y == top &&
                          lowered.frame().height >= kMinHeight * panels[i].frame().height &&
                          (lowered.hasWholeLegend() || !panels[i].hasWholeLegend());
    aligned.push_back(isAsGood ? lowered : panels[i]);
  }
  return aligned;
}

std::vector<DiagramPanel> panelsBetween(float top, float bottom, const DiagramSheet& sheet,
                                        const DiagramOptions& options, bool titlesAbove) {
  constexpr float kBetweenRows = 14, kLittle = 6;  // units
  const DiagramSizes sizes = sizesFor(sheet, options);
  std::vector<Box> cells =
      cellsFor(sheet, options, top, bottom, sizes, titlesAbove ? kLittle : kBetweenRows);
  const float above = aboveFrames(sheet, titlesAbove, sizes);
  std::vector<DiagramPanel> panels;
  const bool isCommon = hasCommonAxis(sheet);
  const bool isStack = gridFor(sheet).columns == 1 && sheet.diagrams.size() > 1;
  const bool isAligned = !sheet.diagrams.empty() && (isStack || options.above);
  if (options.above)  // the labels of the picture above begin nearer to the edge
    for (Box& cell : cells) {
      const float nearer = 0.6F * sheetMargin(sizes);
      cell.x -= nearer;
      cell.width += nearer;
    }
  for (std::size_t i = 0; i < sheet.diagrams.size(); ++i)
    panels.emplace_back(sheet.diagrams[i], cells[i], above,
                        !isCommon || i + 1 == sheet.diagrams.size(), titlesAbove, isAligned,
                        gridFor(sheet).columns > 1, sizes, options.theme);
  if (isAligned) {
    float left = 0, right = static_cast<float>(options.width);
    for (const DiagramPanel& panel : panels) {
      left = std::max(left, panel.frame().x);
      right = std::min(right, panel.frame().right());
    }
    if (options.above) left = std::max(left, options.above->left);
    if (options.above && options.above->right > 0) right = options.above->right;
    for (DiagramPanel& panel : panels) panel.alignTo(left, right);
  }
  return withCommonTops(panels, static_cast<std::size_t>(gridFor(sheet).columns));
}

/// Leaves the legend to the first diagram where the legends of all others have nothing more: in
/// print they would only take space.
void shareLegend(DiagramSheet& sheet) {
  if (sheet.diagrams.size() < 2) return;
  const auto legendNames = [](const Diagram& diagram) {
    std::set<std::string> names;
    for (const DiagramSeries& series : diagram.series)
      if (!series.name.empty()) names.insert(series.name.text);
    if (diagram.ramp)
      names.insert(diagram.ramp->title.text + '\n' + diagram.ramp->from.text + '\n' +
                   diagram.ramp->to.text);
    return names;
  };
  const std::set<std::string> first = legendNames(sheet.diagrams.front());
  const bool isCommon = std::ranges::all_of(sheet.diagrams, [&](const Diagram& diagram) {
    return std::ranges::includes(first, legendNames(diagram));
  });
  if (!isCommon) return;
  for (std::size_t i = 1; i < sheet.diagrams.size(); ++i) {
    for (DiagramSeries& series : sheet.diagrams[i].series) series.name = {};
    sheet.diagrams[i].ramp.reset();
  }
}

/// Gives the y-axis the range of the present points, if there are any.
void holdYAxis(Diagram& diagram) {
  if (std::ranges::none_of(diagram.series,
                           [&](const DiagramSeries& series) { return hasPoints(series, diagram); }))
    return;
  const AxisRange range = yRange(diagram, xRange(diagram));
  diagram.y.from = axisValue(diagram.y.scale, range.from);
  diagram.y.to = axisValue(diagram.y.scale, range.to);
}

/// Adds the marker as series: its trace, and a ring around its dot, which may lie in the middle of
/// the trace. The trace does not widen a logarithmic axis, because it goes to 0 where friction
/// changes its direction.
void addMarker(Diagram& diagram) {
  if (!diagram.marker) return;
  const DiagramMarker& marker = *diagram.marker;
  DiagramSeries trace, dot;
  trace.colour = dot.colour = kMarkerColour;
  trace.points = marker.trace;
  dot.name = marker.name;
  dot.mark = SeriesMark::Circle;
  dot.stroke = SeriesStroke::None;
  dot.points = {{marker.x, marker.y}};
  DiagramSeries ring = dot;
  ring.name = {};
  ring.mark = SeriesMark::Ring;
  if (!marker.label.empty()) diagram.labels.push_back({marker.label, marker.x, marker.y});
  // At rest there is no dot on a logarithmic axis: the name then is that of the line, which has
  // no points, or without a line that of the trace.
  const bool hasLine = std::isfinite(axisPosition(diagram.x.scale, marker.x));
  const bool hasDot = hasPosition(diagram, dot.points.front());
  if (!hasDot && hasLine) dot.points.clear();
  if (!hasDot && !hasLine && !trace.points.empty()) trace.name = marker.name;
  const auto under = static_cast<std::ptrdiff_t>(diagram.series.size());
  for (DiagramSeries* series : {&ring, &dot})
    if (!series->points.empty() || !series->name.empty())
      diagram.series.push_back(std::move(*series));
  if (trace.points.empty()) return;
  if (diagram.y.scale == AxisScale::Logarithmic) holdYAxis(diagram);
  diagram.series.insert(diagram.series.begin() + under, std::move(trace));
}

/// Returns the sheet in the current language, with markers as series.
DiagramSheet prepared(const DiagramSheet& english, const DiagramOptions& options) {
  DiagramSheet sheet = translated(english);
  // Letters of a given size need panels of a width that holds their legends.
  constexpr float kNarrowestPanel = 26;  // letters
  const float letters = options.format.fontSize;
  if (letters > 0) {
    const int most =
        static_cast<int>(static_cast<float>(options.width) / (kNarrowestPanel * letters));
    if (most < gridFor(sheet).columns) sheet.columns = std::max(most, 1);
    shareLegend(sheet);
  }
  for (Diagram& diagram : sheet.diagrams) addMarker(diagram);
  return sheet;
}

/// Returns whether titles above strips say more than upright ones, of which some are symbols, and
/// leave the frames nearly as high.
bool areBetterAbove(const DiagramSheet& sheet, const std::vector<DiagramPanel>& upright,
                    const std::vector<DiagramPanel>& above) {
  constexpr float kMinHeight = 0.8F;  // of the height
  if (!hasStrips(sheet) || std::ranges::all_of(upright, &DiagramPanel::hasTitleInWords))
    return false;
  for (std::size_t i = 0; i < upright.size(); ++i)
    if (above[i].frame().height < kMinHeight * upright[i].frame().height) return false;
  return true;
}

/// Places the panels; heading and note are added to `list`. Titles of the y-axes are upright, or
/// above all frames where they do not fit beside one and the frames leave enough space.
std::vector<DiagramPanel> placePanels(const DiagramSheet& sheet, const DiagramOptions& options,
                                      DrawList& list) {
  const DiagramSizes sizes = sizesFor(sheet, options);
  const float top = addHeading(list, sheet, sizes, options.theme);
  const float bottom = addNote(list, sheet, sizes, options.theme);
  std::vector<DiagramPanel> panels = panelsBetween(top, bottom, sheet, options, false);
  const bool hasTitles = std::ranges::all_of(panels, &DiagramPanel::hasTitle);
  if (hasTitles && std::ranges::all_of(panels, &DiagramPanel::hasTitleInWords)) return panels;
  std::vector<DiagramPanel> others = panelsBetween(top, bottom, sheet, options, true);
  if (hasTitles && !areBetterAbove(sheet, panels, others)) return panels;
  return std::ranges::all_of(others, &DiagramPanel::isReadable) ? others : panels;
}

std::vector<DiagramPanel> placePanels(const DiagramSheet& sheet, const DiagramOptions& options) {
  DrawList unused = emptyList(options);
  return placePanels(sheet, options, unused);
}

/// Returns the sheet as it is drawn: in print without its note where only that makes the legend
/// complete.
DiagramSheet fitted(const DiagramSheet& english, const DiagramOptions& options) {
  DiagramSheet sheet = prepared(english, options);
  if (!(options.format.fontSize > 0) || sheet.note.empty()) return sheet;
  const auto isComplete = [&](const DiagramSheet& one) {
    return std::ranges::all_of(placePanels(one, options), &DiagramPanel::hasWholeLegend);
  };
  DiagramSheet withoutNote = sheet;
  withoutNote.note = {};
  return !isComplete(sheet) && isComplete(withoutNote) ? withoutNote : sheet;
}

/// Returns the height of the lowest picture, from options.height in these steps, in which all
/// panels pass the test; 0 where there is none up to `highest`.
int lowestHeight(const DiagramSheet& sheet, DiagramOptions options, int step, int highest,
                 bool (DiagramPanel::*test)() const) {
  for (; options.height <= highest; options.height += step)
    if (std::ranges::all_of(placePanels(sheet, options), test)) return options.height;
  return 0;
}

}  // namespace

DiagramOptions printOptions(const DiagramSheet& sheet, const Theme& theme) {
  const SheetGrid grid = gridFor(sheet);
  DiagramOptions options;
  options.width = grid.columns == 1 ? 2400 : 1200 * grid.columns;
  options.height = sheet.diagrams.size() <= 1 ? 1600 : 1100 * grid.rows;
  options.scale = sheet.diagrams.size() <= 1 ? 2 : 2.5F;
  options.theme = theme;
  return options;
}

int heightForAll(const DiagramSheet& english, const DiagramOptions& options) {
  constexpr int kHighest = 20000;
  return lowestHeight(prepared(english, options), options, 10, kHighest,
                      &DiagramPanel::isWellReadable);
}

int heightInPrint(const DiagramSheet& english, const DiagramOptions& options) {
  if (english.diagrams.size() < 2 && !options.above) return options.height;
  // Steps of half a letter, to three times the width, which is more than a page.
  const int step = std::max(1, static_cast<int>(options.format.fontSize / 2));
  const int height = lowestHeight(prepared(english, options), options, step, 3 * options.width,
                                  &DiagramPanel::isWhole);
  return height > 0 ? height : options.height;
}

bool isWhole(const DiagramSheet& english, const DiagramOptions& options) {
  return std::ranges::all_of(placePanels(prepared(english, options), options),
                             &DiagramPanel::isWhole);
}

float lowestFrame(const DiagramSheet& english, const DiagramOptions& options) {
  const DiagramSheet sheet = prepared(english, options);
  float lowest = std::numeric_limits<float>::infinity();
  for (const DiagramPanel& panel : placePanels(sheet, options))
    lowest = std::min(lowest, panel.isReadable() ? panel.frame().height : 0);
  return lowest / sizesFor(sheet, options).tick;
}

std::vector<ChartGeometry> diagramFrames(const DiagramSheet& english,
                                         const DiagramOptions& options) {
  std::vector<ChartGeometry> frames;
  for (const DiagramPanel& panel : placePanels(fitted(english, options), options))
    frames.push_back(panel.geometry());
  return frames;
}

DiagramSheet withoutCrowding(DiagramSheet sheet, const DiagramOptions& options) {
  constexpr float kGood = 3;  // in heights of a number
  if (sheet.diagrams.size() > 1 && lowestFrame(sheet, options) < kGood) sheet.diagrams.pop_back();
  if (lowestFrame(sheet, options) < kGood) sheet.note = {};
  return sheet;
}

DrawList composeDiagrams(const DiagramSheet& english, const DiagramOptions& requested) {
  DiagramOptions options = requested;
  options.width = std::max(options.width, 1);
  options.height = std::max(options.height, 1);
  const DiagramSheet sheet = fitted(english, options);
  DrawList list = emptyList(options);
  for (const DiagramPanel& panel : placePanels(sheet, options, list)) panel.addTo(list);
  return list;
}

}  // namespace asperity
