#include "core/contact/kernels/kernels.h"

// One lane runs everywhere; AVX2 and AVX-512 are the instruction sets with a kernel of their own.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/contact/kernels/kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// These includes come after it, as Highway requires.
#include "core/base/flush_denormals.h"
#include "core/contact/kernels/cubic_kernel-inl.h"
#include "core/contact/kernels/linear_kernel-inl.h"
#include "core/contact/kernels/nodal_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace asperity {
namespace HWY_NAMESPACE {

void cubicPasses(const PreparedProfile& line, PassQueue& queue) {
  static_assert(Wide::kLanes <= kMaxStreams);
  CubicKernel(line, queue).run();
}

bool linearPass(const PreparedProfile& line, const PassRequest& request, const PassQueue& queue,
                PassSums& sums) {
  return LinearKernel(line, request).run(queue, sums);
}

using Lanes8 = hn::CappedTag<double, kMaxLanes>;
using OneLane = hn::CappedTag<double, 1>;

void nodalLanesForce(const PreparedProfile& line, const double* depth, const double* length,
                     NodalState* states) {
  NodalKernel<Lanes8, Output::Force>(line, depth, length).run(states);
}
void nodalLanes(const PreparedProfile& line, const double* depth, const double* length,
                NodalState* states) {
  NodalKernel<Lanes8, Output::Everything>(line, depth, length).run(states);
}
void nodalOneLane(const PreparedProfile& line, double depth, double length, NodalState& state,
                  NodeShape* shape) {
  if (shape)
    NodalKernel<OneLane, Output::Everything, true>(line, &depth, &length, shape).run(&state);
  else
    NodalKernel<OneLane, Output::Everything>(line, &depth, &length).run(&state);
}

std::size_t lanes() {
  return hn::Lanes(Lanes8());
}

}  // namespace HWY_NAMESPACE
}  // namespace asperity
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asperity {

HWY_EXPORT(cubicPasses);
HWY_EXPORT(linearPass);
HWY_EXPORT(nodalLanesForce);
HWY_EXPORT(nodalLanes);
HWY_EXPORT(lanes);

void runCubicPasses(const PreparedProfile& line, PassQueue& queue) {
  const FlushDenormals flush(Traps::None);
  HWY_DYNAMIC_DISPATCH(cubicPasses)(line, queue);
}

void runLinearPasses(const PreparedProfile& line, PassQueue& queue) {
  const FlushDenormals flush(Traps::None);
  PassRequest request;
  PassSums sums;
  for (bool goOn = queue.begin(0, request); goOn; goOn = queue.next(0, sums, request))
    if (!HWY_DYNAMIC_DISPATCH(linearPass)(line, request, queue, sums)) return;
}

namespace {

/// Completes the result of a nodal kernel at a depth.
void finish(NodalState& state, double depth, double spacing) {
  state.depth = depth;
  state.sums.stiffness = state.sums.contactLength = state.loaded * spacing;
}

}  // namespace

NodalState nodalPass(const PreparedProfile& line, double depth, double relaxationLength,
                     NodeShape* shape) {
  const FlushDenormals flush(Traps::None);
  NodalState state;
  HWY_STATIC_DISPATCH(nodalOneLane)(line, depth, relaxationLength, state, shape);
  finish(state, depth, line.spacing);
  return state;
}

std::size_t laneCount() {
  return HWY_DYNAMIC_DISPATCH(lanes)();
}

void nodalLanePass(const PreparedProfile& line, const LaneValues& depth,
                   const LaneValues& relaxationLength, Output output,
                   std::array<NodalState, kMaxLanes>& states) {
  const FlushDenormals flush(Traps::None);
  if (output == Output::Force) {
    HWY_DYNAMIC_DISPATCH(nodalLanesForce)
    (line, depth.data(), relaxationLength.data(), states.data());
  } else {
    HWY_DYNAMIC_DISPATCH(nodalLanes)(line, depth.data(), relaxationLength.data(), states.data());
  }
  for (std::size_t lane = 0; lane < kMaxLanes; ++lane)
    finish(states[lane], depth[lane], line.spacing);
}

namespace {

/// Initializes Highway's dispatch, whose function tables are indexed by the target found at the
/// first call.
void useTargets(std::int64_t mask) {
  hwy::SetSupportedTargetsForTest(mask);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

std::int64_t targetOf(InstructionSet set) {
  switch (set) {
    case InstructionSet::Scalar:
      return HWY_SCALAR;
    case InstructionSet::Avx2:
      return HWY_AVX2;
    case InstructionSet::Avx512:
      return HWY_AVX3;
    case InstructionSet::Best:
      break;
  }
  return 0;  // no restriction
}

}  // namespace

bool chooseInstructionSet(InstructionSet wanted) {
  useTargets(0);
  const std::int64_t target = targetOf(wanted);
  if (target != 0 && (hwy::SupportedTargets() & target) == 0) return false;
  useTargets(target);
  return true;
}

InstructionSet instructionSet() {
  const std::int64_t usable = hwy::SupportedTargets() & HWY_TARGETS;
  if (usable & HWY_AVX3) return InstructionSet::Avx512;
  if (usable & HWY_AVX2) return InstructionSet::Avx2;
  return InstructionSet::Scalar;
}

const char* instructionSetName(InstructionSet set) {
  switch (set) {
    case InstructionSet::Scalar:
      return "scalar";
    case InstructionSet::Avx2:
      return "AVX2";
    case InstructionSet::Avx512:
      return "AVX-512";
    case InstructionSet::Best:
      break;
  }
  return "best";
}

}  // namespace asperity
#endif  // HWY_ONCE
