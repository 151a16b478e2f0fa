// Statistics of the rigid line as diagrams: its heights, its spectrum with the Hurst exponent
// fitted to it, and the distributions of pressures and slopes in contact. Pure; any thread.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "core/chart/diagram.h"
#include "core/friction/curve_features.h"
#include "core/run/frame.h"
#include "core/scene/scene.h"
#include "core/surface/line.h"

namespace asperity {

/// The power spectral density C(q) (m^3, two-sided) over the wave number q (1/m), geometric means
/// over equal intervals of log q, and the power law C ~ q^(-2H-1) fitted to them: above the
/// roll-off of a self-affine line; for a line from a file where the points follow one.
struct SpectrumReading {
  std::vector<double> waveNumber, density;
  LineFit fit;          // ln C over ln q
  bool hasFit = false;  // false: at most two intervals, or no power law
  double fitFrom = 0, fitTo = std::numeric_limits<double>::infinity();  // 1/m
  bool isFitted(double q) const { return q >= fitFrom && q <= fitTo; }
  double hurst() const { return -0.5 * (fit.slope + 1); }
};

/// Reads the spectrum of the scene's first line. Throws InputError where it cannot be made.
SpectrumReading readSpectrum(const Scene& scene);

/// Returns the diagram of C(q), of the line, as prescribed and as fitted, on logarithmic axes.
DiagramSheet spectrumSheet(const Scene& scene);

struct LinePoint {
  double x = 0;       // m
  double height = 0;  // m
};

/// Returns one period from x = 0 to x = length, both included: every node, and between two nodes
/// the cubic with the node's heights and slopes (corners stay corners), at equal distances, with at
/// least `atLeast` points in total. A line without slopes is straight between its nodes.
std::vector<LinePoint> sampledLine(const Line& line, std::size_t atLeast);

/// Returns the line of a scene over one period with its statistics, and its spectrum below if it is
/// not given by a formula.
DiagramSheet surfaceSheet(const Scene& scene, const Line& line);

/// Parts of the points in equal intervals of [from, to], relative to the points inside.
struct Histogram {
  double from = 0, to = 1;
  std::vector<double> share;
  double width() const {  // of an interval; 0 without any
    return share.empty() ? 0 : (to - from) / static_cast<double>(share.size());
  }
};

/// Makes `bins` intervals; values outside belong to no interval but count in the total. Each value
/// has its weight, or all have the same without weights.
Histogram makeHistogram(const std::vector<double>& values, double from, double to, std::size_t bins,
                        std::span<const double> weights = {});

/// Returns the standard normal distribution from -most to most, in per cent of a histogram's
/// intervals of this width.
DiagramSeries normalDistribution(double most, double width);

/// Slopes of the line over the elements in contact and over all, in units of the rms slope;
/// positive where the line climbs against the approaching elastomer.
struct SlopeStatistics {
  Histogram whole, contact;
  double climbing = 0;    // part of the contact with a positive slope; 1: one-sided
  double rmsContact = 0;  // rms slope in contact over that of the line
};
SlopeStatistics slopeStatistics(const Frame& frame);

/// Returns the distributions of pressure by contact length, and of slopes in contact and on the
/// whole line.
DiagramSheet statisticsSheet(const Frame& frame);

}  // namespace asperity
