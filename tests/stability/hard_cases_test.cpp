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

constexpr double kRelative = 1e-11;  // of mu
/// Of the rms slope: where mu is the difference of large terms, as for elements one by one.
constexpr double kAbsolute = 1e-15;

double errorOf(double mu, Wide reference) {
  if (mu == reference) return 0;
  return static_cast<double>(std::abs(mu - reference) / std::abs(reference));
}

bool isAccurate(const Situation& situation, double mu, Wide reference) {
  return std::abs(mu - reference) <=
         kRelative * std::abs(reference) + kAbsolute * situation.line.rmsSlope;
}

TEST(HardCases, Table) {
  fmt::print("{:<34} {:<7} {:>10} {:<28} {:>8} {:>8} {:>8} {:>8} {}\n", "case", "scheme", "mu",
             "invariant nearest its limit", "value", "allowed", "plain", "lanes", "what is hard");
  for (const HardCase& row : hardCases()) {
    SCOPED_TRACE(row.name + ", " + nameOf(row.situation.scheme));
    const Situation& s = row.situation;
    const SteadyResult plain = solve(s, Path::Plain), lanes = solve(s, Path::Lanes);
    const Wide mu = referenceSliding(s.line, s.scheme, s.conditions, s.load, plain.indentation).mu;
    const std::vector<Finding> findings = allFindings(s);
    const Finding worst = worstOf(findings);
    fmt::print("{:<34} {:<7} {:>10.4g} {:<28} {:>8.1e} {:>8.1e} {:>8.1e} {:>8.1e} {}\n", row.name,
               nameOf(s.scheme), plain.mu, worst.invariant, worst.value, worst.allowed,
               errorOf(plain.mu, mu), errorOf(lanes.mu, mu), row.why);
    EXPECT_FALSE(isRefused(plain));
    EXPECT_FALSE(isRefused(lanes));
    EXPECT_TRUE(isAccurate(s, plain.mu, mu)) << plain.mu << " is not " << mu;
    EXPECT_TRUE(isAccurate(s, lanes.mu, mu)) << lanes.mu << " is not " << mu;
    for (const Finding& finding : findings)
      EXPECT_TRUE(finding.holds()) << finding.invariant << ": " << finding.value;
  }
}

}  // namespace
}  // namespace asperity
