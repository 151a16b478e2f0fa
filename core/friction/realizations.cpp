#include "core/friction/realizations.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/jobs.h"
#include "core/contact/steady_solver.h"

namespace asperity {
namespace {

using Results = std::vector<SteadyResult>;

/// Memory that a thread uses again for one realization after another, also in later ensembles: the
/// system needs more time to allocate and free the pages of a long line than it takes to fill them,
/// and a cancelled ensemble would wait for that. Lines far shorter than the last one get new
/// memory. A line that several chunks of work need is kept.
struct Buffers {
  Line line;
  PreparedProfile profile;
  std::uint64_t owner = 0;  // the work that the profile belongs to; 0: none
  std::int64_t realization = 0;

  static Buffers& forNodes(std::int64_t nodes) {
    constexpr std::int64_t kMaxSpare = 16;
    thread_local Buffers buffers;
    if (static_cast<std::int64_t>(buffers.line.height.capacity()) > kMaxSpare * nodes) buffers = {};
    return buffers;
  }
};

std::size_t stateCount(const RealizationPart& part) {
  std::size_t count = 0;
  for (const LoadCase& one : part.cases) count += one.velocities.size();
  return count;
}

class Realizations {
 public:
  Realizations(const RealizationWork& work, int threads, const std::stop_token& stop)
      : work_(work), stop_(stop), jobs_(threads) {
    static std::atomic<std::uint64_t> owners{0};
    owner_ = ++owners;
    const Scene* last = nullptr;
    for (std::size_t i = 0; i < work.parts.size(); ++i) {
      const RealizationPart& part = work.parts[i];
      // Parts of one scene share its tables.
      if (&part.scene != last) solvers_.push_back(std::make_unique<SteadySolver>(part.scene));
      last = &part.scene;
      if (part.beginsChunk || chunks_.empty()) chunks_.push_back({i, i, states_});
      chunks_.back().end = i + 1;
      solverOf_.push_back(solvers_.size() - 1);
      states_ += stateCount(part);
    }
  }

  /// Computes realizations. The first call is for one realization, from whose depths the others
  /// begin.
  std::vector<Results> compute(std::int64_t first, std::int64_t count) {
    std::vector<Results> batch(static_cast<std::size_t>(count), Results(states_));
    const auto chunks = static_cast<std::int64_t>(chunks_.size());
    jobs_.run(count * chunks, [&](std::int64_t job) {
      const Chunk& chunk = chunks_[static_cast<std::size_t>(job % chunks)];
      Results& results = batch[static_cast<std::size_t>(job / chunks)];
      if (!stop_.stop_requested())
        slide(work_.first + first + job / chunks, chunk,
              std::span(results).subspan(chunk.firstState));
    });
    if (first_.empty()) first_ = batch.front();
    return batch;
  }

 private:
  /// Parts that one job slides on a line.
  struct Chunk {
    std::size_t begin = 0, end = 0, firstState = 0;
  };

  /// Makes the line of a realization; returns null where stop was requested.
  const PreparedProfile* lineOf(std::int64_t realization) const {
    Buffers& buffers = Buffers::forNodes(work_.source.nodes());
    if (buffers.owner == owner_ && buffers.realization == realization) return &buffers.profile;
    buffers.owner = 0;
    // The making of a long line takes as long as everything else.
    const Slopes slopes = work_.scheme() == Scheme::Linear ? Slopes::Omitted : Slopes::Computed;
    if (!work_.source.makeInto(buffers.line, realization, slopes, stop_) ||
        !prepareProfileInto(buffers.profile, buffers.line, work_.scheme(), stop_))
      return nullptr;
    buffers.owner = owner_;
    buffers.realization = realization;
    return &buffers.profile;
  }

  /// Slides one realization; stops early where stop is requested.
  void slide(std::int64_t realization, const Chunk& chunk, std::span<SteadyResult> left) {
    const PreparedProfile* profile = lineOf(realization);
    if (!profile) return;
    std::span<const SteadyResult> others(first_);
    if (!others.empty()) others = others.subspan(chunk.firstState);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const RealizationPart& part = work_.parts[i];
      const SteadySolver& solver = *solvers_[solverOf_[i]];
      const auto takeRows = [&](std::size_t size) {
        const std::span<SteadyResult> rows = left.first(size);
        left = left.subspan(size);
        const auto other = others.first(others.empty() ? 0 : size);
        others = others.subspan(other.size());
        return std::pair{rows, other};
      };
      if (part.sharesForces) {
        const auto [rows, other] = takeRows(stateCount(part));
        std::vector<double> forces;
        for (const LoadCase& one : part.cases)
          forces.push_back(loadOn(one.load, profile->length).normalForce);
        const std::span<const double> velocities = part.cases.front().velocities;
        if (!solver.sweepForces(*profile, forces, velocities, rows, stop_, other)) return;
        for (std::size_t k = 0; k < part.cases.size(); ++k)
          check(part.cases[k], rows.subspan(k * velocities.size(), velocities.size()), *profile,
                realization);
        continue;
      }
      for (const LoadCase& one : part.cases) {
        const auto [row, other] = takeRows(one.velocities.size());
        if (!solver.sweep(*profile, one.load, one.velocities, row, stop_, other)) return;
        check(one, row, *profile, realization);
      }
    }
  }

  /// Completes the results of a case, and throws where a balance is not met.
  static void check(const LoadCase& one, std::span<SteadyResult> row,
                    const PreparedProfile& profile, std::int64_t realization) {
    for (SteadyResult& result : row) result.rmsSlopeLine = profile.rmsSlope;
    const Message where = message("on realization {}", realization);
    for (std::size_t i = 0; i < row.size(); ++i) requireBalance(row[i], one.velocities[i], where);
  }

  const RealizationWork& work_;
  std::vector<std::unique_ptr<SteadySolver>> solvers_;
  std::vector<std::size_t> solverOf_;  // [part]
  std::vector<Chunk> chunks_;
  std::size_t states_ = 0;
  Results first_;
  const std::stop_token& stop_;
  Jobs jobs_;
  std::uint64_t owner_ = 0;
};

}  // namespace

bool slideRealizations(const RealizationWork& work, std::int64_t count, int threads,
                       const std::stop_token& stop, const TakeRealization& take,
                       const BatchDone& batchDone) {
  Realizations realizations(work, threads, stop);
  // The first result comes at once; later batches are large enough to keep all threads busy.
  for (std::int64_t done = 0, batch = 1; done < count;
       batch = std::min<std::int64_t>(2 * batch, 32)) {
    batch = std::min(batch, count - done);
    const std::vector<Results> finished = realizations.compute(done, batch);
    if (stop.stop_requested()) return false;
    for (const Results& results : finished) take(results);
    done += batch;
    if (batchDone) batchDone(done);
  }
  return true;
}

}  // namespace asperity
