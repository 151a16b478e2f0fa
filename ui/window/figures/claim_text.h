// The results of the paper's claims in words, in the language of the program. Any thread.
#pragma once

#include <QString>

#include "core/paper/claim.h"

namespace asperity {

/// Returns "yes", "no", "undecided", or "only for scheme ...".
QString verdictText(const Claim& claim);

/// Returns "1.26 ± 0.04", with the digits that the uncertainty allows; three where there is none.
QString estimateText(const Estimate& estimate);

}  // namespace asperity
