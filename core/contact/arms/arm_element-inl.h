// This file has one element with arms whose arms (or modes) lie in the lanes of vectors: the
// strains in contact, the amplitudes of the free surface, and what both add to the sums. The kernel
// of arm_kernel-inl.h finds where contact begins and ends. ArmPass has the same in plain form. The
// file is compiled once per instruction set.

#if defined(ASPERITY_ARM_ELEMENT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ASPERITY_ARM_ELEMENT_INL
#undef ASPERITY_ARM_ELEMENT_INL
#else
#define ASPERITY_ARM_ELEMENT_INL
#endif

#include <algorithm>
#include <utility>

#include "core/contact/arms/arm_coefficients.h"
#include "core/contact/arms/arm_decay-inl.h"
#include "core/contact/line/polynomial.h"

HWY_BEFORE_NAMESPACE();
namespace asperity {
namespace HWY_NAMESPACE {

/// A part of a segment in contact: w (m) over u in [0, 1], in the direction of travel.
struct ContactPiece {
  Cubic depth;
  double length;  // m

  HWY_INLINE ContactPiece until(double u) const {
    return {{depth.c0, depth.c1 * u, depth.c2 * u * u, depth.c3 * u * u * u}, length * u};
  }
};

/// A batch holds whole segments that follow each other, one in each lane, over which
/// w' = (D_0 + D_1 u + D_2 u^2) / spacing. The sums over the arms stand at the start of each
/// segment and, in the last entry, at the end of the last one.
struct SegmentBatch {
  static constexpr std::size_t kCount = One::kLanes;

  alignas(64) double d0[kCount], d1[kCount], d2[kCount];
  alignas(64) double strainSum[kCount + 1], lossSum[kCount + 1];  // m; sum g_i e_i / c_i
};

class ArmElement {
 public:
  ArmElement(const ArmVectors& vectors, ArmWorkspace& work)
      : vectors_(vectors),
        armLanes_(lanesFor(vectors.arms)),
        slowLanes_(lanesFor(vectors.slow)),
        modeLanes_(lanesFor(vectors.modes)),
        strain_(work.rows.row(ArmWorkspace::Strain)),
        trial_(work.rows.row(ArmWorkspace::Trial)),
        amplitude_(work.rows.row(ArmWorkspace::Amplitude)),
        arcAmplitude_(work.rows.row(ArmWorkspace::ArcAmplitude)),
        creep_(work.rows.row(ArmWorkspace::Creep)),
        after_(work.rows.row(ArmWorkspace::After)),
        afterStride_(static_cast<std::size_t>(work.rows.row(ArmWorkspace::After + 1) - after_)) {}

  /// Takes the strains (m) that the pass begins with.
  HWY_INLINE void begin(const double* strain) {
    std::copy_n(strain, vectors_.arms, strain_);
    std::fill_n(creep_, slowLanes_, 0.0);
    trialLength_ = -1;
    sumStrains();
  }
  const double* strains() const { return strain_; }
  const double* creep() const { return creep_; }

  // ---- In contact

  /// Returns p / 4G at the start of a piece, where the present strains are.
  HWY_INLINE ValueAndSlope pressure(const ContactPiece& piece) const {
    return pressureWith(strainSum_, lossSum_, piece, 0);
  }

