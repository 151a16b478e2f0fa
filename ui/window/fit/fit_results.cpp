#include "ui/window/fit/fit_results.h"

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/scene/parameters.h"
#include "core/scene/provenance.h"
#include "ui/chart/diagram_picture.h"
#include "ui/draw/picture_file.h"
#include "ui/draw/ticks.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/number_text.h"
#include "ui/panels/parameter_text.h"
#include "ui/window/fit/fit_page.h"

namespace asperity {

// ---- In words

namespace {

/// Returns the range as the report states it; a dash where the data leave an end open.
QString rangeText(const FittedParameter& parameter) {
  if (!std::isfinite(parameter.low) || !std::isfinite(parameter.high)) return QStringLiteral("–");
  return readingText(rangeOf(parameter)).toHtmlEscaped();
}

QString stateText(const FittedParameter& parameter, const Fit& fit, const QColor& warning) {
  const auto warn = [&](const QString& text) {
    return QStringLiteral("<span style='color:%1'>⚠ %2</span>").arg(warning.name(), text);
  };
  if (!fit.hasFoundPoints) return warn(FitPage::tr("curve misses the points"));
  if (!parameter.isDetermined) return warn(FitPage::tr("not determined"));
  if (parameter.isAtLimit) return warn(FitPage::tr("at its limit"));
  if (fit.missesPoints) return warn(FitPage::tr("curve misses the points"));
  return FitPage::tr("determined");
}

/// The symbol, or the name where there is none.
QString shortName(const FittedParameter& parameter) {
  const Parameter& row = *findParameter(parameter.key);
  return row.symbol.empty() ? labelText(row).toHtmlEscaped() : symbolHtml(row.symbol);
}

/// Returns a message of core with the names of the panel instead of keys.
Message withParameterNames(Message message) {
  for (Message& value : message.values) {
    if (const Parameter* parameter = findParameter(value.text))
      value = Message(std::string(parameter->label));
    else
      value = withParameterNames(value);
  }
  return message;
}

/// Returns the product that the data determine best: "τ G^0.45, ± 3 %".
QString combinationText(const Fit& fit) {
  constexpr double kNothing = 0.05;
  const Combination& best = fit.combinations.front();
  QStringList factors;
  for (std::size_t k = 0; k < best.exponents.size(); ++k) {
    const double exponent = best.exponents[k];
    if (std::abs(exponent) < kNothing) continue;
    QString factor = shortName(fit.parameters[k]);
    if (std::abs(exponent - 1) >= kNothing)
      factor += "<sup>" + readingLabel(exponent, 2) + "</sup>";
    factors += factor;
  }
  return FitPage::tr("best determined together: %1 (± %2 %)")
      .arg(factors.join(QStringLiteral(" · ")), readingLabel(100 * best.standardError, 2));
}

/// Returns the correlation of each pair of parameters: "correlation: r(τ, h) = −0.34".
QString correlationsText(const Fit& fit) {
  QStringList pairs;
  for (std::size_t k = 0; k < fit.parameters.size(); ++k)
    for (std::size_t j = k + 1; j < fit.parameters.size(); ++j) {
      const double value =
          fit.correlation(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(j));
      const QString text = std::isfinite(value)
                               ? inLanguage(QString::fromStdString(printedDecimals(value, 2)))
                               : QStringLiteral("–");
      pairs += QStringLiteral("r(%1, %2) = %3")
                   .arg(shortName(fit.parameters[k]), shortName(fit.parameters[j]), text);
    }
  return FitPage::tr("correlation: %1").arg(pairs.join(QStringLiteral("; ")));
}

}  // namespace

QString fittedTable(const Fit& fit, const QColor& warning) {
  const auto cell = [](const QString& text, const char* align) {
    return QStringLiteral("<td align=%1 style='padding-right:8px'>%2</td>").arg(align, text);
  };
  QString rows = "<tr>" + cell(FitPage::tr("parameter"), "left") +
                 cell("<b>" + FitPage::tr("best value") + "</b>", "right") +
                 cell(FitPage::tr("± standard error"), "right") + cell(QString(), "left") + "</tr>";
  for (const FittedParameter& parameter : fit.parameters) {
    const Parameter& row = *findParameter(parameter.key);
    rows +=
        "<tr>" + cell(labelWithSymbol(row), "left") +
        cell("<b>" + quantityLabel(parameter.value, row.unit).toHtmlEscaped() + "</b>", "right") +
        cell(rangeText(parameter), "right") + cell(stateText(parameter, fit, warning), "left") +
        "</tr>";
  }
  return "<table cellspacing=0 cellpadding=1>" + rows + "</table>";
}

QString fittedNotes(const Fit& fit) {
  QStringList lines;
  if (fit.relativeScatter > 0)
    lines += FitPage::tr("the points have no errors; they scatter by %1 % about the fit")
                 .arg(readingLabel(100 * fit.relativeScatter, 2));
  else
    lines += FitPage::tr("χ² = %1 for %2, %3 evaluations")
                 .arg(readingLabel(fit.chiSquared, 4))
                 .arg(translatedText(degreesOfFreedom(fit.degreesOfFreedom)))
                 .arg(fit.evaluations);
  if (fit.parameters.size() > 1) lines += correlationsText(fit);
  const bool isOpen = !std::ranges::all_of(fit.parameters, &FittedParameter::isDetermined);
  const bool areFactors = std::ranges::all_of(fit.parameters, &FittedParameter::isLogarithmic);
  if (isOpen && areFactors && fit.parameters.size() > 1) lines += combinationText(fit);
  for (const Message& note : fit.notes)
    lines += translatedText(withParameterNames(note)).toHtmlEscaped();
  return lines.join(QStringLiteral("<br>"));
}

QStringList fitWarnings(const Fit& fit) {
  QStringList warnings;
  for (const Message& warning : fit.warnings)
    warnings += translatedText(withParameterNames(warning));
  return warnings;
}

DiagramSheet progressSheet(std::span<const double> chiSquared) {
  Diagram diagram;
  diagram.x = {"evaluation", "", AxisScale::Linear, 0,
               std::max(10.0, static_cast<double>(chiSquared.size()) + 1)};
  // Profiles evaluate beside the minimum, so the values themselves would end high.
  diagram.y = {"least χ² so far", "", AxisScale::Logarithmic};
  DiagramSeries series;
  series.mark = SeriesMark::Circle;
  series.colour = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < chiSquared.size(); ++i) {
    least = std::min(least, chiSquared[i]);
    series.points.push_back({static_cast<double>(i + 1), least});
  }
  diagram.series = {std::move(series)};
  DiagramSheet sheet;
  sheet.diagrams = {std::move(diagram)};
  return sheet;
}

