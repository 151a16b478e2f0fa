#include "app/pictures/headless_pictures.h"

#include <QGuiApplication>
#include <algorithm>
#include <array>
#include <cstdio>

#include "app/output.h"
#include "ui/draw/fonts.h"

namespace asperity {
namespace {

/// Qt's warnings about desktops do not concern a program without a window; the program reports
/// errors itself.
void printOnlyFatal(QtMsgType type, const QMessageLogContext&, const QString& message) {
  if (type == QtFatalMsg) std::fprintf(stderr, "asperity: %s\n", qPrintable(message));
}

/// Makes an application that needs no display: text needs only fonts.
std::unique_ptr<QGuiApplication> offscreenApplication() {
  qInstallMessageHandler(printOnlyFatal);
  // Qt removes the words that it knows from the list, so every application needs a new list.
  static int count;
  static char name[] = "asperity", option[] = "-platform", platform[] = "offscreen";
  static char* arguments[4];
  count = 3;
  std::ranges::copy(std::array<char*, 4>{name, option, platform, nullptr}, arguments);
  return std::make_unique<QGuiApplication>(count, arguments);
}

}  // namespace

HeadlessPictures::HeadlessPictures(PixelBackend backend)
    : application_(offscreenApplication()), context_(makePixelContext(backend)) {
  loadFonts();
}

HeadlessPictures::~HeadlessPictures() {
  if (writing_.valid()) writing_.wait();
}

void HeadlessPictures::write(const std::string& file, const DrawList& list,
                             const PictureProperties& properties) {
  if (fileExtension(file) != ".png") return writePicture(file, list, properties, *context_);
  QImage image = draw(list);
  finish();
  writing_ = std::async(std::launch::async, [file, properties, image = std::move(image)] {
    writePng(file, image, properties);
  });
}

QImage HeadlessPictures::draw(const DrawList& list) {
  return renderImage(*context_, list);
}

void HeadlessPictures::finish() {
  if (writing_.valid()) writing_.get();
}

}  // namespace asperity
