// Pictures of the pages that open measured files and of the tab of the material, in both languages
// and themes, to be looked at.
// Usage: import_screenshot FOLDER [--surface FILE]... [--moduli FILE]... [--tab] [--panel]
//        [--fit SCENE] [--quick]
#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QTabBar>
#include <QTabWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cstdio>

#include "core/scene/scene_file.h"
#include "tests/ui/window/event_watch.h"
#include "ui/language/language.h"
#include "ui/panels/parameter_panel.h"
#include "ui/window/curve/comparison_commands.h"
#include "ui/window/figures/diagram_view.h"
#include "ui/window/fit/fit_page.h"
#include "ui/window/import/import_commands.h"
#include "ui/window/import/material_import.h"
#include "ui/window/import/surface_import.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/run_window.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/scene_tabs.h"

namespace {

using namespace asperity;

constexpr int kPatience = 60000;  // ms
constexpr double kBusy = 5e-3;    // s of the processor for one event

struct Wish {
  QString folder;
  QStringList surfaces, moduli;
  QString fitted;
  bool tab = false, panel = false, quick = false;
  QStringList keys;
};

/// Whether it came within patience; a picture that did not is taken as it is.
template <class Condition>
void waitFor(Condition condition) {
  if (!QTest::qWaitFor(condition, kPatience)) std::fputs("not in time\n", stderr);
}

/// One window in one language, theme and size.
class Photographer {
 public:
  Photographer(const Wish& wish, const char* language, bool dark, QSize size)
      : wish_(wish), size_(size) {
    useLanguage(language);
    label_ = QStringLiteral("%1_%2_%3").arg(language, dark ? "dark" : "light").arg(size.width());
    window_ = std::make_unique<MainWindow>(libraryScenes().front().scene);
    window_->appearance().setDark(dark);
    window_->resize(size);
    window_->show();
  }

  void takeAll() {
    for (const QString& file : wish_.surfaces) surface(file);
    for (const QString& file : wish_.moduli) moduli(file);
    if (wish_.tab) tab();
    if (wish_.panel) panel();
    if (!wish_.fitted.isEmpty()) fit();
  }

 private:
  void save(QWidget& widget, const QString& name) {
    QTest::qWait(50);
    widget.grab().save(QDir(wish_.folder).filePath(name + "_" + label_ + ".png"));
  }
  void wait(ImportPage& page, const char* view) {
    page.resize(size_.boundedTo(QSize(1240, 820)) - QSize(40, 40));
    waitFor([&] { return !page.isReading(); });
    auto* sheet = page.findChild<DiagramView*>(view);
    if (page.isReady()) waitFor([&] { return sheet->isPainted(); });
    std::printf("%s\n", qPrintable(page.errorText()));
  }
  void surface(const QString& file) {
    auto& watched = static_cast<WatchedApplication&>(*qApp);
    watched.takeBusy(0);
    QElapsedTimer whole;
    whole.start();
    const double begin = threadSeconds();
    SurfaceImport& page = window_->imports().openSurface(file);
    std::printf("the page stands after %lld ms, %.0f ms of the processor\n", whole.elapsed(),
                1e3 * (threadSeconds() - begin));
    int moves = 0;
    QObject::connect(page.findChild<QProgressBar*>("importProgress"), &QProgressBar::valueChanged,
                     [&](int value) {
                       ++moves;
                       if (wish_.quick) std::printf("%lld ms: %d\n", whole.elapsed(), value);
                     });
    wait(page, "surfaceSpectrum");
    std::printf("%s: %lld ms, %d steps of progress\n", qPrintable(file), whole.elapsed(), moves);
    for (const BusyEvent& event : watched.takeBusy(kBusy))
      std::printf("%.1f ms of the processor: %s\n", 1e3 * event.seconds, qPrintable(event.name));
    save(page, "surface_" + QFileInfo(file).completeBaseName());
    delete &page;
  }
  void moduli(const QString& file) {
    MaterialImport& page = window_->imports().openModuli(file);
    wait(page, "dmaSheet");
    auto* sheets = page.findChild<QTabBar*>("dmaSheets");
    auto* sheet = page.findChild<DiagramView*>("dmaSheet");
    for (int i = 0; i < sheets->count(); ++i) {
      if (wish_.quick && i != 1) continue;
      sheets->setCurrentIndex(i);
      QTest::qWait(500);
      waitFor([&] { return sheet->isPainted(); });
      save(page, QStringLiteral("moduli_%1").arg(i));
    }
    delete &page;
  }
  void tab() {
    Scene rubber = window_->document().scene();
    rubber.elastomer = readScene("{}", "", {}, {"elastomer.material=epdm_70"}).elastomer;
    rubber.surface.rmsHeight = 2e-4;
    window_->document().edit(rubber);
    auto& tabs = *window_->findChild<QTabWidget*>("tabs");
    auto& view = *window_->findChild<DiagramView*>("materialView");
    tabs.setCurrentWidget(&view);
    QTest::qWait(2500);
    waitFor([&] { return view.isPainted(); });
    save(*window_, "tab");
  }
  /// The kinds that have new rows, each from its top.
  void panel() {
    for (const char* set : {"load.kind=pressure", "elastomer.material=epdm_70"}) {
      Scene scene = readScene("{}", "", {}, {set});
      window_->document().edit(scene);
      QTest::qWait(600);
      save(window_->panel(), QStringLiteral("panel_%1").arg(QString(set).section('=', 1)));
    }
    auto* area = window_->panel().findChild<QScrollArea*>();
    area->ensureVisible(0, 700);
    save(window_->panel(), "panel_lower");
  }

