#include "core/run/line_diagrams.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "core/base/intervals.h"
#include "core/base/number_text.h"
#include "core/base/statistics.h"
#include "core/contact/line/polynomial.h"
#include "core/measured/spectral_density.h"
#include "core/surface/line_source.h"
#include "core/surface/spectrum.h"

namespace asperity {
namespace {

constexpr double kBandsPerDecade = 16;
/// Densities that are smaller, relative to the greatest one, are rounding errors.
constexpr double kMinDensity = 1e-22;
constexpr double kMaxSlopes = 4;  // rms slopes shown

double lowestWave(double length) {
  return 2 * std::numbers::pi / length;
}

/// Returns geometric means over equal bands of log q.
SpectralDensity bandMeans(const FourierLine& modes) {
  const double lowest = lowestWave(modes.length);
  double greatest = 0;
  for (const auto& c : modes.coefficients) greatest = std::max(greatest, std::norm(c));
  std::vector<double> numbers, logWaves, logDensities;
  for (std::size_t j = 0; j < modes.coefficients.size(); ++j) {
    const double square = std::norm(modes.coefficients[j]);
    if (!(square > kMinDensity * greatest)) continue;
    const auto number = static_cast<double>(j + 1);
    numbers.push_back(number);
    logWaves.push_back(std::log(lowest * number));
    logDensities.push_back(std::log(square / lowest));
  }
  constexpr double kCentred = 0.5;  // each power of ten is in the middle of a band
  SpectralDensity spectrum;
  for (const IndexRange& band : logBands(numbers, kBandsPerDecade, kCentred)) {
    const auto meanOf = [&band](const std::vector<double>& values) {
      return mean(std::span(values).subspan(band.begin, band.size()));
    };
    spectrum.waveNumber.push_back(std::exp(meanOf(logWaves)));
    spectrum.density.push_back(std::exp(meanOf(logDensities)));
  }
  return spectrum;
}

/// Returns the spectrum that the scene prescribes, before phases and summits.
SpectralDensity prescribedSpectrum(const Scene& scene, const LineSource& source) {
  const Surface& surface = scene.surface;
  FourierLine modes;
  modes.length = source.length();
  for (const double amplitude :
       selfAffineAmplitudes(static_cast<std::size_t>(source.elements()), surface.hurst,
                            surface.rmsHeight, rollOffMode(surface)))
    modes.coefficients.emplace_back(0.5 * amplitude, 0);
  return bandMeans(modes);
}

/// Returns the widest range of wave numbers, of at least a decade, in which the points follow the
/// power law of a self-affine line with 0 <= H <= 1: the exponents of its lower and its upper half
/// agree. The range is empty where there is none: measured spectra have a roll-off, a cut-off and
/// noise.
std::pair<double, double> powerLawRange(const SpectralDensity& spectrum) {
  constexpr double kScatter = 1;  // rms residual of ln C; there are only a few of the longest waves
  constexpr double kDifference = 0.5;  // of the exponents of the halves: 0.25 of H
  const std::span<const double> q = spectrum.waveNumber, density = spectrum.density;
  const auto fitOver = [&](std::size_t from, std::size_t to) {
    return fitPower(q.subspan(from, to - from), density.subspan(from, to - from));
  };
  std::pair<double, double> widest{1, 0};
  double width = std::log(10);
  for (std::size_t from = 0; from < q.size(); ++from)
    for (std::size_t to = from + 4; to <= q.size(); ++to) {
      if (std::log(q[to - 1] / q[from]) < width) continue;
      const LineFit fit = fitOver(from, to);
      if (fit.slope > -1 || fit.slope < -3 || fit.rmsResidual > kScatter) continue;
      const auto middle = static_cast<std::size_t>(
          std::ranges::lower_bound(q, std::sqrt(q[from] * q[to - 1])) - q.begin());
      if (middle < from + 2 || middle + 2 > to) continue;
      const double lower = fitOver(from, middle).slope, upper = fitOver(middle, to).slope;
      if (std::abs(upper - lower) > kDifference) continue;
      width = std::log(q[to - 1] / q[from]);
      widest = {q[from], q[to - 1]};
    }
  return widest;
}

DiagramSeries seriesOf(const SpectralDensity& spectrum, Message name) {
  DiagramSeries series;
  series.name = std::move(name);
  for (std::size_t i = 0; i < spectrum.waveNumber.size(); ++i)
    series.points.push_back({spectrum.waveNumber[i], spectrum.density[i]});
  return series;
}

/// Returns a histogram as a curve with vertical sides.
DiagramSeries histogramSeries(const Histogram& histogram, Message name, int colour) {
  DiagramSeries series{.name = std::move(name), .colour = colour};
  double edge = histogram.from;
  series.points.push_back({edge, 0});
  for (const double share : histogram.share) {
    series.points.push_back({edge, 100 * share});
    edge += histogram.width();
    series.points.push_back({edge, 100 * share});
  }
  series.points.push_back({edge, 0});
  return series;
}

/// Returns the number of bins by Rice's rule, from the points in contact.
std::size_t countBins(std::size_t points) {
  return std::clamp<std::size_t>(
      static_cast<std::size_t>(2 * std::cbrt(static_cast<double>(points))), 8, 48);
}

std::vector<double> slopesOf(const Frame& frame) {
  std::vector<double> slopes(frame.lineHeight.size());
  for (std::size_t i = 0; i < slopes.size(); ++i) slopes[i] = lineSlopeAt(frame, i);
  return slopes;
}

/// Returns the covered part of each element, 0 outside of contact. Contact ends inside the elements
/// at its edges: all of them are covered by the same part, with which the sum is the length in
/// contact.
std::vector<double> coveredParts(const Frame& frame) {
  const std::size_t n = frame.pressure.size();
  const auto touches = [&](std::size_t i) { return frame.pressure[i % n] > 0; };
  std::vector<double> cover(n);
  double touching = 0, edges = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (!touches(i)) continue;
    cover[i] = 1;
    touching += 1;
    edges += touches(i + 1) && touches(i + n - 1) ? 0 : 1;
  }
  const double covered = frame.state.contactFraction * static_cast<double>(n);
  const double inside = touching - edges;
  if (!(touching > 0) || !(covered > 0)) return cover;
  const bool atEdges = edges > 0 && covered > inside;
  for (std::size_t i = 0; i < n; ++i)
    if (touches(i) && !atEdges)
      cover[i] = covered / touching;
    else if (touches(i) && !(touches(i + 1) && touches(i + n - 1)))
      cover[i] = (covered - inside) / edges;
  return cover;
}

/// Returns the value below which 99 % of the weight lies: the few elements at the edges of contact
/// with the highest loads are far away from all others.
double weightedPercentile99(const std::vector<double>& values, const std::vector<double>& weights) {
  const std::vector<std::size_t> order = ascendingOrder(values);
  double left = 0.99 * std::accumulate(weights.begin(), weights.end(), 0.0);
  for (const std::size_t i : order)
    if ((left -= weights[i]) <= 0) return values[i];
  return values[order.back()];
}

Diagram pressureDiagram(const Frame& frame) {
  Diagram diagram{.x = {"line load p", "N/m", AxisScale::Linear},
                  .y = {"share of length", "%", AxisScale::Linear}};
  const std::vector<double> cover = coveredParts(frame);
  std::vector<double> pressures, weights;
  for (std::size_t i = 0; i < cover.size(); ++i) {
    if (!(cover[i] > 0)) continue;
    pressures.push_back(frame.pressure[i] / cover[i]);  // over the covered part
    weights.push_back(cover[i]);
  }
  if (pressures.empty()) return diagram;
  const double mean = frame.state.normalForce / (frame.state.contactFraction * frame.length);
  double most = weightedPercentile99(pressures, weights);
  if (std::isfinite(mean)) most = std::max(mean, most);
  diagram.series = {
      histogramSeries(makeHistogram(pressures, 0, 1.2 * most, countBins(pressures.size()), weights),
                      "in contact", 0)};
  if (!std::isfinite(mean)) return diagram;
  double highest = 0;
  for (const DiagramPoint& point : diagram.series[0].points) highest = std::max(highest, point.y);
  diagram.series.push_back({.name = "mean, force / length", .isTheory = true});
  diagram.series.back().points = {{mean, 0}, {mean, highest}};
  return diagram;
}

Diagram slopeDiagram(const SlopeStatistics& slopes) {
  Diagram diagram{
      .x = {"slope z\u2032 / rms slope", "", AxisScale::Linear, -kMaxSlopes, kMaxSlopes},
      .y = {"share", "%", AxisScale::Linear},
      .series = {histogramSeries(slopes.whole, "whole line", 1)}};
  if (!slopes.contact.share.empty())
    diagram.series.push_back(histogramSeries(slopes.contact, "in contact", 0));
  diagram.series.push_back(normalDistribution(kMaxSlopes, slopes.whole.width()));
  return diagram;
}

/// Returns the diagram of the rigid body over one period of its line.
Diagram heightDiagram(const Line& line) {
  constexpr std::size_t kPoints = 2000;
  constexpr double kBelow = 0.08, kAbove = 0.2;  // of the range of heights
  constexpr double kFlatHalfHeight = 1e-6;       // m, shown around a line without heights
  Diagram diagram{.x = {"position", "m", AxisScale::Linear, 0, line.length},
                  .y = {"height", "m", AxisScale::Linear}};
  const std::vector<LinePoint> points = sampledLine(line, kPoints);
  if (points.empty()) return diagram;
  auto [low, high] = std::ranges::minmax(points, {}, &LinePoint::height);
  double from = low.height, to = high.height;
  // A line without heights: rounding errors must not be drawn like roughness.
  if (!(to - from > 1e-9 * std::max(std::abs(from), std::abs(to)))) {
    from -= kFlatHalfHeight;
    to += kFlatHalfHeight;
  }
  diagram.y.from = from - kBelow * (to - from);
  diagram.y.to = to + kAbove * (to - from);
  DiagramSeries body{.name = "rigid body", .isBand = true, .isTheory = true};
  for (const LinePoint& point : points)
    body.points.push_back({point.x, point.height, point.height, diagram.y.to});
  diagram.series = {std::move(body)};
  return diagram;
}

}  // namespace

