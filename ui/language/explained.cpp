#include "ui/language/explained.h"

#include <QMap>
#include <QRegularExpression>
#include <algorithm>
#include <utility>

#include "ui/language/language.h"
#include "ui/language/translated.h"

namespace asperity {

namespace {

/// Returns a formula that breaks into lines at signs outside of its brackets, or before a plus.
QString withoutBreaksInBrackets(QString formula) {
  int depth = 0;
  for (qsizetype i = 0; i < formula.size(); ++i) {
    const QChar sign = formula[i];
    if (QStringLiteral("([{").contains(sign)) ++depth;
    if (QStringLiteral(")]}").contains(sign)) --depth;
    const bool isBeforePlus = i + 1 < formula.size() && formula[i + 1] == u'+';
    if (sign == u' ' && depth > 0 && !isBeforePlus) formula[i] = QChar::Nbsp;
  }
  return formula;
}

/// Returns a formula with its words and the number of its equation in the present language:
/// "in Kontakt", "Gl. (2)".
QString formulaInLanguage(std::string_view formula) {
  QString text = fromUtf8(formula);
  text.replace(QLatin1String("in contact"), QString::fromStdString(Words::tr("in contact")));
  static const QRegularExpression equation(QStringLiteral("Eq\\. \\((\\d+)\\)"));
  text.replace(equation, QString::fromStdString(Words::tr("Eq. (%1)")).arg(QStringLiteral("\\1")));
  return withoutBreaksInBrackets(std::move(text));
}

}  // namespace

QString formulaHtml(std::string_view formula) {
  QString text = formulaInLanguage(formula).toHtmlEscaped();
  static const QRegularExpression low(QStringLiteral("_(\\p{L}[\\p{L}\\d]*|∞)"));
  static const QRegularExpression raised(QStringLiteral("\\^(?:\\(([^()]*)\\)|(\\p{L}|\\d))"));
  text.replace(low, QStringLiteral("<sub>\\1</sub>"));
  return text.replace(raised, QStringLiteral("<sup>\\1\\2</sup>"));
}

QString formulaText(std::string_view formula) {
  static const QMap<QChar, QChar> low{
      {u'a', u'ₐ'}, {u'e', u'ₑ'}, {u'h', u'ₕ'}, {u'i', u'ᵢ'}, {u'k', u'ₖ'}, {u'l', u'ₗ'},
      {u'm', u'ₘ'}, {u'N', u'ₙ'}, {u'n', u'ₙ'}, {u'o', u'ₒ'}, {u'p', u'ₚ'}, {u'r', u'ᵣ'},
      {u's', u'ₛ'}, {u't', u'ₜ'}, {u'u', u'ᵤ'}, {u'v', u'ᵥ'}, {u'x', u'ₓ'}};
  static const QRegularExpression index(QStringLiteral("_(\\p{L}[\\p{L}\\d]*|∞)"));
  QString text = formulaInLanguage(formula);
  for (qsizetype at = 0;;) {
    const QRegularExpressionMatch found = index.match(text, at);
    if (!found.hasMatch()) return text;
    QString letters = found.captured(1);
    at = found.capturedEnd();
    if (!std::ranges::all_of(letters, [](QChar letter) { return low.contains(letter); })) continue;
    for (QChar& letter : letters) letter = low[letter];
    text.replace(found.capturedStart(), found.capturedLength(), letters);
    at = found.capturedStart() + letters.size();
  }
}

QString richText(const QString& text) {
  QString rich = text.toHtmlEscaped();
  return rich.replace(QStringLiteral("\u2099"), QLatin1String("<sub>N</sub>"));
}

QString explanationHtml(const HoverExplanation& explanation, const QString& title,
                        const QString& sentence) {
  QString text;
  if (!title.isEmpty()) text += "<p><b>" + richText(title) + "</b></p>";
  const QString body =
      sentence.isEmpty() ? translatedText(Message(explanation.sentence)) : sentence;
  text += "<p>" + richText(body) + "</p>";
  if (!explanation.formula.empty()) text += "<p>" + formulaHtml(explanation.formula) + "</p>";
  return text;
}

QString wrappedTip(const QString& text) {
  return text.isEmpty() ? QString() : "<p>" + richText(text) + "</p>";
}

}  // namespace asperity
