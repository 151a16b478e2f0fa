// How a text of core finds its translation: with numbers, as a list, sentence by sentence.
#include "ui/language/translated.h"

#include <gtest/gtest.h>

#include "ui/language/language.h"
#include "ui/language/words.h"

namespace asperity {
namespace {

class Translated : public testing::Test {
 protected:
  Translated() { useLanguage("de"); }
  ~Translated() override { useLanguage("en"); }
};

TEST_F(Translated, EnglishIsLeftAlone) {
  useLanguage("en");
  EXPECT_EQ(translated("mean of 200 lines \u00B1 standard error"),
            "mean of 200 lines \u00B1 standard error");
  EXPECT_EQ(inLanguage(std::string("0.5")), "0.5");
}

TEST_F(Translated, NumbersKeepTheirPlacesAndGetAComma) {
  EXPECT_EQ(translated("mean of 200 lines \u00B1 standard error"),
            "Mittel über 200 Linien \u00B1 Standardfehler");
  EXPECT_EQ(translated("the indentation that carries 0.0034 N is sought"),
            "die Eindringung, die 0,0034 N trägt, wird gesucht");
}

TEST_F(Translated, NumbersArePrintedInOneStyle) {
  EXPECT_EQ(translated("-2.5e-05 is outside 1e-6 to 1e+15 Pa"),
            "\u22122,5\u00D710\u207B\u2075 liegt außerhalb von 10\u207B\u2076 bis "
            "10\u00B9\u2075 Pa");
  useLanguage("en");
  EXPECT_EQ(translated("from 100 s to 1e-10 s"), "from 100 s to 10\u207B\u00B9\u2070 s");
  EXPECT_EQ(translated("at 6.3e+02 m/s"), "at 630 m/s");
  for (const char* text : {"profile_1e5.csv", "the 1e", "2e5x", "a1e5", "1e999"})
    EXPECT_EQ(translated(text), text);
}

TEST_F(Translated, LargeAndSmallNumbersArePowersOfTen) {
  EXPECT_EQ(translated("from 1e5 m/s, 2.5e5 Pa and 3e-4 N"),
            "from 10\u2075 m/s, 2,5\u00D710\u2075 Pa and 3\u00D710\u207B\u2074 N");
  EXPECT_EQ(translated("from 2e4 m/s and 2e-3 N"), "from 20000 m/s and 0,002 N");
  EXPECT_EQ(sceneText("beyond 1e5 m/s"), QStringLiteral("beyond 10\u2075 m/s"));
}

TEST_F(Translated, AComplaintKeepsItsFileAndItsKeys) {
  EXPECT_EQ(translated("my scene.json: surface.file: is missing; a profile needs a file"),
            "my scene.json: surface.file: fehlt; ein Profil braucht eine Datei");
  EXPECT_EQ(translated("unknown key; the nearest known one is surface.hurst"),
            "unbekannter Schlüssel; der nächste bekannte ist surface.hurst");
  EXPECT_EQ(translated("2 is above sweep.velocity_to, 1.5"), "2 liegt über sweep.velocity_to, 1,5");
}

/// Words that the program knows from elsewhere are a person's own in a scene.
TEST_F(Translated, OnlyAShippedSceneSpeaksGerman) {
  EXPECT_EQ(sceneText("Rheology"), "Rheologie");
  for (const char* own : {"linear", "seed 3", "velocity sweep"}) {
    EXPECT_TRUE(translationOf(own)) << own;
    EXPECT_FALSE(isTranslatedScene(own));
    EXPECT_EQ(sceneText(own), own);
  }
  useLanguage("en");
  EXPECT_EQ(sceneText("Rheology"), "Rheology");
  EXPECT_FALSE(isTranslatedScene("Rheology"));
}

TEST_F(Translated, AQuantityWithAPowerOfTenIsOne) {
  EXPECT_EQ(translated("region II: 6.3\u00D710\u207B\u2075 to 10\u207B\u00B9 m/s"),
            "Bereich II: 6,3\u00D710\u207B\u2075 bis 10\u207B\u00B9 m/s");
}

TEST_F(Translated, ListsOfValuesAreSetApartBySemicolons) {
  EXPECT_EQ(translated("H = 0.7, h = 500 nm, \u03BB_r = 1.5e-3 m"),
            "H = 0,7; h = 500 nm; \u03BB_r = 0,0015 m");
}

TEST_F(Translated, WhatNobodyTranslatedStaysAsItIs) {
  EXPECT_EQ(translated("My tyre, 12.5 psi"), "My tyre, 12.5 psi");
  EXPECT_FALSE(translationOf("My tyre, 12.5 psi"));
}

TEST_F(Translated, WhatFollowsANameIsTranslatedAlone) {
  EXPECT_EQ(translated("My tyre; 6 lines of 200 elements, 8 velocities in each region"),
            "My tyre; 6 Linien mit 200 Elementen; 8 Geschwindigkeiten je Bereich");
}

TEST_F(Translated, ASheetHasAllItsTexts) {
  DiagramSheet sheet;
  sheet.subtitle = "G = 10 MPa";
  Diagram diagram;
  diagram.x.title = "sliding velocity v";
  diagram.series.push_back({"this line"});
  sheet.diagrams = {diagram};
  const DiagramSheet german = translated(sheet);
  EXPECT_EQ(german.diagrams[0].x.title, "Gleitgeschwindigkeit v");
  EXPECT_EQ(german.diagrams[0].series[0].name, "diese Linie");
}

TEST(Language, IsFoundFromTheNameOfALocale) {
  EXPECT_EQ(languageFor("de"), "de");
  EXPECT_EQ(languageFor("de_AT.UTF-8"), "de");
  EXPECT_EQ(languageFor("en-GB"), "en");
  EXPECT_EQ(languageFor("deutsch"), "");
  EXPECT_EQ(languageFor("fr_FR"), "");
  EXPECT_EQ(languageCodes(), "en, de");
}

TEST(Language, AnUnknownOneIsEnglish) {
  useLanguage("fr");
  EXPECT_EQ(presentLanguage(), "en");
}

TEST(Words, ValuesGoToTheirPlaces) {
  EXPECT_EQ(filled("%2 of %1 %", {"a", "b"}), "b of a %");
  EXPECT_EQ(filled("100 %", {}), "100 %");
}

}  // namespace
}  // namespace asperity
