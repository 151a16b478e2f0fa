// Tables of spectra in the forms that people write, against the height that each convention means.
#include "core/surface/spectrum_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/input_error.h"

namespace asperity {
namespace {

SpectralDensity parseSpectrum(std::string_view text, const std::string& name, SpectrumKind kind) {
  return parseSpectrumTable(text, name, kind).density;
}

constexpr double kTwoPi = 2 * std::numbers::pi;

double squareHeight(const SpectralDensity& density) {
  return 2 * density.integralTo(density.waveNumber.back());
}

/// A constant density of 1e-18 m^3 from q = 1e4 to 1e5 1/m, in other words each time.
TEST(SpectrumFile, MeansTheSameHeightInEveryConvention) {
  const double expected = 2 * 1e-18 * 9e4;
  const struct {
    const char* text;
    SpectrumKind kind;
  } cases[] = {
      {"wave_number,C1\n1e4,1e-18\n1e5,1e-18\n", SpectrumKind::C1TwoSided},
      {"q [1/um];C1 [um^3]\n0,01;1\n0,1;1\n", SpectrumKind::C1TwoSided},
      {"q (rad/m)\tpsd (nm^3)\n1e5\t1e9\n1e4\t1e9\n", SpectrumKind::C1TwoSided},
      {"wave_number spectrum\n1e4 2e-18\n1e5 2e-18\n", SpectrumKind::C1OneSided},
      {"# q, C\n1e4,1e-18\n1e5,1e-18\n", SpectrumKind::C1TwoSided},
      {"q,C\n1/mm,mm^3\n10,1e-9\n100,1e-9\n", SpectrumKind::C1TwoSided},
      {"Sample: asphalt\nq / \u00B5m^-1\tPSD / \u00B5m\u00B3\n0.01\t1\n0.1\t1\n",
       SpectrumKind::C1TwoSided},
      {"Wave number [1/\xB5m];C1 [\xB5m^3]\r\n0,01;1\r\n0,1;1\r\n", SpectrumKind::C1TwoSided},
      {"Wellenzahl (1/m);Leistungsdichte (m\u00B3)\n1e4;1e-18\n1e5;1e-18\n",
       SpectrumKind::C1TwoSided},
      {"log10 q (1/m),log10 C1 (m^3)\n4,-18\n5,-18\n", SpectrumKind::C1TwoSided},
  };
  for (const auto& one : cases)
    EXPECT_NEAR(squareHeight(parseSpectrum(one.text, "s", one.kind)) / expected, 1, 1e-12)
        << one.text;
}

TEST(SpectrumFile, MayBeInUtf16) {
  std::string text = "\xFF\xFE";
  for (const char letter : std::string_view("q,C1\n1e4,1e-18\n1e5,1e-18\n")) text += {letter, '\0'};
  EXPECT_NEAR(squareHeight(parseSpectrum(text, "s", SpectrumKind::C1TwoSided)) / 1.8e-13, 1, 1e-12);
}

/// Per spatial frequency: <h^2> = 2 integral C df, so numbers are 2 pi times those over q.
TEST(SpectrumFile, TakesDensitiesPerSpatialFrequency) {
  const double f = 1e4 / kTwoPi;
  const std::string byFrequency = "spatial_frequency,C1\n" + std::to_string(f) + ",6e-18\n" +
                                  std::to_string(10 * f) + ",6e-18\n";
  EXPECT_NEAR(
      squareHeight(parseSpectrum(byFrequency, "s", SpectrumKind::C1TwoSided)) / (2 * 6e-18 * 9 * f),
      1, 1e-6);
  const SpectralDensity byWavelength =
      parseSpectrum("wavelength [um],psd\n100,6e-18\n10,6e-18\n", "s", SpectrumKind::C1TwoSided);
  EXPECT_NEAR(squareHeight(byWavelength) / (2 * 6e-18 * 9e4), 1, 1e-12);
  EXPECT_NEAR(byWavelength.waveNumber.front(), kTwoPi * 1e4, 1e-6);
}

/// Heights squared times the unit of lengths, and cycles, as standards for roads write them.
TEST(SpectrumFile, TakesUnitsOfHeightsAndLengths) {
  const double expected = 6e-18 * 9e4 / kTwoPi;  // <h^2> = integral C df
  for (const char* text :
       {"f [1/mm],PSD [um^2 mm]\n1.5915494309,6e-3\n15.915494309,6e-3\n",
        "frequency [cycles/m],G_d [m^3]\n1591.5494309,6e-18\n15915.494309,6e-18\n",
        "frequency (cycles/mm);PSD (\u00B5m\u00B2\u00B7mm)\n1,5915494309;6e-3\n15,915494309;6e-3\n",
        "f [1/mm],PSD [um^2/(1/mm)]\n1.5915494309,6e-3\n15.915494309,6e-3\n"})
    EXPECT_NEAR(squareHeight(parseSpectrum(text, "s", SpectrumKind::C1OneSided)) / expected, 1,
                1e-9)
        << text;
}

/// <h^2> = 2 pi integral C2 q dq = 2 integral C_line dq.
TEST(SpectrumFile, MakesTheEquivalentLineOfAnIsotropicSpectrum) {
  std::string text = "q,C2\n";
  double exact = 0;
  for (int i = 0; i <= 20; ++i) {
    const double q = 1e4 * std::pow(10, i / 20.0);
    text += std::to_string(q) + "," + std::to_string(std::pow(q / 1e4, -3.4)) + "e-22\n";
  }
  exact = kTwoPi * 1e-22 * 1e8 * (1 - std::pow(10, -1.4)) / 1.4;
  EXPECT_NEAR(squareHeight(parseSpectrum(text, "s", SpectrumKind::C2)) / exact, 1, 1e-4);
}

/// Of several columns those count that the kind names, and the wave number before a wavelength.
TEST(SpectrumFile, TakesTheColumnsThatAreMeant) {
  const double expected = 2 * 1e-18 * 9e4;
  for (const char* text : {"wave_number,c1,c2\n1e4,1e-18,7e-30\n1e5,1e-18,7e-30\n",
                           "wave_number,c2,c1\n1e4,7e-30,1e-18\n1e5,7e-30,1e-18\n",
                           "wavelength,wave_number,c1\n6.28e-4,1e4,1e-18\n6.28e-5,1e5,1e-18\n",
                           "psd,q,lambda\n1e-18,1e4,6.28e-4\n1e-18,1e5,6.28e-5\n"})
    EXPECT_NEAR(squareHeight(parseSpectrum(text, "s", SpectrumKind::C1TwoSided)) / expected, 1,
                1e-12)
        << text;
  EXPECT_THROW(parseSpectrum("q,c2\n1e4,1e-30\n1e5,1e-30\n", "s", SpectrumKind::C1TwoSided),
               InputError);
  EXPECT_THROW(parseSpectrum("q,c1\n1e4,1e-30\n1e5,1e-30\n", "s", SpectrumKind::C2), InputError);
}

TEST(SpectrumFile, SaysWhatIsWrongAndWhere) {
  const struct {
    const char* text;
    const char* error;
  } cases[] = {
      {"x,y\n1,2\n2,3\n",
       "s: a spectrum is a table whose header names wave_number, "
       "spatial_frequency or wavelength, and the spectrum in another column"},
      {"q,C\n1,1\n", "s: has 1 rows; at least 2 are needed"},
      {"q,C\n1,1\n1,2\n", "s: has two rows for the wave number 1 1/m"},
      {"q,C\n1,1\n2,-1\n", "s: line 3: the spectrum -1 is below 0"},
      {"q,C\n1,1\n2,nan\n", "s: line 3: the value of C is missing"},
      {"q;C\n1;1\n2\n3;1\n", "s: line 3: has one field where the lines before have 2"},
      {"q,C\n1,0\n2,0\n", "s: has no wave with a strength above 0"},
      {"q [furlong],C\n1,1\n2,1\n",
       "s: furlong is not a unit of q; allowed is 1/m, with "
       "mm, \u00B5m or nm as well"},
  };
  for (const auto& one : cases) {
    try {
      parseSpectrum(one.text, "s", SpectrumKind::C1TwoSided);
      ADD_FAILURE() << one.text;
    } catch (const InputError& error) {
      EXPECT_STREQ(error.what(), one.error);
    }
  }
}

/// Cycles are periods, whatever the column is called.
TEST(SpectrumFile, ReadsCyclesAsSpatialFrequencies) {
  const double expected = 6e-18 * 9e4 / kTwoPi;
  for (const char* name : {"k (cycles/mm)", "wavenumber [cycles/mm]"})
    EXPECT_NEAR(squareHeight(parseSpectrum(
                    std::string(name) + ";psd (nm^2 mm)\n1.5915494309;6e3\n15.915494309;6e3\n", "s",
                    SpectrumKind::C1OneSided)) /
                    expected,
                1, 1e-9)
        << name;
}

TEST(SpectrumFile, RefusesWhatContradictsTheKindOrIsUnknown) {
  const struct {
    const char* header;
    const char* error;
  } cases[] = {
      {"spatial_frequency (rad/m),c1 (m^3)", "s: spatial_frequency in rad/m contradicts itself"},
      {"q (cycles/m),c1 (m^3)", "s: q in cycles/m contradicts itself"},
      {"wave_number (1/m),ASD (m^1.5)", "s: its column ASD is not known as a spectrum"},
      {"wave_number (1/m),whatever", "s: its column whatever is not known as a spectrum"},
      {"wave_number (1/m),c1 (foo)", "s: foo is not a unit of c1"},
      {"wave_number (1/m),c1_one_sided (m^3)", "s: its column c1_one_sided is one-sided"},
      {"spatial_frequency (1/m),psd [m^2/(rad/m)]", "s: psd in m^2/(rad/m) is not a density over"},
  };
  for (const auto& one : cases) {
    try {
      parseSpectrum(std::string(one.header) + "\n1e4,1e-18\n1e5,2e-18\n", "s",
                    SpectrumKind::C1TwoSided);
      ADD_FAILURE() << one.header;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).substr(0, std::string(one.error).size()), one.error);
    }
  }
  EXPECT_NO_THROW(
      parseSpectrum("q,c1_two_sided (m^3)\n1e4,1e-18\n1e5,2e-18\n", "s", SpectrumKind::C1TwoSided));
}

