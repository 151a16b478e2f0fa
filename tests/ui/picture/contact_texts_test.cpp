// Texts of the composed picture: all on the picture, none over another, over many sizes and frames.
#include <gtest/gtest.h>

#include <QFontMetricsF>
#include <QTransform>

#include <QtMath>

#include "sample_frame.h"
#include "ui/picture/contact_picture.h"
#include "ui/picture/text_painter.h"

namespace asperity {
namespace {

QRectF inkOf(const DrawText& text) {
  const QFontMetricsF metrics(fontOf(text));
  const QString words = QString::fromStdString(text.utf8);
  const qreal advance = metrics.horizontalAdvance(words);
  const qreal left = text.anchor == TextAnchor::Left     ? 0
                     : text.anchor == TextAnchor::Centre ? -advance / 2
                                                         : -advance;
  const QRectF ink = metrics.tightBoundingRect(words).translated(left, 0);
  QTransform turn;
  turn.translate(text.x, text.y);
  turn.rotate(-qRadiansToDegrees(static_cast<qreal>(text.angle)));
  return turn.mapRect(ink);
}

struct Size {
  int width, height;
  float scale;
};
constexpr Size kSizes[] = {{320, 200, 1},   {320, 240, 1},  {320, 568, 1},   {400, 300, 1},
                           {480, 854, 1},   {640, 360, 1},  {800, 600, 1},   {1000, 600, 1.25F},
                           {1280, 720, 1},  {1280, 720, 2}, {1920, 1080, 1}, {2560, 1440, 2},
                           {4000, 2250, 1}, {4000, 600, 1}, {600, 2000, 1}};

void expectTidyTexts(const Frame& frame, const ContactView& view, const char* what) {
  for (const Size& size : kSizes) {
    ContactPictureOptions options;
    options.width = size.width;
    options.height = size.height;
    options.scale = size.scale;
    options.view = view;
    const DrawList list = composeContact(frame, options);
    const QRectF picture(0, 0, size.width, size.height);
    std::vector<QRectF> boxes;
    for (const DrawText& text : list.texts) boxes.push_back(inkOf(text));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      EXPECT_TRUE(picture.contains(boxes[i]))
          << what << " " << size.width << "x" << size.height << ": " << list.texts[i].utf8;
      for (std::size_t k = 0; k < i; ++k) {
        const QRectF common = boxes[i].intersected(boxes[k]);
        EXPECT_FALSE(common.width() > 0.5 && common.height() > 0.5)
            << what << " " << size.width << "x" << size.height << ": " << list.texts[i].utf8
            << " over " << list.texts[k].utf8;
      }
    }
  }
}

TEST(ContactTexts, NeverCollideNorLeaveThePicture) {
  SampleOptions options;
  options.points = 300;
  options.distance = 0.0012;
  expectTidyTexts(*sampleFrame(options), {}, "usual");
  options.depth = 5e-5;
  expectTidyTexts(*sampleFrame(options), {}, "deep");
  options.depth = 1e-9;
  options.velocity = -3.21e-5;
  options.title =
      "A title so long that it has to be cut somewhere, because no picture is as wide as this";
  expectTidyTexts(*sampleFrame(options), {}, "light");
  options.rmsHeight = 0;
  options.velocity = 0;
  options.title = "";
  expectTidyTexts(*sampleFrame(options), {}, "flat, at rest");
}

TEST(ContactTexts, StayTidyInAnyView) {
  SampleOptions options;
  options.points = 300;
  const auto frame = sampleFrame(options);
  expectTidyTexts(*frame, {0.0195, 0.0011, 0, 0, 0}, "zoomed");
  expectTidyTexts(*frame, {-0.31, 0.00001, -1.0e-6, -0.99e-6, 3333}, "magnified");
  expectTidyTexts(*frame, {7, 0.3, -1e-3, 1e-3, 1e7}, "far away");
}

TEST(ContactTexts, StayTidyWithEveryReading) {
  SampleOptions options;
  options.points = 300;
  options.distance = 1.234567;
  options.timeScale = 1.234e-7;
  Frame frame = *sampleFrame(options);
  frame.muMarch = 1.2345e-7;
  frame.muSteady = 123.456;
  frame.normalForce = 999.4e-9;
  expectTidyTexts(frame, {}, "every reading");
  frame.scene.reset();
  frame.muSteady = kNotApplicable;
  expectTidyTexts(frame, {}, "no scene");
  expectTidyTexts(Frame{}, {}, "nothing");
}

std::string allTexts(const Frame& frame) {
  std::string words;
  for (const DrawText& text : composeContact(frame, {}).texts) words += text.utf8 + "|";
  return words;
}

TEST(ContactTexts, SayWhatIsShown) {
  SampleOptions options;
  options.points = 300;
  Frame frame = *sampleFrame(options);
  frame.muSteady = 0.0123;
  std::string words = allTexts(frame);
  for (const char* part :
       {"Figure 1", "0.0123", "rigid body", "elastomer", "rigid line slides", "v = 1 m/s",
        "position (mm)", "undeformed surface (\u00B5m)", "vertical exaggeration",
        "contact pressure (line load)", "N/m", "1 s on screen", "= 2 ms"})
    EXPECT_NE(words.find(part), std::string::npos) << part;
  EXPECT_EQ(words.find("march"), std::string::npos);
  frame.muMarch = 0.5;
  frame.timeScale = 0;
  words = allTexts(frame);
  EXPECT_NE(words.find("\u03BC (march)|0.500"), std::string::npos);
  EXPECT_EQ(words.find("on screen"), std::string::npos);
}

}  // namespace
}  // namespace asperity
