#include "core/contact/march/time_march.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/contact/kernels/decay_moments.h"
#include "core/contact/line/polynomial.h"
#include "core/contact/steady_sliding.h"

namespace asperity {
namespace {

// Minimum distance in nodes that counts as a movement in a step. Over a shorter one the differences
// of heights are rounding errors, and no slope changes.
constexpr double kMinMove = 1e-6;

/// Relative to the terms of a balance: smaller values are rounding errors.
constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();

/// Elements with a threshold below an approach: their number, and the sum of their thresholds (m).
struct Touched {
  double count = 0, sum = 0;
};

// Long sums and minima are made of eight parts: one operation then does not wait for the one
// before, and the compiler keeps the parts in vectors.
constexpr std::size_t kParts = 8;
using Parts = std::array<double, kParts>;

/// Returns the sum of the parts, always in the same order.
double sumOf(const Parts& parts) {
  return std::accumulate(parts.begin(), parts.end(), 0.0);
}

/// Returns the elements that the line touches after an approach (m).
Touched touchedBy(double approach, std::span<const double> thresholds) {
  Parts count{}, sum{};
  const auto add = [&](std::size_t part, double threshold) {
    const bool below = threshold < approach;
    count[part] += below ? 1.0 : 0.0;
    sum[part] += below ? threshold : 0.0;
  };
  const std::size_t blocks = thresholds.size() / kParts * kParts;
  for (std::size_t i = 0; i < blocks; i += kParts)
    for (std::size_t k = 0; k < kParts; ++k) add(k, thresholds[i + k]);
  for (std::size_t i = blocks; i < thresholds.size(); ++i) add(i - blocks, thresholds[i]);
  return {sumOf(count), sumOf(sum)};
}

/// Returns the smallest of at least one value.
double smallest(std::span<const double> values) {
  Parts least;
  least.fill(values.front());
  const std::size_t blocks = values.size() / kParts * kParts;
  for (std::size_t i = 0; i < blocks; i += kParts)
    for (std::size_t k = 0; k < kParts; ++k) least[k] = std::min(least[k], values[i + k]);
  for (std::size_t i = blocks; i < values.size(); ++i) least[0] = std::min(least[0], values[i]);
  return std::ranges::min(least);
}

/// Returns the rounding error of p/4 in Pa beside pressures p (N/m) in their balance.
double pressureRounding(std::span<const double> pressure) {
  return pressure.empty() ? 0 : 0.25 * kRounding * std::ranges::max(pressure);
}

}  // namespace

TimeMarch::TimeMarch(std::shared_ptr<const Line> line, double lowest, ElementLaw law)
    : line_(std::move(line)),
      lowest_(lowest),
      law_(std::move(law)),
      modes_(retardationModes(law_)),
      depth_(line_->nodes()),
      pressure_(line_->nodes()),
      height_(line_->nodes()),
      amplitude_(modes_.modes() * line_->nodes()),
      lastHeight_(line_->nodes()),
      free_(line_->nodes()),
      threshold_(line_->nodes()),
      creep_(modes_.modes()) {
  placeLine();
}

/// Sets the state. Each amplitude gets its part of the compliance at rest or, without a rest state,
/// of the amplitude that flows.
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

void TimeMarch::continueFrom(const TimeMarch& other) {
  setState(other.depth_, other.indentation_);
  setPressure(other.pressure_);
  if (amplitude_.size() == other.amplitude_.size()) amplitude_ = other.amplitude_;
  setDistance(other.distance_);
  record(other.records_);
  if (records_.sinceContact && sinceContact_.size() == other.sinceContact_.size())
    sinceContact_ = other.sinceContact_;
  if (line_->nodes() != other.line_->nodes() || line_->length != other.line_->length) return;
  passedNodes_ = other.passedNodes_;
  ahead_ = other.ahead_;
  placeLine();
}

void TimeMarch::settleAtRest(const MarchLoad& load) {
  const double stiffness = 4 * law_.equilibriumModulus * line_->spacing;
  threshold_ = height_;
  indentation_ =
      load.kind == LoadKind::Force ? balance(load.normalForce / stiffness).whole() : load.depth;
  std::vector<double> depth(height_.size());
  for (std::size_t i = 0; i < depth.size(); ++i) {
    depth[i] = std::max(indentation_ - height_[i], 0.0);
    pressure_[i] = 4 * law_.equilibriumModulus * depth[i];
  }
  setState(depth, indentation_);
}

void TimeMarch::setDistance(double distance) {
  distance_ = 0;
  passedNodes_ = 0;
  ahead_ = 0;
  moveLine(distance);
  placeLine();
}

/// Moves the line. Its position is stored as a node and a fraction, so that sums of steps do not
/// drift off the nodes.
void TimeMarch::moveLine(double distance) {
  distance_ += distance;
  const double moved = std::fmod(distance, line_->length) / line_->spacing - ahead_;
  const double whole = std::ceil(moved);
  const auto count = static_cast<std::ptrdiff_t>(line_->nodes());
  passedNodes_ = (passedNodes_ + static_cast<std::ptrdiff_t>(whole)) % count;
  ahead_ = whole - moved;
}

void TimeMarch::setPressure(std::span<const double> pressure) {
  std::copy(pressure.begin(), pressure.end(), pressure_.begin());
}

/// Puts the line over the elements: on nodes exactly, between them by its cubics.
void TimeMarch::placeLine() {
  const std::size_t count = line_->nodes();
  const double h = line_->spacing;
  const double t = ahead_;  // in the segment after node i - passedNodes_
  const auto size = static_cast<std::ptrdiff_t>(count);
  std::size_t from = static_cast<std::size_t>((size - passedNodes_) % size);
  const HermiteWeights weights = hermiteWeights(t, h);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t to = from + 1 == count ? 0 : from + 1;
    const double height = t == 0 ? line_->height[from]
                                 : weights.value0 * line_->height[from] +
                                       weights.value1 * line_->height[to] +
                                       weights.slope0 * line_->slopeAfter[from] +
                                       weights.slope1 * line_->slopeLeftOf(to);
    height_[i] = height - lowest_;
    from = to;
  }
}

