#include "ui/picture/svg_file.h"

#include "core/scene/atomic_file.h"

namespace asperity {

std::string svgOf(const DrawList&, const SvgOptions&) {
  return {};
}

void writeSvg(const std::filesystem::path& path, const DrawList& list, const SvgOptions& options) {
  writeFileAtomically(path, svgOf(list, options));
}

}  // namespace asperity
