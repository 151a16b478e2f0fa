// Reads texts as ready Prony series, and what is expected of them.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "core/base/input_error.h"
#include "core/material/prony_file.h"
#include "tests/core/error_from.h"

namespace asperity {

inline std::optional<PronyFile> readSeries(const std::string& text,
                                           const PronyChoices& choices = {}) {
  std::optional<TextTable> table;
  try {
    TextTableOptions options;
    options.keepsTexts = options.readsCells = true;
    table = readTextTable(text, "prony.txt", options);
  } catch (const InputError&) {
    table.reset();  // no table, as keywords are none
  }
  return readPronyFile(text, table ? &*table : nullptr, "prony.txt", choices);
}

inline std::string seriesError(const std::string& text, const PronyChoices& choices = {}) {
  return errorFrom([&] { readSeries(text, choices); });
}

/// G_0 = 4 MPa: G_i = 2 and 1 MPa at 0.1 and 10 s, 1 MPa is left. timeTolerance: s.
inline void expectSeries(const std::optional<PronyFile>& file, double timeTolerance = 0) {
  ASSERT_TRUE(file.has_value());
  EXPECT_NEAR(file->equilibriumModulus, 1e6, 1e-3);
  ASSERT_EQ(file->arms.size(), 2U);
  EXPECT_NEAR(file->arms[0].modulus, 1e6, 1e-3);
  EXPECT_NEAR(file->arms[0].relaxationTime, 10, timeTolerance);
  EXPECT_NEAR(file->arms[1].modulus, 2e6, 1e-3);
  EXPECT_NEAR(file->arms[1].relaxationTime, 0.1, timeTolerance);
}

/// The same where times are quotients or powers of ten.
inline void expectSeriesNearly(const std::optional<PronyFile>& file) {
  expectSeries(file, 1e-9);
}

inline PronyChoices atKelvin(double temperature) {
  PronyChoices choices;
  choices.temperature = temperature;
  return choices;
}

inline std::vector<std::string> seriesNotes(const std::optional<PronyFile>& file) {
  std::vector<std::string> notes;
  for (const Message& note : file->notes) notes.push_back(note.english());
  return notes;
}

}  // namespace asperity
