// The march in time: elements of any linear rheology at equal distances under a line with any
// motion, also through rest, including the rate of the indentation, with the force balance solved
// exactly in every step.
//
// The state of an element is its creep amplitudes (core/contact/arms/retardation.h), which are
// independent of each other: y = J p/4 + sum a_j, a_j' = -rate_j a_j + fluidity_j p/4. Elements
// with a dashpot of their own (Kelvin: one amplitude, J = 0) are loaded by a constant p in a step
// that resolves it; their p jumps where the line meets them. In longer steps, and without such a
// dashpot, they are loaded by a p that is linear in time. Either way y_new = max(y_free, d_new -
// z), p >= 0 by construction, and F_N(d_new) is piecewise linear and is solved exactly. With dt =
// dx / v friction converges at second order in dx; steps v dt longer than about twice the sliding
// distance in a relaxation time cannot resolve it.
//
// Ownership: owns its line, its law and its state. Threading: one thread at a time.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/contact/arms/retardation.h"
#include "core/material/element_law.h"
#include "core/scene/scene.h"
#include "core/surface/line.h"

namespace asperity {

/// The quantity that is constant in a step.
struct MarchLoad {
  LoadKind kind = LoadKind::Force;
  double normalForce = 0;  // N, for LoadKind::Force
  double depth = 0;        // m, for LoadKind::Indentation
};

/// The result of one step, over one period.
struct MarchStep {
  double indentation = 0;    // m, at its end, from the lowest point of the line
  double normalForce = 0;    // N; constant in the step, or at its end where p is linear
  double work = 0;           // J, done on the elements: integral of p du
  double dissipated = 0;     // J, in the dashpots, each computed separately: never below 0
  double stored = 0;         // J, increase in the springs
  double lineWork = 0;       // J, pressure times the line's own advance: F_x times distance, to
                             // second order in dx everywhere
  double gapWork = 0;        // J, their difference: pressure times the gap closed in the step
  double slopeForce = 0;     // N, integral of p dz/dx, which is -F_x: the slopes are means over the
                             // distance of the step (lineWork over distance), at rest local slopes
  double contactLength = 0;  // m
  std::size_t contacts = 0;  // contact spots
};

/// Optional records of each element, which cost extra time.
struct MarchRecords {
  bool sinceContact = false, power = false;
};

class TimeMarch {
 public:
  /// Makes one element at each node of the line; lowest: height of its lowest point (m).
  TimeMarch(std::shared_ptr<const Line> line, double lowest, ElementLaw law);

  /// Sets depths y = -u >= 0 (m) of all elements, and the indentation. Their amplitudes are those
  /// after creep to this depth under a constant pressure.
  void setState(std::span<const double> depth, double indentation);

  /// Sets also the pressures p (N/m) and, for elements with arms, the amplitudes a_j (m),
  /// [node][mode].
  void setState(std::span<const double> depth, std::span<const double> pressure,
                std::span<const double> amplitudes, double indentation);

  /// Continues from another march's state, with its amplitudes where their number agrees.
  void continueFrom(const TimeMarch& other);

  /// Sets the state under the load at rest with everything relaxed: F_N = 4 G dx sum y.
  void settleAtRest(const MarchLoad& load);

  /// Sets the line's position (m slid so far), and pressures (N/m) to show before the first step.
  void setDistance(double distance);
  void setPressure(std::span<const double> pressure);

  /// Moves the line by `distance` (m, either sign) in the time dt (s, > 0).
  MarchStep step(const MarchLoad& load, double dt, double distance);

  /// Starts these records. Elements that are free now count as never in contact.
  void record(MarchRecords wanted);
  /// Sets the times since contact from a known earlier motion.
  void setSinceContact(std::span<const double> seconds);
  /// Returns the time since each element was in contact, s: 0 in contact, infinite where it never
  /// was; empty where not recorded.
  const std::vector<double>& sinceContact() const { return sinceContact_; }
  /// Returns the power dissipated in each element, W/m: the mean over the last step, with the sum
  /// (MarchStep::dissipated + gapWork) / dt, or before the first step that of its state
  /// (dissipatedPower); 0 where the remaining creep is a rounding error. An element that the line
  /// meets within the step also gets the work done over the gap: so the sum balances lineWork and
  /// is of second order in dx as well. Empty where not recorded.
  const std::vector<double>& power() const { return power_; }
  /// Returns dz/dx of the line over each element, from its cubics; at a corner the mean of both
  /// sides.
  std::vector<double> lineSlope() const;
  /// Returns the integral of p dz/dx with the slopes of the line at its present position, N: -F_x,
  /// also at rest.
  double slopeForce() const;

