// Shifts isotherms to a master curve by time-temperature superposition (Ferry, Viscoelastic
// Properties of Polymers, ch. 11). Neighbouring isotherms are moved along the logarithm of
// frequency until they agree where they overlap; the shifts add up from the reference temperature.
// Where the curve bends between the points of a sweep, all isotherms are fitted together
// (joint_fit.h).
//
// The reduced frequency is f a_T, the reduced modulus G / b_T: a_T > 1 where the material is slower
// than at the reference temperature. Pure functions; any thread; equal input gives equal bits.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "core/material/elastomer.h"
#include "core/material/isotherm_overlap.h"
#include "core/material/isotherms.h"

namespace asperity {

/// The shift of one isotherm in the table.
struct IsothermShift {
  double temperature = 0;    // K
  double log10Shift = 0;     // decades, log10 a_T
  double standardError = 0;  // decades; 0 at the reference
  double log10Vertical = 0;  // decades, log10 b_T
  double fromStorage = 0;    // decades, log10 a_T from G' alone; NaN: not available
  double fromLoss = 0;       // decades, log10 a_T from G'' alone; NaN: not available
};

/// A point of the master curve.
struct MasterPoint {
  DynamicModulus modulus;    // at the reduced frequency
  std::size_t isotherm = 0;  // from which it comes
};

/// What vertical shifts would change of a master curve without them.
struct VerticalEvidence {
  bool isSignificant = false;             // whether more than noise is explained by them
  double residual = 0, residualWith = 0;  // decades, rms of the overlaps without and with them
  double largestShift = 0;                // decades of modulus, between neighbours
  double largestChange = 0;               // decades, of log10 a_T of an isotherm
};

struct MasterCurve {
  double referenceTemperature = 0;    // K
  std::vector<IsothermShift> shifts;  // of every isotherm, rising temperature
  std::vector<Overlap> overlaps;      // of every isotherm with the next warmer one
  std::vector<MasterPoint> points;    // rising reduced frequency
  /// Whether one shift serves both moduli: what different shifts explain is within the noise of the
  /// overlaps, or the shifts nowhere differ by more than a tenth of a decade; and the isotherms
  /// have one shape where they overlap, whatever the shifts.
  bool isThermorheologicallySimple = true;
  // Between the shifts from G' and from G'' alone, where more than noise makes them differ,
  // decades:
  double largestStep = 0;        // from one isotherm to the next
  double largestDifference = 0;  // in the table
  double shapeMisfit = 0;        // decades of modulus, rms, beyond noise and any shifts
  VerticalEvidence vertical;
  /// Whether the shifts are those of a fit of all isotherms together (joint_fit.h) in place of the
  /// sums of the shifts of neighbours.
  bool isFittedTogether = false;

  double lowestFrequency() const { return points.front().modulus.frequency; }  // Hz
  double highestFrequency() const { return points.back().modulus.frequency; }  // Hz
};

/// Makes the master curve. referenceTemperature (K) must lie within the isotherms; between two of
/// them its shift is that of the formula through all shifts (interpolatingFormula), or linear in T
/// where no formula is good. One isotherm is its own master curve, and the reference is its
/// temperature. Throws InputError (--reference-temperature; isotherms that do not overlap, or whose
/// order contradicts their temperatures), and StopRequested within one pair of isotherms after
/// `stop`.
MasterCurve masterCurve(std::span<const Isotherm> isotherms, double referenceTemperature,
                        bool isVertical = false, const std::stop_token& stop = {});

/// Returns the default reference temperature (K): 25 °C, the default temperature of a scene, where
/// it was measured (within kIsothermTolerance), else the nearest isotherm.
double usualReference(std::span<const Isotherm> isotherms);

/// Returns the shifts as the table of a scene.
std::vector<ShiftPoint> shiftTable(const MasterCurve& curve);

}  // namespace asperity
