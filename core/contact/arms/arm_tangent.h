// How the outcome of a pass over a line answers to its start: derivatives with respect to the
// indentation and to each arm's strain at the lowest point. Strains decay in contact,
// amplitudes in free arcs, and what is yielded goes on smoothly through every event, so only the
// lengths between events are needed. Ownership: refers to the memory. One thread at a time.
#pragma once

#include <vector>

#include "core/contact/arms/arm_coefficients.h"

namespace asperity {

class ArmTangent {
 public:
  explicit ArmTangent(const ArmCoefficients& memory);

  /// Contact begins at the lowest point.
  void begin();
  /// Contact of this length (m) ends.
  void leave(double length);
  /// A free arc of this length ends in contact.
  void enter(double length);
  /// The period ends, in contact or free, with a last stretch of this length.
  void finish(double length, bool touching);

  /// Unknown 0 is the indentation, 1 + k the strain of arm k at the lowest point.
  std::size_t unknowns() const { return unknowns_; }
  /// Of the integral of y (m).
  double ofDepthIntegral(std::size_t unknown) const { return volume_[unknown]; }
  /// Of what arm i yields over the period.
  double ofYieldChange(std::size_t i, std::size_t unknown) const {
    return change_[i * unknowns_ + unknown];
  }

 private:
  void contact(double length);
  void arc(double length);

  const ArmCoefficients& memory_;
  std::size_t unknowns_;
  std::vector<double> strain_;  // [arm][unknown], where contact began or begins
  std::vector<double> mode_;    // [mode][unknown], likewise of the arc
  std::vector<double> row_;
  std::vector<double> volume_, change_;
};

}  // namespace asperity
