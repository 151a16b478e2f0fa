// Every word and sign of the contact's picture has an explanation where it is drawn; what drags
// change.
#include "ui/contact/contact_signs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

#include "core/chart/explanations.h"
#include "tests/ui/contact/sample_frame.h"
#include "ui/contact/contact_picture.h"
#include "ui/draw/ticks.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

Frame frame() {
  SampleOptions options;
  options.points = 400;
  return *sampleFrame(options);
}

bool isIn(const Box& place, float x, float y) {
  return x >= place.x && x <= place.x + place.width && y >= place.y && y <= place.y + place.height;
}

std::set<std::string_view> idsOf(const std::vector<ContactSign>& signs) {
  std::set<std::string_view> ids;
  for (const ContactSign& sign : signs) ids.insert(sign.id);
  return ids;
}

TEST(ContactSigns, EachHasAnExplanationAndAPlaceInThePicture) {
  for (const ContactOverlay overlay : {ContactOverlay::Pressure, ContactOverlay::None}) {
    ContactPictureOptions options;
    options.overlay = overlay;
    const std::vector<ContactSign> signs = contactSigns(frame(), options);
    EXPECT_GT(signs.size(), 10U);
    for (const ContactSign& sign : signs) {
      EXPECT_TRUE(findExplanation(sign.id)) << sign.name << ": " << sign.id;
      EXPECT_FALSE(sign.name.empty());
      const Box& place = sign.box;
      EXPECT_GT(place.width, 4) << sign.name;
      EXPECT_GT(place.height, 4) << sign.name;
      EXPECT_TRUE(isIn({0, 0, 1280, 720}, place.x, place.y)) << sign.name;
      EXPECT_LE(place.x + place.width, 1281) << sign.name;
      EXPECT_LE(place.y + place.height, 721) << sign.name;
    }
  }
}

/// What is not a number at an axis says what it is under the pointer.
TEST(ContactSigns, EveryWordOfThePictureIsCovered) {
  for (const int width : {700, 1280}) {
    ContactPictureOptions options;
    options.width = width;
    const Frame shown = frame();
    const std::vector<ContactSign> signs = contactSigns(shown, options);
    for (const DrawText& text : composeContact(shown, options).texts) {
      const bool hasWords = std::ranges::count_if(text.utf8, [](unsigned char letter) {
                              return std::isalpha(letter) != 0;
                            }) > 3;
      if (!hasWords || text.utf8.starts_with("Figure") || text.utf8.starts_with("t = ")) continue;
      const float inside = text.anchor == TextAnchor::Right ? -2.0F : 2.0F;
      const bool isCovered = std::ranges::any_of(signs, [&](const ContactSign& sign) {
        return isIn(sign.box, text.x + (text.angle == 0 ? inside : -2.0F), text.y - 2);
      });
      EXPECT_TRUE(isCovered) << text.utf8 << " at " << width;
    }
  }
}

bool namesBothForces(const std::vector<ContactSign>& signs) {
  return idsOf(signs).contains("tangential_force") &&
         std::ranges::any_of(
             signs, [](const ContactSign& sign) { return sign.handle == ContactHandle::Force; });
}

/// Low or high, a picture has the arrows of forces and velocity in their labels.
TEST(ContactSigns, ArrowsStandInTheirLabels) {
  const Frame shown = frame();
  for (const int height : {240, 400, 720, 1440}) {
    ContactPictureOptions options;
    options.width = std::max(1000, 2 * height);
    options.height = height;
    const std::vector<ContactSign> signs = contactSigns(shown, options);
    EXPECT_TRUE(namesBothForces(signs)) << height;
    EXPECT_EQ(std::ranges::count(signs, ContactHandle::Force, &ContactSign::handle), 1) << height;
    const Rgba& colour = options.theme.highlight;
    int arrows = 0;
    for (const DrawLayer& layer : composeContact(shown, options).layers)
      for (const DrawLine& line : layer.lines)
        for (const DrawVertex& end : line.vertices) {
          if (end.colour.r != colour.r || end.colour.g != colour.g || end.colour.b != colour.b)
            continue;
          ++arrows;
          EXPECT_TRUE(std::ranges::any_of(signs, [&](const ContactSign& sign) {
            return isIn(sign.box, end.x, end.y);
          })) << height;
        }
    EXPECT_GE(arrows, 3 * 5) << height;
  }
}

/// Other words give way before a force is left out.
TEST(ContactSigns, ANarrowPictureNamesBothForces) {
  const Frame shown = frame();
  for (const char* code : {"en", "de"}) {
    useLanguage(code);
    for (const int height : {420, 900})
      for (int width = 660; width < 1200; width += 20) {
        ContactPictureOptions options;
        options.width = width;
        options.height = height;
        options.scale = 1.25F;  // of a presentation
        EXPECT_TRUE(namesBothForces(contactSigns(shown, options)))
            << code << ' ' << width << ' ' << height;
      }
  }
  useLanguage("en");
}

