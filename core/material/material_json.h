// Writes a material as material.json (asperity-material/1), which a scene names as
// elastomer.material. Pure; any thread.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/material/material_model.h"

namespace asperity {

/// Returns {"schema", "verb", "version", "origin": {"file", "sha256", "options"}}.
nlohmann::ordered_json materialOrigin(const Material& material);

/// Returns the text of material.json.
std::string materialJson(const Material& material);

}  // namespace asperity
