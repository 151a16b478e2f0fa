// What the page of a fit shows and saves: the values with errors as a table of rich text,
// the notes with the correlations, a diagram of the progress, and the report as files.
#pragma once

#include <QColor>
#include <QString>
#include <QStringList>
#include <span>
#include <string>

#include "core/chart/diagram.h"
#include "core/chart/fit_report.h"
#include "core/fit/fit.h"

namespace asperity {

/// Returns one row for each parameter: best value, its range, and whether the data determine it,
/// in the colour of warnings where they do not. This and the next two functions: GUI thread, whose
/// language they have.
QString fittedTable(const Fit& fit, const QColor& warning);

/// Returns the sum of squares, the correlations, the products that are determined where a single
/// parameter is not, and the notes of the fit with the names of the panel instead of keys; one line
/// each.
QString fittedNotes(const Fit& fit);

/// Returns the warnings of the fit with the names of the panel instead of keys.
QStringList fitWarnings(const Fit& fit);

/// Returns a diagram of the least sum of squares so far over the number of evaluations.
DiagramSheet progressSheet(std::span<const double> chiSquared);

/// Writes the report of a fit into the folder, which is made where it is missing: the files of
/// `asperity fit`, with the same bytes for the same fit. Returns their names. Any thread on which
/// no OpenGL context of the window is current, one at a time. Throws InputError for what cannot be
/// a folder, or where a file would replace a measured table, and as writeFileAtomically.
QStringList writeFitReport(const std::string& folder, const FittedCurve& fitted);

}  // namespace asperity
