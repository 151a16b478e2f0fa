#include "core/measured/uniform_positions.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/base/statistics.h"

namespace asperity {
namespace {

/// Deviations from uniform positions up to this part of a step are negligible.
constexpr double kNegligible = 1e-3;

/// A line by least squares deviates from rounded numbers by up to about half of their rounding.
constexpr double kSlack = 1.5;

/// The digits of a number in its shortest form: 0.0386 is 386e-4, with exponent -4 and three
/// digits.
struct Digits {
  int exponent = 0;  // of the last digit
  int count = 0;
};

Digits shortestDigits(double value) {
  std::array<char, 32> text{};
  const char* end = std::to_chars(text.data(), text.data() + text.size(), std::abs(value),
                                  std::chars_format::scientific)
                        .ptr;
  Digits digits;
  const char* exponent = std::find(static_cast<const char*>(text.data()), end, 'e');
  for (const char* at = text.data(); at != exponent; ++at) digits.count += *at != '.' ? 1 : 0;
  int power = 0;
  const char* number = exponent + 1;
  if (number != end && *number == '+') ++number;
  std::from_chars(number, end, power);
  digits.exponent = power - (digits.count - 1);
  return digits;
}

/// The rounding of a list of numbers: half of the last printed digit. The numbers are written with
/// equally many decimals or equally many digits; trailing zeros are not known, so the finest of
/// several numbers counts.
class Rounding {
 public:
  explicit Rounding(std::span<const double> numbers) {
    constexpr std::size_t kLooked = 2000;
    const std::size_t step = numbers.size() / kLooked + 1;
    for (std::size_t i = 0; i < numbers.size(); i += step) {
      if (std::isnan(numbers[i]) || numbers[i] == 0) continue;
      const Digits digits = shortestDigits(numbers[i]);
      finest_ = std::min(finest_, digits.exponent);
      most_ = std::max(most_, digits.count);
    }
  }

  double of(double value) const {
    if (finest_ > 300) return 0;
    const double magnitude = std::abs(value);
    const int leading =
        magnitude > 0 ? static_cast<int>(std::floor(std::log10(magnitude))) : finest_;
    return 0.5 * std::pow(10.0, std::max(finest_, leading - most_ + 1));
  }

