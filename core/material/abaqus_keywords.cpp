// Keywords of Abaqus (Abaqus Keywords Reference Guide): *ELASTIC or *HYPERELASTIC, *VISCOELASTIC
// and *TRS of the material that has the Prony series.
#include <algorithm>
#include <functional>

#include "core/base/input_error.h"
#include "core/base/text_number.h"
#include "core/material/dma_columns.h"
#include "core/material/prony_keywords.h"
#include "core/material/temperature_shift.h"

namespace asperity {
namespace {

bool isKeyword(const KeywordLine& line, std::string_view word) {
  return line.words.front() == word;
}

bool has(const KeywordLine& line, std::string_view word) {
  return std::ranges::find(line.words, word) != line.words.end();
}

/// Returns the text after "dependencies=" among the words of a keyword; nothing where there is
/// none.
std::optional<std::string> textParameter(const KeywordLine& keyword, std::string_view parameter) {
  for (const std::string& word : keyword.words)
    if (word.starts_with(parameter)) return word.substr(parameter.size());
  return {};
}

std::optional<double> numberParameter(const KeywordLine& keyword, std::string_view parameter) {
  double value = 0;
  const auto text = textParameter(keyword, parameter);
  if (text && readTextNumber(*text, '.', value)) return value;
  return {};
}

/// Returns the name after NAME= as it was written.
std::string writtenName(const KeywordLine& keyword) {
  const std::size_t label = lowerCase(keyword.text).find("name");
  if (label == std::string::npos) return {};
  std::string_view name = keyword.text.substr(label);
  const std::size_t equals = name.find('=');
  if (equals == std::string_view::npos) return {};
  name.remove_prefix(equals + 1);
  return std::string(trimmedField(name.substr(0, name.find(','))));
}

/// The lines of one material: those from *MATERIAL to the next one, or all before the first one.
struct MaterialLines {
  std::size_t begin = 0, end = 0;
  std::size_t materials = 0;  // in the whole file
};

/// Returns the material with the Prony series; nothing where there is none. Throws InputError where
/// it is not the only one.
std::optional<MaterialLines> materialWithSeries(const KeywordFile& file) {
  MaterialLines found;
  std::optional<std::size_t> series;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    const KeywordLine& line = file.lines[i];
    if (isKeyword(line, "*material")) {
      ++found.materials;
      if (!series)
        found.begin = i;
      else if (found.end == 0)
        found.end = i;
    }
    if (!isKeyword(line, "*viscoelastic")) continue;
    if (!has(line, "time=prony") && !has(line, "frequency=prony"))
      line.fail(
          "is neither TIME=PRONY nor FREQUENCY=PRONY; a table of frequencies and "
          "moduli is read as such");
    if (series) line.fail("is a second *VISCOELASTIC; keep the material that is meant alone");
    series = i;
  }
  if (!series) return {};
  if (found.end == 0) found.end = file.lines.size();
  return found;
}

/// Calls use for each data line of the keyword in line i, up to the next keyword; ** begins a
/// comment.
void forEachData(const std::vector<KeywordLine>& lines, std::size_t i,
                 const std::function<void(const KeywordLine&)>& use) {
  for (std::size_t k = i + 1; k < lines.size(); ++k) {
    const std::string& first = lines[k].words.front();
    if (first.starts_with("**") || (first.empty() && lines[k].words.size() == 1)) continue;
    if (first.starts_with("*")) break;
    use(lines[k]);
  }
}

/// A block of moduli, one row for each temperature.
struct ModulusBlock {
  TemperatureRows rows{};
  std::vector<double> shear{};
  bool isInstantaneous = false;  // else of long term, which is the default
};

/// How the constants of a data line make the shear modulus: those in the first place and in a
/// second one are added, and multiplied by a factor.
struct ModulusForm {
  std::string_view word;      // of the keyword
  double terms;               // N of the keyword, which is 1 where it has none; 0: any
  double factor;              // 2 of W = C10 (I1 - 3) + C01 (I2 - 3) + ...: G = 2 (C10 + C01)
  std::size_t second;         // 0: there is none
  std::size_t temperatureAt;  // place of the temperature after the constants
};

// OGDEN is W = sum 2 mu_i / alpha_i^2 (...): G = sum mu_i.
constexpr ModulusForm kHyperelastic[] = {{"neohooke", 0, 2, 0, 2},
                                         {"yeoh", 0, 2, 0, 6},
                                         {"mooney-rivlin", 0, 2, 1, 3},
                                         {"polynomial", 1, 2, 1, 3},
                                         {"reducedpolynomial", 1, 2, 0, 2},
                                         {"reducedpolynomial", 2, 2, 0, 4},
                                         {"reducedpolynomial", 3, 2, 0, 6},
                                         {"ogden", 1, 1, 0, 3},
                                         {"ogden", 2, 1, 2, 6}};
/// Young's modulus and Poisson's ratio.
constexpr ModulusForm kElastic{"*elastic", 0, 1, 1, 2};

const ModulusForm& modulusForm(const KeywordLine& keyword) {
  if (textParameter(keyword, "dependencies="))
    keyword.fail(
        "has moduli that depend on field variables, which are not read; give "
        "--equilibrium-modulus");
  if (isKeyword(keyword, kElastic.word)) {
    if (!textParameter(keyword, "type=").value_or("isotropic").starts_with("iso"))
      keyword.fail(
          "has moduli that differ with direction, which are not read; give "
          "--equilibrium-modulus");
    return kElastic;
  }
  const double terms = numberParameter(keyword, "n=").value_or(1);
  const auto* const form = std::ranges::find_if(kHyperelastic, [&](const ModulusForm& one) {
    return has(keyword, one.word) && (one.terms == 0 || one.terms == terms);
  });
  if (form == std::end(kHyperelastic) || has(keyword, "testdatainput"))
    keyword.fail(
        "has a hyperelastic form whose shear modulus is not read; NEO HOOKE, MOONEY-RIVLIN, YEOH, "
        "POLYNOMIAL (N=1), REDUCED POLYNOMIAL (N=1 to 3) and OGDEN (N=1 or 2) with their constants "
        "are, or give --equilibrium-modulus");
  return *form;
}

double shearModulus(const ModulusForm& form, const KeywordLine& data) {
  const double first = data.numberAt(0), second = form.second > 0 ? data.numberAt(form.second) : 0;
  return &form == &kElastic ? shearFromYoungs(first, second) : form.factor * (first + second);
}

/// Returns the moduli of a material; nothing where it has none. Throws InputError where it has two
/// blocks of them.
std::optional<ModulusBlock> readModuli(const KeywordFile& file, const MaterialLines& material) {
  std::optional<ModulusBlock> block;
  for (std::size_t i = material.begin; i < material.end; ++i) {
    const KeywordLine& keyword = file.lines[i];
    if (!isKeyword(keyword, "*elastic") && !isKeyword(keyword, "*hyperelastic")) continue;
    if (block) keyword.fail("is a second modulus of the same material; keep the one that is meant");
    const ModulusForm& form = modulusForm(keyword);
    block.emplace();
    block->isInstantaneous = has(keyword, "moduli=instantaneous");
    block->rows.line = keyword;
    forEachData(file.lines, i, [&](const KeywordLine& data) {
      block->shear.push_back(shearModulus(form, data));
      block->rows.temperatures.push_back(data.optionalNumberAt(form.temperatureAt));
    });
    if (block->shear.empty()) keyword.fail("has no modulus");
  }
  return block;
}

/// Reads *TRS: the reference temperature, then C1 and C2 of Williams, Landel and Ferry, or the
/// activation energy of Arrhenius. *PHYSICAL CONSTANTS has the gas constant in the unit of energy
/// of the model.
TemperatureShift readTrs(const KeywordLine& data, bool isArrhenius, double gasConstant,
                         std::optional<double> absoluteZero, const KeywordFile& file,
                         RawSeries& series) {
  TemperatureShift shift;
  shift.referenceTemperature = readReference(data.numberAt(0), absoluteZero, file.choices, series);
  if (isArrhenius) {
    shift.kind = ShiftKind::Arrhenius;
    shift.activationEnergy = data.numberAt(1) * kGasConstant / gasConstant;
  } else {
    shift.c1 = data.numberAt(1);
    shift.c2 = data.numberAt(2);
  }
  return shift;
}

}  // namespace

