// What a picture of the contact costs with OpenGL in software, stage by stage, in processor time of
// this process, so that a busy machine does not change it much: the least of several rounds.
// Usage: picture_rate [WIDTH HEIGHT [ELEMENTS]]; prints one line for each kind of picture.
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>

#include "core/run/simulation.h"
#include "ui/contact/contact_picture.h"
#include "ui/draw/fonts.h"
#include "ui/draw/pixel_context.h"

namespace {

using namespace asperity;

constexpr int kRounds = 7, kPictures = 20;

double processorTime() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Milliseconds.
double cost(const std::function<void()>& work) {
  double least = 1e9;
  for (int round = 0; round < kRounds; ++round) {
    const double start = processorTime();
    for (int i = 0; i < kPictures; ++i) work();
    least = std::min(least, 1e3 * (processorTime() - start) / kPictures);
  }
  return least;
}

void measure(const char* name, const Frame& frame, const ContactPictureOptions& options) {
  PixelContext& context = contextOfThread();
  const DrawList list = composeContact(frame, options);
  std::size_t vertices = 0, triangles = 0;
  for (const DrawLayer& layer : list.layers) {
    triangles += layer.triangles.size() / 3;
    for (const DrawLine& line : layer.lines) vertices += line.vertices.size();
  }
  QImage image(options.width, options.height, QImage::Format_RGBA8888);
  const double compose = cost([&] { composeContact(frame, options); });
  const double shapes = cost([&] { context.draw(list); });
  const double texts = cost([&] {
    QPainter painter(&image);
    paintTexts(painter, list);
  });
  std::printf(
      "%-22s compose %5.2f ms, shapes %6.2f ms, texts %5.2f ms: %4.0f pictures/s of one "
      "core; %zu line vertices, %zu triangles\n",
      name, compose, shapes, texts, 1e3 / (compose + shapes + texts), vertices, triangles);
}

}  // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const QGuiApplication application(argc, argv);
  loadFonts();
  ContactPictureOptions options;
  if (argc > 2) {
    options.width = std::atoi(argv[1]);
    options.height = std::atoi(argv[2]);
  }
  Scene scene;
  scene.surface.elements = argc > 3 ? std::atol(argv[3]) : 5000;
  scene.load.normalForce = 0.2;
  Simulation simulation(std::make_shared<const Scene>(scene), 1);
  simulation.requestFields({true, true, true});
  const double march = cost([&] { simulation.advance(1.0 / 720, 1.0 / 60); });
  const Frame frame = simulation.frame();
  std::printf("%d x %d, %lld elements: march %.2f ms a frame, its copy %.2f ms\n", options.width,
              options.height, static_cast<long long>(scene.surface.elements), march,
              cost([&] { simulation.frame(); }));
  measure("pressure", frame, options);
  options.overlay = ContactOverlay::Relaxation;
  measure("time since contact", frame, options);
  options.overlay = ContactOverlay::Power;
  measure("dissipated power", frame, options);
  options.probe = 0.4 * frame.length;
  options.magnifier = Magnifier{0.4 * frame.length};
  measure("with magnifier", frame, options);
  return 0;
}
