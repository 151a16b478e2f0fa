// A file made again from what it says of itself: its scene, the command that made it and the
// options that shaped it become a command line. Main thread.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/scene/provenance.h"

namespace asperity {

struct OpenCommand;

struct Remake {
  std::vector<std::string> words;  // of the command line, without the program's name
  std::filesystem::path folder{};  // where a command that makes many files writes them
  std::filesystem::path made{};    // of them the one that is meant
};

/// Returns the command line that makes the file of `found` again, with the options of the user in
/// place of its own. Throws InputError where the file does not say how it was made, or where it
/// cannot be made alone.
Remake remakeOf(const OpenCommand& command, const FoundScene& found);

/// Moves the file that was meant to its place, and removes the others.
void finishRemake(const Remake& remake, const std::string& output);

}  // namespace asperity
