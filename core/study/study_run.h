// Runs a study: chunks of simulations as states on common lines, several chunks at once, each
// stored as soon as it is computed. The results of a chunk depend on the study and the chunk's
// number alone: they are the same for any number of threads, processes and shards. Merges the
// stores of shards into one. Threading: functions of their arguments; running uses several threads.
// Failure: the store keeps the message of a simulation that cannot run; std::runtime_error where
// the store cannot be written; InputError where stores do not belong together.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <vector>

#include "core/study/study_store.h"

namespace asperity {

struct StudyRunOptions {
  int threads = 0;  // 0: as many as the machine has
  std::stop_token stop;
  /// Called after every chunk with the number of simulations in the store, on one thread at a time.
  std::function<void(std::int64_t done)> progress;
};

/// Computes every missing chunk of the store on which no other process works. Returns the number of
/// simulations that it added.
std::int64_t runStudy(StudyStore& store, const StudyRunOptions& options = {});

/// The predicted cost of a study.
struct StudyBudget {
  std::int64_t simulations = 0, done = 0, chunks = 0, chunk = 0;
  std::int64_t states = 0;  // balances of one mean: simulations times velocities
  std::int64_t lines = 0;   // number of lines of each mean, in the base scene
  double seconds = 0;       // for the missing simulations, on `threads`, from a trial
  std::int64_t trial = 0;   // simulations of the trial
  std::int64_t trialFailures = 0;
  int threads = 1;
  double bytes = 0;  // of the whole store, approximately
};

/// Predicts the cost from a trial of about `trialSeconds`. done: number of simulations that need
/// not be computed; all: number of those that the store will hold.
StudyBudget studyBudget(const ParameterStudy& study, std::int64_t all, std::int64_t done,
                        int threads, double trialSeconds = 0.5);

/// The result of a merge.
struct MergedStores {
  std::int64_t chunks = 0, chunksPlanned = 0;
  std::vector<Shard> missingShards;         // those without a store, where the stores are shards
  std::vector<std::int64_t> missingChunks;  // the first ones

  bool isWhole() const { return chunks == chunksPlanned; }
};

/// Merges stores of one study in any order, together with a store that exists at `output`. Throws
/// InputError where one of them belongs to another study, or two have different results of a chunk.
MergedStores mergeStores(const std::vector<std::filesystem::path>& inputs,
                         const std::filesystem::path& output);

}  // namespace asperity
