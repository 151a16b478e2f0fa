// The analysis of a study as charts. Pure; any thread.
#pragma once

#include <string>
#include <vector>

#include "core/chart/diagram.h"
#include "core/chart/material_sheets.h"
#include "core/study/study_analysis.h"

namespace asperity {

/// Returns "sensitivity" (of a Saltelli design), "correlation", and for each output "effects_NAME";
/// for each curve "band_NAME".
std::vector<NamedSheet> studySheets(const ParameterStudy& study, const StudyAnalysis& analysis);

}  // namespace asperity
