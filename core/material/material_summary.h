// A material for people and programs: what was measured of it, what was assumed and how good its
// fit is, in sentences; and material.json (asperity-material/1), which a scene names as
// elastomer.material. Pure; any thread.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/material/material_model.h"

namespace asperity {

/// Returns "one arm" or "12 arms".
Message describeArms(std::size_t count);

/// Returns what was measured and how good the fit is, one sentence each.
std::vector<Message> materialSummary(const Material& material);

/// Returns {"schema", "verb", "version", "origin": {"file", "sha256", "options"}}.
nlohmann::ordered_json materialOrigin(const Material& material);

/// Returns the text of material.json.
std::string materialJson(const Material& material);

}  // namespace asperity
