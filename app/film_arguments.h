// How ffmpeg is asked for a film: one thread and no date anywhere, so that the bytes follow from
// the pictures alone. Pure.
#pragma once

#include <string>
#include <vector>

#include "app/film_file.h"

namespace asperity {

/// Of the program itself first. Pictures come in RGBA by its standard input. extension: ".gif".
/// metadata: the file of filmMetadata, or empty.
std::vector<std::string> ffmpegArguments(const std::string& extension, const FilmOptions& options,
                                         const std::string& output, const std::string& metadata);

/// Title and metadata of a film as a file that ffmpeg reads: an argument has a length that it may
/// not exceed. Empty where the format takes none from ffmpeg, or there is nothing to say.
std::string filmMetadata(const std::string& extension, const FilmOptions& options);

}  // namespace asperity
