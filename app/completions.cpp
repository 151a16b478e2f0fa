#include "app/completions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "core/scene/parameters.h"

namespace asperity {
namespace {

struct Option {
  std::string name;      // "--size"
  std::string sentence;  // of the help
  bool takesValue;
};

std::vector<Option> optionsOf(const CLI::App& command) {
  std::vector<Option> options;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames())
      options.push_back({"--" + name, option->get_description(), option->get_expected_max() > 0});
  return options;
}

std::vector<std::string> namesOf(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::string optionNames(const CLI::App& command) {
  std::string names;
  for (const Option& option : optionsOf(command)) names += (names.empty() ? "" : " ") + option.name;
  return names;
}

std::string keys(std::string_view end) {
  std::string text;
  for (const Parameter& row : parameters())
    text += fmt::format("{}{}{}", text.empty() ? "" : " ", row.key, end);
  return text;
}

/// Returns the text inside of single quotes of a shell.
std::string quoted(std::string text) {
  for (std::size_t at = text.find('\''); at != text.npos; at = text.find('\'', at + 4))
    text.replace(at, 1, "'\\''");
  return "'" + text + "'";
}

std::string bashScript(const CLI::App& app) {
  std::string cases;
  for (const CLI::App* command : app.get_subcommands({}))
    cases +=
        fmt::format("    {}) words={} ;;\n", command->get_name(), quoted(optionNames(*command)));
  return fmt::format(R"(# Completions of asperity for bash; made by the program itself.
_asperity() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} words=
  COMPREPLY=()
  if [ "$before" = --set ]; then
    compopt -o nospace
    COMPREPLY=($(compgen -W {} -- "$word"))
    return
  fi
  if [ "$COMP_CWORD" = 1 ]; then
    COMPREPLY=($(compgen -W {} -- "$word") $(compgen -f -- "$word"))
    return
  fi
  case ${{COMP_WORDS[1]}} in
{}  esac
  case $word in
    -*) COMPREPLY=($(compgen -W "$words" -- "$word")) ;;
    *) COMPREPLY=($(compgen -f -- "$word")) ;;
  esac
}}
complete -o filenames -F _asperity asperity
)",
                     quoted(keys("=")),
                     quoted(fmt::format("{} {}", fmt::join(namesOf(app), " "), optionNames(app))),
                     cases);
}

/// In the descriptions of zsh a colon and brackets have a meaning.
std::string plainWords(const std::string& sentence) {
  std::string text;
  for (const char c : sentence) text += c == ':' || c == '[' || c == ']' || c == '\n' ? ' ' : c;
  return text;
}

std::string zshScript(const CLI::App& app) {
  std::string commands, cases;
  for (const CLI::App* command : app.get_subcommands({})) {
    commands += fmt::format(
        "    {}\n", quoted(command->get_name() + ":" + plainWords(command->get_description())));
    std::string options;
    for (const Option& option : optionsOf(*command)) {
      const std::string after = option.name == "--set" ? ":key:($keys)"
                                : option.takesValue    ? ":value:_files"
                                                       : "";
      const std::string spec = fmt::format("*{}[{}]", option.name, plainWords(option.sentence));
      options += " \\\n        " + quoted(spec) +
                 (after.empty()            ? ""
                  : option.name == "--set" ? "\"" + after + "\""
                                           : quoted(after));
    }
    cases += fmt::format("    {}) _arguments{} \\\n        '*:file:_files' ;;\n",
                         command->get_name(), options);
  }
  return fmt::format(R"(#compdef asperity
# Completions of asperity for zsh; made by the program itself.
_asperity() {{
  local -a commands
  local keys={}
  commands=(
{}  )
  if (( CURRENT == 2 )); then
    _describe command commands
    _files
    return
  fi
  local verb=$words[2]
  shift words
  (( CURRENT-- ))
  case $verb in
{}  esac
}}
_asperity "$@"
)",
                     quoted(keys("=")), commands, cases);
}

std::string fishScript(const CLI::App& app) {
  std::string text = "# Completions of asperity for fish; made by the program itself.\n";
  for (const CLI::App* command : app.get_subcommands({}))
    text += fmt::format("complete -c asperity -n __fish_use_subcommand -a {} -d {}\n",
                        command->get_name(), quoted(command->get_description()));
  for (const CLI::App* command : app.get_subcommands({}))
    for (const Option& option : optionsOf(*command)) {
      const std::string values = option.name == "--set"
                                     ? fmt::format(" -x -a {}", quoted(keys("=")))
                                 : option.takesValue ? " -r"
                                                     : "";
      text +=
          fmt::format("complete -c asperity -n '__fish_seen_subcommand_from {}' -l {}{} -d {}\n",
                      command->get_name(), option.name.substr(2), values, quoted(option.sentence));
    }
  return text;
}

}  // namespace

std::vector<std::string_view> completionShells() {
  return {"bash", "zsh", "fish"};
}

std::string completionScript(const CLI::App& app, std::string_view shell) {
  if (shell == "bash") return bashScript(app);
  if (shell == "zsh") return zshScript(app);
  return shell == "fish" ? fishScript(app) : std::string();
}

}  // namespace asperity
