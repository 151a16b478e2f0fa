// Fig. 5: alpha and beta of Eq. (5) in zone 1 over the Hurst exponent.
#include <algorithm>
#include <cmath>

#include "core/base/statistics.h"
#include "core/friction/law.h"
#include "core/paper/figure_parts.h"
#include "core/scene/data_table.h"

namespace asperity {
namespace {

struct Coefficients {
  double hurst = 0;
  Estimate alpha, beta;
  Estimate wideAlpha;             // of the window in which beta is determined
  std::vector<double> without{};  // alpha without each group of realizations
};

Coefficients fitCoefficients(const GroupedMeans& means) {
  Coefficients one{
      hurstExponent(means),
      jackknife(means.groups(), [&](int out) { return fitAlpha(means, out); }),
      jackknife(means.groups(), [&](int out) { return fitBeta(means, out); }),
      jackknife(means.groups(), [&](int out) { return fitAlpha(means, out, kBetaUpTo); })};
  for (int out = 0; means.groups() > 1 && out < means.groups(); ++out)
    one.without.push_back(fitAlpha(means, out));
  return one;
}

/// Returns the correlation of two exponents, by leaving out the same realizations; NaN with fewer
/// than three groups.
double correlation(const Coefficients& a, const Coefficients& b) {
  if (a.without.size() < 3) return kNotApplicable;
  const double meanA = mean(a.without), meanB = mean(b.without);
  double aa = 0, bb = 0, ab = 0;
  for (std::size_t k = 0; k < a.without.size(); ++k) {
    const double x = a.without[k] - meanA, y = b.without[k] - meanB;
    aa += x * x;
    bb += y * y;
    ab += x * y;
  }
  return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : kNotApplicable;
}

/// Returns a note on neighbours: all exponents have the same random phases.
Message correlationNote(const std::vector<Coefficients>& all) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < all.size(); ++k) sum += correlation(all[k], all[k + 1]);
  const double mean = sum / static_cast<double>(all.size() - 1);
  if (!std::isfinite(mean)) return "The points share their random lines and are correlated.";
  return message(
      "The points share their random lines and are correlated: neighbours in \u03B1 by {:.2f} on "
      "average.",
      mean);
}

/// Makes the series of one estimate of all Hurst exponents.
DiagramSeries estimateSeries(const char* name, SeriesMark mark,
                             const std::vector<Coefficients>& all, Estimate Coefficients::*of) {
  DiagramSeries series{name, mark, SeriesStroke::None};
  for (const Coefficients& one : all)
    series.points.push_back(pointWithError(one.hurst, (one.*of).value, (one.*of).standardError));
  return series;
}

/// Makes the series of a formula of the Hurst exponent.
DiagramSeries formulaSeries(const char* name, double (*formula)(double hurst)) {
  DiagramSeries series{name};
  series.isTheory = true;
  for (int k = 0; k <= 50; ++k) series.points.push_back({k / 50.0, formula(k / 50.0)});
  return series;
}

Diagram emptyDiagram(const char* title, const char* name) {
  Diagram diagram{.title = title,
                  .x = {"Hurst exponent H", "", AxisScale::Linear, -0.05, 1.05},
                  .y = {name, "", AxisScale::Linear}};
  return diagram;
}

Diagram alphaDiagram(const std::vector<Coefficients>& all) {
  Diagram diagram = emptyDiagram("exponent", "\u03B1");
  diagram.y.to = 0.6;
  DiagramSeries measured = estimateSeries("measured, 0.001 \u2264 F\u2099/GhL \u2264 0.1",
                                          SeriesMark::Circle, all, &Coefficients::alpha);
  measured.colour = 0;
  DiagramSeries wide = estimateSeries("measured, 0.001 \u2264 F\u2099/GhL \u2264 1",
                                      SeriesMark::Diamond, all, &Coefficients::wideAlpha);
  wide.colour = 1;
  diagram.series = {formulaSeries("\u03B1 = H/(1 + H), Eq. (7)", forceExponent), wide, measured};
  return diagram;
}

