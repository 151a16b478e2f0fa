// Pictures, films and sequences as other programs see them.
#include <gmock/gmock.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "tests/app/program.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

constexpr const char* kSmall = " --size 320x200 --set surface.elements=64 ";

class ExportTest : public ProgramTest {
 protected:
  bool has(const std::string& name) const { return std::filesystem::exists(program.folder / name); }
  /// What another program says of our files; a missing one skips the test.
  std::string other(const std::string& line) const {
    const auto out = program.folder / ".other";
    const int status = std::system(
        ("cd '" + program.folder.path().string() + "'; " + line + " >.other 2>&1").c_str());
    const std::string said = TemporaryFolder::read(out);
    std::filesystem::remove(out);
    EXPECT_EQ(status, 0) << line << "\n" << said;
    return said;
  }
};

TEST_F(ExportTest, OverlaysSayWhatTheirColoursMean) {
  for (const auto& [overlay, title] : {std::pair{"pressure", "line load ("},
                                       {"relaxation", "time since contact"},
                                       {"power", "dissipated power"}}) {
    const std::string file = std::string(overlay) + ".svg";
    run("render s.json --size 960x540 --set surface.elements=64 --overlay " + std::string(overlay) +
        " -o " + file);
    EXPECT_THAT(read(file), HasSubstr(title));
  }
  run("render s.json --size 960x540 --set surface.elements=64 --overlay none -o none.svg");
  EXPECT_THAT(read("none.svg"), Not(HasSubstr("line load (")));
  const Said said = program.run("render s.json -o x.svg --overlay heat");
  EXPECT_EQ(said.status, 2);
  EXPECT_THAT(said.err, HasSubstr("--overlay"));
  EXPECT_FALSE(has("x.svg"));
}

TEST_F(ExportTest, VectorPicturesAreVectorsWithTheirFonts) {
  run(std::string("render s.json -o a.svg") + kSmall);
  run("curve s.json -o c.svg -o c.pdf -o c.png --scale 192dpi --size 1200x800");
  run(std::string("render s.json -o a.pdf") + kSmall);
  for (const char* svg : {"a.svg", "c.svg"})
    EXPECT_THAT(read(svg), AllOf(HasSubstr("<path"), HasSubstr("<text"), Not(HasSubstr("<image"))));
  other("rsvg-convert a.svg -o a_svg.png && rsvg-convert c.svg -o c_svg.png");
  for (const char* pdf : {"a.pdf", "c.pdf"}) {
    EXPECT_THAT(other(std::string("pdffonts ") + pdf), HasSubstr("yes"));
    other(std::string("pdftoppm -r 50 -png ") + pdf + " page");
  }
  EXPECT_EQ(other("pdfimages -list c.pdf | tail -n +3"), "");
  // Of a contact only the soft light of the elastomer is an image, with its mask; Qt's PDF has no
  // gradients of opacity. The hatching of the rigid body is lines.
  EXPECT_EQ(other("pdfimages -list a.pdf | tail -n +3 | cut -c12-17 | grep -c image"), "1\n");
  // 1200 x 800 pixels at twice 96 an inch.
  EXPECT_THAT(other("pdfinfo c.pdf"), HasSubstr("450 x 300 pts"));
  EXPECT_THAT(other("identify -units PixelsPerInch -format '%wx%h %x' c.png"),
              StartsWith("1200x800 19"));
}

TEST_F(ExportTest, EveryPictureGivesItsSceneBackAndIsTheSameAgain) {
  run("curve s.json -o a.png -o a.svg -o a.pdf --set load.normal_force=0.02 --threads 1");
  run("curve s.json -o b.png -o b.svg -o b.pdf --set load.normal_force=0.02 --threads 2");
  for (const std::string extension : {".png", ".svg", ".pdf"}) {
    EXPECT_EQ(read("a" + extension), read("b" + extension)) << extension;
    EXPECT_THAT(program.run("open --json a" + extension).out, HasSubstr("\"normal_force\": 0.02"));
  }
}

TEST_F(ExportTest, TransparentPicturesHaveNoBackground) {
  run(std::string("render s.json -o a.png --transparent") + kSmall);
  EXPECT_THAT(other("identify -format '%[channels] %[pixel:p{0,0}]' a.png"),
              AllOf(HasSubstr("a "), HasSubstr(",0)")));
  run(std::string("render s.json -o b.png --theme dark") + kSmall);
  EXPECT_THAT(other("identify -format '%[opaque]' b.png"), testing::ContainsRegex("[Tt]rue"));
}

