#include "core/chart/map_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "core/base/intervals.h"
#include "core/base/number_text.h"
#include "core/base/statistics.h"
#include "core/chart/contours.h"
#include "core/chart/curve_regions.h"
#include "core/chart/curve_words.h"

namespace asperity {
namespace {

constexpr int kLevels = 9;  // contour lines that a map has about
/// Positive quantities that span more than this factor have logarithmic colours.
constexpr double kLogarithmicSpan = 10;

struct QuantityTitle {
  std::string_view quantity;
  const char* title;
};
constexpr std::array kTitles{
    QuantityTitle{"velocity", "velocity v"},
    QuantityTitle{"mu", "coefficient of friction \u03BC"},
    QuantityTitle{"mu_standard_error", "standard error of \u03BC"},
    QuantityTitle{"mu_law", "friction by Eq. (11)"},
    QuantityTitle{"contact_fraction", "contact fraction"},
    QuantityTitle{"rms_slope_contact", "rms slope in contact"},
    QuantityTitle{"indentation", "indentation d"},
    QuantityTitle{"normalized_mu", "friction over rms slope"},
    QuantityTitle{"dimensionless_velocity", "dimensionless velocity"},
    QuantityTitle{"dimensionless_force", "dimensionless force"},
    QuantityTitle{"realizations", "realizations"},
    QuantityTitle{"mu_interface", "local friction"},
    QuantityTitle{"mu_total", "friction, deformation and local"},
    QuantityTitle{"mu_mean_of_ratios", "mean of the ratios of forces"},
    QuantityTitle{"mu_ratio_of_means", "ratio of the mean forces"},
    QuantityTitle{"mu_low", "lower end of the interval of \u03BC"},
    QuantityTitle{"mu_high", "upper end of the interval of \u03BC"},
    QuantityTitle{"tangential_force", "tangential force F\u2093"},
    QuantityTitle{"power", "power"},
    QuantityTitle{"marginal_share", "share of the marginal element"},
    QuantityTitle{"contact_spots", "contacts in a period"},
    QuantityTitle{"extrapolated", "beyond the measured frequencies"},
    QuantityTitle{"normal_force", "normal force F\u2099"},
    QuantityTitle{"nominal_pressure", "nominal pressure p\u2080"},
    QuantityTitle{"mean_pressure", "mean pressure in contact"},
    QuantityTitle{"exponent", "exponent d ln \u03BC / d ln x"},
};

AxisScale axisScale(const MapAxis& axis) {
  return axis.range.isLogarithmic ? AxisScale::Logarithmic : AxisScale::Linear;
}

DiagramAxis diagramAxis(const MapAxis& axis) {
  const auto [least, most] = std::ranges::minmax(axis.values);
  return {parameterTitle(axis.key()), std::string(axis.range.row->unit), axisScale(axis), least,
          most};
}

double axisNumber(const Scene& scene, const MapAxis& axis) {
  return parameterNumber(*axis.range.row, scene);
}

/// Returns the relative standard error that half of the cells are below; 1 where none is known, as
/// in a preview of one line.
double usualError(const ParameterMap& map) {
  std::vector<double> errors;
  for (const CurvePoint& cell : map.points)
    if (std::isfinite(cell.muStandardError) && cell.mu > 0)
      errors.push_back(cell.muStandardError / cell.mu);
  if (errors.empty()) return 1;
  return upperMedian(std::move(errors));
}

/// A map with both sides in ascending order.
class RisingMap {
 public:
  RisingMap(const ParameterMap& map, std::string_view quantity) : map_(map) {
    columns_ = risingOrder(map.x);
    rows_ = risingOrder(map.y);
    const std::vector<double> given = mapValues(map, quantity);
    for (const std::size_t j : rows_)
      for (const std::size_t i : columns_) values.push_back(given[j * map.x.values.size() + i]);
    for (const std::size_t i : columns_) x.push_back(map.x.values[i]);
    for (const std::size_t j : rows_) y.push_back(map.y.values[j]);
  }

