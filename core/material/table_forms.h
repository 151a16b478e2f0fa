// Brings tables of moduli, of Prony series and of friction into the one form that their readers
// know: a row for each point, a column for each quantity, and a number alone in each cell. Pure;
// any thread. Failure: InputError that names the file and the row.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/text_table.h"

namespace asperity {

/// Makes columns of the rows of a table that has one row for each quantity, with a note. isTable:
/// whether the caller knows the columns.
void transposeRows(TextTable& table, const std::function<bool(const TextBlock&)>& isTable,
                   std::vector<Message>& notes);

/// Joins matrices, each with rows of frequencies and columns of temperatures or the other way round
/// below a heading that names the modulus, to one table whose columns have the modulus and the
/// temperature or frequency in their names, with a note on it. Other tables stay as they are.
void joinMatrices(TextTable& table, std::vector<Message>& notes);

/// Leaves each cell with a number alone: its unit becomes that of the column, the parts of complex
/// numbers become two columns, "G* real part" and "G* imaginary part", and errors are dropped,
/// because every point counts the same. Numbers by which instruments say that a value is out of
/// range are missing. Adds notes on what was done. name: of the file.
void separateCells(TextTable& table, const std::string& name, std::vector<Message>& notes);

}  // namespace asperity
