#include "core/scene/material_tables.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/material/temperature_shift.h"
#include "core/scene/columns.h"

namespace asperity {
namespace {

double shiftOrNaN(const TemperatureFit& fit, double temperature) {
  if (!fit.isDefined) return std::numeric_limits<double>::quiet_NaN();
  try {
    return log10ShiftFactor(fit.shift, temperature);
  } catch (const InputError&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace

std::string isothermsCsv(const Material& material) {
  std::string text =
      joinedColumns({"temperature", "frequency", "storage_modulus", "loss_modulus", "loss_tangent",
                     "reduced_frequency", "reduced_storage_modulus", "reduced_loss_modulus",
                     "fitted_storage_modulus", "fitted_loss_modulus"}) +
      "\n";
  for (std::size_t i = 0; i < material.isotherms.size(); ++i) {
    const IsothermShift& shift = material.curve.shifts[i];
    const double factor = std::pow(10, shift.log10Shift);
    const double vertical = std::pow(10, shift.log10Vertical);
    for (const DynamicModulus& point : material.isotherms[i].points) {
      const DynamicModulus fitted = modulusAt(material.series, point.frequency * factor);
      text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", shift.temperature, point.frequency,
                          point.storage, point.loss, point.loss / point.storage,
                          point.frequency * factor, point.storage / vertical, point.loss / vertical,
                          fitted.storage, fitted.loss);
    }
  }
  return text;
}

std::string shiftsCsv(const Material& material) {
  std::string text = joinedColumns({"temperature", "log10_shift", "log10_shift_standard_error",
                                    "log10_vertical_shift", "log10_shift_storage",
                                    "log10_shift_loss", "log10_shift_wlf", "log10_shift_arrhenius",
                                    "overlap_mismatch", "overlap_decades"}) +
                     "\n";
  for (std::size_t i = 0; i < material.curve.shifts.size(); ++i) {
    const IsothermShift& shift = material.curve.shifts[i];
    const bool hasNext = i < material.curve.overlaps.size();
    text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", shift.temperature, shift.log10Shift,
                        csvNumber(shift.standardError), shift.log10Vertical,
                        csvNumber(shift.fromStorage), csvNumber(shift.fromLoss),
                        csvNumber(shiftOrNaN(material.wlf, shift.temperature)),
                        csvNumber(shiftOrNaN(material.arrhenius, shift.temperature)),
                        hasNext ? csvNumber(material.curve.overlaps[i].mismatch) : "",
                        hasNext ? csvNumber(material.curve.overlaps[i].decades) : "");
  }
  return text;
}

std::string pronyCsv(const Material& material) {
  std::string text = joinedColumns({"relaxation_time", "modulus"}) + "\n";
  text += fmt::format(",{}\n", material.series.equilibriumModulus);
  for (const Arm& arm : material.series.arms)
    text += fmt::format("{},{}\n", arm.relaxationTime, arm.modulus);
  return text;
}

}  // namespace asperity
