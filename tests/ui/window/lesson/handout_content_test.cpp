// Handouts of lessons: what students and teachers get, and what is printed below a question.
#include <gtest/gtest.h>

#include "tests/core/temporary_folder.h"
#include "tests/ui/window/lesson/lessons_fixture.h"
#include "ui/window/lesson/handout.h"
#include "ui/window/lesson/lesson_list.h"
#include "ui/window/lesson/lesson_text.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

class HandoutWindowTest : public LessonsTest {};

/// The teacher closes the list while its handout is being made.
TEST_F(HandoutWindowTest, AHandoutIsSavedThoughItsPageIsClosed) {
  TemporaryFolder folder;
  LessonList& list = lessons().showList();
  list.saver().save(lessonOf(sampleLesson()),
                    QString::fromStdString((folder / "handout.html").string()), false);
  list.close();
  EXPECT_TRUE(waitFor([&] { return std::filesystem::exists(folder / "handout.html"); }));
  EXPECT_TRUE(waitFor([&] { return window_.messages().text().contains("handout.html"); }));
}

TEST(LessonTexts, MarkupBecomesHtmlAndNothingElseDoes) {
  EXPECT_EQ(lessonHtml("A *b* and **c**.\n\nD < 2 * 3 * 4"),
            "<p>A <i>b</i> and <b>c</b>.</p><p>D &lt; 2 * 3 * 4</p>");
  EXPECT_EQ(lessonHtml("See:\n- one\n- *two*"),
            "<p>See:</p><ul><li>one</li><li><i>two</i></li></ul>");
  EXPECT_EQ(lessonHtml("<b>x</b>"), "<p>&lt;b&gt;x&lt;/b&gt;</p>");
  // A number stays with its unit; other words may be parted.
  EXPECT_EQ(lessonHtml("H = 0.7"), QStringLiteral("<p>H\u00A0=\u00A00.7</p>"));
  EXPECT_EQ(lessonHtml("at 3 mm/s, 70 °C, 40 lines"),
            QStringLiteral("<p>at 3\u00A0mm/\u2060s, 70\u00A0°C, 40 lines</p>"));
  EXPECT_EQ(lessonHtml("as 1/v or 1/τ, here/there"),
            QStringLiteral("<p>as 1/\u2060v or 1/\u2060τ, here/there</p>"));
}

TEST(Handouts, StudentsGetQuestionsAndTeachersAnswers) {
  const Lesson lesson = lessonOf(sampleLesson());
  HandoutOptions options;
  const QByteArray students = handoutHtml(lesson, options);
  options.forTeacher = true;
  const QByteArray teachers = handoutHtml(lesson, options);
  for (const QByteArray& page : {students, teachers}) {
    EXPECT_TRUE(page.contains("Twice as fast?"));
    EXPECT_TRUE(page.contains("data:image/png;base64,"));
    EXPECT_FALSE(page.contains("http"));
  }
  EXPECT_FALSE(students.contains("Answer:"));
  EXPECT_FALSE(students.contains("<p>One.</p>"));
  EXPECT_TRUE(teachers.contains("Answer:"));
  EXPECT_TRUE(teachers.contains("<p>One.</p>"));
  EXPECT_GT(teachers.count("<img"), students.count("<img"));
  EXPECT_TRUE(teachers.contains("After the answer to step 1"));  // above its picture
  EXPECT_TRUE(students.contains("Name: ___"));
  EXPECT_FALSE(teachers.contains("Name: ___"));
  EXPECT_EQ(handoutHtml(lesson, options), teachers);
}

/// The next step begins with what the answer made of the scene: printed, it would be the answer.
TEST(Handouts, NoPictureBelowAQuestionTellsItsAnswer) {
  Json json = sampleLesson();
  json["steps"][1].erase("set");
  EXPECT_EQ(handoutHtml(lessonOf(json), {}).count("<img"), 2);  // contact and chart of the first
}

