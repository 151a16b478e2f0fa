// How the cost of one simulation grows with N and with the part of the line in contact, cubic x2 at
// velocities near 0.01 m/s.
#include "tests/bench/fields.h"
#include "tests/bench/line_store.h"
#include "tests/bench/workload.h"

namespace asperity::bench {
namespace {

Body shipped(const PreparedProfile& line, double force) {
  return [&line, force] { return shippedSweep(line, force, nearlyOneVelocity()); };
}

void addGrid(std::int64_t elements, const Contact& contact) {
  addCase(gridName("shipped", elements, contact.name), [=] {
    const PreparedProfile& line = preparedProfile({elements});
    return shipped(line, forceForContact(line, contact.fraction));
  });
  const auto scalar = [=]() -> Body {
    const PreparedProfile& line = preparedProfile({elements});
    const double force = forceForContact(line, contact.fraction);
    return [&line, force] { return scalarSweep(line, force, {&kSlow, 1}); };
  };
  addCase(gridName("scalar", elements, contact.name), scalar, Clock::Cpu,
          elements >= 100000 ? 3 : 0, elements >= 100000 ? 1e-3 : 0);
}

}  // namespace

void addGrowthCases(bool /*quick*/) {
  for (const double fraction : kFractions)
    addCase(fractionName(fraction), [=] {
      const PreparedProfile& line = preparedProfile({5000});
      return shipped(line, forceForContact(line, fraction));
    });
  for (const std::int64_t elements : kSameContact)
    addCase(sameContactName(elements), [=] {
      const PreparedProfile& line = preparedProfile({elements});
      const double fraction = kContactElements / static_cast<double>(elements);
      return shipped(line, forceForContact(line, fraction));
    });
  for (const std::int64_t elements : kElements)
    for (const Contact& contact : kContacts) addGrid(elements, contact);
}

}  // namespace asperity::bench
