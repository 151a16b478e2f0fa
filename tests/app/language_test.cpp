// --language: German pictures from every verb that draws, and the same tables whatever is chosen.
#include <gmock/gmock.h>

#include <regex>
#include <set>

#include "tests/app/program_test.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class LanguageTest : public ProgramTest {
 protected:
  std::string read(const std::string& name) const {
    return TemporaryFolder::read(program.folder / name);
  }
  void run(const std::string& arguments) const {
    const Said said = program.run(arguments, "");
    ASSERT_EQ(said.status, 0) << arguments << "\n" << said.err;
  }
  /// The texts of an SVG that have a word in them, and not only a symbol or a unit.
  std::set<std::string> wordsIn(const std::string& name) const {
    static const std::regex text("<text[^>]*>([^<]*)</text>"), word("[A-Za-z]{4}");
    const std::string svg = read(name);
    std::set<std::string> words;
    for (std::sregex_iterator it(svg.begin(), svg.end(), text), end; it != end; ++it)
      if (std::regex_search((*it)[1].str(), word)) words.insert((*it)[1]);
    return words;
  }
  /// Texts that the German picture shares with the English one.
  std::set<std::string> untranslated(const std::string& english, const std::string& german) const {
    const std::set<std::string> all = wordsIn(german);
    EXPECT_GT(all.size(), 2U) << german;
    std::set<std::string> shared;
    for (const std::string& text : wordsIn(english))
      if (all.contains(text)) shared.insert(text);
    for (const char* same : {"A scene", "I linear"}) shared.erase(same);
    return shared;
  }
};

TEST_F(LanguageTest, PicturesAreGermanThroughout) {
  const std::string verbs[] = {"render s.json --layout both", "curve s.json",
                               "render s.json --layout transient --set sliding.kind=step "
                               "--set sliding.duration=0.01"};
  for (const std::string& verb : verbs) {
    SCOPED_TRACE(verb);
    run(verb + " -o en.svg");
    run(verb + " -o de.svg --language de");
    EXPECT_THAT(untranslated("en.svg", "de.svg"), IsEmpty());
  }
  EXPECT_THAT(read("de.svg"), AllOf(HasSubstr("Geschwindigkeit"), HasSubstr("in Kontakt")));
}

TEST_F(LanguageTest, FiguresAndComparisonsAreGermanAndTheirTablesAreNot) {
  for (const std::string language : {"en", "de"}) {
    run("figure 3 --realizations 2 -o " + language + " --language " + language);
    run("accuracy s.json -o " + language + " --language " + language);
  }
  for (const std::string name : {"figure_3.svg", "work_precision.svg", "standard_error.svg"}) {
    SCOPED_TRACE(name);
    EXPECT_THAT(untranslated("en/" + name, "de/" + name), IsEmpty());
  }
  for (const std::string name : {"figure_3.csv", "claims.json"})
    EXPECT_EQ(read("en/" + name), read("de/" + name)) << name;
}

TEST_F(LanguageTest, ABatchHasAGermanPage) {
  program.folder.write("b.json", R"({"schema": "asperity-batch/1", "title": "Reihe",
    "entries": [{"name": "one", "scene": {"surface": {"elements": 64}}, "show": "contact"}]})");
  run("batch b.json -o en");
  run("batch b.json -o de --language de");
  EXPECT_THAT(read("de/index.html"), AllOf(HasSubstr("lang=\"de\""), HasSubstr("Reibungszahl"),
                                           Not(HasSubstr("friction"))));
  EXPECT_THAT(read("en/index.html"), AllOf(HasSubstr("lang=\"en\""), HasSubstr("friction")));
  EXPECT_THAT(read("de/one.png"), HasSubstr(R"("picture":{"language":"de"})"));
}

TEST_F(LanguageTest, NumbersInPicturesHaveAComma) {
  run("render s.json -o de.svg --language de --set elastomer.relaxation_time=0.0125");
  EXPECT_THAT(read("de.svg"), HasSubstr("12,5 ms"));
  run("curve s.json -o en.csv");
  run("curve s.json -o de.csv --language de");
  EXPECT_EQ(read("en.csv"), read("de.csv"));
}

TEST_F(LanguageTest, TheLanguageBelongsToThePictureAndEnglishSaysNothing) {
  run("render s.json -o plain.png");
  run("render s.json -o en.png --language en");
  run("render s.json -o de.png --language de");
  run("surface s.json -o de_surface.png --language de");
  EXPECT_EQ(read("plain.png"), read("en.png"));
  EXPECT_THAT(read("en.png"), Not(HasSubstr("language")));
  for (const char* name : {"de.png", "de_surface.png"}) {
    EXPECT_THAT(read(name), HasSubstr(R"("language":"de")"));
    const Said opened = program.run(std::string("open --json ") + name, "");
    EXPECT_THAT(opened.out, HasSubstr("\"title\": \"A scene\""));
  }
}

TEST_F(LanguageTest, ReportsOfErrorsStayEnglish) {
  expectRefused("render s.json -o a.png --language de --set surface.hurst=2", 2,
                "surface.hurst: 2 is outside 0 to 1");
}

TEST_F(LanguageTest, AnUnknownLanguageIsRefusedByEveryVerbThatDraws) {
  for (const char* verb :
       {"", "render s.json -o a.png", "curve s.json -o a.png", "surface s.json -o a.png",
        "figure 1 -o out", "accuracy s.json -o out", "batch b.json -o out", "open s.json"})
    expectRefused(std::string(verb) + " --language fr", 2, "--language: fr is not one of en, de");
}

}  // namespace
}  // namespace asperity
