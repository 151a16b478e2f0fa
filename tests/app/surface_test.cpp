// asperity surface of measured files, and the other verbs on scenes of measured surfaces.
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/app/program.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class SurfaceCommandTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    std::string text = "Position [mm];H\xC3\xB6he [\xC2\xB5m]\n";
    for (int i = 0; i < 300; ++i) {
      std::ostringstream row;
      row << 0.002 * i << ";" << std::sin(0.21 * i) + 0.3 * std::cos(0.057 * i * i) + 0.01 * i
          << "\n";
      std::string line = row.str();
      for (char& letter : line) letter = letter == '.' ? ',' : letter;
      text += line;
    }
    program.folder.write("p.csv", text);
    program.folder.write("m.json", R"({"title":"Mine","surface":{"kind":"measured","file":"p.csv"},
        "elastomer":{"rheology":"kelvin","shear_modulus":1e6,"relaxation_time":1e-3},
        "load":{"kind":"pressure","nominal_pressure":1e5,"width":1e-4},
        "sweep":{"velocity_from":0.01,"velocity_to":1,"points":3}})");
  }
};

TEST_F(SurfaceCommandTest, SaysWhatItTookAFileForAndWritesAll) {
  const Said said = program.run("surface p.csv -o v.json -o l.csv -o p.svg");
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_THAT(said.out, AllOf(HasSubstr("300 points"), HasSubstr("summits touch"), HasSubstr("Pdq"),
                              HasSubstr("twice the profile")));
  const auto json = nlohmann::json::parse(read("v.json"));
  EXPECT_EQ(json["reading"]["columns"], 300);
  EXPECT_NEAR(json["reading"]["spacing"], 2e-6, 1e-12);
  EXPECT_GT(json["values"]["raw"]["Pq"], json["values"]["used"]["Pq"]);
  EXPECT_EQ(json["inputs"][0]["sha256"].get<std::string>().size(), 64U);
  EXPECT_TRUE(json["notes"].is_array());
  EXPECT_THAT(read("l.csv"), AllOf(StartsWith("# asperity: "), HasSubstr("\nposition,height\n")));
  EXPECT_THAT(read("p.svg"), HasSubstr("<svg"));
}

TEST_F(SurfaceCommandTest, NamesRoughnessValuesWhereLongWavesAreCut) {
  const Said said = program.run("surface p.csv --json --set surface.long_wave_cut=1e-4");
  EXPECT_EQ(said.status, 0) << said.err;
  const auto values = nlohmann::json::parse(said.out)["values"];
  EXPECT_TRUE(values["used"].contains("Rq"));
  EXPECT_TRUE(values["raw"].contains("Pq"));
}

/// The line that `surface` writes, slid as a profile, has the friction of the file.
TEST_F(SurfaceCommandTest, WritesTheLineThatSlides) {
  ASSERT_EQ(program.run("surface m.json -o l.csv").status, 0);
  const Said measured = program.run("curve m.json"),
             profile =
                 program.run("curve m.json --set surface.kind=profile --set surface.file=l.csv");
  EXPECT_EQ(measured.status, 0) << measured.err;
  EXPECT_EQ(profile.status, 0) << profile.err;
  std::istringstream a(withoutComment(measured.out)), b(withoutComment(profile.out));
  std::string rowA, rowB;
  std::getline(a, rowA);
  std::getline(b, rowB);
  EXPECT_EQ(rowA, rowB);
  EXPECT_THAT(rowA, HasSubstr("nominal_pressure"));
  while (std::getline(a, rowA) && std::getline(b, rowB)) {
    const auto mu = [](const std::string& row) { return std::stod(row.substr(row.find(',') + 1)); };
    EXPECT_NEAR(mu(rowA) / mu(rowB), 1, 1e-9);
  }
}

/// Read again it is neither levelled nor mirrored nor turned over once more.
TEST_F(SurfaceCommandTest, TakesALineThatItWroteAsItStands) {
  ASSERT_EQ(program.run("surface p.csv -o l.csv").status, 0);
  const Said said = program.run("surface l.csv -o again.csv");
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_THAT(said.out, testing::Not(HasSubstr("turned over")));
  std::istringstream written(withoutComment(read("l.csv"))),
      again(withoutComment(read("again.csv")));
  std::string rowA, rowB;
  std::getline(written, rowA);
  std::getline(again, rowB);
  EXPECT_EQ(rowA, rowB);
  int rows = 0;
  const auto height = [](const std::string& row) {
    return std::stod(row.substr(row.find(',') + 1));
  };
  for (; std::getline(written, rowA) && std::getline(again, rowB); ++rows)
    EXPECT_NEAR(height(rowB), height(rowA), 1e-15) << rows;  // m
  EXPECT_EQ(rows, 600);
  EXPECT_FALSE(std::getline(again, rowB));
  const std::string before = read("again.csv");
  const Said remade = program.run("open again.csv --remake");
  EXPECT_EQ(remade.status, 0) << remade.err;
  EXPECT_EQ(read("again.csv"), before);
}

