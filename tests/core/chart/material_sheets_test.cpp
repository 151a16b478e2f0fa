// A measured rubber as charts, from one isotherm of a standard solid.
#include "core/chart/material_sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace asperity {
namespace {

/// Moduli of G = 1 MPa and an arm of `arm` MPa at 1 s, with a deviation that no series follows.
Material materialWith(double arm) {
  std::string table = "frequency (Hz),storage modulus (MPa),loss modulus (MPa)\n";
  for (int i = -10; i <= 10; ++i) {
    const double frequency = std::pow(10, 0.1 * i), x = 2 * M_PI * frequency;
    const double share = x * x / (1 + x * x), deviation = i % 2 == 0 ? 1.01 : 0.99;
    table += std::to_string(frequency) + "," + std::to_string(deviation * (1 + arm * share)) + "," +
             std::to_string(arm * share / x) + "\n";
  }
  MaterialChoices choices;
  choices.columns.temperature = 293.15;
  choices.columns.modulus = ModulusKind::Shear;
  return makeMaterial(table, "solid.csv", choices);
}

const DiagramSheet& sheetOf(const std::vector<NamedSheet>& sheets, const std::string& name) {
  return std::ranges::find(sheets, name, &NamedSheet::name)->sheet;
}

TEST(MaterialSheets, NoResidualIsCutByTheFrame) {
  const std::vector<NamedSheet> sheets = materialSheets(materialWith(1));
  const Diagram& residuals = sheetOf(sheets, "master_curve").diagrams.at(1);
  double largest = 0;
  for (const DiagramSeries& series : residuals.series)
    for (const DiagramPoint& point : series.points) largest = std::max(largest, std::abs(point.y));
  EXPECT_GT(largest, 0.5);
  EXPECT_GT(residuals.y.to, 1.1 * largest);
  EXPECT_EQ(residuals.y.from, -residuals.y.to);
}

/// Of less than a decade on a logarithmic axis, hardly one tick has a round number.
TEST(MaterialSheets, TheLossTangentIsLogarithmicWhereItHasDecades) {
  EXPECT_EQ(sheetOf(materialSheets(materialWith(0.1)), "loss_tangent").diagrams.at(0).y.scale,
            AxisScale::Linear);
  EXPECT_EQ(sheetOf(materialSheets(materialWith(100)), "loss_tangent").diagrams.at(0).y.scale,
            AxisScale::Logarithmic);
}

}  // namespace
}  // namespace asperity
