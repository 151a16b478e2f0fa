#include "core/friction/curve_file.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

namespace asperity {
namespace {

using testing::HasSubstr;

CurvePoint somePoint() {
  CurvePoint point;
  point.velocity = 0.1;
  point.mu = 1.0 / 3;
  point.realizations = 7;
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

}  // namespace
}  // namespace asperity
