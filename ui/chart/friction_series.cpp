#include "ui/chart/friction_series.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/chart/curve_regions.h"
#include "core/chart/curve_words.h"
#include "core/chart/few_summits.h"
#include "core/scene/effects.h"
#include "ui/chart/decade_range.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/draw/ticks.h"

namespace asperity {

namespace {

constexpr double kLowestPercent = -100, kHighestPercent = 200;  // of a strip's range
constexpr double kLeastPercent = 0.1;

Scene withoutPresent(Scene scene) {
  scene.title.clear();
  scene.description.clear();
  scene.chapter.clear();
  scene.sliding = {};
  return scene;
}

PlotSeries seriesOf(const CurveUpdate& curve, CurveAxes axes) {
  const auto [velocity, friction] = factorsOf(curve.points, axes);
  PlotSeries series;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const CurvePoint& point = curve.points[i];
    if (point.realizations > 0)
      series.points.push_back({point.velocity * velocity, point.mu * friction,
                               point.muStandardError * friction, static_cast<int>(i)});
  }
  series.points = plottable(series.points);
  return series;
}

QString withError(const QString& name, double value, double error) {
  const QString text = name + " = " + readingLabel(value);
  return std::isfinite(error) ? text + " ± " + readingLabel(error, 2) : text;
}

QString signedPercent(double part) {
  const QString text = readingLabel(std::abs(100 * part));
  return (part < 0 ? "−" : "+") + text + " %";
}

/// What there is of a curve while it is averaged.
QString shareText(const CurveUpdate& curve) {
  if (curve.isComplete) return {};
  return FrictionSeries::tr("%1 of %2 lines")
      .arg(curve.realizationsDone)
      .arg(curve.realizationsTotal);
}

/// Round ends around all values and 0, held within what can be read.
void fitRange(PlotStrip& strip) {
  double low = 0, high = 0;
  for (const PlotPoint& point : strip.points) {
    if (!std::isfinite(point.y)) continue;
    const double error = std::isfinite(point.error) ? point.error : 0;
    low = std::min(low, point.y - error);
    high = std::max(high, point.y + error);
  }
  const double size = std::max({-low, high, kLeastPercent});
  strip.from = std::max(low < 0 ? -roundUp(std::max(-1.1 * low, 0.15 * size)) : -0.15 * size,
                        kLowestPercent);
  strip.to = std::min(high > 0 ? roundUp(std::max(1.1 * high, 0.15 * size)) : 0.15 * size,
                      kHighestPercent);
}

}  // namespace

bool haveSameCurve(const Scene& a, const Scene& b) {
  return withoutPresent(a) == withoutPresent(b);
}

PlotSeries FrictionSeries::measured(const CurveUpdate& curve, CurveAxes axes) {
  PlotSeries series = seriesOf(curve, axes);
  const bool isPart = curve.scene && hasLocalFriction(*curve.scene);  // not the interface's
  if (isOneLine(curve))
    series.name = isPart ? tr("this line, deformation alone") : tr("this line");
  else
    series.name = isPart ? tr("mean of the lines ± standard error, deformation alone")
                         : tr("mean of the lines ± standard error");
  return series;
}

PlotSeries FrictionSeries::law(const CurveUpdate& curve, CurveAxes axes) {
  const auto [velocity, friction] = factorsOf(curve.points, axes);
  PlotSeries series;
  series.name = tr("Eq. (11)");
  series.style = PlotStyle::Line;
  series.id = kLawCurve;
  for (const CurvePoint& point : curve.points)
    series.points.push_back({point.velocity * velocity, point.muLaw * friction});
  series.points = plottable(series.points);
  return series;
}

PlotSeries FrictionSeries::pinned(const CurveUpdate& curve, CurveAxes axes, int id, int place,
                                  const QString& name) {
  constexpr std::array marks{PlotMark::Square, PlotMark::Triangle, PlotMark::Diamond};
  PlotSeries series = seriesOf(curve, axes);
  series.name = name;
  series.id = id;
  series.place = place;
  // Another mark where colours repeat.
  series.mark = marks[static_cast<std::size_t>(place + place / kPinColours) % marks.size()];
  return series;
}

