// What is to be read at one element of a contact picture. Pure; any thread.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/run/frame.h"

namespace asperity {

struct ProbeReading {
  std::size_t point = 0;  // of the frame
  double position = 0;    // m, of the point, in the first period
  double line = 0;        // m, z - d
  double surface = 0;     // m, u
  double gap = 0;         // m, 0 in contact
  double pressure = 0;    // N/m
  double slope = 0;       // dz/dx; where the frame has none a central difference
  /// m/s, du/dt of the elastomer, where it does not follow from the slope and the velocity alone:
  /// of Kelvin elements in a motion, and while a picture settles. With it the pressure is that of
  /// the depth, p = 4 (G |u| - eta du/dt), to rounding (Li et al. 2013, Eq. 1).
  std::optional<double> surfaceRate;
  std::optional<double> age;    // s since contact, where the frame knows it
  std::optional<double> power;  // W/m, likewise
};

/// At the element nearest to x (m, any period); nothing where the frame cannot be drawn.
std::optional<ProbeReading> probeReading(const Frame& frame, double x);

struct ProbeLine {
  std::string label, value;
};

/// "gap" "12 nm" and so on, for a readout or to be spoken.
std::vector<ProbeLine> probeLines(const ProbeReading& reading);

}  // namespace asperity
