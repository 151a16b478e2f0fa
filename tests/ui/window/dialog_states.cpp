#include "tests/ui/window/dialog_states.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QTabBar>
#include <QTabWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_results.h"
#include "core/scene/scene_file.h"
#include "tests/core/small_scene.h"
#include "ui/panels/value_entry.h"
#include "ui/window/curve/comparison_commands.h"
#include "ui/window/export/export_dialog.h"
#include "ui/window/figures/claims_table.h"
#include "ui/window/figures/diagram_view.h"
#include "ui/window/figures/figures_page.h"
#include "ui/window/fit/fit_page.h"
#include "ui/window/import/import_commands.h"
#include "ui/window/import/material_import.h"
#include "ui/window/import/surface_import.h"
#include "ui/window/lesson/lesson_editor.h"
#include "ui/window/lesson/lesson_list.h"
#include "ui/window/lesson/lessons.h"
#include "ui/window/main/document_commands.h"
#include "ui/window/main/exports.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/scene_tabs.h"
#include "ui/window/main/session.h"
#include "ui/window/main/window_pages.h"
#include "ui/window/map/map_panel.h"
#include "ui/window/map/map_view.h"

namespace asperity {

namespace {

constexpr int kPatience = 60000;  // ms, far more than anything here takes
const QSize kAround(40, 80);      // pixels of the screen that dialogs leave free
constexpr double kTau = 2 * std::numbers::pi;

template <class Condition>
void waitFor(Condition condition, const char* what) {
  if (!QTest::qWaitFor(condition, kPatience)) std::fprintf(stderr, "%s: not in time\n", what);
}

// ---- Files as people have them
// --------------------------------------------------------------------

/// A profile of a profilometer: a title, a header with units, rough, and with a slope and a bow.
QByteArray profileText(double tilt, char separator, char decimal, const QByteArray& head) {
  QByteArray text = head;
  for (int i = 0; i < 900; ++i) {
    const double x = 0.002 * i;  // mm
    double z = 400 * tilt * x;   // um
    for (int wave = 1; wave < 40; ++wave)
      z += 6.0 / std::pow(wave, 1.1) * std::sin(kTau * wave * x / 0.9 + 1.7 * wave * wave);
    QByteArray row = QByteArray::number(x, 'f', 4) + separator + QByteArray::number(z, 'f', 4);
    text += row.replace('.', decimal) + "\n";
  }
  return text;
}

/// Points x, y, z of a small field.
QByteArray fieldText() {
  QByteArray text = "x [um]\ty [um]\tz [nm]\n";
  for (int row = 0; row < 40; ++row)
    for (int column = 0; column < 120; ++column) {
      const double z = 300 * std::sin(0.31 * column + 0.2 * row) + 140 * std::sin(0.9 * row) +
                       60 * std::sin(1.7 * column * row);
      text += QByteArray::number(5 * column) + "\t" + QByteArray::number(5 * row) + "\t" +
              QByteArray::number(z, 'f', 2) + "\n";
    }
  return text;
}

/// Isotherms of a solid with five arms, shifted by WLF.
QByteArray isothermText(const std::vector<double>& celsius, const QByteArray& head) {
  QByteArray text = head;
  for (const double temperature : celsius) {
    const double shift = std::pow(10, -8.86 * (temperature - 20) / (101.6 + temperature - 20));
    for (int i = 0; i < 16; ++i) {
      const double frequency = 0.1 * std::pow(10, 0.2 * i), w = kTau * frequency * shift;
      double storage = 0.8e6, loss = 0;
      for (int arm = 0; arm < 9; ++arm) {
        const double wt = w * std::pow(10.0, -6 + arm), g = 1.1e6 * std::pow(1.8, 4 - arm);
        storage += g * wt * wt / (1 + wt * wt);
        loss += g * wt / (1 + wt * wt);
      }
      text += QByteArray::number(temperature) + "," + QByteArray::number(frequency, 'g', 8) + "," +
              QByteArray::number(storage / 1e6, 'g', 8) + "," +
              QByteArray::number(loss / 1e6, 'g', 8) + "\n";
    }
  }
  return text;
}

/// Visits states one after the other.
class Visitor {
 public:
  Visitor(MainWindow& window, const DialogWishes& wishes, const StateVisit& visit)
      : window_(window), wishes_(wishes), visit_(visit) {}

