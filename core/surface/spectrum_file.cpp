#include "core/surface/spectrum_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/regular_file.h"
#include "core/base/statistics.h"
#include "core/base/text.h"
#include "core/base/text_encoding.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/base/text_table.h"
#include "core/base/text_units.h"

namespace asperity {
namespace {

constexpr std::size_t kLargestTable = std::size_t{1} << 26;  // bytes

enum class Abscissa { WaveNumber, SpatialFrequency, Wavelength };

constexpr const char* kSpectrumTable =
    "a spectrum is a table whose header names wave_number, spatial_frequency or wavelength, and "
    "the spectrum in another column";

/// Returns a name such as "Wave number" in the form wave_number.
std::string plainName(std::string_view name) {
  std::string plain = lowerCase(name);
  std::ranges::replace(plain, ' ', '_');
  std::ranges::replace(plain, '-', '_');
  return plain;
}

std::optional<Abscissa> abscissaOf(std::string_view name) {
  if (isOneOf(name, "wave_number wavenumber angular_wave_number q k wellenzahl nombre_d'onde"))
    return Abscissa::WaveNumber;
  if (isOneOf(name,
              "spatial_frequency frequency f nu ortsfrequenz raumfrequenz "
              "fr\u00E9quence_spatiale"))
    return Abscissa::SpatialFrequency;
  if (isOneOf(name, "wavelength wave_length lambda wellenl\u00E4nge longueur_d'onde"))
    return Abscissa::Wavelength;
  return {};
}

/// Names of the spectrum of a line, of an area, and of either.
constexpr WordList kOfLines("c1 c_1d psd_1d");
constexpr WordList kOfAreas("c2 c_iso c2_iso ciso c_2d psd_2d");
constexpr WordList kOfEither(
    "c psd spectrum power_spectral_density density leistungsdichte spektrale_leistungsdichte "
    "leistungsdichtespektrum spektrum densit\u00E9_spectrale");

/// Returns the size of the column's unit in SI; the power of the length must be the required one.
double factorOf(const TextColumn& column, int power, const std::string& file) {
  if (column.unit.empty()) return 1;
  const auto unit = parseLengthPower(column.unit);
  if (!unit || unit->power != power)
    throw InputError(
        file, "",
        message("{} is not a unit of {}; allowed is {}, with mm, \u00B5m or nm as well",
                shortened(column.unit), shortened(column.name),
                power == -1  ? "1/m"
                : power == 1 ? "m"
                : power == 3 ? "m^3"
                             : "m^4"));
  return std::pow(unit->metres, power);
}

/// What a unit says of a phase: "rad/m" counts radians, "cycles/mm" periods.
enum class Counts { Nothing, Radians, Cycles };

Counts countsOf(std::string_view unit) {
  const std::string word = lowerCase(unit);
  if (word.find("rad") != std::string::npos) return Counts::Radians;
  if (word.find("cyc") != std::string::npos) return Counts::Cycles;
  return Counts::Nothing;
}

/// Removes the sides from a name such as c1_one_sided and returns how many it states; 0: none.
int takeSides(std::string& name) {
  constexpr std::array<std::pair<std::string_view, int>, 8> kSides{{{"one_sided", 1},
                                                                    {"onesided", 1},
                                                                    {"single_sided", 1},
                                                                    {"1_sided", 1},
                                                                    {"two_sided", 2},
                                                                    {"twosided", 2},
                                                                    {"double_sided", 2},
                                                                    {"2_sided", 2}}};
  for (const auto& [words, sides] : kSides) {
    const std::size_t at = name.find(words);
    if (at == std::string::npos) continue;
    name.erase(at, words.size());
    while (name.ends_with('_')) name.pop_back();
    while (name.starts_with('_')) name.erase(0, 1);
    return sides;
  }
  return 0;
}

class SpectrumReader {
 public:
  SpectrumReader(TextBlock block, std::string name, SpectrumKind kind)
      : block_(std::move(block)), name_(std::move(name)), kind_(kind) {}

  SpectrumTable read() {
    findColumns();
    for (std::size_t row = 0; row < block_.rows; ++row) addRow(row);
    return {inOrder(), {columnsFact(), densityFact()}};
  }

 private:
  [[noreturn]] void fail(const Message& what) const { throw InputError(name_, "", what); }
  [[noreturn]] void failAt(std::size_t row, const Message& what) const {
    fail(message("line {}: {}", block_.lines[row], what));
  }

  /// Takes the text in brackets at the end of each name as its unit, also where it is no known one.
  void takeUnits() {
    for (TextColumn& column : block_.columns) {
      const std::size_t open = column.name.find_last_of("([");
      if (!column.unit.empty() || open == std::string::npos || open == 0 ||
          column.name.find_last_of(")]") + 1 != column.name.size())
        continue;
      column.unit = withoutBrackets(std::string_view(column.name).substr(open));
      column.name = trimmedBlanks(std::string_view(column.name).substr(0, open));
    }
  }

