#include "ui/window/main/ask_file.h"

#include <QFileDialog>
#include <QRegularExpression>

namespace asperity {

namespace {

/// "png" of "Pictures (*.png *.svg)".
QString firstEnding(const QString& filter) {
  static const QRegularExpression ending(QStringLiteral(R"(\*\.(\w+))"));
  return ending.match(filter).captured(1);
}

}  // namespace

QString askSaveFile(QWidget* parent, const QString& title, const QString& name,
                    const QString& filters) {
  QFileDialog dialog(parent, title, {}, filters);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(firstEnding(filters));
  QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog,
                   [&](const QString& filter) { dialog.setDefaultSuffix(firstEnding(filter)); });
  dialog.selectFile(name);
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

}  // namespace asperity
