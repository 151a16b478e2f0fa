#include "core/contact/time_march.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

TimeMarch::TimeMarch(std::shared_ptr<const Line> line, double lowest)
    : line_(std::move(line)),
      lowest_(lowest),
      depth_(line_->nodes()),
      pressure_(line_->nodes()),
      rise_(line_->nodes()),
      lastRise_(line_->nodes()),
      threshold_(line_->nodes()) {
  placeLine();
}

void TimeMarch::setState(std::span<const double> depth, double indentation) {
  std::copy(depth.begin(), depth.end(), depth_.begin());
  indentation_ = indentation;
}

void TimeMarch::setDistance(double distance) {
  distance_ = distance;
  placeLine();
}

void TimeMarch::setPressure(std::span<const double> pressure) {
  std::copy(pressure.begin(), pressure.end(), pressure_.begin());
}

/// The line over the elements, moved by distance_: on nodes exactly, between them by its cubics.
void TimeMarch::placeLine() {
  const std::size_t count = line_->nodes();
  const double h = line_->spacing;
  const double shift = std::fmod(distance_, line_->length) / h;
  const double whole = std::ceil(shift);
  const double t = whole - shift;  // of the segment after node i - whole
  const auto back = static_cast<std::ptrdiff_t>(whole);
  const auto size = static_cast<std::ptrdiff_t>(count);
  std::size_t from = static_cast<std::size_t>(((-back) % size + size) % size);
  const double h01 = t * t * (3 - 2 * t), h00 = 1 - h01;
  const double h10 = h * t * (1 - t) * (1 - t), h11 = -h * t * t * (1 - t);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t to = from + 1 == count ? 0 : from + 1;
    const double height = t == 0 ? line_->height[from]
                                 : h00 * line_->height[from] + h01 * line_->height[to] +
                                       h10 * line_->slopeAfter[from] + h11 * line_->slopeLeftOf(to);
    rise_[i] = height - lowest_;
    from = to;
  }
}

/// The indentation d with sum max(0, d - threshold_i) = load (m). Newton's method on a convex,
/// piecewise linear function: from the first step on it comes from the right and only falls, until
/// the set of touched elements repeats; a step that does not fall any more is rounding.
double TimeMarch::balance(double load) {
  const double lowest = *std::min_element(threshold_.begin(), threshold_.end());
  double d = std::max(indentation_, lowest + load);
  for (bool first = true; true; first = false) {
    std::size_t count = 0;
    double sum = 0;
    for (const double threshold : threshold_) {
      const bool below = threshold < d;
      count += below ? 1 : 0;
      sum += below ? threshold - lowest : 0;
    }
    const double next =
        count > 0 ? lowest + (load + sum) / static_cast<double>(count) : lowest + load;
    if (!(next < d) && !first) return d;
    if (next == d || count == 0) return next;
    d = next;
  }
}

MarchStep TimeMarch::step(const MarchConditions& conditions, double dt, double distance) {
  const double h = line_->spacing, stiffness = 4 * conditions.shearModulus;
  const double exponent = conditions.relaxationTime > 0 ? -dt / conditions.relaxationTime
                                                        : -std::numeric_limits<double>::infinity();
  const double kept = std::exp(exponent), given = -std::expm1(exponent);
  distance_ += distance;
  std::swap(rise_, lastRise_);
  placeLine();
  for (std::size_t i = 0; i < depth_.size(); ++i) threshold_[i] = rise_[i] + depth_[i] * kept;
  const double before = indentation_;
  indentation_ = conditions.load == LoadKind::Force
                     ? balance(conditions.normalForce * given / (stiffness * h))
                     : conditions.depth;

  MarchStep result;
  double load = 0, work = 0, dissipated = 0, stored = 0, advance = 0, closing = 0;
  std::size_t touching = 0;
  for (std::size_t i = 0; i < depth_.size(); ++i) {
    const double start = depth_[i];
    const double pushed = std::max(indentation_ - threshold_[i], 0.0);
    const double end = start * kept + pushed;
    const double p = pushed / given;  // per 4G
    load += p;
    work += p * (end - start);
    advance += p * (lastRise_[i] - rise_[i]);
    closing += p * (start - (before - lastRise_[i]));
    dissipated += 0.5 * (start - p) * (start - p);
    stored += 0.5 * (end - start) * (end + start);
    touching += pushed > 0 ? 1 : 0;
    depth_[i] = end;
    pressure_[i] = stiffness * p;
  }
  result.indentation = indentation_;
  result.normalForce = stiffness * h * load;
  result.work = stiffness * h * work;
  result.dissipated = stiffness * h * dissipated * -std::expm1(2 * exponent);
  result.stored = stiffness * h * stored;
  result.slidingWork = result.work - result.normalForce * (indentation_ - before);
  result.lineWork = stiffness * h * advance;
  result.gapWork = stiffness * h * closing;
  result.contactLength = h * static_cast<double>(touching);
  return result;
}

}  // namespace asperity
