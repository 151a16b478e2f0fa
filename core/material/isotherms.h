// Measured dynamic moduli as plain values: frequency sweeps at several temperatures, shear moduli
// in Pa. Where they come from: core/material/dma_file.h; what is made of them:
// core/material/temperature_shifts.h and prony_fit.h. Pure functions; any thread.
#pragma once

#include <limits>
#include <vector>

#include "core/base/message.h"

namespace asperity {

/// One value of a sweep.
struct DynamicModulus {
  double frequency = 0;  // Hz
  double storage = 0;    // Pa, G'
  double loss = 0;       // Pa, G''

  bool operator==(const DynamicModulus&) const = default;
};

/// One frequency sweep at one temperature, in the order of rising frequency.
struct Isotherm {
  double temperature = 293.15;  // K, mean of its rows
  std::vector<DynamicModulus> points;
  std::size_t repeats = 0;  // rows beyond one at each frequency, which the points are means of
  double repeatRatio = 1;   // the largest of the moduli over the least at one frequency

  double lowestFrequency() const { return points.front().frequency; }
  double highestFrequency() const { return points.back().frequency; }
};

/// One row as it was measured.
struct MeasuredModulus {
  double temperature = 293.15;  // K
  DynamicModulus modulus{};
  double strainAmplitude = std::numeric_limits<double>::quiet_NaN();  // NaN: not stated
};

/// Rows closer than this in temperature belong to one sweep, unless a user says otherwise.
inline constexpr double kIsothermTolerance = 0.6;  // K

/// Gathers rows into sweeps: rows whose temperatures follow each other within `tolerance` (K) are
/// one isotherm, in the order of rising temperature and frequency whatever the order of the rows;
/// several values at one frequency of a sweep become their geometric mean. Throws InputError where
/// there is no row, a frequency or modulus is not above 0, the temperatures run on without a gap,
/// or a sweep has one frequency alone.
std::vector<Isotherm> groupIsotherms(std::vector<MeasuredModulus> rows,
                                     double tolerance = kIsothermTolerance);

/// "20 °C": how temperatures stand in messages about measurements.
Message celsius(double kelvin);

}  // namespace asperity
