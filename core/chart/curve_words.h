// A curve's parameters as text, for legends and lines under pictures: the symbols of the table with
// prefixed units. Pure; any thread. UTF-8.
#pragma once

#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/scene/parameters.h"
#include "core/scene/scene.h"

namespace asperity {

/// Returns the title of an axis over a parameter: "normal force F\u2099", "sliding velocity v";
/// without a symbol "seed".
Message parameterTitle(std::string_view key);

/// Returns a value of a row with its unit, a temperature in degrees Celsius; a pure number has all
/// digits that were entered.
PrintedNumber printedValue(double value, const Parameter& row);

/// Returns one parameter: "H = 0.3", "F\u2099 = 10 mN"; without a symbol, "seed 3", "linear". Empty
/// for arms and for an unknown key.
Message describeParameter(std::string_view key, const Scene& scene);

/// Returns one line with a scene's parameters: "H = 0.7, h = 500 nm, G = 10 MPa, ...", without
/// those of the given keys.
Message describeParameters(const Scene& scene, const std::vector<std::string_view>& without = {});

/// Returns the name of a scene and its parameters, for the small line under a title that says what
/// a picture shows.
Message describeScene(const Scene& scene, const std::vector<std::string_view>& without = {});

/// Returns the parameters in which `scene` differs from `from` and on which its friction curve
/// depends: "G = 20 MPa, linear"; empty where the curves have the same parameters.
Message describeDifferences(const Scene& scene, const Scene& from);

}  // namespace asperity
