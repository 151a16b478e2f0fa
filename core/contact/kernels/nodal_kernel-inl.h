// The pass of nodalPass and nodalLanePass in kernels.h over separate elements at the nodes, a
// velocity in each lane; the scalar pass is its instantiation with one lane. Whole blocks are taken
// in one step where every lane is free above them. Compiled once per instruction set.

#if defined(ASPERITY_NODAL_KERNEL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ASPERITY_NODAL_KERNEL_INL
#undef ASPERITY_NODAL_KERNEL_INL
#else
#define ASPERITY_NODAL_KERNEL_INL
#endif

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <algorithm>

#include "core/contact/kernels/kernels.h"

HWY_BEFORE_NAMESPACE();
namespace asperity {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// D: the vectors' tag. kShape: the first lane's shape is recorded. Heights are above the lowest
/// node; y is the depth of an element.
template <class D, Output kOutput, bool kShape = false>
class NodalKernel {
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;
  static constexpr bool kEverything = kOutput == Output::Everything;

 public:
  /// depth, relaxationLength: one value for each lane (m).
  HWY_INLINE NodalKernel(const PreparedProfile& line, const double* depth,
                         const double* relaxationLength, NodeShape* shape = nullptr)
      : line_(line),
        count_(line.segments()),
        shape_(shape),
        depth_(hn::LoadU(d_, depth)),
        relaxationLength_(hn::LoadU(d_, relaxationLength)) {
    // The part of a depth that a free surface loses from one node to the next, and over each block.
    const V exponent = hn::Div(set(-line.spacing), hn::Max(relaxationLength_, set(1e-300)));
    lost_[0] = hn::Neg(hn::Expm1(d_, hn::Max(exponent, set(-350))));
    for (std::size_t k = 1; k < line.blocks.size(); ++k) lost_[k] = twice(twice(lost_[k - 1]));
    // The lowest node comes first, where the elastomer is deepest.
    surface_ = depth_;
  }

  HWY_INLINE void run(NodalState* states) {
    node(0);
    int level = 0;
    for (std::size_t i = 1; i < count_;) level = advance(i, level);
    // The arc ends at the lowest node of the next period.
    closeArcs(hn::Eq(depth_, depth_), depth_);
    store(states);
  }

 private:
  static constexpr D d_{};
  static constexpr int kMaxLevels = 16;

  HWY_INLINE V set(double value) const { return hn::Set(d_, value); }
  HWY_INLINE V zero() const { return hn::Zero(d_); }
  /// Returns the loss over twice the distance from that over one: l (2 - l).
  HWY_INLINE V twice(V lost) const { return hn::Mul(lost, hn::Sub(set(2), lost)); }
  /// Returns the height of a surface after this loss.
  HWY_INLINE V after(V height, V lost) const {
    return hn::MulAdd(hn::Sub(depth_, height), lost, height);
  }

  /// Takes the largest whole block at i above which every lane stays free, or node i.
  HWY_INLINE int advance(std::size_t& i, int level) {
    const int top = static_cast<int>(line_.blocks.size()) - 1;
    for (; level >= 1; --level) {
      const std::size_t from = i - 1, size = std::size_t{1} << (2 * level);
      if ((from & (size - 1)) != 0 || i + size > count_) continue;
      const V far = after(surface_, lost_[level]);
      const double lowest =
          line_.blocks[static_cast<std::size_t>(level)].lowest[from >> (2 * level)];
      if (hn::AllTrue(d_, hn::Gt(set(lowest), far))) {
        skip(far, level);
        i += size;
        return level < top ? level + 1 : level;
      }
    }
    node(i);
    ++i;
    // Blocks of four start at every fourth node from the first on. A shape needs every node.
    return ((i - 1) & 3U) == 0 && top > 0 && !kShape ? 1 : 0;
  }

  /// Every lane relaxes over a block: y is the first free value, which decays node by node.
  HWY_INLINE void skip(V far, int level) {
    if (kEverything) {
      // The depths are summed as a geometric series; without any decay all values are equal.
      const V alike = set(static_cast<double>(std::size_t{1} << (2 * level)));
      const V some = hn::Div(lost_[level], lost_[0]);
      const V sum = hn::IfThenElse(hn::Gt(lost_[0], zero()), some, alike);
      depthSum_ = hn::MulAdd(hn::Sub(depth_, surface_), sum, depthSum_);
      forget(lost_[level]);
      wasLoaded_ = zero();
    }
    surface_ = far;
  }

  /// Adds this loss to that since an element last touched.
  HWY_INLINE void forget(V lost) {
    lostSinceTouch_ = hn::MulAdd(hn::Sub(set(1), lostSinceTouch_), lost, lostSinceTouch_);
  }

  HWY_INLINE void node(std::size_t i) {
    const V height = set(line_.heightAboveMinimum[i]), slope = set(line_.slopeIn[i]);
    // Heights distinguish element and surface even if the indentation is far larger.
    const M touching = hn::Le(height, surface_);
    if (hn::AllFalse(d_, touching)) {
      if (kEverything) {
        record(surface_, zero());
        depthSum_ = hn::Add(depthSum_, hn::Sub(depth_, surface_));
        forget(lost_[0]);
        wasLoaded_ = zero();
      }
      surface_ = after(surface_, lost_[0]);
      return;
    }
    // Eq. (2): an element that touches carries load where p / 4G = d - z - c dz/ds is above 0.
    const V deep = hn::Sub(depth_, height);
    const V pressure = hn::NegMulAdd(relaxationLength_, slope, deep);
    const M loaded = hn::And(touching, hn::Gt(pressure, zero()));
    pressure_ = hn::Add(pressure_, hn::IfThenElseZero(loaded, pressure));
    loaded_ = hn::Add(loaded_, hn::IfThenElseZero(loaded, set(1)));
    const V here = hn::IfThenElse(touching, height, surface_);
    if (kEverything) {
      record(here, hn::IfThenElseZero(loaded, pressure));
      addEverything(i, height, slope, pressure, touching, loaded);
    }
    surface_ = after(here, lost_[0]);
  }

