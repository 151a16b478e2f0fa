#include "app/remake.h"

#include <algorithm>
#include <set>

#include "app/command_line.h"
#include "app/output.h"
#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/chart/figure_style.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

bool isTable(const std::string& file) {
  const std::string extension = extensionOf(file);
  return file == "-" || extension == ".csv" || extension == ".json";
}

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

std::string textOf(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

void addOption(std::vector<std::string>& words, const std::string& word, const Json& value) {
  if (value.is_array()) {
    for (const Json& one : value) addOption(words, word, one);
  } else if (value.is_boolean()) {
    if (value.get<bool>()) words.push_back("--" + word);
  } else {
    // One word, so that a value that begins with a dash is none itself.
    words.push_back("--" + word + "=" + textOf(value));
  }
}

/// Words of options that the user gives anew.
std::set<std::string> wordsOf(const std::vector<std::string>& given) {
  std::set<std::string> words;
  for (const std::string& word : given)
    if (word.starts_with("--")) words.insert(word.substr(2, word.find('=') - 2));
  return words;
}

}  // namespace

Remake remakeOf(const OpenCommand& command, const FoundScene& found) {
  const std::string& file = command.common.scene;
  if (!found.isCarried) throw InputError(file, "", "is a scene, not a result that can be remade");
  static const std::set<std::string_view> single{"curve", "map", "motion", "render", "surface"};
  const bool saysOptions = found.options.is_object();
  if (!saysOptions && (single.contains(found.verb) || found.verb == "figure"))
    throw InputError(file, "",
                     "does not say the options that made it, as files of the command line do since "
                     "this version; open it and save it again");
  const bool isFigure = found.verb == "figure" && found.options.contains("name");
  if (!single.contains(found.verb) && !isFigure)
    throw InputError(file, "",
                     message("was made by 'asperity {}', whose files are made together; run that "
                             "again",
                             shortened(found.verb)));
  const std::string output = command.output.empty() ? file : command.output;
  Json options = found.options;
  if (found.verb == "render" && options.contains("frames") &&
      (extensionOf(file) == ".png" || extensionOf(file) == ".svg"))
    throw InputError(file, "", "is one frame of a sequence; render the folder again");
  Remake remake;
  remake.words.push_back(found.verb);
  std::string outputOption = "output";
  if (isFigure) {
    const std::string name = textOf(options["name"]);
    options.erase("name");
    remake.words.push_back(name);
    remake.folder = output + ".remake";
    remake.made = remake.folder / ("figure_" + name + extensionOf(output));
    remake.words.insert(remake.words.end(), {"--output", remake.folder.string()});
  } else {
    remake.words.push_back(file);
    if (options.contains("output_option")) {
      outputOption = textOf(options["output_option"]);
      options.erase("output_option");
    }
    remake.words.insert(remake.words.end(), {"--" + outputOption, output});
  }
  std::set<std::string> anew = wordsOf(command.others);
  if (!command.common.language.empty()) anew.insert("language");
  const bool dropsPictures = isTable(output) && !isTable(file);
  const bool isVector = extensionOf(output) == ".svg" || extensionOf(output) == ".pdf" ||
                        extensionOf(output) == ".eps";
  for (const auto& [key, value] : options.items()) {
    const std::string word = dashed(key);
    const bool isReplaced = anew.contains(word) || (word == "scale" && anew.contains("dpi")) ||
                            (word == "dpi" && anew.contains("scale"));
    if (isReplaced || (dropsPictures && isOfPictures(word)) || (isVector && word == "backend"))
      continue;
    addOption(remake.words, word, value);
  }
  remake.words.insert(remake.words.end(), command.others.begin(), command.others.end());
  if (!command.common.language.empty())
    remake.words.push_back("--language=" + command.common.language);
  if (command.common.quiet) remake.words.emplace_back("--quiet");
  if (command.common.json) remake.words.emplace_back("--json");
  if (command.common.threads > 0)
    remake.words.push_back("--threads=" + std::to_string(command.common.threads));
  return remake;
}

void finishRemake(const Remake& remake, const std::string& output) {
  if (remake.folder.empty()) return;
  std::error_code error;
  fs::rename(remake.made, output, error);
  if (error) throw InputError(output, "", "cannot be made from this figure");
  fs::remove_all(remake.folder, error);
}

}  // namespace asperity
