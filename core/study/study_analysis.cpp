#include "core/study/study_analysis.h"

#include <algorithm>
#include <cmath>

#include "core/base/statistics.h"

namespace asperity {
namespace {

constexpr std::int64_t kParts = 20;          // of a continuous axis, equally likely
constexpr std::int64_t kMaxSeparate = 64;    // values of an axis that are kept apart
constexpr std::int64_t kMaxSampled = 20000;  // simulations for percentiles and ranks
constexpr int kGroups = 16;                  // of the jackknife

/// Mean and variance of two streams of numbers and their covariance (Welford's recurrence).
struct RunningCovariance {
  double count = 0, meanX = 0, meanY = 0, xx = 0, yy = 0, xy = 0;

  void add(double x, double y) {
    ++count;
    const double stepX = x - meanX, stepY = y - meanY;
    meanX += stepX / count;
    meanY += stepY / count;
    xx += stepX * (x - meanX);
    yy += stepY * (y - meanY);
    xy += stepX * (y - meanY);
  }
  double correlation() const { return xx > 0 && yy > 0 ? xy / std::sqrt(xx * yy) : kNotApplicable; }
};

std::array<double, kPercentiles.size()> computePercentiles(std::vector<double> values) {
  std::ranges::sort(values);
  std::array<double, kPercentiles.size()> found{};
  for (std::size_t i = 0; i < found.size(); ++i)
    found[i] = values.empty() ? kNotApplicable : quantile(values, kPercentiles[i] / 100);
  return found;
}

/// Returns the ranks from 1 on; equal values share the mean of their ranks.
std::vector<double> computeRanks(const std::vector<double>& values) {
  const std::vector<std::size_t> order = ascendingOrder(values);
  std::vector<double> ranks(values.size());
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    while (end < order.size() && values[order[end]] == values[order[begin]]) ++end;
    for (std::size_t i = begin; i < end; ++i)
      ranks[order[i]] = 0.5 * static_cast<double>(begin + end + 1);
  }
  return ranks;
}

double spearmanCorrelation(const std::vector<std::pair<double, double>>& sample) {
  std::vector<double> x, y;
  for (const auto& [a, b] : sample) {
    x.push_back(a);
    y.push_back(b);
  }
  const std::vector<double> ranksX = computeRanks(x), ranksY = computeRanks(y);
  RunningCovariance both;
  for (std::size_t i = 0; i < x.size(); ++i) both.add(ranksX[i], ranksY[i]);
  return both.correlation();
}

/// The parts of one column, whose means are its main effect.
class ColumnParts {
 public:
  ColumnParts(const StudyAxis& axis, std::size_t column) {
    const std::int64_t values = axis.count();
    const StudyColumn& one = axis.columns[column];
    if (values == 0) {
      for (std::int64_t i = 1; i < kParts; ++i)
        edges_.push_back(axis.valueAt(static_cast<double>(i) / kParts, column));
      isLogarithmic_ = axis.range ? axis.range->isLogarithmic
                                  : axis.distribution->kind == DistributionKind::Lognormal;
    } else if (!one.hasWords()) {
      std::vector<double> sorted = one.numbers;
      std::ranges::sort(sorted);
      sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
      isLogarithmic_ = sorted.front() > 0 && hasLogarithmicSlider(*one.row);
      const auto count = static_cast<std::int64_t>(sorted.size());
      const std::int64_t parts = std::min(count, count <= kMaxSeparate ? count : kParts);
      for (std::int64_t i = 1; i < parts; ++i)
        edges_.push_back(sorted[static_cast<std::size_t>(i * count / parts)]);
    } else {
      for (std::size_t i = 1; i < one.words.size(); ++i) edges_.push_back(static_cast<double>(i));
    }
    // A whole number may cover several parts.
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  }

  std::size_t count() const { return edges_.size() + 1; }
  std::size_t partOf(double value) const {
    return static_cast<std::size_t>(std::ranges::upper_bound(edges_, value) - edges_.begin());
  }
  bool isLogarithmic() const { return isLogarithmic_; }
  double coordinate(double value) const { return isLogarithmic_ ? std::log(value) : value; }
  double value(double coordinate) const {
    return isLogarithmic_ ? std::exp(coordinate) : coordinate;
  }

