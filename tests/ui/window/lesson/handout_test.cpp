// The pages of a handout on paper.
#include "ui/window/lesson/handout.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdio>

#include "tests/core/lesson/lesson_samples.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

using testing::HasSubstr;
using Json = nlohmann::ordered_json;

/// Returns what a program prints of the PDF. output: its word for standard output.
QString saidOfPdf(const std::string& program, const std::string& output, const Lesson& lesson,
                  const HandoutOptions& options) {
  TemporaryFolder folder;
  writeHandout(folder / "page.pdf", lesson, options);
  const std::string command =
      program + " '" + (folder / "page.pdf").string() + "' " + output + " 2>&1";
  std::FILE* const pipe = popen(command.c_str(), "r");
  QByteArray text;
  char block[4096];
  while (const std::size_t size = std::fread(block, 1, sizeof(block), pipe))
    text.append(block, static_cast<qsizetype>(size));
  EXPECT_EQ(pclose(pipe), 0) << text.toStdString();
  return QString::fromUtf8(text);
}

/// Returns the texts of the pages of a PDF.
QStringList pagesOf(const Lesson& lesson, const HandoutOptions& options = {}) {
  QStringList pages = saidOfPdf("pdftotext", "-", lesson, options).split('\f');
  pages.removeLast();  // each page ends with a form feed
  return pages;
}

/// Returns a lesson of many steps, of which each asks with choices and shows the same contact.
Lesson longLesson() {
  Json json = sampleLesson();
  Json step = json["steps"][0];
  for (const char* member : {"after", "reveal", "values"}) step.erase(member);
  step["prediction"]["wrong"] = "No.";
  step["prediction"]["right"] = "Yes.";
  step["prediction"]["choices"][0]["text"] = "one choice";
  step["prediction"]["choices"].back()["text"] = "last choice";
  json["steps"] = Json::array();
  for (int i = 0; i < 12; ++i) {
    step["prediction"]["question"] = "Question number " + std::to_string(i + 1) + "?";
    json["steps"].push_back(step);
  }
  return lessonOf(json);
}

TEST(HandoutPages, EachPageHasTheTitleAndItsNumber) {
  const QStringList pages = pagesOf(longLesson());
  ASSERT_GT(pages.size(), 2);
  for (qsizetype i = 0; i < pages.size(); ++i) {
    EXPECT_TRUE(pages[i].contains("Sample")) << pages[i].toStdString();
    // The program that reads the text may leave out narrow spaces.
    EXPECT_TRUE(QString(pages[i]).remove(' ').contains(
        QStringLiteral("%1/%2").arg(i + 1).arg(pages.size())))
        << pages[i].toStdString();
  }
}

TEST(HandoutPages, AQuestionIsOnOnePageWithItsChoices) {
  HandoutOptions teacher;
  teacher.forTeacher = true;
  for (const HandoutOptions& options : {HandoutOptions{}, teacher}) {
    int questions = 0;
    for (const QString& page : pagesOf(longLesson(), options)) {
      const qsizetype asked = page.count("Question number");
      questions += static_cast<int>(asked);
      EXPECT_GE(page.count("☐ last choice"), asked) << page.toStdString();
      EXPECT_EQ(page.count("☐ one choice"), asked) << page.toStdString();
    }
    EXPECT_EQ(questions, 12);
  }
  EXPECT_EQ(handoutHtml(longLesson()).count("<div class=\"question\">"), 12);
}

/// A picture that is slightly too high for the rest of a page becomes smaller: else it would stand
/// alone on the next page, and much of this one would be empty.
TEST(HandoutPages, PicturesBecomeSlightlySmallerToFitOnTheirPage) {
  HandoutOptions teacher;
  teacher.forTeacher = true;
  Json json = sampleLesson();
  const auto pictureWidths = [&](int lines) {
    json["notes"]["en"] = Json::array();
    for (int i = 0; i < lines; ++i) json["notes"]["en"].push_back("Note.");
    std::vector<double> widths;  // inches
    const QStringList rows = saidOfPdf("pdfimages -list", "", lessonOf(json), teacher).split('\n');
    for (const QString& row : rows)
      if (const QStringList cells = row.simplified().split(' '); cells.value(2) == "image")
        widths.push_back(cells.value(3).toDouble() / cells.value(12).toDouble());
    return widths;
  };
  bool isAnySmaller = false;
  for (int lines = 1; lines < 20; ++lines) {
    const std::vector<double> widths = pictureWidths(lines);
    ASSERT_GT(widths.size(), 1U);
    const auto [least, most] = std::ranges::minmax(widths);
    EXPECT_GT(least, 0.84 * most);
    isAnySmaller = isAnySmaller || least < 0.98 * most;
  }
  EXPECT_TRUE(isAnySmaller);
}

/// Notes may have more lines than a page.
TEST(HandoutPages, ATextThatIsLongerThanAPageGoesOnOverTheNextOnes) {
  Json json = sampleLesson();
  Json& notes = json["notes"]["en"] = Json::array();
  for (int i = 0; i < 150; ++i) notes.push_back("Note number " + std::to_string(i + 1) + ".");
  HandoutOptions teacher;
  teacher.forTeacher = true;
  const QStringList pages = pagesOf(lessonOf(json), teacher);
  const std::string all = pages.join('\n').toStdString();
  for (int i = 0; i < 150; ++i)
    EXPECT_THAT(all, HasSubstr("Note number " + std::to_string(i + 1) + "."));
  EXPECT_FALSE(pages[0].contains("1. First")) << "the steps come after the notes";
}

}  // namespace
}  // namespace asperity
