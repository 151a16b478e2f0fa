// The guide: one HTML file that is installed beside the program, or made in its build folder. It
// opens in the reader's own browser. GUI thread.
#pragma once

#include <QString>

namespace asperity {

/// Returns the guide of the program that lies in this folder; empty where there is none.
QString guideFile(const QString& programFolder);

/// Opens that guide, at an anchor of its page where one is given. Returns a sentence why not; empty
/// where it opens.
QString openGuideOf(const QString& programFolder, const QString& anchor = {});

}  // namespace asperity
