// What files say of themselves, and the scene read back from it.
#include "core/scene/provenance.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "core/base/input_error.h"
#include "core/scene/scene_file.h"
#include "tests/core/error_from.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// With everything in its title that quoting could trip over.
Scene awkwardScene() {
  Scene scene;
  scene.title = "}{ \"quoted\" \\ <b> & \u00B5 &quot; {\"a\": 1}";
  scene.load.normalForce = 0.1;
  scene.surface.seed = 42;
  return scene;
}

std::string line() {
  return provenanceLine(provenance("render", awkwardScene()));
}

/// As XML has it.
std::string escaped(const std::string& text) {
  std::string xml;
  for (const char letter : text) xml += letter == '"' ? std::string("&quot;") : std::string{letter};
  return xml;
}

/// A PNG of this text alone.
std::string pngWith(const std::string& text) {
  using std::literals::operator""s;
  const std::string data = "asperity\0\0\0\0\0"s + text;
  std::string length;
  for (int shift = 24; shift >= 0; shift -= 8) length += static_cast<char>(data.size() >> shift);
  return "\x89PNG\r\n\x1A\n" + length + "iTXt" + data + "_crc" + "\0\0\0\0IEND_crc"s;
}

std::string svgWith(const std::string& text) {
  return "<?xml version=\"1.0\"?>\n<svg><title>one</title><metadata>" + escaped(text) +
         "</metadata><path d=\"M0 0\"/></svg>";
}

TEST(Provenance, LineIsOneOfAsciiAndHoldsSceneVerbVersionAndSeed) {
  const std::string text = line();
  for (const char letter : text) {
    EXPECT_TRUE(letter >= ' ' && letter <= '~');
    EXPECT_EQ(std::string("<>&").find(letter), std::string::npos);
  }
  const auto json = nlohmann::json::parse(text);
  EXPECT_EQ(json["verb"], "render");
  EXPECT_EQ(json["version"], ASPERITY_VERSION);
  EXPECT_EQ(json["seed"], 42);
  EXPECT_EQ(json["scene"]["load"]["normal_force"], 0.1);
}

/// As the names of files and the texts of options may be.
TEST(Provenance, BytesThatAreNoUtf8AreReplaced) {
  nlohmann::ordered_json options = {{"labels", "x=a\xFF"}};
  EXPECT_EQ(provenanceLine(options), R"({"labels":"x=a\ufffd"})");
}

TEST(Provenance, CommentIsOneLine) {
  const std::string comment = provenanceComment("curve", awkwardScene());
  EXPECT_THAT(comment, StartsWith("# asperity: {"));
  EXPECT_EQ(comment.find('\n'), comment.size() - 1);
}

TEST(Provenance, SceneComesBackFromAnyFile) {
  const TemporaryFolder folder;
  const std::string text = line();
  const std::pair<std::string, bool> forms[] = {
      {pngWith(text), true},
      {svgWith(text), true},
      {provenanceComment("curve", awkwardScene()) + "velocity,mu\n1,0.1\n", true},
      {provenance("curve", awkwardScene()).dump(2), true},
      {writeScene(awkwardScene()), false},
      {"\xEF\xBB\xBF " + writeScene(awkwardScene()), false}};
  for (const auto& [form, isEmbedded] : forms) {
    const FoundScene found = findScene(folder.write("file", form));
    EXPECT_EQ(writeScene(found.scene), writeScene(awkwardScene())) << form;
    EXPECT_EQ(found.scene.folder, folder.path());
    EXPECT_EQ(found.isEmbedded, isEmbedded) << form;
  }
}

/// What stands after the scene of an answer is not read: it may be long, and cut off.
TEST(Provenance, AnAnswerIsReadUpToItsScene) {
  const std::string answer = provenance("curve", awkwardScene()).dump();
  const std::string cut = answer.substr(0, answer.size() - 1) + ",\"points\":[[1,2],[3,";
  EXPECT_EQ(writeScene(findScene(cut, "a.json").scene), writeScene(awkwardScene()));
}

