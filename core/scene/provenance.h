// How a result came about, in every machine-readable answer: schema, verb, version, the canonical
// scene and its seed; never a date, the threads or a file's name. Pure; any thread.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/scene/scene.h"

namespace asperity {

/// {"schema": "asperity-VERB/1", "verb", "version", "seed" (null where nothing is random),
/// "scene"}.
nlohmann::ordered_json provenance(const std::string& verb, const Scene& scene);

}  // namespace asperity
