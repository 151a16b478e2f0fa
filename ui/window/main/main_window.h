// The main window: contact view above, friction diagram below it, parameters at the right, bars for
// commands and readings; or, instead of the views, the page of the paper's figures or the gallery
// of scenes. It makes the parts, each of which has its own header, and connects them: the document
// holds the scene, the session runs it, and everything shown about a state comes from the session's
// frame. GUI thread. Failure: messages appear in a bar over the views and the window stays usable.
#pragma once

#include <QMainWindow>
#include <optional>
#include <string>
#include <string_view>

#include "core/run/runner.h"
#include "core/scene/scene.h"

class QDockWidget;
class QSplitter;

namespace asperity {

class Appearance;
class Commands;
class ComparisonCommands;
class ContactCanvas;
class CurveCommands;
class DocumentCommands;
class Exports;
class WindowPages;
class FrameDisplay;
class HelpCommands;
class ImportCommands;
class Lessons;
class MessageBar;
class ParameterPanel;
class ChartView;
class SceneDocument;
class SceneTabs;
class Session;
class StatusLine;
class Tour;
class TimeBar;
class TourBar;
class WindowLayout;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(const Scene& scene, RunnerOptions options = {}, QWidget* parent = nullptr);
  ~MainWindow() override;

  SceneDocument& document() { return *document_; }              // the scene and its history
  DocumentCommands& documentCommands() { return *documents_; }  // files, undo, unsaved changes
  ImportCommands& imports() { return *imports_; }  // of measured surfaces and materials
  Session& session() { return *session_; }         // the running scene
  ParameterPanel& panel() { return *panel_; }
  ContactCanvas& canvas() { return *canvas_; }
  SceneTabs& tabs() { return *tabs_; }  // under the contact
  ChartView& plotView();
  CurveCommands& curveCommands() { return *curveCommands_; }
  ComparisonCommands& comparisons() { return *comparisons_; }  // theories, measured friction, fits
  WindowPages& pages() { return *pages_; }  // the views, or another page over them
  Exports& exports() { return *exports_; }
  MessageBar& messages() { return *messages_; }
  StatusLine& status() { return *status_; }
  MessageBar& description() { return *description_; }  // of the scene that was opened
  Tour& tour() { return *tour_; }
  Lessons& lessons() { return *lessons_; }
  Appearance& appearance() { return *appearance_; }
  WindowLayout& windowLayout() { return *windowLayout_; }

  /// Shows the gallery of scenes instead of the views.
  void openGallery();
  /// Opens the shipped scene of this name; an unknown name changes nothing.
  void openShipped(const QString& name);

  /// Changes the language of all texts at once: Qt informs every part (QEvent::LanguageChange),
  /// which sets its own texts; nothing else changes. An unknown code changes nothing.
  void setLanguage(std::string_view code);

 protected:
  /// These handlers open a dropped file: a scene, a picture or table made from one, a measured
  /// surface or a material.
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  void buildViews();
  void addRunCommands();
  void buildCommands();
  void connectScene();
  void connectFrames();
  void connectCurve();
  void connectTime();
  void requestFields();
  void showScene(const Scene& scene, bool isOpened);
  void showDescription();
  void showTitle();
  void step(bool finely);

  Session* session_;
  SceneDocument* document_;
  ContactCanvas* canvas_;
  TimeBar* timeBar_ = nullptr;
  SceneTabs* tabs_ = nullptr;
  QSplitter* splitter_ = nullptr;
  WindowPages* pages_ = nullptr;
  MessageBar *messages_ = nullptr, *hint_ = nullptr, *description_ = nullptr;
  TourBar* tourBar_ = nullptr;
  StatusLine* status_ = nullptr;
  FrameDisplay* frames_ = nullptr;
  ParameterPanel* panel_ = nullptr;
  QDockWidget* dock_ = nullptr;
  Commands* commands_ = nullptr;
  Appearance* appearance_ = nullptr;
  DocumentCommands* documents_ = nullptr;
  ImportCommands* imports_ = nullptr;
  Exports* exports_ = nullptr;
  CurveCommands* curveCommands_ = nullptr;
  ComparisonCommands* comparisons_ = nullptr;
  WindowLayout* windowLayout_ = nullptr;
  HelpCommands* help_ = nullptr;
  Tour* tour_ = nullptr;
  Lessons* lessons_ = nullptr;
  bool wasPlaying_ = false;               // before the slider of time was dragged
  std::optional<std::string> described_;  // the last text in the description bar
};

}  // namespace asperity