// ---- As files

namespace {

// The size, theme and scale that the command has by default.
constexpr int kWidth = 1200, kHeight = 900;

/// The options of the command for a file of this name.
nlohmann::ordered_json optionsOf(const FittedCurve& fitted, const std::string& name,
                                 const nlohmann::ordered_json& language = {}) {
  nlohmann::ordered_json options = fitOptions(fitted.varied, fitted.hasProfiles);
  if (!language.is_null()) options["language"] = language;
  options["file"] = name;
  return options;
}

/// The provenance of a picture, as the command writes it.
std::string originOf(const FittedCurve& fitted, const std::string& name) {
  nlohmann::ordered_json picture = {
      {"size", std::to_string(kWidth) + "x" + std::to_string(kHeight)},
      {"scale", 1.0F},
      {"theme", "print"},
      {"transparent", false}};
  addLanguage(picture);
  const ProvenanceOptions options(
      optionsOf(fitted, name, picture.value("language", nlohmann::ordered_json())));
  nlohmann::ordered_json origin = fitProvenance(fitted.start, fitted.fit);
  origin["picture"] = std::move(picture);
  return provenanceLine(origin);
}

}  // namespace

QStringList writeFitReport(const std::string& folder, const FittedCurve& fitted) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder))
    throw InputError(folder, "", "is not a folder and cannot be created");
  const FitReport report = [&] {
    const ProvenanceOptions options(optionsOf(fitted, "fit"));
    return fitReport(fitted, folder);
  }();

  // All names are checked before the first file is written.
  const std::filesystem::path within(folder);
  std::vector<std::string> names;
  for (const NamedSheet& sheet : report.sheets)
    for (const char* extension : {".png", ".svg", ".pdf"}) names.push_back(sheet.name + extension);
  for (const auto& [name, bytes] : report.texts) names.push_back(name);
  const std::vector<std::filesystem::path> inputs = filesReadBy(fitted.fit.scene);
  for (const std::string& name : names) {
    checkWritable(within / name);
    checkReplacesNone(within / name, inputs);
  }
  DiagramOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.theme = printTheme();
  for (const NamedSheet& sheet : report.sheets) {
    const DrawList picture = composeDiagrams(sheet.sheet, options);
    const std::string origin = originOf(fitted, sheet.name);
    for (const char* extension : {".png", ".svg", ".pdf"})
      writePicture(within / (sheet.name + extension), picture,
                   {translated(sheet.sheet.title), origin, 1});
  }
  // The first text, which describes the others, is written last.
  for (auto text = report.texts.rbegin(); text != report.texts.rend(); ++text)
    writeFileAtomically(within / text->first, text->second);
  QStringList written;
  for (const std::string& name : names) written += QString::fromStdString(name);
  return written;
}

}  // namespace asperity
