// The names of relaxation times, moduli and viscosities in tables of Prony series, and of the
// moduli that the lines around such a table state. Pure functions; any thread.
#pragma once

#include <string>
#include <string_view>

#include "core/material/dma_columns.h"

namespace asperity {

/// Returns a name as compactName does, with "inf", "tau" and "eta" for these signs: "ginf" for
/// "G_∞". The functions below take such words.
std::string seriesWord(std::string_view text);

/// Returns whether a word names the equilibrium modulus.
bool isEquilibrium(std::string_view word);
bool isInstantaneous(std::string_view word);

/// Returns whether a word names relaxation times, or their inverse.
bool isRelaxationTime(std::string_view word);

/// Returns whether a word names the inverse of relaxation times, as LS-DYNA writes beta.
bool isDecayRate(std::string_view word);

/// Returns whether a column's name is that of the moduli of arms, or of parts of a modulus.
bool isArmModulus(std::string_view name);

/// Returns whether a word names the viscosities of arms, eta_i = G_i tau_i.
bool isArmViscosity(std::string_view word);

/// Returns whether a word has an index, as only arms have: "gi", "etak".
bool hasArmIndex(std::string_view word);

/// The modulus of which the numbers of a column are parts, by its name.
enum class PartsOf { Unknown, Instantaneous, Equilibrium };
PartsOf partsByName(std::string_view word);

/// Returns the plain name of a column of moduli without the words around its letter: "g" for
/// "Schubmodul G", "ei" for "Young's modulus E_i". A name of such words alone stays.
std::string modulusLetter(std::string_view name);

/// Returns the kind of modulus that a plain word names: "e0", "einf", "gi", "youngsmodulus".
ModulusKind kindOfModulus(std::string_view word);

}  // namespace asperity
