#include "core/scene/arms_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/scene/parameters.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<ArmMember, 2> kMembers{
    {{"modulus", &Arm::modulus, 1e15, "Pa"}, {"relaxation_time", &Arm::relaxationTime, 1e12, "s"}}};

Message allowed(const ArmMember& member) {
  return rangeText(0, member.most, member.unit);
}

Json parsed(std::string_view json, const std::string& key) {
  Json list = Json::parse(json, nullptr, false);
  if (list.is_discarded())
    throw InputError("", key, message("is not a list in JSON; allowed is {}", allowedArms()));
  if (!list.is_array()) throw InputError("", key, message("needs {}", allowedArms()));
  if (list.size() > kMostArms)
    throw InputError("", key, message("has {} arms; allowed is {}", list.size(), allowedArms()));
  return list;
}

Arm armFrom(const Json& json, const std::string& key) {
  if (!json.is_object())
    throw InputError("", key, "needs an object of modulus and relaxation_time");
  for (const auto& [name, value] : json.items())
    if (std::none_of(kMembers.begin(), kMembers.end(),
                     [&name = name](const ArmMember& member) { return name == member.name; }))
      throw InputError("", key + "." + shortened(name),
                       "unknown key; an arm has modulus and relaxation_time");
  Arm arm;
  for (const ArmMember& member : kMembers) {
    const std::string path = key + "." + member.name;
    if (!json.contains(member.name)) throw InputError("", path, "is missing");
    const Json& value = json[member.name];
    if (!value.is_number())
      throw InputError("", path, message("is not a number; allowed is {}", allowed(member)));
    const double number = value.get<double>();
    if (!(number >= 0 && number <= member.most))
      throw InputError("", path, message("{} is outside {}", plain(number), allowed(member)));
    arm.*member.value = number;
  }
  return arm;
}

}  // namespace

std::span<const ArmMember> armMembers() {
  return kMembers;
}

std::vector<Arm> armsFrom(std::string_view json, const std::string& key) {
  const Json list = parsed(json, key);
  std::vector<Arm> arms;
  for (std::size_t i = 0; i < list.size(); ++i)
    arms.push_back(armFrom(list[i], fmt::format("{}[{}]", key, i)));
  return arms;
}

std::string textOf(const std::vector<Arm>& arms) {
  Json list = Json::array();
  for (const Arm& arm : arms) {
    Json one;
    for (const ArmMember& member : kMembers) one[member.name] = arm.*member.value;
    list.push_back(std::move(one));
  }
  return list.dump();
}

Message allowedArms() {
  return message("a list of 0 to {} {{modulus, relaxation_time}}, {} and {}", kMostArms,
                 allowed(kMembers[0]), allowed(kMembers[1]));
}

}  // namespace asperity
