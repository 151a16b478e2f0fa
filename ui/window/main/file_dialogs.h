// The dialogs in which the user names files to open or to save, the questions before files are
// replaced or changes are lost, and the folder in which the dialogs begin. GUI thread.
#pragma once

#include <QFileDialog>
#include <QMessageBox>
#include <QString>
#include <QStringList>

namespace asperity {

/// Asks the user for a file to write; returns an empty text where none was chosen. A name without
/// an extension gets the first one of the chosen filter, before the dialog asks whether an existing
/// file may be replaced; it does not ask without `asksToReplace`. `name` is proposed, with a folder
/// or in that of the file saved last; `filters` as for QFileDialog, separated by ";;".
QString askSaveFile(QWidget* parent, const QString& title, const QString& name,
                    const QString& filters, bool asksToReplace = true);

/// These functions ask the user for a file to read, or for several, and return nothing where none
/// was chosen. The dialog begins in the folder `place`, or with that file selected.
QString askOpenFile(QWidget* parent, const QString& title, const QString& place,
                    const QString& filters, QFileDialog::Options options = {});
QStringList askOpenFiles(QWidget* parent, const QString& title, const QString& place,
                         const QString& filters);

/// Returns the filter of the pictures that the window writes.
QString pictureFilter();
/// Asks for a file for such a picture, as askSaveFile() does.
QString askPictureFile(QWidget* parent, const QString& name);
/// Returns "Saved contact.png", without the folder.
QString savedText(const QString& file);

/// Asks whether unsaved changes are to be saved, in plain text: Save, Discard or Cancel. name: of
/// the dialog as an object.
using SaveAnswer = QMessageBox::StandardButton;
SaveAnswer askSaveChanges(QWidget* parent, const QString& name, const QString& title,
                          const QString& question, const QString& explanation = {});

/// Asks whether files may be replaced.
bool askReplace(QWidget* parent, const QString& title, const QString& question);

/// Returns the folder in which a file is looked for or proposed: that of the document's file, or
/// where it has none that of the file opened or saved last, or the home folder.
QString proposedFolder(const QString& document = {});

/// Keeps the folder of a file that was opened or saved for proposedFolder().
void rememberFolder(const QString& file);

}  // namespace asperity
