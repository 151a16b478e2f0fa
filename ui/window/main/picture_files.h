// Pictures of the window as images and files, drawn in the same way as the commands draw them, and
// the dialog for the name of a file. Images and files: any thread on which no OpenGL context of the
// window is current, one at a time. The dialog: GUI thread.
#pragma once

#include <QImage>
#include <QString>
#include <filesystem>
#include <memory>
#include <string>

#include "ui/contact/contact_picture.h"
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

/// A picture of the contact as it is on the screen, with its title.
struct ContactShot {
  std::shared_ptr<const Frame> frame;  // never null
  ContactPictureOptions options;
};

/// Returns the frame without the texts of a moving picture: the slow motion, and in steady sliding
/// the readings of the last steps.
std::shared_ptr<const Frame> stillCopy(const Frame& frame);

QImage renderContact(const ContactShot& shot);

/// Writes PNG, SVG or PDF, by the extension. Throws InputError for any other one, and as
/// writeFileAtomically.
void writePicture(const std::filesystem::path& file, const DrawList& picture,
                  const PictureProperties& properties);
void writeContact(const std::filesystem::path& file, const ContactShot& shot);

}  // namespace asperity
