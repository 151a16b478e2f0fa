// Writers of the text files of instruments, and of Surfer's grids, after the descriptions of the
// formats.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "tests/core/measured/written_surface.h"

namespace asperity::written {

// ---- SMD and PRF (ISO 5436-2) ------------------------------------------------------------------

enum class SmdForm {
  Steps,        // SMD: incremental x, records end with ETX, texts with a zero byte
  Spacing,      // PRF: the step stands after SPACING, records end with EOR
  Pairs,        // x and z in each line
  Sections,     // all x, then all z
  WithoutEnds,  // SMD whose ends of records were lost
};

/// The first row of the known surface: x in millimetres, z in whole picometres of micrometres.
inline std::string smd(SmdForm form) {
  const bool isPrf = form != SmdForm::Steps && form != SmdForm::WithoutEnds;
  const std::string end = form == SmdForm::Steps ? "\x03\r\n" : isPrf ? "EOR\r\n" : "\r\n";
  const std::string zero = form == SmdForm::Steps ? std::string(1, '\0') : "";
  std::string text;
  if (isPrf) {
    text = fmt::format(
               "1 2\r\nSG2004 0.000000e+000 PRF\r\nCX M {0:e} MM 1.000000e+000 D\r\n"
               "CZ M {0:e} UM 1.000000e-006 L\r\n",
               static_cast<double>(kColumns)) +
           end + "STYLUS_RADIUS 2.000000e-003 MM\r\n";
    if (form == SmdForm::Spacing) text += fmt::format("SPACING CX {:e}\r\n", 1e3 * kColumnSpacing);
    text += "COMMENT 3 rows of text\r\n" + end;
  } else {
    text = "ISO 5436-2:2012" + zero + "known" + zero + "\r\nPRF" + zero + " 1 ISO5436" + zero +
           "\r\nCX" + zero + " I" + zero + fmt::format(" {} mm", kColumns) + zero + " 1.0e0 D" +
           zero + fmt::format(" {:e} \r\n", 1e3 * kColumnSpacing) + "CZ" + zero + " A" + zero +
           fmt::format(" {} um", kColumns) + zero + " 1.0e-6 D" + zero + "\r\n" + end +
           "DATE: 01-January-2020" + zero + "\r\nCREATED_BY nobody" + zero + "\r\n" + end;
  }
  const auto z = [](int i) { return fmt::format("{}", std::llround(1e6 * micrometres(0, i))); };
  const auto x = [](int i) { return fmt::format("{:.4f}", 1e3 * kColumnSpacing * i); };
  if (form == SmdForm::Sections)
    for (int i = 0; i < kColumns; ++i) text += x(i) + "\r\n";
  for (int i = 0; i < kColumns; ++i)
    text += (form == SmdForm::Pairs ? x(i) + " " : "") + z(i) + "\r\n";
  if (form == SmdForm::WithoutEnds) return text;
  return text + end + (isPrf ? "EOF\r\n" : "12345\r\n" + end + "\x1A");
}

// ---- Zygo --------------------------------------------------------------------------------------

struct ZygoOptions {
  bool hasPoints = true;  // the XYZ file; else the ASCII file of phases
  bool withGap = false, leavesGapOut = false;
  int left = 0, top = 0;  // pixels
  double pixel = kColumnSpacing;
  int phaseResolution = 1;
};

/// The known surface; its steps along y are those along x.
inline std::string zygo(const ZygoOptions& options) {
  constexpr double kScale = 0.5, kWavelength = 6.328e-7, kObliquity = 1.02;
  std::string text = fmt::format(
      "Zygo {} Data File - Format {}\n1 8 1 5 \"Tue Aug 25 16:59:23 2020\"\n0 0 {} {} 1 255\n"
      "{} {} {} {}\n\"a comment\"\n\"\"\n\n0 {} {} 0.3 {} 0 {} 1598374763\n"
      "1024 1024 2 0 0 666 \"10X Mirau\"\n0 0 1 33 0 0 0.1 60.4 2 50\n{} 1 100 0 0 0 0 0 0\n"
      "0 \"\"\n1.5 0\n{}#\n",
      options.hasPoints ? "XYZ" : "ASCII", options.hasPoints ? 1 : 2, kColumns, kRows, options.left,
      options.top, kColumns, kRows, kScale, kWavelength, kObliquity, options.pixel,
      options.phaseResolution, options.hasPoints ? "" : "\"\"\n");
  if (!options.hasPoints) {  // intensities
    for (int i = 0; i < kColumns * kRows; ++i) text += fmt::format("{} ", 100 + i);
    text += "\n#\n";
  }
  const double steps = options.phaseResolution == 0   ? 4096
                       : options.phaseResolution == 1 ? 32768
                                                      : 131072;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const bool gap = options.withGap && isGap(row, column);
      if (!options.hasPoints) {
        const double phase = height(row, column) / (kScale * kWavelength * kObliquity) * steps;
        text += fmt::format("{}{}", gap ? 2147483640 : std::llround(phase),
                            column % 3 == 2 ? "\n" : " ");
      } else if (!(gap && options.leavesGapOut)) {
        text += fmt::format("{} {} {}\n", column + options.left, row + options.top,
                            gap ? "No Data" : fmt::format("{:.6f}", micrometres(row, column)));
      }
    }
  return text + "\n#\n";
}

