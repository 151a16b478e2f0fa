// The choices for every step between the heights of a measured surface and one period of a rigid
// line, as plain values. The enumerators have the order of the words of the scene's keys; the first
// one is the default.
#pragma once

namespace asperity {

enum class GapHandling { Refuse, Interpolate };
enum class FormRemoval { Line, None, Mean, Parabola };
/// How the ends of a profile meet where its period is repeated.
enum class Seam { Mirror, Blend, RandomPhases, Periodic };
enum class LineKind { AsMeasured, IsotropicEquivalent };
/// Which side of the measured surface touches the elastomer: its summits, since heights point out
/// of a surface, or its valleys.
enum class ContactSide { Summits, Valleys };
enum class ProfileDirection { AlongX, AlongY };

/// The steps in the order in which they are done (ISO 21920-3): gaps and outliers, form, short
/// waves, long waves; then the seam.
struct ProcessingChoices {
  GapHandling gaps = GapHandling::Refuse;
  double outliers = 0;  // multiples of the median deviation; 0: all heights are kept
  FormRemoval form = FormRemoval::Line;
  double shortWaveCut = 0;  // m, cut-off wavelength (lambda_s); 0: none
  double longWaveCut = 0;   // m, cut-off wavelength (lambda_c); 0: none
  Seam seam = Seam::Mirror;
  double blendLength = 0;  // m; 0: a tenth of the profile

  bool operator==(const ProcessingChoices&) const = default;
};

}  // namespace asperity
