// What a call says about where to look and with what to compare, in the pictures and tables.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/app/program.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Json = nlohmann::json;

constexpr const char* kPicture = " --size 900x500 --set surface.elements=64 ";
constexpr const char* kMotion =
    " --set sliding.kind=oscillation --set sliding.velocity=0 --set sliding.amplitude=2"
    " --set sliding.frequency=10 --set sliding.duration=0.1 ";

class ViewTest : public ProgramTest {
 protected:
  /// The SVG of the contact without what it says of itself and without fonts.
  std::string drawing(const std::string& arguments) {
    run("render s.json -o c.svg" + std::string(kPicture) + arguments);
    const std::string svg = read("c.svg");
    return svg.substr(std::min(svg.size(), svg.find("</style>")));
  }
  /// Its texts, "a|b|".
  std::string texts(const std::string& arguments) {
    const std::string svg = drawing(arguments);
    std::string all;
    for (std::size_t end = svg.find("</text>"); end != svg.npos;
         end = svg.find("</text>", end + 1)) {
      const std::size_t from = svg.rfind("<text", end);
      const std::size_t begin = svg.find('>', from) + 1;
      bool isInside = false;
      for (const char c : svg.substr(begin, end - begin)) {
        if (c == '<') isInside = true;
        if (!isInside) all += c;
        if (c == '>') isInside = false;
      }
      all += '|';
    }
    return all;
  }
};

TEST_F(ViewTest, APartOfTheLineIsShownBetweenItsEnds) {
  EXPECT_THAT(texts("--view 4e-3:6e-3"),
              AllOf(HasSubstr("|4.0|"), HasSubstr("|6.0|"), Not(HasSubstr("|14|"))));
  EXPECT_THAT(texts(""), HasSubstr("|14|"));
  EXPECT_EQ(drawing("--view 0:0.02"), drawing(""));  // the whole period
}

TEST_F(ViewTest, HeightsAreThoseOfThePart) {
  const auto exaggeration = [&](const std::string& arguments) {
    const std::string shown = texts(arguments), words = "vertical exaggeration ";
    return std::stod(shown.substr(shown.find(words) + words.size()));
  };
  const double whole = exaggeration("");
  // The heights of the whole line would divide the exaggeration by ten.
  EXPECT_GT(exaggeration("--view 4e-3:6e-3"), 1.5 * whole / 10);
}

TEST_F(ViewTest, PositionsAndTimesMayHaveUnits) {
  EXPECT_EQ(drawing("--view '4 mm:6mm'"), drawing("--view 4e-3:6e-3"));
  EXPECT_EQ(drawing("--heights -10um:10um"), drawing("--heights -1e-5:1e-5"));
  EXPECT_EQ(drawing("--probe '3 mm'"), drawing("--probe 3e-3"));
  EXPECT_EQ(drawing("--magnify -3mm"), drawing("--magnify -3e-3"));
  EXPECT_EQ(drawing("--slid 500um"), drawing("--slid 5e-4"));
  EXPECT_EQ(drawing("--at '2 ms'"), drawing("--at 2e-3"));
}

TEST_F(ViewTest, HeightsAreSaidInMetresOrAsTheirExaggeration) {
  EXPECT_THAT(texts("--heights -1e-5:1e-5"), AllOf(HasSubstr("|10|"), HasSubstr("\u221210|")));
  for (const auto& [times, shown] : {std::pair("100", "100"), {"450", "450"}, {"2000", "2,000"}})
    EXPECT_THAT(texts(std::string("--exaggeration ") + times),
                HasSubstr("vertical exaggeration " + std::string(shown) + "×"));
  EXPECT_THAT(texts("--exaggeration 0.5"), HasSubstr("heights reduced 0.5×"));
  EXPECT_THAT(texts("--exaggeration 1"), HasSubstr("to scale"));
}

/// Surfaces of everyday life are drawn as they are, unless a call says otherwise; the rest fills
/// the picture.
TEST_F(ViewTest, RoadsAndPapersAreDrawnToScale) {
  for (const char* name : {"tyre_on_asphalt", "rubber_on_sandpaper", "shoe_on_concrete"}) {
    program.folder.write(
        "s.json", TemporaryFolder::read(std::filesystem::path(ASPERITY_RESOURCES_DIR) / "scenes" /
                                        (std::string(name) + ".json")));
    const auto said = [&](const std::string& options) {
      run("render s.json -o c.svg --size 1280x720 " + options);
      return read("c.svg");
    };
    EXPECT_THAT(said(""), HasSubstr("to scale")) << name;
    EXPECT_THAT(said("--exaggeration 4"), HasSubstr("vertical exaggeration 4×")) << name;
    EXPECT_THAT(said("--heights -1e-5:1e-5"), Not(HasSubstr("to scale"))) << name;
  }
}