 private:
  int finest_ = 1000, most_ = 1;
};

struct Straight {
  double first = 0, spacing = 0;
};

/// Returns the straight line through (i, positions[i]) by least squares; NaN is skipped.
Straight straightThrough(std::span<const double> positions) {
  double count = 0, sumIndex = 0, sumPosition = 0;
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (!std::isnan(positions[i])) {
      count += 1;
      sumIndex += static_cast<double>(i);
      sumPosition += positions[i];
    }
  if (count < 2) return {};
  const double meanIndex = sumIndex / count, meanPosition = sumPosition / count;
  double product = 0, square = 0;
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (!std::isnan(positions[i])) {
      const double index = static_cast<double>(i) - meanIndex;
      product += index * (positions[i] - meanPosition);
      square += index * index;
    }
  const double spacing = product / square;
  return {meanPosition - spacing * meanIndex, spacing};
}

/// Returns whether no position is further from the line than a negligible part of a step, or than
/// its rounding. Where most steps are finer than the rounding, repeated and missing positions
/// cannot be told from rounded ones, and the positions are taken as they are.
bool isStraight(std::span<const double> positions, const Straight& line, const Rounding* rounding) {
  constexpr double kCoarsest = 0.375;
  const double step = std::abs(line.spacing);
  if (!(step > 0)) return false;
  std::size_t coarse = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (std::isnan(positions[i])) continue;
    const double away =
        std::abs(positions[i] - (line.first + line.spacing * static_cast<double>(i)));
    if (away <= kNegligible * step) continue;
    if (rounding == nullptr) return false;
    const double rounded = rounding->of(positions[i]);
    if (away > kSlack * rounded) return false;
    coarse += rounded > kCoarsest * step ? 1 : 0;
  }
  return 2 * coarse <= positions.size();
}

double spacingVariation(std::span<const double> positions, double spacing) {
  double largest = 0;
  for (std::size_t i = 1; i < positions.size(); ++i)
    if (!std::isnan(positions[i]) && !std::isnan(positions[i - 1]))
      largest = std::max(largest, std::abs(positions[i] - positions[i - 1] - spacing));
  return largest / std::abs(spacing);
}

/// Throws InputError for positions that are even except for rounding and leave out many positions
/// of the grid of their last digit: rounded steps cannot be told from missing points.
void requireFineDigits(std::span<const double> positions, const GridAxis& axis,
                       const SurfaceSource& source) {
  constexpr std::int64_t kManyMissing = 10;
  const auto count = static_cast<std::int64_t>(positions.size());
  if (axis.count - count < kManyMissing) return;
  const Straight line = straightThrough(positions);
  const Rounding rounding(positions);
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (std::abs(positions[i] - (line.first + line.spacing * static_cast<double>(i))) >
        kSlack * rounding.of(positions[i]))
      return;
  source.fail(message(
      "the positions are rounded to {:.3g}, too coarsely for even steps of {:.3g}: they need "
      "more digits, or the heights alone are read with surface.point_spacing",
      axis.spacing, line.spacing));
}

/// Makes gaps of the positions of a uniform grid that the file leaves out. Returns false where the
/// positions lie on no such grid of at most twice their number.
bool fillGaps(std::span<const double> positions, std::span<const double> heights,
              const SurfaceSource& source, SurfaceDraft& draft) {
  const auto axis = findGridAxis({positions.begin(), positions.end()},
                                 2 * static_cast<std::int64_t>(positions.size()));
  if (!axis || axis->count < 2) return false;
  requireFineDigits(positions, *axis, source);
  std::vector<double> onGrid(static_cast<std::size_t>(axis->count), kMissingHeight);
  std::vector<bool> isTaken(onGrid.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto index = std::llround((positions[i] - axis->first) / axis->spacing);
    if (index < 0 || index >= axis->count || isTaken[static_cast<std::size_t>(index)]) return false;
    onGrid[static_cast<std::size_t>(index)] = heights[i];
    isTaken[static_cast<std::size_t>(index)] = true;
  }
  draft.grid.columnSpacing = axis->spacing;
  draft.grid.height = std::move(onGrid);
  const std::size_t missing = static_cast<std::size_t>(axis->count) - positions.size();
  draft.facts.notes.push_back(
      missing == 1 ? Message("One place has no row in the file and is taken as a gap.")
                   : message("{} places have no row in the file and are taken as gaps.", missing));
  return true;
}

/// Throws InputError where one step is longer than all others together: nothing is known of the
/// surface in between, and uniform positions would skip most of the points.
void requireNoLeap(std::span<const double> positions, const SurfaceSource& source) {
  if (positions.size() < 3) return;
  std::vector<double> steps;
  for (std::size_t i = 1; i < positions.size(); ++i)
    steps.push_back(positions[i] - positions[i - 1]);
  const auto longest = std::ranges::max_element(steps);
  const double length = positions.back() - positions.front();
  const auto at = static_cast<std::size_t>(longest - steps.begin());
  const double leap = *longest, usual = upperMedian(steps);
  constexpr double kOrdinary = 2;
  if (leap > length / 2 && length > kOrdinary * usual * static_cast<double>(steps.size()))
    source.fail(
        message("the positions leap from {:.6g} to {:.6g}, {:.3g} times the usual step; "
                "each part needs a file of its own",
                positions[at], positions[at + 1], leap / usual));
}

void interpolate(std::span<const double> positions, std::span<const double> heights,
                 SurfaceDraft& draft) {
  const std::size_t count = positions.size();
  const double spacing = (positions.back() - positions.front()) / static_cast<double>(count - 1);
  std::vector<double> interpolated(count);
  std::size_t right = 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double position = positions.front() + spacing * static_cast<double>(i);
    while (right + 1 < count && positions[right] < position) ++right;
    const double part = std::clamp(
        (position - positions[right - 1]) / (positions[right] - positions[right - 1]), 0.0, 1.0);
    const double before = heights[right - 1], after = heights[right];
    if (part == 0)
      interpolated[i] = before;
    else if (part == 1)
      interpolated[i] = after;
    else if (std::isnan(before) || std::isnan(after))
      interpolated[i] = kMissingHeight;
    else
      interpolated[i] = before + part * (after - before);
  }
  draft.grid.columnSpacing = spacing;
  draft.grid.height = std::move(interpolated);
  draft.facts.resampled = true;
  draft.facts.notes.push_back(message(
      "Positions are not uniform (steps differ by up to {:.3g} %): heights are interpolated "
      "linearly onto {} uniform places.",
      100 * draft.facts.spacingVariation, count));
}

