// How long it takes to cancel an ensemble.
#pragma once

#include <cstdint>

namespace asperity::bench {

/// The longest time (s) from a request to stop to the return of frictionCurve, `cubic` x2 on two
/// threads, of `tries` requests at different moments of the work. Threading: the main thread.
double slowestCancel(std::int64_t elements, int tries);

}  // namespace asperity::bench
