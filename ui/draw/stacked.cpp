#include "ui/draw/stacked.h"

#include <algorithm>
#include <utility>

#include "ui/draw/shapes.h"

namespace asperity {

void addPicture(DrawList& list, DrawList part, float right, float down) {
  const Box box{right, down, static_cast<float>(part.width), static_cast<float>(part.height)};
  if (part.background.a > 0) {
    DrawLayer background;
    addRectangle(background, box, part.background);
    list.layers.push_back(std::move(background));
  }
  for (DrawLayer& layer : part.layers) {
    if (layer.clip.width > 0)
      layer.clip = {layer.clip.x + right, layer.clip.y + down, layer.clip.width, layer.clip.height};
    else
      layer.clip = {box.x, box.y, box.width, box.height};
    const auto move = [&](std::vector<DrawVertex>& vertices) {
      for (DrawVertex& vertex : vertices) {
        vertex.x += right;
        vertex.y += down;
      }
    };
    move(layer.triangles);
    for (DrawLine& line : layer.lines) move(line.vertices);
    list.layers.push_back(std::move(layer));
  }
  for (DrawText& text : part.texts) {
    text.x += right;
    text.y += down;
    list.texts.push_back(std::move(text));
  }
}

DrawList stacked(DrawList above, DrawList below) {
  DrawList list;
  list.width = std::max(above.width, below.width);
  list.height = above.height + below.height;
  list.background = above.background;
  const auto down = static_cast<float>(above.height);
  below.background.a = 0;
  above.background.a = 0;
  addPicture(list, std::move(above), 0, 0);
  addPicture(list, std::move(below), 0, down);
  return list;
}

}  // namespace asperity
