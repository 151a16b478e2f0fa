// The measurements in resources/materials/measurements.
#pragma once

#include <string>

#include "core/base/regular_file.h"
#include "core/material/material_model.h"

namespace asperity {

inline std::string measurements(const std::string& name) {
  return readRegularFile(std::string(ASPERITY_RESOURCES_DIR) + "/materials/measurements/" + name,
                         1 << 20);
}

inline const Material& epdm() {
  static const Material material = makeMaterial(measurements("epdm_70.csv"), "epdm_70.csv", {});
  return material;
}

}  // namespace asperity