TEST(Handouts, ACurveThatWasAskedForIsNotPrintedBelowTheNextStep) {
  Json json = sampleLesson();
  json["steps"][0]["show"]["curve"] = "hidden";
  json["steps"][1].erase("set");
  EXPECT_FALSE(handoutHtml(lessonOf(json), {}).contains("alt=\"the friction curve"));
  HandoutOptions teacher;
  teacher.forTeacher = true;
  EXPECT_TRUE(handoutHtml(lessonOf(json), teacher).contains("alt=\"the friction curve"));
}

/// A choice needs no chart, and a curve that is to be guessed is not printed.
TEST(Handouts, AnEmptyChartStandsWhereAPointIsDrawn) {
  Json json = sampleLesson();
  json["steps"][0]["show"]["curve"] = "hidden";
  json["steps"][1]["prediction"] = {{"kind", "point"}, {"question", "Where?"}, {"x", 0.1}};
  const QByteArray beside = handoutHtml(lessonOf(json), {});
  EXPECT_EQ(beside.count("alt=\"a chart of friction, to draw into, with the curve for "), 1);
  json["steps"][1]["show"].erase("beside");
  const QByteArray html = handoutHtml(lessonOf(json), {});
  EXPECT_EQ(html.count("an empty chart of friction"), 1);
  EXPECT_GT(html.indexOf("an empty chart of friction"), html.indexOf("Second"));
  EXPECT_LT(html.indexOf("an empty chart of friction"), html.indexOf("Where?"));
  EXPECT_FALSE(html.contains("alt=\"the friction curve"));
}

/// As on the screen, where the state of the step is marked in the empty chart.
TEST(Handouts, AnEmptyChartHasTheStateFromWhichAGuessBegins) {
  Json json = sampleLesson();
  json["steps"][1]["prediction"] = {{"kind", "point"}, {"question", "Where?"}, {"x", 0.1}};
  json["steps"][1]["show"].erase("beside");
  for (const HandoutBlock& block : handoutBlocks(lessonOf(json), {})) {
    if (!block.picture || !block.picture->name.startsWith("an empty chart")) continue;
    const QImage& image = block.picture->image;
    int coloured = 0;  // lines and letters of the axes are grey
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        coloured += image.pixelColor(x, y).saturation() > 100 ? 1 : 0;
    EXPECT_GT(coloured, 100);
    return;
  }
  FAIL() << "there is no empty chart";
}

/// On paper pictures of one width have letters of one size; a lower contact could not be seen.
TEST(Handouts, PicturesAreEquallyWideAndHighEnoughToBeSeen) {
  HandoutOptions teacher;
  teacher.forTeacher = true;
  int width = 0, pictures = 0;
  for (const HandoutBlock& block : handoutBlocks(lessonOf(sampleLesson()), teacher)) {
    if (!block.picture) continue;
    const QImage& image = block.picture->image;
    if (width == 0) width = image.width();
    EXPECT_EQ(image.width(), width) << block.picture->name.toStdString();
    EXPECT_GT(image.height(), 0.35 * width) << block.picture->name.toStdString();
    ++pictures;
  }
  EXPECT_GT(pictures, 2);
}

/// The same curve on another axis is another picture.
TEST(Handouts, ACurveIsPrintedAgainOnALinearAxis) {
  Json json = sampleLesson();
  json["steps"][1] = {{"text", "Again."}};
  const auto charts = [&json] {
    return handoutHtml(lessonOf(json), {}).count("alt=\"the friction curve");
  };
  const qsizetype before = charts();
  json["steps"][1]["show"]["scale"] = "linear";
  EXPECT_EQ(charts(), before + 1);
}

TEST(Handouts, PdfIsWholeAndTheSameEveryTime) {
  const Lesson lesson = lessonOf(sampleLesson());
  const QByteArray pdf = handoutPdf(lesson);
  EXPECT_TRUE(pdf.startsWith("%PDF-"));
  EXPECT_TRUE(pdf.trimmed().endsWith("%%EOF"));
  EXPECT_FALSE(pdf.contains("CreationDate"));
  EXPECT_EQ(handoutPdf(lesson), pdf);
}

}  // namespace
}  // namespace asperity
