// The work of a study: chunks of simulations as states on common lines, several chunks at once,
// each written as soon as it is done. The results of a chunk are a function of the study and its
// number alone: they are the same for any number of threads, processes and shards. Threading: a
// function of its arguments, which uses several threads. Failure: a simulation that cannot run
// keeps its message in the store; std::runtime_error where the store cannot be written.
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>

#include "core/study/study_store.h"

namespace asperity {

struct StudyRunOptions {
  int threads = 0;  // 0: as many as the machine has
  std::stop_token stop;
  /// Called after every chunk with the simulations that are in the store, on one thread at a time.
  std::function<void(std::int64_t done)> progress;
};

/// Computes a chunk. Returns one without values where `stop` was requested.
StudyChunk computeChunk(const ParameterStudy& study, std::int64_t number, int threads = 1,
                        const std::stop_token& stop = {});

/// Computes every chunk of the store that is missing and that no other process works on. Returns
/// the number of simulations that it added.
std::int64_t runStudy(StudyStore& store, const StudyRunOptions& options = {});

/// What a study will cost.
struct StudyBudget {
  std::int64_t simulations = 0, done = 0, chunks = 0, chunk = 0;
  std::int64_t states = 0;  // balances of one mean: simulations times velocities
  std::int64_t lines = 0;   // that each is a mean over, in the base scene
  double seconds = 0;       // of what is missing, on `threads`, from a trial
  std::int64_t trial = 0;   // simulations of the trial
  std::int64_t trialFailures = 0;
  int threads = 1;
  double bytes = 0;  // of the whole store, about
};

/// Tries some simulations for about as long as `trialSeconds`. done: simulations that need not be
/// computed; all: that the store is to hold.
StudyBudget studyBudget(const ParameterStudy& study, std::int64_t all, std::int64_t done,
                        int threads, double trialSeconds = 0.5);

}  // namespace asperity
