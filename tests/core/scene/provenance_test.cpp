// What files say of themselves, and the scene read back from it.
#include "core/scene/provenance.h"

#include <gmock/gmock.h>

#include "core/scene/input_error.h"
#include "core/scene/scene_file.h"
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

std::string quotesEscaped(const std::string& text) {
  std::string xml;
  for (const char letter : text) xml += letter == '"' ? std::string("&quot;") : std::string{letter};
  return xml;
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

TEST(Provenance, CommentIsOneLine) {
  const std::string comment = provenanceComment("curve", awkwardScene());
  EXPECT_THAT(comment, StartsWith("# asperity: {"));
  EXPECT_EQ(comment.find('\n'), comment.size() - 1);
}

/// Whatever stands around it, plain or as XML: the scene comes back whole.
TEST(Provenance, SceneComesBackFromAnyFile) {
  const TemporaryFolder folder;
  const std::string around = "\x89 binary {\"schema\": 1} \0 more";
  const std::string forms[] = {line(), quotesEscaped(line()),
                               provenance("curve", awkwardScene()).dump(2),
                               writeScene(awkwardScene())};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::string text = i < 2 ? around + forms[i] + around : forms[i];
    const Scene scene = readProvenance(folder.write("file", text));
    EXPECT_EQ(writeScene(scene), writeScene(awkwardScene())) << forms[i];
    EXPECT_EQ(scene.folder, folder.path());
  }
}

std::string refusal(const std::filesystem::path& file) {
  try {
    readProvenance(file);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(Provenance, RefusesFilesWithoutAScene) {
  const TemporaryFolder folder;
  for (const std::string& text : {std::string(), std::string("\x89PNG and nothing else"),
                                  "x" + line().substr(0, line().size() - 9), std::string("[1]")})
    EXPECT_THAT(refusal(folder.write("a.png", text)),
                AllOf(HasSubstr("a.png"), HasSubstr("no scene")));
  EXPECT_THAT(refusal(folder.write("b.json", "{\"surface\": ")), HasSubstr("not valid JSON"));
  EXPECT_THAT(refusal(folder.write("c.json", R"({"schema": 3})")), HasSubstr("schema"));
  EXPECT_THAT(refusal(folder.write("d.json", R"({"scene": {"load": {"normal_force": -1}}})")),
              HasSubstr("load.normal_force"));
  EXPECT_THAT(refusal(folder / "gone.png"), HasSubstr("cannot be opened"));
  EXPECT_THAT(refusal(folder.path()), HasSubstr("is a folder"));
}

}  // namespace
}  // namespace asperity
