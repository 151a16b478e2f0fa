// Ready Prony series as people and finite-element programs write them.
#include "core/material/prony_file.h"

#include <gmock/gmock.h>

#include "core/base/input_error.h"
#include "tests/core/error_from.h"

namespace asperity {
namespace {

using testing::HasSubstr;

std::optional<PronyFile> read(const std::string& text, const PronyChoices& choices = {}) {
  std::optional<TextTable> table;
  try {
    TextTableOptions options;
    options.keepsTexts = true;
    table = readTextTable(text, "prony.txt", options);
  } catch (const InputError&) {
    table.reset();  // no table, as keywords are none
  }
  return readPronyFile(text, table ? &*table : nullptr, "prony.txt", choices);
}

std::string errorOf(const std::string& text, const PronyChoices& choices = {}) {
  return errorFrom([&] { read(text, choices); });
}

/// G_0 = 4 MPa: G_i = 2 and 1 MPa at 0.1 and 10 s, 1 MPa is left.
void expectSeries(const std::optional<PronyFile>& file) {
  ASSERT_TRUE(file.has_value());
  EXPECT_NEAR(file->equilibriumModulus, 1e6, 1e-3);
  ASSERT_EQ(file->arms.size(), 2U);
  EXPECT_NEAR(file->arms[0].modulus, 1e6, 1e-3);
  EXPECT_EQ(file->arms[0].relaxationTime, 10);
  EXPECT_NEAR(file->arms[1].modulus, 2e6, 1e-3);
  EXPECT_EQ(file->arms[1].relaxationTime, 0.1);
}

TEST(PronyFile, KeywordsOfAbaqus) {
  expectSeries(
      read("*MATERIAL, NAME=RUBBER\n*Elastic, moduli=INSTANTANEOUS\n12e6, 0.5\n"
           "*VISCOELASTIC, TIME=PRONY\n** g_i, k_i, tau_i\n0.5, 0., 0.1\n0.25, 0., 10.\n"));
  // Long-term moduli are the default: G_inf = E / (2 (1 + nu)).
  expectSeries(
      read("*ELASTIC\n3e6, 0.5\n*VISCOELASTIC, TIME=PRONY\n0.5, 0., 0.1\n0.25, 0., 10.\n"));
  // Neo Hooke: G = 2 C10.
  const auto file = read(
      "*HYPERELASTIC, NEO HOOKE, MODULI=LONG TERM\n0.5e6, 0.\n*VISCOELASTIC, "
      "TIME=PRONY\n0.5,0,0.1\n"
      "0.25,0,10\n*TRS, DEFINITION=WLF\n25., 8.86, 101.6\n");
  expectSeries(file);
  ASSERT_TRUE(file->shift.has_value());
  EXPECT_EQ(*file->shift, (TemperatureShift{8.86, 101.6, 298.15}));
}

TEST(PronyFile, CommandsOfAnsys) {
  const auto file = read(
      "/PREP7\nMP,EX,1,12e6\nMP,NUXY,1,0.5\nTB,PRONY,1,1,2,SHEAR\nTBDATA,1,0.5,0.1,0.25,10\n"
      "TB,SHIFT,1,1,3,WLF\nTBDATA,1,298.15,8.86,101.6\n");
  expectSeries(file);
  EXPECT_EQ(file->shift->c2, 101.6);
}

/// The unit of a reference temperature stands nowhere in these files.
TEST(PronyFile, TheUnitOfAReferenceTemperatureIsSaidOrTold) {
  const std::string head = "*ELASTIC\n3e6, 0.5\n*VISCOELASTIC, TIME=PRONY\n0.5, 0., 0.1\n";
  const auto referenceOf = [&](const std::string& trs, const char* unit, std::size_t notes) {
    PronyChoices choices;
    choices.temperatureUnit = unit;
    const auto file = read(head + trs, choices);
    EXPECT_EQ(file->notes.size(), notes) << trs;
    return file->shift->referenceTemperature;
  };
  EXPECT_EQ(referenceOf("*TRS\n170.,17.44,51.6\n", "", 1), 443.15);
  EXPECT_EQ(referenceOf("*TRS\n170.,17.44,51.6\n", "K", 0), 170);
  EXPECT_EQ(referenceOf("*TRS\n210.,17.44,51.6\n", "", 1), 210);
  EXPECT_EQ(referenceOf("*TRS\n293.15,17.44,51.6\n", "", 0), 293.15);
  EXPECT_DOUBLE_EQ(referenceOf("*TRS\n-20,17.44,51.6\n", "", 0), 253.15);
  EXPECT_EQ(referenceOf("*TRS\n170.,17.44,51.6\n*PHYSICAL CONSTANTS, ABSOLUTE ZERO=0.\n", "", 0),
            170);
}

/// ln a_T = E/R (1/T - 1/T_r).
TEST(PronyFile, ArrheniusOfAbaqus) {
  const std::string text =
      "*ELASTIC\n3e6, 0.5\n*VISCOELASTIC, TIME=PRONY\n0.5, 0., 0.1\n*TRS, "
      "DEFINITION=ARRHENIUS\n293.15, 1.2e5\n";
  const auto file = read(text);
  ASSERT_TRUE(file->shift.has_value());
  EXPECT_EQ(file->shift->kind, ShiftKind::Arrhenius);
  EXPECT_EQ(file->shift->activationEnergy, 1.2e5);
  EXPECT_EQ(file->shift->referenceTemperature, 293.15);
  // A model in mm, t and s has energies in mJ.
  const auto small = read(
      "*ELASTIC\n3, 0.5\n*VISCOELASTIC, TIME=PRONY\n0.5, 0., 0.1\n*TRS, "
      "DEFINITION=ARRHENIUS\n20., 1.2e8\n*PHYSICAL CONSTANTS, ABSOLUTE ZERO=-273.15, UNIVERSAL GAS "
      "CONSTANT=8314.46261815324\n",
      [] {
        PronyChoices choices;
        choices.modulusUnit = "MPa";
        return choices;
      }());
  EXPECT_NEAR(small->shift->activationEnergy, 1.2e5, 1e-6);
  EXPECT_NEAR(small->shift->referenceTemperature, 293.15, 1e-12);
}

TEST(PronyFile, AShiftThatIsNotReadIsTold) {
  const auto user =
      read("*ELASTIC\n3e6, 0.5\n*VISCOELASTIC, TIME=PRONY\n0.5, 0., 0.1\n*TRS, DEFINITION=USER\n");
  EXPECT_FALSE(user->shift.has_value());
  ASSERT_EQ(user->notes.size(), 1U);
  EXPECT_THAT(user->notes[0].english(), HasSubstr("*TRS, DEFINITION=USER is left out"));
  const auto fictive = read(
      "MP,EX,1,12e6\nTB,PRONY,1,1,1,SHEAR\nTBDATA,1,0.5,0.1\nTB,SHIFT,1,1,2,TN\n"
      "TBDATA,1,293.15,50000\n");
  ASSERT_EQ(fictive->notes.size(), 1U);
  EXPECT_THAT(fictive->notes[0].english(), HasSubstr("TB,SHIFT,TN is left out"));
}

/// Scenes take C1 from 0 to 1000.
TEST(PronyFile, AShiftThatNoSceneTakesIsRefused) {
  EXPECT_THAT(errorOf("MP,EX,1,12e6\nTB,PRONY,1,1,1,SHEAR\nTBDATA,1,0.5,0.1\n"
                      "TB,SHIFT,1,1,3,WLF\nTBDATA,1,20,-8.86,101.6\n"),
              HasSubstr("shift: C1 is -8.86, outside 0 to 1000"));
}

/// A part of a series, and the keywords of another program, are no table of dynamic moduli.
TEST(PronyFile, WhatLooksLikeASeriesIsCalledOne) {
  EXPECT_THAT(errorOf("f_i (Hz),G_i (MPa)\n1000,0.5\n0.1,1\n"),
              HasSubstr("there is no column of relaxation times"));
  EXPECT_THAT(errorOf("tau (s),K_i (MPa)\n1000,0.5\n0.1,1\n"),
              HasSubstr("there is no column of moduli"));
  EXPECT_THAT(errorOf("*MAT_GENERAL_VISCOELASTIC\n$ gi betai\n1,1e-9,2000\n"),
              HasSubstr("keyword of LS-DYNA"));
  PronyChoices choices;
  choices.instantaneousModulus = 4e6;
  expectSeries(read("tau_i (s);G_i/G_0;K_i\n0.1;0.5;0.1\n10;0.25;0\n", choices));
}

TEST(PronyFile, TablesOfTimesAndModuli) {
  expectSeries(read("tau (s),G (MPa)\ninf,1\n0.1,2\n10,1\n"));
  expectSeries(read("G_inf: 1 MPa\ntau_i [s];G_i [MPa]\n0.1;2\n10;1\n"));
  expectSeries(read("E_inf = 3 MPa\ntau (s)\tE (MPa)\n0.1\t6\n10\t3\n"));
  PronyChoices choices;
  choices.instantaneousModulus = 4e6;
  expectSeries(read("tau,g_i\n0.1,0.5\n10,0.25\n", choices));
  choices = {};
  choices.equilibriumModulus = 1e6;
  expectSeries(read("tau,g_i\n0.1,0.5\n10,0.25\n", choices));
}

/// Found by random input: of a liquid whose only arm is empty nothing is left.
TEST(PronyFile, ASeriesNeedsAnArm) {
  PronyChoices liquid;
  liquid.instantaneousModulus = 1e7;
  liquid.isLiquid = true;
  EXPECT_THAT(errorOf("relaxation_time;g_i\n10;0\n20;0\n", liquid),
              HasSubstr("has no arm with a modulus above 0"));
}

/// Random input found two terms of one time, which came back as two arms.
TEST(PronyFile, TermsOfEqualTimesAreOneArm) {
  expectSeries(
      read("*ELASTIC, MODULI=INSTANTANEOUS\n12e6, 0.5\n*VISCOELASTIC, TIME=PRONY\n"
           "0.3, 0., 0.1\n0.25, 0., 10.\n0.2, 0., 0.1\n"));
}

TEST(PronyFile, ATableOfFrequenciesIsNone) {
  EXPECT_FALSE(read("f (Hz),T (C),G' (Pa),G'' (Pa)\n1,20,2e6,2e5\n").has_value());
}

TEST(PronyFile, WhatIsWrongIsSaidInOneLine) {
  const std::string head = "*ELASTIC\n3e6, 0.5\n*VISCOELASTIC, TIME=PRONY\n";
  EXPECT_THAT(errorOf(head + "0.5, 0.\n"), HasSubstr("line 4: needs a number in place 3"));
  EXPECT_THAT(errorOf(head + "0.7,0,1\n0.6,0,2\n"), HasSubstr("add up to 1.3"));
  EXPECT_THAT(errorOf(head + "0.7,0,-1\n"), HasSubstr("relaxation time is -1"));
  EXPECT_THAT(errorOf("*VISCOELASTIC, TIME=PRONY\n0.5,0,1\n"),
              HasSubstr("--instantaneous-modulus"));
  EXPECT_THAT(errorOf("tau (s),G (MPa)\n0.1,2\n10,1\n"), HasSubstr("--liquid"));
  EXPECT_THAT(errorOf("tau,G\ninf,1\n0.1,2\n10,1\n"), HasSubstr("--modulus-unit MPa"));
  PronyChoices liquid;
  liquid.isLiquid = true;
  EXPECT_EQ(read("tau (s),G (MPa)\n0.1,2\n10,1\n", liquid)->equilibriumModulus, 0);
}

}  // namespace
}  // namespace asperity
