#include "tests/ui/chart/sample_sheets.h"

#include <cmath>
#include <limits>

#include "core/base/statistics.h"

namespace asperity {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr SeriesMark kMarks[] = {SeriesMark::Circle, SeriesMark::Square, SeriesMark::Triangle,
                                 SeriesMark::Diamond};

/// Rises in proportion to v up to about `knee`, then stays at `plateau`.
double rise(double v, double knee, double plateau) {
  return plateau / (1 + knee / v);
}

std::vector<DiagramPoint> curve(double knee, double plateau, int count, double error) {
  std::vector<DiagramPoint> points;
  for (int i = 0; i < count; ++i) {
    const double v = std::pow(10, -5 + 8.0 * i / (count - 1)), y = rise(v, knee, plateau);
    points.push_back({v, y, y - error * y, y + error * y});
  }
  return points;
}

DiagramSheet figure2() {
  Diagram diagram;
  diagram.x = {"sliding velocity", "m/s", AxisScale::Logarithmic, 1e-5, 1e3};
  diagram.y = {"normalized coefficient of friction μ/∇z", "", AxisScale::Linear, 0, 0};
  diagram.series.push_back({.name = "200 realizations, ± standard error",
                            .mark = SeriesMark::Circle,
                            .isBand = true,
                            .points = curve(0.01, 0.7, 41, 0.05)});
  diagram.series.push_back({.name = "Eq. (11)",
                            .stroke = SeriesStroke::Dashed,
                            .isTheory = true,
                            .points = curve(0.012, 0.71, 200, 0)});
  for (int k = 1; k < 4; ++k)
    diagram.series.push_back({.name = "variant " + std::to_string(k),
                              .mark = kMarks[k],
                              .stroke = SeriesStroke::Dotted,
                              .points = curve(0.01 * k, 0.6, 9, 0.1)});
  diagram.spans = {{1e-5, 1e-3, "I"}, {1e-3, 1e-2, "II"}, {1e-2, 10, "III"}, {10, 1e3, "IV"}};
  diagram.shades = {{30, 1e3, "few contacts carry the load"}};
  diagram.labels = {{"plateau √2/2", 0.3, 0.4, 1, 0.68}, {"μ ∝ v", 1e-4, 0.2}};
  return {"Fig. 2: a typical dependence of the coefficient of friction on the velocity",
          "F = 3.4 mN, G = 10 MPa, h = 0.5 µm, H = 0.7, L = 20 mm, τ = 1 ms, 200 realizations",
          "Bands are the standard error of the mean. At high velocities the paper's elements and a "
          "resolved line differ: the short-wave cut-off is a parameter of the model.",
          {diagram}};
}

DiagramSheet figure3() {
  Diagram diagram;
  diagram.x = {"sliding velocity", "m/s"};
  diagram.y = {"coefficient of friction μ", ""};
  for (int k = 0; k < 6; ++k) {
    const double knee = 0.003 * std::pow(4, k), plateau = 0.3 * std::pow(2, -k);
    diagram.series.push_back({.name = "H = 0." + std::to_string(2 * k),
                              .mark = kMarks[k % 4],
                              .stroke = SeriesStroke::None,
                              .points = curve(knee, plateau, 33, 0.1)});
    diagram.series.push_back({.name = k == 0 ? "Eq. (11)" : "",
                              .isTheory = true,
                              .points = curve(knee, plateau, 300, 0)});
  }
  return {"Fig. 3: six Hurst exponents", "F = 10 N, G = 10 MPa, h = 0.5 µm", "", {diagram}};
}

DiagramSheet figure4() {
  Diagram diagram;
  diagram.x = {"sliding velocity", "m/s", AxisScale::Logarithmic, 1e-5, 1e3};
  diagram.y = {"μ/∇z", "", AxisScale::Logarithmic, 1e-5, 2};
  for (int k = 0; k < 20; ++k)
    diagram.series.push_back({.name = "force " + std::to_string(k),
                              .ramp = k / 19.0,
                              .points = curve(0.001 * std::pow(2, k), 0.7, 161, 0)});
  diagram.spans = {{1e-5, 0.1, "zone 1: partial contact"}, {0.1, 1e3, "zone 2"}};
  diagram.labels = {{"increasing force", 1e-4, 0.1, 10, 1e-3}};
  diagram.ramp = DiagramRamp{"normal force", "1 mN", "100 N"};
  return {"Fig. 4: twenty normal forces", "G = 10 MPa, h = 0.5 µm, H = 0.7", "", {diagram}};
}

DiagramSheet figure5() {
  DiagramSheet sheet{"Fig. 5: α and β over the Hurst exponent", "zone 1 of Fig. 4", "", {}};
  for (const char* name : {"α", "β"}) {
    Diagram diagram;
    diagram.title = name + std::string(" of Eq. (5)");
    diagram.x = {"Hurst exponent H", "", AxisScale::Linear, 0, 1};
    diagram.y = {name, "", AxisScale::Linear, 0, 0};
    DiagramSeries fitted{
        .name = "fitted", .mark = SeriesMark::Square, .stroke = SeriesStroke::None, .points = {}};
    DiagramSeries theory{.name = "Eq. (7): α = 1/(H + 1)", .isTheory = true, .points = {}};
    for (int i = 0; i <= 10; ++i) {
      const double h = i / 10.0, y = 1 / (h + 1);
      fitted.points.push_back({h, 1.02 * y, y, 1.04 * y});
      theory.points.push_back({h, y});
    }
    diagram.series = {theory, fitted};
    sheet.diagrams.push_back(diagram);
  }
  return sheet;
}

DiagramSheet figure6() {
  Diagram diagram;
  diagram.x = {"normal force", "N"};
  diagram.y = {"μ/∇z in the plateau", "", AxisScale::Linear, 0, 0.8};
  for (int k = 0; k < 6; ++k) {
    DiagramSeries series{
        .name = "H = 0." + std::to_string(2 * k), .mark = kMarks[k % 4], .points = {}};
    for (int i = 0; i < 20; ++i) {
      const double force = std::pow(10, -3 + 5 * i / 19.0);
      series.points.push_back({force, 0.7 * (1 - 0.15 * k * std::pow(force / 1e-3, -0.3))});
    }
    diagram.series.push_back(series);
  }
  return {"Fig. 6: the plateau over the normal force", "", "Dashed: Eq. (12).", {diagram}};
}

Diagram crowded(int series) {
  Diagram diagram;
  diagram.title = "A diagram with far more to tell than anybody will ever read, in one long line";
  diagram.x = {"an axis with a title that is longer than the axis can ever be on a small picture",
               "m/s"};
  diagram.y = {"another title that is longer than the picture is high, whatever the size", "N/m²"};
  for (int k = 0; k < series; ++k) {
    diagram.series.push_back({.name = "a curve with a long name, number " + std::to_string(k),
                              .mark = kMarks[k % 4],
                              .points = curve(std::pow(10, -4 + 0.2 * k), 1, 30, 0.3)});
    diagram.labels.push_back({"label " + std::to_string(k), 1, 0.5, 10, 0.01});
    diagram.spans.push_back(
        {std::pow(10, -5 + 0.2 * k), std::pow(10, -4.8 + 0.2 * k), "region " + std::to_string(k)});
  }
  return diagram;
}

DiagramSheet withoutPlaces() {
  DiagramSheet sheet = sheetOf({{kNaN, 1},
                                {1, kNaN},
                                {kInfinity, 2},
                                {1e300, 1e300, -kInfinity, kInfinity},
                                {-1e300, 1e-300, 0, 1},
                                {2, 3, 4, kNaN}});
  sheet.diagrams.push_back(sheet.diagrams[0]);
  sheet.diagrams[1].x.scale = sheet.diagrams[1].y.scale = AxisScale::Logarithmic;
  sheet.diagrams[1].series[0].points.push_back({-1, 0});
  sheet.diagrams[1].spans = {{0, kInfinity, "all"}, {kNaN, -3, "none"}};
  sheet.diagrams[1].shades = {{0, kInfinity, "tinted"}, {kNaN, -3, "nowhere"}};
  sheet.diagrams[1].labels = {{"nowhere", -1, 5}, {"", 1, 1}, {"there", 1, 1, kNaN, 2}};
  return sheet;
}

}  // namespace