  /// Returns the cell in this column and row.
  const CurvePoint& cell(std::size_t i, std::size_t j) const {
    return map_.at(columns_[i], rows_[j]);
  }
  /// Returns the usual relative standard error of friction.
  double noise() const { return usualError(map_); }
  Scene scene(std::size_t i, std::size_t j) const { return cellScene(map_, columns_[i], rows_[j]); }

  std::vector<double> x, y, values;

 private:
  static std::vector<std::size_t> risingOrder(const MapAxis& axis) {
    std::vector<std::size_t> order(axis.values.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    if (axis.values.front() > axis.values.back()) std::ranges::reverse(order);
    return order;
  }

  const ParameterMap& map_;
  std::vector<std::size_t> columns_, rows_;
};

std::vector<double> axisPositions(const std::vector<double>& values, AxisScale scale) {
  std::vector<double> positions;
  for (const double value : values) positions.push_back(axisPosition(scale, value));
  return positions;
}

/// Returns scale and range of the colours.
DiagramAxis colourAxis(const std::vector<double>& values, std::string_view quantity) {
  DiagramAxis axis{mapQuantityTitle(quantity), std::string(mapQuantityUnit(quantity)),
                   AxisScale::Linear};
  Extent extent;
  for (const double value : values) extent.add(value);
  if (extent.isEmpty()) return axis;
  const auto [least, most] = extent;
  if (least > 0 && most > kLogarithmicSpan * least && quantity != "exponent")
    axis.scale = AxisScale::Logarithmic;
  axis.from = least;
  axis.to = most;
  if (least < most) return axis;
  const double around = least != 0 ? 0.05 * std::abs(least) : 1;
  axis.from -= around;
  axis.to += around;
  return axis;
}

std::vector<DiagramPoint> diagramPoints(const ContourLine& line, AxisScale x, AxisScale y) {
  std::vector<DiagramPoint> points;
  for (const ContourPoint& point : line)
    points.push_back({axisValue(x, point.x), axisValue(y, point.y)});
  return points;
}

/// Adds levels where much of the map lies between two neighbouring ones, as on a plateau: its shape
/// then shows although its colours differ little. The steps are as large as the noise requires, and
/// at least a hundredth of the value.
std::vector<double> withPlateaus(std::vector<double> levels, const std::vector<double>& values,
                                 double from, double to, double noise) {
  constexpr double kMuch = 0.35;  // part of the map between two levels
  constexpr int kBetween = 4;     // further levels there, about
  constexpr int kTimes = 3;
  constexpr double kErrors = 3;  // standard errors between two levels
  const double least = std::max(0.01, kErrors * noise);
  std::vector<double> known;
  std::ranges::copy_if(values, std::back_inserter(known),
                       [](double value) { return std::isfinite(value); });
  for (int time = 0; time < kTimes; ++time) {
    std::vector<double> ends{from};
    ends.insert(ends.end(), levels.begin(), levels.end());
    ends.push_back(to);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const double low = ends[i], high = ends[i + 1];
      const auto inside =
          std::ranges::count_if(known, [&](double value) { return value >= low && value <= high; });
      if (static_cast<double>(inside) < kMuch * static_cast<double>(known.size())) continue;
      const std::vector<double> further = contourLevels(low, high, false, kBetween);
      const double size = std::max(std::abs(low), std::abs(high));
      if (further.empty()) continue;
      const double step = further.size() > 1 ? further[1] - further[0]
                                             : std::max(further[0] - low, high - further[0]);
      if (step >= least * size) levels.insert(levels.end(), further.begin(), further.end());
    }
    std::ranges::sort(levels);
  }
  return levels;
}

/// Returns the map as colours with contour lines. These are interpolated as the colours are: in the
/// logarithm of the quantity on a logarithmic scale.
DiagramField makeField(const RisingMap& map, const Diagram& diagram, std::string_view quantity) {
  DiagramField field{
      .colours = colourAxis(map.values, quantity), .x = map.x, .y = map.y, .values = map.values};
  const bool isLogarithmic = field.colours.scale == AxisScale::Logarithmic;
  std::vector<double> heights = map.values;
  if (isLogarithmic)
    for (double& height : heights)
      height = std::isfinite(height) ? std::log10(height) : kNotApplicable;
  const std::vector<double> x = axisPositions(map.x, diagram.x.scale);
  const std::vector<double> y = axisPositions(map.y, diagram.y.scale);
  // Numbers over many decades are written as on the axes.
  constexpr double kManyDecades = 1e3;
  const bool arePowers = isLogarithmic && field.colours.to > kManyDecades * field.colours.from;
  const double from = field.colours.from, to = field.colours.to;
  for (const double level : withPlateaus(contourLevels(from, to, isLogarithmic, kLevels),
                                         map.values, from, to, map.noise())) {
    DiagramContour contour{
        level, PrintedNumber{arePowers ? printedPower(level) : printedNumber(level)}, {}};
    for (const ContourLine& line :
         contourLines(x, y, heights, isLogarithmic ? std::log10(level) : level))
      contour.lines.push_back(diagramPoints(line, diagram.x.scale, diagram.y.scale));
    if (!contour.lines.empty()) field.contours.push_back(std::move(contour));
  }
  return field;
}

/// A region at one value of the other parameter: its range of velocities.
struct RegionCut {
  double other = 0, from = 0, to = 0;
};

/// The regions of the friction curve at each value of the other parameter.
struct RegionCuts {
  /// One line for each border, in the order of regions; empty where no curve shows it.
  std::array<std::vector<DiagramPoint>, 3> borders;
  std::array<std::vector<RegionCut>, 4> cuts;
};

RegionCuts cutRegions(const RisingMap& map, bool velocityIsX) {
  RegionCuts regions;
  const std::vector<double>& velocities = velocityIsX ? map.x : map.y;
  const std::vector<double>& others = velocityIsX ? map.y : map.x;
  const auto point = [&](double velocity, double other) {
    return velocityIsX ? DiagramPoint{velocity, other} : DiagramPoint{other, velocity};
  };
  const DiagramPoint gap{kNotApplicable, kNotApplicable};
  for (std::size_t k = 0; k < others.size(); ++k) {
    std::vector<CurvePoint> curve;
    for (std::size_t i = 0; i < velocities.size(); ++i)
      curve.push_back(velocityIsX ? map.cell(i, k) : map.cell(k, i));
    const Scene scene = velocityIsX ? map.scene(0, k) : map.scene(k, 0);
    const std::vector<CurveRegion> found = findRegions(scene, curve);
    std::array<bool, 3> isThere{};
    for (std::size_t r = 0; r < found.size(); ++r) {
      const std::size_t number = regionNumber(found[r].name);
      regions.cuts[number].push_back({others[k], found[r].from, found[r].to});
      if (r + 1 == found.size() || number > 2) continue;
      regions.borders[number].push_back(point(found[r].to, others[k]));
      isThere[number] = true;
    }
    for (std::size_t border = 0; border < 3; ++border)
      if (!isThere[border]) regions.borders[border].push_back(gap);
  }
  return regions;
}

bool isFinite(const DiagramPoint& point) {
  return std::isfinite(point.x) && std::isfinite(point.y);
}

DiagramSeries borderSeries(std::vector<DiagramPoint> points) {
  return {.stroke = SeriesStroke::Dashed,
          .isTheory = true,
          .points = std::move(points),
          .id = kRegionBorder};
}

/// Returns the position at which the name of a region has the most space: away from the borders of
/// the region, the edges of the map and the lines of the cross; of several positions with enough
/// space the one nearest to the middle.
DiagramPoint namePosition(const std::vector<RegionCut>& cuts, const ParameterMap& map,
                          const Diagram& diagram, bool velocityIsX) {
  constexpr std::array kParts{0.5, 0.4, 0.6, 0.3, 0.7};  // of the region's width
  constexpr double kEnough = 0.07;                       // of the side of the map
  const DiagramAxis& along = velocityIsX ? diagram.x : diagram.y;
  const DiagramAxis& across = velocityIsX ? diagram.y : diagram.x;
  const auto part = [](const DiagramAxis& axis, double value) {
    const double from = axisPosition(axis.scale, axis.from), to = axisPosition(axis.scale, axis.to);
    return (axisPosition(axis.scale, value) - from) / (to - from);
  };
  const double crossAlong = part(along, axisNumber(map.scene, velocityIsX ? map.x : map.y));
  const double crossAcross = part(across, axisNumber(map.scene, velocityIsX ? map.y : map.x));
  DiagramPoint best;
  double most = -std::numeric_limits<double>::infinity();
  for (const RegionCut& cut : cuts) {
    const double row = part(across, cut.other);
    const double from = part(along, cut.from), to = part(along, cut.to);
    for (const double share : kParts) {
      const double position = from + share * (to - from);
      double room = std::min({position - from, to - position, row, 1 - row});
      if (std::isfinite(crossAlong)) room = std::min(room, std::abs(position - crossAlong));
      if (std::isfinite(crossAcross)) room = std::min(room, std::abs(row - crossAcross));
      const double worth = std::min(room, kEnough) - 1e-3 * std::abs(row - 0.5);
      if (worth <= most) continue;
      most = worth;
      const double first = axisPosition(along.scale, along.from),
                   last = axisPosition(along.scale, along.to);
      const double velocity = axisValue(along.scale, first + position * (last - first));
      best = velocityIsX ? DiagramPoint{velocity, cut.other} : DiagramPoint{cut.other, velocity};
    }
  }
  return best;
}

/// Adds the borders of the regions, and their names in the middle. Returns what they are; empty
/// where there are none.
Message addRegionBorders(Diagram& diagram, const ParameterMap& given, const RisingMap& map) {
  const bool isX = given.x.key() == kVelocityKey, isY = given.y.key() == kVelocityKey;
  const bool isLogarithmic =
      (isX ? given.x : given.y).range.isLogarithmic;  // which the rule of regions needs
  if ((isX || isY) && isLogarithmic) {
    RegionCuts regions = cutRegions(map, isX);
    bool isAny = false;
    for (std::vector<DiagramPoint>& border : regions.borders) {
      if (std::ranges::count_if(border, isFinite) < 2) continue;
      isAny = true;
      diagram.series.push_back(borderSeries(std::move(border)));
    }
    if (!isAny) return {};
    for (std::size_t number = 0; number < 4; ++number) {
      if (regions.cuts[number].size() < 3) continue;
      const DiagramPoint at = namePosition(regions.cuts[number], given, diagram, isX);
      diagram.labels.push_back({Message::name(kRegionNames[number]), at.x, at.y});
    }
    return "Dashed: borders of the regions I to IV, each read from the friction curve at one value "
           "of the other parameter.";
  }
  // This is where single summits bear the load: v / v_few = 1, from the rms heights of the cells.
  std::vector<double> heights;
  for (std::size_t j = 0; j < map.y.size(); ++j)
    for (std::size_t i = 0; i < map.x.size(); ++i) {
      const double few = fewContactsVelocity(map.scene(i, j), {&map.cell(i, j), 1});
      heights.push_back(std::isgreater(few, 0) && map.cell(i, j).velocity > 0
                            ? std::log(map.cell(i, j).velocity / few)
                            : kNotApplicable);
    }
  bool isAny = false;
  for (const ContourLine& line : contourLines(axisPositions(map.x, diagram.x.scale),
                                              axisPositions(map.y, diagram.y.scale), heights, 0)) {
    diagram.series.push_back(borderSeries(diagramPoints(line, diagram.x.scale, diagram.y.scale)));
    isAny = true;
  }
  if (!isAny) return {};
  return "Dashed: F\u2099/(4\u03B7v) = 0.1 h (\u03B7: viscosity); beyond it few contacts carry the "
         "load (region IV).";
}

/// Returns a cross at the scene's own state if that is on the map.
std::optional<DiagramMarker> makeCross(const ParameterMap& map, const Diagram& diagram) {
  const double x = axisNumber(map.scene, map.x), y = axisNumber(map.scene, map.y);
  if (x < diagram.x.from || x > diagram.x.to || y < diagram.y.from || y > diagram.y.to) return {};
  return DiagramMarker{.x = x, .y = y, .isCross = true};
}

}  // namespace

Message mapQuantityTitle(std::string_view quantity) {
  for (const QuantityTitle& one : kTitles)
    if (one.quantity == quantity) return one.title;
  return Message::name(std::string(quantity));
}

DiagramSheet mapSheet(const ParameterMap& map, std::string_view quantity) {
  const Message x(map.x.range.row->label), y(map.y.range.row->label);
  const bool isOfFriction = quantity == "mu" || quantity == "exponent";
  DiagramSheet sheet{
      .title = isOfFriction ? message("Friction over {} and {}", x, y)
                            : message("Map over {} and {}: {}", x, y, mapQuantityTitle(quantity)),
      .subtitle = describeScene(map.scene, {map.x.key(), map.y.key()})};
  Diagram diagram{.x = diagramAxis(map.x), .y = diagramAxis(map.y)};
  const RisingMap rising(map, quantity);
  diagram.field = makeField(rising, diagram, quantity);
  diagram.marker = makeCross(map, diagram);
  std::vector<Message> notes{addRegionBorders(diagram, map, rising)};
  if (diagram.marker) notes.emplace_back("Cross: the scene's own state.");
  for (const bool alongX : {true, false})
    if (isWithoutEffect(map, alongX))
      notes.push_back(message("Friction does not depend on the {} here.",
                              Message((alongX ? map.x : map.y).range.row->label)));
  sheet.note = sentences(notes);
  if (std::ranges::none_of(rising.values, [](double value) { return std::isfinite(value); }))
    diagram.blank = "This quantity does not apply to these states.";
  sheet.diagrams = {std::move(diagram)};
  return sheet;
}

Diagram mapCut(const ParameterMap& map, std::string_view quantity, bool alongX) {
  const RisingMap rising(map, quantity);
  const MapAxis& along = alongX ? map.x : map.y;
  const MapAxis& across = alongX ? map.y : map.x;
  const std::vector<double>& abscissas = alongX ? rising.x : rising.y;
  const std::vector<double> others = axisPositions(alongX ? rising.y : rising.x, axisScale(across));
  // The cut is interpolated between the two rows or columns beside the state.
  const auto [least, most] = std::ranges::minmax(across.values);
  const double at =
      axisPosition(axisScale(across), std::clamp(axisNumber(map.scene, across), least, most));
  const auto above = std::ranges::lower_bound(others, at);
  const auto last = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(above - others.begin(), 1, std::ssize(others) - 1));
  const double part = (at - others[last - 1]) / (others[last] - others[last - 1]);
  Diagram diagram{.x = diagramAxis(along), .y = colourAxis(rising.values, quantity)};
  diagram.y.from = diagram.y.to = 0;
  DiagramSeries series{.mark = SeriesMark::Circle, .colour = 0};
  const std::size_t columns = rising.x.size();
  for (std::size_t i = 0; i < abscissas.size(); ++i) {
    const auto value = [&](std::size_t other) {
      return alongX ? rising.values[other * columns + i] : rising.values[i * columns + other];
    };
    const double a = value(last - 1), b = value(last);
    double between = kNotApplicable;
    if (std::isfinite(a) && std::isfinite(b))
      between =
          a > 0 && b > 0 && quantity != "exponent" ? a * std::pow(b / a, part) : a + (b - a) * part;
    series.points.push_back({abscissas[i], between});
  }
  diagram.series = {std::move(series)};
  DiagramMarker marker;
  marker.x = axisNumber(map.scene, along);
  if (marker.x >= diagram.x.from && marker.x <= diagram.x.to) diagram.marker = marker;
  return diagram;
}

}  // namespace asperity