TEST_F(ViewTest, ColoursEndWhereTheyAreTold) {
  EXPECT_THAT(texts("--colours-to 1234"), AllOf(HasSubstr("|1.23|"), HasSubstr("(kN/m)|")));
  EXPECT_THAT(texts("--overlay power --colours-to 3"),
              AllOf(HasSubstr("|3|"), HasSubstr("(W/m)|")));
  EXPECT_THAT(texts("--overlay relaxation --colours-to 5e-3"),
              AllOf(HasSubstr("|5|"), HasSubstr("(ms)|")));
}

TEST_F(ViewTest, CrosshairAndMagnifierStandWhereTheyAreTold) {
  EXPECT_THAT(texts("--probe 0.005"), HasSubstr("gap"));
  EXPECT_THAT(texts(""), Not(HasSubstr("gap")));
  EXPECT_NE(drawing("--magnify 0.005"), drawing(""));
}

/// After a whole period everything is where it was; after half of one it is not.
TEST_F(ViewTest, SteadySlidingIsShownAtItsMoment) {
  const std::string velocity = " --set sliding.velocity=2";
  EXPECT_EQ(drawing("--slid 0.005" + velocity), drawing("--at 0.0025" + velocity));
  const auto paths = [this](const std::string& arguments) {
    // Without the readings above, which say how far the line has come.
    std::string svg = drawing(arguments);
    for (std::size_t at = svg.find("<text"); at != svg.npos; at = svg.find("<text"))
      svg.erase(at, svg.find("</text>", at) + 7 - at);
    std::erase(svg, '\n');
    return svg;
  };
  EXPECT_NE(paths("--slid 0.01"), paths(""));
  EXPECT_EQ(paths("--slid 0.02"), paths(""));
  EXPECT_THAT(texts("--slid 0.005"), HasSubstr("slid 5.00 mm"));
}

/// The moments of a motion are those of its film.
TEST_F(ViewTest, AMotionIsShownAtItsMoment) {
  EXPECT_THAT(texts(kMotion + std::string("--at 0.05")), HasSubstr("t = 50."));
  EXPECT_EQ(texts(kMotion + std::string("--at 0")).find("t = "), std::string::npos);
  const std::string whole = texts(kMotion);
  EXPECT_THAT(whole, HasSubstr("t = 100 ms"));
  const Said end =
      program.run("render s.json -o c.svg --json --at 0.1" + std::string(kPicture) + kMotion);
  const Said usual = program.run("render s.json -o c.svg --json" + std::string(kPicture) + kMotion);
  EXPECT_EQ(Json::parse(end.out)["indentation"], Json::parse(usual.out)["indentation"]);
  EXPECT_EQ(Json::parse(end.out)["picture"]["at"], 0.1);
}

TEST_F(ViewTest, ThePictureSaysHowItWasLookedAt) {
  run("render s.json -o c.svg --view 1e-3:2e-3 --heights -1e-6:1e-6 --colours-to 100 --probe 1e-3"
      " --slid 0.001 --layout both --compare linear:2:3" +
      std::string(kPicture));
  const std::string text = read("c.svg");
  for (const char* part : {"view", "heights", "colours_to", "probe", "slid", "compared_with"})
    EXPECT_THAT(text, HasSubstr(part));
}

/// The picture of a window of 1024 x 700: the whole legend is beside the curves, which have more
/// than two marks on their axis.
TEST_F(ViewTest, ALowPictureOfContactAndCurveIsWhole) {
  run("render s.json -o c.svg --layout both --size 670x420 --language de");
  const std::string text = read("c.svg");
  EXPECT_THAT(text, AllOf(HasSubstr(">diese Linie, jetzt<"), HasSubstr(">Gl. (11)<"),
                          HasSubstr("± Standardfehler<"), Not(HasSubstr(" weitere<"))));
  // A crest at the right end moves the normal force towards the middle, and all labels have room.
  run("render figure_1 -o f.svg --layout both --size 670x420 --set ensemble.realizations=2");
  EXPECT_THAT(read("f.svg"), AllOf(HasSubstr("200 mN"), HasSubstr("233 µN"), HasSubstr("slides")));
}

