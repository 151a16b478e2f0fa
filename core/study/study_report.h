// The analysis of a study as tables and JSON; study_sheets.h has it as charts. Pure; any thread.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/study/study_analysis.h"

namespace asperity {

/// Half of a 95 % confidence interval, in standard errors of a jackknife over 20 groups: Student's
/// t with 19 degrees of freedom.
inline constexpr double kHalfInterval = 2.093;

nlohmann::ordered_json analysisJson(const ParameterStudy& study, const StudyAnalysis& analysis);
/// Return tables with one row for each output and key (and part of its axis).
std::string indicesCsv(const ParameterStudy& study, const StudyAnalysis& analysis);
std::string effectsCsv(const ParameterStudy& study, const StudyAnalysis& analysis);
std::string percentilesCsv(const StudyAnalysis& analysis);

/// Returns the name of an axis: its key, or "rows" for a table of several keys.
std::string axisName(const StudyAxis& axis);

}  // namespace asperity
