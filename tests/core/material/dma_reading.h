// Reading of tables of dynamic moduli as texts.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "core/material/dma_file.h"
#include "tests/core/error_from.h"

namespace asperity {

inline DmaFile read(const std::string& text, const DmaChoices& choices = {}) {
  TextTableOptions options;
  options.keepsTexts = options.readsCells = true;
  return readDmaFile(readTextTable(text, "dma.csv", options), "dma.csv", choices);
}

inline std::string errorOf(const std::string& text, const DmaChoices& choices = {}) {
  return errorFrom([&] { read(text, choices); });
}

inline void expectRow(const MeasuredModulus& row, double kelvin, double hertz, double storage,
                      double loss) {
  EXPECT_NEAR(row.temperature, kelvin, 1e-9);
  EXPECT_NEAR(row.modulus.frequency, hertz, 1e-9 * hertz);
  EXPECT_NEAR(row.modulus.storage, storage, 1e-9 * storage);
  EXPECT_NEAR(row.modulus.loss, loss, 1e-9 * loss);
}

}  // namespace asperity
