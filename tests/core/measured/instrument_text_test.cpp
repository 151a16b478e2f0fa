// Files of ISO 5436-2, Zygo, Wyko and Surfer, SDF of any maker, and the headers of Keyence,
// MountainsMap and SPIP: a known surface comes back with its own steps and units.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/input_error.h"
#include "tests/core/measured/binary_writers.h"
#include "tests/core/measured/instrument_writers.h"
#include "tests/core/measured/surface_expectations.h"
#include "tests/core/measured/x3p_writer.h"

namespace asperity::written {
namespace {

using testing::HasSubstr;

ReadingChoices inMicrometres() {
  ReadingChoices choices;
  choices.positionUnit = choices.heightUnit = "um";
  return choices;
}

// ---- SDF ---------------------------------------------------------------------------------------

std::string textSdf(const std::string& version) {
  std::string text =
      version + "\r\nManufacID = TEST\r\nCreateDate = 010120200000\r\nModDate = " +
      fmt::format("010120200000\r\nNumPoints = {}\r\nNumProfiles = {}\r\n", kColumns, kRows) +
      fmt::format("Xscale = {}\r\nYscale = {}\r\n", kColumnSpacing, kRowSpacing) +
      "Zscale = 1e-6\r\nZresolution = -1\r\nCompression = 0\r\nDataType = 7\r\n"
      "CheckType = 0\r\n*\r\n";
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column)
      text += fmt::format("{:.6f}\r\n", micrometres(row, column));
  return text + "*\r\n*\r\n";
}

TEST(SdfOfAnyMaker, IsKnownByItsHeader) {
  for (const char* version :
       {"aNPL-V1.0", "aBC-1.0", "aBCR - 1.0", "aISO-1.0", "aEUR-15178", "AIM-2"})
    expectKnown(read(textSdf(version)), "sdf", false, 1e-15);
  for (const char* name : {"NPL", "NIS", "EUR"})
    for (const bool second : {false, true}) {
      expectKnown(read(binarySdf<std::int16_t>(5, true, second, name)), "sdf", true, 1e-15);
      expectKnown(read(binarySdf<double>(7, false, second, name)), "sdf", false, 1e-20);
    }
}

TEST(SdfOfAnyMaker, HasShortCountsWhereTheyAloneArePossible) {
  std::string bytes = binarySdf<double>(7, true);
  bytes.replace(0, 8, "bISO-2.0");
  expectKnown(read(bytes), "sdf", true, 1e-20);
}

TEST(SdfOfAnyMaker, IsNoText) {
  EXPECT_THAT(errorOf("a table\nof words\n"), HasSubstr("no rows of numbers"));
  // Bytes that begin with b, but have no dates.
  EXPECT_NE(errorOf("bananas " + std::string(200, '\0')), "no error");
}

// ---- SMD and PRF -------------------------------------------------------------------------------

TEST(SmdFile, ReadsEveryForm) {
  for (const SmdForm form : {SmdForm::Steps, SmdForm::Spacing, SmdForm::Pairs, SmdForm::Sections,
                             SmdForm::WithoutEnds}) {
    const MeasuredFile file = read(smd(form));
    expectKnown(file, "smd", false, 1e-15, 1e-9, 1);
    EXPECT_EQ(file.facts.heightUnit.source, UnitSource::File);
  }
}

TEST(SmdFile, NamesWhatIsWrong) {
  const std::string good = smd(SmdForm::Spacing);
  EXPECT_THAT(errorOf(replaced(good, "SPACING", "SPEEDING")),
              HasSubstr("surface.point_spacing: is needed"));
  EXPECT_THAT(errorOf(replaced(good, " UM ", " V ")),
              HasSubstr("'V', which is not a unit of length"));
  EXPECT_THAT(errorOf(replaced(good, "7.000000e+00", "8.000000e+00")), HasSubstr("7 points"));
  EXPECT_THAT(errorOf(replaced(good, "-2000000\r\n", "")), HasSubstr("ends after 6 of 7 heights"));
  EXPECT_THAT(errorOf(replaced(good, "-2000000\r\n", "two\r\n")),
              HasSubstr("height 1 is not a number"));
  EXPECT_THAT(errorOf(replaced(good, "EOR\r\nEOF", "1\r\nEOR\r\nEOF")), HasSubstr("8 numbers"));
  const std::string huge = replaced(good, "7.000000e+00", "9.000000e+30");
  EXPECT_THAT(errorOf(huge), HasSubstr("from 1 to"));
  const std::string many =
      replaced(replaced(good, "7.000000e+00", "6.000000e+07"), "7.000000e+00", "6.000000e+07");
  EXPECT_THAT(errorOf(many), HasSubstr("ends too early"));
  const std::string area = replaced(good, "CZ M", "CY M 7.0 MM 1.0 D\r\nCZ M");
  EXPECT_THAT(errorOf(area), HasSubstr("has an axis CY"));
  for (const SmdForm form : {SmdForm::Steps, SmdForm::Pairs}) expectCutOffIsNoHarm(smd(form));
}

// ---- Zygo --------------------------------------------------------------------------------------

/// The known surface with square pixels.
void expectKnownOfSquares(const MeasuredFile& file, bool withGap, double tolerance) {
  MeasuredFile stretched = file;
  EXPECT_NEAR(file.topography.rowSpacing, kColumnSpacing, 1e-12 * kColumnSpacing);
  stretched.topography.rowSpacing *= kRowSpacing / kColumnSpacing;
  expectKnown(stretched, "zygo", withGap, tolerance);
}

TEST(ZygoFile, ReadsPoints) {
  ZygoOptions options;
  expectKnownOfSquares(read(zygo(options)), false, 1e-15);
  options.withGap = true;
  options.left = 12;
  options.top = 300;
  expectKnownOfSquares(read(zygo(options)), true, 1e-15);
  options.leavesGapOut = true;
  expectKnownOfSquares(read(zygo(options)), true, 1e-15);
}

TEST(ZygoFile, ReadsPhases) {
  ZygoOptions options;
  options.hasPoints = false;
  for (const bool gap : {false, true})
    for (const int resolution : {0, 1, 2}) {
      options.withGap = gap;
      options.phaseResolution = resolution;
      // Half a step of the whole numbers.
      const double step = 0.5 * 6.328e-7 * 1.02 / (resolution == 0 ? 4096 : 32768);
      expectKnownOfSquares(read(zygo(options)), gap, 0.51 * step);
    }
}

TEST(ZygoFile, ReadsBinaryPhases) {
  ZygoOptions options;
  for (const int format : {1, 2, 3})
    for (const int resolution : {0, 1, 2}) {
      options.withGap = format == 2;
      options.phaseResolution = resolution;
      const double step = 0.5 * 6.328e-7 * 1.02 / (resolution == 0 ? 4096 : 32768);
      MeasuredFile file = read(binaryZygo(options, format));
      // Sizes of pixels and wavelengths have seven digits.
      EXPECT_NEAR(file.topography.columnSpacing / kColumnSpacing, 1, 1e-6);
      file.topography.columnSpacing = file.topography.rowSpacing = kColumnSpacing;
      expectKnownOfSquares(file, options.withGap, 0.51 * step + 1e-12);
    }
  EXPECT_THAT(errorOf(binaryZygo(options).substr(0, 900)), HasSubstr("ends too early"));
  options.phaseResolution = 3;
  EXPECT_THAT(errorOf(binaryZygo(options)), HasSubstr("PhaseRes 3 is not known"));
  options.phaseResolution = 0;
  options.pixel = 0;
  EXPECT_THAT(errorOf(binaryZygo(options)), HasSubstr("surface.point_spacing: is needed"));
  options.pixel = kColumnSpacing;
  expectCutOffIsNoHarm(binaryZygo(options));
}

TEST(ZygoFile, NamesWhatIsWrong) {
  ZygoOptions options;
  options.pixel = 0;
  EXPECT_THAT(errorOf(zygo(options)), HasSubstr("surface.point_spacing: is needed"));
  ReadingChoices choices;
  choices.spacing = kColumnSpacing;
  expectKnownOfSquares(read(zygo(options), choices), false, 1e-15);
  options.pixel = kColumnSpacing;
  const std::string good = zygo(options);
  EXPECT_THAT(errorOf(replaced(good, "0 0 -2.0", "9 0 -2.0")), HasSubstr("the pixel 9 0"));
  EXPECT_THAT(errorOf(replaced(good, "0 0 -2.000000", "0 0 x")),
              HasSubstr("height is not a number"));
  EXPECT_THAT(errorOf(replaced(good, "6 3 ", "5 3 ")), HasSubstr("already"));
  EXPECT_THAT(errorOf(good.substr(0, good.size() - 40)), HasSubstr("ends after"));
  EXPECT_THAT(errorOf(replaced(good, "0 0 7 4\n", "0 0 70000 40000\n")), HasSubstr("at most"));
  EXPECT_THAT(errorOf(replaced(good, "0 0 7 4\n", "0 0 7000 4000\n")), HasSubstr("ends too early"));
  EXPECT_THAT(errorOf(replaced(good, "0 0 7 4\n", "0 0 7.5 4\n")), HasSubstr("line 4"));
  EXPECT_THAT(errorOf(replaced(good, "0 0 7 4\n", "0\n")),
              HasSubstr("line 4: number 3 is missing"));
  expectCutOffIsNoHarm(good);
  options.hasPoints = false;
  expectCutOffIsNoHarm(zygo(options));
}

// ---- Wyko --------------------------------------------------------------------------------------

TEST(WykoFile, ReadsNanometresAndWaves) {
  for (const bool gap : {false, true})
    for (const bool inWaves : {false, true})
      for (const double mult : {1.0, 2.0, 3200.0}) {
        WykoOptions options;
        options.withGap = gap;
        options.inWaves = inWaves;
        options.mult = mult;
        expectKnown(read(wyko(options)), "wyko", gap, 1e-15, 1e-12);
      }
}

TEST(WykoFile, NamesWhatIsWrong) {
  WykoOptions options;
  options.pixel = "";
  EXPECT_THAT(errorOf(wyko(options)), HasSubstr("surface.point_spacing: is needed"));
  options.pixel = "0.002";
  const std::string good = wyko(options);
  EXPECT_THAT(errorOf(replaced(good, "X Size", "Size")), HasSubstr("no X Size"));
  EXPECT_THAT(errorOf(replaced(good, "X Size\t7", "X Size\t-7")), HasSubstr("X Size"));
  EXPECT_THAT(errorOf(replaced(good, "X Size\t7", "X Size\t70000000")), HasSubstr("at most"));
  EXPECT_THAT(errorOf(replaced(good, "X Size\t7", "X Size\t7000000")), HasSubstr("ends too early"));
  EXPECT_THAT(errorOf(replaced(good, "RAW_DATA", "Intensity")), HasSubstr("no block of heights"));
  options.inWaves = true;
  EXPECT_THAT(errorOf(replaced(wyko(options), "Wavelength", "Wave")), HasSubstr("no Wavelength"));
  expectCutOffIsNoHarm(wyko(options));
}

// ---- Surfer ------------------------------------------------------------------------------------

TEST(SurferGrid, ReadsEveryForm) {
  for (const bool gap : {false, true})
    for (const SurferForm form : {SurferForm::Text, SurferForm::Short, SurferForm::Sections}) {
      const std::string bytes = surfer(form, gap);
      expectKnown(read(bytes, inMicrometres()), "surfer", gap, 1e-12, 1e-12);
      EXPECT_THAT(errorOf(bytes), HasSubstr("surface.position_unit: is needed"));
      expectCutOffIsNoHarm(bytes, inMicrometres());
    }
}

TEST(SurferGrid, HasOneNumberForBlanksInItsSecondVersion) {
  const MeasuredFile file = read(surfer(SurferForm::Sections, true, 2), inMicrometres());
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column)
      EXPECT_EQ(std::isnan(file.topography.at(row, column)),
                isGap(row, column) || micrometres(row, column) == 0.625)
          << row << " " << column;
}

