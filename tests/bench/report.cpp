#include "tests/bench/report.h"

#include <fmt/format.h>

#include "tests/bench/fields.h"
#include "tests/bench/machine.h"
#include "tests/bench/report_sections.h"
#include "tests/bench/table.h"

namespace asperity::bench {
namespace {

/// A page made beside other work says so.
std::string sharedMachine(double load) {
  if (load < 0.5) return "";
  return fmt::format(
      "Other work shared the machine (load average {:.1f} before the run): times are too long, "
      "those of whole curves and of cancelling, by the wall clock, by far; ratios within a table "
      "hold better.\n",
      load);
}

using Find = std::optional<Sample>;

std::string timesOf(std::optional<double> ratio) {
  return ratio ? number(*ratio) : "-";
}

std::string headOf(const Measured& measured) {
  std::string sets;
  for (const std::string& set : measured.instructionSets) sets += (sets.empty() ? "" : ", ") + set;
  return fmt::format(
      "# {}\n\nInstruction sets: {}; in use: {}. Clock: {:.2f} GHz (a chain of dependent "
      "additions).\nCPU time of one core, medians of repeated runs in one process; whole curves "
      "are wall-clock time on 2 threads.\nA simulation is one line at one velocity and one force, "
      "its balance solved; lines and their block minima are given unless it says "
      "otherwise.\n{}{}\n",
      cpuName(), sets, measured.instructionSets.back(), measured.clock / 1e9,
      sharedMachine(measured.loadBefore),
      measured.isQuick ? "Quick run: few repetitions, 9 velocities for the literal algorithm, 3 "
                         "Hurst exponents; not to be quoted.\n"
                       : "");
}

/// Fig. 2: every way to the same curve, against the shipped path.
std::string figure2Section(const Measured& measured) {
  const std::string best = measured.instructionSets.back();
  Table table({"Fig. 2, N = 5000, 41 velocities", "simulation", "passes", "literal over it",
               "literal, wide, over it"});
  const auto row = [&](const std::string& label, const std::string& name) {
    const Find sample = measured.samples.find(name);
    if (!sample) return;
    table.add({label, duration(sample->seconds), number(sample->passes),
               timesOf(measured.ratio(figure2Name("literal", "nodal"), name)),
               timesOf(measured.ratio(figure2Name("literal_wide", "nodal"), name))});
  };
  row("literal algorithm, as compiled", figure2Name("literal", "nodal"));
  row("literal algorithm, widest vectors", figure2Name("literal_wide", "nodal"));
  for (const Resolution& resolution : kResolutions) {
    row(fmt::format("scalar pass, {}", resolution.name),
        figure2Name("scalar_pass", resolution.name));
    for (const std::string& set : measured.instructionSets)
      row(fmt::format("shipped, {}, {}{}", resolution.name, set, set == best ? " (in use)" : ""),
          figure2Name(set, resolution.name));
  }
  for (const std::string& set : measured.instructionSets)
    row(fmt::format("Fig. 4 (20 forces): shipped, cubic_x2, {}", set), figure4Name(set));
  if (table.isEmpty()) return "";
  return "## Ratios on the curve of Fig. 2\nFor the literal algorithm, passes are sweeps over the "
         "elements per time step, N steps.\n\n" +
         table.text() + "\n";
}

/// Three paths, four lengths, three loads.
std::string gridSection(const Measured& measured) {
  Table table({"N", "load", "contact", "literal / shipped", "literal wide / shipped",
               "scalar / shipped", "shipped", "passes", "scalar", "literal"});
  for (const std::int64_t elements : kElements)
    for (const Contact& contact : kContacts) {
      const auto name = [&](const char* path) { return gridName(path, elements, contact.name); };
      const Find shipped = measured.samples.find(name("shipped"));
      const Find scalar = measured.samples.find(name("scalar"));
      const Find literal = measured.samples.find(name("literal"));
      if (!shipped || !scalar || !literal) continue;
      const char* mark = literal->isExtrapolated ? " (extrapolated)" : "";
      table.add(
          {number(static_cast<double>(elements)), contact.name, percent(shipped->contactFraction),
           timesOf(measured.ratio(name("literal"), name("shipped"))) + mark,
           timesOf(measured.ratio(name("literal_wide"), name("shipped"))) + mark,
           timesOf(measured.ratio(name("scalar"), name("shipped"))), duration(shipped->seconds),
           number(shipped->passes), duration(scalar->seconds), duration(literal->seconds) + mark});
    }
  if (table.isEmpty()) return "";
  return "## Literal, scalar and shipped at v = 0.01 m/s\nResolved paths: cubic x2, the scalar one "
         "cold; shipped: 16 velocities within 35 %. Extrapolated: 200 of the literal algorithm's N "
         "steps were timed (20 in a quick run), begun in steady sliding. In complete contact the "
         "shipped path takes the whole line as one block.\n\n" +
         table.text() + "\n";
}

void addStudy(const char* scheme, const StudyEstimate& study, Table& table) {
  std::vector<StudySeries> rows = study.series;
  rows.push_back(study.total());
  for (const StudySeries& row : rows)
    table.add({scheme, row.varied, number(row.lines), number(row.simulations),
               duration(row.lineSeconds / 2), duration(row.simulationSeconds / 2),
               duration((row.lineSeconds + row.simulationSeconds) / 2)});
}

std::string studySection(const Measured& measured) {
  Table table({"scheme", "varied", "lines", "simulations", "lines, 2 cores", "simulations, 2 cores",
               "together"});
  std::string notes;
  for (const auto& [scheme, study] :
       {std::pair{"linear", &measured.studyLinear}, std::pair{"cubic_x2", &measured.studyCubic},
        std::pair{"linear, AVX2", &measured.studyLinearAvx2},
        std::pair{"cubic_x2, AVX2", &measured.studyCubicAvx2}}) {
    if (!*study) continue;
    addStudy(scheme, **study, table);
    notes += fmt::format(
        "{}: {} simulations timed; mean N {}, contact {}, {} passes a simulation; the paper's 50 h "
        "are {} times as long.\n",
        scheme, number((*study)->sampled), number((*study)->elements),
        percent((*study)->contactFraction), number((*study)->passes),
        number(50 * 3600 / (*study)->secondsOn(2)));
  }
  if (table.isEmpty()) return "";
  return "## The paper's study\nA stratified sample (one line in 200 of every parameter set, all "
         "20 "
         "velocities) scaled up, not a run of the whole; one core's time, halved for two. The "
         "paper's 50 h are those of its own machine. Moduli and rms heights are other forces on "
         "the same line (exact scaling), so no lines are made for them; numbers of elements are "
         "those next to the spacings (within 1 %) whose prime factors are small, for which "
         "transforms are several times as fast.\n\n" +
         table.text() + "\n" + notes;
}

}  // namespace

std::string report(const Measured& measured) {
  std::string page = headOf(measured) + figure2Section(measured);
  const std::string targets = targetTable(measured);
  if (!targets.empty()) page += "## Targets\n\n" + targets + "\n";
  return page + gridSection(measured) + growthSection(measured) + peakSection(measured) +
         curveSection(measured) + studySection(measured);
}

}  // namespace asperity::bench
