#include "core/contact/time_march.h"

#include <algorithm>
#include <cmath>

#include "core/contact/decay_moments.h"

namespace asperity {

TimeMarch::TimeMarch(std::shared_ptr<const Line> line, double lowest, ElementLaw law)
    : line_(std::move(line)),
      lowest_(lowest),
      law_(std::move(law)),
      modes_(retardationModes(law_)),
      depth_(line_->nodes()),
      pressure_(line_->nodes()),
      rise_(line_->nodes()),
      amplitude_(modes_.modes() * line_->nodes()),
      lastRise_(line_->nodes()),
      free_(line_->nodes()),
      threshold_(line_->nodes()),
      creep_(modes_.modes()) {
  placeLine();
}

/// Of the compliance at rest, or without a rest of the amplitude that flows, each has its part.
void TimeMarch::setState(std::span<const double> depth, double indentation) {
  std::copy(depth.begin(), depth.end(), depth_.begin());
  indentation_ = indentation;
  double whole = modes_.glassyCompliance;
  const bool flows = !modes_.rate.empty() && modes_.rate[0] == 0;
  for (std::size_t j = 0; j < modes_.modes(); ++j) whole += modes_.fluidity[j] / modes_.rate[j];
  const std::size_t count = depth_.size();
  for (std::size_t j = 0; j < modes_.modes(); ++j) {
    const double part = flows ? (j == 0 ? 1 : 0) : modes_.fluidity[j] / modes_.rate[j] / whole;
    for (std::size_t i = 0; i < count; ++i) amplitude_[j * count + i] = part * depth_[i];
  }
}

void TimeMarch::setState(std::span<const double> depth, std::span<const double> pressure,
                         std::span<const double> amplitudes, double indentation) {
  setState(depth, indentation);
  setPressure(pressure);
  const std::size_t count = depth_.size(), modes = modes_.modes();
  if (amplitudes.size() != modes * count) return;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < modes; ++j) amplitude_[j * count + i] = amplitudes[i * modes + j];
}

void TimeMarch::goOnFrom(const TimeMarch& other) {
  setState(other.depth_, other.indentation_);
  setPressure(other.pressure_);
  if (amplitude_.size() == other.amplitude_.size()) amplitude_ = other.amplitude_;
  setDistance(other.distance_);
}

