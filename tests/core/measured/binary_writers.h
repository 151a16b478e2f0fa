// Writers of binary surfaces, after the descriptions of the formats.
#pragma once

#include <fmt/format.h>

#include <string>

#include "tests/core/measured/written_surface.h"

namespace asperity::written {

// ---- SDF (ISO 25178-71) ------------------------------------------------------------------------

inline constexpr double kSdfScale = 1e-9;  // m, one step of whole numbers: 1 nm

template <class Number>
std::string binarySdf(int dataType, bool withGap, bool second = false, const char* kind = "ISO",
                      int rows = kRows) {
  std::string bytes = fmt::format("b{}-{}", kind, second ? "2.0" : "1.0");
  putText(bytes, "TEST", 10);
  bytes += "010120200000010120200000";
  if (second) {
    put<std::uint32_t>(bytes, kColumns);
    put<std::uint32_t>(bytes, static_cast<std::uint32_t>(rows));
  } else {
    put<std::uint16_t>(bytes, kColumns);
    put<std::uint16_t>(bytes, static_cast<std::uint16_t>(rows));
  }
  // Small types need a coarse step, and unsigned ones a foot.
  const bool isWhole = std::numeric_limits<Number>::is_integer;
  const double scale = !isWhole ? 1.0 : sizeof(Number) == 1 ? 125e-9 : kSdfScale;
  for (const double number : {kColumnSpacing, kRowSpacing, scale, -1.0}) put(bytes, number);
  bytes += '\0';
  bytes += static_cast<char>(dataType);
  bytes += '\0';
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      if (withGap && isGap(row, column)) {
        put(bytes, std::numeric_limits<Number>::lowest());
        continue;
      }
      const double value = height(row, column) / scale;
      if (isWhole)
        put(bytes, static_cast<Number>(std::lround(value)));
      else
        put(bytes, static_cast<Number>(value));
    }
  return bytes + "<trailer></trailer>";
}

// ---- SUR (Digital Surf) ------------------------------------------------------------------------

struct SurOptions {
  int bits = 32;
  bool withGap = false;
  bool packed = false;
  int type = 2;  // 1: profile
  int rows = kRows;
  std::string xUnit = "mm", yUnit = "mm", zUnit = "\xB5m";
  double xMetres = 1e-3, yMetres = 1e-3, zMetres = 1e-6;
  std::string comment{};
  int objects = 1;
};

inline std::string sur(const SurOptions& options) {
  constexpr double kStep = 1e-9;  // m
  std::string bytes = options.packed ? "DSCOMPRESSED" : "DIGITAL SURF";
  const auto put16 = [&bytes](int value) { put(bytes, static_cast<std::int16_t>(value)); };
  const auto put32 = [&bytes](std::int64_t value) { put(bytes, static_cast<std::int32_t>(value)); };
  const auto putFloat = [&bytes](double value) { put(bytes, static_cast<float>(value)); };
  put16(0);
  put16(options.objects);
  put16(1);
  put16(options.type);
  putText(bytes, "known surface", 30);
  putText(bytes, "test", 30);
  put16(0);
  put16(0);
  put16(0);
  put16(options.withGap ? 1 : 0);
  put16(1);
  bytes.append(8, '\0');
  put16(options.bits);
  std::int64_t lowest = INT32_MAX, highest = INT32_MIN;
  std::vector<std::int64_t> points;
  for (int row = 0; row < options.rows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      points.push_back(std::lround(height(row, column) / kStep));
      lowest = std::min(lowest, points.back());
      highest = std::max(highest, points.back());
    }
  put32(lowest);
  put32(highest);
  put32(kColumns);
  put32(options.rows);
  put32(kColumns * options.rows);
  putFloat(kColumnSpacing / options.xMetres);
  putFloat(kRowSpacing / options.yMetres);
  putFloat(kStep / options.zMetres);
  for (const char* name : {"X", "Y", "Z"}) putText(bytes, name, 16);
  for (const std::string& unit : {options.xUnit, options.yUnit, options.zUnit})
    putText(bytes, unit, 16);
  for (const char* unit : {"km", "km", "km"}) putText(bytes, unit, 16);  // of lengths, not of steps
  for (int i = 0; i < 3; ++i) putFloat(1e6);
  bytes.append(6 + 12 + 14 + 4 + 10, '\0');
  put16(static_cast<int>(options.comment.size()));
  put16(4);
  bytes.resize(512, '\0');
  bytes += options.comment + "PRIV";
  std::string data;
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    const bool gap = options.withGap && isGap(i / kColumns, i % kColumns);
    const std::int64_t value = gap ? lowest - 2 : points[static_cast<std::size_t>(i)];
    if (options.bits == 16)
      put(data, static_cast<std::int16_t>(value));
    else
      put(data, static_cast<std::int32_t>(value));
  }
  if (!options.packed) return bytes + data;
  // Two streams.
  const std::size_t half = data.size() / 2;
  std::string table, streams;
  put<std::uint32_t>(table, 2);
  for (const std::string& part : {data.substr(0, half), data.substr(half)}) {
    std::string packed(compressBound(part.size()), '\0');
    uLongf size = packed.size();
    compress(reinterpret_cast<Bytef*>(packed.data()), &size,
             reinterpret_cast<const Bytef*>(part.data()), part.size());
    put(table, static_cast<std::uint32_t>(part.size()));
    put(table, static_cast<std::uint32_t>(size));
    streams += packed.substr(0, size);
  }
  return bytes + table + streams;
}

