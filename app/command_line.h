// The command line: the commands as plain values, and their parsing. Each command has one file in
// app/commands/. Main thread.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/command_options.h"
#include "app/curve_options.h"
#include "app/picture_options.h"
#include "app/pictures/frame_source.h"
#include "app/result_files.h"
#include "core/material/material_options.h"

namespace asperity {

/// Exit statuses of the program; after SIGINT and SIGTERM: 128 plus the number of the signal.
inline constexpr int kDone = 0, kRunFailed = 1, kBadInput = 2, kInterrupted = 130,
                     kTerminated = 143;

struct CurveCommand : TableCommand {
  CurveArguments curves;
  std::string realizationTable;  // file; empty: none
};

struct MapCommand : TableCommand {
  std::string x, y;  // KEY=FROM:TO:N
  std::string quantity = "mu";
};

struct MotionCommand : TableCommand {
  std::int64_t every = 1;  // time steps between two rows
  std::int64_t lines = 1;  // realizations
};

struct RenderCommand {
  CommonOptions common;
  std::string output;
  TimeArguments time;
  PictureArguments picture;
  std::string layout = "contact";
  std::string overlay;  // empty: not given, which means pressure
  ViewArguments view;
  CurveArguments curves;
  bool resume = false;
  std::string table;    // --table; empty: shape, where the output is a table
  std::string columns;  // --columns; empty: all
};

struct SurfaceCommand : TableCommand {
  std::string table = "line";  // of a CSV: line, spectrum or statistics
};

struct FitCommand : FolderCommand {
  std::vector<std::string> data;    // files, beside those that the scene names
  std::vector<std::string> varied;  // KEY or KEY=LOW:HIGH
  bool withoutProfiles = false;
};

/// Its scene is a table of moduli, or a scene.
struct MaterialCommand : FolderCommand {
  WrittenOptions options;  // of reading and fitting
};

/// The actions of `asperity study`; each uses some of the members.
struct StudyCommand {
  CommonOptions common;
  std::string study;                 // file of the study, or its store
  std::vector<std::string> stores;   // to be merged
  std::string output;                // store, or folder
  std::vector<std::string> outputs;  // tables
  std::string shard;                 // I/N; empty: all of the study
  std::string shape = "wide";
  bool plan = false;
  bool allowsFailures = false;  // of simulations, so that a run with some of them succeeds
  PictureArguments picture;
};

/// It has no scene; its assignments change the parameters of the paper.
struct FigureCommand : FolderCommand {
  std::vector<std::string> names;
  std::int64_t realizations = 200;
};

struct ExplainCommand {
  CommonOptions common;
  bool analyze = false;
  std::string x, y;  // axes of a map whose cost is estimated: KEY=FROM:TO:N; empty: no map
};

struct OpenCommand {
  CommonOptions common;             // the scene is read from any file that contains one
  bool remakes = false;             // the file itself, instead of opening the window
  std::string output;               // of a remade file; empty: the file itself
  std::string from;                 // folder of its inputs, or store; empty: is looked for
  std::vector<std::string> others;  // options of the command that made the file
};

struct LessonCommand {
  CommonOptions common;  // its scene is not used
  /// The name or file of a lesson, or files and folders of results; empty: lists all lessons.
  std::vector<std::string> lessons;
  std::vector<std::string> outputs;
  bool forTeacher = false;
};

struct CheckCommand {
  CommonOptions common;
  std::vector<std::string> scenes;
};

/// Its scene is the file of the batch.
struct BatchCommand : FolderCommand {
  bool contactSheet = false;
};

int runCheck(const CheckCommand& command);
int runCurve(const CurveCommand& command);
int runMap(const MapCommand& command);
int runSensitivity(const TableCommand& command);
int runCutoff(const TableCommand& command);
int runMotion(const MotionCommand& command);
int runColumns(const CommonOptions& command);
int runFit(const FitCommand& command);
int runMaterial(const MaterialCommand& command);
int runRender(const RenderCommand& command);
/// Writes a table of the contact; part of `render`.
int runContactTable(const RenderCommand& command);
int runSurface(const SurfaceCommand& command);
int runExplain(const ExplainCommand& command);
int runAccuracy(const FolderCommand& command);
int runFigure(const FigureCommand& command);
/// Opens the window; an empty scene means the default one.
int runWindowCommand(const CommonOptions& command);
int runBatch(const BatchCommand& command);
int runStudyRun(const StudyCommand& command);
int runStudyMerge(const StudyCommand& command);
int runStudyTable(const StudyCommand& command);
int runStudyShow(const StudyCommand& command);
int runStudyAnalyse(const StudyCommand& command);
int runOpen(const OpenCommand& command);
int runLesson(const LessonCommand& command);

/// Parses and runs the command line. Returns the exit status. Throws InputError, or
/// std::runtime_error where the run failed.
int runCommandLine(int argc, char** argv);

}  // namespace asperity
