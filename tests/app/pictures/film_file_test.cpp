// A film's colours, as ffmpeg reads them back; what it says of itself, however long; and programs
// under the name of ffmpeg that make no film.
#include "app/pictures/film_file.h"

#include <gtest/gtest.h>

#include <QColor>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

using namespace std::string_literals;

constexpr int kSize = 64, kFrames = 40;

/// Grey shades, and from the middle of the film on red ones.
QImage frame(int index) {
  QImage image(kSize, kSize, QImage::Format_RGBA8888_Premultiplied);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const int shade = 4 * x;
      image.setPixelColor(x, y,
                          index < kFrames / 2 ? QColor(shade, shade, shade) : QColor(shade, 0, 0));
    }
  return image;
}

/// The last picture of the film, RGB; its size says how many there are.
std::string lastPicture(const TemporaryFolder& folder) {
  const std::string line = "cd '" + folder.path().string() +
                           "' && ffmpeg -v error -i a.gif -pix_fmt rgb24 -f rawvideo all";
  EXPECT_EQ(std::system(line.c_str()), 0);
  const std::string all = TemporaryFolder::read(folder / "all");
  constexpr std::size_t kBytes = 3 * kSize * kSize;
  EXPECT_EQ(all.size(), kBytes * kFrames);
  return all.size() < kBytes ? std::string(kBytes, '\0') : all.substr(all.size() - kBytes);
}

TEST(FilmFile, AGifHasTheColoursOfItsSamplesAndNotTheirPictures) {
  const TemporaryFolder folder;
  FilmOptions options;
  options.width = options.height = kSize;
  options.samples = 3;
  FilmFile film((folder / "a.gif").string(), options);
  for (const int index : {0, kFrames / 2, kFrames - 1}) film.add(frame(index));
  for (int index = 0; index < kFrames; ++index) film.add(frame(index));
  film.finish();
  const std::string picture = lastPicture(folder);
  for (std::size_t x = 8; x < kSize; x += 8) {
    const auto* pixel = reinterpret_cast<const unsigned char*>(&picture[3 * (x + 20 * kSize)]);
    EXPECT_NEAR(pixel[0], 4 * static_cast<int>(x), 12) << x;
    EXPECT_LT(pixel[1], 12) << x;
  }
}

FilmOptions smallFilm() {
  FilmOptions options;
  options.width = options.height = kSize;
  return options;
}

void writeFilm(const std::filesystem::path& file, const FilmOptions& options) {
  FilmFile film(file.string(), options);
  for (int index = 0; index < 3 + options.samples * (file.extension() == ".gif" ? 1 : 0); ++index)
    film.add(frame(index % 2 * (kFrames - 1)));
  film.finish();
}

/// An argument of a program may have 128 KiB: what a film says of itself is no argument.
TEST(FilmFile, ALongTitleAndOddCharactersArriveWhole) {
  const TemporaryFolder folder;
  FilmOptions options = smallFilm();
  const std::string odd = "a=b; #c \\ d\r\ne [f] \u00fc";
  options.title = odd + std::string(300000, 't') + odd;
  options.metadata =
      R"({"schema":"asperity-render/1","x":"\u003c=;#\\)" + std::string(300000, 'm') + "\"}";
  for (const char* name : {"a.mp4", "a.webm"}) {
    writeFilm(folder / name, options);
    const std::string bytes = TemporaryFolder::read(folder / name);
    EXPECT_NE(bytes.find(options.metadata), std::string::npos) << name;
    EXPECT_NE(bytes.find(options.title), std::string::npos) << name;
  }
  for (const char* name : {"a.gif", "a.webp"}) {
    writeFilm(folder / name, options);
    EXPECT_NE(TemporaryFolder::read(folder / name).find(std::string(300000, 'm')),
              std::string::npos)
        << name;
  }
}

/// A zero in a title ends no line that a key could follow.
TEST(FilmFile, ATitleCannotForgeMetadata) {
  const TemporaryFolder folder;
  FilmOptions options = smallFilm();
  options.title = "t\0comment=forged\n;FFMETADATA1\ncomment=forged"s;
  options.metadata = "true";
  writeFilm(folder / "a.mp4", options);
  const std::string line = "cd '" + folder.path().string() +
                           "' && ffprobe -v error -show_entries format_tags=comment -of "
                           "default=nw=1:nk=1 a.mp4 >said";
  ASSERT_EQ(std::system(line.c_str()), 0);
  EXPECT_EQ(TemporaryFolder::read(folder / "said"), "true\n");
}

/// Whatever ends well without a film: the last film stays.
TEST(FilmFile, AnFfmpegThatMakesNoFilmIsAFailureAndTheOldFilmStays) {
  const TemporaryFolder folder;
  const std::string path = std::getenv("PATH");
  for (const char* program : {"cat >/dev/null", "exit 0", "cat >/dev/null; printf 'no film' >&3",
                              "cat >/dev/null; exit 1", "cat >/dev/null; kill -9 $$"})
    for (const char* name : {"a.mp4", "a.webm", "a.gif", "a.webp"}) {
      folder.write("ffmpeg", std::string("#!/bin/sh\n") + program + "\n");
      std::filesystem::permissions(folder / "ffmpeg", std::filesystem::perms::owner_all);
      folder.write(name, "the old film");
      ::setenv("PATH", (folder.path().string() + ":" + path).c_str(), 1);
      EXPECT_THROW(writeFilm(folder / name, smallFilm()), std::runtime_error) << name << program;
      ::setenv("PATH", path.c_str(), 1);
      EXPECT_EQ(TemporaryFolder::read(folder / name), "the old film") << name << program;
    }
  EXPECT_EQ(folder.names().size(), 5U);
}

/// The sides of an mp4 are even: where those of the pictures are odd, the background goes on.
TEST(FilmFile, AnMp4OfOddSidesHasNoBlackEdge) {
  const TemporaryFolder folder;
  FilmOptions options;
  options.width = 65;
  options.height = 49;
  QImage picture(options.width, options.height, QImage::Format_RGBA8888_Premultiplied);
  picture.fill(QColor(240, 240, 240));
  FilmFile film((folder / "a.mp4").string(), options);
  for (int i = 0; i < 3; ++i) film.add(picture);
  film.finish();
  const std::string line = "cd '" + folder.path().string() +
                           "' && ffmpeg -v error -i a.mp4 -pix_fmt gray -f rawvideo all";
  ASSERT_EQ(std::system(line.c_str()), 0);
  const std::string all = TemporaryFolder::read(folder / "all");
  ASSERT_EQ(all.size(), 3U * 66 * 50);
  for (const char shade : all) ASSERT_GT(static_cast<unsigned char>(shade), 230);
}

}  // namespace
}  // namespace asperity
