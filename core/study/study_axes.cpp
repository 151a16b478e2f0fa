#include "core/study/study_axes.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/named_choices.h"
#include "core/base/number_text.h"
#include "core/base/regular_file.h"
#include "core/base/text.h"
#include "core/base/text_table.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLargestTable = std::size_t{1} << 28;  // bytes of a table of rows
constexpr std::int64_t kMaxValues = 1000000;                 // of one list, rows of a table

constexpr NamedChoices<DistributionKind, 3> kDistributions{
    {{"normal", DistributionKind::Normal},
     {"lognormal", DistributionKind::Lognormal},
     {"uniform", DistributionKind::Uniform}}};

/// Throws InputError where the key cannot be varied, because its values do not make different
/// simulations.
void checkKey(const Parameter& row, const std::string& where) {
  const std::string_view key = row.key;
  const bool isOfScene = key.find('.') == key.npos;  // "title"
  if (isOfScene || key.starts_with("sweep.") || key.starts_with("comparison."))
    refuseMember(where, "has no influence on one simulation, so it cannot be varied");
  if (key == "sliding.kind") refuseMember(where, "a study slides steadily; it cannot be varied");
  if (key == "accuracy.target_relative_error")
    refuseMember(where, "a study needs a stated accuracy, not a target");
}

/// Throws InputError where the key does not allow a value.
void checkValue(const Parameter& row, const ParameterValue& value, const std::string& where) {
  Scene scratch;
  try {
    setValue(row, scratch, value);
  } catch (const InputError& error) {
    refuseMember(where, error.message());
  }
}

/// Adds a value of a list or a table to a column, which has either numbers or words.
void addValue(StudyColumn& column, const Json& value, const std::string& where) {
  const Parameter& row = *column.row;
  if (isNumber(row) && (value.is_number() || value.is_string())) {
    const double number =
        value.is_number() ? value.get<double>() : parseMember(row, value.get<std::string>(), where);
    checkValue(row, number, where);
    column.numbers.push_back(number);
    return;
  }
  if (isNumber(row) || !(value.is_string() || (value.is_array() && isList(row))))
    refuseMember(where, message("{} is not allowed here; allowed is {}", shortened(jsonLine(value)),
                                allowedText(row)));
  std::string word = assignedText(value);
  checkValue(row, word, where);
  column.words.push_back(std::move(word));
}

/// Reads a range, which is continuous in a sample; a grid has its points.
void readRange(StudyAxis& axis, const Json& spec, const std::string& where, bool isGrid) {
  checkMembers(spec, where, {"from", "to", "points", "scale"});
  const Parameter& row = *axis.columns.front().row;
  if (!isNumber(row))
    refuseMember(where, "is not a number, so it has no range; a list names its values");
  ParameterRange range{&row, rangeEnd(row, spec, where, "from"), rangeEnd(row, spec, where, "to"),
                       1, false};
  checkValue(row, range.from, where + ".from");
  checkValue(row, range.to, where + ".to");
  const bool isPositive = range.from > 0 && range.to > 0;
  range.isLogarithmic = hasLogarithmicSlider(row) && isPositive;
  if (spec.contains("scale")) {
    const std::string scale = textMember(spec, "scale", "", where);
    if (scale != "log" && scale != "linear")
      refuseMember(where + ".scale", "is neither log nor linear");
    range.isLogarithmic = scale == "log";
    if (range.isLogarithmic && !isPositive)
      refuseMember(where + ".scale", message("a logarithmic range needs ends above 0; {} is not",
                                             plain(range.from > 0 ? range.to : range.from)));
  }
  if (!isGrid) {
    if (spec.contains("points"))
      refuseMember(where + ".points", "has no meaning in a sample; it belongs to sampling grid");
    if (!(range.from < range.to)) refuseMember(where + ".to", "is not above from");
    axis.range = range;
    return;
  }
  if (!spec.contains("points"))
    refuseMember(where + ".points", "is missing; a grid needs the number of values");
  range.points = integerMember(spec, "points", 1, kMaxRangePoints, where);
  axis.columns.front().numbers = rangeValues(range);
}

