// All commands with their options, declared once: help, completions, the dictionary and parsing are
// made from them. Main thread.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "app/command_line.h"

namespace CLI {
class App;
}

namespace asperity {

class CommandTable {
 public:
  /// Adds all commands, and the options of the one that opens the window, to `app`, which must
  /// outlive the table. Where `word`, the first of the command line, names a command, it is the
  /// only one: declaring all takes longer than many a command runs. remake: what `open --remake`
  /// does.
  void declareIn(CLI::App& app, std::string_view word,
                 std::function<int(const OpenCommand&)> remake);

  /// Returns the options that every command takes, for each of them.
  const std::vector<CommonOptions*>& common() const { return common_; }

  /// Runs the command that was parsed, or opens the window where none was. Returns its status.
  int run() const;

 private:
  void addShared(CLI::App& app, CommonOptions& common, const char* defaultLanguage = "en");
  void addSharedWithoutScene(CLI::App& app, CommonOptions& common,
                             const char* defaultLanguage = "en");
  CLI::App* addCommand(const char* name, const char* sentence, std::function<int()> action);
  CLI::App* addSceneCommand(const char* name, const char* sentence, CommonOptions& common,
                            std::function<int()> action);
  void addCheck(const char* name);
  void addCurve(const char* name);
  void addMap(const char* name);
  void addSensitivity(const char* name);
  void addCutoff(const char* name);
  void addMotion(const char* name);
  void addRender(const char* name);
  void addSurface(const char* name);
  void addFit(const char* name);
  void addMaterial(const char* name);
  void addFigure(const char* name);
  void addOpen(const char* name);
  void addBatch(const char* name);
  void addStudy(const char* name);
  void addAccuracy(const char* name);
  void addExplain(const char* name);
  void addColumns(const char* name);
  void addLesson(const char* name);

  CLI::App* app_ = nullptr;
  std::function<int(const OpenCommand&)> remake_;
  std::vector<CommonOptions*> common_;
  CommonOptions window_, columns_;
  CheckCommand check_;
  LessonCommand lesson_;
  CurveCommand curve_;
  MapCommand map_;
  TableCommand sensitivity_, cutoff_;
  MotionCommand motion_;
  RenderCommand render_;
  SurfaceCommand surface_;
  MaterialCommand material_;
  FitCommand fit_;
  FigureCommand figure_;
  OpenCommand open_;
  BatchCommand batch_;
  StudyCommand studyRun_, studyMerge_, studyTable_, studyShow_, studyAnalyse_;
  FolderCommand accuracy_;
  ExplainCommand explain_;
  std::function<int()> selected_;  // runs the command that was parsed
};

}  // namespace asperity
