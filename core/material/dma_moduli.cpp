#include "core/material/dma_moduli.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <numbers>
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

/// Returns the kind of moduli that some words state; unknown where they state none, or both.
ModulusKind kindOfWords(bool isShear, bool isTension) {
  if (isShear == isTension) return ModulusKind::Unknown;
  return isShear ? ModulusKind::Shear : ModulusKind::Tension;
}

/// Returns the kind of moduli of the geometry, the mode or the instrument that a line states:
/// "Geometry: Tension: Film", "Deformation mode: shear", "Geometry: Parallel plate", "Messsystem:
/// PP25", "Instrument: ARES-G2 rheometer". A DMA measures both kinds, and so does a rheometer with
/// a second drive.
ModulusKind kindOfLine(const TextEntry& entry) {
  const std::string line = lowerCase(joinEntry(entry));
  const auto isSystem = [](const std::string& word) {
    // plates, cones, cylinders and bars of Anton Paar
    return beginsWithOneOf(word, "pp cp cc srf") && word.find_first_of("0123456789") <= 3;
  };
  if (containsOneOf(line,
                    "geometr g\u00E9om\u00E9tr clamp fixture messsystem measuringsystem "
                    "mess-system") ||
      line.starts_with("measuring system") ||
      containsOneOf(lowerCase(entry.key),
                    "mode deformation verformung pr\u00FCfart beanspruchung belastungsart"))
    return kindOfWords(
        containsOneOf(line, "shear scher schub torsion parallel cone sandwich") ||
            std::ranges::any_of(wordsIn(line), isSystem),
        containsOneOf(line, "tension tensile zug compress bend biege cantilever film"));
  constexpr WordList kShear(
      "shear test, simple shear, double shear, shear mode, in shear, shear modul, schubmodul, "
      "scherversuch, schubversuch",
      ',');
  constexpr WordList kTension(
      "tensile test, tension test, tensile mode, tension mode, in tension, young's modul, "
      "elastizit\u00E4tsmodul, zugversuch, zugmodus",
      ',');
  if (containsOneOf(line, kShear) || containsOneOf(line, kTension))
    return kindOfWords(containsOneOf(line, kShear), containsOneOf(line, kTension));
  const std::vector<std::string> words = wordsIn(line);
  if (!containsOneOf(line, "instrument ger\u00E4t device rheometer")) return ModulusKind::Unknown;
  const bool isRheometer = std::ranges::any_of(words, [](const std::string& word) {
    return word.ends_with("rheometer") || beginsWithOneOf(word, "ares dhr kinexus mcr rpa");
  });
  const bool mayPull = containsOneOf(line, "dma 702 multidrive tensile");
  return isRheometer && !mayPull ? ModulusKind::Shear : ModulusKind::Unknown;
}

/// Returns the kind of moduli that other columns of a block state: "Shear strain", "Schubspannung".
ModulusKind kindOfOtherColumns(const TextBlock& block, std::string& stating) {
  constexpr WordList kMechanical(
      "strain stress deformation verformung spannung dehnung verzerrung scherung");
  bool isShear = false, isTension = false;
  for (const TextColumn& column : block.columns) {
    const std::string word = compactName(column.name);
    if (!containsOneOf(word, kMechanical)) continue;
    const bool isOfShear = containsOneOf(word, "shear scher schub"),
               isOfTension = containsOneOf(word, "tensile zugsp zugd zugv");
    if (isOfShear || isOfTension) stating = column.name;
    isShear = isShear || isOfShear;
    isTension = isTension || isOfTension;
  }
  return kindOfWords(isShear, isTension);
}

/// Returns the kind of moduli that the lines above a block or its other columns state, and a note
/// on what states it.
ModulusKind statedKind(const DmaBlock& in, std::vector<Message>& notes) {
  for (const TextBlock* current = &in.block;; --current) {
    for (const TextEntry& entry : current->header) {
      const ModulusKind kind = kindOfLine(entry);
      if (kind == ModulusKind::Unknown) continue;
      notes.push_back(message("line {} says of which kind the moduli are: {}", entry.line,
                              Message::name(shortened(entry.written))));
      return kind;
    }
    if (current == &in.table.blocks.front()) break;
  }
  std::string stating;
  const ModulusKind kind = kindOfOtherColumns(in.block, stating);
  if (kind != ModulusKind::Unknown)
    notes.push_back(kind == ModulusKind::Shear
                        ? message("the column {} says that the moduli are of shear",
                                  Message::name(shortened(stating)))
                        : message("the column {} says that the moduli are of tension",
                                  Message::name(shortened(stating))));
  return kind;
}

