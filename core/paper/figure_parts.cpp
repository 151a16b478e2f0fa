#include "core/paper/figure_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/friction/curve_file.h"
#include "core/friction/ensemble.h"
#include "core/surface/line_source.h"

namespace asperity {
namespace {

std::vector<double> normalizedCurve(const GroupedMeans& means, std::size_t j, int leftOut) {
  std::vector<double> values;
  for (std::size_t i = 0; i < means.velocities(j).size(); ++i)
    values.push_back(means.normalizedMu(j, i, leftOut));
  return values;
}

/// Returns mu / (tau v grad^2 / h) in the limit of low velocity, at velocity i: beta Fbar^-alpha of
/// Eq. (5).
double lowVelocityFactor(const GroupedMeans& means, std::size_t j, std::size_t i, int leftOut) {
  const LawInput in = means.lawInput(j, i);
  return means.mu(j, i, leftOut) * in.rmsHeight /
         (in.relaxationTime * in.velocity * in.rmsSlope * in.rmsSlope);
}

}  // namespace

double velocityExponent(const GroupedMeans& means, std::size_t j, std::size_t first,
                        std::size_t last, int leftOut) {
  std::vector<double> velocities, mu;
  for (std::size_t i = first; i <= last; ++i) {
    velocities.push_back(means.velocities(j)[i]);
    mu.push_back(means.mu(j, i, leftOut));
  }
  return fitPower(velocities, mu).slope;
}

CurveMaximum findPlateau(const GroupedMeans& means, std::size_t j, int leftOut) {
  return curveMaximum(means.velocities(j), normalizedCurve(means, j, leftOut));
}

RegionBorders regionBorders(const GroupedMeans& means, std::size_t j, int leftOut,
                            const BorderRule& rule) {
  return regionBorders(means.velocities(j), normalizedCurve(means, j, leftOut), rule);
}

double normalizedMuAt(const GroupedMeans& means, std::size_t j, double velocity, int leftOut) {
  const std::vector<double>& velocities = means.velocities(j);
  const auto above = std::upper_bound(velocities.begin() + 1, velocities.end() - 1, velocity);
  const auto i = static_cast<std::size_t>(above - velocities.begin());
  const double part =
      std::log(velocity / velocities[i - 1]) / std::log(velocities[i] / velocities[i - 1]);
  const double before = means.normalizedMu(j, i - 1, leftOut);
  return before * std::pow(means.normalizedMu(j, i, leftOut) / before, part);
}

double velocityAt(double dimensionlessVelocity, const Scene& scene, double rmsSlope) {
  return dimensionlessVelocity * std::numbers::sqrt2 * scene.surface.rmsHeight /
         (scene.elastomer.relaxationTime * rmsSlope);
}

double meetingVelocity(double dimensionlessForce, double hurst) {
  return std::hypot(dimensionlessForce / 4,
                    std::pow(dimensionlessForce, forceExponent(hurst)) / lawPrefactor(hurst));
}

bool isInZone1(double dimensionlessForce, double to) {
  constexpr double kRounding = 1e-9;
  return dimensionlessForce >= kZone1From * (1 - kRounding) &&
         dimensionlessForce <= to * (1 + kRounding);
}

FullContact compareFullContact(const GroupedMeans& means) {
  FullContact found;
  for (std::size_t j = 0; j < means.forces(); ++j)
    for (std::size_t i = 0; i < means.velocities(j).size(); ++i) {
      if (means.contactFraction(j, i) < 1 - 1e-12) continue;
      ++found.points;
      LawInput in = means.lawInput(j, i);
      const auto deviation = [&] { return std::abs(means.mu(j, i) / fullContactFriction(in) - 1); };
      found.toSpectral = std::max(found.toSpectral, deviation());
      in.rmsSlope = means.rmsSlopeContact(j, i);
      found.toResolved = std::max(found.toResolved, deviation());
    }
  return found;
}

double slopeExponent(std::span<const GroupedMeans> allMeans,
                     const std::function<double(const GroupedMeans&)>& read) {
  std::vector<double> slopes, values;
  for (const GroupedMeans& means : allMeans) {
    slopes.push_back(means.line().rmsSlope);
    values.push_back(read(means));
  }
  return fitPower(slopes, values).slope;
}

std::int64_t scaledElements(const Scene& scene, double factor) {
  return std::max<std::int64_t>(3,
                                std::llround(factor * static_cast<double>(scene.surface.elements)));
}

double forceAt(const Scene& scene, double dimensionlessForce) {
  return dimensionlessForce * scene.elastomer.shearModulus * scene.surface.rmsHeight *
         scene.surface.length;
}

double fitAlpha(const GroupedMeans& means, int leftOut, double to) {
  std::vector<double> forces, factors;
  for (std::size_t j = 0; j < means.forces(); ++j) {
    const double force = dimensionlessForce(means.lawInput(j, 0));
    if (!isInZone1(force, to)) continue;
    forces.push_back(force);
    factors.push_back(lowVelocityFactor(means, j, 0, leftOut));
  }
  return -fitPower(forces, factors).slope;
}

double fitBeta(const GroupedMeans& means, int leftOut) {
  const double alpha = forceExponent(hurstExponent(means));
  double sum = 0;
  for (std::size_t j = 0; j < means.forces(); ++j) {
    const double force = dimensionlessForce(means.lawInput(j, 0));
    sum += std::log(lowVelocityFactor(means, j, 0, leftOut)) + alpha * std::log(force);
  }
  return std::exp(sum / static_cast<double>(means.forces()));
}

std::vector<LoadCase> zone1Cases(const Scene& scene, double rmsSlope) {
  std::vector<LoadCase> cases;
  for (const double force : logSpaced(kZone1From, kBetaUpTo, 13))
    cases.push_back(atForce(forceAt(scene, force), {velocityAt(1e-5, scene, rmsSlope)}));
  return cases;
}

std::vector<LoadCase> plateauCases(const Scene& scene, double rmsSlope,
                                   const std::vector<double>& normalForces) {
  std::vector<LoadCase> cases;
  for (const double normalForce : normalForces) {
    // The maximum lies one to two decades above the velocity where region I meets the plateau.
    const double meeting = meetingVelocity(normalForce / forceAt(scene, 1), scene.surface.hurst);
    const double velocity = velocityAt(meeting, scene, rmsSlope);
    cases.push_back(atForce(normalForce, logSpaced(3 * velocity, 300 * velocity, 9)));
  }
  return cases;
}

std::vector<double> paperForces() {
  return logSpaced(1e-3, 100, 20);
}

std::vector<double> paperSpacings() {
  return logSpaced(1e-7, 1e-5, 20);
}

std::vector<double> sixHurstExponents() {
  return {0, 0.2, 0.4, 0.6, 0.8, 1};
}

std::vector<double> elevenHurstExponents() {
  std::vector<double> exponents;
  for (int tenths = 0; tenths <= 10; ++tenths) exponents.push_back(tenths / 10.0);
  return exponents;
}

bool isInPaperRange(double hurst) {
  return hurst > 0.2 + 1e-9 && hurst < 0.8 - 1e-9;
}

FigureWork::FigureWork(const FigureOptions& options, double totalCost)
    : options_(options), total_(totalCost) {}

StateOptions FigureWork::next(double cost) {
  StateOptions options{.threads = options_.threads, .stop = options_.stop};
  const double before = done_;
  done_ += cost;
  if (options_.progress)
    options.progress = [this, before, cost](double part) {
      options_.progress((before + cost * part) / total_);
    };
  return options;
}

GroupedMeans FigureWork::computeMeans(const Scene& scene, const std::vector<double>& normalForces,
                                      const std::vector<double>& velocities, double cost) {
  return {scene, normalForces, velocities, next(cost)};
}

void forEachHurst(const Scene& scene, std::span<const double> exponents,
                  const FigureOptions& options,
                  const std::function<std::vector<LoadCase>(const Scene&, double rmsSlope)>& cases,
                  const std::function<void(GroupedMeans means)>& use) {
  FigureWork work(options, static_cast<double>(exponents.size()));
  for (const double hurst : exponents) {
    Scene one = scene;
    one.surface.hurst = hurst;
    const double slope = LineSource(one, 1).statistics().rmsSlope;
    use(GroupedMeans(one, cases(one, slope), work.next(1)));
  }
}

DiagramSeries frictionSeries(const GroupedMeans& means, std::size_t j, Message name) {
  DiagramSeries series;
  series.name = std::move(name);
  for (std::size_t i = 0; i < means.velocities(j).size(); ++i) {
    const double error = means.muStandardError(j, i) / means.line().rmsSlope;
    series.points.push_back(
        pointWithError(means.velocities(j)[i], means.normalizedMu(j, i), error));
  }
  return series;
}

DiagramSeries lawSeries(const GroupedMeans& means, std::size_t j, Message name) {
  DiagramSeries series{.name = std::move(name), .isTheory = true};
  LawInput in = means.lawInput(j, 0);
  const std::vector<double>& velocities = means.velocities(j);
  for (const double velocity : logSpaced(velocities.front(), velocities.back(), 161)) {
    in.velocity = velocity;
    series.points.push_back({velocity, frictionLaw(in) / in.rmsSlope});
  }
  return series;
}

Diagram frictionDiagram() {
  return {.x = {"sliding velocity v", "m/s"}, .y = {"normalized friction \u03BC/\u2207z", ""}};
}

DataTable curvesTable(std::initializer_list<ColumnName> own) {
  return {CurveTable().header(columnNames(own)), {}};
}

void addCurve(DataTable& table, const GroupedMeans& means, std::size_t j,
              const std::vector<TableCell>& own) {
  for (std::size_t i = 0; i < means.velocities(j).size(); ++i)
    table.rows.push_back(CurveTable().row(means.point(j, i), own));
}

Message parameterLine(const Scene& scene, const FigureEntry& entry) {
  const auto isVaried = [&](std::string_view key) { return isOneOf(key, entry.ownKeys); };
  std::vector<Message> parts;
  if (!isVaried("surface.hurst")) parts.push_back(message("H = {:g}", scene.surface.hurst));
  if (!isVaried("load.normal_force"))
    parts.push_back(message("F\u2099 = {}", printed(scene.load.normalForce, "N")));
  parts.push_back(message("G = {}", printed(scene.elastomer.shearModulus, "Pa")));
  if (!isVaried("surface.rms_height"))
    parts.push_back(message("h = {}", printed(scene.surface.rmsHeight, "m")));
  if (!isVaried("elastomer.relaxation_time"))
    parts.push_back(message("\u03C4 = {}", printed(scene.elastomer.relaxationTime, "s")));
  if (!isVaried("surface.length"))
    parts.push_back(message("L = {}", printed(scene.surface.length, "m")));
  if (!isVaried("surface.elements")) parts.push_back(message("N = {}", scene.surface.elements));
  if (entry.name != FigureName::Contact)
    parts.push_back(message("{} realizations", scene.ensemble.realizations));
  return listed(parts);
}

Claim fullContactClaim(std::span<const GroupedMeans> allMeans) {
  FullContact all;
  for (const GroupedMeans& means : allMeans) {
    const FullContact one = compareFullContact(means);
    all.points += one.points;
    all.toResolved = std::max(all.toResolved, one.toResolved);
    all.toSpectral = std::max(all.toSpectral, one.toSpectral);
  }
  Claim claim{"equation_8_is_exact", "p. 3, Eq. (8)",
              "In complete contact \u03BC = 4 L \u03B7 grad\u00B2 v / F\u2099, exactly confirmed",
              "largest |\u03BC / Eq. (8) - 1| in complete contact, with the slope of the line as "
              "resolved"};
  claim.expected = 0;
  claim.criterion = message("below {}, on at least one point", plain(1e-9));
  decideExactly(claim, all.points > 0 ? all.toResolved : kNotApplicable, below(1e-9));
  claim.note = message(
      "{} points of complete contact. Against the slope of the spectrum the difference is {:.1e}: "
      "the resolution of the line, which falls with the oversampling.",
      all.points, all.toSpectral);
  return claim;
}

}  // namespace asperity
