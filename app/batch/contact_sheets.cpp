#include "app/batch/contact_sheets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace asperity {
namespace {

// largest width and height in pixels of one picture on a sheet
constexpr int kWidest = 480, kHighest = 960;
constexpr std::string_view kSheetName = "contact_sheet", kEnd = ".png";

}  // namespace

ContactSheets::ContactSheets(int count, int width, int height) : count_(std::max(count, 1)) {
  const double ratio = static_cast<double>(height) / width;
  cellHeight_ = std::clamp(static_cast<int>(kWidest * ratio), 1, kHighest);
  cellWidth_ =
      kWidest * ratio > kHighest ? std::max(1, static_cast<int>(kHighest / ratio)) : kWidest;
  const int side = static_cast<int>(std::ceil(std::sqrt(count_)));
  columns_ = std::min(side, kLargestSheet / cellWidth_);
  rows_ = std::min((count_ + columns_ - 1) / columns_, kLargestSheet / cellHeight_);
}

int ContactSheets::on(int sheet) const {
  return std::clamp(count_ - sheet * perSheet(), 0, perSheet());
}

int ContactSheets::widthOf(int sheet) const {
  return std::min(on(sheet), columns_) * cellWidth_;
}

int ContactSheets::heightOf(int sheet) const {
  return (on(sheet) + columns_ - 1) / columns_ * cellHeight_;
}

ContactSheets::Cell ContactSheets::cell(int picture) const {
  const int sheet = picture / perSheet(), position = picture % perSheet();
  return {sheet, position % columns_ * cellWidth_, position / columns_ * cellHeight_};
}

std::vector<std::string> ContactSheets::names() const {
  std::vector<std::string> names{fmt::format("{}{}", kSheetName, kEnd)};
  for (int sheet = 2; sheet <= sheets(); ++sheet)
    names.push_back(fmt::format("{}_{}{}", kSheetName, sheet, kEnd));
  return names;
}

bool isSheetName(const std::string& name) {
  if (!name.starts_with(kSheetName) || !name.ends_with(kEnd)) return false;
  const std::string_view number = std::string_view(name).substr(
      kSheetName.size(), name.size() - kSheetName.size() - kEnd.size());
  return number.empty() ||
         (number.front() == '_' && number.find_first_not_of("0123456789", 1) == number.npos);
}

}  // namespace asperity
