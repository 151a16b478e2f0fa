// The paper's figures: that each is whole, the same every time, and refuses what it sets itself.
#include "core/paper/figure.h"
#include "core/base/stop.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "core/base/input_error.h"
#include "tests/core/paper/claim_of.h"

namespace asperity {
namespace {

using testing::HasSubstr;

FigureOptions quickOptions() {
  FigureOptions options{.realizations = 4, .assignments = {"surface.elements=300"}};
  return options;
}

FigureOptions optionsFor(FigureName name) {
  FigureOptions options = quickOptions();
  // The spacing figure's own lines are long; a short period keeps them small.
  if (name == FigureName::Spacing) options.assignments = {"surface.length=0.0005"};
  if (name == FigureName::Master) options.assignments.clear();
  return options;
}

class EachFigure : public testing::TestWithParam<FigureName> {};

TEST_P(EachFigure, IsWhole) {
  double part = 0;
  FigureOptions options = optionsFor(GetParam());
  options.progress = [&](double now) {
    EXPECT_GE(now, part - 1e-12);
    part = now;
  };
  const Figure figure = makeFigure(GetParam(), options);
  EXPECT_NEAR(part, 1, 1e-9);
  EXPECT_FALSE(figure.sheet.title.empty());
  EXPECT_THAT(figure.sheet.subtitle.english(), HasSubstr("G = 10 MPa"));
  EXPECT_EQ(figure.sheet.diagrams.empty(), GetParam() == FigureName::Contact);
  for (const Diagram& diagram : figure.sheet.diagrams) {
    EXPECT_FALSE(diagram.x.title.empty());
    EXPECT_FALSE(diagram.y.title.empty());
    EXPECT_FALSE(diagram.series.empty());
    for (const DiagramSeries& series : diagram.series) EXPECT_FALSE(series.points.empty());
  }
  ASSERT_FALSE(figure.claims.empty());
  std::set<std::string> ids;
  for (const Claim& claim : figure.claims) {
    EXPECT_TRUE(ids.insert(claim.id).second) << claim.id;
    EXPECT_THAT(claim.where.english(), HasSubstr("p. ")) << claim.id;
    EXPECT_FALSE(claim.claim.empty() || claim.quantity.empty() || claim.criterion.empty());
  }
}

/// Every row of the table has as many cells as the header.
TEST_P(EachFigure, TableIsRectangular) {
  const Figure figure = makeFigure(GetParam(), optionsFor(GetParam()));
  std::istringstream lines(figure.csv);
  std::string line;
  std::getline(lines, line);
  const auto columns = std::count(line.begin(), line.end(), ',');
  EXPECT_GT(columns, 2);
  int rows = 0;
  while (std::getline(lines, line)) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns) << line;
    ++rows;
  }
  EXPECT_GT(rows, 10);
}

TEST_P(EachFigure, GivesTheSameBytesForAnyThreads) {
  FigureOptions one = optionsFor(GetParam()), three = one;
  one.threads = 1;
  three.threads = 3;
  const Figure a = makeFigure(GetParam(), one), b = makeFigure(GetParam(), three);
  EXPECT_EQ(a.csv, b.csv);
  EXPECT_EQ(claimsJson({&a, 1}), claimsJson({&b, 1}));
}

class EachLongFigure : public testing::TestWithParam<FigureName> {};

TEST_P(EachLongFigure, StopsOnRequest) {
  std::stop_source source;
  FigureOptions options = optionsFor(GetParam());
  options.stop = source.get_token();
  options.progress = [&](double) { source.request_stop(); };
  EXPECT_THROW(makeFigure(GetParam(), options), StopRequested);
}

/// From this one on.
std::vector<FigureName> namesFrom(FigureName first) {
  std::vector<FigureName> all;
  for (const FigureEntry& entry : figureEntries())
    if (entry.name >= first) all.push_back(entry.name);
  return all;
}

std::string nameOf(const testing::TestParamInfo<FigureName>& name) {
  return "Number" + std::string(figureEntry(name.param).word);
}

