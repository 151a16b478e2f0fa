// Fig. 1: one contact, as a drawing, with the statements of the text before it about line and
// model.
#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "core/contact/steady_sliding.h"
#include "core/paper/figure_parts.h"
#include "core/scene/data_table.h"
#include "core/surface/line_source.h"
#include "core/surface/spectrum.h"

namespace asperity {
namespace {

struct Contact {
  Line line;
  PreparedProfile profile;
  SteadyResult steady;
  std::vector<double> depth, pressure;  // at the line's nodes; m and N/m
};

Contact computeContact(const Scene& scene) {
  const LineSource source(scene, curvePointsPerElement(scene));  // as in all figures
  Contact contact{source.make(0), {}, {}, {}, {}};
  contact.profile = prepareProfile(contact.line, scene.accuracy.scheme);
  const SlidingConditions conditions = slidingConditions(scene, scene.sliding.velocity);
  contact.steady = slideAtLoad(contact.profile, conditions, scene.load);
  const NodeShape shape = shapeAt(contact.profile, conditions, contact.steady.indentation);
  contact.depth = inLineOrder(contact.profile, shape.depth);
  contact.pressure = inLineOrder(contact.profile, shape.pressure);
  for (double& pressure : contact.pressure) pressure *= 4 * scene.elastomer.shearModulus;
  return contact;
}

DataTable contactTable(const Contact& contact) {
  DataTable table{columnNames({"position", "line_height", "surface_height", "pressure"}), {}};
  const double down = contact.profile.lowestHeight + contact.steady.indentation;
  for (std::size_t i = 0; i < contact.line.nodes(); ++i)
    table.rows.push_back({static_cast<double>(i) * contact.line.spacing,
                          contact.line.height[i] - down, -contact.depth[i], contact.pressure[i]});
  return table;
}

/// Parts of a sum over modes that come from waves of at least a tenth of the longest, or at most
/// ten times the shortest.
struct Shares {
  double longWaves = 0, shortWaves = 0;
};

Shares waveShares(const FourierLine& modes, double power) {
  const std::size_t count = modes.coefficients.size();
  double whole = 0, early = 0, late = 0;
  for (std::size_t k = 1; k <= count; ++k) {
    const double part =
        std::norm(modes.coefficients[k - 1]) * std::pow(static_cast<double>(k), power);
    whole += part;
    if (k <= 10) early += part;
    if (10 * k >= count) late += part;
  }
  return {early / whole, late / whole};
}

Claim balanceClaim(const Contact& contact) {
  Claim claim{"constant_normal_force", "p. 2, Eq. (3)",
              "The indentation depth is determined to satisfy the condition of constant normal "
              "force",
              "relative residual of the force balance"};
  decideZero(claim, contact.steady.residual);
  claim.note =
      "For separate elements F\u2099(d) jumps where an element enters; see Fig. 2's claims.";
  return claim;
}

Claim unilateralClaim(const Contact& contact) {
  double worst = 0, largest = 0;
  const double down = contact.profile.lowestHeight + contact.steady.indentation;
  for (std::size_t i = 0; i < contact.line.nodes(); ++i) {
    worst = std::max(worst, down - contact.line.height[i] - contact.depth[i]);
    largest = std::max(largest, contact.depth[i]);
  }
  Claim claim{"no_penetration", "p. 2, Eqs. (1) and (2)",
              "Elements out of contact satisfy u < z - d, those in contact f > 0",
              "largest penetration over the largest depth"};
  claim.expected = 0;
  claim.criterion = message("at most {}, and no negative pressure", plain(1e-12));
  decideExactly(claim, worst / largest, below(1e-12));
  const double lowest = *std::min_element(contact.pressure.begin(), contact.pressure.end());
  if (lowest < 0) claim.holds = Verdict::No;
  claim.note =
      "The paper's own condition for leaving the contact is f > 0, not u < z - d alone. With the "
      "detachment condition d - z + \u03B7 v z\u2032 = 0 a factor G is missing: G (d - z) + \u03B7 "
      "v z\u2032 "
      "= 0.";
  return claim;
}

Claim shareClaim(const char* id, const char* text, const char* quantity, double share) {
  Claim claim{id, "p. 1, definitions of h and of the rms gradient", text, quantity};
  claim.criterion = "more than half";
  decideExactly(claim, share, above(0.5));
  return claim;
}

}  // namespace

void addContactFigure(Figure& figure, const FigureOptions& options) {
  const Contact contact = computeContact(figure.scene);
  figure.csv = tableCsv(contactTable(contact));
  figure.sheet.note = "Vertical and horizontal units differ.";
  const FourierLine modes = LineSource(figure.scene, 1).spectrum(0);
  figure.claims = {
      balanceClaim(contact), unilateralClaim(contact),
      shareClaim("height_from_long_waves", "h is dominated by the long wavelengths",
                 "share of h\u00B2 from the longest decade of wavelengths",
                 waveShares(modes, 0).longWaves),
      shareClaim("slope_from_short_waves", "The rms gradient is dominated by the short wavelengths",
                 "share of the squared gradient from the shortest decade of wavelengths",
                 waveShares(modes, 2).shortWaves)};
  if (options.progress) options.progress(1);
}

}  // namespace asperity
