// The space of a study: what each of its axes allows, and its points. A point is a pure function of
// the study and its number, so that every process that works on a part makes the same ones.
// Immutable; any thread.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/scene/parameters.h"
#include "core/scene/range.h"

namespace asperity {

enum class DistributionKind { Normal, Lognormal, Uniform };

/// A random quantity. Mean and deviation are those of the quantity itself, also of a lognormal one,
/// before the limits cut it.
struct Distribution {
  DistributionKind kind = DistributionKind::Uniform;
  double mean = 0, deviation = 1;  // in the key's unit
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();

  /// Returns the quantile of u: the value below which the quantity is with probability u, 0 < u <
  /// 1.
  double quantile(double u) const;

  bool operator==(const Distribution&) const = default;
};

/// Returns the quantile of the standard normal distribution, 0 < p < 1.
double normalQuantile(double p);

/// One key of an axis. Words are the choices and texts of a key that is no number; a point then has
/// the index of its word.
struct StudyColumn {
  const Parameter* row = nullptr;
  std::vector<double> numbers{};  // of an axis of separate values
  std::vector<std::string> words{};

  std::string_view key() const { return row->key; }
  bool hasWords() const { return !words.empty(); }
};

/// One direction of the space: separate values (a list, the points of a range, rows of a table,
/// which set several keys at once), a range or a distribution.
struct StudyAxis {
  std::vector<StudyColumn> columns{};  // one, or those of a table
  std::optional<ParameterRange> range{};
  std::optional<Distribution> distribution{};

  /// Returns the number of separate values; 0 for a continuous axis.
  std::int64_t count() const;
  /// Returns the value of a column at the part u of the axis, 0 < u < 1.
  double valueAt(double u, std::size_t column) const;
};

/// Saltelli: the points of two Sobol samples A and B, and those of A with one coordinate of B, for
/// sensitivity indices: A, one for each axis, B, and so on.
enum class Sampling { Grid, LatinHypercube, Sobol, Saltelli };

class StudySpace {
 public:
  StudySpace() = default;
  /// samples: number of points of a sample; in a Saltelli design, of A. A grid does not use it.
  StudySpace(std::vector<StudyAxis> axes, Sampling sampling, std::int64_t samples,
             std::int64_t seed);

  const std::vector<StudyAxis>& axes() const { return axes_; }
  Sampling sampling() const { return sampling_; }
  std::int64_t samples() const { return samples_; }
  std::int64_t seed() const { return seed_; }
  /// Returns the number of points, at most 2^62.
  std::int64_t size() const { return size_; }
  /// Returns the number of columns of all axes; columns are in the order of the axes.
  std::size_t columns() const { return columns_; }
  const StudyColumn& column(std::size_t number) const;

  /// Fills the values of all columns of a point, 0 <= index < size().
  void pointInto(std::int64_t index, std::span<double> values) const;

 private:
  double coordinate(std::int64_t index, std::size_t axis) const;

  std::vector<StudyAxis> axes_;
  Sampling sampling_ = Sampling::Grid;
  std::int64_t samples_ = 0, seed_ = 1, size_ = 1;
  std::size_t columns_ = 0;
};

// ---- The sequence of Sobol (USSR Comput. Math. Math. Phys. 7(4), 86, 1967) with the direction
// numbers of Joe and Kuo: points that fill a cube of many dimensions evenly
inline constexpr int kMaxSobolDimensions = 64;

/// Returns one coordinate of a point, times 2^32. The points are in the order of Gray codes, in
/// which the first 2^m of them are, for every m, the same set as in the original order. 0 <=
/// dimension < kMaxSobolDimensions. No earlier point is needed, so every process makes the same
/// points.
std::uint32_t sobolNumber(std::uint32_t index, int dimension);

}  // namespace asperity
