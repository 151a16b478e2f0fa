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
  constexpr int kMost = 12, kEven = 3;
  constexpr double kGrowth = 1.2;  // of later steps
  const VariedParameter& parameter = objective_.parameter(k);
  std::vector<ProfilePoint> points;
  VectorXd last = best_.coordinates, step = along;
  double stride = along[k];
  while (std::ssize(points) < kMost) {
    if (std::ssize(points) >= fewest && points.back().deviations >= kFar) break;
    if (std::ssize(points) >= kEven) stride *= kGrowth;
    VectorXd predicted = last + step * (stride / step[k]);
    predicted[k] = last[k] + stride;
    if (predicted[k] < parameter.lowest() || predicted[k] > parameter.highest()) {
      // The last value is the limit itself, if that is not all but reached.
      constexpr double kNear = 0.1;
      const double limit = along[k] < 0 ? parameter.lowest() : parameter.highest();
      if (std::abs(limit - last[k]) < kNear * std::abs(stride)) break;
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

std::optional<VectorXd> shareOfPoint(const VectorXd& best, const ProfilePoint& point) {
  constexpr double kMost = 2;
  if (point.deviations > kMost) return std::nullopt;
  return VectorXd(best + (point.minimum.coordinates - best) / std::max(1.0, point.deviations));
}

namespace {

/// Returns the end of the range to one side. outwards: the points from the best one to that side.
std::optional<VectorXd> endOf(const std::vector<const ProfilePoint*>& outwards, int k,
                              const VariedParameter& parameter) {
  const VectorXd& best = outwards.front()->minimum.coordinates;
  VectorXd end = best;
  const auto extend = [&](const VectorXd& to) {
    if (std::abs(to[k] - best[k]) > std::abs(end[k] - best[k])) end = to;
  };
  for (std::size_t i = 1; i < outwards.size(); ++i) {
    const ProfilePoint &inner = *outwards[i - 1], &outer = *outwards[i];
    if (const auto share = shareOfPoint(best, outer)) extend(*share);
    if (inner.deviations > 1 || outer.deviations <= 1) continue;
    const double part = (1 - inner.deviations) / (outer.deviations - inner.deviations);
    extend(inner.minimum.coordinates +
           part * (outer.minimum.coordinates - inner.minimum.coordinates));
  }
  const ProfilePoint& last = *outwards.back();
  const double there = last.minimum.coordinates[k];
  const bool isComplete =
      last.deviations > 1 || there <= parameter.lowest() || there >= parameter.highest();
  return isComplete ? std::optional(end) : std::nullopt;
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
  return {endOf(below, k, parameter), endOf(above, k, parameter)};
}

}  // namespace asperity
