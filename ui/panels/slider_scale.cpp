#include "ui/panels/slider_scale.h"

#include <algorithm>
#include <cmath>

#include "ui/panels/number_text.h"

namespace asperity {

namespace {

constexpr int kSteps = 1000;
constexpr int kDigits = 3;

struct Span {
  double from, to;
  Scale scale;
  bool whole;
};

Span spanOf(const Parameter& parameter) {
  if (const auto* real = std::get_if<RealField>(&parameter.field))
    return {real->sliderFrom, real->sliderTo, real->scale, false};
  const auto& integer = std::get<IntegerField>(parameter.field);
  return {static_cast<double>(integer.sliderFrom), static_cast<double>(integer.sliderTo),
          integer.scale, true};
}

}  // namespace

SliderScale::SliderScale(const Parameter& parameter) {
  const Span span = spanOf(parameter);
  scale_ = span.scale;
  if (scale_ == Scale::LogarithmicFromNone) values_.push_back(0);
  const double low = coordinate(span.from);
  const double high = coordinate(span.to);
  for (int i = 0; i <= kSteps; ++i) {
    const double between = low + (high - low) * i / kSteps;
    double value = scale_ == Scale::Linear ? between : std::exp(between);
    value = roundedToDigits(value, kDigits);
    if (span.whole) value = std::round(value);
    value = std::clamp(value, span.from, span.to);
    if (values_.empty() || value > values_.back()) values_.push_back(value);
  }
}

double SliderScale::coordinate(double value) const {
  return scale_ == Scale::Linear ? value : std::log(value);
}

double SliderScale::valueAt(int position) const {
  return values_[static_cast<std::size_t>(std::clamp(position, 0, count() - 1))];
}

int SliderScale::positionOf(double value) const {
  const auto above = std::lower_bound(values_.begin(), values_.end(), value);
  if (above == values_.begin()) return 0;
  if (above == values_.end()) return count() - 1;
  const double middle = (coordinate(*(above - 1)) + coordinate(*above)) / 2;
  const auto nearest = coordinate(value) < middle ? above - 1 : above;  // none is far from all
  return static_cast<int>(nearest - values_.begin());
}

}  // namespace asperity
