// The coefficients of elements with arms at one velocity, as a pass over a line needs them: the
// decay and the driving of strains over one segment, the creep of a free surface over blocks of
// segments, and the derivatives of the result of a pass with respect to its initial values; and the
// same as the vector kernels read them, with the memory that they work in. All quantities are
// lengths: moduli are relative to the equilibrium modulus, and times are the distances slid in them
// (m).
// ArmCoefficients and ArmVectors are plain values, read by any thread; an ArmTangent and an
// ArmWorkspace belong to one thread.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/contact/arms/retardation.h"
#include "core/contact/kernels/decay_moments.h"
#include "core/contact/kernels/pass.h"
#include "core/material/element_law.h"

namespace asperity {

struct ArmCoefficients {
  /// law: with an equilibrium modulus and at least one arm; velocity > 0 (m/s); spacing of whole
  /// segments and period (m); levels of blocks of 4^k segments.
  ArmCoefficients(const ElementLaw& law, const RetardationModes& modes, double velocity,
                  double spacing, double period, std::size_t levels);

  std::size_t arms() const { return modulus.size(); }
  std::size_t modes() const { return rate.size(); }

  std::vector<double> modulus;  // g_i = G_i / G
  std::vector<double> inverse;  // 1/m, 1 / (v tau_i)
  double dashpot = 0;           // m, v eta / G
  double glassy = 1;            // 1 + sum g_i, of the springs alone

  // These belong to one whole segment with w' = (D_0 + D_1 u + D_2 u^2) / spacing.
  std::vector<double> kept;  // e_i(1) = kept_i e_i(0) + sum D_k driven_ki
  std::array<std::vector<double>, 3> driven;
  std::vector<double> lossRate;                // 1/m, g_i / (v tau_i)
  std::array<std::vector<double>, 3> moment;   // g_i integral of exp(-z u) u^k
  std::array<std::array<double, 3>, 3> own{};  // sum g_i integral of u^k (what u^l has driven)
  std::vector<LossForm> loss;                  // 1/c_i integral of e_i^2

  /// The number of slow arms, which come first and change little over a period. Their creep is
  /// summed separately, as q_i(1) - q_i(0) = creepKept_i e_i(0) + sum D_k creepDriven_ki.
  std::size_t slow = 0;
  std::vector<double> creepKept;
  std::array<std::vector<double>, 3> creepDriven;

  // These belong to the free surface, y = sum a_j exp(-rate_j s).
  std::vector<double> rate;                // 1/m
  std::vector<double> stiffness;           // of the springs that pull it back, per G
  std::vector<double> settled;             // a_j per depth where all arms have relaxed
  std::vector<std::vector<double>> decay;  // [level][mode], over a block
  std::vector<std::vector<double>> lost;   // 1 - decay
  const RetardationModes& conversion;
};

/// The derivatives of the result of a pass with respect to the indentation and to each arm's strain
/// at the lowest point. Strains decay in contact, amplitudes decay in free arcs, and the creep is
/// continuous through every event, so only the lengths between events are needed. The object refers
/// to the coefficients.
class ArmTangent {
 public:
  explicit ArmTangent(const ArmCoefficients& coefficients);

  /// Begins in contact at the lowest point.
  void begin();
  /// Ends a contact of this length (m).
  void leave(double length);
  /// Ends a free arc of this length (m) in contact.
  void enter(double length);
  /// Ends the period, in contact or free, with a last interval of this length (m).
  void finish(double length, bool touching);

  /// Returns the number of unknowns: 0 is the indentation, 1 + k the strain of arm k at the lowest
  /// point.
  std::size_t unknowns() const { return unknowns_; }
  /// Returns the derivative of the integral of y (m).
  double ofDepthIntegral(std::size_t unknown) const { return volume_[unknown]; }
  /// Returns the derivative of the creep of arm i over the period.
  double ofCreepChange(std::size_t i, std::size_t unknown) const {
    return change_[i * unknowns_ + unknown];
  }

 private:
  void contact(double length);
  void arc(double length);