  void visitAll() {
    group("surface", [this] { surfaces(); });
    group("moduli", [this] { moduli(); });
    group("friction", [this] { friction(); });
    group("fit", [this] { fit(); });
    group("map", [this] { map(); });
    group("export", [this] { exports(); });
    group("figures", [this] { figures(); });
    group("lesson", [this] { lessons(); });
    group("dialog", [this] { dialogs(); });
  }

 private:
  template <class Run>
  void group(const QString& name, Run run) {
    const auto concerns = [&](const QString& wanted) {
      return wanted.startsWith(name) || name.startsWith(wanted);
    };
    if (wishes_.only.isEmpty() || std::ranges::any_of(wishes_.only, concerns)) run();
  }
  bool isWanted(const QString& name) const {
    return wishes_.only.isEmpty() || std::ranges::any_of(wishes_.only, [&](const QString& wanted) {
             return name.startsWith(wanted) || wanted.startsWith(name);
           });
  }
  void show(const QString& name, QWidget& shown) {
    if (isWanted(name)) visit_(name, shown);
  }
  QString write(const QString& name, const QByteArray& text) {
    const QString path = folder_.filePath(name);
    QFile file(path);
    if (file.open(QIODevice::WriteOnly)) file.write(text);
    return path;
  }
  template <class Widget>
  static Widget& in(QWidget& parent, const QString& name) {
    auto* found = parent.findChild<Widget*>(name);
    if (!found) qFatal("there is no %s", qPrintable(name));
    return *found;
  }
  static void choose(QComboBox& box, const QString& data) {
    box.setCurrentIndex(box.findData(data));
    emit box.activated(box.currentIndex());
  }
  void fitScreen(QWidget& dialog) const {
    dialog.resize(dialog.size().boundedTo(wishes_.screen - kAround));
  }
  /// Closes a dialog; whatever it asks meanwhile is not answered.
  static void close(QWidget& dialog) {
    QPointer<QWidget> gone(&dialog);
    if (auto* page = qobject_cast<QDialog*>(&dialog)) page->reject();
    if (gone) gone->close();
    waitFor([&] { return !gone || !gone->isVisible(); }, "closing");
    delete gone.data();
  }
  /// Visits the next modal dialog once it is there, and closes it.
  void visitNext(const QString& name) {
    auto* timer = new QTimer(&window_);
    connectTo(*timer, [this, name, timer, tries = 0]() mutable {
      auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      const bool isThere = dialog && dialog->isVisible() && tries++ > 4;
      if (!isThere && tries < 1000) return;
      timer->stop();
      timer->deleteLater();
      if (!dialog) return;
      show(name, *dialog);
      dialog->reject();
    });
    timer->start(20);
  }
  template <class Act>
  static void connectTo(QTimer& timer, Act act) {
    QObject::connect(&timer, &QTimer::timeout, std::move(act));
  }

  // ---- Measured surfaces