/// The table is read again as the spectrum of random lines.
TEST_F(SurfaceCommandTest, TheSpectrumOfAMeasuredSurfaceTellsItsReliableBand) {
  const Said said = program.run("surface m.json --table spectrum -o s.csv");
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_THAT(withoutComment(read("s.csv")),
              testing::StartsWith("wave_number,power_spectral_density,reliable\n"));
  program.folder.write("r.json", R"({"surface": {"kind": "spectrum", "file": "s.csv",
                                     "spectrum_kind": "c1_two_sided"}})");
  const Said again = program.run("check r.json");
  EXPECT_EQ(again.status, 0) << again.err;
}

TEST_F(SurfaceCommandTest, WorksWithEveryVerb) {
  for (const std::string arguments :
       {"check m.json", "explain m.json", "render m.json -o c.png --size 640x360",
        "curve m.json -o c.csv -o c.json", "accuracy m.json -o acc",
        "explain m.json --set accuracy.target_relative_error=0.05",
        "curve m.json --set accuracy.target_relative_error=0.05",
        "surface m.json --set surface.seam=random_phases",
        "curve m.json --set surface.seam=blend --set surface.line=isotropic_equivalent"}) {
    const Said said = program.run(arguments);
    EXPECT_EQ(said.status, 0) << arguments << "\n" << said.err;
  }
  EXPECT_THAT(program.run("explain m.json").out, HasSubstr("F_N / L = 10 N/m"));
  EXPECT_THAT(program.run("explain m.json --set surface.seam=periodic --set surface.form=none").out,
              HasSubstr("seam_jump"));
}

/// A matrix of four rows, one without any height and two points of the others missing.
TEST_F(SurfaceCommandTest, EveryVerbSaysWhatIsLeftOutAndFilled) {
  std::ostringstream matrix;
  matrix << "# Channel: Topo\n# Width: 100 µm\n# Height: 4 µm\n# Value units: m\n";
  for (int row = 0; row < 4; ++row)
    for (int i = 0; i < 100; ++i) {
      const bool isMissing = row == 1 || (row == 2 && (i == 7 || i == 50));
      if (isMissing)
        matrix << "NaN";
      else
        matrix << 1e-7 * std::sin(0.21 * i + row);
      matrix << (i == 99 ? "\n" : "\t");
    }
  program.folder.write("gaps.txt", matrix.str());
  program.folder.write("g.json", R"({"surface":{"kind":"measured","file":"gaps.txt",
      "gaps":"interpolate"},"ensemble":{"realizations":0},"sweep":{"points":2}})");
  for (const std::string verb : {"surface", "check", "explain", "curve"}) {
    const Said said = program.run(verb + " g.json" + (verb == "curve" ? " -o c.csv" : ""));
    EXPECT_EQ(said.status, 0) << said.err;
    EXPECT_THAT(said.out, AllOf(HasSubstr("one row with fewer than three heights is left out"),
                                HasSubstr("2 points without a height are interpolated")))
        << verb;
  }
  expectRefused("check g.json --set ensemble.realizations=4", 2,
                "4 is more than the rows of the file with 3 measured points or more, which are 3 "
                "of 4; 0 is every one of them");
}

/// Which column is read, what is averaged and what is left out changes friction, so every verb that
/// uses the surface says it, in its JSON, too.
TEST_F(SurfaceCommandTest, EveryVerbSaysHowTheFileWasRead) {
  std::ostringstream table;
  table << "x (um),left (um),right (um)\n";
  const auto add = [&table](int i) {
    table << i << "," << std::sin(0.21 * i) << "," << std::cos(0.3 * i) << "\n";
  };
  for (int i = 0; i < 100; ++i) {
    add(i);
    if (i == 50) add(i);
  }
  program.folder.write("two.csv", table.str());
  program.folder.write("t.json", R"({"surface":{"kind":"measured","file":"two.csv"},
      "ensemble":{"realizations":0},"sweep":{"points":2}})");
  program.folder.write("mu.csv", "v (m/s),mu\n0.001,0.1\n0.01,0.2\n0.1,0.3\n1,0.2\n10,0.1\n");
  const std::string column = "one of 2 columns that could be", repeated = "repeats a position";
  for (const std::string verb :
       {"surface", "check", "explain", "curve", "cutoff",
        "map --x sliding.velocity=0.1:1:2 --y load.normal_force=0.1:1:2",
        "render -o r.png --size 640x360", "render -o r.csv", "accuracy -o accuracy",
        "fit --data mu.csv --vary elastomer.relaxation_time=1e-5:1 -o fit"}) {
    const std::size_t end = std::min(verb.find(' '), verb.size());
    const std::string arguments = verb.substr(0, end) + " t.json" + verb.substr(end) + " --json";
    const Said said = program.run(arguments);
    EXPECT_EQ(said.status, 0) << said.err;
    EXPECT_THAT(said.err, AllOf(HasSubstr(column), HasSubstr(repeated))) << arguments;
    const std::string facts = nlohmann::json::parse(said.out)["reading"]["facts"].dump();
    EXPECT_THAT(facts, AllOf(HasSubstr(column), HasSubstr(repeated))) << arguments;
  }
  program.folder.write("study.json", R"({"schema":"asperity-study/1","scene":"t.json",
      "space":{"load.normal_force":{"from":0.1,"to":1,"points":2}},"outputs":["mu"]})");
  program.folder.write("batch.json", R"({"schema":"asperity-batch/1","size":"400x400",
      "entries":[{"name":"a","scene":"t.json"},{"name":"b","scene":"t.json"}]})");
  for (const std::string arguments :
       {"study run study.json --plan", "study run study.json -o store",
        "batch batch.json -o sheets"})
    EXPECT_THAT(run(arguments), AllOf(HasSubstr(column), HasSubstr(repeated))) << arguments;
  const auto answer = [&](const std::string& arguments) {
    return nlohmann::json::parse(program.run(arguments + " --json").out);
  };
  for (const char* run : {"study run study.json --plan", "study run study.json -o store"})
    EXPECT_THAT(answer(run)["reading"].dump(), HasSubstr(repeated)) << run;
  for (const auto& scene : answer("batch batch.json -o sheets")["scenes"])
    EXPECT_THAT(scene["reading"].dump(), HasSubstr(repeated));
}

