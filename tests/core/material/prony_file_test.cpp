// Ready Prony series as people and finite-element programs write them.
#include "core/material/prony_file.h"

#include <gmock/gmock.h>

#include "tests/core/material/prony_reading.h"

namespace asperity {
namespace {

using testing::HasSubstr;

TEST(PronyFile, KeywordsOfAbaqus) {
  expectSeries(
      readSeries("*MATERIAL, NAME=RUBBER\n*Elastic, moduli=INSTANTANEOUS\n12e6, 0.5\n"
                 "*VISCOELASTIC, TIME=PRONY\n** g_i, k_i, tau_i\n0.5, 0., 0.1\n0.25, 0., 10.\n"));
  // Long-term moduli are the default: G_inf = E / (2 (1 + nu)).
  expectSeries(
      readSeries("*ELASTIC\n3e6, 0.5\n*VISCOELASTIC, TIME=PRONY\n0.5, 0., 0.1\n0.25, 0., 10.\n"));
  // Neo Hooke: G = 2 C10.
  const auto file = readSeries(
      "*HYPERELASTIC, NEO HOOKE, MODULI=LONG TERM\n0.5e6, 0.\n*VISCOELASTIC, "
      "TIME=PRONY\n0.5,0,0.1\n"
      "0.25,0,10\n*TRS, DEFINITION=WLF\n25., 8.86, 101.6\n");
  expectSeries(file);
  ASSERT_TRUE(file->shift.has_value());
  EXPECT_EQ(*file->shift, (TemperatureShift{8.86, 101.6, 298.15}));
}

/// The letter of a part says nothing about the modulus of which it is one: E_0 = 12 MPa is G_0 = 4
/// MPa.
TEST(PronyFile, PartsOfAModulusOfTensionAreDividedForShear) {
  const std::string parts = "tau_i (s),g_i\n0.1,0.5\n10,0.25\n";
  for (const std::string header : {"E0 = 12 MPa\n", "E_0: 12 MPa\n", "E_inf = 3 MPa\n",
                                   "Young modulus E0 = 12 MPa\n", "E_inst = 12 MPa (at 20 C)\n",
                                   "Instantaneous Young's modulus: 12 MPa\n", "E_0 (MPa): 12\n"}) {
    SCOPED_TRACE(header);
    const auto file = readSeries(header + parts);
    expectSeries(file);
    EXPECT_THAT(seriesNotes(file), testing::Contains(HasSubstr("moduli of tension, divided by 3")));
  }
  for (const std::string header : {"G0 = 4 MPa\n", "G_inf = 1 MPa\n"}) {
    const auto file = readSeries(header + parts);
    expectSeries(file);
    EXPECT_THAT(seriesNotes(file), testing::ElementsAre("moduli of shear, not divided"));
  }
  const auto file = readSeries("Instantaneous modulus: 4 MPa\n" + parts);
  expectSeries(file);
  EXPECT_THAT(seriesNotes(file), testing::Contains(HasSubstr("shear is assumed")));
  PronyChoices tension;
  tension.modulus = ModulusKind::Tension;
  expectSeries(readSeries("Instantaneous modulus: 12 MPa\n" + parts, tension));
  // Each modulus is of the kind that its own name says.
  expectSeries(readSeries("E_inf = 3 MPa\ntau (s),G (MPa)\n0.1,2\n10,1\n"));
  expectSeries(readSeries("tau (s),E (MPa)\ninf,3\n0.1,6\n10,3\n"));
}

TEST(PronyFile, UnitsAreReadOrRefused) {
  for (const std::string column :
       {"tau (s),0.1,10", "tau (msec),100,10000", "tau [ms],100,10000",
        "tau / min,1.6666666666666667e-3,0.16666666666666666",
        "tau (h),2.7777777777777778e-5,2.7777777777777778e-3", "tau (Sekunden),0.1,10",
        "tau (days),1.1574074074074074e-6,1.1574074074074074e-4"}) {
    SCOPED_TRACE(column);
    const std::size_t first = column.find(','), second = column.rfind(',');
    const auto file = readSeries("G_inf = 1 MPa\n" + column.substr(0, first) + ",G_i (MPa)\n" +
                                 column.substr(first + 1, second - first - 1) + ",2\n" +
                                 column.substr(second + 1) + ",1\n");
    ASSERT_EQ(file->arms.size(), 2U);
    EXPECT_NEAR(file->arms[0].relaxationTime, 10, 1e-9);
    EXPECT_NEAR(file->arms[1].relaxationTime, 0.1, 1e-9);
    EXPECT_THAT(seriesNotes(file), testing::ElementsAre("moduli of shear, not divided"));
  }
  for (const char* unit : {"(foo)", "[foo]", "/foo"})
    EXPECT_THAT(
        seriesError(std::string("G_inf = 1 MPa\ntau ") + unit + ",G_i (MPa)\n0.1,2\n10,1\n"),
        HasSubstr("has the unit foo, which is not one of s, ms"))
        << unit;
  EXPECT_THAT(seriesError("G_inf = 7 foo\ntau (s),G_i (MPa)\n0.1,2\n10,1\n"),
              HasSubstr("G_inf: has the unit foo, which is not one of Pa, kPa, MPa"));
  EXPECT_THAT(seriesError("G_inf = 1 MPa\ntau (s),G_i [foo]\n0.1,2\n10,1\n"),
              HasSubstr("G_i: has the unit foo, which is not one of Pa"));
  const auto file = readSeries("G_inf = 1 MPa\ntau,G_i (MPa)\n0.1,2\n10,1\n");
  expectSeries(file);
  EXPECT_THAT(seriesNotes(file), testing::Contains("tau has no unit: seconds are assumed"));
  // The unit that the user states is that of numbers without one.
  PronyChoices choices;
  choices.modulusUnit = "MPa";
  expectSeries(readSeries("G_inf = 1 MPa\ntau (s),G_i\n0.1,2\n10,1\n", choices));
  expectSeries(readSeries("G0 = 4\ntau (s),g_i\n0.1,0.5\n10,0.25\n", choices));
  expectSeries(readSeries("G0 = 4 MPa\ntau (s),g_i [%]\n0.1,50\n10,25\n"));
}

TEST(PronyFile, TheHeaderOfATableStatesTemperatureAndShift) {
  const std::string table = "G_inf = 1 MPa\ntau (s),G_i (MPa)\n0.1,2\n10,1\n";
  for (const std::string header :
       {"T_ref = 20 \u00B0C\n", "Reference temperature: 20 C\nC1: 10\nC2: 120\n",
        "Reference temperature: 293.15 K\nWLF C1 = 10, C2 = 120 K\n",
        "Cured at 160 C\nTemperature: 20 C\n"}) {
    SCOPED_TRACE(header);
    const auto file = readSeries(header + table);
    expectSeries(file);
    ASSERT_TRUE(file->temperature.has_value());
    EXPECT_NEAR(*file->temperature, 293.15, 1e-9);
    ASSERT_EQ(file->shift.has_value(), header.find("C2") != header.npos);
    if (file->shift) {
      EXPECT_EQ(*file->shift, (TemperatureShift{10, 120, 293.15}));
    }
  }
  EXPECT_FALSE(readSeries(table)->temperature.has_value());
  // A table of factors may have more rows than the series.
  const auto file =
      readSeries("T_ref = 20 C\n" + table + "\nT (C),log aT\n0,3\n10,1\n20,0\n30,-1\n40,-2\n");
  expectSeries(file);
  ASSERT_TRUE(file->shift.has_value());
  EXPECT_EQ(file->shift->table.size(), 5U);
  // The user's temperature is that of constants without a reference.
  EXPECT_EQ(*readSeries("C1 = 10\nC2 = 120\n" + table, atKelvin(303.15))->shift,
            (TemperatureShift{10, 120, 303.15}));
  EXPECT_EQ(readSeries("T_ref = 20 C\nC1 = 10\nC2 = 120\n" + table, atKelvin(303.15))
                ->shift->referenceTemperature,
            293.15);
}

TEST(PronyFile, CommandsOfAnsys) {
  const auto file = readSeries(
      "/PREP7\nMP,EX,1,12e6\nMP,NUXY,1,0.5\nTB,PRONY,1,1,2,SHEAR\nTBDATA,1,0.5,0.1,0.25,10\n"
      "TB,SHIFT,1,1,3,WLF\nTBDATA,1,298.15,8.86,101.6\n");
  expectSeries(file);
  EXPECT_EQ(file->shift->c2, 101.6);
}

/// The other names of relaxation times; beta is a rate.
TEST(PronyFile, RatesAndOtherNamesOfTimesAreRead) {
  for (const std::string text :
       {"# G_inf = 1 MPa\nlambda_i (s),G_i (MPa)\n0.1,2\n10,1\n",
        "G_inf = 1 MPa\nTemps de relaxation (s);G_i (MPa)\n0.1;2\n10;1\n",
        "# G_inf = 1 MPa\nG_i (MPa),beta_i (1/s)\n2,10\n1,0.1\n",
        "% Long-term shear modulus G: 1e6 Pa\n% tau_i (s),G_i (MPa)\n0.1,2\n10,1\n"}) {
    SCOPED_TRACE(text);
    const auto file = readSeries(text);
    ASSERT_TRUE(file.has_value());
    EXPECT_NEAR(file->equilibriumModulus, 1e6, 1e-6);
    ASSERT_EQ(file->arms.size(), 2U);
    EXPECT_NEAR(file->arms[0].relaxationTime, 10, 1e-9);
    EXPECT_NEAR(file->arms[1].relaxationTime, 0.1, 1e-12);
  }
  EXPECT_THAT(seriesError("# G_inf = 1 MPa\nG_i (MPa),beta_i\n2,10\n1,0.1\n"),
              HasSubstr("beta_i: may be a rate or a time"));
}

/// The unit of a reference temperature stands nowhere in these files.
TEST(PronyFile, TheUnitOfAReferenceTemperatureIsSaidOrTold) {
  const std::string head = "*ELASTIC\n3e6, 0.5\n*VISCOELASTIC, TIME=PRONY\n0.5, 0., 0.1\n";
  const auto referenceOf = [&](const std::string& trs, const char* unit, std::size_t notes) {
    PronyChoices choices;
    choices.temperatureUnit = unit;
    const auto file = readSeries(head + trs, choices);
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
  const auto file = readSeries(text);
  ASSERT_TRUE(file->shift.has_value());
  EXPECT_EQ(file->shift->kind, ShiftKind::Arrhenius);
  EXPECT_EQ(file->shift->activationEnergy, 1.2e5);
  EXPECT_EQ(file->shift->referenceTemperature, 293.15);
  // A model in mm, t and s has energies in mJ.
  const auto small = readSeries(
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
  const auto user = readSeries(
      "*ELASTIC\n3e6, 0.5\n*VISCOELASTIC, TIME=PRONY\n0.5, 0., 0.1\n*TRS, DEFINITION=USER\n");
  EXPECT_FALSE(user->shift.has_value());
  ASSERT_EQ(user->notes.size(), 1U);
  EXPECT_THAT(user->notes[0].english(), HasSubstr("*TRS, DEFINITION=USER is left out"));
  const auto fictive = readSeries(
      "MP,EX,1,12e6\nTB,PRONY,1,1,1,SHEAR\nTBDATA,1,0.5,0.1\nTB,SHIFT,1,1,2,TN\n"
      "TBDATA,1,293.15,50000\n");
  ASSERT_EQ(fictive->notes.size(), 1U);
  EXPECT_THAT(fictive->notes[0].english(), HasSubstr("TB,SHIFT,TN is left out"));
}

/// Scenes take C1 from 0 to 1000.
TEST(PronyFile, AShiftThatNoSceneTakesIsRefused) {
  EXPECT_THAT(seriesError("MP,EX,1,12e6\nTB,PRONY,1,1,1,SHEAR\nTBDATA,1,0.5,0.1\n"
                          "TB,SHIFT,1,1,3,WLF\nTBDATA,1,20,-8.86,101.6\n"),
              HasSubstr("shift: C1 is -8.86, outside 0 to 1000"));
}

/// A part of a series, and the keywords of another program, are no table of dynamic moduli.
TEST(PronyFile, WhatLooksLikeASeriesIsCalledOne) {
  EXPECT_THAT(seriesError("K_i (MPa),G_i (MPa)\n1000,0.5\n0.1,1\n"),
              HasSubstr("there is no column of relaxation times"));
  EXPECT_THAT(seriesError("tau (s),K_i (MPa)\n1000,0.5\n0.1,1\n"),
              HasSubstr("there is no column of moduli"));
  EXPECT_THAT(seriesError("*MAT_GENERAL_VISCOELASTIC\n$ gi betai\n1,1e-9,2000\n"),
              HasSubstr("keyword of LS-DYNA"));
  for (const auto& [text, program] :
       {std::pair("MATVE   100     PRONY                                           +\n"
                  "+       0.5     0.1     0.25    10.0\n",
                  "Nastran"),
        {"/VISC/PRONY/1\n# M K_v\n2\n# G_I Beta_i\n2 10\n1 0.1\n", "Radioss"},
        {"<material id=\"1\" type=\"uncoupled viscoelastic\">\n<t1>0.1</t1>\n", "FEBio"}})
    EXPECT_THAT(seriesError(text), HasSubstr("is a keyword of " + std::string(program)));
  PronyChoices choices;
  choices.instantaneousModulus = 4e6;
  expectSeries(readSeries("tau_i (s);G_i/G_0;K_i\n0.1;0.5;0.1\n10;0.25;0\n", choices));
}

TEST(PronyFile, TablesOfTimesAndModuli) {
  expectSeries(readSeries("tau (s),G (MPa)\ninf,1\n0.1,2\n10,1\n"));
  expectSeries(readSeries("G_inf: 1 MPa\ntau_i [s];G_i [MPa]\n0.1;2\n10;1\n"));
  expectSeries(readSeries("E_inf = 3 MPa\ntau (s)\tE (MPa)\n0.1\t6\n10\t3\n"));
  expectSeries(
      readSeries("E_\u221E = 3 MPa\n\u03C4_i (s);Elastizit\u00E4tsmodul E_i (MPa)\n0.1;6\n10;3\n"));
  PronyChoices choices;
  choices.instantaneousModulus = 4e6;
  expectSeries(readSeries("tau,g_i\n0.1,0.5\n10,0.25\n", choices));
  choices = {};
  choices.equilibriumModulus = 1e6;
  expectSeries(readSeries("tau,g_i\n0.1,0.5\n10,0.25\n", choices));
}

/// The moduli around a table, in every place and form.
TEST(PronyFile, ModuliStandAroundTheTable) {
  for (const std::string text :
       {"Tref = 20 C\nG_inf = 1 MPa\nT (C);log aT\n0;1.5\n20;0\n40;-1\n\ntau (s);G_i "
        "(MPa)\n0.1;2\n10;1\n",
        "Tref = 20 C\ntau (s);G_i (MPa)\n0.1;2\n10;1\n\nG_inf = 1 MPa\n",
        "# T_ref = 20 C, G_inf = 1 MPa\ntau (s),G (MPa)\n0.1,2\n10,1\n",
        "G0: 4 (MPa)\ntau (s);g_i\n0.1;0.5\n10;0.25\n",
        "Schubmodul G0 = 4 MPa\nRelaxationszeit tau [s];Schubmodul G [MPa]\n0.1;2\n10;1\n",
        "Gleichgewichtsmodul G_inf = 1 MPa\nRelaxationszeit [s];Modul G [MPa]\n0.1;2\n10;1\n"}) {
    SCOPED_TRACE(text);
    expectSeries(readSeries(text));
  }
}

TEST(PronyFile, AMissingUnitIsThatWhichFits) {
  for (const std::string text : {"G_inf = 1 MPa\ntau (s);G_i\n0.1;2\n10;1\n",
                                 "G_inf = 1 MPa\ntau (s);G_i\n0.1;2e6\n10;1e6\n",
                                 "G_inf = 1\ntau (s);G_i (MPa)\n0.1;2\n10;1\n",
                                 "G0 = 4e6\ntau (s);G_i (MPa)\n0.1;2\n10;1\n"}) {
    SCOPED_TRACE(text);
    const auto file = readSeries(text);
    expectSeries(file);
    EXPECT_THAT(seriesNotes(file), testing::Contains(HasSubstr("is assumed, which fits")));
  }
  EXPECT_THAT(seriesError("Ginf = 1 MPa\ntau (s);g_i\n1e-3;50\n1e-1;30\n"),
              HasSubstr("g_i: has no unit, and Ginf is in MPa; say with --modulus-unit"));
  EXPECT_THAT(seriesError("G0 = 4e9\ntau (s);G_i (MPa)\n0.1;2\n10;1\n"),
              HasSubstr("G0: has no unit, and G_i is in MPa; write its unit"));
}

TEST(PronyFile, ModuliThatContradictEachOtherAreSaid) {
  const std::string table = "tau (s),g\n1e-3,0.5\n1e-1,0.3\n";
  EXPECT_THAT(seriesNotes(readSeries("G0 = 10 MPa\nG_inf = 3 MPa\n" + table)),
              testing::Contains(HasSubstr("the arms leave 2 MPa of the instantaneous modulus, and "
                                          "an equilibrium modulus of 3 MPa")));
  EXPECT_THAT(seriesNotes(readSeries("G0 = 10 MPa\nG_inf = 2 MPa\n" + table)),
              testing::Not(testing::Contains(HasSubstr("contradict"))));
}

/// Found by random input: of a liquid whose only arm is empty nothing is left.
TEST(PronyFile, ASeriesNeedsAnArm) {
  PronyChoices liquid;
  liquid.instantaneousModulus = 1e7;
  liquid.isLiquid = true;
  EXPECT_THAT(seriesError("relaxation_time;g_i\n10;0\n20;0\n", liquid),
              HasSubstr("has no arm with a modulus above 0"));
}

/// Random input found two terms of one time, which came back as two arms.
TEST(PronyFile, TermsOfEqualTimesAreOneArm) {
  expectSeries(
      readSeries("*ELASTIC, MODULI=INSTANTANEOUS\n12e6, 0.5\n*VISCOELASTIC, TIME=PRONY\n"
                 "0.3, 0., 0.1\n0.25, 0., 10.\n0.2, 0., 0.1\n"));
}

TEST(PronyFile, ATableOfFrequenciesIsNone) {
  EXPECT_FALSE(readSeries("f (Hz),T (C),G' (Pa),G'' (Pa)\n1,20,2e6,2e5\n").has_value());
}

// ---- Several materials

const std::string kSteel = "*MATERIAL, NAME=Steel\n*ELASTIC\n2.1e11, 0.3\n";
const std::string kRim = "*MATERIAL, NAME=RIM\n*ELASTIC\n7e10, 0.3\n";
const std::string kTread = "*Material, name=Tread 2\n*HYPERELASTIC, NEO HOOKE\n5e5, 1e-9\n";
const std::string kSeries = "*VISCOELASTIC, TIME=PRONY\n0.5, 0., 0.1\n0.25, 0., 10.\n";

TEST(PronyFile, AModulusCountsForItsOwnMaterialOfAbaqus) {
  for (const std::string& text :
       {kTread + kSeries, kSteel + kTread + kSeries, kTread + kSeries + kRim,
        kSteel + kTread + kSeries + kRim,
        kTread + kSeries + "*MATERIAL, NAME=CORD\n*HYPERELASTIC, NEO HOOKE\n2e5, 1e-9\n",
        kTread + kSeries + "*MATERIAL, NAME=FOAM\n*HYPERELASTIC, OGDEN\n2e5, 1, 1e-9\n"}) {
    SCOPED_TRACE(text);
    expectSeries(readSeries(text));
  }
  const auto file = readSeries(kSteel + kTread + kSeries + kRim);
  ASSERT_EQ(file->notes.size(), 1U);
  EXPECT_EQ(file->notes[0].english(),
            "material Tread 2 is read: of the 3 materials in the file, it has the series");
  EXPECT_TRUE(readSeries(kTread + kSeries)->notes.empty());
}

TEST(PronyFile, AModulusCountsForItsOwnMaterialOfAnsys) {
  const std::string rubber =
      "MP,EX,2,12e6 ! Pa, of a sudden strain\nMP,NUXY,2,0.5\n"
      "TB,PRONY,2,,2,SHEAR\nTBDATA,1,0.5,0.1,0.25,10\n";
  const std::string steel = "MP,EX,1,2.1e11\nMP,PRXY,1,0.3\n";
  const std::string rim = "MPTEMP,1,20\nMPDATA,EX,3,1,7e10\nTB,PRONY,3,1,1,BULK\nTBDATA,1,0.1,1\n";
  for (const std::string& text : {rubber, steel + rubber, rubber + steel, rim + rubber + steel}) {
    SCOPED_TRACE(text);
    expectSeries(readSeries(text));
  }
  EXPECT_THAT(readSeries(steel + rubber)->notes.at(0).english(),
              HasSubstr("material 2 is read: of the 2"));
  // MAT sets the material of MP; TB has 1 where it names none.
  expectSeries(readSeries(
      "MAT,2\nMP,EX,,2.1e11\nMAT,1\nMP,EX,,12e6\nTB,PRONY,,1,2\nTBDATA,1,0.5,0.1,0.25,10\n"));
}

TEST(PronyFile, TheModulusOfAnotherMaterialIsNone) {
  EXPECT_THAT(seriesError(kSteel + "*MATERIAL, NAME=TREAD\n" + kSeries),
              HasSubstr("prony.txt: material TREAD: has parts of a modulus and not the modulus"));
  EXPECT_THAT(seriesError("MP,EX,1,2.1e11\nTB,PRONY,2,,1,SHEAR\nTBDATA,1,0.5,0.1\n"),
              HasSubstr("material 2: has parts of a modulus and not the modulus"));
  PronyChoices choices;
  choices.equilibriumModulus = 1e6;
  expectSeries(readSeries(kSteel + "*MATERIAL, NAME=TREAD\n" + kSeries, choices));
  EXPECT_THAT(seriesError(kTread + kSeries + "*MATERIAL, NAME=SIDE\n" + kSeries),
              HasSubstr("is a second *VISCOELASTIC"));
  EXPECT_THAT(
      seriesError("MP,EX,1,12e6\nTB,PRONY,1\nTBDATA,1,0.5,0.1\nTB,PRONY,2\nTBDATA,1,0.5,1\n"),
      HasSubstr("line 4: is a second TB,PRONY"));
  EXPECT_THAT(seriesError(kTread + "*ELASTIC\n3e6, 0.5\n" + kSeries),
              HasSubstr("line 4: is a second modulus of the same material"));
  EXPECT_THAT(seriesError("MP,EX,1,12e6\nMP,EX,1,6e6\nTB,PRONY,1\nTBDATA,1,0.5,0.1\n"),
              HasSubstr("line 2: states a property of the same material again"));
}

/// Without a place, TBDATA goes on behind the last constant; TB and TBTEMP begin anew.
TEST(PronyFile, ConstantsOfAnsysFollowEachOther) {
  expectSeries(
      readSeries("TB,ELAS,1,1,2\nTBDATA,,12e6,0.5\nTB,PRONY,1,1,2,SHEAR\n"
                 "TBDATA,,0.5,0.1,,,,\nTBDATA,,0.25,10\n"));
  expectSeries(
      readSeries("TB,ELAS,1,1,2\nTBTEMP,20\nTBDATA,,12e6,0.5\nTBTEMP,60\n"
                 "TBDATA,,6e6,0.5\nTB,PRONY,1,1,2,SHEAR\nTBDATA,3,0.25,10\n"
                 "TBDATA,1,0.5,0.1\n",
                 atKelvin(293.15)));
}

/// Random input found a term with a part and without a time, which was left out, and one with
/// neither.
TEST(PronyFile, TermsOfAnsysAreComplete) {
  EXPECT_THAT(seriesError("MP,EX,1,12e6\nTB,PRONY,1\nTBDATA,1,0.5,0.1,0.25\n"),
              HasSubstr("line 2: has no constant 4"));
  EXPECT_THAT(seriesError("MP,EX,1,12e6\nTB,PRONY,1\nTBDATA,3,0.5,0.1\n"),
              HasSubstr("line 2: has no constant 1"));
}

/// The shear modulus of a small strain is 2 (C10 + C01), or the sum of mu_i for OGDEN.
TEST(PronyFile, HyperelasticMaterialsOfAbaqus) {
  for (const char* form :
       {"NEO HOOKE\n5e5, 1e-9", "MOONEY-RIVLIN\n4e5, 1e5, 1e-9", "YEOH\n5e5, 0., 0., 1e-9, 0., 0.",
        "POLYNOMIAL\n4e5, 1e5, 1e-9", "REDUCED POLYNOMIAL, N=2\n5e5, 3., 1e-9, 0.",
        "OGDEN\n1e6, 3., 1e-9", "OGDEN, N=2\n7e5, 2., 3e5, -2., 1e-9, 0."})
    expectSeries(readSeries("*HYPERELASTIC, " + std::string(form) + "\n" + kSeries));
  for (const char* form :
       {"OGDEN, N=3\n7e5, 2., 2e5, -2., 1e5, 3., 0., 0.\n0.",
        "POLYNOMIAL, N=2\n4e5, 1e5, 0., 0., 0., 1e-9, 0.", "VAN DER WAALS\n1e6",
        "REDUCED POLYNOMIAL, N=0\n5e5, 1e-9", "REDUCED POLYNOMIAL, N=1.5\n5e5, 1e-9"})
    EXPECT_THAT(seriesError("*HYPERELASTIC, " + std::string(form) + "\n" + kSeries),
                HasSubstr("has a hyperelastic form whose shear modulus is not read"));
  expectSeries(
      readSeries("*HYPERELASTIC, NEO HOOKE\n5e5, 1e-9\n*VISCOELASTIC, FREQUENCY=PRONY\n"
                 "0.5, 0., 0.1\n0.25, 0., 10.\n"));
  EXPECT_THAT(seriesError("*VISCOELASTIC, FREQUENCY=TABULAR\n1., 2., 3., 4., 5.\n"),
              HasSubstr("is neither TIME=PRONY nor FREQUENCY=PRONY"));
}

/// The constants of TB,HYPER are those of a sudden deformation: mu for NEO, 2 (C10 + C01) else.
TEST(PronyFile, HyperelasticMaterialsOfAnsys) {
  const std::string series = "TB,PRONY,1,1,2,SHEAR\nTBDATA,1,0.5,0.1,0.25,10\n";
  expectSeries(readSeries("TB,HYPER,1,1,2,NEO\nTBDATA,1,4e6,1e-9\n" + series));
  expectSeries(readSeries("TB,HYPER,1,1,2,MOONEY\nTBDATA,1,1.5e6,0.5e6,1e-9\n" + series));
  expectSeries(readSeries("TB,HYPER,1,1,2,YEOH\nTBDATA,1,2e6,1e5,1e-9\n" + series));
  expectSeries(readSeries("TB,ELASTIC,1,1,2,ISOT\nTBDATA,1,12e6,0.5\n" + series));
  EXPECT_THAT(seriesError("TB,HYPER,1,1,2,OGDEN\nTBDATA,1,4e6,2,1e-9\n" + series),
              HasSubstr("line 1: has a hyperelastic form whose shear modulus is not read"));
}

/// The second constant of an orthotropic material is E_y.
TEST(PronyFile, ModuliOfAnsysThatDifferWithDirectionAreRefused) {
  const std::string series = "TB,PRONY,1,1,2,SHEAR\nTBDATA,1,0.5,0.1,0.25,10\n";
  expectSeries(readSeries("TB,ELASTIC,1\nTBDATA,1,12e6,0.5\n" + series));
  for (const std::string option : {"OELM", "OELN", "AELS", "AELF"})
    EXPECT_THAT(
        seriesError("TB,ELASTIC,1,1,9," + option +
                    "\nTBDATA,1,12e6,12e6,12e6,0.4,0.4,0.4\nTBDATA,7,4e6,4e6,4e6\n" + series),
        HasSubstr("line 1: has moduli that differ with direction, which are not read"))
        << option;
  // A hyperelastic material does not use them.
  expectSeries(
      readSeries("TB,ELASTIC,1,1,9,OELM\nTBDATA,1,12e6,12e6,12e6\nTB,HYPER,1,1,2,NEO\n"
                 "TBDATA,1,4e6,1e-9\n" +
                 series));
}

/// The refusal names these options, and then they must help.
TEST(PronyFile, AChosenModulusReplacesOneThatIsNotRead) {
  PronyChoices choices;
  choices.equilibriumModulus = 1e6;
  expectSeries(
      readSeries("TB,ELASTIC,1,1,9,OELM\nTBDATA,1,12e6,12e6,12e6\nTB,PRONY,1,1,2,SHEAR\n"
                 "TBDATA,1,0.5,0.1,0.25,10\n",
                 choices));
  expectSeries(readSeries("*HYPERELASTIC, VAN DER WAALS\n4e5, 2., 1e-9\n" + kSeries, choices));
  expectSeries(readSeries("*ELASTIC, DEPENDENCIES=1\n4e5, 0.5, , 1.\n" + kSeries, choices));
  EXPECT_THAT(seriesError("*HYPERELASTIC, NEO HOOKE, TEST DATA INPUT\n1e5, 0.1\n" + kSeries),
              HasSubstr("with their constants are, or give --equilibrium-modulus"));
}

// ---- Values at several temperatures

TEST(PronyFile, ModuliAreThoseOfTheTemperatureAskedFor) {
  const std::string elastic = "*ELASTIC\n3e6, 0.5, 0.\n1.5e6, 0.5, 100.\n" + kSeries;
  const std::string neo = "*HYPERELASTIC, NEO HOOKE\n5e5, 1e-9, 0.\n2.5e5, 1e-9, 100.\n" + kSeries;
  const std::string yeoh =
      "*HYPERELASTIC, YEOH\n5e5,1,1,1e-9,0,0,0.\n2.5e5,1,1,1e-9,0,0,100.\n" + kSeries;
  const std::string ansys =
      "MPTEMP,1,0,100\nMPDATA,EX,1,1,12e6,6e6\nTB,PRONY,1\nTBDATA,1,0.5,0.1,0.25,10\n";
  for (const std::string& text : {elastic, neo, yeoh, ansys}) {
    SCOPED_TRACE(text);
    const auto cold = readSeries(text, atKelvin(273.15));
    expectSeries(cold);
    EXPECT_THAT(cold->notes.at(0).english(), HasSubstr("the values at 0.0 \u00B0C are read"));
    EXPECT_NEAR(readSeries(text, atKelvin(373.15))->equilibriumModulus, 0.5e6, 1e-3);
    EXPECT_NEAR(readSeries(text, atKelvin(373.55))->equilibriumModulus, 0.5e6, 1e-3);
    EXPECT_THAT(
        seriesError(text, atKelvin(293.15)),
        HasSubstr("has values at 0.0 \u00B0C, 100.0 \u00B0C and none within 0.6 K of 20.0"));
    EXPECT_THAT(seriesError(text), HasSubstr("temperature: has several values in the file, 0.0"));
    PronyChoices wide = atKelvin(293.15);
    wide.temperatureTolerance = 25;
    expectSeries(readSeries(text, wide));
  }
}

TEST(PronyFile, SeriesAreThoseOfTheTemperatureAskedFor) {
  const std::string text =
      "MP,EX,1,12e6\nTB,PRONY,1,2,2,SHEAR\nTBTEMP,0\nTBDATA,1,0.5,0.1,0.25,10\n"
      "TBTEMP,50\nTBDATA,1,0.25,1e-5,0.1,1e-3\n";
  expectSeries(readSeries(text, atKelvin(273.15)));
  EXPECT_NEAR(readSeries(text, atKelvin(323.15))->equilibriumModulus, 0.65 * 4e6, 1e-3);
  EXPECT_THAT(seriesError(text, atKelvin(293.15)), HasSubstr("line 2: has values at 0.0"));
  EXPECT_THAT(seriesError(text),
              HasSubstr("has several values in the file, 0.0 \u00B0C, 50.0 \u00B0C"));
  PronyChoices modulus;
  modulus.instantaneousModulus = 4e6;
  EXPECT_THAT(seriesError(text, modulus), HasSubstr("has several values in the file"));
}

/// A shift holds from its reference on, so the values are those of that temperature.
TEST(PronyFile, WithAShiftTheValuesAreThoseOfItsReference) {
  const std::string rows = "*ELASTIC\n3e6, 0.5, 25.\n1.5e6, 0.5, 60.\n" + kSeries;
  expectSeries(readSeries(rows + "*TRS\n25., 8.86, 101.6\n"));
  EXPECT_NEAR(readSeries(rows + "*TRS\n60., 8.86, 101.6\n")->equilibriumModulus, 0.5e6, 1e-3);
  EXPECT_THAT(seriesError(rows + "*TRS\n40., 8.86, 101.6\n"),
              HasSubstr("none within 0.6 K of the reference of the shift, 40.0"));
}

TEST(PronyFile, TheOnlyTemperatureOfAFileIsThatOfItsSeries) {
  const std::string row = "*HYPERELASTIC, NEO HOOKE\n5e5, 1e-9, 23.\n" + kSeries;
  const auto file = readSeries(row);
  expectSeries(file);
  ASSERT_TRUE(file->temperature.has_value());
  EXPECT_DOUBLE_EQ(*file->temperature, 296.15);
  EXPECT_EQ(file->notes.at(0).english(),
            "the values at 23.0 \u00B0C are read, with the temperatures of the file in \u00B0C; "
            "--temperature-unit says another");
  EXPECT_THAT(seriesError(row, atKelvin(333.15)), HasSubstr("has values at 23.0 \u00B0C and none"));
  EXPECT_DOUBLE_EQ(
      *readSeries("MP,EX,1,12e6\nTB,PRONY,1\nTBTEMP,296.15\nTBDATA,1,0.5,0.1,0.25,10\n")
           ->temperature,
      296.15);
  EXPECT_THAT(seriesError("*ELASTIC\n3e6, 0.5, -300.\n" + kSeries),
              HasSubstr("temperature: T is -26.85"));
  PronyChoices kelvin;
  kelvin.temperatureUnit = "K";
  EXPECT_DOUBLE_EQ(*readSeries("*ELASTIC\n3e6, 0.5, 150.\n" + kSeries, kelvin)->temperature, 150);
}

/// Programs write a temperature of 0 where none was chosen, as Ansys in the files that it makes.
TEST(PronyFile, ASingleRowAtZeroStatesNoTemperature) {
  const std::string text =
      "MPTEMP,R5.0, 1, 1,  0.0\nMPDATA,R5.0, 1,EX  ,  1, 1,  12000000.\n"
      "TB,PRON,   1,   1,   2,SHEA\nTBTEM,  0.000E+00,   1\nTBDAT,  1,  0.5,  0.1,  0.25, 10.\n";
  EXPECT_FALSE(readSeries(text)->temperature.has_value());
  expectSeries(readSeries(text));
  const auto warm = readSeries(text, atKelvin(293.15));
  expectSeries(warm);
  EXPECT_THAT(warm->notes.at(0).english(), HasSubstr("a single row at temperature 0"));
  EXPECT_TRUE(readSeries(text, atKelvin(273.15))->notes.empty());
}

TEST(PronyFile, RowsThatCannotBeToldApartAreRefused) {
  EXPECT_THAT(seriesError("*ELASTIC\n3e6, 0.5\n1.5e6, 0.5\n" + kSeries),
              HasSubstr("line 1: has more than one row at 0.0"));
  EXPECT_THAT(seriesError("MP,EX,1,12e6,-1e3\nTB,PRONY,1\nTBDATA,1,0.5,0.1\n"),
              HasSubstr("line 1: changes with temperature as a polynomial"));
  EXPECT_THAT(seriesError("MPTEMP,1,0\nMPDATA,EX,1,1,12e6,6e6\nTB,PRONY,1\nTBDATA,1,0.5,0.1\n"),
              HasSubstr("line 2: has a value in place 2 for which MPTEMP has no temperature"));
}

TEST(PronyFile, WhatIsWrongIsSaidInOneLine) {
  const std::string head = "*ELASTIC\n3e6, 0.5\n*VISCOELASTIC, TIME=PRONY\n";
  EXPECT_THAT(seriesError(head + "0.5, 0.\n"), HasSubstr("line 4: needs a number in place 3"));
  EXPECT_THAT(seriesError(head + "0.7,0,1\n0.6,0,2\n"), HasSubstr("add up to 1.3"));
  EXPECT_THAT(seriesError(head + "0.7,0,-1\n"), HasSubstr("relaxation time is -1"));
  EXPECT_THAT(seriesError("*VISCOELASTIC, TIME=PRONY\n0.5,0,1\n"),
              HasSubstr("--instantaneous-modulus"));
  EXPECT_THAT(seriesError("tau (s),G (MPa)\n0.1,2\n10,1\n"), HasSubstr("--liquid"));
  EXPECT_THAT(seriesError("tau,G\ninf,1\n0.1,2\n10,1\n"), HasSubstr("--modulus-unit MPa"));
  PronyChoices liquid;
  liquid.isLiquid = true;
  EXPECT_EQ(readSeries("tau (s),G (MPa)\n0.1,2\n10,1\n", liquid)->equilibriumModulus, 0);
}

}  // namespace
}  // namespace asperity