  /// Computes the strains at the end of each segment of a batch, and the sums over the arms from
  /// which the pressure follows. Nothing is taken over yet, as contact may end within the batch.
  HWY_INLINE void drive(SegmentBatch& batch) {
    constexpr std::size_t kCount = SegmentBatch::kCount;
    // All segments go through the arms of one vector before the next vector: the coefficients and
    // the sums stay in registers, and only e waits for the segment before.
    One strainSum[kCount], lossSum[kCount];
    for (std::size_t n = 0; n < kCount; ++n) strainSum[n] = lossSum[n] = One::all(0);
    for (std::size_t k = 0; k < armLanes_; k += One::kLanes) {
      const Quantities arm = armsFrom(k);
      const One kept = arm[ArmVectors::Kept], g = arm[ArmVectors::Modulus],
                lossRate = arm[ArmVectors::LossRate], driven0 = arm[ArmVectors::Driven0],
                driven1 = arm[ArmVectors::Driven1], driven2 = arm[ArmVectors::Driven2];
      One e = One::load(strain_ + k);
      double* after = after_ + k;
      for (std::size_t n = 0; n < kCount; ++n, after += afterStride_) {
        const One driven =
            mulAdd(One::all(batch.d0[n]), driven0,
                   mulAdd(One::all(batch.d1[n]), driven1, One::all(batch.d2[n]) * driven2));
        e = mulAdd(kept, e, driven);
        e.store(after);
        strainSum[n] = mulAdd(g, e, strainSum[n]);
        lossSum[n] = mulAdd(lossRate, e, lossSum[n]);
      }
    }
    batch.strainSum[0] = strainSum_;
    batch.lossSum[0] = lossSum_;
    for (std::size_t n = 0; n < kCount; ++n) {
      const TwoSums sums = sumsOf(strainSum[n], lossSum[n]);
      batch.strainSum[n + 1] = sums.x;
      batch.lossSum[n + 1] = sums.y;
    }
  }

  /// Moves on over the first `count` segments of a batch that was driven. spacing: their length
  /// (m). The elastic part of the sums is left to the caller.
  template <bool Everything>
  HWY_INLINE void take(const SegmentBatch& batch, std::size_t count, double spacing,
                       PassSums& sums) {
    if (count == 0) return;
    const auto sumOfFirst = [count](One x) { return sumOf(onlyIn({hn::FirstN(kTag, count)}, x)); };
    const One d0 = One::load(batch.d0), d1 = One::load(batch.d1), d2 = One::load(batch.d2);
    // The creep of slow arms.
    if (slowLanes_ > 0) {
      const One sum0 = One::all(sumOfFirst(d0)), sum1 = One::all(sumOfFirst(d1)),
                sum2 = One::all(sumOfFirst(d2));
      for (std::size_t k = 0; k < slowLanes_; k += One::kLanes) {
        const Quantities arm = armsFrom(k);
        One strains = One::load(strain_ + k);
        for (std::size_t n = 0; n + 1 < count; ++n)
          strains = strains + One::load(after_ + n * afterStride_ + k);
        const One driven =
            mulAdd(sum0, arm[ArmVectors::CreepDriven0],
                   mulAdd(sum1, arm[ArmVectors::CreepDriven1],
                          mulAdd(sum2, arm[ArmVectors::CreepDriven2], One::load(creep_ + k))));
        mulAdd(arm[ArmVectors::CreepKept], strains, driven).store(creep_ + k);
      }
    }
    if constexpr (Everything) {
      // Integrals over a segment are forms in its strains and D_k: the forms' terms are summed over
      // the segments first.
      One strain = One::all(0), work = One::all(0), loss = One::all(0);
      for (std::size_t k = 0; k < armLanes_; k += One::kLanes) {
        const Quantities arm = armsFrom(k);
        One e = One::load(strain_ + k);
        One sum = One::all(0), square = sum, with0 = sum, with1 = sum, with2 = sum;
        for (std::size_t n = 0; n < count; ++n) {
          sum = sum + e;
          square = mulAdd(e, e, square);
          with0 = mulAdd(One::all(batch.d0[n]), e, with0);
          with1 = mulAdd(One::all(batch.d1[n]), e, with1);
          with2 = mulAdd(One::all(batch.d2[n]), e, with2);
          e = One::load(after_ + n * afterStride_ + k);
        }
        strain = mulAdd(arm[ArmVectors::Moment0], sum, strain);
        work = mulAdd(
            arm[ArmVectors::Moment0], with0,
            mulAdd(arm[ArmVectors::Moment1], with1, mulAdd(arm[ArmVectors::Moment2], with2, work)));
        loss = mulAdd(arm[ArmVectors::LossOfStrain], square,
                      mulAdd(arm[ArmVectors::LossWith0], with0,
                             mulAdd(arm[ArmVectors::LossWith1], with1,
                                    mulAdd(arm[ArmVectors::LossWith2], with2, loss))));
      }
      // The segments add what they drive themselves.
      const double s00 = sumOfFirst(d0 * d0), s01 = sumOfFirst(d0 * d1), s02 = sumOfFirst(d0 * d2),
                   s11 = sumOfFirst(d1 * d1), s12 = sumOfFirst(d1 * d2), s22 = sumOfFirst(d2 * d2);
      const double s0 = sumOfFirst(d0), s1 = sumOfFirst(d1), s2 = sumOfFirst(d2);
      const auto& own = vectors_.own;
      const auto& dd = vectors_.lossOfSlopes;
      const double ownWork = own[0][0] * s00 + own[1][1] * s11 + own[2][2] * s22 +
                             (own[0][1] + own[1][0]) * s01 + (own[0][2] + own[2][0]) * s02 +
                             (own[1][2] + own[2][1]) * s12;
      const double ownLoss =
          dd[0] * s00 + dd[1] * s01 + dd[2] * s02 + dd[3] * s11 + dd[4] * s12 + dd[5] * s22;
      const double slopeSquared =
          (s00 + s01 + (s11 + 2 * s02) / 3 + 0.5 * s12 + 0.2 * s22) / spacing;
      const double damped = vectors_.dashpot * slopeSquared;
      sums.pressure +=
          spacing * (sumOf(strain) + own[0][0] * s0 + own[0][1] * s1 + own[0][2] * s2) +
          vectors_.dashpot * (s0 + 0.5 * s1 + s2 / 3);
      sums.work += sumOf(work) + ownWork + damped;
      sums.dissipation += sumOf(loss) + ownLoss + damped;
      sums.contactLength += spacing * static_cast<double>(count);
      sums.slopeSquared += slopeSquared;
    }
    std::copy_n(after_ + (count - 1) * afterStride_, armLanes_, strain_);
    strainSum_ = batch.strainSum[count];
    lossSum_ = batch.lossSum[count];
    trialLength_ = -1;
  }

