// Two ways to compute the same friction curve (scheme, oversampling, number of realizations) on
// common lines: the difference of their means, with an error in which the noise of common lines
// cancels. Realizations of equal number have equal phases at every resolution, so they are pairs.
// Threading, failure, cancelling: as frictionCurve. The same bits for any number of threads.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/base/message.h"
#include "core/base/statistics.h"
#include "core/friction/curve_point.h"
#include "core/scene/scene.h"

namespace asperity {

/// Another way to compute the scene's curve, with which it is compared.
struct CurveSetting {
  Scheme scheme = Scheme::Cubic;
  std::int64_t oversampling = 8;  // always 1 for `nodal`
  std::int64_t realizations = 20;

  bool operator==(const CurveSetting&) const = default;
};

/// Returns "cubic x8, 20 lines"; nodal has no oversampling.
Message settingName(const CurveSetting& setting);

/// Returns the scene with this setting; its target accuracy, if any, is dropped.
Scene withSetting(Scene scene, const CurveSetting& setting);

struct DifferencePoint {
  double velocity = 0;  // m/s
  double mu = 0;        // with the setting of the comparison
  double muStandardError = kNotApplicable;
  double relative = 0;  // mean over the scene's own, minus 1
  /// The error of `relative`, in which lines of one number are correlated. Needs two lines.
  double standardError = kNotApplicable;
};

struct CurveDifference {
  std::shared_ptr<const Scene> scene;  // the unchanged scene
  CurveSetting setting;
  std::vector<DifferencePoint> points;
  std::int64_t done = 0, total = 0;  // realizations of both settings together
};

struct DifferenceOptions {
  int threads = 0;
  std::stop_token stop;
  std::function<void(const CurveDifference&)> progress;  // from the calling thread; may be empty
};

/// Computes the difference. scene: without a target accuracy, else InputError. Where `stop` is
/// requested, the points are those of the finished part.
CurveDifference curveDifference(const Scene& scene, const CurveSetting& setting,
                                const DifferenceOptions& options = {});

/// Means of a and b over their lines, of which the first ones are common, and their ratio. Exact
/// for any two numbers of lines; to first order in the errors (delta method).
class PairedMeans {
 public:
  PairedMeans() = default;
  /// orderedRows: LineSource::orderedRows() of each side's lines. Rows are pairs only where both
  /// sides have as many; otherwise lines of one number are different rows, and the errors of both
  /// means are added as if they were independent, which is an upper estimate.
  PairedMeans(std::int64_t orderedRowsOfA, std::int64_t orderedRowsOfB)
      : orderedRowsOfA_(orderedRowsOfA), orderedRowsOfB_(orderedRowsOfB) {}

  void addPair(double a, double b);
  void addOnlyA(double a) {
    onlyA_.add(a);
    if (orderedRowsOfA_ > 0) rowsOfA_.push_back(a);
  }
  void addOnlyB(double b) {
    onlyB_.add(b);
    if (orderedRowsOfB_ > 0) rowsOfB_.push_back(b);
  }

  /// Returns mean b / mean a. Its standard error needs two pairs.
  Estimate ratio() const;
  double meanA() const { return both(a_, onlyA_).mean(); }
  double meanB() const { return both(b_, onlyB_).mean(); }
  double standardErrorB() const {
    return orderedRowsOfB_ > 0 ? lineMeanError(rowsOfB_, orderedRowsOfB_).standardError
                               : both(b_, onlyB_).standardError();
  }

 private:
  static RunningMean both(RunningMean some, const RunningMean& others) {
    some.add(others);
    return some;
  }

  double errorOfRows(double ratio) const;

  std::int64_t orderedRowsOfA_ = 0, orderedRowsOfB_ = 0;
  std::vector<double> rowsOfA_, rowsOfB_;  // friction, of ordered rows alone
  RunningMean a_, b_, onlyA_, onlyB_;
  double products_ = 0;  // sum of the products of the deviations in pairs
};

}  // namespace asperity
