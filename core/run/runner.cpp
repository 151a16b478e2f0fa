#include "core/run/runner.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <tuple>
#include <utility>

#include "core/accuracy/compute_curve.h"
#include "core/accuracy/target_curve.h"
#include "core/base/input_error.h"
#include "core/run/simulation.h"
#include "core/scene/motion.h"
#include "core/scene/sweep.h"

namespace asperity {

namespace {

/// Returns a number of the longer steps in a frame, near the usual one, with which the frames show
/// nearly equal numbers of the shorter steps, too. ratio: of the longer step to the shorter one.
double evenStepsPerFrame(double usual, double ratio) {
  constexpr double kEven = 0.1;  // part of the frames that may show another number
  const auto unevenness = [ratio](double steps) {
    return std::abs(steps * ratio - std::round(steps * ratio)) / (steps * ratio);
  };
  double best = usual;
  for (double away = 0; away <= usual && unevenness(best) > kEven; ++away)
    for (const double steps : {usual + away, usual - away})
      if (2 * steps >= usual && unevenness(steps) < unevenness(best)) best = steps;
  return best;
}

}  // namespace

double usualPace(const Sliding& sliding, double spacing) {
  if (sliding.kind == SlidingKind::Steady) return kDefaultPace;
  const Motion motion(sliding);
  double longer = motion.longestStep(), shorter = longer;
  if (spacing > 0)
    std::tie(shorter, longer) = std::minmax(
        {motion.stepAt(0, spacing, longer), motion.stepAt(motion.jump(), spacing, longer)});
  const RunnerOptions usual;
  const double steps = sliding.duration / longer;
  const double stepsPerFrame =
      evenStepsPerFrame(std::max(1.0, std::round(steps * usual.partPerFrame())), longer / shorter);
  return steps / stepsPerFrame * usual.secondsPerFrame();
}

void CurveRequests::post(const PostedScene& scene) {
  const bool isSame = requested_.scene &&
                      canonicalCurveScene(*scene.scene) == canonicalCurveScene(*requested_.scene);
  present_ = scene;
  updates_.clear();
  if (!isSame) {
    requested_ = scene;
    last_.reset();
    start();
  } else if (last_) {
    last_->scene = scene.scene;
    last_->sceneNumber = scene.number;
    updates_.push_back(*last_);
  }
}

void CurveRequests::stop() {
  isStopped_ = true;
  working_.request_stop();
}

void CurveRequests::start() {
  working_.request_stop();
  isStopped_ = false;
  ++number_;
}

CurveWork CurveRequests::begin() {
  working_ = std::stop_source();
  if (isStopped_) working_.request_stop();
  return {requested_, number_, working_.get_token()};
}

bool CurveRequests::offer(std::uint64_t number, const CurveUpdate& update) {
  if (number != number_) return false;
  last_ = update;
  last_->scene = present_.scene;
  last_->sceneNumber = present_.number;
  updates_.push_back(*last_);
  return true;
}

std::vector<CurveUpdate> CurveRequests::takeUpdates() {
  return std::exchange(updates_, {});
}

namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

struct Runner::Impl {
  explicit Impl(RunnerOptions wanted)
      : options(wanted),
        pace(wanted.secondsPerPeriod),
        marchThread([this](std::stop_token stop) { march(stop); }),
        curveThread([this](std::stop_token stop) { average(stop); }) {}

  ~Impl() {
    marchThread.request_stop();
    curveThread.request_stop();
    {
      const std::lock_guard guard(lock);
      curves.end();
    }
    changed.notify_all();
  }

  // ---- the march -------------------------------------------------------------------------------

  struct Commands {
    std::optional<PostedScene> scene;
    std::optional<FrameFields> fields;
    bool reset = false;
    bool play = false;
    std::vector<double> steps;   // each as a part of the period
    std::optional<double> seek;  // s, the moment to go to
    std::optional<double> pace;  // s on the screen for a period; none: the usual one
    bool any() const { return scene || fields || reset || seek || !steps.empty(); }
  };

  void march(std::stop_token stop) {
    std::optional<Simulation> simulation;
    Clock::time_point next = Clock::now();
    while (!stop.stop_requested()) {
      const Commands commands = takeCommands(stop, next, simulation.has_value());
      if (stop.stop_requested()) return;
      try {
        execute(commands, simulation, next);
      } catch (const std::exception& error) {
        report(commands.scene ? commands.scene->number : 0, error);
      }
    }
  }

