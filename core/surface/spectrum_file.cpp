#include "core/surface/spectrum_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/regular_file.h"
#include "core/base/text.h"

namespace asperity {
namespace {

constexpr std::size_t kLargestTable = std::size_t{1} << 26;  // bytes

enum class Abscissa { WaveNumber, SpatialFrequency, Wavelength };

constexpr std::string_view kWanted =
    "a spectrum is a table whose header names wave_number, spatial_frequency or wavelength, and "
    "the "
    "spectrum in another column";

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\"";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Fields of a row. Spaces separate where nothing else does, but not the words of a header from
/// their units in brackets.
std::vector<std::string_view> fieldsOf(std::string_view line, std::string_view separators) {
  std::vector<std::string_view> fields;
  const bool bySpace = separators == " ";
  while (true) {
    if (bySpace) line = trimmed(line);
    if (bySpace && line.empty()) return fields;
    const std::size_t end = line.find_first_of(separators);
    fields.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) return fields;
    line.remove_prefix(end + 1);
  }
}

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& letter : lower)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return lower;
}

struct Heading {
  std::string name;  // in lower case, '_' for spaces
  std::string unit;
};

/// "Wave number [1/um]" as wave_number and 1/um.
Heading headingOf(std::string_view field) {
  Heading heading;
  const std::size_t open = field.find_first_of("[(");
  if (open != std::string_view::npos) {
    const char close = field[open] == '[' ? ']' : ')';
    const std::size_t end = field.rfind(close);
    if (end != std::string_view::npos && end > open)
      heading.unit = trimmed(field.substr(open + 1, end - open - 1));
  }
  heading.name = lowerCase(trimmed(field.substr(0, open)));
  std::ranges::replace(heading.name, ' ', '_');
  std::ranges::replace(heading.name, '-', '_');
  return heading;
}

std::optional<Abscissa> abscissaOf(std::string_view name) {
  constexpr std::array waveNumbers{"wave_number", "wavenumber", "angular_wave_number", "q", "k"};
  constexpr std::array frequencies{"spatial_frequency", "frequency", "f", "nu"};
  constexpr std::array wavelengths{"wavelength", "wave_length", "lambda"};
  if (std::ranges::find(waveNumbers, name) != waveNumbers.end()) return Abscissa::WaveNumber;
  if (std::ranges::find(frequencies, name) != frequencies.end()) return Abscissa::SpatialFrequency;
  if (std::ranges::find(wavelengths, name) != wavelengths.end()) return Abscissa::Wavelength;
  return {};
}

/// Metres to a power: "m", "1/um", "nm^-1", "rad/m", "m^3", "um3". Empty where it is none.
struct LengthUnit {
  double metres = 1;
  int power = 1;
};
std::optional<LengthUnit> lengthUnitOf(std::string_view text) {
  LengthUnit unit;
  int sign = 1;
  for (const std::string_view front : {"1/", "rad/"})
    if (text.starts_with(front)) {
      sign = -1;
      text.remove_prefix(front.size());
      break;
    }
  constexpr std::pair<std::string_view, double> kUnits[] = {
      {"\u00B5m", 1e-6}, {"\u03BCm", 1e-6}, {"um", 1e-6},   {"nm", 1e-9}, {"mm", 1e-3},
      {"cm", 1e-2},      {"km", 1e3},       {"in", 0.0254}, {"m", 1}};
  const auto found = std::ranges::find_if(
      kUnits, [&](const auto& known) { return text.starts_with(known.first); });
  if (found == std::end(kUnits)) return {};
  unit.metres = found->second;
  text.remove_prefix(found->first.size());
  if (text.starts_with('^')) text.remove_prefix(1);
  constexpr std::pair<std::string_view, int> kPowers[] = {
      {"", 1},       {"2", 2},      {"3", 3},
      {"4", 4},      {"-1", -1},    {"\u00B2", 2},
      {"\u00B3", 3}, {"\u2074", 4}, {"\u207B\u00B9", -1},
      {"{-1}", -1},  {"{3}", 3},    {"{4}", 4}};
  const auto power = std::ranges::find(kPowers, text, &std::pair<std::string_view, int>::first);
  if (power == std::end(kPowers)) return {};
  unit.power = sign * power->second;
  return unit;
}