TEST(ContactSigns, TheLegendExplainsTheColoursThatAreShown) {
  Frame shown = frame();
  shown.sinceContact.assign(shown.pressure.size(), 1e-3);
  shown.power.assign(shown.pressure.size(), 1e-3);
  for (const auto& [overlay, id] : {std::pair{ContactOverlay::Pressure, "line load"},
                                    std::pair{ContactOverlay::Relaxation, "time since contact"},
                                    std::pair{ContactOverlay::Power, "dissipated power"}}) {
    ContactPictureOptions options;
    options.overlay = overlay;
    const std::vector<ContactSign> signs = contactSigns(shown, options);
    EXPECT_TRUE(idsOf(signs).contains(id)) << id;
    // The bar lies at the right below the axes, and its place is found again.
    const auto legend = std::ranges::find_if(signs, [&](const ContactSign& sign) {
      return sign.id == id && sign.box.x + sign.box.width > 900;
    });
    ASSERT_NE(legend, signs.end()) << id;
    const auto found = contactSignAt(shown, options, legend->box.x + legend->box.width / 2,
                                     legend->box.y + legend->box.height / 2);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->id, id);
  }
}

TEST(ContactSigns, LocalFrictionIsExplainedByItsOwnKey) {
  Frame shown = frame();
  Scene scene = *shown.scene;
  scene.interface.shearStress = 2;
  shown.scene = std::make_shared<const Scene>(scene);
  const std::vector<ContactSign> signs = contactSigns(shown, {});
  const auto ids = idsOf(signs);
  EXPECT_TRUE(ids.contains("interface.shear_stress"));
  EXPECT_TRUE(ids.contains("total friction"));
  EXPECT_FALSE(ids.contains("interface.friction_coefficient"));
}

TEST(ContactSigns, NothingIsExplainedBesideThem) {
  const Frame shown = frame();
  EXPECT_FALSE(contactSignAt(shown, {}, -5, -5));
  const Box plot = contactPlotArea(shown, {});
  EXPECT_FALSE(contactSignAt(shown, {}, plot.x + plot.width / 2, plot.y + plot.height * 0.55F));
}

// ---- Drags

ContactPictureOptions usual() {
  ContactPictureOptions options;
  options.width = 1200;
  options.height = 600;
  return options;
}

Scene sceneWith(LoadKind kind) {
  Scene scene;
  scene.load.kind = kind;
  scene.load.normalForce = 0.02;
  scene.load.depth = 5e-7;
  scene.load.nominalPressure = 1e4;
  scene.sliding.velocity = 0.25;
  return scene;
}

TEST(ContactHandles, TheLoadsKindDecidesWhatABodyChanges) {
  EXPECT_EQ(draggedKey(ContactHandle::Body, sceneWith(LoadKind::Force)), "load.normal_force");
  EXPECT_EQ(draggedKey(ContactHandle::Force, sceneWith(LoadKind::Force)), "load.normal_force");
  EXPECT_EQ(draggedKey(ContactHandle::Body, sceneWith(LoadKind::Pressure)),
            "load.nominal_pressure");
  EXPECT_EQ(draggedKey(ContactHandle::Body, sceneWith(LoadKind::Indentation)), "load.depth");
  EXPECT_EQ(draggedKey(ContactHandle::Force, sceneWith(LoadKind::Indentation)), "");
  EXPECT_EQ(draggedKey(ContactHandle::Velocity, sceneWith(LoadKind::Force)), "sliding.velocity");
  EXPECT_EQ(draggedKey(ContactHandle::None, sceneWith(LoadKind::Force)), "");
}

/// A given indentation changes by what the pointer moves, so that the body stays under it.
TEST(ContactHandles, ABodyStaysUnderThePointer) {
  const Scene start = sceneWith(LoadKind::Indentation);
  const Scene deeper = dragged(start, ContactHandle::Body, {0, 0.1, 2e-6});
  EXPECT_NEAR(deeper.load.depth, start.load.depth + 0.1 * 2e-6, 1e-10);
  const Scene lifted = dragged(start, ContactHandle::Body, {0.5, -0.9, 2e-6});
  EXPECT_GT(lifted.load.depth, 0);
  EXPECT_LT(lifted.load.depth, 0.01 * start.load.depth);
}

