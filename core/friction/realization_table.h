// The values of each random line behind a friction curve, as a table: what its means and standard
// errors are made of. One thread at a time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/contact/steady_sliding.h"
#include "core/scene/data_table.h"

namespace asperity {

class RealizationTable {
 public:
  /// velocities: of the sweep, m/s.
  explicit RealizationTable(std::vector<double> velocities);

  /// Adds a realization's results at the velocities, in their order.
  void add(std::int64_t realization, std::span<const SteadyResult> results);

  /// realization, velocity, mu, mu_interface, contact_fraction, rms_slope_contact, indentation,
  /// normal_force, tangential_force, rms_slope: one row for each line and velocity.
  const DataTable& table() const { return table_; }

 private:
  std::vector<double> velocities_;
  DataTable table_;
};

}  // namespace asperity