/// So many SI units are one of the unit; the power of the length must be as the column needs it.
double factorOf(const Heading& heading, int power, const std::string& file, int line) {
  if (heading.unit.empty()) return 1;
  const auto unit = lengthUnitOf(heading.unit);
  if (!unit || unit->power != power)
    throw InputError(file, "",
                     message("line {}: {} is not a unit of {}; allowed is {}, with mm, um or nm as "
                             "well",
                             line, shortened(heading.unit), shortened(heading.name),
                             power == -1  ? "1/m"
                             : power == 1 ? "m"
                             : power == 3 ? "m^3"
                                          : "m^4"));
  return std::pow(unit->metres, power);
}

class Table {
 public:
  Table(std::string_view text, std::string name, SpectrumKind kind)
      : text_(text), name_(std::move(name)), kind_(kind) {}

  SpectralDensity read() {
    if (const std::string_view foreign = foreignKindOf(text_); !foreign.empty())
      throw InputError(name_, "", message("is {}; {}", Message(foreign), Message(kWanted)));
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
    while (!text_.empty()) {
      const std::size_t end = text_.find('\n');
      const std::string_view line = trimmed(text_.substr(0, end));
      text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
      ++line_;
      if (line.empty() || line[0] == '#' || line[0] == '%') {
        if (!hasHeader_ && line.size() > 1) tryHeader(trimmed(line.substr(1)));
        continue;
      }
      if (!hasHeader_ && tryHeader(line)) continue;
      if (!hasHeader_) fail(Message(kWanted));
      if (isUnitRow(line)) continue;
      addRow(line);
    }
    return finish();
  }

 private:
  [[noreturn]] void fail(const Message& what) const {
    throw InputError(name_, "", message("line {}: {}", line_, what));
  }

  /// Takes the line as a header where it names a column of wave numbers or the like.
  bool tryHeader(std::string_view line) {
    separators_ = line.find(';') != std::string_view::npos    ? ";"
                  : line.find('\t') != std::string_view::npos ? "\t"
                  : line.find(',') != std::string_view::npos  ? ","
                                                              : " ";
    std::vector<Heading> headings;
    for (const std::string_view field : fieldsOf(line, separators_)) {
      // "q [1/m]" separated by spaces: the unit belongs to the name before it.
      if (separators_ == " " && !headings.empty() &&
          (field.starts_with('[') || field.starts_with('('))) {
        headings.back().unit = headingOf(field).unit;
        continue;
      }
      headings.push_back(headingOf(field));
    }
    for (std::size_t i = 0; i < headings.size() && !hasHeader_; ++i) {
      const auto found = abscissaOf(headings[i].name);
      if (!found) continue;
      abscissa_ = *found;
      abscissaColumn_ = i;
      hasHeader_ = true;
    }
    if (!hasHeader_) return false;
    if (headings.size() < 2) fail(Message(kWanted));
    valueColumn_ =
        abscissaColumn_ + 1 < headings.size() ? abscissaColumn_ + 1 : abscissaColumn_ - 1;
    // A column that is named as a spectrum is taken before its neighbour.
    for (std::size_t i = 0; i < headings.size(); ++i)
      for (const std::string_view word : {"c", "c1", "c2", "psd", "spectrum", "c_iso", "c2_iso",
                                          "power_spectral_density", "density"})
        if (headings[i].name == word) valueColumn_ = i;
    setUnits(headings[abscissaColumn_], headings[valueColumn_]);
    return true;
  }

  void setUnits(const Heading& abscissa, const Heading& value) {
    toSi_ = factorOf(abscissa, abscissa_ == Abscissa::Wavelength ? 1 : -1, name_, line_);
    valueToSi_ = factorOf(value, kind_ == SpectrumKind::C2 ? 4 : 3, name_, line_);
  }

