// Profiles of ISO 5436-2 (SMD, the format of its softgauges) and of PRF, a related format of NPL.
// Record 1 has one line for each axis: name (CX, CZ), type (A absolute, I incremental, R relative,
// M measured), number of points, unit, scale, type of number and, where incremental, the step.
// Record 2 has lines of words, in PRF with "SPACING CX step" among them. Record 3 has the numbers.
// A record ends with ETX, in PRF with a line EOR; texts may end with a zero byte.
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>

#include "core/base/text_encoding.h"
#include "core/measured/surface_draft.h"
#include "core/measured/uniform_positions.h"
#include "core/measured/word_reader.h"

namespace asperity {
namespace {

constexpr char kEndOfRecord = '\x03';

struct SmdAxis {
  std::string_view type;
  double points = 0;
  std::string_view unit;
  double scale = 1;
  double step = 0;  // 0: none stated
};

/// Returns the axis that a line such as "CX I 22401 mm 1.0e0 D 2.5e-4" describes; empty where the
/// line describes none.
std::optional<SmdAxis> axisIn(std::string_view line, std::string_view name) {
  constexpr std::size_t kMin = 5, kWithStep = 7;
  const std::vector<std::string_view> words = splitWords(line);
  if (words.size() < kMin || words[0] != name || words[1].size() != 1) return {};
  const auto points = parseFiniteNumber(words[2]), scale = parseFiniteNumber(words[4]);
  if (!points || !scale) return {};
  const auto step = words.size() >= kWithStep ? parseFiniteNumber(words[6]) : std::nullopt;
  return SmdAxis{words[1], *points, words[3], *scale, step.value_or(0)};
}

bool endsRecord(std::string_view line) {
  return line == "EOR" || line == "EOF" || line.find(kEndOfRecord) != std::string_view::npos;
}

bool isOfNumbers(std::string_view line) {
  const std::vector<std::string_view> words = splitWords(line);
  return !words.empty() && std::ranges::all_of(words, [](std::string_view word) {
    return parseFiniteNumber(word).has_value();
  });
}

/// Returns the text with blanks in place of the zero bytes that end its words.
std::string withoutZeros(std::string_view bytes) {
  std::string text(withoutByteOrderMark(bytes));
  std::ranges::replace(text, '\0', ' ');
  return text;
}

class SmdReader {
 public:
  SmdReader(const SurfaceSource& source, std::string_view text) : source_(source), reader_(text) {}

  SurfaceDraft read() {
    readHeader();
    const std::int64_t points = countOf(x_);
    if (countOf(z_) != points)
      source_.fail(
          message("the axes {} and {} have {} and {} points", "CX", "CZ", points, countOf(z_)));
    requireSize(source_, points, 1, firstLine_.size() + reader_.left() + 2, 2);
    readNumbers(static_cast<std::size_t>(points));
    SurfaceDraft draft;
    draft.grid.rows = 1;
    draft.grid.columns = points;
    draft.positionUnit = statedUnit(source_, "CX", x_.unit);
    draft.heightUnit = statedUnit(source_, "Z (CZ)", z_.unit);
    if (numbers_.size() == static_cast<std::size_t>(points))
      placeAtSteps(draft);
    else
      separateAxes(draft);
    return draft;
  }

 private:
  /// Reads records 1 and 2, and the first line of record 3.
  void readHeader() {
    std::optional<SmdAxis> x, z;
    int ends = 0;
    while (!reader_.atEnd()) {
      const std::string_view line = reader_.nextLine();
      if (line.starts_with("CY ") && axisIn(line, "CY"))
        source_.fail("has an axis CY; of SMD and PRF files profiles with CX and CZ are read");
      if (!x) x = axisIn(line, "CX");
      if (!z) z = axisIn(line, "CZ");
      if (!x || !z) continue;
      x_ = *x;
      z_ = *z;
      if (endsRecord(line) && ++ends == 2) return;
      // Some copies of such files have lost the marks between the records.
      if (isOfNumbers(line)) {
        firstLine_ = line;
        return;
      }
      readSpacing(line);
    }
    source_.fail(message("the header of the {} file has no end", "SMD"));
  }

