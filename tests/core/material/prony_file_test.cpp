// Ready Prony series as people and finite-element programs write them.
#include "core/material/prony_file.h"

#include <fmt/format.h>
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

/// The same where moduli and times are quotients, or powers of ten.
void expectSeriesNearly(const std::optional<PronyFile>& file) {
  ASSERT_TRUE(file.has_value());
  EXPECT_NEAR(file->equilibriumModulus, 1e6, 1e-3);
  ASSERT_EQ(file->arms.size(), 2U);
  EXPECT_NEAR(file->arms[0].modulus, 1e6, 1e-3);
  EXPECT_NEAR(file->arms[0].relaxationTime, 10, 1e-9);
  EXPECT_NEAR(file->arms[1].modulus, 2e6, 1e-3);
  EXPECT_NEAR(file->arms[1].relaxationTime, 0.1, 1e-9);
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

PronyChoices atKelvin(double temperature) {
  PronyChoices choices;
  choices.temperature = temperature;
  return choices;
}

std::vector<std::string> notesOf(const std::optional<PronyFile>& file) {
  std::vector<std::string> notes;
  for (const Message& note : file->notes) notes.push_back(note.english());
  return notes;
}

/// The letter of a part says nothing about the modulus of which it is one: E_0 = 12 MPa is G_0 = 4
/// MPa.
TEST(PronyFile, PartsOfAModulusOfTensionAreDividedForShear) {
  const std::string parts = "tau_i (s),g_i\n0.1,0.5\n10,0.25\n";
  for (const std::string header : {"E0 = 12 MPa\n", "E_0: 12 MPa\n", "E_inf = 3 MPa\n",
                                   "Young modulus E0 = 12 MPa\n", "E_inst = 12 MPa (at 20 C)\n",
                                   "Instantaneous Young's modulus: 12 MPa\n", "E_0 (MPa): 12\n"}) {
    SCOPED_TRACE(header);
    const auto file = read(header + parts);
    expectSeries(file);
    EXPECT_THAT(notesOf(file), testing::Contains(HasSubstr("moduli of tension, divided by 3")));
  }
  for (const std::string header : {"G0 = 4 MPa\n", "G_inf = 1 MPa\n"}) {
    const auto file = read(header + parts);
    expectSeries(file);
    EXPECT_THAT(notesOf(file), testing::ElementsAre("moduli of shear, not divided"));
  }
  const auto file = read("Instantaneous modulus: 4 MPa\n" + parts);
  expectSeries(file);
  EXPECT_THAT(notesOf(file), testing::Contains(HasSubstr("shear is assumed")));
  PronyChoices tension;
  tension.modulus = ModulusKind::Tension;
  expectSeries(read("Instantaneous modulus: 12 MPa\n" + parts, tension));
  // Each modulus is of the kind that its own name says.
  expectSeries(read("E_inf = 3 MPa\ntau (s),G (MPa)\n0.1,2\n10,1\n"));
  expectSeries(read("tau (s),E (MPa)\ninf,3\n0.1,6\n10,3\n"));
}

TEST(PronyFile, UnitsAreReadOrRefused) {
  for (const std::string column :
       {"tau (s),0.1,10", "tau (msec),100,10000", "tau [ms],100,10000",
        "tau / min,1.6666666666666667e-3,0.16666666666666666",
        "tau (h),2.7777777777777778e-5,2.7777777777777778e-3", "tau (Sekunden),0.1,10",
        "tau (days),1.1574074074074074e-6,1.1574074074074074e-4"}) {
    SCOPED_TRACE(column);
    const std::size_t first = column.find(','), second = column.rfind(',');
    const auto file = read("G_inf = 1 MPa\n" + column.substr(0, first) + ",G_i (MPa)\n" +
                           column.substr(first + 1, second - first - 1) + ",2\n" +
                           column.substr(second + 1) + ",1\n");
    ASSERT_EQ(file->arms.size(), 2U);
    EXPECT_NEAR(file->arms[0].relaxationTime, 10, 1e-9);
    EXPECT_NEAR(file->arms[1].relaxationTime, 0.1, 1e-9);
    EXPECT_THAT(notesOf(file), testing::ElementsAre("moduli of shear, not divided"));
  }
  for (const char* unit : {"(foo)", "[foo]", "/foo"})
    EXPECT_THAT(errorOf(std::string("G_inf = 1 MPa\ntau ") + unit + ",G_i (MPa)\n0.1,2\n10,1\n"),
                HasSubstr("has the unit foo, which is not one of s, ms"))
        << unit;
  EXPECT_THAT(errorOf("G_inf = 7 foo\ntau (s),G_i (MPa)\n0.1,2\n10,1\n"),
              HasSubstr("G_inf: has the unit foo, which is not one of Pa, kPa, MPa"));
  EXPECT_THAT(errorOf("G_inf = 1 MPa\ntau (s),G_i [foo]\n0.1,2\n10,1\n"),
              HasSubstr("G_i: has the unit foo, which is not one of Pa"));
  const auto file = read("G_inf = 1 MPa\ntau,G_i (MPa)\n0.1,2\n10,1\n");
  expectSeries(file);
  EXPECT_THAT(notesOf(file), testing::Contains("tau has no unit: seconds are assumed"));
  // The unit that the user states is that of numbers without one.
  PronyChoices choices;
  choices.modulusUnit = "MPa";
  expectSeries(read("G_inf = 1 MPa\ntau (s),G_i\n0.1,2\n10,1\n", choices));
  expectSeries(read("G0 = 4\ntau (s),g_i\n0.1,0.5\n10,0.25\n", choices));
  expectSeries(read("G0 = 4 MPa\ntau (s),g_i [%]\n0.1,50\n10,25\n"));
}

TEST(PronyFile, TheHeaderOfATableStatesTemperatureAndShift) {
  const std::string table = "G_inf = 1 MPa\ntau (s),G_i (MPa)\n0.1,2\n10,1\n";
  for (const std::string header :
       {"T_ref = 20 \u00B0C\n", "Reference temperature: 20 C\nC1: 10\nC2: 120\n",
        "Reference temperature: 293.15 K\nWLF C1 = 10, C2 = 120 K\n",
        "Cured at 160 C\nTemperature: 20 C\n"}) {
    SCOPED_TRACE(header);
    const auto file = read(header + table);
    expectSeries(file);
    ASSERT_TRUE(file->temperature.has_value());
    EXPECT_NEAR(*file->temperature, 293.15, 1e-9);
    ASSERT_EQ(file->shift.has_value(), header.find("C2") != header.npos);
    if (file->shift) {
      EXPECT_EQ(*file->shift, (TemperatureShift{10, 120, 293.15}));
    }
  }
  EXPECT_FALSE(read(table)->temperature.has_value());
  // A table of factors may have more rows than the series.
  const auto file =
      read("T_ref = 20 C\n" + table + "\nT (C),log aT\n0,3\n10,1\n20,0\n30,-1\n40,-2\n");
  expectSeries(file);
  ASSERT_TRUE(file->shift.has_value());
  EXPECT_EQ(file->shift->table.size(), 5U);
  // The user's temperature is that of constants without a reference.
  EXPECT_EQ(*read("C1 = 10\nC2 = 120\n" + table, atKelvin(303.15))->shift,
            (TemperatureShift{10, 120, 303.15}));
  EXPECT_EQ(read("T_ref = 20 C\nC1 = 10\nC2 = 120\n" + table, atKelvin(303.15))
                ->shift->referenceTemperature,
            293.15);
}

TEST(PronyFile, CommandsOfAnsys) {
  const auto file = read(
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
    const auto file = read(text);
    ASSERT_TRUE(file.has_value());
    EXPECT_NEAR(file->equilibriumModulus, 1e6, 1e-6);
    ASSERT_EQ(file->arms.size(), 2U);
    EXPECT_NEAR(file->arms[0].relaxationTime, 10, 1e-9);
    EXPECT_NEAR(file->arms[1].relaxationTime, 0.1, 1e-12);
  }
  EXPECT_THAT(errorOf("# G_inf = 1 MPa\nG_i (MPa),beta_i\n2,10\n1,0.1\n"),
              HasSubstr("beta_i: may be a rate or a time"));
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

/// G_i = eta_i / tau_i; two of the three describe an arm.
TEST(PronyFile, ViscositiesOfArmsAreRead) {
  for (const std::string text :
       {"G_inf = 1 MPa\ntau_i (s),eta_i (Pa s)\n0.1,2e5\n10,1e7\n",
        "G_inf = 1 MPa\ntau_i (s);\u03B7_i (MPa s)\n0.1;0.2\n10;10\n",
        "G_inf = 1 MPa\nRelaxation time (ms),Viscosity (kPa s)\n100,200\n10000,10000\n",
        "G_inf = 1 MPa\nlambda_i (s),eta_i (Pa.s)\n0.1,2e5\n10,1e7\n",
        "G_inf = 1 MPa\nG_i (MPa),eta_i (MPa s)\n2,0.2\n1,10\n",
        "G_inf = 1 MPa\nG_i (kPa),eta (Pa s)\n2000,2e5\n1000,1e7\n",
        "G_inf = 1 MPa\ntau_i (s),G_i (MPa),eta_i (Pa s)\n0.1,2,2e5\n10,1,1e7\n"}) {
    SCOPED_TRACE(text);
    expectSeriesNearly(read(text));
    EXPECT_THAT(notesOf(read(text)), testing::Not(testing::Contains(HasSubstr("contradicts"))));
  }
  // Moduli of tension have viscosities of tension.
  expectSeriesNearly(read("E_inf = 3 MPa\ntau (s),eta (MPa s)\n0.1,0.6\n10,30\n"));
  PronyChoices unit;
  unit.modulusUnit = "MPa";
  expectSeriesNearly(read("G_inf = 1\ntau (s),eta_i\n0.1,0.2\n10,10\n", unit));
  expectSeriesNearly(read("G_inf = 1\nG_i,eta_i\n2,0.2\n1,10\n", unit));
  EXPECT_THAT(notesOf(read("G_inf = 1 MPa\ntau (s),G (MPa),eta (MPa s)\n0.1,2,0.4\n10,1,20\n")),
              testing::Contains("eta contradicts the moduli and relaxation times, which are read: "
                                "in the median it is 2 times their product"));
}

TEST(PronyFile, ViscositiesNeedAUnitAndARelaxationTime) {
  EXPECT_THAT(errorOf("G_inf = 1 MPa\ntau (s),eta_i\n0.1,0.2\n10,10\n"),
              HasSubstr("eta_i: has no unit; write it behind the name, as in eta_i (Pa s)"));
  EXPECT_THAT(errorOf("G_inf = 1 MPa\ntau (s),eta_i (MPa)\n0.1,0.2\n10,10\n"),
              HasSubstr("eta_i: has the unit MPa, which is not one of Pa s"));
  EXPECT_THAT(errorOf("G_inf = 1 MPa\nG_i,eta_i (Pa s)\n2,0.2\n1,10\n"),
              HasSubstr("G_i: has no unit, and eta_i is in Pa s; say with --modulus-unit"));
  EXPECT_THAT(errorOf("G_0 = 1 MPa\ng_i (%),eta_i (Pa s)\n50,0.2\n20,10\n"),
              HasSubstr("there is no column of relaxation times"));
  EXPECT_THAT(errorOf("tau (s),eta_i (Pa s)\n0.1,2e5\ninf,1e7\n"),
              HasSubstr("line 3: has a viscosity and no relaxation time"));
  EXPECT_THAT(errorOf("tau (s),eta_i (Pa s)\n0.1,2e5\n0,1e7\n"),
              HasSubstr("line 3: the relaxation time is 0 s"));
  // Modulus and viscosity of a fluid are no arms.
  EXPECT_FALSE(read("T (C),G (Pa),eta (Pa s)\n20,2e5,1e3\n30,1e5,5e2\n").has_value());
  EXPECT_FALSE(read("shear rate (1/s),eta (Pa s)\n0.1,2e5\n10,1e4\n").has_value());
}

TEST(PronyFile, LogarithmsAreUndone) {
  for (const std::string text :
       {"G_inf = 1 MPa\nlog10 tau,G_i (MPa)\n-1,2\n1,1\n",
        "G_inf = 1 MPa\nlog10(tau/s),G_i (MPa)\n-1,2\n1,1\n",
        "G_inf = 1 MPa\nlg \u03C4 (ms);G_i (MPa)\n2;2\n4;1\n",
        "G_inf = 1 MPa\nlog tau_i [s],log G_i [Pa]\n-1,6.301029995663981\n1,6\n",
        "G_inf = 1 MPa\nlog_tau (s),G_i (MPa)\n-1,2\n1,1\n",
        "G_inf = 1 MPa\nln tau (s),G_i (MPa)\n-2.302585092994046,2\n2.302585092994046,1\n",
        "G_inf = 1 MPa\nlog10 tau (s),log10 eta_i (Pa s)\n-1,5.301029995663981\n1,7\n"}) {
    SCOPED_TRACE(text);
    expectSeriesNearly(read(text));
  }
  EXPECT_THAT(notesOf(read("G_inf = 1 MPa\nlog tau (s),G_i (MPa)\n-1,2\n1,1\n")),
              testing::Contains("log tau is read as a logarithm to base 10"));
}

/// G_i / G_inf are parts of another modulus than G_i / G_0: of arms of 2 and 1 MPa beside 1 MPa
/// they are 2 and 1, not 0.5 and 0.25.
TEST(PronyFile, PartsOfTheEquilibriumModulusAreRead) {
  for (const std::string text : {"G_inf = 1 MPa\ntau (s),G_i/G_inf\n0.1,2\n10,1\n",
                                 "G_inf = 1 MPa\ntau (s);G_i/G_\u221E\n0.1;2\n10;1\n",
                                 "E_inf = 3 MPa\ntau (s),E_i/E_inf\n0.1,2\n10,1\n",
                                 "G0 = 4 MPa\ntau (s),G_i/G_inf (%)\n0.1,200\n10,100\n",
                                 "G_inf = 1 MPa\ntau (s),G_i/G_inf\ninf,1\n0.1,2\n10,1\n"}) {
    SCOPED_TRACE(text);
    expectSeriesNearly(read(text));
    EXPECT_THAT(notesOf(read(text)), testing::Not(testing::Contains(HasSubstr("contradict"))));
  }
  // Parts below 1 are no parts of the instantaneous modulus either.
  const auto soft = read("G_inf = 1 MPa\ntau (s),G_i/G_inf\n0.1,0.2\n10,0.1\n");
  EXPECT_NEAR(soft->equilibriumModulus, 1e6, 1e-6);
  EXPECT_NEAR(soft->arms.at(1).modulus, 0.2e6, 1e-6);
  PronyChoices choices;
  choices.equilibriumModulus = 1e6;
  expectSeriesNearly(read("tau (s),G_i/G_inf\n0.1,2\n10,1\n", choices));
  choices = {};
  choices.instantaneousModulus = 4e6;
  expectSeriesNearly(read("tau (s),G_i/G_inf\n0.1,2\n10,1\n", choices));
  EXPECT_THAT(errorOf("tau (s),G_i/G_inf\n0.1,2\n10,1\n"),
              HasSubstr("has parts of a modulus and not the modulus itself"));
  EXPECT_THAT(errorOf("G_inf = 1 MPa\ntau (s),G_i/G_inf\ninf,3\n0.1,2\n10,1\n"),
              HasSubstr("G_i/G_inf: are parts that add up to 1.5 with that of the row without a"));
  EXPECT_THAT(errorOf("G_inf = 1 MPa\ntau (s),G_i/G_inf\n0.1,-2\n10,1\n"),
              HasSubstr("line 3: the modulus is -2"));
}

/// Parts that add up to more than 1 were taken for moduli.
TEST(PronyFile, PartsByTheirNameAreNoModuli) {
  PronyChoices unit;
  unit.modulusUnit = "MPa";
  for (const std::string column : {"G_i/G_0\n0.1,1.5\n10,0.8\n", "g_i (%)\n0.1,150\n10,80\n"})
    EXPECT_THAT(errorOf("G0 = 4\ntau (s)," + column, unit),
                HasSubstr("the parts of the instantaneous modulus add up to 2.3, more than 1"));
}

/// A row of equilibrium that is not what the others leave says that the numbers are moduli.
TEST(PronyFile, SmallModuliAreNoParts) {
  PronyChoices unit;
  unit.modulusUnit = "MPa";
  const auto file = read("tau (s),G\ninf,0.3\n0.1,0.2\n10,0.1\n", unit);
  EXPECT_NEAR(file->equilibriumModulus, 0.3e6, 1e-6);
  EXPECT_NEAR(file->arms.at(0).modulus, 0.1e6, 1e-6);
  PronyChoices choices;
  choices.instantaneousModulus = 4e6;
  expectSeries(read("tau (s),g_i\ninf,0.25\n0.1,0.5\n10,0.25\n", choices));
}

TEST(PronyFile, RowsWithoutAValueAreCountedOrRefused) {
  EXPECT_THAT(notesOf(read("G_inf = 1 MPa\ntau (s),G (MPa)\n0.1,2\n1,\n10,1\n")),
              testing::Contains("rows without a value, left out: 1"));
  EXPECT_THAT(errorOf("tau (s),G (MPa)\n0.1,2\n,5\n10,1\ninf,1\n"),
              HasSubstr("line 5: is a second row without a relaxation time"));
}

TEST(PronyFile, RatesHaveTheirOwnUnit) {
  expectSeriesNearly(read("G_inf = 1 MPa\nG_i (MPa),beta_i (1/ms)\n2,0.01\n1,0.0001\n"));
  expectSeriesNearly(read("G_i (MPa),beta_i (1/s)\n1,0\n2,10\n1,0.1\n"));
  EXPECT_THAT(errorOf("G_inf = 1 MPa\nG_i (MPa),beta_i (kHz)\n2,10\n1,0.1\n"),
              HasSubstr("beta_i: may be a rate or a time; write its unit, as 1/s"));
}

/// A number without a unit that fits the others in no unit was read in Pa, and said to fit.
TEST(PronyFile, AUnitThatDoesNotFitIsNotAssumed) {
  EXPECT_THAT(errorOf("G_inf = 1\ntau (s);G_i (Pa)\n0.1;2e6\n10;1e6\n"),
              HasSubstr("G_inf: has no unit, and G_i is in Pa; write its unit"));
  EXPECT_THAT(errorOf("G_inf = 1e6 Pa\ntau (s);G_i\n0.1;2\n10;1\n"),
              HasSubstr("G_i: has no unit, and G_inf is in Pa; say with --modulus-unit"));
}

TEST(PronyFile, AnInstantaneousModulusIsAboveZero) {
  PronyChoices liquid;
  liquid.isLiquid = true;
  EXPECT_THAT(errorOf("G0 = -4 MPa\ntau (s),g_i\n0.1,0.5\n10,0.25\n", liquid),
              HasSubstr("instantaneous modulus: is not above 0"));
}

/// COMSOL exports a table with % before the lines above it, and saves a list of branches without
/// names: number of the branch, modulus, relaxation time.
TEST(PronyFile, BranchesOfComsolAreRead) {
  PronyChoices choices;
  choices.equilibriumModulus = 1e6;
  for (const std::string text :
       {"% Model:              tread.mph\n% Version:            COMSOL 6.1.0.252\n"
        "% Date:               Mar 3 2024, 10:12\n% Table:              Table 1 - Branches\n"
        "% Branch  Shear modulus (Pa)  Relaxation time (s)\n"
        "1                        2000000                   0.1\n"
        "2                        1000000                   10\n",
        "% Branch,Shear modulus (MPa),Relaxation time (ms)\n1,2,100\n2,1,10000\n",
        "1 2e6 0.1\n2 1e6 10\n", "1\t2000000\t0.1\n2\t1000000\t10\n"}) {
    SCOPED_TRACE(text);
    expectSeriesNearly(read(text, choices));
  }
  EXPECT_THAT(notesOf(read("1 2e6 0.1\n2 1e6 10\n", choices)),
              testing::Contains(HasSubstr("columns without names are read as branches")));
  // Numbers alone are a list of branches where a user states a modulus beside them.
  EXPECT_FALSE(read("1 2e6 0.1\n2 1e6 10\n").has_value());
  EXPECT_FALSE(read("0 2e6 0.1\n7 1e6 10\n", choices).has_value());
  // Energy factors are parts of the equilibrium modulus.
  EXPECT_THAT(errorOf("1 2 0.1\n2 1 10\n", choices),
              HasSubstr("column 2: has no unit, and 2 Pa would be no rubber"));
  choices.modulusUnit = "MPa";
  expectSeriesNearly(read("1 2 0.1\n2 1 10\n", choices));
}

TEST(PronyFile, TablesOfTimesAndModuli) {
  expectSeries(read("tau (s),G (MPa)\ninf,1\n0.1,2\n10,1\n"));
  expectSeries(read("G_inf: 1 MPa\ntau_i [s];G_i [MPa]\n0.1;2\n10;1\n"));
  expectSeries(read("E_inf = 3 MPa\ntau (s)\tE (MPa)\n0.1\t6\n10\t3\n"));
  expectSeries(
      read("E_\u221E = 3 MPa\n\u03C4_i (s);Elastizit\u00E4tsmodul E_i (MPa)\n0.1;6\n10;3\n"));
  PronyChoices choices;
  choices.instantaneousModulus = 4e6;
  expectSeries(read("tau,g_i\n0.1,0.5\n10,0.25\n", choices));
  choices = {};
  choices.equilibriumModulus = 1e6;
  expectSeries(read("tau,g_i\n0.1,0.5\n10,0.25\n", choices));
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
    expectSeries(read(text));
  }
}

TEST(PronyFile, AMissingUnitIsThatWhichFits) {
  for (const std::string text : {"G_inf = 1 MPa\ntau (s);G_i\n0.1;2\n10;1\n",
                                 "G_inf = 1 MPa\ntau (s);G_i\n0.1;2e6\n10;1e6\n",
                                 "G_inf = 1\ntau (s);G_i (MPa)\n0.1;2\n10;1\n",
                                 "G0 = 4e6\ntau (s);G_i (MPa)\n0.1;2\n10;1\n"}) {
    SCOPED_TRACE(text);
    const auto file = read(text);
    expectSeries(file);
    EXPECT_THAT(notesOf(file), testing::Contains(HasSubstr("is assumed, which fits")));
  }
  EXPECT_THAT(errorOf("Ginf = 1 MPa\ntau (s);g_i\n1e-3;50\n1e-1;30\n"),
              HasSubstr("g_i: has no unit, and Ginf is in MPa; say with --modulus-unit"));
  EXPECT_THAT(errorOf("G0 = 4e9\ntau (s);G_i (MPa)\n0.1;2\n10;1\n"),
              HasSubstr("G0: has no unit, and G_i is in MPa; write its unit"));
}

TEST(PronyFile, ModuliThatContradictEachOtherAreSaid) {
  const std::string table = "tau (s),g\n1e-3,0.5\n1e-1,0.3\n";
  EXPECT_THAT(notesOf(read("G0 = 10 MPa\nG_inf = 3 MPa\n" + table)),
              testing::Contains(HasSubstr("the arms leave 2 MPa of the instantaneous modulus, and "
                                          "an equilibrium modulus of 3 MPa")));
  EXPECT_THAT(notesOf(read("G0 = 10 MPa\nG_inf = 2 MPa\n" + table)),
              testing::Not(testing::Contains(HasSubstr("contradict"))));
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

// ---- LS-DYNA

/// *MAT_076: density, bulk modulus, ..., TREF, A, B; a blank card; G_i, beta_i, K_i, beta_Ki.
const std::string kGeneral =
    "*KEYWORD\n*MAT_GENERAL_VISCOELASTIC_TITLE\nTread\n"
    "$#     mid        ro      bulk       pcf        ef      tref         a         b\n"
    "         1  1.10E-09    2000.0       0.0       0.0       0.0       0.0       0.0\n\n"
    "$#      gi     betai        ki    betaki\n"
    "       1.0       0.0\n       2.0      10.0       5.0      10.0\n       1.0       0.1\n"
    "                          50.0      10.0\n*END\n";

TEST(PronyFile, KeywordsOfDyna) {
  const auto file = read(kGeneral);
  expectSeriesNearly(file);
  EXPECT_EQ(file->format.english(), "keywords of LS-DYNA");
  EXPECT_FALSE(file->temperature.has_value());
  EXPECT_THAT(notesOf(file),
              testing::ElementsAre("the file states no units; a density of 1.1e-9 is that of a "
                                   "rubber in t/mm3, so moduli are read in MPa and times in s"));
  expectSeriesNearly(read("*MAT_076\n1,1.1e-9,2000.\n,,,\n1.,0.\n2.,10.\n1.,0.1\n"));
  // G(t) = G_inf + (G_0 - G_inf) exp(-beta t)
  for (const std::string keyword : {"*MAT_VISCOELASTIC\n", "*MAT_006\n"}) {
    const auto one =
        read(keyword + "         7    1100.0     2.0e9     3.0e6     1.0e6      10.0\n");
    ASSERT_EQ(one->arms.size(), 1U);
    EXPECT_NEAR(one->equilibriumModulus, 1e6, 1e-3);
    EXPECT_NEAR(one->arms[0].modulus, 2e6, 1e-3);
    EXPECT_NEAR(one->arms[0].relaxationTime, 0.1, 1e-12);
  }
}

/// The density is that of a rubber in one system of units, and in it the times have theirs.
TEST(PronyFile, TheDensityTellsTheUnitsOfDyna) {
  const auto deck = [](const std::string& density, double modulus, double rate) {
    return fmt::format("*MAT_076\n1,{},1\n\n{},0\n{},{}\n{},{}\n", density, modulus, 2 * modulus,
                       10 * rate, modulus, 0.1 * rate);
  };
  expectSeriesNearly(read(deck("1100", 1e6, 1)));        // kg, m, s
  expectSeriesNearly(read(deck("1.1e-9", 1, 1)));        // t, mm, s
  expectSeriesNearly(read(deck("1.1e-6", 1e-3, 1e-3)));  // kg, mm, ms
  expectSeriesNearly(read(deck("1.1e-6", 1e3, 1)));      // kg, mm, s
  expectSeriesNearly(read(deck("1.1e-3", 1, 1e-3)));     // g, mm, ms
  expectSeriesNearly(read(deck("1.1e-3", 1e6, 1)));      // g, mm, s
  expectSeriesNearly(read(deck("1.1", 1e-5, 1e-6)));     // g, cm, microseconds
  PronyChoices unit;
  unit.modulusUnit = "MPa";
  expectSeriesNearly(read(deck("1.1e-3", 1, 1e-3), unit));
  for (const std::string density : {"0", "7.8e-9", "1.1"})
    EXPECT_THAT(errorOf(deck(density, 1e3, 1)), HasSubstr("line 2: does not tell its units"))
        << density;
  EXPECT_THAT(errorOf(deck("1.1e-6", 1e-3, 1e-3), unit), HasSubstr("does not tell its units"));
}

TEST(PronyFile, AShiftOfDynaIsLeftOut) {
  const auto file = read("*MAT_076\n1,1.1e-9,2000.,0,0,296.15,-20.,100.\n\n1,0\n2,10\n1,0.1\n");
  expectSeriesNearly(file);
  EXPECT_FALSE(file->shift.has_value());
  ASSERT_TRUE(file->temperature.has_value());
  EXPECT_EQ(*file->temperature, 296.15);
  EXPECT_THAT(notesOf(file), testing::Contains(HasSubstr("the series holds at TREF")));
}

TEST(PronyFile, MaterialsOfDynaThatAreNotReadAreRefused) {
  const std::string series = "1,0\n2,10\n1,0.1\n";
  EXPECT_THAT(errorOf("*MAT_ELASTIC\n1,7.8e-9,2.1e5,0.3\n"), HasSubstr("that is not read"));
  EXPECT_THAT(errorOf("*MAT_GENERAL_VISCOELASTIC_MOISTURE\n1,1.1e-9\n\n" + series),
              HasSubstr("that is not read"));
  EXPECT_THAT(errorOf("*MAT_076\n1,1.1e-9\n99\n"), HasSubstr("line 3: takes its constants from"));
  EXPECT_THAT(errorOf("*MAT_076\n1,1.1e-9,1,0,1\n\n" + series), HasSubstr("elastic layer"));
  EXPECT_THAT(errorOf("*MAT_006\n1,1.1e-9,2000,-3,1,10\n"), HasSubstr("has -3 in place 4"));
  EXPECT_THAT(errorOf("*MAT_006\n1,1.1e-9,2000,1,3,10\n"), HasSubstr("line 2: does not relax"));
  EXPECT_THAT(errorOf("*MAT_006\n1 1.1e-9 2000 3 1 10\n"),
              HasSubstr("neither 10 characters wide nor separated by commas"));
  EXPECT_THAT(errorOf("*KEYWORD LONG=Y\n*MAT_006\n1,1.1e-9,2000,3,1,10\n"),
              HasSubstr("line 2: is written in the long format"));
  EXPECT_THAT(errorOf("*MAT_006\n1,1.1e-9,2000,3,1,&beta\n"), HasSubstr("a number in place 6"));
  EXPECT_THAT(errorOf(kGeneral + "*MAT_006\n2,1.1e-9,2000,3,1,10\n"),
              HasSubstr("is a second viscoelastic material"));
  const auto file = read("*MAT_ELASTIC\n2,7.8e-9,2.1e5,0.3\n" + kGeneral);
  expectSeriesNearly(file);
  EXPECT_THAT(notesOf(file), testing::Contains("material Tread is read: of the 2 materials in the "
                                               "file, it has the series"));
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
    expectSeries(read(text));
  }
  const auto file = read(kSteel + kTread + kSeries + kRim);
  ASSERT_EQ(file->notes.size(), 1U);
  EXPECT_EQ(file->notes[0].english(),
            "material Tread 2 is read: of the 3 materials in the file, it has the series");
  EXPECT_TRUE(read(kTread + kSeries)->notes.empty());
}

TEST(PronyFile, AModulusCountsForItsOwnMaterialOfAnsys) {
  const std::string rubber =
      "MP,EX,2,12e6 ! Pa, of a sudden strain\nMP,NUXY,2,0.5\n"
      "TB,PRONY,2,,2,SHEAR\nTBDATA,1,0.5,0.1,0.25,10\n";
  const std::string steel = "MP,EX,1,2.1e11\nMP,PRXY,1,0.3\n";
  const std::string rim = "MPTEMP,1,20\nMPDATA,EX,3,1,7e10\nTB,PRONY,3,1,1,BULK\nTBDATA,1,0.1,1\n";
  for (const std::string& text : {rubber, steel + rubber, rubber + steel, rim + rubber + steel}) {
    SCOPED_TRACE(text);
    expectSeries(read(text));
  }
  EXPECT_THAT(read(steel + rubber)->notes.at(0).english(),
              HasSubstr("material 2 is read: of the 2"));
  // MAT sets the material of MP; TB has 1 where it names none.
  expectSeries(
      read("MAT,2\nMP,EX,,2.1e11\nMAT,1\nMP,EX,,12e6\nTB,PRONY,,1,2\nTBDATA,1,0.5,0.1,0.25,10\n"));
}

TEST(PronyFile, TheModulusOfAnotherMaterialIsNone) {
  EXPECT_THAT(errorOf(kSteel + "*MATERIAL, NAME=TREAD\n" + kSeries),
              HasSubstr("prony.txt: material TREAD: has parts of a modulus and not the modulus"));
  EXPECT_THAT(errorOf("MP,EX,1,2.1e11\nTB,PRONY,2,,1,SHEAR\nTBDATA,1,0.5,0.1\n"),
              HasSubstr("material 2: has parts of a modulus and not the modulus"));
  PronyChoices choices;
  choices.equilibriumModulus = 1e6;
  expectSeries(read(kSteel + "*MATERIAL, NAME=TREAD\n" + kSeries, choices));
  EXPECT_THAT(errorOf(kTread + kSeries + "*MATERIAL, NAME=SIDE\n" + kSeries),
              HasSubstr("is a second *VISCOELASTIC"));
  EXPECT_THAT(errorOf("MP,EX,1,12e6\nTB,PRONY,1\nTBDATA,1,0.5,0.1\nTB,PRONY,2\nTBDATA,1,0.5,1\n"),
              HasSubstr("line 4: is a second TB,PRONY"));
  EXPECT_THAT(errorOf(kTread + "*ELASTIC\n3e6, 0.5\n" + kSeries),
              HasSubstr("line 4: is a second modulus of the same material"));
  EXPECT_THAT(errorOf("MP,EX,1,12e6\nMP,EX,1,6e6\nTB,PRONY,1\nTBDATA,1,0.5,0.1\n"),
              HasSubstr("line 2: states a property of the same material again"));
}

/// The constants of TB,HYPER are those of a sudden deformation: mu for NEO, 2 (C10 + C01) else.
TEST(PronyFile, HyperelasticMaterialsOfAnsys) {
  const std::string series = "TB,PRONY,1,1,2,SHEAR\nTBDATA,1,0.5,0.1,0.25,10\n";
  expectSeries(read("TB,HYPER,1,1,2,NEO\nTBDATA,1,4e6,1e-9\n" + series));
  expectSeries(read("TB,HYPER,1,1,2,MOONEY\nTBDATA,1,1.5e6,0.5e6,1e-9\n" + series));
  expectSeries(read("TB,HYPER,1,1,2,YEOH\nTBDATA,1,2e6,1e5,1e-9\n" + series));
  expectSeries(read("TB,ELASTIC,1,1,2,ISOT\nTBDATA,1,12e6,0.5\n" + series));
  EXPECT_THAT(errorOf("TB,HYPER,1,1,2,OGDEN\nTBDATA,1,4e6,2,1e-9\n" + series),
              HasSubstr("line 1: has a hyperelastic form whose shear modulus is not read"));
}

/// The second constant of an orthotropic material is E_y.
TEST(PronyFile, ModuliOfAnsysThatDifferWithDirectionAreRefused) {
  const std::string series = "TB,PRONY,1,1,2,SHEAR\nTBDATA,1,0.5,0.1,0.25,10\n";
  expectSeries(read("TB,ELASTIC,1\nTBDATA,1,12e6,0.5\n" + series));
  for (const std::string option : {"OELM", "OELN", "AELS", "AELF"})
    EXPECT_THAT(errorOf("TB,ELASTIC,1,1,9," + option +
                        "\nTBDATA,1,12e6,12e6,12e6,0.4,0.4,0.4\nTBDATA,7,4e6,4e6,4e6\n" + series),
                HasSubstr("line 1: has moduli that differ with direction, which are not read"))
        << option;
  // A hyperelastic material does not use them.
  expectSeries(
      read("TB,ELASTIC,1,1,9,OELM\nTBDATA,1,12e6,12e6,12e6\nTB,HYPER,1,1,2,NEO\n"
           "TBDATA,1,4e6,1e-9\n" +
           series));
}

/// The refusal names these options, and then they must help.
TEST(PronyFile, AChosenModulusReplacesOneThatIsNotRead) {
  PronyChoices choices;
  choices.equilibriumModulus = 1e6;
  expectSeries(
      read("TB,ELASTIC,1,1,9,OELM\nTBDATA,1,12e6,12e6,12e6\nTB,PRONY,1,1,2,SHEAR\n"
           "TBDATA,1,0.5,0.1,0.25,10\n",
           choices));
  expectSeries(read("*HYPERELASTIC, OGDEN\n4e5, 2., 1e-9\n" + kSeries, choices));
  expectSeries(read("*ELASTIC, DEPENDENCIES=1\n4e5, 0.5, , 1.\n" + kSeries, choices));
  EXPECT_THAT(errorOf("*HYPERELASTIC, NEO HOOKE, TEST DATA INPUT\n1e5, 0.1\n" + kSeries),
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
    const auto cold = read(text, atKelvin(273.15));
    expectSeries(cold);
    EXPECT_THAT(cold->notes.at(0).english(), HasSubstr("the values at 0.0 \u00B0C are read"));
    EXPECT_NEAR(read(text, atKelvin(373.15))->equilibriumModulus, 0.5e6, 1e-3);
    EXPECT_NEAR(read(text, atKelvin(373.55))->equilibriumModulus, 0.5e6, 1e-3);
    EXPECT_THAT(
        errorOf(text, atKelvin(293.15)),
        HasSubstr("has values at 0.0 \u00B0C, 100.0 \u00B0C and none within 0.6 K of 20.0"));
    EXPECT_THAT(errorOf(text), HasSubstr("temperature: has several values in the file, 0.0"));
    PronyChoices wide = atKelvin(293.15);
    wide.temperatureTolerance = 25;
    expectSeries(read(text, wide));
  }
}

TEST(PronyFile, SeriesAreThoseOfTheTemperatureAskedFor) {
  const std::string text =
      "MP,EX,1,12e6\nTB,PRONY,1,2,2,SHEAR\nTBTEMP,0\nTBDATA,1,0.5,0.1,0.25,10\n"
      "TBTEMP,50\nTBDATA,1,0.25,1e-5,0.1,1e-3\n";
  expectSeries(read(text, atKelvin(273.15)));
  EXPECT_NEAR(read(text, atKelvin(323.15))->equilibriumModulus, 0.65 * 4e6, 1e-3);
  EXPECT_THAT(errorOf(text, atKelvin(293.15)), HasSubstr("line 2: has values at 0.0"));
  EXPECT_THAT(errorOf(text),
              HasSubstr("has several values in the file, 0.0 \u00B0C, 50.0 \u00B0C"));
  PronyChoices modulus;
  modulus.instantaneousModulus = 4e6;
  EXPECT_THAT(errorOf(text, modulus), HasSubstr("has several values in the file"));
}

/// A shift holds from its reference on, so the values are those of that temperature.
TEST(PronyFile, WithAShiftTheValuesAreThoseOfItsReference) {
  const std::string rows = "*ELASTIC\n3e6, 0.5, 25.\n1.5e6, 0.5, 60.\n" + kSeries;
  expectSeries(read(rows + "*TRS\n25., 8.86, 101.6\n"));
  EXPECT_NEAR(read(rows + "*TRS\n60., 8.86, 101.6\n")->equilibriumModulus, 0.5e6, 1e-3);
  EXPECT_THAT(errorOf(rows + "*TRS\n40., 8.86, 101.6\n"),
              HasSubstr("none within 0.6 K of the reference of the shift, 40.0"));
}

TEST(PronyFile, TheOnlyTemperatureOfAFileIsThatOfItsSeries) {
  const std::string row = "*HYPERELASTIC, NEO HOOKE\n5e5, 1e-9, 23.\n" + kSeries;
  const auto file = read(row);
  expectSeries(file);
  ASSERT_TRUE(file->temperature.has_value());
  EXPECT_DOUBLE_EQ(*file->temperature, 296.15);
  EXPECT_EQ(file->notes.at(0).english(),
            "the values at 23.0 \u00B0C are read, with the temperatures of the file in \u00B0C; "
            "--temperature-unit says another");
  EXPECT_THAT(errorOf(row, atKelvin(333.15)), HasSubstr("has values at 23.0 \u00B0C and none"));
  EXPECT_DOUBLE_EQ(
      *read("MP,EX,1,12e6\nTB,PRONY,1\nTBTEMP,296.15\nTBDATA,1,0.5,0.1,0.25,10\n")->temperature,
      296.15);
  EXPECT_THAT(errorOf("*ELASTIC\n3e6, 0.5, -300.\n" + kSeries),
              HasSubstr("temperature: T is -26.85"));
  PronyChoices kelvin;
  kelvin.temperatureUnit = "K";
  EXPECT_DOUBLE_EQ(*read("*ELASTIC\n3e6, 0.5, 150.\n" + kSeries, kelvin)->temperature, 150);
}

/// Programs write a temperature of 0 where none was chosen, as Ansys in the files that it makes.
TEST(PronyFile, ASingleRowAtZeroStatesNoTemperature) {
  const std::string text =
      "MPTEMP,R5.0, 1, 1,  0.0\nMPDATA,R5.0, 1,EX  ,  1, 1,  12000000.\n"
      "TB,PRON,   1,   1,   2,SHEA\nTBTEM,  0.000E+00,   1\nTBDAT,  1,  0.5,  0.1,  0.25, 10.\n";
  EXPECT_FALSE(read(text)->temperature.has_value());
  expectSeries(read(text));
  const auto warm = read(text, atKelvin(293.15));
  expectSeries(warm);
  EXPECT_THAT(warm->notes.at(0).english(), HasSubstr("a single row at temperature 0"));
  EXPECT_TRUE(read(text, atKelvin(273.15))->notes.empty());
}

TEST(PronyFile, RowsThatCannotBeToldApartAreRefused) {
  EXPECT_THAT(errorOf("*ELASTIC\n3e6, 0.5\n1.5e6, 0.5\n" + kSeries),
              HasSubstr("line 1: has more than one row at 0.0"));
  EXPECT_THAT(errorOf("MP,EX,1,12e6,-1e3\nTB,PRONY,1\nTBDATA,1,0.5,0.1\n"),
              HasSubstr("line 1: changes with temperature as a polynomial"));
  EXPECT_THAT(errorOf("MPTEMP,1,0\nMPDATA,EX,1,1,12e6,6e6\nTB,PRONY,1\nTBDATA,1,0.5,0.1\n"),
              HasSubstr("line 2: has a value in place 2 for which MPTEMP has no temperature"));
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
