#include "core/material/prony_keywords.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text_dialect.h"
#include "core/base/text_number.h"
#include "core/material/dma_columns.h"
#include "core/material/temperature_shift.h"

namespace asperity {
namespace {

std::vector<KeywordLine> splitIntoLines(std::string_view text, const std::string& name) {
  std::vector<KeywordLine> lines;
  for (std::size_t number = 1; !text.empty(); ++number) {
    KeywordLine next{name, takeLine(text), number};
    std::string word;
    for (const char letter : lowerCase(next.text)) {
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

/// Throws InputError for values that no scene accepts.
void checkRange(const char* what, double value, double least, double most, const char* key,
                const std::string& name) {
  if (!(value >= least && value <= most))
    throw InputError(name, key,
                     message("{} is {}, outside {} to {}", Message::name(what), plain(value),
                             plain(least), plain(most)));
}

constexpr double kColdest = 1, kHottest = 2000;  // K

void checkShift(const TemperatureShift& shift, const std::string& name) {
  checkRange("T_r", shift.referenceTemperature, kColdest, kHottest, "shift", name);
  if (shift.kind == ShiftKind::Arrhenius) {
    checkRange("E_a", shift.activationEnergy, 0, kMaxActivationEnergy, "shift", name);
  } else {
    checkRange("C1", shift.c1, 0, kMaxC1, "shift", name);
    checkRange("C2", shift.c2, kMinC2, kMaxC2, "shift", name);
  }
}

// ---- Other programs ----------------------------------------------------------------------------

/// Throws InputError where a file has materials of finite-element programs that are not read.
void refuseOthers(const std::vector<KeywordLine>& lines) {
  constexpr std::pair<std::string_view, const char*> kOthers[] = {{"*mat_", "LS-DYNA"},
                                                                  {"matve", "Nastran"},
                                                                  {"/visc/", "Radioss"},
                                                                  {"<febio_spec", "FEBio"},
                                                                  {"<material", "FEBio"}};
  for (const KeywordLine& line : lines)
    for (const auto& [begin, program] : kOthers)
      if (line.words.front().starts_with(begin))
        line.fail(
            message("is a keyword of {} that is not read; those of Abaqus, Ansys and LS-DYNA "
                    "(*MAT_GENERAL_VISCOELASTIC, *MAT_VISCOELASTIC) are, or write the Prony series "
                    "as a table with columns tau (s) and G (MPa), whose tau is 1/beta, and the "
                    "equilibrium modulus in a row with tau = inf",
                    program));
}

// ---- Temperatures ------------------------------------------------------------------------------

/// The unit of a file's temperatures.
struct TemperatureScale {
  std::optional<double> absoluteZero;  // in this unit, where the file states it
  Unit unit{};                         // elsewhere
  const char* assumed = nullptr;       // its name, where neither the file nor the user states it

  double kelvin(double number) const {
    return absoluteZero ? number - *absoluteZero : unit.toSi(number);
  }
};

/// The files of finite-element programs do not state a unit. lowest: the lowest number.
TemperatureScale temperatureScale(double lowest, std::optional<double> absoluteZero,
                                  const PronyChoices& choices) {
  if (const auto unit = temperatureUnit(choices.temperatureUnit)) return {{}, *unit, nullptr};
  if (absoluteZero) return {absoluteZero, {}, nullptr};
  const char* taken = assumedTemperatureUnit(lowest);
  return {{}, *temperatureUnit(taken), taken};
}

/// Returns whether a table states at which temperatures its rows hold.
bool statesTemperatures(const TemperatureRows& table) {
  return table.temperatures.size() > 1 ||
         (table.temperatures.size() == 1 && table.temperatures.front().value_or(0) != 0);
}

std::vector<double> kelvins(const TemperatureRows& table, const TemperatureScale& scale) {
  std::vector<double> temperatures;
  for (const auto& temperature : table.temperatures)
    temperatures.push_back(scale.kelvin(temperature.value_or(0)));
  return temperatures;
}

/// Returns "0.0 °C, 50.0 °C", each once.
Message listTemperatures(std::vector<double> kelvins) {
  std::ranges::sort(kelvins);
  std::vector<Message> list;
  for (const double kelvin : kelvins) {
    Message next = celsius(kelvin);
    if (list.empty() || !(list.back() == next)) list.push_back(std::move(next));
  }
  return listed(list);
}

/// Returns the row of a table at the wanted temperature (K), which is the reference of the shift or
/// was chosen. Throws InputError where no row is within the tolerance, and where several are.
std::size_t rowAt(double wanted, const std::vector<double>& kelvins, const KeywordLine& line,
                  const KeywordFile& file, bool isReference) {
  const double tolerance = file.choices.temperatureTolerance;
  const auto nearest = std::ranges::min_element(
      kelvins, {}, [&](double kelvin) { return std::abs(kelvin - wanted); });
  if (std::abs(*nearest - wanted) > tolerance)
    line.fail(isReference
                  ? message("has values at {} and none within {} K of the reference of the shift, "
                            "{}; --temperature-tolerance allows more, or give "
                            "--equilibrium-modulus",
                            listTemperatures(kelvins), tolerance, celsius(wanted))
                  : message("has values at {} and none within {} K of {}; choose one of these with "
                            "--temperature, or allow more with --temperature-tolerance",
                            listTemperatures(kelvins), tolerance, celsius(wanted)));
  if (std::ranges::count(kelvins, *nearest) > 1)
    line.fail(message("has more than one row at {}; keep the one that is meant alone",
                      celsius(*nearest)));
  return static_cast<std::size_t>(nearest - kelvins.begin());
}

}  // namespace

// ---- What the readers share --------------------------------------------------------------------

std::string KeywordLine::word(std::size_t index) const {
  return index < words.size() ? words[index] : std::string();
}

std::string KeywordLine::key() const {
  return fmt::format("line {}", number);
}

double KeywordLine::numberAt(std::size_t index) const {
  double value = 0;
  if (index >= words.size() || !readTextNumber(words[index], '.', value))
    fail(message("needs a number in place {}", index + 1));
  return value;
}

std::optional<double> KeywordLine::optionalNumberAt(std::size_t index) const {
  return word(index).empty() ? std::nullopt : std::optional(numberAt(index));
}

void KeywordLine::fail(const Message& message) const {
  throw InputError(std::string(file), key(), message);
}

double readReference(double number, std::optional<double> absoluteZero, const PronyChoices& choices,
                     RawSeries& series) {
  constexpr double kDoubtFrom = 100, kDoubtTo = 250;
  const TemperatureScale scale = temperatureScale(number, absoluteZero, choices);
  if (scale.assumed && number >= kDoubtFrom && number <= kDoubtTo)
    series.notes.push_back(message(
        "the reference temperature {} of the file is taken in {}; --temperature-unit says another",
        plain(number), scale.assumed));
  return scale.kelvin(number);
}

Message shiftLeftOut(std::string keyword) {
  std::ranges::transform(keyword, keyword.begin(), [](unsigned char letter) {
    return static_cast<char>(std::toupper(letter));
  });
  return message(
      "the shift with temperature by {} is left out; one of Williams, Landel and Ferry "
      "(WLF) is read",
      keyword);
}

void addMaterialNote(const std::string& material, std::size_t materials, RawSeries& series) {
  if (materials > 1)
    series.notes.push_back(
        message("material {} is read: of the {} materials in the file, it has the series",
                Message::name(material), materials));
}

std::vector<std::size_t> chooseRows(const std::vector<TemperatureRows>& tables,
                                    std::optional<double> absoluteZero, const KeywordFile& file,
                                    RawSeries& series) {
  std::vector<std::size_t> rows(tables.size(), 0);
  double lowest = std::numeric_limits<double>::infinity();
  for (const TemperatureRows& table : tables)
    if (statesTemperatures(table))
      for (const auto& temperature : table.temperatures)
        lowest = std::min(lowest, temperature.value_or(0));
  const std::optional<double> chosen =
      series.shift ? series.shift->referenceTemperature : file.choices.temperature;
  if (std::isfinite(lowest)) {
    const TemperatureScale scale = temperatureScale(lowest, absoluteZero, file.choices);
    std::vector<std::vector<double>> stated(tables.size());  // K; empty where a table states none
    std::vector<double> all;
    for (std::size_t i = 0; i < tables.size(); ++i) {
      if (statesTemperatures(tables[i])) stated[i] = kelvins(tables[i], scale);
      all.insert(all.end(), stated[i].begin(), stated[i].end());
    }
    const auto [coldest, warmest] = std::ranges::minmax(all);
    if (!chosen && warmest - coldest > file.choices.temperatureTolerance)
      throw InputError(file.name, "temperature",
                       message("has several values in the file, {}; choose one with --temperature",
                               listTemperatures(all)));
    const double wanted = chosen.value_or(all.front());
    std::optional<double> used;
    for (std::size_t i = 0; i < tables.size(); ++i) {
      if (stated[i].empty()) continue;
      rows[i] = rowAt(wanted, stated[i], tables[i].line, file, series.shift.has_value());
      if (!used) used = stated[i][rows[i]];
    }
    series.temperature = used;
    series.notes.push_back(
        scale.assumed ? message("the values at {} are read, with the temperatures of the file in "
                                "{}; --temperature-unit says another",
                                celsius(*used), scale.assumed)
                      : message("the values at {} are read", celsius(*used)));
  }
  const bool hasLoneZero = std::ranges::any_of(tables, [](const TemperatureRows& table) {
    return !statesTemperatures(table) && !table.temperatures.empty() && table.temperatures.front();
  });
  if (hasLoneZero && chosen &&
      std::abs(temperatureScale(0, absoluteZero, file.choices).kelvin(0) - *chosen) >
          file.choices.temperatureTolerance)
    series.notes.push_back(
        "a single row at temperature 0 is read as one for every temperature: programs write 0 "
        "where none was chosen");
  return rows;
}

std::optional<RawSeries> keywordSeries(std::string_view text, const std::string& name,
                                       const PronyChoices& choices) {
  const std::vector<KeywordLine> lines = splitIntoLines(text, name);
  const auto read = [&](bool hasModulus) {
    const KeywordFile file{lines, name, choices, hasModulus};
    std::optional<RawSeries> series = abaqusSeries(file);
    if (!series) series = ansysSeries(file);
    return series ? series : dynaSeries(file);
  };
  std::optional<RawSeries> series;
  try {
    series = read(true);
  } catch (const InputError&) {
    // A modulus that the user gives replaces one that cannot be read.
    if (!choices.statesModulus()) throw;
    series = read(false);
  }
  if (!series) refuseOthers(lines);
  if (series && series->shift) checkShift(*series->shift, name);
  if (series && series->temperature)
    checkRange("T", *series->temperature, kColdest, kHottest, "temperature", name);
  return series;
}

}  // namespace asperity
