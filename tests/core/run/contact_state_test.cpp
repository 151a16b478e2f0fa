// The state of the contact in words: every number that is said is that of the frame.
#include "core/run/contact_state.h"

#include <gtest/gtest.h>

#include <string>

#include "core/base/number_text.h"
#include "core/run/contact_tables.h"
#include "core/run/steady_frames.h"

namespace asperity {
namespace {

Frame frameOf(const std::function<void(Scene&)>& change = {}) {
  auto scene = std::make_shared<Scene>();
  scene->surface.elements = 500;
  scene->load.normalForce = 0.02;
  scene->sliding.velocity = 1;
  if (change) change(*scene);
  return SteadyFrames(scene, {}).frame(0, 1, 25);
}

/// All sentences, each with a space after it.
std::string said(const Frame& frame, const CurveAtVelocity& curve = {}) {
  std::string text;
  for (const Message& sentence : describeContact(frame, curve)) {
    const std::string one = sentence.english();
    EXPECT_TRUE(one.ends_with('.')) << one;
    for (const char* place : {"%1", "%2", "%3", "%4", "{"})
      EXPECT_EQ(one.find(place), one.npos) << one;
    text += one + ' ';
  }
  return text;
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

TEST(ContactState, NamesVelocityForceContactsAndFriction) {
  const Frame frame = frameOf();
  const std::string text = said(frame);
  const std::vector<ContactInterval> contacts = findIntervals(frame, false);
  ASSERT_GT(contacts.size(), 3U);
  double longest = 0;
  for (const ContactInterval& contact : contacts) longest = std::max(longest, contact.length);
  for (const std::string& part :
       {std::string("slides to the right at 1 m/s"), std::string("presses with 20 mN"),
        printedQuantity(frame.state.indentation, "m") + " below",
        "at " + std::to_string(contacts.size()) + " contacts",
        printedNumber(100 * frame.state.contactFraction) + " % of the period of 20 mm",
        "longest contact is " + printedQuantity(longest, "m"),
        "coefficient of friction is " + printedNumber(frame.state.mu, 3, Zeros::Keep),
        "a tangential force of " + printedQuantity(frame.state.tangentialForce, "N")})
    EXPECT_TRUE(says(text, part)) << part << " is not in " << text;
  EXPECT_EQ(describeContact(frame).size(), 4U);
}

TEST(ContactState, SpeaksOfOneContactInTheSingular) {
  const Frame frame = frameOf([](Scene& scene) { scene.surface.kind = SurfaceKind::Parabola; });
  ASSERT_EQ(findIntervals(frame, false).size(), 1U);
  const std::string length = printedQuantity(frame.state.contactFraction * frame.length, "m");
  EXPECT_TRUE(says(said(frame), "at one contact of " + length + ", which is ")) << said(frame);
}

TEST(ContactState, SpeaksOfRestAndOfFullContact) {
  EXPECT_TRUE(says(said(frameOf([](Scene& scene) { scene.sliding.velocity = 0; })),
                   "The rigid line rests. "));
  const std::string full = said(frameOf([](Scene& scene) { scene.load.normalForce = 1e3; }));
  EXPECT_TRUE(says(full, "All of the surface is in contact.")) << full;
}

TEST(ContactState, SaysWhereFrictionComesFrom) {
  const Frame both = frameOf([](Scene& scene) { scene.interface.frictionCoefficient = 0.3; });
  EXPECT_TRUE(says(said(both), printedNumber(both.state.mu, 3, Zeros::Keep) +
                                   " from the deformation of the elastomer and 0.300 from the "
                                   "interface"))
      << said(both);
  const auto elastic = [](Scene& scene) { scene.elastomer.rheology = Rheology::Elastic; };
  EXPECT_TRUE(says(said(frameOf(elastic)), "There is no friction: an elastic body"));
  EXPECT_TRUE(says(said(frameOf([&](Scene& scene) {
                     elastic(scene);
                     scene.interface.frictionCoefficient = 0.3;
                   })),
                   "is 0.300, all of it from the interface"));
}

TEST(ContactState, SpeaksOfWhatIsDrawnWhileItSettles) {
  Frame frame = frameOf();
  frame.isSettling = true;
  frame.marched = {3e-7, 0.01, 0.001, 0.05, 0.1, 0};
  const std::string text = said(frame);
  EXPECT_EQ(frame.drawn().mu, 0.1);
  EXPECT_TRUE(says(text, "presses with 10 mN")) << text;
  EXPECT_TRUE(says(text, "friction is 0.100")) << text;
  EXPECT_TRUE(says(text, "whose coefficient is " + printedNumber(frame.state.mu, 3, Zeros::Keep)));
}

TEST(ContactState, SpeaksOfAMotionAtItsMoment) {
  Frame frame = frameOf();
  frame.transient = std::make_shared<std::vector<TransientSample>>();
  frame.time = 2e-3;
  frame.velocity = -0.5;
  frame.state.mu = kNotApplicable;
  const std::string text = said(frame);
  EXPECT_TRUE(says(text, "At 2 ms of the motion the rigid line slides to the left at 500 mm/s."))
      << text;
  EXPECT_TRUE(says(text, "Friction cannot be read here")) << text;
}

TEST(ContactState, SaysWhatTheCurveTells) {
  const Frame frame = frameOf();
  CurveAtVelocity curve{0.0123, 0.000123, 20, "III", {}};
  curve.notes.add(Note::FewContacts);
  const std::string text = said(frame, curve);
  EXPECT_TRUE(says(text, "The mean of 20 lines is 0.0123 ± 1 %.")) << text;
  EXPECT_TRUE(says(text, "This is region III of the friction curve, plateau.")) << text;
  EXPECT_TRUE(says(text, "Note: few contacts carry the load")) << text;
  // A mean over one line, or over lines that are all the same, says nothing new.
  EXPECT_FALSE(says(said(frame, {0.0123, kNotApplicable, 1, "", {}}), "The mean"));
  EXPECT_FALSE(says(said(frame, {0.0123, 0, 20, "", {}}), "The mean"));
}

TEST(ContactState, AFrameWithoutContactSaysSo) {
  Frame frame = frameOf();
  std::ranges::fill(frame.pressure, 0);
  frame.state.normalForce = 0;
  frame.state.contactFraction = 0;
  const std::string text = said(frame);
  EXPECT_TRUE(says(text, "do not touch") && says(text, "no friction")) << text;
  EXPECT_TRUE(describeContact(Frame{}).empty());
}

}  // namespace
}  // namespace asperity
