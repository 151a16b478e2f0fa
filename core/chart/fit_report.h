// A fit as table, JSON and charts, and the files of its report. Pure functions, except for
// fitWithCurve, which computes with several threads; equal fits give equal bytes.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/chart/curve_set.h"
#include "core/chart/diagram.h"
#include "core/chart/material_sheets.h"
#include "core/fit/fit.h"

namespace asperity {

/// Values with their errors, correlations, combinations, profiles and notes.
nlohmann::ordered_json fitJson(const Fit& fit);

/// One row for each measured point: what was measured and what the fitted scene says there.
std::string fitCsv(const Fit& fit, std::span<const FrictionData> data);

/// What a person reads first, line by line: "elastomer.shear_modulus = 1.02e7 Pa, 9.5e6 to 1.1e7",
/// what these ranges are, how far the points lie from the curve, and the notes.
std::vector<Message> describeFit(const Fit& fit);

/// The fitted curve with its band, the points and their residuals. `set`: the curve of the fitted
/// scene with the measured tables.
DiagramSheet fitSheet(const Fit& fit, const CurveSet& set);

/// The least sum of squares over each parameter, in the squares of the points' errors (fit.h: times
/// errorScale): flat where the data leave it open.
DiagramSheet profileSheet(const Fit& fit);

/// The provenance of a fit: that of the fitted scene, and as "start" the scene that was fitted.
nlohmann::ordered_json fitProvenance(const Scene& start, const Fit& fit);

/// The options of the command `asperity fit` that make this fit, for its provenance. varied: as a
/// user wrote them.
nlohmann::ordered_json fitOptions(const std::vector<std::string>& varied, bool hasProfiles);

/// The text of fit.json. varied: as a user wrote them.
std::string fitAnswer(const Scene& start, const Fit& fit, const std::vector<std::string>& varied);

/// A fit with everything that its report shows.
struct FittedCurve {
  Scene start;  // that was fitted
  Fit fit;
  CurveSet set;                     // the curve of the fitted scene with the measured tables
  std::vector<std::string> varied;  // as a user wrote them: "KEY" or "KEY=LOW:HIGH"
  bool hasProfiles = true;          // were wanted
};

/// Fits the scene to the tables that it names (readComparisonData) and computes the curve of the
/// fitted scene. Throws as fitFriction, and InputError where the scene moves or has a target in
/// place of a number of lines.
FittedCurve fitWithCurve(const Scene& scene, const std::vector<FrictionData>& data,
                         std::span<const VariedParameter> parameters, const FitOptions& options);

/// The files of a report in one folder.
struct FitReport {
  std::vector<std::pair<std::string, std::string>> texts;  // names and bytes; the first says most
  std::vector<NamedSheet> sheets;                          // each is a picture of several formats
};

/// `folder`: where the files will stand, from which the fitted scene names its own.
FitReport fitReport(const FittedCurve& fitted, const std::string& folder);

}  // namespace asperity
