// Every step of every shipped lesson in a small window, before and after its answer, in both
// languages: nothing of the pane is cut off, nothing lies over anything else, the buttons that lead
// on are in sight and stay where they are, and the Tab key reaches every control.
#include <gmock/gmock.h>

#include <QCheckBox>
#include <QDialog>
#include <QDockWidget>
#include <QGuiApplication>
#include <QLabel>
#include <QLayout>
#include <QListWidget>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QTextDocument>
#include <set>

#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_results.h"
#include "tests/core/temporary_folder.h"
#include "tests/ui/window/qt_application.h"
#include "tests/ui/window/readable_widgets.h"
#include "tests/ui/window/window_in.h"
#include "ui/panels/controls.h"
#include "ui/panels/labels.h"
#include "ui/panels/parameter_panel.h"
#include "ui/window/lesson/lesson_editor.h"
#include "ui/window/lesson/lesson_list.h"
#include "ui/window/lesson/lesson_pane.h"
#include "ui/window/lesson/lessons.h"
#include "ui/window/lesson/prediction_point.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/scene_tabs.h"

namespace asperity {
namespace {

using testing::IsEmpty;

constexpr QSize kSmall(1024, 700);
constexpr QSize kMinChart(300, 100);    // pixels of a chart that can be read
constexpr QSize kMinContact(300, 150);  // and of the contact

constexpr int kLayoutPatience = 1500;  // ms, until a layout has settled

using Faults = std::vector<std::string>;

std::string nameOf(const QWidget& widget) {
  return (widget.metaObject()->className() + (' ' + widget.objectName())).toStdString();
}

/// Words that are wider than their label, which wraps only between words.
void findWideWords(const QWidget& pane, Faults& faults) {
  for (const QLabel* label : pane.findChildren<QLabel*>()) {
    if (!label->isVisible() || !label->wordWrap()) continue;
    QTextDocument document;
    document.setDocumentMargin(0);
    document.setDefaultFont(label->font());
    if (label->textFormat() == Qt::PlainText)
      document.setPlainText(label->text());
    else
      document.setHtml(label->text());
    document.setTextWidth(label->contentsRect().width());
    if (document.idealWidth() > label->contentsRect().width() + 1)
      faults.push_back(nameOf(*label) + " has a word that is too wide");
  }
}

void findOverlaps(const QWidget& parent, Faults& faults) {
  const QList<QWidget*> children = parent.findChildren<QWidget*>(Qt::FindDirectChildrenOnly);
  for (const QWidget* one : children)
    for (const QWidget* other : children)
      if (one < other && one->isVisible() && other->isVisible() &&
          one->geometry().intersects(other->geometry()))
        faults.push_back(nameOf(*one) + " lies over " + nameOf(*other));
  for (const QWidget* child : children) findOverlaps(*child, faults);
}

void findWhatIsOutOfSight(MainWindow& window, Faults& faults) {
  QWidget& pane = window.lessons().player().pane();
  for (const char* name :
       {"lessonBack", "lessonShow", "lessonNext", "lessonProgress", "lessonScore"}) {
    const auto* widget = window.findChild<QWidget*>(name);
    const QRect place(widget->mapTo(&window, QPoint()), widget->size());
    if (widget->isVisible() && (!window.rect().contains(place) ||
                                widget->visibleRegion().boundingRect() != widget->rect()))
      faults.push_back(std::string(name) + " is not in sight");
  }
  const auto& title = dynamic_cast<WrappedLabel&>(*window.findChild<QLabel*>("lessonTitle"));
  if (title.shownText() != title.text())
    faults.push_back("the title is shortened: " + title.shownText().toStdString());
  const auto* scroll = pane.findChild<QScrollArea*>();
  if (scroll->widget()->width() > scroll->viewport()->width())
    faults.push_back("the texts would have to be scrolled sideways");
  // The text is not scrolled while there is room below the parameters.
  const auto* rows = window.findChild<ParameterPanel*>()->findChild<QScrollArea*>();
  constexpr int kRoom = 20;  // pixels that are not worth a movement of the border
  const QLayout& layout = *rows->widget()->layout();
  const int width = rows->viewport()->width();
  const int needed = layout.hasHeightForWidth() ? layout.totalHeightForWidth(width)
                                                : layout.totalMinimumSize().height();
  const int room = rows->viewport()->height() - needed;
  if (rows->isVisible() && scroll->verticalScrollBar()->maximum() > 0 && room > kRoom)
    faults.push_back("the text is scrolled beside free room");
  constexpr int kOneRow = 52;
  if (rows->isVisible() && scroll->verticalScrollBar()->maximum() > 0 && room < 0 &&
      rows->viewport()->height() > kOneRow + kRoom)
    faults.push_back("text and parameters are scrolled, and the text could be whole");
  // What the step speaks of is to be seen beside it.
  if (window.tabs().width() < kMinChart.width() || window.tabs().height() < kMinChart.height())
    faults.push_back("the chart is too small");
  const auto* contact = window.findChild<QWidget*>("contactPage");
  if (!contact->isVisible() || contact->width() < kMinContact.width() ||
      contact->height() < kMinContact.height())
    faults.push_back("the contact is too small");
}

/// Controls of the pane, and the point on the chart, which the Tab key does not reach. One of the
/// choices is reached, and the arrow keys go on to the others.
void findUnreached(MainWindow& window, Faults& faults) {
  LessonPane& pane = window.lessons().player().pane();
  std::set<const QWidget*> wanted;
  bool hasChoice = false;
  for (QWidget* widget : pane.findChildren<QWidget*>() + pane.foot().findChildren<QWidget*>()) {
    const bool isControl = qobject_cast<QAbstractButton*>(widget) ||
                           widget->objectName() == "lessonNumber" ||
                           widget->objectName() == "lessonText";
    if (!isControl || !widget->isVisible() || !widget->isEnabled()) continue;
    if (widget->objectName().startsWith("lessonChoice:") && std::exchange(hasChoice, true))
      continue;
    wanted.insert(widget);
  }
  PredictionPoint& point = window.lessons().player().point();
  if (point.isVisible() && !window.lessons().player().isRevealed()) wanted.insert(&point);
  for (const char* key : {"lessonKeep", "lessonEnd"})
    wanted.insert(window.findChild<QWidget*>(key));
  std::set<const QWidget*> reached;
  window.findChild<QLabel*>("lessonText")->setFocus();
  while (const QWidget* focus = window.focusWidget()) {
    if (!reached.insert(focus).second) break;
    QTest::keyClick(window.windowHandle(), Qt::Key_Tab);
  }
  for (const QWidget* widget : wanted)
    if (!reached.contains(widget)) faults.push_back(nameOf(*widget) + " is not reached by Tab");
}

class LessonLayout : public testing::TestWithParam<std::string> {};

TEST_P(LessonLayout, EveryStepIsWholeAndReachedInASmallWindow) {
  WindowIn window("en");
  window->resize(kSmall);
  ASSERT_TRUE(QTest::qWaitForWindowActive(&*window));
  Lessons& lessons = window->lessons();
  ASSERT_TRUE(lessons.open(QString::fromStdString(GetParam())));
  auto& next = *window->findChild<QPushButton*>("lessonNext");
  const auto topOfNext = [&] { return next.mapTo(&*window, QPoint()).y(); };
  const int top = topOfNext();
  const auto check = [&](bool isRevealed) {
    // A moving picture, which no layout depends on, would take a third of the time.
    window->session().setPlaying(false);
    for (const char* language : {"en", "de"}) {
      SCOPED_TRACE(std::to_string(lessons.player().step() + 1) +
                   (isRevealed ? " after " : " before ") + language);
      useLanguage(language);
      const bool isGerman = std::string_view(language) == "de";
      const auto* progress = window->findChild<QLabel*>("lessonProgress");
      ASSERT_TRUE(QTest::qWaitFor([&] { return progress->text().contains(" von ") == isGerman; }));
      QCoreApplication::processEvents();  // the layout of the other texts
      EXPECT_EQ(cutOffIn(lessons.player().pane()), "");
      EXPECT_EQ(cutOffIn(lessons.player().pane().foot()), "");
      Faults faults;
      const auto isWhole = [&] {
        faults.clear();
        findWideWords(lessons.player().pane(), faults);
        for (const char* dock : {"lessonDock", "lessonFootDock"})
          findOverlaps(*window->findChild<QDockWidget*>(dock), faults);
        findWhatIsOutOfSight(*window, faults);
        return faults.empty();
      };
      (void)QTest::qWaitFor(isWhole, kLayoutPatience);
      if (!isGerman) findUnreached(*window, faults);
      EXPECT_THAT(faults, IsEmpty());
      EXPECT_EQ(topOfNext(), top);
    }
    useLanguage("en");
  };
  const auto steps = static_cast<int>(lessons.player().lesson()->steps.size());
  for (int step = 0; step < steps; ++step) {
    if (!lessons.player().isRevealed()) {
      check(false);
      window->findChild<QPushButton*>("lessonShow")->click();
      ASSERT_TRUE(QTest::qWaitFor([&] { return lessons.player().isRevealed(); }, kWindowPatience));
    }
    check(true);
    next.click();
  }
  EXPECT_FALSE(lessons.player().isRunning());
  EXPECT_EQ(window->size(), kSmall);  // nothing made it larger
}

std::vector<std::string> shippedNames() {
  std::vector<std::string> names;
  for (const ShippedFile& lesson : shippedLessons()) names.emplace_back(lesson.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(All, LessonLayout, testing::ValuesIn(shippedNames()),
                         [](const auto& one) { return one.param; });

class LessonPages : public testing::TestWithParam<const char*> {};

/// The list, the editor at every step of a lesson, and the results.
TEST_P(LessonPages, AreReadableAndReachable) {
  WindowIn window(GetParam());
  window->move(QGuiApplication::screens().back()->geometry().topLeft());
  window->resize(kSmall);
  const auto expectNoFaults = [](QWidget& page, const std::string& name) {
    page.resize(page.size().boundedTo(kSmall - QSize(40, 80)));
    QStringList faults = readingFaults(page);
    faults += sizeFaults(page, kSmall) + tabFaults(page);
    EXPECT_TRUE(faults.isEmpty()) << name << ":\n" << faults.join('\n').toStdString();
  };
  Lessons& lessons = window->lessons();
  LessonList& list = lessons.showList();
  expectNoFaults(list, "list");
  list.findChild<QCheckBox*>("lessonNotes")->click();
  expectNoFaults(list, "list with notes");
  list.close();
  const Lesson lesson = readNamedLesson("rubber_is_not_coulomb", readNamedScene);
  LessonEditor& editor = lessons.showEditor(lesson, {});
  for (int row = 0; row <= static_cast<int>(lesson.steps.size()); ++row) {
    editor.findChild<QListWidget*>("editorSteps")->setCurrentRow(row);
    expectNoFaults(editor, "editor " + std::to_string(row));
  }
  editor.close();
  TemporaryFolder folder;
  LessonResults results = emptyResults(lesson);
  for (int step = 0; step < static_cast<int>(lesson.steps.size()); ++step)
    if (askingStep(lesson, step)) {
      LessonResult one;
      one.step = step;
      results.set(one);
    }
  folder.write("ada.json", resultsJson(results));
  const QString file = QString::fromStdString((folder / "ada.json").string());
  ASSERT_TRUE(lessons.open(file));
  expectNoFaults(*window->findChild<QDialog*>("lessonResults"), "results");
  window->findChild<QDialog*>("lessonResults")->close();
  ASSERT_TRUE(lessons.openResults({file, file}));
  expectNoFaults(*window->findChild<QDialog*>("classResults"), "class");
}

INSTANTIATE_TEST_SUITE_P(Languages, LessonPages, testing::Values("en", "de"));

}  // namespace
}  // namespace asperity
