#include "ui/panels/number_text.h"

#include <QRegularExpression>
#include <algorithm>
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

double roundedToDigits(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return value;
  char text[32];
  // The conversion uses decimal text, so that the result is exactly the number "0.0034", not a
  // neighbour.
  const auto end = std::to_chars(std::begin(text), std::end(text), value,
                                 std::chars_format::scientific, digits - 1);
  double rounded = value;
  std::from_chars(text, end.ptr, rounded);
  return rounded;
}

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

QString valueText(const ParameterValue& value) {
  if (const auto* real = std::get_if<double>(&value)) return shownNumber(*real);
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return QString::number(*integer);
  return QString::fromStdString(std::get<std::string>(value));
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

QString wordText(std::string_view word) {
  if (presentLanguage() == "en")
    for (const auto& [key, name] : {std::pair("kelvin", "Kelvin"), std::pair("prony", "Prony"),
                                    std::pair("standard_solid", "standard solid")})
      if (word == key) return QString::fromLatin1(name);
  return translatedText(fromUtf8(word).replace('_', '-').toStdString());
}

namespace {

struct Prefix {
  QStringView letter;
  int exponent;
};

// There are two letters for mu: the micro sign and the Greek one.
const Prefix kPrefixes[] = {{u"", 0},        {u"f", -15},     {u"p", -12}, {u"n", -9}, {u"u", -6},
                            {u"\u00b5", -6}, {u"\u03bc", -6}, {u"m", -3},  {u"c", -2}, {u"k", 3},
                            {u"M", 6},       {u"G", 9},       {u"T", 12},  {u"P", 15}};

std::optional<int> exponentOf(const QString& given, const QString& unit) {
  for (const Prefix& prefix : kPrefixes)
    if (given == prefix.letter.toString() + unit) return prefix.exponent;
  return std::nullopt;
}

int largestExponent(const QString& unit) {
  return unit == QLatin1String("m") || unit == QLatin1String("s") || unit == QLatin1String("m/s")
             ? 0
             : 9;
}

/// Returns the letter to print, for a multiple of three from -12 to 9.
QString prefixOf(int exponent) {
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

constexpr int kMostPlaces = 5;  // zeros written out, before or after the point

}  // namespace

QString withPoint(const QString& text) {
  static const QRegularExpression form(QStringLiteral(R"(^\s*[+-]?\d*,\d*(?:[eE\s\p{L}].*)?$)"));
  const qsizetype comma = text.indexOf(',');
  const bool isNumber = form.match(text).hasMatch() && text.indexOf(',', comma + 1) < 0;
  return isNumber ? QString(text).replace(comma, 1, '.') : text;
}

QString inPlainUnit(const QString& text, const QString& unit) {
  static const QRegularExpression form(
      QStringLiteral(R"(^\s*([+-]?(?:\d+\.?\d*|\.\d+))(?:[eE]([+-]?\d+))?\s*([^\d\s.].*?)\s*$)"));
  const QRegularExpressionMatch match = form.match(text);
  if (unit.isEmpty() || !match.hasMatch()) return text;
  const QString number = match.captured(1);
  const int exponent = match.captured(2).toInt();
  const QString given = match.captured(3).replace(QChar(0x00b7), QChar(' '));
  const std::optional<int> shift = exponentOf(given, unit);
  if (!shift) return text;
  // The exponents are added as text, so that "20 mm" is exactly the number 0.02.
  return numberText((number + "e" + QString::number(exponent + *shift)).toDouble());
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
  const QString number = std::abs(places) <= kMostPlaces ? shifted(mantissa, places)
                                                         : mantissa + 'e' + QString::number(places);
  return {number, prefixOf(prefix) + unit};
}

QString inShownUnit(const QString& text, const QString& shownUnit) {
  static const QRegularExpression alone(QStringLiteral(R"(^\s*[+-]?(\d+\.?\d*|\.\d+)\s*$)"));
  return !shownUnit.isEmpty() && alone.match(text).hasMatch() ? text.trimmed() + ' ' + shownUnit
                                                              : text;
}

namespace {

/// A dimension as text, with one of its units and an example from daily life.
struct Dimension {
  const char* unit;
  QString words;
  const char* example = "";  // only for dimensions of parameters
};

QList<Dimension> dimensions() {
  return {{"m", ParameterRow::tr("a length"), "20 mm"},
          {"Pa", ParameterRow::tr("a modulus or pressure"), "10 MPa"},
          {"N", ParameterRow::tr("a force"), "3.4 mN"},
          {"m/s", ParameterRow::tr("a velocity"), "1 m/s"},
          {"s", ParameterRow::tr("a time"), "1 ms"},
          {"K", ParameterRow::tr("a temperature"), "300 K"},
          {"Hz", ParameterRow::tr("a frequency"), "10 Hz"},
          {"N/m", ParameterRow::tr("a force on a length"), "100 N/m"},
          {"Pa s", ParameterRow::tr("a viscosity"), "10 kPa s"},
          {"g", ParameterRow::tr("a mass")},
          {"t", ParameterRow::tr("a mass")},
          {"J", ParameterRow::tr("an energy")},
          {"W", ParameterRow::tr("a power")},
          {"V", ParameterRow::tr("a voltage")},
          {"rad", ParameterRow::tr("an angle")},
          {"°", ParameterRow::tr("an angle")},
          {"m²", ParameterRow::tr("an area")},
          {"1/m", ParameterRow::tr("a wave number")}};
}

/// A unit that is not the plain one with a prefix.
struct OtherUnit {
  const char *name, *unit;
  double size, offset = 0;  // plain = (number + offset) size
};

constexpr OtherUnit kOtherUnits[] = {
    {"°C", "K", 1, 273.15}, {"°F", "K", 5.0 / 9, 459.67},
    {"bar", "Pa", 1e5},     {"N/m²", "Pa", 1},
    {"N/mm²", "Pa", 1e6},   {"min", "s", 60},
    {"h", "s", 3600},       {"km/h", "m/s", 1 / 3.6},
    {"P", "Pa s", 0.1},     {"1/s", "Hz", 1},
    {"%", "", 0.01},
};

struct Quantity {
  double number = 0;
  QString unit;  // as it was typed, with or without a prefix
};

std::optional<Quantity> quantityOf(const QString& text) {
  static const QRegularExpression form(
      QStringLiteral(R"(^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(\S(?:.*\S)?)?\s*$)"));
  const QRegularExpressionMatch match = form.match(text);
  if (!match.hasMatch()) return {};
  return Quantity{match.captured(1).toDouble(), match.captured(2)};
}

const OtherUnit* otherUnit(const QString& name) {
  for (const OtherUnit& other : kOtherUnits)
    if (name == QString::fromUtf8(other.name)) return &other;
  return nullptr;
}

bool isUnitOf(const QString& given, const QString& unit) {
  return inPlainUnit("1 " + given, unit) != "1 " + given;
}

std::optional<Dimension> dimensionOf(const QString& given) {
  const OtherUnit* other = otherUnit(given);
  for (const Dimension& dimension : dimensions()) {
    const QString unit = QString::fromUtf8(dimension.unit);
    if (other ? unit == QString::fromUtf8(other->unit) : isUnitOf(given, unit)) return dimension;
  }
  return {};
}

/// Returns the dimension and an example of the values that the rule accepts.
std::pair<QString, QString> wantedBy(const NumberRule& rule) {
  const auto known = rule.unit.isEmpty() ? std::nullopt : dimensionOf(rule.unit);
  if (!known) return {ParameterRow::tr("a pure number"), inLanguage(QStringLiteral("0.5"))};
  const bool isDifference = rule.unit == QLatin1String("K") && !rule.isTemperature;
  return {isDifference ? ParameterRow::tr("a difference of temperatures") : known->words,
          inLanguage(QString::fromUtf8(known->example))};
}

/// Returns whether a unit is accepted: degrees Celsius are no unit of a difference, per cent none
/// of an integer.
bool isTaken(const OtherUnit& other, const NumberRule& rule) {
  return QString::fromUtf8(other.unit) == rule.unit && (other.offset == 0 || rule.isTemperature) &&
         !rule.isWhole;
}

QString endInWords(double value, const NumberRule& rule) {
  if (rule.isWhole) return QString::number(static_cast<qint64>(value));
  return inLanguage(QString::fromStdString(printedQuantity(value, rule.unit.toStdString())));
}

QString otherUnitRefused(const QString& text, const QString& given, const NumberRule& rule) {
  const auto [wanted, example] = wantedBy(rule);
  if (const auto dimension = dimensionOf(given))
    return ParameterRow::tr("%1 is %2; wanted is %3, such as %4")
        .arg(text, dimension->words, wanted, example);
  return ParameterRow::tr("“%1” is no unit known here; wanted is %2, such as %3")
      .arg(given, wanted, example);
}

}  // namespace

NumberRule ruleOf(const Parameter& parameter) {
  const AllowedRange range = allowedRange(parameter).value_or(AllowedRange{});
  return {fromUtf8(parameter.unit), range.minimum, range.maximum,
          std::holds_alternative<IntegerField>(parameter.field),
          parameter.unit == "K" && parameter.key.ends_with("temperature")};
}

QString allowedInWords(const NumberRule& rule) {
  QString from = endInWords(rule.minimum, rule);
  const QString to = endInWords(rule.maximum, rule);
  const auto unitOf = [](const QString& text) { return text.section(' ', 1); };
  if (rule.minimum == 0 || unitOf(from) == unitOf(to)) from = from.section(' ', 0, 0);
  return ParameterRow::tr("%1 to %2").arg(from, to);
}

QString plainNumberOf(const QString& text, const NumberRule& rule) {
  const auto quantity = quantityOf(text);
  const OtherUnit* other = quantity ? otherUnit(quantity->unit) : nullptr;
  if (other && isTaken(*other, rule))
    return numberText(roundedToDigits((quantity->number + other->offset) * other->size, 15));
  return inPlainUnit(text, rule.unit);
}

QString refusalOf(const QString& text, const NumberRule& rule) {
  const QString typed = text.trimmed();
  bool isNumber = false;
  const double value = plainNumberOf(typed, rule).toDouble(&isNumber);
  const QString allowed = allowedInWords(rule);
  if (!isNumber) {
    const auto quantity = quantityOf(typed);
    const bool hasUnit = quantity && !quantity->unit.isEmpty();
    if (hasUnit && (!rule.unit.isEmpty() || dimensionOf(quantity->unit)))
      return otherUnitRefused(inLanguage(typed), quantity->unit, rule);
    return ParameterRow::tr("“%1” is not a number; allowed is %2").arg(typed.left(60), allowed);
  }
  if (rule.isWhole && value != std::floor(value))
    return ParameterRow::tr("%1 is not a whole number; allowed is %2")
        .arg(inLanguage(typed), allowed);
  if (value < rule.minimum || value > rule.maximum)
    return ParameterRow::tr("%1 is outside %2").arg(inLanguage(typed), allowed);
  return {};
}

}  // namespace asperity
