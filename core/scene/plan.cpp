#include "core/scene/plan.h"

#include <atomic>

#include "core/base/number_text.h"
#include "core/material/temperature_shift.h"
#include "core/scene/scene_check.h"

namespace asperity {
namespace {

constexpr std::array<std::string_view, kStages> kNames{
    "line",          "roll-off",        "summit correlation", "temperature shift", "free surface",
    "arms",          "start from rest", "steady pass",        "contact search",    "periodicity",
    "force balance", "time march",      "interface friction", "velocity sweep",    "averaging",
    "stored shape"};

bool hasElastomer(Purpose purpose) {
  return purpose != Purpose::Surface;
}

/// Returns whether sliding is steady; a curve is so at every velocity, whatever the motion of the
/// scene.
bool isSteady(const Scene& scene, Purpose purpose) {
  return purpose == Purpose::Curve || scene.sliding.kind == SlidingKind::Steady;
}

/// Returns whether the scene states the spectrum of its waves.
bool isSelfAffine(const Scene& scene) {
  return scene.surface.kind == SurfaceKind::SelfAffine;
}

/// Returns whether results are averaged. The scene states the number of lines, except for rows,
/// whose number is in their file.
bool isAveraged(const Scene& scene) {
  return mayHaveManyLines(scene.surface) && scene.ensemble.realizations != 1;
}

/// Returns whether the steady state is needed: for steady sliding, and as the beginning of other
/// motions except those from rest.
bool hasSteadyState(const Scene& scene, Purpose purpose) {
  return isSteady(scene, purpose) ||
         (scene.sliding.kind != SlidingKind::Start && scene.sliding.velocity > 0);
}

/// Returns how a measured surface becomes a line.
Message whyMeasured(const Surface& surface) {
  const bool isEquivalent = surface.line == LineKind::IsotropicEquivalent;
  const Message line = isEquivalent
                           ? Message(
                                 "the isotropic equivalent, C = \u03C0 q C\u2082, of the measured "
                                 "surface")
                           : Message("the measured surface as it is along the sliding");
  const Message side = surface.contactSide == ContactSide::Summits ? Message("its summits touch")
                                                                   : Message("its valleys touch");
  switch (surface.processing.seam) {
    case Seam::Mirror:
      return message("{}; {}; mirrored, so that the period is twice the file's", line, side);
    case Seam::Blend:
      return message("{}; {}; its end is blended into its beginning", line, side);
    case Seam::RandomPhases:
      return message("{}; its spectrum with random phases", line);
    default:
      return message("{}; {}; repeated as it is", line, side);
  }
}

Message whyLine(const Scene& scene, bool) {
  switch (scene.surface.kind) {
    case SurfaceKind::SelfAffine:
      return "waves of a self-affine spectrum with random phases are summed";
    case SurfaceKind::Measured:
      return whyMeasured(scene.surface);
    case SurfaceKind::Spectrum:
      return "waves of the file's spectrum with random phases are summed";
    case SurfaceKind::Profile:
      return "the profile is read and taken as one period of a band-limited line";
    default:
      return "the line is given by a formula";
  }
}

Message whyRollOff(const Scene& scene, bool runs) {
  if (runs)
    return message("waves longer than {} are all equally strong",
                   printed(scene.surface.rollOffWavelength, "m"));
  if (!isSelfAffine(scene)) return "the line has no spectrum of its own";
  return scene.surface.rollOffWavelength > 0 ? "no wave of the line is longer than the roll-off"
                                             : "the spectrum is self-affine up to the whole period";
}

Message whySummits(const Scene& scene, bool runs) {
  const double kappa = scene.surface.summitCorrelation;
  if (runs)
    return kappa > 0 ? message("short waves are stronger on the summits, kappa = {}", kappa)
                     : message("short waves are stronger in the valleys, kappa = {}", kappa);
  return isSelfAffine(scene) ? "phases alone are random: summits are as rough as valleys"
                             : "the line is not random";
}

Message whyShift(const Scene& scene, bool runs) {
  const Elastomer& elastomer = scene.elastomer;
  if (runs)
    return message("at {} K all relaxation times are {:.4g} times as long", elastomer.temperature,
                   shiftFactor(elastomer.shift, elastomer.temperature));
  return elementLaw(elastomer).kind() == ElementKind::Elastic
             ? "nothing relaxes"
             : "the elastomer is at its reference temperature";
}

Message whyFreeSurface(const Scene& scene, bool runs) {
  if (!runs) return "the elastomer is elastic and responds at once";
  return elementLaw(scene.elastomer).kind() == ElementKind::Kelvin
             ? "a free surface recovers with one relaxation time"
             : "a free surface recovers with several relaxation times";
}

Message whyArms(const Scene& scene, bool runs) {
  const std::size_t arms = elementLaw(scene.elastomer).arms.size();
  if (runs)
    return arms == 1 ? Message("1 internal variable an element")
                     : message("{} internal variables an element", arms);
  return hasArms(scene.elastomer.rheology) ? "no arm has strength and time"
                                           : "the elastomer has none";
}

Message whyStart(const Scene&, bool runs) {
  return runs ? "the line is pressed in at v = 0 and everything has relaxed"
              : "the motion does not begin from rest";
}

Message whySteadyPass(const Scene& scene, bool runs) {
  if (!runs) return "the motion begins at v = 0, where nothing slides";
  if (scene.sliding.kind == SlidingKind::Steady)
    return "steady sliding is stationary in the line's frame";
  return scene.sliding.kind == SlidingKind::Start || scene.sliding.velocity == 0
             ? "the friction curve is of steady sliding"
             : "the steady state at the first velocity is where the motion begins";
}

Message whySearch(const Scene& scene, bool runs) {
  if (!runs) return "nothing slides steadily";
  return scene.accuracy.scheme == Scheme::Nodal
             ? "whether an element touches is asked at each node"
             : "edges of contact are found inside the segments wherever contact is not complete";
}

Message whyPeriodicity(const Scene& scene, bool runs) {
  if (runs) return "arms must be after a period as they were before";
  return elementLaw(scene.elastomer).arms.empty()
             ? "the lowest point is always in contact: the period closes in one pass"
             : "there is no steady state";
}

constexpr int kGivenDigits = 6;  // of a value that a user gave

Message whyBalance(const Scene& scene, bool runs) {
  if (!runs) return "the indentation is given";
  if (scene.load.kind == LoadKind::Force)
    return message("the indentation that carries {} is sought",
                   printed(scene.load.normalForce, "N", kGivenDigits));
  return scene.load.width > 0
             ? message(
                   "the indentation that carries {} on a width of {} is sought; results depend on "
                   "the width",
                   printed(scene.load.nominalPressure, "Pa", kGivenDigits),
                   printed(scene.load.width, "m", kGivenDigits))
             : message(
                   "the indentation that carries {} on the square of the period is sought; results "
                   "depend on the width",
                   printed(scene.load.nominalPressure, "Pa", kGivenDigits));
}

Message whyMarch(const Scene& scene, bool runs) {
  if (!runs) return "steady sliding is stationary in the line's frame";
  return scene.sliding.kind == SlidingKind::Steady ? "the window lets the line pass by"
                                                   : "the velocity changes with time";
}

Message whyInterface(const Scene& scene, bool runs) {
  if (!runs) return "local friction has no strength";
  return scene.interface.frictionCoefficient > 0
             ? message("a local coefficient of {} is reported separately",
                       scene.interface.frictionCoefficient)
             : message("{} N/m in contact are reported separately", scene.interface.shearStress);
}

Message whySweep(const Scene& scene, bool runs) {
  if (!scene.sweep.isOfVelocity())
    return runs ? message("{} values of {}, those on the same lines side by side",
                          scene.sweep.points, scene.sweep.key)
                : message("only one value of {} is asked for", scene.sweep.key);
  return runs ? message("{} velocities, side by side where the kernel can", scene.sweep.points)
              : Message("only one velocity is asked for");
}

Message whyAveraging(const Scene& scene, bool runs) {
  if (runs && choosesAccuracy(scene)) return "as many random lines as the target accuracy needs";
  if (runs && hasRandomPhases(scene.surface))
    return message("{} random lines", scene.ensemble.realizations);
  if (runs && scene.ensemble.realizations == 0) return "every row of the measured surface";
  if (runs) return message("{} rows of the measured surface", scene.ensemble.realizations);
  return mayHaveManyLines(scene.surface) ? "one line is enough" : "the line is not random";
}

Message whyShape(const Scene&, bool runs) {
  return runs ? "it is drawn, or marched on from" : "nothing is drawn";
}

using Why = Message (*)(const Scene&, bool runs);
constexpr std::array<Why, kStages> kReasons{
    whyLine,      whyRollOff,    whySummits,   whyShift,       whyFreeSurface, whyArms,
    whyStart,     whySteadyPass, whySearch,    whyPeriodicity, whyBalance,     whyMarch,
    whyInterface, whySweep,      whyAveraging, whyShape};

std::array<std::atomic<std::uint64_t>, kStages> counts{};

}  // namespace

bool needsStage(const Scene& scene, Purpose purpose, Stage stage) {
  if (stage == Stage::Line) return true;
  if (stage == Stage::RollOff)
    return isSelfAffine(scene) && scene.surface.rollOffWavelength > 0 &&
           scene.surface.rollOffWavelength < scene.surface.length;
  if (stage == Stage::SummitCorrelation)
    return isSelfAffine(scene) && scene.surface.summitCorrelation != 0;
  if (!hasElastomer(purpose)) return false;
  if (purpose == Purpose::Window && stage != Stage::TimeMarch)
    return needsStage(scene, Purpose::Curve, stage) || needsStage(scene, Purpose::Picture, stage);
  const bool steady = isSteady(scene, purpose);
  switch (stage) {
    case Stage::TemperatureShift:
      return elementLaw(scene.elastomer).kind() != ElementKind::Elastic &&
             shiftsTimes(scene.elastomer);
    case Stage::FreeSurface:
      return elementLaw(scene.elastomer).kind() != ElementKind::Elastic;
    case Stage::Arms:
      return elementLaw(scene.elastomer).kind() == ElementKind::Arms;
    case Stage::StartFromRest:
      return !steady && (scene.sliding.kind == SlidingKind::Start || scene.sliding.velocity == 0);
    case Stage::SteadyPass:
    case Stage::ContactSearch:
      return hasSteadyState(scene, purpose);
    case Stage::Periodicity:
      return hasSteadyState(scene, purpose) &&
             elementLaw(scene.elastomer).kind() == ElementKind::Arms;
    case Stage::ForceBalance:
      return scene.load.kind != LoadKind::Indentation;
    case Stage::TimeMarch:
      return !steady || purpose == Purpose::Window;
    case Stage::Interface:
      return hasLocalFriction(scene);
    case Stage::Sweep:
      return purpose == Purpose::Curve && scene.sweep.points > 1;
    case Stage::Averaging:
      return purpose == Purpose::Curve && isAveraged(scene);
    default:
      return purpose != Purpose::Curve;
  }
}

std::vector<PlanStage> planStages(const Scene& scene, Purpose purpose) {
  checkEffects(scene);
  std::vector<PlanStage> stages;
  for (std::size_t i = 0; i < kStages; ++i) {
    const auto stage = static_cast<Stage>(i);
    const bool runs = needsStage(scene, purpose, stage);
    const bool about = i <= static_cast<std::size_t>(Stage::SummitCorrelation);
    stages.push_back({stage, std::string(kNames[i]), runs,
                      runs || about || hasElastomer(purpose)
                          ? kReasons[i](scene, runs)
                          : Message("only the line is asked for")});
  }
  return stages;
}

std::string_view stageName(Stage stage) {
  return kNames[static_cast<std::size_t>(stage)];
}

StageCounts stageCounts() {
  StageCounts now{};
  for (std::size_t i = 0; i < kStages; ++i) now[i] = counts[i].load(std::memory_order_relaxed);
  return now;
}

void countStage(Stage stage) {
  counts[static_cast<std::size_t>(stage)].fetch_add(1, std::memory_order_relaxed);
}

}  // namespace asperity
