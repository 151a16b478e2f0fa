// Power spectra of measured profiles and topographies, in bands that are evenly spaced in the
// logarithm of the wave number, and the line that the method of dimensionality reduction needs for
// an isotropic surface. Pure functions; any thread. The heights must have no gaps.
//
// Conventions (Persson): C1 is two-sided per wave number, <h^2> = 2 integral C1 dq; C2 is
// isotropic, <h^2> = 2 pi integral C2 q dq. The equivalent line has C_line = pi q C2 (Geike and
// Popov 2007; Popov and Hess, Method of Dimensionality Reduction, ch. 10). In each ring of wave
// numbers it has as much power as the surface, so that its <h^2> equals that of the surface and its
// <z'^2> equals <|grad h|^2>.
#pragma once

#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/measured/processing_choices.h"
#include "core/measured/profile_flaws.h"
#include "core/measured/spectral_density.h"
#include "core/measured/topography.h"

namespace asperity {

/// Returns the powers of the waves 0, 1, ..., n/2 of a profile under a Hann window (m^2, the part
/// of each in <h^2>), normalised so that the window takes no power on average.
std::vector<double> hannPowers(std::span<const double> heights);

/// Returns the spectrum of a profile, C1 over q, under a Hann window and without the wave 0.
/// spacing: m.
SpectralDensity hannSpectrum(std::span<const double> heights, double spacing);

/// The wave numbers of a profile between which its spectrum describes its roughness. The band
/// begins at the third wave, because the window mixes each wave with its neighbours. It ends at
/// half of the highest wave number, or where white noise begins: from there on the spectrum falls
/// more slowly than 1/q, which the spectrum of no self-affine surface does, and has no peaks, which
/// that of a machined surface has. The cut-off of the short waves ends the band as well, and so
/// does the noise of heights that are rounded to coarse steps: it is white or, of a stair, confined
/// to long waves, and matters where the spectrum is less than four times as high. Smoothing by the
/// tip of a stylus cannot be recognized from the heights alone.
struct ReliableBand {
  double from = 0, to = 0;  // 1/m
  bool endsInNoise = false;
};
ReliableBand reliableBand(std::span<const double> heights, double spacing, double shortWaveCut,
                          const HeightSteps& steps = {});

/// Powers (m^2) in bands of wave numbers. Band j covers the waves first[j] to first[j + 1] - 1 of
/// the analysed length; the lowest band contains the wave 0 as well.
struct BandPowers {
  double length = 0;               // m; wave k has q = 2 pi k / length
  std::vector<std::size_t> first;  // one more than bands
  std::vector<double> power;

  std::size_t bands() const { return power.size(); }
  double from(std::size_t band) const;    // 1/m, lower edge, half a wave below its first
  double to(std::size_t band) const;      // 1/m, upper edge
  double centre(std::size_t band) const;  // 1/m
  double total() const;                   // m^2
  /// Returns the rms slope that follows from these powers.
  double rmsSlope() const;
  SpectralDensity density() const;
};

/// Gathers the powers of the waves 0, 1, ... in bands: 8 per decade where there are as many waves.
BandPowers inBands(std::span<const double> powers, double length);

/// The spectra of an isotropic surface: that of profiles cut from it, and that of its equivalent
/// line.
struct EquivalentSpectra {
  BandPowers profile, line;

  /// Returns the factor by which the amplitudes of a measured profile at q are multiplied to give
  /// the equivalent line: sqrt(C_line / C_prof) of the band that contains q.
  double factor(double q) const;
};

/// Returns the spectra of a topography without gaps. The rows give the spectrum that the surface
/// has if it is isotropic, by the Abel relation (below). The two-dimensional spectrum under a Hann
/// window, summed over rings, corrects it where the surface is not: by one step of expectation and
/// maximisation from the isotropic spectrum to these rings, which takes into account how the window
/// across the rows spreads each wave. Few rows spread long waves over most of the rings, and rows
/// far apart fold short waves into them; the spectrum is then that of the rows. `form` is
/// subtracted from the whole topography before (a plane, a paraboloid). `progress` is called with
/// the finished part, 0 to 1. Throws StopRequested (core/base/stop.h) where `stop` was requested,
/// within a row or within the one transform of all rows.
EquivalentSpectra equivalentSpectra(const Topography& topography, FormRemoval form,
                                    const std::stop_token& stop = {},
                                    const std::function<void(double)>& progress = {});

/// Returns the spectra of an isotropic surface of which one profile is known, by the Abel relation
/// C_prof(q) = 2 integral from q of C2(q') q' dq' / sqrt(q'^2 - q^2): a wave q' of the surface
/// appears in a cut at q' cos(phi), with phi uniformly distributed. The relation is solved in bands
/// for powers that are not negative by expectation and maximisation (Lucy 1974; Richardson 1972),
/// which preserves the sum of the powers. For a scattered spectrum this method favours long waves.
/// The powers are therefore multiplied by a power law of q so that their mean square slope is the
/// one that the relation gives exactly: twice that of the profile, since the mean of cos^2(phi) is
/// 1/2.
EquivalentSpectra equivalentSpectra(const BandPowers& profile);

}  // namespace asperity
