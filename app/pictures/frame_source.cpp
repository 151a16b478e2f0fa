#include "app/pictures/frame_source.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/run/runner.h"

namespace asperity {
namespace {

constexpr double kMaxFrames = 1e6;
constexpr std::int64_t kSamples = 200;   // minimum number of samples over a motion
constexpr double kMaxSlidPeriods = 1e9;  // maximum distance of sliding, in periods

double chosenFramesPerSecond(const TimeArguments& arguments) {
  return arguments.framesPerSecond > 0 ? arguments.framesPerSecond : kDefaultFramesPerSecond;
}

std::int64_t rounded(double frames, const char* option) {
  if (!(frames <= kMaxFrames))
    throw InputError(
        "", option,
        message("{} frames are more than {}", printedNumber(frames), printedNumber(kMaxFrames)));
  return std::max<std::int64_t>(1, std::llround(frames));
}

void checkTogether(const TimeArguments& arguments) {
  if (arguments.frames > 0 && arguments.duration > 0)
    throw InputError("", "--duration",
                     "cannot be combined with --frames: both set the length of the film");
  if (arguments.at && arguments.slid)
    throw InputError("", "--slid", "cannot be combined with --at: both set the moment");
  const bool length = arguments.frames > 0 || arguments.duration > 0;
  if (arguments.slowMotion > 0 && arguments.cycles > 0 && length)
    throw InputError("", "--slow-motion", "follows from the cycles and the length of the film");
}

void checkMoment(const Scene& scene, const TimeArguments& arguments, double length, bool single) {
  const char* option = arguments.at ? "--at" : "--slid";
  if (!arguments.at && !arguments.slid) return;
  if (!single) throw InputError("", option, "shows one moment; frames and films have many");
  const bool isSteady = scene.sliding.kind == SlidingKind::Steady;
  if (arguments.slid && !isSteady)
    throw InputError("", "--slid", "belongs to steady sliding; a motion has --at");
  if (!isSteady && *arguments.at > scene.sliding.duration)
    throw InputError(
        "", "--at",
        message("{} is after the motion's end at {}", printedQuantity(*arguments.at, "s", 6),
                printedQuantity(scene.sliding.duration, "s", 6)));
  if (!isSteady) return;
  const double slid = arguments.slid ? *arguments.slid : *arguments.at * scene.sliding.velocity;
  if (!(std::abs(slid) <= kMaxSlidPeriods * length))
    throw InputError("", option,
                     message("{} slid are more than {} periods", printedQuantity(slid, "m"),
                             printedNumber(kMaxSlidPeriods)));
}

FramePlan steadyPlan(double period, const TimeArguments& arguments, bool single) {
  FramePlan plan;
  const double cycles = arguments.cycles > 0 ? arguments.cycles : 1;
  const double fps = chosenFramesPerSecond(arguments);
  if (arguments.frames > 0 || arguments.duration > 0)
    plan.count =
        arguments.frames > 0 ? arguments.frames : rounded(arguments.duration * fps, "--duration");
  else if (arguments.slowMotion > 0)
    plan.count =
        single ? 1 : rounded(cycles * period * arguments.slowMotion * fps, "--slow-motion");
  else
    plan.count = single ? 1 : rounded(cycles * kDefaultFrames, "--cycles");
  plan.periodsPerFrame = arguments.slowMotion > 0 ? 1 / (arguments.slowMotion * fps * period)
                                                  : cycles / static_cast<double>(plan.count);
  return plan;
}

FramePlan motionPlan(double duration, const TimeArguments& arguments, bool single) {
  if (arguments.cycles > 0)
    throw InputError("", "--cycles", "belongs to steady sliding; a motion has its duration");
  if (arguments.slowMotion > 0 && (arguments.frames > 0 || arguments.duration > 0))
    throw InputError("", "--slow-motion", "follows from the motion and the length of the film");
  FramePlan plan;
  const double fps = chosenFramesPerSecond(arguments);
  plan.count = single                   ? 1
               : arguments.frames > 0   ? arguments.frames
               : arguments.duration > 0 ? rounded(arguments.duration * fps, "--duration")
               : arguments.slowMotion > 0
                   ? rounded(duration * arguments.slowMotion * fps, "--slow-motion")
                   : kDefaultFrames;
  if (plan.count > 1) plan.timeScale = duration * fps / static_cast<double>(plan.count - 1);
  return plan;
}

/// Plans the frames. single: one picture is requested. length: of the period, m. Throws InputError.
FramePlan planFrames(const Scene& scene, double length, const TimeArguments& arguments,
                     bool single) {
  checkTogether(arguments);
  const double velocity = std::abs(scene.sliding.velocity);
  FramePlan plan;
  if (scene.sliding.kind != SlidingKind::Steady) {
    plan = motionPlan(scene.sliding.duration, arguments, single);
  } else {
    if (!(velocity > 0) && arguments.slowMotion > 0)
      throw InputError("", "--slow-motion", "needs a velocity above 0");
    plan = steadyPlan(velocity > 0 ? length / velocity : 0, arguments, single);
    if (plan.count > 1 && velocity > 0)
      plan.timeScale = plan.periodsPerFrame * length / velocity * chosenFramesPerSecond(arguments);
  }
  plan.framesPerSecond = chosenFramesPerSecond(arguments);
  return plan;
}

}  // namespace

FrameSource::FrameSource(const Scene& scene, const TimeArguments& arguments, bool single,
                         const FrameFields& fields, double visibleLength)
    : arguments_(arguments), sliding_(scene.sliding) {
  const auto shared = std::make_shared<const Scene>(scene);
  if (scene.sliding.kind == SlidingKind::Steady)
    steady_.emplace(shared, fields, visibleLength);
  else
    motion_
        .emplace(shared, 0,
                 single ? Simulation::kStepsPerFrame : std::numeric_limits<double>::infinity())
        .requestFields(fields);
  if (steady_) {
    length_ = steady_->length();
  } else {
    const Frame first = motion_->frame();
    length_ = first.length;
    spacing_ = first.spacing;
  }
  checkMoment(scene, arguments, length_, single);
  plan_ = planFrames(scene, length_, arguments, single);
}

Frame FrameSource::steadyFrame(std::int64_t index) const {
  if (!arguments_.at && !arguments_.slid)
    return steady_->frameAt(static_cast<double>(index) * plan_.periodsPerFrame, plan_.timeScale,
                            static_cast<std::uint64_t>(index));
  const double slid = arguments_.slid ? *arguments_.slid : *arguments_.at * sliding_.velocity;
  Frame frame = steady_->frameAt(slid / steady_->length(), 0, 0);
  frame.distance = slid;  // exact to the last digit
  if (arguments_.at) frame.time = *arguments_.at;
  return frame;
}

/// Returns the frame of a motion at the present time, as the window shows it.
Frame FrameSource::momentFrame() {
  const RunnerOptions window{.secondsPerPeriod = usualPace(sliding_, spacing_)};
  motion_->advanceTo(arguments_.at.value_or(sliding_.duration), window.partPerFrame(),
                     window.secondsPerFrame());
  Frame frame = motion_->frame();
  frame.timeScale = 0;
  return frame;
}

Frame FrameSource::frame(std::int64_t index) {
  if (steady_) return steadyFrame(index);
  if (plan_.count == 1) return momentFrame();
  const std::int64_t intervals = plan_.count - 1;
  const std::int64_t parts = (kSamples + intervals - 1) / intervals;  // parts of an interval
  const std::int64_t target = index * parts;
  while (advanced_ < target) {
    // Whole steps end before the part does; the next part makes up for it.
    ++advanced_;
    motion_->advanceTo(
        sliding_.duration * static_cast<double>(advanced_) / static_cast<double>(intervals * parts),
        1, 1 / plan_.framesPerSecond);
  }
  Frame frame = motion_->frame();
  frame.timeScale = plan_.timeScale;
  return frame;
}

}  // namespace asperity
