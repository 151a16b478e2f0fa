// Completions of the command line for shells, made from the same tables as its help: commands,
// their options with named values, and the keys of a scene after --set. Pure; any thread.
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

/// Returns the script for bash, zsh or fish; empty for another one.
std::string completionScript(const CLI::App& app, std::string_view shell);

}  // namespace asperity
