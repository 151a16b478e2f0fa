#include "core/paper/literal_march.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#if defined(__x86_64__) && defined(__GNUC__)
#define ASPERITY_X86 1
#endif

namespace asperity {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The elements in contact at an indentation d, with F_N / (4 G dx) = count d - offset.
struct ContactSet {
  double indentation = 0;  // m
  double count = 0;        // a double, so that it is summed like the other values
  double offset = 0;       // m, sum of z - c z'
  double force() const { return count * indentation - offset; }  // m
};

/// Eqs. (1) to (4) over plain arrays. heightAboveMinimum and slope belong to the line above the
/// elements.
struct Elements {
  const double* heightAboveMinimum;  // m, z - z_lowest
  const double* slope;               // z'
  double* depth;                     // m, y = -u
  std::size_t count;
  double relaxationLength;  // m, c = v tau

  void relax(double decay) const {
    for (std::size_t i = 0; i < count; ++i) depth[i] *= decay;
  }

  ContactSet contactAt(double indentation) const {
    double touching = 0, offset = 0;
#pragma omp simd reduction(+ : touching, offset)
    for (std::size_t i = 0; i < count; ++i) {
      const double pressed =
          heightAboveMinimum[i] - relaxationLength * slope[i];  // f > 0 above this indentation
      const double reached = heightAboveMinimum[i] + depth[i];  // u < z - d below this one
      const bool isTouching = (indentation > pressed) & (indentation > reached);
      touching += isTouching ? 1.0 : 0.0;
      offset += isTouching ? pressed : 0.0;
    }
    return {indentation, touching, offset};
  }

  /// Returns the lowest indentation (m) above `indentation` at which an element enters.
  double nextEntry(double indentation) const {
    double lowest = kInfinity;
#pragma omp simd reduction(min : lowest)
    for (std::size_t i = 0; i < count; ++i) {
      const double pressed = heightAboveMinimum[i] - relaxationLength * slope[i],
                   reached = heightAboveMinimum[i] + depth[i];
      const double entry = pressed > reached ? pressed : reached;
      const double ahead = entry >= indentation ? entry : kInfinity;
      lowest = ahead < lowest ? ahead : lowest;
    }
    return lowest;
  }

  /// Returns F_x / (4 G dx) (m) and gives the elements their shape at this indentation.
  double pressInto(double indentation) const {
    double* const y = depth;
    const double c = relaxationLength;
    double work = 0;
#pragma omp simd reduction(+ : work)
    for (std::size_t i = 0; i < count; ++i) {
      const double deep = indentation - heightAboveMinimum[i], last = y[i];
      const double force = deep + c * slope[i];
      y[i] = deep > last ? deep : last;
      work += force * (((force > 0) & (deep > last)) ? slope[i] : 0.0);
    }
    return work;
  }
};

struct Found {
  ContactSet contact;
  bool isJump = false;
  int sweeps = 0;
};

/// Searches with a bracket for the indentation at which F_N / (4 G dx) is `load` (m).
class IndentationSearch {
 public:
  IndentationSearch(const Elements& elements, double load) : elements_(elements), load_(load) {}

  Found from(double guess) {
    sweep(guess);
    for (;;) {
      const double solution = solutionForThisSet();
      if (set_.count > 0 && isSame(solution, set_.indentation)) return {set_, false, sweeps_};
      const bool isInside = solution > low_.indentation && solution < high_.indentation;
      if (!isInside && isAtJump()) return {justAboveJump(), true, sweeps_};
      const double middle = 0.5 * (low_.indentation + high_.indentation);
      if (!isInside && (middle <= low_.indentation || middle >= high_.indentation))
        return {high_, true, sweeps_};  // several elements enter together
      const double lastCount = set_.count;
      sweep(isInside ? solution : middle);
      if (isInside && set_.count == lastCount) return {set_, false, sweeps_};
    }
  }

 private:
  void sweep(double indentation) {
    set_ = elements_.contactAt(indentation);
    (set_.force() >= load_ ? high_ : low_) = set_;
    ++sweeps_;
  }

  /// Returns the solution of Eq. (3) for the elements in contact; without any, the indentation
  /// where the first one enters.
  double solutionForThisSet() {
    if (set_.count > 0) return (load_ + set_.offset) / set_.count;
    return justAbove(nextEntry());
  }

  bool isAtJump() const { return high_.count - low_.count <= 1; }
  ContactSet justAboveJump() { return {justAbove(nextEntry()), high_.count, high_.offset}; }
  double nextEntry() {
    ++sweeps_;
    return elements_.nextEntry(low_.indentation);
  }
  static bool isSame(double a, double b) { return std::abs(a - b) <= 1e-15 * std::abs(b); }
  static double justAbove(double indentation) { return std::nextafter(indentation, kInfinity); }

