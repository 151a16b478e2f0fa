#include "core/study/study_run.h"

#include <fmt/format.h>
#include <unistd.h>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <set>
#include <thread>

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/base/jobs.h"
#include "core/friction/curve_file.h"
#include "core/friction/steady_states.h"
#include "core/scene/sweep.h"
#include "core/study/curve_fits.h"

namespace asperity {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Computes the simulations of one chunk.
class ChunkWork {
 public:
  ChunkWork(const ParameterStudy& study, int threads, const std::stop_token& stop)
      : study_(study),
        curveValues_(study.curveValues()),
        wantsFits_(std::ranges::any_of(
            study.outputs, [](const StudyOutput& output) { return output.fit.has_value(); })) {
    options_.threads = threads;
    options_.stop = stop;
  }

  StudyChunk compute(std::int64_t first, std::int64_t count) {
    const Clock::time_point start = Clock::now();
    chunk_.first = first;
    chunk_.count = count;
    chunk_.values.assign(study_.numbers() * static_cast<std::size_t>(count), kNotApplicable);
    makeStates();
    slide(0, static_cast<std::int64_t>(simulations_.size()));
    if (options_.stop.stop_requested()) chunk_.values.clear();
    std::ranges::sort(chunk_.failures, {}, &StudyFailure::simulation);
    chunk_.seconds = secondsSince(start);
    return std::move(chunk_);
  }

 private:
  /// Makes the states of all simulations that are possible: first at the scene's own velocity, then
  /// along its curve.
  void makeStates() {
    std::vector<double> point(study_.space.columns());
    const std::size_t each = study_.states();
    states_.reserve(static_cast<std::size_t>(chunk_.count) * each);
    for (std::int64_t i = 0; i < chunk_.count; ++i) {
      const std::size_t before = states_.size();
      try {
        study_.space.pointInto(chunk_.first + i, point);
        Scene scene = study_.sceneAt(point);
        for (const double value : curveValues_) states_.push_back(asperity::sceneAt(scene, value));
        if (study_.wantsPoint()) states_.push_back(scene);
        if (wantsFits_) curveScenes_.push_back(std::move(scene));
        simulations_.push_back(i);
      } catch (const InputError& error) {
        states_.resize(before);
        fail(i, error);
      }
    }
  }

  /// Slides some of the simulations together. Where one of them fails, its half is slid again
  /// without the other half; the halves depend on the chunk alone.
  void slide(std::int64_t begin, std::int64_t end) {
    if (begin == end || options_.stop.stop_requested()) return;
    const std::size_t each = study_.states();
    const std::span<const Scene> states(states_.data() + static_cast<std::size_t>(begin) * each,
                                        static_cast<std::size_t>(end - begin) * each);
    try {
      const SteadyStates slid = slideStates(states, options_);
      if (!slid.isComplete) return;
      for (std::int64_t i = begin; i < end; ++i)
        take(i, std::span(slid.points).subspan(static_cast<std::size_t>(i - begin) * each, each));
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::runtime_error& error) {
      if (end - begin == 1) {
        fail(simulations_[static_cast<std::size_t>(begin)], error);
        return;
      }
      const std::int64_t middle = begin + (end - begin) / 2;
      slide(begin, middle);
      slide(middle, end);
    }
  }

  /// Stores the numbers of a simulation, which is counted among the possible ones.
  void take(std::int64_t number, std::span<const CurvePoint> points) {
    const auto index = static_cast<std::size_t>(number);
    auto cell = static_cast<std::size_t>(simulations_[index]);
    CurveFitValues fits{};
    if (wantsFits_)
      fits = curveFits(curveScenes_[index], curveValues_, points.first(curveValues_.size()));
    const auto put = [&](double value) {
      chunk_.values[cell] = value;
      cell += static_cast<std::size_t>(chunk_.count);
    };
    for (const StudyOutput& output : study_.outputs)
      if (output.fit)
        put(fits[static_cast<std::size_t>(*output.fit)]);
      else if (!output.isCurve)
        put(curveValue(points.back(), output.column));
      else
        for (const CurvePoint& point : points.first(curveValues_.size()))
          put(curveValue(point, output.column));
  }

  void fail(std::int64_t simulation, const std::exception& error) {
    chunk_.failures.push_back({chunk_.first + simulation, errorMessage(error).english()});
  }

