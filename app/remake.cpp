#include "app/remake.h"

#include <stdlib.h>

#include <algorithm>
#include <set>

#include "app/command_line.h"
#include "app/output.h"
#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/regular_file.h"
#include "core/base/text.h"
#include "core/chart/figure_style.h"
#include "core/scene/scene_file.h"
#include "core/study/study_store.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Options of pictures that tables do not have.
bool isOfPictures(const std::string& word) {
  static const std::set<std::string_view> words = [] {
    std::set<std::string_view> all{"scale",    "style",   "transparent", "backend",
                                   "language", "x-range", "y-range",     "axes"};
    for (const FigureOption& option : figureOptions()) all.insert(option.word);
    return all;
  }();
  return words.contains(word);
}

std::string dashed(std::string key) {
  std::ranges::replace(key, '_', '-');
  return key;
}

void addOption(std::vector<std::string>& words, const std::string& word, const Json& value) {
  if (value.is_array()) {
    for (const Json& one : value) addOption(words, word, one);
  } else if (value.is_boolean()) {
    if (value.get<bool>()) words.push_back("--" + word);
  } else {
    // One word, so that a value that begins with a dash is none itself.
    words.push_back("--" + word + "=" + assignedText(value));
  }
}

/// Returns the words of options that the user gives again.
std::set<std::string> optionWords(const std::vector<std::string>& given) {
  std::set<std::string> words;
  for (const std::string& word : given)
    if (word.starts_with("--")) words.insert(word.substr(2, word.find('=') - 2));
  return words;
}

/// Removes a member that is a text.
std::string taken(Json& object, const char* member) {
  const auto found = object.find(member);
  if (found == object.end()) return {};
  std::string text = assignedText(*found);
  object.erase(member);
  return text;
}

/// Returns the options of material.json, which are in its origin: other files are made from it, and
/// must not depend on the style of its pictures.
Json materialOptions(const Json& metadata) {
  Json options = Json::object();
  const Json given = metadata["origin"].value("options", Json::object());
  for (const auto& [option, value] : given.items()) {
    const bool isFlag = isOneOf(option, {"--vertical-shifts", "--liquid"});
    options[option.substr(std::min<std::size_t>(2, option.size()))] = isFlag ? Json(true) : value;
  }
  for (const char* label : {"name", "source"})
    if (metadata.contains(label) && metadata[label] != "")
      options[label] = assignedText(metadata[label]);
  options["file"] = "material";
  return options;
}

/// Returns whether a result was made from measured moduli, and has no scene.
bool isFromMeasurements(const FoundScene& found) {
  const Json& origin = found.origin;
  return origin.contains("origin") && origin["origin"].is_object() &&
         origin["origin"].contains("file") && !origin.contains("scene");
}

/// Returns the options that made the file. Throws where a file of this origin cannot be made again.
Json recordedOptions(const FoundScene& found, const std::string& file) {
  if (!found.isEmbedded) throw InputError(file, "", "is a scene, not a result that can be remade");
  if (!isOneOf(found.verb, {"accuracy", "batch", "curve", "cutoff", "figure", "fit", "map",
                            "material", "motion", "render", "sensitivity", "study", "surface"}))
    throw InputError(
        file, "",
        message("is a result of the kind '{}', which cannot be remade", shortened(found.verb)));
  if (isFromMeasurements(found) && !found.origin.contains("options"))
    return materialOptions(found.origin);
  // A file that an earlier version wrote into a folder does not name itself.
  const bool isOfFolder = isOneOf(found.verb, {"accuracy", "batch", "fit", "material"});
  if (!found.options.is_object() || (isOfFolder && !found.options.contains("file")) ||
      (found.verb == "figure" && !found.options.contains("name")))
    throw InputError(file, "",
                     message("does not say the options that made it: files that the window, an "
                             "earlier version or Python from values alone saved do not, and may "
                             "have other numbers; 'asperity {}' makes a new one of its scene",
                             found.verb));
  if (found.verb == "render" && found.options.contains("frames") && isPictureFile(file))
    throw InputError(file, "", "is one frame of a sequence; render the folder again");
  return found.options;
}

