#include "core/run/steady_frames.h"

#include <algorithm>
#include <cmath>

#include "core/contact/march/time_march.h"
#include "core/contact/steady_sliding.h"
#include "core/scene/scene_check.h"
#include "core/surface/line_source.h"

namespace asperity {
namespace {

/// Minimum number of points across a picture, and maximum of a line: a frame's shift is rounded to
/// one of them.
constexpr double kPicturePoints = 8192, kMaxPoints = 1 << 20;

SteadyState solve(const SteadySolver& sliding, const PreparedProfile& line, double velocity) {
  SteadyState state = sliding.at(line, velocity);
  requireBalance(state.result, velocity);
  return state;
}

void rotate(std::vector<double>& values, std::int64_t shift) {
  if (!values.empty()) std::rotate(values.begin(), values.end() - shift, values.end());
}

/// Returns the power in the dashpots at the shape's points, W/m, in order of travel.
std::vector<double> steadyPower(const SteadySolver& sliding, const SteadyShape& shape) {
  const RetardationModes modes = retardationModes(sliding.law());
  const std::size_t starts = shape.nodes.depth.size();
  std::vector<double> amplitudes(modes.modes() * starts);
  const bool one = shape.modes.empty();  // the depth itself is the only mode
  for (std::size_t j = 0; j < modes.modes(); ++j)
    for (std::size_t i = 0; i < starts; ++i)
      amplitudes[j * starts + i] = one ? shape.nodes.depth[i] : shape.modes[i * modes.modes() + j];
  return dissipatedPower(modes, shape.nodes.pressure, amplitudes);
}

/// Returns the points per element. The paper's elements are drawn as they are; a resolved line is
/// drawn finely enough to move smoothly.
std::int64_t pointsToDraw(const Scene& scene, const LineSource& own, double seen) {
  if (scene.accuracy.scheme == Scheme::Nodal) return 1;
  const double pictures = seen > 0 ? std::max(own.length() / seen, 1.0) : 1;
  const double wanted = std::min(kPicturePoints * pictures, kMaxPoints);
  return std::max<std::int64_t>(
      pointsPerElement(scene),
      std::llround(std::ceil(wanted / static_cast<double>(own.elements()))));
}

}  // namespace

double greatestPressure(const SteadyShape& shape, double spacing, double normalForce) {
  constexpr double kMin = 0.1;  // of the normal force
  const std::vector<double>& pressure = shape.nodes.pressure;
  return asperity::normalForce(pressure, spacing) < kMin * normalForce ? kNotApplicable
                                                                       : std::ranges::max(pressure);
}

Frame stillFrame(std::shared_ptr<const Scene> scene, const RigidLine& rigid,
                 const SteadySolver& sliding, const SteadyState& shown, const SteadyResult& facts,
                 const FrameFields& fields) {
  const Line& line = *rigid.line;
  const PreparedProfile& profile = rigid.prepared;
  const double velocity = scene->sliding.velocity;
  const SteadyShape shape = sliding.shape(profile, velocity, shown);
  Frame frame;
  frame.scene = std::move(scene);
  frame.length = line.length;
  frame.elements = rigid.elements;
  frame.spacing = line.spacing;
  frame.surfaceHeight = inLineOrder(profile, shape.nodes.depth);
  frame.pressure = inLineOrder(profile, shape.nodes.pressure);
  for (double& height : frame.surfaceHeight) height = -height;
  for (const double height : line.height)
    frame.lineHeight.push_back(height - profile.lowestHeight - shown.result.indentation);
  frame.state = facts;
  frame.steadyPressure = greatestPressure(shape, line.spacing, shown.result.normalForce);
  frame.rmsHeight = line.rmsHeight;
  frame.rmsSlope = line.rmsSlope;
  frame.velocity = velocity;
  if (fields.lineSlope) {
    // This is the line's slope on the side from which a point is met, as in the pass: a corner has
    // two.
    frame.lineSlope = inLineOrder(profile, profile.slopeIn);
    for (double& slope : frame.lineSlope) slope = -slope;
  }
  if (fields.sinceContact)
    frame.sinceContact = steadyContactAge(frame.pressure, frame.spacing, velocity);
  if (fields.power) {
    frame.power = inLineOrder(profile, steadyPower(sliding, shape));
    addLocalFriction(frame.power, frame.pressure, interfaceAt(*frame.scene, velocity), velocity);
  }
  return frame;
}

void moveByPoints(Frame& frame, std::int64_t points) {
  const auto count = static_cast<std::int64_t>(frame.lineHeight.size());
  const std::int64_t shift = (points % count + count) % count;
  for (std::vector<double>* field : {&frame.lineHeight, &frame.surfaceHeight, &frame.pressure,
                                     &frame.lineSlope, &frame.sinceContact, &frame.power})
    rotate(*field, shift);
}

SteadyFrames::SteadyFrames(std::shared_ptr<const Scene> scene, const FrameFields& fields,
                           double seen)
    : scene_(std::move(scene)) {
  const Accuracy& accuracy = scene_->accuracy;
  requireSteadySliding(*scene_, "a picture of one shape");
  const SteadySolver sliding(*scene_);
  const double velocity = scene_->sliding.velocity;
  const LineSource own(*scene_, pointsPerElement(*scene_));
  result_ = solve(sliding, prepareProfile(own.make(0), accuracy.scheme), velocity).result;
  const RigidLine drawn = RigidLine::withPoints(*scene_, pointsToDraw(*scene_, own, seen));
  const SteadyState shown = solve(sliding, drawn.prepared, velocity);
  still_ = stillFrame(scene_, drawn, sliding, shown, result_, fields);
}

Frame SteadyFrames::frame(std::int64_t index, std::int64_t count, double framesPerSecond) const {
  const double velocity = scene_->sliding.velocity;
  const bool moves = count > 1 && velocity > 0;
  const double timeScale =
      moves ? still_.length / velocity / static_cast<double>(count) * framesPerSecond : 0;
  return frameAt(static_cast<double>(index) / static_cast<double>(count), timeScale,
                 static_cast<std::uint64_t>(index));
}

Frame SteadyFrames::frameAt(double periods, double timeScale, std::uint64_t step) const {
  Frame frame = still_;
  const double velocity = scene_->sliding.velocity;
  const double part = periods - std::floor(periods);
  moveByPoints(frame, std::llround(part * static_cast<double>(frame.lineHeight.size())));
  frame.step = step;
  frame.distance = periods * frame.length;
  frame.time = velocity > 0 ? frame.distance / velocity : 0;
  frame.timeScale = timeScale;
  return frame;
}

}  // namespace asperity
