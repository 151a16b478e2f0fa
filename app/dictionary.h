// The dictionary of the guide: every key of a scene, every column of a table and every option of a
// command, as Markdown, made from the tables that the program itself works with. Pure; any thread.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace asperity {

/// Returns a page of Markdown with the anchors `keys`, `columns`, `options` and, for each command,
/// `options-NAME`. app: the command line with all commands.
std::string dictionaryMarkdown(const CLI::App& app);

}  // namespace asperity
