// What was found of a sentence of the paper, in words: for the table in the window and for what
// `asperity figure` prints. Pure once the language is chosen; any thread.
#pragma once

#include <QString>

#include "core/paper/claim.h"

namespace asperity {

/// "yes", "no", "undecided", "only for scheme ...".
QString verdictText(const Claim& claim);

/// "1.26 ± 0.04": as many digits as the uncertainty leaves; three where there is none.
QString estimateText(const Estimate& estimate);

}  // namespace asperity
