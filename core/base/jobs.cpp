#include "core/base/jobs.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <optional>

namespace asperity {
namespace {

/// oneTBB warns on stderr where an arena asks for more threads than the machine has, unless such a
/// limit has been set explicitly before.
std::optional<tbb::global_control> moreThanTheMachine(int threads) {
  const int usual = tbb::this_task_arena::max_concurrency();
  if (threads <= usual) return std::nullopt;
  return std::optional<tbb::global_control>(std::in_place,
                                            tbb::global_control::max_allowed_parallelism,
                                            static_cast<std::size_t>(threads));
}

}  // namespace

struct Jobs::Arena {
  explicit Arena(int wanted)
      : allowed(moreThanTheMachine(wanted)),
        threads(wanted > 0 ? wanted : tbb::task_arena::automatic) {}

  std::optional<tbb::global_control> allowed;
  tbb::task_arena threads;
};

Jobs::Jobs(int threads) : arena_(new Arena(threads)) {}

Jobs::~Jobs() = default;

void Jobs::runEach(std::int64_t count, Call one, const void* job) {
  arena_->threads.execute([&] {
    tbb::parallel_for(std::int64_t{0}, count, [=](std::int64_t number) { one(job, number); });
  });
}

}  // namespace asperity
