#include "ui/contact/contact_viewer.h"

#include <cmath>
#include <utility>

#include "ui/contact/frame_curves.h"

namespace asperity {
namespace {

constexpr double kHeights = 0.7;  // exponent of heights, a usual Hurst exponent
constexpr double kMin = 8;        // minimum number of elements across the plot
// The magnifier moves to another asperity only if its pressure is greater by the first factor;
// within the second part of the period it is still the same asperity.
constexpr double kMore = 1.25, kSame = 0.01;

/// Returns whether the colour scale is kept: another scene, the end of settling and a motion that
/// begins again have a new scale.
bool showsTheSame(const Frame& last, const Frame& now) {
  return last.sceneNumber == now.sceneNumber && last.isSettling == now.isSettling &&
         last.time <= now.time;
}

/// Returns the image of a periodic position at or after the left end of the view; it may lie beyond
/// the right end.
double fromLeftEnd(double x, const ContactView& view, double period) {
  return x - period * std::floor((x - view.left) / period);
}

bool isWithin(double x, const ContactView& view, double period) {
  return fromLeftEnd(x, view, period) <= view.left + view.width;
}

}  // namespace

void ContactViewer::setFrame(std::shared_ptr<const Frame> frame) {
  const std::shared_ptr<const Frame> last = std::exchange(frame_, std::move(frame));
  if (!frame_) return;
  if (last && last->length != frame_->length) fit();
  if (fitted_ && last && !showsTheSame(*last, *frame_))
    fitted_->pressure = fitted_->age = fitted_->power = 0;
  fitHeightsToFrame();
  if (magnifies_) followPeak(last.get());
}

void ContactViewer::fitHeightsToFrame() {
  fitted_ = fittedView(*frame_, fitted_, labelSpace_);
  fitted_->left = fitted_->width = 0;
}

void ContactViewer::setLabelSpace(double part) {
  constexpr double kSameSpace = 0.01;  // of the height: the header's texts change it by less
  if (std::abs(part - labelSpace_) < kSameSpace) return;
  labelSpace_ = part;
  if (!frame_ || !fitted_) return;
  fitted_->bottom = fitted_->top = 0;
  fitHeightsToFrame();
}

/// Finds the greatest pressure in the view, but keeps the previous position while its pressure is
/// still similar.
void ContactViewer::followPeak(const Frame* last) {
  const Frame& frame = *frame_;
  if (!isDrawable(frame)) return;
  const double period = periodLength(frame);
  const double moved = last && last->length == frame.length ? frame.distance - last->distance : 0;
  const double here = peak_ + moved;
  const ContactView seen = view();
  std::optional<std::size_t> most, same;
  for (std::size_t i = 0; i < frame.pressure.size(); ++i) {
    const double p = frame.pressure[i], x = static_cast<double>(i) * frame.spacing;
    if (!(p > 0) || !isWithin(x, seen, period)) continue;
    if (!most || p > frame.pressure[*most]) most = i;
    const double away = std::remainder(x - here, period);
    if (std::abs(away) < kSame * period && (!same || p > frame.pressure[*same])) same = i;
  }
  const bool stays =
      same && isWithin(here, seen, period) && frame.pressure[*most] < kMore * frame.pressure[*same];
  // The magnifier moves with the line, not with the element that has the greatest pressure.
  peak_ = stays || !most ? here : static_cast<double>(*most) * frame.spacing;
}

/// Returns the middle of what the magnifier enlarges: always a position in the view, which a line
/// that slides leaves at one end and enters again at the other.
double ContactViewer::magnified(const ContactView& seen) const {
  if (!isDrawable(*frame_)) return peak_;
  const double period = periodLength(*frame_);
  return isWithin(peak_, seen, period) ? fromLeftEnd(peak_, seen, period)
                                       : seen.left + 0.5 * seen.width;
}

ContactView ContactViewer::view() const {
  const ContactView fitted = resolvedView(*frame_, fitted_.value_or(ContactView{}));
  return navigation_.applied(fitted, isDrawable(*frame_) ? periodLength(*frame_) : fitted.width,
                             frame_->distance);
}

double ContactViewer::finest() const {
  const double points = frame_ ? static_cast<double>(frame_->lineHeight.size()) : 0;
  return points > kMin ? kMin / points : 1;
}

ContactPictureOptions ContactViewer::options() const {
  ContactPictureOptions options;
  options.view = view();
  options.overlay = overlay_;
  options.probe = pointer();
  if (magnifies_) options.magnifier = Magnifier{options.probe.value_or(magnified(options.view))};
  return options;
}

FrameFields ContactViewer::fields() const {
  FrameFields fields = fieldsFor(overlay_);
  fields.lineSlope = cursor_ || element_;
  return fields;
}

/// Shows another part; the magnifier follows also while no new frame comes.
void ContactViewer::navigate(const ViewNavigation& navigation) {
  navigation_ = navigation;
  if (magnifies_ && frame_ && fitted_) followPeak(frame_.get());
}

void ContactViewer::zoom(const ViewPosition& at, double steps) {
  navigate(navigation_.zoomed(at, std::pow(kZoomStep, steps), std::pow(kZoomStep, kHeights * steps),
                              finest()));
  // Zooming out to the whole period shows everything.
  if (steps < 0 && navigation_.enlargement() == 1) fit();
}

void ContactViewer::exaggerate(const ViewPosition& at, double steps) {
  navigate(navigation_.zoomed(at, 1, std::pow(kZoomStep, steps), finest()));
}

void ContactViewer::pan(double dx, double dy) {
  // A view of all heights keeps them when it is moved, and a view of the whole period its axis.
  navigate(navigation_.panned(navigation_.enlargement() > 1 ? dx : 0,
                              navigation_.hasFittedHeights() ? 0 : dy));
}

void ContactViewer::fit() {
  navigate(navigation_.fitted());
}

void ContactViewer::fitHeights() {
  navigation_ = navigation_.withFittedHeights();
}

void ContactViewer::follow(bool follows) {
  if (!frame_ || !isDrawable(*frame_))
    navigation_ = navigation_.following(follows, 1, 0);
  else
    navigation_ = navigation_.following(follows, periodLength(*frame_), frame_->distance);
}

void ContactViewer::pointAt(std::optional<ViewPosition> position) {
  cursor_ = position;
  element_.reset();
}

void ContactViewer::movePointer(int elements) {
  if (!frame_ || !isDrawable(*frame_)) return;
  const ContactView seen = view();
  const double from = pointer().value_or(seen.left + 0.5 * seen.width);
  double to = std::round(from / frame_->spacing + elements) * frame_->spacing;
  // The crosshair leaves the view on one side and enters it on the other.
  if (to < seen.left) to = seen.left + seen.width - 0.5 * frame_->spacing;
  if (to > seen.left + seen.width) to = seen.left + 0.5 * frame_->spacing;
  cursor_.reset();
  element_ = std::round(to / frame_->spacing) * frame_->spacing;
}

std::optional<double> ContactViewer::pointer() const {
  if (!frame_) return std::nullopt;
  if (!cursor_) return element_;
  const ContactView seen = view();
  return seen.left + cursor_->x * seen.width;
}

std::optional<ProbeReading> ContactViewer::reading() const {
  const auto x = pointer();
  return x ? probeReading(*frame_, *x) : std::nullopt;
}

void ContactViewer::magnify(bool magnifies) {
  magnifies_ = magnifies;
  if (magnifies && frame_) followPeak(nullptr);
}

}  // namespace asperity
