// Reads Prony series from files of finite-element programs. Such a file often has several
// materials, and values at several temperatures: the modulus is that of the material with the
// series, and all values are those of one temperature. Pure; any thread.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/material/elastomer.h"
#include "core/material/prony_file.h"

namespace asperity {

/// Reads the keywords of Abaqus or LS-DYNA, or the commands of Ansys; nothing where the text has
/// none of them. Throws InputError (`name`), also for materials of LS-DYNA that are not read.
std::optional<RawSeries> keywordSeries(std::string_view text, const std::string& name,
                                       const PronyChoices& choices);

// ---- What the readers share

struct KeywordLine {
  std::string_view file{};           // its name
  std::string_view text{};           // as it was written
  std::size_t number = 0;            // 0: there is no such line
  std::vector<std::string> words{};  // separated by commas, in lower case, without blanks

  /// Returns a word; empty beyond the last one.
  std::string word(std::size_t index) const;
  /// Returns the number in a place, counted from 0. Throws InputError where there is none.
  double numberAt(std::size_t index) const;
  /// Returns the same; nothing where the place is empty.
  std::optional<double> optionalNumberAt(std::size_t index) const;
  /// Returns "line 4", by which errors name it.
  std::string key() const;
  /// Throws InputError that names the file and the line.
  [[noreturn]] void fail(const Message& message) const;
};

/// The file that is read.
struct KeywordFile {
  const std::vector<KeywordLine>& lines;
  const std::string& name;
  const PronyChoices& choices;
  bool hasModulus = true;  // whether its modulus is read, or left to the choices
};

/// Returns the reference temperature of a shift in K. absoluteZero: in the file's unit, where the
/// file states it.
double readReference(double number, std::optional<double> absoluteZero, const PronyChoices& choices,
                     RawSeries& series);

/// Returns the note on a shift that is not read.
Message shiftLeftOut(std::string keyword);

/// Adds the note on a file with several materials, of which `material` has the series.
void addMaterialNote(const std::string& material, std::size_t materials, RawSeries& series);

/// A table whose rows hold at one temperature each.
struct TemperatureRows {
  KeywordLine line{};  // that begins the table, by which errors name it
  /// In the unit of the file; nothing where a row states none, which finite-element programs read
  /// as 0. A single row at 0 states no temperature either: programs write 0 where none was chosen.
  std::vector<std::optional<double>> temperatures{};
};

/// Returns the row to read of each table, all of one temperature: that of the shift, or the chosen
/// one, or the only one of the file. Sets the temperature of the series and adds notes on what was
/// assumed. Throws InputError where a table has no row within the tolerance, or where there are
/// several temperatures and none is chosen.
std::vector<std::size_t> chooseRows(const std::vector<TemperatureRows>& tables,
                                    std::optional<double> absoluteZero, const KeywordFile& file,
                                    RawSeries& series);

// ---- The readers; nothing where the lines hold no series of the program

std::optional<RawSeries> abaqusSeries(const KeywordFile& file);
std::optional<RawSeries> ansysSeries(const KeywordFile& file);
std::optional<RawSeries> dynaSeries(const KeywordFile& file);

}  // namespace asperity
