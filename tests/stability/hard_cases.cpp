#include "tests/stability/hard_cases.h"

#include <cmath>
#include <numbers>

#include "core/surface/line.h"
#include "core/surface/line_source.h"
#include "core/surface/spectrum.h"

namespace asperity {
namespace {

constexpr double kModulus = 1e7, kTau = 1e-3, kLength = 0.02, kHeight = 5e-7, kForce = 0.0034;
constexpr Scheme kAll[] = {Scheme::Nodal, Scheme::Linear, Scheme::Cubic};

Line rough(std::int64_t elements, double hurst = 0.7, double height = kHeight) {
  Scene scene;
  scene.surface.elements = elements;
  scene.surface.hurst = hurst;
  scene.surface.rmsHeight = height;
  return LineSource(scene, 1).make(0);
}

/// Straight from node to node, with corners.
Line polygon(const std::vector<double>& heights) {
  Line line;
  line.length = kLength;
  line.spacing = kLength / static_cast<double>(heights.size());
  line.height = heights;
  const std::size_t n = heights.size();
  line.slopeBefore.resize(n);
  double squares = 0;
  for (std::size_t i = 0; i < n; ++i) {
    line.slopeAfter.push_back((heights[(i + 1) % n] - heights[i]) / line.spacing);
    line.slopeBefore[(i + 1) % n] = line.slopeAfter[i];
    squares += line.slopeAfter[i] * line.slopeAfter[i];
  }
  line.rmsSlope = std::sqrt(squares / static_cast<double>(n));
  line.rmsHeight = kHeight;
  return line;
}

/// The band-limited line through heights, as a measured profile is taken.
Line smooth(const std::vector<double>& heights) {
  const FourierTransform transform(heights.size());
  const FourierLine modes = transform.analyse(heights, kLength);
  Line line;
  line.length = kLength;
  line.spacing = kLength / static_cast<double>(heights.size());
  transform.evaluate(modes, line.height);
  transform.evaluateSlope(modes, line.slopeAfter);
  line.rmsHeight = rmsHeight(modes);
  line.rmsSlope = rmsSlope(modes);
  return line;
}

template <class Function>
std::vector<double> heights(std::size_t count, const Function& function) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(kHeight * function(static_cast<double>(i) / static_cast<double>(count)));
  return values;
}

double sawtooth(double x) {
  return 4 * x - 2;
}
double step(double x) {
  return x < 0.5 ? -1 : 1;
}
double plateaus(double x) {
  const double wave = 3 * std::sin(6 * std::numbers::pi * x);
  return std::clamp(wave, -1.0, 1.0);
}
double twoLowest(double x) {
  return -std::abs(std::sin(2 * std::numbers::pi * x));
}

class Table {
 public:
  void add(const std::string& name, const std::string& why, const Line& line, double velocity,
           double force, double tau = kTau) {
    for (const Scheme scheme : kAll)
      addOne(name, why, scheme, line, {kModulus, tau, velocity}, force);
  }
  void addOne(const std::string& name, const std::string& why, Scheme scheme, const Line& line,
              const SlidingConditions& conditions, double force) {
    HardCase row{name, why, {line, scheme, conditions, {}}};
    row.situation.load.normalForce = force;
    rows.push_back(row);
  }
  void atDepth(const std::string& name, const std::string& why, const Line& line, double velocity,
               double depth) {
    for (const Scheme scheme : kAll) {
      HardCase row{name, why, {line, scheme, {kModulus, kTau, velocity}, {}}};
      row.situation.load.kind = LoadKind::Indentation;
      row.situation.load.depth = depth;
      rows.push_back(row);
    }
  }

