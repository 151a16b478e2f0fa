#include "core/material/prony_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_dialect.h"
#include "core/base/text_number.h"
#include "core/base/units.h"
#include "core/material/dma_columns.h"
#include "core/material/element_law.h"

namespace asperity {
namespace {

// What a file leaves out.
constexpr double kNotStated = std::numeric_limits<double>::quiet_NaN();

/// What all of these files say: parts of the instantaneous modulus or moduli, and one modulus.
struct RawSeries {
  struct Term {
    double weight = 0, time = 0;
    std::size_t line = 0;
  };
  std::vector<Term> terms;
  bool isRelative = true;             // weights are parts of the instantaneous modulus
  double instantaneous = kNotStated;  // in the file's unit, of shear
  double equilibrium = kNotStated;    // the same
  double unit = 1;                    // Pa
  bool isUnitKnown = false;
  std::optional<TemperatureShift> shift;
  Message format;
};

struct Line {
  std::vector<std::string> words;  // separated by commas, in lower case, without blanks
  std::size_t number = 0;
};

std::vector<Line> linesOf(std::string_view text) {
  std::vector<Line> lines;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = takeLine(text);
    Line next;
    next.number = number;
    std::string word;
    for (const char letter : lowerCase(line)) {
      if (letter == ',') {
        next.words.push_back(word);
        word.clear();
      } else if (letter != ' ' && letter != '\t') {
        word += letter;
      }
    }
    next.words.push_back(word);
    lines.push_back(std::move(next));
  }
  return lines;
}

double numberIn(const Line& line, std::size_t place, const std::string& name) {
  double value = 0;
  if (place >= line.words.size() || !readTextNumber(line.words[place], '.', value))
    throw InputError(name, fmt::format("line {}", line.number),
                     message("needs a number in place {}", place + 1));
  return value;
}

double shearOf(double youngs, double poisson) {
  return youngs / (2 * (1 + poisson));
}

bool has(const Line& line, std::string_view word) {
  return std::ranges::find(line.words, word) != line.words.end();
}

// ---- Abaqus ------------------------------------------------------------------------------------

std::optional<RawSeries> abaqusSeries(const std::vector<Line>& lines, const std::string& name) {
  const auto isKeyword = [](const Line& line, std::string_view word) {
    return line.words.front() == word;
  };
  if (std::ranges::none_of(lines,
                           [&](const Line& line) { return isKeyword(line, "*viscoelastic"); }))
    return {};
  RawSeries series;
  series.format = "keywords of Abaqus";
  std::size_t viscoelastics = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Line& keyword = lines[i];
    // Data lines follow until the next keyword; ** begins a comment.
    const auto forEachData = [&](const std::function<void(const Line&)>& use) {
      for (std::size_t k = i + 1; k < lines.size(); ++k) {
        const std::string& first = lines[k].words.front();
        if (first.starts_with("**") || (first.empty() && lines[k].words.size() == 1)) continue;
        if (first.starts_with("*")) break;
        use(lines[k]);
      }
    };
    const bool isInstantaneous = has(keyword, "moduli=instantaneous");
    const auto setModulus = [&](double shear) {
      (isInstantaneous ? series.instantaneous : series.equilibrium) = shear;
    };
    if (isKeyword(keyword, "*elastic")) {
      forEachData([&](const Line& data) {
        setModulus(shearOf(numberIn(data, 0, name), numberIn(data, 1, name)));
      });
    } else if (isKeyword(keyword, "*hyperelastic")) {
      const bool isMooney = has(keyword, "mooney-rivlin");
      if (!isMooney && !has(keyword, "neohooke") && !has(keyword, "yeoh"))
        throw InputError(name, fmt::format("line {}", keyword.number),
                         "has a hyperelastic form whose shear modulus is not read; NEO HOOKE, "
                         "MOONEY-RIVLIN and YEOH are, or give --equilibrium-modulus");
      forEachData([&](const Line& data) {
        setModulus(2 * (numberIn(data, 0, name) + (isMooney ? numberIn(data, 1, name) : 0)));
      });
    } else if (isKeyword(keyword, "*viscoelastic")) {
      if (!has(keyword, "time=prony"))
        throw InputError(name, fmt::format("line {}", keyword.number),
                         "is not TIME=PRONY; a table of frequencies and moduli is read as such");
      if (++viscoelastics > 1)
        throw InputError(name, fmt::format("line {}", keyword.number),
                         "is a second *VISCOELASTIC; keep the material that is meant alone");
      forEachData([&](const Line& data) {
        series.terms.push_back({numberIn(data, 0, name), numberIn(data, 2, name), data.number});
      });
    } else if (isKeyword(keyword, "*trs")) {
      if (keyword.words.size() > 1 && !has(keyword, "definition=wlf")) continue;
      forEachData([&](const Line& data) {
        TemperatureShift shift;
        // The file does not say its unit of temperature; rubbers have no reference above 200 °C.
        const double reference = numberIn(data, 0, name);
        shift.referenceTemperature = reference < 200 ? reference + kZeroCelsius : reference;
        shift.c1 = numberIn(data, 1, name);
        shift.c2 = numberIn(data, 2, name);
        series.shift = shift;
      });
    }
  }
  return series;
}

