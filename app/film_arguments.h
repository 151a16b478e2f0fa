// How ffmpeg is asked for a film: one thread and no date anywhere, so that the bytes follow from
// the pictures alone. Pure.
#pragma once

#include <string>
#include <vector>

#include "app/film_file.h"

namespace asperity {

/// Of the program itself first. Pictures come in RGBA by its standard input. extension: ".gif".
std::vector<std::string> ffmpegArguments(const std::string& extension, const FilmOptions& options,
                                         const std::string& output);

}  // namespace asperity
