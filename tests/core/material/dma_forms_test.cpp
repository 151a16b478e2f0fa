// Moduli in other forms than as two columns of numbers: as a magnitude and one part, as complex
// numbers, viscosities and compliances, and with their frequencies in names.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/base/text_number.h"
#include "tests/core/material/dma_reading.h"

namespace asperity {
namespace {

using testing::Contains;
using testing::HasSubstr;

std::vector<std::string> notesOf(const DmaFile& file) {
  std::vector<std::string> notes;
  for (const Message& note : file.facts.notes) notes.push_back(note.english());
  return notes;
}

/// 3, 4 and 5 are the sides of a right triangle.
TEST(DmaForms, AMagnitudeAndOnePartGiveTheOther) {
  const DmaFile loss = read("f (Hz),T (C),|G*| (MPa),G'' (MPa)\n1,20,5,4\n10,20,10,8\n");
  expectRow(loss.rows[0], 293.15, 1, 3e6, 4e6);
  EXPECT_TRUE(loss.facts.notes.empty());
  const DmaFile storage = read("f (Hz),T (C),|E*| (MPa),E' (kPa)\n1,20,15,12000\n10,20,30,24000\n");
  expectRow(storage.rows[1], 293.15, 10, 8e6, 6e6);
  // Digits are lost where both are nearly the same.
  const DmaFile close = read("f (Hz),T (C),|G*| (MPa),G' (MPa)\n1,20,1,0.99\n10,20,2,1.98\n");
  EXPECT_THAT(notesOf(close), Contains(HasSubstr("1 % of error in one of them makes 50 % in it")));
  EXPECT_THAT(errorOf("f (Hz),T (C),|G*| (MPa),G' (MPa)\n1,20,5,4\n10,20,4,5\n"),
              HasSubstr("line 3: |G*| is not above G', which is a part of it"));
  // Storage and loss modulus themselves precede.
  expectRow(read("f (Hz),T (C),|G*| (MPa),G' (MPa),G'' (MPa)\n1,20,5,3,1\n10,20,5,3,1\n").rows[0],
            293.15, 1, 3e6, 1e6);
}

TEST(DmaForms, APeriodGivesTheFrequency) {
  for (const char* text :
       {"Period (s),T (C),G' (MPa),G'' (MPa)\n10,20,3,1\n0.1,20,4,2\n",
        "Periodendauer [ms];T [C];G' [MPa];G'' [MPa]\n1e4;20;3;1\n100;20;4;2\n"}) {
    const DmaFile file = read(text);
    ASSERT_EQ(file.rows.size(), 2U) << text;
    expectRow(file.rows[0], 293.15, 0.1, 3e6, 1e6);
    expectRow(file.rows[1], 293.15, 10, 4e6, 2e6);
    EXPECT_THAT(notesOf(file), Contains(HasSubstr("is a period of the oscillation")));
  }
  // A frequency beside it precedes.
  expectRow(read("Period (s),f (Hz),T (C),G' (MPa),G'' (MPa)\n9,1,20,3,1\n9,10,20,4,2\n").rows[1],
            293.15, 10, 4e6, 2e6);
  EXPECT_THAT(errorOf("Period,T (C),G' (MPa),G'' (MPa)\n10,20,3,1\n0.1,20,4,2\n"),
              HasSubstr("has no columns that are known as frequency"));
  EXPECT_THAT(errorOf("Period (s),T (C),G' (MPa),G'' (MPa)\n-10,20,3,1\n0.1,20,4,2\n"),
              HasSubstr("line 2: the frequency is -0.1, which must be above 0"));
}

TEST(DmaForms, ComplexNumbersAreTwoModuli) {
  for (const char* cells :
       {"2e6+2e5i\n3e6+4e5i", "2e6 + 2e5j\n3e6 + 4e5j", "(2e6+2e5j)\n(3e6+4e5j)",
        "2e6+i*2e5\n3e6+i*4e5", "2000000+200000*i\n3000000+400000*i", "(2e6;2e5)\n(3e6;4e5)"}) {
    std::string text = "f (Hz)\tT (C)\tG* (Pa)\n1\t20\t" + std::string(cells) + "\n";
    text.insert(text.find('\n', text.find("1\t20")) + 1, "10\t20\t");
    const DmaFile file = read(text);
    ASSERT_EQ(file.rows.size(), 2U) << cells;
    expectRow(file.rows[1], 293.15, 10, 3e6, 4e5);
    EXPECT_EQ(file.facts.storage.name, "G* real part");
    EXPECT_EQ(file.facts.loss.name, "G* imaginary part");
  }
  const DmaFile pairs = read(
      "f (Hz),G* -5 C (MPa),G* 20 C (MPa)\n1,\"(3,1)\",\"(2,0.2)\"\n10,\"(4,1)\",\"(3,0.4)\"\n");
  ASSERT_EQ(pairs.rows.size(), 4U);
  expectRow(pairs.rows[3], 293.15, 10, 3e6, 4e5);
  // exp(-i omega t) turns the sign of the loss.
  const DmaFile turned = read("f (Hz);T (C);G* (MPa)\n1;20;2,0-0,2i\n10;20;3,0-0,4i\n");
  expectRow(turned.rows[1], 293.15, 10, 3e6, 4e5);
  EXPECT_THAT(notesOf(turned),
              Contains(HasSubstr("G*: the imaginary parts are below 0 in all rows")));
  EXPECT_THAT(errorOf("f (Hz);T (C);G* (MPa)\n1;20;2+0.2i\n10;20;3-0.4i\n"),
              HasSubstr("line 3: G* imaginary part is \u22120.4 MPa, which must be above 0"));
  EXPECT_THAT(errorOf("f (Hz);T (C);G* (MPa)\n1;20;2+0.2i\n10;20;3\n"),
              HasSubstr("G*: line 3: is not a complex number, as others of the column are"));
}

TEST(DmaForms, ErrorsAndUnitsInCellsLeaveTheNumbers) {
  const DmaFile file = read(
      "20 C\nf (Hz),G' (MPa),G'' (MPa)\n1,2 \u00B1 0.1,0.2 \u00B1 0.01\n10,3 +/- 0.1,0.4(1)\n");
  expectRow(file.rows[1], 293.15, 10, 3e6, 4e5);
  EXPECT_THAT(notesOf(file), Contains("errors in cells, not read, because every point counts the "
                                      "same: G', G''"));
  const DmaFile named =
      read("f (Hz);T (C);G' \u00B1 s (MPa);tan d\n1;20;2 \u00B1 0.1;0.1\n10;20;3 \u00B1 0.1;0.2\n");
  expectRow(named.rows[1], 293.15, 10, 3e6, 6e5);
  const DmaFile units =
      read("f;T;G';G''\n1 Hz;20 \u00B0C;2 MPa;200 kPa\n10 Hz;20 \u00B0C;3 MPa;400 kPa\n");
  expectRow(units.rows[1], 293.15, 10, 3e6, 4e5);
  // The logarithm of a number with an error is one, too.
  expectRow(
      read("f (Hz);T (C);log G' (Pa);G'' (Pa)\n1;20;6 \u00B1 0.1;2e5\n10;20;6 \u00B1 0.1;4e5\n")
          .rows[1],
      293.15, 10, 1e6, 4e5);
  // Remarks may hold anything.
  const DmaFile remarks = read(
      "f (Hz);T (C);G' (MPa);G'' (MPa);Remark\n1;20;2;0.2;5 %\n10;20;3;0.4;3 h\n10;30;2;0.1;4\n");
  EXPECT_EQ(remarks.rows.size(), 3U);
  EXPECT_THAT(errorOf("f;T;G';G''\n1 Hz;20 \u00B0C;2 MPa;200 kPa\n10 Hz;20 \u00B0C;3 N;400 kPa\n"),
              HasSubstr("column G' has the unit N here, and MPa elsewhere"));
}

/// G* = i omega eta*; the frequencies are 10 and 100 rad/s.
TEST(DmaForms, ViscositiesGiveModuli) {
  const std::string head = "w (rad/s),T (C),";
  for (const std::string table :
       {"eta' (Pa s),eta'' (Pa s)\n10,20,2e4,2e5\n100,20,4e3,3e4\n",
        "\u03B7\u2032 (kPa\u00B7s),\u03B7\u2033 (kPa\u00B7s)\n10,20,20,200\n100,20,4,30\n",
        "|eta*| (Pa.s),tan delta\n10,20,200997.51242241781,0.1\n100,20,30265.491900843113,"
        "0.13333333333333333\n",
        "Complex viscosity (Pas),Phase angle (deg)\n10,20,200997.51242241781,5.710593137499643\n"
        "100,20,30265.491900843113,7.594643368591445\n",
        "|eta*| (Pa s),eta' (Pa s)\n10,20,200997.51242241781,2e4\n100,20,30265.491900843113,4e3\n",
        "G' (MPa),|eta*| (Pa s)\n10,20,2,200997.51242241781\n100,20,3,30265.491900843113\n",
        "G' (MPa),eta' (Pa s)\n10,20,2,2e4\n100,20,3,4e3\n"}) {
    const DmaFile file = read(head + table);
    ASSERT_EQ(file.rows.size(), 2U) << table;
    expectRow(file.rows[0], 293.15, 5 / std::numbers::pi, 2e6, 2e5);
    expectRow(file.rows[1], 293.15, 50 / std::numbers::pi, 3e6, 4e5);
    EXPECT_THAT(notesOf(file),
                Contains("the moduli follow from viscosities: G* = i \u03C9 \u03B7*"));
  }
  // The viscosity of a flow is none.
  EXPECT_THAT(errorOf(head + "viscosity (Pa s),tan delta\n10,20,1,1\n100,20,1,1\n"),
              HasSubstr("has no columns that are known"));
}

/// G* = 1 / J*: 1 / (4 - 3 i) = (4 + 3 i) / 25.
TEST(DmaForms, CompliancesGiveModuli) {
  for (const std::string table : {"J' (1/MPa),J'' (1/MPa)\n1,20,4,3\n10,20,8,6\n",
                                  "J' (MPa^-1),J'' (MPa\u207B\u00B9)\n1,20,4,3\n10,20,8,6\n",
                                  "J' [mm\u00B2/N],J'' [mm\u00B2/N]\n1,20,4,3\n10,20,8,6\n",
                                  "Storage compliance J' (1/Pa),Loss compliance J'' "
                                  "(1/Pa)\n1,20,4e-6,3e-6\n10,20,8e-6,6e-6\n",
                                  "J' (1/MPa),tan delta\n1,20,4,0.75\n10,20,8,0.75\n",
                                  "|J*| (1/MPa),J'' (1/MPa)\n1,20,5,3\n10,20,10,6\n",
                                  "J* (1/MPa)\n1,20,4-3i\n10,20,8-6i\n"}) {
    const DmaFile file = read("f (Hz),T (C)," + table);
    ASSERT_EQ(file.rows.size(), 2U) << table;
    expectRow(file.rows[0], 293.15, 1, 0.16e6, 0.12e6);
    EXPECT_THAT(notesOf(file), Contains("the moduli follow from compliances: G* = 1 / J*"));
  }
  EXPECT_EQ(read("f (Hz),T (C),J' (1/MPa),J'' (1/MPa)\n1,20,4,3\n10,20,8,6\n").facts.storage.name,
            "J'");
  // Those of tension are three times as small as those of shear.
  const DmaFile tension = read("f (Hz),T (C),D' (1/MPa),D'' (1/MPa)\n1,20,4,3\n10,20,8,6\n");
  expectRow(tension.rows[0], 293.15, 1, 0.16e6 / 3, 0.12e6 / 3);
  EXPECT_EQ(tension.facts.modulus, ModulusKind::Tension);
  EXPECT_THAT(errorOf("f (Hz),T (C),J' (1/furlong),J'' (1/furlong)\n1,20,4,3\n10,20,8,6\n"),
              HasSubstr("has the unit 1/furlong, which is not one of 1/Pa"));
}

/// Viscosities are in the chosen unit times s, and compliances in one over it, whatever the file
/// states.
TEST(DmaForms, TheChosenUnitOfModuliIsThatOfViscositiesAndCompliances) {
  DmaChoices choices;
  choices.modulusUnit = "kN/m2";
  for (const std::string unit : {"", " (Pa s)", " (furlong)"}) {
    const DmaFile file = read(
        "w (rad/s),T (C),eta'" + unit + ",eta''" + unit + "\n10,20,20,200\n100,20,4,30\n", choices);
    expectRow(file.rows[1], 293.15, 50 / std::numbers::pi, 3e6, 4e5);
    EXPECT_EQ(file.facts.storage.unit, "kN/m2 s");
  }
  for (const std::string unit : {"", " (1/Pa)", " (1/furlong)"}) {
    const DmaFile file = read(
        "f (Hz),T (C),J'" + unit + ",J''" + unit + "\n1,20,4e-3,3e-3\n10,20,8e-3,6e-3\n", choices);
    expectRow(file.rows[0], 293.15, 1, 0.16e6, 0.12e6);
    EXPECT_EQ(file.facts.storage.unit, "1/(kN/m2)");
  }
}

/// As Mettler names moduli of every kind.
TEST(DmaForms, MIsAModulusOfAKindStatedElsewhere) {
  for (const std::string table :
       {"M' (MPa),M'' (MPa)\n1,20,3,4\n10,20,6,8\n", "|M*| (MPa),M'' (MPa)\n1,20,5,4\n10,20,10,8\n",
        "Storage modulus M' (MPa),Loss modulus M'' (MPa)\n1,20,3,4\n10,20,6,8\n"}) {
    expectRow(read("Device: MCR 302e\nf (Hz),T (C)," + table).rows[0], 293.15, 1, 3e6, 4e6);
    EXPECT_THAT(errorOf("f (Hz),T (C)," + table), HasSubstr("--modulus shear or"));
  }
  EXPECT_THAT(errorOf("f (Hz),T (C),G' M (MPa),G'' (MPa)\n1,20,3,4\n10,20,6,8\n"),
              HasSubstr("G' M: 'm' is not understood beside the name of a modulus"));
}

TEST(DmaForms, ReducedFrequenciesHaveManySymbols) {
  for (const char* name : {"f_red (Hz)", "aT f (Hz)", "aT\u00D7f (Hz)", "freq_red (Hz)",
                           "fr\u00E9quence r\u00E9duite (Hz)"}) {
    const DmaFile file =
        read(std::string("Tref = 20 C\n") + name + ",G' (MPa),G'' (MPa)\n1,2,0.2\n10,3,0.4\n");
    EXPECT_TRUE(file.facts.isReduced) << name;
    expectRow(file.rows[1], 293.15, 10, 3e6, 4e5);
  }
  for (const char* name : {"log(aT*w/(rad/s))", "log(aT\u00B7\u03C9) (rad/s)", "log w*aT/(rad/s)",
                           "lg(\u03C9_red) [rad/s]"}) {
    const DmaFile file =
        read(std::string("Tref = 20 C\n") + name + ";log G'/Pa;log G''/Pa\n1.0;6;5\n2.0;7;6\n");
    EXPECT_TRUE(file.facts.isReduced) << name;
    expectRow(file.rows[1], 293.15, 50 / std::numbers::pi, 1e7, 1e6);
  }
  EXPECT_FALSE(read("measured frequency (Hz),T (C),G' (MPa),G'' (MPa)\n1,20,2,0.2\n10,20,3,0.4\n")
                   .facts.isReduced);
}

/// Sweeps of temperature at several frequencies, side by side or in blocks.
TEST(DmaForms, NamesAndLinesMayStateTheFrequency) {
  for (const char* names : {"T (C),G' 1 Hz (MPa),G'' 1 Hz (MPa),G' 10 Hz (MPa),G'' 10 Hz (MPa)",
                            "T (C),G' 1Hz (MPa),G' 10Hz (MPa),G'' 1Hz (MPa),G'' 10Hz (MPa)",
                            "##Temp./\u00B0C,G'(1.000 Hz)/MPa,G''(1.000 Hz)/MPa,G'(10.000 "
                            "Hz)/MPa,G''(10.000 Hz)/MPa"}) {
    const bool isMixed = std::string(names).find("1Hz") != std::string::npos;
    const DmaFile file =
        read(std::string(names) + (isMixed ? "\n20,2,3,0.2,0.4\n30,1,2,0.1,0.2\n"
                                           : "\n20,2,0.2,3,0.4\n30,1,0.1,2,0.2\n"));
    ASSERT_EQ(file.rows.size(), 4U) << names;
    expectRow(file.rows[0], 293.15, 1, 2e6, 2e5);
    expectRow(file.rows[3], 303.15, 10, 2e6, 2e5);
  }
  const DmaFile tangents = read(
      "T (C),E' 2.5 Hz [MPa],tan d (2.5 Hz),E' 5 Hz [MPa],tan d (5 Hz)\n20,6,0.1,9,0.2\n"
      "30,3,0.1,6,0.2\n");
  expectRow(tangents.rows[0], 293.15, 2.5, 2e6, 2e5);
  expectRow(tangents.rows[2], 293.15, 5, 3e6, 6e5);
  const DmaFile blocks = read(
      "Frequency: 1 Hz\nT (C);G' (MPa);G'' (MPa)\n20;2;0.2\n30;1;0.1\n\nFrequenz = 10 Hz\n"
      "T (C);G' (MPa);G'' (MPa)\n20;3;0.4\n30;2;0.2\n");
  ASSERT_EQ(blocks.rows.size(), 4U);
  expectRow(blocks.rows[2], 293.15, 10, 3e6, 4e5);
  for (const char* line : {"Sampling frequency: 100 Hz", "Frequency: 1 to 10 Hz", "1 Hz; 2 Hz"})
    EXPECT_THAT(errorOf(std::string(line) + "\nT (C);G' (MPa);G'' (MPa)\n20;2;0.2\n30;1;0.1\n"),
                HasSubstr("has no columns that are known"))
        << line;
}

/// One row for each quantity; the line of names is the first row, or numbers the points.
TEST(DmaForms, RowsMayBeTheQuantities) {
  for (const std::string text :
       {"Frequency (Hz);1;10;100\nT (\u00B0C);20;20;20\nG' (MPa);2;3;4\nG'' (MPa);0,2;0,4;0,5\n",
        "Quantity,1,2,3\nf (Hz),1,10,100\nTemperature (K),293.15,293.15,293.15\nG' (MPa),2,3,4\n"
        "tan delta,0.1,0.13333333333333333,0.125\n"}) {
    const DmaFile file = read(text);
    ASSERT_EQ(file.rows.size(), 3U) << text;
    expectRow(file.rows[1], 293.15, 10, 3e6, 4e5);
    EXPECT_THAT(notesOf(file), Contains("the table has one row for each quantity, and its columns "
                                        "are the points"));
  }
}

TEST(DmaForms, NamesMayBeInManyLanguages) {
  for (const std::string names :
       {"Cz\u0119stotliwo\u015B\u0107 (Hz);Temperatura (\u00B0C);Modu\u0142 zachowawczy G' "
        "(MPa);Modu\u0142 stratno\u015Bci G'' (MPa)",
        "Frequentie (Hz);Temperatuur (\u00B0C);Opslagmodulus G' (MPa);Verliesmodulus G'' (MPa)",
        "Frequ\u00EAncia (Hz);Temperatura (\u00B0C);M\u00F3dulo de armazenamento G' "
        "(MPa);M\u00F3dulo de perda G'' (MPa)",
        "\u9891\u7387 (Hz);\u6E29\u5EA6 (\u00B0C);\u50A8\u80FD\u6A21\u91CF G' "
        "(MPa);\u635F\u8017\u6A21\u91CF G'' (MPa)",
        "\uC8FC\uD30C\uC218 (Hz);\uC628\uB3C4 (\u00B0C);\uC800\uC7A5\uD0C4\uC131\uB960 G' "
        "(MPa);\uC190\uC2E4\uD0C4\uC131\uB960 G'' (MPa)"}) {
    const DmaFile file = read(names + "\n1;20;2;0,2\n10;20;3;0,4\n");
    ASSERT_EQ(file.rows.size(), 2U) << names;
    expectRow(file.rows[1], 293.15, 10, 3e6, 4e5);
  }
}

TEST(DmaForms, LostValuesAreLeftOut) {
  for (const char* lost : {"9.9E+30", "9.91E37", "-9.9e+37", "OVER", "+OVER", "Overload", "OVFL"}) {
    const DmaFile file = read(std::string("f (Hz),T (C),G' (MPa),G'' (MPa)\n1,20,2,0.2\n2,20,") +
                              lost + ",1\n10,20,3,0.4\n");
    EXPECT_EQ(file.rows.size(), 2U) << lost;
    EXPECT_EQ(file.facts.leftOut, 1U) << lost;
  }
}

TEST(DmaForms, TheFileMaySayThatModuliAreOfShear) {
  const std::string table =
      "f (Hz);T (C);Storage modulus (MPa);Loss modulus (MPa)\n1;20;2;0.2\n10;20;3;0.4\n";
  for (const char* line : {"Messsystem: PP25-SN123", "Instrument: ARES-G2", "Device: MCR 302e",
                           "Instrument name: Discovery Hybrid Rheometer"})
    expectRow(read(std::string(line) + "\n" + table).rows[1], 293.15, 10, 3e6, 4e5);
  for (const char* column : {"Shear strain (%)", "Schubspannung (kPa)", "Scherdeformation (%)"}) {
    const DmaFile file =
        read(std::string("f (Hz);T (C);Storage modulus (MPa);Loss modulus (MPa);") + column +
             "\n1;20;2;0.2;1\n10;20;3;0.4;1\n");
    expectRow(file.rows[1], 293.15, 10, 3e6, 4e5);
    EXPECT_THAT(notesOf(file), Contains(HasSubstr("says that the moduli are of shear")));
  }
  for (const char* line : {"Instrument: DMA 850", "Instrument: MCR 702 MultiDrive",
                           "Instrument: rheometer with DMA", "Operator: Ares"})
    EXPECT_THAT(errorOf(std::string(line) + "\n" + table), HasSubstr("--modulus shear")) << line;
}

TEST(DmaForms, ModuliOfAnotherKindThanWantedAreNamed) {
  DmaChoices choices;
  choices.modulus = ModulusKind::Shear;
  const std::string table = "f (Hz),T (C),E' (MPa),E'' (MPa)\n1,20,6,0.6\n10,20,9,1.2\n";
  EXPECT_THAT(errorOf(table, choices),
              HasSubstr("--modulus: the file has moduli of tension (E) by their names: E', E''"));
  choices.storageColumn = "3";
  choices.lossColumn = "4";
  expectRow(read(table, choices).rows[0], 293.15, 1, 6e6, 6e5);
}

TEST(DmaForms, MatricesOfBothModuliAreOneTable) {
  for (const char* text :
       {"G' (MPa)\nf (Hz);20 \u00B0C;40 \u00B0C\n1;2;1\n10;4;3\n\n"
        "G'' (MPa)\nf (Hz);20 \u00B0C;40 \u00B0C\n1;0.2;0.1\n10;0.4;0.3\n",
        "G' (MPa)\nf (Hz) \\ T (\u00B0C);20;40\n1;2;1\n10;4;3\n\n"
        "G'' (MPa)\nf (Hz) \\ T (\u00B0C);20;40\n1;0.2;0.1\n10;0.4;0.3\n",
        "Speichermodul G' / MPa;;\nf / Hz;20 \u00B0C;40 \u00B0C\n1;2;1\n10;4;3\n;;\n"
        "Verlustmodul G'' / MPa;;\nf / Hz;20 \u00B0C;40 \u00B0C\n1;0,2;0,1\n10;0,4;0,3\n",
        "G' (MPa)\nf (Hz);T = 20 \u00B0C;T = 40 \u00B0C\n1;2;1\n10;4;3\n\n"
        "tan delta\nf (Hz);T = 20 \u00B0C;T = 40 \u00B0C\n1;0.1;0.1\n10;0.1;0.1\n",
        "G' (MPa)\nf (Hz);20;40\n1;2;1\n10;4;3\n\n"
        "G'' (MPa)\nf (Hz);20;40\n1;0.2;0.1\n10;0.4;0.3\n"}) {
    SCOPED_TRACE(text);
    const DmaFile file = read(text);
    ASSERT_EQ(file.rows.size(), 4U);
    expectRow(file.rows[1], 293.15, 10, 4e6, 4e5);
    expectRow(file.rows[3], 313.15, 10, 3e6, 3e5);
    EXPECT_THAT(notesOf(file), Contains("2 matrices, each below the name of its modulus, are read "
                                        "as one table"));
  }
  // Rows of temperatures, and columns of frequencies; powers of ten with a unit are no units.
  const DmaFile turned = read(
      "G' (MPa)\nT (\u00B0C),0.1 Hz,1 Hz,10 Hz\n20,2,3,4\n40,1,2,3\n\n"
      "G'' (MPa)\nT (\u00B0C),0.1 Hz,1 Hz,10 Hz\n20,0.2,0.3,0.4\n40,0.1,0.2,0.3\n");
  ASSERT_EQ(turned.rows.size(), 6U);
  expectRow(turned.rows[5], 313.15, 10, 3e6, 3e5);
  const DmaFile bare = read(
      "G' (MPa)\nf (Hz);20;40\n1;2;1\n10;4;3\n\n"
      "G'' (MPa)\nf (Hz);20;40\n1;0.2;0.1\n10;0.4;0.3\n");
  EXPECT_THAT(notesOf(bare), Contains("the numbers above the columns are taken for temperatures: "
                                      "20 \u00B0C to 40 \u00B0C"));
  // Other temperatures, or no name of the modulus.
  EXPECT_THAT(errorOf("G' (MPa)\nf (Hz);20 \u00B0C;40 \u00B0C\n1;2;1\n10;4;3\n\n"
                      "G'' (MPa)\nf (Hz);20 \u00B0C;60 \u00B0C\n1;0.2;0.1\n10;0.4;0.3\n"),
              HasSubstr("has no columns that are known"));
  EXPECT_NE(errorOf("f (Hz);20 \u00B0C;40 \u00B0C\n1;2;1\n10;4;3\n\n"
                    "f (Hz);20 \u00B0C;40 \u00B0C\n1;0.2;0.1\n10;0.4;0.3\n"),
            "no error");
  const DmaFile corner = read(
      "G' (MPa)\nf (kHz) \\ T;20;40\n1;2;1\n10;4;3\n\n"
      "G'' (MPa)\nf (kHz) \\ T;20;40\n1;0.2;0.1\n10;0.4;0.3\n");
  expectRow(corner.rows[3], 313.15, 1e4, 3e6, 3e5);
}

TEST(DmaForms, RowsOfMatricesAreComparedWithTheirUnits) {
  const auto text = [](const std::string& names, const std::string& rows) {
    return "G' (MPa)\nf (Hz);20 \u00B0C;40 \u00B0C\n1;2;1\n10;4;3\n\nG'' (MPa)\n" + names +
           ";20 \u00B0C;40 \u00B0C\n" + rows;
  };
  for (const char* names : {"f (kHz)", "f (rad/s)", "omega", "T (\u00B0C)"})
    EXPECT_NE(errorOf(text(names, "1;0.2;0.1\n10;0.4;0.3\n")), "no error") << names;
  for (const auto& [names, rows] :
       {std::pair("f (kHz)", "0.001;0.2;0.1\n0.01;0.4;0.3\n"),
        {"omega (rad/s)", "6.283185307179586;0.2;0.1\n62.83185307179586;0.4;0.3\n"}}) {
    const DmaFile file = read(text(names, rows));
    ASSERT_EQ(file.rows.size(), 4U) << names;
    expectRow(file.rows[3], 313.15, 10, 3e6, 3e5);
  }
}

TEST(DmaForms, NumbersAboveMatricesMayHaveDecimalCommas) {
  const DmaFile file = read(
      "G' (MPa)\nf (Hz) \\ T (\u00B0C);22,5;40\n1;2;1\n10;4;3\n\n"
      "G'' (MPa)\nf (Hz) \\ T (\u00B0C);22,5;40\n1;0,2;0,1\n10;0,4;0,3\n");
  ASSERT_EQ(file.rows.size(), 4U);
  expectRow(file.rows[1], 295.65, 10, 4e6, 4e5);
}

/// A line above matrices is kept although a number in it is that of a column.
TEST(DmaForms, LinesAboveMatricesStateWhatHoldsForAll) {
  for (const std::string filler : {"40", "50"}) {
    const DmaFile file = read("Simple shear, " + filler +
                              " phr carbon black\nStorage modulus (MPa)\nf (Hz);20;40\n1;2;1\n"
                              "10;4;3\n\nLoss modulus (MPa)\nf (Hz);20;40\n1;0.2;0.1\n"
                              "10;0.4;0.3\n");
    expectRow(file.rows[3], 313.15, 10, 3e6, 3e5);
  }
}

TEST(DmaForms, TheLetterOfASampleIsNoSymbol) {
  for (const char* sample : {"sample E", "sample G", "Specimen E", "Probe G", "compound E"}) {
    const std::string label = std::string(" modulus (") + sample + ") (MPa)";
    EXPECT_THAT(errorOf("f (Hz);T (\u00B0C);Storage" + label + ";Loss" + label +
                        "\n1;20;2;0.2\n10;20;4;0.4\n"),
                HasSubstr("--modulus"))
        << sample;
  }
  expectRow(read("f (Hz);T (\u00B0C);Storage modulus G (sample E) (MPa);Loss modulus G (sample E) "
                 "(MPa)\n1;20;2;0.2\n10;20;4;0.4\n")
                .rows[1],
            293.15, 10, 4e6, 4e5);
}

TEST(DmaForms, MatricesSideBySideAreOneTable) {
  for (const char* separator : {";", "\t", ","}) {
    std::string text =
        ";G' (MPa);;G'' (MPa);\nf (Hz);20 \u00B0C;40 \u00B0C;20 \u00B0C;40 \u00B0C\n"
        "1;2;1;0.2;0.1\n10;4;3;0.4;0.3\n";
    replaceAll(text, ";", separator);
    SCOPED_TRACE(text);
    const DmaFile file = read(text);
    ASSERT_EQ(file.rows.size(), 4U);
    expectRow(file.rows[3], 313.15, 10, 3e6, 3e5);
  }
  // The groups have other temperatures.
  EXPECT_NE(errorOf(";G' (MPa);;G'' (MPa);\nf (Hz);20 \u00B0C;40 \u00B0C;20 \u00B0C;60 "
                    "\u00B0C\n1;2;1;0.2;0.1\n10;4;3;0.4;0.3\n"),
            "no error");
}

TEST(DmaForms, NamesInRussianTurkishAndCzechAreRead) {
  for (const char* names :
       {"\u0427\u0430\u0441\u0442\u043E\u0442\u0430 (\u0413\u0446);"
        "\u0422\u0435\u043C\u043F\u0435\u0440\u0430\u0442\u0443\u0440\u0430, \u00B0\u0421;"
        "\u041C\u043E\u0434\u0443\u043B\u044C "
        "\u043D\u0430\u043A\u043E\u043F\u043B\u0435\u043D\u0438\u044F G' "
        "(\u041C\u041F\u0430);\u041C\u043E\u0434\u0443\u043B\u044C "
        "\u043F\u043E\u0442\u0435\u0440\u044C G'' (\u041C\u041F\u0430)",
        "Frekans (Hz);S\u0131cakl\u0131k (\u00B0C);Depolama mod\u00FCl\u00FC G' (MPa);Kay\u0131p "
        "mod\u00FCl\u00FC G'' (MPa)",
        "Frekvence (Hz);Teplota (\u00B0C);Pam\u011B\u0165ov\u00FD modul G' "
        "(MPa);Ztr\u00E1tov\u00FD "
        "modul G'' (MPa)"}) {
    SCOPED_TRACE(names);
    expectRow(read(std::string(names) + "\n1;20;2;0,2\n10;20;4;0,4\n").rows[1], 293.15, 10, 4e6,
              4e5);
  }
}

TEST(DmaForms, TemperaturesAboveSweepsMayBeStatements) {
  const DmaFile file = read(
      ";T=0;;T=20;\nf (Hz);G' (MPa);G'' (MPa);G' (MPa);G'' (MPa)\n1;4;0.4;2;0.2\n10;8;0.8;4;0.4\n");
  ASSERT_EQ(file.rows.size(), 4U);
  expectRow(file.rows[3], 293.15, 10, 4e6, 4e5);
}

/// As temperatures do, in merged cells of a spreadsheet.
TEST(DmaForms, AFrequencyHoldsForTheRowsBelowIt) {
  const DmaFile file = read(
      "f (Hz);T (C);G' (MPa);G'' (MPa)\n1;0;4;0.4\n;20;2;0.2\n;40;1;0.1\n10;0;8;0.8\n;20;4;0.4\n"
      ";40;2;0.2\n");
  ASSERT_EQ(file.rows.size(), 6U);
  expectRow(file.rows[4], 293.15, 10, 4e6, 4e5);
  EXPECT_THAT(notesOf(file), Contains("f stands in the first row of each group alone: it holds for "
                                      "the rows below it"));
}

TEST(DmaForms, DatesStandBesideTheNumbers) {
  const DmaFile file = read(
      "Date;Time;f (Hz);T (\u00B0C);G' (MPa);G'' (MPa)\n"
      "12.03.2024;10:11:12;1;20;2,5;0,2\n12.03.2024;10:11:32;10;20;4;0,4\n");
  expectRow(file.rows[0], 293.15, 1, 2.5e6, 2e5);
  EXPECT_EQ(file.rows.size(), 2U);
}

TEST(DmaForms, PartsOfAComplexModulusAndItsLetterAreNames) {
  expectRow(read("f [Hz];T [\u00B0C];Re(G*) [MPa];Im(G*) [MPa]\n1;20;2;0.2\n10;20;4;0.4\n").rows[1],
            293.15, 10, 4e6, 4e5);
  expectRow(
      read("f_Hz,T_C,Storage_Modulus_E_MPa,Loss_Modulus_E_MPa\n1,20,6,0.6\n10,20,12,1.2\n").rows[1],
      293.15, 10, 4e6, 4e5);
  expectRow(
      read("f [Hz];T [oC];G* real [N mm-2];G* imag [N mm\u207B\u00B2]\n1;20;2;0.2\n10;20;4;0.4\n")
          .rows[1],
      293.15, 10, 4e6, 4e5);
  // "Elastik" is a word of modulus and no letter of it.
  expectRow(
      read("f (Hz);T (C);Elastik mod\u00FCl G' (MPa);G'' (MPa)\n1;20;2;0.2\n10;20;4;0.4\n").rows[1],
      293.15, 10, 4e6, 4e5);
}

TEST(DmaForms, LinesAboveSayKindAndFrequency) {
  const std::string rows =
      "f (Hz),T (C),Storage modulus (MPa),Loss modulus (MPa)\n1,20,6,0.6\n10,20,12,1.2\n";
  expectRow(read("Simple shear 10x10x2 mm\n" + rows).rows[1], 293.15, 10, 12e6, 1.2e6);
  expectRow(read("Zugversuch\n" + rows).rows[1], 293.15, 10, 4e6, 4e5);
  const DmaFile ramp =
      read("Temperature sweep at 10 Hz\nT (C),G' (MPa),G'' (MPa)\n0,4,0.4\n20,2,0.2\n40,1,0.1\n");
  expectRow(ramp.rows[1], 293.15, 10, 2e6, 2e5);
  EXPECT_NE(errorOf("Frequency sweep 0.1 - 100 Hz\nT (C),G' (MPa),G'' (MPa)\n0,4,0.4\n20,2,0.2\n"),
            "no error");
}

TEST(DmaForms, ALossFactorInPerCentNeedsItsUnit) {
  const std::string rows = "\n1;20;2;10\n10;20;4;12\n";
  EXPECT_THAT(
      errorOf("f (Hz);T (C);G' (MPa);tan delta" + rows),
      HasSubstr("tan delta: has no unit, and its median is 12, more than that of a rubber"));
  expectRow(read("f (Hz);T (C);G' (MPa);tan delta (%)" + rows).rows[0], 293.15, 1, 2e6, 2e5);
  expectRow(read("f (Hz);T (C);G' (MPa);tan delta [1]" + rows).rows[0], 293.15, 1, 2e6, 2e7);
}

TEST(DmaForms, TemperaturesBetweenTheRowsOfOneTable) {
  const std::string names = "f (Hz);G' (MPa);G'' (MPa)\n";
  for (const char* end : {"", ";;"}) {
    const DmaFile file = read(names + "T = 5 \u00B0C" + end + "\n1;3;1\n10;4;2\nT = 20 \u00B0C" +
                              end + "\n1;2;0.5\n10;3;1\n");
    ASSERT_EQ(file.rows.size(), 4U) << end;
    expectRow(file.rows[1], 278.15, 10, 4e6, 2e6);
    expectRow(file.rows[2], 293.15, 1, 2e6, 0.5e6);
  }
  const DmaFile runs = read("T = 5 \u00B0C\n" + names + "1;3;1\n10;4;2\nRun 2\n1;2;0.5\n10;3;1\n");
  ASSERT_EQ(runs.rows.size(), 2U);
  EXPECT_THAT(notesOf(runs), Contains("tables of numbers that are not used: at line 6"));
}

TEST(DmaForms, LinesBelowTheOnlyTableCountAsThoseAboveIt) {
  const DmaFile file = read(
      "f (Hz);G' (MPa);G'' (MPa)\n1;3;1\n10;4;2\n\nReference temperature: 20 \u00B0C\n"
      "C1 = 8.86; C2 = 101.6 K\n");
  ASSERT_EQ(file.rows.size(), 2U);
  expectRow(file.rows[0], 293.15, 1, 3e6, 1e6);
  ASSERT_TRUE(file.shift);
  EXPECT_DOUBLE_EQ(file.shift->c1, 8.86);
}

TEST(DmaForms, OtherLinesBelowTheTableStateNoTemperature) {
  const std::string table = "f (Hz);G' (MPa);G'' (MPa)\n1;3;1\n10;4;2\n\n";
  for (const char* below :
       {"Next test: T = 60 \u00B0C\n", "Sample 2: T = 60 \u00B0C\n", "T: 60 \u00B0C for ageing\n",
        "Next test\nT = 60 \u00B0C\n", "T = 60 \u00B0C\nStorage at 5 \u00B0C\n"})
    EXPECT_THAT(errorOf(table + below), HasSubstr("temperature: is stated nowhere")) << below;
  for (const char* below : {"T = 60 \u00B0C\n", "Tref = 60 \u00B0C\nC1 = 8.86; C2 = 101.6 K\n",
                            "C1 = 8.86; C2 = 101.6 K; fit of another compound\n"}) {
    const DmaFile file = read("T = 5 \u00B0C\n" + table + below);
    expectRow(file.rows[0], 278.15, 1, 3e6, 1e6);
    EXPECT_FALSE(file.shift) << below;
  }
}

TEST(DmaForms, RowsBelowOtherLinesAreNotOfTheTable) {
  for (const char* between :
       {"WLF: Tref = 20 \u00B0C", "shift factors, Tref = 20 \u00B0C", "Mean values, T = 5 \u00B0C",
        "T = 20 \u00B0C, f in kHz", "Tg = -60 \u00B0C", "-----"}) {
    const DmaFile file =
        read(std::string("T = 5 \u00B0C\nf (Hz);G' (MPa);G'' (MPa)\n1;3;1\n10;4;2\n") + between +
             "\n8.86;101.6;1\n20;102;2\n");
    EXPECT_EQ(file.rows.size(), 2U) << between;
  }
}

TEST(DmaForms, TemperaturesInNamesWithoutBracketsSideBySide) {
  for (const std::string name :
       {"tan delta {}", "tan(delta) @ {}", "tan delta ({})", "tan \u03B4 bei {}"}) {
    std::string text = "f (Hz)";
    for (const std::string state : {"-35 \u00B0C", "0 \u00B0C", "20 \u00B0C"}) {
      text += ";E' (MPa) " + state + ";" + name;
      replaceAll(text, "{}", state);
    }
    text += "\n1;300;0.1;30;0.2;3;0.3\n10;400;0.1;40;0.2;4;0.3\n";
    const DmaFile file = read(text);
    ASSERT_EQ(file.rows.size(), 6U) << name;
    expectRow(file.rows[0], 238.15, 1, 1e8, 1e7);
    expectRow(file.rows[3], 273.15, 10, 4e7 / 3, 8e6 / 3);
    std::string chosen = name;
    replaceAll(chosen, "{}", "20 \u00B0C");
    DmaChoices choices;
    choices.lossTangentColumn = chosen;
    const DmaFile one = read(text, choices);
    ASSERT_EQ(one.rows.size(), 2U) << name;
    expectRow(one.rows[0], 293.15, 1, 1e6, 0.3e6);
  }
}

TEST(DmaForms, ASetTemperatureGroupsTheRowsOfItsIsotherms) {
  const std::string names = ";f (Hz);G' (MPa);G'' (MPa)\n";
  const std::string rows =
      "10;9.2;1;3;1\n10;10.1;10;4;2\n10;10.7;100;5;2\n"
      "20;20.9;1;2;0.5\n20;19.4;10;3;1\n20;19.7;100;4;2\n";
  for (const std::string columns :
       {"Setpoint (\u00B0C);Temperature (\u00B0C)", "T set (\u00B0C);T actual (\u00B0C)",
        "Soll-Temperatur (\u00B0C);Ist-Temperatur (\u00B0C)"}) {
    const DmaFile file = read(columns + names + rows);
    ASSERT_EQ(file.rows.size(), 6U) << columns;
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR(file.rows[i].temperature, i < 3 ? 283.15 : 293.15, 1e-9) << columns;
    EXPECT_THAT(notesOf(file), Contains(HasSubstr("which differ from it by up to 0.9 K")))
        << columns;
    // Where the temperatures follow the set ones closely, they are left as they are.
    const DmaFile close = read(columns + names + "10;9.9;1;3;1\n10;10.1;10;4;2\n");
    EXPECT_NEAR(close.rows[0].temperature, 283.05, 1e-9) << columns;
    // Where they overlap or lie far apart, it is not clear.
    for (const std::string unclear :
         {"10;9.2;1;3;1\n10;14;10;4;2\n", "10;9;1;3;1\n10;11;10;4;2\n12;10;1;3;1\n12;12;10;4;2\n",
          "10;9;1;3;1\n;11;10;4;2\n"})
      EXPECT_NEAR(read(columns + names + unclear).rows[1].temperature,
                  unclear.find("14") != unclear.npos ? 287.15 : 284.15, 1e-9)
          << columns << unclear;
  }
}

}  // namespace
}  // namespace asperity
