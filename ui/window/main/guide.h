// The guide: one HTML file that is installed beside the program, or made in its build folder. It
// opens in the reader's own browser. GUI thread.
#pragma once

#include <QString>

namespace asperity {

/// Returns the guide of the program in this folder; empty where there is none.
QString guideFile(const QString& programFolder);

/// Opens the guide at an anchor ("eq-11"), or at its beginning. Returns the error message; empty on
/// success.
QString openGuideFile(const QString& programFolder, const QString& anchor = {});

}  // namespace asperity
