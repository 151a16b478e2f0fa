#include "core/friction/steady_states.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "core/contact/steady_sliding.h"
#include "core/friction/realizations.h"
#include "core/material/element_law.h"
#include "core/scene/plan.h"

namespace asperity {
namespace {

/// Values closer than this differ by rounding only: two ways to the same product.
constexpr double kRounding = 1e-13;

bool areEqual(double a, double b) {
  return a == b || std::abs(a - b) <= kRounding * std::max(std::abs(a), std::abs(b));
}

/// How much larger the moduli and the relaxation times of a law are than those of another one.
struct LawRatio {
  double modulus = 1, time = 1;
};

/// None where the two are not the same law in other units.
std::optional<LawRatio> ratioOf(const ElementLaw& law, const ElementLaw& reference) {
  if (law.kind() != reference.kind() || law.arms.size() != reference.arms.size()) return {};
  if (!(law.equilibriumModulus > 0) || !(reference.equilibriumModulus > 0)) return {};
  LawRatio ratio;
  ratio.modulus = law.equilibriumModulus / reference.equilibriumModulus;
  if (!law.arms.empty())
    ratio.time = law.arms.front().relaxationTime / reference.arms.front().relaxationTime;
  else if (law.kind() == ElementKind::Kelvin)
    ratio.time = law.relaxationTime / reference.relaxationTime;
  if (!areEqual(law.viscosity, ratio.modulus * ratio.time * reference.viscosity)) return {};
  for (std::size_t i = 0; i < law.arms.size(); ++i)
    if (!areEqual(law.arms[i].modulus, ratio.modulus * reference.arms[i].modulus) ||
        !areEqual(law.arms[i].relaxationTime, ratio.time * reference.arms[i].relaxationTime))
      return {};
  return ratio;
}

/// The surface without what only scales its heights.
Surface shapeOf(const Surface& surface) {
  Surface shape = surface;
  if (surface.kind == SurfaceKind::SelfAffine && surface.rmsHeight > 0) shape.rmsHeight = 1;
  return shape;
}

double heightRatio(const Surface& surface, const Surface& reference) {
  return surface.kind == SurfaceKind::SelfAffine && surface.rmsHeight > 0
             ? surface.rmsHeight / reference.rmsHeight
             : 1;
}

/// A state in the units of its group.
struct Member {
  std::size_t state = 0;
  double height = 1, force = 1;  // of the state, over those of the group
  Load load;                     // in the group's units
  double velocity = 0;           // m/s, likewise
  std::size_t result = 0;        // place among the group's results
};

/// States that slide on the same lines with the same law, but for units.
struct Group {
  Surface shape;
  Scene scene;  // the first state, whose units are the group's
  ElementLaw law;
  std::int64_t points;  // per element
  std::vector<Member> members;
  std::vector<LoadCase> cases;
};

double amountOf(const Load& load) {
  return load.kind == LoadKind::Force ? load.normalForce : load.depth;
}

/// Gathers the members into cases of one load with ascending velocities, equal ones once, and tells
/// each member its place. Returns the number of different ones.
std::size_t setCases(Group& group) {
  std::vector<Member*> order;
  for (Member& member : group.members) order.push_back(&member);
  std::ranges::stable_sort(order, {}, [](const Member* m) { return amountOf(m->load); });
  std::size_t results = 0;
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    while (end < order.size() && areEqual(amountOf(order[end]->load), amountOf(order[begin]->load)))
      ++end;
    const std::span<Member*> same(order.data() + begin, end - begin);
    std::ranges::stable_sort(same, {}, &Member::velocity);
    LoadCase one{same.front()->load, {}};
    for (Member* member : same) {
      if (one.velocities.empty() || !areEqual(member->velocity, one.velocities.back()))
        one.velocities.push_back(member->velocity);
      member->result = results + one.velocities.size() - 1;
    }
    results += one.velocities.size();
    group.cases.push_back(std::move(one));
  }
  return results;
}

class States {
 public:
  States(std::span<const Scene> states, const StateOptions& options)
      : states_(states), options_(options) {
    for (std::size_t i = 0; i < states.size(); ++i) add(i);
  }

  SteadyStates slide() {
    SteadyStates found;
    found.points.resize(states_.size());
    if (options_.keepsLines) found.muOfLines.resize(states_.size());
    for (Group& group : groups_) found.computed += setCases(group);
    if (options_.partial)
      for (const Group& group : groups_) totalLines_ += LineSource(group.scene, 1).lines();
    double done = 0;
    for (const Group& group : groups_) {
      const double part =
          static_cast<double>(group.members.size()) / static_cast<double>(states_.size());
      if (!slide(group, done, part, found)) {
        found.isComplete = false;
        return found;
      }
      done += part;
    }
    if (balances_ > 0)
      found.marginalFraction = static_cast<double>(marginal_) / static_cast<double>(balances_);
    return found;
  }