// ---- Ansys -------------------------------------------------------------------------------------

std::optional<RawSeries> ansysSeries(const std::vector<Line>& lines, const std::string& name) {
  enum class Table { Other, Shear, Shift } table = Table::Other;
  RawSeries series;
  series.format = "commands of Ansys";
  bool isFound = false;
  double youngs = kNotStated, poisson = kNotStated;
  std::vector<double> shearData, shiftData;
  std::size_t lineOfData = 0;
  for (const Line& line : lines) {
    const std::string& command = line.words.front();
    const auto word = [&](std::size_t i) {
      return i < line.words.size() ? line.words[i] : std::string();
    };
    if (command == "tb") {
      isFound = isFound || word(1) == "prony";
      table = word(1) == "prony" && word(5) != "bulk"  ? Table::Shear
              : word(1) == "shift" && word(5) == "wlf" ? Table::Shift
                                                       : Table::Other;
    } else if (command == "tbdata" && table != Table::Other) {
      std::vector<double>& data = table == Table::Shear ? shearData : shiftData;
      const double start = numberIn(line, 1, name);
      if (!(start >= 1 && start <= 200))
        throw InputError(name, fmt::format("line {}", line.number),
                         "begins at a place that is outside 1 to 200");
      lineOfData = line.number;
      auto place = static_cast<std::size_t>(start) - 1;
      for (std::size_t i = 2; i < line.words.size(); ++i, ++place) {
        if (line.words[i].empty()) continue;
        data.resize(std::max(data.size(), place + 1), kNotStated);
        data[place] = numberIn(line, i, name);
      }
    } else if (command == "mp" && word(1) == "ex") {
      youngs = numberIn(line, 3, name);
    } else if (command == "mp" && (word(1) == "nuxy" || word(1) == "prxy")) {
      poisson = numberIn(line, 3, name);
    } else if (command == "mp" && word(1) == "gxy") {
      series.instantaneous = numberIn(line, 3, name);
    }
  }
  if (!isFound) return {};
  for (std::size_t i = 0; i + 1 < shearData.size(); i += 2)
    series.terms.push_back({shearData[i], shearData[i + 1], lineOfData});
  if (std::isfinite(youngs))
    series.instantaneous = shearOf(youngs, std::isfinite(poisson) ? poisson : 0.5);
  if (shiftData.size() >= 3) {
    TemperatureShift shift;
    shift.referenceTemperature = shiftData[0] < 200 ? shiftData[0] + kZeroCelsius : shiftData[0];
    shift.c1 = shiftData[1];
    shift.c2 = shiftData[2];
    series.shift = shift;
  }
  return series;
}

// ---- A table -----------------------------------------------------------------------------------

/// "G_inf", "g∞", "Equilibrium modulus", "E0" and the like, without marks.
std::string plainWord(std::string_view text) {
  std::string word = lowerCase(text);
  for (const std::string_view infinity : {"\u221E", "infinity", "infty"})
    for (std::size_t at; (at = word.find(infinity)) != word.npos;)
      word.replace(at, infinity.size(), "inf");
  for (const std::string_view tau : {"\u03C4", "\u03A4"})
    for (std::size_t at; (at = word.find(tau)) != word.npos;) word.replace(at, tau.size(), "tau");
  std::erase_if(word, [](char letter) {
    return letter == ' ' || letter == '_' || letter == '-' || letter == '.' || letter == '{' ||
           letter == '}' || letter == '(' || letter == ')';
  });
  return word;
}

