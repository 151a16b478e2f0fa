// The tables of a material.
#include "core/scene/material_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/core/material/shipped_measurements.h"

namespace asperity {
namespace {

TEST(MaterialTables, HaveARowForEverything) {
  const std::string isotherms = isothermsCsv(epdm()), shifts = shiftsCsv(epdm());
  EXPECT_EQ(std::ranges::count(isotherms, '\n'), 211);
  EXPECT_EQ(std::ranges::count(shifts, '\n'), 11);
  EXPECT_EQ(std::ranges::count(pronyCsv(epdm()), '\n'),
            static_cast<std::ptrdiff_t>(2 + epdm().series.arms.size()));
}

}  // namespace
}  // namespace asperity
