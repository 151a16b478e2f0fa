#include "ui/language/explained.h"

#include <QRegularExpression>

#include "ui/language/translated.h"

namespace asperity {

QString formulaHtml(std::string_view formula) {
  QString text =
      QString::fromUtf8(formula.data(), static_cast<qsizetype>(formula.size())).toHtmlEscaped();
  static const QRegularExpression low(QStringLiteral("_(\\p{L}[\\p{L}\\d]*|∞)"));
  static const QRegularExpression raised(QStringLiteral("\\^(?:\\(([^()]*)\\)|(\\p{L}|\\d))"));
  text.replace(low, QStringLiteral("<sub>\\1</sub>"));
  return text.replace(raised, QStringLiteral("<sup>\\1\\2</sup>"));
}

QString formulaText(std::string_view formula) {
  QString text = QString::fromUtf8(formula.data(), static_cast<qsizetype>(formula.size()));
  static const QRegularExpression low(QStringLiteral("_(\\p{L}[\\p{L}\\d]*|∞)"));
  text.replace(QStringLiteral("_N"), QStringLiteral("ₙ"));
  return text.replace(low, QStringLiteral("(\\1)"));
}

QString explanationHtml(const Explanation& explanation, const QString& title,
                        const QString& sentence) {
  QString text;
  if (!title.isEmpty()) text += "<p><b>" + title.toHtmlEscaped() + "</b></p>";
  if (!explanation.formula.empty()) text += "<p>" + formulaHtml(explanation.formula) + "</p>";
  const QString said =
      sentence.isEmpty() ? translatedText(Message(explanation.sentence)) : sentence;
  return text + "<p>" + said.toHtmlEscaped() + "</p>";
}

}  // namespace asperity