/// Returns the approach up to the first threshold and further, with sum max(0, further -
/// threshold_i) = load (m). Thresholds are counted from the first one on, because a load may press
/// by far less than the approach. Newton's method on a convex, piecewise linear function: after the
/// first step it approaches from the right and only falls, until the set of touched elements
/// repeats; a step that does not fall is rounding.
TimeMarch::Approach TimeMarch::balance(double load) {
  const double lowest = smallest(threshold_);
  for (double& threshold : threshold_) threshold -= lowest;
  double d = std::max(-lowest, load);
  for (bool first = true; true; first = false) {
    const Touched touched = touchedBy(d, threshold_);
    const double next = touched.count > 0 ? (load + touched.sum) / touched.count : load;
    if (!(next < d) && !first) return {lowest, d};
    if (next == d || touched.count == 0) return {lowest, next};
    d = next;
  }
}

/// Returns whether a p that is linear in a step of this length is not possible: each p would then
/// get the error of the one before with the opposite sign, little smaller. That is so where the
/// step resolves the dashpot of the elements. Where it does not, a constant p would lag behind the
/// other amplitudes by half a step, as if the elements had more friction.
bool TimeMarch::needsConstantPressure(double dt) const {
  constexpr double kDamped = 0.8;  // of the error of the step before
  if (modes_.glassyCompliance > 0) return false;
  double before = 0, after = 0;
  for (std::size_t j = 0; j < modes_.modes(); ++j) {
    const DrivenDecay decay = drivenDecay(modes_.rate[j] * dt);
    before += modes_.fluidity[j] * (decay.driven[0] - decay.driven[1]);
    after += modes_.fluidity[j] * decay.driven[1];
  }
  return before > kDamped * after;
}

void TimeMarch::prepareSteps(double dt) {
  if (dt == preparedFor_) return;
  preparedFor_ = dt;
  isPressureConstant_ = needsConstantPressure(dt);
  compliance_ = modes_.glassyCompliance;
  for (std::size_t j = 0; j < creep_.size(); ++j) {
    const double z = modes_.rate[j] * dt, flow = modes_.fluidity[j] * dt;
    const DrivenDecay decay = drivenDecay(z);
    Creep& creep = creep_[j];
    creep.kept = decay.kept;
    creep.forgotten = -std::expm1(-z);
    creep.before = isPressureConstant_ ? 0 : flow * (decay.driven[0] - decay.driven[1]);
    creep.after = flow * (isPressureConstant_ ? decay.driven[0] : decay.driven[1]);
    creep.stiffness = modes_.rate[j] / modes_.fluidity[j];
    const double whole = z > 0 ? -0.5 * std::expm1(-2 * z) / z : 1;  // for a constant p
    const LossForm form = isPressureConstant_ ? LossForm{} : lossForm(z);
    creep.loss = {flow * whole, 0, 0};
    if (!isPressureConstant_) creep.loss[1] = flow * (z > 0 ? form.ed[0] / z : 1);
    if (!isPressureConstant_) creep.loss[2] = flow * (z > 0 ? form.dd[0] / z : 1.0 / 3);
    compliance_ += creep.after;
  }
}

