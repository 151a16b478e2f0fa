// The march in time: Kelvin elements at equal distances under a line that moves as it likes, the
// rate of the indentation included, the force balance solved exactly in every step.
//
// In a step dt each element is loaded by a constant p, so with E = exp(-dt / tau) its depth goes
// from y0 to y1 = y0 E + (1 - E) p / 4G: free elements relax to y0 E, touching ones to d - rise,
// and p >= 0 by construction. F_N(d) is piecewise linear and is solved exactly. With dt = dx / v
// friction converges at second order in dx; v dt beyond about 2 v tau cannot resolve it.
//
// Ownership: holds its line and its state. Threading: one thread at a time.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "core/surface/line.h"

namespace asperity {

struct MarchConditions {
  double shearModulus = 0;    // Pa
  double relaxationTime = 0;  // s
  LoadKind load = LoadKind::Force;
  double normalForce = 0;  // N, for LoadKind::Force
  double depth = 0;        // m, for LoadKind::Indentation
};

/// What happened in one step, over one period.
struct MarchStep {
  double indentation = 0;    // m, at its end, from the lowest point of the line
  double normalForce = 0;    // N
  double work = 0;           // J, done on the elements: integral of p du
  double dissipated = 0;     // J, in the dashpots
  double stored = 0;         // J, gained by the springs
  double slidingWork = 0;    // J, work less what the normal force did by sinking; in steady sliding
                             // all of it is dissipated, at any resolution
  double lineWork = 0;       // J, pressure times the line's own advance: F_x times distance. Second
                             // order in dx everywhere; slidingWork is first order where elements
                             // enter, because p acts on them before the line has reached them
  double gapWork = 0;        // J, that difference: pressure times the gap it closed in the step
  double contactLength = 0;  // m
};

class TimeMarch {
 public:
  /// One element at each node of the line; lowest: height of its lowest point (m).
  TimeMarch(std::shared_ptr<const Line> line, double lowest);

  /// Depths y = -u >= 0 (m) of all elements, and the indentation they belong to.
  void setState(std::span<const double> depth, double indentation);

  /// The line's place (m slid so far), and pressures (N/m) to show before the first step.
  void setDistance(double distance);
  void setPressure(std::span<const double> pressure);

  /// Moves the line by `distance` (m, either sign) in the time dt (s, > 0).
  MarchStep step(const MarchConditions& conditions, double dt, double distance);

  double distance() const { return distance_; }                      // m, slid so far
  double indentation() const { return indentation_; }                // m
  const std::vector<double>& depth() const { return depth_; }        // m, y at x_i = i spacing
  const std::vector<double>& pressure() const { return pressure_; }  // N/m
  const std::vector<double>& rise() const { return rise_; }  // m, of the line above each element
  const Line& line() const { return *line_; }

 private:
  void placeLine();
  double balance(double load);

  std::shared_ptr<const Line> line_;
  double lowest_;
  double distance_ = 0, indentation_ = 0;
  std::vector<double> depth_, pressure_, rise_;
  std::vector<double> lastRise_;   // m, before the step
  std::vector<double> threshold_;  // m, indentation at which each element is touched in this step
};

}  // namespace asperity
