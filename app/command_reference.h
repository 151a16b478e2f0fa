// What the program writes about its own command line, made from the tables that it works with:
// completions for shells, and the dictionary of the guide. Pure; any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace asperity {

/// Names of the shells.
std::vector<std::string_view> completionShells();

/// Returns the script for bash, zsh or fish, which completes commands, their options, and the keys
/// of a scene after --set; empty for another shell.
std::string completionScript(const CLI::App& app, std::string_view shell);

/// Returns a page of Markdown with every key of a scene, every column of a table and every option
/// of a command, under the anchors `keys`, `columns`, `options` and, for each command,
/// `options-NAME`. app: the command line with all commands.
std::string dictionaryMarkdown(const CLI::App& app);

}  // namespace asperity
