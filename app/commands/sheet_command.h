// The common part of commands whose answer is one table and one sheet of diagrams. Main thread.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/command_line.h"
#include "core/chart/diagram.h"

namespace asperity {

/// An answer in all its forms, with the options of tables in `origin` and `json`. `csv` lacks the
/// line with its provenance.
struct SheetAnswer {
  nlohmann::ordered_json origin;  // provenance
  std::string csv, json;
  std::string printed;  // without output files; empty: the CSV
  DiagramSheet sheet;
};

/// Checks the names of the output files and the options of pictures before any work. Throws
/// InputError.
PictureSettings checkSheetOutputs(const SheetCommand& command, const Scene& scene,
                                  const PictureDefaults& defaults);

/// Writes the files, or prints the answer where there are none.
void writeAnswer(const SheetCommand& command, const PictureSettings& settings,
                 const SheetAnswer& answer);

}  // namespace asperity