/// The store in which a study's results are: the one that the user names, or the first beside the
/// file, above it or in the present folder that has as many of its simulations.
fs::path findStore(const FoundScene& found, const OpenCommand& command) {
  const std::string& file = command.common.scene;
  const std::string digest = assignedText(found.origin.value("study_sha256", Json()));
  const Json simulations = found.origin.value("simulations", Json());
  const auto isOfStudy = [&](const StudyStore& store) { return store.study().digest == digest; };
  const auto isSame = [&](const StudyStore& store) {
    return isOfStudy(store) && Json(store.simulationsDone()) == simulations &&
           (!found.origin.contains("chunks_sha256") ||
            assignedText(found.origin["chunks_sha256"]) == store.chunksDigest());
  };
  const auto changed = [&](const StudyStore& store) {
    if (Json(store.simulationsDone()) == simulations)
      return InputError(store.file().string(), "",
                        message("has other simulations than {} was made from", shortened(file)));
    return InputError(store.file().string(), "",
                      message("has {} simulations now, and {} was made from {}",
                              store.simulationsDone(), shortened(file), assignedText(simulations)));
  };
  std::error_code ignored;
  if (!command.from.empty() && !fs::is_directory(command.from, ignored)) {
    const StudyStore store(command.from);
    if (!isOfStudy(store))
      throw InputError(command.from, "", message("is not the store of the study of {}", file));
    if (!isSame(store)) throw changed(store);
    return command.from;
  }
  std::vector<fs::path> folders = foldersAround(file);
  if (!command.from.empty()) folders = {command.from};
  std::optional<InputError> nearest;
  for (const fs::path& folder : folders)
    for (const fs::directory_entry& entry :
         fs::directory_iterator(folder.empty() ? "." : folder, ignored)) {
      const fs::path candidate = folder / entry.path().filename();
      try {
        // The number of a store's kind, SQLite's application_id, is in its first bytes.
        if (!entry.is_regular_file(ignored) || !isStudyStore(RegularFile(candidate).read(0, 72)))
          continue;
        const StudyStore store(candidate);
        if (isSame(store)) return candidate;
        if (isOfStudy(store) && !nearest) nearest = changed(store);
      } catch (const std::exception&) {
        continue;  // it cannot be read, or is damaged
      }
    }
  if (nearest) throw *nearest;
  throw InputError(file, "--from",
                   "the store of its study is neither beside it, nor above it, nor in the present "
                   "folder; --from names it");
}

/// Throws where a file that the result was made from is missing: it would be made without it, or
/// not at all.
void needInputs(const FoundScene& found, const std::string& file) {
  std::error_code ignored;
  for (const InputFile& input : inputsOf(found))
    if (!fs::exists(found.scene.folder / input.name, ignored))
      throw InputError(file, input.key,
                       message("{}, from which it was made, is not there; --from names its folder",
                               shortened(input.name)));
}

/// Checks the name of the new file and the options for it before any work.
void checkOutput(const Remake& remake, const OpenCommand& command,
                 const std::vector<fs::path>& inputs) {
  const bool isPicture = isPictureFile(command.common.scene);
  if (remake.output != "-") checkNoInput(remake.output, inputs);
  if (remake.part.empty()) return;  // the command checks it
  const std::string extension = fileExtension(remake.output);
  const bool isStandardOutput = remake.output == "-" && !isPicture;
  const auto check = [&](std::initializer_list<std::string_view> known) {
    if (!isOneOf(extension, known)) throw unknownExtension(remake.output, extension, known);
  };
  if (!isStandardOutput) {
    if (remake.words.front() == "figure")
      check({".csv", ".png", ".svg", ".pdf"});
    else if (isPicture && remake.words.front() == "batch")
      check({".png"});
    else if (isPicture)
      check({".png", ".svg", ".pdf"});
    else
      check({".csv", ".json"});
    checkWritable(remake.output);
  }
  for (const std::string& word : optionWords(command.others))
    if (isOfPictures(word) == isTableFile(remake.output) &&
        (isOfPictures(word) || word == "columns"))
      throw InputError("", "--" + word,
                       message("belongs to {}, and {} is none",
                               isOfPictures(word) ? "pictures" : "tables", remake.output));
}

/// Adds what the command reads: the store of a study, measured moduli, the name of a figure, or
/// otherwise the file itself, whose scene the command gets. Returns the files that are read.
std::vector<fs::path> addInputs(Remake& remake, FoundScene& found, const std::string& part,
                                const OpenCommand& command) {
  const std::string& file = command.common.scene;
  const bool isMeasured = isFromMeasurements(found);
  if ((found.verb == "study" || isMeasured || remake.hasSeveralScenes) &&
      !command.common.assignments.empty())
    throw InputError("", "--set", message("sets keys of a scene, and {} is not of one", file));
  if (found.verb == "study") {
    const fs::path store = findStore(found, command);
    remake.words.insert(remake.words.end(), {part.empty() ? "table" : "analyse", store.string()});
    return {store};
  }
  needInputs(found, file);
  for (const FoundScene& one : found.parts) needInputs(one, file);
  std::vector<fs::path> inputs;
  for (const InputFile& input : inputsOf(found)) inputs.push_back(found.scene.folder / input.name);
  if (isMeasured || found.verb == "figure") {
    remake.words.push_back(isMeasured ? inputs.front().string() : part);
    return inputs;
  }
  remake.words.push_back(file);
  if (found.verb == "fit" && found.origin.contains("start"))
    found.scene = readScene(jsonLine(found.origin["start"]), file, found.scene.folder);
  if (!remake.hasSeveralScenes)
    found.scene = changedScene(found.scene, command.common.assignments, file);
  remake.found = std::move(found);
  return inputs;
}

