#include "ui/contact/contact_probe.h"

#include <algorithm>
#include <cmath>

#include "core/material/element_law.h"
#include "ui/contact/decimate.h"
#include "ui/draw/ticks.h"
#include "ui/language/words.h"

namespace asperity {
namespace {

/// Returns the rate of the surface. A marched element has a constant pressure in each time step, so
/// its law gives the rate at the end of the step exactly. The line's slope and velocity give it
/// only to first order in the step.
std::optional<double> surfaceRate(const Frame& frame, std::size_t point) {
  const bool isMarched = frame.transient || frame.isSettling;
  if (!frame.scene || !isMarched) return std::nullopt;
  const ElementLaw law = elementLaw(frame.scene->elastomer);
  if (law.kind() != ElementKind::Kelvin) return std::nullopt;
  const double spring = -4 * law.equilibriumModulus * frame.surfaceHeight[point];
  return (spring - frame.pressure[point]) / (4 * law.viscosity);
}

/// A free surface relaxes for ever; what is left of it far below an atom is shown as 0.
std::string heightText(double height) {
  constexpr double kMin = 1e-12;  // m
  return quantity(std::abs(height) < kMin ? 0 : height, "m", 3, Zeros::Keep);
}

}  // namespace

std::optional<ProbeReading> probeReading(const Frame& frame, double x) {
  if (!isDrawable(frame) || !std::isfinite(x)) return std::nullopt;
  const auto count = static_cast<double>(frame.lineHeight.size());
  const double nearest = std::round(x / frame.spacing);
  const double wrapped = nearest - count * std::floor(nearest / count);
  const std::size_t n = frame.lineHeight.size();
  const std::size_t i = std::min(static_cast<std::size_t>(wrapped), n - 1);
  ProbeReading reading;
  reading.point = i;
  reading.position = nearest * frame.spacing;  // as on the axis, in any period
  reading.line = frame.lineHeight[i];
  reading.surface = frame.surfaceHeight[i];
  reading.pressure = frame.pressure[i];
  reading.gap = reading.pressure > 0 ? 0 : std::max(reading.line - reading.surface, 0.0);
  reading.slope = lineSlopeAt(frame, i);
  reading.surfaceRate = surfaceRate(frame, i);
  if (frame.sinceContact.size() == n && std::isfinite(frame.sinceContact[i]))
    reading.age = frame.sinceContact[i];
  if (frame.power.size() == n) reading.power = frame.power[i];
  return reading;
}

std::vector<ProbeLine> probeLines(const ProbeReading& reading) {
  std::vector<ProbeLine> lines{
      {Words::tr("position x"), quantity(reading.position, "m", 4, Zeros::Keep)},
      {Words::tr("rigid line z"), heightText(reading.line)},
      {Words::tr("elastomer u"), heightText(reading.surface)}};
  if (reading.pressure > 0)
    lines.push_back({Words::tr("pressure p"), quantity(reading.pressure, "N/m", 3, Zeros::Keep)});
  else
    lines.push_back({Words::tr("gap"), quantity(reading.gap, "m", 3, Zeros::Keep)});
  lines.push_back({Words::tr("slope z\u2032"), shortNumber(reading.slope, 3, Zeros::Keep)});
  if (reading.surfaceRate)
    lines.push_back(
        {Words::tr("rate du/dt"), quantity(*reading.surfaceRate, "m/s", 3, Zeros::Keep)});
  if (reading.age && *reading.age > 0)
    lines.push_back({Words::tr("free for"), quantity(*reading.age, "s", 3, Zeros::Keep)});
  if (reading.power)
    lines.push_back({Words::tr("dissipates"), quantity(*reading.power, "W/m", 3, Zeros::Keep)});
  return lines;
}

}  // namespace asperity