// ---- GSF ---------------------------------------------------------------------------------------

inline std::string gsf(const std::string& header, bool withGap) {
  std::string bytes = "Gwyddion Simple Field 1.0\n" + header;
  bytes.append(4 - bytes.size() % 4, '\0');
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column)
      put(bytes, static_cast<float>(height(row, column, withGap)));
  return bytes;
}

inline std::string gsfHeader() {
  return fmt::format(
      "XRes = {}\nYRes = {}\nXReal = {}\nYReal = {}\nXYUnits = m\nZUnits = m\nTitle = Height\n",
      kColumns, kRows, kColumns * kColumnSpacing, kRows * kRowSpacing);
}

// ---- GWY ---------------------------------------------------------------------------------------

inline std::string gwyText(const std::string& name, const std::string& value) {
  return name + '\0' + 's' + value + '\0';
}
inline std::string gwyInt(const std::string& name, std::int32_t value) {
  std::string bytes = name + '\0' + 'i';
  put(bytes, value);
  return bytes;
}
inline std::string gwyDouble(const std::string& name, double value) {
  std::string bytes = name + '\0' + 'd';
  put(bytes, value);
  return bytes;
}
inline std::string gwyObject(const std::string& type, const std::string& components) {
  std::string bytes = type + '\0';
  put(bytes, static_cast<std::uint32_t>(components.size()));
  return bytes + components;
}
inline std::string gwyMember(const std::string& name, const std::string& object) {
  return name + '\0' + 'o' + object;
}

/// zUnit "V": not heights. scale multiplies the heights.
inline std::string gwyField(const std::string& zUnit, double scale = 1, bool mask = false) {
  std::string data = std::string("data") + '\0' + 'D';
  put(data, static_cast<std::uint32_t>(kColumns * kRows));
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column)
      put(data, mask ? (isGap(row, column) ? 1.0 : 0.0) : scale * height(row, column));
  const auto unit = [](const std::string& name, const std::string& text) {
    return gwyMember(name, gwyObject("GwySIUnit", gwyText("unitstr", text)));
  };
  return gwyObject("GwyDataField", gwyInt("xres", kColumns) + gwyInt("yres", kRows) +
                                       gwyDouble("xreal", kColumns * kColumnSpacing) +
                                       gwyDouble("yreal", kRows * kRowSpacing) +
                                       unit("si_unit_xy", "m") + unit("si_unit_z", zUnit) + data);
}

inline std::string gwy(const std::string& components) {
  return "GWYP" + gwyObject("GwyContainer", components);
}

/// A channel of volts, the heights, and twice the heights.
inline std::string gwyOfThree(bool withMask = false) {
  std::string components =
      gwyMember("/0/data", gwyField("V")) + gwyText("/0/data/title", "Current") +
      gwyMember("/2/data", gwyField("m", 2)) + gwyText("/2/data/title", "Twice") +
      gwyMember("/1/data", gwyField("m")) + gwyText("/1/data/title", "Height");
  if (withMask) components += gwyMember("/1/mask", gwyField("", 1, true));
  return gwy(components);
}

// ---- NPY (NumPy) -------------------------------------------------------------------------------

/// The known surface as an array of NumPy in micrometres, or of whole numbers in nanometres.
template <class Number>
std::string npy(const std::string& type, int version = 1, bool isFortran = false,
                bool withGap = false, const std::string& shape = {}) {
  const bool isWhole = std::numeric_limits<Number>::is_integer;
  std::string header = fmt::format(
      "{{'descr': '{}', 'fortran_order': {}, 'shape': {}, }}", type, isFortran ? "True" : "False",
      shape.empty() ? fmt::format("({}, {})", kRows, kColumns) : shape);
  while ((header.size() + 11) % 16 != 0) header += ' ';
  header += '\n';
  std::string bytes = "\x93NUMPY";
  bytes += static_cast<char>(version);
  bytes += '\0';
  if (version == 1)
    put(bytes, static_cast<std::uint16_t>(header.size()));
  else
    put(bytes, static_cast<std::uint32_t>(header.size()));
  bytes += header;
  const auto add = [&](int row, int column) {
    const double value = micrometres(row, column) * (isWhole ? 1e3 : 1);
    const double written =
        withGap && isGap(row, column) ? std::numeric_limits<double>::quiet_NaN() : value;
    if constexpr (std::numeric_limits<Number>::is_integer)
      put(bytes, static_cast<Number>(std::lround(written)), type.front() == '>');
    else
      put(bytes, static_cast<Number>(written), type.front() == '>');
  };
  if (isFortran)
    for (int column = 0; column < kColumns; ++column)
      for (int row = 0; row < kRows; ++row) add(row, column);
  else
    for (int row = 0; row < kRows; ++row)
      for (int column = 0; column < kColumns; ++column) add(row, column);
  return bytes;
}

}  // namespace asperity::written
