#include "core/run/contact_age.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace asperity {

std::vector<double> steadyContactAge(std::span<const double> pressure, double spacing,
                                     double velocity) {
  const std::size_t count = pressure.size();
  std::vector<double> age(count, std::numeric_limits<double>::infinity());
  const double each =
      velocity != 0 ? spacing / std::abs(velocity) : std::numeric_limits<double>::infinity();
  double now = std::numeric_limits<double>::infinity();
  // Goes around twice, from the side towards which the line slides.
  for (std::size_t step = 0; step < 2 * count; ++step) {
    const std::size_t offset = step % count;
    const std::size_t i = velocity > 0 ? count - 1 - offset : offset;
    now = pressure[i] > 0 ? 0 : now + each;
    age[i] = now;
  }
  return age;
}

}  // namespace asperity