TEST(SurferGrid, NamesWhatIsWrong) {
  const std::string good = surfer(SurferForm::Text, false);
  const ReadingChoices um = inMicrometres();
  EXPECT_THAT(errorOf(replaced(good, "7 4", "6 4"), um), HasSubstr("more than the 24 heights"));
  EXPECT_THAT(errorOf(replaced(good, "7 4", "7 5"), um), HasSubstr("ends after 28 of 35"));
  EXPECT_THAT(errorOf(replaced(good, "7 4", "70000 50000"), um), HasSubstr("at most"));
  EXPECT_THAT(errorOf(replaced(good, "7 4", "7000 5000"), um), HasSubstr("ends too early"));
  EXPECT_THAT(errorOf(replaced(good, "7 4", "x 4"), um), HasSubstr("nx"));
  EXPECT_THAT(errorOf(replaced(good, "0 12", "0 0"), um), HasSubstr("no length above 0"));
}

// ---- Headers of matrices and profiles ----------------------------------------------------------

std::string rowsOf(const std::string& before, const std::string& between,
                   const std::string& after) {
  std::string text;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column)
      text += (column > 0 ? between : before) + fmt::format("{:.9g}", micrometres(row, column));
    text += after + "\n";
  }
  return text;
}

TEST(MatrixHeaders, OfKeyenceStateTheStep) {
  const std::string body = rowsOf("\"", "\",\"", "\"");
  for (const char* key : {"XY Calibration", "XY-Justierung"}) {
    const MeasuredFile file = read(
        fmt::format("\"Model\",\"VK-X1000\"\n\"{}\",\"2000.000\",\"nm\"\n\"Horizontal\",\"7\"\n"
                    "\"Vertical\",\"4\"\n\"Unit\",\"\u00B5m\"\n\n\"Height\"\n",
                    key) +
        body);
    EXPECT_NEAR(file.topography.columnSpacing, 2e-6, 1e-18);
    EXPECT_NEAR(file.topography.rowSpacing, 2e-6, 1e-18);
    EXPECT_NEAR(file.topography.at(1, 2), height(1, 2), 1e-15);
  }
}

