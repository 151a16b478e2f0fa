#include "ui/panels/typed_number.h"

#include <QRegularExpression>
#include <cmath>
#include <optional>

#include "core/base/printed_number.h"
#include "ui/language/language.h"
#include "ui/panels/number_text.h"
#include "ui/panels/parameter_row.h"
#include "ui/panels/unit_text.h"

namespace asperity {

namespace {

/// A dimension in words, by a unit of it and with a value that people know.
struct Dimension {
  const char* unit;
  QString words;
  const char* example = "";  // only of what a parameter can be
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

/// Units that no prefix makes of the plain one.
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
  QString unit;  // as it was typed, without prefix or with
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

/// The dimension and an example of what the rule takes.
std::pair<QString, QString> wantedBy(const NumberRule& rule) {
  const auto known = rule.unit.isEmpty() ? std::nullopt : dimensionOf(rule.unit);
  if (!known) return {ParameterRow::tr("a pure number"), inLanguage(QStringLiteral("0.5"))};
  const bool isDifference = rule.unit == QLatin1String("K") && !rule.isTemperature;
  return {isDifference ? ParameterRow::tr("a difference of temperatures") : known->words,
          inLanguage(QString::fromUtf8(known->example))};
}

/// Degrees are no unit of a difference, per cent none of a whole number.
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