  /// Returns the pressure at the end of segment n of a batch whose first n segments have been
  /// taken. advance() over that segment then needs no new decays.
  HWY_INLINE ValueAndSlope pressureAfter(const SegmentBatch& batch, std::size_t n,
                                         const ContactPiece& piece) {
    std::copy_n(after_ + n * afterStride_, armLanes_, trial_);
    trialLength_ = piece.length;
    trialStrainSum_ = batch.strainSum[n + 1];
    trialLossSum_ = batch.lossSum[n + 1];
    return pressureWith(trialStrainSum_, trialLossSum_, piece, 1);
  }

  double dashpot() const { return vectors_.dashpot; }
  double glassy() const { return vectors_.glassy; }

  /// Returns p / 4G at u of any piece that begins with the present strains, and its derivative. The
  /// strains there are kept, so that advance() to the same place needs no new decays.
  HWY_INLINE ValueAndSlope pressureAt(const ContactPiece& piece, double u) {
    const Cubic& w = piece.depth;
    const One d0 = One::all(u * w.c1), d1 = One::all(2 * u * u * w.c2),
              d2 = One::all(3 * u * u * u * w.c3), distances = One::all(piece.length * u);
    One strainSum = One::all(0), lossSum = One::all(0);
    for (std::size_t k = 0; k < armLanes_; k += One::kLanes) {
      const Quantities arm = armsFrom(k);
      const ArmDecay decay = armDecay(distances * arm[ArmVectors::Inverse]);
      const One e = decay.strain(One::load(strain_ + k), d0, d1, d2);
      e.store(trial_ + k);
      strainSum = mulAdd(arm[ArmVectors::Modulus], e, strainSum);
      lossSum = mulAdd(arm[ArmVectors::LossRate], e, lossSum);
    }
    return tried(piece, u, strainSum, lossSum);
  }

