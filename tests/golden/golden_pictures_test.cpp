// The main states of the pictures against pictures kept beside this file, with a tolerance: drawing
// libraries differ by a level in a few pixels, fonts by their hinting. A picture that differs is
// saved as NAME.seen.png in the working folder. ASPERITY_KEEP_GOLDEN=1 replaces the kept ones: look
// at each of them before it is committed.
#include <gtest/gtest.h>

#include <QImage>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>

#include "core/run/simulation.h"
#include "core/run/steady_frames.h"
#include "core/scene/scene_file.h"
#include "ui/picture/contact_overlay.h"
#include "ui/picture/contact_picture.h"
#include "ui/picture/text_painter.h"
#include "ui/picture/view_navigation.h"
#include "ui/render/osmesa_context.h"

namespace asperity {
namespace {

constexpr FrameFields kEverything{true, true, true};

Scene sceneOf(const std::string& name) {
  return readSceneFile(std::string(ASPERITY_RESOURCES_DIR) + "/scenes/" + name + ".json", {});
}

Frame steadyFrame(const std::string& name) {
  return SteadyFrames(std::make_shared<const Scene>(sceneOf(name)), kEverything).frame(0, 1, 25);
}

ContactPictureOptions usual() {
  ContactPictureOptions options;
  options.width = 960;
  options.height = 540;
  return options;
}

struct Difference {
  double mean = 0;   // levels of 255, over all channels
  double share = 0;  // of pixels that differ by more than 24 levels
};

Difference differenceOf(const QImage& a, const QImage& b) {
  Difference difference;
  std::int64_t sum = 0, far = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
      const int apart[] = {std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                           std::abs(qBlue(p) - qBlue(q))};
      for (const int channel : apart) sum += channel;
      far += *std::max_element(apart, apart + 3) > 24 ? 1 : 0;
    }
  const double pixels = static_cast<double>(a.width()) * a.height();
  difference.mean = static_cast<double>(sum) / (3 * pixels);
  difference.share = static_cast<double>(far) / pixels;
  return difference;
}

void expectAsKept(const std::string& name, const DrawList& list) {
  OsmesaContext context;
  const QImage seen = renderImage(context, list).convertToFormat(QImage::Format_RGB888);
  const QString kept =
      QString::fromStdString(std::string(ASPERITY_TESTS_DIR) + "/golden/" + name + ".png");
  if (qEnvironmentVariableIsSet("ASPERITY_KEEP_GOLDEN")) {
    ASSERT_TRUE(seen.save(kept, nullptr, 80));
  }
  const QImage wanted = QImage(kept).convertToFormat(QImage::Format_RGB888);
  ASSERT_EQ(wanted.size(), seen.size()) << name;
  const Difference difference = differenceOf(wanted, seen);
  const bool isSame = difference.mean < 0.4 && difference.share < 0.004;
  if (!isSame) seen.save(QString::fromStdString(name + ".seen.png"));
  EXPECT_TRUE(isSame) << name << ": mean " << difference.mean << ", far apart " << difference.share;
}

TEST(GoldenPictures, ContactInLightAndDark) {
  const Frame frame = steadyFrame("figure_1");
  ContactPictureOptions options = usual();
  expectAsKept("contact_light", composeContact(frame, options));
  options.theme = darkTheme();
  expectAsKept("contact_dark", composeContact(frame, options));
}

TEST(GoldenPictures, Overlays) {
  const Frame frame = steadyFrame("figure_1");
  ContactPictureOptions options = usual();
  for (const ContactOverlay overlay :
       {ContactOverlay::None, ContactOverlay::Relaxation, ContactOverlay::Power}) {
    options.overlay = overlay;
    options.theme = overlay == ContactOverlay::Power ? darkTheme() : lightTheme();
    expectAsKept("overlay_" + std::string(wordFor(overlay)), composeContact(frame, options));
  }
}

TEST(GoldenPictures, ProbeAndMagnifier) {
  const Frame frame = steadyFrame("figure_1");
  ContactPictureOptions options = usual();
  options.probe = 8.4e-3;
  expectAsKept("probe", composeContact(frame, options));
  options.magnifier = Magnifier{8.4e-3, 8};
  expectAsKept("probe_and_magnifier", composeContact(frame, options));
  options.theme = darkTheme();
  options.probe.reset();
  options.magnifier->position = 1.1e-2;
  expectAsKept("magnifier_dark", composeContact(frame, options));
}

TEST(GoldenPictures, Zoomed) {
  const Frame frame = steadyFrame("figure_1");
  ContactPictureOptions options = usual();
  const ViewNavigation navigation = ViewNavigation{}.zoomed({0.5, 0.28}, 12, 4, 1e-4);
  options.view = navigation.applied(fittedView(frame), frame.length, 0);
  expectAsKept("zoomed", composeContact(frame, options));
}

TEST(GoldenPictures, AMotion) {
  Simulation simulation(std::make_shared<const Scene>(sceneOf("reversal")), 1);
  simulation.want(kEverything);
  for (int i = 0; i < 40; ++i) simulation.advance(0.02, 0.04);
  ContactPictureOptions options = usual();
  options.overlay = ContactOverlay::Relaxation;
  options.theme = darkTheme();
  expectAsKept("reversal_relaxation", composeContact(simulation.frame(), options));
}

}  // namespace
}  // namespace asperity