std::vector<LinePoint> sampledLine(const Line& line, std::size_t atLeast) {
  const std::size_t n = line.nodes();
  std::vector<LinePoint> points;
  if (n == 0) return points;
  const bool smooth = line.slopeAfter.size() == n;
  const std::size_t pieces = smooth ? std::max<std::size_t>(1, (atLeast + n - 1) / n) : 1;
  points.reserve(n * pieces + 1);
  for (std::size_t i = 0; i < n; ++i) {
    const double x = static_cast<double>(i) * line.spacing;
    points.push_back({x, line.height[i]});
    const std::size_t next = (i + 1) % n;
    const double step = line.height[next] - line.height[i];
    for (std::size_t k = 1; k < pieces; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(pieces);
      const double rise =
          hermiteRise(t, step, line.spacing, line.slopeAfter[i], line.slopeLeftOf(next));
      points.push_back({x + t * line.spacing, line.height[i] + rise});
    }
  }
  points.push_back({line.length, line.height.front()});
  return points;
}

DiagramSheet surfaceSheet(const Scene& scene, const Line& line) {
  constexpr int kDigits = 4;
  DiagramSheet sheet;
  sheet.title = scene.title.empty() ? Message("Rigid line") : Message(scene.title);
  std::vector<Message> facts{
      message("one period L = {}", printed(line.length, "m", kDigits)),
      message("rms height h = {}", printed(line.rmsHeight, "m", kDigits, Zeros::Keep)),
      message("rms slope = {}", printed(line.rmsSlope, kDigits, Zeros::Keep))};
  if (scene.surface.kind == SurfaceKind::SelfAffine)
    facts.push_back(message("Hurst exponent H = {}", printed(scene.surface.hurst, kDigits)));
  sheet.subtitle = listed(facts);
  if (line.nodes() == 0 || !(line.length > 0)) return sheet;
  sheet.diagrams = {heightDiagram(line)};
  sheet.columns = 1;
  const bool isFormula = LineSource(scene, 1).spectrum(0).coefficients.empty();
  if (isFormula || !(line.rmsHeight > 0)) return sheet;
  DiagramSheet spectrum = spectrumSheet(scene);
  if (spectrum.diagrams[0].series.back().points.size() < 2) return sheet;
  sheet.diagrams.push_back(std::move(spectrum.diagrams[0]));
  sheet.note = std::move(spectrum.note);
  return sheet;
}

