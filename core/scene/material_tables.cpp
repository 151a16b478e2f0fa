#include "core/scene/material_tables.h"

#include <cmath>

#include "core/base/input_error.h"
#include "core/base/statistics.h"
#include "core/material/temperature_shift.h"
#include "core/scene/columns.h"
#include "core/scene/data_table.h"

namespace asperity {
namespace {

double shiftOrNaN(const TemperatureFit& fit, double temperature) {
  if (!fit.isDefined) return kNaN;
  try {
    return log10ShiftFactor(fit.shift, temperature);
  } catch (const InputError&) {
    return kNaN;
  }
}

}  // namespace

std::string isothermsCsv(const Material& material) {
  DataTable table{
      columnNames({"temperature", "frequency", "storage_modulus", "loss_modulus", "loss_tangent",
                   "reduced_frequency", "reduced_storage_modulus", "reduced_loss_modulus",
                   "fitted_storage_modulus", "fitted_loss_modulus"}),
      {}};
  for (std::size_t i = 0; i < material.isotherms.size(); ++i) {
    const IsothermShift& shift = material.curve.shifts[i];
    const double factor = std::pow(10, shift.log10Shift);
    const double vertical = std::pow(10, shift.log10Vertical);
    for (const DynamicModulus& point : material.isotherms[i].points) {
      const DynamicModulus fitted = modulusAt(material.series, point.frequency * factor);
      table.rows.push_back({shift.temperature, point.frequency, point.storage, point.loss,
                            point.loss / point.storage, point.frequency * factor,
                            point.storage / vertical, point.loss / vertical, fitted.storage,
                            fitted.loss});
    }
  }
  return tableCsv(table);
}

std::string shiftsCsv(const Material& material) {
  DataTable table{columnNames({"temperature", "log10_shift", "log10_shift_standard_error",
                               "log10_vertical_shift", "log10_shift_storage", "log10_shift_loss",
                               "log10_shift_wlf", "log10_shift_arrhenius", "overlap_mismatch",
                               "overlap_decades"}),
                  {}};
  for (std::size_t i = 0; i < material.curve.shifts.size(); ++i) {
    const IsothermShift& shift = material.curve.shifts[i];
    const bool hasNext = i < material.curve.overlaps.size();
    table.rows.push_back({shift.temperature, shift.log10Shift, shift.standardError,
                          shift.log10Vertical, shift.fromStorage, shift.fromLoss,
                          shiftOrNaN(material.wlf, shift.temperature),
                          shiftOrNaN(material.arrhenius, shift.temperature),
                          hasNext ? material.curve.overlaps[i].mismatch : kNaN,
                          hasNext ? material.curve.overlaps[i].decades : kNaN});
  }
  return tableCsv(table);
}

std::string pronyCsv(const Material& material) {
  DataTable table{columnNames({"relaxation_time", "modulus"}),
                  {{kNaN, material.series.equilibriumModulus}}};
  for (const Arm& arm : material.series.arms)
    table.rows.push_back({arm.relaxationTime, arm.modulus});
  return tableCsv(table);
}

}  // namespace asperity
