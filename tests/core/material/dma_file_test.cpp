// Tables of dynamic moduli as instruments and people write them.
#include "core/material/dma_file.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/base/input_error.h"
#include "tests/core/error_from.h"
#include "tests/core/material/dma_reading.h"

namespace asperity {
namespace {

using testing::HasSubstr;

/// The same two rows in many forms: 20 °C, 1 and 10 Hz, G' 2 and 3 MPa, G'' 0.2 and 0.4 MPa.
TEST(DmaFile, ReadsTheSameRowsFromManyForms) {
  const std::string forms[] = {
      "freq_hz,temperature_C,G_storage_pa,G_loss_pa\n1,20,2e6,2e5\n10,20,3e6,4e5\n",
      "Frequency (Hz);Temp. (\u00B0C);G' (MPa);G'' (MPa)\n1,0;20,0;2,0;0,2\n10,0;20,0;3,0;0,4\n",
      "f\tT\tG'\tG\"\nHz\tK\tkPa\tkPa\n1\t293.15\t2000\t200\n10\t293.15\t3000\t400\n",
      "Angular frequency [rad/s],Temperature [\u00B0F],Shear storage modulus [Pa],Shear loss "
      "modulus [Pa]\n6.283185307179586,68,2e6,2e5\n62.83185307179586,68,3e6,4e5\n",
      "Frequenz / Hz;Temperatur / \u00B0C;Speichermodul G' / MPa;Verlustmodul G'' / MPa\n"
      "1;20;2;0,2\n10;20;3;0,4\n",
      "f (Hz),G' (MPa),tan(delta),T (C)\n1,2,0.1,20\n10,3,0.1333333333333333333,20\n",
      "Temperature: 20 \u00B0C\nf (Hz),G' (Pa),G'' (Pa)\n1,2e6,2e5\n10,3e6,4e5\n",
      "f (Hz),G' 20\u00B0C (MPa),G'' 20\u00B0C (MPa)\n1,2,0.2\n10,3,0.4\n",
      "\u03C9 (rad/s),G\u2032 (Pa),G\u2033 (Pa),T (\u00B0C)\n6.283185307179586,2e6,2e5,20\n"
      "62.83185307179586,3e6,4e5,20\n",
      "# rheometer\nsample,freq_hz,temperature_C,G_storage_pa,G_loss_pa\nA,1,20,2e6,2e5\n"
      "A,10,20,3e6,4e5\n",
      "E' (MPa),E'' (MPa),f (Hz),T (\u00B0C)\n6,0.6,1,20\n9,1.2,10,20\n",
      "log frequency (Hz),T (C),log G' (Pa),log G'' (Pa)\n"
      "0,20,6.301029995663981,5.301029995663981\n1,20,6.477121254719663,5.602059991327963\n",
      "log10(f/Hz);lg(G'/MPa);ln G'' [MPa];T/\u00B0C\n"
      "0;0,3010299956639812;-1,6094379124341003;20\n"
      "1;0,47712125471966244;-0,916290731874155;20\n",
      "##T/\u00B0C;f/Hz;G'/MPa;G\"/MPa;tan d\n20;1;2;0,2;0,1\n20;10;3;0,4;0,1333333333\n",
      "Sample Temperature (C)\tomega (s\u207B\u00B9)\tG' (Pa)\tG'' (Pa)\n"
      "20\t6.283185307179586\t2e6\t2e5\n20\t62.83185307179586\t3e6\t4e5\n",
  };
  for (const std::string& form : forms) {
    SCOPED_TRACE(form);
    const DmaFile file = read(form);
    ASSERT_EQ(file.rows.size(), 2U);
    expectRow(file.rows[0], 293.15, 1, 2e6, 2e5);
    expectRow(file.rows[1], 293.15, 10, 3e6, 4e5);
  }
}

/// |G*| exp(i delta) = G' + i G''.
TEST(DmaFile, MagnitudeAndPhaseAreAComplexNumber) {
  for (const char* header :
       {"f (Hz),T (C),|G*| (MPa),phase (deg)\n", "f (Hz),T (C),G* (MPa),delta\n"}) {
    const DmaFile file = read(std::string(header) + "1,20,2,30\n10,20,4,60\n");
    expectRow(file.rows[0], 293.15, 1, 2e6 * std::cos(std::numbers::pi / 6),
              2e6 * std::sin(std::numbers::pi / 6));
  }
}

TEST(DmaFile, OneModulusAndThePhaseAreAPair) {
  for (const std::string columns : {"G' (MPa),delta (deg)\n1,20,2,30\n10,20,3,30\n",
                                    "G'' (MPa),phase angle (deg)\n1,20,1.1547005383792515,30\n"
                                    "10,20,1.7320508075688772,30\n"}) {
    const DmaFile file = read("f (Hz),T (C)," + columns);
    ASSERT_EQ(file.rows.size(), 2U) << columns;
    expectRow(file.rows[0], 293.15, 1, 2e6, 2e6 * std::tan(std::numbers::pi / 6));
  }
  // No storage modulus follows from a phase of 0; the isotherms refuse an infinite one.
  const DmaFile file = read("f (Hz),T (C),G'' (MPa),phase (deg)\n1,20,1,0\n10,20,1,30\n");
  EXPECT_THROW(groupIsotherms(file.rows), InputError);
}

/// One modulus beside magnitude and phase was taken for half of a pair whose other half is missing.
TEST(DmaFile, AModulusBesideMagnitudeAndPhaseIsNotNeeded) {
  for (const std::string other : {"G' (MPa)", "G'' (MPa)"}) {
    const DmaFile file =
        read("f (Hz),T (C)," + other + ",|G*| (MPa),phase (deg)\n1,20,9,2,30\n10,20,9,4,30\n");
    ASSERT_EQ(file.rows.size(), 2U) << other;
    expectRow(file.rows[0], 293.15, 1, 2e6 * std::cos(std::numbers::pi / 6), 1e6);
    EXPECT_EQ(file.facts.storage.name, "|G*|");
    EXPECT_EQ(file.facts.loss.name, "phase");
  }
}

TEST(DmaFile, BlocksAndWideTablesHaveATemperatureEach) {
  const DmaFile blocks = read(
      "Temperature: 20 C\nf;G';G''\nHz;MPa;MPa\n1;2;1\n2;3;1\n\nTemperature: 30 C\nf;G';G''\n"
      "Hz;MPa;MPa\n1;1.5;1\n2;2.5;1\n");
  ASSERT_EQ(blocks.rows.size(), 4U);
  expectRow(blocks.rows[0], 293.15, 1, 2e6, 1e6);
  expectRow(blocks.rows[3], 303.15, 2, 2.5e6, 1e6);
  const DmaFile wide = read(
      "f (Hz),G' @ 20C (MPa),G'' @ 20C (MPa),G' @ 30C (MPa),G'' @ 30C (MPa)\n1,2,1,1.5,1\n"
      "2,3,1,2.5,1\n");
  ASSERT_EQ(wide.rows.size(), 4U);
  expectRow(wide.rows[3], 303.15, 2, 2.5e6, 1e6);
}

TEST(DmaFile, ModuliOfTensionBecomeThoseOfShear) {
  DmaChoices choices;
  choices.poissonRatio = 0.35;
  const DmaFile file =
      read("f (Hz),T (C),E' (MPa),E'' (MPa)\n1,20,2.7,0.27\n2,20,2.7,0.27\n", choices);
  expectRow(file.rows[0], 293.15, 1, 1e6, 1e5);
  EXPECT_EQ(file.facts.modulus, ModulusKind::Tension);
}

TEST(DmaFile, TheUsersWordWins) {
  DmaChoices choices;
  choices.frequencyColumn = "3";
  choices.storageColumn = "first";
  choices.lossColumn = "second";
  choices.modulus = ModulusKind::Shear;
  choices.modulusUnit = "MPa";
  choices.temperature = 293.15;
  const DmaFile file = read("first,second,third\n2,0.2,1\n3,0.4,10\n", choices);
  expectRow(file.rows[1], 293.15, 10, 3e6, 4e5);
  choices.lossColumn = "fourth";
  EXPECT_THAT(errorOf("first,second,third\n2,0.2,1\n3,0.4,10\n", choices),
              HasSubstr("--loss-column: fourth is not one of first, second, third"));
}

TEST(DmaFile, AMasterCurveIsAtOneTemperature) {
  const DmaFile file = read(
      "Reference temperature: 25 C\nReduced frequency (Hz),T (C),G' (Pa),G'' "
      "(Pa)\n1e-3,60,1e6,1e5\n"
      "1e5,-10,2e6,5e5\n");
  EXPECT_TRUE(file.facts.isReduced);
  expectRow(file.rows[1], 298.15, 1e5, 2e6, 5e5);
}

/// Numbers with K or \u00B0C near the table are often of something else than the test.
TEST(DmaFile, TheTemperatureOfTheTestIsFoundAmongOthers) {
  const std::string table = "f [Hz];G' [Pa];G'' [Pa]\n1;2e6;2e5\n10;3e6;4e5\n";
  for (const std::string header : {
           "Temperature: 20 \u00B0C\nHeating rate: 2 K/min\n",
           "Temperature: 20 \u00B0C\nramp of 2 K / min, then 5 \u00B0C/s\n",
           "Temperature: 20 \u00B0C\nSoak time: 300 s, tolerance 0.5 K\n",
           "Temperature: 20 \u00B0C\nVulcanization: 160 \u00B0C, 12 min\n",
           "Temperature: 20 \u00B0C\nVulkanisation: 12 min, T = 160 \u00B0C\n",
           "Sample: NR, cured 12 min at 160 \u00B0C\nTest temperature: 20 \u00B0C\n",
           "Messtemperatur: 20 \u00B0C\nGlas\u00FCbergang Tg: -58 \u00B0C\n",
           "Messtemperatur: 20 \u00B0C\nT_g = -58 \u00B0C\n",
           "Isothermal frequency sweep at 20 \u00B0C\nOven range -150 \u00B0C to 600 \u00B0C\n",
           "density 1.1 g/cm3 at 23 \u00B0C\nsweep at 20 \u00B0C\n-150 ... 600 \u00B0C\nT max = 80 "
           "\u00B0C\n",
           "Master curve, Tref = 20 \u00B0C\nWLF C1 = 10\nWLF C2 = 120 K\n",
           "Reference temperature: 20 \u00B0C\nC1: 10\nC2: 120 K\n",
           "Bezugstemperatur: 293.15 K\nWLF C1 = 10, C2 = 120 K\n",
           "Set temperature: 25 \u00B0C\nSample temperature: 20 \u00B0C\n",
           "Temperature [\u00B0C]: 20\nRoom temperature: 24 \u00B0C\n",
           "T/K = 293.15\nstiffness measured at 25 \u00B0C\n",
           "Temperature: 20 \u00B1 0.5 \u00B0C\n",
           "Temperature: 20 \u00B0C \u00B1 0.5 K\n",
           "T = 20 \u00B0C, cooling 3 K/min\nReference temperature: 50 \u00B0C\n",
           "Temperature: 20\n",
           "Reference: 2041\nt = 300\nStep 3: 20 \u00B0C\nTemperature step: 5 K\n",
           "NETZSCH DMA 242 C\nfrequency sweep (20.0 \u00B0C)\n",
           "Tempered 24 h at 70 \u00B0C\nTest at 20 \u00B0C\n",
           "Getempert 24 h bei 70 \u00B0C\nTest bei 20 \u00B0C\n",
           "Tempern 70 \u00B0C\nMessung bei 20 \u00B0C\n",
           "Vernetzungstemperatur: 160 \u00B0C\nMessung bei 20 \u00B0C\n",
           "Verarbeitungstemperatur 160 \u00B0C\nMessung bei 20 \u00B0C\n",
           "Processing temperature: 160 \u00B0C\nMeasured at 20 \u00B0C\n",
           "Crosslinking temperature: 160 \u00B0C\nMeasured at 20 \u00B0C\n",
           "Drying temperature: 80 \u00B0C\nMeasured at 20 \u00B0C\n",
           "Trocknungstemperatur: 80 \u00B0C\nMessung bei 20 \u00B0C\n",
           "Storage temperature: 5 \u00B0C\nMeasured at 20 \u00B0C\n",
           "Process temperature: 160 \u00B0C\nProcess: sweep, 20 \u00B0C\n",
           "Storage modulus, temperature 20 \u00B0C\n",
           "Brittleness temperature: -55 \u00B0C\nMeasured at 20 \u00B0C\n",
           "Softening temperature: 90 \u00B0C\nMeasured at 20 \u00B0C\n",
           "Kristallisation: -35 \u00B0C\ngemessen bei 20 \u00B0C\n",
           "Temp\u00E9rature de cuisson : 150 \u00B0C\nMesure \u00E0 20 \u00B0C\n",
           "Number of temperatures: 9\nMeasured at 20 \u00B0C\n",
           "Temperature sensor: 2\nMeasured at 20 \u00B0C\n",
           "Attempt: 2\nTemperature: 20 \u00B0C\n",
           "Temperature program: 1\nMeasured at 20 \u00B0C\n",
           "Temperature: 20 \u00B0C\nTemperature precision 0.1 K\nTemperature stability: 0.1 "
           "\u00B0C\n",
           "Aging: 7 d, 70 \u00B0C; Temperature: 20 \u00B0C\n",
           "SBR, cure 10 min @ 170 \u00B0C, tested at 20 \u00B0C\n",
           "SBR, cured at 160 \u00B0C and tested at 20 \u00B0C\n",
           "Vulkanisation 170\u00B0C/10min; Messung 20\u00B0C\n",
           "Test: 20 \u00B0C, press 160 \u00B0C 10 min\n",
           "Press: 160 \u00B0C, 10 min, Test: 20 \u00B0C\n",
           "T_test = 20 \u00B0C\nT_cure = 160 \u00B0C\n",
           "Ttest: 20 \u00B0C\nTcure: 160 \u00B0C\nTg: -50 \u00B0C\n",
           "Temperatur: 20 Grad Celsius\n",
           "Sample: NR 60C\nFrequency sweep 20 \u00B0C\n",
           "Run at 20 C\n",
           "Probe: SBR T90; Temperature: 20 \u00B0C\n",
           "Probe: SBR T90; Tref: 20 \u00B0C; cure 10 min @ 170 \u00B0C\n",
       }) {
    SCOPED_TRACE(header);
    EXPECT_NEAR(read(header + table).rows.front().temperature, 293.15, 1e-9);
  }
  const std::string reduced = "Temperature: 50 \u00B0C\nReference temperature: 20 \u00B0C\n";
  EXPECT_NEAR(read(reduced + "Reduced frequency (Hz);G' [Pa];G'' [Pa]\n1;2e6;2e5\n10;3e6;4e5\n")
                  .rows.front()
                  .temperature,
              293.15, 1e-9);
}

/// The names of samples and their conditions have numbers of other things in front: the mixture,
/// its filler, the hardness.
TEST(DmaFile, NumbersInTheNamesOfSamplesAreNoTemperatures) {
  const std::string table = "f [Hz];G' [Pa];G'' [Pa]\n1;2e6;2e5\n10;3e6;4e5\n";
  for (const std::string header :
       {"Mischung A12, 20 \u00B0C",
        "Mischung 7; 20 \u00B0C",
        "Mixture B2, 20 \u00B0C",
        "Probe 3 (20 \u00B0C)",
        "Sample: NR 60 [20 \u00B0C]",
        "NR-CB50_20C",
        "SBR_50phr_20C",
        "NR_60ShA_20degC_1Hz",
        "EPDM70_293.15K",
        "NR_68F",
        "HNBR 75, 20 \u00B0C",
        "Rubber N330, 50 phr, 20 \u00B0C",
        "SBR, 60 Shore A, 20 \u00B0C",
        "Sample A12 20 \u00B0C",
        "Probe 3C, 20 \u00B0C",
        "3C, 20 \u00B0C",
        "NR N330 @ 20 C",
        "Mischung A12, T = 20 \u00B0C",
        "NR-CB50, aged 168 h at 70 \u00B0C, T = 20 \u00B0C",
        "Mischung A12, cured 10 min at 160 \u00B0C, tested at 20 \u00B0C"})
    EXPECT_NEAR(read(header + "\n" + table).rows.front().temperature, 293.15, 1e-9) << header;
  for (const std::string header : {"Mischung bei 160 \u00B0C",
                                   "Mischung: 160 \u00B0C",
                                   "Mix 160 \u00B0C",
                                   "NR aged (70 \u00B0C)",
                                   "NR_aged_70C",
                                   "NR_168h_70C",
                                   "NR_20C_to_60C",
                                   "NR-20C",
                                   "Netzsch_DMA_242C_x",
                                   "DMA 242C",
                                   "Hardness 60 Shore A, 23 \u00B0C",
                                   "TR10: -40 \u00B0C",
                                   "ML(1+4) 100 \u00B0C",
                                   "ML 1+4 @ 100 \u00B0C",
                                   "TR 10 -40 \u00B0C",
                                   "LTB -40 \u00B0C",
                                   "VST 95 \u00B0C",
                                   "DVR (70 \u00B0C)",
                                   "DSC: -60 \u00B0C",
                                   "IRM 903, 70 \u00B0C",
                                   "UV 60 \u00B0C",
                                   "Bad A 70 \u00B0C",
                                   "Mooney 100 \u00B0C",
                                   "Mix 2 160 \u00B0C",
                                   "Mischung 1 160 \u00B0C",
                                   "Mixture A (160 \u00B0C)",
                                   "run_3C",
                                   "DMA_242C",
                                   "Td 120 \u00B0C",
                                   "swollen (40 \u00B0C)",
                                   "NR_RT_C"})
    EXPECT_THAT(errorOf(header + "\n" + table),
                HasSubstr("temperature: is stated nowhere; say at which the moduli were measured"))
        << header;
}

TEST(DmaFile, TheNameOfTheFileMayStateTheTemperature) {
  const std::string table = "f [Hz];G' [Pa];G'' [Pa]\n1;2e6;2e5\n10;3e6;4e5\n";
  const auto readNamed = [](const std::string& text, const std::string& name) {
    return readDmaFile(readTextTable(text, name, {}), name, {});
  };
  for (const char* name : {"data/NR-CB50_20C.csv", "Probe 3 (20 \u00B0C).txt", "20C.csv"}) {
    const DmaFile file = readNamed(table, name);
    EXPECT_NEAR(file.rows.front().temperature, 293.15, 1e-9) << name;
    EXPECT_EQ(factsOf(file.facts)[1].english(), "temperature: 20.0 \u00B0C (name of the file)");
  }
  // What the file says itself comes first, and a doubt in it remains one.
  EXPECT_NEAR(readNamed("T = 20 \u00B0C\n" + table, "NR_60C.csv").rows.front().temperature, 293.15,
              1e-9);
  EXPECT_THROW(readNamed("Swollen at 40 \u00B0C\n" + table, "NR_20C.csv"), InputError);
  EXPECT_THROW(readNamed(table, "NR_aged_70C.csv"), InputError);
  // A line below the table that states another one is a doubt; one that agrees is none.
  EXPECT_THAT(errorFrom([&] { readNamed(table + "T = 60 \u00B0C\n", "NR_20C.csv"); }),
              HasSubstr("is 20.0 \u00B0C by the name of the file and 60.0 \u00B0C in line 4"));
  EXPECT_NEAR(readNamed(table + "T = 20 \u00B0C\n", "NR_20C.csv").rows.front().temperature, 293.15,
              1e-9);
}

/// People and word processors write a minus in many ways; a dash between words is none.
TEST(DmaFile, MinusSignsOfTemperaturesAreRead) {
  const std::string table = "f [Hz];G' [Pa];G'' [Pa]\n1;2e6;2e5\n10;3e6;4e5\n";
  const auto kelvin = [&](const std::string& header) {
    return read(header + "\n" + table).rows.front().temperature;
  };
  for (const char* header :
       {"T = \u201320 \u00B0C", "Temperature: - 20 \u00B0C", "Temperature: \u2212 20 \u00B0C",
        "\u201320 \u00B0C", "Temperature: minus 20 \u00B0C", "measured at - 20 \u00B0C"})
    EXPECT_NEAR(kelvin(header), 253.15, 1e-9) << header;
  for (const char* header : {"Sample A \u2013 20 \u00B0C", "Frequency sweep - 20 \u00B0C",
                             "Temperature: 20 +/- 1 \u00B0C", "Temperature: 20 +/-1 \u00B0C"})
    EXPECT_NEAR(kelvin(header), 293.15, 1e-9) << header;
}

TEST(DmaFile, FrenchNamesOfColumnsAreKnown) {
  const DmaFile file = read(
      "Temp\u00E9rature (\u00B0C)\tFr\u00E9quence (Hz)\tG' (MPa)\tG'' (MPa)\n"
      "20\t1\t2\t0.2\n20\t10\t3\t0.4\n");
  expectRow(file.rows[0], 293.15, 1, 2e6, 2e5);
}

TEST(DmaFile, WithoutATemperatureOfTheTestTheFileIsRefused) {
  const std::string table = "f [Hz];G' [Pa];G'' [Pa]\n1;2e6;2e5\n10;3e6;4e5\n";
  for (const std::string header :
       {"Sample: NR, cured 12 min at 160 \u00B0C\n", "Temperature range: -40 to 60 \u00B0C\n",
        "Heating rate: 2 K/min\n", "Oven -150 \u00B0C to 600 \u00B0C\n", "B = 12 K\n",
        "Temperature points: 9\n", "Temperature profile: 3\n", "Temperature control: 1\n",
        "Temps : 12\n", "Attempt: 2\n", "Sample: NR N330 C\n",
        "Rheometer MDR 160 \u00B0C: t90 = 8.2 min\n", "MDR 2000, 170 \u00B0C, ts2 1.3 min\n",
        "Build 120 C\n", "Curing: 10 min; T = 160 \u00B0C\n"})
    EXPECT_THAT(errorOf(header + table),
                HasSubstr("temperature: is stated nowhere; say at which the moduli were measured "
                          "with --temperature"))
        << header;
  EXPECT_THAT(errorOf("Temperature: 2 K\n" + table),
              HasSubstr("line 1: states a temperature of 2 K, at which no rubber is measured"));
  EXPECT_THAT(
      errorOf("Temperature: 20 \u00B0C\nT = 40 \u00B0C\n" + table),
      HasSubstr("temperature: is 20.0 \u00B0C in line 1 and 40.0 \u00B0C in line 2; say with "
                "--temperature which"));
  EXPECT_THAT(errorOf("f (Hz),T (K),G' (Pa),G'' (Pa)\n1,20,2e6,2e5\n10,20,3e6,4e5\n"),
              HasSubstr("line 2: the temperature is 20 K, at which no rubber is measured"));
}

/// Each block has its own temperature, whatever else its header states.
TEST(DmaFile, BlocksWithTolerancesAreIsotherms) {
  const DmaFile file = read(
      "Instrument: DMA 242\n\nStep\nTemperature: -40 \u00B0C\nSoak tolerance: 0.5 K\nf;G';G''\n"
      "Hz;MPa;MPa\n1;2;1\n2;3;1\n\nStep\nTemperature: 20 \u00B0C\nSoak tolerance: 0.5 K\n"
      "f;G';G''\nHz;MPa;MPa\n1;1.5;1\n2;2.5;1\n");
  ASSERT_EQ(file.rows.size(), 4U);
  EXPECT_NEAR(file.rows[0].temperature, 233.15, 1e-9);
  EXPECT_NEAR(file.rows[3].temperature, 293.15, 1e-9);
}

/// Two isotherms side by side, in every form that spreadsheets give them.
TEST(DmaFile, SweepsSideBySideAreAllRead) {
  const std::string rows = "1,2,1,1.5,1\n2,3,1,2.5,1\n";
  const std::string ownRows = "1,2,1,1,1.5,1\n2,3,1,2,2.5,1\n";
  const std::string names = "f (Hz),G' (MPa),G'' (MPa),G' (MPa),G'' (MPa)\n";
  const std::string ownNames = "f (Hz),G' (MPa),G'' (MPa),f (Hz),G' (MPa),G'' (MPa)\n";
  const std::string forms[] = {
      "20 \u00B0C,,,30 \u00B0C,,\n" + ownNames + ownRows,
      "T=20C,,,T=30C,,\n" + ownNames + ownRows,
      "20 C,20 C,20 C,30 C,30 C,30 C\n" + ownNames + ownRows,
      ",20 \u00B0C,20 \u00B0C,30 \u00B0C,30 \u00B0C\n" + names + rows,
      ",20 \u00B0C,,30 \u00B0C,\n" + names + rows,
      "f,G',G'',G',G''\nHz,MPa,MPa,MPa,MPa\n,20 \u00B0C,20 \u00B0C,30 \u00B0C,30 \u00B0C\n" + rows,
      "f (Hz),G' (MPa) @ 20 C,G'' (MPa) @ 20 C,G' (MPa) @ 30 C,G'' (MPa) @ 30 C\n" + rows,
      "T (C),f (Hz),G' (MPa),G'' (MPa),T (C),f (Hz),G' (MPa),G'' (MPa)\n"
      "20,1,2,1,30,1,1.5,1\n20,2,3,1,30,2,2.5,1\n",
      "20 C,,,,30 C,,\nf (Hz),G' (MPa),G'' (MPa),,f (Hz),G' (MPa),G'' (MPa)\n"
      "1,2,1,,1,1.5,1\n2,3,1,,2,2.5,1\n",
      ",20 C,30 C,20 C,30 C\nf (Hz),G' (MPa),G' (MPa),G'' (MPa),G'' "
      "(MPa)\n1,2,1.5,1,1\n2,3,2.5,1,1\n",
  };
  for (const std::string& form : forms) {
    SCOPED_TRACE(form);
    const DmaFile file = read(form);
    ASSERT_EQ(file.rows.size(), 4U);
    expectRow(file.rows[0], 293.15, 1, 2e6, 1e6);
    expectRow(file.rows[1], 293.15, 2, 3e6, 1e6);
    expectRow(file.rows[2], 303.15, 1, 1.5e6, 1e6);
    expectRow(file.rows[3], 303.15, 2, 2.5e6, 1e6);
    EXPECT_EQ(file.facts.leftOut, 0U);
  }
}

/// The shorter one of two sweeps side by side ends with empty cells, which are no gaps.
TEST(DmaFile, SweepsSideBySideMayEndApart) {
  const DmaFile file = read(
      "20 C,,,30 C,,\nf (Hz),G' (MPa),G'' (MPa),f (Hz),G' (MPa),G'' (MPa)\n1,2,1,1,1.5,1\n"
      "2,3,1,2,2.5,1\n,,,3,2.6,1\n");
  EXPECT_EQ(file.rows.size(), 5U);
  EXPECT_EQ(file.facts.leftOut, 0U);
}

TEST(DmaFile, NoColumnOfModuliIsDroppedInSilence) {
  const std::string rows = "1,2,1,1.5,1\n2,3,1,2.5,1\n";
  const std::string names = "f (Hz),G' (MPa),G'' (MPa),G' (MPa),G'' (MPa)\n";
  EXPECT_THAT(errorOf(names + rows),
              HasSubstr("temperature: is not stated for each of the sweeps side by side in the "
                        "columns G' (2), G'' (3), G' (4), G'' (5)"));
  EXPECT_THAT(errorOf("0 C,10 C,20 C,,\n" + names + rows), HasSubstr("is not stated for each"));
  EXPECT_THAT(errorOf("f (Hz),T (C),G' (MPa),G'' (MPa),G' (MPa)\n1,20,2,1,3\n2,20,2,1,3\n"),
              HasSubstr("belong to no sweep with a frequency and both moduli: G' (5)"));
  // Whoever names the columns knows the others.
  DmaChoices choices;
  choices.storageColumn = "4";
  choices.lossColumn = "5";
  choices.temperature = 293.15;
  expectRow(read(names + rows, choices).rows[0], 293.15, 1, 1.5e6, 1e6);
}

/// What instruments write beside the moduli is none: viscosities, energies, compliances.
TEST(DmaFile, OtherQuantitiesAreNoModuli) {
  const DmaFile file = read(
      "f (Hz),T (C),eta'' (Pa s),G' (MPa),G'' (MPa),Loss energy (J),|G*| (MPa),J'' (1/Pa)\n"
      "1,20,9,2,1,7,2.2,8\n2,20,9,3,1,7,3.2,8\n");
  expectRow(file.rows[0], 293.15, 1, 2e6, 1e6);
}

TEST(DmaFile, StrainAmplitudeIsKept) {
  const DmaFile file =
      read("f (Hz),T (C),G' (Pa),G'' (Pa),strain (%)\n1,20,1e6,1e5,0.2\n2,20,1e6,1e5,0.2\n");
  EXPECT_NEAR(file.rows[0].strainAmplitude, 0.002, 1e-15);
}

TEST(DmaFile, AStrainHasAUnitOfStrain) {
  const auto strainIn = [](const std::string& unit) {
    return read("f (Hz),T (C),G' (Pa),G'' (Pa),strain [" + unit +
                "]\n1,20,1e6,1e5,2\n2,20,1e6,1e5,2\n");
  };
  EXPECT_NEAR(strainIn("mm/mm").rows[0].strainAmplitude, 2, 1e-15);
  EXPECT_NEAR(strainIn("\u2030").rows[0].strainAmplitude, 2e-3, 1e-15);
  EXPECT_NEAR(strainIn("\u00B5m/m").rows[0].strainAmplitude, 2e-6, 1e-15);
  // A displacement is no strain, but does not stand in the way of the moduli.
  for (const char* unit : {"mm", "foo"}) {
    const DmaFile file = strainIn(unit);
    EXPECT_TRUE(std::isnan(file.rows[0].strainAmplitude)) << unit;
    EXPECT_THAT(file.facts.leftOutColumns, HasSubstr("strain")) << unit;
  }
}

TEST(DmaFile, MissingValuesAreLeftOutAndCounted) {
  const DmaFile file =
      read("f (Hz);T (C);G' (Pa);G'' (Pa)\n1;20;1e6;1e5\n2;20;;1e5\n3;20;2e6;NaN\n4;20;2e6;1e5\n");
  EXPECT_EQ(file.rows.size(), 2U);
  EXPECT_EQ(file.facts.leftOut, 2U);
}

TEST(DmaFile, WordsAreNoTemperatures) {
  EXPECT_THAT(errorOf("f (Hz);G' (MPa);G'' (MPa);T (C)\n1;2;0.2;ok\n10;3;0.4;ok\n"),
              HasSubstr("T: has no number in any row"));
}

/// What stands in brackets after a modulus is its unit; one that is not known is refused, not
/// taken for pascals.
TEST(DmaFile, UnitsInBracketsAreKnownOrRefused) {
  const auto storageIn = [](const std::string& unit) {
    return read("f (Hz),T (C),G' " + unit + ",tan delta\n1,20,2,0.1\n10,20,3,0.1\n")
        .rows.front()
        .modulus.storage;
  };
  EXPECT_DOUBLE_EQ(storageIn("(MN/m\u00B2)"), 2e6);
  EXPECT_DOUBLE_EQ(storageIn("(kg/cm2)"), 2 * 98066.5);
  EXPECT_NEAR(storageIn("(ksi)"), 2 * 6894757.293168361, 1e-3);
  EXPECT_DOUBLE_EQ(storageIn("/MPa"), 2e6);
  for (const char* unit : {"(furlongs)", "[furlongs]", "/furlongs"})
    EXPECT_THAT(
        errorOf(std::string("f (Hz),T (C),G' ") + unit + ",tan delta\n1,20,2,0.1\n10,20,3,0.1\n"),
        HasSubstr("has the unit furlongs"))
        << unit;
}

/// The other column is a loss factor, which has no unit.
TEST(DmaFile, ALossModulusWithoutAUnitIsThatOfARubberToo) {
  EXPECT_THAT(errorOf("f (Hz),T (C),G'',tan delta\n1,20,0.2,0.1\n10,20,0.4,0.1\n"),
              HasSubstr("G'': has no unit, and 4 Pa would be no rubber; say --modulus-unit MPa"));
  EXPECT_EQ(read("f (Hz),T (C),G'',tan delta\n1,20,2e5,0.1\n10,20,4e5,0.1\n").rows.size(), 2U);
}

TEST(DmaFile, WhatIsWrongIsSaidInOneLine) {
  EXPECT_THAT(errorOf("f (Hz),T (K),G' (MPa),G'' (MPa)\n1,293,2,0.2\n10,3000,3,0.4\n"),
              HasSubstr("line 3: the temperature is 3000 K, at which no rubber is measured"));
  EXPECT_THAT(errorOf("f (Hz),T (C),G' (Pa),G'' (Pa)\n1,20,2.0e6x,2e5\n10,20,3.0e6x,4e5\n"),
              HasSubstr("G': line 2: '2.0e6x' is not a number"));
  const std::string rows = "1,20,2e6,2e5\n10,20,3e6,4e5\n";
  EXPECT_THAT(errorOf("a,b,c,d\n" + rows), HasSubstr("has no columns that are known"));
  EXPECT_THAT(errorOf("f (Hz),T (C),storage modulus (Pa),loss modulus (Pa)\n" + rows),
              HasSubstr("--modulus shear or --modulus tension"));
  EXPECT_THAT(errorOf("f (Hz),T (C),G' (Pa),E'' (Pa)\n" + rows), HasSubstr("one is of shear"));
  EXPECT_THAT(errorOf("f (Hz),T (C),G' (MPa),G''\n" + rows), HasSubstr("G'': has no unit"));
  EXPECT_THAT(errorOf("f (Hz),T (C),G' [furlong],G'' [furlong]\n" + rows),
              HasSubstr("has the unit furlong"));
  EXPECT_THAT(errorOf("f (Hz),T (C),G' (Pa),G'' (Pa)\n1,20,2e6,-1\n2,20,2e6,1\n"),
              HasSubstr("line 2: G'' is \u22121 Pa, which must be above 0"));
  // The number is that of the file, and not a third of it in Pa.
  EXPECT_THAT(errorOf("f (Hz),T (C),E' (MPa),E'' (MPa)\n1,20,-8.4653,1\n2,20,2,1\n"),
              HasSubstr("line 2: E' is \u22128.4653 MPa, which must be above 0"));
  EXPECT_THAT(errorOf("f (Hz),T (C),G' (Pa),tan d\n1,20,2e6,-1\n2,20,2e6,1\n"),
              HasSubstr("line 2: the loss modulus is -2000000, which must be above 0"));
  EXPECT_THAT(errorOf("f (Hz),T (C),G' (Pa),G'' (Pa)\n0,20,2e6,1\n2,20,2e6,1\n"),
              HasSubstr("the frequency is 0"));
  EXPECT_THAT(errorOf("f (Hz),T (C),G' (Pa),G'' (Pa)\n1,20,2e6,1\n2,-300,2e6,1\n"),
              HasSubstr("the temperature in K is -26.85, which"));
  EXPECT_THAT(errorOf("f (Hz),T,G' (Pa),G'' (Pa)\n1,20,2e6,1\n2,300,2e6,1\n"), HasSubstr("mixed"));
  EXPECT_THAT(errorOf("f (Hz),G' (Pa),G'' (Pa)\n1,2e6,1\n2,2e6,1\n"), HasSubstr("--temperature"));
  EXPECT_THAT(errorOf("f,T,G',G''\n1,20,2,1\n2,20,2,1\n"), HasSubstr("--modulus-unit MPa"));
}

/// Kelvins under the name of degrees made isotherms from 263 to 313 \u00B0C in silence.
TEST(DmaFile, DegreesThatLookLikeKelvinsAreSaid) {
  const std::string rows = "1,263,2e6,2e5\n10,263,3e6,4e5\n1,313,1e6,2e5\n10,313,2e6,4e5\n";
  const std::string table = "f (Hz),T (\u00B0C),G' (Pa),G'' (Pa)\n" + rows;
  EXPECT_THAT(read(table).facts.notes.at(0).english(),
              HasSubstr("T runs from 263 to 313 \u00B0C, where most rubbers are destroyed"));
  DmaChoices choices;
  choices.temperatureUnit = "K";
  EXPECT_TRUE(read(table, choices).facts.notes.empty());
  EXPECT_TRUE(read("f (Hz),T (K),G' (Pa),G'' (Pa)\n" + rows).facts.notes.empty());
}

/// t before T was taken for the temperature.
TEST(DmaFile, ATimeIsNoTemperature) {
  for (const std::string header :
       {"t (s),T (\u00B0C),f (Hz),G' (Pa),G'' (Pa)\n", "t [min],T [C],f [Hz],G' [Pa],G'' [Pa]\n",
        "t,T,f,G',G''\n", "t,T,f,G',G''\ns,\u00B0C,Hz,Pa,Pa\n"})
    for (const std::string chosen : {"", "T"}) {
      DmaChoices choices;
      choices.temperatureColumn = chosen;
      const DmaFile file = read(header + "30,20,1,2e6,2e5\n60,20,10,3e6,4e5\n", choices);
      ASSERT_EQ(file.rows.size(), 2U) << header;
      expectRow(file.rows[1], 293.15, 10, 3e6, 4e5);
    }
  // Alone it is one.
  expectRow(read("t,f (Hz),G' (Pa),G'' (Pa)\n20,1,2e6,2e5\n20,10,3e6,4e5\n").rows[0], 293.15, 1,
            2e6, 2e5);
}

TEST(DmaFile, ARowOfTemperaturesMayHaveOneUnit) {
  for (const std::string row :
       {"T / \u00B0C;20;;30;", "T / \u00B0C;20;20;30;30", "T (K);293.15;;303.15;",
        "Temperature;20;;30;", "T / \u00B0C;20,0;;30,0;"}) {
    const DmaFile file = read(row +
                              "\nf / Hz;G' / MPa;G'' / MPa;G' / MPa;G'' / MPa\n1;2;1;1.5;1\n"
                              "2;3;1;2.5;1\n");
    ASSERT_EQ(file.rows.size(), 4U) << row;
    expectRow(file.rows[3], 303.15, 2, 2.5e6, 1e6);
  }
}

/// A table with f, T and f aT was refused for want of the temperature of a master curve.
TEST(DmaFile, ReducedFrequenciesBesideIsothermsAreNotRead) {
  const DmaFile file = read(
      "T (\u00B0C),f (Hz),aT,f*aT (Hz),G' (Pa),G'' (Pa)\n10,1,5,5,2e6,2e5\n10,10,5,50,3e6,4e5\n"
      "20,1,1,1,1e6,2e5\n20,10,1,10,2e6,4e5\n");
  ASSERT_EQ(file.rows.size(), 4U);
  expectRow(file.rows[1], 283.15, 10, 3e6, 4e5);
  EXPECT_FALSE(file.facts.isReduced);
  EXPECT_THAT(file.facts.notes.at(0).english(), HasSubstr("the isotherms have their own"));
}

TEST(DmaFile, StiffnessesAndTorquesAreNoModuli) {
  expectRow(read("T (C),f (Hz),K' (N/m),K\" (N/m),E' (Pa),E\" (Pa)\n20,1,9,9,6e6,6e5\n"
                 "20,10,9,9,9e6,1.2e6\n")
                .rows.at(1),
            293.15, 10, 3e6, 4e5);
  const DmaFile rpa = read(
      "Temp [\u00B0C],Freq [cpm],S' [dNm],S'' [dNm],G' [kPa],G'' [kPa]\n20,60,9,9,2000,200\n"
      "20,600,9,9,3000,400\n");
  expectRow(rpa.rows.at(1), 293.15, 10, 3e6, 4e5);
  // Alone, their unit is refused.
  EXPECT_THAT(errorOf("T (C),f (Hz),G' (N/m),G'' (N/m)\n20,1,9,9\n20,10,9,9\n"),
              HasSubstr("has the unit N/m"));
}

/// Names of text with blanks: a drawn line below them, or units without one for the row number.
TEST(DmaFile, TablesWithBlanksKeepTheirNames) {
  const std::string rows = "   1    20.0   1.0   2e6   2e5\n   2    20.0  10.0   3e6   4e5\n";
  const std::string names = "   N    Temp  Freq    G'   G''\n";
  const std::string units = "           C    Hz    Pa    Pa\n";
  for (const std::string& head :
       {names + "-----------------------------\n", names + units, names + units + "=====\n"}) {
    const DmaFile file = read(head + rows);
    ASSERT_EQ(file.rows.size(), 2U) << head;
    expectRow(file.rows[1], 293.15, 10, 3e6, 4e5);
  }
  // The unit may be missing of another column.
  EXPECT_THAT(errorOf("   Freq   Temp   G'   G''  tand\n     Hz      C   Pa    Pa\n"
                      " 1  20  2e6  2e5  0.1\n 10  20  3e6  4e5  0.13\n"),
              HasSubstr("has no columns that are known"));
}

/// The rest of the brackets stood in the name.
TEST(DmaFile, LogarithmsHaveNamesWithoutBrackets) {
  const DmaFile file =
      read("T (C),log10(\u03C9/(rad/s)),lg(G'/MPa),lg(G''/MPa)\n20,0,0.3,-0.7\n20,1,0.5,-0.4\n");
  EXPECT_EQ(file.facts.frequency.name, "\u03C9");
  EXPECT_EQ(file.facts.frequency.unit, "rad/s");
}

/// Deviations of a modulus are no modulus; averaged into it they would halve it and more.
TEST(DmaFile, ColumnsOfDeviationsAreLeftOutByName) {
  for (const std::string deviation :
       {"G' std (MPa)", "std G' (MPa)", "G' SD (MPa)", "u(G') (MPa)", "\u0394G' (MPa)",
        "s(G') (MPa)", "G'_err (MPa)", "G' \u00B1 (MPa)", "G' uncertainty (MPa)", "G' stderr (MPa)",
        "sigma G' (MPa)", "\u03C3(G') (MPa)", "G' 95% CI (MPa)", "G' min (MPa)", "G' max (MPa)",
        "G' (MPa) std", "G' error (MPa)", "stdev G' (MPa)"}) {
    SCOPED_TRACE(deviation);
    for (const bool isFirst : {false, true}) {
      const DmaFile file = isFirst ? read("f (Hz),T (C)," + deviation +
                                          ",G' (MPa),G'' (MPa)\n1,20,0.9,2,0.2\n10,20,0.9,3,0.4\n")
                                   : read("f (Hz),T (C),G' (MPa)," + deviation +
                                          ",G'' (MPa)\n1,20,2,0.9,0.2\n10,20,3,0.9,0.4\n");
      ASSERT_EQ(file.rows.size(), 2U);
      expectRow(file.rows[0], 293.15, 1, 2e6, 2e5);
      expectRow(file.rows[1], 293.15, 10, 3e6, 4e5);
      EXPECT_FALSE(file.facts.leftOutColumns.empty());
    }
  }
}

/// Words beside a modulus that are not understood are asked about.
TEST(DmaFile, UnclearColumnsOfModuliAreRefused) {
  const std::string rows = "1,20,2,0.2,3\n10,20,3,0.4,4\n";
  for (const std::string other : {"G' fit", "G' raw", "G' mean", "G' at 10 % strain", "G'.1"})
    EXPECT_THAT(errorOf("f (Hz),T (C),G' (MPa),G'' (MPa)," + other + " (MPa)\n" + rows),
                HasSubstr("seem to be the same quantity"))
        << other;
  EXPECT_THAT(errorOf("f (Hz),T (C),G' fit (MPa),G'' (MPa),x\n" + rows),
              HasSubstr("G' fit: 'fit' is not understood beside the name of a modulus"));
  DmaChoices choices;
  choices.storageColumn = "3";
  expectRow(read("f (Hz),T (C),G' fit (MPa),G'' (MPa),x\n" + rows, choices).rows[0], 293.15, 1, 2e6,
            2e5);
  expectRow(read("f (Hz),T (C),G' mean (MPa),G'' mean (MPa),x\n" + rows).rows[0], 293.15, 1, 2e6,
            2e5);
}

TEST(DmaFile, LossFactorsAreRatiosOrPerCent) {
  for (const std::string name : {"tan delta (%)", "loss factor (%)", "tan delta [%]"})
    expectRow(read("f (Hz),T (C),G' (MPa)," + name + "\n1,20,2,5\n10,20,2,10\n").rows[0], 293.15, 1,
              2e6, 1e5);
  for (const std::string name : {"tan delta (x1000)", "1000 tan delta", "tan delta (deg)"})
    EXPECT_FALSE(errorOf("f (Hz),T (C),G' (MPa)," + name + "\n1,20,2,5\n10,20,2,10\n").empty())
        << name;
  EXPECT_THAT(errorOf("f (Hz),T (C),G* (MPa),phase (turns)\n1,20,2,5\n10,20,2,10\n"),
              HasSubstr("an angle is in rad or deg"));
}

TEST(DmaFile, TheSamplesTemperatureIsTaken) {
  const DmaFile file = read(
      "Set temperature (C),Sample temperature (C),f (Hz),G' (MPa),G'' (MPa)\n"
      "10,20,1,2,0.2\n10,20,10,3,0.4\n");
  expectRow(file.rows[0], 293.15, 1, 2e6, 2e5);
  EXPECT_EQ(file.facts.temperature.name, "Sample temperature");
  EXPECT_EQ(file.facts.leftOutColumns, "Set temperature");
  EXPECT_THAT(errorOf("Temperature (C),Room temperature (C),f (Hz),G' (MPa),G'' (MPa)\n"
                      "10,20,1,2,0.2\n10,20,10,3,0.4\n"),
              HasSubstr("seem to be the same quantity"));
}

std::vector<std::string> factsIn(const std::string& text, const DmaChoices& choices = {}) {
  std::vector<std::string> facts;
  for (const Message& fact : factsOf(read(text, choices).facts)) facts.push_back(fact.english());
  return facts;
}

TEST(DmaFile, TheFactsNameColumnsUnitsAndKind) {
  using testing::ElementsAre;
  EXPECT_THAT(factsIn("f (Hz),T (K),E' (MPa),tan delta\n1,293,2,0.1\n10,293,3,0.1\n"),
              ElementsAre("frequency: f in Hz", "temperature: T in K",
                          "moduli of tension: E' in MPa, tan delta"));
  EXPECT_THAT(factsIn("f (Hz),T (K),G* (MPa),phase\n1,293,2,10\n10,293,3,12\n"),
              testing::Contains("moduli of shear: G* in MPa, phase in deg (assumed)"));
  DmaChoices megapascals;
  megapascals.modulusUnit = "MPa";
  EXPECT_THAT(
      factsIn("omega,T,G1,G2\n1,20,2,0.2\n10,20,3,0.4\n", megapascals),
      ElementsAre("frequency: omega in rad/s (assumed)", "temperature: T in \u00B0C (assumed)",
                  "moduli of shear: G1 in MPa, G2 in MPa"));
  EXPECT_THAT(factsIn("Tref = 20 C\naT*f (Hz),G',G''\n1,2e6,2e5\n10,3e6,4e5\n"),
              ElementsAre("reduced frequency: aT*f in Hz",
                          "temperature: 20.0 \u00B0"
                          "C (line 1: Tref = 20 C)",
                          "moduli of shear: G' in Pa (assumed), G'' in Pa (assumed)"));
  const std::string block = "C\nf (Hz),G' (MPa),G'' (MPa)\n1,2,0.2\n10,3,0.4\n\n";
  EXPECT_EQ(factsIn("T = 20 " + block + "T = 30 " + block).size(), 2U);
  EXPECT_THAT(
      factsIn("T = 20 " + block + "T = 30 C\nf (Hz),G' (Pa),G'' (Pa)\n1,2e6,2e5\n10,3e6,4e5\n"),
      testing::Contains("these are the columns of the last of 2 sweeps"));
}

/// Beside a unit of moduli that a user chose, viscosities and compliances have units of their own.
TEST(DmaFile, AChosenUnitOfModuliIsThatOfOtherFormsToo) {
  DmaChoices newtons;
  newtons.modulusUnit = "N/mm2";
  const std::string viscosities = "omega (rad/s),T (C),eta',eta''\n10,20,0.2,2\n20,20,0.4,3\n";
  expectRow(read(viscosities, newtons).rows[0], 293.15, 10 / (2 * std::numbers::pi), 20e6, 2e6);
  EXPECT_THAT(factsIn(viscosities, newtons), testing::Contains(HasSubstr("eta' in N/mm2 s")));
  const std::string compliances = "f (Hz),T (C),J',J''\n1,20,0.4,0.2\n2,20,0.3,0.2\n";
  expectRow(read(compliances, newtons).rows[0], 293.15, 1, 2e6, 1e6);  // J'/|J|^2, J''/|J|^2
  EXPECT_THAT(factsIn(compliances, newtons), testing::Contains(HasSubstr("J' in 1/(N/mm2)")));
}

TEST(DmaFile, ColumnsThatContradictEachOtherAreSaid) {
  const auto tangent = [](const std::string& first, const std::string& second) {
    return factsIn("f (Hz),T (C),G' (MPa),G'' (MPa),tan d\n1,20,2,0.2," + first + "\n10,20,3,0.6," +
                   second + "\n");
  };
  EXPECT_EQ(tangent("0.101", "0.199").size(), 3U);
  EXPECT_THAT(tangent("0.2", "0.4"),
              testing::Contains("tan d contradicts the moduli: in the median it is 2 times the "
                                "ratio of G'' and G'; the moduli are read"));
  EXPECT_EQ(tangent("", "0").size(), 3U);
  EXPECT_EQ(factsIn("f (Hz),T (C),E' (MPa),E'' (MPa),G' (MPa),G'' (MPa)\n1,20,0,1,2,0.2\n"
                    "10,20,,1,3,0.6\n")
                .size(),
            3U);
  const std::string both =
      "f (Hz),T (C),E' (MPa),E'' (MPa),G' (kPa),G'' (kPa)\n1,20,6,1,3000,500\n10,20,7,1,3500,600\n";
  EXPECT_THAT(
      factsIn(both),
      testing::Contains("the table also has moduli of tension, 2 times those of shear in the "
                        "median (3 with this Poisson's ratio); those of shear are read, and "
                        "--modulus tension reads the others"));
  DmaChoices tension;
  tension.modulus = ModulusKind::Tension;
  EXPECT_THAT(factsIn(both, tension),
              testing::Contains(HasSubstr("those of tension are 2 times as large in the median")));
}

/// Moduli of tension depend on Poisson's ratio: one that the file states is not passed over.
TEST(DmaFile, AnotherPoissonsRatioInTheTextIsNamed) {
  const std::string rows = "f (Hz),T (C),E' (MPa),E'' (MPa)\n1,20,6,1\n10,20,7,1\n";
  const std::string said = "states a Poisson's ratio of 0.48, and 0.5 is used";
  for (const std::string line : {"Poisson's ratio: 0.48", "Poisson ratio = 0.48", "\u03BD = 0.48",
                                 "Querkontraktionszahl: 0,48", "Sample: NR; nu = 0.48"})
    EXPECT_THAT(factsIn("# " + line + "\n" + rows), testing::Contains(HasSubstr(said))) << line;
  const std::string stated = "# Poisson's ratio: 0.48\n" + rows;
  DmaChoices same;
  same.poissonRatio = 0.48;
  EXPECT_THAT(factsIn(stated, same),
              testing::Not(testing::Contains(HasSubstr("Poisson's ratio of"))));
  EXPECT_THAT(factsIn("# Poisson's ratio: 0.48\nf (Hz),T (C),G' (MPa),G'' (MPa)\n1,20,2,1\n"
                      "10,20,3,1\n"),
              testing::Not(testing::Contains(HasSubstr("Poisson's ratio of"))));
}

/// A mean of two rubbers is no rubber.
TEST(DmaFile, SeveralSamplesInOneTableAreRefused) {
  const auto table = [](const std::string& name, const std::string& one, const std::string& other,
                        double factor) {
    std::string text = name + "T (C),f (Hz),G' (MPa),G'' (MPa)\n";
    for (const std::string& label : {one, other})
      for (const double frequency : {1, 3, 10})
        text += label + "20," + std::to_string(frequency) + "," +
                std::to_string((label == one ? 1 : factor) * (2 + frequency)) + "," +
                std::to_string((label == one ? 1 : factor) * 0.3) + "\n";
    return text;
  };
  EXPECT_THAT(
      errorOf(table("Sample,", "A,", "B,", 3)),
      HasSubstr("dma.csv: Sample: tells samples or runs apart, A in line 2 and B in line 5, "
                "whose moduli at the same temperature and frequency differ by a factor of "
                "3"));
  EXPECT_THAT(errorOf(table("No,", "1,", "2,", 3)), HasSubstr("No: tells samples or runs apart"));
  // A heating and a cooling run, without a column that says so.
  std::string runs = "T (C),f (Hz),G' (MPa),G'' (MPa)\n";
  for (const std::string row : {"20,1,2,0.2\n20,10,3,0.3\n", "20,10,3.9,0.39\n20,1,2.6,0.26\n"})
    runs += row;
  EXPECT_THAT(errorOf(runs), HasSubstr("as in lines 2 and 5, by a factor of 1.3"));
  EXPECT_EQ(read(table("Sample,", "A,", "B,", 1.1)).rows.size(), 6U);
  // Two strains are chosen from later.
  EXPECT_EQ(read(table("Strain (%),", "0.1,", "10,", 0.5)).rows.size(), 6U);
}

/// A temperature beside a duration or a word that may be about a treatment, in any language.
TEST(DmaFile, TheTemperatureOfAPreparationIsNotThatOfTheTest) {
  const std::string table = "f (Hz),G' (Pa),G'' (Pa)\n1,2e6,2e5\n10,3e6,4e5\n";
  for (const std::string line :
       {"Conditioned at 40 \u00B0C for 24 h", "Preheated to 60 \u00B0C",
        "Swollen in toluene at 40 \u00B0C", "Vieilli 168 h \u00E0 70 \u00B0C",
        "Recuit 2 h \u00E0 90 \u00B0C", "Traitement thermique : 90 \u00B0C",
        "Invecchiato 70 h a 100 \u00B0C", "Envejecido 72 h a 70 \u00B0C",
        "\u8001\u5316 70 \u2103 168 h", "Laboratory 23 \u00B0C", "Swelling temperature: 40 \u00B0C",
        "Temp\u00E9rature de vieillissement : 70 \u00B0C", "Tested after 24 h at 40 \u00B0C",
        "Test piece swollen at 40 \u00B0C", "Aged 168 h, T = 20 \u00B0C"})
    EXPECT_THAT(errorOf("# " + line + "\n" + table),
                testing::AllOf(HasSubstr("temperature: is stated nowhere"),
                               HasSubstr("(line 1 may be about something else: ")))
        << line;
  EXPECT_NEAR(read("Vieilli 168 h \u00E0 70 \u00B0C, essai \u00E0 20 \u00B0C\n" + table)
                  .rows.front()
                  .temperature,
              293.15, 1e-9);
}

TEST(DmaFile, ColumnsOfOtherLanguagesAreKnown) {
  for (const std::string names :
       {"Temp\u00E9rature (\u00B0C);Fr\u00E9quence (Hz);Module de conservation E' (MPa);Module de "
        "perte E'' (MPa)",
        "\u6E29\u5EA6(\u2103);\u5468\u6CE2\u6570(Hz);\u8CAF\u8535\u5F3E\u6027\u7387E'(MPa);"
        "\u640D\u5931\u5F3E\u6027\u7387E''(MPa)",
        "Temperatura (\u00B0C);Frequenza (Hz);Modulo conservativo E' (MPa);Modulo di perdita E'' "
        "(MPa)",
        "Temperatura (\u00B0C);Frecuencia (Hz);M\u00F3dulo de almacenamiento E' (MPa);M\u00F3dulo "
        "de p\u00E9rdida E'' (MPa)",
        "Temperatura (\u00B0C);Frequenza (Hz);Modulo conservativo (MPa);Modulo dissipativo (MPa)",
        "Temperatura (\u00B0C);Frecuencia (Hz);M\u00F3dulo el\u00E1stico (MPa);M\u00F3dulo viscoso "
        "(MPa)",
        "T (\u00B0C);f (Hz);E' (10^6 Pa);E'' (10^6 Pa)"}) {
    SCOPED_TRACE(names);
    DmaChoices tension;
    tension.modulus = ModulusKind::Tension;
    const DmaFile file = read(names + "\n20;1;6;0.6\n20;10;9;1.2\n", tension);
    expectRow(file.rows[0], 293.15, 1, 2e6, 2e5);
    expectRow(file.rows[1], 293.15, 10, 3e6, 4e5);
  }
}

/// RheoCompass writes an empty row between names and units, and Mettler the temperature of the
/// sample as Ts.
TEST(DmaFile, InstrumentsHaveHeadersOfTheirOwn) {
  const DmaFile anton = read(
      "Ergebnis:;FS 1\nIntervalldaten:;Messpunkt;Temperatur;Kreisfrequenz;Speichermodul "
      "G\u2032;Verlustmodul G\u2033;Verlustfaktor\n;;;;;;\n;;[\u00B0C];[rad/s];[kPa];[kPa];[1]\n"
      ";1;20,00;6,5;2000;400;0,2\n;2;20,00;65,0;3000;900;0,3\n");
  ASSERT_EQ(anton.rows.size(), 2u);
  expectRow(anton.rows[1], 293.15, 65 / (2 * std::numbers::pi), 3e6, 9e5);
  const DmaFile mettler = read(
      "Curve Values:\n  Index   t      Ts     Tr      f      G'     G''   tan\n"
      "          [s]    [\u00B0C]   [\u00B0C]   [Hz]   [MPa]   [MPa]   []\n"
      "   0     1.0   20.0   20.4   1.0   2.0   0.4   0.2\n"
      "   1     2.0   20.0   20.4   10.0  3.0   0.9   0.3\n");
  ASSERT_EQ(mettler.rows.size(), 2u);
  expectRow(mettler.rows[1], 293.15, 10, 3e6, 9e5);
}

/// Merged cells of a spreadsheet are empty but for the first one.
TEST(DmaFile, ATemperatureMayStandInTheFirstRowOfASweepAlone) {
  const std::string names = "T (C);f (Hz);G' (MPa);G'' (MPa)\n";
  const DmaFile file = read(names + "20;1;2;0,4\n;10;3;0,5\n;100;4;0,6\n40;1;1;0,2\n;10;2;0,3\n");
  ASSERT_EQ(file.rows.size(), 5u);
  expectRow(file.rows[2], 293.15, 100, 4e6, 6e5);
  expectRow(file.rows[4], 313.15, 10, 2e6, 3e5);
  EXPECT_EQ(file.facts.notes.back().english(),
            "T stands in the first row of each group alone: it holds for the rows below it");
  // One that is missing among others is that of no other row.
  const DmaFile lost = read(names + "20;1;2;0,4\n;10;3;0,5\n20;100;4;0,6\n40;1;1;0,2\n");
  EXPECT_EQ(lost.rows.size(), 3u);
  EXPECT_EQ(lost.facts.leftOut, 1u);
}

/// A unit that stands beside the columns is not passed over: it would change the numbers.
TEST(DmaFile, AUnitThatStandsElsewhereIsAskedFor) {
  const std::string rows = "20,1,2.5e6,5e5\n20,10,3.5e6,9e5\n", names = "T (C),f,G',G''\n";
  for (const char* line : {"f in rad/s", "All frequencies in rad s-1", "Angular frequency sweep",
                           "Frequency unit: rad/s", "# f in rad/s, G' and G'' in Pa, T in C"})
    EXPECT_THAT(errorOf(line + ("\n" + names) + rows),
                HasSubstr("f: has no unit, and line 1 names "))
        << line;
  EXPECT_THAT(errorOf(names + rows + "f in rad/s\n"), HasSubstr("line 4 names 'rad/s'"));
  EXPECT_THAT(errorOf("moduli in kPa\n" + names + rows),
              HasSubstr("G': has no unit, and line 1 names 'kPa'; --modulus-unit says"));
  DmaChoices choices;
  choices.frequencyUnit = "Hz";
  EXPECT_EQ(read("f in rad/s\n" + names + rows, choices).rows.size(), 2u);
  for (const char* line :
       {"f in Hz", "moduli in Pa", "Strain rate 20 rad/s", "Geometry: torsion rectangular",
        "Plates of radius 4 mm", "Radial clamps", "Sample: bar"})
    EXPECT_EQ(read(line + ("\n" + names) + rows).rows.size(), 2u) << line;
}

/// A row that cannot be read is not lost in silence, also where another block follows.
TEST(DmaFile, DamagedRowsBelowABlockAreSaid) {
  const std::string names = "f (Hz);G' (MPa);G'' (MPa)\n", good = "1;2;0,4\n10;3;0,5\n";
  const DmaFile file = read("T = 20 C\n" + names + good + "100;4;<1\n\nT = 40 C\n" + names + good);
  EXPECT_EQ(file.rows.size(), 4u);
  EXPECT_EQ(file.facts.notes.back().english(),
            "Line 5 is left out: it begins with a number but is not a row of the table.");
}

/// A header in pascals above numbers in megapascals is a common slip.
TEST(DmaFile, ModuliOfNoRubberAreSaid) {
  const auto lastNote = [](const std::string& unit) {
    const DmaFile file =
        read("T (C),f (Hz),G' (" + unit + "),G'' (" + unit + ")\n20,1,2.5,0.5\n20,10,3.5,0.9\n");
    return file.facts.notes.empty() ? std::string() : file.facts.notes.back().english();
  };
  EXPECT_EQ(lastNote("Pa"),
            "the moduli are at most 3.5 Pa, which is softer than any rubber: where the file states "
            "a wrong unit, --modulus-unit replaces it");
  EXPECT_THAT(lastNote("TPa"), HasSubstr("the moduli are at least 2.5e+12 Pa, which is stiffer"));
  EXPECT_EQ(lastNote("MPa"), "");
  EXPECT_EQ(lastNote("kPa"), "");
}

TEST(DmaFile, TheGeometrySaysTheKindOfModuli) {
  const std::string table =
      "Temperature\tFrequency\tStorage modulus\tLoss modulus\n\u00B0C\tHz\tMPa\tMPa\n"
      "20\t1\t6\t0.6\n20\t10\t9\t1.2\n";
  const DmaFile film = read("Sample\tNR\nGeometry\tTension: Film\n" + table);
  expectRow(film.rows[0], 293.15, 1, 2e6, 2e5);
  EXPECT_EQ(film.facts.notes.front().english(),
            "line 2 says of which kind the moduli are: Geometry Tension: Film");
  for (const char* line :
       {"Geometry\tParallel plate", "Test mode: shear", "Beanspruchungsart: Doppelscherung"})
    expectRow(read(std::string(line) + "\n" + table).rows[0], 293.15, 1, 6e6, 6e5);
  expectRow(read("Deformation mode: Tension\n" + table).rows[0], 293.15, 1, 2e6, 2e5);
  EXPECT_THAT(errorOf("Mode: frequency sweep\n" + table), HasSubstr("may be of shear (G)"));
}

/// What a program writes about the shift of its master curve.
TEST(DmaFile, TheShiftBesideAMasterCurveIsRead) {
  const std::string curve = "f (Hz);G' (Pa);G'' (Pa)\n1;2e6;2e5\n10;3e6;4e5\n100;4e6;6e5\n";
  const std::string head = "Master curve, Tref = 20 \u00B0C\n";
  for (const std::string constants :
       {"WLF C1 = 10\nWLF C2 = 120 K\n", "WLF C1 = 10, C2 = 120 K\n", "C_1: 10\nC_2: 120\n",
        "WLF C1 = 10 C2 = 120 K\n", "WLF C1=10 C2 (K) = 120\n", "WLF C1=10 C2=120 Tref 20 C\n",
        "WLF C1 = 10 C2 = 120 K Tref=20C\n"}) {
    const DmaFile file = read(head + constants + curve);
    ASSERT_TRUE(file.shift.has_value()) << constants;
    EXPECT_EQ(*file.shift, (TemperatureShift{10, 120, 293.15}));
    EXPECT_THAT(factsIn(head + constants + curve), testing::Contains(HasSubstr("C1 = 10")));
  }
  // Constants of another temperature than the curve's: 60 C + 120 K - 20 C.
  const std::string reduced = "aT*f (Hz);G' (Pa);G'' (Pa)\n1;2e6;2e5\n10;3e6;4e5\n100;4e6;6e5\n";
  for (const std::string constants :
       {"WLF: Tref = 20 \u00B0C; C1 = 10; C2 = 120 K\n",
        "WLF C1 = 10 C2 = 120 K Tref = 20 \u00B0C\n", "WLF C1=10 C2=120 Tref 20 C\n",
        "WLF Tref=20C C1=10 C2=120\n", "WLF: C1 = 10, C2 = 120 K, Tref = 20 \u00B0C\n",
        "WLF fit: C1 = 10 ; C2 = 120 K ; T0 = 20 \u00B0C\n",
        "WLF Tref = 20 \u00B0C; WLF C1 = 10; WLF C2 = 120 K\n",
        "WLF reference temperature: 20 \u00B0C\nC1 = 10\nC2 (K): 120\n",
        "WLF parameters (Tref = 20 \u00B0C):\nC1 = 10\nC2 = 120\n",
        "WLF parameters, Tref = 20 \u00B0C:\nC1 = 10\nC2 = 120\n",
        "WLF at 20 \u00B0C: C1 = 10, C2 = 120 K\n",
        "WLF (C1 = 10, C2 = 120 K) at 20 \u00B0C\nC1 = 10\n",
        "T_WLF = 20 \u00B0C\nC1 = 10\nC2 = 120\n",
        "WLF Tref [\u00B0C]: 20\nWLF C1: 10\nWLF C2: 120\n"}) {
    const DmaFile file = read("Master curve at 60 \u00B0C\n" + constants + reduced);
    ASSERT_TRUE(file.shift.has_value()) << constants;
    EXPECT_NEAR(file.shift->c1, 7.5, 1e-9) << constants;
    EXPECT_NEAR(file.shift->c2, 160, 1e-9) << constants;
    EXPECT_NEAR(file.shift->referenceTemperature, 333.15, 1e-9) << constants;
  }
  // The universal constants are those of the glass transition: 20 C + 51.6 K + 50 C.
  for (const std::string constants :
       {"WLF (Tg = -50 \u00B0C): C1 = 17.44; C2 = 51.6\n",
        "WLF at Tg = -50 \u00B0C: C1 = 17.44, C2 = 51.6\n",
        "C1: 17.44\nC2: 51.6\nReference temperature of WLF: -50 \u00B0C\n",
        "WLF C1: 17.44\nWLF C2: 51.6 K\nTg: -50 \u00B0C\n"})
    for (const std::string curveAt :
         {"Master curve at 20 \u00B0C\n", "Master curve, T = 20 \u00B0C\n"}) {
      const DmaFile file = read(curveAt + constants + reduced);
      ASSERT_TRUE(file.shift.has_value()) << constants;
      EXPECT_NEAR(file.shift->c2, 121.6, 1e-9) << constants;
      EXPECT_NEAR(file.shift->c1, 17.44 * 51.6 / 121.6, 1e-9) << constants;
    }
  // Other constants are not: the curve's temperature is theirs, which is said.
  const std::string other =
      "Master curve at 20 \u00B0C\nTg: -50 \u00B0C\nC1 = 10\nC2 = 120\n" + reduced;
  EXPECT_EQ(read(other).shift->c2, 120);
  EXPECT_THAT(factsIn(other), testing::Contains(HasSubstr("no reference temperature is stated")));
  // Degrees Fahrenheit are smaller.
  const DmaFile fahrenheit = read("Tref = 68 \u00B0F; WLF: C1 = 8, C2 = 216 \u00B0F\n" + curve);
  EXPECT_NEAR(fahrenheit.shift->c2, 120, 1e-9);
  EXPECT_THAT(errorOf(head + "C1 = 8\nC2 = 120 MPa\n" + curve),
              HasSubstr("WLF: C2 has the unit MPa, which is none of a difference"));
  // All in one line, with the separator of the rows.
  const std::string commas = "f (Hz),G' (Pa),G'' (Pa)\n1,2e6,2e5\n10,3e6,4e5\n100,4e6,6e5\n";
  const DmaFile line = read("# Master curve, Tref = 20 \u00B0C, WLF C1 = 8, C2 = 120 K\n" + commas);
  ASSERT_TRUE(line.shift.has_value());
  EXPECT_EQ(*line.shift, (TemperatureShift{8, 120, 293.15}));
  for (const std::string energy :
       {"# Master curve, Tref = 20 \u00B0C, Arrhenius Ea = 100 kJ/mol\n",
        "# Reference temperature: 20 \u00B0C\n# Activation energy: 23.9005736 kcal/mol\n"}) {
    const DmaFile arrhenius = read(energy + commas);
    ASSERT_TRUE(arrhenius.shift.has_value()) << energy;
    EXPECT_EQ(arrhenius.shift->kind, ShiftKind::Arrhenius);
    EXPECT_NEAR(arrhenius.shift->activationEnergy, 1e5, 0.1);
    EXPECT_NEAR(arrhenius.shift->referenceTemperature, 293.15, 1e-9);
  }
  EXPECT_THAT(factsIn(head + "ln aT form: C1 = 23.03, C2 = 120\n" + curve),
              testing::Contains(HasSubstr("not read: line 2 is about ln aT")));
  for (const std::string formula :
       {"ln(aT) = -C1 (T - Tref) / (C2 + T - Tref)", "aT = exp(-C1*(T-Tref)/(C2+T-Tref))"}) {
    const DmaFile natural = read(head + "# " + formula + "\n# C1 = 23.03\n# C2 = 120 K\n" + curve);
    EXPECT_FALSE(natural.shift.has_value()) << formula;
  }
  EXPECT_TRUE(read(head +
                   "# log10(aT) = -C1 (T - Tref) / (C2 + T - Tref)\n# C1 = 10\n# C2 = 120 K\n" +
                   curve)
                  .shift.has_value());
  // The same curve from 50 C on.
  const DmaFile apart = read("Temperature: 50 C\n" + head + "C1 = 10\nC2 = 120\n" + curve);
  EXPECT_NEAR(apart.shift->c2, 150, 1e-9);
  EXPECT_NEAR(apart.shift->c1, 8, 1e-9);
  EXPECT_THAT(errorOf(head + "C1 = -10\nC2 = 120\n" + curve), HasSubstr("WLF: C1 is -10"));

  const std::string table = head + curve + "\nShift factors\n";
  for (const std::string rows :
       {"T [\u00B0C];log aT\n50;-2\n20;0\n-40;10\n",
        "T (K);log10(a_T)\n323.15;-2\n293.15;0\n233.15;10\n", "T;aT\n-40;1e10\n20;1\n50;0.01\n",
        "Temperature (C);ln aT\n-40;23.02585092994046\n20;0\n50;-4.605170185988092\n"}) {
    const DmaFile file = read(table + rows);
    ASSERT_TRUE(file.shift.has_value()) << rows;
    ASSERT_EQ(file.shift->table.size(), 3U);
    EXPECT_NEAR(file.shift->table.front().log10Shift, 10, 1e-9);
    EXPECT_EQ(file.shift->table[1], (ShiftPoint{293.15, 0}));
  }
  const std::string turned = "T [\u00B0C];-log aT\n50;2\n20;0\n-40;-10\n";
  EXPECT_NEAR(read(table + turned).shift->table.front().log10Shift, 10, 1e-9);
  EXPECT_THAT(factsIn(table + turned),
              testing::Not(testing::Contains(HasSubstr("check their sign"))));
  EXPECT_THAT(factsIn(table + "T [\u00B0C];log aT\n50;2\n20;0\n-40;-10\n"),
              testing::Contains(HasSubstr("rise with temperature")));
  for (const std::string row : {"20;", "20;NaN", "20;0", "20;-1", "-300;1", "50;1"})
    EXPECT_THAT(factsIn(table + "T;aT\n-40;1e10\n" + row + "\n50;0.01\n"),
                testing::Contains(HasSubstr("are not read: they are no rising table")))
        << row;
  EXPECT_FALSE(read(table + "T [\u00B0C];log aT\n50;0\n20;2\n-40;12\n").shift.has_value());
  EXPECT_THAT(factsIn(table + "T [\u00B0C];log aT\n50;0\n20;2\n-40;12\n"),
              testing::Contains(HasSubstr("are not read: they are not those of 20.0")));
  EXPECT_THAT(factsIn(head + "Arrhenius: 80 kJ/mol\n" + curve),
              testing::Contains(HasSubstr("line 2 is about a shift and is not read")));
  const std::string isotherms = "f (Hz);T (C);G' (Pa);G'' (Pa)\n1;20;2e6;2e5\n1;30;3e6;4e5\n";
  EXPECT_THAT(factsIn("C1 = 10\nC2 = 120\n" + isotherms),
              testing::Contains("the shift that the file states is not read: the isotherms have "
                                "their own"));
}

TEST(DmaFile, UnclearMarksAreSaid) {
  EXPECT_TRUE(read("f (Hz);T (C);E' (kPa);E'' (kPa)\n1;25;6.000;1.000\n10;25;7.500;1.500\n"
                   "100;25;9.000;2.000\n1000;25;12.000;2.500\n")
                  .facts.isMarkUnclear);
}

/// The columns of such a test are no others that an option could name.
TEST(DmaFile, RelaxationAndCreepAreNotRead) {
  for (const char* head : {"time (s),G(t) (MPa)", "time (s),J(t) (1/MPa)",
                           "t (s),Relaxation modulus (MPa)", "Time (s),Creep compliance (1/MPa)"}) {
    const std::string text = std::string(head) + "\n0.1,2\n1,1.5\n10,1.2\n";
    EXPECT_THAT(errorFrom([&] { read(text); }),
                AllOf(HasSubstr("relaxation tests, G(t), and creep tests, J(t), are not read"),
                      Not(HasSubstr("--frequency-column"))))
        << head;
  }
}

}  // namespace
}  // namespace asperity