  SurfaceImport& openSurface(const QString& file) {
    SurfaceImport& page = window_.imports().openSurface(file);
    fitScreen(page);
    settle(page, "surfaceSpectrum");
    return page;
  }
  static void settle(ImportPage& page, const char* view) {
    waitFor([&] { return !page.isReading(); }, "reading");
    const QList<DiagramView*> sheets = page.findChildren<DiagramView*>();
    const auto arePainted = [&] {
      return std::ranges::all_of(sheets, [](const DiagramView* each) { return each->isPainted(); });
    };
    if (page.isReady()) waitFor(arePainted, view);
  }
  void surface(const QString& name, const QString& file) {
    if (!isWanted(name)) return;
    SurfaceImport& page = openSurface(file);
    show(name, page);
    close(page);
  }
  void surfaces() {
    surface("surface_level", write("concrete 12.csv", profileText(0, ',', '.', "x (mm),z (um)\n")));
    const QString tilted = write("Prüfling 7 Längsschnitt.txt",
                                 profileText(1, ';', ',', "Taster 2 µm\nWeg [mm];Höhe [µm]\n"));
    surface("surface_trend", tilted);
    const QString field = write("field.xyz", fieldText());
    surface("surface_field", field);
    if (isWanted("surface_field_row")) {
      SurfaceImport& page = openSurface(field);
      auto& entry = in<ValueEntry>(page, "entry:surface.row");
      entry.setFocus();
      entry.selectAll();
      QTest::keyClicks(&entry, "12");
      QTest::keyClick(&entry, Qt::Key_Return);
      settle(page, "surfaceSpectrum");
      choose(in<QComboBox>(page, "choice:surface.line"), "isotropic_equivalent");
      settle(page, "surfaceSpectrum");
      choose(in<QComboBox>(page, "choice:surface.seam"), "blend");
      settle(page, "surfaceSpectrum");
      show("surface_field_row", page);
      close(page);
    }
    QByteArray steep = "x (mm);z (mm)\n", unitless;
    for (int i = 0; i < 500; ++i) {
      steep +=
          QByteArray::number(0.01 * i) + ";" + QByteArray::number(0.02 * ((i * 7919) % 13)) + "\n";
      unitless += QByteArray::number(i) + " " + QByteArray::number(100 * std::sin(0.3 * i)) + "\n";
    }
    if (isWanted("surface_notes")) {
      SurfaceImport& page = openSurface(write("grooves.csv", steep));
      choose(in<QComboBox>(page, "choice:surface.seam"), "periodic");
      settle(page, "surfaceSpectrum");
      show("surface_notes", page);
      close(page);
    }
    surface("surface_no_unit", write("scan.txt", unitless));
    surface("surface_empty", write("empty.csv", ""));
    surface("surface_wrong",
            write("minutes of the meeting.txt", "these are words and no numbers\n"));
    surface("surface_gone", folder_.filePath("gone.sdf"));
    for (const QString& file : wishes_.surfaces)
      surface("surface_of_" + QFileInfo(file).completeBaseName(), file);
    if (isWanted("surface_stopped")) {
      SurfaceImport& page = window_.imports().openSurface(tilted);
      fitScreen(page);
      show("surface_reading", page);
      QTest::mouseClick(&in<QAbstractButton>(page, "importStop"), Qt::LeftButton);
      show("surface_stopped", page);
      close(page);
    }
  }

  // ---- Measured moduli

  MaterialImport& openModuli(const QString& file) {
    MaterialImport& page = window_.imports().openModuli(file);
    fitScreen(page);
    settle(page, "dmaSheet");
    return page;
  }
  void moduliSheets(const QString& name, const QString& file) {
    if (!isWanted(name)) return;
    MaterialImport& page = openModuli(file);
    auto& sheets = in<QTabBar>(page, "dmaSheets");
    for (int i = 0; i < sheets.count(); ++i) {
      sheets.setCurrentIndex(i);
      settle(page, "dmaSheet");
      show(name + "_" + sheets.tabData(i).toString(), page);
    }
    show(name, page);
    close(page);
  }
  void moduli() {
    const QByteArray head = "Temp (C),f (Hz),E' (MPa),E'' (MPa)\n";
    moduliSheets("moduli_one", write("tread 20C.csv", isothermText({20}, head)));
    moduliSheets("moduli_many", wishes_.moduli.isEmpty()
                                    ? write("tread.csv", isothermText({5, 15, 25, 35, 45}, head))
                                    : wishes_.moduli);
    moduliSheets("moduli_unknown", write("tread 3.csv", isothermText({0, 20}, "A,B,C,D\n")));
    moduliSheets("moduli_apart", write("tread 4.csv", isothermText({0, 60}, head)));
    moduliSheets("moduli_empty", write("nothing.csv", ""));
    if (isWanted("moduli_refused")) {
      MaterialImport& page = openModuli(write("tread 20C.csv", isothermText({20}, head)));
      auto& entry = in<QLineEdit>(page, "dmaReference");
      entry.setFocus();
      QTest::keyClicks(&entry, "warm");
      QTest::keyClick(&entry, Qt::Key_Return);
      settle(page, "dmaSheet");
      show("moduli_refused", page);
      close(page);
    }
  }

