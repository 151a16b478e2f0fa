#include "core/contact/kernels/cubic_kernel.h"

// As for the separate elements of lane_pass.cpp.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/contact/kernels/cubic_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/base/flush_denormals.h"
#include "core/contact/kernels/cubic_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace asperity {
namespace HWY_NAMESPACE {

void stream(const PreparedProfile& line, PassQueue& queue) {
  CubicKernel(line, queue).run();
}
std::size_t streams() {
  return Wide::kLanes;
}

}  // namespace HWY_NAMESPACE
}  // namespace asperity
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asperity {

HWY_EXPORT(stream);
HWY_EXPORT(streams);

std::size_t streamCount() {
  return HWY_DYNAMIC_DISPATCH(streams)();
}

void passLanes(const PreparedProfile& line, PassQueue& queue) {
  const FlushDenormals flush(Traps::None);
  HWY_DYNAMIC_DISPATCH(stream)(line, queue);
}

}  // namespace asperity
#endif  // HWY_ONCE
