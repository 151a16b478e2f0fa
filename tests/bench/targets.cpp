#include "tests/bench/targets.h"

#include "tests/bench/fields.h"
#include "tests/bench/table.h"

namespace asperity::bench {
namespace {

enum class Wanted { AtMost, AtLeast };

struct Target {
  const char* what;
  const char* set;  // instruction set it belongs to; empty: the one in use
  const char* unit;
  Wanted wanted;
  double limit;
  std::optional<double> (*measure)(const Measured&, const char* set);
  const char* limitedBy;  // what stands in the way, printed where the target is missed
};

std::optional<double> times(std::optional<double> value, double factor) {
  return value ? std::optional(*value * factor) : std::nullopt;
}
std::optional<double> secondsOf(const Measured& measured, const std::string& name) {
  const auto sample = measured.samples.find(name);
  return sample ? std::optional(sample->seconds) : std::nullopt;
}

template <int kResolution>
std::optional<double> figure2(const Measured& measured, const char* set) {
  return times(secondsOf(measured, figure2Name(set, kResolutions[kResolution].name)), 1e6);
}
std::optional<double> figure4(const Measured& measured, const char* set) {
  return times(secondsOf(measured, figure4Name(set)), 1e6);
}
std::optional<double> literalRatio(const Measured& measured, const char*) {
  return measured.ratio(figure2Name("literal", "nodal"),
                        figure2Name(measured.instructionSets.back(), "cubic_x2"));
}
std::optional<double> sameContact(const Measured& measured, const char*) {
  return measured.ratio(sameContactName(kSameContact[1]), sameContactName(kSameContact[0]));
}
std::optional<double> studyCubic(const Measured& measured, const char*) {
  if (!measured.studyCubic) return std::nullopt;
  return measured.studyCubic->secondsOn(2);
}
std::optional<double> studyLinear(const Measured& measured, const char*) {
  if (!measured.studyLinear) return std::nullopt;
  return measured.studyLinear->secondsOn(2);
}
std::optional<double> memory(const Measured& measured, const char*) {
  return times(measured.peakMemory, 1.0 / (1 << 20));
}
std::optional<double> cancel(const Measured& measured, const char*) {
  return times(measured.cancel, 1e3);
}
std::optional<double> cancelLong(const Measured& measured, const char*) {
  return times(measured.cancelLong, 1e3);
}
template <int kResolution, std::int64_t kLines>
std::optional<double> curve(const Measured& measured, const char*) {
  return times(secondsOf(measured, curveName(kResolutions[kResolution].name, kLines)), 1e3);
}

std::optional<double> studyOverhead(const Measured& measured, const char*) {
  if (!measured.studyCost) return std::nullopt;
  return 1e6 * measured.studyCost->perSimulation();
}
std::optional<double> studyRows(const Measured& measured, const char*) {
  if (!measured.studyCost) return std::nullopt;
  return measured.studyCost->rowsPerSecond();
}

constexpr auto kMax = Wanted::AtMost;

// What profiles show.
constexpr const char* kFewLooks =
    "at light load a pass is 24 to 50 segments looked into: two fifths of the time go to their "
    "edges, as much to the ways between them, which each lane goes alone (mispredicted branches), "
    "the rest to starting passes; 16 lanes are 9 busy in a curve of one line";
constexpr const char* kStudy =
    "three quarters are simulations, 3 passes each, which is next to the least that a balance to "
    "1e-13 can do with; the series of spacings takes half of all, half of it for its lines";
constexpr const char* kWallClock =
    "no step of making a line in used memory and no 256 steps of a pass take 2 ms of a core at "
    "N = 200,000; a thread's first line, in fresh memory, and waiting for a core count too";

// clang-format off
constexpr Target kTargets[] = {
    {"Fig. 2, `linear`, N = 5000", "AVX-512", "us", kMax, 4, figure2<1>, ""},
    {"Fig. 2, `linear`, N = 5000", "AVX2", "us", kMax, 8, figure2<1>, ""},
    {"Fig. 2, `nodal`, N = 5000", "AVX-512", "us", kMax, 15, figure2<0>, ""},
    {"Fig. 2, `nodal`, N = 5000", "AVX2", "us", kMax, 25, figure2<0>, ""},
    {"Fig. 2, `cubic` x2, N = 5000", "AVX-512", "us", kMax, 12, figure2<2>, kFewLooks},
    {"Fig. 2, `cubic` x2, N = 5000", "AVX2", "us", kMax, 15, figure2<2>, kFewLooks},
    {"Fig. 4, `cubic` x2, N = 5000", "AVX-512", "us", kMax, 60, figure4, ""},
    {"Fig. 4, `cubic` x2, N = 5000", "AVX2", "us", kMax, 80, figure4, ""},
    {"Fig. 2, literal algorithm over `cubic` x2", "", "times", Wanted::AtLeast, 2000, literalRatio, ""},
    {"N = 1e6 over N = 1e4, 500 elements in contact", "", "times", kMax, 20, sameContact, ""},
    {"the paper's study, `cubic` x2 (scaled up)", "", "s", kMax, 150, studyCubic, kStudy},
    {"the paper's study, `linear` (scaled up)", "", "s", kMax, 30, studyLinear, kStudy},
    {"peak memory, 200 lines, N = 5000, `cubic` x2", "", "MiB", kMax, 100, memory, ""},
    {"first curve, 1 line, `cubic` x2", "", "ms", kMax, 16, curve<2, 1>, ""},
    {"first curve, 1 line, `nodal`", "", "ms", kMax, 16, curve<0, 1>, ""},
    {"whole curve, 200 lines, `nodal`", "", "ms", kMax, 200, curve<0, kRealizations>, ""},
    {"cancelling an ensemble, N = 5000, `cubic` x2, slowest", "", "ms", kMax, 10, cancel, kWallClock},
    {"cancelling an ensemble, N = 200,000, `cubic` x2, slowest", "", "ms", kMax, 10, cancelLong, kWallClock},
    {"a study's simulation beyond kernel and line", "", "us", kMax, 5, studyOverhead, ""},
    {"rows of a study's table", "", "per second", Wanted::AtLeast, 100000, studyRows, ""},
    {"whole curve, 200 lines, `cubic` x2", "", "ms", kMax, 1000, curve<2, kRealizations>, ""},
};
// clang-format on

std::string verdict(const Target& target, double value) {
  const bool isMet =
      target.wanted == Wanted::AtMost ? value <= target.limit : value >= target.limit;
  if (isMet) return "met";
  return *target.limitedBy != '\0' ? std::string("missed: ") + target.limitedBy : "missed";
}

}  // namespace

std::optional<double> Measured::ratio(const std::string& slow, const std::string& fast) const {
  const auto above = samples.find(slow), below = samples.find(fast);
  return above && below ? std::optional(above->seconds / below->seconds) : std::nullopt;
}

std::string targetTable(const Measured& measured) {
  Table table({"what", "instruction set", "target", "measured", "of the target", ""});
  for (const Target& target : kTargets) {
    const std::string set = *target.set != '\0' ? target.set : measured.instructionSets.back();
    const auto value = target.measure(measured, set.c_str());
    if (!value) continue;
    const char* bound = target.wanted == Wanted::AtMost ? "<=" : ">=";
    table.add({target.what, set,
               std::string(bound) + " " + number(target.limit) + " " + target.unit,
               number(*value) + " " + target.unit, number(*value / target.limit),
               verdict(target, *value)});
  }
  return table.isEmpty() ? "" : table.text();
}

}  // namespace asperity::bench
