#include "core/run/transient_diagram.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include "core/base/input_error.h"
#include "core/base/intervals.h"
#include "core/base/number_text.h"
#include "core/chart/curve_words.h"
#include "core/friction/law.h"
#include "core/material/element_law.h"
#include "core/scene/motion.h"
#include "core/scene/sweep.h"

namespace asperity {
namespace {

// ripples; a strip then shows ripples as at most a third of it
constexpr double kFrictionFloor = 10;
constexpr double kMax = 0.5;                 // maximum part of the value
constexpr double kAir = 0.12;                // part of the range, on either side
constexpr double kContactFloor = 0.2;        // part of a contact fraction
constexpr std::size_t kLongestTrace = 2000;  // samples of a motion
constexpr double kAnySpeed = std::numeric_limits<double>::infinity();

std::vector<DiagramPoint> inTime(std::span<const TransientSample> samples,
                                 double TransientSample::*member) {
  std::vector<DiagramPoint> points;
  for (const TransientSample& sample : samples) points.push_back({sample.time, sample.*member});
  return points;
}

/// Returns the samples, and between two of them one more where friction changes its direction and
/// so is 0. Of that one only the time, the friction and its error are known.
std::vector<TransientSample> withTurns(std::span<const TransientSample> samples) {
  std::vector<TransientSample> all;
  const TransientSample* last = nullptr;
  for (const TransientSample& next : samples) {
    if (last && std::signbit(last->tangentialForce) != std::signbit(next.tangentialForce) &&
        last->mu > 0 && next.mu > 0) {
      const double part = last->mu / (last->mu + next.mu);
      TransientSample turn;
      turn.time = std::lerp(last->time, next.time, part);
      turn.mu = 0;
      if (std::isfinite(last->muError) && std::isfinite(next.muError))
        turn.muError = std::lerp(last->muError, next.muError, part);
      all.push_back(turn);
    }
    all.push_back(next);
    last = &next;
  }
  return all;
}

Diagram strip(const Scene& scene, std::vector<DiagramPoint> points, DiagramAxis yAxis,
              double least) {
  Diagram diagram{.x = {"time t", "s", AxisScale::Linear, 0, scene.sliding.duration},
                  .y = std::move(yAxis)};
  DiagramSeries series;
  series.colour = 0;
  Extent shown;
  for (const DiagramPoint& point : points) shown.add(point.y);
  series.points = std::move(points);
  if (least > 0 && !shown.isEmpty()) axisEnds(shown.least, shown.most, least).setOn(diagram.y);
  diagram.series = {std::move(series)};
  return diagram;
}

std::vector<TransientSample> joined(std::span<const TransientSample> samples,
                                    std::span<const TransientSample> later) {
  std::vector<TransientSample> all(samples.begin(), samples.end());
  all.insert(all.end(), later.begin(), later.end());
  return all;
}

/// Cuts the line of a strip at a time, s, after which it is faded.
void fadeAfter(double time, Diagram& diagram) {
  DiagramSeries& now = diagram.series.front();
  DiagramSeries faded = now;
  faded.isFaded = true;
  std::erase_if(now.points, [&](const DiagramPoint& point) { return point.x > time; });
  std::erase_if(faded.points, [&](const DiagramPoint& point) { return point.x < time; });
  diagram.series.push_back(std::move(faded));
}

/// Adds the known error as a band around the values, under their line; the axis includes it where
/// it reaches 0, as for a body without friction.
void addErrorBand(Diagram& diagram, std::span<const TransientSample> samples) {
  DiagramSeries band{.stroke = SeriesStroke::None, .isBand = true, .colour = 0};
  for (const TransientSample& sample : samples)
    if (std::isfinite(sample.muError))
      band.points.push_back({sample.time, sample.mu, std::max(sample.mu - sample.muError, 0.0),
                             sample.mu + sample.muError});
  if (band.points.size() < 2) return;
  const double low = std::ranges::min(band.points, {}, &DiagramPoint::low).low;
  const double high = std::ranges::max(band.points, {}, &DiagramPoint::high).high;
  if (low < diagram.y.from || high > diagram.y.to) {
    const AxisEnds ends = axisEnds(low, high, 0);
    diagram.y.from = std::min(diagram.y.from, ends.from);
    diagram.y.to = std::max(diagram.y.to, ends.to);
  }
  diagram.series.insert(diagram.series.begin(), std::move(band));
}

/// Returns the time of the last jump of the velocity before `now`, s; a start from rest jumps at 0.
/// NaN: none.
double newestJump(const Sliding& sliding, double now) {
  const Motion motion(sliding);
  if (sliding.kind == SlidingKind::Start) return 0;
  const bool jumped = motion.jump() < motion.duration() && now > motion.jump();
  return jumped && !motion.isSmooth() ? motion.jump() : kNotApplicable;
}

/// Returns whether there will be a guide at the end: it is then explained from the beginning. A
/// line that stops has none, and neither has a scene that cannot run, because its temperature has
/// no shift.
bool willRelax(const Scene& scene) {
  const double end = scene.sliding.duration;
  if (!std::isfinite(newestJump(scene.sliding, end))) return false;
  if (Motion(scene.sliding).velocityAt(end) == 0) return false;
  try {
    return elementLaw(scene.elastomer).kind() == ElementKind::Kelvin;
  } catch (const InputError&) {
    return false;
  }
}

bool isKnown(const TransientSample& sample) {
  return std::isfinite(sample.mu) && std::isfinite(sample.predictedRate);
}

}  // namespace

DiagramSheet transientSheet(const Scene& scene, std::span<const TransientSample> samples,
                            double spacing, double period, std::span<const TransientSample> later) {
  // Axes and band are those of all samples, so that they stay where the motion goes back.
  const std::vector<TransientSample> all = joined(samples, later), turned = withTurns(all);
  const MinimumSpan floors = minimumSpan(all, spacing, period);
  DiagramSheet sheet{.columns = 1, .sharesAxis = true};
  sheet.diagrams = {
      strip(scene, inTime(all, &TransientSample::velocity),
            {"velocity v", "m/s", AxisScale::Linear}, 0),
      strip(scene, inTime(turned, &TransientSample::mu),
            {hasLocalFriction(scene) ? "friction \u03BC, deformation alone" : "friction \u03BC", "",
             AxisScale::Linear},
            floors.friction),
      strip(scene, inTime(all, &TransientSample::indentation),
            {"indentation d", "m", AxisScale::Linear}, floors.indentation),
      strip(scene, inTime(all, &TransientSample::contactLength),
            {"length per contact \u2113", "m", AxisScale::Linear}, floors.contactLength)};
  if (!later.empty())
    for (Diagram& diagram : sheet.diagrams)
      fadeAfter(samples.empty() ? -1 : samples.back().time, diagram);
  addErrorBand(sheet.diagrams[1], turned);
  if (willRelax(scene))
    sheet.note =
        "Dashed: relaxation at the predicted rate 1/\u03C4 + v/\u2113, exact for one contact and a "
        "small change of velocity, a guide otherwise.";
  DiagramSeries guide{.stroke = SeriesStroke::Dashed, .isTheory = true};
  guide.points = relaxationGuide(scene.sliding, samples);
  if (willRelax(scene))
    sheet.status = "a dashed line will show relaxation at the predicted rate 1/\u03C4 + v/\u2113";
  if (guide.points.size() < 2) return sheet;
  sheet.status =
      message("dashed: relaxation at the predicted rate 1/\u03C4 + v/\u2113 = {} s\u207B\u00B9",
              printed(samples.back().predictedRate, 3));
  sheet.diagrams[1].series.push_back(std::move(guide));
  return sheet;
}

DiagramSheet frictionLoopSheet(std::span<const TransientSample> samples,
                               std::span<const TransientSample> later) {
  Diagram diagram{.x = {"velocity v", "m/s", AxisScale::Linear},
                  .y = {"\u03BC with its sign", "", AxisScale::Linear}};
  DiagramSeries loop{.colour = 0}, faded{.colour = 0, .isFaded = true};
  Extent velocities{0, 0}, frictions{0, 0};  // both include 0, where friction changes its direction
  const auto add = [&](const TransientSample& sample, DiagramSeries& series) {
    const double friction =
        sample.normalForce > 0 ? sample.tangentialForce / sample.normalForce : kNotApplicable;
    series.points.push_back({sample.velocity, friction});
    if (!std::isfinite(friction)) return;
    velocities.add(sample.velocity);
    frictions.add(friction);
  };
  for (const TransientSample& sample : samples) add(sample, loop);
  if (!later.empty() && !loop.points.empty()) faded.points = {loop.points.back()};
  for (const TransientSample& sample : later) add(sample, faded);
  axisEnds(velocities.least, velocities.most, 0).setOn(diagram.x);
  axisEnds(frictions.least, frictions.most, 0).setOn(diagram.y);
  DiagramSeries now{.mark = SeriesMark::Ring, .stroke = SeriesStroke::None, .colour = 1};
  if (!loop.points.empty()) now.points = {loop.points.back()};
  diagram.series = {std::move(loop), std::move(now)};
  if (!faded.points.empty()) diagram.series.push_back(std::move(faded));
  DiagramSheet sheet;
  sheet.diagrams = {std::move(diagram)};
  return sheet;
}

Diagram contactStrip(const Scene& scene, std::span<const TransientSample> samples) {
  return strip(scene, inTime(samples, &TransientSample::contactFraction),
               {"in contact", "", AxisScale::Linear}, kContactFloor);
}

AxesFactors axesFactors(const Frame& frame, CurveAxes axes) {
  if (axes == CurveAxes::Physical) return {1, 1};
  AxesFactors factors;
  if (!(frame.rmsHeight > 0) || !(frame.rmsSlope > 0)) return factors;
  factors.friction = 1 / frame.rmsSlope;
  const ElementLaw law = elementLaw(frame.scene->elastomer);
  if (law.kind() != ElementKind::Kelvin) return factors;
  const double velocity = 1;
  factors.velocity = dimensionlessVelocity(lawInput(frame, velocity));
  return factors;
}

namespace {

/// Returns the rms slope of the line where it is in contact; NaN where the frame has no slopes.
double rmsSlopeInContact(const Frame& frame) {
  double squares = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < std::min(frame.lineSlope.size(), frame.pressure.size()); ++i) {
    if (!(frame.pressure[i] > 0)) continue;
    squares += frame.lineSlope[i] * frame.lineSlope[i];
    ++count;
  }
  return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : kNotApplicable;
}

/// Velocity and friction with their signs.
struct TracePoint {
  double velocity = 0, friction = 0;
};

/// Returns whether two values are so far apart, on different sides of 0 or by their ratio, that a
/// straight line between them is bent on a logarithmic axis.
bool isBentBetween(double a, double b) {
  constexpr double kRatio = 1.25;
  const auto [least, most] = std::minmax({std::abs(a), std::abs(b)});
  return a * b < 0 || most > kRatio * least;
}

/// The path of a motion over the magnitude of its velocity. Between two samples, a smooth motion
/// has velocity and friction on straight lines in time, which logarithmic axes bend: most near
/// rest, and where friction changes its direction. The path has further points there: down to a
/// least velocity, below which it is interrupted, and to friction of 0.
class MotionTrace {
 public:
  MotionTrace(std::span<const TransientSample> samples, double slowest, const AxesFactors& factors)
      : factors_(factors), slowest_(slowest) {
    for (const TransientSample& sample : samples)
      if (sample.velocity != 0) slowest_ = std::min(slowest_, std::abs(sample.velocity));
  }

