// What the paper reads from its curves by eye, defined once: slopes, the regions' borders, the
// plateau. All read averages at one force (index j), optionally without one group of realizations
// (see jackknife). Pure; any thread.
#pragma once

#include <cstddef>
#include <vector>

#include "core/friction/study.h"

namespace asperity {

/// Exponent n of mu ~ v^n, fitted to velocities `first` to `last` (indices, both included).
double velocityExponent(const Study& study, std::size_t j, std::size_t first, std::size_t last,
                        int leftOut = Study::kAll);

struct Plateau {
  double velocity = 0;      // m/s
  double normalizedMu = 0;  // mu / rms slope of the line
};

/// The curve's maximum, from the parabola in ln v through the three highest neighbours.
Plateau plateauOf(const Study& study, std::size_t j, int leftOut = Study::kAll);

/// Where the curve leaves one region for the next (m/s); NaN where it never does.
struct RegionBorders {
  double endOfLinear = 0;  // I to II: kBelowLine below its line through region I
  double toPlateau = 0;    // II to III: kOfPlateau of the maximum reached
  double offPlateau = 0;   // III to IV: below that again
};
inline constexpr double kBelowLine = 0.9;
inline constexpr double kOfPlateau = 0.9;

/// Region I is that of the lowest velocity.
RegionBorders regionBorders(const Study& study, std::size_t j, int leftOut = Study::kAll);

/// mu / rms slope at a velocity between those computed, straight in logarithms.
double normalizedMuAt(const Study& study, std::size_t j, double velocity,
                      int leftOut = Study::kAll);

/// mu / (tau v grad^2 / h) in the limit of low velocity, read at velocity i: beta Fbar^-alpha of
/// Eq. (5).
double lowVelocityFactor(const Study& study, std::size_t j, std::size_t i,
                         int leftOut = Study::kAll);

}  // namespace asperity