TEST_F(ExportTest, WhatDrawsAgrees) {
  run(std::string("render s.json -o a.png --backend osmesa") + kSmall);
  run(std::string("render s.json -o b.png --backend egl") + kSmall);
  other(
      "compare -metric AE -fuzz 0.6% a.png b.png null: 2>count; test \"$(cat count)\" = 0; rm "
      "count");
  run(std::string("render s.json -o c.png --backend raster") + kSmall);
  other(
      "compare -metric AE -fuzz 5% a.png c.png null: 2>count; test \"$(cat count)\" -lt 64; rm "
      "count");
  // What draws by itself needs no library, and changes no byte between threads or runs.
  run(std::string("render s.json -o d.png --threads 1") + kSmall,
      "ASPERITY_OSMESA_LIBRARY=libNowhere.so ASPERITY_EGL_LIBRARY=libNowhere.so");
  EXPECT_EQ(read("c.png"), read("d.png"));
}

TEST_F(ExportTest, FilmsAreWholeHoldTheirSceneAndRepeatTheirBytes) {
  for (const std::string kind : {"mp4", "webm", "gif", "webp"}) {
    SCOPED_TRACE(kind);
    run("render s.json -o a." + kind + " --frames 5 --fps 10" + kSmall);
    run("render s.json -o b." + kind + " --frames 5 --fps 10 --threads 1" + kSmall);
    EXPECT_EQ(read("a." + kind), read("b." + kind));
    EXPECT_THAT(program.run("open --json a." + kind).out, HasSubstr("\"elements\": 64"));
    if (kind != "webp")  // ffmpeg 5 writes it, but cannot read it
      EXPECT_THAT(other("ffprobe -v error -count_frames -show_entries "
                        "stream=width,height,r_frame_rate,nb_read_frames -of csv=p=0 a." +
                        kind),
                  HasSubstr("320,200,10/1,5"));
    else
      EXPECT_EQ(other("identify -format '%n ' a.webp").substr(0, 2), "5 ");
  }
}

TEST_F(ExportTest, TransparentFilms) {
  expectRefused("render s.json -o a.mp4 --transparent", 2, "mp4 does not support transparency");
  run(std::string("render s.json -o a.webp --transparent --frames 2") + kSmall);
  EXPECT_THAT(other("identify -format '%[pixel:p{0,0}]' 'a.webp[0]'"), HasSubstr(",0)"));
}

TEST_F(ExportTest, WithoutFfmpegFilmsAreRefusedInOneLine) {
  expectRefused("render s.json -o a.mp4", 1, "films need the program ffmpeg", "PATH=/nowhere");
}

TEST_F(ExportTest, AFilmThatIsKilledOrFindsNoRoomLeavesNothing) {
  for (const char* delay : {"0.2", "0.5", "1"}) {
    program.run(std::string("render s.json -o a.webm --frames 2000") + kSmall,
                std::string("timeout -s KILL ") + delay);
    EXPECT_THAT(program.folder.names(), ElementsAre("s.json"));
  }
  for (const std::string kind : {"mp4", "webm", "gif", "webp"}) {
    const Said said = program.runOnFullDisk("render s.json -o a." + kind + " --frames 3" + kSmall);
    EXPECT_EQ(said.status, 1) << kind;
    EXPECT_THAT(said.err, HasSubstr("a." + kind + ": cannot be written")) << kind;
    EXPECT_THAT(program.folder.names(), ElementsAre("s.json"));
  }
}

TEST_F(ExportTest, LengthOfAFilm) {
  const auto frames = [this](const std::string& arguments) {
    const Said said = program.run("render s.json --json -o f.gif --fps 4" + arguments + kSmall);
    EXPECT_EQ(said.status, 0) << said.err;
    return nlohmann::json::parse(said.out)["picture"]["frames"].get<int>();
  };
  EXPECT_EQ(frames(" --duration 2"), 8);
  // A period takes 0.02 s at 1 m/s: two of them, a hundred times as slow.
  EXPECT_EQ(frames(" --cycles 2 --slow-motion 100"), 16);
  EXPECT_EQ(frames(" --slow-motion 50 --duration 1"), 4);
  expectRefused("render s.json -o f.gif --frames 3 --duration 1", 2, "--duration");
  expectRefused("render s.json -o f.gif --frames 3 --cycles 1 --slow-motion 9", 2, "--slow-motion");
  expectRefused("render s.json -o f.gif --slow-motion 3 --set sliding.velocity=0", 2, "above 0");
  expectRefused("render s.json -o f.gif --slow-motion 1e12", 2, "frames are more than");
}