/// Replaces heights at equal positions by their mean and returns the number of removed rows.
std::size_t meanOfRepeats(std::vector<double>& positions, std::vector<double>& heights) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < positions.size();) {
    std::size_t end = i;
    double sum = 0, count = 0;
    for (; end < positions.size() && positions[end] == positions[i]; ++end)
      if (!std::isnan(heights[end])) {
        sum += heights[end];
        count += 1;
      }
    positions[kept] = positions[i];
    heights[kept] = count > 0 ? sum / count : kMissingHeight;
    ++kept;
    i = end;
  }
  const std::size_t gone = positions.size() - kept;
  positions.resize(kept);
  heights.resize(kept);
  return gone;
}

}  // namespace

std::optional<double> uniformSpacing(std::span<const double> positions) {
  const Straight line = straightThrough(positions);
  if (isStraight(positions, line, nullptr)) {
    // Where nothing is rounded, the spacing follows from the ends exactly.
    if (!std::isnan(positions.front()) && !std::isnan(positions.back()) && positions.size() > 1)
      return (positions.back() - positions.front()) / static_cast<double>(positions.size() - 1);
    return line.spacing;
  }
  const Rounding rounding(positions);
  if (isStraight(positions, line, &rounding)) return line.spacing;
  return {};
}

namespace {

/// Returns the axis through sorted numbers; those that differ by no more than `merged` roundings
/// are one position.
std::optional<GridAxis> axisThrough(std::span<const double> numbers, const Rounding& rounding,
                                    double merged, std::int64_t most) {
  std::vector<double> positions;
  for (const double number : numbers)
    if (positions.empty() || number - positions.back() > merged * rounding.of(number))
      positions.push_back(number);
  if (positions.size() < 2) return GridAxis{positions.front(), 0, 1};
  double step = positions[1] - positions[0];
  for (std::size_t i = 2; i < positions.size(); ++i)
    step = std::min(step, positions[i] - positions[i - 1]);
  const double range = positions.back() - positions.front();
  // The smallest step may be too short by rounding, so the number of positions is the one that fits
  // all of them.
  const double count = std::round(range / step);
  if (!(count < static_cast<double>(most))) return {};
  GridAxis axis{positions.front(), range / count, static_cast<std::int64_t>(count) + 1};
  std::vector<double> lattice(static_cast<std::size_t>(axis.count), kMissingHeight);
  for (const double position : positions) {
    const auto at = static_cast<std::size_t>(std::llround((position - axis.first) / axis.spacing));
    if (at >= lattice.size() || !std::isnan(lattice[at])) return {};
    lattice[at] = position;
  }
  const Straight line = straightThrough(lattice);
  if (isStraight(lattice, line, nullptr)) return axis;
  if (!isStraight(lattice, line, &rounding)) return {};
  axis.first = line.first;
  axis.spacing = line.spacing;
  return axis;
}

}  // namespace

std::optional<GridAxis> findGridAxis(std::vector<double> numbers, std::int64_t most) {
  if (numbers.empty()) return {};
  std::ranges::sort(numbers);
  const Rounding rounding(numbers);
  if (const auto exact = axisThrough(numbers, rounding, 0, most)) return exact;
  // Rounding changes the smallest step, so an axis with as many positions as numbers is tried as
  // well.
  std::vector<double> positions = numbers;
  positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
  if (static_cast<std::int64_t>(positions.size()) <= most)
    if (const auto spacing = uniformSpacing(positions)) {
      const Straight line = straightThrough(positions);
      return GridAxis{line.first, *spacing, static_cast<std::int64_t>(positions.size())};
    }
  constexpr double kMerged = 2.5;
  return axisThrough(numbers, rounding, kMerged, most);
}

