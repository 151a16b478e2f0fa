// What a map over two parameters will cost, predicted from a trial: of all its states on one line,
// or where that takes long of some of them, and where it is short of all on a few lines, too, which
// tells what does not grow with the lines. Time depends on the machine and is shown to users, but
// never decides what is computed. Threading: one thread at a time (time is measured). Failure: as
// parameterMap; StopRequested.
#pragma once

#include <cstddef>
#include <stop_token>

#include "core/friction/parameter_map.h"

namespace asperity {

struct MapCost {
  std::size_t columns = 0, rows = 0;  // cells along x and y
  /// Cells that have to be slid; the others are equal to one of them. 0: not known, because the
  /// trial was of some cells only.
  std::size_t different = 0;
  double lines = 1;    // that each cell is a mean over
  double seconds = 0;  // wall clock, on `threads`
  int threads = 1;
};

/// Predicts `parameterMap` for these axes. threads: 0 means as many as the machine has.
MapCost predictMap(const Scene& scene, const MapAxis& x, const MapAxis& y, int threads = 0,
                   const std::stop_token& stop = {});

}  // namespace asperity
