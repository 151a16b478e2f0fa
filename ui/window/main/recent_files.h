// The files opened or saved last, kept in the user's settings. GUI thread. Files that are not there
// any more are left out.
#pragma once

#include <QStringList>

namespace asperity {

inline constexpr int kMostRecentFiles = 8;

/// The newest first; absolute paths.
QStringList recentFiles();

void addRecentFile(const QString& file);
void clearRecentFiles();

}  // namespace asperity
