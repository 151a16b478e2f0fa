// A writer of X3P (ISO 25178-72) in all its variants.
#pragma once

#include <fmt/format.h>

#include <string>

#include "tests/core/measured/written_surface.h"

namespace asperity::written {

struct X3pOptions {
  std::string feature = "SUR";
  char zType = 'D';  // I, L, F, D
  bool zIncremental = false;
  bool absoluteX = false, absoluteY = false;
  bool listed = false;  // heights in main.xml
  bool withGap = false;
  bool maskFile = false;  // the gap by a file of bits; else by NaN or an empty datum
  bool packed = true;
  bool checksums = true;
  bool upperCase = false;  // of checksums
  int rows = kRows;
  std::string prefix = "p:";  // of the namespace
  std::string prologue{};     // after the XML declaration
  std::string pointMd5{};     // instead of the true one
  std::string mainMd5{};
  int claimedColumns = kColumns, claimedRows = kRows;
  std::string extra{};                    // in Record2
  double columnSpacing = kColumnSpacing;  // as the file states it
  double rowSpacing = kRowSpacing;
  // The file of the heights, as main.xml names it and as the directory of the archive does.
  std::string link = "bindata/data.bin", entry = "bindata/data.bin";
};

struct X3pParts {
  std::string main, points, valid;
};

inline X3pParts x3pParts(const X3pOptions& options) {
  const bool isWhole = options.zType == 'I' || options.zType == 'L';
  const double step = isWhole ? 1e-9 : 1;
  X3pParts parts;
  std::string list;
  parts.valid.assign((static_cast<std::size_t>(kColumns * options.rows) + 7) / 8, '\0');
  for (int row = 0; row < options.rows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const bool gap = options.withGap && isGap(row, column);
      const int point = row * kColumns + column;
      if (!gap)
        parts.valid[static_cast<std::size_t>(point / 8)] =
            static_cast<char>(parts.valid[static_cast<std::size_t>(point / 8)] | 1 << point % 8);
      std::string datum;
      const auto position = [&](double value) {
        put(parts.points, value);
        datum += fmt::format("{};", value);
      };
      if (options.absoluteX) position(column * kColumnSpacing);
      if (options.absoluteY) position(row * kRowSpacing);
      const double value = height(row, column) / step;
      if (options.zType == 'I')
        put(parts.points, static_cast<std::int16_t>(std::lround(value)));
      else if (options.zType == 'L')
        put(parts.points, static_cast<std::int32_t>(std::lround(value)));
      else if (options.zType == 'F')
        put(parts.points, gap && !options.maskFile ? std::nanf("") : static_cast<float>(value));
      else
        put(parts.points, gap && !options.maskFile ? std::nan("") : value);
      datum += isWhole ? fmt::format("{}", std::lround(value)) : fmt::format("{:.9e}", value);
      list += gap ? "<Datum/>" : "<Datum>" + datum + "</Datum>\n";
    }
  const auto axis = [](const std::string& name, bool incremental, char type, double increment) {
    return fmt::format(
        "<{0}><AxisType>{1}</AxisType><DataType>{2}</DataType><Increment>{3}</Increment>"
        "<Offset>0</Offset></{0}>",
        name, incremental ? "I" : "A", type, increment);
  };
  const auto md5Of = [&options](const std::string& given, const std::string& bytes) {
    std::string text = given.empty() ? md5(bytes) : given;
    if (options.upperCase)
      for (char& letter : text)
        if (letter >= 'a' && letter <= 'f') letter = static_cast<char>(letter - 'a' + 'A');
    return text;
  };
  std::string data;
  if (options.listed) {
    data = "<DataList>" + list + "</DataList>";
  } else {
    data = "<DataLink><PointDataLink>" + options.link + "</PointDataLink>";
    if (options.checksums)
      data += "<MD5ChecksumPointData>" + md5Of(options.pointMd5, parts.points) +
              "</MD5ChecksumPointData>";
    if (options.maskFile) {
      data += "<ValidPointsLink>bindata/valid.bin</ValidPointsLink>";
      if (options.checksums)
        data += "<MD5ChecksumValidPoints>" + md5Of("", parts.valid) + "</MD5ChecksumValidPoints>";
    }
    data += "</DataLink>";
  }
  const bool isProfile = options.feature == "PRF";
  const int columns = options.claimedColumns,
            rows = options.rows == kRows ? options.claimedRows : options.rows;
  parts.main = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{0}<{1}ISO5436_2 "
      "xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\">"
      "<Record1><Revision>ISO5436 - "
      "2000</Revision><FeatureType>{2}</FeatureType><Axes>{3}{4}{5}</Axes>"
      "</Record1><Record2><Date>2020-01-01T00:00:00</Date>{6}</Record2><Record3><MatrixDimension>"
      "<SizeX>{7}</SizeX><SizeY>{8}</SizeY><SizeZ>{9}</SizeZ></MatrixDimension>{10}</Record3>"
      "<Record4><ChecksumFile>md5checksum.hex</ChecksumFile></Record4></{1}ISO5436_2>\n",
      options.prologue, options.prefix, options.feature,
      axis("CX", !options.absoluteX, 'D', options.absoluteX ? 0 : options.columnSpacing),
      axis("CY", !options.absoluteY, 'D', options.absoluteY ? 0 : options.rowSpacing),
      axis("CZ", options.zIncremental, options.zType, step), options.extra, columns,
      isProfile ? 1 : rows, isProfile ? rows : 1, data);
  return parts;
}

inline std::string x3pArchive(const X3pOptions& options, const X3pParts& parts) {
  std::vector<ZippedFile> files{{"main.xml", parts.main}};
  if (!options.listed) files.push_back({options.entry, parts.points});
  if (options.maskFile) files.push_back({"bindata/valid.bin", parts.valid});
  if (options.checksums)
    files.push_back(
        {"md5checksum.hex",
         (options.mainMd5.empty() ? md5(parts.main) : options.mainMd5) + " *main.xml\r\n"});
  return zipped(files, options.packed);
}

inline std::string x3p(const X3pOptions& options) {
  return x3pArchive(options, x3pParts(options));
}

}  // namespace asperity::written
