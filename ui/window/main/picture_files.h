// The dialog for the name of a file that is saved, and pictures as files, drawn in the same way as
// the commands draw them. The dialog: GUI thread. Files: any thread on which no OpenGL context of
// the window is current, one at a time.
#pragma once

#include <QString>
#include <filesystem>

#include "ui/draw/draw_list.h"
#include "ui/draw/png_file.h"

class QWidget;

namespace asperity {

/// Asks the user for a file to write; returns an empty text where none was chosen. A name without
/// an extension gets the first one of the chosen filter, before the dialog asks whether an existing
/// file may be replaced; it does not ask without `asksToReplace`. `name` is proposed, with a folder
/// or in that of the file saved last; `filters` as for QFileDialog, separated by ";;".
QString askSaveFile(QWidget* parent, const QString& title, const QString& name,
                    const QString& filters, bool asksToReplace = true);

/// Returns the folder in which a file is looked for or proposed: that of the document's file, or
/// where it has none that of the file opened or saved last, or the home folder.
QString proposedFolder(const QString& document = {});

/// Keeps the folder of a file that was opened or saved for proposedFolder().
void rememberFolder(const QString& file);

/// Writes PNG, SVG or PDF, by the extension. Throws InputError for any other one, and as
/// writeFileAtomically.
void writePicture(const std::filesystem::path& file, const DrawList& picture,
                  const PictureProperties& properties);

}  // namespace asperity
