// A curve's parameters in words, for legends and lines under pictures: the symbols of the table
// with prefixed units. Pure; any thread. UTF-8.
#pragma once

#include <string>
#include <string_view>

#include "core/scene/scene.h"

namespace asperity {

/// One of them: "H = 0.3", "F\u2099 = 10 mN"; where it has no symbol, "seed 3", "linear". Empty for
/// arms and for a key that is not known.
std::string parameterInWords(std::string_view key, const Scene& scene);

/// One line of what a scene sets: "H = 0.7, h = 500 nm, G = 10 MPa, ...".
std::string parametersInWords(const Scene& scene);

/// Only what `scene` has otherwise than `from` and its friction curve depends on: "G = 20 MPa,
/// linear"; empty where the curves are of the same parameters.
std::string differencesInWords(const Scene& scene, const Scene& from);

}  // namespace asperity
