// Tables of the contact against the sums and identities that their columns promise.
#include "core/run/contact_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

}  // namespace
}  // namespace asperity