/// Computes the depths at the end of the step if nothing touches, and the approach at which the
/// line reaches them. Under a constant p a short step presses elements by far less than their
/// depth, so everything is counted from the step's beginning: a touched element has exactly no gap.
void TimeMarch::creepFreely() {
  const std::size_t count = depth_.size();
  std::fill(free_.begin(), free_.end(), 0);
  std::fill(threshold_.begin(), threshold_.end(), 0);
  for (std::size_t j = 0; j < creep_.size(); ++j) {
    const Creep creep = creep_[j];
    double* amplitude = amplitude_.data() + j * count;
    if (creep.before == 0)
      for (std::size_t i = 0; i < count; ++i) {
        free_[i] += creep.kept * amplitude[i];
        threshold_[i] -= creep.forgotten * amplitude[i];
      }
    else
      for (std::size_t i = 0; i < count; ++i)
        free_[i] += creep.kept * amplitude[i] + creep.before * 0.25 * pressure_[i];
  }
  for (std::size_t i = 0; i < count; ++i) {
    const double gap = depth_[i] - (indentation_ - lastHeight_[i]);
    threshold_[i] = isPressureConstant_ ? threshold_[i] + gap + (height_[i] - lastHeight_[i])
                                        : free_[i] + height_[i] - indentation_;
  }
}

/// Presses the touched elements to the new indentation and computes the sums.
template <bool IsConstant>
MarchStep TimeMarch::finishStep(const Approach& approach) {
  const std::size_t count = depth_.size();
  const double before = before_;
  const double h = 4 * line_->spacing;  // p is 4 times the load of the amplitudes
  double load = 0, work = 0, stored = 0, dissipated = 0, advance = 0, closing = 0;
  std::size_t touching = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double pushed = std::max(approach.further - threshold_[i], 0.0);
    const double start = depth_[i], end = pushed > 0 ? indentation_ - height_[i] : free_[i];
    const double last = 0.25 * pressure_[i], now = pushed / compliance_;
    const double mean = IsConstant ? now : 0.5 * (last + now);
    const double gap = start - (before - lastHeight_[i]);
    load += now;
    advance += mean * (lastHeight_[i] - height_[i]);
    if (IsConstant) closing += mean * gap;
    if (!IsConstant) stored += 0.5 * modes_.glassyCompliance * (now - last) * (now + last);
    touching += pushed > 0 ? 1 : 0;
    depth_[i] = end;
    threshold_[i] = last;  // from here on it is the previous pressure
    pressure_[i] = 4 * now;
  }
  for (std::size_t j = 0; j < creep_.size(); ++j) {
    const Creep creep = creep_[j];
    double* amplitude = amplitude_.data() + j * count;
    const bool isSlow = creep.forgotten < 0.5;
    for (std::size_t i = 0; i < count; ++i) {
      const double start = amplitude[i], now = 0.25 * pressure_[i];
      double driven = creep.after * now;
      if constexpr (!IsConstant) driven += creep.before * threshold_[i];
      const double change = driven - creep.forgotten * start;
      // A settled amplitude stays exactly the same, and a forgotten one leaves no rounding error.
      const double end = isSlow ? start + change : creep.kept * start + driven;
      if constexpr (IsConstant) work += now * change;
      stored += 0.5 * creep.stiffness * change * (end + start);
      if constexpr (IsConstant) {
        const double x = now - creep.stiffness * start;
        dissipated += creep.loss[0] * x * x;
      } else {
        dissipated += creep.taken(threshold_[i] - creep.stiffness * start, now - threshold_[i]);
      }
      amplitude[i] = end;
    }
  }
  MarchStep result;
  result.indentation = indentation_;
  result.normalForce = h * load;
  // Under a p that is linear in time the amplitudes determine the depths between beginning and end:
  // their stored and dissipated energy is exactly the work.
  result.work = h * (IsConstant ? work : stored + dissipated);
  result.stored = h * stored;
  result.dissipated = h * dissipated;
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
  if (step.contacts == 0 && last) step.contacts = 1;  // contact all around
}

double TimeMarch::slopeForce() const {
  const std::vector<double> slope = lineSlope();
  double force = 0;
  for (std::size_t i = 0; i < slope.size(); ++i) force += pressure_[i] * slope[i];
  return force * line_->spacing;
}

MarchStep TimeMarch::step(const MarchLoad& load, double dt, double distance) {
  prepareSteps(dt);
  keepBegin();
  moveLine(distance);
  std::swap(height_, lastHeight_);
  placeLine();
  creepFreely();
  before_ = indentation_;
  const Approach approach = load.kind == LoadKind::Force
                                ? balance(load.normalForce * compliance_ / (4 * line_->spacing))
                                : Approach{0, load.depth - indentation_};
  indentation_ += approach.whole();
  MarchStep result = isPressureConstant_ ? finishStep<true>(approach) : finishStep<false>(approach);
  countContacts(result);
  const bool moves = std::abs(distance) > kMinMove * line_->spacing;
  result.slopeForce = moves ? result.lineWork / distance : slopeForce();
  recordStep(dt);
  return result;
}

