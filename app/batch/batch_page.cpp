#include "app/batch/batch_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/base/number_text.h"
#include "core/chart/curve_words.h"
#include "core/scene/columns.h"
#include "core/scene/parameters.h"
#include "ui/draw/picture_file.h"
#include "ui/draw/ticks.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"

namespace asperity {
namespace {

// largest width and height in pixels of one picture on a sheet
constexpr int kWidestCell = 480, kHighestCell = 960;
constexpr std::string_view kSheetName = "contact_sheet", kEnd = ".png";

}  // namespace

ContactSheets::ContactSheets(int count, int width, int height) : count_(std::max(count, 1)) {
  const double ratio = static_cast<double>(height) / width;
  cellHeight_ = std::clamp(static_cast<int>(kWidestCell * ratio), 1, kHighestCell);
  cellWidth_ = kWidestCell * ratio > kHighestCell
                   ? std::max(1, static_cast<int>(kHighestCell / ratio))
                   : kWidestCell;
  const int side = static_cast<int>(std::ceil(std::sqrt(count_)));
  columns_ = std::min(side, kLargestSheet / cellWidth_);
  rows_ = std::min((count_ + columns_ - 1) / columns_, kLargestSheet / cellHeight_);
}

int ContactSheets::picturesOn(int sheet) const {
  return std::clamp(count_ - sheet * perSheet(), 0, perSheet());
}

int ContactSheets::widthOf(int sheet) const {
  return std::min(picturesOn(sheet), columns_) * cellWidth_;
}

int ContactSheets::heightOf(int sheet) const {
  return (picturesOn(sheet) + columns_ - 1) / columns_ * cellHeight_;
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

namespace {

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="%1">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<style>
  body { font: 16px/1.45 "DejaVu Sans", system-ui, sans-serif; margin: 2rem auto; max-width: 90rem;
         padding: 0 1.5rem; color: #18212b; background: #fff; }
  main { display: grid; grid-template-columns: repeat(auto-fill, minmax(24rem, 1fr)); gap: 1.5rem; }
  article { border: 1px solid #d5dde5; border-radius: 8px; padding: 1rem; }
  article.bad { border-color: #b83a06; }
  h2 { font-size: 1.05rem; margin: 0 0 .5rem; overflow-wrap: anywhere; }
  img { width: 100%; height: auto; }
  table { border-collapse: collapse; margin: .5rem 0; width: 100%; }
  td { padding: .15rem 0; border-top: 1px solid #eef2f5; overflow-wrap: anywhere; }
  td + td { text-align: right; font-variant-numeric: tabular-nums; }
  .bad p, .missed { color: #b83a06; }
  .quiet { color: #5a6876; font-size: .85rem; }
</style>
)";

std::string row(const std::string& name, const std::string& value, const std::string& tip = {}) {
  const std::string title = tip.empty() ? "" : fmt::format(" title=\"{}\"", xmlText(tip));
  return fmt::format("<tr><td{}>{}</td><td>{}</td></tr>", title, xmlText(name), xmlText(value));
}

/// Returns a row with a swept parameter, under the name that the window shows for it.
std::string variedRow(const std::string& key, const std::string& value) {
  const Parameter* parameter = findParameter(key);
  if (!parameter) return row(key, value);
  std::string shown = value;
  constexpr int kDigits = 6;
  if (double number = 0; readNumber(value, number)) {
    shown =
        parameter->unit.empty() ? inLanguage(value) : quantity(number, parameter->unit, kDigits);
  } else if (std::holds_alternative<ChoiceField>(parameter->field)) {
    std::ranges::replace(shown, '_', '-');
    shown = translated(shown);
  }
  return row(translated(parameter->label), shown, key);
}

/// Returns whether the mean has local friction beside that of the deformation.
bool hasTotal(const BatchResult& result) {
  return result.mean && std::isfinite(result.mean->muInterface);
}

/// Returns the means, each with its standard error where it has one, and beside them the results of
/// the line that is shown. A scene of one line has only the latter.
std::string readings(const BatchResult& result) {
  const auto& mean = result.mean;
  const bool hasLines = mean && mean->realizations > 1;
  const auto beside = [&](const std::string& ofMean, const std::string& own) {
    return hasLines ? filled(Words::tr("%1 (line shown: %2)"), {ofMean, own}) : own;
  };
  const CurvePoint shown = mean.value_or(CurvePoint{});
  std::string name = mean ? Words::tr("coefficient of friction")
                          : Words::tr("coefficient of friction at the end, of the line shown");
  if (hasLines)
    name = filled(Words::tr("coefficient of friction, mean of %1 lines"),
                  {std::to_string(shown.realizations)});
  std::string rows = row(name, beside(numberWithError(shown.mu, shown.muStandardError),
                                      shortNumber(result.lineMu, 4)));
  if (hasTotal(result))
    rows += row(translated(Message("with local friction")), shortNumber(totalMu(*mean), 4));
  return rows +
         row(Words::tr("in contact"), beside(shortPercent(shown.contactFraction),
                                             shortPercent(result.lineContactFraction))) +
         row(Words::tr("indentation"),
             beside(quantity(shown.indentation, "m", 4), quantity(result.lineIndentation, "m", 4)));
}

std::string article(const BatchResult& result) {
  const BatchItem& item = result.item;
  if (!item.error.empty())
    return fmt::format("<article class=\"bad\"><h2>{}</h2><p>{}</p></article>\n",
                       xmlText(item.name), xmlText(translated(item.error)));
  std::string html = fmt::format(
      "<article><h2>{0}</h2><a href=\"{1}\"><img src=\"{1}\" alt=\"{0}\" loading=\"lazy\"></a>"
      "<table>",
      xmlText(translated(item.title)), result.files.front());
  for (const auto& [key, value] : item.varied) html += variedRow(key, value);
  html += readings(result);
  html += "</table>";
  if (!result.missed.empty())
    html += "<p class=\"missed\">" + xmlText(translated(result.missed)) + "</p>";
  html += "<p class=\"quiet\">" + xmlText(translated(describeParameters(item.scene))) + "</p><p>";
  for (const std::string& file : result.files)
    html += fmt::format("<a href=\"{0}\">{0}</a> ", file);
  return html + "</p></article>\n";
}

std::string countText(std::size_t all, std::size_t bad) {
  if (all == 1) return bad > 0 ? Words::tr("One scene, and it failed.") : Words::tr("One scene.");
  const std::string count = std::to_string(all);
  return bad > 0 ? filled(Words::tr("%1 scenes, %2 of them failed."), {count, std::to_string(bad)})
                 : filled(Words::tr("%1 scenes."), {count});
}

}  // namespace

std::string batchPage(const Batch& batch, const std::vector<BatchResult>& results,
                      const std::vector<std::string>& sheets) {
  const auto bad = std::count_if(results.begin(), results.end(),
                                 [](const BatchResult& r) { return !r.item.error.empty(); });
  std::string html =
      filled(kHead, {std::string(presentLanguage())}) +
      fmt::format("<title>{0}</title>\n</head>\n<body>\n<h1>{0}</h1>\n", xmlText(batch.title));
  html += "<p>" + countText(results.size(), static_cast<std::size_t>(bad)) + " ";
  for (std::size_t i = 0; i < sheets.size(); ++i)
    html +=
        fmt::format("<a href=\"{}\">{}</a>, ", sheets[i],
                    sheets.size() == 1 ? Words::tr("All on one sheet")
                                       : filled(Words::tr("Sheet %1"), {std::to_string(i + 1)}));
  html += "<a href=\"results.csv\">" + Words::tr("all results as a table") + "</a>.</p>\n<main>\n";
  for (const BatchResult& result : results) html += article(result);
  return html + "</main>\n<p class=\"quiet\">" +
         filled(Words::tr("Made by Asperity %1."), {ASPERITY_VERSION}) + "</p>\n</body>\n</html>\n";
}

DataTable batchTable(const std::vector<BatchResult>& results) {
  std::vector<std::string> keys;
  for (const BatchResult& result : results)
    for (const auto& [key, value] : result.item.varied)
      if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
  const bool anyTotal = std::ranges::any_of(results, hasTotal);
  DataTable table{columnNames({"name"}), {}};
  const auto addColumns = [&table](const std::vector<std::string>& names) {
    table.columns.insert(table.columns.end(), names.begin(), names.end());
  };
  addColumns(keys);
  addColumns(columnNames({"mu", "indentation", "contact_fraction", "mu_standard_error"}));
  if (anyTotal) addColumns(columnNames({"mu_total"}));
  addColumns(columnNames(
      {"realizations", "line_mu", "line_indentation", "line_contact_fraction", "error"}));
  for (const BatchResult& result : results) {
    std::vector<TableCell>& row = table.rows.emplace_back();
    row.emplace_back(result.item.name);
    for (const std::string& key : keys) {
      const auto own =
          std::ranges::find(result.item.varied, key, &std::pair<std::string, std::string>::first);
      row.emplace_back(own == result.item.varied.end() ? std::string() : own->second);
    }
    const auto& mean = result.mean;
    for (const auto member : {&CurvePoint::mu, &CurvePoint::indentation,
                              &CurvePoint::contactFraction, &CurvePoint::muStandardError})
      row.emplace_back(mean ? (*mean).*member : kNotApplicable);
    if (anyTotal) row.emplace_back(mean ? totalMu(*mean) : kNotApplicable);
    row.push_back(mean ? TableCell(mean->realizations) : kNotApplicable);
    for (const double ofLine : {result.lineMu, result.lineIndentation, result.lineContactFraction})
      row.emplace_back(ofLine);
    row.emplace_back(result.fault().english());
  }
  return table;
}

}  // namespace asperity
