// The body of nodalLanePass in lane_pass.h, compiled once per instruction set. nodal_pass.cpp has
// the same steps in plain form; names follow it. Read it first.

#if defined(ASPERITY_NODAL_LANE_PASS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ASPERITY_NODAL_LANE_PASS_INL
#undef ASPERITY_NODAL_LANE_PASS_INL
#else
#define ASPERITY_NODAL_LANE_PASS_INL
#endif

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include "core/contact/kernels/lane_pass.h"

HWY_BEFORE_NAMESPACE();
namespace asperity {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <bool kEverything>
class NodalLanePass {
  using D = hn::CappedTag<double, kMostLanes>;
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;

 public:
  NodalLanePass(const PreparedProfile& line, const double* depth, const double* memory)
      : line_(line), depth_(hn::Load(d_, depth)), memory_(hn::Load(d_, memory)) {
    const V exponent = hn::Div(set(-line.spacing), hn::Max(memory_, set(1e-300)));
    lost_[0] = hn::Neg(hn::Expm1(d_, hn::Max(exponent, set(-350))));
    for (std::size_t k = 1; k < line.blocks.size(); ++k) lost_[k] = twice(twice(lost_[k - 1]));
    surface_ = depth_;
  }

  HWY_INLINE void run(NodalLaneSums& sums) {
    const std::size_t count = line_.segments();
    node(0);
    int level = 0;
    for (std::size_t i = 1; i < count;) level = advance(i, level);
    closeArcs(hn::Eq(depth_, depth_), depth_);
    store(sums);
  }

 private:
  static constexpr D d_{};
  static constexpr int kMostLevels = 16;

  HWY_INLINE V set(double value) const { return hn::Set(d_, value); }
  HWY_INLINE V zero() const { return hn::Zero(d_); }
  /// What is lost over two stretches, of what is lost over one: l (2 - l).
  HWY_INLINE V twice(V lost) const { return hn::Mul(lost, hn::Sub(set(2), lost)); }
  /// Where a surface is after a stretch, from a height.
  HWY_INLINE V after(V height, V lost) const {
    return hn::MulAdd(hn::Sub(depth_, height), lost, height);
  }

  /// Takes the largest whole block at i above which every lane stays free, or node i.
  HWY_INLINE int advance(std::size_t& i, int level) {
    const int top = static_cast<int>(line_.blocks.size()) - 1;
    while (level >= 1) {
      const std::size_t from = i - 1, size = std::size_t{1} << (2 * level);
      const std::size_t block = from >> (2 * level);
      const auto& blocks = line_.blocks[static_cast<std::size_t>(level)];
      if ((from & (size - 1)) == 0 && block < blocks.size()) {
        const V far = after(surface_, lost_[level]);
        if (hn::AllTrue(d_, hn::Gt(set(blocks.lowest[block]), far))) {
          skip(far, level);
          i += size;
          return level < top ? level + 1 : level;
        }
      }
      --level;
    }
    node(i);
    ++i;
    // Blocks of four start at every fourth node from the first on.
    return ((i - 1) & 3U) == 0 && top > 0 ? 1 : 0;
  }

  /// Every lane relaxes over a block: y here is the first free value, decayed node by node.
  HWY_INLINE void skip(V far, int level) {
    if (kEverything) {
      // Geometric sum; without any decay all values are alike.
      const V alike = set(static_cast<double>(std::size_t{1} << (2 * level)));
      const V some = hn::Div(lost_[level], lost_[0]);
      const V sum = hn::IfThenElse(hn::Gt(lost_[0], zero()), some, alike);
      depthSum_ = hn::MulAdd(hn::Sub(depth_, surface_), sum, depthSum_);
      forget(lost_[level]);
    }
    surface_ = far;
  }

  HWY_INLINE void forget(V lost) {
    lostSinceTouch_ = hn::MulAdd(hn::Sub(set(1), lostSinceTouch_), lost, lostSinceTouch_);
  }

