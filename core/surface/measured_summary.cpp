#include "core/surface/measured_summary.h"

#include <numbers>

#include "core/base/fourier.h"
#include "core/base/number_text.h"

namespace asperity {
namespace {

PrintedNumber metres(double value) {
  return printed(value, "m", 5);
}

/// Returns the measured heights relative to their mean, with gaps interpolated, as a spectrum needs
/// them.
std::vector<double> withoutGaps(std::vector<double> heights) {
  interpolateGaps(heights);
  removeForm(heights, FormRemoval::Mean);
  return heights;
}

}  // namespace

MeasuredSummary measuredSummary(const Scene& scene, const LineSource& source,
                                SummarySpectra spectra) {
  const MeasuredLines& lines = *source.measured();
  const Topography& topography = lines.file().topography;
  const ProcessingChoices& processing = scene.surface.processing;
  MeasuredSummary summary{.facts = lines.file().facts,
                          .columns = topography.columns,
                          .rows = topography.rows,
                          .spacing = topography.columnSpacing,
                          .rowSpacing = topography.rowSpacing,
                          .rowInFile = lines.numberInFile(source.rowOf(0)),
                          .rowsUsed = lines.rows(),
                          .missing = lines.missingHeights(),
                          .profile = lines.profile(source.rowOf(0)),
                          .spikes = lines.spikes()};
  const ProcessedProfile& profile = summary.profile;
  summary.longWaveCut = processing.longWaveCut;
  summary.raw = profileParameters(profile.raw, profile.spacing);
  summary.used = profileParameters(profile.used, profile.spacing, processing.longWaveCut);
  const RealTransform shared(profile.raw.size());  // keeps the plan of a long profile
  if (spectra == SummarySpectra::Computed) {
    summary.rawSpectrum = hannSpectrum(withoutGaps(profile.raw), profile.spacing);
    summary.usedSpectrum = hannSpectrum(withoutGaps(profile.used), profile.spacing);
  }
  const SpectrumLimits limits = lines.spectrumLimits(profile);
  summary.steps = limits.steps;
  summary.isFlat = summary.raw.pt == 0;
  if (!summary.isFlat) summary.band = limits.band;
  summary.coarseRows = lines.coarseRows();
  summary.radius = lines.radiusOfForm();
  summary.period = source.length();
  summary.lineSlope = source.statistics().rmsSlope;
  summary.ratios = lines.equivalentRatios();
  summary.isEquivalent = scene.surface.line == LineKind::IsotropicEquivalent;
  summary.hasTurned = scene.surface.contactSide == ContactSide::Summits;
  summary.isMirrored = processing.seam == Seam::Mirror;
  summary.notes = lineNotes(source);
  return summary;
}

Message spikesFact(std::int64_t spikes) {
  const PrintedNumber usual = printed(kUsualOutliers, 2);
  if (spikes == 1)
    return message(
        "one point of all rows stands far out of its neighbours, like a spike: where it is an "
        "error of the measurement, surface.outliers={} replaces it",
        usual);
  return message(
      "{} points of all rows stand far out of their neighbours, like spikes: where they are errors "
      "of the measurement, surface.outliers={} replaces them",
      spikes, usual);
}

namespace {

/// Returns how the file was read, then what is left out and what is interpolated.
std::vector<Message> readingFacts(const ReadingFacts& facts, const MissingHeights& missing) {
  std::vector<Message> list = facts.notes;
  const auto add = [&list](std::int64_t count, const Message& one, const Message& several) {
    if (count > 0) list.push_back(count == 1 ? one : several);
  };
  add(missing.rowsLeftOut, "one row with fewer than three heights is left out",
      message("{} rows with fewer than three heights are left out", missing.rowsLeftOut));
  add(missing.ends, "one point without a height at an end is left out",
      message("{} points without a height at the ends are left out", missing.ends));
  add(missing.gaps, "one point without a height is interpolated",
      message("{} points without a height are interpolated", missing.gaps));
  add(missing.outliers, "one outlier is interpolated",
      message("{} outliers are interpolated", missing.outliers));
  return list;
}

}  // namespace

std::vector<Message> readingFacts(const Scene& scene) {
  if (scene.surface.kind == SurfaceKind::Spectrum) return LineSource(scene, 1).spectrumFacts();
  if (scene.surface.kind != SurfaceKind::Measured) return {};
  const auto lines = MeasuredLines::of(scene);
  return readingFacts(lines->file().facts, lines->missingHeights());
}

namespace {

/// Adds what the line is: the surface as measured or its isotropic equivalent, and its period.
void addLineFacts(const MeasuredSummary& summary, std::vector<Message>& list) {
  list.push_back(
      summary.isEquivalent
          ? message(
                "the line is the isotropic equivalent, C = \u03C0 q C\u2082, which has the height "
                "of the whole surface in the mean over all rows; its rms height is {} times "
                "and its rms slope {} times that of the line as measured",
                printed(summary.ratios.height, 4), printed(summary.ratios.slope, 4))
          : Message("the line is the surface as measured"));
  // The window across the rows distinguishes wavelengths from two rows to half of all rows.
  constexpr std::int64_t kRowsForFourOctaves = 64;
  if (summary.isEquivalent && summary.rows < kRowsForFourOctaves)
    list.push_back(
        summary.rows == 1
            ? Message("that the surface is isotropic is assumed: one profile cannot show it")
            : message("that the surface is isotropic is assumed: {} rows are too few to show it",
                      summary.rows));
  list.push_back(summary.hasTurned ? Message("the line is turned over, because the summits touch")
                                   : Message("the line is not turned over: the valleys touch"));
  list.push_back(
      summary.isMirrored
          ? message("one period of the line is {} long, twice the profile", metres(summary.period))
          : message("one period of the line is {} long", metres(summary.period)));
}

/// Adds what makes the line too steep or its values doubtful, and what to do about it.
void addDoubts(const MeasuredSummary& summary, std::vector<Message>& list) {
  if (summary.longWaveCut > summary.used.length)
    list.push_back(message(
        "the long-wave cut-off of {} is longer than the profile of {}: hardly any wave is removed, "
        "and the values are no roughness parameters of ISO 21920-2",
        metres(summary.longWaveCut), metres(summary.used.length)));
  if (summary.steps.step > 0)
    list.push_back(
        message("the heights of the row have only {} levels, {} apart, which is about as much as "
                "neighbours differ: the line is too steep by these steps; measure in finer steps, "
                "or remove waves shorter than {} by surface.short_wave_cut",
                summary.steps.levels, metres(summary.steps.step),
                metres(2 * std::numbers::pi / summary.band.to)));
  if (summary.radius > 0)
    list.push_back(
        message("the profile is part of a circle with a radius of {}, which a parabola does not "
                "follow: measure a shorter piece, or remove the form by surface.long_wave_cut",
                printed(summary.radius, "m", 2)));
  if (summary.coarseRows.examined > 1 && summary.coarseRows.coarse > 0)
    list.push_back(
        message("of {} rows examined, {} have heights in steps that are too coarse for their line",
                summary.coarseRows.examined, summary.coarseRows.coarse));
}

Message spectrumFact(const MeasuredSummary& summary) {
  if (summary.isFlat) return "all heights of the row are the same: it has no spectrum";
  if (!(summary.band.to > summary.band.from))
    return "the profile is too short, or too noisy, for a spectrum that can be relied on";
  const PrintedNumber shortest = metres(2 * std::numbers::pi / summary.band.to),
                      longest = metres(2 * std::numbers::pi / summary.band.from);
  return summary.band.endsInNoise
             ? message(
                   "the spectrum is reliable for wavelengths of {} to {}; shorter ones are noise",
                   shortest, longest)
             : message(
                   "the spectrum is reliable for wavelengths of {} to {}, as far as the tip was "
                   "sharper than these",
                   shortest, longest);
}

}  // namespace

std::vector<Message> factsOf(const MeasuredSummary& summary) {
  std::vector<Message> list = readingFacts(summary.facts, summary.missing);
  if (summary.rows > 1)
    list.push_back(summary.rowsUsed == 1 ? message("row {} alone is the line", summary.rowInFile)
                                         : message("shown is row {}; {} rows are lines",
                                                   summary.rowInFile, summary.rowsUsed));
  if (summary.spikes > 0) list.push_back(spikesFact(summary.spikes));
  addLineFacts(summary, list);
  addDoubts(summary, list);
  list.push_back(spectrumFact(summary));
  return list;
}

std::vector<NamedValue> namedValues(const MeasuredSummary& summary) {
  const std::string letter = summary.isRoughness() ? "R" : "P";
  const ProfileParameters &raw = summary.raw, &used = summary.used;
  return {{letter + "a", "m", raw.pa, used.pa},   {letter + "q", "m", raw.pq, used.pq},
          {letter + "sk", "", raw.psk, used.psk}, {letter + "ku", "", raw.pku, used.pku},
          {letter + "z", "m", raw.pz, used.pz},   {letter + "t", "m", raw.pt, used.pt},
          {letter + "dq", "", raw.pdq, used.pdq}};
}

}  // namespace asperity
