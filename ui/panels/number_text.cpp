#include "ui/panels/number_text.h"

#include <QRegularExpression>
#include <QTextDocumentFragment>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "core/base/number_text.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/parameter_row.h"

namespace asperity {

QString numberText(double value) {
  char buffer[32];
  const auto end = std::to_chars(std::begin(buffer), std::end(buffer), value);
  std::string text(buffer, end.ptr);
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return QString::fromStdString(text);
  const int exponent = std::stoi(text.substr(e + 1));
  return QString::fromStdString(text.substr(0, e + 1)) + QString::number(exponent);
}

QString shownNumber(double value) {
  return inLanguage(numberText(value));
}

QString quantityLabel(double value, std::string_view unit, int digits) {
  return QString::fromStdString(readingInLanguage(printedQuantity(value, unit, digits)));
}

QString valueText(const ParameterValue& value) {
  if (const auto* real = std::get_if<double>(&value)) return shownNumber(*real);
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return QString::number(*integer);
  return QString::fromStdString(std::get<std::string>(value));
}

QString withoutTags(QString html) {
  static const QRegularExpression tag(QStringLiteral("<[^>]*>"));
  return html.remove(tag);
}

QString spokenText(const QString& html) {
  return QTextDocumentFragment::fromHtml(html).toPlainText();
}

QString symbolHtml(std::string_view symbol) {
  QString text = fromUtf8(symbol);
  for (const auto& [name, letter] : {std::pair("tau", u'τ'), std::pair("eta", u'η'),
                                     std::pair("kappa", u'κ'), std::pair("lambda", u'λ')})
    if (text.section('_', 0, 0) == QLatin1String(name))
      text.replace(0, text.section('_', 0, 0).size(), QChar(letter));
  text.replace(QStringLiteral("_inf"), QStringLiteral("_∞"));
  const qsizetype low = text.indexOf('_');
  if (low < 0) return QStringLiteral("<i>%1</i>").arg(text.toHtmlEscaped());
  return QStringLiteral("<i>%1</i><sub>%2</sub>")
      .arg(text.left(low).toHtmlEscaped(), text.mid(low + 1).toHtmlEscaped());
}

QString inQuotes(const QString& text) {
  return (presentLanguage() == "de" ? QStringLiteral("„%1“") : QStringLiteral("“%1”")).arg(text);
}

namespace {

/// The names of a choice for users, where the words of the scene file are too short.
struct ChoiceName {
  std::string_view key;
  std::string_view word;
  const char* name;
};

constexpr std::array<ChoiceName, 35> kChoiceNames{{
    {"surface.format", "text", "text table"},
    {"surface.format", "profile", "text: profile"},
    {"surface.format", "matrix", "text: matrix of heights"},
    {"surface.format", "points", "text: points x y z"},
    {"surface.format", "x3p", "X3P"},
    {"surface.format", "sdf", "SDF"},
    {"surface.format", "smd", "SMD, PRF"},
    {"surface.format", "sur", "SUR"},
    {"surface.format", "gsf", "GSF"},
    {"surface.format", "gwy", "GWY"},
    {"surface.format", "npy", "NumPy"},
    {"surface.format", "zygo", "Zygo"},
    {"surface.format", "wyko", "Wyko, text"},
    {"surface.format", "surfer", "Surfer grid"},
    {"surface.format", "gwyddion", "read by Gwyddion"},
    {"surface.position_unit", "auto", "from the file"},
    {"surface.position_unit", "in", "inch"},
    {"surface.height_unit", "auto", "from the file"},
    {"surface.height_unit", "in", "inch"},
    {"surface.direction", "along_x", "along the rows (x)"},
    {"surface.direction", "along_y", "across the rows (y)"},
    {"surface.gaps", "refuse", "refuse the file"},
    {"surface.form", "line", "straight line"},
    {"surface.form", "none", "nothing"},
    {"surface.form", "mean", "mean height"},
    {"surface.seam", "mirror", "mirrored"},
    {"surface.seam", "blend", "blended"},
    {"surface.seam", "random_phases", "random phases"},
    {"surface.seam", "periodic", "as they are"},
    {"surface.line", "as_measured", "as measured"},
    {"surface.line", "isotropic_equivalent", "isotropic equivalent"},
    {"surface.spectrum_kind", "unstated", "not stated"},
    {"surface.spectrum_kind", "c1_two_sided", "of a line, two-sided"},
    {"surface.spectrum_kind", "c1_one_sided", "of a line, one-sided"},
    {"surface.spectrum_kind", "c2", "of a surface"},
}};

/// The English names of words that are written otherwise in files.
constexpr std::array<std::pair<std::string_view, const char*>, 7> kEnglishNames{
    {{"kelvin", "Kelvin"},
     {"prony", "Prony"},
     {"standard_solid", "standard solid"},
     {"wlf", "WLF"},
     {"arrhenius", "Arrhenius"},
     {"auto", "automatic"},
     {"um", "\u00b5m"}}};

}  // namespace

QString wordText(std::string_view word, std::string_view key) {
  for (const ChoiceName& each : kChoiceNames)
    if (each.word == word && each.key == key) return translatedText(Message(each.name));
  if (presentLanguage() == "en")
    for (const auto& [known, name] : kEnglishNames)
      if (word == known) return QString::fromUtf8(name);
  return translatedText(fromUtf8(word).replace('_', '-').toStdString());
}

namespace {

int largestExponent(const QString& unit) {
  return unit == QLatin1String("m") || unit == QLatin1String("s") || unit == QLatin1String("m/s")
             ? 0
             : 9;
}

/// Returns the prefix of a unit for a power of ten that is a multiple of three, from -12 to 9.
QString unitPrefix(int exponent) {
  static const QString letters = QStringLiteral("pn\u00b5m kMG");
  return exponent == 0 ? QString() : QString(letters[exponent / 3 + 4]);
}

/// Shifts the decimal point: 1.25 and 2 give "125"; the digits are unchanged, so nothing is
/// rounded.
QString shifted(const QString& mantissa, int places) {
  const bool isNegative = mantissa.startsWith('-');
  QString digits = mantissa.mid(isNegative ? 1 : 0);
  digits.remove('.');
  const qsizetype before = places + 1;  // position of the point
  if (before <= 0)
    digits.prepend(QStringLiteral("0.") + QString(-before, '0'));
  else if (digits.size() <= before)
    digits.append(QString(before - digits.size(), '0'));
  else
    digits.insert(before, '.');
  return isNegative ? '-' + digits : digits;
}

constexpr int kMaxDecimals = 5;  // zeros written out, before or after the point

}  // namespace

QString withPoint(const QString& text) {
  static const QRegularExpression form(QStringLiteral(R"(^\s*[+-]?\d*,\d*(?:[eE\s\p{L}].*)?$)"));
  const qsizetype comma = text.indexOf(',');
  const bool isNumber = form.match(text).hasMatch() && text.indexOf(',', comma + 1) < 0;
  return isNumber ? QString(text).replace(comma, 1, '.') : text;
}

QString withoutGroups(const QString& text) {
  // A number with an exponent has no groups, and no group begins with 0: "0.125" is a fraction.
  static const QString form(
      QStringLiteral(R"(^\s*[+\-\x{2212}]?[1-9]\d{0,2}(?:\%1\d{3})+(?![\d\%1]|[eE][+-]?\d))"));
  static const QRegularExpression commas(form.arg(',')), points(form.arg('.'));
  const bool hasDecimalComma = inLanguage(QStringLiteral(".")) == QStringLiteral(",");
  const QRegularExpressionMatch grouped = (hasDecimalComma ? points : commas).match(text);
  if (!grouped.hasMatch()) return withPoint(text);
  QString number = grouped.captured();
  number.remove(hasDecimalComma ? '.' : ',');
  return withPoint(number + text.mid(grouped.capturedEnd()));
}

UnitText inReadableUnit(double value, const QString& unit) {
  if (value == 0 || !std::isfinite(value) || unit.isEmpty() || unit == QLatin1String("K"))
    return {numberText(value), unit};
  char buffer[32];
  const auto end =
      std::to_chars(std::begin(buffer), std::end(buffer), value, std::chars_format::scientific);
  const QString text = QString::fromLatin1(buffer, end.ptr - buffer);
  const QString mantissa = text.section('e', 0, 0);
  const int exponent = text.section('e', 1).toInt();
  const int thousands = exponent >= 0 ? exponent / 3 : -((2 - exponent) / 3);
  const int prefix = std::clamp(3 * thousands, -12, largestExponent(unit));
  const int places = exponent - prefix;
  const QString number = std::abs(places) <= kMaxDecimals
                             ? shifted(mantissa, places)
                             : mantissa + 'e' + QString::number(places);
  return {number, unitPrefix(prefix) + unit};
}

QString inShownUnit(const QString& text, const QString& shownUnit) {
  static const QRegularExpression alone(
      QStringLiteral(R"(^\s*[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\s*$)"));
  return !shownUnit.isEmpty() && alone.match(text).hasMatch() ? text.trimmed() + ' ' + shownUnit
                                                              : text;
}

namespace {

QString endInWords(double value, const NumberRule& rule) {
  if (rule.isWhole) return QString::number(static_cast<qint64>(value));
  return inLanguage(QString::fromStdString(printedQuantity(value, rule.unit.toStdString())));
}

TypedQuantity readQuantity(const QString& text, const NumberRule& rule) {
  const std::string unit = rule.unit.toStdString();
  return typedQuantity(text.toStdString(), {unit, rule.isTemperature, rule.isWhole});
}

}  // namespace

NumberRule numberRule(const Parameter& parameter) {
  const AllowedRange range = allowedRange(parameter).value_or(AllowedRange{});
  const QuantityRule quantity = quantityRule(parameter);
  return {fromUtf8(quantity.unit), range.minimum, range.maximum, quantity.isWhole,
          quantity.isTemperature};
}

QString allowedInWords(const NumberRule& rule) {
  QString from = endInWords(rule.minimum, rule);
  const QString to = endInWords(rule.maximum, rule);
  const auto unit = [](const QString& text) { return text.section(' ', 1); };
  if (rule.minimum == 0 || unit(from) == unit(to)) from = from.section(' ', 0, 0);
  return ParameterRow::tr("%1 to %2").arg(from, to);
}

QString toPlainNumber(const QString& text, const NumberRule& rule) {
  bool isPlain = false;
  text.toDouble(&isPlain);
  const auto value = isPlain ? std::nullopt : readQuantity(text, rule).value;
  return value ? numberText(*value) : text;
}

QString validationError(const QString& text, const NumberRule& rule) {
  const QString typed = text.trimmed();
  const TypedQuantity quantity = readQuantity(typed, rule);
  const QString allowed = allowedInWords(rule);
  if (!quantity.refusal.empty()) return translatedText(quantity.refusal);
  if (!quantity.value)
    return ParameterRow::tr("“%1” is not a number; allowed is %2").arg(typed.left(60), allowed);
  if (rule.isWhole && *quantity.value != std::floor(*quantity.value))
    return ParameterRow::tr("%1 is not a whole number; allowed is %2")
        .arg(inLanguage(typed), allowed);
  if (*quantity.value < rule.minimum || *quantity.value > rule.maximum)
    return ParameterRow::tr("%1 is outside %2").arg(inLanguage(typed), allowed);
  return {};
}

}  // namespace asperity