  const ArmCoefficients& coefficients_;
  std::size_t unknowns_;
  std::vector<double> strain_;  // [arm][unknown], where contact began or begins
  std::vector<double> mode_;    // [mode][unknown], likewise of the arc
  std::vector<double> row_;
  std::vector<double> volume_, change_;
};

// ---- The coefficients as the vector kernels read them: one row of numbers for each quantity, one
// number for each arm or mode, padded with zeros to whole vectors
/// Lanes of the widest vector.
inline constexpr std::size_t kWidestVector = 8;
struct alignas(64) WideCell {
  std::array<double, kWidestVector> value{};
};

/// Rows of numbers of one width. Each row begins a cache line and is padded with zeros.
class AlignedRows {
 public:
  AlignedRows() = default;
  AlignedRows(std::size_t rows, std::size_t width) { shape(rows, width); }

  /// Sets the size of the rows; all numbers become 0.
  void shape(std::size_t rows, std::size_t width) {
    stride_ = (width + kWidestVector - 1) / kWidestVector;
    cells_.assign(rows * stride_, WideCell{});
  }
  double* row(std::size_t i) { return cells_[i * stride_].value.data(); }
  const double* row(std::size_t i) const { return cells_[i * stride_].value.data(); }

 private:
  std::size_t stride_ = 0;
  std::vector<WideCell> cells_;
};

/// Several quantities of each arm or mode. All quantities of one vector are adjacent, so that one
/// pointer reaches them.
template <std::size_t Quantities>
class LaneTable {
 public:
  explicit LaneTable(std::size_t width)
      : cells_((width + kWidestVector - 1) / kWidestVector * Quantities) {}

  /// Returns a quantity of arm or mode i.
  double& value(std::size_t quantity, std::size_t i) {
    return cells_[i / kWidestVector * Quantities + quantity].value[i % kWidestVector];
  }
  /// Returns a pointer to the quantities of the vector that begins with arm or mode i; quantity q
  /// is kWidestVector q further on.
  const double* from(std::size_t i) const {
    return cells_[i / kWidestVector * Quantities].value.data() + i % kWidestVector;
  }

 private:
  std::vector<WideCell> cells_;
};

struct ArmVectors {
  /// The quantities in `arm`; they are named after those of ArmCoefficients.
  enum Arm : std::size_t {
    Inverse,
    Modulus,
    LossRate,
    Kept,
    Driven0,
    Driven1,
    Driven2,
    CreepKept,
    CreepDriven0,
    CreepDriven1,
    CreepDriven2,
    Moment0,
    Moment1,
    Moment2,
    LossOfStrain,  // of loss, times the modulus: ee
    LossWith0,     // ed
    LossWith1,
    LossWith2,
    ArmRows
  };
  enum Mode : std::size_t { Rate, Stiffness, Settled, ModeRows };

  explicit ArmVectors(const ArmCoefficients& coefficients);

  std::size_t arms, modes, slow;
  double dashpot, glassy;
  std::array<std::array<double, 3>, 3> own;
  std::array<double, 6> lossOfSlopes{};  // sum g_i dd_i of loss
  LaneTable<ArmRows> arm;
  LaneTable<ModeRows> mode;
  AlignedRows decay, lost;        // [level] over modes
  AlignedRows toStrain, toCreep;  // [mode] over arms
  AlignedRows ofCreep;            // [arm] over modes
};

/// The initial values, the working memory and the results of a pass, per 4G as in ArmPass.
struct ArmWorkspace {
  explicit ArmWorkspace(const ArmVectors& vectors);

  /// Lengths (m) along the period, in contact, free, in contact, and so on, from the lowest point
  /// on.
  std::vector<double> lengths;
  std::vector<double> creepChange;  // m, of each arm
  PassSums sums;
  void addLength(double length);
  bool wasComplete() const { return lengths.size() == 1; }

  enum Row : std::size_t {
    Strain,
    Trial,
    Amplitude,
    ArcAmplitude,
    Creep,
    After,
    Rows = After + kWidestVector
  };
  AlignedRows rows;
};

}  // namespace asperity
