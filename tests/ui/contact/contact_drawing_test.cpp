// Pixels of the composed picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "tests/ui/contact/sample_frame.h"
#include "ui/contact/contact_picture.h"
#include "ui/draw/fonts.h"
#include "ui/draw/pixel_context.h"
#include "ui/draw/theme.h"
#include "ui/draw/ticks.h"

namespace asperity {
namespace {

/// The greatest difference of a channel.
int difference(const Pixels& pixels, int x, int y, const Rgba& colour) {
  const std::size_t i = (static_cast<std::size_t>(y) * pixels.width + x) * 4;
  const float wanted[] = {colour.r, colour.g, colour.b};
  int worst = 0;
  for (std::size_t c = 0; c < 3; ++c)
    worst = std::max(worst,
                     std::abs(pixels.rgba[i + c] - static_cast<int>(std::lround(255 * wanted[c]))));
  return worst;
}

/// A flat line a little above the elastomer that touches with one point alone.
Frame singleContact(int points, std::size_t where) {
  Frame frame;
  frame.length = 0.02;
  frame.spacing = frame.length / points;
  frame.lineHeight.assign(static_cast<std::size_t>(points), 1e-6);
  frame.surfaceHeight.assign(static_cast<std::size_t>(points), 0);
  frame.pressure.assign(static_cast<std::size_t>(points), 0);
  frame.lineHeight[where] = frame.surfaceHeight[where] = -1e-9;
  frame.pressure[where] = 7;
  return frame;
}

/// In a low view that is filled to its top, where the labels are.
TEST(ContactDrawing, LabelsLeaveTheLineWhole) {
  const auto context = makeOsmesaContext();
  Frame frame = singleContact(400, 200);
  frame.pressure.assign(400, 0);
  frame.state.normalForce = 0;
  auto scene = std::make_shared<Scene>();
  scene->sliding.velocity = 1;
  frame.scene = scene;
  for (std::size_t i = 0; i < 400; ++i)
    frame.lineHeight[i] = 1e-6 * (0.6 + 0.4 * std::sin(0.1 * static_cast<double>(i)));
  ContactPictureOptions options;
  options.width = 900;
  options.height = 240;
  options.view = {0, frame.length, -0.2e-6, 1.02e-6, 0};
  const Box plot = contactPlotArea(frame, options);
  const DrawList list = composeContact(frame, options);
  EXPECT_TRUE(
      std::ranges::any_of(list.texts, [](const auto& t) { return t.utf8 == "rigid body"; }));
  const Pixels pixels = context->draw(list);
  int broken = 0;
  for (std::size_t i = 2; i < 398; ++i) {
    const double height = frame.lineHeight[i];
    const int x = static_cast<int>(plot.x + plot.width * static_cast<double>(i) / 400);
    const int y = static_cast<int>(plot.y + plot.height * (1.02e-6 - height) / 1.22e-6);
    int nearest = 255;
    for (int dy = -3; dy <= 3; ++dy)
      nearest = std::min(nearest, difference(pixels, x, y + dy, options.theme.rigidEdge));
    broken += nearest > 60;
  }
  EXPECT_LE(broken, 4);  // pixels of the tags' arrow
}

TEST(ContactDrawing, OnePointInContactIsSeenAtEveryWidth) {
  const auto context = makeOsmesaContext();
  const Rgba colour = pressureColour(static_cast<float>(7 / roundUp(7)));
  for (const int width : {320, 641, 1280, 4000}) {
    for (const int points : {60, 5000, 200000}) {
      for (const double share : {0.03, 0.5, 0.97}) {
        const auto where = static_cast<std::size_t>(share * points);
        const Frame frame = singleContact(points, where);
        ContactPictureOptions options;
        options.width = width;
        options.height = 480;
        const Box plot = contactPlotArea(frame, options);
        const ContactView view = resolvedView(frame, {});
        const double x =
            plot.x + plot.width * (static_cast<double>(where) * frame.spacing) / view.width;
        const double y = plot.y + plot.height * view.top / (view.top - view.bottom);
        const Pixels pixels = context->draw(composeContact(frame, options));
        EXPECT_LE(difference(pixels, static_cast<int>(x), static_cast<int>(y), colour), 3)
            << width << " " << points << " " << share;
      }
    }
  }
}

/// Contact between two points: the bodies all but touch there and no point carries pressure.
TEST(ContactDrawing, ContactBetweenPointsIsSeen) {
  const auto context = makeOsmesaContext();
  for (const int points : {60, 5000, 200000}) {
    const auto where = static_cast<std::size_t>(0.3 * points);
    Frame frame = singleContact(points, where);
    frame.pressure[where] = 0;
    frame.state.normalForce = 1e-9;
    ContactPictureOptions options;
    const Box plot = contactPlotArea(frame, options);
    const ContactView view = resolvedView(frame, {});
    EXPECT_EQ(view.pressure, 0);
    const double x =
        plot.x + plot.width * (static_cast<double>(where) * frame.spacing) / view.width;
    const double y = plot.y + plot.height * view.top / (view.top - view.bottom);
    const auto off = [&] {
      const Pixels pixels = context->draw(composeContact(frame, options));
      return difference(pixels, static_cast<int>(x), static_cast<int>(y), pressureColour(1));
    };
    EXPECT_LE(off(), 3) << points;
    frame.state.normalForce = 0;  // nothing touches
    EXPECT_GT(off(), 40) << points;
  }
}

TEST(ContactDrawing, ContactsAreLitAndTheRestIsNot) {
  const auto context = makeOsmesaContext();
  SampleOptions options;
  options.points = 60;  // so far apart that every point has pixels of its own
  const auto frame = sampleFrame(options);
  ContactPictureOptions picture;
  const Box plot = contactPlotArea(*frame, picture);
  const ContactView view = resolvedView(*frame, {});
  const Pixels pixels = context->draw(composeContact(*frame, picture));
  int lit = 0;
  for (std::size_t i = 1; i < 60; ++i) {
    const double x = plot.x + plot.width * static_cast<double>(i) / 60;
    const double y =
        plot.y + plot.height * (view.top - frame->surfaceHeight[i]) / (view.top - view.bottom);
    const Rgba colour = pressureColour(static_cast<float>(frame->pressure[i] / view.pressure));
    const int off = difference(pixels, static_cast<int>(x), static_cast<int>(y), colour);
    if (frame->pressure[i] > 0) {
      EXPECT_LE(off, 30) << i;  // neighbours blend along the line
      ++lit;
    } else {
      EXPECT_GT(off, 40) << i;
    }
  }
  EXPECT_GT(lit, 5);
}

TEST(ContactDrawing, NothingMovesOutsideTheAxes) {
  const auto context = makeOsmesaContext();
  SampleOptions options;
  options.depth = 3e-6;
  ContactPictureOptions picture;
  picture.view = {0, 0.02, -1.2e-6, 0.3e-6, 100};  // cuts the curves off above and below
  const auto first = sampleFrame(options);
  options.distance = 0.007;
  options.hurst = 0.3;
  auto second = std::make_shared<Frame>(*sampleFrame(options));
  second->time = 0;
  const Box plot = contactPlotArea(*first, picture);
  const Pixels a = context->draw(composeContact(*first, picture));
  const Pixels b = context->draw(composeContact(*second, picture));
  ASSERT_EQ(a.rgba.size(), b.rgba.size());
  int inside = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const std::size_t i = (static_cast<std::size_t>(y) * a.width + x) * 4;
      const bool equal = std::equal(&a.rgba[i], &a.rgba[i] + 4, &b.rgba[i]);
      const float dx = static_cast<float>(x) - plot.x, dy = static_cast<float>(y) - plot.y;
      const bool within = dx >= 0 && dx < plot.width && dy >= 0 && dy < plot.height;
      if (within)
        inside += equal ? 0 : 1;
      else
        ASSERT_TRUE(equal) << x << " " << y;
    }
  }
  EXPECT_GT(inside, 10000);
}

