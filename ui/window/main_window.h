// The main window: contact view above, friction diagram below it, parameters at the right, bars for
// commands and facts; or the page of the paper's figures in the place of the views. Everything
// shown about a state comes from the frame; the controls only post scenes. Owns its Session. GUI
// thread. Failure: complaints appear in a bar over the views and the window goes on.
#pragma once

#include <QElapsedTimer>
#include <QMainWindow>
#include <functional>

#include "core/run/runner.h"
#include "ui/picture/contact_picture.h"
#include "ui/window/icons.h"

class QMenu;
class QStackedWidget;
class QTabWidget;
class QTimer;

namespace asperity {

class AccuracyPanel;
class ContactCanvas;
class GalleryPage;
class MessageBar;
class ParameterPanel;
class PlanList;
class PlotView;
class Session;
class StatusLine;
class TransientStrips;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(const Scene& scene, RunnerOptions options = {}, QWidget* parent = nullptr);
  ~MainWindow() override;

  Session& session() { return *session_; }
  ParameterPanel& panel() { return *panel_; }
  PlotView& plotView() { return *plot_; }
  ContactCanvas& canvas() { return *canvas_; }
  MessageBar& messages() { return *messages_; }
  MessageBar& description() { return *description_; }
  GalleryPage& gallery() { return *gallery_; }

  /// Another scene for controls and runner.
  void showScene(const Scene& scene);

  /// A scene file, or any file that the program wrote from one. False, with the reason in the
  /// message bar, where the file does not read or write.
  bool openScene(const QString& file);
  bool saveScene(const QString& file);

  /// The page of the paper's figures in the place of the views, and back. What it computes goes on
  /// meanwhile.
  void openFigures();
  void closeFigures();
  bool isShowingFigures() const;

  void setDark(bool dark);
  bool isDark() const { return dark_; }

 protected:
  /// A scene, or a picture or table made from one, dropped on the window is opened.
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void buildViews();
  void buildPanel();
  void connectSession();
  void showDescription();
  void showTitle();

  // Commands, in main_window_actions.cpp.
  void buildActions();
  QAction* addCommand(const char* name, const QString& text, const QKeySequence& key, Symbol symbol,
                      std::function<void()> run);
  void buildMenus();
  void buildToolBar();
  void fillScenes(QMenu& menu);
  void showPlaying(bool playing);
  void paintIcons();
  void showAbout();

  // In main_window_files.cpp.
  void askOpen();
  void askSave();

  // In main_window_tabs.cpp.
  QTabWidget* buildTabs();
  void showAboutScene();
  void showMeasuredCurve();

  // In main_window_view.cpp: the contact's commands and facts.
  void buildViewCommands(QMenu& menu);
  void connectView();

  // In main_window_chart.cpp: the friction curve's.
  void buildChartCommands(QMenu& menu);
  void connectChart();
  void showPlotSoon();
  void showPlot();

  // In main_window_figures.cpp.
  void buildFigures();
  void fillFigures(QMenu& menu);

  Session* session_ = nullptr;
  ContactCanvas* canvas_ = nullptr;
  PlotView* plot_ = nullptr;
  ParameterPanel* panel_ = nullptr;
  QTabWidget* tabs_ = nullptr;  // under the contact
  TransientStrips* strips_ = nullptr;
  PlanList* plan_ = nullptr;
  AccuracyPanel* accuracy_ = nullptr;
  QElapsedTimer curveTime_;  // since the present curve was wanted
  MessageBar* messages_ = nullptr;
  MessageBar* description_ = nullptr;  // what to look for in the scene that was opened
  StatusLine* status_ = nullptr;
  QStackedWidget* pages_ = nullptr;  // the views, and the figures
  GalleryPage* gallery_ = nullptr;
  QDockWidget* dock_ = nullptr;
  QTimer* plotPause_ = nullptr;  // runs after the diagram was painted
  bool plotIsDue_ = false;       // and something came meanwhile
  QAction *play_ = nullptr, *step_ = nullptr, *reset_ = nullptr;
  QAction *open_ = nullptr, *save_ = nullptr, *light_ = nullptr;
  QAction* figures_ = nullptr;
  QMenu* scenes_ = nullptr;
  QString file_;  // last opened or saved
  bool dark_ = false;
  bool hadDock_ = true;  // before the figures were opened
};

}  // namespace asperity