std::optional<GridAxis> findNearGridAxis(std::vector<double> numbers, std::int64_t most) {
  constexpr double kNear = 0.02, kShortest = 0.1;  // of a step, of the longest gap
  if (numbers.size() < 2) return {};
  std::ranges::sort(numbers);
  double longest = 0;
  for (std::size_t i = 1; i < numbers.size(); ++i)
    longest = std::max(longest, numbers[i] - numbers[i - 1]);
  double step = longest;
  for (std::size_t i = 1; i < numbers.size(); ++i)
    if (const double gap = numbers[i] - numbers[i - 1]; gap > kShortest * longest)
      step = std::min(step, gap);
  if (!(step > 0)) return {};
  // The numbers of one position are close together; the first of them stands for all.
  std::vector<double> lattice{numbers.front()};
  std::vector<std::size_t> indices{0};
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    const double steps = std::round((numbers[i] - numbers[i - 1]) / step);
    if (!(static_cast<double>(lattice.size()) + steps <= static_cast<double>(most))) return {};
    if (steps > 0) {
      lattice.resize(lattice.size() + static_cast<std::size_t>(steps), kMissingHeight);
      lattice.back() = numbers[i];
    }
    indices.push_back(lattice.size() - 1);
  }
  const Straight line = straightThrough(lattice);
  if (!(line.spacing > 0)) return {};
  // The line through the first numbers of all positions lies at the lower edge of the deviations.
  double lowest = 0, highest = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double away = numbers[i] - (line.first + line.spacing * static_cast<double>(indices[i]));
    lowest = std::min(lowest, away);
    highest = std::max(highest, away);
  }
  const double deviation = (highest - lowest) / 2 / line.spacing;
  if (deviation > kNear) return {};
  return GridAxis{line.first + (lowest + highest) / 2, line.spacing,
                  static_cast<std::int64_t>(lattice.size()), deviation};
}

Message repeatsNote(std::size_t rows) {
  return rows == 1
             ? Message("One row repeats a position: the mean of the heights is taken.")
             : message("{} rows repeat a position: the mean of their heights is taken.", rows);
}

namespace {

/// Stores heights at positions that are uniform, and notes where their rounding hides how far they
/// are apart.
void keepPlaces(std::span<const double> positions, double spacing, std::vector<double> heights,
                SurfaceDraft& draft) {
  constexpr double kVisible = 0.1;  // of a step
  draft.facts.spacingVariation = spacingVariation(positions, spacing);
  if (draft.facts.spacingVariation > kVisible)
    draft.facts.notes.push_back(
        message("Positions have few digits (steps differ by up to {:.3g} %) and are taken for "
                "uniform ones that were rounded.",
                100 * draft.facts.spacingVariation));
  draft.grid.columnSpacing = std::abs(spacing);
  draft.grid.height = std::move(heights);
}

/// Stores heights at positions that ascend but are not uniform.
void placeRising(std::vector<double> positions, std::vector<double> heights,
                 const SurfaceSource& source, SurfaceDraft& draft) {
  if (const std::size_t gone = meanOfRepeats(positions, heights); gone > 0)
    draft.facts.notes.push_back(repeatsNote(gone));
  if (positions.size() < 2)
    source.fail("all positions are the same; at least 3 different ones are needed");
  if (const auto spacing = uniformSpacing(positions))
    return keepPlaces(positions, *spacing, std::move(heights), draft);
  const double mean =
      (positions.back() - positions.front()) / static_cast<double>(positions.size() - 1);
  draft.facts.spacingVariation = spacingVariation(positions, mean);
  if (fillGaps(positions, heights, source, draft)) return;
  requireNoLeap(positions, source);
  interpolate(positions, heights, draft);
}

}  // namespace

void resampleUniformly(std::vector<double> positions, std::vector<double> heights,
                       std::span<const std::uint32_t> lines, const SurfaceSource& source,
                       SurfaceDraft& draft) {
  const auto spacing = uniformSpacing(positions);
  bool falls = spacing && *spacing < 0;
  if (!spacing) {
    // No position may be missing.
    const auto lineOf = [&lines](std::size_t row) {
      return row < lines.size() ? lines[row] : row + 1;
    };
    for (std::size_t i = 0; i < positions.size(); ++i)
      if (std::isnan(positions[i]))
        source.fail(message("line {}: the position is missing", lineOf(i)));
    falls = positions.back() < positions.front();
    for (std::size_t i = 1; i < positions.size(); ++i)
      if (falls ? positions[i] > positions[i - 1] : positions[i] < positions[i - 1])
        source.fail(message(
            "line {}: the position goes back; positions must rise or fall all along", lineOf(i)));
  }
  if (falls) {
    std::ranges::reverse(positions);
    std::ranges::reverse(heights);
    draft.facts.notes.emplace_back("Positions fall from row to row: the profile is turned round.");
  }
  if (spacing)
    keepPlaces(positions, std::abs(*spacing), std::move(heights), draft);
  else
    placeRising(std::move(positions), std::move(heights), source, draft);
  draft.grid.columns = static_cast<std::int64_t>(draft.grid.height.size());
}

}  // namespace asperity
