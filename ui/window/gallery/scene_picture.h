// The small picture of a scene in the gallery: its contact, curve or motion without texts and
// margins, drawn in the same way as all other pictures. Pure; any thread on which no OpenGL context
// of Qt is current. Failure: std::exception where the scene cannot run or no backend can draw.
#pragma once

#include <QImage>
#include <stop_token>

#include "core/scene/scene.h"
#include "ui/draw/theme.h"
#include "ui/window/gallery/scene_cards.h"

namespace asperity {

/// Pixels of every picture of a scene; a card shows it smaller.
inline constexpr QSize kScenePicture{480, 288};

/// Draws the picture. A friction curve is the mean of a few lines only, a motion is that of the
/// scene. Throws StopRequested where it is stopped.
QImage drawScenePicture(const Scene& scene, SceneView view, const Theme& theme,
                        const std::stop_token& stop = {});

}  // namespace asperity
