#include "app/commands/sheet_command.h"

#include <fmt/format.h>

#include "app/output.h"
#include "app/pictures/headless_pictures.h"
#include "core/base/atomic_file.h"
#include "core/scene/provenance.h"
#include "ui/chart/diagram_picture.h"
#include "ui/language/translated.h"

namespace asperity {

PictureSettings checkSheetOutputs(const SheetCommand& command, const Scene& scene,
                                  const PictureDefaults& defaults) {
  checkOutputs(command.outputs, kOutputExtensions, DefaultOutput::PrintsTable);
  for (const std::string& output : command.outputs)
    checkNoInput(output, inputFiles(command.common, scene));
  checkUseful(command.picture, command.outputs);
  return pictureSettings(command.picture, defaults);
}

void writeAnswer(const SheetCommand& command, const PictureSettings& settings,
                 const SheetAnswer& answer) {
  HeadlessPictures pictures(settings.backend);
  std::string text;
  for (const std::string& output : command.outputs) {
    const std::string extension = fileExtension(output);
    if (extension == ".csv") {
      writeFileAtomically(output,
                          "# asperity: " + provenanceLine(answer.origin) + "\n" + answer.csv);
    } else if (extension == ".json") {
      writeFileAtomically(output, answer.json);
    } else if (output == "-") {
      continue;
    } else {
      nlohmann::ordered_json origin = answer.origin;
      origin["options"] = optionsFor(command.common.given, output);
      origin["picture"] = settings.json();
      pictures.write(output, drawSheet(answer.sheet, settings),
                     settings.properties(translated(answer.sheet.title), provenanceLine(origin)));
    }
    text += wroteLine(output);
  }
  pictures.finish();
  if (command.common.json)
    fmt::print("{}", answer.json);
  else if (command.outputs.empty() && !answer.printed.empty())
    fmt::print("{}", answer.printed);
  else if (command.outputs.empty() || hasStandardOutput(command.outputs))
    fmt::print("# asperity: {}\n{}", provenanceLine(answer.origin), answer.csv);
  if (!command.outputs.empty())
    printSummary(command.common.json || hasStandardOutput(command.outputs), command.common.quiet,
                 text);
}

}  // namespace asperity
