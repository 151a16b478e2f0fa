#include "ui/window/main/recent_files.h"

#include <QFileInfo>
#include <QSettings>

namespace asperity {

namespace {

const QString kKey = QStringLiteral("recentFiles");

}  // namespace

QStringList recentFiles() {
  QStringList files = QSettings().value(kKey).toStringList();
  files.removeIf([](const QString& file) { return !QFileInfo::exists(file); });
  return files;
}

void addRecentFile(const QString& file) {
  const QString path = QFileInfo(file).absoluteFilePath();
  QStringList files = recentFiles();
  files.removeAll(path);
  files.prepend(path);
  QSettings().setValue(kKey, files.mid(0, kMostRecentFiles));
}

void clearRecentFiles() {
  QSettings().remove(kKey);
}

}  // namespace asperity