  // ---- Measured friction and its fit

  QString frictionFile() {
    return write("Tread at 20 °C.csv",
                 "velocity (mm/s),mu,mu_error\n1,0.0006,0.0001\n10,0.0011,0.0001\n100,0.002,"
                 "0.0002\n1000,0.0027,0.0002\n10000,0.0019,0.0002\n");
  }
  void friction() {
    window_.document().open(sceneOfSize(256, 9, 3));
    window_.imports().openDropped(frictionFile());
    waitFor([&] { return !window_.document().scene().comparison.data.empty(); }, "friction");
    waitFor([&] { return window_.session().friction().progress() >= 1; }, "a curve");
    if (isWanted("friction_beside")) {
      QTest::qWait(400);
      show("friction_beside", window_);
    }
    if (isWanted("friction_wrong")) {
      window_.imports().openDropped(write("wrong.csv", "velocity (mm/s),mu\n1,high\n2,low\n"));
      waitFor([&] { return window_.messages().isVisible(); }, "a message");
      show("friction_wrong", window_);
      window_.messages().hide();
    }
  }
  void fit() {
    Scene scene = sceneOfSize(256, 9, 3);
    scene.comparison.data = {{frictionFile().toStdString(), {}}};
    window_.document().open(scene);
    FitPage& page = *window_.comparisons().openFit();
    fitScreen(page);
    show("fit_begin", page);
    auto& keys = in<QTableWidget>(page, "fitKeys");
    const auto rowOf = [&](const QString& key) {
      for (int row = 0; row < keys.rowCount(); ++row)
        if (keys.item(row, 0)->data(Qt::UserRole).toString() == key) return row;
      return 0;
    };
    keys.item(rowOf("surface.rms_height"), 2)->setText("high");
    show("fit_refused", page);
    keys.item(rowOf("surface.rms_height"), 2)->setText({});
    for (const char* key : {"surface.rms_height", "elastomer.relaxation_time"})
      keys.item(rowOf(key), 0)->setCheckState(Qt::Checked);
    in<QPushButton>(page, "fitRun").click();
    QTest::qWait(150);
    show("fit_running", page);
    waitFor([&] { return !page.isFitting(); }, "a fit");
    auto& sheets = in<QTabBar>(page, "fitSheets");
    auto& sheet = in<DiagramView>(page, "fitSheet");
    for (int i = 0; i < sheets.count(); ++i) {
      sheets.setCurrentIndex(i);
      QTest::qWait(50);
      waitFor([&] { return sheet.isPainted(); }, "a diagram");
      show(QStringLiteral("fit_sheet_%1").arg(i), page);
    }
    close(page);
    if (isWanted("fit_error")) {
      scene.comparison.data = {{folder_.filePath("gone.csv").toStdString(), {}}};
      window_.document().open(scene);
      FitPage& wrong = *window_.comparisons().openFit();
      fitScreen(wrong);
      in<QTableWidget>(wrong, "fitKeys").item(0, 0)->setCheckState(Qt::Checked);
      in<QPushButton>(wrong, "fitRun").click();
      waitFor([&] { return !wrong.isFitting(); }, "a fit");
      show("fit_error", wrong);
      close(wrong);
    }
  }

  // ---- The map