/// Returns the kind of the moduli in these columns: the user's, else that of their names, else the
/// one that the file states otherwise.
ModulusKind kindOfModuli(const DmaBlock& in, std::initializer_list<std::size_t> columns,
                         std::vector<Message>& notes) {
  ModulusKind kind = ModulusKind::Unknown;
  for (const std::size_t column : columns) {
    const ModulusKind next = dmaColumn(in.block.columns[column]).kind;
    if (next == ModulusKind::Unknown) continue;
    if (kind != ModulusKind::Unknown && kind != next)
      throw InputError(in.fileName, in.block.label(column),
                       "is of another kind than the other modulus: one is of shear (G), one of "
                       "tension (E); say with --storage-column and --loss-column which belong "
                       "together");
    kind = next;
  }
  if (kind == ModulusKind::Unknown) kind = statedKind(in, notes);
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
    const DmaColumn meaning = dmaColumn(other);
    if (other.isText || meaning.quantity != DmaQuantity::Storage ||
        meaning.form != MeasuredForm::Modulus || meaning.kind == ModulusKind::Unknown ||
        meaning.kind == kind)
      continue;
    const double size =
        unitSize(other.unit, "Pa").value_or(1) / unitSize(read.unit, "Pa").value_or(1);
    std::vector<double> ratios;
    for (std::size_t row = 0; row < block.rows; ++row) {
      const double one = block.at(row, i) * size, used = block.at(row, storage);
      if (isPositive(one) && isPositive(used)) ratios.push_back(isShear ? one / used : used / one);
    }
    if (ratios.empty()) return {};
    const PrintedNumber ratio = printed(upperMedian(std::move(ratios)), 3);
    const PrintedNumber expected = printed(2 * (1 + poisson), 3);
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
      Message::name(block.label(tangent)), printed(*ratio, 3),
      Message::name(block.label(moduli.second)), Message::name(block.label(moduli.first)));
}

/// Returns the other part of a magnitude; 0, which is refused, where the magnitude is not above the
/// part.
double otherPart(double magnitude, double part) {
  return magnitude > part ? std::sqrt((magnitude - part) * (magnitude + part)) : 0;
}

/// Returns the note on a modulus that follows from a magnitude and its other part, where rounding
/// matters: the relative error of m becomes m^2 / (m^2 - p^2) times as large.
std::optional<Message> otherPartNote(const TextBlock& block, const ModulusColumns& moduli) {
  constexpr double kMatters = 3;
  std::vector<double> factors;
  for (std::size_t row = 0; row < block.rows; ++row) {
    const double part = block.at(row, moduli.second) * moduli.secondSize /
                        (block.at(row, moduli.first) * moduli.firstSize);
    if (isPositive(part) && part < 1) factors.push_back(1 / ((1 - part) * (1 + part)));
  }
  if (factors.empty()) return {};
  const double factor = upperMedian(std::move(factors));
  if (factor < kMatters) return {};
  return message(
      "the other modulus follows from {} and {}, which differ little: 1 % of error in one of them "
      "makes {} % in it, in the median",
      Message::name(block.label(moduli.first)), Message::name(block.label(moduli.second)),
      printed(factor, 2));
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
      {Loss, Phase,
       [](double loss, double phase) {
         return DynamicModulus{0, storageOf(loss, std::tan(phase)), loss};
       }},
      {Magnitude, Loss,
       [](double magnitude, double loss) {
         return DynamicModulus{0, otherPart(magnitude, loss), loss};
       }},
      {Magnitude, Storage, [](double magnitude, double storage) {
         return DynamicModulus{0, storage, otherPart(magnitude, storage)};
       }}};
  const auto* const found = std::ranges::find_if(kPairs, [&](const MeasuredPair& pair) {
    return columns.has(pair.first) && columns.has(pair.second);
  });
  return found == std::end(kPairs) ? nullptr : found;
}

