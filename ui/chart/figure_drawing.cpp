#include "ui/chart/figure_drawing.h"

#include <utility>

#include "core/run/steady_frames.h"
#include "ui/contact/contact_picture.h"
#include "ui/language/translated.h"

namespace asperity {
namespace {

constexpr double kFramesPerSecond = 25;  // of the film that begins with the frame of the contact

/// Replaces the scene's title by the figure's translated title.
Frame inPresentLanguage(Frame contact, const Figure& figure) {
  Scene scene = *contact.scene;
  scene.title = translated(figure.sheet.title);
  contact.scene = std::make_shared<const Scene>(std::move(scene));
  return contact;
}

}  // namespace

std::shared_ptr<const Frame> contactFrame(const Figure& figure) {
  if (!figure.sheet.diagrams.empty()) return nullptr;
  Scene scene = figure.scene;
  scene.title = figure.sheet.title.english();
  const SteadyFrames frames(std::make_shared<const Scene>(std::move(scene)));
  return std::make_shared<const Frame>(frames.frame(0, 1, kFramesPerSecond));
}

DrawList composeFigure(const Figure& figure, const Frame* contact, const DiagramOptions& options) {
  if (!contact) return composeDiagrams(figure.sheet, options);
  ContactPictureOptions picture;
  picture.width = options.width;
  picture.height = options.height;
  picture.scale = options.scale;
  picture.theme = options.theme;
  picture.fontSize = options.format.fontSize;
  picture.lineWidth = options.format.lineWidth;
  picture.title = !figure.sheet.title.empty();
  return composeContact(inPresentLanguage(*contact, figure), picture);
}

}  // namespace asperity
