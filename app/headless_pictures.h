// Pictures without a screen: a Qt application on the offscreen platform for texts, OpenGL without a
// screen for shapes, and one thread that encodes and writes a picture while the next one is drawn.
// Ownership: one at a time, made and used on the main thread.
// Failure: std::runtime_error (no library that draws, a file that cannot be written), from any
// call.
#pragma once

#include <QImage>
#include <future>
#include <memory>
#include <string>

#include "ui/draw/pixel_context.h"
#include "ui/draw/png_file.h"

class QGuiApplication;

namespace asperity {

class HeadlessPictures {
 public:
  explicit HeadlessPictures(PixelBackend backend = PixelBackend::Automatic);
  ~HeadlessPictures();
  HeadlessPictures(const HeadlessPictures&) = delete;
  HeadlessPictures& operator=(const HeadlessPictures&) = delete;

  /// As PNG, SVG or PDF, by the extension (.png, .svg, .pdf); throws InputError for any other. The
  /// file keeps the given properties. Draws at once; the file may be written later, but before
  /// finish() returns.
  void write(const std::string& file, const DrawList& list,
             const PictureProperties& properties = {});

  /// Shapes and texts, at once.
  QImage draw(const DrawList& list);

  /// Waits for the last file.
  void finish();

 private:
  void writePng(const std::string& file, const DrawList& list, const PictureProperties& properties);

  std::unique_ptr<QGuiApplication> application_;
  std::unique_ptr<PixelContext> context_;
  std::future<void> writing_;
};

}  // namespace asperity