  /// Adds a sample, and before it the way from the previous one, if it is known.
  void add(const TransientSample& sample, bool isSmooth) {
    constexpr int kHalvings = 14;
    const TracePoint to{sample.velocity, std::copysign(sample.mu, sample.tangentialForce)};
    const bool isKnown = std::isfinite(last_.friction) && std::isfinite(to.friction);
    if (isSmooth && isKnown)
      addWay(last_, to, kHalvings);
    else if (last_.velocity * to.velocity < 0)
      interrupt();
    push(to);
    last_ = to;
  }

  std::vector<DiagramPoint> points{};

 private:
  /// Adds points between two others where the axes bend the line between them.
  void addWay(const TracePoint& from, const TracePoint& to, int halvings) {
    const TracePoint middle{std::midpoint(from.velocity, to.velocity),
                            std::midpoint(from.friction, to.friction)};
    const bool isBent =
        isBentBetween(from.velocity, to.velocity) || isBentBetween(from.friction, to.friction);
    if (!isBent) return;
    if (halvings == 0) {
      if (from.velocity * to.velocity < 0)
        interrupt();
      else if (from.friction * to.friction <= 0)
        push({middle.velocity, 0});
      return;
    }
    addWay(from, middle, halvings - 1);
    if (std::abs(middle.velocity) < slowest_)
      interrupt();
    else
      push(middle);
    addWay(middle, to, halvings - 1);
  }

