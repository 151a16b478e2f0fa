#include "ui/language/translated.h"

#include <QMap>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "ui/language/language.h"

namespace asperity {

namespace {

constexpr double kMinPlain = 1e-3, kMaxPlain = 1e5;  // outside of this range, powers of ten
constexpr const char* kScenes = "scenes";            // context of the texts in shipped scenes

/// Returns "1e-10" and "6.3e+02" in the style of all other numbers; formatted numbers are
/// unchanged.
std::string shownNumber(const std::string& text) {
  double value = 0;
  const std::size_t e = text.find('e');
  if (e == text.npos || !readNumber(text, value) || !std::isfinite(value)) return text;
  const auto digits = static_cast<int>(
      std::count_if(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(e),
                    [](unsigned char letter) { return std::isdigit(letter) != 0; }));
  const double size = std::abs(value);
  const bool isPlain = value == 0 || (size >= kMinPlain && size < kMaxPlain);
  return isPlain ? printedNumber(value, digits) : printedPower(value, digits);
}

std::optional<QString> found(const std::string& form) {
  const auto text = translationIn("core", form.c_str());
  return text ? text : translationIn(kScenes, form.c_str());
}

/// Returns whether a template has only symbols and placeholders, such as "%1 = %2", which is the
/// same in every language. Words have two adjacent small letters.
bool isFormula(std::string_view form) {
  const auto isSmall = [](char letter) { return letter >= 'a' && letter <= 'z'; };
  return std::ranges::adjacent_find(
             form, [&](char a, char b) { return isSmall(a) && isSmall(b); }) == form.end();
}

/// Whether numbers have groups of thousands, as in readings, or none, so that they can be typed.
enum class Thousands { Plain, Grouped };

/// Translates a message. `isWhole` becomes false where a translation is missing.
std::string translate(const Message& english, bool& isWhole,
                      Thousands thousands = Thousands::Plain) {
  if (english.kind == Message::Kind::Name) return english.text;
  if (english.kind == Message::Kind::Number) {
    const std::string number = shownNumber(english.text);
    return thousands == Thousands::Grouped ? readingInLanguage(number) : inLanguage(number);
  }
  std::string form = english.text;
  if (const auto text = found(form))
    form = text->toStdString();
  else if (!isFormula(form))
    isWhole = false;
  if (english.values.empty()) return form;
  std::vector<std::string> values;
  for (const Message& value : english.values)
    values.push_back(translate(value, isWhole, thousands));
  return filled(form, values);
}

}  // namespace

std::optional<std::string> findTranslation(const Message& english) {
  bool isWhole = true;
  std::string text = translate(english, isWhole);
  return isWhole ? std::optional(std::move(text)) : std::nullopt;
}

std::string translated(const Message& english) {
  bool isWhole = true;
  return translate(english, isWhole);
}

QString translatedText(const Message& english) {
  return QString::fromStdString(translated(english));
}

QString readingText(const Message& english) {
  bool isWhole = true;
  return QString::fromStdString(translate(english, isWhole, Thousands::Grouped));
}

QString capitalized(const QString& text) {
  return text.left(1).toUpper() + text.mid(1);
}

QString keptTogether(QString text) {
  static const QRegularExpression unit(
      QStringLiteral(R"((\d) ((?:[GMkcmµn]?(?:m|s|N|Pa|K|W|J|g)|°C|%)(?:/(?:s|m))?)(?![\w/]))"));
  static const QRegularExpression equation(QStringLiteral(R"(\b(Eq\.|Gl\.) \()"));
  text.replace(unit, QStringLiteral("\\1\u00A0\\2"));
  return text.replace(equation, QStringLiteral("\\1\u00A0("));
}

QString shortened(const QString& text, qsizetype letters) {
  if (text.size() <= letters) return text;
  const QString between = QStringLiteral(" .,;:–");
  qsizetype end = text.lastIndexOf(' ', letters - 1);
  while (end > 0 && between.contains(text[end - 1])) --end;
  if (end <= 0) end = letters - 1;
  return text.left(end) + QChar(0x2026);
}

QString translatedError(const std::exception& error) {
  return translatedText(errorMessage(error));
}

LiveText liveError(const std::exception& error) {
  return [message = errorMessage(error)] { return translatedText(message); };
}

bool isTranslatedScene(std::string_view text) {
  return !text.empty() && translationIn(kScenes, std::string(text).c_str());
}

QString sceneText(std::string_view text) {
  const auto found = translationIn(kScenes, std::string(text).c_str());
  return found ? *found : QString::fromStdString(std::string(text));
}

namespace {

void translateInPlace(Message& text) {
  text = Message::name(readingText(text).toStdString());
}

}  // namespace

DiagramMarker translated(DiagramMarker marker) {
  translateInPlace(marker.name);
  translateInPlace(marker.label);
  return marker;
}

DiagramSheet translated(DiagramSheet sheet) {
  for (Message* text : {&sheet.title, &sheet.subtitle, &sheet.note, &sheet.status})
    translateInPlace(*text);
  for (Diagram& diagram : sheet.diagrams) {
    for (Message* text : {&diagram.title, &diagram.x.title, &diagram.y.title, &diagram.blank})
      translateInPlace(*text);
    for (DiagramSeries& series : diagram.series) translateInPlace(series.name);
    for (DiagramSpan& span : diagram.spans) {
      translateInPlace(span.label);
      for (Message& note : span.notes) translateInPlace(note);
    }
    for (DiagramSpan& shade : diagram.shades) translateInPlace(shade.label);
    for (DiagramLabel& label : diagram.labels) translateInPlace(label.text);
    if (diagram.marker) diagram.marker = translated(*std::move(diagram.marker));
    for (DiagramBar& bar : diagram.bars) translateInPlace(bar.name);
    if (diagram.field) {
      translateInPlace(diagram.field->colours.title);
      for (DiagramContour& contour : diagram.field->contours) translateInPlace(contour.label);
    }
    if (diagram.ramp)
      for (Message* text : {&diagram.ramp->title, &diagram.ramp->from, &diagram.ramp->to})
        translateInPlace(*text);
  }
  return sheet;
}

// ---- Explanations

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

/// Returns plain text as rich text, in which the modulus "G∞" has a lowered sign.
QString withLoweredInfinity(const QString& text) {
  return text.toHtmlEscaped().replace(QStringLiteral("G∞"), QStringLiteral("G<sub>∞</sub>"));
}

/// Returns what finds a symbol in a formula: z in "z′" and "η v z′", but not in "∇z", C not in
/// "C₁", and G not in "G∞" or "G(t)".
QRegularExpression symbolPattern(const QString& symbol) {
  const bool isLatin = symbol.size() == 1 && symbol[0].unicode() < 128;
  const QString pattern = isLatin ? QStringLiteral("(?<![\\p{L}∇_])%1(?![\\p{L}\\p{N}_∞″]|\\(t)")
                                  : QStringLiteral("%1(?!_)");
  return QRegularExpression(pattern.arg(QRegularExpression::escape(symbol)));
}

/// Returns "η: viscosity; z: height of the line" for the symbols of a formula; empty without any.
QString symbolsHtml(std::string_view formula) {
  // Compiling the patterns takes far longer than searching a formula for them.
  static const auto patterns = [] {
    std::vector<QRegularExpression> all;
    for (const FormulaSymbol& one : formulaSymbols())
      all.push_back(symbolPattern(fromUtf8(one.symbol)));
    return all;
  }();
  const QString searched = fromUtf8(formula);
  QStringList texts;
  for (std::size_t i = 0; i < patterns.size(); ++i)
    if (const FormulaSymbol& one = formulaSymbols()[i]; searched.contains(patterns[i]))
      texts += formulaHtml(one.symbol) + ": " + richText(translatedText(Message(one.meaning)));
  return texts.join(QStringLiteral("; "));
}

}  // namespace

QString formulaHtml(std::string_view formula) {
  QString text = withLoweredInfinity(formulaInLanguage(formula));
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
  return withLoweredInfinity(text).replace(QStringLiteral("\u2099"), QLatin1String("<sub>N</sub>"));
}

QString plainTitle(QString title) {
  return title.remove(QStringLiteral(" F\u2099"));
}

QString explanationHtml(const HoverExplanation& explanation, const QString& title,
                        const QString& sentence) {
  QString text;
  if (!title.isEmpty()) text += "<p><b>" + richText(title) + "</b></p>";
  const QString body =
      sentence.isEmpty() ? translatedText(Message(explanation.sentence)) : sentence;
  text += "<p>" + richText(body) + "</p>";
  if (!explanation.formula.empty()) text += "<p>" + formulaHtml(explanation.formula) + "</p>";
  if (const QString symbols = symbolsHtml(explanation.formula); !symbols.isEmpty())
    text += "<p>" + symbols + "</p>";
  return text;
}

QString wrappedTip(const QString& text) {
  return text.isEmpty() ? QString() : "<p>" + richText(text) + "</p>";
}

}  // namespace asperity
