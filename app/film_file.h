// Films: pictures handed to ffmpeg, which runs as a program of its own and encodes them as mp4,
// webm, gif or animated webp. The same pictures give the same bytes on the same machine.
// Ownership: one film; made, fed and finished by one thread at a time.
// Failure: std::runtime_error in one sentence. The file is whole or not there: ffmpeg writes into a
// file without a name, which gets its name at the end.
#pragma once

#include <QImage>
#include <memory>
#include <string>
#include <vector>

namespace asperity {

struct FilmOptions {
  int width = 0, height = 0;  // pixels of every picture
  double framesPerSecond = 25;
  bool transparent = false;
  int samples = 1;       // of a gif: pictures added before the film, whose colours are its palette
  std::string title;     // empty: none
  std::string metadata;  // one line of ASCII without markup; empty: none
};

/// Returns the arguments of ffmpeg, its own name first. It reads pictures in RGBA from its standard
/// input. extension: ".gif".
/// metadata: the file of filmMetadata, or empty.
std::vector<std::string> ffmpegArguments(const std::string& extension, const FilmOptions& options,
                                         const std::string& output, const std::string& metadata);

/// Title and metadata of a film as a file that ffmpeg reads: an argument has a length that it may
/// not exceed. Empty where the format takes none from ffmpeg, or there is nothing to say.
std::string filmMetadata(const std::string& extension, const FilmOptions& options);

/// Whether the extension is one of .mp4, .webm, .gif, .webp.
bool isFilm(const std::string& extension);

/// Throws where there is no ffmpeg to be run, and InputError where the kind of film cannot be
/// transparent. Call before long work.
void checkFilm(const std::string& file, bool transparent);

class FilmFile {
 public:
  FilmFile(const std::string& file, const FilmOptions& options);
  ~FilmFile();  // not finished: nothing is left
  FilmFile(const FilmFile&) = delete;
  FilmFile& operator=(const FilmFile&) = delete;

  void add(const QImage& image);

  /// Waits for ffmpeg and gives the film its name.
  void finish();

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

/// The bytes of a film with an XMP packet inside, in the place that the format has for one.
std::string gifWithXmp(const std::string& gif, const std::string& packet);
std::string webpWithXmp(const std::string& webp, const std::string& packet);

}  // namespace asperity