  double distance() const { return distance_; }                      // m, slid so far
  double indentation() const { return indentation_; }                // m
  const std::vector<double>& depth() const { return depth_; }        // m, y at x_i = i spacing
  const std::vector<double>& pressure() const { return pressure_; }  // N/m
  /// Returns the height of the line over each element above its lowest point, m.
  const std::vector<double>& heightAboveMinimum() const { return height_; }
  /// Returns the amplitudes a_j, m, [mode][element].
  const std::vector<double>& amplitudes() const { return amplitude_; }
  const Line& line() const { return *line_; }
  const ElementLaw& law() const { return law_; }
  const RetardationModes& modes() const { return modes_; }

 private:
  /// The effect of a step dt on an amplitude.
  struct Creep {
    double kept;       // factor of the amplitude
    double forgotten;  // 1 - kept
    double before;     // m / Pa, effect of p/4 at the step's beginning
    double after;      // m / Pa, effect of p/4 at its end, or throughout
    double stiffness;  // Pa, of its spring; 0 for one that only flows
    /// m / Pa: its dashpot dissipates x (loss[0] x + loss[1] more) + loss[2] more^2 under a p/4
    /// that is x above what its spring holds (Pa) and grows by `more` in the step.
    std::array<double, 3> loss;

    double taken(double x, double more) const {
      return x * (loss[0] * x + loss[1] * more) + loss[2] * more * more;
    }
  };

  /// How far the line approaches the elastomer in a step, m: up to the first element, and further.
  struct Approach {
    double toContact, further;
    double whole() const { return toContact + further; }
  };

  bool needsConstantPressure(double dt) const;
  void prepareSteps(double dt);
  void moveLine(double distance);
  void placeLine();
  Approach balance(double load);
  void creepFreely();
  template <bool IsConstant>
  MarchStep finishStep(const Approach& approach);
  void countContacts(MarchStep& step) const;
  void keepBegin();
  void recordStep(double dt);
  void recordPower(double dt);

  std::shared_ptr<const Line> line_;
  double lowest_;
  ElementLaw law_;
  RetardationModes modes_;
  double distance_ = 0, indentation_ = 0;
  double before_ = 0;  // m, indentation at the step's beginning
  // number of nodes by which the line has moved, within one period
  std::ptrdiff_t passedNodes_ = 0;
  double ahead_ = 0;  // minus this part of a node
  std::vector<double> depth_, pressure_, height_;
  std::vector<double> amplitude_;   // m, [mode][element]
  std::vector<double> lastHeight_;  // m, before the step
  std::vector<double> free_;        // m, depths at the end of the step if nothing touches
  std::vector<double> threshold_;   // m, approach at which the line touches each element
  std::vector<Creep> creep_;
  MarchRecords records_;
  std::vector<double> sinceContact_, power_;
  std::vector<double> beginDepth_, beginPressure_, beginAmplitude_;  // of the step, for power
  double preparedFor_ = -1;                                          // s, dt of creep_
  bool isPressureConstant_ = false;                                  // p in steps of that dt
  double compliance_ = 0;  // m / Pa, y over a p/4 added at the end of the step
};

// ---- Power: the heat of the dashpots of each element. Pure; any thread.

/// Returns the present power, W/m, of elements under pressures p (N/m) with creep amplitudes a_j
/// (m), [mode][element] as in TimeMarch. Each amplitude is a spring and a dashpot in parallel with
/// a_j' = -rate_j a_j + fluidity_j p/4, so that the dashpots take 4 sum a_j'^2 / fluidity_j; for
/// Kelvin elements 4 eta u'^2, in contact or free. Its integral over a period of steady sliding is
/// F_x v. Zeros for elastic elements, and where the remaining creep is a rounding error: at rest.
std::vector<double> dissipatedPower(const RetardationModes& modes, std::span<const double> pressure,
                                    std::span<const double> amplitudes);

/// Adds the heat of local friction to the power (W/m) of each element where p (N/m) is above 0, at
/// this velocity (m/s, either sign).
void addLocalFriction(std::span<double> power, std::span<const double> pressure,
                      const Interface& interface, double velocity);

}  // namespace asperity