TEST_F(ExportTest, ASequenceGoesOnWhereItStopped) {
  const std::string arguments = std::string(" --frames 6 --json") + kSmall;
  run("render s.json -o whole" + arguments);
  run("render s.json -o part" + arguments);
  for (const char* name : {"part/frame_0002.png", "part/frame_0005.png", "part/frame_0006.png"})
    std::filesystem::remove(program.folder / name);
  const Said said = program.run("render s.json -o part --resume" + arguments);
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_EQ(nlohmann::json::parse(said.out)["pipeline"]["frames_drawn"], 3);
  EXPECT_THAT(program.folder.names("part"), testing::SizeIs(6));
  for (const std::string& name : program.folder.names("whole"))
    EXPECT_EQ(read("whole/" + name), read("part/" + name)) << name;
  other("ffmpeg -v error -i whole/frame_%04d.png -f null -");
  expectRefused("render s.json -o part --resume --frames 6 --size 320x200", 2,
                "frame_0001.png: was made by another scene");
  expectRefused("render s.json -o a.png --resume", 2, "--resume");
}

/// A slide keeps the shape of the screen; its contact leaves the chart the room for its legend.
TEST_F(ExportTest, ASlideOfContactAndCurveKeepsItsSizeAndItsWholeLegend) {
  run("render s.json -o slide.svg --layout both --style slides");
  EXPECT_THAT(read("slide.svg"),
              AllOf(HasSubstr("width=\"1920\" height=\"1080\""), HasSubstr(">this line, now<"),
                    HasSubstr(">Eq. (11)<"), HasSubstr(">v = 1 m/s<")));
}

/// Also where the numbers of the curve need more space than those of the contact.
TEST_F(ExportTest, FramesOfContactAndCurveBeginAtOnePlace) {
  const std::regex frame("<rect x=\"([1-9][0-9.]*)\" y=\"[0-9.]*\" width=\"([0-9.]*)\"");
  for (const char* size : {"86mmx70mm", "400x300", "1280x720"}) {
    run(std::string("render s.json -o frames.svg --layout both --size ") + size);
    const std::string svg = read("frames.svg");
    std::set<std::string> lefts, widths;
    for (std::sregex_iterator one(svg.begin(), svg.end(), frame), end; one != end; ++one) {
      lefts.insert((*one)[1]);
      widths.insert((*one)[2]);
    }
    EXPECT_EQ(lefts.size(), 1U) << size << ": " << testing::PrintToString(lefts);
    EXPECT_EQ(widths.size(), 1U) << size << ": " << testing::PrintToString(widths);
  }
}

TEST_F(ExportTest, AShorterSequenceLeavesNoFrameOfALongerOne) {
  const std::string size = kSmall;
  run("render s.json -o seq --frames 5" + size);
  // Not frames of ours: nothing in them, or something else.
  program.folder.write("seq/frame_0009.png", "somebody's");
  program.folder.write("seq/frame_0007.txt", "a note");
  run("render s.json -o curve.png --layout curve" + size);
  std::filesystem::copy(program.folder / "curve.png", program.folder / "seq/frame_0008.png");
  const Said said = program.run("render s.json -o seq --frames 2" + size);
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_THAT(program.folder.names("seq"),
              testing::UnorderedElementsAre("frame_0001.png", "frame_0002.png", "frame_0009.png",
                                            "frame_0007.txt", "frame_0008.png"));
  EXPECT_THAT(said.out, HasSubstr("wrote 2 frames in seq\nremoved 3 frames"));
  // With another number of digits they would be a second sequence.
  std::filesystem::copy(program.folder / "seq/frame_0002.png",
                        program.folder / "seq/frame_00002.png");
  const Said resumed = program.run("render s.json -o seq --frames 2 --resume" + size);
  ASSERT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_FALSE(has("seq/frame_00002.png"));
  EXPECT_THAT(resumed.out, HasSubstr("removed one frame"));
}

TEST_F(ExportTest, OneFrameIsCalledOne) {
  const std::string size = kSmall;
  const auto said = [&](const std::string& arguments) { return program.run(arguments + size).out; };
  EXPECT_THAT(said("render s.json -o seq --frames 1"), HasSubstr("wrote one frame in seq"));
  EXPECT_THAT(said("render s.json -o f.gif --frames 1"), HasSubstr("wrote one frame to f.gif"));
  run("render s.json -o two --frames 2" + size);
  std::filesystem::remove(program.folder / "two/frame_0001.png");
  EXPECT_THAT(said("render s.json -o two --frames 2 --resume"),
              AllOf(HasSubstr("wrote one frame in two"), HasSubstr("one was there already")));
}

TEST_F(ExportTest, StripsWithoutRoomAreRefused) {
  const std::string start =
      " --layout transient --set sliding.kind=start --set sliding.duration=0.02"
      " --set surface.elements=64 ";
  expectRefused("render s.json -o t.png --size 320x160" + start, 2,
                "--size: 320x160 leaves no room for the strips over time; 320x");
  // The size that it names is enough.
  const std::string said = program.run("render s.json -o t.png --size 320x160" + start).err;
  const std::size_t from = said.find("; ") + 2, to = said.find(" does");
  const std::string enough = said.substr(from, to - from);
  run("render s.json -o t.png --size " + enough + start);
  // A program that runs this one gets the height as a number.
  EXPECT_THAT(
      program.run("render s.json -o t.png --size 320x160" + start, "ASPERITY_PROGRESS=1").err,
      HasSubstr("height 160 " + enough.substr(enough.find('x') + 1) + "\n"));
}