 private:
  void add(std::size_t index) {
    const Scene& scene = states_[index];
    ElementLaw law = lawOf(scene.elastomer);
    const Surface shape = shapeOf(scene.surface);
    const std::int64_t points = pointsPerElementOfCurve(scene);
    // Neighbours are likely to be of one kind: the newest group comes first.
    for (auto group = groups_.rbegin(); group != groups_.rend(); ++group) {
      if (group->points != points || !(group->shape == shape) ||
          !(group->scene.interface == scene.interface) ||
          group->scene.accuracy.scheme != scene.accuracy.scheme ||
          group->scene.ensemble.realizations != scene.ensemble.realizations ||
          group->scene.load.kind != scene.load.kind)
        continue;
      const std::optional<LawRatio> ratio = ratioOf(law, group->law);
      if (!ratio) continue;
      addTo(*group, index, *ratio);
      return;
    }
    Scene reference = scene;
    reference.sliding.kind = SlidingKind::Steady;
    groups_.push_back({shape, std::move(reference), std::move(law), points, {}, {}});
    addTo(groups_.back(), index, {});
  }

  void addTo(Group& group, std::size_t index, const LawRatio& ratio) const {
    const Scene& scene = states_[index];
    Member member;
    member.state = index;
    member.height = heightRatio(scene.surface, group.scene.surface);
    member.force = ratio.modulus * member.height;
    member.load = scene.load;
    member.load.normalForce /= member.force;
    member.load.depth /= member.height;
    member.velocity = scene.sliding.velocity * ratio.time;
    group.members.push_back(member);
  }

  /// Returns a result of the group in the units of a member. length: the period, m.
  SteadyResult inUnitsOf(const Member& member, double length, SteadyResult result) const {
    result.mu *= member.height;
    result.indentation *= member.height;
    result.rmsSlopeContact *= member.height;
    result.rmsSlopeLine *= member.height;
    result.normalForce *= member.force;
    result.tangentialForce *= member.force * member.height;
    const Scene& scene = states_[member.state];
    if (result.muInterface != 0)
      result.muInterface = localFriction(interfaceAt(scene, scene.sliding.velocity),
                                         result.normalForce, result.contactFraction * length);
    return result;
  }

  /// Columns of the law for each member, in its own units.
  std::vector<LawColumns> columnsOf(const Group& group, const LineSource& source) const {
    std::vector<LawColumns> columns;
    for (const Member& member : group.members) {
      LineStatistics statistics = source.statistics();
      statistics.rmsHeight *= member.height;
      statistics.rmsSlope *= member.height;
      columns.emplace_back(states_[member.state], statistics, source);
    }
    return columns;
  }

  bool slide(const Group& group, double done, double part, SteadyStates& found) {
    const LineSource source(group.scene, group.points);
    const std::int64_t total = source.lines();
    const std::vector<LawColumns> columns = columnsOf(group, source);
    std::vector<CurveAverages> averages(group.members.size());
    const RealizationTask task{group.scene, source, group.cases, 0};
    const auto take = [&](std::span<const SteadyResult> results) {
      for (const SteadyResult& result : results) {
        found.largestResidual = std::max(found.largestResidual, result.residual);
        marginal_ += result.marginalShare < 1 ? 1 : 0;
        ++balances_;
      }
      for (std::size_t i = 0; i < group.members.size(); ++i) {
        const Member& member = group.members[i];
        const SteadyResult result = inUnitsOf(member, source.length(), results[member.result]);
        averages[i].add(result);
        if (options_.keepsLines)
          found.muOfLines[member.state].push_back(result.mu + result.muInterface);
      }
    };
    const auto setPoints = [&] {
      for (std::size_t i = 0; i < group.members.size(); ++i) {
        const std::size_t state = group.members[i].state;
        CurvePoint& point = found.points[state];
        point = averages[i].point(states_[state].sliding.velocity);
        columns[i].addTo(point, averages[i]);
      }
    };
    const auto report = [&](std::int64_t lines) {
      if (options_.progress)
        options_.progress(done + part * static_cast<double>(lines) / static_cast<double>(total));
      if (!options_.partial) return;
      setPoints();
      options_.partial(lines_ + lines, totalLines_, found.points);
    };
    if (!slideRealizations(task, total, options_.threads, options_.stop, take, report)) {
      if (options_.partial) setPoints();
      return false;
    }
    lines_ += total;
    setPoints();
    return true;
  }

  std::span<const Scene> states_;
  const StateOptions& options_;
  std::vector<Group> groups_;
  std::int64_t lines_ = 0, totalLines_ = 0;  // slid, and of all groups together
  std::int64_t balances_ = 0, marginal_ = 0;
};

}  // namespace

SteadyStates slideStates(std::span<const Scene> states, const StateOptions& options) {
  return States(states, options).slide();
}

}  // namespace asperity
