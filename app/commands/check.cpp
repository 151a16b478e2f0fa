// asperity check: reads and validates, and says in a few lines what the scene is.
#include <fmt/format.h>

#include "app/command_line.h"
#include "app/output.h"
#include "core/contact/steady_sliding.h"
#include "core/friction/law.h"
#include "core/scene/element_law.h"
#include "core/scene/input_error.h"
#include "core/scene/provenance.h"
#include "core/surface/line_source.h"

namespace asperity {
namespace {

LawInput lawInputOf(const Scene& scene, const LineSource& source) {
  const SlidingConditions conditions = conditionsOf(scene, scene.sliding.velocity);
  return {conditions.shearModulus,       conditions.relaxationTime,    source.length(),
          source.statistics().rmsHeight, source.statistics().rmsSlope, scene.surface.hurst,
          scene.load.normalForce,        scene.sliding.velocity};
}

std::string summaryOf(const Scene& scene, const LineSource& source, const LawInput& in) {
  std::string text = fmt::format(
      "{}\n  line: L = {} m, {} elements of {:.6g} m, rms height {:.6g} m, rms slope {:.6g}\n",
      scene.title.empty() ? "a valid scene" : scene.title, source.length(), source.elements(),
      source.length() / static_cast<double>(source.elements()), in.rmsHeight, in.rmsSlope);
  if (in.rmsHeight > 0 && scene.load.kind == LoadKind::Force)
    text += fmt::format("  dimensionless force F_N / G h L = {:.6g} (Eq. 14)\n",
                        dimensionlessForce(in));
  // Eq. (13) knows one relaxation time.
  if (in.rmsHeight > 0 && lawOf(scene.elastomer).kind() != ElementKind::Arms)
    text += fmt::format("  dimensionless velocity tau v slope / (sqrt(2) h) = {:.6g} (Eq. 13)\n",
                        dimensionlessVelocity(in));
  return text;
}

}  // namespace

int runCheck(const CommonOptions& command) {
  const Scene scene = sceneOf(command);
  saidOfScene(command, [&] {
    const LineSource source(scene, pointsPerElement(scene));
    printSummary(command.json, command.quiet, summaryOf(scene, source, lawInputOf(scene, source)));
  });
  if (command.json) {
    nlohmann::ordered_json answer = provenance("check", scene);
    answer["valid"] = true;
    fmt::print("{}\n", answer.dump(2));
  }
  return kDone;
}

}  // namespace asperity