INSTANTIATE_TEST_SUITE_P(Figures, EachFigure, testing::ValuesIn(namesFrom(FigureName::Contact)),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(Figures, EachLongFigure,
                         testing::ValuesIn(namesFrom(FigureName::Velocity)), nameOf);

/// Region IV: the constant level belongs to the literal rule.
TEST(Figures, ConstantLevelHoldsForTheLiteralRuleOnly) {
  const Figure figure = makeFigure(FigureName::Velocity, quickOptions());
  EXPECT_EQ(claimOf(figure, "region_4_constant_level").holds, Verdict::OnlyForScheme);
  EXPECT_EQ(claimOf(figure, "no_convergence_problems").holds, Verdict::OnlyForScheme);
  EXPECT_EQ(claimOf(figure, "region_1_is_linear").holds, Verdict::Yes);
  ASSERT_EQ(figure.sheet.diagrams.size(), 1U);
  std::vector<std::string> regions;
  for (const DiagramSpan& span : figure.sheet.diagrams[0].spans)
    regions.push_back(span.label.english());
  EXPECT_THAT(regions, testing::ElementsAre("I", "II", "III", "IV"));
}

/// Exact statements hold at any number of lines.
TEST(Figures, ExactClaimsHold) {
  const Figure forces = makeFigure(FigureName::Forces, quickOptions());
  EXPECT_EQ(claimOf(forces, "force_over_modulus").holds, Verdict::Yes);
  EXPECT_EQ(claimOf(forces, "equation_8_is_exact").holds, Verdict::Yes);
  const Figure master = makeFigure(FigureName::Master, optionsFor(FigureName::Master));
  EXPECT_EQ(claimOf(master, "temperature_shift").holds, Verdict::Yes);
  EXPECT_EQ(claimOf(master, "dimensionless_variables").holds, Verdict::Yes);
  // No two curves look alike.
  std::set<std::tuple<int, SeriesStroke, SeriesMark>> looks;
  const Diagram& computed = master.sheet.diagrams.front();
  for (const DiagramSeries& series : computed.series)
    EXPECT_TRUE(looks.emplace(series.colour, series.stroke, series.mark).second)
        << series.name.english();
}

/// Eq. (17): the shift closes the distance of curves a decade or two apart.
TEST(Figures, MasterCurveCollapses) {
  FigureOptions options;
  options.realizations = 40;
  const Figure master = makeFigure(FigureName::Master, options);
  EXPECT_EQ(claimOf(master, "master_curve").holds, Verdict::Yes);
}

TEST(Figures, ClaimsAsJson) {
  const Figure figure = makeFigure(FigureName::Contact, {});
  const auto json = nlohmann::json::parse(claimsJson({&figure, 1}));
  ASSERT_EQ(json["claims"].size(), figure.claims.size());
  const auto& first = json["claims"][0];
  for (const char* key : {"figure", "id", "where", "claim", "measured", "uncertainty", "holds",
                          "note", "quantity", "criterion", "expected"})
    EXPECT_TRUE(first.contains(key)) << key;
  EXPECT_EQ(first["holds"], "yes");
  EXPECT_EQ(json["figures"]["1"]["scene"]["schema"], "asperity-scene/1");
}

TEST(Figures, RefuseWhatTheySetThemselves) {
  FigureOptions options = quickOptions();
  options.assignments = {"load.normal_force=1"};
  EXPECT_THROW(figureScene(FigureName::Forces, options), InputError);
  EXPECT_EQ(figureScene(FigureName::Velocity, options).load.normalForce, 1);
  options.assignments = {"ensemble.realizations=3"};
  EXPECT_THROW(figureScene(FigureName::Velocity, options), InputError);
  options.assignments = {"surface.kind=sine"};
  EXPECT_THROW(figureScene(FigureName::Velocity, options), InputError);
  options.assignments = {"surface.rms_height=0"};
  EXPECT_THROW(figureScene(FigureName::Velocity, options), InputError);
}

}  // namespace
}  // namespace asperity
