#include "core/material/dma_moduli.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/statistics.h"
#include "core/base/text.h"
#include "core/base/text_clause.h"
#include "core/base/text_number.h"

namespace asperity {
namespace {

// ---- Of shear or of tension ---------------------------------------------------------------------

/// Returns the kind of moduli of the geometry that the lines above a block state: "Geometry:
/// Tension: Film", "Geometry: Parallel plate". Unknown where they state none, or both.
ModulusKind kindOfGeometry(const DmaBlock& in, std::vector<Message>& notes) {
  for (const TextBlock* current = &in.block;; --current) {
    for (const TextEntry& entry : current->header) {
      const std::string line = lowerCase(joinEntry(entry));
      if (!containsOneOf(line, "geometr g\u00E9om\u00E9tr clamp fixture")) continue;
      const bool isShear = containsOneOf(line, "shear schub torsion parallel cone sandwich");
      const bool isTension =
          containsOneOf(line, "tension tensile zug compress bend biege cantilever film");
      if (isShear == isTension) continue;
      notes.push_back(message("line {} states the geometry: {}", entry.line,
                              Message::name(shortened(entry.written))));
      return isShear ? ModulusKind::Shear : ModulusKind::Tension;
    }
    if (current == &in.table.blocks.front()) return ModulusKind::Unknown;
  }
}

/// Returns the kind of the moduli in these columns: the user's, else that of their names, else that
/// of the geometry.
ModulusKind kindOfModuli(const DmaBlock& in, std::initializer_list<std::size_t> columns,
                         std::vector<Message>& notes) {
  ModulusKind kind = ModulusKind::Unknown;
  for (const std::size_t column : columns) {
    const ModulusKind next =
        dmaColumn(in.block.columns[column].name, in.block.columns[column].unit).kind;
    if (next == ModulusKind::Unknown) continue;
    if (kind != ModulusKind::Unknown && kind != next)
      throw InputError(in.fileName, in.block.label(column),
                       "is of another kind than the other modulus: one is of shear (G), one of "
                       "tension (E); say with --storage-column and --loss-column which belong "
                       "together");
    kind = next;
  }
  if (kind == ModulusKind::Unknown) kind = kindOfGeometry(in, notes);
  if (in.choices.modulus != ModulusKind::Unknown) kind = in.choices.modulus;
  if (kind == ModulusKind::Unknown)
    throw InputError(in.fileName, in.block.label(*columns.begin()),
                     "may be of shear (G) or of tension (E); say which with --modulus shear or "
                     "--modulus tension");
  return kind;
}

/// Where only one column has a unit, it is unclear whether it is that of both.
void requireUnits(const DmaBlock& in, const DmaColumnFact& one, const DmaColumnFact& other) {
  if (one.isUnitAssumed == other.isUnitAssumed) return;
  const DmaColumnFact& without = one.isUnitAssumed ? one : other;
  const DmaColumnFact& with = one.isUnitAssumed ? other : one;
  throw InputError(
      in.fileName, without.name,
      message("has no unit, and {} is in {}; say with --modulus-unit which unit both have",
              with.name, with.unit));
}

// ---- Contradictions -----------------------------------------------------------------------------

bool isPositive(double value) {
  return std::isfinite(value) && value > 0;
}

/// Returns the note on a table that also has moduli of the kind that is not read, with their ratio.
/// storage: the column that is read, which is of this kind; poisson: Poisson's ratio.
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

/// Returns the note on a loss factor that contradicts both moduli (contradictingRatio).
/// tangentSize: of the unit of its column.
std::optional<Message> lossFactorNote(const TextBlock& block, const ModulusColumns& moduli,
                                      std::size_t tangent, double tangentSize) {
  std::vector<double> ratios;
  for (std::size_t row = 0; row < block.rows; ++row) {
    const double storage = block.at(row, moduli.first) * moduli.firstSize;
    const double loss = block.at(row, moduli.second) * moduli.secondSize;
    const double factor = block.at(row, tangent) * tangentSize;
    if (isPositive(storage) && isPositive(loss) && isPositive(factor))
      ratios.push_back(factor * storage / loss);
  }
  const auto ratio = contradictingRatio(std::move(ratios));
  if (!ratio) return {};
  return message(
      "{} contradicts the moduli: in the median it is {} times the ratio of {} and {}; the moduli "
      "are read",
      Message::name(block.label(tangent)), PrintedNumber{printedNumber(*ratio, 3)},
      Message::name(block.label(moduli.second)), Message::name(block.label(moduli.first)));
}

/// Returns the storage modulus of a loss modulus; infinite, which is refused, where nothing is
/// lost.
double storageOf(double loss, double tangent) {
  return tangent == 0 ? std::numeric_limits<double>::infinity() : loss / tangent;
}

}  // namespace

const MeasuredPair* measuredPair(const SweepColumns& columns) {
  using enum DmaQuantity;
  static constexpr MeasuredPair kPairs[] = {
      {Storage, Loss,
       [](double storage, double loss) {
         return DynamicModulus{0, storage, loss};
       }},
      {Storage, LossTangent,
       [](double storage, double tangent) {
         return DynamicModulus{0, storage, storage * tangent};
       }},
      {Loss, LossTangent,
       [](double loss, double tangent) {
         return DynamicModulus{0, storageOf(loss, tangent), loss};
       }},
      {Magnitude, Phase,
       [](double magnitude, double phase) {
         return DynamicModulus{0, magnitude * std::cos(phase), magnitude * std::sin(phase)};
       }},
      {Magnitude, LossTangent,
       [](double magnitude, double tangent) {
         const double storage = magnitude / std::hypot(1, tangent);
         return DynamicModulus{0, storage, storage * tangent};
       }},
      {Storage, Phase,
       [](double storage, double phase) {
         return DynamicModulus{0, storage, storage * std::tan(phase)};
       }},
      {Loss, Phase, [](double loss, double phase) {
         return DynamicModulus{0, storageOf(loss, std::tan(phase)), loss};
       }}};
  const auto* const found = std::ranges::find_if(kPairs, [&](const MeasuredPair& pair) {
    return columns.has(pair.first) && columns.has(pair.second);
  });
  return found == std::end(kPairs) ? nullptr : found;
}

ModulusColumns findModulusColumns(const DmaBlock& in, const SweepColumns& columns) {
  using enum DmaQuantity;
  const MeasuredPair& measured = *measuredPair(columns);
  ModulusColumns found;
  found.first = columns[measured.first];
  found.second = columns[measured.second];
  found.combine = measured.combine;
  const SizedColumn first = modulusColumn(in, found.first);
  SizedColumn second;
  if (measured.second == Loss) {
    second = modulusColumn(in, found.second);
    requireUnits(in, first.fact, second.fact);
    found.kind = kindOfModuli(in, {found.first, found.second}, found.notes);
  } else {
    found.kind = kindOfModuli(in, {found.first}, found.notes);
    second = measured.second == Phase ? phaseColumn(in, found.second)
                                      : lossTangentColumn(in, found.second);
  }
  const double factor =
      found.kind == ModulusKind::Tension ? shearFromYoungs(1, in.choices.poissonRatio) : 1;
  found.firstSize = first.size * factor;
  found.secondSize = measured.second == Loss ? second.size * factor : second.size;
  found.storage = measured.first == Loss ? second.fact : first.fact;
  found.loss = measured.first == Loss ? first.fact : second.fact;
  const auto addNote = [&found](std::optional<Message> note) {
    if (note) found.notes.push_back(std::move(*note));
  };
  if (measured.first == Storage)
    addNote(otherKindNote(in.block, found.first, found.kind, in.choices.poissonRatio));
  if (measured.second == Loss && columns.has(LossTangent))
    if (const auto size = lossTangentSize(in, columns[LossTangent]))
      addNote(lossFactorNote(in.block, found, columns[LossTangent], *size));
  return found;
}

}  // namespace asperity
