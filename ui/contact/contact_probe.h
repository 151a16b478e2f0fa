// The reading at one element of a contact picture; contact_parts.h draws it. Pure; any thread.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/run/frame.h"

namespace asperity {

struct ProbeReading {
  std::size_t point = 0;  // of the frame
  double position = 0;    // m, of the point, in the period of x
  double line = 0;        // m, z - d
  double surface = 0;     // m, u
  double gap = 0;         // m, 0 in contact
  double pressure = 0;    // N/m
  double slope = 0;       // dz/dx; a central difference where the frame has no slopes
  /// m/s, du/dt of the elastomer, where the slope and the velocity do not determine it: for Kelvin
  /// elements in a motion, and while a picture settles. It makes the pressure agree with the depth
  /// to rounding, p = 4 (G |u| - eta du/dt) (Li et al. 2013, Eq. 1).
  std::optional<double> surfaceRate;
  std::optional<double> age;    // s since contact, if the frame has it
  std::optional<double> power;  // W/m, if the frame has it
};

/// Returns the reading at the element nearest to x (m, any period); nothing where the frame cannot
/// be drawn.
std::optional<ProbeReading> probeReading(const Frame& frame, double x);

struct ProbeLine {
  std::string label, value;
};

/// Returns "gap" "12 nm" and so on, for a readout or a screen reader.
std::vector<ProbeLine> probeLines(const ProbeReading& reading);

}  // namespace asperity
