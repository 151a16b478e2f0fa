#include "core/paper/load_shares.h"

#include <algorithm>
#include <cmath>

#include "core/base/jobs.h"
#include "core/base/stop.h"

namespace asperity {

LoadShares::LoadShares(const Scene& scene, std::vector<LoadCase> cases, std::int64_t lines,
                       const StateOptions& options)
    : cases_(std::move(cases)) {
  const LineSource source(scene, linePoints(scene));
  const std::size_t cells = cellIndex(cases_.size(), 0);
  std::vector<std::vector<Sums>> each(static_cast<std::size_t>(lines));
  Jobs(options.threads).run(lines, [&](std::int64_t r) {
    const PreparedProfile line = prepareProfile(source.make(r), scene.accuracy.scheme);
    std::vector<Sums>& sums = each[static_cast<std::size_t>(r)];
    for (const LoadCase& one : cases_)
      for (const double velocity : one.velocities) {
        if (options.stop.stop_requested()) return;
        sums.push_back(lineSums(line, slidingConditions(scene, velocity), one.load.normalForce));
      }
  });
  throwIfStopped(options.stop);
  groups_ = static_cast<int>(std::min<std::int64_t>(GroupedMeans::kGroups, lines));
  sums_.resize(static_cast<std::size_t>(groups_) * cells);
  for (std::size_t r = 0; r < each.size(); ++r)
    for (std::size_t cell = 0; cell < cells; ++cell)
      sums_[r % static_cast<std::size_t>(groups_) * cells + cell].add(each[r][cell]);
  if (options.progress) options.progress(1);
}

void LoadShares::Sums::add(const Sums& other) {
  load += other.load;
  trailing += other.trailing;
  elastic += other.elastic;
  frictionOverSlope += other.frictionOverSlope;
  lines += other.lines;
}

/// Returns the sums of a line. Material travels towards larger s: a leading side is one whose rise
/// falls along s.
LoadShares::Sums LoadShares::lineSums(const PreparedProfile& line,
                                      const SlidingConditions& conditions, double force) {
  const SteadyResult result = slideAtForce(line, conditions, force);
  const NodeShape shape = shapeAt(line, conditions, result.indentation);
  Sums sums;
  // The load is not the sum over the nodes, which miss contacts shorter than their distance.
  sums.load = force / (4 * conditions.shearModulus * line.spacing);
  for (std::size_t i = 0; i < line.segments(); ++i) {
    if (!(shape.pressure[i] > 0)) continue;
    sums.elastic += shape.depth[i];
    if (line.slopeIn[i] > 0) sums.trailing += shape.pressure[i];
  }
  if (std::isfinite(result.rmsSlopeContact)) {
    sums.frictionOverSlope = result.mu / result.rmsSlopeContact;
    sums.lines = 1;
  }
  return sums;
}

std::size_t LoadShares::cellIndex(std::size_t j, std::size_t i) const {
  return j * cases_.front().velocities.size() + i;
}

LoadShares::Sums LoadShares::sums(std::size_t j, std::size_t i, int leftOut) const {
  const std::size_t cells = cellIndex(cases_.size(), 0);
  Sums all;
  for (int group = 0; group < groups_; ++group)
    if (group != leftOut) all.add(sums_[static_cast<std::size_t>(group) * cells + cellIndex(j, i)]);
  return all;
}

double LoadShares::trailing(std::size_t j, std::size_t i, int leftOut) const {
  const Sums all = sums(j, i, leftOut);
  return all.trailing / all.load;
}

double LoadShares::elastic(std::size_t j, std::size_t i, int leftOut) const {
  const Sums all = sums(j, i, leftOut);
  return all.elastic / all.load;
}

double LoadShares::frictionOverSlope(std::size_t j, std::size_t i, int leftOut) const {
  const Sums all = sums(j, i, leftOut);
  return all.frictionOverSlope / all.lines;
}

}  // namespace asperity
