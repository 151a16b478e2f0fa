// asperity columns: lists all columns of all tables with their meaning.
#include "core/scene/columns.h"

#include <fmt/format.h>

#include "app/command_line.h"

namespace asperity {

int runColumns(const CommonOptions& command) {
  printSummary(command, columnsText());
  if (command.json) fmt::print("{}", columnsJson());
  return kDone;
}

}  // namespace asperity
