#include "core/friction/jobs.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace asperity {

struct Jobs::Arena {
  tbb::task_arena threads;
};

Jobs::Jobs(int threads)
    : arena_(new Arena{tbb::task_arena(threads > 0 ? threads : tbb::task_arena::automatic)}) {}

Jobs::~Jobs() = default;

void Jobs::runEach(std::int64_t count, Call one, const void* job) {
  arena_->threads.execute([&] {
    tbb::parallel_for(std::int64_t{0}, count, [=](std::int64_t number) { one(job, number); });
  });
}

}  // namespace asperity