std::vector<PlotSpan> FrictionSeries::regions(const CurveUpdate& curve, CurveAxes axes) {
  struct Text {
    const char* name;
    QString word, tip;
  };
  const Text texts[] = {
      {"I", tr("linear"),
       tr("Region I: friction grows in proportion to velocity, Eqs. (5) to (8). It ends where the "
          "curve is 20 % below that line.")},
      {"II", tr("transition"),
       tr("Region II: from the line to the plateau. It ends where 95 % of the maximum is "
          "reached.")},
      {"III", tr("plateau"),
       tr("Region III: contacts carry on their leading sides only, Eq. (9). It ends where friction "
          "falls below 95 % of the maximum.")},
      {"IV", tr("decrease"),
       tr("Region IV: few summits of the finite period carry the load, and the slope in contact "
          "falls, Eq. (15). It begins below 95 % of the maximum.")}};
  const double factor = factorsOf(curve.points, axes).velocity;
  std::vector<PlotSpan> spans;
  if (!std::isfinite(factor)) return spans;
  const bool isTinted = fewSummitsOf(*curve.scene, curve.points).has_value();
  for (const CurveRegion& region : regionsOfCurve(*curve.scene, curve.points))
    for (const Text& text : texts)
      if (region.name == text.name) {
        QString tip = text.tip + "\n" + tr("Borders are read from this curve, not from theory.");
        if (isTinted && region.name == "IV") tip += "\n" + translatedText(kFewSummitsSentence);
        spans.push_back(
            {text.name, text.word, tip, region.from * factor, region.to * factor, false});
      }
  return spans;
}

std::vector<PlotSpan> FrictionSeries::shades(const CurveUpdate& curve, CurveAxes axes) {
  const double factor = factorsOf(curve.points, axes).velocity;
  const std::optional<VelocityRange> few = fewSummitsOf(*curve.scene, curve.points);
  if (!few || !std::isfinite(factor)) return {};
  return {{tr("few summits carry the load"), {}, {}, few->from * factor, few->to * factor, false}};
}

PlotStrip FrictionSeries::strip(const CurveDifference& difference, const CurveUpdate& curve,
                                CurveAxes axes) {
  const double factor = factorsOf(curve.points, axes).velocity;
  PlotStrip strip;
  strip.title = tr("difference");
  strip.name = tr("%1, less the curve above").arg(translatedText(nameOf(difference.setting)));
  if (difference.done < difference.total)
    strip.note = tr("%1 of %2 lines").arg(difference.done).arg(difference.total);
  for (std::size_t i = 0; i < difference.points.size(); ++i) {
    const DifferencePoint& point = difference.points[i];
    strip.points.push_back({point.velocity * factor, 100 * point.relative,
                            100 * point.standardError, static_cast<int>(i)});
  }
  fitRange(strip);
  return strip;
}

QString FrictionSeries::nameOfPinned(const CurveUpdate& curve, const Scene& present) {
  const QString words = translatedText(differencesInWords(*curve.scene, present));
  const QString name = words.isEmpty() ? tr("same parameters") : words;
  const QString share = shareText(curve);
  return share.isEmpty() ? name : QStringLiteral("%1 (%2)").arg(name, share);
}

QString FrictionSeries::reading(const CurvePoint& point, CurveAxes axes) {
  QStringList lines;
  lines += tr("v = %1 m/s").arg(readingLabel(point.velocity));
  lines += withError(QStringLiteral("μ"), point.mu, point.muStandardError);
  if (axes == CurveAxes::Dimensionless) {
    lines.prepend(QStringLiteral("v̄ = ") + readingLabel(point.dimensionlessVelocity));
    lines += withError(QStringLiteral("μ / ∇z"), point.normalizedMu,
                       point.muStandardError * point.normalizedMu / point.mu);
  }
  lines += tr("in contact %1 %").arg(readingLabel(100 * point.contactFraction));
  if (std::isfinite(point.muLaw)) lines += tr("Eq. (11): %1").arg(readingLabel(point.muLaw));
  return lines.join('\n');
}

QString FrictionSeries::reading(const DifferencePoint& point, const CurveSetting& setting) {
  QString difference = tr("difference %1").arg(signedPercent(point.relative));
  if (std::isfinite(point.standardError))
    difference += " ± " + readingLabel(100 * point.standardError, 2) + " %";
  return tr("v = %1 m/s").arg(readingLabel(point.velocity)) + '\n' + difference + '\n' +
         withError(QStringLiteral("μ"), point.mu, point.muStandardError) + ' ' +
         tr("with %1").arg(translatedText(nameOf(setting)));
}

}  // namespace asperity
