#include "core/friction/realizations.h"

#include <algorithm>
#include <vector>

#include "core/base/jobs.h"
#include "core/contact/steady_solver.h"

namespace asperity {
namespace {

using Results = std::vector<SteadyResult>;

/// Memory that a thread uses again for one realization after another, also in later ensembles: the
/// system needs more time to allocate and free the pages of a long line than it takes to fill them,
/// and a cancelled ensemble would wait for that. Lines far shorter than the last one get new
/// memory.
struct Buffers {
  Line line;
  PreparedProfile profile;

  static Buffers& forNodes(std::int64_t nodes) {
    constexpr std::int64_t kMostSpare = 16;
    thread_local Buffers buffers;
    if (static_cast<std::int64_t>(buffers.line.height.capacity()) > kMostSpare * nodes)
      buffers = {};
    return buffers;
  }
};

class Realizations {
 public:
  Realizations(const RealizationTask& task, int threads, const std::stop_token& stop)
      : task_(task), sliding_(task.scene), stop_(stop), jobs_(threads) {}

  /// Computes realizations. The first call is for one realization, from whose depths the others
  /// begin.
  std::vector<Results> compute(std::int64_t first, std::int64_t count) {
    std::vector<Results> batch(static_cast<std::size_t>(count));
    jobs_.run(count, [&](std::int64_t i) {
      if (!stop_.stop_requested())
        batch[static_cast<std::size_t>(i)] = slide(task_.first + first + i);
    });
    if (first_.empty()) first_ = batch.front();
    return batch;
  }

 private:
  /// Slides one realization; stops early where stop is requested.
  Results slide(std::int64_t realization) {
    Buffers& buffers = Buffers::forNodes(task_.source.nodes());
    const Scheme scheme = task_.scene.accuracy.scheme;
    // The making of a long line takes as long as everything else.
    const Slopes slopes = scheme == Scheme::Linear ? Slopes::NotWanted : Slopes::Wanted;
    if (!task_.source.makeInto(buffers.line, realization, slopes, stop_) ||
        !prepareProfileInto(buffers.profile, buffers.line, scheme, Direction::Forward, stop_))
      return {};
    std::size_t count = 0;
    for (const LoadCase& one : task_.cases) count += one.velocities.size();
    Results results(count);
    std::span<SteadyResult> left(results);
    std::span<const SteadyResult> others(first_);
    for (const LoadCase& one : task_.cases) {
      const std::span<SteadyResult> row = left.first(one.velocities.size());
      left = left.subspan(row.size());
      const auto other = others.first(others.empty() ? 0 : row.size());
      others = others.subspan(other.size());
      if (!sliding_.sweep(buffers.profile, one.load, one.velocities, row, stop_, other)) return {};
      for (SteadyResult& result : row) result.rmsSlopeLine = buffers.profile.rmsSlope;
      requireBalances(one, row, realization);
    }
    return results;
  }

  static void requireBalances(const LoadCase& one, std::span<const SteadyResult> row,
                              std::int64_t realization) {
    const Message where = message("on realization {}", realization);
    for (std::size_t i = 0; i < row.size(); ++i) requireBalance(row[i], one.velocities[i], where);
  }

  const RealizationTask& task_;
  SteadySolver sliding_;
  Results first_;
  const std::stop_token& stop_;
  Jobs jobs_;
};

}  // namespace

bool slideRealizations(const RealizationTask& task, std::int64_t count, int threads,
                       const std::stop_token& stop, const TakeRealization& take,
                       const BatchDone& batchDone) {
  Realizations realizations(task, threads, stop);
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
