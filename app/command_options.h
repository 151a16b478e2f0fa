// Options of the command line: ranges FROM:TO, numbers within limits, the options that shape a
// file, those that every command takes with the scene that they name, and errors of the parser in
// the words of this program. An invalid value gives one sentence that names the option, the fault
// and the allowed values. Main thread.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/input_error.h"
#include "core/scene/notes.h"
#include "core/scene/provenance.h"
#include "core/scene/scene.h"

namespace asperity {

struct NumberRange {
  double from = 0, to = 0;
};

/// Reads two finite numbers, the first below the second. Each is in the SI unit `unit`, which may
/// be empty, or has a unit of its own: "1mm:2mm". Throws InputError naming the option.
NumberRange rangeFrom(const std::string& option, const std::string& text, const std::string& unit);

/// Restricts the option to finite numbers, or integers, within limits. The help shows the limits
/// with their SI unit; a number may have a unit of its own, as "3 mm".
void setNumberRange(CLI::Option* option, double least, double most, std::string_view unit = {});
void setIntegerRange(CLI::Option* option, std::int64_t least, std::int64_t most);

/// Lets the option be given several times, with one value each time. Returns it.
CLI::Option* mayRepeat(CLI::Option* option);

/// An option and whether it is given.
using OptionGiven = std::pair<const char*, bool>;

/// Returns the first of the options that is given; null: none.
const char* firstGiven(std::initializer_list<OptionGiven> options);

/// Throws InputError with the first of the options that is given.
void refuseGiven(std::initializer_list<OptionGiven> options, const Message& why);

/// Forbids empty text for options and files, and values for flags; CLI11 would accept both
/// silently. Call it once, after all options have been added.
void refuseEmptyWords(CLI::App& app);

/// An option that was given: its word without dashes, what was given, and the group of options in
/// which the help shows it.
struct GivenOption {
  std::string word;
  std::vector<std::string> values;  // empty for a flag
  std::string group;
  bool isFile = false;  // whether its values name files, which are read
};

/// Groups of options in the help; each shapes outputs of one kind.
inline constexpr const char *kPictureGroup = "Pictures", *kTableGroup = "Tables";

/// Returns whether an option shapes outputs; the scene and its values, the names of outputs,
/// threads and what is printed do not. word: without dashes.
bool shapesOutputs(std::string_view word);

/// Returns the options that were given to a command (or its action) and shape its outputs.
std::vector<GivenOption> givenOptions(const CLI::App& command);

/// Returns the options that shape this output, for its provenance: {"columns": "a,b", "with": ["x",
/// "y"], "regions": true}. The extension determines whether it is a table (.csv, .json, "-" and
/// none) or a picture.
nlohmann::ordered_json optionsFor(const std::vector<GivenOption>& given, const std::string& output);

/// Returns the options of a file in a folder of outputs: "file" is its name without extension.
nlohmann::ordered_json optionsInFolder(const std::vector<GivenOption>& given,
                                       const std::string& file);

/// Returns the parser's error in the words of this program. app: the app that parsed.
InputError parseError(const CLI::App& app, const CLI::ParseError& error);

/// Throws InputError where options of the program are given before a command, which would ignore
/// them.
void refuseWordsBeforeCommand(const CLI::App& app);

struct CommonOptions {
  std::string scene;
  std::vector<std::string> assignments;  // --set KEY=VALUE
  std::string language;                  // language of texts; empty: English, or the window's own
  int threads = 0;                       // 0: as many as the machine has
  bool quiet = false;
  bool json = false;
  bool timing = false;
  std::vector<GivenOption> given;  // that shape outputs
  // instead of the file `scene`, which names it in errors
  std::optional<FoundScene> remade = {};
  bool isPart = false;  // the output folder is temporary: one of its files is kept
};

/// Returns the scene of a command with its assignments. The scene comes from a file or, where no
/// file has the name, from the shipped scenes. Throws InputError.
Scene loadScene(const CommonOptions& options);

/// Returns the files that were read for the scene; no output may replace them.
std::vector<std::filesystem::path> inputFiles(const CommonOptions& options, const Scene& scene);

/// Runs the work of a command. Where an InputError names neither a file nor an option, it gets the
/// name of the scene's file.
template <class Work>
auto withSceneContext(const CommonOptions& options, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw error.isOfOption() ? error : error.withFile(options.scene);
  }
}

/// Reads the scene's measured surface, if it has one, and finds its lines with a progress bar. Both
/// are then cached for the code that makes lines of the scene (core/surface/measured_lines.h). That
/// code also reports errors, because it knows their context.
void findLinesWithProgress(const Scene& scene, bool quiet);

/// Prints text for a user, in whole lines of printable characters: to stdout, or to stderr where
/// stdout has output for a machine, JSON or other data.
void printSummary(const CommonOptions& options, const std::string& summary, bool hasData = false);

/// Returns a line in the present language for each message.
std::string translatedLines(const std::vector<Message>& messages);
/// The same for one message, where there is one.
std::string translatedLine(const std::optional<Message>& line);

/// Returns a line for each note: its word and its sentence in the present language.
std::string noteLines(const NoteSet& notes);

}  // namespace asperity