TEST(MatrixHeaders, WithTheUnitOfHeightsAloneGiveNoStep) {
  const std::string text = "Unit: um\n\n" + rowsOf("", "\t", "");
  EXPECT_THAT(errorOf(text), HasSubstr("surface.point_spacing: is needed"));
  EXPECT_THAT(errorOf("Unit: um\n1\n2\n1\n3\n"), HasSubstr("surface.point_spacing: is needed"));
  ReadingChoices choices;
  choices.spacing = kColumnSpacing;
  EXPECT_NEAR(read(text, choices).topography.columnSpacing, kColumnSpacing, 1e-18);
  EXPECT_NEAR(read(text, choices).topography.at(1, 2), height(1, 2), 1e-15);
}

TEST(MatrixHeaders, StateStepsByTheirUsualNames) {
  const std::string body = rowsOf("", "\t", "");
  for (const char* header :
       {"X increment: 2 um\nY increment: 5 um\n",
        "Schrittweite X: 2 um\nSchrittweite Y: 0.005 mm\n",
        "Pixelbreite: 2 um\nPixelh\u00F6he: 5 um\n", "X pitch\t2\tum\nY pitch\t5\tum\n",
        "XStep=2um\nYStep=5um\n", "DeltaX 2 um\nDeltaY 5 um\n", "Pas X : 2 um\nPas Y : 5 um\n",
        "Pixel size: 2 um x 5 um\n", "Pixel size (um): 2 x 5\n", "Field of view: 14 um x 20 um\n",
        "Scan size: 14 x 20 um\n", "14 um x 20 um\n",
        "Width: 7\nHeight: 4\nX step: 2 um\nY step: 5 um\n",
        "Width: 14 um\nX step: 2 um\nY step: 5 um\n",
        "X size: 12 um\nX step: 2 um\nY step: 5 um\n"})
    expectKnown(read(header + ("Z unit: um\n" + body)), "matrix", false, 1e-15);
  const MeasuredFile bare =
      read("Width: 7\nHeight: 4\nXY unit: um\nZ unit: um\nPixel size: 2\n" + body);
  EXPECT_NEAR(bare.topography.columnSpacing, 2e-6, 1e-18);
  EXPECT_NEAR(bare.topography.rowSpacing, 2e-6, 1e-18);
}

