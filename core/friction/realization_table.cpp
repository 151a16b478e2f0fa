#include "core/friction/realization_table.h"

#include <algorithm>
#include <utility>

#include "core/friction/curve_point.h"
#include "core/scene/columns.h"

namespace asperity {

RealizationTable::RealizationTable(std::vector<double> velocities)
    : velocities_(std::move(velocities)) {
  for (const ColumnName column :
       {ColumnName("realization"), ColumnName("velocity"), ColumnName("mu"),
        ColumnName("mu_interface"), ColumnName("contact_fraction"), ColumnName("rms_slope_contact"),
        ColumnName("indentation"), ColumnName("normal_force"), ColumnName("tangential_force"),
        ColumnName("rms_slope")})
    table_.columns.push_back(column.text());
}

void RealizationTable::add(std::int64_t realization, std::span<const SteadyResult> results) {
  for (std::size_t i = 0; i < std::min(results.size(), velocities_.size()); ++i) {
    const SteadyResult& at = results[i];
    // A line without normal force has no coefficient of friction.
    const bool isPressed = at.normalForce > 0;
    table_.rows.push_back({realization, velocities_[i], isPressed ? at.mu : kNotApplicable,
                           isPressed ? at.muInterface : kNotApplicable, at.contactFraction,
                           at.rmsSlopeContact, at.indentation, at.normalForce, at.tangentialForce,
                           at.rmsSlopeLine});
  }
}

}  // namespace asperity
