// The profile of a parameter: the least sum of squares with the parameter held, over its value, and
// how many deviations each value lies from the best one. It is a part of core/fit/fit.cpp.
//
// A step outwards begins from its neighbour, so that the other parameters follow a curved valley.
//
// Deviations. Let D be the rise of the sum of squares from the best point to a point of the
// profile. The errors of the points give D the variance 4 s^2 D (s: the scale of their errors), the
// mean over the fit's lines gives it the variance V, which is that of the lines' own differences.
// The point is z = D / sqrt(s^2 D + V / 4) deviations away. Where friction is linear in the
// parameters, z = 1 is one standard error of fit.h. Where the mean over few lines makes the sum of
// squares uneven, V is large, and its bumps and hollows are not taken for answers of the data.
// Failure: as Objective; a state that cannot slide ends a profile.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/fit/fit_objective.h"

namespace asperity {

struct ProfilePoint {
  Minimum minimum;
  double deviations = 0;  // from the best point, z above
};

/// The coordinates of all parameters where a profile is one deviation from the best point; nothing
/// where it does not get so far.
struct ProfileRange {
  std::optional<Eigen::VectorXd> low, high;
};

class ProfileWalk {
 public:
  /// best: the minimum over all parameters.
  ProfileWalk(const Objective& objective, const Minimum& best, double errorScale);

  /// Walks from the best point to both sides until the sum of squares is far above its least.
  /// along: the first step, whose length in the parameter k the next steps have; later
  /// ones grow. fewest: steps to each
  /// side where limits allow. Returns the points in the order of rising values.
  std::vector<ProfilePoint> profile(int k, const Eigen::VectorXd& along, int fewest) const;

 private:
  struct Residuals {
    Eigen::VectorXd ofMean;   // [point]
    Eigen::MatrixXd ofLines;  // [point][line], about their mean, to the scale of its error
  };

  Residuals residualsAt(const Eigen::VectorXd& coordinates) const;
  std::vector<ProfilePoint> side(int k, const Eigen::VectorXd& along, int fewest) const;
  Minimum held(int k, const Eigen::VectorXd& predicted, const Eigen::VectorXd& neighbour) const;
  double deviations(const Minimum& minimum) const;
  Eigen::VectorXd withinLimits(Eigen::VectorXd coordinates) const;

  const Objective& objective_;
  const Minimum& best_;
  double errorScale_;
  Residuals residuals_;  // of the best point
};

/// Returns how far one deviation reaches towards a point that is at most two away: to the point
/// itself where it is nearer than one, else to its share of the distance.
std::optional<Eigen::VectorXd> shareOfPoint(const Eigen::VectorXd& best, const ProfilePoint& point);

/// Returns the outermost values of the parameter k that are one deviation from the best point.
/// Where a profile is flat further out, the range is so long that all its points within two
/// deviations lie within two ranges.
ProfileRange rangeOfProfile(const Objective& objective, int k,
                            const std::vector<ProfilePoint>& profile);

}  // namespace asperity
