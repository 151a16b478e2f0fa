// The main window: contact view above, friction diagram below it, parameters at the right, bars for
// commands and facts; or the page of the paper's figures in the place of the views. Everything
// shown about a state comes from the frame; the controls only post scenes. Owns its Session. GUI
// thread. Failure: complaints appear in a bar over the views and the window goes on.
#pragma once

#include <QElapsedTimer>
#include <QFont>
#include <QMainWindow>
#include <QPointer>
#include <QSize>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

#include "core/run/runner.h"
#include "ui/contact/contact_picture.h"
#include "ui/window/main/icons.h"
#include "ui/window/main/message_bar.h"

class QMenu;
class QSplitter;
class QStackedWidget;
class QTabWidget;
class QTimer;
class QToolBar;

namespace asperity {

class AccuracyPanel;
class ContactCanvas;
class CurveCommands;
class DiagramView;
class FigureGallery;
class GalleryPage;
class GestureCounter;
class LatestWork;
class ParameterPanel;
class PlanList;
class ChartView;
class SceneDocument;
class Session;
class StatusLine;
struct ContactShot;
struct CurveWish;
struct FoundScene;
struct SceneOrigin;
class TourBar;
class WindowSight;

enum class Colours { System, Light, Dark };

/// Said outright: otherwise what the contents need for a moment, in large letters or under a
/// comparison, would push the window over the edge of the screen for good.
inline constexpr QSize kLeastWindow{900, 560};

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(const Scene& scene, RunnerOptions options = {}, QWidget* parent = nullptr);
  ~MainWindow() override;

  Session& session() { return *session_; }
  ParameterPanel& panel() { return *panel_; }
  ChartView& plotView() { return *plot_; }
  CurveCommands& curveCommands() { return *curveCommands_; }
  ContactCanvas& canvas() { return *canvas_; }
  MessageBar& messages() { return *messages_; }
  MessageBar& description() { return *description_; }
  /// Made when it is first asked for.
  GalleryPage& gallery();

  /// Another scene for controls and runner: a fresh document without a history. Asks nothing.
  void showScene(const Scene& scene);
  void showScene(const SceneOrigin& origin);

  /// The next step of the present scene, for whatever lets a person change it outside of the panel
  /// of parameters; can be undone. Steps within one drag are one. `what` names it in the menu,
  /// a source text of this class; null: after the parameters that differ.
  void editScene(const Scene& scene, const char* what = nullptr);
  SceneDocument& document() { return *document_; }

  /// Reads a scene file, or any file that the program wrote from one, in the background, and shows
  /// its scene as showFound() does; the newest call wins. sceneRead() follows; where the file does
  /// not read, with the reason in the message bar.
  void openScene(const QString& file);
  /// Shows a scene that was read from a file. Asks first where it comes out of a picture, film or
  /// table and would read a file elsewhere, or take very much memory or time.
  void showFound(const QString& file, const FoundScene& found);
  /// False, with the reason in the message bar, where the file cannot be written.
  bool saveScene(const QString& file);

  /// The contact as it is shown, with its title, as .png, .svg or .pdf. In the background;
  /// exported() or a complaint in the message bar follows.
  void savePicture(const QString& file);

  /// The page of the paper's figures in the place of the views, and back. What it computes goes on
  /// meanwhile.
  void openFigures();
  void closeFigures();
  bool isShowingFigures() const;

  /// All words in another language, at once; scene, history, runs, curves and layout go on. An
  /// unknown code changes nothing. Not from within a menu's own action: the menus go.
  void setLanguage(std::string_view code);

  void setDark(bool dark);
  bool isDark() const { return dark_; }

  /// As the desktop has them, or always light or dark.
  void setColours(Colours colours);
  Colours colours() const { return colours_; }

  /// Size, docks, tabs and colours as they were when the last window was closed, as far as the
  /// screen has room for them, and from now on this window leaves its own behind. Call before it is
  /// shown.
  void rememberLayout();
  void restoreDefaultLayout();
  /// All of it lies on its screen, as does what a maximized or full window goes back to. Call
  /// before it is shown.
  void fitToScreen();

  /// Six scenes with a sentence each; and a small hint at it, until it was taken or put away.
  void startTour();
  void offerTour();
  bool isTouring() const { return isTouring_; }

  /// For an audience: the whole screen, large texts, contact and curve alone; Escape leaves.
  void setPresenting(bool presenting);
  bool isPresenting() const { return presentation_.has_value(); }

 signals:
  /// A file that was to be opened was read, and its scene is shown or not.
  void sceneRead(const QString& file, bool isShown);
  /// A picture is on the clipboard (empty) or in this file.
  void exported(const QString& file);

 protected:
  /// A scene, or a picture or table made from one, dropped on the window is opened.
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  void putTogether();
  void buildViews();
  void buildPanel();
  void connectSession();
  void followSight();
  void showFrame();
  void showComplaint();
  void endFailure(MessageBar::Failure of);
  void showDescription();
  void showTitle();
  QString nameOfScene() const;

  // Commands, in main_window_actions.cpp.
  void buildActions();
  QAction* addCommand(const char* name, const QString& text, const QKeySequence& key, Symbol symbol,
                      std::function<void()> run);
  void buildMenus();
  void adoptActions(QMenu& menu);
  void buildToolBar();
  void fillScenes(QMenu& menu);
  void showPlaying(bool playing);
  void paintIcons();

  // In main_window_help.cpp.
  void buildHelpCommands();
  void fillHelp(QMenu& menu);
  void showTourStep(int step);
  void showTourBar(int step);
  void endTour();
  void showShortcuts();
  void showAbout();

