#include "core/fit/friction_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_number.h"

namespace asperity {
namespace {

using Series = std::vector<const MeasuredPoint*>;

/// Returns the points that differ at most in their velocity and friction together, each series in
/// the order of velocities, in the order in which the series begin in the file.
std::vector<Series> seriesOf(const std::vector<MeasuredPoint>& points) {
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  const auto keyOf = [](double value) { return std::isnan(value) ? kNone : value; };
  std::map<std::tuple<std::string_view, double, double, double>, std::size_t> numbers;
  std::vector<Series> all;
  for (const MeasuredPoint& point : points) {
    const auto [found, isNew] =
        numbers.try_emplace({point.label, keyOf(point.normalForce), keyOf(point.nominalPressure),
                             keyOf(point.temperature)},
                            all.size());
    if (isNew) all.emplace_back();
    all[found->second].push_back(&point);
  }
  for (Series& series : all)
    std::ranges::stable_sort(series, {},
                             [](const MeasuredPoint* point) { return point->velocity; });
  return all;
}

/// Throws InputError for friction without a unit that is too high for any rubber: it is in per
/// cent.
void refusePercent(const std::vector<MeasuredPoint>& points, const TextBlock& block,
                   const FrictionRoles& roles, const std::string& name) {
  constexpr double kHighest = 5;
  const auto [least, most] = std::ranges::minmax_element(points, {}, &MeasuredPoint::mu);
  if (!block.columns[roles.find(FrictionQuantity::Mu)->index].unit.empty() ||
      !(least->mu > kHighest))
    return;
  throw InputError(
      name, "",
      message("the coefficients of friction are {} to {}; name their unit in the header, as "
              "in \"mu (%)\" or \"mu (1)\"",
              plain(least->mu), plain(most->mu)));
}

/// Throws InputError for a number that no test of rubber reaches: it is in another unit, or it
/// stands for a missing value, as 9999 and 1E+38 do.
void refuseImpossible(const std::vector<MeasuredPoint>& points, const std::string& name) {
  struct Limit {
    FrictionQuantity quantity;
    double MeasuredPoint::*value;
    double most;
    const char* unit;
  };
  // A velocity may be reduced to another temperature, by any factor. Rubber is tested up to 250 °C;
  // kelvins that are taken for °C become at least 546 K where they are above the freezing point.
  constexpr Limit kLimits[] = {
      {FrictionQuantity::Mu, &MeasuredPoint::mu, 100, ""},
      {FrictionQuantity::Velocity, &MeasuredPoint::velocity, 1e12, " m/s"},
      {FrictionQuantity::Force, &MeasuredPoint::normalForce, 1e9, " N"},
      {FrictionQuantity::Pressure, &MeasuredPoint::nominalPressure, 1e12, " Pa"},
      {FrictionQuantity::Temperature, &MeasuredPoint::temperature, 545, " K"}};
  for (const MeasuredPoint& point : points)
    for (const auto& [quantity, value, most, unit] : kLimits)
      if (std::isgreater(point.*value, most))
        throw InputError(
            name, "",
            message("row {}: {}", point.row,
                    message("the {} is {}, which no test of rubber reaches; correct it or its "
                            "unit, or leave it empty where it stands for a missing value",
                            Message(meaningOf(quantity)),
                            PrintedNumber{plain(point.*value).text + unit})));
}

/// Throws InputError for a power of ten as unit of friction that may be the factor by which
/// friction was multiplied: one above 1, or numbers below 1 that need none.
void refuseFactor(const std::vector<MeasuredPoint>& points, const TextBlock& block,
                  const FrictionRoles& roles, const std::string& name) {
  const FrictionRole& mu = *roles.find(FrictionQuantity::Mu);
  const TextColumn& column = block.columns[mu.index];
  const double factor = mu.conversion.unit.toSi(1);
  const auto most = std::ranges::max_element(points, {}, &MeasuredPoint::mu);
  if (!isWrittenPower(column.unit) || (factor <= 1 && most->mu >= factor)) return;
  throw InputError(
      name, "",
      message("column {}: the factor {} may multiply or divide the numbers; write the coefficients "
              "of friction without it",
              shortened(column.name), column.unit));
}

/// Throws InputError for a force that is proportional to friction: it is the force of friction,
/// under a constant load.
void refuseFrictionForce(const std::vector<MeasuredPoint>& points, const TextBlock& block,
                         const FrictionRoles& roles, const std::string& name) {
  constexpr std::size_t kMin = 3;
  constexpr double kRounding = 1.02, kVaries = 1.1;
  const FrictionRole* force = roles.find(FrictionQuantity::Force);
  if (!force || points.size() < kMin || std::isnan(points.front().normalForce)) return;
  const auto ratio = [](const MeasuredPoint& point) { return point.normalForce / point.mu; };
  const auto [least, most] = std::ranges::minmax_element(points, {}, &MeasuredPoint::mu);
  const auto [low, high] = std::ranges::minmax_element(points, {}, ratio);
  if (most->mu < kVaries * least->mu || ratio(*high) > kRounding * ratio(*low)) return;
  throw InputError(
      name, "",
      message("column {}: the force is proportional to the coefficient of friction, as a force of "
              "friction is; name it friction force, and give the normal force in a column "
              "normal_force or a line \"Normal force: {:.3g} N\"",
              shortened(block.columns[force->index].name), ratio(*low)));
}

/// Throws InputError for two points that nothing tells apart.
[[noreturn]] void refuseRepeat(const MeasuredPoint& first, const MeasuredPoint& second,
                               bool haveVelocities, const std::string& name) {
  if (!haveVelocities)
    throw InputError(
        name, "",
        message("rows {} and {} have the velocity above the table, and no load, temperature or "
                "label tells them apart; give the velocity of each row in a column, as in "
                "\"v (m/s)\"",
                first.row, second.row));
  throw InputError(
      name, "",
      message("row {}: {}", second.row,
              message("has the velocity of row {}, {} m/s; average repeated measurements and "
                      "give their error as mu_error, or tell them apart by a label",
                      first.row, plain(second.velocity))));
}

/// Returns a note on the point of a series, in the order of velocities, that lies furthest from
/// the line between its neighbours in double logarithm, where it is far above or below both. The
/// first and the last two points are left out: there it is open which one is wrong.
std::optional<Message> slipOf(const Series& series) {
  constexpr double kFarFromLine = 8, kFarFromBoth = 3;
  double most = 1;
  std::size_t furthest = 0;
  for (std::size_t i = 1; i + 1 < series.size(); ++i) {
    const MeasuredPoint &before = *series[i - 1], &behind = *series[i + 1];
    const double part = std::log(series[i]->velocity / before.velocity) /
                        std::log(behind.velocity / before.velocity);
    const double ratio = series[i]->mu / (before.mu * std::pow(behind.mu / before.mu, part));
    if (std::max(ratio, 1 / ratio) <= std::max(most, 1 / most)) continue;
    most = ratio;
    furthest = i;
  }
  if (furthest < 2 || furthest + 2 >= series.size()) return {};
  const double mu = series[furthest]->mu, before = series[furthest - 1]->mu,
               behind = series[furthest + 1]->mu;
  const bool isFar =
      mu > kFarFromBoth * std::max(before, behind) || kFarFromBoth * mu < std::min(before, behind);
  if (!isFar || std::max(most, 1 / most) < kFarFromLine) return {};
  return message(
      "row {}: the coefficient of friction {} is {:.2g} times what the points beside it give; is "
      "its decimal mark right?",
      series[furthest]->row, plain(mu), most);
}

}  // namespace

void requirePoints(const std::vector<MeasuredPoint>& points, const std::string& name) {
  if (points.size() < 2)
    throw InputError(name, "",
                     message("has {} row of numbers; at least 2 are needed", points.size()));
}

void checkColumns(const std::vector<MeasuredPoint>& points, const TextBlock& block,
                  const FrictionRoles& roles, const std::string& name) {
  if (points.empty()) return;
  refusePercent(points, block, roles, name);
  refuseFactor(points, block, roles, name);
  refuseFrictionForce(points, block, roles, name);
}

void checkPoints(const std::vector<MeasuredPoint>& points, bool haveVelocities,
                 const std::string& name) {
  refuseImpossible(points, name);
  const MeasuredPoint *first = nullptr, *repeat = nullptr;
  for (const Series& series : seriesOf(points))
    for (std::size_t i = 1; i < series.size(); ++i) {
      if (series[i]->velocity != series[i - 1]->velocity) continue;
      if (repeat && repeat < series[i]) continue;
      first = series[i - 1];
      repeat = series[i];
    }
  if (repeat) refuseRepeat(*first, *repeat, haveVelocities, name);
}

std::vector<Message> slipNotes(const std::vector<MeasuredPoint>& points) {
  std::vector<Message> notes;
  for (const Series& series : seriesOf(points))
    if (const auto slip = slipOf(series)) notes.push_back(*slip);
  return notes;
}

}  // namespace asperity