void TimeMarch::settleAtRest(const MarchLoad& load) {
  const double stiffness = 4 * law_.equilibriumModulus * line_->spacing;
  threshold_ = rise_;
  indentation_ = 0;
  indentation_ = load.kind == LoadKind::Force ? balance(load.normalForce / stiffness) : load.depth;
  std::vector<double> depth(rise_.size());
  for (std::size_t i = 0; i < depth.size(); ++i) {
    depth[i] = std::max(indentation_ - rise_[i], 0.0);
    pressure_[i] = 4 * law_.equilibriumModulus * depth[i];
  }
  setState(depth, indentation_);
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

void TimeMarch::prepareSteps(double dt) {
  if (dt == preparedFor_) return;
  preparedFor_ = dt;
  const bool hasDashpot = modes_.glassyCompliance == 0;
  compliance_ = modes_.glassyCompliance;
  for (std::size_t j = 0; j < creep_.size(); ++j) {
    const double z = modes_.rate[j] * dt, flow = modes_.fluidity[j] * dt;
    const DrivenDecay decay = drivenDecay(z);
    Creep& creep = creep_[j];
    creep.kept = decay.kept;
    creep.before = hasDashpot ? 0 : flow * (decay.driven[0] - decay.driven[1]);
    creep.after = flow * (hasDashpot ? decay.driven[0] : decay.driven[1]);
    creep.stiffness = modes_.rate[j] / modes_.fluidity[j];
    creep.lost = -std::expm1(-2 * z);
    compliance_ += creep.after;
  }
}

/// Amplitudes and depths at the end of the step where nothing touches.
void TimeMarch::creepFreely() {
  const std::size_t count = depth_.size();
  std::fill(free_.begin(), free_.end(), 0);
  for (std::size_t j = 0; j < creep_.size(); ++j) {
    const Creep creep = creep_[j];
    double* amplitude = amplitude_.data() + j * count;
    if (creep.before == 0)
      for (std::size_t i = 0; i < count; ++i) free_[i] += creep.kept * amplitude[i];
    else
      for (std::size_t i = 0; i < count; ++i)
        free_[i] += creep.kept * amplitude[i] + creep.before * 0.25 * pressure_[i];
  }
  for (std::size_t i = 0; i < count; ++i) threshold_[i] = rise_[i] + free_[i];
}

/// Presses the touched elements to the new indentation and sums up.
template <bool HasDashpot>
MarchStep TimeMarch::finishStep(double before) {
  const std::size_t count = depth_.size();
  const double h = 4 * line_->spacing;  // p is 4 times what the amplitudes are driven by
  double load = 0, work = 0, stored = 0, dissipated = 0, advance = 0, closing = 0;
  std::size_t touching = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double pushed = std::max(indentation_ - threshold_[i], 0.0);
    const double start = depth_[i], end = free_[i] + pushed;
    const double last = 0.25 * pressure_[i], now = pushed / compliance_;
    const double mean = HasDashpot ? now : 0.5 * (last + now);
    load += now;
    work += mean * (end - start);
    advance += mean * (lastRise_[i] - rise_[i]);
    if (HasDashpot) closing += mean * (start - (before - lastRise_[i]));
    if (!HasDashpot) stored += 0.5 * modes_.glassyCompliance * (now - last) * (now + last);
    touching += pushed > 0 ? 1 : 0;
    depth_[i] = end;
    threshold_[i] = last;  // from here on: the pressure before
    pressure_[i] = 4 * now;
  }
  for (std::size_t j = 0; j < creep_.size(); ++j) {
    const Creep creep = creep_[j];
    double* amplitude = amplitude_.data() + j * count;
    const double softness = creep.stiffness > 0 ? 1 / creep.stiffness : 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double start = amplitude[i], now = 0.25 * pressure_[i];
      double end = creep.kept * start + creep.after * now;
      if constexpr (!HasDashpot) end += creep.before * threshold_[i];
      stored += 0.5 * creep.stiffness * (end - start) * (end + start);
      if constexpr (HasDashpot)
        dissipated += creep.stiffness > 0 ? 0.5 * creep.stiffness * creep.lost *
                                                (start - softness * now) * (start - softness * now)
                                          : creep.after * now * now;
      amplitude[i] = end;
    }
  }
  MarchStep result;
  result.indentation = indentation_;
  result.normalForce = h * load;
  result.work = h * work;
  result.stored = h * stored;
  result.dissipated = HasDashpot ? h * dissipated : h * (work - stored);
  result.slidingWork = result.work - result.normalForce * (indentation_ - before);
  result.lineWork = h * advance;
  result.gapWork = h * closing;
  result.contactLength = line_->spacing * static_cast<double>(touching);
  return result;
}

void TimeMarch::countContacts(MarchStep& step) const {
  bool last = pressure_.back() > 0;
  for (const double pressure : pressure_) {
    step.contacts += pressure > 0 && !last ? 1 : 0;
    last = pressure > 0;
  }
  if (step.contacts == 0 && last) step.contacts = 1;  // all around
}

MarchStep TimeMarch::step(const MarchLoad& load, double dt, double distance) {
  prepareSteps(dt);
  distance_ += distance;
  std::swap(rise_, lastRise_);
  placeLine();
  creepFreely();
  const double before = indentation_;
  indentation_ = load.kind == LoadKind::Force
                     ? balance(load.normalForce * compliance_ / (4 * line_->spacing))
                     : load.depth;
  MarchStep result =
      modes_.glassyCompliance == 0 ? finishStep<true>(before) : finishStep<false>(before);
  countContacts(result);
  return result;
}

}  // namespace asperity
