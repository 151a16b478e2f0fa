#include "ui/window/lesson/lesson_text.h"

#include <QDateTime>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>
#include <cmath>

#include "ui/draw/ticks.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"

namespace asperity {

namespace {

/// Returns a text with no-break characters where a line break would hinder reading.
QString inReadableLines(const QString& given) {
  QString text = keptTogether(given);
  // The parts of "mm/s" and "1/v" stay together.
  static const QRegularExpression quotient(QStringLiteral(R"((?<=\w)/(?=\w\b))"),
                                           QRegularExpression::UseUnicodePropertiesOption);
  text.replace(quotient, QStringLiteral("/\u2060"));
  // So do the two sides of "H = 0.7" and "T − T₀".
  for (const char16_t sign : {u'=', u'−', u'+'})
    text.replace(QString(u' ') + sign + ' ', QString(QChar::Nbsp) + sign + QChar::Nbsp);
  // So does a number with what it counts: "3-mal".
  static const QRegularExpression times(QStringLiteral(R"((\d)-(?=\w))"));
  return text.replace(times, QStringLiteral("\\1\u2011"));
}

QString inlineHtml(const QString& text) {
  static const QRegularExpression strong(QStringLiteral(R"(\*\*(\S(?:.*?\S)?)\*\*)"),
                                         QRegularExpression::DotMatchesEverythingOption);
  static const QRegularExpression emphasis(QStringLiteral(R"(\*(\S(?:.*?\S)?)\*)"),
                                           QRegularExpression::DotMatchesEverythingOption);
  QString html = inReadableLines(text.toHtmlEscaped());
  html.replace(strong, QStringLiteral("<b>\\1</b>"));
  html.replace(emphasis, QStringLiteral("<i>\\1</i>"));
  return html;
}

QString shortFactor(double value) {
  return fromUtf8(numberInWords({roundedToDigits(value, 3), {}}));
}

QString perCent(double part) {
  return shortFactor(100 * part) + "\u00A0%";
}

/// Returns how far a right answer may be from the computed one, in words; empty for a choice.
QString toleranceInWords(const LessonPrediction& prediction) {
  const auto factor = [](double tolerance) {
    return fromUtf8(Words::tr("a factor of %1")).arg(shortFactor(1 + tolerance));
  };
  QString within;
  if (prediction.kind == PredictionKind::Number)
    within = QStringLiteral("±") + perCent(prediction.tolerance);
  else if (prediction.kind == PredictionKind::Point && prediction.x)
    within = factor(prediction.tolerance);
  else if (prediction.kind == PredictionKind::Point)
    within = fromUtf8(Words::tr("%1, its place within %2"))
                 .arg(factor(prediction.tolerance), factor(prediction.xTolerance));
  if (within.isEmpty()) return {};
  return " (" + fromUtf8(Words::tr("right within %1")).arg(within) + ")";
}

/// Returns a number, or the height and the place of a point whose place is asked for.
QString valueInWords(const LessonPrediction& prediction, const LessonNumber& number,
                     const LessonNumber& place) {
  const bool hasPlace = prediction.kind == PredictionKind::Point && !prediction.x;
  return hasPlace ? pointInWords(number, place) : fromUtf8(numberInWords(number));
}

/// Returns which part of a wrong point is wrong.
QString mistakeText(const LessonPrediction& prediction, const LessonAnswer& answer,
                    const GivenAnswer& given) {
  return fromUtf8(isHeightRight(prediction, answer, given)
                      ? Words::tr("The height is right, the place is not.")
                  : isPlaceRight(prediction, answer, given)
                      ? Words::tr("The place is right, the height is not.")
                      : Words::tr("Neither the place nor the height is right."));
}

QString paragraph(const QString& text) {
  return text.isEmpty() ? QString() : "<p>" + text.toHtmlEscaped() + "</p>";
}

}  // namespace

const std::string& shown(const LessonText& text) {
  return text.in(presentLanguage());
}

QString plainText(const LessonText& text) {
  return QString::fromStdString(shown(text));
}

QString lineText(const LessonText& text) {
  return inReadableLines(plainText(text));
}

QString fileNamePart(const LessonText& title) {
  constexpr int kLongest = 60;  // letters
  static const QRegularExpression forbidden(QStringLiteral(R"([/\\:*?"<>|\x00-\x1f])"));
  return plainText(title).remove(forbidden).simplified().left(kLongest);
}

QString dateText(const std::string& date) {
  const QString text = QString::fromStdString(date);
  const QDateTime time = QDateTime::fromString(text, Qt::ISODate);
  if (!time.isValid()) return text;
  return QLocale(fromUtf8(presentLanguage())).toString(time, QLocale::ShortFormat);
}

QString lessonHtml(const std::string& text) {
  QString html;
  const QStringList paragraphs = QString::fromStdString(text).split(QStringLiteral("\n\n"));
  for (const QString& paragraph : paragraphs) {
    const QStringList lines = paragraph.split('\n');
    QStringList words;
    bool isInList = false;
    const auto endText = [&] {
      if (!words.isEmpty())
        html += "<p>" + inlineHtml(words.join('\n')).replace('\n', "<br>") + "</p>";
      words.clear();
    };
    for (const QString& line : lines) {
      const bool isItem = line.startsWith(QStringLiteral("- "));
      if (isItem) endText();
      if (isItem != isInList) html += isItem ? QStringLiteral("<ul>") : QStringLiteral("</ul>");
      isInList = isItem;
      if (isItem)
        html += "<li>" + inlineHtml(line.mid(2)) + "</li>";
      else if (!line.isEmpty())
        words += line;
    }
    if (isInList) html += QStringLiteral("</ul>");
    endText();
  }
  return html;
}

std::string numberInWords(const LessonNumber& number) {
  if (!number.unit.empty()) return quantity(number.value, number.unit, 3);
  // A ratio near 1 shows its difference from 1: "1.002", not "1". A number of four digits is shown
  // as it was typed: "2,559".
  const bool hasFourDigits = std::abs(number.value - 1) < 0.02 || std::abs(number.value) >= 1000;
  return shortNumber(number.value, hasFourDigits ? 4 : 3);
}

QString pointInWords(const LessonNumber& height, const LessonNumber& place) {
  return fromUtf8(numberInWords(height)) + ' ' +
         fromUtf8(Words::tr("at %1")).arg(fromUtf8(numberInWords(place)));
}

QString answerInWords(const LessonPrediction& prediction, const LessonAnswer& answer) {
  if (answer.choice >= 0)
    return plainText(prediction.choices[static_cast<std::size_t>(answer.choice)].text);
  return valueInWords(prediction, answer.number, answer.x) + toleranceInWords(prediction);
}

QString toleranceText(const LessonPrediction& prediction) {
  if (prediction.kind == PredictionKind::Choice) return {};
  if (prediction.kind == PredictionKind::Number) {
    // Per cent mislead where they are many: an answer within 100 % may be 0.
    constexpr double kManyPerCent = 0.5;
    if (prediction.tolerance < kManyPerCent)
      return fromUtf8(Words::tr("An answer within %1 of the right one counts."))
          .arg(perCent(prediction.tolerance));
    return fromUtf8(Words::tr("An answer from %1 to %2 times the right one counts."))
        .arg(shortFactor(1 - prediction.tolerance), shortFactor(1 + prediction.tolerance));
  }
  const QString height = shortFactor(1 + prediction.tolerance);
  if (prediction.x)
    return fromUtf8(Words::tr("A height within a factor of %1 counts as right.")).arg(height);
  return fromUtf8(Words::tr("A height within a factor of %1 and a place within a factor of %2 "
                            "count as right."))
      .arg(height, shortFactor(1 + prediction.xTolerance));
}

QString lessonHtml(const LessonText& text, const LessonPrediction& prediction,
                   const LessonAnswer& answer, const GivenAnswer& given) {
  return lessonHtml(
      withValues(shown(text), prediction, answer, given, presentLanguage(), numberInWords));
}

QString verdictText(const LessonPrediction& prediction, const LessonAnswer& answer,
                    const GivenAnswer& given, bool isRight) {
  const bool isChoice = prediction.kind == PredictionKind::Choice;
  const QString found = isChoice && !prediction.answer
                            ? QString()
                            : fromUtf8(Words::tr("The program finds %1."))
                                  .arg(valueInWords(prediction, answer.number, answer.x));
  const auto contains = [](const LessonText& text, const char* place) {
    return shown(text).find(place) != std::string::npos;
  };
  if (!given.isGiven()) {
    const bool hasAnswerAlone =
        contains(prediction.wrong, "{") && !contains(prediction.wrong, "{given");
    return hasAnswerAlone ? lessonHtml(prediction.wrong, prediction, answer, given)
                          : paragraph(found);
  }
  const LessonText& comment = isRight ? prediction.right : prediction.wrong;
  const bool isPoint = prediction.kind == PredictionKind::Point && !prediction.x;
  QString verdict = "<p><b>" +
                    (isRight ? QStringLiteral("✓ ") + fromUtf8(Words::tr("Right"))
                             : QStringLiteral("✗ ") + fromUtf8(Words::tr("No"))) +
                    "</b></p>";
  QStringList sentences;
  if (isPoint || (!isChoice && !contains(comment, "{given")))
    sentences += fromUtf8(Words::tr("You said %1."))
                     .arg(valueInWords(prediction, {given.number, answer.number.unit},
                                       {given.x, answer.x.unit}));
  if (isPoint && !isRight) sentences += mistakeText(prediction, answer, given);
  // A text to a choice may have in words what was computed.
  if (isChoice ? comment.empty() : !contains(comment, "{answer")) sentences += found;
  return verdict + paragraph(sentences.join(' ')) + lessonHtml(comment, prediction, answer, given);
}

}  // namespace asperity
