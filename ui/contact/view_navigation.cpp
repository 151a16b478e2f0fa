#include "ui/contact/view_navigation.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/base/number_text.h"

namespace asperity {
namespace {

// The smallest and largest height range, relative to the fitted one: from single elements to a
// range at which x and y have the same scale on almost any line.
constexpr double kMinHeights = 1e-4, kMaxHeights = 1e6;

double wrapped(double share) {
  const double rest = share - std::floor(share);
  return rest < 1 && std::isfinite(rest) ? rest : 0;
}

double usable(double factor) {
  return std::isfinite(factor) && factor > 0 ? factor : 1;
}

}  // namespace

std::string ViewNavigation::toText() const {
  std::string text = follows_ ? "line" : "rubber";
  for (const double number : {left_, width_, bottom_, top_}) text += ' ' + plainNumber(number);
  return text;
}

ViewNavigation ViewNavigation::fromText(const std::string& text) {
  std::istringstream words(text);
  std::string word;
  words >> word;
  ViewNavigation view;
  view.follows_ = word == "line";
  if (!view.follows_ && word != "rubber") return {};
  for (double* number : {&view.left_, &view.width_, &view.bottom_, &view.top_})
    if (!(words >> word) || !readNumber(word, *number) || !std::isfinite(*number)) return {};
  if (!(view.width_ > 0 && view.top_ > view.bottom_)) return {};
  // Only what differs from an allowed view by more than rounding is changed.
  constexpr double kRounding = 1e-9;
  const ViewNavigation clamped = view.within(0);
  const auto isSame = [](double a, double b) {
    return std::abs(a - b) <= kRounding * std::max(1.0, std::abs(a));
  };
  const bool isAllowed = isSame(view.left_, clamped.left_) && isSame(view.width_, clamped.width_) &&
                         isSame(view.bottom_, clamped.bottom_) && isSame(view.top_, clamped.top_);
  return isAllowed ? view : clamped;
}

ContactView ViewNavigation::applied(const ContactView& fitted, double period,
                                    double distance) const {
  ContactView view = fitted;
  view.width = width_ * period;
  view.left = follows_ ? period * wrapped(left_ + wrapped(distance / period)) : left_ * period;
  const double size = fitted.top - fitted.bottom;
  if (!hasFittedHeights()) {
    view.bottom = fitted.bottom + bottom_ * size;
    view.top = fitted.bottom + top_ * size;
  }
  return view;
}

/// Limits the view: never wider than the period; enlarged heights stay within the fitted ones,
/// others contain them.
ViewNavigation ViewNavigation::within(double finest) const {
  ViewNavigation clamped = *this;
  const double middle = left_ + 0.5 * width_;
  clamped.width_ = std::clamp(width_, std::min(std::max(finest, 1e-12), 1.0), 1.0);
  clamped.left_ = wrapped(clamped.width_ == width_ ? left_ : middle - 0.5 * clamped.width_);
  const double size = std::clamp(top_ - bottom_, kMinHeights, kMaxHeights);
  const double centre = 0.5 * (bottom_ + top_);
  const double low = std::min(0.0, 1 - size), high = std::max(0.0, 1 - size);
  clamped.bottom_ = std::clamp(centre - 0.5 * size, low, high);
  clamped.top_ = clamped.bottom_ + size;
  // A view that differs from the fitted one only by rounding becomes exactly that one.
  if (std::abs(size - 1) < 1e-9) clamped.bottom_ = 0, clamped.top_ = 1;
  return clamped;
}

ViewNavigation ViewNavigation::zoomed(const ViewPosition& at, double xFactor, double yFactor,
                                      double finest) const {
  ViewNavigation next = *this;
  const double width = std::clamp(width_ / usable(xFactor), std::min(finest, 1.0), 1.0);
  next.left_ = left_ + at.x * (width_ - width);
  next.width_ = width;
  const double size = top_ - bottom_;
  const double nextSize = std::clamp(size / usable(yFactor), kMinHeights, kMaxHeights);
  next.bottom_ = bottom_ + at.y * (size - nextSize);
  next.top_ = next.bottom_ + nextSize;
  return next.within(finest);
}

ViewNavigation ViewNavigation::panned(double dx, double dy) const {
  ViewNavigation next = *this;
  const double size = top_ - bottom_;
  if (std::isfinite(dx)) next.left_ -= dx * width_;
  if (std::isfinite(dy)) next.bottom_ -= dy * size;
  next.top_ = next.bottom_ + size;
  return next.within(width_);
}

ViewNavigation ViewNavigation::following(bool follows, double period, double distance) const {
  ViewNavigation next = *this;
  const double moved = wrapped(distance / period);
  if (follows != follows_) next.left_ = wrapped(follows ? left_ - moved : left_ + moved);
  next.follows_ = follows;
  return next;
}

ViewNavigation ViewNavigation::fitted() const {
  ViewNavigation next;
  next.follows_ = follows_;
  return next;
}

ViewNavigation ViewNavigation::withFittedHeights() const {
  ViewNavigation next = *this;
  next.bottom_ = 0;
  next.top_ = 1;
  return next;
}

}  // namespace asperity