  std::vector<HardCase> rows;
};

void addConditions(Table& table) {
  const Line line = rough(500);
  table.add("v = 0", "no memory at all", line, 0, kForce);
  table.add("v = 1e-12", "decay within 1e-10 of an element", line, 1e-12, kForce);
  table.add("v = 1e9", "contact of 1e-9 of an element", line, 1e9, kForce);
  table.add("v = 1e12, tau = 1e12", "every range at its end", line, 1e12, kForce, 1e12);
  table.add("tau = 0", "elastic", line, 1, kForce, 0);
  table.add("tau = 1e-300", "1 / c beyond numbers", line, 1e-12, kForce, 1e-300);
  table.add("tau = 1e12", "nothing ever relaxes", line, 1, kForce, 1e12);
  for (const double exponent : {-12, -6, 0, 6, 12}) {
    const double bar = std::pow(10, exponent);
    for (const double velocity : {1e-3, 1.0, 1e3})
      table.add("Fbar = 1e" + std::to_string(static_cast<int>(exponent)) +
                    ", v = " + std::to_string(velocity).substr(0, 6),
                exponent < 0 ? "contact far below an element" : "d far above the heights", line,
                velocity, bar * kModulus * kHeight * kLength);
  }
}

/// The indentation from which on the line touches everywhere: max(z - c z'), over the segments.
double fullContactDepth(const Line& line, double memory) {
  const PreparedProfile profile = prepareProfile(line, Scheme::Cubic);
  double depth = 0;
  for (std::size_t i = 0; i < profile.segments(); ++i) {
    const Cubic rise = profile.segment(i);
    const double k = memory / profile.segmentLength(i);
    const Cubic needed{rise.c0 + k * rise.c1, rise.c1 + 2 * k * rise.c2, rise.c2 + 3 * k * rise.c3,
                       rise.c3};
    depth = std::max({depth, needed(0), needed(1)});
    for (const double t : stationaryPoints(needed)) depth = std::max(depth, needed(t));
  }
  return depth;
}

void addFullContact(Table& table) {
  const Line line = rough(500);
  for (const double velocity : {0.01, 1.0, 1e3}) {
    const double full = fullContactDepth(line, velocity * kTau);
    const std::string v = ", v = " + std::to_string(velocity).substr(0, 6);
    table.atDepth("contact just complete" + v, "the last gap closes", line, velocity,
                  full * (1 + 1e-14));
    table.atDepth("complete contact just lost" + v, "a gap of 1e-7 of an element", line, velocity,
                  full * (1 - 1e-14));
    table.atDepth("lost by 1e-6" + v, "a gap of 1e-3 of an element", line, velocity,
                  full * (1 - 1e-6));
  }
  table.atDepth("d = 1e9 h, v = 1", "d - z loses nine digits", line, 1, 1e9 * kHeight);
  const double fast = 1e9 * kHeight / fullContactDepth(line, 1.0) / kTau;
  table.atDepth("d = 1e9 h, contact half lost", "and gaps are told by the lost digits", line,
                2 * fast, 1e9 * kHeight);
}

void addLines(Table& table) {
  const std::vector<double> speeds{1e-3, 1.0, 1e3};
  const auto each = [&](const std::string& name, const std::string& why, const Line& line,
                        double force = kForce) {
    for (const double v : speeds)
      table.add(name + ", v = " + std::to_string(v).substr(0, 6), why, line, v, force);
  };
  each("H = 0", "rough at every scale", rough(500, 0));
  each("H = 1", "smooth at short ones", rough(500, 1));
  each("h = 0", "flat", rough(500, 0.7, 0));
  each("h = 1e-15", "far below an atom", rough(500, 0.7, 1e-15));
  each("N = 3", "one mode", rough(3));
  each("N = 7", "three modes", rough(7));
  each("N = 4999", "a prime", rough(4999));
  each("two lowest points", "the start is not unique", polygon(heights(400, twoLowest)));
  each("plateaus", "p = 0 along whole stretches", polygon(heights(400, plateaus)));
  each("plateaus, smooth", "nearly flat stretches", smooth(heights(400, plateaus)));
  each("sawtooth", "a fall within one element", polygon(heights(400, sawtooth)));
  each("sawtooth, smooth", "with its ringing", smooth(heights(400, sawtooth)));
  each("step", "a wall of one element", polygon(heights(400, step)));
  each("step, smooth", "with its ringing", smooth(heights(400, step)));
  std::vector<double> outlier = rough(400).height;
  outlier[57] = 1e6 * kHeight;
  each("a hole of 1e6 h", "heights of two magnitudes", polygon(outlier));
  outlier[57] = -1e6 * kHeight;
  each("a tip of 1e6 h", "one element carries all", polygon(outlier));
  each("a tip of 1e6 h, smooth", "one element carries all", smooth(outlier));
  each("one wedge, light", "single-element contact", wedgeLine(kLength, 401, 1e-3), 1e-12);
  each("one parabola, light", "single-element contact", parabolaLine(kLength, 401, 0.1), 1e-12);
  each("denormal decay", "u far below 1e-308", wedgeLine(kLength, 4001, 1e-3), 1e-9);
}

/// Where the literal force jumps no depth meets the load; the share of the element on the edge
/// does.
void addNodalJumps(Table& table) {
  const Line line = rough(500);
  for (const double force : {1e-9, 1e-5, kForce})
    for (const double velocity : {1e-9, 1e-3, 0.1, 10.0})
      table.addOne("nodal, " + std::to_string(force * 1e9).substr(0, 5) + " nN, v = 1e" +
                       std::to_string(static_cast<int>(std::log10(velocity))),
                   "F_N(d) jumps; mu of either sign", Scheme::Nodal, line,
                   {kModulus, kTau, velocity}, force);
}

void addLargest(Table& table) {
  const Line line = rough(1 << 20);
  table.add("N = 2^20, v = 1000", "long sums", line, 1e3, kForce);
}

}  // namespace

std::vector<HardCase> hardCases() {
  Table table;
  addConditions(table);
  addFullContact(table);
  addLines(table);
  addNodalJumps(table);
  addLargest(table);
  return table.rows;
}

}  // namespace asperity