  /// Moves on to u of the piece.
  HWY_INLINE void advance(const ContactPiece& piece, double u) {
    if (trialLength_ != piece.length * u) pressureAt(piece, u);
    addCreep(piece.until(u));
    takeTrial();
  }

  /// Adds all sums of a piece in contact, before the strains move on. The elastic part of the work
  /// is added where contact ends.
  HWY_INLINE void gatherPiece(const ContactPiece& piece, PassSums& sums) const {
    const One length = One::all(piece.length);
    One strain = One::all(0), work = One::all(0), loss = One::all(0);
    for (std::size_t k = 0; k < armLanes_; k += One::kLanes) {
      const Quantities arm = armsFrom(k);
      const ArmIntegrals found =
          armIntegrals(length * arm[ArmVectors::Inverse], One::load(strain_ + k), piece.depth.c1,
                       2 * piece.depth.c2, 3 * piece.depth.c3);
      const One g = arm[ArmVectors::Modulus];
      strain = mulAdd(g, found.strain, strain);
      work = mulAdd(g, found.work, work);
      loss = mulAdd(g, found.loss, loss);
    }
    const double slopeSquared = piece.depth.integralOfSlopeSquared(1) / piece.length;
    const double damped = vectors_.dashpot * slopeSquared;
    sums.pressure += piece.length * (piece.depth.integral(1) + sumOf(strain)) +
                     vectors_.dashpot * (piece.depth.c1 + piece.depth.c2 + piece.depth.c3);
    sums.work += sumOf(work) + damped;
    sums.dissipation += sumOf(loss) + damped;
    sums.contactLength += piece.length;
    sums.slopeSquared += slopeSquared;
  }

  /// Ends contact at this depth (m) and finds the amplitudes that belong to it and to the strains.
  HWY_INLINE void setFree(double depth) {
    const One w = One::all(depth);
    for (std::size_t k = 0; k < modeLanes_; k += One::kLanes) {
      const Quantities mode = modesFrom(k);
      One amplitude = w * mode[ArmVectors::Settled], other = One::all(0);
      std::size_t i = 0;
      for (; i + 1 < vectors_.arms; i += 2) {
        amplitude =
            negMulAdd(One::all(strain_[i]), One::load(vectors_.ofCreep.row(i) + k), amplitude);
        other =
            negMulAdd(One::all(strain_[i + 1]), One::load(vectors_.ofCreep.row(i + 1) + k), other);
      }
      if (i < vectors_.arms)
        amplitude =
            negMulAdd(One::all(strain_[i]), One::load(vectors_.ofCreep.row(i) + k), amplitude);
      amplitude = amplitude + other;
      amplitude.store(amplitude_ + k);
      amplitude.store(arcAmplitude_ + k);
    }
  }

  // ---- Free

  /// Returns how far (m) the surface comes back over a block of segments of this level.
  HWY_INLINE double recoveryOverBlock(std::size_t level) const {
    const double* lost = vectors_.lost.row(level);
    One back = One::all(0);
    for (std::size_t k = 0; k < modeLanes_; k += One::kLanes)
      back = mulAdd(One::load(amplitude_ + k), One::load(lost + k), back);
    return sumOf(back);
  }
  HWY_INLINE void relaxOverBlock(std::size_t level) {
    const double* decay = vectors_.decay.row(level);
    for (std::size_t k = 0; k < modeLanes_; k += One::kLanes)
      (One::load(amplitude_ + k) * One::load(decay + k)).store(amplitude_ + k);
  }

