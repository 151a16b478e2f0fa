#include "core/material/dma_samples.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/statistics.h"
#include "core/base/text.h"
#include "core/material/dma_columns.h"

namespace asperity {
namespace {

/// Two rows at the same temperature, frequency and strain.
struct RepeatedRows {
  std::size_t first, second;
};

std::vector<RepeatedRows> repeatedRows(const std::vector<MeasuredModulus>& rows) {
  std::vector<std::size_t> order(rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return rows[i].temperature; });
  std::vector<RepeatedRows> repeats;
  for (auto begin = order.begin(), end = begin; begin != order.end(); begin = end) {
    // The rows of one isotherm.
    for (++end; end != order.end() &&
                rows[*end].temperature - rows[*(end - 1)].temperature <= kIsothermTolerance;)
      ++end;
    std::stable_sort(begin, end, [&](std::size_t i, std::size_t j) {
      return rows[i].modulus.frequency < rows[j].modulus.frequency;
    });
    for (auto first = begin, next = first; first != end; first = next) {
      const double most = rows[*first].modulus.frequency * (1 + kSameFrequency);
      for (++next; next != end && rows[*next].modulus.frequency <= most; ++next) {
        const double own = rows[*first].strainAmplitude, other = rows[*next].strainAmplitude;
        const bool isOtherStrain = std::isfinite(own) && std::isfinite(other) &&
                                   std::abs(std::log(own / other)) > std::log(kSameStrain);
        const bool isApart =
            std::abs(rows[*first].temperature - rows[*next].temperature) > kIsothermTolerance ||
            isOtherStrain;
        if (!isApart) repeats.push_back({std::min(*first, *next), std::max(*first, *next)});
      }
    }
  }
  return repeats;
}

/// Returns whether a column has other values in the rows of each pair, and each value in several
/// rows, as a label has and a time has not.
bool distinguishes(std::size_t column, const std::vector<RowOrigin>& origins,
                   const std::vector<RepeatedRows>& repeats) {
  std::map<std::string, std::size_t> rows;
  for (const RowOrigin& origin : origins) {
    if (column >= origin.block->columns.size()) return false;
    ++rows[origin.field(column)];
  }
  return rows.size() * 2 <= origins.size() &&
         std::ranges::all_of(repeats, [&](const RepeatedRows& pair) {
           return origins[pair.first].field(column) != origins[pair.second].field(column);
         });
}

}  // namespace

std::string RowOrigin::field(std::size_t column) const {
  if (block->columns[column].isText) return block->texts[column][row];
  return plain(block->at(row, column)).text;
}

void refuseDifferentSamples(const std::vector<MeasuredModulus>& rows,
                            const std::vector<RowOrigin>& origins, const std::string& fileName) {
  constexpr double kSameSample = 1.2;
  const std::vector<RepeatedRows> repeats = repeatedRows(rows);
  if (repeats.empty()) return;
  std::vector<double> storage, loss;
  for (const RepeatedRows& pair : repeats) {
    const DynamicModulus &one = rows[pair.first].modulus, &other = rows[pair.second].modulus;
    storage.push_back(std::exp(std::abs(std::log(one.storage / other.storage))));
    loss.push_back(std::exp(std::abs(std::log(one.loss / other.loss))));
  }
  const double ratio = std::max(upperMedian(std::move(storage)), upperMedian(std::move(loss)));
  if (ratio <= kSameSample) return;
  const RowOrigin &first = origins[repeats.front().first],
                  &second = origins[repeats.front().second];
  const PrintedNumber factor = printed(ratio, 3);
  std::string unused;
  for (std::size_t i = 0; i < first.block->columns.size(); ++i) {
    const TextColumn& column = first.block->columns[i];
    if (!column.isText && dmaColumn(column).quantity != DmaQuantity::None) continue;
    appendItem(unused, shortened(first.block->label(i)));
    if (distinguishes(i, origins, repeats))
      throw InputError(
          fileName, first.block->label(i),
          message("tells samples or runs apart, {} in line {} and {} in line {}, whose moduli at "
                  "the same temperature and frequency differ by a factor of {} in the median; "
                  "keep the rows of one of them",
                  Message::name(shortened(first.field(i))), first.line(),
                  Message::name(shortened(second.field(i))), second.line(), factor));
  }
  throw InputError(
      fileName, "",
      message("states other moduli at the same temperature and frequency, as in lines {} and {}, "
              "by a factor of {} in the median, and runs of one sample differ by at most {}; keep "
              "the rows of one sample and run (columns that are not read: {})",
              first.line(), second.line(), factor, kSameSample,
              Message::name(unused.empty() ? "-" : unused)));
}

}  // namespace asperity
