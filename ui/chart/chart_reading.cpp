#include "ui/chart/chart_reading.h"

#include <QStringList>

#include "ui/language/translated.h"

namespace asperity {

std::optional<HoverExplanation> explanationAt(const ReadableChart& chart, const ChartTarget& target,
                                              QPointF position) {
  if (chart.frames.empty()) return std::nullopt;
  if (target.isPoint()) return findExplanation(targetSeries(chart.english, target).name);
  const Diagram& diagram = chart.english.diagrams[0];
  if (target.span >= 0)
    return findExplanation(std::string_view(
        "region " + diagram.spans[static_cast<std::size_t>(target.span)].shortLabel));
  if (target.isMarker) return std::nullopt;
  for (const QRectF& name : chart.shadeNames)
    if (name.contains(position) && !diagram.shades.empty())
      return findExplanation(diagram.shades.front().label);
  return std::nullopt;
}

QString tipText(const ReadableChart& chart, const ChartTarget& target, QPointF position,
                const DescribePoint& describe) {
  if (chart.frames.empty()) return {};
  if (target.isPoint())
    return describe ? describe(targetSeries(chart.sheet, target).id,
                               targetPoint(chart.sheet, target).row)
                    : QString();
  const auto explanation = explanationAt(chart, target, position);
  if (target.span >= 0) {
    const DiagramSpan& span = chart.sheet.diagrams[0].spans[static_cast<std::size_t>(target.span)];
    QStringList lines{QString::fromStdString(span.label.text)};
    if (explanation && !explanation->formula.empty()) lines += formulaText(explanation->formula);
    for (const Message& note : span.notes) lines += QString::fromStdString(note.text);
    return lines.join('\n');
  }
  if (explanation)
    return translatedText(Message(explanation->sentence)) + '\n' +
           formulaText(explanation->formula);
  return position.y() > chart.frames.back().area.bottom() ? chart.cutTitle : QString();
}

QList<QRectF> neighbours(const ReadableChart& chart, const ChartTarget& target) {
  QList<QRectF> found;
  if (target.isPoint()) {
    const auto index = static_cast<std::size_t>(target.diagram);
    const ChartGeometry& map = chart.frames[index];
    const double reach = kPointReach * map.scale;
    const DiagramPoint& own = targetPoint(chart.sheet, target);
    for (const DiagramSeries& series : chart.sheet.diagrams[index].series)
      if (series.id != -1 && series.mark != SeriesMark::None)
        for (const DiagramPoint& point : series.points)
          if (const QPointF at = map.at(point.x, point.y); &point != &own && isFinite(at))
            found += QRectF(at.x() - reach, at.y() - reach, 2 * reach, 2 * reach);
  } else if (target.span >= 0) {
    const ChartGeometry& map = chart.frames[0];
    found += QRectF(map.area.left(), map.area.top() - map.names, map.area.width(), map.names);
  }
  return found;
}

}  // namespace asperity
