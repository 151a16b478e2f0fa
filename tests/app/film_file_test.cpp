// A film's colours, as ffmpeg reads them back.
#include "app/film_file.h"

#include <gtest/gtest.h>

#include <QColor>
#include <cstdlib>

#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

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

}  // namespace
}  // namespace asperity
