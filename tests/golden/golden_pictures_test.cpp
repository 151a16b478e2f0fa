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
#include <utility>
#include <vector>

#include "core/run/simulation.h"
#include "core/run/steady_frames.h"
#include "core/scene/scene_file.h"
#include "ui/contact/contact_overlay.h"
#include "ui/contact/contact_picture.h"
#include "ui/contact/view_navigation.h"
#include "ui/draw/fonts.h"
#include "ui/draw/pixel_context.h"

namespace asperity {
namespace {

constexpr FrameFields kEverything{true, true, true};

/// With the two points to an element that the pictures were made with.
Scene sceneOf(const std::string& name) {
  return readSceneFile(std::string(ASPERITY_RESOURCES_DIR) + "/scenes/" + name + ".json",
                       {"accuracy.oversampling=2"});
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
  double share = 0;  // of pixels that differ by more than kFar levels
  int largest = 0;   // pixels of these that lie together, as those of a wrong letter do
};

constexpr int kFar = 24;  // levels
constexpr int kLargestRegion = 8;
constexpr int kTogether = 2;  // pixels: those no further apart belong to one region

/// The pixels of the largest region; `far` is taken apart.
int largestRegion(std::vector<bool>& far, int width, int height) {
  int largest = 0;
  std::vector<int> waiting;
  for (int start = 0; start < width * height; ++start) {
    if (!far[static_cast<std::size_t>(start)]) continue;
    int count = 0;
    waiting.push_back(start);
    far[static_cast<std::size_t>(start)] = false;
    while (!waiting.empty()) {
      const int x = waiting.back() % width, y = waiting.back() / width;
      waiting.pop_back();
      ++count;
      for (int j = std::max(y - kTogether, 0); j <= std::min(y + kTogether, height - 1); ++j)
        for (int i = std::max(x - kTogether, 0); i <= std::min(x + kTogether, width - 1); ++i) {
          const int other = j * width + i;
          if (!far[static_cast<std::size_t>(other)]) continue;
          far[static_cast<std::size_t>(other)] = false;
          waiting.push_back(other);
        }
    }
    largest = std::max(largest, count);
  }
  return largest;
}

Difference differenceOf(const QImage& a, const QImage& b) {
  Difference difference;
  std::int64_t sum = 0;
  std::vector<bool> far;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
      const int apart[] = {std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                           std::abs(qBlue(p) - qBlue(q))};
      for (const int channel : apart) sum += channel;
      far.push_back(*std::max_element(apart, apart + 3) > kFar);
    }
  const double pixels = static_cast<double>(a.width()) * a.height();
  difference.mean = static_cast<double>(sum) / (3 * pixels);
  difference.share = static_cast<double>(std::ranges::count(far, true)) / pixels;
  difference.largest = largestRegion(far, a.width(), a.height());
  return difference;
}

/// A wrong digit is 0.01 % of a picture, and some ten pixels in one place.
bool isSame(const Difference& difference) {
  return difference.mean < 0.4 && difference.share < 0.004 && difference.largest < kLargestRegion;
}

/// Draws the picture as the program does, and as OpenGL does.
void expectAsKept(const std::string& name, const DrawList& list) {
  const QString kept =
      QString::fromStdString(std::string(ASPERITY_TESTS_DIR) + "/golden/" + name + ".png");
  for (const PixelBackend backend : {PixelBackend::Automatic, PixelBackend::Osmesa}) {
    const auto context = makePixelContext(backend);
    const QImage seen = renderImage(*context, list).convertToFormat(QImage::Format_RGB888);
    if (qEnvironmentVariableIsSet("ASPERITY_KEEP_GOLDEN")) {
      ASSERT_TRUE(seen.save(kept, nullptr, 80));
    }
    const QImage wanted = QImage(kept).convertToFormat(QImage::Format_RGB888);
    ASSERT_EQ(wanted.size(), seen.size()) << name;
    const Difference difference = differenceOf(wanted, seen);
    if (!isSame(difference)) seen.save(QString::fromStdString(name + ".seen.png"));
    EXPECT_TRUE(isSame(difference))
        << name << " by " << context->name() << ": mean " << difference.mean << ", far apart "
        << difference.share << ", together " << difference.largest;
  }
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
    expectAsKept("overlay_" + std::string(choiceWord(kContactOverlays, overlay)),
                 composeContact(frame, options));
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
  simulation.requestFields(kEverything);
  for (int i = 0; i < 40; ++i) simulation.advance(0.02, 0.04);
  ContactPictureOptions options = usual();
  options.overlay = ContactOverlay::Relaxation;
  options.theme = darkTheme();
  expectAsKept("reversal_relaxation", composeContact(simulation.frame(), options));
}

QImage imageOf(const DrawList& list) {
  return renderImage(contextOfThread(), list).convertToFormat(QImage::Format_RGB888);
}

/// What the comparison is there to see: one digit of one label, one sign less, a tag elsewhere.
TEST(GoldenPictures, OneWrongDigitIsADifference) {
  const Frame frame = steadyFrame("figure_1");
  const QImage right = imageOf(composeContact(frame, usual()));
  EXPECT_TRUE(isSame(differenceOf(right, right)));
  int candidates = 0, digits = 0;
  const DrawList list = composeContact(frame, usual());
  for (std::size_t label = 0; label < list.texts.size(); ++label)
    for (const auto& [digit, other] : {std::pair{'1', '7'}, {'0', '8'}, {'3', '8'}, {'5', '6'}}) {
      const std::size_t at = list.texts[label].utf8.find(digit);
      if (at == std::string::npos || candidates++ % 4 != 0) continue;  // a picture takes its time
      DrawList wrong = list;
      wrong.texts[label].utf8[at] = other;
      const Difference difference = differenceOf(right, imageOf(wrong));
      EXPECT_FALSE(isSame(difference))
          << wrong.texts[label].utf8 << ": together " << difference.largest;
      EXPECT_LT(difference.share, 0.004);  // which the share alone would pass over
      ++digits;
    }
  EXPECT_GT(digits, 5);
}

}  // namespace
}  // namespace asperity
