// What a march notes of its elements where a picture asks for it.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/contact/march/dissipation.h"
#include "core/contact/march/time_march.h"

namespace asperity {

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
  for (double& here : slope) {
    const std::size_t to = from + 1 == count ? 0 : from + 1;
    const double rise = (line_->height[to] - line_->height[from]) / h;
    here = t == 0 ? 0.5 * (line_->slopeAfter[from] + line_->slopeLeftOf(from))
                  : 6 * t * (1 - t) * rise + (1 - t) * (1 - 3 * t) * line_->slopeAfter[from] +
                        t * (3 * t - 2) * line_->slopeLeftOf(to);
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

/// Element by element what finishStep sums up as MarchStep::dissipated and gapWork.
void TimeMarch::recordPower(double dt) {
  const std::size_t count = depth_.size();
  const bool hasDashpot = modes_.glassyCompliance == 0;
  // Without a dashpot a pressure comes from the difference of depths.
  const double ofDepth = hasDashpot ? 0 : kRounding * std::abs(indentation_) / compliance_;
  const double rounding =
      std::max({ofDepth, pressureRounding(beginPressure_), pressureRounding(pressure_)});
  const auto unlessRounding = [rounding](double x) { return std::abs(x) > rounding ? x : 0; };
  std::fill(power_.begin(), power_.end(), 0.0);
  for (std::size_t j = 0; j < creep_.size(); ++j) {
    const Creep creep = creep_[j];
    const double* begin = beginAmplitude_.data() + j * count;
    for (std::size_t i = 0; i < count; ++i) {
      const double now = 0.25 * pressure_[i], last = hasDashpot ? now : 0.25 * beginPressure_[i];
      power_[i] += creep.taken(unlessRounding(last - creep.stiffness * begin[i]),
                               unlessRounding(now - last));
    }
  }
  if (hasDashpot)
    for (std::size_t i = 0; i < count; ++i)
      if (pressure_[i] > 0)
        power_[i] += 0.25 * pressure_[i] * (beginDepth_[i] - (before_ - lastRise_[i]));
  for (double& power : power_) power *= 4 / dt;
}

}  // namespace asperity
