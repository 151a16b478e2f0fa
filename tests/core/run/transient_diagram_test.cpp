// Strips over time do not magnify the ripple of the march, and the guide over the friction of a
// motion is the exponential with the rate that each sample predicts.
#include "core/run/transient_diagram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/core/run/transient_samples.h"

namespace asperity {
namespace {

/// A parabola that slides on and on at one velocity: nothing changes but the ripple.
Scene slowParabola() {
  Scene scene;
  scene.surface.kind = SurfaceKind::Parabola;
  scene.surface.length = 0.04;
  scene.surface.elements = 4000;
  scene.surface.radius = 1;
  scene.accuracy.oversampling = 1;
  scene.load.normalForce = 0.1;
  scene.sliding.kind = SlidingKind::Step;
  scene.sliding.velocity = scene.sliding.velocityAfter = 0.005;
  scene.sliding.duration = 0.02;
  return scene;
}

struct Extent {
  double low = INFINITY, high = -INFINITY;
};

/// A member of samples, and the minimum span of its axis.
using Floor = std::pair<double TransientSample::*, double>;

Extent extentOf(const std::vector<TransientSample>& samples, double TransientSample::*member) {
  Extent extent;
  for (const TransientSample& sample : samples) {
    extent.low = std::min(extent.low, sample.*member);
    extent.high = std::max(extent.high, sample.*member);
  }
  return extent;
}

TEST(StripRange, ARippleOfOneNodeStaysSmall) {
  const auto samples = transientSamples(slowParabola(), 200);
  const MinimumSpan floors = minimumSpan(samples, 1e-5, 0.04);
  for (const auto& [member, floor] :
       {Floor{&TransientSample::mu, floors.friction},
        Floor{&TransientSample::indentation, floors.indentation},
        Floor{&TransientSample::contactLength, floors.contactLength}}) {
    const Extent ripple = extentOf(samples, member);
    const AxisEnds ends = axisEnds(ripple.low, ripple.high, floor);
    EXPECT_LT(ripple.high - ripple.low, 0.4 * (ends.to - ends.from)) << floor;
    EXPECT_LT(ends.to - ends.from, 0.1 * ripple.high) << "still close to the value";
  }
}

TEST(StripRange, WhatIsMoreThanARippleFillsItsStrip) {
  Scene scene = slowParabola();
  scene.sliding.velocity = 0.5;
  scene.sliding.velocityAfter = 0.55;
  const auto samples = transientSamples(scene, 200);
  const MinimumSpan floors = minimumSpan(samples, 1e-5, 0.04);
  for (const auto& [member, floor] : {Floor{&TransientSample::mu, floors.friction},
                                      Floor{&TransientSample::indentation, floors.indentation}}) {
    const Extent change = extentOf(samples, member);
    const AxisEnds ends = axisEnds(change.low, change.high, floor);
    EXPECT_NEAR((change.high - change.low) / (ends.to - ends.from), 1 / 1.24, 1e-9);
  }
}

TEST(StripRange, ManyContactsRippleLess) {
  TransientSample sample;
  sample.contactLength = 1e-4;
  sample.contactFraction = 0.005;  // one of them
  const std::vector<TransientSample> one(3, sample);
  sample.contactFraction = 0.5;  // a hundred
  const std::vector<TransientSample> many(3, sample);
  const double single = minimumSpan(one, 1e-6, 0.02).indentation;
  EXPECT_NEAR(single, 0.01, 1e-12);
  EXPECT_NEAR(minimumSpan(many, 1e-6, 0.02).indentation, 0.1 * single, 1e-12);
}

TEST(StripRange, WithoutKnowledgeTheValuesDecide) {
  EXPECT_EQ(minimumSpan({}, 1e-6, 0.02).friction, 0);
  const AxisEnds ends = axisEnds(2, 3, 0);
  EXPECT_NEAR(ends.from, 1.88, 1e-12);
  EXPECT_NEAR(ends.to, 3.12, 1e-12);
  EXPECT_LT(axisEnds(5, 5, 0).from, axisEnds(5, 5, 0).to);
  EXPECT_LT(axisEnds(0, 0, 0.1).from, axisEnds(0, 0, 0.1).to);
}

TEST(StripRange, SheetsHoldItToo) {
  const Scene scene = slowParabola();
  const auto samples = transientSamples(scene, 200);
  const DiagramSheet sheet = transientSheet(scene, samples, 1e-5, 0.04);
  const DiagramAxis& friction = sheet.diagrams[1].y;
  const Extent ripple = extentOf(samples, &TransientSample::mu);
  EXPECT_LT(ripple.high - ripple.low, 0.4 * (friction.to - friction.from));
}

/// Its magnitude has a corner there, which no sample meets.
TEST(Strips, FrictionThatChangesItsDirectionGoesThroughZero) {
  std::vector<TransientSample> samples(4);
  const double forces[] = {3, 1, -3, -5};
  for (int i = 0; i < 4; ++i) {
    samples[i].time = 0.001 * i;
    samples[i].tangentialForce = forces[i];
    samples[i].mu = std::abs(forces[i]) / 100;
  }
  const DiagramSheet sheet = transientSheet(slowParabola(), samples);
  const std::vector<DiagramPoint>& points = sheet.diagrams[1].series.front().points;
  ASSERT_EQ(points.size(), 5U);
  EXPECT_NEAR(points[2].x, 0.00125, 1e-15) << "on the straight line between the two samples";
  EXPECT_EQ(points[2].y, 0);
  EXPECT_EQ(sheet.diagrams[2].series.front().points.size(), 4U);

  // The band of a known error turns where the line does.
  for (TransientSample& sample : samples) sample.muError = 0.002;
  const DiagramSeries band = transientSheet(slowParabola(), samples).diagrams[1].series.front();
  ASSERT_TRUE(band.isBand);
  ASSERT_EQ(band.points.size(), 5U);
  EXPECT_EQ(band.points[2].x, points[2].x);
  EXPECT_EQ(band.points[2].low, 0);
  EXPECT_NEAR(band.points[2].high, 0.002, 1e-15);
}

/// Nothing moves where a user looks at an earlier moment.
TEST(Strips, LaterSamplesAreFadedInTheSameAxes) {
  const Scene scene = slowParabola();
  const auto samples = transientSamples(scene, 200);
  const DiagramSheet whole = transientSheet(scene, samples, 1e-5, 0.04);
  for (const std::size_t now : {0U, 1U, 50U, 199U}) {
    const auto all = std::span(samples);
    const DiagramSheet sheet = transientSheet(scene, all.first(now), 1e-5, 0.04, all.subspan(now));
    for (std::size_t i = 0; i < whole.diagrams.size(); ++i) {
      EXPECT_EQ(sheet.diagrams[i].y.from, whole.diagrams[i].y.from) << i;
      EXPECT_EQ(sheet.diagrams[i].y.to, whole.diagrams[i].y.to) << i;
      std::size_t points = 0;
      for (const DiagramSeries& series : sheet.diagrams[i].series) {
        if (series.isBand || series.isTheory) continue;
        points += series.points.size();
        const double present = now == 0 ? -1 : samples[now - 1].time;
        for (const DiagramPoint& point : series.points)
          EXPECT_TRUE(series.isFaded ? point.x >= present : point.x <= present);
      }
      EXPECT_EQ(points, samples.size() + (now > 0 ? 1 : 0)) << "the lines meet";
    }
  }
}

constexpr double kRate = 900;  // 1/s

/// Friction that relaxes from the jump on exactly as predicted; level before it.
std::vector<TransientSample> relaxing(double jump, double duration) {
  std::vector<TransientSample> samples;
  for (int i = 0; i <= 400; ++i) {
    TransientSample sample;
    sample.time = duration * i / 400;
    sample.mu = sample.time > jump ? 0.5 + 0.3 * std::exp(-kRate * (sample.time - jump)) : 0.2;
    sample.predictedRate = kRate;
    samples.push_back(sample);
  }
  return samples;
}

Sliding motion(SlidingKind kind) {
  Sliding sliding;
  sliding.kind = kind;
  sliding.duration = 0.04;
  return sliding;
}

TEST(RelaxationGuide, LiesOnFrictionThatRelaxesAsPredicted) {
  for (const SlidingKind kind : {SlidingKind::Start, SlidingKind::Step, SlidingKind::Reversal}) {
    const double jump = kind == SlidingKind::Start ? 0 : 0.02;
    const auto samples = relaxing(jump, 0.04);
    const auto guide = relaxationGuide(motion(kind), samples);
    ASSERT_GE(guide.size(), 199U);
    EXPECT_GT(guide.front().x, jump);
    for (const DiagramPoint& point : guide) {
      const double mu = 0.5 + 0.3 * std::exp(-kRate * (point.x - jump));
      EXPECT_NEAR(point.y, mu, 1e-8 * mu + 0.3 * std::exp(-kRate * 0.02)) << point.x;
    }
  }
}

TEST(RelaxationGuide, IsNotThereBeforeAJumpNorWhereTheVelocityAlwaysChanges) {
  auto samples = relaxing(0.02, 0.04);
  EXPECT_TRUE(relaxationGuide(motion(SlidingKind::Oscillation), samples).empty());
  samples.resize(150);
  EXPECT_TRUE(relaxationGuide(motion(SlidingKind::Step), samples).empty());
  EXPECT_TRUE(relaxationGuide(motion(SlidingKind::Start), {}).empty());
}

/// The window shows the strips of a scene before it knows that the scene cannot run.
TEST(RelaxationGuide, IsNotThereWhereTheShiftOfTheTimesEnds) {
  Scene scene = slowParabola();
  scene.elastomer.shift.referenceTemperature = scene.elastomer.temperature + 200;
  DiagramSheet sheet;
  EXPECT_NO_THROW(sheet = transientSheet(scene, {}, 0, 0, {}));
  EXPECT_FALSE(sheet.diagrams.empty());
}

TEST(RelaxationGuide, IsNotThereAtRest) {
  auto samples = relaxing(0.02, 0.04);
  for (TransientSample& sample : samples)
    if (sample.time > 0.02) sample.mu = kNotApplicable;
  EXPECT_TRUE(relaxationGuide(motion(SlidingKind::Step), samples).empty());
  // A line that will stop is not told to have one.
  Scene scene = slowParabola();
  scene.sliding = motion(SlidingKind::Step);
  EXPECT_FALSE(transientSheet(scene, {}, 0, 0, {}).note.empty());
  scene.sliding.velocityAfter = 0;
  EXPECT_TRUE(transientSheet(scene, {}, 0, 0, {}).note.empty());
}

}  // namespace
}  // namespace asperity
