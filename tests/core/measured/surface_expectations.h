// What the tests of the readers expect of a surface that was read.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/input_error.h"
#include "core/measured/measured_file.h"
#include "tests/core/error_from.h"
#include "tests/core/measured/written_surface.h"

namespace asperity::written {

/// What a table without units needs.
inline const ReadingChoices kInMicrometres{.positionUnit = "um", .heightUnit = "um"};

inline MeasuredFile read(const std::string& bytes, const ReadingChoices& choices = {}) {
  return readMeasuredBytes(bytes, "surface.dat", choices);
}

/// The message of the error; "no error" where there is none.
inline std::string errorOf(const std::string& bytes, const ReadingChoices& choices = {}) {
  return errorFrom([&] { read(bytes, choices); });
}

/// Returns whether a note of the reader has this part.
inline bool says(const MeasuredFile& file, const std::string& part) {
  return std::ranges::any_of(file.facts.notes, [&part](const Message& note) {
    return note.english().find(part) != std::string::npos;
  });
}

inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

/// Every beginning of the file is read or refused in one line.
inline void expectCutOffIsNoHarm(const std::string& bytes, const ReadingChoices& choices = {}) {
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const std::string error = errorOf(bytes.substr(0, size), choices);
    EXPECT_EQ(error.find('\n'), std::string::npos) << size;
    EXPECT_LT(error.size(), 400u) << size;
  }
}

/// The known surface, heights within `tolerance` (m), spacings to `relative` of themselves.
inline void expectKnown(const MeasuredFile& file, const std::string& format, bool withGap,
                        double tolerance, double relative = 1e-12, int rows = kRows) {
  const Topography& grid = file.topography;
  EXPECT_EQ(file.facts.format, format);
  ASSERT_EQ(grid.columns, kColumns);
  ASSERT_EQ(grid.rows, rows);
  EXPECT_NEAR(grid.columnSpacing, kColumnSpacing, relative * kColumnSpacing);
  EXPECT_NEAR(grid.rowSpacing, rows > 1 ? kRowSpacing : 0, relative * kRowSpacing);
  EXPECT_EQ(file.facts.points, kColumns * rows);
  EXPECT_EQ(file.facts.gaps, withGap && rows > kGapRow ? 1 : 0);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const double height = written::height(row, column, withGap);
      if (std::isnan(height))
        EXPECT_TRUE(std::isnan(grid.at(row, column)));
      else
        EXPECT_NEAR(grid.at(row, column), height, tolerance)
            << "row " << row << ", column " << column;
    }
  EXPECT_FALSE(file.facts.notes.empty());
}

}  // namespace asperity::written