  const ParameterStudy& study_;
  const std::vector<double> curveValues_;
  const bool wantsFits_;
  StateOptions options_;
  StudyChunk chunk_;
  std::vector<std::int64_t> simulations_;  // the possible ones, counted in the chunk
  std::vector<Scene> states_;
  std::vector<Scene> curveScenes_;  // of the same simulations, where fits are wanted
};

/// Computes a chunk. Returns one without values where `stop` was requested.
StudyChunk computeChunk(const ParameterStudy& study, std::int64_t number, int threads,
                        const std::stop_token& stop) {
  StudyChunk chunk =
      ChunkWork(study, threads, stop).compute(number * study.chunk, study.sizeOfChunk(number));
  chunk.number = number;
  return chunk;
}

/// The chunks of a store, which several threads take.
class StudyRun {
 public:
  StudyRun(StudyStore& store, const StudyRunOptions& options)
      : store_(store), options_(options), done_(store.simulationsDone()) {}

  std::int64_t run() {
    // A further round takes the chunks that another process has left.
    while (runRound() > 0 && !isStopping_) {
    }
    if (failure_) std::rethrow_exception(failure_);
    if (store_.isWhole()) store_.finish();
    return added_;
  }

 private:
  /// Computes every free chunk once; returns the number of simulations that it added.
  std::int64_t runRound() {
    next_ = 0;
    addedInRound_ = 0;
    const int threads = threadCount(options_.threads);
    const std::int64_t missing =
        static_cast<std::int64_t>(store_.missing(static_cast<std::size_t>(threads)).size());
    if (missing == 0) return 0;
    // Few chunks are computed one after the other, each on all threads.
    const bool isWide = missing >= threads;
    const int workers = isWide ? threads : 1, each = isWide ? 1 : threads;
    {
      std::vector<std::jthread> others;
      for (int i = 1; i < workers; ++i) others.emplace_back([this, each] { work(each); });
      work(each);
    }
    return addedInRound_;
  }

  void work(int threads) {
    try {
      while (!isStopping_ && !options_.stop.stop_requested()) {
        const std::int64_t number = claim();
        if (number < 0) return;
        const StudyChunk chunk = computeChunk(store_.study(), number, threads, options_.stop);
        if (chunk.values.empty()) return;
        add(chunk);
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      isStopping_ = true;
    }
  }

  std::int64_t claim() {
    const std::lock_guard lock(mutex_);
    if (next_ < 0) return -1;
    const std::int64_t number = store_.claim(next_);
    next_ = number < 0 ? -1 : number + 1;
    return number;
  }

  void add(const StudyChunk& chunk) {
    const std::lock_guard lock(mutex_);
    store_.add(chunk);
    ++addedInRound_;
    added_ += chunk.count;
    done_ += chunk.count;
    if (options_.progress) options_.progress(done_);
  }

  StudyStore& store_;
  const StudyRunOptions& options_;
  std::mutex mutex_;
  std::atomic<bool> isStopping_{false};
  std::exception_ptr failure_;
  std::int64_t next_ = 0, added_ = 0, addedInRound_ = 0, done_ = 0;
};

}  // namespace

std::int64_t runStudy(StudyStore& store, const StudyRunOptions& options) {
  return StudyRun(store, options).run();
}

StudyBudget studyBudget(const ParameterStudy& study, std::int64_t all, std::int64_t done,
                        int threads, double trialSeconds) {
  StudyBudget budget{.simulations = all,
                     .done = done,
                     .chunks = study.chunks(),
                     .chunk = study.chunk,
                     .threads = threadCount(threads)};
  budget.states = all * static_cast<std::int64_t>(study.states());
  budget.lines = mayHaveManyLines(study.base.surface) ? study.base.ensemble.realizations : 1;
  constexpr double kBytesOfRow = 150;
  budget.bytes = static_cast<double>(all) * static_cast<double>(8 * study.numbers()) +
                 static_cast<double>(all) / static_cast<double>(study.chunk) * kBytesOfRow;
  // The trial doubles the number of simulations, from the middle of the study, until they take long
  // enough: together they share their lines, as in the run.
  const std::int64_t most = std::min(study.chunk, study.simulations());
  double seconds = 0;
  for (std::int64_t count = 1; budget.trial == 0 || seconds < trialSeconds / 2; count *= 2) {
    const std::int64_t tried = std::min(count, most);
    if (tried == budget.trial) break;
    const std::int64_t first = (study.simulations() - tried) / 2;
    const StudyChunk chunk = ChunkWork(study, 1, {}).compute(first, tried);
    budget.trial = tried;
    budget.trialFailures = static_cast<std::int64_t>(chunk.failures.size());
    seconds = chunk.seconds;
  }
  budget.seconds =
      seconds / static_cast<double>(budget.trial) * static_cast<double>(all - done) /
      std::min<double>(budget.threads, static_cast<double>(std::max<std::int64_t>(1, all - done)));
  return budget;
}

namespace {

namespace fs = std::filesystem;

/// The file into which stores are merged, beside the one that gets its place in the end.
class PartOfStore {
 public:
  explicit PartOfStore(const fs::path& output) : file_(output) {
    file_ += fmt::format(".{}.part", ::getpid());
    remove();  // what an earlier process of this number has left
  }
  ~PartOfStore() { remove(); }
  PartOfStore(const PartOfStore&) = delete;
  PartOfStore& operator=(const PartOfStore&) = delete;