/// The panel of the difference is drawn or missed aloud.
TEST_F(ViewTest, AComparisonIsDrawnWholeOrRefused) {
  const std::string compared = " --compare linear:2:3 --set surface.elements=64";
  const std::string call = "render s.json -o c.svg --layout both --size ";
  const Said said = program.run(call + "891x160" + compared);
  EXPECT_EQ(said.status, 2);
  ASSERT_THAT(said.err, HasSubstr("no room for the difference"));
  const std::size_t named = said.err.find("; 891x") + 2;
  run(call + said.err.substr(named, said.err.find(' ', named) - named) + compared);
  EXPECT_THAT(read("c.svg"), HasSubstr("\u0394 (%)")) << "the axis of the difference, in short";
  run("render s.json -o c.svg --layout both --size 891x545" + compared);
  EXPECT_THAT(read("c.svg"), HasSubstr("\u0394 (%)"));
  run("render s.json -o c.svg --layout both --size 1200x1000" + compared);
  EXPECT_THAT(read("c.svg"), HasSubstr("difference"));
}

TEST_F(ViewTest, WhatCannotBeMeantIsRefused) {
  const auto refused = [this](const std::string& arguments, const std::string& says) {
    expectRefused("render s.json -o c.png " + arguments, 2, says);
  };
  for (const char* text : {"1e-3", "2e-3:1e-3", "1:1", "a:b", "0:inf", "0:1e-3x"})
    refused(std::string("--view ") + text, "--view: ");
  refused("--view 0:2", "--view: 0:2 is not 2e-11 to 1 m wide, of which the most are 50 periods");
  refused("--view 1e9:1000000000.01", " m is not within 20000 m of 0");
  refused("--slid 0.005 --at 3", "--slid: cannot be combined with --at");
  refused("--heights 1e-6", "--heights: 1e-6 is not FROM:TO in m");
  refused("--exaggeration 0", "--exaggeration");
  refused("--exaggeration 10 --heights 0:1", "--exaggeration: cannot be combined with --heights");
  refused("--colours-to -1", "--colours-to");
  refused("--colours-to 1 --overlay none", "no colours");
  refused("--probe 1e9", "--probe");
  refused("--magnify nan", "--magnify");
  refused("--at -1", "--at: -1 is outside 0 to 1e12 s");
  refused("--at nan", "--at");
  refused("--at '3 mm'", "--at: 3 mm is a length; expected a time, such as 1 ms");
  refused("--probe 3furlongs", "--probe: 'furlongs' is not a known unit; expected a length");
  refused("--view 1ms:2ms", "--view: 1ms is a time; expected a length, such as 20 mm");
  refused("--slid 1e300", "--slid");
  refused("--at 1" + std::string(kMotion), "after the motion's end");
  refused("--slid 1e-3" + std::string(kMotion), "--slid: belongs to steady sliding");
  expectRefused("render s.json -o c.gif --at 1e-3", 2, "--at: shows one moment");
  expectRefused("render s.json -o frames --slid 1e-3", 2, "--slid: shows one moment");
}

/// An option of a part that is not shown does nothing: that is said, not done.
TEST_F(ViewTest, OptionsOfAnotherLayoutAreRefused) {
  for (const char* option :
       {"--overlay power", "--overlay pressure", "--view 0:1e-3", "--heights 0:1", "--probe 0",
        "--exaggeration 9", "--colours-to 3", "--magnify 0", "--slid 1e-3", "--at 1e-3"})
    expectRefused(std::string("render s.json -o c.png --layout curve ") + option, 2,
                  "applies only to the contact, which --layout curve does not show");
  for (const char* option : {"--compare linear", "--with load.normal_force=1", "--x-range 1:2",
                             "--y-range 1:2", "--axes dimensionless"})
    expectRefused(std::string("render s.json -o c.png ") + option, 2,
                  "applies only to the curve, which --layout contact does not show");
}

TEST_F(ViewTest, ComparedCurvesAreInPictureAndTables) {
  run("curve s.json -o c.svg -o c.csv -o c.json --compare linear:4:5 --with load.normal_force=0.1"
      " --with 'surface.hurst=0.5;load.normal_force=1'");
  EXPECT_THAT(read("c.svg"), AllOf(HasSubstr("linear x4, 5 lines"), HasSubstr("100 mN")));
  const std::string table = read("c.csv");
  EXPECT_THAT(table, AllOf(StartsWith("# asperity: "), HasSubstr("relative_difference"),
                           HasSubstr("\n\"H = 0.5, F\u2099 = 1 N"),
                           HasSubstr("\n\"linear x4, 5 lines\",")));
  const Json answer = Json::parse(read("c.json"));
  EXPECT_EQ(answer["points"].size(), 5U);
  EXPECT_EQ(answer["with"].size(), 2U);
  EXPECT_EQ(answer["compared"]["points"].size(), 5U);
  // The same difference and error in every table.
  const Json& compared = answer["compared"]["points"][2];
  const std::string row = table.substr(table.find("\n\"linear x4, 5 lines\",") + 1);
  std::istringstream rows(row);
  std::string line;
  for (int k = 0; k < 3; ++k) std::getline(rows, line);
  const std::size_t comma = line.rfind(',');
  EXPECT_EQ(std::stod(line.substr(comma + 1)), compared["relative_difference_standard_error"]);
  EXPECT_EQ(std::stod(line.substr(line.rfind(',', comma - 1) + 1)),
            compared["relative_difference"]);
  // One of the beside is the curve that its scene has by itself.
  const Said own = program.run("curve s.json --json --set load.normal_force=0.1");
  EXPECT_EQ(answer["with"][0]["points"][2]["mu"], Json::parse(own.out)["points"][2]["mu"]);
  EXPECT_THAT(program.run("open --json c.csv").out, HasSubstr("\"realizations\": 6"));
}