 private:
  std::vector<double> edges_;
  bool isLogarithmic_ = false;
};

/// Sums of a Saltelli design over groups of successive blocks. Successive Sobol points cover the
/// space evenly, so that the groups differ by little; of every 16th one all would lie in the same
/// sixteenth of an axis.
class SobolSums {
 public:
  /// blocks: of the whole design.
  SobolSums(std::size_t axes, double centre, std::int64_t blocks)
      : axes_(axes), centre_(centre), designed_(blocks), sums_(kGroups * (3 + 2 * axes)) {}

  /// number: of the block in the design. block: y of A, then y of A with each coordinate of B in
  /// turn, then y of B.
  void add(std::int64_t number, std::span<const double> block) {
    const auto group = static_cast<std::size_t>(number * kGroups / designed_);
    double* const sums = sums_.data() + group * stride();
    const double a = block.front() - centre_, b = block.back() - centre_;
    sums[0] += 1;
    sums[1] += a + b;
    sums[2] += a * a + b * b;
    for (std::size_t i = 0; i < axes_; ++i) {
      const double mixed = block[i + 1] - centre_;
      sums[3 + 2 * i] += b * (mixed - a);
      sums[4 + 2 * i] += (a - mixed) * (a - mixed);
    }
    ++blocks_;
  }

  std::int64_t blocks() const { return blocks_; }

  SobolIndex index(std::size_t axis) const {
    SobolIndex index;
    index.axis = axis;
    std::vector<int> filled;
    for (int group = 0; group < kGroups; ++group)
      if (sums_[static_cast<std::size_t>(group) * stride()] > 0) filled.push_back(group);
    const int groups = static_cast<int>(filled.size());
    if (groups < 2) return index;
    index.halfInterval = studentQuantile(groups - 1);
    const auto left = [&](int out) {
      return out < 0 ? out : filled[static_cast<std::size_t>(out)];
    };
    // Saltelli et al., Comput. Phys. Commun. 181, 259 (2010), Table 2: (b) for the first order,
    // and (f), Jansen's estimator, for the total effect.
    index.first =
        jackknife(groups, [&](int out) { return share(mean(3 + 2 * axis, left(out)), left(out)); });
    index.total = jackknife(
        groups, [&](int out) { return share(mean(4 + 2 * axis, left(out)) / 2, left(out)); });
    return index;
  }

 private:
  std::size_t stride() const { return 3 + 2 * axes_; }
  double sum(std::size_t quantity, int leftOut) const {
    double total = 0;
    for (int group = 0; group < kGroups; ++group)
      if (group != leftOut) total += sums_[static_cast<std::size_t>(group) * stride() + quantity];
    return total;
  }
  double mean(std::size_t quantity, int leftOut) const {
    return sum(quantity, leftOut) / sum(0, leftOut);
  }
  double variance(int leftOut) const {
    const double count = 2 * sum(0, leftOut), average = sum(1, leftOut) / count;
    return sum(2, leftOut) / count - average * average;
  }

  double share(double part, int leftOut) const {
    const double all = variance(leftOut);
    return all > 0 ? part / all : kNotApplicable;
  }