  const fs::path& file() const { return file_; }

 private:
  void remove() const {
    std::error_code ignored;
    for (const char* end : {"", "-wal", "-shm", "-journal"})
      fs::remove(fs::path(file_) += end, ignored);
  }

  fs::path file_;
};

/// Opens the inputs, and the output where there is one. Throws InputError where there are none, or
/// they are not of the same study.
std::vector<StudyStore> openStores(const std::vector<fs::path>& inputs, const fs::path& output) {
  std::vector<StudyStore> stores;
  std::error_code ignored;
  for (const fs::path& input : inputs) {
    if (fs::equivalent(input, output, ignored)) continue;  // the output is read in any case
    stores.emplace_back(input);
  }
  if (fs::exists(output, ignored)) stores.emplace_back(output);
  if (stores.empty()) throw InputError("", "", "there is no store to merge");
  const StudyStore& first = stores.front();
  for (const StudyStore& store : stores)
    if (store.study().digest != first.study().digest)
      throw InputError(
          store.file().string(), "",
          message("is of another study than {}: {}", first.file().string(),
                  describeDifference(first.study().canonical, store.study().canonical)));
  return stores;
}

/// Adds the chunks of a store, some at a time.
void addChunks(StudyStore& joined, const StudyStore& store) {
  constexpr std::size_t kTogether = 64;
  std::vector<StudyChunk> chunks;
  store.eachChunk([&](const StudyChunk& chunk) {
    chunks.push_back(chunk);
    if (chunks.size() == kTogether) {
      joined.addEqual(chunks, store.file());
      chunks.clear();
    }
    return true;
  });
  joined.addEqual(chunks, store.file());
}

/// Returns the first shards of which there is no store, where the study was divided into shards.
std::vector<Shard> missingShards(const std::vector<StudyStore>& stores) {
  constexpr std::size_t kMax = 16;
  std::int64_t count = 1;
  std::set<std::int64_t> known;
  for (const StudyStore& store : stores) count = std::max(count, store.shard().count);
  for (const StudyStore& store : stores)
    if (store.shard().count == count) known.insert(store.shard().number);
  std::vector<Shard> missing;
  for (std::int64_t i = 1; count > 1 && i <= count && missing.size() < kMax; ++i)
    if (!known.contains(i)) missing.push_back({i, count});
  return missing;
}

}  // namespace

MergedStores mergeStores(const std::vector<fs::path>& inputs, const fs::path& output) {
  checkWritable(output);
  std::vector<StudyStore> stores = openStores(inputs, output);
  const PartOfStore part(output);
  MergedStores merged;
  {
    StudyStore joined(part.file(), stores.front().study(), {});
    for (const StudyStore& store : stores) addChunks(joined, store);
    merged.chunks = joined.chunksDone();
    merged.chunksPlanned = joined.chunksPlanned();
    merged.missingChunks = joined.missing(8);
    joined.finish();
  }
  if (!merged.isWhole()) merged.missingShards = missingShards(stores);
  stores.clear();
  fs::rename(part.file(), output);
  return merged;
}

}  // namespace asperity
