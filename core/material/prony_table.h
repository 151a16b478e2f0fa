// Reads a Prony series from a table of relaxation times and moduli, as people write it, by the
// names of its columns and of the lines around it. Two of relaxation time, modulus and viscosity
// describe an arm, G_i = eta_i / tau_i; logarithms of them are read, too. prony_arms.cpp reads the
// rows. Pure; any thread. Failure: InputError that names the file and the column or line.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text_table.h"
#include "core/material/dma_columns.h"
#include "core/material/prony_file.h"

namespace asperity {

/// Returns nothing where the table is none of a Prony series.
std::optional<RawSeries> tableSeries(TextTable table, const std::string& name,
                                     const PronyChoices& choices);

/// Returns a table of the arms that a text states as named numbers, one or several in a line: "G1 =
/// 2 MPa", "tau_1: 0.1 s", "G1;2;MPa". All other lines stand above the table. Nothing where the
/// text states none. Throws InputError for arms that are not complete (prony_lines.cpp).
std::optional<TextTable> tableOfNamedArms(std::string_view text, const std::string& name);

// ---- Names --------------------------------------------------------------------------------------

/// Returns a name as compactName does, with "inf", "tau" and "eta" for these signs: "ginf" for
/// "G_∞". The functions below take such words.
std::string seriesWord(std::string_view text);

/// Returns whether a word names the equilibrium modulus.
bool isEquilibrium(std::string_view word);
bool isInstantaneous(std::string_view word);

/// Returns whether a word names relaxation times, or their inverse; omega alone may be a frequency.
bool isRelaxationTime(std::string_view word);

/// Returns whether a word names the inverse of relaxation times: beta, as LS-DYNA writes it, or
/// omega_i.
bool isDecayRate(std::string_view word);

/// Returns whether a column's name is that of the moduli of arms, or of parts of a modulus.
bool isArmModulus(std::string_view name);

/// Returns whether a word names the viscosities of arms, eta_i = G_i tau_i.
bool isArmViscosity(std::string_view word);

/// Returns whether a word has an index, as only arms have: "gi", "etak".
bool hasArmIndex(std::string_view word);

/// The modulus of which the numbers of a column are parts, by its name.
enum class PartsOf { Unknown, Instantaneous, Equilibrium };
PartsOf partsByName(std::string_view word);

// ---- Rows (prony_arms.cpp) ----------------------------------------------------------------------

/// The block of a series, with what the user states about the file, and the series that is made.
struct SeriesBlock : TextPart {
  const std::string& name;  // of the file
  const PronyChoices& choices;
  RawSeries& series;
};

/// What the rows of a table hold. Weights are in the unit of the series.
struct SeriesRows {
  TextColumn column{};  // of the weights, with their unit
  PartsOf parts = PartsOf::Unknown;
  std::vector<double> weights{}, times{};      // times in s; NaN: a row has none
  double equilibrium = RawSeries::kNotStated;  // of the row without a relaxation time
  double sum = 0, most = 0;                    // of the weights of the other rows
};

/// Reads the arms of a block into the terms of a series, with notes on what was computed, assumed
/// and left out; nothing where the block has none. The names and numbers of the table are changed:
/// logarithms are undone. Throws InputError where the block has a part of a series.
std::optional<SeriesRows> readArms(TextTable& table, TextBlock& block, const std::string& name,
                                   const PronyChoices& choices, RawSeries& series);

}  // namespace asperity
