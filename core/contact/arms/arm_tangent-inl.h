// This file has ArmTangent of arm_coefficients.h with the unknowns in the lanes of vectors: how the
// outcome of a pass answers to its start. It leaves out what a contact makes forgotten, so that
// fast arms cost nothing. The file is compiled once per instruction set.

#if defined(ASPERITY_ARM_TANGENT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ASPERITY_ARM_TANGENT_INL
#undef ASPERITY_ARM_TANGENT_INL
#else
#define ASPERITY_ARM_TANGENT_INL
#endif

#include <algorithm>

#include "core/contact/arms/arm_kernel.h"
#include "core/contact/kernels/wide-inl.h"

HWY_BEFORE_NAMESPACE();
namespace asperity {
namespace HWY_NAMESPACE {

class ArmTangentKernel {
 public:
  ArmTangentKernel(const ArmVectors& vectors, ArmJacobian& jacobian)
      : vectors_(vectors), jacobian_(jacobian), lanes_(lanesFor(vectors.arms + 1)) {}

  /// lengths: as of ArmWorkspace.
  void run(const std::vector<double>& lengths) {
    begin();
    // Arms are remembered over a contact from the slowest one on; of those that it makes forgotten
    // nothing is needed before or after.
    std::size_t remembered = armsRememberedAfter(lengths[0]);
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      const bool isLast = i + 1 == lengths.size();
      if (i % 2 == 0) {
        contact(lengths[i], remembered);
        // So the lanes of forgotten strains at the lowest point hold nothing from here on.
        if (i == 0) lanes_ = lanesFor(remembered + 1);
        if (!isLast) leave(remembered);
      } else {
        arc(lengths[i]);
        remembered = isLast ? vectors_.arms : armsRememberedAfter(lengths[i + 1]);
        enter(remembered);
      }
    }
    for (std::size_t i = remembered; i < vectors_.arms; ++i)
      std::fill_n(jacobian_.strain.row(i), lanes_, 0.0);
    // In arms that change much in a period, creep takes what their strains lose.
    for (std::size_t i = vectors_.slow; i < vectors_.arms; ++i) {
      double *change = jacobian_.change.row(i), *strain = jacobian_.strain.row(i);
      for (std::size_t k = 0; k < lanes_; k += One::kLanes)
        (-One::load(strain + k)).store(change + k);
      change[i + 1] += 1;
    }
  }

 private:
  static std::size_t lanesFor(std::size_t count) {
    return (count + One::kLanes - 1) / One::kLanes * One::kLanes;
  }

  /// Returns the number of arms, from the slowest on, of whose strains a contact of this length
  /// leaves something. The strains of all others are lost to the last digit.
  std::size_t armsRememberedAfter(double length) const {
    constexpr double kForgotten = 45;
    std::size_t count = vectors_.arms;
    while (count > 0 &&
           vectors_.arm.from(count - 1)[ArmVectors::Inverse * kWidestVector] * length > kForgotten)
      --count;
    return count;
  }

  void begin() {
    const std::size_t unknowns = vectors_.arms + 1;
    jacobian_.strain.shape(vectors_.arms, unknowns);
    jacobian_.change.shape(vectors_.arms, unknowns);
    jacobian_.volume.shape(1, unknowns);
    for (std::size_t i = 0; i < vectors_.arms; ++i) jacobian_.strain.row(i)[i + 1] = 1;
  }

  /// Lets the strains decay over a contact; what slow arms lose is creep.
  void contact(double length, std::size_t remembered) {
    jacobian_.volume.row(0)[0] += length;
    const One lengths = One::all(length);
    alignas(64) double lost[One::kLanes];
    for (std::size_t first = 0; first < remembered; first += One::kLanes) {
      const double* inverse = vectors_.arm.from(first) + ArmVectors::Inverse * kWidestVector;
      lostAfter(lengths * One::load(inverse)).store(lost);
      for (std::size_t i = first; i < std::min(first + One::kLanes, remembered); ++i) {
        const One share = One::all(lost[i - first]);
        double *strain = jacobian_.strain.row(i), *change = jacobian_.change.row(i);
        for (std::size_t k = 0; k < lanes_; k += One::kLanes) {
          const One e = One::load(strain + k), gone = share * e;
          (e - gone).store(strain + k);
          if (i < vectors_.slow) (One::load(change + k) + gone).store(change + k);
        }
      }
    }
  }

