// What the names and units of the columns of a table of measured friction mean, in several
// languages. Pure functions; any thread.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text_table.h"
#include "core/base/units.h"

namespace asperity {

enum class FrictionQuantity {
  Velocity,
  Mu,
  MuError,
  VelocityError,
  Force,
  Pressure,
  Temperature,
  Label,
};

inline constexpr std::array<FrictionQuantity, 3> kLoadsAndTemperature{
    FrictionQuantity::Force, FrictionQuantity::Pressure, FrictionQuantity::Temperature};

/// Returns "normal force", "error of the velocity", ...: the quantity in messages.
const char* meaningOf(FrictionQuantity quantity);

/// Returns the quantity of a column by its name: "v", "Reibwert", "Fz", "Normal force F_N",
/// "u(mu)", "std". A name with several meanings, such as t for temperature and time, needs a unit
/// of its quantity, or kAnyUnit. Nothing where the name is not known.
std::optional<FrictionQuantity> findMeaning(const std::string& name, const std::string& unit);
std::optional<FrictionQuantity> findMeaning(const TextColumn& column);
inline constexpr const char* kAnyUnit = "?";

/// Returns whether a name has several meanings or is that of a mean. Such a column does not count
/// beside one with a clear name.
bool isAmbiguousName(const std::string& name);

/// Returns whether the name of a velocity says that it is that of sliding, and not of a wheel:
/// "v_slide", "Gleitgeschwindigkeit".
bool isNameOfSliding(const std::string& name);

/// Returns the quantity that a word names; the word has letters and digits in lower case alone.
std::optional<FrictionQuantity> quantityNamed(const std::string& word);
/// Returns the same of a word beside others, where one of few letters means something else.
std::optional<FrictionQuantity> quantityInText(const std::string& word);

/// How an error is stated that is not one standard error: "2 sigma", "95% CI", "U(mu) (k=2)",
/// "RSD".
struct ErrorScale {
  std::string name{}, unit{};  // of the error, without the words for its scale
  double divisor = 1;          // by which the error is divided for one standard error
  bool isShare = false;        // of the value
  bool isVariance = false;
  bool isIndefinite = false;  // a range, or an expanded uncertainty without its factor
};

/// Returns the scale of an error of friction or velocity; nothing where the column is none or its
/// name says nothing about a scale.
std::optional<ErrorScale> findErrorScale(const TextColumn& column);

/// Returns whether a name is that of an error, such as "u(T)", "dF" and "load error".
bool isErrorName(const std::string& name);
/// Returns whether the name of an error says that it is a share of its quantity.
bool isRelativeError(const std::string& name);
/// Returns whether the name of an error is that of the scatter of single values, such as "SD", and
/// not of the error of their mean.
bool isScatter(const std::string& name);
/// Returns whether the name of an error says that it is that of the mean, such as "SEM".
bool isErrorOfMean(const std::string& name);
/// Returns whether a unit is "% of mu", "% rel." or the like: a share of the quantity.
bool isShareUnit(std::string_view unit);

/// Returns the unit of this load, temperature or velocity; nothing where the text is none.
std::optional<Unit> unitOfQuantity(const std::string& unit, FrictionQuantity quantity);
/// Returns whether a unit measures this load, temperature or velocity.
bool measures(const std::string& unit, FrictionQuantity quantity);
/// Returns the load or temperature that has this unit.
std::optional<FrictionQuantity> quantityOfUnit(const std::string& unit);
/// Returns the same of a load, a temperature or a velocity, in which friction may be measured.
std::optional<FrictionQuantity> stateOfUnit(const std::string& unit);
/// Returns whether a force, stress or modulus with these words in its name is no normal load: the
/// force of friction, the shear stress, the modulus of the rubber.
bool isOtherLoad(const std::vector<std::string>& words);

/// Returns whether a name is that of the force of friction and nothing else.
bool isForceOfFriction(const std::string& name);

/// Returns whether a name is that of the force of friction, of its mean, or in words and by its
/// symbol: "Reibkraft F_R".
bool meansForceOfFriction(const std::string& name);

/// Returns which load, temperature or velocity a name in lower case and a unit are those of, in
/// words; empty where they are of none.
std::string stateNamed(const std::string& word, const std::string& unit);

/// Returns the words of a name in letters and digits: "fz", "track" and "mean" of "Fz_track
/// (mean)".
std::vector<std::string> nameWords(std::string text);

}  // namespace asperity