  /// Waits for commands, or for the time of the next frame while playing.
  Commands takeCommands(std::stop_token stop, Clock::time_point next, bool running) {
    std::unique_lock guard(lock);
    const auto hasCommands = [this] { return pending.any(); };
    const auto moves = [&] { return running && playing && isVisible; };
    if (wantedMoment) {
      // Going to a moment does not wait.
    } else if (moves()) {
      changed.wait_until(guard, stop, next, hasCommands);
    } else {
      changed.wait(guard, stop, [&] { return hasCommands() || moves(); });
    }
    Commands commands = std::move(pending);
    pending = {};
    commands.play = playing && isVisible;
    commands.pace = pace;
    return commands;
  }

  void execute(const Commands& commands, std::optional<Simulation>& simulation,
               Clock::time_point& next) {
    if (commands.scene) {
      if (simulation)
        // While time is paused the old shape cannot relax.
        simulation->update(commands.scene->scene, commands.scene->number,
                           commands.play ? Simulation::Shape::Present : Simulation::Shape::Steady);
      else
        simulation.emplace(commands.scene->scene, commands.scene->number);
    }
    if (commands.fields) fields = *commands.fields;
    if (!simulation) return;
    if (commands.fields || commands.scene) simulation->requestFields(fields);
    if (commands.reset) simulation->reset();
    for (const double part : commands.steps) simulation->singleStep(part);
    const std::chrono::duration<double> interval(options.secondsPerFrame());
    const double part = interval.count() / commands.pace.value_or(usualPace(
                                               simulation->scene().sliding, simulation->spacing()));
    if (commands.scene || commands.reset || !commands.steps.empty()) wantedMoment.reset();
    if (commands.seek) wantedMoment = commands.seek;
    if (wantedMoment) {
      next = Clock::now() + std::chrono::duration_cast<Clock::duration>(interval);
      const double moment = *std::exchange(wantedMoment, {});  // an exception ends the seek
      bool isThere = false;
      while (!isThere && Clock::now() < next)
        isThere = simulation->seek(moment, part, interval.count());
      if (!isThere) wantedMoment = moment;
      publish(simulation->frame());
      return;
    }
    const bool due = commands.play && Clock::now() >= next;
    if (due) {
      simulation->advance(part, interval.count());
      next = std::max(next + std::chrono::duration_cast<Clock::duration>(interval), Clock::now());
    }
    if (due || commands.any()) publish(simulation->frame());
  }

  void publish(Frame&& frame) {
    auto shared = std::make_shared<const Frame>(std::move(frame));
    const std::lock_guard guard(lock);
    newest = std::move(shared);
  }

  // ---- the friction curve ----------------------------------------------------------------------

  void average(std::stop_token stop) {
    CurveWork work;
    while (true) {
      {
        std::unique_lock guard(lock);
        changed.wait(guard, stop, [&] { return curves.hasNewerThan(work.number); });
        if (stop.stop_requested()) return;
        work = curves.begin();
      }
      CurveOptions curveOptions{.threads = options.threads, .stop = work.stop};
      // What is read at the present velocity must not depend on the axis of the diagram.
      curveOptions.addsLogVelocities = true;
      run(work, curveOptions);
    }
  }

  /// Computes a curve and offers its states. Where the program chooses the number of lines it may
  /// need more of them at any time, so that only the last state is complete.
  void run(const CurveWork& work, CurveOptions& curveOptions) {
    const bool isPlanned = !choosesAccuracy(*work.scene.scene);
    CurveUpdate last;
    curveOptions.progress = [&](const CurveProgress& progress) {
      last.realizationsDone = progress.realizationsDone;
      last.realizationsTotal = progress.realizationsTotal;
      last.points = progress.points;
      last.isComplete = isPlanned && progress.realizationsDone == progress.realizationsTotal;
      offer(work.number, last);
    };
    try {
      Curve curve = computeCurve(*work.scene.scene, curveOptions);
      if (!curve.isComplete || last.isComplete) return;
      last.missedTarget = missedTarget(curve);
      last.points = std::move(curve.points);
      for (const CurvePoint& point : last.points)
        last.realizationsTotal = std::max(last.realizationsTotal, point.realizations);
      last.realizationsDone = last.realizationsTotal;
      last.isComplete = true;
      offer(work.number, last);
    } catch (const std::exception& error) {
      report(work.scene.number, error);
    }
  }

