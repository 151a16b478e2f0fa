#include "tests/stability/random_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

#include "core/scene/list_text.h"
#include "core/scene/scene_file.h"

namespace asperity {
namespace {

constexpr std::int64_t kMaxElements = 400, kMaxPoints = 8;  // so that many scenes are tried
constexpr double kMinTime = std::numeric_limits<double>::denorm_min();  // s, above 0, of an arm

template <class... Handlers>
struct Overloaded : Handlers... {
  using Handlers::operator()...;
};
template <class... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;

/// 0 to 1, of 2^30 steps.
rc::Gen<double> part() {
  return rc::gen::map(rc::gen::resize(100, rc::gen::inRange(0, (1 << 30) + 1)),
                      [](int value) { return static_cast<double>(value) / (1 << 30); });
}

double between(double low, double high, double part) {
  // In the logarithm where there is one; 0 stands for itself at the low end.
  if (low < 0) return low + part * (high - low);
  const double least = low > 0 ? low : high * 1e-30;
  if (low == 0 && part < 0.05) return 0;
  return std::clamp(std::exp(std::log(least) + part * (std::log(high) - std::log(least))), low,
                    high);
}

rc::Gen<ParameterValue> anyValue(const RealField& field) {
  const auto inside = [](double low, double high) {
    return rc::gen::map(part(),
                        [low, high](double at) { return ParameterValue(between(low, high, at)); });
  };
  // What sliders reach, mostly; then everything; then the ends.
  return rc::gen::weightedOneOf<ParameterValue>(
      {{6, inside(field.sliderFrom, field.sliderTo)},
       {3, inside(field.minimum, field.maximum)},
       {1, rc::gen::element<ParameterValue>(field.minimum, field.maximum)}});
}

rc::Gen<ParameterValue> anyValue(const IntegerField& field, std::int64_t most) {
  const std::int64_t high = std::min(field.maximum, most);
  return rc::gen::map(part(), [low = field.minimum, high](double at) {
    const double value =
        std::floor(between(static_cast<double>(low), static_cast<double>(high), at));
    return ParameterValue(std::clamp(static_cast<std::int64_t>(value), low, high));
  });
}

std::int64_t mostOf(std::string_view key) {
  if (key == "surface.elements") return kMaxElements;
  if (key == "accuracy.oversampling") return kMaxPoints;
  if (key == "surface.waves") return kMaxElements / 2;
  return std::int64_t{1} << 53;
}

/// 0 or any number up to `most`, every power of ten alike.
double upTo(double most, double least, double part) {
  return part < 0.05 ? 0 : between(least, most, (part - 0.05) / 0.95);
}

/// Mostly moduli and times of rubber, sometimes everything that the table allows: times down to the
/// smallest number there is.
rc::Gen<ParameterValue> anyArms() {
  const auto arm =
      rc::gen::map(rc::gen::tuple(part(), part(), rc::gen::resize(100, rc::gen::inRange(0, 4))),
                   [](const std::tuple<double, double, int>& at) {
                     const auto [modulus, time, wide] = at;
                     return wide == 0 ? Arm{upTo(1e15, 1e-6, modulus), upTo(1e12, kMinTime, time)}
                                      : Arm{between(1e3, 1e9, modulus), between(1e-10, 1e3, time)};
                   });
  return rc::gen::map(rc::gen::resize(6, rc::gen::container<std::vector<Arm>>(arm)),
                      [](const std::vector<Arm>& arms) { return ParameterValue(listText(arms)); });
}

rc::Gen<ParameterValue> anyValueOf(const Parameter& row) {
  return std::visit(
      Overloaded{[](const RealField& field) { return anyValue(field); },
                 [&](const IntegerField& field) { return anyValue(field, mostOf(row.key)); },
                 [](const ChoiceField& field) {
                   std::vector<ParameterValue> words;
                   for (const std::string_view word : field.choices)
                     words.emplace_back(std::string(word));
                   return rc::gen::elementOf(words);
                 },
                 [](const ArmsField&) { return anyArms(); },
                 [&](const auto&) {
                   return rc::gen::just(row.key == "surface.file"
                                            ? ParameterValue(std::string("profile_public.csv"))
                                            : parameterValue(row, Scene{}));
                 }},
      row.field);
}

}  // namespace

Scene sceneWith(const std::vector<Setting>& settings) {
  Scene scene;
  scene.surface.elements = 100;
  scene.ensemble.realizations = 1;
  for (const bool kinds : {true, false})
    for (const Setting& setting : settings) {
      const Parameter& row = parameters()[setting.row];
      if (std::holds_alternative<ChoiceField>(row.field) != kinds) continue;
      if (!kinds && !isApplicable(row, scene)) continue;
      setValue(row, scene, setting.value);
    }
  if (scene.surface.kind == SurfaceKind::Profile) scene.surface.file = "profile_public.csv";
  if (scene.elastomer.rheology == Rheology::StandardSolid) scene.elastomer.arms.resize(1);
  scene.surface.waves = std::min(scene.surface.waves, (scene.surface.elements - 1) / 2);
  if (scene.accuracy.scheme == Scheme::Nodal) scene.accuracy.oversampling = 1;
  if (scene.sweep.velocityFrom > scene.sweep.velocityTo)
    std::swap(scene.sweep.velocityFrom, scene.sweep.velocityTo);
  scene.folder = std::string(ASPERITY_TESTS_DIR) + "/reference";
  return scene;
}

rc::Gen<std::vector<Setting>> anySettings() {
  const auto rows = parameters().size();
  return rc::gen::container<std::vector<Setting>>(rc::gen::mapcat(
      rc::gen::resize(100, rc::gen::inRange<std::size_t>(0, rows)), [](std::size_t row) {
        return rc::gen::map(anyValueOf(parameters()[row]), [row](const ParameterValue& value) {
          return Setting{row, value};
        });
      }));
}

rc::Gen<std::vector<Setting>> anySettingsWithArms() {
  const auto rowOf = [](std::string_view key) {
    return static_cast<std::size_t>(findParameter(key) - parameters().data());
  };
  const Setting prony{rowOf("elastomer.rheology"), std::string("prony")};
  const auto arms =
      rc::gen::map(anyArms(), [row = rowOf("elastomer.arms")](const ParameterValue& value) {
        return Setting{row, value};
      });
  return rc::gen::map(rc::gen::pair(anySettings(), arms),
                      [prony](const std::pair<std::vector<Setting>, Setting>& drawn) {
                        std::vector<Setting> settings = drawn.first;
                        settings.push_back(prony);
                        settings.push_back(drawn.second);
                        return settings;
                      });
}

std::ostream& operator<<(std::ostream& stream, const Setting& setting) {
  stream << parameters()[setting.row].key << "=";
  std::visit([&stream](const auto& value) { stream << value; }, setting.value);
  return stream;
}

}  // namespace asperity
