#include "ui/window/main/guide.h"

#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QUrl>

#include "ui/window/main/message_bar.h"

namespace asperity {

QString guideFile(const QString& programFolder) {
  for (const char* place : {"../share/asperity/guide.html", "../resources/guide/guide.html"}) {
    const QFileInfo file(QDir(programFolder).filePath(QString::fromLatin1(place)));
    if (file.isFile() && file.isReadable()) return file.canonicalFilePath();
  }
  return {};
}

QString openGuideOf(const QString& programFolder, const QString& anchor) {
  const QString file = guideFile(programFolder);
  if (file.isEmpty())
    return MessageBar::tr(
        "The guide is not here: it is built with the program where pandoc is installed. Its pages "
        "can be read in the folder resources/guide of the sources.");
  QUrl page = QUrl::fromLocalFile(file);
  if (!anchor.isEmpty()) page.setFragment(anchor);
  if (!QDesktopServices::openUrl(page))
    return MessageBar::tr("No browser opens the guide; it is the file %1.")
        .arg(QDir::toNativeSeparators(file));
  return {};
}

}  // namespace asperity
