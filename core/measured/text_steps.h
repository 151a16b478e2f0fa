// The step between the points of a text table where its header states it by other quantities:
// counts and lengths, the ends of an axis, a speed and a rate. Only the readers of text in this
// folder use it.
#pragma once

#include <cstdint>
#include <optional>

#include "core/base/text_table.h"
#include "core/measured/text_lengths.h"

namespace asperity {

/// What a header counts: the points of a profile, those of a row of a field, or its rows.
enum class Counted { Points, Columns, Rows };

/// Returns the number that the header states for it: "Number of points: 800", "Zeilen: 40", "800
/// points" in a line of several statements.
std::optional<std::int64_t> statedCount(const TextTable& table, const TextBlock& block,
                                        Counted counted);

/// Returns the step between `count` points where the header states their number and the length from
/// the first to the last one: "Axis X", 60, "59.00 um", as MountainsMap writes it, or "Points: 60"
/// and "Traverse length: 59 um". It is also stated by "Points per mm: 1000", and by the first and
/// the last position, "x from 0 to 59 um" or, in two lines, "Start X = 0 um" and "End X = 59 um".
std::optional<HeaderLength> countedStep(const TextTable& table, const TextBlock& block,
                                        std::int64_t count, char axis);

/// Returns the way of a stylus between two samples where the header states its speed and their
/// rate: "Scan speed: 0.5 mm/s", "Sampling rate: 1000 Hz".
std::optional<HeaderLength> sampledStep(const TextTable& table, const TextBlock& block);

}  // namespace asperity
