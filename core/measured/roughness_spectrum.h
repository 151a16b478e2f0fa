// Power spectra of measured profiles and topographies in bands that are evenly spaced in the
// logarithm of the wave number, and the line that the method of dimensionality reduction needs for
// an isotropic surface. Pure functions; any thread. No gaps in what is analysed.
//
// Conventions (Persson): C1 is two-sided per wave number, <h^2> = 2 integral C1 dq; C2 is
// isotropic, <h^2> = 2 pi integral C2 q dq. The equivalent line has C_line = pi q C2 (Geike and
// Popov 2007; Popov and Hess, Method of Dimensionality Reduction, ch. 10): in each ring of wave
// numbers as much power as the surface, so its <h^2> and, as <z'^2>, its <|grad h|^2>.
#pragma once

#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/measured/processing_choices.h"
#include "core/measured/spectral_density.h"
#include "core/measured/topography.h"

namespace asperity {

/// Power (m^2, its part of <h^2>) of the waves 0, 1, ..., n/2 of a profile under a Hann window,
/// normalised so that the window takes no power on average.
std::vector<double> hannPowers(std::span<const double> heights);

/// Spectrum of a profile, C1 over q, as it is with the Hann window, without the wave 0.
SpectralDensity hannSpectrum(std::span<const double> heights, double spacing);

/// Wave numbers of a profile between which its spectrum speaks of roughness: from the third wave,
/// because the window mixes each with its neighbours, to half of the highest one, or to where white
/// noise begins: there the spectrum falls less than 1/q for good, which no self-affine surface
/// does, and has no peaks, which a machined one has. The cut-off of the short waves ends it, too.
/// What the radius of a stylus' tip has smoothed is not seen from the heights alone.
struct ReliableBand {
  double from = 0, to = 0;  // 1/m
  bool endsInNoise = false;
};
ReliableBand reliableBand(std::span<const double> heights, double spacing, double shortWaveCut);

/// Powers (m^2) in bands of wave numbers. Band j covers the waves first[j] to first[j + 1] - 1 of
/// the length that they were analysed on; the lowest band has the wave 0 as well.
struct BandPowers {
  double length = 0;               // m; wave k has q = 2 pi k / length
  std::vector<std::size_t> first;  // one more than bands
  std::vector<double> power;

  std::size_t bands() const { return power.size(); }
  double from(std::size_t band) const;    // 1/m, lower edge, half a wave below its first
  double to(std::size_t band) const;      // 1/m, upper edge
  double centre(std::size_t band) const;  // 1/m
  double total() const;                   // m^2
  /// Rms slope that these powers make.
  double rmsSlope() const;
  SpectralDensity density() const;
};

/// Powers of the waves 0, 1, ... gathered in bands, 8 to a decade where there are as many waves.
BandPowers inBands(std::span<const double> powers, double length);

/// The spectra of an isotropic surface: of profiles cut from it, and of its equivalent line.
struct EquivalentSpectra {
  BandPowers profile, line;

  /// Factor of the amplitudes of a measured profile at q that makes it the equivalent line,
  /// sqrt(C_line / C_prof) of the band that q is in.
  double factor(double q) const;
};

/// From a topography without gaps: its two-dimensional spectrum under a Hann window, summed over
/// rings. `form` is subtracted from the whole before (a plane, a paraboloid). `progress` is told
/// the part done, 0 to 1. Throws StopRequested (core/measured/measured_file.h) where `stop` was
/// requested, within a row or the one transform of all of them.
EquivalentSpectra equivalentSpectra(const Topography& topography, FormRemoval form,
                                    const std::stop_token& stop = {},
                                    const std::function<void(double)>& progress = {});

/// From one profile by the Abel relation C_prof(q) = 2 integral from q of C2(q') q' dq' /
/// sqrt(q'^2 - q^2): a wave q' of an isotropic surface appears in a cut at q' cos(phi) with phi
/// uniform. Solved in bands for powers that are not below 0 by expectation and maximisation (Lucy
/// 1974; Richardson 1972), which keeps the sum of the powers. Where a spectrum scatters, powers
/// that cannot be below 0 lean to long waves, so they are tilted by a power law until the mean
/// square slope is what the relation says for certain: twice that of the profile, as cos^2(phi) is
/// 1/2 on average.
EquivalentSpectra equivalentSpectra(const BandPowers& profile);

}  // namespace asperity