/// The same phases in a binary file, of format 1 to 3, after intensities of one bucket.
inline std::string binaryZygo(const ZygoOptions& options, int format = 1) {
  constexpr double kScale = 0.5, kWavelength = 6.328e-7, kObliquity = 1.02;
  const std::size_t size = format == 3 ? 4096 : 834;
  std::string header;
  const auto putAt = [&header](std::size_t place, auto number) {
    header.resize(place);
    put(header, number, true);
  };
  putAt(0, static_cast<std::uint32_t>(0x881B036E + format));
  putAt(4, static_cast<std::int16_t>(format));
  putAt(6, static_cast<std::int32_t>(size));
  for (const auto& [place, number] :
       {std::pair{52, 5}, {54, 3}, {56, 1}, {68, kColumns}, {70, kRows}})
    putAt(static_cast<std::size_t>(place), static_cast<std::int16_t>(number));
  for (const auto& [place, number] :
       {std::pair{164, kScale}, {168, kWavelength}, {176, kObliquity}, {184, options.pixel}})
    putAt(static_cast<std::size_t>(place), static_cast<float>(number));
  putAt(218, static_cast<std::int16_t>(options.phaseResolution));
  header.resize(size);
  std::string bytes = header + std::string(5 * 3 * 2, '\x11');
  const double steps = options.phaseResolution == 0   ? 4096
                       : options.phaseResolution == 1 ? 32768
                                                      : 131072;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const double phase = height(row, column) / (kScale * kWavelength * kObliquity) * steps;
      const bool gap = options.withGap && isGap(row, column);
      put(bytes, static_cast<std::int32_t>(gap ? 2147483640 : std::llround(phase)), true);
    }
  return bytes;
}

// ---- Wyko --------------------------------------------------------------------------------------

struct WykoOptions {
  bool withGap = false;
  bool inWaves = false;
  double mult = 1;
  std::string pixel = "0.002";  // mm
};

inline std::string wyko(const WykoOptions& options) {
  constexpr double kWavelength = 632.8;  // nm
  std::string text = fmt::format(
      "Wyko ASCII Data File Format 0\t{}\t1\nX Size\t{}\nY Size\t{}\n"
      "Block Name\tType\tLength\tValue\nTitle\t5\t20\tknown surface\n",
      options.inWaves ? 0 : 1, kColumns, kRows);
  if (!options.pixel.empty()) text += "Pixel_size\t7\t4\t" + options.pixel + "\n";
  text +=
      fmt::format("Wavelength\t7\t4\t{}\nMult\t6\t2\t{}\nAspect\t7\t4\t{}\nRAW_DATA\t3\t112\t\n",
                  kWavelength, options.mult, kRowSpacing / kColumnSpacing);
  for (int column = 0; column < kColumns; ++column) {
    for (int row = 0; row < kRows; ++row) {
      const double nanometres = 1e9 * height(row, column);
      const double number = options.inWaves ? nanometres / kWavelength * options.mult : nanometres;
      text += (row > 0 ? "\t" : "") +
              (options.withGap && isGap(row, column) ? "Bad" : fmt::format("{:.9f}", number));
    }
    text += "\n";
  }
  return text;
}

// ---- Surfer ------------------------------------------------------------------------------------

enum class SurferForm { Text, Short, Sections };

/// In micrometres, which the file does not state.
inline std::string surfer(SurferForm form, bool withGap, std::uint32_t version = 1) {
  constexpr double kBlank = 1.70141e38;
  const double lastX = 2.0 * (kColumns - 1), lastY = 5.0 * (kRows - 1);
  const auto number = [&](int row, int column) {
    return withGap && isGap(row, column) ? kBlank : micrometres(row, column);
  };
  std::string bytes;
  if (form == SurferForm::Text) {
    bytes =
        fmt::format("DSAA\r\n{} {}\r\n0 {}\r\n0 {}\r\n-10 10\r\n", kColumns, kRows, lastX, lastY);
    for (int row = 0; row < kRows; ++row) {
      for (int column = 0; column < kColumns; ++column)
        bytes += fmt::format("{:.9g}{}", number(row, column), column % 4 == 3 ? "\r\n" : " ");
      bytes += "\r\n\r\n";
    }
    return bytes;
  }
  if (form == SurferForm::Short) {
    bytes = "DSBB";
    put<std::int16_t>(bytes, kColumns);
    put<std::int16_t>(bytes, kRows);
    for (const double one : {0.0, lastX, 0.0, lastY, -10.0, 10.0}) put(bytes, one);
    for (int row = 0; row < kRows; ++row)
      for (int column = 0; column < kColumns; ++column)
        put(bytes, static_cast<float>(number(row, column)));
    return bytes;
  }
  const double blank = version == 1 ? kBlank : 0.625;  // a number among the heights
  bytes = "DSRB";
  put<std::uint32_t>(bytes, 4);
  put<std::uint32_t>(bytes, version);
  bytes += "FLTI";
  put<std::uint32_t>(bytes, 3);
  bytes += "abcGRID";
  put<std::uint32_t>(bytes, 72);
  put<std::int32_t>(bytes, kRows);
  put<std::int32_t>(bytes, kColumns);
  for (const double one : {0.0, 0.0, 2.0, 5.0, -10.0, 10.0, 0.0, blank}) put(bytes, one);
  bytes += "DATA";
  put<std::uint32_t>(bytes, kColumns * kRows * 8);
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) put(bytes, number(row, column));
  return bytes;
}

}  // namespace asperity::written
