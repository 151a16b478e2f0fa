// The cost of a map of friction over two parameters, predicted before the run: a few of its lines
// are tried. Time depends on the machine and is shown to users, but never decides what is computed.
// Threading: one thread at a time (time is measured). Failure: as parameterMap; StopRequested.
#pragma once

#include <cstddef>
#include <stop_token>

#include "core/friction/parameter_map.h"
#include "core/scene/scene.h"

namespace asperity {

struct MapCost {
  std::size_t columns = 0, rows = 0;  // cells along x and y
  /// The number of cells that have to be computed; the others equal one of them. 0: not known,
  /// because the trial used only some cells.
  std::size_t different = 0;
  double lines = 1;    // number of lines of the mean in each cell
  double seconds = 0;  // wall clock, on `threads`
  int threads = 1;
};

/// Predicts `parameterMap` for these axes from a trial: of all cells on one line or, where that
/// takes long, of some of them. Where the trial is short, all cells are also computed on a few
/// lines, which shows the part of the time that does not grow with the lines. threads: 0 means as
/// many as the machine has.
MapCost predictMap(const Scene& scene, const MapAxis& x, const MapAxis& y, int threads = 0,
                   const std::stop_token& stop = {});

}  // namespace asperity
