// A folder of results: texts and charts that a command writes together. Main thread.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/command_options.h"
#include "app/picture_options.h"
#include "core/chart/diagram.h"

namespace asperity {

class OutputFolder {
 public:
  /// inputs: files that the command reads and may not replace. `settings` must outlive it.
  OutputFolder(std::string folder, std::vector<std::filesystem::path> inputs,
               const PictureSettings& settings);

  void addText(const std::string& name, std::string bytes);
  /// Adds a chart that is written as NAME.png, NAME.svg and NAME.pdf.
  void addSheet(const std::string& name, DiagramSheet sheet);

  /// Writes all files. All contents are known by now, so that the folder has only complete files.
  /// The first text, which describes the others, is written last. origin: makes the provenance of a
  /// picture from the given options and the picture's name.
  void write(const std::vector<GivenOption>& given,
             const std::function<nlohmann::ordered_json()>& origin) const;
  /// Returns one line for each file.
  std::string summary() const;

 private:
  struct Text {
    std::string file, bytes;
  };
  struct Sheet {
    std::string name;
    DiagramSheet sheet;
  };
  std::string filePath(const std::string& name) const;
  void checkName(const std::string& name) const;

  std::string folder_;
  std::vector<std::filesystem::path> inputs_;
  const PictureSettings& settings_;
  std::vector<Text> texts_;
  std::vector<Sheet> sheets_;
};

}  // namespace asperity