/// The columns, the units and the convention are stated, as of other files.
TEST(SpectrumFile, SaysHowItWasRead) {
  const auto facts = [](const char* header, SpectrumKind kind) {
    const auto table =
        parseSpectrumTable(std::string(header) + "\n1e4,1e-30\n1e5,1e-30\n", "s", kind);
    return sentences(table.facts).english();
  };
  EXPECT_EQ(facts("wavelength (um),C1 (um^2*mm)", SpectrumKind::C1TwoSided),
            "wavelengths are column 1 'wavelength' (um), the spectrum is column 2 'C1' (um^2*mm) "
            "the spectrum is two-sided, per spatial frequency f = 1/wavelength: h\u00B2 = 2 \u222B "
            "C df");
  EXPECT_EQ(facts("q,C1", SpectrumKind::C1OneSided),
            "wave numbers are column 1 'q' (in SI units), the spectrum is column 2 'C1' (in SI "
            "units) the spectrum is one-sided, per wave number q: h\u00B2 = \u222B C dq");
  EXPECT_EQ(facts("f (1/mm),C2 (m^4)", SpectrumKind::C2),
            "spatial frequencies are column 1 'f' (1/mm), the spectrum is column 2 'C2' (m^4) the "
            "spectrum is of an isotropic area, per spatial frequency f = 1/wavelength: h\u00B2 = "
            "2\u03C0 \u222B C f df");
}

}  // namespace
}  // namespace asperity
