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

/// One number of an arm, as a row of a table of its own.
struct ArmMember {
  const char* name;
  double Arm::*value;
  double most;  // at least 0
  const char* unit;
};

/// Returns modulus, then relaxation time.
std::span<const ArmMember> armMembers();

/// Reads a list. Throws InputError that names the member, such as KEY[1].modulus.
std::vector<Arm> armsFrom(std::string_view json, const std::string& key);

/// Returns JSON text with numbers in the shortest form that reads back to the same value.
std::string textOf(const std::vector<Arm>& arms);

/// Returns in words what a list may contain.
Message allowedArms();

}  // namespace asperity
