// The files of a result: one table with one chart, in each form that the outputs of a command ask
// for, or a folder of texts and charts. Main thread.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/command_options.h"
#include "app/picture_options.h"
#include "core/chart/diagram.h"
#include "core/scene/data_table.h"

namespace asperity {

/// What every command that makes one table and one chart is given.
struct TableCommand {
  CommonOptions common;
  std::vector<std::string> outputs;
  PictureArguments picture;
  std::string columns;  // --columns; empty: all
};

/// What every command that fills a folder is given.
struct FolderCommand {
  CommonOptions common;
  std::string output;
  PictureArguments picture;
  std::string columns;  // --columns; empty: all
};

/// A file that a command writes beside its outputs.
struct OtherFile {
  std::string name;
  std::function<void()> write;
};

/// A result that is one table and one chart. Its forms are made when a file needs them, while the
/// options of this file are those of each provenance (ProvenanceOptions).
struct TableResult {
  std::function<std::string()> csv, json;  // with their provenance
  std::function<DiagramSheet()> sheet;
  std::function<nlohmann::ordered_json()> origin;  // provenance of the chart
  /// What the provenance of the chart says of the picture beyond its settings.
  nlohmann::ordered_json picture = nlohmann::ordered_json::object();
  float minTextSize = 0;                // of the chart, as in DiagramOptions
  std::string summary{};                // lines before those that name the files
  std::vector<Message> reading{};       // of the surface, for the summary and the JSON
  std::string printed{};                // where there are no files; empty: the CSV
  std::vector<OtherFile> otherFiles{};  // written before the outputs
};

/// Returns an answer in JSON whose "points" have the chosen columns alone.
std::string withColumns(const std::string& json, const ColumnChoice& columns);

/// Checks the names of the output files and the options of pictures before any work. Throws
/// InputError.
PictureSettings checkTableOutputs(const TableCommand& command, const Scene& scene);

/// Writes the files and a summary; prints the table where there are no files, and for `-`.
void writeResult(const TableCommand& command, const PictureSettings& settings,
                 const TableResult& result);

/// A folder of texts and charts that a command writes together.
class OutputFolder {
 public:
  /// Make this object before any work. It creates no folder. Throws InputError where nothing could
  /// be written into the folder. inputs: files that the command reads and may not replace.
  /// `settings` must outlive it.
  OutputFolder(std::string folder, std::vector<std::filesystem::path> inputs,
               const PictureSettings& settings);

  void addText(const std::string& name, std::string bytes);
  /// Adds a chart that is written as NAME.png, NAME.svg and NAME.pdf.
  void addSheet(NamedSheet sheet) { sheets_.push_back(std::move(sheet)); }

  /// States charts that other runs of the command make: the summary names those that an earlier run
  /// has left in the folder and this one does not replace.
  void setOtherSheets(std::vector<std::string> names) { others_ = std::move(names); }

  /// Writes all files. All contents are known by now, so that the folder has only complete files.
  /// The first text, which describes the others, is written last. origin: makes the provenance of a
  /// picture from the given options and the picture's name.
  void write(const std::vector<GivenOption>& given,
             const std::function<nlohmann::ordered_json()>& origin) const;
  /// Returns one line for each file, and for each one that an earlier run has left.
  std::string summary() const;

 private:
  struct Text {
    std::string file, bytes;
  };
  void checkName(const std::string& name) const;

  std::string folder_;
  std::vector<std::filesystem::path> inputs_;
  const PictureSettings& settings_;
  std::vector<Text> texts_;
  std::vector<NamedSheet> sheets_;
  std::vector<std::string> others_;
};

}  // namespace asperity
