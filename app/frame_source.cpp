#include "app/frame_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/scene/input_error.h"

namespace asperity {
namespace {

constexpr std::int64_t kUsualFrames = 60;
constexpr double kUsualFps = 25;
constexpr double kMostFrames = 1e6;
constexpr std::int64_t kSamples = 200;  // over a motion, at least

double fpsOf(const TimeChoice& choice) {
  return choice.framesPerSecond > 0 ? choice.framesPerSecond : kUsualFps;
}

std::int64_t rounded(double frames, const char* option) {
  if (!(frames <= kMostFrames))
    throw InputError("", option,
                     fmt::format("{:.3g} frames are more than {:g}", frames, kMostFrames));
  return std::max<std::int64_t>(1, std::llround(frames));
}

void checkTogether(const TimeChoice& choice) {
  if (choice.frames > 0 && choice.duration > 0)
    throw InputError("", "--duration",
                     "and --frames both say how long the film is; one of them is enough");
  const bool length = choice.frames > 0 || choice.duration > 0;
  if (choice.slowMotion > 0 && choice.cycles > 0 && length)
    throw InputError("", "--slow-motion", "follows from the cycles and the length of the film");
}

FramePlan steadyPlan(double period, const TimeChoice& choice, bool single) {
  FramePlan plan;
  const double cycles = choice.cycles > 0 ? choice.cycles : 1;
  const double fps = fpsOf(choice);
  if (choice.frames > 0 || choice.duration > 0)
    plan.count = choice.frames > 0 ? choice.frames : rounded(choice.duration * fps, "--duration");
  else if (choice.slowMotion > 0)
    plan.count = single ? 1 : rounded(cycles * period * choice.slowMotion * fps, "--slow-motion");
  else
    plan.count = single ? 1 : rounded(cycles * kUsualFrames, "--cycles");
  plan.periodsPerFrame = choice.slowMotion > 0 ? 1 / (choice.slowMotion * fps * period)
                                               : cycles / static_cast<double>(plan.count);
  return plan;
}

FramePlan motionPlan(double duration, const TimeChoice& choice, bool single) {
  if (choice.cycles > 0)
    throw InputError("", "--cycles", "belongs to steady sliding; a motion has its duration");
  if (choice.slowMotion > 0 && (choice.frames > 0 || choice.duration > 0))
    throw InputError("", "--slow-motion", "follows from the motion and the length of the film");
  FramePlan plan;
  const double fps = fpsOf(choice);
  plan.count = single                ? 1
               : choice.frames > 0   ? choice.frames
               : choice.duration > 0 ? rounded(choice.duration * fps, "--duration")
               : choice.slowMotion > 0
                   ? rounded(duration * choice.slowMotion * fps, "--slow-motion")
                   : kUsualFrames;
  if (plan.count > 1) plan.timeScale = duration * fps / static_cast<double>(plan.count - 1);
  return plan;
}

}  // namespace

FramePlan planFrames(const Scene& scene, double length, const TimeChoice& choice, bool single) {
  checkTogether(choice);
  const double velocity = std::abs(scene.sliding.velocity);
  FramePlan plan;
  if (scene.sliding.kind != SlidingKind::Steady) {
    plan = motionPlan(scene.sliding.duration, choice, single);
  } else {
    if (!(velocity > 0) && choice.slowMotion > 0)
      throw InputError("", "--slow-motion", "needs a velocity above 0");
    plan = steadyPlan(velocity > 0 ? length / velocity : 0, choice, single);
    if (plan.count > 1 && velocity > 0)
      plan.timeScale = plan.periodsPerFrame * length / velocity * fpsOf(choice);
  }
  plan.framesPerSecond = fpsOf(choice);
  return plan;
}

FrameSource::FrameSource(const Scene& scene, const TimeChoice& choice, bool single,
                         const FrameFields& fields)
    : duration_(scene.sliding.duration) {
  const auto shared = std::make_shared<const Scene>(scene);
  if (scene.sliding.kind == SlidingKind::Steady)
    steady_.emplace(shared, fields);
  else
    motion_.emplace(shared, 0, std::numeric_limits<double>::infinity()).want(fields);
  plan_ = planFrames(scene, steady_ ? steady_->length() : 0, choice, single);
}

Frame FrameSource::frame(std::int64_t index) {
  if (steady_)
    return steady_->frameAt(static_cast<double>(index) * plan_.periodsPerFrame, plan_.timeScale,
                            static_cast<std::uint64_t>(index));
  const std::int64_t intervals = std::max<std::int64_t>(plan_.count - 1, 1);
  const std::int64_t parts = (kSamples + intervals - 1) / intervals;  // of an interval
  const std::int64_t target = (plan_.count == 1 ? 1 : index) * parts;
  while (advanced_ < target) {
    // Whole steps fall short of a part: the next one makes up for it.
    ++advanced_;
    const double due = static_cast<double>(advanced_) / static_cast<double>(intervals * parts);
    const double part = due - motion_->frame().time / duration_;
    if (part > 0) motion_->advance(part, 1 / plan_.framesPerSecond);
  }
  Frame frame = motion_->frame();
  frame.timeScale = plan_.timeScale;
  return frame;
}

}  // namespace asperity