  std::size_t axes_;
  double centre_;
  std::int64_t designed_;
  std::vector<double> sums_;
  std::int64_t blocks_ = 0;
};

/// The statistics of one output, from a single pass over the simulations.
struct OutputSums {
  RunningMean y;
  double least = kNotApplicable, largest = kNotApplicable;
  std::int64_t failed = 0;
  std::vector<RunningCovariance> correlations;       // [column]
  std::vector<std::vector<RunningMean>> x, effects;  // [column][part]
  std::vector<double> sample;
  std::vector<std::vector<std::pair<double, double>>> scatter;  // [column]
};

class Analysis {
 public:
  Analysis(const StudySpace& space, const std::vector<AnalysedOutput>& outputs)
      : space_(space), outputs_(outputs), point_(space.columns()) {
    for (const StudyAxis& axis : space.axes())
      for (std::size_t c = 0; c < axis.columns.size(); ++c) parts_.emplace_back(axis, c);
    members_ = space.sampling() == Sampling::Saltelli
                   ? static_cast<std::int64_t>(space.axes().size()) + 2
                   : 1;
    std::size_t number = 0;
    for (const AnalysedOutput& output : outputs) {
      if (output.values.empty()) {
        numbers_.push_back(number++);
        OutputSums& sums = sums_.emplace_back();
        sums.correlations.resize(parts_.size());
        sums.scatter.resize(parts_.size());
        for (const ColumnParts& parts : parts_) {
          sums.x.emplace_back(parts.count());
          sums.effects.emplace_back(parts.count());
        }
      } else {
        curves_.push_back(number);
        curveSamples_.emplace_back(output.values.size());
        number += output.values.size();
      }
    }
    // Statistics that need an order use only some simulations, at equal distances.
    const std::int64_t used = space.size() / members_ * (members_ > 1 ? 2 : 1);
    stride_ = std::max<std::int64_t>(1, (used + kMaxSampled - 1) / kMaxSampled);
  }

  void add(std::int64_t index, std::span<const double> numbers) {
    ++simulations_;
    // Of the dependent points of a Saltelli design only A and B count, each once.
    const std::int64_t member = index % members_;
    if (members_ > 1 && member != 0 && member != members_ - 1) return;
    const bool isSampled = counted_++ % stride_ == 0;
    space_.pointInto(index, point_);
    for (std::size_t k = 0; k < sums_.size(); ++k) addTo(sums_[k], numbers[numbers_[k]], isSampled);
    if (isSampled) {
      ++sampled_;
      for (std::size_t k = 0; k < curves_.size(); ++k)
        for (std::size_t v = 0; v < curveSamples_[k].size(); ++v)
          if (const double y = numbers[curves_[k] + v]; std::isfinite(y))
            curveSamples_[k][v].push_back(y);
    }
  }

  StudyAnalysis finish(const EachSimulation& each) {
    StudyAnalysis analysis;
    analysis.simulations = simulations_;
    analysis.sampled = sampled_;
    std::size_t scalar = 0, curve = 0;
    for (const AnalysedOutput& output : outputs_) {
      if (output.values.empty()) {
        analysis.outputs.push_back(outputOf(output.name, sums_[scalar++]));
      } else {
        CurveBand band{output.name, output.values, {}};
        for (std::vector<double>& sample : curveSamples_[curve])
          band.percentiles.push_back(computePercentiles(std::move(sample)));
        ++curve;
        analysis.bands.push_back(std::move(band));
      }
    }
    if (members_ > 1) addIndices(analysis, each);
    return analysis;
  }

 private:
  void addTo(OutputSums& sums, double y, bool isSampled) {
    if (!std::isfinite(y)) {
      ++sums.failed;
      return;
    }
    sums.least = sums.y.count() > 0 ? std::min(sums.least, y) : y;
    sums.largest = sums.y.count() > 0 ? std::max(sums.largest, y) : y;
    sums.y.add(y);
    if (isSampled) sums.sample.push_back(y);
    for (std::size_t c = 0; c < parts_.size(); ++c) {
      const double coordinate = parts_[c].coordinate(point_[c]);
      const std::size_t part = parts_[c].partOf(point_[c]);
      sums.correlations[c].add(coordinate, y);
      sums.x[c][part].add(coordinate);
      sums.effects[c][part].add(y);
      if (isSampled) sums.scatter[c].emplace_back(point_[c], y);
    }
  }