DiagramSheet sheetOf(const std::vector<DiagramPoint>& points) {
  Diagram diagram;
  diagram.x = {"x", "m", AxisScale::Linear};
  diagram.y = {"y", "", AxisScale::Linear};
  diagram.series.push_back({.name = "points", .mark = SeriesMark::Circle, .points = points});
  return {"A sheet", "", "", {diagram}};
}

std::vector<NamedSheet> figureSheets() {
  return {{"figure 2", figure2()},
          {"figure 3", figure3()},
          {"figure 4", figure4()},
          {"figure 5", figure5()},
          {"figure 6", figure6()}};
}

std::vector<NamedSheet> awkwardSheets() {
  std::string words;
  for (int i = 0; i < 80; ++i) words += "word" + std::to_string(i) + (i % 5 == 0 ? ", " : " ");
  DiagramSheet many{"Many", words, words, {}};
  for (int i = 0; i < 7; ++i) many.diagrams.push_back(crowded(3));
  DiagramSheet ramp{words, std::string(300, 'W'), "", {crowded(4)}};
  ramp.diagrams[0].ramp = DiagramRamp{words, "from a long way off", "to the end of the world"};
  DiagramSheet narrow = sheetOf({{1.00001, 0.5}, {1.00002, 0.500001}});
  narrow.diagrams[0].x.scale = narrow.diagrams[0].y.scale = AxisScale::Logarithmic;
  return {{"nothing", {}},
          {"empty diagram", {"Empty", "", "", {Diagram{}}}},
          {"one point", sheetOf({{0, 0}})},
          {"same height", sheetOf({{1, 5}, {2, 5}})},
          {"tiny", sheetOf({{1e-9, 1e-12}, {2e-9, 3e-12}})},
          {"huge", sheetOf({{-1e12, 1e9}, {2e12, -3e9}})},
          {"less than a decade", narrow},
          {"without places", withoutPlaces()},
          {"thirty curves", {"Thirty", words, words, {crowded(30)}}},
          {"seven diagrams", many},
          {"long ramp", ramp}};
}

}  // namespace asperity
