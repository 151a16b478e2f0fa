#include "ui/window/main/guide.h"

#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QUrl>

#include "ui/window/main/message_bar.h"

namespace asperity {

QString guideFile(const QString& programFolder) {
  for (const char* path : {"../share/asperity/guide.html", "../resources/guide/guide.html"}) {
    const QFileInfo file(QDir(programFolder).filePath(QString::fromLatin1(path)));
    if (file.isFile() && file.isReadable()) return file.canonicalFilePath();
  }
  return {};
}

QString openGuideFile(const QString& programFolder, const QString& anchor) {
  const QString file = guideFile(programFolder);
  if (file.isEmpty())
    return MessageBar::tr("The guide is not part of this build. Its text is in resources/guide.");
  QUrl path = QUrl::fromLocalFile(file);
  if (!anchor.isEmpty()) path.setFragment(anchor);
  if (!QDesktopServices::openUrl(path))
    return MessageBar::tr("No browser opens the guide; it is the file %1.")
        .arg(QDir::toNativeSeparators(file));
  return {};
}

}  // namespace asperity
