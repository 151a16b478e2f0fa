// What every fuzz target asks of a reader: any bytes are either read or refused with InputError, in
// one short line. Everything else (another exception, a sanitizer's finding, an endless run) is a
// finding.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/base/input_error.h"

namespace asperity {

inline void require(bool holds) {
  if (!holds) std::abort();
}

/// A message is one line of no more than a few hundred letters.
inline void requireShortLine(const std::string& message) {
  require(message.size() < 1000);
  for (const char letter : message) require(static_cast<unsigned char>(letter) >= ' ');
}

/// Calls read(text); a refusal is a short line.
template <class Read>
int readOrRefuse(const std::uint8_t* data, std::size_t size, const Read& read) {
  try {
    read(std::string_view(reinterpret_cast<const char*>(data), size));
  } catch (const InputError& error) {
    require(error.what()[0] != '\0');
    requireShortLine(error.what());
  }
  return 0;
}

}  // namespace asperity
