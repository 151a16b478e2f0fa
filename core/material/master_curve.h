// Shifts isotherms to a master curve by time-temperature superposition (Ferry, Viscoelastic
// Properties of Polymers, ch. 11). Neighbouring isotherms are moved along the logarithm of
// frequency until they agree where they overlap; the shifts add up from the reference temperature.
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
  double temperature = 0;      // K
  double log10Shift = 0;       // decades, log10 a_T
  double standardError = 0;    // decades; 0 at the reference
  double log10Vertical = 0;    // decades, log10 b_T
  double fromStorage = 0;      // decades, log10 a_T from G' alone; NaN: not available
  double fromLoss = 0;         // decades, log10 a_T from G'' alone; NaN: not available
  double differenceError = 0;  // decades, standard error of the difference of these two
};

/// A point of the master curve.
struct MasterPoint {
  DynamicModulus modulus;    // at the reduced frequency
  std::size_t isotherm = 0;  // from which it comes
};

struct MasterCurve {
  double referenceTemperature = 0;    // K
  std::vector<IsothermShift> shifts;  // of every isotherm, rising temperature
  std::vector<Overlap> overlaps;      // of every isotherm with the next warmer one
  std::vector<MasterPoint> points;    // rising reduced frequency
  /// Whether one shift serves both moduli: the shifts from G' and from G'' alone nowhere differ by
  /// more than a tenth of a decade and three standard errors, which count the scatter of all steps.
  bool isThermorheologicallySimple = true;
  double largestDifference = 0;  // decades, between the two tables
  double largestStep = 0;        // decades, the same from one isotherm to the next

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

/// Returns whether vertical shifts explain the differences between the moduli of `plain`, the curve
/// without them: they leave none that is significant, and remove a significant part of each.
bool explainsDifferences(const MasterCurve& vertical, const MasterCurve& plain);

/// Returns the default reference temperature (K): 25 °C, the default temperature of a scene, where
/// it was measured (within kIsothermTolerance), else the nearest isotherm.
double usualReference(std::span<const Isotherm> isotherms);

/// Returns the shifts as the table of a scene.
std::vector<ShiftPoint> shiftTable(const MasterCurve& curve);

}  // namespace asperity