/// Equal distances are equal factors, so that two drags are the same as one of their length.
TEST(ContactHandles, ForcesAndVelocitiesChangeByFactors) {
  const Scene start = sceneWith(LoadKind::Force);
  const auto force = [&](double down) {
    return dragged(start, ContactHandle::Force, {0, down, 1e-6}).load.normalForce;
  };
  EXPECT_GT(force(0.1), start.load.normalForce);
  EXPECT_LT(force(-0.1), start.load.normalForce);
  EXPECT_NEAR(force(0.3) * force(-0.3), start.load.normalForce * start.load.normalForce,
              1e-3 * start.load.normalForce * start.load.normalForce);
  const Scene once = dragged(start, ContactHandle::Velocity, {0.1, 0, 1e-6});
  const Scene twice = dragged(once, ContactHandle::Velocity, {0.1, 0, 1e-6});
  EXPECT_NEAR(twice.sliding.velocity,
              dragged(start, ContactHandle::Velocity, {0.2, 0, 1e-6}).sliding.velocity,
              1e-3 * twice.sliding.velocity);
  EXPECT_GT(once.sliding.velocity, start.sliding.velocity);
}

TEST(ContactHandles, WithoutAWayNothingChangesAndNoDragLeavesWhatIsAllowed) {
  Scene start = sceneWith(LoadKind::Force);
  start.load.normalForce = 0.0123456789;  // not even rounded
  EXPECT_EQ(dragged(start, ContactHandle::Body, {0.7, 0, 1e-6}), start);
  EXPECT_EQ(dragged(start, ContactHandle::Velocity, {0, 0.7, 1e-6}), start);
  for (const double far : {-1e3, 1e3})
    for (const ContactHandle handle :
         {ContactHandle::Body, ContactHandle::Force, ContactHandle::Velocity})
      for (const LoadKind kind : {LoadKind::Force, LoadKind::Indentation, LoadKind::Pressure}) {
        const Scene after = dragged(sceneWith(kind), handle, {far, far, 1e-6});
        EXPECT_TRUE(std::isfinite(after.load.normalForce + after.load.depth +
                                  after.load.nominalPressure + after.sliding.velocity));
        EXPECT_GT(after.load.depth, 0);
      }
}

TEST(ContactHandles, ALineAtRestIsStartedToTheRight) {
  Scene start = sceneWith(LoadKind::Force);
  start.sliding.velocity = 0;
  EXPECT_GT(dragged(start, ContactHandle::Velocity, {0.01, 0, 1e-6}).sliding.velocity, 0);
  EXPECT_EQ(dragged(start, ContactHandle::Velocity, {-0.1, 0, 1e-6}), start);
}

/// The label with the velocity, wherever the picture has it, drags the velocity; that of the
/// normal force the force.
TEST(ContactHandles, LabelsAndArrowsAreWhereTheyAreDrawn) {
  const auto frame = sampleFrame({});
  const ContactPictureOptions options = usual();
  const DrawList list = composeContact(*frame, options);
  const auto handleOf = [&](const std::string& part) {
    const Box plot = contactPlotArea(*frame, options);
    for (const DrawText& text : list.texts)
      if (text.utf8.find(part) != std::string::npos && text.y > plot.y && text.x > plot.x)
        return handleAt(*frame, options, text.x + 2, text.y - 3);
    ADD_FAILURE() << part;
    return ContactHandle::None;
  };
  EXPECT_EQ(handleOf("v = "), ContactHandle::Velocity);
  EXPECT_EQ(handleOf(" = " + quantity(frame->state.normalForce, "N")), ContactHandle::Force);
  for (const ContactSign& place : contactHandles(*frame, options)) {
    EXPECT_GE(place.box.width, 12);
    EXPECT_EQ(handleAt(*frame, options, place.box.x + place.box.width / 2,
                       place.box.y + place.box.height / 2),
              place.handle);
  }
}

/// The friction is computed: its label says so, and no drag of it presses harder.
TEST(ContactHandles, TheTangentialForceIsNone) {
  const auto frame = sampleFrame({});
  int count = 0;
  for (const ContactSign& sign : contactSigns(*frame, usual())) {
    if (sign.id != "tangential_force") continue;
    ++count;
    EXPECT_FALSE(sign.tip.empty()) << sign.name;
    const auto middle = [](float from, float size) { return from + size / 2; };
    const float x = middle(sign.box.x, sign.box.width), y = middle(sign.box.y, sign.box.height);
    EXPECT_EQ(handleAt(*frame, usual(), x, y), ContactHandle::None) << sign.name;
  }
  EXPECT_EQ(count, 1);
  // The name of the rigid body is a part of it.
  for (const ContactSign& sign : contactSigns(*frame, usual()))
    if (sign.id == "rigid body") {
      EXPECT_EQ(handleAt(*frame, usual(), sign.box.x + 3, sign.box.y + 3), ContactHandle::Body);
    }
}

