#include "ui/window/lesson/lesson_results_page.h"

#include <QAbstractButton>
#include <QFileInfo>
#include <QMessageBox>

#include <cmath>
#include <optional>

#include "core/lesson/lesson_class.h"
#include "core/lesson/lesson_file.h"
#include "core/scene/sweep.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/window/lesson/lesson_text.h"
#include "ui/window/main/scene_library.h"

namespace asperity {

namespace {

/// Returns the shipped lesson to which results belong; nothing for another lesson or version.
std::optional<Lesson> shippedLessonOf(const LessonResults& results) {
  for (const ShippedLesson& shipped : shippedLessons()) {
    if (shipped.name != results.lesson) continue;
    Lesson lesson = readNamedLesson(results.lesson, readNamedScene);
    if (lesson.digest == results.digest) return withWholeQuestions(std::move(lesson));
  }
  return std::nullopt;
}

QString verdict(const LessonResult& result) {
  if (!result.given.isGiven()) return LessonResultsPage::tr("shown");
  return result.isRight ? LessonResultsPage::tr("right") : LessonResultsPage::tr("wrong");
}

/// Returns an answer in words: a number, or the choice with its text. Where the lesson is not known
/// (null), a choice has its number and the place of a point no unit.
QString answerText(const LessonResult& result, const LessonStep* asked, int choice, double number,
                   double x) {
  if (result.kind == PredictionKind::Choice) {
    if (choice < 0) return QStringLiteral("–");
    const auto place = static_cast<std::size_t>(choice);
    if (asked && place < asked->prediction->choices.size())
      return plainText(asked->prediction->choices[place].text);
    return LessonResultsPage::tr("choice %1").arg(choice + 1);
  }
  if (std::isnan(number)) return QStringLiteral("–");
  const LessonNumber height{number, result.expected.number.unit};
  if (result.kind == PredictionKind::Number || std::isnan(x))
    return fromUtf8(numberInWords(height));
  return pointInWords(height, {x, asked ? std::string(sweptParameter(asked->scene).unit) : ""});
}

}  // namespace

QString LessonResultsPage::html(const QString& file) {
  const LessonResults results = readResultsFile(file.toStdString());
  const std::optional<Lesson> lesson = shippedLessonOf(results);
  const QString title = lesson ? plainText(lesson->title) : QString::fromStdString(results.title);
  QString html =
      "<h3>" + title.toHtmlEscaped() + "</h3><p>" + QFileInfo(file).fileName().toHtmlEscaped();
  if (!results.date.empty())
    html += ", " + QString::fromStdString(results.date).replace('T', ' ').toHtmlEscaped();
  html += "</p><p><b>" +
          tr("%1 right, %2 wrong, %3 shown")
              .arg(results.right())
              .arg(results.wrong())
              .arg(results.shown()) +
          "</b></p><table cellpadding=\"4\">";
  const QStringList heads = {tr("Step"), tr("Answer"), QString(), tr("Right answer")};
  html += "<tr><th align=\"left\">" + heads.join("</th><th align=\"left\">") + "</th></tr>";
  for (const LessonResult& one : results.results) {
    const auto step = static_cast<std::size_t>(one.step);
    const bool isAsked = lesson && step < lesson->steps.size() && lesson->steps[step].prediction;
    const LessonStep* asked = isAsked ? &lesson->steps[step] : nullptr;
    QString name = QString::number(one.step + 1);
    if (asked) name += ". " + plainText(asked->prediction->question).toHtmlEscaped();
    const QString given = answerText(one, asked, one.given.choice, one.given.number, one.given.x);
    const QString right = answerText(one, asked, one.expected.choice, one.expected.number.value,
                                     one.expected.x.value);
    html += "<tr><td>" + name + "</td><td>" + given.toHtmlEscaped() + "</td><td><b>" +
            verdict(one) + "</b></td><td>" + right.toHtmlEscaped() + "</td></tr>";
  }
  return html + "</table>";
}

void showLessonResults(QWidget& window, const QString& file) {
  auto* box = new QMessageBox(QMessageBox::NoIcon, LessonResultsPage::tr("Results of a lesson"),
                              LessonResultsPage::html(file), QMessageBox::Close, &window);
  box->setObjectName("lessonResults");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setTextFormat(Qt::RichText);
  box->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  box->button(QMessageBox::Close)->setText(LessonResultsPage::tr("&Close"));
  box->open();
}

}  // namespace asperity
