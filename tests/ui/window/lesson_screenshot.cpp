// Walks through a lesson on a real display and saves a picture of the screen of every step, before
// and after its answer. Usage: lesson_screenshot FOLDER --lesson NAME [--dark] [--size WxH]
// [--language CODE] [--only STEP] [--every] [--list] [--notes] [--editor STEP] [--handout FILE
// [--teacher]]. With --every each picture is saved at three sizes, in both themes and both
// languages, in a folder for each, such as "1024x700 dark de"; the display has to be as large as
// the largest.
#include <QApplication>
#include <QCheckBox>
#include <QCommandLineParser>
#include <QDir>
#include <QLineEdit>
#include <QListWidget>
#include <QPixmap>
#include <QPushButton>
#include <QRadioButton>
#include <QScreen>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <cstdio>

#include "ui/chart/chart_view.h"
#include "ui/language/language.h"
#include "ui/window/lesson/handout.h"
#include "ui/window/lesson/lesson_editor.h"
#include "ui/window/lesson/lesson_list.h"
#include "ui/window/lesson/lessons.h"
#include "ui/window/lesson/prediction_point.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/run_window.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/session.h"

namespace {

using namespace asperity;

void settle(MainWindow& window, int milliseconds) {
  if (!QTest::qWaitFor([&] { return window.session().friction().progress() >= 1; }, 20000))
    std::fputs("the curve does not come\n", stderr);
  QTest::qWait(milliseconds);
}

bool save(MainWindow& window, const QString& file) {
  settle(window, 700);
  return window.screen()->grabWindow(0).toImage().save(file, nullptr, 80);
}

/// Saves the window at every size, in every theme and language.
bool saveEvery(MainWindow& window, const QString& folder, const QString& name) {
  bool isSaved = true;
  for (const QSize size : {QSize(1024, 700), QSize(1280, 720), QSize(2560, 1440)}) {
    window.resize(size);
    for (const char* language : {"en", "de"}) {
      useLanguage(language);
      for (const bool isDark : {false, true}) {
        window.appearance().setDark(isDark);
        settle(window, size.width() > 2000 ? 1500 : 600);  // a large contact is drawn for longer
        const QDir in(QStringLiteral("%1/%2x%3 %4 %5")
                          .arg(folder)
                          .arg(size.width())
                          .arg(size.height())
                          .arg(isDark ? "dark" : "light", language));
        const QRect place(window.mapToGlobal(QPoint()), window.size());
        isSaved = in.mkpath(".") &&
                  window.screen()->grabWindow(0).copy(place).save(in.filePath(name), nullptr, 90) &&
                  isSaved;
      }
    }
  }
  return isSaved;
}

/// Answers as a student would: the first choice, a number, a point somewhere.
void answer(MainWindow& window) {
  if (auto* choice = window.findChild<QRadioButton*>("lessonChoice:0")) choice->click();
  if (auto* number = window.findChild<QLineEdit*>("lessonNumber")) QTest::keyClicks(number, "2");
  PredictionPoint& point = window.lessons().player().point();
  if (point.isVisible()) QTest::mouseClick(&point, Qt::LeftButton, {}, point.rect().center());
}

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  const QTemporaryDir settings;  // never the user's own
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  QCommandLineParser parser;
  parser.addPositionalArgument("FOLDER", "where the pictures go");
  parser.addOptions({{"lesson", "name or file", "NAME"},
                     {"dark", "dark colours"},
                     {"size", "of the window, WxH", "WxH"},
                     {"language", "of all texts", "CODE"},
                     {"only", "one step, from 1", "STEP"},
                     {"every", "each picture at every size, in every theme and language"},
                     {"list", "the page of all lessons"},
                     {"notes", "that page with the notes for teachers"},
                     {"editor", "the editor at a step, from 1; 0: the lesson", "STEP"},
                     {"handout", "instead, a handout as HTML or PDF", "FILE"},
                     {"teacher", "the handout is for teachers"}});
  parser.process(application);
  const QString folder = parser.positionalArguments().value(0);
  prepareApplication(application);
  useLanguage(parser.value("language").toStdString());
  MainWindow window(libraryScenes().front().scene);
  window.appearance().setDark(parser.isSet("dark"));
  const QStringList sides = parser.value("size").split('x');
  if (sides.size() == 2) window.resize(sides[0].toInt(), sides[1].toInt());
  window.show();
  if (!QTest::qWaitForWindowExposed(&window)) return std::fputs("never exposed\n", stderr), 1;
  if (parser.isSet("list") || parser.isSet("notes")) {
    LessonList& list = window.lessons().showList();
    list.findChild<QCheckBox*>("lessonNotes")->setChecked(parser.isSet("notes"));
    return save(window, folder + "/list.png") ? 0 : 1;
  }
  if (!window.lessons().open(parser.value("lesson"))) return 1;
  if (parser.isSet("handout")) {
    HandoutOptions options;
    options.forTeacher = parser.isSet("teacher");
    writeHandout(parser.value("handout").toStdString(), *window.lessons().player().lesson(),
                 options);
    return 0;
  }
  if (parser.isSet("editor")) {
    LessonEditor& editor = window.lessons().showEditor(*window.lessons().player().lesson(), {});
    editor.findChild<QListWidget*>("editorSteps")->setCurrentRow(parser.value("editor").toInt());
    return save(window, folder + "/editor.png") ? 0 : 1;
  }
  const int only = parser.value("only").toInt();
  const auto take = [&](const QString& name) {
    return parser.isSet("every") ? saveEvery(window, folder, name)
                                 : save(window, folder + '/' + name);
  };
  const auto steps = static_cast<int>(window.lessons().player().lesson()->steps.size());
  for (int step = 0; step < steps; ++step) {
    const bool isWanted = only == 0 || only == step + 1;
    const QString name = QStringLiteral("%1").arg(step + 1, 2, 10, QChar('0'));
    auto* next = window.findChild<QPushButton*>("lessonNext");
    if (!window.lessons().player().isRevealed()) {
      if (isWanted) {
        take(name + "a.png");
        answer(window);
        next->click();
      } else {
        window.findChild<QPushButton*>("lessonShow")->click();
      }
      if (!QTest::qWaitFor([&] { return window.lessons().player().isRevealed(); }, 30000))
        return std::fputs("no answer\n", stderr), 1;
    }
    if (isWanted && !take(name + "b.png")) return 1;
    if (only == step + 1) break;
    // The last one would end the lesson and ask for the answers.
    if (step + 1 < steps) next->click();
  }
  return 0;
}
