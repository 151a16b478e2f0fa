// What the crosshair reads, and that its readout and the magnifier hide nothing they should not.
#include "ui/contact/contact_probe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/run/simulation.h"
#include "tests/ui/contact/sample_frame.h"
#include "tests/ui/contact/tidy_texts.h"
#include "ui/contact/contact_parts.h"
#include "ui/contact/contact_picture.h"
#include "ui/draw/ticks.h"

namespace asperity {
namespace {

Frame smallFrame() {
  Frame frame;
  frame.length = 4e-3;
  frame.spacing = 1e-3;
  frame.lineHeight = {2e-6, -1e-6, 1e-6, 3e-6};
  frame.surfaceHeight = {0, -1e-6, -0.4e-6, -0.1e-6};
  frame.pressure = {0, 12, 0, 0};
  return frame;
}

TEST(Probe, ReadsTheNearestElementInAnyPeriod) {
  const Frame frame = smallFrame();
  for (const double x : {1.1e-3, 0.6e-3, 1.4e-3 + 3 * 4e-3, 1e-3 - 7 * 4e-3}) {
    const auto reading = probeReading(frame, x);
    ASSERT_TRUE(reading);
    EXPECT_EQ(reading->point, 1U) << x;
    EXPECT_EQ(reading->line, -1e-6);
    EXPECT_EQ(reading->surface, -1e-6);
    EXPECT_EQ(reading->pressure, 12);
    EXPECT_EQ(reading->gap, 0);
  }
  EXPECT_EQ(probeReading(frame, 3.6e-3)->point, 0U);  // the next period's first
  EXPECT_NEAR(probeReading(frame, 2e-3)->gap, 1.4e-6, 1e-18);
}

TEST(Probe, SlopeIsTheFramesOwnWhereItHasOne) {
  Frame frame = smallFrame();
  EXPECT_NEAR(probeReading(frame, 1e-3)->slope, -0.5e-3, 1e-12);
  EXPECT_NEAR(probeReading(frame, 0)->slope, -2e-3, 1e-12);  // over the end of the period
  frame.lineSlope = {0.1, 0.2, 0.3, 0.4};
  EXPECT_EQ(probeReading(frame, 1e-3)->slope, 0.2);
}

TEST(Probe, AgeAndPowerWhereTheyAreKnown) {
  Frame frame = smallFrame();
  EXPECT_FALSE(probeReading(frame, 0)->age);
  frame.sinceContact = {1e-3, 0, std::numeric_limits<double>::infinity(), 2e-3};
  frame.power = {0, 3, 0.5, 0};
  EXPECT_EQ(*probeReading(frame, 0)->age, 1e-3);
  EXPECT_FALSE(probeReading(frame, 2e-3)->age);
  EXPECT_EQ(*probeReading(frame, 2e-3)->power, 0.5);
}

TEST(Probe, NothingToReadWhereNothingIsDrawn) {
  EXPECT_FALSE(probeReading(Frame{}, 0));
  EXPECT_FALSE(probeReading(smallFrame(), NAN));
}

TEST(Probe, SaysItInEngineeringUnits) {
  Frame frame = smallFrame();
  frame.lineSlope = {0.1, -1.5e-3, 0.3, 0.4};
  std::string all;
  for (const ProbeLine& line : probeLines(*probeReading(frame, 1e-3)))
    all += line.label + " = " + line.value + "; ";
  EXPECT_EQ(
      all,
      "position x = 1.000 mm; rigid line z \u2212 d = \u22121.00 \u00B5m; elastomer u = \u22121.00 "
      "\u00B5m; line load p = 12.0 N/m; slope z\u2032 = \u22120.00150; ");
}

Scene movingScene(SlidingKind kind) {
  Scene scene;
  scene.surface.elements = 300;
  scene.accuracy.oversampling = 4;
  scene.load.normalForce = 0.2;
  scene.sliding = {kind, 0.05, 0.2};
  scene.sliding.duration = 0.05;
  scene.sliding.amplitude = 0.05;
  return scene;
}

/// p = 4 (G |u| - eta du/dt) at every point of every frame, with what the crosshair says.
void expectTheLaw(const Frame& frame) {
  const double g = frame.scene->elastomer.shearModulus;
  const double eta = g * frame.scene->elastomer.relaxationTime;
  const double largest = std::ranges::max(frame.pressure);
  for (std::size_t i = 0; i < frame.pressure.size(); ++i) {
    const auto reading = probeReading(frame, static_cast<double>(i) * frame.spacing);
    ASSERT_TRUE(reading->surfaceRate);
    EXPECT_NEAR(reading->pressure, 4 * (-g * reading->surface - eta * *reading->surfaceRate),
                1e-12 * largest);
  }
}

/// Relative difference (root mean square) between the rates said and those by which the elastomer
/// moves until the next frame.
double rateError(const Frame& now, const Frame& next) {
  double difference = 0, all = 0;
  for (std::size_t i = 0; i < now.pressure.size(); ++i) {
    const double x = static_cast<double>(i) * now.spacing;
    const bool isHeld = now.pressure[i] > 0 && next.pressure[i] > 0;
    const bool isFree = now.pressure[i] == 0 && next.pressure[i] == 0;
    if (!isHeld && !isFree) continue;  // the rate jumps where an element is met
    const double moved = (next.surfaceHeight[i] - now.surfaceHeight[i]) / (next.time - now.time);
    const double mean =
        0.5 * (*probeReading(now, x)->surfaceRate + *probeReading(next, x)->surfaceRate);
    difference += std::pow(mean - moved, 2);
    all += moved * moved;
  }
  return std::sqrt(difference / all);
}

TEST(Probe, PressureInAMotionIsThatOfTheDepthAndTheRateShown) {
  for (const SlidingKind kind : {SlidingKind::Step, SlidingKind::Start, SlidingKind::Oscillation}) {
    Simulation simulation(std::make_shared<const Scene>(movingScene(kind)), 1);
    for (int i = 0; i < 30; ++i) {
      simulation.advance(0.02, 1.0 / 60);
      expectTheLaw(simulation.frame());
    }
    const Frame now = simulation.frame();
    while (!(simulation.frame().time > now.time)) simulation.advance(1e-3, 1.0 / 60);
    EXPECT_LT(rateError(now, simulation.frame()), 0.25);
  }
}

TEST(Probe, PressureOfASettlingPictureIsThatOfTheDepthAndTheRateShown) {
  Scene scene = movingScene(SlidingKind::Steady);
  Simulation simulation(std::make_shared<const Scene>(scene), 1);
  EXPECT_FALSE(probeReading(simulation.frame(), 0)->surfaceRate);  // it is v z'
  scene.load.normalForce = 2;
  simulation.update(std::make_shared<const Scene>(scene), 2);
  int settling = 0;
  for (int i = 0; i < 5; ++i) {
    simulation.advance(1e-4, 1.0 / 60);
    const Frame frame = simulation.frame();
    if (!frame.isSettling) break;
    ++settling;
    expectTheLaw(frame);
  }
  EXPECT_GT(settling, 0);
}

TEST(Probe, RateIsSaidWhereTheLawHasOne) {
  Scene scene = movingScene(SlidingKind::Step);
  Simulation simulation(std::make_shared<const Scene>(scene), 1);
  const auto lines = probeLines(*probeReading(simulation.frame(), 0));
  EXPECT_TRUE(
      std::ranges::any_of(lines, [](const ProbeLine& line) { return line.label == "rate du/dt"; }));
  scene.elastomer.rheology = Rheology::Prony;
  scene.elastomer.equilibriumModulus = 1e7;
  scene.elastomer.arms = {{1e7, 1e-3}};
  simulation = Simulation(std::make_shared<const Scene>(scene), 2);
  EXPECT_FALSE(probeReading(simulation.frame(), 0)->surfaceRate);
}

struct Size {
  int width, height;
  float scale;
};
constexpr Size kSizes[] = {{320, 200, 1}, {480, 300, 1}, {640, 360, 1},  {880, 300, 1},
                           {880, 300, 2}, {600, 900, 1}, {1280, 720, 1}, {2560, 1440, 2}};

/// Every text on the picture, none over another: what lies under an inset is left out.
TEST(Probe, TextsStayTidyUnderTheCrosshairAndTheMagnifier) {
  SampleOptions sample;
  sample.points = 400;
  Frame frame = *sampleFrame(sample);
  frame.sinceContact.assign(400, 1.234e-3);
  frame.power.assign(400, 0.123);
  for (const Size& size : kSizes)
    for (const double share : {0.0, 0.02, 0.3, 0.5, 0.77, 0.99})
      for (const int what : {1, 2, 3}) {
        ContactPictureOptions options;
        options.width = size.width;
        options.height = size.height;
        options.scale = size.scale;
        if (what & 1) options.probe = share * frame.length;
        if (what & 2) options.magnifier = Magnifier{share * frame.length, 8};
        expectTidy(composeContact(frame, options),
                   std::to_string(size.width) + "x" + std::to_string(size.height) + " " +
                       std::to_string(share) + " " + std::to_string(what));
      }
}

/// Calls `visit(list, size, where)` with pictures of a frame of 400 points at all sizes, with the
/// crosshair at 41 places.
template <class Visit>
void visitProbed(Visit visit) {
  SampleOptions sample;
  sample.points = 400;
  const Frame frame = *sampleFrame(sample);
  for (const Size& size : kSizes)
    for (int i = 0; i <= 40; ++i) {
      ContactPictureOptions options;
      options.width = size.width;
      options.height = size.height;
      options.scale = size.scale;
      options.probe = i / 40.0 * frame.length;
      visit(composeContact(frame, options), size,
            std::to_string(size.width) + ' ' + std::to_string(i));
    }
}

/// A plate behind words is a thick line of two points. No box covers the words and leaves the
/// plate.
TEST(Probe, APlateKeepsItsWords) {
  int plates = 0;
  visitProbed([&](const DrawList& list, const Size& size, const std::string& where) {
    for (const DrawLayer& layer : list.layers)
      for (const DrawLine& line : layer.lines) {
        if (line.vertices.size() != 2 || line.width < 12 * size.scale) continue;
        ++plates;
        const DrawVertex &from = line.vertices.front(), &to = line.vertices.back();
        EXPECT_TRUE(std::ranges::any_of(list.texts, [&](const DrawText& text) {
          return text.x >= from.x - line.width && text.x <= to.x &&
                 std::abs(text.y - from.y) < line.width / 2;
        })) << where;
      }
  });
  EXPECT_GT(plates, 100);
}

/// The dots on line and surface are the last lines that are single points; no readout covers them:
/// its box is the last layer's.
TEST(Probe, ReadoutNeverCoversThePoint) {
  int shown = 0;
  visitProbed([&](const DrawList& list, const Size& size, const std::string& where) {
    const DrawLayer& box = list.layers.back();
    if (!box.lines.empty() || box.triangles.size() != 12) return;  // no room for a readout
    ++shown;
    float left = 1e9F, right = 0, top = 1e9F, bottom = 0;
    for (const DrawVertex& v : box.triangles) {
      left = std::min(left, v.x);
      right = std::max(right, v.x);
      top = std::min(top, v.y);
      bottom = std::max(bottom, v.y);
    }
    for (const DrawLine& line : list.layers[list.layers.size() - 2].lines)
      if (line.vertices.size() == 1) {
        const DrawVertex& dot = line.vertices.front();
        EXPECT_FALSE(dot.x > left && dot.x < right && dot.y > top && dot.y < bottom) << where;
      }
    EXPECT_GE(left, 0);
    EXPECT_LE(right, static_cast<float>(size.width));
  });
  EXPECT_GT(shown, 200);
}

/// The readout's box: the last layer's triangles, or no width where there is none.
Box readoutBox(const DrawList& list) {
  const DrawLayer& layer = list.layers.back();
  if (!layer.lines.empty() || layer.triangles.size() != 12) return {};
  float left = 1e9F, right = 0, top = 1e9F, bottom = 0;
  for (const DrawVertex& v : layer.triangles) {
    left = std::min(left, v.x);
    right = std::max(right, v.x);
    top = std::min(top, v.y);
    bottom = std::max(bottom, v.y);
  }
  return {left, top, right - left, bottom - top};
}

/// Pictures as journals print them, 86 mm at 300 dots to an inch: low in units of their texts.
TEST(Probe, ReadoutStaysInThePlotAndOffTheMagnifier) {
  SampleOptions sample;
  sample.points = 400;
  Frame frame = *sampleFrame(sample);
  frame.sinceContact.assign(400, 1.234e-3);
  frame.power.assign(400, 0.123);
  int shown = 0;
  for (const Size& size : {Size{1016, 760, 3.125F},
                           {1016, 500, 3.125F},
                           {508, 380, 1.5F},
                           {480, 300, 1},
                           {640, 360, 1}})
    for (int i = 0; i <= 40; ++i) {
      ContactPictureOptions options;
      options.width = size.width;
      options.height = size.height;
      options.scale = size.scale;
      options.probe = i / 40.0 * frame.length;
      options.magnifier = Magnifier{*options.probe - 0.02 * frame.length, 8};
      const Box box = readoutBox(composeContact(frame, options));
      if (!(box.width > 0)) continue;
      ++shown;
      const Box plot = contactPlotArea(frame, options);
      EXPECT_GE(box.y, plot.y) << size.width << " " << i;
      EXPECT_LE(box.bottom(), plot.y + plot.height) << size.width << " " << i;
    }
  EXPECT_GT(shown, 100);
}

/// The plate under the scale's bars is the second but last rectangle of the top layer's triangles.
TEST(Magnifier, ItsScaleHidesNoContact) {
  int shown = 0;
  for (const double depth : {2e-7, 1e-6, 3e-6}) {
    SampleOptions sample;
    sample.depth = depth;
    const Frame frame = *sampleFrame(sample);
    for (const Size& size : {Size{1016, 900, 3.125F}, {500, 350, 1}, {640, 360, 1}, {1280, 720, 1}})
      for (int i = 0; i < 40; ++i) {
        ContactPictureOptions options;
        options.width = size.width;
        options.height = size.height;
        options.scale = size.scale;
        options.magnifier = Magnifier{i / 40.0 * frame.length, 8};
        const DrawList list = composeContact(frame, options);
        const DrawLayer& top = list.layers.back();
        if (top.triangles.size() != 6) continue;  // no room for a scale
        ++shown;
        float left = 1e9F, right = 0, above = 1e9F, bottom = 0;
        for (const DrawVertex& v : top.triangles) {
          left = std::min(left, v.x);
          right = std::max(right, v.x);
          above = std::min(above, v.y);
          bottom = std::max(bottom, v.y);
        }
        // The curves and contacts of the inset are in the layer below.
        const DrawLayer& curves = list.layers[list.layers.size() - 2];
        for (const DrawLine& line : curves.lines) {
          if (line.vertices.size() == 2 && line.vertices[0].y == line.vertices[1].y) continue;
          for (const DrawVertex& v : line.vertices)
            EXPECT_FALSE(v.x > left && v.x < right && v.y > above && v.y < bottom)
                << size.width << " " << i << " " << depth;
        }
      }
  }
  EXPECT_GT(shown, 300);
}

/// At journal width, too, where it takes more of the plot.
TEST(Magnifier, IsThereInSmallPictures) {
  const Frame frame = *sampleFrame({});
  for (const Size& size : {Size{1016, 900, 3.125F}, {400, 350, 1}}) {
    ContactPictureOptions options;
    options.width = size.width;
    options.height = size.height;
    options.scale = size.scale;
    const std::size_t without = composeContact(frame, options).layers.size();
    options.magnifier = Magnifier{0.2 * frame.length, 8};
    EXPECT_GT(composeContact(frame, options).layers.size(), without) << size.width;
  }
}

TEST(Magnifier, LiesOnTheOtherSideOfThePlot) {
  const Frame frame = *sampleFrame({});
  const ContactPictureOptions options;
  const ContactLayout layout = layoutContact(frame, options, 60);
  const Box right = magnifierBox(frame, {0.2 * frame.length, 8}, layout);
  const Box left = magnifierBox(frame, {0.8 * frame.length, 8}, layout);
  EXPECT_GT(right.x, layout.px(0.5 * frame.length));
  EXPECT_LT(left.right(), layout.px(0.5 * frame.length));
  for (const Box& box : {left, right}) {
    EXPECT_GE(box.y, layout.plot.y);
    EXPECT_LE(box.bottom(), layout.plot.bottom());
  }
}

TEST(ProbeLines, HeightsFarBelowAnAtomAreNone) {
  ProbeReading reading;
  reading.surface = -5.4e-16;
  reading.line = 2e-12;
  const std::vector<ProbeLine> lines = probeLines(reading);
  EXPECT_EQ(lines[1].value, "2.00 pm");
  EXPECT_EQ(lines[2].value, "0 pm") << "in the unit of the other height";
}

}  // namespace
}  // namespace asperity
