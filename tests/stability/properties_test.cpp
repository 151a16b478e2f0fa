// What always holds, tried on random scenes over the whole table of parameters. A failure is shrunk
// and written as a scene file, which `asperity check` opens; once mended it is kept among the
// regressions, which are tried every time.
// ASPERITY_PROPERTIES=N tries N scenes, with a seed of their own by ASPERITY_SEED=N. Lines of up to
// ASPERITY_REFERENCE=N nodes are also computed in wider numbers, which is slow.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

#include "core/base/input_error.h"
#include "core/contact/steady_solver.h"
#include "core/scene/scene_file.h"
#include "core/surface/line_source.h"
#include "tests/stability/invariants.h"
#include "tests/stability/random_scene.h"
#include "tests/stability/reference_arms.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

/// An environment variable as a number.
std::uint64_t numberFrom(const char* variable, std::uint64_t otherwise) {
  const char* text = std::getenv(variable);
  return text ? std::strtoull(text, nullptr, 10) : otherwise;
}

/// Relative. Strains are known to an ulp of heights or depth, whichever is larger, and close to
/// what the result says; arms far stiffer than the equilibrium make pressure of it.
double digitsLostBy(const ElementLaw& law, const Line& line, const SteadyResult& result) {
  double stiffness = 0;
  for (const Arm& arm : law.arms) stiffness += arm.modulus;
  const auto [low, high] = std::minmax_element(line.height.begin(), line.height.end());
  const double largest = std::max(1.0, (*high - *low) / result.indentation);
  return stiffness / law.equilibriumModulus *
         (16 * std::numeric_limits<double>::epsilon() * largest + result.periodicityError);
}

/// How far mu is from the same computation in wider numbers.
Finding referenceFinding(const Situation& situation, const SteadySolver& sliding,
                         const SteadyState& state) {
  const SteadyResult& result = state.result;
  const double velocity = situation.conditions.velocity;
  const bool withArms = sliding.law().kind() == ElementKind::Arms && velocity > 0;
  const ReferenceResult reference =
      withArms ? referenceWithArms(situation.line, situation.scheme, sliding.law(), velocity,
                                   situation.load, result.indentation, state.arms.strain)
               : referenceSliding(situation.line, situation.scheme, situation.conditions,
                                  situation.load, result.indentation);
  if (!(reference.periodicityError <= 1e-13L)) return {"the reference closes", 1, 0};
  const bool nodal = situation.scheme == Scheme::Nodal;
  const Wide least = (nodal ? 1e-12L : 1e-15L) * situation.line.rmsSlope + 1e-80L;
  const Wide apart = std::max(std::abs(result.mu - reference.mu) - least, Wide(0));
  double allowed = 1e-9;
  for (const Finding& finding : resultFindings(situation, result))
    if (finding.invariant == "both ways to F_N") allowed = finding.allowed;
  return {"mu against wider numbers",
          apart > 0 ? static_cast<double>(apart / std::abs(reference.mu)) : 0, allowed};
}

/// The first thing that does not hold, or nothing.
std::string complaintAbout(const Scene& scene) {
  try {
    const Scene again = readScene(writeScene(scene), "scene", scene.folder);
    if (writeScene(again) != writeScene(scene)) return "does not read back as it was written";
    const LineSource source(scene, pointsPerElement(scene));
    const SteadySolver sliding(scene);
    const Line line = source.make(0);
    const PreparedProfile profile = prepareProfile(line, scene.accuracy.scheme);
    const SteadyState state = sliding.at(profile, scene.sliding.velocity);
    if (isRefused(state.result)) return "";
    if (!std::isfinite(state.result.mu) && state.result.normalForce > 0)
      return "mu is not a number";
    const ElementLaw& law = sliding.law();
    Situation situation{line,
                        scene.accuracy.scheme,
                        {law.equilibriumModulus, law.relaxationTime, scene.sliding.velocity},
                        scene.load};
    const bool arms = law.kind() == ElementKind::Arms;
    if (arms)
      situation.conditions.relaxationTime =
          std::max(law.relaxationTime, law.arms.front().relaxationTime);
    const double lost = arms ? digitsLostBy(law, line, state.result) : 0;
    std::vector<Finding> findings =
        arms ? resultFindings(situation, state.result) : allFindings(situation);
    if (line.nodes() <= numberFrom("ASPERITY_REFERENCE", 0) && state.result.normalForce > 0)
      findings.push_back(referenceFinding(situation, sliding, state));
    for (const Finding& finding : findings)
      if (!(finding.value <= finding.allowed + lost))
        return fmt::format("{}: {:.2g} of {:.2g}", finding.invariant, finding.value,
                           finding.allowed);
  } catch (const InputError& refusal) {
    if (refusal.message().empty()) return "refused without a reason";
  }
  return "";
}

/// Where the scene lies that was tried last: after a crash too.
std::string written(const Scene& scene) {
  Scene portable = scene;
  if (!portable.surface.file.empty())
    portable.surface.file = (scene.folder / portable.surface.file).string();
  const fs::path file = fs::temp_directory_path() / "asperity_tried_scene.json";
  std::ofstream(file) << writeScene(portable);
  return file.string();
}

/// Tries `scenes` of them; the first that fails is kept as a file.
void expectToHold(const rc::Gen<std::vector<Setting>>& settings, std::uint64_t scenes) {
  rc::detail::TestParams params;
  params.seed = numberFrom("ASPERITY_SEED", 20130725);
  params.maxSuccess = static_cast<int>(numberFrom("ASPERITY_PROPERTIES", scenes));
  const fs::path failed = fs::temp_directory_path() / "asperity_failed_scene.json";
  const auto property = [&settings, failed] {
    const Scene scene = sceneWith(*settings);
    const std::string file = written(scene), complaint = complaintAbout(scene);
    if (complaint.empty()) return;
    fs::copy_file(file, failed, fs::copy_options::overwrite_existing);
    RC_FAIL(complaint + "; the scene is " + failed.string());
  };
  const auto result = rc::detail::checkTestable(property, rc::detail::TestMetadata(), params);
  EXPECT_TRUE(result.template is<rc::detail::SuccessResult>()) << [&] {
    std::ostringstream text;
    rc::detail::printResultMessage(result, text);
    return text.str();
  }();
}

TEST(Properties, HoldForAnyScene) {
  expectToHold(anySettings(), 1500);
}

TEST(Properties, HoldForAnyArms) {
  expectToHold(anySettingsWithArms(), 500);
}

TEST(Properties, HoldForScenesThatOnceFailed) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(ASPERITY_TESTS_DIR "/stability/regressions"))
    if (entry.path().extension() == ".json") {
      ++count;
      EXPECT_EQ(complaintAbout(readSceneFile(entry.path())), "") << entry.path();
    }
  EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace asperity