SpectrumReading readSpectrum(const Scene& scene) {
  const LineSource source(scene, 1);
  SpectralDensity spectrum = bandMeans(modesOf(source));
  SpectrumReading reading;
  const double rollOff =
      scene.surface.kind == SurfaceKind::SelfAffine ? scene.surface.rollOffWavelength : 0;
  reading.fitFrom = rollOff > 0 ? 2 * std::numbers::pi / rollOff : 0;
  if (hasSurfaceFile(scene.surface))
    std::tie(reading.fitFrom, reading.fitTo) = powerLawRange(spectrum);
  std::vector<double> x, y;
  for (std::size_t i = 0; i < spectrum.waveNumber.size(); ++i) {
    if (!reading.isFitted(spectrum.waveNumber[i])) continue;
    x.push_back(spectrum.waveNumber[i]);
    y.push_back(spectrum.density[i]);
  }
  reading.hasFit = x.size() > 2;
  if (reading.hasFit) reading.fit = fitPower(x, y);
  reading.waveNumber = std::move(spectrum.waveNumber);
  reading.density = std::move(spectrum.density);
  return reading;
}

DiagramSheet spectrumSheet(const Scene& scene) {
  const SpectrumReading reading = readSpectrum(scene);
  Diagram diagram{.x = {"wave number q", "1/m", AxisScale::Logarithmic},
                  .y = {"spectral density C", "m\u00B3", AxisScale::Logarithmic}};
  DiagramSheet sheet;
  DiagramSeries line = seriesOf({reading.waveNumber, reading.density}, "this line");
  line.mark = SeriesMark::Circle;
  line.stroke = SeriesStroke::None;
  line.colour = 0;
  if (scene.surface.kind == SurfaceKind::SelfAffine) {
    DiagramSeries prescribed = seriesOf(prescribedSpectrum(scene, LineSource(scene, 1)),
                                        message("prescribed, H = {:.3g}", scene.surface.hurst));
    prescribed.isTheory = true;
    diagram.series.push_back(std::move(prescribed));
  }
  diagram.series.push_back(std::move(line));
  if (reading.hasFit) {
    DiagramSeries fitted{.name = message("fitted, H = {:.3f}", reading.hurst()),
                         .stroke = SeriesStroke::Dashed,
                         .colour = 1};
    for (const double q : reading.waveNumber)
      if (reading.isFitted(q))
        fitted.points.push_back(
            {q, std::exp(reading.fit.intercept + reading.fit.slope * std::log(q))});
    diagram.series.push_back(std::move(fitted));
  }
  const bool hasExponent = reading.hasFit || scene.surface.kind == SurfaceKind::SelfAffine;
  sheet.note =
      hasExponent
          ? Message(
                "C(q) ~ q\u207B\u00B2\u1D34\u207B\u00B9 is two-sided, h\u00B2 = 2 \u222B C dq; cut "
                "off at \u03C0 over the element spacing. Points are means over equal intervals of "
                "log q.")
          : Message(
                "C(q) is two-sided, h\u00B2 = 2 \u222B C dq; cut off at \u03C0 over the element "
                "spacing. Points are means over equal intervals of log q.");
  sheet.diagrams = {std::move(diagram)};
  return sheet;
}