  OutputAnalysis outputOf(const std::string& name, OutputSums& sums) const {
    OutputAnalysis output;
    output.name = name;
    output.count = sums.y.count();
    output.failed = sums.failed;
    output.mean = sums.y.mean();
    if (output.count > 1) output.deviation = std::sqrt(sums.y.variance());
    output.least = sums.least;
    output.largest = sums.largest;
    output.percentiles = computePercentiles(std::move(sums.sample));
    for (std::size_t c = 0; c < parts_.size(); ++c) {
      ColumnEffect effect;
      effect.column = c;
      effect.isLogarithmic = parts_[c].isLogarithmic();
      effect.correlation = sums.correlations[c].correlation();
      effect.rankCorrelation = spearmanCorrelation(sums.scatter[c]);
      for (std::size_t p = 0; p < parts_[c].count(); ++p) {
        const RunningMean& y = sums.effects[c][p];
        if (y.count() == 0) continue;
        effect.means.push_back({parts_[c].value(sums.x[c][p].mean()), y.mean(),
                                y.count() > 1 ? y.standardError() : kNotApplicable, y.count()});
      }
      effect.sample = std::move(sums.scatter[c]);
      output.effects.push_back(std::move(effect));
    }
    return output;
  }

  void addIndices(StudyAnalysis& analysis, const EachSimulation& each) const {
    std::vector<SobolSums> sums;
    for (const OutputAnalysis& output : analysis.outputs)
      sums.emplace_back(space_.axes().size(), output.count > 0 ? output.mean : 0,
                        space_.size() / members_);
    std::vector<std::vector<double>> blocks(sums.size());
    std::int64_t expected = -1;
    each([&](std::int64_t index, std::span<const double> numbers) {
      const std::int64_t member = index % members_;
      // A gap in the numbers ends an incomplete block.
      if (member == 0 || index != expected)
        for (std::vector<double>& block : blocks) block.clear();
      expected = index + 1;
      for (std::size_t k = 0; k < sums.size(); ++k) {
        if (blocks[k].size() == static_cast<std::size_t>(member))
          blocks[k].push_back(numbers[numbers_[k]]);
        const bool isWhole =
            blocks[k].size() == static_cast<std::size_t>(members_) && member == members_ - 1;
        if (isWhole && std::ranges::all_of(blocks[k], [](double y) { return std::isfinite(y); }))
          sums[k].add(index / members_, blocks[k]);
      }
    });
    for (std::size_t k = 0; k < sums.size(); ++k) {
      analysis.outputs[k].blocks = sums[k].blocks();
      if (!std::isgreater(analysis.outputs[k].deviation, 0)) continue;
      for (std::size_t axis = 0; axis < space_.axes().size(); ++axis)
        analysis.outputs[k].indices.push_back(sums[k].index(axis));
    }
  }

  const StudySpace& space_;
  const std::vector<AnalysedOutput>& outputs_;
  std::vector<double> point_;
  std::vector<ColumnParts> parts_;  // of each column
  std::int64_t members_ = 1;        // of a block
  std::vector<std::size_t> numbers_, curves_;
  std::vector<OutputSums> sums_;
  std::vector<std::vector<std::vector<double>>> curveSamples_;  // [curve][value]
  std::int64_t stride_ = 1, counted_ = 0, simulations_ = 0, sampled_ = 0;
};

}  // namespace

StudyAnalysis analyseSimulations(const StudySpace& space,
                                 const std::vector<AnalysedOutput>& outputs,
                                 const EachSimulation& each) {
  Analysis analysis(space, outputs);
  each([&](std::int64_t index, std::span<const double> numbers) { analysis.add(index, numbers); });
  return analysis.finish(each);
}

StudyAnalysis analyseStudy(const StudyStore& store) {
  const ParameterStudy& study = store.study();
  std::vector<AnalysedOutput> outputs;
  for (const StudyOutput& output : study.outputs)
    outputs.push_back({output.name, output.isCurve ? study.curveValues() : std::vector<double>()});
  std::vector<double> numbers(study.numbers());
  return analyseSimulations(study.space, outputs, [&](const UseSimulation& use) {
    store.eachChunk([&](const StudyChunk& chunk) {
      for (std::int64_t i = 0; i < chunk.count; ++i) {
        for (std::size_t n = 0; n < numbers.size(); ++n) numbers[n] = chunk.at(n, i);
        use(chunk.first + i, numbers);
      }
      return true;
    });
  });
}

}  // namespace asperity
