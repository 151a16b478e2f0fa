#include "core/base/text_row.h"

#include <charconv>
#include <system_error>

#include "core/base/text_number.h"

namespace asperity {
namespace {

bool isBlank(char letter) {
  return letter == ' ' || letter == '\t';
}

}  // namespace

bool readPlainRow(std::string_view line, const TextDialect& dialect, std::span<double> numbers) {
  using Separator = TextDialect::Separator;
  if (dialect.separator == Separator::CommaBlank || dialect.separator == Separator::CommaPair)
    return false;
  const char mark = markOf(dialect.separator);
  const bool atBlanks = dialect.separator == Separator::Blanks;
  const char* place = line.data();
  const char* const end = place + line.size();
  const auto skipBlanks = [&] {
    while (place != end && (*place == ' ' || (*place == '\t' && mark != '\t'))) ++place;
  };
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    skipBlanks();
    if (i > 0 && !atBlanks) {
      if (place == end || *place != mark) return false;
      ++place;
      skipBlanks();
    }
    if (place != end && *place == '+') ++place;
    // Neither "inf" nor "nan", which std::from_chars takes for numbers.
    const char* first = place != end && *place == '-' ? place + 1 : place;
    if (first == end || !(isDigit(*first) || *first == '.')) return false;
    if (dialect.decimal == '.') {
      const auto [stop, error] = std::from_chars(place, end, numbers[i]);
      if (error != std::errc{}) return false;
      place = stop;
    } else {
      const char* stop = place;
      while (stop != end && !isBlank(*stop) && *stop != mark) ++stop;
      const auto size = static_cast<std::size_t>(stop - place);
      if (!readTextNumber(std::string_view(place, size), ',', numbers[i])) return false;
      place = stop;
    }
    if (place != end && !isBlank(*place) && *place != mark) return false;
  }
  skipBlanks();
  return place == end;
}

}  // namespace asperity
