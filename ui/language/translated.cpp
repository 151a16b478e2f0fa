#include "ui/language/translated.h"

#include <QRegularExpression>
#include <QStringList>
#include <cmath>

#include "core/base/printed_number.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

using Found = std::optional<QString>;

/// "0.7", "\u22121.5e-3", "2.3\u00D710\u207B\u2075", with the unit that follows: "10 MPa"; or what
/// somebody wrote, in quotes.
const QRegularExpression& quantity() {
  static const QRegularExpression form(
      QStringLiteral("(?:(?<![\\w.])|(?<= x)|(?<=\u00D7))[-\u2212]?"
                     "(?:10[\u207B\u2070\u00B9\u00B2\u00B3\u2074-\u2079]+"
                     "|\\d+(?:\\.\\d+)?(?:e[-+]?\\d+)?"
                     "(?:\u00D710[\u207B\u2070\u00B9\u00B2\u00B3\u2074-\u2079]+)?)"
                     "(?: [fpn\u00B5mkMGTP]?(?:m/s|N/m|Pa s|Pa|Hz|N|m|s|K)(?![\\w/^]))?"
                     "|(?<!\\w)'[^']*'(?!\\w)"),
      QRegularExpression::UseUnicodePropertiesOption);
  return form;
}

/// The same, and what nobody translates: keys of a scene and texts of JSON.
const QRegularExpression& quantityOrName() {
  static const QRegularExpression form(
      quantity().pattern() +
          QStringLiteral("|(?<![\\w.])[a-z_]+(?:\\.[a-z0-9_]+)+(?![\\w.])|\"[^\"]*\""
                         "|[a-z_]+(?=; it belongs to )|(?<=; it belongs to )[a-z_ ]+$"),
      QRegularExpression::UseUnicodePropertiesOption);
  return form;
}

constexpr double kLeastPlain = 1e-3, kMostPlain = 1e5;  // beyond them powers of ten

/// Numbers as computers write them, "1e-10" and "6.3e+02", as all others are printed.
QString withPrintedNumbers(const QString& text) {
  static const QRegularExpression form(
      QStringLiteral("(?<![\\w.,])(-?\\d+)(?:[.,](\\d+))?e([-+]?\\d+)(?!\\w)"));
  QString printed;
  qsizetype end = 0;
  for (auto it = form.globalMatch(text); it.hasNext();) {
    const QRegularExpressionMatch match = it.next();
    const QString front = match.captured(1), behind = match.captured(2);
    const double value = (front + '.' + behind + 'e' + match.captured(3)).toDouble();
    if (!std::isfinite(value)) continue;
    const auto digits = static_cast<int>(front.size() + behind.size()) - front.startsWith('-');
    const double size = std::abs(value);
    const bool isPlain = value == 0 || (size >= kLeastPlain && size < kMostPlain);
    printed += text.mid(end, match.capturedStart() - end) +
               inLanguage(QString::fromStdString(isPlain ? printedNumber(value, digits)
                                                         : printedPower(value, digits)));
    end = match.capturedEnd();
  }
  return printed + text.mid(end);
}

constexpr const char* kScenes = "scenes";  // context of what shipped scenes say of themselves

Found known(const QString& english) {
  const QByteArray text = english.toUtf8();
  const Found found = translationIn("core", text.constData());
  return found ? found : translationIn(kScenes, text.constData());
}

/// What the form finds becomes %1, %2, ..., and goes back in the language's way.
Found knownWithout(const QRegularExpression& form, const QString& english) {
  QString pattern;
  QStringList values;
  qsizetype end = 0;
  for (auto it = form.globalMatch(english); it.hasNext();) {
    const QRegularExpressionMatch match = it.next();
    const bool isNumber =
        quantity().match(match.captured()).capturedLength() == match.capturedLength();
    values += isNumber ? inLanguage(match.captured()) : match.captured();
    pattern += english.mid(end, match.capturedStart() - end) + '%' + QString::number(values.size());
    end = match.capturedEnd();
  }
  if (values.isEmpty()) return {};
  Found found = known(pattern + english.mid(end));
  // From the last one down: %1 is also the beginning of %10.
  if (found)
    for (qsizetype i = values.size(); i > 0; --i)
      found->replace('%' + QString::number(i), values[i - 1]);
  return found;
}

Found knownWithoutNumbers(const QString& english) {
  return knownWithout(quantity(), english);
}

Found knownWithoutNames(const QString& english) {
  return knownWithout(quantityOrName(), english);
}

/// "H = 0.7", "10 mN", "III": the same in every language but for the decimal sign.
Found formula(const QString& text) {
  static const QRegularExpression name(QStringLiteral("^(?:[^\\s=]{1,4} [=\u2264\u2265] )?"),
                                       QRegularExpression::UseUnicodePropertiesOption);
  static const QRegularExpression other(QStringLiteral("^[IVX]+$|^[^a-zA-Z]*$"));
  const QString value = text.mid(name.match(text).capturedLength());
  const QRegularExpressionMatch match = quantity().match(value);
  const bool isQuantity = match.hasMatch() && match.capturedLength() == value.size();
  if (!isQuantity && !other.match(value).hasMatch()) return {};
  return inLanguage(text);
}

