// asperity check: reads and validates a scene, and prints a summary of a few lines.
#include <fmt/format.h>

#include "app/command_line.h"
#include "app/output.h"
#include "core/base/input_error.h"
#include "core/base/text.h"
#include "core/contact/steady_sliding.h"
#include "core/friction/law.h"
#include "core/material/element_law.h"
#include "core/scene/provenance.h"
#include "core/surface/line_source.h"
#include "ui/draw/ticks.h"
#include "ui/language/translated.h"
#include "ui/language/words.h"

namespace asperity {
namespace {

LawInput lawInputOf(const Scene& scene, const LineSource& source) {
  const SlidingConditions conditions = slidingConditions(scene, scene.sliding.velocity);
  return {conditions.shearModulus,
          conditions.relaxationTime,
          source.length(),
          source.statistics().rmsHeight,
          source.statistics().rmsSlope,
          scene.surface.hurst,
          loadOn(scene.load, source.length()).normalForce,
          scene.sliding.velocity};
}

std::string summaryOf(const Scene& scene, const LineSource& source, const LawInput& in) {
  const auto number = [](double value) { return shortNumber(value, 6); };
  const double spacing = source.length() / static_cast<double>(source.elements());
  std::string text =
      scene.title.empty() ? Words::tr("a valid scene") : printable(translated(scene.title));
  const auto add = [&text](const std::string& line) { text += "\n  " + line; };
  add(filled(Words::tr("line: L = %1 m, %2 elements of %3 m, rms height %4 m, rms slope %5"),
             {number(source.length()), std::to_string(source.elements()), number(spacing),
              number(in.rmsHeight), number(in.rmsSlope)}));
  if (in.rmsHeight > 0 && scene.load.kind != LoadKind::Indentation)
    add(filled(Words::tr("dimensionless force F_N / G h L = %1 (Eq. 14)"),
               {number(dimensionlessForce(in))}));
  // Eq. (13) has one relaxation time.
  if (in.rmsHeight > 0 && lawOf(scene.elastomer).kind() != ElementKind::Arms)
    add(filled(Words::tr("dimensionless velocity tau v slope / (sqrt(2) h) = %1 (Eq. 13)"),
               {number(dimensionlessVelocity(in))}));
  return text + "\n";
}

}  // namespace

int runCheck(const CommonOptions& command) {
  const Scene scene = sceneOf(command);
  withSceneContext(command, [&] {
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
