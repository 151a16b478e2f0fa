#include "core/material/prony_keywords.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text_dialect.h"
#include "core/base/text_number.h"
#include "core/material/dma_columns.h"
#include "core/material/temperature_shift.h"

namespace asperity {
namespace {

struct Line {
  std::vector<std::string> words;  // separated by commas, in lower case, without blanks
  std::size_t number = 0;
};

std::vector<Line> splitIntoLines(std::string_view text) {
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

double numberAt(const Line& line, std::size_t index, const std::string& name) {
  double value = 0;
  if (index >= line.words.size() || !readTextNumber(line.words[index], '.', value))
    throw InputError(name, fmt::format("line {}", line.number),
                     message("needs a number in place {}", index + 1));
  return value;
}

bool has(const Line& line, std::string_view word) {
  return std::ranges::find(line.words, word) != line.words.end();
}

/// Returns the reference temperature of a shift in K. The files of finite-element programs do not
/// state its unit: below 200 it is taken for °C, as no rubber has a reference above 200 °C.
double readReference(double number, const PronyChoices& choices, RawSeries& series) {
  constexpr double kKelvinFrom = 200, kDoubtFrom = 100, kDoubtTo = 250;
  if (const auto unit = temperatureUnit(choices.temperatureUnit)) return unit->toSi(number);
  const char* taken = number < kKelvinFrom ? "\u00B0C" : "K";
  if (number >= kDoubtFrom && number <= kDoubtTo)
    series.notes.push_back(message(
        "the reference temperature {} of the file is taken in {}; --temperature-unit says another",
        plain(number), taken));
  return temperatureUnit(taken)->toSi(number);
}

Message leftOut(std::string keyword) {
  std::ranges::transform(keyword, keyword.begin(), [](unsigned char letter) {
    return static_cast<char>(std::toupper(letter));
  });
  return message(
      "the shift with temperature by {} is left out; one of Williams, Landel and Ferry "
      "(WLF) is read",
      keyword);
}

/// Throws InputError for values that no scene accepts.
void checkShift(const TemperatureShift& shift, const std::string& name) {
  const auto check = [&](const char* what, double value, double least, double most) {
    if (!(value >= least && value <= most))
      throw InputError(name, "shift",
                       message("{} is {}, outside {} to {}", Message::name(what), plain(value),
                               plain(least), plain(most)));
  };
  check("T_r", shift.referenceTemperature, 1, 2000);
  if (shift.kind == ShiftKind::Arrhenius) {
    check("E_a", shift.activationEnergy, 0, kMostActivationEnergy);
  } else {
    check("C1", shift.c1, 0, kMostC1);
    check("C2", shift.c2, kLeastC2, kMostC2);
  }
}

// ---- Abaqus ------------------------------------------------------------------------------------

/// Returns the number behind "absolutezero=" among the words of a keyword; nothing where there is
/// none.
std::optional<double> keywordParameter(const Line& keyword, std::string_view parameter) {
  for (const std::string_view word : keyword.words) {
    double value = 0;
    if (word.starts_with(parameter) && readTextNumber(word.substr(parameter.size()), '.', value))
      return value;
  }
  return {};
}

/// Reads *TRS (Abaqus Keywords Reference): the reference temperature, then C1 and C2 of Williams,
/// Landel and Ferry, or the activation energy of Arrhenius. *PHYSICAL CONSTANTS has the gas
/// constant in the unit of energy of the model.
TemperatureShift trsShift(const Line& data, bool isArrhenius, const std::vector<Line>& lines,
                          const std::string& name, const PronyChoices& choices, RawSeries& series) {
  double gasConstant = kGasConstant;
  std::optional<double> zero;
  for (const Line& line : lines) {
    if (line.words.front() != "*physicalconstants") continue;
    gasConstant = keywordParameter(line, "universalgasconstant=").value_or(gasConstant);
    zero = keywordParameter(line, "absolutezero=");
  }
  TemperatureShift shift;
  const double reference = numberAt(data, 0, name);
  shift.referenceTemperature = zero && choices.temperatureUnit.empty()
                                   ? reference - *zero
                                   : readReference(reference, choices, series);
  if (isArrhenius) {
    shift.kind = ShiftKind::Arrhenius;
    shift.activationEnergy = numberAt(data, 1, name) * kGasConstant / gasConstant;
  } else {
    shift.c1 = numberAt(data, 1, name);
    shift.c2 = numberAt(data, 2, name);
  }
  return shift;
}

std::optional<RawSeries> abaqusSeries(const std::vector<Line>& lines, const std::string& name,
                                      const PronyChoices& choices) {
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
        setModulus(shearFromYoungs(numberAt(data, 0, name), numberAt(data, 1, name)));
      });
    } else if (isKeyword(keyword, "*hyperelastic")) {
      const bool isMooney = has(keyword, "mooney-rivlin");
      if (!isMooney && !has(keyword, "neohooke") && !has(keyword, "yeoh"))
        throw InputError(name, fmt::format("line {}", keyword.number),
                         "has a hyperelastic form whose shear modulus is not read; NEO HOOKE, "
                         "MOONEY-RIVLIN and YEOH are, or give --equilibrium-modulus");
      forEachData([&](const Line& data) {
        setModulus(2 * (numberAt(data, 0, name) + (isMooney ? numberAt(data, 1, name) : 0)));
      });
    } else if (isKeyword(keyword, "*viscoelastic")) {
      if (!has(keyword, "time=prony"))
        throw InputError(name, fmt::format("line {}", keyword.number),
                         "is not TIME=PRONY; a table of frequencies and moduli is read as such");
      if (++viscoelastics > 1)
        throw InputError(name, fmt::format("line {}", keyword.number),
                         "is a second *VISCOELASTIC; keep the material that is meant alone");
      forEachData([&](const Line& data) {
        series.terms.push_back({numberAt(data, 0, name), numberAt(data, 2, name), data.number});
      });
    } else if (isKeyword(keyword, "*trs")) {
      const bool isArrhenius = has(keyword, "definition=arrhenius");
      if (keyword.words.size() > 1 && !isArrhenius && !has(keyword, "definition=wlf")) {
        series.notes.push_back(leftOut("*trs, " + keyword.words[1]));
        continue;
      }
      forEachData([&](const Line& data) {
        series.shift = trsShift(data, isArrhenius, lines, name, choices, series);
      });
    }
  }
  return series;
}