/// "seed 3", "local shear = 2 N/m": a label of the table and its value.
Found labelled(const QString& english) {
  QRegularExpressionMatch value;
  for (auto it = quantity().globalMatch(english); it.hasNext();) value = it.next();
  if (!value.hasMatch() || value.capturedEnd() != english.size()) return {};
  const QString label = english.left(value.capturedStart());
  const QString sign =
      label.endsWith(QStringLiteral(" = ")) ? QStringLiteral(" = ") : QStringLiteral(" ");
  if (!label.endsWith(sign)) return {};
  const Found found = known(label.chopped(sign.size()));
  return found ? std::optional(*found + sign + inLanguage(value.captured())) : found;
}

Found whole(const QString& english) {
  for (const auto way : {known, knownWithoutNumbers, knownWithoutNames, formula, labelled})
    if (const Found found = way(english)) return found;
  return {};
}

/// Every part must be known.
Found joined(const QStringList& parts, const QString& separator, Found (*each)(const QString&)) {
  QStringList done;
  for (const QString& part : parts) {
    const Found found = each(part);
    if (!found) return {};
    done += *found;
  }
  return done.join(separator);
}

/// "zone 1: ..." in its two halves.
Found named(const QString& english) {
  if (const Found found = whole(english)) return found;
  const qsizetype colon = english.indexOf(QStringLiteral(": "));
  if (colon < 0) return {};
  return joined({english.left(colon), english.mid(colon + 2)}, QStringLiteral(": "), whole);
}

/// A comma may stand in a number, so lists of values are set apart by semicolons.
Found list(const QString& english) {
  if (const Found found = named(english)) return found;
  for (const char* separator : {"; ", ", "})
    if (english.contains(QLatin1String(separator)))
      return joined(english.split(QLatin1String(separator)), QStringLiteral("; "),
                    separator[0] == ';' ? list : named);
  return {};
}

/// With its full stop, where it has one.
Found sentence(const QString& english) {
  if (const Found found = list(english)) return found;
  if (!english.endsWith('.')) return {};
  const Found found = list(english.chopped(1));
  return found ? std::optional(*found + '.') : found;
}

Found all(const QString& english) {
  if (const Found found = whole(english)) return found;
  static const QRegularExpression between(
      QStringLiteral("(?<=\\.) (?=[A-Z\u221A\u03B1-\u03C9]|beta|sqrt)"));
  if (const Found found = joined(english.split(between), QStringLiteral(" "), sentence))
    return found;
  return {};
}

void translate(std::string& text) {
  text = translated(text);
}

void translate(Diagram& diagram) {
  translate(diagram.title);
  for (DiagramAxis* axis : {&diagram.x, &diagram.y}) translate(axis->title);
  for (DiagramSeries& series : diagram.series) translate(series.name);
  for (DiagramSpan& span : diagram.spans) {
    translate(span.label);
    for (std::string& note : span.notes) translate(note);
  }
  for (DiagramSpan& shade : diagram.shades) translate(shade.label);
  for (DiagramLabel& label : diagram.labels) translate(label.text);
  if (diagram.marker)
    for (std::string* text : {&diagram.marker->name, &diagram.marker->label}) translate(*text);
  translate(diagram.blank);
  if (diagram.ramp)
    for (std::string* text : {&diagram.ramp->title, &diagram.ramp->from, &diagram.ramp->to})
      translate(*text);
}

}  // namespace

std::optional<std::string> translationOf(std::string_view english) {
  if (english.empty()) return std::string();
  const Found found =
      all(QString::fromUtf8(english.data(), static_cast<qsizetype>(english.size())));
  return found ? std::optional(found->toStdString()) : std::nullopt;
}

namespace {

std::string inPresentLanguage(std::string_view english) {
  if (presentLanguage() == "en") return std::string(english);
  if (const auto found = translationOf(english)) return *found;
  // A sheet says first what somebody called the scene, an error which file it is about.
  for (const char* separator : {"; ", ": "})
    for (std::size_t name = english.find(separator); name != english.npos;
         name = english.find(separator, name + 2))
      if (const auto rest = translationOf(english.substr(name + 2)))
        return std::string(english.substr(0, name + 2)) + *rest;
  return std::string(english);
}

}  // namespace

std::string translated(std::string_view english) {
  return translatedText(english).toStdString();
}

QString translatedText(std::string_view english) {
  return withPrintedNumbers(QString::fromStdString(inPresentLanguage(english)));
}

bool isTranslatedScene(std::string_view text) {
  return !text.empty() && translationIn(kScenes, std::string(text).c_str());
}

QString sceneText(std::string_view text) {
  const Found found = translationIn(kScenes, std::string(text).c_str());
  return withPrintedNumbers(found ? *found : QString::fromStdString(std::string(text)));
}

DiagramSheet translated(DiagramSheet sheet) {
  for (std::string* text : {&sheet.title, &sheet.subtitle, &sheet.note, &sheet.status})
    translate(*text);
  for (Diagram& diagram : sheet.diagrams) translate(diagram);
  return sheet;
}

}  // namespace asperity