  void map() {
    Scene scene = sceneOfSize(256, 9, 3);
    scene.title = "Map";
    window_.document().open(scene);
    auto& tabs = in<QTabWidget>(window_, "tabs");
    auto& panel = in<MapPanel>(window_, "mapPanel");
    tabs.setCurrentWidget(&panel);
    const auto showMap = [&](const QString& name) {
      waitFor([&] { return panel.map() && panel.map()->isFinal; }, "a map");
      QTest::qWait(60);
      waitFor([&] { return panel.view().isPainted(); }, "the map's picture");
      if (panel.view().frames().size() > 0) {
        const QRectF& area = panel.view().frames().back().area;
        QTest::mouseMove(&panel.view(), QPoint(static_cast<int>(area.left() + 0.6 * area.width()),
                                               static_cast<int>(area.top() + 0.4 * area.height())));
        QTest::qWait(30);
      }
      show(name, wishes_.screen.width() > 0 && isWanted(name + "_window")
                     ? static_cast<QWidget&>(window_)
                     : panel);
    };
    showMap("map_usual");
    in<QComboBox>(window_, "mapY")
        .setCurrentIndex(in<QComboBox>(window_, "mapY").findData("surface.rms_height"));
    showMap("map_roughness");
    auto& quantity = in<QComboBox>(window_, "mapQuantity");
    quantity.setCurrentIndex(quantity.count() - 1);
    showMap("map_quantity");
    if (isWanted("map_save")) {
      visitNext("map_save");
      in<QPushButton>(window_, "mapSave").click();
    }
    quantity.setCurrentIndex(quantity.findData("mu"));
    tabs.setCurrentIndex(0);
  }

  // ---- Export

  void waitForPreview(ExportDialog& dialog) {
    const auto& note = in<QLabel>(dialog, "exportNote");
    waitFor([&] { return note.text() != ExportDialog::tr("The preview is being made…"); },
            "a preview");
  }
  void exportOf(const QString& name, ExportKind kind,
                const std::function<void(ExportDialog&)>& change = {}) {
    if (!isWanted(name)) return;
    window_.exports().setProgram(wishes_.program);
    ExportDialog& dialog = window_.exports().openDialog(kind);
    fitScreen(dialog);
    dialog.setFile(QDir(folder_.path()).filePath(QFileInfo(dialog.file()).fileName()));
    if (change) {
      waitForPreview(dialog);
      change(dialog);
    }
    waitForPreview(dialog);
    show(name, dialog);
    close(dialog);
  }
  void exports() {
    window_.document().open(sceneOfSize(256, 9, 3));
    waitFor([&] { return window_.session().friction().progress() >= 1; }, "a curve");
    window_.session().setPlaying(false);
    const auto set = [](const char* box, const QString& word) {
      return [box, word](ExportDialog& dialog) {
        auto& choice = in<QComboBox>(dialog, box);
        choice.setCurrentIndex(choice.findData(word));
      };
    };
    exportOf("export_picture", ExportKind::Picture);
    exportOf("export_paper", ExportKind::Picture, [&](ExportDialog& dialog) {
      set("exportContent", "both")(dialog);
      set("exportFormat", ".pdf")(dialog);
      set("exportPreset", "page")(dialog);
    });
    exportOf("export_transparent", ExportKind::Picture, [&](ExportDialog& dialog) {
      set("exportTheme", "print")(dialog);
      in<QCheckBox>(dialog, "exportTransparent").setChecked(true);
    });
    exportOf("export_style", ExportKind::Picture, [&](ExportDialog& dialog) {
      set("exportContent", "curve")(dialog);
      set("exportStyle", "journal")(dialog);
    });
    exportOf("export_film", ExportKind::Film);
    exportOf("export_frames", ExportKind::Film, set("exportFormat", ""));
    exportOf("export_table", ExportKind::Table);
    exportOf("export_contacts", ExportKind::Table, set("exportContent", "contacts"));
    if (wishes_.hasFigures) exportOf("export_figures", ExportKind::Figure);
    exportOf("export_refused", ExportKind::Picture, [](ExportDialog& dialog) {
      auto& width = in<QLineEdit>(dialog, "exportWidth");
      width.setFocus();
      width.selectAll();
      QTest::keyClicks(&width, "12");
    });
    if (isWanted("export_replace")) {
      ExportDialog& dialog = window_.exports().openDialog(ExportKind::Table);
      dialog.setFile(write("curve.csv", "an older one\n"));
      visitNext("export_replace");
      dialog.write();
      close(dialog);
    }
    if (isWanted("export_writing")) {
      ExportDialog& dialog = window_.exports().openDialog(ExportKind::Film);
      fitScreen(dialog);
      set("exportFormat", "")(dialog);
      waitForPreview(dialog);
      dialog.setFile(folder_.filePath("frames"));
      auto& duration = in<QLineEdit>(dialog, "exportDuration");
      duration.setFocus();
      duration.selectAll();
      QTest::keyClicks(&duration, "600");
      dialog.write();
      waitFor([&] { return in<QProgressBar>(dialog, "exportProgress").value() > 0; }, "a film");
      show("export_writing", dialog);
      dialog.reject();  // ends the writing
      show("export_cancelled", dialog);
      close(dialog);
    }
    window_.session().setPlaying(true);
  }

