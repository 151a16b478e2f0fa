#include "ui/chart/point_text.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "core/chart/curve_diagram.h"
#include "core/chart/curve_words.h"
#include "core/scene/sweep.h"
#include "ui/draw/ticks.h"
#include "ui/language/translated.h"

namespace asperity {

namespace {

struct PointText {
  Q_DECLARE_TR_FUNCTIONS(asperity::PointText)
};

QString withError(const QString& name, double value, double error) {
  return name + " = " + QString::fromStdString(numberWithError(value, error));
}

QString withUnit(const QString& name, double value, std::string_view unit, int digits = 3) {
  return name + " = " + QString::fromStdString(quantity(value, unit, digits));
}

QString velocityText(double velocity) {
  return withUnit(QStringLiteral("v"), velocity, "m/s");
}

QString signedPercent(double part) {
  const QString text = readingLabel(std::abs(100 * part));
  return (part < 0 ? "−" : "+") + text + " %";
}

/// Returns the position on the axis of the reduced velocity, and the temperature; empty where the
/// axis is another one.
QStringList reducedLines(const CurveSet& set, double velocity, double reduced, double temperature) {
  QStringList lines;
  if (set.axes == CurveAxes::Physical && reduced != velocity)
    lines += withUnit(QStringLiteral("a\u1D1B v"), reduced, "m/s");
  if (std::isfinite(temperature)) lines += "T = " + translatedText(celsius(temperature));
  return lines;
}

QString curvePointText(const CurvePoint& point, const Scene& scene, const CurveSet& set) {
  QStringList lines;
  if (!set.isOfVelocity())
    lines += readingText(describeParameter(scene.sweep.key, withSweptValue(scene, point.swept)));
  lines += velocityText(point.velocity);
  if (set.hasReducedAxis())
    lines +=
        reducedLines(set, point.velocity, abscissa(point, scene, set), scene.elastomer.temperature);
  if (!set.isOfMu()) {
    const QuantityEntry& entry = quantityEntry(set.y);
    lines += withUnit(translatedText(entry.title), quantityValue(set.y, point), entry.unit);
  }
  lines += withError(QStringLiteral("μ"), point.mu, point.muStandardError);
  if (std::isfinite(point.muInterface) && set.y != CurveQuantity::MuTotal)
    lines +=
        PointText::tr("with local friction: %1").arg(readingLabel(totalMu(point), 3, Zeros::Keep));
  if (set.axes == CurveAxes::Dimensionless) {
    lines.prepend(QStringLiteral("v̄ = ") + readingLabel(point.dimensionlessVelocity));
    lines += withError(QStringLiteral("μ / ∇z"), point.normalizedMu,
                       point.muStandardError * point.normalizedMu / point.mu);
  }
  lines += PointText::tr("in contact %1 %").arg(readingLabel(100 * point.contactFraction));
  if (std::isfinite(point.muLaw))
    lines += PointText::tr("Eq. (11): %1").arg(readingLabel(point.muLaw, 3, Zeros::Keep));
  return lines.join('\n');
}

QString measuredPointText(const MeasuredCurve& measured, std::size_t index, const CurveSet& set) {
  const MeasuredPoint& point = measured.data.points[index];
  const QString name = QString::fromStdString(measured.data.name);
  QStringList lines{point.label.empty() ? name : name + ", " + QString::fromStdString(point.label)};
  lines += velocityText(point.velocity);
  if (index < measured.abscissas.size() && set.isOfVelocity())
    lines += reducedLines(set, point.velocity, measured.abscissas[index], point.temperature);
  lines += withError(QStringLiteral("μ"), point.mu, point.muError);
  if (index < measured.computed.size())
    lines += PointText::tr("computed: %1").arg(readingLabel(totalMu(measured.computed[index])));
  return lines.join('\n');
}

QString differenceText(const DifferencePoint& point, const CurveSetting& setting) {
  QString difference = PointText::tr("difference %1").arg(signedPercent(point.relative));
  if (std::isfinite(point.standardError))
    difference += " ± " + readingLabel(100 * point.standardError, 2) + " %";
  return velocityText(point.velocity) + '\n' + difference + '\n' +
         withError(QStringLiteral("μ"), point.mu, point.muStandardError) + ' ' +
         PointText::tr("with %1").arg(translatedText(settingName(setting)));
}

}  // namespace

const NamedCurve* findCurve(const CurveSet& set, int id) {
  if (id == kPresentCurve || id == kTotalCurve) return &set.present;
  const auto found = std::ranges::find(set.pinned, id, &NamedCurve::id);
  return found == set.pinned.end() ? nullptr : &*found;
}

QString pointText(const CurveSet& set, int id, int row) {
  const auto index = static_cast<std::size_t>(row);
  if (id == kDifferenceCurve)
    return set.difference && index < set.difference->points.size()
               ? differenceText(set.difference->points[index], set.difference->setting)
               : QString();
  if (id <= kMeasuredCurves) {
    const auto table = static_cast<std::size_t>(kMeasuredCurves - id);
    return table < set.measured.size() && index < set.measured[table].data.points.size()
               ? measuredPointText(set.measured[table], index, set)
               : QString();
  }
  const NamedCurve* curve = findCurve(set, id);
  if (!curve || index >= curve->points.size()) return {};
  const QString text = curvePointText(curve->points[index], curve->scene, set);
  return curve == &set.present ? text : translatedText(curve->name) + '\n' + text;
}

}  // namespace asperity
