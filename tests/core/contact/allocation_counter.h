// Counts every allocation of the test program.
#pragma once

namespace asperity {
long allocationsSoFar();
}
