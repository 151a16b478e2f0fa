#include "tests/bench/report_sections.h"

#include <fmt/format.h>

#include "core/contact/kernels/kernels.h"
#include "tests/bench/fields.h"
#include "tests/bench/table.h"

namespace asperity::bench {
namespace {

std::string growthInElements(const Measured& measured) {
  Table table({"load", "N", "cost over that at N = 1,000", "N over 1,000"});
  for (const Contact& contact : kContacts)
    for (const std::int64_t elements : kElements) {
      const auto ratio = measured.ratio(gridName("shipped", elements, contact.name),
                                        gridName("shipped", kElements[0], contact.name));
      if (!ratio) continue;
      table.add({contact.name, number(static_cast<double>(elements)), number(*ratio),
                 number(static_cast<double>(elements / kElements[0]))});
    }
  return table.isEmpty() ? "" : table.text() + "\n";
}

std::string growthInContact(const Measured& measured) {
  Table table({"contact", "cost over the lightest", "simulation", "passes"});
  for (const double fraction : kFractions) {
    const auto sample = measured.samples.find(fractionName(fraction));
    const auto ratio = measured.ratio(fractionName(fraction), fractionName(kFractions[0]));
    if (sample && ratio)
      table.add({percent(sample->contactFraction), number(*ratio), duration(sample->seconds),
                 number(sample->passes)});
  }
  return table.isEmpty() ? "" : table.text() + "\n";
}

// The model of the machine's peak. A pass that looked at every segment of a resolved line would
// need, for each segment and lane: d - rise and its pressure (2), the free depth (1) and the
// comparison with it (1), the sums of depth, of stiffness and of z'^2 (3), and the choice between
// contact and free (1): 8 operations. A core with two vector pipes does two per cycle and lane.
constexpr double kOperations = 8, kPipes = 2;

std::string sameContact(const Measured& measured) {
  Table table(
      {"N, 500 elements in contact", "contact", "cost over the first", "simulation", "passes"});
  for (const std::int64_t elements : kSameContact) {
    const auto sample = measured.samples.find(sameContactName(elements));
    const auto ratio = measured.ratio(sameContactName(elements), sameContactName(kSameContact[0]));
    if (sample && ratio)
      table.add({number(static_cast<double>(elements)), percent(sample->contactFraction),
                 number(*ratio), duration(sample->seconds), number(sample->passes)});
  }
  return table.isEmpty() ? "" : table.text() + "\n";
}

}  // namespace

std::string growthSection(const Measured& measured) {
  const std::string elements = growthInElements(measured), contact = growthInContact(measured);
  const std::string same = sameContact(measured);
  if (elements.empty() && contact.empty() && same.empty()) return "";
  return "## Growth of the shipped path's cost (cubic x2, v = 0.01 m/s)\n\n" + elements + same +
         (contact.empty() ? "" : "N = 5000:\n\n" + contact);
}

std::string peakSection(const Measured& measured) {
  Table table({"N = 5000, cubic x2", "passes", "cycles per segment, lane and pass", "of peak"});
  const auto lanes = static_cast<double>(laneCount());
  for (const double fraction : kFractions) {
    const auto sample = measured.samples.find(fractionName(fraction));
    if (!sample || sample->passes <= 0) continue;
    const double segments = 2 * 5000;
    const double cycles = sample->seconds * measured.clock / sample->passes / segments;
    const double least = kOperations / (kPipes * lanes);
    table.add({"contact " + percent(sample->contactFraction), number(sample->passes),
               number(cycles), number(100 * least / cycles) + " %"});
  }
  if (table.isEmpty()) return "";
  return fmt::format(
             "## Fraction of the machine's peak\nModel: a pass over every segment costs {} "
             "operations per segment and lane; two vector pipes of {} lanes do {} per cycle, so "
             "the least is {} cycles. Blocks that are skipped or taken whole count as if every "
             "segment had been computed: more than 100 % means work avoided.\n\n",
             number(kOperations), number(lanes), number(kPipes * lanes),
             number(kOperations / (kPipes * lanes))) +
         table.text() + "\n";
}

std::string curveSection(const Measured& measured) {
  Table table({"41 velocities, 2 threads, lines included", "first line", "200 lines", "passes",
               "peak memory"});
  for (const Resolution& resolution : kResolutions) {
    const auto first = measured.samples.find(curveName(resolution.name, 1));
    const auto all = measured.samples.find(curveName(resolution.name, kRealizations));
    if (!first || !all) continue;
    const auto& bytes = resolution.scheme == Scheme::Nodal   ? measured.peakMemoryNodal
                        : resolution.scheme == Scheme::Cubic ? measured.peakMemory
                                                             : std::optional<double>{};
    table.add({resolution.name, duration(first->seconds), duration(all->seconds),
               number(all->passes), bytes ? number(*bytes / (1 << 20)) + " MiB" : "-"});
  }
  if (table.isEmpty()) return "";
  return "## Whole curves of Fig. 2\nWall-clock time; peak memory (largest resident set) is that "
         "of a process of its own.\n\n" +
         table.text() + "\n";
}

}  // namespace asperity::bench
