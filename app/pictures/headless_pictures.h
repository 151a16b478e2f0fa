// Pictures without a screen: a Qt application on the offscreen platform draws texts, an OpenGL
// context without a screen draws shapes, and one thread encodes and writes a picture while the next
// one is drawn.
// Ownership: one object at a time, made and used on the main thread.
// Failure: any call may throw std::runtime_error (no OpenGL library, a file that cannot be
// written).
#pragma once

#include <QImage>
#include <future>
#include <memory>
#include <string>

#include "ui/draw/picture_file.h"

class QGuiApplication;

namespace asperity {

class HeadlessPictures {
 public:
  explicit HeadlessPictures(PixelBackend backend = PixelBackend::Automatic);
  ~HeadlessPictures();
  HeadlessPictures(const HeadlessPictures&) = delete;
  HeadlessPictures& operator=(const HeadlessPictures&) = delete;

  /// Writes a picture as writePicture() does. It is drawn at once; a PNG may be written later, but
  /// before finish() returns.
  void write(const std::string& file, const DrawList& list,
             const PictureProperties& properties = {});

  /// Draws shapes and texts at once.
  QImage draw(const DrawList& list);

  /// Waits until the last file is written.
  void finish();

 private:
  std::unique_ptr<QGuiApplication> application_;
  std::unique_ptr<PixelContext> context_;
  std::future<void> writing_;
};

}  // namespace asperity