  /// Two parameters of a scene with measured friction, before, during and after.
  void fit() {
    window_->document().open(readSceneFile(wish_.fitted.toStdString()));
    QTest::qWait(300);
    FitPage& page = *window_->comparisons().openFit();
    page.resize(size_.boundedTo(QSize(1240, 820)) - QSize(40, 40));
    auto& keys = *page.findChild<QTableWidget*>("fitKeys");
    for (int row = 0; row < keys.rowCount(); ++row)
      if (wish_.keys.contains(keys.item(row, 0)->toolTip().section(' ', -1)))
        keys.item(row, 0)->setCheckState(Qt::Checked);
    save(page, "fit_begin");
    page.findChild<QPushButton*>("fitRun")->click();
    QTest::qWait(900);
    save(page, "fit_running");
    waitFor([&] { return !page.isFitting(); });
    std::printf("%s\n", qPrintable(page.errorText()));
    auto& sheet = *page.findChild<DiagramView*>("fitSheet");
    for (int i = 0; i < 3; ++i) {
      page.findChild<QTabBar*>("fitSheets")->setCurrentIndex(i);
      QTest::qWait(600);
      waitFor([&] { return sheet.isPainted(); });
      save(page, QStringLiteral("fit_%1").arg(i));
    }
    delete &page;
    save(*window_, "fit_window");
  }

  const Wish& wish_;
  QSize size_;
  QString label_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace

int main(int argc, char** argv) {
  WatchedApplication application(argc, argv);
  const QTemporaryDir settings;  // never the user's own
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  prepareApplication(application);
  QCommandLineParser parser;
  parser.addPositionalArgument("FOLDER", "where the pictures go");
  parser.addOptions({{"surface", "a measured surface", "FILE"},
                     {"moduli", "measured moduli", "FILE"},
                     {"tab", "the tab of the material"},
                     {"panel", "rows of the panel"},
                     {"fit", "a scene with measured friction", "SCENE"},
                     {"key", "that is varied in the fit", "KEY"},
                     {"size", "of the window, WxH", "WxH"},
                     {"quick", "one language, theme and size"}});
  parser.process(application);
  if (parser.positionalArguments().size() != 1) parser.showHelp(1);
  const Wish wish{parser.positionalArguments().constFirst(),
                  parser.values("surface"),
                  parser.values("moduli"),
                  parser.value("fit"),
                  parser.isSet("tab"),
                  parser.isSet("panel"),
                  parser.isSet("quick"),
                  parser.values("key")};
  QDir().mkpath(wish.folder);
  if (wish.quick) {
    Photographer(wish, "en", false, {1600, 1000}).takeAll();
    return 0;
  }
  QSize first(1600, 1000), second(1024, 700);
  const QStringList sides = parser.value("size").split('x');
  if (sides.size() == 2) first = second = {sides[0].toInt(), sides[1].toInt()};
  Photographer(wish, "en", false, first).takeAll();
  Photographer(wish, "de", true, second).takeAll();
  return 0;
}
