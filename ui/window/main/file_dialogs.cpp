#include "ui/window/main/file_dialogs.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QSettings>

#include "ui/panels/controls.h"

namespace asperity {

namespace {

/// Returns the first extension of a filter: "png" of "Pictures (*.png *.svg)".
QString firstExtension(const QString& filter) {
  static const QRegularExpression pattern(QStringLiteral(R"(\*\.(\w+))"));
  return pattern.match(filter).captured(1);
}

struct FileDialogs {
  Q_DECLARE_TR_FUNCTIONS(asperity::FileDialogs)
};

const QString kLastFolder = QStringLiteral("files/saveFolder");

}  // namespace

QString proposedFolder(const QString& document) {
  if (const QFileInfo file(document); !document.isEmpty() && file.absoluteDir().exists())
    return file.absolutePath();
  const QString last = QSettings().value(kLastFolder).toString();
  return !last.isEmpty() && QFileInfo(last).isDir() ? last : QDir::homePath();
}

void rememberFolder(const QString& file) {
  if (!file.isEmpty()) QSettings().setValue(kLastFolder, QFileInfo(file).absolutePath());
}

QString askSaveFile(QWidget* parent, const QString& title, const QString& name,
                    const QString& filters, bool asksToReplace) {
  QFileDialog dialog(parent, title, proposedFolder(), filters);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setOption(QFileDialog::DontConfirmOverwrite, !asksToReplace);
  dialog.setDefaultSuffix(firstExtension(filters));
  QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog,
                   [&](const QString& filter) { dialog.setDefaultSuffix(firstExtension(filter)); });
  dialog.selectFile(name);
  if (dialog.exec() != QDialog::Accepted) return {};
  const QString file = dialog.selectedFiles().value(0);
  rememberFolder(file);
  return file;
}

QString pictureFilter() {
  return FileDialogs::tr("Pictures (*.png *.svg *.pdf)");
}

QString askPictureFile(QWidget* parent, const QString& name) {
  return askSaveFile(parent, FileDialogs::tr("Save picture"), name, pictureFilter());
}

QString savedText(const QString& file) {
  return FileDialogs::tr("Saved %1").arg(QFileInfo(file).fileName());
}

QString askOpenFile(QWidget* parent, const QString& title, const QString& place,
                    const QString& filters, QFileDialog::Options options) {
  const QString file =
      QFileDialog::getOpenFileName(parent, title, place, filters, nullptr, options);
  rememberFolder(file);
  return file;
}

QStringList askOpenFiles(QWidget* parent, const QString& title, const QString& place,
                         const QString& filters) {
  const QStringList files = QFileDialog::getOpenFileNames(parent, title, place, filters);
  rememberFolder(files.value(0));
  return files;
}

SaveAnswer askSaveChanges(QWidget* parent, const QString& name, const QString& title,
                          const QString& question, const QString& explanation) {
  return ask(parent, {name, title, question, explanation},
             {{QMessageBox::Save, FileDialogs::tr("&Save")},
              {QMessageBox::Discard, FileDialogs::tr("&Discard")},
              {QMessageBox::Cancel, FileDialogs::tr("&Cancel")}},
             QMessageBox::Save);
}

bool askReplace(QWidget* parent, const QString& title, const QString& question) {
  return ask(parent, {"replaceQuestion", title, question},
             {{QMessageBox::Yes, FileDialogs::tr("&Replace")},
              {QMessageBox::Cancel, FileDialogs::tr("&Cancel")}},
             QMessageBox::Cancel) == QMessageBox::Yes;
}

}  // namespace asperity
