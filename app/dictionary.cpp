#include "app/dictionary.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "core/scene/columns.h"
#include "core/scene/parameter_help.h"

namespace asperity {
namespace {

std::string markdown(const nlohmann::json& text) {
  return escapedMarkdown(text.get<std::string>());
}

/// Returns a definition list of the columns, but for keys of scenes, which are columns of a batch.
std::string columnList() {
  std::string text;
  const auto columns = nlohmann::json::parse(columnsJson())["columns"];
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