/// The text stands at the end of a file that is larger than what is read of it.
TEST(Provenance, ALargeFileIsReadAtBothEnds) {
  const TemporaryFolder folder;
  const std::string packet = "<dc:description><rdf:Alt><rdf:li xml:lang=\"x-default\">" +
                             escaped(line()) + "</rdf:li></rdf:Alt></dc:description>";
  const auto file = folder.write("film.webp", "RIFF____WEBP");
  std::filesystem::resize_file(file, std::uintmax_t{1} << 32);  // of nothing
  std::ofstream(file, std::ios::binary | std::ios::app) << packet;
  EXPECT_EQ(writeScene(findScene(file).scene), writeScene(awkwardScene()));
}

std::string refusal(const std::filesystem::path& file) {
  return errorFrom([&] { findScene(file); });
}

TEST(Provenance, RefusesFilesWithoutAScene) {
  const TemporaryFolder folder;
  for (const std::string& text :
       {std::string(), std::string("\x89PNG and nothing else"), "x" + line(), std::string("[1]"),
        pngWith("nothing"), svgWith("{\"schema\":\"asperity-x/1\"}")})
    EXPECT_THAT(refusal(folder.write("a.png", text)),
                AllOf(HasSubstr("a.png"), HasSubstr("no scene")));
  EXPECT_THAT(refusal(folder.write("prony.csv",
                                   "# asperity: {\"schema\":\"asperity-material/1\",\"origin\":"
                                   "{\"file\":\"dma.csv\"}}\nrelaxation_time,modulus\n1,2\n")),
              HasSubstr("holds no scene: it was made from a table of moduli"));
  EXPECT_THAT(refusal(folder.write("b.json", "{\"surface\": ")), HasSubstr("not valid JSON"));
  EXPECT_THAT(refusal(folder.write("c.json", R"({"schema": 3})")), HasSubstr("schema"));
  EXPECT_THAT(refusal(folder.write("d.json", R"({"scene": {"load": {"normal_force": -1}}})")),
              HasSubstr("load.normal_force"));
  EXPECT_THAT(refusal(folder / "gone.png"), HasSubstr("cannot be opened"));
  EXPECT_THAT(refusal(folder.path()), HasSubstr("is a folder"));
}

TEST(Provenance, TheInnermostOptionsOfTheThreadStandBeforeTheScene) {
  EXPECT_FALSE(provenance("curve", awkwardScene()).contains("options"));
  using Json = nlohmann::ordered_json;
  const ProvenanceOptions outer(Json{{"size", "4x3"}});
  {
    const ProvenanceOptions inner(Json{{"size", "2x2"}, {"file", "fit"}});
    const std::string text = provenance("fit", awkwardScene()).dump();
    EXPECT_THAT(text, HasSubstr(R"("options":{"size":"2x2","file":"fit"},"scene":)"));
    std::thread([] {
      EXPECT_FALSE(provenance("curve", awkwardScene()).contains("options"));
    }).join();
  }
  EXPECT_EQ(provenance("curve", awkwardScene())["options"]["size"], "4x3");
}

/// A result stands in a folder of its own; what it was made from is above it.
TEST(Provenance, InputsAreFoundInTheFoldersAbove) {
  const TemporaryFolder folder;
  const std::filesystem::path deep = folder.path() / "out" / "fit";
  std::filesystem::create_directories(deep);
  folder.write("data.csv", "velocity,mu\n1,0.1\n");
  Scene scene = awkwardScene();
  scene.folder = folder.path();
  scene.comparison.data = {{"data.csv", "A"}};
  const auto file = folder.write("out/fit/a.csv", provenanceComment("fit", scene) + "x\n");
  EXPECT_EQ(findScene(file).scene.folder, folder.path());
  const FoundScene found = findResult(file);
  ASSERT_EQ(inputsOf(found).size(), 1U);
  EXPECT_EQ(inputsOf(found)[0].key, "comparison.data");
  EXPECT_EQ(inputsOf(found)[0].sha256.size(), 64U);
  // Another file of this name that is nearer is not the one.
  folder.write("out/data.csv", "velocity,mu\n1,0.2\n");
  EXPECT_EQ(findScene(file).scene.folder, folder.path());
  std::filesystem::remove(folder / "data.csv");
  EXPECT_THAT(refusal(file), HasSubstr("data.csv: it is another file now"));
  std::filesystem::remove(folder / "out/data.csv");
  EXPECT_EQ(findScene(file).scene.folder, deep);  // the command says that it is missing
}

