#include "core/friction/curve_file.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "core/friction/ensemble.h"

namespace asperity {
namespace {

using testing::HasSubstr;

CurvePoint somePoint() {
  CurvePoint point{.velocity = 0.1, .mu = 1.0 / 3, .realizations = 7};
  return point;
}

TEST(CurveFile, CsvHasTheContractsColumnsAndShortestNumbers) {
  const std::string text = curveCsv({somePoint()});
  EXPECT_THAT(text, HasSubstr("velocity,mu,mu_standard_error,mu_law,contact_fraction,"
                              "rms_slope_contact,indentation,normalized_mu,"
                              "dimensionless_velocity,dimensionless_force,realizations\n"));
  EXPECT_THAT(text, HasSubstr("\n0.1,0.3333333333333333,,,0,,0,,,,7\n"));
}

TEST(CurveFile, JsonCarriesSceneVersionAndSeed) {
  Scene scene;
  scene.surface.seed = 42;
  const auto root = nlohmann::json::parse(curveJson({somePoint()}, scene));
  EXPECT_EQ(root["version"], ASPERITY_VERSION);
  EXPECT_EQ(root["seed"], 42);
  EXPECT_EQ(root["scene"]["surface"]["seed"], 42);
  EXPECT_EQ(root["points"][0]["mu"], 1.0 / 3);
  EXPECT_TRUE(root["points"][0]["mu_law"].is_null());
}

/// N elements with a handful of them in contact: Eq. (4) gives a remainder of the elastic pressure
/// that does not fall with velocity, of either sign. The table says of which rows.
TEST(CurveFile, FrictionBelowWhatElementsResolveHasANote) {
  Scene scene;
  scene.surface.elements = 200;
  scene.accuracy.scheme = Scheme::Nodal;
  scene.accuracy.oversampling = 1;
  scene.sweep = {1e-6, 1e3, 19};
  int negative = 0, noted = 0;
  for (const std::int64_t realizations : {1, 10}) {
    scene.ensemble.realizations = realizations;
    for (std::int64_t seed = 1; seed <= 4; ++seed) {
      scene.surface.seed = seed;
      const std::vector<CurvePoint> points = frictionCurve(scene).points;
      for (const CurvePoint& point : points) {
        negative += point.mu < 0 ? 1 : 0;
        noted += pointNotes(point).empty() ? 0 : 1;
        if (point.mu < 0) {
          EXPECT_EQ(pointNotes(point), "unresolved_friction") << point.velocity;
        }
      }
      EXPECT_EQ(pointNotes(points[13]), "") << "at " << points[13].velocity << " m/s";
      const std::string table = curveCsv(points);
      EXPECT_THAT(table, HasSubstr("realizations,marginal_share,notes\n"));
      EXPECT_THAT(table, HasSubstr(",unresolved_friction\n"));
      const auto root = nlohmann::json::parse(curveJson(points, scene));
      EXPECT_EQ(root["points"][0]["notes"], "unresolved_friction");
      EXPECT_EQ(root["points"][13]["notes"], "");
    }
  }
  EXPECT_GT(negative, 10);
  EXPECT_GT(noted, negative);
}

/// Scenes with a nominal pressure list contacts; the same under a force have the table that they
/// had. A point of few contacts has the note in either.
TEST(CurveFile, ContactSpotsStandInTablesOfScenesThatListThem) {
  Scene scene;
  scene.surface.elements = 500;
  scene.ensemble.realizations = 5;
  scene.sweep = {1e-2, 1e3, 6};
  const std::vector<CurvePoint> before = frictionCurve(scene).points;
  EXPECT_THAT(curveCsv(before), testing::Not(HasSubstr("contact_spots")));
  EXPECT_THAT(curveCsv(before), testing::Not(HasSubstr("notes")));
  scene.load.kind = LoadKind::Pressure;
  scene.load.width = 1;
  scene.load.nominalPressure = scene.load.normalForce / scene.surface.length;
  const std::vector<CurvePoint> points = frictionCurve(scene).points;
  EXPECT_THAT(curveCsv(points), HasSubstr(",contact_spots,notes\n"));
  const auto root = nlohmann::json::parse(curveJson(points, scene));
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i].contactSpots, before[i].contactSpots);
    EXPECT_EQ(root["points"][i]["contact_spots"], points[i].contactSpots);
    const bool few = points[i].contactSpots < kFewContacts;
    EXPECT_EQ(pointNoteSet(before[i]).has(Note::FewContacts), few) << points[i].velocity;
    EXPECT_EQ(pointNotes(points[i]), few ? "few_contacts" : "") << points[i].velocity;
  }
  EXPECT_GE(points.front().contactSpots, kFewContacts);
  EXPECT_LT(points.back().contactSpots, kFewContacts);
}

/// Of stretches that have grown together few are left, and of a single parabola there is one:
/// neither is a want of summits.
TEST(CurveFile, FewContactsAreSingleSummitsOfRoughLines) {
  EXPECT_TRUE(areContactsFew(1, 0.01));
  EXPECT_FALSE(areContactsFew(kFewContacts, 0.01));
  EXPECT_FALSE(areContactsFew(1, 1));
  EXPECT_FALSE(areContactsFew(kNotApplicable, 0.01));
  Scene scene;
  scene.surface.kind = SurfaceKind::Parabola;
  scene.sweep = {1e-2, 1, 3};
  for (const CurvePoint& point : frictionCurve(scene).points) {
    EXPECT_EQ(point.contactSpots, 1);
    EXPECT_FALSE(pointNoteSet(point).has(Note::FewContacts));
  }
}

/// Resolved lines of every shape, in light and in complete contact, at all velocities: none.
TEST(CurveFile, ResolvedFrictionHasNoNote) {
  Scene scene;
  scene.surface.elements = 300;
  scene.ensemble.realizations = 2;
  scene.sweep = {1e-6, 1e3, 10};
  for (const SurfaceKind kind :
       {SurfaceKind::SelfAffine, SurfaceKind::Sine, SurfaceKind::Wedge, SurfaceKind::Parabola})
    for (const double hurst : {0.0, 0.5, 1.0})
      for (const double force : {1e-5, 1e-2, 1e3}) {
        scene.surface.kind = kind;
        scene.surface.hurst = hurst;
        scene.load.normalForce = force;
        const std::vector<CurvePoint> points = frictionCurve(scene).points;
        for (const CurvePoint& point : points)
          EXPECT_EQ(pointNotes(point), "")
              << static_cast<int>(kind) << ", H " << hurst << ", " << force << " N, "
              << point.velocity << " m/s: " << point.mu;
        EXPECT_THAT(curveCsv(points), testing::Not(HasSubstr("notes")));
      }
}

}  // namespace
}  // namespace asperity
