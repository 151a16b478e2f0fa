// --language: German pictures and summaries from every verb, and the same tables whatever is
// chosen.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

#include "tests/app/program.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class LanguageTest : public ProgramTest {
 protected:
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
    run("figure 1 -o " + language + " --language " + language);
    run("figure 3 --realizations 2 -o " + language + " --language " + language);
    run("accuracy s.json -o " + language + " --language " + language);
  }
  for (const std::string name :
       {"figure_1.svg", "figure_3.svg", "work_precision.svg", "standard_error.svg"}) {
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

TEST_F(LanguageTest, TitlesOfABatchAreGermanAndItsTableKeepsItsKeys) {
  program.folder.write("b.json", R"({"schema": "asperity-batch/1", "entries": [
      {"name": "a", "scene": "figure_2.json", "show": "contact",
       "set": {"surface.elements": 64}, "sweep": {"surface.hurst": [0.25, 0.5]}},
      {"name": "own", "scene": {"title": "Ours", "surface": {"elements": 64}}, "show": "contact",
       "sweep": {"load.normal_force": [0.01]}},
      {"name": "bad", "scene": {"surface": {"hurst": 7}}}]})");
  const Said said = program.run("batch b.json -o de --language de");
  EXPECT_EQ(said.status, 1);
  EXPECT_THAT(said.out, HasSubstr("4 Szenen, davon 1 fehlgeschlagen"));
  EXPECT_THAT(said.err, HasSubstr("bad: scene: surface.hurst: 7 is outside"));
  EXPECT_THAT(read("de/index.html"),
              AllOf(HasSubstr("Abbildung 2: typische Abh\u00E4ngigkeit"), HasSubstr("; H = 0,25<"),
                    HasSubstr("Ours; F\u2099 = 10 mN<"), HasSubstr("Hurst-Exponent</td><td>0,25<"),
                    HasSubstr("surface.hurst: 7 liegt au\u00DFerhalb von 0 bis 1")));
  EXPECT_THAT(read("de/a_01.json"), HasSubstr("friction on velocity; H = 0.25\""));
  EXPECT_THAT(read("de/results.csv"), HasSubstr("name,surface.hurst,load.normal_force,mu"));
}

/// Lines that a person reads, each of them said in the language; names of files stay.
TEST_F(LanguageTest, WhatVerbsPrintIsGermanThroughout) {
  static const std::regex word("[A-Za-z]{4}"),
      english("\\b(the|of|is|and|with|wrote|lines?|points|error|time|force|yes|no|at|on)\\b");
  program.folder.write("b.json", R"({"schema": "asperity-batch/1",
    "entries": [{"name": "one", "scene": {"surface": {"elements": 64}}, "show": "contact"}]})");
  const std::string step = " --set sliding.kind=step --set sliding.duration=0.01";
  const std::vector<std::string> calls{
      "check s.json",
      "check s.json --set title=''",
      "explain s.json --analyze",
      "explain s.json --analyze --set accuracy.scheme=nodal",
      "explain s.json --analyze" + step,
      "surface s.json -o a.csv",
      "curve s.json -o a.csv",
      "curve s.json -o a.csv --set accuracy.scheme=nodal --set ensemble.realizations=1",
      "curve s.json -o a.csv --set accuracy.target_relative_error=0.2",
      "render s.json -o a.png",
      "render s.json -o out --frames 2",
      "batch b.json -o out",
      "figure 3 --realizations 2 -o out",
      "accuracy s.json -o out"};
  for (const std::string& call : calls) {
    SCOPED_TRACE(call);
    std::set<std::string> lines;
    const auto split = [](const std::string& text, const auto& take) {
      std::istringstream stream(text);
      for (std::string line; std::getline(stream, line);) take(line);
    };
    split(program.run(call).out, [&](const std::string& line) { lines.insert(line); });
    const Said said = program.run(call + " --language de");
    EXPECT_EQ(said.status, 0) << said.err;
    EXPECT_EQ(said.err, "");
    EXPECT_NE(said.out, "");
    split(said.out, [&](const std::string& line) {
      if (line == "A scene") return;
      EXPECT_FALSE(std::regex_search(line, word) && lines.contains(line)) << line;
      EXPECT_FALSE(std::regex_search(line, english)) << line;
    });
  }
}

TEST_F(LanguageTest, AMachinesAnswerKeepsItsKeys) {
  for (const char* verb : {"check", "explain", "surface"}) {
    const Said said = program.run(std::string(verb) + " s.json --json --language de");
    const auto german = nlohmann::ordered_json::parse(said.out);
    const auto english =
        nlohmann::ordered_json::parse(program.run(std::string(verb) + " s.json --json").out);
    EXPECT_EQ(german["scene"], english["scene"]);
    EXPECT_THAT(said.err, testing::ContainsRegex("RMS|aus"));
    for (const auto& [key, value] : english.items()) EXPECT_TRUE(german.contains(key)) << key;
  }
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

TEST_F(LanguageTest, AnUnknownLanguageIsRefusedByEveryVerb) {
  for (const char* verb : {"", "render s.json -o a.png", "curve s.json -o a.png",
                           "surface s.json -o a.png", "figure 1 -o out", "accuracy s.json -o out",
                           "batch b.json -o out", "open s.json", "check s.json", "explain s.json"})
    expectRefused(std::string(verb) + " --language fr", 2, "--language: fr is not one of en, de");
}

}  // namespace
}  // namespace asperity
