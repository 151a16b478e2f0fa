#include "ui/chart/plot.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace asperity {

bool isPlottable(double x, double y) {
  return std::isfinite(x) && std::isfinite(y) && x > 0 && y > 0;
}

std::vector<PlotPoint> plottable(const std::vector<PlotPoint>& points) {
  std::vector<PlotPoint> kept;
  std::copy_if(points.begin(), points.end(), std::back_inserter(kept),
               [](const PlotPoint& point) { return isPlottable(point.x, point.y); });
  return kept;
}

}  // namespace asperity