  /// Returns how far (m) the surface comes back over any distance (m), and how fast it does there.
  HWY_INLINE ValueAndSlope recovery(double distance) const {
    const One distances = One::all(distance);
    One back = One::all(0), speed = One::all(0);
    for (std::size_t k = 0; k < modeLanes_; k += One::kLanes) {
      const Quantities mode = modesFrom(k);
      const One a = One::load(amplitude_ + k), rate = mode[ArmVectors::Rate];
      const One lost = lostAfter(rate * distances);
      back = mulAdd(a, lost, back);
      speed = mulAdd(rate, negMulAdd(a, lost, a), speed);
    }
    const TwoSums sums = sumsOf(back, speed);
    return {sums.x, sums.y};
  }
  /// Returns how fast the surface comes back now.
  HWY_INLINE double speedBack() const {
    One speed = One::all(0);
    for (std::size_t k = 0; k < modeLanes_; k += One::kLanes) {
      const Quantities mode = modesFrom(k);
      speed = mulAdd(mode[ArmVectors::Rate], One::load(amplitude_ + k), speed);
    }
    return sumOf(speed);
  }
  /// Relaxes over any distance and returns how far the surface comes back.
  HWY_INLINE double relax(double distance) {
    const One distances = One::all(distance);
    One back = One::all(0);
    for (std::size_t k = 0; k < modeLanes_; k += One::kLanes) {
      const Quantities mode = modesFrom(k);
      const One a = One::load(amplitude_ + k);
      const OneExponential e = exponentialOf(mode[ArmVectors::Rate] * distances);
      const One kept = mulAdd(e.two, e.grown, e.two);
      back = mulAdd(a, negMulAdd(e.two, e.grown, One::all(1) - e.two), back);
      (a * kept).store(amplitude_ + k);
    }
    return sumOf(back);
  }

  /// Ends a free arc of this length (m), with the amplitudes there, and adds its sums. Each
  /// amplitude relaxes by itself and takes what its own spring has stored.
  template <bool Everything>
  HWY_INLINE void endArc(double length, PassSums& sums) {
    const One distances = One::all(length);
    One volume = One::all(0), loss = One::all(0);
    for (std::size_t k = 0; k < modeLanes_; k += One::kLanes) {
      const Quantities mode = modesFrom(k);
      const One a = One::load(arcAmplitude_ + k), z = mode[ArmVectors::Rate] * distances;
      const One lost = lostAfter(z), gone = a * lost;
      const One mean = select(z > One::all(0), lost / z, One::all(1));
      volume = mulAdd(a, mean, volume);
      (a - gone).store(amplitude_ + k);
      gone.store(arcAmplitude_ + k);
      if constexpr (Everything)
        loss = mulAdd(mode[ArmVectors::Stiffness] * a, gone * (One::all(2) - lost), loss);
    }
    sums.depth += sumOf(volume) * length;
    if constexpr (Everything) sums.dissipation += 0.5 * sumOf(loss);
    // The creep of slow arms.
    for (std::size_t k = 0; k < slowLanes_; k += One::kLanes) {
      One creep = One::load(creep_ + k);
      for (std::size_t j = 0; j < vectors_.modes; ++j)
        creep =
            negMulAdd(One::all(arcAmplitude_[j]), One::load(vectors_.toCreep.row(j) + k), creep);
      creep.store(creep_ + k);
    }
    // The strains follow from the amplitudes.
    for (std::size_t k = 0; k < armLanes_; k += One::kLanes) {
      One strain = One::all(0), other = One::all(0);
      std::size_t j = 0;
      for (; j + 1 < vectors_.modes; j += 2) {
        strain = mulAdd(One::all(amplitude_[j]), One::load(vectors_.toStrain.row(j) + k), strain);
        other =
            mulAdd(One::all(amplitude_[j + 1]), One::load(vectors_.toStrain.row(j + 1) + k), other);
      }
      if (j < vectors_.modes)
        strain = mulAdd(One::all(amplitude_[j]), One::load(vectors_.toStrain.row(j) + k), strain);
      (strain + other).store(strain_ + k);
    }
    trialLength_ = -1;
    sumStrains();
  }

 private:
  static std::size_t lanesFor(std::size_t count) {
    return (count + One::kLanes - 1) / One::kLanes * One::kLanes;
  }
  /// The quantities of the arms or modes of one vector.
  struct Quantities {
    const double* from;
    HWY_INLINE One operator[](std::size_t quantity) const {
      return One::load(from + quantity * kWidestVector);
    }
  };
  HWY_INLINE Quantities armsFrom(std::size_t k) const { return {vectors_.arm.from(k)}; }
  HWY_INLINE Quantities modesFrom(std::size_t k) const { return {vectors_.mode.from(k)}; }

