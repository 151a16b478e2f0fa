#include "core/material/prony_names.h"

#include "core/base/text.h"
#include "core/base/text_number.h"

namespace asperity {

std::string seriesWord(std::string_view text) {
  std::string word = compactName(text);
  for (const std::string_view infinity : WordList("\u221E infinity infty"))
    replaceAll(word, infinity, "inf");
  for (const std::string_view tau : WordList("\u03C4 \u03A4")) replaceAll(word, tau, "tau");
  for (const std::string_view eta : WordList("\u03B7 \u0397")) replaceAll(word, eta, "eta");
  return word;
}

bool isEquilibrium(std::string_view word) {
  return isOneOf(
      word,
      "ginf einf equilibriummodulus longtermmodulus rubberymodulus ge ee geq eeq gequilibrium "
      "eequilibrium inf longtermmodulusg longtermmoduluse equilibriummodulusg "
      "equilibriummoduluse");
}

bool isInstantaneous(std::string_view word) {
  return isOneOf(word,
                 "g0 e0 instantaneousmodulus shorttermmodulus glassymodulus gglassy eglassy ginst "
                 "einst ginstantaneous einstantaneous");
}

bool isRelaxationTime(std::string_view word) {
  return beginsWithOneOf(word, "tau relaxationtime relaxationszeit tempsderelax") ||
         isOneOf(word, "ti times lambda lambdai beta betai");
}

bool isDecayRate(std::string_view word) {
  return word.starts_with("beta");
}

bool isArmModulus(std::string_view name) {
  const std::string word = seriesWord(name);
  return isOneOf(modulusLetter(name), "g gi e ei") || partsByName(word) != PartsOf::Unknown ||
         isOneOf(word,
                 "g gi e ei modulus moduli alpha alphai gimod shearmodulus relativemodulus gk ek");
}

bool isArmViscosity(std::string_view word) {
  return isOneOf(word,
                 "eta etai etak viscosity viscosities viscosityeta viscosityetai viskositaet "
                 "viskositaeteta viskositaetetai");
}

bool hasArmIndex(std::string_view word) {
  return isOneOf(word,
                 "gi ei gi/g0 ei/e0 gi/ginf ei/einf gi/ge ei/ee gi/geq ei/eeq gk ek etai etak");
}

PartsOf partsByName(std::string_view word) {
  if (isOneOf(word, "gi/g0 ei/e0 g/g0 e/e0 gk/g0 ek/e0")) return PartsOf::Instantaneous;
  if (isOneOf(word,
              "gi/ginf ei/einf g/ginf e/einf gk/ginf ek/einf gi/ge ei/ee g/ge e/ee gi/geq ei/eeq"))
    return PartsOf::Equilibrium;
  return PartsOf::Unknown;
}

std::string modulusLetter(std::string_view name) {
  const std::string whole = seriesWord(name);
  std::string word = whole;
  for (const std::string_view part :
       WordList("young's youngs young shear tensile relaxations relaxation schub zug elastizitaets "
                "moduli modulus modul of"))
    replaceAll(word, part, "");
  return word.empty() ? whole : word;
}

ModulusKind kindOfModulus(std::string_view word) {
  if (containsOneOf(word, "young tensile") || word.starts_with("zug")) return ModulusKind::Tension;
  if (containsOneOf(word, "shear schub")) return ModulusKind::Shear;
  if (word.starts_with("e") && !word.starts_with("equilibrium")) return ModulusKind::Tension;
  if (word.starts_with("g") && !word.starts_with("glassy")) return ModulusKind::Shear;
  return ModulusKind::Unknown;
}

}  // namespace asperity
