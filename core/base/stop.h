// The exception by which work ends after its caller has requested a stop by a std::stop_token.
#pragma once

#include <stop_token>

namespace asperity {

/// Thrown by work of any kind (readers, fits, curves, films) where a stop was requested.
struct StopRequested {};

inline void throwIfStopped(const std::stop_token& stop) {
  if (stop.stop_requested()) throw StopRequested{};
}

}  // namespace asperity
