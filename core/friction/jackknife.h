// Standard errors by the jackknife. GroupedMeans are the means of a scene at several loads and
// velocities over its realizations, with the sums of each group of realizations. A number that is
// derived from the means (a slope, a plateau, an exponent) is derived again without each group in
// turn. The scatter of these values gives its standard error, which includes the correlation of
// loads and velocities on the same lines. Immutable once computed; any thread.
// Failure: as frictionCurve, which computes the same averages.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/base/statistics.h"
#include "core/base/stop.h"
#include "core/contact/steady_sliding.h"
#include "core/friction/curve_point.h"
#include "core/friction/law.h"
#include "core/friction/ensemble.h"
#include "core/friction/steady_states.h"
#include "core/scene/scene.h"
#include "core/surface/line_source.h"

namespace asperity {

class GroupedMeans {
 public:
  /// Number of groups of realizations that the jackknife leaves out in turn; fewer lines have one
  /// group each.
  static constexpr int kGroups = 20;
  static constexpr int kAll = -1;  // no group left out

  /// normalForces (N) and velocities (m/s) are both ascending.
  GroupedMeans(const Scene& scene, const std::vector<double>& normalForces,
               const std::vector<double>& velocities, const StateOptions& options);
  /// Each force has its own velocities, all of one number.
  GroupedMeans(const Scene& scene, std::vector<LoadCase> cases, const StateOptions& options);

  const Scene& scene() const { return scene_; }
  std::size_t forces() const { return cases_.size(); }
  double normalForce(std::size_t j) const { return cases_[j].load.normalForce; }  // N
  const std::vector<double>& velocities(std::size_t j = 0) const { return cases_[j].velocities; }
  const LineStatistics& line() const { return line_; }
  std::int64_t realizations() const { return realizations_; }
  int groups() const { return groups_; }

  /// Return averages over all realizations except for those of one group, at force j and velocity
  /// i.
  double mu(std::size_t j, std::size_t i, int leftOut = kAll) const;
  /// Returns the mean of mu over the rms slope of the same line.
  double normalizedMu(std::size_t j, std::size_t i, int leftOut = kAll) const;
  double contactFraction(std::size_t j, std::size_t i, int leftOut = kAll) const;
  /// Returns the root mean square over realizations, each weighted by its contact: of the pooled
  /// contact.
  double rmsSlopeContact(std::size_t j, std::size_t i, int leftOut = kAll) const;
  double muStandardError(std::size_t j, std::size_t i) const;
  /// Returns the fraction of lines whose force fell into a jump of the nodal rule.
  double marginalFraction(std::size_t j, std::size_t i) const;
  double largestResidual() const { return largestResidual_; }

  /// Returns the input of Eqs. (5) to (14) at force j and velocity i, with the rms slope of the
  /// whole line.
  LawInput lawInput(std::size_t j, std::size_t i) const;
  /// Returns the row of a table.
  CurvePoint point(std::size_t j, std::size_t i) const;

 private:
  /// Friction is summed relative to that of the first realization, so that no digits are lost where
  /// all lines agree.
  enum Quantity {
    Mu,
    MuSquared,
    NormalizedMu,
    Contact,
    SlopeSquares,
    Indentation,
    Marginal,
    kQuantities
  };
  using Sums = std::array<double, kQuantities>;

  void add(std::int64_t realization, std::span<const SteadyResult> results);
  std::size_t cellOf(std::size_t j, std::size_t i) const;
  double mean(Quantity quantity, std::size_t j, std::size_t i, int leftOut) const;

  Scene scene_;
  std::vector<LoadCase> cases_;
  LineStatistics line_;
  bool slopesDiffer_ = false;  // from line to line; line_ has the values of the first one
  double length_ = 0;          // m
  std::int64_t realizations_ = 0;
  std::int64_t orderedRows_ = 0;  // LineSource::orderedRows()
  int groups_ = 1;
  std::vector<std::int64_t> groupSizes_;
  std::vector<Sums> sums_;       // [group][force][velocity]
  std::vector<double> firstMu_;  // [force][velocity]
  double largestResidual_ = 0;
};

/// Returns a number derived from one or more GroupedMeans of the same realizations, with its
/// standard error, which needs two groups. groups: GroupedMeans::groups(). `read` gets the group to
/// leave out, or GroupedMeans::kAll. orderedRows: where each group is one line,
/// LineSource::orderedRows(); the error of rows is that of the mean of their pseudo-values, groups
/// * value of all - (groups - 1) * value without one (Miller, Biometrika 61, 1, 1974).
Estimate jackknife(int groups, const std::function<double(int leftOut)>& read,
                   std::int64_t orderedRows = 0);

}  // namespace asperity
