// Output files of the commands: their names are checked before any work, their kinds by extension.
// Main thread.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"

namespace asperity {

/// Returns the extension in small letters: ".csv" for "out/Curve.CSV".
std::string fileExtension(const std::string& file);

/// Extensions of the tables and pictures that most commands write.
inline const std::initializer_list<std::string_view> kOutputExtensions = {
    ".csv", ".json", ".png", ".svg", ".pdf", ".eps", ".tif", ".tiff"};

/// Returns the name of a file in a folder.
std::string fileIn(const std::string& folder, const std::string& name);

/// Returns whether a file is a picture by its extension.
bool isPictureFile(const std::string& file);

/// Returns whether an output is a table: .csv, .json, or `-`, standard output.
bool isTableFile(const std::string& file);

/// The output of a command without an output file.
enum class DefaultOutput { PrintsSummary, PrintsTable };

/// Returns whether `-`, standard output, is one of the outputs.
bool hasStandardOutput(const std::vector<std::string>& files);

/// Writes a table to a file, or to standard output where it is `-`.
void writeTable(const std::string& output, const std::string& text);

/// Throws InputError where a file has none of these extensions, can never be written or is given
/// twice. `-` is allowed where a table can be printed.
void checkOutputs(const std::vector<std::string>& files,
                  std::initializer_list<std::string_view> extensions,
                  DefaultOutput byDefault = DefaultOutput::PrintsSummary);

/// Throws InputError where an output would replace a file that was read.
void checkNoInput(const std::string& output, const std::vector<std::filesystem::path>& inputs);

/// Throws InputError where the folder's name is "-": pictures and tables cannot go to standard
/// output together, and a folder of that name is hardly intended.
void checkFolderName(const std::string& folder);

/// Throws InputError where the folder cannot be made, nothing can be written into it, or a new one
/// would have the name of a picture or table, which its user expects to be a file. Makes nothing,
/// so that a command can call it before any other check.
void checkFolder(const std::string& folder);

/// Makes the folder and its parents where they are missing. Throws InputError.
void makeFolder(const std::string& folder);

/// Returns a number, or one with its unit, in the present language, as all answers of commands have
/// it: without groups of thousands, because people type such numbers back.
std::string answerNumber(double value, int digits = 3);
std::string answerQuantity(double value, std::string_view unit, int digits = 3);

/// Returns a text of the present language with its values, texts and integers, as a line.
template <class... Values>
std::string filledLine(std::string_view form, const Values&... values) {
  return filled(form, {fmt::format("{}", values)...}) + "\n";
}

/// Returns "wrote a.png" in the current language, with a line break.
std::string wroteLine(const std::string& file);

/// Returns such a line for each file, without standard output.
std::string wroteLines(const std::vector<std::string>& files);

/// Prints an error as one line to stderr. Errors of stderr itself (closed, full) are ignored:
/// nothing else can report them.
void printError(const std::string& sentence);

/// Prints an answer in JSON to stdout.
void printJson(const nlohmann::ordered_json& answer);

}  // namespace asperity
