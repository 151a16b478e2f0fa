#include "core/contact/kernels/linear_kernel.h"

// As for the separate elements of lane_pass.cpp.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/contact/kernels/linear_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/base/flush_denormals.h"
#include "core/contact/kernels/linear_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace asperity {
namespace HWY_NAMESPACE {

bool passOnce(const PreparedProfile& line, const PassRequest& task, const PassQueue& queue,
              PassSums& sums) {
  return LinearKernel(line, task).run(queue, sums);
}

}  // namespace HWY_NAMESPACE
}  // namespace asperity
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asperity {

HWY_EXPORT(passOnce);

void passStraight(const PreparedProfile& line, PassQueue& queue) {
  const FlushDenormals flush(Traps::None);
  PassRequest task;
  PassSums sums;
  for (bool goOn = queue.begin(0, task); goOn; goOn = queue.next(0, sums, task))
    if (!HWY_DYNAMIC_DISPATCH(passOnce)(line, task, queue, sums)) return;
}

}  // namespace asperity
#endif  // HWY_ONCE