  /// Reads a line "SPACING CX 2.5e-4".
  void readSpacing(std::string_view line) {
    const std::vector<std::string_view> words = splitWords(line);
    if (words.size() >= 3 && words[0] == "SPACING" && words[1] == "CX")
      spacing_ = parseFiniteNumber(words[2]).value_or(spacing_);
  }

  std::int64_t countOf(const SmdAxis& axis) const {
    const auto points = wholeNumber(axis.points);
    if (!points || *points < 1)
      source_.fail(message("the number of points of an axis is not a whole number from 1 to {}",
                           kMaxPoints));
    if (axis.scale == 0) source_.failNotAboveZero("scale");
    return *points;
  }

  /// Reads all numbers of record 3: one or two for each point.
  void readNumbers(std::size_t points) {
    std::string_view line = firstLine_.empty() ? reader_.nextLine() : firstLine_;
    for (bool isFirst = true;; line = reader_.nextLine(), isFirst = false) {
      const std::string_view content = line.substr(0, line.find(kEndOfRecord));
      const std::vector<std::string_view> words =
          splitWords(line == "EOR" || line == "EOF" ? "" : content);
      if (isFirst) inRows_ = words.size() == 2;
      for (const std::string_view word : words) addNumber(word, 2 * points);
      if (endsRecord(line) || reader_.atEnd()) break;
    }
    if (numbers_.size() != points && numbers_.size() != 2 * points)
      source_.fail(numbers_.size() < points ? message("line {}: ends after {} of {} heights",
                                                      reader_.line(), numbers_.size(), points)
                                            : message("line {}: has {} numbers for {} points",
                                                      reader_.line(), numbers_.size(), points));
  }

  void addNumber(std::string_view word, std::size_t most) {
    source_.reportPoint(numbers_.size(), most);
    const double number = parseHeight(source_, reader_.line(), word, numbers_.size());
    if (numbers_.size() == most)
      source_.fail(message("line {}: has more than the {} heights that the header says",
                           reader_.line(), most / 2));
    numbers_.push_back(number);
  }

  double heightOf(double number) const {
    const double height = number * z_.scale;
    return std::isfinite(height) ? height : kMissingHeight;
  }

  void placeAtSteps(SurfaceDraft& draft) {
    for (const double number : numbers_) draft.grid.height.push_back(heightOf(number));
    const double step = x_.step != 0 ? x_.step : spacing_;
    draft.hasPositions = step != 0;
    draft.grid.columnSpacing = draft.hasPositions ? std::abs(step * x_.scale) : 1;
    if (!draft.hasPositions) draft.positionUnit.reset();
  }

  /// Separates the numbers of both axes: x and z of one point after the other, or first all x.
  void separateAxes(SurfaceDraft& draft) {
    const std::size_t points = numbers_.size() / 2;
    const bool inTurn = inRows_ || !std::ranges::is_sorted(std::span(numbers_).first(points));
    std::vector<double> positions, heights;
    for (std::size_t i = 0; i < points; ++i) {
      const double position = numbers_[inTurn ? 2 * i : i];
      positions.push_back(position * x_.scale);
      heights.push_back(heightOf(numbers_[inTurn ? 2 * i + 1 : points + i]));
    }
    resampleUniformly(std::move(positions), std::move(heights), {}, source_, draft);
  }

  const SurfaceSource& source_;
  WordReader reader_;
  std::string_view firstLine_;  // of record 3, where the header was read up to it
  SmdAxis x_, z_;
  double spacing_ = 0;   // of the line SPACING; 0: there is none
  bool inRows_ = false;  // x and z stand in one line
  std::vector<double> numbers_;
};

}  // namespace

bool isSmd(const SurfaceSource& source) {
  constexpr std::size_t kLookedAt = 2048, kLines = 12;
  const std::string beginning = withoutZeros(source.bytes.substr(0, kLookedAt));
  WordReader reader(beginning);
  bool hasX = false, hasZ = false;
  for (std::size_t i = 0; i < kLines && !reader.atEnd(); ++i) {
    const std::string_view line = reader.nextLine();
    hasX = hasX || axisIn(line, "CX");
    hasZ = hasZ || axisIn(line, "CZ");
  }
  return hasX && hasZ;
}

SurfaceDraft readSmd(const SurfaceSource& source) {
  const std::string text = withoutZeros(source.bytes);
  const DecodedText decoded(text, source.name);
  return SmdReader(source, decoded.text).read();
}

}  // namespace asperity
