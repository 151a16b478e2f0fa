#include "core/scene/essentials.h"

#include <algorithm>
#include <array>

#include "core/base/text.h"
#include "core/scene/parameters.h"

namespace asperity {

namespace {

/// The keys in the order in which they are shown. Rows of another kind have no meaning and are left
/// out.
constexpr std::array<std::string_view, 20> kShown{kVelocityKey,
                                                  "sliding.velocity_after",
                                                  "sliding.amplitude",
                                                  "sliding.frequency",
                                                  "load.normal_force",
                                                  "load.depth",
                                                  "load.nominal_pressure",
                                                  "elastomer.material",
                                                  "elastomer.shear_modulus",
                                                  "elastomer.relaxation_time",
                                                  "elastomer.equilibrium_modulus",
                                                  "elastomer.temperature",
                                                  "surface.file",
                                                  "surface.rms_height",
                                                  "surface.hurst",
                                                  "surface.amplitude",
                                                  "surface.waves",
                                                  "surface.slope",
                                                  "surface.radius",
                                                  "interface.friction_coefficient"};

/// If there are too many keys, these are left out, beginning with the last one.
constexpr std::array<std::string_view, 4> kMinImportant{"elastomer.equilibrium_modulus",
                                                        "surface.hurst", "elastomer.temperature",
                                                        "elastomer.relaxation_time"};

bool hasMeaning(std::string_view key, const Scene& scene) {
  return isApplicable(*findParameter(key), scene);
}

/// Returns whether a row that has a meaning is also essential in this scene.
bool isEssential(std::string_view key, const Scene& scene) {
  if (key == "elastomer.temperature") return hasArms(scene.elastomer.rheology);
  if (key == "elastomer.equilibrium_modulus") return scene.elastomer.material.empty();
  if (key == "interface.friction_coefficient") return scene.interface.frictionCoefficient > 0;
  return true;
}

/// Returns the first of the keys that has a meaning, or else that of the velocity.
std::string_view firstOf(const WordList& keys, const Scene& scene) {
  for (const std::string_view key : keys)
    if (hasMeaning(key, scene)) return key;
  return kVelocityKey;
}

}  // namespace

std::vector<std::string_view> essentialKeys(const Scene& scene) {
  std::vector<std::string_view> keys;
  for (const std::string_view key : kShown)
    if (hasMeaning(key, scene) && isEssential(key, scene)) keys.push_back(key);
  for (const std::string_view key : kMinImportant)
    if (keys.size() > kMaxEssentials) std::erase(keys, key);
  keys.resize(std::min(keys.size(), kMaxEssentials));
  return keys;
}

std::string_view noteKey(Note note, const Scene& scene) {
  switch (note) {
    case Note::SlopeAbove:
      return firstOf(
          "surface.rms_height surface.amplitude surface.slope surface.radius surface.file", scene);
    case Note::FewContacts:
    case Note::StrainBeyondMeasured:
    case Note::UnresolvedFriction:
      return firstOf("load.normal_force load.depth load.nominal_pressure", scene);
    case Note::ExtrapolatedTemperature:
      return firstOf("elastomer.temperature", scene);
    case Note::SeamJump:
      return firstOf("surface.seam surface.file", scene);
    case Note::FewIndependentRows:
      return firstOf("surface.file", scene);
    case Note::CoarseHeights:
      return firstOf("surface.short_wave_cut surface.file", scene);
    case Note::RoundForm:
      return firstOf("surface.long_wave_cut surface.file", scene);
    case Note::Spikes:
      return firstOf("surface.outliers surface.file", scene);
    case Note::ExtrapolatedMaterial:
    case Note::FastEnoughToHeat:
    case Note::FasterThanTested:
      break;
  }
  return kVelocityKey;
}

}  // namespace asperity
