#include "ui/window/main/picture_files.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QRegularExpression>
#include <QSettings>

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "ui/draw/fonts.h"
#include "ui/draw/pdf_file.h"
#include "ui/draw/pixel_context.h"
#include "ui/draw/svg_file.h"

namespace asperity {

namespace {

/// Returns the first extension of a filter: "png" of "Pictures (*.png *.svg)".
QString firstExtension(const QString& filter) {
  static const QRegularExpression pattern(QStringLiteral(R"(\*\.(\w+))"));
  return pattern.match(filter).captured(1);
}

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

void writePicture(const std::filesystem::path& file, const DrawList& picture,
                  const PictureProperties& properties) {
  const std::string extension = file.extension().string();
  if (extension == ".png") {
    checkWritable(file);
    writePng(file, renderImage(contextOfThread(), picture),
             {properties.title, properties.metadata, 96 * properties.scale});
  } else if (extension == ".svg") {
    writeSvg(file, picture, {properties.title, properties.metadata});
  } else if (extension == ".pdf") {
    writePdf(file, picture, {properties.title, properties.metadata, 0.75 / properties.scale});
  } else {
    throw unknownExtension(file.string(), extension, {".png", ".svg", ".pdf"});
  }
}

}  // namespace asperity
