// A slider dragged at 1 kHz for a minute: as many scenes, posted as fast as they can be, and the
// frames that come meanwhile. No clock: the runner is to bear any rate.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "core/run/runner.h"
#include "core/scene/parameters.h"

namespace asperity {
namespace {

constexpr int kPosts = 60000;

/// To and fro over the slider of a key, in the logarithm where it has one.
double dragged(const RealField& field, int i, int period) {
  const double part = std::abs(2.0 * (i % period) / period - 1);
  if (!(field.sliderFrom > 0)) return field.sliderFrom + part * (field.sliderTo - field.sliderFrom);
  return field.sliderFrom * std::pow(field.sliderTo / field.sliderFrom, part);
}

void expectSound(const Frame& frame) {
  ASSERT_EQ(frame.lineHeight.size(), frame.surfaceHeight.size());
  const auto [low, high] = std::minmax_element(frame.lineHeight.begin(), frame.lineHeight.end());
  const double noise = 1e-12 * std::max({*high - *low, std::abs(*low), std::abs(*high)});
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < frame.lineHeight.size(); ++i) {
    const double surface = frame.surfaceHeight[i], pressure = frame.pressure[i];
    const bool sound = std::isfinite(surface) && std::isfinite(pressure) && pressure >= 0 &&
                       surface <= 0 && surface <= frame.lineHeight[i] + noise;
    wrong += sound ? 0 : 1;
  }
  EXPECT_EQ(wrong, 0U) << "of frame " << frame.step << " of scene " << frame.sceneNumber;
  EXPECT_TRUE(std::isfinite(frame.state.indentation) && frame.state.normalForce >= 0);
}

/// The first frame of this scene or a later one; null where none comes.
std::shared_ptr<const Frame> awaitFrame(const Runner& runner, std::uint64_t number) {
  for (int i = 0; i < 10000000; ++i) {
    const auto frame = runner.newestFrame();
    if (frame && frame->sceneNumber >= number) return frame;
    std::this_thread::yield();
  }
  return nullptr;
}

TEST(Dragging, SixtyThousandScenes) {
  const char* keys[] = {"load.normal_force", "sliding.velocity", "elastomer.shear_modulus",
                        "elastomer.relaxation_time", "surface.rms_height"};
  Runner runner;
  runner.play();
  Scene scene;
  scene.surface.elements = 200;
  scene.sweep.points = 5;
  scene.ensemble.realizations = 4;
  std::uint64_t posted = 0, seen = 0, frames = 0;
  std::size_t updates = 0;
  for (int i = 0; i < kPosts; ++i) {
    const Parameter& row = *findParameter(keys[i / 1000 % 5]);
    setValue(row, scene, dragged(std::get<RealField>(row.field), i, 997));
    posted = runner.post(scene);
    ASSERT_EQ(posted, static_cast<std::uint64_t>(i) + 1);
    updates = std::max(updates, runner.takeCurveUpdates().size());
    // Now and then the hand rests for as long as a frame takes.
    const auto frame = i % 100 == 99 ? awaitFrame(runner, posted) : runner.newestFrame();
    if (!frame || frame->sceneNumber == seen) continue;
    EXPECT_GT(frame->sceneNumber, seen);
    EXPECT_LE(frame->sceneNumber, posted);
    seen = frame->sceneNumber;
    ++frames;
    expectSound(*frame);
  }
  // The last one comes through, and nothing has piled up behind it.
  const auto last = awaitFrame(runner, posted);
  ASSERT_TRUE(last);
  EXPECT_EQ(last->sceneNumber, posted);
  expectSound(*last);
  EXPECT_GE(frames, 600U);
  EXPECT_LE(updates, 64U);
  for (const RunnerMessage& message : runner.takeMessages()) ADD_FAILURE() << message.text;
}

}  // namespace
}  // namespace asperity
