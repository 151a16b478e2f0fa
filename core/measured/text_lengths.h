// The lengths and the units of lengths that a text table states beside its numbers: steps and
// extents above them, units in the names of columns, in lines of their own and in the corner of a
// matrix; and the step between points by other quantities: counts and lengths, the ends of an axis,
// a speed and a rate (text_steps.cpp). Only the readers of text in this folder use it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/text.h"
#include "core/base/text_table.h"
#include "core/measured/surface_draft.h"

namespace asperity {

/// A length in the header of a file.
struct HeaderLength {
  double value = 0;
  std::optional<StatedUnit> unit{};
  bool hasAxis = false;           // its name is that of a length along one axis
  std::optional<Message> note{};  // what it follows from, where this is not evident

  /// Returns the length in m; without a unit it counts as one.
  double metres() const { return value * (unit ? unit->metres : 1); }
};
/// The ways to name an axis, {}.
inline constexpr WordList kAxisForms(
    "axis {}, {} axis, {}-axis, achse {}, {}-achse, axe {}, axe des {}, eje {}, asse {}", ',');

/// Reads a single length above 0: "10 um", "512"; nothing where the unit is none of length.
std::optional<HeaderLength> lengthIn(std::string_view text);

/// What a length is: the step between two points, or the extent of the whole field.
enum class LengthKind { Step, Extent };

/// Returns the length that the lines above the numbers state along an axis, 'x' or 'y', by its
/// usual names: "X increment: 0.5 um", "Breite: 10 um". Below a line that names an axis alone, as
/// "Y-axis:", lengths are of this axis. Another length without an axis counts for x alone, and two
/// lengths in a line, as "Scan size: 10 um x 20 um", or one named "XY", for x and y. Where two
/// lines contradict each other, it throws InputError, or returns nothing if the user states the
/// spacing.
std::optional<HeaderLength> headerLength(const SurfaceText& in, LengthKind kind, char axis);

/// Returns whether the lines above the numbers state how far measured lines are apart: "Line
/// spacing", "Profilabstand", which say more than "dy".
bool statesLineSpacing(const TextPart& in);

/// Returns the lengths of a field that the header calls width and length, in their order: the first
/// one is that along x. Nothing where it has only one of them.
std::optional<std::pair<HeaderLength, HeaderLength>> widthAndLength(const TextBlock& block);

/// Which entries of the header are searched for a unit: only those for positions or heights, or
/// also a common one such as "Unit".
enum class UnitEntries { Own, AndCommon };

/// Returns the unit that the header states for positions or for heights: in an entry of its own, or
/// in the name of the table of heights.
std::optional<StatedUnit> headerUnit(const TextPart& in, bool ofHeights,
                                     UnitEntries entries = UnitEntries::AndCommon);

/// Returns the text in place of a unit, in the name of the column (-1: there is none) or in the
/// header, that is no known unit. Empty where there is no such text.
std::string unknownUnit(const TextPart& in, int column, bool ofHeights);

/// Returns the unit of a column by its name, else by the header. Throws InputError where it is no
/// unit of length and the user chooses no other one.
std::optional<StatedUnit> columnUnit(const SurfaceText& in, int column, bool ofHeights);

/// The units that the corner of a matrix with positions in its first row and column states: "y\x
/// [um]", "Z [um] | X [mm] / Y [mm]", "mm".
struct CornerUnits {
  std::optional<StatedUnit> x{}, y{}, z{};
  std::string unknownPosition{}, unknownHeight{};
};
CornerUnits cornerUnits(const TextBlock& block);

/// What a header counts: the points of a profile, those of a row of a field, or its rows.
enum class Counted { Points, Columns, Rows };

/// Returns the number that the header states for it: "Number of points: 800", "Zeilen: 40", "800
/// points" in a line of several statements.
std::optional<std::int64_t> statedCount(const TextPart& in, Counted counted);

/// Returns the step between `count` points where the header states their number and the length from
/// the first to the last one: "Axis X", 60, "59.00 um", as MountainsMap writes it, or "Points: 60"
/// and "Traverse length: 59 um". It is also stated by "Points per mm: 1000", and by the first and
/// the last position, "x from 0 to 59 um" or, in two lines, "Start X = 0 um" and "End X = 59 um".
std::optional<HeaderLength> countedStep(const TextPart& in, std::int64_t count, char axis);

/// Returns the way of a stylus between two samples where the header states its speed and their
/// rate: "Scan speed: 0.5 mm/s", "Sampling rate: 1000 Hz".
std::optional<HeaderLength> sampledStep(const TextPart& in);

}  // namespace asperity
