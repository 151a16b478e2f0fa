// Shows the window on a real display, waits until it is alive, and saves a picture of the screen.
// Usage: window_screenshot FILE.png [--dark] [--size WxH] [--scene FILE [--set KEY=VALUE]...]
//        [--wait MS] [--expect-message] [--figure WORD] [--tab NUMBER]
//        [--do ACTION]... [--point X,Y] [--zoom X,Y,STEPS] [--language CODE]
// ACTION: object name of an action or a button; X and Y: shares of the contact's plot from its left
// lower corner. Exit: 0 when the window was exposed, animated and showed a curve (or, with
// --expect-message, a message); 1 with the reason otherwise.
#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QCommandLineParser>
#include <QPixmap>
#include <QScreen>
#include <QSettings>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>
#include <cstdio>
#include <string>
#include <vector>

#include "core/scene/scene_file.h"
#include "ui/chart/chart_view.h"
#include "ui/language/language.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/figures/diagram_view.h"
#include "ui/window/figures/figures_page.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/run_window.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/session.h"
#include "ui/window/main/window_pages.h"

namespace {

using namespace asperity;

struct Wish {
  QString picture, scene, figure, language;
  QSize size{1280, 800};
  std::vector<std::string> assignments;
  QStringList actions;
  QStringList point, zoom;  // empty: not asked for
  int tab = -1;             // as it comes
  bool dark = false;
  bool message = false;
  int wait = 1500;  // ms
};

Wish readWish(const QApplication& application) {
  QCommandLineParser parser;
  parser.addPositionalArgument("FILE.png", "where the picture goes");
  parser.addOptions({{"dark", "dark colours"},
                     {"size", "of the window, WxH", "WxH"},
                     {"scene", "scene file", "FILE"},
                     {"set", "over the scene file", "KEY=VALUE"},
                     {"figure", "of the paper, on its page", "WORD"},
                     {"tab", "under the contact, from 0", "NUMBER"},
                     {"language", "of all texts", "CODE"},
                     {"do", "to trigger before the picture", "ACTION"},
                     {"point", "where the cursor is over the contact", "X,Y"},
                     {"zoom", "wheel turned over the contact", "X,Y,STEPS"},
                     {"expect-message", "the scene cannot run"},
                     {"wait", "milliseconds to run before the picture", "MS"}});
  parser.process(application);
  Wish wish;
  if (parser.positionalArguments().size() != 1) parser.showHelp(1);
  wish.picture = parser.positionalArguments().constFirst();
  wish.scene = parser.value("scene");
  wish.figure = parser.value("figure");
  wish.language = parser.value("language");
  for (const QString& text : parser.values("set")) wish.assignments.push_back(text.toStdString());
  if (parser.isSet("tab")) wish.tab = parser.value("tab").toInt();
  wish.actions = parser.values("do");
  wish.point = parser.value("point").split(',', Qt::SkipEmptyParts);
  wish.zoom = parser.value("zoom").split(',', Qt::SkipEmptyParts);
  wish.dark = parser.isSet("dark");
  wish.message = parser.isSet("expect-message");
  if (parser.isSet("wait")) wish.wait = parser.value("wait").toInt();
  const QStringList sides = parser.value("size").split('x');
  if (sides.size() == 2) wish.size = {sides[0].toInt(), sides[1].toInt()};
  return wish;
}

constexpr int kPictureWait = 60000;  // ms, far more than they take

const char* complaint(MainWindow& window, const Wish& wish, int frames) {
  if (wish.message) return window.messages().isVisible() ? nullptr : "no message appeared";
  if (frames < 5) return "the contact is not animated";
  if (window.canvas().backendName().isEmpty()) return "nothing draws the contact";
  if (window.plotView().sheet().diagrams[0].series.empty()) return "no curve has arrived";
  return nullptr;
}

/// Whether the middle of the contact view is more than one flat colour.
bool isPainted(const QImage& image) {
  const int x = image.width() / 3;
  for (int y = 0; y < image.height() / 2; ++y)
    if (image.pixel(x, y) != image.pixel(x, image.height() / 8)) return true;
  return false;
}

/// As from the menu; waits for the picture.
bool showFigure(MainWindow& window, const QString& word) {
  auto* action = window.findChild<QAction*>("figure:" + word);
  if (!action) return false;
  action->trigger();
  DiagramView& picture = window.pages().figuresPage().picture();
  const bool isThere = QTest::qWaitFor([&] { return picture.isPainted(); }, 300000);
  QTest::qWait(300);  // on the screen too
  return isThere;
}

QPointF placeOn(const ContactCanvas& canvas, const QStringList& shares) {
  const QRectF plot = canvas.plotArea();
  return {plot.left() + shares[0].toDouble() * plot.width(),
          plot.bottom() - shares[1].toDouble() * plot.height()};
}

/// What hands would do to the contact view.
void handle(MainWindow& window, const Wish& wish) {
  ContactCanvas& canvas = window.canvas();
  for (const QString& name : wish.actions)
    if (auto* action = window.findChild<QAction*>(name))
      action->trigger();
    else if (auto* button = window.findChild<QAbstractButton*>(name))
      button->click();
  if (wish.zoom.size() == 3) {
    const QPointF place = placeOn(canvas, wish.zoom);
    QWheelEvent wheel(place, canvas.mapToGlobal(place), {},
                      {0, static_cast<int>(120 * wish.zoom[2].toDouble())}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&canvas, &wheel);
  }
  if (wish.point.size() == 2) QTest::mouseMove(&canvas, placeOn(canvas, wish.point).toPoint());
}

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  const QTemporaryDir settings;  // never the user's own
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  const Wish wish = readWish(application);
  prepareApplication(application);
  useLanguage(wish.language.toStdString());
  const std::vector<LibraryScene> library = libraryScenes();
  const Scene scene = !wish.scene.isEmpty()
                          ? readSceneFile(wish.scene.toStdString(), wish.assignments)
                      : library.empty() ? Scene{}
                                        : library.front().scene;
  MainWindow window(scene);
  window.appearance().setDark(wish.dark);
  window.resize(wish.size);
  int pictures = 0;
  QObject::connect(&window.canvas(), &ContactCanvas::painted, [&] { ++pictures; });
  window.show();
  if (!QTest::qWaitForWindowExposed(&window)) return std::fputs("never exposed\n", stderr), 1;
  if (wish.tab >= 0) window.findChild<QTabWidget*>("tabs")->setCurrentIndex(wish.tab);
  QTest::qWait(wish.wait / 2);
  handle(window, wish);
  QTest::qWait(wish.wait / 2);
  // However slow the machine is.
  if (!QTest::qWaitFor([&] { return !complaint(window, wish, pictures); }, kPictureWait)) {
    const char* reason = complaint(window, wish, pictures);
    std::fprintf(stderr, "window_screenshot: %s\n", reason);
    return 1;
  }
  if (!wish.figure.isEmpty() && !showFigure(window, wish.figure))
    return std::fputs("window_screenshot: the figure does not come\n", stderr), 1;
  const QImage image = window.screen()->grabWindow(0).toImage();
  std::printf("%s, %d frames/s\n", qPrintable(window.canvas().backendName()),
              window.canvas().framesPerSecond());
  if (!wish.message && !isPainted(image))
    return std::fputs("window_screenshot: the contact is blank\n", stderr), 1;
  return image.save(wish.picture, nullptr, 80) ? 0 : 1;
}