  HWY_INLINE ValueAndSlope pressureWith(double strainSum, double lossSum, const ContactPiece& piece,
                                        double u) const {
    const Cubic& w = piece.depth;
    const double perLength = vectors_.dashpot / piece.length, rising = w.derivative(u);
    return {
        w(u) + strainSum + perLength * rising,
        rising * vectors_.glassy - piece.length * lossSum + perLength * (2 * w.c2 + 6 * u * w.c3)};
  }
  HWY_INLINE ValueAndSlope tried(const ContactPiece& piece, double u, One strainSum, One lossSum) {
    trialLength_ = piece.length * u;
    const TwoSums sums = sumsOf(strainSum, lossSum);
    trialStrainSum_ = sums.x;
    trialLossSum_ = sums.y;
    return pressureWith(trialStrainSum_, trialLossSum_, piece, u);
  }
  /// The strains that were tried last become the present ones.
  HWY_INLINE void takeTrial() {
    std::swap(strain_, trial_);
    strainSum_ = trialStrainSum_;
    lossSum_ = trialLossSum_;
    trialLength_ = -1;
  }
  HWY_INLINE void sumStrains() {
    One strainSum = One::all(0), lossSum = One::all(0);
    for (std::size_t k = 0; k < armLanes_; k += One::kLanes) {
      const Quantities arm = armsFrom(k);
      const One e = One::load(strain_ + k);
      strainSum = mulAdd(arm[ArmVectors::Modulus], e, strainSum);
      lossSum = mulAdd(arm[ArmVectors::LossRate], e, lossSum);
    }
    const TwoSums sums = sumsOf(strainSum, lossSum);
    strainSum_ = sums.x;
    lossSum_ = sums.y;
  }

  /// Adds the creep of slow arms on a piece: z times the integral of e, by the series that their
  /// small z allows.
  HWY_INLINE void addCreep(const ContactPiece& piece) {
    const One d0 = One::all(piece.depth.c1), d1 = One::all(piece.depth.c2),
              d2 = One::all(piece.depth.c3), one = One::all(1);
    for (std::size_t k = 0; k < slowLanes_; k += One::kLanes) {
      const Quantities arm = armsFrom(k);
      // Beside slow arms there may be others in a vector, of which nothing is used.
      const One z = min(One::all(piece.length) * arm[ArmVectors::Inverse], One::all(0.5));
      const One driven3 = drivenSeries<3>(z);
      const One driven2 = One::all(1.0 / 3) * negMulAdd(z, driven3, one);
      const One driven1 = One::all(0.5) * negMulAdd(z, driven2, one);
      const One driven0 = negMulAdd(z, driven1, one);
      const One integral = mulAdd(driven0, One::load(strain_ + k),
                                  mulAdd(driven1, d0, mulAdd(driven2, d1, driven3 * d2)));
      mulAdd(z, integral, One::load(creep_ + k)).store(creep_ + k);
    }
  }

  const ArmVectors& vectors_;
  std::size_t armLanes_, slowLanes_, modeLanes_;
  double *strain_, *trial_;            // m; e_i, and where the pressure was last asked for
  double *amplitude_, *arcAmplitude_;  // m, a_j, and where the arc began
  double* creep_;                      // m, of slow arms
  double* after_;                      // m, e_i at the ends of a batch's segments
  std::size_t afterStride_;
  double strainSum_ = 0, lossSum_ = 0;            // sum g_i e_i (m), sum g_i e_i / c_i
  double trialStrainSum_ = 0, trialLossSum_ = 0;  // of what was tried
  double trialLength_ = -1;                       // m, where that was, or below 0
};

}  // namespace HWY_NAMESPACE
}  // namespace asperity
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
