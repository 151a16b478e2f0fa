#include "ui/contact/contact_overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/contact/arms/retardation.h"
#include "core/material/element_law.h"
#include "ui/contact/frame_curves.h"
#include "ui/draw/theme.h"
#include "ui/draw/ticks.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

constexpr int kPowerDecades = 3;
// A free surface has recovered after this many of its longest relaxation times.
constexpr double kRelaxationTimes = 4;

struct OverlayEntry {
  std::string_view unit, explanation;
  const std::vector<double> Frame::*values;
  double ContactView::*maximum;
};

/// The overlays in the order of their enumeration.
constexpr std::array<OverlayEntry, 4> kOverlays{
    {{"", "", nullptr, nullptr},
     {"N/m", "line load", &Frame::pressure, &ContactView::pressure},
     {"s", "time since contact", &Frame::sinceContact, &ContactView::age},
     {"W/m", "dissipated power", &Frame::power, &ContactView::power}}};

const OverlayEntry& overlayEntry(ContactOverlay overlay) {
  return kOverlays[static_cast<std::size_t>(overlay)];
}

/// Returns the numbers of a scale in one unit, "10⁻²⁹ N/m" outside the range of prefixes.
AxisTicks countedTicks(const ColourScale& scale, int most) {
  return linearTicks(0, scale.maximum, most, overlayEntry(scale.overlay).unit);
}

std::string withUnit(const std::string& title, const ColourScale& scale) {
  constexpr int kMany = 6;
  return title + " (" + countedTicks(scale, kMany).unit + ")";
}

double greatestFinite(const std::vector<double>& values) {
  double greatest = 0;
  for (const double value : values)
    if (std::isfinite(value)) greatest = std::max(greatest, value);
  return greatest;
}

/// Returns the longest relaxation time, s; infinite where nothing relaxes to rest.
double longestRelaxation(const Frame& frame) {
  if (!frame.scene) return std::numeric_limits<double>::infinity();
  const RetardationModes modes = retardationModes(elementLaw(frame.scene->elastomer));
  return modes.modes() > 0 ? 1 / modes.rate.front() : std::numeric_limits<double>::infinity();
}

}  // namespace

FrameFields fieldsFor(ContactOverlay overlay) {
  FrameFields fields;
  fields.sinceContact = overlay == ContactOverlay::Relaxation;
  fields.power = overlay == ContactOverlay::Power;
  return fields;
}

std::string_view explanationId(ContactOverlay overlay) {
  return overlayEntry(overlay).explanation;
}

float ColourScale::position(double value) const {
  if (!(maximum > 0) || std::isnan(value)) return 0;
  double position = value / maximum;
  if (overlay == ContactOverlay::Power)
    position = position > 0 ? 1 + std::log10(position) / kPowerDecades : 0;
  return static_cast<float>(std::clamp(position, 0.0, 1.0));
}

double ColourScale::minimumShown() const {
  return overlay == ContactOverlay::Power ? maximum * std::pow(10, -kPowerDecades) : 0;
}

Rgba ColourScale::colourAt(float position) const {
  return overlay == ContactOverlay::Relaxation ? ageColour(position) : pressureColour(position);
}

std::string ColourScale::title() const {
  switch (overlay) {
    case ContactOverlay::Relaxation:
      return withUnit(Words::tr("time since contact"), *this);
    case ContactOverlay::Power:
      return withUnit(Words::tr("dissipated power, log scale"), *this);
    default:
      return withUnit(Words::tr("line load"), *this);
  }
}

std::string ColourScale::shortTitle() const {
  switch (overlay) {
    case ContactOverlay::Relaxation:
      return withUnit(Words::tr("since contact"), *this);
    case ContactOverlay::Power:
      return withUnit(Words::tr("power, log"), *this);
    default:
      return withUnit(Words::tr("line load"), *this);
  }
}

std::vector<ColourTick> ColourScale::ticks(int most, bool hasUnit) const {
  const AxisTicks round = countedTicks(*this, most);
  const auto label = [&](double value) { return shortNumber(value / round.unitSize); };
  std::vector<ColourTick> ticks;
  if (overlay == ContactOverlay::Power) {
    for (int decade = kPowerDecades; decade > 0; --decade) {
      const double value = maximum * std::pow(10, -decade);
      ticks.push_back({position(value), label(value)});
    }
  } else {
    for (const Tick& tick : round.ticks)
      if (tick.value < maximum * (1 - 1e-9))
        ticks.push_back({position(tick.value), label(tick.value)});
  }
  ticks.push_back({1, label(maximum) + (hasUnit ? " " + round.unit : "")});
  return ticks;
}

std::string reasonUncoloured(const Frame& frame, ContactOverlay overlay) {
  const std::vector<double>& values = overlayValues(frame, overlay);
  if (!isDrawable(frame) || values.size() != frame.lineHeight.size()) return {};
  const bool showsPressure = overlay == ContactOverlay::Pressure;
  if (showsPressure ? greatestPressure(frame) > 0 : greatestFinite(values) > 0) return {};
  const bool rests = frameVelocity(frame) == 0;
  // If all points were in contact, they would bear pressure.
  const bool touches = frame.state.contactFraction < 1 &&
                       (frame.state.normalForce > 0 || frame.state.contactFraction > 0);
  if (touches && !(greatestPressure(frame) > 0))
    return Words::tr("no colours: the contact is too small to be drawn");
  if (showsPressure) return Words::tr("no colours: nothing touches");
  if (overlay == ContactOverlay::Power)
    return rests ? Words::tr("no colours: nothing is dissipated at rest")
                 : Words::tr("no colours: nothing is dissipated");
  if (frame.state.contactFraction >= 1)
    return Words::tr("no colours: all of the surface is in contact");
  return rests ? Words::tr("no colours: at rest nothing leaves contact")
               : Words::tr("no colours: nothing has left contact yet");
}

const std::vector<double>& overlayValues(const Frame& frame, ContactOverlay overlay) {
  static const std::vector<double> none;
  const auto values = overlayEntry(overlay).values;
  return values ? frame.*values : none;
}

double scaleMaximum(const Frame& frame, ContactOverlay overlay, double last) {
  constexpr double kInHand = 1.1;  // margin, so that the scale rarely changes
  if (overlay == ContactOverlay::Pressure && !pointsBearLoad(frame)) return 0;
  if (overlay == ContactOverlay::Pressure && frame.steadyPressure > 0)
    return roundUp(kInHand * frame.steadyPressure);
  double greatest = greatestFinite(overlayValues(frame, overlay));
  if (overlay == ContactOverlay::Relaxation && greatest > 0)
    greatest = std::min(greatest, kRelaxationTimes * longestRelaxation(frame));
  if (!(greatest > 0) || (greatest <= last && greatest > 0.4 * last)) return last;
  return roundUp(overlay == ContactOverlay::Relaxation ? greatest : kInHand * greatest);
}

double colourMaximum(const ContactView& view, ContactOverlay overlay) {
  const auto maximum = overlayEntry(overlay).maximum;
  return maximum ? view.*maximum : 0;
}

void setColourMaximum(ContactView& view, ContactOverlay overlay, double maximum) {
  if (const auto member = overlayEntry(overlay).maximum) view.*member = maximum;
}

}  // namespace asperity