std::optional<RawSeries> abaqusSeries(const KeywordFile& file) {
  const std::optional<MaterialLines> material = materialWithSeries(file);
  if (!material) return {};
  RawSeries series;
  series.format = "keywords of Abaqus";
  if (const KeywordLine& first = file.lines[material->begin]; isKeyword(first, "*material")) {
    const std::string written = writtenName(first);
    series.material = written.empty() ? first.key() : written;
  }
  addMaterialNote(series.material, material->materials, series);
  double gasConstant = kGasConstant;
  std::optional<double> absoluteZero;
  for (const KeywordLine& line : file.lines) {
    if (!isKeyword(line, "*physicalconstants")) continue;
    gasConstant = numberParameter(line, "universalgasconstant=").value_or(gasConstant);
    absoluteZero = numberParameter(line, "absolutezero=");
  }
  for (std::size_t i = material->begin; i < material->end; ++i) {
    const KeywordLine& keyword = file.lines[i];
    if (isKeyword(keyword, "*viscoelastic")) {
      forEachData(file.lines, i, [&](const KeywordLine& data) {
        series.terms.push_back({data.numberAt(0), data.numberAt(2), data.number});
      });
    } else if (isKeyword(keyword, "*trs")) {
      const bool isArrhenius = has(keyword, "definition=arrhenius");
      if (keyword.words.size() > 1 && !isArrhenius && !has(keyword, "definition=wlf")) {
        series.notes.push_back(shiftLeftOut("*trs, " + keyword.words[1]));
        continue;
      }
      forEachData(file.lines, i, [&](const KeywordLine& data) {
        series.shift = readTrs(data, isArrhenius, gasConstant, absoluteZero, file, series);
      });
    }
  }
  if (!file.hasModulus) return series;
  if (const std::optional<ModulusBlock> moduli = readModuli(file, *material)) {
    const std::size_t row = chooseRows({moduli->rows}, absoluteZero, file, series).front();
    (moduli->isInstantaneous ? series.instantaneous : series.equilibrium) = moduli->shear[row];
  }
  return series;
}

}  // namespace asperity
