// A measured rubber as charts, from one isotherm.
#include "core/chart/material_sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace asperity {
namespace {

using Moduli = std::pair<double, double>;  // storage, loss, MPa

/// A standard solid with an arm of 1 s: its loss tangent falls by decades beside its peak.
Moduli solid(double frequency) {
  const double x = 2 * M_PI * frequency, share = x * x / (1 + x * x);
  return {1 + share, share / x};
}

/// Moduli that grow alike: their loss tangent is the same at each frequency.
Moduli powerLaw(double frequency) {
  const double storage = std::pow(frequency, 0.2);
  return {storage, std::tan(0.1 * M_PI) * storage};
}

/// One isotherm, with deviations that no series follows.
Material materialOf(Moduli moduli(double)) {
  std::string table = "frequency (Hz),storage modulus (MPa),loss modulus (MPa)\n";
  for (int i = -10; i <= 10; ++i) {
    const double frequency = std::pow(10, 0.1 * i);
    const auto [storage, loss] = moduli(frequency);
    table += std::to_string(frequency) + "," +
             std::to_string((i % 2 == 0 ? 1.01 : 0.99) * storage) + "," + std::to_string(loss) +
             "\n";
  }
  MaterialChoices choices;
  choices.columns.temperature = 293.15;
  choices.columns.modulus = ModulusKind::Shear;
  return makeMaterial(table, "rubber.csv", choices);
}

const DiagramSheet& sheetOf(const std::vector<NamedSheet>& sheets, const std::string& name) {
  return std::ranges::find(sheets, name, &NamedSheet::name)->sheet;
}

TEST(MaterialSheets, NoResidualIsCutByTheFrame) {
  const std::vector<NamedSheet> sheets = materialSheets(materialOf(solid));
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
  EXPECT_EQ(sheetOf(materialSheets(materialOf(powerLaw)), "loss_tangent").diagrams.at(0).y.scale,
            AxisScale::Linear);
  EXPECT_EQ(sheetOf(materialSheets(materialOf(solid)), "loss_tangent").diagrams.at(0).y.scale,
            AxisScale::Logarithmic);
}

/// A ready Prony series has no points, which its legend would name.
TEST(MaterialSheets, OnlyMeasuredModuliHaveMarksInTheLegend) {
  const auto firstName = [](const Material& material) {
    const std::vector<NamedSheet> sheets = materialSheets(material);
    for (const DiagramSeries& series : sheetOf(sheets, "master_curve").diagrams.at(0).series)
      if (!series.name.empty()) return series.name.english();
    return std::string();
  };
  EXPECT_EQ(firstName(materialOf(solid)), "G\u2032 (\u25CF measured)");
  MaterialChoices choices;
  choices.columns.temperature = 293.15;
  EXPECT_EQ(firstName(makeMaterial("G_inf = 1 MPa\ntau (s),G_i (MPa)\n0.01,2\n1,0.5\n",
                                   "series.csv", choices)),
            "G\u2032");
}

}  // namespace
}  // namespace asperity
