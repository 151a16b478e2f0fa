// Measured dynamic moduli as plain values: rows of one strain amplitude, and frequency sweeps at
// several temperatures made of them; shear moduli in Pa. core/material/dma_file.h reads the rows;
// core/material/master_curve.h and prony_fit.h make a material of the sweeps. Pure functions; any
// thread.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/statistics.h"

namespace asperity {

/// The dynamic modulus at one frequency.
struct DynamicModulus {
  double frequency = 0;  // Hz
  double storage = 0;    // Pa, G'
  double loss = 0;       // Pa, G''

  bool operator==(const DynamicModulus&) const = default;
};

/// The temperatures of a sweep that rise or fall with frequency (temperature_drift.h).
struct TemperatureDrift {
  double from = 0, to = 0;  // K, the coldest and the warmest of them
  bool isRising = true;     // with frequency
  bool isRemoved = false;   // whether the moduli were interpolated to one temperature
};

/// One frequency sweep at one temperature, by rising frequency.
struct Isotherm {
  double temperature = 293.15;  // K, mean of its rows, or to which they were interpolated
  std::vector<DynamicModulus> points;
  std::size_t repeats = 0;  // rows beyond the first one at each frequency; the points are means
  double repeatRatio = 1;   // the largest of the moduli over the least at one frequency
  std::optional<TemperatureDrift> drift{};
  bool isOfRamp = false;  // interpolated between the temperatures of slow ramps (isothermsOfRamp)

  double lowestFrequency() const { return points.front().frequency; }
  double highestFrequency() const { return points.back().frequency; }
};

/// One measured row.
struct MeasuredModulus {
  double temperature = 293.15;  // K
  DynamicModulus modulus{};
  double strainAmplitude = kNaN;  // NaN: not stated
};

/// Frequencies with a smaller relative difference count as one.
inline constexpr double kSameFrequency = 1e-4;
/// Strain amplitudes count as one up to this ratio.
inline constexpr double kSameStrain = 1.2;

/// Keeps the rows of the chosen strain amplitude, if one is chosen, and returns the median of the
/// remaining ones; NaN where no row states one. Filled rubber is softer the more it is strained
/// (Payne effect), so a master curve belongs to one amplitude. Amplitudes that count as one may
/// differ between temperatures and frequencies. Throws InputError (`name`) where sweeps at one
/// temperature (within `tolerance`, K) were measured at several amplitudes and none is chosen, and
/// (--strain) where no amplitude is close to the chosen one.
double chooseStrain(std::vector<MeasuredModulus>& rows, std::optional<double> chosen,
                    double tolerance, const std::string& name);

/// Rows belong to one sweep while neighbouring temperatures differ by at most this, unless a user
/// chooses another tolerance.
inline constexpr double kIsothermTolerance = 0.6;  // K
/// Rows over more than so many tolerances are no sweep at a constant temperature.
inline constexpr double kWideSweep = 6;
/// Returns the rows of each sweep. rows: by rising temperature; tolerance: K.
std::vector<std::span<const MeasuredModulus>> sweepsOf(std::span<const MeasuredModulus> rows,
                                                       double tolerance);

/// Groups rows into sweeps, by rising temperature and frequency whatever the order of the rows.
/// Rows whose temperatures follow each other within `tolerance` (K) are one isotherm; several
/// values at one frequency of a sweep become their geometric mean. A temperature that drifts within
/// a sweep by more than the tolerance is removed where it can be (removeDrift). Rows without such
/// sweeps may be ramps of temperature (isothermsOfRamp). Throws InputError where there is no row, a
/// frequency or modulus is out of range, the temperatures of a sweep drift over more than a few
/// tolerances without a gap, or a sweep has only one frequency, and the rows are no ramps.
std::vector<Isotherm> groupIsotherms(std::vector<MeasuredModulus> rows,
                                     double tolerance = kIsothermTolerance);

}  // namespace asperity