  /// Cycles belong to a spatial frequency, radians to a wave number.
  void checkCounts() {
    const TextColumn &wave = block_.columns[waveColumn_], &density = block_.columns[densityColumn_];
    const Counts counts = countsOf(wave.unit);
    const std::string name = plainName(wave.name);
    if (abscissa_ == Abscissa::WaveNumber && counts == Counts::Cycles && name != "q" &&
        name != "angular_wave_number")
      abscissa_ = Abscissa::SpatialFrequency;
    const auto contradicts = [this](Counts one) {
      return (abscissa_ == Abscissa::WaveNumber && one == Counts::Cycles) ||
             (abscissa_ != Abscissa::WaveNumber && one == Counts::Radians);
    };
    if (contradicts(counts))
      fail(
          message("{} in {} contradicts itself: a wave number is in rad/m, a spatial frequency in "
                  "cycles/m",
                  shortened(wave.name), shortened(wave.unit)));
    if (contradicts(countsOf(density.unit)))
      fail(
          message("{} in {} is not a density over {}: over a wave number it is per rad/m, over a "
                  "spatial frequency or a wavelength per cycles/m",
                  shortened(density.name), shortened(density.unit), shortened(wave.name)));
  }

  void findColumns() {
    takeUnits();
    const std::vector<TextColumn>& columns = block_.columns;
    // Of several abscissae the first wave number is used, else the first spatial frequency.
    std::optional<Abscissa> found;
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (const auto one = abscissaOf(plainName(columns[i].name));
          one && (!found || *one < *found)) {
        found = one;
        waveColumn_ = i;
      }
    if (!found || columns.size() < 2) fail(kSpectrumTable);
    abscissa_ = *found;
    findDensity();
    checkCounts();
    waveSize_ = factorOf(columns[waveColumn_], abscissa_ == Abscissa::Wavelength ? 1 : -1, name_);
    densitySize_ = factorOf(columns[densityColumn_], kind_ == SpectrumKind::C2 ? 4 : 3, name_);
  }

  /// Finds the column with the name of the wanted spectrum, else one with any name of a spectrum,
  /// else the neighbour of the abscissa.
  void findDensity() {
    const std::vector<TextColumn>& columns = block_.columns;
    const auto find = [&](const WordList& words) {
      return std::ranges::find_if(columns, [&](const TextColumn& column) {
        std::string name = plainName(column.name);
        takeSides(name);
        return isOneOf(name, words);
      });
    };
    const bool isOfArea = kind_ == SpectrumKind::C2;
    auto column = find(isOfArea ? kOfAreas : kOfLines);
    if (column == columns.end()) column = find(kOfEither);
    if (column == columns.end()) {
      if (const auto other = find(isOfArea ? kOfLines : kOfAreas); other != columns.end())
        fail(isOfArea
                 ? message("its column {} is a spectrum of a line, which surface.spectrum_kind "
                           "does not say",
                           shortened(other->name))
                 : message("its column {} is a spectrum of an area, which surface.spectrum_kind "
                           "does not say",
                           shortened(other->name)));
      for (std::size_t i : {waveColumn_ + 1, waveColumn_ - 1})
        if (column == columns.end() && i < columns.size() &&
            !abscissaOf(plainName(columns[i].name)))
          column = columns.begin() + static_cast<std::ptrdiff_t>(i);
      // Any name will do with the unit of such a density, but the root of a density is none.
      if (column != columns.end() &&
          (column->unit.empty() || plainName(column->name).starts_with("asd")))
        fail(
            message("its column {} is not known as a spectrum; allowed are C1, C2 or psd, or "
                    "another name with its unit",
                    shortened(column->name)));
    }
    if (column == columns.end()) fail(kSpectrumTable);
    std::string plain = plainName(column->name);
    const int sides = takeSides(plain);
    const int wanted = kind_ == SpectrumKind::C1OneSided   ? 1
                       : kind_ == SpectrumKind::C1TwoSided ? 2
                                                           : 0;
    if (sides != 0 && wanted != 0 && sides != wanted)
      fail(sides == 1 ? message("its column {} is one-sided, which surface.spectrum_kind does not "
                                "say",
                                shortened(column->name))
                      : message("its column {} is two-sided, which surface.spectrum_kind does not "
                                "say",
                                shortened(column->name)));
    densityColumn_ = static_cast<std::size_t>(column - columns.begin());
  }

  Message columnText(std::size_t index) const {
    const TextColumn& column = block_.columns[index];
    return column.unit.empty()
               ? message("column {} '{}' (in SI units)", index + 1, shortened(column.name))
               : message("column {} '{}' ({})", index + 1, shortened(column.name),
                         shortened(column.unit));
  }

  Message columnsFact() const {
    const Message wave = columnText(waveColumn_), density = columnText(densityColumn_);
    switch (abscissa_) {
      case Abscissa::WaveNumber:
        return message("wave numbers are {}, the spectrum is {}", wave, density);
      case Abscissa::SpatialFrequency:
        return message("spatial frequencies are {}, the spectrum is {}", wave, density);
      case Abscissa::Wavelength:
        break;
    }
    return message("wavelengths are {}, the spectrum is {}", wave, density);
  }