TEST(ContactDrawing, BytesRepeat) {
  SampleOptions options;
  const auto frame = sampleFrame(options);
  const auto render = [&] {
    const auto context = makeOsmesaContext();
    ContactPictureOptions picture;
    picture.theme = darkTheme();
    return renderImage(*context, composeContact(*frame, picture));
  };
  EXPECT_EQ(render(), render());
}

TEST(ContactDrawing, CostDoesNotGrowWithThePoints) {
  const auto vertices = [](int points) {
    Frame frame = singleContact(points, 0);
    for (std::size_t i = 0; i < frame.pressure.size(); i += 3) frame.pressure[i] = 1;
    for (std::size_t i = 0; i < frame.lineHeight.size(); ++i)
      frame.lineHeight[i] += 1e-7 * std::sin(static_cast<double>(i));
    std::size_t count = 0;
    for (const DrawLayer& layer : composeContact(frame, {}).layers) {
      count += layer.triangles.size();
      for (const DrawLine& line : layer.lines) count += line.vertices.size();
    }
    return count;
  };
  EXPECT_LT(vertices(1000000), 200000U);
  EXPECT_LT(vertices(1000000), 1.2 * static_cast<double>(vertices(20000)));
}

TEST(ContactDrawing, AnyFrameAndSizeComposes) {
  const auto context = makeOsmesaContext();
  SampleOptions options;
  options.points = 1;
  ContactPictureOptions picture;
  for (const int size : {1, 2, 17, 60, 150}) {
    picture.width = picture.height = size;
    EXPECT_EQ(context->draw(composeContact(Frame{}, picture)).width, size);
    EXPECT_EQ(context->draw(composeContact(*sampleFrame(options), picture)).width, size);
  }
  Frame damaged = singleContact(100, 50);
  damaged.lineHeight[10] = damaged.surfaceHeight[11] = std::nan("");
  damaged.pressure[12] = INFINITY;
  damaged.distance = INFINITY;
  picture.width = 400;
  EXPECT_EQ(context->draw(composeContact(damaged, picture)).width, 400);
}

}  // namespace
}  // namespace asperity