void readDistribution(StudyAxis& axis, const Json& spec, const std::string& where, bool isGrid) {
  checkMembers(spec, where, {"distribution", "mean", "deviation", "from", "to"});
  const Parameter& row = *axis.columns.front().row;
  if (!isNumber(row)) refuseMember(where, "is not a number, so it has no distribution");
  if (isGrid)
    refuseMember(where,
                 "a distribution needs sampling latin_hypercube, sobol or saltelli, not a grid");
  Distribution made;
  made.kind =
      chosen(kDistributions, textMember(spec, "distribution", "", where), where + ".distribution");
  const auto from = optionalNumberMember(spec, where, "from"),
             to = optionalNumberMember(spec, where, "to");
  const bool hasMoments = spec.contains("mean") || spec.contains("deviation");
  if (made.kind == DistributionKind::Uniform && (hasMoments ? from || to : !(from && to)))
    refuseMember(where, "a uniform distribution has either from and to, or mean and deviation");
  if (hasMoments || made.kind != DistributionKind::Uniform) {
    made.mean = numberMember(spec, where, "mean");
    made.deviation = numberMember(spec, where, "deviation");
    if (!(made.deviation > 0)) refuseMember(where + ".deviation", "is not above 0");
  }
  if (made.kind == DistributionKind::Lognormal && !(made.mean > 0))
    refuseMember(where + ".mean", "of a lognormal distribution is not above 0");
  if (from) checkValue(row, *from, where + ".from");
  if (to) checkValue(row, *to, where + ".to");
  made.from = from.value_or(made.from);
  made.to = to.value_or(made.to);
  if (!(made.from < made.to)) refuseMember(where + ".to", "is not above from");
  // Limits that cut off nearly all of the distribution would leave only its last digits.
  const double middle = made.quantile(0.5);
  if (!(middle > made.from && middle < made.to) || !(made.quantile(0.25) < made.quantile(0.75)))
    refuseMember(where, "almost nothing of the distribution is between from and to");
  if (made.kind == DistributionKind::Uniform) {
    checkValue(row, made.quantile(0x1p-53), where);
    checkValue(row, made.quantile(1 - 0x1p-53), where);
  }
  axis.distribution = made;
}

/// Adds a column of a key to rows. Throws InputError where the key cannot be varied, or has one.
void addColumn(StudyAxis& rows, const std::string& key, const std::string& where) {
  const Parameter& row = knownParameter(key);
  checkKey(row, where);
  for (const StudyColumn& other : rows.columns)
    if (other.row == &row) refuseMember(where, message("has two columns of {}", key));
  rows.columns.push_back({&row, {}, {}});
}

/// Reads rows from the lists "keys" and "values" of an object.
StudyAxis readListedRows(const Json& spec, const std::string& where) {
  checkMembers(spec, where, {"keys", "values"});
  if (!spec.contains("keys") || !spec.contains("values") || !spec["keys"].is_array() ||
      !spec["values"].is_array())
    refuseMember(where, "needs the lists keys and values, or the name of a table");
  StudyAxis rows;
  for (const Json& key : spec["keys"]) {
    if (!key.is_string()) refuseMember(where + ".keys", "needs texts");
    addColumn(rows, key.get<std::string>(), where);
  }
  for (const Json& row : spec["values"]) {
    if (!row.is_array() || row.size() != rows.columns.size())
      refuseMember(where + ".values", "needs lists of as many values as there are keys");
    for (std::size_t i = 0; i < row.size(); ++i)
      addValue(rows.columns[i], row[i], where + ".values");
  }
  return rows;
}

/// Throws InputError where the name of a column is no key, or its unit not that of the key.
void checkColumn(const TextColumn& column, const std::string& file) {
  const Parameter* row = findParameter(column.name);
  if (!row) {
    const std::string_view nearest = nearestKey(column.name);
    throw InputError(file, "",
                     nearest.empty()
                         ? message("column '{}' is not a scene key", shortened(column.name))
                         : message("column '{}' is not a scene key; the nearest known one is {}",
                                   shortened(column.name), nearest));
  }
  if (!column.unit.empty() && column.unit != row->unit)
    throw InputError(file, "",
                     message("column {} is in {}; a study takes plain numbers in {}", column.name,
                             shortened(column.unit), row->unit.empty() ? "1" : row->unit));
}

/// Returns the bytes of a table that `where` of the study names.
std::string tableBytes(const std::filesystem::path& path, const std::string& where) {
  try {
    return readRegularFile(path, kLargestTable);
  } catch (const InputError& error) {
    refuseMember(where, errorMessage(error));
  }
}

