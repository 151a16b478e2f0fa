#include "core/contact/arms/arm_kernel.h"

// The instruction sets are those of kernels.cpp: one lane, AVX2, AVX-512.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/contact/arms/arm_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// These includes come after it, as Highway requires.
#include "core/base/flush_denormals.h"
#include "core/contact/arms/arm_kernel-inl.h"
#include "core/contact/arms/arm_tangent-inl.h"

HWY_BEFORE_NAMESPACE();
namespace asperity {
namespace HWY_NAMESPACE {

void armPass(const PreparedProfile& line, const ArmVectors& vectors, double depth,
             const double* strain, Output output, ArmWorkspace& work) {
  ArmKernel kernel(line, vectors, work);
  if (output == Output::Everything)
    kernel.run<true>(depth, strain);
  else
    kernel.run<false>(depth, strain);
}

void completeStrains(const PreparedProfile& line, const ArmVectors& vectors, double* strain,
                     ArmWorkspace& work) {
  ArmKernel(line, vectors, work).completeStrains(strain);
}

void armJacobian(const ArmVectors& vectors, const ArmWorkspace& work, ArmJacobian& jacobian) {
  ArmTangentKernel(vectors, jacobian).run(work.lengths);
}

}  // namespace HWY_NAMESPACE
}  // namespace asperity
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asperity {

HWY_EXPORT(armPass);
HWY_EXPORT(completeStrains);
HWY_EXPORT(armJacobian);

void runArmPass(const PreparedProfile& line, const ArmVectors& vectors, double depth,
                std::span<const double> strain, Output output, ArmWorkspace& work) {
  const FlushDenormals flush(Traps::None);
  HWY_DYNAMIC_DISPATCH(armPass)(line, vectors, depth, strain.data(), output, work);
}

void findCompleteStrains(const PreparedProfile& line, const ArmVectors& vectors,
                         std::span<double> strain, ArmWorkspace& work) {
  const FlushDenormals flush(Traps::None);
  HWY_DYNAMIC_DISPATCH(completeStrains)(line, vectors, strain.data(), work);
}

ArmJacobian::ArmJacobian(const ArmVectors& vectors)
    : volume(1, vectors.arms + 1),
      change(vectors.arms, vectors.arms + 1),
      strain(vectors.arms, vectors.arms + 1),
      mode(vectors.modes, vectors.arms + 1),
      lost(vectors.modes, vectors.arms + 1) {}

void findArmJacobian(const ArmVectors& vectors, const ArmWorkspace& work, ArmJacobian& jacobian) {
  const FlushDenormals flush(Traps::None);
  HWY_DYNAMIC_DISPATCH(armJacobian)(vectors, work, jacobian);
}

}  // namespace asperity
#endif  // HWY_ONCE
