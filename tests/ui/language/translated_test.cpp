// How a message of core is shown: its template translated, its values in their places.
#include "ui/language/translated.h"

#include <gtest/gtest.h>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

class Translated : public testing::Test {
 protected:
  Translated() { useLanguage("de"); }
  ~Translated() override { useLanguage("en"); }
};

TEST_F(Translated, EnglishIsLeftAlone) {
  useLanguage("en");
  EXPECT_EQ(translated(message("mean of {} lines \u00B1 standard error", 200)),
            "mean of 200 lines \u00B1 standard error");
  EXPECT_EQ(inLanguage(std::string("0.5")), "0.5");
}

TEST_F(Translated, ValuesStandInTheTranslatedTemplateAndNumbersGetAComma) {
  EXPECT_EQ(translated(message("mean of {} lines \u00B1 standard error", 200)),
            "Mittel über 200 Linien \u00B1 Standardfehler");
  EXPECT_EQ(translated(message("the indentation that carries {} is sought", printed(0.0034, "N"))),
            "die Eindringung, die 3,4 mN trägt, wird gesucht");
}

TEST_F(Translated, NumbersArePrintedInOneStyle) {
  EXPECT_EQ(translated(message("{} is outside {}", -2.5e-5, rangeText(1e-6, 1e15, "Pa"))),
            "\u22122,5\u00D710\u207B\u2075 liegt außerhalb von 10\u207B\u2076 bis "
            "10\u00B9\u2075 Pa");
  useLanguage("en");
  EXPECT_EQ(translated(message("{} s", 1e-10)), "10\u207B\u00B9\u2070 s");
  EXPECT_EQ(translated(message("{:.2g} m/s", 630.0)), "630 m/s");
  for (const char* text : {"profile_1e5.csv", "the 1e", "2e5x", "a1e5", "1e999", "1e-10"})
    EXPECT_EQ(translated(message("{}", text)), text);
}

/// What a chart or a reading says has groups of thousands, which nobody can type into an entry.
TEST_F(Translated, ReadingsHaveGroupsOfThousands) {
  useLanguage("en");
  const Message speed = message("v = {}", printed(1234, "m/s", 4));
  EXPECT_EQ(readingText(speed), "v = 1,234 m/s");
  EXPECT_EQ(translated(speed), "v = 1234 m/s");
  DiagramSheet sheet;
  sheet.subtitle = speed;
  EXPECT_EQ(translated(sheet).subtitle.text, "v = 1,234 m/s");
  useLanguage("de");
  EXPECT_EQ(readingText(speed), "v = 1.234 m/s");
}

TEST_F(Translated, LargeAndSmallNumbersArePowersOfTen) {
  EXPECT_EQ(translated(message("{:.3g}", 1e5)), "10\u2075");
  EXPECT_EQ(translated(message("{:.3g}", 2.5e5)), "2,5\u00D710\u2075");
  EXPECT_EQ(translated(message("{:.3g}", 3e-4)), "0,0003");
  EXPECT_EQ(translated(message("{:.1e}", 3e-4)), "3\u00D710\u207B\u2074");
  EXPECT_EQ(translated(message("{:.1e}", 2e-3)), "0,002");
}

TEST_F(Translated, AnErrorKeepsItsFileAndItsKeys) {
  const InputError error("my scene.json", "surface.file", "is missing; a profile needs a file");
  EXPECT_EQ(translatedError(error).toStdString(),
            "my scene.json: surface.file: fehlt; ein Profil braucht eine Datei");
  EXPECT_STREQ(error.what(), "my scene.json: surface.file: is missing; a profile needs a file");
  EXPECT_EQ(translated(message("unknown key; the nearest known one is {}", "surface.hurst")),
            "unbekannter Schlüssel; der nächste bekannte ist surface.hurst");
  EXPECT_EQ(translatedError(std::runtime_error("0.5 of somebody")).toStdString(),
            "0.5 of somebody");
}

/// Words that the program knows from elsewhere are a person's own in a scene.
TEST_F(Translated, OnlyAShippedSceneSpeaksGerman) {
  EXPECT_EQ(sceneText("Motions"), "Bewegungen");
  for (const char* own : {"linear", "velocity sweep"}) {
    EXPECT_TRUE(findTranslation(own)) << own;
    EXPECT_FALSE(isTranslatedScene(own));
    EXPECT_EQ(sceneText(own), own);
  }
  useLanguage("en");
  EXPECT_EQ(sceneText("Motions"), "Motions");
  EXPECT_FALSE(isTranslatedScene("Motions"));
}

TEST_F(Translated, APrintedQuantityGetsAComma) {
  EXPECT_EQ(
      translated(message("region {}: {} to {} m/s", "II", PrintedNumber{"6.3\u00D710\u207B\u2075"},
                         PrintedNumber{"10\u207B\u00B9"})),
      "Bereich II: 6,3\u00D710\u207B\u2075 bis 10\u207B\u00B9 m/s");
}

TEST_F(Translated, ListsAreSetApartBySemicolons) {
  const Message list = listed({message("H = {:g}", 0.7),
                               {},
                               message("h = {}", PrintedNumber{"500 nm"}),
                               message("\u03BB_r = {}", PrintedNumber{"1.5 mm"})});
  EXPECT_EQ(list.english(), "H = 0.7, h = 500 nm, \u03BB_r = 1.5 mm");
  EXPECT_EQ(translated(list), "H = 0,7; h = 500 nm; \u03BB_r = 1,5 mm");
}