  void push(const TracePoint& point) {
    points.push_back({std::abs(point.velocity) * factors_.velocity,
                      std::abs(point.friction) * factors_.friction});
  }

  void interrupt() {
    if (!points.empty() && std::isfinite(points.back().x))
      points.push_back({kNotApplicable, kNotApplicable});
  }

  AxesFactors factors_;
  double slowest_;
  TracePoint last_{0, kNotApplicable};
};

/// Returns a quantity of the frame, whose friction at the moment is `mu`.
double quantityOf(const Frame& frame, CurveQuantity quantity, double mu) {
  const ContactState& state = frame.state;
  switch (quantity) {
    case CurveQuantity::Mu:
      return mu;
    case CurveQuantity::MuTotal:
      return mu + state.muInterface;
    case CurveQuantity::NormalizedMu:
      return mu / frame.rmsSlope;
    case CurveQuantity::ContactFraction:
      return state.contactFraction;
    case CurveQuantity::RmsSlopeContact:
      return rmsSlopeInContact(frame);
    case CurveQuantity::Indentation:
      return state.indentation;
    case CurveQuantity::TangentialForce:
      return mu * state.normalForce;
    case CurveQuantity::Power:
      return mu * state.normalForce * std::abs(frame.scene->sliding.velocity);
    default:
      break;
  }
  const double width = contactWidth(frame.scene->load, frame.length);
  return state.contactFraction > 0
             ? state.normalForce / (state.contactFraction * frame.length * width)
             : kNotApplicable;
}

}  // namespace