Diagram betaDiagram(const std::vector<Coefficients>& all) {
  Diagram diagram = emptyDiagram("prefactor", "\u03B2");
  diagram.y.to = 3;
  DiagramSeries one{"\u03B2 = 1, silently in Eq. (12)"};
  one.isTheory = true;
  one.stroke = SeriesStroke::Dashed;
  one.points = {{0, 1}, {1, 1}};
  diagram.series = {one, formulaSeries("table used by Eq. (11) here", lawPrefactor),
                    estimateSeries("measured, 0.001 \u2264 F\u2099/GhL \u2264 1",
                                   SeriesMark::Circle, all, &Coefficients::beta)};
  return diagram;
}

Claim exponentClaim(const std::vector<Coefficients>& all) {
  Claim claim{
      "alpha_is_H_over_1_plus_H", "p. 3, Eq. (7), Fig. 5",
      "For 0.2 < H < 0.8 the exponent \u03B1 = H/(1 + H) fits the numerical data very well",
      "largest |\u03B1 - H/(1 + H)| at the five Hurst exponents between 0.2 and 0.8, without "
      "the ends; F\u2099 / G h L from 0.001 to 0.1"};
  const auto deviation = [](const Coefficients& one, const Estimate& alpha) {
    return Estimate{std::abs(alpha.value - forceExponent(one.hurst)), alpha.standardError};
  };
  std::vector<Message> each;
  std::vector<Estimate> narrow, wide;
  for (const Coefficients& one : all) {
    each.push_back(message("H = {:g}: {:.3f} for {:.3f}", one.hurst, one.alpha.value,
                           forceExponent(one.hurst)));
    if (!isInPaperRange(one.hurst)) continue;
    narrow.push_back(deviation(one, one.alpha));
    wide.push_back(deviation(one, one.wideAlpha));
  }
  claim.expected = 0;
  claim.criterion = "below 0.02 at each";
  decideByAll(claim, narrow, below(0.02));
  const auto widest = std::ranges::max_element(wide, {}, &Estimate::value);
  claim.note = message(
      "{}. It depends on the window: with F\u2099 / G h L up to 1 the largest deviation is {:.3f}.",
      listed(each), widest->value);
  return claim;
}

Claim prefactorClaim(const std::vector<Coefficients>& all) {
  Claim claim{"beta_of_equation_12", "p. 3, Eq. (12)",
              "Eq. (11) can be rewritten as Eq. (12), in which \u03B2 does not appear",
              "\u03B2 most distant from 1 at the eleven Hurst exponents"};
  std::vector<Estimate> betas;
  for (const Coefficients& one : all) betas.push_back(one.beta);
  claim.expected = 1;
  claim.criterion = "every \u03B2 within 0.1 of 1";
  decideByAll(claim, betas, within(1, 0.1));
  std::vector<Message> each;
  for (const Coefficients& one : all)
    each.push_back(message("{:g}: {:.2f}", one.hurst, one.beta.value));
  claim.note = message(
      "Eq. (12) sets \u03B2 = 1 without saying so and is low by that factor in region I. "
      "\u03B2 by H: {}.",
      listed(each));
  return claim;
}

}  // namespace

void addExponentsFigure(Figure& figure, const FigureOptions& options) {
  std::vector<Coefficients> all;
  DataTable table{columnNames({"hurst", "alpha", "alpha_standard_error", "alpha_law", "beta",
                               "beta_standard_error", "alpha_up_to_1",
                               "alpha_up_to_1_standard_error", "realizations"}),
                  {}};
  forEachHurst(figure.scene, elevenHurstExponents(), options, zone1Cases,
               [&](const GroupedMeans& means) {
                 const Coefficients& one = all.emplace_back(fitCoefficients(means));
                 table.rows.push_back({one.hurst, one.alpha.value, one.alpha.standardError,
                                       forceExponent(one.hurst), one.beta.value,
                                       one.beta.standardError, one.wideAlpha.value,
                                       one.wideAlpha.standardError, means.realizations()});
               });
  figure.csv = tableCsv(table);
  figure.sheet.diagrams = {alphaDiagram(all), betaDiagram(all)};
  figure.sheet.note = sentences(
      {"In the limit of low velocity. \u03B1 depends on the range of forces that it is fitted to; "
       "\u03B2 belongs to \u03B1 = H/(1 + H). Bars: one standard error.",
       correlationNote(all)});
  figure.claims = {exponentClaim(all), prefactorClaim(all)};
}

}  // namespace asperity
