#include "core/run/simulation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/surface/line_source.h"

namespace asperity {
namespace {

/// Element-steps spent on one frame, at most: counted, so that frames do not depend on a clock.
constexpr double kStepsPerFrame = 4e5;

}  // namespace

/// The rigid line, made once for as long as scenes agree on it.
struct Simulation::Rigid {
  explicit Rigid(const Scene& scene)
      : line(std::make_shared<Line>(LineSource(scene, pointsPerElement(scene)).make(0))),
        travel(prepareTravel(*line, scene.accuracy.scheme)) {}

  std::shared_ptr<const Line> line;
  TravelLine travel;
};

struct Simulation::Ready {
  Ready(std::shared_ptr<const Scene> wanted, std::uint64_t itsNumber, const Ready* last)
      : scene(std::move(wanted)),
        number(itsNumber),
        rigid(last && last->scene->surface == scene->surface &&
                      last->scene->accuracy == scene->accuracy &&
                      last->scene->folder == scene->folder
                  ? last->rigid
                  : std::make_shared<Rigid>(*scene)),
        conditions(conditionsOf(*scene, scene->sliding.velocity)),
        steady(slideAtLoad(rigid->travel, conditions, scene->load)) {
    if (steady.status != SteadyStatus::Balanced || !std::isfinite(steady.mu))
      throw std::runtime_error("no indentation carries the normal force to working accuracy");
  }

  const Line& line() const { return *rigid->line; }
  MarchConditions marchConditions() const {
    return {conditions.shearModulus, conditions.relaxationTime, scene->load.kind,
            scene->load.normalForce, scene->load.depth};
  }

  std::shared_ptr<const Scene> scene;
  std::uint64_t number;
  std::shared_ptr<const Rigid> rigid;
  SlidingConditions conditions;
  SteadyResult steady;
};

Simulation::Simulation(std::shared_ptr<const Scene> scene, std::uint64_t number)
    : ready_(std::make_shared<Ready>(std::move(scene), number, nullptr)) {
  reset();
}

void Simulation::update(std::shared_ptr<const Scene> scene, std::uint64_t number, Shape shape) {
  const auto next = std::make_shared<Ready>(std::move(scene), number, ready_.get());
  const bool sameElements = next->line().nodes() == ready_->line().nodes() &&
                            next->line().length == ready_->line().length;
  ready_ = next;
  if (!sameElements) return reset();
  if (shape == Shape::Steady) return settle(march_->distance());
  TimeMarch march(ready_->rigid->line, ready_->rigid->travel.lowestHeight);
  march.setState(march_->depth(), march_->indentation());
  march.setDistance(march_->distance());
  march.setPressure(march_->pressure());
  march_ = std::move(march);
  clearReading();
}

void Simulation::reset() {
  settle(0);
  steps_ = 0;
  time_ = 0;
}

/// The steady state, with the line moved to the node nearest to this distance.
void Simulation::settle(double distance) {
  const TravelLine& travel = ready_->rigid->travel;
  const Line& line = ready_->line();
  const NodeShape shape = shapeAt(travel, ready_->conditions, ready_->steady.indentation);
  std::vector<double> depth = inLineOrder(travel, shape.depth);
  std::vector<double> pressure = inLineOrder(travel, shape.pressure);
  for (double& p : pressure) p *= 4 * ready_->conditions.shearModulus;
  const auto moved =
      static_cast<std::ptrdiff_t>(std::llround(std::fmod(distance, line.length) / line.spacing));
  const std::ptrdiff_t shift = moved % static_cast<std::ptrdiff_t>(line.nodes());
  std::rotate(depth.begin(), depth.end() - shift, depth.end());
  std::rotate(pressure.begin(), pressure.end() - shift, pressure.end());
  march_.emplace(ready_->rigid->line, travel.lowestHeight);
  march_->setState(depth, ready_->steady.indentation);
  march_->setPressure(pressure);
  march_->setDistance(line.spacing * static_cast<double>(shift) +
                      line.length * std::floor(distance / line.length));
  timeScale_ = 0;
  clearReading();
}

void Simulation::clearReading() {
  lineWork_ = normalWork_ = 0;
  resolves_ = false;
}

/// The line moves by one node at most, and by less where that resolves the relaxation.
double Simulation::naturalStep() const {
  const double memory = ready_->conditions.velocity * ready_->conditions.relaxationTime;
  const double spacing = ready_->line().spacing;
  return memory > 0 ? std::clamp(memory / 2, spacing / 8, spacing) : spacing;
}

void Simulation::stepOnce(double dt, double distance) {
  last_ = march_->step(ready_->marchConditions(), dt, distance);
  lineWork_ += last_.lineWork;
  normalWork_ += last_.normalForce * distance;
  resolves_ = distance > 0 &&
              distance <= 2 * ready_->conditions.velocity * ready_->conditions.relaxationTime;
  time_ += dt;
  ++steps_;
}

void Simulation::advance(double part, double wallSeconds) {
  clearReading();
  const double velocity = ready_->conditions.velocity;
  const double before = time_;
  if (velocity > 0) {
    const double most =
        std::max(1.0, std::floor(kStepsPerFrame / static_cast<double>(ready_->line().nodes())));
    const double wanted = part * ready_->line().length;
    const double finest = std::ceil(wanted / naturalStep());
    // Where the budget binds, steps grow up to one node; only then the line slows down.
    const double steps = std::min(finest, most);
    const double distance = std::min(wanted / steps, ready_->line().spacing);
    for (double i = 0; i < steps; ++i) stepOnce(distance / velocity, distance);
  } else {
    const double rest = std::max(ready_->conditions.relaxationTime, 1e-6) / 30;
    stepOnce(rest, 0);
  }
  timeScale_ = (time_ - before) / wallSeconds;
}

void Simulation::singleStep() {
  clearReading();
  const double velocity = ready_->conditions.velocity;
  if (velocity > 0)
    stepOnce(naturalStep() / velocity, naturalStep());
  else
    stepOnce(std::max(ready_->conditions.relaxationTime, 1e-6) / 30, 0);
}

Frame Simulation::frame() const {
  Frame frame;
  frame.scene = ready_->scene;
  frame.sceneNumber = ready_->number;
  frame.step = steps_;
  frame.time = time_;
  frame.distance = march_->distance();
  frame.timeScale = timeScale_;
  frame.length = ready_->line().length;
  frame.spacing = ready_->line().spacing;
  frame.pressure = march_->pressure();
  for (const double depth : march_->depth()) frame.surfaceHeight.push_back(-depth);
  for (const double rise : march_->rise()) frame.lineHeight.push_back(rise - march_->indentation());
  // All facts are those of the steady state, as everywhere else; the march adds its own reading.
  const SteadyResult& steady = ready_->steady;
  frame.indentation = steady.indentation;
  frame.normalForce = steady.normalForce;
  frame.tangentialForce = steady.tangentialForce;
  frame.contactFraction = steady.contactFraction;
  frame.muSteady = steady.mu;
  frame.rmsHeight = ready_->line().rmsHeight;
  frame.rmsSlope = ready_->line().rmsSlope;
  if (resolves_ && normalWork_ > 0) frame.muMarch = lineWork_ / normalWork_;
  return frame;
}

}  // namespace asperity
