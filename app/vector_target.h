// Choice of the vector instructions of the kernels: the widest that the machine has, or those that
// the environment names, so that a result of another machine can be reproduced to the last digit.
// Main thread.
#pragma once

#include <string>

namespace asperity {

/// Reads ASPERITY_TARGET, if it is set. Throws InputError where it names no target, or one that
/// this machine does not have. Call it before anything is computed.
void chooseVectorTarget();

/// Returns the help text: the variable and its values.
std::string vectorTargetHelp();

/// Returns "avx2 kernels": what the present machine computes with.
std::string vectorTargetInUse();

}  // namespace asperity
