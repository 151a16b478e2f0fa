// Which vectors the kernels compute with: the widest that the machine has, or those that the
// environment names, so that a result of another machine can be made again to the last digit.
#pragma once

#include <string>

namespace asperity {

/// What ASPERITY_TARGET says, if anything. Throws InputError where it names none, or one that this
/// machine does not have. Before anything is computed.
void chooseVectorTarget();

/// For the help: the variable and its values.
std::string vectorTargetHelp();

}  // namespace asperity
