// Says in sentences what was measured of a material, what was assumed, and how good its fit is.
// Pure; any thread.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/message.h"
#include "core/material/material_model.h"

namespace asperity {

/// Returns "one arm" or "12 arms".
Message describeArms(std::size_t count);

/// Returns what was measured and how good the fit is, one sentence each.
std::vector<Message> materialSummary(const Material& material);

}  // namespace asperity
