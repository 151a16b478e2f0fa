#include "ui/panels/unit_text.h"

#include <QRegularExpression>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>

#include "ui/panels/number_text.h"

namespace asperity {

namespace {

struct Prefix {
  QStringView letter;
  int exponent;
};

// Both letters that look like mu: the micro sign and the Greek one.
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

/// The letter to print, for a multiple of three from -12 to 9.
QString prefixOf(int exponent) {
  static const QString letters = QStringLiteral("pn\u00b5m kMG");
  return exponent == 0 ? QString() : QString(letters[exponent / 3 + 4]);
}

/// 1.25 and 2 make "125"; digits as they are, so that nothing is rounded.
QString shifted(const QString& mantissa, int places) {
  const bool isNegative = mantissa.startsWith('-');
  QString digits = mantissa.mid(isNegative ? 1 : 0);
  digits.remove('.');
  const qsizetype before = places + 1;  // the point
  if (before <= 0)
    digits.prepend(QStringLiteral("0.") + QString(-before, '0'));
  else if (digits.size() <= before)
    digits.append(QString(before - digits.size(), '0'));
  else
    digits.insert(before, '.');
  return isNegative ? '-' + digits : digits;
}

constexpr int kMostPlaces = 5;  // written out, before or behind the point

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
  // The exponents are added as text, so that "20 mm" is the number that reads 0.02.
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

}  // namespace asperity