TEST_F(ExportTest, ADashIsNoFolder) {
  program.folder.write("b.json",
                       R"({"schema": "asperity-batch/1", "entries": [{"scene": "s.json"}]})");
  for (const char* call : {"accuracy s.json", "figure 1", "batch b.json"})
    expectRefused(std::string(call) + " -o -", 2, "--output: '-' is not a folder");
}

/// A user who names a file gets no folder of that name; one that is there may have any name.
TEST_F(ExportTest, ANewFolderHasNoNameOfAFile) {
  expectRefused("figure 1 -o fig.png", 2,
                "fig.png: has the name of a .png file, but the command writes several files into a "
                "folder; name a folder, such as fig");
  expectRefused("accuracy s.json -o table.CSV", 2, "name a folder, such as table");
  EXPECT_FALSE(has("fig.png"));
  std::filesystem::create_directory(program.folder / "fig.png");
  run("figure 1 -o fig.png");
  EXPECT_TRUE(has("fig.png/claims.json"));
}

TEST_F(ExportTest, AKilledSequenceLeavesWholeFramesAndIsResumed) {
  const std::string arguments = std::string("render s.json -o seq --frames 40 ") + kSmall;
  for (const char* delay : {"0.3", "0.5", "0.7"}) {
    program.run(arguments + " --resume", std::string("timeout -s KILL ") + delay);
    if (!has("seq")) continue;
    for (const std::string& name : program.folder.names("seq"))
      EXPECT_THAT(read("seq/" + name), testing::EndsWith(std::string("IEND\xAE\x42\x60\x82")))
          << name;
  }
  run(arguments + " --resume");
  EXPECT_THAT(program.folder.names("seq"), testing::SizeIs(40));
}

TEST_F(ExportTest, StagesShareTheTimeOfASequence) {
  const Said said = program.run(std::string("render s.json -o seq --frames 4 --json") + kSmall);
  const auto share = nlohmann::json::parse(said.out)["pipeline"]["share"];
  double sum = 0;
  for (const char* stage : {"simulate", "draw", "encode", "write"})
    sum += share[stage].get<double>();
  EXPECT_NEAR(sum, 1, 1e-9);
}

TEST_F(ExportTest, LayoutsAndMotions) {
  run(std::string("render s.json -o both.png --layout both --size 640x600"));
  run(std::string("render s.json -o curve.svg --layout curve"));
  expectRefused("render s.json -o t.png --layout transient", 2, "sliding.kind: is steady");
  expectRefused("render s.json -o c.gif --layout curve", 2, "curve cannot be a film");
  const std::string start = " --set sliding.kind=start --set sliding.duration=0.02";
  run("render s.json -o t.gif --frames 3 --layout transient --size 640x600" + start);
  run("render s.json -o b.svg --layout both" + start);
  EXPECT_THAT(read("b.svg"), HasSubstr("this motion, now"));
}

/// The examples of reports: make has nothing left to do afterwards, and all pictures are there.
TEST_F(ExportTest, ReportsAreRebuiltByMake) {
  const std::string make = "make -C '" ASPERITY_RESOURCES_DIR "/reports' pictures OUT='" +
                           (program.folder / "build").string() +
                           "' ASPERITY='" ASPERITY_PROGRAM "'";
  other(make);
  EXPECT_THAT(program.folder.names("build"),
              testing::UnorderedElementsAre("contact.pdf", "contact.png", "curve.pdf", "curve.svg",
                                            "curve.csv", "film.gif"));
  EXPECT_THAT(other(make), Not(HasSubstr("render")));
}

TEST_F(ExportTest, RefusesOptionsItDoesNotKnow) {
  expectRefused("render s.json -o a.png --theme pink", 2,
                "--theme: pink is not one of light, dark");
  expectRefused("render s.json -o a.png --language fr", 2, "--language: fr is not one of en, de");
  expectRefused("render s.json -o a.png --backend metal", 2, "--backend");
  expectRefused("render s.json -o a.png --scale 0", 2, "--scale");
  expectRefused("render s.json -o a.png --scale 300 dpi", 2, "dpi");
  expectRefused("render s.json -o a.png --size 320x200x3", 2, "--size");
  expectRefused("render s.json -o a.png --layout wide", 2, "--layout");
  expectRefused("render s.json -o a.pdf --size 32768x32768", 2, "160 to 16384");
  expectRefused("curve s.json -o a.png --size 32768x200", 2, "160 to 16384");
}

}  // namespace
}  // namespace asperity
