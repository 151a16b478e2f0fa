// Reads ready Prony series as people and finite-element programs write them: tables of relaxation
// times, moduli or viscosities (prony_table.h); keywords of Abaqus and LS-DYNA and commands of
// Ansys (prony_keywords.h). Pure; any thread. Failure: InputError that names the file and the line
// or column.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/base/statistics.h"
#include "core/base/text_table.h"
#include "core/material/dma_columns.h"
#include "core/material/elastomer.h"
#include "core/material/isotherms.h"

namespace asperity {

/// What a user states about a file; NaN and empty values leave it to the file.
struct PronyChoices {
  double instantaneousModulus = kNaN;  // Pa, shear
  double equilibriumModulus = kNaN;    // Pa, shear
  std::string modulusUnit;             // of a file whose moduli have none
  std::string temperatureUnit{};       // of the reference temperature of keywords and commands
  ModulusKind modulus = ModulusKind::Unknown;
  double poissonRatio = 0.5;
  bool isLiquid = false;  // whether there may be no equilibrium modulus
  /// K, at which the series is wanted; it chooses among the values at several temperatures, which
  /// may lie apart from it by the tolerance (K).
  std::optional<double> temperature{};
  double temperatureTolerance = kIsothermTolerance;

  /// Returns whether the user states a modulus, to which parts of one may refer.
  bool statesModulus() const {
    return std::isfinite(instantaneousModulus) || std::isfinite(equilibriumModulus);
  }
};

/// A Prony series as a file states it, before its modulus is known: parts of a modulus, or moduli,
/// and one modulus. prony_table.h and prony_keywords.h read it.
struct RawSeries {
  static constexpr double kNotStated = kNaN;
  struct Term {
    double weight = 0, time = 0;
    std::size_t line = 0;
  };
  std::vector<Term> terms{};
  bool isRelative = true;             // weights are parts of the instantaneous modulus
  double instantaneous = kNotStated;  // in the file's unit, of shear
  double equilibrium = kNotStated;    // the same
  double unit = 1;                    // Pa
  bool isUnitKnown = false;
  std::optional<TemperatureShift> shift{};
  std::optional<double> temperature{};  // K, at which the file states its values
  std::string material{};               // "TREAD"; empty where the file names none
  Message format{};
  std::vector<Message> notes{};

  /// Returns the sum of the parts, or of the moduli in the file's unit.
  double totalWeight() const {
    double sum = 0;
    for (const Term& term : terms) sum += term.weight;
    return sum;
  }
};

struct PronyFile {
  double equilibriumModulus = 0;  // Pa, of shear
  std::vector<Arm> arms;          // of shear, strictly falling relaxation times
  std::optional<TemperatureShift> shift{};
  std::optional<double> temperature{};  // K, at which the file states its values
  Message format;                       // "keywords of Abaqus"
  std::vector<Message> notes{};         // what was assumed, and what was left out
};

/// Reads a Prony series; returns nothing where the text is none of these, and throws where it is a
/// Prony series in a form that is not read. table: the same text as a table; null where it holds
/// none.
std::optional<PronyFile> readPronyFile(std::string_view text, const TextTable* table,
                                       const std::string& name, const PronyChoices& choices);

}  // namespace asperity