TEST(MatrixHeaders, WithOtherLengthsGiveNoStep) {
  const std::string body = "Z unit: um\n" + rowsOf("", "\t", "");
  for (const char* header :
       {"Filter lambda s: 2.5 um\nFilter lambda c: 0.8 mm\n", "Stage X: 12.5 mm\nStage Y: 3.5 mm\n",
        "Working distance: 0.5 mm\nHeight: 3 mm\n", "Tip radius: 2 um\nResolution: 0.5 um\n",
        "Sample thickness: 2 mm\nMin height: 1 um\n", "Objective: 50x 10 um\n",
        "Width: 7\nHeight: 4\nXY unit: um\n"})
    EXPECT_THAT(errorOf(header + body), HasSubstr("surface.point_spacing: is needed (in m)"))
        << header;
}

/// The user's distance of the points replaces what the lines above a matrix state.
TEST(PointSpacing, ReplacesAWrongWidth) {
  const std::string text =
      "Width: 30 um\nHeight: 20 um\nX step: 2 um\nZ unit: um\n" + rowsOf("", "\t", "");
  EXPECT_THAT(errorOf(text),
              HasSubstr("a step of 2 \u00B5m and an extent of 30 \u00B5m, which do not "
                        "fit 7 points"));
  ReadingChoices choices;
  choices.spacing = 3e-6;
  const MeasuredFile file = read(text, choices);
  EXPECT_NEAR(file.topography.columnSpacing, 3e-6, 1e-18);
  EXPECT_TRUE(says(file, "surface.point_spacing replaces"));
}