bool isEquilibrium(const std::string& word) {
  return isOneOf(word, {"ginf", "einf", "equilibriummodulus", "longtermmodulus", "rubberymodulus",
                        "ge", "ee", "gequilibrium", "inf"});
}

bool isInstantaneous(const std::string& word) {
  return isOneOf(word, {"g0", "e0", "instantaneousmodulus", "shorttermmodulus", "glassymodulus",
                        "gglassy", "eglassy"});
}

std::optional<RawSeries> tableSeries(const TextTable& table, const std::string& name,
                                     const PronyChoices& choices) {
  const TextBlock& block = table.largest();
  constexpr auto kNone = static_cast<std::size_t>(-1);
  std::size_t timeAt = kNone, weightAt = kNone;
  for (std::size_t i = 0; i < block.columns.size(); ++i) {
    const std::string word = plainWord(block.columns[i].name);
    if (dmaColumn(block.columns[i].name, block.columns[i].unit).quantity == DmaQuantity::Frequency)
      return {};
    if (timeAt == kNone && (word.starts_with("tau") || word.starts_with("relaxationtime") ||
                            word.starts_with("relaxationszeit") || isOneOf(word, {"ti", "times"})))
      timeAt = i;
    else if (weightAt == kNone &&
             (isOneOf(word, {"g", "gi", "e", "ei", "modulus", "moduli", "alpha", "alphai", "gimod",
                             "shearmodulus", "relativemodulus", "giginf", "gk", "ek"})))
      weightAt = i;
  }
  if (timeAt == kNone || weightAt == kNone) return {};

  RawSeries series;
  series.format = "a table of relaxation times and moduli";
  const TextColumn& weights = block.columns[weightAt];
  const auto pressure = sizeOfUnit(weights.unit, "Pa");
  series.isUnitKnown = pressure.has_value();
  if (pressure) series.unit = *pressure;
  const double timeSize = sizeOfUnit(block.columns[timeAt].unit, "s").value_or(1);

  ModulusKind kind = choices.modulus;
  if (kind == ModulusKind::Unknown)
    kind = plainWord(weights.name).starts_with("e") ? ModulusKind::Tension : ModulusKind::Shear;
  const double shear = kind == ModulusKind::Tension ? shearOf(1, choices.poissonRatio) : 1;

  // A row without a relaxation time, or with an infinite one, is the equilibrium modulus.
  double sum = 0, largest = 0;
  for (std::size_t row = 0; row < block.rows; ++row) {
    const double time = block.at(row, timeAt), weight = block.at(row, weightAt);
    if (!std::isfinite(weight)) continue;
    if (!std::isfinite(time)) {
      series.equilibrium = weight * shear;
      continue;
    }
    series.terms.push_back({weight, time * timeSize, block.lines[row]});
    sum += weight;
    largest = std::max(largest, weight);
  }
  for (const TextEntry& entry : block.header)
    if (const auto quantity = quantityIn(entry.value)) {
      const std::string word = plainWord(entry.key);
      const double size = sizeOfUnit(quantity->unit, "Pa").value_or(series.unit) / series.unit;
      if (isEquilibrium(word)) series.equilibrium = quantity->number * size * shear;
      if (isInstantaneous(word)) series.instantaneous = quantity->number * size * shear;
    }
  // Parts of the instantaneous modulus have no unit, and their sum is at most 1.
  series.isRelative = !series.isUnitKnown && largest < 1 && sum <= 1 + 1e-6;
  if (!series.isRelative)
    for (RawSeries::Term& term : series.terms) term.weight *= shear;
  if (series.isRelative && std::isfinite(series.equilibrium) && series.equilibrium < shear)
    series.equilibrium = kNotStated;  // a part, too: what is left of 1
  if (series.terms.empty()) throw InputError(name, "", "holds no relaxation time");
  return series;
}

// ---- All ---------------------------------------------------------------------------------------