TEST_F(ViewTest, ASemicolonInAValueIsWrittenWithABackslash) {
  run("curve s.json -o c.json --with 'title=one\\;two;load.normal_force=0.1' --with 'title=a\\b'");
  const Json answer = Json::parse(read("c.json"));
  ASSERT_EQ(answer["with"].size(), 2U);
  EXPECT_THAT(std::string(answer["with"][0]["name"]), HasSubstr("100 mN"));
  expectRefused("curve s.json --with 'title=one;two'", 2,
                "--with: 'two' between two ; is not KEY=VALUE; a ; that belongs to a value is "
                "written \\;");
  expectRefused("curve s.json --with 'load.normal_force=1;'", 2, "--with: ''");
}

/// Of the line itself, as the window's is; a difference of heights would be another.
TEST_F(ViewTest, TheCrosshairReadsTheSlopeOfTheLine) {
  const auto slopeOf = [this](const std::string& arguments) {
    const std::string all = texts(arguments);
    const std::size_t at = all.find("slope z\u2032|") + std::string("slope z\u2032|").size();
    return all.substr(at, all.find('|', at) - at);
  };
  // Just beside the tip of a wedge, over which a difference would be 0.
  const std::string wedge =
      " --set surface.kind=wedge --set surface.slope=0.002 --set load.normal_force=1e-4"
      " --set sliding.kind=start --set sliding.duration=1e-6 --set sliding.velocity=1e-9 ";
  EXPECT_EQ(slopeOf(wedge + "--probe 0.01"), "\u22120.00200");
}

/// The scene's own table keeps the columns that people script against.
TEST_F(ViewTest, ThePlainTableStaysAsItIs) {
  EXPECT_THAT(program.run("curve s.json").out, HasSubstr("\nvelocity,mu,mu_standard_error,mu_law"));
  run("curve s.json -o a.csv -o a.png --axes dimensionless");
  EXPECT_THAT(read("a.csv"), HasSubstr("\nvelocity,mu,mu_standard_error,mu_law"));
}

TEST_F(ViewTest, AxesAndRangesOfTheCurve) {
  run("curve s.json -o a.svg --axes dimensionless");
  EXPECT_THAT(read("a.svg"), HasSubstr("normalized friction"));
  run("curve s.json -o r.svg --x-range 1e-2:1e1");
  run("curve s.json -o p.svg");
  EXPECT_NE(read("r.svg"), read("p.svg"));
}

TEST_F(ViewTest, ComparisonsThatCannotBeMeantAreRefused) {
  for (const char* text :
       {"quadratic", "linear:0", "linear:65", "nodal:2", "linear:2:0", "linear:2:3:4", "linear:x"})
    expectRefused(std::string("curve s.json --compare ") + text, 2, "--compare: ");
  expectRefused("curve s.json --compare linear --set accuracy.target_relative_error=0.01", 2,
                "--compare needs the same resolution");
  expectRefused("curve s.json --with load.normal_farce=1", 2, "--with: load.normal_farce");
  expectRefused("curve s.json --with load.normal_force", 2, "--with");
  expectRefused("curve s.json --with sliding.kind=step", 2, "--with: sliding.kind: ");
  expectRefused("curve s.json -o a.png --x-range 0:1", 2, "not above 0");
  expectRefused("curve s.json -o a.png --axes round", 2, "--axes: round is not one of");
  for (const char* option : {"--axes dimensionless", "--x-range 1:2", "--y-range 1:2"})
    for (const char* verb : {"curve s.json ", "curve s.json -o a.csv "})
      expectRefused(std::string(verb) + option, 2, "belongs to pictures, and no output is one");
}

}  // namespace
}  // namespace asperity