  // In main_window_files.cpp.
  void buildFileCommands();
  void fillFiles(QMenu& menu);
  void fillRecent();
  void askOpen();
  bool mayShowFound(const QString& file, const FoundScene& found);
  bool save();
  bool askSave();

  // In main_window_document.cpp: history, and what is not saved yet.
  void connectDocument();
  void buildEditCommands();
  void fillEdit(QMenu& menu);
  void showHistory();
  void takeStep(const Scene& scene);
  void resetAll();
  bool mayLeaveScene();
  void replaceScene(const SceneOrigin& origin);

  // In main_window_layout.cpp: docks, tabs, full screen, colours.
  void buildLayoutCommands();
  void fillLayout(QMenu& menu);
  void fillTabs(QMenu& menu);
  void fillColours(QMenu& menu);
  void showTab(int index);
  void beginPresentation();
  void endPresentation();
  void setFullScreen(bool full);
  void leaveFullScreen();
  void showScreenMode();
  void saveLayout();

  // In main_window_copy.cpp: what leaves the window.
  void buildCopyCommands();
  std::optional<ContactShot> shot() const;
  void showExports();
  void copyPicture();
  void askPicture();
  CurveWish shownCurves() const;
  QString pictureCommand() const;
  void copyText(const QString& text);
  void runExport(std::function<void()> work, std::function<void()> done);

  // In main_window_tabs.cpp.
  QTabWidget* buildTabs();
  void showAboutScene();
  void showMeasuredCurve();
  struct Measured {
    double seconds, standardError, interval;
  };
  void showMeasured(const Measured& measured);

  // In main_window_status.cpp: the facts below.
  void buildStatus();
  void showWork();

  // In main_window_view.cpp: the contact's commands and facts.
  void buildViewCommands(QMenu& menu);
  void connectView();
  void wantFields();
  double partPerStep() const;

  // In main_window_chart.cpp: the friction curve's.
  void buildChartCommands(QMenu& menu);
  void connectChart();

  // In main_window_figures.cpp.
  void buildFigures();
  void makeGallery(std::unique_ptr<FigureGallery> figures);
  void fillFigures(QMenu& menu);

  // In main_window_language.cpp.
  struct Arrangement;
  Arrangement arrangementNow();
  void takeApart();
  void arrange(Arrangement arrangement);

  Session* session_ = nullptr;
  QTimer* poll_ = nullptr;
  WindowSight* sight_ = nullptr;
  SceneDocument* document_ = nullptr;
  GestureCounter* gestures_ = nullptr;
  ContactCanvas* canvas_ = nullptr;
  QObject* parts_ = nullptr;  // owns what is no widget and has words or serves what has
  ChartView* plot_ = nullptr;
  ParameterPanel* panel_ = nullptr;
  QTabWidget* tabs_ = nullptr;  // under the contact
  ChartView* strips_ = nullptr;
  DiagramView *spectrum_ = nullptr, *statistics_ = nullptr;
  PlanList* plan_ = nullptr;
  AccuracyPanel* accuracy_ = nullptr;
  std::optional<Scene> timed_;                            // whose curve is timed
  QElapsedTimer curveTime_;                               // since it was wanted; invalid once there
  std::optional<Measured> measured_;                      // of the present curve
  std::optional<std::pair<QString, QString>> complaint_;  // of the scene: key and text of core
  MessageBar* messages_ = nullptr;
  MessageBar* description_ = nullptr;  // what to look for in the scene that was opened
  std::optional<QString> described_;   // and what it said last
  MessageBar* hint_ = nullptr;         // at the tour
  TourBar* tourBar_ = nullptr;
  bool isTouring_ = false;
  StatusLine* status_ = nullptr;
  QSplitter* splitter_ = nullptr;
  QStackedWidget* pages_ = nullptr;  // the views, and the figures
  GalleryPage* gallery_ = nullptr;
  QDockWidget* dock_ = nullptr;
  QToolBar* tools_ = nullptr;
  CurveCommands* curveCommands_ = nullptr;
  QAction *play_ = nullptr, *step_ = nullptr, *reset_ = nullptr;
  QAction *open_ = nullptr, *save_ = nullptr, *saveAs_ = nullptr, *light_ = nullptr;
  QAction *undo_ = nullptr, *redo_ = nullptr, *revert_ = nullptr, *resetAll_ = nullptr;
  QAction *copyPicture_ = nullptr, *savePicture_ = nullptr;
  QAction *copyRender_ = nullptr, *copyCurve_ = nullptr;
  QAction *fullScreen_ = nullptr, *present_ = nullptr, *leave_ = nullptr;
  QAction* restoreLayout_ = nullptr;
  QAction *tour_ = nullptr, *tourBack_ = nullptr, *tourNext_ = nullptr;
  QAction *shortcuts_ = nullptr, *about_ = nullptr;
  QList<QAction*> tabActions_, colourActions_;
  QMenu* recent_ = nullptr;
  QAction* figures_ = nullptr;
  QMenu* scenes_ = nullptr;
  bool dark_ = false;
  Colours colours_ = Colours::System;
  bool remembers_ = false;
  QByteArray defaultLayout_;
  /// What comes back when the presentation ends.
  struct Presentation {
    QFont font;
    QByteArray geometry, docks;
    QSize dock;
    QList<std::pair<QPointer<QSplitter>, QByteArray>> splits;
    bool hasStatus;
  };
  std::optional<Presentation> presentation_;
  bool hadDock_ = true, hadStatus_ = true;  // before the figures were opened
  std::uint64_t openings_ = 0;          // of scenes: what was read for an earlier one is dropped
  std::unique_ptr<LatestWork> reader_;  // of files that are opened
  std::jthread export_;                 // last: ends before anything else here goes
};

}  // namespace asperity
