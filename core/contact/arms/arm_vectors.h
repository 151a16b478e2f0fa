// The coefficients of elements with arms as the vector kernels read them: one row of numbers for
// each quantity, one number for each arm or mode, padded with zeros to whole vectors; and the
// memory that a pass works in. ArmVectors are plain values, read by any thread; an ArmWorkspace
// belongs to one thread.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/contact/arms/arm_coefficients.h"
#include "core/contact/kernels/pass.h"

namespace asperity {

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
