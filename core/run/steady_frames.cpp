#include "core/run/steady_frames.h"

#include <algorithm>
#include <cmath>

#include "core/contact/dissipation.h"
#include "core/contact/scene_sliding.h"
#include "core/contact/unmet_balance.h"
#include "core/run/contact_age.h"
#include "core/scene/effects.h"
#include "core/surface/line_source.h"

namespace asperity {
namespace {

/// Points across a picture, at least, and of a line, at most: a frame's shift is rounded to one of
/// them.
constexpr double kPicturePoints = 8192, kMostPoints = 1 << 20;

SteadyState solve(const SceneSliding& sliding, const TravelLine& line, double velocity) {
  SteadyState state = sliding.at(line, velocity);
  requireBalance(state.result, velocity);
  return state;
}

void rotate(std::vector<double>& values, std::int64_t shift) {
  if (!values.empty()) std::rotate(values.begin(), values.end() - shift, values.end());
}

/// To an element. The paper's elements are shown as they are; a resolved line is drawn finely
/// enough to glide.
std::int64_t pointsToDraw(const Scene& scene, const LineSource& own, double seen) {
  if (scene.accuracy.scheme == Scheme::Nodal) return 1;
  const double pictures = seen > 0 ? std::max(own.length() / seen, 1.0) : 1;
  const double wanted = std::min(kPicturePoints * pictures, kMostPoints);
  return std::max<std::int64_t>(
      pointsPerElement(scene),
      std::llround(std::ceil(wanted / static_cast<double>(own.elements()))));
}

}  // namespace

SteadyFrames::SteadyFrames(std::shared_ptr<const Scene> scene, const FrameFields& fields,
                           double seen)
    : scene_(std::move(scene)) {
  const Accuracy& accuracy = scene_->accuracy;
  needSteadySliding(*scene_, "a picture of one shape");
  const SceneSliding sliding(*scene_);
  const double velocity = scene_->sliding.velocity;
  const LineSource own(*scene_, pointsPerElement(*scene_));
  result_ = solve(sliding, prepareTravel(own.make(0), accuracy.scheme), velocity).result;

  const std::int64_t finer = pointsToDraw(*scene_, own, seen);
  const LineSource source(*scene_, finer);
  const Line line = source.make(0);
  const TravelLine travel = prepareTravel(line, accuracy.scheme);
  const SteadyState shown = solve(sliding, travel, velocity);
  const SteadyShape whole = sliding.shape(travel, velocity, shown);
  const NodeShape& shape = whole.nodes;

  still_.scene = scene_;
  still_.length = line.length;
  still_.spacing = line.spacing;
  still_.surfaceHeight = inLineOrder(travel, shape.depth);
  still_.pressure = inLineOrder(travel, shape.pressure);
  for (double& height : still_.surfaceHeight) height = -height;
  for (const double height : line.height)
    still_.lineHeight.push_back(height - travel.lowestHeight - shown.result.indentation);
  still_.indentation = result_.indentation;
  still_.normalForce = result_.normalForce;
  still_.tangentialForce = result_.tangentialForce;
  still_.contactFraction = result_.contactFraction;
  still_.rmsHeight = line.rmsHeight;
  still_.rmsSlope = line.rmsSlope;
  still_.muSteady = result_.mu;
  still_.muInterface = result_.muInterface;
  still_.velocity = velocity;
  addFields(fields, line, travel, sliding, whole);
}

void SteadyFrames::addFields(const FrameFields& fields, const Line& line, const TravelLine& travel,
                             const SceneSliding& sliding, const SteadyShape& shape) {
  if (fields.lineSlope) still_.lineSlope = line.slopeAfter;
  if (fields.sinceContact)
    still_.sinceContact = steadyContactAge(still_.pressure, still_.spacing, still_.velocity);
  if (!fields.power) return;
  const RetardationModes modes = retardationModes(sliding.law());
  const std::size_t starts = shape.nodes.depth.size();
  std::vector<double> amplitudes(modes.modes() * starts);
  const bool one = shape.modes.empty();  // the depth itself
  for (std::size_t j = 0; j < modes.modes(); ++j)
    for (std::size_t i = 0; i < starts; ++i)
      amplitudes[j * starts + i] = one ? shape.nodes.depth[i] : shape.modes[i * modes.modes() + j];
  still_.power = inLineOrder(travel, dissipatedPower(modes, shape.nodes.pressure, amplitudes));
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
  const auto points = static_cast<double>(frame.lineHeight.size());
  const double part = periods - std::floor(periods);
  const auto shift =
      static_cast<std::int64_t>(std::llround(part * points)) % static_cast<std::int64_t>(points);
  frame.step = step;
  frame.distance = periods * frame.length;
  frame.time = velocity > 0 ? frame.distance / velocity : 0;
  frame.timeScale = timeScale;
  for (std::vector<double>* field : {&frame.lineHeight, &frame.surfaceHeight, &frame.pressure,
                                     &frame.lineSlope, &frame.sinceContact, &frame.power})
    rotate(*field, shift);
  return frame;
}

}  // namespace asperity
