// Pictures of the window as images and files, drawn as the headless commands draw them, and the
// question where a file is to be written. Images and files: any thread on which no OpenGL context
// of the window is current, one at a time. The question: GUI thread.
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

/// Asks a user for a file to write; empty where none was chosen. A name without an ending gets
/// the first one of the filter that is chosen in the dialog, before it is asked whether the file
/// may be replaced. `name` is proposed, with or without a folder; `filters` as for QFileDialog,
/// separated by ";;".
QString askSaveFile(QWidget* parent, const QString& title, const QString& name,
                    const QString& filters);

/// The contact as it is on the screen, under its title.
struct ContactShot {
  std::shared_ptr<const Frame> frame;  // never null
  ContactPictureOptions options;
};

/// Without what is said of a picture that moves: how fast its time passes on the screen, and in
/// steady sliding what its last steps read.
std::shared_ptr<const Frame> stillOf(const Frame& frame);

QImage imageOf(const ContactShot& shot);

/// Write PNG, SVG or PDF, by the extension; InputError for any other, and as writeFileAtomically.
void writePicture(const std::filesystem::path& file, const DrawList& picture,
                  const PictureProperties& properties);
void writeContact(const std::filesystem::path& file, const ContactShot& shot);

}  // namespace asperity
