#include "core/contact/kernels/kernels.h"

// The instruction sets are those of kernels.cpp: one lane, AVX2, AVX-512.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/contact/kernels/nodal_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// This include comes after it, as Highway requires.
#include "core/base/flush_denormals.h"
#include "core/contact/kernels/nodal_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace asperity {
namespace HWY_NAMESPACE {

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

HWY_EXPORT(nodalLanesForce);
HWY_EXPORT(nodalLanes);
HWY_EXPORT(lanes);

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

}  // namespace asperity
#endif  // HWY_ONCE
