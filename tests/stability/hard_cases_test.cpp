// Hard cases as a table: what was tried, which invariant came nearest to its limit, and how far mu
// is from the same computation in wider numbers.
#include "tests/stability/hard_cases.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/stability/reference_pass.h"

namespace asperity {
namespace {

const char* nameOf(Scheme scheme) {
  switch (scheme) {
    case Scheme::Nodal:
      return "nodal";
    case Scheme::Linear:
      return "linear";
    case Scheme::Cubic:
      return "cubic";
  }
  return "";
}

TEST(HardCases, Table) {
  fmt::print("{:<34} {:<7} {:>10} {:<28} {:>8} {:>8} {:>8} {:>8} {}\n", "case", "scheme", "mu",
             "worst invariant", "value", "allowed", "mu plain", "mu lanes", "what is hard");
  for (const HardCase& row : hardCases()) {
    const Situation& s = row.situation;
    const SteadyResult plain = solve(s, Path::Plain), lanes = solve(s, Path::Lanes);
    const ReferenceResult reference =
        referenceSliding(s.line, s.scheme, s.conditions, s.load, plain.indentation);
    const auto off = [&](double mu) {
      return mu == reference.mu ? 0 : static_cast<double>(std::abs(mu / reference.mu - 1));
    };
    const std::vector<Finding> findings = allFindings(s);
    const Finding worst = worstOf(findings);
    fmt::print("{:<34} {:<7} {:>10.4g} {:<28} {:>8.1e} {:>8.1e} {:>8.1e} {:>8.1e} {} {}\n",
               row.name, nameOf(s.scheme), plain.mu, worst.invariant, worst.value, worst.allowed,
               off(plain.mu), off(lanes.mu), row.why,
               isRefused(plain) || isRefused(lanes) ? "REFUSED" : "");
    EXPECT_EQ(isRefused(plain) || isRefused(lanes), row.refused);
    for (const Finding& finding : findings)
      EXPECT_TRUE(finding.holds()) << row.name << " " << nameOf(s.scheme) << ": "
                                   << finding.invariant << " " << finding.value;
  }
}

}  // namespace
}  // namespace asperity