/// Reads rows from a table whose columns have the names of keys.
StudyAxis readTabulatedRows(const std::filesystem::path& path, const std::string& where) {
  const std::string file = path.string();
  TextTableOptions options;
  options.keepsTexts = true;
  const TextTable table = readTextTable(tableBytes(path, where), file, options);
  refuseUnclearMark(table, file);
  const TextBlock& block = table.largest();
  StudyAxis rows;
  for (const TextColumn& column : block.columns) {
    checkColumn(column, file);
    addColumn(rows, column.name, where);
  }
  for (std::size_t r = 0; r < block.rows; ++r)
    for (std::size_t c = 0; c < block.columns.size(); ++c) {
      const TextColumn& column = block.columns[c];
      if (!column.isText && std::isnan(block.at(r, c)))
        throw InputError(file, "", message("line {}: {} is missing", block.lines[r], column.name));
      try {
        addValue(rows.columns[c], column.isText ? Json(block.texts[c][r]) : Json(block.at(r, c)),
                 "");
      } catch (const InputError& error) {
        throw InputError(file, "",
                         message("line {}: {}: {}", block.lines[r], column.name, error.message()));
      }
    }
  return rows;
}

Json valueJson(const StudyColumn& column, std::size_t index) {
  if (!column.hasWords()) return column.numbers[index];
  return column.words[index];
}

}  // namespace

StudyAxis readRows(const Json& spec, const std::string& where,
                   const std::filesystem::path& folder) {
  if (!spec.is_object() && !spec.is_string())
    refuseMember(where, "needs the name of a table with a column for each key");
  StudyAxis rows = spec.is_object() ? readListedRows(spec, where)
                                    : readTabulatedRows(folder / spec.get<std::string>(), where);
  if (rows.columns.empty() || rows.count() == 0) refuseMember(where, "has no row");
  if (rows.count() > kMaxValues)
    refuseMember(where, message("has {} rows; at most {} are allowed", rows.count(), kMaxValues));
  return rows;
}

StudyAxis readAxis(const std::string& key, const Json& spec, bool isGrid) {
  const std::string where = "space." + shortened(key);
  StudyAxis axis;
  try {
    axis.columns = {{&knownParameter(key), {}, {}}};
  } catch (const InputError& error) {
    refuseMember(where, error.message());
  }
  checkKey(*axis.columns.front().row, where);
  if (spec.is_array()) {
    if (spec.empty()) refuseMember(where, "has no value");
    if (static_cast<std::int64_t>(spec.size()) > kMaxValues)
      refuseMember(where,
                   message("has {} values; at most {} are allowed", spec.size(), kMaxValues));
    for (const Json& value : spec) addValue(axis.columns.front(), value, where);
  } else if (!spec.is_object()) {
    refuseMember(where,
                 "needs a list of values, a range {\"from\", \"to\", \"points\", \"scale\"} or a "
                 "distribution");
  } else if (spec.contains("distribution")) {
    readDistribution(axis, spec, where, isGrid);
  } else {
    readRange(axis, spec, where, isGrid);
  }
  return axis;
}

Json axisJson(const StudyAxis& axis) {
  if (axis.range)
    return {{"from", axis.range->from},
            {"to", axis.range->to},
            {"scale", axis.range->isLogarithmic ? "log" : "linear"}};
  if (const auto& given = axis.distribution) {
    Json json = {{"distribution", choiceWord(kDistributions, given->kind)}};
    const bool hasLimits = std::isfinite(given->from) && std::isfinite(given->to);
    if (given->kind != DistributionKind::Uniform || !hasLimits) {
      json["mean"] = given->mean;
      json["deviation"] = given->deviation;
    }
    if (std::isfinite(given->from)) json["from"] = given->from;
    if (std::isfinite(given->to)) json["to"] = given->to;
    return json;
  }
  Json list = Json::array();
  for (std::size_t i = 0; i < static_cast<std::size_t>(axis.count()); ++i)
    list.push_back(valueJson(axis.columns.front(), i));
  return list;
}

Json rowsJson(const StudyAxis& axis) {
  Json keys = Json::array(), values = Json::array();
  for (const StudyColumn& column : axis.columns) keys.push_back(column.key());
  for (std::size_t i = 0; i < static_cast<std::size_t>(axis.count()); ++i) {
    Json row = Json::array();
    for (const StudyColumn& column : axis.columns) row.push_back(valueJson(column, i));
    values.push_back(std::move(row));
  }
  return {{"keys", std::move(keys)}, {"values", std::move(values)}};
}

}  // namespace asperity
