// Colour scales of the contact picture.
#include "ui/contact/contact_overlay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "tests/ui/contact/sample_frame.h"
#include "ui/draw/fonts.h"
#include "ui/draw/theme.h"

namespace asperity {
namespace {

using testing::Contains;
using testing::EndsWith;
using testing::IsSupersetOf;

double luminance(const Rgba& colour) {
  return 0.2126 * colour.r + 0.7152 * colour.g + 0.0722 * colour.b;
}

/// Readable with any colour vision: lightness alone orders the values.
TEST(Overlay, MapsAreOrderedByLightness) {
  for (int i = 0; i < 100; ++i) {
    const float a = static_cast<float>(i) / 100, b = static_cast<float>(i + 1) / 100;
    EXPECT_LT(luminance(pressureColour(a)), luminance(pressureColour(b))) << i;
    EXPECT_GT(luminance(ageColour(a)), luminance(ageColour(b))) << i;
  }
}

TEST(Overlay, ScalesAreLinearButForPower) {
  const ColourScale pressure{ContactOverlay::Pressure, 200}, power{ContactOverlay::Power, 5};
  EXPECT_FLOAT_EQ(pressure.position(50), 0.25F);
  EXPECT_FLOAT_EQ(pressure.position(1000), 1);
  EXPECT_FLOAT_EQ(power.position(5), 1);
  EXPECT_FLOAT_EQ(power.position(5e-3), 0);
  EXPECT_NEAR(power.position(0.05), 1.0 / 3, 1e-6);
  EXPECT_EQ(power.position(0), 0);
  EXPECT_EQ(pressure.position(NAN), 0);
}

/// Each tick stands where its value's colour is.
TEST(Overlay, LegendSpansTheBar) {
  for (const ContactOverlay overlay :
       {ContactOverlay::Pressure, ContactOverlay::Relaxation, ContactOverlay::Power}) {
    const ColourScale scale{overlay, 4e-3};
    const std::vector<ColourTick> ticks = scale.ticks(6, false);
    ASSERT_GE(ticks.size(), 3U);
    EXPECT_EQ(ticks.front().position, 0);
    EXPECT_EQ(ticks.back().position, 1);
    for (std::size_t i = 1; i < ticks.size(); ++i)
      EXPECT_GT(ticks[i].position, ticks[i - 1].position);
  }
  EXPECT_EQ((ColourScale{ContactOverlay::Relaxation, 4e-3}).ticks(6, true).back().label, "4 ms");
  EXPECT_EQ((ColourScale{ContactOverlay::Relaxation, 4e-3}).ticks(6, false).back().label, "4");
  EXPECT_EQ((ColourScale{ContactOverlay::Pressure, 200e3}).shortTitle(), "line load (kN/m)");
}

/// Numbers in one unit, which the last one says: short enough for a label at every decade.
TEST(Overlay, DecadesOfPowerAreLabelledInOneUnit) {
  const auto labels = [](double end) {
    std::string all;
    for (const ColourTick& tick : (ColourScale{ContactOverlay::Power, end}).ticks(6, true))
      all += tick.label + "|";
    return all;
  };
  EXPECT_EQ(labels(5), "0.005|0.05|0.5|5 W/m|");
  EXPECT_EQ(labels(2e-3), "0.002|0.02|0.2|2 mW/m|");
  Frame frame = *sampleFrame({});
  frame.power.assign(frame.pressure.size(), 1.2e-3);
  ContactPictureOptions options;
  options.overlay = ContactOverlay::Power;
  for (const int width : {900, 1280, 1920}) {
    options.width = width;
    std::set<std::string> texts;
    for (const DrawText& text : composeContact(frame, options).texts) texts.insert(text.utf8);
    EXPECT_THAT(texts, IsSupersetOf({"0.0015", "0.015", "0.15", "1.5"})) << width;
    EXPECT_THAT(texts, Contains(EndsWith("(mW/m)"))) << width;
  }
}

/// Where a colour is asked for and none is seen, a few words say why.
TEST(Overlay, SaysWhyNothingIsColoured) {
  SampleOptions sample;
  sample.velocity = 0;
  Frame resting = *sampleFrame(sample), sliding = *sampleFrame({});
  for (Frame* frame : {&resting, &sliding}) {
    frame->sinceContact.assign(frame->pressure.size(), std::numeric_limits<double>::infinity());
    frame->power.assign(frame->pressure.size(), 0.0);
  }
  EXPECT_EQ(reasonUncoloured(resting, ContactOverlay::Relaxation),
            "no colours: at rest nothing leaves contact");
  EXPECT_EQ(reasonUncoloured(sliding, ContactOverlay::Relaxation),
            "no colours: nothing has left contact yet");
  EXPECT_EQ(reasonUncoloured(resting, ContactOverlay::Power),
            "no colours: nothing is dissipated at rest");
  EXPECT_EQ(reasonUncoloured(sliding, ContactOverlay::Power), "no colours: nothing is dissipated");
  EXPECT_EQ(reasonUncoloured(sliding, ContactOverlay::Pressure), "");
  EXPECT_EQ(reasonUncoloured(sliding, ContactOverlay::None), "");
  sliding.state.contactFraction = 1;
  EXPECT_EQ(reasonUncoloured(sliding, ContactOverlay::Relaxation),
            "no colours: all of the surface is in contact");
  sliding.pressure.assign(sliding.pressure.size(), 0.0);
  EXPECT_EQ(reasonUncoloured(sliding, ContactOverlay::Pressure), "no colours: nothing touches");
  sliding.power.clear();  // not asked for: nothing is known
  EXPECT_EQ(reasonUncoloured(sliding, ContactOverlay::Power), "");
  for (const int height : {260, 720}) {
    ContactPictureOptions options;
    options.height = height;
    options.overlay = ContactOverlay::Relaxation;
    bool said = false;
    for (const DrawText& text : composeContact(resting, options).texts)
      said = said || text.utf8 == "no colours: at rest nothing leaves contact";
    EXPECT_TRUE(said) << height;
  }
}

TEST(Overlay, ScaleFitsTheFrameAndKeepsStill) {
  Frame frame = *sampleFrame({});
  frame.power.assign(frame.pressure.size(), 0.7);
  const double end = scaleMaximum(frame, ContactOverlay::Power, 0);
  EXPECT_GE(end, 0.7);
  EXPECT_LE(end, 1.5);
  frame.power.assign(frame.pressure.size(), 0.6);
  EXPECT_EQ(scaleMaximum(frame, ContactOverlay::Power, end), end);
  frame.power.assign(frame.pressure.size(), 70);
  EXPECT_GE(scaleMaximum(frame, ContactOverlay::Power, end), 70);
  frame.power.clear();
  EXPECT_EQ(scaleMaximum(frame, ContactOverlay::Power, 0), 0);
}

/// After a few relaxation times nothing is to be seen; infinite ages have no say.
TEST(Overlay, AgesEndWithTheRelaxation) {
  Frame frame = *sampleFrame({});
  frame.sinceContact.assign(frame.pressure.size(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(scaleMaximum(frame, ContactOverlay::Relaxation, 0), 0);
  frame.sinceContact[3] = 2e-3;
  EXPECT_NEAR(scaleMaximum(frame, ContactOverlay::Relaxation, 0), 2e-3, 1e-12);
  frame.sinceContact[4] = 1;
  EXPECT_NEAR(scaleMaximum(frame, ContactOverlay::Relaxation, 0),
              4 * frame.scene->elastomer.relaxationTime, 1e-12);
}

/// Whatever was shown before, and however the march ripples.
TEST(Overlay, ThePressureScaleIsThatOfTheSteadyState) {
  Frame frame = *sampleFrame({});
  frame.steadyPressure = 170;
  for (const double last : {0.0, 300.0, 1e35})
    for (const double drawn : {1e-3, 1.0, 100.0}) {
      Frame moving = frame;
      for (double& pressure : moving.pressure) pressure *= drawn;
      EXPECT_EQ(scaleMaximum(moving, ContactOverlay::Pressure, last), 200);
    }
}

/// All numbers of a bar count in the unit of its last one, and none of them is long.
TEST(Overlay, NumbersOfTheBarAreShortAtAnySize) {
  for (const ContactOverlay overlay :
       {ContactOverlay::Pressure, ContactOverlay::Relaxation, ContactOverlay::Power})
    for (int power = -40; power <= 40; ++power)
      for (const double digit : {1.0, 1.5, 2.5, 5.0}) {
        const double end = digit * std::pow(10.0, power);
        const std::vector<ColourTick> ticks = (ColourScale{overlay, end}).ticks(6, true);
        ASSERT_GE(ticks.size(), 2U) << end;
        for (const ColourTick& tick : ticks)
          EXPECT_LT(textWidth(tick.label, 12), 110) << tick.label;
        for (std::size_t i = 0; i + 1 < ticks.size(); ++i)
          EXPECT_LE(ticks[i].label.size(), 8U) << ticks[i].label << " of " << end;
      }
  std::string labels;
  for (const ColourTick& tick : (ColourScale{ContactOverlay::Pressure, 5e-29}).ticks(6, true))
    labels += tick.label + "|";
  EXPECT_EQ(labels, "0|1|2|3|4|5 10\u207B\u00B2\u2079 N/m|");
}

TEST(Overlay, AsksOnlyForWhatItShows) {
  EXPECT_EQ(fieldsFor(ContactOverlay::Pressure), FrameFields{});
  EXPECT_EQ(fieldsFor(ContactOverlay::None), FrameFields{});
  EXPECT_TRUE(fieldsFor(ContactOverlay::Relaxation).sinceContact);
  EXPECT_TRUE(fieldsFor(ContactOverlay::Power).power);
}

TEST(Overlay, WithoutItsFieldThereIsNoLegend) {
  ContactPictureOptions options;
  options.overlay = ContactOverlay::Power;
  for (const DrawText& text : composeContact(*sampleFrame({}), options).texts)
    EXPECT_EQ(text.utf8.find("power"), std::string::npos);
}

/// At most two vertices a pixel column and curve, whatever is coloured.
TEST(Overlay, CostDoesNotGrowWithThePoints) {
  for (const ContactOverlay overlay :
       {ContactOverlay::Pressure, ContactOverlay::Relaxation, ContactOverlay::Power}) {
    SampleOptions sample;
    sample.points = 200000;
    sample.hurst = 2;  // few modes to sum up
    Frame frame;
    frame.length = 0.02;
    frame.spacing = 1e-7;
    for (int i = 0; i < 200000; ++i) {
      frame.lineHeight.push_back(1e-6 * std::sin(0.01 * i) + 1e-7 * std::sin(3.0 * i));
      frame.surfaceHeight.push_back(std::min(0.0, frame.lineHeight.back()));
      frame.pressure.push_back(frame.lineHeight.back() < 0 ? 1 + (i % 7) : 0);
      frame.sinceContact.push_back(i % 100 * 1e-6);
      frame.power.push_back(0.1 * (i % 13));
    }
    ContactPictureOptions options;
    options.overlay = overlay;
    const Box plot = contactPlotArea(frame, options);
    for (const DrawLayer& layer : composeContact(frame, options).layers)
      for (const DrawLine& line : layer.lines)
        EXPECT_LE(line.vertices.size(), 2 * static_cast<std::size_t>(plot.width) + 8);
  }
}

}  // namespace
}  // namespace asperity
