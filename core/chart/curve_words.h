// A curve's parameters in words, for legends and lines under pictures: the symbols of the table
// with prefixed units. Pure; any thread. UTF-8.
#pragma once

#include <string_view>

#include "core/base/message.h"
#include "core/scene/scene.h"

namespace asperity {

/// One of them: "H = 0.3", "F\u2099 = 10 mN"; where it has no symbol, "seed 3", "linear". Empty for
/// arms and for a key that is not known.
Message parameterInWords(std::string_view key, const Scene& scene);

/// One line of what a scene sets: "H = 0.7, h = 500 nm, G = 10 MPa, ...".
Message parametersInWords(const Scene& scene);

/// Only what `scene` has otherwise than `from` and its friction curve depends on: "G = 20 MPa,
/// linear"; empty where the curves are of the same parameters.
Message differencesInWords(const Scene& scene, const Scene& from);

}  // namespace asperity