/// The picture of a window that is 1024 pixels wide, in the language with the longer words.
TEST(ContactHandles, ANarrowPictureNamesAllForces) {
  ContactPictureOptions options;
  for (const char* code : {"en", "de"})
    for (const auto& [width, height] :
         {std::pair{670, 227}, std::pair{640, 260}, std::pair{670, 340}}) {
      useLanguage(code);
      options.width = width;
      options.height = height;
      const auto ids = idsOf(contactSigns(*sampleFrame({}), options));
      for (const char* id : {"tangential_force", "load.normal_force", "sliding.velocity"})
        EXPECT_TRUE(ids.contains(id)) << id << ' ' << height << ' ' << code;
    }
  // Where summits leave little space, the normal force has its place before the friction.
  SampleOptions sample;
  options.height = 200;
  for (int i = 0; i < 12; ++i) {
    sample.distance = 0.0017 * i;
    const auto ids = idsOf(contactSigns(*sampleFrame(sample), options));
    EXPECT_TRUE(ids.contains("load.normal_force") || !ids.contains("tangential_force")) << i;
  }
  useLanguage("en");
}

/// However low the picture of the window: no summit that passes moves or hides what is dragged. The
/// lowest picture that has labels has all of them.
TEST(ContactHandles, StayInTheirPlaceWhileTheLineSlides) {
  constexpr float kDigits = 12;  // pixels, by which the width of a changing number may differ
  for (const int height : {190, 195, 200, 205, 210, 220, 240, 280, 340, 480}) {
    ContactPictureOptions options;
    options.width = 720;
    options.height = height;
    SampleOptions sample;
    sample.points = 400;
    const auto first = sampleFrame(sample);
    const double space = labelSpace(*first, options);
    std::optional<ContactView> view;
    std::vector<ContactSign> before;
    for (int i = 0; i < 12; ++i) {
      sample.distance = 0.0017 * i;
      const auto now = sampleFrame(sample);
      view = fittedView(*now, view, space);
      options.view = *view;
      const std::vector<ContactSign> handles = contactHandles(*now, options);
      const auto isForce = [](const ContactSign& sign) {
        return sign.handle == ContactHandle::Force;
      };
      if (i == 0 && handles.empty() && height < 210) break;  // too low for labels
      EXPECT_TRUE(std::ranges::any_of(handles, isForce)) << height << ' ' << i;
      EXPECT_EQ(handles.size(), 2U) << height << ' ' << i;  // with the velocity
      if (i > 0) {
        ASSERT_EQ(handles.size(), before.size()) << height << ' ' << i;
        for (std::size_t k = 0; k < handles.size(); ++k)
          EXPECT_NEAR(handles[k].box.x, before[k].box.x, kDigits) << height << ' ' << i;
      }
      before = handles;
    }
  }
}

/// Everything on and above the line is the body; the gap, the elastomer and what is around the plot
/// only move the view.
TEST(ContactHandles, TheBodyBeginsAtTheLine) {
  const auto frame = sampleFrame({});
  const ContactPictureOptions options = usual();
  const Box plot = contactPlotArea(*frame, options);
  const ContactView view = resolvedView(*frame, options.view);
  int checked = 0;
  for (std::size_t i = 7; i < frame->lineHeight.size(); i += 31) {
    const auto x = static_cast<float>(
        plot.x + plot.width * (static_cast<double>(i) * frame->spacing - view.left) / view.width);
    const auto y = static_cast<float>(plot.y + plot.height * (view.top - frame->lineHeight[i]) /
                                                   (view.top - view.bottom));
    if (x < plot.x + 1 || x > plot.x + plot.width - 1) continue;
    if (y < plot.y + 4 || y + 20 > plot.y + plot.height) continue;
    EXPECT_NE(handleAt(*frame, options, x, y - 3), ContactHandle::None) << i;
    EXPECT_EQ(handleAt(*frame, options, x, y + 16), ContactHandle::None) << i;
    ++checked;
  }
  EXPECT_GT(checked, 5);
  EXPECT_EQ(handleAt(*frame, options, plot.x - 5, plot.y + 5), ContactHandle::None);
  EXPECT_EQ(handleAt(*frame, options, plot.x + 5, plot.y + plot.height + 9), ContactHandle::None);
}

/// The arrow shows the velocity at this moment, which is not the mean that the scene states.
TEST(ContactHandles, TheArrowOfAnOscillationSetsItsAmplitude) {
  Scene start = sceneWith(LoadKind::Force);
  start.sliding.kind = SlidingKind::Oscillation;
  start.sliding.velocity = 0;
  start.sliding.amplitude = 0.5;
  const Scene after = dragged(start, ContactHandle::Velocity, {0.1, 0, 1e-6});
  EXPECT_EQ(after.sliding.velocity, 0);
  EXPECT_GT(after.sliding.amplitude, 0.5);
}

}  // namespace
}  // namespace asperity
