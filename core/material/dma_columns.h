// What the columns of a table of dynamic moduli mean: names and units as rheometers, analysers
// (DMA) and people write them, in many languages. Pure
// functions; any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/base/text.h"
#include "core/base/text_table.h"
#include "core/base/units.h"
#include "core/material/text_quantities.h"

namespace asperity {

enum class DmaQuantity {
  None,
  Frequency,
  ReducedFrequency,  // shifted to one temperature already
  Temperature,
  Storage,
  Loss,
  LossTangent,
  Magnitude,  // |G*|
  Phase,
  Strain,
};

/// Returns whether the quantity is a modulus.
bool isModulus(DmaQuantity quantity);

/// Returns whether the quantity is a modulus or part of one, which each sweep has for itself.
bool isMeasured(DmaQuantity quantity);

enum class ModulusKind { Unknown, Shear, Tension };

/// What a column states in place of a modulus: a viscosity, G* = i omega eta*, or a compliance,
/// G* = 1 / J*.
enum class MeasuredForm { Modulus, Viscosity, Compliance };

/// Returns the shear modulus of a Young's modulus, E / (2 (1 + nu)).
double shearFromYoungs(double youngs, double poisson);

/// Says that moduli of tension were divided for shear.
Message dividedForShear(double poisson);

/// Returns the note on a Poisson's ratio that the lines above a block state and that is not the one
/// by which moduli of tension are divided.
std::optional<Message> otherPoissonNote(const TextPart& in, double poisson);

/// Words that name the temperature of the sample, a set one, and that of a device.
inline constexpr WordList kWordsOfSample(
    "sample specimen probe proben actual ist measured tsample tprobe tist tactual tmeasured");
inline constexpr WordList kWordsOfSetPoint(
    "set setpoint soll target nominal program programmed tset tsoll");
inline constexpr WordList kWordsOfDevice("oven furnace chamber bath ofen kammer");

struct DmaColumn {
  /// Of a viscosity, eta' is part of the loss modulus, and eta'' of the storage modulus; J' and J''
  /// are the storage and the loss compliance.
  DmaQuantity quantity = DmaQuantity::None;
  ModulusKind kind = ModulusKind::Unknown;  // of a modulus
  MeasuredForm form = MeasuredForm::Modulus;
  bool isAngular = false;               // of a frequency: omega by its name
  std::optional<double> temperature{};  // K, where the name states one: "G' (20 \u00B0C)"
  std::optional<double> frequency{};    // Hz, where the name of a measured one has it: "E' 10 Hz"
  bool isUnitOfState = false;           // the unit is part of one of these, and none of the numbers
  /// Of no use, and named to the user: a deviation ("G' std"), a set value, a strain in a unit that
  /// is not known. Its quantity is none.
  bool isLeftOut = false;
  std::string unknown{};  // words beside the name of a modulus that are not understood: "fit"
  std::string words{};    // all of the name's words, by which equal names are recognized
};

/// Returns what a column means: "G'", "E_storage", "Storage modulus", "tan(delta)", "|E*|",
/// "omega", "Temp.", "G'' @ 20 \u00B0C", ... The unit helps where the brackets of the name contain
/// a temperature.
DmaColumn dmaColumn(std::string_view name, std::string_view unit);
inline DmaColumn dmaColumn(const TextColumn& column) {
  return dmaColumn(column.name, column.unit);
}

/// Returns a name in lower case, with plain primes, with Greek letters as words, and without
/// blanks, brackets, "_", "-" and ".": "gdelta" for "G_\u03B4".
std::string compactName(std::string_view name);

/// Returns the text in brackets, or after a slash, at the end of a name: it is meant as a unit,
/// known or not. Empty where there is none.
std::string unitText(std::string_view name);

/// Returns what to say about moduli (Pa) that no rubber has; nothing where one may.
std::optional<Message> unusualModulus(double least, double most);

/// Throws InputError for moduli without a unit, the largest of which (`largest`, Pa) is below 1
/// kPa: no rubber has such moduli in Pa. `name` is the file's, `key` the column's.
void refuseSoftModulus(const std::string& name, const std::string& key, double largest);

}  // namespace asperity