  // ---- Figures of the paper

  void figures() {
    window_.pages().openFigures();
    FiguresPage& page = window_.pages().figuresPage();
    show("figures_none", page);
    if (wishes_.hasFigures) {
      in<QSpinBox>(page, "realizations").setValue(3);
      for (const FigureEntry& entry : figureEntries()) {
        const QString name =
            "figures_" + QString::fromUtf8(entry.word.data(), std::ssize(entry.word));
        if (!isWanted(name)) continue;
        page.choose(entry.name, true);
        if (&entry == &figureEntries()[1]) {
          waitFor([&] { return page.queue().computing().has_value() || page.hasFigure(); },
                  "a figure");
          show("figures_computing", page);
        }
        waitFor([&] { return !page.queue().computing(); }, "a figure");
        waitFor([&] { return page.picture().isPainted(); }, "its picture");
        show(name, page);
        auto& claims = in<ClaimsTable>(page, "claims");
        if (claims.rowCount() == 0) continue;
        claims.selectRow(claims.rowCount() - 1);
        QTest::qWait(30);
        show(name + "_claim", page);
      }
      if (isWanted("figures_save")) {
        visitNext("figures_save_picture");
        in<QPushButton>(page, "savePicture").click();
        visitNext("figures_save_data");
        in<QPushButton>(page, "saveData").click();
      }
    }
    window_.pages().showViews();
  }

  // ---- Lessons

