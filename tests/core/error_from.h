// What the program says of input that it refuses.
#pragma once

#include <string>

#include "core/base/input_error.h"

namespace asperity {

/// Returns the text of the InputError that the work throws; "no error" where it throws none.
template <class Work>
std::string errorFrom(const Work& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace asperity
