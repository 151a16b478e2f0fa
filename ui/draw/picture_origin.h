// What a picture file keeps of how it came about. Pure once the language is chosen; any thread.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/scene/scene.h"

namespace asperity {

/// "language" among what is said of a picture, where it is not English.
void addLanguage(nlohmann::ordered_json& picture);

/// The same in the provenance of a picture of which nothing else was chosen.
void nameLanguage(nlohmann::ordered_json& origin);

/// The provenance of a picture of which only the language was chosen, as one line.
std::string pictureOrigin(const std::string& verb, const Scene& scene);

}  // namespace asperity
