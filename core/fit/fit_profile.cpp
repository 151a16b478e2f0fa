#include "core/fit/fit_profile.h"

#include <algorithm>
#include <cmath>

#include "core/base/input_error.h"
#include "core/base/statistics.h"

namespace asperity {

using Eigen::MatrixXd;
using Eigen::VectorXd;

ProfileWalk::ProfileWalk(const Objective& objective, const Minimum& best, double errorScale)
    : objective_(objective),
      best_(best),
      errorScale_(errorScale),
      residuals_(residualsAt(best.coordinates)) {}

std::vector<ProfilePoint> ProfileWalk::profile(int k, const VectorXd& along, int fewest) const {
  std::vector<ProfilePoint> points = side(k, -along, fewest);
  std::ranges::reverse(points);
  points.push_back({best_, 0});
  for (ProfilePoint& point : side(k, along, fewest)) points.push_back(std::move(point));
  return points;
}

std::vector<ProfilePoint> ProfileWalk::side(int k, const VectorXd& along, int fewest) const {
  constexpr double kFar = 2.5;  // deviations
  constexpr int kMost = 12;
  const VariedParameter& parameter = objective_.parameter(k);
  std::vector<ProfilePoint> points;
  VectorXd last = best_.coordinates, step = along;
  while (std::ssize(points) < kMost) {
    if (std::ssize(points) >= fewest && points.back().deviations >= kFar) break;
    VectorXd predicted = last + step;
    predicted[k] = last[k] + along[k];
    if (predicted[k] < parameter.lowest() || predicted[k] > parameter.highest()) {
      // The last value is the limit itself, if that is not all but reached.
      constexpr double kNear = 0.1;
      const double limit = along[k] < 0 ? parameter.lowest() : parameter.highest();
      if (std::abs(limit - last[k]) < kNear * std::abs(along[k])) break;
      predicted = last + step * ((limit - last[k]) / step[k]);
      predicted[k] = limit;
    }
    try {
      ProfilePoint point{held(k, withinLimits(predicted), last), 0};
      point.deviations = deviations(point.minimum);
      step = point.minimum.coordinates - last;
      last = point.minimum.coordinates;
      points.push_back(std::move(point));
    } catch (const InputError&) {
      break;  // a state that cannot slide
    }
  }
  return points;
}

Minimum ProfileWalk::held(int k, const VectorXd& predicted, const VectorXd& neighbour) const {
  constexpr int kIterations = 30;
  VectorXd beside = neighbour;
  beside[k] = predicted[k];
  const auto at = [&](const VectorXd& coordinates) {
    return Minimum{coordinates, objective_.chiSquared(objective_.evaluate(coordinates, {})), true};
  };
  const Minimum straight = at(predicted);
  std::vector<int> others;
  for (int j = 0; j < static_cast<int>(predicted.size()); ++j)
    if (j != k) others.push_back(j);
  if (others.empty()) return straight;
  const Minimum same = at(beside);
  const Minimum& start = straight.chiSquared <= same.chiSquared ? straight : same;
  Minimum found = minimize(objective_, start.coordinates, others, kIterations);
  if (found.hasConverged) return found;
  const Minimum& other = &start == &straight ? same : straight;
  Minimum second = minimize(objective_, other.coordinates, others, kIterations);
  return second.chiSquared < found.chiSquared ? second : found;
}

ProfileWalk::Residuals ProfileWalk::residualsAt(const VectorXd& coordinates) const {
  const FrictionWithDerivatives found = objective_.evaluate(coordinates, {});
  const auto n = static_cast<Eigen::Index>(objective_.size());
  Residuals residuals{VectorXd(n), scatterOfLines(found)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto point = static_cast<std::size_t>(i);
    residuals.ofMean[i] = objective_.residual(found, point);
    residuals.ofLines.row(i) /= objective_.deviation(point);
  }
  return residuals;
}

double ProfileWalk::deviations(const Minimum& minimum) const {
  const double rise = minimum.chiSquared - best_.chiSquared;
  if (rise <= 0) return 0;
  const Residuals there = residualsAt(minimum.coordinates);
  double variance = 0;  // of the rise, by the lines
  if (there.ofLines.cols() == residuals_.ofLines.cols())
    variance = 4 * (there.ofLines.transpose() * there.ofMean -
                    residuals_.ofLines.transpose() * residuals_.ofMean)
                       .squaredNorm();
  return rise / std::sqrt(errorScale_ * errorScale_ * rise + variance / 4);
}

VectorXd ProfileWalk::withinLimits(VectorXd coordinates) const {
  for (Eigen::Index j = 0; j < coordinates.size(); ++j) {
    const VariedParameter& parameter = objective_.parameter(static_cast<int>(j));
    coordinates[j] = std::clamp(coordinates[j], parameter.lowest(), parameter.highest());
  }
  return coordinates;
}

namespace {

/// Returns where a profile crosses one deviation between the last of its points that is nearer and
/// the next one. outwards: the points from the best one to one side.
std::optional<VectorXd> lastWithin(const std::vector<const ProfilePoint*>& outwards, int k,
                                   const VariedParameter& parameter) {
  std::size_t within = 0;
  for (std::size_t i = 0; i < outwards.size(); ++i)
    if (outwards[i]->deviations <= 1) within = i;
  const ProfilePoint& inner = *outwards[within];
  if (within + 1 < outwards.size()) {
    const ProfilePoint& outer = *outwards[within + 1];
    const double part = (1 - inner.deviations) / (outer.deviations - inner.deviations);
    return VectorXd(inner.minimum.coordinates +
                    part * (outer.minimum.coordinates - inner.minimum.coordinates));
  }
  const double end = inner.minimum.coordinates[k];
  if (end <= parameter.lowest() || end >= parameter.highest()) return inner.minimum.coordinates;
  return std::nullopt;
}

}  // namespace

ProfileRange rangeOfProfile(const Objective& objective, int k,
                            const std::vector<ProfilePoint>& profile) {
  const auto best = std::ranges::min_element(
      profile, {}, [](const ProfilePoint& point) { return point.minimum.chiSquared; });
  std::vector<const ProfilePoint*> below, above;
  for (auto point = best; point != profile.end(); ++point) above.push_back(&*point);
  for (auto point = profile.begin(); point <= best; ++point) below.insert(below.begin(), &*point);
  const VariedParameter& parameter = objective.parameter(k);
  return {lastWithin(below, k, parameter), lastWithin(above, k, parameter)};
}

}  // namespace asperity
