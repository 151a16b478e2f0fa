// Every word and sign of the contact's picture has an explanation where it is drawn.
#include "ui/contact/contact_signs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/chart/explanations.h"
#include "tests/ui/contact/sample_frame.h"

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

TEST(ContactSigns, TheLegendExplainsTheColoursThatAreShown) {
  Frame shown = frame();
  shown.sinceContact.assign(shown.pressure.size(), 1e-3);
  shown.power.assign(shown.pressure.size(), 1e-3);
  for (const auto& [overlay, id] : {std::pair{ContactOverlay::Pressure, "contact pressure"},
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

}  // namespace
}  // namespace asperity