  /// Writes the results of a student who answered the first questions with the first choice, in a
  /// lesson whose questions are choices, numbers and points.
  QString resultsFile(const QString& name, const Lesson& lesson, int answered) {
    LessonResults results = emptyResults(lesson);
    results.date = "2026-11-27T10:00:00";
    for (int step = 0; step < static_cast<int>(lesson.steps.size()); ++step) {
      const LessonStep* asked = askingStep(lesson, step);
      if (!asked || answered-- <= 0) continue;
      LessonResult one;
      one.step = step;
      one.kind = asked->prediction->kind;
      if (one.kind == PredictionKind::Choice) one.given.choice = one.expected.choice = 0;
      if (one.kind != PredictionKind::Choice) one.given.number = one.expected.number.value = 3.67;
      if (one.kind == PredictionKind::Point) one.given.x = one.expected.x.value = 0.34;
      one.isRight = answered % 2 == 0;
      results.set(one);
    }
    const QString path = folder_.filePath(name);
    writeResults(path.toStdString(), results, lesson);
    return path;
  }
  void lessons() {
    Lessons& lessons = window_.lessons();
    const Lesson lesson = readNamedLesson("load_and_friction", readNamedScene);
    if (isWanted("lesson_list")) {
      LessonList& list = lessons.showList();
      fitScreen(list);
      show("lesson_list", list);
      in<QCheckBox>(list, "lessonNotes").click();
      show("lesson_list_computing", list);
      waitFor([&] { return in<QLabel>(list, "lessonAbout").text().contains("<b>"); }, "answers");
      show("lesson_list_notes", list);
      close(list);
    }
    LessonEditor& editor = lessons.showEditor(lesson, {});
    auto& steps = in<QListWidget>(editor, "editorSteps");
    auto& scroll = *in<QWidget>(editor, "editorQuestion").parentWidget();
    for (int row = 0; row < steps.count(); ++row) {
      steps.setCurrentRow(row);
      QTest::qWait(30);
      show(QStringLiteral("lesson_editor_%1").arg(row), editor);
      if (QScrollBar* bar = scrollBarOf(scroll); row > 0 && bar) bar->setValue(bar->maximum());
      QTest::qWait(30);
      if (row > 0) show(QStringLiteral("lesson_editor_%1_end").arg(row), editor);
    }
    in<QPushButton>(editor, "editorAdd").click();
    show("lesson_editor_added", editor);
    steps.setCurrentRow(2);
    in<QPlainTextEdit>(editor, "editorQuestion").clear();
    QTest::qWait(50);
    show("lesson_editor_refused", editor);
    visitNext("lesson_editor_unsaved");
    in<QPushButton>(editor, "editorClose").click();
    delete &editor;
    const QString broken =
        write("emil.json", "{\"schema\": \"asperity-lesson-results/1\", \"lesson\": \"lo");
    lessons.openResults({resultsFile("Anna Müller.json", lesson, 6),
                         resultsFile("ben.json", lesson, 2), resultsFile("dora.json", lesson, 4),
                         resultsFile("with a rather long name of its file.json", lesson, 5),
                         broken});
    for (const char* page : {"classResults", "lessonResults"}) {
      auto& dialog = in<QDialog>(window_, page);
      fitScreen(dialog);
      QTest::qWait(50);
      show(QStringLiteral("lesson_%1").arg(page), dialog);
      close(dialog);
      if (page == QLatin1String("classResults")) lessons.open(folder_.filePath("Anna Müller.json"));
    }
    lessons.openResults({broken});
    show("lesson_results_wrong", window_);
    window_.messages().hide();
    lessons.start(lesson, 1);
    in<QRadioButton>(window_, "lessonChoice:0").click();
    in<QPushButton>(window_, "lessonNext").click();
    waitFor([&] { return lessons.player().isRevealed(); }, "an answer");
    visitNext("lesson_unsaved");
    lessons.mayLeave();
    lessons.close();
  }
  /// Returns the bar by which a widget is scrolled down; null where it is in no area.
  static QScrollBar* scrollBarOf(QWidget& content) {
    for (QWidget* widget = &content; widget; widget = widget->parentWidget())
      if (auto* area = qobject_cast<QScrollArea*>(widget)) return area->verticalScrollBar();
    return nullptr;
  }

  // ---- Other dialogs

  void dialogs() {
    const auto open = [&](const QString& name, const char* action) {
      if (!isWanted(name)) return;
      QAction* command = window_.findChild<QAction*>(QLatin1String(action));
      if (!command) qFatal("there is no command %s", action);
      command->trigger();
      QDialog* dialog = nullptr;
      waitFor(
          [&] {
            for (QDialog* each : window_.findChildren<QDialog*>())
              if (each->isVisible()) dialog = each;
            return dialog != nullptr;
          },
          action);
      if (!dialog) return;
      fitScreen(*dialog);
      QTest::qWait(50);
      show(name, *dialog);
      close(*dialog);
    };
    open("dialog_about", "about");
    open("dialog_keys", "shortcuts");
    open("dialog_words", "describe");
    for (const auto& [name, action] : {std::pair{"dialog_open_surface", "openSurface"},
                                       {"dialog_open_material", "openMaterial"},
                                       {"dialog_open_friction", "openFriction"},
                                       {"dialog_save_scene", "saveAs"},
                                       {"dialog_save_picture", "savePicture"}}) {
      if (!isWanted(name)) continue;
      visitNext(name);
      window_.findChild<QAction*>(QLatin1String(action))->trigger();
    }
    if (isWanted("dialog_guide")) {
      window_.findChild<QAction*>("guide")->trigger();
      QTest::qWait(50);
      show("dialog_guide", window_);
      window_.messages().hide();
    }
  }

  MainWindow& window_;
  const DialogWishes& wishes_;
  const StateVisit& visit_;
  QTemporaryDir folder_;
};

}  // namespace

void visitDialogs(MainWindow& window, const DialogWishes& wishes, const StateVisit& visit) {
  Visitor(window, wishes, visit).visitAll();
}

}  // namespace asperity
