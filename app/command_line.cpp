#include "app/command_line.h"

#include <fmt/format.h>

#include <QtGlobal>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>

#include "app/command_reference.h"
#include "app/command_table.h"
#include "app/output.h"
#include "app/remake.h"
#include "app/vector_target.h"
#include "core/base/input_error.h"
#include "core/base/text.h"
#include "core/scene/parameters.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

constexpr const char* kDescription =
    "Asperity shows and computes how a viscoelastic elastomer slides over a randomly rough line.";

class CommandLine {
 public:
  /// word: the first one behind the program's name; may be empty.
  explicit CommandLine(std::string_view word) : app_(kDescription, "asperity") {
    app_.set_version_flag("--version", versionText());
    app_.add_option("--completions", completions_,
                    "Print completions of this command line for bash, zsh or fish")
        ->type_name("SHELL");
    app_.add_flag("--dictionary", printsDictionary_,
                  "Print all scene keys, columns and options as Markdown");
    app_.set_help_flag("-h,--help", "Show this help");
    app_.require_subcommand(0, 1);
    commands_.declareIn(app_, word, remake);
    app_.footer(fmt::format(
        "Exit status: {} done, {} the run failed, {} bad input or usage, {} interrupted, {} "
        "terminated.\n{}",
        kDone, kRunFailed, kBadInput, kInterrupted, kTerminated, vectorTargetHelp()));
    refuseEmptyWords(app_);
  }

  int run(int argc, char** argv) {
    try {
      // The parser takes the words in reverse order.
      std::vector<std::string> words(std::make_reverse_iterator(argv + argc),
                                     std::make_reverse_iterator(argv + std::min(argc, 1)));
      if (asksForKeys(words)) {
        fmt::print("Scene keys (--set KEY=VALUE):\n{}", parameterTableText());
        return kDone;
      }
      if (!words.empty() && words.back() == "help" && !std::filesystem::exists("help")) {
        words.pop_back();
        words.insert(words.begin(), "--help");
      }
      app_.parse(std::move(words));
    } catch (const CLI::ParseError& error) {
      if (error.get_exit_code() == 0) return app_.exit(error);
      throw parseError(app_, error);
    }
    refuseWordsBeforeCommand(app_);
    for (const CommonOptions* common : commands_.common())
      if (!common->language.empty()) chooseLanguage(common->language);
    if (const auto commands = app_.get_subcommands(); !commands.empty())
      for (CommonOptions* common : commands_.common())
        common->given = givenOptions(*commands.front());
    if (!completions_.empty()) {
      const std::string script = completionScript(app_, completions_);
      if (script.empty())
        throw InputError("", "--completions", notOneOf(completions_, completionShells()));
      fmt::print("{}", script);
      return kDone;
    }
    if (printsDictionary_) {
      fmt::print("{}", dictionaryMarkdown(app_));
      return kDone;
    }
    return commands_.run();
  }

  /// The contents of a remade file, which its command uses instead of a scene file.
  void setRemade(const Remake& remake) {
    for (CommonOptions* common : commands_.common()) {
      if (remake.found) common->remade = remake.found;
      common->isPart = !remake.part.empty();
    }
  }

  /// Treats a first word that is neither an option, a command nor a file as a misspelt command.
  void checkCommand(int argc, char** argv) const {
    const bool asksForHelp = argc > 2 && argv[1] == std::string_view("help");
    const std::string word = asksForHelp ? argv[2] : argc > 1 ? argv[1] : "";
    const bool isLikeCommand = !word.empty() && word.find_first_of("-./") == std::string::npos;
    std::error_code ignored;  // as where the word is longer than a name of a file
    if (!isLikeCommand || word == "help" || std::filesystem::exists(word, ignored)) return;
    std::vector<std::string> names;
    for (const CLI::App* command : app_.get_subcommands({})) names.push_back(command->get_name());
    if (std::ranges::find(names, word) != names.end()) return;
    const std::vector<std::string_view> known(names.begin(), names.end());
    const std::string_view nearest = nearestWord(word, known);
    throw InputError(
        "", "",
        nearest.empty()
            ? message("unknown command '{}'; 'asperity --help' lists all", shortened(word))
            : message("unknown command '{}'; did you mean '{}'?", shortened(word), nearest));
  }

  bool timing() const { return std::ranges::any_of(commands_.common(), &CommonOptions::timing); }

 private:
  /// Returns whether "keys" follows --help or "help".
  static bool asksForKeys(const std::vector<std::string>& reversed) {
    for (std::size_t i = 0; i + 1 < reversed.size(); ++i)
      if (reversed[i] == "keys" && (reversed[i + 1] == "--help" || reversed[i + 1] == "-h" ||
                                    (reversed[i + 1] == "help" && reversed.size() == 2)))
        return true;
    return false;
  }

  static std::string versionText() {
    return fmt::format("asperity {}\n{} {}, Qt {}, {}", ASPERITY_VERSION,
#ifdef __clang__
                       "Clang", __clang_version__,
#else
                       "GCC", __VERSION__,
#endif
                       qVersion(), vectorTargetInUse());
  }

  /// Runs the command that made the file on the file's own scene.
  static int remake(const OpenCommand& open) {
    Remake remake = prepareRemake(open);
    std::optional<RemakeFolder> folder;
    if (!remake.part.empty()) {
      folder.emplace();
      remake.words.insert(remake.words.end(), {"--output", folder->path().string()});
    }
    std::string name = "asperity";
    std::vector<char*> words{name.data()};
    for (std::string& word : remake.words) words.push_back(word.data());
    CommandLine again(words.size() > 1 ? words[1] : "");
    again.setRemade(remake);
    const int status = again.run(static_cast<int>(words.size()), words.data());
    if (status != kDone && !remake.hasSeveralScenes) return status;
    if (folder) {
      folder->take(remake);
      printSummary(open.common, wroteLines({remake.output}), remake.output == "-");
    }
    if (remake.hasTimes)
      printSummary(open.common,
                   filled(Words::tr("%1: run times, and what follows from them, are measured "
                                    "again; all other numbers are the same"),
                          {remake.output}),
                   true);
    return status;
  }

  CLI::App app_;
  std::string completions_;
  bool printsDictionary_ = false;
  CommandTable commands_;
};

}  // namespace

int runCommandLine(int argc, char** argv) {
  const auto start = std::chrono::steady_clock::now();
  CommandLine commandLine(argc > 1 ? argv[1] : "");
  commandLine.checkCommand(argc, argv);
  const int status = commandLine.run(argc, argv);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  if (commandLine.timing())
    std::fputs(fmt::format("time {:.3f} s\n", elapsed.count()).c_str(), stderr);
  return status;
}

}  // namespace asperity
