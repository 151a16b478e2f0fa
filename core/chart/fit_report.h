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
#include "core/fit/fit.h"

namespace asperity {

/// Returns the range of a value, "9.5 MPa to 11 MPa": one standard error to each side, or further
/// out where the profile says so. Everything that shows an error of a value shows this one.
Message rangeOf(const FittedParameter& parameter);

/// Returns values with their errors, correlations, combinations, profiles and notes.
nlohmann::ordered_json fitJson(const Fit& fit);

/// Returns one row for each measured point: the measured friction and that of the fitted scene.
std::string fitCsv(const Fit& fit, std::span<const FrictionData> data);

/// Returns a summary line by line: "elastomer.shear_modulus = 1.02e7 Pa, 9.5e6 to 1.1e7", the
/// meaning of these ranges, the distance of the points from the curve, and the notes.
std::vector<Message> describeFit(const Fit& fit);

/// Returns the fitted curve with its band, the points and their residuals. Where there is local
/// friction, the band is around the curve that has it. set: the curve of the fitted scene with the
/// measured tables.
DiagramSheet fitSheet(const Fit& fit, const CurveSet& set);

/// Returns the minimum of the sum of squares over each parameter, in units of the squared errors of
/// the points (fit.h: times errorScale): flat where the data do not determine it.
DiagramSheet profileSheet(const Fit& fit);

/// Returns the provenance of the fitted scene, with the original scene as "start".
nlohmann::ordered_json fitProvenance(const Scene& start, const Fit& fit);

/// Returns the options of the command `asperity fit` that make this fit, for its provenance.
/// varied: as a user wrote them.
nlohmann::ordered_json fitOptions(const std::vector<std::string>& varied, bool hasProfiles);

/// Returns the text of fit.json. reading: how the file of the surface was read (readingFacts).
/// varied: as a user wrote them.
std::string fitAnswer(const Scene& start, const std::vector<Message>& reading, const Fit& fit,
                      const std::vector<std::string>& varied);

/// A fit with everything in its report.
struct FittedCurve {
  Scene start;  // that was fitted
  Fit fit;
  CurveSet set;                     // the curve of the fitted scene with the measured tables
  std::vector<std::string> varied;  // as a user wrote them: "KEY" or "KEY=LOW:HIGH"
  bool hasProfiles = true;          // whether they were requested
};

/// Fits the scene to the tables that it names (readComparisonData) and computes the curve of the
/// fitted scene. Throws as fitFriction, and InputError where the scene moves or has a target in
/// place of a number of lines.
FittedCurve fitWithCurve(const Scene& scene, const std::vector<FrictionData>& data,
                         std::span<const VariedParameter> parameters, const FitOptions& options);

/// The files of a report in one folder.
struct FitReport {
  std::vector<std::pair<std::string, std::string>> texts;  // names and bytes, the summary first
  std::vector<Message> reading;    // how the file of the surface was read (readingFacts)
  std::vector<NamedSheet> sheets;  // each is a picture of several formats
};

/// Makes the report. folder: of its files, from which the fitted scene names its own.
FitReport fitReport(const FittedCurve& fitted, const std::string& folder);

}  // namespace asperity
