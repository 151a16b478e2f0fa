// Films. The pictures go to ffmpeg, which runs as a separate process and encodes them as mp4, webm,
// gif or animated webp. The same pictures give the same bytes on the same machine.
// Ownership: one film; made, fed and finished by one thread at a time.
// Failure: std::runtime_error in one sentence. The film file is complete or absent: ffmpeg writes
// into an unnamed file, which gets its name at the end.
#pragma once

#include <QImage>
#include <memory>
#include <string>

namespace asperity {

struct FilmOptions {
  int width = 0, height = 0;  // pixels of every picture
  double framesPerSecond = 25;
  bool transparent = false;
  int samples = 1;       // of a gif: pictures added before the film; their colours give its palette
  std::string title;     // empty: none
  std::string metadata;  // one line of ASCII without markup; empty: none
};

/// Returns whether a file is a film by its extension: .mp4, .webm, .gif or .webp.
bool isFilmFile(const std::string& file);

/// Throws where no ffmpeg can be run, and InputError where films of this kind cannot be
/// transparent. Call it before long work.
void checkFilm(const std::string& file, bool transparent);

class FilmFile {
 public:
  FilmFile(const std::string& file, const FilmOptions& options);
  ~FilmFile();  // an unfinished film leaves no file
  FilmFile(const FilmFile&) = delete;
  FilmFile& operator=(const FilmFile&) = delete;

  void add(const QImage& image);

  /// Waits for ffmpeg and gives the film its name.
  void finish();

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace asperity
