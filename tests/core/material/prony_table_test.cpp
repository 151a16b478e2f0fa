// Tables of relaxation times, moduli and viscosities in every form.
#include "core/material/prony_table.h"

#include <gmock/gmock.h>

#include "tests/core/material/prony_reading.h"

namespace asperity {
namespace {

using testing::HasSubstr;

TEST(PronyTable, NamesInGermanAreRead) {
  for (const std::string text :
       {"Gleichgewichtsmodul: 1 MPa\nRelaxationszeit (s);Schubmodul (MPa)\n0,1;2\n10;1,0\n",
        "Relaxationszeit (s);Schubmodul (N/mm\u00B2)\n0,1;2\n10;1,0\nGleichgewichtsmodul: 1 "
        "N/mm\u00B2\n",
        "Gleichgewichtsmodul: 3 MPa\nRelaxationszeit (s);E_i (MPa)\n0,1;6\n10;3,0\n"}) {
    SCOPED_TRACE(text);
    expectSeriesNearly(readSeries(text));
  }
}

/// G_i = eta_i / tau_i; two of the three describe an arm.
TEST(PronyTable, ViscositiesOfArmsAreRead) {
  for (const std::string text :
       {"G_inf = 1 MPa\ntau_i (s),eta_i (Pa s)\n0.1,2e5\n10,1e7\n",
        "G_inf = 1 MPa\ntau_i (s);\u03B7_i (MPa s)\n0.1;0.2\n10;10\n",
        "G_inf = 1 MPa\nRelaxation time (ms),Viscosity (kPa s)\n100,200\n10000,10000\n",
        "G_inf = 1 MPa\nlambda_i (s),eta_i (Pa.s)\n0.1,2e5\n10,1e7\n",
        "G_inf = 1 MPa\nG_i (MPa),eta_i (MPa s)\n2,0.2\n1,10\n",
        "G_inf = 1 MPa\nG_i (kPa),eta (Pa s)\n2000,2e5\n1000,1e7\n",
        "G_inf = 1 MPa\ntau_i (s),G_i (MPa),eta_i (Pa s)\n0.1,2,2e5\n10,1,1e7\n"}) {
    SCOPED_TRACE(text);
    expectSeriesNearly(readSeries(text));
    EXPECT_THAT(seriesNotes(readSeries(text)),
                testing::Not(testing::Contains(HasSubstr("contradicts"))));
  }
  // Moduli of tension have viscosities of tension.
  expectSeriesNearly(readSeries("E_inf = 3 MPa\ntau (s),eta (MPa s)\n0.1,0.6\n10,30\n"));
  PronyChoices unit;
  unit.modulusUnit = "MPa";
  expectSeriesNearly(readSeries("G_inf = 1\ntau (s),eta_i\n0.1,0.2\n10,10\n", unit));
  expectSeriesNearly(readSeries("G_inf = 1\nG_i,eta_i\n2,0.2\n1,10\n", unit));
  EXPECT_THAT(
      seriesNotes(readSeries("G_inf = 1 MPa\ntau (s),G (MPa),eta (MPa s)\n0.1,2,0.4\n10,1,20\n")),
      testing::Contains("eta contradicts the moduli and relaxation times, which are read: "
                        "in the median it is 2 times their product"));
}

TEST(PronyTable, TimesMayBeInMinutes) {
  for (const std::string name : {"tau in min", "tau (min.)", "Relaxation time [Min.]", "tau_min"})
    expectSeriesNearly(readSeries("G_inf = 1 MPa\n" + name +
                                  ",G_i (MPa)\n0.0016666666666666668,2\n"
                                  "0.16666666666666666,1\n"));
}

TEST(PronyTable, ViscositiesNeedAUnitAndARelaxationTime) {
  EXPECT_THAT(seriesError("G_inf = 1 MPa\ntau (s),eta_i\n0.1,0.2\n10,10\n"),
              HasSubstr("eta_i: has no unit; write it after the name, as in eta_i (Pa s)"));
  EXPECT_THAT(seriesError("G_inf = 1 MPa\ntau (s),eta_i (MPa)\n0.1,0.2\n10,10\n"),
              HasSubstr("eta_i: has the unit MPa, which is not one of Pa s"));
  EXPECT_THAT(seriesError("G_inf = 1 MPa\nG_i,eta_i (Pa s)\n2,0.2\n1,10\n"),
              HasSubstr("G_i: has no unit, and eta_i is in Pa s; say with --modulus-unit"));
  EXPECT_THAT(seriesError("G_0 = 1 MPa\ng_i (%),eta_i (Pa s)\n50,0.2\n20,10\n"),
              HasSubstr("there is no column of relaxation times"));
  EXPECT_THAT(seriesError("tau (s),eta_i (Pa s)\n0.1,2e5\ninf,1e7\n"),
              HasSubstr("line 3: has a viscosity and no relaxation time"));
  EXPECT_THAT(seriesError("tau (s),eta_i (Pa s)\n0.1,2e5\n0,1e7\n"),
              HasSubstr("line 3: the relaxation time is 0 s"));
  // Modulus and viscosity of a fluid are no arms.
  EXPECT_FALSE(readSeries("T (C),G (Pa),eta (Pa s)\n20,2e5,1e3\n30,1e5,5e2\n").has_value());
  EXPECT_FALSE(readSeries("shear rate (1/s),eta (Pa s)\n0.1,2e5\n10,1e4\n").has_value());
}

TEST(PronyTable, LogarithmsAreUndone) {
  for (const std::string text :
       {"G_inf = 1 MPa\nlog10 tau,G_i (MPa)\n-1,2\n1,1\n",
        "G_inf = 1 MPa\nlog10(tau/s),G_i (MPa)\n-1,2\n1,1\n",
        "G_inf = 1 MPa\nlg \u03C4 (ms);G_i (MPa)\n2;2\n4;1\n",
        "G_inf = 1 MPa\nlog tau_i [s],log G_i [Pa]\n-1,6.301029995663981\n1,6\n",
        "G_inf = 1 MPa\nlog_tau (s),G_i (MPa)\n-1,2\n1,1\n",
        "G_inf = 1 MPa\nln tau (s),G_i (MPa)\n-2.302585092994046,2\n2.302585092994046,1\n",
        "G_inf = 1 MPa\nlog10 tau (s),log10 eta_i (Pa s)\n-1,5.301029995663981\n1,7\n"}) {
    SCOPED_TRACE(text);
    expectSeriesNearly(readSeries(text));
  }
  EXPECT_THAT(seriesNotes(readSeries("G_inf = 1 MPa\nlog tau (s),G_i (MPa)\n-1,2\n1,1\n")),
              testing::Contains("log tau is read as a logarithm to base 10"));
}

/// G_i / G_inf are parts of another modulus than G_i / G_0: of arms of 2 and 1 MPa beside 1 MPa
/// they are 2 and 1, not 0.5 and 0.25.
TEST(PronyTable, PartsOfTheEquilibriumModulusAreRead) {
  for (const std::string text : {"G_inf = 1 MPa\ntau (s),G_i/G_inf\n0.1,2\n10,1\n",
                                 "G_inf = 1 MPa\ntau (s);G_i/G_\u221E\n0.1;2\n10;1\n",
                                 "E_inf = 3 MPa\ntau (s),E_i/E_inf\n0.1,2\n10,1\n",
                                 "G_eq = 1 MPa\ntau (s),G_i / G_eq\n0.1,2\n10,1\n",
                                 "G0 = 4 MPa\ntau (s),G_i/G_inf (%)\n0.1,200\n10,100\n",
                                 "G_inf = 1 MPa\ntau (s),G_i/G_inf\ninf,1\n0.1,2\n10,1\n"}) {
    SCOPED_TRACE(text);
    expectSeriesNearly(readSeries(text));
    EXPECT_THAT(seriesNotes(readSeries(text)),
                testing::Not(testing::Contains(HasSubstr("contradict"))));
  }
  // Parts below 1 are no parts of the instantaneous modulus either.
  const auto soft = readSeries("G_inf = 1 MPa\ntau (s),G_i/G_inf\n0.1,0.2\n10,0.1\n");
  EXPECT_NEAR(soft->equilibriumModulus, 1e6, 1e-6);
  EXPECT_NEAR(soft->arms.at(1).modulus, 0.2e6, 1e-6);
  PronyChoices choices;
  choices.equilibriumModulus = 1e6;
  expectSeriesNearly(readSeries("tau (s),G_i/G_inf\n0.1,2\n10,1\n", choices));
  choices = {};
  choices.instantaneousModulus = 4e6;
  expectSeriesNearly(readSeries("tau (s),G_i/G_inf\n0.1,2\n10,1\n", choices));
  EXPECT_THAT(seriesError("tau (s),G_i/G_inf\n0.1,2\n10,1\n"),
              HasSubstr("has parts of a modulus and not the modulus itself"));
  EXPECT_THAT(seriesError("G_inf = 1 MPa\ntau (s),G_i/G_inf\ninf,3\n0.1,2\n10,1\n"),
              HasSubstr("G_i/G_inf: are parts that add up to 1.5 with that of the row without a"));
  EXPECT_THAT(seriesError("G_inf = 1 MPa\ntau (s),G_i/G_inf\n0.1,-2\n10,1\n"),
              HasSubstr("line 3: the modulus is -2"));
}

/// Parts that add up to more than 1 were taken for moduli.
TEST(PronyTable, PartsByTheirNameAreNoModuli) {
  PronyChoices unit;
  unit.modulusUnit = "MPa";
  for (const std::string column : {"G_i/G_0\n0.1,1.5\n10,0.8\n", "g_i (%)\n0.1,150\n10,80\n"})
    EXPECT_THAT(seriesError("G0 = 4\ntau (s)," + column, unit),
                HasSubstr("the parts of the instantaneous modulus add up to 2.3, more than 1"));
}

/// A row of equilibrium that is not what the others leave says that the numbers are moduli.
TEST(PronyTable, SmallModuliAreNoParts) {
  PronyChoices unit;
  unit.modulusUnit = "MPa";
  const auto file = readSeries("tau (s),G\ninf,0.3\n0.1,0.2\n10,0.1\n", unit);
  EXPECT_NEAR(file->equilibriumModulus, 0.3e6, 1e-6);
  EXPECT_NEAR(file->arms.at(0).modulus, 0.1e6, 1e-6);
  PronyChoices choices;
  choices.instantaneousModulus = 4e6;
  expectSeries(readSeries("tau (s),g_i\ninf,0.25\n0.1,0.5\n10,0.25\n", choices));
}

/// A unit that stands beside the columns is not passed over, and neither is a row that cannot be
/// read.
TEST(PronyTable, UnitsAndRowsAreNotLost) {
  const std::string top = "# G_inf = 1 MPa, T0 = 20 C\n", rows = "tau,G (MPa)\n0.1,2\n10,1\n";
  expectSeries(readSeries(top + "# relaxation times in s\n" + rows));
  for (const std::string& text :
       {top + "# relaxation times in ms\n" + rows, top + rows + "tau in ms\n"})
    EXPECT_THAT(seriesError(text),
                testing::HasSubstr("names 'ms'; write the unit into the name, as "
                                   "in \"tau (ms)\""));
  const auto damaged = readSeries(top + rows + "100,<1\n");
  expectSeries(damaged);
  EXPECT_THAT(seriesNotes(damaged),
              testing::Contains(
                  "Line 5 is left out: it begins with a number but is not a row of the table."));
}

TEST(PronyTable, RowsWithoutAValueAreCountedOrRefused) {
  EXPECT_THAT(seriesNotes(readSeries("G_inf = 1 MPa\ntau (s),G (MPa)\n0.1,2\n1,\n10,1\n")),
              testing::Contains("rows without a value, left out: 1"));
  EXPECT_THAT(seriesError("tau (s),G (MPa)\n0.1,2\n,5\n10,1\ninf,1\n"),
              HasSubstr("line 5: is a second row without a relaxation time"));
}

TEST(PronyTable, RatesHaveTheirOwnUnit) {
  expectSeriesNearly(readSeries("G_inf = 1 MPa\nG_i (MPa),beta_i (1/ms)\n2,0.01\n1,0.0001\n"));
  expectSeriesNearly(readSeries("G_i (MPa),beta_i (1/s)\n1,0\n2,10\n1,0.1\n"));
  EXPECT_THAT(seriesError("G_inf = 1 MPa\nG_i (MPa),beta_i (kHz)\n2,10\n1,0.1\n"),
              HasSubstr("beta_i: may be a rate or a time; write its unit, as 1/s"));
}

TEST(PronyTable, AngularRatesAreReadAndFrequenciesAreAmbiguous) {
  for (const char* names : {"omega_i (rad/s)", "\u03C9_i (1/s)", "omega (rad/s)"})
    expectSeriesNearly(
        readSeries("G_inf = 1 MPa\n" + std::string(names) + ",G_i (MPa)\n10,2\n0.1,1\n"));
  expectSeriesNearly(readSeries("G_inf = 1 MPa\nrelaxation rate (1/s);G (MPa)\n10;2\n0.1;1\n"));
  EXPECT_FALSE(readSeries("omega (krad/s),G' (Pa),G'' (Pa)\n1,2e6,2e5\n2,2e6,2e5\n").has_value());
  for (const char* names : {"f_i (Hz)", "frequency (Hz)", "omega_i (Hz)"})
    EXPECT_THAT(seriesError("G_inf = 1 MPa\n" + std::string(names) + ",G_i (MPa)\n10,2\n0.1,1\n"),
                HasSubstr("may be 1/tau or 1/(2 pi tau)"));
}

TEST(PronyTable, ArmsMayStandSideBySide) {
  for (const char* text :
       {"Compound;G_inf (MPa);G1 (MPa);tau1 (s);G2 (MPa);tau2 (s)\nA12;1;2;0.1;1;10\n",
        "G_1 [MPa];G_2 [MPa];\u03C4_1 [s];\u03C4_2 [s];Ginf [MPa]\n2;1;0,1;10;1\n",
        "G0 (MPa),g1,tau1 (s),g2,tau2 (s)\n4,0.5,0.1,0.25,10\n",
        "E_inf (MPa),E1 (MPa),tau1 (s),E2 (MPa),tau2 (s)\n3,6,0.1,3,10\n"}) {
    SCOPED_TRACE(text);
    expectSeriesNearly(readSeries(text));
  }
  const auto file =
      readSeries("T (\u00B0C),Ginf (MPa),G1 (MPa),tau1 (s),G2 (MPa),tau2 (s)\n20,1,2,0.1,1,10\n");
  expectSeriesNearly(file);
  EXPECT_NEAR(file->temperature.value_or(0), 293.15, 1e-9);
  const auto shifted = readSeries(
      "Tref (C);C1;C2 (K);Ginf (MPa);G1 (MPa);tau1 (s);G2 (MPa);tau2 (s)\n20;8;100;1;2;0.1;1;10\n");
  expectSeriesNearly(shifted);
  EXPECT_EQ(shifted->shift, (TemperatureShift{8, 100, 293.15}));
  EXPECT_THAT(seriesError("name,G_inf (MPa),G1 (MPa),tau1 (s),G2 (MPa),tau2 (s)\n"
                          "NR,1,2,0.1,1,10\nBR,1,3,0.1,1,10\n"),
              HasSubstr("has 2 rows, each of which is a Prony series"));
  EXPECT_THAT(seriesError("G1 (MPa),tau1 (s),G2 (kPa),tau2 (s)\n2,0.1,1,10\n"),
              HasSubstr("looks like the relaxation times of a Prony series"));
}

TEST(PronyTable, RowsMayBeTheQuantities) {
  for (const char* text : {"i;1;2\nG_i (MPa);2;1\n\u03C4_i (s);0,1;10\nG_inf (MPa);1;\n",
                           "# E0 = 12 MPa\nterm,1,2\ng_i,0.5,0.25\ntau_i (s),0.1,10\n",
                           "# G_inf = 1 MPa\ntau (s);0.1;10\nG (MPa);2;1\n"}) {
    SCOPED_TRACE(text);
    const auto file = readSeries(text);
    expectSeriesNearly(file);
    EXPECT_THAT(seriesNotes(file),
                testing::Contains("the table has one row for each quantity, and its columns are "
                                  "the points"));
  }
}

TEST(PronyTable, AModulusOfTheWholeSeriesMayBeAColumn) {
  for (const char* rows : {"0.1;2;1\n10;1;1\n", "0.1;2;1\n10;1;\n"})
    expectSeriesNearly(readSeries("tau_i (s);G_i (MPa);G_inf (MPa)\n" + std::string(rows)));
  EXPECT_THAT(seriesError("tau_i (s);G_i (MPa);G_inf (MPa)\n0.1;2;1\n10;1;3\n"),
              HasSubstr("equilibrium modulus: is not above 0"));
}

TEST(PronyTable, OtherNamesAreRead) {
  expectSeriesNearly(readSeries("G_g = 4 MPa\ng_i,lambda_k (s)\n0.5,0.1\n0.25,10\n"));
  expectSeriesNearly(
      readSeries("G_inf = 1 MPa\nRelaxation time (s),Relaxation modulus (MPa)\n0.1,2\n10,1\n"));
}

/// A list of numbers that say nothing is no table, even where it has more numbers.
TEST(PronyTable, AListOfNumbersAboveTheTableIsPassedOver) {
  expectSeries(readSeries("G_inf = 1 MPa\n20\n30\n40\n50\n60\n\ntau (s);G_i (MPa)\n0.1;2\n10;1\n"));
}

/// A number without a unit that fits the others in no unit was read in Pa, and said to fit.
TEST(PronyTable, AUnitThatDoesNotFitIsNotAssumed) {
  EXPECT_THAT(seriesError("G_inf = 1\ntau (s);G_i (Pa)\n0.1;2e6\n10;1e6\n"),
              HasSubstr("G_inf: has no unit, and G_i is in Pa; write its unit"));
  // What is wrong with parts is said of parts.
  EXPECT_THAT(seriesError("G0 = 3 MPa\ntau (s);g_i\n0.1;0.6\n10;0.5\n"),
              HasSubstr("g_i: has no unit and adds up to 1.1; parts of the instantaneous modulus "
                        "add up to at most 1, and moduli need their unit"));
  EXPECT_THAT(seriesError("G_inf = 1e6 Pa\ntau (s);G_i\n0.1;2\n10;1\n"),
              HasSubstr("G_i: has no unit, and G_inf is in Pa; say with --modulus-unit"));
}

TEST(PronyTable, AnInstantaneousModulusIsAboveZero) {
  PronyChoices liquid;
  liquid.isLiquid = true;
  EXPECT_THAT(seriesError("G0 = -4 MPa\ntau (s),g_i\n0.1,0.5\n10,0.25\n", liquid),
              HasSubstr("instantaneous modulus: is not above 0"));
}

/// COMSOL exports a table with % before the lines above it, and saves a list of branches without
/// names: number of the branch, modulus, relaxation time.
TEST(PronyTable, BranchesOfComsolAreRead) {
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
    expectSeriesNearly(readSeries(text, choices));
  }
  EXPECT_THAT(seriesNotes(readSeries("1 2e6 0.1\n2 1e6 10\n", choices)),
              testing::Contains(HasSubstr("columns without names are read as branches")));
  // Numbers alone are a list of branches where a user states a modulus beside them.
  EXPECT_FALSE(readSeries("1 2e6 0.1\n2 1e6 10\n").has_value());
  EXPECT_FALSE(readSeries("0 2e6 0.1\n7 1e6 10\n", choices).has_value());
  EXPECT_FALSE(readSeries("1 1e4 2e6\n2 1e-1 1e6\n", choices).has_value());
  // Energy factors are parts of the equilibrium modulus.
  EXPECT_THAT(seriesError("1 2 0.1\n2 1 10\n", choices),
              HasSubstr("column 2: has no unit, and 2 Pa would be no rubber"));
  choices.modulusUnit = "MPa";
  expectSeriesNearly(readSeries("1 2 0.1\n2 1 10\n", choices));
}

/// Notes, scripts and lists of parameters state an arm as two named numbers.
TEST(PronyLines, NamedNumbersAreArms) {
  for (const char* text :
       {"G_inf = 1 MPa\nG1 = 2 MPa\ntau1 = 0.1 s\nG2 = 1 MPa\ntau2 = 10 s\n",
        "E_inf: 3 MPa\nE_1: 6 MPa\ntau_1: 0.1 s\nE_2: 3 MPa\ntau_2: 10 s\n",
        "G0 = 4 MPa\nG1 = 2 MPa, tau1 = 0,1 s\nG2 = 1 MPa, tau2 = 10 s\n",
        "Ginf = 1e6 Pa\nG1 = 2000 kPa\nG2 = 1 MPa\ntau1 = 100 ms\ntau2 = 10 s\n",
        "G0;4;MPa\nG1;2;MPa\ntau1;0,1;s\nG2;1;MPa\ntau2;10;s\n",
        "Name\tValue\tUnit\nG_inf\t1\tMPa\nG_1\t2\tMPa\ntau_1\t0.1\ts\nG_2\t1\tMPa\ntau_2\t10\ts\n",
        "Parameter;Wert\nG_inf [MPa];1\nG1 [MPa];2\nG2 [MPa];1\ntau1 [s];0,1\ntau2 [s];10\n",
        "G0 = 4 MPa\ng1 = 0.5\ntau1 = 0.1 s\ng2 = 0.25\ntau2 = 10 s\n",
        "G_inf 1[MPa] \"long-term\"\nG1 2[MPa] \"branch\"\ntau1 0.1[s]\nG2 1[MPa]\ntau2 10[s]\n",
        "G(1) = 2 MPa\ntau(1) = 0.1 s\nG(2) = 1 MPa\ntau(2) = 10 s\nG(inf) = 1 MPa\n",
        "G[inf] = 1 MPa\nG[1] = 2 MPa\ntau[1] = 0.1 s\nG[2] = 1 MPa\ntau[2] = 10 s\n",
        "$G_{\\infty}$ = 1 MPa\n$G_{1}$ = 2 MPa\n$\\tau_{1}$ = 0.1 s\nG_2 = 1 MPa\n\\tau_2 = 10 "
        "s\n",
        "p = dict(G_inf=1e6, G1=2e6, tau1=0.1, G2=1e6, tau2=10)\n",
        "{\"G_inf\": 1e6,\n\"G1\": 2e6,\n\"tau1\": 0.1,\n\"G2\": 1e6,\n\"tau2\": 10}\n",
        "Ginf\uFF1A1 MPa\nG1\uFF1A2 MPa\ntau1\uFF1A0.1 s\nG2\uFF1D1 MPa\ntau2\uFF1D10 s\n",
        "Ginf = 1 MPa # at last\nG1 = 2 MPa (was 3 MPa)\ntau1 = 0.1 s # a: G1\nG2 = 1 MPa # b\n"
        "tau2 = 10 s // tau2 = 9 s\n",
        "Ginf = 1.0D6 ! Pa\nG1 = 2.0D6 ! Pa\ntau1 = 0.1D0 ! s\nG2 = 1.0D6 ! Pa\ntau2 = 1D1 ! s\n",
        "G0 = 4 MPa\ng1 = 50 %, tau1 = 0.1 s\ng2 = 25 %, tau2 = 10 s\n",
        "G\u221E = 1 MPa\nG\u2081 = 2 MPa\n\u03C4\u2081 = 0.1 s\nG\u2082 = 1 MPa\n\u03C4\u2082 = "
        "10 s\n",
        "% NR\nG_inf = 1e6; % Pa\nG1 = 2e6; % Pa\ntau1 = 0.1; % s\nG2 = 1e6; % Pa\ntau2 = 10; % "
        "s\n",
        "G_inf = 1e6  # Pa\nG = [2e6, 1e6]  # Pa\ntau = [0.1, 10]  # s\n",
        "Ginf = 1e6;\nGi = [2e6 1e6];\ntaui = [0.1 10];\n",
        "Modulus 1: 2 MPa\nRelaxation time 1: 0.1 s\nModulus 2: 1 MPa\nRelaxation time 2: 10 s\n"
        "Equilibrium modulus: 1 MPa\n",
        "Ginf: 1 MPa\nArm 1: G = 2 MPa, tau = 0.1 s\nArm 2: G = 1 MPa, tau = 10 s\n",
        "E_inf=3MPa\nE1=6MPa\nt1=0.1s\nE2=3MPa\nt2=10s\n",
        "n;tau_n / s;G_n / MPa\n1;0,1;2\n2;10;1\n\u221E;;1\n",
        "beta_1 = 10 1/s\nG_1 = 2 MPa\nbeta_2 = 0.1 1/s\nG_2 = 1 MPa\nG_inf = 1 MPa\n",
        "eta_1 = 0.2 MPa s\nG_1 = 2 MPa\neta_2 = 10 MPa s\nG_2 = 1 MPa\nG_inf = 1 MPa\n"}) {
    SCOPED_TRACE(text);
    expectSeriesNearly(readSeries(text));
  }
  const auto file =
      readSeries("T = 20 \u00B0C\nG_inf = 1 MPa\nG1 = 2 MPa\ntau1 = 0.1\nG2 = 1 MPa\ntau2 = 10\n");
  expectSeries(file);
  EXPECT_NEAR(file->temperature.value_or(0), 293.15, 1e-9);
  EXPECT_THAT(seriesNotes(file), testing::Contains("tau_i has no unit: seconds are assumed"));
}

TEST(PronyLines, IncompleteArmsAreRefused) {
  EXPECT_THAT(seriesError("G_inf = 1 MPa\nG_1 = 2 MPa\ntau_1 = 0.1 s\nG_2 = 1 MPa\n"),
              HasSubstr("line 4: G_2 is stated without tau_2; each arm needs both"));
  EXPECT_THAT(seriesError("G1 = 2 MPa\nG1 = 3 MPa\ntau1 = 0.1 s\n"),
              HasSubstr("line 2: G_1 is stated in line 1 already"));
  EXPECT_THAT(seriesError("G1 = 2\ntau1 = 0.1 s\nG2 = 1 MPa\ntau2 = 10 s\n"),
              HasSubstr("line 1: G_1 has no unit, as others have; write it after the number"));
  EXPECT_THAT(seriesError("G1 = 2 MPa\ntau1 = 0.1 s\nG2 = 1 stone\ntau2 = 10 s\n"),
              HasSubstr("line 3: G_2 has the unit stone, which is not understood"));
  EXPECT_THAT(seriesError("Ginf = 1\nG1 = 2\ntau1 = 0.1 s\nG2 = 1\ntau2 = 10 s\n"),
              HasSubstr("would be no rubber; say --modulus-unit"));
  EXPECT_THAT(seriesError("Ginf = 1 MPa\nG1 = 2,000 kPa\ntau1 = 0.1 s\n"),
              HasSubstr("may separate decimals or thousands"));
  EXPECT_THAT(seriesError("G_1 = 2 MPa\ntau_1 = 0.1 s\neta_1 = 0.2 MPa s\nG_2 = 1 MPa\n"
                          "tau_2 = 10 s\neta_2 = 10 MPa s\neta_3 = 1 MPa s\n"),
              HasSubstr("line 7: eta_3 is stated without G_3; each arm needs both"));
  // Moduli above a table of measurements are none of its series.
  EXPECT_FALSE(readSeries("G1 = 2 MPa\ntau1 = 0.1 s\nf (Hz),G' (MPa),G'' (MPa)\n1,2,1\n10,3,1\n"));
  EXPECT_FALSE(readSeries("G1 = 2 MPa\nG2 = 1 MPa\n"));
}

/// An arm in a form that is not read was left out without a word.
TEST(PronyLines, NoArmIsLeftOutInSilence) {
  expectSeriesNearly(
      readSeries("Ginf: 1 MPa\nArm 1: G = 2 MPa, tau = 0.1 s\n"
                 "Arm 2: G = 1 MPa, tau = 10 s, eta = 10 MPa s\n"));
  const std::string arm = "Ginf: 1 MPa\nG1 = 2 MPa, tau1 = 0.1 s\n";
  EXPECT_THAT(seriesError(arm + "G2 = 1 MPa, tau = 10 s\n"),
              HasSubstr("line 3: tau belongs to no arm; write the number of its arm"));
  EXPECT_THAT(seriesError(arm + "G = 1 MPa\n"), HasSubstr("line 3: G belongs to no arm"));
  EXPECT_THAT(seriesError(arm + "G2 = abc\ntau2 = n/a\n"),
              HasSubstr("line 3: G_2 has no number that can be read; write it as \"G_2 = 1\""));
  EXPECT_THAT(seriesError("G1;2;MPa\ntau1;0.1;s\nG2;n/a;MPa\n"),
              HasSubstr("line 3: G_2 has no number"));
  for (const char* other : {"double G2 = 1e6; // Pa\ndouble tau2 = 10; // s\n",
                            "| G2 | 1 MPa |\n| tau2 | 10 s |\n", "G2 is 1 MPa\ntau2 is 10 s\n",
                            "G2 -> 1 MPa\ntau2 -> 10 s\n", "p.G2 = 1e6;\np.tau2 = 10;\n"})
    EXPECT_THAT(seriesError(arm + other), HasSubstr("line 3: G_2 has no number")) << other;
  // Words that explain a name are no value of it.
  const std::string both = arm + "G2 = 1 MPa, tau2 = 10 s\n";
  expectSeriesNearly(readSeries("G1: modulus of the first arm\n" + both));
  expectSeriesNearly(readSeries("Sample: E2\n" + both));
  expectSeriesNearly(readSeries("G1 and tau1 are those of the first arm\n" + both));
}

/// Viscosities beside moduli and relaxation times are compared with them.
TEST(PronyLines, ViscositiesThatContradictAreSaid) {
  const std::string arms = "Ginf: 1 MPa\nArm 1: G = 2 MPa, tau = 0.1 s, eta = ";
  const std::string second = " MPa s\nArm 2: G = 1 MPa, tau = 10 s, eta = 10 MPa s\n";
  EXPECT_THAT(seriesNotes(readSeries(arms + "0.2" + second)),
              testing::Not(testing::Contains(HasSubstr("contradicts"))));
  EXPECT_THAT(seriesNotes(readSeries(arms + "20" + second)),
              testing::Contains(HasSubstr("eta_i contradicts the moduli and relaxation times")));
}

TEST(PronyLines, CommasInListsAreReadOrRefused) {
  const auto file = readSeries("G_inf = 1 MPa\nG = [2,5; 1,5]  # MPa\ntau = [1,2; 10,3]  # s\n");
  ASSERT_TRUE(file && file->arms.size() == 2);
  EXPECT_NEAR(file->arms[0].modulus, 1.5e6, 1e-3);
  EXPECT_NEAR(file->arms[0].relaxationTime, 10.3, 1e-9);
  EXPECT_NEAR(file->arms[1].modulus, 2.5e6, 1e-3);
  EXPECT_THAT(seriesError("G_inf = 1 MPa\nG = [2,5 1,5]  # MPa\ntau = [1 2 3 4]\n"),
              HasSubstr("line 2: the commas in the list may separate decimals or numbers"));
  EXPECT_THAT(seriesError("G_inf = 1 MPa\nG = [2, 1; 3, 4]  # MPa\ntau = [1; 10]\n"),
              HasSubstr("line 2: G_1 has no number that can be read"));
  for (const char* list : {"[2e6,1e6]", "[2.0,1e6]", "[2e6, 1e6]", "[2e6; 1e6]", "[2e6 1e6]"})
    EXPECT_EQ(readSeries(std::string("G_inf = 1e6 Pa\nG = ") + list + " # Pa\ntau = [0.1,10]\n")
                  ->arms.size(),
              2U)
        << list;
}

/// An arm that somebody switched off was read.
TEST(PronyLines, ArmsInCommentsCountWhereThereAreNoOthers) {
  const std::string live = "G_inf = 1e6 # Pa\nG1 = 2e6 # Pa\ntau1 = 0.1 # s\n";
  const std::string second = "G2 = 1e6 # Pa\ntau2 = 10 # s\n";
  expectSeriesNearly(
      readSeries(live + second + "# G3 = 9e6 # Pa\n# tau3 = 99 # s\n# G_inf = 3e6 # Pa\n"));
  expectSeriesNearly(readSeries("# G2 = 9e6 # Pa\n" + live + second));
  for (const std::string mark : {"-- ", "REM ", "; ", "' ", "// ", "%"})
    expectSeriesNearly(readSeries(live + mark + "G3 = 9 MPa, tau3 = 99 s\n" + second));
  expectSeriesNearly(
      readSeries("# G_inf = 1 MPa\n# G1 = 2 MPa, tau1 = 0.1 s\n# G2 = 1 MPa, tau2 = 10 s\n"));
  expectSeriesNearly(
      readSeries("# G_inf = 1 MPa\nG1 = 2 MPa, tau1 = 0.1 s\nG2 = 1 MPa, tau2 = 10 s\n"));
}

// Found by random input: the comma before a whole number was taken for its decimal mark.
TEST(PronyLines, CommasBetweenFieldsAreNoDecimalMarks) {
  expectSeriesNearly(
      readSeries("G_inf,1.000,MPa\nG1,2.000,MPa\ntau1,0.1,s\nG2,1.000,MPa\ntau2,10,s\n"));
}

TEST(PronyLines, PointsBesideDecimalCommasMaySeparateThousands) {
  const std::string rest = "tau1 = 0,1 s\nG2 = 1 MPa\ntau2 = 10 s\n";
  EXPECT_THAT(
      seriesError("G_inf = 1 MPa\nG1 = 2.000 kPa\n" + rest),
      HasSubstr("line 2: the mark in the number of G_1 may separate decimals or thousands"));
  EXPECT_THAT(seriesError("G_inf = 1.000 kPa\nG1 = 2 MPa\n" + rest),
              HasSubstr("line 1: the mark in the number of G_inf may separate"));
  EXPECT_THAT(seriesError("G_inf = 1,000 kPa\nG1 = 2 MPa\ntau1 = 0.1 s\n"),
              HasSubstr("line 1: the mark in the number of G_inf may separate"));
  expectSeriesNearly(
      readSeries("G_inf = 1.000 MPa\nG1 = 2.000 MPa\ntau1 = 0.100 s\nG2 = 1.000 MPa\n"
                 "tau2 = 10.000 s\n"));
}

/// A note promises that such a table is read.
TEST(PronyLines, ShiftFactorsBesideNamedArmsAreRead) {
  const std::string arms =
      "T = 20 \u00B0C\nG_inf = 1 MPa\nG1 = 2 MPa, tau1 = 0.1 s\n"
      "G2 = 1 MPa, tau2 = 10 s\n";
  const std::string shifts = "T (C);log aT\n0;2\n20;0\n40;-1.5\n";
  for (const std::string& text : {arms + "\n" + shifts, shifts + "\n" + arms}) {
    SCOPED_TRACE(text);
    const auto file = readSeries(text);
    expectSeriesNearly(file);
    ASSERT_TRUE(file->shift.has_value());
    EXPECT_EQ(file->shift->kind, ShiftKind::Table);
    EXPECT_EQ(file->shift->table.size(), 3U);
    EXPECT_NEAR(file->temperature.value_or(0), 293.15, 1e-9);
  }
}

TEST(PronyTable, TemperatureAndShiftMayStandBelow) {
  for (const char* end : {"", ";;"}) {
    const std::string line = std::string(end) + "\n";
    const auto file = readSeries("tau (s);G (MPa)\n0.1;2\n10;1\n\nG_inf = 1 MPa" + line +
                                 "Tref = 20 \u00B0C" + line + "C1 = 8.86; C2 = 101.6 K\n");
    expectSeries(file);
    EXPECT_NEAR(file->temperature.value_or(0), 293.15, 1e-9);
    ASSERT_TRUE(file->shift.has_value());
    EXPECT_DOUBLE_EQ(file->shift->c2, 101.6);
  }
}

TEST(PronyTable, TheShiftAboveATablePrecedesOneBelow) {
  const auto file = readSeries(
      "G_inf = 1 MPa\nTref = 20 \u00B0C\nC1 = 5\nC2 = 50 K\ntau (s);G (MPa)\n0.1;2\n10;1\n\nC1 = "
      "10\nC2 = 100 "
      "K\n");
  ASSERT_TRUE(file->shift.has_value());
  EXPECT_DOUBLE_EQ(file->shift->c1, 5);
  EXPECT_DOUBLE_EQ(file->shift->c2, 50);
}

TEST(PronyTable, RefusesAnEndModulusWithTwoValues) {
  const std::string arms = "tau (s),G (MPa)\n0.1,2\n10,1\n";
  EXPECT_THAT(seriesError("G_inf = 1 MPa\n" + arms + "G_inf = 1.2 MPa\n"),
              HasSubstr("G_inf: is stated twice, with the shear moduli 1 MPa and 1.2 MPa"));
  EXPECT_THAT(seriesError("G_inf = 2 MPa\ntau (s),G (MPa)\n0.1,2\n10,1\ninf,1\n"),
              HasSubstr("is stated twice"));
  EXPECT_THAT(seriesError("G_0 = 4 MPa\nG_0: 5 MPa\n" + arms), HasSubstr("G_0: is stated twice"));
  // The same value in another unit is no other value.
  expectSeriesNearly(readSeries("G_inf = 1 MPa\nequilibrium modulus: 1000 kPa\n" + arms));
}

/// Moduli of tension depend on Poisson's ratio: one that the file states is not passed over.
TEST(PronyTable, AnotherPoissonsRatioInTheTextIsNamed) {
  const std::string stated = "E_inf = 3 MPa\nnu = 0.49\nT = 20 C\n";
  const auto notes = seriesNotes(readSeries(stated + "i;E_i (MPa);tau_i (s)\n1;6;0.1\n2;3;10\n"));
  EXPECT_THAT(notes,
              testing::Contains(HasSubstr("states a Poisson's ratio of 0.49, and 0.5 is used")));
}

}  // namespace
}  // namespace asperity
