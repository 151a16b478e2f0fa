#include "core/material/dma_facts.h"

#include <cmath>

#include "core/base/number_text.h"
#include "core/base/statistics.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/material/isotherms.h"

namespace asperity {
namespace {

/// Returns "G' in MPa", "G' in MPa (assumed)" or "tan delta".
Message describeColumn(const DmaColumnFact& fact) {
  const Message name = Message::name(fact.name);
  if (fact.unit.empty()) return name;
  return fact.isUnitAssumed ? message("{} in {} (assumed)", name, fact.unit)
                            : message("{} in {}", name, fact.unit);
}

bool isPositive(double value) {
  return std::isfinite(value) && value > 0;
}

}  // namespace

std::vector<Message> factsOf(const DmaFacts& facts) {
  std::vector<Message> lines;
  const Message frequency = describeColumn(facts.frequency);
  lines.push_back(facts.isReduced ? message("reduced frequency: {}", frequency)
                                  : message("frequency: {}", frequency));
  if (!facts.temperature.name.empty())
    lines.push_back(message("temperature: {}", describeColumn(facts.temperature)));
  else if (facts.stated && facts.sweeps == 1)
    lines.push_back(message("temperature: {} (line {}: {})", celsius(facts.stated->kelvin),
                            facts.stated->line, Message::name(shortened(facts.stated->text))));
  const Message storage = describeColumn(facts.storage), loss = describeColumn(facts.loss);
  lines.push_back(facts.modulus == ModulusKind::Tension
                      ? message("moduli of tension: {}, {}", storage, loss)
                      : message("moduli of shear: {}, {}", storage, loss));
  if (facts.hasOtherColumns)
    lines.push_back(message("these are the columns of the last of {} sweeps", facts.sweeps));
  lines.insert(lines.end(), facts.notes.begin(), facts.notes.end());
  return lines;
}

std::optional<Message> otherKindNote(const TextBlock& block, std::size_t storage, ModulusKind kind,
                                     double poisson) {
  const TextColumn& read = block.columns[storage];
  const bool isShear = kind == ModulusKind::Shear;
  for (std::size_t i = 0; i < block.columns.size(); ++i) {
    const TextColumn& other = block.columns[i];
    const DmaColumn meaning = dmaColumn(other.name, other.unit);
    if (other.isText || meaning.quantity != DmaQuantity::Storage ||
        meaning.kind == ModulusKind::Unknown || meaning.kind == kind)
      continue;
    const double size =
        unitSize(other.unit, "Pa").value_or(1) / unitSize(read.unit, "Pa").value_or(1);
    std::vector<double> ratios;
    for (std::size_t row = 0; row < block.rows; ++row) {
      const double one = block.at(row, i) * size, used = block.at(row, storage);
      if (isPositive(one) && isPositive(used)) ratios.push_back(isShear ? one / used : used / one);
    }
    if (ratios.empty()) return {};
    const PrintedNumber ratio{printedNumber(upperMedian(std::move(ratios)), 3)};
    const PrintedNumber expected{printedNumber(2 * (1 + poisson), 3)};
    return isShear ? message(
                         "the table also has moduli of tension, {} times those of shear in the "
                         "median ({} with this Poisson's ratio); those of shear are read, and "
                         "--modulus tension reads the others",
                         ratio, expected)
                   : message(
                         "the table also has moduli of shear; those of tension are {} times as "
                         "large in the median ({} with this Poisson's ratio) and are read, and "
                         "--modulus shear reads the others",
                         ratio, expected);
  }
  return {};
}

std::optional<Message> lossFactorNote(const TextBlock& block, const LossFactorColumns& columns) {
  std::vector<double> ratios;
  for (std::size_t row = 0; row < block.rows; ++row) {
    const double storage = block.at(row, columns.storage) * columns.storageSize;
    const double loss = block.at(row, columns.loss) * columns.lossSize;
    const double tangent = block.at(row, columns.tangent) * columns.tangentSize;
    if (isPositive(storage) && isPositive(loss) && isPositive(tangent))
      ratios.push_back(tangent * storage / loss);
  }
  constexpr double kSame = 0.1;
  if (ratios.empty()) return {};
  const double ratio = upperMedian(std::move(ratios));
  if (std::abs(ratio - 1) <= kSame) return {};
  return message(
      "{} contradicts the moduli: in the median it is {} times the ratio of {} and {}; the moduli "
      "are read",
      Message::name(columnLabel(block, columns.tangent)), PrintedNumber{printedNumber(ratio, 3)},
      Message::name(columnLabel(block, columns.loss)),
      Message::name(columnLabel(block, columns.storage)));
}

std::string columnLabel(const TextBlock& block, std::size_t column) {
  const std::string& name = block.columns[column].name;
  return name.empty() ? "column " + std::to_string(column + 1) : name;
}

}  // namespace asperity