Histogram makeHistogram(const std::vector<double>& values, double from, double to, std::size_t bins,
                        std::span<const double> weights) {
  Histogram histogram{from, to, std::vector<double>(bins)};
  if (values.empty()) return histogram;
  const double whole = weights.empty() ? static_cast<double>(values.size())
                                       : std::accumulate(weights.begin(), weights.end(), 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double bin = (values[i] - from) / histogram.width();
    if (bin >= 0 && bin < static_cast<double>(bins))
      histogram.share[static_cast<std::size_t>(bin)] += (weights.empty() ? 1 : weights[i]) / whole;
  }
  return histogram;
}

DiagramSeries normalDistribution(double most, double width) {
  DiagramSeries normal{
      .name = "normal distribution", .stroke = SeriesStroke::Dashed, .isTheory = true};
  for (double x = -most; x <= most; x += 0.1)
    normal.points.push_back(
        {x, 100 * width * std::exp(-0.5 * x * x) / std::sqrt(2 * std::numbers::pi)});
  return normal;
}

SlopeStatistics slopeStatistics(const Frame& frame) {
  SlopeStatistics statistics;
  std::vector<double> slopes = slopesOf(frame), contact;
  if (slopes.empty()) return statistics;
  const double direction = frame.velocity < 0 ? -1 : 1;
  const double rmsSlope = rms(slopes);
  if (!(rmsSlope > 0)) return statistics;
  double climbing = 0;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    slopes[i] = direction * slopes[i] / rmsSlope;
    if (!(frame.pressure[i] > 0)) continue;
    contact.push_back(slopes[i]);
    climbing += slopes[i] > 0 ? 1 : 0;
  }
  const std::size_t bins = countBins(contact.empty() ? slopes.size() : contact.size());
  statistics.whole = makeHistogram(slopes, -kMaxSlopes, kMaxSlopes, bins);
  if (contact.empty()) return statistics;
  statistics.contact = makeHistogram(contact, -kMaxSlopes, kMaxSlopes, bins);
  statistics.climbing = climbing / static_cast<double>(contact.size());
  statistics.rmsContact = rms(contact);
  return statistics;
}

DiagramSheet statisticsSheet(const Frame& frame) {
  DiagramSheet sheet;
  sheet.columns = 2;
  const SlopeStatistics slopes = slopeStatistics(frame);
  sheet.diagrams = {pressureDiagram(frame), slopeDiagram(slopes)};
  sheet.note = slopes.contact.share.empty()
                   ? Message("No element is in contact.")
                   : message(
                         "{:.0f} % of the contact is on slopes that climb (100 %: one-sided, "
                         "50 %: both sides alike); rms slope in contact {:.2f} times that of the "
                         "line.",
                         100 * slopes.climbing, slopes.rmsContact);
  return sheet;
}

}  // namespace asperity
