// A fit as table, JSON and charts. Pure functions; equal fits give equal bytes.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "core/chart/curve_set.h"
#include "core/chart/diagram.h"
#include "core/fit/fit.h"

namespace asperity {

/// Values with their errors, correlations, combinations, profiles and notes.
nlohmann::ordered_json fitJson(const Fit& fit);

/// One row for each measured point: what was measured and what the fitted scene says there.
std::string fitCsv(const Fit& fit, std::span<const FrictionData> data);

/// "elastomer.shear_modulus = 1.02e7 Pa, 9.5e6 to 1.1e7".
Message fittedInWords(const FittedParameter& parameter);

/// The fitted curve with its band, the points and their residuals. `set`: the curve of the fitted
/// scene with the measured tables.
DiagramSheet fitSheet(const Fit& fit, const CurveSet& set);

/// The least sum of squares over each parameter: flat where the data leave it open.
DiagramSheet profileSheet(const Fit& fit);

}  // namespace asperity
