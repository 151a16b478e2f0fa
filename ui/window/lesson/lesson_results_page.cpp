#include "ui/window/lesson/lesson_results_page.h"

#include <QDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTextBrowser>
#include <QVBoxLayout>
#include <cmath>
#include <exception>
#include <filesystem>
#include <map>

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/lesson/lesson_file.h"
#include "core/scene/sweep.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/panels/labels.h"
#include "ui/window/lesson/lesson_text.h"
#include "ui/window/main/file_dialogs.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/window_layout.h"

namespace asperity {

namespace {

/// Returns the shipped lesson to which results belong, with whole questions.
std::optional<Lesson> findShippedLesson(const LessonResults& results) {
  std::optional<Lesson> lesson = shippedLesson(results);
  if (lesson) lesson = withWholeQuestions(*std::move(lesson));
  return lesson;
}

/// Returns the step if it asks for a prediction; null where not, or where the lesson is not known.
const LessonStep* predictionStep(const std::optional<Lesson>& lesson, int step) {
  return lesson ? askingStep(*lesson, step) : nullptr;
}

QString verdict(const LessonResult& result) {
  if (!result.given.isGiven()) return fromUtf8(Words::tr("shown"));
  return result.isRight ? fromUtf8(Words::tr("right")) : fromUtf8(Words::tr("wrong"));
}

/// Returns the right answer in the form of a given one.
GivenAnswer rightAnswer(const LessonResult& result) {
  const LessonAnswer& expected = result.expected;
  return {expected.choice, expected.number.value, expected.x.value};
}

/// Returns an answer in words: a number, or the choice with its text. Where the step is not known
/// (null), a choice has its number.
QString answerText(const LessonResult& result, const LessonStep* asked, const GivenAnswer& answer) {
  if (!answer.isGiven()) return QStringLiteral("–");
  if (result.kind == PredictionKind::Choice) {
    const auto place = static_cast<std::size_t>(answer.choice);
    if (asked && place < asked->prediction->choices.size())
      return plainText(asked->prediction->choices[place].text);
    return fromUtf8(Words::tr("choice %1")).arg(answer.choice + 1);
  }
  const LessonNumber height{answer.number, result.expected.number.unit};
  if (result.kind == PredictionKind::Number || std::isnan(answer.x))
    return fromUtf8(numberInWords(height));
  // Older files have no unit of the place.
  std::string unit = result.expected.x.unit;
  if (unit.empty() && asked) unit = sweptParameter(asked->scene).unit;
  return pointInWords(height, {answer.x, unit});
}

/// Returns an answer as a column of a class has it: a choice has its number.
QString shortAnswer(const LessonResult& result, const LessonStep* asked,
                    const GivenAnswer& answer) {
  return answerText(result, result.kind == PredictionKind::Choice ? nullptr : asked, answer);
}

/// Returns a row of a table; its cells are HTML.
QString rowHtml(const QStringList& cells, const QString& cell = QStringLiteral("td"),
                const QString& style = {}) {
  const QString begin = "<" + cell + " align=\"left\" style=\"" + style + "\">";
  const QString end = "</" + cell + ">";
  return "<tr>" + begin + cells.join(end + begin) + end + "</tr>";
}

QString tableHtml(const QString& rows) {
  return "<table cellpadding=\"5\" cellspacing=\"0\" border=\"1\" "
         "style=\"border-collapse: collapse; border-color: gray\">" +
         rows + "</table>";
}

/// The answers of a student stay in one line each; other texts of the page break.
const QString kOneLine = QStringLiteral("white-space: nowrap");

/// Returns the table of the students in one lesson.
QString classTable(const std::vector<StudentResults>& students) {
  const ClassRows rows = LessonResultsPage::classRows(students);
  const auto html = [](QStringList cells, const QString& cell, const QString& style = {}) {
    for (QString& each : cells) each = each.toHtmlEscaped();
    return rowHtml(cells, cell, kOneLine + style);
  };
  QString all = html(rows.heading, "th") + html(rows.answers, "td", "; font-weight: bold");
  for (const QStringList& cells : rows.students) all += html(cells, "td");
  return tableHtml(all);
}

}  // namespace

std::optional<Lesson> shippedLesson(const LessonResults& results) {
  for (const ShippedFile& shipped : shippedLessons()) {
    if (shipped.name != results.lesson) continue;
    Lesson lesson = readNamedLesson(results.lesson, readNamedScene);
    if (lesson.digest == results.digest) return lesson;
  }
  return std::nullopt;
}

QString LessonResultsPage::lessonTitle(const LessonResults& results) {
  const std::optional<Lesson> lesson = findShippedLesson(results);
  return lesson ? plainText(lesson->title) : QString::fromStdString(results.title);
}

ClassRows LessonResultsPage::classRows(const std::vector<StudentResults>& students) {
  const std::optional<Lesson> lesson = findShippedLesson(students.front().results);
  std::map<int, const LessonResult*> steps;  // a result of each step, for the right answer
  for (const StudentResults& student : students)
    for (const LessonResult& one : student.results.results) steps.emplace(one.step, &one);
  ClassRows rows{{fromUtf8(Words::tr("File")), fromUtf8(Words::tr("right")),
                  fromUtf8(Words::tr("wrong")), fromUtf8(Words::tr("shown"))},
                 {fromUtf8(Words::tr("Right answer")), {}, {}, {}},
                 {}};
  for (const auto& [step, one] : steps) {
    rows.heading += fromUtf8(Words::tr("Step")) + ' ' + QString::number(step + 1);
    rows.answers += shortAnswer(*one, predictionStep(lesson, step), rightAnswer(*one));
  }
  for (const StudentResults& student : students) {
    const LessonResults& results = student.results;
    QStringList cells = {QString::fromStdString(student.file), QString::number(results.right()),
                         QString::number(results.wrong()), QString::number(results.shown())};
    for (const auto& [step, any] : steps) {
      const LessonResult* one = results.find(step);
      QString cell = one ? verdict(*one) : QStringLiteral("–");
      if (one && one->given.isGiven())
        cell += " (" + shortAnswer(*one, predictionStep(lesson, step), one->given) + ')';
      cells += cell;
    }
    rows.students.push_back(cells);
  }
  return rows;
}

QString LessonResultsPage::html(const QString& file) {
  const LessonResults results = readResultsFile(file.toStdString());
  const std::optional<Lesson> lesson = findShippedLesson(results);
  QString html = "<h3>" + lessonTitle(results).toHtmlEscaped() + "</h3><p>" +
                 QFileInfo(file).fileName().toHtmlEscaped();
  if (!results.date.empty()) html += ", " + dateText(results.date).toHtmlEscaped();
  html += "</p><p><b>" +
          tr("%1 right, %2 wrong, %3 shown")
              .arg(results.right())
              .arg(results.wrong())
              .arg(results.shown()) +
          "</b></p>";
  QString rows = rowHtml(
      {fromUtf8(Words::tr("Step")), tr("Answer"), QString(), fromUtf8(Words::tr("Right answer"))},
      "th");
  for (const LessonResult& one : results.results) {
    const LessonStep* asked = predictionStep(lesson, one.step);
    QString name = QString::number(one.step + 1);
    if (asked) name += ". " + plainText(asked->prediction->question).toHtmlEscaped();
    rows += rowHtml({name, answerText(one, asked, one.given).toHtmlEscaped(),
                     "<b>" + verdict(one) + "</b>",
                     answerText(one, asked, rightAnswer(one)).toHtmlEscaped()});
  }
  return html + tableHtml(rows);
}

QString LessonResultsPage::classHtml(const ClassResults& results) {
  QString html;
  for (const std::vector<StudentResults>& students : results.classes)
    html += "<h3>" + lessonTitle(students.front().results).toHtmlEscaped() + "</h3>" +
            classTable(students);
  if (!results.refused.empty()) html += "<h3>" + tr("Files without results") + "</h3>";
  for (const InputError& error : results.refused) {
    const QString name = QFileInfo(QString::fromStdString(error.file())).fileName();
    const QString reason = translatedError(InputError("", error.key(), error.message()));
    html += "<p>" + (name + ": " + reason).toHtmlEscaped() + "</p>";
  }
  return html;
}

namespace {

/// A page in a dialog, in which what does not fit is scrolled to.
class ResultsDialog : public QDialog {
 public:
  ResultsDialog(QWidget& window, const QString& name, const QString& title, const QString& html)
      : QDialog(&window),
        page_(named<QTextBrowser>(name + "Table")),
        status_(textLabel(name + "Status")),
        foot_(new QHBoxLayout) {
    setObjectName(name);
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(title);
    page_->setAccessibleName(title);
    page_->setHtml(html);
    status_->hide();
    auto* column = new QVBoxLayout(this);
    column->addWidget(page_, 1);
    column->addWidget(status_);
    column->addLayout(foot_);
    foot_->addStretch(1);
    connect(&addButton(name + "Close", LessonResultsPage::tr("&Close")), &QPushButton::clicked,
            this, &QDialog::reject);
    constexpr QSize kSize(960, 460);  // pixels; the table of a class with six answers fits
    resizePage(*this, kSize);
  }

