// A figure of the paper as a picture: its diagrams, or the contact where it has none. Pure
// functions; any thread.
#pragma once

#include <memory>

#include "core/paper/figure.h"
#include "core/run/frame.h"
#include "ui/chart/diagram_picture.h"

namespace asperity {

/// The frame that a figure without diagrams is drawn from; null for the others. Throws what its
/// scene's steady state throws.
std::shared_ptr<const Frame> contactOf(const Figure& figure);

/// contact: as contactOf() gave it.
DrawList composeFigure(const Figure& figure, const Frame* contact, const DiagramOptions& options);

}  // namespace asperity
