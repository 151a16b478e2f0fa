// The coefficients of one elastomer with arms, computed once for each velocity and kept: random
// lines of one spectrum have the same length and spacing, so all of them share the table.
// Threading: any number of threads may ask at once. Ownership: the result is shared and never
// changes.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <tuple>

#include "core/contact/arms/arm_coefficients.h"
#include "core/contact/arms/arm_vectors.h"
#include "core/contact/line/prepared_profile.h"
#include "core/material/element_law.h"

namespace asperity {

/// The coefficients at one velocity for lines of one length, spacing and number of block levels.
struct ArmTable {
  ArmTable(const ElementLaw& law, const RetardationModes& modes, double velocity,
           const PreparedProfile& line)
      : coefficients(law, modes, velocity, line.spacing, line.length, line.blocks.size()),
        vectors(coefficients) {}

  ArmCoefficients coefficients;
  ArmVectors vectors;
};

class ArmTables {
 public:
  /// The object refers to both arguments.
  ArmTables(const ElementLaw& law, const RetardationModes& modes) : law_(law), modes_(modes) {}

  /// velocity: m/s, > 0.
  std::shared_ptr<const ArmTable> at(double velocity, const PreparedProfile& line);

  const ElementLaw& law() const { return law_; }

 private:
  using Key = std::tuple<double, double, double, std::size_t>;

  const ElementLaw& law_;
  const RetardationModes& modes_;
  std::mutex mutex_;
  std::map<Key, std::shared_ptr<const ArmTable>> known_;
};

}  // namespace asperity
