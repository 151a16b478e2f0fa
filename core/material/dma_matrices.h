// Moduli in several matrices of one table: rows of frequencies and columns of temperatures, or the
// other way round, below a heading that names the modulus. Pure; any thread.
#pragma once

#include <vector>

#include "core/base/message.h"
#include "core/base/text_table.h"

namespace asperity {

/// Joins the matrices of the storage modulus, the loss modulus, ... to one table whose columns have
/// the modulus and the temperature or frequency in their names, with a note on it. Other tables
/// stay as they are.
void joinMatrices(TextTable& table, std::vector<Message>& notes);

}  // namespace asperity
