// The master curve, Eqs. (16) and (17): curves for other forces, lengths, relaxation times and
// heights before and after shifting; temperature is the special case that shifts exactly.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/number_text.h"
#include "core/base/units.h"
#include "core/friction/ensemble.h"
#include "core/paper/figure_parts.h"

namespace asperity {
namespace {

struct Variant {
  Message name;
  Scene scene;
  int kind;                                   // the parameter that differs, as a colour
  SeriesStroke stroke = SeriesStroke::Solid;  // tells variants of one kind apart
};

std::vector<Variant> makeVariants(const Scene& base) {
  std::vector<Variant> variants{{"as given", base, 0}};
  const auto add = [&](Message name, int kind, const auto& change) {
    constexpr std::array kStrokes{SeriesStroke::Solid, SeriesStroke::Dashed, SeriesStroke::Dotted};
    const auto before =
        static_cast<std::size_t>(std::ranges::count(variants, kind, &Variant::kind));
    Variant variant{std::move(name), base, kind, kStrokes.at(before)};
    change(variant.scene);
    variants.push_back(std::move(variant));
  };
  for (const double factor : {0.1, 10.0, 100.0})
    add(message("F\u2099 = {}", printed(factor * base.load.normalForce, "N")), 1,
        [&](Scene& scene) { scene.load.normalForce *= factor; });
  for (const double factor : {0.25, 4.0})
    add(message("L = {}", printed(factor * base.surface.length, "m")), 2, [&](Scene& scene) {
      // The spacing does not change: the elastomer is only longer.
      scene.surface.length *= factor;
      scene.surface.elements = scaledElements(scene, factor);
    });
  for (const double factor : {0.1, 10.0})
    add(message("\u03C4 = {}", printed(factor * base.elastomer.relaxationTime, "s")), 3,
        [&](Scene& scene) { scene.elastomer.relaxationTime *= factor; });
  for (const double factor : {0.2, 5.0})
    add(message("h = {}", printed(factor * base.surface.rmsHeight, "m")), 4,
        [&](Scene& scene) { scene.surface.rmsHeight *= factor; });
  return variants;
}

/// The divisors of Eqs. (16) and (17): velocity (m/s) and friction.
struct Shift {
  double velocity, friction;
};

Shift masterShift(const GroupedMeans& means, int leftOut = GroupedMeans::kAll) {
  LawInput in = means.lawInput(0, 0);
  in.rmsSlope = means.rmsSlopeContact(0, 0, leftOut);
  in.velocity = 1;
  return {meetingVelocity(dimensionlessForce(in), in.hurst) / dimensionlessVelocity(in),
          in.rmsSlope};
}

/// Returns the root mean square over x of the standard deviation of log10(mu) among the curves;
/// `value` gives the friction of one of them at x.
template <class Value>
double spread(const std::vector<GroupedMeans>& allMeans, const std::vector<double>& abscissas,
              const Value& value) {
  double squares = 0;
  for (const double x : abscissas) {
    double sum = 0, sumOfSquares = 0;
    for (const GroupedMeans& means : allMeans) {
      const double logarithm = std::log10(value(means, x));
      sum += logarithm;
      sumOfSquares += logarithm * logarithm;
    }
    const auto n = static_cast<double>(allMeans.size());
    squares += std::max(0.0, sumOfSquares / n - sum / n * (sum / n));
  }
  return std::sqrt(squares / static_cast<double>(abscissas.size()));
}

double spreadBefore(const std::vector<GroupedMeans>& allMeans, int out) {
  const std::vector<double>& velocities = allMeans.front().velocities();
  return spread(allMeans, logSpaced(velocities.front(), 10, 60),
                [&](const GroupedMeans& means, double v) {
                  return normalizedMuAt(means, 0, v, out) * means.line().rmsSlope;
                });
}

/// The range ends at the plateau: region IV is not part of Eq. (12).
constexpr double kCollapseFrom = 0.01, kCollapseTo = 10;

double spreadAfter(const std::vector<GroupedMeans>& allMeans, int out) {
  return spread(allMeans, logSpaced(kCollapseFrom, kCollapseTo, 60),
                [&](const GroupedMeans& means, double x) {
                  const Shift shift = masterShift(means, out);
                  return normalizedMuAt(means, 0, x * shift.velocity, out) * means.line().rmsSlope /
                         shift.friction;
                });
}

Claim collapseClaim(const std::vector<GroupedMeans>& allMeans) {
  Claim claim{"master_curve", "p. 4, Eqs. (16) and (17)",
              "Changing force, system size or relaxation time only shifts the curves in the double "
              "logarithmic presentation",
              "rms spread of the shifted curves in decades of \u03BC, up to the plateau"};
  claim.expected = 0;
  claim.criterion = "below 0.05 decades (12 %)";
  decide(claim,
         jackknife(allMeans.front().groups(), [&](int out) { return spreadAfter(allMeans, out); }),
         below(0.05));
  claim.note =
      message("Before the shift it is {:.2f} decades.", spreadBefore(allMeans, GroupedMeans::kAll));
  return claim;
}

/// Returns the claim at other G, tau, h and L, with a force and velocities such that the
/// dimensionless numbers stay: mu / grad depends on Fbar, tau v / L, H and N only.
Claim dimensionClaim(const Scene& base, FigureWork& work) {
  Scene scene = base, other = base;
  scene.ensemble.realizations = other.ensemble.realizations =
      std::min<std::int64_t>(base.ensemble.realizations, 5);
  other.surface.length *= 3;
  other.surface.rmsHeight *= 0.7;
  other.elastomer.shearModulus *= 2.1;
  other.elastomer.relaxationTime *= 0.3;
  const std::vector<double> velocities{1e-3, 1e-1, 10};
  std::vector<double> scaled = velocities;
  for (double& velocity : scaled) velocity *= 3 / 0.3;
  const GroupedMeans one = work.computeMeans(scene, {base.load.normalForce}, velocities, 1);
  const GroupedMeans two =
      work.computeMeans(other, {base.load.normalForce * 3 * 0.7 * 2.1}, scaled, 1);
  double worst = 0;
  for (std::size_t i = 0; i < velocities.size(); ++i)
    worst = std::max(worst, std::abs(two.normalizedMu(0, i) / one.normalizedMu(0, i) - 1));
  Claim claim{
      "dimensionless_variables", "p. 1, abstract; p. 4, conclusion",
      "The coefficient of friction depends on two dimensionless combinations of force, "
      "velocity, modulus, viscosity, roughness, slope, size and the Hurst exponent",
      "largest change of \u03BC / grad where h, L, G and \u03C4 change but F\u2099 / G h L and "
      "\u03C4 v grad / h do not"};
  decideZero(claim, worst);
  claim.note = "At the same number of elements; it is a third variable, by the spacing.";
  return claim;
}

/// The WLF constants were measured on a filled rubber (Sci. Rep. 11, 2021, s41598-021-97921-0).
constexpr double kC1 = 4.41, kC2 = 137.64, kReference = 343.15;  // -, K, K

double wlfShift(double kelvin) {
  return std::pow(10, -kC1 * (kelvin - kReference) / (kC2 + kelvin - kReference));
}

struct Temperatures {
  Diagram diagram;
  Claim claim;
};

/// Tests mu(v, T) = mu(v a_T, T_r) with curves at four temperatures, each computed independently.
Temperatures testTemperatures(const Scene& base, FigureWork& work) {
  Temperatures result;
  result.diagram = frictionDiagram();
  result.diagram.title = "temperature";
  Scene scene = base;
  scene.ensemble.realizations = std::min<std::int64_t>(base.ensemble.realizations, 20);
  const std::vector<double> velocities = sweepVelocities(scene.sweep);
  double worst = 0;
  const std::vector<double> celsius{10, 40, 70, 100};
  std::vector<DiagramSeries> shifted;
  for (std::size_t k = 0; k < celsius.size(); ++k) {
    const double factor = wlfShift(celsius[k] + kZeroCelsius);
    Scene warm = scene;
    warm.elastomer.relaxationTime *= factor;
    const GroupedMeans means = work.computeMeans(warm, {scene.load.normalForce}, velocities, 0.2);
    std::vector<double> moved = velocities;
    for (double& velocity : moved) velocity *= factor;
    const GroupedMeans reference = work.computeMeans(scene, {scene.load.normalForce}, moved, 0.2);
    for (std::size_t i = 0; i < velocities.size(); ++i)
      worst = std::max(worst, std::abs(means.mu(0, i) / reference.mu(0, i) - 1));
    DiagramSeries raw = frictionSeries(means, 0, message("{:g} \u00B0C", celsius[k]));
    raw.colour = static_cast<int>(k);
    raw.stroke = SeriesStroke::Dotted;
    raw.dropErrors();
    DiagramSeries marks = raw;
    marks.name = {};
    marks.stroke = SeriesStroke::None;
    marks.mark = SeriesMark::Circle;
    for (DiagramPoint& point : marks.points) point.x *= factor;
    result.diagram.series.push_back(std::move(raw));
    shifted.push_back(std::move(marks));
  }
  for (DiagramSeries& series : shifted) result.diagram.series.push_back(std::move(series));
  result.diagram.x.title = "velocity v (lines), v a\u209C (circles)";
  result.claim = {"temperature_shift", "p. 4, after Eq. (17)",
                  "Curves are shifted by changes of temperature, which influences the relaxation "
                  "time (the master curve procedure)",
                  "largest |\u03BC(v, T) / \u03BC(v a\u209C, T\u1D63) - 1|, 10 to 100 \u00B0C"};
  decideZero(result.claim, worst);
  result.claim.note =
      "WLF shift of a filled rubber: C\u2081 = 4.41, C\u2082 = 137.64 K, T\u1D63 = 343.15 K.";
  return result;
}

DiagramSeries plainSeries(const GroupedMeans& means, const Variant& variant, bool isShifted) {
  DiagramSeries series = frictionSeries(means, 0, variant.name);
  series.colour = variant.kind;
  series.stroke = variant.stroke;
  if (variant.kind == 0) series.mark = SeriesMark::Circle;
  const Shift shift = isShifted ? masterShift(means) : Shift{1, 1};
  series.dropErrors();
  for (DiagramPoint& point : series.points) {
    point.x /= shift.velocity;
    point.y *= means.line().rmsSlope / shift.friction;
  }
  return series;
}

}  // namespace

void addMasterFigure(Figure& figure, const FigureOptions& options) {
  const std::vector<Variant> variants = makeVariants(figure.scene);
  FigureWork work(options, static_cast<double>(variants.size()) + 3.6);
  Diagram before = frictionDiagram(), after;
  before.title = "as computed";
  before.y.title = "friction \u03BC";
  after.title = "shifted by Eq. (17)";
  after.x = {"v\u0305 / f(F\u0305)", ""};
  after.y = {"\u03BC/\u2207z in contact", ""};
  DiagramSeries law{"Eq. (11)"};
  law.isTheory = true;
  for (const double x : logSpaced(1e-4, 1e3, 141))
    law.points.push_back({x, std::numbers::sqrt2 / std::hypot(1, 1 / x)});
  after.series.push_back(law);

  std::vector<GroupedMeans> allMeans;
  DataTable table = curvesTable({"variant", "velocity_shift", "friction_shift"});
  for (const Variant& variant : variants) {
    const GroupedMeans& means = allMeans.emplace_back(work.computeMeans(
        variant.scene, {variant.scene.load.normalForce}, sweepVelocities(variant.scene.sweep), 1));
    before.series.push_back(plainSeries(means, variant, false));
    after.series.push_back(plainSeries(means, variant, true));
    after.series.back().name = {};
    const Shift shift = masterShift(means);
    addCurve(table, means, 0, {variant.name.english(), shift.velocity, shift.friction});
  }
  figure.csv = tableCsv(table);
  after.x.from = 1e-4;
  after.x.to = 1e3;
  after.y.from = 1e-4;
  after.y.to = 3;
  Claim dimension = dimensionClaim(figure.scene, work);
  Temperatures temperatures = testTemperatures(figure.scene, work);
  figure.sheet.diagrams = {std::move(before), std::move(after), std::move(temperatures.diagram)};
  figure.sheet.note =
      "Shifted with the rms slope in contact at low velocity; f is where region I of Eq. (11) "
      "meets the plateau. Region IV is not part of Eq. (12) and does not collapse.";
  figure.claims = {collapseClaim(allMeans), std::move(dimension), std::move(temperatures.claim)};
}

}  // namespace asperity
