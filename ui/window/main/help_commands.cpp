#include "ui/window/main/help_commands.h"

#include <QCoreApplication>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QMainWindow>
#include <QMessageBox>
#include <QUrl>

#include "ui/window/main/commands.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/window_keys.h"

namespace asperity {

HelpCommands::HelpCommands(QMainWindow& window, MessageBar& messages)
    : QObject(&window), window_(window), messages_(messages) {}

void HelpCommands::addTo(Commands& commands) {
  commands.add({"shortcuts",
                [] { return tr("Keyboard shortcuts"); },
                [this] { showShortcuts(); },
                {Qt::Key_F1, Qt::Key_Question}});
  commands.add({"guide", [] { return tr("Guide"); }, [this] { openGuide({}); }});
  commands.add({"about", [] { return tr("About Asperity"); }, [this] { showAbout(); }});
}

void HelpCommands::showShortcuts() {
  auto* sheet = new ShortcutSheet(window_, &window_);
  sheet->setAttribute(Qt::WA_DeleteOnClose);
  sheet->open();
}

void HelpCommands::showAbout() {
  auto* box = new QMessageBox(&window_);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setWindowTitle(tr("About Asperity"));
  box->setText(tr("<h3>Asperity %1</h3>").arg(ASPERITY_VERSION));
  box->setInformativeText(
      tr("Shows how a viscoelastic elastomer slides over a randomly rough rigid line, after Li et "
         "al., <i>Friction between a viscoelastic body and a rigid surface with random self-affine "
         "roughness</i>, Physical Review Letters 111, 034301 (2013).<br><br>The elements of the "
         "elastomer are independent of each other: long-range elastic coupling is not in the "
         "model.<br><br>Free software, GPL-3.0-or-later."));
  box->open();
}

void HelpCommands::openGuide(const QString& anchor) {
  const LiveText reason = openGuideFile(QCoreApplication::applicationDirPath(), anchor);
  if (reason.isEmpty())
    messages_.end(MessageBar::Failure::Files);
  else
    messages_.showFailure(MessageBar::Failure::Files, reason);
}

QString guideFile(const QString& programFolder) {
  for (const char* path : {"../share/asperity/guide.html", "../resources/guide/guide.html"}) {
    const QFileInfo file(QDir(programFolder).filePath(QString::fromLatin1(path)));
    if (file.isFile() && file.isReadable()) return file.canonicalFilePath();
  }
  return {};
}

LiveText openGuideFile(const QString& programFolder, const QString& anchor) {
  const QString file = guideFile(programFolder);
  if (file.isEmpty())
    return [] {
      return HelpCommands::tr(
          "The guide is not part of this build. Its text is in resources/guide.");
    };
  QUrl path = QUrl::fromLocalFile(file);
  if (!anchor.isEmpty()) path.setFragment(anchor);
  if (!QDesktopServices::openUrl(path))
    return [file] {
      return HelpCommands::tr("No browser opens the guide; it is the file %1.")
          .arg(QDir::toNativeSeparators(file));
    };
  return {};
}

}  // namespace asperity
