#include "app/command_options.h"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/output.h"
#include "app/progress_bar.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/scene/parameters.h"
#include "core/scene/scene_file.h"
#include "core/surface/measured_lines.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/window/main/scene_library.h"

namespace asperity {
namespace {

/// Replaces a number with a unit, "3 mm", by that in the SI unit, and returns why the unit is
/// refused. Any other text stays, for the check behind it.
std::string toPlainNumber(std::string& text, std::string_view unit) {
  const TypedQuantity typed = typedQuantity(text, {unit});
  if (typed.value) text = plainNumber(*typed.value);
  return typed.refusal.english();
}

template <class Number>
void setRange(CLI::Option* option, Number least, Number most, const char* what,
              const std::string& allowed) {
  const CLI::Validator check(
      [=](const std::string& text) -> std::string {
        Number number{};
        if (!readNumber(text, number) || !std::isfinite(static_cast<double>(number)))
          return fmt::format("'{}' is not a {}; allowed is {}", shortened(text), what, allowed);
        return number >= least && number <= most
                   ? std::string()
                   : fmt::format("{} is outside {}", shortened(text), allowed);
      },
      "");
  option->check(check)->type_name(allowed);
}

/// Returns the command or its action that was given, or the program itself.
const CLI::App& selectedCommand(const CLI::App& app) {
  const auto commands = app.get_subcommands();
  return commands.empty() ? app : selectedCommand(*commands.front());
}

/// Returns how a command is called: "asperity study run".
std::string commandPath(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent ? commandPath(*parent) + " " + command.get_name() : "asperity";
}

/// Returns the option as the user writes it: "--frames", or "SCENE" for one without dashes.
std::string optionName(const CLI::Option& option) {
  return option.get_positional() ? option.get_name() : option.get_name(false, false);
}

InputError beforeCommand(const CLI::App& command, const std::string& word) {
  return {"", shortened(word),
          fmt::format("must come after '{}', as all options and files do", command.get_name())};
}

InputError unexpected(const CLI::App& app) {
  const CLI::App& command = selectedCommand(app);
  const std::vector<std::string> own = app.remaining(), words = command.remaining();
  if (&command != &app && !own.empty()) return beforeCommand(command, own.front());
  const std::string call = commandPath(command);
  for (const std::string& word : words) {
    if (!word.starts_with('-')) continue;
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
      if (!option->get_positional()) names.push_back(optionName(*option));
    const std::vector<std::string_view> known(names.begin(), names.end());
    const std::string_view nearest = nearestWord(word, known);
    return {"", shortened(word.substr(0, word.find('='))),
            nearest.empty() ? message("unknown option of '{}'; '{} --help' lists all", call, call)
                            : message("unknown option of '{}'; did you mean {}?", call, nearest)};
  }
  if (words.empty()) return {"", "", message("unexpected argument for '{}'", call)};
  const std::string word = shortened(words.front());
  const bool isKey = findParameter(word.substr(0, word.find('='))) != nullptr;
  if (isKey && word.find('=') != std::string::npos && command.get_option_no_throw("--set"))
    return {"", "",
            message("unexpected argument '{}' for '{}'; --set stands before each KEY=VALUE", word,
                    call)};
  return {"", "", message("unexpected argument '{}' for '{}'", word, call)};
}

/// Returns the error for a command without one of its actions, as 'asperity study' needs.
InputError missingAction(const CLI::App& app) {
  const CLI::App& command = selectedCommand(app);
  std::vector<std::string> names;
  for (const CLI::App* action : command.get_subcommands({})) names.push_back(action->get_name());
  const std::vector<std::string_view> known(names.begin(), names.end());
  const std::vector<std::string> words = command.remaining();
  if (!words.empty() && !words.front().starts_with('-'))
    return {"", command.get_name(), notOneOf(shortened(words.front()), known)};
  return {"", command.get_name(), message("needs one of {} behind it", namesWithCommas(known))};
}

/// Translates CLI11's messages such as "--size: At Most 1 required but received 2".
InputError mismatch(const std::string& text) {
  std::string name = text.substr(0, text.find_first_of(": "));
  // the name of a flag
  if (std::islower(static_cast<unsigned char>(name.front()))) name = "--" + name;
  if (text.find("received") != std::string::npos) return {"", name, "is given more than once"};
  if (text.find("flag") != std::string::npos) return {"", name, "takes no value"};
  return {"", name, "needs a value"};
}

}  // namespace

NumberRange rangeFrom(const std::string& option, const std::string& text, const std::string& unit) {
  const std::string_view all = text;
  const std::size_t colon = std::min(all.find(':'), all.size());
  const TypedQuantity from = typedQuantity(all.substr(0, colon), {unit}),
                      to = typedQuantity(all.substr(std::min(colon + 1, all.size())), {unit});
  for (const TypedQuantity& end : {from, to})
    if (!end.refusal.empty()) throw InputError("", option, end.refusal);
  if (!from.value || !to.value || !(*from.value < *to.value))
    throw InputError("", option,
                     message("{} is not FROM:TO{} with FROM below TO", shortened(text),
                             unit.empty() ? "" : " in " + unit));
  return {*from.value, *to.value};
}

void setNumberRange(CLI::Option* option, double least, double most, std::string_view unit) {
  setRange(option, least, most, "number", rangeText(least, most, unit).english());
  option->transform(CLI::Validator(
      [unit = std::string(unit)](std::string& text) { return toPlainNumber(text, unit); }, ""));
}

void setIntegerRange(CLI::Option* option, std::int64_t least, std::int64_t most) {
  setRange(option, least, most, "whole number", fmt::format("{} to {}", least, most));
}

CLI::Option* mayRepeat(CLI::Option* option) {
  return option->take_all()->allow_extra_args(false);
}

const char* firstGiven(std::initializer_list<OptionGiven> options) {
  const auto* found = std::ranges::find(options, true, &OptionGiven::second);
  return found == options.end() ? nullptr : found->first;
}

void refuseGiven(std::initializer_list<OptionGiven> options, const Message& why) {
  if (const char* option = firstGiven(options)) throw InputError("", option, why);
}

void refuseEmptyWords(CLI::App& app) {
  const CLI::Validator hasText(
      [](const std::string& text) { return text.empty() ? "is empty" : std::string(); }, "");
  for (CLI::Option* option : app.get_options())
    if (option->get_expected_max() == 0)
      option->disable_flag_override();
    else
      option->check(hasText);
  for (CLI::App* command : app.get_subcommands({})) refuseEmptyWords(*command);
}

bool shapesOutputs(std::string_view word) {
  // Measured friction and theories are part of the scene by then.
  return !isOneOf(word, {"output", "set", "threads", "quiet", "json", "timing", "resume", "remake",
                         "from", "data", "theory", "help", "realizations-table"});
}

std::vector<GivenOption> givenOptions(const CLI::App& command) {
  std::vector<GivenOption> given;
  for (const CLI::Option* option : selectedCommand(command).get_options()) {
    const std::string word = option->get_positional() ? "" : optionName(*option);
    if (option->count() == 0 || !word.starts_with("--") || !shapesOutputs(word.substr(2))) continue;
    const bool isFlag = option->get_expected_max() == 0;
    given.push_back({word.substr(2), isFlag ? std::vector<std::string>{} : option->results(),
                     option->get_group(),
                     option->get_type_name().find("FILE") != std::string::npos});
  }
  return given;
}

nlohmann::ordered_json optionsFor(const std::vector<GivenOption>& given,
                                  const std::string& output) {
  // A bare ".png" would be the name of a hidden file.
  const std::string file = "x" + output;
  const bool isTable = isTableFile(file) || fileExtension(file).empty();
  nlohmann::ordered_json options = nlohmann::ordered_json::object();
  for (const GivenOption& option : given) {
    if (option.group == (isTable ? kPictureGroup : kTableGroup)) continue;
    // Tables have one language, and English is the default of pictures. The backend of drawing
    // changes rounding alone.
    const bool isEnglish = option.values == std::vector<std::string>{"en"};
    if (option.word == "backend" || (option.word == "language" && (isTable || isEnglish))) continue;
    std::string key = option.word;
    std::ranges::replace(key, '-', '_');
    if (option.values.empty())
      options[key] = true;
    else if (option.values.size() == 1)
      options[key] = option.values.front();
    else
      options[key] = option.values;
  }
  return options;
}

nlohmann::ordered_json optionsInFolder(const std::vector<GivenOption>& given,
                                       const std::string& file) {
  nlohmann::ordered_json options = optionsFor(given, file);
  options["file"] = std::filesystem::path(file).stem().string();
  return options;
}

InputError parseError(const CLI::App& app, const CLI::ParseError& error) {
  const std::string text = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error)) return unexpected(app);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) return mismatch(text);
  if (text.starts_with("A subcommand is required")) return missingAction(app);
  return {"", "", text.substr(0, text.find('\n'))};
}

