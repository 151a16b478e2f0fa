// The error that a mean over the rows of a topography has as the mean of its surface. Rows that are
// drawn with replacement are independent, but the surface has only these rows: no number of draws
// makes this error smaller. The rows are slid as the coarsest lines. Pure functions; one thread at
// a time.
#pragma once

#include <stop_token>
#include <vector>

#include "core/friction/line_mean.h"
#include "core/scene/scene.h"

namespace asperity {

/// Returns the error of all rows at each velocity, relative to their mean; nothing where stopped.
std::vector<MeanError> errorsOfRows(const Scene& scene, const std::vector<double>& velocities,
                                    int threads, const std::stop_token& stop);

struct PredictedRowErrors {
  std::vector<double> standardErrors;  // at each velocity, relative to the mean
  double seconds = 0;                  // of the processor, that all rows would take
};

/// Judges the same by some pairs of rows. Throws StopRequested.
PredictedRowErrors predictErrorsOfRows(const Scene& scene, const std::vector<double>& velocities,
                                       const std::stop_token& stop);

}  // namespace asperity
