// Analyses the results of a study: the part of the variance that each key is responsible for (Sobol
// indices), the mean over all other keys (main effects), correlations, percentiles.
// The numbers come one simulation after the other, in the order of the study, and are not kept:
// memory does not grow with the study. Pure; any thread.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/friction/jackknife.h"
#include "core/study/study_store.h"

namespace asperity {

/// Sensitivity indices of one axis, with the standard errors of the jackknife.
struct SobolIndex {
  std::size_t axis = 0;
  Estimate first;  // Var(E(y | x)) / Var(y): the part of the variance that goes if x is known
  Estimate total;  // E(Var(y | all others)) / Var(y): the part that stays if all others are known
  double halfInterval = 0;  // standard errors from an estimate to each end of its 95 % interval
};

/// The mean of an output over all simulations with one value of a column, or with a value in one
/// part of it.
struct MainEffect {
  double x = 0;  // mean of the column in the part
  double mean = 0, standardError = kNotApplicable;
  std::int64_t count = 0;
};

/// The effect of one column of the space on one output.
struct ColumnEffect {
  std::size_t column = 0;
  double correlation = kNotApplicable;      // Pearson's, of the logarithm where isLogarithmic
  double rankCorrelation = kNotApplicable;  // Spearman's, of `sample`
  bool isLogarithmic = false;
  std::vector<MainEffect> means;
  std::vector<std::pair<double, double>> sample;  // some of the simulations
};

inline constexpr std::array<double, 5> kPercentiles{5, 25, 50, 75, 95};

struct OutputAnalysis {
  std::string name;
  std::int64_t count = 0, failed = 0;  // simulations with a number, and without
  double mean = kNotApplicable, deviation = kNotApplicable;
  double least = kNotApplicable, largest = kNotApplicable;
  std::array<double, kPercentiles.size()> percentiles{};
  std::vector<SobolIndex> indices;    // of a Saltelli design
  std::int64_t blocks = 0;            // number of complete blocks of the design
  std::vector<ColumnEffect> effects;  // one for each column
};

/// Percentiles of a curve at each of its values.
struct CurveBand {
  std::string name;
  std::vector<double> values;
  std::vector<std::array<double, kPercentiles.size()>> percentiles;
};

struct StudyAnalysis {
  std::vector<OutputAnalysis> outputs;  // those that are not curves
  std::vector<CurveBand> bands;
  std::int64_t simulations = 0;
  std::int64_t sampled = 0;  // number of them that percentiles and rank correlations use
};

/// Called with the simulations in ascending order; the numbers of a failed one are NaN.
using UseSimulation = std::function<void(std::int64_t index, std::span<const double> numbers)>;
using EachSimulation = std::function<void(const UseSimulation& use)>;

/// One of the numbers of a simulation, or a curve of `values.size()` numbers.
struct AnalysedOutput {
  std::string name;
  std::vector<double> values;  // of the key that a curve goes over; empty: not a curve
};

/// Analyses simulations. `each` is called more than once.
StudyAnalysis analyseSimulations(const StudySpace& space,
                                 const std::vector<AnalysedOutput>& outputs,
                                 const EachSimulation& each);

StudyAnalysis analyseStudy(const StudyStore& store);

}  // namespace asperity