/// Heights alone as Mitutoyo, a Japanese and a French program write them.
TEST(ListHeaders, StateTheStep) {
  const std::string heights = "1\n2\n-1\n0.5\n";
  for (const char* header :
       {"\"Sampling pitch\",\"0.5um\"\n\"Unit\",\"um\"\n\"[Data]\"\n",
        "\u6E2C\u5B9A\u30D4\u30C3\u30C1,0.5,\u03BCm\n\u9AD8\u3055\u5358\u4F4D,\u03BCm\n",
        "Pas : 0,5 \u00B5m\nUnit\u00E9 Z : \u00B5m\n", "Spacing,0.0005,mm\nZ unit,um\n",
        "Traverse length: 1.5 um\nPoints: 4\nUnit: um\n"}) {
    const MeasuredFile file = read(header + heights);
    EXPECT_EQ(file.topography.columns, 4) << header;
    EXPECT_NEAR(file.topography.columnSpacing, 5e-7, 1e-18) << header;
    EXPECT_NEAR(file.topography.at(0, 2), -1e-6, 1e-18) << header;
  }
  EXPECT_THAT(errorOf("Traverse length: 1.5 um\nPoints: 5\nUnit: um\n" + heights),
              HasSubstr("surface.point_spacing: is needed"));
}

TEST(MatrixHeaders, OfMountainsMapHaveCountAndLength) {
  const std::string text =
      "Axis X\t7\t12.00 \u00B5m\nAxis Y\t4\t15.00 \u00B5m\n" + rowsOf("", "\t", "");
  ReadingChoices choices;
  choices.heightUnit = "um";
  expectKnown(read(text, choices), "matrix", false, 1e-15);
  EXPECT_EQ(read(text, choices).facts.positionUnit.unit, "\u00B5m");
  // Counts that are not those of the numbers say nothing.
  EXPECT_THAT(errorOf(replaced(text, "X\t7", "X\t8"), choices), HasSubstr("is needed"));
}

TEST(MatrixHeaders, OfSpipAreInNanometres) {
  const std::string text =
      "# File Format = ASCII\n# x-pixels = 7\n# y-pixels = 4\n# x-length = 14000\n"
      "# y-length = 20000\n# Bit2nm = 1000\n# Start of Data:\n" +
      rowsOf("", "\t", "");
  expectKnown(read(text), "matrix", false, 1e-15);
  // Version 4.3 writes the unit of the heights in brackets.
  const std::string withUnit =
      replaced(replaced(text, "# Bit2nm = 1000\n", "# z-unit = [\u00B5m]\n# voidpixels =0\n"),
               "14000", "1.40000e+04");
  expectKnown(read(withUnit), "matrix", false, 1e-15);
  EXPECT_THAT(errorOf(replaced(text, "y-pixels = 4", "y-pixels = 5")),
              HasSubstr("the header says 7 x 5 pixels; the file has 7 x 4 numbers"));
}

