#include "ui/panels/unit_text.h"

#include <QRegularExpression>
#include <optional>

#include "ui/panels/number_text.h"

namespace asperity {

namespace {

struct Prefix {
  QStringView letter;
  int exponent;
};

// Both letters that look like mu: the micro sign and the Greek one.
const Prefix kPrefixes[] = {{u"", 0},        {u"p", -12},     {u"n", -9}, {u"u", -6},
                            {u"\u00b5", -6}, {u"\u03bc", -6}, {u"m", -3}, {u"c", -2},
                            {u"k", 3},       {u"M", 6},       {u"G", 9}};

std::optional<int> exponentOf(const QString& given, const QString& unit) {
  for (const Prefix& prefix : kPrefixes)
    if (given == prefix.letter.toString() + unit) return prefix.exponent;
  return std::nullopt;
}

}  // namespace

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

}  // namespace asperity