  const Elements& elements_;
  double load_;
  ContactSet set_;
  ContactSet low_{-kInfinity, 0, 0}, high_{kInfinity, kInfinity, 0};
  int sweeps_ = 0;
};

/// The march: the elements are fixed, and the line moves by one node per step.
class Literal {
 public:
  Literal(const Line& line, const SlidingConditions& conditions, double normalForce)
      : nodes_(line.nodes()),
        memory_(conditions.velocity * conditions.relaxationTime),
        decay_(std::exp(-line.spacing / memory_)),
        elementStiffness_(4 * conditions.shearModulus * line.spacing),
        load_(normalForce / elementStiffness_),
        heightAboveMinimum_(twice(line.height)),
        slope_(twice(line.slopeAfter)),
        depth_(nodes_, 0.0) {
    const double lowest = *std::min_element(heightAboveMinimum_.begin(), heightAboveMinimum_.end());
    for (double& heightAboveMinimum : heightAboveMinimum_) heightAboveMinimum -= lowest;
    indentation_ = load_ / static_cast<double>(nodes_);
  }

  void start(std::span<const double> depth, double indentation) {
    depth_.assign(depth.begin(), depth.end());
    indentation_ = indentation;
  }

  LiteralResult run(std::int64_t steps) {
    LiteralResult result;
    result.steps = steps;
    const std::int64_t averaged = std::max<std::int64_t>(1, steps / 5);
    std::int64_t sweeps = 0, jumps = 0;
    for (std::int64_t k = 0; k < steps; ++k) {
      const Step now = step(k);
      sweeps += now.found.sweeps;
      jumps += now.found.isJump ? 1 : 0;
      if (!now.found.isJump)
        result.largestResidual =
            std::max(result.largestResidual, std::abs(now.found.contact.force() / load_ - 1));
      if (k >= steps - averaged) add(now, 1.0 / static_cast<double>(averaged), result);
    }
    result.sweepsPerStep = static_cast<double>(sweeps) / static_cast<double>(steps);
    result.jumpFraction = static_cast<double>(jumps) / static_cast<double>(steps);
    return result;
  }

 private:
  struct Step {
    Found found;
    double work;  // m, F_x / (4 G dx)
  };

  static std::vector<double> twice(const std::vector<double>& values) {
    std::vector<double> both = values;
    both.insert(both.end(), values.begin(), values.end());
    return both;
  }

  Step step(std::int64_t k) {
    // The line has moved by k spacings towards +x: its node i - k is above element i.
    const std::size_t first = (nodes_ - static_cast<std::size_t>(k) % nodes_) % nodes_;
    const Elements elements{heightAboveMinimum_.data() + first, slope_.data() + first,
                            depth_.data(), nodes_, memory_};
    elements.relax(decay_);
    const Found found = IndentationSearch(elements, load_).from(indentation_);
    indentation_ = found.contact.indentation;
    return {found, elements.pressInto(indentation_)};
  }

  void add(const Step& step, double weight, LiteralResult& result) const {
    const ContactSet& contact = step.found.contact;
    result.mu += weight * step.work / contact.force();
    result.normalForce += weight * elementStiffness_ * contact.force();
    result.tangentialForce += weight * elementStiffness_ * step.work;
    result.indentation += weight * contact.indentation;
    result.contactFraction += weight * contact.count / static_cast<double>(nodes_);
  }

  std::size_t nodes_;
  double memory_, decay_, elementStiffness_;
  double load_;  // m, F_N / (4 G dx)
  std::vector<double> heightAboveMinimum_, slope_, depth_;
  double indentation_ = 0;
};

// These are the same loops, compiled for wider vectors.
#ifdef ASPERITY_X86
[[gnu::target("avx512f"), gnu::flatten]] LiteralResult runAvx512(Literal& literal,
                                                                 std::int64_t steps) {
  return literal.run(steps);
}
[[gnu::target("avx2"), gnu::flatten]] LiteralResult runAvx2(Literal& literal, std::int64_t steps) {
  return literal.run(steps);
}
#endif

}  // namespace

bool isSupported(LiteralVectors vectors) {
  switch (vectors) {
    case LiteralVectors::AsCompiled:
      return true;
#ifdef ASPERITY_X86
    case LiteralVectors::Avx2:
      return __builtin_cpu_supports("avx2");
    case LiteralVectors::Avx512:
      return __builtin_cpu_supports("avx512f");
#else
    default:
      break;
#endif
  }
  return false;
}

LiteralResult literalMarch(const Line& line, const SlidingConditions& conditions,
                           double normalForce, const LiteralOptions& options) {
  Literal literal(line, conditions, normalForce);
  if (!options.startDepth.empty()) literal.start(options.startDepth, options.startIndentation);
  const std::int64_t steps =
      options.steps > 0 ? options.steps : static_cast<std::int64_t>(line.nodes());
#ifdef ASPERITY_X86
  if (isSupported(options.vectors)) {
    if (options.vectors == LiteralVectors::Avx512) return runAvx512(literal, steps);
    if (options.vectors == LiteralVectors::Avx2) return runAvx2(literal, steps);
  }
#endif
  return literal.run(steps);
}

}  // namespace asperity