TEST_F(Translated, WhatNobodyTranslatedStaysAsItIs) {
  EXPECT_EQ(translated("My tyre, 12.5 psi"), "My tyre, 12.5 psi");
  EXPECT_FALSE(findTranslation("My tyre, 12.5 psi"));
  EXPECT_EQ(translated(Message::name("seed")), "seed");
}

TEST_F(Translated, AMessageInAMessageIsTranslatedToo) {
  const Message lines = message("{} lines of {} elements, 8 velocities in each region", 6, 200);
  EXPECT_EQ(translated(message("{}; {}", Message("My tyre"), lines)),
            "My tyre; 6 Linien mit 200 Elementen; 8 Geschwindigkeiten je Bereich");
}

TEST_F(Translated, ASheetHasAllItsTexts) {
  DiagramSheet sheet;
  sheet.subtitle = message("G = {}", PrintedNumber{"1.5 MPa"});
  Diagram diagram;
  diagram.x.title = "sliding velocity v";
  diagram.series.push_back({"this line"});
  sheet.diagrams = {diagram};
  const DiagramSheet german = translated(sheet);
  EXPECT_EQ(german.subtitle.text, "G = 1,5 MPa");
  EXPECT_EQ(german.diagrams[0].x.title.text, "Gleitgeschwindigkeit v");
  EXPECT_EQ(german.diagrams[0].series[0].name.text, "diese Linie");
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

TEST_F(Translated, FormulasNameTheirEquation) {
  EXPECT_EQ(formulaHtml("f = 4 Δx p, Eq. (2)"), QStringLiteral("f = 4 Δx p, Gl. (2)"));
  EXPECT_EQ(formulaText("f = 4 Δx p, Eq. (2)"), QStringLiteral("f = 4 Δx p, Gl. (2)"));
  EXPECT_EQ(formulaHtml("u = z − d in contact"), QStringLiteral("u = z − d in Kontakt"));
  useLanguage("en");
  EXPECT_EQ(formulaHtml("f = 4 Δx p, Eq. (2)"), QStringLiteral("f = 4 Δx p, Eq. (2)"));
}

/// "(h/(β" at the end of a line leaves the reader with half a quotient.
TEST_F(Translated, FormulasBreakOnlyBesideBracketsOrBeforeAPlus) {
  const QString law = formulaText(findExplanation(std::string_view("Eq. (11)"))->formula);
  EXPECT_TRUE(law.contains(QStringLiteral("(h/(β\u00A0τ\u00A0∇z²\u00A0v)\u00A0(Fₙ/")))
      << law.toStdString();
  EXPECT_TRUE(law.contains(QStringLiteral(" +\u00A0(h/("))) << law.toStdString();
  EXPECT_TRUE(law.startsWith(QStringLiteral("μ = [1/")));
}

/// A lowered letter that has no sign of its own stays behind its line: "L(c)" would be a function.
TEST_F(Translated, FormulasInPlainTextHaveLoweredLettersWhereThereAreSome) {
  EXPECT_EQ(formulaText("μ = |F_x|/F_N"), QStringLiteral("μ = |Fₓ|/Fₙ"));
  EXPECT_EQ(formulaText("μ_total = s L_c"), QStringLiteral("μₜₒₜₐₗ = s L_c"));
}

/// No letter of Unicode is a lowered capital N.
TEST_F(Translated, TitlesInPlainTextHaveWordsForTheNormalForce) {
  EXPECT_EQ(plainTitle(QStringLiteral("normal force F\u2099 (N)")), "normal force (N)");
  EXPECT_EQ(plainTitle(QStringLiteral("shear modulus G (Pa)")), "shear modulus G (Pa)");
}

TEST_F(Translated, LinesDoNotEndWithinAQuantity) {
  EXPECT_EQ(keptTogether("at 3 mm/s and 20 °C"), "at 3\u00A0mm/s and 20\u00A0°C");
  EXPECT_EQ(keptTogether("5.7 % of Eq. (11)"), "5.7\u00A0% of Eq.\u00A0(11)");
  for (const char* name : {"run-3-b 2 main.csv", "/m/s/3 mm/a.csv"})
    EXPECT_EQ(keptTogether(name), name);
}

TEST(Shortened, EndsWithAWholeWord) {
  EXPECT_EQ(shortened("Slow the oscillation down", 25), "Slow the oscillation down");
  EXPECT_EQ(shortened("Slow the oscillation down", 24), "Slow the oscillation…");
  EXPECT_EQ(shortened("Slow the oscillation down", 21), "Slow the oscillation…");
  EXPECT_EQ(shortened("Slow the oscillation down", 20), "Slow the…");
  EXPECT_EQ(shortened("It falls. Then it grows", 12), "It falls…");
  EXPECT_EQ(shortened("a_name_without_spaces.json", 7), "a_name…");
  EXPECT_EQ(shortened(" first", 4), " fi…") << "no word is whole";
}

TEST(Words, ValuesGoToTheirPlaces) {
  EXPECT_EQ(filled("%2 of %1 %", {"a", "b"}), "b of a %");
  EXPECT_EQ(filled("100 %", {}), "100 %");
}

}  // namespace
}  // namespace asperity