TEST(MatrixHeaders, OfSpipMarkPixelsWithoutAHeight) {
  const std::string header =
      "# File Format = ASCII\n# x-pixels = 7\n# y-pixels = 4\n# x-length = 14000\n"
      "# y-length = 20000\n# Bit2nm = 1000\n# voidpixels =1\n# Start of Data:\n";
  std::string heights, marks;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const bool gap = isGap(row, column), last = column == kColumns - 1;
      heights += fmt::format("{:.9g}{}", gap ? 99 : micrometres(row, column), last ? "\n" : "\t");
      marks += fmt::format("{}{}", gap ? 0 : 1, last ? "\n" : "\t");
    }
  expectKnown(read(header + heights + marks), "matrix", true, 1e-15);
  EXPECT_THAT(
      errorOf(header + heights),
      HasSubstr("the header says 7 x 4 pixels and as many that mark those without a height; "
                "the file has 7 x 4 numbers"));
}

TEST(PointSpacing, IsNeverIgnoredInSilence) {
  const std::string text = "x (um),z (um)\n0,1\n2,3\n4,1\n6,2\n";
  ReadingChoices choices;
  choices.spacing = 5e-6;
  EXPECT_NEAR(read(text, choices).topography.columnSpacing, 2e-6, 1e-18);
  EXPECT_TRUE(says(read(text, choices), "surface.point_spacing is not used"));
  choices.spacing = 2e-6;
  EXPECT_FALSE(says(read(text, choices), "is not used"));
  EXPECT_TRUE(says(read(gsf(gsfHeader(), false), {.spacing = 1}), "is not used"));
}

// ---- Steps that are missing ---------------------------------------------------------------------

TEST(X3pSteps, AreAskedForWhereNoneIsStated) {
  X3pOptions options;
  options.columnSpacing = std::nan("");
  EXPECT_THAT(errorOf(x3p(options)), HasSubstr("surface.point_spacing: is needed"));
  ReadingChoices choices;
  choices.spacing = kColumnSpacing;
  EXPECT_EQ(read(x3p(options), choices).topography.columnSpacing, kColumnSpacing);
}

TEST(Positions, ThatLeapAreRefused) {
  std::string text = "x (um),z (um)\n";
  for (int i = 0; i < 50; ++i) text += fmt::format("{},{}\n", i, i % 6);
  const std::string first = text;
  for (int i = 0; i < 50; ++i) text += fmt::format("{},{}\n", 1000000 + i, i % 6);
  EXPECT_THAT(errorOf(text), HasSubstr("the positions leap from 49 to 1e+06, 1e+06 times"));
  // A second stretch not far after the first one leaves a gap.
  text = first;
  for (int i = 0; i < 50; ++i) text += fmt::format("{},{}\n", 90 + i, i % 6);
  EXPECT_EQ(read(text).facts.gaps, 40);
  // Steps that grow are no leap.
  text = "x (um),z (um)\n";
  for (int i = 0; i < 50; ++i) text += fmt::format("{:.6g},{}\n", std::pow(1.2, i), i % 6);
  EXPECT_TRUE(read(text).facts.resampled);
}

// ---- Columns and units -------------------------------------------------------------------------

std::string table(const std::string& header, double ofX, double ofZ) {
  std::string text = header + "\n";
  for (int i = 0; i < 30; ++i)
    text += fmt::format("{:.9g}\t{:.9g}\n", 2 * i * ofX, (3 * std::sin(0.7 * i) + 0.1 * i) * ofZ);
  return text;
}

TEST(PositionColumn, IsTheOneThatRisesUniformlyWhateverItsName) {
  for (const char* header :
       {"Profile Path Length [mm]\tDepth [\u00B5m]", "Profile Position (mm)\tProfile Height (um)",
        "Profile [mm]\tSignal [um]", "Raw (mm)\tHeight (um)", "XPosition[mm]\tHeight[um]"}) {
    const MeasuredFile file = read(table(header, 1e-3, 1));
    EXPECT_NEAR(file.topography.columnSpacing, 2e-6, 1e-15) << header;
    EXPECT_NEAR(file.topography.at(0, 1), 1e-6 * (3 * std::sin(0.7) + 0.1), 1e-14) << header;
  }
  // Two curves over the position.
  const MeasuredFile curves =
      read("Position (um)\tY (um)\tY 2 (um)\n0\t1\t5\n1\t2\t4\n2\t1\t7\n3\t3\t6\n");
  EXPECT_EQ(curves.topography.columns, 4);
  EXPECT_NEAR(curves.topography.at(0, 3), 3e-6, 1e-15);
}

