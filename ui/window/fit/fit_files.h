// The report of a fit as files: those of `asperity fit`, with the same bytes for the same fit.
// Any thread on which no OpenGL context of the window is current, one at a time.
#pragma once

#include <QStringList>
#include <string>

#include "core/chart/fit_report.h"

namespace asperity {

/// Writes into the folder, which is made where it is missing; returns the names of the files.
/// Throws InputError for what cannot be a folder, or where a file would replace a measured table,
/// and as writeFileAtomically.
QStringList writeFitReport(const std::string& folder, const FittedCurve& fitted);

}  // namespace asperity