TEST(Provenance, ResultsOfManyScenesOrNoneAreForRemakingAlone) {
  const TemporaryFolder folder;
  const std::string one = writeScene(awkwardScene());
  const std::string scenes = R"({"verb":"batch","scenes":[{"name":"a","scene":)" + one +
                             R"(},{"name":"b","error":"why"}]})";
  const auto many = folder.write(
      "m.csv", "# asperity: " + nlohmann::ordered_json::parse(scenes).dump() + "\nx\n");
  EXPECT_THAT(refusal(many), HasSubstr("shows many scenes"));
  const FoundScene found = findResult(many);
  ASSERT_EQ(found.parts.size(), 2U);
  EXPECT_EQ(writeScene(found.parts[0].scene), one);
  EXPECT_EQ(found.parts[1].origin["error"], "why");
  const auto none = folder.write(
      "n.json", R"({"verb":"material","origin":{"file":"dma.csv","sha256":"0"},"name":"x"})");
  EXPECT_NE(refusal(none), "no error");
  const FoundScene material = findResult(none);
  EXPECT_EQ(material.verb, "material");
  EXPECT_EQ(inputsOf(material)[0].name, "dma.csv");
}

/// Brackets within brackets: a parser that calls itself for each would run out of its stack.
TEST(Provenance, NestedBracketsAreRefused) {
  const std::string deep(200000, '['), braces = [] {
    std::string text;
    for (int i = 0; i < 70000; ++i) text += "{\"a\":";
    return text;
  }();
  const std::string inside = "{\"schema\":\"asperity-render/1\",\"scene\":";
  for (const std::string& nested :
       {inside + deep, inside + braces, inside + "{\"load\":" + deep, "{\"x\":" + deep, braces})
    for (const std::string& bytes :
         {pngWith(nested), svgWith(nested), "# asperity: " + nested, nested})
      EXPECT_THROW(findScene(bytes, "a"), InputError);
}

/// Each of these takes a moment where every byte is looked at a few times, and minutes where it is
/// looked at as often as there are bytes before it.
TEST(Provenance, TimeGrowsWithTheBytesAlone) {
  constexpr std::size_t kBytes = 6000000;
  const auto repeated = [](const std::string& text) {
    std::string all;
    while (all.size() < kBytes) all += text;
    return all;
  };
  std::string keys = "{\"x\":{";
  for (int i = 0; keys.size() < kBytes; ++i) keys += "\"" + std::to_string(i) + "\":1,";
  for (const std::string& bytes :
       {"<svg><metadata>" + repeated("&quot;") + "</metadata>",
        "<svg><metadata>{" + repeated("&quot;") + "</metadata>",
        "<svg><metadata>" + repeated("{&quot;schema&quot;:&quot;asperity-") + "</metadata>",
        "<svg>" + repeated("<metadata>"), "%PDF" + repeated("<dc:description>"),
        "GIF89a" + repeated("<dc:description><rdf:li"), "\x1A\x45\xDF\xA3" + repeated("\x45\xA3"),
        "____ftyp" + repeated("\xA9"
                              "cmt"),
        "____ftyp" + repeated("\xA9"
                              "cmt____data"),
        "# asperity: {" + repeated("\"\\"), "{" + repeated("\"a\":{"), keys,
        "{\"a\":[" + repeated("{},") + "1]}", "\x89PNG\r\n\x1A\n" + std::string(kBytes, '\0')})
    EXPECT_THROW(findScene(bytes, "a"), InputError);
}

}  // namespace
}  // namespace asperity
