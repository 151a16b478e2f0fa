#include "core/material/set_temperatures.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_clause.h"
#include "core/material/dma_columns.h"
#include "core/material/text_quantities.h"

namespace asperity {
namespace {

/// Returns the only column of set temperatures, "Setpoint (\u00B0C)", "T set"; nothing where there
/// are none or several.
std::optional<std::size_t> setColumn(const TextBlock& block) {
  const auto namesSetPoint = [](const TextColumn& column) {
    const std::vector<std::string> words = wordsIn(column.name);
    return hasOneOf(words, kWordsOfSetPoint) || hasOneOf(words, "solltemperatur sollwert");
  };
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < block.columns.size(); ++i) {
    const TextColumn& column = block.columns[i];
    const bool isTemperature =
        dmaColumn(column).quantity == DmaQuantity::Temperature || temperatureUnit(column.unit);
    if (column.isText || !isTemperature || !namesSetPoint(column)) continue;
    if (found) return {};
    found = i;
  }
  return found;
}

/// The rows of one set temperature.
struct SetGroup {
  std::vector<std::size_t> rows{};
  double coldest = 0, warmest = 0, mean = 0;  // K
};

/// Returns whether the rows are of one sweep: of several frequencies, at nearly one temperature.
bool isSweep(const SetGroup& group, const std::vector<MeasuredModulus>& rows) {
  constexpr double kWidest = 3;  // K
  const double first = rows[group.rows.front()].modulus.frequency;
  return group.warmest - group.coldest <= kWidest &&
         std::ranges::any_of(group.rows, [&](std::size_t row) {
           return std::abs(rows[row].modulus.frequency - first) > kSameFrequency * first;
         });
}

/// Returns the rows of each set temperature by rising temperature; empty where they are not clear.
std::vector<SetGroup> groupsOf(const std::vector<MeasuredModulus>& rows,
                               const std::vector<RowOrigin>& origins) {
  std::map<double, SetGroup> bySet;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto column = setColumn(*origins[i].block);
    if (!column || std::isnan(origins[i].block->at(origins[i].row, *column))) return {};
    bySet[origins[i].block->at(origins[i].row, *column)].rows.push_back(i);
  }
  std::vector<SetGroup> groups;
  for (auto& [temperature, group] : bySet) {
    double sum = 0;
    group.coldest = group.warmest = rows[group.rows.front()].temperature;
    for (const std::size_t row : group.rows) {
      group.coldest = std::min(group.coldest, rows[row].temperature);
      group.warmest = std::max(group.warmest, rows[row].temperature);
      sum += rows[row].temperature;
    }
    group.mean = sum / static_cast<double>(group.rows.size());
    if (!isSweep(group, rows) || (!groups.empty() && group.coldest <= groups.back().warmest))
      return {};
    groups.push_back(std::move(group));
  }
  return groups;
}

/// Returns whether the tolerance alone groups the rows otherwise: it parts the rows of a group, or
/// joins two groups.
bool differFromTolerance(const std::vector<SetGroup>& groups,
                         const std::vector<MeasuredModulus>& rows) {
  for (std::size_t i = 0; i < groups.size(); ++i) {
    std::vector<double> temperatures;
    for (const std::size_t row : groups[i].rows) temperatures.push_back(rows[row].temperature);
    std::ranges::sort(temperatures);
    for (std::size_t j = 1; j < temperatures.size(); ++j)
      if (temperatures[j] - temperatures[j - 1] > kIsothermTolerance) return true;
    if (i > 0 && groups[i].coldest - groups[i - 1].warmest <= kIsothermTolerance &&
        groups[i].mean - groups[i - 1].mean > kIsothermTolerance)
      return true;
  }
  return false;
}

}  // namespace

std::optional<Message> groupBySetTemperature(std::vector<MeasuredModulus>& rows,
                                             const std::vector<RowOrigin>& origins) {
  const std::vector<SetGroup> groups = groupsOf(rows, origins);
  if (groups.empty() || !differFromTolerance(groups, rows)) return {};
  double farthest = 0;
  for (const SetGroup& group : groups)
    for (const std::size_t row : group.rows) {
      farthest = std::max(farthest, std::abs(rows[row].temperature - group.mean));
      rows[row].temperature = group.mean;
    }
  const TextBlock& block = *origins.front().block;
  return message(
      "the rows of one {} are one isotherm, at the mean of their temperatures, which differ from "
      "it "
      "by up to {}",
      Message::name(shortened(block.label(*setColumn(block)))), printedQuantity(farthest, "K", 2));
}

}  // namespace asperity
