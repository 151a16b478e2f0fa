// Pictures of every state of the pages and dialogs that import, fit, export and show figures, in
// one language, theme and size of the screen, to be looked at; and what is wrong with their texts.
// Usage: dialog_screenshot FOLDER PROGRAM [--language CODE] [--dark] [--screen WxH]
//        [--only BEGINNING]... [--moduli FILE] [--surface FILE]... [--no-figures]
#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <cstdio>

#include "tests/ui/window/dialog_states.h"
#include "tests/ui/window/readable_widgets.h"
#include "ui/language/language.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/run_window.h"
#include "ui/window/main/scene_library.h"

using namespace asperity;

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  const QTemporaryDir settings;  // never the user's own
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  prepareApplication(application);
  QCommandLineParser parser;
  parser.addPositionalArgument("FOLDER", "where the pictures go");
  parser.addPositionalArgument("PROGRAM", "asperity, which export dialogs run");
  parser.addOptions({{"language", "of all texts", "CODE", "en"},
                     {"dark", "dark colours"},
                     {"screen", "size of the screen, WxH", "WxH", "1024x700"},
                     {"only", "states whose names begin so", "BEGINNING"},
                     {"moduli", "isotherms of a real rubber", "FILE"},
                     {"surface", "a further measured surface", "FILE"},
                     {"no-figures", "without the figures of the paper"}});
  parser.process(application);
  if (parser.positionalArguments().size() != 2) parser.showHelp(1);
  const QDir folder(parser.positionalArguments().constFirst());
  QDir().mkpath(folder.path());
  const QStringList sides = parser.value("screen").split('x');
  DialogWishes wishes;
  wishes.program = parser.positionalArguments().constLast();
  wishes.screen = {sides.value(0).toInt(), sides.value(1).toInt()};
  wishes.only = parser.values("only");
  wishes.moduli = parser.value("moduli");
  wishes.surfaces = parser.values("surface");
  wishes.hasFigures = !parser.isSet("no-figures");

  useLanguage(parser.value("language").toStdString());
  MainWindow window(libraryScenes().front().scene);
  window.appearance().setDark(parser.isSet("dark"));
  window.resize(wishes.screen);
  window.show();
  if (!QTest::qWaitForWindowExposed(&window)) return std::fputs("never exposed\n", stderr), 1;
  QTest::qWait(300);
  visitDialogs(window, wishes, [&](const QString& name, QWidget& shown) {
    for (const QString& fault :
         readingFaults(shown) +
             (shown.window() == &window ? QStringList() : sizeFaults(shown, wishes.screen)))
      std::printf("%s: %s\n", qPrintable(name), qPrintable(fault));
    shown.grab().save(folder.filePath(name + ".png"));
    std::fflush(stdout);
  });
  return 0;
}
