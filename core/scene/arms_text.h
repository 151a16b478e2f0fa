// The arms of an elastomer as JSON text: [{"modulus":1e7,"relaxation_time":0.001}, ...].
// Pure functions.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/scene/scene.h"

namespace asperity {

/// One number of an arm: the table of parameters within the list.
struct ArmMember {
  const char* name;
  double Arm::*value;
  double most;  // at least 0
  const char* unit;
};

/// Modulus, then relaxation time.
std::span<const ArmMember> armMembers();

/// Throws InputError that names the member, such as KEY[1].modulus.
std::vector<Arm> armsFrom(std::string_view json, const std::string& key);

/// Numbers in the shortest form that reads back to the same value.
std::string textOf(const std::vector<Arm>& arms);

/// What a list may hold, in words.
Message allowedArms();

}  // namespace asperity
