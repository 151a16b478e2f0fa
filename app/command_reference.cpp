#include "app/command_reference.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "core/base/json_text.h"
#include "core/scene/columns.h"
#include "core/scene/parameters.h"

namespace asperity {
namespace {

struct OptionHelp {
  std::string name;      // "--size"
  std::string sentence;  // of the help
  bool takesValue;
};

std::vector<OptionHelp> longOptions(const CLI::App& command) {
  std::vector<OptionHelp> options;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames())
      options.push_back({"--" + name, option->get_description(), option->get_expected_max() > 0});
  return options;
}

std::vector<std::string> commandNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::string optionNames(const CLI::App& command) {
  std::string names;
  for (const OptionHelp& option : longOptions(command))
    names += (names.empty() ? "" : " ") + option.name;
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
  return fmt::format(
      R"(# Completions of asperity for bash; made by the program itself.
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
      quoted(fmt::format("{} {}", fmt::join(commandNames(app), " "), optionNames(app))), cases);
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
    for (const OptionHelp& option : longOptions(*command)) {
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
    for (const OptionHelp& option : longOptions(*command)) {
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

std::string markdown(const nlohmann::ordered_json& text) {
  return escapedMarkdown(text.get<std::string>());
}

/// Returns a definition list of the columns, but for keys of scenes, which are columns of a batch.
std::string columnList() {
  std::string text;
  const auto columns = jsonValue(columnsJson())["columns"];
  for (const auto& column : columns) {
    const std::string name = column["name"];
    if (name.find('.') != name.npos) continue;
    const std::string unit = column["unit"], equation = column["equation"];
    std::string tables;
    for (const auto& table : column["tables"])
      tables += (tables.empty() ? "" : ", ") + table.get<std::string>();
    text += fmt::format(
        "`{}`{}\n\n:   {}{} In: {}.\n\n", name, unit.empty() ? "" : " " + escapedMarkdown(unit),
        markdown(column["meaning"]),
        equation.empty() ? "" : " *" + escapedMarkdown(equation) + "*.", escapedMarkdown(tables));
  }
  return text;
}

void addCommand(const CLI::App& command, const std::string& before, std::string& text) {
  const std::string name = command.get_name();
  text += fmt::format("### {} {{#options{}-{}}}\n\n```text\n{}```\n\n", name,
                      before == "asperity" ? "" : "-" + before.substr(before.rfind(' ') + 1), name,
                      command.help(before));
  for (const CLI::App* action : command.get_subcommands({}))
    addCommand(*action, before + " " + name, text);
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

std::string dictionaryMarkdown(const CLI::App& app) {
  std::string text =
      "# Dictionary {#dictionary}\n\nThe program made this page from its own tables; "
      "`asperity columns`, `--help keys` and `--help` print the same.\n\n"
      "## Keys of a scene {#keys}\n\n"
      "A scene is a JSON file; what is left out has its default. A key of another kind than the "
      "scene's is an error.\n\n" +
      parameterListMarkdown() +
      "## Columns of tables {#columns}\n\n"
      "Symbols are those of the [theory](#symbols); y = -u, grad is the rms slope. In a batch that "
      "varies a key, the key itself is a column, too.\n\n" +
      columnList() + "## Commands and their options {#options}\n\n";
  for (const CLI::App* command : app.get_subcommands({})) addCommand(*command, "asperity", text);
  return text;
}

}  // namespace asperity
