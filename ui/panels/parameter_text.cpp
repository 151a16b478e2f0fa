#include "ui/panels/parameter_text.h"

#include <QLocale>
#include <QRegularExpression>
#include <algorithm>

#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/parameter_row.h"

namespace asperity {

namespace {

/// Returns the range of the slider in the notation of the entries, or the words of a choice. The
/// allowed range is in the message that refuses a value.
QString rangeText(const Parameter& parameter) {
  if (allowedRange(parameter)) {
    NumberRule rule = numberRule(parameter);
    std::visit(
        [&rule](const auto& field) {
          if constexpr (requires { field.sliderFrom; }) {
            rule.minimum = static_cast<double>(field.sliderFrom);
            rule.maximum = static_cast<double>(field.sliderTo);
          }
        },
        parameter.field);
    return ParameterRow::tr("slider: %1").arg(allowedInWords(rule));
  }
  QStringList words;
  if (const auto* choice = std::get_if<ChoiceField>(&parameter.field))
    for (const std::string_view word : choice->choices) words += wordText(word, parameter.key);
  if (words.isEmpty()) return {};
  return ParameterRow::tr("values: %1").arg(words.join(QStringLiteral(", ")));
}

/// Returns whether some word of the text begins with these letters.
bool beginsWordIn(const QString& letters, const QString& text) {
  static const QRegularExpression between(QStringLiteral(R"([\s._(-]+)"));
  const QStringList parts = text.split(between);
  return std::ranges::any_of(
      parts, [&](const QString& part) { return part.startsWith(letters, Qt::CaseInsensitive); });
}

/// Returns whether a word is found in a name: a long one anywhere, a short one at the beginning of
/// a word, because one or two letters are found nearly everywhere.
bool isWordIn(const QString& word, const QString& text) {
  return word.size() > 2 ? text.contains(word, Qt::CaseInsensitive) : beginsWordIn(word, text);
}

/// Returns whether a word is a unit in which the parameter may be typed: "mN", "°C".
bool isUnit(const QString& word, const Parameter& parameter) {
  return !parameter.unit.empty() && findUnit(word.toStdString(), parameter.unit).has_value();
}

QString smallParagraph(const QString& text) {
  return QStringLiteral("<p><small>%1</small></p>").arg(text);
}

/// Returns the last line of a tooltip: the key, for people who write scene files, and its range.
QString keyLine(const Parameter& parameter) {
  const QString range = rangeText(parameter);
  if (range.isEmpty()) return {};
  return smallParagraph(ParameterRow::tr("key in scene files: %1; %2")
                            .arg(fromUtf8(parameter.key), range.toHtmlEscaped()));
}

}  // namespace

QString labelText(const Parameter& parameter) {
  return translatedText(parameter.label);
}

QString labelWithSymbol(const Parameter& parameter) {
  QString label = labelText(parameter);
  if (parameter.symbol.empty()) return label;
  const QString plain = fromUtf8(parameter.symbol).remove('_');
  if (label.endsWith(' ' + plain)) label.chop(plain.size() + 1);
  // A line break never separates the symbol from its name.
  return label + "&nbsp;&nbsp;" + symbolHtml(parameter.symbol);
}

QString withLabels(const QString& text) {
  static const QRegularExpression key(
      QStringLiteral(R"(([a-z_]+(?:\.[a-z0-9_]+)+)(?:=(-?\d(?:[\d.,]*\d)?(?:e[-+]?\d+)?))?)"));
  const QLocale locale(fromUtf8(presentLanguage()));
  QString labelled;
  qsizetype end = 0;
  for (auto it = key.globalMatch(text); it.hasNext();) {
    const QRegularExpressionMatch match = it.next();
    const Parameter* parameter = findParameter(match.captured(1).toStdString());
    labelled += text.mid(end, match.capturedStart() - end);
    labelled += parameter ? inQuotes(labelText(*parameter)) : match.captured();
    if (parameter && match.hasCaptured(2)) {
      bool isNumber = false;
      const double value = locale.toDouble(match.captured(2), &isNumber);
      labelled += " = " + (isNumber ? textWithUnit(*parameter, value) : match.captured(2));
    }
    end = match.capturedEnd();
  }
  return labelled + text.mid(end);
}

QString errorWithLabel(const InputError& error) {
  if (!error.file().empty()) return translatedError(error);
  const QString text = withLabels(translatedText(error.message()));
  const Parameter* parameter = findParameter(error.key());
  if (parameter) return labelText(*parameter) + ": " + text;
  return error.key().starts_with("--") ? text : translatedError(error);
}

bool isFound(const Parameter& parameter, const QStringList& words, bool inSentence) {
  const QString text =
      labelText(parameter) + ' ' + fromUtf8(parameter.label) + ' ' + fromUtf8(parameter.key);
  const QString sentence =
      inSentence ? translatedText(parameter.sentence) + ' ' + fromUtf8(parameter.sentence)
                 : QString();
  const QString symbol = withoutTags(symbolHtml(parameter.symbol));
  return std::ranges::all_of(words, [&](const QString& word) {
    return isWordIn(word, text) || beginsWordIn(word, sentence) ||
           (!symbol.isEmpty() && word == symbol) || word == fromUtf8(parameter.symbol) ||
           isUnit(word, parameter);
  });
}

UnitText shownText(const Parameter& parameter, const ParameterValue& value) {
  if (const auto* real = std::get_if<double>(&value)) {
    const UnitText text = inReadableUnit(*real, fromUtf8(parameter.unit));
    return {inLanguage(text.number), text.unit};
  }
  // Texts of shipped scenes are shown in the language of the window.
  if (const auto* text = std::get_if<std::string>(&value))
    if (std::holds_alternative<TextField>(parameter.field) && isTranslatedScene(*text))
      return {sceneText(*text), {}};
  return {valueText(value), fromUtf8(parameter.unit)};
}

QString textWithUnit(const Parameter& parameter, const ParameterValue& value) {
  const UnitText text = shownText(parameter, value);
  return (text.number + ' ' + text.unit).trimmed();
}

QString resetText(const Parameter& parameter, const ParameterValue& initial) {
  if (std::holds_alternative<ArmsField>(parameter.field))
    return ParameterRow::tr("Back to the default, one arm");
  const QString value = textWithUnit(parameter, initial);
  return value.isEmpty() ? ParameterRow::tr("Back to the default, which is empty")
                         : ParameterRow::tr("Back to the default, %1").arg(value);
}

QString explanationText(const Parameter& parameter, Rheology rheology) {
  const auto explanation = findExplanation(parameter.key);
  return explanation ? explanationHtml(withFormulaFor(*explanation, rheology)) : QString();
}

QString parameterTip(const Parameter& parameter, Rheology rheology) {
  return explanationText(parameter, rheology) + keyLine(parameter);
}

QString controlTip(const Parameter& parameter, Rheology rheology, SliderUse slider) {
  QString text = explanationText(parameter, rheology);
  if (std::holds_alternative<RealField>(parameter.field) && !parameter.unit.empty())
    text += smallParagraph(ParameterRow::tr(
        "A number alone counts in the unit beside it; any unit may be typed with it."));
  if (slider != SliderUse::None) {
    QString keys = ParameterRow::tr(
        "Arrow keys make steps, with Shift the smallest ones; PageUp and PageDown large ones.");
    if (slider == SliderUse::Visible)
      keys += ' ' + ParameterRow::tr("Dragging with Shift is ten times finer.");
    text += smallParagraph(keys);
  }
  return text + keyLine(parameter);
}

}  // namespace asperity