  HWY_INLINE void node(std::size_t i) {
    const V rise = set(line_.rise[i]), slope = set(line_.slopeIn[i]);
    const M touching = hn::Le(rise, surface_);
    if (hn::AllFalse(d_, touching)) {
      if (kEverything) {
        depthSum_ = hn::Add(depthSum_, hn::Sub(depth_, surface_));
        forget(lost_[0]);
      }
      surface_ = after(surface_, lost_[0]);
      return;
    }
    const V deep = hn::Sub(depth_, rise);
    const V pressure = hn::NegMulAdd(memory_, slope, deep);
    const M loaded = hn::And(touching, hn::Gt(pressure, zero()));
    pressure_ = hn::Add(pressure_, hn::IfThenElse(loaded, pressure, zero()));
    loaded_ = hn::Add(loaded_, hn::IfThenElse(loaded, set(1), zero()));
    const V here = hn::IfThenElse(touching, rise, surface_);
    if (kEverything) everything(i, rise, slope, pressure, touching, loaded);
    surface_ = after(here, lost_[0]);
  }

  HWY_INLINE void everything(std::size_t i, V rise, V slope, V pressure, M touching, M loaded) {
    closeArcs(touching, hn::Sub(depth_, surface_));
    work_ = hn::Sub(work_, hn::IfThenElse(loaded, hn::Mul(pressure, slope), zero()));
    const V squared = hn::Mul(slope, slope);
    slopeSquared_ = hn::Add(slopeSquared_, hn::IfThenElse(loaded, squared, zero()));
    const V here = hn::Sub(depth_, hn::IfThenElse(touching, rise, surface_));
    depthSum_ = hn::Add(depthSum_, here);
    const V pressed = hn::MulAdd(memory_, slope, rise);
    V threshold = hn::Max(pressed, zero());
    if (i > 0) {
      const V reached = hn::Add(lastRise_, hn::Div(hn::Sub(rise, lastRise_), lostSinceTouch_));
      threshold = hn::Max(threshold, reached);
    }
    threshold_ = hn::IfThenElse(loaded, hn::Max(threshold_, threshold), threshold_);
    lastRise_ = hn::IfThenElse(touching, rise, lastRise_);
    lostSinceTouch_ = hn::IfThenZeroElse(touching, lostSinceTouch_);
    forget(lost_[0]);
    arcStart_ = hn::IfThenElse(touching, here, arcStart_);
  }

  /// Energy given off since the last element that touched, from arcStart_ down to `end`.
  HWY_INLINE void closeArcs(M lanes, V end) {
    const V lost = hn::Mul(set(0.5), hn::MulSub(arcStart_, arcStart_, hn::Mul(end, end)));
    freeLoss_ = hn::Add(freeLoss_, hn::IfThenElse(lanes, hn::Max(lost, zero()), zero()));
  }

  HWY_INLINE void storeOne(V value, LaneValues& target) const {
    hn::StoreU(value, d_, target.data());
  }

  HWY_INLINE void store(NodalLaneSums& sums) const {
    const V dx = set(line_.spacing);
    storeOne(hn::Mul(pressure_, dx), sums.pressure);
    storeOne(loaded_, sums.loaded);
    if (!kEverything) return;
    storeOne(hn::Mul(depthSum_, dx), sums.depth);
    storeOne(hn::Mul(work_, dx), sums.work);
    storeOne(hn::MulAdd(hn::Mul(memory_, slopeSquared_), dx, freeLoss_), sums.dissipation);
    storeOne(hn::Mul(slopeSquared_, dx), sums.slopeSquared);
    storeOne(threshold_, sums.threshold);
  }

  const PreparedProfile& line_;
  V depth_, memory_;
  V lost_[kMostLevels];       // part of a depth, over a block of each level
  V surface_ = hn::Zero(d_);  // height of what reaches the next node without contact
  V lastRise_ = hn::Zero(d_), lostSinceTouch_ = hn::Zero(d_), arcStart_ = hn::Zero(d_);
  V pressure_ = hn::Zero(d_), loaded_ = hn::Zero(d_), depthSum_ = hn::Zero(d_);
  V work_ = hn::Zero(d_), slopeSquared_ = hn::Zero(d_), freeLoss_ = hn::Zero(d_);
  V threshold_ = hn::Set(d_, -1);
};

}  // namespace HWY_NAMESPACE
}  // namespace asperity
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
