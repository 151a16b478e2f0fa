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

class QGuiApplication;

namespace asperity {

/// What a picture file says of itself besides what it shows.
struct PictureFacts {
  std::string title;     // of the document; empty: none
  std::string metadata;  // where it came from, any UTF-8 text; empty: none
  double scale = 1;      // pixels to one at 96 per inch: how large it is on paper
};

class HeadlessPictures {
 public:
  explicit HeadlessPictures(PixelBackend backend = PixelBackend::Automatic);
  ~HeadlessPictures();
  HeadlessPictures(const HeadlessPictures&) = delete;
  HeadlessPictures& operator=(const HeadlessPictures&) = delete;

  /// As PNG, SVG or PDF, by the extension (.png, .svg, .pdf); throws InputError for any other. The
  /// file keeps what `facts` says. Draws at once; the file may be written later, but before
  /// finish() returns.
  void write(const std::string& file, const DrawList& list, const PictureFacts& facts = {});

  /// Shapes and texts, at once.
  QImage draw(const DrawList& list);

  /// Waits for the last file.
  void finish();

 private:
  void writePng(const std::string& file, const DrawList& list, const PictureFacts& facts);

  std::unique_ptr<QGuiApplication> application_;
  std::unique_ptr<PixelContext> context_;
  std::future<void> writing_;
};

}  // namespace asperity