void chooseForm(std::vector<DmaColumn>& found) {
  using enum MeasuredForm;
  using Filter = bool (*)(const DmaColumn&);
  static constexpr Filter kInOrder[] = {
      [](const DmaColumn& column) { return column.form == Modulus; },
      [](const DmaColumn& column) { return column.form != Compliance; },
      [](const DmaColumn& column) {
        return column.form == Compliance || !isModulus(column.quantity);
      }};
  const auto* const complete = std::ranges::find_if(kInOrder, [&found](Filter isKept) {
    SweepColumns columns;
    for (std::size_t i = 0; i < found.size(); ++i)
      if (isKept(found[i])) columns.indices[found[i].quantity] = i;
    return columns.hasModuli();
  });
  const Filter isKept = complete == std::end(kInOrder) ? kInOrder[0] : *complete;
  for (DmaColumn& column : found)
    if (!isKept(column)) column.quantity = DmaQuantity::None;
}

DynamicModulus ModulusColumns::at(double hertz, double one, double other) const {
  const double omega = 2 * std::numbers::pi * hertz;
  DynamicModulus modulus = pair->combine(isFirstViscosity ? one * omega : one,
                                         isSecondViscosity ? other * omega : other);
  if (areCompliances) {
    const double square = modulus.storage * modulus.storage + modulus.loss * modulus.loss;
    modulus = {0, modulus.storage / square, modulus.loss / square};
  }
  modulus.frequency = hertz;
  return modulus;
}

ModulusColumns findModulusColumns(const DmaBlock& in, const SweepColumns& columns) {
  using enum DmaQuantity;
  const MeasuredPair& measured = *measuredPair(columns);
  const bool areBothModuli = isModulus(measured.second);
  const auto formOf = [&](std::size_t column) { return dmaColumn(in.block.columns[column]).form; };
  ModulusColumns found;
  found.first = columns[measured.first];
  found.second = columns[measured.second];
  found.pair = &measured;
  const MeasuredForm firstForm = formOf(found.first),
                     secondForm = areBothModuli ? formOf(found.second) : firstForm;
  found.areCompliances = firstForm == MeasuredForm::Compliance;
  if (found.areCompliances != (secondForm == MeasuredForm::Compliance))
    throw InputError(in.fileName, in.block.label(found.second),
                     message("and {} are a compliance and none; both moduli follow from two "
                             "compliances, or from two moduli",
                             shortened(in.block.label(found.first))));
  found.isFirstViscosity = firstForm == MeasuredForm::Viscosity;
  found.isSecondViscosity = areBothModuli && secondForm == MeasuredForm::Viscosity;
  const SizedColumn first = modulusColumn(in, found.first);
  SizedColumn second;
  if (areBothModuli) {
    second = modulusColumn(in, found.second);
    requireUnits(in, first.fact, second.fact);
    found.kind = kindOfModuli(in, {found.first, found.second}, found.notes);
  } else {
    found.kind = kindOfModuli(in, {found.first}, found.notes);
    second = measured.second == Phase ? phaseColumn(in, found.second)
                                      : lossTangentColumn(in, found.second);
  }
  double factor =
      found.kind == ModulusKind::Tension ? shearFromYoungs(1, in.choices.poissonRatio) : 1;
  if (found.areCompliances) factor = 1 / factor;
  found.firstSize = first.size * factor;
  found.secondSize = areBothModuli ? second.size * factor : second.size;
  found.storage = measured.first == Loss ? second.fact : first.fact;
  found.loss = measured.first == Loss ? first.fact : second.fact;
  const auto addNote = [&found](std::optional<Message> note) {
    if (note) found.notes.push_back(std::move(*note));
  };
  if (found.areCompliances) addNote("the moduli follow from compliances: G* = 1 / J*");
  if (found.isFirstViscosity || found.isSecondViscosity)
    addNote("the moduli follow from viscosities: G* = i \u03C9 \u03B7*");
  if (found.kind == ModulusKind::Tension) addNote(otherPoissonNote(in, in.choices.poissonRatio));
  if (measured.first == Storage && firstForm == MeasuredForm::Modulus)
    addNote(otherKindNote(in.block, found.first, found.kind, in.choices.poissonRatio));
  if (measured.first == Magnitude && areBothModuli && firstForm == secondForm)
    addNote(otherPartNote(in.block, found));
  if (measured.first == Storage && measured.second == Loss && columns.has(LossTangent))
    if (const auto size = lossTangentSize(in, columns[LossTangent]))
      addNote(lossFactorNote(in.block, found, columns[LossTangent], *size));
  return found;
}

}  // namespace asperity
