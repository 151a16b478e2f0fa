// A fit in words for the window: its values with errors and correlations as a table of rich text,
// its notes, how far it has come. Pure; GUI thread (the language may change).
#pragma once

#include <QString>
#include <span>

#include "core/chart/diagram.h"
#include "core/fit/fit.h"

namespace asperity {

/// Returns one row for each parameter: best value, standard error, whether the data determine it,
/// and its correlations with the others.
QString fittedTable(const Fit& fit);

/// Returns the sum of squares, the products that are determined where a single parameter is not,
/// and the notes of the fit with the names of the panel instead of keys; one line each.
QString fittedNotes(const Fit& fit);

/// Returns a diagram of the sums of squares so far over the number of evaluations.
DiagramSheet progressSheet(std::span<const double> chiSquared);

}  // namespace asperity
