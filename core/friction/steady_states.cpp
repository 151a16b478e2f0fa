#include "core/friction/steady_states.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include "core/contact/steady_sliding.h"
#include "core/friction/excitation.h"
#include "core/friction/ensemble.h"
#include "core/material/element_law.h"
#include "core/scene/plan.h"

namespace asperity {
namespace {

/// Values with a smaller relative difference are equal up to rounding: products computed in two
/// orders.
constexpr double kEqualWithin = 1e-13;

bool areEqual(double a, double b) {
  return a == b || std::abs(a - b) <= kEqualWithin * std::max(std::abs(a), std::abs(b));
}

/// The factors between the moduli and the relaxation times of two laws.
struct LawRatio {
  double modulus = 1, time = 1;
};

/// Returns the factors; nothing where the two are not the same law in other units.
std::optional<LawRatio> lawRatio(const ElementLaw& law, const ElementLaw& reference) {
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

/// Returns the surface without the parameters that only scale its heights.
Surface unscaledShape(const Surface& surface) {
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
  std::size_t index = 0;         // among the members of its lines
  double height = 1, force = 1;  // of the state, over those of the lines and the group
  Load load;                     // in these units; a pressure as the force that it means
  double velocity = 0;           // m/s, likewise
  std::size_t result = 0;        // index among the group's results
};

/// States of the same law on the same lines, except for units.
struct Group {
  Scene scene;  // the first state, whose moduli and times are the units
  ElementLaw law;
  std::vector<Member> members;
  std::vector<LoadCase> cases;
  std::size_t firstResult = 0;  // index of its results among those of its lines
};

/// Groups on the same lines, except for the scale of their heights. The unit of height is that of
/// the first state.
struct Lines {
  Surface shape;
  std::int64_t points;  // per element
  std::vector<Group> groups;
  std::size_t members = 0;
};

double loadAmount(const Load& load) {
  return load.kind == LoadKind::Force ? load.normalForce : load.depth;
}

/// Combines the members into cases of one load with ascending velocities, equal ones once, and
/// gives each member its index. Returns the number of different states.
std::size_t setCases(Group& group) {
  std::vector<Member*> order;
  for (Member& member : group.members) order.push_back(&member);
  std::ranges::stable_sort(order, {}, [](const Member* m) { return loadAmount(m->load); });
  std::size_t results = 0;
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    while (end < order.size() &&
           areEqual(loadAmount(order[end]->load), loadAmount(order[begin]->load)))
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

/// Divides the cases of all groups on some lines into pieces, each of which one thread slides on
/// one line. The pieces do not depend on the number of threads, because guesses go from state to
/// state within a piece.
class Pieces {
 public:
  explicit Pieces(std::span<const Group> groups) {
    for (const Group& group : groups) add(group);
  }

  std::span<const RealizationPart> parts() const { return parts_; }

 private:
  // The number of states of a piece: many compared with the making of a line, few compared with the
  // time of the slowest piece. Elements with arms cost about ten times as much.
  static constexpr std::size_t kStates = 512, kStatesWithArms = 64;

  void add(const Group& group) {
    const bool hasArms = group.law.kind() == ElementKind::Arms;
    const std::size_t most = hasArms ? kStatesWithArms : kStates;
    const std::span<const LoadCase> cases(group.cases);
    if (!hasArms && cases.size() > 1 && isTable(cases)) {
      const std::size_t rows = std::max<std::size_t>(1, most / cases.front().velocities.size());
      for (std::size_t i = 0; i < cases.size(); i += rows)
        addPart(group.scene, cases.subspan(i, std::min(rows, cases.size() - i)), true, most);
      return;
    }
    for (const LoadCase& one : cases) {
      if (one.velocities.size() <= most) {
        addPart(group.scene, {&one, 1}, false, most);
        continue;
      }
      for (std::size_t i = 0; i < one.velocities.size(); i += most) {
        const auto begin = one.velocities.begin() + static_cast<std::ptrdiff_t>(i);
        const auto count = std::min(most, one.velocities.size() - i);
        cut_.push_back({one.load, {begin, begin + static_cast<std::ptrdiff_t>(count)}});
        addPart(group.scene, {&cut_.back(), 1}, false, most);
      }
    }
  }

  /// Returns whether all forces have the same velocities, so that results at one force help at the
  /// next.
  static bool isTable(std::span<const LoadCase> cases) {
    return std::ranges::all_of(cases, [&](const LoadCase& one) {
      return one.load.kind == LoadKind::Force && one.load.normalForce > 0 &&
             one.velocities.front() > 0 && one.velocities == cases.front().velocities;
    });
  }

  void addPart(const Scene& scene, std::span<const LoadCase> cases, bool sharesForces,
               std::size_t most) {
    std::size_t states = 0;
    for (const LoadCase& one : cases) states += one.velocities.size();
    const bool begins = parts_.empty() || states_ + states > most;
    states_ = begins ? states : states_ + states;
    parts_.push_back({scene, cases, sharesForces, begins});
  }

  std::vector<RealizationPart> parts_;
  std::deque<LoadCase> cut_;  // pieces of long cases, which never move in memory
  std::size_t states_ = 0;    // in the newest piece
};

class States {
 public:
  States(std::span<const Scene> states, const StateOptions& options)
      : states_(states), options_(options) {
    for (std::size_t i = 0; i < states.size() && !options.stop.stop_requested(); ++i) add(i);
  }

  SteadyStates slide() {
    SteadyStates found;
    found.points.resize(states_.size());
    found.orderedRows.resize(states_.size());
    if (options_.keepsLines) found.muOfLines.resize(states_.size());
    if (options_.partial)
      for (const Lines& lines : lines_)
        totalLines_ += LineSource(lines.groups.front().scene, 1).lines();
    double done = 0;
    for (Lines& lines : lines_) {
      const double part = static_cast<double>(lines.members) / static_cast<double>(states_.size());
      if (!slide(lines, done, part, found)) {
        found.isComplete = false;
        return found;
      }
      done += part;
    }
    found.isComplete = !options_.stop.stop_requested();
    if (balances_ > 0)
      found.marginalFraction = static_cast<double>(marginal_) / static_cast<double>(balances_);
    return found;
  }

 private:
  /// Adds a state to its lines and its group. Those of the last states are tried first, because a
  /// state is likely to belong to them.
  void add(std::size_t index) {
    const Scene& scene = states_[index];
    const std::int64_t points = curvePointsPerElement(scene);
    const Surface shape = unscaledShape(scene.surface);
    const auto isSame = [&](const Lines& lines) {
      const Scene& first = lines.groups.front().scene;
      return lines.points == points && lines.shape == shape &&
             first.accuracy.scheme == scene.accuracy.scheme &&
             choosesAccuracy(first) == choosesAccuracy(scene) &&
             first.ensemble.realizations == scene.ensemble.realizations &&
             first.folder == scene.folder;
    };
    auto lines = std::find_if(lines_.rbegin(), lines_.rend(), isSame);
    if (lines == lines_.rend()) {
      lines_.push_back({shape, points, {}, 0});
      lines = lines_.rbegin();
    }
    const ElementLaw law = elementLaw(scene.elastomer);
    for (auto group = lines->groups.rbegin(); group != lines->groups.rend(); ++group) {
      // A pressure may be compared with a force as soon as the length of the line is known.
      const bool isDepth = scene.load.kind == LoadKind::Indentation;
      if (!(group->scene.interface == scene.interface) ||
          (group->scene.load.kind == LoadKind::Indentation) != isDepth)
        continue;
      const std::optional<LawRatio> ratio = lawRatio(law, group->law);
      if (!ratio) continue;
      addTo(*lines, *group, index, *ratio);
      return;
    }
    Scene reference = scene;
    reference.sliding.kind = SlidingKind::Steady;
    lines->groups.push_back({std::move(reference), law, {}, {}, 0});
    addTo(*lines, lines->groups.back(), index, {});
  }

  void addTo(Lines& lines, Group& group, std::size_t index, const LawRatio& ratio) const {
    const Scene& scene = states_[index];
    Member member;
    member.state = index;
    member.index = lines.members++;
    member.height = heightRatio(scene.surface, lines.groups.front().scene.surface);
    member.force = ratio.modulus * member.height;
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

  bool slide(Lines& lines, double done, double part, SteadyStates& found) {
    const LineSource source(lines.groups.front().scene, lines.points);
    std::size_t results = 0;
    for (Group& group : lines.groups) {
      for (Member& member : group.members) {
        member.load = loadOn(states_[member.state].load, source.length());
        member.load.normalForce /= member.force;
        member.load.depth /= member.height;
      }
      group.firstResult = results;
      results += setCases(group);
    }
    found.computed += results;
    const Pieces pieces(lines.groups);
    const std::int64_t total = source.lines();
    std::vector<CurveAverages> averages(lines.members, CurveAverages(source.orderedRows()));
    const RealizationWork work{source, pieces.parts()};
    for (const Group& group : lines.groups)
      for (const Member& member : group.members)
        found.orderedRows[member.state] = source.orderedRows();
    const auto take = [&](std::span<const SteadyResult> all) {
      for (const SteadyResult& result : all) {
        found.largestResidual = std::max(found.largestResidual, result.residual);
        marginal_ += result.marginalShare < 1 ? 1 : 0;
        ++balances_;
      }
      for (const Group& group : lines.groups)
        for (const Member& member : group.members) {
          const SteadyResult result =
              inUnitsOf(member, source.length(), all[group.firstResult + member.result]);
          averages[member.index].add(result);
          if (options_.keepsLines)
            found.muOfLines[member.state].push_back(result.mu + result.muInterface);
        }
    };
    const auto report = [&](std::int64_t lineCount) {
      if (options_.progress)
        options_.progress(done +
                          part * static_cast<double>(lineCount) / static_cast<double>(total));
      if (!options_.partial) return;
      setPoints(lines, source, averages, found);
      options_.partial(slidLines_ + lineCount, totalLines_, found.points);
    };
    if (!slideRealizations(work, total, options_.threads, options_.stop, take, report)) {
      if (options_.partial) setPoints(lines, source, averages, found);
      return false;
    }
    slidLines_ += total;
    return setPoints(lines, source, averages, found);
  }

  /// Makes the rows of the states from the averages over the lines so far. Returns false where the
  /// work was stopped before and no partial result is requested.
  bool setPoints(const Lines& lines, const LineSource& source,
                 const std::vector<CurveAverages>& averages, SteadyStates& found) const {
    LineProperties shared;
    const Scene* last = nullptr;
    for (const Group& group : lines.groups)
      for (const Member& member : group.members) {
        if (!options_.partial && options_.stop.stop_requested()) return false;
        const Scene& scene = states_[member.state];
        const bool needsWaves = !shared.waves && measuredFrequencies(scene.elastomer);
        if (!last || needsWaves) shared = lineProperties(source, scene.elastomer);
        last = &scene;
        CurvePoint& point = found.points[member.state];
        point = averages[member.index].point(scene.sliding.velocity);
        LawColumns(scene, shared.scaled(member.height)).addTo(point, averages[member.index]);
      }
    return true;
  }

  std::span<const Scene> states_;
  const StateOptions& options_;
  std::deque<Lines> lines_;
  std::int64_t slidLines_ = 0, totalLines_ = 0;  // done, and of all kinds of line together
  std::int64_t balances_ = 0, marginal_ = 0;
};

}  // namespace

SteadyStates slideStates(std::span<const Scene> states, const StateOptions& options) {
  return States(states, options).slide();
}

}  // namespace asperity
