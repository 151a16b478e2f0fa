// Which cases there are, as data, and how they are named; the reports look them up by these names.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace asperity::bench {

inline constexpr std::array<std::int64_t, 4> kElements{1000, 5000, 100000, 1000000};

struct Contact {
  const char* name;
  double fraction;  // at v = 0.01 m/s
};
inline constexpr std::array<Contact, 3> kContacts{
    {{"light", 0.005}, {"medium", 0.3}, {"full", 1.0}}};

/// Contact fractions whose cost is compared, at N = 5000.
inline constexpr std::array<double, 8> kFractions{0.0003, 0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0};

struct Resolution {
  const char* name;
  Scheme scheme;
  std::int64_t oversampling;
};
inline constexpr std::array<Resolution, 3> kResolutions{
    {{"nodal", Scheme::Nodal, 1}, {"linear", Scheme::Linear, 1}, {"cubic_x2", Scheme::Cubic, 2}}};

/// Lines of which the same number of elements is in contact: below 0.1 % of the longer one.
inline constexpr std::array<std::int64_t, 2> kSameContact{10000, 1000000};
inline constexpr double kContactElements = 500;

inline constexpr std::int64_t kRealizations = 200;

/// Of this machine, narrowest first; the shipped path uses the last.
std::vector<std::string> instructionSets();

std::string gridName(const std::string& path, std::int64_t elements, const std::string& contact);
std::string fractionName(double fraction);
std::string sameContactName(std::int64_t elements);
std::string curveName(const std::string& resolution, std::int64_t realizations);
/// path: an instruction set, or another way to the same curve.
std::string figure4Name(const std::string& path);
std::string figure2Name(const std::string& path, const std::string& resolution);

// One file each; called once, before the benchmarks run.
void addLiteralCases(bool quick);
void addSweepCases(bool quick);
void addGrowthCases(bool quick);
void addCurveCases(bool quick);

}  // namespace asperity::bench