  /// States the integral that gives the mean square height.
  Message densityFact() const {
    const bool isAngular = abscissa_ == Abscissa::WaveNumber;
    if (kind_ == SpectrumKind::C2)
      return isAngular
                 ? "the spectrum is of an isotropic area, per wave number q: h\u00B2 = 2\u03C0 "
                   "\u222B C q dq"
                 : "the spectrum is of an isotropic area, per spatial frequency f = "
                   "1/wavelength: h\u00B2 = 2\u03C0 \u222B C f df";
    if (kind_ == SpectrumKind::C1OneSided)
      return isAngular ? "the spectrum is one-sided, per wave number q: h\u00B2 = \u222B C dq"
                       : "the spectrum is one-sided, per spatial frequency f = 1/wavelength: "
                         "h\u00B2 = \u222B C df";
    return isAngular ? "the spectrum is two-sided, per wave number q: h\u00B2 = 2 \u222B C dq"
                     : "the spectrum is two-sided, per spatial frequency f = 1/wavelength: "
                       "h\u00B2 = 2 \u222B C df";
  }

  double numberAt(std::size_t row, std::size_t column) const {
    const double number = block_.at(row, column);
    if (!std::isfinite(number))
      failAt(row, message("the value of {} is missing", shortened(block_.columns[column].name)));
    return number;
  }

  void addRow(std::size_t row) {
    const double x = numberAt(row, waveColumn_) * waveSize_;
    const double value = numberAt(row, densityColumn_) * densitySize_;
    if (x == 0 && abscissa_ != Abscissa::Wavelength) return;  // the mean
    if (!(x > 0)) failAt(row, message("{} is not above 0", plain(block_.at(row, waveColumn_))));
    if (value < 0)
      failAt(row, message("the spectrum {} is below 0", plain(block_.at(row, densityColumn_))));
    // All values become densities per wave number: C(q) dq = C(f) df, and C2(q) q dq = C2(f) f df.
    constexpr double kTwoPi = 2 * std::numbers::pi;
    const bool isAngular = abscissa_ == Abscissa::WaveNumber;
    const double q = isAngular ? x : abscissa_ == Abscissa::Wavelength ? kTwoPi / x : kTwoPi * x;
    const double perWave = isAngular ? 1 : 1 / kTwoPi;
    const double density = kind_ == SpectrumKind::C2
                               ? std::numbers::pi * q * value * perWave * perWave
                           : kind_ == SpectrumKind::C1OneSided ? value * perWave / 2
                                                               : value * perWave;
    if (!std::isfinite(q) || !std::isfinite(density))
      failAt(row, "is beyond what a number can hold");
    waves_.push_back(q);
    densities_.push_back(density);
  }

  SpectralDensity inOrder() const {
    if (waves_.size() < 2) fail(message("has {} rows; at least 2 are needed", waves_.size()));
    SpectralDensity density;
    for (const std::size_t i : ascendingOrder(waves_)) {
      if (!density.empty() && waves_[i] == density.waveNumber.back())
        fail(message("has two rows for the wave number {:.6g} 1/m", waves_[i]));
      density.waveNumber.push_back(waves_[i]);
      density.density.push_back(densities_[i]);
    }
    density.binEdge = findBinEdges(density.waveNumber);
    const double sum = density.integral();
    if (!std::isfinite(sum)) fail("is beyond what a number can hold");
    if (!(sum > 0)) fail("has no wave with a strength above 0");
    return density;
  }

  TextBlock block_;
  std::string name_;
  SpectrumKind kind_;
  Abscissa abscissa_ = Abscissa::WaveNumber;
  std::size_t waveColumn_ = 0, densityColumn_ = 1;
  double waveSize_ = 1, densitySize_ = 1;
  std::vector<double> waves_, densities_;
};

}  // namespace

SpectrumTable parseSpectrumTable(std::string_view text, const std::string& name,
                                 SpectrumKind kind) {
  if (const std::string_view foreign = detectNonText(text);
      !foreign.empty() && foreign != "text in UTF-16")
    throw InputError(name, "", message("is {}; {}", Message(foreign), Message(kSpectrumTable)));
  TextTable table = readTextTable(text, name);
  undoLogarithms(table, [](const std::string& quantity) {
    std::string plain = plainName(parseColumnName(quantity).name);
    takeSides(plain);
    return abscissaOf(plain) || isOneOf(plain, kOfLines) || isOneOf(plain, kOfAreas) ||
           isOneOf(plain, kOfEither);
  });
  refuseUnclearMark(table, name);
  return SpectrumReader(table.largest(), name, kind).read();
}

SpectrumTable readSpectrumTable(const std::filesystem::path& file, SpectrumKind kind) {
  return parseSpectrumTable(readRegularFile(file, kLargestTable), file.string(), kind);
}

}  // namespace asperity
