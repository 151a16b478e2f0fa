#include "app/output.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_number.h"
#include "ui/draw/picture_file.h"
#include "ui/language/language.h"

namespace asperity {

std::string fileExtension(const std::string& file) {
  return lowerCase(std::filesystem::path(file).extension().string());
}

std::string fileIn(const std::string& folder, const std::string& name) {
  return (std::filesystem::path(folder) / name).string();
}

bool isPictureFile(const std::string& file) {
  return isOneOf(fileExtension(file), kPictureExtensions);
}

bool isTableFile(const std::string& file) {
  const std::string extension = fileExtension(file);
  return file == "-" || extension == ".csv" || extension == ".json";
}

bool hasStandardOutput(const std::vector<std::string>& files) {
  return std::ranges::find(files, "-") != files.end();
}

void writeTable(const std::string& output, const std::string& text) {
  if (output == "-")
    fmt::print("{}", text);
  else
    writeFileAtomically(output, text);
}

void checkOutputs(const std::vector<std::string>& files,
                  std::initializer_list<std::string_view> extensions, DefaultOutput byDefault) {
  std::set<std::filesystem::path> seen;
  for (const std::string& file : files) {
    if (file == "-" && byDefault == DefaultOutput::PrintsTable) {
      if (!seen.insert(file).second)
        throw InputError("", "--output", file + " is given more than once");
      continue;
    }
    checkWritable(file);
    const std::string extension = fileExtension(file);
    if (!isOneOf(extension, extensions)) throw unknownExtension(file, extension, extensions);
    checkPictureTool(file);
    if (!seen.insert(std::filesystem::absolute(file).lexically_normal()).second)
      throw InputError("", "--output", file + " is given more than once");
  }
}

void checkNoInput(const std::string& output, const std::vector<std::filesystem::path>& inputs) {
  if (isAnyOf(output, inputs))
    throw InputError("", "--output", output + " is also an input file and would be replaced");
}

void checkFolderName(const std::string& folder) {
  if (folder == "-")
    throw InputError("", "--output",
                     "'-' is not a folder, and pictures cannot be written to standard output; name "
                     "a file or a folder (./- for a folder called -)");
}

namespace {

InputError noFolder(const std::string& folder) {
  return {folder, "", "is not a folder and cannot be created"};
}

}  // namespace

void checkFolder(const std::string& folder) {
  namespace fs = std::filesystem;
  checkFolderName(folder);
  std::error_code ignored;
  if ((isPictureFile(folder) || isTableFile(folder)) && !fs::exists(folder, ignored))
    throw InputError(folder, "",
                     message("has the name of a {} file, but the command writes several files into "
                             "a folder; name a folder, such as {}",
                             fileExtension(folder), fs::path(folder).replace_extension().string()));
  // The folders that are missing will be made in the nearest one that is there.
  fs::path there = fs::absolute(folder, ignored);
  while (!fs::exists(fs::symlink_status(there, ignored)) && there != there.parent_path())
    there = there.parent_path();
  if (!fs::is_directory(there, ignored)) throw noFolder(folder);
  if (::access(there.c_str(), W_OK | X_OK) != 0)
    throw InputError(folder, "", message("folder {} cannot be written to", there.string()));
}

void makeFolder(const std::string& folder) {
  checkFolder(folder);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder)) throw noFolder(folder);
}

std::string answerNumber(double value, int digits) {
  return inLanguage(printedNumber(value, digits));
}

std::string answerQuantity(double value, std::string_view unit, int digits) {
  return inLanguage(printedQuantity(value, unit, digits));
}

std::string wroteLine(const std::string& file) {
  return filledLine(Words::tr("wrote %1"), printable(file));
}

std::string wroteLines(const std::vector<std::string>& files) {
  std::string text;
  for (const std::string& file : files)
    if (file != "-") text += wroteLine(file);
  return text;
}

void printError(const std::string& sentence) {
  std::fputs(("asperity: " + printable(sentence) + "\n").c_str(), stderr);
}

void printJson(const nlohmann::ordered_json& answer) {
  fmt::print("{}", jsonFile(answer));
}

}  // namespace asperity
