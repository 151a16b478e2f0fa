#include "ui/chart/chart_layout.h"

#include <QFontMetricsF>
#include <QString>
#include <algorithm>
#include <cmath>

#include "ui/chart/diagram_axes.h"
#include "ui/chart/diagram_layout.h"

namespace asperity {

namespace {

constexpr double kSmall = 20;       // pixels, of a frame that does not fit
constexpr double kMinLines = 1.8;   // minimum height of a second diagram, in lines of text
constexpr double kMinAbove = 2.6;   // the same of the first one, above a second one
constexpr double kMinStrip = 2.0;   // the same of a strip; fewer of them are shown in a low view
constexpr double kMinTitle = 0.8;   // of its usual size, for a title of the y-axis
constexpr double kBesideGap = 8;    // pixels at each side of titles beside strips
constexpr double kMaxBeside = 0.2;  // part of the width for titles in one line, at most

/// Returns the width of titles beside strips, which are too low for upright titles. A title has one
/// line where that leaves most of the width to the strips, otherwise two, otherwise one for each
/// word.
double besideTitleWidth(const DiagramSheet& sheet, double width, const QFontMetricsF& metrics) {
  if (!hasStrips(sheet)) return 0;
  double whole = 0, halves = 0, words = 0;
  for (const Diagram& diagram : sheet.diagrams) {
    const std::string unit = diagram.y.unit.empty() ? " (10⁻⁸)" : " (m" + diagram.y.unit + ")";
    const QString title = QString::fromStdString(diagram.y.title.text + unit);
    const auto textWidth = [&](const QString& text) { return metrics.horizontalAdvance(text); };
    whole = std::max(whole, textWidth(title));
    double half = textWidth(title);
    for (qsizetype at = title.indexOf(' '); at >= 0; at = title.indexOf(' ', at + 1))
      half = std::min(half, std::max(textWidth(title.left(at)), textWidth(title.mid(at + 1))));
    halves = std::max(halves, half);
    for (const QString& word : title.split(' ')) words = std::max(words, textWidth(word));
  }
  const double most = kMaxBeside * width;
  return std::ceil(whole < most ? whole : halves < most ? halves : words) + 2;
}

}  // namespace

ChartLayout layOutChart(const DiagramSheet& sheet, const VisibleRange& shown, const QSizeF& size,
                        const ChartStyle& style, bool hasChoosers) {
  ChartLayout layout;
  const std::vector<Diagram>& diagrams = sheet.diagrams;
  if (diagrams.empty()) return layout;
  const QFontMetricsF metrics(style.font);
  const double line = metrics.height(), scale = style.scale(), edge = kFrameEdge * scale;
  const double names = std::max(18.0, std::ceil(line));
  const double beside = besideTitleWidth(sheet, size.width(), metrics);
  const bool hasUprightTitle = beside == 0 && !(hasChoosers && diagrams.size() == 1);
  const double left =
      12 + (hasUprightTitle ? line : 0) + metrics.horizontalAdvance(QStringLiteral("5×10⁻⁵")) + 12;
  // The right margin holds half of the label at the end of the x-axis, or the titles.
  const double half = metrics.horizontalAdvance(QStringLiteral("10⁻⁵")) / 2 + 4;
  const double right = beside > 0 ? beside + 2 * kBesideGap : std::max(18.0, half);
  const double above = diagrams[0].spans.empty() ? 9 : names + 2;
  const double below = hasChoosers ? line + 12 : 2 * line + 20;
  double gap = beside > 0 ? 8 : 12;
  const double available = size.height() - above - below;
  std::size_t count = diagrams.size();
  double share = 0;
  for (const Diagram& diagram : diagrams) share += diagram.height;
  const auto frameHeight = [&](std::size_t i) {
    const double all = available - static_cast<double>(count - 1) * gap;
    const double height = std::floor(all * diagrams[i].height / share);
    // In a low view the first diagram gives the second one the height that it needs.
    const double second = std::ceil(kMinLines * line);
    const bool isTight = count == 2 && all * diagrams[1].height / share < second;
    if (!isTight || all - second < kMinAbove * line) return height;
    return i == 0 ? std::floor(all - second) : second;
  };
  // The title of a strip is above it where the strip is too low for an upright one.
  const auto isTooLowFor = [&](std::size_t i) {
    const double length =
        metrics.horizontalAdvance(QString::fromStdString(diagrams[i].y.title.text));
    return kMinTitle * length > frameHeight(i);
  };
  for (std::size_t i = 1; i < count && beside == 0; ++i) layout.hasTitlesAbove |= isTooLowFor(i);
  if (layout.hasTitlesAbove) gap = line + 5;
  const double least = (hasStrips(sheet) ? kMinStrip : kMinLines) * line;
  while (count > 1 && frameHeight(count - 1) < least) share -= diagrams[--count].height;
  const double width = size.width() - left - right;
  double top = above;
  for (std::size_t i = 0; i < count; ++i) {
    ChartGeometry map;
    map.area = QRectF(left, top, width, frameHeight(i));
    if (!(width > kSmall && map.area.height() > kSmall)) map.area.setSize({kSmall, kSmall});
    map.area.adjust(edge, 0, -edge, 0);
    map.x = shown.x;
    map.y = i == 0 ? shown.y : yRange(diagrams[i], shown.x);
    map.xScale = diagrams[i].x.scale;
    map.yScale = diagrams[i].y.scale;
    map.names = names;
    map.scale = scale;
    top = map.area.bottom() + gap;
    layout.frames.push_back(map);
  }
  layout.titleBeside = beside;
  return layout;
}

}  // namespace asperity
