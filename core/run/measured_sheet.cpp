#include "core/run/measured_sheet.h"

#include <algorithm>
#include <cmath>

#include "core/base/intervals.h"
#include "core/base/number_text.h"
#include "core/run/line_diagrams.h"

namespace asperity {
namespace {

constexpr std::size_t kStretches = 1500;  // along the profile

/// Returns the points of a profile relative to `mean`; of a long one the lowest and the highest of
/// each part, so that no summit is lost.
std::vector<DiagramPoint> profilePoints(std::span<const double> heights, double spacing,
                                        double mean) {
  std::vector<DiagramPoint> points;
  const auto add = [&](std::size_t i) {
    points.push_back({(static_cast<double>(i) + 0.5) * spacing, heights[i] - mean});
  };
  if (heights.size() <= 2 * kStretches) {
    for (std::size_t i = 0; i < heights.size(); ++i) add(i);
    return points;
  }
  for (std::size_t s = 0; s < kStretches; ++s) {
    const std::size_t first = s * heights.size() / kStretches;
    const std::size_t end = (s + 1) * heights.size() / kStretches;
    std::size_t lowest = first, highest = first;
    for (std::size_t i = first; i < end; ++i) {
      if (std::isnan(heights[i])) continue;
      if (std::isnan(heights[lowest]) || heights[i] < heights[lowest]) lowest = i;
      if (std::isnan(heights[highest]) || heights[i] > heights[highest]) highest = i;
    }
    add(std::min(lowest, highest));
    if (lowest != highest) add(std::max(lowest, highest));
  }
  return points;
}

DiagramSeries seriesNamed(const char* name, int colour, std::vector<DiagramPoint> points) {
  DiagramSeries series{.name = name, .colour = colour, .points = std::move(points)};
  return series;
}

/// Makes the diagrams of both profiles: in one frame, or in two where the removed form is much
/// larger than the roughness.
std::vector<Diagram> profileDiagrams(const MeasuredSummary& summary) {
  constexpr double kDwarfs = 4;
  const ProcessedProfile& profile = summary.profile;
  DiagramSeries raw =
      seriesNamed("raw, about its mean", 1,
                  profilePoints(profile.raw, profile.spacing, meanHeight(profile.raw)));
  raw.stroke = SeriesStroke::Dashed;
  DiagramSeries used = seriesNamed("used", 0, profilePoints(profile.used, profile.spacing, 0));
  Diagram frame{.x = {"position", "m", AxisScale::Linear, 0, summary.used.length},
                .y = {"height", "m", AxisScale::Linear}};
  if (summary.raw.pt <= kDwarfs * summary.used.pt) {
    frame.series = {std::move(used), std::move(raw)};
    return {frame};
  }
  Diagram below = frame;
  frame.series = {std::move(raw)};
  below.series = {std::move(used)};
  return {frame, below};
}

/// Returns means over intervals of log q, as the eye would average them.
std::vector<DiagramPoint> spectrumPoints(const SpectralDensity& spectrum) {
  constexpr double kPointsPerDecade = 24;
  std::vector<DiagramPoint> points;
  for (const IndexRange& band : logBands(spectrum.waveNumber, kPointsPerDecade)) {
    double wave = 0, density = 0;
    for (std::size_t i = band.begin; i < band.end; ++i) {
      wave += std::log(spectrum.waveNumber[i]);
      density += spectrum.density[i];
    }
    const auto count = static_cast<double>(band.size());
    if (density > 0) points.push_back({std::exp(wave / count), density / count});
  }
  return points;
}

Diagram spectrumDiagram(const MeasuredSummary& summary) {
  Diagram diagram{.x = {"wave number q", "1/m", AxisScale::Logarithmic},
                  .y = {"spectral density C", "m\u00B3", AxisScale::Logarithmic}};
  std::vector<DiagramPoint> raw = spectrumPoints(summary.rawSpectrum);
  std::vector<DiagramPoint> used = spectrumPoints(summary.usedSpectrum);
  // A part that a filter has removed completely would extend the axis to rounding errors.
  constexpr double kDeepest = 1e-12;
  double greatest = 0, least = HUGE_VAL;
  for (const auto* points : {&raw, &used})
    for (const DiagramPoint& point : *points) greatest = std::max(greatest, point.y);
  for (auto* points : {&raw, &used}) {
    std::erase_if(*points,
                  [&](const DiagramPoint& point) { return point.y < kDeepest * greatest; });
    for (const DiagramPoint& point : *points) least = std::min(least, point.y);
  }
  if (!raw.empty()) {
    const double first = raw.front().x, last = raw.back().x;
    if (summary.band.from > first)
      diagram.shades.push_back({first, summary.band.from, "too long", {}, {}, false});
    if (summary.band.to < last)
      diagram.shades.push_back({summary.band.to,
                                last,
                                summary.band.endsInNoise ? Message("noise") : Message("too short"),
                                {},
                                {},
                                false});
  }
  DiagramSeries before = seriesNamed("raw", 1, std::move(raw));
  before.stroke = SeriesStroke::Dashed;
  diagram.series = {seriesNamed("used", 0, std::move(used)), std::move(before)};
  return diagram;
}

/// Makes the diagram of the distribution of heights, in rms heights of the used profile.
Diagram heightDistribution(const MeasuredSummary& summary) {
  constexpr double kMax = 5;
  Diagram diagram{.x = {summary.isRoughness() ? "height z / Rq" : "height z / Pq", "",
                        AxisScale::Linear, -kMax, kMax},
                  .y = {"share", "%", AxisScale::Linear}};
  std::vector<double> heights;
  const double mean = meanHeight(summary.profile.used);
  if (!(summary.used.pq > 0)) {
    diagram.blank = "all heights are equal";
    return diagram;
  }
  for (const double height : summary.profile.used)
    heights.push_back((height - mean) / summary.used.pq);
  const auto bins = static_cast<std::size_t>(
      std::clamp(std::sqrt(static_cast<double>(heights.size())), 20.0, 100.0));
  const Histogram histogram = makeHistogram(heights, -kMax, kMax, bins);
  DiagramSeries steps = seriesNamed("used", 0, {});
  for (std::size_t i = 0; i < histogram.share.size(); ++i) {
    const double from = histogram.from + histogram.width() * static_cast<double>(i);
    steps.points.push_back({from, 100 * histogram.share[i]});
    steps.points.push_back({from + histogram.width(), 100 * histogram.share[i]});
  }
  diagram.series = {std::move(steps), normalDistribution(kMax, histogram.width())};
  return diagram;
}

}  // namespace

DiagramSheet measuredSheet(const MeasuredSummary& summary, const std::string& title) {
  DiagramSheet sheet;
  sheet.title = title.empty() ? Message("Measured surface") : Message(title);
  const auto metres = [](double value) { return printed(value, "m", 4); };
  const auto number = [](double value) { return printed(value, 4); };
  const Message rough = summary.isRoughness() ? Message::name("Rq") : Message::name("Pq");
  const Message slope = summary.isRoughness() ? Message::name("Rdq") : Message::name("Pdq");
  sheet.subtitle = listed(
      {summary.rows > 1 ? message("row {} of {}", summary.rowInFile, summary.rows) : Message(),
       message("{} = {} raw, {} used", rough, metres(summary.raw.pq), metres(summary.used.pq)),
       message("{} = {} raw, {} used", slope, number(summary.raw.pdq), number(summary.used.pdq)),
       summary.isEquivalent
           ? message("rms slope of the equivalent line {}", number(summary.lineSlope))
           : Message()});
  sheet.diagrams = profileDiagrams(summary);
  sheet.diagrams.push_back(spectrumDiagram(summary));
  sheet.diagrams.push_back(heightDistribution(summary));
  sheet.columns = sheet.diagrams.size() == 4 ? 2 : 1;
  sheet.note = measuredSheetNote();
  return sheet;
}

Message measuredSheetNote() {
  return "Summits are up, as in the file. C(q) is two-sided, h\u00B2 = 2 \u222B C dq, under a "
         "Hann window; tinted: not roughness but the length of the profile, noise or too few "
         "points to a wave.";
}

}  // namespace asperity