void refuseWordsBeforeCommand(const CLI::App& app) {
  const CLI::App& command = selectedCommand(app);
  if (&command == &app) return;
  for (const CLI::Option* option : app.get_options())
    if (option->count() > 0) throw beforeCommand(command, optionName(*option));
}

namespace {

/// Returns what standard input holds. Throws InputError where it is more than a scene may be.
std::string standardInput() {
  std::string text;
  char part[4096];
  while (const std::size_t count = std::fread(part, 1, sizeof part, stdin)) {
    text.append(part, count);
    if (text.size() > kLargestScene)
      throw InputError("standard input", "", "is larger than a scene may be");
  }
  return text;
}

}  // namespace

Scene loadScene(const CommonOptions& options) {
  if (options.remade)
    return changedScene(options.remade->scene, options.assignments, options.scene);
  if (options.scene.empty()) return readScene("{}", "--set", {}, options.assignments);
  if (options.scene == "-")
    return readScene(standardInput(), "standard input", {}, options.assignments);
  return readNamedScene(options.scene, {}, options.assignments);
}

std::vector<std::filesystem::path> inputFiles(const CommonOptions& options, const Scene& scene) {
  std::vector<std::filesystem::path> inputs;
  if (!options.remade) inputs.emplace_back(options.scene);  // a remade file may replace itself
  for (const GivenOption& option : options.given)
    if (option.isFile) inputs.insert(inputs.end(), option.values.begin(), option.values.end());
  const std::vector<std::filesystem::path> named = filesReadBy(scene);
  inputs.insert(inputs.end(), named.begin(), named.end());
  return inputs;
}

