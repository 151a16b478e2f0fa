// The title and readings above the axes.
#include <algorithm>
#include <cmath>

#include "ui/contact/contact_parts.h"
#include "ui/contact/frame_curves.h"
#include "ui/draw/fonts.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"

namespace asperity {
namespace {

struct Reading {
  TextRuns label;
  std::string value;
  int rank = 0;  // the highest is left out first
  std::string tip;
  std::string_view id;     // of its explanation
  std::string reserved{};  // value whose width is kept, so that digits move no other reading
};

/// A reading with its position: the label's left end, and the baseline of its first row.
struct PlacedReading {
  Reading reading;
  DrawPoint at;
};

float readingWidth(const Reading& reading, const Sizes& s) {
  return std::max({textWidth(reading.label, s.small), textWidth(reading.value, s.body, true),
                   textWidth(reading.reserved, s.body, true)});
}

/// Adds interface and total friction, where the scene has local friction.
void addInterfaceReadings(std::vector<Reading>& readings, const Frame& frame) {
  if (!hasInterface(frame)) return;
  const ContactState& state = frame.drawn();
  readings.push_back({{{Words::tr("\u03BC of the interface")}},
                      shortNumber(state.muInterface, 3, Zeros::Keep),
                      2,
                      Words::tr("Of local friction in contact, beside what the deformation costs; "
                                "it does not change the contact."),
                      frame.scene->interface.shearStress > 0 ? "interface.shear_stress"
                                                             : "interface.friction_coefficient"});
  readings.push_back(
      {{{Words::tr("\u03BC in total")}},
       shortNumber(totalFriction(state), 3, Zeros::Keep),
       1,
       Words::tr("Of deformation and interface together: friction force over normal force."),
       "total friction"});
}

std::string frictionTip(const Frame& frame) {
  if (frame.isSettling)
    return Words::tr(
        "Tangential force divided by normal force while the elastomer still relaxes after a "
        "change, read from the time steps since the last picture.");
  if (frame.transient)
    return Words::tr(
        "Tangential force divided by normal force at this moment of the motion, a mean "
        "over the time since the last picture. After \u00B1 stands the "
        "estimated error of elements and time steps.");
  return Words::tr(
      "Tangential force divided by normal force of this line in steady sliding, computed "
      "without time steps.");
}

Reading settledReading(const Frame& frame, int rank) {
  return {
      {{Words::tr("\u03BC when settled")}},
      shortNumber(frame.state.mu, 3, Zeros::Keep),
      rank,
      Words::tr(
          "Friction in the steady state, as in the chart. The picture is still approaching it."),
      "mu"};
}

/// Returns the readings of the state that is drawn. While it approaches the steady state, the
/// friction of the steady state is shown, too, at the end, where it moves no other reading; where
/// that of the picture cannot be read, it stands in its place.
std::vector<Reading> makeReadings(const Frame& frame) {
  std::vector<Reading> readings;
  const bool isSteady = !frame.transient;
  const ContactState& state = frame.drawn();
  const bool isSettledAlone =
      frame.isSettling && !std::isfinite(state.mu) && std::isfinite(frame.state.mu);
  if (isSettledAlone)
    readings.push_back(settledReading(frame, 0));
  else
    readings.push_back(
        {{{hasInterface(frame) ? Words::tr("\u03BC of the deformation")
                               : Words::tr("coefficient of friction \u03BC")}},
         // A motion has an error where that of its elements and time steps is known.
         numberWithError(state.mu, isSteady ? kNotApplicable : frame.muError, Zeros::Keep),
         0,
         frictionTip(frame),
         "mu",
         isSteady ? std::string() : numberWithError(0.0008888, 0.0000088, Zeros::Keep)});
  addInterfaceReadings(readings, frame);
  readings.push_back({{{Words::tr("normal force F")}, {"N", false, true}},
                      quantity(state.normalForce, "N"),
                      3,
                      Words::tr("Force that presses one period of the line into the elastomer."),
                      "load.normal_force"});
  readings.push_back({{{Words::tr("indentation d")}},
                      quantity(state.indentation, "m"),
                      5,
                      Words::tr("How deep the lowest point of the line lies below the undeformed "
                                "surface."),
                      "indentation"});
  readings.push_back({{{Words::tr("in contact")}},
                      shortPercent(state.contactFraction),
                      4,
                      Words::tr("Share of the line's length that touches the elastomer."),
                      "contact_fraction"});
  if (frame.scene)
    readings.push_back({{{Words::tr("velocity v")}},
                        quantity(isSteady ? frame.scene->sliding.velocity : frame.velocity, "m/s"),
                        6,
                        isSteady ? Words::tr("Velocity of the line, to the right.")
                                 : Words::tr("Velocity of the line at this moment; below 0 it goes "
                                             "back."),
                        "sliding.velocity"});
  // A line at rest has no pace.
  if (frame.timeScale > 0 && (frame.transient || frameVelocity(frame) != 0)) {
    const bool isSlower = frame.timeScale < 1;
    const double factor = isSlower ? 1 / frame.timeScale : frame.timeScale;
    readings.push_back({{{isSlower ? Words::tr("slow motion") : Words::tr("time lapse")}},
                        factorText(factor) + "\u00D7",
                        8,
                        filled(Words::tr("One second on the screen shows %1 of the motion."),
                               {quantity(frame.timeScale, "s")}),
                        "pace"});
  }
  if (frame.isSettling && !isSettledAlone) readings.push_back(settledReading(frame, 7));
  return readings;
}

/// Arranges readings in rows, from left to right.
std::vector<std::vector<Reading>> flow(const std::vector<Reading>& readings, float width, float gap,
                                       const Sizes& s) {
  std::vector<std::vector<Reading>> rows(1);
  float used = 0;
  for (const Reading& reading : readings) {
    const float needed = readingWidth(reading, s);
    if (!rows.back().empty() && used + gap + needed > width) {
      rows.emplace_back();
      used = 0;
    }
    used += needed + (rows.back().empty() ? 0 : gap);
    rows.back().push_back(reading);
  }
  return rows;
}

void dropLeastImportant(std::vector<Reading>& readings) {
  readings.erase(
      std::max_element(readings.begin(), readings.end(),
                       [](const Reading& a, const Reading& b) { return a.rank < b.rank; }));
}

std::string surfaceName(const Surface& surface) {
  switch (surface.kind) {
    case SurfaceKind::SelfAffine:
      return surface.rmsHeight > 0 ? Words::tr("A rough rigid line")
                                   : Words::tr("A flat rigid line");
    case SurfaceKind::Sine:
      return Words::tr("A rigid sine");
    case SurfaceKind::Wedge:
      return Words::tr("A rigid wedge");
    case SurfaceKind::Parabola:
      return Words::tr("A rigid parabola");
    case SurfaceKind::Spectrum:
      return Words::tr("A rough rigid line");
    case SurfaceKind::Measured:
    case SurfaceKind::Profile:
      return Words::tr("A measured rigid line");
  }
  return Words::tr("A rigid line");
}

std::string pictureTitle(const Frame& frame) {
  if (!frame.scene) return Words::tr("A rigid line on an elastomer");
  if (!frame.scene->title.empty()) return sceneText(frame.scene->title).toStdString();
  const bool rests = frame.scene->sliding.velocity == 0;
  return filled(
      rests ? Words::tr("%1 rests on an elastomer") : Words::tr("%1 slides over an elastomer"),
      {surfaceName(frame.scene->surface)});
}

/// Returns "t = 3.2 ms, slid 1.5 mm", of a motion that returns "displaced by 1.5 mm".
std::string progressWords(bool returns, double time, double distance) {
  return filled(returns ? Words::tr("t = %1, displaced by %2") : Words::tr("t = %1, slid %2"),
                {quantity(time, "s", 3, Zeros::Keep), quantity(distance, "m", 3, Zeros::Keep)});
}

/// Returns whether the line moves back and forth; its distance is then that from its beginning.
bool returns(const Frame& frame) {
  const SlidingKind kind = frame.scene ? frame.scene->sliding.kind : SlidingKind::Steady;
  return kind == SlidingKind::Oscillation || kind == SlidingKind::Reversal;
}

/// Returns how far the line has come; nothing before the first step.
std::string progressText(const Frame& frame) {
  if (!(frame.time > 0)) return {};
  constexpr double kRounding = 1e-12;  // part of the period, for a motion that returned
  const double slid = std::abs(frame.distance);
  return progressWords(returns(frame), frame.time, slid > kRounding * frame.length ? slid : 0);
}

/// Returns the width that is kept for the progress: that of the usual numbers, so that the title
/// beside them does not change with their digits.
float progressWidth(const Frame& frame, const std::string& progress, float size) {
  if (progress.empty()) return 0;
  float width = textWidth(progress, size);
  for (const double wide : {88.8e-6, 88.8e-3})
    width = std::max(width, textWidth(progressWords(returns(frame), wide, wide), size));
  return width;
}

float titleBaseline(const Sizes& s) {
  return std::round(10 * s.unit + s.title);
}

/// The title and the text at the right end of its line, if it fits.
struct TitleLine {
  std::string whole, shown, progress;
  float side = 0, width = 0, progressAt = 0;
  float size = 0;  // of the title's font
};

TitleLine titleLine(const Frame& frame, const ContactPictureOptions& options) {
  const Sizes s = sizesFor(options);
  const auto width = static_cast<float>(options.width);
  TitleLine line{
      pictureTitle(frame), {}, progressText(frame), std::round(16 * s.unit), 0, 0, s.title};
  const float progress = progressWidth(frame, line.progress, s.small);
  line.progressAt = std::floor(width - line.side - textWidth(line.progress, s.small));
  const float alone = width - 2 * line.side, beside = alone - progress - 2 * line.side;
  const float smallest = std::max(kSmallestFont, std::round(0.8F * s.title));
  // The title is worth more than the time beside it.
  const bool fitsBeside = textWidth(line.whole, smallest, true) <= beside;
  if (!(progress < 0.4F * width) || !fitsBeside) line.progress.clear();
  line.width = line.progress.empty() ? alone : beside;
  line.size = fittingSize(line.whole, s.title, smallest, true, line.width);
  line.shown = elided(line.whole, line.size, true, line.width);
  return line;
}

void addTitle(DrawList& list, const Frame& frame, const ContactPictureOptions& options) {
  const Sizes s = sizesFor(options);
  const Theme& theme = options.theme;
  const float baseline = titleBaseline(s);
  const TitleLine line = titleLine(frame, options);
  if (!line.shown.empty())
    addText(list, {{line.shown, true}}, {line.side, baseline}, line.size, theme.text);
  if (!line.progress.empty())
    addText(list, {{line.progress}}, {line.progressAt, baseline}, s.small, theme.faintText);
}

float titleHeight(const Sizes& s) {
  return std::round(10 * s.unit + s.title * 1.25F);
}

float rowHeight(const Sizes& s) {
  return std::round(s.small + s.body + 14 * s.unit);
}

/// Returns the pixels that title and readings may take from the top.
float mostHeight(const ContactPictureOptions& options) {
  return 0.4F * static_cast<float>(options.height);
}

/// Places as many readings as fit below a title with this baseline.
std::vector<PlacedReading> placedReadings(const Frame& frame, const ContactPictureOptions& options,
                                          float baseline) {
  const Sizes s = sizesFor(options);
  const float side = std::round(16 * s.unit), gap = std::round(26 * s.unit);
  const float width = static_cast<float>(options.width) - 2 * side;
  std::vector<Reading> readings = makeReadings(frame);
  const auto tooMuch = [&](const auto& rows) {
    // One reading alone below a full row would take the picture's height, and come and go with the
    // digits of the others.
    const bool hasWidow = rows.size() == 2 && rows[0].size() > 4 && rows[1].size() == 1;
    return titleHeight(s) + static_cast<float>(rows.size()) * rowHeight(s) > mostHeight(options) ||
           readingWidth(rows[0][0], s) > width || hasWidow;
  };
  while (!readings.empty() && tooMuch(flow(readings, width, gap, s))) dropLeastImportant(readings);
  std::vector<PlacedReading> placed;
  if (readings.empty()) return placed;
  for (const auto& row : flow(readings, width, gap, s)) {
    float x = side;
    for (const Reading& reading : row) {
      placed.push_back({reading, {x, baseline}});
      x += std::round(readingWidth(reading, s) + gap);
    }
    baseline += rowHeight(s);
  }
  return placed;
}

bool hasHeader(const ContactPictureOptions& options) {
  return titleHeight(sizesFor(options)) <= mostHeight(options);
}

}  // namespace

float addHeader(DrawList& list, const Frame& frame, const ContactPictureOptions& options) {
  const Sizes s = sizesFor(options);
  const Theme& theme = options.theme;
  if (!hasHeader(options)) return 0;
  addTitle(list, frame, options);
  const std::vector<PlacedReading> readings = placedReadings(frame, options, titleBaseline(s));
  if (readings.empty()) return titleHeight(s);
  for (const auto& [reading, at] : readings) {
    addText(list, reading.label, {at.x, std::round(at.y + 11 * s.unit + s.small * 0.8F)}, s.small,
            theme.faintText);
    const bool first = reading.rank == 0;
    addText(list, {{reading.value, true}}, {at.x, std::round(at.y + rowHeight(s))}, s.body,
            first ? theme.highlight : theme.text);
  }
  return std::round(readings.back().at.y + rowHeight(s) + s.body * 0.4F);
}

std::vector<ContactSign> contactReadings(const Frame& frame, const ContactPictureOptions& options) {
  std::vector<ContactSign> signs;
  if (!options.title || !hasHeader(options)) return signs;
  const Sizes s = sizesFor(options);
  if (const TitleLine line = titleLine(frame, options); line.shown != line.whole)
    signs.push_back({{line.side, 0, line.width, titleHeight(s)}, line.shown, {}, line.whole});
  for (const auto& [reading, at] : placedReadings(frame, options, titleBaseline(s)))
    signs.push_back({{at.x, at.y + 0.25F * s.body, readingWidth(reading, s), rowHeight(s)},
                     plainText(reading.label),
                     reading.id,
                     reading.tip});
  return signs;
}

}  // namespace asperity