TEST(Units, AreKnownAsWordsAndInches) {
  for (const char* header : {"x (Millimeter)\tz (Mikrometer)", "x (millimetres)\tz (microns)"})
    EXPECT_NEAR(read(table(header, 1e-3, 1)).topography.columnSpacing, 2e-6, 1e-15) << header;
  for (const char* unit : {"\u00B5in", "uin", "microinches", "\u00B5inch", "uinches"}) {
    const MeasuredFile file =
        read(table(fmt::format("x (in)\tz ({})", unit), 1 / 25400.0, 1 / 0.0254));
    EXPECT_NEAR(file.topography.columnSpacing, 2e-6, 1e-14) << unit;
    EXPECT_NEAR(file.topography.at(0, 1), 1e-6 * (3 * std::sin(0.7) + 0.1), 1e-14) << unit;
  }
}

TEST(Units, ThatNobodyKnowsAreNamed) {
  EXPECT_THAT(
      errorOf(table("x (mm)\tz (furlong)", 1e-3, 1)),
      HasSubstr(
          "surface.height_unit: is needed (m, mm, \u00B5m, nm, in, mil): the unit 'furlong' of "
          "the file is not known; known are m, cm, mm"));
  EXPECT_THAT(errorOf(table("x (cubit)\tz (um)", 1, 1)), HasSubstr("the unit 'cubit' of the file"));
  EXPECT_THAT(errorOf("z unit: digits\n" + table("x (mm)\tz", 1e-3, 1)),
              HasSubstr("the unit 'digits' of the file"));
  // An unknown unit is no metre, however small the numbers are.
  for (const char* header : {"x (m)\tz (furlong)", "x (m)\tz (V)"})
    EXPECT_THAT(errorOf(table(header, 1e-6, 1e-6)), HasSubstr("surface.height_unit: "));
  EXPECT_THAT(errorOf("Unit: V\n" + table("x (m)\tz", 1e-6, 1e-6)),
              HasSubstr("the unit 'V' of the file is not known"));
  ReadingChoices choices;
  choices.heightUnit = "um";
  EXPECT_NEAR(read(table("x (mm)\tz (furlong)", 1e-3, 1), choices).topography.at(0, 1),
              1e-6 * (3 * std::sin(0.7) + 0.1), 1e-14);
}

TEST(Units, AreKnownInOtherLanguages) {
  for (const char* header :
       {"x (\u043C\u043C)\tz (\u043C\u043A\u043C)", "x (millim\u00E8tres)\tz (microm\u00E8tres)",
        "x (\u6BEB\u7C73)\tz (\u5FAE\u7C73)", "X(mm)\tZ(\x83\xCAm)"}) {
    const MeasuredFile file = read(table(header, 1e-3, 1));
    EXPECT_NEAR(file.topography.columnSpacing, 2e-6, 1e-15) << header;
    EXPECT_NEAR(file.topography.at(0, 1), 1e-6 * (3 * std::sin(0.7) + 0.1), 1e-14) << header;
  }
  EXPECT_NEAR(read(table("x (1/100 mm)\tz (um)", 0.1, 1)).topography.columnSpacing, 2e-6, 1e-15);
}

/// A depth counts into the material, unless the user says that the column holds heights.
TEST(Depth, IsAskedFor) {
  for (const char* name : {"depth_um", "distance sensor to surface (um)", "Abstand [um]"}) {
    const std::string text =
        "x_um," + std::string(name) + "\n0,0\n1,5\n2,0\n3,1\n4,0\n5,0\n6,0\n7,0\n";
    EXPECT_NE(errorOf(text).find("may count into the material; say 2"), std::string::npos)
        << errorOf(text);
  }
  EXPECT_EQ(errorOf("Distance [mm],Height [um]\n0,0\n1,5\n2,0\n3,1\n"), "no error");
}

}  // namespace
}  // namespace asperity::written
