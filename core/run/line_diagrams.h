// The rigid line in numbers, as diagrams: its heights, its spectrum with the Hurst exponent read
// back from it, and how pressures and slopes are distributed where the bodies touch. Pure; any
// thread.
#pragma once

#include <span>
#include <vector>

#include "core/chart/diagram.h"
#include "core/friction/curve_features.h"
#include "core/run/frame.h"
#include "core/scene/scene.h"
#include "core/surface/line.h"

namespace asperity {

/// The power spectral density C(q) (m^3, two-sided) over the wave number q (1/m), geometric means
/// of equal stretches of log q, and the power law through those above the roll-off: C ~ q^(-2H-1).
struct SpectrumReading {
  std::vector<double> waveNumber, density;
  LineFit fit;          // ln C over ln q
  bool hasFit = false;  // more than two stretches
  double fitFrom = 0;   // 1/m
  double hurst() const { return -0.5 * (fit.slope + 1); }
};

/// Of the scene's first line. Throws InputError where it cannot be made.
SpectrumReading readSpectrum(const Scene& scene);

/// C(q), what was wanted and what was fitted, on logarithmic axes.
DiagramSheet spectrumSheet(const Scene& scene);

struct LinePoint {
  double x = 0;       // m
  double height = 0;  // m
};

/// One period from x = 0 to x = length, both included: every node, and between two nodes the cubic
/// with the node's heights and slopes (corners stay corners), at equal distances, so that there are
/// at least `atLeast` points. A line without slopes is straight between its nodes.
std::vector<LinePoint> sampledLine(const Line& line, std::size_t atLeast);

/// The line of a scene over one period with its statistics, and its spectrum below where it has one
/// of its own and is not given by a formula.
DiagramSheet surfaceSheet(const Scene& scene, const Line& line);

/// Shares of the points in equal stretches of [from, to], of those inside.
struct Histogram {
  double from = 0, to = 1;
  std::vector<double> share;
  double width() const {  // of a stretch; 0 without any
    return share.empty() ? 0 : (to - from) / static_cast<double>(share.size());
  }
};

/// `bins` stretches; values outside are left out of the stretches but counted in the whole. Each
/// counts by its weight, or all alike without weights.
Histogram histogramOf(const std::vector<double>& values, double from, double to, std::size_t bins,
                      std::span<const double> weights = {});

/// Slopes of the line over the elements in contact and over all, in rms slopes; positive where the
/// line climbs against the elastomer that it meets.
struct SlopeStatistics {
  Histogram whole, contact;
  double climbing = 0;    // share of the contact with a positive slope; 1: one-sided
  double rmsContact = 0;  // rms slope in contact over that of the line
};
SlopeStatistics slopeStatistics(const Frame& frame);

/// Pressures by contact length, and slopes in contact against the whole line.
DiagramSheet statisticsSheet(const Frame& frame);

}  // namespace asperity