void checkTerms(const RawSeries& series, const std::string& name) {
  if (series.terms.empty()) throw InputError(name, "", "holds no term of a Prony series");
  constexpr std::size_t kMostTerms = 64;
  if (series.terms.size() > kMostTerms)
    throw InputError(name, "",
                     message("has {} terms; allowed is {}", series.terms.size(), kMostTerms));
  double sum = 0;
  for (const RawSeries::Term& term : series.terms) {
    const std::string line = fmt::format("line {}", term.line);
    if (!(term.weight >= 0))
      throw InputError(name, line,
                       message("the modulus is {}, which must be at least 0", plain(term.weight)));
    if (!(term.time > 0 && term.time <= 1e12))
      throw InputError(
          name, line,
          message("the relaxation time is {} s, which must be above 0", plain(term.time)));
    sum += term.weight;
  }
  if (series.isRelative && sum > 1 + 1e-6)
    throw InputError(
        name, "",
        message("the parts of the instantaneous modulus add up to {:.6g}, more than 1", sum));
}

PronyFile finished(const RawSeries& series, const std::string& name, const PronyChoices& choices) {
  checkTerms(series, name);
  double unit = series.unit;
  if (!choices.modulusUnit.empty()) {
    const auto chosen = sizeOfUnit(choices.modulusUnit, "Pa");
    if (!chosen)
      throw InputError(
          "", "--modulus-unit",
          notOneOf(choices.modulusUnit, std::vector<std::string_view>{"Pa", "kPa", "MPa", "GPa"}));
    unit = *chosen;
  }
  double sum = 0;
  for (const RawSeries::Term& term : series.terms) sum += term.weight;
  double equilibrium = series.equilibrium * unit, instantaneous = series.instantaneous * unit;
  if (std::isfinite(choices.instantaneousModulus)) {
    instantaneous = choices.instantaneousModulus;
    equilibrium = kNotStated;
  }
  if (std::isfinite(choices.equilibriumModulus)) equilibrium = choices.equilibriumModulus;
  if (series.isRelative && !std::isfinite(instantaneous) && !std::isfinite(equilibrium))
    throw InputError(name, "",
                     "has parts of a modulus and not the modulus itself; give the instantaneous "
                     "shear modulus with --instantaneous-modulus, or --equilibrium-modulus");
  const double rest = std::max(0.0, 1 - sum);
  if (series.isRelative && !std::isfinite(instantaneous)) {
    if (!(rest > 1e-9))
      throw InputError(name, "",
                       "has parts that add up to 1, so that its long-term modulus is 0; give "
                       "--instantaneous-modulus, and --liquid if that is meant");
    instantaneous = equilibrium / rest;
  }
  PronyFile file;
  file.format = series.format;
  file.shift = series.shift;
  for (const RawSeries::Term& term : series.terms)
    if (term.weight > 0)
      file.arms.push_back({term.weight * (series.isRelative ? instantaneous : unit), term.time});
  if (file.arms.empty()) throw InputError(name, "", "has no arm with a modulus above 0");
  file.arms = joinedArms(std::move(file.arms));
  if (std::isfinite(equilibrium))
    file.equilibriumModulus = equilibrium;
  else if (series.isRelative)
    file.equilibriumModulus = instantaneous * (rest > 1e-9 ? rest : 0);
  else if (std::isfinite(instantaneous))
    file.equilibriumModulus = instantaneous - sum * unit;
  if (!choices.isLiquid && !(file.equilibriumModulus > 0))
    throw InputError(name, "equilibrium modulus",
                     "is not above 0, as of a liquid, which cannot carry a load for ever; give "
                     "--equilibrium-modulus, or allow it with --liquid");
  file.equilibriumModulus = std::max(0.0, file.equilibriumModulus);
  double stiffest = file.equilibriumModulus;
  for (const Arm& arm : file.arms) stiffest += arm.modulus;
  if (!series.isUnitKnown && choices.modulusUnit.empty())
    refuseSoftModulus(name, "modulus", stiffest);
  return file;
}

}  // namespace

std::optional<PronyFile> readPronyFile(std::string_view text, const TextTable* table,
                                       const std::string& name, const PronyChoices& choices) {
  const std::vector<Line> lines = linesOf(text);
  std::optional<RawSeries> series = abaqusSeries(lines, name);
  if (!series) series = ansysSeries(lines, name);
  if (!series && table) series = tableSeries(*table, name, choices);
  if (!series) return {};
  return finished(*series, name, choices);
}

}  // namespace asperity