/// Adds the options of the file, except those that the user gives again.
void addOwnOptions(Remake& remake, const Json& options, const OpenCommand& command) {
  const std::string& file = command.common.scene;
  const bool isFigure = remake.words.front() == "figure";
  std::set<std::string> given = optionWords(command.others);
  if (!command.common.language.empty()) given.insert("language");
  const bool dropsPictures = isTableFile(remake.output) && !isTableFile(file);
  const bool isVector = isOneOf(fileExtension(remake.output), {".svg", ".pdf", ".eps"});
  for (const auto& [key, value] : options.items()) {
    const std::string word = dashed(key);
    // The file of a figure describes its scene by settings only.
    if (!shapesOutputs(word) && !(word == "set" && isFigure))
      throw InputError(file, "options." + shortened(key), "is not an option that changes a file");
    const bool isReplaced = given.contains(word) || (word == "scale" && given.contains("dpi")) ||
                            (word == "dpi" && given.contains("scale"));
    if (isReplaced || (dropsPictures && isOfPictures(word)) || (isVector && word == "backend"))
      continue;
    addOption(remake.words, word, value);
  }
  if (isFigure)  // in the scenes of others they are set already
    for (const std::string& assignment : command.common.assignments)
      addOption(remake.words, "set", assignment);
}

/// Adds what the user gives.
void addGiven(Remake& remake, const OpenCommand& command) {
  std::vector<std::string>& words = remake.words;
  const CommonOptions& common = command.common;
  words.insert(words.end(), command.others.begin(), command.others.end());
  if (!common.language.empty()) words.push_back("--language=" + common.language);
  if (common.quiet) words.emplace_back("--quiet");
  if (common.json) words.emplace_back("--json");
  if (common.threads > 0) words.push_back("--threads=" + std::to_string(common.threads));
}

}  // namespace

Remake prepareRemake(const OpenCommand& command) {
  const std::string& file = command.common.scene;
  std::error_code ignored;
  const bool isFolder = fs::is_directory(command.from, ignored);
  FoundScene found = findResult(file, isFolder ? command.from : std::string());
  if (!command.from.empty() && !isFolder && found.verb != "study")
    throw InputError("", "--from", message("{} is not a folder", shortened(command.from)));
  Json options = recordedOptions(found, file);
  const std::string part = taken(options, found.verb == "figure" ? "name" : "file");
  // A name in a foreign file must not lead out of the folder.
  if (part.find('/') != std::string::npos)
    throw InputError(file, "options.file", message("'{}' is not a file name", shortened(part)));
  if (found.verb == "batch")  // the batch command reads its item, or all items, itself
    for (const char* own : {"entry", "title", "every", "lines"}) options.erase(own);

  Remake remake;
  remake.words = {found.verb};
  remake.output = command.output.empty() ? file : command.output;
  remake.hasSeveralScenes = !found.parts.empty();
  remake.hasTimes = found.verb == "accuracy";
  const std::vector<fs::path> inputs = addInputs(remake, found, part, command);
  const bool isRealizationsTable = taken(options, "output_option") == "realizations-table";
  if (part.empty()) {
    remake.words.insert(remake.words.end(),
                        {isRealizationsTable ? "--realizations-table" : "--output", remake.output});
  } else {
    const std::string prefix = remake.words.front() == "figure" ? "figure_" : "";
    remake.part = prefix + part + fileExtension(remake.output == "-" ? file : remake.output);
  }
  checkOutput(remake, command, inputs);
  addOwnOptions(remake, options, command);
  addGiven(remake, command);
  return remake;
}

RemakeFolder::RemakeFolder() {
  std::string name = (fs::temp_directory_path() / "asperity-remake-XXXXXX").string();
  if (!::mkdtemp(name.data()))
    throw std::runtime_error(name.substr(0, name.rfind('/')) + ": no folder can be made there");
  path_ = name;
}

RemakeFolder::~RemakeFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void RemakeFolder::take(const Remake& remake) const {
  const fs::path made = path_ / remake.part;
  std::error_code ignored;
  if (!fs::exists(made, ignored))
    throw InputError(remake.output, "",
                     message("'asperity {}' writes no {}", remake.words.front(), remake.part));
  constexpr std::size_t kLargest = std::size_t{1} << 31;
  writeTable(remake.output, readRegularFile(made, kLargest));
}

}  // namespace asperity