DiagramMarker frameMarker(const Frame& frame, CurveAxes axes, CurveQuantity y) {
  const AxesFactors factors = axesFactors(frame, axes);
  const Scene& scene = *frame.scene;
  const bool isOfVelocity = axes == CurveAxes::Dimensionless || scene.sweep.isOfVelocity();
  DiagramMarker marker;
  double velocity = scene.sliding.velocity, mu = frame.state.mu;
  Message label = message("v = {}", printed(velocity, "m/s"));
  if (frame.transient) {
    const std::vector<TransientSample>& samples = *frame.transient;
    // A line at rest is at no place of the curve; its last time step still had a velocity.
    const bool rests = samples.empty() || frame.velocity == 0;
    velocity = std::abs(rests ? frame.velocity : samples.back().velocity);
    mu = samples.empty() ? kNotApplicable : samples.back().mu;
    label = message("|v| = {}", printed(std::abs(frame.velocity), "m/s"));
    marker.isFixed = true;
    const std::size_t shown = std::min(samples.size(), kLongestTrace);
    if (isOfVelocity && y == CurveQuantity::Mu) {
      const auto shownSamples = std::span(samples).last(shown);
      const double slowest = scene.sweep.isOfVelocity() ? scene.sweep.velocityFrom : kAnySpeed;
      MotionTrace trace(shownSamples, slowest, factors);
      for (const TransientSample& sample : shownSamples)
        trace.add(sample, Motion(scene.sliding).isSmooth());
      marker.trace = std::move(trace.points);
    }
  }
  marker.name = marker.isFixed ? "this motion, now" : "this line, now";
  marker.x = isOfVelocity ? velocity * factors.velocity : ownSweptValue(scene);
  marker.y = axes == CurveAxes::Dimensionless ? mu * factors.friction : quantityOf(frame, y, mu);
  if (axes == CurveAxes::Dimensionless)
    label = message("v\u0304 = {}", printed(marker.x, 3));
  else if (!isOfVelocity)
    label = describeParameter(scene.sweep.key, scene);
  // A logarithmic axis has no place for rest.
  const bool isLogarithmic =
      axes == CurveAxes::Dimensionless || scene.sweep.scale == SweepScale::Logarithmic;
  if (!marker.isFixed && isLogarithmic && !(marker.x > 0)) marker.name = {};
  marker.label = std::move(label);
  return marker;
}

std::vector<DiagramPoint> relaxationGuide(const Sliding& sliding,
                                          std::span<const TransientSample> samples) {
  if (samples.empty() || !isKnown(samples.back())) return {};
  const double jump = newestJump(sliding, samples.back().time);
  if (!std::isfinite(jump)) return {};
  const auto first = std::ranges::find_if(
      samples, [&](const TransientSample& s) { return s.time > jump && isKnown(s); });
  if (first == samples.end()) return {};
  const double end = samples.back().mu;
  double time = first->time, exponent = 0;
  std::vector<DiagramPoint> guide;
  for (auto sample = first; sample != samples.end() && isKnown(*sample); ++sample) {
    exponent += sample->predictedRate * (sample->time - time);
    time = sample->time;
    guide.push_back({time, end + (first->mu - end) * std::exp(-exponent)});
  }
  return guide;
}

MinimumSpan minimumSpan(std::span<const TransientSample> samples, double spacing, double period) {
  double length = 0, fraction = 0, count = 0;
  for (const TransientSample& sample : samples) {
    if (!(sample.contactLength > 0)) continue;
    length += sample.contactLength;
    fraction += sample.contactFraction;
    ++count;
  }
  if (!(count > 0) || !(spacing > 0)) return {};
  length /= count;
  const double contacts = std::max(1.0, fraction / count * period / length);
  const double ripple = spacing / length / std::sqrt(contacts);
  const double floor = std::min(kFrictionFloor * ripple, kMax);
  return {floor, std::min(ripple, kMax), floor};
}

AxisEnds axisEnds(double low, double high, double least) {
  const double middle = 0.5 * (low + high);
  const double size = std::max(high - low, least * std::abs(middle));
  if (!(size > 0)) return {middle - 1, middle + 1};
  const double half = (0.5 + kAir) * size;
  return {middle - half, middle + half};
}

}  // namespace asperity
