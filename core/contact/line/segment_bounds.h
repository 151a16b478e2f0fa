// Bounds and integrals of whole segments of one length and of blocks of them, many at a time; the
// same bits on every instruction set. Pure functions.
#pragma once

#include <cstddef>
#include <span>

#include "core/contact/line/block_level.h"

namespace asperity {

/// Segment k has the rises rise[k] and rise[k + 1] (m) at its ends and the slopes slopeIn[k] and
/// slopeOut[k] there; it becomes block k of `blocks`, which has as many. length: m, of each.
/// Bounds by control points (a cubic lies within theirs), integrals exactly.
void boundSegments(const double* rise, const double* slopeIn, const double* slopeOut,
                   std::size_t count, double length, BlockLevel& blocks);

/// The same of one segment; rise: at its two ends.
SegmentBounds boundSegment(const double* rise, double slopeIn, double slopeOut, double length);

/// Blocks of four straight segments each, as far as whole ones go: of their rises at all ends and
/// the slope of each.
void boundStraightFours(const double* rise, const double* slope, std::size_t count, double length,
                        BlockLevel& blocks);

/// Blocks of four of a finer level's each, as far as whole ones go.
void mergeFours(const BlockLevel& finer, BlockLevel& blocks);

/// The first of the lowest of some values, of which there is at least one.
std::size_t placeOfLowest(std::span<const double> values);

}  // namespace asperity