// ---- Ansys -------------------------------------------------------------------------------------

std::optional<RawSeries> ansysSeries(const std::vector<Line>& lines, const std::string& name,
                                     const PronyChoices& choices) {
  enum class Table { Other, Shear, Shift } table = Table::Other;
  RawSeries series;
  series.format = "commands of Ansys";
  bool isFound = false;
  double youngs = RawSeries::kNotStated, poisson = RawSeries::kNotStated;
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
      if (word(1) == "shift" && table == Table::Other)
        series.notes.push_back(leftOut("tb,shift," + word(5)));
    } else if (command == "tbdata" && table != Table::Other) {
      std::vector<double>& data = table == Table::Shear ? shearData : shiftData;
      const double start = numberAt(line, 1, name);
      if (!(start >= 1 && start <= 200))
        throw InputError(name, fmt::format("line {}", line.number),
                         "begins at a place that is outside 1 to 200");
      lineOfData = line.number;
      auto index = static_cast<std::size_t>(start) - 1;
      for (std::size_t i = 2; i < line.words.size(); ++i, ++index) {
        if (line.words[i].empty()) continue;
        data.resize(std::max(data.size(), index + 1), RawSeries::kNotStated);
        data[index] = numberAt(line, i, name);
      }
    } else if (command == "mp" && word(1) == "ex") {
      youngs = numberAt(line, 3, name);
    } else if (command == "mp" && (word(1) == "nuxy" || word(1) == "prxy")) {
      poisson = numberAt(line, 3, name);
    } else if (command == "mp" && word(1) == "gxy") {
      series.instantaneous = numberAt(line, 3, name);
    }
  }
  if (!isFound) return {};
  for (std::size_t i = 0; i + 1 < shearData.size(); i += 2)
    series.terms.push_back({shearData[i], shearData[i + 1], lineOfData});
  if (std::isfinite(youngs))
    series.instantaneous = shearFromYoungs(youngs, std::isfinite(poisson) ? poisson : 0.5);
  if (shiftData.size() >= 3) {
    TemperatureShift shift;
    shift.referenceTemperature = readReference(shiftData[0], choices, series);
    shift.c1 = shiftData[1];
    shift.c2 = shiftData[2];
    series.shift = shift;
  }
  return series;
}

// ---- LS-DYNA -----------------------------------------------------------------------------------

void refuseDyna(const std::vector<Line>& lines, const std::string& name) {
  for (const Line& line : lines)
    if (line.words.front().starts_with("*mat_"))
      throw InputError(name, fmt::format("line {}", line.number),
                       "is a keyword of LS-DYNA, which is not read; write the Prony series as a "
                       "table with columns tau (s) and G (MPa), whose tau is 1/beta, and the "
                       "equilibrium modulus in a row with tau = inf");
}

}  // namespace

std::optional<RawSeries> keywordSeries(std::string_view text, const std::string& name,
                                       const PronyChoices& choices) {
  const std::vector<Line> lines = splitIntoLines(text);
  std::optional<RawSeries> series = abaqusSeries(lines, name, choices);
  if (!series) series = ansysSeries(lines, name, choices);
  if (!series) refuseDyna(lines, name);
  if (series && series->shift) checkShift(*series->shift, name);
  return series;
}

}  // namespace asperity
