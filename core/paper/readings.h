// Quantities that the paper reads from its curves by eye, each defined once: slopes, the regions'
// borders, the plateau. All use averages at one force (index j), optionally without one group of
// realizations (see jackknife). Pure; any thread.
#pragma once

#include <cstddef>
#include <vector>

#include "core/friction/curve_features.h"
#include "core/friction/jackknife.h"

namespace asperity {

/// Returns the exponent n of mu ~ v^n, fitted to velocities `first` to `last` (indices, both
/// included).
double velocityExponent(const GroupedMeans& means, std::size_t j, std::size_t first,
                        std::size_t last, int leftOut = GroupedMeans::kAll);

struct Plateau {
  double velocity = 0;      // m/s
  double normalizedMu = 0;  // mu / rms slope of the line
};

/// Returns the curve's maximum, from the parabola in ln v through the highest value and its
/// neighbours.
Plateau findPlateau(const GroupedMeans& means, std::size_t j, int leftOut = GroupedMeans::kAll);

/// Returns the borders; region I is the region of the lowest velocity.
RegionBorders regionBorders(const GroupedMeans& means, std::size_t j,
                            int leftOut = GroupedMeans::kAll, const BorderRule& rule = {});

/// Returns mu / rms slope at a velocity between computed ones, by linear interpolation of
/// logarithms.
double normalizedMuAt(const GroupedMeans& means, std::size_t j, double velocity,
                      int leftOut = GroupedMeans::kAll);

/// Returns mu / (tau v grad^2 / h) in the limit of low velocity, at velocity i: beta Fbar^-alpha of
/// Eq. (5).
double lowVelocityFactor(const GroupedMeans& means, std::size_t j, std::size_t i,
                         int leftOut = GroupedMeans::kAll);

/// mu compared with Eq. (8), where the whole line is in contact on every realization.
struct FullContact {
  int points = 0;
  double toResolved = 0;  // largest |mu / Eq. (8) - 1| with the rms slope of the line's segments
  double toSpectral = 0;  // the same with the slope of the spectrum: the resolution of the line
};
FullContact compareFullContact(const GroupedMeans& means);

/// Returns F_N (N) for a dimensionless force: Fbar G h L, Eq. (14).
double forceAt(const Scene& scene, double dimensionlessForce);

/// Returns the velocity (m/s) at which Eq. (13) has this value.
double velocityAt(double dimensionlessVelocity, const Scene& scene, double rmsSlope);

/// Returns the dimensionless velocity at which region I of Eq. (11) meets its plateau; f(Fbar) of
/// Eq. (16).
double meetingVelocity(double dimensionlessForce, double hurst);

/// The dimensionless forces for exponents of zone 1 (partial contact), the same for every figure.
/// alpha depends on this window: curves of ln mu over ln Fbar are not quite straight.
inline constexpr double kZone1From = 1e-3, kZone1To = 0.1;
bool isInZone1(double dimensionlessForce, double to = kZone1To);

/// Return Eq. (5)'s exponent and prefactor in zone 1, from forces at velocity index 0. alpha is the
/// slope of ln mu over ln Fbar up to `to`. beta belongs to alpha = H/(1+H) and is the mean of the
/// logarithm up to kBetaUpTo: it is used in Eq. (11), which must hold until contact is complete.
double fitAlpha(const GroupedMeans& means, int leftOut = GroupedMeans::kAll, double to = kZone1To);
double fitBeta(const GroupedMeans& means, int leftOut = GroupedMeans::kAll);
inline constexpr double kBetaUpTo = 1;

/// Returns thirteen forces that cover the window, and one velocity in the limit of slow sliding.
std::vector<LoadCase> zone1Cases(const Scene& scene, double rmsSlope);

/// Returns forces with nine velocities each around the maximum of its curve.
std::vector<LoadCase> plateauCases(const Scene& scene, double rmsSlope,
                                   const std::vector<double>& normalForces);

}  // namespace asperity