  /// Makes the rows of amplitudes from those of strains where contact ends.
  void leave(std::size_t remembered) {
    product(vectors_.modes, remembered, vectors_.ofCreep, jacobian_.strain, jacobian_.mode);
    for (std::size_t j = 0; j < vectors_.modes; ++j)
      jacobian_.mode.row(j)[0] += vectors_.mode.from(j)[ArmVectors::Settled * kWidestVector];
  }

  void arc(double length) {
    const One lengths = One::all(length);
    double* volume = jacobian_.volume.row(0);
    alignas(64) double lost[One::kLanes], mean[One::kLanes];
    for (std::size_t first = 0; first < vectors_.modes; first += One::kLanes) {
      const double* rate = vectors_.mode.from(first) + ArmVectors::Rate * kWidestVector;
      const One z = lengths * One::load(rate), gone = lostAfter(z);
      gone.store(lost);
      select(z > One::all(0), gone / z * lengths, lengths).store(mean);
      for (std::size_t j = first; j < std::min(first + One::kLanes, vectors_.modes); ++j) {
        const One share = One::all(lost[j - first]), over = One::all(mean[j - first]);
        double *mode = jacobian_.mode.row(j), *lostRow = jacobian_.lost.row(j);
        for (std::size_t k = 0; k < lanes_; k += One::kLanes) {
          const One a = One::load(mode + k), back = share * a;
          mulAdd(over, a, One::load(volume + k)).store(volume + k);
          back.store(lostRow + k);
          (a - back).store(mode + k);
        }
      }
    }
    // The creep of slow arms.
    for (std::size_t i = 0; i < vectors_.slow; ++i) {
      double* change = jacobian_.change.row(i);
      for (std::size_t k = 0; k < lanes_; k += One::kLanes) {
        One sum = One::load(change + k);
        for (std::size_t j = 0; j < vectors_.modes; ++j)
          sum = negMulAdd(One::all(vectors_.toCreep.row(j)[i]),
                          One::load(jacobian_.lost.row(j) + k), sum);
        sum.store(change + k);
      }
    }
  }

  /// Makes the rows of strains: those of the free surface, and what the line presses in beyond.
  void enter(std::size_t remembered) {
    product(remembered, vectors_.modes, vectors_.toCreep, jacobian_.mode, jacobian_.strain);
    for (std::size_t i = 0; i < remembered; ++i) jacobian_.strain.row(i)[0] += 1;
  }

  /// Computes to[i] = - sum over m of factor.row(m)[i] from[m], four rows of `to` at a time.
  void product(std::size_t rows, std::size_t terms, const AlignedRows& factor,
               const AlignedRows& from, AlignedRows& to) const {
    for (std::size_t k = 0; k < lanes_; k += One::kLanes) {
      std::size_t i = 0;
      for (; i + 4 <= rows; i += 4) {
        One sum0 = One::all(0), sum1 = sum0, sum2 = sum0, sum3 = sum0;
        for (std::size_t m = 0; m < terms; ++m) {
          const One x = One::load(from.row(m) + k);
          const double* by = factor.row(m) + i;
          sum0 = negMulAdd(One::all(by[0]), x, sum0);
          sum1 = negMulAdd(One::all(by[1]), x, sum1);
          sum2 = negMulAdd(One::all(by[2]), x, sum2);
          sum3 = negMulAdd(One::all(by[3]), x, sum3);
        }
        sum0.store(to.row(i) + k);
        sum1.store(to.row(i + 1) + k);
        sum2.store(to.row(i + 2) + k);
        sum3.store(to.row(i + 3) + k);
      }
      for (; i < rows; ++i) {
        One sum = One::all(0);
        for (std::size_t m = 0; m < terms; ++m)
          sum = negMulAdd(One::all(factor.row(m)[i]), One::load(from.row(m) + k), sum);
        sum.store(to.row(i) + k);
      }
    }
  }

  const ArmVectors& vectors_;
  ArmJacobian& jacobian_;
  std::size_t lanes_;
};

}  // namespace HWY_NAMESPACE
}  // namespace asperity
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