  /// Adds a button to the left of the others.
  QPushButton& addButton(const QString& name, const QString& text) {
    auto* button = named<QPushButton>(name);
    button->setText(text);
    foot_->insertWidget(1, button);
    orderTabs(*page_, *foot_);  // the first button is that of the Enter key
    return *button;
  }

  /// Shows a line below the page.
  void showStatus(const QString& text, MessageKind kind) {
    setMessage(*status_, text, kind);
    status_->show();
  }

 private:
  QTextBrowser* page_;
  QLabel* status_;
  QHBoxLayout* foot_;
};

/// Asks for a file and saves the table of the class in it.
void saveTable(ResultsDialog& page, const ClassResults& results) {
  try {
    const std::string table = classCsv(onlyClass(results));
    const QString file =
        askSaveFile(&page, LessonResultsPage::tr("Save the table of a class"),
                    LessonResultsPage::tr("class.csv"), LessonResultsPage::tr("Table (*.csv)"));
    if (file.isEmpty()) return;
    const std::filesystem::path path = file.toStdString();
    if (path.extension() != ".csv")
      throw unknownExtension(path.string(), path.extension().string(), {".csv"});
    writeFileAtomically(path, table);
    page.showStatus(savedText(file), MessageKind::Note);
  } catch (const std::exception& error) {
    page.showStatus(translatedError(error), MessageKind::Error);
  }
}

}  // namespace

void showLessonResults(QWidget& window, const QString& file,
                       const std::function<void(const Lesson&, const LessonResults&)>& goOn) {
  const LessonResults results = readResultsFile(file.toStdString());
  auto* page =
      new ResultsDialog(window, "lessonResults", LessonResultsPage::tr("Results of a lesson"),
                        LessonResultsPage::html(file));
  if (const std::optional<Lesson> lesson = shippedLesson(results); goOn && lesson)
    QObject::connect(
        &page->addButton("resultsGoOn", LessonResultsPage::tr("&Go on with these answers")),
        &QPushButton::clicked, &window, [page, goOn, lesson = *lesson, results] {
          page->reject();
          goOn(lesson, results);
        });
  page->open();
}

void showClassResults(QWidget& window, const QStringList& files) {
  std::vector<std::string> paths;
  for (const QString& file : files) paths.push_back(file.toStdString());
  const ClassResults results = readClasses(paths);
  auto* page =
      new ResultsDialog(window, "classResults", LessonResultsPage::tr("Results of a class"),
                        LessonResultsPage::classHtml(results));
  QObject::connect(&page->addButton("saveClassTable", LessonResultsPage::tr("&Save table…")),
                   &QPushButton::clicked, page, [page, results] { saveTable(*page, results); });
  page->open();
}

}  // namespace asperity
