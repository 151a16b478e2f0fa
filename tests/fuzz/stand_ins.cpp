#include <string_view>
#include <vector>

#include "core/friction/curve_file.h"

namespace asperity {

// The columns of a friction curve, without what computes it.
std::vector<std::string_view> curveColumns() {
  return {"velocity", "mu", "contact_fraction", "indentation"};
}

}  // namespace asperity