  void offer(std::uint64_t curve, const CurveUpdate& update) {
    {
      const std::lock_guard guard(lock);
      if (!curves.offer(curve, update)) return;
    }
    if (options.curveUpdated) options.curveUpdated();
  }

  /// Returns the number of the scene. It is called under the lock.
  std::uint64_t take(Scene&& scene) {
    present = {std::make_shared<const Scene>(std::move(scene)), present.number + 1};
    pending.scene = present;
    curves.post(present);
    changed.notify_all();
    return present.number;
  }

  /// Adds a message about an error. Only an error in the scene names a key.
  void report(std::uint64_t number, const std::exception& error) {
    const auto* ofInput = dynamic_cast<const InputError*>(&error);
    const std::lock_guard guard(lock);
    messages.push_back(ofInput ? RunnerMessage{number, ofInput->key(), ofInput->message()}
                               : RunnerMessage{number, "", errorMessage(error)});
  }

  const RunnerOptions options;
  FrameFields fields;                  // this and the next are used by the march only
  std::optional<double> wantedMoment;  // s, of a motion, on the way to it
  std::mutex lock;  // protects everything down to the threads; never held while computing
  std::condition_variable_any changed;
  bool playing = true;
  bool isVisible = true;
  std::optional<double> pace;  // s on the screen for a period; none: the usual one
  Commands pending;
  PostedScene present;
  std::shared_ptr<const Frame> newest;
  CurveRequests curves;
  std::vector<RunnerMessage> messages;
  std::jthread marchThread, curveThread;  // last: they use all members above
};

Runner::Runner(RunnerOptions options) : impl_(std::make_unique<Impl>(options)) {}
Runner::~Runner() = default;

std::uint64_t Runner::post(Scene scene) {
  const std::lock_guard guard(impl_->lock);
  return impl_->take(std::move(scene));
}

std::uint64_t Runner::open(Scene scene) {
  const std::lock_guard guard(impl_->lock);
  impl_->pending.reset = true;  // carried out together with the scene
  return impl_->take(std::move(scene));
}

void Runner::requestFields(const FrameFields& fields) {
  const std::lock_guard guard(impl_->lock);
  impl_->pending.fields = fields;
  impl_->changed.notify_all();
}

void Runner::play() {
  const std::lock_guard guard(impl_->lock);
  impl_->playing = true;
  impl_->changed.notify_all();
}

void Runner::pause() {
  const std::lock_guard guard(impl_->lock);
  impl_->playing = false;
}

bool Runner::isPlaying() const {
  const std::lock_guard guard(impl_->lock);
  return impl_->playing;
}

void Runner::singleStep(double part) {
  const std::lock_guard guard(impl_->lock);
  impl_->pending.steps.push_back(part);
  impl_->changed.notify_all();
}

void Runner::setPace(std::optional<double> secondsPerPeriod) {
  const std::lock_guard guard(impl_->lock);
  impl_->pace = secondsPerPeriod;
}

void Runner::seek(double time) {
  const std::lock_guard guard(impl_->lock);
  impl_->pending.seek = time;
  impl_->changed.notify_all();
}

void Runner::setVisible(bool seen) {
  const std::lock_guard guard(impl_->lock);
  impl_->isVisible = seen;
  impl_->changed.notify_all();
}

void Runner::reset() {
  const std::lock_guard guard(impl_->lock);
  impl_->pending.reset = true;
  impl_->changed.notify_all();
}

void Runner::stopCurve() {
  const std::lock_guard guard(impl_->lock);
  impl_->curves.stop();
}

void Runner::startCurve() {
  const std::lock_guard guard(impl_->lock);
  impl_->curves.start();
  impl_->changed.notify_all();
}

std::shared_ptr<const Frame> Runner::newestFrame() const {
  const std::lock_guard guard(impl_->lock);
  return impl_->newest;
}

std::vector<CurveUpdate> Runner::takeCurveUpdates() {
  const std::lock_guard guard(impl_->lock);
  return impl_->curves.takeUpdates();
}

std::vector<RunnerMessage> Runner::takeMessages() {
  const std::lock_guard guard(impl_->lock);
  return std::exchange(impl_->messages, {});
}

}  // namespace asperity
