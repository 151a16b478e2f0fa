// The readers of measured surfaces, one target for each ASPERITY_FUZZ_FORMAT: what they take is at
// least three points along x, finite or gaps. "x3p_xml" is main.xml in an archive that is whole,
// since random bytes hardly ever are.
#include <cmath>

#include "core/measured/measured_file.h"
#include "tests/core/measured/written_surface.h"
#include "tests/fuzz/fuzz_target.h"

namespace asperity {
namespace {

void requireSound(std::string_view bytes, const ReadingChoices& choices) {
  const MeasuredFile file = readMeasuredBytes(bytes, "surface", choices);
  const Topography& grid = file.topography;
  require(grid.columns >= 3 && grid.rows >= 1);
  require(grid.height.size() == static_cast<std::size_t>(grid.columns * grid.rows));
  require(std::isfinite(grid.columnSpacing) && grid.columnSpacing > 0);
  require(std::isfinite(grid.rowSpacing) && grid.rowSpacing >= 0);
  for (const double height : grid.height) require(!std::isinf(height));
  for (const Message& note : file.facts.notes) require(!note.english().empty());
}

}  // namespace
}  // namespace asperity

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asperity;
  return readOrRefuse(data, size, [](std::string_view text) {
    const std::string_view format = ASPERITY_FUZZ_FORMAT;
    ReadingChoices choices;
    // Whatever the file says, units are no reason to stop.
    choices.positionUnit = choices.heightUnit = "um";
    if (format == "x3p_xml") {
      const std::string archive = written::zipped(
          {{"main.xml", std::string(text)}, {"bindata/data.bin", std::string(224, '\x40')}}, false);
      requireSound(archive, choices);
    } else {
      choices.format = format;
      requireSound(text, choices);
    }
  });
}
