#include "ui/panels/number_text.h"

#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include "ui/language/language.h"
#include "ui/language/translated.h"

namespace asperity {

double roundedToDigits(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return value;
  char text[32];
  // Through decimal text, so that the result is the number that reads "0.0034", not a neighbour.
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

}  // namespace asperity
