#include "core/contact/kernels/nodal_search.h"

namespace asperity {

NodalBalance balanceNodal(const PreparedProfile& line, double memoryLength, double load) {
  NodalSearch search;
  search.start(load, line.spacing, load / line.length + line.meanRise, 0);
  while (!search.isDone()) {
    NodalLook look;
    look.depth = search.nextDepth();
    const NodalState state = nodalStateAt(line, look.depth, memoryLength);
    look.force = state.sums.pressure;
    look.loaded = state.loaded;
    look.threshold = state.threshold;
    look.sums = state.sums;
    search.take(look);
  }
  return search.answer();
}

}  // namespace asperity
