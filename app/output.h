// Output files of the verbs: their names checked before any work, their kinds by extension.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// ".csv" of "out/Curve.CSV".
std::string extensionOf(const std::string& file);

/// What a verb does that is given no output file.
enum class Without { PrintsSummary, PrintsTable };

/// Throws InputError where a file has none of these extensions, can never be written or stands
/// there twice.
void checkOutputs(const std::vector<std::string>& files,
                  std::initializer_list<std::string_view> extensions,
                  Without without = Without::PrintsSummary);

/// Throws InputError where an output would replace a file that was read.
void checkNoInput(const std::string& output, const std::vector<std::filesystem::path>& inputs);

/// Throws InputError where the folder's name is "-": pictures and tables do not go to standard
/// output together, and a folder of that name is hardly ever meant.
void checkFolderName(const std::string& folder);

/// Makes the folder, with those above it, where it is not there. Throws InputError.
void makeFolder(const std::string& folder);

/// "wrote a.png" in the language in use, with its line's end.
std::string wroteLine(const std::string& file);

/// What a person reads, in whole lines of printable characters: to stdout, or to stderr where
/// stdout is the machine's.
void printSummary(bool machineReads, bool quiet, const std::string& given);

}  // namespace asperity
