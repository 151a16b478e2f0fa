// Isotherms by the set temperature that stands beside that of the sample. Pure; any thread.
#pragma once

#include <optional>
#include <vector>

#include "core/base/message.h"
#include "core/material/dma_samples.h"
#include "core/material/isotherms.h"

namespace asperity {

/// Gives all rows of one set temperature the mean of their own temperatures where these scatter so
/// far that rows closer than kIsothermTolerance would be other isotherms. Returns the note that
/// says so. Does nothing where this is not clear: where several columns or none state the set
/// temperature, where a row has none, where one of them has a single frequency or rows more than 3
/// K apart, or where the rows of two of them overlap. origins: of each row.
std::optional<Message> groupBySetTemperature(std::vector<MeasuredModulus>& rows,
                                             const std::vector<RowOrigin>& origins);

}  // namespace asperity