/// A constant height is neither a circle of any radius nor has it a spectrum.
TEST_F(SurfaceCommandTest, SaysThatAProfileIsFlat) {
  for (const std::string height : {"0", "5.3", "-0.7"}) {
    std::string table = "x (um),z (um)\n";
    for (int i = 0; i < 100; ++i) table += std::to_string(i) + "," + height + "\n";
    program.folder.write("flat.csv", table);
    const std::string said = run("surface flat.csv");
    EXPECT_THAT(said, HasSubstr("all heights of the row are the same")) << height;
    EXPECT_THAT(said, Not(AnyOf(HasSubstr("circle"), HasSubstr("reliable"), HasSubstr("relied"))))
        << height;
  }
}

TEST_F(SurfaceCommandTest, SaysWhatIsLeftOutAtTheEnds) {
  std::string table = "x (um),z (um)\n";
  for (int i = 0; i < 100; ++i)
    table += std::to_string(i) + "," +
             (i < 10 || i > 97 ? "NaN" : std::to_string(std::sin(0.21 * i))) + "\n";
  program.folder.write("p.csv", table);
  EXPECT_THAT(run("check m.json --set surface.gaps=interpolate"),
              HasSubstr("12 points without a height at the ends are left out"));
}

/// One point is no points.
TEST_F(SurfaceCommandTest, CountsOneAsOne) {
  std::string table = "x (um),z (um)\n";
  for (int i = 0; i < 100; ++i)
    for (int repeat = 0; repeat < (i == 50 ? 2 : 1); ++repeat)
      table += std::to_string(i) + "," + std::to_string(i == 30 ? 40 : std::sin(0.21 * i)) + "\n";
  program.folder.write("one.csv", table);
  EXPECT_THAT(run("surface one.csv"), AllOf(HasSubstr("One row repeats a position"),
                                            HasSubstr("one point of all rows stands far out")));
}

/// The height of an equivalent line is another one than that of its row: both factors are told.
TEST_F(SurfaceCommandTest, TellsHeightAndSlopeOfTheEquivalentLine) {
  const std::string as = " --set surface.line=";
  const auto valuesOf = [&](const std::string& line) {
    const Said said = program.run("surface p.csv --json" + as + line);
    EXPECT_EQ(said.status, 0) << said.err;
    return nlohmann::json::parse(said.out);
  };
  const auto row = valuesOf("as_measured"), line = valuesOf("isotropic_equivalent");
  for (const auto& [ratio, value] :
       {std::pair{"height_ratio", "rms_height"}, {"slope_ratio", "rms_slope"}}) {
    EXPECT_EQ(row["values"][ratio], 1);
    EXPECT_NEAR(line["values"][ratio].get<double>(),
                line["statistics"][value].get<double>() / row["statistics"][value].get<double>(),
                1e-12);
  }
  // The parameters of ISO 21920-2 are those of the row.
  EXPECT_EQ(row["values"]["used"], line["values"]["used"]);
  EXPECT_THAT(program.run("surface p.csv" + as + "isotropic_equivalent").out,
              AllOf(HasSubstr("its rms height is "), HasSubstr(" times and its rms slope ")));
}

TEST_F(SurfaceCommandTest, RefusesInOneLine) {
  program.folder.write("bad.csv", "not a surface\n");
  expectRefused("surface bad.csv", 2, "bad.csv");
  expectRefused("surface none.csv", 2, "none.csv");
  expectRefused("surface p.csv --set surface.row=2", 2, "surface.row");
  expectRefused("surface p.csv --set surface.long_wave_cut=1e-7", 2, "surface.long_wave_cut");
  expectRefused("surface p.csv --set surface.blend_length=1e-4", 2, "surface.blend_length");
  expectRefused("surface p.csv --set surface.hurst=0.5", 2, "surface.hurst");
  expectRefused("surface p.csv --set surface.length=1", 2, "surface.length");
  expectRefused("curve m.json --set ensemble.realizations=3", 2, "ensemble.realizations");
}

}  // namespace
}  // namespace asperity
