#include "ui/picture/diagram_picture.h"

#include <algorithm>

namespace asperity {

DiagramOptions printOptions(const DiagramSheet& sheet, const Theme& theme) {
  DiagramOptions options;
  const int more = std::clamp(static_cast<int>(sheet.diagrams.size()), 1, 4) - 1;
  options.width = 2400 + 1200 * more;
  options.height = 1600;
  options.scale = 2;
  options.theme = theme;
  return options;
}

DrawList composeDiagrams(const DiagramSheet&, const DiagramOptions& options) {
  DrawList list;
  list.width = std::max(options.width, 1);
  list.height = std::max(options.height, 1);
  list.background = options.theme.background;
  return list;
}

}  // namespace asperity
