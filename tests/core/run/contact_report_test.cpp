// Tables of the contact against the sums and identities that their columns promise, and the contact
// in words: every number that is said is that of the frame.
#include "core/run/contact_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/number_text.h"
#include "core/run/steady_frames.h"

namespace asperity {
namespace {

double number(const DataTable& table, std::size_t row, const std::string& column) {
  const auto place = std::ranges::find(table.columns, column) - table.columns.begin();
  return std::get<double>(table.rows.at(row).at(static_cast<std::size_t>(place)));
}

double sum(const DataTable& table, const std::string& column) {
  double total = 0;
  for (std::size_t i = 0; i < table.rows.size(); ++i) total += number(table, i, column);
  return total;
}

Frame frameForTables(const std::function<void(Scene&)>& change = {}) {
  auto scene = std::make_shared<Scene>();
  scene->surface.elements = 500;
  scene->load.normalForce = 0.02;
  if (change) change(*scene);
  return SteadyFrames(scene, fieldsForTables()).frame(0, 1, 25);
}

TEST(ContactTables, ContactsAndGapsCoverThePeriodOnce) {
  const Frame frame = frameForTables();
  const DataTable contacts = contactsTable(frame), gaps = gapsTable(frame);
  EXPECT_GT(contacts.rows.size(), 3U);
  EXPECT_EQ(contacts.rows.size(), gaps.rows.size());  // in turns on a periodic line
  EXPECT_NEAR(sum(contacts, "length") + sum(gaps, "length"), frame.length, 1e-12 * frame.length);
  EXPECT_NEAR(sum(contacts, "length") / frame.length, frame.state.contactFraction, 0.01);
}

/// F_N = sum p dx and F_x = -sum p z' dx = -mu F_N towards +x, Eqs. (3) and (4).
TEST(ContactTables, ForcesOfContactsAddUpToThoseOfTheLine) {
  const Frame frame = frameForTables();
  const DataTable contacts = contactsTable(frame), shape = shapeTable(frame);
  EXPECT_NEAR(sum(contacts, "normal_force"), sum(shape, "line_load") * frame.spacing, 1e-15);
  EXPECT_NEAR(sum(contacts, "normal_force") / frame.state.normalForce, 1, 0.01);
  EXPECT_NEAR(sum(contacts, "tangential_force") / (-frame.state.mu * frame.state.normalForce), 1,
              0.02);
  for (std::size_t i = 0; i < contacts.rows.size(); ++i) {
    EXPECT_LE(number(contacts, i, "mean_line_load"), number(contacts, i, "largest_line_load"));
    EXPECT_NEAR(number(contacts, i, "mean_line_load") * number(contacts, i, "length"),
                number(contacts, i, "normal_force"), 1e-15);
  }
}

/// At 30 m/s contacts are shorter than an element: points between the elements find their load.
TEST(ContactTables, PointsThatMissTheLoadAreNamed) {
  EXPECT_FALSE(coarsePointsNote(frameForTables()));
  const auto noteAt = [](std::int64_t oversampling) {
    return coarsePointsNote(frameForTables([oversampling](Scene& scene) {
      scene.surface.elements = 5000;
      scene.sliding.velocity = 30;
      scene.load.normalForce = 0.0034;
      scene.accuracy.oversampling = oversampling;
    }));
  };
  EXPECT_TRUE(noteAt(1));
  EXPECT_FALSE(noteAt(64));
}

TEST(ContactTables, GapsAreTheDistanceBetweenLineAndSurface) {
  const Frame frame = frameForTables();
  const DataTable shape = shapeTable(frame), gaps = gapsTable(frame);
  for (std::size_t i = 0; i < shape.rows.size(); ++i) {
    const double gap = number(shape, i, "gap");
    EXPECT_GE(gap, 0);
    EXPECT_EQ(number(shape, i, "line_load") > 0, number(shape, i, "time_since_contact") == 0);
    if (number(shape, i, "line_load") > 0) {
      EXPECT_EQ(gap, 0);
    }
  }
  EXPECT_NEAR(sum(gaps, "area"), sum(shape, "gap") * frame.spacing, 1e-18);
}

/// A point in contact came under the edge ahead a time way / v ago; the times of one contact grow
/// against the direction of sliding.
TEST(ContactTables, TimeInContactIsTheWayToTheEdgeAhead) {
  const Frame frame = frameForTables();
  const std::vector<double> times = timeInContact(frame);
  for (const ContactInterval& contact : findIntervals(frame, false)) {
    const std::size_t n = times.size(), last = (contact.first + contact.points - 1) % n;
    EXPECT_NEAR(times[last], 0.5 * frame.spacing / frame.velocity, 1e-15);
    EXPECT_NEAR(times[contact.first], (contact.length - 0.5 * frame.spacing) / frame.velocity,
                1e-9 * times[contact.first]);
  }
}

/// In steady sliding all of the power of friction becomes heat.
TEST(ContactTables, PowerIsBalanced) {
  for (const double friction : {0.0, 0.3}) {
    const Frame frame =
        frameForTables([&](Scene& scene) { scene.interface.frictionCoefficient = friction; });
    const DataTable power = powerTable(frame);
    const double in = number(power, 0, "power_in");
    EXPECT_NEAR(number(power, 0, "power_dissipated") / in, 1, 0.02);
    EXPECT_NEAR(
        in, (frame.state.mu + frame.state.muInterface) * frame.state.normalForce * frame.velocity,
        0.01 * in);
    EXPECT_NEAR(sum(shapeTable(frame), "power") * frame.spacing,
                number(power, 0, "power_dissipated"), 1e-12 * in);
    EXPECT_GT(number(power, 0, "power_free"), 0);
  }
}

/// Power in = F_x v equals the power dissipated, 4 eta v^2 integral u'^2 dx for Kelvin elements.
/// The sum over points misses a part of the integral, and the note says how much is there.
TEST(ContactTables, PointsThatMissPowerAreNamed) {
  const auto isNamed = [](Scheme scheme, std::int64_t oversampling, Rheology rheology) {
    const Frame frame = frameForTables([&](Scene& scene) {
      scene.surface.elements = 30;
      scene.load.normalForce = 0.0034;
      scene.accuracy.scheme = scheme;
      scene.accuracy.oversampling = oversampling;
      scene.elastomer.rheology = rheology;
      if (hasArms(rheology)) scene.elastomer.arms = {{2e7, 1e-3}};
    });
    const DataTable power = powerTable(frame);
    const double part = number(power, 0, "power_dissipated") / number(power, 0, "power_in");
    const std::optional<Message> note = coarsePowerNote(frame);
    EXPECT_EQ(note.has_value(), std::abs(part - 1) > 0.005) << part;
    if (note) {
      EXPECT_NE(note->english().find(" " + printedPercent(part, 4).text + " % of the power"),
                std::string::npos)
          << note->english();
    }
    return note.has_value();
  };
  for (const Rheology rheology : {Rheology::Kelvin, Rheology::StandardSolid}) {
    EXPECT_TRUE(isNamed(Scheme::Linear, 1, rheology));
    EXPECT_FALSE(isNamed(Scheme::Cubic, 64, rheology));
  }
  EXPECT_TRUE(isNamed(Scheme::Nodal, 1, Rheology::Kelvin));
  EXPECT_FALSE(coarsePowerNote(frameForTables([](Scene& scene) { scene.sliding.velocity = 0; })));
}

TEST(ContactTables, CompleteContactIsOneStretchWithoutAnEdge) {
  const Frame frame = frameForTables([](Scene& scene) {
    scene.surface.kind = SurfaceKind::Sine;
    scene.load.normalForce = 100;
    scene.sliding.velocity = 1e-3;
  });
  ASSERT_EQ(frame.state.contactFraction, 1);
  const DataTable contacts = contactsTable(frame);
  ASSERT_EQ(contacts.rows.size(), 1U);
  EXPECT_NEAR(number(contacts, 0, "length"), frame.length, 1e-12);
  EXPECT_TRUE(gapsTable(frame).rows.empty());
  EXPECT_TRUE(std::isnan(timeInContact(frame).front()));
  EXPECT_EQ(derivedNumbers(frame)["contact_spots"], 1);
}

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