  /// A row below the header without a digit at its beginning: "1/m, m^3".
  bool isUnitRow(std::string_view line) {
    if (!waves_.empty() || hasUnitRow_) return false;
    const auto fields = fieldsOf(line, separators_);
    if (fields.size() <= std::max(abscissaColumn_, valueColumn_)) return false;
    const auto bare = [](std::string_view field) {
      if (field.size() > 2 && (field[0] == '[' || field[0] == '('))
        field = field.substr(1, field.size() - 2);
      return std::string(trimmed(field));
    };
    const std::string first = bare(fields[abscissaColumn_]), second = bare(fields[valueColumn_]);
    if (!lengthUnitOf(first)) return false;
    setUnits({"wave_number", first}, {"spectrum", second});
    return hasUnitRow_ = true;
  }

  double numberAt(const std::vector<std::string_view>& fields, std::size_t column) const {
    if (column >= fields.size())
      fail(message("has {} fields; {} are needed", fields.size(), column + 1));
    std::string field(fields[column]);
    if (separators_ != ",") std::ranges::replace(field, ',', '.');  // a decimal comma
    if (field.starts_with('+')) field.erase(0, 1);
    double number = 0;
    if (!readNumber(std::string_view(field), number) || !std::isfinite(number))
      fail(message("'{}' is not a finite number", shortened(fields[column])));
    return number;
  }

  void addRow(std::string_view line) {
    const auto fields = fieldsOf(line, separators_);
    const double x = numberAt(fields, abscissaColumn_) * toSi_;
    const double value = numberAt(fields, valueColumn_) * valueToSi_;
    if (x == 0 && abscissa_ != Abscissa::Wavelength) return;  // the mean
    if (!(x > 0)) fail(message("{} is not above 0", fields[abscissaColumn_]));
    if (value < 0) fail(message("the spectrum {} is below 0", fields[valueColumn_]));
    // Everything per wave number: C(q) dq = C(f) df, and C2(q) q dq = C2(f) f df.
    constexpr double kTwoPi = 2 * std::numbers::pi;
    const bool isAngular = abscissa_ == Abscissa::WaveNumber;
    const double q = isAngular ? x : abscissa_ == Abscissa::Wavelength ? kTwoPi / x : kTwoPi * x;
    const double perWave = isAngular ? 1 : 1 / kTwoPi;
    const double density = kind_ == SpectrumKind::C2
                               ? std::numbers::pi * q * value * perWave * perWave
                           : kind_ == SpectrumKind::C1OneSided ? value * perWave / 2
                                                               : value * perWave;
    if (!std::isfinite(q) || !std::isfinite(density)) fail("is beyond what a number can hold");
    waves_.push_back(q);
    densities_.push_back(density);
  }

  SpectralDensity finish() {
    if (!hasHeader_) throw InputError(name_, "", Message(kWanted));
    if (waves_.size() < 2)
      throw InputError(name_, "", message("has {} rows; at least 2 are needed", waves_.size()));
    std::vector<std::size_t> order(waves_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [this](std::size_t i) { return waves_[i]; });
    SpectralDensity density;
    for (const std::size_t i : order) {
      if (!density.empty() && waves_[i] == density.waveNumber.back())
        throw InputError(name_, "",
                         message("has two rows for the wave number {:.6g} 1/m", waves_[i]));
      density.waveNumber.push_back(waves_[i]);
      density.density.push_back(densities_[i]);
    }
    const double sum = density.integralTo(density.waveNumber.back());
    if (!std::isfinite(sum)) throw InputError(name_, "", "is beyond what a number can hold");
    if (!(sum > 0)) throw InputError(name_, "", "has no wave with a strength above 0");
    return density;
  }

  std::string_view text_;
  std::string name_;
  SpectrumKind kind_;
  int line_ = 0;
  std::string_view separators_ = ",";
  bool hasHeader_ = false, hasUnitRow_ = false;
  Abscissa abscissa_ = Abscissa::WaveNumber;
  std::size_t abscissaColumn_ = 0, valueColumn_ = 1;
  double toSi_ = 1, valueToSi_ = 1;
  std::vector<double> waves_, densities_;
};

}  // namespace

SpectralDensity parseSpectrum(std::string_view text, const std::string& name, SpectrumKind kind) {
  return Table(text, name, kind).read();
}

SpectralDensity readSpectrum(const std::filesystem::path& file, SpectrumKind kind) {
  return parseSpectrum(readRegularFile(file, kLargestTable), file.string(), kind);
}

}  // namespace asperity
