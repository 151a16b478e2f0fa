// Pictures as EPS, which some publishers still require: the program's own PDF, turned into
// PostScript by pdftops (poppler-utils). Letters and lines stay vectors; translucent colours become
// opaque ones, and a picture with light that fades out becomes an image. Main thread.
#pragma once

#include <string>

#include "ui/draw/picture_file.h"

namespace asperity {

/// Throws InputError where pdftops is not installed.
void checkEpsTool(const std::string& file);

/// Writes the file, complete or not at all. The metadata are in comments "%asperity: ..." after the
/// header. Throws std::runtime_error in one sentence that names the file.
void writeEps(const std::string& file, const DrawList& list, const PictureProperties& properties);

}  // namespace asperity
