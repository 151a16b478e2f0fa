// The parts of the load in steady sliding: on the leading or the trailing sides of the summits, in
// the springs or the dashpots. They come from the shape of the elastomer at the nodes of every
// line, which GroupedMeans do not keep. Immutable once computed; any thread. Equal bits for any
// number of threads. Failure: StopRequested where `stop` was requested.
#pragma once

#include <cstdint>
#include <vector>

#include "core/friction/jackknife.h"
#include "core/friction/ensemble.h"
#include "core/scene/scene.h"

namespace asperity {

class LoadShares {
 public:
  /// Computes cases at a constant force on the scene's first lines; the lines take turns in the
  /// groups of the jackknife, as in GroupedMeans.
  LoadShares(const Scene& scene, std::vector<LoadCase> cases, std::int64_t lines,
             const StateOptions& options);

  int groups() const { return groups_; }
  const LoadCase& loadCase(std::size_t j) const { return cases_[j]; }

  /// Return the parts of the normal force of all lines together, at case j and velocity i: on sides
  /// from which the line recedes; and in the springs, integral of 4 G (d - z) over contact.
  double trailing(std::size_t j, std::size_t i, int leftOut = GroupedMeans::kAll) const;
  double elastic(std::size_t j, std::size_t i, int leftOut = GroupedMeans::kAll) const;
  /// Returns the mean over the lines of mu / rms slope in contact.
  double frictionOverSlope(std::size_t j, std::size_t i, int leftOut = GroupedMeans::kAll) const;

 private:
  struct Sums {
    double load = 0, trailing = 0, elastic = 0;  // all in the same unit
    double frictionOverSlope = 0, lines = 0;
    void add(const Sums& other);
  };

  static Sums lineSums(const PreparedProfile& line, const SlidingConditions& conditions,
                       double force);
  std::size_t cellIndex(std::size_t j, std::size_t i) const;
  Sums sums(std::size_t j, std::size_t i, int leftOut) const;

  std::vector<LoadCase> cases_;
  int groups_ = 1;
  std::vector<Sums> sums_;  // [group][case][velocity]
};

}  // namespace asperity
