// A figure of the paper as a picture: its diagrams, or a contact where it has none. Pure functions;
// any thread.
#pragma once

#include <memory>

#include "core/paper/figure.h"
#include "core/run/frame.h"
#include "ui/chart/diagram_picture.h"

namespace asperity {

/// Returns the frame of the contact for a figure without diagrams; null for the others. Throws the
/// errors of the scene's steady state.
std::shared_ptr<const Frame> contactFrame(const Figure& figure);

/// Draws the figure. contact: the result of contactFrame().
DrawList composeFigure(const Figure& figure, const Frame* contact, const DiagramOptions& options);

}  // namespace asperity