// ---- Records of the elements for pictures that need them

void TimeMarch::record(MarchRecords wanted) {
  const std::size_t count = depth_.size();
  if (!wanted.sinceContact) {
    sinceContact_.clear();
  } else if (sinceContact_.empty()) {
    sinceContact_.assign(count, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < count; ++i)
      if (pressure_[i] > 0) sinceContact_[i] = 0;
  }
  if (!wanted.power)
    power_.clear();
  else if (power_.empty())
    power_ = dissipatedPower(modes_, pressure_, amplitude_);
  records_ = wanted;
}

void TimeMarch::setSinceContact(std::span<const double> seconds) {
  sinceContact_.assign(seconds.begin(), seconds.end());
}

std::vector<double> TimeMarch::lineSlope() const {
  const std::size_t count = line_->nodes();
  const double h = line_->spacing, t = ahead_;
  const auto size = static_cast<std::ptrdiff_t>(count);
  std::size_t from = static_cast<std::size_t>((size - passedNodes_) % size);
  std::vector<double> slope(count);
  const HermiteSlopeWeights weights = hermiteSlopeWeights(t);
  for (double& here : slope) {
    const std::size_t to = from + 1 == count ? 0 : from + 1;
    const double mean = (line_->height[to] - line_->height[from]) / h;
    here = t == 0 ? 0.5 * (line_->slopeAfter[from] + line_->slopeLeftOf(from))
                  : weights.mean * mean + weights.slope0 * line_->slopeAfter[from] +
                        weights.slope1 * line_->slopeLeftOf(to);
    from = to;
  }
  return slope;
}

void TimeMarch::keepBegin() {
  if (!records_.power) return;
  beginDepth_ = depth_;
  beginPressure_ = pressure_;
  beginAmplitude_ = amplitude_;
}

void TimeMarch::recordStep(double dt) {
  if (records_.sinceContact)
    for (std::size_t i = 0; i < sinceContact_.size(); ++i)
      sinceContact_[i] = pressure_[i] > 0 ? 0 : sinceContact_[i] + dt;
  if (records_.power) recordPower(dt);
}

/// Computes for each element what finishStep sums as MarchStep::dissipated and gapWork.
void TimeMarch::recordPower(double dt) {
  const std::size_t count = depth_.size();
  // A linear pressure comes from the difference of depths.
  const double ofDepth = isPressureConstant_ ? 0 : kRounding * std::abs(indentation_) / compliance_;
  const double rounding =
      std::max({ofDepth, pressureRounding(beginPressure_), pressureRounding(pressure_)});
  const auto unlessRounding = [rounding](double x) { return std::abs(x) > rounding ? x : 0; };
  std::fill(power_.begin(), power_.end(), 0.0);
  for (std::size_t j = 0; j < creep_.size(); ++j) {
    const Creep creep = creep_[j];
    const double* begin = beginAmplitude_.data() + j * count;
    for (std::size_t i = 0; i < count; ++i) {
      const double now = 0.25 * pressure_[i],
                   last = isPressureConstant_ ? now : 0.25 * beginPressure_[i];
      power_[i] += creep.taken(unlessRounding(last - creep.stiffness * begin[i]),
                               unlessRounding(now - last));
    }
  }
  if (isPressureConstant_)
    for (std::size_t i = 0; i < count; ++i)
      if (pressure_[i] > 0)
        power_[i] += 0.25 * pressure_[i] * (beginDepth_[i] - (before_ - lastHeight_[i]));
  for (double& power : power_) power *= 4 / dt;
}

std::vector<double> dissipatedPower(const RetardationModes& modes, std::span<const double> pressure,
                                    std::span<const double> amplitudes) {
  std::vector<double> power(pressure.size());
  const double rounding = pressureRounding(pressure);
  for (std::size_t j = 0; j < modes.modes(); ++j) {
    const std::span<const double> amplitude = amplitudes.subspan(j * power.size(), power.size());
    const double stiffness = modes.rate[j] / modes.fluidity[j];
    for (std::size_t i = 0; i < power.size(); ++i) {
      const double unheld = 0.25 * pressure[i] - stiffness * amplitude[i];
      if (std::abs(unheld) > rounding) power[i] += 4 * modes.fluidity[j] * unheld * unheld;
    }
  }
  return power;
}

void addLocalFriction(std::span<double> power, std::span<const double> pressure,
                      const Interface& interface, double velocity) {
  for (std::size_t i = 0; i < power.size(); ++i)
    power[i] += localFrictionLoad(interface, pressure[i]) * std::abs(velocity);
}

}  // namespace asperity
