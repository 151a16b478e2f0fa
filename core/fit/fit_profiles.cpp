#include "core/fit/fit_profiles.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace asperity {
namespace {

using Eigen::VectorXd;

/// Returns how many standard errors a parabola of the sum of squares would be away from its least
/// value to reach that of a point.
double errorsAbove(const Minimum& point, const FitErrors& errors) {
  return std::sqrt(std::max(0.0, point.chiSquared - errors.chiSquared)) / errors.errorScale;
}

VectorXd withinLimits(const Objective& objective, VectorXd coordinates) {
  for (const int j : objective.all()) {
    const VariedParameter& parameter = objective.parameter(j);
    coordinates[j] = std::clamp(coordinates[j], parameter.lowest(), parameter.highest());
  }
  return coordinates;
}

/// Holds one parameter at values on one side of the best one, and minimizes over the others. They
/// begin where the covariance predicts, further out where the last two points lead, so that they
/// follow a curved valley. Where the sum of squares has not risen by one standard error after
/// three of them, the walk goes on with longer steps.
std::vector<Minimum> profileToOneSide(const Objective& objective, int k, int sign,
                                      const Minimum& best, const FitErrors& errors) {
  constexpr int kFewIterations = 4;
  const VariedParameter& parameter = objective.parameter(k);
  const double error = std::sqrt(errors.covariance(k, k));
  const double reach = std::min(error, 2 * largestDeterminedError(parameter));
  std::vector<int> others = objective.all();
  others.erase(others.begin() + k);
  std::vector<Minimum> points;
  VectorXd last = best.coordinates;
  VectorXd perReach = errors.covariance.col(k) * reach / errors.covariance(k, k);
  double place = 0;
  for (const double reaches : {1, 2, 3, 6, 12}) {
    if (reaches > 3 && (reach < error || errorsAbove(points.back(), errors) > 1)) break;
    VectorXd start = withinLimits(objective, last + sign * (reaches - place) * perReach);
    start[k] = best.coordinates[k] + sign * reaches * reach;
    if (start[k] < parameter.lowest() || start[k] > parameter.highest()) break;
    points.push_back(others.empty() ? atCoordinates(objective, start)
                                    : minimize(objective, start, others, kFewIterations));
    perReach = sign * (points.back().coordinates - last) / (reaches - place);
    last = points.back().coordinates;
    place = reaches;
  }
  return points;
}

}  // namespace

FitProfiles fitProfiles(const Objective& objective, const Minimum& best, const FitErrors& errors) {
  FitProfiles profiles;
  for (const int k : objective.all()) {
    std::vector<Minimum> points = profileToOneSide(objective, k, -1, best, errors);
    std::ranges::reverse(points);
    points.push_back(best);
    std::ranges::move(profileToOneSide(objective, k, 1, best, errors), std::back_inserter(points));
    profiles.push_back(std::move(points));
  }
  return profiles;
}

const Minimum& lowestPoint(const FitProfiles& profiles, const Minimum& best) {
  const Minimum* lowest = &best;
  for (const std::vector<Minimum>& profile : profiles)
    for (const Minimum& point : profile)
      if (point.chiSquared < lowest->chiSquared) lowest = &point;
  return *lowest;
}

std::pair<double, double> profileReach(const FitProfiles& profiles, const FitErrors& errors,
                                       Eigen::Index coordinate, double best) {
  double below = 0, above = 0;
  const auto take = [&](double place) {
    below = std::max(below, best - place);
    above = std::max(above, place - best);
  };
  for (const std::vector<Minimum>& profile : profiles)
    for (std::size_t i = 0; i < profile.size(); ++i) {
      const double height = errorsAbove(profile[i], errors);
      const double place = profile[i].coordinates[coordinate];
      if (height <= 1) take(place);
      if (i == 0) continue;
      const double before = errorsAbove(profile[i - 1], errors);
      if ((height > 1) != (before > 1))
        take(std::lerp(profile[i - 1].coordinates[coordinate], place,
                       (1 - before) / (height - before)));
    }
  return {below, above};
}

double negligibleDecrease(const FitErrors& errors) {
  return 0.1 * errors.errorScale * errors.errorScale;
}

}  // namespace asperity