void findLinesWithProgress(const Scene& scene, bool quiet) {
  if (scene.surface.kind != SurfaceKind::Measured) return;
  ProgressBar bar(Words::tr("parts of the surface"), quiet);
  try {
    MeasuredLines::of(scene, {}, [&bar](double part) { bar.showPart(part); });
  } catch (const InputError&) {
  }
}

void printSummary(const CommonOptions& options, const std::string& summary, bool hasData) {
  if (options.quiet || options.isPart) return;
  std::string text;
  for (std::size_t at = 0; at < summary.size();) {
    const std::size_t end = std::min(summary.find('\n', at), summary.size());
    text += printable(std::string_view(summary).substr(at, end - at)) + "\n";
    at = end + 1;
  }
  if (options.json || hasData)
    std::fputs(text.c_str(), stderr);
  else
    fmt::print("{}", text);
}

std::string translatedLines(const std::vector<Message>& messages) {
  std::string text;
  for (const Message& line : messages) text += translated(line) + "\n";
  return text;
}

std::string translatedLine(const std::optional<Message>& line) {
  return line ? translated(*line) + "\n" : std::string();
}

std::string noteLines(const NoteSet& notes) {
  std::string text;
  for (const Note note : notes.list())
    text += std::string(noteWord(note)) + ": " + translated(noteSentence(note)) + "\n";
  return text;
}

}  // namespace asperity
