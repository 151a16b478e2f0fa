// The analysis of a study as JSON, tables and charts. Pure; any thread.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/chart/diagram.h"
#include "core/study/study_analysis.h"

namespace asperity {

nlohmann::ordered_json analysisJson(const ParameterStudy& study, const StudyAnalysis& analysis);

/// Return tables with one row for each output and key (and part of its axis).
std::string indicesCsv(const ParameterStudy& study, const StudyAnalysis& analysis);
std::string effectsCsv(const ParameterStudy& study, const StudyAnalysis& analysis);
std::string percentilesCsv(const StudyAnalysis& analysis);

/// Returns "sensitivity" (of a Saltelli design), "correlation", and for each output "effects_NAME";
/// for each curve "band_NAME".
std::vector<NamedSheet> studySheets(const ParameterStudy& study, const StudyAnalysis& analysis);

/// Returns the name of an axis: its key, or "rows" for a table of several keys.
std::string axisName(const StudyAxis& axis);

}  // namespace asperity
