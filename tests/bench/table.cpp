#include "tests/bench/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::bench {
namespace {

std::string row(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths) {
  std::string text = "|";
  for (std::size_t i = 0; i < cells.size(); ++i)
    text += fmt::format(" {:<{}} |", cells[i], widths[i]);
  return text + "\n";
}

}  // namespace

std::string Table::text() const {
  std::vector<std::size_t> widths(rows_.front().size(), 3);
  for (const auto& cells : rows_)
    for (std::size_t i = 0; i < cells.size(); ++i) widths[i] = std::max(widths[i], cells[i].size());
  std::string text = row(rows_.front(), widths) + "|";
  for (const std::size_t width : widths) text += std::string(width + 2, '-') + "|";
  text += "\n";
  for (std::size_t i = 1; i < rows_.size(); ++i) text += row(rows_[i], widths);
  return text;
}

std::string number(double value) {
  if (!std::isfinite(value)) return "-";
  if (std::abs(value) < 999.5) return fmt::format("{:.3g}", value);
  const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - 2);
  std::string digits = fmt::format("{:.0f}", std::round(value / unit) * unit);
  for (std::size_t i = digits.size(); i > 3 && digits[i - 4] != '-'; i -= 3)
    digits.insert(i - 3, ",");
  return digits;
}

std::string percent(double part) {
  return part >= 1 - 1e-9 ? "100 %" : fmt::format("{:.2g} %", 100 * part);
}

std::string duration(double seconds) {
  if (seconds < 1e-3) return number(seconds * 1e6) + " us";
  if (seconds < 1) return number(seconds * 1e3) + " ms";
  return number(seconds) + " s";
}

}  // namespace asperity::bench
