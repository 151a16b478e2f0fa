// Texts of the composed picture: all on the picture, none over another, over many sizes and frames.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "tests/ui/contact/sample_frame.h"
#include "tests/ui/contact/tidy_texts.h"
#include "ui/contact/contact_overlay.h"
#include "ui/contact/contact_picture.h"
#include "ui/contact/contact_signs.h"
#include "ui/contact/frame_curves.h"
#include "ui/draw/ticks.h"

namespace asperity {
namespace {

struct PictureSize {
  int width, height;
  float scale;
};
constexpr PictureSize kPictureSizes[] = {
    {320, 200, 1},   {320, 240, 1},   {320, 568, 1},      {400, 300, 1},  {480, 854, 1},
    {640, 360, 1},   {800, 600, 1},   {1000, 600, 1.25F}, {1280, 720, 1}, {1280, 720, 2},
    {1920, 1080, 1}, {2560, 1440, 2}, {4000, 2250, 1},    {4000, 600, 1}, {600, 2000, 1}};

void expectTidyTexts(const Frame& frame, const ContactView& view, const char* what) {
  for (const PictureSize& size : kPictureSizes) {
    ContactPictureOptions options;
    options.width = size.width;
    options.height = size.height;
    options.scale = size.scale;
    options.view = view;
    const DrawList list = composeContact(frame, options);
    const std::string where =
        what + (" " + std::to_string(size.width) + "x" + std::to_string(size.height));
    expectTidy(list, where);
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
  frame.state.mu = 123.456;
  frame.state.normalForce = 999.4e-9;
  expectTidyTexts(frame, {}, "every reading");
  frame.scene.reset();
  frame.state.mu = kNotApplicable;
  expectTidyTexts(frame, {}, "no scene");
  expectTidyTexts(Frame{}, {}, "nothing");
}

std::string allTexts(const Frame& frame) {
  return allTexts(composeContact(frame, {}));
}

TEST(ContactTexts, SayWhatIsShown) {
  SampleOptions options;
  options.points = 300;
  Frame frame = *sampleFrame(options);
  frame.state.mu = 0.0123;
  std::string words = allTexts(frame);
  for (const char* part :
       {"Figure 1", "0.0123", "rigid body", "elastomer", "rigid line slides", "v = 1 m/s",
        "position (mm)", "undeformed surface (\u00B5m)", "vertical exaggeration", "line load (",
        "N/m)", "slow motion", "500\u00D7"})
    EXPECT_NE(words.find(part), std::string::npos) << part;
  EXPECT_EQ(words.find("moving picture"), std::string::npos);
  frame.muMarch = 0.5;
  frame.timeScale = 0;
  words = allTexts(frame);
  EXPECT_EQ(words.find("0.500"), std::string::npos) << "one friction, that of the steady state";
  EXPECT_EQ(words.find("settled"), std::string::npos);
  EXPECT_EQ(words.find("slow motion"), std::string::npos);
}

/// The panel has the time at the reference temperature, and the picture that of the temperature.
TEST(ContactTexts, AShiftedRelaxationTimeHasItsTemperature) {
  SampleOptions options;
  options.points = 300;
  Frame frame = *sampleFrame(options);
  EXPECT_EQ(allTexts(frame).find("s at "), std::string::npos);
  Scene warm = *frame.scene;
  warm.elastomer.temperature = 348;
  frame.scene = std::make_shared<const Scene>(warm);
  EXPECT_NE(allTexts(frame).find("s at 74.9 \u00B0C"), std::string::npos) << allTexts(frame);
}

/// The facts are of the picture, and what they come to has a name of its own.
TEST(ContactTexts, WhileItSettlesWhatIsDrawnIsTold) {
  SampleOptions options;
  options.points = 300;
  Frame frame = *sampleFrame(options);
  frame.isSettling = true;
  frame.marched = {3.21e-6, 0.0456, 0.0456 * 0.0789, 0.123, 0.0789, 0};
  frame.state.mu = 0.0123;
  const std::string words = allTexts(frame);
  for (const char* part : {"coefficient of friction \u03BC|0.0789|", "\u03BC when settled|0.0123|",
                           "3.21 \u00B5m|", "12.3 %|", "45.6 mN|", "= 3.6 mN"})
    EXPECT_NE(words.find(part), std::string::npos) << part << " in " << words;
  expectTidyTexts(frame, {}, "settling");
  frame.marched.mu = frame.marched.tangentialForce = kNotApplicable;  // steps too coarse to read it
  EXPECT_EQ(contactReadings(frame, {}).front().name, "\u03BC when settled")
      << "as the marker of the chart, which is named after it";
  EXPECT_EQ(allTexts(frame).find("coefficient of friction"), std::string::npos);
  EXPECT_EQ(allTexts(frame).find("tangential force F|"), std::string::npos);
  frame.state.mu = kNotApplicable;
  EXPECT_NE(allTexts(frame).find("coefficient of friction \u03BC|\u2013|"), std::string::npos);
}

/// Zoomed to one of the two, the other one has no name there; and the arrow of sliding stays.
TEST(ContactTexts, BodiesAreNamedOnlyWhereTheyAre) {
  SampleOptions options;
  options.points = 300;
  const auto frame = sampleFrame(options);
  const auto words = [&](double bottom, double top) {
    ContactPictureOptions picture;
    picture.view.bottom = bottom;
    picture.view.top = top;
    std::string all;
    for (const DrawText& text : composeContact(*frame, picture).texts) all += text.utf8 + "|";
    return all;
  };
  const double low = *std::ranges::min_element(frame->surfaceHeight);
  const double high = *std::ranges::max_element(frame->lineHeight);
  const double size = high - low;
  const std::string both = words(low - 0.5 * size, high + 0.5 * size);
  const std::string rubber = words(low - 2 * size, low - 0.1 * size);
  const std::string rigid = words(high + 0.1 * size, high + 2 * size);
  const auto names = [](const std::string& text, const char* name) {
    return text.find(name) != std::string::npos;
  };
  EXPECT_TRUE(names(both, "rigid body|") && names(both, "elastomer"));
  EXPECT_FALSE(names(rubber, "rigid body|"));
  EXPECT_TRUE(names(rubber, "elastomer|"));
  EXPECT_TRUE(names(rubber, "rigid line slides"));
  EXPECT_TRUE(names(rigid, "rigid body|"));
  EXPECT_FALSE(names(rigid, "elastomer|"));
}

/// Local friction is a part of its own: each part and their sum are named, and F_x is the sum's.
TEST(ContactTexts, SayWhichPartOfTheFriction) {
  SampleOptions options;
  options.points = 300;
  Frame frame = *sampleFrame(options);
  EXPECT_EQ(allTexts(frame).find("interface"), std::string::npos);
  Scene scene = *frame.scene;
  scene.interface.frictionCoefficient = 0.25;
  frame.scene = std::make_shared<const Scene>(scene);
  frame.state.mu = 0.125;
  frame.state.muInterface = 0.25;
  frame.state.normalForce = 2;
  frame.state.tangentialForce = 0.25;
  const std::string words = allTexts(frame);
  for (const char* part : {"\u03BC of the deformation|0.125|", "\u03BC of the interface|0.250|",
                           "\u03BC in total|0.375|", "tangential force in total F|x| = 750 mN"})
    EXPECT_NE(words.find(part), std::string::npos) << part << " in " << words;
}

/// All power is that of the friction force, to the last digit shown, whatever the points add up to.
TEST(ContactTexts, PowerIsFrictionTimesVelocity) {
  SampleOptions options;
  options.points = 300;
  Frame frame = *sampleFrame(options);
  frame.power.assign(frame.pressure.size(), 1);
  frame.state.normalForce = 2;
  frame.state.mu = 0.125;
  frame.state.tangentialForce = 0.25;
  ContactPictureOptions picture;
  picture.overlay = ContactOverlay::Power;
  const auto textsOf = [&] { return allTexts(composeContact(frame, picture)); };
  EXPECT_NE(textsOf().find("250 mW total, "), std::string::npos) << textsOf();  // at 1 m/s
  Scene scene = *frame.scene;
  scene.interface.frictionCoefficient = 0.25;
  frame.scene = std::make_shared<const Scene>(scene);
  frame.state.muInterface = 0.25;
  EXPECT_NE(textsOf().find("750 mW total, "), std::string::npos) << textsOf();
}

/// A motion states the error of its discretization beside its friction; the force points to where
/// contact pushes, at rest too.
TEST(ContactTexts, AMotionSaysItsErrorAndWhereItsForcePoints) {
  SampleOptions options;
  options.points = 300;
  Frame frame = *sampleFrame(options);
  TransientSample sample;
  sample.tangentialForce = -0.1;
  frame.transient = std::make_shared<const std::vector<TransientSample>>(1, sample);
  frame.velocity = 0;
  frame.state.mu = 0.0512;
  EXPECT_NE(allTexts(frame).find("|0.0512|"), std::string::npos);
  frame.muError = 0.00213;
  EXPECT_NE(allTexts(frame).find("|0.0512 \u00B1 0.0021|"), std::string::npos) << allTexts(frame);
  // Value and error end at the same digit, however small the error is.
  frame.muError = 1.04e-5;
  EXPECT_NE(allTexts(frame).find("|0.051200 \u00B1 0.000010|"), std::string::npos)
      << allTexts(frame);
  EXPECT_TRUE(pushesRight(frame));
  sample.tangentialForce = 0.1;
  frame.transient = std::make_shared<const std::vector<TransientSample>>(1, sample);
  EXPECT_FALSE(pushesRight(frame));
}

TEST(ContactTexts, DefaultTitleFitsTheKindOfLine) {
  SampleOptions options;
  options.points = 100;
  options.title = "";
  Frame frame = *sampleFrame(options);
  auto scene = std::make_shared<Scene>(*frame.scene);
  frame.scene = scene;
  const std::pair<SurfaceKind, const char*> titles[] = {
      {SurfaceKind::SelfAffine, "A rough rigid line slides over an elastomer|"},
      {SurfaceKind::Sine, "A rigid sine slides over an elastomer|"},
      {SurfaceKind::Wedge, "A rigid wedge slides over an elastomer|"},
      {SurfaceKind::Parabola, "A rigid parabola slides over an elastomer|"},
      {SurfaceKind::Profile, "A measured rigid line slides over an elastomer|"}};
  for (const auto& [kind, title] : titles) {
    scene->surface.kind = kind;
    EXPECT_EQ(allTexts(frame).find(title), 0U) << allTexts(frame);
  }
  scene->surface.kind = SurfaceKind::Wedge;
  scene->sliding.velocity = 0;
  EXPECT_EQ(allTexts(frame).find("A rigid wedge rests on an elastomer|"), 0U);
  scene->surface.kind = SurfaceKind::SelfAffine;
  scene->surface.rmsHeight = 0;
  EXPECT_EQ(allTexts(frame).find("A flat rigid line rests on an elastomer|"), 0U);
}

TEST(ContactTexts, FrictionIsShownOnlyWhereThereIsSome) {
  SampleOptions options;
  options.points = 300;
  Frame frame = *sampleFrame(options);
  EXPECT_NE(allTexts(frame).find("tangential force F|"), std::string::npos);
  for (const double mu : {0.0, kNotApplicable}) {
    frame.state.mu = mu;
    frame.state.tangentialForce = 1e-20;  // what rounding leaves
    EXPECT_EQ(allTexts(frame).find("tangential force F|"), std::string::npos) << mu;
  }
}

/// After a stop friction decays below the error of its elements and steps: an arrow would give a
/// direction and digits to what is only rounding.
TEST(ContactTexts, FrictionBelowItsErrorHasNoArrow) {
  SampleOptions options;
  options.points = 300;
  Frame frame = *sampleFrame(options);
  frame.transient = std::make_shared<const std::vector<TransientSample>>();
  frame.state.mu = 1e-3;
  frame.muError = 1e-5;
  EXPECT_NE(allTexts(frame).find("tangential force F|"), std::string::npos);
  frame.muError = 2e-3;
  EXPECT_EQ(allTexts(frame).find("tangential force F|"), std::string::npos);
  EXPECT_NE(allTexts(frame).find("F|N|"), std::string::npos);
}

/// Numbers of the colour bar lie below it or, in a low picture, beside it.
TEST(ContactTexts, ColourBarHasItsZeroAndItsMaximum) {
  SampleOptions options;
  options.points = 300;
  const auto frame = sampleFrame(options);
  for (const double pressure : {0.05, 1.0, 60.0, 150.0, 200.0, 3333.0, 8e7}) {
    for (const PictureSize& size : kPictureSizes) {
      ContactPictureOptions picture;
      picture.width = size.width;
      picture.height = size.height;
      picture.scale = size.scale;
      picture.view = resolvedView(*frame, {});
      picture.view.pressure = pressure;
      const DrawList list = composeContact(*frame, picture);
      const Box plot = contactPlotArea(*frame, picture);
      const auto title = std::find_if(list.texts.begin(), list.texts.end(), [](const auto& text) {
        return text.utf8.starts_with("line load (");
      });
      if (title == list.texts.end()) continue;  // no room for a bar
      bool zero = false, most = false;
      for (const DrawText& text : list.texts) {
        if (text.y < title->y - 0.5F) continue;
        zero = zero || text.utf8 == "0";
        // The number at the end has its unit in the title.
        const std::string_view unit =
            std::string_view(title->utf8).substr(title->utf8.find('(') + 1);
        if (text.utf8 + " " + std::string(unit) != quantity(pressure, "N/m") + ")") continue;
        EXPECT_LE(inkOf(text).right(), plot.x + plot.width + 0.5);
        most = true;
      }
      EXPECT_TRUE(zero && most) << pressure << " N/m " << size.width << "x" << size.height;
    }
  }
}

/// However low the view is: under a comparison, or with the large texts of a presentation.
TEST(ContactTexts, LowPicturesKeepTheirLegend) {
  SampleOptions sample;
  sample.points = 300;
  Frame frame = *sampleFrame(sample);
  frame.power = frame.pressure;
  frame.sinceContact.assign(frame.pressure.size(), 1e-3);
  for (const ContactOverlay overlay :
       {ContactOverlay::Pressure, ContactOverlay::Relaxation, ContactOverlay::Power})
    for (const PictureSize& size : {PictureSize{960, 330, 1},
                                    {960, 260, 1},
                                    {960, 200, 1},
                                    {640, 200, 1},
                                    {480, 170, 1},
                                    {1280, 300, 1.6F},
                                    {1280, 420, 1.6F}}) {
      ContactPictureOptions options;
      options.width = size.width;
      options.height = size.height;
      options.scale = size.scale;
      options.overlay = overlay;
      const DrawList list = composeContact(frame, options);
      const Box plot = contactPlotArea(frame, options);
      const bool hasEnd = std::ranges::any_of(list.texts, [&](const DrawText& text) {
        return std::ranges::any_of(std::array{"N/m", "N/m)", "W/m", "W/m)", "ms", "ms)"},
                                   [&](const char* unit) { return text.utf8.ends_with(unit); }) &&
               text.y > plot.y + plot.height;
      });
      const std::string where = std::to_string(size.width) + "x" + std::to_string(size.height);
      EXPECT_TRUE(hasEnd) << where;
      EXPECT_GT(plot.height, 40 * size.scale) << where;
      expectTidy(list, where);
    }
}

/// What the readings above the axes mean is told where they stand.
TEST(ContactTexts, EveryReadingHasItsSentence) {
  SampleOptions sample;
  sample.points = 300;
  Frame frame = *sampleFrame(sample);
  frame.isSettling = true;
  frame.marched = {1e-6, 1, 0.5, 0.1, 0.5, 0};
  const std::vector<ContactSign> readings = contactReadings(frame, {});
  ASSERT_EQ(readings.size(), 7U);
  const DrawList list = composeContact(frame, {});
  for (const ContactSign& reading : readings) {
    EXPECT_GT(reading.tip.size(), 20U) << reading.name;
    const Box& place = reading.box;
    int texts = 0;  // the label and the value
    for (const DrawText& text : list.texts)
      if (text.x >= place.x - 1 && text.x < place.x + place.width && text.y > place.y &&
          text.y <= place.y + place.height)
        ++texts;
    EXPECT_GE(texts, 2) << reading.name;
  }
  EXPECT_EQ(readings.back().name, "\u03BC when settled") << "where it moves no other one";
  EXPECT_NE(readings.back().tip.find("steady state"), std::string::npos);
  ContactPictureOptions plain;
  plain.title = false;
  EXPECT_TRUE(contactReadings(frame, plain).empty());
}

/// Whatever the digits of the time are, the title is the same; it is whole where it fits alone, and
/// never cut for the time beside it.
TEST(ContactTexts, TheTitleDoesNotChangeWithTheTime) {
  SampleOptions sample;
  sample.points = 300;
  Frame frame = *sampleFrame(sample);
  Scene scene = *frame.scene;
  scene.title = "Figure 2: how friction typically depends on the velocity of sliding";
  frame.scene = std::make_shared<const Scene>(scene);
  ContactPictureOptions options;
  options.height = 400;
  for (options.width = 420; options.width < 1000; options.width += 7) {
    const auto titleAt = [&](double time) {
      frame.time = frame.distance = time;
      const DrawList list = composeContact(frame, options);
      const DrawText& title = list.texts.front();
      return title.utf8 + " in " + std::to_string(title.size);
    };
    const std::string first = titleAt(1.11e-3);
    for (const double time : {88.8e-6, 444e-6, 11.1e-3, 0.7}) EXPECT_EQ(titleAt(time), first);
    const bool hasTime =
        std::ranges::any_of(composeContact(frame, options).texts,
                            [](const DrawText& text) { return text.utf8.starts_with("t = "); });
    EXPECT_FALSE(hasTime && !first.starts_with(scene.title)) << options.width << ": " << first;
    if (options.width > 640) {
      EXPECT_TRUE(first.starts_with(scene.title)) << options.width;
    }
  }
}

/// At the large texts of a presentation, too.
TEST(ContactTexts, ATitleThatIsTooLongIsToldWhereItStands) {
  SampleOptions sample;
  sample.points = 300;
  Frame frame = *sampleFrame(sample);
  Scene scene = *frame.scene;
  scene.title = "A title that is a good deal longer than what a picture of this width can show";
  frame.scene = std::make_shared<const Scene>(scene);
  ContactPictureOptions options;
  EXPECT_NE(contactReadings(frame, options).front().tip, scene.title);  // as a whole it is there
  options.width = 700;
  options.scale = 1.5F;
  const ContactSign title = contactReadings(frame, options).front();
  EXPECT_EQ(title.tip, scene.title);
  const DrawList list = composeContact(frame, options);
  const auto shown = std::ranges::find_if(
      list.texts, [&](const DrawText& text) { return text.utf8 == title.name; });
  ASSERT_NE(shown, list.texts.end());
  EXPECT_TRUE(shown->utf8.ends_with("\u2026"));
  EXPECT_GT(shown->y, title.box.y);
  EXPECT_LT(shown->y, title.box.y + title.box.height);
}

TEST(ContactTexts, NoColourBarWithoutAPressure) {
  SampleOptions options;
  options.points = 300;
  Frame frame = *sampleFrame(options);
  frame.pressure.assign(frame.pressure.size(), 0);
  std::string words = allTexts(frame);
  EXPECT_EQ(words.find("line load"), std::string::npos);
  EXPECT_EQ(words.find("glow"), std::string::npos);
  EXPECT_NE(words.find("dot: a contact too small to be drawn"), std::string::npos) << words;
  expectTidyTexts(frame, {}, "no pressure");
  frame.state.normalForce = frame.state.contactFraction = 0;
  EXPECT_EQ(allTexts(frame).find("dot:"), std::string::npos);
}

/// A flat line in contact from end to end, shown so that it comes to the very bottom.
TEST(ContactTexts, ElastomerIsNamedWhereNoContactIs) {
  SampleOptions options;
  options.points = 200;
  options.rmsHeight = 0;
  Frame frame = *sampleFrame(options);
  const auto named = [&](int width, int height) {
    ContactPictureOptions picture;
    picture.width = width;
    picture.height = height;
    picture.view = {0, 0.02, -1.1e-6, 0.2e-6, 0};
    const DrawList list = composeContact(frame, picture);
    const auto it = std::find_if(list.texts.begin(), list.texts.end(), [](const auto& text) {
      return text.utf8.find("elastomer") == 0 || text.utf8.find("elastomer:") != std::string::npos;
    });
    return it == list.texts.end() ? std::optional<DrawText>() : *it;
  };
  const auto footer = named(1280, 720);
  ASSERT_TRUE(footer);
  EXPECT_GT(footer->y, 650);                // below the axes
  EXPECT_FALSE(named(400, 260));            // no footer there: no clear place
  for (std::size_t i = 81; i < 200; ++i) {  // contact at the left alone
    frame.pressure[i] = frame.surfaceHeight[i] = 0;
    frame.lineHeight[i] = 1e-7;
  }
  const auto right = named(400, 260);
  ASSERT_TRUE(right);
  EXPECT_GT(right->x, 200);
}

/// Contact between two points of the frame is contact, whatever was asked to be coloured.
TEST(ContactTexts, NoColoursDoNotMeanNoContact) {
  SampleOptions sample;
  sample.points = 300;
  Frame frame = *sampleFrame(sample);
  frame.pressure.assign(300, 0);
  frame.sinceContact.assign(300, std::numeric_limits<double>::infinity());
  frame.power.assign(300, 0);
  for (const ContactOverlay overlay :
       {ContactOverlay::Pressure, ContactOverlay::Relaxation, ContactOverlay::Power}) {
    frame.state.normalForce = 1e-9;
    frame.state.contactFraction = 1e-6;
    EXPECT_EQ(reasonUncoloured(frame, overlay), "no colours: the contact is too small to be drawn");
    frame.state.normalForce = frame.state.contactFraction = 0;
    EXPECT_NE(reasonUncoloured(frame, overlay), "no colours: the contact is too small to be drawn");
  }
  EXPECT_EQ(reasonUncoloured(frame, ContactOverlay::Pressure), "no colours: nothing touches");
}

// From 300 pixels on, at the densities of a screen and of a journal (86 mm at 300 per inch).
constexpr PictureSize kNarrow[] = {
    {300, 220, 1},       {320, 240, 1},       {400, 260, 1},        {500, 350, 1},  {500, 170, 1},
    {1016, 500, 3.125F}, {1016, 760, 3.125F}, {1016, 1200, 3.125F}, {1280, 200, 1}, {1280, 720, 1}};

/// One number says nothing of the scale, and none without a unit says how much.
TEST(ContactTexts, BothAxesHaveTwoNumbersAndAUnit) {
  for (const double depth : {1e-7, 1e-6, 4e-6}) {
    SampleOptions sample;
    sample.points = 300;
    sample.depth = depth;
    const Frame frame = *sampleFrame(sample);
    for (const PictureSize& size : kNarrow) {
      ContactPictureOptions options;
      options.width = size.width;
      options.height = size.height;
      options.scale = size.scale;
      const Box plot = contactPlotArea(frame, options);
      const DrawList list = composeContact(frame, options);
      int onY = 0, onX = 0, units = 0;
      for (const DrawText& text : list.texts) {
        const bool isBeside = text.x < plot.x && text.anchor == TextAnchor::Right;
        onY += isBeside ? 1 : 0;
        const float below = text.y - plot.y - plot.height;
        onX += text.anchor == TextAnchor::Centre && below > 0 && below < 2 * text.size &&
                       text.angle == 0 && text.utf8.find('(') == std::string::npos
                   ? 1
                   : 0;
        for (const char* unit : {"(mm)", "(\u00B5m)", "(nm)", " mm", " \u00B5m", " nm"})
          units += text.utf8.ends_with(unit) && (text.x < plot.x + 1 || below > 0) ? 1 : 0;
      }
      const std::string where = std::to_string(size.width) + "x" + std::to_string(size.height) +
                                " depth " + std::to_string(1e6 * depth);
      // A frame that is lower than two numbers cannot have them.
      if (plot.height > 3 * list.texts.back().size) {
        EXPECT_GE(onY, 2) << where;
      }
      EXPECT_GE(onX, 2) << where;
      EXPECT_GE(units, 2) << where;
      expectTidy(list, where);
    }
  }
}

/// Rows that the line crosses have no label, wherever it has slid to.
TEST(ContactTexts, NoLabelIsCrossedByTheLine) {
  int labels = 0;
  for (int slid = 0; slid < 8; ++slid) {
    SampleOptions sample;
    sample.points = 500;
    sample.distance = slid * 0.0025;
    const Frame frame = *sampleFrame(sample);
    for (const PictureSize& size : kNarrow) {
      ContactPictureOptions options;
      options.width = size.width;
      options.height = size.height;
      options.scale = size.scale;
      const Box plot = contactPlotArea(frame, options);
      const ContactView view = resolvedView(frame, options.view);
      const DrawList list = composeContact(frame, options);
      for (const DrawText& text : list.texts) {
        if (text.x <= plot.x || text.y <= plot.y || text.y > plot.y + 0.45F * plot.height ||
            text.x >= plot.x + plot.width)
          continue;
        ++labels;
        const QRectF ink = inkOf(text);
        for (std::size_t i = 0; i < frame.lineHeight.size(); ++i) {
          const double x = plot.x + (static_cast<double>(i) * frame.spacing - view.left) /
                                        view.width * plot.width;
          const double y =
              plot.y + (view.top - frame.lineHeight[i]) / (view.top - view.bottom) * plot.height;
          if (x < ink.left() || x > ink.right()) continue;
          ASSERT_GT(y, ink.bottom())
              << text.utf8 << " " << size.width << "x" << size.height << " slid " << slid;
        }
      }
    }
  }
  EXPECT_GT(labels, 150);
}

/// A view that moves by a pixel moves no label that the line does not cross there.
TEST(ContactTexts, LabelsStayWhileTheViewMovesByAPixel) {
  SampleOptions sample;
  sample.points = 500;
  const Frame frame = *sampleFrame(sample);
  const auto labelPlaces = [&](const ContactPictureOptions& options) {
    std::vector<LabelPlace> found;
    composeContact(frame, options, &found);
    return found;
  };
  int kept = 0, moved = 0, movedWithoutMemory = 0;
  for (const PictureSize& size : {PictureSize{640, 260, 1}, {900, 280, 1}, {1280, 300, 1}}) {
    ContactPictureOptions options;
    options.width = size.width;
    options.height = size.height;
    options.view.width = frame.length / 3;
    const ContactView whole = resolvedView(frame, {});
    options.view.top = whole.bottom + 0.8 * (whole.top - whole.bottom);
    options.view.bottom = whole.bottom;
    const Box plot = contactPlotArea(frame, options);
    const auto leftOf = [](const std::vector<LabelPlace>& places, std::string_view id) {
      const auto found = std::ranges::find(places, id, &LabelPlace::id);
      return found == places.end() ? std::optional<float>() : found->left;
    };
    std::vector<LabelPlace> before, plain;
    for (int step = 0; step < 200; ++step) {
      options.view.left = step * options.view.width / static_cast<double>(plot.width);
      options.lastLabels = {};
      const std::vector<LabelPlace> withoutMemory = labelPlaces(options);
      options.lastLabels = before;
      const std::vector<LabelPlace> now = labelPlaces(options);
      for (const LabelPlace& label : now) {
        const auto last = leftOf(before, label.id), lastPlain = leftOf(plain, label.id);
        const auto isPlain = leftOf(withoutMemory, label.id);
        if (lastPlain && isPlain && *lastPlain != *isPlain) ++movedWithoutMemory;
        if (last) ++(*last == label.left ? kept : moved);
      }
      before = now;
      plain = withoutMemory;
    }
  }
  EXPECT_GT(kept, 300);
  EXPECT_LT(2 * moved, movedWithoutMemory);
}

}  // namespace
}  // namespace asperity