  HWY_INLINE void addEverything(std::size_t i, V height, V slope, V pressure, M touching,
                                M loaded) {
    // The arcs of the touching lanes end here.
    closeArcs(touching, hn::Sub(depth_, surface_));
    // Eq. (4), with w' = -dz/ds.
    work_ = hn::Sub(work_, hn::IfThenElse(loaded, hn::Mul(pressure, slope), zero()));
    const V squared = hn::Mul(slope, slope);
    slopeSquared_ = hn::Add(slopeSquared_, hn::IfThenElse(loaded, squared, zero()));
    const V here = hn::Sub(depth_, hn::IfThenElse(touching, height, surface_));
    depthSum_ = hn::Add(depthSum_, here);
    // The indentation at which this element is pressed, and at which the line reaches it after the
    // last touching element.
    const V pressed = hn::MulAdd(relaxationLength_, slope, height);
    V threshold = hn::Max(pressed, zero());
    if (i > 0) {
      const V reached =
          hn::Add(lastHeight_, hn::Div(hn::Sub(height, lastHeight_), lostSinceTouch_));
      threshold = hn::Max(threshold, reached);
    }
    threshold_ = hn::IfThenElse(loaded, hn::Max(threshold_, threshold), threshold_);
    // A contact spot begins at a loaded element after one that is not.
    const V isLoaded = hn::IfThenElseZero(loaded, set(1));
    spots_ = hn::Add(spots_, hn::Sub(isLoaded, hn::Mul(isLoaded, wasLoaded_)));
    if (i == 0) firstLoaded_ = isLoaded;
    wasLoaded_ = isLoaded;
    // A new arc begins where the line touches.
    lastHeight_ = hn::IfThenElse(touching, height, lastHeight_);
    lostSinceTouch_ = hn::IfThenZeroElse(touching, lostSinceTouch_);
    forget(lost_[0]);
    arcStart_ = hn::IfThenElse(touching, here, arcStart_);
  }

  /// Adds the energy released since the last touching element, from arcStart_ down to `end`.
  HWY_INLINE void closeArcs(M lanes, V end) {
    const V lost = hn::Mul(set(0.5), hn::MulSub(arcStart_, arcStart_, hn::Mul(end, end)));
    freeLoss_ = hn::Add(freeLoss_, hn::IfThenElse(lanes, hn::Max(lost, zero()), zero()));
  }

  /// Records the first lane's element: `height` of its surface, and its pressure.
  HWY_INLINE void record(V height, V pressure) const {
    if (!kShape) return;
    shape_->depth.push_back(std::max(hn::GetLane(hn::Sub(depth_, height)), 0.0));
    shape_->pressure.push_back(hn::GetLane(pressure));
  }

  /// Writes one quantity of every lane.
  template <class Member>
  HWY_INLINE void give(V value, NodalState* states, const Member& member) const {
    for (std::size_t lane = 0; lane < hn::Lanes(d_); ++lane)
      member(states[lane]) = hn::ExtractLane(value, lane);
  }

  /// Writes the results; finish() in kernels.cpp adds depth and the lengths in contact.
  HWY_INLINE void store(NodalState* states) const {
    const V dx = set(line_.spacing);
    give(loaded_, states, [](NodalState& s) -> double& { return s.loaded; });
    give(hn::Mul(pressure_, dx), states, [](NodalState& s) -> double& { return s.sums.pressure; });
    if (!kEverything) return;
    const V loss = hn::MulAdd(hn::Mul(relaxationLength_, slopeSquared_), dx, freeLoss_);
    give(threshold_, states, [](NodalState& s) -> double& { return s.threshold; });
    give(hn::Mul(depthSum_, dx), states, [](NodalState& s) -> double& { return s.sums.depth; });
    give(hn::Mul(work_, dx), states, [](NodalState& s) -> double& { return s.sums.work; });
    give(loss, states, [](NodalState& s) -> double& { return s.sums.dissipation; });
    give(hn::Mul(slopeSquared_, dx), states,
         [](NodalState& s) -> double& { return s.sums.slopeSquared; });
    // The first spot goes on from the last one where both meet at the lowest node.
    give(hn::Sub(spots_, hn::Mul(firstLoaded_, wasLoaded_)), states,
         [](NodalState& s) -> double& { return s.sums.gaps; });
  }

  const PreparedProfile& line_;
  std::size_t count_;  // number of nodes
  NodeShape* shape_;
  V depth_, relaxationLength_;
  V lost_[kMaxLevels];        // lost part of a depth over a block of each level
  V surface_ = hn::Zero(d_);  // height of the free surface at the next node
  V lastHeight_ = hn::Zero(d_), lostSinceTouch_ = hn::Zero(d_), arcStart_ = hn::Zero(d_);
  V pressure_ = hn::Zero(d_), loaded_ = hn::Zero(d_), depthSum_ = hn::Zero(d_);
  V work_ = hn::Zero(d_), slopeSquared_ = hn::Zero(d_), freeLoss_ = hn::Zero(d_);
  V threshold_ = hn::Set(d_, -1);
  V spots_ = hn::Zero(d_), firstLoaded_ = hn::Zero(d_), wasLoaded_ = hn::Zero(d_);
};

}  // namespace HWY_NAMESPACE
}  // namespace asperity
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
