#include "ui/draw/picture_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <random>
#include <stdexcept>

#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

class PngFile : public testing::Test {
 protected:
  TemporaryFolder folder_;
};

/// Noise, so that it does not compress.
QImage picture(int size) {
  QImage image(size, size, QImage::Format_RGBA8888_Premultiplied);
  std::mt19937 random(1);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) image.setPixel(x, y, 0xFF000000U | (random() & 0xFFFFFFU));
  return image;
}

std::string failure(const fs::path& path, const QImage& image) {
  try {
    writePng(path, image, {});
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

/// While it lives, no file may grow beyond `bytes`: writes fail as on a full disk.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &limit_);
    rlimit small = limit_;
    small.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &limit_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit limit_{};
};

TEST_F(PngFile, IsReadBackAsItWas) {
  const fs::path path = folder_ / "a picture \u00B5.png";
  writePng(path, picture(40), {});
  QImage back;
  ASSERT_TRUE(back.load(QString::fromStdString(path.string())));
  EXPECT_EQ(back.convertToFormat(QImage::Format_ARGB32),
            picture(40).convertToFormat(QImage::Format_ARGB32));
  EXPECT_EQ(folder_.names().size(), 1U);
}

TEST_F(PngFile, KeepsTransparencyTextsAndDensity) {
  QImage image = picture(30);
  image.setPixel(3, 4, 0x80402010U);
  const std::string metadata = "{\"title\": \"\u00B5 of a line\"}";
  const std::string bytes = encodePng(image, {"A title", metadata, 2});
  EXPECT_EQ(pngMetadata(bytes), metadata);
  const QImage back = QImage::fromData(QByteArray::fromStdString(bytes), "PNG");
  EXPECT_EQ(back.convertToFormat(QImage::Format_ARGB32),
            image.convertToFormat(QImage::Format_ARGB32));
  EXPECT_EQ(back.text("asperity").toStdString(), metadata);
  EXPECT_EQ(back.text("Title"), "A title");
  EXPECT_NEAR(back.dotsPerMeterX() * 0.0254, 192, 0.02);
}

TEST_F(PngFile, MetadataIsEmptyWhereThereIsNone) {
  EXPECT_EQ(pngMetadata(encodePng(picture(3))), "");
  EXPECT_EQ(pngMetadata("no picture"), "");
  const std::string whole = encodePng(picture(3), {"t", "text"});
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_THAT(pngMetadata(whole.substr(0, size)), testing::AnyOf("", "text"));
}

TEST_F(PngFile, ReplacesAnExistingFileAndRepeatsItsBytes) {
  const fs::path path = folder_ / "p.png";
  writePng(path, picture(10), {});
  writePng(path, picture(20), {});
  const std::string first = folder_.read(path);
  writePng(path, picture(20), {});
  EXPECT_EQ(folder_.read(path), first);
  EXPECT_EQ(folder_.names().size(), 1U);
}

TEST_F(PngFile, FullDiskLeavesWhatWasThere) {
  const fs::path path = folder_ / "p.png";
  writePng(path, picture(10), {});
  const std::string before = folder_.read(path);
  std::string message;
  {
    const SmallDisk disk(4096);
    message = failure(path, picture(200));
  }
  EXPECT_THAT(message, testing::HasSubstr("p.png"));
  EXPECT_THAT(message, testing::HasSubstr("File too large"));
  EXPECT_EQ(folder_.read(path), before);
  EXPECT_EQ(folder_.names().size(), 1U);
}

TEST_F(PngFile, SaysWhyItCannotBeWritten) {
  EXPECT_THAT(failure(folder_.path(), picture(4)), testing::HasSubstr("is a folder"));
  EXPECT_THAT(
      failure(folder_ / "nowhere" / "p.png", picture(4)),
      testing::AllOf(testing::HasSubstr("nowhere/p.png"), testing::HasSubstr("does not exist")));
  EXPECT_THAT(failure(folder_ / "p.png", QImage()), testing::HasSubstr("encoded"));
  ASSERT_EQ(mkfifo((folder_ / "pipe.png").c_str(), 0600), 0);
  EXPECT_THAT(failure(folder_ / "pipe.png", picture(4)), testing::HasSubstr("not a plain file"));
  fs::remove(folder_ / "pipe.png");
  EXPECT_THAT(failure("/proc/p.png", picture(4)), testing::HasSubstr("/proc/p.png"));
  EXPECT_EQ(folder_.names().size(), 0U);
}

}  // namespace
}  // namespace asperity
