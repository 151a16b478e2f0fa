// A table in Markdown, columns aligned. A plain value.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

namespace asperity::bench {

class Table {
 public:
  explicit Table(std::vector<std::string> head) : rows_{std::move(head)} {}
  /// As many cells as the head has.
  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  bool isEmpty() const { return rows_.size() < 2; }
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

/// Three significant digits, large numbers with their thousands apart: 0.0123, 4.56, 12,300.
std::string number(double value);

/// Parts of one, as percent: 30 %, 0.05 %.
std::string percent(double part);

/// Seconds in the unit that reads best: 12.3 us, 1.5 ms, 2.0 s.
std::string duration(double seconds);

}  // namespace asperity::bench
